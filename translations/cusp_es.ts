<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en_US">
<context>
    <name>Admin</name>
    <message>
        <source>erased a person</source>
        <translation>borró a una persona</translation>
    </message>
    <message>
        <source>erased a comment</source>
        <translation>borró un comentario</translation>
    </message>
    <message>
        <source>erased the reason for a score</source>
        <translation>borró el motivo de una puntuación</translation>
    </message>
    <message>
        <source>This person was erased and cannot come back.</source>
        <translation>Esta persona fue borrada y no puede volver.</translation>
    </message>
    <message>
        <source>Erase %1?</source>
        <translation>¿Borrar a %1?</translation>
    </message>
    <message>
        <source>The names, the login and the comments by and about this person are removed. The attempts and scores stay, under a pseudonym. This cannot be undone, and it does not reach backups and exported files.</source>
        <translation>Se eliminan los nombres, el inicio de sesión y los comentarios de esta persona y sobre ella. Los intentos y las puntuaciones se conservan con un seudónimo. No se puede deshacer, y no alcanza las copias de seguridad ni los archivos exportados.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>&amp;Keep the person</source>
        <translation>&amp;Conservar a la persona</translation>
    </message>
    <message>
        <source>an attempt was compared with the assigned version</source>
        <translation>se comparó un intento con la versión asignada</translation>
    </message>
    <message>
        <source>marked an attempt again from its recording</source>
        <translation>volvió a calificar un intento a partir de su grabación</translation>
    </message>
    <message>
        <source>found an older copy in the place of the database</source>
        <translation>encontró una copia más antigua en lugar de la base de datos</translation>
    </message>
    <message>
        <source>logged in</source>
        <translation>inició sesión</translation>
    </message>
    <message>
        <source>logged out</source>
        <translation>cerró sesión</translation>
    </message>
    <message>
        <source>a login failed</source>
        <translation>falló un inicio de sesión</translation>
    </message>
    <message>
        <source>used a one-time code</source>
        <translation>usó un código de un solo uso</translation>
    </message>
    <message>
        <source>changed the password</source>
        <translation>cambió la contraseña</translation>
    </message>
    <message>
        <source>reset a password</source>
        <translation>restableció una contraseña</translation>
    </message>
    <message>
        <source>entered a person</source>
        <translation>registró a una persona</translation>
    </message>
    <message>
        <source>changed a person</source>
        <translation>modificó a una persona</translation>
    </message>
    <message>
        <source>added a class</source>
        <translation>añadió un grupo</translation>
    </message>
    <message>
        <source>renamed a class</source>
        <translation>cambió el nombre de un grupo</translation>
    </message>
    <message>
        <source>put somebody into a class</source>
        <translation>puso a alguien en un grupo</translation>
    </message>
    <message>
        <source>took somebody out of a class</source>
        <translation>sacó a alguien de un grupo</translation>
    </message>
    <message>
        <source>gave a lesson to a class</source>
        <translation>asignó una lección a un grupo</translation>
    </message>
    <message>
        <source>took a lesson back</source>
        <translation>retiró una lección</translation>
    </message>
    <message>
        <source>an attempt was kept</source>
        <translation>se guardó un intento</translation>
    </message>
    <message>
        <source>commented on an attempt</source>
        <translation>comentó un intento</translation>
    </message>
    <message>
        <source>gave another score</source>
        <translation>dio otra puntuación</translation>
    </message>
    <message>
        <source>kept a hardness preset</source>
        <translation>guardó un ajuste de dureza</translation>
    </message>
    <message>
        <source>changed a setting</source>
        <translation>cambió un ajuste</translation>
    </message>
    <message>
        <source>a backup was restored</source>
        <translation>se restauró una copia de seguridad</translation>
    </message>
    <message>
        <source>guest</source>
        <translation>invitado</translation>
    </message>
    <message>
        <source>student</source>
        <translation>estudiante</translation>
    </message>
    <message>
        <source>instructor</source>
        <translation>docente</translation>
    </message>
    <message>
        <source>admin</source>
        <translation>administrador</translation>
    </message>
    <message>
        <source>nobody</source>
        <translation>nadie</translation>
    </message>
    <message>
        <source>the program</source>
        <translation>el programa</translation>
    </message>
    <message>
        <source>began an exam</source>
        <translation>comenzó un examen</translation>
    </message>
    <message>
        <source>found the audit changed</source>
        <translation>encontró el registro alterado</translation>
    </message>
    <message>
        <source>made a backup</source>
        <translation>hizo una copia de seguridad</translation>
    </message>
    <message>
        <source>exported attempts</source>
        <translation>exportó intentos</translation>
    </message>
    <message>
        <source>copied the school into another database</source>
        <translation>copió la escuela a otra base de datos</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>otro nombre</translation>
    </message>
    <message>
        <source>a name that nobody has</source>
        <translation>un nombre que nadie tiene</translation>
    </message>
    <message>
        <source>brought the school here from another database</source>
        <translation>trajo aquí la escuela desde otra base de datos</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>desactivada</translation>
    </message>
    <message>
        <source>enabled</source>
        <translation>activada</translation>
    </message>
    <message numerus="yes">
        <source>at most %n attempt(s)</source>
        <translation>
            <numerusform>como máximo %n intento</numerusform>
            <numerusform>como máximo %n intentos</numerusform>
        </translation>
    </message>
    <message>
        <source>as many attempts as one likes</source>
        <translation>tantos intentos como se quiera</translation>
    </message>
    <message>
        <source>It has more fields than the first line names.</source>
        <translation>Tiene más campos de los que nombra la primera línea.</translation>
    </message>
    <message>
        <source>It stands in line %1 already.</source>
        <translation>Ya está en la línea %1.</translation>
    </message>
    <message>
        <source>It is too long, or has signs that cannot be seen.</source>
        <translation>Es demasiado largo o contiene signos que no se ven.</translation>
    </message>
    <message>
        <source>It is none of student, instructor, admin.</source>
        <translation>No es student, instructor ni admin.</translation>
    </message>
    <message>
        <source>Here the role is %1; a class list does not change it.</source>
        <translation>Aquí el papel es %1; una lista de clase no lo cambia.</translation>
    </message>
    <message>
        <source>The name of a class has 1 to 100 characters that can be seen.</source>
        <translation>El nombre de una clase tiene de 1 a 100 caracteres visibles.</translation>
    </message>
    <message>
        <source>when a place that was left is locked</source>
        <translation>cuándo se bloquea un puesto abandonado</translation>
    </message>
    <message>
        <source>how long checking a password takes</source>
        <translation>cuánto tarda la comprobación de una contraseña</translation>
    </message>
    <message>
        <source>how much memory checking a password takes</source>
        <translation>cuánta memoria necesita la comprobación de una contraseña</translation>
    </message>
    <message>
        <source>the preset that everybody uses</source>
        <translation>el ajuste que usan todos</translation>
    </message>
    <message>
        <source>attempt %1</source>
        <translation>intento %1</translation>
    </message>
    <message>
        <source>exam %1</source>
        <translation>examen %1</translation>
    </message>
    <message>
        <source>class %1</source>
        <translation>grupo %1</translation>
    </message>
    <message>
        <source>person %1</source>
        <translation>persona %1</translation>
    </message>
    <message>
        <source>setting %1</source>
        <translation>ajuste %1</translation>
    </message>
    <message>
        <source>all attempts</source>
        <translation>todos los intentos</translation>
    </message>
    <message>
        <source>the school</source>
        <translation>la escuela</translation>
    </message>
    <message>
        <source>the audit</source>
        <translation>el registro</translation>
    </message>
    <message>
        <source>preset %1, version %2</source>
        <translation>ajuste de dureza %1, versión %2</translation>
    </message>
    <message>
        <source>backup of %1</source>
        <extracomment>%1: a day and a time, or the name of a file</extracomment>
        <translation>copia del %1</translation>
    </message>
    <message>
        <source>From sign %1 of this line on the file is no UTF-8 text. Save it from the spreadsheet as “CSV UTF-8”.</source>
        <translation>A partir del carácter %1 de esta línea, el archivo no es texto en UTF-8. Guárdelo desde la hoja de cálculo como «CSV UTF-8».</translation>
    </message>
    <message>
        <source>A quotation mark at sign %1 of this line is not closed.</source>
        <translation>Las comillas del carácter %1 de esta línea no se cierran.</translation>
    </message>
    <message>
        <source>At sign %1 of this line words stand behind a closing quotation mark.</source>
        <translation>En el carácter %1 de esta línea hay texto detrás de las comillas de cierre.</translation>
    </message>
    <message>
        <source>A class list has no such column. Is it %1?</source>
        <extracomment>%1: the name of a column</extracomment>
        <translation>Una lista de clase no tiene tal columna. ¿Es %1?</translation>
    </message>
    <message>
        <source>This column is there twice.</source>
        <translation>Esta columna está dos veces.</translation>
    </message>
    <message>
        <source>This column is missing. The first line names the columns.</source>
        <translation>Falta esta columna. La primera línea nombra las columnas.</translation>
    </message>
    <message>
        <source>a computer wrote here for the first time</source>
        <translation>un ordenador escribió aquí por primera vez</translation>
    </message>
    <message>
        <source>computer with the key %1</source>
        <translation>ordenador con la clave %1</translation>
    </message>
    <message>
        <source>took out a report of a class</source>
        <translation>sacó un informe de una clase</translation>
    </message>
    <message>
        <source>had the password kept more safely</source>
        <translation>tiene ahora la contraseña guardada con más seguridad</translation>
    </message>
    <message>
        <source>took a comment back</source>
        <translation>retiró un comentario</translation>
    </message>
    <message>
        <source>how long a login by a name that nobody has takes</source>
        <translation>cuánto tarda un inicio de sesión con un nombre que nadie tiene</translation>
    </message>
    <message>
        <source>A class list has no such column. It has username, given_name, family_name, role and class.</source>
        <translation>Una lista de clase no tiene tal columna. Tiene username, given_name, family_name, role y class.</translation>
    </message>
    <message>
        <source>which presets are retired</source>
        <translation>qué ajustes de dureza están retirados</translation>
    </message>
    <message>
        <source>table %1</source>
        <translation>tabla %1</translation>
    </message>
    <message>
        <source>trigger %1</source>
        <translation>disparador %1</translation>
    </message>
    <message>
        <source>It is empty, longer than 64 characters, or has other characters than the letters a to z, digits and . _ - @.</source>
        <translation>Está vacío, tiene más de 64 caracteres o contiene otros que las letras de la a a la z, cifras y . _ - @.</translation>
    </message>
</context>
<context>
    <name>Block</name>
    <message>
        <source>Practice block: line</source>
        <translation>Bloque de práctica: línea</translation>
    </message>
    <message>
        <source>Practice block: circle</source>
        <translation>Bloque de práctica: círculo</translation>
    </message>
    <message>
        <source>Practice block: cross</source>
        <translation>Bloque de práctica: cruz</translation>
    </message>
    <message>
        <source>Practice block: square</source>
        <translation>Bloque de práctica: cuadrado</translation>
    </message>
    <message>
        <source>Practice block: dovetail</source>
        <translation>Bloque de práctica: cola de milano</translation>
    </message>
    <message>
        <source>Practice block: staircase</source>
        <translation>Bloque de práctica: escalera</translation>
    </message>
    <message>
        <source>Practice block: letter I</source>
        <translation>Bloque de práctica: letra I</translation>
    </message>
    <message>
        <source>Practice block: letter T</source>
        <translation>Bloque de práctica: letra T</translation>
    </message>
    <message>
        <source>Practice block: three layers</source>
        <translation>Bloque de práctica: tres capas</translation>
    </message>
    <message>
        <source>Practice block: depth plunges</source>
        <translation>Bloque de práctica: pozos de profundidad</translation>
    </message>
    <message>
        <source>Practice block: enamel and dentin</source>
        <translation>Bloque de práctica: esmalte y dentina</translation>
    </message>
</context>
<context>
    <name>Breach</name>
    <message>
        <source>The pulp is exposed</source>
        <translation>La pulpa está expuesta</translation>
    </message>
    <message>
        <source>The tooth is perforated</source>
        <translation>El diente está perforado</translation>
    </message>
    <message>
        <source>Deeper than %1 mm</source>
        <translation>Más profundo que %1 mm</translation>
    </message>
    <message>
        <source>The marginal ridge is thinner than %1 mm</source>
        <translation>La cresta marginal mide menos de %1 mm</translation>
    </message>
    <message>
        <source>Cut outside the target area</source>
        <translation>Se talló fuera de la zona prevista</translation>
    </message>
    <message>
        <source>Pressed with %1 N; the limit is %2 N</source>
        <translation>Se presionó con %1 N; el límite es %2 N</translation>
    </message>
    <message>
        <source>The bur ran without contact for %1 s</source>
        <translation>La fresa giró sin contacto durante %1 s</translation>
    </message>
    <message>
        <source>Cut with a bur that this lesson does not allow</source>
        <translation>Se talló con una fresa que esta lección no permite</translation>
    </message>
    <message>
        <source>An exposed pulp usually dies, because cut odontoblasts do not recover. Watch the section and leave half a millimetre of dentin.</source>
        <translation>Una pulpa expuesta suele morir, porque los odontoblastos cortados no se recuperan. Observe el corte y deje medio milímetro de dentina.</translation>
    </message>
    <message>
        <source>A perforated tooth is usually lost. Watch the depth in the section.</source>
        <translation>Un diente perforado suele perderse. Vigile la profundidad en el corte.</translation>
    </message>
    <message>
        <source>Cutting deeper than necessary weakens the tooth and comes close to the pulp. The section shows how deep you are.</source>
        <translation>Tallar más de lo necesario debilita el diente y se acerca a la pulpa. El corte muestra a qué profundidad está.</translation>
    </message>
    <message>
        <source>A thin marginal ridge breaks under load. Stop the bur&apos;s outer edge earlier.</source>
        <translation>Una cresta marginal delgada se rompe bajo carga. Detenga antes el borde exterior de la fresa.</translation>
    </message>
    <message>
        <source>Sound tissue does not grow back. The dashed line in the section shows what to cut.</source>
        <translation>El tejido sano no vuelve a crecer. La línea discontinua del corte muestra lo que hay que tallar.</translation>
    </message>
    <message>
        <source>About 1 N cuts best; more heats the pulp, stalls the turbine and slips. Let the bur do the work.</source>
        <translation>Alrededor de 1 N es lo que mejor corta; más calienta la pulpa, frena la turbina y resbala. Deje trabajar a la fresa.</translation>
    </message>
    <message>
        <source>A running bur can injure lips and cheeks. Stop it when you are not cutting.</source>
        <translation>Una fresa en marcha puede herir labios y mejillas. Deténgala cuando no esté tallando.</translation>
    </message>
    <message>
        <source>The shape of the bur determines the shape of the cavity. Choose a bur that the lesson lists.</source>
        <translation>La forma de la fresa determina la forma de la cavidad. Elija una fresa que indique la lección.</translation>
    </message>
    <message>
        <source>The running bur touched the adjacent tooth</source>
        <translation>La fresa en marcha tocó el diente adyacente</translation>
    </message>
    <message>
        <source>A nick in the adjacent tooth collects plaque and decays. Stay inside the outline; N shows the adjacent teeth.</source>
        <translation>Una muesca en el diente adyacente retiene placa y se caria. No salga del contorno; N muestra los dientes adyacentes.</translation>
    </message>
</context>
<context>
    <name>Bur</name>
    <message>
        <source>Round, No. %1</source>
        <translation>Redonda, n.º %1</translation>
    </message>
    <message>
        <source>Inverted cone, No. %1</source>
        <translation>Cono invertido, n.º %1</translation>
    </message>
    <message>
        <source>Straight fissure, No. %1</source>
        <translation>Fisura recta, n.º %1</translation>
    </message>
    <message>
        <source>Straight fissure, crosscut, No. %1</source>
        <translation>Fisura recta de corte transversal, n.º %1</translation>
    </message>
    <message>
        <source>Domed fissure, crosscut, No. %1</source>
        <translation>Fisura de punta redondeada y corte transversal, n.º %1</translation>
    </message>
    <message>
        <source>Tapered fissure, No. %1</source>
        <translation>Fisura cónica, n.º %1</translation>
    </message>
    <message>
        <source>Tapered fissure, crosscut, No. %1</source>
        <translation>Fisura cónica de corte transversal, n.º %1</translation>
    </message>
    <message>
        <source>Pear, No. %1</source>
        <translation>Pera, n.º %1</translation>
    </message>
    <message>
        <source>Long pear, No. %1</source>
        <translation>Pera larga, n.º %1</translation>
    </message>
    <message>
        <source>Egg, No. %1</source>
        <translation>Huevo, n.º %1</translation>
    </message>
    <message>
        <source>Flame, No. %1</source>
        <translation>Llama, n.º %1</translation>
    </message>
    <message>
        <source>Cylinder, No. %1</source>
        <translation>Cilindro, n.º %1</translation>
    </message>
    <message>
        <source>Round-end taper, No. %1</source>
        <translation>Cónica de punta redondeada, n.º %1</translation>
    </message>
    <message>
        <source>Chamfer, No. %1</source>
        <translation>Torpedo, n.º %1</translation>
    </message>
    <message>
        <source>Diamond, round, No. %1</source>
        <translation>Diamante redondo, n.º %1</translation>
    </message>
    <message>
        <source>Diamond, pear, No. %1</source>
        <translation>Diamante en pera, n.º %1</translation>
    </message>
    <message>
        <source>Diamond, egg, No. %1</source>
        <translation>Diamante en huevo, n.º %1</translation>
    </message>
    <message>
        <source>Diamond, flame, No. %1</source>
        <translation>Diamante en llama, n.º %1</translation>
    </message>
    <message>
        <source>Diamond, cylinder, No. %1</source>
        <translation>Diamante cilíndrico, n.º %1</translation>
    </message>
    <message>
        <source>Diamond, round-end taper, No. %1</source>
        <translation>Diamante cónico de punta redondeada, n.º %1</translation>
    </message>
    <message>
        <source>Diamond, chamfer, No. %1</source>
        <translation>Diamante torpedo, n.º %1</translation>
    </message>
    <message>
        <source>Diamond, No. %1</source>
        <translation>Diamante, n.º %1</translation>
    </message>
</context>
<context>
    <name>Chart</name>
    <message numerus="yes">
        <source>and %n more</source>
        <extracomment>Bars of a chart that there is no room for</extracomment>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Criterion</name>
    <message>
        <source>Enamel and dentin beside and below the decay. Tissue directly above the decay must be removed and is not counted.</source>
        <translation>Esmalte y dentina al lado y debajo de la caries. El tejido situado justo encima de la caries debe quitarse y no se cuenta.</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>no medido</translation>
    </message>
    <message>
        <source>%1 − %2 free</source>
        <extracomment>%1 is a value, %2 what of it costs nothing: &quot;3.20 − 1.00 free&quot;</extracomment>
        <translation>%1 − %2 sin coste</translation>
    </message>
    <message>
        <source>at least %1 %2</source>
        <translation>al menos %1 %2</translation>
    </message>
    <message>
        <source>up to %1 %2</source>
        <translation>hasta %1 %2</translation>
    </message>
    <message>
        <source>Not measured, so the attempt fails and the remaining %1 points are lost</source>
        <translation>No se midió, así que el intento no se aprueba y se pierden los %1 puntos restantes</translation>
    </message>
    <message>
        <source>Not measured, so it earns none of its %1 points</source>
        <translation>No se midió, así que no da ninguno de sus %1 puntos</translation>
    </message>
    <message>
        <source>%1: nothing lost</source>
        <translation>%1: nada perdido</translation>
    </message>
    <message>
        <source>Allowed: %1. The attempt fails and the remaining %2 points are lost</source>
        <extracomment>%1 is a range: &quot;up to 0.00 mm²&quot;</extracomment>
        <translation>Se permite: %1. El intento no se aprueba y se pierden los %2 puntos restantes</translation>
    </message>
    <message>
        <source>%1 %2 outside the limit; a more serious error decides</source>
        <translation>%1 %2 fuera del límite; decide un error más grave</translation>
    </message>
    <message>
        <source>%1; beyond it all of its %2 points are lost</source>
        <translation>%1; más allá se pierden todos sus %2 puntos</translation>
    </message>
    <message>
        <source>(%1) / %2 %3 × %4 points</source>
        <translation>(%1) / %2 %3 × %4 puntos</translation>
    </message>
    <message>
        <source>%1, at most all of them</source>
        <translation>%1, como máximo todos</translation>
    </message>
    <message>
        <source>%1 has reached %2</source>
        <extracomment>%1: the name of a measure, %2: a figure with its unit</extracomment>
        <translation>%1 haya alcanzado %2</translation>
    </message>
    <message>
        <source>None of its %1 points are earned before %2</source>
        <extracomment>%1: points of a score, %2: what has to be done: &quot;50 % of the decay is removed&quot;</extracomment>
        <translation>No se gana ninguno de sus %1 puntos hasta que %2</translation>
    </message>
    <message>
        <source>%1 of the decay is removed</source>
        <extracomment>%1: a share: &quot;50 %&quot;</extracomment>
        <translation>se haya quitado el %1 de la caries</translation>
    </message>
    <message>
        <source>%1 of the ideal is cut</source>
        <translation>se haya tallado el %1 del ideal</translation>
    </message>
    <message>
        <source>%1 of the shape is cut</source>
        <translation>se haya tallado el %1 de la forma</translation>
    </message>
    <message>
        <source>The measured value was not saved</source>
        <translation>El valor medido no se guardó</translation>
    </message>
    <message>
        <source>Counts as soon as %1</source>
        <extracomment>%1: what has to be done: &quot;50 % of the decay is removed&quot;</extracomment>
        <translation>Cuenta en cuanto %1</translation>
    </message>
    <message>
        <source>Not measured, so the score is limited to %1 points</source>
        <extracomment>%1: points of a score</extracomment>
        <translation>No medido, por lo que la puntuación se limita a %1 puntos</translation>
    </message>
    <message>
        <source>Allowed: %1. The score is limited to %2 points</source>
        <extracomment>%1 is a range: &quot;up to 0.00 mm²&quot;; %2: points of a score</extracomment>
        <translation>Permitido: %1. La nota se limita a %2 puntos</translation>
    </message>
    <message>
        <source>%1 of the tooth is removed</source>
        <translation>se haya eliminado %1 del diente</translation>
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
        <translation>vestibular</translation>
    </message>
    <message>
        <source>buccal</source>
        <translation>vestibular</translation>
    </message>
    <message>
        <source>palatal</source>
        <translation>palatino</translation>
    </message>
    <message>
        <source>lingual</source>
        <translation>lingual</translation>
    </message>
    <message>
        <source>distolabial</source>
        <translation>distovestibular</translation>
    </message>
    <message>
        <source>distobuccal</source>
        <translation>distovestibular</translation>
    </message>
    <message>
        <source>distopalatal</source>
        <translation>distopalatino</translation>
    </message>
    <message>
        <source>distolingual</source>
        <translation>distolingual</translation>
    </message>
    <message>
        <source>mesiolabial</source>
        <translation>mesiovestibular</translation>
    </message>
    <message>
        <source>mesiobuccal</source>
        <translation>mesiovestibular</translation>
    </message>
    <message>
        <source>mesiopalatal</source>
        <translation>mesiopalatino</translation>
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
        <translation>A lo largo de x</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>A lo largo de y</translation>
    </message>
    <message>
        <source>Labio-palatal</source>
        <translation>Vestibulopalatino</translation>
    </message>
    <message>
        <source>Labio-lingual</source>
        <translation>Vestibulolingual</translation>
    </message>
    <message>
        <source>Bucco-palatal</source>
        <translation>Vestibulopalatino</translation>
    </message>
    <message>
        <source>Bucco-lingual</source>
        <translation>Vestibulolingual</translation>
    </message>
    <message>
        <source>apical</source>
        <translation>apical</translation>
    </message>
    <message>
        <source>incisal</source>
        <translation>incisal</translation>
    </message>
    <message>
        <source>occlusal</source>
        <translation>oclusal</translation>
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
        <translation>El archivo no está. ¿Se movió o cambió de nombre?</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that it is a file and that you may open it.</source>
        <translation>El archivo no se puede leer. Compruebe que es un archivo y que tiene permiso para abrirlo.</translation>
    </message>
    <message>
        <source>The file cannot be written. Choose another folder, or make room on the disk.</source>
        <translation>El archivo no se puede escribir. Elija otra carpeta o libere espacio en el disco.</translation>
    </message>
    <message>
        <source>A newer Cusp wrote this file. Update Cusp to open it.</source>
        <translation>Este archivo lo escribió un Cusp más nuevo. Actualice Cusp para abrirlo.</translation>
    </message>
    <message>
        <source>There is no surface in this file. Choose a scan of a tooth.</source>
        <translation>En este archivo no hay ninguna superficie. Elija el escaneo de un diente.</translation>
    </message>
    <message>
        <source>Cusp does not know what is asked for by this name.</source>
        <translation>Cusp no conoce nada con este nombre.</translation>
    </message>
    <message>
        <source>A value lies outside what Cusp can work with.</source>
        <translation>Un valor está fuera de lo que Cusp puede manejar.</translation>
    </message>
    <message>
        <source>It was made on another tooth, or with another decay, than this lesson&apos;s. Ask who made the lesson.</source>
        <translation>Se hizo en otro diente que el de esta lección, o con otra caries. Pregunte a quien hizo la lección.</translation>
    </message>
    <message>
        <source>Export it again, or choose another scan.</source>
        <translation>Expórtelo de nuevo o elija otro escaneo.</translation>
    </message>
    <message>
        <source>Copy it again from where it was made, or choose another one.</source>
        <translation>Cópielo de nuevo desde donde se hizo o elija otro.</translation>
    </message>
    <message>
        <source>Put a copy of it back, or move it away: Cusp then begins a new one.</source>
        <translation>Reponga una copia o muévalo a otro sitio: Cusp empezará entonces uno nuevo.</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>Inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>The file is no recording of Cusp.</source>
        <translation>El archivo no es una grabación de Cusp.</translation>
    </message>
    <message>
        <source>The file is no database of Cusp.</source>
        <translation>El archivo no es una base de datos de Cusp.</translation>
    </message>
    <message>
        <source>The file is not what its name says. Scans are OBJ, STL or PLY.</source>
        <translation>El archivo no es lo que dice su nombre. Los escaneos son OBJ, STL o PLY.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>El archivo está vacío.</translation>
    </message>
    <message>
        <source>The file ends too early.</source>
        <translation>El archivo termina demasiado pronto.</translation>
    </message>
    <message>
        <source>The file is too large. Export it with fewer triangles.</source>
        <translation>El archivo es demasiado grande. Expórtelo con menos triángulos.</translation>
    </message>
    <message>
        <source>The file is too large.</source>
        <translation>El archivo es demasiado grande.</translation>
    </message>
    <message>
        <source>Where a number belongs, the file holds something else.</source>
        <translation>Donde debería haber un número, el archivo contiene otra cosa.</translation>
    </message>
    <message>
        <source>The content of the file does not fit together.</source>
        <translation>El contenido del archivo no concuerda.</translation>
    </message>
    <message>
        <source>The scan cannot be opened. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>No se puede abrir el escaneo. %1</translation>
    </message>
    <message>
        <source>The tooth cannot be created. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>No se puede crear el diente. %1</translation>
    </message>
    <message>
        <source>The recording cannot be played. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>No se puede reproducir la grabación. %1</translation>
    </message>
    <message>
        <source>The recording was not saved. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>La grabación no se guardó. %1</translation>
    </message>
    <message>
        <source>Grades will not be saved; drilling and grading still work. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Las calificaciones no se guardarán; aun así puede tallar y recibir calificación. %1</translation>
    </message>
    <message>
        <source>Its file is kept for seven days, in the folder &quot;discarded&quot;.</source>
        <translation>Su archivo se conserva siete días, en la carpeta «discarded».</translation>
    </message>
    <message>
        <source>Ask who made the lesson, or choose another one.</source>
        <translation>Pregunte a quien hizo la lección o elija otra.</translation>
    </message>
    <message>
        <source>This Cusp did not write the file, or an older one did.</source>
        <translation>El archivo no lo escribió este Cusp, o lo escribió uno más antiguo.</translation>
    </message>
    <message>
        <source>The lesson cannot be started; your work is unchanged. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>No se puede empezar la lección; su trabajo no ha cambiado. %1</translation>
    </message>
    <message>
        <source>The work cannot be graded; it is unchanged. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>No se puede calificar el trabajo; no ha cambiado. %1</translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work: if the computer fails, it is lost. Make room on the disk, or save the recording now and then.</source>
        <translation>Este intento no se conserva en el disco mientras trabaja: si el ordenador falla, se pierde. Libere espacio en el disco o guarde la grabación de vez en cuando.</translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Este intento no se conserva en el disco mientras trabaja. %1</translation>
    </message>
    <message>
        <source>An unfinished attempt cannot be resumed. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Un intento sin terminar no se puede reanudar. %1</translation>
    </message>
    <message>
        <source>Nothing has been cut yet that could be a reference.</source>
        <translation>Todavía no se ha tallado nada que pueda ser una referencia.</translation>
    </message>
    <message>
        <source>The reference was not saved. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>La referencia no se guardó. %1</translation>
    </message>
    <message>
        <source>Another program is writing to the school&apos;s database. Try again in a moment.</source>
        <translation>Otro programa está escribiendo en la base de datos de la escuela. Inténtelo de nuevo en un momento.</translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Cusp tries again by itself.</source>
        <translation>El servidor de la escuela no responde. Cusp lo intenta de nuevo por sí solo.</translation>
    </message>
    <message>
        <source>Your role does not allow it.</source>
        <translation>Su función no lo permite.</translation>
    </message>
    <message>
        <source>Wrong username or password.</source>
        <translation>El nombre de usuario o la contraseña no son correctos.</translation>
    </message>
    <message>
        <source>Too many logins have failed. Wait a moment and try again.</source>
        <translation>Ha fallado el inicio de sesión demasiadas veces. Espere un momento e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Choose a password first.</source>
        <translation>Elija primero una contraseña.</translation>
    </message>
    <message>
        <source>The school&apos;s data cannot be shown now; your work is saved. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Los datos de la escuela no se pueden mostrar ahora; su trabajo se guarda. %1</translation>
    </message>
    <message>
        <source>The school&apos;s file cannot be written. Make room on the disk, or make its folder writable.</source>
        <translation>No se puede escribir el archivo de la escuela. Libere espacio en el disco o dé permiso de escritura en su carpeta.</translation>
    </message>
    <message>
        <source>An older Cusp made this school. Ask its administrator to run “cusp db migrate”.</source>
        <translation>Un Cusp anterior creó esta escuela. Pida a su administrador que ejecute «cusp db migrate».</translation>
    </message>
    <message>
        <source>That was not done, and nothing was changed. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>No se hizo, y nada ha cambiado. %1</translation>
    </message>
    <message>
        <source>An attempt that was to be sent to the school is damaged. It was moved to the folder “outbox/damaged”. Everything else is saved as usual.</source>
        <translation>Un intento que se iba a enviar a la escuela está dañado. Se movió a la carpeta «outbox/damaged». Todo lo demás se guarda como siempre.</translation>
    </message>
    <message>
        <source>Somebody else has changed it meanwhile. Here is what there is now; change it again if need be.</source>
        <translation>Otra persona lo ha cambiado mientras tanto. Aquí está lo que hay ahora; cámbielo de nuevo si hace falta.</translation>
    </message>
    <message>
        <source>This is the last admin who can log in. Make somebody else an admin first.</source>
        <translation>Es el último administrador que puede iniciar sesión. Nombre antes a otro administrador.</translation>
    </message>
    <message>
        <source>This account was disabled. Ask an admin.</source>
        <translation>Esta cuenta se ha desactivado. Pregunte a la administración.</translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Try it again when the server answers.</source>
        <translation>El servidor de la escuela no responde. Inténtelo de nuevo cuando responda.</translation>
    </message>
    <message>
        <source>This grade is not saved yet; Cusp tries again while it runs. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>Esta calificación aún no está guardada; Cusp lo vuelve a intentar mientras esté abierto. %1</translation>
    </message>
    <message>
        <source>The folder “outbox”, where grades wait for the school, cannot be written. Make room on the disk, or make that folder writable.</source>
        <translation>No se puede escribir en la carpeta «outbox», donde las notas esperan a la escuela. Libere espacio en el disco o permita escribir en esa carpeta.</translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work: if the computer fails, it is lost. Go on, and have room made on the disk.</source>
        <translation>Este intento no se guarda en el disco mientras trabaja: si el ordenador falla, se pierde. Siga trabajando y pida que liberen espacio.</translation>
    </message>
    <message>
        <source>The school&apos;s data lie on a network drive, and another Cusp, here or at another computer, has them open. Only one at a time can: close that one. For several computers an admin keeps them on a PostgreSQL server.</source>
        <translation>Los datos de la escuela están en una unidad de red, y otro Cusp, aquí o en otro ordenador, los tiene abiertos. Solo uno puede a la vez: cierre ese. Para varios ordenadores, un administrador los pone en un servidor PostgreSQL.</translation>
    </message>
    <message>
        <source>The school&apos;s server says no. Ask whoever looks after it: its log, or “cusp db check”, says why.</source>
        <translation>El servidor de la escuela lo rechaza. Pregunte a quien lo administra: su registro, o «cusp db check», dice por qué.</translation>
    </message>
    <message>
        <source>The school&apos;s server cannot prove that it is the right one, or cannot encrypt the connection, so nothing is sent to it. Ask whoever looks after it to set up its certificate.</source>
        <translation>El servidor de la escuela no puede demostrar que es el correcto, o no puede cifrar la conexión, así que no se le envía nada. Pida a quien se ocupa de él que configure su certificado.</translation>
    </message>
    <message>
        <source>Your login has ended, or another school is now where yours was. Log in again.</source>
        <translation>Su sesión ha terminado, o donde estaba su escuela hay ahora otra. Inicie sesión de nuevo.</translation>
    </message>
    <message>
        <source>The school&apos;s server went away while this was being done, and nobody can say whether it was. Look when it answers again, before you do it again.</source>
        <translation>El servidor de la escuela se fue mientras esto se hacía, y nadie puede decir si se hizo. Mírelo cuando vuelva a responder, antes de hacerlo otra vez.</translation>
    </message>
    <message>
        <source>Nothing was written: what stands on it is read anew for it. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>No se escribió nada: para ello se vuelve a leer lo que contiene. %1</translation>
    </message>
</context>
<context>
    <name>ExamWords</name>
    <message>
        <source>undo</source>
        <translation>deshacer</translation>
    </message>
    <message>
        <source>expert&apos;s attempt</source>
        <translation>intento del experto</translation>
    </message>
    <message>
        <source>earlier attempts</source>
        <translation>intentos anteriores</translation>
    </message>
    <message>
        <source>Time: %1</source>
        <extracomment>%1: &quot;8 min&quot;, or that there is no limit</extracomment>
        <translation>Tiempo: %1</translation>
    </message>
    <message>
        <source>Attempts: %1</source>
        <extracomment>%1: &quot;2 attempts left, 1 graded so far&quot;</extracomment>
        <translation>Intentos: %1</translation>
    </message>
    <message>
        <source>Passed from: %1 of 100 points</source>
        <extracomment>%1: points</extracomment>
        <translation>Se aprueba con: %1 de 100 puntos</translation>
    </message>
    <message>
        <source>Locked: %1</source>
        <extracomment>%1: a list</extracomment>
        <translation>Bloqueado: %1</translation>
    </message>
    <message>
        <source>The clock starts when you begin, and also runs while you are on another page. Faults are shown after the grade.</source>
        <translation>El tiempo corre desde que empieza, también mientras está en otra página. Los errores se muestran después de la calificación.</translation>
    </message>
    <message>
        <source>&amp;Begin exam</source>
        <translation>Empezar el &amp;examen</translation>
    </message>
</context>
<context>
    <name>ExerciseMarks</name>
    <message>
        <source>height, mm</source>
        <extracomment>Title of a scale: how high the bur&apos;s tip stands over the block</extracomment>
        <translation>altura, mm</translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>&quot;%1&quot; has changed since the lesson was read; open the page again.</source>
        <translation>«%1» ha cambiado desde que se leyó la lección; vuelva a abrir la página.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read, or has more than %2 MB, which a lesson may take along; use a coarser scan.</source>
        <translation>«%1» no se puede leer o supera los %2 MB que una lección puede llevar consigo; use un escaneo menos fino.</translation>
    </message>
    <message>
        <source>The version that was assigned is not on this computer yet. Open this page again when the database can be reached.</source>
        <translation>La versión asignada todavía no está en este equipo. Vuelva a abrir esta página cuando se pueda acceder a la base de datos.</translation>
    </message>
    <message>
        <source>The version that was assigned cannot be read by this version of Cusp. Ask who keeps Cusp to update it.</source>
        <translation>Esta versión de Cusp no puede leer la versión asignada. Pida a quien mantiene Cusp que lo actualice.</translation>
    </message>
    <message>
        <source>touch.points[%1]: there is no tooth at x = %2, y = %3 mm</source>
        <translation>touch.points[%1]: en x = %2, y = %3 mm no hay diente</translation>
    </message>
    <message>
        <source>has %1; a lesson has at most %2</source>
        <translation>tiene %1; una lección tiene como mucho %2</translation>
    </message>
    <message>
        <source>unterminated object</source>
        <translation>un objeto no está cerrado</translation>
    </message>
    <message>
        <source>missing name separator</source>
        <translation>faltan los dos puntos tras una clave</translation>
    </message>
    <message>
        <source>unterminated array</source>
        <translation>una lista no está cerrada</translation>
    </message>
    <message>
        <source>missing value separator</source>
        <translation>falta la coma entre dos valores</translation>
    </message>
    <message>
        <source>invalid termination by number</source>
        <translation>falta algo tras el último número</translation>
    </message>
    <message>
        <source>illegal number</source>
        <translation>un número no válido</translation>
    </message>
    <message>
        <source>invalid escape sequence</source>
        <translation>un carácter no válido tras \</translation>
    </message>
    <message>
        <source>unterminated string</source>
        <translation>un texto no está cerrado</translation>
    </message>
    <message>
        <source>object is missing after a comma</source>
        <translation>falta algo tras una coma</translation>
    </message>
    <message>
        <source>too deeply nested document</source>
        <translation>anidado a demasiada profundidad</translation>
    </message>
    <message>
        <source>too large document</source>
        <translation>demasiado grande</translation>
    </message>
    <message>
        <source>garbage at the end of the document</source>
        <translation>queda algo al final</translation>
    </message>
    <message>
        <source>illegal value</source>
        <translation>un valor no válido</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 bytes</translation>
    </message>
    <message>
        <source>is %1, from a newer Cusp; this one reads %2. Update Cusp to give this lesson</source>
        <translation>es %1, de un Cusp más nuevo; este lee %2. Actualice Cusp para dar esta lección</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>está vacío</translation>
    </message>
    <message>
        <source>is written in UTF-16 or UTF-32; save it as UTF-8</source>
        <translation>está escrito en UTF-16 o UTF-32; guárdelo como UTF-8</translation>
    </message>
    <message>
        <source>is not JSON: line %1, column %2: invalid UTF8 string; save the file as UTF-8</source>
        <translation>no es JSON: línea %1, columna %2: un texto no es UTF-8; guarde el archivo como UTF-8</translation>
    </message>
    <message>
        <source>is not JSON: line %1, column %2: %3</source>
        <translation>no es JSON: línea %1, columna %2: %3</translation>
    </message>
    <message>
        <source>must be one JSON object in braces</source>
        <translation>debe ser un objeto JSON entre llaves</translation>
    </message>
    <message>
        <source>is said twice in one object; leave one out</source>
        <translation>está dos veces en un objeto; quite una</translation>
    </message>
    <message>
        <source>&quot;%1&quot; leads out of the lesson&apos;s folder; name a file beside it</source>
        <translation>«%1» lleva fuera de la carpeta de la lección; indique un archivo junto a ella</translation>
    </message>
    <message>
        <source>is based on itself by way of %1</source>
        <translation>se basa en sí mismo a través de %1</translation>
    </message>
    <message>
        <source>more than %1 files are based on one another</source>
        <translation>se basa en más de %1 archivos encadenados</translation>
    </message>
    <message>
        <source>must be the name of a file beside this one, or of one that is shipped</source>
        <translation>debe ser el nombre de un archivo junto a este o de uno incluido con Cusp</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>no existe</translation>
    </message>
    <message>
        <source>cannot be read (it is a folder)</source>
        <translation>no se puede leer (es una carpeta)</translation>
    </message>
    <message>
        <source>cannot be read (it is no file)</source>
        <translation>no se puede leer (no es un archivo)</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>no se puede leer (%1)</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true o false</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texto</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>una lista</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objeto</translation>
    </message>
    <message>
        <source>null</source>
        <translation>null</translation>
    </message>
    <message>
        <source>is %1; write a number of %2 without its unit</source>
        <translation>es %1; escriba un número sin su unidad (%2)</translation>
    </message>
    <message>
        <source>is %1; write a number</source>
        <translation>es %1; escriba un número</translation>
    </message>
    <message>
        <source>is %1, it must lie between %2 and %3 %4</source>
        <translation>es %1 y debe estar entre %2 y %3 %4</translation>
    </message>
    <message>
        <source>is %1, it must lie between %2 and %3</source>
        <translation>es %1 y debe estar entre %2 y %3</translation>
    </message>
    <message>
        <source>is %1, it must be a whole number</source>
        <translation>es %1 y debe ser un número entero</translation>
    </message>
    <message>
        <source>is %1; write true or false</source>
        <translation>es %1; escriba true o false</translation>
    </message>
    <message>
        <source>is %1; write a text in quotes</source>
        <translation>es %1; escriba un texto entre comillas</translation>
    </message>
    <message>
        <source>has %1 characters; at most %2 are read</source>
        <translation>tiene %1 caracteres; se leen como mucho %2</translation>
    </message>
    <message>
        <source>holds the character U+%1, which cannot be seen; leave it out</source>
        <translation>contiene el carácter U+%1, que no se ve; quítelo</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>has %1 characters; it takes 1 to %2</source>
        <translation>tiene %1 caracteres; debe tener de 1 a %2</translation>
    </message>
    <message>
        <source>is %1; write {&quot;en&quot;: &quot;...&quot;, &quot;de&quot;: &quot;...&quot;}</source>
        <translation>es %1; escriba {&quot;en&quot;: &quot;...&quot;, &quot;de&quot;: &quot;...&quot;}</translation>
    </message>
    <message>
        <source>has texts in %1 languages; it takes 1 to %2</source>
        <translation>tiene textos en %1 idiomas; debe tener de 1 a %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be the code of a language (en, de, es, ja) with a text</source>
        <translation>«%1» debe ser el código de un idioma (en, de, es, ja) con un texto</translation>
    </message>
    <message>
        <source>must be a list of at most %1 texts: [&quot;...&quot;, &quot;...&quot;]</source>
        <translation>debe ser una lista de como mucho %1 textos: [&quot;...&quot;, &quot;...&quot;]</translation>
    </message>
    <message>
        <source>is %1; write an object in braces</source>
        <translation>es %1; escriba un objeto entre llaves</translation>
    </message>
    <message>
        <source>must be a list of at most %1 objects</source>
        <translation>debe ser una lista de como mucho %1 objetos</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known; there are %2</source>
        <translation>«%1» no se conoce; hay %2</translation>
    </message>
    <message>
        <source>must be a list of 1 to %1 places: [[x, y], ...]</source>
        <translation>debe ser una lista de 1 a %1 puntos: [[x, y], ...]</translation>
    </message>
    <message>
        <source>must be [x, y], two numbers between %1 and %2 mm</source>
        <translation>debe ser [x, y], dos números entre %1 y %2 mm</translation>
    </message>
    <message>
        <source>is not a key that is known here, so it is left out</source>
        <translation>no es una clave conocida aquí, así que se omite</translation>
    </message>
    <message>
        <source>is not a key that is known here; did you mean &quot;%1&quot;?</source>
        <translation>no es una clave conocida aquí; ¿quería decir «%1»?</translation>
    </message>
    <message>
        <source>%1 (in the pack %2)</source>
        <translation>%1 (en el paquete %2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to another lesson; give this one an id of its own</source>
        <translation>«%1» pertenece a otra lección; dé a esta un id propio</translation>
    </message>
    <message>
        <source>is missing; write &quot;format&quot;: %1</source>
        <translation>falta; escriba &quot;format&quot;: %1</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; beside the lesson</source>
        <translation>junto a la lección no hay ningún archivo «%1»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read</source>
        <translation>«%1» no se puede leer</translation>
    </message>
    <message>
        <source>is missing; there are %1</source>
        <translation>falta; hay %1</translation>
    </message>
    <message>
        <source>has %1 with all that it names; a recording takes at most %2 along. Shorten its texts</source>
        <translation>tiene %1 con todo lo que nombra; una grabación lleva como mucho %2. Acorte sus textos</translation>
    </message>
    <message>
        <source>is missing; write {&quot;fdi&quot;: 36}, {&quot;block&quot;: &quot;line&quot;} or {&quot;scan&quot;: &quot;tooth.stl&quot;}</source>
        <translation>falta; escriba {&quot;fdi&quot;: 36}, {&quot;block&quot;: &quot;line&quot;} o {&quot;scan&quot;: &quot;tooth.stl&quot;}</translation>
    </message>
    <message>
        <source>must name one of &quot;fdi&quot;, &quot;block&quot; and &quot;scan&quot;</source>
        <translation>debe indicar uno solo de «fdi», «block» y «scan»</translation>
    </message>
    <message>
        <source>there is no tooth %1 here; those of the left are made: 21 to 28 and 31 to 38</source>
        <translation>aquí no hay diente %1; se hacen los del lado izquierdo: 21 a 28 y 31 a 38</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no unit; write mm, cm, m, in or the millimetres of one unit</source>
        <translation>«%1» no es una unidad; escriba mm, cm, m, in o los milímetros de una unidad</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no direction; write +x, -x, +y, -y, +z, -z, or three numbers such as 1,0,1</source>
        <translation>«%1» no es una dirección; escriba +x, -x, +y, -y, +z, -z, o tres números como 1,0,1</translation>
    </message>
    <message>
        <source>an ideal is captured, or has a kind and sizes; leave one out (where the lesson is based on another, with &quot;kind&quot;: null, &quot;sizes&quot;: null)</source>
        <translation>un ideal es capturado o tiene kind y sizes; quite uno (si la lección se basa en otra, con &quot;kind&quot;: null, &quot;sizes&quot;: null)</translation>
    </message>
    <message>
        <source>is missing; name the preparation, or a file &quot;captured&quot;</source>
        <translation>falta; indique la preparación o un archivo «captured»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2; a lesson takes at most %3. Capture it on a coarser grid</source>
        <translation>«%1» tiene %2; una lección admite como mucho %3. Captúrelo en una rejilla más gruesa</translation>
    </message>
    <message>
        <source>has its own caries and plastic; leave it out, or leave out &quot;caries&quot; and &quot;plastic&quot;</source>
        <translation>tiene sus propios valores de caries y plástico; quítelo o quite «caries» y «plastic»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no aid; there are section, depth_gauge, radiograph, heat_map, mirror, ideal, bur_colour, fixture, depth_stop</source>
        <translation>«%1» no es una ayuda; hay section, depth_gauge, radiograph, heat_map, mirror, ideal, bur_colour, fixture, depth_stop</translation>
    </message>
    <message>
        <source>only a tooth of ours has neighbours; write false</source>
        <translation>solo un diente de Cusp tiene vecinos; escriba false</translation>
    </message>
    <message>
        <source>to remove decay there must be some: write &quot;lesion&quot;: {&quot;extent&quot;: 0.5} for a tooth</source>
        <translation>para eliminar caries tiene que haberla: escriba &quot;lesion&quot;: {&quot;extent&quot;: 0.5} para un diente</translation>
    </message>
    <message>
        <source>is missing; it says which preparation is to be cut</source>
        <translation>falta; dice qué preparación hay que tallar</translation>
    </message>
    <message>
        <source>a shape is traced in a block: write {&quot;block&quot;: &quot;line&quot;}</source>
        <translation>una forma se traza en un bloque: escriba {&quot;block&quot;: &quot;line&quot;}</translation>
    </message>
    <message>
        <source>is missing; it says which points are to be touched: {&quot;points&quot;: [[x, y], ...]}</source>
        <translation>falta; dice qué puntos hay que tocar: {&quot;points&quot;: [[x, y], ...]}</translation>
    </message>
    <message>
        <source>is missing; it says which force is to be held: {&quot;force_n&quot;: 1}</source>
        <translation>falta; dice qué fuerza hay que mantener: {&quot;force_n&quot;: 1}</translation>
    </message>
    <message>
        <source>layers are told apart in a block of them: write {&quot;block&quot;: &quot;layers&quot;}</source>
        <translation>las capas se distinguen en un bloque de capas: escriba {&quot;block&quot;: &quot;layers&quot;}</translation>
    </message>
    <message>
        <source>layers are told apart without any; leave the key out</source>
        <translation>las capas se distinguen sin ayudas; quite la clave</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was captured on the tooth &apos;%2&apos; (seed %3, grid %4); name that tooth, seed and grid, or capture it on this one</source>
        <translation>«%1» se capturó en el diente «%2» (seed %3, grid %4); indique ese diente con su seed y grid, o captúrelo en este</translation>
    </message>
    <message>
        <source>is made by rule for a tooth of ours only, &quot;tooth&quot;: {&quot;fdi&quot;: 36}; for a scan name a captured one: {&quot;captured&quot;: &quot;mine.cuspideal&quot;}</source>
        <translation>se hace por regla solo para un diente de Cusp, &quot;tooth&quot;: {&quot;fdi&quot;: 36}; para un escaneo indique uno capturado: {&quot;captured&quot;: &quot;mine.cuspideal&quot;}</translation>
    </message>
    <message>
        <source>%1 cannot be read; check its name and rights.</source>
        <translation>%1 no se puede leer; compruebe el nombre y los permisos.</translation>
    </message>
    <message>
        <source>%1 has %2, and a pack takes %3 in all; pack fewer lessons, or coarser scans.</source>
        <translation>%1 tiene %2 y un paquete admite %3 en total; empaquete menos lecciones o escaneos más gruesos.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made; name another.</source>
        <translation>La carpeta %1 no se puede crear; indique otra.</translation>
    </message>
    <message>
        <source>The pack names a file &quot;%1&quot;, which leads out of its folder or is of no kind that lessons have; nothing was unpacked.</source>
        <translation>El paquete nombra un archivo «%1» que lleva fuera de su carpeta o no es de ningún tipo que tengan las lecciones; no se desempaquetó nada.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; in the pack is not what its hash says: it was damaged or changed; nothing was unpacked. Ask for the pack again.</source>
        <translation>El archivo «%1» del paquete no es lo que dice su suma de verificación: se dañó o se cambió; no se desempaquetó nada. Pida el paquete de nuevo.</translation>
    </message>
    <message>
        <source>This is no pack of lessons, it is damaged, or it holds more than %1; choose a file that &quot;cusp lesson pack&quot; has made.</source>
        <translation>No es un paquete de lecciones, está dañado o contiene más de %1; elija un archivo hecho con «cusp lesson pack».</translation>
    </message>
    <message>
        <source>This is no pack of lessons; choose a file that &quot;cusp lesson pack&quot; has made.</source>
        <translation>No es un paquete de lecciones; elija un archivo hecho con «cusp lesson pack».</translation>
    </message>
    <message>
        <source>The pack is of format %1, from a newer Cusp; this one reads %2. Update Cusp.</source>
        <translation>El paquete es de formato %1, de un Cusp más nuevo; este lee %2. Actualice Cusp.</translation>
    </message>
    <message>
        <source>The pack lists %1 files; it may hold 1 to %2.</source>
        <translation>El paquete enumera %1 archivos; puede contener de 1 a %2.</translation>
    </message>
    <message>
        <source>The pack holds &quot;%1&quot; twice; nothing was unpacked.</source>
        <translation>El paquete contiene «%1» dos veces; no se desempaquetó nada.</translation>
    </message>
    <message>
        <source>%1 is a link to elsewhere; nothing was unpacked. Name another folder.</source>
        <translation>%1 es un enlace a otro sitio; no se desempaquetó nada. Indique otra carpeta.</translation>
    </message>
    <message>
        <source>There is another file &quot;%1&quot; in %2 already; nothing was unpacked. Move it away, or name another folder.</source>
        <translation>En %2 ya hay otro archivo «%1»; no se desempaquetó nada. Muévalo o indique otra carpeta.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be written.</source>
        <translation>No se puede escribir en la carpeta %1.</translation>
    </message>
    <message>
        <source>has %1; a hardness preset has at most %2</source>
        <translation>tiene %1; un ajuste de dureza tiene como mucho %2</translation>
    </message>
    <message>
        <source>is %1, from a newer Cusp; this one reads %2. Update Cusp to use it</source>
        <translation>es %1, de un Cusp más nuevo; este lee %2. Actualice Cusp para usarlo</translation>
    </message>
    <message>
        <source>says that this is no hardness preset; choose a file that Cusp has exported</source>
        <translation>dice que esto no es un ajuste de dureza; elija un archivo que Cusp haya exportado</translation>
    </message>
    <message>
        <source>must be one line of 1 to %1 characters</source>
        <translation>debe ser una línea de 1 a %1 caracteres</translation>
    </message>
    <message>
        <source>is not there; check the name</source>
        <translation>no está; compruebe el nombre</translation>
    </message>
    <message>
        <source>cannot be read; name a file that you may read</source>
        <translation>no se puede leer; indique un archivo que usted pueda leer</translation>
    </message>
    <message>
        <source>there is another %1 of version %2; give this one another number</source>
        <translation>hay otro «%1» de la versión %2; dé a este otro número</translation>
    </message>
    <message>
        <source>rubric %1, criterion %2, %3: %4</source>
        <translation>rúbrica %1, criterio %2, %3: %4</translation>
    </message>
    <message>
        <source>%1 %2 is not between %3 and %4</source>
        <translation>%1 %2 no está entre %3 y %4</translation>
    </message>
    <message>
        <source>must be at least 0.1 points</source>
        <translation>debe ser de al menos 0,1 puntos</translation>
    </message>
    <message>
        <source>rubric %1, criteria: there are %2, it takes 1 to %3</source>
        <translation>rúbrica %1, criteria: hay %2, debe haber de 1 a %3</translation>
    </message>
    <message>
        <source>rubric %1, pass_mark: must lie between 0 and 100 points</source>
        <translation>rúbrica %1, pass_mark: debe estar entre 0 y 100 puntos</translation>
    </message>
    <message>
        <source>is there twice</source>
        <translation>está dos veces</translation>
    </message>
    <message>
        <source>rubric %1, weight: those of all criteria make %2 points; they must make 100</source>
        <translation>rúbrica %1, weight: los de todos los criterios suman %2 puntos; deben sumar 100</translation>
    </message>
    <message>
        <source>is %1; points are given to a tenth</source>
        <translation>es %1; los puntos se dan con un decimal</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no measure; &quot;cusp lesson measures&quot; lists them</source>
        <translation>«%1» no es una medida; «cusp lesson measures» las enumera</translation>
    </message>
    <message>
        <source>may hold small letters, digits, &apos;-&apos; and &apos;_&apos; only, and begins with a letter or digit</source>
        <translation>solo puede contener minúsculas, cifras, «-» y «_», y empieza por una letra o una cifra</translation>
    </message>
    <message>
        <source>is missing; name one that is shipped (&quot;decay_removal&quot;), a file beside the lesson, or write it out</source>
        <translation>falta; indique una incluida con Cusp («decay_removal»), un archivo junto a la lección, o escríbala entera</translation>
    </message>
    <message>
        <source>there is no rubric &quot;%1&quot;</source>
        <translation>no hay ninguna rúbrica «%1»</translation>
    </message>
    <message>
        <source>%1</source>
        <extracomment>%1: what has no words of its own but English ones</extracomment>
        <translation>%1 (solo se sabe en inglés)</translation>
    </message>
    <message>
        <source>the %1 (%2) is not a number</source>
        <extracomment>%1: a number of an ideal or a block, %2: its key, %3: the number that was given</extracomment>
        <translation>%1 (%2) no es un número</translation>
    </message>
    <message>
        <source>the %1 (%2) must be from %4 to %5, not %3</source>
        <translation>%1 (%2) debe estar entre %4 y %5, no %3</translation>
    </message>
    <message>
        <source>the %1 (%2) must be from %4 to %5 %6, not %3</source>
        <translation>%1 (%2) debe estar entre %4 y %5 %6, no %3</translation>
    </message>
    <message>
        <source>the %1 (%2) must be a whole number, not %3</source>
        <translation>%1 (%2) debe ser un número entero, no %3</translation>
    </message>
    <message>
        <source>there is no size &quot;%1&quot;; there are %2</source>
        <translation>no hay ninguna medida «%1»; hay %2</translation>
    </message>
    <message>
        <source>the thickness of the enamel layer (enamel_mm) is more than the block&apos;s height (height_mm)</source>
        <translation>la capa de esmalte (enamel_mm) es más gruesa que la altura del bloque (height_mm)</translation>
    </message>
    <message>
        <source>the block&apos;s side or height (side_mm, height_mm) is too small for three pads: they take %1 and %2 mm</source>
        <translation>el lado o la altura del bloque (side_mm, height_mm) no basta para tres campos: necesitan %1 y %2 mm</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) leaves less than %1 mm of the block around it</source>
        <translation>la longitud de la forma (length_mm) deja menos de %1 mm de bloque alrededor</translation>
    </message>
    <message>
        <source>the depth of the channel (depth_mm) leaves less than %1 mm of the block below it</source>
        <translation>la profundidad del canal (depth_mm) deja menos de %1 mm de bloque debajo</translation>
    </message>
    <message>
        <source>the radius of inner corners (corner_radius_mm) is more than half of the width of the channel (width_mm)</source>
        <translation>el radio de los ángulos internos (corner_radius_mm) es mayor que la mitad de la anchura del canal (width_mm)</translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the radius of inner corners (corner_radius_mm): no bur leaves that</source>
        <translation>el radio entre piso y pared (line_angle_mm) es mayor que el radio de los ángulos internos (corner_radius_mm): ninguna fresa deja eso</translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the depth (depth_mm)</source>
        <translation>el radio entre piso y pared (line_angle_mm) es mayor que la profundidad (depth_mm)</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) must be at least %1 mm with a channel of that width (width_mm)</source>
        <translation>con un canal de esa anchura (width_mm), la forma (length_mm) debe medir al menos %1 mm</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) is less than the width of the channel (width_mm)</source>
        <translation>la forma (length_mm) es más corta que la anchura del canal (width_mm)</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) leaves each of its steps shorter than the channel is wide (width_mm)</source>
        <translation>con esa longitud de la forma (length_mm), cada escalón es más corto que la anchura del canal (width_mm)</translation>
    </message>
    <message>
        <source>there is no practice block &apos;%1&apos;; choose one of %2</source>
        <translation>no hay ningún bloque de práctica «%1»; elija uno de %2</translation>
    </message>
    <message>
        <source>there is no preparation &apos;%1&apos;; choose one of %2</source>
        <translation>no hay ninguna preparación «%1»; elija una de %2</translation>
    </message>
    <message>
        <source>the preparation &apos;%1&apos; is not made for tooth %2; it is for %3</source>
        <translation>la preparación «%1» no se hace en el diente %2; es para %3</translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the radius of the bur (bur_radius_mm): no bur leaves that</source>
        <translation>el radio entre piso y pared (line_angle_mm) es mayor que el radio de la fresa (bur_radius_mm): ninguna fresa deja eso</translation>
    </message>
    <message>
        <source>the width of the isthmus (isthmus_mm) is less than the bur is wide (twice bur_radius_mm)</source>
        <translation>el istmo (isthmus_mm) es más estrecho que la fresa (dos veces bur_radius_mm)</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make its depth (depth_mm) less</source>
        <translation>esta preparación abriría la pulpa; reduzca la profundidad (depth_mm)</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make its depth (depth_mm) or that of the box (box_floor_mm, box_axial_mm) less</source>
        <translation>esta preparación abriría la pulpa; reduzca la profundidad (depth_mm) o la del cajón (box_floor_mm, box_axial_mm)</translation>
    </message>
    <message>
        <source>nobody knows where the fissures of &apos;%1&apos; run or which side is mesial; choose a tooth by its FDI number, or take an ideal from attempts at this one</source>
        <translation>nadie sabe por dónde van las fisuras de «%1» ni qué lado es mesial; elija un diente por su número FDI o tome un ideal de intentos en este</translation>
    </message>
    <message>
        <source>there is no room for the %1 on this tooth; make one of these less: %2</source>
        <extracomment>%1: a part of a preparation, %2: keys of numbers</extracomment>
        <translation>en este diente no hay sitio (%1); reduzca uno de estos: %2</translation>
    </message>
    <message>
        <source>occlusal outline</source>
        <translation>contorno oclusal</translation>
    </message>
    <message>
        <source>central groove</source>
        <translation>surco central</translation>
    </message>
    <message>
        <source>mesial pit</source>
        <translation>fosita mesial</translation>
    </message>
    <message>
        <source>distal pit</source>
        <translation>fosita distal</translation>
    </message>
    <message>
        <source>pits</source>
        <translation>fositas</translation>
    </message>
    <message>
        <source>none: the tooth has no such groove</source>
        <translation>ninguno: el diente no tiene ese surco</translation>
    </message>
    <message>
        <source>tooth %1 has no pulp chamber that could be opened from above</source>
        <translation>el diente %1 no tiene una cámara pulpar que se pueda abrir desde arriba</translation>
    </message>
    <message>
        <source>The captured ideal is damaged. Use a copy of the file, or capture it again.</source>
        <translation>El ideal capturado está dañado. Use una copia del archivo o captúrelo de nuevo.</translation>
    </message>
    <message>
        <source>The ideal was captured on the tooth &apos;%1&apos; (seed %2, grid %3) and does not fit &apos;%4&apos; (seed %5, grid %6); name that tooth, seed and grid, or capture it on this one.</source>
        <translation>El ideal se capturó en el diente «%1» (seed %2, grid %3) y no encaja con «%4» (seed %5, grid %6); indique ese diente con su seed y grid, o captúrelo en este.</translation>
    </message>
    <message>
        <source>The captured ideal is empty; choose another file.</source>
        <translation>El ideal capturado está vacío; elija otro archivo.</translation>
    </message>
    <message>
        <source>This is not a captured ideal; choose a file that Cusp has saved as one (*.cuspideal).</source>
        <translation>Esto no es un ideal capturado; elija un archivo que Cusp haya guardado como tal (*.cuspideal).</translation>
    </message>
    <message>
        <source>The captured ideal is of version %1, this Cusp reads up to version %2; open it with a newer Cusp.</source>
        <translation>El ideal capturado es de la versión %1 y este Cusp lee hasta la versión %2; ábralo con un Cusp más nuevo.</translation>
    </message>
    <message>
        <source>The captured ideal ends early: it was cut off while being written or copied. Use a whole copy.</source>
        <translation>El ideal capturado termina antes de tiempo: se cortó al escribirlo o copiarlo. Use una copia completa.</translation>
    </message>
    <message>
        <source>The firmware file is empty; choose another file.</source>
        <translation>El archivo de firmware está vacío; elija otro archivo.</translation>
    </message>
    <message>
        <source>The file is larger than %1 KiB and cannot be firmware for the Falcon; choose another file.</source>
        <translation>El archivo ocupa más de %1 KiB y no puede ser firmware para el Falcon; elija otro archivo.</translation>
    </message>
    <message>
        <source>This is not firmware for the Falcon; choose another file.</source>
        <translation>Esto no es firmware para el Falcon; elija otro archivo.</translation>
    </message>
    <message>
        <source>The firmware file is too short: it has %1 bytes, and its header alone has %2. Use a complete copy.</source>
        <translation>El archivo de firmware es demasiado corto: tiene %1 bytes y solo su cabecera ya tiene %2. Use una copia completa.</translation>
    </message>
    <message>
        <source>The firmware file ends before its block %1 is complete. Use a complete copy.</source>
        <translation>El archivo de firmware termina antes de que su bloque %1 esté completo. Use una copia completa.</translation>
    </message>
    <message>
        <source>The firmware ends after %1 bytes, but the file has %2. Use an unchanged copy.</source>
        <translation>El firmware termina tras %1 bytes, pero el archivo tiene %2. Use una copia sin cambios.</translation>
    </message>
    <message>
        <source>There is no handpiece &apos;%1&apos;; choose one of %2.</source>
        <translation>No hay ninguna pieza de mano «%1»; elija una de %2.</translation>
    </message>
    <message>
        <source>There is no bur &apos;%1&apos;; choose one of %2.</source>
        <translation>No hay ninguna fresa «%1»; elija una de %2.</translation>
    </message>
    <message>
        <source>There is no hardness preset &apos;%1&apos;; choose natural or typodont, or name a file.</source>
        <translation>No hay ningún ajuste de dureza «%1»; elija natural o typodont, o indique un archivo.</translation>
    </message>
    <message>
        <source>the force limit is %1 N, and the device gives at most %2 N; lower it</source>
        <translation>el límite de fuerza es %1 N y el dispositivo da como mucho %2 N; redúzcalo</translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm with this damping; lower the stiffness, or damp more</source>
        <translation>la rigidez es %1 N/mm y, con %2 ms de retardo y este amortiguamiento, una mano ligera solo se mantiene firme hasta %3 N/mm; reduzca la rigidez o amortigüe más</translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm however it is damped; lower the stiffness</source>
        <translation>la rigidez es %1 N/mm y, con %2 ms de retardo, una mano ligera solo se mantiene firme hasta %3 N/mm, se amortigüe como se amortigüe; reduzca la rigidez</translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm before it buzzes; lower the stiffness</source>
        <translation>la rigidez es %1 N/mm y, con %2 ms de retardo, una mano ligera solo se mantiene firme hasta %3 N/mm, y luego zumba; reduzca la rigidez</translation>
    </message>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
    <message>
        <source>percent</source>
        <translation>por ciento</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>grados</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>minutos</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1: the name of a file; %2: what is wrong with it: &quot;is empty&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>says nothing of %1: that is as shipped</source>
        <translation>no dice nada de %1: eso queda como viene con Cusp</translation>
    </message>
    <message>
        <source>%1 has the last version that there can be, %2; keep this under another name</source>
        <translation>%1 tiene la última versión posible, %2; guárdelo con otro nombre</translation>
    </message>
    <message>
        <source>The USB of this computer cannot be used (%1). The mouse works without it.</source>
        <translation>No se puede usar el USB de este ordenador (%1). El ratón funciona sin él.</translation>
    </message>
    <message>
        <source>You have no permission to use the Falcon. Install the rule that %1 prints, then unplug the Falcon and plug it in again.</source>
        <translation>No tiene permiso para usar el Falcon. Instale la regla que imprime %1 y desconecte y vuelva a conectar el Falcon.</translation>
    </message>
    <message>
        <source>Another program uses the Falcon. Close that program.</source>
        <translation>Otro programa usa el Falcon. Cierre ese programa.</translation>
    </message>
    <message>
        <source>Another driver of the system holds the Falcon. Give it the driver WinUSB.</source>
        <translation>Otro controlador del sistema ocupa el Falcon. Asígnele el controlador WinUSB.</translation>
    </message>
    <message>
        <source>The USB connection to the Falcon failed (%1). Unplug the Falcon and plug it in again.</source>
        <translation>La conexión USB con el Falcon ha fallado (%1). Desconecte y vuelva a conectar el Falcon.</translation>
    </message>
    <message>
        <source>No Falcon is plugged in.</source>
        <translation>No hay ningún Falcon conectado.</translation>
    </message>
    <message>
        <source>The Falcon does not answer. Check that its mains adapter is plugged in, then unplug its USB cable and plug it in again.</source>
        <translation>El Falcon no responde. Compruebe que su adaptador de corriente está conectado y desconecte y vuelva a conectar su cable USB.</translation>
    </message>
    <message>
        <source>The Falcon was unplugged while its firmware was loaded.</source>
        <translation>El Falcon se desconectó mientras se cargaba su firmware.</translation>
    </message>
    <message>
        <source>The Falcon received byte %1 of the firmware wrongly. Try another USB port, without a hub.</source>
        <translation>El Falcon recibió mal el byte %1 del firmware. Pruebe otro puerto USB, sin concentrador.</translation>
    </message>
    <message>
        <source>Loading the firmware was stopped.</source>
        <translation>Se detuvo la carga del firmware.</translation>
    </message>
    <message>
        <source>The firmware file cannot be read; choose it again.</source>
        <translation>No se puede leer el archivo de firmware; elíjalo de nuevo.</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware, which cannot be shipped with Cusp. Choose the firmware file of your Falcon&apos;s software.</source>
        <translation>El Falcon necesita su firmware, que no se puede distribuir con Cusp. Elija el archivo de firmware del software de su Falcon.</translation>
    </message>
    <message>
        <source>The firmware was loaded, but does not answer. Try another firmware file.</source>
        <translation>El firmware se cargó, pero no responde. Pruebe otro archivo de firmware.</translation>
    </message>
    <message>
        <source>This program was built without libusb: force devices are left out.</source>
        <translation>Este programa se compiló sin libusb: los dispositivos de fuerza no están incluidos.</translation>
    </message>
    <message>
        <source>No Falcon with the serial number %1 is plugged in.</source>
        <translation>No hay ningún Falcon con el número de serie %1 conectado.</translation>
    </message>
    <message>
        <source>Cusp cannot read pictures: its file %1 or a library of OpenCV is missing. Install Cusp again. The mouse works without it.</source>
        <translation>Cusp no puede leer imágenes: falta su archivo %1 o una biblioteca de OpenCV. Instale Cusp de nuevo. El ratón funciona sin ellos.</translation>
    </message>
    <message>
        <source>There is no camera %1. Plug in a camera, or choose another one.</source>
        <translation>No hay ninguna cámara %1. Conecte una cámara o elija otra.</translation>
    </message>
    <message>
        <source>You have no permission to use camera %1. An administrator of this computer can add you to the group &quot;video&quot;.</source>
        <translation>No tiene permiso para usar la cámara %1. Un administrador de este equipo puede añadirle al grupo «video».</translation>
    </message>
    <message>
        <source>Camera %1 gives no pictures. Close other programs that use it, or choose another one.</source>
        <translation>La cámara %1 no da imágenes. Cierre otros programas que la usen o elija otra.</translation>
    </message>
    <message>
        <source>Camera %1 gives no more pictures. Check that it is plugged in.</source>
        <translation>La cámara %1 ya no da imágenes. Compruebe que esté conectada.</translation>
    </message>
    <message>
        <source>There is no file %1.</source>
        <translation>No existe el archivo %1.</translation>
    </message>
    <message>
        <source>The file %1 cannot be read.</source>
        <translation>No se puede leer el archivo %1.</translation>
    </message>
    <message>
        <source>%1 is no video, or of a kind that cannot be read here.</source>
        <translation>%1 no es un vídeo, o es de un tipo que no se puede leer aquí.</translation>
    </message>
    <message>
        <source>The calibration is for pictures of %1 x %2 pixels, and these have %3 x %4. Calibrate the camera at this size.</source>
        <translation>La calibración es para imágenes de %1 x %2 píxeles, y estas tienen %3 x %4. Calibre la cámara con este tamaño.</translation>
    </message>
    <message>
        <source>The file %1 is too large for a calibration.</source>
        <translation>El archivo %1 es demasiado grande para una calibración.</translation>
    </message>
    <message>
        <source>%1 is no calibration of a camera.</source>
        <translation>%1 no es una calibración de una cámara.</translation>
    </message>
    <message>
        <source>%1: a value is missing or is not a number.</source>
        <translation>%1: falta un valor o no es un número.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The size of the pictures must be 1 to 16384 pixels a side.</source>
        <translation>Las imágenes deben tener de 1 a 16384 píxeles por lado.</translation>
    </message>
    <message>
        <source>The optical centre of a camera must lie within its pictures.</source>
        <translation>El centro óptico de una cámara debe estar dentro de sus imágenes.</translation>
    </message>
    <message>
        <source>The coefficients of a lens must lie between -5 and 5.</source>
        <translation>Los coeficientes de un objetivo deben estar entre -5 y 5.</translation>
    </message>
    <message>
        <source>The focal length of a camera must be 0.1 to 20 times the width of its pictures.</source>
        <translation>La distancia focal de una cámara debe ser de 0,1 a 20 veces la anchura de sus imágenes.</translation>
    </message>
    <message>
        <source>This program was built without SDL 2: pedals and gamepads are left out.</source>
        <translation>Este programa se compiló sin SDL 2: faltan los pedales y los mandos.</translation>
    </message>
    <message>
        <source>Pedals and gamepads cannot be read (%1). The mouse and the keyboard work without them.</source>
        <translation>No se pueden leer pedales ni mandos (%1). El ratón y el teclado funcionan sin ellos.</translation>
    </message>
    <message>
        <source>must lie between 0.1 and 100 points, at a criterion without weight</source>
        <translation>debe estar entre 0,1 y 100 puntos, en un criterio sin peso</translation>
    </message>
    <message>
        <source>a critical criterion has none; it limits the points of the whole attempt</source>
        <translation>un criterio crítico no tiene; limita los puntos de todo el intento</translation>
    </message>
    <message>
        <source>a critical criterion leaves no points; give one of the two</source>
        <translation>un criterio crítico no deja puntos; indique solo uno de los dos</translation>
    </message>
    <message>
        <source>must be at least 0.1 points; an error that leaves none is &quot;critical&quot;</source>
        <translation>debe ser de al menos 0,1 puntos; un error que no deja ninguno es &quot;critical&quot;</translation>
    </message>
    <message>
        <source>is how far the tooth lies on a side; say which in &quot;lies&quot;</source>
        <translation>indica cuánto se inclina el diente hacia un lado; diga cuál en «lies»</translation>
    </message>
    <message>
        <source>a tooth that lies on a side has no neighbours; write false</source>
        <translation>un diente tumbado no tiene vecinos; escriba false</translation>
    </message>
    <message>
        <source>is about a tooth that stands upright</source>
        <translation>se refiere a un diente en posición vertical</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no side of a tooth; write occlusal, mesial, distal, buccal or lingual</source>
        <translation>«%1» no es una cara de un diente; escriba occlusal, mesial, distal, buccal o lingual</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no side of a scan; write occlusal, -x, +x, -y or +y</source>
        <translation>«%1» no es una cara de un escaneo; escriba occlusal, -x, +x, -y o +y</translation>
    </message>
    <message>
        <source>a tooth is tilted by %1 to %2 degrees, not by %3</source>
        <translation>un diente se inclina de %1 a %2 grados, no %3</translation>
    </message>
    <message>
        <source>a bur reaches no fissure of a tooth that is tilted by more than %1 degrees</source>
        <translation>en un diente inclinado más de %1 grados la fresa no alcanza ninguna fisura</translation>
    </message>
    <message>
        <source>decay below a contact is on the mesial or distal side; let the tooth lie that way</source>
        <translation>la caries bajo un contacto está en la cara mesial o distal; coloque el diente de ese lado</translation>
    </message>
    <message>
        <source>decay at the neck or in a pit of a side is on the buccal or lingual side; let the tooth lie that way</source>
        <translation>la caries del cuello o de una fosita lateral está en la cara bucal o lingual; coloque el diente de ese lado</translation>
    </message>
    <message>
        <source>there is no pit on the side that tooth &apos;%1&apos; shows</source>
        <translation>la cara que muestra el diente %1 no tiene ninguna fosita</translation>
    </message>
    <message>
        <source>this preparation is made for a tooth that stands upright; leave out &quot;lies&quot;, or take an ideal from attempts at this tooth</source>
        <translation>esta preparación se hace para un diente en posición vertical; quite «lies», o tome un ideal de intentos en este diente</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make the depth of the box (box_floor_mm, box_axial_mm) less</source>
        <translation>esta preparación abriría la pulpa; reduzca la profundidad del cajón (box_floor_mm, box_axial_mm)</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) leaves less than %1 mm of the block between its pits (width_mm, steps)</source>
        <translation>la longitud de la forma (length_mm) deja menos de %1 mm del bloque entre sus pozos (width_mm, steps)</translation>
    </message>
    <message>
        <source>the enamel is thinner where it is thickest (depth_mm) than where it is thinnest (enamel_mm)</source>
        <translation>el esmalte es más fino donde es más grueso (depth_mm) que donde es más fino (enamel_mm)</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make the reduction (reduction_mm, functional_mm) less</source>
        <translation>esta preparación abriría la pulpa; disminuya la reducción (reduction_mm, functional_mm)</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>width of the isthmus</source>
        <translation>anchura del istmo</translation>
    </message>
    <message>
        <source>depth of the pulpal floor</source>
        <translation>profundidad del piso pulpar</translation>
    </message>
    <message>
        <source>width of the dovetail</source>
        <translation>anchura de la cola de milano</translation>
    </message>
    <message>
        <source>extension into the grooves</source>
        <translation>extensión a los surcos</translation>
    </message>
    <message>
        <source>marginal ridge that is left</source>
        <translation>cresta marginal que queda</translation>
    </message>
    <message>
        <source>ridge across the tooth that is left on each side</source>
        <translation>cresta transversal que queda a cada lado</translation>
    </message>
    <message>
        <source>divergence of the end walls</source>
        <translation>divergencia de las paredes extremas</translation>
    </message>
    <message>
        <source>radius of the bur</source>
        <translation>radio de la fresa</translation>
    </message>
    <message>
        <source>radius between floor and wall</source>
        <translation>radio entre piso y pared</translation>
    </message>
    <message>
        <source>floor along the junction</source>
        <translation>piso a lo largo de la unión amelodentinaria</translation>
    </message>
    <message>
        <source>depth of the floor in dentin</source>
        <translation>profundidad del piso en dentina</translation>
    </message>
    <message>
        <source>depth of the gingival floor</source>
        <translation>profundidad del piso gingival</translation>
    </message>
    <message>
        <source>depth of the axial wall</source>
        <translation>profundidad de la pared axial</translation>
    </message>
    <message>
        <source>width of the box</source>
        <translation>anchura del cajón</translation>
    </message>
    <message>
        <source>lean of the access walls</source>
        <translation>inclinación de las paredes del acceso</translation>
    </message>
    <message>
        <source>margin around the chamber</source>
        <translation>margen alrededor de la cámara</translation>
    </message>
    <message>
        <source>block&apos;s side</source>
        <translation>lado del bloque</translation>
    </message>
    <message>
        <source>block&apos;s height</source>
        <translation>altura del bloque</translation>
    </message>
    <message>
        <source>thickness of the enamel layer</source>
        <translation>grosor de la capa de esmalte</translation>
    </message>
    <message>
        <source>width of the channel</source>
        <translation>anchura del canal</translation>
    </message>
    <message>
        <source>depth of the channel</source>
        <translation>profundidad del canal</translation>
    </message>
    <message>
        <source>length of the shape</source>
        <translation>longitud de la forma</translation>
    </message>
    <message>
        <source>flare of the dovetail</source>
        <translation>apertura de la cola de milano</translation>
    </message>
    <message>
        <source>number of steps</source>
        <translation>número de escalones</translation>
    </message>
    <message>
        <source>radius of inner corners</source>
        <translation>radio de los ángulos internos</translation>
    </message>
    <message>
        <source>occlusal reduction</source>
        <translation>reducción oclusal</translation>
    </message>
    <message>
        <source>reduction of the functional cusps</source>
        <translation>reducción de las cúspides funcionales</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>version %1 of the lesson %2 was changed or is damaged; assign the lesson again</source>
        <translation>la versión %1 de la lección %2 se cambió o está dañada; vuelva a asignar la lección</translation>
    </message>
    <message>
        <source>row %1 of the audit was not written by Cusp: the role of person:%2 did not permit %3 on %4 then</source>
        <translation>la fila %1 del registro no la escribió Cusp: el rol que person:%2 tenía entonces no permitía %3 en %4</translation>
    </message>
    <message>
        <source>row %1 of the audit (%2): a computer had seen later rows of it. If nobody restored a backup without Cusp then, somebody put an older copy in the place of the database</source>
        <translation>fila %1 del registro (%2): un equipo había visto filas posteriores. Si entonces nadie restauró una copia de seguridad sin Cusp, alguien puso una copia más antigua en lugar de la base de datos</translation>
    </message>
    <message>
        <source>%1 attempts do not match their recordings and do not count; the pages of the classes mark them</source>
        <translation>%1 intentos no coinciden con sus grabaciones y no cuentan; las páginas de las clases los señalan</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no audit code; a report shows one such as 412-9f3ac07be1d2</source>
        <translation>«%1» no es un código de auditoría; un informe muestra uno como 412-9f3ac07be1d2</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) tells that the rows before it did not end as they had been signed</source>
        <translation>la fila %1 del registro (%2, %3, %4) dice que las filas anteriores no terminaban como se habían firmado</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) is not the one that was signed: it was changed, or the signature was put there from elsewhere</source>
        <translation>la fila %1 del registro (%2, %3, %4) no es la que se firmó: fue alterada, o la firma procede de otro lugar</translation>
    </message>
    <message>
        <source>the signature of the newest row of the audit was not made by the station whose key stands beside it</source>
        <translation>la firma de la última fila del registro no es del puesto cuya clave figura al lado</translation>
    </message>
    <message>
        <source>audit row %1 was removed</source>
        <translation>la fila %1 del registro fue eliminada</translation>
    </message>
    <message>
        <source>no signature covers audit row %1: it was inserted, or the signed head was set back, or the row behind it was changed</source>
        <translation>ninguna firma cubre la fila %1 del registro: fue insertada, o se volvió a una cabecera firmada anterior, o la fila siguiente fue alterada</translation>
    </message>
    <message>
        <source>the signed head of the audit was removed</source>
        <translation>la cabecera firmada del registro fue eliminada</translation>
    </message>
    <message>
        <source>the file is damaged: %1</source>
        <translation>el archivo está dañado: %1</translation>
    </message>
    <message>
        <source>row %1 of the table %2 belongs to no row of %3</source>
        <translation>la fila %1 de la tabla %2 no corresponde a ninguna fila de %3</translation>
    </message>
    <message>
        <source>%1 (%2, %3) was changed after it had been kept</source>
        <translation>%1 (%2, %3): fue alterado después de guardarse</translation>
    </message>
    <message>
        <source>%1 was removed; row %2 of the audit tells of it</source>
        <translation>%1: fue eliminado; la fila %2 del registro da cuenta de ello</translation>
    </message>
    <message>
        <source>%1 has no score sheet</source>
        <translation>%1: no tiene hoja de puntuación</translation>
    </message>
    <message>
        <source>%1 has a standing in %2 that the attempts do not add up to</source>
        <translation>%1 tiene en %2 un resultado que los intentos no justifican</translation>
    </message>
    <message>
        <source>%1 has attempts in %2 and no standing</source>
        <translation>%1 tiene intentos en %2, pero ningún resultado</translation>
    </message>
    <message>
        <source>the recording %1 is not there any more; bring the folder &quot;recordings&quot; back from a backup</source>
        <translation>la grabación %1 ya no está; recupere la carpeta «recordings» de una copia de seguridad</translation>
    </message>
    <message>
        <source>the recording %1 was changed or is damaged; bring it back from a backup</source>
        <translation>la grabación %1 fue alterada o está dañada; recupérela de una copia de seguridad</translation>
    </message>
    <message>
        <source>the head of the audit was signed with the key %1, which is not this computer&apos;s; if the file was not written by Cusp on another computer, somebody has rewritten it</source>
        <translation>la cabecera del registro se firmó con la clave %1, que no es la de este ordenador; si el archivo no lo escribió Cusp en otro ordenador, alguien lo ha reescrito</translation>
    </message>
    <message>
        <source>%1 is no longer there: what it guarded is not guarded any more</source>
        <translation>%1 ya no está: lo que protegía ya no está protegido</translation>
    </message>
    <message>
        <source>the newest row of the audit was signed with the key %1, and the audit knows no station that has it</source>
        <translation>la última fila del registro se firmó con la clave %1, y el registro no conoce ningún puesto que la tenga</translation>
    </message>
    <message>
        <source>audit row %1, which a report names, is not there: it was removed, or the code is not typed as it stands there</source>
        <translation>la fila %1 del registro, que nombra un informe, no está: se eliminó, o el código no se escribió como figura allí</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) is not the one that a report names: it or one before it was changed, or the code is not typed as it stands there</source>
        <translation>la fila %1 del registro (%2, %3, %4) no es la que nombra un informe: ella o una anterior fue modificada, o el código no se escribió como figura allí</translation>
    </message>
    <message>
        <source>%1 (%2, %3) is not noted in the audit: it was inserted, or the note of it is among the rows of the audit that were removed or changed</source>
        <translation>%1 (%2, %3): no consta en el registro; fue insertado, o su anotación está entre las filas del registro que fueron eliminadas o modificadas</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) does not follow from the row before it: one of the two was changed, inserted or moved</source>
        <translation>la fila %1 del registro (%2, %3, %4) no sigue a la anterior: una de las dos fue cambiada, insertada o movida</translation>
    </message>
    <message>
        <source>the audit itself was changed: rows that differ from it may be right all the same</source>
        <translation>el propio registro fue cambiado: las filas que difieren de él pueden ser correctas a pesar de todo</translation>
    </message>
    <message>
        <source>the check could not go on: %1</source>
        <translation>la comprobación no pudo continuar: %1</translation>
    </message>
    <message>
        <source>%1 differs from the audit: the row of %2 was changed, added or removed</source>
        <translation>%1 difiere del registro: la fila de %2 fue cambiada, añadida o eliminada</translation>
    </message>
</context>
<context>
    <name>Handpiece</name>
    <message>
        <source>Turbine</source>
        <translation>Turbina</translation>
    </message>
    <message>
        <source>Electric</source>
        <extracomment>A red-ring contra-angle: electric motor, geared up</extracomment>
        <translation>Eléctrica</translation>
    </message>
    <message>
        <source>Low-speed</source>
        <translation>Lenta</translation>
    </message>
</context>
<context>
    <name>Health</name>
    <message>
        <source>The handpiece is disconnected: no force. Plug it in again.</source>
        <translation>La pieza de mano está desconectada: sin fuerza. Vuelva a conectarla.</translation>
    </message>
    <message>
        <source>The computer was too slow: the recording has a gap.</source>
        <translation>El ordenador fue demasiado lento: la grabación tiene un hueco.</translation>
    </message>
    <message>
        <source>The computer is slow: the picture lags behind.</source>
        <translation>El ordenador es lento: la imagen va con retraso.</translation>
    </message>
    <message>
        <source>Force at its limit</source>
        <translation>Fuerza en su límite</translation>
    </message>
    <message>
        <source>The bur is inside the tooth. Lift it out to continue.</source>
        <translation>La fresa está dentro del diente. Sáquela para continuar.</translation>
    </message>
    <message>
        <source>The handpiece responds late: the tooth feels softer.</source>
        <translation>La pieza de mano responde tarde: el diente se siente más blando.</translation>
    </message>
    <message>
        <source>The handpiece guides your hand back over the tooth. Push against it to stop.</source>
        <translation>La pieza de mano guía su mano de vuelta sobre el diente. Empuje en contra para detenerla.</translation>
    </message>
    <message>
        <source>The outline holds your hand. Press Q to release it.</source>
        <translation>El contorno retiene su mano. Pulse Q para soltarla.</translation>
    </message>
</context>
<context>
    <name>HistoryPanel</name>
    <message>
        <source>Intact tooth</source>
        <translation>Diente intacto</translation>
    </message>
    <message>
        <source>Tooth reset</source>
        <translation>Diente restablecido</translation>
    </message>
    <message>
        <source>%1 mm³ %2</source>
        <extracomment>What a stroke took off: so many cubic millimetres of a tissue</extracomment>
        <translation>%1 mm³ %2</translation>
    </message>
    <message>
        <source>present</source>
        <translation>ahora</translation>
    </message>
</context>
<context>
    <name>Landmark</name>
    <message>
        <source>central pit</source>
        <translation>fosa central</translation>
    </message>
    <message>
        <source>mesial pit</source>
        <translation>fosa mesial</translation>
    </message>
    <message>
        <source>distal pit</source>
        <translation>fosa distal</translation>
    </message>
    <message>
        <source>mesial marginal ridge</source>
        <translation>cresta marginal mesial</translation>
    </message>
    <message>
        <source>distal marginal ridge</source>
        <translation>cresta marginal distal</translation>
    </message>
</context>
<context>
    <name>Lesson</name>
    <message>
        <source>Practice block</source>
        <translation>Bloque de práctica</translation>
    </message>
    <message>
        <source>Exams</source>
        <translation>Exámenes</translation>
    </message>
    <message>
        <source>Ideal preparations</source>
        <translation>Preparaciones ideales</translation>
    </message>
    <message>
        <source>Removing decay</source>
        <translation>Eliminación de caries</translation>
    </message>
    <message>
        <source>any</source>
        <translation>cualquiera</translation>
    </message>
    <message>
        <source>section</source>
        <translation>corte</translation>
    </message>
    <message>
        <source>depth gauge</source>
        <translation>medidor de profundidad</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>radiografía</translation>
    </message>
    <message>
        <source>depth colours</source>
        <translation>colores de profundidad</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>espejo</translation>
    </message>
    <message>
        <source>ideal preparation</source>
        <translation>preparación ideal</translation>
    </message>
    <message>
        <source>all</source>
        <translation>todas</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sin límite</translation>
    </message>
    <message>
        <source>%1: %2 points</source>
        <translation>%1: %2 puntos</translation>
    </message>
    <message>
        <source>bur that changes colour</source>
        <translation>fresa que cambia de color</translation>
    </message>
    <message>
        <source>guided hand</source>
        <translation>mano guiada</translation>
    </message>
    <message>
        <source>depth stop</source>
        <translation>tope de profundidad</translation>
    </message>
    <message>
        <source>%1 ± %2 costs nothing</source>
        <extracomment>%1: a target; %2: how far off it one may be at no cost</extracomment>
        <translation>%1 ± %2 no cuesta nada</translation>
    </message>
    <message>
        <source>%1 or more costs nothing</source>
        <translation>%1 o más no cuesta nada</translation>
    </message>
    <message>
        <source>Up to %1 costs nothing</source>
        <translation>Hasta %1 no cuesta nada</translation>
    </message>
    <message>
        <source> (more, where the decay is larger)</source>
        <translation> (más, donde la caries es mayor)</translation>
    </message>
    <message>
        <source>beyond it the attempt fails</source>
        <translation>más allá no se aprueba el intento</translation>
    </message>
    <message>
        <source>beyond it all %1 points are lost</source>
        <translation>más allá se pierden los %1 puntos</translation>
    </message>
    <message>
        <source>%1 off, all %2 points are lost</source>
        <translation>con %1 de desviación se pierden los %2 puntos</translation>
    </message>
    <message>
        <source>at %1 all %2 points are lost</source>
        <translation>en %1 se pierden los %2 puntos</translation>
    </message>
    <message>
        <source>from %1 on all %2 points are lost</source>
        <translation>desde %1 se pierden los %2 puntos</translation>
    </message>
    <message>
        <source>The first minutes</source>
        <translation>Los primeros minutos</translation>
    </message>
    <message>
        <source>outline %1 mm to either side</source>
        <translation>contorno %1 mm hacia cada lado</translation>
    </message>
    <message>
        <source>floor %1 mm up or down</source>
        <translation>piso %1 mm más alto o más bajo</translation>
    </message>
    <message>
        <source>walls %1°, that is %2 mm over 1.5 mm of depth</source>
        <translation>paredes %1°, es decir, %2 mm en 1,5 mm de profundidad</translation>
    </message>
    <message>
        <source>floor even to %1 mm</source>
        <translation>piso plano con %1 mm</translation>
    </message>
    <message>
        <source> as soon as %1</source>
        <extracomment>%1: what has to be done before points are earned: &quot;50 % of the decay is removed&quot;</extracomment>
        <translation> en cuanto %1</translation>
    </message>
    <message>
        <source>exam</source>
        <extracomment>On the card of a lesson</extracomment>
        <translation>examen</translation>
    </message>
    <message>
        <source>in progress</source>
        <extracomment>On the card of the lesson that is being worked on</extracomment>
        <translation>en curso</translation>
    </message>
    <message>
        <source>due since %1</source>
        <translation>venció a las %1</translation>
    </message>
    <message>
        <source>due today %1</source>
        <translation>vence hoy, %1</translation>
    </message>
    <message>
        <source>due tomorrow</source>
        <translation>vence mañana</translation>
    </message>
    <message>
        <source>due %1</source>
        <extracomment>%1: a day of the week, or a date</extracomment>
        <translation>vence: %1</translation>
    </message>
    <message>
        <source>You have no attempts left at this lesson. Your teacher can give you more.</source>
        <translation>No le quedan intentos en esta lección. Su docente puede darle más.</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n day(s) late</source>
        <extracomment>%1: the day it was due, &quot;17 Nov&quot;</extracomment>
        <translation>
            <numerusform>%1, %n día de retraso</numerusform>
            <numerusform>%1, %n días de retraso</numerusform>
        </translation>
    </message>
    <message>
        <source>no attempts left</source>
        <extracomment>On the card of a lesson</extracomment>
        <translation>sin más intentos</translation>
    </message>
    <message>
        <source>Your last attempt at this exam was started in another window. The work in this window does not count.</source>
        <translation>Su último intento en este examen se empezó en otra ventana. El trabajo de esta ventana no cuenta.</translation>
    </message>
    <message>
        <source>In an exam, the expert&apos;s attempt is not shown.</source>
        <translation>En un examen no se muestra el intento del experto.</translation>
    </message>
    <message>
        <source>Only lessons have an expert&apos;s attempt. Press F2 to choose one.</source>
        <translation>Solo las lecciones tienen un intento del experto. Pulse F2 para elegir una.</translation>
    </message>
    <message>
        <source>This exercise has no expert&apos;s attempt.</source>
        <translation>Este ejercicio no tiene un intento del experto.</translation>
    </message>
    <message>
        <source>beyond it the score is limited to %1 points</source>
        <extracomment>%1: points of a score</extracomment>
        <translation>más allá, la puntuación se limita a %1 puntos</translation>
    </message>
    <message>
        <source>At most %1 points: %2</source>
        <extracomment>%1: points of a score; %2: serious errors, with semicolons between</extracomment>
        <translation>Como máximo %1 puntos: %2</translation>
    </message>
    <message>
        <source>Fails the attempt: %1</source>
        <extracomment>%1: serious errors, with semicolons between</extracomment>
        <translation>Suspende el intento: %1</translation>
    </message>
    <message>
        <source>mesial side towards the bur</source>
        <translation>cara mesial hacia la fresa</translation>
    </message>
    <message>
        <source>distal side towards the bur</source>
        <translation>cara distal hacia la fresa</translation>
    </message>
    <message>
        <source>buccal side towards the bur</source>
        <translation>cara vestibular hacia la fresa</translation>
    </message>
    <message>
        <source>lingual side towards the bur</source>
        <translation>cara lingual hacia la fresa</translation>
    </message>
    <message>
        <source>%1 towards the bur</source>
        <extracomment>%1: a direction of a scan, such as &quot;+x&quot;</extracomment>
        <translation>%1 hacia la fresa</translation>
    </message>
</context>
<context>
    <name>Login</name>
    <message>
        <source>Wrong username or password. Try again, or ask an admin for a one-time code.</source>
        <translation>El nombre de usuario o la contraseña no son correctos. Inténtelo de nuevo o pida un código de un solo uso a un administrador.</translation>
    </message>
    <message numerus="yes">
        <source>Too many logins have failed. Wait %n second(s) and try again.</source>
        <translation>
            <numerusform>Ha fallado el inicio de sesión demasiadas veces. Espere %n segundo e inténtelo de nuevo.</numerusform>
            <numerusform>Ha fallado el inicio de sesión demasiadas veces. Espere %n segundos e inténtelo de nuevo.</numerusform>
        </translation>
    </message>
    <message>
        <source>A user was added here in the meantime. Log in as an admin.</source>
        <translation>Entretanto se ha añadido un usuario. Inicie sesión como administrador.</translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Try again, or practise without a login.</source>
        <translation>El servidor de la escuela no responde. Inténtelo de nuevo o practique sin iniciar sesión.</translation>
    </message>
    <message>
        <source>A password has at least eight characters, does not contain the username and is not a common one such as &quot;password1&quot;.</source>
        <translation>Una contraseña tiene al menos ocho caracteres, no contiene el nombre de usuario y no es una habitual como «password1».</translation>
    </message>
    <message>
        <source>Another program is writing to the school&apos;s database, so nobody can log in. Try again in a moment.</source>
        <translation>Otro programa está escribiendo en la base de datos de la escuela, así que nadie puede iniciar sesión. Inténtelo de nuevo en un momento.</translation>
    </message>
</context>
<context>
    <name>Material</name>
    <message>
        <source>decay</source>
        <translation>caries</translation>
    </message>
    <message>
        <source>enamel</source>
        <translation>esmalte</translation>
    </message>
    <message>
        <source>dentin</source>
        <translation>dentina</translation>
    </message>
    <message>
        <source>pulp</source>
        <translation>pulpa</translation>
    </message>
    <message>
        <source>C</source>
        <extracomment>One letter for decay (caries); must differ from those of enamel, dentin and pulp.</extracomment>
        <translation>C</translation>
    </message>
    <message>
        <source>E</source>
        <extracomment>One letter for enamel</extracomment>
        <translation>E</translation>
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
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Centro</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
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
        <translation>Tomado en milímetros, el escaneo mide %1 mm de largo, más que un diente.</translation>
    </message>
    <message>
        <source>The file names no unit. As centimetres it is %1 mm long, so centimetres were taken.</source>
        <translation>El archivo no indica unidad. En centímetros mide %1 mm de largo, así que se tomaron centímetros.</translation>
    </message>
    <message>
        <source>The file names no unit. As inches it is %1 mm long, so inches were taken.</source>
        <translation>El archivo no indica ninguna unidad. En pulgadas mide %1 mm de largo, por lo que se tomaron pulgadas.</translation>
    </message>
    <message>
        <source>The file names no unit. As metres it is %1 mm long, so metres were taken.</source>
        <translation>El archivo no indica unidad. En metros mide %1 mm de largo, así que se tomaron metros.</translation>
    </message>
    <message>
        <source>In no usual unit has the scan the size of a tooth, so it was made %1 mm long.</source>
        <translation>En ninguna unidad habitual tiene el escaneo el tamaño de un diente, así que se le dio una longitud de %1 mm.</translation>
    </message>
    <message>
        <source>The tooth lay askew in the file and was turned upright. If it is not upright now, export it with the crown along +z.</source>
        <translation>El diente estaba inclinado en el archivo y se ha enderezado. Si ahora no está derecho, expórtelo con la corona hacia +z.</translation>
    </message>
    <message>
        <source>The shape does not show where the crown is. If the tooth lies on its side, export it with the crown along +z.</source>
        <translation>La forma no muestra dónde está la corona. Si el diente está tumbado, expórtelo con la corona hacia +z.</translation>
    </message>
    <message>
        <source>The scan has openings; they were closed.</source>
        <translation>El escaneo tiene aberturas; se cerraron.</translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) without an area were left out.</source>
        <translation>
            <numerusform>Se omitió %n triángulo sin área.</numerusform>
            <numerusform>Se omitieron %n triángulos sin área.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) are there twice.</source>
        <translation>
            <numerusform>%n triángulo está dos veces.</numerusform>
            <numerusform>%n triángulos están dos veces.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n edge(s) more than two triangles meet.</source>
        <translation>
            <numerusform>En %n arista se juntan más de dos triángulos.</numerusform>
            <numerusform>En %n aristas se juntan más de dos triángulos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n edge(s) neighbouring triangles disagree which side is outside.</source>
        <translation>
            <numerusform>En %n arista los triángulos vecinos no coinciden en qué lado es el exterior.</numerusform>
            <numerusform>En %n aristas los triángulos vecinos no coinciden en qué lado es el exterior.</numerusform>
        </translation>
    </message>
    <message>
        <source>The scan was inside out and has been turned.</source>
        <translation>El escaneo estaba del revés y se le ha dado la vuelta.</translation>
    </message>
    <message numerus="yes">
        <source>The scan has %n separate part(s); the outermost surface counts.</source>
        <translation>
            <numerusform>El escaneo tiene %n parte; cuenta la superficie más externa.</numerusform>
            <numerusform>El escaneo tiene %n partes separadas; cuenta la superficie más externa.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Section</name>
    <message>
        <source>The plane does not meet the tooth here.</source>
        <translation>El plano no toca aquí el diente.</translation>
    </message>
    <message>
        <source>original surface</source>
        <extracomment>In the key of a picture, beside a line</extracomment>
        <translation>superficie original</translation>
    </message>
    <message>
        <source>ideal preparation</source>
        <translation>preparación ideal</translation>
    </message>
    <message>
        <source>within tolerance</source>
        <extracomment>In the key of a picture: what may be cut or left without losing points</extracomment>
        <translation>dentro de la tolerancia</translation>
    </message>
    <message>
        <source>costs points</source>
        <extracomment>In the key of a picture: farther out, all points of this criterion are lost</extracomment>
        <translation>cuesta puntos</translation>
    </message>
    <message>
        <source>soft decay</source>
        <translation>caries blanda</translation>
    </message>
    <message>
        <source>leathery decay</source>
        <translation>caries correosa</translation>
    </message>
    <message>
        <source>firm decay</source>
        <translation>caries firme</translation>
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
        <translation>V</translation>
    </message>
    <message>
        <source>B</source>
        <translation>V</translation>
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
        <translation>corte</translation>
    </message>
    <message>
        <source>depth gauge</source>
        <translation>medidor de profundidad</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>radiografía</translation>
    </message>
    <message>
        <source>depth colours</source>
        <translation>colores de profundidad</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>espejo</translation>
    </message>
    <message>
        <source>ideal</source>
        <translation>ideal</translation>
    </message>
    <message>
        <source>No aids in use</source>
        <translation>Ninguna ayuda en uso</translation>
    </message>
    <message>
        <source>Aids in use: %1</source>
        <translation>Ayudas en uso: %1</translation>
    </message>
    <message>
        <source>Undone</source>
        <translation>Deshecho</translation>
    </message>
    <message>
        <source>Redone</source>
        <translation>Rehecho</translation>
    </message>
    <message>
        <source>Tooth reset</source>
        <translation>Diente restablecido</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>Nota %1</translation>
    </message>
    <message>
        <source>The hand was guided back</source>
        <translation>Se llevó la mano de vuelta</translation>
    </message>
    <message>
        <source>Resumed</source>
        <translation>Reanudado</translation>
    </message>
    <message>
        <source>colour of the bur</source>
        <translation>color de la fresa</translation>
    </message>
    <message>
        <source>guided hand</source>
        <translation>mano guiada</translation>
    </message>
    <message>
        <source>%1 pad: answer %2</source>
        <extracomment>%1 is &quot;Left&quot;, &quot;Middle&quot; or &quot;Right&quot;, %2 a tissue</extracomment>
        <translation>%1: respuesta %2</translation>
    </message>
    <message>
        <source>Handpiece: %1</source>
        <translation>Pieza de mano: %1</translation>
    </message>
    <message>
        <source>Point %1 touched</source>
        <translation>Punto %1 tocado</translation>
    </message>
    <message>
        <source>Graded</source>
        <translation>Calificado</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 who remarked something on an attempt, %2 the words</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Bur: %1</source>
        <extracomment>%1: a bur such as &quot;Pear, No. 330&quot;</extracomment>
        <translation>Fresa: %1</translation>
    </message>
</context>
<context>
    <name>Tooth</name>
    <message>
        <source>upper right</source>
        <translation>superior derecho</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>superior izquierdo</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>inferior izquierdo</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>inferior derecho</translation>
    </message>
    <message>
        <source>%1 central incisor</source>
        <translation>incisivo central %1</translation>
    </message>
    <message>
        <source>%1 lateral incisor</source>
        <translation>incisivo lateral %1</translation>
    </message>
    <message>
        <source>%1 canine</source>
        <translation>canino %1</translation>
    </message>
    <message>
        <source>%1 first premolar</source>
        <translation>primer premolar %1</translation>
    </message>
    <message>
        <source>%1 second premolar</source>
        <translation>segundo premolar %1</translation>
    </message>
    <message>
        <source>%1 first molar</source>
        <translation>primer molar %1</translation>
    </message>
    <message>
        <source>%1 second molar</source>
        <translation>segundo molar %1</translation>
    </message>
    <message>
        <source>%1 third molar</source>
        <translation>tercer molar %1</translation>
    </message>
    <message>
        <source>Tooth %1</source>
        <translation>Diente %1</translation>
    </message>
    <message>
        <source>Tooth without a name</source>
        <translation>Diente sin nombre</translation>
    </message>
</context>
<context>
    <name>ViewMarks</name>
    <message>
        <source>depth, mm</source>
        <translation>profundidad, mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <extracomment>A length in millimetres</extracomment>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>as it should be</source>
        <translation>como debe ser</translation>
    </message>
    <message>
        <source>%1 too deep</source>
        <extracomment>%1 is a length: the tooth is cut deeper than it should be</extracomment>
        <translation>%1 de más</translation>
    </message>
    <message>
        <source>%1 to cut</source>
        <extracomment>%1 is a length: so much is still to be taken away</extracomment>
        <translation>faltan %1</translation>
    </message>
    <message>
        <source>deviation, mm</source>
        <extracomment>Titles of a scale of colours: how deep a cut is, and how far from the ideal</extracomment>
        <translation>desviación, mm</translation>
    </message>
</context>
<context>
    <name>app::AdminController</name>
    <message>
        <source>The person was erased. The attempts stay as %1.</source>
        <translation>La persona fue borrada. Los intentos se conservan como %1.</translation>
    </message>
    <message>
        <source>The person was erased, and the attempts stay as %1. Another program was using the database file, so unused parts of it may contain the names until another person is erased.</source>
        <translation>La persona fue borrada y los intentos se conservan como %1. Otro programa usaba el archivo de la base de datos, por lo que sus partes sin uso pueden contener los nombres hasta que se borre a otra persona.</translation>
    </message>
    <message>
        <source>%1 (not protected on the network: %2)</source>
        <translation>%1 (sin protección en la red: %2)</translation>
    </message>
    <message>
        <source>%1 was entered.</source>
        <translation>%1 se registró.</translation>
    </message>
    <message>
        <source>%1 was changed.</source>
        <translation>%1 se modificó.</translation>
    </message>
    <message>
        <source>%1 cannot be read, or is too large.</source>
        <translation>%1 no se puede leer o es demasiado grande.</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>Se detuvo.</translation>
    </message>
    <message>
        <source>The data are being backed up …</source>
        <translation>Se está haciendo la copia de seguridad …</translation>
    </message>
    <message>
        <source>Everything is looked at …</source>
        <translation>Se revisa todo …</translation>
    </message>
    <message>
        <source>Nothing is wrong: %1 attempts and %2 rows of the audit are as they were noted.</source>
        <translation>Todo está bien: %1 intentos y %2 filas del registro están como se anotaron.</translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) are not as they should be.</source>
        <translation>
            <numerusform>%n cosa no está como debería.</numerusform>
            <numerusform>%n cosas no están como deberían.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is empty. The first line of a class list names its columns: username, given_name, family_name, role, class.</source>
        <translation>%1 está vacío. La primera línea de una lista de clase nombra sus columnas: username, given_name, family_name, role, class.</translation>
    </message>
    <message numerus="yes">
        <source>A place that was left is locked after %n minute(s).</source>
        <translation>
            <numerusform>Un puesto abandonado se bloquea tras %n minuto.</numerusform>
            <numerusform>Un puesto abandonado se bloquea tras %n minutos.</numerusform>
        </translation>
    </message>
    <message>
        <source>The backup is looked at …</source>
        <translation>Se revisa la copia de seguridad …</translation>
    </message>
    <message>
        <source>%1 is no whole backup of a school, and was not restored. Choose another one.</source>
        <translation>%1 no es una copia completa de una escuela y no se restauró. Elija otra.</translation>
    </message>
    <message>
        <source>The class list is looked at …</source>
        <translation>Se revisa la lista de clase …</translation>
    </message>
    <message>
        <source>These people are being entered …</source>
        <translation>Se está registrando a estas personas …</translation>
    </message>
    <message>
        <source>No class can be called that. Its name has 1 to 100 characters that can be seen, without |, which parts classes in a class list, and no other class has it.</source>
        <translation>Ninguna clase puede llamarse así. Su nombre tiene de 1 a 100 caracteres visibles, sin |, que separa las clases en una lista de clase, y ninguna otra clase lo lleva.</translation>
    </message>
    <message>
        <source>%1 has more than %2 lines. Split it, and enter the parts one after another.</source>
        <translation>%1 tiene más de %2 líneas. Divídalo e introduzca las partes una tras otra.</translation>
    </message>
    <message>
        <source>The audit is still the one that the report with the code %1 names.</source>
        <translation>El registro sigue siendo el que nombra el informe con el código %1.</translation>
    </message>
    <message>
        <source>Backed up: %1. Its pages and keys are whole.</source>
        <translation>Copiado: %1. Sus páginas y claves están íntegras.</translation>
    </message>
    <message>
        <source>The school&apos;s file is in use: another window of Cusp, or another program, has it open, or a backup is being made. Close what has it open, and restore then.</source>
        <translation>El archivo de la escuela está en uso: otra ventana de Cusp u otro programa lo tiene abierto, o se está haciendo una copia de seguridad. Cierre lo que lo tiene abierto y restaure después.</translation>
    </message>
    <message>
        <source>The backup was not restored; nothing has been changed. %1</source>
        <translation>La copia de seguridad no se restauró; no se ha cambiado nada. %1</translation>
    </message>
    <message>
        <source>It is no backup of this school.</source>
        <translation>No es una copia de seguridad de esta escuela.</translation>
    </message>
    <message>
        <source>There is nothing to save: everything is as it was.</source>
        <translation>No hay nada que guardar: todo está como estaba.</translation>
    </message>
    <message>
        <source>Nothing was entered: somebody else has entered or changed people meanwhile. This is what the list would do now.</source>
        <translation>No se registró a nadie: otra persona ha registrado o modificado a alguien entretanto. Esto es lo que haría la lista ahora.</translation>
    </message>
    <message>
        <source>That cannot be: the username is empty or taken, or has other characters than the letters a to z, digits and . _ - @.</source>
        <translation>No es posible: el nombre de usuario está vacío u ocupado, o contiene otros caracteres que las letras de la a a la z, cifras y . _ - @.</translation>
    </message>
</context>
<context>
    <name>app::LessonsController</name>
    <message>
        <source>The pack was not unpacked, so its lesson cannot be changed. %1</source>
        <translation>El paquete no se desempaquetó, así que su lección no se puede cambiar. %1</translation>
    </message>
    <message>
        <source>No program answers here that shows folders. Your own lessons are in %1.</source>
        <translation>Aquí no responde ningún programa que muestre carpetas. Sus propias lecciones están en %1.</translation>
    </message>
</context>
<context>
    <name>app::OpenedScoreController</name>
    <message>
        <source>Preparing the score card …</source>
        <translation>Preparando la hoja de puntuación …</translation>
    </message>
    <message>
        <source>Earlier attempts are not available during an exam. Press G to finish the exam, or start another lesson.</source>
        <translation>Los intentos anteriores no están disponibles durante un examen. Pulse G para terminar el examen o empiece otra lección.</translation>
    </message>
</context>
<context>
    <name>app::AttemptController</name>
    <message>
        <source>Making tooth %1 …</source>
        <translation>Creando el diente %1 …</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Leyendo %1 …</translation>
    </message>
    <message>
        <source>Making a practice block …</source>
        <translation>Creando un bloque de práctica …</translation>
    </message>
    <message>
        <source>Preparing the lesson …</source>
        <translation>Preparando la lección …</translation>
    </message>
    <message>
        <source>The reference was saved as %1. A lesson names it, or choose it in the editor of a lesson on this tooth.</source>
        <translation>La referencia se guardó como %1. Una lección la nombra, o elíjala en el editor de una lección sobre este diente.</translation>
    </message>
</context>
<context>
    <name>app::ResumeController</name>
    <message>
        <source>Resuming the attempt …</source>
        <translation>Reanudando el intento …</translation>
    </message>
    <message>
        <source>Your attempt continues where you stopped. It was begun with the mouse: the device has no soft limit at the end of its reach in this attempt.</source>
        <translation>Su intento continúa donde lo dejó. Se empezó con el ratón: en este intento el dispositivo no tiene un límite suave al final de su alcance.</translation>
    </message>
    <message>
        <source>Your attempt continues where you stopped.</source>
        <translation>Su intento continúa donde lo dejó.</translation>
    </message>
    <message>
        <source>The attempt is no longer there.</source>
        <translation>El intento ya no está.</translation>
    </message>
</context>
<context>
    <name>app::GradingController</name>
    <message>
        <source>The tooth is not ready yet. Try again in a moment.</source>
        <translation>El diente aún no está listo. Inténtelo de nuevo en un momento.</translation>
    </message>
    <message>
        <source>Nothing has been cut yet, so there is nothing to grade.</source>
        <translation>Todavía no se ha tallado nada, así que no hay nada que calificar.</translation>
    </message>
    <message>
        <source>This exercise has not been started yet, so there is nothing to grade.</source>
        <translation>Este ejercicio aún no ha empezado, así que no hay nada que calificar.</translation>
    </message>
    <message>
        <source>No pad has an answer yet. Choose below the view what each pad is made of.</source>
        <translation>Ningún campo tiene respuesta todavía. Elija debajo de la vista de qué está hecho cada campo.</translation>
    </message>
    <message>
        <source>The grade that could not be saved is now saved.</source>
        <translation>La calificación que no se pudo guardar ya está guardada.</translation>
    </message>
</context>
<context>
    <name>app::PlaybackController</name>
    <message>
        <source>Reading %1 …</source>
        <translation>Leyendo %1 …</translation>
    </message>
    <message>
        <source>The tooth is intact. You can start drilling.</source>
        <translation>El diente está intacto. Puede empezar a tallar.</translation>
    </message>
    <message>
        <source>You are back in your own work.</source>
        <translation>Ha vuelto a su propio trabajo.</translation>
    </message>
    <message>
        <source>Preparing the lesson …</source>
        <translation>Preparando la lección …</translation>
    </message>
    <message>
        <source>The expert</source>
        <translation>El experto</translation>
    </message>
    <message>
        <source>A simulated hand does the lesson …</source>
        <translation>Una mano simulada hace la lección …</translation>
    </message>
    <message>
        <source>The simulated hand</source>
        <translation>La mano simulada</translation>
    </message>
    <message>
        <source>No teacher has recorded this lesson, so a simulated hand shows it.</source>
        <translation>Ningún docente ha grabado esta lección, así que la muestra una mano simulada.</translation>
    </message>
    <message>
        <source>No teacher has recorded this lesson, and the simulated hand cannot do it.</source>
        <translation>Ningún docente ha grabado esta lección, y la mano simulada no puede hacerla.</translation>
    </message>
</context>
<context>
    <name>app::LoginController</name>
    <message>
        <source>The school&apos;s database is on a network drive, where only one computer at a time can use it. For several computers, use a PostgreSQL server.</source>
        <translation>La base de datos de la escuela está en una unidad de red, donde solo puede usarla un ordenador a la vez. Para varios ordenadores, use un servidor PostgreSQL.</translation>
    </message>
    <message>
        <source>The connection to the school&apos;s server is not protected: someone on the network can read or change names and marks. Ask whoever looks after the server.</source>
        <translation>La conexión con el servidor de la escuela no está protegida: alguien en la red puede leer o cambiar nombres y notas. Pregunte a quien se ocupa del servidor.</translation>
    </message>
    <message>
        <source>Your password was changed.</source>
        <translation>Su contraseña se ha cambiado.</translation>
    </message>
    <message>
        <source>This account was disabled, and you were logged out. Ask an admin.</source>
        <translation>Esta cuenta se ha desactivado y se ha cerrado su sesión. Pregunte a la administración.</translation>
    </message>
    <message>
        <source>Your role was changed, and you were logged out. Log in again.</source>
        <translation>Se ha cambiado su papel y se ha cerrado su sesión. Inicie sesión de nuevo.</translation>
    </message>
    <message>
        <source>Your login has ended, or another school is now where yours was. Log in again.</source>
        <translation>Su sesión ha terminado, o donde estaba su escuela hay ahora otra. Inicie sesión de nuevo.</translation>
    </message>
</context>
<context>
    <name>app::SchoolController</name>
    <message>
        <source>An attempt does not match its recording, so its score does not count. It is marked in the student&apos;s attempts and in the table of the class.</source>
        <translation>Un intento no coincide con su grabación, por lo que su puntuación no cuenta. Está señalado en los intentos del estudiante y en la tabla de la clase.</translation>
    </message>
    <message>
        <source>The database is older than when this computer last used it: attempts and changes may be missing. If nobody restored a backup, somebody put an older copy in its place. The audit has a row about it.</source>
        <translation>La base de datos es más antigua que cuando este equipo la usó por última vez: pueden faltar intentos y cambios. Si nadie restauró una copia de seguridad, alguien puso una copia más antigua en su lugar. El registro tiene una fila al respecto.</translation>
    </message>
    <message>
        <source>Today&apos;s backup was not made. %1</source>
        <translation>No se hizo la copia de hoy. %1</translation>
    </message>
    <message>
        <source>The backup was not restored; nothing has been changed. %1</source>
        <translation>La copia de seguridad no se restauró; no se ha cambiado nada. %1</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) on this computer cannot be sent to this school: the student is unknown, or another station.key signed them. They stay on this computer.</source>
        <translation>
            <numerusform>%n intento de este ordenador no se puede enviar a esta escuela: el estudiante es desconocido, o se firmó con otro station.key. Se queda en este ordenador.</numerusform>
            <numerusform>%n intentos de este ordenador no se pueden enviar a esta escuela: el estudiante es desconocido, o se firmaron con otro station.key. Se quedan en este ordenador.</numerusform>
        </translation>
    </message>
    <message>
        <source>The backup of %1 was restored.</source>
        <extracomment>%2: a file&apos;s name</extracomment>
        <translation>Se restauró la copia del %1.</translation>
    </message>
    <message>
        <source>The backup of %1 was restored. The previous file is kept next to it as %2.</source>
        <translation>Se restauró la copia del %1. El archivo anterior se conserva a su lado como %2.</translation>
    </message>
    <message>
        <source>The backup was not restored. %1</source>
        <translation>La copia de seguridad no se restauró. %1</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) on this computer wait for another school: %1. If that is this one under an earlier name, &quot;cusp db send&quot; brings them here.</source>
        <extracomment>%1: a file&apos;s name, or the address of a server</extracomment>
        <translation>
            <numerusform>%n intento en este equipo queda pendiente para otra escuela: %1. Si es esta misma con un nombre anterior, «cusp db send» lo trae aquí.</numerusform>
            <numerusform>%n intentos en este equipo quedan pendientes para otra escuela: %1. Si es esta misma con un nombre anterior, «cusp db send» los trae aquí.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ReportController</name>
    <message>
        <source>Score card: %1</source>
        <translation>Hoja de puntuación: %1</translation>
    </message>
    <message>
        <source>Save the score card</source>
        <translation>Guardar la hoja de puntuación</translation>
    </message>
    <message>
        <source>The score card was saved as %1.</source>
        <translation>La hoja de puntuación se guardó como %1.</translation>
    </message>
    <message>
        <source>The score card could not be written. Choose another folder, or free some disk space.</source>
        <translation>La hoja de puntuación no se pudo escribir. Elija otra carpeta o libere espacio en el disco.</translation>
    </message>
    <message>
        <source>The score card was printed.</source>
        <translation>La hoja de puntuación se imprimió.</translation>
    </message>
    <message>
        <source>The score card could not be printed.</source>
        <translation>No se pudo imprimir la hoja de puntuación.</translation>
    </message>
    <message>
        <source>Creating the score card …</source>
        <translation>Preparando la hoja de puntuación …</translation>
    </message>
    <message>
        <source>Not logged in</source>
        <translation>Sin iniciar sesión</translation>
    </message>
    <message>
        <source>There is no printer on this computer. Save it as a PDF instead.</source>
        <translation>En este equipo no hay impresora. Guárdelo como PDF.</translation>
    </message>
</context>
<context>
    <name>app::DeviceController</name>
    <message>
        <source>This cannot be changed during an exam.</source>
        <translation>Esto no se puede cambiar durante un examen.</translation>
    </message>
    <message>
        <source>The %1 is ready again and moves the bur.</source>
        <extracomment>%1: a force device</extracomment>
        <translation>El %1 vuelve a estar listo y mueve la fresa.</translation>
    </message>
    <message>
        <source>The %1 no longer responds, and the bur was lifted. Continue with the mouse, or plug it in again.</source>
        <extracomment>%1: a force device</extracomment>
        <translation>El %1 ya no responde y la fresa se ha levantado. Continúe con el ratón o vuelva a conectarlo.</translation>
    </message>
    <message>
        <source>Show the device</source>
        <translation>Mostrar el dispositivo</translation>
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
        <translation>Imprimir la marca</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Documento PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The sheet is in %1. Print it without scaling.</source>
        <extracomment>%1: a path</extracomment>
        <translation>La hoja está en %1. Imprímala sin escalar.</translation>
    </message>
    <message>
        <source>The sheet could not be written.</source>
        <translation>No se pudo escribir la hoja.</translation>
    </message>
    <message>
        <source>The field of view could not be measured. Hold the tag still at this distance, and check the edge of its black square.</source>
        <translation>No se pudo medir el campo de visión. Mantenga la marca quieta a esta distancia y compruebe el lado de su cuadrado negro.</translation>
    </message>
    <message>
        <source>The field of view is %1°. It is stored for this camera.</source>
        <extracomment>%1: a number of degrees</extracomment>
        <translation>El campo de visión es de %1°. Se guarda para esta cámara.</translation>
    </message>
    <message>
        <source>The view does not follow your head: the camera gives no pictures.</source>
        <translation>La vista no sigue su cabeza: la cámara no da imágenes.</translation>
    </message>
    <message>
        <source>The view does not follow your head: the tag is not seen.</source>
        <translation>La vista no sigue su cabeza: no se ve la marca.</translation>
    </message>
    <message>
        <source>Show the device</source>
        <translation>Mostrar el dispositivo</translation>
    </message>
    <message>
        <source>The calibration %1 cannot be used. The field of view counts.</source>
        <extracomment>%1: the name of a file</extracomment>
        <translation>La calibración %1 no se puede usar. Vale el campo de visión.</translation>
    </message>
</context>
<context>
    <name>app::AttemptHistoryController</name>
    <message>
        <source>The recording of this attempt is not there, so it cannot be shown again. Its score and its figures are in the list.</source>
        <translation>La grabación de este intento no está, por lo que no se puede volver a mostrar. Su puntuación y sus cifras están en la lista.</translation>
    </message>
    <message>
        <source>%1: %2 points</source>
        <extracomment>%1: a lesson, and when it was done</extracomment>
        <translation>%1: %2 puntos</translation>
    </message>
    <message>
        <source>This belongs to none of your classes any more. An admin can enter you into the class again.</source>
        <translation>Esto ya no pertenece a ninguno de sus grupos. Un administrador puede volver a ponerle en el grupo.</translation>
    </message>
</context>
<context>
    <name>app::ClassController</name>
    <message>
        <source>Save the class report</source>
        <translation>Guardar el informe del grupo</translation>
    </message>
    <message>
        <source>The report was saved as %1.</source>
        <translation>El informe se guardó como %1.</translation>
    </message>
    <message>
        <source>The report could not be written. Choose another folder, or make room on the disk.</source>
        <translation>El informe no se pudo escribir. Elija otra carpeta o libere espacio en el disco.</translation>
    </message>
    <message>
        <source>The report was printed.</source>
        <translation>El informe se imprimió.</translation>
    </message>
    <message>
        <source>The printer did not take the report.</source>
        <translation>La impresora no aceptó el informe.</translation>
    </message>
    <message>
        <source>The report is being written …</source>
        <translation>Redactando el informe …</translation>
    </message>
    <message>
        <source>There is no printer on this computer. Save it as a PDF instead.</source>
        <translation>En este equipo no hay impresora. Guárdelo como PDF.</translation>
    </message>
</context>
<context>
    <name>app::CommentsController</name>
    <message>
        <source>On the attempt of %1: %2</source>
        <extracomment>%1: who made an attempt, and when; %2: why</extracomment>
        <translation>Sobre el intento de %1: %2</translation>
    </message>
    <message>
        <source>That was not done: this student is in none of your classes any more. What you have typed stays here; an admin can enter you into the class again.</source>
        <translation>No se hizo: este estudiante ya no está en ninguno de sus grupos. Lo que ha escrito queda aquí; un administrador puede volver a ponerle en el grupo.</translation>
    </message>
</context>
<context>
    <name>app::PresetController</name>
    <message>
        <source>The next tooth feels like this.</source>
        <translation>El próximo diente se sentirá así.</translation>
    </message>
    <message>
        <source>The next tooth of everybody here feels like this.</source>
        <translation>El próximo diente se sentirá así para todos aquí.</translation>
    </message>
    <message>
        <source>Not kept: only an admin keeps the school&apos;s presets.</source>
        <translation>No se guardó: solo un administrador guarda los ajustes de la escuela.</translation>
    </message>
    <message>
        <source>Not kept: %1</source>
        <translation>No se guardó: %1</translation>
    </message>
    <message>
        <source>Not imported: %1</source>
        <translation>No se importó: %1</translation>
    </message>
    <message>
        <source>The preset was exported as %1.</source>
        <translation>El ajuste se exportó como %1.</translation>
    </message>
    <message>
        <source>Not kept: the file cannot be written. Make room on the disk, or check the rights.</source>
        <translation>No se guardó: el archivo no se puede escribir. Libere espacio en el disco o revise los permisos.</translation>
    </message>
    <message>
        <source>Not exported: the file cannot be written. Choose another folder, or make room on the disk.</source>
        <translation>No se exportó: el archivo no se puede escribir. Elija otra carpeta o libere espacio en el disco.</translation>
    </message>
    <message>
        <source>Somebody else has chosen %1 for everybody here meanwhile. That stays.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>Mientras tanto, otra persona ha elegido %1 para todos aquí. Se queda así.</translation>
    </message>
    <message>
        <source>%1 was not retired: teeth feel like it now, or too many are retired.</source>
        <translation>%1 no se ha retirado: los dientes se sienten así ahora, o ya hay demasiados retirados.</translation>
    </message>
    <message>
        <source>%1 is offered to nobody any more. Attempts go on naming it.</source>
        <translation>%1 ya no se ofrece a nadie. Los intentos lo siguen nombrando.</translation>
    </message>
    <message>
        <source>%1 is offered again.</source>
        <translation>%1 se ofrece de nuevo.</translation>
    </message>
    <message>
        <source>The next tooth of everybody here feels like this. An admin had retired it; it is offered again.</source>
        <translation>El próximo diente se sentirá así para todos aquí. Un administrador lo había retirado; se ofrece de nuevo.</translation>
    </message>
</context>
<context>
    <name>ui::admin::AdminPage</name>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Class list</source>
        <translation>Lista de grupo</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Copias de seguridad</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>This computer</source>
        <translation>Este ordenador</translation>
    </message>
    <message>
        <source>School</source>
        <translation>Escuela</translation>
    </message>
</context>
<context>
    <name>ui::admin::AuditPart</name>
    <message>
        <source>Clear the search</source>
        <translation>Borrar la búsqueda</translation>
    </message>
    <message>
        <source>Search: a person, an action</source>
        <translation>Buscar: una persona, una acción</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the audit code</source>
        <translation>Copiar el código del registro</translation>
    </message>
    <message>
        <source>Older rows</source>
        <translation>Filas anteriores</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Registro</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n fila</numerusform>
            <numerusform>%n filas</numerusform>
        </translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Cuándo</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Quién</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Whom or what</source>
        <translation>A quién o qué</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
    <message>
        <source>Audit code now: %1. Every report shows the code of its day. Type one beside &quot;Check everything&quot; (Backups) to see whether what was noted before it is still as it was.</source>
        <extracomment>%1: a short code</extracomment>
        <translation>Código de auditoría ahora: %1. Cada informe muestra el código de su día. Escriba uno junto a «Revisar todo» (Copias de seguridad) para ver si lo que se anotó antes sigue como estaba.</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) among the newest %1; &quot;Older rows&quot; brings more to search</source>
        <extracomment>%1: how many rows were searched</extracomment>
        <translation>
            <numerusform>%n fila entre las %1 más recientes; «Filas anteriores» trae más para buscar</numerusform>
            <numerusform>%n filas entre las %1 más recientes; «Filas anteriores» trae más para buscar</numerusform>
        </translation>
    </message>
    <message>
        <source>Leave out attempts</source>
        <translation>Omitir los intentos</translation>
    </message>
    <message>
        <source>Who began an exam or made an attempt is not shown: what is left is what was done to people, classes, grades, presets, settings and backups</source>
        <translation>No se muestra quién empezó un examen o hizo un intento: queda lo que se hizo con personas, clases, calificaciones, preajustes, ajustes y copias de seguridad</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) among the newest %1 without attempts; &quot;Older rows&quot; brings more to search</source>
        <extracomment>%1: how many rows were searched</extracomment>
        <translation>
            <numerusform>%n fila entre las %1 más recientes sin intentos; «Filas anteriores» trae más para buscar</numerusform>
            <numerusform>%n filas entre las %1 más recientes sin intentos; «Filas anteriores» trae más para buscar</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::admin::BackupPart</name>
    <message>
        <source>Back up now</source>
        <translation>Hacer copia ahora</translation>
    </message>
    <message>
        <source>Check everything</source>
        <translation>Revisar todo</translation>
    </message>
    <message>
        <source>Look at every page, every attempt and the whole audit for what was changed, removed or inserted</source>
        <translation>Mirar cada página, cada intento y todo el registro en busca de lo cambiado, quitado o añadido</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>What the check found</source>
        <translation>Lo que encontró la revisión</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Copias de seguridad</translation>
    </message>
    <message>
        <source>The school&apos;s data are on a server: %1. Its administrator makes the backups; &quot;cusp db copy&quot; brings all of it into a file.</source>
        <translation>Los datos de la escuela están en un servidor: %1. Su administrador hace las copias; «cusp db copy» lo lleva todo a un archivo.</translation>
    </message>
    <message>
        <source>Yes: log everybody out and restore it</source>
        <translation>Sí: cerrar todas las sesiones y restaurar</translation>
    </message>
    <message>
        <source>Restore the chosen backup …</source>
        <translation>Restaurar la copia elegida …</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Hecha</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Keep what there is</source>
        <translation>Dejarlo como está</translation>
    </message>
    <message>
        <source>The school&apos;s data are in %1. A backup is made every day the program is used. All of the last two days are kept, then one for each of 12 days, 10 weeks and 9 months.</source>
        <translation>Los datos de la escuela están en %1. Cada día que se usa el programa se hace una copia de seguridad. Se conservan todas las de los dos últimos días y después una de cada uno de 12 días, 10 semanas y 9 meses.</translation>
    </message>
    <message>
        <source>Restore the backup of %1? What was entered after it will be missing. Attempts of this computer that are in no backup are entered again. The present file is kept beside it.</source>
        <extracomment>%1: when a backup was made</extracomment>
        <translation>¿Restaurar la copia de %1? Faltará lo que se registró después. Los intentos de este ordenador que no están en ninguna copia se vuelven a registrar. El archivo actual se conserva al lado.</translation>
    </message>
    <message>
        <source>Audit code of a report (optional):</source>
        <translation>Código de auditoría de un informe (opcional):</translation>
    </message>
    <message>
        <source>&quot;Check everything&quot; then also looks whether the audit is still the one that the report was printed from</source>
        <translation>«Revisar todo» mira entonces también si el registro sigue siendo aquel del que se imprimió el informe</translation>
    </message>
    <message>
        <source>This is no audit code. A report shows one such as %1.</source>
        <extracomment>%1: an example</extracomment>
        <translation>Esto no es un código de auditoría. Un informe muestra uno como %1.</translation>
    </message>
</context>
<context>
    <name>ui::admin::PeoplePart</name>
    <message>
        <source>Erase …</source>
        <translation>Borrar …</translation>
    </message>
    <message>
        <source>Erase the person</source>
        <translation>Borrar a la persona</translation>
    </message>
    <message>
        <source>Remove names, login and comments; the attempts stay under a pseudonym</source>
        <translation>Eliminar nombres, inicio de sesión y comentarios; los intentos se conservan con un seudónimo</translation>
    </message>
    <message>
        <source>erased</source>
        <translation>borrada</translation>
    </message>
    <message>
        <source>This person was erased. The attempts stay under this name.</source>
        <translation>Esta persona fue borrada. Los intentos se conservan con este nombre.</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Borrar la búsqueda</translation>
    </message>
    <message>
        <source>Search: a name, a class, a role</source>
        <translation>Buscar: un nombre, un grupo, un papel</translation>
    </message>
    <message>
        <source>Username</source>
        <translation>Nombre de usuario</translation>
    </message>
    <message>
        <source>Given name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Family name</source>
        <translation>Apellidos</translation>
    </message>
    <message>
        <source>Name of a class</source>
        <translation>Nombre de un grupo</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Usuario</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Grupos</translation>
    </message>
    <message>
        <source>Last login</source>
        <translation>Última sesión</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>New person</source>
        <translation>Nueva persona</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Add a class of this name</source>
        <translation>Añadir un grupo con este nombre</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>Give this name to the class that is chosen above</source>
        <translation>Dar este nombre al grupo elegido arriba</translation>
    </message>
    <message>
        <source>Reset password</source>
        <translation>Restablecer contraseña</translation>
    </message>
    <message>
        <source>Take the password away and give a one-time code in its place</source>
        <translation>Quitar la contraseña y dar en su lugar un código de un solo uso</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Rename the class</source>
        <translation>Cambiar el nombre del grupo</translation>
    </message>
    <message>
        <source>Copy the one-time code</source>
        <translation>Copiar el código de un solo uso</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>can log in</source>
        <translation>puede iniciar sesión</translation>
    </message>
    <message>
        <source>has a one-time code</source>
        <translation>tiene un código de un solo uso</translation>
    </message>
    <message>
        <source>Enter the person</source>
        <translation>Registrar a la persona</translation>
    </message>
    <message>
        <source>Save the changes</source>
        <translation>Guardar los cambios</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>Activar</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>Desactivar</translation>
    </message>
    <message>
        <source>Who is disabled cannot log in; attempts and names stay</source>
        <translation>Quien está desactivado no puede iniciar sesión; sus intentos y su nombre se conservan</translation>
    </message>
    <message>
        <source>needs a one-time code</source>
        <translation>necesita un código de un solo uso</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Conservarla</translation>
    </message>
    <message>
        <source>Keep the password</source>
        <translation>Conservar la contraseña</translation>
    </message>
    <message>
        <source>Yes, take it away</source>
        <translation>Sí, quitarla</translation>
    </message>
    <message>
        <source>Yes, take the password away</source>
        <translation>Sí, quitar la contraseña</translation>
    </message>
    <message>
        <source>%1 will need a new one-time code: take the password away?</source>
        <translation>%1 necesitará un nuevo código de un solo uso: ¿quitar la contraseña?</translation>
    </message>
    <message>
        <source>The school&apos;s data are being written to …</source>
        <translation>Se está escribiendo en los datos de la escuela …</translation>
    </message>
    <message numerus="yes">
        <source>%Ln person(s)</source>
        <translation>
            <numerusform>%Ln persona</numerusform>
            <numerusform>%Ln personas</numerusform>
        </translation>
    </message>
    <message>
        <source>What you have typed for a new person is not entered.</source>
        <translation>Lo que ha escrito de una persona nueva no está registrado.</translation>
    </message>
    <message>
        <source>What you have changed of %1 is not saved.</source>
        <translation>Lo que ha cambiado de %1 no está guardado.</translation>
    </message>
    <message>
        <source>has a one-time code, shown here</source>
        <translation>tiene un código de un solo uso, visible aquí</translation>
    </message>
    <message>
        <source>There is a class %1 already. It is ticked above.</source>
        <extracomment>%1: the name of a class</extracomment>
        <translation>La clase %1 ya existe. Está marcada arriba.</translation>
    </message>
    <message>
        <source>Yes, make another</source>
        <translation>Sí, crear otro</translation>
    </message>
    <message>
        <source>The one-time code of %1 above would let nobody in any longer: make another?</source>
        <translation>El código de un solo uso de %1, arriba, ya no dejaría entrar a nadie: ¿crear otro?</translation>
    </message>
    <message>
        <source>The username is missing.</source>
        <translation>Falta el nombre de usuario.</translation>
    </message>
    <message numerus="yes">
        <source>%n one-time code(s) are shown under School, and kept nowhere else: %1.</source>
        <extracomment>%1: a person, or several</extracomment>
        <translation>
            <numerusform>%n código de un solo uso se muestra en Escuela y no está en ningún otro lugar: %1.</numerusform>
            <numerusform>%n códigos de un solo uso se muestran en Escuela y no están en ningún otro lugar: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Yes, save it</source>
        <translation>Sí, guardar</translation>
    </message>
    <message>
        <source>Stay an admin</source>
        <translation>Seguir siendo administrador</translation>
    </message>
    <message>
        <source>You would be an admin no longer, and be logged out: save it all the same?</source>
        <translation>Dejaría de ser administrador y se cerraría su sesión: ¿guardarlo de todos modos?</translation>
    </message>
    <message>
        <source>This is your own account. You would be logged out, and could not log in again: disable it?</source>
        <translation>Es su propia cuenta. Se cerraría su sesión y no podría volver a iniciarla: ¿desactivarla?</translation>
    </message>
    <message>
        <source>Yes, disable it</source>
        <translation>Sí, desactivar</translation>
    </message>
    <message>
        <source>Somebody else has changed %1 meanwhile. What you have typed stays here.</source>
        <extracomment>%1 is a person</extracomment>
        <translation>Mientras tanto, otra persona ha cambiado los datos de %1. Lo que ha escrito sigue aquí.</translation>
    </message>
    <message>
        <source>One-time code of %1. Tell it now: it is kept nowhere. It is shown here, whenever %1 is chosen, until you log out.</source>
        <translation>Código de un solo uso de %1. Comuníquelo ahora: no se guarda en ningún sitio. Se muestra aquí, cada vez que elija a %1, hasta que cierre la sesión.</translation>
    </message>
</context>
<context>
    <name>ui::admin::RosterPart</name>
    <message>
        <source>A class list is a CSV file with the columns username, given_name, family_name, role and class. Role may be left out; several classes are parted by |. Choose it, or drop it here: nothing is entered before you have seen what it would do.</source>
        <translation>Una lista de grupo es un archivo CSV con las columnas username, given_name, family_name, role y class. El papel puede faltar; varios grupos se separan con una barra vertical. Elíjala o suéltela aquí: nada se registra antes de que vea lo que haría.</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Elegir un archivo …</translation>
    </message>
    <message>
        <source>Enter these people</source>
        <translation>Registrar a estas personas</translation>
    </message>
    <message>
        <source>Save the one-time codes …</source>
        <translation>Guardar los códigos …</translation>
    </message>
    <message>
        <source>What the class list would do</source>
        <translation>Lo que haría la lista</translation>
    </message>
    <message>
        <source>%1 was entered: %2 new, %3 known already. The codes below are kept nowhere else.</source>
        <translation>%1 se registró: %2 nuevas, %3 ya conocidas. Los códigos de abajo no se guardan en otro sitio.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Columna</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Qué está mal</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Usuario</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>One-time code</source>
        <translation>Código de un solo uso</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nueva</translation>
    </message>
    <message>
        <source>known</source>
        <translation>conocida</translation>
    </message>
    <message>
        <source>Choose a class list</source>
        <translation>Elegir una lista de grupo</translation>
    </message>
    <message>
        <source>Class lists (*.csv);;All files (*)</source>
        <translation>Listas de grupo (*.csv);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Save the one-time codes</source>
        <translation>Guardar los códigos de un solo uso</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>The codes were saved. Delete the file when everybody has logged in.</source>
        <translation>Los códigos se guardaron. Borre el archivo cuando todos hayan iniciado sesión.</translation>
    </message>
    <message>
        <source>The codes could not be written. Choose another folder, or make room on the disk.</source>
        <translation>No se pudieron escribir los códigos. Elija otra carpeta o libere espacio en el disco.</translation>
    </message>
    <message>
        <source>Example of a class list</source>
        <translation>Ejemplo de una lista de clase</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rol</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Clases</translation>
    </message>
    <message>
        <source>%1 (new)</source>
        <extracomment>%1: a class that would be added</extracomment>
        <translation>%1 (nueva)</translation>
    </message>
    <message>
        <source>The one-time codes of %1 are not saved, and they are kept nowhere else.</source>
        <translation>Los códigos de un solo uso de %1 no se han guardado y no están en ningún otro lugar.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln fault(s). Nothing was entered; mend the file and choose it again.</source>
        <translation>
            <numerusform>%1: %Ln fallo. No se registró nada; corrija el archivo y elíjalo de nuevo.</numerusform>
            <numerusform>%1: %Ln fallos. No se registró nada; corrija el archivo y elíjalo de nuevo.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is nobody in %1: it has only the line that names the columns.</source>
        <translation>En %1 no hay nadie: solo tiene la línea que nombra las columnas.</translation>
    </message>
    <message numerus="yes">
        <source>%1 %Ln new person(s) would be entered.</source>
        <extracomment>%1: what another sentence says of how many are known already</extracomment>
        <translation>
            <numerusform>%1 Se registraría %Ln persona nueva.</numerusform>
            <numerusform>%1 Se registrarían %Ln personas nuevas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln person(s) known already.</source>
        <translation>
            <numerusform>%1: %Ln persona ya conocida.</numerusform>
            <numerusform>%1: %Ln personas ya conocidas.</numerusform>
        </translation>
    </message>
    <message>
        <source>known as %1 so far</source>
        <translation>hasta ahora conocido como %1</translation>
    </message>
    <message>
        <source>%1 was entered: nobody in it is new.</source>
        <translation>%1 se ha registrado: nadie en ella es nuevo.</translation>
    </message>
    <message>
        <source>%1; the line has fewer fields than the first</source>
        <extracomment>%1: &quot;new&quot; or &quot;known&quot;, of somebody on a class list</extracomment>
        <translation>%1; la línea tiene menos campos que la primera</translation>
    </message>
    <message>
        <source>These people are being entered …</source>
        <translation>Se está registrando a estas personas …</translation>
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
        <translation>Minutos tras los que se bloquea un puesto abandonado</translation>
    </message>
    <message>
        <source>Drilled with</source>
        <translation>Se talla con</translation>
    </message>
    <message>
        <source>Servo loop</source>
        <translation>Bucle de control</translation>
    </message>
    <message>
        <source>Key of this station</source>
        <translation>Clave de este puesto</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>Base de datos</translation>
    </message>
    <message>
        <source>On their way</source>
        <translation>En camino</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>%1 times a second</source>
        <translation>%1 veces por segundo</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n intento</numerusform>
            <numerusform>%n intentos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (pen)</source>
        <translation>%1 (lápiz)</translation>
    </message>
    <message>
        <source>a mouse</source>
        <translation>un ratón</translation>
    </message>
    <message>
        <source>%1 ms in the middle, 99 of 100 within %2 ms</source>
        <extracomment>Times between two servo ticks</extracomment>
        <translation>%1 ms en el medio, 99 de 100 en %2 ms como mucho</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>todavía no</translation>
    </message>
    <message>
        <source>Found here</source>
        <translation>Encontrado aquí</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medido</translation>
    </message>
    <message>
        <source>Everywhere in the school, a place that was left is locked after</source>
        <translation>En toda la escuela, un puesto abandonado se bloquea a los</translation>
    </message>
</context>
<context>
    <name>ui::charts::ChartPanel</name>
    <message>
        <source>Save as picture (PNG) …</source>
        <translation>Guardar como imagen (PNG) …</translation>
    </message>
    <message>
        <source>Save as drawing (SVG) …</source>
        <translation>Guardar como dibujo (SVG) …</translation>
    </message>
    <message>
        <source>Save as table (CSV) …</source>
        <translation>Guardar como tabla (CSV) …</translation>
    </message>
    <message>
        <source>Save this chart</source>
        <translation>Guardar este gráfico</translation>
    </message>
    <message>
        <source>Save the chart &quot;%1&quot;</source>
        <translation>Guardar el gráfico «%1»</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>Guardar el gráfico</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Guardado: %1</translation>
    </message>
    <message>
        <source>%1 could not be written (%2). Try another folder.</source>
        <extracomment>%2: the system&apos;s own words</extracomment>
        <translation>%1 no se pudo escribir (%2). Pruebe con otra carpeta.</translation>
    </message>
</context>
<context>
    <name>ui::charts::Table</name>
    <message>
        <source>series</source>
        <translation>serie</translation>
    </message>
    <message>
        <source>class, lower quartile</source>
        <translation>grupo, cuartil inferior</translation>
    </message>
    <message>
        <source>class, median</source>
        <translation>grupo, mediana</translation>
    </message>
    <message>
        <source>class, upper quartile</source>
        <translation>grupo, cuartil superior</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
</context>
<context>
    <name>ui::console::Console</name>
    <message>
        <source>Console</source>
        <translation>Consola</translation>
    </message>
    <message>
        <source>Answers of the console</source>
        <translation>Respuestas de la consola</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Type a command; Tab completes, &quot;help&quot; explains</source>
        <translation>Escriba una orden; Tab completa, «help» explica</translation>
    </message>
    <message>
        <source>Parameters can be looked at and turned here while you drill. &quot;help&quot; lists the commands.</source>
        <translation>Aquí se pueden ver los parámetros y cambiarlos mientras fresa. «help» enumera las órdenes.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; wants a name behind it.</source>
        <translation>«%1» necesita un nombre detrás.</translation>
    </message>
    <message>
        <source>Write &quot;set NAME VALUE&quot;, as in &quot;set force.stiffness 1.5&quot;.</source>
        <translation>Escriba «set NOMBRE VALOR», como en «set force.stiffness 1.5».</translation>
    </message>
    <message>
        <source>Presets are not to be had here.</source>
        <translation>Aquí no hay ajustes de dureza disponibles.</translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;. &quot;help&quot; lists those there are.</source>
        <translation>No hay ninguna orden «%1». «help» enumera las que hay.</translation>
    </message>
    <message>
        <source>No parameter&apos;s name holds &quot;%1&quot;.</source>
        <translation>Ningún parámetro contiene «%1» en su nombre.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
    <message>
        <source>All that is felt is as the preset says.</source>
        <translation>Todo lo que se siente es como dice el ajuste.</translation>
    </message>
    <message>
        <source>There is room for %1. Take one away with &quot;unwatch NAME&quot;.</source>
        <translation>Hay sitio para %1. Quite uno con «unwatch NOMBRE».</translation>
    </message>
    <message>
        <source>Page Up and Page Down turn over the answers, Up and Down what was typed.</source>
        <translation>Re Pág y Av Pág pasan las respuestas; Arriba y Abajo, lo escrito.</translation>
    </message>
    <message>
        <source>Write &quot;export NAME FILE&quot;, as in &quot;export live.force force.csv&quot;.</source>
        <translation>Escriba «export NOMBRE ARCHIVO», como en «export live.force force.csv».</translation>
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
        <translation>list [TEXTO]       los parámetros cuyo nombre contiene el texto
get NOMBRE         su valor, intervalo y qué hace
set NOMBRE VALOR   lo fija
reset [NOMBRE]     lo devuelve a su valor, o todo lo que se siente
watch NOMBRE       lo muestra sobre la vista
plot NOMBRE        dibuja sus últimos diez segundos sobre la vista
export NOMBRE ARCHIVO guarda lo trazado: .csv, .svg o .png
unwatch [NOMBRE]   lo quita, o lo quita todo
save NOMBRE        conserva lo que se siente como ajuste de dureza
load NOMBRE        hace sentir un ajuste de dureza conservado</translation>
    </message>
    <message>
        <source>%1 is not plotted. &quot;plot %1&quot; begins it; then it can be saved.</source>
        <translation>%1 no se está trazando. «plot %1» lo empieza; después se puede guardar.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Guardado como %1.</translation>
    </message>
    <message>
        <source>There is a file %1 already; choose another name.</source>
        <translation>Ya existe un archivo %1; elija otro nombre.</translation>
    </message>
</context>
<context>
    <name>ui::console::WatchPanel</name>
    <message>
        <source>Seconds before now</source>
        <translation>Segundos antes de ahora</translation>
    </message>
</context>
<context>
    <name>ui::console::Words</name>
    <message>
        <source>on</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>off</source>
        <translation>no</translation>
    </message>
    <message>
        <source>a live value, to be read, watched or plotted</source>
        <translation>un valor en vivo, para leer, vigilar o dibujar</translation>
    </message>
    <message>
        <source>0 (off) or 1 (on)</source>
        <translation>0 (no) o 1 (sí)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <extracomment>%1 and %2 are numbers, %2 with a unit</extracomment>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>There is no parameter &quot;%1&quot;. Type &quot;list&quot; for those there are.</source>
        <translation>No hay ningún parámetro «%1». Escriba «list» para ver los que hay.</translation>
    </message>
    <message>
        <source>%1 is a live value: it can be watched and plotted, not set.</source>
        <translation>%1 es un valor en vivo: se puede vigilar y dibujar, no fijar.</translation>
    </message>
    <message>
        <source>%1 takes %2.</source>
        <translation>%1 admite %2.</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Dureza</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Ratón y teclas</translation>
    </message>
    <message>
        <source>Live values</source>
        <translation>Valores en vivo</translation>
    </message>
    <message>
        <source>This cannot be changed here and now.</source>
        <translation>Esto no se puede cambiar aquí y ahora.</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Presión</translation>
    </message>
    <message>
        <source>How hard the mouse button presses the bur against the tooth.</source>
        <translation>Con cuánta fuerza aprieta el botón del ratón la fresa contra el diente.</translation>
    </message>
    <message>
        <source>Force that the hand is given.</source>
        <translation>Fuerza que recibe la mano.</translation>
    </message>
    <message>
        <source>Depth of the bur&apos;s tip below the uncut surface.</source>
        <translation>Profundidad de la punta de la fresa bajo la superficie sin tallar.</translation>
    </message>
    <message>
        <source>Volume removed since the tooth was taken, undone or not.</source>
        <translation>Volumen eliminado desde que se tomó el diente, deshecho o no.</translation>
    </message>
    <message>
        <source>Turns of the bur under its load.</source>
        <translation>Vueltas de la fresa bajo su carga.</translation>
    </message>
    <message>
        <source>Periods of the servo that were missed since the start.</source>
        <translation>Periodos del servo perdidos desde el inicio.</translation>
    </message>
    <message>
        <source>Time between two ticks of the servo: half of the last second&apos;s were shorter.</source>
        <translation>Tiempo entre dos ciclos del servo: la mitad de los del último segundo fueron más cortos.</translation>
    </message>
    <message>
        <source>Time between two ticks of the servo: 99 in 100 of the last second&apos;s were shorter.</source>
        <translation>Tiempo entre dos ciclos del servo: 99 de cada 100 del último segundo fueron más cortos.</translation>
    </message>
    <message>
        <source>A blind comparison of two presets is running, so their values are hidden. &quot;End the comparison&quot; beside the tooth ends it.</source>
        <translation>Hay en curso una comparación a ciegas de dos ajustes, así que sus valores están ocultos. «Terminar la comparación», junto al diente, le pone fin.</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>How fast the bur goes down at most while you press.</source>
        <translation>A qué velocidad baja la fresa como máximo mientras pulsa.</translation>
    </message>
</context>
<context>
    <name>ui::devices::ButtonLights</name>
    <message>
        <source>No grip button is pressed</source>
        <translation>No se pulsa ningún botón de la empuñadura</translation>
    </message>
    <message>
        <source>Pressed: %1</source>
        <translation>Pulsados: %1</translation>
    </message>
</context>
<context>
    <name>ui::devices::DevicesPage</name>
    <message>
        <source>Devices</source>
        <translation>Dispositivos</translation>
    </message>
    <message>
        <source>Loading the firmware</source>
        <translation>Cargando el firmware</translation>
    </message>
    <message>
        <source>Pull the grip out of the device as far as it goes, then push it straight in.</source>
        <extracomment>Of the grip of a force device</extracomment>
        <translation>Tire de la empuñadura hacia fuera del dispositivo hasta el tope y luego empújela recta hacia dentro.</translation>
    </message>
    <message>
        <source>Each arm has to pass its index mark. If no ring fills, check that the mains adapter is plugged in.</source>
        <translation>Cada brazo tiene que pasar por su marca de referencia. Si no se llena ningún anillo, compruebe que el adaptador de corriente esté enchufado.</translation>
    </message>
    <message>
        <source>Mouse or pen</source>
        <translation>Ratón o lápiz</translation>
    </message>
    <message>
        <source>Simulated hand</source>
        <translation>Mano simulada</translation>
    </message>
    <message>
        <source>Always ready.</source>
        <translation>Siempre listo.</translation>
    </message>
    <message>
        <source>Drills by itself while you watch.</source>
        <translation>Fresa por sí sola mientras usted mira.</translation>
    </message>
    <message>
        <source>The bur follows the pointer over the tooth and goes down while you press the button. You feel no force. Feed, depth stop and force are set beside the tooth.</source>
        <translation>La fresa sigue al puntero sobre el diente y baja mientras pulsa el botón. No se siente ninguna fuerza. El avance, el tope de profundidad y la fuerza se ajustan junto al diente.</translation>
    </message>
    <message>
        <source>A simulated hand with a simulated force device cuts the ideal preparation. When you start or leave it, the attempt begins anew. Its attempts are not saved.</source>
        <translation>Una mano simulada con un dispositivo de fuerza simulado talla la preparación ideal. Cuando la inicia o la deja, el intento empieza de nuevo. Sus intentos no se guardan.</translation>
    </message>
    <message>
        <source>Serial number %1.</source>
        <extracomment>%1: the number of a device</extracomment>
        <translation>Número de serie %1.</translation>
    </message>
    <message>
        <source>Practise</source>
        <extracomment>The button that leads back to the tooth</extracomment>
        <translation>Practicar</translation>
    </message>
    <message>
        <source>Use: %1</source>
        <translation>Usar: %1</translation>
    </message>
    <message>
        <source>Another one is plugged in too. To use that one, unplug this one.</source>
        <translation>También hay otro conectado. Para usar ese, desconecte este.</translation>
    </message>
    <message>
        <source>Head tracking</source>
        <translation>Seguimiento de la cabeza</translation>
    </message>
    <message>
        <source>Pedal and gamepad</source>
        <translation>Pedal y mando</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Sonido</translation>
    </message>
    <message>
        <source>Hand and rest</source>
        <extracomment>A button that opens a guide: which hand works, and where it rests</extracomment>
        <translation>Mano y apoyo</translation>
    </message>
</context>
<context>
    <name>ui::devices::FirmwareCard</name>
    <message>
        <source>Firmware file</source>
        <translation>Archivo de firmware</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Elegir un archivo …</translation>
    </message>
    <message>
        <source>Choose the firmware file</source>
        <translation>Elegir el archivo de firmware</translation>
    </message>
    <message>
        <source>None is chosen.</source>
        <translation>No se ha elegido ninguno.</translation>
    </message>
    <message>
        <source>Unknown firmware, SHA-256 %1</source>
        <translation>Firmware desconocido, SHA-256 %1</translation>
    </message>
    <message>
        <source>Firmware (*.bin *.BIN);;All files (*)</source>
        <translation>Firmware (*.bin *.BIN);;Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>ui::devices::ForceTest</name>
    <message>
        <source>Away</source>
        <translation>Alejar</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Towards you</source>
        <translation>Hacia usted</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Abajo</translation>
    </message>
    <message>
        <source>Push the hand: %1</source>
        <extracomment>%1: a direction, such as &quot;Left&quot;</extracomment>
        <translation>Empujar la mano: %1</translation>
    </message>
</context>
<context>
    <name>ui::devices::HandList</name>
    <message>
        <source>Chosen</source>
        <translation>Elegido</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Dispositivos</translation>
    </message>
    <message>
        <source>%1, chosen</source>
        <translation>%1, elegido</translation>
    </message>
</context>
<context>
    <name>ui::devices::HeadTrackingCard</name>
    <message>
        <source>Follow my head</source>
        <translation>Seguir mi cabeza</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <extracomment>Of a picture: it looks like a mirror</extracomment>
        <translation>Como un espejo</translation>
    </message>
    <message>
        <source>Straight ahead is here</source>
        <translation>El centro está aquí</translation>
    </message>
    <message>
        <source>No picture is saved or sent.</source>
        <translation>Ninguna imagen se guarda ni se envía.</translation>
    </message>
    <message>
        <source>The picture of the camera appears here when head tracking is on.</source>
        <translation>Aquí aparece la imagen de la cámara cuando el seguimiento de la cabeza está activado.</translation>
    </message>
</context>
<context>
    <name>ui::devices::HomingMarks</name>
    <message numerus="yes">
        <source>%n of 3 arms homed</source>
        <translation>
            <numerusform>%n de 3 brazos referenciado</numerusform>
            <numerusform>%n de 3 brazos referenciados</numerusform>
        </translation>
    </message>
    <message>
        <source>Top arm</source>
        <translation>Brazo superior</translation>
    </message>
    <message>
        <source>Right arm</source>
        <translation>Brazo derecho</translation>
    </message>
    <message>
        <source>Left arm</source>
        <translation>Brazo izquierdo</translation>
    </message>
</context>
<context>
    <name>ui::devices::IntervalChart</name>
    <message>
        <source>Intervals between answers</source>
        <translation>Intervalos entre respuestas</translation>
    </message>
    <message>
        <source>Number of answers in the last second for each interval. The last bar contains all longer intervals. The height is logarithmic, so that a single late answer is visible.</source>
        <translation>Cuántas respuestas del último segundo llegaron tras cada intervalo. La última barra reúne todos los más largos. La altura crece con el logaritmo, para que se vea también una sola respuesta tardía.</translation>
    </message>
    <message>
        <source>%1 answers in a second</source>
        <translation>%1 respuestas en un segundo</translation>
    </message>
</context>
<context>
    <name>ui::devices::LiveTest</name>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Grip buttons</source>
        <translation>Botones de la empuñadura</translation>
    </message>
    <message>
        <source>Force: hold a button, and the device pushes your hand gently</source>
        <translation>Fuerza: mantenga pulsado un botón y el dispositivo empuja suavemente su mano</translation>
    </message>
    <message>
        <source>Intervals between answers</source>
        <translation>Intervalos entre respuestas</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Respuestas</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Ida y vuelta</translation>
    </message>
    <message>
        <source>99 % below</source>
        <extracomment>Of the time from a request to its answer: 99 of 100 are shorter</extracomment>
        <translation>99 % por debajo de</translation>
    </message>
    <message>
        <source>Lost</source>
        <extracomment>Requests without an answer</extracomment>
        <translation>Perdidas</translation>
    </message>
    <message>
        <source>Rejected</source>
        <extracomment>Answers that were not plausible</extracomment>
        <translation>Rechazadas</translation>
    </message>
</context>
<context>
    <name>ui::devices::PlacementPicture</name>
    <message>
        <source>It stands on its base, and the arms point away from its front.</source>
        <translation>Está sobre su base y los brazos apuntan hacia fuera desde su frente.</translation>
    </message>
    <message>
        <source>It lies on its back, and the arms point up.</source>
        <translation>Está tumbado de espaldas y los brazos apuntan hacia arriba.</translation>
    </message>
    <message>
        <source>It stands at your right hand and faces left.</source>
        <translation>Está a su derecha y mira hacia la izquierda.</translation>
    </message>
    <message>
        <source>It stands at your left hand and faces right.</source>
        <translation>Está a su izquierda y mira hacia la derecha.</translation>
    </message>
    <message>
        <source>It stands in front of you and faces you.</source>
        <translation>Está delante de usted y le mira de frente.</translation>
    </message>
    <message>
        <source>How to place the device</source>
        <translation>Cómo colocar el dispositivo</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>De lado</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Desde arriba</translation>
    </message>
</context>
<context>
    <name>ui::devices::PositionView</name>
    <message>
        <source>Position: %1 mm right, %2 mm away, %3 mm up</source>
        <extracomment>%1, %2, %3: millimetres to the right, away from the user and up</extracomment>
        <translation>Posición: %1 mm a la derecha, %2 mm hacia el fondo, %3 mm hacia arriba</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Desde arriba</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>De frente</translation>
    </message>
</context>
<context>
    <name>ui::devices::RuleCard</name>
    <message>
        <source>Copy the rule</source>
        <translation>Copiar la regla</translation>
    </message>
    <message>
        <source>Rule for this device</source>
        <translation>Regla para este dispositivo</translation>
    </message>
    <message>
        <source>As an administrator, write this rule to the file %1. Then unplug the device and plug it in again. The command &quot;%2&quot; prints the same rule.</source>
        <extracomment>%1: a file; %2: a command</extracomment>
        <translation>Como administrador, escriba esta regla en el archivo %1. Después desconecte el dispositivo y vuelva a conectarlo. La orden «%2» muestra la misma regla.</translation>
    </message>
</context>
<context>
    <name>ui::devices::SetupCard</name>
    <message>
        <source>It stands</source>
        <extracomment>How the device is placed on the table</extracomment>
        <translation>Posición</translation>
    </message>
    <message>
        <source>as sold</source>
        <extracomment>Of a device: on its base, as it was sold</extracomment>
        <translation>como se vende</translation>
    </message>
    <message>
        <source>on its back, arms up</source>
        <translation>de espaldas, brazos arriba</translation>
    </message>
    <message>
        <source>Place</source>
        <extracomment>Where the device stands, seen by the user</extracomment>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>in front of you</source>
        <translation>delante de usted</translation>
    </message>
    <message>
        <source>on your right</source>
        <translation>a su derecha</translation>
    </message>
    <message>
        <source>on your left</source>
        <translation>a su izquierda</translation>
    </message>
    <message>
        <source>Scale</source>
        <extracomment>How far the hand moves for one millimetre of the bur</extracomment>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Movement of the hand for 1 mm of the bur, in millimetres</source>
        <translation>Movimiento de la mano por 1 mm de la fresa, en milímetros</translation>
    </message>
</context>
<context>
    <name>ui::devices::TagSheet</name>
    <message>
        <source>Head tracking: tag %1</source>
        <translation>Seguimiento de la cabeza: marca %1</translation>
    </message>
    <message>
        <source>Print this on matte paper. Cut a tag out along the dashed line. Do not cut off its white border: without it the tag is not found. Glue the tag to a piece of stiff, flat card.</source>
        <translation>Imprima esto en papel mate. Recorte una marca por la línea discontinua. No corte el borde blanco: sin él no se encuentra la marca. Pegue la marca sobre un cartón rígido y plano.</translation>
    </message>
    <message>
        <source>Wear the tag on your forehead with the arrow pointing up, tilted by 15 to 25 degrees: its lower edge is nearer to the camera than its upper edge.</source>
        <translation>Lleve la marca en la frente con la flecha hacia arriba, inclinada de 15 a 25 grados: su borde inferior queda más cerca de la cámara que el superior.</translation>
    </message>
    <message>
        <source>Tell Cusp the length of the tag&apos;s edge. It stands below the tag and is the side of the black square.</source>
        <translation>Indique a Cusp la longitud del borde de la marca. Figura debajo de la marca y es el lado del cuadrado negro.</translation>
    </message>
    <message>
        <source>Tag %1, edge %2 mm</source>
        <translation>Marca %1, borde %2 mm</translation>
    </message>
    <message>
        <source>The headband: cut it out and cut its two slots. Pull an elastic band, 20 mm wide and about 35 cm long, through the slots.</source>
        <translation>La banda: recórtela y corte sus dos ranuras. Pase por las ranuras una cinta elástica de 20 mm de ancho y unos 35 cm de largo.</translation>
    </message>
    <message>
        <source>The wedge: glue it to stiff card, cut it out, fold it along the dotted lines to a triangle, and glue its flap to its foot. Glue it behind the tag, the foot below. It keeps the tag flat and tilts it by 20 degrees.</source>
        <translation>La cuña: péguela sobre cartón rígido, recórtela, dóblela por las líneas de puntos en forma de triángulo y pegue la solapa al pie. Péguela detrás de la marca, con el pie abajo. Mantiene plana la marca y la inclina 20 grados.</translation>
    </message>
    <message>
        <source>Flap</source>
        <translation>Solapa</translation>
    </message>
    <message>
        <source>This side to the forehead</source>
        <translation>Este lado hacia la frente</translation>
    </message>
    <message>
        <source>This side to the tag</source>
        <translation>Este lado hacia la marca</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Pie</translation>
    </message>
    <message>
        <source>Board for the calibration of a camera. Glue it to something stiff and flat. Show it to the camera at many places and tilted to all sides.</source>
        <translation>Tablero para calibrar una cámara. Péguelo sobre algo rígido y plano. Muéstrelo a la cámara en muchos lugares e inclinado hacia todos los lados.</translation>
    </message>
    <message>
        <source>Measure this line: it must be 100 mm long. Otherwise print without scaling (100 %).</source>
        <translation>Mida esta línea: debe tener 100 mm. Si no, imprima sin escalar (100 %).</translation>
    </message>
</context>
<context>
    <name>ui::devices::TagPicture</name>
    <message>
        <source>Picture of the camera, with the tag outlined</source>
        <translation>Imagen de la cámara, con el contorno del marcador</translation>
    </message>
    <message>
        <source>Picture of the camera, without the tag</source>
        <translation>Imagen de la cámara, sin el marcador</translation>
    </message>
</context>
<context>
    <name>ui::devices::TrackingFigures</name>
    <message>
        <source>Pictures per second</source>
        <translation>Imágenes por segundo</translation>
    </message>
    <message>
        <source>Pictures with the tag</source>
        <extracomment>Share of the pictures in which the tag was found</extracomment>
        <translation>Imágenes con el marcador</translation>
    </message>
    <message>
        <source>Time to find it</source>
        <translation>Tiempo de búsqueda</translation>
    </message>
    <message>
        <source>Latency</source>
        <extracomment>Time from a picture of the camera to the turn of the view</extracomment>
        <translation>Retardo</translation>
    </message>
    <message>
        <source>Jitter</source>
        <extracomment>How far the measured place of a head at rest moves</extracomment>
        <translation>Temblor</translation>
    </message>
</context>
<context>
    <name>ui::devices::TrackingSetupCard</name>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Size of its pictures</source>
        <translation>Tamaño de sus imágenes</translation>
    </message>
    <message>
        <source>Its field of view, sideways</source>
        <translation>Su campo de visión horizontal</translation>
    </message>
    <message>
        <source>60° fits most cameras. The data sheet of the camera has the exact number.</source>
        <translation>60° sirve para la mayoría de las cámaras. La ficha técnica de la cámara indica el valor exacto.</translation>
    </message>
    <message>
        <source>Number of the tag</source>
        <translation>Número del marcador</translation>
    </message>
    <message>
        <source>Edge of its black square</source>
        <translation>Lado de su cuadrado negro</translation>
    </message>
    <message>
        <source>Turn of the view for 1° of the head</source>
        <translation>Giro de la vista por 1° de la cabeza</translation>
    </message>
    <message>
        <source>Print the tag …</source>
        <translation>Imprimir el marcador…</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <extracomment>%1: a number</extracomment>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>No camera is plugged in</source>
        <translation>No hay ninguna cámara conectada</translation>
    </message>
    <message>
        <source>Camera %1, not plugged in</source>
        <extracomment>%1: the number of a camera</extracomment>
        <translation>Cámara %1, no conectada</translation>
    </message>
    <message>
        <source>A video file …</source>
        <translation>Un archivo de vídeo…</translation>
    </message>
    <message>
        <source>Choose a video file</source>
        <translation>Elija un archivo de vídeo</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.webm *.ogv);;All files (*)</source>
        <translation>Vídeos (*.mp4 *.mkv *.avi *.mov *.webm *.ogv);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>When the head moves</source>
        <translation>Al mover la cabeza</translation>
    </message>
    <message>
        <source>The tooth turns</source>
        <translation>Gira el diente</translation>
    </message>
    <message>
        <source>The screen is a window</source>
        <extracomment>The tooth is seen through the screen as through a window</extracomment>
        <translation>La pantalla es una ventana</translation>
    </message>
    <message>
        <source>Hold the tag %1 mm from the lens</source>
        <extracomment>%1: a length in millimetres</extracomment>
        <translation>Sostenga la marca a %1 mm del objetivo</translation>
    </message>
    <message>
        <source>Measure the field of view</source>
        <translation>Medir el campo de visión</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Imágenes por segundo</translation>
    </message>
    <message>
        <source>Its lens</source>
        <translation>Su objetivo</translation>
    </message>
    <message>
        <source>By its field of view</source>
        <translation>Por su campo de visión</translation>
    </message>
    <message>
        <source>A calibration file …</source>
        <translation>Un archivo de calibración …</translation>
    </message>
    <message>
        <source>A folder of images …</source>
        <translation>Una carpeta de imágenes …</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Elegir una carpeta de imágenes</translation>
    </message>
    <message>
        <source>Choose a calibration of the camera</source>
        <translation>Elegir una calibración de la cámara</translation>
    </message>
    <message>
        <source>Calibrations (*.json);;All files (*)</source>
        <translation>Calibraciones (*.json);;Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>ui::devices::TrackingText</name>
    <message>
        <source>Not available: head tracking is left out of this program.</source>
        <translation>No disponible: este programa no incluye el seguimiento de la cabeza.</translation>
    </message>
    <message>
        <source>Off.</source>
        <extracomment>Of head tracking</extracomment>
        <translation>Desactivado.</translation>
    </message>
    <message>
        <source>The camera is being opened.</source>
        <translation>Se está abriendo la cámara.</translation>
    </message>
    <message>
        <source>The camera sends no pictures.</source>
        <translation>La cámara no envía imágenes.</translation>
    </message>
    <message>
        <source>The pictures are dark.</source>
        <translation>Las imágenes están oscuras.</translation>
    </message>
    <message>
        <source>The pictures do not change.</source>
        <translation>Las imágenes no cambian.</translation>
    </message>
    <message>
        <source>Several tags with the number %1 are in the picture.</source>
        <extracomment>%1: a number</extracomment>
        <translation>Hay varios marcadores con el número %1 en la imagen.</translation>
    </message>
    <message>
        <source>The view follows your head.</source>
        <translation>La vista sigue su cabeza.</translation>
    </message>
    <message>
        <source>The tag is not in the picture.</source>
        <translation>El marcador no está en la imagen.</translation>
    </message>
    <message>
        <source>Install the libraries AprilTag and OpenCV and build Cusp again, or use a package that has them. The mouse turns the view without them.</source>
        <translation>Instale las bibliotecas AprilTag y OpenCV y vuelva a compilar Cusp, o use un paquete que las incluya. El ratón gira la vista sin ellas.</translation>
    </message>
    <message>
        <source>The view turns when you move your head. Print the tag, glue it to stiff card and wear it on a headband, tilted by about 20°. Then turn on “Follow my head”.</source>
        <translation>La vista gira cuando usted mueve la cabeza. Imprima el marcador, péguelo en cartón rígido y llévelo en una cinta para la cabeza, inclinado unos 20°. Después active «Seguir mi cabeza».</translation>
    </message>
    <message>
        <source>This takes a few seconds at most.</source>
        <translation>Tarda unos segundos como máximo.</translation>
    </message>
    <message>
        <source>%1 Cusp tries again by itself. The mouse turns the view meanwhile.</source>
        <extracomment>%1: what went wrong and what to do, one or two sentences</extracomment>
        <translation>%1 Cusp lo vuelve a intentar por sí solo. Mientras tanto, el ratón gira la vista.</translation>
    </message>
    <message>
        <source>Turn on more light, and check that no cover is in front of the camera.</source>
        <translation>Encienda más luz y compruebe que la cámara no esté tapada.</translation>
    </message>
    <message>
        <source>Unplug the camera and plug it in again, or choose another one.</source>
        <translation>Desconecte la cámara y vuelva a conectarla, o elija otra.</translation>
    </message>
    <message>
        <source>The view follows the largest one. Take the others out of the picture.</source>
        <translation>La vista sigue al más grande. Retire los demás de la imagen.</translation>
    </message>
    <message>
        <source>Sit as you do when you drill, look at the screen, and press “Straight ahead is here”.</source>
        <translation>Siéntese como cuando talla, mire la pantalla y pulse «El centro está aquí».</translation>
    </message>
    <message>
        <source>Turn to the camera so that the whole tag and its white border are in the picture. The tag must have the number %1. A lamp or a window behind you makes it too dark.</source>
        <extracomment>%1: a number; the button &quot;Print the tag …&quot; is on the same page</extracomment>
        <translation>Gírese hacia la cámara para que el marcador entero y su borde blanco estén en la imagen. El marcador debe tener el número %1. Una lámpara o una ventana detrás de usted lo oscurece demasiado.</translation>
    </message>
    <message>
        <source>The pictures are being opened.</source>
        <translation>Se están abriendo las imágenes.</translation>
    </message>
    <message>
        <source>The pictures cannot be read.</source>
        <translation>No se pueden leer las imágenes.</translation>
    </message>
    <message>
        <source>The last picture has been shown.</source>
        <translation>Se ha mostrado la última imagen.</translation>
    </message>
    <message>
        <source>To see the pictures again, turn “Follow my head” off and on.</source>
        <translation>Para ver las imágenes de nuevo, desactive y active «Seguir mi cabeza».</translation>
    </message>
    <message>
        <source>Choose other pictures, or a camera.</source>
        <translation>Elija otras imágenes o una cámara.</translation>
    </message>
    <message>
        <source>The pictures are nearly white.</source>
        <translation>Las imágenes están casi blancas.</translation>
    </message>
    <message>
        <source>Turn the camera away from lamps and windows, or lower its exposure.</source>
        <translation>Aparte la cámara de lámparas y ventanas o reduzca su exposición.</translation>
    </message>
    <message>
        <source>The camera gives %1 pictures a second, not %2: in little light it exposes for longer. Turn on more light, or choose smaller pictures.</source>
        <extracomment>%1 and %2: numbers</extracomment>
        <translation>La cámara da %1 imágenes por segundo en lugar de %2: con poca luz expone durante más tiempo. Encienda más luz o elija imágenes más pequeñas.</translation>
    </message>
</context>
<context>
    <name>ui::devices::Words</name>
    <message>
        <source>Not available: this program was built without force devices.</source>
        <translation>No disponible: este programa se compiló sin dispositivos de fuerza.</translation>
    </message>
    <message>
        <source>Not plugged in.</source>
        <translation>No está conectado.</translation>
    </message>
    <message>
        <source>Plugged in, but you are not allowed to open it.</source>
        <translation>Conectado, pero usted no tiene permiso para abrirlo.</translation>
    </message>
    <message>
        <source>Plugged in, but it cannot be opened.</source>
        <translation>Conectado, pero no se puede abrir.</translation>
    </message>
    <message>
        <source>Plugged in. It needs its firmware file.</source>
        <translation>Conectado. Necesita su archivo de firmware.</translation>
    </message>
    <message>
        <source>Loading the firmware: %1 %.</source>
        <extracomment>%1: a number from 0 to 100</extracomment>
        <translation>Cargando el firmware: %1 %.</translation>
    </message>
    <message>
        <source>Plugged in. Move the grip to home it.</source>
        <translation>Conectado. Mueva la empuñadura para referenciarlo.</translation>
    </message>
    <message>
        <source>Ready.</source>
        <translation>Listo.</translation>
    </message>
    <message>
        <source>It does not respond. The force is off.</source>
        <translation>No responde. La fuerza está desactivada.</translation>
    </message>
    <message>
        <source>Install the library libusb and build Cusp again, or use a package that has it.</source>
        <translation>Instale la biblioteca libusb y vuelva a compilar Cusp, o use un paquete que la incluya.</translation>
    </message>
    <message>
        <source>Plug in the USB cable and the mains adapter. The device is found by itself.</source>
        <translation>Conecte el cable USB y el adaptador de corriente. El dispositivo se detecta solo.</translation>
    </message>
    <message>
        <source>The firmware came with the software of the device and may not be shipped with Cusp.</source>
        <translation>El firmware venía con el software del dispositivo y no se puede distribuir con Cusp.</translation>
    </message>
    <message>
        <source>Check both plugs. The device continues by itself when it responds again.</source>
        <translation>Compruebe los dos enchufes. El dispositivo continúa por sí solo cuando vuelve a responder.</translation>
    </message>
    <message>
        <source>The last problem, which is over: %1</source>
        <extracomment>%1: what went wrong, a sentence</extracomment>
        <translation>El último problema, ya resuelto: %1</translation>
    </message>
    <message>
        <source>Drill</source>
        <extracomment>A button on the grip of a force device; pressed, the bur turns</extracomment>
        <translation>Fresar</translation>
    </message>
    <message>
        <source>Undo</source>
        <extracomment>A button on the grip of a force device</extracomment>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Mirror</source>
        <extracomment>A button on the grip of a force device: the dental mirror</extracomment>
        <translation>Espejo</translation>
    </message>
    <message>
        <source>Centre</source>
        <extracomment>A button on the grip of a force device: back over the tooth</extracomment>
        <translation>Centro</translation>
    </message>
    <message>
        <source>The calibration in %1 cannot be used, so the usual values are. Calibrate the device again.</source>
        <extracomment>%1: a path</extracomment>
        <translation>La calibración de %1 no se puede usar; se aplican los valores habituales. Calibre el dispositivo de nuevo.</translation>
    </message>
</context>
<context>
    <name>ui::inside::SectionView</name>
    <message>
        <source>Section through the bur</source>
        <translation>Corte a través de la fresa</translation>
    </message>
    <message>
        <source>Picture of the section</source>
        <translation>Imagen del corte</translation>
    </message>
    <message>
        <source>Cut the tooth in this direction, through the bur</source>
        <translation>Cortar el diente en esta dirección, a través de la fresa</translation>
    </message>
    <message>
        <source>Section along y</source>
        <translation>Corte a lo largo de y</translation>
    </message>
    <message>
        <source>Section along x</source>
        <translation>Corte a lo largo de x</translation>
    </message>
    <message>
        <source>Angle of the section, degrees</source>
        <translation>Ángulo del corte, grados</translation>
    </message>
    <message>
        <source>Turn the section about the bur (Shift+X: by 15 degrees)</source>
        <translation>Girar el corte alrededor de la fresa (Mayúsculas+X: 15 grados)</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Depth below original surface</source>
        <translation>Bajo la superficie original</translation>
    </message>
    <message>
        <source>Vertical depth of the tip below the original surface.</source>
        <translation>Profundidad vertical de la punta bajo la superficie original.</translation>
    </message>
    <message>
        <source>Dentin left over the pulp</source>
        <translation>Dentina sobre la pulpa</translation>
    </message>
    <message>
        <source>Sound dentin between the cut and the pulp straight below the tip. A dash: no pulp there.</source>
        <translation>Dentina sana entre el tallado y la pulpa, justo debajo de la punta. Una raya: allí no hay pulpa.</translation>
    </message>
    <message>
        <source>Straight down from the tip of the bur. A dash: no pulp there.</source>
        <translation>En vertical hacia abajo desde la punta de la fresa. Una raya: allí no hay pulpa.</translation>
    </message>
    <message>
        <source>The shortest way in any direction, also out of the plane of the picture.</source>
        <translation>El camino más corto en cualquier dirección, también fuera del plano de la imagen.</translation>
    </message>
    <message>
        <source>Section: %1</source>
        <translation>Corte: %1</translation>
    </message>
    <message>
        <source>Tip straight down to the pulp</source>
        <translation>Punta a pulpa, en vertical</translation>
    </message>
    <message>
        <source>Bur to the nearest pulp</source>
        <translation>Fresa a la pulpa más cercana</translation>
    </message>
</context>
<context>
    <name>ui::inside::XrayPage</name>
    <message>
        <source>X-ray</source>
        <translation>Radiografía</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>One tooth</source>
        <translation>Un diente</translation>
    </message>
    <message>
        <source>The whole tooth with its root</source>
        <translation>El diente entero con su raíz</translation>
    </message>
    <message>
        <source>Bitewing</source>
        <translation>Interproximal</translation>
    </message>
    <message>
        <source>Beam from the side</source>
        <translation>Haz desde el lado</translation>
    </message>
    <message>
        <source>Turns the beam about the tooth</source>
        <translation>Gira el haz alrededor del diente</translation>
    </message>
    <message>
        <source>Beam from above</source>
        <translation>Haz desde arriba</translation>
    </message>
    <message>
        <source>Tilts the beam; 0 is level</source>
        <translation>Inclina el haz; 0 es horizontal</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposición</translation>
    </message>
    <message>
        <source>More radiation: a darker film with less grain</source>
        <translation>Más radiación: una película más oscura con menos grano</translation>
    </message>
    <message>
        <source>Simulated: a parallel beam, no scatter, no bone and no gums.</source>
        <translation>Simulada: haz paralelo, sin dispersión, hueso ni encía.</translation>
    </message>
    <message>
        <source>Save the picture …</source>
        <translation>Guardar imagen …</translation>
    </message>
    <message>
        <source>Save both films side by side as a PNG file</source>
        <translation>Guardar ambas películas, una junto a otra, en un archivo PNG</translation>
    </message>
    <message>
        <source>X-ray: %1</source>
        <extracomment>%1 is &quot;Tooth 36&quot; or a file name</extracomment>
        <translation>Radiografía: %1</translation>
    </message>
    <message>
        <source>The crown between two sound neighbours made by Cusp, with contact points.</source>
        <translation>La corona entre dos vecinos sanos hechos por Cusp, con puntos de contacto.</translation>
    </message>
    <message>
        <source>Nothing in a scan says which side is mesial, so it gets no neighbours.</source>
        <translation>Nada en un escaneo indica qué lado es mesial, así que no tiene vecinos.</translation>
    </message>
    <message>
        <source>This tooth lies on a side, so it gets no neighbours.</source>
        <translation>Este diente está tumbado, así que no tiene vecinos.</translation>
    </message>
</context>
<context>
    <name>ui::people::AssignPage</name>
    <message>
        <source>Assign version %1 to new attempts</source>
        <translation>Asignar la versión %1 a los intentos nuevos</translation>
    </message>
    <message>
        <source>Assign the changed lesson to new attempts</source>
        <translation>Asignar la lección cambiada a los intentos nuevos</translation>
    </message>
    <message numerus="yes">
        <source>Assign %n changed lesson(s) to new attempts</source>
        <translation>
            <numerusform>Asignar %n lección cambiada a los intentos nuevos</numerusform>
            <numerusform>Asignar %n lecciones cambiadas a los intentos nuevos</numerusform>
        </translation>
    </message>
    <message>
        <source>Attempts that have been begun, and scores so far, stay with the version they were made with.</source>
        <translation>Los intentos empezados y las puntuaciones hasta ahora quedan con la versión con la que se hicieron.</translation>
    </message>
    <message>
        <source>%1 (a later version is available)</source>
        <translation>%1 (hay una versión posterior)</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <translation>%1, versión %2</translation>
    </message>
    <message>
        <source>given</source>
        <translation>asignada</translation>
    </message>
    <message>
        <source>given, due %1</source>
        <translation>asignada, vence: %1</translation>
    </message>
    <message>
        <source>%1, over</source>
        <translation>%1, vencida</translation>
    </message>
    <message>
        <source>There is no day when it is due</source>
        <translation>No hay fecha de entrega</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sin límite</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>%1 of %2 students</extracomment>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1 of %2 have passed, %3 have tried</source>
        <translation>%1 de %2 han aprobado, %3 lo han intentado</translation>
    </message>
    <message>
        <source>That was undone.</source>
        <translation>Eso se deshizo.</translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) assigned.</source>
        <translation>
            <numerusform>%n lección asignada.</numerusform>
            <numerusform>%n lecciones asignadas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) taken back; attempts stay.</source>
        <translation>
            <numerusform>%n lección retirada; los intentos se conservan.</numerusform>
            <numerusform>%n lecciones retiradas; los intentos se conservan.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) changed.</source>
        <translation>
            <numerusform>%n lección cambiada.</numerusform>
            <numerusform>%n lecciones cambiadas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Asignar</translation>
    </message>
    <message numerus="yes">
        <source>Assign %n lesson(s)</source>
        <translation>
            <numerusform>Asignar %n lección</numerusform>
            <numerusform>Asignar %n lecciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Assign lessons</source>
        <translation>Asignar lecciones</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>Search: a word, or the number of a tooth</source>
        <translation>Buscar: una palabra o el número de un diente</translation>
    </message>
    <message>
        <source>Search the lessons</source>
        <translation>Buscar en las lecciones</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Borrar la búsqueda</translation>
    </message>
    <message>
        <source>Lessons to assign</source>
        <translation>Lecciones para asignar</translation>
    </message>
    <message>
        <source>What %1 is to do</source>
        <extracomment>%1: name of a class</extracomment>
        <translation>Lo que %1 tiene que hacer</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>Entrega</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Intentos</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Aprobado</translation>
    </message>
    <message>
        <source>Nothing is assigned yet. Tick lessons on the left, say when they are due, and assign them; here you will see how many have passed.</source>
        <translation>Todavía no hay nada asignado. Marque lecciones a la izquierda, indique la fecha de entrega y asígnelas; aquí verá cuántos han aprobado.</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambiar</translation>
    </message>
    <message>
        <source>Change due date and attempts of the chosen lessons</source>
        <translation>Cambiar la entrega y los intentos de las lecciones elegidas</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Take the chosen lessons back</source>
        <translation>Retirar las lecciones elegidas</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) who have not passed have no attempts left: earlier ones count.</source>
        <translation>
            <numerusform>%n estudiante que no ha aprobado no tiene más intentos: los anteriores cuentan.</numerusform>
            <numerusform>%n estudiantes que no han aprobado no tienen más intentos: los anteriores cuentan.</numerusform>
        </translation>
    </message>
    <message>
        <source>No lesson fits. Search for another word.</source>
        <translation>Ninguna lección coincide. Busque otra palabra.</translation>
    </message>
</context>
<context>
    <name>ui::people::AssignTerms</name>
    <message>
        <source>Due on</source>
        <extracomment>A date follows</extracomment>
        <translation>Entrega el</translation>
    </message>
    <message>
        <source>There is a day when it is due</source>
        <translation>Hay fecha de entrega</translation>
    </message>
    <message>
        <source>Day when it is due</source>
        <translation>Fecha de entrega</translation>
    </message>
    <message>
        <source>Until the end of this day</source>
        <translation>Hasta el final de este día</translation>
    </message>
    <message>
        <source>Attempts</source>
        <extracomment>How often a lesson may be tried; a number follows</extracomment>
        <translation>Intentos</translation>
    </message>
    <message>
        <source>Attempts at most</source>
        <translation>Intentos como máximo</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sin límite</translation>
    </message>
    <message>
        <source>The month before</source>
        <translation>El mes anterior</translation>
    </message>
    <message>
        <source>The next month</source>
        <translation>El mes siguiente</translation>
    </message>
    <message>
        <source>This day is over: whoever has not passed is late at once.</source>
        <translation>Ese día ya pasó: quien no haya aprobado queda fuera de plazo al instante.</translation>
    </message>
    <message>
        <source>Each lesson keeps what you do not change here.</source>
        <translation>Cada lección conserva lo que no cambie aquí.</translation>
    </message>
</context>
<context>
    <name>ui::people::ClassCharts</name>
    <message>
        <source>Shown when %1 people have tried the lesson, so that nobody can be made out.</source>
        <translation>Se muestra cuando %1 personas han intentado la lección, para que no se reconozca a nadie.</translation>
    </message>
    <message>
        <source>Best score</source>
        <translation>Mejor puntuación</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Nota de aprobado</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>Estudiantes</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Distribución</translation>
    </message>
    <message numerus="yes">
        <source>Best scores of %n student(s)</source>
        <translation>
            <numerusform>Mejores puntuaciones de %n estudiante</numerusform>
            <numerusform>Mejores puntuaciones de %n estudiantes</numerusform>
        </translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Intento</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Learning curve</source>
        <translation>Curva de aprendizaje</translation>
    </message>
    <message>
        <source>Of those who made so many attempts</source>
        <translation>De quienes hicieron tantos intentos</translation>
    </message>
    <message>
        <source>Lost, % of what it counts</source>
        <translation>Perdido, % de lo que cuenta</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Criterio</translation>
    </message>
    <message>
        <source>%1: the class loses %2 % of its points</source>
        <translation>%1: el grupo pierde el %2 % de sus puntos</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>Dificultad</translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2 points: %n student(s)</source>
        <translation>
            <numerusform>%1 a %2 puntos: %n estudiante</numerusform>
            <numerusform>%1 a %2 puntos: %n estudiantes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 passed; first attempts: %3 points</source>
        <translation>%1 de %2 aprobaron; primeros intentos: %3 puntos</translation>
    </message>
    <message>
        <source>%1 of %2 passed, after %3 attempts on the average; first attempts: %4 points</source>
        <translation>%1 de %2 aprobaron, tras %3 intentos de media; primeros intentos: %4 puntos</translation>
    </message>
</context>
<context>
    <name>ui::people::ClassModel</name>
    <message numerus="yes">
        <source>%1, of which %n do not match their recordings and do not count</source>
        <translation>
            <numerusform>%1, de los que %n no coincide con su grabación y no cuenta</numerusform>
            <numerusform>%1, de los que %n no coinciden con sus grabaciones y no cuentan</numerusform>
        </translation>
    </message>
    <message>
        <source>stuck</source>
        <extracomment>Of a student</extracomment>
        <translation>sin avance</translation>
    </message>
    <message>
        <source>no login</source>
        <translation>sin acceso</translation>
    </message>
    <message>
        <source>new</source>
        <extracomment>Of a student who has no attempt yet</extracomment>
        <translation>sin intentos</translation>
    </message>
    <message>
        <source>%1: no attempt yet</source>
        <translation>%1: aún sin intentos</translation>
    </message>
    <message>
        <source>%1: last attempt %2</source>
        <translation>%1: último intento %2</translation>
    </message>
    <message>
        <source>%1: not tried</source>
        <translation>%1: sin intentar</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n intento</numerusform>
            <numerusform>%n intentos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: best %2, passed, %3, last %4</source>
        <extracomment>%1: student and lesson; %2: points; %3: &quot;4 attempts&quot;; %4: a date</extracomment>
        <translation>%1: mejor %2, aprobado, %3, último %4</translation>
    </message>
    <message>
        <source>%1: best %2, not passed, %3, last %4</source>
        <translation>%1: mejor %2, no aprobado, %3, último %4</translation>
    </message>
    <message>
        <source>Last</source>
        <extracomment>Column: when the student&apos;s last attempt was</extracomment>
        <translation>Último</translation>
    </message>
    <message>
        <source>%1, %2: never logged in</source>
        <translation>%1, %2: nunca ha iniciado sesión</translation>
    </message>
    <message>
        <source>%1, %2: last login %3</source>
        <translation>%1, %2: último inicio de sesión %3</translation>
    </message>
    <message>
        <source>user name</source>
        <translation>nombre de usuario</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>needs</source>
        <translation>necesita</translation>
    </message>
    <message>
        <source>last login, UTC</source>
        <translation>último inicio de sesión, UTC</translation>
    </message>
    <message>
        <source>last attempt, UTC</source>
        <translation>último intento, UTC</translation>
    </message>
    <message>
        <source>%1: best score</source>
        <translation>%1: mejor puntuación</translation>
    </message>
    <message>
        <source>%1: attempts</source>
        <translation>%1: intentos</translation>
    </message>
    <message>
        <source>%1: passed</source>
        <translation>%1: aprobado</translation>
    </message>
    <message>
        <source>late</source>
        <extracomment>Of a student who has not passed a lesson that is overdue</extracomment>
        <translation>con retraso</translation>
    </message>
    <message>
        <source>%1: not tried, and overdue</source>
        <translation>%1: sin intentar y con el plazo vencido</translation>
    </message>
    <message>
        <source>%1: best %2, not passed and overdue, %3, last %4</source>
        <translation>%1: mejor %2, no aprobado y con el plazo vencido, %3, último %4</translation>
    </message>
    <message>
        <source>due %1</source>
        <extracomment>%1: a date</extracomment>
        <translation>entrega: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) at most</source>
        <translation>
            <numerusform>%n intento como máximo</numerusform>
            <numerusform>%n intentos como máximo</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 passed</source>
        <translation>%1 de %2 aprobaron</translation>
    </message>
    <message>
        <source>out of tries</source>
        <extracomment>Of a student who has no attempts left at a lesson that they have not passed</extracomment>
        <translation>sin intentos</translation>
    </message>
    <message>
        <source>%1: best %2, not passed and no attempts left, %3, last %4</source>
        <translation>%1: mejor %2, no aprobado y sin intentos restantes, %3, último %4</translation>
    </message>
    <message>
        <source>%1: begun, without a score so far, and no attempts left</source>
        <translation>%1: empezado, sin puntuación hasta ahora y sin más intentos</translation>
    </message>
    <message>
        <source>%1: begun, without a score so far, and overdue</source>
        <translation>%1: empezado, sin puntuación hasta ahora y con el plazo vencido</translation>
    </message>
    <message>
        <source>%1: begun, without a score so far</source>
        <translation>%1: empezado, sin puntuación hasta ahora</translation>
    </message>
    <message>
        <source>disabled</source>
        <extracomment>Of a student whose account is closed</extracomment>
        <translation>desactivado</translation>
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
        <translation>Mostrar quién hizo tres intentos seguidos de una lección sin aprobar y sin mejorar cinco puntos</translation>
    </message>
    <message>
        <source>Show who has never logged in</source>
        <translation>Mostrar quién no ha iniciado sesión nunca</translation>
    </message>
    <message>
        <source>Show who has logged in and has no graded attempt yet</source>
        <translation>Mostrar quién ha iniciado sesión y aún no tiene ningún intento calificado</translation>
    </message>
    <message>
        <source>Nobody needs you just now</source>
        <translation>Nadie le necesita en este momento</translation>
    </message>
    <message numerus="yes">
        <source>%n need(s) you:</source>
        <translation>
            <numerusform>%n le necesita:</numerusform>
            <numerusform>%n le necesitan:</numerusform>
        </translation>
    </message>
    <message>
        <source>Here you will see your classes: who needs you, and how everybody does at every lesson. An administrator gives you a class.</source>
        <translation>Aquí verá sus grupos: quién le necesita y cómo le va a cada cual en cada lección. Un administrador le asigna un grupo.</translation>
    </message>
    <message>
        <source>Nobody is in this class yet. Students are entered by an administrator, one by one or from a list.</source>
        <translation>Todavía no hay nadie en este grupo. Un administrador registra a los estudiantes, uno a uno o desde una lista.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Guardado: %1</translation>
    </message>
    <message>
        <source>%1 could not be written (%2). Try another folder.</source>
        <translation>%1 no se pudo escribir (%2). Pruebe con otra carpeta.</translation>
    </message>
    <message>
        <source>Save the matrix</source>
        <translation>Guardar la matriz</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>How the class does at</source>
        <translation>Cómo le va al grupo en</translation>
    </message>
    <message>
        <source>Lesson whose charts are shown</source>
        <translation>Lección cuyos gráficos se muestran</translation>
    </message>
    <message>
        <source>Best scores, students by lessons</source>
        <translation>Mejores puntuaciones, estudiantes por lecciones</translation>
    </message>
    <message>
        <source>Assign lessons</source>
        <translation>Asignar lecciones</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>Save as PDF …</source>
        <translation>Guardar como PDF …</translation>
    </message>
    <message>
        <source>Print …</source>
        <translation>Imprimir …</translation>
    </message>
    <message>
        <source>Save the matrix as a table (CSV) …</source>
        <translation>Guardar la matriz como tabla (CSV) …</translation>
    </message>
    <message>
        <source>Show who has not passed a lesson that is overdue</source>
        <translation>Mostrar quién no ha aprobado una lección con el plazo vencido</translation>
    </message>
    <message>
        <source>%1 (%2 of %3 passed)</source>
        <extracomment>%1: a lesson; %2 of the %3 who tried it</extracomment>
        <translation>%1 (%2 de %3 aprobaron)</translation>
    </message>
    <message>
        <source>There is no class yet. Make one, and enter its teachers and students: then you see here who needs help, and how everybody does at every lesson.</source>
        <translation>Todavía no hay ninguna clase. Cree una y registre a sus docentes y estudiantes: entonces verá aquí quién necesita ayuda y cómo le va a cada uno en cada lección.</translation>
    </message>
    <message>
        <source>Nobody is in this class yet. Enter its students, one by one or from a list.</source>
        <translation>Todavía no hay nadie en esta clase. Registre a sus estudiantes, uno a uno o desde una lista.</translation>
    </message>
    <message>
        <source>People and classes</source>
        <extracomment>Where people are entered and classes are made</extracomment>
        <translation>Personas y clases</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1: a class; %2: a lesson</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Show who has no attempts left at a lesson that is not passed. More can be allowed under Assign lessons.</source>
        <translation>Muestra quién no tiene más intentos en una lección no aprobada. En «Asignar lecciones» se pueden permitir más.</translation>
    </message>
    <message>
        <source>Best score of each student; a tick: passed; ▲: overdue, or no attempts left; ⚠: does not match its recording. A heading sorts, once more the other way, then by name. A cell opens the attempts.</source>
        <translation>Mejor puntuación de cada estudiante; una marca: aprobado; ▲: plazo vencido o sin más intentos; ⚠: no coincide con su grabación. Un encabezado ordena, otra vez al revés, y luego por nombre. Una celda abre los intentos.</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Borrar la búsqueda</translation>
    </message>
    <message numerus="yes">
        <source>%Ln student(s)</source>
        <translation>
            <numerusform>%Ln estudiante</numerusform>
            <numerusform>%Ln estudiantes</numerusform>
        </translation>
    </message>
    <message>
        <source>Search: a student</source>
        <translation>Buscar: un estudiante</translation>
    </message>
    <message>
        <source>%1 F5 reads the class again; Cusp tries it every ten seconds, too.</source>
        <extracomment>%1: that a class could not be read, and why</extracomment>
        <translation>%1 F5 vuelve a leer el grupo; Cusp también lo intenta cada diez segundos.</translation>
    </message>
    <message>
        <source>The class is being read …</source>
        <translation>Leyendo el grupo …</translation>
    </message>
    <message>
        <source>%1 F5 reads the classes again; Cusp tries it every ten seconds, too.</source>
        <translation>%1 F5 vuelve a leer los grupos; Cusp también lo intenta cada diez segundos.</translation>
    </message>
    <message>
        <source>The classes are being read …</source>
        <translation>Leyendo los grupos …</translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryCharts</name>
    <message>
        <source>Attempt %1, %2</source>
        <extracomment>%1: a count; %2: date and time</extracomment>
        <translation>Intento %1, %2</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Intento</translation>
    </message>
    <message>
        <source>The newest %1 of %2 attempts</source>
        <translation>Los %1 intentos más recientes de %2</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n intento</numerusform>
            <numerusform>%n intentos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 points, passed</source>
        <translation>%1 puntos, aprobado</translation>
    </message>
    <message>
        <source>%1 points, not passed</source>
        <translation>%1 puntos, no aprobado</translation>
    </message>
    <message>
        <source>(machine: %1)</source>
        <translation>(máquina: %1)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: which attempt; %2: what it came to</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Middle half</source>
        <translation>Mitad central</translation>
    </message>
    <message>
        <source>Class median</source>
        <translation>Mediana del grupo</translation>
    </message>
    <message>
        <source>Attempt %1: median %3, middle half %4 to %5, %2 people</source>
        <extracomment>Of a class; %1: a count of attempts, %2: of people, %3 to %5: points</extracomment>
        <translation>Intento %1: mediana %3, mitad central de %4 a %5, %2 personas</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Puntuación</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Aprobado</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>No aprobado</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Nota de aprobado</translation>
    </message>
    <message>
        <source>After the first graded attempt its score is here, and then how it goes on.</source>
        <translation>Tras el primer intento calificado, aquí está su puntuación, y luego cómo evoluciona.</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Criterio</translation>
    </message>
    <message>
        <source>What costs points</source>
        <translation>Qué cuesta puntos</translation>
    </message>
    <message numerus="yes">
        <source>Average of the last %n attempt(s)</source>
        <translation>
            <numerusform>De %n intento</numerusform>
            <numerusform>Media de los últimos %n intentos</numerusform>
        </translation>
    </message>
    <message>
        <source>After the first graded attempt you see here which criterion costs most.</source>
        <translation>Tras el primer intento calificado verá aquí qué criterio cuesta más.</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>Minutos</translation>
    </message>
    <message>
        <source>%1 min</source>
        <extracomment>%1: &quot;12:07&quot;</extracomment>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>After the first graded attempt you see here how long it took.</source>
        <translation>Tras el primer intento calificado verá aquí cuánto duró.</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Máxima</translation>
    </message>
    <message>
        <source>mean %1 N, highest %2 N while cutting</source>
        <translation>media %1 N, máxima %2 N al tallar</translation>
    </message>
    <message>
        <source>Newtons</source>
        <translation>Newtons</translation>
    </message>
    <message>
        <source>Force while cutting</source>
        <translation>Fuerza al tallar</translation>
    </message>
    <message>
        <source>After the first graded attempt you see here how hard the bur was pressed.</source>
        <translation>Tras el primer intento calificado verá aquí con cuánta fuerza se presionó la fresa.</translation>
    </message>
    <message>
        <source>%1 in %2 min</source>
        <translation>%1 en %2 min</translation>
    </message>
    <message>
        <source>Class median, time</source>
        <translation>Mediana del grupo, tiempo</translation>
    </message>
    <message>
        <source>Class median, points</source>
        <translation>Mediana del grupo, puntos</translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation>Rapidez y precisión</translation>
    </message>
    <message>
        <source>Good and quick is at the top left</source>
        <translation>Lo bueno y rápido está arriba a la izquierda</translation>
    </message>
    <message>
        <source>After the first graded attempt you see here time against points.</source>
        <translation>Tras el primer intento calificado verá aquí el tiempo frente a los puntos.</translation>
    </message>
    <message numerus="yes">
        <source>Of the last %n attempt(s), each in those where it counts</source>
        <translation>
            <numerusform>Del último %n intento, si cuenta en él</numerusform>
            <numerusform>De los últimos %n intentos, cada uno en los que cuenta</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 points lost</source>
        <extracomment>%1: a criterion; %2: a number</extracomment>
        <translation>%1: %2 puntos perdidos</translation>
    </message>
    <message>
        <source>Points lost</source>
        <translation>Puntos perdidos</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryModel</name>
    <message>
        <source>practice</source>
        <translation>práctica</translation>
    </message>
    <message>
        <source>in doubt</source>
        <translation>en duda</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>aprobado</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>no aprobado</translation>
    </message>
    <message>
        <source>Given by an instructor. The machine&apos;s score: %1</source>
        <translation>Dada por un docente. La puntuación de la máquina: %1</translation>
    </message>
    <message>
        <source>Mean and highest force while cutting</source>
        <translation>Fuerza media y máxima al tallar</translation>
    </message>
    <message>
        <source>%1, given by an instructor; the machine&apos;s score: %2</source>
        <translation>%1, dada por un docente; la puntuación de la máquina: %2</translation>
    </message>
    <message>
        <source>Date</source>
        <extracomment>Column of a table of attempts</extracomment>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Puntuación</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Force, N</source>
        <extracomment>Newtons</extracomment>
        <translation>Fuerza, N</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nuevo</translation>
    </message>
    <message>
        <source>read</source>
        <extracomment>Of a teacher&apos;s feedback: to be read yet; not read by the student; read already</extracomment>
        <translation>leído</translation>
    </message>
    <message>
        <source>A teacher has written about this attempt or given another score: open its grade to read it</source>
        <translation>Un profesor ha escrito sobre este intento o le ha dado otra nota: abra la calificación para leerlo</translation>
    </message>
    <message>
        <source>Feedback</source>
        <extracomment>Column of a table of attempts: what a teacher has said</extracomment>
        <translation>Comentarios</translation>
    </message>
    <message>
        <source>unread</source>
        <translation>sin leer</translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryPage</name>
    <message>
        <source>Criteria</source>
        <translation>Criterios</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Todas las lecciones</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1: a lesson; %2: how many attempts</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n intento</numerusform>
            <numerusform>%n intentos</numerusform>
        </translation>
    </message>
    <message>
        <source>Of this attempt no recording was kept.</source>
        <translation>De este intento no se conservó ninguna grabación.</translation>
    </message>
    <message>
        <source>See again how it was done</source>
        <translation>Ver de nuevo cómo se hizo</translation>
    </message>
    <message>
        <source>Attempts of %1</source>
        <translation>Intentos de %1</translation>
    </message>
    <message>
        <source>Show the attempts at this lesson</source>
        <translation>Mostrar los intentos de esta lección</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Intentos</translation>
    </message>
    <message>
        <source>Open grade</source>
        <translation>Abrir la calificación</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>No attempts yet</source>
        <translation>Aún no hay intentos</translation>
    </message>
    <message>
        <source>%1 has no attempts yet</source>
        <translation>%1 aún no tiene intentos</translation>
    </message>
    <message>
        <source>Here you will find every attempt that was graded: its score, what cost points, time and force, and how it goes from attempt to attempt. Do a lesson and have it graded.</source>
        <translation>Aquí encontrará cada intento calificado: su puntuación, qué costó puntos, tiempo y fuerza, y cómo evoluciona de intento en intento. Haga una lección y pida que se califique.</translation>
    </message>
    <message>
        <source>As soon as an attempt has been graded it is here.</source>
        <translation>En cuanto se califique un intento, estará aquí.</translation>
    </message>
    <message>
        <source>Speed</source>
        <extracomment>A chart of speed and accuracy</extracomment>
        <translation>Ritmo</translation>
    </message>
    <message>
        <source>%1, begun %2</source>
        <extracomment>%1: an exam; %2: when it was begun</extracomment>
        <translation>%1, comenzado el %2</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Exams that have no score: %1</source>
        <translation>Exámenes sin puntuación: %1</translation>
    </message>
    <message>
        <source>See what cost points, and where</source>
        <translation>Ver qué costó puntos y dónde</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>Mis intentos</translation>
    </message>
    <message>
        <source>See what cost points</source>
        <translation>Ver qué costó puntos</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) wait on this computer, and stand here when the school has them.</source>
        <translation>
            <numerusform>%n intento espera en este ordenador y aparecerá aquí cuando la escuela lo tenga.</numerusform>
            <numerusform>%n intentos esperan en este ordenador y aparecerán aquí cuando la escuela los tenga.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::kit::ListTable</name>
    <message>
        <source>Corner of the table</source>
        <translation>Esquina de la tabla</translation>
    </message>
    <message>
        <source>Sorted by: %1, from the least</source>
        <extracomment>%1: a heading</extracomment>
        <translation>Ordenado por: %1, de menor a mayor</translation>
    </message>
    <message>
        <source>Sorted by: %1, from the most</source>
        <translation>Ordenado por: %1, de mayor a menor</translation>
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
        <translation>Inicie sesión para guardar sus intentos.</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Iniciar sesión</translation>
    </message>
    <message>
        <source>Choose a password</source>
        <translation>Elegir una contraseña</translation>
    </message>
    <message>
        <source>The one-time code is correct. Choose your own password: at least eight characters.</source>
        <translation>El código de un solo uso es correcto. Elija su propia contraseña: al menos ocho caracteres.</translation>
    </message>
    <message>
        <source>Set the password</source>
        <translation>Establecer la contraseña</translation>
    </message>
    <message>
        <source>Welcome to Cusp</source>
        <translation>Le damos la bienvenida a Cusp</translation>
    </message>
    <message>
        <source>Create the school</source>
        <translation>Crear la escuela</translation>
    </message>
    <message>
        <source>Locked by %1</source>
        <extracomment>%1: the name a user logs in with</extracomment>
        <translation>Bloqueado por %1</translation>
    </message>
    <message>
        <source>The work in progress is unchanged.</source>
        <translation>El trabajo en curso no ha cambiado.</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Desbloquear</translation>
    </message>
    <message>
        <source>Switch user</source>
        <translation>Cambiar de usuario</translation>
    </message>
    <message>
        <source>Practise without login</source>
        <translation>Practicar sin iniciar sesión</translation>
    </message>
    <message>
        <source>Username</source>
        <translation>Nombre de usuario</translation>
    </message>
    <message>
        <source>Given name</source>
        <translation>Nombre de pila</translation>
    </message>
    <message>
        <source>Family name</source>
        <translation>Apellidos</translation>
    </message>
    <message>
        <source>Password or one-time code</source>
        <translation>Contraseña o código de un solo uso</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Contraseña</translation>
    </message>
    <message>
        <source>Confirm password</source>
        <translation>Confirmar contraseña</translation>
    </message>
    <message>
        <source>Drill and get a grade; nothing is saved</source>
        <translation>Tallar y recibir calificación; no se guarda nada</translation>
    </message>
    <message>
        <source>The passwords do not match. Type the second one again.</source>
        <translation>Las contraseñas no coinciden. Escriba la segunda otra vez.</translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation>Idioma: %1</translation>
    </message>
    <message>
        <source>Choose the language</source>
        <translation>Elegir el idioma</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Intentar de nuevo</translation>
    </message>
    <message>
        <source>Restore backup (%1)</source>
        <extracomment>%1: day and time</extracomment>
        <translation>Restaurar copia (%1)</translation>
    </message>
    <message>
        <source>Attempts on this computer that are in no backup are added again. Changes that teachers and admins made after the backup are lost. The current file is kept next to the restored one.</source>
        <translation>Los intentos de este ordenador que no están en ninguna copia se añaden de nuevo. Los cambios que docentes y administradores hicieron después de la copia se pierden. El archivo actual se conserva junto al restaurado.</translation>
    </message>
    <message>
        <source>Change your password</source>
        <translation>Cambiar su contraseña</translation>
    </message>
    <message>
        <source>At least eight characters.</source>
        <translation>Al menos ocho caracteres.</translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation>Cambiar la contraseña</translation>
    </message>
    <message>
        <source>Cancel</source>
        <extracomment>Back, without having changed the password</extracomment>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Change my password</source>
        <translation>Cambiar mi contraseña</translation>
    </message>
    <message>
        <source>Current password</source>
        <translation>Contraseña actual</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>Contraseña nueva</translation>
    </message>
    <message>
        <source>Confirm new password</source>
        <translation>Confirmar contraseña nueva</translation>
    </message>
    <message>
        <source>This name contains invisible characters. Type it again.</source>
        <translation>Este nombre contiene caracteres invisibles. Escríbalo de nuevo.</translation>
    </message>
    <message>
        <source>The school&apos;s database was not found: %1 has no users. Restore the backup below, or create a new school and become its admin.</source>
        <translation>No se encontró la base de datos de la escuela: %1 no contiene usuarios. Restaure la copia de seguridad abajo o cree una escuela nueva, de la que será administrador.</translation>
    </message>
    <message>
        <source>Save the attempt just graded as mine</source>
        <translation>Guardar como mío el intento recién calificado</translation>
    </message>
    <message>
        <source>%1: saved for the user who logs in. If the box is not checked, the attempt is not saved.</source>
        <extracomment>%1: a lesson or a tooth</extracomment>
        <translation>%1: se guarda para quien inicia sesión. Si la casilla no está marcada, el intento no se guarda.</translation>
    </message>
    <message>
        <source>The work in progress is unchanged, but the exam time keeps running.</source>
        <translation>El trabajo en curso no ha cambiado, pero el tiempo del examen sigue corriendo.</translation>
    </message>
    <message>
        <source>Waiting for the school&apos;s database …</source>
        <translation>Esperando la base de datos de la escuela …</translation>
    </message>
    <message>
        <source>Opening the school&apos;s database …</source>
        <translation>Abriendo la base de datos de la escuela …</translation>
    </message>
    <message>
        <source>A username has 1 to 64 characters: the letters a to z, digits and . _ - @.</source>
        <translation>Un nombre de usuario tiene de 1 a 64 caracteres: letras de la a a la z, cifras y . _ - @.</translation>
    </message>
    <message>
        <source>Set up a school</source>
        <translation>Crear una escuela</translation>
    </message>
    <message>
        <source>Drill a virtual tooth and see what to do better.</source>
        <translation>Talle un diente virtual y vea qué puede mejorar.</translation>
    </message>
    <message>
        <source>No users yet. You become the admin, and add teachers and students next.</source>
        <translation>Aún no hay usuarios. Usted será el administrador y añadirá después profesores y estudiantes.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
</context>
<context>
    <name>ui::scoring::CommentsPanel</name>
    <message>
        <source>%1 points, passed</source>
        <translation>%1 puntos, aprobado</translation>
    </message>
    <message>
        <source>%1 points, not passed</source>
        <translation>%1 puntos, no aprobado</translation>
    </message>
    <message>
        <source>Given by %1. The machine&apos;s score: %2 points.</source>
        <translation>Dada por %1. La puntuación de la máquina: %2 puntos.</translation>
    </message>
    <message>
        <source>The machine&apos;s score</source>
        <translation>La puntuación de la máquina</translation>
    </message>
    <message>
        <source>at %1 of the replay</source>
        <translation>en %1 de la reproducción</translation>
    </message>
    <message>
        <source>Pin the comment to this moment</source>
        <translation>Fijar el comentario a este momento</translation>
    </message>
    <message>
        <source>at the marked place</source>
        <translation>en el lugar marcado</translation>
    </message>
    <message>
        <source>Pin the comment to this place</source>
        <translation>Fijar el comentario a este lugar</translation>
    </message>
    <message>
        <source>▶ %1</source>
        <extracomment>%1: minutes and seconds</extracomment>
        <translation>▶ %1</translation>
    </message>
    <message>
        <source>Show the moment %1</source>
        <translation>Mostrar el momento %1</translation>
    </message>
    <message>
        <source>◎ place</source>
        <translation>◎ lugar</translation>
    </message>
    <message>
        <source>Show the place</source>
        <translation>Mostrar el lugar</translation>
    </message>
    <message>
        <source>gave %1 points: %2</source>
        <translation>dio %1 puntos: %2</translation>
    </message>
    <message>
        <source>let the machine&apos;s score count again: %1</source>
        <translation>devolvió la validez a la puntuación de la máquina: %1</translation>
    </message>
    <message>
        <source>Write a comment</source>
        <translation>Escriba un comentario</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>Add comment</source>
        <translation>Añadir comentario</translation>
    </message>
    <message>
        <source>Give another score</source>
        <translation>Dar otra puntuación</translation>
    </message>
    <message>
        <source>Points given</source>
        <translation>Puntos dados</translation>
    </message>
    <message>
        <source> points</source>
        <extracomment>Behind a number</extracomment>
        <translation> puntos</translation>
    </message>
    <message>
        <source>Reason, which the student reads</source>
        <translation>Motivo, que el estudiante lee</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Give this score</source>
        <translation>Dar esta puntuación</translation>
    </message>
    <message>
        <source>Back to the machine&apos;s score</source>
        <translation>Volver a la puntuación de la máquina</translation>
    </message>
    <message>
        <source>To pin it, click a place on the tooth above, or play the attempt to a moment and come back.</source>
        <translation>Para fijarlo, haga clic arriba en un lugar del diente, o reproduzca el intento hasta un momento y vuelva.</translation>
    </message>
    <message>
        <source>To pin it to a moment, play the attempt to there and come back.</source>
        <translation>Para fijarlo a un momento, reproduzca el intento hasta ahí y vuelva.</translation>
    </message>
    <message>
        <source>To pin it to a place, click on the tooth above.</source>
        <translation>Para fijarlo a un lugar, haga clic arriba en el diente.</translation>
    </message>
    <message numerus="yes">
        <source>Room for %Ln more character(s)</source>
        <translation>
            <numerusform>Cabe %Ln carácter más</numerusform>
            <numerusform>Caben %Ln caracteres más</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln character(s) too many: a comment has at most %1.</source>
        <translation>
            <numerusform>Sobra %Ln carácter: un comentario tiene %1 como máximo.</numerusform>
            <numerusform>Sobran %Ln caracteres: un comentario tiene %1 como máximo.</numerusform>
        </translation>
    </message>
    <message>
        <source>This comment had been taken back already.</source>
        <translation>Este comentario ya se había retirado.</translation>
    </message>
    <message>
        <source>Taken back. Nobody is shown it any more. Its words are here again, to be corrected or cleared.</source>
        <translation>Retirado. Ya nadie ve el comentario. Su texto está aquí otra vez, para corregirlo o borrarlo.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Take back your comment of %1</source>
        <extracomment>%1: when it was written</extracomment>
        <translation>Retirar su comentario del %1</translation>
    </message>
    <message>
        <source>Taken back. Nobody is shown it any more. Its words are here again, below what you are writing.</source>
        <translation>Retirado. Ya no lo ve nadie. Sus palabras están aquí de nuevo, debajo de lo que usted escribe.</translation>
    </message>
    <message>
        <source>A score has 0 to 100 points.</source>
        <translation>Una puntuación tiene de 0 a 100 puntos.</translation>
    </message>
    <message>
        <source>Nobody has written anything yet. Where there is a recording, a comment can be pinned to a moment of the replay and to a place on the tooth.</source>
        <translation>Nadie ha escrito nada todavía. Donde hay una grabación, un comentario se puede fijar a un momento de la reproducción y a un lugar del diente.</translation>
    </message>
    <message>
        <source>Nobody has written anything yet. What an instructor says is here.</source>
        <translation>Nadie ha escrito nada todavía. Aquí está lo que dice un docente.</translation>
    </message>
    <message numerus="yes">
        <source>%n comment(s) were typed and are not added yet.</source>
        <translation>
            <numerusform>Se ha escrito %n comentario que aún no se ha añadido.</numerusform>
            <numerusform>Se han escrito %n comentarios que aún no se han añadido.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n score(s) were typed and are not given yet.</source>
        <translation>
            <numerusform>Se ha escrito %n puntuación que aún no se ha asignado.</numerusform>
            <numerusform>Se han escrito %n puntuaciones que aún no se han asignado.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::people::WelcomeChoices</name>
    <message>
        <source>Practise now</source>
        <translation>Practicar ahora</translation>
    </message>
    <message>
        <source>A tooth with decay is ready. Nothing is saved.</source>
        <translation>Hay un diente con caries listo. No se guarda nada.</translation>
    </message>
    <message>
        <source>Set up a school</source>
        <translation>Crear una escuela</translation>
    </message>
    <message>
        <source>Users, lessons and score histories. You become the admin.</source>
        <translation>Usuarios, lecciones e historial de notas. Usted será el administrador.</translation>
    </message>
</context>
<context>
    <name>ui::text::PeopleTexts</name>
    <message>
        <source>This attempt was made with another version of the lesson than the one that was assigned. It is practice and does not count.</source>
        <translation>Este intento se hizo con otra versión de la lección que la asignada. Es práctica y no cuenta.</translation>
    </message>
    <message>
        <source>The recording is missing, damaged or not of this attempt. The score does not count until a teacher gives one.</source>
        <translation>La grabación falta, está dañada o no es de este intento. La puntuación no cuenta hasta que un docente dé una.</translation>
    </message>
    <message>
        <source>The recording gives another result than the one that was reported. The score does not count until a teacher gives one.</source>
        <translation>La grabación da otro resultado que el comunicado. La puntuación no cuenta hasta que un docente dé una.</translation>
    </message>
    <message>
        <source>This exam was not begun as its recording says: its start is missing here, or less time has passed since than was worked. The score does not count until a teacher gives one.</source>
        <translation>Este examen no empezó como dice su grabación: falta aquí su comienzo, o desde entonces pasó menos tiempo del trabajado. La puntuación no cuenta hasta que un docente dé una.</translation>
    </message>
    <message>
        <source>Free practice</source>
        <translation>Práctica libre</translation>
    </message>
    <message>
        <source>today</source>
        <translation>hoy</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>ayer</translation>
    </message>
    <message>
        <source>d MMM</source>
        <extracomment>A day without its year, as QLocale::toString() takes it: &quot;27 Nov&quot;. German &quot;d. MMM&quot;, Japanese &quot;M月d日&quot;</extracomment>
        <translation>d MMM</translation>
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
        <translation>Avance según la fuerza</translation>
    </message>
    <message>
        <source>%1 %2 mm/s</source>
        <extracomment>%1 is a material, %2 a speed</extracomment>
        <translation>%1 %2 mm/s</translation>
    </message>
    <message>
        <source>Straight down with %1 N</source>
        <extracomment>%1 is a force</extracomment>
        <translation>En vertical hacia abajo con %1 N</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Fuerza, N</translation>
    </message>
    <message>
        <source>Feed, mm/s</source>
        <translation>Avance, mm/s</translation>
    </message>
    <message>
        <source>dashed: as it was kept</source>
        <translation>discontinua: como está guardado</translation>
    </message>
    <message>
        <source>%1, as it was kept</source>
        <extracomment>%1 is a material; its line is that of the preset before it was changed</extracomment>
        <translation>%1, como se guardó</translation>
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
        <translation>Tasa</translation>
    </message>
    <message>
        <source>Cuts from</source>
        <extracomment>The force from which on a material is cut</extracomment>
        <translation>Umbral</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>De %1.</translation>
    </message>
</context>
<context>
    <name>ui::presets::PresetsPage</name>
    <message>
        <source>Hardness presets</source>
        <translation>Ajustes de dureza</translation>
    </message>
    <message>
        <source>Hardness presets and their versions</source>
        <translation>Ajustes de dureza y sus versiones</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Importar …</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>Importar un ajuste</translation>
    </message>
    <message>
        <source>Read a preset from a file and keep it here</source>
        <translation>Leer un ajuste de un archivo y conservarlo aquí</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportar …</translation>
    </message>
    <message>
        <source>Export this version</source>
        <translation>Exportar esta versión</translation>
    </message>
    <message>
        <source>Write the chosen version to a file, for another school</source>
        <translation>Escribir la versión elegida en un archivo, para otra escuela</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nombre del ajuste</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Notes: what it is for</source>
        <translation>Notas: para qué sirve</translation>
    </message>
    <message>
        <source>Simple</source>
        <translation>Sencillo</translation>
    </message>
    <message>
        <source>A few sliders</source>
        <translation>Unos pocos controles</translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation>Todos los números</translation>
    </message>
    <message>
        <source>Every number with its range</source>
        <translation>Cada número con su intervalo</translation>
    </message>
    <message>
        <source>Feed of</source>
        <translation>Avance de</translation>
    </message>
    <message>
        <source>Bur whose feed is drawn</source>
        <translation>Fresa cuyo avance se dibuja</translation>
    </message>
    <message>
        <source>Try on a block</source>
        <translation>Probar en un bloque</translation>
    </message>
    <message>
        <source>Drill a block of enamel, dentin and soft caries with it</source>
        <translation>Fresar con él un bloque de esmalte, dentina y caries blanda</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Duplicate under another name</source>
        <translation>Duplicar con otro nombre</translation>
    </message>
    <message>
        <source>Begin a preset of another name with these numbers</source>
        <translation>Empezar un ajuste con otro nombre y estos números</translation>
    </message>
    <message>
        <source>Use for practice</source>
        <translation>Usar para practicar</translation>
    </message>
    <message>
        <source>Use this version for practice</source>
        <translation>Usar esta versión para practicar</translation>
    </message>
    <message>
        <source>Every tooth feels like this, unless its lesson says otherwise</source>
        <translation>Todos los dientes se notan así, salvo que su lección diga otra cosa</translation>
    </message>
    <message>
        <source>Compare blind with</source>
        <translation>Comparar a ciegas con</translation>
    </message>
    <message>
        <source>Preset to compare with</source>
        <translation>Ajuste con el que comparar</translation>
    </message>
    <message>
        <source>Number of trials</source>
        <translation>Número de pruebas</translation>
    </message>
    <message>
        <source>Compare A and B</source>
        <translation>Comparar A y B</translation>
    </message>
    <message>
        <source>Drill with both, behind letters, and say which feels more like a tooth</source>
        <translation>Fresar con ambos, ocultos tras letras, y decir cuál se parece más a un diente</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>versión %1</translation>
    </message>
    <message>
        <source>shipped</source>
        <translation>incluido</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>en uso</translation>
    </message>
    <message>
        <source>changed from %1</source>
        <translation>cambiado a partir de %1</translation>
    </message>
    <message>
        <source>Restore as the newest version</source>
        <translation>Restaurar como versión más reciente</translation>
    </message>
    <message>
        <source>Save as a new version</source>
        <translation>Guardar como versión nueva</translation>
    </message>
    <message>
        <source>A version is never changed: this becomes another</source>
        <translation>Una versión no se cambia nunca: esta pasa a ser otra</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <extracomment>%1 is the name of a preset that is duplicated</extracomment>
        <translation>%1, copia</translation>
    </message>
    <message>
        <source>Trials:</source>
        <extracomment>Before a number</extracomment>
        <translation>Pruebas:</translation>
    </message>
    <message>
        <source>An admin keeps the school&apos;s presets</source>
        <translation>Un administrador guarda los ajustes de la escuela</translation>
    </message>
    <message>
        <source>These two feel the same: choose another, or change a number</source>
        <translation>Estos dos se sienten igual: elija otro o cambie un número</translation>
    </message>
    <message>
        <source>What you have changed of the hardness preset %1 is not saved.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>Lo que ha cambiado del ajuste de dureza %1 no está guardado.</translation>
    </message>
    <message>
        <source>retired</source>
        <extracomment>A hardness preset that nobody is offered any more</extracomment>
        <translation>retirado</translation>
    </message>
    <message>
        <source>Take up again</source>
        <translation>Volver a ofrecer</translation>
    </message>
    <message>
        <source>Retire</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Offer this preset again</source>
        <translation>Volver a ofrecer este ajuste</translation>
    </message>
    <message>
        <source>Retire this preset</source>
        <translation>Retirar este ajuste</translation>
    </message>
    <message>
        <source>What is in use or shipped is not retired</source>
        <translation>Lo que está en uso o viene con Cusp no se retira</translation>
    </message>
    <message>
        <source>It is offered again, in all its versions</source>
        <translation>Se ofrece de nuevo, en todas sus versiones</translation>
    </message>
    <message>
        <source>Nobody is offered it any more; attempts go on naming it</source>
        <translation>Ya no se ofrece a nadie; los intentos lo siguen nombrando</translation>
    </message>
</context>
<context>
    <name>ui::presets::SimplePanel</name>
    <message>
        <source>Enamel</source>
        <translation>Esmalte</translation>
    </message>
    <message>
        <source>softer</source>
        <translation>más blando</translation>
    </message>
    <message>
        <source>harder</source>
        <translation>más duro</translation>
    </message>
    <message>
        <source>Dentin</source>
        <translation>Dentina</translation>
    </message>
    <message>
        <source>Caries</source>
        <translation>Caries</translation>
    </message>
    <message>
        <source>Plastic tooth</source>
        <translation>Diente de plástico</translation>
    </message>
    <message>
        <source>Touch that cuts</source>
        <extracomment>How hard one must press before anything comes away</extracomment>
        <translation>Toque que corta</translation>
    </message>
    <message>
        <source>lighter</source>
        <translation>más ligero</translation>
    </message>
    <message>
        <source>heavier</source>
        <translation>más fuerte</translation>
    </message>
    <message>
        <source>Wall</source>
        <extracomment>What an uncut tooth feels like under the bur</extracomment>
        <translation>Pared</translation>
    </message>
    <message>
        <source>stiffer</source>
        <translation>más rígido</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <extracomment>A slider: what it is about, and the words at its ends</extracomment>
        <translation>%1, de %2 a %3</translation>
    </message>
    <message>
        <source>In the middle: the numbers that were typed.</source>
        <extracomment>Of sliders. %1 is a hardness preset</extracomment>
        <translation>En el centro: los números introducidos.</translation>
    </message>
    <message>
        <source>In the middle: %1.</source>
        <translation>En el centro: %1.</translation>
    </message>
</context>
<context>
    <name>ui::presets::TrialCard</name>
    <message>
        <source>Feel A</source>
        <translation>Sentir A</translation>
    </message>
    <message>
        <source>Feel B</source>
        <translation>Sentir B</translation>
    </message>
    <message>
        <source>Drill with the preset behind A from now on</source>
        <translation>Fresar desde ahora con el ajuste que hay detrás de A</translation>
    </message>
    <message>
        <source>Drill with the preset behind B from now on</source>
        <translation>Fresar desde ahora con el ajuste que hay detrás de B</translation>
    </message>
    <message>
        <source>A does</source>
        <extracomment>Which of two presets feels more like a tooth</extracomment>
        <translation>A</translation>
    </message>
    <message>
        <source>B does</source>
        <translation>B</translation>
    </message>
    <message>
        <source>No difference</source>
        <translation>Sin diferencia</translation>
    </message>
    <message>
        <source>All as it was</source>
        <translation>Todo como estaba</translation>
    </message>
    <message>
        <source>Set all sliders back to the preset</source>
        <translation>Devolver todos los controles al ajuste</translation>
    </message>
    <message>
        <source>Save as CSV …</source>
        <translation>Guardar como CSV …</translation>
    </message>
    <message>
        <source>Save the comparison as CSV</source>
        <translation>Guardar la comparación como CSV</translation>
    </message>
    <message>
        <source>Back to the presets</source>
        <translation>Volver a los ajustes</translation>
    </message>
    <message>
        <source>Drill: each slider is felt at once.</source>
        <translation>Frese: cada control se nota al instante.</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <extracomment>%1 of %2 trials</extracomment>
        <translation>Prueba %1 de %2</translation>
    </message>
    <message>
        <source>Drill with A and with B, as often as you like. Which feels more like a tooth?</source>
        <translation>Frese con A y con B cuantas veces quiera. ¿Cuál se parece más a un diente?</translation>
    </message>
    <message>
        <source>Compared</source>
        <translation>Comparado</translation>
    </message>
    <message numerus="yes">
        <source>%1: chosen %n time(s).</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>
            <numerusform>%1: elegido %n vez.</numerusform>
            <numerusform>%1: elegido %n veces.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No difference: %n time(s).</source>
        <translation>
            <numerusform>Sin diferencia: %n vez.</numerusform>
            <numerusform>Sin diferencia: %n veces.</numerusform>
        </translation>
    </message>
    <message>
        <source>That says nothing: they came out as even as can be.</source>
        <translation>Eso no dice nada: quedaron tan igualados como es posible.</translation>
    </message>
    <message numerus="yes">
        <source>That is hardly chance: tossing a coin comes out as uneven only %n time(s) in 100.</source>
        <translation>
            <numerusform>Eso apenas puede ser azar: una moneda sale tan desigual solo %n vez de cada 100.</numerusform>
            <numerusform>Eso apenas puede ser azar: una moneda sale tan desigual solo %n veces de cada 100.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>That may be chance: tossing a coin comes out as uneven %n time(s) in 100. Compare more often to be sure.</source>
        <translation>
            <numerusform>Eso puede ser azar: una moneda sale tan desigual %n vez de cada 100. Compare más veces para estar seguro.</numerusform>
            <numerusform>Eso puede ser azar: una moneda sale tan desigual %n veces de cada 100. Compare más veces para estar seguro.</numerusform>
        </translation>
    </message>
    <message>
        <source>First cut a little with both</source>
        <translation>Primero corte un poco con ambos</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Terminar la comparación</translation>
    </message>
    <message>
        <source>What has been answered counts, and it is told which was which</source>
        <translation>Lo ya respondido cuenta, y se dice cuál era cuál</translation>
    </message>
    <message>
        <source>It was ended before anything was chosen.</source>
        <translation>Se terminó antes de elegir nada.</translation>
    </message>
    <message>
        <source>Block of</source>
        <extracomment>What the block is made of on which a hardness preset is tried</extracomment>
        <translation>Bloque de</translation>
    </message>
    <message>
        <source>What the block is made of</source>
        <translation>De qué está hecho el bloque</translation>
    </message>
    <message>
        <source>enamel, dentin, soft decay</source>
        <translation>esmalte, dentina, caries blanda</translation>
    </message>
    <message>
        <source>enamel, dentin, firm decay</source>
        <translation>esmalte, dentina, caries firme</translation>
    </message>
    <message>
        <source>plastic throughout</source>
        <translation>plástico por completo</translation>
    </message>
</context>
<context>
    <name>ui::text::PresetTexts</name>
    <message>
        <source>Soft caries</source>
        <translation>Caries blanda</translation>
    </message>
    <message>
        <source>Firm caries</source>
        <translation>Caries firme</translation>
    </message>
    <message>
        <source>Enamel</source>
        <translation>Esmalte</translation>
    </message>
    <message>
        <source>Dentin</source>
        <translation>Dentina</translation>
    </message>
    <message>
        <source>Pulp</source>
        <translation>Pulpa</translation>
    </message>
    <message>
        <source>Plastic tooth</source>
        <extracomment>What the teeth of a typodont are made of</extracomment>
        <translation>Diente de plástico</translation>
    </message>
    <message>
        <source>%1: rate</source>
        <extracomment>%1 is a material of a tooth</extracomment>
        <translation>%1: tasa</translation>
    </message>
    <message>
        <source>%1: from</source>
        <translation>%1: umbral</translation>
    </message>
    <message>
        <source>Share along the bur</source>
        <translation>Parte a lo largo de la fresa</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortiguación</translation>
    </message>
    <message>
        <source>Damping of fast motion</source>
        <translation>Amortiguación del movimiento rápido</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Fricción</translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation>Límite de fuerza</translation>
    </message>
    <message>
        <source>Volume that a newton beyond the threshold takes away in a second, pushing sideways.</source>
        <translation>Volumen que un newton por encima del umbral elimina en un segundo, empujando de lado.</translation>
    </message>
    <message>
        <source>A lighter touch leaves no mark.</source>
        <translation>Un toque más ligero no deja marca.</translation>
    </message>
    <message>
        <source>What is left of the rate when the bur is pushed along its axis.</source>
        <translation>Lo que queda de la tasa cuando la fresa se empuja a lo largo de su eje.</translation>
    </message>
    <message>
        <source>Of the spring between hand and bur: how hard a wall feels.</source>
        <translation>Del muelle entre la mano y la fresa: cuán dura se nota una pared.</translation>
    </message>
    <message>
        <source>What calms the hand at rest. Too much is felt as a buzz.</source>
        <translation>Lo que calma la mano en reposo. Demasiado se nota como un zumbido.</translation>
    </message>
    <message>
        <source>What calms a fast hand besides, as when the bur is thrown at the tooth.</source>
        <translation>Lo que además calma una mano rápida, como cuando la fresa se lanza contra el diente.</translation>
    </message>
    <message>
        <source>Of the bur that slides on the tooth.</source>
        <translation>De la fresa que se desliza sobre el diente.</translation>
    </message>
    <message>
        <source>The largest force that is ever given to the hand.</source>
        <translation>La mayor fuerza que llega a recibir la mano.</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <extracomment>A range: %1 to %2, %3 is a unit</extracomment>
        <translation>%1 a %2 %3</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <extracomment>%1 is the name of a hardness preset, %2 its version</extracomment>
        <translation>%1, versión %2</translation>
    </message>
    <message>
        <source>%1, changed by hand</source>
        <extracomment>After the name of a hardness preset whose numbers were changed during the attempt</extracomment>
        <translation>%1, cambiado a mano</translation>
    </message>
    <message>
        <source>The force limit is %1 N, and the device gives at most %2 N: lower it.</source>
        <translation>El límite de fuerza es %1 N y el dispositivo da como máximo %2 N: bájelo.</translation>
    </message>
    <message>
        <source>Holds: a light hand at %1 ms of delay is steady up to %2 N/mm, and this is %3.</source>
        <translation>Aguanta: una mano ligera con %1 ms de retardo es estable hasta %2 N/mm, y esto es %3.</translation>
    </message>
    <message>
        <source>Would tremble: a light hand at %1 ms of delay is steady up to %2 N/mm, and this is %3.</source>
        <translation>Temblaría: una mano ligera con %1 ms de retardo es estable hasta %2 N/mm, y esto es %3.</translation>
    </message>
    <message>
        <source>Lower the stiffness, or damp more.</source>
        <translation>Baje la rigidez o amortigüe más.</translation>
    </message>
    <message>
        <source>Lower the stiffness.</source>
        <translation>Baje la rigidez.</translation>
    </message>
    <message>
        <source>Share of flat ends</source>
        <extracomment>Of a bur whose end is flat, such as a pear or a fissure bur</extracomment>
        <translation>Parte de los extremos planos</translation>
    </message>
    <message>
        <source>Full load</source>
        <extracomment>The load on the bur beyond which it cuts no faster</extracomment>
        <translation>Carga plena</translation>
    </message>
    <message>
        <source>What a pear or a fissure bur has of the share along the bur. At 1 the end makes no difference.</source>
        <translation>Lo que una fresa de pera o de fisura tiene de la parte a lo largo de la fresa. Con 1, el extremo no influye.</translation>
    </message>
    <message>
        <source>A bur pressed harder cuts no faster. At 20 N there is no such limit.</source>
        <translation>Una fresa que se aprieta más no corta más deprisa. Con 20 N no hay tal límite.</translation>
    </message>
</context>
<context>
    <name>ui::practice::HistoryPanel</name>
    <message>
        <source>Undo history</source>
        <translation>Historial de cambios</translation>
    </message>
    <message>
        <source>Click a state, or press Enter, to return to it</source>
        <translation>Haga clic en un estado, o pulse Intro, para volver a él</translation>
    </message>
    <message>
        <source>Each stroke appears here as a small picture. Click a picture to go back to it. Later strokes stay as a separate branch.</source>
        <translation>Cada pasada aparece aquí como una imagen pequeña. Haga clic en una imagen para volver a ella. Las pasadas posteriores se conservan como una rama aparte.</translation>
    </message>
</context>
<context>
    <name>ui::replay::ReplayBar</name>
    <message>
        <source>You are watching a recording</source>
        <translation>Está viendo una grabación</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Stop the replay</source>
        <translation>Detener la reproducción</translation>
    </message>
    <message>
        <source>Stop the replay and return to your own work (Esc)</source>
        <translation>Detener la reproducción y volver a su propio trabajo (Esc)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Progress of a recording: minutes and seconds played, and of the whole</extracomment>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1×</source>
        <extracomment>Speed of a replay: so many times as fast as it was made</extracomment>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Speed of the replay: %1</source>
        <translation>Velocidad de la reproducción: %1</translation>
    </message>
</context>
<context>
    <name>ui::replay::TimeLine</name>
    <message>
        <source>Time line</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>Left and Right move from stroke to stroke, Home and End to the beginning and the end.</source>
        <translation>Izquierda y derecha van de pasada en pasada; Inicio y Fin, al principio y al final.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>On a time line: a time, and what happened then</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Stroke %1, %2 s, %3</source>
        <translation>Pasada %1, %2 s, %3</translation>
    </message>
    <message>
        <source>Interruption of %1, not counted as working time</source>
        <translation>Interrupción de %1, no cuenta como tiempo de trabajo</translation>
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
        <translation>Sin avance (tres intentos seguidos, sin aprobar, sin mejorar cinco puntos)</translation>
    </message>
    <message>
        <source>Never logged in</source>
        <translation>Nunca han iniciado sesión</translation>
    </message>
    <message>
        <source>Logged in, no graded attempt yet</source>
        <translation>Sesión iniciada, aún sin intentos calificados</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s)</source>
        <translation>
            <numerusform>%n estudiante</numerusform>
            <numerusform>%n estudiantes</numerusform>
        </translation>
    </message>
    <message>
        <source>The class at: %1</source>
        <translation>El grupo en: %1</translation>
    </message>
    <message>
        <source>Late: a lesson is overdue and not passed</source>
        <translation>Con retraso: una lección con el plazo vencido y no aprobada</translation>
    </message>
    <message>
        <source>Class: %1</source>
        <translation>Grupo: %1</translation>
    </message>
    <message>
        <source>Rubric: %1, version %2, content %3</source>
        <translation>Rúbrica: %1, versión %2, contenido %3</translation>
    </message>
    <message>
        <source>No attempts left at a lesson that is not passed</source>
        <translation>Sin más intentos en una lección no aprobada</translation>
    </message>
    <message>
        <source>Best scores</source>
        <translation>Mejores puntuaciones</translation>
    </message>
    <message>
        <source>✓: passed; ▲: overdue, or no attempts left; ⚠: does not match its recording; ▲ behind a name: needs the teacher</source>
        <translation>✓: aprobado; ▲: plazo vencido o sin más intentos; ⚠: no coincide con su grabación; ▲ tras un nombre: necesita al docente</translation>
    </message>
</context>
<context>
    <name>ui::report::ScoreCard</name>
    <message>
        <source>Score card: %1</source>
        <translation>Hoja de puntuación: %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1: a person; %2: date and time</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Given by an instructor. Automatic score: %1 points.</source>
        <translation>Dada por un docente. Puntuación automática: %1 puntos.</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <extracomment>%1: a person; %2: date and time; %3: why</extracomment>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>Self-assessment before the score: %1 points</source>
        <translation>Autoevaluación antes de la puntuación: %1 puntos</translation>
    </message>
    <message>
        <source>Time %1 min; cutting force: mean %2 N, maximum %3 N</source>
        <extracomment>&quot;12:07&quot;</extracomment>
        <translation>Tiempo %1 min; fuerza al tallar: media %2 N, máxima %3 N</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>not met</source>
        <translation>no respetado</translation>
    </message>
    <message>
        <source>met</source>
        <translation>respetado</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Lost of a weight, both points: &quot;−4.4 of 30.0&quot;</extracomment>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Lost points</source>
        <translation>Puntos perdidos</translation>
    </message>
    <message>
        <source>On the tooth, and in a section through the largest deviation</source>
        <translation>En el diente, y en un corte por la mayor desviación</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Comentarios</translation>
    </message>
    <message>
        <source>Details of grading and recording</source>
        <translation>Datos de la calificación y la grabación</translation>
    </message>
    <message>
        <source>Rubric: %1, version %2, content %3</source>
        <translation>Rúbrica: %1, versión %2, contenido %3</translation>
    </message>
    <message>
        <source>Hardness: %1, content %2</source>
        <translation>Dureza: %1, contenido %2</translation>
    </message>
    <message>
        <source>Device: %1; contact: %2; grid: %3 columns a side; view: %4; seed: %5</source>
        <translation>Dispositivo: %1; contacto: %2; cuadrícula: %3 columnas por lado; vista: %4; semilla: %5</translation>
    </message>
    <message>
        <source>Made with Cusp %1; recording %2; attempt %3</source>
        <translation>Hecho con Cusp %1; grabación %2; intento %3</translation>
    </message>
    <message>
        <source>Not measured: undercuts and walls past 90°, because the model is a height field.</source>
        <translation>No se miden los socavados ni las paredes de más de 90°, porque el modelo es un campo de alturas.</translation>
    </message>
    <message>
        <source>%1, %2, at %3 of the replay</source>
        <translation>%1, %2, en %3 de la repetición</translation>
    </message>
    <message>
        <source>%1 of 100 points, pass mark %2. %3</source>
        <extracomment>%1 and %2: points; %3: &quot;Passed&quot;, &quot;Not passed: critical error&quot;</extracomment>
        <translation>%1 de 100 puntos, aprobado desde %2. %3</translation>
    </message>
    <message>
        <source>Comments, with the numbers of their places in the picture of the tooth</source>
        <translation>Comentarios, con los números de sus lugares en la imagen del diente</translation>
    </message>
    <message>
        <source>mouse, pen or gamepad</source>
        <translation>ratón, lápiz o mando</translation>
    </message>
    <message>
        <source>simulated handpiece</source>
        <translation>pieza de mano simulada</translation>
    </message>
    <message>
        <source>continuous</source>
        <extracomment>How the point of contact is found: anywhere, not only on a lattice</extracomment>
        <translation>continuo</translation>
    </message>
    <message>
        <source>on a lattice</source>
        <extracomment>How the point of contact is found</extracomment>
        <translation>sobre una retícula</translation>
    </message>
    <message>
        <source>on a lattice, 16 steps a tick</source>
        <extracomment>How the point of contact is found</extracomment>
        <translation>sobre una retícula, 16 pasos por ciclo</translation>
    </message>
    <message>
        <source>by depth</source>
        <extracomment>How force is found: the deeper inside, the harder it is pushed out</extracomment>
        <translation>según la profundidad</translation>
    </message>
    <message>
        <source>flat</source>
        <extracomment>A picture that is no stereo picture</extracomment>
        <translation>plana</translation>
    </message>
    <message>
        <source>red and cyan glasses, in colour</source>
        <translation>gafas rojo-cian, en color</translation>
    </message>
    <message>
        <source>red and cyan glasses, in grey</source>
        <translation>gafas rojo-cian, en gris</translation>
    </message>
    <message>
        <source>stereo, halves side by side</source>
        <translation>estéreo, mitades una al lado de otra</translation>
    </message>
    <message>
        <source>stereo, halves one above the other</source>
        <translation>estéreo, mitades una encima de otra</translation>
    </message>
    <message>
        <source>Rubric: content %1</source>
        <translation>Rúbrica: contenido %1</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>ratón</translation>
    </message>
    <message>
        <source>pen</source>
        <translation>lápiz</translation>
    </message>
    <message>
        <source>keyboard</source>
        <translation>teclado</translation>
    </message>
    <message>
        <source>gamepad</source>
        <translation>mando de juego</translation>
    </message>
</context>
<context>
    <name>ui::report::Sheet</name>
    <message>
        <source>Cusp %1, printed %2</source>
        <translation>Cusp %1, impreso el %2</translation>
    </message>
    <message>
        <source>%1, page %2</source>
        <translation>%1, página %2</translation>
    </message>
    <message>
        <source>Audit code: %1</source>
        <translation>Código de auditoría: %1</translation>
    </message>
    <message>
        <source>Not kept in a school&apos;s database: there is no audit code</source>
        <translation>No se conserva en la base de datos de ninguna escuela: no hay código de auditoría</translation>
    </message>
    <message>
        <source>%1, page %2 of %3</source>
        <translation>%1, página %2 de %3</translation>
    </message>
</context>
<context>
    <name>ui::settings::SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation>Configuración</translation>
    </message>
    <message>
        <source>Search the settings</source>
        <translation>Buscar en la configuración</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Borrar la búsqueda</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>De %1.</translation>
    </message>
    <message>
        <source>Set it back</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Set back: %1</source>
        <extracomment>%1 is the name of a setting</extracomment>
        <translation>Restablecer: %1</translation>
    </message>
    <message>
        <source>No setting is called so, and none speaks of it. Look for one word, such as &quot;force&quot;.</source>
        <translation>Ningún ajuste se llama así ni habla de ello. Busque una sola palabra, como «fuerza».</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Of every window, at once.</source>
        <translation>De todas las ventanas, en el acto.</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>From the next start on. The practice room is always dark.</source>
        <translation>Desde el próximo inicio. La sala de práctica siempre es oscura.</translation>
    </message>
    <message>
        <source>as the desktop</source>
        <translation>como el escritorio</translation>
    </message>
    <message>
        <source>light</source>
        <translation>claras</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>oscuras</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Mano</translation>
    </message>
    <message>
        <source>Mouse or pen, a simulated hand, or a force device: choose, home and try it.</source>
        <translation>Ratón o lápiz, una mano simulada o un dispositivo de fuerza: elíjalo, refiéralo y pruébelo.</translation>
    </message>
</context>
<context>
    <name>ui::window::AccountMenu</name>
    <message>
        <source>My account</source>
        <translation>Mi cuenta</translation>
    </message>
    <message>
        <source>Change my password …</source>
        <translation>Cambiar mi contraseña …</translation>
    </message>
</context>
<context>
    <name>ui::kit::Actions</name>
    <message>
        <source>Drill</source>
        <translation>Fresar</translation>
    </message>
    <message>
        <source>Drill on or off</source>
        <translation>Fresa en marcha o parada</translation>
    </message>
    <message>
        <source>Start or stop the bur</source>
        <translation>Poner en marcha o parar la fresa</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Undo the last stroke</source>
        <translation>Deshacer la última pasada</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Redo the stroke that was undone</source>
        <translation>Rehacer la pasada que se deshizo</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Empezar de nuevo</translation>
    </message>
    <message>
        <source>Reset the tooth; Undo restores your work</source>
        <translation>Restablecer el diente; Deshacer recupera su trabajo</translation>
    </message>
    <message>
        <source>Grade</source>
        <translation>Calificar</translation>
    </message>
    <message>
        <source>Measure your preparation and explain the grade</source>
        <translation>Medir su preparación y explicar la calificación</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation>Pieza de mano</translation>
    </message>
    <message>
        <source>Use this bur</source>
        <translation>Usar esta fresa</translation>
    </message>
    <message>
        <source>Other hand</source>
        <translation>Otra mano</translation>
    </message>
    <message>
        <source>Tooth and files</source>
        <translation>Diente y archivos</translation>
    </message>
    <message>
        <source>Choose a tooth</source>
        <translation>Elegir un diente</translation>
    </message>
    <message>
        <source>Show the arches and choose one of 16 teeth</source>
        <translation>Mostrar las arcadas y elegir uno de 16 dientes</translation>
    </message>
    <message>
        <source>Open a scan</source>
        <translation>Abrir un escaneo</translation>
    </message>
    <message>
        <source>Open the scan of a tooth: OBJ, STL or PLY</source>
        <translation>Abrir el escaneo de un diente: OBJ, STL o PLY</translation>
    </message>
    <message>
        <source>Save the recording</source>
        <translation>Guardar la grabación</translation>
    </message>
    <message>
        <source>Save every movement of this attempt to a file</source>
        <translation>Guardar cada movimiento de este intento en un archivo</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Abrir una grabación</translation>
    </message>
    <message>
        <source>Replay a saved attempt</source>
        <translation>Reproducir un intento guardado</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>Restablecer la vista</translation>
    </message>
    <message>
        <source>Return to the initial view</source>
        <translation>Volver a la vista inicial</translation>
    </message>
    <message>
        <source>Side panel</source>
        <translation>Panel lateral</translation>
    </message>
    <message>
        <source>Show or hide the figures</source>
        <translation>Mostrar u ocultar las medidas</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Pantalla completa</translation>
    </message>
    <message>
        <source>Fill the whole screen</source>
        <translation>Llenar toda la pantalla</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclas y ratón</translation>
    </message>
    <message>
        <source>Show what every key does</source>
        <translation>Mostrar qué hace cada tecla</translation>
    </message>
    <message>
        <source>Back to the tooth</source>
        <translation>Volver al diente</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Close Cusp</source>
        <translation>Cerrar Cusp</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>Tooltip: what it does, then its key</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Pause the replay</source>
        <translation>Pausar la reproducción</translation>
    </message>
    <message>
        <source>Pause or resume the replay</source>
        <translation>Pausar o reanudar la reproducción</translation>
    </message>
    <message>
        <source>Resume the replay</source>
        <translation>Reanudar la reproducción</translation>
    </message>
    <message>
        <source>Hold the handpiece from the other side; the view stays</source>
        <translation>Sostener la pieza de mano desde el otro lado; la vista no cambia</translation>
    </message>
    <message>
        <source>Return the handpiece</source>
        <translation>Devolver la pieza de mano</translation>
    </message>
    <message>
        <source>Let the handpiece guide your hand back over the tooth</source>
        <translation>Dejar que la pieza de mano guíe su mano de vuelta sobre el diente</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Rotate 180°</source>
        <translation>Girar 180°</translation>
    </message>
    <message>
        <source>Look at the tooth from the opposite side</source>
        <translation>Ver el diente desde el lado opuesto</translation>
    </message>
    <message>
        <source>Dental mirror</source>
        <extracomment>The small round mirror on a handle</extracomment>
        <translation>Espejo dental</translation>
    </message>
    <message>
        <source>Show or hide the mirror; drag its glass to move it, with Shift to tilt it</source>
        <translation>Mostrar u ocultar el espejo; arrastre el cristal para moverlo, con Mayúsculas para inclinarlo</translation>
    </message>
    <message>
        <source>Light on the handpiece</source>
        <translation>Luz en la pieza de mano</translation>
    </message>
    <message>
        <source>Light the cavity from the handpiece</source>
        <translation>Iluminar la cavidad desde la pieza de mano</translation>
    </message>
    <message>
        <source>Depth colours</source>
        <translation>Colores de profundidad</translation>
    </message>
    <message>
        <source>Colour the cut by its depth and show the depth at the pointer</source>
        <translation>Colorear el tallado por su profundidad y mostrarla en el puntero</translation>
    </message>
    <message>
        <source>Hand position</source>
        <translation>Posición de la mano</translation>
    </message>
    <message>
        <source>Show faintly where the hand holds the bur</source>
        <translation>Mostrar tenuemente dónde sostiene la mano la fresa</translation>
    </message>
    <message>
        <source>Colour-blind palette</source>
        <translation>Paleta para daltónicos</translation>
    </message>
    <message>
        <source>Give each tissue a colour and a pattern that are easy to tell apart</source>
        <translation>Dar a cada tejido un color y una trama fáciles de distinguir</translation>
    </message>
    <message>
        <source>Wet tooth</source>
        <extracomment>The tooth as if it were wet</extracomment>
        <translation>Diente húmedo</translation>
    </message>
    <message>
        <source>Make the tooth shine as if it were wet</source>
        <translation>Hacer que el diente brille como si estuviera húmedo</translation>
    </message>
    <message>
        <source>Stereo picture</source>
        <translation>Imagen estéreo</translation>
    </message>
    <message>
        <source>One picture for each eye</source>
        <translation>Una imagen para cada ojo</translation>
    </message>
    <message>
        <source>Set up the stereo picture …</source>
        <translation>Configurar la imagen estéreo …</translation>
    </message>
    <message>
        <source>Choose glasses or screen and fit it to your eyes</source>
        <translation>Elegir gafas o pantalla y ajustarla a sus ojos</translation>
    </message>
    <message>
        <source>Mirror horizontally</source>
        <translation>Reflejar horizontalmente</translation>
    </message>
    <message>
        <source>For a half-silvered mirror over the hand</source>
        <translation>Para un espejo semirreflectante sobre la mano</translation>
    </message>
    <message>
        <source>Mirror vertically</source>
        <translation>Reflejar verticalmente</translation>
    </message>
    <message>
        <source>For a screen mounted upside down over the hand</source>
        <translation>Para una pantalla colocada boca abajo sobre la mano</translation>
    </message>
    <message>
        <source>Save a picture …</source>
        <translation>Guardar una imagen …</translation>
    </message>
    <message>
        <source>Save what the view shows as a PNG</source>
        <translation>Guardar lo que muestra la vista como PNG</translation>
    </message>
    <message>
        <source>Less motion</source>
        <translation>Menos movimiento</translation>
    </message>
    <message>
        <source>No animations and no spinning bur</source>
        <translation>Sin animaciones ni fresa girando</translation>
    </message>
    <message>
        <source>Whole mouth</source>
        <translation>Boca completa</translation>
    </message>
    <message>
        <source>Choose a tooth in the whole mouth, or go back to the flat arches</source>
        <translation>Elegir un diente en la boca completa o volver a las arcadas planas</translation>
    </message>
    <message>
        <source>Seeing inside</source>
        <translation>Ver el interior</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Show or hide a live section through the bur</source>
        <translation>Mostrar u ocultar un corte en vivo a través de la fresa</translation>
    </message>
    <message>
        <source>Turn the section</source>
        <translation>Girar el corte</translation>
    </message>
    <message>
        <source>Turn the section around the bur by 15 degrees</source>
        <translation>Girar el corte 15 grados alrededor de la fresa</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Radiografía</translation>
    </message>
    <message>
        <source>This lesson does not allow it.</source>
        <translation>Esta lección no lo permite.</translation>
    </message>
    <message>
        <source>Neighbouring teeth</source>
        <translation>Dientes adyacentes</translation>
    </message>
    <message>
        <source>Show the adjacent teeth and the gum</source>
        <translation>Mostrar los dientes adyacentes y la encía</translation>
    </message>
    <message>
        <source>Deviation from the ideal</source>
        <translation>Desviación del ideal</translation>
    </message>
    <message>
        <source>Colour what is too deep and what is still to cut, and show the value at the pointer</source>
        <translation>Colorear lo que es demasiado profundo y lo que falta, y mostrar el valor en el puntero</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>Choose what to practise</source>
        <translation>Elegir qué practicar</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Show or hide the undo history with all its branches</source>
        <translation>Mostrar u ocultar el historial con todas sus ramas</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Reproducción</translation>
    </message>
    <message>
        <source>Previous stroke</source>
        <translation>Pasada anterior</translation>
    </message>
    <message>
        <source>Go to the end of the previous stroke and pause</source>
        <translation>Ir al final de la pasada anterior y pausar</translation>
    </message>
    <message>
        <source>Next stroke</source>
        <translation>Pasada siguiente</translation>
    </message>
    <message>
        <source>Go to the end of the next stroke and pause</source>
        <translation>Ir al final de la pasada siguiente y pausar</translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation>Al principio</translation>
    </message>
    <message>
        <source>Go to the beginning of the recording</source>
        <translation>Ir al principio de la grabación</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Al final</translation>
    </message>
    <message>
        <source>Go to the end of the recording</source>
        <translation>Ir al final de la grabación</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Más lento</translation>
    </message>
    <message>
        <source>Play the recording more slowly, down to a tenth</source>
        <translation>Reproducir la grabación más despacio, hasta una décima parte</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Más rápido</translation>
    </message>
    <message>
        <source>Play the recording faster, up to 16 times</source>
        <translation>Reproducir la grabación más deprisa, hasta 16 veces</translation>
    </message>
    <message>
        <source>Use this handpiece</source>
        <translation>Usar esta pieza de mano</translation>
    </message>
    <message>
        <source>Colour the bur</source>
        <extracomment>The bur tells by its colour how near it is to what is to be kept</extracomment>
        <translation>Colorear la fresa</translation>
    </message>
    <message>
        <source>Colour the bur by its distance from tissue that must be kept</source>
        <translation>Colorear la fresa según su distancia al tejido que debe conservarse</translation>
    </message>
    <message>
        <source>Guided hand</source>
        <translation>Mano guiada</translation>
    </message>
    <message>
        <source>A gentle force keeps the hand within the outline</source>
        <translation>Una fuerza suave mantiene la mano dentro del contorno</translation>
    </message>
    <message>
        <source>Edit the lesson …</source>
        <translation>Editar la lección …</translation>
    </message>
    <message>
        <source>Change the ideal and the rubric of the selected lesson</source>
        <translation>Cambiar el ideal y la rúbrica de la lección elegida</translation>
    </message>
    <message>
        <source>Save this attempt as a reference …</source>
        <translation>Guardar este intento como referencia …</translation>
    </message>
    <message>
        <source>Save your preparation as an ideal for lessons</source>
        <translation>Guardar su preparación como ideal para lecciones</translation>
    </message>
    <message>
        <source>The expert&apos;s attempt</source>
        <translation>El intento del experto</translation>
    </message>
    <message>
        <source>Watch how an expert does it; during a replay, beside this attempt</source>
        <translation>Ver cómo lo hace un experto; en una reproducción, junto a este intento</translation>
    </message>
    <message>
        <source>Compare with …</source>
        <translation>Comparar con …</translation>
    </message>
    <message>
        <source>Open another attempt beside this one, or close it</source>
        <translation>Abrir otro intento junto a este, o cerrarlo</translation>
    </message>
    <message>
        <source>Guide my hand</source>
        <translation>Guiar mi mano</translation>
    </message>
    <message>
        <source>Let the handpiece guide your hand along the attempt; push against it to stop</source>
        <translation>La pieza de mano guía su mano a lo largo del intento; empuje en contra para soltarla</translation>
    </message>
    <message>
        <source>Hardness presets</source>
        <translation>Ajustes de dureza</translation>
    </message>
    <message>
        <source>Choose, try and change how drilling feels</source>
        <translation>Elegir, probar y cambiar cómo se nota el fresado</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Iniciar sesión</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>Consola</translation>
    </message>
    <message>
        <source>Show or hide parameters that you can change while you drill</source>
        <translation>Mostrar u ocultar parámetros que puede cambiar mientras fresa</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Configuración</translation>
    </message>
    <message>
        <source>Every setting with its range</source>
        <translation>Cada opción con su intervalo</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>Mis intentos</translation>
    </message>
    <message>
        <source>See the results of your attempts</source>
        <translation>Ver los resultados de sus intentos</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Grupos</translation>
    </message>
    <message>
        <source>See the results of a class and who needs help</source>
        <translation>Ver los resultados de un grupo y quién necesita ayuda</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Visita guiada</translation>
    </message>
    <message>
        <source>Get to know the window step by step</source>
        <translation>Conocer la ventana paso a paso</translation>
    </message>
    <message>
        <source>School</source>
        <translation>Escuela</translation>
    </message>
    <message>
        <source>People, class lists, backups and the audit</source>
        <translation>Personas, listas, copias de seguridad y el registro</translation>
    </message>
    <message>
        <source>Log in, lock this workstation, or change your password or the language</source>
        <translation>Iniciar sesión, bloquear este puesto, cambiar la contraseña o el idioma</translation>
    </message>
    <message>
        <source>Lock or switch user</source>
        <translation>Bloquear o cambiar de usuario</translation>
    </message>
    <message>
        <source>Your work stays open; a password is needed to continue</source>
        <translation>Su trabajo sigue abierto; para continuar se necesita una contraseña</translation>
    </message>
    <message>
        <source>Close this page; nothing is lost</source>
        <translation>Cerrar esta página; no se pierde nada</translation>
    </message>
    <message>
        <source>Back to the attempts</source>
        <translation>Volver a los intentos</translation>
    </message>
    <message>
        <source>Back to the class</source>
        <translation>Volver a la clase</translation>
    </message>
    <message>
        <source>Back to the lessons</source>
        <translation>Volver a las lecciones</translation>
    </message>
    <message>
        <source>Guest,
unsaved</source>
        <extracomment>Beside &quot;Log in&quot;, on every page: what is done now is kept for nobody. Two short lines.</extracomment>
        <translation>Invitado,
sin guardar</translation>
    </message>
    <message>
        <source>Show changes made on other computers</source>
        <translation>Mostrar los cambios hechos en otros ordenadores</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Show X-ray pictures of the tooth, before and now, or close them</source>
        <translation>Mostrar radiografías del diente, antes y ahora, o cerrarlas</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search on this page, or among the lessons</source>
        <translation>Buscar en esta página o entre las lecciones</translation>
    </message>
    <message>
        <source>Outline</source>
        <extracomment>Of the ideal preparation, drawn on the tooth</extracomment>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Show or hide the outline of the ideal preparation on the tooth</source>
        <translation>Mostrar u ocultar el contorno de la preparación ideal sobre el diente</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Dispositivos</translation>
    </message>
    <message>
        <source>Choose and try what moves the bur</source>
        <translation>Elegir y probar lo que mueve la fresa</translation>
    </message>
    <message>
        <source>Straight ahead is here</source>
        <translation>El frente está aquí</translation>
    </message>
    <message>
        <source>Make the present position of your head the middle one</source>
        <translation>Tomar la posición actual de la cabeza como la central</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Sonido</translation>
    </message>
    <message>
        <source>Sound of the handpiece on or off</source>
        <translation>Encender o apagar el sonido de la pieza de mano</translation>
    </message>
    <message>
        <source>All burs</source>
        <translation>Todas las fresas</translation>
    </message>
    <message>
        <source>Choose from all burs, and which are at hand</source>
        <translation>Elegir entre todas las fresas y cuáles están a mano</translation>
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
        <translation>Arcadas</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
</context>
<context>
    <name>ui::practice::BurChooser</name>
    <message>
        <source>Burs</source>
        <translation>Fresas</translation>
    </message>
</context>
<context>
    <name>ui::kit::BusyOverlay</name>
    <message>
        <source>Working</source>
        <translation>Trabajando</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
</context>
<context>
    <name>ui::practice::DrillSwitch</name>
    <message>
        <source>Drill is on</source>
        <translation>La fresa está en marcha</translation>
    </message>
    <message>
        <source>Drill is off</source>
        <translation>La fresa está parada</translation>
    </message>
    <message>
        <source>Drill on</source>
        <translation>En marcha</translation>
    </message>
    <message>
        <source>Drill off</source>
        <translation>Parada</translation>
    </message>
</context>
<context>
    <name>ui::kit::FileDialog</name>
    <message>
        <source>%1 is a file of another kind and stays as it is. Choose another name.</source>
        <translation>%1 es un archivo de otro tipo y se queda como está. Elija otro nombre.</translation>
    </message>
</context>
<context>
    <name>ui::kit::ForceBar</name>
    <message>
        <source>Force against the force that is set</source>
        <translation>Fuerza respecto a la fuerza ajustada</translation>
    </message>
    <message>
        <source>The mark is the force that is set. A wall that presses sideways adds to it.</source>
        <translation>La marca es la fuerza ajustada. Una pared que presiona de lado se suma a ella.</translation>
    </message>
</context>
<context>
    <name>ui::practice::HandControls</name>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Feed, millimetres per second</source>
        <translation>Avance, milímetros por segundo</translation>
    </message>
    <message>
        <source>How fast the bur goes down at most while you press</source>
        <translation>Velocidad máxima a la que baja la fresa mientras presiona</translation>
    </message>
    <message>
        <source>Depth stop</source>
        <translation>Tope</translation>
    </message>
    <message>
        <source>The bur stops at this depth below the original surface</source>
        <translation>La fresa se detiene a esta profundidad bajo la superficie original</translation>
    </message>
    <message>
        <source>Depth stop, millimetres</source>
        <translation>Tope de profundidad, milímetros</translation>
    </message>
    <message>
        <source>To change the depth, turn the mouse wheel while you press the button or hold Shift</source>
        <translation>Para cambiar la profundidad, gire la rueda mientras mantiene pulsado el botón o la tecla Mayús</translation>
    </message>
    <message>
        <source>Push with</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>Push with, newtons</source>
        <translation>Presionar con, newtons</translation>
    </message>
    <message>
        <source>How hard the mouse and the keys push the bur against the tooth at most</source>
        <translation>Fuerza máxima con la que el ratón y las teclas empujan la fresa contra el diente</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>The %1 moves the bur. Feed, depth stop and force are for the mouse.</source>
        <extracomment>%1: a force device</extracomment>
        <translation>El %1 mueve la fresa. El avance, el tope de profundidad y la fuerza son para el ratón.</translation>
    </message>
</context>
<context>
    <name>ui::practice::HandpieceChooser</name>
    <message>
        <source>Handpieces</source>
        <translation>Piezas de mano</translation>
    </message>
</context>
<context>
    <name>ui::window::HelpOverlay</name>
    <message>
        <source>Move the bur</source>
        <translation>Mover la fresa</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>ratón</translation>
    </message>
    <message>
        <source>arrows</source>
        <translation>flechas</translation>
    </message>
    <message>
        <source>Push it against the tooth</source>
        <translation>Apretarla contra el diente</translation>
    </message>
    <message>
        <source>left button</source>
        <translation>botón izquierdo</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Av Pág</translation>
    </message>
    <message>
        <source>Lift it</source>
        <translation>Levantarla</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Re Pág</translation>
    </message>
    <message>
        <source>Push harder, softer</source>
        <translation>Apretar más, menos</translation>
    </message>
    <message>
        <source>Depth stop</source>
        <translation>Tope</translation>
    </message>
    <message>
        <source>wheel while pressed</source>
        <translation>rueda mientras presiona</translation>
    </message>
    <message>
        <source>Shift + wheel</source>
        <translation>Mayús + rueda</translation>
    </message>
    <message>
        <source>Insert, Delete</source>
        <translation>Insertar, Suprimir</translation>
    </message>
    <message>
        <source>Ctrl + wheel</source>
        <translation>Control + rueda</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Girar la vista</translation>
    </message>
    <message>
        <source>Ctrl + arrows</source>
        <translation>Control + flechas</translation>
    </message>
    <message>
        <source>Zoom in, zoom out</source>
        <translation>Acercarse, alejarse</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>rueda</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Cerrar (Esc)</translation>
    </message>
    <message>
        <source>Over the tooth</source>
        <translation>Sobre el diente</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>Restablecer la vista</translation>
    </message>
    <message>
        <source>right double-click</source>
        <translation>doble clic derecho</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Move it in fine steps</source>
        <translation>Moverla con precisión</translation>
    </message>
    <message>
        <source>Shift + arrows</source>
        <translation>Mayúsculas + flechas</translation>
    </message>
    <message>
        <source>right or middle drag</source>
        <translation>arrastre derecho/medio</translation>
    </message>
    <message>
        <source>The teal arc beside the bur shows how hard it presses; it is full at the force that is set.</source>
        <translation>El arco turquesa junto a la fresa muestra con cuánta fuerza presiona; está lleno con la fuerza ajustada.</translation>
    </message>
    <message>
        <source>Turn the handpiece</source>
        <translation>Girar la pieza de mano</translation>
    </message>
    <message>
        <source>the same with Shift</source>
        <translation>lo mismo con Mayúsculas</translation>
    </message>
    <message>
        <source>Move the mirror</source>
        <translation>Mover el espejo</translation>
    </message>
    <message>
        <source>drag its glass</source>
        <translation>arrastrar el cristal</translation>
    </message>
    <message>
        <source>Alt + arrows</source>
        <translation>Alt + flechas</translation>
    </message>
    <message>
        <source>Tilt the mirror</source>
        <translation>Inclinar el espejo</translation>
    </message>
    <message>
        <source>wheel over it</source>
        <translation>rueda sobre él</translation>
    </message>
    <message>
        <source>Bring it nearer</source>
        <translation>Acercarlo</translation>
    </message>
    <message>
        <source>Alt + Page Up</source>
        <translation>Alt + Re Pág</translation>
    </message>
    <message>
        <source>In a list</source>
        <translation>En una lista</translation>
    </message>
    <message>
        <source>Change the sorting</source>
        <translation>Cambiar el orden</translation>
    </message>
</context>
<context>
    <name>ui::scoring::RecentScoresChart</name>
    <message>
        <source>Last grades, oldest first: %1</source>
        <translation>Últimas notas, primero la más antigua: %1</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>aprobado desde %1</translation>
    </message>
    <message>
        <source>%1 with another rubric</source>
        <translation>%1 según otra rúbrica</translation>
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
        <translation>Idioma</translation>
    </message>
</context>
<context>
    <name>ui::window::FileDialogs</name>
    <message>
        <source>Scans of teeth (%1)</source>
        <translation>Escaneos de dientes (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Recordings (%1)</source>
        <translation>Grabaciones (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Imágenes (%1)</translation>
    </message>
    <message>
        <source>The picture was saved as %1.</source>
        <translation>La imagen se guardó como %1.</translation>
    </message>
    <message>
        <source>The picture could not be written. Choose another folder, or free some disk space.</source>
        <translation>La imagen no se pudo escribir. Elija otra carpeta o libere espacio en el disco.</translation>
    </message>
    <message>
        <source>Captured ideals (%1)</source>
        <translation>Ideales capturados (%1)</translation>
    </message>
    <message>
        <source>The comparison was saved as %1.</source>
        <translation>La comparación se guardó como %1.</translation>
    </message>
    <message>
        <source>The comparison could not be written. Choose another folder, or make room on the disk.</source>
        <translation>La comparación no se pudo escribir. Elija otra carpeta o libere espacio en el disco.</translation>
    </message>
    <message>
        <source>Hardness presets (%1)</source>
        <translation>Ajustes de dureza (%1)</translation>
    </message>
    <message>
        <source>Tables (%1)</source>
        <translation>Tablas (%1)</translation>
    </message>
</context>
<context>
    <name>ui::window::UnsavedWork</name>
    <message>
        <source>Your work would be lost.</source>
        <translation>Su trabajo se perdería.</translation>
    </message>
    <message>
        <source>Your latest cuts are not saved as a recording.</source>
        <translation>Sus últimos cortes no están guardados como grabación.</translation>
    </message>
    <message>
        <source>&amp;Save the recording …</source>
        <translation>&amp;Guardar la grabación …</translation>
    </message>
    <message>
        <source>The exam would end without a score.</source>
        <translation>El examen terminaría sin puntuación.</translation>
    </message>
    <message>
        <source>It still counts as an attempt. Your work cannot be graded later.</source>
        <translation>Cuenta igualmente como intento. Su trabajo no podrá calificarse más tarde.</translation>
    </message>
    <message>
        <source>&amp;Grade it now</source>
        <translation>&amp;Calificar ahora</translation>
    </message>
    <message numerus="yes">
        <source>%n grade(s) are not saved yet and would be lost.</source>
        <translation>
            <numerusform>%n calificación aún no está guardada y se perdería.</numerusform>
            <numerusform>%n calificaciones aún no están guardadas y se perderían.</numerusform>
        </translation>
    </message>
    <message>
        <source>The disk cannot be written to. Cusp tries again every few seconds while it runs. Free some disk space, or check the permissions of the folder.</source>
        <translation>No se puede escribir en el disco. Cusp lo vuelve a intentar cada pocos segundos mientras está abierto. Libere espacio en el disco o revise los permisos de la carpeta.</translation>
    </message>
</context>
<context>
    <name>ui::window::CommandSender</name>
    <message>
        <source>Cusp was still busy and did not do that. Try again.</source>
        <translation>Cusp aún estaba ocupado y no lo hizo. Inténtelo de nuevo.</translation>
    </message>
</context>
<context>
    <name>ui::window::Notices</name>
    <message numerus="yes">
        <source>%n note(s) about this scan</source>
        <translation>
            <numerusform>%n nota sobre este escaneo</numerusform>
            <numerusform>%n notas sobre este escaneo</numerusform>
        </translation>
    </message>
    <message>
        <source>This is neither a scan (OBJ, STL, PLY) nor a recording. Drop one of those.</source>
        <translation>Esto no es ni un escaneo (OBJ, STL, PLY) ni una grabación. Suelte uno de ellos.</translation>
    </message>
    <message>
        <source>The recording was saved as %1.</source>
        <translation>La grabación se guardó como %1.</translation>
    </message>
    <message>
        <source>Another unit</source>
        <translation>Otra unidad</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Milímetros</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centímetros</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pulgadas</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metros</translation>
    </message>
    <message>
        <source>Keep this unit</source>
        <translation>Mantener esta unidad</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>You had no attempts left at this lesson, so this grade is not saved.</source>
        <translation>Ya no le quedaban intentos en esta lección, así que esta calificación no se guarda.</translation>
    </message>
    <message>
        <source>You can save your work as a recording.</source>
        <translation>Puede guardar su trabajo como grabación.</translation>
    </message>
    <message>
        <source>The school&apos;s database does not answer yet. You can continue drilling; your request is completed when it answers.</source>
        <translation>La base de datos de la escuela aún no responde. Puede seguir tallando; su petición se completará cuando responda.</translation>
    </message>
</context>
<context>
    <name>ui::window::ResumeOffer</name>
    <message>
        <source>Resume</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>%1: an attempt of %2 was not finished.</source>
        <extracomment>%1: &quot;Tooth 36&quot;, &quot;Practice block: line&quot;; %2: a time of today, or a day and a time</extracomment>
        <translation>%1: un intento (%2) quedó sin terminar.</translation>
    </message>
    <message>
        <source>The attempt was discarded; it is kept for seven days.</source>
        <translation>El intento se descartó; se conserva siete días.</translation>
    </message>
    <message>
        <source>Restore it</source>
        <translation>Recuperarlo</translation>
    </message>
    <message>
        <source>&amp;Continue it</source>
        <translation>&amp;Continuarlo</translation>
    </message>
    <message>
        <source>This exam would be discarded without a score.</source>
        <translation>Este examen se descartaría sin puntuación.</translation>
    </message>
    <message>
        <source>It still counts as an attempt. You can restore it right afterwards.</source>
        <translation>Cuenta igualmente como intento. Justo después podrá recuperarlo.</translation>
    </message>
</context>
<context>
    <name>ui::window::LessonController</name>
    <message>
        <source>The tooth was reset.</source>
        <translation>El diente se ha restablecido.</translation>
    </message>
    <message>
        <source>Restore my work</source>
        <translation>Recuperar mi trabajo</translation>
    </message>
    <message>
        <source>Only a tooth with decay has an ideal preparation.</source>
        <translation>Solo un diente con caries tiene una preparación ideal.</translation>
    </message>
    <message>
        <source>The time for this lesson is over. Continue as long as you like, or press G for the grade.</source>
        <translation>El tiempo de esta lección ha terminado. Continúe cuanto quiera o pulse G para la calificación.</translation>
    </message>
    <message>
        <source>The exercise starts again.</source>
        <translation>El ejercicio empieza de nuevo.</translation>
    </message>
    <message>
        <source>Another attempt at the exam begins.</source>
        <translation>Empieza otro intento del examen.</translation>
    </message>
    <message>
        <source>Another attempt at the lesson begins.</source>
        <translation>Empieza otro intento de la lección.</translation>
    </message>
    <message>
        <source>The time for this exam is over: cutting is disabled.</source>
        <translation>El tiempo de este examen ha terminado: ya no se puede tallar.</translation>
    </message>
    <message>
        <source>This exam is over but not graded yet. Press G to grade it.</source>
        <translation>Este examen ha terminado, pero aún no está calificado. Pulse G para calificarlo.</translation>
    </message>
    <message>
        <source>Another attempt begins.</source>
        <translation>Empieza otro intento.</translation>
    </message>
    <message>
        <source>The outline is not available in an exam.</source>
        <translation>El contorno no está disponible en un examen.</translation>
    </message>
    <message>
        <source>This tooth has no ideal preparation.</source>
        <translation>Este diente no tiene una preparación ideal.</translation>
    </message>
    <message>
        <source>This attempt has lasted six hours, the longest that Cusp records: cutting is disabled. Press G for the grade, or R for another attempt.</source>
        <translation>Este intento dura seis horas, lo máximo que Cusp graba: ya no se puede cortar. Pulse G para la calificación o R para otro intento.</translation>
    </message>
</context>
<context>
    <name>ui::window::PracticeController</name>
    <message>
        <source>You can undo the stroke.</source>
        <translation>Puede deshacer la pasada.</translation>
    </message>
    <message>
        <source>Tooth perforated</source>
        <translation>Diente perforado</translation>
    </message>
    <message>
        <source>Pulp opened</source>
        <translation>Pulpa abierta</translation>
    </message>
</context>
<context>
    <name>ui::window::ReplayView</name>
    <message>
        <source>The recording has ended.</source>
        <translation>La grabación ha terminado.</translation>
    </message>
    <message>
        <source>Stop the replay</source>
        <translation>Detener la reproducción</translation>
    </message>
    <message>
        <source>You pushed against the guidance, so it stopped. Press A to start it again.</source>
        <translation>Empujó en contra de la guía, así que se detuvo. Pulse A para iniciarla de nuevo.</translation>
    </message>
    <message>
        <source>The handpiece is no longer available, so the guidance stopped.</source>
        <translation>La pieza de mano ya no está disponible, así que la guía se detuvo.</translation>
    </message>
    <message>
        <source>From a file …</source>
        <translation>De un archivo …</translation>
    </message>
</context>
<context>
    <name>ui::window::HardnessController</name>
    <message>
        <source>Import a hardness preset</source>
        <translation>Importar un ajuste de dureza</translation>
    </message>
    <message>
        <source>Export the hardness preset</source>
        <translation>Exportar el ajuste de dureza</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>Guardar la comparación</translation>
    </message>
    <message>
        <source>The hardness preset was saved: %1.</source>
        <translation>El ajuste de dureza se guardó: %1.</translation>
    </message>
    <message>
        <source>It feels like %1 now.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>Ahora se siente como %1.</translation>
    </message>
    <message>
        <source>The hardness cannot be changed during an exam.</source>
        <translation>La dureza no se puede cambiar durante un examen.</translation>
    </message>
    <message>
        <source>A replay uses the recorded hardness.</source>
        <translation>Una reproducción usa la dureza grabada.</translation>
    </message>
    <message>
        <source>A blind comparison of two presets is running. Finish it first.</source>
        <translation>Hay en curso una comparación a ciegas de dos ajustes. Termínela primero.</translation>
    </message>
    <message>
        <source>This lesson sets its own hardness. Only the forces can be changed.</source>
        <translation>Esta lección fija su propia dureza. Solo se pueden cambiar las fuerzas.</translation>
    </message>
    <message>
        <source>There is no hardness preset &quot;%1&quot;. There are: %2.</source>
        <translation>No hay ningún ajuste de dureza «%1». Hay: %2.</translation>
    </message>
</context>
<context>
    <name>ui::window::AccountController</name>
    <message>
        <source>The one-time code is no longer valid. Ask an admin for a new one.</source>
        <translation>El código de un solo uso ya no es válido. Pida otro a un administrador.</translation>
    </message>
</context>
<context>
    <name>ui::window::LessonEditing</name>
    <message>
        <source>This file is not a valid lesson, so it cannot be edited. Fix the listed errors first.</source>
        <translation>Este archivo no es una lección válida, así que no se puede editar. Corrija primero los errores indicados.</translation>
    </message>
    <message>
        <source>The lesson editor is not available during an exam, because it shows the ideal. Press G to finish the exam, or start another lesson.</source>
        <translation>El editor de lecciones no está disponible durante un examen, porque muestra el ideal. Pulse G para terminar el examen o empiece otra lección.</translation>
    </message>
    <message>
        <source>Only teachers can edit lessons: log in as a teacher. To practise the lesson, choose it in the list.</source>
        <translation>Solo los docentes pueden editar lecciones: inicie sesión como docente. Para practicar la lección, elíjala en la lista.</translation>
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
        <translation>Esto es una reproducción. Deténgala para que se califique su propio trabajo.</translation>
    </message>
    <message>
        <source>You cannot drill from below: the bur is on the other side of the tooth. Turn the tooth back, or press V.</source>
        <translation>No se puede tallar desde abajo: la fresa está al otro lado del diente. Vuelva a girarlo o pulse V.</translation>
    </message>
    <message>
        <source>The simulated handpiece is active</source>
        <extracomment>Beside the name of the tooth, where otherwise &quot;lower left first molar&quot; stands</extracomment>
        <translation>La pieza de mano simulada está activa</translation>
    </message>
    <message>
        <source>Save the X-ray pictures</source>
        <translation>Guardar las radiografías</translation>
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
        <translation>Mensaje</translation>
    </message>
    <message>
        <source>Close this message (Esc)</source>
        <translation>Cerrar este mensaje (Esc)</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Cerrar este mensaje</translation>
    </message>
</context>
<context>
    <name>ui::toothchooser::Mouth</name>
    <message>
        <source>Whole mouth</source>
        <translation>Boca completa</translation>
    </message>
    <message>
        <source>Arrow keys move along the arch, Enter selects the tooth.</source>
        <translation>Las flechas recorren la arcada; Intro elige el diente.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>This computer cannot draw the whole mouth. Use the flat arches instead.</source>
        <translation>Este ordenador no puede dibujar la boca completa. Use en su lugar las arcadas planas.</translation>
    </message>
    <message>
        <source>Creating the teeth …</source>
        <translation>Se están creando los dientes …</translation>
    </message>
    <message>
        <source>Selected. Press Enter or double-click to use it.</source>
        <translation>Elegido. Pulse Intro o haga doble clic para usarlo.</translation>
    </message>
    <message>
        <source>Click to select it.</source>
        <translation>Haga clic para elegirlo.</translation>
    </message>
    <message>
        <source>Only teeth of the left side can be drilled; %1 is its mirror image.</source>
        <translation>Solo se pueden tallar dientes del lado izquierdo; %1 es su imagen especular.</translation>
    </message>
    <message>
        <source>Right button turns, wheel zooms. From above or below you see one jaw.</source>
        <translation>El botón derecho gira, la rueda amplía. Desde arriba o desde abajo se ve un maxilar.</translation>
    </message>
</context>
<context>
    <name>ui::window::PracticeRoom</name>
    <message>
        <source>Move the mouse over the tooth, press the left button to drill; right-drag turns the view; F1 for keys</source>
        <translation>Mueva el ratón sobre el diente y pulse el botón izquierdo para tallar; arrastrar con el derecho gira la vista; F1 muestra las teclas</translation>
    </message>
    <message>
        <source>This attempt</source>
        <translation>Este intento</translation>
    </message>
</context>
<context>
    <name>ui::kit::ConfirmOverlay</name>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Descartar</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>&amp;Stay</source>
        <translation>&amp;Quedarse</translation>
    </message>
</context>
<context>
    <name>ui::kit::ScoreBar</name>
    <message>
        <source>%1 of 100, pass mark %2</source>
        <extracomment>A score bar for the screen reader</extracomment>
        <translation>%1 de 100, aprobado desde %2</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>aprobado desde %1</translation>
    </message>
</context>
<context>
    <name>ui::kit::ScrollPane</name>
    <message>
        <source>More than there is room for</source>
        <translation>Más de lo que cabe</translation>
    </message>
    <message>
        <source>Page Up, Page Down and the arrow keys scroll</source>
        <translation>Re Pág, Av Pág y las flechas desplazan</translation>
    </message>
</context>
<context>
    <name>ui::practice::SidePanel</name>
    <message>
        <source>Live figures and handpiece</source>
        <translation>Medidas en vivo y pieza de mano</translation>
    </message>
    <message>
        <source>Under the bur</source>
        <translation>Bajo la fresa</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Decay left</source>
        <extracomment>Of what is to be taken away: decay, or the preparation that is asked for</extracomment>
        <translation>Caries restante</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Eliminado</translation>
    </message>
    <message>
        <source>Bur</source>
        <translation>Fresa</translation>
    </message>
    <message>
        <source>Air</source>
        <comment>the bur touches nothing</comment>
        <translation>Aire</translation>
    </message>
    <message>
        <source>N, limited</source>
        <extracomment>Unit of the force while the wanted force is beyond what the device may give</extracomment>
        <translation>N, limitada</translation>
    </message>
    <message>
        <source>&lt; 1</source>
        <translation>&lt; 1</translation>
    </message>
    <message>
        <source>Depth of the tip below the original surface. No value is shown at the edge of the tooth, where a vertical depth means little.</source>
        <translation>Profundidad de la punta bajo la superficie original. En el borde del diente no se muestra ningún valor, porque allí la profundidad vertical dice poco.</translation>
    </message>
    <message>
        <source>Area of opened pulp, seen from above. The grade uses this figure.</source>
        <translation>Área de pulpa expuesta, vista desde arriba. La calificación usa este valor.</translation>
    </message>
    <message>
        <source>N, %1 sideways</source>
        <extracomment>Unit of the force, and how much of it comes from a wall that presses sideways</extracomment>
        <translation>N, %1 lateral</translation>
    </message>
    <message>
        <source>beside the decay</source>
        <translation>junto a la caries</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation>Pieza de mano</translation>
    </message>
    <message>
        <source>The handpiece touches the crown, so the bur cannot go deeper.</source>
        <translation>La pieza de mano toca la corona, así que la fresa no puede bajar más.</translation>
    </message>
    <message>
        <source>To the pulp</source>
        <translation>Hasta la pulpa</translation>
    </message>
    <message>
        <source>Shortest distance from the head of the bur to the pulp, downwards or sideways. Leave two millimetres; less than half a millimetre harms the pulp.</source>
        <translation>Distancia más corta de la cabeza de la fresa a la pulpa, hacia abajo o hacia los lados. Deje dos milímetros; menos de medio milímetro daña la pulpa.</translation>
    </message>
    <message>
        <source>To the limit</source>
        <extracomment>How far the bur is from what is to be kept</extracomment>
        <translation>Hasta el límite</translation>
    </message>
    <message>
        <source>Distance from the head of the bur to tissue that must be kept, downwards or sideways. No value is shown above one millimetre.</source>
        <translation>Distancia de la cabeza de la fresa al tejido que debe conservarse, hacia abajo o hacia los lados. Por encima de un milímetro no se muestra ningún valor.</translation>
    </message>
    <message>
        <source>Speed of the bur in revolutions per minute. Load slows it down until it stalls</source>
        <translation>Velocidad de la fresa en revoluciones por minuto. La carga la frena hasta que se para</translation>
    </message>
    <message>
        <source>rpm</source>
        <extracomment>Turns a minute</extracomment>
        <translation>rpm</translation>
    </message>
    <message>
        <source>Still to cut</source>
        <translation>Por tallar</translation>
    </message>
    <message>
        <source>beyond the ideal</source>
        <translation>fuera del ideal</translation>
    </message>
    <message>
        <source>Block</source>
        <extracomment>What a practice block is made of, in place of &quot;Enamel&quot;</extracomment>
        <translation>Bloque</translation>
    </message>
</context>
<context>
    <name>ui::practice::StereoCard</name>
    <message>
        <source>Distance of the eyes</source>
        <translation>Distancia entre los ojos</translation>
    </message>
    <message>
        <source>Plane of the screen</source>
        <translation>Plano de la pantalla</translation>
    </message>
    <message>
        <source>Stereo picture</source>
        <translation>Imagen estéreo</translation>
    </message>
    <message>
        <source>Way to the eyes</source>
        <translation>Forma de llegar a los ojos</translation>
    </message>
    <message>
        <source>Red and cyan glasses, in colour</source>
        <translation>Gafas rojo-cian, en color</translation>
    </message>
    <message>
        <source>Red and cyan glasses, in grey</source>
        <translation>Gafas rojo-cian, en gris</translation>
    </message>
    <message>
        <source>Halves side by side</source>
        <translation>Mitades una al lado de otra</translation>
    </message>
    <message>
        <source>Halves one above the other</source>
        <translation>Mitades una encima de otra</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Without stereo</source>
        <translation>Sin estéreo</translation>
    </message>
    <message>
        <source>1. How do the two pictures reach your eyes? Close one eye, then the other: each must see a single tooth.</source>
        <translation>1. ¿Cómo llegan las dos imágenes a sus ojos? Cierre un ojo y luego el otro: cada uno debe ver un solo diente.</translation>
    </message>
    <message>
        <source>2. Move the eyes apart until the cusps stand up from the fissures, and back a little if it tires you.</source>
        <translation>2. Separe los ojos hasta que las cúspides se alcen sobre las fisuras, y vuelva un poco atrás si le cansa.</translation>
    </message>
    <message>
        <source>3. Move the tooth before or behind the screen until you see it without effort.</source>
        <translation>3. Mueva el diente delante o detrás de la pantalla hasta que lo vea sin esfuerzo.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Discard the changes (Esc)</source>
        <translation>Descartar los cambios (Esc)</translation>
    </message>
</context>
<context>
    <name>ui::toothchooser::ToothChooser</name>
    <message>
        <source>Choose a tooth</source>
        <translation>Elegir un diente</translation>
    </message>
    <message>
        <source>Drill this tooth</source>
        <translation>Tallar este diente</translation>
    </message>
    <message>
        <source>Practise on this tooth (Enter)</source>
        <translation>Practicar en este diente (Intro)</translation>
    </message>
    <message>
        <source>Or drill your own tooth: a scan as an OBJ, STL or PLY file. You can also drop the file anywhere on this window.</source>
        <translation>O talle un diente propio: un escaneo OBJ, STL o PLY. También puede soltar el archivo en cualquier lugar de esta ventana.</translation>
    </message>
    <message>
        <source>No tooth selected</source>
        <translation>Ningún diente elegido</translation>
    </message>
    <message>
        <source>In use. Choosing it again resets it.</source>
        <translation>En uso. Si lo elige de nuevo, se restablece.</translation>
    </message>
    <message>
        <source>Click a tooth, or use the arrow keys.</source>
        <translation>Haga clic en un diente o use las flechas.</translation>
    </message>
    <message>
        <source>Flat arches</source>
        <translation>Arcadas planas</translation>
    </message>
    <message>
        <source>Whole mouth</source>
        <translation>Boca completa</translation>
    </message>
</context>
<context>
    <name>ui::window::Tour</name>
    <message>
        <source>Move the bur with the mouse and press the left button to drill. Drag with the right button to turn the view.</source>
        <translation>Mueva la fresa con el ratón y pulse el botón izquierdo para tallar. Arrastre con el derecho para girar la vista.</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Todas las lecciones</translation>
    </message>
    <message>
        <source>The lessons that come with Cusp, and your own. Search for a word or the number of a tooth.</source>
        <translation>Las lecciones que trae Cusp y las suyas. Busque una palabra o el número de un diente.</translation>
    </message>
    <message>
        <source>Change a lesson</source>
        <translation>Cambiar una lección</translation>
    </message>
    <message>
        <source>Change the goal and the rubric of a lesson, and see the effect on earlier attempts.</source>
        <translation>Cambie el objetivo y la rúbrica de una lección, y vea el efecto en los intentos anteriores.</translation>
    </message>
    <message>
        <source>Your classes</source>
        <translation>Sus grupos</translation>
    </message>
    <message>
        <source>Here you see who needs help and how everybody is doing. Assign lessons, open attempts, replay them, and write comments.</source>
        <translation>Aquí ve quién necesita ayuda y cómo va cada uno. Asigne lecciones, abra intentos, reprodúzcalos y escriba comentarios.</translation>
    </message>
    <message>
        <source>Try it yourself</source>
        <translation>Pruébelo usted</translation>
    </message>
    <message>
        <source>The grade</source>
        <translation>La calificación</translation>
    </message>
    <message>
        <source>Your work is measured, and the score card shows where and when each point was lost.</source>
        <translation>Su trabajo se mide, y la hoja de puntuación muestra dónde y cuándo se perdió cada punto.</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Grupos</translation>
    </message>
    <message>
        <source>The results of every class in every lesson, as its teachers see them.</source>
        <translation>Los resultados de cada grupo en cada lección, tal como los ven sus docentes.</translation>
    </message>
    <message>
        <source>How it feels</source>
        <translation>Cómo se siente</translation>
    </message>
    <message>
        <source>Burs, force and depth are here. The hardness presets (F7) set how hard teeth are.</source>
        <translation>Aquí están las fresas, la fuerza y la profundidad. Los ajustes de dureza (F7) fijan la dureza de los dientes.</translation>
    </message>
    <message>
        <source>The tooth</source>
        <translation>El diente</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>Choose here what to practise. Lessons assigned to your class come first.</source>
        <translation>Elija aquí qué practicar. Las lecciones asignadas a su grupo aparecen primero.</translation>
    </message>
    <message>
        <source>Choose here what to practise. Each lesson states its goal and how it is graded.</source>
        <translation>Elija aquí qué practicar. Cada lección indica su objetivo y cómo se califica.</translation>
    </message>
    <message>
        <source>Bur, force and depth</source>
        <translation>Fresa, fuerza y profundidad</translation>
    </message>
    <message>
        <source>Change the bur, set how hard the mouse presses, and read force and depth while you drill.</source>
        <translation>Cambie de fresa, ajuste cuánto presiona el ratón y lea la fuerza y la profundidad mientras talla.</translation>
    </message>
    <message>
        <source>Seeing inside</source>
        <translation>Ver por dentro</translation>
    </message>
    <message>
        <source>A live section through the bur shows enamel, dentin and pulp, where the lesson allows it.</source>
        <translation>Un corte en vivo a través de la fresa muestra esmalte, dentina y pulpa, si la lección lo permite.</translation>
    </message>
    <message>
        <source>See how your scores develop, read your instructor&apos;s comments, and replay every attempt.</source>
        <translation>Vea cómo evolucionan sus puntuaciones, lea los comentarios de su docente y reproduzca cada intento.</translation>
    </message>
    <message>
        <source>Your account</source>
        <translation>Su cuenta</translation>
    </message>
    <message>
        <source>Log in to save your grades. Without a login, nothing is saved.</source>
        <translation>Inicie sesión para guardar sus calificaciones. Sin iniciar sesión no se guarda nada.</translation>
    </message>
    <message>
        <source>Lock the window when you leave, or switch user.</source>
        <translation>Bloquee la ventana al irse, o cambie de usuario.</translation>
    </message>
    <message>
        <source>Every key</source>
        <translation>Todas las teclas</translation>
    </message>
    <message>
        <source>All keys are listed here. You can also start this tour again from there.</source>
        <translation>Aquí están todas las teclas. Desde ahí también puede repetir esta visita.</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visita guiada</translation>
    </message>
    <message>
        <source>Skip the tour</source>
        <translation>Omitir la visita</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Steps of a tour: &quot;2 of 6&quot;</extracomment>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>The school</source>
        <translation>La escuela</translation>
    </message>
    <message>
        <source>Add people one by one or from a list, assign them to classes, and manage backups and the audit.</source>
        <translation>Añada personas una a una o desde una lista, asígnelas a grupos y gestione las copias de seguridad y la auditoría.</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>Mis intentos</translation>
    </message>
</context>
<context>
    <name>ui::kit::UnsavedChanges</name>
    <message>
        <source>Discard your unsaved changes?</source>
        <extracomment>%1: a user</extracomment>
        <translation>¿Descartar sus cambios sin guardar?</translation>
    </message>
    <message>
        <source>Discard the unsaved changes of %1?</source>
        <translation>¿Descartar los cambios sin guardar de %1?</translation>
    </message>
    <message>
        <source>&amp;Keep editing</source>
        <translation>&amp;Seguir editando</translation>
    </message>
</context>
<context>
    <name>ui::practice::ViewMenu</name>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Choose what the view shows</source>
        <translation>Elegir qué muestra la vista</translation>
    </message>
    <message>
        <source>Look from</source>
        <translation>Mirar desde</translation>
    </message>
    <message>
        <source>Occlusal</source>
        <translation>Oclusal</translation>
    </message>
    <message>
        <source>Buccal</source>
        <translation>Vestibular</translation>
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
        <translation>Apical</translation>
    </message>
</context>
<context>
    <name>ui::scoring::AdviceWords</name>
    <message>
        <source>You drilled right through the tooth. Check the depth in the section while you go down.</source>
        <translation>Ha perforado el diente de lado a lado. Compruebe la profundidad en el corte mientras baja.</translation>
    </message>
    <message>
        <source>The bur went down at %1 mm/s when it opened the pulp. Go down slowly, and stop when the floor is firm dentin.</source>
        <extracomment>%1 is a speed in mm/s</extracomment>
        <translation>La fresa bajaba a %1 mm/s cuando abrió la pulpa. Baje despacio y pare cuando el piso sea dentina firme.</translation>
    </message>
    <message>
        <source>You opened the pulp. Check in the section how much dentin is left before you go deeper, and stop when the floor is firm dentin.</source>
        <translation>Ha abierto la pulpa. Compruebe en el corte cuánta dentina queda antes de profundizar y pare cuando el piso sea dentina firme.</translation>
    </message>
    <message>
        <source>The pulp chamber is not open yet. Go on at the place that the X-ray shows until its roof is gone.</source>
        <translation>La cámara pulpar aún no está abierta. Siga en el lugar que muestra la radiografía hasta eliminar su techo.</translation>
    </message>
    <message>
        <source>%1 % of the decay is still in the tooth. Clean the walls first and then the floor, until no brown is left.</source>
        <extracomment>%1 is a share in per cent</extracomment>
        <translation>Queda un %1 % de la caries en el diente. Limpie primero las paredes y luego el piso, hasta que no quede nada marrón.</translation>
    </message>
    <message>
        <source>The bur went down at %1 mm/s into sound tissue. Lift it as soon as the figure turns yellow.</source>
        <extracomment>%1 is a speed in mm/s</extracomment>
        <translation>La fresa bajó a %1 mm/s en tejido sano. Levántela en cuanto la cifra se ponga amarilla.</translation>
    </message>
    <message>
        <source>You removed %1 mm³ of sound tissue. Follow the brown edge, and take a smaller bur near it.</source>
        <extracomment>%1 is a volume in mm³</extracomment>
        <translation>Ha eliminado %1 mm³ de tejido sano. Siga el borde marrón y use una fresa más pequeña cerca de él.</translation>
    </message>
    <message>
        <source>Enamel is left without dentin under it. Remove the overhanging edge.</source>
        <translation>Queda esmalte sin dentina debajo. Elimine el borde que sobresale.</translation>
    </message>
    <message>
        <source>The bur went down at %1 mm/s and past the floor. Go down slowly, or set the depth stop.</source>
        <extracomment>%1 is a speed in mm/s</extracomment>
        <translation>La fresa bajó a %1 mm/s y pasó del piso. Baje despacio o ajuste el tope de profundidad.</translation>
    </message>
    <message>
        <source>The floor is up to %1 mm too deep. Set the depth stop to the depth that the lesson asks for.</source>
        <translation>El piso es hasta %1 mm demasiado profundo. Ponga el tope de profundidad en la que pide la lección.</translation>
    </message>
    <message>
        <source>The floor is too deep. Set the depth stop to the depth that the lesson asks for.</source>
        <translation>El piso es demasiado profundo. Ponga el tope de profundidad en la que pide la lección.</translation>
    </message>
    <message>
        <source>The floor is up to %1 mm too high. Lower it with the depth stop at the depth that the lesson asks for.</source>
        <translation>El piso está hasta %1 mm demasiado alto. Bájelo con el tope en la profundidad que pide la lección.</translation>
    </message>
    <message>
        <source>%1 % of the preparation is still standing. Compare with the outline and cut what is left inside it.</source>
        <extracomment>%1 is a share in per cent</extracomment>
        <translation>Queda en pie el %1 % de la preparación. Compare con el contorno y talle lo que queda dentro.</translation>
    </message>
    <message>
        <source>You cut up to %1 mm outside the outline. Keep the edge of the bur, not its middle, on the line.</source>
        <translation>Ha tallado hasta %1 mm fuera del contorno. Lleve el borde de la fresa, no su centro, por la línea.</translation>
    </message>
    <message>
        <source>You cut outside the outline. Keep the edge of the bur, not its middle, on the line.</source>
        <translation>Ha tallado fuera del contorno. Lleve el borde de la fresa, no su centro, por la línea.</translation>
    </message>
    <message>
        <source>The outline stays up to %1 mm inside the ideal one. Widen the cavity to the line.</source>
        <translation>El contorno queda hasta %1 mm por dentro del ideal. Amplíe la cavidad hasta la línea.</translation>
    </message>
    <message>
        <source>The marginal ridge is only %1 mm wide; it should keep %2 mm. Stop earlier on the way to the ridge.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>La cresta marginal mide solo %1 mm; deben quedar %2 mm. Deténgase antes al acercarse a la cresta.</translation>
    </message>
    <message>
        <source>The isthmus is %1 mm too wide. Go through it once, with a bur that is not wider than it.</source>
        <translation>El istmo es %1 mm demasiado ancho. Páselo una sola vez con una fresa que no sea más ancha.</translation>
    </message>
    <message>
        <source>The isthmus is %1 mm too narrow. Widen it evenly on both sides.</source>
        <translation>El istmo es %1 mm demasiado estrecho. Ensánchelo por igual a ambos lados.</translation>
    </message>
    <message>
        <source>A wall leans %1° from the ideal. Move the bur along the wall in one stroke at full depth.</source>
        <translation>Una pared se desvía %1° del ideal. Recorra la pared con la fresa de una vez a toda la profundidad.</translation>
    </message>
    <message>
        <source>The floor is uneven. Keep the depth stop on, and sweep the floor in strokes that overlap.</source>
        <translation>El piso es irregular. Deje puesto el tope de profundidad y pase por el piso con pasadas que se solapen.</translation>
    </message>
    <message>
        <source>Too little is done to judge this. Finish the preparation first.</source>
        <translation>Se ha hecho demasiado poco para juzgarlo. Termine primero la preparación.</translation>
    </message>
    <message>
        <source>You pushed too hard. Let the bur do the work.</source>
        <translation>Ha apretado demasiado. Deje que trabaje la fresa.</translation>
    </message>
    <message>
        <source>Watch the gauge and change the force slowly until it stays in the range.</source>
        <translation>Observe el indicador y cambie la fuerza despacio hasta que se mantenga en el intervalo.</translation>
    </message>
    <message>
        <source>You took longer than asked. Plan the strokes before you begin.</source>
        <translation>Ha tardado más de lo pedido. Planifique las pasadas antes de empezar.</translation>
    </message>
    <message>
        <source>Some points are not touched yet. The ring marks one of them.</source>
        <translation>Faltan puntos por tocar. El anillo marca uno de ellos.</translation>
    </message>
    <message>
        <source>Touch each pad slowly again: enamel is hardest, dentin yields, decay is soft.</source>
        <translation>Toque de nuevo cada zona despacio: el esmalte es lo más duro, la dentina cede, la caries es blanda.</translation>
    </message>
    <message>
        <source>You cut the tooth. In this exercise the bur only touches it: do not press the drill.</source>
        <translation>Ha cortado el diente. En este ejercicio la fresa solo lo toca: no accione la fresa.</translation>
    </message>
    <message>
        <source>Only %1 mm of dentin is left over the pulp. Watch the figure for the remaining dentin, and stop earlier.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>Solo quedan %1 mm de dentina sobre la pulpa. Vigile la cifra de la dentina restante y deténgase antes.</translation>
    </message>
    <message>
        <source>You cut the tooth %1 mm away from the decay. Lift the bur before you move it, and cut at the decay only.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>Talló el diente a %1 mm de la caries. Levante la fresa antes de moverla y talle solo en la caries.</translation>
    </message>
    <message>
        <source>The cavity goes %1 mm below the decay. Stop as soon as no brown is left at the bottom.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>La cavidad llega %1 mm por debajo de la caries. Deténgase en cuanto no quede marrón en el fondo.</translation>
    </message>
    <message>
        <source>The floor is still in enamel. Lower it until it lies just inside dentin.</source>
        <translation>El piso está todavía en esmalte. Bájelo hasta que quede justo en dentina.</translation>
    </message>
    <message>
        <source>The floor is tilted by %1°. Keep the depth stop on, and compare both ends in the section.</source>
        <translation>El piso está inclinado %1°. Mantenga el tope de profundidad y compare ambos extremos en el corte.</translation>
    </message>
    <message>
        <source>The turning bur touched the neighbouring tooth. Leave a thin shell of enamel towards it, and break it off last.</source>
        <translation>La fresa en marcha tocó el diente vecino. Deje una pared fina de esmalte hacia él y quítela al final.</translation>
    </message>
    <message>
        <source>The walls are wavy. Go along each wall once more with the side of the bur, in one light stroke.</source>
        <translation>Las paredes son onduladas. Repase cada pared con el costado de la fresa, en una sola pasada ligera.</translation>
    </message>
    <message>
        <source>Only %1 mm of the oblique ridge is left; it should keep %2 mm. Stop earlier on both sides of it.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>Solo quedan %1 mm de la cresta oblicua; deben quedar %2 mm. Deténgase antes a ambos lados.</translation>
    </message>
    <message>
        <source>The gingival floor is %1 mm off the height that the lesson asks for. Check its depth in the section before you widen the box.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>El piso gingival se aparta %1 mm de la altura que pide la lección. Compruebe su profundidad en el corte antes de ensanchar el cajón.</translation>
    </message>
    <message>
        <source>The axial wall of the box is %1 mm too far inside the tooth. Compare the depth of the box with the width of the bur before you go on inwards.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>La pared axial del cajón está %1 mm demasiado adentro. Compare la profundidad del cajón con el ancho de la fresa antes de seguir hacia dentro.</translation>
    </message>
    <message>
        <source>The axial wall of the box is %1 mm too far outside. Move the bur inwards along the whole wall.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>La pared axial del cajón está %1 mm demasiado afuera. Lleve la fresa hacia dentro a lo largo de toda la pared.</translation>
    </message>
    <message>
        <source>The %1 mm pit is %2 mm too deep. Lift the bur sooner, and compare the depth with the head of the bur.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>El pozo de %1 mm es %2 mm demasiado profundo. Levante antes la fresa y compare la profundidad con su cabeza.</translation>
    </message>
    <message>
        <source>The %1 mm pit is %2 mm too shallow. Go down in short steps, and compare the depth with the head of the bur.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>Al pozo de %1 mm le faltan %2 mm de profundidad. Baje a pasos cortos y compare la profundidad con la cabeza de la fresa.</translation>
    </message>
    <message>
        <source>You cut %1 mm³ of dentin. Stop as soon as the bur sinks more easily and the floor looks yellow.</source>
        <extracomment>%1 is a volume in mm³</extracomment>
        <translation>Ha tallado %1 mm³ de dentina. Pare en cuanto la fresa entre con más facilidad y el piso se vea amarillo.</translation>
    </message>
    <message>
        <source>Up to %1 mm of enamel is left on the floor. Cut on with light strokes until the bur meets less resistance.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>En el piso quedan hasta %1 mm de esmalte. Siga con pasadas ligeras hasta que la resistencia disminuya.</translation>
    </message>
    <message>
        <source>%1 % of the soft decay is still in the tooth. Remove it from the walls and the floor until the bur meets more resistance.</source>
        <extracomment>%1 is a share in per cent</extracomment>
        <translation>El %1 % de la caries blanda sigue en el diente. Elimínela de las paredes y del piso hasta que la fresa encuentre más resistencia.</translation>
    </message>
    <message>
        <source>Leathery decay is left on %1 mm² that do not lie over the pulp. Remove it there down to firm dentin.</source>
        <extracomment>%1 is an area in mm²</extracomment>
        <translation>Queda caries correosa en %1 mm² que no están sobre la pulpa. Elimínela allí hasta la dentina firme.</translation>
    </message>
    <message>
        <source>Decay is left at the enamel-dentin junction on %1 mm². Clean the junction all the way round.</source>
        <extracomment>%1 is an area in mm²</extracomment>
        <translation>Queda caries en %1 mm² del límite amelodentinario. Limpie el límite todo alrededor.</translation>
    </message>
    <message>
        <source>The cavity goes %1 mm deeper than the decay that had to be removed. Stop at firm dentin, and over the pulp at leathery dentin.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>La cavidad llega %1 mm más abajo que la caries que había que eliminar. Deténgase en la dentina firme y, sobre la pulpa, en la correosa.</translation>
    </message>
    <message>
        <source>A marginal ridge that should stay is %1 mm thinner than it should be. Stop earlier on the way to the ridge.</source>
        <translation>Una cresta marginal que debe conservarse es %1 mm más fina de lo debido. Deténgase antes al acercarse a la cresta.</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ConductNotes</name>
    <message>
        <source>No breach of the rules</source>
        <translation>Ninguna infracción de las reglas</translation>
    </message>
    <message numerus="yes">
        <source>%n breach(es) of the rules</source>
        <translation>
            <numerusform>%n infracción de las reglas</numerusform>
            <numerusform>%n infracciones de las reglas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Replay the attempt from this moment</source>
        <translation>Reproducir el intento desde este momento</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>breaches</comment>
        <translation>
            <numerusform>%n más</numerusform>
            <numerusform>%n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Show every breach</source>
        <translation>Mostrar todas las infracciones</translation>
    </message>
    <message>
        <source>%1 in total, %2 of it cutting</source>
        <extracomment>Two times in minutes and seconds</extracomment>
        <translation>%1 en total, %2 tallando</translation>
    </message>
    <message>
        <source>force: mean %1 N, maximum %2 N</source>
        <translation>fuerza media %1 N, máxima %2 N</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) undone</source>
        <translation>
            <numerusform>%n paso deshecho</numerusform>
            <numerusform>%n pasos deshechos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::scoring::CriterionRow</name>
    <message>
        <source>%1 not measured</source>
        <extracomment>%1: points of a score. What could not be measured earns nothing</extracomment>
        <translation>%1 sin medir</translation>
    </message>
    <message>
        <source>%1 not removed</source>
        <translation>%1 no eliminados</translation>
    </message>
    <message>
        <source>%1 not achieved</source>
        <extracomment>Of a criterion that was not fulfilled at any time</extracomment>
        <translation>%1 no alcanzados</translation>
    </message>
    <message>
        <source>%1 at %2, stroke %3</source>
        <extracomment>%1: points lost, %2: minutes and seconds of the attempt, %3: number of a stroke of the bur</extracomment>
        <translation>%1 en %2, pasada %3</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>The exposed area, seen from above. The side panel shows the removed volume, in mm³.</source>
        <translation>El área expuesta, vista desde arriba. El panel lateral muestra el volumen eliminado, en mm³.</translation>
    </message>
    <message>
        <source>The attempt fails and all remaining points are lost</source>
        <extracomment>Tooltip on the points of one criterion</extracomment>
        <translation>No se aprueba el intento y se pierden todos los puntos restantes</translation>
    </message>
    <message>
        <source>At most %1 points can be lost here</source>
        <translation>Aquí se pueden perder como máximo %1 puntos</translation>
    </message>
    <message>
        <source>%1: %2, %3 points</source>
        <extracomment>A row of a score, for the screen reader: %1 a criterion, %2 what was measured, %3 the points it cost</extracomment>
        <translation>%1: %2, %3 puntos</translation>
    </message>
    <message>
        <source>Show the worst place</source>
        <translation>Mostrar el peor lugar</translation>
    </message>
    <message>
        <source>Replay the attempt from this moment</source>
        <translation>Reproducir el intento desde este momento</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>moments at which points were lost</comment>
        <translation>
            <numerusform>%n más</numerusform>
            <numerusform>%n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Show every moment</source>
        <translation>Mostrar todos los momentos</translation>
    </message>
    <message>
        <source>%1 too late</source>
        <extracomment>%1: points of a score, for something that was done later than asked</extracomment>
        <translation>%1 por tardar</translation>
    </message>
    <message>
        <source>%1 work incomplete</source>
        <extracomment>%1: points of a score that is earned only when enough of the work is done</extracomment>
        <translation>%1 trabajo incompleto</translation>
    </message>
    <message>
        <source>This error limits the score to %1 points</source>
        <translation>Este error limita la puntuación a %1 puntos</translation>
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
        <translation>Elegir este material para el campo; puede cambiarlo hasta la calificación</translation>
    </message>
    <message>
        <source>✓ right</source>
        <extracomment>Beside what the student took a pad for; %1 is the tissue that it is</extracomment>
        <translation>✓ correcto</translation>
    </message>
    <message>
        <source>✗ it is %1</source>
        <translation>✗ es %1</translation>
    </message>
    <message numerus="yes">
        <source>All %n points touched</source>
        <translation>
            <numerusform>%n punto tocado</numerusform>
            <numerusform>Los %n puntos tocados</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 points touched</source>
        <translation>%1 de %2 puntos tocados</translation>
    </message>
    <message>
        <source>Held for %1 s</source>
        <extracomment>%1 is a time in seconds</extracomment>
        <translation>Mantenida %1 s</translation>
    </message>
    <message>
        <source>Hold %1 N for %2 s</source>
        <translation>Mantener %1 N durante %2 s</translation>
    </message>
    <message>
        <source>of %1 s</source>
        <extracomment>Behind the seconds that a force has been held: of how many</extracomment>
        <translation>de %1 s</translation>
    </message>
    <message>
        <source>The materials of the pads</source>
        <translation>Los materiales de los campos</translation>
    </message>
    <message>
        <source>Every pad has an answer</source>
        <translation>Cada campo tiene una respuesta</translation>
    </message>
    <message>
        <source>What is each pad made of?</source>
        <translation>¿De qué está hecho cada campo?</translation>
    </message>
    <message>
        <source>Graded. Press F2 for the next lesson.</source>
        <translation>Calificado. Pulse F2 para la lección siguiente.</translation>
    </message>
    <message>
        <source>Well done. Press G for your grade.</source>
        <translation>Bien hecho. Pulse G para la calificación.</translation>
    </message>
    <message>
        <source>Sure? Then press G for your grade.</source>
        <translation>¿Seguro? Entonces pulse G para la calificación.</translation>
    </message>
    <message>
        <source>The bur is turning. Stop it with the space bar: this exercise needs no cutting.</source>
        <translation>La fresa está girando. Deténgala con la barra espaciadora: en este ejercicio no se talla nada.</translation>
    </message>
    <message>
        <source>Start the bur with the space bar: while it is stopped, all three feel the same.</source>
        <translation>Ponga en marcha la fresa con la barra espaciadora: mientras está parada, los tres se notan igual.</translation>
    </message>
    <message>
        <source>Longest so far: %1 s</source>
        <extracomment>%1 is a time in seconds</extracomment>
        <translation>La más larga hasta ahora: %1 s</translation>
    </message>
    <message>
        <source>Any order. A ring becomes a disc when touched.</source>
        <translation>En cualquier orden. Un anillo tocado se convierte en disco.</translation>
    </message>
    <message>
        <source>Anywhere on the tooth.</source>
        <translation>En cualquier lugar del diente.</translation>
    </message>
    <message>
        <source>Press on each for a second, and compare.</source>
        <translation>Presione un segundo en cada uno y compare.</translation>
    </message>
</context>
<context>
    <name>ui::scoring::FeedbackCard</name>
    <message>
        <source>%1 commented on your attempt: %2</source>
        <extracomment>%1: a teacher; %2: a lesson</extracomment>
        <translation>%1 ha comentado su intento: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n of your attempts have new feedback</source>
        <translation>
            <numerusform>Hay comentarios nuevos sobre %n de sus intentos</numerusform>
            <numerusform>Hay comentarios nuevos sobre %n de sus intentos</numerusform>
        </translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Leer</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>Mis intentos</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ScorePredictionPage</name>
    <message>
        <source>Before you see the score</source>
        <translation>Antes de ver la puntuación</translation>
    </message>
    <message>
        <source>How many points do you expect?</source>
        <translation>¿Cuántos puntos espera?</translation>
    </message>
    <message>
        <source>What cost you most?</source>
        <translation>¿Qué le costó más?</translation>
    </message>
    <message>
        <source>Show the score</source>
        <translation>Mostrar la puntuación</translation>
    </message>
    <message>
        <source>Show how your work was graded (Enter)</source>
        <translation>Mostrar cómo se calificó su trabajo (Intro)</translation>
    </message>
    <message>
        <source>%1. The pass mark is %2 of 100 points. You learn more from a score if you assess your own work first.</source>
        <extracomment>%1 is a lesson, %2 the mark that is needed</extracomment>
        <translation>%1. Se aprueba con %2 de 100 puntos. Se aprende más de una puntuación si antes se autoevalúa el trabajo.</translation>
    </message>
    <message>
        <source>Set the points that you expect.</source>
        <translation>Indique los puntos que espera.</translation>
    </message>
</context>
<context>
    <name>ui::scoring::HeatMap</name>
    <message>
        <source>The tooth from above, coloured by what is too deep and what is still to cut</source>
        <translation>El diente desde arriba, coloreado según lo que es demasiado profundo y lo que falta</translation>
    </message>
    <message>
        <source>as it should be</source>
        <translation>como debe ser</translation>
    </message>
    <message>
        <source>%1 mm too deep</source>
        <translation>%1 mm demasiado profundo</translation>
    </message>
    <message>
        <source>%1 mm still to cut</source>
        <translation>faltan %1 mm</translation>
    </message>
    <message>
        <source>still to cut</source>
        <translation>por tallar</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>demasiado profundo</translation>
    </message>
    <message>
        <source>To mark the place of a comment, click the tooth or use the arrow keys. Delete removes the mark.</source>
        <translation>Para marcar el lugar de un comentario, haga clic en el diente o use las flechas. Supr quita la marca.</translation>
    </message>
</context>
<context>
    <name>ui::practice::HoldGauge</name>
    <message>
        <source>Force in relation to the range from %1 to %2 N</source>
        <translation>Fuerza respecto al intervalo de %1 a %2 N</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::IdealForm</name>
    <message>
        <source>What the ideal is</source>
        <translation>Qué es el ideal</translation>
    </message>
    <message>
        <source>Take recordings as the reference …</source>
        <translation>Tomar grabaciones como referencia …</translation>
    </message>
    <message>
        <source>Choose one attempt, or several whose mean is to be cut</source>
        <translation>Elegir un intento, o varios cuya media hay que tallar</translation>
    </message>
    <message>
        <source>The ideal is the decay itself: nothing is to be set</source>
        <translation>El ideal es la propia caries: no hay nada que ajustar</translation>
    </message>
    <message>
        <source>An exercise: nothing is to be cut</source>
        <translation>Un ejercicio: no hay que tallar nada</translation>
    </message>
    <message>
        <source>Ideal preparation</source>
        <translation>Preparación ideal</translation>
    </message>
    <message>
        <source>By rule</source>
        <extracomment>%1: the name of a file</extracomment>
        <translation>Por regla</translation>
    </message>
    <message>
        <source>Captured: %1</source>
        <translation>Capturado: %1</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <extracomment>%1 and %2: the least and the greatest number that can be set; %3: a unit</extracomment>
        <translation>de %1 a %2 %3</translation>
    </message>
</context>
<context>
    <name>ui::practice::InfractionCard</name>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Restore the tooth as it was before this; you can redo it (Enter)</source>
        <translation>Devolver el diente a como estaba antes; se puede rehacer (Intro)</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Keep the tooth as it is and continue (Esc)</source>
        <translation>Dejar el diente como está y continuar (Esc)</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::LessonEditor</name>
    <message>
        <source>Lesson editor</source>
        <translation>Editor de lecciones</translation>
    </message>
    <message>
        <source>Title of the lesson</source>
        <translation>Título de la lección</translation>
    </message>
    <message>
        <source>Take recordings as the reference …</source>
        <translation>Tomar grabaciones como referencia …</translation>
    </message>
    <message>
        <source>On the tooth</source>
        <translation>En el diente</translation>
    </message>
    <message>
        <source>What the tolerances mean on the tooth</source>
        <translation>Qué significan las tolerancias en el diente</translation>
    </message>
    <message>
        <source>Past attempts</source>
        <translation>Intentos anteriores</translation>
    </message>
    <message>
        <source>How attempts would score under other tolerances</source>
        <translation>Cómo puntuarían los intentos con otras tolerancias</translation>
    </message>
    <message>
        <source>The lesson&apos;s file</source>
        <translation>El archivo de la lección</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>The lesson as its file says it</source>
        <translation>La lección tal como la dice su archivo</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save the lesson</source>
        <translation>Guardar la lección</translation>
    </message>
    <message>
        <source>Write the lesson into your folder (Ctrl+S)</source>
        <translation>Escribir la lección en su carpeta (Control+S)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Widen the tolerances until the ideal itself loses nothing</source>
        <translation>Ampliar las tolerancias hasta que el propio ideal no pierda nada</translation>
    </message>
    <message>
        <source>Fit the tolerances to the ideal</source>
        <translation>Ajustar las tolerancias al ideal</translation>
    </message>
    <message>
        <source>Lesson editor: %1</source>
        <translation>Editor de lecciones: %1</translation>
    </message>
    <message>
        <source>A shipped lesson: saved, it becomes one of your own, based on it.</source>
        <translation>Una lección incluida: al guardarla se convierte en una propia, basada en ella.</translation>
    </message>
    <message>
        <source>This lesson of yours is changed where it stands.</source>
        <translation>Esta lección propia se cambia en su lugar.</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>Aún sin guardar.</translation>
    </message>
    <message>
        <source>This rubric has no criterion that can be drawn on the tooth.</source>
        <translation>Esta rúbrica no tiene ningún criterio que se pueda dibujar en el diente.</translation>
    </message>
    <message>
        <source>Costs nothing: %1.</source>
        <translation>No cuesta nada: %1.</translation>
    </message>
    <message>
        <source>The ideal is checked as soon as nothing is wrong.</source>
        <translation>El ideal se comprueba en cuanto no haya nada mal.</translation>
    </message>
    <message>
        <source>The ideal scores %1 on itself</source>
        <translation>El ideal obtiene %1 frente a sí mismo</translation>
    </message>
    <message>
        <source>The ideal scores only %1 on itself; it loses at: %2</source>
        <translation>El ideal solo obtiene %1 frente a sí mismo; pierde en: %2</translation>
    </message>
    <message>
        <source>Recordings (%1)</source>
        <translation>Grabaciones (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Replaying %n recording(s) …</source>
        <translation>
            <numerusform>Reproduciendo %n grabación …</numerusform>
            <numerusform>Reproduciendo %n grabaciones …</numerusform>
        </translation>
    </message>
    <message>
        <source>No reference was made: %1</source>
        <translation>No se creó ninguna referencia: %1</translation>
    </message>
    <message>
        <source>The reference is %1 beside your lessons.</source>
        <translation>La referencia es %1, junto a sus lecciones.</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>No guardado: %1</translation>
    </message>
    <message>
        <source>Not saved: whoever cuts exactly this ideal would lose points. Widen the tolerances that are named, or press Fit.</source>
        <translation>No guardado: quien tallara exactamente este ideal perdería puntos. Amplíe las tolerancias indicadas o pulse «Ajustar».</translation>
    </message>
    <message>
        <source>Not saved: there is a file %1 already. Open that lesson instead.</source>
        <translation>No guardado: ya existe un archivo %1. Abra esa lección en su lugar.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Guardado como %1.</translation>
    </message>
    <message>
        <source>An exercise has no ideal that could be checked.</source>
        <translation>Un ejercicio no tiene ningún ideal que comprobar.</translation>
    </message>
    <message>
        <source>Wrong: %1</source>
        <extracomment>%1: where in the lesson, and what is wrong there</extracomment>
        <translation>Error: %1</translation>
    </message>
    <message>
        <source>Not measured or not earned on this ideal, so no tolerance helps: %1. Mark by another rubric.</source>
        <translation>No medido o no ganado en este ideal, así que ninguna tolerancia ayuda: %1. Califique según otra rúbrica.</translation>
    </message>
    <message>
        <source>The lesson needs a title.</source>
        <translation>La lección necesita un título.</translation>
    </message>
    <message>
        <source>Not saved: %1 has been changed since you opened it, in another window or at another computer. Open it anew to see that; a step back then brings your own changes back, to be saved in its place.</source>
        <translation>No guardado: %1 ha cambiado desde que usted lo abrió, en otra ventana o en otro ordenador. Ábralo de nuevo para verlo; después, un paso atrás recupera sus propios cambios, que se pueden guardar en su lugar.</translation>
    </message>
    <message>
        <source>Open anew</source>
        <translation>Abrir de nuevo</translation>
    </message>
    <message>
        <source>Show what stands in the file now; a step back brings your own changes back</source>
        <translation>Mostrar lo que dice ahora el archivo; un paso atrás recupera los cambios propios</translation>
    </message>
    <message>
        <source>%1 is no lesson as it stands now, and was not opened. Look at it with whoever has changed it.</source>
        <translation>%1, tal como está ahora, no es una lección y no se abrió. Revíselo con quien lo haya cambiado.</translation>
    </message>
    <message>
        <source>This is what stands in the file now. A step back brings your own changes back.</source>
        <translation>Esto es lo que dice ahora el archivo. Un paso atrás recupera sus propios cambios.</translation>
    </message>
    <message numerus="yes">
        <source>What you have changed in %n lesson(s) would be lost.</source>
        <translation>
            <numerusform>Lo que ha cambiado en %n lección se perdería.</numerusform>
            <numerusform>Lo que ha cambiado en %n lecciones se perdería.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::catalog::LessonPicture</name>
    <message>
        <source>What the lesson asks for, as a picture</source>
        <translation>Lo que pide la lección, en imagen</translation>
    </message>
    <message>
        <source>This tooth cannot be created.</source>
        <translation>No se puede crear este diente.</translation>
    </message>
    <message>
        <source>Creating the tooth …</source>
        <translation>Se está creando el diente …</translation>
    </message>
</context>
<context>
    <name>ui::practice::LessonStrip</name>
    <message>
        <source>Previous step</source>
        <translation>Paso anterior</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Paso siguiente</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Pista</translation>
    </message>
    <message>
        <source>Show a hint for this step</source>
        <translation>Mostrar una pista para este paso</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>A step of the work, and how many there are</extracomment>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Working time</source>
        <translation>Tiempo de trabajo</translation>
    </message>
    <message>
        <source>Remaining time of %1</source>
        <translation>Tiempo restante de %1</translation>
    </message>
    <message>
        <source>The exam is over and cutting is disabled. Press G for the score or R for another attempt.</source>
        <translation>El examen ha terminado y ya no se puede tallar. Pulse G para la puntuación o R para otro intento.</translation>
    </message>
    <message>
        <source>The exam is over and cutting is disabled. Press G for the score.</source>
        <translation>El examen ha terminado y ya no se puede tallar. Pulse G para la puntuación.</translation>
    </message>
    <message>
        <source>Remove the brown decay. Stop when the floor is firm dentin.</source>
        <translation>Elimine la caries marrón. Pare cuando el piso sea dentina firme.</translation>
    </message>
    <message>
        <source>The decay is out. Press G for the score.</source>
        <translation>La caries está eliminada. Pulse G para la nota.</translation>
    </message>
</context>
<context>
    <name>ui::catalog::LessonsPage</name>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>Search: a word, or the number of a tooth</source>
        <translation>Buscar: una palabra o el número de un diente</translation>
    </message>
    <message>
        <source>Search the lessons</source>
        <translation>Buscar en las lecciones</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Borrar la búsqueda</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Start this lesson</source>
        <translation>Empezar esta lección</translation>
    </message>
    <message>
        <source>Load the tooth of this lesson (Enter)</source>
        <translation>Cargar el diente de esta lección (Intro)</translation>
    </message>
    <message>
        <source>Your own lessons …</source>
        <translation>Sus propias lecciones …</translation>
    </message>
    <message>
        <source>Open the folder for lessons that teachers add</source>
        <translation>Abrir la carpeta en la que los docentes añaden lecciones</translation>
    </message>
    <message>
        <source>Open the folder of your own lessons</source>
        <translation>Abrir la carpeta de sus propias lecciones</translation>
    </message>
    <message>
        <source>exam</source>
        <translation>examen</translation>
    </message>
    <message>
        <source>Invalid file</source>
        <translation>Archivo no válido</translation>
    </message>
    <message>
        <source>This file is not a valid lesson. The other lessons work.</source>
        <translation>Este archivo no es una lección válida. Las demás lecciones funcionan.</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Diente</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Practice: mistakes are reported at once</source>
        <translation>Práctica: los errores se indican al momento</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Burs</source>
        <translation>Fresas</translation>
    </message>
    <message>
        <source>Aids</source>
        <translation>Ayudas</translation>
    </message>
    <message>
        <source>Rubric</source>
        <extracomment>%1 is the name of a rubric, %2 the mark that is needed</extracomment>
        <translation>Rúbrica</translation>
    </message>
    <message>
        <source>%1, passed from %2</source>
        <translation>%1, aprobado desde %2</translation>
    </message>
    <message>
        <source>Not modelled</source>
        <translation>No modelado</translation>
    </message>
    <message>
        <source>Your best</source>
        <translation>Su mejor resultado</translation>
    </message>
    <message numerus="yes">
        <source>%1 in %n attempt(s)</source>
        <translation>
            <numerusform>%1 en %n intento</numerusform>
            <numerusform>%1 en %n intentos</numerusform>
        </translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>changed, not saved</source>
        <extracomment>Of a lesson in a list: in the editor</extracomment>
        <translation>cambiada, sin guardar</translation>
    </message>
    <message>
        <source>best %1, passed</source>
        <extracomment>For a screen reader: the best score of a lesson</extracomment>
        <translation>mejor %1, aprobado</translation>
    </message>
    <message>
        <source>best %1, not passed</source>
        <translation>mejor %1, no aprobado</translation>
    </message>
    <message>
        <source>Exam: mistakes are recorded and reported at the end; undo is disabled</source>
        <translation>Examen: los errores se registran y se indican al final; no se puede deshacer</translation>
    </message>
    <message>
        <source>Tooth …</source>
        <translation>Diente …</translation>
    </message>
    <message>
        <source>Lessons on one tooth</source>
        <translation>Lecciones de un diente</translation>
    </message>
    <message>
        <source>Choose a tooth in the arch to see its lessons</source>
        <translation>Elegir un diente de la arcada para ver sus lecciones</translation>
    </message>
    <message>
        <source>All</source>
        <extracomment>All lessons</extracomment>
        <translation>Todas</translation>
    </message>
    <message>
        <source>To do</source>
        <extracomment>Lessons that are still to be done</extracomment>
        <translation>Por hacer</translation>
    </message>
    <message>
        <source>Passed</source>
        <extracomment>Lessons that were passed</extracomment>
        <translation>Superadas</translation>
    </message>
    <message>
        <source>Exams</source>
        <translation>Exámenes</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Discard the unfinished attempt</source>
        <translation>Descartar el intento sin terminar</translation>
    </message>
    <message>
        <source>Continue %1, started %2</source>
        <extracomment>%1: a lesson or a tooth; %2: a time of today, or a day and a time</extracomment>
        <translation>Continuar: %1, empezado %2</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Last attempt: %1, best so far %2</source>
        <extracomment>%1: a lesson; %2: points</extracomment>
        <translation>Último intento: %1, mejor hasta ahora %2</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Intentar de nuevo</translation>
    </message>
    <message>
        <source>Assigned to you, but not on this computer: %1. Ask your teacher for the file.</source>
        <translation>Asignado a usted, pero no está en este ordenador: %1. Pida el archivo a su docente.</translation>
    </message>
    <message>
        <source>Assigned to you</source>
        <translation>Asignadas a usted</translation>
    </message>
    <message>
        <source>No matching lessons</source>
        <translation>Ninguna lección coincide</translation>
    </message>
    <message>
        <source>Search for another word, or show all lessons.</source>
        <translation>Busque otra palabra o muestre todas las lecciones.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) left</source>
        <translation>
            <numerusform>queda %n intento</numerusform>
            <numerusform>quedan %n intentos</numerusform>
        </translation>
    </message>
    <message>
        <source>Assigned to</source>
        <translation>Asignada a</translation>
    </message>
    <message>
        <source>There are no such lessons now. Show all lessons.</source>
        <translation>Ahora no hay lecciones así. Muestre todas las lecciones.</translation>
    </message>
    <message>
        <source>Loading the lessons …</source>
        <translation>Cargando las lecciones …</translation>
    </message>
    <message>
        <source>no score yet</source>
        <translation>aún sin puntuación</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sin límite</translation>
    </message>
    <message>
        <source>%1 graded so far</source>
        <extracomment>Of attempts at a lesson; follows &quot;2 attempts left, &quot;</extracomment>
        <translation>calificados hasta ahora: %1</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::RubricForm</name>
    <message>
        <source>Marking</source>
        <translation>Calificación</translation>
    </message>
    <message>
        <source>Passed from</source>
        <translation>Aprobado desde</translation>
    </message>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Nota de aprobado</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Tolerance of: %1</source>
        <extracomment>%1: a criterion</extracomment>
        <translation>Tolerancia de: %1</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>suspende</translation>
    </message>
    <message>
        <source>Weight of: %1</source>
        <translation>Peso de: %1</translation>
    </message>
    <message>
        <source>All weights: %1 points</source>
        <translation>Todos los pesos: %1 puntos</translation>
    </message>
    <message>
        <source>All weights: %1 points; they must make 100</source>
        <translation>Todos los pesos: %1 puntos; deben sumar 100</translation>
    </message>
    <message>
        <source>Targets and spans</source>
        <translation>Objetivos y márgenes</translation>
    </message>
    <message>
        <source>What each measure ought to be, and how far beyond the tolerance all points are lost</source>
        <translation>Qué debe ser cada medida, y a qué distancia más allá de la tolerancia se pierden todos los puntos</translation>
    </message>
    <message>
        <source>Target</source>
        <extracomment>What a measure ought to be</extracomment>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Target of: %1</source>
        <translation>Objetivo de: %1</translation>
    </message>
    <message>
        <source>all lost over</source>
        <extracomment>How far beyond the tolerance all points of a criterion are lost</extracomment>
        <translation>todo perdido en</translation>
    </message>
    <message>
        <source>Span of: %1</source>
        <translation>Margen de: %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <extracomment>%1: the points that an error leaves at most</extracomment>
        <translation>como máximo %1</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ScoreHistory</name>
    <message numerus="yes">
        <source>Of the best results of %n people in your class, %1 % are below this.</source>
        <extracomment>%1 is a number of per cent</extracomment>
        <translation>
            <numerusform>De los mejores resultados de %n persona de su grupo, el %1 % está por debajo de este.</numerusform>
            <numerusform>De los mejores resultados de %n personas de su grupo, el %1 % está por debajo de este.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No comparison with a class: to keep results anonymous it needs %1 people, and there are results of %n person(s).</source>
        <extracomment>%1 is a number of people</extracomment>
        <translation>
            <numerusform>Sin comparación con un grupo: para mantener el anonimato hacen falta %1 personas, y aquí están los resultados de %n persona.</numerusform>
            <numerusform>Sin comparación con un grupo: para mantener el anonimato hacen falta %1 personas, y aquí están los resultados de %n personas.</numerusform>
        </translation>
    </message>
    <message>
        <source>other rubric</source>
        <extracomment>Beside an earlier grade that cannot be compared with this one</extracomment>
        <translation>otra rúbrica</translation>
    </message>
    <message>
        <source>No earlier grades.</source>
        <translation>No hay calificaciones anteriores.</translation>
    </message>
    <message>
        <source>Log in and save</source>
        <translation>Iniciar sesión y guardar</translation>
    </message>
    <message>
        <source>No comparison with a class: to keep results anonymous it needs %1 people, and yours is the only result.</source>
        <extracomment>%1 is a number of people</extracomment>
        <translation>Sin comparación con un grupo: para mantener el anonimato hacen falta %1 personas, y el suyo es el único resultado.</translation>
    </message>
    <message>
        <source>You are not logged in, so this grade is not saved.</source>
        <translation>No ha iniciado sesión, así que esta calificación no se guarda.</translation>
    </message>
    <message>
        <source>This grade is saved on this computer. It is sent to the school&apos;s database when the connection is back.</source>
        <translation>Esta calificación está guardada en este ordenador. Se enviará a la base de datos de la escuela cuando vuelva la conexión.</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Intentos</translation>
    </message>
    <message>
        <source>This grade is not saved yet. Cusp tries again every few seconds while it runs. Free some disk space.</source>
        <translation>Esta calificación aún no está guardada. Cusp lo vuelve a intentar cada pocos segundos mientras está abierto. Libere espacio en el disco.</translation>
    </message>
    <message>
        <source>This grade is not saved and will not be here next time.</source>
        <translation>Esta calificación no se guarda y no estará aquí la próxima vez.</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ScorePage</name>
    <message>
        <source>Does not count</source>
        <translation>No cuenta</translation>
    </message>
    <message>
        <source>You expected %1 points, which is exactly right.</source>
        <translation>Esperaba %1 puntos: acertó exactamente.</translation>
    </message>
    <message>
        <source>You expected %1 points. You overestimated by %2 points.</source>
        <translation>Esperaba %1 puntos. Sobrestimó su resultado en %2 puntos.</translation>
    </message>
    <message>
        <source>You expected %1 points. You underestimated by %2 points.</source>
        <translation>Esperaba %1 puntos. Subestimó su resultado en %2 puntos.</translation>
    </message>
    <message>
        <source>Rubric &quot;%1&quot;, version %2, content %3. Undercuts and walls past 90° are not measured, because the model is a height field.</source>
        <extracomment>%1 is the name of a rubric, %2 its version, %3 the beginning of its hash</extracomment>
        <translation>Rúbrica «%1», versión %2, contenido %3. No se miden socavados ni paredes de más de 90°, porque el modelo es un campo de alturas.</translation>
    </message>
    <message>
        <source>Grade</source>
        <translation>Calificar</translation>
    </message>
    <message>
        <source>The tooth is measured again with half and with double the number of grid columns. The result is clear of the pass mark if all scores lie on the same side of it. This says nothing about another attempt.</source>
        <translation>El diente se mide de nuevo con la mitad y con el doble de columnas de la cuadrícula. El resultado es claro si todas las puntuaciones quedan del mismo lado de la nota de aprobado. Esto no dice nada de otro intento.</translation>
    </message>
    <message>
        <source>Lost points</source>
        <translation>Puntos perdidos</translation>
    </message>
    <message>
        <source>Finding the moment of each lost point …</source>
        <translation>Buscando el momento de cada punto perdido …</translation>
    </message>
    <message>
        <source>Finding the moment of each lost point</source>
        <translation>Buscando el momento de cada punto perdido</translation>
    </message>
    <message>
        <source>Grade: %1</source>
        <extracomment>%1 is a lesson, &quot;Tooth 36&quot; or a file name %1 is a person, %2 a lesson</extracomment>
        <translation>Calificación: %1</translation>
    </message>
    <message>
        <source>of 100</source>
        <translation>de 100</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Aprobado</translation>
    </message>
    <message>
        <source>Not passed: critical error</source>
        <translation>No aprobado: error crítico</translation>
    </message>
    <message>
        <source>Not passed yet</source>
        <translation>Aún no aprobado</translation>
    </message>
    <message>
        <source>Score at half the grid: %1, at double the grid: %2.</source>
        <translation>Puntuación con la mitad de la cuadrícula: %1; con el doble: %2.</translation>
    </message>
    <message>
        <source>Score at half the grid: %1.</source>
        <translation>Puntuación con la mitad de la cuadrícula: %1.</translation>
    </message>
    <message>
        <source>Result is close to the pass mark.</source>
        <translation>El resultado está cerca de la nota de aprobado.</translation>
    </message>
    <message>
        <source>Result is clear of the pass mark.</source>
        <translation>El resultado está claramente alejado de la nota de aprobado.</translation>
    </message>
    <message>
        <source>%1: no points lost</source>
        <extracomment>%1 a criterion of a score</extracomment>
        <translation>%1: sin puntos perdidos</translation>
    </message>
    <message>
        <source>No deviation from the ideal</source>
        <translation>Sin desviación del ideal</translation>
    </message>
    <message>
        <source>%1 mm too deep</source>
        <translation>%1 mm demasiado profundo</translation>
    </message>
    <message>
        <source>%1 mm still to cut</source>
        <translation>faltan %1 mm</translation>
    </message>
    <message>
        <source>%1: worst place, %2</source>
        <translation>%1: peor lugar, %2</translation>
    </message>
    <message>
        <source>%1 has no place on the tooth; largest deviation: %2</source>
        <translation>%1 no tiene lugar en el diente; mayor desviación: %2</translation>
    </message>
    <message>
        <source>You lost no points.</source>
        <translation>No perdió ningún punto.</translation>
    </message>
    <message>
        <source>Your biggest loss: %1.</source>
        <translation>Su mayor pérdida de puntos: %1.</translation>
    </message>
    <message>
        <source>You named your biggest loss correctly: %1.</source>
        <translation>Acertó qué le costó más puntos: %1.</translation>
    </message>
    <message>
        <source>You expected &quot;%1&quot; to be your biggest loss; it was &quot;%2&quot;.</source>
        <translation>Creía que su mayor pérdida de puntos era «%1»; fue «%2».</translation>
    </message>
    <message>
        <source>%1: %2, no answer</source>
        <extracomment>%1 is &quot;Left&quot;, &quot;Middle&quot; or &quot;Right&quot;, %2 and %3 are tissues</extracomment>
        <translation>%1: %2, sin respuesta</translation>
    </message>
    <message>
        <source>%1: %2, correct</source>
        <translation>%1: %2, correcto</translation>
    </message>
    <message>
        <source>%1: %2, your answer: %3</source>
        <translation>%1: %2, su respuesta: %3</translation>
    </message>
    <message>
        <source>%1 has no place on the tooth</source>
        <translation>%1 no tiene lugar en el diente</translation>
    </message>
    <message>
        <source>%1: worst place</source>
        <extracomment>%1 a criterion of a score</extracomment>
        <translation>%1: peor lugar</translation>
    </message>
    <message>
        <source>Held for %1 of %2 s, mean deviation %3 N</source>
        <translation>Mantenida %1 de %2 s, con %3 N de desviación media</translation>
    </message>
    <message>
        <source>All points were touched</source>
        <translation>Se tocaron todos los puntos</translation>
    </message>
    <message>
        <source>%1 of %2 points touched; the ring marks a missed point</source>
        <translation>%1 de %2 puntos tocados; el anillo marca uno sin tocar</translation>
    </message>
    <message>
        <source>Drilled with the hardness preset %1.</source>
        <extracomment>%1 is a hardness preset with its version</extracomment>
        <translation>Tallado con el ajuste de dureza %1.</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Replay this attempt</source>
        <translation>Reproducir este intento</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>Save or print the score card</source>
        <translation>Guardar o imprimir la hoja de puntuación</translation>
    </message>
    <message>
        <source>Save as PDF …</source>
        <translation>Guardar como PDF …</translation>
    </message>
    <message>
        <source>Print …</source>
        <translation>Imprimir …</translation>
    </message>
    <message>
        <source>Grade of %1: %2</source>
        <translation>Calificación de %1: %2</translation>
    </message>
    <message>
        <source>The student expected %1 points.</source>
        <translation>El estudiante esperaba %1 puntos.</translation>
    </message>
    <message>
        <source>Passed (teacher&apos;s decision)</source>
        <translation>Aprobado (decisión del docente)</translation>
    </message>
    <message>
        <source>Not passed (teacher&apos;s decision)</source>
        <translation>No aprobado (decisión del docente)</translation>
    </message>
    <message>
        <source>Automatic score: %1</source>
        <extracomment>%1: a sum of points</extracomment>
        <translation>Puntuación automática: %1</translation>
    </message>
    <message>
        <source>This attempt has no readable recording. It cannot be replayed, and the tooth is not shown. The score and the lost points are shown as they were saved.</source>
        <translation>Este intento no tiene una grabación legible. No se puede reproducir y no se muestra el diente. La puntuación y los puntos perdidos se muestran tal como se guardaron.</translation>
    </message>
    <message>
        <source>Next time</source>
        <translation>La próxima vez</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
    <message>
        <source>How the points add up, and by which rules</source>
        <translation>Cómo se suman los puntos y con qué reglas</translation>
    </message>
    <message>
        <source>Show it at %1</source>
        <extracomment>%1: minutes and seconds of the attempt</extracomment>
        <translation>Mostrar en %1</translation>
    </message>
    <message>
        <source>Next lesson</source>
        <translation>Siguiente lección</translation>
    </message>
    <message>
        <source>Show the moment in the replay</source>
        <translation>Mostrar el momento en la repetición</translation>
    </message>
    <message>
        <source>Not passed: limited to %1</source>
        <extracomment>%1: points of a score</extracomment>
        <translation>No aprobado: como máximo %1</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::SweepChart</name>
    <message>
        <source>Scores of past attempts over the tolerance</source>
        <translation>Puntuaciones de intentos anteriores según la tolerancia</translation>
    </message>
    <message>
        <source>At %1 times the tolerance %2 of %3 pass; median %4</source>
        <extracomment>%1: a number, &quot;1.5&quot;; %2 of %3 attempts; %4: points</extracomment>
        <translation>Con %1 veces la tolerancia aprueban %2 de %3; mediana %4</translation>
    </message>
    <message>
        <source>Times the tolerance</source>
        <translation>Múltiplo de la tolerancia</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Each attempt</source>
        <translation>Cada intento</translation>
    </message>
    <message>
        <source>%1: %2 points at %3 times the tolerance</source>
        <extracomment>%1: the name of a file, or which line</extracomment>
        <translation>%1: %2 puntos con %3 veces la tolerancia</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Nota de aprobado</translation>
    </message>
    <message>
        <source>As set</source>
        <translation>Valor actual</translation>
    </message>
    <message>
        <source>Lower quartile</source>
        <translation>Cuartil inferior</translation>
    </message>
    <message>
        <source>Upper quartile</source>
        <translation>Cuartil superior</translation>
    </message>
    <message>
        <source>Attempts that pass, %</source>
        <translation>Intentos aprobados, %</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Grabación</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::SweepPage</name>
    <message>
        <source>Recordings …</source>
        <translation>Grabaciones …</translation>
    </message>
    <message>
        <source>Choose the folder with recordings of attempts</source>
        <translation>Elegir la carpeta con grabaciones de intentos</translation>
    </message>
    <message>
        <source>Choose the folder with recordings</source>
        <translation>Elegir la carpeta con grabaciones</translation>
    </message>
    <message>
        <source>Whose tolerance is changed</source>
        <translation>Qué tolerancia se cambia</translation>
    </message>
    <message>
        <source>Recordings that are replayed</source>
        <translation>Grabaciones que se reproducen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Stop replaying</source>
        <translation>Detener la reproducción</translation>
    </message>
    <message>
        <source>Go on with those that are done</source>
        <translation>Seguir con las que están listas</translation>
    </message>
    <message>
        <source>Choose a folder with recordings of this tooth: each is replayed once, and its score is drawn for tolerances from 0 to 3 times those at the left.</source>
        <translation>Elija una carpeta con grabaciones de este diente: cada una se reproduce una vez, y su puntuación se dibuja para tolerancias de 0 a 3 veces las de la izquierda.</translation>
    </message>
    <message>
        <source>All tolerances</source>
        <translation>Todas las tolerancias</translation>
    </message>
    <message>
        <source>No attempt in this folder was made at this tooth.</source>
        <translation>Ningún intento de esta carpeta se hizo en este diente.</translation>
    </message>
    <message>
        <source>The attempts of the history were made for another ideal than this draft&apos;s. Choose a folder with recordings.</source>
        <translation>Los intentos del historial se hicieron para otro ideal que el de este borrador. Elija una carpeta con grabaciones.</translation>
    </message>
    <message numerus="yes">
        <source>%n of them from the history.</source>
        <translation>
            <numerusform>%n de ellos, del historial.</numerusform>
            <numerusform>%n de ellos, del historial.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) at other teeth are left out.</source>
        <translation>
            <numerusform>Se omite %n intento en otro diente.</numerusform>
            <numerusform>Se omiten %n intentos en otros dientes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) could not be read.</source>
        <translation>
            <numerusform>%n grabación no se pudo leer.</numerusform>
            <numerusform>%n grabaciones no se pudieron leer.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) of the history without measured values are left out.</source>
        <translation>
            <numerusform>Se omite %n intento del historial sin valores medidos.</numerusform>
            <numerusform>Se omiten %n intentos del historial sin valores medidos.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::ToleranceView</name>
    <message>
        <source>The tolerances on the tooth</source>
        <translation>Las tolerancias en el diente</translation>
    </message>
    <message>
        <source>Drag the line of the section; arrow keys move it, Shift with them turns it, as a double click does</source>
        <translation>Arrastre la línea del corte; las flechas la mueven, con Mayúsculas la giran, y también un doble clic</translation>
    </message>
    <message>
        <source>Nothing to show yet: what is wrong is said at the left.</source>
        <translation>Aún no hay nada que mostrar: lo que está mal se dice a la izquierda.</translation>
    </message>
    <message>
        <source>The ideal is being made …</source>
        <translation>Se está creando el ideal …</translation>
    </message>
</context>
<context>
    <name>ui::kit::FormInputs</name>
    <message>
        <source>%1 stays.</source>
        <translation>Se queda %1.</translation>
    </message>
    <message>
        <source>Only whole numbers from %1 to %2 can be entered here.</source>
        <extracomment>%1 and %2: the least and the greatest number, %2 with a unit</extracomment>
        <translation>Aquí solo se admiten números enteros de %1 a %2.</translation>
    </message>
    <message>
        <source>Only %1 to %2 can be entered here.</source>
        <translation>Aquí solo se admite de %1 a %2.</translation>
    </message>
</context>
<context>
    <name>ui::scoring::WorstSection</name>
    <message>
        <source>Section through the worst place</source>
        <translation>Corte por el peor lugar</translation>
    </message>
</context>
<context>
    <name>ui::tooth::SceneWidget</name>
    <message>
        <source>No picture</source>
        <extracomment>Heading where a picture would be; a sentence below says why</extracomment>
        <translation>Sin imagen</translation>
    </message>
</context>
<context>
    <name>ui::tooth::ToothView</name>
    <message>
        <source>Tooth</source>
        <translation>Diente</translation>
    </message>
    <message>
        <source>Arrow keys move the bur, page down pushes, page up lifts.</source>
        <translation>Las flechas mueven la fresa, Av Pág presiona, Re Pág levanta.</translation>
    </message>
    <message>
        <source>%1 N</source>
        <extracomment>A force in newtons, beside the bur</extracomment>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>This computer offers no OpenGL 3.3, so the tooth cannot be shown. Install or update the graphics driver (on Debian: libgl1-mesa-dri), then start Cusp again.</source>
        <translation>Este ordenador no ofrece OpenGL 3.3, así que no se puede mostrar el diente. Instale o actualice el controlador gráfico (en Debian: libgl1-mesa-dri) y vuelva a abrir Cusp.</translation>
    </message>
    <message>
        <source>%1 / %2 mm</source>
        <translation>%1 / %2 mm</translation>
    </message>
    <message>
        <source>Stop %1 mm</source>
        <extracomment>The depth at which the bur will stop</extracomment>
        <translation>Tope %1 mm</translation>
    </message>
</context>
<context>
    <name>app::PedalController</name>
    <message>
        <source>The pedal was unplugged, and the bur was stopped. Plug it in again, or switch the drill on to work without it.</source>
        <translation>Se desconectó el pedal y se detuvo la fresa. Vuelva a conectarlo, o encienda el torno para trabajar sin él.</translation>
    </message>
    <message>
        <source>Show the device</source>
        <translation>Mostrar el dispositivo</translation>
    </message>
    <message>
        <source>The pedal is plugged in again.</source>
        <translation>El pedal está conectado de nuevo.</translation>
    </message>
</context>
<context>
    <name>ui::devices::AxisBars</name>
    <message>
        <source>Axes and buttons. No button is pressed.</source>
        <translation>Ejes y botones. No hay ningún botón pulsado.</translation>
    </message>
    <message>
        <source>Axes and buttons. Pressed: %1</source>
        <extracomment>%1: names of buttons</extracomment>
        <translation>Ejes y botones. Pulsados: %1</translation>
    </message>
</context>
<context>
    <name>ui::devices::ControllerButtonsCard</name>
    <message>
        <source>Sticks, triggers and arrows</source>
        <extracomment>What sticks, triggers and arrows of a gamepad do</extracomment>
        <translation>Palancas, gatillos y flechas</translation>
    </message>
    <message>
        <source>Press the button for: %1. Click again for none.</source>
        <extracomment>%1: &quot;Undo&quot;, or another action</extracomment>
        <translation>Pulse el botón para: %1. Otro clic: ninguno.</translation>
    </message>
    <message>
        <source>Buttons. Click one here, then press it on the pedal or gamepad.</source>
        <translation>Botones. Haga clic en uno aquí y púlselo después en el pedal o el mando.</translation>
    </message>
    <message>
        <source>Press it …</source>
        <translation>Púlselo…</translation>
    </message>
    <message>
        <source>None</source>
        <extracomment>No button</extracomment>
        <translation>Ninguno</translation>
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
        <translation>No forma parte de este programa.</translation>
    </message>
    <message>
        <source>Pedals and gamepads cannot be read.</source>
        <translation>No se pueden leer pedales ni mandos.</translation>
    </message>
    <message>
        <source>The pedal is ready.</source>
        <translation>El pedal está listo.</translation>
    </message>
    <message>
        <source>The chosen pedal is not plugged in.</source>
        <translation>El pedal elegido no está conectado.</translation>
    </message>
    <message>
        <source>The pedal is pressed, or it sticks. Release it.</source>
        <translation>El pedal está pisado o atascado. Suéltelo.</translation>
    </message>
    <message>
        <source>Nothing is plugged in.</source>
        <translation>No hay nada conectado.</translation>
    </message>
    <message>
        <source>This program was built without SDL 2. The mouse and the keyboard work without it.</source>
        <translation>Este programa se compiló sin SDL 2. El ratón y el teclado funcionan sin él.</translation>
    </message>
    <message>
        <source>The bur turns while the pedal is pressed, and faster the farther it is pressed.</source>
        <translation>La fresa gira mientras se pisa el pedal, y más deprisa cuanto más se pisa.</translation>
    </message>
    <message>
        <source>Plug in &quot;%1&quot;. Until then, the bur runs without a pedal.</source>
        <extracomment>%1: name of a pedal</extracomment>
        <translation>Conecte «%1». Hasta entonces, la fresa funciona sin pedal.</translation>
    </message>
    <message>
        <source>The bur does not start before the pedal has been seen released. If it is released now, teach it again.</source>
        <translation>La fresa no arranca hasta que el pedal se haya soltado una vez. Si ahora está suelto, enséñelo de nuevo.</translation>
    </message>
    <message>
        <source>Plug in a foot pedal or a gamepad. A pedal that acts as a keyboard needs nothing here: let it send Page Down.</source>
        <translation>Conecte un pedal o un mando. Un pedal que actúa como teclado no necesita nada aquí: haga que envíe Av Pág.</translation>
    </message>
    <message>
        <source>Run the bur</source>
        <extracomment>What a button does: the bur turns at full speed while it is pressed</extracomment>
        <translation>Hacer girar la fresa</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Espejo</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centro</translation>
    </message>
    <message>
        <source>Next view</source>
        <extracomment>What a button does: looks at the tooth from another side</extracomment>
        <translation>Vista siguiente</translation>
    </message>
    <message>
        <source>Next bur</source>
        <translation>Fresa siguiente</translation>
    </message>
    <message>
        <source>Finish and grade</source>
        <translation>Terminar y calificar</translation>
    </message>
    <message>
        <source>Left stick, sideways</source>
        <translation>Palanca izquierda, lateral</translation>
    </message>
    <message>
        <source>Left stick, up and down</source>
        <translation>Palanca izquierda, vertical</translation>
    </message>
    <message>
        <source>Right stick, sideways</source>
        <translation>Palanca derecha, lateral</translation>
    </message>
    <message>
        <source>Right stick, up and down</source>
        <translation>Palanca derecha, vertical</translation>
    </message>
    <message>
        <source>Left trigger</source>
        <translation>Gatillo izquierdo</translation>
    </message>
    <message>
        <source>Right trigger</source>
        <translation>Gatillo derecho</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <extracomment>Of a pedal; %1: a number</extracomment>
        <translation>Eje %1</translation>
    </message>
    <message>
        <source>View</source>
        <extracomment>A button of a gamepad</extracomment>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Guide</source>
        <extracomment>A button of a gamepad</extracomment>
        <translation>Guía</translation>
    </message>
    <message>
        <source>Menu</source>
        <extracomment>A button of a gamepad</extracomment>
        <translation>Menú</translation>
    </message>
    <message>
        <source>Left stick</source>
        <extracomment>The button in a stick of a gamepad</extracomment>
        <translation>Palanca izquierda</translation>
    </message>
    <message>
        <source>Right stick</source>
        <extracomment>The button in a stick of a gamepad</extracomment>
        <translation>Palanca derecha</translation>
    </message>
    <message>
        <source>Moves the bur over the tooth</source>
        <translation>Mueve la fresa sobre el diente</translation>
    </message>
    <message>
        <source>Turns the view</source>
        <translation>Gira la vista</translation>
    </message>
    <message>
        <source>Presses the bur down: the farther, the harder</source>
        <translation>Aprieta la fresa: cuanto más, más fuerte</translation>
    </message>
    <message>
        <source>Sets the speed of the bur, if it is the pedal</source>
        <translation>Fija la velocidad de la fresa, si hace de pedal</translation>
    </message>
    <message>
        <source>Arrows</source>
        <extracomment>The cross of four arrows on a gamepad</extracomment>
        <translation>Flechas</translation>
    </message>
    <message>
        <source>Go through the buttons of the panel, or of the page</source>
        <translation>Recorren los botones del panel o de la página</translation>
    </message>
    <message>
        <source>Presses the button that the arrows have gone to</source>
        <translation>Acciona el botón al que han llegado las flechas</translation>
    </message>
    <message>
        <source>Leads back to the tooth</source>
        <translation>Lleva de vuelta al diente</translation>
    </message>
    <message>
        <source>Plugged in: %1</source>
        <extracomment>%1: names of pedals and gamepads</extracomment>
        <translation>Conectado: %1</translation>
    </message>
    <message>
        <source>Teach a pedal by one press: its travel then sets the speed of the bur. A gamepad works as it comes.</source>
        <translation>Enseñe un pedal pisándolo una vez: su recorrido fija entonces la velocidad de la fresa. Un mando funciona tal cual.</translation>
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
        <translation>Pedal o mando</translation>
    </message>
    <message>
        <source>The bur turns only while this pedal is pressed</source>
        <translation>La fresa gira solo mientras se pisa este pedal</translation>
    </message>
    <message>
        <source>Another one of the same kind is plugged in too. The one that was plugged in first counts.</source>
        <translation>Hay otro del mismo tipo conectado. Cuenta el que se conectó primero.</translation>
    </message>
    <message>
        <source>Work without this pedal</source>
        <translation>Trabajar sin este pedal</translation>
    </message>
</context>
<context>
    <name>ui::devices::PedalSetupCard</name>
    <message>
        <source>Inverted</source>
        <extracomment>Of a pedal: the bur runs while it is released</extracomment>
        <translation>Invertido</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <extracomment>Of a pedal: the part of its travel in which the bur stands</extracomment>
        <translation>Zona muerta</translation>
    </message>
    <message>
        <source>Curve</source>
        <extracomment>Of a pedal: 1 is a straight line</extracomment>
        <translation>Curva</translation>
    </message>
    <message>
        <source>1 is a straight line. With more, slow speeds have more of the travel.</source>
        <translation>1 es una recta. Con más, las velocidades lentas ocupan más recorrido.</translation>
    </message>
    <message>
        <source>Press the pedal fully and release it.</source>
        <translation>Pise el pedal a fondo y suéltelo.</translation>
    </message>
    <message>
        <source>No pedal has been taught. The speed of the bur follows its travel once it has.</source>
        <translation>No se ha enseñado ningún pedal. Después, la velocidad de la fresa seguirá su recorrido.</translation>
    </message>
    <message>
        <source>The speed of the bur follows: %1.</source>
        <extracomment>%1: &quot;Left trigger&quot; or &quot;Axis 1&quot;</extracomment>
        <translation>La velocidad de la fresa sigue a: %1.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Teach the pedal</source>
        <translation>Enseñar el pedal</translation>
    </message>
    <message>
        <source>Speed of the bur over the travel of the pedal</source>
        <translation>Velocidad de la fresa según el recorrido del pedal</translation>
    </message>
</context>
<context>
    <name>ui::devices::SoundCard</name>
    <message>
        <source>Play sound</source>
        <translation>Reproducir sonido</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <extracomment>Volume of a part of the sound</extracomment>
        <translation>Pieza de mano</translation>
    </message>
    <message>
        <source>Cutting</source>
        <extracomment>Volume of a part of the sound</extracomment>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Contact</source>
        <extracomment>Volume of a part of the sound: the bur meets the tooth</extracomment>
        <translation>Contacto</translation>
    </message>
    <message>
        <source>Spray</source>
        <extracomment>Volume of a part of the sound: water that cools the bur</extracomment>
        <translation>Espray</translation>
    </message>
    <message>
        <source>Suction</source>
        <extracomment>Volume of a part of the sound</extracomment>
        <translation>Aspiración</translation>
    </message>
    <message>
        <source>Volume: %1</source>
        <extracomment>Name of a slider; %1: &quot;Handpiece&quot;, &quot;Cutting&quot;</extracomment>
        <translation>Volumen: %1</translation>
    </message>
    <message>
        <source>Output</source>
        <extracomment>Of sound: loudspeakers or headphones</extracomment>
        <translation>Salida</translation>
    </message>
    <message>
        <source>Play a sample</source>
        <translation>Reproducir una muestra</translation>
    </message>
    <message>
        <source>The turbine runs free, cuts enamel, then dentin</source>
        <translation>La turbina gira libre, corta esmalte y luego dentina</translation>
    </message>
    <message>
        <source>As the system is set</source>
        <extracomment>Audio output</extracomment>
        <translation>La del sistema</translation>
    </message>
    <message>
        <source>The chosen output (missing)</source>
        <extracomment>Audio output that was chosen before and is not plugged in</extracomment>
        <translation>La salida elegida (falta)</translation>
    </message>
</context>
<context>
    <name>ui::devices::SoundText</name>
    <message>
        <source>Off.</source>
        <extracomment>Of sound</extracomment>
        <translation>Apagado.</translation>
    </message>
    <message>
        <source>Silent: this computer has no audio output.</source>
        <translation>En silencio: este ordenador no tiene salida de audio.</translation>
    </message>
    <message>
        <source>Silent: %1 does not play.</source>
        <extracomment>%1: an audio output, as the system calls it</extracomment>
        <translation>En silencio: %1 no reproduce.</translation>
    </message>
    <message>
        <source>The chosen output is missing; %1 plays instead.</source>
        <extracomment>%1: an audio output, as the system calls it</extracomment>
        <translation>Falta la salida elegida; en su lugar suena %1.</translation>
    </message>
    <message>
        <source>Plays on %1.</source>
        <extracomment>%1: an audio output, as the system calls it</extracomment>
        <translation>Suena en %1.</translation>
    </message>
    <message>
        <source>Plug in headphones or loudspeakers: the sound then starts without a restart. Everything else works without sound.</source>
        <translation>Conecte unos auriculares o altavoces: el sonido empieza sin reiniciar. Todo lo demás funciona sin sonido.</translation>
    </message>
    <message>
        <source>Choose another output, or close the program that uses this one. Cusp tries again every second.</source>
        <translation>Elija otra salida o cierre el programa que usa esta. Cusp lo intenta de nuevo cada segundo.</translation>
    </message>
    <message>
        <source>Plug the output in again: the sound then returns to it.</source>
        <translation>Vuelva a conectar la salida: el sonido regresa a ella.</translation>
    </message>
    <message>
        <source>The handpiece drops in pitch under load. Enamel sounds bright, dentin dull. The sound plays while you see the tooth.</source>
        <translation>La pieza de mano baja de tono con la carga. El esmalte suena brillante; la dentina, apagada. El sonido se oye mientras ve el diente.</translation>
    </message>
</context>
<context>
    <name>ui::practice::BurPicker</name>
    <message>
        <source>Round</source>
        <translation>Redonda</translation>
    </message>
    <message>
        <source>Inverted cone</source>
        <translation>Cono invertido</translation>
    </message>
    <message>
        <source>Straight fissure</source>
        <translation>Fisura recta</translation>
    </message>
    <message>
        <source>Tapered fissure</source>
        <translation>Fisura cónica</translation>
    </message>
    <message>
        <source>Pear, egg and flame</source>
        <translation>Pera, huevo y llama</translation>
    </message>
    <message>
        <source>Diamonds</source>
        <translation>Diamantes</translation>
    </message>
    <message>
        <source>All burs</source>
        <translation>Todas las fresas</translation>
    </message>
    <message>
        <source>Search by number, ISO size or shape</source>
        <translation>Buscar por número, tamaño ISO o forma</translation>
    </message>
    <message>
        <source>There is no such bur.</source>
        <translation>No existe tal fresa.</translation>
    </message>
    <message>
        <source>Take it out of the panel</source>
        <translation>Quitar del panel</translation>
    </message>
    <message>
        <source>The panel holds four burs: take one out first.</source>
        <translation>El panel admite cuatro fresas: quite una antes.</translation>
    </message>
    <message>
        <source>Keep it at hand in the panel</source>
        <translation>Tener a mano en el panel</translation>
    </message>
    <message>
        <source>Keep at hand: %1</source>
        <extracomment>%1: a bur such as &quot;Pear, No. 330&quot;</extracomment>
        <translation>Tener a mano: %1</translation>
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
        <translation>Grano %1</translation>
    </message>
    <message>
        <source>This lesson does not allow it.</source>
        <translation>Esta lección no lo permite.</translation>
    </message>
</context>
<context>
    <name>ui::devices::PenField</name>
    <message>
        <source>Press the pen here</source>
        <extracomment>In a field in which the user tries the pen of a graphics tablet</extracomment>
        <translation>Presione aquí con el lápiz</translation>
    </message>
</context>
<context>
    <name>ui::devices::PenCard</name>
    <message>
        <source>Pen</source>
        <translation>Lápiz</translation>
    </message>
    <message>
        <source>The tilt of the pen is ignored: the bur stays upright.</source>
        <translation>La inclinación del lápiz no se tiene en cuenta: la fresa se mantiene vertical.</translation>
    </message>
    <message>
        <source>Curve</source>
        <extracomment>Of a pen: 1 is a straight line</extracomment>
        <translation>Curva</translation>
    </message>
    <message>
        <source>1 is a straight line. With more, a light touch presses more weakly.</source>
        <translation>1 es una línea recta. Con más, un toque ligero presiona con menos fuerza.</translation>
    </message>
    <message>
        <source>Force over the pressure of the pen</source>
        <translation>Fuerza según la presión del lápiz</translation>
    </message>
    <message>
        <source>No pen has been seen yet. Press it in the field, or move it over the field.</source>
        <translation>Todavía no se ha detectado ningún lápiz. Presiónelo en el campo o muévalo por encima.</translation>
    </message>
    <message>
        <source>That was a mouse, or a pen whose driver reports no pressure. The bur presses with %1 N.</source>
        <extracomment>%1: newtons</extracomment>
        <translation>Eso fue un ratón o un lápiz cuyo controlador no informa de la presión. La fresa presiona con %1 N.</translation>
    </message>
    <message>
        <source>The pen hovers: the bur follows it and does not press.</source>
        <translation>El lápiz está en el aire: la fresa lo sigue y no presiona.</translation>
    </message>
    <message>
        <source>Pressure %1 %: the bur presses with %2 N of %3 N.</source>
        <extracomment>%1: per cent; %2 and %3: newtons</extracomment>
        <translation>Presión %1 %: la fresa presiona con %2 N de %3 N.</translation>
    </message>
</context>
<context>
    <name>ui::devices::HandGuidePicture</name>
    <message>
        <source>50 to 70 cm</source>
        <extracomment>Between the eyes and the screen</extracomment>
        <translation>50 a 70 cm</translation>
    </message>
</context>
<context>
    <name>ui::devices::StillnessTest</name>
    <message>
        <source>Time that is over</source>
        <translation>Tiempo transcurrido</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Once more</source>
        <translation>Otra vez</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Get ready.</source>
        <translation>Prepárese.</translation>
    </message>
    <message>
        <source>Hold still.</source>
        <translation>No se mueva.</translation>
    </message>
    <message>
        <source>This can be tried when the device is ready.</source>
        <translation>Esto se puede probar cuando el dispositivo esté listo.</translation>
    </message>
    <message>
        <source>The device stopped responding. Start again when it is ready.</source>
        <translation>El dispositivo ha dejado de responder. Empiece de nuevo cuando esté listo.</translation>
    </message>
    <message>
        <source>Too few positions were measured. Close other programs and start again.</source>
        <translation>Se han medido muy pocas posiciones. Cierre otros programas y empiece de nuevo.</translation>
    </message>
    <message>
        <source>On the tooth, the bur drifted by %1 mm and trembled by %2 mm.</source>
        <extracomment>%1 and %2: millimetres</extracomment>
        <translation>En el diente, la fresa se desvió %1 mm y tembló %2 mm.</translation>
    </message>
    <message>
        <source>On the screen, the pointer drifted by %1 mm and trembled by %2 mm.</source>
        <translation>En la pantalla, el puntero se desvió %1 mm y tembló %2 mm.</translation>
    </message>
    <message>
        <source>The hand drifts: support the forearm, and try another height of the rest.</source>
        <translation>La mano se desvía: apoye el antebrazo y pruebe otra altura del apoyo.</translation>
    </message>
    <message>
        <source>The hand trembles: hold the grip loosely, put a finger on the rest, or choose a larger scale on the next step.</source>
        <translation>La mano tiembla: sujete la empuñadura sin apretar, ponga un dedo en el apoyo o elija una escala mayor en el paso siguiente.</translation>
    </message>
    <message>
        <source>The hand trembles: put the wrist on the table, or zoom in at the tooth.</source>
        <translation>La mano tiembla: apoye la muñeca en la mesa o amplíe la vista del diente.</translation>
    </message>
    <message>
        <source>That is steady.</source>
        <translation>Eso es estable.</translation>
    </message>
</context>
<context>
    <name>ui::devices::HandGuide</name>
    <message>
        <source>Scale</source>
        <extracomment>How far the hand moves for one millimetre of the bur</extracomment>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Movement of the hand for 1 mm of the bur, in millimetres. With more, drift and tremor of the hand move the bur less.</source>
        <translation>Movimiento de la mano por 1 mm de la fresa, en milímetros. Con más, la desviación y el temblor de la mano mueven menos la fresa.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <extracomment>%1 and %2: numbers</extracomment>
        <translation>Paso %1 de %2</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Mano derecha</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Mano izquierda</translation>
    </message>
    <message>
        <source>Use this height</source>
        <extracomment>The height at which the hand is now</extracomment>
        <translation>Usar esta altura</translation>
    </message>
    <message>
        <source>Use the middle</source>
        <translation>Usar el centro</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Which hand do you work with?</source>
        <translation>¿Con qué mano trabaja?</translation>
    </message>
    <message>
        <source>Place the screen</source>
        <translation>Colocar la pantalla</translation>
    </message>
    <message>
        <source>Rest the hand</source>
        <translation>Apoyar la mano</translation>
    </message>
    <message>
        <source>Hold still</source>
        <translation>No moverse</translation>
    </message>
    <message>
        <source>Your place</source>
        <translation>Su puesto</translation>
    </message>
    <message>
        <source>The handpiece comes from the side of this hand, and the light from the other one. Place the mouse, the tablet or the device on this side.</source>
        <translation>La pieza de mano viene del lado de esta mano y la luz del otro. Coloque el ratón, la tableta o el dispositivo en este lado.</translation>
    </message>
    <message>
        <source>Place it straight in front of you, 50 to 70 cm from your eyes. Its upper edge is at the height of your eyes or a little below. Sit upright and let the shoulders hang.</source>
        <translation>Colóquela justo delante de usted, a 50 a 70 cm de los ojos. Su borde superior queda a la altura de los ojos o un poco por debajo. Siéntese erguido y relaje los hombros.</translation>
    </message>
    <message>
        <source>Put a box or a firm cushion in front of the device, so that the ring finger rests while you hold the grip, as it does on a tooth. Hold the grip as if at the tooth. The top of the tooth comes to the height that you store.</source>
        <translation>Ponga una caja o un cojín firme delante del dispositivo, para que el dedo anular se apoye mientras sujeta la empuñadura, como sobre un diente. Sujete la empuñadura como si estuviera en el diente. La parte superior del diente queda a la altura que guarde.</translation>
    </message>
    <message>
        <source>Lay the forearm on the table, with the wrist straight. Hold a pen near its tip, and rest the little finger beside it. Move a mouse with the fingers.</source>
        <translation>Apoye el antebrazo en la mesa, con la muñeca recta. Sujete un lápiz cerca de la punta y apoye el meñique al lado. Mueva un ratón con los dedos.</translation>
    </message>
    <message>
        <source>Hold the grip as if at the tooth, with a finger on the rest. Press Start with the other hand and hold still for 8 seconds.</source>
        <translation>Sujete la empuñadura como si estuviera en el diente, con un dedo en el apoyo. Pulse «Iniciar» con la otra mano y no se mueva durante 8 segundos.</translation>
    </message>
    <message>
        <source>Press Start with the space bar, or click it and leave the pointer there. Hold still for 8 seconds. A pen hovers meanwhile.</source>
        <translation>Pulse «Iniciar» con la barra espaciadora, o haga clic y deje ahí el puntero. No se mueva durante 8 segundos. Un lápiz se mantiene en el aire.</translation>
    </message>
    <message>
        <source>Not all of the tooth could be reached from %1 mm, so %2 mm is stored. Move the rest or the device instead.</source>
        <extracomment>%1 and %2: millimetres</extracomment>
        <translation>Desde %1 mm no se alcanzaría todo el diente, por eso se ha guardado %2 mm. Mueva en su lugar el apoyo o el dispositivo.</translation>
    </message>
    <message>
        <source>The top of the tooth is at the middle of the work area.</source>
        <translation>La parte superior del diente está en el centro del área de trabajo.</translation>
    </message>
    <message>
        <source>The top of the tooth is %1 mm above the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>La parte superior del diente está %1 mm por encima del centro del área de trabajo.</translation>
    </message>
    <message>
        <source>The top of the tooth is %1 mm below the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>La parte superior del diente está %1 mm por debajo del centro del área de trabajo.</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <extracomment>%1: &quot;Right hand&quot;; %2: &quot;Novint Falcon&quot;</extracomment>
        <translation>%1, %2.</translation>
    </message>
    <message>
        <source>How still the hand is held was not measured.</source>
        <translation>No se ha medido lo quieta que se mantiene la mano.</translation>
    </message>
    <message>
        <source>The device is not ready. Its entry on the page of devices says what to do.</source>
        <translation>El dispositivo no está listo. Su entrada en la página de dispositivos dice qué hacer.</translation>
    </message>
    <message>
        <source>The grip is %1 mm above the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>La empuñadura está %1 mm por encima del centro del área de trabajo.</translation>
    </message>
    <message>
        <source>The grip is %1 mm below the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>La empuñadura está %1 mm por debajo del centro del área de trabajo.</translation>
    </message>
    <message>
        <source>Mouse or pen</source>
        <translation>Ratón o lápiz</translation>
    </message>
</context>
<context>
    <name>app::SoundController</name>
    <message>
        <source>Show the device</source>
        <translation>Mostrar el dispositivo</translation>
    </message>
    <message>
        <source>The sound is on.</source>
        <translation>El sonido está activado.</translation>
    </message>
    <message>
        <source>The sound is off. %1 turns it on again.</source>
        <extracomment>%1: a key</extracomment>
        <translation>El sonido está desactivado. %1 lo activa de nuevo.</translation>
    </message>
</context>
</TS>
