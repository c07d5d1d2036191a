<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en_US">
<context>
    <name>Admin</name>
    <message>
        <source>logged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>logged out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a login failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>used a one-time code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed the password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reset a password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>entered a person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed a person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>added a class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>renamed a class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>put somebody into a class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>took somebody out of a class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gave a lesson to a class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>took a lesson back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an attempt was kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>commented on an attempt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gave another score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept a hardness preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed a setting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a backup was restored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>student</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instructor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>admin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nobody</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>began an exam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>found the audit changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>made a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exported attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copied the school into another database</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a name that nobody has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brought the school here from another database</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>enabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>at most %n attempt(s)</source>
        <translation>
            <numerusform>at most %n attempt</numerusform>
            <numerusform>at most %n attempts</numerusform>
        </translation>
    </message>
    <message>
        <source>as many attempts as one likes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has more fields than the first line names.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It stands in line %1 already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is too long, or has signs that cannot be seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is none of student, instructor, admin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here the role is %1; a class list does not change it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name of a class has 1 to 100 characters that can be seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>when a place that was left is locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long checking a password takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how much memory checking a password takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the preset that everybody uses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>attempt %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exam %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>class %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>person %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>setting %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the school</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the audit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preset %1, version %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>backup of %1</source>
        <extracomment>%1: a day and a time, or the name of a file</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From sign %1 of this line on the file is no UTF-8 text. Save it from the spreadsheet as “CSV UTF-8”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A quotation mark at sign %1 of this line is not closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At sign %1 of this line words stand behind a closing quotation mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A class list has no such column. Is it %1?</source>
        <extracomment>%1: the name of a column</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This column is there twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This column is missing. The first line names the columns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a computer wrote here for the first time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>computer with the key %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>took out a report of a class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>had the password kept more safely</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>took a comment back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long a login by a name that nobody has takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is empty, longer than 64 characters, has other signs than letters, digits and . _ - @, or letters of several scripts in one word.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A class list has no such column. It has username, given_name, family_name, role and class.</source>
        <translation></translation>
    </message>
    <message>
        <source>which presets are retired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>table %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>column %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>index %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trigger %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>constraint %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>view %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rule %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Block</name>
    <message>
        <source>Practice block: line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice block: circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice block: cross</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice block: square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice block: dovetail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice block: staircase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice block: letter I</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice block: letter T</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice block: three layers</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Breach</name>
    <message>
        <source>The pulp is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a hole through the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deeper than %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The marginal ridge is thinner than %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut where nothing was to be cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pressed with %1 N, allowed are %2 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bur has run in the air for %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut with a bur that this lesson does not allow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An open pulp mostly dies: odontoblasts that are cut do not come back. Look at the section, and keep half a millimetre of dentin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A perforated tooth is mostly lost. Watch the depth in the section.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is deeper than needed weakens the tooth and comes near the pulp. The section shows how deep you are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A thin marginal ridge breaks under load. Stop the bur&apos;s outer edge earlier.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sound tissue does not grow again. The broken line in the section shows what is to be cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About 1 N cuts best; more heats the pulp, stalls the turbine and slips. Let the bur do the work.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A bur that turns unwatched hurts lips and cheeks. Stop it when you do not cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another shape leaves another cavity. Choose a bur that the lesson names.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tooth beside was touched by the turning bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A nick in the neighbour holds plaque and decays. Stay inside the outline; N shows the teeth beside.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Bur</name>
    <message>
        <source>Round, No. 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pear, No. 330</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Long pear, No. 245</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straight fissure, No. 57</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Chart</name>
    <message>
        <source>d MMM</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MMM yyyy</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <extracomment>Bars of a chart that there is no room for</extracomment>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Criterion</name>
    <message>
        <source>Enamel and dentin beside the decay and below it. What lies straight above the decay has to go and is not counted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 − %2 free</source>
        <extracomment>%1 is a value, %2 what of it costs nothing: &quot;3.20 − 1.00 free&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured, so the attempt fails: %1 points that were left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured, so it earns none of its %1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: nothing lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allowed is %1; it fails the attempt and takes the %2 points left</source>
        <extracomment>%1 is a range: &quot;up to 0.00 mm²&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 too far off; a worse error decides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; beyond it all of its %2 points are lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(%1) / %2 %3 × %4 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, no more than all of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has reached %2</source>
        <extracomment>%1: the name of a measure, %2: a figure with its unit</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of its %1 points are earned before %2</source>
        <extracomment>%1: points of a score, %2: what has to be done: &quot;50 % of the decay is out&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the decay is out</source>
        <extracomment>%1: a share: &quot;50 %&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the ideal is cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the shape is cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value that was measured here is not stored</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Direction</name>
    <message>
        <source>distal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mesial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>labial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>buccal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>palatal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lingual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distolabial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distobuccal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distopalatal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distolingual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mesiolabial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mesiobuccal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mesiopalatal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mesiolingual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesio-distal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labio-palatal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labio-lingual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bucco-palatal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bucco-lingual</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>The file is not there. Was it moved or renamed?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be read. Check that it is a file and that you may open it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be written. Choose another folder, or make room on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A newer Cusp wrote this file. Update Cusp to open it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no surface in this file. Choose a scan of a tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cusp does not know what is asked for by this name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A value lies outside what Cusp can work with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export it again, or choose another scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy it again from where it was made, or choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a copy of it back, or move it away: Cusp then begins a new one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no recording of Cusp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no database of Cusp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is not what its name says. Scans are OBJ, STL or PLY.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file ends too early.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is too large. Export it with fewer triangles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is too large.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where a number belongs, the file holds something else.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The content of the file does not fit together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scan cannot be opened. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tooth cannot be made. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording cannot be played. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording was not saved. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grades will not be kept; drilling and grading work all the same. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its file is kept for seven days, in the folder &quot;discarded&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask who made the lesson, or choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This Cusp did not write the file, or an older one did.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lesson cannot be given; what was on the table still is. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work cannot be marked; it is as it was. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work: if the computer fails, it is lost. Make room on the disk, or save the recording now and then.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An attempt that was not finished cannot be taken up again. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has been cut yet that could be a reference.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reference was not saved. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was made on another tooth, or with another decay, than this lesson&apos;s. Ask who made the lesson.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program is writing to the school&apos;s data. Try again in a moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Cusp tries again by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your role does not allow it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name or password is wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many logins have failed. Wait a moment and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a password first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the school keeps cannot be shown now; what you do is kept. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s file cannot be written. Make room on the disk, or make its folder writable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An older Cusp made this school. Ask its administrator to run “cusp db migrate”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That was not done, and nothing was changed. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An attempt on its way to the school is damaged and was put aside, in the folder “outbox/damaged”. All else is kept as ever.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody else has changed it meanwhile. Here is what there is now; change it again if need be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is the last admin who can log in. Make somebody else an admin first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This account was disabled. Ask an admin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Try it again when the server answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This grade is not kept yet; it is tried again as long as Cusp runs. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder “outbox”, where grades wait for the school, cannot be written. Make room on the disk, or make that folder writable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work: if the computer fails, it is lost. Go on, and have room made on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s data lie on a network drive, and another Cusp, here or at another computer, has them open. Only one at a time can: close that one. For several computers an admin keeps them on a PostgreSQL server.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s server says no. Ask whoever looks after it: its log, or “cusp db check”, says why.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another school is now where yours was. Log in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s server went away while this was being done, and nobody can say whether it was. Look when it answers again, before you do it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was written: what stands on it is read anew for it. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ExerciseMarks</name>
    <message>
        <source>height, mm</source>
        <extracomment>Title of a scale: how high the bur&apos;s tip stands over the block</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>touch.points[%1]: there is no tooth at x = %2, y = %3 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has %1; a lesson has at most %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unterminated object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing name separator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unterminated array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing value separator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>invalid termination by number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>illegal number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>invalid escape sequence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unterminated string</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>object is missing after a comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too deeply nested document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too large document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>garbage at the end of the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>illegal value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1, from a newer Cusp; this one reads %2. Update Cusp to give this lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is written in UTF-16 or UTF-32; save it as UTF-8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not JSON: line %1, column %2: invalid UTF8 string; save the file as UTF-8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not JSON: line %1, column %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be one JSON object in braces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is said twice in one object; leave one out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; leads out of the lesson&apos;s folder; name a file beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is based on itself by way of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than %1 files are based on one another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be the name of a file beside this one, or of one that is shipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be read (it is a folder)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be read (it is no file)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>true or false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>null</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1; write a number of %2 without its unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1; write a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1, it must lie between %2 and %3 %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1, it must lie between %2 and %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1, it must be a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1; write true or false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1; write a text in quotes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has %1 characters; at most %2 are read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holds the character U+%1, which cannot be seen; leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has %1 characters; it takes 1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1; write {&quot;en&quot;: &quot;...&quot;, &quot;de&quot;: &quot;...&quot;}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has texts in %1 languages; it takes 1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be the code of a language (en, de, es, ja) with a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be a list of at most %1 texts: [&quot;...&quot;, &quot;...&quot;]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1; write an object in braces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be a list of at most %1 objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known; there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be a list of 1 to %1 places: [[x, y], ...]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be [x, y], two numbers between %1 and %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not a key that is known here, so it is left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not a key that is known here; did you mean &quot;%1&quot;?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (in the pack %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to another lesson; give this one an id of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is missing; write &quot;format&quot;: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; beside the lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is missing; there are %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has %1 with all that it names; a recording takes at most %2 along. Shorten its texts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is missing; write {&quot;fdi&quot;: 36}, {&quot;block&quot;: &quot;line&quot;} or {&quot;scan&quot;: &quot;tooth.stl&quot;}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must name one of &quot;fdi&quot;, &quot;block&quot; and &quot;scan&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no tooth %1 here; those of the left are made: 21 to 28 and 31 to 38</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no unit; write mm, cm, m or the millimetres of one unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no direction; write +x, -x, +y, -y, +z or -z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an ideal is captured, or has a kind and sizes; leave one out (where the lesson is based on another, with &quot;kind&quot;: null, &quot;sizes&quot;: null)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is missing; name the preparation, or a file &quot;captured&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2; a lesson takes at most %3. Capture it on a coarser grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has its own caries and plastic; leave it out, or leave out &quot;caries&quot; and &quot;plastic&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no aid; there are section, depth_gauge, radiograph, heat_map, mirror, ideal, bur_colour, fixture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only a tooth of ours has neighbours; write false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to remove decay there must be some: write &quot;lesion&quot;: {&quot;extent&quot;: 0.5} for a tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is missing; it says which preparation is to be cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a shape is traced in a block: write {&quot;block&quot;: &quot;line&quot;}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is missing; it says which points are to be touched: {&quot;points&quot;: [[x, y], ...]}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is missing; it says which force is to be held: {&quot;force_n&quot;: 1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers are told apart in a block of them: write {&quot;block&quot;: &quot;layers&quot;}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers are told apart without any; leave the key out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was captured on the tooth &apos;%2&apos; (seed %3, grid %4); name that tooth, seed and grid, or capture it on this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is made by rule for a tooth of ours only, &quot;tooth&quot;: {&quot;fdi&quot;: 36}; for a scan name a captured one: {&quot;captured&quot;: &quot;mine.cuspideal&quot;}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read; check its name and rights.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has %2, and a pack takes %3 in all; pack fewer lessons, or coarser scans.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 cannot be made; name another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pack names a file &quot;%1&quot;, which leads out of its folder or is of no kind that lessons have; nothing was unpacked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; in the pack is not what its hash says: it was damaged or changed; nothing was unpacked. Ask for the pack again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is no pack of lessons, it is damaged, or it holds more than %1; choose a file that &quot;cusp lesson pack&quot; has made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is no pack of lessons; choose a file that &quot;cusp lesson pack&quot; has made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pack is of format %1, from a newer Cusp; this one reads %2. Update Cusp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pack lists %1 files; it may hold 1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pack holds &quot;%1&quot; twice; nothing was unpacked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a link to elsewhere; nothing was unpacked. Name another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is another file &quot;%1&quot; in %2 already; nothing was unpacked. Move it away, or name another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 cannot be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has %1; a hardness preset has at most %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1, from a newer Cusp; this one reads %2. Update Cusp to use it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>says that this is no hardness preset; choose a file that Cusp has exported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be one line of 1 to %1 characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not there; check the name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be read; name a file that you may read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is another %1 of version %2; give this one another number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rubric %1, criterion %2, %3: %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 is not between %3 and %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a critical criterion earns nothing, it has nothing to wait for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a critical criterion has none; it fails the attempt and takes all points that are left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be at least 0.1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rubric %1, criteria: there are %2, it takes 1 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rubric %1, pass_mark: must lie between 0 and 100 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is there twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rubric %1, weight: those of all criteria make %2 points; they must make 100</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1; points are given to a tenth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no measure; &quot;cusp lesson measures&quot; lists them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>may hold small letters, digits, &apos;-&apos; and &apos;_&apos; only, and begins with a letter or digit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is missing; name one that is shipped (&quot;decay_removal&quot;), a file beside the lesson, or write it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no rubric &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1</source>
        <extracomment>%1: what has no words of its own but English ones</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1 (%2) is not a number</source>
        <extracomment>%1: a number of an ideal or a block, %2: its key, %3: the number that was given</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1 (%2) must be from %4 to %5, not %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1 (%2) must be from %4 to %5 %6, not %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1 (%2) must be a whole number, not %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no size &quot;%1&quot;; there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the thickness of the enamel layer (enamel_mm) is more than the block&apos;s height (height_mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the block&apos;s side or height (side_mm, height_mm) is too small for three pads: they take %1 and %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) leaves less than %1 mm of the block around it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the depth of the channel (depth_mm) leaves less than %1 mm of the block below it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the radius of inner corners (corner_radius_mm) is more than half of the width of the channel (width_mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the radius of inner corners (corner_radius_mm): no bur leaves that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the depth (depth_mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) must be at least %1 mm with a channel of that width (width_mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) is less than the width of the channel (width_mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) leaves each of its steps shorter than the channel is wide (width_mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no practice block &apos;%1&apos;; choose one of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no preparation &apos;%1&apos;; choose one of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the preparation &apos;%1&apos; is not made for tooth %2; it is for %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the radius of the bur (bur_radius_mm): no bur leaves that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the width of the isthmus (isthmus_mm) is less than the bur is wide (twice bur_radius_mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make its depth (depth_mm) less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make its depth (depth_mm) or that of the box (box_floor_mm, box_axial_mm) less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nobody knows where the fissures of &apos;%1&apos; run or which side is mesial; choose a tooth by its FDI number, or take an ideal from attempts at this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no room for the %1 on this tooth; make one of these less: %2</source>
        <extracomment>%1: a part of a preparation, %2: keys of numbers</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>occlusal outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>central groove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mesial pit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distal pit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none: the tooth has no such groove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tooth %1 has no pulp chamber that could be opened from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The captured ideal is damaged. Use a copy of the file, or capture it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ideal was captured on the tooth &apos;%1&apos; (seed %2, grid %3) and does not fit &apos;%4&apos; (seed %5, grid %6); name that tooth, seed and grid, or capture it on this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The captured ideal is empty; choose another file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not a captured ideal; choose a file that Cusp has saved as one (*.cuspideal).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The captured ideal is of version %1, this Cusp reads up to version %2; open it with a newer Cusp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The captured ideal ends early: it was cut off while being written or copied. Use a whole copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no handpiece &apos;%1&apos;; choose one of %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no bur &apos;%1&apos;; choose one of %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no hardness preset &apos;%1&apos;; choose natural or typodont, or name a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the force limit is %1 N, and the device gives at most %2 N; lower it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm with this damping; lower the stiffness, or damp more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm however it is damped; lower the stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm before it buzzes; lower the stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1: the name of a file; %2: what is wrong with it: &quot;is empty&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>says nothing of %1: that is as shipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has the last version that there can be, %2; keep this under another name</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>width of the isthmus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth of the pulpal floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width of the dovetail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>extension into the grooves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>marginal ridge that is left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ridge across the tooth that is left on each side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>divergence of the end walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius of the bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius between floor and wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>floor along the junction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth of the floor in dentin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth of the gingival floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth of the axial wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width of the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lean of the access walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>margin around the chamber</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>block&apos;s side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>block&apos;s height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thickness of the enamel layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width of the channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth of the channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length of the shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flare of the dovetail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius of inner corners</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>&quot;%1&quot; is no audit code; a report shows one such as 412-9f3ac07be1d2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) tells that the rows before it did not end as they had been signed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) is not the one that was signed: it was changed, or the signature was put there from elsewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the signature of the newest row of the audit was not made by the station whose key stands beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit row %1 was removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit rows %1 to %2 were removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no signature covers audit row %1: it was inserted, or the signed head was set back, or the row behind it was changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no signature covers audit rows %1 to %2: they were inserted, or the signed head was set back, or the row behind them was changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) and row %5 (%6, %7, %8) were exchanged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) was inserted, and those behind it were renumbered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit rows %1 to %2 were inserted, and those behind them were renumbered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before audit row %1 (%2, %3, %4) a row was removed, and those behind were renumbered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before audit row %1 (%2, %3, %4) %5 rows were removed, and those behind were renumbered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) was moved: it was written as row %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) was changed, or the one before it was and its hash with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the signed head of the audit was removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is damaged: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>row %1 of the table %2 belongs to no row of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2, %3) was inserted: the audit knows nothing of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2, %3) was changed after it had been kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was removed; row %2 of the audit tells of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was removed or changed; row %2 of the audit tells of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was inserted: the audit knows nothing of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was changed after it had been noted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no score sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has a standing in %2 that the attempts do not add up to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has attempts in %2 and no standing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording %1 is not there any more; bring the folder &quot;recordings&quot; back from a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording %1 was changed or is damaged; bring it back from a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the head of the audit was signed with the key %1, which is not this computer&apos;s; if the file was not written by Cusp on another computer, somebody has rewritten it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an override of %1 was inserted: the audit knows nothing of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an override of %1 was changed after it had been noted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an override of %1 was removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a comment on %1 was inserted: the audit knows nothing of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a comment on %1 was changed after it had been noted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a comment on %1 was removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not what the audit says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has another score than the audit says was given to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has the role %2, the audit says %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was disabled or enabled, and it was not noted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was given another name, and it was not noted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what %1 was given of the lesson %2 is not what the audit says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>that %1 was given the lesson %2 was removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was renamed, and it was not noted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was put into %2, and it was not noted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was taken out of %2, and it was not noted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was taken from the person who made it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of tables, indexes and triggers the names alone could be compared: this user of the server may not create a schema there; let the owner of the database check it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no longer there: what it guarded is not guarded any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not as this program makes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not from this program: it may change what is written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the newest row of the audit was signed with the key %1, and the audit knows no station that has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pages of the file could not be looked at (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the audit could not be looked at (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tables, indexes and triggers could not be looked at (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the attempts could not be looked at (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the exams that were begun could not be looked at (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>score sheets and standings could not be looked at (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>people, classes, comments, presets and settings could not be compared with the audit (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recordings could not be looked at (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>who signed the head of the audit could not be looked at (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new rows of the table %1 are not numbered as this program does, so that perhaps none can be added to it; &quot;cusp db migrate&quot; puts that right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the numbers of new rows could not be looked at (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a comment on %1 was taken back, and it was not noted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a comment on %1 that was taken back is there again, changed or removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the password of %1 cannot be read, and lets nobody in: reset it, or restore a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the password or the one-time code of %1 was changed without a note in the audit: reset it, or restore a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the server lets the triggers of this database rest (session_replication_role is %1): what they guard is not guarded; let its administrator set it to origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not from this program: it may refuse what is to be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit row %1, which a report names, is not there: it was removed, or the code is not typed as it stands there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) and those behind it were renumbered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) is not the one that a report names: it or one before it was changed, or the code is not typed as it stands there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not from this program: its rows are read among those of the table %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not from this program: who changes its rows changes those of the table %2, past what guards them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not from this program: it may change what is read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>audit rows %1 to %2 were moved: they were written as rows %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2, %3) is not noted in the audit: it was inserted, or the note of it is among the rows of the audit that were removed or changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rows of the audit were removed or changed: what is said not to be as it was noted, or not to be noted, may be sound, and the note of it among them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an override of %1 is not noted in the audit: it was inserted, or the note of it is among the rows of the audit that were removed or changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a comment on %1 is not noted in the audit: it was inserted, or the note of it is among the rows of the audit that were removed or changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not noted in the audit: it was inserted, or the note of it is among the rows of the audit that were removed or changed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Handpiece</name>
    <message>
        <source>Turbine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Electric</source>
        <extracomment>A red-ring contra-angle: electric motor, geared up</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low-speed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Health</name>
    <message>
        <source>The handpiece is gone: no force. Plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The computer was too slow: the recording has a gap.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The computer is slow: the picture lags behind.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force at its limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bur is inside the tooth: lift it out, then it works.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The handpiece answers late: the tooth is made softer to the hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The handpiece leads your hand back over the tooth. Hold it back, and it lets go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline holds your hand: Q lets it go.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HistoryPanel</name>
    <message>
        <source>Whole tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm³ %2</source>
        <extracomment>What a stroke took off: so many cubic millimetres of a tissue</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>present</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Lesson</name>
    <message>
        <source>Practice block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ideal preparations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removing decay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth gauge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colours of depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ideal preparation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: fails the attempt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bur that changes colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guided hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, give or take %2, costs nothing</source>
        <extracomment>%1: a target; %2: how far off it one may be at no cost</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From %1 up costs nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up to %1 costs nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (more, where the decay is larger)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond it the attempt fails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond it all %1 points are lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 off, all %2 points are lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1 all %2 points are lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from %1 on all %2 points are lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outline %1 mm to either side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>floor %1 mm up or down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walls %1°, that is %2 mm over 1.5 mm of depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>floor even to %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> as soon as %1</source>
        <extracomment>%1: what has to be done before points are earned: &quot;50 % of the decay is out&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exam</source>
        <extracomment>On the card of a lesson</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on the table</source>
        <extracomment>On the card of the lesson that is being worked on</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>due since %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>due today %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>due tomorrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>due %1</source>
        <extracomment>%1: a day of the week, or a date</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You have used up your attempts at this lesson. Your teacher can give you more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1, %n day(s) late</source>
        <extracomment>%1: the day it was due, &quot;17 Nov&quot;</extracomment>
        <translation>
            <numerusform>%1, %n day late</numerusform>
            <numerusform>%1, %n days late</numerusform>
        </translation>
    </message>
    <message>
        <source>no attempts left</source>
        <extracomment>On the card of a lesson</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your last attempt at this exam was begun in another window. What was cut here does not count.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Login</name>
    <message>
        <source>Name or password is wrong. Try again, or ask an admin for a one-time code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Too many logins have failed. Wait %n second(s) and try again.</source>
        <translation>
            <numerusform>Too many logins have failed. Wait %n second and try again.</numerusform>
            <numerusform>Too many logins have failed. Wait %n seconds and try again.</numerusform>
        </translation>
    </message>
    <message>
        <source>Somebody has been entered here meanwhile. Log in as an admin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Try again, or practise without a login.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A password has eight characters or more, does not hold the name, and is none that everybody tries first, such as &quot;password1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program is writing to the school&apos;s data, and nobody can be let in meanwhile. Try again in a moment.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Material</name>
    <message>
        <source>decay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>enamel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dentin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pulp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C</source>
        <extracomment>One letter for decay (caries); must differ from those of enamel, dentin and pulp.</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E</source>
        <extracomment>One letter for enamel</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D</source>
        <extracomment>One letter for dentin</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P</source>
        <extracomment>One letter for pulp</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Pad</name>
    <message>
        <source>Left</source>
        <extracomment>Three pads of a practice block, side by side</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Printing</name>
    <message>
        <source>PDF (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Scan</name>
    <message>
        <source>Taken as millimetres the scan is %1 mm long, more than a tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file names no unit. As centimetres it is %1 mm long, so centimetres were taken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file names no unit. As metres it is %1 mm long, so metres were taken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In no usual unit has the scan the size of a tooth, so it was made %1 mm long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shape does not show where the crown is. If the tooth lies on its side, export it with the crown along +z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scan has openings; they were closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) without an area were left out.</source>
        <translation>
            <numerusform>%n triangle without an area was left out.</numerusform>
            <numerusform>%n triangles without an area were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) are there twice.</source>
        <translation>
            <numerusform>%n triangle is there twice.</numerusform>
            <numerusform>%n triangles are there twice.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n edge(s) more than two triangles meet.</source>
        <translation>
            <numerusform>At %n edge more than two triangles meet.</numerusform>
            <numerusform>At %n edges more than two triangles meet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n edge(s) neighbouring triangles disagree which side is outside.</source>
        <translation>
            <numerusform>At %n edge neighbouring triangles disagree which side is outside.</numerusform>
            <numerusform>At %n edges neighbouring triangles disagree which side is outside.</numerusform>
        </translation>
    </message>
    <message>
        <source>The scan was inside out and has been turned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>The scan has %n separate part(s); the outermost surface counts.</source>
        <translation>
            <numerusform>The scan has %n part; its outermost surface counts.</numerusform>
            <numerusform>The scan has %n separate parts; the outermost surface counts.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Section</name>
    <message>
        <source>surface before anything was cut</source>
        <extracomment>In the key of a picture, beside a line</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plane does not meet the tooth here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface before</source>
        <extracomment>The same, where a second line stands beside it</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ideal preparation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>within tolerance</source>
        <extracomment>In the key of a picture: what may be cut or left without losing points</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>costs points</source>
        <extracomment>In the key of a picture: farther out, all points of this criterion are lost</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Surface</name>
    <message>
        <source>M</source>
        <extracomment>Letters for sides of teeth, one or two each. Mesial</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D</source>
        <extracomment>Letter for the distal side</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>La</source>
        <extracomment>Letters for the labial side (towards the lip), then for the buccal one (towards the cheek)</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P</source>
        <extracomment>Letters for the palatal side, then for the lingual one</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I</source>
        <extracomment>Letters for the incisal edge, then for the occlusal surface</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>O</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TimeLine</name>
    <message>
        <source>section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth gauge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colours of depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ideal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No aid in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aids in use: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bur %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hand was led home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taken up again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colour of the bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held within the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 pad: said to be %2</source>
        <extracomment>%1 is &quot;Left&quot;, &quot;Middle&quot; or &quot;Right&quot;, %2 a tissue</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handpiece: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point %1 touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Graded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 who remarked something on an attempt, %2 the words</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Tooth</name>
    <message>
        <source>upper right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>upper left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lower left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lower right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 central incisor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lateral incisor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 canine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 first premolar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 second premolar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 first molar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 second molar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 third molar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tooth %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tooth without a name</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ViewMarks</name>
    <message>
        <source>depth, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <extracomment>A length in millimetres</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it should be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 too deep</source>
        <extracomment>%1 is a length: the tooth is cut deeper than it should be</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to go</source>
        <extracomment>%1 is a length: so much is still to be taken away</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off the ideal, mm</source>
        <extracomment>Titles of a scale of colours: how deep a cut is, and how far from the ideal</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::AdminDesk</name>
    <message>
        <source>%1 was entered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read, or is too large.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The data are being backed up …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A backup is made and restored …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything is looked at …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is wrong: %1 attempts and %2 rows of the audit are as they were noted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) are not as they should be.</source>
        <translation>
            <numerusform>%n thing is not as it should be.</numerusform>
            <numerusform>%n things are not as they should be.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is empty. The first line of a class list names its columns: username, given_name, family_name, role, class.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>A place that was left is locked after %n minute(s).</source>
        <translation>
            <numerusform>A place that was left is locked after %n minute.</numerusform>
            <numerusform>A place that was left is locked after %n minutes.</numerusform>
        </translation>
    </message>
    <message>
        <source>The backup is looked at …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no whole backup of a school, and was not restored. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The class list is looked at …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These people are being entered …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No class can be called that. Its name has 1 to 100 characters that can be seen, without |, which parts classes in a class list, and no other class has it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has more than %2 lines. Split it, and enter the parts one after another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The audit is still the one that the report with the code %1 names.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the last check found is in this backup, too; it stands below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backed up: %1. Its pages and keys are whole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restoring works: a backup was made, restored beside the database and compared, %1 rows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>But its audit was changed. &quot;Check everything&quot; says where. Older backups in which it is whole are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s file is in use: another window of Cusp, or another program, has it open, or a backup is being made. Close what has it open, and restore then.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The backup was not restored; nothing has been changed. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That cannot be: the name is empty or taken, or has other signs than letters, digits and . _ - @, or letters of several scripts in one word.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is no backup of this school.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to save: everything is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was entered: somebody else has entered or changed people meanwhile. This is what the list would do now.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::Application</name>
    <message>
        <source>Making tooth %1 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tooth is whole, and yours to drill.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is your own work again, as you left it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tooth is not ready yet. Try again in a moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has been cut yet, so there is nothing to grade.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making a practice block …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing the lesson …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking up the attempt …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your attempt goes on where it was left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This attempt was made with another device, so it cannot be gone on with. It is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reference was saved as %1. A lesson names it, or choose it in the editor of a lesson on this tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This exercise has not been begun yet, so there is nothing to grade.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The expert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pack was not unpacked, so its lesson cannot be changed. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A simulated hand does the lesson …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No teacher has recorded this lesson, so a simulated hand shows it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No teacher has recorded this lesson, and a simulated hand does not manage it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No pad has been named yet: say beneath the view what each is made of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The attempt is no longer there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Working out the score card …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s data lie on a network drive: only one computer at a time can use them. For several, keep them on a PostgreSQL server.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Today&apos;s backup was not made. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your password was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The backup was not restored; nothing has been changed. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) on this computer cannot be given to this school: it does not know whose they are, or they were signed with another station.key. They wait.</source>
        <translation>
            <numerusform>%n attempt on this computer cannot be given to this school: it does not know whose it is, or it was signed with another station.key. It waits.</numerusform>
            <numerusform>%n attempts on this computer cannot be given to this school: it does not know whose they are, or they were signed with another station.key. They wait.</numerusform>
        </translation>
    </message>
    <message>
        <source>The backup of %1 is in place.</source>
        <extracomment>%2: a file&apos;s name</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The backup of %1 is in place. The file that was there is kept beside it as %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This account was disabled, and you were logged out. Ask an admin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The grade that could not be kept is kept now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Today&apos;s backup was made, but the audit was changed. &quot;Check everything&quot; on the page of the backups says where.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The backup was not restored. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program answers here that shows folders. Your own lessons are in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) on this computer wait for their school: this file is named as a backup is, and gets none.</source>
        <translation>
            <numerusform>%n attempt on this computer waits for its school: this file is named as a backup is, and gets none.</numerusform>
            <numerusform>%n attempts on this computer wait for their school: this file is named as a backup is, and gets none.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) on this computer wait for another school: %1. If that is this one under an earlier name, &quot;cusp db send&quot; brings them here.</source>
        <translation>
            <numerusform>%n attempt on this computer waits for another school: %1. If that is this one under an earlier name, &quot;cusp db send&quot; brings it here.</numerusform>
            <numerusform>%n attempts on this computer wait for another school: %1. If that is this one under an earlier name, &quot;cusp db send&quot; brings them here.</numerusform>
        </translation>
    </message>
    <message>
        <source>Its audit had been changed before it was made. &quot;Check everything&quot; on the page of the backups says where; an older backup may have it whole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your role was changed, and you were logged out. Log in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You are in an exam: earlier attempts are opened when it is over. Press G for the grade, or take another lesson.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another school is now where yours was, and you were logged out. Log in again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::CardDesk</name>
    <message>
        <source>Score card: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the score card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The score card was saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The score card could not be written. Choose another folder, or make room on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The score card was printed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The printer did not take the score card.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The score card is being made …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not logged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no printer on this computer. Save it as a PDF instead.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::PeopleDesk</name>
    <message>
        <source>Save the class report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report was saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report could not be written. Choose another folder, or make room on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report was printed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The printer did not take the report.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording of this attempt is not there, so it cannot be shown again. Its score and its figures are in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report is being written …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 points</source>
        <extracomment>%1: a lesson, and when it was done</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no printer on this computer. Save it as a PDF instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the attempt of %1: %2</source>
        <extracomment>%1: who made an attempt, and when; %2: why</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That was not done: this student is in none of your classes any more. What you have typed stays here; an admin can enter you into the class again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This belongs to none of your classes any more. An admin can enter you into the class again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::PresetDesk</name>
    <message>
        <source>The next tooth feels like this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next tooth of everybody here feels like this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not kept: only an admin keeps the school&apos;s presets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not kept: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not imported: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preset was exported as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not kept: the file cannot be written. Make room on the disk, or check the rights.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not exported: the file cannot be written. Choose another folder, or make room on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody else has chosen %1 for everybody here meanwhile. That stays.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not retired: teeth feel like it now, or too many are retired.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is offered to nobody any more. Attempts go on naming it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is offered again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next tooth of everybody here feels like this. An admin had retired it; it is offered again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::admin::AdminPage</name>
    <message>
        <source>People</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Audit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>School</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::admin::AuditPart</name>
    <message>
        <source>Clear the search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search: a person, an action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the audit code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Older rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Audit</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n row</numerusform>
            <numerusform>%n rows</numerusform>
        </translation>
    </message>
    <message>
        <source>No.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whom or what</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Details</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Audit code now: %1. Every report shows the code of its day. Type one beside &quot;Check everything&quot; (Backups) to see whether what was noted before it is still as it was.</source>
        <extracomment>%1: a short code</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) among the newest %1; &quot;Older rows&quot; brings more to search</source>
        <extracomment>%1: how many rows were searched</extracomment>
        <translation>
            <numerusform>%n row among the newest %1; &quot;Older rows&quot; brings more to search</numerusform>
            <numerusform>%n rows among the newest %1; &quot;Older rows&quot; brings more to search</numerusform>
        </translation>
    </message>
    <message>
        <source>Leave out attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who began an exam or made an attempt is not shown: what is left is what was done to people, classes, grades, presets, settings and backups</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) among the newest %1 without attempts; &quot;Older rows&quot; brings more to search</source>
        <extracomment>%1: how many rows were searched</extracomment>
        <translation>
            <numerusform>%n row among the newest %1 without attempts; &quot;Older rows&quot; brings more to search</numerusform>
            <numerusform>%n rows among the newest %1 without attempts; &quot;Older rows&quot; brings more to search</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::admin::BackupPart</name>
    <message>
        <source>Back up now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try a restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a backup, restore it beside the database, compare, and remove it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at every page, every attempt and the whole audit for what was changed, removed or inserted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the check found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s data are on a server: %1. Its administrator makes the backups; &quot;cusp db copy&quot; brings all of it into a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes: log everybody out and restore it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore the chosen backup …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep what there is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s data are in %1. A backup is made every day the program is used. All of the last two days are kept, then one for each of 12 days, 10 weeks and 9 months.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore the backup of %1? What was entered after it will be missing; attempts of this computer are brought in again, and the present file is kept beside it.</source>
        <extracomment>%1: when a backup was made</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Audit code of a report (optional):</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;Check everything&quot; then also looks whether the audit is still the one that the report was printed from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is no audit code. A report shows one such as %1.</source>
        <extracomment>%1: an example</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::admin::PeoplePart</name>
    <message>
        <source>Clear the search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search: a name, a class, a role</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name to log in with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Given name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Family name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of a class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Login</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Role</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last login</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a class of this name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give this name to the class that is chosen above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the password away and give a one-time code in its place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the one-time code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>can log in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a one-time code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter the person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who is disabled cannot log in; attempts and names stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needs a one-time code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes, take it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes, take the password away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 will need a new one-time code: take the password away?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s data are being written to …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring the changes back</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%Ln person(s)</source>
        <translation>
            <numerusform>%Ln person</numerusform>
            <numerusform>%Ln people</numerusform>
        </translation>
    </message>
    <message>
        <source>What you had typed for a new person is put aside.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you had changed of %1 is put aside.</source>
        <extracomment>%1 is a person</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you have typed for a new person is not entered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you have changed of %1 is not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a one-time code, shown here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One-time code of %1. Tell it now: it is kept nowhere. It is shown here, whenever %1 is chosen, until School is left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a class %1 already. It is ticked above.</source>
        <extracomment>%1: the name of a class</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The one-time codes that are shown here are kept nowhere else. Esc once more leaves School without them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes, make another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The one-time code of %1 above would let nobody in any longer: make another?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name to log in with is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n one-time code(s) are shown under School, and kept nowhere else: %1.</source>
        <extracomment>%1: a person, or several</extracomment>
        <translation>
            <numerusform>%n one-time code is shown under School, and kept nowhere else: %1.</numerusform>
            <numerusform>%n one-time codes are shown under School, and kept nowhere else: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Yes, save it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stay an admin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You would be an admin no longer, and be logged out: save it all the same?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is your own account. You would be logged out, and could not log in again: disable it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes, disable it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody else has changed it meanwhile. There is now: %1. What you have typed stays here; saving it puts it in the place of that.</source>
        <extracomment>%1: &quot;Given name: Ann · Role: Instructor&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::admin::RosterPart</name>
    <message>
        <source>A class list is a CSV file with the columns username, given_name, family_name, role and class. Role may be left out; several classes are parted by |. Choose it, or drop it here: nothing is entered before you have seen what it would do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter these people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the one-time codes …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the class list would do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was entered: %2 new, %3 known already. The codes below are kept nowhere else.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Login</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One-time code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a class list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class lists (*.csv);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the one-time codes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The codes were saved. Delete the file when everybody has logged in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The codes could not be written. Choose another folder, or make room on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Example of a class list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Role</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (new)</source>
        <extracomment>%1: a class that would be added</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another file all the same …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The one-time codes of %1 are not saved, and they are kept nowhere else.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln fault(s). Nothing was entered; mend the file and choose it again.</source>
        <translation>
            <numerusform>%1: %Ln fault. Nothing was entered; mend the file and choose it again.</numerusform>
            <numerusform>%1: %Ln faults. Nothing was entered; mend the file and choose it again.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is nobody in %1: it has only the line that names the columns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 %Ln new person(s) would be entered.</source>
        <extracomment>%1: what another sentence says of how many are known already</extracomment>
        <translation>
            <numerusform>%1 %Ln new person would be entered.</numerusform>
            <numerusform>%1 %Ln new people would be entered.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln person(s) known already.</source>
        <translation>
            <numerusform>%1: %Ln person known already.</numerusform>
            <numerusform>%1: %Ln people known already.</numerusform>
        </translation>
    </message>
    <message>
        <source>known as %1 so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was entered: nobody in it is new.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; the line has fewer fields than the first</source>
        <extracomment>%1: &quot;new&quot; or &quot;known&quot;, of somebody on a class list</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::admin::StationPart</name>
    <message>
        <source>min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minutes after which a place that was left is locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drilled with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key of this station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Database</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On their way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a simulated handpiece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mouse, pen or gamepad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (pen)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms in the middle, 99 of 100 within %2 ms</source>
        <extracomment>Times between two servo ticks</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everywhere in the school, a place that was left is locked after</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::charts::ChartPanel</name>
    <message>
        <source>Save as picture (PNG) …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as drawing (SVG) …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as table (CSV) …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save this chart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the chart &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be written (%2). Try another folder.</source>
        <extracomment>%2: the system&apos;s own words</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::charts::Table</name>
    <message>
        <source>series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>class, lower quartile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>class, median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>class, upper quartile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::console::Console</name>
    <message>
        <source>Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answers of the console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a command; Tab completes, &quot;help&quot; explains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters can be looked at and turned here while you drill. &quot;help&quot; lists the commands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; wants a name behind it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write &quot;set NAME VALUE&quot;, as in &quot;set force.stiffness 1.5&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presets are not to be had here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;. &quot;help&quot; lists those there are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No parameter&apos;s name holds &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that is felt is as the preset says.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is room for %1. Take one away with &quot;unwatch NAME&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page Up and Page Down turn over the answers, Up and Down what was typed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write &quot;export NAME FILE&quot;, as in &quot;export live.force force.csv&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>list [TEXT]      the parameters whose name holds the text
