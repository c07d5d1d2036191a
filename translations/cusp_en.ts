<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en_US">
<context>
    <name>Admin</name>
    <message numerus="yes">
        <source>at most %n attempt(s)</source>
        <translation>
            <numerusform>at most %n attempt</numerusform>
            <numerusform>at most %n attempts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Chart</name>
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
    <name>Lesson</name>
    <message numerus="yes">
        <source>%1, %n day(s) late</source>
        <extracomment>%1: the day it was due, &quot;17 Nov&quot;</extracomment>
        <translation>
            <numerusform>%1, %n day late</numerusform>
            <numerusform>%1, %n days late</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Login</name>
    <message numerus="yes">
        <source>Too many logins have failed. Wait %n second(s) and try again.</source>
        <translation>
            <numerusform>Too many logins have failed. Wait %n second and try again.</numerusform>
            <numerusform>Too many logins have failed. Wait %n seconds and try again.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Scan</name>
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
    <message numerus="yes">
        <source>The scan has %n separate part(s); the outermost surface counts.</source>
        <translation>
            <numerusform>The scan has %n part; its outermost surface counts.</numerusform>
            <numerusform>The scan has %n separate parts; the outermost surface counts.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::AdminController</name>
    <message numerus="yes">
        <source>%n thing(s) are not as they should be.</source>
        <translation>
            <numerusform>%n thing is not as it should be.</numerusform>
            <numerusform>%n things are not as they should be.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A place that was left is locked after %n minute(s).</source>
        <translation>
            <numerusform>A place that was left is locked after %n minute.</numerusform>
            <numerusform>A place that was left is locked after %n minutes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::SchoolController</name>
    <message numerus="yes">
        <source>%n attempt(s) on this computer cannot be sent to this school: the student is unknown, or another station.key signed them. They stay on this computer.</source>
        <translation>
            <numerusform>%n attempt on this computer cannot be sent to this school: the student is unknown, or another station.key signed it. It stays on this computer.</numerusform>
            <numerusform>%n attempts on this computer cannot be sent to this school: the student is unknown, or another station.key signed them. They stay on this computer.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) on this computer wait for another school: %1. If that is this one under an earlier name, &quot;cusp db send&quot; brings them here.</source>
        <extracomment>%1: a file&apos;s name, or the address of a server</extracomment>
        <translation>
            <numerusform>%n attempt on this computer waits for another school: %1. If that is this one under an earlier name, &quot;cusp db send&quot; brings it here.</numerusform>
            <numerusform>%n attempts on this computer wait for another school: %1. If that is this one under an earlier name, &quot;cusp db send&quot; brings them here.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::admin::AuditPart</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n row</numerusform>
            <numerusform>%n rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) among the newest %1; &quot;Older rows&quot; brings more to search</source>
        <extracomment>%1: how many rows were searched</extracomment>
        <translation>
            <numerusform>%n row among the newest %1; &quot;Older rows&quot; brings more to search</numerusform>
            <numerusform>%n rows among the newest %1; &quot;Older rows&quot; brings more to search</numerusform>
        </translation>
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
    <name>ui::admin::PeoplePart</name>
    <message numerus="yes">
        <source>%Ln person(s)</source>
        <translation>
            <numerusform>%Ln person</numerusform>
            <numerusform>%Ln people</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n one-time code(s) are shown under School, and kept nowhere else: %1.</source>
        <extracomment>%1: a person, or several</extracomment>
        <translation>
            <numerusform>%n one-time code is shown under School, and kept nowhere else: %1.</numerusform>
            <numerusform>%n one-time codes are shown under School, and kept nowhere else: %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::admin::RosterPart</name>
    <message numerus="yes">
        <source>%1: %Ln fault(s). Nothing was entered; mend the file and choose it again.</source>
        <translation>
            <numerusform>%1: %Ln fault. Nothing was entered; mend the file and choose it again.</numerusform>
            <numerusform>%1: %Ln faults. Nothing was entered; mend the file and choose it again.</numerusform>
        </translation>
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
</context>
<context>
    <name>ui::admin::StationPart</name>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::devices::HomingMarks</name>
    <message numerus="yes">
        <source>%n of 3 arms homed</source>
        <translation>
            <numerusform>%n of 3 arms homed</numerusform>
            <numerusform>%n of 3 arms homed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::people::AssignPage</name>
    <message numerus="yes">
        <source>Assign %n changed lesson(s) to new attempts</source>
        <translation>
            <numerusform>Assign %n changed lesson to new attempts</numerusform>
            <numerusform>Assign %n changed lessons to new attempts</numerusform>
        </translation>
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
    <message numerus="yes">
        <source>Assign %n lesson(s)</source>
        <translation>
            <numerusform>Assign %n lesson</numerusform>
            <numerusform>Assign %n lessons</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) who have not passed have no attempts left: earlier ones count.</source>
        <translation>
            <numerusform>%n student who has not passed has no attempts left: earlier ones count.</numerusform>
            <numerusform>%n students who have not passed have no attempts left: earlier ones count.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::people::ClassCharts</name>
    <message numerus="yes">
        <source>Best scores of %n student(s)</source>
        <translation>
            <numerusform>Best score of %n student</numerusform>
            <numerusform>Best scores of %n students</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2 points: %n student(s)</source>
        <translation>
            <numerusform>%1 to %2 points: %n student</numerusform>
            <numerusform>%1 to %2 points: %n students</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::people::ClassModel</name>
    <message numerus="yes">
        <source>%1, of which %n do not match their recordings and do not count</source>
        <translation>
            <numerusform>%1, of which %n does not match its recording and does not count</numerusform>
            <numerusform>%1, of which %n do not match their recordings and do not count</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) at most</source>
        <translation>
            <numerusform>%n attempt at most</numerusform>
            <numerusform>%n attempts at most</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::people::ClassPage</name>
    <message numerus="yes">
        <source>%n need(s) you:</source>
        <translation>
            <numerusform>%n needs you:</numerusform>
            <numerusform>%n need you:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln student(s)</source>
        <translation>
            <numerusform>%Ln student</numerusform>
            <numerusform>%Ln students</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryCharts</name>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Average of the last %n attempt(s)</source>
        <translation>
            <numerusform>Of %n attempt</numerusform>
            <numerusform>Average of the last %n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of the last %n attempt(s), each in those where it counts</source>
        <translation>
            <numerusform>Of the last %n attempt, as far as it counts there</numerusform>
            <numerusform>Of the last %n attempts, each in those where it counts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryPage</name>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
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
    <name>ui::scoring::CommentsPanel</name>
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
</context>
<context>
    <name>ui::presets::TrialCard</name>
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
</context>
<context>
    <name>ui::report::ClassReport</name>
    <message numerus="yes">
        <source>%n student(s)</source>
        <translation>
            <numerusform>%n student</numerusform>
            <numerusform>%n students</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::report::ScoreCard</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::window::UnsavedWork</name>
    <message numerus="yes">
        <source>%n grade(s) are not saved yet and would be lost.</source>
        <translation>
            <numerusform>%n grade is not saved yet and would be lost.</numerusform>
            <numerusform>%n grades are not saved yet and would be lost.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::scoring::ConductNotes</name>
    <message numerus="yes">
        <source>%n breach(es) of the rules</source>
        <translation>
            <numerusform>%n breach of the rules</numerusform>
            <numerusform>%n breaches of the rules</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>breaches</comment>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) undone</source>
        <translation>
            <numerusform>%n step undone</numerusform>
            <numerusform>%n steps undone</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::scoring::CriterionRow</name>
    <message numerus="yes">
        <source>%n more</source>
        <comment>moments at which points were lost</comment>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::practice::ExerciseCard</name>
    <message numerus="yes">
        <source>All %n points touched</source>
        <translation>
            <numerusform>%n point touched</numerusform>
            <numerusform>All %n points touched</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::scoring::FeedbackCard</name>
    <message numerus="yes">
        <source>%n of your attempts have new feedback</source>
        <translation>
            <numerusform>%n of your attempts has new feedback</numerusform>
            <numerusform>%n of your attempts have new feedback</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::LessonEditor</name>
    <message numerus="yes">
        <source>Replaying %n recording(s) …</source>
        <translation>
            <numerusform>Replaying %n recording …</numerusform>
            <numerusform>Replaying %n recordings …</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>What you have changed in %n lesson(s) would be lost.</source>
        <translation>
            <numerusform>What you have changed in %n lesson would be lost.</numerusform>
            <numerusform>What you have changed in %n lessons would be lost.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::catalog::LessonsPage</name>
    <message numerus="yes">
        <source>%1 in %n attempt(s)</source>
        <translation>
            <numerusform>%1 in %n attempt</numerusform>
            <numerusform>%1 in %n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) left</source>
        <translation>
            <numerusform>%n attempt left</numerusform>
            <numerusform>%n attempts left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::scoring::ScoreHistory</name>
    <message numerus="yes">
        <source>Of the best results of %n people in your class, %1 % are below this.</source>
        <extracomment>%1 is a number of per cent</extracomment>
        <translation>
            <numerusform>Of the best result of %n person in your class, %1 % are below this.</numerusform>
            <numerusform>Of the best results of %n people in your class, %1 % are below this.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No comparison with a class: to keep results anonymous it needs %1 people, and there are results of %n person(s).</source>
        <extracomment>%1 is a number of people</extracomment>
        <translation>
            <numerusform>No comparison with a class: to keep results anonymous it needs %1 people, and there are results of %n person.</numerusform>
            <numerusform>No comparison with a class: to keep results anonymous it needs %1 people, and there are results of %n people.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::scoring::ScorePage</name>
</context>
<context>
    <name>ui::lessoneditor::SweepPage</name>
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
    <name>ui::window::Notices</name>
    <message numerus="yes">
        <source>%n note(s) about this scan</source>
        <translation>
            <numerusform>%n note about this scan</numerusform>
            <numerusform>%n notes about this scan</numerusform>
        </translation>
    </message>
</context>
</TS>
