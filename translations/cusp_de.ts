<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_US">
<context>
    <name>Admin</name>
    <message>
        <source>erased a person</source>
        <translation>hat eine Person gelöscht</translation>
    </message>
    <message>
        <source>erased a comment</source>
        <translation>hat einen Kommentar gelöscht</translation>
    </message>
    <message>
        <source>erased the reason for a score</source>
        <translation>hat die Begründung einer Punktzahl gelöscht</translation>
    </message>
    <message>
        <source>This person was erased and cannot come back.</source>
        <translation>Diese Person wurde gelöscht und kann nicht zurückkommen.</translation>
    </message>
    <message>
        <source>Erase %1?</source>
        <translation>%1 löschen?</translation>
    </message>
    <message>
        <source>The names, the login and the comments by and about this person are removed. The attempts and scores stay, under a pseudonym. This cannot be undone, and it does not reach backups and exported files.</source>
        <translation>Die Namen, die Anmeldung und die Kommentare von dieser Person und über sie werden entfernt. Die Versuche und Punktzahlen bleiben unter einem Pseudonym. Das lässt sich nicht rückgängig machen, und es erreicht keine Sicherungen und exportierten Dateien.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>&amp;Keep the person</source>
        <translation>Person be&amp;halten</translation>
    </message>
    <message>
        <source>an attempt was compared with the assigned version</source>
        <translation>ein Versuch wurde mit der aufgegebenen Fassung verglichen</translation>
    </message>
    <message>
        <source>marked an attempt again from its recording</source>
        <translation>hat einen Versuch aus seiner Aufzeichnung noch einmal bewertet</translation>
    </message>
    <message>
        <source>found an older copy in the place of the database</source>
        <translation>fand eine ältere Kopie an der Stelle der Datenbank</translation>
    </message>
    <message>
        <source>logged in</source>
        <translation>hat sich angemeldet</translation>
    </message>
    <message>
        <source>logged out</source>
        <translation>hat sich abgemeldet</translation>
    </message>
    <message>
        <source>a login failed</source>
        <translation>eine Anmeldung schlug fehl</translation>
    </message>
    <message>
        <source>used a one-time code</source>
        <translation>hat einen Einmalcode benutzt</translation>
    </message>
    <message>
        <source>changed the password</source>
        <translation>hat das Passwort geändert</translation>
    </message>
    <message>
        <source>reset a password</source>
        <translation>hat ein Passwort zurückgesetzt</translation>
    </message>
    <message>
        <source>entered a person</source>
        <translation>hat eine Person eingetragen</translation>
    </message>
    <message>
        <source>changed a person</source>
        <translation>hat eine Person geändert</translation>
    </message>
    <message>
        <source>added a class</source>
        <translation>hat eine Klasse angelegt</translation>
    </message>
    <message>
        <source>renamed a class</source>
        <translation>hat eine Klasse umbenannt</translation>
    </message>
    <message>
        <source>put somebody into a class</source>
        <translation>hat jemanden in eine Klasse aufgenommen</translation>
    </message>
    <message>
        <source>took somebody out of a class</source>
        <translation>hat jemanden aus einer Klasse genommen</translation>
    </message>
    <message>
        <source>gave a lesson to a class</source>
        <translation>hat einer Klasse eine Lektion aufgegeben</translation>
    </message>
    <message>
        <source>took a lesson back</source>
        <translation>hat eine Lektion zurückgenommen</translation>
    </message>
    <message>
        <source>an attempt was kept</source>
        <translation>ein Versuch wurde gespeichert</translation>
    </message>
    <message>
        <source>commented on an attempt</source>
        <translation>hat einen Versuch kommentiert</translation>
    </message>
    <message>
        <source>gave another score</source>
        <translation>hat eine andere Punktzahl gegeben</translation>
    </message>
    <message>
        <source>kept a hardness preset</source>
        <translation>hat eine Härte-Voreinstellung gespeichert</translation>
    </message>
    <message>
        <source>changed a setting</source>
        <translation>hat eine Einstellung geändert</translation>
    </message>
    <message>
        <source>a backup was restored</source>
        <translation>eine Sicherung wurde zurückgespielt</translation>
    </message>
    <message>
        <source>guest</source>
        <translation>Gast</translation>
    </message>
    <message>
        <source>student</source>
        <translation>Student/in</translation>
    </message>
    <message>
        <source>instructor</source>
        <translation>Lehrkraft</translation>
    </message>
    <message>
        <source>admin</source>
        <translation>Admin</translation>
    </message>
    <message>
        <source>nobody</source>
        <translation>niemand</translation>
    </message>
    <message>
        <source>the program</source>
        <translation>das Programm</translation>
    </message>
    <message>
        <source>began an exam</source>
        <translation>begann eine Prüfung</translation>
    </message>
    <message>
        <source>found the audit changed</source>
        <translation>fand das Protokoll verändert</translation>
    </message>
    <message>
        <source>made a backup</source>
        <translation>hat eine Sicherung angelegt</translation>
    </message>
    <message>
        <source>exported attempts</source>
        <translation>hat Versuche exportiert</translation>
    </message>
    <message>
        <source>copied the school into another database</source>
        <translation>hat die Schule in eine andere Datenbank kopiert</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>anderer Name</translation>
    </message>
    <message>
        <source>a name that nobody has</source>
        <translation>ein Name, den niemand hat</translation>
    </message>
    <message>
        <source>brought the school here from another database</source>
        <translation>hat die Schule aus einer anderen Datenbank hierher gebracht</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>enabled</source>
        <translation>freigegeben</translation>
    </message>
    <message numerus="yes">
        <source>at most %n attempt(s)</source>
        <translation>
            <numerusform>höchstens %n Versuch</numerusform>
            <numerusform>höchstens %n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>as many attempts as one likes</source>
        <translation>beliebig viele Versuche</translation>
    </message>
    <message>
        <source>It has more fields than the first line names.</source>
        <translation>Sie hat mehr Felder, als die erste Zeile nennt.</translation>
    </message>
    <message>
        <source>It stands in line %1 already.</source>
        <translation>Er steht schon in Zeile %1.</translation>
    </message>
    <message>
        <source>It is too long, or has signs that cannot be seen.</source>
        <translation>Er ist zu lang oder enthält Zeichen, die man nicht sieht.</translation>
    </message>
    <message>
        <source>It is none of student, instructor, admin.</source>
        <translation>Das ist weder student noch instructor noch admin.</translation>
    </message>
    <message>
        <source>Here the role is %1; a class list does not change it.</source>
        <translation>Hier ist die Rolle %1; eine Klassenliste ändert sie nicht.</translation>
    </message>
    <message>
        <source>The name of a class has 1 to 100 characters that can be seen.</source>
        <translation>Der Name einer Klasse hat 1 bis 100 sichtbare Zeichen.</translation>
    </message>
    <message>
        <source>when a place that was left is locked</source>
        <translation>wann ein verlassener Platz gesperrt wird</translation>
    </message>
    <message>
        <source>how long checking a password takes</source>
        <translation>wie lange das Prüfen eines Passworts dauert</translation>
    </message>
    <message>
        <source>how much memory checking a password takes</source>
        <translation>wie viel Speicher das Prüfen eines Passworts braucht</translation>
    </message>
    <message>
        <source>the preset that everybody uses</source>
        <translation>die Voreinstellung, die für alle gilt</translation>
    </message>
    <message>
        <source>attempt %1</source>
        <translation>Versuch %1</translation>
    </message>
    <message>
        <source>exam %1</source>
        <translation>Prüfung %1</translation>
    </message>
    <message>
        <source>class %1</source>
        <translation>Klasse %1</translation>
    </message>
    <message>
        <source>person %1</source>
        <translation>Person %1</translation>
    </message>
    <message>
        <source>setting %1</source>
        <translation>Einstellung %1</translation>
    </message>
    <message>
        <source>all attempts</source>
        <translation>alle Versuche</translation>
    </message>
    <message>
        <source>the school</source>
        <translation>die Schule</translation>
    </message>
    <message>
        <source>the audit</source>
        <translation>das Protokoll</translation>
    </message>
    <message>
        <source>preset %1, version %2</source>
        <translation>Voreinstellung %1, Version %2</translation>
    </message>
    <message>
        <source>backup of %1</source>
        <extracomment>%1: a day and a time, or the name of a file</extracomment>
        <translation>Sicherung vom %1</translation>
    </message>
    <message>
        <source>From sign %1 of this line on the file is no UTF-8 text. Save it from the spreadsheet as “CSV UTF-8”.</source>
        <translation>Ab Zeichen %1 dieser Zeile ist die Datei kein Text in UTF-8. Speichern Sie sie in der Tabellenkalkulation als „CSV UTF-8“.</translation>
    </message>
    <message>
        <source>A quotation mark at sign %1 of this line is not closed.</source>
        <translation>Ein Anführungszeichen an Zeichen %1 dieser Zeile ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>At sign %1 of this line words stand behind a closing quotation mark.</source>
        <translation>An Zeichen %1 dieser Zeile stehen Wörter hinter einem schließenden Anführungszeichen.</translation>
    </message>
    <message>
        <source>A class list has no such column. Is it %1?</source>
        <extracomment>%1: the name of a column</extracomment>
        <translation>Eine Klassenliste hat keine solche Spalte. Ist %1 gemeint?</translation>
    </message>
    <message>
        <source>This column is there twice.</source>
        <translation>Diese Spalte gibt es zweimal.</translation>
    </message>
    <message>
        <source>This column is missing. The first line names the columns.</source>
        <translation>Diese Spalte fehlt. Die erste Zeile nennt die Spalten.</translation>
    </message>
    <message>
        <source>a computer wrote here for the first time</source>
        <translation>ein Rechner hat hier zum ersten Mal geschrieben</translation>
    </message>
    <message>
        <source>computer with the key %1</source>
        <translation>Rechner mit dem Schlüssel %1</translation>
    </message>
    <message>
        <source>took out a report of a class</source>
        <translation>hat einen Klassenbericht entnommen</translation>
    </message>
    <message>
        <source>had the password kept more safely</source>
        <translation>bekam sein Passwort sicherer gespeichert</translation>
    </message>
    <message>
        <source>took a comment back</source>
        <translation>hat einen Kommentar zurückgenommen</translation>
    </message>
    <message>
        <source>how long a login by a name that nobody has takes</source>
        <translation>wie lange eine Anmeldung mit einem Namen dauert, den niemand hat</translation>
    </message>
    <message>
        <source>A class list has no such column. It has username, given_name, family_name, role and class.</source>
        <translation>Eine Klassenliste hat keine solche Spalte. Sie hat username, given_name, family_name, role und class.</translation>
    </message>
    <message>
        <source>which presets are retired</source>
        <translation>welche Voreinstellungen ausgemustert sind</translation>
    </message>
    <message>
        <source>table %1</source>
        <translation>Tabelle %1</translation>
    </message>
    <message>
        <source>trigger %1</source>
        <translation>Trigger %1</translation>
    </message>
    <message>
        <source>It is empty, longer than 64 characters, or has other characters than the letters a to z, digits and . _ - @.</source>
        <translation>Er ist leer, länger als 64 Zeichen oder enthält andere Zeichen als die Buchstaben a bis z, Ziffern und . _ - @.</translation>
    </message>
</context>
<context>
    <name>Block</name>
    <message>
        <source>Practice block: line</source>
        <translation>Übungsblock: Linie</translation>
    </message>
    <message>
        <source>Practice block: circle</source>
        <translation>Übungsblock: Kreis</translation>
    </message>
    <message>
        <source>Practice block: cross</source>
        <translation>Übungsblock: Kreuz</translation>
    </message>
    <message>
        <source>Practice block: square</source>
        <translation>Übungsblock: Quadrat</translation>
    </message>
    <message>
        <source>Practice block: dovetail</source>
        <translation>Übungsblock: Schwalbenschwanz</translation>
    </message>
    <message>
        <source>Practice block: staircase</source>
        <translation>Übungsblock: Treppe</translation>
    </message>
    <message>
        <source>Practice block: letter I</source>
        <translation>Übungsblock: Buchstabe I</translation>
    </message>
    <message>
        <source>Practice block: letter T</source>
        <translation>Übungsblock: Buchstabe T</translation>
    </message>
    <message>
        <source>Practice block: three layers</source>
        <translation>Übungsblock: drei Schichten</translation>
    </message>
    <message>
        <source>Practice block: depth plunges</source>
        <translation>Übungsblock: Tiefenbohrungen</translation>
    </message>
    <message>
        <source>Practice block: enamel and dentin</source>
        <translation>Übungsblock: Schmelz und Dentin</translation>
    </message>
</context>
<context>
    <name>Breach</name>
    <message>
        <source>The pulp is exposed</source>
        <translation>Die Pulpa ist eröffnet</translation>
    </message>
    <message>
        <source>The tooth is perforated</source>
        <translation>Der Zahn ist perforiert</translation>
    </message>
    <message>
        <source>Deeper than %1 mm</source>
        <translation>Tiefer als %1 mm</translation>
    </message>
    <message>
        <source>The marginal ridge is thinner than %1 mm</source>
        <translation>Die Randleiste ist dünner als %1 mm</translation>
    </message>
    <message>
        <source>Cut outside the target area</source>
        <translation>Außerhalb des Zielbereichs geschnitten</translation>
    </message>
    <message>
        <source>Pressed with %1 N; the limit is %2 N</source>
        <translation>Mit %1 N gedrückt; die Grenze ist %2 N</translation>
    </message>
    <message>
        <source>The bur ran without contact for %1 s</source>
        <translation>Der Bohrer lief %1 s lang ohne Kontakt</translation>
    </message>
    <message>
        <source>Cut with a bur that this lesson does not allow</source>
        <translation>Mit einem Bohrer geschnitten, den diese Lektion nicht erlaubt</translation>
    </message>
    <message>
        <source>An exposed pulp usually dies, because cut odontoblasts do not recover. Watch the section and leave half a millimetre of dentin.</source>
        <translation>Eine eröffnete Pulpa stirbt meist ab, denn durchtrennte Odontoblasten erholen sich nicht. Achten Sie auf den Schnitt und lassen Sie einen halben Millimeter Dentin stehen.</translation>
    </message>
    <message>
        <source>A perforated tooth is usually lost. Watch the depth in the section.</source>
        <translation>Ein durchbohrter Zahn ist meist verloren. Achten Sie im Schnitt auf die Tiefe.</translation>
    </message>
    <message>
        <source>Cutting deeper than necessary weakens the tooth and comes close to the pulp. The section shows how deep you are.</source>
        <translation>Tiefer zu schneiden als nötig schwächt den Zahn und kommt der Pulpa nahe. Der Schnitt zeigt, wie tief Sie sind.</translation>
    </message>
    <message>
        <source>A thin marginal ridge breaks under load. Stop the bur&apos;s outer edge earlier.</source>
        <translation>Eine dünne Randleiste bricht unter Last. Halten Sie mit der Außenkante des Bohrers früher an.</translation>
    </message>
    <message>
        <source>Sound tissue does not grow back. The dashed line in the section shows what to cut.</source>
        <translation>Gesundes Gewebe wächst nicht nach. Die gestrichelte Linie im Schnitt zeigt, was weg soll.</translation>
    </message>
    <message>
        <source>About 1 N cuts best; more heats the pulp, stalls the turbine and slips. Let the bur do the work.</source>
        <translation>Etwa 1 N schneidet am besten; mehr erhitzt die Pulpa, bremst die Turbine und rutscht ab. Lassen Sie den Bohrer arbeiten.</translation>
    </message>
    <message>
        <source>A running bur can injure lips and cheeks. Stop it when you are not cutting.</source>
        <translation>Ein laufender Bohrer kann Lippen und Wangen verletzen. Halten Sie ihn an, wenn Sie nicht schneiden.</translation>
    </message>
    <message>
        <source>The shape of the bur determines the shape of the cavity. Choose a bur that the lesson lists.</source>
        <translation>Die Form des Bohrers bestimmt die Form der Kavität. Nehmen Sie einen Bohrer, den die Lektion nennt.</translation>
    </message>
    <message>
        <source>The running bur touched the adjacent tooth</source>
        <translation>Der laufende Bohrer hat den Nachbarzahn berührt</translation>
    </message>
    <message>
        <source>A nick in the adjacent tooth collects plaque and decays. Stay inside the outline; N shows the adjacent teeth.</source>
        <translation>Eine Kerbe im Nachbarzahn hält Belag fest und wird kariös. Bleiben Sie im Umriss; N zeigt die Nachbarzähne.</translation>
    </message>
</context>
<context>
    <name>Bur</name>
    <message>
        <source>Round, No. %1</source>
        <translation>Rundbohrer, Nr. %1</translation>
    </message>
    <message>
        <source>Inverted cone, No. %1</source>
        <translation>Umgekehrter Kegel, Nr. %1</translation>
    </message>
    <message>
        <source>Straight fissure, No. %1</source>
        <translation>Zylindrisch, Nr. %1</translation>
    </message>
    <message>
        <source>Straight fissure, crosscut, No. %1</source>
        <translation>Zylindrisch mit Querhieb, Nr. %1</translation>
    </message>
    <message>
        <source>Domed fissure, crosscut, No. %1</source>
        <translation>Zylindrisch mit rundem Ende und Querhieb, Nr. %1</translation>
    </message>
    <message>
        <source>Tapered fissure, No. %1</source>
        <translation>Konisch, Nr. %1</translation>
    </message>
    <message>
        <source>Tapered fissure, crosscut, No. %1</source>
        <translation>Konisch mit Querhieb, Nr. %1</translation>
    </message>
    <message>
        <source>Pear, No. %1</source>
        <translation>Birnenförmig, Nr. %1</translation>
    </message>
    <message>
        <source>Long pear, No. %1</source>
        <translation>Lang birnenförmig, Nr. %1</translation>
    </message>
    <message>
        <source>Egg, No. %1</source>
        <translation>Eiförmig, Nr. %1</translation>
    </message>
    <message>
        <source>Flame, No. %1</source>
        <translation>Flammenförmig, Nr. %1</translation>
    </message>
    <message>
        <source>Cylinder, No. %1</source>
        <translation>Zylinder, Nr. %1</translation>
    </message>
    <message>
        <source>Round-end taper, No. %1</source>
        <translation>Konus mit rundem Ende, Nr. %1</translation>
    </message>
    <message>
        <source>Chamfer, No. %1</source>
        <translation>Torpedo, Nr. %1</translation>
    </message>
    <message>
        <source>Diamond, round, No. %1</source>
        <translation>Diamant, rund, Nr. %1</translation>
    </message>
    <message>
        <source>Diamond, pear, No. %1</source>
        <translation>Diamant, Birne, Nr. %1</translation>
    </message>
    <message>
        <source>Diamond, egg, No. %1</source>
        <translation>Diamant, Ei, Nr. %1</translation>
    </message>
    <message>
        <source>Diamond, flame, No. %1</source>
        <translation>Diamant, Flamme, Nr. %1</translation>
    </message>
    <message>
        <source>Diamond, cylinder, No. %1</source>
        <translation>Diamant, Zylinder, Nr. %1</translation>
    </message>
    <message>
        <source>Diamond, round-end taper, No. %1</source>
        <translation>Diamant, Konus mit rundem Ende, Nr. %1</translation>
    </message>
    <message>
        <source>Diamond, chamfer, No. %1</source>
        <translation>Diamant, Torpedo, Nr. %1</translation>
    </message>
    <message>
        <source>Diamond, No. %1</source>
        <translation>Diamant, Nr. %1</translation>
    </message>
</context>
<context>
    <name>Chart</name>
    <message numerus="yes">
        <source>and %n more</source>
        <extracomment>Bars of a chart that there is no room for</extracomment>
        <translation>
            <numerusform>und noch %n</numerusform>
            <numerusform>und noch %n</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Criterion</name>
    <message>
        <source>Enamel and dentin beside and below the decay. Tissue directly above the decay must be removed and is not counted.</source>
        <translation>Schmelz und Dentin neben und unter der Karies. Gewebe genau über der Karies muss abgetragen werden und zählt nicht.</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>%1 − %2 free</source>
        <extracomment>%1 is a value, %2 what of it costs nothing: &quot;3.20 − 1.00 free&quot;</extracomment>
        <translation>%1 − %2 frei</translation>
    </message>
    <message>
        <source>at least %1 %2</source>
        <translation>mindestens %1 %2</translation>
    </message>
    <message>
        <source>up to %1 %2</source>
        <translation>bis %1 %2</translation>
    </message>
    <message>
        <source>Not measured, so the attempt fails and the remaining %1 points are lost</source>
        <translation>Nicht gemessen, also nicht bestanden: Die übrigen %1 Punkte sind verloren</translation>
    </message>
    <message>
        <source>Not measured, so it earns none of its %1 points</source>
        <translation>Nicht gemessen, bringt also keinen seiner %1 Punkte</translation>
    </message>
    <message>
        <source>%1: nothing lost</source>
        <translation>%1: nichts verloren</translation>
    </message>
    <message>
        <source>Allowed: %1. The attempt fails and the remaining %2 points are lost</source>
        <extracomment>%1 is a range: &quot;up to 0.00 mm²&quot;</extracomment>
        <translation>Erlaubt: %1. Der Versuch ist nicht bestanden, und die übrigen %2 Punkte sind verloren</translation>
    </message>
    <message>
        <source>%1 %2 outside the limit; a more serious error decides</source>
        <translation>%1 %2 außerhalb der Grenze; ein schwererer Fehler entscheidet</translation>
    </message>
    <message>
        <source>%1; beyond it all of its %2 points are lost</source>
        <translation>%1; darüber sind alle %2 Punkte verloren</translation>
    </message>
    <message>
        <source>(%1) / %2 %3 × %4 points</source>
        <translation>(%1) / %2 %3 × %4 Punkte</translation>
    </message>
    <message>
        <source>%1, at most all of them</source>
        <translation>%1, höchstens alle</translation>
    </message>
    <message>
        <source>%1 has reached %2</source>
        <extracomment>%1: the name of a measure, %2: a figure with its unit</extracomment>
        <translation>%1 den Wert %2 erreicht</translation>
    </message>
    <message>
        <source>None of its %1 points are earned before %2</source>
        <extracomment>%1: points of a score, %2: what has to be done: &quot;50 % of the decay is removed&quot;</extracomment>
        <translation>Keiner der %1 Punkte zählt, bevor %2</translation>
    </message>
    <message>
        <source>%1 of the decay is removed</source>
        <extracomment>%1: a share: &quot;50 %&quot;</extracomment>
        <translation>%1 der Karies entfernt sind</translation>
    </message>
    <message>
        <source>%1 of the ideal is cut</source>
        <translation>%1 des Ideals geschnitten sind</translation>
    </message>
    <message>
        <source>%1 of the shape is cut</source>
        <translation>%1 der Form geschnitten sind</translation>
    </message>
    <message>
        <source>The measured value was not saved</source>
        <translation>Der gemessene Wert wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>Counts as soon as %1</source>
        <extracomment>%1: what has to be done: &quot;50 % of the decay is removed&quot;</extracomment>
        <translation>Zählt, sobald %1</translation>
    </message>
    <message>
        <source>Not measured, so the score is limited to %1 points</source>
        <extracomment>%1: points of a score</extracomment>
        <translation>Nicht gemessen, daher ist die Punktzahl auf %1 begrenzt</translation>
    </message>
    <message>
        <source>Allowed: %1. The score is limited to %2 points</source>
        <extracomment>%1 is a range: &quot;up to 0.00 mm²&quot;; %2: points of a score</extracomment>
        <translation>Erlaubt: %1. Die Punktzahl ist auf %2 begrenzt</translation>
    </message>
    <message>
        <source>%1 of the tooth is removed</source>
        <translation>%1 des Zahns entfernt sind</translation>
    </message>
</context>
<context>
    <name>Direction</name>
    <message>
        <source>distal</source>
        <translation>distal</translation>
    </message>
    <message>
        <source>mesial</source>
        <translation>mesial</translation>
    </message>
    <message>
        <source>labial</source>
        <translation>labial</translation>
    </message>
    <message>
        <source>buccal</source>
        <translation>bukkal</translation>
    </message>
    <message>
        <source>palatal</source>
        <translation>palatinal</translation>
    </message>
    <message>
        <source>lingual</source>
        <translation>lingual</translation>
    </message>
    <message>
        <source>distolabial</source>
        <translation>distolabial</translation>
    </message>
    <message>
        <source>distobuccal</source>
        <translation>distobukkal</translation>
    </message>
    <message>
        <source>distopalatal</source>
        <translation>distopalatinal</translation>
    </message>
    <message>
        <source>distolingual</source>
        <translation>distolingual</translation>
    </message>
    <message>
        <source>mesiolabial</source>
        <translation>mesiolabial</translation>
    </message>
    <message>
        <source>mesiobuccal</source>
        <translation>mesiobukkal</translation>
    </message>
    <message>
        <source>mesiopalatal</source>
        <translation>mesiopalatinal</translation>
    </message>
    <message>
        <source>mesiolingual</source>
        <translation>mesiolingual</translation>
    </message>
    <message>
        <source>Mesio-distal</source>
        <translation>Mesiodistal</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>Entlang x</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>Entlang y</translation>
    </message>
    <message>
        <source>Labio-palatal</source>
        <translation>Labiopalatinal</translation>
    </message>
    <message>
        <source>Labio-lingual</source>
        <translation>Labiolingual</translation>
    </message>
    <message>
        <source>Bucco-palatal</source>
        <translation>Bukkopalatinal</translation>
    </message>
    <message>
        <source>Bucco-lingual</source>
        <translation>Bukkolingual</translation>
    </message>
    <message>
        <source>apical</source>
        <translation>apikal</translation>
    </message>
    <message>
        <source>incisal</source>
        <translation>inzisal</translation>
    </message>
    <message>
        <source>occlusal</source>
        <translation>okklusal</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <extracomment>Two directions at once, such as &quot;mesial / incisal&quot;</extracomment>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>The file is not there. Was it moved or renamed?</source>
        <translation>Die Datei ist nicht da. Wurde sie verschoben oder umbenannt?</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that it is a file and that you may open it.</source>
        <translation>Die Datei lässt sich nicht lesen. Ist es eine Datei, und dürfen Sie sie öffnen?</translation>
    </message>
    <message>
        <source>The file cannot be written. Choose another folder, or make room on the disk.</source>
        <translation>Die Datei lässt sich nicht schreiben. Wählen Sie einen anderen Ordner oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>A newer Cusp wrote this file. Update Cusp to open it.</source>
        <translation>Diese Datei stammt von einem neueren Cusp. Aktualisieren Sie Cusp, um sie zu öffnen.</translation>
    </message>
    <message>
        <source>There is no surface in this file. Choose a scan of a tooth.</source>
        <translation>In dieser Datei ist keine Oberfläche. Wählen Sie den Scan eines Zahns.</translation>
    </message>
    <message>
        <source>Cusp does not know what is asked for by this name.</source>
        <translation>Cusp kennt nichts unter diesem Namen.</translation>
    </message>
    <message>
        <source>A value lies outside what Cusp can work with.</source>
        <translation>Ein Wert liegt außerhalb dessen, womit Cusp arbeiten kann.</translation>
    </message>
    <message>
        <source>It was made on another tooth, or with another decay, than this lesson&apos;s. Ask who made the lesson.</source>
        <translation>Sie entstand an einem anderen Zahn als dem dieser Lektion oder an einem mit anderer Karies. Fragen Sie, wer die Lektion erstellt hat.</translation>
    </message>
    <message>
        <source>Export it again, or choose another scan.</source>
        <translation>Exportieren Sie sie noch einmal oder wählen Sie einen anderen Scan.</translation>
    </message>
    <message>
        <source>Copy it again from where it was made, or choose another one.</source>
        <translation>Kopieren Sie sie noch einmal von dort, wo sie entstanden ist, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>Put a copy of it back, or move it away: Cusp then begins a new one.</source>
        <translation>Spielen Sie eine Sicherungskopie zurück oder verschieben Sie die Datei; Cusp legt dann eine neue an.</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The file is no recording of Cusp.</source>
        <translation>Die Datei ist keine Aufzeichnung von Cusp.</translation>
    </message>
    <message>
        <source>The file is no database of Cusp.</source>
        <translation>Die Datei ist keine Datenbank von Cusp.</translation>
    </message>
    <message>
        <source>The file is not what its name says. Scans are OBJ, STL or PLY.</source>
        <translation>Die Datei ist nicht das, was ihr Name sagt. Scans sind OBJ, STL oder PLY.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Die Datei ist leer.</translation>
    </message>
    <message>
        <source>The file ends too early.</source>
        <translation>Die Datei endet zu früh.</translation>
    </message>
    <message>
        <source>The file is too large. Export it with fewer triangles.</source>
        <translation>Die Datei ist zu groß. Exportieren Sie sie mit weniger Dreiecken.</translation>
    </message>
    <message>
        <source>The file is too large.</source>
        <translation>Die Datei ist zu groß.</translation>
    </message>
    <message>
        <source>Where a number belongs, the file holds something else.</source>
        <translation>Wo eine Zahl hingehört, steht in der Datei etwas anderes.</translation>
    </message>
    <message>
        <source>The content of the file does not fit together.</source>
        <translation>Der Inhalt der Datei passt nicht zusammen.</translation>
    </message>
    <message>
        <source>The scan cannot be opened. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Der Scan lässt sich nicht öffnen. %1</translation>
    </message>
    <message>
        <source>The tooth cannot be created. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Der Zahn lässt sich nicht erzeugen. %1</translation>
    </message>
    <message>
        <source>The recording cannot be played. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Die Aufzeichnung lässt sich nicht wiedergeben. %1</translation>
    </message>
    <message>
        <source>The recording was not saved. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Die Aufzeichnung wurde nicht gespeichert. %1</translation>
    </message>
    <message>
        <source>Grades will not be saved; drilling and grading still work. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Bewertungen werden nicht gespeichert; präparieren und bewerten lassen können Sie trotzdem. %1</translation>
    </message>
    <message>
        <source>Its file is kept for seven days, in the folder &quot;discarded&quot;.</source>
        <translation>Die Datei bleibt sieben Tage im Ordner „discarded“ liegen.</translation>
    </message>
    <message>
        <source>Ask who made the lesson, or choose another one.</source>
        <translation>Fragen Sie, wer die Lektion gemacht hat, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>This Cusp did not write the file, or an older one did.</source>
        <translation>Die Datei stammt nicht von diesem Cusp oder von einem älteren.</translation>
    </message>
    <message>
        <source>The lesson cannot be started; your work is unchanged. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Die Lektion lässt sich nicht beginnen; Ihre Arbeit ist unverändert. %1</translation>
    </message>
    <message>
        <source>The work cannot be graded; it is unchanged. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Die Arbeit kann nicht bewertet werden; sie ist unverändert. %1</translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work: if the computer fails, it is lost. Make room on the disk, or save the recording now and then.</source>
        <translation>Dieser Versuch wird während der Arbeit nicht auf der Festplatte gesichert: Fällt der Computer aus, ist er verloren. Schaffen Sie Platz auf der Festplatte oder speichern Sie ab und zu die Aufzeichnung.</translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Dieser Versuch wird während der Arbeit nicht auf der Festplatte gesichert. %1</translation>
    </message>
    <message>
        <source>An unfinished attempt cannot be resumed. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Ein unvollendeter Versuch kann nicht fortgesetzt werden. %1</translation>
    </message>
    <message>
        <source>Nothing has been cut yet that could be a reference.</source>
        <translation>Es wurde noch nichts präpariert, das eine Referenz sein könnte.</translation>
    </message>
    <message>
        <source>The reference was not saved. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Die Referenz wurde nicht gespeichert. %1</translation>
    </message>
    <message>
        <source>Another program is writing to the school&apos;s database. Try again in a moment.</source>
        <translation>Ein anderes Programm schreibt gerade in die Datenbank der Schule. Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Cusp tries again by itself.</source>
        <translation>Der Server der Schule antwortet nicht. Cusp versucht es von selbst wieder.</translation>
    </message>
    <message>
        <source>Your role does not allow it.</source>
        <translation>Ihre Rolle erlaubt das nicht.</translation>
    </message>
    <message>
        <source>Wrong username or password.</source>
        <translation>Benutzername oder Passwort ist falsch.</translation>
    </message>
    <message>
        <source>Too many logins have failed. Wait a moment and try again.</source>
        <translation>Zu viele Anmeldungen sind fehlgeschlagen. Warten Sie einen Moment und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Choose a password first.</source>
        <translation>Wählen Sie zuerst ein Passwort.</translation>
    </message>
    <message>
        <source>The school&apos;s data cannot be shown now; your work is saved. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Die Daten der Schule lassen sich gerade nicht anzeigen; Ihre Arbeit wird gespeichert. %1</translation>
    </message>
    <message>
        <source>The school&apos;s file cannot be written. Make room on the disk, or make its folder writable.</source>
        <translation>Die Datei der Schule kann nicht geschrieben werden. Schaffen Sie Platz auf dem Datenträger oder machen Sie ihren Ordner beschreibbar.</translation>
    </message>
    <message>
        <source>An older Cusp made this school. Ask its administrator to run “cusp db migrate”.</source>
        <translation>Diese Schule hat ein älteres Cusp angelegt. Bitten Sie ihren Administrator, „cusp db migrate“ auszuführen.</translation>
    </message>
    <message>
        <source>That was not done, and nothing was changed. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Das wurde nicht ausgeführt, und nichts wurde geändert. %1</translation>
    </message>
    <message>
        <source>An attempt that was to be sent to the school is damaged. It was moved to the folder “outbox/damaged”. Everything else is saved as usual.</source>
        <translation>Ein Versuch, der an die Schule gesendet werden sollte, ist beschädigt. Er wurde in den Ordner „outbox/damaged“ verschoben. Alles andere wird wie gewohnt gespeichert.</translation>
    </message>
    <message>
        <source>Somebody else has changed it meanwhile. Here is what there is now; change it again if need be.</source>
        <translation>Jemand anderes hat das inzwischen geändert. Hier steht, was jetzt gilt; ändern Sie es bei Bedarf noch einmal.</translation>
    </message>
    <message>
        <source>This is the last admin who can log in. Make somebody else an admin first.</source>
        <translation>Das ist der letzte Admin, der sich anmelden kann. Machen Sie zuerst jemand anderen zum Admin.</translation>
    </message>
    <message>
        <source>This account was disabled. Ask an admin.</source>
        <translation>Dieses Konto wurde gesperrt. Fragen Sie die Verwaltung.</translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Try it again when the server answers.</source>
        <translation>Der Server der Schule antwortet nicht. Versuchen Sie es noch einmal, wenn er wieder antwortet.</translation>
    </message>
    <message>
        <source>This grade is not saved yet; Cusp tries again while it runs. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Diese Bewertung ist noch nicht gespeichert; Cusp versucht es wieder, solange es läuft. %1</translation>
    </message>
    <message>
        <source>The folder “outbox”, where grades wait for the school, cannot be written. Make room on the disk, or make that folder writable.</source>
        <translation>In den Ordner „outbox“, in dem Noten auf die Schule warten, kann nicht geschrieben werden. Schaffen Sie Platz auf dem Datenträger oder erlauben Sie das Schreiben in diesen Ordner.</translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work: if the computer fails, it is lost. Go on, and have room made on the disk.</source>
        <translation>Dieser Versuch wird während der Arbeit nicht auf dem Datenträger aufbewahrt: Fällt der Computer aus, ist er verloren. Arbeiten Sie weiter und lassen Sie Platz schaffen.</translation>
    </message>
    <message>
        <source>The school&apos;s data lie on a network drive, and another Cusp, here or at another computer, has them open. Only one at a time can: close that one. For several computers an admin keeps them on a PostgreSQL server.</source>
        <translation>Die Daten der Schule liegen auf einem Netzlaufwerk, und ein anderes Cusp, hier oder an einem anderen Computer, hat sie geöffnet. Nur eines kann das zur gleichen Zeit: Schließen Sie jenes. Für mehrere Computer legt ein Admin sie auf einen PostgreSQL-Server.</translation>
    </message>
    <message>
        <source>The school&apos;s server says no. Ask whoever looks after it: its log, or “cusp db check”, says why.</source>
        <translation>Der Server der Schule lehnt es ab. Fragen Sie bei seiner Betreuung nach: Sein Protokoll oder „cusp db check“ nennt den Grund.</translation>
    </message>
    <message>
        <source>The school&apos;s server cannot prove that it is the right one, or cannot encrypt the connection, so nothing is sent to it. Ask whoever looks after it to set up its certificate.</source>
        <translation>Der Server der Schule kann nicht beweisen, dass er der richtige ist, oder die Verbindung nicht verschlüsseln. Deshalb wird nichts an ihn gesendet. Bitten Sie die Person, die ihn betreut, sein Zertifikat einzurichten.</translation>
    </message>
    <message>
        <source>Your login has ended, or another school is now where yours was. Log in again.</source>
        <translation>Ihre Anmeldung wurde beendet, oder wo Ihre Schule war, ist jetzt eine andere. Melden Sie sich neu an.</translation>
    </message>
    <message>
        <source>The school&apos;s server went away while this was being done, and nobody can say whether it was. Look when it answers again, before you do it again.</source>
        <translation>Der Server der Schule war weg, während das ausgeführt wurde, und niemand kann sagen, ob es geschah. Sehen Sie nach, wenn er wieder antwortet, bevor Sie es noch einmal tun.</translation>
    </message>
    <message>
        <source>Nothing was written: what stands on it is read anew for it. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Nichts wurde geschrieben: Was darauf steht, wird dafür neu gelesen. %1</translation>
    </message>
</context>
<context>
    <name>ExamWords</name>
    <message>
        <source>undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>expert&apos;s attempt</source>
        <translation>Versuch des Experten</translation>
    </message>
    <message>
        <source>earlier attempts</source>
        <translation>frühere Versuche</translation>
    </message>
    <message>
        <source>Time: %1</source>
        <extracomment>%1: &quot;8 min&quot;, or that there is no limit</extracomment>
        <translation>Zeit: %1</translation>
    </message>
    <message>
        <source>Attempts: %1</source>
        <extracomment>%1: &quot;2 attempts left, 1 graded so far&quot;</extracomment>
        <translation>Versuche: %1</translation>
    </message>
    <message>
        <source>Passed from: %1 of 100 points</source>
        <extracomment>%1: points</extracomment>
        <translation>Bestanden ab: %1 von 100 Punkten</translation>
    </message>
    <message>
        <source>Locked: %1</source>
        <extracomment>%1: a list</extracomment>
        <translation>Gesperrt: %1</translation>
    </message>
    <message>
        <source>The clock starts when you begin, and also runs while you are on another page. Faults are shown after the grade.</source>
        <translation>Die Uhr läuft, sobald Sie beginnen, auch während Sie auf einer anderen Seite sind. Fehler werden nach der Bewertung gezeigt.</translation>
    </message>
    <message>
        <source>&amp;Begin exam</source>
        <translation>Prüfung &amp;beginnen</translation>
    </message>
</context>
<context>
    <name>ExerciseMarks</name>
    <message>
        <source>height, mm</source>
        <extracomment>Title of a scale: how high the bur&apos;s tip stands over the block</extracomment>
        <translation>Höhe, mm</translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>&quot;%1&quot; has changed since the lesson was read; open the page again.</source>
        <translation>„%1“ hat sich geändert, seit die Lektion gelesen wurde; öffnen Sie die Seite noch einmal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read, or has more than %2 MB, which a lesson may take along; use a coarser scan.</source>
        <translation>„%1“ kann nicht gelesen werden oder hat mehr als die %2 MB, die eine Lektion mitnehmen darf; nehmen Sie einen gröberen Scan.</translation>
    </message>
    <message>
        <source>The version that was assigned is not on this computer yet. Open this page again when the database can be reached.</source>
        <translation>Die aufgegebene Fassung ist noch nicht auf diesem Computer. Öffnen Sie diese Seite noch einmal, wenn die Datenbank erreichbar ist.</translation>
    </message>
    <message>
        <source>The version that was assigned cannot be read by this version of Cusp. Ask who keeps Cusp to update it.</source>
        <translation>Dieses Cusp kann die aufgegebene Fassung nicht lesen. Bitten Sie, wer Cusp hier betreut, es zu aktualisieren.</translation>
    </message>
    <message>
        <source>touch.points[%1]: there is no tooth at x = %2, y = %3 mm</source>
        <translation>touch.points[%1]: Bei x = %2, y = %3 mm ist kein Zahn</translation>
    </message>
    <message>
        <source>has %1; a lesson has at most %2</source>
        <translation>hat %1; eine Lektion hat höchstens %2</translation>
    </message>
    <message>
        <source>unterminated object</source>
        <translation>ein Objekt ist nicht geschlossen</translation>
    </message>
    <message>
        <source>missing name separator</source>
        <translation>hinter einem Schlüssel fehlt der Doppelpunkt</translation>
    </message>
    <message>
        <source>unterminated array</source>
        <translation>eine Liste ist nicht geschlossen</translation>
    </message>
    <message>
        <source>missing value separator</source>
        <translation>zwischen zwei Werten fehlt das Komma</translation>
    </message>
    <message>
        <source>invalid termination by number</source>
        <translation>hinter der letzten Zahl fehlt etwas</translation>
    </message>
    <message>
        <source>illegal number</source>
        <translation>keine gültige Zahl</translation>
    </message>
    <message>
        <source>invalid escape sequence</source>
        <translation>ein ungültiges Zeichen hinter einem \</translation>
    </message>
    <message>
        <source>unterminated string</source>
        <translation>ein Text ist nicht geschlossen</translation>
    </message>
    <message>
        <source>object is missing after a comma</source>
        <translation>nach einem Komma fehlt etwas</translation>
    </message>
    <message>
        <source>too deeply nested document</source>
        <translation>zu tief verschachtelt</translation>
    </message>
    <message>
        <source>too large document</source>
        <translation>zu groß</translation>
    </message>
    <message>
        <source>garbage at the end of the document</source>
        <translation>am Ende steht noch etwas</translation>
    </message>
    <message>
        <source>illegal value</source>
        <translation>kein gültiger Wert</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Byte</translation>
    </message>
    <message>
        <source>is %1, from a newer Cusp; this one reads %2. Update Cusp to give this lesson</source>
        <translation>ist %1, von einem neueren Cusp; dieses liest %2. Aktualisieren Sie Cusp, um diese Lektion zu geben</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is written in UTF-16 or UTF-32; save it as UTF-8</source>
        <translation>ist in UTF-16 oder UTF-32 geschrieben; speichern Sie es als UTF-8</translation>
    </message>
    <message>
        <source>is not JSON: line %1, column %2: invalid UTF8 string; save the file as UTF-8</source>
        <translation>ist kein JSON: Zeile %1, Spalte %2: ein Text ist kein UTF-8; speichern Sie die Datei als UTF-8</translation>
    </message>
    <message>
        <source>is not JSON: line %1, column %2: %3</source>
        <translation>ist kein JSON: Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>must be one JSON object in braces</source>
        <translation>muss ein JSON-Objekt in geschweiften Klammern sein</translation>
    </message>
    <message>
        <source>is said twice in one object; leave one out</source>
        <translation>steht zweimal in einem Objekt; lassen Sie eines weg</translation>
    </message>
    <message>
        <source>&quot;%1&quot; leads out of the lesson&apos;s folder; name a file beside it</source>
        <translation>„%1“ führt aus dem Ordner der Lektion hinaus; nennen Sie eine Datei daneben</translation>
    </message>
    <message>
        <source>is based on itself by way of %1</source>
        <translation>beruht über %1 auf sich selbst</translation>
    </message>
    <message>
        <source>more than %1 files are based on one another</source>
        <translation>beruht auf mehr als %1 Dateien hintereinander</translation>
    </message>
    <message>
        <source>must be the name of a file beside this one, or of one that is shipped</source>
        <translation>muss der Name einer Datei daneben oder einer mitgelieferten sein</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>gibt es nicht</translation>
    </message>
    <message>
        <source>cannot be read (it is a folder)</source>
        <translation>kann nicht gelesen werden (es ist ein Ordner)</translation>
    </message>
    <message>
        <source>cannot be read (it is no file)</source>
        <translation>kann nicht gelesen werden (es ist keine Datei)</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>null</source>
        <translation>null</translation>
    </message>
    <message>
        <source>is %1; write a number of %2 without its unit</source>
        <translation>ist %1; schreiben Sie eine Zahl ohne ihre Einheit (%2)</translation>
    </message>
    <message>
        <source>is %1; write a number</source>
        <translation>ist %1; schreiben Sie eine Zahl</translation>
    </message>
    <message>
        <source>is %1, it must lie between %2 and %3 %4</source>
        <translation>ist %1, muss aber zwischen %2 und %3 %4 liegen</translation>
    </message>
    <message>
        <source>is %1, it must lie between %2 and %3</source>
        <translation>ist %1, muss aber zwischen %2 und %3 liegen</translation>
    </message>
    <message>
        <source>is %1, it must be a whole number</source>
        <translation>ist %1, muss aber eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>is %1; write true or false</source>
        <translation>ist %1; schreiben Sie true oder false</translation>
    </message>
    <message>
        <source>is %1; write a text in quotes</source>
        <translation>ist %1; schreiben Sie einen Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>has %1 characters; at most %2 are read</source>
        <translation>hat %1 Zeichen; gelesen werden höchstens %2</translation>
    </message>
    <message>
        <source>holds the character U+%1, which cannot be seen; leave it out</source>
        <translation>enthält das unsichtbare Zeichen U+%1; lassen Sie es weg</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>has %1 characters; it takes 1 to %2</source>
        <translation>hat %1 Zeichen; es braucht 1 bis %2</translation>
    </message>
    <message>
        <source>is %1; write {&quot;en&quot;: &quot;...&quot;, &quot;de&quot;: &quot;...&quot;}</source>
        <translation>ist %1; schreiben Sie {&quot;en&quot;: &quot;...&quot;, &quot;de&quot;: &quot;...&quot;}</translation>
    </message>
    <message>
        <source>has texts in %1 languages; it takes 1 to %2</source>
        <translation>hat Texte in %1 Sprachen; es braucht 1 bis %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be the code of a language (en, de, es, ja) with a text</source>
        <translation>„%1“ muss das Kürzel einer Sprache (en, de, es, ja) mit einem Text sein</translation>
    </message>
    <message>
        <source>must be a list of at most %1 texts: [&quot;...&quot;, &quot;...&quot;]</source>
        <translation>muss eine Liste von höchstens %1 Texten sein: [&quot;...&quot;, &quot;...&quot;]</translation>
    </message>
    <message>
        <source>is %1; write an object in braces</source>
        <translation>ist %1; schreiben Sie ein Objekt in geschweiften Klammern</translation>
    </message>
    <message>
        <source>must be a list of at most %1 objects</source>
        <translation>muss eine Liste von höchstens %1 Objekten sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known; there are %2</source>
        <translation>„%1“ ist unbekannt; es gibt %2</translation>
    </message>
    <message>
        <source>must be a list of 1 to %1 places: [[x, y], ...]</source>
        <translation>muss eine Liste von 1 bis %1 Stellen sein: [[x, y], ...]</translation>
    </message>
    <message>
        <source>must be [x, y], two numbers between %1 and %2 mm</source>
        <translation>muss [x, y] sein, zwei Zahlen zwischen %1 und %2 mm</translation>
    </message>
    <message>
        <source>is not a key that is known here, so it is left out</source>
        <translation>ist hier kein bekannter Schlüssel und wird weggelassen</translation>
    </message>
    <message>
        <source>is not a key that is known here; did you mean &quot;%1&quot;?</source>
        <translation>ist hier kein bekannter Schlüssel; ist „%1“ gemeint?</translation>
    </message>
    <message>
        <source>%1 (in the pack %2)</source>
        <translation>%1 (im Paket %2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to another lesson; give this one an id of its own</source>
        <translation>„%1“ gehört einer anderen Lektion; geben Sie dieser eine eigene id</translation>
    </message>
    <message>
        <source>is missing; write &quot;format&quot;: %1</source>
        <translation>fehlt; schreiben Sie &quot;format&quot;: %1</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; beside the lesson</source>
        <translation>neben der Lektion gibt es keine Datei „%1“</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read</source>
        <translation>„%1“ kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>is missing; there are %1</source>
        <translation>fehlt; es gibt %1</translation>
    </message>
    <message>
        <source>has %1 with all that it names; a recording takes at most %2 along. Shorten its texts</source>
        <translation>hat mit allem, was sie nennt, %1; eine Aufzeichnung nimmt höchstens %2 mit. Kürzen Sie ihre Texte</translation>
    </message>
    <message>
        <source>is missing; write {&quot;fdi&quot;: 36}, {&quot;block&quot;: &quot;line&quot;} or {&quot;scan&quot;: &quot;tooth.stl&quot;}</source>
        <translation>fehlt; schreiben Sie {&quot;fdi&quot;: 36}, {&quot;block&quot;: &quot;line&quot;} oder {&quot;scan&quot;: &quot;tooth.stl&quot;}</translation>
    </message>
    <message>
        <source>must name one of &quot;fdi&quot;, &quot;block&quot; and &quot;scan&quot;</source>
        <translation>muss genau eines von „fdi“, „block“ und „scan“ nennen</translation>
    </message>
    <message>
        <source>there is no tooth %1 here; those of the left are made: 21 to 28 and 31 to 38</source>
        <translation>Zahn %1 gibt es hier nicht; es gibt die linken: 21 bis 28 und 31 bis 38</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no unit; write mm, cm, m, in or the millimetres of one unit</source>
        <translation>„%1“ ist keine Einheit; schreiben Sie mm, cm, m, in oder die Millimeter einer Einheit</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no direction; write +x, -x, +y, -y, +z, -z, or three numbers such as 1,0,1</source>
        <translation>„%1“ ist keine Richtung; schreiben Sie +x, -x, +y, -y, +z, -z oder drei Zahlen wie 1,0,1</translation>
    </message>
    <message>
        <source>an ideal is captured, or has a kind and sizes; leave one out (where the lesson is based on another, with &quot;kind&quot;: null, &quot;sizes&quot;: null)</source>
        <translation>ein Ideal ist abgenommen, oder es hat kind und sizes; lassen Sie eines weg (wenn die Lektion auf einer anderen beruht: mit &quot;kind&quot;: null, &quot;sizes&quot;: null)</translation>
    </message>
    <message>
        <source>is missing; name the preparation, or a file &quot;captured&quot;</source>
        <translation>fehlt; nennen Sie die Präparation oder eine Datei „captured“</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2; a lesson takes at most %3. Capture it on a coarser grid</source>
        <translation>„%1“ hat %2; eine Lektion nimmt höchstens %3. Nehmen Sie es auf einem gröberen Gitter ab</translation>
    </message>
    <message>
        <source>has its own caries and plastic; leave it out, or leave out &quot;caries&quot; and &quot;plastic&quot;</source>
        <translation>hat eigene Werte für Karies und Kunststoff; lassen Sie es weg, oder lassen Sie „caries“ und „plastic“ weg</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no aid; there are section, depth_gauge, radiograph, heat_map, mirror, ideal, bur_colour, fixture, depth_stop</source>
        <translation>„%1“ ist keine Hilfe; es gibt section, depth_gauge, radiograph, heat_map, mirror, ideal, bur_colour, fixture, depth_stop</translation>
    </message>
    <message>
        <source>only a tooth of ours has neighbours; write false</source>
        <translation>nur ein Zahn von Cusp hat Nachbarn; schreiben Sie false</translation>
    </message>
    <message>
        <source>to remove decay there must be some: write &quot;lesion&quot;: {&quot;extent&quot;: 0.5} for a tooth</source>
        <translation>um Karies zu entfernen, muss welche da sein: Schreiben Sie &quot;lesion&quot;: {&quot;extent&quot;: 0.5} für einen Zahn</translation>
    </message>
    <message>
        <source>is missing; it says which preparation is to be cut</source>
        <translation>fehlt; es sagt, welche Präparation gefragt ist</translation>
    </message>
    <message>
        <source>a shape is traced in a block: write {&quot;block&quot;: &quot;line&quot;}</source>
        <translation>eine Form wird in einem Block nachgefahren: Schreiben Sie {&quot;block&quot;: &quot;line&quot;}</translation>
    </message>
    <message>
        <source>is missing; it says which points are to be touched: {&quot;points&quot;: [[x, y], ...]}</source>
        <translation>fehlt; es sagt, welche Punkte zu berühren sind: {&quot;points&quot;: [[x, y], ...]}</translation>
    </message>
    <message>
        <source>is missing; it says which force is to be held: {&quot;force_n&quot;: 1}</source>
        <translation>fehlt; es sagt, welche Kraft zu halten ist: {&quot;force_n&quot;: 1}</translation>
    </message>
    <message>
        <source>layers are told apart in a block of them: write {&quot;block&quot;: &quot;layers&quot;}</source>
        <translation>Schichten werden in einem Block aus Schichten unterschieden: Schreiben Sie {&quot;block&quot;: &quot;layers&quot;}</translation>
    </message>
    <message>
        <source>layers are told apart without any; leave the key out</source>
        <translation>Schichten werden ohne Hilfen unterschieden; lassen Sie den Schlüssel weg</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was captured on the tooth &apos;%2&apos; (seed %3, grid %4); name that tooth, seed and grid, or capture it on this one</source>
        <translation>„%1“ wurde am Zahn „%2“ (seed %3, grid %4) abgenommen; nennen Sie jenen Zahn mit seed und grid, oder nehmen Sie es an diesem ab</translation>
    </message>
    <message>
        <source>is made by rule for a tooth of ours only, &quot;tooth&quot;: {&quot;fdi&quot;: 36}; for a scan name a captured one: {&quot;captured&quot;: &quot;mine.cuspideal&quot;}</source>
        <translation>entsteht nach Regeln nur für einen Zahn von Cusp, &quot;tooth&quot;: {&quot;fdi&quot;: 36}; für einen Scan nennen Sie ein abgenommenes: {&quot;captured&quot;: &quot;mine.cuspideal&quot;}</translation>
    </message>
    <message>
        <source>%1 cannot be read; check its name and rights.</source>
        <translation>%1 kann nicht gelesen werden; prüfen Sie Name und Rechte.</translation>
    </message>
    <message>
        <source>%1 has %2, and a pack takes %3 in all; pack fewer lessons, or coarser scans.</source>
        <translation>%1 hat %2, und ein Paket fasst insgesamt %3; packen Sie weniger Lektionen oder gröbere Scans ein.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made; name another.</source>
        <translation>Der Ordner %1 lässt sich nicht anlegen; nennen Sie einen anderen.</translation>
    </message>
    <message>
        <source>The pack names a file &quot;%1&quot;, which leads out of its folder or is of no kind that lessons have; nothing was unpacked.</source>
        <translation>Das Paket nennt eine Datei „%1“, die aus seinem Ordner hinausführt oder von keiner Art ist, die Lektionen haben; nichts wurde ausgepackt.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; in the pack is not what its hash says: it was damaged or changed; nothing was unpacked. Ask for the pack again.</source>
        <translation>Die Datei „%1“ im Paket ist nicht, was ihre Prüfsumme sagt: Sie wurde beschädigt oder verändert; nichts wurde ausgepackt. Lassen Sie sich das Paket neu geben.</translation>
    </message>
    <message>
        <source>This is no pack of lessons, it is damaged, or it holds more than %1; choose a file that &quot;cusp lesson pack&quot; has made.</source>
        <translation>Das ist kein Paket von Lektionen, es ist beschädigt, oder es enthält mehr als %1; wählen Sie eine Datei, die „cusp lesson pack“ gemacht hat.</translation>
    </message>
    <message>
        <source>This is no pack of lessons; choose a file that &quot;cusp lesson pack&quot; has made.</source>
        <translation>Das ist kein Paket von Lektionen; wählen Sie eine Datei, die „cusp lesson pack“ gemacht hat.</translation>
    </message>
    <message>
        <source>The pack is of format %1, from a newer Cusp; this one reads %2. Update Cusp.</source>
        <translation>Das Paket hat das Format %1, von einem neueren Cusp; dieses liest %2. Aktualisieren Sie Cusp.</translation>
    </message>
    <message>
        <source>The pack lists %1 files; it may hold 1 to %2.</source>
        <translation>Das Paket nennt %1 Dateien; es darf 1 bis %2 enthalten.</translation>
    </message>
    <message>
        <source>The pack holds &quot;%1&quot; twice; nothing was unpacked.</source>
        <translation>Das Paket enthält „%1“ zweimal; nichts wurde ausgepackt.</translation>
    </message>
    <message>
        <source>%1 is a link to elsewhere; nothing was unpacked. Name another folder.</source>
        <translation>%1 ist eine Verknüpfung anderswohin; nichts wurde ausgepackt. Nennen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>There is another file &quot;%1&quot; in %2 already; nothing was unpacked. Move it away, or name another folder.</source>
        <translation>In %2 gibt es schon eine andere Datei „%1“; nichts wurde ausgepackt. Verschieben Sie sie, oder nennen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be written.</source>
        <translation>In den Ordner %1 kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>has %1; a hardness preset has at most %2</source>
        <translation>hat %1; eine Härte-Voreinstellung hat höchstens %2</translation>
    </message>
    <message>
        <source>is %1, from a newer Cusp; this one reads %2. Update Cusp to use it</source>
        <translation>ist %1, von einem neueren Cusp; dieses liest %2. Aktualisieren Sie Cusp, um die Datei zu verwenden</translation>
    </message>
    <message>
        <source>says that this is no hardness preset; choose a file that Cusp has exported</source>
        <translation>sagt, dass dies keine Härte-Voreinstellung ist; wählen Sie eine Datei, die Cusp exportiert hat</translation>
    </message>
    <message>
        <source>must be one line of 1 to %1 characters</source>
        <translation>muss eine Zeile von 1 bis %1 Zeichen sein</translation>
    </message>
    <message>
        <source>is not there; check the name</source>
        <translation>ist nicht da; prüfen Sie den Namen</translation>
    </message>
    <message>
        <source>cannot be read; name a file that you may read</source>
        <translation>kann nicht gelesen werden; nennen Sie eine Datei, die Sie lesen dürfen</translation>
    </message>
    <message>
        <source>there is another %1 of version %2; give this one another number</source>
        <translation>es gibt eine andere „%1“ mit der Version %2; geben Sie dieser eine andere Nummer</translation>
    </message>
    <message>
        <source>rubric %1, criterion %2, %3: %4</source>
        <translation>Bewertungsschema %1, Kriterium %2, %3: %4</translation>
    </message>
    <message>
        <source>%1 %2 is not between %3 and %4</source>
        <translation>%1 %2 liegt nicht zwischen %3 und %4</translation>
    </message>
    <message>
        <source>must be at least 0.1 points</source>
        <translation>muss mindestens 0,1 Punkte sein</translation>
    </message>
    <message>
        <source>rubric %1, criteria: there are %2, it takes 1 to %3</source>
        <translation>Bewertungsschema %1, criteria: es sind %2, nötig sind 1 bis %3</translation>
    </message>
    <message>
        <source>rubric %1, pass_mark: must lie between 0 and 100 points</source>
        <translation>Bewertungsschema %1, pass_mark: muss zwischen 0 und 100 Punkten liegen</translation>
    </message>
    <message>
        <source>is there twice</source>
        <translation>ist zweimal da</translation>
    </message>
    <message>
        <source>rubric %1, weight: those of all criteria make %2 points; they must make 100</source>
        <translation>Bewertungsschema %1, weight: alle Kriterien zusammen ergeben %2 Punkte; es müssen 100 sein</translation>
    </message>
    <message>
        <source>is %1; points are given to a tenth</source>
        <translation>ist %1; Punkte gibt es auf ein Zehntel genau</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no measure; &quot;cusp lesson measures&quot; lists them</source>
        <translation>„%1“ ist keine Messgröße; „cusp lesson measures“ zählt sie auf</translation>
    </message>
    <message>
        <source>may hold small letters, digits, &apos;-&apos; and &apos;_&apos; only, and begins with a letter or digit</source>
        <translation>darf nur Kleinbuchstaben, Ziffern, „-“ und „_“ enthalten und beginnt mit einem Buchstaben oder einer Ziffer</translation>
    </message>
    <message>
        <source>is missing; name one that is shipped (&quot;decay_removal&quot;), a file beside the lesson, or write it out</source>
        <translation>fehlt; nennen Sie ein mitgeliefertes („decay_removal“), eine Datei neben der Lektion, oder schreiben Sie es aus</translation>
    </message>
    <message>
        <source>there is no rubric &quot;%1&quot;</source>
        <translation>es gibt kein Bewertungsschema „%1“</translation>
    </message>
    <message>
        <source>%1</source>
        <extracomment>%1: what has no words of its own but English ones</extracomment>
        <translation>%1 (nur auf Englisch bekannt)</translation>
    </message>
    <message>
        <source>the %1 (%2) is not a number</source>
        <extracomment>%1: a number of an ideal or a block, %2: its key, %3: the number that was given</extracomment>
        <translation>%1 (%2) ist keine Zahl</translation>
    </message>
    <message>
        <source>the %1 (%2) must be from %4 to %5, not %3</source>
        <translation>%1 (%2) muss zwischen %4 und %5 liegen und ist %3</translation>
    </message>
    <message>
        <source>the %1 (%2) must be from %4 to %5 %6, not %3</source>
        <translation>%1 (%2) muss zwischen %4 und %5 %6 liegen und ist %3</translation>
    </message>
    <message>
        <source>the %1 (%2) must be a whole number, not %3</source>
        <translation>%1 (%2) muss eine ganze Zahl sein und ist %3</translation>
    </message>
    <message>
        <source>there is no size &quot;%1&quot;; there are %2</source>
        <translation>es gibt kein Maß „%1“; es gibt %2</translation>
    </message>
    <message>
        <source>the thickness of the enamel layer (enamel_mm) is more than the block&apos;s height (height_mm)</source>
        <translation>die Schmelzschicht (enamel_mm) ist dicker, als der Block hoch ist (height_mm)</translation>
    </message>
    <message>
        <source>the block&apos;s side or height (side_mm, height_mm) is too small for three pads: they take %1 and %2 mm</source>
        <translation>Seite oder Höhe des Blocks (side_mm, height_mm) reicht nicht für drei Felder: Sie brauchen %1 und %2 mm</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) leaves less than %1 mm of the block around it</source>
        <translation>die Länge der Form (length_mm) lässt ringsum weniger als %1 mm vom Block</translation>
    </message>
    <message>
        <source>the depth of the channel (depth_mm) leaves less than %1 mm of the block below it</source>
        <translation>die Tiefe der Rinne (depth_mm) lässt darunter weniger als %1 mm vom Block</translation>
    </message>
    <message>
        <source>the radius of inner corners (corner_radius_mm) is more than half of the width of the channel (width_mm)</source>
        <translation>der Radius der Innenecken (corner_radius_mm) ist größer als die halbe Breite der Rinne (width_mm)</translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the radius of inner corners (corner_radius_mm): no bur leaves that</source>
        <translation>der Radius zwischen Boden und Wand (line_angle_mm) ist größer als der Radius der Innenecken (corner_radius_mm): das hinterlässt kein Bohrer</translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the depth (depth_mm)</source>
        <translation>der Radius zwischen Boden und Wand (line_angle_mm) ist größer als die Tiefe (depth_mm)</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) must be at least %1 mm with a channel of that width (width_mm)</source>
        <translation>die Form (length_mm) muss bei dieser Breite der Rinne (width_mm) mindestens %1 mm lang sein</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) is less than the width of the channel (width_mm)</source>
        <translation>die Form (length_mm) ist kürzer, als die Rinne breit ist (width_mm)</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) leaves each of its steps shorter than the channel is wide (width_mm)</source>
        <translation>bei dieser Länge der Form (length_mm) ist jede Stufe kürzer, als die Rinne breit ist (width_mm)</translation>
    </message>
    <message>
        <source>there is no practice block &apos;%1&apos;; choose one of %2</source>
        <translation>es gibt keinen Übungsblock „%1“; wählen Sie einen von %2</translation>
    </message>
    <message>
        <source>there is no preparation &apos;%1&apos;; choose one of %2</source>
        <translation>es gibt keine Präparation „%1“; wählen Sie eine von %2</translation>
    </message>
    <message>
        <source>the preparation &apos;%1&apos; is not made for tooth %2; it is for %3</source>
        <translation>die Präparation „%1“ gibt es nicht für Zahn %2, nur für %3</translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the radius of the bur (bur_radius_mm): no bur leaves that</source>
        <translation>der Radius zwischen Boden und Wand (line_angle_mm) ist größer als der Radius des Bohrers (bur_radius_mm): das hinterlässt kein Bohrer</translation>
    </message>
    <message>
        <source>the width of the isthmus (isthmus_mm) is less than the bur is wide (twice bur_radius_mm)</source>
        <translation>der Isthmus (isthmus_mm) ist schmaler als der Bohrer (zweimal bur_radius_mm)</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make its depth (depth_mm) less</source>
        <translation>diese Präparation würde die Pulpa eröffnen; verringern Sie die Tiefe (depth_mm)</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make its depth (depth_mm) or that of the box (box_floor_mm, box_axial_mm) less</source>
        <translation>diese Präparation würde die Pulpa eröffnen; verringern Sie die Tiefe (depth_mm) oder die des Kastens (box_floor_mm, box_axial_mm)</translation>
    </message>
    <message>
        <source>nobody knows where the fissures of &apos;%1&apos; run or which side is mesial; choose a tooth by its FDI number, or take an ideal from attempts at this one</source>
        <translation>niemand weiß, wo die Fissuren von „%1“ verlaufen und welche Seite mesial ist; wählen Sie einen Zahn nach seiner FDI-Nummer, oder nehmen Sie ein Ideal aus Versuchen an diesem</translation>
    </message>
    <message>
        <source>there is no room for the %1 on this tooth; make one of these less: %2</source>
        <extracomment>%1: a part of a preparation, %2: keys of numbers</extracomment>
        <translation>auf diesem Zahn ist kein Platz (%1); verringern Sie eines davon: %2</translation>
    </message>
    <message>
        <source>occlusal outline</source>
        <translation>okklusaler Umriss</translation>
    </message>
    <message>
        <source>central groove</source>
        <translation>Zentralfurche</translation>
    </message>
    <message>
        <source>mesial pit</source>
        <translation>mesiale Grube</translation>
    </message>
    <message>
        <source>distal pit</source>
        <translation>distale Grube</translation>
    </message>
    <message>
        <source>pits</source>
        <translation>Gruben</translation>
    </message>
    <message>
        <source>none: the tooth has no such groove</source>
        <translation>keines: der Zahn hat keine solche Furche</translation>
    </message>
    <message>
        <source>tooth %1 has no pulp chamber that could be opened from above</source>
        <translation>Zahn %1 hat keine Pulpenkammer, die sich von oben eröffnen ließe</translation>
    </message>
    <message>
        <source>The captured ideal is damaged. Use a copy of the file, or capture it again.</source>
        <translation>Das abgenommene Ideal ist beschädigt. Nehmen Sie eine Kopie der Datei, oder nehmen Sie es neu ab.</translation>
    </message>
    <message>
        <source>The ideal was captured on the tooth &apos;%1&apos; (seed %2, grid %3) and does not fit &apos;%4&apos; (seed %5, grid %6); name that tooth, seed and grid, or capture it on this one.</source>
        <translation>Das Ideal wurde am Zahn „%1“ (seed %2, grid %3) abgenommen und passt nicht zu „%4“ (seed %5, grid %6); nennen Sie jenen Zahn mit seed und grid, oder nehmen Sie es an diesem ab.</translation>
    </message>
    <message>
        <source>The captured ideal is empty; choose another file.</source>
        <translation>Das abgenommene Ideal ist leer; wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>This is not a captured ideal; choose a file that Cusp has saved as one (*.cuspideal).</source>
        <translation>Das ist kein abgenommenes Ideal; wählen Sie eine Datei, die Cusp als solches gespeichert hat (*.cuspideal).</translation>
    </message>
    <message>
        <source>The captured ideal is of version %1, this Cusp reads up to version %2; open it with a newer Cusp.</source>
        <translation>Das abgenommene Ideal hat die Version %1, dieses Cusp liest bis Version %2; öffnen Sie es mit einem neueren Cusp.</translation>
    </message>
    <message>
        <source>The captured ideal ends early: it was cut off while being written or copied. Use a whole copy.</source>
        <translation>Das abgenommene Ideal endet zu früh: Es wurde beim Schreiben oder Kopieren abgeschnitten. Nehmen Sie eine vollständige Kopie.</translation>
    </message>
    <message>
        <source>The firmware file is empty; choose another file.</source>
        <translation>Die Firmware-Datei ist leer; wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>The file is larger than %1 KiB and cannot be firmware for the Falcon; choose another file.</source>
        <translation>Die Datei ist größer als %1 KiB und kann keine Firmware für den Falcon sein; wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>This is not firmware for the Falcon; choose another file.</source>
        <translation>Das ist keine Firmware für den Falcon; wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>The firmware file is too short: it has %1 bytes, and its header alone has %2. Use a complete copy.</source>
        <translation>Die Firmware-Datei ist zu kurz: Sie hat %1 Bytes, und allein ihr Kopf hat %2. Nehmen Sie eine vollständige Kopie.</translation>
    </message>
    <message>
        <source>The firmware file ends before its block %1 is complete. Use a complete copy.</source>
        <translation>Die Firmware-Datei endet, bevor ihr Block %1 vollständig ist. Nehmen Sie eine vollständige Kopie.</translation>
    </message>
    <message>
        <source>The firmware ends after %1 bytes, but the file has %2. Use an unchanged copy.</source>
        <translation>Die Firmware endet nach %1 Bytes, aber die Datei hat %2. Nehmen Sie eine unveränderte Kopie.</translation>
    </message>
    <message>
        <source>There is no handpiece &apos;%1&apos;; choose one of %2.</source>
        <translation>Es gibt kein Handstück „%1“; wählen Sie eines von %2.</translation>
    </message>
    <message>
        <source>There is no bur &apos;%1&apos;; choose one of %2.</source>
        <translation>Es gibt keinen Bohrer „%1“; wählen Sie einen von %2.</translation>
    </message>
    <message>
        <source>There is no hardness preset &apos;%1&apos;; choose natural or typodont, or name a file.</source>
        <translation>Es gibt keine Härte-Voreinstellung „%1“; wählen Sie natural oder typodont, oder nennen Sie eine Datei.</translation>
    </message>
    <message>
        <source>the force limit is %1 N, and the device gives at most %2 N; lower it</source>
        <translation>die Kraftgrenze ist %1 N, und das Gerät gibt höchstens %2 N; senken Sie sie</translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm with this damping; lower the stiffness, or damp more</source>
        <translation>die Steifigkeit ist %1 N/mm, und eine leichte Hand bleibt bei %2 ms Verzögerung mit dieser Dämpfung nur bis %3 N/mm ruhig; senken Sie die Steifigkeit, oder dämpfen Sie mehr</translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm however it is damped; lower the stiffness</source>
        <translation>die Steifigkeit ist %1 N/mm, und eine leichte Hand bleibt bei %2 ms Verzögerung nur bis %3 N/mm ruhig, wie auch immer gedämpft wird; senken Sie die Steifigkeit</translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm before it buzzes; lower the stiffness</source>
        <translation>die Steifigkeit ist %1 N/mm, und eine leichte Hand bleibt bei %2 ms Verzögerung nur bis %3 N/mm ruhig, darüber surrt sie; senken Sie die Steifigkeit</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>percent</source>
        <translation>Prozent</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1: the name of a file; %2: what is wrong with it: &quot;is empty&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>says nothing of %1: that is as shipped</source>
        <translation>sagt nichts über %1: Das ist wie mitgeliefert</translation>
    </message>
    <message>
        <source>%1 has the last version that there can be, %2; keep this under another name</source>
        <translation>%1 hat die letzte mögliche Version, %2; speichern Sie dies unter einem anderen Namen</translation>
    </message>
    <message>
        <source>The USB of this computer cannot be used (%1). The mouse works without it.</source>
        <translation>Der USB dieses Computers lässt sich nicht verwenden (%1). Die Maus arbeitet ohne ihn.</translation>
    </message>
    <message>
        <source>You have no permission to use the Falcon. Install the rule that %1 prints, then unplug the Falcon and plug it in again.</source>
        <translation>Ihnen fehlt die Berechtigung für den Falcon. Installieren Sie die Regel, die %1 ausgibt, und stecken Sie den Falcon aus und wieder ein.</translation>
    </message>
    <message>
        <source>Another program uses the Falcon. Close that program.</source>
        <translation>Ein anderes Programm verwendet den Falcon. Schließen Sie dieses Programm.</translation>
    </message>
    <message>
        <source>Another driver of the system holds the Falcon. Give it the driver WinUSB.</source>
        <translation>Ein anderer Treiber des Systems belegt den Falcon. Weisen Sie ihm den Treiber WinUSB zu.</translation>
    </message>
    <message>
        <source>The USB connection to the Falcon failed (%1). Unplug the Falcon and plug it in again.</source>
        <translation>Die USB-Verbindung zum Falcon ist gestört (%1). Stecken Sie den Falcon aus und wieder ein.</translation>
    </message>
    <message>
        <source>No Falcon is plugged in.</source>
        <translation>Es ist kein Falcon angeschlossen.</translation>
    </message>
    <message>
        <source>The Falcon does not answer. Check that its mains adapter is plugged in, then unplug its USB cable and plug it in again.</source>
        <translation>Der Falcon antwortet nicht. Prüfen Sie, ob sein Netzteil angeschlossen ist, und stecken Sie sein USB-Kabel aus und wieder ein.</translation>
    </message>
    <message>
        <source>The Falcon was unplugged while its firmware was loaded.</source>
        <translation>Der Falcon wurde ausgesteckt, während seine Firmware geladen wurde.</translation>
    </message>
    <message>
        <source>The Falcon received byte %1 of the firmware wrongly. Try another USB port, without a hub.</source>
        <translation>Der Falcon hat Byte %1 der Firmware falsch empfangen. Versuchen Sie einen anderen USB-Anschluss, ohne Hub.</translation>
    </message>
    <message>
        <source>Loading the firmware was stopped.</source>
        <translation>Das Laden der Firmware wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The firmware file cannot be read; choose it again.</source>
        <translation>Die Firmware-Datei lässt sich nicht lesen; wählen Sie sie erneut.</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware, which cannot be shipped with Cusp. Choose the firmware file of your Falcon&apos;s software.</source>
        <translation>Der Falcon braucht seine Firmware, die nicht mit Cusp geliefert werden darf. Wählen Sie die Firmware-Datei aus der Software Ihres Falcon.</translation>
    </message>
    <message>
        <source>The firmware was loaded, but does not answer. Try another firmware file.</source>
        <translation>Die Firmware wurde geladen, antwortet aber nicht. Versuchen Sie eine andere Firmware-Datei.</translation>
    </message>
    <message>
        <source>This program was built without libusb: force devices are left out.</source>
        <translation>Dieses Programm wurde ohne libusb gebaut: Kraftgeräte sind nicht enthalten.</translation>
    </message>
    <message>
        <source>No Falcon with the serial number %1 is plugged in.</source>
        <translation>Es ist kein Falcon mit der Seriennummer %1 angeschlossen.</translation>
    </message>
    <message>
        <source>Cusp cannot read pictures: its file %1 or a library of OpenCV is missing. Install Cusp again. The mouse works without it.</source>
        <translation>Cusp kann keine Bilder lesen: Seine Datei %1 oder eine Bibliothek von OpenCV fehlt. Installieren Sie Cusp neu. Die Maus funktioniert ohne sie.</translation>
    </message>
    <message>
        <source>There is no camera %1. Plug in a camera, or choose another one.</source>
        <translation>Es gibt keine Kamera %1. Schließen Sie eine Kamera an, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>You have no permission to use camera %1. An administrator of this computer can add you to the group &quot;video&quot;.</source>
        <translation>Sie haben keine Berechtigung für Kamera %1. Ein Administrator dieses Computers kann Sie in die Gruppe „video“ aufnehmen.</translation>
    </message>
    <message>
        <source>Camera %1 gives no pictures. Close other programs that use it, or choose another one.</source>
        <translation>Kamera %1 liefert keine Bilder. Schließen Sie andere Programme, die sie benutzen, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>Camera %1 gives no more pictures. Check that it is plugged in.</source>
        <translation>Kamera %1 liefert keine Bilder mehr. Prüfen Sie, ob sie angeschlossen ist.</translation>
    </message>
    <message>
        <source>There is no file %1.</source>
        <translation>Es gibt keine Datei %1.</translation>
    </message>
    <message>
        <source>The file %1 cannot be read.</source>
        <translation>Die Datei %1 kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>%1 is no video, or of a kind that cannot be read here.</source>
        <translation>%1 ist kein Video oder von einer Art, die hier nicht gelesen werden kann.</translation>
    </message>
    <message>
        <source>The calibration is for pictures of %1 x %2 pixels, and these have %3 x %4. Calibrate the camera at this size.</source>
        <translation>Die Kalibrierung gilt für Bilder von %1 x %2 Pixeln, und diese haben %3 x %4. Kalibrieren Sie die Kamera bei dieser Größe.</translation>
    </message>
    <message>
        <source>The file %1 is too large for a calibration.</source>
        <translation>Die Datei %1 ist zu groß für eine Kalibrierung.</translation>
    </message>
    <message>
        <source>%1 is no calibration of a camera.</source>
        <translation>%1 ist keine Kalibrierung einer Kamera.</translation>
    </message>
    <message>
        <source>%1: a value is missing or is not a number.</source>
        <translation>%1: Ein Wert fehlt oder ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The size of the pictures must be 1 to 16384 pixels a side.</source>
        <translation>Die Bilder müssen auf jeder Seite 1 bis 16384 Pixel haben.</translation>
    </message>
    <message>
        <source>The optical centre of a camera must lie within its pictures.</source>
        <translation>Die optische Mitte einer Kamera muss in ihren Bildern liegen.</translation>
    </message>
    <message>
        <source>The coefficients of a lens must lie between -5 and 5.</source>
        <translation>Die Koeffizienten eines Objektivs müssen zwischen -5 und 5 liegen.</translation>
    </message>
    <message>
        <source>The focal length of a camera must be 0.1 to 20 times the width of its pictures.</source>
        <translation>Die Brennweite einer Kamera muss das 0,1- bis 20-Fache der Breite ihrer Bilder sein.</translation>
    </message>
    <message>
        <source>This program was built without SDL 2: pedals and gamepads are left out.</source>
        <translation>Dieses Programm wurde ohne SDL 2 gebaut: Pedale und Gamepads fehlen.</translation>
    </message>
    <message>
        <source>Pedals and gamepads cannot be read (%1). The mouse and the keyboard work without them.</source>
        <translation>Pedale und Gamepads können nicht gelesen werden (%1). Maus und Tastatur gehen ohne sie.</translation>
    </message>
    <message>
        <source>must lie between 0.1 and 100 points, at a criterion without weight</source>
        <translation>muss zwischen 0,1 und 100 Punkten liegen, bei einem Kriterium ohne Gewicht</translation>
    </message>
    <message>
        <source>a critical criterion has none; it limits the points of the whole attempt</source>
        <translation>ein kritisches Kriterium hat keines; es begrenzt die Punkte des ganzen Versuchs</translation>
    </message>
    <message>
        <source>a critical criterion leaves no points; give one of the two</source>
        <translation>ein kritisches Kriterium lässt keine Punkte übrig; geben Sie nur eines von beiden an</translation>
    </message>
    <message>
        <source>must be at least 0.1 points; an error that leaves none is &quot;critical&quot;</source>
        <translation>muss mindestens 0,1 Punkte sein; ein Fehler, der keine übrig lässt, ist &quot;critical&quot;</translation>
    </message>
    <message>
        <source>is how far the tooth lies on a side; say which in &quot;lies&quot;</source>
        <translation>sagt, wie weit der Zahn auf einer Seite liegt; nennen Sie sie in „lies“</translation>
    </message>
    <message>
        <source>a tooth that lies on a side has no neighbours; write false</source>
        <translation>ein Zahn, der auf der Seite liegt, hat keine Nachbarn; schreiben Sie false</translation>
    </message>
    <message>
        <source>is about a tooth that stands upright</source>
        <translation>betrifft einen aufrecht stehenden Zahn</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no side of a tooth; write occlusal, mesial, distal, buccal or lingual</source>
        <translation>„%1“ ist keine Seite eines Zahns; schreiben Sie occlusal, mesial, distal, buccal oder lingual</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no side of a scan; write occlusal, -x, +x, -y or +y</source>
        <translation>„%1“ ist keine Seite eines Scans; schreiben Sie occlusal, -x, +x, -y oder +y</translation>
    </message>
    <message>
        <source>a tooth is tilted by %1 to %2 degrees, not by %3</source>
        <translation>ein Zahn wird um %1 bis %2 Grad gekippt, nicht um %3</translation>
    </message>
    <message>
        <source>a bur reaches no fissure of a tooth that is tilted by more than %1 degrees</source>
        <translation>an einem Zahn, der um mehr als %1 Grad gekippt ist, erreicht kein Bohrer eine Fissur</translation>
    </message>
    <message>
        <source>decay below a contact is on the mesial or distal side; let the tooth lie that way</source>
        <translation>Karies unter einem Kontakt liegt mesial oder distal; lassen Sie den Zahn so liegen</translation>
    </message>
    <message>
        <source>decay at the neck or in a pit of a side is on the buccal or lingual side; let the tooth lie that way</source>
        <translation>Karies am Zahnhals oder in einer Grube einer Seite liegt bukkal oder lingual; lassen Sie den Zahn so liegen</translation>
    </message>
    <message>
        <source>there is no pit on the side that tooth &apos;%1&apos; shows</source>
        <translation>die Seite, die Zahn %1 zeigt, hat keine Grube</translation>
    </message>
    <message>
        <source>this preparation is made for a tooth that stands upright; leave out &quot;lies&quot;, or take an ideal from attempts at this tooth</source>
        <translation>diese Präparation wird für einen aufrecht stehenden Zahn gemacht; lassen Sie „lies“ weg, oder nehmen Sie ein Ideal von Versuchen an diesem Zahn ab</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make the depth of the box (box_floor_mm, box_axial_mm) less</source>
        <translation>diese Präparation würde die Pulpa eröffnen; verringern Sie die Tiefe des Kastens (box_floor_mm, box_axial_mm)</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) leaves less than %1 mm of the block between its pits (width_mm, steps)</source>
        <translation>die Länge der Form (length_mm) lässt zwischen ihren Vertiefungen weniger als %1 mm des Blocks (width_mm, steps)</translation>
    </message>
    <message>
        <source>the enamel is thinner where it is thickest (depth_mm) than where it is thinnest (enamel_mm)</source>
        <translation>der Schmelz ist an der dicksten Stelle (depth_mm) dünner als an der dünnsten (enamel_mm)</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make the reduction (reduction_mm, functional_mm) less</source>
        <translation>diese Präparation würde die Pulpa eröffnen; verringern Sie die Reduktion (reduction_mm, functional_mm)</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>width of the isthmus</source>
        <translation>Breite des Isthmus</translation>
    </message>
    <message>
        <source>depth of the pulpal floor</source>
        <translation>Tiefe des Pulpabodens</translation>
    </message>
    <message>
        <source>width of the dovetail</source>
        <translation>Breite des Schwalbenschwanzes</translation>
    </message>
    <message>
        <source>extension into the grooves</source>
        <translation>Ausdehnung in die Furchen</translation>
    </message>
    <message>
        <source>marginal ridge that is left</source>
        <translation>verbleibende Randleiste</translation>
    </message>
    <message>
        <source>ridge across the tooth that is left on each side</source>
        <translation>beidseits verbleibende Querleiste</translation>
    </message>
    <message>
        <source>divergence of the end walls</source>
        <translation>Divergenz der Endwände</translation>
    </message>
    <message>
        <source>radius of the bur</source>
        <translation>Radius des Bohrers</translation>
    </message>
    <message>
        <source>radius between floor and wall</source>
        <translation>Radius zwischen Boden und Wand</translation>
    </message>
    <message>
        <source>floor along the junction</source>
        <translation>Boden entlang der Schmelz-Dentin-Grenze</translation>
    </message>
    <message>
        <source>depth of the floor in dentin</source>
        <translation>Tiefe des Bodens im Dentin</translation>
    </message>
    <message>
        <source>depth of the gingival floor</source>
        <translation>Tiefe des gingivalen Bodens</translation>
    </message>
    <message>
        <source>depth of the axial wall</source>
        <translation>Tiefe der axialen Wand</translation>
    </message>
    <message>
        <source>width of the box</source>
        <translation>Breite des Kastens</translation>
    </message>
    <message>
        <source>lean of the access walls</source>
        <translation>Neigung der Zugangswände</translation>
    </message>
    <message>
        <source>margin around the chamber</source>
        <translation>Rand um die Kammer</translation>
    </message>
    <message>
        <source>block&apos;s side</source>
        <translation>Seite des Blocks</translation>
    </message>
    <message>
        <source>block&apos;s height</source>
        <translation>Höhe des Blocks</translation>
    </message>
    <message>
        <source>thickness of the enamel layer</source>
        <translation>Dicke der Schmelzschicht</translation>
    </message>
    <message>
        <source>width of the channel</source>
        <translation>Breite der Rinne</translation>
    </message>
    <message>
        <source>depth of the channel</source>
        <translation>Tiefe der Rinne</translation>
    </message>
    <message>
        <source>length of the shape</source>
        <translation>Länge der Form</translation>
    </message>
    <message>
        <source>flare of the dovetail</source>
        <translation>Weitung des Schwalbenschwanzes</translation>
    </message>
    <message>
        <source>number of steps</source>
        <translation>Zahl der Stufen</translation>
    </message>
    <message>
        <source>radius of inner corners</source>
        <translation>Radius der Innenecken</translation>
    </message>
    <message>
        <source>occlusal reduction</source>
        <translation>okklusale Reduktion</translation>
    </message>
    <message>
        <source>reduction of the functional cusps</source>
        <translation>Reduktion der tragenden Höcker</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>version %1 of the lesson %2 was changed or is damaged; assign the lesson again</source>
        <translation>Fassung %1 der Lektion %2 wurde geändert oder ist beschädigt; geben Sie die Lektion noch einmal auf</translation>
    </message>
    <message>
        <source>row %1 of the audit was not written by Cusp: the role of person:%2 did not permit %3 on %4 then</source>
        <translation>Zeile %1 des Protokolls hat nicht Cusp geschrieben: Die damalige Rolle von person:%2 erlaubte %3 an %4 nicht</translation>
    </message>
    <message>
        <source>row %1 of the audit (%2): a computer had seen later rows of it. If nobody restored a backup without Cusp then, somebody put an older copy in the place of the database</source>
        <translation>Zeile %1 des Protokolls (%2): Ein Computer hatte spätere Zeilen davon gesehen. Wenn damals niemand ohne Cusp eine Sicherung wiederhergestellt hat, hat jemand eine ältere Kopie an die Stelle der Datenbank gelegt</translation>
    </message>
    <message>
        <source>%1 attempts do not match their recordings and do not count; the pages of the classes mark them</source>
        <translation>%1 Versuche passen nicht zu ihren Aufzeichnungen und zählen nicht; die Seiten der Klassen zeigen sie an</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no audit code; a report shows one such as 412-9f3ac07be1d2</source>
        <translation>„%1“ ist kein Prüfcode; ein Bericht zeigt einen wie 412-9f3ac07be1d2</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) tells that the rows before it did not end as they had been signed</source>
        <translation>Zeile %1 des Protokolls (%2, %3, %4) sagt, dass die Zeilen davor nicht so endeten, wie sie signiert worden waren</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) is not the one that was signed: it was changed, or the signature was put there from elsewhere</source>
        <translation>Zeile %1 des Protokolls (%2, %3, %4) ist nicht die, die signiert wurde: Sie wurde verändert, oder die Signatur kommt von anderswo</translation>
    </message>
    <message>
        <source>the signature of the newest row of the audit was not made by the station whose key stands beside it</source>
        <translation>die Signatur der neuesten Zeile des Protokolls stammt nicht von dem Arbeitsplatz, dessen Schlüssel daneben steht</translation>
    </message>
    <message>
        <source>audit row %1 was removed</source>
        <translation>Zeile %1 des Protokolls wurde entfernt</translation>
    </message>
    <message>
        <source>no signature covers audit row %1: it was inserted, or the signed head was set back, or the row behind it was changed</source>
        <translation>keine Signatur deckt Zeile %1 des Protokolls: Sie wurde eingefügt, der signierte Kopf wurde zurückgesetzt, oder die Zeile dahinter wurde verändert</translation>
    </message>
    <message>
        <source>the signed head of the audit was removed</source>
        <translation>der signierte Kopf des Protokolls wurde entfernt</translation>
    </message>
    <message>
        <source>the file is damaged: %1</source>
        <translation>die Datei ist beschädigt: %1</translation>
    </message>
    <message>
        <source>row %1 of the table %2 belongs to no row of %3</source>
        <translation>Zeile %1 der Tabelle %2 gehört zu keiner Zeile von %3</translation>
    </message>
    <message>
        <source>%1 (%2, %3) was changed after it had been kept</source>
        <translation>%1 (%2, %3) wurde nach dem Sichern verändert</translation>
    </message>
    <message>
        <source>%1 was removed; row %2 of the audit tells of it</source>
        <translation>%1 wurde entfernt; Zeile %2 des Protokolls berichtet davon</translation>
    </message>
    <message>
        <source>%1 has no score sheet</source>
        <translation>%1 hat keinen Bewertungsbogen</translation>
    </message>
    <message>
        <source>%1 has a standing in %2 that the attempts do not add up to</source>
        <translation>%1 hat in %2 einen Stand, den die Versuche nicht ergeben</translation>
    </message>
    <message>
        <source>%1 has attempts in %2 and no standing</source>
        <translation>%1 hat in %2 Versuche, aber keinen Stand</translation>
    </message>
    <message>
        <source>the recording %1 is not there any more; bring the folder &quot;recordings&quot; back from a backup</source>
        <translation>die Aufzeichnung %1 ist nicht mehr da; holen Sie den Ordner „recordings“ aus einer Sicherung zurück</translation>
    </message>
    <message>
        <source>the recording %1 was changed or is damaged; bring it back from a backup</source>
        <translation>die Aufzeichnung %1 wurde verändert oder ist beschädigt; holen Sie sie aus einer Sicherung zurück</translation>
    </message>
    <message>
        <source>the head of the audit was signed with the key %1, which is not this computer&apos;s; if the file was not written by Cusp on another computer, somebody has rewritten it</source>
        <translation>der Kopf des Protokolls wurde mit dem Schlüssel %1 signiert, der nicht der dieses Rechners ist; wenn die Datei nicht von Cusp auf einem anderen Rechner geschrieben wurde, hat jemand sie neu geschrieben</translation>
    </message>
    <message>
        <source>%1 is no longer there: what it guarded is not guarded any more</source>
        <translation>%1 ist nicht mehr da: Was damit geschützt war, ist nicht mehr geschützt</translation>
    </message>
    <message>
        <source>the newest row of the audit was signed with the key %1, and the audit knows no station that has it</source>
        <translation>die neueste Zeile des Protokolls wurde mit dem Schlüssel %1 signiert, und das Protokoll kennt keinen Arbeitsplatz, der ihn hat</translation>
    </message>
    <message>
        <source>audit row %1, which a report names, is not there: it was removed, or the code is not typed as it stands there</source>
        <translation>Zeile %1 des Protokolls, die ein Bericht nennt, gibt es nicht: Sie wurde entfernt, oder der Code ist nicht so eingegeben, wie er dort steht</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) is not the one that a report names: it or one before it was changed, or the code is not typed as it stands there</source>
        <translation>Zeile %1 des Protokolls (%2, %3, %4) ist nicht die, die ein Bericht nennt: Sie oder eine davor wurde geändert, oder der Code ist nicht so eingegeben, wie er dort steht</translation>
    </message>
    <message>
        <source>%1 (%2, %3) is not noted in the audit: it was inserted, or the note of it is among the rows of the audit that were removed or changed</source>
        <translation>%1 (%2, %3) ist im Protokoll nicht vermerkt: Es wurde eingefügt, oder der Vermerk stand in einer der Zeilen, die aus dem Protokoll entfernt oder darin geändert wurden</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) does not follow from the row before it: one of the two was changed, inserted or moved</source>
        <translation>Protokollzeile %1 (%2, %3, %4) folgt nicht auf die Zeile davor: Eine der beiden wurde geändert, eingefügt oder verschoben</translation>
    </message>
    <message>
        <source>the audit itself was changed: rows that differ from it may be right all the same</source>
        <translation>das Protokoll selbst wurde geändert: Zeilen, die davon abweichen, können trotzdem richtig sein</translation>
    </message>
    <message>
        <source>the check could not go on: %1</source>
        <translation>die Prüfung konnte nicht fortgesetzt werden: %1</translation>
    </message>
    <message>
        <source>%1 differs from the audit: the row of %2 was changed, added or removed</source>
        <translation>%1 weicht vom Protokoll ab: Die Zeile von %2 wurde geändert, hinzugefügt oder entfernt</translation>
    </message>
</context>
<context>
    <name>Handpiece</name>
    <message>
        <source>Turbine</source>
        <translation>Turbine</translation>
    </message>
    <message>
        <source>Electric</source>
        <extracomment>A red-ring contra-angle: electric motor, geared up</extracomment>
        <translation>Elektrisch</translation>
    </message>
    <message>
        <source>Low-speed</source>
        <translation>Langsam</translation>
    </message>
</context>
<context>
    <name>Health</name>
    <message>
        <source>The handpiece is disconnected: no force. Plug it in again.</source>
        <translation>Das Handstück ist getrennt: keine Kraft. Stecken Sie es wieder ein.</translation>
    </message>
    <message>
        <source>The computer was too slow: the recording has a gap.</source>
        <translation>Der Rechner war zu langsam: Die Aufzeichnung hat eine Lücke.</translation>
    </message>
    <message>
        <source>The computer is slow: the picture lags behind.</source>
        <translation>Der Rechner ist langsam: Das Bild hängt nach.</translation>
    </message>
    <message>
        <source>Force at its limit</source>
        <translation>Kraft an der Grenze</translation>
    </message>
    <message>
        <source>The bur is inside the tooth. Lift it out to continue.</source>
        <translation>Der Bohrer steckt im Zahn. Heben Sie ihn heraus, um weiterzumachen.</translation>
    </message>
    <message>
        <source>The handpiece responds late: the tooth feels softer.</source>
        <translation>Das Handstück antwortet spät: Der Zahn fühlt sich weicher an.</translation>
    </message>
    <message>
        <source>The handpiece guides your hand back over the tooth. Push against it to stop.</source>
        <translation>Das Handstück führt Ihre Hand über den Zahn zurück. Drücken Sie dagegen, um es zu beenden.</translation>
    </message>
    <message>
        <source>The outline holds your hand. Press Q to release it.</source>
        <translation>Der Umriss hält Ihre Hand. Drücken Sie Q, um sie freizugeben.</translation>
    </message>
</context>
<context>
    <name>HistoryPanel</name>
    <message>
        <source>Intact tooth</source>
        <translation>Unversehrter Zahn</translation>
    </message>
    <message>
        <source>Tooth reset</source>
        <translation>Zahn zurückgesetzt</translation>
    </message>
    <message>
        <source>%1 mm³ %2</source>
        <extracomment>What a stroke took off: so many cubic millimetres of a tissue</extracomment>
        <translation>%1 mm³ %2</translation>
    </message>
    <message>
        <source>present</source>
        <translation>jetzt</translation>
    </message>
</context>
<context>
    <name>Landmark</name>
    <message>
        <source>central pit</source>
        <translation>zentrale Grube</translation>
    </message>
    <message>
        <source>mesial pit</source>
        <translation>mesiale Grube</translation>
    </message>
    <message>
        <source>distal pit</source>
        <translation>distale Grube</translation>
    </message>
    <message>
        <source>mesial marginal ridge</source>
        <translation>mesiale Randleiste</translation>
    </message>
    <message>
        <source>distal marginal ridge</source>
        <translation>distale Randleiste</translation>
    </message>
</context>
<context>
    <name>Lesson</name>
    <message>
        <source>Practice block</source>
        <translation>Übungsblock</translation>
    </message>
    <message>
        <source>Exams</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Ideal preparations</source>
        <translation>Ideale Präparationen</translation>
    </message>
    <message>
        <source>Removing decay</source>
        <translation>Karies entfernen</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>depth gauge</source>
        <translation>Tiefenmesser</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgen</translation>
    </message>
    <message>
        <source>depth colours</source>
        <translation>Tiefenfarben</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>Spiegel</translation>
    </message>
    <message>
        <source>ideal preparation</source>
        <translation>ideale Präparation</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>%1: %2 points</source>
        <translation>%1: %2 Punkte</translation>
    </message>
    <message>
        <source>bur that changes colour</source>
        <translation>Bohrer, der die Farbe wechselt</translation>
    </message>
    <message>
        <source>guided hand</source>
        <translation>geführte Hand</translation>
    </message>
    <message>
        <source>depth stop</source>
        <translation>Tiefenanschlag</translation>
    </message>
    <message>
        <source>%1 ± %2 costs nothing</source>
        <extracomment>%1: a target; %2: how far off it one may be at no cost</extracomment>
        <translation>%1 ± %2 kostet nichts</translation>
    </message>
    <message>
        <source>%1 or more costs nothing</source>
        <translation>%1 oder mehr kostet nichts</translation>
    </message>
    <message>
        <source>Up to %1 costs nothing</source>
        <translation>Bis %1 kostet nichts</translation>
    </message>
    <message>
        <source> (more, where the decay is larger)</source>
        <translation> (mehr, wo die Karies größer ist)</translation>
    </message>
    <message>
        <source>beyond it the attempt fails</source>
        <translation>darüber hinaus ist der Versuch nicht bestanden</translation>
    </message>
    <message>
        <source>beyond it all %1 points are lost</source>
        <translation>darüber hinaus gehen alle %1 Punkte verloren</translation>
    </message>
    <message>
        <source>%1 off, all %2 points are lost</source>
        <translation>um %1 daneben gehen alle %2 Punkte verloren</translation>
    </message>
    <message>
        <source>at %1 all %2 points are lost</source>
        <translation>bei %1 sind alle %2 Punkte verloren</translation>
    </message>
    <message>
        <source>from %1 on all %2 points are lost</source>
        <translation>ab %1 sind alle %2 Punkte verloren</translation>
    </message>
    <message>
        <source>The first minutes</source>
        <translation>Die ersten Minuten</translation>
    </message>
    <message>
        <source>outline %1 mm to either side</source>
        <translation>Umriss %1 mm nach beiden Seiten</translation>
    </message>
    <message>
        <source>floor %1 mm up or down</source>
        <translation>Boden %1 mm höher oder tiefer</translation>
    </message>
    <message>
        <source>walls %1°, that is %2 mm over 1.5 mm of depth</source>
        <translation>Wände %1°, das sind %2 mm auf 1,5 mm Tiefe</translation>
    </message>
    <message>
        <source>floor even to %1 mm</source>
        <translation>Boden eben auf %1 mm</translation>
    </message>
    <message>
        <source> as soon as %1</source>
        <extracomment>%1: what has to be done before points are earned: &quot;50 % of the decay is removed&quot;</extracomment>
        <translation>, sobald %1</translation>
    </message>
    <message>
        <source>exam</source>
        <extracomment>On the card of a lesson</extracomment>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>in progress</source>
        <extracomment>On the card of the lesson that is being worked on</extracomment>
        <translation>in Arbeit</translation>
    </message>
    <message>
        <source>due since %1</source>
        <translation>fällig seit %1</translation>
    </message>
    <message>
        <source>due today %1</source>
        <translation>heute fällig, %1</translation>
    </message>
    <message>
        <source>due tomorrow</source>
        <translation>morgen fällig</translation>
    </message>
    <message>
        <source>due %1</source>
        <extracomment>%1: a day of the week, or a date</extracomment>
        <translation>fällig: %1</translation>
    </message>
    <message>
        <source>You have no attempts left at this lesson. Your teacher can give you more.</source>
        <translation>Sie haben für diese Lektion keine Versuche mehr. Ihre Lehrkraft kann Ihnen weitere geben.</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n day(s) late</source>
        <extracomment>%1: the day it was due, &quot;17 Nov&quot;</extracomment>
        <translation>
            <numerusform>%1, %n Tag zu spät</numerusform>
            <numerusform>%1, %n Tage zu spät</numerusform>
        </translation>
    </message>
    <message>
        <source>no attempts left</source>
        <extracomment>On the card of a lesson</extracomment>
        <translation>keine Versuche mehr</translation>
    </message>
    <message>
        <source>Your last attempt at this exam was started in another window. The work in this window does not count.</source>
        <translation>Ihr letzter Versuch in dieser Prüfung wurde in einem anderen Fenster begonnen. Die Arbeit in diesem Fenster zählt nicht.</translation>
    </message>
    <message>
        <source>In an exam, the expert&apos;s attempt is not shown.</source>
        <translation>In einer Prüfung wird der Versuch des Experten nicht gezeigt.</translation>
    </message>
    <message>
        <source>Only lessons have an expert&apos;s attempt. Press F2 to choose one.</source>
        <translation>Den Versuch eines Experten gibt es nur bei Lektionen. F2 öffnet die Auswahl.</translation>
    </message>
    <message>
        <source>This exercise has no expert&apos;s attempt.</source>
        <translation>Zu dieser Übung gibt es keinen Versuch eines Experten.</translation>
    </message>
    <message>
        <source>beyond it the score is limited to %1 points</source>
        <extracomment>%1: points of a score</extracomment>
        <translation>darüber ist die Punktzahl auf %1 begrenzt</translation>
    </message>
    <message>
        <source>At most %1 points: %2</source>
        <extracomment>%1: points of a score; %2: serious errors, with semicolons between</extracomment>
        <translation>Höchstens %1 Punkte: %2</translation>
    </message>
    <message>
        <source>Fails the attempt: %1</source>
        <extracomment>%1: serious errors, with semicolons between</extracomment>
        <translation>Lässt den Versuch scheitern: %1</translation>
    </message>
    <message>
        <source>mesial side towards the bur</source>
        <translation>mesiale Seite zum Bohrer</translation>
    </message>
    <message>
        <source>distal side towards the bur</source>
        <translation>distale Seite zum Bohrer</translation>
    </message>
    <message>
        <source>buccal side towards the bur</source>
        <translation>bukkale Seite zum Bohrer</translation>
    </message>
    <message>
        <source>lingual side towards the bur</source>
        <translation>linguale Seite zum Bohrer</translation>
    </message>
    <message>
        <source>%1 towards the bur</source>
        <extracomment>%1: a direction of a scan, such as &quot;+x&quot;</extracomment>
        <translation>%1 zum Bohrer</translation>
    </message>
</context>
<context>
    <name>Login</name>
    <message>
        <source>Wrong username or password. Try again, or ask an admin for a one-time code.</source>
        <translation>Benutzername oder Passwort ist falsch. Versuchen Sie es noch einmal, oder bitten Sie die Verwaltung um einen Einmalcode.</translation>
    </message>
    <message numerus="yes">
        <source>Too many logins have failed. Wait %n second(s) and try again.</source>
        <translation>
            <numerusform>Zu viele Anmeldungen sind fehlgeschlagen. Warten Sie %n Sekunde und versuchen Sie es noch einmal.</numerusform>
            <numerusform>Zu viele Anmeldungen sind fehlgeschlagen. Warten Sie %n Sekunden und versuchen Sie es noch einmal.</numerusform>
        </translation>
    </message>
    <message>
        <source>A user was added here in the meantime. Log in as an admin.</source>
        <translation>Inzwischen wurde hier ein Benutzer angelegt. Melden Sie sich als Admin an.</translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Try again, or practise without a login.</source>
        <translation>Der Server der Schule antwortet nicht. Versuchen Sie es noch einmal, oder üben Sie ohne Anmeldung.</translation>
    </message>
    <message>
        <source>A password has at least eight characters, does not contain the username and is not a common one such as &quot;password1&quot;.</source>
        <translation>Ein Passwort hat mindestens acht Zeichen, enthält nicht den Benutzernamen und ist kein gängiges wie „passwort1“.</translation>
    </message>
    <message>
        <source>Another program is writing to the school&apos;s database, so nobody can log in. Try again in a moment.</source>
        <translation>Ein anderes Programm schreibt gerade in die Datenbank der Schule, deshalb kann sich niemand anmelden. Versuchen Sie es gleich noch einmal.</translation>
    </message>
</context>
<context>
    <name>Material</name>
    <message>
        <source>decay</source>
        <translation>Karies</translation>
    </message>
    <message>
        <source>enamel</source>
        <translation>Schmelz</translation>
    </message>
    <message>
        <source>dentin</source>
        <translation>Dentin</translation>
    </message>
    <message>
        <source>pulp</source>
        <translation>Pulpa</translation>
    </message>
    <message>
        <source>C</source>
        <extracomment>One letter for decay (caries); must differ from those of enamel, dentin and pulp.</extracomment>
        <translation>K</translation>
    </message>
    <message>
        <source>E</source>
        <extracomment>One letter for enamel</extracomment>
        <translation>S</translation>
    </message>
    <message>
        <source>D</source>
        <extracomment>One letter for dentin</extracomment>
        <translation>D</translation>
    </message>
    <message>
        <source>P</source>
        <extracomment>One letter for pulp</extracomment>
        <translation>P</translation>
    </message>
</context>
<context>
    <name>Pad</name>
    <message>
        <source>Left</source>
        <extracomment>Three pads of a practice block, side by side</extracomment>
        <translation>Links</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
</context>
<context>
    <name>Printing</name>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
</context>
<context>
    <name>Scan</name>
    <message>
        <source>Taken as millimetres the scan is %1 mm long, more than a tooth.</source>
        <translation>In Millimetern gelesen ist der Scan %1 mm lang, länger als ein Zahn.</translation>
    </message>
    <message>
        <source>The file names no unit. As centimetres it is %1 mm long, so centimetres were taken.</source>
        <translation>Die Datei nennt keine Einheit. In Zentimetern gelesen ist der Scan %1 mm lang, daher wurden Zentimeter angenommen.</translation>
    </message>
    <message>
        <source>The file names no unit. As inches it is %1 mm long, so inches were taken.</source>
        <translation>Die Datei nennt keine Einheit. In Zoll gelesen ist der Scan %1 mm lang, daher wurde Zoll angenommen.</translation>
    </message>
    <message>
        <source>The file names no unit. As metres it is %1 mm long, so metres were taken.</source>
        <translation>Die Datei nennt keine Einheit. In Metern gelesen ist der Scan %1 mm lang, daher wurden Meter angenommen.</translation>
    </message>
    <message>
        <source>In no usual unit has the scan the size of a tooth, so it was made %1 mm long.</source>
        <translation>In keiner üblichen Einheit hat der Scan die Größe eines Zahns, daher wurde er auf %1 mm Länge gebracht.</translation>
    </message>
    <message>
        <source>The tooth lay askew in the file and was turned upright. If it is not upright now, export it with the crown along +z.</source>
        <translation>Der Zahn lag schräg in der Datei und wurde aufgerichtet. Steht er jetzt nicht aufrecht, exportieren Sie ihn mit der Krone in Richtung +z.</translation>
    </message>
    <message>
        <source>The shape does not show where the crown is. If the tooth lies on its side, export it with the crown along +z.</source>
        <translation>Die Form lässt nicht erkennen, wo die Krone ist. Liegt der Zahn auf der Seite, exportieren Sie ihn mit der Krone in Richtung +z.</translation>
    </message>
    <message>
        <source>The scan has openings; they were closed.</source>
        <translation>Der Scan hat Öffnungen; sie wurden geschlossen.</translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) without an area were left out.</source>
        <translation>
            <numerusform>%n Dreieck ohne Fläche wurde ausgelassen.</numerusform>
            <numerusform>%n Dreiecke ohne Fläche wurden ausgelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) are there twice.</source>
        <translation>
            <numerusform>%n Dreieck ist doppelt vorhanden.</numerusform>
            <numerusform>%n Dreiecke sind doppelt vorhanden.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n edge(s) more than two triangles meet.</source>
        <translation>
            <numerusform>An %n Kante stoßen mehr als zwei Dreiecke zusammen.</numerusform>
            <numerusform>An %n Kanten stoßen mehr als zwei Dreiecke zusammen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n edge(s) neighbouring triangles disagree which side is outside.</source>
        <translation>
            <numerusform>An %n Kante widersprechen sich benachbarte Dreiecke, welche Seite außen ist.</numerusform>
            <numerusform>An %n Kanten widersprechen sich benachbarte Dreiecke, welche Seite außen ist.</numerusform>
        </translation>
    </message>
    <message>
        <source>The scan was inside out and has been turned.</source>
        <translation>Der Scan war nach innen gekehrt und wurde gewendet.</translation>
    </message>
    <message numerus="yes">
        <source>The scan has %n separate part(s); the outermost surface counts.</source>
        <translation>
            <numerusform>Der Scan besteht aus %n Teil; es zählt die äußerste Fläche.</numerusform>
            <numerusform>Der Scan besteht aus %n getrennten Teilen; es zählt die äußerste Fläche.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Section</name>
    <message>
        <source>The plane does not meet the tooth here.</source>
        <translation>Die Ebene trifft den Zahn hier nicht.</translation>
    </message>
    <message>
        <source>original surface</source>
        <extracomment>In the key of a picture, beside a line</extracomment>
        <translation>ursprüngliche Oberfläche</translation>
    </message>
    <message>
        <source>ideal preparation</source>
        <translation>ideale Präparation</translation>
    </message>
    <message>
        <source>within tolerance</source>
        <extracomment>In the key of a picture: what may be cut or left without losing points</extracomment>
        <translation>in der Toleranz</translation>
    </message>
    <message>
        <source>costs points</source>
        <extracomment>In the key of a picture: farther out, all points of this criterion are lost</extracomment>
        <translation>kostet Punkte</translation>
    </message>
    <message>
        <source>soft decay</source>
        <translation>weiche Karies</translation>
    </message>
    <message>
        <source>leathery decay</source>
        <translation>lederartige Karies</translation>
    </message>
    <message>
        <source>firm decay</source>
        <translation>feste Karies</translation>
    </message>
</context>
<context>
    <name>Surface</name>
    <message>
        <source>M</source>
        <extracomment>Letters for sides of teeth, one or two each. Mesial</extracomment>
        <translation>M</translation>
    </message>
    <message>
        <source>D</source>
        <extracomment>Letter for the distal side</extracomment>
        <translation>D</translation>
    </message>
    <message>
        <source>La</source>
        <extracomment>Letters for the labial side (towards the lip), then for the buccal one (towards the cheek)</extracomment>
        <translation>La</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>P</source>
        <extracomment>Letters for the palatal side, then for the lingual one</extracomment>
        <translation>P</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>I</source>
        <extracomment>Letters for the incisal edge, then for the occlusal surface</extracomment>
        <translation>I</translation>
    </message>
    <message>
        <source>O</source>
        <translation>O</translation>
    </message>
</context>
<context>
    <name>TimeLine</name>
    <message>
        <source>section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>depth gauge</source>
        <translation>Tiefenmesser</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgenbild</translation>
    </message>
    <message>
        <source>depth colours</source>
        <translation>Tiefenfarben</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>Spiegel</translation>
    </message>
    <message>
        <source>ideal</source>
        <translation>Ideal</translation>
    </message>
    <message>
        <source>No aids in use</source>
        <translation>Keine Hilfe in Gebrauch</translation>
    </message>
    <message>
        <source>Aids in use: %1</source>
        <translation>Hilfen in Gebrauch: %1</translation>
    </message>
    <message>
        <source>Undone</source>
        <translation>Rückgängig gemacht</translation>
    </message>
    <message>
        <source>Redone</source>
        <translation>Wiederhergestellt</translation>
    </message>
    <message>
        <source>Tooth reset</source>
        <translation>Zahn zurückgesetzt</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>Notiz %1</translation>
    </message>
    <message>
        <source>The hand was guided back</source>
        <translation>Die Hand wurde zurückgeführt</translation>
    </message>
    <message>
        <source>Resumed</source>
        <translation>Wieder aufgenommen</translation>
    </message>
    <message>
        <source>colour of the bur</source>
        <translation>Farbe des Bohrers</translation>
    </message>
    <message>
        <source>guided hand</source>
        <translation>geführte Hand</translation>
    </message>
    <message>
        <source>%1 pad: answer %2</source>
        <extracomment>%1 is &quot;Left&quot;, &quot;Middle&quot; or &quot;Right&quot;, %2 a tissue</extracomment>
        <translation>%1: Antwort %2</translation>
    </message>
    <message>
        <source>Handpiece: %1</source>
        <translation>Handstück: %1</translation>
    </message>
    <message>
        <source>Point %1 touched</source>
        <translation>Punkt %1 berührt</translation>
    </message>
    <message>
        <source>Graded</source>
        <translation>Benotet</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 who remarked something on an attempt, %2 the words</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Bur: %1</source>
        <extracomment>%1: a bur such as &quot;Pear, No. 330&quot;</extracomment>
        <translation>Bohrer: %1</translation>
    </message>
</context>
<context>
    <name>Tooth</name>
    <message>
        <source>upper right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>%1 central incisor</source>
        <translation>mittlerer Schneidezahn %1</translation>
    </message>
    <message>
        <source>%1 lateral incisor</source>
        <translation>seitlicher Schneidezahn %1</translation>
    </message>
    <message>
        <source>%1 canine</source>
        <translation>Eckzahn %1</translation>
    </message>
    <message>
        <source>%1 first premolar</source>
        <translation>erster Prämolar %1</translation>
    </message>
    <message>
        <source>%1 second premolar</source>
        <translation>zweiter Prämolar %1</translation>
    </message>
    <message>
        <source>%1 first molar</source>
        <translation>erster Molar %1</translation>
    </message>
    <message>
        <source>%1 second molar</source>
        <translation>zweiter Molar %1</translation>
    </message>
    <message>
        <source>%1 third molar</source>
        <translation>dritter Molar %1</translation>
    </message>
    <message>
        <source>Tooth %1</source>
        <translation>Zahn %1</translation>
    </message>
    <message>
        <source>Tooth without a name</source>
        <translation>Zahn ohne Namen</translation>
    </message>
</context>
<context>
    <name>ViewMarks</name>
    <message>
        <source>depth, mm</source>
        <translation>Tiefe, mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <extracomment>A length in millimetres</extracomment>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>as it should be</source>
        <translation>wie es sein soll</translation>
    </message>
    <message>
        <source>%1 too deep</source>
        <extracomment>%1 is a length: the tooth is cut deeper than it should be</extracomment>
        <translation>%1 zu tief</translation>
    </message>
    <message>
        <source>%1 to cut</source>
        <extracomment>%1 is a length: so much is still to be taken away</extracomment>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>deviation, mm</source>
        <extracomment>Titles of a scale of colours: how deep a cut is, and how far from the ideal</extracomment>
        <translation>Abweichung, mm</translation>
    </message>
</context>
<context>
    <name>app::AdminController</name>
    <message>
        <source>The person was erased. The attempts stay as %1.</source>
        <translation>Die Person wurde gelöscht. Die Versuche bleiben als %1.</translation>
    </message>
    <message>
        <source>The person was erased, and the attempts stay as %1. Another program was using the database file, so unused parts of it may contain the names until another person is erased.</source>
        <translation>Die Person wurde gelöscht, und die Versuche bleiben als %1. Ein anderes Programm benutzte die Datenbankdatei, daher können unbenutzte Teile von ihr die Namen enthalten, bis wieder eine Person gelöscht wird.</translation>
    </message>
    <message>
        <source>%1 (not protected on the network: %2)</source>
        <translation>%1 (im Netz nicht geschützt: %2)</translation>
    </message>
    <message>
        <source>%1 was entered.</source>
        <translation>%1 wurde eingetragen.</translation>
    </message>
    <message>
        <source>%1 was changed.</source>
        <translation>%1 wurde geändert.</translation>
    </message>
    <message>
        <source>%1 cannot be read, or is too large.</source>
        <translation>%1 kann nicht gelesen werden oder ist zu groß.</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>Es wurde angehalten.</translation>
    </message>
    <message>
        <source>The data are being backed up …</source>
        <translation>Die Daten werden gesichert …</translation>
    </message>
    <message>
        <source>Everything is looked at …</source>
        <translation>Alles wird geprüft …</translation>
    </message>
    <message>
        <source>Nothing is wrong: %1 attempts and %2 rows of the audit are as they were noted.</source>
        <translation>Nichts ist falsch: %1 Versuche und %2 Zeilen des Protokolls sind so, wie sie festgehalten wurden.</translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) are not as they should be.</source>
        <translation>
            <numerusform>%n Sache ist nicht, wie sie sein sollte.</numerusform>
            <numerusform>%n Dinge sind nicht, wie sie sein sollten.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is empty. The first line of a class list names its columns: username, given_name, family_name, role, class.</source>
        <translation>%1 ist leer. Die erste Zeile einer Klassenliste nennt ihre Spalten: username, given_name, family_name, role, class.</translation>
    </message>
    <message numerus="yes">
        <source>A place that was left is locked after %n minute(s).</source>
        <translation>
            <numerusform>Ein verlassener Platz wird nach %n Minute gesperrt.</numerusform>
            <numerusform>Ein verlassener Platz wird nach %n Minuten gesperrt.</numerusform>
        </translation>
    </message>
    <message>
        <source>The backup is looked at …</source>
        <translation>Die Sicherung wird angesehen …</translation>
    </message>
    <message>
        <source>%1 is no whole backup of a school, and was not restored. Choose another one.</source>
        <translation>%1 ist keine vollständige Sicherung einer Schule und wurde nicht zurückgespielt. Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>The class list is looked at …</source>
        <translation>Die Klassenliste wird angesehen …</translation>
    </message>
    <message>
        <source>These people are being entered …</source>
        <translation>Diese Personen werden eingetragen …</translation>
    </message>
    <message>
        <source>No class can be called that. Its name has 1 to 100 characters that can be seen, without |, which parts classes in a class list, and no other class has it.</source>
        <translation>So kann keine Klasse heißen. Ihr Name hat 1 bis 100 sichtbare Zeichen, ohne |, das in einer Klassenliste Klassen trennt, und keine andere Klasse heißt so.</translation>
    </message>
    <message>
        <source>%1 has more than %2 lines. Split it, and enter the parts one after another.</source>
        <translation>%1 hat mehr als %2 Zeilen. Teilen Sie die Liste und geben Sie die Teile nacheinander ein.</translation>
    </message>
    <message>
        <source>The audit is still the one that the report with the code %1 names.</source>
        <translation>Das Protokoll ist noch das, das der Bericht mit dem Code %1 nennt.</translation>
    </message>
    <message>
        <source>Backed up: %1. Its pages and keys are whole.</source>
        <translation>Gesichert: %1. Seiten und Schlüssel der Sicherung sind heil.</translation>
    </message>
    <message>
        <source>The school&apos;s file is in use: another window of Cusp, or another program, has it open, or a backup is being made. Close what has it open, and restore then.</source>
        <translation>Die Datei der Schule ist in Gebrauch: Ein anderes Fenster von Cusp oder ein anderes Programm hat sie geöffnet, oder eine Sicherung wird gerade gemacht. Schließen Sie, was sie geöffnet hat, und spielen Sie dann zurück.</translation>
    </message>
    <message>
        <source>The backup was not restored; nothing has been changed. %1</source>
        <translation>Die Sicherung wurde nicht zurückgespielt; nichts wurde verändert. %1</translation>
    </message>
    <message>
        <source>It is no backup of this school.</source>
        <translation>Sie ist keine Sicherung dieser Schule.</translation>
    </message>
    <message>
        <source>There is nothing to save: everything is as it was.</source>
        <translation>Es gibt nichts zu speichern: Alles ist, wie es war.</translation>
    </message>
    <message>
        <source>Nothing was entered: somebody else has entered or changed people meanwhile. This is what the list would do now.</source>
        <translation>Es wurde niemand eingetragen: Jemand anderes hat inzwischen Personen eingetragen oder geändert. Dies würde die Liste jetzt bewirken.</translation>
    </message>
    <message>
        <source>That cannot be: the username is empty or taken, or has other characters than the letters a to z, digits and . _ - @.</source>
        <translation>Das geht nicht: Der Benutzername ist leer oder vergeben oder enthält andere Zeichen als die Buchstaben a bis z, Ziffern und . _ - @.</translation>
    </message>
</context>
<context>
    <name>app::LessonsController</name>
    <message>
        <source>The pack was not unpacked, so its lesson cannot be changed. %1</source>
        <translation>Das Paket wurde nicht ausgepackt, deshalb lässt sich seine Lektion nicht ändern. %1</translation>
    </message>
    <message>
        <source>No program answers here that shows folders. Your own lessons are in %1.</source>
        <translation>Hier antwortet kein Programm, das Ordner anzeigt. Ihre eigenen Lektionen liegen in %1.</translation>
    </message>
</context>
<context>
    <name>app::OpenedScoreController</name>
    <message>
        <source>Preparing the score card …</source>
        <translation>Das Bewertungsblatt wird erstellt …</translation>
    </message>
    <message>
        <source>Earlier attempts are not available during an exam. Press G to finish the exam, or start another lesson.</source>
        <translation>Frühere Versuche sind während einer Prüfung nicht verfügbar. Drücken Sie G, um die Prüfung zu beenden, oder beginnen Sie eine andere Lektion.</translation>
    </message>
</context>
<context>
    <name>app::AttemptController</name>
    <message>
        <source>Making tooth %1 …</source>
        <translation>Zahn %1 wird erzeugt …</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>Making a practice block …</source>
        <translation>Übungsblock wird erzeugt …</translation>
    </message>
    <message>
        <source>Preparing the lesson …</source>
        <translation>Die Lektion wird vorbereitet …</translation>
    </message>
    <message>
        <source>The reference was saved as %1. A lesson names it, or choose it in the editor of a lesson on this tooth.</source>
        <translation>Die Referenz wurde als %1 gespeichert. Eine Lektion nennt sie, oder Sie wählen sie im Editor einer Lektion an diesem Zahn.</translation>
    </message>
</context>
<context>
    <name>app::ResumeController</name>
    <message>
        <source>Resuming the attempt …</source>
        <translation>Der Versuch wird fortgesetzt …</translation>
    </message>
    <message>
        <source>Your attempt continues where you stopped. It was begun with the mouse: the device has no soft limit at the end of its reach in this attempt.</source>
        <translation>Ihr Versuch geht weiter, wo Sie aufgehört haben. Er wurde mit der Maus begonnen: In diesem Versuch hat das Gerät am Ende seiner Reichweite keine weiche Grenze.</translation>
    </message>
    <message>
        <source>Your attempt continues where you stopped.</source>
        <translation>Ihr Versuch geht dort weiter, wo Sie aufgehört haben.</translation>
    </message>
    <message>
        <source>The attempt is no longer there.</source>
        <translation>Der Versuch ist nicht mehr da.</translation>
    </message>
</context>
<context>
    <name>app::GradingController</name>
    <message>
        <source>The tooth is not ready yet. Try again in a moment.</source>
        <translation>Der Zahn ist noch nicht bereit. Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>Nothing has been cut yet, so there is nothing to grade.</source>
        <translation>Es wurde noch nichts abgetragen, also gibt es nichts zu bewerten.</translation>
    </message>
    <message>
        <source>This exercise has not been started yet, so there is nothing to grade.</source>
        <translation>Diese Übung ist noch nicht begonnen, also gibt es nichts zu bewerten.</translation>
    </message>
    <message>
        <source>No pad has an answer yet. Choose below the view what each pad is made of.</source>
        <translation>Noch hat kein Feld eine Antwort. Wählen Sie unter dem Bild, woraus jedes Feld besteht.</translation>
    </message>
    <message>
        <source>The grade that could not be saved is now saved.</source>
        <translation>Die Bewertung, die nicht gespeichert werden konnte, ist jetzt gespeichert.</translation>
    </message>
</context>
<context>
    <name>app::PlaybackController</name>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>The tooth is intact. You can start drilling.</source>
        <translation>Der Zahn ist unversehrt. Sie können mit dem Präparieren beginnen.</translation>
    </message>
    <message>
        <source>You are back in your own work.</source>
        <translation>Sie sind wieder bei Ihrer eigenen Arbeit.</translation>
    </message>
    <message>
        <source>Preparing the lesson …</source>
        <translation>Die Lektion wird vorbereitet …</translation>
    </message>
    <message>
        <source>The expert</source>
        <translation>Der Experte</translation>
    </message>
    <message>
        <source>A simulated hand does the lesson …</source>
        <translation>Eine simulierte Hand macht die Lektion …</translation>
    </message>
    <message>
        <source>The simulated hand</source>
        <translation>Die simulierte Hand</translation>
    </message>
    <message>
        <source>No teacher has recorded this lesson, so a simulated hand shows it.</source>
        <translation>Keine Lehrkraft hat diese Lektion aufgezeichnet, deshalb zeigt sie eine simulierte Hand.</translation>
    </message>
    <message>
        <source>No teacher has recorded this lesson, and the simulated hand cannot do it.</source>
        <translation>Keine Lehrkraft hat diese Lektion aufgezeichnet, und eine simulierte Hand schafft sie nicht.</translation>
    </message>
</context>
<context>
    <name>app::LoginController</name>
    <message>
        <source>The school&apos;s database is on a network drive, where only one computer at a time can use it. For several computers, use a PostgreSQL server.</source>
        <translation>Die Datenbank der Schule liegt auf einem Netzlaufwerk, wo sie nur ein Computer zugleich benutzen kann. Nehmen Sie für mehrere Computer einen PostgreSQL-Server.</translation>
    </message>
    <message>
        <source>The connection to the school&apos;s server is not protected: someone on the network can read or change names and marks. Ask whoever looks after the server.</source>
        <translation>Die Verbindung zum Server der Schule ist nicht geschützt: Jemand im Netz kann Namen und Noten lesen oder ändern. Wenden Sie sich an die Person, die den Server betreut.</translation>
    </message>
    <message>
        <source>Your password was changed.</source>
        <translation>Ihr Passwort wurde geändert.</translation>
    </message>
    <message>
        <source>This account was disabled, and you were logged out. Ask an admin.</source>
        <translation>Dieses Konto wurde gesperrt, und Sie wurden abgemeldet. Fragen Sie die Verwaltung.</translation>
    </message>
    <message>
        <source>Your role was changed, and you were logged out. Log in again.</source>
        <translation>Ihre Rolle wurde geändert, und Sie wurden abgemeldet. Melden Sie sich neu an.</translation>
    </message>
    <message>
        <source>Your login has ended, or another school is now where yours was. Log in again.</source>
        <translation>Ihre Anmeldung wurde beendet, oder wo Ihre Schule war, ist jetzt eine andere. Melden Sie sich neu an.</translation>
    </message>
</context>
<context>
    <name>app::SchoolController</name>
    <message>
        <source>An attempt does not match its recording, so its score does not count. It is marked in the student&apos;s attempts and in the table of the class.</source>
        <translation>Ein Versuch passt nicht zu seiner Aufzeichnung, darum zählt sein Ergebnis nicht. Er ist in den Versuchen der Person und in der Tabelle der Klasse gekennzeichnet.</translation>
    </message>
    <message>
        <source>The database is older than when this computer last used it: attempts and changes may be missing. If nobody restored a backup, somebody put an older copy in its place. The audit has a row about it.</source>
        <translation>Die Datenbank ist älter als bei der letzten Benutzung an diesem Computer: Versuche und Änderungen können fehlen. Wenn niemand eine Sicherung wiederhergestellt hat, hat jemand eine ältere Kopie an ihre Stelle gelegt. Im Protokoll steht eine Zeile darüber.</translation>
    </message>
    <message>
        <source>Today&apos;s backup was not made. %1</source>
        <translation>Die heutige Sicherung wurde nicht gemacht. %1</translation>
    </message>
    <message>
        <source>The backup was not restored; nothing has been changed. %1</source>
        <translation>Die Sicherung wurde nicht zurückgespielt; nichts wurde verändert. %1</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) on this computer cannot be sent to this school: the student is unknown, or another station.key signed them. They stay on this computer.</source>
        <translation>
            <numerusform>%n Versuch auf diesem Computer kann nicht an diese Schule gesendet werden: Die Person ist unbekannt, oder er wurde mit einem anderen station.key signiert. Er bleibt auf diesem Computer.</numerusform>
            <numerusform>%n Versuche auf diesem Computer können nicht an diese Schule gesendet werden: Die Person ist unbekannt, oder sie wurden mit einem anderen station.key signiert. Sie bleiben auf diesem Computer.</numerusform>
        </translation>
    </message>
    <message>
        <source>The backup of %1 was restored.</source>
        <extracomment>%2: a file&apos;s name</extracomment>
        <translation>Die Sicherung vom %1 wurde wiederhergestellt.</translation>
    </message>
    <message>
        <source>The backup of %1 was restored. The previous file is kept next to it as %2.</source>
        <translation>Die Sicherung vom %1 wurde wiederhergestellt. Die vorige Datei liegt als %2 daneben.</translation>
    </message>
    <message>
        <source>The backup was not restored. %1</source>
        <translation>Die Sicherung wurde nicht zurückgespielt. %1</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) on this computer wait for another school: %1. If that is this one under an earlier name, &quot;cusp db send&quot; brings them here.</source>
        <extracomment>%1: a file&apos;s name, or the address of a server</extracomment>
        <translation>
            <numerusform>%n Versuch auf diesem Computer wartet auf eine andere Schule: %1. Ist das diese hier unter einem früheren Namen, bringt „cusp db send“ ihn hierher.</numerusform>
            <numerusform>%n Versuche auf diesem Computer warten auf eine andere Schule: %1. Ist das diese hier unter einem früheren Namen, bringt „cusp db send“ sie hierher.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ReportController</name>
    <message>
        <source>Score card: %1</source>
        <translation>Bewertung: %1</translation>
    </message>
    <message>
        <source>Save the score card</source>
        <translation>Bewertungsblatt speichern</translation>
    </message>
    <message>
        <source>The score card was saved as %1.</source>
        <translation>Das Bewertungsblatt wurde als %1 gespeichert.</translation>
    </message>
    <message>
        <source>The score card could not be written. Choose another folder, or free some disk space.</source>
        <translation>Das Bewertungsblatt konnte nicht geschrieben werden. Wählen Sie einen anderen Ordner, oder schaffen Sie Platz auf dem Datenträger.</translation>
    </message>
    <message>
        <source>The score card was printed.</source>
        <translation>Das Bewertungsblatt wurde gedruckt.</translation>
    </message>
    <message>
        <source>The score card could not be printed.</source>
        <translation>Das Bewertungsblatt konnte nicht gedruckt werden.</translation>
    </message>
    <message>
        <source>Creating the score card …</source>
        <translation>Das Bewertungsblatt wird erstellt …</translation>
    </message>
    <message>
        <source>Not logged in</source>
        <translation>Nicht angemeldet</translation>
    </message>
    <message>
        <source>There is no printer on this computer. Save it as a PDF instead.</source>
        <translation>An diesem Computer gibt es keinen Drucker. Speichern Sie es stattdessen als PDF.</translation>
    </message>
</context>
<context>
    <name>app::DeviceController</name>
    <message>
        <source>This cannot be changed during an exam.</source>
        <translation>Während einer Prüfung kann das nicht geändert werden.</translation>
    </message>
    <message>
        <source>The %1 is ready again and moves the bur.</source>
        <extracomment>%1: a force device</extracomment>
        <translation>Der %1 ist wieder bereit und führt den Bohrer.</translation>
    </message>
    <message>
        <source>The %1 no longer responds, and the bur was lifted. Continue with the mouse, or plug it in again.</source>
        <extracomment>%1: a force device</extracomment>
        <translation>Der %1 antwortet nicht mehr; der Bohrer wurde abgehoben. Arbeiten Sie mit der Maus weiter, oder stecken Sie ihn wieder ein.</translation>
    </message>
    <message>
        <source>Show the device</source>
        <translation>Gerät anzeigen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: a force device; %2: a sentence about its state</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>app::HeadTrackingController</name>
    <message>
        <source>Print the tag</source>
        <translation>Marke drucken</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF-Dokument (*.pdf)</translation>
    </message>
    <message>
        <source>The sheet is in %1. Print it without scaling.</source>
        <extracomment>%1: a path</extracomment>
        <translation>Das Blatt ist in %1. Drucken Sie es ohne Skalierung.</translation>
    </message>
    <message>
        <source>The sheet could not be written.</source>
        <translation>Das Blatt konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The field of view could not be measured. Hold the tag still at this distance, and check the edge of its black square.</source>
        <translation>Der Bildwinkel konnte nicht gemessen werden. Halten Sie die Marke in diesem Abstand still, und prüfen Sie die Kante ihres schwarzen Quadrats.</translation>
    </message>
    <message>
        <source>The field of view is %1°. It is stored for this camera.</source>
        <extracomment>%1: a number of degrees</extracomment>
        <translation>Der Bildwinkel beträgt %1°. Er wird für diese Kamera gespeichert.</translation>
    </message>
    <message>
        <source>The view does not follow your head: the camera gives no pictures.</source>
        <translation>Die Ansicht folgt Ihrem Kopf nicht: Die Kamera liefert keine Bilder.</translation>
    </message>
    <message>
        <source>The view does not follow your head: the tag is not seen.</source>
        <translation>Die Ansicht folgt Ihrem Kopf nicht: Die Marke ist nicht zu sehen.</translation>
    </message>
    <message>
        <source>Show the device</source>
        <translation>Gerät anzeigen</translation>
    </message>
    <message>
        <source>The calibration %1 cannot be used. The field of view counts.</source>
        <extracomment>%1: the name of a file</extracomment>
        <translation>Die Kalibrierung %1 kann nicht verwendet werden. Es gilt der Bildwinkel.</translation>
    </message>
</context>
<context>
    <name>app::AttemptHistoryController</name>
    <message>
        <source>The recording of this attempt is not there, so it cannot be shown again. Its score and its figures are in the list.</source>
        <translation>Die Aufzeichnung dieses Versuchs ist nicht da, darum kann er nicht noch einmal gezeigt werden. Punktzahl und Zahlen stehen in der Liste.</translation>
    </message>
    <message>
        <source>%1: %2 points</source>
        <extracomment>%1: a lesson, and when it was done</extracomment>
        <translation>%1: %2 Punkte</translation>
    </message>
    <message>
        <source>This belongs to none of your classes any more. An admin can enter you into the class again.</source>
        <translation>Das gehört zu keiner Ihrer Klassen mehr. Die Verwaltung kann Sie wieder in die Klasse aufnehmen.</translation>
    </message>
</context>
<context>
    <name>app::ClassController</name>
    <message>
        <source>Save the class report</source>
        <translation>Klassenbericht speichern</translation>
    </message>
    <message>
        <source>The report was saved as %1.</source>
        <translation>Der Bericht wurde als %1 gespeichert.</translation>
    </message>
    <message>
        <source>The report could not be written. Choose another folder, or make room on the disk.</source>
        <translation>Der Bericht konnte nicht geschrieben werden. Wählen Sie einen anderen Ordner, oder schaffen Sie Platz auf dem Datenträger.</translation>
    </message>
    <message>
        <source>The report was printed.</source>
        <translation>Der Bericht wurde gedruckt.</translation>
    </message>
    <message>
        <source>The printer did not take the report.</source>
        <translation>Der Drucker hat den Bericht nicht angenommen.</translation>
    </message>
    <message>
        <source>The report is being written …</source>
        <translation>Der Bericht wird geschrieben …</translation>
    </message>
    <message>
        <source>There is no printer on this computer. Save it as a PDF instead.</source>
        <translation>An diesem Computer gibt es keinen Drucker. Speichern Sie es stattdessen als PDF.</translation>
    </message>
</context>
<context>
    <name>app::CommentsController</name>
    <message>
        <source>On the attempt of %1: %2</source>
        <extracomment>%1: who made an attempt, and when; %2: why</extracomment>
        <translation>Zum Versuch von %1: %2</translation>
    </message>
    <message>
        <source>That was not done: this student is in none of your classes any more. What you have typed stays here; an admin can enter you into the class again.</source>
        <translation>Das wurde nicht getan: Diese Person ist in keiner Ihrer Klassen mehr. Was Sie geschrieben haben, bleibt hier stehen; die Verwaltung kann Sie wieder in die Klasse aufnehmen.</translation>
    </message>
</context>
<context>
    <name>app::PresetController</name>
    <message>
        <source>The next tooth feels like this.</source>
        <translation>Der nächste Zahn fühlt sich so an.</translation>
    </message>
    <message>
        <source>The next tooth of everybody here feels like this.</source>
        <translation>Der nächste Zahn fühlt sich hier bei allen so an.</translation>
    </message>
    <message>
        <source>Not kept: only an admin keeps the school&apos;s presets.</source>
        <translation>Nicht gespeichert: Nur ein Admin speichert die Härte-Voreinstellungen der Schule.</translation>
    </message>
    <message>
        <source>Not kept: %1</source>
        <translation>Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Not imported: %1</source>
        <translation>Nicht eingelesen: %1</translation>
    </message>
    <message>
        <source>The preset was exported as %1.</source>
        <translation>Die Härte-Voreinstellung wurde als %1 exportiert.</translation>
    </message>
    <message>
        <source>Not kept: the file cannot be written. Make room on the disk, or check the rights.</source>
        <translation>Nicht gespeichert: Die Datei kann nicht geschrieben werden. Schaffen Sie Platz auf der Festplatte oder prüfen Sie die Rechte.</translation>
    </message>
    <message>
        <source>Not exported: the file cannot be written. Choose another folder, or make room on the disk.</source>
        <translation>Nicht exportiert: Die Datei kann nicht geschrieben werden. Wählen Sie einen anderen Ordner oder schaffen Sie Platz auf der Festplatte.</translation>
    </message>
    <message>
        <source>Somebody else has chosen %1 for everybody here meanwhile. That stays.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>Inzwischen hat jemand anderes für alle hier %1 gewählt. Das bleibt so.</translation>
    </message>
    <message>
        <source>%1 was not retired: teeth feel like it now, or too many are retired.</source>
        <translation>%1 wurde nicht ausgemustert: Zähne fühlen sich jetzt so an, oder es sind schon zu viele ausgemustert.</translation>
    </message>
    <message>
        <source>%1 is offered to nobody any more. Attempts go on naming it.</source>
        <translation>%1 wird niemandem mehr angeboten. Versuche nennen es weiterhin.</translation>
    </message>
    <message>
        <source>%1 is offered again.</source>
        <translation>%1 wird wieder angeboten.</translation>
    </message>
    <message>
        <source>The next tooth of everybody here feels like this. An admin had retired it; it is offered again.</source>
        <translation>Der nächste Zahn fühlt sich hier bei allen so an. Die Verwaltung hatte diese Voreinstellung ausgemustert; sie wird wieder angeboten.</translation>
    </message>
</context>
<context>
    <name>ui::admin::AdminPage</name>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Class list</source>
        <translation>Klassenliste</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>This computer</source>
        <translation>Dieser Computer</translation>
    </message>
    <message>
        <source>School</source>
        <translation>Schule</translation>
    </message>
</context>
<context>
    <name>ui::admin::AuditPart</name>
    <message>
        <source>Clear the search</source>
        <translation>Suche leeren</translation>
    </message>
    <message>
        <source>Search: a person, an action</source>
        <translation>Suche: eine Person, eine Handlung</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the audit code</source>
        <translation>Den Protokollcode kopieren</translation>
    </message>
    <message>
        <source>Older rows</source>
        <translation>Ältere Zeilen</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Protokoll</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n Zeile</numerusform>
            <numerusform>%n Zeilen</numerusform>
        </translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Whom or what</source>
        <translation>Wen oder was</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Audit code now: %1. Every report shows the code of its day. Type one beside &quot;Check everything&quot; (Backups) to see whether what was noted before it is still as it was.</source>
        <extracomment>%1: a short code</extracomment>
        <translation>Prüfcode jetzt: %1. Auf jedem Bericht steht der Code seines Tages. Geben Sie einen neben „Alles prüfen“ (Sicherungen) ein, um zu sehen, ob noch alles so ist, wie es davor festgehalten wurde.</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) among the newest %1; &quot;Older rows&quot; brings more to search</source>
        <extracomment>%1: how many rows were searched</extracomment>
        <translation>
            <numerusform>%n Zeile unter den neuesten %1; „Ältere Zeilen“ holt weitere zum Suchen</numerusform>
            <numerusform>%n Zeilen unter den neuesten %1; „Ältere Zeilen“ holt weitere zum Suchen</numerusform>
        </translation>
    </message>
    <message>
        <source>Leave out attempts</source>
        <translation>Versuche weglassen</translation>
    </message>
    <message>
        <source>Who began an exam or made an attempt is not shown: what is left is what was done to people, classes, grades, presets, settings and backups</source>
        <translation>Wer eine Prüfung begann oder einen Versuch machte, wird nicht gezeigt: Übrig bleibt, was mit Personen, Klassen, Bewertungen, Voreinstellungen, Einstellungen und Sicherungen getan wurde</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) among the newest %1 without attempts; &quot;Older rows&quot; brings more to search</source>
        <extracomment>%1: how many rows were searched</extracomment>
        <translation>
            <numerusform>%n Zeile unter den neuesten %1 ohne Versuche; „Ältere Zeilen“ holt weitere zum Durchsuchen</numerusform>
            <numerusform>%n Zeilen unter den neuesten %1 ohne Versuche; „Ältere Zeilen“ holt weitere zum Durchsuchen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::admin::BackupPart</name>
    <message>
        <source>Back up now</source>
        <translation>Jetzt sichern</translation>
    </message>
    <message>
        <source>Check everything</source>
        <translation>Alles prüfen</translation>
    </message>
    <message>
        <source>Look at every page, every attempt and the whole audit for what was changed, removed or inserted</source>
        <translation>Jede Seite, jeden Versuch und das ganze Protokoll darauf ansehen, ob etwas geändert, entfernt oder eingefügt wurde</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>What the check found</source>
        <translation>Was die Prüfung fand</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>The school&apos;s data are on a server: %1. Its administrator makes the backups; &quot;cusp db copy&quot; brings all of it into a file.</source>
        <translation>Die Daten der Schule liegen auf einem Server: %1. Dessen Verwalter macht die Sicherungen; „cusp db copy“ bringt alles in eine Datei.</translation>
    </message>
    <message>
        <source>Yes: log everybody out and restore it</source>
        <translation>Ja: alle abmelden und zurückspielen</translation>
    </message>
    <message>
        <source>Restore the chosen backup …</source>
        <translation>Gewählte Sicherung zurückspielen …</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Gemacht</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Keep what there is</source>
        <translation>Alles lassen, wie es ist</translation>
    </message>
    <message>
        <source>The school&apos;s data are in %1. A backup is made every day the program is used. All of the last two days are kept, then one for each of 12 days, 10 weeks and 9 months.</source>
        <translation>Die Daten der Schule liegen in %1. An jedem Tag, an dem das Programm benutzt wird, entsteht eine Sicherung. Alle der letzten zwei Tage bleiben, danach je eine von 12 Tagen, 10 Wochen und 9 Monaten.</translation>
    </message>
    <message>
        <source>Restore the backup of %1? What was entered after it will be missing. Attempts of this computer that are in no backup are entered again. The present file is kept beside it.</source>
        <extracomment>%1: when a backup was made</extracomment>
        <translation>Die Sicherung vom %1 zurückspielen? Was danach eingetragen wurde, fehlt dann. Versuche dieses Computers, die in keiner Sicherung sind, werden wieder eingetragen. Die jetzige Datei bleibt daneben erhalten.</translation>
    </message>
    <message>
        <source>Audit code of a report (optional):</source>
        <translation>Prüfcode eines Berichts (wenn gewünscht):</translation>
    </message>
    <message>
        <source>&quot;Check everything&quot; then also looks whether the audit is still the one that the report was printed from</source>
        <translation>„Alles prüfen“ sieht dann auch nach, ob das Protokoll noch das ist, aus dem der Bericht gedruckt wurde</translation>
    </message>
    <message>
        <source>This is no audit code. A report shows one such as %1.</source>
        <extracomment>%1: an example</extracomment>
        <translation>Das ist kein Prüfcode. Auf einem Bericht steht einer wie %1.</translation>
    </message>
</context>
<context>
    <name>ui::admin::PeoplePart</name>
    <message>
        <source>Erase …</source>
        <translation>Löschen …</translation>
    </message>
    <message>
        <source>Erase the person</source>
        <translation>Die Person löschen</translation>
    </message>
    <message>
        <source>Remove names, login and comments; the attempts stay under a pseudonym</source>
        <translation>Namen, Anmeldung und Kommentare entfernen; die Versuche bleiben unter einem Pseudonym</translation>
    </message>
    <message>
        <source>erased</source>
        <translation>gelöscht</translation>
    </message>
    <message>
        <source>This person was erased. The attempts stay under this name.</source>
        <translation>Diese Person wurde gelöscht. Die Versuche bleiben unter diesem Namen.</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Suche leeren</translation>
    </message>
    <message>
        <source>Search: a name, a class, a role</source>
        <translation>Suche: ein Name, eine Klasse, eine Rolle</translation>
    </message>
    <message>
        <source>Username</source>
        <translation>Benutzername</translation>
    </message>
    <message>
        <source>Given name</source>
        <translation>Vorname</translation>
    </message>
    <message>
        <source>Family name</source>
        <translation>Nachname</translation>
    </message>
    <message>
        <source>Name of a class</source>
        <translation>Name einer Klasse</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>Last login</source>
        <translation>Letzte Anmeldung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>New person</source>
        <translation>Neue Person</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>Add a class of this name</source>
        <translation>Eine Klasse dieses Namens anlegen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Give this name to the class that is chosen above</source>
        <translation>Der oben gewählten Klasse diesen Namen geben</translation>
    </message>
    <message>
        <source>Reset password</source>
        <translation>Passwort zurücksetzen</translation>
    </message>
    <message>
        <source>Take the password away and give a one-time code in its place</source>
        <translation>Das Passwort wegnehmen und dafür einen Einmalcode geben</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Rename the class</source>
        <translation>Die Klasse umbenennen</translation>
    </message>
    <message>
        <source>Copy the one-time code</source>
        <translation>Den Einmalcode kopieren</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>can log in</source>
        <translation>kann sich anmelden</translation>
    </message>
    <message>
        <source>has a one-time code</source>
        <translation>hat einen Einmalcode</translation>
    </message>
    <message>
        <source>Enter the person</source>
        <translation>Person eintragen</translation>
    </message>
    <message>
        <source>Save the changes</source>
        <translation>Änderungen speichern</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Who is disabled cannot log in; attempts and names stay</source>
        <translation>Wer gesperrt ist, kann sich nicht anmelden; Versuche und Namen bleiben</translation>
    </message>
    <message>
        <source>needs a one-time code</source>
        <translation>braucht einen Einmalcode</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keep the password</source>
        <translation>Das Passwort behalten</translation>
    </message>
    <message>
        <source>Yes, take it away</source>
        <translation>Ja, wegnehmen</translation>
    </message>
    <message>
        <source>Yes, take the password away</source>
        <translation>Ja, das Passwort wegnehmen</translation>
    </message>
    <message>
        <source>%1 will need a new one-time code: take the password away?</source>
        <translation>%1 wird einen neuen Einmalcode brauchen: das Passwort wegnehmen?</translation>
    </message>
    <message>
        <source>The school&apos;s data are being written to …</source>
        <translation>In die Daten der Schule wird geschrieben …</translation>
    </message>
    <message numerus="yes">
        <source>%Ln person(s)</source>
        <translation>
            <numerusform>%Ln Person</numerusform>
            <numerusform>%Ln Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>What you have typed for a new person is not entered.</source>
        <translation>Was Sie für eine neue Person eingegeben haben, ist nicht eingetragen.</translation>
    </message>
    <message>
        <source>What you have changed of %1 is not saved.</source>
        <translation>Was Sie an %1 geändert haben, ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>has a one-time code, shown here</source>
        <translation>hat einen Einmalcode, hier zu sehen</translation>
    </message>
    <message>
        <source>There is a class %1 already. It is ticked above.</source>
        <extracomment>%1: the name of a class</extracomment>
        <translation>Die Klasse %1 gibt es schon. Sie ist oben angekreuzt.</translation>
    </message>
    <message>
        <source>Yes, make another</source>
        <translation>Ja, einen anderen</translation>
    </message>
    <message>
        <source>The one-time code of %1 above would let nobody in any longer: make another?</source>
        <translation>Mit dem Einmalcode von %1 oben käme niemand mehr hinein: einen anderen erstellen?</translation>
    </message>
    <message>
        <source>The username is missing.</source>
        <translation>Der Benutzername fehlt.</translation>
    </message>
    <message numerus="yes">
        <source>%n one-time code(s) are shown under School, and kept nowhere else: %1.</source>
        <extracomment>%1: a person, or several</extracomment>
        <translation>
            <numerusform>%n Einmalcode steht unter „Schule“ und sonst nirgends: %1.</numerusform>
            <numerusform>%n Einmalcodes stehen unter „Schule“ und sonst nirgends: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Yes, save it</source>
        <translation>Ja, speichern</translation>
    </message>
    <message>
        <source>Stay an admin</source>
        <translation>Admin bleiben</translation>
    </message>
    <message>
        <source>You would be an admin no longer, and be logged out: save it all the same?</source>
        <translation>Sie wären nicht mehr Admin und würden abgemeldet: trotzdem speichern?</translation>
    </message>
    <message>
        <source>This is your own account. You would be logged out, and could not log in again: disable it?</source>
        <translation>Das ist Ihr eigenes Konto. Sie würden abgemeldet und könnten sich nicht wieder anmelden: sperren?</translation>
    </message>
    <message>
        <source>Yes, disable it</source>
        <translation>Ja, sperren</translation>
    </message>
    <message>
        <source>Somebody else has changed %1 meanwhile. What you have typed stays here.</source>
        <extracomment>%1 is a person</extracomment>
        <translation>Inzwischen hat jemand anders %1 geändert. Was Sie getippt haben, bleibt hier.</translation>
    </message>
    <message>
        <source>One-time code of %1. Tell it now: it is kept nowhere. It is shown here, whenever %1 is chosen, until you log out.</source>
        <translation>Einmalcode von %1. Sagen Sie ihn jetzt: Er wird nirgends aufbewahrt. Bis Sie sich abmelden, steht er hier, sooft Sie %1 wählen.</translation>
    </message>
</context>
<context>
    <name>ui::admin::RosterPart</name>
    <message>
        <source>A class list is a CSV file with the columns username, given_name, family_name, role and class. Role may be left out; several classes are parted by |. Choose it, or drop it here: nothing is entered before you have seen what it would do.</source>
        <translation>Eine Klassenliste ist eine CSV-Datei mit den Spalten username, given_name, family_name, role und class. Die Rolle kann fehlen; mehrere Klassen trennt ein senkrechter Strich. Wählen Sie sie, oder legen Sie sie hier ab: Nichts wird eingetragen, bevor Sie gesehen haben, was geschähe.</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>Enter these people</source>
        <translation>Diese Personen eintragen</translation>
    </message>
    <message>
        <source>Save the one-time codes …</source>
        <translation>Die Einmalcodes speichern …</translation>
    </message>
    <message>
        <source>What the class list would do</source>
        <translation>Was die Klassenliste bewirken würde</translation>
    </message>
    <message>
        <source>%1 was entered: %2 new, %3 known already. The codes below are kept nowhere else.</source>
        <translation>%1 wurde eingetragen: %2 neu, %3 schon bekannt. Die Codes unten stehen sonst nirgends.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Was falsch ist</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>One-time code</source>
        <translation>Einmalcode</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>known</source>
        <translation>bekannt</translation>
    </message>
    <message>
        <source>Choose a class list</source>
        <translation>Eine Klassenliste wählen</translation>
    </message>
    <message>
        <source>Class lists (*.csv);;All files (*)</source>
        <translation>Klassenlisten (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the one-time codes</source>
        <translation>Die Einmalcodes speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>The codes were saved. Delete the file when everybody has logged in.</source>
        <translation>Die Codes wurden gespeichert. Löschen Sie die Datei, wenn sich alle angemeldet haben.</translation>
    </message>
    <message>
        <source>The codes could not be written. Choose another folder, or make room on the disk.</source>
        <translation>Die Codes konnten nicht geschrieben werden. Wählen Sie einen anderen Ordner, oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>Example of a class list</source>
        <translation>Beispiel einer Klassenliste</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>%1 (new)</source>
        <extracomment>%1: a class that would be added</extracomment>
        <translation>%1 (neu)</translation>
    </message>
    <message>
        <source>The one-time codes of %1 are not saved, and they are kept nowhere else.</source>
        <translation>Die Einmalcodes von %1 sind nicht gespeichert, und sie stehen nirgends sonst.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln fault(s). Nothing was entered; mend the file and choose it again.</source>
        <translation>
            <numerusform>%1: %Ln Fehler. Nichts wurde eingetragen; berichtigen Sie die Datei und wählen Sie sie noch einmal.</numerusform>
            <numerusform>%1: %Ln Fehler. Nichts wurde eingetragen; berichtigen Sie die Datei und wählen Sie sie noch einmal.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is nobody in %1: it has only the line that names the columns.</source>
        <translation>In %1 steht niemand: Es gibt nur die Zeile, die die Spalten nennt.</translation>
    </message>
    <message numerus="yes">
        <source>%1 %Ln new person(s) would be entered.</source>
        <extracomment>%1: what another sentence says of how many are known already</extracomment>
        <translation>
            <numerusform>%1 %Ln neue Person würde eingetragen.</numerusform>
            <numerusform>%1 %Ln neue Personen würden eingetragen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln person(s) known already.</source>
        <translation>
            <numerusform>%1: %Ln Person ist schon bekannt.</numerusform>
            <numerusform>%1: %Ln Personen sind schon bekannt.</numerusform>
        </translation>
    </message>
    <message>
        <source>known as %1 so far</source>
        <translation>bisher bekannt als %1</translation>
    </message>
    <message>
        <source>%1 was entered: nobody in it is new.</source>
        <translation>%1 wurde eingetragen: Niemand darin ist neu.</translation>
    </message>
    <message>
        <source>%1; the line has fewer fields than the first</source>
        <extracomment>%1: &quot;new&quot; or &quot;known&quot;, of somebody on a class list</extracomment>
        <translation>%1; die Zeile hat weniger Felder als die erste</translation>
    </message>
    <message>
        <source>These people are being entered …</source>
        <translation>Diese Personen werden eingetragen …</translation>
    </message>
</context>
<context>
    <name>ui::admin::StationPart</name>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>Minutes after which a place that was left is locked</source>
        <translation>Minuten, nach denen ein verlassener Platz gesperrt wird</translation>
    </message>
    <message>
        <source>Drilled with</source>
        <translation>Gebohrt wird mit</translation>
    </message>
    <message>
        <source>Servo loop</source>
        <translation>Regelkreis</translation>
    </message>
    <message>
        <source>Key of this station</source>
        <translation>Schlüssel dieses Platzes</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>Datenbank</translation>
    </message>
    <message>
        <source>On their way</source>
        <translation>Unterwegs</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>%1 times a second</source>
        <translation>%1-mal in der Sekunde</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (pen)</source>
        <translation>%1 (Stift)</translation>
    </message>
    <message>
        <source>a mouse</source>
        <translation>eine Maus</translation>
    </message>
    <message>
        <source>%1 ms in the middle, 99 of 100 within %2 ms</source>
        <extracomment>Times between two servo ticks</extracomment>
        <translation>%1 ms in der Mitte, 99 von 100 höchstens %2 ms</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
    <message>
        <source>Found here</source>
        <translation>Hier gefunden</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Everywhere in the school, a place that was left is locked after</source>
        <translation>In der ganzen Schule wird ein verlassener Platz gesperrt nach</translation>
    </message>
</context>
<context>
    <name>ui::charts::ChartPanel</name>
    <message>
        <source>Save as picture (PNG) …</source>
        <translation>Als Bild speichern (PNG) …</translation>
    </message>
    <message>
        <source>Save as drawing (SVG) …</source>
        <translation>Als Zeichnung speichern (SVG) …</translation>
    </message>
    <message>
        <source>Save as table (CSV) …</source>
        <translation>Als Tabelle speichern (CSV) …</translation>
    </message>
    <message>
        <source>Save this chart</source>
        <translation>Dieses Diagramm speichern</translation>
    </message>
    <message>
        <source>Save the chart &quot;%1&quot;</source>
        <translation>Das Diagramm „%1“ speichern</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>Diagramm speichern</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>%1 could not be written (%2). Try another folder.</source>
        <extracomment>%2: the system&apos;s own words</extracomment>
        <translation>%1 konnte nicht geschrieben werden (%2). Versuchen Sie einen anderen Ordner.</translation>
    </message>
</context>
<context>
    <name>ui::charts::Table</name>
    <message>
        <source>series</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>class, lower quartile</source>
        <translation>Klasse, unteres Quartil</translation>
    </message>
    <message>
        <source>class, median</source>
        <translation>Klasse, Median</translation>
    </message>
    <message>
        <source>class, upper quartile</source>
        <translation>Klasse, oberes Quartil</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
</context>
<context>
    <name>ui::console::Console</name>
    <message>
        <source>Console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>Answers of the console</source>
        <translation>Antworten der Konsole</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Type a command; Tab completes, &quot;help&quot; explains</source>
        <translation>Geben Sie einen Befehl ein; Tab vervollständigt, „help“ erklärt</translation>
    </message>
    <message>
        <source>Parameters can be looked at and turned here while you drill. &quot;help&quot; lists the commands.</source>
        <translation>Hier können Sie Parameter ansehen und verstellen, während Sie bohren. „help“ zeigt die Befehle.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; wants a name behind it.</source>
        <translation>Hinter „%1“ fehlt ein Name.</translation>
    </message>
    <message>
        <source>Write &quot;set NAME VALUE&quot;, as in &quot;set force.stiffness 1.5&quot;.</source>
        <translation>Schreiben Sie „set NAME WERT“, etwa „set force.stiffness 1.5“.</translation>
    </message>
    <message>
        <source>Presets are not to be had here.</source>
        <translation>Voreinstellungen gibt es hier nicht.</translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;. &quot;help&quot; lists those there are.</source>
        <translation>Den Befehl „%1“ gibt es nicht. „help“ zeigt alle.</translation>
    </message>
    <message>
        <source>No parameter&apos;s name holds &quot;%1&quot;.</source>
        <translation>In keinem Namen eines Parameters kommt „%1“ vor.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>All that is felt is as the preset says.</source>
        <translation>Alles, was man fühlt, ist wieder wie in der Voreinstellung.</translation>
    </message>
    <message>
        <source>There is room for %1. Take one away with &quot;unwatch NAME&quot;.</source>
        <translation>Es ist Platz für %1. Nehmen Sie mit „unwatch NAME“ etwas weg.</translation>
    </message>
    <message>
        <source>Page Up and Page Down turn over the answers, Up and Down what was typed.</source>
        <translation>Bild auf und Bild ab blättern in den Antworten, Auf und Ab in dem, was getippt wurde.</translation>
    </message>
    <message>
        <source>Write &quot;export NAME FILE&quot;, as in &quot;export live.force force.csv&quot;.</source>
        <translation>Schreiben Sie „export NAME DATEI“, etwa „export live.force force.csv“.</translation>
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
        <translation>list [TEXT]      die Parameter, in deren Namen der Text vorkommt
get NAME         Wert, Bereich und Wirkung
set NAME WERT    stellt ihn ein
reset [NAME]     setzt ihn oder alles, was man fühlt, zurück
watch NAME       zeigt ihn über der Ansicht
plot NAME        zeichnet seine letzten zehn Sekunden über die Ansicht
export NAME DATEI speichert das Gezeichnete: .csv, .svg oder .png
unwatch [NAME]   nimmt ihn oder alles wieder weg
save NAME        behält, was man fühlt, als Härte-Voreinstellung
load NAME        lässt eine behaltene Härte-Voreinstellung fühlen</translation>
    </message>
    <message>
        <source>%1 is not plotted. &quot;plot %1&quot; begins it; then it can be saved.</source>
        <translation>%1 wird nicht gezeichnet. „plot %1“ beginnt damit; dann lässt es sich speichern.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>There is a file %1 already; choose another name.</source>
        <translation>Es gibt schon eine Datei %1; wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>ui::console::WatchPanel</name>
    <message>
        <source>Seconds before now</source>
        <translation>Sekunden vor jetzt</translation>
    </message>
</context>
<context>
    <name>ui::console::Words</name>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>a live value, to be read, watched or plotted</source>
        <translation>ein laufender Wert, zum Lesen, Beobachten oder Zeichnen</translation>
    </message>
    <message>
        <source>0 (off) or 1 (on)</source>
        <translation>0 (aus) oder 1 (an)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <extracomment>%1 and %2 are numbers, %2 with a unit</extracomment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>There is no parameter &quot;%1&quot;. Type &quot;list&quot; for those there are.</source>
        <translation>Den Parameter „%1“ gibt es nicht. „list“ zeigt alle.</translation>
    </message>
    <message>
        <source>%1 is a live value: it can be watched and plotted, not set.</source>
        <translation>%1 ist ein laufender Wert: Man kann ihn beobachten und zeichnen, aber nicht einstellen.</translation>
    </message>
    <message>
        <source>%1 takes %2.</source>
        <translation>%1 nimmt %2 an.</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>Live values</source>
        <translation>Laufende Werte</translation>
    </message>
    <message>
        <source>This cannot be changed here and now.</source>
        <translation>Das lässt sich hier und jetzt nicht ändern.</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>How hard the mouse button presses the bur against the tooth.</source>
        <translation>Wie fest die Maustaste den Bohrer gegen den Zahn drückt.</translation>
    </message>
    <message>
        <source>Force that the hand is given.</source>
        <translation>Kraft, die die Hand bekommt.</translation>
    </message>
    <message>
        <source>Depth of the bur&apos;s tip below the uncut surface.</source>
        <translation>Tiefe der Bohrerspitze unter der unbearbeiteten Oberfläche.</translation>
    </message>
    <message>
        <source>Volume removed since the tooth was taken, undone or not.</source>
        <translation>Abgetragenes Volumen, seit der Zahn auf dem Tisch liegt, auch wenn es rückgängig gemacht wurde.</translation>
    </message>
    <message>
        <source>Turns of the bur under its load.</source>
        <translation>Drehzahl des Bohrers unter Last.</translation>
    </message>
    <message>
        <source>Periods of the servo that were missed since the start.</source>
        <translation>Takte der Regelung, die seit dem Start versäumt wurden.</translation>
    </message>
    <message>
        <source>Time between two ticks of the servo: half of the last second&apos;s were shorter.</source>
        <translation>Zeit zwischen zwei Takten der Regelung: Die Hälfte in der letzten Sekunde war kürzer.</translation>
    </message>
    <message>
        <source>Time between two ticks of the servo: 99 in 100 of the last second&apos;s were shorter.</source>
        <translation>Zeit zwischen zwei Takten der Regelung: 99 von 100 in der letzten Sekunde waren kürzer.</translation>
    </message>
    <message>
        <source>A blind comparison of two presets is running, so their values are hidden. &quot;End the comparison&quot; beside the tooth ends it.</source>
        <translation>Ein Blindvergleich zweier Voreinstellungen läuft, deshalb sind ihre Werte verborgen. „Vergleich beenden“ neben dem Zahn beendet ihn.</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>How fast the bur goes down at most while you press.</source>
        <translation>Wie schnell der Bohrer höchstens nach unten geht, während Sie drücken.</translation>
    </message>
</context>
<context>
    <name>ui::devices::ButtonLights</name>
    <message>
        <source>No grip button is pressed</source>
        <translation>Keine Taste am Griff ist gedrückt</translation>
    </message>
    <message>
        <source>Pressed: %1</source>
        <translation>Gedrückt: %1</translation>
    </message>
</context>
<context>
    <name>ui::devices::DevicesPage</name>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Loading the firmware</source>
        <translation>Die Firmware wird geladen</translation>
    </message>
    <message>
        <source>Pull the grip out of the device as far as it goes, then push it straight in.</source>
        <extracomment>Of the grip of a force device</extracomment>
        <translation>Ziehen Sie den Griff so weit wie möglich aus dem Gerät heraus und schieben Sie ihn dann gerade hinein.</translation>
    </message>
    <message>
        <source>Each arm has to pass its index mark. If no ring fills, check that the mains adapter is plugged in.</source>
        <translation>Jeder Arm muss an seiner Indexmarke vorbei. Füllt sich kein Ring, prüfen Sie, ob das Netzteil eingesteckt ist.</translation>
    </message>
    <message>
        <source>Mouse or pen</source>
        <translation>Maus oder Stift</translation>
    </message>
    <message>
        <source>Simulated hand</source>
        <translation>Simulierte Hand</translation>
    </message>
    <message>
        <source>Always ready.</source>
        <translation>Immer bereit.</translation>
    </message>
    <message>
        <source>Drills by itself while you watch.</source>
        <translation>Bohrt selbst, während Sie zusehen.</translation>
    </message>
    <message>
        <source>The bur follows the pointer over the tooth and goes down while you press the button. You feel no force. Feed, depth stop and force are set beside the tooth.</source>
        <translation>Der Bohrer folgt dem Zeiger über den Zahn und geht hinunter, solange Sie die Taste drücken. Sie fühlen keine Kraft. Vorschub, Tiefenanschlag und Kraft stellen Sie neben dem Zahn ein.</translation>
    </message>
    <message>
        <source>A simulated hand with a simulated force device cuts the ideal preparation. When you start or leave it, the attempt begins anew. Its attempts are not saved.</source>
        <translation>Eine simulierte Hand mit einem simulierten Kraftgerät schneidet die ideale Präparation. Wenn Sie sie starten oder verlassen, beginnt der Versuch neu. Ihre Versuche werden nicht gespeichert.</translation>
    </message>
    <message>
        <source>Serial number %1.</source>
        <extracomment>%1: the number of a device</extracomment>
        <translation>Seriennummer %1.</translation>
    </message>
    <message>
        <source>Practise</source>
        <extracomment>The button that leads back to the tooth</extracomment>
        <translation>Üben</translation>
    </message>
    <message>
        <source>Use: %1</source>
        <translation>Verwenden: %1</translation>
    </message>
    <message>
        <source>Another one is plugged in too. To use that one, unplug this one.</source>
        <translation>Ein weiteres ist ebenfalls angeschlossen. Um jenes zu verwenden, ziehen Sie dieses ab.</translation>
    </message>
    <message>
        <source>Head tracking</source>
        <translation>Kopfverfolgung</translation>
    </message>
    <message>
        <source>Pedal and gamepad</source>
        <translation>Pedal und Gamepad</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Hand and rest</source>
        <extracomment>A button that opens a guide: which hand works, and where it rests</extracomment>
        <translation>Hand und Auflage</translation>
    </message>
</context>
<context>
    <name>ui::devices::FirmwareCard</name>
    <message>
        <source>Firmware file</source>
        <translation>Firmware-Datei</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>Choose the firmware file</source>
        <translation>Firmware-Datei wählen</translation>
    </message>
    <message>
        <source>None is chosen.</source>
        <translation>Es ist keine gewählt.</translation>
    </message>
    <message>
        <source>Unknown firmware, SHA-256 %1</source>
        <translation>Unbekannte Firmware, SHA-256 %1</translation>
    </message>
    <message>
        <source>Firmware (*.bin *.BIN);;All files (*)</source>
        <translation>Firmware (*.bin *.BIN);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>ui::devices::ForceTest</name>
    <message>
        <source>Away</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hinauf</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Towards you</source>
        <translation>Zu Ihnen</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Hinunter</translation>
    </message>
    <message>
        <source>Push the hand: %1</source>
        <extracomment>%1: a direction, such as &quot;Left&quot;</extracomment>
        <translation>Hand schieben: %1</translation>
    </message>
</context>
<context>
    <name>ui::devices::HandList</name>
    <message>
        <source>Chosen</source>
        <translation>Gewählt</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>%1, chosen</source>
        <translation>%1, gewählt</translation>
    </message>
</context>
<context>
    <name>ui::devices::HeadTrackingCard</name>
    <message>
        <source>Follow my head</source>
        <translation>Meinem Kopf folgen</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <extracomment>Of a picture: it looks like a mirror</extracomment>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>Straight ahead is here</source>
        <translation>Hier ist geradeaus</translation>
    </message>
    <message>
        <source>No picture is saved or sent.</source>
        <translation>Kein Bild wird gespeichert oder gesendet.</translation>
    </message>
    <message>
        <source>The picture of the camera appears here when head tracking is on.</source>
        <translation>Hier erscheint das Bild der Kamera, wenn die Kopfverfolgung eingeschaltet ist.</translation>
    </message>
</context>
<context>
    <name>ui::devices::HomingMarks</name>
    <message numerus="yes">
        <source>%n of 3 arms homed</source>
        <translation>
            <numerusform>%n von 3 Armen referenziert</numerusform>
            <numerusform>%n von 3 Armen referenziert</numerusform>
        </translation>
    </message>
    <message>
        <source>Top arm</source>
        <translation>Oberer Arm</translation>
    </message>
    <message>
        <source>Right arm</source>
        <translation>Rechter Arm</translation>
    </message>
    <message>
        <source>Left arm</source>
        <translation>Linker Arm</translation>
    </message>
</context>
<context>
    <name>ui::devices::IntervalChart</name>
    <message>
        <source>Intervals between answers</source>
        <translation>Abstände zwischen Antworten</translation>
    </message>
    <message>
        <source>Number of answers in the last second for each interval. The last bar contains all longer intervals. The height is logarithmic, so that a single late answer is visible.</source>
        <translation>Wie viele Antworten der letzten Sekunde nach welchem Abstand kamen. Der letzte Balken hat alle längeren. Die Höhe wächst mit dem Logarithmus, damit man auch eine einzelne späte Antwort sieht.</translation>
    </message>
    <message>
        <source>%1 answers in a second</source>
        <translation>%1 Antworten in einer Sekunde</translation>
    </message>
</context>
<context>
    <name>ui::devices::LiveTest</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Grip buttons</source>
        <translation>Tasten am Griff</translation>
    </message>
    <message>
        <source>Force: hold a button, and the device pushes your hand gently</source>
        <translation>Kraft: Halten Sie eine Taste gedrückt, und das Gerät schiebt Ihre Hand sanft</translation>
    </message>
    <message>
        <source>Intervals between answers</source>
        <translation>Abstände zwischen Antworten</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Hin und zurück</translation>
    </message>
    <message>
        <source>99 % below</source>
        <extracomment>Of the time from a request to its answer: 99 of 100 are shorter</extracomment>
        <translation>99 % unter</translation>
    </message>
    <message>
        <source>Lost</source>
        <extracomment>Requests without an answer</extracomment>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Rejected</source>
        <extracomment>Answers that were not plausible</extracomment>
        <translation>Verworfen</translation>
    </message>
</context>
<context>
    <name>ui::devices::PlacementPicture</name>
    <message>
        <source>It stands on its base, and the arms point away from its front.</source>
        <translation>Es steht auf seinem Fuß, und die Arme zeigen von seiner Vorderseite weg.</translation>
    </message>
    <message>
        <source>It lies on its back, and the arms point up.</source>
        <translation>Es liegt auf dem Rücken, und die Arme zeigen nach oben.</translation>
    </message>
    <message>
        <source>It stands at your right hand and faces left.</source>
        <translation>Es steht rechts von Ihnen und schaut nach links.</translation>
    </message>
    <message>
        <source>It stands at your left hand and faces right.</source>
        <translation>Es steht links von Ihnen und schaut nach rechts.</translation>
    </message>
    <message>
        <source>It stands in front of you and faces you.</source>
        <translation>Es steht vor Ihnen und schaut Sie an.</translation>
    </message>
    <message>
        <source>How to place the device</source>
        <translation>So stellen Sie das Gerät auf</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Von der Seite</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
</context>
<context>
    <name>ui::devices::PositionView</name>
    <message>
        <source>Position: %1 mm right, %2 mm away, %3 mm up</source>
        <extracomment>%1, %2, %3: millimetres to the right, away from the user and up</extracomment>
        <translation>Position: %1 mm rechts, %2 mm entfernt, %3 mm oben</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
</context>
<context>
    <name>ui::devices::RuleCard</name>
    <message>
        <source>Copy the rule</source>
        <translation>Regel kopieren</translation>
    </message>
    <message>
        <source>Rule for this device</source>
        <translation>Regel für dieses Gerät</translation>
    </message>
    <message>
        <source>As an administrator, write this rule to the file %1. Then unplug the device and plug it in again. The command &quot;%2&quot; prints the same rule.</source>
        <extracomment>%1: a file; %2: a command</extracomment>
        <translation>Schreiben Sie diese Regel als Administrator in die Datei %1. Ziehen Sie dann das Gerät ab und stecken Sie es wieder ein. Der Befehl „%2“ gibt dieselbe Regel aus.</translation>
    </message>
</context>
<context>
    <name>ui::devices::SetupCard</name>
    <message>
        <source>It stands</source>
        <extracomment>How the device is placed on the table</extracomment>
        <translation>Aufstellung</translation>
    </message>
    <message>
        <source>as sold</source>
        <extracomment>Of a device: on its base, as it was sold</extracomment>
        <translation>wie verkauft</translation>
    </message>
    <message>
        <source>on its back, arms up</source>
        <translation>auf dem Rücken, Arme oben</translation>
    </message>
    <message>
        <source>Place</source>
        <extracomment>Where the device stands, seen by the user</extracomment>
        <translation>Platz</translation>
    </message>
    <message>
        <source>in front of you</source>
        <translation>vor Ihnen</translation>
    </message>
    <message>
        <source>on your right</source>
        <translation>rechts von Ihnen</translation>
    </message>
    <message>
        <source>on your left</source>
        <translation>links von Ihnen</translation>
    </message>
    <message>
        <source>Scale</source>
        <extracomment>How far the hand moves for one millimetre of the bur</extracomment>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Movement of the hand for 1 mm of the bur, in millimetres</source>
        <translation>Bewegung der Hand für 1 mm des Bohrers, in Millimetern</translation>
    </message>
</context>
<context>
    <name>ui::devices::TagSheet</name>
    <message>
        <source>Head tracking: tag %1</source>
        <translation>Kopfverfolgung: Marke %1</translation>
    </message>
    <message>
        <source>Print this on matte paper. Cut a tag out along the dashed line. Do not cut off its white border: without it the tag is not found. Glue the tag to a piece of stiff, flat card.</source>
        <translation>Drucken Sie dies auf mattes Papier. Schneiden Sie eine Marke entlang der gestrichelten Linie aus. Schneiden Sie den weißen Rand nicht ab: Ohne ihn wird die Marke nicht gefunden. Kleben Sie die Marke auf ein Stück steife, ebene Pappe.</translation>
    </message>
    <message>
        <source>Wear the tag on your forehead with the arrow pointing up, tilted by 15 to 25 degrees: its lower edge is nearer to the camera than its upper edge.</source>
        <translation>Tragen Sie die Marke auf der Stirn, mit dem Pfeil nach oben und um 15 bis 25 Grad geneigt: Ihre untere Kante ist näher an der Kamera als die obere.</translation>
    </message>
    <message>
        <source>Tell Cusp the length of the tag&apos;s edge. It stands below the tag and is the side of the black square.</source>
        <translation>Geben Sie in Cusp die Kantenlänge der Marke an. Sie steht unter der Marke und ist die Seite des schwarzen Quadrats.</translation>
    </message>
    <message>
        <source>Tag %1, edge %2 mm</source>
        <translation>Marke %1, Kante %2 mm</translation>
    </message>
    <message>
        <source>The headband: cut it out and cut its two slots. Pull an elastic band, 20 mm wide and about 35 cm long, through the slots.</source>
        <translation>Das Stirnband: Schneiden Sie es und seine zwei Schlitze aus. Ziehen Sie ein Gummiband, 20 mm breit und etwa 35 cm lang, durch die Schlitze.</translation>
    </message>
    <message>
        <source>The wedge: glue it to stiff card, cut it out, fold it along the dotted lines to a triangle, and glue its flap to its foot. Glue it behind the tag, the foot below. It keeps the tag flat and tilts it by 20 degrees.</source>
        <translation>Der Keil: Kleben Sie ihn auf steife Pappe, schneiden Sie ihn aus, falten Sie ihn entlang der gepunkteten Linien zu einem Dreieck und kleben Sie die Lasche an den Fuß. Kleben Sie ihn hinter die Marke, den Fuß nach unten. Er hält die Marke eben und neigt sie um 20 Grad.</translation>
    </message>
    <message>
        <source>Flap</source>
        <translation>Lasche</translation>
    </message>
    <message>
        <source>This side to the forehead</source>
        <translation>Diese Seite zur Stirn</translation>
    </message>
    <message>
        <source>This side to the tag</source>
        <translation>Diese Seite zur Marke</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>Board for the calibration of a camera. Glue it to something stiff and flat. Show it to the camera at many places and tilted to all sides.</source>
        <translation>Tafel für die Kalibrierung einer Kamera. Kleben Sie sie auf etwas Steifes und Ebenes. Zeigen Sie sie der Kamera an vielen Stellen und nach allen Seiten geneigt.</translation>
    </message>
    <message>
        <source>Measure this line: it must be 100 mm long. Otherwise print without scaling (100 %).</source>
        <translation>Messen Sie diese Linie: Sie muss 100 mm lang sein. Sonst drucken Sie ohne Skalierung (100 %).</translation>
    </message>
</context>
<context>
    <name>ui::devices::TagPicture</name>
    <message>
        <source>Picture of the camera, with the tag outlined</source>
        <translation>Bild der Kamera, die Marke ist umrandet</translation>
    </message>
    <message>
        <source>Picture of the camera, without the tag</source>
        <translation>Bild der Kamera, ohne die Marke</translation>
    </message>
</context>
<context>
    <name>ui::devices::TrackingFigures</name>
    <message>
        <source>Pictures per second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>Pictures with the tag</source>
        <extracomment>Share of the pictures in which the tag was found</extracomment>
        <translation>Bilder mit der Marke</translation>
    </message>
    <message>
        <source>Time to find it</source>
        <translation>Suchzeit</translation>
    </message>
    <message>
        <source>Latency</source>
        <extracomment>Time from a picture of the camera to the turn of the view</extracomment>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>Jitter</source>
        <extracomment>How far the measured place of a head at rest moves</extracomment>
        <translation>Zittern</translation>
    </message>
</context>
<context>
    <name>ui::devices::TrackingSetupCard</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Size of its pictures</source>
        <translation>Größe ihrer Bilder</translation>
    </message>
    <message>
        <source>Its field of view, sideways</source>
        <translation>Ihr Bildwinkel, waagerecht</translation>
    </message>
    <message>
        <source>60° fits most cameras. The data sheet of the camera has the exact number.</source>
        <translation>60° passen für die meisten Kameras. Den genauen Wert nennt das Datenblatt der Kamera.</translation>
    </message>
    <message>
        <source>Number of the tag</source>
        <translation>Nummer der Marke</translation>
    </message>
    <message>
        <source>Edge of its black square</source>
        <translation>Kante des schwarzen Quadrats</translation>
    </message>
    <message>
        <source>Turn of the view for 1° of the head</source>
        <translation>Drehung der Ansicht je 1° des Kopfes</translation>
    </message>
    <message>
        <source>Print the tag …</source>
        <translation>Marke drucken …</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <extracomment>%1: a number</extracomment>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>No camera is plugged in</source>
        <translation>Keine Kamera ist angeschlossen</translation>
    </message>
    <message>
        <source>Camera %1, not plugged in</source>
        <extracomment>%1: the number of a camera</extracomment>
        <translation>Kamera %1, nicht angeschlossen</translation>
    </message>
    <message>
        <source>A video file …</source>
        <translation>Eine Videodatei …</translation>
    </message>
    <message>
        <source>Choose a video file</source>
        <translation>Videodatei wählen</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.webm *.ogv);;All files (*)</source>
        <translation>Videos (*.mp4 *.mkv *.avi *.mov *.webm *.ogv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>When the head moves</source>
        <translation>Wenn sich der Kopf bewegt</translation>
    </message>
    <message>
        <source>The tooth turns</source>
        <translation>Der Zahn dreht sich</translation>
    </message>
    <message>
        <source>The screen is a window</source>
        <extracomment>The tooth is seen through the screen as through a window</extracomment>
        <translation>Der Bildschirm ist ein Fenster</translation>
    </message>
    <message>
        <source>Hold the tag %1 mm from the lens</source>
        <extracomment>%1: a length in millimetres</extracomment>
        <translation>Marke %1 mm vor das Objektiv halten</translation>
    </message>
    <message>
        <source>Measure the field of view</source>
        <translation>Bildwinkel messen</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>Its lens</source>
        <translation>Ihr Objektiv</translation>
    </message>
    <message>
        <source>By its field of view</source>
        <translation>Nach dem Bildwinkel</translation>
    </message>
    <message>
        <source>A calibration file …</source>
        <translation>Eine Kalibrierdatei …</translation>
    </message>
    <message>
        <source>A folder of images …</source>
        <translation>Ein Ordner mit Bildern …</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Ordner mit Bildern wählen</translation>
    </message>
    <message>
        <source>Choose a calibration of the camera</source>
        <translation>Kalibrierung der Kamera wählen</translation>
    </message>
    <message>
        <source>Calibrations (*.json);;All files (*)</source>
        <translation>Kalibrierungen (*.json);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>ui::devices::TrackingText</name>
    <message>
        <source>Not available: head tracking is left out of this program.</source>
        <translation>Nicht verfügbar: Dieses Programm enthält keine Kopfverfolgung.</translation>
    </message>
    <message>
        <source>Off.</source>
        <extracomment>Of head tracking</extracomment>
        <translation>Aus.</translation>
    </message>
    <message>
        <source>The camera is being opened.</source>
        <translation>Die Kamera wird geöffnet.</translation>
    </message>
    <message>
        <source>The camera sends no pictures.</source>
        <translation>Die Kamera sendet keine Bilder.</translation>
    </message>
    <message>
        <source>The pictures are dark.</source>
        <translation>Die Bilder sind dunkel.</translation>
    </message>
    <message>
        <source>The pictures do not change.</source>
        <translation>Die Bilder ändern sich nicht.</translation>
    </message>
    <message>
        <source>Several tags with the number %1 are in the picture.</source>
        <extracomment>%1: a number</extracomment>
        <translation>Mehrere Marken mit der Nummer %1 sind im Bild.</translation>
    </message>
    <message>
        <source>The view follows your head.</source>
        <translation>Die Ansicht folgt Ihrem Kopf.</translation>
    </message>
    <message>
        <source>The tag is not in the picture.</source>
        <translation>Die Marke ist nicht im Bild.</translation>
    </message>
    <message>
        <source>Install the libraries AprilTag and OpenCV and build Cusp again, or use a package that has them. The mouse turns the view without them.</source>
        <translation>Installieren Sie die Bibliotheken AprilTag und OpenCV und bauen Sie Cusp neu, oder verwenden Sie ein Paket, das sie enthält. Die Maus dreht die Ansicht auch ohne sie.</translation>
    </message>
    <message>
        <source>The view turns when you move your head. Print the tag, glue it to stiff card and wear it on a headband, tilted by about 20°. Then turn on “Follow my head”.</source>
        <translation>Die Ansicht dreht sich, wenn Sie den Kopf bewegen. Drucken Sie die Marke, kleben Sie sie auf festen Karton und tragen Sie sie an einem Stirnband, um etwa 20° geneigt. Schalten Sie dann „Meinem Kopf folgen“ ein.</translation>
    </message>
    <message>
        <source>This takes a few seconds at most.</source>
        <translation>Das dauert höchstens ein paar Sekunden.</translation>
    </message>
    <message>
        <source>%1 Cusp tries again by itself. The mouse turns the view meanwhile.</source>
        <extracomment>%1: what went wrong and what to do, one or two sentences</extracomment>
        <translation>%1 Cusp versucht es von selbst wieder. Inzwischen dreht die Maus die Ansicht.</translation>
    </message>
    <message>
        <source>Turn on more light, and check that no cover is in front of the camera.</source>
        <translation>Schalten Sie mehr Licht ein und prüfen Sie, dass keine Abdeckung vor der Kamera ist.</translation>
    </message>
    <message>
        <source>Unplug the camera and plug it in again, or choose another one.</source>
        <translation>Ziehen Sie die Kamera ab und stecken Sie sie wieder ein, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>The view follows the largest one. Take the others out of the picture.</source>
        <translation>Die Ansicht folgt der größten. Nehmen Sie die anderen aus dem Bild.</translation>
    </message>
    <message>
        <source>Sit as you do when you drill, look at the screen, and press “Straight ahead is here”.</source>
        <translation>Setzen Sie sich wie beim Präparieren, schauen Sie auf den Bildschirm und drücken Sie „Hier ist geradeaus“.</translation>
    </message>
    <message>
        <source>Turn to the camera so that the whole tag and its white border are in the picture. The tag must have the number %1. A lamp or a window behind you makes it too dark.</source>
        <extracomment>%1: a number; the button &quot;Print the tag …&quot; is on the same page</extracomment>
        <translation>Wenden Sie sich der Kamera zu, sodass die ganze Marke mit ihrem weißen Rand im Bild ist. Die Marke muss die Nummer %1 haben. Eine Lampe oder ein Fenster hinter Ihnen macht sie zu dunkel.</translation>
    </message>
    <message>
        <source>The pictures are being opened.</source>
        <translation>Die Bilder werden geöffnet.</translation>
    </message>
    <message>
        <source>The pictures cannot be read.</source>
        <translation>Die Bilder können nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The last picture has been shown.</source>
        <translation>Das letzte Bild wurde gezeigt.</translation>
    </message>
    <message>
        <source>To see the pictures again, turn “Follow my head” off and on.</source>
        <translation>Um die Bilder noch einmal zu sehen, schalten Sie „Meinem Kopf folgen“ aus und wieder ein.</translation>
    </message>
    <message>
        <source>Choose other pictures, or a camera.</source>
        <translation>Wählen Sie andere Bilder oder eine Kamera.</translation>
    </message>
    <message>
        <source>The pictures are nearly white.</source>
        <translation>Die Bilder sind fast weiß.</translation>
    </message>
    <message>
        <source>Turn the camera away from lamps and windows, or lower its exposure.</source>
        <translation>Drehen Sie die Kamera von Lampen und Fenstern weg oder verringern Sie ihre Belichtung.</translation>
    </message>
    <message>
        <source>The camera gives %1 pictures a second, not %2: in little light it exposes for longer. Turn on more light, or choose smaller pictures.</source>
        <extracomment>%1 and %2: numbers</extracomment>
        <translation>Die Kamera liefert %1 Bilder in der Sekunde statt %2: Bei wenig Licht belichtet sie länger. Schalten Sie mehr Licht ein oder wählen Sie kleinere Bilder.</translation>
    </message>
</context>
<context>
    <name>ui::devices::Words</name>
    <message>
        <source>Not available: this program was built without force devices.</source>
        <translation>Nicht verfügbar: Dieses Programm wurde ohne Kraftgeräte gebaut.</translation>
    </message>
    <message>
        <source>Not plugged in.</source>
        <translation>Nicht eingesteckt.</translation>
    </message>
    <message>
        <source>Plugged in, but you are not allowed to open it.</source>
        <translation>Eingesteckt, aber Sie dürfen es nicht öffnen.</translation>
    </message>
    <message>
        <source>Plugged in, but it cannot be opened.</source>
        <translation>Eingesteckt, lässt sich aber nicht öffnen.</translation>
    </message>
    <message>
        <source>Plugged in. It needs its firmware file.</source>
        <translation>Eingesteckt. Es braucht seine Firmware-Datei.</translation>
    </message>
    <message>
        <source>Loading the firmware: %1 %.</source>
        <extracomment>%1: a number from 0 to 100</extracomment>
        <translation>Die Firmware wird geladen: %1 %.</translation>
    </message>
    <message>
        <source>Plugged in. Move the grip to home it.</source>
        <translation>Eingesteckt. Bewegen Sie den Griff, um es zu referenzieren.</translation>
    </message>
    <message>
        <source>Ready.</source>
        <translation>Bereit.</translation>
    </message>
    <message>
        <source>It does not respond. The force is off.</source>
        <translation>Es antwortet nicht. Die Kraft ist aus.</translation>
    </message>
    <message>
        <source>Install the library libusb and build Cusp again, or use a package that has it.</source>
        <translation>Installieren Sie die Bibliothek libusb und bauen Sie Cusp neu, oder verwenden Sie ein Paket, das sie enthält.</translation>
    </message>
    <message>
        <source>Plug in the USB cable and the mains adapter. The device is found by itself.</source>
        <translation>Stecken Sie das USB-Kabel und das Netzteil ein. Das Gerät wird von selbst gefunden.</translation>
    </message>
    <message>
        <source>The firmware came with the software of the device and may not be shipped with Cusp.</source>
        <translation>Die Firmware kam mit der Software des Geräts und darf mit Cusp nicht ausgeliefert werden.</translation>
    </message>
    <message>
        <source>Check both plugs. The device continues by itself when it responds again.</source>
        <translation>Prüfen Sie beide Stecker. Das Gerät macht von selbst weiter, wenn es wieder antwortet.</translation>
    </message>
    <message>
        <source>The last problem, which is over: %1</source>
        <extracomment>%1: what went wrong, a sentence</extracomment>
        <translation>Das letzte Problem, inzwischen behoben: %1</translation>
    </message>
    <message>
        <source>Drill</source>
        <extracomment>A button on the grip of a force device; pressed, the bur turns</extracomment>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Undo</source>
        <extracomment>A button on the grip of a force device</extracomment>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Mirror</source>
        <extracomment>A button on the grip of a force device: the dental mirror</extracomment>
        <translation>Spiegel</translation>
    </message>
    <message>
        <source>Centre</source>
        <extracomment>A button on the grip of a force device: back over the tooth</extracomment>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>The calibration in %1 cannot be used, so the usual values are. Calibrate the device again.</source>
        <extracomment>%1: a path</extracomment>
        <translation>Die Kalibrierung in %1 ist unbrauchbar; es gelten die üblichen Werte. Kalibrieren Sie das Gerät neu.</translation>
    </message>
</context>
<context>
    <name>ui::inside::SectionView</name>
    <message>
        <source>Section through the bur</source>
        <translation>Schnitt durch den Bohrer</translation>
    </message>
    <message>
        <source>Picture of the section</source>
        <translation>Bild des Schnitts</translation>
    </message>
    <message>
        <source>Cut the tooth in this direction, through the bur</source>
        <translation>Den Zahn in dieser Richtung durch den Bohrer schneiden</translation>
    </message>
    <message>
        <source>Section along y</source>
        <translation>Schnitt entlang y</translation>
    </message>
    <message>
        <source>Section along x</source>
        <translation>Schnitt entlang x</translation>
    </message>
    <message>
        <source>Angle of the section, degrees</source>
        <translation>Winkel des Schnitts, Grad</translation>
    </message>
    <message>
        <source>Turn the section about the bur (Shift+X: by 15 degrees)</source>
        <translation>Den Schnitt um den Bohrer drehen (Umschalt+X: um 15 Grad)</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>Depth below original surface</source>
        <translation>Tiefe unter Originalfläche</translation>
    </message>
    <message>
        <source>Vertical depth of the tip below the original surface.</source>
        <translation>Senkrechte Tiefe der Spitze unter der ursprünglichen Oberfläche.</translation>
    </message>
    <message>
        <source>Dentin left over the pulp</source>
        <translation>Dentin über der Pulpa</translation>
    </message>
    <message>
        <source>Sound dentin between the cut and the pulp straight below the tip. A dash: no pulp there.</source>
        <translation>Gesundes Dentin zwischen Schnitt und Pulpa, senkrecht unter der Spitze. Ein Strich: dort liegt keine Pulpa.</translation>
    </message>
    <message>
        <source>Straight down from the tip of the bur. A dash: no pulp there.</source>
        <translation>Von der Bohrerspitze senkrecht nach unten. Ein Strich: dort liegt keine Pulpa.</translation>
    </message>
    <message>
        <source>The shortest way in any direction, also out of the plane of the picture.</source>
        <translation>Der kürzeste Weg in irgendeiner Richtung, auch aus der Bildebene heraus.</translation>
    </message>
    <message>
        <source>Section: %1</source>
        <translation>Schnitt: %1</translation>
    </message>
    <message>
        <source>Tip straight down to the pulp</source>
        <translation>Spitze bis Pulpa, senkrecht</translation>
    </message>
    <message>
        <source>Bur to the nearest pulp</source>
        <translation>Bohrer bis nächste Pulpa</translation>
    </message>
</context>
<context>
    <name>ui::inside::XrayPage</name>
    <message>
        <source>X-ray</source>
        <translation>Röntgen</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>One tooth</source>
        <translation>Ein Zahn</translation>
    </message>
    <message>
        <source>The whole tooth with its root</source>
        <translation>Der ganze Zahn mit Wurzel</translation>
    </message>
    <message>
        <source>Bitewing</source>
        <translation>Bissflügel</translation>
    </message>
    <message>
        <source>Beam from the side</source>
        <translation>Strahl von der Seite</translation>
    </message>
    <message>
        <source>Turns the beam about the tooth</source>
        <translation>Dreht den Strahl um den Zahn</translation>
    </message>
    <message>
        <source>Beam from above</source>
        <translation>Strahl von oben</translation>
    </message>
    <message>
        <source>Tilts the beam; 0 is level</source>
        <translation>Neigt den Strahl; 0 ist waagrecht</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>More radiation: a darker film with less grain</source>
        <translation>Mehr Strahlung: ein dunklerer Film mit weniger Rauschen</translation>
    </message>
    <message>
        <source>Simulated: a parallel beam, no scatter, no bone and no gums.</source>
        <translation>Simuliert: paralleler Strahl, ohne Streuung, Knochen und Zahnfleisch.</translation>
    </message>
    <message>
        <source>Save the picture …</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Save both films side by side as a PNG file</source>
        <translation>Beide Filme nebeneinander als PNG-Datei speichern</translation>
    </message>
    <message>
        <source>X-ray: %1</source>
        <extracomment>%1 is &quot;Tooth 36&quot; or a file name</extracomment>
        <translation>Röntgen: %1</translation>
    </message>
    <message>
        <source>The crown between two sound neighbours made by Cusp, with contact points.</source>
        <translation>Die Krone zwischen zwei gesunden Nachbarzähnen von Cusp, mit Kontaktpunkten.</translation>
    </message>
    <message>
        <source>Nothing in a scan says which side is mesial, so it gets no neighbours.</source>
        <translation>Ein Scan sagt nicht, welche Seite mesial ist; darum bekommt er keine Nachbarn.</translation>
    </message>
    <message>
        <source>This tooth lies on a side, so it gets no neighbours.</source>
        <translation>Dieser Zahn liegt auf der Seite; darum bekommt er keine Nachbarn.</translation>
    </message>
</context>
<context>
    <name>ui::people::AssignPage</name>
    <message>
        <source>Assign version %1 to new attempts</source>
        <translation>Fassung %1 für neue Versuche aufgeben</translation>
    </message>
    <message>
        <source>Assign the changed lesson to new attempts</source>
        <translation>Geänderte Lektion für neue Versuche aufgeben</translation>
    </message>
    <message numerus="yes">
        <source>Assign %n changed lesson(s) to new attempts</source>
        <translation>
            <numerusform>%n geänderte Lektion für neue Versuche aufgeben</numerusform>
            <numerusform>%n geänderte Lektionen für neue Versuche aufgeben</numerusform>
        </translation>
    </message>
    <message>
        <source>Attempts that have been begun, and scores so far, stay with the version they were made with.</source>
        <translation>Begonnene Versuche und bisherige Ergebnisse bleiben bei der Fassung, mit der sie gemacht wurden.</translation>
    </message>
    <message>
        <source>%1 (a later version is available)</source>
        <translation>%1 (es gibt eine spätere Fassung)</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <translation>%1, Fassung %2</translation>
    </message>
    <message>
        <source>given</source>
        <translation>aufgegeben</translation>
    </message>
    <message>
        <source>given, due %1</source>
        <translation>aufgegeben, fällig: %1</translation>
    </message>
    <message>
        <source>%1, over</source>
        <translation>%1, vorbei</translation>
    </message>
    <message>
        <source>There is no day when it is due</source>
        <translation>Es gibt keinen Tag, an dem sie fällig ist</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>%1 of %2 students</extracomment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2 have passed, %3 have tried</source>
        <translation>%1 von %2 bestanden, %3 haben es versucht</translation>
    </message>
    <message>
        <source>That was undone.</source>
        <translation>Das wurde rückgängig gemacht.</translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) assigned.</source>
        <translation>
            <numerusform>%n Lektion aufgegeben.</numerusform>
            <numerusform>%n Lektionen aufgegeben.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) taken back; attempts stay.</source>
        <translation>
            <numerusform>%n Lektion zurückgenommen; Versuche bleiben.</numerusform>
            <numerusform>%n Lektionen zurückgenommen; Versuche bleiben.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) changed.</source>
        <translation>
            <numerusform>%n Lektion geändert.</numerusform>
            <numerusform>%n Lektionen geändert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Aufgeben</translation>
    </message>
    <message numerus="yes">
        <source>Assign %n lesson(s)</source>
        <translation>
            <numerusform>%n Lektion aufgeben</numerusform>
            <numerusform>%n Lektionen aufgeben</numerusform>
        </translation>
    </message>
    <message>
        <source>Assign lessons</source>
        <translation>Lektionen aufgeben</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Search: a word, or the number of a tooth</source>
        <translation>Suche: ein Wort oder die Nummer eines Zahns</translation>
    </message>
    <message>
        <source>Search the lessons</source>
        <translation>Lektionen durchsuchen</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Suche leeren</translation>
    </message>
    <message>
        <source>Lessons to assign</source>
        <translation>Lektionen zum Aufgeben</translation>
    </message>
    <message>
        <source>What %1 is to do</source>
        <extracomment>%1: name of a class</extracomment>
        <translation>Was %1 zu tun hat</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>Fällig</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Nothing is assigned yet. Tick lessons on the left, say when they are due, and assign them; here you will see how many have passed.</source>
        <translation>Noch ist nichts aufgegeben. Haken Sie links Lektionen an, sagen Sie, wann sie fällig sind, und geben Sie sie auf; hier sehen Sie dann, wie viele bestanden haben.</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Change due date and attempts of the chosen lessons</source>
        <translation>Fälligkeit und Versuche der gewählten Lektionen ändern</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Take the chosen lessons back</source>
        <translation>Die gewählten Lektionen zurücknehmen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) who have not passed have no attempts left: earlier ones count.</source>
        <translation>
            <numerusform>%n Person, die noch nicht bestanden hat, hat keinen Versuch mehr: Frühere zählen mit.</numerusform>
            <numerusform>%n Personen, die noch nicht bestanden haben, haben keinen Versuch mehr: Frühere zählen mit.</numerusform>
        </translation>
    </message>
    <message>
        <source>No lesson fits. Search for another word.</source>
        <translation>Keine Lektion passt. Suchen Sie ein anderes Wort.</translation>
    </message>
</context>
<context>
    <name>ui::people::AssignTerms</name>
    <message>
        <source>Due on</source>
        <extracomment>A date follows</extracomment>
        <translation>Fällig am</translation>
    </message>
    <message>
        <source>There is a day when it is due</source>
        <translation>Es gibt einen Tag, an dem sie fällig ist</translation>
    </message>
    <message>
        <source>Day when it is due</source>
        <translation>Tag, an dem sie fällig ist</translation>
    </message>
    <message>
        <source>Until the end of this day</source>
        <translation>Bis zum Ende dieses Tages</translation>
    </message>
    <message>
        <source>Attempts</source>
        <extracomment>How often a lesson may be tried; a number follows</extracomment>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Attempts at most</source>
        <translation>Höchstzahl der Versuche</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>The month before</source>
        <translation>Der Monat davor</translation>
    </message>
    <message>
        <source>The next month</source>
        <translation>Der nächste Monat</translation>
    </message>
    <message>
        <source>This day is over: whoever has not passed is late at once.</source>
        <translation>Dieser Tag ist vorbei: Wer noch nicht bestanden hat, ist sofort im Verzug.</translation>
    </message>
    <message>
        <source>Each lesson keeps what you do not change here.</source>
        <translation>Jede Lektion behält, was Sie hier nicht ändern.</translation>
    </message>
</context>
<context>
    <name>ui::people::ClassCharts</name>
    <message>
        <source>Shown when %1 people have tried the lesson, so that nobody can be made out.</source>
        <translation>Zu sehen, sobald %1 Personen die Lektion versucht haben, damit niemand erkennbar ist.</translation>
    </message>
    <message>
        <source>Best score</source>
        <translation>Bestes Ergebnis</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>Studierende</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message numerus="yes">
        <source>Best scores of %n student(s)</source>
        <translation>
            <numerusform>Bestes Ergebnis von %n Person</numerusform>
            <numerusform>Beste Ergebnisse von %n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Learning curve</source>
        <translation>Lernkurve</translation>
    </message>
    <message>
        <source>Of those who made so many attempts</source>
        <translation>Von denen, die so viele Versuche gemacht haben</translation>
    </message>
    <message>
        <source>Lost, % of what it counts</source>
        <translation>Verloren, % des Gewichts</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>%1: the class loses %2 % of its points</source>
        <translation>%1: Die Klasse verliert %2 % der Punkte dafür</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>Schwierigkeit</translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2 points: %n student(s)</source>
        <translation>
            <numerusform>%1 bis %2 Punkte: %n Person</numerusform>
            <numerusform>%1 bis %2 Punkte: %n Studierende</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 passed; first attempts: %3 points</source>
        <translation>%1 von %2 bestanden; erste Versuche: %3 Punkte</translation>
    </message>
    <message>
        <source>%1 of %2 passed, after %3 attempts on the average; first attempts: %4 points</source>
        <translation>%1 von %2 bestanden, im Mittel nach %3 Versuchen; erste Versuche: %4 Punkte</translation>
    </message>
</context>
<context>
    <name>ui::people::ClassModel</name>
    <message numerus="yes">
        <source>%1, of which %n do not match their recordings and do not count</source>
        <translation>
            <numerusform>%1, davon passt %n nicht zu seiner Aufzeichnung und zählt nicht</numerusform>
            <numerusform>%1, davon passen %n nicht zu ihren Aufzeichnungen und zählen nicht</numerusform>
        </translation>
    </message>
    <message>
        <source>stuck</source>
        <extracomment>Of a student</extracomment>
        <translation>kommt nicht weiter</translation>
    </message>
    <message>
        <source>no login</source>
        <translation>nie angemeldet</translation>
    </message>
    <message>
        <source>new</source>
        <extracomment>Of a student who has no attempt yet</extracomment>
        <translation>neu</translation>
    </message>
    <message>
        <source>%1: no attempt yet</source>
        <translation>%1: noch kein Versuch</translation>
    </message>
    <message>
        <source>%1: last attempt %2</source>
        <translation>%1: letzter Versuch %2</translation>
    </message>
    <message>
        <source>%1: not tried</source>
        <translation>%1: nicht versucht</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: best %2, passed, %3, last %4</source>
        <extracomment>%1: student and lesson; %2: points; %3: &quot;4 attempts&quot;; %4: a date</extracomment>
        <translation>%1: bestes Ergebnis %2, bestanden, %3, zuletzt %4</translation>
    </message>
    <message>
        <source>%1: best %2, not passed, %3, last %4</source>
        <translation>%1: bestes Ergebnis %2, nicht bestanden, %3, zuletzt %4</translation>
    </message>
    <message>
        <source>Last</source>
        <extracomment>Column: when the student&apos;s last attempt was</extracomment>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>%1, %2: never logged in</source>
        <translation>%1, %2: nie angemeldet</translation>
    </message>
    <message>
        <source>%1, %2: last login %3</source>
        <translation>%1, %2: zuletzt angemeldet %3</translation>
    </message>
    <message>
        <source>user name</source>
        <translation>Benutzername</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>needs</source>
        <translation>braucht</translation>
    </message>
    <message>
        <source>last login, UTC</source>
        <translation>letzte Anmeldung, UTC</translation>
    </message>
    <message>
        <source>last attempt, UTC</source>
        <translation>letzter Versuch, UTC</translation>
    </message>
    <message>
        <source>%1: best score</source>
        <translation>%1: bestes Ergebnis</translation>
    </message>
    <message>
        <source>%1: attempts</source>
        <translation>%1: Versuche</translation>
    </message>
    <message>
        <source>%1: passed</source>
        <translation>%1: bestanden</translation>
    </message>
    <message>
        <source>late</source>
        <extracomment>Of a student who has not passed a lesson that is overdue</extracomment>
        <translation>überfällig</translation>
    </message>
    <message>
        <source>%1: not tried, and overdue</source>
        <translation>%1: nicht versucht und überfällig</translation>
    </message>
    <message>
        <source>%1: best %2, not passed and overdue, %3, last %4</source>
        <translation>%1: bestes Ergebnis %2, nicht bestanden und überfällig, %3, zuletzt %4</translation>
    </message>
    <message>
        <source>due %1</source>
        <extracomment>%1: a date</extracomment>
        <translation>fällig: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) at most</source>
        <translation>
            <numerusform>höchstens %n Versuch</numerusform>
            <numerusform>höchstens %n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 passed</source>
        <translation>%1 von %2 bestanden</translation>
    </message>
    <message>
        <source>out of tries</source>
        <extracomment>Of a student who has no attempts left at a lesson that they have not passed</extracomment>
        <translation>ohne Versuche</translation>
    </message>
    <message>
        <source>%1: best %2, not passed and no attempts left, %3, last %4</source>
        <translation>%1: bestes Ergebnis %2, nicht bestanden und keine Versuche mehr, %3, zuletzt %4</translation>
    </message>
    <message>
        <source>%1: begun, without a score so far, and no attempts left</source>
        <translation>%1: begonnen, bisher ohne Ergebnis, und keine Versuche mehr</translation>
    </message>
    <message>
        <source>%1: begun, without a score so far, and overdue</source>
        <translation>%1: begonnen, bisher ohne Ergebnis, und überfällig</translation>
    </message>
    <message>
        <source>%1: begun, without a score so far</source>
        <translation>%1: begonnen, bisher ohne Ergebnis</translation>
    </message>
    <message>
        <source>disabled</source>
        <extracomment>Of a student whose account is closed</extracomment>
        <translation>gesperrt</translation>
    </message>
</context>
<context>
    <name>ui::people::ClassPage</name>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1: name of a class; %2: how many students</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1: how many; %2: &quot;stuck&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Show who made three attempts in a row at a lesson without passing, and without getting better by five points</source>
        <translation>Zeigt, wer an einer Lektion drei Versuche hintereinander nicht bestanden hat und nicht um fünf Punkte besser wurde</translation>
    </message>
    <message>
        <source>Show who has never logged in</source>
        <translation>Zeigt, wer sich noch nie angemeldet hat</translation>
    </message>
    <message>
        <source>Show who has logged in and has no graded attempt yet</source>
        <translation>Zeigt, wer sich angemeldet hat und noch keinen bewerteten Versuch hat</translation>
    </message>
    <message>
        <source>Nobody needs you just now</source>
        <translation>Gerade braucht Sie niemand</translation>
    </message>
    <message numerus="yes">
        <source>%n need(s) you:</source>
        <translation>
            <numerusform>%n braucht Sie:</numerusform>
            <numerusform>%n brauchen Sie:</numerusform>
        </translation>
    </message>
    <message>
        <source>Here you will see your classes: who needs you, and how everybody does at every lesson. An administrator gives you a class.</source>
        <translation>Hier sehen Sie Ihre Klassen: wer Sie braucht und wie alle bei jeder Lektion stehen. Eine Klasse gibt Ihnen, wer die Schule verwaltet.</translation>
    </message>
    <message>
        <source>Nobody is in this class yet. Students are entered by an administrator, one by one or from a list.</source>
        <translation>In dieser Klasse ist noch niemand. Studierende trägt ein, wer die Schule verwaltet, einzeln oder aus einer Liste.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>%1 could not be written (%2). Try another folder.</source>
        <translation>%1 konnte nicht geschrieben werden (%2). Versuchen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Save the matrix</source>
        <translation>Matrix speichern</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>How the class does at</source>
        <translation>So steht die Klasse bei</translation>
    </message>
    <message>
        <source>Lesson whose charts are shown</source>
        <translation>Lektion, deren Diagramme zu sehen sind</translation>
    </message>
    <message>
        <source>Best scores, students by lessons</source>
        <translation>Beste Ergebnisse, Studierende nach Lektionen</translation>
    </message>
    <message>
        <source>Assign lessons</source>
        <translation>Lektionen aufgeben</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Save as PDF …</source>
        <translation>Als PDF speichern …</translation>
    </message>
    <message>
        <source>Print …</source>
        <translation>Drucken …</translation>
    </message>
    <message>
        <source>Save the matrix as a table (CSV) …</source>
        <translation>Matrix als Tabelle speichern (CSV) …</translation>
    </message>
    <message>
        <source>Show who has not passed a lesson that is overdue</source>
        <translation>Zeigt, wer eine überfällige Lektion nicht bestanden hat</translation>
    </message>
    <message>
        <source>%1 (%2 of %3 passed)</source>
        <extracomment>%1: a lesson; %2 of the %3 who tried it</extracomment>
        <translation>%1 (%2 von %3 bestanden)</translation>
    </message>
    <message>
        <source>There is no class yet. Make one, and enter its teachers and students: then you see here who needs help, and how everybody does at every lesson.</source>
        <translation>Es gibt noch keine Klasse. Legen Sie eine an und tragen Sie ihre Lehrenden und Studierenden ein: Dann sehen Sie hier, wer Hilfe braucht und wie alle in jeder Lektion stehen.</translation>
    </message>
    <message>
        <source>Nobody is in this class yet. Enter its students, one by one or from a list.</source>
        <translation>In dieser Klasse ist noch niemand. Tragen Sie ihre Studierenden ein, einzeln oder aus einer Liste.</translation>
    </message>
    <message>
        <source>People and classes</source>
        <extracomment>Where people are entered and classes are made</extracomment>
        <translation>Personen und Klassen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1: a class; %2: a lesson</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Show who has no attempts left at a lesson that is not passed. More can be allowed under Assign lessons.</source>
        <translation>Zeigt, wer bei einer nicht bestandenen Lektion keine Versuche mehr hat. Unter „Lektionen aufgeben“ lassen sich weitere erlauben.</translation>
    </message>
    <message>
        <source>Best score of each student; a tick: passed; ▲: overdue, or no attempts left; ⚠: does not match its recording. A heading sorts, once more the other way, then by name. A cell opens the attempts.</source>
        <translation>Bestes Ergebnis jeder Person; ein Haken: bestanden; ▲: überfällig oder keine Versuche mehr; ⚠: passt nicht zur Aufzeichnung. Eine Überschrift sortiert, noch einmal andersherum, dann nach Namen. Eine Zelle öffnet die Versuche.</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Suche leeren</translation>
    </message>
    <message numerus="yes">
        <source>%Ln student(s)</source>
        <translation>
            <numerusform>%Ln Person</numerusform>
            <numerusform>%Ln Studierende</numerusform>
        </translation>
    </message>
    <message>
        <source>Search: a student</source>
        <translation>Suche: eine Person</translation>
    </message>
    <message>
        <source>%1 F5 reads the class again; Cusp tries it every ten seconds, too.</source>
        <extracomment>%1: that a class could not be read, and why</extracomment>
        <translation>%1 F5 liest die Klasse noch einmal; Cusp versucht es auch von selbst alle zehn Sekunden.</translation>
    </message>
    <message>
        <source>The class is being read …</source>
        <translation>Die Klasse wird gelesen …</translation>
    </message>
    <message>
        <source>%1 F5 reads the classes again; Cusp tries it every ten seconds, too.</source>
        <translation>%1 F5 liest die Klassen noch einmal; Cusp versucht es auch von selbst alle zehn Sekunden.</translation>
    </message>
    <message>
        <source>The classes are being read …</source>
        <translation>Die Klassen werden gelesen …</translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryCharts</name>
    <message>
        <source>Attempt %1, %2</source>
        <extracomment>%1: a count; %2: date and time</extracomment>
        <translation>Versuch %1, %2</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>The newest %1 of %2 attempts</source>
        <translation>Die neuesten %1 von %2 Versuchen</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 points, passed</source>
        <translation>%1 Punkte, bestanden</translation>
    </message>
    <message>
        <source>%1 points, not passed</source>
        <translation>%1 Punkte, nicht bestanden</translation>
    </message>
    <message>
        <source>(machine: %1)</source>
        <translation>(Maschine: %1)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: which attempt; %2: what it came to</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Middle half</source>
        <translation>Mittlere Hälfte</translation>
    </message>
    <message>
        <source>Class median</source>
        <translation>Median der Klasse</translation>
    </message>
    <message>
        <source>Attempt %1: median %3, middle half %4 to %5, %2 people</source>
        <extracomment>Of a class; %1: a count of attempts, %2: of people, %3 to %5: points</extracomment>
        <translation>Versuch %1: Median %3, mittlere Hälfte %4 bis %5, %2 Personen</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>After the first graded attempt its score is here, and then how it goes on.</source>
        <translation>Nach dem ersten bewerteten Versuch steht hier sein Ergebnis, und dann, wie es weitergeht.</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>What costs points</source>
        <translation>Was Punkte kostet</translation>
    </message>
    <message numerus="yes">
        <source>Average of the last %n attempt(s)</source>
        <translation>
            <numerusform>Aus %n Versuch</numerusform>
            <numerusform>Mittel der letzten %n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>After the first graded attempt you see here which criterion costs most.</source>
        <translation>Nach dem ersten bewerteten Versuch sehen Sie hier, welches Kriterium am meisten kostet.</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>%1 min</source>
        <extracomment>%1: &quot;12:07&quot;</extracomment>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>After the first graded attempt you see here how long it took.</source>
        <translation>Nach dem ersten bewerteten Versuch sehen Sie hier, wie lange er gedauert hat.</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Höchste</translation>
    </message>
    <message>
        <source>mean %1 N, highest %2 N while cutting</source>
        <translation>im Mittel %1 N, höchstens %2 N beim Schneiden</translation>
    </message>
    <message>
        <source>Newtons</source>
        <translation>Newton</translation>
    </message>
    <message>
        <source>Force while cutting</source>
        <translation>Kraft beim Schneiden</translation>
    </message>
    <message>
        <source>After the first graded attempt you see here how hard the bur was pressed.</source>
        <translation>Nach dem ersten bewerteten Versuch sehen Sie hier, wie stark der Bohrer gedrückt wurde.</translation>
    </message>
    <message>
        <source>%1 in %2 min</source>
        <translation>%1 in %2 min</translation>
    </message>
    <message>
        <source>Class median, time</source>
        <translation>Median der Klasse, Zeit</translation>
    </message>
    <message>
        <source>Class median, points</source>
        <translation>Median der Klasse, Punkte</translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation>Tempo und Genauigkeit</translation>
    </message>
    <message>
        <source>Good and quick is at the top left</source>
        <translation>Gut und schnell ist oben links</translation>
    </message>
    <message>
        <source>After the first graded attempt you see here time against points.</source>
        <translation>Nach dem ersten bewerteten Versuch sehen Sie hier Zeit gegen Punkte.</translation>
    </message>
    <message numerus="yes">
        <source>Of the last %n attempt(s), each in those where it counts</source>
        <translation>
            <numerusform>Des letzten %n Versuchs, soweit es darin zählt</numerusform>
            <numerusform>Der letzten %n Versuche, jedes in denen, wo es zählt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 points lost</source>
        <extracomment>%1: a criterion; %2: a number</extracomment>
        <translation>%1: %2 Punkte verloren</translation>
    </message>
    <message>
        <source>Points lost</source>
        <translation>Verlorene Punkte</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryModel</name>
    <message>
        <source>practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>in doubt</source>
        <translation>fraglich</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>Given by an instructor. The machine&apos;s score: %1</source>
        <translation>Von einer Lehrkraft gegeben. Ergebnis der Maschine: %1</translation>
    </message>
    <message>
        <source>Mean and highest force while cutting</source>
        <translation>Mittlere und höchste Kraft beim Schneiden</translation>
    </message>
    <message>
        <source>%1, given by an instructor; the machine&apos;s score: %2</source>
        <translation>%1, von einer Lehrkraft gegeben; Ergebnis der Maschine: %2</translation>
    </message>
    <message>
        <source>Date</source>
        <extracomment>Column of a table of attempts</extracomment>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Bestanden?</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Force, N</source>
        <extracomment>Newtons</extracomment>
        <translation>Kraft, N</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>read</source>
        <extracomment>Of a teacher&apos;s feedback: to be read yet; not read by the student; read already</extracomment>
        <translation>gelesen</translation>
    </message>
    <message>
        <source>A teacher has written about this attempt or given another score: open its grade to read it</source>
        <translation>Eine Lehrkraft hat zu diesem Versuch geschrieben oder ihm andere Punkte gegeben: öffnen Sie die Bewertung, um es zu lesen</translation>
    </message>
    <message>
        <source>Feedback</source>
        <extracomment>Column of a table of attempts: what a teacher has said</extracomment>
        <translation>Rückmeldung</translation>
    </message>
    <message>
        <source>unread</source>
        <translation>ungelesen</translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryPage</name>
    <message>
        <source>Criteria</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1: a lesson; %2: how many attempts</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>Of this attempt no recording was kept.</source>
        <translation>Von diesem Versuch wurde keine Aufzeichnung behalten.</translation>
    </message>
    <message>
        <source>See again how it was done</source>
        <translation>Noch einmal sehen, wie gearbeitet wurde</translation>
    </message>
    <message>
        <source>Attempts of %1</source>
        <translation>Versuche von %1</translation>
    </message>
    <message>
        <source>Show the attempts at this lesson</source>
        <translation>Die Versuche an dieser Lektion zeigen</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Open grade</source>
        <translation>Bewertung öffnen</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>No attempts yet</source>
        <translation>Noch keine Versuche</translation>
    </message>
    <message>
        <source>%1 has no attempts yet</source>
        <translation>%1 hat noch keine Versuche</translation>
    </message>
    <message>
        <source>Here you will find every attempt that was graded: its score, what cost points, time and force, and how it goes from attempt to attempt. Do a lesson and have it graded.</source>
        <translation>Hier finden Sie jeden bewerteten Versuch: sein Ergebnis, was Punkte kostete, Zeit und Kraft, und wie es von Versuch zu Versuch geht. Machen Sie eine Lektion und lassen Sie sie bewerten.</translation>
    </message>
    <message>
        <source>As soon as an attempt has been graded it is here.</source>
        <translation>Sobald ein Versuch bewertet ist, steht er hier.</translation>
    </message>
    <message>
        <source>Speed</source>
        <extracomment>A chart of speed and accuracy</extracomment>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>%1, begun %2</source>
        <extracomment>%1: an exam; %2: when it was begun</extracomment>
        <translation>%1, begonnen %2</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und noch %n</numerusform>
            <numerusform>und noch %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Exams that have no score: %1</source>
        <translation>Prüfungen ohne Punktzahl: %1</translation>
    </message>
    <message>
        <source>See what cost points, and where</source>
        <translation>Sehen, was Punkte gekostet hat und wo</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>Meine Versuche</translation>
    </message>
    <message>
        <source>See what cost points</source>
        <translation>Sehen, was Punkte gekostet hat</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) wait on this computer, and stand here when the school has them.</source>
        <translation>
            <numerusform>%n Versuch wartet auf diesem Computer und steht hier, sobald die Schule ihn hat.</numerusform>
            <numerusform>%n Versuche warten auf diesem Computer und stehen hier, sobald die Schule sie hat.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::kit::ListTable</name>
    <message>
        <source>Corner of the table</source>
        <translation>Ecke der Tabelle</translation>
    </message>
    <message>
        <source>Sorted by: %1, from the least</source>
        <extracomment>%1: a heading</extracomment>
        <translation>Sortiert nach: %1, vom Kleinsten an</translation>
    </message>
    <message>
        <source>Sorted by: %1, from the most</source>
        <translation>Sortiert nach: %1, vom Größten an</translation>
    </message>
</context>
<context>
    <name>ui::people::LoginPage</name>
    <message>
        <source>Cusp</source>
        <translation>Cusp</translation>
    </message>
    <message>
        <source>Log in to save your attempts.</source>
        <translation>Melden Sie sich an, damit Ihre Versuche gespeichert werden.</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Choose a password</source>
        <translation>Passwort wählen</translation>
    </message>
    <message>
        <source>The one-time code is correct. Choose your own password: at least eight characters.</source>
        <translation>Der Einmalcode ist richtig. Wählen Sie ein eigenes Passwort: mindestens acht Zeichen.</translation>
    </message>
    <message>
        <source>Set the password</source>
        <translation>Passwort festlegen</translation>
    </message>
    <message>
        <source>Welcome to Cusp</source>
        <translation>Willkommen bei Cusp</translation>
    </message>
    <message>
        <source>Create the school</source>
        <translation>Schule anlegen</translation>
    </message>
    <message>
        <source>Locked by %1</source>
        <extracomment>%1: the name a user logs in with</extracomment>
        <translation>Gesperrt von %1</translation>
    </message>
    <message>
        <source>The work in progress is unchanged.</source>
        <translation>Die begonnene Arbeit ist unverändert.</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Switch user</source>
        <translation>Benutzer wechseln</translation>
    </message>
    <message>
        <source>Practise without login</source>
        <translation>Ohne Anmeldung üben</translation>
    </message>
    <message>
        <source>Username</source>
        <translation>Benutzername</translation>
    </message>
    <message>
        <source>Given name</source>
        <translation>Vorname</translation>
    </message>
    <message>
        <source>Family name</source>
        <translation>Nachname</translation>
    </message>
    <message>
        <source>Password or one-time code</source>
        <translation>Passwort oder Einmalcode</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Confirm password</source>
        <translation>Passwort bestätigen</translation>
    </message>
    <message>
        <source>Drill and get a grade; nothing is saved</source>
        <translation>Präparieren und eine Bewertung erhalten; nichts wird gespeichert</translation>
    </message>
    <message>
        <source>The passwords do not match. Type the second one again.</source>
        <translation>Die Passwörter stimmen nicht überein. Geben Sie das zweite noch einmal ein.</translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation>Sprache: %1</translation>
    </message>
    <message>
        <source>Choose the language</source>
        <translation>Sprache wählen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Restore backup (%1)</source>
        <extracomment>%1: day and time</extracomment>
        <translation>Sicherung zurückspielen (%1)</translation>
    </message>
    <message>
        <source>Attempts on this computer that are in no backup are added again. Changes that teachers and admins made after the backup are lost. The current file is kept next to the restored one.</source>
        <translation>Versuche auf diesem Computer, die in keiner Sicherung sind, werden wieder hinzugefügt. Änderungen, die Lehrkräfte und Admins nach der Sicherung gemacht haben, gehen verloren. Die jetzige Datei bleibt neben der wiederhergestellten erhalten.</translation>
    </message>
    <message>
        <source>Change your password</source>
        <translation>Ihr Passwort ändern</translation>
    </message>
    <message>
        <source>At least eight characters.</source>
        <translation>Mindestens acht Zeichen.</translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation>Passwort ändern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <extracomment>Back, without having changed the password</extracomment>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Change my password</source>
        <translation>Mein Passwort ändern</translation>
    </message>
    <message>
        <source>Current password</source>
        <translation>Aktuelles Passwort</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>Neues Passwort</translation>
    </message>
    <message>
        <source>Confirm new password</source>
        <translation>Neues Passwort bestätigen</translation>
    </message>
    <message>
        <source>This name contains invisible characters. Type it again.</source>
        <translation>Dieser Name enthält unsichtbare Zeichen. Geben Sie ihn neu ein.</translation>
    </message>
    <message>
        <source>The school&apos;s database was not found: %1 has no users. Restore the backup below, or create a new school and become its admin.</source>
        <translation>Die Datenbank der Schule wurde nicht gefunden: %1 enthält keine Benutzer. Stellen Sie unten die Sicherung wieder her, oder legen Sie eine neue Schule an, deren Admin Sie werden.</translation>
    </message>
    <message>
        <source>Save the attempt just graded as mine</source>
        <translation>Den eben bewerteten Versuch als meinen speichern</translation>
    </message>
    <message>
        <source>%1: saved for the user who logs in. If the box is not checked, the attempt is not saved.</source>
        <extracomment>%1: a lesson or a tooth</extracomment>
        <translation>%1: wird für die Person gespeichert, die sich anmeldet. Ohne Häkchen wird der Versuch nicht gespeichert.</translation>
    </message>
    <message>
        <source>The work in progress is unchanged, but the exam time keeps running.</source>
        <translation>Die begonnene Arbeit ist unverändert, aber die Prüfungszeit läuft weiter.</translation>
    </message>
    <message>
        <source>Waiting for the school&apos;s database …</source>
        <translation>Warten auf die Datenbank der Schule …</translation>
    </message>
    <message>
        <source>Opening the school&apos;s database …</source>
        <translation>Die Datenbank der Schule wird geöffnet …</translation>
    </message>
    <message>
        <source>A username has 1 to 64 characters: the letters a to z, digits and . _ - @.</source>
        <translation>Ein Benutzername hat 1 bis 64 Zeichen: die Buchstaben a bis z, Ziffern und . _ - @.</translation>
    </message>
    <message>
        <source>Set up a school</source>
        <translation>Schule einrichten</translation>
    </message>
    <message>
        <source>Drill a virtual tooth and see what to do better.</source>
        <translation>Präparieren Sie einen virtuellen Zahn und sehen Sie, was Sie besser machen können.</translation>
    </message>
    <message>
        <source>No users yet. You become the admin, and add teachers and students next.</source>
        <translation>Noch keine Benutzer. Sie werden Admin und fügen danach Lehrende und Studierende hinzu.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
</context>
<context>
    <name>ui::scoring::CommentsPanel</name>
    <message>
        <source>%1 points, passed</source>
        <translation>%1 Punkte, bestanden</translation>
    </message>
    <message>
        <source>%1 points, not passed</source>
        <translation>%1 Punkte, nicht bestanden</translation>
    </message>
    <message>
        <source>Given by %1. The machine&apos;s score: %2 points.</source>
        <translation>Gegeben von %1. Ergebnis der Maschine: %2 Punkte.</translation>
    </message>
    <message>
        <source>The machine&apos;s score</source>
        <translation>Das Ergebnis der Maschine</translation>
    </message>
    <message>
        <source>at %1 of the replay</source>
        <translation>bei %1 der Wiedergabe</translation>
    </message>
    <message>
        <source>Pin the comment to this moment</source>
        <translation>Kommentar an diesen Moment heften</translation>
    </message>
    <message>
        <source>at the marked place</source>
        <translation>an der markierten Stelle</translation>
    </message>
    <message>
        <source>Pin the comment to this place</source>
        <translation>Kommentar an diese Stelle heften</translation>
    </message>
    <message>
        <source>▶ %1</source>
        <extracomment>%1: minutes and seconds</extracomment>
        <translation>▶ %1</translation>
    </message>
    <message>
        <source>Show the moment %1</source>
        <translation>Den Moment %1 zeigen</translation>
    </message>
    <message>
        <source>◎ place</source>
        <translation>◎ Stelle</translation>
    </message>
    <message>
        <source>Show the place</source>
        <translation>Die Stelle zeigen</translation>
    </message>
    <message>
        <source>gave %1 points: %2</source>
        <translation>gab %1 Punkte: %2</translation>
    </message>
    <message>
        <source>let the machine&apos;s score count again: %1</source>
        <translation>ließ wieder das Ergebnis der Maschine gelten: %1</translation>
    </message>
    <message>
        <source>Write a comment</source>
        <translation>Kommentar schreiben</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Add comment</source>
        <translation>Kommentar hinzufügen</translation>
    </message>
    <message>
        <source>Give another score</source>
        <translation>Ein anderes Ergebnis geben</translation>
    </message>
    <message>
        <source>Points given</source>
        <translation>Gegebene Punkte</translation>
    </message>
    <message>
        <source> points</source>
        <extracomment>Behind a number</extracomment>
        <translation> Punkte</translation>
    </message>
    <message>
        <source>Reason, which the student reads</source>
        <translation>Begründung, die die Person liest</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Begründung</translation>
    </message>
    <message>
        <source>Give this score</source>
        <translation>Dieses Ergebnis geben</translation>
    </message>
    <message>
        <source>Back to the machine&apos;s score</source>
        <translation>Zurück zum Ergebnis der Maschine</translation>
    </message>
    <message>
        <source>To pin it, click a place on the tooth above, or play the attempt to a moment and come back.</source>
        <translation>Zum Anheften klicken Sie oben auf eine Stelle am Zahn, oder spielen Sie den Versuch bis zu einem Moment ab und kommen Sie zurück.</translation>
    </message>
    <message>
        <source>To pin it to a moment, play the attempt to there and come back.</source>
        <translation>Um ihn an einen Moment zu heften, spielen Sie den Versuch bis dorthin ab und kommen Sie zurück.</translation>
    </message>
    <message>
        <source>To pin it to a place, click on the tooth above.</source>
        <translation>Um ihn an eine Stelle zu heften, klicken Sie oben auf den Zahn.</translation>
    </message>
    <message numerus="yes">
        <source>Room for %Ln more character(s)</source>
        <translation>
            <numerusform>Platz für noch %Ln Zeichen</numerusform>
            <numerusform>Platz für noch %Ln Zeichen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln character(s) too many: a comment has at most %1.</source>
        <translation>
            <numerusform>%Ln Zeichen zu viel: Ein Kommentar hat höchstens %1.</numerusform>
            <numerusform>%Ln Zeichen zu viel: Ein Kommentar hat höchstens %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>This comment had been taken back already.</source>
        <translation>Dieser Kommentar war schon zurückgenommen.</translation>
    </message>
    <message>
        <source>Taken back. Nobody is shown it any more. Its words are here again, to be corrected or cleared.</source>
        <translation>Zurückgenommen. Niemand sieht den Kommentar mehr. Sein Text steht wieder hier; Sie können ihn berichtigen oder löschen.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Take back your comment of %1</source>
        <extracomment>%1: when it was written</extracomment>
        <translation>Ihren Kommentar vom %1 zurücknehmen</translation>
    </message>
    <message>
        <source>Taken back. Nobody is shown it any more. Its words are here again, below what you are writing.</source>
        <translation>Zurückgenommen. Niemand sieht es mehr. Die Worte stehen wieder hier, unter dem, was Sie gerade schreiben.</translation>
    </message>
    <message>
        <source>A score has 0 to 100 points.</source>
        <translation>Ein Ergebnis hat 0 bis 100 Punkte.</translation>
    </message>
    <message>
        <source>Nobody has written anything yet. Where there is a recording, a comment can be pinned to a moment of the replay and to a place on the tooth.</source>
        <translation>Noch hat niemand etwas geschrieben. Wo es eine Aufzeichnung gibt, lässt sich ein Kommentar an einen Moment der Wiedergabe und an eine Stelle am Zahn heften.</translation>
    </message>
    <message>
        <source>Nobody has written anything yet. What an instructor says is here.</source>
        <translation>Noch hat niemand etwas geschrieben. Was eine Lehrkraft sagt, steht hier.</translation>
    </message>
    <message numerus="yes">
        <source>%n comment(s) were typed and are not added yet.</source>
        <translation>
            <numerusform>%n Kommentar ist getippt und noch nicht hinzugefügt.</numerusform>
            <numerusform>%n Kommentare sind getippt und noch nicht hinzugefügt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n score(s) were typed and are not given yet.</source>
        <translation>
            <numerusform>%n Punktzahl ist getippt und noch nicht vergeben.</numerusform>
            <numerusform>%n Punktzahlen sind getippt und noch nicht vergeben.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::people::WelcomeChoices</name>
    <message>
        <source>Practise now</source>
        <translation>Jetzt üben</translation>
    </message>
    <message>
        <source>A tooth with decay is ready. Nothing is saved.</source>
        <translation>Ein Zahn mit Karies liegt bereit. Nichts wird gespeichert.</translation>
    </message>
    <message>
        <source>Set up a school</source>
        <translation>Schule einrichten</translation>
    </message>
    <message>
        <source>Users, lessons and score histories. You become the admin.</source>
        <translation>Benutzer, Lektionen und Notenverläufe. Sie werden Admin.</translation>
    </message>
</context>
<context>
    <name>ui::text::PeopleTexts</name>
    <message>
        <source>This attempt was made with another version of the lesson than the one that was assigned. It is practice and does not count.</source>
        <translation>Dieser Versuch wurde mit einer anderen Fassung der Lektion gemacht als der aufgegebenen. Er ist eine Übung und zählt nicht.</translation>
    </message>
    <message>
        <source>The recording is missing, damaged or not of this attempt. The score does not count until a teacher gives one.</source>
        <translation>Die Aufzeichnung fehlt, ist beschädigt oder nicht von diesem Versuch. Das Ergebnis zählt erst, wenn eine Lehrkraft eines gibt.</translation>
    </message>
    <message>
        <source>The recording gives another result than the one that was reported. The score does not count until a teacher gives one.</source>
        <translation>Die Aufzeichnung ergibt etwas anderes, als gemeldet wurde. Das Ergebnis zählt erst, wenn eine Lehrkraft eines gibt.</translation>
    </message>
    <message>
        <source>This exam was not begun as its recording says: its start is missing here, or less time has passed since than was worked. The score does not count until a teacher gives one.</source>
        <translation>Diese Prüfung wurde nicht so begonnen, wie ihre Aufzeichnung sagt: Ihr Beginn fehlt hier, oder seitdem ist weniger Zeit vergangen, als gearbeitet wurde. Das Ergebnis zählt erst, wenn eine Lehrkraft eines gibt.</translation>
    </message>
    <message>
        <source>Free practice</source>
        <translation>Freies Üben</translation>
    </message>
    <message>
        <source>today</source>
        <translation>heute</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>gestern</translation>
    </message>
    <message>
        <source>d MMM</source>
        <extracomment>A day without its year, as QLocale::toString() takes it: &quot;27 Nov&quot;. German &quot;d. MMM&quot;, Japanese &quot;M月d日&quot;</extracomment>
        <translation>d. MMM</translation>
    </message>
    <message>
        <source>MMM yyyy</source>
        <extracomment>A month, as QLocale::toString() takes it: &quot;Nov 2024&quot;</extracomment>
        <translation>MMM yyyy</translation>
    </message>
</context>
<context>
    <name>ui::presets::FeedChart</name>
    <message>
        <source>Feed over force</source>
        <translation>Vorschub über der Kraft</translation>
    </message>
    <message>
        <source>%1 %2 mm/s</source>
        <extracomment>%1 is a material, %2 a speed</extracomment>
        <translation>%1 %2 mm/s</translation>
    </message>
    <message>
        <source>Straight down with %1 N</source>
        <extracomment>%1 is a force</extracomment>
        <translation>Gerade nach unten mit %1 N</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Kraft, N</translation>
    </message>
    <message>
        <source>Feed, mm/s</source>
        <translation>Vorschub, mm/s</translation>
    </message>
    <message>
        <source>dashed: as it was kept</source>
        <translation>gestrichelt: wie es gespeichert ist</translation>
    </message>
    <message>
        <source>%1, as it was kept</source>
        <extracomment>%1 is a material; its line is that of the preset before it was changed</extracomment>
        <translation>%1, wie gesichert</translation>
    </message>
</context>
<context>
    <name>ui::presets::PresetTable</name>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Abtrag</translation>
    </message>
    <message>
        <source>Cuts from</source>
        <extracomment>The force from which on a material is cut</extracomment>
        <translation>Schneidet ab</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>Von %1.</translation>
    </message>
</context>
<context>
    <name>ui::presets::PresetsPage</name>
    <message>
        <source>Hardness presets</source>
        <translation>Härte-Voreinstellungen</translation>
    </message>
    <message>
        <source>Hardness presets and their versions</source>
        <translation>Härte-Voreinstellungen und ihre Versionen</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Importieren …</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>Eine Voreinstellung importieren</translation>
    </message>
    <message>
        <source>Read a preset from a file and keep it here</source>
        <translation>Eine Voreinstellung aus einer Datei lesen und hier behalten</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Export this version</source>
        <translation>Diese Version exportieren</translation>
    </message>
    <message>
        <source>Write the chosen version to a file, for another school</source>
        <translation>Die gewählte Version in eine Datei schreiben, für eine andere Schule</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Name der Voreinstellung</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Notes: what it is for</source>
        <translation>Notizen: wofür sie ist</translation>
    </message>
    <message>
        <source>Simple</source>
        <translation>Einfach</translation>
    </message>
    <message>
        <source>A few sliders</source>
        <translation>Wenige Regler</translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation>Alle Zahlen</translation>
    </message>
    <message>
        <source>Every number with its range</source>
        <translation>Jede Zahl mit ihrem Bereich</translation>
    </message>
    <message>
        <source>Feed of</source>
        <translation>Vorschub von</translation>
    </message>
    <message>
        <source>Bur whose feed is drawn</source>
        <translation>Bohrer, dessen Vorschub gezeichnet wird</translation>
    </message>
    <message>
        <source>Try on a block</source>
        <translation>Am Block probieren</translation>
    </message>
    <message>
        <source>Drill a block of enamel, dentin and soft caries with it</source>
        <translation>Damit einen Block aus Schmelz, Dentin und weicher Karies bohren</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Duplicate under another name</source>
        <translation>Unter anderem Namen duplizieren</translation>
    </message>
    <message>
        <source>Begin a preset of another name with these numbers</source>
        <translation>Mit diesen Zahlen eine Voreinstellung mit anderem Namen beginnen</translation>
    </message>
    <message>
        <source>Use for practice</source>
        <translation>Zum Üben verwenden</translation>
    </message>
    <message>
        <source>Use this version for practice</source>
        <translation>Diese Version zum Üben verwenden</translation>
    </message>
    <message>
        <source>Every tooth feels like this, unless its lesson says otherwise</source>
        <translation>Jeder Zahn fühlt sich so an, wenn seine Lektion nichts anderes sagt</translation>
    </message>
    <message>
        <source>Compare blind with</source>
        <translation>Blind gegen</translation>
    </message>
    <message>
        <source>Preset to compare with</source>
        <translation>Voreinstellung zum Vergleich</translation>
    </message>
    <message>
        <source>Number of trials</source>
        <translation>Zahl der Durchgänge</translation>
    </message>
    <message>
        <source>Compare A and B</source>
        <translation>A und B vergleichen</translation>
    </message>
    <message>
        <source>Drill with both, behind letters, and say which feels more like a tooth</source>
        <translation>Mit beiden bohren, hinter Buchstaben, und sagen, was sich eher wie ein Zahn anfühlt</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>shipped</source>
        <translation>mitgeliefert</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>in Gebrauch</translation>
    </message>
    <message>
        <source>changed from %1</source>
        <translation>geändert gegenüber %1</translation>
    </message>
    <message>
        <source>Restore as the newest version</source>
        <translation>Als neueste Version wiederherstellen</translation>
    </message>
    <message>
        <source>Save as a new version</source>
        <translation>Als neue Version sichern</translation>
    </message>
    <message>
        <source>A version is never changed: this becomes another</source>
        <translation>Eine Version wird nie geändert: Daraus wird eine weitere</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <extracomment>%1 is the name of a preset that is duplicated</extracomment>
        <translation>%1 Kopie</translation>
    </message>
    <message>
        <source>Trials:</source>
        <extracomment>Before a number</extracomment>
        <translation>Durchgänge:</translation>
    </message>
    <message>
        <source>An admin keeps the school&apos;s presets</source>
        <translation>Ein Admin speichert die Härte-Voreinstellungen der Schule</translation>
    </message>
    <message>
        <source>These two feel the same: choose another, or change a number</source>
        <translation>Diese beiden fühlen sich gleich an: Wählen Sie ein anderes oder ändern Sie eine Zahl</translation>
    </message>
    <message>
        <source>What you have changed of the hardness preset %1 is not saved.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>Was Sie an der Härte-Voreinstellung %1 geändert haben, ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>retired</source>
        <extracomment>A hardness preset that nobody is offered any more</extracomment>
        <translation>ausgemustert</translation>
    </message>
    <message>
        <source>Take up again</source>
        <translation>Wieder anbieten</translation>
    </message>
    <message>
        <source>Retire</source>
        <translation>Ausmustern</translation>
    </message>
    <message>
        <source>Offer this preset again</source>
        <translation>Diese Voreinstellung wieder anbieten</translation>
    </message>
    <message>
        <source>Retire this preset</source>
        <translation>Diese Voreinstellung ausmustern</translation>
    </message>
    <message>
        <source>What is in use or shipped is not retired</source>
        <translation>Was verwendet wird oder mitgeliefert ist, wird nicht ausgemustert</translation>
    </message>
    <message>
        <source>It is offered again, in all its versions</source>
        <translation>Sie wird wieder angeboten, in allen Versionen</translation>
    </message>
    <message>
        <source>Nobody is offered it any more; attempts go on naming it</source>
        <translation>Sie wird niemandem mehr angeboten; Versuche nennen sie weiterhin</translation>
    </message>
</context>
<context>
    <name>ui::presets::SimplePanel</name>
    <message>
        <source>Enamel</source>
        <translation>Schmelz</translation>
    </message>
    <message>
        <source>softer</source>
        <translation>weicher</translation>
    </message>
    <message>
        <source>harder</source>
        <translation>härter</translation>
    </message>
    <message>
        <source>Dentin</source>
        <translation>Dentin</translation>
    </message>
    <message>
        <source>Caries</source>
        <translation>Karies</translation>
    </message>
    <message>
        <source>Plastic tooth</source>
        <translation>Kunststoffzahn</translation>
    </message>
    <message>
        <source>Touch that cuts</source>
        <extracomment>How hard one must press before anything comes away</extracomment>
        <translation>Druck, der schneidet</translation>
    </message>
    <message>
        <source>lighter</source>
        <translation>leichter</translation>
    </message>
    <message>
        <source>heavier</source>
        <translation>fester</translation>
    </message>
    <message>
        <source>Wall</source>
        <extracomment>What an uncut tooth feels like under the bur</extracomment>
        <translation>Wand</translation>
    </message>
    <message>
        <source>stiffer</source>
        <translation>steifer</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <extracomment>A slider: what it is about, and the words at its ends</extracomment>
        <translation>%1, %2 bis %3</translation>
    </message>
    <message>
        <source>In the middle: the numbers that were typed.</source>
        <extracomment>Of sliders. %1 is a hardness preset</extracomment>
        <translation>In der Mitte: die eingegebenen Zahlen.</translation>
    </message>
    <message>
        <source>In the middle: %1.</source>
        <translation>In der Mitte: %1.</translation>
    </message>
</context>
<context>
    <name>ui::presets::TrialCard</name>
    <message>
        <source>Feel A</source>
        <translation>A fühlen</translation>
    </message>
    <message>
        <source>Feel B</source>
        <translation>B fühlen</translation>
    </message>
    <message>
        <source>Drill with the preset behind A from now on</source>
        <translation>Ab jetzt mit der Voreinstellung hinter A bohren</translation>
    </message>
    <message>
        <source>Drill with the preset behind B from now on</source>
        <translation>Ab jetzt mit der Voreinstellung hinter B bohren</translation>
    </message>
    <message>
        <source>A does</source>
        <extracomment>Which of two presets feels more like a tooth</extracomment>
        <translation>A ist es</translation>
    </message>
    <message>
        <source>B does</source>
        <translation>B ist es</translation>
    </message>
    <message>
        <source>No difference</source>
        <translation>Kein Unterschied</translation>
    </message>
    <message>
        <source>All as it was</source>
        <translation>Alles wie vorher</translation>
    </message>
    <message>
        <source>Set all sliders back to the preset</source>
        <translation>Alle Regler auf die Voreinstellung zurücksetzen</translation>
    </message>
    <message>
        <source>Save as CSV …</source>
        <translation>Als CSV sichern …</translation>
    </message>
    <message>
        <source>Save the comparison as CSV</source>
        <translation>Den Vergleich als CSV sichern</translation>
    </message>
    <message>
        <source>Back to the presets</source>
        <translation>Zu den Voreinstellungen</translation>
    </message>
    <message>
        <source>Drill: each slider is felt at once.</source>
        <translation>Bohren Sie: Jeden Regler fühlen Sie sofort.</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <extracomment>%1 of %2 trials</extracomment>
        <translation>Durchgang %1 von %2</translation>
    </message>
    <message>
        <source>Drill with A and with B, as often as you like. Which feels more like a tooth?</source>
        <translation>Bohren Sie mit A und mit B, so oft Sie möchten. Was fühlt sich eher wie ein Zahn an?</translation>
    </message>
    <message>
        <source>Compared</source>
        <translation>Verglichen</translation>
    </message>
    <message numerus="yes">
        <source>%1: chosen %n time(s).</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>
            <numerusform>%1: %n-mal gewählt.</numerusform>
            <numerusform>%1: %n-mal gewählt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No difference: %n time(s).</source>
        <translation>
            <numerusform>Kein Unterschied: %n-mal.</numerusform>
            <numerusform>Kein Unterschied: %n-mal.</numerusform>
        </translation>
    </message>
    <message>
        <source>That says nothing: they came out as even as can be.</source>
        <translation>Das sagt nichts: Es ging so gleich aus, wie es nur kann.</translation>
    </message>
    <message numerus="yes">
        <source>That is hardly chance: tossing a coin comes out as uneven only %n time(s) in 100.</source>
        <translation>
            <numerusform>Das ist kaum Zufall: Eine Münze fällt nur %n Mal von 100 so ungleich.</numerusform>
            <numerusform>Das ist kaum Zufall: Eine Münze fällt nur %n Mal von 100 so ungleich.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>That may be chance: tossing a coin comes out as uneven %n time(s) in 100. Compare more often to be sure.</source>
        <translation>
            <numerusform>Das kann Zufall sein: Eine Münze fällt %n Mal von 100 so ungleich. Vergleichen Sie öfter, um sicher zu sein.</numerusform>
            <numerusform>Das kann Zufall sein: Eine Münze fällt %n Mal von 100 so ungleich. Vergleichen Sie öfter, um sicher zu sein.</numerusform>
        </translation>
    </message>
    <message>
        <source>First cut a little with both</source>
        <translation>Schneiden Sie erst mit beiden ein wenig</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Vergleich beenden</translation>
    </message>
    <message>
        <source>What has been answered counts, and it is told which was which</source>
        <translation>Was beantwortet ist, zählt, und es wird verraten, welche welche war</translation>
    </message>
    <message>
        <source>It was ended before anything was chosen.</source>
        <translation>Er wurde beendet, bevor etwas gewählt war.</translation>
    </message>
    <message>
        <source>Block of</source>
        <extracomment>What the block is made of on which a hardness preset is tried</extracomment>
        <translation>Block aus</translation>
    </message>
    <message>
        <source>What the block is made of</source>
        <translation>Woraus der Block besteht</translation>
    </message>
    <message>
        <source>enamel, dentin, soft decay</source>
        <translation>Schmelz, Dentin, weicher Karies</translation>
    </message>
    <message>
        <source>enamel, dentin, firm decay</source>
        <translation>Schmelz, Dentin, fester Karies</translation>
    </message>
    <message>
        <source>plastic throughout</source>
        <translation>Kunststoff durch und durch</translation>
    </message>
</context>
<context>
    <name>ui::text::PresetTexts</name>
    <message>
        <source>Soft caries</source>
        <translation>Weiche Karies</translation>
    </message>
    <message>
        <source>Firm caries</source>
        <translation>Feste Karies</translation>
    </message>
    <message>
        <source>Enamel</source>
        <translation>Schmelz</translation>
    </message>
    <message>
        <source>Dentin</source>
        <translation>Dentin</translation>
    </message>
    <message>
        <source>Pulp</source>
        <translation>Pulpa</translation>
    </message>
    <message>
        <source>Plastic tooth</source>
        <extracomment>What the teeth of a typodont are made of</extracomment>
        <translation>Kunststoffzahn</translation>
    </message>
    <message>
        <source>%1: rate</source>
        <extracomment>%1 is a material of a tooth</extracomment>
        <translation>%1: Abtrag</translation>
    </message>
    <message>
        <source>%1: from</source>
        <translation>%1: ab</translation>
    </message>
    <message>
        <source>Share along the bur</source>
        <translation>Anteil längs des Bohrers</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Damping of fast motion</source>
        <translation>Dämpfung schneller Bewegung</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation>Kraftgrenze</translation>
    </message>
    <message>
        <source>Volume that a newton beyond the threshold takes away in a second, pushing sideways.</source>
        <translation>Volumen, das ein Newton über der Schwelle in einer Sekunde abträgt, bei seitlichem Druck.</translation>
    </message>
    <message>
        <source>A lighter touch leaves no mark.</source>
        <translation>Leichterer Druck hinterlässt keine Spur.</translation>
    </message>
    <message>
        <source>What is left of the rate when the bur is pushed along its axis.</source>
        <translation>Was vom Abtrag bleibt, wenn der Bohrer längs seiner Achse gedrückt wird.</translation>
    </message>
    <message>
        <source>Of the spring between hand and bur: how hard a wall feels.</source>
        <translation>Der Feder zwischen Hand und Bohrer: wie hart sich eine Wand anfühlt.</translation>
    </message>
    <message>
        <source>What calms the hand at rest. Too much is felt as a buzz.</source>
        <translation>Was die ruhende Hand beruhigt. Zu viel fühlt man als Summen.</translation>
    </message>
    <message>
        <source>What calms a fast hand besides, as when the bur is thrown at the tooth.</source>
        <translation>Was eine schnelle Hand zusätzlich beruhigt, etwa wenn der Bohrer auf den Zahn stößt.</translation>
    </message>
    <message>
        <source>Of the bur that slides on the tooth.</source>
        <translation>Des Bohrers, der auf dem Zahn gleitet.</translation>
    </message>
    <message>
        <source>The largest force that is ever given to the hand.</source>
        <translation>Die größte Kraft, die die Hand je bekommt.</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <extracomment>A range: %1 to %2, %3 is a unit</extracomment>
        <translation>%1 bis %2 %3</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <extracomment>%1 is the name of a hardness preset, %2 its version</extracomment>
        <translation>%1, Version %2</translation>
    </message>
    <message>
        <source>%1, changed by hand</source>
        <extracomment>After the name of a hardness preset whose numbers were changed during the attempt</extracomment>
        <translation>%1, von Hand geändert</translation>
    </message>
    <message>
        <source>The force limit is %1 N, and the device gives at most %2 N: lower it.</source>
        <translation>Die Kraftgrenze ist %1 N, und das Gerät gibt höchstens %2 N: Senken Sie sie.</translation>
    </message>
    <message>
        <source>Holds: a light hand at %1 ms of delay is steady up to %2 N/mm, and this is %3.</source>
        <translation>Hält: Eine leichte Hand bleibt bei %1 ms Verzögerung bis %2 N/mm ruhig, und hier sind es %3.</translation>
    </message>
    <message>
        <source>Would tremble: a light hand at %1 ms of delay is steady up to %2 N/mm, and this is %3.</source>
        <translation>Würde zittern: Eine leichte Hand bleibt bei %1 ms Verzögerung bis %2 N/mm ruhig, und hier sind es %3.</translation>
    </message>
    <message>
        <source>Lower the stiffness, or damp more.</source>
        <translation>Senken Sie die Steifigkeit oder dämpfen Sie mehr.</translation>
    </message>
    <message>
        <source>Lower the stiffness.</source>
        <translation>Senken Sie die Steifigkeit.</translation>
    </message>
    <message>
        <source>Share of flat ends</source>
        <extracomment>Of a bur whose end is flat, such as a pear or a fissure bur</extracomment>
        <translation>Anteil flacher Enden</translation>
    </message>
    <message>
        <source>Full load</source>
        <extracomment>The load on the bur beyond which it cuts no faster</extracomment>
        <translation>Volle Last</translation>
    </message>
    <message>
        <source>What a pear or a fissure bur has of the share along the bur. At 1 the end makes no difference.</source>
        <translation>Was ein birnenförmiger oder ein Fissurenbohrer vom Anteil längs des Bohrers hat. Bei 1 macht das Ende keinen Unterschied.</translation>
    </message>
    <message>
        <source>A bur pressed harder cuts no faster. At 20 N there is no such limit.</source>
        <translation>Ein Bohrer, der stärker gedrückt wird, schneidet nicht schneller. Bei 20 N gibt es keine solche Grenze.</translation>
    </message>
</context>
<context>
    <name>ui::practice::HistoryPanel</name>
    <message>
        <source>Undo history</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Click a state, or press Enter, to return to it</source>
        <translation>Einen Zustand anklicken oder Eingabetaste drücken, um zu ihm zurückzukehren</translation>
    </message>
    <message>
        <source>Each stroke appears here as a small picture. Click a picture to go back to it. Later strokes stay as a separate branch.</source>
        <translation>Jeder Strich erscheint hier als kleines Bild. Ein Klick auf ein Bild führt dorthin zurück. Spätere Striche bleiben als eigener Zweig erhalten.</translation>
    </message>
</context>
<context>
    <name>ui::replay::ReplayBar</name>
    <message>
        <source>You are watching a recording</source>
        <translation>Sie sehen eine Aufzeichnung</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Stop the replay</source>
        <translation>Die Wiedergabe beenden</translation>
    </message>
    <message>
        <source>Stop the replay and return to your own work (Esc)</source>
        <translation>Die Wiedergabe beenden und zur eigenen Arbeit zurückkehren (Esc)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Progress of a recording: minutes and seconds played, and of the whole</extracomment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1×</source>
        <extracomment>Speed of a replay: so many times as fast as it was made</extracomment>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Speed of the replay: %1</source>
        <translation>Geschwindigkeit der Wiedergabe: %1</translation>
    </message>
</context>
<context>
    <name>ui::replay::TimeLine</name>
    <message>
        <source>Time line</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Left and Right move from stroke to stroke, Home and End to the beginning and the end.</source>
        <translation>Links und rechts führen von Strich zu Strich, Pos1 und Ende zum Anfang und zum Ende.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>On a time line: a time, and what happened then</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Stroke %1, %2 s, %3</source>
        <translation>Strich %1, %2 s, %3</translation>
    </message>
    <message>
        <source>Interruption of %1, not counted as working time</source>
        <translation>Unterbrechung von %1, zählt nicht als Arbeitszeit</translation>
    </message>
</context>
<context>
    <name>ui::report::ClassReport</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: what they need; %2: names</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Stuck (three attempts in a row, not passed, not better by five points)</source>
        <translation>Kommen nicht weiter (drei Versuche hintereinander, nicht bestanden, nicht um fünf Punkte besser)</translation>
    </message>
    <message>
        <source>Never logged in</source>
        <translation>Nie angemeldet</translation>
    </message>
    <message>
        <source>Logged in, no graded attempt yet</source>
        <translation>Angemeldet, noch kein bewerteter Versuch</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s)</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Studierende</numerusform>
        </translation>
    </message>
    <message>
        <source>The class at: %1</source>
        <translation>Die Klasse bei: %1</translation>
    </message>
    <message>
        <source>Late: a lesson is overdue and not passed</source>
        <translation>Überfällig: eine Lektion ist fällig gewesen und nicht bestanden</translation>
    </message>
    <message>
        <source>Class: %1</source>
        <translation>Klasse: %1</translation>
    </message>
    <message>
        <source>Rubric: %1, version %2, content %3</source>
        <translation>Bewertungsschema: %1, Version %2, Inhalt %3</translation>
    </message>
    <message>
        <source>No attempts left at a lesson that is not passed</source>
        <translation>Keine Versuche mehr bei einer nicht bestandenen Lektion</translation>
    </message>
    <message>
        <source>Best scores</source>
        <translation>Beste Ergebnisse</translation>
    </message>
    <message>
        <source>✓: passed; ▲: overdue, or no attempts left; ⚠: does not match its recording; ▲ behind a name: needs the teacher</source>
        <translation>✓: bestanden; ▲: überfällig oder keine Versuche mehr; ⚠: passt nicht zur Aufzeichnung; ▲ hinter einem Namen: braucht die Lehrkraft</translation>
    </message>
</context>
<context>
    <name>ui::report::ScoreCard</name>
    <message>
        <source>Score card: %1</source>
        <translation>Bewertung: %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1: a person; %2: date and time</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Given by an instructor. Automatic score: %1 points.</source>
        <translation>Von einer Lehrkraft gegeben. Automatische Bewertung: %1 Punkte.</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <extracomment>%1: a person; %2: date and time; %3: why</extracomment>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>Self-assessment before the score: %1 points</source>
        <translation>Selbsteinschätzung vor der Bewertung: %1 Punkte</translation>
    </message>
    <message>
        <source>Time %1 min; cutting force: mean %2 N, maximum %3 N</source>
        <extracomment>&quot;12:07&quot;</extracomment>
        <translation>Zeit %1 min; Schnittkraft: Mittel %2 N, Maximum %3 N</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiterer</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>not met</source>
        <translation>nicht eingehalten</translation>
    </message>
    <message>
        <source>met</source>
        <translation>eingehalten</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Lost of a weight, both points: &quot;−4.4 of 30.0&quot;</extracomment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Lost points</source>
        <translation>Verlorene Punkte</translation>
    </message>
    <message>
        <source>On the tooth, and in a section through the largest deviation</source>
        <translation>Auf dem Zahn und im Schnitt durch die größte Abweichung</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>Details of grading and recording</source>
        <translation>Angaben zu Bewertung und Aufzeichnung</translation>
    </message>
    <message>
        <source>Rubric: %1, version %2, content %3</source>
        <translation>Bewertungsschema: %1, Version %2, Inhalt %3</translation>
    </message>
    <message>
        <source>Hardness: %1, content %2</source>
        <translation>Härte: %1, Inhalt %2</translation>
    </message>
    <message>
        <source>Device: %1; contact: %2; grid: %3 columns a side; view: %4; seed: %5</source>
        <translation>Gerät: %1; Kontakt: %2; Raster: %3 Säulen je Seite; Ansicht: %4; Zufallszahl: %5</translation>
    </message>
    <message>
        <source>Made with Cusp %1; recording %2; attempt %3</source>
        <translation>Entstanden mit Cusp %1; Aufzeichnung %2; Versuch %3</translation>
    </message>
    <message>
        <source>Not measured: undercuts and walls past 90°, because the model is a height field.</source>
        <translation>Nicht gemessen: Unterschnitte und Wände über 90°, denn das Modell ist ein Höhenfeld.</translation>
    </message>
    <message>
        <source>%1, %2, at %3 of the replay</source>
        <translation>%1, %2, bei %3 der Wiedergabe</translation>
    </message>
    <message>
        <source>%1 of 100 points, pass mark %2. %3</source>
        <extracomment>%1 and %2: points; %3: &quot;Passed&quot;, &quot;Not passed: critical error&quot;</extracomment>
        <translation>%1 von 100 Punkten, Bestehensgrenze %2. %3</translation>
    </message>
    <message>
        <source>Comments, with the numbers of their places in the picture of the tooth</source>
        <translation>Kommentare, mit den Nummern ihrer Stellen im Bild des Zahns</translation>
    </message>
    <message>
        <source>mouse, pen or gamepad</source>
        <translation>Maus, Stift oder Gamepad</translation>
    </message>
    <message>
        <source>simulated handpiece</source>
        <translation>simuliertes Handstück</translation>
    </message>
    <message>
        <source>continuous</source>
        <extracomment>How the point of contact is found: anywhere, not only on a lattice</extracomment>
        <translation>stufenlos</translation>
    </message>
    <message>
        <source>on a lattice</source>
        <extracomment>How the point of contact is found</extracomment>
        <translation>auf einem Gitter</translation>
    </message>
    <message>
        <source>on a lattice, 16 steps a tick</source>
        <extracomment>How the point of contact is found</extracomment>
        <translation>auf einem Gitter, 16 Schritte je Takt</translation>
    </message>
    <message>
        <source>by depth</source>
        <extracomment>How force is found: the deeper inside, the harder it is pushed out</extracomment>
        <translation>nach Eindringtiefe</translation>
    </message>
    <message>
        <source>flat</source>
        <extracomment>A picture that is no stereo picture</extracomment>
        <translation>flach</translation>
    </message>
    <message>
        <source>red and cyan glasses, in colour</source>
        <translation>Rot-Cyan-Brille, in Farbe</translation>
    </message>
    <message>
        <source>red and cyan glasses, in grey</source>
        <translation>Rot-Cyan-Brille, in Grau</translation>
    </message>
    <message>
        <source>stereo, halves side by side</source>
        <translation>Stereo, Hälften nebeneinander</translation>
    </message>
    <message>
        <source>stereo, halves one above the other</source>
        <translation>Stereo, Hälften übereinander</translation>
    </message>
    <message>
        <source>Rubric: content %1</source>
        <translation>Bewertungsschema: Inhalt %1</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>pen</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>keyboard</source>
        <translation>Tastatur</translation>
    </message>
    <message>
        <source>gamepad</source>
        <translation>Gamepad</translation>
    </message>
</context>
<context>
    <name>ui::report::Sheet</name>
    <message>
        <source>Cusp %1, printed %2</source>
        <translation>Cusp %1, gedruckt %2</translation>
    </message>
    <message>
        <source>%1, page %2</source>
        <translation>%1, Seite %2</translation>
    </message>
    <message>
        <source>Audit code: %1</source>
        <translation>Prüfcode: %1</translation>
    </message>
    <message>
        <source>Not kept in a school&apos;s database: there is no audit code</source>
        <translation>In keiner Datenbank einer Schule aufbewahrt: es gibt keinen Prüfcode</translation>
    </message>
    <message>
        <source>%1, page %2 of %3</source>
        <translation>%1, Seite %2 von %3</translation>
    </message>
</context>
<context>
    <name>ui::settings::SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Search the settings</source>
        <translation>In den Einstellungen suchen</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Suche leeren</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>Von %1.</translation>
    </message>
    <message>
        <source>Set it back</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Set back: %1</source>
        <extracomment>%1 is the name of a setting</extracomment>
        <translation>Zurücksetzen: %1</translation>
    </message>
    <message>
        <source>No setting is called so, and none speaks of it. Look for one word, such as &quot;force&quot;.</source>
        <translation>Keine Einstellung heißt so, und keine spricht davon. Suchen Sie ein Wort, etwa „Kraft“.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Of every window, at once.</source>
        <translation>Aller Fenster, sofort.</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>From the next start on. The practice room is always dark.</source>
        <translation>Ab dem nächsten Start. Der Übungsraum ist immer dunkel.</translation>
    </message>
    <message>
        <source>as the desktop</source>
        <translation>wie der Desktop</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Mouse or pen, a simulated hand, or a force device: choose, home and try it.</source>
        <translation>Maus oder Stift, eine simulierte Hand oder ein Kraftgerät: wählen, referenzieren und ausprobieren.</translation>
    </message>
</context>
<context>
    <name>ui::window::AccountMenu</name>
    <message>
        <source>My account</source>
        <translation>Mein Konto</translation>
    </message>
    <message>
        <source>Change my password …</source>
        <translation>Mein Passwort ändern …</translation>
    </message>
</context>
<context>
    <name>ui::kit::Actions</name>
    <message>
        <source>Drill</source>
        <translation>Präparieren</translation>
    </message>
    <message>
        <source>Drill on or off</source>
        <translation>Handstück an oder aus</translation>
    </message>
    <message>
        <source>Start or stop the bur</source>
        <translation>Den Bohrer starten oder anhalten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last stroke</source>
        <translation>Den letzten Strich rückgängig machen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo the stroke that was undone</source>
        <translation>Den rückgängig gemachten Strich wiederholen</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Reset the tooth; Undo restores your work</source>
        <translation>Den Zahn zurücksetzen; „Rückgängig“ stellt Ihre Arbeit wieder her</translation>
    </message>
    <message>
        <source>Grade</source>
        <translation>Bewerten</translation>
    </message>
    <message>
        <source>Measure your preparation and explain the grade</source>
        <translation>Die Präparation messen und die Bewertung erklären</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation>Handstück</translation>
    </message>
    <message>
        <source>Use this bur</source>
        <translation>Diesen Bohrer verwenden</translation>
    </message>
    <message>
        <source>Other hand</source>
        <translation>Andere Hand</translation>
    </message>
    <message>
        <source>Tooth and files</source>
        <translation>Zahn und Dateien</translation>
    </message>
    <message>
        <source>Choose a tooth</source>
        <translation>Zahn wählen</translation>
    </message>
    <message>
        <source>Show the arches and choose one of 16 teeth</source>
        <translation>Die Zahnbögen zeigen und einen von 16 Zähnen wählen</translation>
    </message>
    <message>
        <source>Open a scan</source>
        <translation>Scan öffnen</translation>
    </message>
    <message>
        <source>Open the scan of a tooth: OBJ, STL or PLY</source>
        <translation>Den Scan eines Zahns öffnen: OBJ, STL oder PLY</translation>
    </message>
    <message>
        <source>Save the recording</source>
        <translation>Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>Save every movement of this attempt to a file</source>
        <translation>Jede Bewegung dieses Versuchs in einer Datei speichern</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Replay a saved attempt</source>
        <translation>Einen gespeicherten Versuch abspielen</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>Return to the initial view</source>
        <translation>Zur Anfangsansicht zurückkehren</translation>
    </message>
    <message>
        <source>Side panel</source>
        <translation>Seitenleiste</translation>
    </message>
    <message>
        <source>Show or hide the figures</source>
        <translation>Die Messwerte ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Fill the whole screen</source>
        <translation>Den ganzen Bildschirm füllen</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Show what every key does</source>
        <translation>Zeigen, was jede Taste bewirkt</translation>
    </message>
    <message>
        <source>Back to the tooth</source>
        <translation>Zurück zum Zahn</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Close Cusp</source>
        <translation>Cusp schließen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>Tooltip: what it does, then its key</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Pause the replay</source>
        <translation>Wiedergabe anhalten</translation>
    </message>
    <message>
        <source>Pause or resume the replay</source>
        <translation>Die Wiedergabe anhalten oder fortsetzen</translation>
    </message>
    <message>
        <source>Resume the replay</source>
        <translation>Wiedergabe fortsetzen</translation>
    </message>
    <message>
        <source>Hold the handpiece from the other side; the view stays</source>
        <translation>Das Handstück von der anderen Seite halten; die Ansicht bleibt</translation>
    </message>
    <message>
        <source>Return the handpiece</source>
        <translation>Handstück zurückführen</translation>
    </message>
    <message>
        <source>Let the handpiece guide your hand back over the tooth</source>
        <translation>Die Hand vom Handstück über den Zahn zurückführen lassen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Rotate 180°</source>
        <translation>Um 180° drehen</translation>
    </message>
    <message>
        <source>Look at the tooth from the opposite side</source>
        <translation>Den Zahn von der anderen Seite sehen</translation>
    </message>
    <message>
        <source>Dental mirror</source>
        <extracomment>The small round mirror on a handle</extracomment>
        <translation>Mundspiegel</translation>
    </message>
    <message>
        <source>Show or hide the mirror; drag its glass to move it, with Shift to tilt it</source>
        <translation>Den Spiegel ein- oder ausblenden; am Glas ziehen bewegt ihn, mit Umschalt kippt es ihn</translation>
    </message>
    <message>
        <source>Light on the handpiece</source>
        <translation>Licht am Handstück</translation>
    </message>
    <message>
        <source>Light the cavity from the handpiece</source>
        <translation>Das Handstück leuchtet in die Kavität</translation>
    </message>
    <message>
        <source>Depth colours</source>
        <translation>Tiefenfarben</translation>
    </message>
    <message>
        <source>Colour the cut by its depth and show the depth at the pointer</source>
        <translation>Den Schnitt nach seiner Tiefe färben und die Tiefe am Zeiger anzeigen</translation>
    </message>
    <message>
        <source>Hand position</source>
        <translation>Position der Hand</translation>
    </message>
    <message>
        <source>Show faintly where the hand holds the bur</source>
        <translation>Blass zeigen, wo die Hand den Bohrer hält</translation>
    </message>
    <message>
        <source>Colour-blind palette</source>
        <translation>Farben für Farbenblinde</translation>
    </message>
    <message>
        <source>Give each tissue a colour and a pattern that are easy to tell apart</source>
        <translation>Jedem Gewebe eine Farbe und ein Muster geben, die leicht zu unterscheiden sind</translation>
    </message>
    <message>
        <source>Wet tooth</source>
        <extracomment>The tooth as if it were wet</extracomment>
        <translation>Nasser Zahn</translation>
    </message>
    <message>
        <source>Make the tooth shine as if it were wet</source>
        <translation>Den Zahn glänzen lassen, als wäre er nass</translation>
    </message>
    <message>
        <source>Stereo picture</source>
        <translation>Stereobild</translation>
    </message>
    <message>
        <source>One picture for each eye</source>
        <translation>Ein Bild für jedes Auge</translation>
    </message>
    <message>
        <source>Set up the stereo picture …</source>
        <translation>Stereobild einrichten …</translation>
    </message>
    <message>
        <source>Choose glasses or screen and fit it to your eyes</source>
        <translation>Brille oder Bildschirm wählen und an die Augen anpassen</translation>
    </message>
    <message>
        <source>Mirror horizontally</source>
        <translation>Horizontal spiegeln</translation>
    </message>
    <message>
        <source>For a half-silvered mirror over the hand</source>
        <translation>Für einen halbdurchlässigen Spiegel über der Hand</translation>
    </message>
    <message>
        <source>Mirror vertically</source>
        <translation>Vertikal spiegeln</translation>
    </message>
    <message>
        <source>For a screen mounted upside down over the hand</source>
        <translation>Für einen Bildschirm, der kopfüber über der Hand liegt</translation>
    </message>
    <message>
        <source>Save a picture …</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Save what the view shows as a PNG</source>
        <translation>Was die Ansicht zeigt, als PNG speichern</translation>
    </message>
    <message>
        <source>Less motion</source>
        <translation>Weniger Bewegung</translation>
    </message>
    <message>
        <source>No animations and no spinning bur</source>
        <translation>Keine Animationen, kein drehender Bohrer</translation>
    </message>
    <message>
        <source>Whole mouth</source>
        <translation>Ganzer Mund</translation>
    </message>
    <message>
        <source>Choose a tooth in the whole mouth, or go back to the flat arches</source>
        <translation>Einen Zahn im ganzen Mund wählen oder zurück zu den flachen Zahnbögen</translation>
    </message>
    <message>
        <source>Seeing inside</source>
        <translation>Hineinsehen</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Show or hide a live section through the bur</source>
        <translation>Einen mitlaufenden Schnitt durch den Bohrer ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Turn the section</source>
        <translation>Schnitt drehen</translation>
    </message>
    <message>
        <source>Turn the section around the bur by 15 degrees</source>
        <translation>Den Schnitt um 15 Grad um den Bohrer drehen</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgen</translation>
    </message>
    <message>
        <source>This lesson does not allow it.</source>
        <translation>Diese Lektion erlaubt das nicht.</translation>
    </message>
    <message>
        <source>Neighbouring teeth</source>
        <translation>Nachbarzähne</translation>
    </message>
    <message>
        <source>Show the adjacent teeth and the gum</source>
        <translation>Die Nachbarzähne und das Zahnfleisch zeigen</translation>
    </message>
    <message>
        <source>Deviation from the ideal</source>
        <translation>Abweichung vom Ideal</translation>
    </message>
    <message>
        <source>Colour what is too deep and what is still to cut, and show the value at the pointer</source>
        <translation>Einfärben, was zu tief ist und was noch fehlt, und den Wert am Zeiger anzeigen</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Choose what to practise</source>
        <translation>Wählen, was geübt wird</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Show or hide the undo history with all its branches</source>
        <translation>Den Verlauf mit allen Zweigen ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Previous stroke</source>
        <translation>Vorheriger Strich</translation>
    </message>
    <message>
        <source>Go to the end of the previous stroke and pause</source>
        <translation>Zum Ende des vorigen Strichs gehen und anhalten</translation>
    </message>
    <message>
        <source>Next stroke</source>
        <translation>Nächster Strich</translation>
    </message>
    <message>
        <source>Go to the end of the next stroke and pause</source>
        <translation>Zum Ende des nächsten Strichs gehen und anhalten</translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>Go to the beginning of the recording</source>
        <translation>Zum Anfang der Aufzeichnung gehen</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>Go to the end of the recording</source>
        <translation>Zum Ende der Aufzeichnung gehen</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Play the recording more slowly, down to a tenth</source>
        <translation>Die Aufzeichnung langsamer abspielen, bis zu einem Zehntel</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Play the recording faster, up to 16 times</source>
        <translation>Die Aufzeichnung schneller abspielen, bis zum 16-Fachen</translation>
    </message>
    <message>
        <source>Use this handpiece</source>
        <translation>Dieses Handstück verwenden</translation>
    </message>
    <message>
        <source>Colour the bur</source>
        <extracomment>The bur tells by its colour how near it is to what is to be kept</extracomment>
        <translation>Bohrer färben</translation>
    </message>
    <message>
        <source>Colour the bur by its distance from tissue that must be kept</source>
        <translation>Den Bohrer nach seinem Abstand zu Gewebe färben, das erhalten bleiben muss</translation>
    </message>
    <message>
        <source>Guided hand</source>
        <translation>Geführte Hand</translation>
    </message>
    <message>
        <source>A gentle force keeps the hand within the outline</source>
        <translation>Eine sanfte Kraft hält die Hand im Umriss</translation>
    </message>
    <message>
        <source>Edit the lesson …</source>
        <translation>Lektion bearbeiten …</translation>
    </message>
    <message>
        <source>Change the ideal and the rubric of the selected lesson</source>
        <translation>Ideal und Bewertungsschema der ausgewählten Lektion ändern</translation>
    </message>
    <message>
        <source>Save this attempt as a reference …</source>
        <translation>Diesen Versuch als Referenz speichern …</translation>
    </message>
    <message>
        <source>Save your preparation as an ideal for lessons</source>
        <translation>Ihre Präparation als Ideal für Lektionen speichern</translation>
    </message>
    <message>
        <source>The expert&apos;s attempt</source>
        <translation>Versuch des Experten</translation>
    </message>
    <message>
        <source>Watch how an expert does it; during a replay, beside this attempt</source>
        <translation>Ansehen, wie ein Experte es macht; bei einer Wiedergabe neben diesem Versuch</translation>
    </message>
    <message>
        <source>Compare with …</source>
        <translation>Vergleichen mit …</translation>
    </message>
    <message>
        <source>Open another attempt beside this one, or close it</source>
        <translation>Einen anderen Versuch neben diesem öffnen oder wieder schließen</translation>
    </message>
    <message>
        <source>Guide my hand</source>
        <translation>Hand führen</translation>
    </message>
    <message>
        <source>Let the handpiece guide your hand along the attempt; push against it to stop</source>
        <translation>Das Handstück führt Ihre Hand den Versuch entlang; drücken Sie dagegen, um es zu beenden</translation>
    </message>
    <message>
        <source>Hardness presets</source>
        <translation>Härte-Voreinstellungen</translation>
    </message>
    <message>
        <source>Choose, try and change how drilling feels</source>
        <translation>Wählen, probieren und ändern, wie sich das Bohren anfühlt</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>Show or hide parameters that you can change while you drill</source>
        <translation>Parameter, die Sie beim Bohren ändern können, ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Every setting with its range</source>
        <translation>Jede Einstellung mit ihrem Bereich</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>Meine Versuche</translation>
    </message>
    <message>
        <source>See the results of your attempts</source>
        <translation>Die Ergebnisse Ihrer Versuche sehen</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>See the results of a class and who needs help</source>
        <translation>Die Ergebnisse einer Klasse sehen und wer Hilfe braucht</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Get to know the window step by step</source>
        <translation>Das Fenster Schritt für Schritt kennenlernen</translation>
    </message>
    <message>
        <source>School</source>
        <translation>Schule</translation>
    </message>
    <message>
        <source>People, class lists, backups and the audit</source>
        <translation>Personen, Klassenlisten, Sicherungen und das Protokoll</translation>
    </message>
    <message>
        <source>Log in, lock this workstation, or change your password or the language</source>
        <translation>Anmelden, diesen Arbeitsplatz sperren, Passwort oder Sprache ändern</translation>
    </message>
    <message>
        <source>Lock or switch user</source>
        <translation>Sperren oder Benutzer wechseln</translation>
    </message>
    <message>
        <source>Your work stays open; a password is needed to continue</source>
        <translation>Ihre Arbeit bleibt offen; zum Weitermachen ist ein Passwort nötig</translation>
    </message>
    <message>
        <source>Close this page; nothing is lost</source>
        <translation>Diese Seite schließen; nichts geht verloren</translation>
    </message>
    <message>
        <source>Back to the attempts</source>
        <translation>Zurück zu den Versuchen</translation>
    </message>
    <message>
        <source>Back to the class</source>
        <translation>Zurück zur Klasse</translation>
    </message>
    <message>
        <source>Back to the lessons</source>
        <translation>Zurück zu den Lektionen</translation>
    </message>
    <message>
        <source>Guest,
unsaved</source>
        <extracomment>Beside &quot;Log in&quot;, on every page: what is done now is kept for nobody. Two short lines.</extracomment>
        <translation>Gast,
ungesichert</translation>
    </message>
    <message>
        <source>Show changes made on other computers</source>
        <translation>Änderungen von anderen Computern zeigen</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Show X-ray pictures of the tooth, before and now, or close them</source>
        <translation>Röntgenbilder des Zahns zeigen, vorher und jetzt, oder schließen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search on this page, or among the lessons</source>
        <translation>Auf dieser Seite suchen, oder unter den Lektionen</translation>
    </message>
    <message>
        <source>Outline</source>
        <extracomment>Of the ideal preparation, drawn on the tooth</extracomment>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Show or hide the outline of the ideal preparation on the tooth</source>
        <translation>Umriss der idealen Präparation auf dem Zahn zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Choose and try what moves the bur</source>
        <translation>Wählen und ausprobieren, was den Bohrer führt</translation>
    </message>
    <message>
        <source>Straight ahead is here</source>
        <translation>Hier ist geradeaus</translation>
    </message>
    <message>
        <source>Make the present position of your head the middle one</source>
        <translation>Die jetzige Haltung des Kopfes zur mittleren machen</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Sound of the handpiece on or off</source>
        <translation>Ton des Handstücks ein- oder ausschalten</translation>
    </message>
    <message>
        <source>All burs</source>
        <translation>Alle Bohrer</translation>
    </message>
    <message>
        <source>Choose from all burs, and which are at hand</source>
        <translation>Unter allen Bohrern wählen, und welche griffbereit sind</translation>
    </message>
</context>
<context>
    <name>ui::toothchooser::ArchTooth</name>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is the FDI number, %2 the tooth&apos;s name</extracomment>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>ui::toothchooser::ArchView</name>
    <message>
        <source>Arches</source>
        <translation>Zahnbögen</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
</context>
<context>
    <name>ui::practice::BurChooser</name>
    <message>
        <source>Burs</source>
        <translation>Bohrer</translation>
    </message>
</context>
<context>
    <name>ui::kit::BusyOverlay</name>
    <message>
        <source>Working</source>
        <translation>In Arbeit</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
</context>
<context>
    <name>ui::practice::DrillSwitch</name>
    <message>
        <source>Drill is on</source>
        <translation>Handstück ist an</translation>
    </message>
    <message>
        <source>Drill is off</source>
        <translation>Handstück ist aus</translation>
    </message>
    <message>
        <source>Drill on</source>
        <translation>Handstück an</translation>
    </message>
    <message>
        <source>Drill off</source>
        <translation>Handstück aus</translation>
    </message>
</context>
<context>
    <name>ui::kit::FileDialog</name>
    <message>
        <source>%1 is a file of another kind and stays as it is. Choose another name.</source>
        <translation>%1 ist eine Datei anderer Art und bleibt, wie sie ist. Wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>ui::kit::ForceBar</name>
    <message>
        <source>Force against the force that is set</source>
        <translation>Kraft im Verhältnis zur eingestellten</translation>
    </message>
    <message>
        <source>The mark is the force that is set. A wall that presses sideways adds to it.</source>
        <translation>Die Marke ist die eingestellte Kraft. Eine Wand, die seitlich drückt, kommt hinzu.</translation>
    </message>
</context>
<context>
    <name>ui::practice::HandControls</name>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Feed, millimetres per second</source>
        <translation>Vorschub in Millimetern pro Sekunde</translation>
    </message>
    <message>
        <source>How fast the bur goes down at most while you press</source>
        <translation>So schnell geht der Bohrer höchstens tiefer, solange Sie drücken</translation>
    </message>
    <message>
        <source>Depth stop</source>
        <translation>Tiefenanschlag</translation>
    </message>
    <message>
        <source>The bur stops at this depth below the original surface</source>
        <translation>In dieser Tiefe unter der ursprünglichen Oberfläche hält der Bohrer an</translation>
    </message>
    <message>
        <source>Depth stop, millimetres</source>
        <translation>Tiefenanschlag in Millimetern</translation>
    </message>
    <message>
        <source>To change the depth, turn the mouse wheel while you press the button or hold Shift</source>
        <translation>Um die Tiefe zu ändern, drehen Sie das Mausrad bei gedrückter Maustaste oder gedrückter Umschalttaste</translation>
    </message>
    <message>
        <source>Push with</source>
        <translation>Anpresskraft</translation>
    </message>
    <message>
        <source>Push with, newtons</source>
        <translation>Anpresskraft in Newton</translation>
    </message>
    <message>
        <source>How hard the mouse and the keys push the bur against the tooth at most</source>
        <translation>So stark drücken Maus und Tasten den Bohrer höchstens gegen den Zahn</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>The %1 moves the bur. Feed, depth stop and force are for the mouse.</source>
        <extracomment>%1: a force device</extracomment>
        <translation>Der %1 führt den Bohrer. Vorschub, Tiefenanschlag und Kraft gelten für die Maus.</translation>
    </message>
</context>
<context>
    <name>ui::practice::HandpieceChooser</name>
    <message>
        <source>Handpieces</source>
        <translation>Handstücke</translation>
    </message>
</context>
<context>
    <name>ui::window::HelpOverlay</name>
    <message>
        <source>Move the bur</source>
        <translation>Bohrer führen</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>Push it against the tooth</source>
        <translation>An den Zahn drücken</translation>
    </message>
    <message>
        <source>left button</source>
        <translation>linke Taste</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Lift it</source>
        <translation>Abheben</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>Push harder, softer</source>
        <translation>Stärker, schwächer</translation>
    </message>
    <message>
        <source>Depth stop</source>
        <translation>Tiefenanschlag</translation>
    </message>
    <message>
        <source>wheel while pressed</source>
        <translation>Mausrad beim Drücken</translation>
    </message>
    <message>
        <source>Shift + wheel</source>
        <translation>Umschalt + Mausrad</translation>
    </message>
    <message>
        <source>Insert, Delete</source>
        <translation>Einfg, Entf</translation>
    </message>
    <message>
        <source>Ctrl + wheel</source>
        <translation>Strg + Rad</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Ansicht drehen</translation>
    </message>
    <message>
        <source>Ctrl + arrows</source>
        <translation>Strg + Pfeile</translation>
    </message>
    <message>
        <source>Zoom in, zoom out</source>
        <translation>Vergrößern, verkleinern</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>Over the tooth</source>
        <translation>Am Zahn</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>right double-click</source>
        <translation>Doppelklick rechts</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>Move it in fine steps</source>
        <translation>In feinen Schritten führen</translation>
    </message>
    <message>
        <source>Shift + arrows</source>
        <translation>Umschalt + Pfeile</translation>
    </message>
    <message>
        <source>right or middle drag</source>
        <translation>rechts oder Mitte ziehen</translation>
    </message>
    <message>
        <source>The teal arc beside the bur shows how hard it presses; it is full at the force that is set.</source>
        <translation>Der türkise Bogen neben dem Bohrer zeigt, wie fest er drückt; bei der eingestellten Kraft ist er voll.</translation>
    </message>
    <message>
        <source>Turn the handpiece</source>
        <translation>Das Handstück drehen</translation>
    </message>
    <message>
        <source>the same with Shift</source>
        <translation>ebenso mit Umschalt</translation>
    </message>
    <message>
        <source>Move the mirror</source>
        <translation>Spiegel bewegen</translation>
    </message>
    <message>
        <source>drag its glass</source>
        <translation>am Glas ziehen</translation>
    </message>
    <message>
        <source>Alt + arrows</source>
        <translation>Alt + Pfeiltasten</translation>
    </message>
    <message>
        <source>Tilt the mirror</source>
        <translation>Spiegel kippen</translation>
    </message>
    <message>
        <source>wheel over it</source>
        <translation>Rad über ihm</translation>
    </message>
    <message>
        <source>Bring it nearer</source>
        <translation>Näher holen</translation>
    </message>
    <message>
        <source>Alt + Page Up</source>
        <translation>Alt + Bild auf</translation>
    </message>
    <message>
        <source>In a list</source>
        <translation>In einer Liste</translation>
    </message>
    <message>
        <source>Change the sorting</source>
        <translation>Sortierung ändern</translation>
    </message>
</context>
<context>
    <name>ui::scoring::RecentScoresChart</name>
    <message>
        <source>Last grades, oldest first: %1</source>
        <translation>Letzte Bewertungen, älteste zuerst: %1</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>bestanden ab %1</translation>
    </message>
    <message>
        <source>%1 with another rubric</source>
        <translation>%1 nach anderer Regel</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: date and time; %2: what the grade of then came to</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>ui::kit::LanguageMenu</name>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
</context>
<context>
    <name>ui::window::FileDialogs</name>
    <message>
        <source>Scans of teeth (%1)</source>
        <translation>Scans von Zähnen (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Recordings (%1)</source>
        <translation>Aufzeichnungen (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>The picture was saved as %1.</source>
        <translation>Das Bild wurde als %1 gespeichert.</translation>
    </message>
    <message>
        <source>The picture could not be written. Choose another folder, or free some disk space.</source>
        <translation>Das Bild konnte nicht geschrieben werden. Wählen Sie einen anderen Ordner oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>Captured ideals (%1)</source>
        <translation>Abgenommene Ideale (%1)</translation>
    </message>
    <message>
        <source>The comparison was saved as %1.</source>
        <translation>Der Vergleich wurde als %1 gesichert.</translation>
    </message>
    <message>
        <source>The comparison could not be written. Choose another folder, or make room on the disk.</source>
        <translation>Der Vergleich konnte nicht geschrieben werden. Wählen Sie einen anderen Ordner oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>Hardness presets (%1)</source>
        <translation>Härte-Voreinstellungen (%1)</translation>
    </message>
    <message>
        <source>Tables (%1)</source>
        <translation>Tabellen (%1)</translation>
    </message>
</context>
<context>
    <name>ui::window::UnsavedWork</name>
    <message>
        <source>Your work would be lost.</source>
        <translation>Ihre Arbeit ginge verloren.</translation>
    </message>
    <message>
        <source>Your latest cuts are not saved as a recording.</source>
        <translation>Ihre letzten Schnitte sind nicht als Aufzeichnung gespeichert.</translation>
    </message>
    <message>
        <source>&amp;Save the recording …</source>
        <translation>Aufzeichnung &amp;speichern …</translation>
    </message>
    <message>
        <source>The exam would end without a score.</source>
        <translation>Die Prüfung würde ohne Punktzahl enden.</translation>
    </message>
    <message>
        <source>It still counts as an attempt. Your work cannot be graded later.</source>
        <translation>Sie zählt trotzdem als Versuch. Ihre Arbeit kann später nicht bewertet werden.</translation>
    </message>
    <message>
        <source>&amp;Grade it now</source>
        <translation>Jetzt &amp;bewerten</translation>
    </message>
    <message numerus="yes">
        <source>%n grade(s) are not saved yet and would be lost.</source>
        <translation>
            <numerusform>%n Bewertung ist noch nicht gespeichert und ginge verloren.</numerusform>
            <numerusform>%n Bewertungen sind noch nicht gespeichert und gingen verloren.</numerusform>
        </translation>
    </message>
    <message>
        <source>The disk cannot be written to. Cusp tries again every few seconds while it runs. Free some disk space, or check the permissions of the folder.</source>
        <translation>Der Datenträger ist nicht beschreibbar. Solange Cusp läuft, versucht es das alle paar Sekunden wieder. Geben Sie Speicherplatz frei, oder prüfen Sie die Rechte des Ordners.</translation>
    </message>
</context>
<context>
    <name>ui::window::CommandSender</name>
    <message>
        <source>Cusp was still busy and did not do that. Try again.</source>
        <translation>Cusp war noch beschäftigt und hat das nicht getan. Versuchen Sie es noch einmal.</translation>
    </message>
</context>
<context>
    <name>ui::window::Notices</name>
    <message numerus="yes">
        <source>%n note(s) about this scan</source>
        <translation>
            <numerusform>%n Hinweis zu diesem Scan</numerusform>
            <numerusform>%n Hinweise zu diesem Scan</numerusform>
        </translation>
    </message>
    <message>
        <source>This is neither a scan (OBJ, STL, PLY) nor a recording. Drop one of those.</source>
        <translation>Das ist weder ein Scan (OBJ, STL, PLY) noch eine Aufzeichnung. Ziehen Sie eine solche Datei herein.</translation>
    </message>
    <message>
        <source>The recording was saved as %1.</source>
        <translation>Die Aufzeichnung wurde als %1 gespeichert.</translation>
    </message>
    <message>
        <source>Another unit</source>
        <translation>Andere Einheit</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Keep this unit</source>
        <translation>Diese Einheit behalten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>You had no attempts left at this lesson, so this grade is not saved.</source>
        <translation>Sie hatten für diese Lektion keine Versuche mehr, darum wird diese Bewertung nicht gespeichert.</translation>
    </message>
    <message>
        <source>You can save your work as a recording.</source>
        <translation>Sie können Ihre Arbeit als Aufzeichnung speichern.</translation>
    </message>
    <message>
        <source>The school&apos;s database does not answer yet. You can continue drilling; your request is completed when it answers.</source>
        <translation>Die Datenbank der Schule antwortet noch nicht. Sie können weiter präparieren; Ihre Anfrage wird erledigt, sobald sie antwortet.</translation>
    </message>
</context>
<context>
    <name>ui::window::ResumeOffer</name>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>%1: an attempt of %2 was not finished.</source>
        <extracomment>%1: &quot;Tooth 36&quot;, &quot;Practice block: line&quot;; %2: a time of today, or a day and a time</extracomment>
        <translation>%1: Ein Versuch von %2 wurde nicht beendet.</translation>
    </message>
    <message>
        <source>The attempt was discarded; it is kept for seven days.</source>
        <translation>Der Versuch wurde verworfen; er bleibt sieben Tage aufgehoben.</translation>
    </message>
    <message>
        <source>Restore it</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Continue it</source>
        <translation>&amp;Damit weitermachen</translation>
    </message>
    <message>
        <source>This exam would be discarded without a score.</source>
        <translation>Diese Prüfung würde ohne Punktzahl verworfen.</translation>
    </message>
    <message>
        <source>It still counts as an attempt. You can restore it right afterwards.</source>
        <translation>Sie zählt trotzdem als Versuch. Direkt danach können Sie sie noch wiederherstellen.</translation>
    </message>
</context>
<context>
    <name>ui::window::LessonController</name>
    <message>
        <source>The tooth was reset.</source>
        <translation>Der Zahn wurde zurückgesetzt.</translation>
    </message>
    <message>
        <source>Restore my work</source>
        <translation>Arbeit wiederherstellen</translation>
    </message>
    <message>
        <source>Only a tooth with decay has an ideal preparation.</source>
        <translation>Nur ein Zahn mit Karies hat eine ideale Präparation.</translation>
    </message>
    <message>
        <source>The time for this lesson is over. Continue as long as you like, or press G for the grade.</source>
        <translation>Die Zeit für diese Lektion ist um. Arbeiten Sie weiter, solange Sie möchten, oder drücken Sie G für die Bewertung.</translation>
    </message>
    <message>
        <source>The exercise starts again.</source>
        <translation>Die Übung beginnt von vorn.</translation>
    </message>
    <message>
        <source>Another attempt at the exam begins.</source>
        <translation>Ein weiterer Versuch der Prüfung beginnt.</translation>
    </message>
    <message>
        <source>Another attempt at the lesson begins.</source>
        <translation>Ein weiterer Versuch der Lektion beginnt.</translation>
    </message>
    <message>
        <source>The time for this exam is over: cutting is disabled.</source>
        <translation>Die Zeit für diese Prüfung ist um: Schneiden ist nicht mehr möglich.</translation>
    </message>
    <message>
        <source>This exam is over but not graded yet. Press G to grade it.</source>
        <translation>Diese Prüfung ist vorbei, aber noch nicht bewertet. Drücken Sie G, um sie zu bewerten.</translation>
    </message>
    <message>
        <source>Another attempt begins.</source>
        <translation>Ein neuer Versuch beginnt.</translation>
    </message>
    <message>
        <source>The outline is not available in an exam.</source>
        <translation>Der Umriss ist in einer Prüfung nicht verfügbar.</translation>
    </message>
    <message>
        <source>This tooth has no ideal preparation.</source>
        <translation>Für diesen Zahn gibt es keine ideale Präparation.</translation>
    </message>
    <message>
        <source>This attempt has lasted six hours, the longest that Cusp records: cutting is disabled. Press G for the grade, or R for another attempt.</source>
        <translation>Dieser Versuch dauert sechs Stunden, länger zeichnet Cusp keinen auf: Schneiden ist nicht mehr möglich. Drücken Sie G für die Bewertung oder R für einen weiteren Versuch.</translation>
    </message>
</context>
<context>
    <name>ui::window::PracticeController</name>
    <message>
        <source>You can undo the stroke.</source>
        <translation>Sie können den Strich rückgängig machen.</translation>
    </message>
    <message>
        <source>Tooth perforated</source>
        <translation>Zahn perforiert</translation>
    </message>
    <message>
        <source>Pulp opened</source>
        <translation>Pulpa eröffnet</translation>
    </message>
</context>
<context>
    <name>ui::window::ReplayView</name>
    <message>
        <source>The recording has ended.</source>
        <translation>Die Aufzeichnung ist zu Ende.</translation>
    </message>
    <message>
        <source>Stop the replay</source>
        <translation>Wiedergabe beenden</translation>
    </message>
    <message>
        <source>You pushed against the guidance, so it stopped. Press A to start it again.</source>
        <translation>Sie haben gegen die Führung gedrückt, deshalb wurde sie beendet. Mit A beginnt sie wieder.</translation>
    </message>
    <message>
        <source>The handpiece is no longer available, so the guidance stopped.</source>
        <translation>Das Handstück ist nicht mehr verfügbar, deshalb wurde die Führung beendet.</translation>
    </message>
    <message>
        <source>From a file …</source>
        <translation>Aus einer Datei …</translation>
    </message>
</context>
<context>
    <name>ui::window::HardnessController</name>
    <message>
        <source>Import a hardness preset</source>
        <translation>Eine Härte-Voreinstellung importieren</translation>
    </message>
    <message>
        <source>Export the hardness preset</source>
        <translation>Die Härte-Voreinstellung exportieren</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>Den Vergleich sichern</translation>
    </message>
    <message>
        <source>The hardness preset was saved: %1.</source>
        <translation>Die Härte-Voreinstellung wurde gespeichert: %1.</translation>
    </message>
    <message>
        <source>It feels like %1 now.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>Es fühlt sich jetzt an wie %1.</translation>
    </message>
    <message>
        <source>The hardness cannot be changed during an exam.</source>
        <translation>Während einer Prüfung kann die Härte nicht geändert werden.</translation>
    </message>
    <message>
        <source>A replay uses the recorded hardness.</source>
        <translation>Eine Wiedergabe verwendet die aufgezeichnete Härte.</translation>
    </message>
    <message>
        <source>A blind comparison of two presets is running. Finish it first.</source>
        <translation>Ein Blindvergleich zweier Voreinstellungen läuft. Beenden Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>This lesson sets its own hardness. Only the forces can be changed.</source>
        <translation>Diese Lektion legt ihre eigene Härte fest. Nur die Kräfte lassen sich ändern.</translation>
    </message>
    <message>
        <source>There is no hardness preset &quot;%1&quot;. There are: %2.</source>
        <translation>Es gibt keine Härte-Voreinstellung „%1“. Es gibt: %2.</translation>
    </message>
</context>
<context>
    <name>ui::window::AccountController</name>
    <message>
        <source>The one-time code is no longer valid. Ask an admin for a new one.</source>
        <translation>Der Einmalcode gilt nicht mehr. Bitten Sie die Verwaltung um einen neuen.</translation>
    </message>
</context>
<context>
    <name>ui::window::LessonEditing</name>
    <message>
        <source>This file is not a valid lesson, so it cannot be edited. Fix the listed errors first.</source>
        <translation>Diese Datei ist keine gültige Lektion, deshalb kann sie nicht bearbeitet werden. Beheben Sie zuerst die genannten Fehler.</translation>
    </message>
    <message>
        <source>The lesson editor is not available during an exam, because it shows the ideal. Press G to finish the exam, or start another lesson.</source>
        <translation>Der Lektionseditor ist während einer Prüfung nicht verfügbar, denn er zeigt das Ideal. Drücken Sie G, um die Prüfung zu beenden, oder beginnen Sie eine andere Lektion.</translation>
    </message>
    <message>
        <source>Only teachers can edit lessons: log in as a teacher. To practise the lesson, choose it in the list.</source>
        <translation>Nur Lehrkräfte können Lektionen bearbeiten: Melden Sie sich als Lehrkraft an. Um die Lektion zu üben, wählen Sie sie in der Liste.</translation>
    </message>
</context>
<context>
    <name>ui::window::MainWindow</name>
    <message>
        <source>Cusp</source>
        <translation>Cusp</translation>
    </message>
    <message>
        <source>%1 – Cusp</source>
        <extracomment>%1: a lesson; %2: a person and a date</extracomment>
        <translation>%1 – Cusp</translation>
    </message>
    <message>
        <source>This is a replay. Stop it to grade your own work.</source>
        <translation>Das ist eine Wiedergabe. Beenden Sie sie, um Ihre eigene Arbeit bewerten zu lassen.</translation>
    </message>
    <message>
        <source>You cannot drill from below: the bur is on the other side of the tooth. Turn the tooth back, or press V.</source>
        <translation>Von unten können Sie nicht präparieren: Der Bohrer ist auf der anderen Seite des Zahns. Drehen Sie den Zahn zurück oder drücken Sie V.</translation>
    </message>
    <message>
        <source>The simulated handpiece is active</source>
        <extracomment>Beside the name of the tooth, where otherwise &quot;lower left first molar&quot; stands</extracomment>
        <translation>Das simulierte Handstück ist aktiv</translation>
    </message>
    <message>
        <source>Save the X-ray pictures</source>
        <translation>Röntgenbilder speichern</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>ui::kit::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Close this message (Esc)</source>
        <translation>Diese Meldung schließen (Esc)</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>ui::toothchooser::Mouth</name>
    <message>
        <source>Whole mouth</source>
        <translation>Ganzer Mund</translation>
    </message>
    <message>
        <source>Arrow keys move along the arch, Enter selects the tooth.</source>
        <translation>Die Pfeiltasten gehen am Zahnbogen entlang, die Eingabetaste wählt den Zahn.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>This computer cannot draw the whole mouth. Use the flat arches instead.</source>
        <translation>Dieser Computer kann den ganzen Mund nicht zeichnen. Nehmen Sie stattdessen die flachen Zahnbögen.</translation>
    </message>
    <message>
        <source>Creating the teeth …</source>
        <translation>Die Zähne entstehen …</translation>
    </message>
    <message>
        <source>Selected. Press Enter or double-click to use it.</source>
        <translation>Ausgewählt. Eingabetaste oder Doppelklick nimmt ihn.</translation>
    </message>
    <message>
        <source>Click to select it.</source>
        <translation>Klicken wählt ihn.</translation>
    </message>
    <message>
        <source>Only teeth of the left side can be drilled; %1 is its mirror image.</source>
        <translation>Gebohrt werden nur Zähne der linken Seite; sein Spiegelbild ist %1.</translation>
    </message>
    <message>
        <source>Right button turns, wheel zooms. From above or below you see one jaw.</source>
        <translation>Rechte Taste dreht, Rad vergrößert. Von oben oder unten sehen Sie einen Kiefer.</translation>
    </message>
</context>
<context>
    <name>ui::window::PracticeRoom</name>
    <message>
        <source>Move the mouse over the tooth, press the left button to drill; right-drag turns the view; F1 for keys</source>
        <translation>Maus über den Zahn führen, zum Präparieren linke Taste drücken; rechts ziehen dreht die Ansicht; F1 zeigt die Tasten</translation>
    </message>
    <message>
        <source>This attempt</source>
        <translation>Dieser Versuch</translation>
    </message>
</context>
<context>
    <name>ui::kit::ConfirmOverlay</name>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Stay</source>
        <translation>&amp;Bleiben</translation>
    </message>
</context>
<context>
    <name>ui::kit::ScoreBar</name>
    <message>
        <source>%1 of 100, pass mark %2</source>
        <extracomment>A score bar for the screen reader</extracomment>
        <translation>%1 von 100, bestanden ab %2</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>bestanden ab %1</translation>
    </message>
</context>
<context>
    <name>ui::kit::ScrollPane</name>
    <message>
        <source>More than there is room for</source>
        <translation>Mehr, als Platz hat</translation>
    </message>
    <message>
        <source>Page Up, Page Down and the arrow keys scroll</source>
        <translation>Bild auf, Bild ab und die Pfeiltasten blättern</translation>
    </message>
</context>
<context>
    <name>ui::practice::SidePanel</name>
    <message>
        <source>Live figures and handpiece</source>
        <translation>Messwerte und Handstück</translation>
    </message>
    <message>
        <source>Under the bur</source>
        <translation>Unter dem Bohrer</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Decay left</source>
        <extracomment>Of what is to be taken away: decay, or the preparation that is asked for</extracomment>
        <translation>Restkaries</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Abgetragen</translation>
    </message>
    <message>
        <source>Bur</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>Air</source>
        <comment>the bur touches nothing</comment>
        <translation>Kein Kontakt</translation>
    </message>
    <message>
        <source>N, limited</source>
        <extracomment>Unit of the force while the wanted force is beyond what the device may give</extracomment>
        <translation>N, begrenzt</translation>
    </message>
    <message>
        <source>&lt; 1</source>
        <translation>&lt; 1</translation>
    </message>
    <message>
        <source>Depth of the tip below the original surface. No value is shown at the edge of the tooth, where a vertical depth means little.</source>
        <translation>Tiefe der Spitze unter der ursprünglichen Oberfläche. Am Rand des Zahns wird kein Wert angezeigt, weil die senkrechte Tiefe dort wenig aussagt.</translation>
    </message>
    <message>
        <source>Area of opened pulp, seen from above. The grade uses this figure.</source>
        <translation>Fläche der eröffneten Pulpa, von oben gesehen. Die Bewertung verwendet diesen Wert.</translation>
    </message>
    <message>
        <source>N, %1 sideways</source>
        <extracomment>Unit of the force, and how much of it comes from a wall that presses sideways</extracomment>
        <translation>N, %1 seitlich</translation>
    </message>
    <message>
        <source>beside the decay</source>
        <translation>neben der Karies</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation>Handstück</translation>
    </message>
    <message>
        <source>The handpiece touches the crown, so the bur cannot go deeper.</source>
        <translation>Das Handstück berührt die Krone, deshalb kommt der Bohrer nicht tiefer.</translation>
    </message>
    <message>
        <source>To the pulp</source>
        <translation>Bis zur Pulpa</translation>
    </message>
    <message>
        <source>Shortest distance from the head of the bur to the pulp, downwards or sideways. Leave two millimetres; less than half a millimetre harms the pulp.</source>
        <translation>Kürzester Abstand vom Bohrerkopf zur Pulpa, nach unten oder seitlich. Lassen Sie zwei Millimeter stehen; weniger als ein halber Millimeter schadet der Pulpa.</translation>
    </message>
    <message>
        <source>To the limit</source>
        <extracomment>How far the bur is from what is to be kept</extracomment>
        <translation>Bis zur Grenze</translation>
    </message>
    <message>
        <source>Distance from the head of the bur to tissue that must be kept, downwards or sideways. No value is shown above one millimetre.</source>
        <translation>Abstand vom Kopf des Bohrers zu Gewebe, das erhalten bleiben muss, nach unten oder zur Seite. Über einem Millimeter wird kein Wert angezeigt.</translation>
    </message>
    <message>
        <source>Speed of the bur in revolutions per minute. Load slows it down until it stalls</source>
        <translation>Drehzahl des Bohrers in Umdrehungen pro Minute. Last bremst ihn, bis er stehen bleibt</translation>
    </message>
    <message>
        <source>rpm</source>
        <extracomment>Turns a minute</extracomment>
        <translation>U/min</translation>
    </message>
    <message>
        <source>Still to cut</source>
        <translation>Noch abzutragen</translation>
    </message>
    <message>
        <source>beyond the ideal</source>
        <translation>über das Ideal hinaus</translation>
    </message>
    <message>
        <source>Block</source>
        <extracomment>What a practice block is made of, in place of &quot;Enamel&quot;</extracomment>
        <translation>Block</translation>
    </message>
</context>
<context>
    <name>ui::practice::StereoCard</name>
    <message>
        <source>Distance of the eyes</source>
        <translation>Abstand der Augen</translation>
    </message>
    <message>
        <source>Plane of the screen</source>
        <translation>Ebene des Bildschirms</translation>
    </message>
    <message>
        <source>Stereo picture</source>
        <translation>Stereobild</translation>
    </message>
    <message>
        <source>Way to the eyes</source>
        <translation>Weg zu den Augen</translation>
    </message>
    <message>
        <source>Red and cyan glasses, in colour</source>
        <translation>Rot-Cyan-Brille, in Farbe</translation>
    </message>
    <message>
        <source>Red and cyan glasses, in grey</source>
        <translation>Rot-Cyan-Brille, in Grau</translation>
    </message>
    <message>
        <source>Halves side by side</source>
        <translation>Hälften nebeneinander</translation>
    </message>
    <message>
        <source>Halves one above the other</source>
        <translation>Hälften übereinander</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Without stereo</source>
        <translation>Ohne Stereo</translation>
    </message>
    <message>
        <source>1. How do the two pictures reach your eyes? Close one eye, then the other: each must see a single tooth.</source>
        <translation>1. Wie kommen die beiden Bilder zu Ihren Augen? Schließen Sie erst das eine, dann das andere: Jedes muss einen einzigen Zahn sehen.</translation>
    </message>
    <message>
        <source>2. Move the eyes apart until the cusps stand up from the fissures, and back a little if it tires you.</source>
        <translation>2. Rücken Sie die Augen auseinander, bis die Höcker sich aus den Fissuren heben; ein wenig zurück, wenn es anstrengt.</translation>
    </message>
    <message>
        <source>3. Move the tooth before or behind the screen until you see it without effort.</source>
        <translation>3. Rücken Sie den Zahn vor oder hinter den Bildschirm, bis Sie ihn mühelos sehen.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Discard the changes (Esc)</source>
        <translation>Änderungen verwerfen (Esc)</translation>
    </message>
</context>
<context>
    <name>ui::toothchooser::ToothChooser</name>
    <message>
        <source>Choose a tooth</source>
        <translation>Zahn wählen</translation>
    </message>
    <message>
        <source>Drill this tooth</source>
        <translation>Diesen Zahn präparieren</translation>
    </message>
    <message>
        <source>Practise on this tooth (Enter)</source>
        <translation>An diesem Zahn üben (Eingabe)</translation>
    </message>
    <message>
        <source>Or drill your own tooth: a scan as an OBJ, STL or PLY file. You can also drop the file anywhere on this window.</source>
        <translation>Oder präparieren Sie einen eigenen Zahn: einen Scan als OBJ, STL oder PLY. Sie können die Datei auch irgendwo auf dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>No tooth selected</source>
        <translation>Kein Zahn gewählt</translation>
    </message>
    <message>
        <source>In use. Choosing it again resets it.</source>
        <translation>In Arbeit. Wenn Sie ihn noch einmal wählen, wird er zurückgesetzt.</translation>
    </message>
    <message>
        <source>Click a tooth, or use the arrow keys.</source>
        <translation>Klicken Sie einen Zahn an oder wählen Sie mit den Pfeiltasten.</translation>
    </message>
    <message>
        <source>Flat arches</source>
        <translation>Zahnbögen</translation>
    </message>
    <message>
        <source>Whole mouth</source>
        <translation>Ganzer Mund</translation>
    </message>
</context>
<context>
    <name>ui::window::Tour</name>
    <message>
        <source>Move the bur with the mouse and press the left button to drill. Drag with the right button to turn the view.</source>
        <translation>Führen Sie den Bohrer mit der Maus, und drücken Sie zum Präparieren die linke Taste. Ziehen mit der rechten Taste dreht die Ansicht.</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>The lessons that come with Cusp, and your own. Search for a word or the number of a tooth.</source>
        <translation>Die Lektionen von Cusp und Ihre eigenen. Suchen Sie nach einem Wort oder der Nummer eines Zahns.</translation>
    </message>
    <message>
        <source>Change a lesson</source>
        <translation>Eine Lektion ändern</translation>
    </message>
    <message>
        <source>Change the goal and the rubric of a lesson, and see the effect on earlier attempts.</source>
        <translation>Ändern Sie Ziel und Bewertungsschema einer Lektion, und sehen Sie die Wirkung auf frühere Versuche.</translation>
    </message>
    <message>
        <source>Your classes</source>
        <translation>Ihre Klassen</translation>
    </message>
    <message>
        <source>Here you see who needs help and how everybody is doing. Assign lessons, open attempts, replay them, and write comments.</source>
        <translation>Hier sehen Sie, wer Hilfe braucht und wie alle vorankommen. Geben Sie Lektionen auf, öffnen Sie Versuche, spielen Sie sie ab und schreiben Sie Kommentare.</translation>
    </message>
    <message>
        <source>Try it yourself</source>
        <translation>Selbst versuchen</translation>
    </message>
    <message>
        <source>The grade</source>
        <translation>Die Bewertung</translation>
    </message>
    <message>
        <source>Your work is measured, and the score card shows where and when each point was lost.</source>
        <translation>Ihre Arbeit wird vermessen, und das Bewertungsblatt zeigt, wo und wann jeder Punkt verloren ging.</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>The results of every class in every lesson, as its teachers see them.</source>
        <translation>Die Ergebnisse jeder Klasse in jeder Lektion, so wie ihre Lehrkräfte sie sehen.</translation>
    </message>
    <message>
        <source>How it feels</source>
        <translation>Wie es sich anfühlt</translation>
    </message>
    <message>
        <source>Burs, force and depth are here. The hardness presets (F7) set how hard teeth are.</source>
        <translation>Bohrer, Kraft und Tiefe stehen hier. Wie hart Zähne sind, bestimmen die Härte-Voreinstellungen (F7).</translation>
    </message>
    <message>
        <source>The tooth</source>
        <translation>Der Zahn</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Choose here what to practise. Lessons assigned to your class come first.</source>
        <translation>Wählen Sie hier, was Sie üben. Die Lektionen, die Ihrer Klasse aufgegeben sind, stehen zuerst.</translation>
    </message>
    <message>
        <source>Choose here what to practise. Each lesson states its goal and how it is graded.</source>
        <translation>Wählen Sie hier, was Sie üben. Jede Lektion nennt ihr Ziel und ihre Bewertung.</translation>
    </message>
    <message>
        <source>Bur, force and depth</source>
        <translation>Bohrer, Kraft und Tiefe</translation>
    </message>
    <message>
        <source>Change the bur, set how hard the mouse presses, and read force and depth while you drill.</source>
        <translation>Wechseln Sie den Bohrer, stellen Sie ein, wie fest die Maus drückt, und lesen Sie beim Präparieren Kraft und Tiefe ab.</translation>
    </message>
    <message>
        <source>Seeing inside</source>
        <translation>Hineinsehen</translation>
    </message>
    <message>
        <source>A live section through the bur shows enamel, dentin and pulp, where the lesson allows it.</source>
        <translation>Ein mitlaufender Schnitt durch den Bohrer zeigt Schmelz, Dentin und Pulpa, wo die Lektion es erlaubt.</translation>
    </message>
    <message>
        <source>See how your scores develop, read your instructor&apos;s comments, and replay every attempt.</source>
        <translation>Sehen Sie, wie sich Ihre Punkte entwickeln, lesen Sie die Kommentare Ihrer Lehrkraft, und spielen Sie jeden Versuch ab.</translation>
    </message>
    <message>
        <source>Your account</source>
        <translation>Ihr Konto</translation>
    </message>
    <message>
        <source>Log in to save your grades. Without a login, nothing is saved.</source>
        <translation>Melden Sie sich an, damit Ihre Bewertungen gespeichert werden. Ohne Anmeldung wird nichts gespeichert.</translation>
    </message>
    <message>
        <source>Lock the window when you leave, or switch user.</source>
        <translation>Sperren Sie das Fenster, wenn Sie gehen, oder wechseln Sie den Benutzer.</translation>
    </message>
    <message>
        <source>Every key</source>
        <translation>Alle Tasten</translation>
    </message>
    <message>
        <source>All keys are listed here. You can also start this tour again from there.</source>
        <translation>Hier stehen alle Tasten. Von dort können Sie auch diesen Rundgang wieder starten.</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Skip the tour</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Steps of a tour: &quot;2 of 6&quot;</extracomment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>The school</source>
        <translation>Die Schule</translation>
    </message>
    <message>
        <source>Add people one by one or from a list, assign them to classes, and manage backups and the audit.</source>
        <translation>Fügen Sie Personen einzeln oder aus einer Liste hinzu, teilen Sie sie Klassen zu, und verwalten Sie Sicherungen und Prüfprotokoll.</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>Meine Versuche</translation>
    </message>
</context>
<context>
    <name>ui::kit::UnsavedChanges</name>
    <message>
        <source>Discard your unsaved changes?</source>
        <extracomment>%1: a user</extracomment>
        <translation>Ihre nicht gespeicherten Änderungen verwerfen?</translation>
    </message>
    <message>
        <source>Discard the unsaved changes of %1?</source>
        <translation>Die nicht gespeicherten Änderungen von %1 verwerfen?</translation>
    </message>
    <message>
        <source>&amp;Keep editing</source>
        <translation>&amp;Weiter bearbeiten</translation>
    </message>
</context>
<context>
    <name>ui::practice::ViewMenu</name>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Choose what the view shows</source>
        <translation>Wählen, was die Ansicht zeigt</translation>
    </message>
    <message>
        <source>Look from</source>
        <translation>Blick von</translation>
    </message>
    <message>
        <source>Occlusal</source>
        <translation>Okklusal</translation>
    </message>
    <message>
        <source>Buccal</source>
        <translation>Bukkal</translation>
    </message>
    <message>
        <source>Lingual</source>
        <translation>Lingual</translation>
    </message>
    <message>
        <source>Mesial</source>
        <translation>Mesial</translation>
    </message>
    <message>
        <source>Distal</source>
        <translation>Distal</translation>
    </message>
    <message>
        <source>Apical</source>
        <translation>Apikal</translation>
    </message>
</context>
<context>
    <name>ui::scoring::AdviceWords</name>
    <message>
        <source>You drilled right through the tooth. Check the depth in the section while you go down.</source>
        <translation>Sie haben den Zahn durchbohrt. Prüfen Sie beim Absenken die Tiefe im Schnitt.</translation>
    </message>
    <message>
        <source>The bur went down at %1 mm/s when it opened the pulp. Go down slowly, and stop when the floor is firm dentin.</source>
        <extracomment>%1 is a speed in mm/s</extracomment>
        <translation>Der Bohrer ging mit %1 mm/s nach unten, als er die Pulpa eröffnete. Gehen Sie langsam tiefer und halten Sie an, wenn der Boden festes Dentin ist.</translation>
    </message>
    <message>
        <source>You opened the pulp. Check in the section how much dentin is left before you go deeper, and stop when the floor is firm dentin.</source>
        <translation>Sie haben die Pulpa eröffnet. Prüfen Sie im Schnitt, wie viel Dentin übrig ist, bevor Sie tiefer gehen, und halten Sie an, wenn der Boden festes Dentin ist.</translation>
    </message>
    <message>
        <source>The pulp chamber is not open yet. Go on at the place that the X-ray shows until its roof is gone.</source>
        <translation>Die Pulpakammer ist noch nicht eröffnet. Arbeiten Sie an der Stelle weiter, die das Röntgenbild zeigt, bis ihr Dach entfernt ist.</translation>
    </message>
    <message>
        <source>%1 % of the decay is still in the tooth. Clean the walls first and then the floor, until no brown is left.</source>
        <extracomment>%1 is a share in per cent</extracomment>
        <translation>%1 % der Karies sind noch im Zahn. Säubern Sie zuerst die Wände und dann den Boden, bis kein Braun mehr zu sehen ist.</translation>
    </message>
    <message>
        <source>The bur went down at %1 mm/s into sound tissue. Lift it as soon as the figure turns yellow.</source>
        <extracomment>%1 is a speed in mm/s</extracomment>
        <translation>Der Bohrer ging mit %1 mm/s in gesundes Gewebe. Heben Sie ihn ab, sobald die Zahl gelb wird.</translation>
    </message>
    <message>
        <source>You removed %1 mm³ of sound tissue. Follow the brown edge, and take a smaller bur near it.</source>
        <extracomment>%1 is a volume in mm³</extracomment>
        <translation>Sie haben %1 mm³ gesundes Gewebe entfernt. Folgen Sie dem braunen Rand und nehmen Sie in seiner Nähe einen kleineren Bohrer.</translation>
    </message>
    <message>
        <source>Enamel is left without dentin under it. Remove the overhanging edge.</source>
        <translation>Unter dem Schmelz fehlt stellenweise Dentin. Entfernen Sie den überhängenden Rand.</translation>
    </message>
    <message>
        <source>The bur went down at %1 mm/s and past the floor. Go down slowly, or set the depth stop.</source>
        <extracomment>%1 is a speed in mm/s</extracomment>
        <translation>Der Bohrer ging mit %1 mm/s über den Boden hinaus. Gehen Sie langsam tiefer oder stellen Sie den Tiefenanschlag ein.</translation>
    </message>
    <message>
        <source>The floor is up to %1 mm too deep. Set the depth stop to the depth that the lesson asks for.</source>
        <translation>Der Boden ist bis zu %1 mm zu tief. Stellen Sie den Tiefenanschlag auf die Tiefe ein, die die Lektion verlangt.</translation>
    </message>
    <message>
        <source>The floor is too deep. Set the depth stop to the depth that the lesson asks for.</source>
        <translation>Der Boden ist zu tief. Stellen Sie den Tiefenanschlag auf die Tiefe ein, die die Lektion verlangt.</translation>
    </message>
    <message>
        <source>The floor is up to %1 mm too high. Lower it with the depth stop at the depth that the lesson asks for.</source>
        <translation>Der Boden ist bis zu %1 mm zu hoch. Senken Sie ihn mit dem Tiefenanschlag auf der Tiefe, die die Lektion verlangt.</translation>
    </message>
    <message>
        <source>%1 % of the preparation is still standing. Compare with the outline and cut what is left inside it.</source>
        <extracomment>%1 is a share in per cent</extracomment>
        <translation>%1 % der Präparation stehen noch. Vergleichen Sie mit dem Umriss und entfernen Sie, was darin übrig ist.</translation>
    </message>
    <message>
        <source>You cut up to %1 mm outside the outline. Keep the edge of the bur, not its middle, on the line.</source>
        <translation>Sie haben bis zu %1 mm außerhalb des Umrisses geschnitten. Führen Sie den Rand des Bohrers, nicht seine Mitte, an der Linie.</translation>
    </message>
    <message>
        <source>You cut outside the outline. Keep the edge of the bur, not its middle, on the line.</source>
        <translation>Sie haben außerhalb des Umrisses geschnitten. Führen Sie den Rand des Bohrers, nicht seine Mitte, an der Linie.</translation>
    </message>
    <message>
        <source>The outline stays up to %1 mm inside the ideal one. Widen the cavity to the line.</source>
        <translation>Der Umriss bleibt bis zu %1 mm innerhalb des idealen. Erweitern Sie die Kavität bis zur Linie.</translation>
    </message>
    <message>
        <source>The marginal ridge is only %1 mm wide; it should keep %2 mm. Stop earlier on the way to the ridge.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>Die Randleiste ist nur %1 mm breit; %2 mm sollen stehen bleiben. Halten Sie auf dem Weg zur Randleiste früher an.</translation>
    </message>
    <message>
        <source>The isthmus is %1 mm too wide. Go through it once, with a bur that is not wider than it.</source>
        <translation>Der Isthmus ist %1 mm zu breit. Fahren Sie einmal hindurch, mit einem Bohrer, der nicht breiter ist.</translation>
    </message>
    <message>
        <source>The isthmus is %1 mm too narrow. Widen it evenly on both sides.</source>
        <translation>Der Isthmus ist %1 mm zu schmal. Erweitern Sie ihn auf beiden Seiten gleichmäßig.</translation>
    </message>
    <message>
        <source>A wall leans %1° from the ideal. Move the bur along the wall in one stroke at full depth.</source>
        <translation>Eine Wand weicht um %1° vom Ideal ab. Führen Sie den Bohrer in einem Zug auf voller Tiefe an der Wand entlang.</translation>
    </message>
    <message>
        <source>The floor is uneven. Keep the depth stop on, and sweep the floor in strokes that overlap.</source>
        <translation>Der Boden ist uneben. Lassen Sie den Tiefenanschlag eingeschaltet und führen Sie den Bohrer in überlappenden Zügen über den Boden.</translation>
    </message>
    <message>
        <source>Too little is done to judge this. Finish the preparation first.</source>
        <translation>Es ist zu wenig getan, um das zu beurteilen. Beenden Sie zuerst die Präparation.</translation>
    </message>
    <message>
        <source>You pushed too hard. Let the bur do the work.</source>
        <translation>Sie haben zu stark gedrückt. Lassen Sie den Bohrer arbeiten.</translation>
    </message>
    <message>
        <source>Watch the gauge and change the force slowly until it stays in the range.</source>
        <translation>Beobachten Sie die Anzeige und ändern Sie die Kraft langsam, bis sie im Bereich bleibt.</translation>
    </message>
    <message>
        <source>You took longer than asked. Plan the strokes before you begin.</source>
        <translation>Sie haben länger gebraucht als verlangt. Planen Sie die Züge, bevor Sie beginnen.</translation>
    </message>
    <message>
        <source>Some points are not touched yet. The ring marks one of them.</source>
        <translation>Einige Punkte sind noch nicht berührt. Der Ring markiert einen davon.</translation>
    </message>
    <message>
        <source>Touch each pad slowly again: enamel is hardest, dentin yields, decay is soft.</source>
        <translation>Berühren Sie jede Fläche noch einmal langsam: Schmelz ist am härtesten, Dentin gibt nach, Karies ist weich.</translation>
    </message>
    <message>
        <source>You cut the tooth. In this exercise the bur only touches it: do not press the drill.</source>
        <translation>Sie haben den Zahn angeschnitten. In dieser Übung berührt ihn der Bohrer nur: Schalten Sie den Bohrer nicht ein.</translation>
    </message>
    <message>
        <source>Only %1 mm of dentin is left over the pulp. Watch the figure for the remaining dentin, and stop earlier.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>Über der Pulpa sind nur noch %1 mm Dentin. Achten Sie auf die Anzeige des verbliebenen Dentins und hören Sie früher auf.</translation>
    </message>
    <message>
        <source>You cut the tooth %1 mm away from the decay. Lift the bur before you move it, and cut at the decay only.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>Sie haben den Zahn %1 mm neben der Karies beschliffen. Heben Sie den Bohrer ab, bevor Sie ihn bewegen, und bohren Sie nur an der Karies.</translation>
    </message>
    <message>
        <source>The cavity goes %1 mm below the decay. Stop as soon as no brown is left at the bottom.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>Die Kavität reicht %1 mm unter die Karies. Hören Sie auf, sobald am Boden nichts Braunes mehr ist.</translation>
    </message>
    <message>
        <source>The floor is still in enamel. Lower it until it lies just inside dentin.</source>
        <translation>Der Boden liegt noch im Schmelz. Senken Sie ihn, bis er gerade im Dentin liegt.</translation>
    </message>
    <message>
        <source>The floor is tilted by %1°. Keep the depth stop on, and compare both ends in the section.</source>
        <translation>Der Boden ist um %1° geneigt. Lassen Sie den Tiefenanschlag an und vergleichen Sie beide Enden im Schnitt.</translation>
    </message>
    <message>
        <source>The turning bur touched the neighbouring tooth. Leave a thin shell of enamel towards it, and break it off last.</source>
        <translation>Der drehende Bohrer hat den Nachbarzahn berührt. Lassen Sie zu ihm hin eine dünne Schmelzwand stehen und entfernen Sie sie zuletzt.</translation>
    </message>
    <message>
        <source>The walls are wavy. Go along each wall once more with the side of the bur, in one light stroke.</source>
        <translation>Die Wände sind wellig. Fahren Sie jede Wand noch einmal mit der Seite des Bohrers ab, in einem leichten Zug.</translation>
    </message>
    <message>
        <source>Only %1 mm of the oblique ridge is left; it should keep %2 mm. Stop earlier on both sides of it.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>Von der schrägen Leiste sind nur %1 mm übrig; es sollen %2 mm bleiben. Halten Sie auf beiden Seiten früher an.</translation>
    </message>
    <message>
        <source>The gingival floor is %1 mm off the height that the lesson asks for. Check its depth in the section before you widen the box.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>Der gingivale Boden weicht um %1 mm von der verlangten Höhe ab. Prüfen Sie seine Tiefe im Schnitt, bevor Sie den Kasten verbreitern.</translation>
    </message>
    <message>
        <source>The axial wall of the box is %1 mm too far inside the tooth. Compare the depth of the box with the width of the bur before you go on inwards.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>Die axiale Wand des Kastens liegt %1 mm zu weit innen. Vergleichen Sie die Tiefe des Kastens mit der Breite des Bohrers, bevor Sie weiter nach innen gehen.</translation>
    </message>
    <message>
        <source>The axial wall of the box is %1 mm too far outside. Move the bur inwards along the whole wall.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>Die axiale Wand des Kastens liegt %1 mm zu weit außen. Führen Sie den Bohrer entlang der ganzen Wand weiter nach innen.</translation>
    </message>
    <message>
        <source>The %1 mm pit is %2 mm too deep. Lift the bur sooner, and compare the depth with the head of the bur.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>Die Vertiefung von %1 mm ist um %2 mm zu tief. Heben Sie den Bohrer früher ab und vergleichen Sie die Tiefe mit seinem Kopf.</translation>
    </message>
    <message>
        <source>The %1 mm pit is %2 mm too shallow. Go down in short steps, and compare the depth with the head of the bur.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>Die Vertiefung von %1 mm ist um %2 mm zu flach. Gehen Sie in kleinen Schritten tiefer und vergleichen Sie die Tiefe mit dem Kopf des Bohrers.</translation>
    </message>
    <message>
        <source>You cut %1 mm³ of dentin. Stop as soon as the bur sinks more easily and the floor looks yellow.</source>
        <extracomment>%1 is a volume in mm³</extracomment>
        <translation>Sie haben %1 mm³ Dentin abgetragen. Halten Sie an, sobald der Bohrer leichter sinkt und der Boden gelb aussieht.</translation>
    </message>
    <message>
        <source>Up to %1 mm of enamel is left on the floor. Cut on with light strokes until the bur meets less resistance.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>Am Boden sind noch bis zu %1 mm Schmelz. Arbeiten Sie mit leichten Zügen weiter, bis der Widerstand nachlässt.</translation>
    </message>
    <message>
        <source>%1 % of the soft decay is still in the tooth. Remove it from the walls and the floor until the bur meets more resistance.</source>
        <extracomment>%1 is a share in per cent</extracomment>
        <translation>%1 % der weichen Karies sind noch im Zahn. Entfernen Sie sie von den Wänden und vom Boden, bis der Bohrer auf mehr Widerstand trifft.</translation>
    </message>
    <message>
        <source>Leathery decay is left on %1 mm² that do not lie over the pulp. Remove it there down to firm dentin.</source>
        <extracomment>%1 is an area in mm²</extracomment>
        <translation>Auf %1 mm², die nicht über der Pulpa liegen, ist lederartige Karies verblieben. Entfernen Sie sie dort bis zum festen Dentin.</translation>
    </message>
    <message>
        <source>Decay is left at the enamel-dentin junction on %1 mm². Clean the junction all the way round.</source>
        <extracomment>%1 is an area in mm²</extracomment>
        <translation>An der Schmelz-Dentin-Grenze ist auf %1 mm² Karies verblieben. Säubern Sie die Grenze ringsum.</translation>
    </message>
    <message>
        <source>The cavity goes %1 mm deeper than the decay that had to be removed. Stop at firm dentin, and over the pulp at leathery dentin.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>Die Kavität reicht %1 mm tiefer als die Karies, die zu entfernen war. Hören Sie bei festem Dentin auf, über der Pulpa bei lederartigem.</translation>
    </message>
    <message>
        <source>A marginal ridge that should stay is %1 mm thinner than it should be. Stop earlier on the way to the ridge.</source>
        <translation>Eine Randleiste, die stehen bleiben soll, ist um %1 mm zu dünn. Halten Sie auf dem Weg zur Leiste früher an.</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ConductNotes</name>
    <message>
        <source>No breach of the rules</source>
        <translation>Kein Verstoß gegen die Regeln</translation>
    </message>
    <message numerus="yes">
        <source>%n breach(es) of the rules</source>
        <translation>
            <numerusform>%n Verstoß gegen die Regeln</numerusform>
            <numerusform>%n Verstöße gegen die Regeln</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>Replay the attempt from this moment</source>
        <translation>Den Versuch ab diesem Moment abspielen</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>breaches</comment>
        <translation>
            <numerusform>%n weiterer</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Show every breach</source>
        <translation>Alle Verstöße zeigen</translation>
    </message>
    <message>
        <source>%1 in total, %2 of it cutting</source>
        <extracomment>Two times in minutes and seconds</extracomment>
        <translation>%1 insgesamt, davon %2 schneidend</translation>
    </message>
    <message>
        <source>force: mean %1 N, maximum %2 N</source>
        <translation>Kraft: Mittel %1 N, Maximum %2 N</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) undone</source>
        <translation>
            <numerusform>%n Schritt zurückgenommen</numerusform>
            <numerusform>%n Schritte zurückgenommen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::scoring::CriterionRow</name>
    <message>
        <source>%1 not measured</source>
        <extracomment>%1: points of a score. What could not be measured earns nothing</extracomment>
        <translation>%1 nicht gemessen</translation>
    </message>
    <message>
        <source>%1 not removed</source>
        <translation>%1 nicht entfernt</translation>
    </message>
    <message>
        <source>%1 not achieved</source>
        <extracomment>Of a criterion that was not fulfilled at any time</extracomment>
        <translation>%1 nicht erreicht</translation>
    </message>
    <message>
        <source>%1 at %2, stroke %3</source>
        <extracomment>%1: points lost, %2: minutes and seconds of the attempt, %3: number of a stroke of the bur</extracomment>
        <translation>%1 bei %2, Strich %3</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>The exposed area, seen from above. The side panel shows the removed volume, in mm³.</source>
        <translation>Die freigelegte Fläche, von oben gesehen. Die Seitenleiste zeigt das abgetragene Volumen in mm³.</translation>
    </message>
    <message>
        <source>The attempt fails and all remaining points are lost</source>
        <extracomment>Tooltip on the points of one criterion</extracomment>
        <translation>Der Versuch ist nicht bestanden, alle übrigen Punkte sind verloren</translation>
    </message>
    <message>
        <source>At most %1 points can be lost here</source>
        <translation>Hier gehen höchstens %1 Punkte verloren</translation>
    </message>
    <message>
        <source>%1: %2, %3 points</source>
        <extracomment>A row of a score, for the screen reader: %1 a criterion, %2 what was measured, %3 the points it cost</extracomment>
        <translation>%1: %2, %3 Punkte</translation>
    </message>
    <message>
        <source>Show the worst place</source>
        <translation>Die schlimmste Stelle zeigen</translation>
    </message>
    <message>
        <source>Replay the attempt from this moment</source>
        <translation>Den Versuch ab diesem Moment abspielen</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>moments at which points were lost</comment>
        <translation>
            <numerusform>%n weiterer</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Show every moment</source>
        <translation>Jeden Zeitpunkt zeigen</translation>
    </message>
    <message>
        <source>%1 too late</source>
        <extracomment>%1: points of a score, for something that was done later than asked</extracomment>
        <translation>%1 zu spät</translation>
    </message>
    <message>
        <source>%1 work incomplete</source>
        <extracomment>%1: points of a score that is earned only when enough of the work is done</extracomment>
        <translation>%1 Arbeit unvollständig</translation>
    </message>
    <message>
        <source>This error limits the score to %1 points</source>
        <translation>Dieser Fehler begrenzt die Punktzahl auf %1</translation>
    </message>
</context>
<context>
    <name>ui::practice::ExerciseCard</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is &quot;Left&quot;, &quot;Middle&quot; or &quot;Right&quot;, %2 a tissue</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Choose this material for the pad; you can change it until you are graded</source>
        <translation>Dieses Material für das Feld wählen; bis zur Bewertung können Sie es ändern</translation>
    </message>
    <message>
        <source>✓ right</source>
        <extracomment>Beside what the student took a pad for; %1 is the tissue that it is</extracomment>
        <translation>✓ richtig</translation>
    </message>
    <message>
        <source>✗ it is %1</source>
        <translation>✗ es ist %1</translation>
    </message>
    <message numerus="yes">
        <source>All %n points touched</source>
        <translation>
            <numerusform>%n Punkt berührt</numerusform>
            <numerusform>Alle %n Punkte berührt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 points touched</source>
        <translation>%1 von %2 Punkten berührt</translation>
    </message>
    <message>
        <source>Held for %1 s</source>
        <extracomment>%1 is a time in seconds</extracomment>
        <translation>%1 s gehalten</translation>
    </message>
    <message>
        <source>Hold %1 N for %2 s</source>
        <translation>%1 N für %2 s halten</translation>
    </message>
    <message>
        <source>of %1 s</source>
        <extracomment>Behind the seconds that a force has been held: of how many</extracomment>
        <translation>von %1 s</translation>
    </message>
    <message>
        <source>The materials of the pads</source>
        <translation>Die Materialien der Felder</translation>
    </message>
    <message>
        <source>Every pad has an answer</source>
        <translation>Jedes Feld hat eine Antwort</translation>
    </message>
    <message>
        <source>What is each pad made of?</source>
        <translation>Woraus besteht jedes Feld?</translation>
    </message>
    <message>
        <source>Graded. Press F2 for the next lesson.</source>
        <translation>Bewertet. Drücken Sie F2 für die nächste Lektion.</translation>
    </message>
    <message>
        <source>Well done. Press G for your grade.</source>
        <translation>Gut gemacht. Drücken Sie G für die Bewertung.</translation>
    </message>
    <message>
        <source>Sure? Then press G for your grade.</source>
        <translation>Sicher? Dann drücken Sie G für die Bewertung.</translation>
    </message>
    <message>
        <source>The bur is turning. Stop it with the space bar: this exercise needs no cutting.</source>
        <translation>Der Bohrer läuft. Halten Sie ihn mit der Leertaste an: In dieser Übung wird nichts geschnitten.</translation>
    </message>
    <message>
        <source>Start the bur with the space bar: while it is stopped, all three feel the same.</source>
        <translation>Starten Sie den Bohrer mit der Leertaste: Solange er steht, fühlen sich alle drei gleich an.</translation>
    </message>
    <message>
        <source>Longest so far: %1 s</source>
        <extracomment>%1 is a time in seconds</extracomment>
        <translation>Am längsten bisher: %1 s</translation>
    </message>
    <message>
        <source>Any order. A ring becomes a disc when touched.</source>
        <translation>In beliebiger Reihenfolge. Ein berührter Ring wird zur Scheibe.</translation>
    </message>
    <message>
        <source>Anywhere on the tooth.</source>
        <translation>Irgendwo auf dem Zahn.</translation>
    </message>
    <message>
        <source>Press on each for a second, and compare.</source>
        <translation>Drücken Sie auf jedes eine Sekunde lang und vergleichen Sie.</translation>
    </message>
</context>
<context>
    <name>ui::scoring::FeedbackCard</name>
    <message>
        <source>%1 commented on your attempt: %2</source>
        <extracomment>%1: a teacher; %2: a lesson</extracomment>
        <translation>%1 hat Ihren Versuch kommentiert: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n of your attempts have new feedback</source>
        <translation>
            <numerusform>Zu %n Ihrer Versuche gibt es neue Rückmeldungen</numerusform>
            <numerusform>Zu %n Ihrer Versuche gibt es neue Rückmeldungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>Meine Versuche</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ScorePredictionPage</name>
    <message>
        <source>Before you see the score</source>
        <translation>Bevor Sie die Note sehen</translation>
    </message>
    <message>
        <source>How many points do you expect?</source>
        <translation>Wie viele Punkte erwarten Sie?</translation>
    </message>
    <message>
        <source>What cost you most?</source>
        <translation>Was hat am meisten gekostet?</translation>
    </message>
    <message>
        <source>Show the score</source>
        <translation>Note zeigen</translation>
    </message>
    <message>
        <source>Show how your work was graded (Enter)</source>
        <translation>Zeigen, wie Ihre Arbeit bewertet wurde (Eingabe)</translation>
    </message>
    <message>
        <source>%1. The pass mark is %2 of 100 points. You learn more from a score if you assess your own work first.</source>
        <extracomment>%1 is a lesson, %2 the mark that is needed</extracomment>
        <translation>%1. Bestanden ist ab %2 von 100 Punkten. Sie lernen mehr aus einer Bewertung, wenn Sie Ihre Arbeit zuerst selbst beurteilen.</translation>
    </message>
    <message>
        <source>Set the points that you expect.</source>
        <translation>Stellen Sie ein, wie viele Punkte Sie erwarten.</translation>
    </message>
</context>
<context>
    <name>ui::scoring::HeatMap</name>
    <message>
        <source>The tooth from above, coloured by what is too deep and what is still to cut</source>
        <translation>Der Zahn von oben, gefärbt nach dem, was zu tief ist und was noch fehlt</translation>
    </message>
    <message>
        <source>as it should be</source>
        <translation>wie es sein soll</translation>
    </message>
    <message>
        <source>%1 mm too deep</source>
        <translation>%1 mm zu tief</translation>
    </message>
    <message>
        <source>%1 mm still to cut</source>
        <translation>%1 mm fehlen noch</translation>
    </message>
    <message>
        <source>still to cut</source>
        <translation>fehlt noch</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>zu tief</translation>
    </message>
    <message>
        <source>To mark the place of a comment, click the tooth or use the arrow keys. Delete removes the mark.</source>
        <translation>Um die Stelle eines Kommentars zu markieren, klicken Sie auf den Zahn oder nehmen Sie die Pfeiltasten. Entf entfernt die Marke.</translation>
    </message>
</context>
<context>
    <name>ui::practice::HoldGauge</name>
    <message>
        <source>Force in relation to the range from %1 to %2 N</source>
        <translation>Kraft im Verhältnis zum Bereich von %1 bis %2 N</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::IdealForm</name>
    <message>
        <source>What the ideal is</source>
        <translation>Was das Ideal ist</translation>
    </message>
    <message>
        <source>Take recordings as the reference …</source>
        <translation>Aufzeichnungen als Referenz nehmen …</translation>
    </message>
    <message>
        <source>Choose one attempt, or several whose mean is to be cut</source>
        <translation>Wählen Sie einen Versuch oder mehrere, deren Mittel zu präparieren ist</translation>
    </message>
    <message>
        <source>The ideal is the decay itself: nothing is to be set</source>
        <translation>Das Ideal ist die Karies selbst: Es gibt nichts einzustellen</translation>
    </message>
    <message>
        <source>An exercise: nothing is to be cut</source>
        <translation>Eine Übung: Es gibt nichts zu präparieren</translation>
    </message>
    <message>
        <source>Ideal preparation</source>
        <translation>Ideale Präparation</translation>
    </message>
    <message>
        <source>By rule</source>
        <extracomment>%1: the name of a file</extracomment>
        <translation>Nach Regel</translation>
    </message>
    <message>
        <source>Captured: %1</source>
        <translation>Abgenommen: %1</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <extracomment>%1 and %2: the least and the greatest number that can be set; %3: a unit</extracomment>
        <translation>%1 bis %2 %3</translation>
    </message>
</context>
<context>
    <name>ui::practice::InfractionCard</name>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Restore the tooth as it was before this; you can redo it (Enter)</source>
        <translation>Den Zahn auf den Stand davor zurücksetzen; das lässt sich wiederholen (Eingabe)</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Keep the tooth as it is and continue (Esc)</source>
        <translation>Den Zahn so lassen und weiterarbeiten (Esc)</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::LessonEditor</name>
    <message>
        <source>Lesson editor</source>
        <translation>Lektionseditor</translation>
    </message>
    <message>
        <source>Title of the lesson</source>
        <translation>Titel der Lektion</translation>
    </message>
    <message>
        <source>Take recordings as the reference …</source>
        <translation>Aufzeichnungen als Referenz nehmen …</translation>
    </message>
    <message>
        <source>On the tooth</source>
        <translation>Am Zahn</translation>
    </message>
    <message>
        <source>What the tolerances mean on the tooth</source>
        <translation>Was die Toleranzen am Zahn bedeuten</translation>
    </message>
    <message>
        <source>Past attempts</source>
        <translation>Frühere Versuche</translation>
    </message>
    <message>
        <source>How attempts would score under other tolerances</source>
        <translation>Wie Versuche bei anderen Toleranzen bewertet würden</translation>
    </message>
    <message>
        <source>The lesson&apos;s file</source>
        <translation>Die Datei der Lektion</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>The lesson as its file says it</source>
        <translation>Die Lektion, wie sie in ihrer Datei steht</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save the lesson</source>
        <translation>Lektion speichern</translation>
    </message>
    <message>
        <source>Write the lesson into your folder (Ctrl+S)</source>
        <translation>Die Lektion in Ihren Ordner schreiben (Strg+S)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Widen the tolerances until the ideal itself loses nothing</source>
        <translation>Die Toleranzen weiten, bis das Ideal selbst nichts verliert</translation>
    </message>
    <message>
        <source>Fit the tolerances to the ideal</source>
        <translation>Toleranzen an das Ideal anpassen</translation>
    </message>
    <message>
        <source>Lesson editor: %1</source>
        <translation>Lektionseditor: %1</translation>
    </message>
    <message>
        <source>A shipped lesson: saved, it becomes one of your own, based on it.</source>
        <translation>Eine mitgelieferte Lektion: Gespeichert wird daraus Ihre eigene, die auf ihr aufbaut.</translation>
    </message>
    <message>
        <source>This lesson of yours is changed where it stands.</source>
        <translation>Diese eigene Lektion wird an ihrem Ort geändert.</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>Noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>This rubric has no criterion that can be drawn on the tooth.</source>
        <translation>Diese Bewertung hat kein Kriterium, das sich am Zahn zeichnen lässt.</translation>
    </message>
    <message>
        <source>Costs nothing: %1.</source>
        <translation>Kostet nichts: %1.</translation>
    </message>
    <message>
        <source>The ideal is checked as soon as nothing is wrong.</source>
        <translation>Das Ideal wird geprüft, sobald nichts mehr falsch ist.</translation>
    </message>
    <message>
        <source>The ideal scores %1 on itself</source>
        <translation>Das Ideal erreicht an sich selbst %1</translation>
    </message>
    <message>
        <source>The ideal scores only %1 on itself; it loses at: %2</source>
        <translation>Das Ideal erreicht an sich selbst nur %1; es verliert bei: %2</translation>
    </message>
    <message>
        <source>Recordings (%1)</source>
        <translation>Aufzeichnungen (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Replaying %n recording(s) …</source>
        <translation>
            <numerusform>%n Aufzeichnung wird abgespielt …</numerusform>
            <numerusform>%n Aufzeichnungen werden abgespielt …</numerusform>
        </translation>
    </message>
    <message>
        <source>No reference was made: %1</source>
        <translation>Keine Referenz: %1</translation>
    </message>
    <message>
        <source>The reference is %1 beside your lessons.</source>
        <translation>Die Referenz ist %1 neben Ihren Lektionen.</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Not saved: whoever cuts exactly this ideal would lose points. Widen the tolerances that are named, or press Fit.</source>
        <translation>Nicht gespeichert: Wer genau dieses Ideal präpariert, verlöre Punkte. Weiten Sie die genannten Toleranzen oder drücken Sie „Anpassen“.</translation>
    </message>
    <message>
        <source>Not saved: there is a file %1 already. Open that lesson instead.</source>
        <translation>Nicht gespeichert: Es gibt schon eine Datei %1. Öffnen Sie stattdessen diese Lektion.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>An exercise has no ideal that could be checked.</source>
        <translation>Eine Übung hat kein Ideal, das zu prüfen wäre.</translation>
    </message>
    <message>
        <source>Wrong: %1</source>
        <extracomment>%1: where in the lesson, and what is wrong there</extracomment>
        <translation>Falsch: %1</translation>
    </message>
    <message>
        <source>Not measured or not earned on this ideal, so no tolerance helps: %1. Mark by another rubric.</source>
        <translation>An diesem Ideal nicht gemessen oder nicht verdient, da hilft keine Toleranz: %1. Bewerten Sie nach einem anderen Schema.</translation>
    </message>
    <message>
        <source>The lesson needs a title.</source>
        <translation>Die Lektion braucht einen Titel.</translation>
    </message>
    <message>
        <source>Not saved: %1 has been changed since you opened it, in another window or at another computer. Open it anew to see that; a step back then brings your own changes back, to be saved in its place.</source>
        <translation>Nicht gespeichert: %1 wurde geändert, seit Sie es geöffnet haben, in einem anderen Fenster oder an einem anderen Computer. Öffnen Sie es neu, um das zu sehen; ein Schritt zurück holt dann Ihre eigenen Änderungen wieder, die sich an seiner Stelle speichern lassen.</translation>
    </message>
    <message>
        <source>Open anew</source>
        <translation>Neu öffnen</translation>
    </message>
    <message>
        <source>Show what stands in the file now; a step back brings your own changes back</source>
        <translation>Zeigen, was jetzt in der Datei steht; ein Schritt zurück holt die eigenen Änderungen wieder</translation>
    </message>
    <message>
        <source>%1 is no lesson as it stands now, and was not opened. Look at it with whoever has changed it.</source>
        <translation>%1 ist so, wie es jetzt dasteht, keine Lektion und wurde nicht geöffnet. Sehen Sie es mit dem an, der es geändert hat.</translation>
    </message>
    <message>
        <source>This is what stands in the file now. A step back brings your own changes back.</source>
        <translation>Das steht jetzt in der Datei. Ein Schritt zurück holt Ihre eigenen Änderungen wieder.</translation>
    </message>
    <message numerus="yes">
        <source>What you have changed in %n lesson(s) would be lost.</source>
        <translation>
            <numerusform>Was Sie in %n Lektion geändert haben, ginge verloren.</numerusform>
            <numerusform>Was Sie in %n Lektionen geändert haben, ginge verloren.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::catalog::LessonPicture</name>
    <message>
        <source>What the lesson asks for, as a picture</source>
        <translation>Was die Lektion verlangt, als Bild</translation>
    </message>
    <message>
        <source>This tooth cannot be created.</source>
        <translation>Dieser Zahn lässt sich nicht erzeugen.</translation>
    </message>
    <message>
        <source>Creating the tooth …</source>
        <translation>Der Zahn wird erzeugt …</translation>
    </message>
</context>
<context>
    <name>ui::practice::LessonStrip</name>
    <message>
        <source>Previous step</source>
        <translation>Vorheriger Schritt</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Tipp</translation>
    </message>
    <message>
        <source>Show a hint for this step</source>
        <translation>Einen Tipp zu diesem Schritt zeigen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>A step of the work, and how many there are</extracomment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Working time</source>
        <translation>Arbeitszeit</translation>
    </message>
    <message>
        <source>Remaining time of %1</source>
        <translation>Restzeit von %1</translation>
    </message>
    <message>
        <source>The exam is over and cutting is disabled. Press G for the score or R for another attempt.</source>
        <translation>Die Prüfung ist zu Ende, Schneiden ist nicht mehr möglich. Drücken Sie G für die Note oder R für einen weiteren Versuch.</translation>
    </message>
    <message>
        <source>The exam is over and cutting is disabled. Press G for the score.</source>
        <translation>Die Prüfung ist zu Ende, Schneiden ist nicht mehr möglich. Drücken Sie G für die Note.</translation>
    </message>
    <message>
        <source>Remove the brown decay. Stop when the floor is firm dentin.</source>
        <translation>Entfernen Sie die braune Karies. Hören Sie auf, wenn der Boden festes Dentin ist.</translation>
    </message>
    <message>
        <source>The decay is out. Press G for the score.</source>
        <translation>Die Karies ist entfernt. Drücken Sie G für die Note.</translation>
    </message>
</context>
<context>
    <name>ui::catalog::LessonsPage</name>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Search: a word, or the number of a tooth</source>
        <translation>Suche: ein Wort oder die Nummer eines Zahns</translation>
    </message>
    <message>
        <source>Search the lessons</source>
        <translation>Lektionen durchsuchen</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Suche leeren</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Start this lesson</source>
        <translation>Diese Lektion beginnen</translation>
    </message>
    <message>
        <source>Load the tooth of this lesson (Enter)</source>
        <translation>Den Zahn dieser Lektion laden (Eingabe)</translation>
    </message>
    <message>
        <source>Your own lessons …</source>
        <translation>Eigene Lektionen …</translation>
    </message>
    <message>
        <source>Open the folder for lessons that teachers add</source>
        <translation>Den Ordner öffnen, in den Lehrkräfte eigene Lektionen legen</translation>
    </message>
    <message>
        <source>Open the folder of your own lessons</source>
        <translation>Den Ordner der eigenen Lektionen öffnen</translation>
    </message>
    <message>
        <source>exam</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Invalid file</source>
        <translation>Ungültige Datei</translation>
    </message>
    <message>
        <source>This file is not a valid lesson. The other lessons work.</source>
        <translation>Diese Datei ist keine gültige Lektion. Die anderen Lektionen funktionieren.</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Practice: mistakes are reported at once</source>
        <translation>Übung: Fehler werden sofort gemeldet</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Burs</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>Aids</source>
        <translation>Hilfen</translation>
    </message>
    <message>
        <source>Rubric</source>
        <extracomment>%1 is the name of a rubric, %2 the mark that is needed</extracomment>
        <translation>Bewertet nach</translation>
    </message>
    <message>
        <source>%1, passed from %2</source>
        <translation>%1, bestanden ab %2</translation>
    </message>
    <message>
        <source>Not modelled</source>
        <translation>Nicht modelliert</translation>
    </message>
    <message>
        <source>Your best</source>
        <translation>Ihr Bestes</translation>
    </message>
    <message numerus="yes">
        <source>%1 in %n attempt(s)</source>
        <translation>
            <numerusform>%1 in %n Versuch</numerusform>
            <numerusform>%1 in %n Versuchen</numerusform>
        </translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>changed, not saved</source>
        <extracomment>Of a lesson in a list: in the editor</extracomment>
        <translation>geändert, nicht gespeichert</translation>
    </message>
    <message>
        <source>best %1, passed</source>
        <extracomment>For a screen reader: the best score of a lesson</extracomment>
        <translation>Bestes %1, bestanden</translation>
    </message>
    <message>
        <source>best %1, not passed</source>
        <translation>Bestes %1, nicht bestanden</translation>
    </message>
    <message>
        <source>Exam: mistakes are recorded and reported at the end; undo is disabled</source>
        <translation>Prüfung: Fehler werden aufgezeichnet und am Ende gemeldet; Rückgängig ist gesperrt</translation>
    </message>
    <message>
        <source>Tooth …</source>
        <translation>Zahn …</translation>
    </message>
    <message>
        <source>Lessons on one tooth</source>
        <translation>Lektionen an einem Zahn</translation>
    </message>
    <message>
        <source>Choose a tooth in the arch to see its lessons</source>
        <translation>Einen Zahn im Bogen wählen, um die Lektionen daran zu sehen</translation>
    </message>
    <message>
        <source>All</source>
        <extracomment>All lessons</extracomment>
        <translation>Alle</translation>
    </message>
    <message>
        <source>To do</source>
        <extracomment>Lessons that are still to be done</extracomment>
        <translation>Zu tun</translation>
    </message>
    <message>
        <source>Passed</source>
        <extracomment>Lessons that were passed</extracomment>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Exams</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Discard the unfinished attempt</source>
        <translation>Den unvollendeten Versuch verwerfen</translation>
    </message>
    <message>
        <source>Continue %1, started %2</source>
        <extracomment>%1: a lesson or a tooth; %2: a time of today, or a day and a time</extracomment>
        <translation>Weitermachen: %1, begonnen %2</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weitermachen</translation>
    </message>
    <message>
        <source>Last attempt: %1, best so far %2</source>
        <extracomment>%1: a lesson; %2: points</extracomment>
        <translation>Letzter Versuch: %1, bisher bestes Ergebnis %2</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Assigned to you, but not on this computer: %1. Ask your teacher for the file.</source>
        <translation>Ihnen aufgegeben, aber nicht auf diesem Computer: %1. Bitten Sie Ihre Lehrkraft um die Datei.</translation>
    </message>
    <message>
        <source>Assigned to you</source>
        <translation>Ihnen aufgegeben</translation>
    </message>
    <message>
        <source>No matching lessons</source>
        <translation>Keine passende Lektion</translation>
    </message>
    <message>
        <source>Search for another word, or show all lessons.</source>
        <translation>Suchen Sie ein anderes Wort, oder lassen Sie alle Lektionen zeigen.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) left</source>
        <translation>
            <numerusform>noch %n Versuch</numerusform>
            <numerusform>noch %n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>Assigned to</source>
        <translation>Aufgegeben für</translation>
    </message>
    <message>
        <source>There are no such lessons now. Show all lessons.</source>
        <translation>Solche Lektionen gibt es jetzt nicht. Zeigen Sie alle Lektionen an.</translation>
    </message>
    <message>
        <source>Loading the lessons …</source>
        <translation>Die Lektionen werden geladen …</translation>
    </message>
    <message>
        <source>no score yet</source>
        <translation>noch keine Punktzahl</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>%1 graded so far</source>
        <extracomment>Of attempts at a lesson; follows &quot;2 attempts left, &quot;</extracomment>
        <translation>%1 bisher bewertet</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::RubricForm</name>
    <message>
        <source>Marking</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>Passed from</source>
        <translation>Bestanden ab</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Tolerance of: %1</source>
        <extracomment>%1: a criterion</extracomment>
        <translation>Toleranz von: %1</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>entscheidet</translation>
    </message>
    <message>
        <source>Weight of: %1</source>
        <translation>Gewicht von: %1</translation>
    </message>
    <message>
        <source>All weights: %1 points</source>
        <translation>Alle Gewichte: %1 Punkte</translation>
    </message>
    <message>
        <source>All weights: %1 points; they must make 100</source>
        <translation>Alle Gewichte: %1 Punkte; es müssen 100 sein</translation>
    </message>
    <message>
        <source>Targets and spans</source>
        <translation>Ziele und Spannen</translation>
    </message>
    <message>
        <source>What each measure ought to be, and how far beyond the tolerance all points are lost</source>
        <translation>Was jedes Maß sein soll, und wie weit jenseits der Toleranz alle Punkte verloren sind</translation>
    </message>
    <message>
        <source>Target</source>
        <extracomment>What a measure ought to be</extracomment>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Target of: %1</source>
        <translation>Ziel von: %1</translation>
    </message>
    <message>
        <source>all lost over</source>
        <extracomment>How far beyond the tolerance all points of a criterion are lost</extracomment>
        <translation>alles verloren über</translation>
    </message>
    <message>
        <source>Span of: %1</source>
        <translation>Spanne von: %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <extracomment>%1: the points that an error leaves at most</extracomment>
        <translation>höchstens %1</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ScoreHistory</name>
    <message numerus="yes">
        <source>Of the best results of %n people in your class, %1 % are below this.</source>
        <extracomment>%1 is a number of per cent</extracomment>
        <translation>
            <numerusform>Von %n Person Ihrer Klasse liegen %1 % der besten Ergebnisse darunter.</numerusform>
            <numerusform>Von den besten Ergebnissen von %n Personen Ihrer Klasse liegen %1 % darunter.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No comparison with a class: to keep results anonymous it needs %1 people, and there are results of %n person(s).</source>
        <extracomment>%1 is a number of people</extracomment>
        <translation>
            <numerusform>Kein Vergleich mit einer Klasse: Damit die Ergebnisse anonym bleiben, sind %1 Personen nötig; hier sind die Ergebnisse von %n Person.</numerusform>
            <numerusform>Kein Vergleich mit einer Klasse: Damit die Ergebnisse anonym bleiben, sind %1 Personen nötig; hier sind die Ergebnisse von %n Personen.</numerusform>
        </translation>
    </message>
    <message>
        <source>other rubric</source>
        <extracomment>Beside an earlier grade that cannot be compared with this one</extracomment>
        <translation>andere Regel</translation>
    </message>
    <message>
        <source>No earlier grades.</source>
        <translation>Keine früheren Bewertungen.</translation>
    </message>
    <message>
        <source>Log in and save</source>
        <translation>Anmelden und speichern</translation>
    </message>
    <message>
        <source>No comparison with a class: to keep results anonymous it needs %1 people, and yours is the only result.</source>
        <extracomment>%1 is a number of people</extracomment>
        <translation>Kein Vergleich mit einer Klasse: Damit die Ergebnisse anonym bleiben, sind %1 Personen nötig, und hier ist nur Ihr Ergebnis.</translation>
    </message>
    <message>
        <source>You are not logged in, so this grade is not saved.</source>
        <translation>Sie sind nicht angemeldet, darum wird diese Bewertung nicht gespeichert.</translation>
    </message>
    <message>
        <source>This grade is saved on this computer. It is sent to the school&apos;s database when the connection is back.</source>
        <translation>Diese Bewertung ist auf diesem Computer gespeichert. Sie wird an die Datenbank der Schule gesendet, sobald die Verbindung wieder besteht.</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>This grade is not saved yet. Cusp tries again every few seconds while it runs. Free some disk space.</source>
        <translation>Diese Bewertung ist noch nicht gespeichert. Solange Cusp läuft, versucht es das alle paar Sekunden wieder. Geben Sie Speicherplatz frei.</translation>
    </message>
    <message>
        <source>This grade is not saved and will not be here next time.</source>
        <translation>Diese Bewertung wird nicht gespeichert und ist beim nächsten Mal nicht mehr da.</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ScorePage</name>
    <message>
        <source>Does not count</source>
        <translation>Zählt nicht</translation>
    </message>
    <message>
        <source>You expected %1 points, which is exactly right.</source>
        <translation>Sie haben %1 Punkte erwartet, das ist genau richtig.</translation>
    </message>
    <message>
        <source>You expected %1 points. You overestimated by %2 points.</source>
        <translation>Sie haben %1 Punkte erwartet und sich um %2 Punkte überschätzt.</translation>
    </message>
    <message>
        <source>You expected %1 points. You underestimated by %2 points.</source>
        <translation>Sie haben %1 Punkte erwartet und sich um %2 Punkte unterschätzt.</translation>
    </message>
    <message>
        <source>Rubric &quot;%1&quot;, version %2, content %3. Undercuts and walls past 90° are not measured, because the model is a height field.</source>
        <extracomment>%1 is the name of a rubric, %2 its version, %3 the beginning of its hash</extracomment>
        <translation>Bewertungsschema „%1“, Version %2, Inhalt %3. Unterschnitte und Wände über 90° werden nicht gemessen, denn das Modell ist ein Höhenfeld.</translation>
    </message>
    <message>
        <source>Grade</source>
        <translation>Bewerten</translation>
    </message>
    <message>
        <source>The tooth is measured again with half and with double the number of grid columns. The result is clear of the pass mark if all scores lie on the same side of it. This says nothing about another attempt.</source>
        <translation>Der Zahn wird noch einmal mit halb und mit doppelt so vielen Rasterspalten gemessen. Das Ergebnis ist klar, wenn alle Punktzahlen auf derselben Seite der Bestehensgrenze liegen. Über einen weiteren Versuch sagt das nichts.</translation>
    </message>
    <message>
        <source>Lost points</source>
        <translation>Verlorene Punkte</translation>
    </message>
    <message>
        <source>Finding the moment of each lost point …</source>
        <translation>Der Zeitpunkt jedes verlorenen Punkts wird gesucht …</translation>
    </message>
    <message>
        <source>Finding the moment of each lost point</source>
        <translation>Der Zeitpunkt jedes verlorenen Punkts wird gesucht</translation>
    </message>
    <message>
        <source>Grade: %1</source>
        <extracomment>%1 is a lesson, &quot;Tooth 36&quot; or a file name %1 is a person, %2 a lesson</extracomment>
        <translation>Bewertung: %1</translation>
    </message>
    <message>
        <source>of 100</source>
        <translation>von 100</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Not passed: critical error</source>
        <translation>Nicht bestanden: kritischer Fehler</translation>
    </message>
    <message>
        <source>Not passed yet</source>
        <translation>Noch nicht bestanden</translation>
    </message>
    <message>
        <source>Score at half the grid: %1, at double the grid: %2.</source>
        <translation>Punkte bei halbem Raster: %1, bei doppeltem Raster: %2.</translation>
    </message>
    <message>
        <source>Score at half the grid: %1.</source>
        <translation>Punkte bei halbem Raster: %1.</translation>
    </message>
    <message>
        <source>Result is close to the pass mark.</source>
        <translation>Das Ergebnis liegt nahe an der Bestehensgrenze.</translation>
    </message>
    <message>
        <source>Result is clear of the pass mark.</source>
        <translation>Das Ergebnis liegt klar neben der Bestehensgrenze.</translation>
    </message>
    <message>
        <source>%1: no points lost</source>
        <extracomment>%1 a criterion of a score</extracomment>
        <translation>%1: keine Punkte verloren</translation>
    </message>
    <message>
        <source>No deviation from the ideal</source>
        <translation>Keine Abweichung vom Ideal</translation>
    </message>
    <message>
        <source>%1 mm too deep</source>
        <translation>%1 mm zu tief</translation>
    </message>
    <message>
        <source>%1 mm still to cut</source>
        <translation>%1 mm fehlen noch</translation>
    </message>
    <message>
        <source>%1: worst place, %2</source>
        <translation>%1: schlimmste Stelle, %2</translation>
    </message>
    <message>
        <source>%1 has no place on the tooth; largest deviation: %2</source>
        <translation>%1 hat keinen Ort am Zahn; größte Abweichung: %2</translation>
    </message>
    <message>
        <source>You lost no points.</source>
        <translation>Sie haben keine Punkte verloren.</translation>
    </message>
    <message>
        <source>Your biggest loss: %1.</source>
        <translation>Ihr größter Punktverlust: %1.</translation>
    </message>
    <message>
        <source>You named your biggest loss correctly: %1.</source>
        <translation>Sie haben Ihren größten Punktverlust richtig genannt: %1.</translation>
    </message>
    <message>
        <source>You expected &quot;%1&quot; to be your biggest loss; it was &quot;%2&quot;.</source>
        <translation>Sie hielten „%1“ für Ihren größten Punktverlust; es war „%2“.</translation>
    </message>
    <message>
        <source>%1: %2, no answer</source>
        <extracomment>%1 is &quot;Left&quot;, &quot;Middle&quot; or &quot;Right&quot;, %2 and %3 are tissues</extracomment>
        <translation>%1: %2, keine Antwort</translation>
    </message>
    <message>
        <source>%1: %2, correct</source>
        <translation>%1: %2, richtig</translation>
    </message>
    <message>
        <source>%1: %2, your answer: %3</source>
        <translation>%1: %2, Ihre Antwort: %3</translation>
    </message>
    <message>
        <source>%1 has no place on the tooth</source>
        <translation>%1 hat keinen Ort am Zahn</translation>
    </message>
    <message>
        <source>%1: worst place</source>
        <extracomment>%1 a criterion of a score</extracomment>
        <translation>%1: schlimmste Stelle</translation>
    </message>
    <message>
        <source>Held for %1 of %2 s, mean deviation %3 N</source>
        <translation>%1 von %2 s gehalten, mittlere Abweichung %3 N</translation>
    </message>
    <message>
        <source>All points were touched</source>
        <translation>Alle Punkte wurden berührt</translation>
    </message>
    <message>
        <source>%1 of %2 points touched; the ring marks a missed point</source>
        <translation>%1 von %2 Punkten berührt; der Ring markiert einen ausgelassenen</translation>
    </message>
    <message>
        <source>Drilled with the hardness preset %1.</source>
        <extracomment>%1 is a hardness preset with its version</extracomment>
        <translation>Gebohrt mit der Härte-Voreinstellung %1.</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Replay this attempt</source>
        <translation>Diesen Versuch abspielen</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Save or print the score card</source>
        <translation>Bewertungsblatt speichern oder drucken</translation>
    </message>
    <message>
        <source>Save as PDF …</source>
        <translation>Als PDF speichern …</translation>
    </message>
    <message>
        <source>Print …</source>
        <translation>Drucken …</translation>
    </message>
    <message>
        <source>Grade of %1: %2</source>
        <translation>Bewertung von %1: %2</translation>
    </message>
    <message>
        <source>The student expected %1 points.</source>
        <translation>Vom Studierenden erwartet: %1 Punkte.</translation>
    </message>
    <message>
        <source>Passed (teacher&apos;s decision)</source>
        <translation>Bestanden (Entscheidung der Lehrkraft)</translation>
    </message>
    <message>
        <source>Not passed (teacher&apos;s decision)</source>
        <translation>Nicht bestanden (Entscheidung der Lehrkraft)</translation>
    </message>
    <message>
        <source>Automatic score: %1</source>
        <extracomment>%1: a sum of points</extracomment>
        <translation>Automatische Bewertung: %1</translation>
    </message>
    <message>
        <source>This attempt has no readable recording. It cannot be replayed, and the tooth is not shown. The score and the lost points are shown as they were saved.</source>
        <translation>Von diesem Versuch gibt es keine lesbare Aufzeichnung. Er kann nicht abgespielt werden, und der Zahn wird nicht gezeigt. Punktzahl und Punktverluste werden so gezeigt, wie sie gespeichert wurden.</translation>
    </message>
    <message>
        <source>Next time</source>
        <translation>Beim nächsten Mal</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>How the points add up, and by which rules</source>
        <translation>Wie sich die Punkte zusammensetzen und nach welchen Regeln</translation>
    </message>
    <message>
        <source>Show it at %1</source>
        <extracomment>%1: minutes and seconds of the attempt</extracomment>
        <translation>Bei %1 zeigen</translation>
    </message>
    <message>
        <source>Next lesson</source>
        <translation>Nächste Lektion</translation>
    </message>
    <message>
        <source>Show the moment in the replay</source>
        <translation>Den Moment in der Wiedergabe zeigen</translation>
    </message>
    <message>
        <source>Not passed: limited to %1</source>
        <extracomment>%1: points of a score</extracomment>
        <translation>Nicht bestanden: höchstens %1</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::SweepChart</name>
    <message>
        <source>Scores of past attempts over the tolerance</source>
        <translation>Noten früherer Versuche über der Toleranz</translation>
    </message>
    <message>
        <source>At %1 times the tolerance %2 of %3 pass; median %4</source>
        <extracomment>%1: a number, &quot;1.5&quot;; %2 of %3 attempts; %4: points</extracomment>
        <translation>Beim %1-Fachen der Toleranz bestehen %2 von %3; Median %4</translation>
    </message>
    <message>
        <source>Times the tolerance</source>
        <translation>Vielfaches der Toleranz</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Each attempt</source>
        <translation>Jeder Versuch</translation>
    </message>
    <message>
        <source>%1: %2 points at %3 times the tolerance</source>
        <extracomment>%1: the name of a file, or which line</extracomment>
        <translation>%1: %2 Punkte beim %3-Fachen der Toleranz</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>As set</source>
        <translation>Wie eingestellt</translation>
    </message>
    <message>
        <source>Lower quartile</source>
        <translation>Unteres Quartil</translation>
    </message>
    <message>
        <source>Upper quartile</source>
        <translation>Oberes Quartil</translation>
    </message>
    <message>
        <source>Attempts that pass, %</source>
        <translation>Bestandene Versuche, %</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::SweepPage</name>
    <message>
        <source>Recordings …</source>
        <translation>Aufzeichnungen …</translation>
    </message>
    <message>
        <source>Choose the folder with recordings of attempts</source>
        <translation>Den Ordner mit Aufzeichnungen von Versuchen wählen</translation>
    </message>
    <message>
        <source>Choose the folder with recordings</source>
        <translation>Ordner mit Aufzeichnungen wählen</translation>
    </message>
    <message>
        <source>Whose tolerance is changed</source>
        <translation>Wessen Toleranz geändert wird</translation>
    </message>
    <message>
        <source>Recordings that are replayed</source>
        <translation>Aufzeichnungen, die abgespielt werden</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop replaying</source>
        <translation>Abspielen anhalten</translation>
    </message>
    <message>
        <source>Go on with those that are done</source>
        <translation>Mit denen weiterarbeiten, die fertig sind</translation>
    </message>
    <message>
        <source>Choose a folder with recordings of this tooth: each is replayed once, and its score is drawn for tolerances from 0 to 3 times those at the left.</source>
        <translation>Wählen Sie einen Ordner mit Aufzeichnungen dieses Zahns: Jede wird einmal abgespielt, und ihre Note wird für das 0- bis 3-Fache der Toleranzen links gezeichnet.</translation>
    </message>
    <message>
        <source>All tolerances</source>
        <translation>Alle Toleranzen</translation>
    </message>
    <message>
        <source>No attempt in this folder was made at this tooth.</source>
        <translation>Kein Versuch in diesem Ordner wurde an diesem Zahn gemacht.</translation>
    </message>
    <message>
        <source>The attempts of the history were made for another ideal than this draft&apos;s. Choose a folder with recordings.</source>
        <translation>Die Versuche des Verlaufs galten einem anderen Ideal als dem dieses Entwurfs. Wählen Sie einen Ordner mit Aufzeichnungen.</translation>
    </message>
    <message numerus="yes">
        <source>%n of them from the history.</source>
        <translation>
            <numerusform>%n davon aus dem Verlauf.</numerusform>
            <numerusform>%n davon aus dem Verlauf.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) at other teeth are left out.</source>
        <translation>
            <numerusform>%n Versuch an einem anderen Zahn bleibt weg.</numerusform>
            <numerusform>%n Versuche an anderen Zähnen bleiben weg.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) could not be read.</source>
        <translation>
            <numerusform>%n Aufzeichnung war nicht lesbar.</numerusform>
            <numerusform>%n Aufzeichnungen waren nicht lesbar.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) of the history without measured values are left out.</source>
        <translation>
            <numerusform>%n Versuch aus dem Verlauf ohne Messwerte bleibt weg.</numerusform>
            <numerusform>%n Versuche aus dem Verlauf ohne Messwerte bleiben weg.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::ToleranceView</name>
    <message>
        <source>The tolerances on the tooth</source>
        <translation>Die Toleranzen am Zahn</translation>
    </message>
    <message>
        <source>Drag the line of the section; arrow keys move it, Shift with them turns it, as a double click does</source>
        <translation>Ziehen Sie die Linie des Schnitts; Pfeiltasten verschieben sie, mit Umschalt drehen sie, ebenso ein Doppelklick</translation>
    </message>
    <message>
        <source>Nothing to show yet: what is wrong is said at the left.</source>
        <translation>Noch nichts zu zeigen: Was falsch ist, steht links.</translation>
    </message>
    <message>
        <source>The ideal is being made …</source>
        <translation>Das Ideal wird angelegt …</translation>
    </message>
</context>
<context>
    <name>ui::kit::FormInputs</name>
    <message>
        <source>%1 stays.</source>
        <translation>%1 bleibt.</translation>
    </message>
    <message>
        <source>Only whole numbers from %1 to %2 can be entered here.</source>
        <extracomment>%1 and %2: the least and the greatest number, %2 with a unit</extracomment>
        <translation>Hier sind nur ganze Zahlen von %1 bis %2 möglich.</translation>
    </message>
    <message>
        <source>Only %1 to %2 can be entered here.</source>
        <translation>Hier ist nur %1 bis %2 möglich.</translation>
    </message>
</context>
<context>
    <name>ui::scoring::WorstSection</name>
    <message>
        <source>Section through the worst place</source>
        <translation>Schnitt durch die schlimmste Stelle</translation>
    </message>
</context>
<context>
    <name>ui::tooth::SceneWidget</name>
    <message>
        <source>No picture</source>
        <extracomment>Heading where a picture would be; a sentence below says why</extracomment>
        <translation>Kein Bild</translation>
    </message>
</context>
<context>
    <name>ui::tooth::ToothView</name>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>Arrow keys move the bur, page down pushes, page up lifts.</source>
        <translation>Pfeiltasten führen den Bohrer, Bild ab drückt, Bild auf hebt ab.</translation>
    </message>
    <message>
        <source>%1 N</source>
        <extracomment>A force in newtons, beside the bur</extracomment>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>This computer offers no OpenGL 3.3, so the tooth cannot be shown. Install or update the graphics driver (on Debian: libgl1-mesa-dri), then start Cusp again.</source>
        <translation>Dieser Rechner bietet kein OpenGL 3.3, darum kann der Zahn nicht gezeigt werden. Installieren oder aktualisieren Sie den Grafiktreiber (unter Debian: libgl1-mesa-dri) und starten Sie Cusp neu.</translation>
    </message>
    <message>
        <source>%1 / %2 mm</source>
        <translation>%1 / %2 mm</translation>
    </message>
    <message>
        <source>Stop %1 mm</source>
        <extracomment>The depth at which the bur will stop</extracomment>
        <translation>Anschlag %1 mm</translation>
    </message>
</context>
<context>
    <name>app::PedalController</name>
    <message>
        <source>The pedal was unplugged, and the bur was stopped. Plug it in again, or switch the drill on to work without it.</source>
        <translation>Das Pedal wurde abgezogen, und der Bohrer wurde angehalten. Schließen Sie es wieder an, oder schalten Sie den Antrieb ein, um ohne Pedal zu arbeiten.</translation>
    </message>
    <message>
        <source>Show the device</source>
        <translation>Gerät zeigen</translation>
    </message>
    <message>
        <source>The pedal is plugged in again.</source>
        <translation>Das Pedal ist wieder angeschlossen.</translation>
    </message>
</context>
<context>
    <name>ui::devices::AxisBars</name>
    <message>
        <source>Axes and buttons. No button is pressed.</source>
        <translation>Achsen und Knöpfe. Kein Knopf ist gedrückt.</translation>
    </message>
    <message>
        <source>Axes and buttons. Pressed: %1</source>
        <extracomment>%1: names of buttons</extracomment>
        <translation>Achsen und Knöpfe. Gedrückt: %1</translation>
    </message>
</context>
<context>
    <name>ui::devices::ControllerButtonsCard</name>
    <message>
        <source>Sticks, triggers and arrows</source>
        <extracomment>What sticks, triggers and arrows of a gamepad do</extracomment>
        <translation>Sticks, Abzüge und Pfeile</translation>
    </message>
    <message>
        <source>Press the button for: %1. Click again for none.</source>
        <extracomment>%1: &quot;Undo&quot;, or another action</extracomment>
        <translation>Drücken Sie den Knopf für: %1. Noch ein Klick: keiner.</translation>
    </message>
    <message>
        <source>Buttons. Click one here, then press it on the pedal or gamepad.</source>
        <translation>Knöpfe. Klicken Sie hier einen an und drücken Sie ihn dann am Pedal oder Gamepad.</translation>
    </message>
    <message>
        <source>Press it …</source>
        <translation>Drücken …</translation>
    </message>
    <message>
        <source>None</source>
        <extracomment>No button</extracomment>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: an action; %2: a button</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>ui::devices::Controllers</name>
    <message>
        <source>Not part of this program.</source>
        <translation>Nicht Teil dieses Programms.</translation>
    </message>
    <message>
        <source>Pedals and gamepads cannot be read.</source>
        <translation>Pedale und Gamepads können nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The pedal is ready.</source>
        <translation>Das Pedal ist bereit.</translation>
    </message>
    <message>
        <source>The chosen pedal is not plugged in.</source>
        <translation>Das gewählte Pedal ist nicht angeschlossen.</translation>
    </message>
    <message>
        <source>The pedal is pressed, or it sticks. Release it.</source>
        <translation>Das Pedal ist gedrückt, oder es klemmt. Lassen Sie es los.</translation>
    </message>
    <message>
        <source>Nothing is plugged in.</source>
        <translation>Es ist nichts angeschlossen.</translation>
    </message>
    <message>
        <source>This program was built without SDL 2. The mouse and the keyboard work without it.</source>
        <translation>Dieses Programm wurde ohne SDL 2 gebaut. Maus und Tastatur gehen ohne.</translation>
    </message>
    <message>
        <source>The bur turns while the pedal is pressed, and faster the farther it is pressed.</source>
        <translation>Der Bohrer dreht sich, solange das Pedal gedrückt ist, und je weiter, desto schneller.</translation>
    </message>
    <message>
        <source>Plug in &quot;%1&quot;. Until then, the bur runs without a pedal.</source>
        <extracomment>%1: name of a pedal</extracomment>
        <translation>Schließen Sie „%1“ an. Bis dahin läuft der Bohrer ohne Pedal.</translation>
    </message>
    <message>
        <source>The bur does not start before the pedal has been seen released. If it is released now, teach it again.</source>
        <translation>Der Bohrer startet erst, wenn das Pedal einmal losgelassen war. Ist es jetzt losgelassen, lernen Sie es neu an.</translation>
    </message>
    <message>
        <source>Plug in a foot pedal or a gamepad. A pedal that acts as a keyboard needs nothing here: let it send Page Down.</source>
        <translation>Schließen Sie ein Fußpedal oder ein Gamepad an. Ein Pedal, das wie eine Tastatur arbeitet, braucht hier nichts: lassen Sie es Bild-ab senden.</translation>
    </message>
    <message>
        <source>Run the bur</source>
        <extracomment>What a button does: the bur turns at full speed while it is pressed</extracomment>
        <translation>Bohrer laufen lassen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegel</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Next view</source>
        <extracomment>What a button does: looks at the tooth from another side</extracomment>
        <translation>Nächste Ansicht</translation>
    </message>
    <message>
        <source>Next bur</source>
        <translation>Nächster Bohrer</translation>
    </message>
    <message>
        <source>Finish and grade</source>
        <translation>Beenden und bewerten</translation>
    </message>
    <message>
        <source>Left stick, sideways</source>
        <translation>Linker Stick, seitwärts</translation>
    </message>
    <message>
        <source>Left stick, up and down</source>
        <translation>Linker Stick, auf und ab</translation>
    </message>
    <message>
        <source>Right stick, sideways</source>
        <translation>Rechter Stick, seitwärts</translation>
    </message>
    <message>
        <source>Right stick, up and down</source>
        <translation>Rechter Stick, auf und ab</translation>
    </message>
    <message>
        <source>Left trigger</source>
        <translation>Linker Abzug</translation>
    </message>
    <message>
        <source>Right trigger</source>
        <translation>Rechter Abzug</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <extracomment>Of a pedal; %1: a number</extracomment>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>View</source>
        <extracomment>A button of a gamepad</extracomment>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Guide</source>
        <extracomment>A button of a gamepad</extracomment>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Menu</source>
        <extracomment>A button of a gamepad</extracomment>
        <translation>Menü</translation>
    </message>
    <message>
        <source>Left stick</source>
        <extracomment>The button in a stick of a gamepad</extracomment>
        <translation>Linker Stick</translation>
    </message>
    <message>
        <source>Right stick</source>
        <extracomment>The button in a stick of a gamepad</extracomment>
        <translation>Rechter Stick</translation>
    </message>
    <message>
        <source>Moves the bur over the tooth</source>
        <translation>Bewegt den Bohrer über den Zahn</translation>
    </message>
    <message>
        <source>Turns the view</source>
        <translation>Dreht die Ansicht</translation>
    </message>
    <message>
        <source>Presses the bur down: the farther, the harder</source>
        <translation>Drückt den Bohrer an: je weiter, desto fester</translation>
    </message>
    <message>
        <source>Sets the speed of the bur, if it is the pedal</source>
        <translation>Stellt die Drehzahl des Bohrers ein, wenn er das Pedal ist</translation>
    </message>
    <message>
        <source>Arrows</source>
        <extracomment>The cross of four arrows on a gamepad</extracomment>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>Go through the buttons of the panel, or of the page</source>
        <translation>Gehen durch die Knöpfe des Bedienfelds oder der Seite</translation>
    </message>
    <message>
        <source>Presses the button that the arrows have gone to</source>
        <translation>Drückt den Knopf, zu dem die Pfeile gegangen sind</translation>
    </message>
    <message>
        <source>Leads back to the tooth</source>
        <translation>Führt zurück zum Zahn</translation>
    </message>
    <message>
        <source>Plugged in: %1</source>
        <extracomment>%1: names of pedals and gamepads</extracomment>
        <translation>Angeschlossen: %1</translation>
    </message>
    <message>
        <source>Teach a pedal by one press: its travel then sets the speed of the bur. A gamepad works as it comes.</source>
        <translation>Lernen Sie ein Pedal durch einmaliges Drücken an: sein Weg stellt dann die Drehzahl des Bohrers ein. Ein Gamepad geht, wie es ist.</translation>
    </message>
    <message>
        <source>LB</source>
        <extracomment>Left shoulder button of a gamepad, as it is printed on it</extracomment>
        <translation>LB</translation>
    </message>
    <message>
        <source>RB</source>
        <extracomment>Right shoulder button of a gamepad, as it is printed on it</extracomment>
        <translation>RB</translation>
    </message>
</context>
<context>
    <name>ui::devices::PedalCard</name>
    <message>
        <source>Pedal or gamepad</source>
        <translation>Pedal oder Gamepad</translation>
    </message>
    <message>
        <source>The bur turns only while this pedal is pressed</source>
        <translation>Der Bohrer dreht sich nur, solange dieses Pedal gedrückt ist</translation>
    </message>
    <message>
        <source>Another one of the same kind is plugged in too. The one that was plugged in first counts.</source>
        <translation>Ein zweites derselben Art ist auch angeschlossen. Es zählt das zuerst angeschlossene.</translation>
    </message>
    <message>
        <source>Work without this pedal</source>
        <translation>Ohne dieses Pedal arbeiten</translation>
    </message>
</context>
<context>
    <name>ui::devices::PedalSetupCard</name>
    <message>
        <source>Inverted</source>
        <extracomment>Of a pedal: the bur runs while it is released</extracomment>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <extracomment>Of a pedal: the part of its travel in which the bur stands</extracomment>
        <translation>Totbereich</translation>
    </message>
    <message>
        <source>Curve</source>
        <extracomment>Of a pedal: 1 is a straight line</extracomment>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>1 is a straight line. With more, slow speeds have more of the travel.</source>
        <translation>1 ist eine Gerade. Mit mehr haben langsame Drehzahlen mehr vom Weg.</translation>
    </message>
    <message>
        <source>Press the pedal fully and release it.</source>
        <translation>Drücken Sie das Pedal ganz durch und lassen Sie es los.</translation>
    </message>
    <message>
        <source>No pedal has been taught. The speed of the bur follows its travel once it has.</source>
        <translation>Es ist kein Pedal angelernt. Danach folgt die Drehzahl des Bohrers seinem Weg.</translation>
    </message>
    <message>
        <source>The speed of the bur follows: %1.</source>
        <extracomment>%1: &quot;Left trigger&quot; or &quot;Axis 1&quot;</extracomment>
        <translation>Die Drehzahl des Bohrers folgt: %1.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Teach the pedal</source>
        <translation>Pedal anlernen</translation>
    </message>
    <message>
        <source>Speed of the bur over the travel of the pedal</source>
        <translation>Drehzahl des Bohrers über dem Weg des Pedals</translation>
    </message>
</context>
<context>
    <name>ui::devices::SoundCard</name>
    <message>
        <source>Play sound</source>
        <translation>Ton abspielen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <extracomment>Volume of a part of the sound</extracomment>
        <translation>Handstück</translation>
    </message>
    <message>
        <source>Cutting</source>
        <extracomment>Volume of a part of the sound</extracomment>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Contact</source>
        <extracomment>Volume of a part of the sound: the bur meets the tooth</extracomment>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Spray</source>
        <extracomment>Volume of a part of the sound: water that cools the bur</extracomment>
        <translation>Spray</translation>
    </message>
    <message>
        <source>Suction</source>
        <extracomment>Volume of a part of the sound</extracomment>
        <translation>Absaugung</translation>
    </message>
    <message>
        <source>Volume: %1</source>
        <extracomment>Name of a slider; %1: &quot;Handpiece&quot;, &quot;Cutting&quot;</extracomment>
        <translation>Lautstärke: %1</translation>
    </message>
    <message>
        <source>Output</source>
        <extracomment>Of sound: loudspeakers or headphones</extracomment>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>Play a sample</source>
        <translation>Probe abspielen</translation>
    </message>
    <message>
        <source>The turbine runs free, cuts enamel, then dentin</source>
        <translation>Die Turbine läuft frei, schneidet Schmelz, dann Dentin</translation>
    </message>
    <message>
        <source>As the system is set</source>
        <extracomment>Audio output</extracomment>
        <translation>Wie im System eingestellt</translation>
    </message>
    <message>
        <source>The chosen output (missing)</source>
        <extracomment>Audio output that was chosen before and is not plugged in</extracomment>
        <translation>Die gewählte Ausgabe (fehlt)</translation>
    </message>
</context>
<context>
    <name>ui::devices::SoundText</name>
    <message>
        <source>Off.</source>
        <extracomment>Of sound</extracomment>
        <translation>Aus.</translation>
    </message>
    <message>
        <source>Silent: this computer has no audio output.</source>
        <translation>Stumm: Dieser Computer hat keine Tonausgabe.</translation>
    </message>
    <message>
        <source>Silent: %1 does not play.</source>
        <extracomment>%1: an audio output, as the system calls it</extracomment>
        <translation>Stumm: %1 spielt nicht.</translation>
    </message>
    <message>
        <source>The chosen output is missing; %1 plays instead.</source>
        <extracomment>%1: an audio output, as the system calls it</extracomment>
        <translation>Die gewählte Ausgabe fehlt; stattdessen spielt %1.</translation>
    </message>
    <message>
        <source>Plays on %1.</source>
        <extracomment>%1: an audio output, as the system calls it</extracomment>
        <translation>Spielt auf %1.</translation>
    </message>
    <message>
        <source>Plug in headphones or loudspeakers: the sound then starts without a restart. Everything else works without sound.</source>
        <translation>Schließen Sie Kopfhörer oder Lautsprecher an: Der Ton beginnt dann ohne Neustart. Alles andere geht auch ohne Ton.</translation>
    </message>
    <message>
        <source>Choose another output, or close the program that uses this one. Cusp tries again every second.</source>
        <translation>Wählen Sie eine andere Ausgabe, oder schließen Sie das Programm, das diese benutzt. Cusp versucht es jede Sekunde erneut.</translation>
    </message>
    <message>
        <source>Plug the output in again: the sound then returns to it.</source>
        <translation>Schließen Sie die Ausgabe wieder an: Der Ton kehrt dann zu ihr zurück.</translation>
    </message>
    <message>
        <source>The handpiece drops in pitch under load. Enamel sounds bright, dentin dull. The sound plays while you see the tooth.</source>
        <translation>Unter Last wird der Ton des Handstücks tiefer. Schmelz klingt hell, Dentin dumpf. Der Ton spielt, solange Sie den Zahn sehen.</translation>
    </message>
</context>
<context>
    <name>ui::practice::BurPicker</name>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>Inverted cone</source>
        <translation>Umgekehrter Kegel</translation>
    </message>
    <message>
        <source>Straight fissure</source>
        <translation>Zylindrisch</translation>
    </message>
    <message>
        <source>Tapered fissure</source>
        <translation>Konisch</translation>
    </message>
    <message>
        <source>Pear, egg and flame</source>
        <translation>Birne, Ei und Flamme</translation>
    </message>
    <message>
        <source>Diamonds</source>
        <translation>Diamanten</translation>
    </message>
    <message>
        <source>All burs</source>
        <translation>Alle Bohrer</translation>
    </message>
    <message>
        <source>Search by number, ISO size or shape</source>
        <translation>Nach Nummer, ISO-Größe oder Form suchen</translation>
    </message>
    <message>
        <source>There is no such bur.</source>
        <translation>Einen solchen Bohrer gibt es nicht.</translation>
    </message>
    <message>
        <source>Take it out of the panel</source>
        <translation>Aus der Leiste nehmen</translation>
    </message>
    <message>
        <source>The panel holds four burs: take one out first.</source>
        <translation>Die Leiste fasst vier Bohrer: Nehmen Sie erst einen heraus.</translation>
    </message>
    <message>
        <source>Keep it at hand in the panel</source>
        <translation>In der Leiste griffbereit halten</translation>
    </message>
    <message>
        <source>Keep at hand: %1</source>
        <extracomment>%1: a bur such as &quot;Pear, No. 330&quot;</extracomment>
        <translation>Griffbereit halten: %1</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <extracomment>Diameter and length of a bur</extracomment>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>ISO %1</source>
        <extracomment>Size of a bur as in ISO 6360</extracomment>
        <translation>ISO %1</translation>
    </message>
    <message>
        <source>Grit %1</source>
        <extracomment>Of a diamond bur: number of its grit in ISO 6360, such as 524</extracomment>
        <translation>Körnung %1</translation>
    </message>
    <message>
        <source>This lesson does not allow it.</source>
        <translation>Diese Lektion erlaubt das nicht.</translation>
    </message>
</context>
<context>
    <name>ui::devices::PenField</name>
    <message>
        <source>Press the pen here</source>
        <extracomment>In a field in which the user tries the pen of a graphics tablet</extracomment>
        <translation>Hier mit dem Stift drücken</translation>
    </message>
</context>
<context>
    <name>ui::devices::PenCard</name>
    <message>
        <source>Pen</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>The tilt of the pen is ignored: the bur stays upright.</source>
        <translation>Die Neigung des Stifts wird nicht beachtet: Der Bohrer bleibt aufrecht.</translation>
    </message>
    <message>
        <source>Curve</source>
        <extracomment>Of a pen: 1 is a straight line</extracomment>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>1 is a straight line. With more, a light touch presses more weakly.</source>
        <translation>1 ist eine Gerade. Mit mehr drückt eine leichte Berührung schwächer.</translation>
    </message>
    <message>
        <source>Force over the pressure of the pen</source>
        <translation>Kraft über dem Druck des Stifts</translation>
    </message>
    <message>
        <source>No pen has been seen yet. Press it in the field, or move it over the field.</source>
        <translation>Bisher wurde kein Stift erkannt. Drücken Sie ihn in das Feld oder bewegen Sie ihn darüber.</translation>
    </message>
    <message>
        <source>That was a mouse, or a pen whose driver reports no pressure. The bur presses with %1 N.</source>
        <extracomment>%1: newtons</extracomment>
        <translation>Das war eine Maus oder ein Stift, dessen Treiber keinen Druck meldet. Der Bohrer drückt mit %1 N.</translation>
    </message>
    <message>
        <source>The pen hovers: the bur follows it and does not press.</source>
        <translation>Der Stift schwebt: Der Bohrer folgt ihm und drückt nicht.</translation>
    </message>
    <message>
        <source>Pressure %1 %: the bur presses with %2 N of %3 N.</source>
        <extracomment>%1: per cent; %2 and %3: newtons</extracomment>
        <translation>Druck %1 %: Der Bohrer drückt mit %2 N von %3 N.</translation>
    </message>
</context>
<context>
    <name>ui::devices::HandGuidePicture</name>
    <message>
        <source>50 to 70 cm</source>
        <extracomment>Between the eyes and the screen</extracomment>
        <translation>50 bis 70 cm</translation>
    </message>
</context>
<context>
    <name>ui::devices::StillnessTest</name>
    <message>
        <source>Time that is over</source>
        <translation>Abgelaufene Zeit</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Once more</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Get ready.</source>
        <translation>Machen Sie sich bereit.</translation>
    </message>
    <message>
        <source>Hold still.</source>
        <translation>Halten Sie still.</translation>
    </message>
    <message>
        <source>This can be tried when the device is ready.</source>
        <translation>Das geht, sobald das Gerät bereit ist.</translation>
    </message>
    <message>
        <source>The device stopped responding. Start again when it is ready.</source>
        <translation>Das Gerät antwortet nicht mehr. Beginnen Sie noch einmal, wenn es bereit ist.</translation>
    </message>
    <message>
        <source>Too few positions were measured. Close other programs and start again.</source>
        <translation>Es wurden zu wenige Positionen gemessen. Schließen Sie andere Programme und beginnen Sie noch einmal.</translation>
    </message>
    <message>
        <source>On the tooth, the bur drifted by %1 mm and trembled by %2 mm.</source>
        <extracomment>%1 and %2: millimetres</extracomment>
        <translation>Am Zahn wanderte der Bohrer um %1 mm und zitterte um %2 mm.</translation>
    </message>
    <message>
        <source>On the screen, the pointer drifted by %1 mm and trembled by %2 mm.</source>
        <translation>Auf dem Bildschirm wanderte der Zeiger um %1 mm und zitterte um %2 mm.</translation>
    </message>
    <message>
        <source>The hand drifts: support the forearm, and try another height of the rest.</source>
        <translation>Die Hand wandert: Stützen Sie den Unterarm ab und probieren Sie eine andere Höhe der Auflage.</translation>
    </message>
    <message>
        <source>The hand trembles: hold the grip loosely, put a finger on the rest, or choose a larger scale on the next step.</source>
        <translation>Die Hand zittert: Halten Sie den Griff locker, legen Sie einen Finger auf die Auflage oder wählen Sie im nächsten Schritt einen größeren Maßstab.</translation>
    </message>
    <message>
        <source>The hand trembles: put the wrist on the table, or zoom in at the tooth.</source>
        <translation>Die Hand zittert: Legen Sie das Handgelenk auf den Tisch oder vergrößern Sie die Ansicht des Zahns.</translation>
    </message>
    <message>
        <source>That is steady.</source>
        <translation>Das ist ruhig.</translation>
    </message>
</context>
<context>
    <name>ui::devices::HandGuide</name>
    <message>
        <source>Scale</source>
        <extracomment>How far the hand moves for one millimetre of the bur</extracomment>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Movement of the hand for 1 mm of the bur, in millimetres. With more, drift and tremor of the hand move the bur less.</source>
        <translation>Bewegung der Hand für 1 mm des Bohrers, in Millimetern. Mit mehr bewegen Wandern und Zittern der Hand den Bohrer weniger.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <extracomment>%1 and %2: numbers</extracomment>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Use this height</source>
        <extracomment>The height at which the hand is now</extracomment>
        <translation>Diese Höhe verwenden</translation>
    </message>
    <message>
        <source>Use the middle</source>
        <translation>Die Mitte verwenden</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Which hand do you work with?</source>
        <translation>Welche Hand arbeitet?</translation>
    </message>
    <message>
        <source>Place the screen</source>
        <translation>Bildschirm aufstellen</translation>
    </message>
    <message>
        <source>Rest the hand</source>
        <translation>Hand auflegen</translation>
    </message>
    <message>
        <source>Hold still</source>
        <translation>Stillhalten</translation>
    </message>
    <message>
        <source>Your place</source>
        <translation>Ihr Platz</translation>
    </message>
    <message>
        <source>The handpiece comes from the side of this hand, and the light from the other one. Place the mouse, the tablet or the device on this side.</source>
        <translation>Das Handstück kommt von der Seite dieser Hand und das Licht von der anderen. Stellen Sie die Maus, das Tablett oder das Gerät auf diese Seite.</translation>
    </message>
    <message>
        <source>Place it straight in front of you, 50 to 70 cm from your eyes. Its upper edge is at the height of your eyes or a little below. Sit upright and let the shoulders hang.</source>
        <translation>Stellen Sie ihn gerade vor sich, 50 bis 70 cm von den Augen entfernt. Seine Oberkante ist auf Augenhöhe oder etwas darunter. Sitzen Sie aufrecht und lassen Sie die Schultern hängen.</translation>
    </message>
    <message>
        <source>Put a box or a firm cushion in front of the device, so that the ring finger rests while you hold the grip, as it does on a tooth. Hold the grip as if at the tooth. The top of the tooth comes to the height that you store.</source>
        <translation>Stellen Sie eine Schachtel oder ein festes Kissen vor das Gerät, damit der Ringfinger aufliegt, während Sie den Griff halten, wie auf einem Zahn. Halten Sie den Griff wie am Zahn. Die Oberseite des Zahns kommt auf die Höhe, die Sie speichern.</translation>
    </message>
    <message>
        <source>Lay the forearm on the table, with the wrist straight. Hold a pen near its tip, and rest the little finger beside it. Move a mouse with the fingers.</source>
        <translation>Legen Sie den Unterarm mit geradem Handgelenk auf den Tisch. Halten Sie einen Stift nahe der Spitze und legen Sie den kleinen Finger daneben auf. Bewegen Sie eine Maus mit den Fingern.</translation>
    </message>
    <message>
        <source>Hold the grip as if at the tooth, with a finger on the rest. Press Start with the other hand and hold still for 8 seconds.</source>
        <translation>Halten Sie den Griff wie am Zahn, mit einem Finger auf der Auflage. Drücken Sie mit der anderen Hand auf „Start“ und halten Sie 8 Sekunden still.</translation>
    </message>
    <message>
        <source>Press Start with the space bar, or click it and leave the pointer there. Hold still for 8 seconds. A pen hovers meanwhile.</source>
        <translation>Drücken Sie „Start“ mit der Leertaste, oder klicken Sie darauf und lassen Sie den Zeiger dort. Halten Sie 8 Sekunden still. Ein Stift schwebt dabei.</translation>
    </message>
    <message>
        <source>Not all of the tooth could be reached from %1 mm, so %2 mm is stored. Move the rest or the device instead.</source>
        <extracomment>%1 and %2: millimetres</extracomment>
        <translation>Von %1 mm aus wäre nicht der ganze Zahn erreichbar, deshalb sind %2 mm gespeichert. Verschieben Sie stattdessen die Auflage oder das Gerät.</translation>
    </message>
    <message>
        <source>The top of the tooth is at the middle of the work area.</source>
        <translation>Die Oberseite des Zahns ist in der Mitte des Arbeitsbereichs.</translation>
    </message>
    <message>
        <source>The top of the tooth is %1 mm above the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>Die Oberseite des Zahns ist %1 mm über der Mitte des Arbeitsbereichs.</translation>
    </message>
    <message>
        <source>The top of the tooth is %1 mm below the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>Die Oberseite des Zahns ist %1 mm unter der Mitte des Arbeitsbereichs.</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <extracomment>%1: &quot;Right hand&quot;; %2: &quot;Novint Falcon&quot;</extracomment>
        <translation>%1, %2.</translation>
    </message>
    <message>
        <source>How still the hand is held was not measured.</source>
        <translation>Wie ruhig die Hand gehalten wird, wurde nicht gemessen.</translation>
    </message>
    <message>
        <source>The device is not ready. Its entry on the page of devices says what to do.</source>
        <translation>Das Gerät ist nicht bereit. Sein Eintrag auf der Seite der Geräte sagt, was zu tun ist.</translation>
    </message>
    <message>
        <source>The grip is %1 mm above the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>Der Griff ist %1 mm über der Mitte des Arbeitsbereichs.</translation>
    </message>
    <message>
        <source>The grip is %1 mm below the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>Der Griff ist %1 mm unter der Mitte des Arbeitsbereichs.</translation>
    </message>
    <message>
        <source>Mouse or pen</source>
        <translation>Maus oder Stift</translation>
    </message>
</context>
<context>
    <name>app::SoundController</name>
    <message>
        <source>Show the device</source>
        <translation>Gerät anzeigen</translation>
    </message>
    <message>
        <source>The sound is on.</source>
        <translation>Der Ton ist an.</translation>
    </message>
    <message>
        <source>The sound is off. %1 turns it on again.</source>
        <extracomment>%1: a key</extracomment>
        <translation>Der Ton ist aus. %1 schaltet ihn wieder ein.</translation>
    </message>
</context>
</TS>