get NAME         its value, range and what it does
set NAME VALUE   sets it
reset [NAME]     sets it, or everything that is felt, back
watch NAME       shows it over the view
plot NAME        draws its last ten seconds over the view
export NAME FILE saves what is plotted: .csv, .svg or .png
unwatch [NAME]   takes it, or everything, away
save NAME        keeps what is felt as a hardness preset
load NAME        feels a hardness preset that is kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not plotted. &quot;plot %1&quot; begins it; then it can be saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a file %1 already; choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::console::WatchPanel</name>
    <message>
        <source>Seconds before now</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::console::Words</name>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a live value, to be read, watched or plotted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 (off) or 1 (on)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <extracomment>%1 and %2 are numbers, %2 with a unit</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no parameter &quot;%1&quot;. Type &quot;list&quot; for those there are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a live value: it can be watched and plotted, not set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 takes %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This cannot be changed here and now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How hard the mouse button presses the bur against the tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force that the hand is given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth of the bur&apos;s tip below the uncut surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume removed since the tooth was taken, undone or not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns of the bur under its load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Periods of the servo that were missed since the start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time between two ticks of the servo: half of the last second&apos;s were shorter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time between two ticks of the servo: 99 in 100 of the last second&apos;s were shorter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two presets are being compared blind: until that is over, what is felt is not told. &quot;End the comparison&quot; beside the tooth ends it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::inside::SectionView</name>
    <message>
        <source>Section through the bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture of the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut the tooth in this direction, through the bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of the section, degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the section about the bur (Shift+X: by 15 degrees)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth below the old surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the tip stands below the surface as it was, straight up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dentin left over the pulp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sound dentin between the cut and the pulp straight below the tip. A dash: no pulp there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straight down from the tip of the bur. A dash: no pulp there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shortest way in any direction, also out of the plane of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tip straight down to the pulp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tip to the nearest pulp</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::inside::XrayPage</name>
    <message>
        <source>X-ray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole tooth with its root</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bitewing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beam from the side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns the beam about the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beam from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilts the beam; 0 is level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More radiation: a darker film with less grain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: a parallel beam, no scatter, no bone and no gums.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save both films side by side as a PNG file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X-ray: %1</source>
        <extracomment>%1 is &quot;Tooth 36&quot; or a file name</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crown between its two neighbours. They are sound teeth made by Cusp, and touch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing in a scan says which side is mesial, so it gets no neighbours.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::people::AssignPage</name>
    <message>
        <source>given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>given, due %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no day when it is due</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>%1 of %2 students</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 have passed, %3 have tried</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That was undone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) assigned.</source>
        <translation>
            <numerusform>%n lesson assigned.</numerusform>
            <numerusform>%n lessons assigned.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) taken back; attempts stay.</source>
        <translation>
            <numerusform>%n lesson taken back; attempts stay.</numerusform>
            <numerusform>%n lessons taken back; attempts stay.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) changed.</source>
        <translation>
            <numerusform>%n lesson changed.</numerusform>
            <numerusform>%n lessons changed.</numerusform>
        </translation>
    </message>
    <message>
        <source>Assign</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Assign %n lesson(s)</source>
        <translation>
            <numerusform>Assign %n lesson</numerusform>
            <numerusform>Assign %n lessons</numerusform>
        </translation>
    </message>
    <message>
        <source>Assign lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search: a word, or the number of a tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lessons to assign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What %1 is to do</source>
        <extracomment>%1: name of a class</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Due</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is assigned yet. Tick lessons on the left, say when they are due, and assign them; here you will see how many have passed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change due date and attempts of the chosen lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the chosen lessons back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) who have not passed have no attempts left: earlier ones count.</source>
        <translation>
            <numerusform>%n student who has not passed has no attempts left: earlier ones count.</numerusform>
            <numerusform>%n students who have not passed have no attempts left: earlier ones count.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) of your own: %1. Students find them only at computers that have their files, too: put a copy of %2 there into the folder that &quot;Your own lessons&quot; opens on the page of lessons.</source>
        <extracomment>%1: titles; %2: files</extracomment>
        <translation>
            <numerusform>A lesson of your own: %1. Students find it only at computers that have its file, too: put a copy of %2 there into the folder that &quot;Your own lessons&quot; opens on the page of lessons.</numerusform>
            <numerusform>%n lessons of your own: %1. Students find them only at computers that have their files, too: put a copy of %2 there into the folder that &quot;Your own lessons&quot; opens on the page of lessons.</numerusform>
        </translation>
    </message>
    <message>
        <source>No lesson fits. Search for another word.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::people::AssignTerms</name>
    <message>
        <source>Due on</source>
        <extracomment>A date follows</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a day when it is due</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Day when it is due</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Until the end of this day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts</source>
        <extracomment>How often a lesson may be tried; a number follows</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The month before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next month</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This day is over: whoever has not passed is late at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each lesson keeps what you do not change here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::people::ClassCharts</name>
    <message>
        <source>Shown when %1 people have tried the lesson, so that nobody can be made out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Best score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Students</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Best scores of %n student(s)</source>
        <translation>
            <numerusform>Best score of %n student</numerusform>
            <numerusform>Best scores of %n students</numerusform>
        </translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learning curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of those who made so many attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lost, % of what it counts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the class loses %2 % of its points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2 points: %n student(s)</source>
        <translation>
            <numerusform>%1 to %2 points: %n student</numerusform>
            <numerusform>%1 to %2 points: %n students</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 passed; first attempts: %3 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 passed, after %3 attempts on the average; first attempts: %4 points</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::people::ClassModel</name>
    <message>
        <source>stuck</source>
        <extracomment>Of a student</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no login</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new</source>
        <extracomment>Of a student who has no attempt yet</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no attempt yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: last attempt %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not tried</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: best %2, passed, %3, last %4</source>
        <extracomment>%1: student and lesson; %2: points; %3: &quot;4 attempts&quot;; %4: a date</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: best %2, not passed, %3, last %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last</source>
        <extracomment>Column: when the student&apos;s last attempt was</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: never logged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: last login %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>user name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last login, UTC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last attempt, UTC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: best score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>late</source>
        <extracomment>Of a student who has not passed a lesson that is overdue</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not tried, and overdue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: best %2, not passed and overdue, %3, last %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>due %1</source>
        <extracomment>%1: a date</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) at most</source>
        <translation>
            <numerusform>%n attempt at most</numerusform>
            <numerusform>%n attempts at most</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>out of tries</source>
        <extracomment>Of a student who has no attempts left at a lesson that he has not passed</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: best %2, not passed and no attempts left, %3, last %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: begun, without a score so far, and no attempts left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: begun, without a score so far, and overdue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: begun, without a score so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disabled</source>
        <extracomment>Of a student whose account is closed</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::people::ClassPage</name>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1: name of a class; %2: how many students</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1: how many; %2: &quot;stuck&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show who made three attempts in a row at a lesson without passing, and without getting better by five points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show who has never logged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show who has logged in and has no graded attempt yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody needs you just now</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n need(s) you:</source>
        <translation>
            <numerusform>%n needs you:</numerusform>
            <numerusform>%n need you:</numerusform>
        </translation>
    </message>
    <message>
        <source>Here you will see your classes: who needs you, and how everybody does at every lesson. An administrator gives you a class.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is in this class yet. Students are entered by an administrator, one by one or from a list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be written (%2). Try another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the class does at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lesson whose charts are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Best scores, students by lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as PDF …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the matrix as a table (CSV) …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show who has not passed a lesson that is overdue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 of %3 passed)</source>
        <extracomment>%1: a lesson; %2 of the %3 who tried it</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no class yet. Make one, and enter its teachers and students: then you see here who needs help, and how everybody does at every lesson.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is in this class yet. Enter its students, one by one or from a list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People and classes</source>
        <extracomment>Where people are entered and classes are made</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1: a class; %2: a lesson</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show who has no attempts left at a lesson that is not passed. More can be allowed under Assign lessons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Best score of each student; a tick: passed; ▲: overdue, or no attempts left. A heading sorts, once more the other way, then by name. A cell opens the attempts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%Ln student(s)</source>
        <translation>
            <numerusform>%Ln student</numerusform>
            <numerusform>%Ln students</numerusform>
        </translation>
    </message>
    <message>
        <source>Search: a student</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 F5 reads the class again; Cusp tries it every ten seconds, too.</source>
        <extracomment>%1: that a class could not be read, and why</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The class is being read …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 F5 reads the classes again; Cusp tries it every ten seconds, too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The classes are being read …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryCharts</name>
    <message>
        <source>Attempt %1, %2</source>
        <extracomment>%1: a count; %2: date and time</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The newest %1 of %2 attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 points, passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points, not passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(machine: %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: which attempt; %2: what it came to</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempt %1: median %3, middle half %4 to %5, %2 people</source>
        <extracomment>Of a class; %1: a count of attempts, %2: of people, %3 to %5: points</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After the first graded attempt its score is here, and then how it goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What costs points</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Average of the last %n attempt(s)</source>
        <translation>
            <numerusform>Of %n attempt</numerusform>
            <numerusform>Average of the last %n attempts</numerusform>
        </translation>
    </message>
    <message>
        <source>After the first graded attempt you see here which criterion costs most.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <extracomment>%1: &quot;12:07&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After the first graded attempt you see here how long it took.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean %1 N, highest %2 N while cutting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newtons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force while cutting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After the first graded attempt you see here how hard the bur was pressed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class median, time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class median, points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good and quick is at the top left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After the first graded attempt you see here time against points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Of the last %n attempt(s), each in those where it counts</source>
        <translation>
            <numerusform>Of the last %n attempt, as far as it counts there</numerusform>
            <numerusform>Of the last %n attempts, each in those where it counts</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 points lost</source>
        <extracomment>%1: a criterion; %2: a number</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryModel</name>
    <message>
        <source>passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Given by an instructor. The machine&apos;s score: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean and highest force while cutting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, given by an instructor; the machine&apos;s score: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Date</source>
        <extracomment>Column of a table of attempts</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force, N</source>
        <extracomment>Newtons</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read</source>
        <extracomment>Of a teacher&apos;s feedback: to be read yet; not read by the student; read already</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A teacher has written about this attempt or given another score: open its grade to read it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feedback</source>
        <extracomment>Column of a table of attempts: what a teacher has said</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unread</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryPage</name>
    <message>
        <source>Criteria</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1: a lesson; %2: how many attempts</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message>
        <source>Of this attempt no recording was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See again how it was done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the attempts at this lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open grade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No attempts yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no attempts yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here you will find every attempt that was graded: its score, what cost points, time and force, and how it goes from attempt to attempt. Do a lesson and have it graded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As soon as an attempt has been graded it is here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <extracomment>A chart of speed and accuracy</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, begun %2</source>
        <extracomment>%1: an exam; %2: when it was begun</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message>
        <source>Exams that have no score: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See what cost points, and where</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See what cost points</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) wait on this computer, and stand here when the school has them.</source>
        <translation>
            <numerusform>%n attempt waits on this computer, and stands here when the school has it.</numerusform>
            <numerusform>%n attempts wait on this computer, and stand here when the school has them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::people::ListTable</name>
    <message>
        <source>Corner of the table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sorted by: %1, from the least</source>
        <extracomment>%1: a heading</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sorted by: %1, from the most</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::people::LoginPage</name>
    <message>
        <source>Cusp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log in, so that your attempts are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The one-time code is right. From now on you log in with a password of your own: eight characters or more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Welcome to Cusp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody has been entered here yet. Create the school: you become its admin, who enters teachers and students. Or practise now; nothing is kept then.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create the school</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked by %1</source>
        <extracomment>%1: the name a user logs in with</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work on the table is as it was left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody else logs in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practise now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practise without login</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name to log in with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Given name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Family name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Password or one-time code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The password again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill and be graded; nothing is kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The two passwords differ. Type the second one again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the language of all words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore backup (%1)</source>
        <extracomment>%1: day and time</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts of this computer are brought in again. What teachers and admins have entered since then is missing. The file that is there now is kept beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change your password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The new one: eight characters or more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave it as it is</source>
        <extracomment>Back, without having changed the password</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change my password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Present password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The new password again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A name to log in with has 1 to 64 letters, digits and . _ - @, and no spaces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This name has signs that cannot be seen. Type it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s data are not where they were: there is nobody in %1. But there is a backup of them, which you can restore below. Or create a new school: you become its admin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The attempt just graded is mine; keep it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: it becomes the attempt of who logs in. Without the tick it is not kept.</source>
        <extracomment>%1: a lesson or a tooth</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work on the table is as it was left, but the time of the exam goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for the school&apos;s data …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school&apos;s data are being opened …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::people::TalkPanel</name>
    <message>
        <source>%1 points, passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points, not passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Given by %1. The machine&apos;s score: %2 points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machine&apos;s score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1 of the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pin the comment to this moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at the marked place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pin the comment to this place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▶ %1</source>
        <extracomment>%1: minutes and seconds</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the moment %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>◎ place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gave %1 points: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>let the machine&apos;s score count again: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a comment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add comment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give another score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> points</source>
        <extracomment>Behind a number</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason, which the student reads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give this score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the machine&apos;s score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To pin it, click a place on the tooth above, or play the attempt to a moment and come back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To pin it to a moment, play the attempt to there and come back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To pin it to a place, click on the tooth above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Room for %Ln more character(s)</source>
        <translation>
            <numerusform>Room for %Ln more character</numerusform>
            <numerusform>Room for %Ln more characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln character(s) too many: a comment has at most %1.</source>
        <translation>
            <numerusform>%Ln character too many: a comment has at most %1.</numerusform>
            <numerusform>%Ln characters too many: a comment has at most %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>This comment had been taken back already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taken back. Nobody is shown it any more. Its words are here again, to be corrected or cleared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back your comment of %1</source>
        <extracomment>%1: when it was written</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taken back. Nobody is shown it any more. Its words are here again, below what you are writing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A score has 0 to 100 points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you had typed on this attempt in another window stands below it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You were giving another score to an attempt in another window, and that waits, too: %1 points. %2</source>
        <extracomment>%1: a number; %2: why</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody has written anything yet. Where there is a recording, a comment can be pinned to a moment of the replay and to a place on the tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody has written anything yet. What an instructor says is here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::people::Words</name>
    <message>
        <source>Free practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>today</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>d MMM</source>
        <extracomment>A day without its year, as QLocale::toString() takes it: &quot;27 Nov&quot;. German &quot;d. MMM&quot;, Japanese &quot;M月d日&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MMM yyyy</source>
        <extracomment>A month, as QLocale::toString() takes it: &quot;Nov 2024&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::presets::FeedChart</name>
    <message>
        <source>Feed over force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 mm/s</source>
        <extracomment>%1 is a material, %2 a speed</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straight down with %1 N</source>
        <extracomment>%1 is a force</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feed, mm/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dashed: as it was kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, as it was kept</source>
        <extracomment>%1 is a material; its line is that of the preset before it was changed</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::presets::PresetTable</name>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts from</source>
        <extracomment>The force from which on a material is cut</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::presets::PresetsPage</name>
    <message>
        <source>Hardness presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hardness presets and their versions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read a preset from a file and keep it here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export this version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the chosen version to a file, for another school</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes: what it is for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A few sliders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every number with its range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feed of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bur whose feed is drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try on a block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill a block of enamel, dentin and soft caries with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate under another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin a preset of another name with these numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use for practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use this version for practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every tooth feels like this, unless its lesson says otherwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare blind with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare A and B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill with both, behind letters, and say which feels more like a tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>version %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore as the newest version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as a new version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A version is never changed: this becomes another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 copy</source>
        <extracomment>%1 is the name of a preset that is duplicated</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials:</source>
        <extracomment>Before a number</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An admin keeps the school&apos;s presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These two feel the same: choose another, or change a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring the changes back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you had changed of %1 is put aside.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you have changed of the hardness preset %1 is not saved.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>retired</source>
        <extracomment>A hardness preset that nobody is offered any more</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take up again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Retire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offer this preset again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Retire this preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is in use or shipped is not retired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is offered again, in all its versions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is offered it any more; attempts go on naming it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you changed of the hardness preset %1 in another window waits, too.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::presets::SimplePanel</name>
    <message>
        <source>Enamel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>softer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>harder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dentin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Caries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plastic tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch that cuts</source>
        <extracomment>How hard one must press before anything comes away</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lighter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heavier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall</source>
        <extracomment>What an uncut tooth feels like under the bur</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stiffer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <extracomment>A slider: what it is about, and the words at its ends</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the middle: the numbers that were typed.</source>
        <extracomment>Of sliders. %1 is a hardness preset</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the middle: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::presets::TrialCard</name>
    <message>
        <source>Feel A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill with the preset behind A from now on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill with the preset behind B from now on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A does</source>
        <extracomment>Which of two presets feels more like a tooth</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set all sliders back to the preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as CSV …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the comparison as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill: each slider is felt at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <extracomment>%1 of %2 trials</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill with A and with B, as often as you like. Which feels more like a tooth?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1: chosen %n time(s).</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>
            <numerusform>%1: chosen %n time.</numerusform>
            <numerusform>%1: chosen %n times.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No difference: %n time(s).</source>
        <translation>
            <numerusform>No difference: %n time.</numerusform>
            <numerusform>No difference: %n times.</numerusform>
        </translation>
    </message>
    <message>
        <source>That says nothing: they came out as even as can be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>That is hardly chance: tossing a coin comes out as uneven only %n time(s) in 100.</source>
        <translation>
            <numerusform>That is hardly chance: tossing a coin comes out as uneven only %n time in 100.</numerusform>
            <numerusform>That is hardly chance: tossing a coin comes out as uneven only %n times in 100.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>That may be chance: tossing a coin comes out as uneven %n time(s) in 100. Compare more often to be sure.</source>
        <translation>
            <numerusform>That may be chance: tossing a coin comes out as uneven %n time in 100. Compare more often to be sure.</numerusform>
            <numerusform>That may be chance: tossing a coin comes out as uneven %n times in 100. Compare more often to be sure.</numerusform>
        </translation>
    </message>
    <message>
        <source>First cut a little with both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What has been answered counts, and it is told which was which</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was ended before anything was chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Block of</source>
        <extracomment>What the block is made of on which a hardness preset is tried</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the block is made of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>enamel, dentin, soft decay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>enamel, dentin, firm decay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plastic throughout</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::presets::Words</name>
    <message>
        <source>Soft caries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firm caries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enamel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dentin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plastic tooth</source>
        <extracomment>What the teeth of a typodont are made of</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: rate</source>
        <extracomment>%1 is a material of a tooth</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share along the bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damping of fast motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume that a newton beyond the threshold takes away in a second, pushing sideways.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A lighter touch leaves no mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left of the rate when the bur is pushed along its axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the spring between hand and bur: how hard a wall feels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What calms the hand at rest. Too much is felt as a buzz.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What calms a fast hand besides, as when the bur is thrown at the tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the bur that slides on the tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest force that is ever given to the hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <extracomment>A range: %1 to %2, %3 is a unit</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <extracomment>%1 is the name of a hardness preset, %2 its version</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, changed by hand</source>
        <extracomment>After the name of a hardness preset whose numbers were changed during the attempt</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force limit is %1 N, and the device gives at most %2 N: lower it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds: a light hand at %1 ms of delay is steady up to %2 N/mm, and this is %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Would tremble: a light hand at %1 ms of delay is steady up to %2 N/mm, and this is %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower the stiffness, or damp more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower the stiffness.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::replay::HistoryPanel</name>
    <message>
        <source>Undo history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to a moment: click it, or press Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each stroke you make appears here as a small picture. Click one to go back to it; what came after stays, as a branch of its own.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::replay::ReplayBar</name>
    <message>
        <source>You are watching a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop watching and go back to your own work (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Progress of a recording: minutes and seconds played, and of the whole</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1×</source>
        <extracomment>Speed of a replay: so many times as fast as it was made</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the replay: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::replay::TimeLine</name>
    <message>
        <source>Time line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left and right go from stroke to stroke, Home and End to the beginning and the end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>On a time line: a time, and what happened then</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke %1, %2 s, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elsewhere for %1, which is no time of the attempt</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::report::ClassReport</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: what they need; %2: names</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stuck (three attempts in a row, not passed, not better by five points)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Never logged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Logged in, no graded attempt yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n student(s)</source>
        <translation>
            <numerusform>%n student</numerusform>
            <numerusform>%n students</numerusform>
        </translation>
    </message>
    <message>
        <source>The class at: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Late: a lesson is overdue and not passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rubric: %1, version %2, content %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No attempts left at a lesson that is not passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Best scores</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓: passed; ▲: overdue, or no attempts left; ▲ behind a name: needs the teacher</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::report::ScoreCard</name>
    <message>
        <source>Score card: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1: a person; %2: date and time</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Given by an instructor. The machine&apos;s score: %1 points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <extracomment>%1: a person; %2: date and time; %3: why</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected before the score was seen: %1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time %1 min; force while cutting %2 N on the average, %3 N at most</source>
        <extracomment>&quot;12:07&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message>
        <source>not kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Lost of a weight, both points: &quot;−4.4 of 30.0&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the points went</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the tooth, and in a section through the place that is farthest off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it was marked and made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rubric: %1, version %2, content %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hardness: %1, content %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device: %1; contact: %2; grid: %3 columns a side; view: %4; seed: %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made with Cusp %1; recording %2; attempt %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured: undercuts and walls past 90°, because the model is a height field.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2, at %3 of the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of 100 points, pass mark %2. %3</source>
        <extracomment>%1 and %2: points; %3: &quot;Passed&quot;, &quot;Not passed: harm done&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comments, with the numbers of their places in the picture of the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mouse, pen or gamepad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated handpiece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>continuous</source>
        <extracomment>How the point of contact is found: anywhere, not only on a lattice</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on a lattice</source>
        <extracomment>How the point of contact is found</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on a lattice, 16 steps a tick</source>
        <extracomment>How the point of contact is found</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by depth</source>
        <extracomment>How force is found: the deeper inside, the harder it is pushed out</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flat</source>
        <extracomment>A picture that is no stereo picture</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>red and cyan glasses, in colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>red and cyan glasses, in grey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stereo, halves side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stereo, halves one above the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rubric: content %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::report::Sheet</name>
    <message>
        <source>Cusp %1, printed %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, page %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Audit code: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not kept in a school&apos;s database: there is no audit code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, page %2 of %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::settings::SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set back: %1</source>
        <extracomment>%1 is the name of a setting</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No setting is called so, and none speaks of it. Look for one word, such as &quot;force&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of every window, at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the next start on. The practice room is always dark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dark</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::AccountMenu</name>
    <message>
        <source>My place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change my password …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::Actions</name>
    <message>
        <source>Drill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the bur turn, or stop it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back the last stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the stroke again that was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the tooth whole again; undo brings your work back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure what you have cut and explain the grade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take this bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tooth and files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the arches and choose one of 16 teeth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the scan of a tooth: OBJ, STL or PLY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save every movement of this attempt to a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watch a saved attempt again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View from the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the tooth back to where it began</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the figures, or put them away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill the whole screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what every key does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close Cusp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>Tooltip: what it does, then its key</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the recording where it is, or let it go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the handpiece from the other side; the view stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lead the handpiece home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the handpiece lead your hand back over the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the other side: half a circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dental mirror</source>
        <extracomment>The small round mirror on a handle</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the mirror or put it away; drag its glass, with Shift to tilt it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light on the handpiece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the handpiece light the cavity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours of depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour the cut by its depth and tell it under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the hand is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show faintly where the hand holds the bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours for every eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give each tissue a colour and a pattern that nobody confuses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wet tooth</source>
        <extracomment>The tooth as if it were wet</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the tooth shine as if it were wet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stereo picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One picture for each eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set up the stereo picture …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose glasses or screen and fit it to your eyes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn left and right over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For a half-silvered mirror over the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn up and down over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For a screen that lies upside down over the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a picture …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save what the view shows as a PNG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gliding, no spinning bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole mouth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a tooth in the whole mouth, or go back to the flat arches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seeing inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show a live cut through the bur, or put it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the cut about the bur by 15 degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show X-ray pictures of the tooth, before and now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This lesson does not allow it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Neighbouring teeth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the teeth beside this one, and the gum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours against the ideal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour what is too deep and what is still to go, and tell it under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose what to practise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what can be gone back to, branches and all, or put it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A stroke back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go back to the end of the stroke before, and hold there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A stroke on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on to the end of the next stroke, and hold there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the beginning of the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the end of the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play the recording more slowly, down to a tenth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play the recording faster, up to 16 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take this handpiece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour the bur</source>
        <extracomment>The bur tells by its colour how near it is to what is to be kept</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour the bur by how near it is to what is to be kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guided hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let a gentle force hold the hand within the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the lesson …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the ideal and the marking of the lesson that is chosen in the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save this attempt as the reference …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep what you have cut as the ideal that lessons ask for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The expert&apos;s attempt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watch how an expert does it; in a replay, beside this attempt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another beside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open another attempt beside this one, or put it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Be led along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the handpiece lead your hand along the attempt; a push lets go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hardness presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose, try and change how drilling feels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at parameters and turn them while you drill, or put it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every setting with its range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See how your attempts went</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See how a class does, and who needs help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Be shown round, step by step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>School</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People, class lists, backups and the audit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log in; lock this place, change your password or the language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock, or let another log in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your work stays; who comes back or logs in says who he is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close what is open here; nothing is lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guest,
unsaved</source>
        <extracomment>Beside &quot;Log in&quot;, on every page: what is done now is kept for nobody. Two short lines.</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what was done at other computers meanwhile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::ArchTooth</name>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is the FDI number, %2 the tooth&apos;s name</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::ArchView</name>
    <message>
        <source>Arches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::BurChooser</name>
    <message>
        <source>Burs</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::BusyCard</name>
    <message>
        <source>Working</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::Drafts</name>
    <message>
        <source>Something that was typed and kept nowhere waits on this computer, but this Cusp cannot read it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throw it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The attempt that you typed this on is there no more.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::DrillSwitch</name>
    <message>
        <source>Drill is on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill is off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill off</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::FileDialog</name>
    <message>
        <source>%1 is a file of another kind and stays as it is. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::ForceBar</name>
    <message>
        <source>Force against the force that is set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mark is the force that is set. A wall that presses sideways adds to it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::HandpieceChooser</name>
    <message>
        <source>Handpieces</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::HelpOverlay</name>
    <message>
        <source>Move the bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push it against the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lift it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push harder, softer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Come nearer, go back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right double-click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move it finely</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift + arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right or middle drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The teal arc beside the bur shows how hard it presses; it is full at the force that is set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the handpiece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same with Shift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drag its glass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt + arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilt the mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel over it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring it nearer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt + Page Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sort it otherwise</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::HistoryChart</name>
    <message>
        <source>Last grades, oldest first: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 by another rubric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: date and time; %2: what the grade of then came to</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::LanguageMenu</name>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::MainWindow</name>
    <message>
        <source>Cusp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tooth is whole again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring my work back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cusp is still busy with what came before, and did not do that. Try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 – Cusp</source>
        <extracomment>%1: a lesson; %2: a person and a date</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n note(s) about this scan</source>
        <translation>
            <numerusform>%n note about this scan</numerusform>
            <numerusform>%n notes about this scan</numerusform>
        </translation>
    </message>
    <message>
        <source>Scans of teeth (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is neither a scan (OBJ, STL, PLY) nor a recording. Drop one of those.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a replay. Stop it to be graded on your own work.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording was saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording has come to its end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you have cut would be lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has not been saved as a recording since you last cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save the recording …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo takes the stroke back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tooth perforated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulp opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave it as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From below nothing is drilled: the bur works on the other side of the tooth. Turn it back, or press V.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated handpiece is at work</source>
        <extracomment>Beside the name of the tooth, where otherwise &quot;lower left first molar&quot; stands</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture was saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture could not be written. Choose another folder, or make room on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the X-ray pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a tooth with decay has an ideal preparation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time of this lesson is over. Go on as long as you like, or press G.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This file cannot be given as a lesson, so there is nothing to edit. Mend what is named first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Captured ideals (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You held against it, so your hand is free. Press A to be led again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The handpiece is not there any more, so your hand is free.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The exercise begins anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You are in an exam, and a lesson&apos;s ideal is shown in the editor. Finish the exam first: press G for the grade, or take another lesson.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: an attempt of %2 was not finished.</source>
        <extracomment>%1: &quot;Tooth 36&quot;, &quot;Practice block: line&quot;; %2: a time of today, or a day and a time</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>What you have changed in %n lesson(s) would be lost.</source>
        <translation>
            <numerusform>What you have changed in %n lesson would be lost.</numerusform>
            <numerusform>What you have changed in %n lessons would be lost.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another attempt at the exam begins.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The attempt was discarded; it is kept for seven days.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a hardness preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the hardness preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The comparison was saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The comparison could not be written. Choose another folder, or make room on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hardness preset was kept: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It feels like %1 now.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In an exam, what is felt stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a replay: it feels as it was recorded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two presets are being compared blind: that comes to its end first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This lesson brings its own hardness. Only the forces can be changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hardness presets (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The exam would be broken off without a score.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It counts as an attempt all the same. What you have cut cannot be graded later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Grade it now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lessons are changed by teachers: log in as one. To do the lesson, choose it in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another attempt at the lesson begins.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no hardness preset &quot;%1&quot;. There are: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not everything has been saved, and it would be lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a file …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You had used up your attempts at this lesson before, so this grade is not kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work itself can be kept as a recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the school keeps does not answer yet. You can go on drilling; what you asked for comes when it does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Show it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cusp stays open: what somebody else has typed or changed is not kept yet, and it cannot be put by on this computer. Make room on the disk, or let that person log in here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n comment(s) were typed and are not added yet.</source>
        <translation>
            <numerusform>%n comment was typed and is not added yet.</numerusform>
            <numerusform>%n comments were typed and are not added yet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n score(s) were typed and are not given yet.</source>
        <translation>
            <numerusform>%n score was typed and is not given yet.</numerusform>
            <numerusform>%n scores were typed and are not given yet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n grade(s) are not kept yet, and would be lost.</source>
        <translation>
            <numerusform>%n grade is not kept yet, and would be lost.</numerusform>
            <numerusform>%n grades are not kept yet, and would be lost.</numerusform>
        </translation>
    </message>
    <message>
        <source>The disk takes nothing now. It is tried again every few seconds as long as Cusp runs: make room on the disk, or check the rights of the folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One-time codes that %1 made would be lost.</source>
        <extracomment>%1: an admin, or several</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are kept nowhere else. Whoever has not logged in with one by then gets another from an admin, under School.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time of this exam is over: nothing more can be cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This exam is over, but has no grade yet. Press G for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Go on with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another attempt begins.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This exam would be put away without a score.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It counts as an attempt all the same. Right afterwards you can still bring it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The one-time code does not hold any more. Ask an admin for another.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::MessageBar</name>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this message (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::Mouth</name>
    <message>
        <source>Whole mouth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys walk along the arch, Enter takes the tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This computer cannot draw the whole mouth. The flat arches do the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The teeth are being made …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chosen. Enter or a double click takes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to choose it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only teeth of the left side can be drilled; %1 is its mirror image.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right button turns, wheel zooms. From above or below you see one jaw.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::PracticeRoom</name>
    <message>
        <source>Move the mouse over the tooth, press the left button to drill; right-drag turns the view; F1 for keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This attempt</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::QuestionCard</name>
    <message>
        <source>&amp;Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stay</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::ScoreBar</name>
    <message>
        <source>%1 of 100, pass mark %2</source>
        <extracomment>A score bar for the screen reader</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::ScrollPane</name>
    <message>
        <source>More than there is room for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page Up, Page Down and the arrow keys scroll</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::SidePanel</name>
    <message>
        <source>Live figures and handpiece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under the bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decay left</source>
        <extracomment>Of what is to be taken away: decay, or the preparation that is asked for</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push with, newtons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How hard the mouse and the keys push the bur against the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air</source>
        <comment>the bur touches nothing</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N, limited</source>
        <extracomment>Unit of the force while the wanted force is beyond what the device may give</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt; 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the tip stands below the surface as it was. Nothing is shown at the edge of the tooth, where straight down says little.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume of pulp cut away. The grade looks at the area that lies open, in mm².</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N, %1 sideways</source>
        <extracomment>Unit of the force, and how much of it comes from a wall that presses sideways</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beside the decay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The handpiece lies on the crown: the bur cannot reach deeper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dentin over pulp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sound dentin between the cut and the pulp straight below the tip. Two millimetres are wanted; less than half a millimetre harms the pulp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the limit</source>
        <extracomment>How far the bur is from what is to be kept</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the bur&apos;s head is from what is to be kept, downwards or sideways. Nothing is shown while it is more than a millimetre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns of the bur a minute: a load slows it, until it stalls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rpm</source>
        <extracomment>Turns a minute</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still to cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond the ideal</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::StereoCard</name>
    <message>
        <source>Distance of the eyes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plane of the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stereo picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Way to the eyes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red and cyan glasses, in colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red and cyan glasses, in grey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Halves side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Halves one above the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without stereo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1. How do the two pictures reach your eyes? Close one eye, then the other: each must see a single tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2. Move the eyes apart until the cusps stand up from the fissures, and back a little if it tires you.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3. Move the tooth before or behind the screen until you see it without effort.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave everything as it was before (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::ToothChooser</name>
    <message>
        <source>Choose a tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drill this tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put this tooth on the table (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Or drill a tooth of your own: a scan as OBJ, STL or PLY. You can also drop the file anywhere on this window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the table now. Taking it again gives you a whole one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a tooth, or walk with the arrow keys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat arches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole mouth</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::Tour</name>
    <message>
        <source>Move the bur with the mouse and press the left button to drill. Drag with the right button to turn the view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Those that come with Cusp, and your own. The search takes a word or the number of a tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change a lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change what a lesson asks for and how it marks, and see what that makes of earlier attempts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your classes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here you see who needs you and how everybody does. Assign lessons, open attempts, replay them, and write comments.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try it yourself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The grade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work is measured, and the score card shows every lost point, where it was lost and when.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How every class does at every lesson, as its teachers see it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it feels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Burs, force and depth are here. How hard teeth are is set in the hardness presets (F7).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose here what to practise. What your class is to do comes first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose here what to practise. Each lesson says what it asks and how it is marked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bur, force and depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take another bur, set how hard the mouse presses, and read force and depth while you drill.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seeing inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A live cut through the bur shows enamel, dentin and pulp, where the lesson allows it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How your scores went, what your instructor says, and every attempt to be played again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who logs in keeps the grades. Without that, nothing is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock your place when you leave it, or let somebody else log in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All keys are listed here. From there you can take this tour again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip the tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Steps of a tour: &quot;2 of 6&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The school</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter people, one by one or from a list, put them into classes, and look after backups and the audit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::shell::ViewMenu</name>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is shown of the tooth, and how</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::ConductNotes</name>
    <message>
        <source>No breach of the rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n breach(es) of the rules</source>
        <translation>
            <numerusform>%n breach of the rules</numerusform>
            <numerusform>%n breaches of the rules</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See it happen: play the attempt from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>breaches</comment>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
    <message>
        <source>Show every breach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in all, %2 of it cutting</source>
        <extracomment>Two times in minutes and seconds</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force %1 N on the mean, %2 N at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) taken back</source>
        <translation>
            <numerusform>%n step taken back</numerusform>
            <numerusform>%n steps taken back</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::study::CriterionRow</name>
    <message>
        <source>%1 not measured</source>
        <extracomment>%1: points of a score. What could not be measured earns nothing</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 never removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 never earned</source>
        <extracomment>Of a criterion that was not fulfilled at any time</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2, stroke %3</source>
        <extracomment>%1: points lost, %2: minutes and seconds of the attempt, %3: number of a stroke of the bur</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The area that lies open, seen from above. The volume that was cut away stands beside the tooth, in mm³.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fails the attempt and takes all points that are left</source>
        <extracomment>Tooltip on the points of one criterion</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most %1 points can be lost here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, %3 points</source>
        <extracomment>A row of a score, for the screen reader: %1 a criterion, %2 what was measured, %3 the points it cost</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show where this was worst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No stroke caused this: see how the attempt ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See it happen: play the attempt from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>moments at which points were lost</comment>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
    <message>
        <source>Show every moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 too late</source>
        <extracomment>%1: points of a score, for something that was done later than asked</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 too little done</source>
        <extracomment>%1: points of a score that is earned only when enough of the work is done</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::ExerciseCard</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is &quot;Left&quot;, &quot;Middle&quot; or &quot;Right&quot;, %2 a tissue</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say that this pad is made of this; you can change it until you are graded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ right</source>
        <extracomment>Beside what the student took a pad for; %1 is the tissue that it is</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ it is %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>All %n points touched</source>
        <translation>
            <numerusform>%n point touched</numerusform>
            <numerusform>All %n points touched</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 points touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Held for %1 s</source>
        <extracomment>%1 is a time in seconds</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold %1 N for %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of %1 s</source>
        <extracomment>Behind the seconds that a force has been held: of how many</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is what they are made of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every pad has its name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is each pad made of?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Graded. F2 leads to the next lesson.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Well done. See how it is marked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sure? Then see how it is marked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bur is turning: stop it with the space bar. Here nothing is to be cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the bur turn with the space bar: at rest all three feel the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest so far: %1 s</source>
        <extracomment>%1 is a time in seconds</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any order. Rings become discs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anywhere on the tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press on each for a second, and compare.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::FeedbackCard</name>
    <message>
        <source>%1 has written about your attempt: %2</source>
        <extracomment>%1: a teacher; %2: a lesson</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n of your attempts have new feedback</source>
        <translation>
            <numerusform>%n of your attempts has new feedback</numerusform>
            <numerusform>%n of your attempts have new feedback</numerusform>
        </translation>
    </message>
    <message>
        <source>Read it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::Forecast</name>
    <message>
        <source>Before you see the score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many points do you expect?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What cost you most?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See how the work was marked (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. You pass from %2 of 100 points. A score teaches more once you have judged your work yourself.</source>
        <extracomment>%1 is a lesson, %2 the mark that is needed</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing in particular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the points that you expect.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose what cost you most.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::HeatMap</name>
    <message>
        <source>The tooth from above, coloured by what is too deep and what is still to go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it ought to be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm too deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm still to go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>still to go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on the tooth, or use the arrow keys, to mark the place that a comment is about; Delete takes the mark away.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::HoldGauge</name>
    <message>
        <source>Force against the band from %1 to %2 N</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::IdealForm</name>
    <message>
        <source>What the ideal is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take recordings as the reference …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one attempt, or several whose mean is to be cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ideal is the decay itself: nothing is to be set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An exercise: nothing is to be cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ideal preparation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By rule</source>
        <extracomment>%1: the name of a file</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Captured: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <extracomment>%1 and %2: the least and the greatest number that can be set; %3: a unit</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::InfractionCard</name>
    <message>
        <source>Take it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the tooth back to before it happened; it can be redone (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave it as it is and work on (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::LessonEditor</name>
    <message>
        <source>Lesson editor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Title of the lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take recordings as the reference …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the tolerances mean on the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Past attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How attempts would score under other tolerances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lesson&apos;s file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lesson as its file says it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the lesson into your folder (Ctrl+S)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Widen the tolerances until the ideal itself loses nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the tolerances to the ideal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lesson editor: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A shipped lesson: saved, it becomes one of your own, based on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This lesson of yours is changed where it stands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This rubric has no criterion that can be drawn on the tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Costs nothing: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ideal is checked as soon as nothing is wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ideal scores %1 on itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ideal scores only %1 on itself; it loses at: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Replaying %n recording(s) …</source>
        <translation>
            <numerusform>Replaying %n recording …</numerusform>
            <numerusform>Replaying %n recordings …</numerusform>
        </translation>
    </message>
    <message>
        <source>No reference was made: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reference is %1 beside your lessons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved: whoever cuts exactly this ideal would lose points. Widen the tolerances that are named, or press Fit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved: there is a file %1 already. Open that lesson instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An exercise has no ideal that could be checked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrong: %1</source>
        <extracomment>%1: where in the lesson, and what is wrong there</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured or not earned on this ideal, so no tolerance helps: %1. Mark by another rubric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lesson needs a title.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved: %1 has been changed since you opened it, in another window or at another computer. Open it anew to see that; a step back then brings your own changes back, to be saved in its place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what stands in the file now; a step back brings your own changes back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no lesson as it stands now, and was not opened. Look at it with whoever has changed it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is what stands in the file now. A step back brings your own changes back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was changed of the lesson &quot;%1&quot; in another window waits, too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was changed of a lesson waits, but its file is there no more, or is no lesson: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::LessonPicture</name>
    <message>
        <source>What the lesson asks for, as a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This tooth cannot be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tooth is being made …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::LessonStrip</name>
    <message>
        <source>The step before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show a hint for this step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>A step of the work, and how many there are</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time worked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time left of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The exam is over, and nothing more can be cut. G shows the score; R begins another attempt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The exam is over, and nothing more can be cut. G shows the score.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::LessonsPage</name>
    <message>
        <source>Lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search: a word, or the number of a tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start this lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the tooth of this lesson on the table (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your own lessons …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the folder that a teacher&apos;s lessons are read from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the folder of your own lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot be given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This file cannot be given as a lesson. The others work.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice: you are told what goes wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Burs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aids</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marked by</source>
        <extracomment>%1 is the name of a rubric, %2 the mark that is needed</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, passed from %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not modelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your best</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 in %n attempt(s)</source>
        <translation>
            <numerusform>%1 in %n attempt</numerusform>
            <numerusform>%1 in %n attempts</numerusform>
        </translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed, not saved</source>
        <extracomment>Of a lesson in a list: in the editor</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>best %1, passed</source>
        <extracomment>For a screen reader: the best score of a lesson</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>best %1, not passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exam: faults are noted, nothing is said until the end, and no step is taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tooth …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lessons on one tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick a tooth in the arch, to see the lessons on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <extracomment>All lessons</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To do</source>
        <extracomment>Lessons that are still to be done</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passed</source>
        <extracomment>Lessons that were passed</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard the attempt that was not finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue where I stopped: %1, begun %2</source>
        <extracomment>%1: a lesson or a tooth; %2: a time of today, or a day and a time</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tried last: %1, best so far %2</source>
        <extracomment>%1: a lesson; %2: points</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Given to you, but not on this computer: %1. Ask your teacher for the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Given to you</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No lesson fits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search for another word, or show all lessons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) left</source>
        <translation>
            <numerusform>%n attempt left</numerusform>
            <numerusform>%n attempts left</numerusform>
        </translation>
    </message>
    <message>
        <source>Given to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is none of these now. Show all lessons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lessons are being read …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no score yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::RubricForm</name>
    <message>
        <source>Marking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passed from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance of: %1</source>
        <extracomment>%1: a criterion</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All weights: %1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All weights: %1 points; they must make 100</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Targets and spans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What each measure ought to be, and how far beyond the tolerance all points are lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target</source>
        <extracomment>What a measure ought to be</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target of: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all lost over</source>
        <extracomment>How far beyond the tolerance all points of a criterion are lost</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Span of: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::ScorePage</name>
    <message>
        <source>You expected %1 points: exactly so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You expected %1 points: %2 too many.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You expected %1 points: %2 too few.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marked by &quot;%1&quot;, version %2, content %3. Undercuts and walls past 90° are not measured: the model is a height field.</source>
        <extracomment>%1 is the name of a rubric, %2 its version, %3 the beginning of its hash</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The finished tooth is measured again with half and with double the number of columns along a side. That tells how far the number hangs on the grid. It tells nothing about the hand, or about what you would do on another day.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the points went</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding the moment of each lost point …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding the moment of each lost point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grade: %1</source>
        <extracomment>%1 is a lesson, &quot;Tooth 36&quot; or a file name %1 is a person, %2 a lesson</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of 100</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not passed: harm done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not passed yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At half the grid %1, at double %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At half the grid %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pass mark lies between: this result is within the noise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not within the noise of the pass mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work is everywhere as it ought to be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm too deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm still to go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the worst place, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no place; farthest off the ideal: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Of the best results of %n people in your class, %1 % are below this.</source>
        <extracomment>%1 is a number of per cent</extracomment>
        <translation>
            <numerusform>Of the best result of %n person in your class, %1 % are below this.</numerusform>
            <numerusform>Of the best results of %n people in your class, %1 % are below this.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No comparison with a class: it takes %1 people, so that nobody can be made out, and here are the results of %n person(s).</source>
        <extracomment>%1 is a number of people</extracomment>
        <translation>
            <numerusform>No comparison with a class: it takes %1 people, so that nobody can be made out, and here are the results of %n person.</numerusform>
            <numerusform>No comparison with a class: it takes %1 people, so that nobody can be made out, and here are the results of %n people.</numerusform>
        </translation>
    </message>
    <message>
        <source>other rubric</source>
        <extracomment>Beside an earlier grade that cannot be compared with this one</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is the first grade here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing cost you a point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most points went to: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What cost most you knew: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You thought that most points went to &quot;%1&quot;; they went to &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, not named</source>
        <extracomment>%1 is &quot;Left&quot;, &quot;Middle&quot; or &quot;Right&quot;, %2 and %3 are tissues</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, as you said</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, you said %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no place on the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the worst place</source>
        <extracomment>%1 a criterion of a score</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Held for %1 of %2 s, %3 N off on the average</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All points were touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 points touched; the ring marks one that was not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log in and keep it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drilled with the hardness preset %1.</source>
        <extracomment>%1 is a hardness preset with its version</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No comparison with a class: it takes %1 people, so that nobody can be made out, and yours is the only one here.</source>
        <extracomment>%1 is a number of people</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You are not logged in, so this grade is not kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This grade is kept on this computer. The school&apos;s database gets it when it can be reached.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay this attempt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Score card on paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as PDF …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grade of %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected by the student: %1 points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passed, as the teacher decided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not passed, as the teacher decided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machine&apos;s score: %1</source>
        <extracomment>%1: a sum of points</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This attempt has no recording that can be read: it cannot be replayed, and no picture of the tooth is shown. The score and what cost points are as they were kept.</source>
        <translation></translation>
    </message>
    <message>
        <source>This grade is not kept yet. It is tried again every few seconds as long as Cusp runs: make room on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This grade is not kept: it will not be here next time.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::SweepChart</name>
    <message>
        <source>Scores of past attempts over the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 times the tolerance %2 of %3 pass; median %4</source>
        <extracomment>%1: a number, &quot;1.5&quot;; %2 of %3 attempts; %4: points</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each attempt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 points at %3 times the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts that pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower quartile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper quartile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts that pass, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::SweepPage</name>
    <message>
        <source>Recordings …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder with recordings of attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder with recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose tolerance is changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings that are replayed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop replaying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with those that are done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder with recordings of this tooth: each is replayed once, and its score is drawn for tolerances from 0 to 3 times those at the left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All tolerances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No attempt in this folder was made at this tooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The attempts of the history were made for another ideal than this draft&apos;s. Choose a folder with recordings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n of them from the history.</source>
        <translation>
            <numerusform>%n of them from the history.</numerusform>
            <numerusform>%n of them from the history.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) at other teeth are left out.</source>
        <translation>
            <numerusform>%n attempt at another tooth is left out.</numerusform>
            <numerusform>%n attempts at other teeth are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) could not be read.</source>
        <translation>
            <numerusform>%n recording could not be read.</numerusform>
            <numerusform>%n recordings could not be read.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) of the history without measured values are left out.</source>
        <translation>
            <numerusform>%n attempt of the history without measured values is left out.</numerusform>
            <numerusform>%n attempts of the history without measured values are left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::study::ToleranceView</name>
    <message>
        <source>The tolerances on the tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the line of the section; arrow keys move it, Shift with them turns it, as a double click does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to show yet: what is wrong is said at the left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ideal is being made …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::Words</name>
    <message>
        <source>%1 stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only whole numbers from %1 to %2 can be entered here.</source>
        <extracomment>%1 and %2: the least and the greatest number, %2 with a unit</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only %1 to %2 can be entered here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::study::WorstSection</name>
    <message>
        <source>Section through the worst place</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::tooth::SceneWidget</name>
    <message>
        <source>No picture</source>
        <extracomment>Heading where a picture would be; a sentence below says why</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::tooth::ToothView</name>
    <message>
        <source>Tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys move the bur, page down pushes, page up lifts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N</source>
        <extracomment>A force in newtons, beside the bur</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This computer offers no OpenGL 3.3, so the tooth cannot be shown. Install or update the graphics driver (on Debian: libgl1-mesa-dri), then start Cusp again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
