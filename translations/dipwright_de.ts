<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Archive</name>
    <message>
        <source>The file is empty</source>
        <translation>Die Datei ist leer</translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>Die Datei kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>The file cannot be packed</source>
        <translation>Die Datei lässt sich nicht packen</translation>
    </message>
    <message>
        <source>The file does not exist</source>
        <translation>Die Datei gibt es nicht</translation>
    </message>
    <message>
        <source>This is not a Dipwright project, or the file is truncated or damaged</source>
        <translation>Das ist kein Dipwright-Projekt, oder die Datei ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>The file is truncated or damaged</source>
        <translation>Die Datei ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>The file contains an entry with an unsafe path and is not opened</source>
        <translation>Die Datei enthält einen Eintrag mit unsicherem Pfad und wird nicht geöffnet</translation>
    </message>
    <message>
        <source>The file contains the entry %1 twice</source>
        <translation>Die Datei enthält den Eintrag %1 doppelt</translation>
    </message>
    <message>
        <source>The file is encrypted; save it without a password</source>
        <translation>Die Datei ist verschlüsselt; speichern Sie sie ohne Kennwort</translation>
    </message>
    <message>
        <source>The project does not contain %1</source>
        <translation>Das Projekt enthält %1 nicht</translation>
    </message>
    <message>
        <source>%1 in the project is truncated or damaged</source>
        <translation>%1 im Projekt ist abgeschnitten oder beschädigt</translation>
    </message>
</context>
<context>
    <name>AtomicFile</name>
    <message>
        <source>it is a folder</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>The file cannot be written: %1</source>
        <translation>Die Datei kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>it is write-protected</source>
        <translation>sie ist schreibgeschützt</translation>
    </message>
    <message>
        <source>another program is writing it now; try again</source>
        <translation>ein anderes Programm schreibt sie gerade; versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>its symbolic links form a loop</source>
        <translation>ihre symbolischen Verknüpfungen bilden einen Kreis</translation>
    </message>
    <message>
        <source>the disk did not accept its data: %1</source>
        <translation>der Datenträger hat die Daten nicht angenommen: %1</translation>
    </message>
</context>
<context>
    <name>BodyAppearance</name>
    <message>
        <source>Painted</source>
        <translation>Bemalt</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Nicht bemalt</translation>
    </message>
    <message>
        <source>Painted (estimated from the shape)</source>
        <translation>Bemalt (aus der Form geschätzt)</translation>
    </message>
</context>
<context>
    <name>BodyPath</name>
    <message>
        <source>A slanted dip needs an angle to the water between %1° and %2°</source>
        <translation>Ein schräger Tauchvorgang braucht einen Winkel zum Wasser zwischen %1° und %2°</translation>
    </message>
    <message>
        <source>The part can enter tilted by at most 85°</source>
        <translation>Das Teil kann höchstens um 85° gekippt eintauchen</translation>
    </message>
    <message>
        <source>slow at the beginning and the end</source>
        <translation>am Anfang und am Ende langsam</translation>
    </message>
    <message>
        <source>On its path the part travels more than %1 m; choose a smaller angle or water speed, or a faster dip</source>
        <translation>Auf seinem Weg fährt das Teil mehr als %1 m; wählen Sie einen kleineren Winkel, eine kleinere Fließgeschwindigkeit oder einen schnelleren Tauchvorgang</translation>
    </message>
    <message>
        <source>slanted by %1°, heading %2°</source>
        <translation>schräg mit %1°, Richtung %2°</translation>
    </message>
    <message>
        <source>tilted by %1°, heading %2°</source>
        <translation>um %1° gekippt, Richtung %2°</translation>
    </message>
    <message>
        <source>rolled by %1°, heading %2°</source>
        <translation>um %1° gerollt, Richtung %2°</translation>
    </message>
    <message>
        <source>turned by %1° on the way down</source>
        <translation>beim Absenken um %1° gedreht</translation>
    </message>
    <message>
        <source>water at %1 mm/s, heading %2°</source>
        <translation>Wasser mit %1 mm/s, Richtung %2°</translation>
    </message>
    <message>
        <source>A path by poses needs at least two poses</source>
        <translation>Ein Weg durch Lagen braucht mindestens zwei Lagen</translation>
    </message>
    <message>
        <source>The first pose of a path must have the time 0 s and the depth 0 mm, at which the part touches the water</source>
        <translation>Die erste Lage eines Wegs muss die Zeit 0 s und die Tiefe 0 mm haben, in der das Teil das Wasser berührt</translation>
    </message>
    <message>
        <source>The last pose of a path must have the depth of the dip and no turn; to turn the part at the end of the dip, change its rotation</source>
        <translation>Die letzte Lage eines Wegs muss die Tiefe des Tauchvorgangs und keine Drehung haben; um das Teil am Ende des Tauchvorgangs zu drehen, ändern Sie seine Drehung</translation>
    </message>
    <message>
        <source>through %1 poses</source>
        <translation>durch %1 Lagen</translation>
    </message>
    <message>
        <source>On its path the part travels and turns more than %1 m in all; use fewer poses or smaller turns</source>
        <translation>Auf seinem Weg bewegt und dreht sich das Teil insgesamt um mehr als %1 m; nehmen Sie weniger Lagen oder kleinere Drehungen</translation>
    </message>
    <message>
        <source>acceleration at most %1 mm/s²</source>
        <translation>Beschleunigung höchstens %1 mm/s²</translation>
    </message>
    <message>
        <source>Pose %1 of the path must be at least %2 s later than the pose before it</source>
        <translation>Lage %1 des Wegs muss mindestens %2 s später sein als die Lage davor</translation>
    </message>
    <message>
        <source>The poses of the path turn the part too far in all; use fewer poses or smaller turns</source>
        <translation>Die Lagen des Wegs drehen das Teil insgesamt zu weit; nehmen Sie weniger Lagen oder kleinere Drehungen</translation>
    </message>
    <message>
        <source>A part that rolls by more than 360° lays film on its own film; choose an angle of at most 360°</source>
        <translation>Ein Teil, das um mehr als 360° rollt, legt Film auf seinen eigenen Film; wählen Sie einen Winkel von höchstens 360°</translation>
    </message>
</context>
<context>
    <name>Certainty</name>
    <message>
        <source>Overhang (°)</source>
        <translation>Überhang (°)</translation>
    </message>
    <message>
        <source>Grip fade range (°)</source>
        <translation>Bereich des Haltverlusts (°)</translation>
    </message>
    <message>
        <source>Gathering (mean stretch)</source>
        <translation>Raffen (mittlere Dehnung)</translation>
    </message>
    <message>
        <source>Tearing (stretch in length or area)</source>
        <translation>Reißen (Dehnung von Länge oder Fläche)</translation>
    </message>
    <message>
        <source>%1 varied from %2 to %3 (in the project: %4): 95 % of the painted area moves by at most %5. %6 % of it moves by more than %7, and %8 % is no longer painted.</source>
        <translation>%1 von %2 bis %3 verändert (im Projekt: %4): 95 % der bemalten Fläche verschieben sich um höchstens %5. %6 % von ihr verschieben sich um mehr als %7, und %8 % werden nicht mehr bemalt.</translation>
    </message>
    <message>
        <source>the film has too few points to be compared with a film of half as many</source>
        <translation>der Film hat zu wenige Punkte für den Vergleich mit einem Film, der halb so viele Punkte hat</translation>
    </message>
</context>
<context>
    <name>CheckedSolver</name>
    <message>
        <source>it threw an unknown exception</source>
        <translation>er hat eine unbekannte Ausnahme geworfen</translation>
    </message>
    <message>
        <source>it reported impossible convergence values</source>
        <translation>er hat unmögliche Konvergenzwerte gemeldet</translation>
    </message>
    <message>
        <source>it makes no progress</source>
        <translation>er kommt nicht voran</translation>
    </message>
    <message>
        <source>it stopped without being cancelled</source>
        <translation>er hat aufgehört, ohne abgebrochen worden zu sein</translation>
    </message>
    <message>
        <source>it returned no result for some films of a batch</source>
        <translation>er hat für einige Filme eines Stapels kein Ergebnis geliefert</translation>
    </message>
    <message>
        <source>it created no film</source>
        <translation>er hat keinen Film erzeugt</translation>
    </message>
    <message>
        <source>it returned an invalid state for some points</source>
        <translation>er hat für einige Punkte einen ungültigen Zustand geliefert</translation>
    </message>
    <message>
        <source>it returned an invalid mark for some points</source>
        <translation>er hat für einige Punkte eine ungültige Marke geliefert</translation>
    </message>
    <message>
        <source>it reported an impossible number of steps or an impossible descent</source>
        <translation>er hat eine unmögliche Zahl von Schritten oder eine unmögliche Tauchtiefe gemeldet</translation>
    </message>
</context>
<context>
    <name>ColourNote</name>
    <message>
        <source>%1 has colours outside BT.2020, the largest colour space used here: %2 % of its pixels are printed less saturated; to control this, save it in a smaller colour space, such as Adobe RGB</source>
        <translation>%1 hat Farben außerhalb von BT.2020, dem größten hier verwendeten Farbraum: %2 % der Pixel werden weniger gesättigt gedruckt; um das selbst zu bestimmen, speichern Sie das Bild in einem kleineren Farbraum wie Adobe RGB</translation>
    </message>
    <message>
        <source>%1 is in CMYK and has no ICC profile, so its colours are only estimated and can be wrong; save it with its profile, or as sRGB</source>
        <translation>%1 ist in CMYK und hat kein ICC-Profil, daher sind die Farben nur geschätzt und können falsch sein; speichern Sie das Bild mit seinem Profil oder als sRGB</translation>
    </message>
    <message>
        <source>%1 is to be shown turned or mirrored, as its EXIF data says, but it is used as its pixels are stored; save it upright in an image program</source>
        <translation>%1 soll laut seinen EXIF-Daten gedreht oder gespiegelt gezeigt werden, wird aber so verwendet, wie seine Pixel gespeichert sind; speichern Sie es in einem Bildprogramm aufrecht</translation>
    </message>
    <message>
        <source>%1 names its colour space in a cICP chunk, which is not read, so its colours count as sRGB and can be wrong; save it with an ICC profile, or as sRGB</source>
        <translation>%1 nennt seinen Farbraum in einem cICP-Block, der nicht gelesen wird; die Farben gelten daher als sRGB und können falsch sein; speichern Sie es mit einem ICC-Profil oder als sRGB</translation>
    </message>
</context>
<context>
    <name>Cost</name>
    <message>
        <source>Cyan</source>
        <translation>Cyan</translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation>Magenta</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Ink: %1</source>
        <translation>Tinte: %1</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Arbeit</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Einrichten</translation>
    </message>
    <message>
        <source>Handling</source>
        <translation>Handhabung</translation>
    </message>
    <message>
        <source>Soak</source>
        <translation>Einweichen</translation>
    </message>
    <message>
        <source>Activator</source>
        <translation>Aktivator</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Tauchen</translation>
    </message>
    <message>
        <source>Flash, each rack</source>
        <translation>Ablüften, je Gestell</translation>
    </message>
    <message>
        <source>Drying, each rack</source>
        <translation>Trocknen, je Gestell</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>%1 m of roll</source>
        <translation>%1 m Rolle</translation>
    </message>
    <message>
        <source>%1 sheets</source>
        <translation>%1 Blätter</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>no price</source>
        <translation>kein Preis</translation>
    </message>
    <message>
        <source>no ml/m²</source>
        <translation>keine ml/m²</translation>
    </message>
    <message>
        <source>no time for the set-up</source>
        <translation>keine Zeit für das Einrichten</translation>
    </message>
    <message>
        <source>no time for handling</source>
        <translation>keine Zeit für die Handhabung</translation>
    </message>
    <message>
        <source>no soak time</source>
        <translation>keine Einweichzeit</translation>
    </message>
    <message>
        <source>no activator time</source>
        <translation>keine Aktivatorzeit</translation>
    </message>
    <message>
        <source>no flash time</source>
        <translation>keine Ablüftzeit</translation>
    </message>
    <message>
        <source>no drying time</source>
        <translation>keine Trockenzeit</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 days %2 h</source>
        <translation>%1 Tage %2 h</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>Sum of the known prices</source>
        <translation>Summe der bekannten Preise</translation>
    </message>
    <message>
        <source>Working time</source>
        <translation>Arbeitszeit</translation>
    </message>
    <message>
        <source>Until the last part is dry</source>
        <translation>Bis das letzte Teil trocken ist</translation>
    </message>
    <message>
        <source>no price for the film</source>
        <translation>kein Preis für den Film</translation>
    </message>
    <message>
        <source>no price for an hour of work</source>
        <translation>kein Preis für eine Arbeitsstunde</translation>
    </message>
    <message>
        <source>no amount in ml/m² for ink: %1</source>
        <translation>keine Menge in ml/m² für Tinte: %1</translation>
    </message>
    <message>
        <source>no price for ink: %1</source>
        <translation>kein Preis für Tinte: %1</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2</source>
        <translation>Teile: %1, Blätter: %2</translation>
    </message>
    <message>
        <source>cost: %1, for each part: %2</source>
        <translation>Kosten: %1, je Teil: %2</translation>
    </message>
    <message>
        <source>working time: %1, until the last part is dry: %2</source>
        <translation>Arbeitszeit: %1, bis das letzte Teil trocken ist: %2</translation>
    </message>
</context>
<context>
    <name>Cradle</name>
    <message>
        <source>Forming the cradle</source>
        <translation>Halterung wird geformt</translation>
    </message>
    <message>
        <source>Checking the cradle</source>
        <translation>Halterung wird geprüft</translation>
    </message>
    <message>
        <source>%1: the part can slide sideways in its cradle, because its dry surface is too flat; mark its position and fix it there</source>
        <translation>%1: Das Teil kann in seiner Halterung seitlich rutschen, weil seine trockene Fläche zu flach ist; zeichnen Sie seine Lage an, und befestigen Sie es dort</translation>
    </message>
    <message>
        <source>%1: the cradle&apos;s plate has no room for the engraving; write the arrow, the dip number and the job on it</source>
        <translation>%1: Die Platte der Halterung hat keinen Platz für die Gravur; schreiben Sie Pfeil, Nummer des Tauchvorgangs und Auftrag darauf</translation>
    </message>
    <message>
        <source>%1: no cradle is possible, because an earlier dip has painted every place that could hold the part; allow padded contact with paint (cradle.on_paint), or turn the part</source>
        <translation>%1: Es ist keine Halterung möglich, weil ein früherer Tauchvorgang alle Stellen bemalt hat, die das Teil halten könnten; erlauben Sie gepolsterten Kontakt mit der Farbe (cradle.on_paint), oder drehen Sie das Teil</translation>
    </message>
    <message>
        <source>%1: no cradle is possible, because the film reaches every place that could hold the part; dip it less deep, or turn the part</source>
        <translation>%1: Es ist keine Halterung möglich, weil der Film alle Stellen erreicht, die das Teil halten könnten; tauchen Sie es weniger tief, oder drehen Sie das Teil</translation>
    </message>
    <message>
        <source>Finding the surface that stays dry</source>
        <translation>Trocken bleibende Fläche wird gesucht</translation>
    </message>
    <message>
        <source>%1: the part tips out of its cradle unless it is fastened, because the cradle cannot hold it on all sides of its centre of mass. Fasten the part through the bore in the cradle, or turn the part</source>
        <translation>%1: Das Teil kippt aus seiner Halterung, wenn es nicht befestigt wird, weil die Halterung es nicht auf allen Seiten seines Schwerpunkts halten kann. Befestigen Sie das Teil durch die Bohrung in der Halterung, oder drehen Sie das Teil</translation>
    </message>
    <message>
        <source>%1: the cradle touches %2 mm² of paint from an earlier dip; line the cradle there with %3 mm of soft felt or foam</source>
        <translation>%1: Die Halterung berührt %2 mm² Farbe aus einem früheren Tauchvorgang; legen Sie die Halterung dort mit %3 mm weichem Filz oder Schaumstoff aus</translation>
    </message>
    <message>
        <source>%1: no cradle is possible, because on this path it would touch the film on the water; tilt or roll the part less, dip it less deep, or hold it by hand</source>
        <translation>%1: Es ist keine Halterung möglich, weil sie auf diesem Weg den Film auf dem Wasser berühren würde; kippen oder rollen Sie das Teil weniger, tauchen Sie es weniger tief, oder halten Sie es von Hand</translation>
    </message>
    <message>
        <source>Reducing the triangles of the cradle</source>
        <translation>Dreiecke der Halterung werden verringert</translation>
    </message>
    <message>
        <source>%1: no cradle is possible, because the bore is wider than the place where the part rests; choose a smaller bore (cradle.bore_mm)</source>
        <translation>%1: Keine Halterung ist möglich, weil die Bohrung breiter ist als die Stelle, auf der das Teil ruht; wählen Sie eine kleinere Bohrung (cradle.bore_mm)</translation>
    </message>
    <message>
        <source>%1: the model has %2 separate parts, but the cradle has one bore, which can fasten only one of them; give each part its own holder</source>
        <translation>%1: Das Modell hat %2 getrennte Teile, aber die Halterung hat nur eine Bohrung, die nur eines davon befestigen kann; geben Sie jedem Teil einen eigenen Halter</translation>
    </message>
</context>
<context>
    <name>Dip</name>
    <message>
        <source>Dipping</source>
        <translation>Tauchen</translation>
    </message>
    <message>
        <source>The solver failed: %1</source>
        <translation>Der Solver ist gescheitert: %1</translation>
    </message>
    <message>
        <source>The solver failed with an unknown exception</source>
        <translation>Der Solver ist mit einer unbekannten Ausnahme gescheitert</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Torn film</source>
        <translation>Gerissener Film</translation>
    </message>
    <message>
        <source>Film that did not converge</source>
        <translation>Film, der nicht konvergierte</translation>
    </message>
    <message>
        <source>Released film</source>
        <translation>Abgelöster Film</translation>
    </message>
    <message>
        <source>The part does not meet the film; move it over the film, choose a larger film, or give the film smaller cells or more points</source>
        <translation>Das Teil trifft den Film nicht; schieben Sie es über den Film, wählen Sie einen größeren Film oder geben Sie dem Film kleinere Zellen oder mehr Punkte</translation>
    </message>
    <message>
        <source>The solver did not find the part: it is only %1 mm thick in places, and the distance field has cells of %2 mm; make it thicker there, or dip only a section of it</source>
        <translation>Der Solver hat das Teil nicht gefunden: Es ist stellenweise nur %1 mm dick, und das Abstandsfeld hat Zellen von %2 mm; machen Sie es dort dicker, oder tauchen Sie nur einen Abschnitt davon</translation>
    </message>
    <message>
        <source>The part, %1 × %2 mm on the water, reaches past the film on all sides, so no film is left to wrap round it; %3</source>
        <translation>Das Teil, %1 × %2 mm auf dem Wasser, ragt auf allen Seiten über den Film hinaus, sodass kein Film bleibt, der es umhüllt; %3</translation>
    </message>
    <message>
        <source>With these cells the film would have %1 million points, but at most %2 million are allowed; choose larger cells</source>
        <translation>Mit diesen Zellen hätte der Film %1 Millionen Punkte, erlaubt sind höchstens %2 Millionen; wählen Sie größere Zellen</translation>
    </message>
    <message>
        <source>The simulation became unstable; choose a smaller step or time step (Dipping &gt; Accuracy)</source>
        <translation>Die Simulation wurde instabil; wählen Sie einen kleineren Schritt oder Zeitschritt (Tauchen &gt; Genauigkeit)</translation>
    </message>
    <message>
        <source>%1 of the painted area (%2 %) is painted by film that tore, was released or did not converge. %3.</source>
        <translation>%1 der bemalten Fläche (%2 %) sind von Film bemalt, der riss, sich löste oder nicht konvergierte. %3.</translation>
    </message>
    <message>
        <source>This solver allows only straight dips; choose another solver, or a straight path</source>
        <translation>Dieser Solver erlaubt nur gerade Tauchvorgänge; wählen Sie einen anderen Solver oder einen geraden Weg</translation>
    </message>
    <message>
        <source>The film model of the paper allows only straight dips; choose the production film, or a straight path</source>
        <translation>Das Filmmodell der Veröffentlichung erlaubt nur gerade Tauchvorgänge; wählen Sie den Produktionsfilm oder einen geraden Weg</translation>
    </message>
    <message>
        <source>some places have several causes</source>
        <translation>einige Stellen haben mehrere Ursachen</translation>
    </message>
    <message>
        <source>check the model&apos;s size and unit, because no film is larger than %1 mm</source>
        <translation>prüfen Sie Größe und Einheit des Modells, weil kein Film größer als %1 mm ist</translation>
    </message>
    <message>
        <source>turn the film by 90° (%1 × %2 mm)</source>
        <translation>drehen Sie den Film um 90° (%1 × %2 mm)</translation>
    </message>
    <message>
        <source>choose a film that is clearly larger than %1 × %2 mm, because film also covers the part&apos;s sides</source>
        <translation>wählen Sie einen Film, der deutlich größer als %1 × %2 mm ist, weil Film auch die Seiten des Teils bedeckt</translation>
    </message>
</context>
<context>
    <name>DipCache</name>
    <message>
        <source>The file of cached dips is damaged and is ignored; the next run in the workbench replaces it</source>
        <translation>Die Datei der zwischengespeicherten Tauchvorgänge ist beschädigt und wird nicht verwendet; der nächste Lauf im Fenster ersetzt sie</translation>
    </message>
    <message>
        <source>The dips cannot be cached: %1</source>
        <translation>Die Tauchvorgänge können nicht zwischengespeichert werden: %1</translation>
    </message>
    <message>
        <source>Reading the cached dips</source>
        <translation>Zwischengespeicherte Tauchvorgänge werden gelesen</translation>
    </message>
</context>
<context>
    <name>DipJob</name>
    <message>
        <source>Simulating the dip</source>
        <translation>Tauchvorgang wird simuliert</translation>
    </message>
    <message>
        <source>Preparing the views</source>
        <translation>Ansichten werden vorbereitet</translation>
    </message>
    <message>
        <source>Refining the film</source>
        <translation>Der Film wird verfeinert</translation>
    </message>
</context>
<context>
    <name>DipPlayback</name>
    <message>
        <source>First contact</source>
        <translation>Erste Berührung</translation>
    </message>
    <message>
        <source>Film tears</source>
        <translation>Film reißt</translation>
    </message>
    <message>
        <source>Film is released at an overhang</source>
        <translation>Film löst sich an einem Überhang</translation>
    </message>
    <message>
        <source>Air is trapped under the part</source>
        <translation>Luft wird unter dem Teil eingeschlossen</translation>
    </message>
    <message>
        <source>%1, at depth %2</source>
        <translation>%1, in %2 Tiefe</translation>
    </message>
    <message>
        <source>Pose %1 of the path</source>
        <translation>Lage %1 des Wegs</translation>
    </message>
</context>
<context>
    <name>FileLock</name>
    <message>
        <source>%1 on %2, process %3</source>
        <translation>%1 auf %2, Prozess %3</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>ein anderes Programm</translation>
    </message>
    <message>
        <source>an unknown machine</source>
        <translation>einem unbekannten Rechner</translation>
    </message>
</context>
<context>
    <name>FilmFacts</name>
    <message>
        <source>%1: cells of %2, %3 × %4 points</source>
        <translation>%1: Zellen von %2, %3 × %4 Punkte</translation>
    </message>
    <message>
        <source>%1, simulation time about %2 s</source>
        <translation>%1, Rechenzeit etwa %2 s</translation>
    </message>
</context>
<context>
    <name>FilmFields</name>
    <message>
        <source>W</source>
        <comment>width</comment>
        <translation>B</translation>
    </message>
    <message>
        <source>H</source>
        <comment>height</comment>
        <translation>H</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Held by a barrier</source>
        <translation>Von einer Barriere gehalten</translation>
    </message>
    <message>
        <source>Swell</source>
        <translation>Quellung</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxation</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>Elastisch</translation>
    </message>
    <message>
        <source>Contact distance</source>
        <translation>Kontaktabstand</translation>
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
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>C</source>
        <comment>cyan</comment>
        <translation>C</translation>
    </message>
    <message>
        <source>M</source>
        <comment>magenta</comment>
        <translation>M</translation>
    </message>
    <message>
        <source>Y</source>
        <comment>yellow</comment>
        <translation>Y</translation>
    </message>
    <message>
        <source>K</source>
        <comment>black</comment>
        <translation>K</translation>
    </message>
    <message>
        <source>W</source>
        <comment>white</comment>
        <translation>W</translation>
    </message>
    <message>
        <source>As in the project</source>
        <translation>Wie im Projekt</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Überhang</translation>
    </message>
    <message>
        <source>Total growth of the floating film after a long time, relative to its length at the start of the dip. 0: the film does not grow.</source>
        <translation>Gesamtes Wachstum des schwimmenden Films nach langer Zeit, bezogen auf seine Länge zu Beginn des Tauchens. 0: Der Film wächst nicht.</translation>
    </message>
    <message>
        <source>Whether this side of the film floats freely or a barrier in the tank holds it.</source>
        <translation>Ob diese Seite des Films frei schwimmt oder eine Barriere im Becken sie hält.</translation>
    </message>
    <message>
        <source>Size of the wetted film relative to the printed film, in width and height. The sheet is printed smaller by this factor, so measure it first.</source>
        <translation>Größe des benetzten Films im Verhältnis zum gedruckten, in Breite und Höhe. Das Blatt wird um diesen Faktor kleiner gedruckt; messen Sie ihn deshalb zuerst.</translation>
    </message>
    <message>
        <source>Time in which stress in the floating film decays. Elastic film keeps its stress for ever; viscous film (0 s) loses it at once.</source>
        <translation>Zeit, in der Spannung im schwimmenden Film abklingt. Elastischer Film behält seine Spannung für immer; viskoser Film (0 s) verliert sie sofort.</translation>
    </message>
    <message>
        <source>Growth rate</source>
        <translation>Wachstumsrate</translation>
    </message>
    <message>
        <source>How fast the floating film grows at the start of the dip, per second. Adhered film does not grow.</source>
        <translation>Wie schnell der schwimmende Film zu Beginn des Tauchvorgangs wächst, je Sekunde. Haftender Film wächst nicht.</translation>
    </message>
    <message>
        <source>Growth limit</source>
        <translation>Grenze des Wachstums</translation>
    </message>
    <message>
        <source>A film point touches the part when it comes this close to its surface.</source>
        <translation>Ein Filmpunkt berührt das Teil, wenn er dessen Oberfläche so nahe kommt.</translation>
    </message>
    <message>
        <source>Ink exponent</source>
        <translation>Tintenexponent</translation>
    </message>
    <message>
        <source>Ink exponent, black and white</source>
        <translation>Tintenexponent, Schwarz und Weiß</translation>
    </message>
    <message>
        <source>Measured ink</source>
        <translation>Gemessene Tinte</translation>
    </message>
    <message>
        <source>Film tears where its length or its area is stretched by more than this factor. Torn film is marked and does not paint.</source>
        <translation>Film reißt, wo seine Länge oder seine Fläche um mehr als diesen Faktor gedehnt wird. Gerissener Film wird markiert und bemalt nichts.</translation>
    </message>
    <message>
        <source>Grip fade range</source>
        <translation>Bereich des Haltverlusts</translation>
    </message>
    <message>
        <source>Gathering stretch</source>
        <translation>Raffdehnung</translation>
    </message>
    <message>
        <source>Tear stretch</source>
        <translation>Reißdehnung</translation>
    </message>
    <message>
        <source>The part loses its grip on the film gradually, in this range of angles before the overhang. This value is a guess; no film was measured.</source>
        <translation>Winkelbereich vor dem Überhang, in dem das Teil den Halt am Film allmählich verliert. Dieser Wert ist eine Annahme; kein Film wurde gemessen.</translation>
    </message>
    <message>
        <source>Compressed film gathers where its mean stretch falls below this value. Gathered film hardly resists further compression. This value is a guess; no film was measured.</source>
        <translation>Gestauchter Film rafft sich, wo seine mittlere Dehnung unter diesen Wert fällt. Geraffter Film leistet weiterer Stauchung kaum Widerstand. Dieser Wert ist eine Annahme; kein Film wurde gemessen.</translation>
    </message>
    <message>
        <source>How ink thins: where film is stretched to J times its area, ink of density D has only the density D·J^−n. n is 1 for dye and 0 for opaque dots. Used for inks without measured tones; the preset value is a guess.</source>
        <translation>Wie Tinte dünner wird: Wo der Film auf das J-fache seiner Fläche gedehnt ist, hat Tinte der Dichte D nur noch die Dichte D·J^−n. n ist 1 für Farbstoff und 0 für deckende Punkte. Gilt für Tinten ohne gemessene Töne; der voreingestellte Wert ist eine Annahme.</translation>
    </message>
    <message>
        <source>The exponent n for black and white ink. Only CMYK printers use it, because only for them each ink is compensated individually, after colour separation.</source>
        <translation>Der Exponent n für schwarze und weiße Tinte. Er gilt nur für CMYK-Drucker, weil nur bei ihnen jede Tinte einzeln ausgeglichen wird, nach der Farbseparation.</translation>
    </message>
    <message>
        <source>Values for each tone of a measured step wedge: ink, density, exponent, bend and largest stretch. The command “dipwright-cli profile wedge” computes them.</source>
        <translation>Werte für jeden Ton eines gemessenen Stufenkeils: Tinte, Dichte, Exponent, Krümmung und größte Dehnung. Der Befehl „dipwright-cli profile wedge“ berechnet sie.</translation>
    </message>
    <message>
        <source>Film adheres to faces that turn up from the vertical by at most this angle. Faces that turn up more release the film.</source>
        <translation>Film haftet auf Flächen, die sich aus der Senkrechten um höchstens diesen Winkel nach oben wenden. Von Flächen, die sich weiter nach oben wenden, löst er sich.</translation>
    </message>
</context>
<context>
    <name>FilmMeasured</name>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>measured on %1</source>
        <translation>gemessen am %1</translation>
    </message>
    <message>
        <source>swell</source>
        <translation>Quellung</translation>
    </message>
    <message>
        <source>growth</source>
        <translation>Wachstum</translation>
    </message>
    <message>
        <source>relaxation</source>
        <translation>Relaxation</translation>
    </message>
    <message>
        <source>%1 measured on %2</source>
        <translation>%1 gemessen am %2</translation>
    </message>
    <message>
        <source>%1 not measured</source>
        <translation>%1 nicht gemessen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>None (film not measured)</source>
        <translation>Keines (Film nicht gemessen)</translation>
    </message>
</context>
<context>
    <name>FolderTransaction</name>
    <message>
        <source>The results cannot be written: %1</source>
        <translation>Die Ergebnisse können nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>The results cannot be written, because %1 is not a folder</source>
        <translation>Die Ergebnisse können nicht geschrieben werden, weil %1 kein Ordner ist</translation>
    </message>
    <message>
        <source>Another program is writing results to this folder (%1); wait for it, or choose another folder</source>
        <translation>Ein anderes Programm schreibt Ergebnisse in diesen Ordner (%1); warten Sie darauf, oder wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>The folder cannot be written; choose another folder</source>
        <translation>In den Ordner kann nicht geschrieben werden; wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>The results are incomplete, because files in %1 were moved or removed during writing; leave that folder alone and try again</source>
        <translation>Die Ergebnisse sind unvollständig, weil während des Schreibens Dateien in %1 verschoben oder entfernt wurden; lassen Sie diesen Ordner unberührt und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>The results cannot be moved into the folder, perhaps because a file there is in use; close it and try again</source>
        <translation>Die Ergebnisse können nicht in den Ordner verschoben werden, vielleicht weil dort eine Datei benutzt wird; schließen Sie sie und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>Only some of the results were moved into the folder; close the programs that have files there open, then start this program again to move the rest</source>
        <translation>Nur ein Teil der Ergebnisse wurde in den Ordner verschoben; schließen Sie die Programme, die dort Dateien geöffnet haben, und starten Sie dieses Programm neu, um den Rest zu verschieben</translation>
    </message>
    <message>
        <source>Earlier results in this folder are incomplete, and another program prevents their completion. Close the programs that use files in the folder, or move %1 out of the folder</source>
        <translation>Frühere Ergebnisse in diesem Ordner sind unvollständig, und ein anderes Programm verhindert, dass sie vervollständigt werden. Schließen Sie die Programme, die Dateien in diesem Ordner benutzen, oder verschieben Sie %1 aus dem Ordner</translation>
    </message>
    <message>
        <source>Results that were just written cannot be read: %1</source>
        <translation>Die eben geschriebenen Ergebnisse lassen sich nicht lesen: %1</translation>
    </message>
    <message>
        <source>The results cannot be written, because %1 already exists and cannot be replaced; move it, or choose another folder</source>
        <translation>Die Ergebnisse können nicht geschrieben werden, weil %1 schon vorhanden ist und nicht ersetzt werden kann; verschieben Sie es, oder wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>The results cannot be written: their folder was removed or moved meanwhile</source>
        <translation>Die Ergebnisse können nicht geschrieben werden: Ihr Ordner wurde inzwischen entfernt oder verschoben</translation>
    </message>
</context>
<context>
    <name>GuidePlaces</name>
    <message>
        <source>Dip ▸ Tolerances</source>
        <translation>Tauchen ▸ Toleranzen</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>File ▸ Print</source>
        <translation>Datei ▸ Drucken</translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation>ICC-Profil</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Edit ▸ Profiles</source>
        <translation>Bearbeiten ▸ Profile</translation>
    </message>
    <message>
        <source>Measuring a dipped part</source>
        <translation>Ein getauchtes Teil messen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Measuring a film</source>
        <translation>Einen Film messen</translation>
    </message>
    <message>
        <source>File ▸ Snapshots</source>
        <translation>Datei ▸ Schnappschüsse</translation>
    </message>
    <message>
        <source>log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Dip ▸ Check numerical error</source>
        <translation>Tauchen ▸ Numerischen Fehler prüfen</translation>
    </message>
    <message>
        <source>File ▸ New project</source>
        <translation>Datei ▸ Neues Projekt</translation>
    </message>
    <message>
        <source>Reload model</source>
        <translation>Modell neu laden</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Dip ▸ Find poses</source>
        <translation>Tauchen ▸ Lagen suchen</translation>
    </message>
    <message>
        <source>File ▸ Print history</source>
        <translation>Datei ▸ Druckverlauf</translation>
    </message>
    <message>
        <source>File ▸ Calibrate printer</source>
        <translation>Datei ▸ Drucker kalibrieren</translation>
    </message>
    <message>
        <source>As built</source>
        <translation>Gefertigt</translation>
    </message>
    <message>
        <source>File ▸ Job queue</source>
        <translation>Datei ▸ Warteschlange</translation>
    </message>
    <message>
        <source>At the tank</source>
        <translation>Am Becken</translation>
    </message>
    <message>
        <source>File ▸ Plates</source>
        <translation>Datei ▸ Platten</translation>
    </message>
    <message>
        <source>Dip ▸ Send to server</source>
        <translation>Tauchen ▸ An Server senden</translation>
    </message>
</context>
<context>
    <name>ImmersionEdits</name>
    <message>
        <source>Add dip</source>
        <translation>Tauchvorgang hinzufügen</translation>
    </message>
    <message>
        <source>Dip %1</source>
        <translation>Tauchvorgang %1</translation>
    </message>
    <message>
        <source>Remove dip</source>
        <translation>Tauchvorgang entfernen</translation>
    </message>
    <message>
        <source>Use pose</source>
        <translation>Lage übernehmen</translation>
    </message>
    <message>
        <source>Swap dips</source>
        <translation>Tauchvorgänge tauschen</translation>
    </message>
    <message>
        <source>Try poses</source>
        <translation>Lagen ausprobieren</translation>
    </message>
    <message>
        <source>Add pose to path</source>
        <translation>Lage zum Weg hinzufügen</translation>
    </message>
    <message>
        <source>Remove pose from path</source>
        <translation>Lage aus dem Weg entfernen</translation>
    </message>
</context>
<context>
    <name>InkOptions</name>
    <message>
        <source>Comparing the options for ink</source>
        <translation>Möglichkeiten für die Tinte werden verglichen</translation>
    </message>
    <message>
        <source>Lighten the darkest colours to density %1</source>
        <translation>Die dunkelsten Farben bis zur Dichte %1 aufhellen</translation>
    </message>
    <message>
        <source>Print white beneath the colours</source>
        <translation>Weiß unter die Farben drucken</translation>
    </message>
    <message>
        <source>Print the ink in %1 passes</source>
        <translation>Die Tinte in %1 Durchgängen drucken</translation>
    </message>
    <message>
        <source>Search for a pose with less stretch</source>
        <translation>Eine Lage mit weniger Dehnung suchen</translation>
    </message>
    <message>
        <source>%1 % of the painted surface too pale; missing density where it is short now: %2 (95 %), %3 at most; mean colour error ΔE %4</source>
        <translation>%1 % der bemalten Fläche zu blass; fehlende Dichte, wo sie jetzt nicht reicht: %2 (95 %), höchstens %3; mittlerer Farbfehler ΔE %4</translation>
    </message>
    <message>
        <source>; %1 % of the contrast there</source>
        <translation>; dort %1 % des Kontrasts</translation>
    </message>
    <message>
        <source>ink suffices where the area of the film grows at most %1 times</source>
        <translation>die Tinte reicht, wo die Fläche des Films höchstens auf das %1-Fache wächst</translation>
    </message>
</context>
<context>
    <name>InspectionEdits</name>
    <message>
        <source>Measured %1</source>
        <translation>Gemessen %1</translation>
    </message>
    <message>
        <source>Add photos</source>
        <translation>Fotos hinzufügen</translation>
    </message>
    <message>
        <source>Remove photo</source>
        <translation>Foto entfernen</translation>
    </message>
    <message>
        <source>Add pair of places</source>
        <translation>Stellenpaar hinzufügen</translation>
    </message>
    <message>
        <source>Move place in photo</source>
        <translation>Stelle im Foto verschieben</translation>
    </message>
    <message>
        <source>Remove pair of places</source>
        <translation>Stellenpaar entfernen</translation>
    </message>
    <message>
        <source>Keep part</source>
        <translation>Teil behalten</translation>
    </message>
    <message>
        <source>Correct the next sheets</source>
        <translation>Nächste Blätter korrigieren</translation>
    </message>
    <message>
        <source>Change strength of correction</source>
        <translation>Stärke der Korrektur ändern</translation>
    </message>
    <message>
        <source>Change film measurement</source>
        <translation>Filmmessung ändern</translation>
    </message>
    <message>
        <source>Use fit in project</source>
        <translation>Anpassung im Projekt verwenden</translation>
    </message>
</context>
<context>
    <name>InspectionProfile</name>
    <message>
        <source>Save to profile</source>
        <translation>Im Profil speichern</translation>
    </message>
    <message>
        <source>Name of a new or existing film profile</source>
        <translation>Name eines neuen oder vorhandenen Filmprofils</translation>
    </message>
    <message>
        <source>Saved the measurement in the film profile %1</source>
        <translation>Messung im Filmprofil %1 gespeichert</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Artwork</source>
        <translation>Gestaltung</translation>
    </message>
    <message>
        <source>Pose search</source>
        <translation>Lagensuche</translation>
    </message>
</context>
<context>
    <name>MarkEdits</name>
    <message>
        <source>Mark zone</source>
        <translation>Zone markieren</translation>
    </message>
    <message>
        <source>Remove mark</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>Remove marks</source>
        <translation>Marken entfernen</translation>
    </message>
    <message>
        <source>Mark area for the seam</source>
        <translation>Bereich für die Naht markieren</translation>
    </message>
    <message>
        <source>Erase marks for the seam</source>
        <translation>Markierungen für die Naht radieren</translation>
    </message>
    <message>
        <source>Erase mask</source>
        <translation>Maske radieren</translation>
    </message>
    <message>
        <source>Mask area</source>
        <translation>Fläche maskieren</translation>
    </message>
    <message>
        <source>The project holds as many marks of this kind as it can; remove some to mark more</source>
        <translation>Das Projekt enthält so viele Markierungen dieser Art wie möglich; entfernen Sie einige, um mehr zu markieren</translation>
    </message>
</context>
<context>
    <name>Mask</name>
    <message>
        <source>Masked areas: %1 (%2 mm²). Cover them with tape before the first dip.</source>
        <translation>Maskierte Flächen: %1 (%2 mm²). Vor dem ersten Tauchvorgang mit Klebeband abdecken.</translation>
    </message>
</context>
<context>
    <name>ModelEdits</name>
    <message>
        <source>Change size</source>
        <translation>Größe ändern</translation>
    </message>
</context>
<context>
    <name>ModelImport</name>
    <message>
        <source>Reading the model</source>
        <translation>Modell wird gelesen</translation>
    </message>
    <message>
        <source>Reading the texture</source>
        <translation>Textur wird gelesen</translation>
    </message>
    <message>
        <source>Dip %1</source>
        <translation>Tauchvorgang %1</translation>
    </message>
    <message>
        <source>The model refers to files outside its folder:</source>
        <translation>Das Modell verweist auf Dateien außerhalb seines Ordners:</translation>
    </message>
    <message>
        <source>Reload model</source>
        <translation>Modell neu laden</translation>
    </message>
    <message>
        <source>The project file refers to these files:</source>
        <translation>Die Projektdatei verweist auf diese Dateien:</translation>
    </message>
    <message>
        <source>Replace model</source>
        <translation>Modell ersetzen</translation>
    </message>
    <message>
        <source>Replace texture</source>
        <translation>Textur ersetzen</translation>
    </message>
    <message>
        <source>Change tolerance</source>
        <translation>Toleranz ändern</translation>
    </message>
    <message>
        <source>Making the triangles again</source>
        <translation>Die Dreiecke werden neu gemacht</translation>
    </message>
</context>
<context>
    <name>Motion</name>
    <message>
        <source>The motion template contains the unknown placeholder {%1}; use one of these: %2</source>
        <translation>Die Bewegungsvorlage enthält den unbekannten Platzhalter {%1}; verwenden Sie einen von diesen: %2</translation>
    </message>
    <message>
        <source>This dip follows a path, and the motion template has no {moves}; add {moves} or {moves_per_minute}, or choose the template of a controller: linuxcnc, grbl or marlin</source>
        <translation>Dieser Tauchvorgang folgt einem Weg, aber die Bewegungsvorlage enthält kein {moves}; ergänzen Sie {moves} oder {moves_per_minute}, oder wählen Sie die Vorlage einer Steuerung: linuxcnc, grbl oder marlin</translation>
    </message>
</context>
<context>
    <name>OutOfProcessSolver</name>
    <message>
        <source>its process cannot be started: %1</source>
        <translation>sein Prozess kann nicht gestartet werden: %1</translation>
    </message>
    <message>
        <source>it did not respond for %1 s and was stopped</source>
        <translation>er hat %1 s lang nicht geantwortet und wurde beendet</translation>
    </message>
    <message>
        <source>its answer was impossibly long, so its process was stopped</source>
        <translation>seine Antwort war unmöglich lang, daher wurde sein Prozess beendet</translation>
    </message>
    <message>
        <source>its process was killed, perhaps because the memory was full</source>
        <translation>sein Prozess wurde abgebrochen, vielleicht weil der Speicher voll war</translation>
    </message>
    <message>
        <source>it crashed (code %1)</source>
        <translation>er ist abgestürzt (Code %1)</translation>
    </message>
    <message>
        <source>its process ended unexpectedly (exit code %1)</source>
        <translation>sein Prozess endete unerwartet (Exit-Code %1)</translation>
    </message>
</context>
<context>
    <name>OutputSets</name>
    <message>
        <source>Sheets as PDF</source>
        <translation>Blätter als PDF</translation>
    </message>
    <message>
        <source>Film images as PNG</source>
        <translation>Filmbilder als PNG</translation>
    </message>
    <message>
        <source>Sheets in the printer&apos;s colours as PDF</source>
        <translation>Blätter in den Farben des Druckers als PDF</translation>
    </message>
    <message>
        <source>Sheets in the printer&apos;s colours as TIFF</source>
        <translation>Blätter in den Farben des Druckers als TIFF</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Traveller</source>
        <translation>Laufkarte</translation>
    </message>
    <message>
        <source>Motion programs</source>
        <translation>Bewegungsprogramme</translation>
    </message>
    <message>
        <source>Cradles</source>
        <translation>Halterungen</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Film and part for ParaView</source>
        <translation>Film und Teil für ParaView</translation>
    </message>
    <message>
        <source>Maps of the film</source>
        <translation>Karten des Films</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Print shop</source>
        <translation>Druckerei</translation>
    </message>
    <message>
        <source>Tank</source>
        <translation>Becken</translation>
    </message>
    <message>
        <source>There is no output set of this name; the project has %1. A list of outputs is also possible: %2</source>
        <translation>Es gibt keinen Ausgabesatz mit diesem Namen; das Projekt hat %1. Möglich ist auch eine Liste von Ausgaben: %2</translation>
    </message>
    <message>
        <source>Proof to share</source>
        <translation>Vorschau zum Weitergeben</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Kunde</translation>
    </message>
</context>
<context>
    <name>Outputs</name>
    <message>
        <source>Writing the sheet of %1</source>
        <translation>Blatt von %1 wird geschrieben</translation>
    </message>
    <message>
        <source>The folder cannot be created; choose another one</source>
        <translation>Der Ordner kann nicht angelegt werden; wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>These files were not made by an output or were changed since: %1. Allow overwriting, or choose another folder</source>
        <translation>Diese Dateien hat keine Ausgabe erzeugt, oder sie wurden seitdem geändert: %1. Erlauben Sie das Überschreiben oder wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>%1: done, %2</source>
        <translation>%1: fertig, %2</translation>
    </message>
    <message>
        <source>%1: failed. %2</source>
        <translation>%1: fehlgeschlagen. %2</translation>
    </message>
    <message>
        <source>%1: out of date</source>
        <translation>%1: veraltet</translation>
    </message>
    <message>
        <source>%1: not made</source>
        <translation>%1: nicht erzeugt</translation>
    </message>
</context>
<context>
    <name>PhysicsValidation</name>
    <message>
        <source>%1 film, %2 cells in the contact radius</source>
        <translation>%1er Film, %2 Zellen im Kontaktradius</translation>
    </message>
    <message>
        <source>arc length from the pole (mm)</source>
        <translation>Bogenlänge vom Pol (mm)</translation>
    </message>
    <message>
        <source>film radius (mm)</source>
        <translation>Filmradius (mm)</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>rms</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>FAILED</source>
        <translation>FEHLER</translation>
    </message>
    <message>
        <source>Dipping</source>
        <translation>Tauchen</translation>
    </message>
    <message>
        <source>The solver failed: %1</source>
        <translation>Der Solver ist gescheitert: %1</translation>
    </message>
    <message>
        <source>physics validation</source>
        <translation>Prüfung der Physik</translation>
    </message>
    <message>
        <source>Flat spheroid 1 : 0.6</source>
        <translation>Flaches Sphäroid 1 : 0,6</translation>
    </message>
    <message>
        <source>Long spheroid 1 : 1.4</source>
        <translation>Langes Sphäroid 1 : 1,4</translation>
    </message>
    <message>
        <source>Cone of %1°</source>
        <translation>Kegel von %1°</translation>
    </message>
    <message>
        <source>viscous</source>
        <translation>viskos</translation>
    </message>
    <message>
        <source>elastic</source>
        <translation>elastisch</translation>
    </message>
    <message>
        <source>Flat face, 60 × 40 mm</source>
        <translation>Ebene Fläche, 60 × 40 mm</translation>
    </message>
    <message>
        <source>Ellipsoid turned by 45°</source>
        <translation>Ellipsoid um 45° gedreht</translation>
    </message>
    <message>
        <source>%1, %2 cells</source>
        <translation>%1, %2 Zellen</translation>
    </message>
    <message>
        <source>Flat face</source>
        <translation>Ebene Fläche</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>growing</source>
        <translation>wachsend</translation>
    </message>
    <message>
        <source>Film before it is touched</source>
        <translation>Film vor der Berührung</translation>
    </message>
    <message>
        <source>The film never touched the body; do not use this solver</source>
        <translation>Der Film hat den Körper nie berührt; verwenden Sie diesen Solver nicht</translation>
    </message>
    <message>
        <source>axes − diagonals</source>
        <translation>Achsen − Diagonalen</translation>
    </message>
    <message>
        <source>Inner side of a torus, up to 80° from its lowest circle</source>
        <translation>Innenseite eines Torus, bis 80° von seinem tiefsten Kreis</translation>
    </message>
    <message>
        <source>Sphere, up to 80° from its lowest point</source>
        <translation>Kugel, bis 80° von ihrem tiefsten Punkt</translation>
    </message>
    <message>
        <source>Horizontal cylinder, up to 80° from its lowest line</source>
        <translation>Liegender Zylinder, bis 80° von seiner tiefsten Linie</translation>
    </message>
</context>
<context>
    <name>Pipeline</name>
    <message>
        <source>a film with coarser cells does not follow the part</source>
        <translation>ein Film mit gröberen Zellen folgt dem Teil nicht</translation>
    </message>
    <message>
        <source>Writing the sheet of %1</source>
        <translation>Blatt von %1 wird geschrieben</translation>
    </message>
    <message>
        <source>Writing the film of %1</source>
        <translation>Film von %1 wird geschrieben</translation>
    </message>
    <message>
        <source>Comparing the sheets</source>
        <translation>Blätter werden verglichen</translation>
    </message>
    <message>
        <source>Writing the proof</source>
        <translation>Vorschau wird geschrieben</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Bericht wird geschrieben</translation>
    </message>
    <message>
        <source>Reversing the texture</source>
        <translation>Textur wird umgekehrt</translation>
    </message>
    <message>
        <source>Dipping with varied film laws</source>
        <translation>Tauchen mit veränderten Filmgesetzen</translation>
    </message>
    <message>
        <source>Writing the cradle of %1</source>
        <translation>Halterung von %1 wird geschrieben</translation>
    </message>
    <message>
        <source>Writing the traveller</source>
        <translation>Laufkarte wird geschrieben</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Writing film %1</source>
        <translation>Film %1 wird geschrieben</translation>
    </message>
    <message>
        <source>The picture on the film</source>
        <translation>Das Bild auf dem Film</translation>
    </message>
    <message>
        <source>1:1, reduced for swell %1 × %2</source>
        <translation>1:1, verkleinert um Quellung %1 × %2</translation>
    </message>
    <message>
        <source>Locating the film on the part</source>
        <translation>Film auf dem Teil wird gesucht</translation>
    </message>
    <message>
        <source>%1 should be dipped after %2. Along the seam, the film&apos;s stretch is %3 for %1 and %4 for %2. A placement error of the second film grows with its stretch.</source>
        <translation>%1 sollte nach %2 getaucht werden. Längs der Naht beträgt die Dehnung des Films %3 bei %1 und %4 bei %2. Ein Lagefehler des zweiten Films wächst mit dessen Dehnung.</translation>
    </message>
    <message>
        <source>The project has no model; import one first</source>
        <translation>Das Projekt hat kein Modell; importieren Sie zuerst eines</translation>
    </message>
    <message>
        <source>The run needs about %1 GB of memory for the sheets</source>
        <translation>Der Lauf braucht für die Blätter etwa %1 GB Speicher</translation>
    </message>
    <message>
        <source>The sheets need about %1 GB of memory, but this computer has %2 GB; choose a lower resolution or a smaller film</source>
        <translation>Die Blätter brauchen etwa %1 GB Speicher, aber dieser Rechner hat %2 GB; wählen Sie eine niedrigere Auflösung oder einen kleineren Film</translation>
    </message>
    <message>
        <source>The part does not meet the film; move it over the film or choose a larger film</source>
        <translation>Das Teil trifft den Film nicht; schieben Sie es über den Film oder wählen Sie einen größeren Film</translation>
    </message>
    <message>
        <source>The part is smaller than the film&apos;s cells; give the film smaller cells or more points, or check the model&apos;s unit</source>
        <translation>Das Teil ist kleiner als die Zellen des Films; geben Sie dem Film kleinere Zellen oder mehr Punkte, oder prüfen Sie die Einheit des Modells</translation>
    </message>
    <message>
        <source>%1: the film&apos;s cells are too coarse for this part; give the film smaller cells or more points</source>
        <translation>%1: Die Zellen des Films sind zu grob für dieses Teil; geben Sie dem Film kleinere Zellen oder mehr Punkte</translation>
    </message>
    <message>
        <source>Import of the model: %1</source>
        <translation>Import des Modells: %1</translation>
    </message>
    <message>
        <source>The model is not closed; Dipwright guesses what is inside</source>
        <translation>Das Modell ist nicht geschlossen; Dipwright schätzt, was innen ist</translation>
    </message>
    <message>
        <source>Writing the motion files</source>
        <translation>Bewegungsdateien werden geschrieben</translation>
    </message>
    <message>
        <source>Writing the coverage picture</source>
        <translation>Abdeckungsbild wird geschrieben</translation>
    </message>
    <message>
        <source>Simulating a deeper dip</source>
        <translation>Tieferer Tauchvorgang wird simuliert</translation>
    </message>
    <message>
        <source>%1: the film&apos;s cells were reduced to %2 mm.</source>
        <translation>%1: Die Zellen des Films wurden auf %2 mm verkleinert.</translation>
    </message>
    <message>
        <source>%1: cells of %2 mm might be small enough to print the sheet, but would need about %3 million points × steps; the project allows %4 million. Raise this limit (Film &gt; Work limit), or turn the part.</source>
        <translation>%1: Mit Zellen von %2 mm ließe sich das Blatt vielleicht drucken. Dafür wären etwa %3 Millionen Punkte × Schritte nötig; das Projekt erlaubt %4 Millionen. Erhöhen Sie diese Grenze (Film &gt; Grenze für den Aufwand), oder drehen Sie das Teil.</translation>
    </message>
    <message>
        <source>Film %1: %2 × %3 mm, pieces: %4, used area: %5 %</source>
        <translation>Film %1: %2 × %3 mm, Stücke: %4, genutzte Fläche: %5 %</translation>
    </message>
    <message>
        <source>Moving the results to their folder</source>
        <translation>Ergebnisse werden in ihren Ordner verschoben</translation>
    </message>
    <message>
        <source>The artwork has %1 spot colours, more than the limit of %2; remove some</source>
        <translation>Die Gestaltung hat %1 Sonderfarben, mehr als die höchstens %2; entfernen Sie einige</translation>
    </message>
    <message>
        <source>The simulation became unstable when this setting was varied; give the film smaller cells or more points</source>
        <translation>Die Simulation wurde instabil, als diese Einstellung verändert wurde; geben Sie dem Film kleinere Zellen oder mehr Punkte</translation>
    </message>
    <message>
        <source>Some places of the model are only %1 mm thick. The film may miss them, because the smallest possible cells of the distance field are %2 mm. Make these places thicker, or dip a smaller section of the model.</source>
        <translation>Einige Stellen des Modells sind nur %1 mm dick. Der Film kann sie verfehlen, weil die kleinstmöglichen Zellen des Abstandsfelds %2 mm groß sind. Machen Sie diese Stellen dicker oder tauchen Sie einen kleineren Abschnitt des Modells.</translation>
    </message>
    <message>
        <source>The model is inside out, at least in some places. Film does not adhere to faces that point inwards. Import the model again; the import turns these faces outwards.</source>
        <translation>Das Modell ist zumindest teilweise umgestülpt. Film haftet nicht auf Flächen, die nach innen zeigen. Importieren Sie das Modell neu; der Import wendet diese Flächen nach außen.</translation>
    </message>
    <message>
        <source>The check of the numerical error would need a film of %1 × %2 points, which is too many; halve the number of film points</source>
        <translation>Die Prüfung des numerischen Fehlers bräuchte einen Film von %1 × %2 Punkten; das sind zu viele. Halbieren Sie die Zahl der Filmpunkte</translation>
    </message>
    <message>
        <source>The CPU is used instead of %1, which is not available: %2</source>
        <translation>Die CPU wird verwendet, weil %1 nicht verfügbar ist: %2</translation>
    </message>
    <message>
        <source>%2 took over, because %1 failed: %3</source>
        <translation>%2 hat übernommen, weil %1 gescheitert ist: %3</translation>
    </message>
    <message>
        <source>The model has no texture; the colours of its materials are printed</source>
        <translation>Das Modell hat keine Textur; gedruckt werden die Farben seiner Materialien</translation>
    </message>
    <message>
        <source>The part reaches past the film&apos;s edge; move or turn the part, or %1</source>
        <translation>Das Teil ragt über den Rand des Films hinaus; verschieben oder drehen Sie das Teil, oder %1</translation>
    </message>
    <message>
        <source>Writing the stretch maps of %1</source>
        <translation>Dehnungskarten von %1 werden geschrieben</translation>
    </message>
    <message>
        <source>Writing the tolerance map of %1</source>
        <translation>Toleranzkarte von %1 wird geschrieben</translation>
    </message>
    <message>
        <source>there is too little memory</source>
        <translation>der Speicher reicht nicht</translation>
    </message>
    <message>
        <source>%1: the dip could not be repeated with smaller cells: %2</source>
        <translation>%1: Der Tauchvorgang konnte nicht mit kleineren Zellen wiederholt werden: %2</translation>
    </message>
    <message>
        <source>The film model of the paper allows only straight dips; choose the production film, or a straight path</source>
        <translation>Das Filmmodell der Veröffentlichung erlaubt nur gerade Tauchvorgänge; wählen Sie den Produktionsfilm oder einen geraden Weg</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>There is nothing to write</source>
        <translation>Es gibt nichts zu schreiben</translation>
    </message>
    <message>
        <source>The white ink and the cut contour are both named %1; rename one of them under Sheet, Spot colours</source>
        <translation>Weiß und Schneidkontur heißen beide %1; benennen Sie unter Blatt, Sonderfarben eine der beiden um</translation>
    </message>
    <message>
        <source>The layer&apos;s spot colour has the name of the sheet&apos;s white ink, %1; give the layer another spot colour, or rename the white ink under Sheet, Spot colours</source>
        <translation>Die Sonderfarbe der Ebene heißt wie das Weiß des Blatts, %1; geben Sie der Ebene eine andere Sonderfarbe, oder benennen Sie das Weiß unter Blatt, Sonderfarben um</translation>
    </message>
    <message>
        <source>The layer&apos;s spot colour has the name of the cut contour, %1; give the layer another spot colour, or rename the cut contour under Sheet, Spot colours</source>
        <translation>Die Sonderfarbe der Ebene heißt wie die Schneidkontur, %1; geben Sie der Ebene eine andere Sonderfarbe, oder benennen Sie die Schneidkontur unter Blatt, Sonderfarben um</translation>
    </message>
    <message>
        <source>The spot colours %1 and %2 differ only in capital letters; write both alike, or give the layer another spot colour</source>
        <translation>Die Sonderfarben %1 und %2 unterscheiden sich nur in der Groß- und Kleinschreibung; schreiben Sie beide gleich, oder geben Sie der Ebene eine andere Sonderfarbe</translation>
    </message>
    <message>
        <source>A zone, mask or layer names the face or material “%1”, which the model does not have; choose another name</source>
        <translation>Eine Zone, Maske oder Ebene nennt die Fläche oder das Material „%1“, die das Modell nicht hat; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>Writing the proof to share</source>
        <translation>Vorschau zum Weitergeben wird geschrieben</translation>
    </message>
    <message>
        <source>The dips were simulated on another computer by %1, which is not available here. Run the job here before you compute tolerances</source>
        <translation>Die Tauchvorgänge wurden auf einem anderen Computer mit %1 simuliert, das hier nicht verfügbar ist. Führen Sie den Auftrag hier aus, bevor Sie Toleranzen berechnen</translation>
    </message>
    <message>
        <source>The jobs differ in their ink settings or CMYK profiles, so that the films do not keep all amounts of ink of CMYK pictures or compensate each ink by itself; give all jobs the same ink settings and profiles</source>
        <translation>Die Aufträge haben verschiedene Tinteneinstellungen oder CMYK-Profile, sodass die Filme nicht alle Tintenmengen von CMYK-Bildern behalten oder nicht jede Tinte für sich ausgleichen; geben Sie allen Aufträgen dieselben Tinteneinstellungen und Profile</translation>
    </message>
    <message>
        <source>%1: the sheet can be printed, but its numerical error is above the wanted error. Cells of %2 mm might reach it, with about %3 million points × steps; the project allows %4 million (Film &gt; Work limit).</source>
        <translation>%1: Das Blatt kann gedruckt werden, aber sein numerischer Fehler ist größer als gewünscht. Zellen von %2 mm könnten den gewünschten Fehler erreichen, mit etwa %3 Millionen Punkten × Schritten; das Projekt erlaubt %4 Millionen (Film &gt; Grenze für den Aufwand).</translation>
    </message>
    <message>
        <source>Fins or pins of the model, %1 mm² in all, are at most %2 mm thick. The film may miss them, because the cells of the distance field are %3 mm. Increase the resolution of the distance field, or make these places thicker.</source>
        <translation>Finnen oder Stifte des Modells, zusammen %1 mm², sind höchstens %2 mm dick. Der Film kann sie verfehlen, weil die Zellen des Abstandsfelds %3 mm groß sind. Erhöhen Sie die Auflösung des Abstandsfelds, oder machen Sie diese Stellen dicker.</translation>
    </message>
    <message>
        <source>The film of this job swells, relaxes or grows differently from that of %1; pack only jobs for the same film together</source>
        <translation>Der Film dieses Auftrags quillt, erschlafft oder wächst anders als der von %1; packen Sie nur Aufträge für denselben Film zusammen</translation>
    </message>
    <message>
        <source>This job has another printer profile than %1; give both the same profile (on the command line, --profile gives it to all jobs)</source>
        <translation>Dieser Auftrag hat ein anderes Druckerprofil als %1; geben Sie beiden dasselbe Profil (auf der Befehlszeile gibt --profile es allen Aufträgen)</translation>
    </message>
    <message>
        <source>Masks that lie off the part: %1. Perhaps they were made for another model; draw them again</source>
        <translation>Masken, die neben dem Teil liegen: %1. Vielleicht gehören sie zu einem anderen Modell; zeichnen Sie sie neu</translation>
    </message>
    <message>
        <source>Zones that lie off the part: %1. Perhaps they were made for another model; mark them again</source>
        <translation>Zonen, die neben dem Teil liegen: %1. Vielleicht gehören sie zu einem anderen Modell; markieren Sie sie neu</translation>
    </message>
    <message>
        <source>Marks for the seam that lie off the part: %1. Perhaps they were made for another model; mark the seam again</source>
        <translation>Markierungen für die Naht, die neben dem Teil liegen: %1. Vielleicht gehören sie zu einem anderen Modell; markieren Sie die Naht neu</translation>
    </message>
</context>
<context>
    <name>PlainFile</name>
    <message>
        <source>it is a folder</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>it is a pipe or a device; save its data to a file and choose that file</source>
        <translation>es ist eine Pipe oder ein Gerät; speichern Sie die Daten in einer Datei und wählen Sie diese</translation>
    </message>
</context>
<context>
    <name>Png</name>
    <message>
        <source>The picture cannot be stored as PNG: %1</source>
        <translation>Das Bild kann nicht als PNG gespeichert werden: %1</translation>
    </message>
    <message>
        <source>The picture cannot be stored as PNG, because it is empty or too large for this computer&apos;s memory</source>
        <translation>Das Bild kann nicht als PNG gespeichert werden, weil es leer oder zu groß für den Speicher dieses Rechners ist</translation>
    </message>
</context>
<context>
    <name>PoseSearch</name>
    <message>
        <source>Trying poses</source>
        <translation>Lagen werden probiert</translation>
    </message>
    <message>
        <source>Choose a number from %1 to %2</source>
        <translation>Wählen Sie eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Größte Dehnung</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Eingeschlossene Luft</translation>
    </message>
    <message>
        <source>Film used</source>
        <translation>Film genutzt</translation>
    </message>
    <message>
        <source>weight of a zone</source>
        <translation>Gewicht einer Zone</translation>
    </message>
    <message>
        <source>Narrow overlap</source>
        <translation>Schmale Überlappung</translation>
    </message>
    <message>
        <source>The project has no model; import one first</source>
        <translation>Das Projekt hat kein Modell; importieren Sie zuerst eines</translation>
    </message>
    <message>
        <source>Rating directions by the part&apos;s shape</source>
        <translation>Richtungen werden nach der Form des Teils bewertet</translation>
    </message>
    <message>
        <source>Dip %1</source>
        <translation>Tauchvorgang %1</translation>
    </message>
    <message>
        <source>no difference</source>
        <translation>kein Unterschied</translation>
    </message>
    <message>
        <source>%1 (worse)</source>
        <translation>%1 (schlechter)</translation>
    </message>
    <message>
        <source>%1 (better)</source>
        <translation>%1 (besser)</translation>
    </message>
    <message>
        <source>There is no measure with this name; choose one of %1</source>
        <translation>Es gibt kein Maß mit diesem Namen; wählen Sie eines von %1</translation>
    </message>
    <message>
        <source>Film without faults</source>
        <translation>Film ohne Fehler</translation>
    </message>
    <message>
        <source>Wrinkled film</source>
        <translation>Film mit Falten</translation>
    </message>
    <message>
        <source>Torn film</source>
        <translation>Gerissener Film</translation>
    </message>
    <message>
        <source>Seam length</source>
        <translation>Nahtlänge</translation>
    </message>
    <message>
        <source>All weights are 0; set at least one weight above 0</source>
        <translation>Alle Gewichte sind 0; setzen Sie mindestens ein Gewicht über 0</translation>
    </message>
    <message>
        <source>This file holds a part of another search; create all files from the same project with the same options and solver</source>
        <translation>Diese Datei enthält einen Teil einer anderen Suche; erzeugen Sie alle Dateien aus demselben Projekt mit denselben Optionen und demselben Solver</translation>
    </message>
    <message>
        <source>search part %1 of %2</source>
        <translation>Teil %1 von %2 der Suche</translation>
    </message>
    <message>
        <source>Give each of the %1 result files of the divided search exactly once; you gave %2 files</source>
        <translation>Geben Sie jede der %1 Ergebnisdateien der aufgeteilten Suche genau einmal an; angegeben sind %2 Dateien</translation>
    </message>
    <message>
        <source>This file does not contain all dips of its part of the search; create it again</source>
        <translation>Diese Datei enthält nicht alle Tauchvorgänge ihres Teils der Suche; erzeugen Sie sie neu</translation>
    </message>
    <message>
        <source>None of the simulated poses paints the part; choose a larger film</source>
        <translation>Keine der simulierten Lagen bemalt das Teil; wählen Sie einen größeren Film</translation>
    </message>
    <message>
        <source>This file holds no part of a pose search, or it is damaged; create it again with --shard</source>
        <translation>Diese Datei enthält keinen Teil einer Lagensuche, oder sie ist beschädigt; erzeugen Sie sie mit --shard neu</translation>
    </message>
    <message>
        <source>Paths need the production film and a solver that follows them; choose another solver, or search without paths</source>
        <translation>Wege brauchen den Produktionsfilm und einen Solver, der ihnen folgt; wählen Sie einen anderen Solver, oder suchen Sie ohne Wege</translation>
    </message>
    <message>
        <source>Dip %1: %2</source>
        <translation>Tauchvorgang %1: %2</translation>
    </message>
    <message>
        <source>The whole part is masked; unmask the surface to be printed before you search for a pose</source>
        <translation>Das ganze Teil ist maskiert; nehmen Sie die Maske von der zu druckenden Oberfläche, bevor Sie eine Lage suchen</translation>
    </message>
    <message>
        <source>Dipping the best pose with smaller cells</source>
        <translation>Die beste Lage wird mit kleineren Zellen getaucht</translation>
    </message>
    <message>
        <source>This part of a pose search is from another version of the program; create it again with --shard</source>
        <translation>Dieser Teil einer Posensuche stammt von einer anderen Version des Programms; erzeugen Sie ihn mit --shard neu</translation>
    </message>
</context>
<context>
    <name>ProfileSpecs</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Held by a barrier</source>
        <translation>Von einer Barriere gehalten</translation>
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
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Ränder</translation>
    </message>
    <message>
        <source>L</source>
        <comment>left</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>T</source>
        <comment>top</comment>
        <translation>O</translation>
    </message>
    <message>
        <source>R</source>
        <comment>right</comment>
        <translation>R</translation>
    </message>
    <message>
        <source>B</source>
        <comment>bottom</comment>
        <translation>U</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Rendering intent</source>
        <translation>Rendering Intent</translation>
    </message>
    <message>
        <source>Perceptual</source>
        <translation>Perzeptiv</translation>
    </message>
    <message>
        <source>Relative colorimetric</source>
        <translation>Relativ farbmetrisch</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>Absolute colorimetric</source>
        <translation>Absolut farbmetrisch</translation>
    </message>
    <message>
        <source>Ink limit</source>
        <translation>Tintenlimit</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>W</source>
        <comment>width</comment>
        <translation>B</translation>
    </message>
    <message>
        <source>H</source>
        <comment>height</comment>
        <translation>H</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Einzug</translation>
    </message>
    <message>
        <source>Short edge first</source>
        <translation>Kurze Kante zuerst</translation>
    </message>
    <message>
        <source>Long edge first</source>
        <translation>Lange Kante zuerst</translation>
    </message>
    <message>
        <source>Lot</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>Behaviour on the water</source>
        <translation>Verhalten auf dem Wasser</translation>
    </message>
    <message>
        <source>Soak time</source>
        <translation>Einweichzeit</translation>
    </message>
    <message>
        <source>Activator time</source>
        <translation>Aktivatorzeit</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>L</source>
        <comment>length</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>Water level</source>
        <translation>Wasserstand</translation>
    </message>
    <message>
        <source>Barriers</source>
        <translation>Barrieren</translation>
    </message>
    <message>
        <source>Whether a barrier in the tank holds this side of the film.</source>
        <translation>Ob eine Barriere im Becken diese Seite des Films hält.</translation>
    </message>
    <message>
        <source>Flash time</source>
        <translation>Ablüftzeit</translation>
    </message>
    <message>
        <source>Not given</source>
        <translation>Nicht angegeben</translation>
    </message>
    <message>
        <source>Drying time</source>
        <translation>Trockenzeit</translation>
    </message>
    <message>
        <source>Measured on</source>
        <translation>Gemessen am</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>The name of the profile in lists and projects.</source>
        <translation>Der Name des Profils in Listen und Projekten.</translation>
    </message>
    <message>
        <source>System name</source>
        <translation>Name im System</translation>
    </message>
    <message>
        <source>The printer&apos;s name in the operating system. The print dialog selects this printer first.</source>
        <translation>Der Name des Druckers im Betriebssystem. Der Druckdialog wählt diesen Drucker zuerst.</translation>
    </message>
    <message>
        <source>Pixels per inch of the sheets for this printer.</source>
        <translation>Pixel je Zoll der Blätter für diesen Drucker.</translation>
    </message>
    <message>
        <source>How out-of-gamut colours are mapped to colours that the printer can print.</source>
        <translation>Wie Farben außerhalb des Farbumfangs auf druckbare Farben abgebildet werden.</translation>
    </message>
    <message>
        <source>Black point compensation</source>
        <translation>Tiefenkompensierung</translation>
    </message>
    <message>
        <source>The highest optical density per channel that the film holds.</source>
        <translation>Die höchste optische Dichte je Kanal, die der Film hält.</translation>
    </message>
    <message>
        <source>Total area coverage</source>
        <translation>Gesamtfarbauftrag</translation>
    </message>
    <message>
        <source>From the ICC profile</source>
        <translation>Aus dem ICC-Profil</translation>
    </message>
    <message>
        <source>Measured from photos</source>
        <translation>Auf Fotos gemessen</translation>
    </message>
    <message>
        <source>The date of the photos. The profile counts as measured as long as swell and growth have the values from the photos.</source>
        <translation>Das Datum der Fotos. Das Profil gilt als gemessen, solange Quellung und Wachstum die Werte aus den Fotos haben.</translation>
    </message>
    <message>
        <source>Water temperature, °C</source>
        <translation>Wassertemperatur, °C</translation>
    </message>
    <message>
        <source>The temperature of the water in the photos.</source>
        <translation>Die Temperatur des Wassers bei den Fotos.</translation>
    </message>
    <message>
        <source>Measured swell</source>
        <translation>Gemessene Quellung</translation>
    </message>
    <message>
        <source>Swell error</source>
        <translation>Fehler der Quellung</translation>
    </message>
    <message>
        <source>Measured growth</source>
        <translation>Gemessenes Wachstum</translation>
    </message>
    <message>
        <source>The growth measured from the photos.</source>
        <translation>Das auf den Fotos gemessene Wachstum.</translation>
    </message>
    <message>
        <source>The limit of the growth, measured from the photos.</source>
        <translation>Die auf den Fotos gemessene Grenze des Wachstums.</translation>
    </message>
    <message>
        <source>Measured relaxation</source>
        <translation>Gemessene Relaxation</translation>
    </message>
    <message>
        <source>The relaxation time measured from photos of a dipped part.</source>
        <translation>Die auf Fotos eines getauchten Teils gemessene Relaxationszeit.</translation>
    </message>
    <message>
        <source>The SHA-256 checksums of the photo files, to identify them.</source>
        <translation>Die SHA-256-Prüfsummen der Fotodateien, um sie wiederzuerkennen.</translation>
    </message>
    <message>
        <source>The edge that enters the printer first. Film swells more along its web.</source>
        <translation>Die Kante, die zuerst in den Drucker geht. Film quillt längs seiner Bahn stärker.</translation>
    </message>
    <message>
        <source>The manufacturer&apos;s lot number. Another lot may swell differently.</source>
        <translation>Die Chargennummer des Herstellers. Eine andere Charge quillt vielleicht anders.</translation>
    </message>
    <message>
        <source>A date such as 2027-03-31. May be empty.</source>
        <translation>Ein Datum wie 2027-03-31. Darf leer sein.</translation>
    </message>
    <message>
        <source>Time from the dip to the rinse.</source>
        <translation>Zeit vom Tauchvorgang bis zum Abspülen.</translation>
    </message>
    <message>
        <source>Time from the rinse until the part may be touched or dipped again.</source>
        <translation>Zeit vom Abspülen, bis das Teil angefasst oder wieder getaucht werden darf.</translation>
    </message>
    <message>
        <source>Distance from the tank&apos;s rim down to the water.</source>
        <translation>Abstand vom Beckenrand hinab zum Wasser.</translation>
    </message>
    <message>
        <source>Mark spacing</source>
        <translation>Abstand der Marken</translation>
    </message>
    <message>
        <source>The margins that the printer cannot reach at the left (L), top (T), right (R) and bottom (B) edge of the paper.</source>
        <translation>Die Ränder, die der Drucker an der linken (L), oberen (O), rechten (R) und unteren (U) Kante des Papiers nicht erreicht.</translation>
    </message>
    <message>
        <source>The swell measured from the photos, in width (W) and height (H). 0: not measured.</source>
        <translation>Die auf den Fotos gemessene Quellung, in Breite (B) und Höhe (H). 0: nicht gemessen.</translation>
    </message>
    <message>
        <source>Uncertainty of the measured swell (±, 95 % confidence), in width (W) and height (H).</source>
        <translation>Unsicherheit der gemessenen Quellung (±, 95 % Konfidenz), in Breite (B) und Höhe (H).</translation>
    </message>
    <message>
        <source>Width (W) and height (H) of the dry film.</source>
        <translation>Breite (B) und Höhe (H) des trockenen Films.</translation>
    </message>
    <message>
        <source>Advanced: material laws that are not measured</source>
        <translation>Erweitert: nicht gemessene Materialgesetze</translation>
    </message>
    <message>
        <source>Width (W) and length (L) of the water surface.</source>
        <translation>Breite (B) und Länge (L) der Wasserfläche.</translation>
    </message>
    <message>
        <source>Distance between the tank&apos;s marks, across (X) and along (Y) the tank. The sheet&apos;s registration marks are aligned with the tank&apos;s marks. 0: no marks.</source>
        <translation>Abstand der Marken des Beckens, quer (X) und längs (Y) zum Becken. Die Passmarken des Blatts werden an den Marken des Beckens ausgerichtet. 0: keine Marken.</translation>
    </message>
    <message>
        <source>Printed length divided by intended length, across the paper (X) and along its feed (Y). Sheets are divided by this factor, so that they print at true size. “Calibrate printer” measures the factor.</source>
        <translation>Gedruckte Länge geteilt durch gewünschte Länge, quer zum Papier (X) und längs seines Einzugs (Y). Blätter werden durch diesen Faktor geteilt, damit sie in wahrer Größe gedruckt werden. „Drucker kalibrieren“ misst den Faktor.</translation>
    </message>
    <message>
        <source>Maps the darkest colour of the image to the darkest colour that the printer can print, so that shadows stay distinct.</source>
        <translation>Bildet die dunkelste Farbe des Bildes auf die dunkelste Farbe ab, die der Drucker drucken kann, damit Schatten unterscheidbar bleiben.</translation>
    </message>
    <message>
        <source>The largest sum of the four inks at one place (TAC). Where the sum is larger, cyan, magenta and yellow are reduced; black stays. Used only with a CMYK ICC profile.</source>
        <translation>Die größte Summe der vier Farben an einer Stelle (TAC). Wo die Summe größer ist, werden Cyan, Magenta und Gelb verringert; Schwarz bleibt. Nur mit einem CMYK-ICC-Profil verwendet.</translation>
    </message>
    <message>
        <source>Measured growth limit</source>
        <translation>Gemessene Grenze des Wachstums</translation>
    </message>
    <message>
        <source>Average distance between the corners of the printed squares in the photos and their positions computed from these values.</source>
        <translation>Mittlerer Abstand zwischen den Ecken der gedruckten Quadrate auf den Fotos und ihren aus diesen Werten berechneten Positionen.</translation>
    </message>
    <message>
        <source>Use by</source>
        <translation>Haltbar bis</translation>
    </message>
    <message>
        <source>Time from laying the film on the water to spraying the activator.</source>
        <translation>Zeit vom Auflegen des Films auf das Wasser bis zum Aufsprühen des Aktivators.</translation>
    </message>
    <message>
        <source>Time from spraying the activator to the dip.</source>
        <translation>Zeit vom Aufsprühen des Aktivators bis zum Tauchvorgang.</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Water depth</source>
        <translation>Wassertiefe</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>How far the machine can move the centre of a part sideways from the middle of the tank.</source>
        <translation>Wie weit die Maschine die Mitte eines Teils von der Mitte des Beckens zur Seite bewegen kann.</translation>
    </message>
    <message>
        <source>Fastest motion</source>
        <translation>Schnellste Bewegung</translation>
    </message>
    <message>
        <source>The highest speed at which the machine moves a part.</source>
        <translation>Die höchste Geschwindigkeit, mit der die Maschine ein Teil bewegt.</translation>
    </message>
    <message>
        <source>Fastest turn</source>
        <translation>Schnellste Drehung</translation>
    </message>
    <message>
        <source>The highest speed at which the machine turns a part.</source>
        <translation>Die höchste Geschwindigkeit, mit der die Maschine ein Teil dreht.</translation>
    </message>
    <message>
        <source>Distance from the water surface to the tank&apos;s floor. The verdict on a dip that goes deeper is “Do not print”.</source>
        <translation>Abstand von der Wasseroberfläche zum Boden des Beckens. Das Urteil über einen tieferen Tauchvorgang ist „Nicht drucken“.</translation>
    </message>
    <message>
        <source>Cost of the ink</source>
        <translation>Kosten der Tinte</translation>
    </message>
    <message>
        <source>C</source>
        <comment>cyan</comment>
        <translation>C</translation>
    </message>
    <message>
        <source>M</source>
        <comment>magenta</comment>
        <translation>M</translation>
    </message>
    <message>
        <source>Y</source>
        <comment>yellow</comment>
        <translation>Y</translation>
    </message>
    <message>
        <source>K</source>
        <comment>black</comment>
        <translation>K</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Other</source>
        <comment>spot inks</comment>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Ink at full tint, ml/m²</source>
        <translation>Tinte bei vollem Ton, ml/m²</translation>
    </message>
    <message>
        <source>Millilitres of each ink on a square metre that is printed at full tint. Usual values are 5 to 20. 0: not given.</source>
        <translation>Milliliter jeder Tinte auf einem Quadratmeter, der mit vollem Ton gedruckt ist. Übliche Werte sind 5 bis 20. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Price of a litre</source>
        <translation>Preis eines Liters</translation>
    </message>
    <message>
        <source>Price of a litre of each ink, in the currency of the tank&apos;s profile. 0: not given.</source>
        <translation>Preis eines Liters jeder Tinte, in der Währung des Beckenprofils. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Spot ink at full tint, ml/m²</source>
        <translation>Sonderfarbe bei vollem Ton, ml/m²</translation>
    </message>
    <message>
        <source>The same for white and for every other spot ink. 0: not given.</source>
        <translation>Dasselbe für Weiß und für jede andere Sonderfarbe. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Price of a litre of spot ink</source>
        <translation>Preis eines Liters Sonderfarbe</translation>
    </message>
    <message>
        <source>The price of white and of every other spot ink. 0: not given.</source>
        <translation>Preis von Weiß und von jeder anderen Sonderfarbe. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Cost of the film</source>
        <translation>Kosten des Films</translation>
    </message>
    <message>
        <source>Price</source>
        <translation>Preis</translation>
    </message>
    <message>
        <source>Price of the film for the unit below, in the currency of the tank&apos;s profile.</source>
        <translation>Preis des Films für die Einheit darunter, in der Währung des Beckenprofils.</translation>
    </message>
    <message>
        <source>Price for</source>
        <translation>Preis für</translation>
    </message>
    <message>
        <source>What the price is for. A metre of roll is as wide as the film is cut.</source>
        <translation>Wofür der Preis gilt. Ein Meter Rolle ist so breit, wie der Film geschnitten wird.</translation>
    </message>
    <message>
        <source>A square metre</source>
        <translation>Einen Quadratmeter</translation>
    </message>
    <message>
        <source>A metre of roll</source>
        <translation>Einen Meter Rolle</translation>
    </message>
    <message>
        <source>A sheet</source>
        <translation>Ein Blatt</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Arbeit</translation>
    </message>
    <message>
        <source>Price of an hour</source>
        <translation>Preis einer Stunde</translation>
    </message>
    <message>
        <source>Price of an hour of work at the tank. Set-up, handling, soak, activator and dip count as work; flash and drying do not.</source>
        <translation>Preis einer Stunde Arbeit am Becken. Einrichten, Handhabung, Einweichen, Aktivator und Tauchen zählen als Arbeit; Ablüften und Trocknen nicht.</translation>
    </message>
    <message>
        <source>Set-up, minutes</source>
        <translation>Einrichten, Minuten</translation>
    </message>
    <message>
        <source>Minutes of work before the first dip of an order.</source>
        <translation>Minuten Arbeit vor dem ersten Tauchvorgang einer Bestellung.</translation>
    </message>
    <message>
        <source>Handling, minutes</source>
        <translation>Handhabung, Minuten</translation>
    </message>
    <message>
        <source>Minutes of work for each dip of a rack, in addition to the timed steps: laying the film, mounting, rinsing.</source>
        <translation>Minuten Arbeit für jeden Tauchvorgang eines Gestells, zusätzlich zu den Schritten mit fester Zeit: Film auflegen, einspannen, abspülen.</translation>
    </message>
    <message>
        <source>Parts per rack</source>
        <translation>Teile je Gestell</translation>
    </message>
    <message>
        <source>How many parts one dip with one sheet makes. More than 1 only if the model shows several parts on a jig.</source>
        <translation>Wie viele Teile ein Tauchvorgang mit einem Blatt ergibt. Mehr als 1 nur, wenn das Modell mehrere Teile auf einem Träger zeigt.</translation>
    </message>
    <message>
        <source>Scrap</source>
        <translation>Ausschuss</translation>
    </message>
    <message>
        <source>Share of the dipped racks that cannot be sold. Film, ink and work are counted for them, too. Usual values are 2 to 10 %.</source>
        <translation>Anteil der getauchten Gestelle, die nicht verkauft werden können. Film, Tinte und Arbeit werden auch für sie gezählt. Übliche Werte sind 2 bis 10 %.</translation>
    </message>
    <message>
        <source>Currency</source>
        <translation>Währung</translation>
    </message>
    <message>
        <source>The currency of all prices, for example EUR.</source>
        <translation>Die Währung aller Preise, zum Beispiel EUR.</translation>
    </message>
    <message>
        <source>PDF and TIFF files</source>
        <translation>PDF- und TIFF-Dateien</translation>
    </message>
    <message>
        <source>PDF for</source>
        <translation>PDF für</translation>
    </message>
    <message>
        <source>The RIP that reads the CMYK PDF. For Ghostscript, white and spot colours blend as transparency, which looks right on every screen, too. For the Adobe PDF Print Engine they overprint. For older RIPs they overprint in a PDF/X-1a file. Viewers that ignore overprint show white over the colours.</source>
        <translation>Der RIP, der das CMYK-PDF liest. Für Ghostscript werden Weiß und Sonderfarben als Transparenz überlagert, was auch auf jedem Bildschirm richtig aussieht. Für die Adobe PDF Print Engine überdrucken sie. Für ältere RIPs überdrucken sie in einer PDF/X-1a-Datei. Betrachter, die das Überdrucken nicht beachten, zeigen Weiß über den Farben.</translation>
    </message>
    <message>
        <source>Ghostscript, viewers</source>
        <translation>Ghostscript, Betrachter</translation>
    </message>
    <message>
        <source>Adobe PDF Print Engine</source>
        <translation>Adobe PDF Print Engine</translation>
    </message>
    <message>
        <source>Older RIPs</source>
        <translation>Ältere RIPs</translation>
    </message>
    <message>
        <source>Square pixels in TIFF</source>
        <translation>Quadratische Pixel im TIFF</translation>
    </message>
    <message>
        <source>Gives TIFF files one resolution. If the scales X and Y differ, the image is resampled, which softens it slightly. Without this, the file has two resolutions, which some RIPs ignore.</source>
        <translation>Gibt TIFF-Dateien eine einzige Auflösung. Sind die Maßstäbe X und Y verschieden, wird das Bild neu abgetastet und dadurch etwas weicher. Sonst hat die Datei zwei Auflösungen, die manche RIPs nicht beachten.</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Gap in a series</source>
        <translation>Abstand in einer Serie</translation>
    </message>
    <message>
        <source>Bare film between the sheets of a series, which is printed on the roll as one job, with cut marks and the number of each copy in the gap. Usual values are 5 to 20 mm. Without it, each sheet is a page of its own.</source>
        <translation>Freier Film zwischen den Blättern einer Serie, die in einem Auftrag auf die Rolle gedruckt wird, mit Schnittmarken und der Nummer jedes Exemplars im Abstand. Üblich sind 5 bis 20 mm. Ohne Abstand ist jedes Blatt eine eigene Seite.</translation>
    </message>
    <message>
        <source>Single pages</source>
        <translation>Einzelne Seiten</translation>
    </message>
    <message>
        <source>Width of the roll</source>
        <translation>Breite der Rolle</translation>
    </message>
    <message>
        <source>Width of the loaded roll, as far as it can be printed. Give it if the printer does not report its roll.</source>
        <translation>Breite der eingelegten Rolle, soweit sie bedruckt werden kann. Geben Sie sie an, wenn der Drucker seine Rolle nicht meldet.</translation>
    </message>
    <message>
        <source>As the printer reports</source>
        <translation>Wie der Drucker meldet</translation>
    </message>
    <message>
        <source>Pure inks</source>
        <translation>Reine Tinten</translation>
    </message>
    <message>
        <source>As the ICC profile mixes them</source>
        <translation>Wie das ICC-Profil sie mischt</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>What is printed in one ink alone instead of a mixture. “Black”: greys of RGB pictures, and black alone in CMYK pictures. “All”: cyan, magenta and yellow alone, too. Keeps text and lines sharp. CMYK pictures in the printer&apos;s own ICC profile always keep their amounts of ink, unless a device link from CMYK converts them.</source>
        <translation>Was in einer einzigen Tinte statt in einer Mischung gedruckt wird. „Schwarz“: Grautöne von RGB-Bildern und reines Schwarz in CMYK-Bildern. „Alle“: auch reines Cyan, Magenta und Gelb. Hält Text und Linien scharf. CMYK-Bilder im ICC-Profil des Druckers behalten immer ihre Tintenmengen, außer wenn ein Device-Link von CMYK sie umrechnet.</translation>
    </message>
</context>
<context>
    <name>Profiles</name>
    <message>
        <source>%1, lot %2,</source>
        <translation>%1, Charge %2,</translation>
    </message>
    <message>
        <source>This is not a Dipwright profile</source>
        <translation>Das ist kein Dipwright-Profil</translation>
    </message>
    <message>
        <source>A profile needs a name</source>
        <translation>Ein Profil braucht einen Namen</translation>
    </message>
    <message>
        <source>The profile cannot be removed</source>
        <translation>Das Profil kann nicht entfernt werden</translation>
    </message>
    <message>
        <source>This is not a Dipwright profile: %1</source>
        <translation>Das ist kein Dipwright-Profil: %1</translation>
    </message>
    <message>
        <source>The profile cannot be written: %1</source>
        <translation>Das Profil kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>The ICC profile is not valid base64 text; import it again</source>
        <translation>Das ICC-Profil ist kein gültiger Base64-Text; importieren Sie es neu</translation>
    </message>
    <message>
        <source>The profile has version %1 of the file format, but this program reads only up to version %2; open it with a newer Dipwright</source>
        <translation>Das Profil hat die Version %1 des Dateiformats, aber dieses Programm liest nur bis Version %2; öffnen Sie es mit einem neueren Dipwright</translation>
    </message>
    <message>
        <source>Another program is writing the profile (%1); try again</source>
        <translation>Ein anderes Programm schreibt das Profil gerade (%1); versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>A file of this name exists and is not a readable profile, so it is not replaced; repair it, move it, or choose another name: %1</source>
        <translation>Eine Datei dieses Namens ist vorhanden und nicht als Profil lesbar, deshalb wird sie nicht ersetzt; berichtigen oder verschieben Sie sie, oder wählen Sie einen anderen Namen: %1</translation>
    </message>
    <message>
        <source>Another program has changed the profile since it was read, so it is not saved; read it again and repeat your change</source>
        <translation>Ein anderes Programm hat das Profil geändert, seit es gelesen wurde, deshalb wird es nicht gespeichert; lesen Sie es neu und wiederholen Sie Ihre Änderung</translation>
    </message>
    <message>
        <source>The folder for profiles cannot be created; choose another with DIPWRIGHT_PROFILE_PATH</source>
        <translation>Der Ordner für Profile kann nicht angelegt werden; wählen Sie mit DIPWRIGHT_PROFILE_PATH einen anderen</translation>
    </message>
    <message>
        <source>There is no such kind of profile; use printer, film or tank</source>
        <translation>Diese Art Profil gibt es nicht; nehmen Sie printer, film oder tank</translation>
    </message>
    <message>
        <source>This profile has no value of this name; choose one of: %1</source>
        <translation>Dieses Profil hat keinen Wert dieses Namens; wählen Sie einen von: %1</translation>
    </message>
    <message>
        <source>There is no %1 profile of this name; choose one of: %2</source>
        <translation>Ein Profil für %1 mit diesem Namen gibt es nicht; wählen Sie eines von: %2</translation>
    </message>
    <message>
        <source>You have no %1 profile of this name; profiles that come with the program cannot be removed</source>
        <translation>Sie haben kein Profil für %1 mit diesem Namen; mitgelieferte Profile können nicht entfernt werden</translation>
    </message>
    <message>
        <source>The film %1 expired on %2; use a new lot, or test this lot first</source>
        <translation>Der Film %1 ist am %2 abgelaufen; nehmen Sie eine neue Charge oder testen Sie zuerst diese Charge</translation>
    </message>
    <message>
        <source>Several files hold a %1 profile of this name, and only the first is read: %2; remove all but one, or change the name in the others</source>
        <translation>Mehrere Dateien enthalten ein Profil (%1) dieses Namens, und nur die erste wird gelesen: %2; entfernen Sie alle bis auf eine, oder ändern Sie den Namen in den anderen</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>a text of at most %1 characters</source>
        <translation>ein Text von höchstens %1 Zeichen</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>“%1” must be an object</source>
        <translation>„%1“ muss ein Objekt sein</translation>
    </message>
    <message>
        <source>%1 must be an object</source>
        <translation>%1 muss ein Objekt sein</translation>
    </message>
    <message>
        <source>profiles.%1 holds a profile of another kind</source>
        <translation>profiles.%1 enthält ein Profil anderer Art</translation>
    </message>
    <message>
        <source>This is not a Dipwright project</source>
        <translation>Das ist kein Dipwright-Projekt</translation>
    </message>
    <message>
        <source>%1 must be an array of at most %2 entries</source>
        <translation>%1 muss eine Liste mit höchstens %2 Einträgen sein</translation>
    </message>
    <message>
        <source>a colour such as #1a2b3c</source>
        <translation>eine Farbe wie #1a2b3c</translation>
    </message>
    <message>
        <source>A value is missing; expected %1</source>
        <translation>Hier fehlt ein Wert; erwartet wird %1</translation>
    </message>
    <message>
        <source>%1 is not allowed here; expected %2</source>
        <translation>%1 ist hier nicht erlaubt; erwartet wird %2</translation>
    </message>
    <message>
        <source>There is no film size of this name; use one of %1</source>
        <translation>Ein Filmformat dieses Namens gibt es nicht; nehmen Sie eines von %1</translation>
    </message>
    <message>
        <source>immersions must be an array with one or two entries</source>
        <translation>immersions muss eine Liste mit einem oder zwei Einträgen sein</translation>
    </message>
    <message>
        <source>The project has version %1 of the file format, but this program reads only up to version %2; open it with a newer Dipwright</source>
        <translation>Das Projekt hat die Version %1 des Dateiformats, aber dieses Programm liest nur bis Version %2; öffnen Sie es mit einem neueren Dipwright</translation>
    </message>
    <message>
        <source>There is no such setting; %1</source>
        <translation>Diese Einstellung gibt es nicht; %1</translation>
    </message>
    <message>
        <source>There is no preset %1; use production or paper-2020</source>
        <translation>Die Vorgabe %1 gibt es nicht; nehmen Sie production oder paper-2020</translation>
    </message>
    <message>
        <source>There is no such layer; the number of layers is %1, and the lowest is artwork.layers[0]</source>
        <translation>Diese Ebene gibt es nicht; die Zahl der Ebenen ist %1, und die unterste ist artwork.layers[0]</translation>
    </message>
    <message>
        <source>There is no such dip; the number of dips is %1, and the first is immersions[0]</source>
        <translation>Diesen Tauchvorgang gibt es nicht; die Zahl der Tauchvorgänge ist %1, und der erste ist immersions[0]</translation>
    </message>
    <message>
        <source>inspection.pairs names a photo that is not in inspection.photos</source>
        <translation>inspection.pairs nennt ein Foto, das nicht in inspection.photos steht</translation>
    </message>
    <message>
        <source>%1 × %2 points are too many; a film may have up to %3 million points</source>
        <translation>%1 × %2 Punkte sind zu viele; ein Film darf bis zu %3 Millionen Punkte haben</translation>
    </message>
    <message>
        <source>A spot colour needs its own name; All, None and the names of the four process inks are reserved</source>
        <translation>Eine Sonderfarbe braucht einen eigenen Namen; All, None und die Namen der vier Prozessfarben sind vergeben</translation>
    </message>
    <message>
        <source>“%1” is not a colour; write it as #1a2b3c</source>
        <translation>„%1“ ist keine Farbe; schreiben Sie sie als #1a2b3c</translation>
    </message>
    <message>
        <source>%1 is not allowed here; expected %2 values, each of them %3</source>
        <translation>%1 ist hier nicht erlaubt; erwartet werden %2 Werte, jeder davon %3</translation>
    </message>
    <message>
        <source>the settings in this section are %1</source>
        <translation>die Einstellungen dieses Abschnitts sind %1</translation>
    </message>
    <message>
        <source>%1 is not allowed here; expected a list of at most %2 entries</source>
        <translation>%1 ist hier nicht erlaubt; erwartet wird eine Liste mit höchstens %2 Einträgen</translation>
    </message>
    <message>
        <source>In the poses of a path only the depth may be null; it then is the depth of the dip</source>
        <translation>In den Lagen eines Wegs darf nur die Tiefe null sein; sie ist dann die Tiefe des Tauchvorgangs</translation>
    </message>
    <message>
        <source>In the poses of a path, times are at most %1 s, lengths %2 mm and turns %3°</source>
        <translation>In den Lagen eines Wegs sind Zeiten höchstens %1 s, Längen höchstens %2 mm und Drehungen höchstens %3°</translation>
    </message>
    <message>
        <source>The brush strokes in %1 have %2 points; at most %3 are possible</source>
        <translation>Die Pinselstriche in %1 haben %2 Punkte; höchstens %3 sind möglich</translation>
    </message>
    <message>
        <source>The value must be a list in JSON, as in the project file</source>
        <translation>Der Wert muss eine Liste in JSON sein, wie in der Projektdatei</translation>
    </message>
    <message>
        <source>The normals of a brush stroke have parts from −1 to 1</source>
        <translation>Die Normalen eines Pinselstrichs haben Komponenten von −1 bis 1</translation>
    </message>
    <message>
        <source>There is no such value; write its path as in the project file</source>
        <translation>Einen solchen Wert gibt es nicht; schreiben Sie seinen Pfad wie in der Projektdatei</translation>
    </message>
    <message>
        <source>as_built.places names a part that is not in as_built.parts</source>
        <translation>as_built.places nennt ein Teil, das nicht in as_built.parts steht</translation>
    </message>
    <message>
        <source>A layer has no such setting; its settings are %1</source>
        <translation>Eine Ebene hat keine solche Einstellung; ihre Einstellungen sind %1</translation>
    </message>
    <message>
        <source>An empty value</source>
        <translation>Ein leerer Wert</translation>
    </message>
    <message>
        <source>%1 is not a date; write year, month and day, for example 2027-03-31</source>
        <translation>%1 ist kein Datum; schreiben Sie Jahr, Monat und Tag, zum Beispiel 2027-03-31</translation>
    </message>
    <message>
        <source>a path begins with one of %1</source>
        <translation>ein Pfad beginnt mit einem dieser Wörter: %1</translation>
    </message>
    <message>
        <source>An entry has no such key; its keys are %1</source>
        <translation>Ein Eintrag hat keinen solchen Schlüssel; seine Schlüssel sind %1</translation>
    </message>
</context>
<context>
    <name>ProjectDifferences</name>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>Marks for zones</source>
        <translation>Marken für Zonen</translation>
    </message>
    <message>
        <source>Pose search · weight of %1</source>
        <translation>Lagensuche · Gewicht von %1</translation>
    </message>
    <message>
        <source>Pose search · limit of %1</source>
        <translation>Lagensuche · Grenze von %1</translation>
    </message>
    <message>
        <source>Pose search · weight of zone %1</source>
        <translation>Lagensuche · Gewicht der Zone %1</translation>
    </message>
    <message>
        <source>Artwork · base colour</source>
        <translation>Gestaltung · Grundfarbe</translation>
    </message>
    <message>
        <source>Artwork · layer %1</source>
        <translation>Gestaltung · Ebene %1</translation>
    </message>
    <message>
        <source>%1, %2 × %3%7 at (%4; %5; %6)%7, turned by %8°</source>
        <translation>%1, %2 × %3%7 bei (%4; %5; %6)%7, um %8° gedreht</translation>
    </message>
    <message>
        <source>%1, with other settings</source>
        <translation>%1, mit anderen Einstellungen</translation>
    </message>
    <message>
        <source>Dips</source>
        <translation>Tauchvorgänge</translation>
    </message>
    <message>
        <source>Marks for the seam</source>
        <translation>Marken für die Naht</translation>
    </message>
    <message>
        <source>Printer profile</source>
        <translation>Druckerprofil</translation>
    </message>
    <message>
        <source>Film profile</source>
        <translation>Filmprofil</translation>
    </message>
    <message>
        <source>Tank profile</source>
        <translation>Beckenprofil</translation>
    </message>
    <message>
        <source>Marks for masks</source>
        <translation>Markierungen für Masken</translation>
    </message>
    <message>
        <source>%1 others</source>
        <translation>%1 andere</translation>
    </message>
</context>
<context>
    <name>ProjectFile</name>
    <message>
        <source>The project is open elsewhere (%1); close it there, or work on a copy</source>
        <translation>Das Projekt ist anderswo geöffnet (%1); schließen Sie es dort, oder arbeiten Sie an einer Kopie</translation>
    </message>
    <message>
        <source>The existing file cannot be read, so it is not replaced; try again, or save under another name</source>
        <translation>Die vorhandene Datei kann nicht gelesen werden, deshalb wird sie nicht ersetzt; versuchen Sie es noch einmal, oder speichern Sie unter einem anderen Namen</translation>
    </message>
    <message>
        <source>Another program has changed the project since it was read, so it is not saved; open it again and repeat your change</source>
        <translation>Ein anderes Programm hat das Projekt geändert, seit es gelesen wurde, deshalb wird es nicht gespeichert; öffnen Sie es neu und wiederholen Sie Ihre Änderung</translation>
    </message>
</context>
<context>
    <name>ProjectStore</name>
    <message>
        <source>project.json is damaged at character %1: %2</source>
        <translation>project.json ist bei Zeichen %1 beschädigt: %2</translation>
    </message>
    <message>
        <source>The project cannot be saved: %1</source>
        <translation>Das Projekt kann nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>The project was not saved, because its file would be refused when opened: %1</source>
        <translation>Das Projekt wurde nicht gespeichert, weil seine Datei beim Öffnen abgelehnt würde: %1</translation>
    </message>
    <message>
        <source>This is not a Dipwright project: it has no project.json</source>
        <translation>Das ist kein Dipwright-Projekt: Es hat keine project.json</translation>
    </message>
    <message>
        <source>project.json contains a list instead of a project</source>
        <translation>project.json enthält eine Liste statt eines Projekts</translation>
    </message>
    <message>
        <source>The project names no model: model.mesh is missing</source>
        <translation>Das Projekt nennt kein Modell: model.mesh fehlt</translation>
    </message>
    <message>
        <source>The model in the project was changed after saving: its sha256 differs</source>
        <translation>Das Modell im Projekt wurde nach dem Speichern geändert: Sein sha256 weicht ab</translation>
    </message>
    <message>
        <source>The project lists %1 textures, but its model needs %2</source>
        <translation>Das Projekt nennt %1 Texturen, aber sein Modell braucht %2</translation>
    </message>
    <message>
        <source>Saving the project</source>
        <translation>Das Projekt wird gespeichert</translation>
    </message>
    <message>
        <source>project.json holds the key %1 twice; remove one of them</source>
        <translation>project.json enthält den Schlüssel %1 zweimal; entfernen Sie einen davon</translation>
    </message>
</context>
<context>
    <name>ProjectValue</name>
    <message>
        <source>There is no such setting</source>
        <translation>Diese Einstellung gibt es nicht</translation>
    </message>
</context>
<context>
    <name>Proof</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>Bedruckt</translation>
    </message>
    <message>
        <source>The part as it is expected to come out</source>
        <translation>Das Teil, wie es voraussichtlich herauskommt</translation>
    </message>
    <message>
        <source>After dip 1</source>
        <translation>Nach Tauchvorgang 1</translation>
    </message>
    <message>
        <source>The part after %1</source>
        <translation>Das Teil nach %1</translation>
    </message>
    <message>
        <source>Artwork</source>
        <translation>Motiv</translation>
    </message>
    <message>
        <source>The picture that was asked for</source>
        <translation>Das gewünschte Bild</translation>
    </message>
    <message>
        <source>bare</source>
        <translation>blank</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mehr</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>How many times longer the film becomes on the part</source>
        <translation>Wievielmal länger der Film auf dem Teil wird</translation>
    </message>
    <message>
        <source>Numerical error</source>
        <translation>Numerischer Fehler</translation>
    </message>
    <message>
        <source>How far the picture may be off by computing, in mm. Limit: %1 mm</source>
        <translation>Wie weit das Bild durch die Rechnung daneben liegen kann, in mm. Grenze: %1 mm</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>How far handling may move the picture, ± mm</source>
        <translation>Wie weit die Handhabung das Bild verschieben kann, ± mm</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Dips</source>
        <translation>Tauchvorgänge</translation>
    </message>
    <message>
        <source>Painted by all dips together</source>
        <translation>Von allen Tauchvorgängen zusammen bedeckt</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Length of the seam</source>
        <translation>Länge der Naht</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Dip %1: %2</source>
        <translation>Tauchvorgang %1: %2</translation>
    </message>
    <message>
        <source>Painted</source>
        <translation>Bedeckt</translation>
    </message>
    <message>
        <source>Stretch: mean, 95 % below, largest</source>
        <translation>Dehnung: Mittel, 95 % darunter, größte</translation>
    </message>
    <message>
        <source>Numerical error, 95 % within</source>
        <translation>Numerischer Fehler, 95 % innerhalb von</translation>
    </message>
    <message>
        <source>Read-back error, 95 % within</source>
        <translation>Rücklesefehler, 95 % innerhalb von</translation>
    </message>
    <message>
        <source>Tolerance of handling, 95 % within ±</source>
        <translation>Toleranz der Handhabung, 95 % innerhalb von ±</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Eingeschlossene Luft</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>%1 × %2 mm, job %3</source>
        <translation>%1 × %2 mm, Auftrag %3</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>Urteil: %1</translation>
    </message>
    <message>
        <source>The surface shown here is within %1 mm of the part.</source>
        <translation>Die gezeigte Oberfläche liegt höchstens %1 mm neben dem Teil.</translation>
    </message>
    <message>
        <source>The surface shown here has all triangles of the part.</source>
        <translation>Die gezeigte Oberfläche hat alle Dreiecke des Teils.</translation>
    </message>
    <message>
        <source>Screens show colours differently; the print decides.</source>
        <translation>Bildschirme zeigen Farben verschieden; es gilt der Druck.</translation>
    </message>
    <message>
        <source>Making the proof to share</source>
        <translation>Vorschau zum Weitergeben wird erzeugt</translation>
    </message>
    <message>
        <source>This program was built without three.js, which shows the proof in a browser. Build it with the package libjs-three installed, or share proof.png</source>
        <translation>Dieses Programm wurde ohne three.js gebaut, das die Vorschau im Browser zeigt. Bauen Sie es mit dem Paket libjs-three, oder geben Sie proof.png weiter</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Auftrag %1</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>The part. Arrow keys turn it, plus and minus zoom, 0 resets</source>
        <translation>Das Teil. Pfeiltasten drehen es, Plus und Minus zoomen, 0 setzt zurück</translation>
    </message>
    <message>
        <source>Drag to turn. Wheel or two fingers zoom and move. Arrow keys turn, + and − zoom.</source>
        <translation>Ziehen dreht. Mausrad oder zwei Finger zoomen und verschieben. Pfeiltasten drehen, + und − zoomen.</translation>
    </message>
    <message>
        <source>This browser cannot draw in 3D (WebGL). The picture shows the part from six sides.</source>
        <translation>Dieser Browser kann nicht in 3D zeichnen (WebGL). Das Bild zeigt das Teil von sechs Seiten.</translation>
    </message>
    <message>
        <source>The part from six sides</source>
        <translation>Das Teil von sechs Seiten</translation>
    </message>
    <message>
        <source>Sheets, ink side up</source>
        <translation>Blätter, Farbseite oben</translation>
    </message>
    <message>
        <source>Made by %1. The viewer is three.js.</source>
        <translation>Erzeugt mit %1. Die Darstellung macht three.js.</translation>
    </message>
    <message>
        <source>Licence of the viewer</source>
        <translation>Lizenz der Darstellung</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>nicht verglichen</translation>
    </message>
    <message>
        <source>Masked, not painted</source>
        <translation>Maskiert, nicht bemalt</translation>
    </message>
</context>
<context>
    <name>PropertySpecs</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Distance field</source>
        <translation>Abstandsfeld</translation>
    </message>
    <message>
        <source>Samples per edge</source>
        <translation>Stützstellen je Kante</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Printed film</source>
        <translation>Gedruckter Film</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigenes</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>W</source>
        <comment>width</comment>
        <translation>B</translation>
    </message>
    <message>
        <source>H</source>
        <comment>height</comment>
        <translation>H</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Behaviour on the water</source>
        <translation>Verhalten auf dem Wasser</translation>
    </message>
    <message>
        <source>Swell</source>
        <translation>Quellung</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxation</translation>
    </message>
    <message>
        <source>Film model</source>
        <translation>Filmmodell</translation>
    </message>
    <message>
        <source>Isotropic</source>
        <translation>Isotrop</translation>
    </message>
    <message>
        <source>Structural lattice</source>
        <translation>Strukturelles Gitter</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Auflage</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>Self-contact</source>
        <translation>Selbstkontakt</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source>Bleed</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>Registration marks</source>
        <translation>Passmarken</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Lineal</translation>
    </message>
    <message>
        <source>Job line</source>
        <translation>Auftragszeile</translation>
    </message>
    <message>
        <source>Compensate stretch</source>
        <translation>Dehnung ausgleichen</translation>
    </message>
    <message>
        <source>Ink limit</source>
        <translation>Tintenlimit</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Anzahl der Punkte</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Registration error</source>
        <translation>Passerfehler</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Halterung</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Spiel</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Polster</translation>
    </message>
    <message>
        <source>Pin clearance</source>
        <translation>Spiel der Stifte</translation>
    </message>
    <message>
        <source>Bore</source>
        <translation>Bohrung</translation>
    </message>
    <message>
        <source>Engraving</source>
        <translation>Gravur</translation>
    </message>
    <message>
        <source>Water level</source>
        <translation>Wasserstand</translation>
    </message>
    <message>
        <source>Dips</source>
        <translation>Tauchvorgänge</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Korrektur</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Dipping</source>
        <translation>Tauchen</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>Along the film&apos;s edge</source>
        <translation>Am Rand des Films</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Printed last, under the colour</source>
        <translation>Zuletzt gedruckt, unter der Farbe</translation>
    </message>
    <message>
        <source>Printed first, over the colour</source>
        <translation>Zuerst gedruckt, über der Farbe</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Choke</source>
        <translation>Unterfüllung</translation>
    </message>
    <message>
        <source>Print it</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Check first</source>
        <translation>Zuerst prüfen</translation>
    </message>
    <message>
        <source>Do not print</source>
        <translation>Nicht drucken</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Eingeschlossene Luft</translation>
    </message>
    <message>
        <source>Too pale</source>
        <translation>Zu blass</translation>
    </message>
    <message>
        <source>Torn or released film</source>
        <translation>Gerissener oder abgelöster Film</translation>
    </message>
    <message>
        <source>Reached by neither dip</source>
        <translation>Von keinem Tauchvorgang erreicht</translation>
    </message>
    <message>
        <source>Narrow overlap</source>
        <translation>Schmale Überlappung</translation>
    </message>
    <message>
        <source>Repaired model</source>
        <translation>Berichtigtes Modell</translation>
    </message>
    <message>
        <source>Film not measured</source>
        <translation>Film nicht gemessen</translation>
    </message>
    <message>
        <source>Expected deviations (±)</source>
        <translation>Erwartete Abweichungen (±)</translation>
    </message>
    <message>
        <source>The name of the project. It is printed in the job line of every sheet.</source>
        <translation>Der Name des Projekts. Er wird in der Auftragszeile jedes Blatts gedruckt.</translation>
    </message>
    <message>
        <source>The date in the job line. It is stored in the project, so that the same project always gives the same sheet.</source>
        <translation>Das Datum in der Auftragszeile. Es ist im Projekt gespeichert, damit dasselbe Projekt immer dasselbe Blatt ergibt.</translation>
    </message>
    <message>
        <source>Number of samples along each edge of the distance field around the part. More samples follow finer detail and take longer to compute.</source>
        <translation>Anzahl der Abtastpunkte je Kante des Abstandsfelds um das Teil. Mehr Punkte folgen feineren Einzelheiten und brauchen länger.</translation>
    </message>
    <message>
        <source>The size of the film as it is delivered and printed.</source>
        <translation>Die Größe, in der der Film geliefert und bedruckt wird.</translation>
    </message>
    <message>
        <source>How fine the simulated film is. “Automatic” chooses the cell size from the part&apos;s narrow features and its pose: fine where the part enters the film, coarse towards the film&apos;s edges.</source>
        <translation>Wie fein der simulierte Film ist. „Automatisch“ wählt die Zellgröße nach den schmalen Stellen des Teils und seiner Lage: fein, wo das Teil in den Film eintaucht, grob zu den Rändern des Films hin.</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Zellgröße</translation>
    </message>
    <message>
        <source>Side length of the simulated film&apos;s cells where the part enters the film. Smaller cells show finer detail and take longer.</source>
        <translation>Seitenlänge der Zellen des simulierten Films, wo das Teil in den Film eintaucht. Kleinere Zellen zeigen feinere Einzelheiten und brauchen länger.</translation>
    </message>
    <message>
        <source>Gap between the cradle and the part that lies in it.</source>
        <translation>Abstand zwischen der Halterung und dem Teil, das in ihr liegt.</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Wandstärke</translation>
    </message>
    <message>
        <source>The smallest thickness of the walls that hold the part.</source>
        <translation>Die kleinste Dicke der Wände, die das Teil halten.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>How far below the top of the part the cradle reaches. It reaches deeper where the part would tip or slide.</source>
        <translation>Wie weit unter das obere Ende des Teils die Halterung reicht. Sie reicht tiefer, wo das Teil kippen oder rutschen würde.</translation>
    </message>
    <message>
        <source>Distance to the film</source>
        <translation>Abstand zum Film</translation>
    </message>
    <message>
        <source>Space for felt or foam where the cradle rests on paint.</source>
        <translation>Raum für Filz oder Schaum, wo die Halterung auf Farbe liegt.</translation>
    </message>
    <message>
        <source>Plate thickness</source>
        <translation>Plattendicke</translation>
    </message>
    <message>
        <source>Thickness of the plate that the cradle hangs from.</source>
        <translation>Dicke der Platte, an der die Halterung hängt.</translation>
    </message>
    <message>
        <source>Height above the water</source>
        <translation>Höhe über dem Wasser</translation>
    </message>
    <message>
        <source>Height of the plate above the water at the end of the dip.</source>
        <translation>Höhe der Platte über dem Wasser am Ende des Tauchvorgangs.</translation>
    </message>
    <message>
        <source>Pin spacing</source>
        <translation>Abstand der Stifte</translation>
    </message>
    <message>
        <source>Largest distance between two datum pins. The pins stand where the sheet&apos;s marks float, or closer to the film&apos;s centre.</source>
        <translation>Größter Abstand zweier Passstifte. Die Stifte stehen, wo die Marken des Blatts schwimmen, oder näher an der Mitte des Films.</translation>
    </message>
    <message>
        <source>Pin diameter</source>
        <translation>Durchmesser der Stifte</translation>
    </message>
    <message>
        <source>Diameter of the datum pins on the tank&apos;s frame.</source>
        <translation>Der Durchmesser der Passstifte am Rahmen des Beckens.</translation>
    </message>
    <message>
        <source>Gap between a pin and its hole, all round.</source>
        <translation>Spalt zwischen Stift und Loch, ringsum.</translation>
    </message>
    <message>
        <source>Diameter of a hole through the cradle and its plate, for holding the part with a screw, suction or hot glue. 0: no hole.</source>
        <translation>Durchmesser eines Lochs durch die Halterung und ihre Platte, um das Teil mit Schraube, Unterdruck oder Heißkleber zu halten. 0: kein Loch.</translation>
    </message>
    <message>
        <source>Depth of the engraved arrow, dip number and job number in the plate. 0: no engraving.</source>
        <translation>Tiefe, in der Pfeil, Nummer des Tauchvorgangs und Auftragsnummer in die Platte graviert werden. 0: keine Gravur.</translation>
    </message>
    <message>
        <source>Side length of the cells on which the cradle is computed. Smaller cells give a smoother surface, take longer and make larger files.</source>
        <translation>Seitenlänge der Zellen, auf denen die Halterung berechnet wird. Kleinere Zellen geben eine glattere Oberfläche, brauchen länger und machen größere Dateien.</translation>
    </message>
    <message>
        <source>How far the lowest point of the part goes below the waterline. “Whole part” dips until the part is fully under water.</source>
        <translation>Wie weit der tiefste Punkt des Teils unter die Wasserlinie kommt. „Ganzes Teil“ taucht, bis das Teil ganz unter Wasser ist.</translation>
    </message>
    <message>
        <source>Whole part</source>
        <translation>Ganzes Teil</translation>
    </message>
    <message>
        <source>How much farther the part moves down once it is fully under water.</source>
        <translation>Wie viel weiter das Teil sinkt, wenn es ganz unter Wasser ist.</translation>
    </message>
    <message>
        <source>The simulated time of one step.</source>
        <translation>Die simulierte Zeit eines Schritts.</translation>
    </message>
    <message>
        <source>Number of sweeps over all constraints in one step.</source>
        <translation>Anzahl der Durchläufe über alle Zwangsbedingungen in einem Schritt.</translation>
    </message>
    <message>
        <source>Sweep method</source>
        <translation>Art der Durchläufe</translation>
    </message>
    <message>
        <source>Jacobi corrects all points at once and averages the corrections. Gauss–Seidel corrects one point after the other.</source>
        <translation>Jacobi korrigiert alle Punkte zugleich und mittelt die Korrekturen. Gauß–Seidel korrigiert einen Punkt nach dem anderen.</translation>
    </message>
    <message>
        <source>The name of this dip. It is printed in the job line of its sheet.</source>
        <translation>Der Name dieses Tauchvorgangs. Er wird in der Auftragszeile seines Blatts gedruckt.</translation>
    </message>
    <message>
        <source>Split the part between the dips</source>
        <translation>Das Teil auf die Tauchvorgänge aufteilen</translation>
    </message>
    <message>
        <source>Each dip paints the areas where it gives the better result and leaves the others blank. If off, both dips paint everything they reach, and some areas are painted twice.</source>
        <translation>Jeder Tauchvorgang bemalt die Flächen, auf denen er das bessere Ergebnis gibt, und lässt die anderen frei. Wenn ausgeschaltet, bemalen beide alles, was sie erreichen, und manche Flächen werden doppelt bemalt.</translation>
    </message>
    <message>
        <source>How far the second dip may be displaced from the first. The overlap is made wide enough that no edge shows.</source>
        <translation>Wie weit der zweite Tauchvorgang gegen den ersten verschoben sein darf. Die Überlappung wird so breit, dass keine Kante zu sehen ist.</translation>
    </message>
    <message>
        <source>Stretch limit</source>
        <translation>Grenze der Dehnung</translation>
    </message>
    <message>
        <source>Where the film of one dip stretches beyond this factor, the other dip paints if it can.</source>
        <translation>Wo sich der Film eines Tauchvorgangs über diesen Faktor hinaus dehnt, bemalt der andere Tauchvorgang das Teil, wenn er kann.</translation>
    </message>
    <message>
        <source>Turns the page on its side.</source>
        <translation>Legt die Seite quer.</translation>
    </message>
    <message>
        <source>Pixels per inch of the film image.</source>
        <translation>Bildpunkte je Zoll des Filmbilds.</translation>
    </message>
    <message>
        <source>How far the colour continues beyond the painted area, so that a small position error leaves no bare edge.</source>
        <translation>Wie weit die Farbe über die bemalte Fläche hinausreicht, damit ein kleiner Lagefehler keinen unbemalten Rand lässt.</translation>
    </message>
    <message>
        <source>Marks in the corners, for aligning the film in the tank.</source>
        <translation>Marken in den Ecken, um den Film im Becken auszurichten.</translation>
    </message>
    <message>
        <source>A ruler of 100 mm. Measure it to check that the page was printed at true size.</source>
        <translation>Ein Lineal von 100 mm. Messen Sie nach, ob die Seite in wahrer Größe gedruckt wurde.</translation>
    </message>
    <message>
        <source>A line with project, dip, date, film, scale and a checksum.</source>
        <translation>Eine Zeile mit Projekt, Tauchvorgang, Datum, Film, Maßstab und Prüfsumme.</translation>
    </message>
    <message>
        <source>Part colour</source>
        <translation>Farbe des Teils</translation>
    </message>
    <message>
        <source>How far the edge of the white stays inside the edge of the colour, on the film.</source>
        <translation>Wie weit der Rand des Weiß innerhalb des Rands der Farbe bleibt, auf dem Film.</translation>
    </message>
    <message>
        <source>Name of the white ink</source>
        <translation>Name der weißen Farbe</translation>
    </message>
    <message>
        <source>The name of the white ink in the printer.</source>
        <translation>Der Name der weißen Farbe im Drucker.</translation>
    </message>
    <message>
        <source>Cut contour</source>
        <translation>Schneidkontur</translation>
    </message>
    <message>
        <source>Around the ink</source>
        <translation>Um die Farbe herum</translation>
    </message>
    <message>
        <source>Distance from the ink to the cut contour.</source>
        <translation>Abstand der Schneidkontur von der Farbe.</translation>
    </message>
    <message>
        <source>Bleed at the contour</source>
        <translation>Beschnitt an der Kontur</translation>
    </message>
    <message>
        <source>How far the colours continue beyond the cut contour, so that a misplaced cut shows no bare film.</source>
        <translation>Wie weit die Farben über die Schneidkontur hinausreichen, damit ein verrutschter Schnitt keinen leeren Film zeigt.</translation>
    </message>
    <message>
        <source>Contour name</source>
        <translation>Name der Kontur</translation>
    </message>
    <message>
        <source>The name of the spot colour that the cutter follows.</source>
        <translation>Der Name der Sonderfarbe, der der Schneideplotter folgt.</translation>
    </message>
    <message>
        <source>Correct repeating errors</source>
        <translation>Wiederkehrende Fehler korrigieren</translation>
    </message>
    <message>
        <source>How much of the repeating error is corrected.</source>
        <translation>Wie viel des wiederkehrenden Fehlers korrigiert wird.</translation>
    </message>
    <message>
        <source>Spot colours</source>
        <translation>Sonderfarben</translation>
    </message>
    <message>
        <source>Ink thins where the film stretches. This prints more ink there, so that the part shows the colour of the texture.</source>
        <translation>Farbe wird dünner, wo sich der Film dehnt. Hiermit wird dort mehr Farbe gedruckt, damit das Teil die Farbe der Textur zeigt.</translation>
    </message>
    <message>
        <source>The highest optical density that can be printed. Where more is needed, the colour is too pale; the report gives the area.</source>
        <translation>Die höchste optische Dichte, die gedruckt werden kann. Wo mehr nötig ist, wird die Farbe zu blass; der Bericht nennt die Fläche.</translation>
    </message>
    <message>
        <source>Part position</source>
        <translation>Ort des Teils</translation>
    </message>
    <message>
        <source>Part rotation</source>
        <translation>Drehung des Teils</translation>
    </message>
    <message>
        <source>How far the part may be rotated from its pose, about axes through its centre.</source>
        <translation>Wie weit das Teil gegen seine Lage verdreht sein darf, um Achsen durch seine Mitte.</translation>
    </message>
    <message>
        <source>Film position</source>
        <translation>Ort des Films</translation>
    </message>
    <message>
        <source>How far the film may be from its intended place when the part meets it.</source>
        <translation>Wie weit der Film von seinem vorgesehenen Ort entfernt sein darf, wenn das Teil ihn trifft.</translation>
    </message>
    <message>
        <source>Film rotation</source>
        <translation>Drehung des Films</translation>
    </message>
    <message>
        <source>How far the film may be rotated on the water, about its centre.</source>
        <translation>Wie weit der Film auf dem Wasser verdreht sein darf, um seine Mitte.</translation>
    </message>
    <message>
        <source>How much longer or shorter than assumed the floating film may be, as a share of its length.</source>
        <translation>Wie viel länger oder kürzer als angenommen der schwimmende Film sein darf, als Anteil seiner Länge.</translation>
    </message>
    <message>
        <source>The share of the part&apos;s surface that trapped air may keep dry. Above five times any of these limits, the verdict is “do not print”.</source>
        <translation>Der Anteil der Oberfläche des Teils, den eingeschlossene Luft trocken halten darf. Über dem Fünffachen einer dieser Grenzen lautet das Urteil „Nicht drucken“.</translation>
    </message>
    <message>
        <source>The share of the painted area that may be too pale because the film stretches more than the ink can compensate.</source>
        <translation>Der Anteil der bemalten Fläche, der zu blass sein darf, weil sich der Film mehr dehnt, als die Farbe ausgleichen kann.</translation>
    </message>
    <message>
        <source>The share of the painted area where the film may tear or be released from the part.</source>
        <translation>Der Anteil der bemalten Fläche, auf dem der Film reißen oder sich vom Teil lösen darf.</translation>
    </message>
    <message>
        <source>The share of the part&apos;s surface that both dips may leave unreached. A job with one dip has no such limit.</source>
        <translation>Der Anteil der Oberfläche des Teils, den beide Tauchvorgänge auslassen dürfen. Ein Auftrag mit einem Tauchvorgang hat keine solche Grenze.</translation>
    </message>
    <message>
        <source>The share of the overlap that may be too narrow for the registration error of the second film.</source>
        <translation>Der Anteil der Überlappung, der für den Passerfehler des zweiten Films zu schmal sein darf.</translation>
    </message>
    <message>
        <source>The share of a marked zone A or B that may stay unpainted.</source>
        <translation>Der Anteil einer markierten Zone A oder B, der ohne Farbe bleiben darf.</translation>
    </message>
    <message>
        <source>The verdict for a model of one plain colour without artwork.</source>
        <translation>Das Urteil für ein einfarbiges Modell ohne Gestaltung.</translation>
    </message>
    <message>
        <source>The verdict for a film whose swell was not measured.</source>
        <translation>Das Urteil für einen Film, dessen Quellung nicht gemessen wurde.</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>Zonen</translation>
    </message>
    <message>
        <source>How far (±) colours may land from their intended places. Surface that is not marked is zone C.</source>
        <translation>Wie weit (±) Farben von ihrem vorgesehenen Ort entfernt landen dürfen. Nicht markierte Oberfläche ist Zone C.</translation>
    </message>
    <message>
        <source>Number of simulated dips with all deviations at once. They check whether the separate effects add up. 0: no check.</source>
        <translation>Anzahl simulierter Tauchvorgänge mit allen Abweichungen zugleich. Sie prüfen, ob sich die einzelnen Wirkungen addieren. 0: keine Prüfung.</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Width (W) and height (H) of the printed film. The cells of the simulated film keep their size.</source>
        <translation>Breite (B) und Höhe (H) des bedruckten Films. Die Zellen des simulierten Films behalten ihre Größe.</translation>
    </message>
    <message>
        <source>Number of points of the simulated film, across (W) and down (H). More points show finer detail and take longer.</source>
        <translation>Anzahl der Punkte des simulierten Films, quer (B) und längs (H). Mehr Punkte zeigen feinere Einzelheiten und brauchen länger.</translation>
    </message>
    <message>
        <source>Advanced: material laws that are not measured</source>
        <translation>Erweitert: nicht gemessene Materialgesetze</translation>
    </message>
    <message>
        <source>Width (W) and height (H) of the page.</source>
        <translation>Breite (B) und Höhe (H) der Seite.</translation>
    </message>
    <message>
        <source>How far the part may be from its intended place when it meets the film. 95 of 100 dips are within this distance.</source>
        <translation>Wie weit das Teil von seinem Sollort entfernt sein darf, wenn es den Film trifft. 95 von 100 Tauchvorgängen liegen innerhalb dieses Abstands.</translation>
    </message>
    <message>
        <source>How much faster or slower the dip may be, as a share of the set speed.</source>
        <translation>Wie viel schneller oder langsamer der Tauchvorgang sein darf, als Anteil der eingestellten Geschwindigkeit.</translation>
    </message>
    <message>
        <source>How much longer or shorter the film&apos;s relaxation time may be, as a share of the relaxation time.</source>
        <translation>Wie viel länger oder kürzer die Relaxationszeit des Films sein darf, als Anteil der Relaxationszeit.</translation>
    </message>
    <message>
        <source>The smallest allowed distance between film that paints and the film&apos;s edge. Nearer to the edge, film may curl or fold.</source>
        <translation>Der kleinste erlaubte Abstand zwischen bemalendem Film und dem Rand des Films. Näher am Rand kann sich der Film rollen oder falten.</translation>
    </message>
    <message>
        <source>Check with simulated dips</source>
        <translation>Prüfung mit simulierten Tauchvorgängen</translation>
    </message>
    <message>
        <source>Width, on the part, of the band along the seam that both dips paint. The dips fade into each other there. The band is wider where the registration error would show.</source>
        <translation>Breite, auf dem Teil gemessen, des Streifens längs der Naht, den beide Tauchvorgänge bemalen. Die Tauchvorgänge gehen dort ineinander über. Der Streifen ist breiter, wo der Passerfehler sichtbar würde.</translation>
    </message>
    <message>
        <source>Contact with paint</source>
        <translation>Kontakt mit Farbe</translation>
    </message>
    <message>
        <source>Whether the cradle may support the part on areas that earlier dips have painted, with padding in between.</source>
        <translation>Ob die Halterung das Teil auf Flächen stützen darf, die frühere Tauchvorgänge bemalt haben, mit Polster dazwischen.</translation>
    </message>
    <message>
        <source>Work limit</source>
        <translation>Grenze für den Aufwand</translation>
    </message>
    <message>
        <source>Isotropic film resists shear; the result does not depend on the direction of the grid. The structural lattice connects each point only with its horizontal and vertical neighbours, as in the publication of 2020.</source>
        <translation>Isotroper Film widersteht Scherung; das Ergebnis hängt nicht von der Richtung des Gitters ab. Das strukturelle Gitter verbindet jeden Punkt nur mit seinen waagerechten und senkrechten Nachbarn, wie in der Veröffentlichung von 2020.</translation>
    </message>
    <message>
        <source>Water: the water supports the floating film. None: nothing supports the film.</source>
        <translation>Wasser: Das Wasser trägt den schwimmenden Film. Keine: Nichts trägt den Film.</translation>
    </message>
    <message>
        <source>Smallest distance from the cradle to any place that the film reaches or that earlier dips have painted.</source>
        <translation>Kleinster Abstand der Halterung zu allen Stellen, die der Film erreicht oder die frühere Tauchvorgänge bemalt haben.</translation>
    </message>
    <message>
        <source>Extra depth</source>
        <translation>Zusätzliche Tiefe</translation>
    </message>
    <message>
        <source>Prevents the film from passing through itself.</source>
        <translation>Verhindert, dass der Film durch sich selbst dringt.</translation>
    </message>
    <message>
        <source>The page that the film image is placed on. “Same as the film” prints the film itself, edge to edge.</source>
        <translation>Die Seite, auf die das Filmbild gelegt wird. „Wie der Film“ druckt den Film selbst, von Rand zu Rand.</translation>
    </message>
    <message>
        <source>Same as the film</source>
        <translation>Wie der Film</translation>
    </message>
    <message>
        <source>Marks and text</source>
        <translation>Marken und Text</translation>
    </message>
    <message>
        <source>Colour of the bare part, such as #1a2b3c. Proof and view show the ink on this colour. If empty, they show a light grey part, with the ink in the colours that it has on white.</source>
        <translation>Farbe des unbemalten Teils, zum Beispiel #1a2b3c. Vorschau und Ansicht zeigen die Druckfarbe darauf. Wenn leer, zeigen sie ein hellgraues Teil und darauf die Druckfarbe so, wie sie auf Weiß aussieht.</translation>
    </message>
    <message>
        <source>A plate of white ink. White that is printed last touches the part, under the colours. White that is printed first lies outside, over the colours. Only in CMYK files (PDF and TIFF).</source>
        <translation>Eine Platte mit weißer Farbe. Zuletzt gedrucktes Weiß berührt das Teil, unter den Farben. Zuerst gedrucktes Weiß liegt außen, über den Farben. Nur in CMYK-Dateien (PDF und TIFF).</translation>
    </message>
    <message>
        <source>How dense the white is on the finished part; 100 % is solid white. Where the film stretches, more white is printed, up to 100 %.</source>
        <translation>Wie dicht das Weiß auf dem fertigen Teil ist; 100 % ist Vollton. Wo sich der Film dehnt, wird mehr Weiß gedruckt, bis zu 100 %.</translation>
    </message>
    <message>
        <source>The line that the cutter follows, as a spot colour in a CMYK PDF.</source>
        <translation>Die Linie, der der Schneideplotter folgt, als Sonderfarbe in einem CMYK-PDF.</translation>
    </message>
    <message>
        <source>Shifts the image on the sheet so that it cancels the error that repeats on the measured parts.</source>
        <translation>Verschiebt das Bild auf dem Blatt so, dass es den Fehler ausgleicht, der sich an den gemessenen Teilen wiederholt.</translation>
    </message>
    <message>
        <source>How much higher or lower than intended the water may stand. The part is then dipped deeper or less deep.</source>
        <translation>Wie viel höher oder tiefer als vorgesehen das Wasser stehen darf. Das Teil wird dann tiefer oder weniger tief getaucht.</translation>
    </message>
    <message>
        <source>Limits beyond which the verdict is “check first”</source>
        <translation>Grenzen, ab denen das Urteil „zuerst prüfen“ lautet</translation>
    </message>
    <message>
        <source>Unpainted in a zone</source>
        <translation>Unbemalt in einer Zone</translation>
    </message>
    <message>
        <source>Distance to film&apos;s edge</source>
        <translation>Abstand zum Filmrand</translation>
    </message>
    <message>
        <source>No texture or artwork</source>
        <translation>Weder Textur noch Gestaltung</translation>
    </message>
    <message>
        <source>Start value of the random deviations in the simulated dips. Another value gives other deviations.</source>
        <translation>Startwert der zufälligen Abweichungen in den simulierten Tauchvorgängen. Ein anderer Wert ergibt andere Abweichungen.</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Straight down</source>
        <translation>Gerade nach unten</translation>
    </message>
    <message>
        <source>Slanted</source>
        <translation>Schräg</translation>
    </message>
    <message>
        <source>Tilt in and level</source>
        <translation>Kippen und waagerecht stellen</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Level at</source>
        <translation>Waagerecht bei</translation>
    </message>
    <message>
        <source>The end of the dip</source>
        <translation>Ende des Tauchvorgangs</translation>
    </message>
    <message>
        <source>Rolling radius</source>
        <translation>Rollradius</translation>
    </message>
    <message>
        <source>How far the part travels sideways while it rolls through one radian (57.3°). Half the part&apos;s height lets a cylinder roll without slip.</source>
        <translation>Wie weit das Teil zur Seite fährt, während es um einen Radianten (57,3°) rollt. Mit der halben Höhe des Teils rollt ein Zylinder ohne Schlupf.</translation>
    </message>
    <message>
        <source>Half the part&apos;s height</source>
        <translation>Halbe Höhe des Teils</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung beim Absenken</translation>
    </message>
    <message>
        <source>Turn about the vertical while the part goes down, counterclockwise seen from above.</source>
        <translation>Drehung um die Senkrechte beim Absenken, von oben gesehen gegen den Uhrzeigersinn.</translation>
    </message>
    <message>
        <source>Water speed</source>
        <translation>Fließgeschwindigkeit</translation>
    </message>
    <message>
        <source>Slow speed</source>
        <translation>Langsame Geschwindigkeit</translation>
    </message>
    <message>
        <source>The direction on the water in which the part travels or rolls, or the side that enters first. 0°: to the right (X), 90°: down the sheet (Z). The water flows in this direction, too.</source>
        <translation>Die Richtung auf dem Wasser, in die das Teil fährt oder rollt, oder die Seite, die zuerst eintaucht. 0°: nach rechts (X), 90°: zum unteren Rand des Blatts (Z). Auch das Wasser fließt in diese Richtung.</translation>
    </message>
    <message>
        <source>Slow distance</source>
        <translation>Langsame Strecke</translation>
    </message>
    <message>
        <source>The slow speed applies to the first and the last part of the way down. This is the length of each part.</source>
        <translation>Die langsame Geschwindigkeit gilt für das erste und das letzte Stück des Wegs nach unten. Dies ist die Länge jedes dieser Stücke.</translation>
    </message>
    <message>
        <source>Film expired</source>
        <translation>Film abgelaufen</translation>
    </message>
    <message>
        <source>The verdict for a film whose profile gives an expiry date in the past.</source>
        <translation>Das Urteil für einen Film, dessen Profil ein vergangenes Ablaufdatum nennt.</translation>
    </message>
    <message>
        <source>Gauss–Seidel</source>
        <translation>Gauß–Seidel</translation>
    </message>
    <message>
        <source>Same as the dip</source>
        <translation>Wie beim Tauchen</translation>
    </message>
    <message>
        <source>Rotation of the part about X, then Y, then Z. If the part tilts, rolls or turns on its path: its rotation at the end of the dip. You can also drag the rings in the view; hold Shift for steps of 15°.</source>
        <translation>Drehung des Teils um X, dann Y, dann Z. Wenn das Teil auf seinem Weg kippt, rollt oder sich dreht: seine Drehung am Ende des Tauchvorgangs. Sie können auch die Ringe in der Ansicht ziehen; mit Umschalt in Schritten von 15°.</translation>
    </message>
    <message>
        <source>How fast the part moves down into the water. On a slanted path the machine moves faster, because the part also travels sideways.</source>
        <translation>Wie schnell sich das Teil ins Wasser senkt. Auf einem schrägen Weg fährt die Maschine schneller, weil sich das Teil auch zur Seite bewegt.</translation>
    </message>
    <message>
        <source>Slanted: the angle between the path and the water, 10° to 170°. Tilt: how far the part is tilted when the dip begins, at most 85°. Roll: the angle through which it rolls. Slanted above 90°, or a negative tilt or roll, is against the heading.</source>
        <translation>Schräg: der Winkel zwischen Weg und Wasser, 10° bis 170°. Kippen: wie weit das Teil am Anfang gekippt ist, höchstens 85°. Rollen: der Winkel, um den es rollt. Schräg über 90° sowie negatives Kippen oder Rollen gehen gegen die Richtung.</translation>
    </message>
    <message>
        <source>Speed at which water and film flow through the tank, in the direction of the heading. A negative speed flows against the heading.</source>
        <translation>Geschwindigkeit, mit der Wasser und Film durch das Becken fließen, in der angegebenen Richtung. Eine negative Geschwindigkeit fließt gegen die Richtung.</translation>
    </message>
    <message>
        <source>Speed on the first and the last part of the way down. If the part then rolls, it rolls at the speed of the dip.</source>
        <translation>Geschwindigkeit auf dem ersten und dem letzten Teil des Wegs nach unten. Rollt das Teil danach, rollt es mit der Tauchgeschwindigkeit.</translation>
    </message>
    <message>
        <source>Where the centre of the part is when the dip begins, measured from the film&apos;s centre: X to the right, Z down the sheet.</source>
        <translation>Wo die Mitte des Teils am Anfang des Tauchvorgangs ist, gemessen von der Mitte des Films: X nach rechts, Z auf dem Blatt nach unten.</translation>
    </message>
    <message>
        <source>Depth of the part&apos;s lowest point at which the part is no longer tilted.</source>
        <translation>Tiefe des tiefsten Punkts, in der das Teil nicht mehr gekippt ist.</translation>
    </message>
    <message>
        <source>Path angle</source>
        <translation>Winkel des Wegs</translation>
    </message>
    <message>
        <source>How far the angle of a slanted, tilted or rolling dip may be from its set value. Has no effect on other dips.</source>
        <translation>Wie weit der Winkel eines schrägen, gekippten oder rollenden Tauchvorgangs vom eingestellten Wert abweichen darf. Auf andere Tauchvorgänge wirkt er nicht.</translation>
    </message>
    <message>
        <source>Start of the dip</source>
        <translation>Beginn des Tauchvorgangs</translation>
    </message>
    <message>
        <source>How much earlier or later than intended the dip may begin. Has an effect only if the water flows or the film grows.</source>
        <translation>Wie viel früher oder später als vorgesehen der Tauchvorgang beginnen darf. Wirkt nur, wenn das Wasser fließt oder der Film wächst.</translation>
    </message>
    <message>
        <source>How the part moves into the water. Slanted: down and sideways. Tilt: one side enters first, and the part is levelled while it goes down. Roll: down to the depth of the dip, then rolled sideways over the film; set a depth (Dipping &gt; Depth) at which the part is not yet under water. Poses: through poses that you set; at first they follow the present path. The rotation above is the part&apos;s rotation at the end of the dip.</source>
        <translation>Wie sich das Teil ins Wasser bewegt. Schräg: nach unten und zur Seite. Kippen: Eine Seite taucht zuerst ein, und das Teil wird beim Absenken waagerecht gestellt. Rollen: nach unten bis zur Tiefe des Tauchvorgangs, dann seitwärts über den Film gerollt; stellen Sie eine Tiefe ein (Tauchen &gt; Tiefe), in der das Teil noch nicht unter Wasser ist. Lagen: durch Lagen, die Sie einstellen; zuerst folgen sie dem jetzigen Weg. Die Drehung oben ist die Drehung des Teils am Ende des Tauchvorgangs.</translation>
    </message>
    <message>
        <source>Through poses</source>
        <translation>Durch Lagen</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>The acceleration with which the part reaches its speed on the path and stops. The dip takes longer than without a limit.</source>
        <translation>Die Beschleunigung, mit der das Teil auf dem Weg seine Geschwindigkeit erreicht und anhält. Der Tauchvorgang dauert länger als ohne Grenze.</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Keine Grenze</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Bestellung</translation>
    </message>
    <message>
        <source>Parts to make</source>
        <translation>Zu fertigende Teile</translation>
    </message>
    <message>
        <source>The number of good parts that are ordered. Report, queue and traveller give the cost and the time of the order. Sheets do not depend on it.</source>
        <translation>Zahl der guten Teile, die bestellt sind. Bericht, Warteschlange und Laufkarte geben Kosten und Zeit der Bestellung an. Blätter hängen nicht davon ab.</translation>
    </message>
    <message>
        <source>If the numerical error is too large to print a sheet, its dip is repeated with smaller cells. This limits the work of one dip: the number of film points times the number of steps, in millions. 100 takes about 20 s on two cores. 0: the dip is not repeated.</source>
        <translation>Ist der numerische Fehler zu groß, um ein Blatt zu drucken, wird der Tauchvorgang mit kleineren Zellen wiederholt. Dieser Wert begrenzt den Aufwand eines Tauchvorgangs: Zahl der Filmpunkte mal Zahl der Schritte, in Millionen. 100 dauern auf zwei Kernen etwa 20 s. 0: Der Tauchvorgang wird nicht wiederholt.</translation>
    </message>
    <message>
        <source>Densest colour</source>
        <translation>Dichteste Farbe</translation>
    </message>
    <message>
        <source>Passes of ink</source>
        <translation>Durchgänge der Tinte</translation>
    </message>
    <message>
        <source>How many times the printer prints each sheet onto the same film. Two passes reach twice the ink limit. The film must not move between the passes, and takes longer to dry. Usual: 1.</source>
        <translation>Wie oft der Drucker jedes Blatt auf denselben Film druckt. Zwei Durchgänge erreichen das doppelte Tintenlimit. Der Film darf sich zwischen den Durchgängen nicht bewegen und trocknet länger. Üblich: 1.</translation>
    </message>
    <message>
        <source>A tone curve lightens the darkest colours of the texture to this density and keeps them apart, so that the ink suffices on stretched film. Usual: 0.8 to 1.8. At 10 the texture stays as it is. The amounts of ink of CMYK pictures do not change.</source>
        <translation>Eine Gradationskurve hellt die dunkelsten Farben der Textur bis zu dieser Dichte auf und hält sie auseinander, damit die Tinte auf gedehntem Film reicht. Üblich: 0,8 bis 1,8. Bei 10 bleibt die Textur, wie sie ist. Die Tintenmengen von CMYK-Bildern ändern sich nicht.</translation>
    </message>
    <message>
        <source>Wanted error</source>
        <translation>Gewünschter Fehler</translation>
    </message>
    <message>
        <source>The dip is repeated with smaller cells until the numerical error is at most this on 95 % of the painted area, or until the work limit is reached. “Printable”: only until the sheet can be printed.</source>
        <translation>Der Tauchvorgang wird mit kleineren Zellen wiederholt, bis der numerische Fehler auf 95 % der bemalten Fläche höchstens so groß ist oder die Grenze für den Aufwand erreicht ist. „Druckbar“: nur, bis das Blatt gedruckt werden kann.</translation>
    </message>
    <message>
        <source>Printable</source>
        <translation>Druckbar</translation>
    </message>
    <message>
        <source>How far the contact line moves in one step, in cells of the film. For a more exact sheet, smaller cells are better than steps below 0.5.</source>
        <translation>Wie weit sich die Kontaktlinie in einem Schritt bewegt, in Zellen des Films. Für ein genaueres Blatt sind kleinere Zellen besser als Schritte unter 0,5.</translation>
    </message>
    <message>
        <source>Least painted area</source>
        <translation>Kleinste bemalte Fläche</translation>
    </message>
    <message>
        <source>The share of the part&apos;s surface that the only dip of a job should paint.</source>
        <translation>Der Anteil der Oberfläche des Teils, den der einzige Tauchvorgang eines Auftrags bemalen soll.</translation>
    </message>
    <message>
        <source>The verdict for a model that was repaired.</source>
        <translation>Das Urteil für ein Modell, das berichtigt wurde.</translation>
    </message>
    <message>
        <source>Incomplete model</source>
        <translation>Unvollständiges Modell</translation>
    </message>
    <message>
        <source>The verdict for a model of which the import left something out, such as a missing texture or a texture transform.</source>
        <translation>Das Urteil für ein Modell, von dem beim Import etwas weggelassen wurde, zum Beispiel eine fehlende Textur oder eine Texturtransformation.</translation>
    </message>
</context>
<context>
    <name>ReportPanel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Area stretch, smallest and largest</source>
        <translation>Flächendehnung, kleinste und größte</translation>
    </message>
    <message>
        <source>Film triangles across texture seams</source>
        <translation>Filmdreiecke über Texturnähten</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Width of the overlap</source>
        <translation>Breite der Überlappung</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Painted by %1 only</source>
        <translation>Nur von %1 bemalt</translation>
    </message>
    <message>
        <source>Overlap, painted by both</source>
        <translation>Überlappung, von beiden bemalt</translation>
    </message>
    <message>
        <source>Reached by neither dip</source>
        <translation>Von keinem Tauchvorgang erreicht</translation>
    </message>
    <message>
        <source>Overlap too narrow for a registration error of %1</source>
        <translation>Überlappung, zu schmal für einen Passerfehler von %1</translation>
    </message>
    <message>
        <source>Length of the seam</source>
        <translation>Länge der Naht</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Film points on the part</source>
        <translation>Filmpunkte auf dem Teil</translation>
    </message>
    <message>
        <source>Read-back error, mean and 95 %</source>
        <translation>Rücklesefehler, Mittel und 95 %</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Eingeschlossene Luft</translation>
    </message>
    <message>
        <source>Steps that did not converge</source>
        <translation>Nicht konvergierte Schritte</translation>
    </message>
    <message>
        <source>Use this film</source>
        <translation>Diesen Film verwenden</translation>
    </message>
    <message>
        <source>Area not reached, at %1</source>
        <translation>Nicht erreichte Fläche, bei %1</translation>
    </message>
    <message>
        <source>Number of smaller areas not reached</source>
        <translation>Anzahl kleinerer nicht erreichter Flächen</translation>
    </message>
    <message>
        <source>Area painted by film that tore, was released or did not converge</source>
        <translation>Fläche, bemalt von Film, der riss, sich löste oder nicht konvergierte</translation>
    </message>
    <message>
        <source>Area too pale because of the ink limit</source>
        <translation>Wegen des Tintenlimits zu blasse Fläche</translation>
    </message>
    <message>
        <source>Simulation time</source>
        <translation>Dauer der Simulation</translation>
    </message>
    <message>
        <source>Most of the film stays empty. A film of format %1 (%2 × %3) is large enough.</source>
        <translation>Der größte Teil des Films bleibt leer. Ein Film im Format %1 (%2 × %3) ist groß genug.</translation>
    </message>
    <message>
        <source>Smallest film cell</source>
        <translation>Kleinste Filmzelle</translation>
    </message>
    <message>
        <source>%1 on the model</source>
        <translation>%1 am Modell</translation>
    </message>
    <message>
        <source>Stretch: mean, 99 % below, largest</source>
        <translation>Dehnung: Mittel, 99 % darunter, größte</translation>
    </message>
    <message>
        <source>Place of the largest stretch</source>
        <translation>Ort der größten Dehnung</translation>
    </message>
    <message>
        <source>Warnings on the part</source>
        <translation>Warnungen auf dem Teil</translation>
    </message>
    <message>
        <source>Cost and time</source>
        <translation>Kosten und Zeit</translation>
    </message>
    <message>
        <source>One part</source>
        <translation>Ein Teil</translation>
    </message>
    <message>
        <source>Order of %1 parts</source>
        <translation>Bestellung über %1 Teile</translation>
    </message>
    <message>
        <source>Sheets to print</source>
        <translation>Zu druckende Blätter</translation>
    </message>
    <message>
        <source>The amounts of ink are estimated, because the project has no printer profile with an ICC profile in CMYK.</source>
        <translation>Die Tintenmengen sind geschätzt, weil das Projekt kein Druckerprofil mit einem ICC-Profil in CMYK hat.</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern …</translation>
    </message>
    <message>
        <source>Edit prices…</source>
        <translation>Preise bearbeiten …</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Geplant</translation>
    </message>
    <message>
        <source>Took, mean of all runs</source>
        <translation>Gedauert, Mittel aller Durchgänge</translation>
    </message>
    <message>
        <source>Dip %1: %2</source>
        <translation>Tauchvorgang %1: %2</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>At the tank</source>
        <translation>Am Becken</translation>
    </message>
    <message>
        <source>Too pale: needs more ink than the limit</source>
        <translation>Zu blass: braucht mehr Tinte, als die Grenze erlaubt</translation>
    </message>
    <message>
        <source>Too pale</source>
        <translation>Zu blass</translation>
    </message>
    <message>
        <source>Missing, 95 %</source>
        <translation>Fehlt, 95 %</translation>
    </message>
    <message>
        <source>Missing, most</source>
        <translation>Fehlt, größte</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Colour error ΔE</source>
        <translation>Farbfehler ΔE</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Where ink does not suffice</source>
        <translation>Wo die Tinte nicht reicht</translation>
    </message>
    <message>
        <source>A click on an option changes the project; it can be undone. Too pale: share of the painted surface. Missing: optical density where ink is short now (95 %), and the most anywhere. Contrast: of the texture, where ink is short now. Colour error: mean difference to the texture on the painted surface.</source>
        <translation>Ein Klick auf eine Möglichkeit ändert das Projekt; das lässt sich rückgängig machen. Zu blass: Anteil der bemalten Fläche. Fehlt: optische Dichte, wo die Tinte jetzt nicht reicht (95 %), und die größte überhaupt. Kontrast: der Textur, wo die Tinte jetzt nicht reicht. Farbfehler: mittlerer Unterschied zur Textur auf der bemalten Fläche.</translation>
    </message>
</context>
<context>
    <name>RunCommand</name>
    <message>
        <source>Project %1 of %2: %3</source>
        <translation>Projekt %1 von %2: %3</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Coverage by all dips: %1 %</source>
        <translation>Abdeckung durch alle Tauchvorgänge: %1 %</translation>
    </message>
    <message>
        <source>%1 % of the film is used; the smaller size %2 (%3 × %4 mm) is large enough</source>
        <translation>%1 % des Films werden genutzt; das kleinere Format %2 (%3 × %4 mm) ist groß genug</translation>
    </message>
    <message>
        <source>Film: swell guessed</source>
        <translation>Film: Quellung geschätzt</translation>
    </message>
    <message>
        <source>Film: swell measured on %1</source>
        <translation>Film: Quellung gemessen am %1</translation>
    </message>
    <message>
        <source>Solver: %1 %2 on %3</source>
        <translation>Solver: %1 %2 auf %3</translation>
    </message>
    <message>
        <source>%1: %2 × %3 points, cells of %4 mm over the part, %5, coverage %6 %, read-back error of the texture %7 mm (95 %)</source>
        <translation>%1: %2 × %3 Punkte, Zellen von %4 mm über dem Teil, %5, Abdeckung %6 %, Rücklesefehler der Textur %7 mm (95 %)</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 Schritte</translation>
    </message>
    <message>
        <source>%1 steps in %2 s</source>
        <translation>%1 Schritte in %2 s</translation>
    </message>
    <message>
        <source>%1: the cradle is %2 mm from the part and %3 mm from the paint, supports %4 mm² of the part and may be tilted by %5°</source>
        <translation>%1: Die Halterung ist %2 mm vom Teil und %3 mm von der Farbe entfernt, stützt %4 mm² des Teils und darf um %5° gekippt werden</translation>
    </message>
    <message>
        <source>Seam: %1 mm long</source>
        <translation>Naht: %1 mm lang</translation>
    </message>
    <message>
        <source>Seam: %1 mm long, %2 % as visible as a plain cut halfway between the poses</source>
        <translation>Naht: %1 mm lang, %2 % so sichtbar wie ein einfacher Schnitt auf halbem Weg zwischen den Lagen</translation>
    </message>
    <message>
        <source>smaller places that only report.json lists: %1</source>
        <translation>kleinere Stellen, die nur report.json nennt: %1</translation>
    </message>
    <message>
        <source>not reached: %1 mm² at x %2 mm, y %3 mm, z %4 mm on the model</source>
        <translation>nicht erreicht: %1 mm² bei x %2 mm, y %3 mm, z %4 mm auf dem Modell</translation>
    </message>
    <message>
        <source>Split between the dips: %1 %2, %3 %4, overlap %5 with a width of %6 to %7 mm, not painted %8</source>
        <translation>Aufteilung auf die Tauchvorgänge: %1 %2, %3 %4, Überlappung %5 mit einer Breite von %6 bis %7 mm, nicht bemalt %8</translation>
    </message>
    <message>
        <source>%1 mm² (%2 %)</source>
        <translation>%1 mm² (%2 %)</translation>
    </message>
    <message>
        <source>±%1 mm at x %2 mm, y %3 mm, z %4 mm on the model, largest cause: %5</source>
        <translation>±%1 mm bei x %2 mm, y %3 mm, z %4 mm auf dem Modell, größte Ursache: %5</translation>
    </message>
    <message>
        <source>moves the border of the paint: %1 mm² less or %2 mm² more painted</source>
        <translation>verschiebt den Rand der bemalten Fläche: %1 mm² weniger oder %2 mm² mehr bemalt</translation>
    </message>
    <message>
        <source>%1 ±%2 %3: %4 % of the spread, %5</source>
        <translation>%1 ±%2 %3: %4 % der Streuung, %5</translation>
    </message>
    <message>
        <source>colours land within %1 of their places</source>
        <translation>Farben landen innerhalb von %1 um ihre Stellen</translation>
    </message>
    <message>
        <source>±%1 mm (95 %; half of the painted area within ±%2 mm, all within ±%3 mm)</source>
        <translation>±%1 mm (95 %; die Hälfte der bemalten Fläche innerhalb von ±%2 mm, alles innerhalb von ±%3 mm)</translation>
    </message>
    <message>
        <source>x %1 mm, z %2 mm from the film&apos;s centre: %3</source>
        <translation>x %1 mm, z %2 mm von der Mitte des Films: %3</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
</context>
<context>
    <name>SeparateBodies</name>
    <message>
        <source>The body at X %1, Y %2, Z %3 mm</source>
        <translation>Der Körper bei X %1, Y %2, Z %3 mm</translation>
    </message>
</context>
<context>
    <name>Separation</name>
    <message>
        <source>The white layer is left out: it needs a printer profile with an ICC profile in CMYK</source>
        <translation>Die weiße Schicht wird weggelassen: Sie braucht ein Druckerprofil mit einem ICC-Profil in CMYK</translation>
    </message>
    <message>
        <source>The spot colours are left out: they need a printer profile with an ICC profile in CMYK</source>
        <translation>Die Sonderfarben werden weggelassen: Sie brauchen ein Druckerprofil mit einem ICC-Profil in CMYK</translation>
    </message>
</context>
<context>
    <name>Serving</name>
    <message>
        <source>Write the path of a socket, such as /run/user/1000/dipwright.sock, or a port of this computer, such as 127.0.0.1:8137</source>
        <translation>Schreiben Sie den Pfad eines Sockets, etwa /run/user/1000/dipwright.sock, oder einen Port dieses Rechners, etwa 127.0.0.1:8137</translation>
    </message>
    <message>
        <source>Only addresses of this computer are possible, because the connection is not encrypted. Reach another computer through an SSH tunnel: ssh -L 8137:127.0.0.1:8137 USER@COMPUTER</source>
        <translation>Nur Adressen dieses Rechners sind möglich, denn die Verbindung ist nicht verschlüsselt. Erreichen Sie einen anderen Rechner durch einen SSH-Tunnel: ssh -L 8137:127.0.0.1:8137 BENUTZER@RECHNER</translation>
    </message>
    <message>
        <source>The server does not answer (%1). Check that it runs, and the address</source>
        <translation>Der Server antwortet nicht (%1). Prüfen Sie, ob er läuft, und die Adresse</translation>
    </message>
    <message>
        <source>The server&apos;s answer is too long</source>
        <translation>Die Antwort des Servers ist zu lang</translation>
    </message>
    <message>
        <source>The server refused the request (%1)</source>
        <translation>Der Server hat die Anfrage abgelehnt (%1)</translation>
    </message>
    <message>
        <source>The server says: %1</source>
        <translation>Der Server meldet: %1</translation>
    </message>
    <message>
        <source>The project cannot be read: %1</source>
        <translation>Das Projekt kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>The project has %1 MB, and the server allows %2 MB</source>
        <translation>Das Projekt hat %1 MB, und der Server erlaubt %2 MB</translation>
    </message>
    <message>
        <source>The file cannot be written: %1</source>
        <translation>Die Datei kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>The server has no file %1</source>
        <translation>Der Server hat keine Datei %1</translation>
    </message>
    <message>
        <source>The server&apos;s file %1 is too large</source>
        <translation>Die Datei %1 des Servers ist zu groß</translation>
    </message>
    <message>
        <source>The server could not run the job: %1</source>
        <translation>Der Server konnte den Auftrag nicht ausführen: %1</translation>
    </message>
    <message>
        <source>Waiting for the server</source>
        <translation>Warten auf den Server</translation>
    </message>
    <message>
        <source>On the server: %1</source>
        <translation>Auf dem Server: %1</translation>
    </message>
    <message>
        <source>Sending the project</source>
        <translation>Projekt wird gesendet</translation>
    </message>
    <message>
        <source>Fetching the results</source>
        <translation>Ergebnisse werden geholt</translation>
    </message>
    <message>
        <source>The server&apos;s results do not fit this program. Install the same version of Dipwright on both computers</source>
        <translation>Die Ergebnisse des Servers passen nicht zu diesem Programm. Installieren Sie auf beiden Rechnern dieselbe Version von Dipwright</translation>
    </message>
    <message>
        <source>The server has too many jobs; remove finished ones</source>
        <translation>Der Server hat zu viele Aufträge; entfernen Sie beendete</translation>
    </message>
</context>
<context>
    <name>ShippedNames</name>
    <message>
        <source>Ideal film, A3</source>
        <translation>Idealer Film, A3</translation>
    </message>
    <message>
        <source>Ideal film, A4</source>
        <translation>Idealer Film, A4</translation>
    </message>
    <message>
        <source>Soft film, A4, swells by 5 %</source>
        <translation>Weicher Film, A4, quillt um 5 %</translation>
    </message>
    <message>
        <source>Pigment printer, borderless, 600 dpi</source>
        <translation>Pigmentdrucker, randlos, 600 dpi</translation>
    </message>
    <message>
        <source>Office printer, 5 mm margins</source>
        <translation>Bürodrucker, 5 mm Rand</translation>
    </message>
    <message>
        <source>True size, sRGB</source>
        <translation>Wahre Größe, sRGB</translation>
    </message>
    <message>
        <source>Tank with barriers on all sides</source>
        <translation>Becken mit Barrieren an allen Seiten</translation>
    </message>
    <message>
        <source>Open tank</source>
        <translation>Offenes Becken</translation>
    </message>
    <message>
        <source>Position-based film on the CPU</source>
        <translation>Positionsbasierter Film auf der CPU</translation>
    </message>
    <message>
        <source>Position-based film on an NVIDIA GPU</source>
        <translation>Positionsbasierter Film auf einer NVIDIA-GPU</translation>
    </message>
    <message>
        <source>No NVIDIA driver was found on this computer; install one to compute on the GPU.</source>
        <translation>Auf diesem Rechner fehlt ein NVIDIA-Treiber; installieren Sie einen, um auf der GPU zu rechnen.</translation>
    </message>
    <message>
        <source>No NVIDIA GPU was found on this computer.</source>
        <translation>Auf diesem Rechner wurde keine NVIDIA-GPU gefunden.</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Tetrahedron</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Turtle</source>
        <translation>Schildkröte</translation>
    </message>
    <message>
        <source>Lagoon</source>
        <translation>Lagune</translation>
    </message>
    <message>
        <source>Dusk</source>
        <translation>Dämmerung</translation>
    </message>
    <message>
        <source>Balance</source>
        <translation>Waage</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
</context>
<context>
    <name>SmallFile</name>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>Die Datei kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>The file is larger than %1 MB, too large for this purpose; choose another file</source>
        <translation>Die Datei ist größer als %1 MB und damit zu groß für diesen Zweck; wählen Sie eine andere Datei</translation>
    </message>
</context>
<context>
    <name>SnapshotEdits</name>
    <message>
        <source>Take snapshot “%1”</source>
        <translation>Schnappschuss „%1“ aufnehmen</translation>
    </message>
    <message>
        <source>Remove snapshot “%1”</source>
        <translation>Schnappschuss „%1“ entfernen</translation>
    </message>
    <message>
        <source>Restore snapshot “%1”</source>
        <translation>Schnappschuss „%1“ wiederherstellen</translation>
    </message>
</context>
<context>
    <name>Snapshots</name>
    <message>
        <source>The picture of layer “%1” is no longer in the project&apos;s file</source>
        <translation>Das Bild der Ebene „%1“ ist nicht mehr in der Projektdatei</translation>
    </message>
</context>
<context>
    <name>SolverRegistry</name>
    <message>
        <source>Its description has no valid &quot;%1&quot;</source>
        <translation>Seine Beschreibung hat kein gültiges „%1“</translation>
    </message>
    <message>
        <source>Its description cannot be read: %1</source>
        <translation>Seine Beschreibung kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Its description is not valid JSON: %1</source>
        <translation>Seine Beschreibung ist kein gültiges JSON: %1</translation>
    </message>
    <message>
        <source>Its module %1 is missing</source>
        <translation>Sein Modul %1 fehlt</translation>
    </message>
    <message>
        <source>Its module cannot be loaded: %1</source>
        <translation>Sein Modul kann nicht geladen werden: %1</translation>
    </message>
    <message>
        <source>Its module has no entry point %1</source>
        <translation>Sein Modul hat keinen Einsprungpunkt %1</translation>
    </message>
    <message>
        <source>Its module failed at start: %1</source>
        <translation>Sein Modul ist beim Start gescheitert: %1</translation>
    </message>
    <message>
        <source>Its module failed at start with an unknown exception</source>
        <translation>Sein Modul ist beim Start mit einer unbekannten Ausnahme gescheitert</translation>
    </message>
    <message>
        <source>no plugin was found</source>
        <translation>kein Plugin wurde gefunden</translation>
    </message>
    <message>
        <source>No solver can run here; install one or set DIPWRIGHT_PLUGIN_PATH</source>
        <translation>Hier kann kein Solver laufen; installieren Sie einen oder setzen Sie DIPWRIGHT_PLUGIN_PATH</translation>
    </message>
    <message>
        <source>There is no such solver; choose one of %1</source>
        <translation>Diesen Solver gibt es nicht; wählen Sie einen von %1</translation>
    </message>
    <message>
        <source>This solver cannot be used: %1</source>
        <translation>Dieser Solver kann nicht verwendet werden: %1</translation>
    </message>
    <message>
        <source>It has crashed twice; replace it, or set DIPWRIGHT_RETRY_SOLVERS=1 to try it again</source>
        <translation>Er ist zweimal abgestürzt; ersetzen Sie ihn, oder setzen Sie DIPWRIGHT_RETRY_SOLVERS=1, um ihn wieder zu versuchen</translation>
    </message>
    <message>
        <source>The &quot;priority&quot; in its description has to be a whole number from -%1 to %1</source>
        <translation>„priority“ in seiner Beschreibung muss eine ganze Zahl von -%1 bis %1 sein</translation>
    </message>
    <message>
        <source>It cannot run here and does not say why; ask its author</source>
        <translation>Er kann hier nicht laufen und sagt nicht, warum; fragen Sie seinen Hersteller</translation>
    </message>
    <message>
        <source>Its description file is too large</source>
        <translation>Seine Beschreibungsdatei ist zu groß</translation>
    </message>
    <message>
        <source>Its description file does not describe a solver</source>
        <translation>Seine Beschreibungsdatei beschreibt keinen Solver</translation>
    </message>
    <message>
        <source>Its id may contain only lower-case letters, digits and hyphens</source>
        <translation>Seine Kennung darf nur Kleinbuchstaben, Ziffern und Bindestriche enthalten</translation>
    </message>
    <message>
        <source>Other users can write to %1; remove that permission, or move the plugin</source>
        <translation>Andere Benutzer können %1 schreiben; entziehen Sie ihnen dieses Recht, oder verschieben Sie das Plugin</translation>
    </message>
    <message>
        <source>Its module must be in the same folder as its description; give the file&apos;s name without a path</source>
        <translation>Sein Modul muss im selben Ordner liegen wie seine Beschreibung; geben Sie den Dateinamen ohne Pfad an</translation>
    </message>
    <message>
        <source>Its module does not match this program&apos;s solver interface %1, although its description file says that it does; build it again</source>
        <translation>Sein Modul passt nicht zur Solverschnittstelle %1 dieses Programms, obwohl seine Beschreibungsdatei das angibt; bauen Sie es neu</translation>
    </message>
    <message>
        <source>It handles films of at most %1 points, but this film has %2; choose another solver, or a coarser film</source>
        <translation>Er verarbeitet Filme mit höchstens %1 Punkten, aber dieser Film hat %2; wählen Sie einen anderen Solver oder einen gröberen Film</translation>
    </message>
    <message>
        <source>It was built for solver interface %1, but this program has %2 to %3; get the plugin for this version of the program, or build it again</source>
        <translation>Er wurde für die Solverschnittstelle %1 gebaut, dieses Programm hat aber %2 bis %3; besorgen Sie das Plugin für diese Version des Programms, oder bauen Sie es neu</translation>
    </message>
</context>
<context>
    <name>StateDifference</name>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Painted in only one state</source>
        <translation>Nur in einem Stand bemalt</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Nicht bemalt</translation>
    </message>
    <message>
        <source>The difference needs the dips of both states.</source>
        <translation>Der Unterschied braucht die Tauchvorgänge beider Stände.</translation>
    </message>
    <message>
        <source>These states have different models, so their sheets cannot be compared.</source>
        <translation>Diese Stände haben verschiedene Modelle; ihre Blätter lassen sich daher nicht vergleichen.</translation>
    </message>
    <message>
        <source>These states have different numbers of dips, so their sheets cannot be compared.</source>
        <translation>Diese Stände haben verschieden viele Tauchvorgänge; ihre Blätter lassen sich daher nicht vergleichen.</translation>
    </message>
    <message>
        <source>Comparing the sheets</source>
        <translation>Blätter werden verglichen</translation>
    </message>
    <message>
        <source>Drawing the difference</source>
        <translation>Unterschied wird gezeichnet</translation>
    </message>
</context>
<context>
    <name>StateFigures</name>
    <message>
        <source>no result</source>
        <translation>kein Ergebnis</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Total coverage</source>
        <translation>Gesamte Abdeckung</translation>
    </message>
    <message>
        <source>Area with too large a numerical error</source>
        <translation>Fläche mit zu großem numerischem Fehler</translation>
    </message>
    <message>
        <source>Stretch of the film on the part, 95th percentile</source>
        <translation>Dehnung des Films auf dem Teil, 95. Perzentil</translation>
    </message>
    <message>
        <source>%1 (better)</source>
        <translation>%1 (besser)</translation>
    </message>
    <message>
        <source>%1 (worse)</source>
        <translation>%1 (schlechter)</translation>
    </message>
    <message>
        <source>Largest stretch of the film on the part</source>
        <translation>Größte Dehnung des Films auf dem Teil</translation>
    </message>
    <message>
        <source>Numerical error of the sheet, 95th percentile</source>
        <translation>Numerischer Fehler des Blatts, 95. Perzentil</translation>
    </message>
    <message>
        <source>Compressed film that may wrinkle</source>
        <translation>Gestauchter Film, der Falten werfen kann</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Eingeschlossene Luft</translation>
    </message>
    <message>
        <source>Area painted by film that tore, was released or did not converge</source>
        <translation>Fläche, bemalt von Film, der riss, sich löste oder nicht konvergierte</translation>
    </message>
    <message>
        <source>Area too pale because of the ink limit</source>
        <translation>Wegen des Tintenlimits zu blasse Fläche</translation>
    </message>
    <message>
        <source>Length of the seam</source>
        <translation>Länge der Naht</translation>
    </message>
    <message>
        <source>Ink of all plates, as area at full tint</source>
        <translation>Tinte aller Platten, als Fläche mit vollem Ton</translation>
    </message>
</context>
<context>
    <name>TankFit</name>
    <message>
        <source>The film measures %1 × %2 mm on the water, but the tank “%3” only %4 × %5 mm; use a smaller film</source>
        <translation>Der Film misst auf dem Wasser %1 × %2 mm, das Becken „%3“ aber nur %4 × %5 mm; nehmen Sie einen kleineren Film</translation>
    </message>
    <message>
        <source>The part reaches past the edge of the tank “%1”; move or turn the part</source>
        <translation>Das Teil ragt über den Rand des Beckens „%1“ hinaus; das Teil verschieben oder drehen</translation>
    </message>
    <message>
        <source>The part goes %1 mm under water, but the water in the tank “%2” is only %3 mm deep; reduce the depth of the dip, or turn the part</source>
        <translation>Das Teil kommt %1 mm unter Wasser, aber das Wasser im Becken „%2“ ist nur %3 mm tief; weniger tief tauchen oder das Teil drehen</translation>
    </message>
    <message>
        <source>The centre of the part moves %1 mm sideways from the middle of the tank “%2”, but its machine reaches only %3 mm; move the part or change its path</source>
        <translation>Die Mitte des Teils bewegt sich %1 mm von der Mitte des Beckens „%2“ zur Seite, aber seine Maschine reicht nur %3 mm weit; das Teil verschieben oder den Weg ändern</translation>
    </message>
    <message>
        <source>The part moves at up to %1 mm/s, but the machine of the tank “%2” reaches only %3 mm/s; reduce the speed of the dip</source>
        <translation>Das Teil bewegt sich mit bis zu %1 mm/s, aber die Maschine des Beckens „%2“ schafft nur %3 mm/s; langsamer tauchen</translation>
    </message>
    <message>
        <source>The part turns at up to %1°/s, but the machine of the tank “%2” reaches only %3°/s; use a slower dip or a smaller turn</source>
        <translation>Das Teil dreht sich mit bis zu %1°/s, aber die Maschine des Beckens „%2“ schafft nur %3°/s; langsamer tauchen oder weniger drehen</translation>
    </message>
    <message>
        <source>The water carries the film %1 mm during the dip, past the edge of the tank “%2”; reduce the speed of the water, or use a smaller film</source>
        <translation>Das Wasser trägt den Film während des Tauchvorgangs %1 mm weit, über den Rand des Beckens „%2“ hinaus; verringern Sie die Geschwindigkeit des Wassers, oder verwenden Sie einen kleineren Film</translation>
    </message>
    <message>
        <source>The part reaches past the barrier at the film&apos;s %1 edge; move or turn the part, change its path, or use a larger film</source>
        <translation>Das Teil reicht über die Barriere am %1 Rand des Films hinaus; verschieben oder drehen Sie das Teil, ändern Sie seinen Weg, oder verwenden Sie einen größeren Film</translation>
    </message>
    <message>
        <source>left</source>
        <comment>edge of the film</comment>
        <translation>linken</translation>
    </message>
    <message>
        <source>right</source>
        <comment>edge of the film</comment>
        <translation>rechten</translation>
    </message>
    <message>
        <source>top</source>
        <comment>edge of the film</comment>
        <translation>oberen</translation>
    </message>
    <message>
        <source>bottom</source>
        <comment>edge of the film</comment>
        <translation>unteren</translation>
    </message>
</context>
<context>
    <name>Tolerance</name>
    <message>
        <source>Swell</source>
        <translation>Quellung</translation>
    </message>
    <message>
        <source>Water level</source>
        <translation>Wasserstand</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxation</translation>
    </message>
    <message>
        <source>Zone %1 is not painted.</source>
        <translation>Zone %1 wird nicht bemalt.</translation>
    </message>
    <message>
        <source>Position of the part along X</source>
        <translation>Lage des Teils entlang X</translation>
    </message>
    <message>
        <source>Position of the part along Z</source>
        <translation>Lage des Teils entlang Z</translation>
    </message>
    <message>
        <source>Rotation of the part about X</source>
        <translation>Drehung des Teils um X</translation>
    </message>
    <message>
        <source>Rotation of the part about Y</source>
        <translation>Drehung des Teils um Y</translation>
    </message>
    <message>
        <source>Rotation of the part about Z</source>
        <translation>Drehung des Teils um Z</translation>
    </message>
    <message>
        <source>Position of the film along X</source>
        <translation>Lage des Films entlang X</translation>
    </message>
    <message>
        <source>Position of the film along Z</source>
        <translation>Lage des Films entlang Z</translation>
    </message>
    <message>
        <source>Rotation of the film about Y</source>
        <translation>Drehung des Films um Y</translation>
    </message>
    <message>
        <source>The simulation became unstable in a dip with deviations; give the film smaller cells or more points</source>
        <translation>Die Simulation wurde in einem Tauchvorgang mit Abweichungen instabil; geben Sie dem Film kleinere Zellen oder mehr Punkte</translation>
    </message>
    <message>
        <source>Simulating dips with deviations</source>
        <translation>Tauchvorgänge mit Abweichungen werden simuliert</translation>
    </message>
    <message>
        <source>Check: with all deviations at once, %1 simulated dips give a displacement of ±%2 (95 % of the painted area). The sum of the contributors gives ±%3. Both agree.</source>
        <translation>Prüfung: Mit allen Abweichungen zugleich ergeben %1 simulierte Tauchvorgänge eine Verschiebung von ±%2 (95 % der bemalten Fläche). Die Summe der Beiträge ergibt ±%3. Beides stimmt überein.</translation>
    </message>
    <message>
        <source>Check: with all deviations at once, %1 simulated dips give a displacement of ±%2 (95 % of the painted area). The sum of the contributors gives ±%3. The two differ, because the effects of the contributors do not simply add up here.</source>
        <translation>Prüfung: Mit allen Abweichungen zugleich ergeben %1 simulierte Tauchvorgänge eine Verschiebung von ±%2 (95 % der bemalten Fläche). Die Summe der Beiträge ergibt ±%3. Beides weicht voneinander ab, weil sich die Beiträge hier nicht einfach addieren.</translation>
    </message>
    <message>
        <source>Zone %1 keeps its limit of ±%3: on %2 % of the painted area, the image is displaced by less than this limit, and on 95 % by ±%4 or less. Largest contributor: %5.</source>
        <translation>Zone %1 hält ihre Grenze von ±%3 ein: Auf %2 % der bemalten Fläche ist das Bild um weniger als diese Grenze verschoben, auf 95 % um höchstens ±%4. Größter Beitrag: %5.</translation>
    </message>
    <message>
        <source>Zone %1 exceeds its limit of ±%3: on only %2 % of the painted area, the image is displaced by less than this limit, and on 95 % by ±%4 or less. Largest contributor: %5.</source>
        <translation>Zone %1 überschreitet ihre Grenze von ±%3: Nur auf %2 % der bemalten Fläche ist das Bild um weniger als diese Grenze verschoben, auf 95 % um höchstens ±%4. Größter Beitrag: %5.</translation>
    </message>
    <message>
        <source>Angle of the path</source>
        <translation>Winkel des Wegs</translation>
    </message>
    <message>
        <source>Start of the dip</source>
        <translation>Beginn des Tauchvorgangs</translation>
    </message>
</context>
<context>
    <name>Traveller</name>
    <message>
        <source>The cradle is marked with the number of this dip and the number of its sheet, %1. At the end of the path, its arrow points to the film&apos;s upper edge.</source>
        <translation>Auf der Halterung stehen die Nummer dieses Tauchvorgangs und die Nummer seines Blatts, %1. Am Ende des Wegs zeigt ihr Pfeil zur oberen Kante des Films.</translation>
    </message>
    <message>
        <source>Dip the part along its path in %1 s (motion-%2.csv begins at the waiting height). Each pose gives the time, the position of the part&apos;s centre relative to the film&apos;s centre on the water, and the turn relative to the rotation at the end: about the axis to the right, then about the axis towards the upper edge, then about the upward axis.</source>
        <translation>Das Teil in %1 s auf seinem Weg eintauchen (motion-%2.csv beginnt in der Wartehöhe). Jede Lage nennt die Zeit, den Ort der Teilmitte gegenüber der Filmmitte auf dem Wasser und die Drehung gegenüber der Drehung am Ende: um die Achse nach rechts, dann um die Achse zur oberen Kante, dann um die Achse nach oben.</translation>
    </message>
    <message>
        <source>%1 s: %2 mm to the right, %3 mm towards the upper edge, %4 mm up, turned by %5°, %6° and %7°</source>
        <translation>%1 s: %2 mm nach rechts, %3 mm zur oberen Kante, %4 mm nach oben, gedreht um %5°, %6° und %7°</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>Dip %1 of %2: %3</source>
        <translation>Tauchvorgang %1 von %2: %3</translation>
    </message>
    <message>
        <source>%1. %2, job %3</source>
        <translation>%1. %2, Auftrag %3</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Auftrag %1</translation>
    </message>
    <message>
        <source>Seen from the film&apos;s lower edge</source>
        <translation>Von der unteren Kante des Films gesehen</translation>
    </message>
    <message>
        <source>Seen from the film&apos;s right edge</source>
        <translation>Von der rechten Kante des Films gesehen</translation>
    </message>
    <message>
        <source>upper edge</source>
        <translation>obere Kante</translation>
    </message>
    <message>
        <source>lower edge</source>
        <translation>untere Kante</translation>
    </message>
    <message>
        <source>left edge</source>
        <translation>linke Kante</translation>
    </message>
    <message>
        <source>No film profile is given.</source>
        <translation>Kein Filmprofil ist angegeben.</translation>
    </message>
    <message>
        <source>At the tank</source>
        <translation>Am Becken</translation>
    </message>
    <message>
        <source>Done by</source>
        <translation>Ausgeführt von</translation>
    </message>
    <message>
        <source>Date, time</source>
        <translation>Datum, Uhrzeit</translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation>Geprüft von</translation>
    </message>
    <message>
        <source>Swell measured on %1.</source>
        <translation>Quellung gemessen am %1.</translation>
    </message>
    <message>
        <source>Swell guessed, not measured.</source>
        <translation>Quellung geschätzt, nicht gemessen.</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>Urteil: %1</translation>
    </message>
    <message>
        <source>Soak the film: %1</source>
        <translation>Film einweichen: %1</translation>
    </message>
    <message>
        <source>Spray the activator, then wait: %1</source>
        <translation>Aktivator aufsprühen, dann warten: %1</translation>
    </message>
    <message>
        <source>see the film maker&apos;s instructions (no time given)</source>
        <translation>siehe Anleitung des Filmherstellers (keine Zeit angegeben)</translation>
    </message>
    <message>
        <source>Traveller for %1, %2</source>
        <translation>Laufkarte für %1, %2</translation>
    </message>
    <message>
        <source>Order of the dips: %1</source>
        <translation>Reihenfolge der Tauchvorgänge: %1</translation>
    </message>
    <message>
        <source>Rotation about fixed axes: X %1°, then Y %2°, then Z %3°. Centre of the part: x = %4 mm (to the right), z = %5 mm (towards the lower edge) from the film&apos;s centre. Blue line: water when the dip begins (solid) and ends (dashed).</source>
        <translation>Drehung um feste Achsen: X %1°, dann Y %2°, dann Z %3°. Mitte des Teils: x = %4 mm (nach rechts), z = %5 mm (zur unteren Kante) von der Mitte des Films. Blaue Linie: Wasser am Anfang (durchgezogen) und am Ende (gestrichelt) des Tauchvorgangs.</translation>
    </message>
    <message>
        <source>There is no cradle for this dip. Hold the part as drawn.</source>
        <translation>Für diesen Tauchvorgang gibt es keine Halterung. Halten Sie das Teil wie gezeichnet.</translation>
    </message>
    <message>
        <source>The cradle is marked with the number of this dip and the number of its sheet, %1. Its arrow points to the film&apos;s upper edge.</source>
        <translation>Auf der Halterung stehen die Nummer dieses Tauchvorgangs und die Nummer seines Blatts, %1. Ihr Pfeil zeigt zur oberen Kante des Films.</translation>
    </message>
    <message>
        <source>Dotted: the tank&apos;s marks, %1 × %2 mm apart. Centre the film between them.</source>
        <translation>Gepunktet: die Marken des Beckens, %1 × %2 mm voneinander. Den Film mittig dazwischen legen.</translation>
    </message>
    <message>
        <source>The distance between the tank&apos;s marks is not given.</source>
        <translation>Der Abstand der Marken des Beckens ist nicht angegeben.</translation>
    </message>
    <message>
        <source>Film: printed size %1 × %2 mm, swell %3 × %4.</source>
        <translation>Film: gedruckte Größe %1 × %2 mm, Quellung %3 × %4.</translation>
    </message>
    <message>
        <source>%1 (lot: %2, use by: %3).</source>
        <translation>%1 (Charge: %2, haltbar bis: %3).</translation>
    </message>
    <message>
        <source>Lay sheet %1 on the water, ink side up.</source>
        <translation>Blatt %1 auf das Wasser legen, Farbseite oben.</translation>
    </message>
    <message>
        <source>The arrow on the cradle&apos;s plate must point to the upper edge of the sheet.</source>
        <translation>Der Pfeil auf der Platte der Halterung muss zur oberen Kante des Blatts zeigen.</translation>
    </message>
    <message>
        <source>Dip the part: lower its lowest point from %1 mm above the water to %2 mm below it, at %3 mm/s, in %4 s</source>
        <translation>Das Teil tauchen: seinen tiefsten Punkt von %1 mm über dem Wasser auf %2 mm darunter senken, mit %3 mm/s, in %4 s</translation>
    </message>
    <message>
        <source>Hold the part under water for %1 s. Clear the remaining film from the water around it. Then lift the part out at %2 mm/s.</source>
        <translation>Das Teil %1 s unter Wasser halten. Den restlichen Film rundherum vom Wasser entfernen. Dann das Teil mit %2 mm/s herausheben.</translation>
    </message>
    <message>
        <source>Let the part flash off before rinsing: %1</source>
        <translation>Das Teil vor dem Abspülen ablüften lassen: %1</translation>
    </message>
    <message>
        <source>Rinse the part, then let it dry: %1</source>
        <translation>Das Teil abspülen, dann trocknen lassen: %1</translation>
    </message>
    <message>
        <source>Before dip %1, compare the part with its pictures after dip %2: the colours are in place, nothing is torn or folded, and the part is dry where it will be held.</source>
        <translation>Vor Tauchvorgang %1 das Teil mit seinen Bildern nach Tauchvorgang %2 vergleichen: Die Farben sind an ihrem Platz, nichts ist gerissen oder gefaltet, und das Teil ist trocken, wo es gehalten wird.</translation>
    </message>
    <message>
        <source>Compare the part with its pictures after dip %1.</source>
        <translation>Das Teil mit seinen Bildern nach Tauchvorgang %1 vergleichen.</translation>
    </message>
    <message>
        <source>After dip %1 the part should look like this (seen from the lower edge, the right edge and below)</source>
        <translation>Nach Tauchvorgang %1 soll das Teil so aussehen (von der unteren Kante, der rechten Kante und von unten gesehen)</translation>
    </message>
    <message>
        <source>The part at the end of the dip, when its rotation about fixed axes is X %1°, then Y %2°, then Z %3°. Dashed blue line: water at the end.</source>
        <translation>Das Teil am Ende des Tauchvorgangs; seine Drehung um feste Achsen ist dann X %1°, danach Y %2°, danach Z %3°. Gestrichelte blaue Linie: Wasser am Ende.</translation>
    </message>
    <message>
        <source>Tape the masked surface</source>
        <translation>Maskierte Fläche abkleben</translation>
    </message>
    <message>
        <source>Lay the film</source>
        <translation>Film auflegen</translation>
    </message>
    <message>
        <source>Soak</source>
        <translation>Einweichen</translation>
    </message>
    <message>
        <source>Spray the activator</source>
        <translation>Aktivator sprühen</translation>
    </message>
    <message>
        <source>Dip the part</source>
        <translation>Teil tauchen</translation>
    </message>
    <message>
        <source>Hold under water</source>
        <translation>Unter Wasser halten</translation>
    </message>
    <message>
        <source>Let it flash off</source>
        <translation>Ablüften lassen</translation>
    </message>
    <message>
        <source>Rinse and dry</source>
        <translation>Abspülen und trocknen</translation>
    </message>
    <message>
        <source>Remove the tape</source>
        <translation>Klebeband abziehen</translation>
    </message>
    <message>
        <source>Compare the part</source>
        <translation>Teil vergleichen</translation>
    </message>
    <message>
        <source>Cover the masked surface of the part with tape (pink in the pictures). Number of areas: %1; in total %2 mm².</source>
        <translation>Die maskierte Fläche des Teils mit Klebeband abdecken (rosa in den Bildern). Anzahl der Flächen: %1; zusammen %2 mm².</translation>
    </message>
    <message>
        <source>Check that the tape still covers the masked surface (pink in the pictures).</source>
        <translation>Prüfen, ob das Klebeband die maskierte Fläche noch abdeckt (rosa in den Bildern).</translation>
    </message>
    <message>
        <source>Remove the tape from the masked surface.</source>
        <translation>Das Klebeband von der maskierten Fläche abziehen.</translation>
    </message>
    <message>
        <source>Compare the part with the picture on the traveller: the colours are in place, and nothing is torn or folded.</source>
        <translation>Vergleichen Sie das Teil mit dem Bild auf der Laufkarte: Die Farben sind an ihrem Ort, und nichts ist gerissen oder gefaltet.</translation>
    </message>
    <message>
        <source>Lay sheet %1, which must have been printed in %2 passes, on the water, ink side up.</source>
        <translation>Das Blatt %1, das in %2 Durchgängen gedruckt sein muss, mit der Farbseite nach oben auf das Wasser legen.</translation>
    </message>
    <message>
        <source>All dips: %1</source>
        <translation>Alle Tauchvorgänge: %1</translation>
    </message>
    <message>
        <source>From above, ink side up. Crosses: marks of the floating film, or its corners if it has no marks. Red circles: datum pins at (x; z) = %1, %2 and %3 mm from the film&apos;s centre, x to the right, z towards the lower edge. Dashed: the part.</source>
        <translation>Von oben, Farbseite oben. Kreuze: Marken des schwimmenden Films, oder seine Ecken, wenn er keine Marken hat. Rote Kreise: Passstifte bei (x; z) = %1, %2 und %3 mm von der Mitte des Films, x nach rechts, z zur unteren Kante. Gestrichelt: das Teil.</translation>
    </message>
    <message>
        <source>The water flows at %1 mm/s with the heading %2° (0°: to the right, 90°: towards the lower edge) and carries the film. Lay the film so far upstream that its centre is in the middle of the tank when the dip begins; all positions are relative to that place. At the end of the dip, the film&apos;s centre is %3 mm to the right of it and %4 mm towards the lower edge.</source>
        <translation>Das Wasser fließt mit %1 mm/s in Richtung %2° (0°: nach rechts, 90°: zur unteren Kante) und trägt den Film mit. Legen Sie den Film so weit stromaufwärts auf, dass seine Mitte in der Mitte des Beckens ist, wenn der Tauchvorgang beginnt; alle Positionen gelten von dort aus. Am Ende des Tauchvorgangs ist die Mitte des Films %3 mm rechts davon und %4 mm zur unteren Kante hin.</translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source> in</source>
        <translation> in</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> in/s</source>
        <translation> in/s</translation>
    </message>
    <message>
        <source> mm/s</source>
        <translation> mm/s</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source> cells</source>
        <translation> Zellen</translation>
    </message>
    <message>
        <source> D</source>
        <translation> D</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source> %/s</source>
        <translation> %/s</translation>
    </message>
    <message>
        <source>%1 in²</source>
        <translation>%1 in²</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source> million</source>
        <translation> Mio.</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source> in/s²</source>
        <translation> in/s²</translation>
    </message>
    <message>
        <source> mm/s²</source>
        <translation> mm/s²</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>The film&apos;s swell is %1; the usual range is %2 to %3. Check this value. If it was measured, check that the rulers on the card and on the film have the length that is printed beside them.</source>
        <translation>Die Quellung des Films ist %1; üblich sind %2 bis %3. Prüfen Sie diesen Wert. Wurde er gemessen, prüfen Sie, ob die Lineale auf der Karte und auf dem Film so lang sind, wie daneben steht.</translation>
    </message>
    <message>
        <source>Trapped air keeps %1 % of the part dry; the limit is %2 %. Turn the part so that the air escapes, or drill a vent hole. Vent holes narrower than %3 may not be seen.</source>
        <translation>Eingeschlossene Luft hält %1 % des Teils trocken; die Grenze ist %2 %. Drehen Sie das Teil so, dass die Luft entweicht, oder bohren Sie ein Entlüftungsloch. Entlüftungslöcher unter %3 Breite werden vielleicht nicht erkannt.</translation>
    </message>
    <message>
        <source>The film grows by %1 % in all; more than %2 % is unusual. Check this value.</source>
        <translation>Der Film wächst insgesamt um %1 %; mehr als %2 % ist unüblich. Prüfen Sie diesen Wert.</translation>
    </message>
    <message>
        <source>The film grows by %1 % per second; more than %2 % is unusual. Check this value.</source>
        <translation>Der Film wächst um %1 % je Sekunde; mehr als %2 % ist unüblich. Prüfen Sie diesen Wert.</translation>
    </message>
    <message>
        <source>The dip speed is %1 mm/s; the usual range is %2 to %3 mm/s. Check this value.</source>
        <translation>Die Tauchgeschwindigkeit ist %1 mm/s; üblich sind %2 bis %3 mm/s. Prüfen Sie diesen Wert.</translation>
    </message>
    <message>
        <source>The path lifts the part again by more than %1 % of its depth. Film that the part carries out of the water is not simulated. Lower the part without lifting it, or make a test dip.</source>
        <translation>Der Weg hebt das Teil wieder um mehr als %1 % seiner Tiefe. Film, den das Teil aus dem Wasser zieht, wird nicht simuliert. Senken Sie das Teil, ohne es zu heben, oder machen Sie einen Tauchvorgang zur Probe.</translation>
    </message>
    <message>
        <source>Ink now: %1</source>
        <translation>Farbe jetzt: %1</translation>
    </message>
    <message>
        <source>A second dip may help, too.</source>
        <translation>Auch ein zweiter Tauchvorgang kann helfen.</translation>
    </message>
    <message>
        <source>The film tears, and up to %1 % of the surface that it should paint stays bare; the limit is %2 %. Turn the part, or use a film that stretches more.</source>
        <translation>Der Film reißt, und bis zu %1 % der Fläche, die er bedrucken soll, bleiben frei; die Grenze ist %2 %. Drehen Sie das Teil oder nehmen Sie einen Film, der sich weiter dehnt.</translation>
    </message>
    <message>
        <source>The film tore or was released on %1 % of the painted area; the limit is %2 %. Turn the part.</source>
        <translation>Der Film riss oder löste sich auf %1 % der bemalten Fläche; die Grenze ist %2 %. Drehen Sie das Teil.</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area; the limit is %2. Turn the part, or set much smaller cells or more points (Film &gt; Resolution).</source>
        <translation>Numerischer Fehler: höchstens %1 auf 95 % der bemalten Fläche; die Grenze ist %2. Drehen Sie das Teil oder setzen Sie viel kleinere Zellen oder mehr Punkte (Film &gt; Auflösung).</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area; the limit is %2. Turn the part.</source>
        <translation>Numerischer Fehler: höchstens %1 auf 95 % der bemalten Fläche; die Grenze ist %2. Drehen Sie das Teil.</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area; the limit is %2. Set cells of %3 (Film &gt; Resolution &gt; Cell size), or turn the part.</source>
        <translation>Numerischer Fehler: höchstens %1 auf 95 % der bemalten Fläche; die Grenze ist %2. Setzen Sie Zellen von %3 (Film &gt; Auflösung &gt; Zellgröße) oder drehen Sie das Teil.</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area; the limit is %2. Set more points (Film &gt; Points), or turn the part.</source>
        <translation>Numerischer Fehler: höchstens %1 auf 95 % der bemalten Fläche; die Grenze ist %2. Setzen Sie mehr Punkte (Film &gt; Punkte) oder drehen Sie das Teil.</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Nicht beurteilt</translation>
    </message>
    <message>
        <source>Print it</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Do not print</source>
        <translation>Nicht drucken</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Zone %1: %2</source>
        <translation>Zone %1: %2</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The numerical error was not estimated.</source>
        <translation>Der numerische Fehler wurde nicht geschätzt.</translation>
    </message>
    <message>
        <source>The numerical error could not be estimated: %1.</source>
        <translation>Der numerische Fehler ließ sich nicht schätzen: %1.</translation>
    </message>
    <message>
        <source>The model has no texture and no artwork: one plain colour is printed.</source>
        <translation>Das Modell hat weder Textur noch Gestaltung: Gedruckt wird eine einzige Farbe.</translation>
    </message>
    <message>
        <source>Model: %1</source>
        <translation>Modell: %1</translation>
    </message>
    <message>
        <source>The film&apos;s swell is guessed, not measured: the picture may be a few per cent too large or too small. Measure the film.</source>
        <translation>Die Quellung des Films ist geschätzt, nicht gemessen: Das Bild kann einige Prozent zu groß oder zu klein sein. Messen Sie den Film.</translation>
    </message>
    <message>
        <source>Check these places first</source>
        <translation>Diese Stellen zuerst prüfen</translation>
    </message>
    <message>
        <source>The numerical error may exceed %2 on %1 % of the painted area. Check the places that the program lists.</source>
        <translation>Der numerische Fehler kann auf %1 % der bemalten Fläche größer als %2 sein. Prüfen Sie die Stellen, die das Programm auflistet.</translation>
    </message>
    <message>
        <source>The film does not paint the part. Check the model&apos;s unit, its place over the film, and the depth of the dip.</source>
        <translation>Der Film bemalt das Teil nicht. Prüfen Sie die Einheit des Modells, seinen Platz über dem Film und die Tauchtiefe.</translation>
    </message>
    <message>
        <source>%1 % of the painted area will be too pale; the limit is %2 %. The film stretches more than the ink limit (Ink &gt; Ink limit) can compensate. Turn the part, or choose lighter colours.</source>
        <translation>%1 % der bemalten Fläche werden zu blass; die Grenze ist %2 %. Der Film dehnt sich mehr, als das Tintenlimit (Farbe &gt; Tintenlimit) ausgleichen kann. Drehen Sie das Teil oder wählen Sie hellere Farben.</translation>
    </message>
    <message>
        <source>%1 % of the part is painted by neither dip; the limit is %2 %. Turn the part in one of the dips.</source>
        <translation>%1 % des Teils werden von keinem Tauchvorgang bemalt; die Grenze ist %2 %. Drehen Sie das Teil in einem der Tauchvorgänge.</translation>
    </message>
    <message>
        <source>%1 % of the overlap is too narrow; the limit is %2 %. A small placement error of the second film shows there. Widen the overlap (Seam &gt; Overlap), or turn the part in one of the dips.</source>
        <translation>%1 % der Überlappung sind zu schmal; die Grenze ist %2 %. Dort ist ein kleiner Lagefehler des zweiten Films zu sehen. Verbreitern Sie die Überlappung (Naht &gt; Überlappung) oder drehen Sie das Teil in einem der Tauchvorgänge.</translation>
    </message>
    <message>
        <source>%1: numerical error up to %3; the limit is %2</source>
        <translation>%1: numerischer Fehler bis zu %3; die Grenze ist %2</translation>
    </message>
    <message>
        <source>%1 % of the zone is not painted; the limit is %2 %. Turn the part so that film reaches it.</source>
        <translation>%1 % der Zone sind nicht bemalt; die Grenze ist %2 %. Drehen Sie das Teil so, dass Film die Zone erreicht.</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area; the limit is %2. Most of this error comes from the length of the steps: set a smaller step (Dipping &gt; Step).</source>
        <translation>Numerischer Fehler: höchstens %1 auf 95 % der bemalten Fläche; die Grenze ist %2. Der größte Teil dieses Fehlers kommt von der Länge der Schritte: Setzen Sie einen kleineren Schritt (Tauchen &gt; Schritt).</translation>
    </message>
    <message>
        <source>Film that paints the part lies only %1 from the film&apos;s edge; at least %2 are required. Use a larger film, or move the part to the film&apos;s centre.</source>
        <translation>Film, der das Teil bemalt, liegt nur %1 vom Rand des Films entfernt; mindestens %2 sind nötig. Nehmen Sie einen größeren Film oder rücken Sie das Teil in die Mitte des Films.</translation>
    </message>
    <message>
        <source>The numerical error is not known, because this dip and the coarser dips for comparison paint no place in common. Set smaller cells (Film &gt; Resolution).</source>
        <translation>Der numerische Fehler ist unbekannt, weil dieser Tauchvorgang und die gröberen Tauchvorgänge zum Vergleich keine gemeinsame Stelle bemalen. Setzen Sie kleinere Zellen (Film &gt; Auflösung).</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area.</source>
        <translation>Numerischer Fehler: höchstens %1 auf 95 % der bemalten Fläche.</translation>
    </message>
    <message>
        <source>The border of the painted area is uncertain: with other cells or steps, %1 % of the part changes between painted and unpainted. Set smaller cells (Film &gt; Resolution).</source>
        <translation>Der Rand der bemalten Fläche ist unsicher: Mit anderen Zellen oder Schritten wechseln %1 % des Teils zwischen bemalt und unbemalt. Setzen Sie kleinere Zellen (Film &gt; Auflösung).</translation>
    </message>
    <message>
        <source>In %1 steps of the dip, the film did not converge; the residual force was up to %2 % of the elastic force. Set smaller cells (Film &gt; Resolution).</source>
        <translation>In %1 Schritten des Tauchvorgangs konvergierte der Film nicht; die Restkraft betrug bis zu %2 % der elastischen Kraft. Setzen Sie kleinere Zellen (Film &gt; Auflösung).</translation>
    </message>
    <message>
        <source>This verdict is expected: the run repeats the dip with film cells of %1 and judges it again.</source>
        <translation>Dieses Urteil ist erwartet: Der Lauf wiederholt den Tauchvorgang mit Filmzellen von %1 und urteilt neu.</translation>
    </message>
    <message>
        <source>Handling and numerical error together: at most ±%1 on 95 % of the painted area; the limit is ±%2. Reduce the largest cause that the results list under Tolerances, or turn the part.</source>
        <translation>Handhabung und numerischer Fehler zusammen: höchstens ±%1 auf 95 % der bemalten Fläche; die Grenze ist ±%2. Verringern Sie die größte Ursache, die die Ergebnisse unter „Toleranzen“ nennen, oder drehen Sie das Teil.</translation>
    </message>
    <message>
        <source>The dip paints only %1 % of the part; the limit is %2 %. Check the depth and the pose.</source>
        <translation>Der Tauchvorgang bemalt nur %1 % des Teils; die Grenze ist %2 %. Prüfen Sie die Tiefe und die Lage.</translation>
    </message>
    <message>
        <source>Both dips print %1 % of the part at full strength, so these places become too dark. Split the part between the dips (share.enabled).</source>
        <translation>Beide Tauchvorgänge drucken %1 % des Teils mit voller Stärke, sodass diese Stellen zu dunkel werden. Teilen Sie das Teil zwischen den Tauchvorgängen auf (share.enabled).</translation>
    </message>
    <message>
        <source>The sheet has no ink: its picture is white or transparent. Check the texture and the artwork.</source>
        <translation>Das Blatt enthält keine Farbe: Sein Bild ist weiß oder durchsichtig. Prüfen Sie die Textur und die Gestaltung.</translation>
    </message>
    <message>
        <source>On the part&apos;s own colour, the picture keeps only %1 % of its contrast; at least %2 % are required. Coat the part, print a white layer under the colours, or correct the part colour.</source>
        <translation>Auf der Eigenfarbe des Teils behält das Bild nur %1 % seines Kontrasts; mindestens %2 % sind nötig. Grundieren Sie das Teil, drucken Sie eine weiße Schicht unter die Farben, oder berichtigen Sie die Farbe des Teils.</translation>
    </message>
    <message>
        <source>It is not known whether the measured parts by which the sheet is corrected were dipped with the present pose, film, process and model. Check this, or turn the correction off (As built).</source>
        <translation>Es ist nicht bekannt, ob die gemessenen Teile, nach denen das Blatt korrigiert wird, mit der jetzigen Lage, dem jetzigen Film, Prozess und Modell getaucht wurden. Prüfen Sie das, oder schalten Sie die Korrektur aus (Gefertigt).</translation>
    </message>
    <message>
        <source>The sheet is not corrected, because all measured parts were dipped with another pose, film, process or model. Measure a part of the present dip, or turn the correction off (As built).</source>
        <translation>Das Blatt wird nicht korrigiert, weil alle gemessenen Teile mit anderer Lage, anderem Film, Prozess oder Modell getaucht wurden. Messen Sie ein Teil des jetzigen Tauchvorgangs, oder schalten Sie die Korrektur aus (Gefertigt).</translation>
    </message>
    <message>
        <source>The sheet is corrected without %1 of %2 measured parts, which were dipped with another pose, film, process or model.</source>
        <translation>Das Blatt wird ohne %1 von %2 gemessenen Teilen korrigiert, die mit anderer Lage, anderem Film, Prozess oder Modell getaucht wurden.</translation>
    </message>
    <message>
        <source>%1: the film did not converge there</source>
        <translation>%1: der Film konvergierte dort nicht</translation>
    </message>
    <message>
        <source>Masks cover everything that the film would paint. Remove a mask, or turn the part so that the film reaches other places.</source>
        <translation>Masken bedecken alles, was der Film bemalen würde. Entfernen Sie eine Maske, oder drehen Sie das Teil so, dass der Film andere Stellen erreicht.</translation>
    </message>
    <message>
        <source>Artwork hides the amounts of ink in the model&apos;s texture, so its colours are printed instead. To print the amounts, put the artwork into the texture.</source>
        <translation>Die Gestaltung verdeckt die Tintenmengen in der Textur des Modells, deshalb werden ihre Farben gedruckt. Um die Tintenmengen zu drucken, übernehmen Sie die Gestaltung in die Textur.</translation>
    </message>
    <message>
        <source>%1: the slow speed is %2 mm/s; the usual range is %3 to %4 mm/s. Check this value.</source>
        <translation>%1: Die langsame Geschwindigkeit ist %2 mm/s; üblich sind %3 bis %4 mm/s. Prüfen Sie diesen Wert.</translation>
    </message>
    <message>
        <source>The numerical error of %1 % of the painted area is unknown, because film with larger cells or steps does not reach it; the limit is %2 %. Set smaller cells (Film &gt; Resolution), or turn the part.</source>
        <translation>Der numerische Fehler ist auf %1 % der bemalten Fläche unbekannt, weil Film mit größeren Zellen oder Schritten sie nicht erreicht; die Grenze ist %2 %. Setzen Sie kleinere Zellen (Film &gt; Auflösung) oder drehen Sie das Teil.</translation>
    </message>
    <message>
        <source>Half of the overlap is at most %1 wide instead of %2, because the two films do not overlap farther there.</source>
        <translation>Die Hälfte der Überlappung ist höchstens %1 breit statt %2, weil die beiden Filme dort nicht weiter überlappen.</translation>
    </message>
    <message>
        <source>%1 % of the area that seam marks give to one dip is painted by the other dip. Film does not reach it there, or the marks are too small. Turn the part, or change the marks.</source>
        <translation>%1 % der Fläche, die Nahtmarken dem einen Tauchvorgang zuweisen, bemalt der andere. Der Film erreicht sie dort nicht, oder die Marken sind zu klein. Drehen Sie das Teil, oder ändern Sie die Marken.</translation>
    </message>
    <message>
        <source>%1: the part moves at %2 mm/s on its path; the usual range is %3 to %4 mm/s. Check the times of the poses.</source>
        <translation>%1: Das Teil bewegt sich auf seiner Bahn mit %2 mm/s; üblich sind %3 bis %4 mm/s. Prüfen Sie die Zeiten der Posen.</translation>
    </message>
    <message>
        <source>%1 more bodies</source>
        <translation>%1 weitere Körper</translation>
    </message>
    <message>
        <source>Only %1 % is painted; the limit is %2 %. Move or turn the body, dip deeper, or set smaller cells if it is small. If it is to stay bare, mask it.</source>
        <translation>Nur %1 % sind bemalt; die Grenze ist %2 %. Verschieben oder drehen Sie den Körper, tauchen Sie tiefer, oder setzen Sie kleinere Zellen, wenn er klein ist. Wenn er frei bleiben soll, maskieren Sie ihn.</translation>
    </message>
</context>
<context>
    <name>VerdictPanel</name>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Places to check in %1:</source>
        <translation>Zu prüfende Stellen in %1:</translation>
    </message>
    <message>
        <source>Before the last changes</source>
        <translation>Vor den letzten Änderungen</translation>
    </message>
</context>
<context>
    <name>ZoneAppearance</name>
    <message>
        <source>Zone %1, ±%2 mm</source>
        <translation>Zone %1, ±%2 mm</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Nicht bemalt</translation>
    </message>
    <message>
        <source>Pale: well within the limit</source>
        <translation>Blass: deutlich innerhalb der Grenze</translation>
    </message>
    <message>
        <source>Above the limit</source>
        <translation>Über der Grenze</translation>
    </message>
</context>
<context>
    <name>dipwright::Artwork</name>
    <message>
        <source>The picture of the layer “%1”</source>
        <translation>Das Bild der Ebene „%1“</translation>
    </message>
    <message>
        <source>The artwork already has %1 layers, which is the limit; remove one</source>
        <translation>Die Gestaltung hat schon %1 Ebenen, mehr sind nicht möglich; entfernen Sie eine</translation>
    </message>
    <message>
        <source>The font %2 of the text “%1” is not installed on this computer, so another font replaces it; install it, or choose an installed font</source>
        <translation>Die Schrift %2 des Textes „%1“ ist auf diesem Rechner nicht installiert und wird durch eine andere ersetzt; installieren Sie sie, oder wählen Sie eine installierte Schrift</translation>
    </message>
    <message>
        <source>The model has no face or material of this name; its names are %1</source>
        <translation>Das Modell hat keine Fläche und kein Material dieses Namens; seine Namen sind %1</translation>
    </message>
    <message>
        <source>No installed font has the characters %2 of the text “%1”, so boxes are printed; install a font that has them</source>
        <translation>Keine installierte Schrift hat die Zeichen %2 des Textes „%1“, daher werden Kästchen gedruckt; installieren Sie eine passende Schrift</translation>
    </message>
    <message>
        <source>The layer “%1” is %2 mm long, but a turn around its axis is only %3 mm, so its sides are cut off; make it smaller</source>
        <translation>Die Ebene „%1“ ist %2 mm lang, aber eine Umdrehung um ihre Achse nur %3 mm, daher sind ihre Seiten abgeschnitten; machen Sie sie kleiner</translation>
    </message>
    <message>
        <source>The layers “%1” and “%2” use the ink %3 with different colours or printing orders. It is printed with the colour and order of “%1”. Give both layers the same colour and order</source>
        <translation>Die Ebenen „%1“ und „%2“ verwenden die Farbe %3 mit verschiedenen Farbtönen oder Druckreihenfolgen. Gedruckt wird mit Farbton und Reihenfolge von „%1“. Geben Sie beiden Ebenen denselben Farbton und dieselbe Reihenfolge</translation>
    </message>
    <message>
        <source>The layer “%1” ends where another body of the model covers the surface, so about %2 % of it is missing; join the bodies in a modelling program, or place the layer along an axis</source>
        <translation>Die Ebene „%1“ endet dort, wo ein anderer Körper des Modells die Oberfläche verdeckt, daher fehlen etwa %2 % von ihr; vereinigen Sie die Körper in einem Modellierprogramm, oder platzieren Sie die Ebene längs einer Achse</translation>
    </message>
</context>
<context>
    <name>dipwright::ArtworkController</name>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Carbon</source>
        <translation>Carbon</translation>
    </message>
    <message>
        <source>Camouflage</source>
        <translation>Tarnmuster</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Holz</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Reading the picture</source>
        <translation>Bild wird gelesen</translation>
    </message>
    <message>
        <source>Change layer</source>
        <translation>Ebene ändern</translation>
    </message>
    <message>
        <source>Change base colour</source>
        <translation>Grundfarbe ändern</translation>
    </message>
    <message>
        <source>Add picture</source>
        <translation>Bild hinzufügen</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>Ebene verschieben</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>Turn layer</source>
        <translation>Ebene drehen</translation>
    </message>
    <message>
        <source>Resize layer</source>
        <translation>Größe der Ebene ändern</translation>
    </message>
</context>
<context>
    <name>dipwright::ArtworkPage</name>
    <message>
        <source>Carbon</source>
        <translation>Carbon</translation>
    </message>
    <message>
        <source>Camouflage</source>
        <translation>Tarnmuster</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Holz</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the layer (Delete)</source>
        <translation>Entfernt die Ebene (Entf)</translation>
    </message>
    <message>
        <source>Base colour</source>
        <translation>Grundfarbe</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Light colour</source>
        <translation>Helle Farbe</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>As a decal</source>
        <translation>Als Abziehbild</translation>
    </message>
    <message>
        <source>Along an axis</source>
        <translation>Längs einer Achse</translation>
    </message>
    <message>
        <source>From six sides</source>
        <translation>Von sechs Seiten</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Add &amp;picture…</source>
        <translation>&amp;Bild hinzufügen …</translation>
    </message>
    <message>
        <source>Places a picture on the part. You can also drop a picture on the part in the view.</source>
        <translation>Legt ein Bild auf das Teil. Sie können auch ein Bild auf das Teil in der Ansicht ziehen.</translation>
    </message>
    <message>
        <source>Add &amp;text</source>
        <translation>&amp;Text hinzufügen</translation>
    </message>
    <message>
        <source>Add p&amp;attern</source>
        <translation>&amp;Muster hinzufügen</translation>
    </message>
    <message>
        <source>Layers, top layer first</source>
        <translation>Ebenen, die oberste zuerst</translation>
    </message>
    <message>
        <source>The layers, top layer first. The tick shows or hides a layer, a double click renames it. Delete removes it, Ctrl+Up and Ctrl+Down move it.</source>
        <translation>Die Ebenen, die oberste zuerst. Das Häkchen blendet eine Ebene ein oder aus, ein Doppelklick benennt sie um. Entf entfernt sie, Strg+Auf und Strg+Ab verschieben sie.</translation>
    </message>
    <message>
        <source>Moves the layer up (Ctrl+Up)</source>
        <translation>Verschiebt die Ebene nach oben (Strg+Auf)</translation>
    </message>
    <message>
        <source>Moves the layer down (Ctrl+Down)</source>
        <translation>Verschiebt die Ebene nach unten (Strg+Ab)</translation>
    </message>
    <message>
        <source>Each number gives a different pattern of the same kind.</source>
        <translation>Jede Zahl ergibt ein anderes Muster derselben Art.</translation>
    </message>
    <message>
        <source>At 100 % the layer hides everything below it.</source>
        <translation>Bei 100 % verdeckt die Ebene alles darunter.</translation>
    </message>
    <message>
        <source>Spot colour</source>
        <translation>Sonderfarbe</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Display colour</source>
        <translation>Anzeigefarbe</translation>
    </message>
    <message>
        <source>On the outside</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Platzierung</translation>
    </message>
    <message>
        <source>Around an axis</source>
        <translation>Um eine Achse</translation>
    </message>
    <message>
        <source>The layer fits into this width and height and keeps its proportions.</source>
        <translation>Die Ebene passt in diese Breite und Höhe und behält ihre Proportionen.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Counterclockwise, seen from outside.</source>
        <translation>Gegen den Uhrzeigersinn, von außen gesehen.</translation>
    </message>
    <message>
        <source>Repeat width</source>
        <translation>Breite der Wiederholung</translation>
    </message>
    <message>
        <source>no repeat</source>
        <translation>keine Wiederholung</translation>
    </message>
    <message>
        <source>Centre X</source>
        <translation>Mitte X</translation>
    </message>
    <message>
        <source>Centre Y</source>
        <translation>Mitte Y</translation>
    </message>
    <message>
        <source>Centre Z</source>
        <translation>Mitte Z</translation>
    </message>
    <message>
        <source>colours of the model</source>
        <translation>Farben des Modells</translation>
    </message>
    <message>
        <source>The name of a varnish or special ink, as the printer knows it. In CMYK PDF and TIFF files the layer then becomes a plate of its own. The plate uses the layer&apos;s shape and opacity, not its colours.</source>
        <translation>Der Name eines Lacks oder einer Sonderfarbe, wie der Drucker ihn kennt. In CMYK-PDF- und -TIFF-Dateien wird die Ebene dann zu einer eigenen Druckplatte. Die Platte übernimmt Form und Deckkraft der Ebene, nicht ihre Farben.</translation>
    </message>
    <message>
        <source>If ticked, this ink prints before the four process inks and ends up on the outside of the part, like a varnish. Otherwise it prints after the process inks and lies next to the part.</source>
        <translation>Mit Häkchen druckt diese Farbe vor den vier Prozessfarben und liegt außen auf dem Teil, wie ein Lack. Sonst druckt sie nach den Prozessfarben und liegt direkt auf dem Teil.</translation>
    </message>
    <message>
        <source>A decal keeps lengths and straight lines around its centre. The other placements suit patterns that cover the whole part.</source>
        <translation>Ein Abziehbild behält um seine Mitte Längen und gerade Linien. Die anderen Platzierungen eignen sich für Muster, die das ganze Teil bedecken.</translation>
    </message>
    <message>
        <source>The width of one repeat on the part. Around an axis, the width is adjusted so that a whole number of repeats fits.</source>
        <translation>Die Breite einer Wiederholung auf dem Teil. Um eine Achse wird die Breite so angepasst, dass eine ganze Zahl von Wiederholungen passt.</translation>
    </message>
    <message>
        <source>The layer&apos;s centre in the model&apos;s coordinates. A decal is centred at the nearest place on the surface.</source>
        <translation>Die Mitte der Ebene in den Koordinaten des Modells. Ein Abziehbild liegt an der nächsten Stelle der Oberfläche.</translation>
    </message>
    <message>
        <source>The colour below all layers. White: no ink is printed. Without a base colour the model keeps its own colours.</source>
        <translation>Die Farbe unter allen Ebenen. Weiß: Es wird keine Farbe gedruckt. Ohne Grundfarbe behält das Modell seine eigenen Farben.</translation>
    </message>
    <message>
        <source>Programs and printers that do not know the spot colour use this colour instead.</source>
        <translation>Programme und Drucker, die die Sonderfarbe nicht kennen, verwenden stattdessen diese Farbe.</translation>
    </message>
    <message>
        <source>Printed size</source>
        <translation>Gedruckte Größe</translation>
    </message>
    <message>
        <source>The size of the layer on the part. It keeps its proportions, so it can be smaller than the width and height above.</source>
        <translation>Die Größe der Ebene auf dem Teil. Sie behält ihre Proportionen und kann deshalb kleiner sein als die Breite und Höhe darüber.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Only on</source>
        <translation>Nur auf</translation>
    </message>
    <message>
        <source>whole part</source>
        <translation>ganzem Teil</translation>
    </message>
    <message>
        <source>The face of the CAD model, or the material, on which the layer shows. A decal moves to its middle.</source>
        <translation>Die Fläche des CAD-Modells oder das Material, auf dem die Ebene erscheint. Ein Abziehbild rückt in die Mitte der Fläche.</translation>
    </message>
</context>
<context>
    <name>dipwright::ArtworkPainter</name>
    <message>
        <source>Painting the artwork</source>
        <translation>Gestaltung wird aufgetragen</translation>
    </message>
</context>
<context>
    <name>dipwright::BodyHandles</name>
    <message>
        <source>Turn part</source>
        <translation>Teil drehen</translation>
    </message>
    <message>
        <source>Change depth</source>
        <translation>Tiefe ändern</translation>
    </message>
    <message>
        <source>Move part</source>
        <translation>Teil verschieben</translation>
    </message>
    <message>
        <source>Turned by %1° about %2 (type an angle, or hold Shift for steps of %3°)</source>
        <translation>Um %1° um %2 gedreht (Winkel eingeben, oder mit Umschalt in Schritten von %3°)</translation>
    </message>
    <message>
        <source>Moved to %1 along %2 (type a distance, or hold Shift for steps of %3)</source>
        <translation>Auf %1 längs %2 verschoben (Abstand eingeben, oder mit Umschalt in Schritten von %3)</translation>
    </message>
    <message>
        <source>Depth %1 (type a distance, or hold Shift for steps of %2)</source>
        <translation>Tiefe %1 (Abstand eingeben, oder mit Umschalt in Schritten von %2)</translation>
    </message>
</context>
<context>
    <name>dipwright::BodyMenu</name>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Drehen</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Verschieben</translation>
    </message>
    <message>
        <source>Mark this face as &amp;zone A</source>
        <translation>Diese Fläche als &amp;Zone A markieren</translation>
    </message>
    <message>
        <source>Turn part</source>
        <translation>Teil drehen</translation>
    </message>
    <message>
        <source>Move part</source>
        <translation>Teil verschieben</translation>
    </message>
    <message>
        <source>Turn this face &amp;down</source>
        <translation>Diese Fläche nach &amp;unten drehen</translation>
    </message>
    <message>
        <source>Turn a face down</source>
        <translation>Fläche nach unten drehen</translation>
    </message>
    <message>
        <source>Mask this face, so that it &amp;stays free of film</source>
        <translation>Diese Fläche maskieren, damit sie &amp;frei von Film bleibt</translation>
    </message>
</context>
<context>
    <name>dipwright::BodyShare</name>
    <message>
        <source>Splitting the part between the dips</source>
        <translation>Das Teil wird auf die Tauchvorgänge aufgeteilt</translation>
    </message>
</context>
<context>
    <name>dipwright::Budgets</name>
    <message>
        <source>A face of the model has more than %1 corners; cut it into triangles in a modelling program</source>
        <translation>Eine Fläche des Modells hat mehr als %1 Ecken; zerlegen Sie sie in einem Modellierprogramm in Dreiecke</translation>
    </message>
    <message>
        <source>The model refers to more than %1 other files; reduce their number</source>
        <translation>Das Modell verweist auf mehr als %1 andere Dateien; verringern Sie ihre Zahl</translation>
    </message>
    <message>
        <source>The model has more than %1 materials; reduce their number</source>
        <translation>Das Modell hat mehr als %1 Materialien; verringern Sie ihre Zahl</translation>
    </message>
    <message>
        <source>The file is not opened, because it contains more than %1 entries; ask its author for another file</source>
        <translation>Die Datei wird nicht geöffnet, weil sie mehr als %1 Einträge enthält; bitten Sie den Urheber um eine andere Datei</translation>
    </message>
    <message>
        <source>project.json is larger than %1 MB and is not read; ask the project&apos;s author for another file</source>
        <translation>project.json ist größer als %1 MB und wird nicht gelesen; bitten Sie den Urheber des Projekts um eine andere Datei</translation>
    </message>
    <message>
        <source>The file is not read, because its values are nested more than %1 levels deep; ask its author for another file</source>
        <translation>Die Datei wird nicht gelesen, weil ihre Werte tiefer als %1 Ebenen verschachtelt sind; bitten Sie den Urheber um eine andere Datei</translation>
    </message>
    <message>
        <source>The file is not read, because it contains more than %1 million values; ask its author for another file</source>
        <translation>Die Datei wird nicht gelesen, weil sie mehr als %1 Millionen Werte enthält; bitten Sie den Urheber um eine andere Datei</translation>
    </message>
    <message>
        <source>The project contains more than %1 MB of files that do not belong to it; remove them with an archive program</source>
        <translation>Das Projekt enthält mehr als %1 MB an Dateien, die nicht zu ihm gehören; entfernen Sie diese mit einem Archivprogramm</translation>
    </message>
    <message>
        <source>The file is larger than %1 MB; make it smaller</source>
        <translation>Die Datei ist größer als %1 MB; verkleinern Sie sie</translation>
    </message>
    <message>
        <source>The model has more than %1 million triangles, which is the limit for a file of its size; reduce their number</source>
        <translation>Das Modell hat mehr als %1 Millionen Dreiecke; das ist die Grenze für eine Datei dieser Größe. Verringern Sie ihre Zahl</translation>
    </message>
    <message>
        <source>The model cannot be read: its objects are nested more than %1 levels deep; merge them in a modelling program</source>
        <translation>Das Modell kann nicht gelesen werden: Seine Objekte sind tiefer als %1 Ebenen verschachtelt; vereinigen Sie sie in einem Modellierprogramm</translation>
    </message>
    <message>
        <source>The file is not opened, because it would take more than %1 MB after unpacking, far too much for its size; ask its author for another file</source>
        <translation>Die Datei wird nicht geöffnet, weil sie nach dem Entpacken mehr als %1 MB belegen würde, viel zu viel für ihre Größe; bitten Sie den Urheber um eine andere Datei</translation>
    </message>
    <message>
        <source>The picture is more than %1 pixels wide or high; make it smaller</source>
        <translation>Das Bild ist mehr als %1 Pixel breit oder hoch; verkleinern Sie es</translation>
    </message>
    <message>
        <source>The pictures have more than %1 million pixels in total, too many for a file of this size; reduce the pictures in width and height</source>
        <translation>Die Bilder haben insgesamt mehr als %1 Millionen Pixel, zu viele für eine Datei dieser Größe; verringern Sie Breite und Höhe der Bilder</translation>
    </message>
    <message>
        <source>Reading the file takes more than %1 MB of memory, far too much for its size; make the file smaller, or save it again in the program that created it</source>
        <translation>Die Datei zu lesen braucht mehr als %1 MB Speicher, viel zu viel für ihre Größe; verkleinern Sie die Datei, oder speichern Sie sie in dem Programm neu, das sie erzeugt hat</translation>
    </message>
    <message>
        <source>Reading the file takes more than %1 seconds, far too long for its size; make the file smaller, or save it again in the program that created it</source>
        <translation>Die Datei zu lesen dauert länger als %1 Sekunden, viel zu lange für ihre Größe; verkleinern Sie die Datei, oder speichern Sie sie in dem Programm neu, das sie erzeugt hat</translation>
    </message>
    <message>
        <source>The CAD model has more than %1 faces; save only the part that is dipped, without its inner parts</source>
        <translation>Das CAD-Modell hat mehr als %1 Flächen; speichern Sie nur das Teil, das getaucht wird, ohne innere Teile</translation>
    </message>
    <message>
        <source>The CAD model would have more than %1 million triangles; choose a larger tolerance for its triangles</source>
        <translation>Das CAD-Modell hätte mehr als %1 Millionen Dreiecke; wählen Sie eine größere Toleranz der Dreiecke</translation>
    </message>
    <message>
        <source>Reading the CAD file takes more than %1 MB of memory; choose a larger tolerance for its triangles, or save only the part that is dipped</source>
        <translation>Das Lesen der CAD-Datei braucht mehr als %1 MB Speicher; wählen Sie eine größere Toleranz der Dreiecke, oder speichern Sie nur das Teil, das getaucht wird</translation>
    </message>
    <message>
        <source>Reading the CAD file takes more than %1 seconds; choose a larger tolerance for its triangles, or save only the part that is dipped</source>
        <translation>Das Lesen der CAD-Datei dauert länger als %1 Sekunden; wählen Sie eine größere Toleranz der Dreiecke, oder speichern Sie nur das Teil, das getaucht wird</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltController</name>
    <message>
        <source>Computing the repeating error</source>
        <translation>Wiederkehrender Fehler wird berechnet</translation>
    </message>
    <message>
        <source>As built</source>
        <translation>Gefertigt</translation>
    </message>
    <message>
        <source>Measuring the error on the sheet</source>
        <translation>Fehler auf dem Blatt wird gemessen</translation>
    </message>
    <message>
        <source>Keep part</source>
        <translation>Teil behalten</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltPage</name>
    <message>
        <source>&amp;Correct the next sheets</source>
        <translation>Nächste Blätter &amp;korrigieren</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Accepted by</source>
        <translation>Abgenommen von</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>Strength of the correction</source>
        <translation>Stärke der Korrektur</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Tauchvorgang</translation>
    </message>
    <message>
        <source>Dip %1</source>
        <translation>Tauchvorgang %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>The repeating error of the parts is shown here.</source>
        <translation>Hier ist der wiederkehrende Fehler der Teile zu sehen.</translation>
    </message>
    <message>
        <source>Repeating error and correction</source>
        <translation>Wiederkehrender Fehler und Korrektur</translation>
    </message>
    <message>
        <source>Measured parts of the job</source>
        <translation>Gemessene Teile des Auftrags</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Name of the person who accepts the part</source>
        <translation>Name der Person, die das Teil abnimmt</translation>
    </message>
    <message>
        <source>&amp;Keep part</source>
        <translation>Teil &amp;behalten</translation>
    </message>
    <message>
        <source>Stores the measured error of this part with the job</source>
        <translation>Speichert den gemessenen Fehler dieses Teils beim Auftrag</translation>
    </message>
    <message>
        <source>Shifts the image on the next sheets so that it cancels the repeating error</source>
        <translation>Verschiebt das Bild auf den nächsten Blättern so, dass der wiederkehrende Fehler verschwindet</translation>
    </message>
    <message>
        <source>How much of the repeating error the next sheets correct</source>
        <translation>Wie viel des wiederkehrenden Fehlers die nächsten Blätter korrigieren</translation>
    </message>
    <message>
        <source>The picture shows how the next sheets are corrected.</source>
        <translation>Das Bild zeigt, wie die nächsten Blätter korrigiert werden.</translation>
    </message>
    <message>
        <source>Root mean square of the part&apos;s error, measured on the sheet</source>
        <translation>Quadratisches Mittel des Fehlers des Teils, auf dem Blatt gemessen</translation>
    </message>
    <message>
        <source>The correction is off. The picture shows how it would change the next sheets.</source>
        <translation>Die Korrektur ist aus. Das Bild zeigt, wie sie die nächsten Blätter ändern würde.</translation>
    </message>
    <message>
        <source>“Keep part” stores in the project: the error of this part, the checksums of its photos and the name of the person who accepts it.</source>
        <translation>„Teil behalten“ speichert im Projekt: den Fehler dieses Teils, die Prüfsummen seiner Fotos und den Namen der Person, die es abnimmt.</translation>
    </message>
    <message>
        <source>To keep a part, first find its corners on the page “Dipped part”. The places of the pairs must lie on the part itself, not on the print.</source>
        <translation>Um ein Teil zu behalten, suchen Sie zuerst seine Ecken auf der Seite „Getauchtes Teil“. Die Stellen der Paare müssen auf dem Teil selbst liegen, nicht auf dem Druck.</translation>
    </message>
    <message>
        <source>Name of the person</source>
        <translation>Name der Person</translation>
    </message>
    <message>
        <source>Times at the tank</source>
        <translation>Zeiten am Becken</translation>
    </message>
    <message>
        <source>At the tank</source>
        <translation>Am Becken</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Geplant</translation>
    </message>
    <message>
        <source>Took</source>
        <translation>Gedauert</translation>
    </message>
    <message>
        <source>Mean of all runs, and the shortest and longest run</source>
        <translation>Mittel aller Durchgänge, und der kürzeste und der längste Durchgang</translation>
    </message>
    <message>
        <source>Dip %1: %2</source>
        <translation>Tauchvorgang %1: %2</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>only dip %1</source>
        <translation>nur Tauchvorgang %1</translation>
    </message>
    <message>
        <source>Dips as now</source>
        <translation>Wie jetzt</translation>
    </message>
    <message>
        <source>Whether the part was dipped with the present pose, film, process and model. The next sheets are corrected without dips of which this is not so.</source>
        <translation>Ob das Teil mit der jetzigen Lage, dem jetzigen Film, Prozess und Modell getaucht wurde. Die nächsten Blätter werden ohne die Tauchvorgänge korrigiert, bei denen das nicht so ist.</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltPlaces</name>
    <message>
        <source>None of the measured places lies on film that adheres to the part; check that the photos show a part of this job</source>
        <translation>Keine der gemessenen Stellen liegt auf Film, der am Teil haftet; prüfen Sie, ob die Fotos ein Teil dieses Auftrags zeigen</translation>
    </message>
    <message>
        <source>The job can keep at most %1 parts and %2 places; this part would exceed the limit</source>
        <translation>Der Auftrag kann höchstens %1 Teile und %2 Stellen behalten; dieses Teil würde die Grenze überschreiten</translation>
    </message>
    <message>
        <source>The job already contains the part in these photos; a part may be added only once</source>
        <translation>Der Auftrag enthält das Teil auf diesen Fotos schon; ein Teil darf nur einmal hinzugefügt werden</translation>
    </message>
    <message>
        <source>they fit if sheet_y_mm has the other sign: it increases downwards on the floating sheet, ink side up</source>
        <translation>sie passen mit umgekehrtem Vorzeichen von sheet_y_mm: es wächst auf dem schwimmenden Blatt, Farbseite oben, nach unten</translation>
    </message>
    <message>
        <source>they fit if sheet_x_mm has the other sign: it increases rightwards on the floating sheet, ink side up</source>
        <translation>sie passen mit umgekehrtem Vorzeichen von sheet_x_mm: es wächst auf dem schwimmenden Blatt, Farbseite oben, nach rechts</translation>
    </message>
    <message>
        <source>they fit if sheet_x_mm and sheet_y_mm have the other sign</source>
        <translation>sie passen mit umgekehrten Vorzeichen von sheet_x_mm und sheet_y_mm</translation>
    </message>
    <message>
        <source>they fit if sheet_x_mm and sheet_y_mm are swapped</source>
        <translation>sie passen, wenn sheet_x_mm und sheet_y_mm vertauscht werden</translation>
    </message>
    <message>
        <source>they fit if they are counted from the sheet&apos;s top left corner; count them from its middle</source>
        <translation>sie passen, wenn sie von der linken oberen Ecke des Blatts gezählt sind; zählen Sie von seiner Mitte</translation>
    </message>
    <message>
        <source>they fit if they are counted from the sheet&apos;s bottom left corner; count them from its middle, downwards</source>
        <translation>sie passen, wenn sie von der linken unteren Ecke des Blatts gezählt sind; zählen Sie von seiner Mitte nach unten</translation>
    </message>
    <message>
        <source>check that they belong to this job and its present settings</source>
        <translation>prüfen Sie, ob sie zu diesem Auftrag und seinen jetzigen Einstellungen gehören</translation>
    </message>
    <message>
        <source>The simulation carries half of the printed places more than %1 mm away from their targets x_mm, y_mm, z_mm; %2</source>
        <translation>In der Simulation liegt die Hälfte der gedruckten Stellen mehr als %1 mm von ihren Zielen x_mm, y_mm, z_mm entfernt; %2</translation>
    </message>
    <message>
        <source>%1 of %2 places x_mm, y_mm, z_mm lie more than %3 mm from the surface of the job&apos;s model; check that the table belongs to this part, and is in millimetres and in the model&apos;s coordinates</source>
        <translation>%1 von %2 Stellen x_mm, y_mm, z_mm liegen mehr als %3 mm von der Oberfläche des Modells entfernt; prüfen Sie, ob die Tabelle zu diesem Teil gehört und in Millimetern und Koordinaten des Modells ist</translation>
    </message>
</context>
<context>
    <name>dipwright::CadModel</name>
    <message>
        <source>CAD file %1 in %2, faces: %3, tolerance of the triangles: %4 mm</source>
        <translation>CAD-Datei %1 in %2, Flächen: %3, Toleranz der Dreiecke: %4 mm</translation>
    </message>
    <message>
        <source>mm (its unit is unknown)</source>
        <translation>mm (ihre Einheit ist unbekannt)</translation>
    </message>
    <message>
        <source>Only a model from a CAD file (STEP, IGES) can be cut into other triangles; import such a file</source>
        <translation>Nur ein Modell aus einer CAD-Datei (STEP, IGES) kann in andere Dreiecke zerlegt werden; importieren Sie eine solche Datei</translation>
    </message>
</context>
<context>
    <name>dipwright::CalibrationDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Horizontal ruler</source>
        <translation>Waagerechtes Lineal</translation>
    </message>
    <message>
        <source>Vertical ruler</source>
        <translation>Senkrechtes Lineal</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Als PDF speichern …</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>1. Print the page</source>
        <translation>1. Seite drucken</translation>
    </message>
    <message>
        <source>P&amp;rofile</source>
        <translation>P&amp;rofil</translation>
    </message>
    <message>
        <source>Pr&amp;inter</source>
        <translation>Druc&amp;ker</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>P&amp;apier</translation>
    </message>
    <message>
        <source>&amp;Horizontal</source>
        <translation>&amp;Waagerecht</translation>
    </message>
    <message>
        <source>&amp;Vertical</source>
        <translation>&amp;Senkrecht</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Looking for printers</source>
        <translation>Drucker werden gesucht</translation>
    </message>
    <message>
        <source>X %1, Y %2</source>
        <translation>X %1, Y %2</translation>
    </message>
    <message>
        <source>Printing</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Printed on %1. Let it dry, then measure.</source>
        <translation>Gedruckt auf %1. Lassen Sie die Seite trocknen, dann messen Sie.</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Wrote %1. Print it at 100 %, without “fit to page”.</source>
        <translation>%1 geschrieben. Drucken Sie die Seite mit 100 %, ohne „An Seite anpassen“.</translation>
    </message>
    <message>
        <source>The measured length of the printed ruler, to 0.1 mm.</source>
        <translation>Die gemessene Länge des gedruckten Lineals, auf 0,1 mm.</translation>
    </message>
    <message>
        <source>Measure (no correction)</source>
        <translation>Messen (ohne Korrektur)</translation>
    </message>
    <message>
        <source>Verify (corrected by the profile)</source>
        <translation>Prüfen (durch das Profil korrigiert)</translation>
    </message>
    <message>
        <source>&amp;Print page</source>
        <translation>Seite &amp;drucken</translation>
    </message>
    <message>
        <source>&amp;Save scale to profile</source>
        <translation>Maßstab ins Profil &amp;übernehmen</translation>
    </message>
    <message>
        <source>Calibrate printer</source>
        <translation>Drucker kalibrieren</translation>
    </message>
    <message>
        <source>No printer set up</source>
        <translation>Kein Drucker eingerichtet</translation>
    </message>
    <message>
        <source>The profile that receives the scale. You can create profiles under “Profiles”.</source>
        <translation>Das Profil, das den Maßstab erhält. Neue Profile legen Sie unter „Profile“ an.</translation>
    </message>
    <message>
        <source>The paper in the printer.</source>
        <translation>Das Papier im Drucker.</translation>
    </message>
    <message>
        <source>Prints rulers without correction, for measuring.</source>
        <translation>Druckt Lineale ohne Korrektur, zum Messen.</translation>
    </message>
    <message>
        <source>2. Measure the rulers</source>
        <translation>2. Lineale messen</translation>
    </message>
    <message>
        <source>Save page</source>
        <translation>Seite speichern</translation>
    </message>
    <message>
        <source>The printers that are set up on this computer.</source>
        <translation>Die Drucker, die auf diesem Rechner eingerichtet sind.</translation>
    </message>
    <message>
        <source>Prints the same rulers with the correction. Each ruler must now have its nominal length.</source>
        <translation>Druckt dieselben Lineale mit der Korrektur. Jedes Lineal muss nun seine Solllänge haben.</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. Save the page as PDF and print it elsewhere, at 100 %.</source>
        <translation>Auf diesem Rechner ist kein Drucker eingerichtet. Speichern Sie die Seite als PDF und drucken Sie sie anderswo mit 100 %.</translation>
    </message>
    <message>
        <source>nominal length: %1 mm</source>
        <translation>Solllänge: %1 mm</translation>
    </message>
    <message>
        <source>Print the page. Measure both rulers from the first to the last line, to 0.1 mm. Type the lengths and save the scale. Then print the page again to verify the scale.</source>
        <translation>Drucken Sie die Seite. Messen Sie beide Lineale vom ersten bis zum letzten Strich auf 0,1 mm. Geben Sie die Längen ein und übernehmen Sie den Maßstab. Drucken Sie die Seite dann noch einmal, um den Maßstab zu prüfen.</translation>
    </message>
    <message>
        <source>Sent to the print queue of %1</source>
        <translation>An die Druckwarteschlange von %1 gesendet</translation>
    </message>
    <message>
        <source>%1 now has the scale X %2, Y %3. Print the page again to verify the scale.</source>
        <translation>%1 hat jetzt den Maßstab X %2, Y %3. Drucken Sie die Seite noch einmal, um den Maßstab zu prüfen.</translation>
    </message>
</context>
<context>
    <name>dipwright::CalibrationPage</name>
    <message>
        <source>Verification of the printer&apos;s scale</source>
        <translation>Prüfung des Druckermaßstabs</translation>
    </message>
    <message>
        <source>Calibration of the printer&apos;s scale</source>
        <translation>Kalibrierung des Druckermaßstabs</translation>
    </message>
    <message>
        <source>The calibration page cannot be written: %1</source>
        <translation>Die Kalibrierseite kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>From its first to its last line, the horizontal ruler must measure %1 mm and the vertical ruler %2 mm.</source>
        <translation>Vom ersten bis zum letzten Strich muss das waagerechte Lineal %1 mm und das senkrechte %2 mm messen.</translation>
    </message>
    <message>
        <source>If a ruler differs by more than 0.2 mm, calibrate the printer again.</source>
        <translation>Weicht ein Lineal um mehr als 0,2 mm ab, kalibrieren Sie den Drucker noch einmal.</translation>
    </message>
    <message>
        <source>Measure both rulers to 0.1 mm and enter the lengths in the printer&apos;s profile.</source>
        <translation>Messen Sie beide Lineale auf 0,1 mm und tragen Sie die Längen in das Profil des Druckers ein.</translation>
    </message>
    <message>
        <source>Scale correction: X %1, Y %2</source>
        <translation>Maßstabskorrektur: X %1, Y %2</translation>
    </message>
    <message>
        <source>No scale correction: X 1, Y 1</source>
        <translation>Keine Maßstabskorrektur: X 1, Y 1</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm is too small to calibrate a printer; use A5 or larger</source>
        <translation>Papier von %1 × %2 mm ist zu klein, um einen Drucker zu kalibrieren; verwenden Sie A5 oder größer</translation>
    </message>
    <message>
        <source>A ruler of %2 mm measures %1 mm, which differs by more than 10 %; switch off all scaling in the printer&apos;s settings, print the page again and measure again</source>
        <translation>Ein Lineal von %2 mm misst %1 mm und weicht damit um mehr als 10 % ab; schalten Sie jede Skalierung in den Einstellungen des Druckers ab, drucken Sie die Seite neu und messen Sie noch einmal</translation>
    </message>
</context>
<context>
    <name>dipwright::CompareWindow</name>
    <message>
        <source>What is shown</source>
        <translation>Was gezeigt wird</translation>
    </message>
    <message>
        <source>Stretch of the film</source>
        <translation>Dehnung des Films</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Film on the part</source>
        <translation>Film auf dem Teil</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Tauchvorgang</translation>
    </message>
    <message>
        <source>The dip that is shown</source>
        <translation>Der gezeigte Tauchvorgang</translation>
    </message>
    <message>
        <source>Dip %1</source>
        <translation>Tauchvorgang %1</translation>
    </message>
    <message>
        <source>Fit both parts into their views</source>
        <translation>Beide Teile in ihre Ansichten einpassen</translation>
    </message>
    <message>
        <source>Close the comparison (Escape)</source>
        <translation>Den Vergleich schließen (Escape)</translation>
    </message>
    <message>
        <source>Values of both states</source>
        <translation>Werte beider Zustände</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Difference on the sheet</source>
        <translation>Unterschied auf dem Blatt</translation>
    </message>
    <message>
        <source>What both views show: the lines of the film, its stretch, the painted area, or how far the image differs between the two states, on the part and on the second sheet</source>
        <translation>Was beide Ansichten zeigen: die Linien des Films, seine Dehnung, die bemalte Fläche, oder wie weit sich das Bild zwischen beiden Ständen unterscheidet, auf dem Teil und auf dem zweiten Blatt</translation>
    </message>
    <message>
        <source>Difference of the sheets</source>
        <translation>Unterschied der Blätter</translation>
    </message>
    <message>
        <source>Difference of each dip</source>
        <translation>Unterschied jedes Tauchvorgangs</translation>
    </message>
    <message>
        <source>Choose a dip to see the place where its sheets differ most</source>
        <translation>Wählen Sie einen Tauchvorgang, um die Stelle zu sehen, an der sich seine Blätter am meisten unterscheiden</translation>
    </message>
    <message>
        <source>95 % of the surface</source>
        <translation>95 % der Fläche</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source>Painted in both</source>
        <translation>In beiden bemalt</translation>
    </message>
    <message>
        <source>Painted in one</source>
        <translation>In einem bemalt</translation>
    </message>
    <message>
        <source>Comparing the sheets</source>
        <translation>Blätter werden verglichen</translation>
    </message>
    <message>
        <source>Difference on the part</source>
        <translation>Unterschied auf dem Teil</translation>
    </message>
    <message>
        <source>Difference on the sheet of “%1”</source>
        <translation>Unterschied auf dem Blatt von „%1“</translation>
    </message>
    <message>
        <source>Distance between the places of the flat film that colour a place of the part. Choose a dip in the table to see the place where it is largest.</source>
        <translation>Abstand der Stellen des flachen Films, die eine Stelle des Teils bemalen. Wählen Sie in der Tabelle einen Tauchvorgang, um die Stelle zu sehen, an der er am größten ist.</translation>
    </message>
</context>
<context>
    <name>dipwright::CradleView</name>
    <message>
        <source>Making the cradle</source>
        <translation>Die Halterung wird hergestellt</translation>
    </message>
    <message>
        <source>Show cradle</source>
        <translation>Halterung zeigen</translation>
    </message>
</context>
<context>
    <name>dipwright::DeeperFilm</name>
    <message>
        <source>Deeper dip</source>
        <translation>Tieferer Tauchvorgang</translation>
    </message>
    <message>
        <source>Simulating a deeper dip</source>
        <translation>Tieferer Tauchvorgang wird simuliert</translation>
    </message>
</context>
<context>
    <name>dipwright::DipCacheUpdater</name>
    <message>
        <source>Reading cached results</source>
        <translation>Zwischengespeicherte Ergebnisse werden gelesen</translation>
    </message>
    <message>
        <source>Took the results from the cache file beside the project.</source>
        <translation>Die Ergebnisse stammen aus der Cache-Datei neben dem Projekt.</translation>
    </message>
</context>
<context>
    <name>dipwright::DipController</name>
    <message>
        <source>Simulated with %1 on %2</source>
        <translation>Simuliert mit „%1“ auf %2</translation>
    </message>
    <message>
        <source>The results are out of date; run the dip again first.</source>
        <translation>Die Ergebnisse sind veraltet; starten Sie zuerst das Tauchen neu.</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Tauchvorgang</translation>
    </message>
    <message>
        <source>Use film %1</source>
        <translation>Film %1 verwenden</translation>
    </message>
    <message>
        <source>Out of date: new results are being computed.</source>
        <translation>Veraltet: Neue Ergebnisse werden berechnet.</translation>
    </message>
    <message>
        <source>Sheet out of date: made before the last changes.</source>
        <translation>Blatt veraltet: vor den letzten Änderungen berechnet.</translation>
    </message>
    <message>
        <source>Results out of date: made before the last changes.</source>
        <translation>Ergebnisse veraltet: vor den letzten Änderungen berechnet.</translation>
    </message>
    <message>
        <source>being refined</source>
        <translation>wird verfeinert</translation>
    </message>
    <message>
        <source>The dip can be played when the running job has ended.</source>
        <translation>Der Tauchvorgang kann abgespielt werden, wenn der laufende Auftrag zu Ende ist.</translation>
    </message>
    <message>
        <source>Draft with %1 × %2 film points</source>
        <translation>Entwurf, %1 × %2 Punkte</translation>
    </message>
    <message>
        <source>95 % of the sheet within about %1</source>
        <translation>95 % des Blatts auf etwa %1 genau</translation>
    </message>
    <message>
        <source>run the dip before printing</source>
        <translation>vor dem Drucken den Tauchvorgang starten</translation>
    </message>
    <message>
        <source>The saved results contain no recording of the dip. The dip is simulated again so that you can play it; the results stay the same.</source>
        <translation>Die gespeicherten Ergebnisse enthalten keine Aufzeichnung des Tauchvorgangs. Er wird noch einmal simuliert, damit Sie ihn abspielen können; die Ergebnisse bleiben gleich.</translation>
    </message>
    <message>
        <source>Refining to reduce the numerical error. Cancel keeps this result.</source>
        <translation>Wird verfeinert, um den numerischen Fehler zu verringern. Abbrechen behält dieses Ergebnis.</translation>
    </message>
    <message>
        <source>The numerical error is larger than wanted. Run the dip again to refine the film.</source>
        <translation>Der numerische Fehler ist größer als gewünscht. Führen Sie den Tauchvorgang noch einmal aus, um den Film zu verfeinern.</translation>
    </message>
</context>
<context>
    <name>dipwright::DipScene</name>
    <message>
        <source>Mask: stays free of film</source>
        <translation>Maske: bleibt frei von Film</translation>
    </message>
</context>
<context>
    <name>dipwright::DipView</name>
    <message>
        <source>The 3D view needs OpenGL 3.2, which could not be started. Update the graphics driver. Everything else works.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.2, das sich nicht starten ließ. Aktualisieren Sie den Grafiktreiber. Alles andere geht.</translation>
    </message>
</context>
<context>
    <name>dipwright::DistanceField</name>
    <message>
        <source>The distance field&apos;s resolution is %1; choose 32 to 512</source>
        <translation>Die Auflösung des Abstandsfelds ist %1; wählen Sie 32 bis 512</translation>
    </message>
    <message>
        <source>Building the distance field</source>
        <translation>Abstandsfeld wird gebaut</translation>
    </message>
    <message>
        <source>The size of the model is zero; choose a model with a surface</source>
        <translation>Die Größe des Modells ist null; wählen Sie ein Modell mit einer Oberfläche</translation>
    </message>
</context>
<context>
    <name>dipwright::Document</name>
    <message>
        <source>The project is open elsewhere (%1); choose another name</source>
        <translation>Das Projekt ist anderswo geöffnet (%1); wählen Sie einen anderen Namen</translation>
    </message>
</context>
<context>
    <name>dipwright::DocumentController</name>
    <message>
        <source>an unknown machine</source>
        <translation>einem unbekannten Rechner</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>Ü&amp;berschreiben</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Project in use</source>
        <translation>Projekt in Benutzung</translation>
    </message>
    <message>
        <source>“%1” is already open on %2 (process %3).</source>
        <translation>„%1“ ist bereits auf %2 geöffnet (Prozess %3).</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Trotzdem öffnen</translation>
    </message>
    <message>
        <source>Project changed by another program</source>
        <translation>Projekt von einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>Another program has saved “%1” since you opened it.</source>
        <translation>Ein anderes Programm hat „%1“ gespeichert, seit Sie es geöffnet haben.</translation>
    </message>
    <message>
        <source>Save under another name to keep both versions. If you overwrite the file, the changes of the other program are lost.</source>
        <translation>Speichern Sie unter einem anderen Namen, um beide Fassungen zu behalten. Beim Überschreiben gehen die Änderungen des anderen Programms verloren.</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to “%1” before closing it?</source>
        <translation>Die Änderungen an „%1“ vor dem Schließen speichern?</translation>
    </message>
    <message>
        <source>No recent projects</source>
        <translation>Keine zuletzt geöffneten Projekte</translation>
    </message>
    <message>
        <source>%1 is a picture. Open a project first, then drop the picture to use it as the texture.</source>
        <translation>%1 ist ein Bild. Öffnen Sie zuerst ein Projekt und ziehen Sie das Bild dann hinein, um es als Textur zu verwenden.</translation>
    </message>
    <message>
        <source>%1 is not a project, model or picture</source>
        <translation>%1 ist weder Projekt noch Modell noch Bild</translation>
    </message>
    <message>
        <source>If both programs save the project, the one that saves second asks which version to keep.</source>
        <translation>Wenn beide Programme das Projekt speichern, fragt das zweite, welche Fassung bleiben soll.</translation>
    </message>
    <message>
        <source>The file of this project no longer exists: %1. Save the project to write it again.</source>
        <translation>Die Datei dieses Projekts gibt es nicht mehr: %1. Speichern Sie das Projekt, um sie neu zu schreiben.</translation>
    </message>
    <message>
        <source>The file of “%1” no longer exists. Save the project before closing it?</source>
        <translation>Die Datei von „%1“ gibt es nicht mehr. Das Projekt vor dem Schließen speichern?</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>“%1” is being saved. The window closes when the project is saved.</source>
        <translation>„%1“ wird gespeichert. Das Fenster schließt sich, wenn das Projekt gespeichert ist.</translation>
    </message>
    <message>
        <source>If you cancel, the window stays open. The project is saved in any case.</source>
        <translation>Wenn Sie abbrechen, bleibt das Fenster offen. Das Projekt wird in jedem Fall gespeichert.</translation>
    </message>
</context>
<context>
    <name>dipwright::DocumentSession</name>
    <message>
        <source>Opening the project</source>
        <translation>Projekt wird geöffnet</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 geöffnet</translation>
    </message>
    <message>
        <source>Restoring the project</source>
        <translation>Projekt wird wiederhergestellt</translation>
    </message>
    <message>
        <source>Restored unsaved changes of %1</source>
        <translation>Nicht gespeicherte Änderungen von %1 wiederhergestellt</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>Restore project</source>
        <translation>Projekt wiederherstellen</translation>
    </message>
    <message>
        <source>Unsaved changes would be lost in a crash, because the recovery copy cannot be written. Save often. %1</source>
        <translation>Ungespeicherte Änderungen gingen bei einem Absturz verloren, weil die Sicherungskopie nicht geschrieben werden kann. Speichern Sie oft. %1</translation>
    </message>
    <message>
        <source>Saving the project</source>
        <translation>Das Projekt wird gespeichert</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>dipwright::DrawnPage</name>
    <message>
        <source>The page cannot be written: %1</source>
        <translation>Die Seite kann nicht geschrieben werden: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::EditController</name>
    <message>
        <source>Replace model</source>
        <translation>Modell ersetzen</translation>
    </message>
    <message>
        <source>Replace texture</source>
        <translation>Textur ersetzen</translation>
    </message>
</context>
<context>
    <name>dipwright::ExportController</name>
    <message>
        <source>Wrote the results to %1</source>
        <translation>Ergebnisse nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>dehnung</translation>
    </message>
    <message>
        <source>Wrote the maps to %1</source>
        <translation>Karten nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Wrote the cradles to %1</source>
        <translation>Halterungen nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Export results to a folder</source>
        <translation>Ergebnisse in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Export results</source>
        <translation>Ergebnisse exportieren</translation>
    </message>
    <message>
        <source>Save sheet</source>
        <translation>Blatt speichern</translation>
    </message>
    <message>
        <source>Export cradles</source>
        <translation>Halterungen exportieren</translation>
    </message>
    <message>
        <source>Export cradles to a folder</source>
        <translation>Halterungen in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Export stretch</source>
        <translation>Dehnung exportieren</translation>
    </message>
    <message>
        <source>These sheets were made before the last changes to the project. Run the dip again to print the current state.</source>
        <translation>Diese Blätter entstanden vor den letzten Änderungen am Projekt. Starten Sie den Tauchvorgang neu, um den aktuellen Stand zu drucken.</translation>
    </message>
    <message>
        <source>Save maps</source>
        <translation>Karten speichern</translation>
    </message>
    <message>
        <source>Save costs</source>
        <translation>Kosten speichern</translation>
    </message>
    <message>
        <source>%1 costs</source>
        <translation>%1 Kosten</translation>
    </message>
    <message>
        <source>These sheets were made before the last changes to the project. Run the dip again to see the current state.</source>
        <translation>Diese Blätter stammen aus der Zeit vor den letzten Änderungen am Projekt. Rechnen Sie den Tauchvorgang neu, um den jetzigen Stand zu sehen.</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmFit</name>
    <message>
        <source>Fitted</source>
        <translation>Angepasst</translation>
    </message>
    <message>
        <source>%1, dip %2</source>
        <translation>%1, Tauchvorgang %2</translation>
    </message>
    <message>
        <source>measure it at the tank and leave it out of the fit</source>
        <translation>messen Sie es am Becken und lassen Sie es aus der Anpassung</translation>
    </message>
    <message>
        <source>Swell along X</source>
        <translation>Quellung längs X</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxation</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wachstum</translation>
    </message>
    <message>
        <source>Contact distance</source>
        <translation>Kontaktabstand</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>The fit did not converge in %1 rounds; check for places that were mistaken for others, or fit fewer quantities</source>
        <translation>Die Anpassung ist in %1 Runden nicht konvergiert; prüfen Sie auf verwechselte Stellen, oder passen Sie weniger Größen an</translation>
    </message>
    <message>
        <source>The pairs do not determine any quantity of the film; give more pairs, all round the part</source>
        <translation>Die Paare bestimmen keine Größe des Films; geben Sie mehr Paare an, rund um das Teil</translation>
    </message>
    <message>
        <source>None of the printed places lies on the part in the simulation; check that they belong to this job&apos;s sheet</source>
        <translation>Keine der gedruckten Stellen liegt in der Simulation auf dem Teil; prüfen Sie, ob sie zum Blatt dieses Auftrags gehören</translation>
    </message>
    <message>
        <source>%1: %2 (before: %3; 95 % interval: %4)</source>
        <translation>%1: %2 (vorher: %3; 95-%-Intervall: %4)</translation>
    </message>
    <message>
        <source>%1 and %2 cannot be determined independently: correlation %3</source>
        <translation>%1 und %2 lassen sich nicht unabhängig voneinander bestimmen: Korrelation %3</translation>
    </message>
    <message>
        <source>%1 is not determined by these pairs and keeps its value</source>
        <translation>%1 ist durch diese Paare nicht bestimmt und behält den bisherigen Wert</translation>
    </message>
    <message>
        <source>give pairs of places all round the part</source>
        <translation>geben Sie Paare rund um das Teil an</translation>
    </message>
    <message>
        <source>photograph places near the part&apos;s lowest point and others high on its sides, from more than one direction</source>
        <translation>fotografieren Sie Stellen nahe dem tiefsten Punkt des Teils und andere weit oben an seinen Seiten, aus mehr als einer Richtung</translation>
    </message>
    <message>
        <source>measure growth from photos of the floating film with “inspect film”</source>
        <translation>messen Sie das Wachstum aus Fotos des schwimmenden Films mit „inspect film“</translation>
    </message>
    <message>
        <source>The project&apos;s film does not grow, so its growth cannot be fitted; measure it from photos of the floating film with “inspect film”</source>
        <translation>Der Film des Projekts wächst nicht, also lässt sich sein Wachstum nicht anpassen; messen Sie es aus Fotos des schwimmenden Films mit „inspect film“</translation>
    </message>
    <message>
        <source>%1 has no effect on this film and cannot be fitted</source>
        <translation>%1 hat auf diesen Film keine Wirkung und lässt sich nicht anpassen</translation>
    </message>
    <message>
        <source>%1 moves none of the places, so the pairs do not determine it; %2</source>
        <translation>%1 bewegt keine der Stellen, also bestimmen die Paare es nicht; %2</translation>
    </message>
    <message>
        <source>The pairs cannot separate %1 from the camera&apos;s position (correlation %2); %3</source>
        <translation>Die Paare können %1 nicht von der Position der Kamera trennen (Korrelation %2); %3</translation>
    </message>
    <message>
        <source>give more pairs on the part itself, farther apart</source>
        <translation>geben Sie mehr Paare am Teil selbst an, weiter auseinander</translation>
    </message>
    <message>
        <source>give pairs on the part itself (edges, corners or holes) with --pairs</source>
        <translation>geben Sie mit --pairs Paare am Teil selbst an (Kanten, Ecken oder Löcher)</translation>
    </message>
    <message>
        <source>The pairs cannot separate %1 from %2 (correlation %3); fit only one of the two, or %4</source>
        <translation>Die Paare können %1 nicht von %2 trennen (Korrelation %3); passen Sie nur eines von beiden an, oder %4</translation>
    </message>
    <message>
        <source>The pairs do not determine %1 well enough; give more pairs, or %2</source>
        <translation>Die Paare bestimmen %1 nicht gut genug; geben Sie mehr Paare an, oder %2</translation>
    </message>
    <message>
        <source>“%1” cannot be fitted; choose from %2</source>
        <translation>„%1“ lässt sich nicht anpassen; wählen Sie aus %2</translation>
    </message>
    <message>
        <source>A place belongs to dip %1, but the number of dips in the project is %2</source>
        <translation>Eine Stelle gehört zu Tauchvorgang %1, das Projekt hat aber nur so viele Tauchvorgänge: %2</translation>
    </message>
    <message>
        <source>Position of the part along X</source>
        <translation>Lage des Teils entlang X</translation>
    </message>
    <message>
        <source>Position of the part along Z</source>
        <translation>Lage des Teils entlang Z</translation>
    </message>
    <message>
        <source>Rotation of the part about Y</source>
        <translation>Drehung des Teils um Y</translation>
    </message>
    <message>
        <source>Root mean square distance between the simulated and the photographed print: %1 px (%2 mm) before the fit, %3 px (%4 mm) after it</source>
        <translation>Quadratisches Mittel des Abstands zwischen simuliertem und fotografiertem Druck: %1 px (%2 mm) vor der Anpassung, %3 px (%4 mm) danach</translation>
    </message>
    <message>
        <source>%1 is uncertain by about %2 %: a change by 10 % moves none of the places by more than %3 mm; give more pairs, or %4</source>
        <translation>%1 ist um etwa %2 % unsicher: Eine Änderung um 10 % bewegt keine der Stellen um mehr als %3 mm; geben Sie mehr Paare an, oder %4</translation>
    </message>
    <message>
        <source>There are too few pairs on the part to determine the %1 unknowns of film and camera; give more pairs, or fit fewer quantities</source>
        <translation>Es sind zu wenige Paare auf dem Teil, um die %1 Unbekannten von Film und Kamera zu bestimmen; geben Sie mehr Paare an, oder passen Sie weniger Größen an</translation>
    </message>
    <message>
        <source>The fit found no film and camera that explain the pairs; check whether a pair names the wrong place</source>
        <translation>Die Anpassung fand keinen Film und keine Kamera, die die Paare erklären; prüfen Sie, ob ein Paar die falsche Stelle nennt</translation>
    </message>
    <message>
        <source>Swell along Z</source>
        <translation>Quellung längs Z</translation>
    </message>
    <message>
        <source>The fit does not explain the places: their root mean square distance is %1 mm before the fit and %2 mm after it; check the coordinates of the sheet, and for places that were mistaken for others</source>
        <translation>Die Anpassung erklärt die Stellen nicht: Ihr mittlerer quadratischer Abstand ist vorher %1 mm und nachher %2 mm; prüfen Sie die Koordinaten des Blatts und ob Stellen verwechselt wurden</translation>
    </message>
    <message>
        <source>The film profile %1 has other values than the project&apos;s film, under which the values were fitted; compare the two before you use it</source>
        <translation>Das Filmprofil %1 hat andere Werte als der Film des Projekts, mit dem angepasst wurde; vergleichen Sie beide, bevor Sie es verwenden</translation>
    </message>
    <message>
        <source>The job&apos;s sheets are already corrected by its measured parts, so fitted values in the job would correct the same error twice; turn the correction off (As built) and fit a part whose sheet was not corrected</source>
        <translation>Die Blätter des Auftrags werden schon nach den gemessenen Teilen korrigiert, angepasste Werte im Auftrag würden denselben Fehler also zweimal korrigieren; schalten Sie die Korrektur aus (Gefertigt) und passen Sie ein Teil an, dessen Blatt nicht korrigiert war</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmPage</name>
    <message>
        <source>Unevenness of the film</source>
        <translation>Ungleichmäßigkeit des Films</translation>
    </message>
    <message>
        <source>Photos of the film</source>
        <translation>Fotos des Films</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source> °C</source>
        <translation> °C</translation>
    </message>
    <message>
        <source>Dip begins after</source>
        <translation>Tauchvorgang beginnt nach</translation>
    </message>
    <message>
        <source>Lot</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportieren …</translation>
    </message>
    <message>
        <source>Photos (%1)</source>
        <translation>Fotos (%1)</translation>
    </message>
    <message>
        <source>Seconds since the film was laid on the water</source>
        <translation>Sekunden, seit der Film auf das Wasser gelegt wurde</translation>
    </message>
    <message>
        <source>Photo of the film</source>
        <translation>Foto des Films</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Unevenness</source>
        <translation>Ungleichmäßigkeit</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Brennweite</translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation>Verzeichnung</translation>
    </message>
    <message>
        <source>k1 ?</source>
        <translation>k1 ?</translation>
    </message>
    <message>
        <source>k2 ?</source>
        <translation>k2 ?</translation>
    </message>
    <message>
        <source>Corners found in the photo are shown here.</source>
        <translation>Hier werden die im Foto gefundenen Ecken gezeigt.</translation>
    </message>
    <message>
        <source>Seconds on the water</source>
        <translation>Sekunden auf dem Wasser</translation>
    </message>
    <message>
        <source>Seconds from laying the film on the water to the start of the dip. The swell is computed for this time.</source>
        <translation>Sekunden vom Auflegen des Films auf das Wasser bis zum Beginn des Tauchvorgangs. Die Quellung wird für diesen Zeitpunkt berechnet.</translation>
    </message>
    <message>
        <source>from the photos</source>
        <translation>aus den Fotos</translation>
    </message>
    <message>
        <source>Rulers on the card</source>
        <translation>Lineale der Karte</translation>
    </message>
    <message>
        <source>Rulers on the dry film</source>
        <translation>Lineale, Film trocken</translation>
    </message>
    <message>
        <source>Reading error ±</source>
        <translation>Ablesefehler ±</translation>
    </message>
    <message>
        <source>Rulers and camera</source>
        <translation>Lineale und Kamera</translation>
    </message>
    <message>
        <source>Readings of the printed rulers, height of the card, and camera data</source>
        <translation>Ablesungen der gedruckten Lineale, Höhe der Karte und Daten der Kamera</translation>
    </message>
    <message>
        <source>Add &amp;photos…</source>
        <translation>&amp;Fotos hinzufügen …</translation>
    </message>
    <message>
        <source>&amp;Save to profile…</source>
        <translation>Im Profil &amp;speichern …</translation>
    </message>
    <message>
        <source>at the start of the dip</source>
        <translation>zu Beginn des Tauchvorgangs</translation>
    </message>
    <message>
        <source>%1: %2 corners on the film, %3 on the card, residual %4 px</source>
        <translation>%1: %2 Ecken auf dem Film, %3 auf der Karte, Restfehler %4 px</translation>
    </message>
    <message>
        <source>Water temperature</source>
        <translation>Wassertemperatur</translation>
    </message>
    <message>
        <source>Measured length of the horizontal ruler</source>
        <translation>Gemessene Länge des waagerechten Lineals</translation>
    </message>
    <message>
        <source>Measured length of the vertical ruler</source>
        <translation>Gemessene Länge des senkrechten Lineals</translation>
    </message>
    <message>
        <source>Reading error of each ruler. A larger reading error gives a wider 95 % interval of the swell.</source>
        <translation>Ablesefehler jedes Lineals. Ein größerer Ablesefehler ergibt ein breiteres 95-%-Intervall der Quellung.</translation>
    </message>
    <message>
        <source>Focal length of the lens as 35 mm equivalent. Needed only if the card lies above the film.</source>
        <translation>Brennweite des Objektivs als Kleinbildäquivalent. Nur nötig, wenn die Karte höher als der Film liegt.</translation>
    </message>
    <message>
        <source>Coefficients of the lens distortion of a calibrated camera. “?”: the coefficient is found from each photo.</source>
        <translation>Koeffizienten der Objektivverzeichnung einer kalibrierten Kamera. „?“: Der Koeffizient wird aus jedem Foto bestimmt.</translation>
    </message>
    <message>
        <source>The places where the film has grown more or less than on average are shown here.</source>
        <translation>Hier wird gezeigt, wo der Film mehr oder weniger als im Mittel gewachsen ist.</translation>
    </message>
    <message>
        <source>Card height above film</source>
        <translation>Karte über dem Film</translation>
    </message>
    <message>
        <source>Print the two pages, then add photos of the film&apos;s chessboard on the water with the card beside it, or drop them here. The guide explains how to take them.</source>
        <translation>Drucken Sie die zwei Seiten. Fügen Sie dann Fotos vom Schachbrett des Films auf dem Wasser mit der Karte daneben hinzu oder legen Sie sie hier ab. Das Handbuch erklärt, wie Sie fotografieren.</translation>
    </message>
    <message>
        <source>Temperature of the water. It is kept with the measurement and does not change it.</source>
        <translation>Temperatur des Wassers. Sie wird mit der Messung aufbewahrt und ändert diese nicht.</translation>
    </message>
    <message>
        <source>Number of the film&apos;s lot. It is kept with the measurement and printed on the pages.</source>
        <translation>Nummer der Charge des Films. Sie wird mit der Messung aufbewahrt und auf die Seiten gedruckt.</translation>
    </message>
    <message>
        <source>Pages to p&amp;rint…</source>
        <translation>Seiten zum D&amp;rucken …</translation>
    </message>
    <message>
        <source>Saves the chessboard for the film (film.pdf) and the card (card.pdf) to a folder. Print the film&apos;s page on the film and the card&apos;s page on stiff, waterproof cardboard, both at 100 %.</source>
        <translation>Speichert das Schachbrett für den Film (film.pdf) und die Karte (card.pdf) in einen Ordner. Drucken Sie die Seite für den Film auf den Film und die Karte auf steifen, wasserfesten Karton, beide mit 100 %.</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmProbe</name>
    <message>
        <source>on the water</source>
        <translation>auf dem Wasser</translation>
    </message>
    <message>
        <source>Part at %1, %2, %3</source>
        <translation>Teil bei %1, %2, %3</translation>
    </message>
    <message>
        <source>on the part</source>
        <translation>auf dem Teil</translation>
    </message>
    <message>
        <source>Sheet at %1, %2 · %3 · stretch %4 and %5, area stretch %6</source>
        <translation>Blatt bei %1, %2 · %3 · Dehnung %4 und %5, Flächendehnung %6</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmWatch</name>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>Unevenness: 95 % of the film lies within %1 mm of where an evenly swollen film would lie</source>
        <translation>Ungleichmäßigkeit: 95 % des Films liegen höchstens %1 mm von der Stelle entfernt, an der ein gleichmäßig gequollener Film läge</translation>
    </message>
    <message>
        <source>Unevenness of the film</source>
        <translation>Ungleichmäßigkeit des Films</translation>
    </message>
    <message>
        <source>95 % of the corners lie within %1 mm of an evenly swollen film</source>
        <translation>95 % der Ecken liegen höchstens %1 mm neben einem gleichmäßig gequollenen Film</translation>
    </message>
    <message>
        <source>The film&apos;s chessboard is mirrored; lay the film with its ink side up, and use the photo without flipping it</source>
        <translation>Das Schachbrett des Films ist gespiegelt; legen Sie den Film mit der Farbseite nach oben, und spiegeln Sie das Foto nicht</translation>
    </message>
    <message>
        <source>The card is mirrored; use the photo without flipping it</source>
        <translation>Die Karte ist gespiegelt; spiegeln Sie das Foto nicht</translation>
    </message>
    <message>
        <source>The photos show no measurable growth of the film</source>
        <translation>Die Fotos zeigen kein messbares Wachstum des Films</translation>
    </message>
    <message>
        <source>Growth: %1 ± %2 % per second</source>
        <translation>Wachstum: %1 ± %2 % pro Sekunde</translation>
    </message>
    <message>
        <source>Growth: %1 ± %2 % per second when the dip begins; %3 ± %4 % in total after a long time</source>
        <translation>Wachstum: %1 ± %2 % pro Sekunde zu Beginn des Tauchvorgangs; insgesamt %3 ± %4 % nach langer Zeit</translation>
    </message>
    <message>
        <source>The photo does not contain the camera&apos;s focal length, which is needed because the card lies above the film; give the 35 mm equivalent focal length</source>
        <translation>Das Foto enthält die Brennweite der Kamera nicht, die nötig ist, weil die Karte über dem Film liegt; geben Sie die Brennweite bezogen auf Kleinbild (35 mm) an</translation>
    </message>
    <message>
        <source>Too little of the film&apos;s chessboard is visible; photograph all of it, sharp and without glare</source>
        <translation>Vom Schachbrett des Films ist zu wenig zu sehen; fotografieren Sie es ganz, scharf und ohne Spiegelung</translation>
    </message>
    <message>
        <source>Only %1 corners of the film&apos;s chessboard are visible, but %2 are needed; photograph all of it, without glare</source>
        <translation>Nur %1 Ecken vom Schachbrett des Films sind zu sehen, aber %2 werden gebraucht; fotografieren Sie es ganz und ohne Spiegelung</translation>
    </message>
    <message>
        <source>Only %1 corners of the card are visible, but %2 are needed; photograph all of it, without glare</source>
        <translation>Nur %1 Ecken der Karte sind zu sehen, aber %2 werden gebraucht; fotografieren Sie sie ganz und ohne Spiegelung</translation>
    </message>
    <message>
        <source>The swell was measured after %1 s, but the dip begins after %2 s; this swell does not include the growth in between</source>
        <translation>Die Quellung wurde nach %1 s gemessen, aber der Tauchvorgang beginnt nach %2 s; diese Quellung enthält das Wachstum dazwischen nicht</translation>
    </message>
    <message>
        <source>The photos show the film from %1 to %2 s after it was laid on the water, but the dip begins after %3 s; correct the times, or take photos both before and after the start of the dip</source>
        <translation>Die Fotos zeigen den Film von %1 bis %2 s nach dem Auflegen, der Tauchvorgang beginnt aber nach %3 s; berichtigen Sie die Zeiten, oder nehmen Sie Fotos vor und nach dem Beginn des Tauchvorgangs auf</translation>
    </message>
    <message>
        <source>Growth is not measured; to measure it, take photos at three or more times, from before the dip begins until after it ends</source>
        <translation>Das Wachstum ist nicht gemessen; um es zu messen, nehmen Sie Fotos zu drei oder mehr Zeiten auf, von vor dem Beginn des Tauchvorgangs bis nach seinem Ende</translation>
    </message>
    <message>
        <source>The film still grew at the same rate in the last photo. Its growth limit is therefore unknown, and the growth in the profile stays unchanged. Take photos until the film stops growing</source>
        <translation>Auf dem letzten Foto wuchs der Film noch gleich schnell. Die Grenze seines Wachstums ist daher unbekannt, und das Wachstum im Profil bleibt unverändert. Fotografieren Sie, bis der Film nicht mehr wächst</translation>
    </message>
    <message>
        <source>No chessboard for measuring the film is visible; print one with “dipwright-cli calibrate film” and photograph all of it, sharp and without glare</source>
        <translation>Kein Schachbrett zum Messen des Films ist zu sehen; drucken Sie eines mit „dipwright-cli calibrate film“ und fotografieren Sie es ganz, scharf und ohne Spiegelung</translation>
    </message>
    <message>
        <source>The card that gives the scale is not visible; print it with “dipwright-cli calibrate card” and lay it beside the film</source>
        <translation>Die Karte, die den Maßstab gibt, ist nicht zu sehen; drucken Sie sie mit „dipwright-cli calibrate card“ und legen Sie sie neben den Film</translation>
    </message>
    <message>
        <source>The position of the film cannot be determined from the visible corners; photograph the whole film and the whole card from above</source>
        <translation>Aus den sichtbaren Ecken lässt sich die Lage des Films nicht bestimmen; fotografieren Sie den ganzen Film und die ganze Karte von oben</translation>
    </message>
    <message>
        <source>The card&apos;s corners lie %1 px from their places on a flat card; lay the card flat, and correct or clear the values for lens distortion, focal length and card height</source>
        <translation>Die Ecken der Karte liegen %1 px neben ihren Plätzen auf einer ebenen Karte; legen Sie die Karte eben hin, und berichtigen oder löschen Sie die Werte für Verzeichnung, Brennweite und Höhe der Karte</translation>
    </message>
    <message>
        <source>Swell when the dip begins: along X %1, along Z %2</source>
        <translation>Quellung zu Beginn des Tauchvorgangs: längs X %1, längs Z %2</translation>
    </message>
    <message>
        <source>In these photos the film shrinks by %1 % per second, but film grows on the water; check that the times are in the order of the photos</source>
        <translation>Auf diesen Fotos schrumpft der Film um %1 % pro Sekunde, Film wächst auf dem Wasser aber; prüfen Sie, ob die Zeiten in der Reihenfolge der Fotos stehen</translation>
    </message>
    <message>
        <source>The sizes of the film in these photos do not determine its growth; check that the times are in the order of the photos, and take photos from before the dip begins until the film stops growing</source>
        <translation>Die Größen des Films auf diesen Fotos bestimmen sein Wachstum nicht; prüfen Sie, ob die Zeiten in der Reihenfolge der Fotos stehen, und nehmen Sie Fotos von vor dem Beginn des Tauchvorgangs bis zum Ende des Wachstums auf</translation>
    </message>
    <message>
        <source>The photo is the same as %1; give each photo only once</source>
        <translation>Das Foto ist dasselbe wie %1; geben Sie jedes Foto nur einmal an</translation>
    </message>
    <message>
        <source>Colour: growth relative to the mean swell %1 · arrows: displacement, scale %2:1</source>
        <translation>Farbe: Wachstum gegenüber der mittleren Quellung %1 · Pfeile: Verschiebung, Maßstab %2:1</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmWatchController</name>
    <message>
        <source>Reading photos</source>
        <translation>Fotos werden gelesen</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>Measuring the film</source>
        <translation>Film wird gemessen</translation>
    </message>
    <message>
        <source>The project refers to these photos:</source>
        <translation>Das Projekt verweist auf diese Fotos:</translation>
    </message>
    <message>
        <source>Film on the water</source>
        <translation>Film auf Wasser</translation>
    </message>
    <message>
        <source>The photo %1 has changed since it was added.</source>
        <translation>Das Foto %1 hat sich geändert, seit es hinzugefügt wurde.</translation>
    </message>
    <message>
        <source>Export film measurement to a folder</source>
        <translation>Filmmessung in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Export film measurement</source>
        <translation>Filmmessung exportieren</translation>
    </message>
    <message>
        <source>Wrote the film measurement to %1</source>
        <translation>Filmmessung nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Save the pages for the film and the card to a folder</source>
        <translation>Die Seiten für Film und Karte in einen Ordner speichern</translation>
    </message>
    <message>
        <source>Save pages to print</source>
        <translation>Seiten zum Drucken speichern</translation>
    </message>
    <message>
        <source>Wrote film.pdf and card.pdf to %1. Print them at 100 %; the rulers must measure 100 mm.</source>
        <translation>film.pdf und card.pdf wurden in %1 gespeichert. Drucken Sie sie mit 100 %; die Lineale müssen 100 mm messen.</translation>
    </message>
</context>
<context>
    <name>dipwright::FinishedPartPreview</name>
    <message>
        <source>Computing the finished part</source>
        <translation>Fertiges Teil wird berechnet</translation>
    </message>
</context>
<context>
    <name>dipwright::FitController</name>
    <message>
        <source>Fitting film and dip</source>
        <translation>Film und Tauchvorgang werden angepasst</translation>
    </message>
    <message>
        <source>Wrote the fit to %1</source>
        <translation>Anpassung nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Use in project</source>
        <translation>Im Projekt verwenden</translation>
    </message>
    <message>
        <source>Export fit to a folder</source>
        <translation>Anpassung in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Export fit</source>
        <translation>Anpassung exportieren</translation>
    </message>
</context>
<context>
    <name>dipwright::FitPage</name>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportieren …</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>Fitted quantities</source>
        <translation>Angepasste Größen</translation>
    </message>
    <message>
        <source>Correlations of the fitted quantities</source>
        <translation>Korrelationen der angepassten Größen</translation>
    </message>
    <message>
        <source>&amp;Fit film and dip</source>
        <translation>Film und Tauchvorgang an&amp;passen</translation>
    </message>
    <message>
        <source>&amp;Use in project</source>
        <translation>Im Projekt &amp;verwenden</translation>
    </message>
    <message>
        <source>Puts the fitted film, placement and depth into the project. The film then counts as measured.</source>
        <translation>Übernimmt Film, Lage und Tiefe aus der Anpassung in das Projekt. Der Film gilt dann als gemessen.</translation>
    </message>
    <message>
        <source>&amp;Save to profile…</source>
        <translation>Im Profil &amp;speichern …</translation>
    </message>
    <message>
        <source>The project uses the film, placement and depth of this fit. To fit again, find the corners again.</source>
        <translation>Das Projekt verwendet Film, Lage und Tiefe dieser Anpassung. Um erneut anzupassen, suchen Sie die Ecken noch einmal.</translation>
    </message>
    <message>
        <source>First find the corners on the page “Dipped part”. Film and dip are fitted to them.</source>
        <translation>Suchen Sie zuerst die Ecken auf der Seite „Getauchtes Teil“. Film und Tauchvorgang werden an sie angepasst.</translation>
    </message>
    <message>
        <source>Fits placement, swell and relaxation, as far as the photos determine them.</source>
        <translation>Passt Lage, Quellung und Relaxation an, soweit die Fotos sie bestimmen.</translation>
    </message>
    <message>
        <source>Fitted</source>
        <translation>Angepasst</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95-%-Intervall</translation>
    </message>
    <message>
        <source>Near 1 or −1: the photos determine only a combination of the two quantities, not each quantity separately</source>
        <translation>Nahe 1 oder −1: Die Fotos bestimmen nur eine Kombination der beiden Größen, nicht jede einzeln</translation>
    </message>
    <message>
        <source>Changes the settings of film and dip and repeats the simulation until the simulated image lies where the photos show it</source>
        <translation>Ändert die Einstellungen von Film und Tauchvorgang und wiederholt die Simulation, bis das simulierte Bild dort liegt, wo die Fotos es zeigen</translation>
    </message>
    <message>
        <source>No pair is a place on the part itself, such as a corner or a hole. Without such pairs, a shift or rotation of the whole image looks the same as a movement of the camera.</source>
        <translation>Kein Paar ist eine Stelle auf dem Teil selbst, etwa eine Ecke oder ein Loch. Ohne solche Paare sieht eine Verschiebung oder Drehung des ganzen Bilds genauso aus wie eine Bewegung der Kamera.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
</context>
<context>
    <name>dipwright::GuidePictures</name>
    <message>
        <source>film.pdf
printed on the film</source>
        <translation>film.pdf
auf den Film gedruckt</translation>
    </message>
    <message>
        <source>card.pdf
printed on stiff, waterproof cardboard</source>
        <translation>card.pdf
auf steifen, wasserfesten Karton gedruckt</translation>
    </message>
    <message>
        <source>The card beside it, flat</source>
        <translation>Die Karte daneben, flach</translation>
    </message>
    <message>
        <source>From above, both whole, no glare</source>
        <translation>Von oben, beide ganz, ohne Spiegelung</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The rulers on both must measure 100 mm</source>
        <translation>Die Lineale auf beiden müssen 100 mm messen</translation>
    </message>
    <message>
        <source>The film, ink side up, as for a dip</source>
        <translation>Der Film, Farbe nach oben, wie zum Tauchen</translation>
    </message>
    <message>
        <source>Both at the same height: the card gives the scale</source>
        <translation>Beide auf einer Höhe: Die Karte gibt den Maßstab</translation>
    </message>
    <message>
        <source>Note the time when you lay the film</source>
        <translation>Notieren Sie, wann Sie den Film auflegen</translation>
    </message>
    <message>
        <source>One photo gives the swell, three or more give the growth</source>
        <translation>Ein Foto ergibt die Quellung, drei oder mehr das Wachstum</translation>
    </message>
    <message>
        <source>Take photos before the dip and until the film stops growing</source>
        <translation>Fotografieren Sie vor dem Tauchvorgang und bis der Film nicht mehr wächst</translation>
    </message>
</context>
<context>
    <name>dipwright::GuideWindow</name>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>User guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Press Enter to go to the next match</source>
        <translation>Die Eingabetaste geht zum nächsten Treffer</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Keine Treffer</translation>
    </message>
    <message>
        <source>Matches: %1</source>
        <translation>Treffer: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::HelpController</name>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>The project</source>
        <translation>Das Projekt</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>Die Ansicht</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>The timeline</source>
        <translation>Die Zeitleiste</translation>
    </message>
    <message>
        <source>The results</source>
        <translation>Die Ergebnisse</translation>
    </message>
    <message>
        <source>About Dipwright</source>
        <translation>Über Dipwright</translation>
    </message>
    <message>
        <source>Computational hydrographic printing.</source>
        <translation>Berechneter Wassertransferdruck.</translation>
    </message>
    <message>
        <source>Dipwright computes the image to print on a film. When the part is dipped through the film, every colour lands in its intended place.</source>
        <translation>Dipwright berechnet das Bild, das auf einen Film gedruckt wird. Wird das Teil durch den Film getaucht, landet jede Farbe an ihrem vorgesehenen Ort.</translation>
    </message>
    <message>
        <source>Model, film, one or two dips, sheet and ink. Select an entry in the tree and change its values below. To begin, drop a model on the window.</source>
        <translation>Modell, Film, ein oder zwei Tauchvorgänge, Blatt und Farbe. Wählen Sie einen Eintrag im Baum und ändern Sie darunter seine Werte. Ziehen Sie zu Beginn ein Modell auf das Fenster.</translation>
    </message>
    <message>
        <source>The part above the film. Drag to look at it from all sides, turn it with the rings, then press Run.</source>
        <translation>Das Teil über dem Film. Ziehen Sie, um es von allen Seiten zu sehen, drehen Sie es mit den Ringen und klicken Sie dann auf „Starten“.</translation>
    </message>
    <message>
        <source>Simulates the dip while you watch. You can cancel at any time. With “Run live”, each change recomputes the results that depend on it.</source>
        <translation>Simuliert den Tauchvorgang vor Ihren Augen. Sie können jederzeit abbrechen. Mit „Laufend neu rechnen“ berechnet jede Änderung die Ergebnisse neu, die von ihr abhängen.</translation>
    </message>
    <message>
        <source>Replays the dip or shows any moment of it.</source>
        <translation>Spielt den Tauchvorgang noch einmal ab oder zeigt einen beliebigen Augenblick.</translation>
    </message>
    <message>
        <source>The stretch of the film, the image on it, the finished part and the sheet to print. Move the cursor over one picture to see the same place in the others.</source>
        <translation>Die Dehnung des Films, das Bild darauf, das fertige Teil und das Blatt zum Drucken. Fahren Sie mit dem Zeiger über ein Bild, um dieselbe Stelle in den anderen zu sehen.</translation>
    </message>
    <message>
        <source>The report was copied to the clipboard</source>
        <translation>Der Bericht wurde in die Zwischenablage kopiert</translation>
    </message>
</context>
<context>
    <name>dipwright::Histogram</name>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
</context>
<context>
    <name>dipwright::ImportModel</name>
    <message>
        <source>Entities of the CAD file that cannot be read, so that faces or parts may be missing: %1</source>
        <translation>Elemente der CAD-Datei, die nicht gelesen werden können, sodass Flächen oder Teile fehlen können: %1</translation>
    </message>
    <message>
        <source>it is incomplete or damaged</source>
        <translation>sie ist unvollständig oder beschädigt</translation>
    </message>
    <message>
        <source>The model&apos;s blend shapes are not applied, so it has its shape without them; apply them in a modelling program</source>
        <translation>Die Blendshapes des Modells werden nicht angewendet, deshalb hat es seine Form ohne sie; wenden Sie sie in einem Modellierprogramm an</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Modell wird gelesen</translation>
    </message>
    <message>
        <source>The model&apos;s size must be more than 0 and at most %1 mm</source>
        <translation>Die Größe des Modells muss über 0 und höchstens %1 mm sein</translation>
    </message>
    <message>
        <source>The model&apos;s unit must be a positive number of millimetres</source>
        <translation>Die Einheit des Modells muss eine positive Zahl von Millimetern sein</translation>
    </message>
    <message>
        <source>The model file does not exist; check its name</source>
        <translation>Die Modelldatei gibt es nicht; prüfen Sie ihren Namen</translation>
    </message>
    <message>
        <source>This is a folder; choose a model file in it</source>
        <translation>Das ist ein Ordner; wählen Sie eine Modelldatei darin</translation>
    </message>
    <message>
        <source>The model file cannot be read; check its permissions</source>
        <translation>Die Modelldatei kann nicht gelesen werden; prüfen Sie ihre Zugriffsrechte</translation>
    </message>
    <message>
        <source>None of the model&apos;s triangles has an area; choose another model</source>
        <translation>Keines der Dreiecke des Modells hat eine Fläche; wählen Sie ein anderes Modell</translation>
    </message>
    <message>
        <source>The file %1, which the model names, was not found</source>
        <translation>Die Datei %1, die das Modell nennt, wurde nicht gefunden</translation>
    </message>
    <message>
        <source>The model has no triangles; save it with its surface</source>
        <translation>Das Modell hat keine Dreiecke; speichern Sie es mit seiner Oberfläche</translation>
    </message>
    <message>
        <source>Checking the model</source>
        <translation>Modell wird geprüft</translation>
    </message>
    <message>
        <source>Finding the texture&apos;s charts</source>
        <translation>Inseln der Textur werden gesucht</translation>
    </message>
    <message>
        <source>The texture %1 was not found beside the model; its material&apos;s colour is used instead</source>
        <translation>Die Textur %1 wurde neben dem Modell nicht gefunden; stattdessen wird die Farbe ihres Materials verwendet</translation>
    </message>
    <message>
        <source>it ends too early</source>
        <translation>es endet zu früh</translation>
    </message>
    <message>
        <source>there is a word where a number should be</source>
        <translation>wo eine Zahl stehen sollte, steht ein Wort</translation>
    </message>
    <message>
        <source>it is not a PLY file</source>
        <translation>es ist keine PLY-Datei</translation>
    </message>
    <message>
        <source>its PLY format %1 is unknown</source>
        <translation>sein PLY-Format %1 ist unbekannt</translation>
    </message>
    <message>
        <source>its header is not understood</source>
        <translation>sein Kopf ist unverständlich</translation>
    </message>
    <message>
        <source>its points have no x, y and z</source>
        <translation>seine Punkte haben kein x, y und z</translation>
    </message>
    <message>
        <source>its faces have no corners</source>
        <translation>seine Flächen haben keine Ecken</translation>
    </message>
    <message>
        <source>texture %1 in %2</source>
        <translation>Textur %1 in %2</translation>
    </message>
    <message>
        <source>Reading triangles</source>
        <translation>Dreiecke werden gelesen</translation>
    </message>
    <message>
        <source>it is not a 3MF package</source>
        <translation>es ist kein 3MF-Paket</translation>
    </message>
    <message>
        <source>its elements are out of order</source>
        <translation>seine Elemente sind in falscher Reihenfolge</translation>
    </message>
    <message>
        <source>there is no number where one should be</source>
        <translation>wo eine Zahl stehen sollte, steht keine</translation>
    </message>
    <message>
        <source>The texture %1 is not in the model&apos;s package; its material&apos;s colour is used instead</source>
        <translation>Die Textur %1 ist nicht im Paket des Modells; stattdessen wird die Farbe ihres Materials verwendet</translation>
    </message>
    <message>
        <source>The model has no texture coordinates, so no picture can be placed on it; unwrap it in a modelling program first</source>
        <translation>Das Modell hat keine Texturkoordinaten, daher lässt sich kein Bild darauf legen; wickeln Sie es erst in einem Modellierprogramm ab</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>die Datei kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Triangles without area that were removed: %1</source>
        <translation>Dreiecke ohne Fläche, die entfernt wurden: %1</translation>
    </message>
    <message>
        <source>its unit %1 is unknown</source>
        <translation>seine Einheit %1 ist unbekannt</translation>
    </message>
    <message>
        <source>its format is not supported</source>
        <translation>sein Format wird nicht unterstützt</translation>
    </message>
    <message>
        <source>line %1 declares more values than the file can hold</source>
        <translation>Zeile %1 gibt mehr Werte an, als die Datei enthalten kann</translation>
    </message>
    <message>
        <source>line %1 has no number where one is expected</source>
        <translation>in Zeile %1 fehlt eine Zahl</translation>
    </message>
    <message>
        <source>its array %1 has fewer values than an accessor reads</source>
        <translation>sein Array %1 hat weniger Werte, als ein Accessor liest</translation>
    </message>
    <message>
        <source>it needs the glTF extension %1, which is not supported (export it without that extension)</source>
        <translation>es braucht die glTF-Erweiterung %1, die nicht unterstützt wird (exportieren Sie es ohne diese Erweiterung)</translation>
    </message>
    <message>
        <source>its points or texture coordinates are stored as integers, which is not supported (export it with float coordinates, without quantization)</source>
        <translation>seine Punkte oder Texturkoordinaten sind als ganze Zahlen gespeichert, was nicht unterstützt wird (exportieren Sie es mit Gleitkomma-Koordinaten, ohne Quantisierung)</translation>
    </message>
    <message>
        <source>The model scales or rotates a texture (KHR_texture_transform), which is not shown correctly; apply the transform to the texture coordinates in a modelling program</source>
        <translation>Das Modell skaliert oder dreht eine Textur (KHR_texture_transform), was nicht richtig dargestellt wird; wenden Sie die Transformation in einem Modellierprogramm auf die Texturkoordinaten an</translation>
    </message>
    <message>
        <source>A texture of the model has no picture or is in an unsupported format, so its material&apos;s colour is used instead; export the texture as PNG or JPEG</source>
        <translation>Eine Textur des Modells hat kein Bild oder ein Format, das nicht unterstützt wird; stattdessen wird die Farbe ihres Materials verwendet; exportieren Sie die Textur als PNG oder JPEG</translation>
    </message>
    <message>
        <source>%1 sets material properties before its first material</source>
        <translation>%1 gibt Materialeigenschaften vor dem ersten Material an</translation>
    </message>
    <message>
        <source>Some texture options in %1 are ignored: %2; apply them to the picture in a modelling program</source>
        <translation>Einige Texturoptionen in %1 werden nicht berücksichtigt: %2; wenden Sie sie in einem Modellierprogramm auf das Bild an</translation>
    </message>
    <message>
        <source>it holds more data than its header declares</source>
        <translation>es enthält mehr Daten, als sein Kopf angibt</translation>
    </message>
    <message>
        <source>a face refers to a point that does not exist</source>
        <translation>eine Fläche verweist auf einen Punkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>The model&apos;s vertex colours are not used; bake them into a texture to print them</source>
        <translation>Die Vertexfarben des Modells werden nicht verwendet; backen Sie sie in eine Textur, um sie zu drucken</translation>
    </message>
    <message>
        <source>a triangle refers to a point that does not exist</source>
        <translation>ein Dreieck verweist auf einen Punkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>it needs the 3MF extension %1, which is not supported</source>
        <translation>es braucht die 3MF-Erweiterung %1, die nicht unterstützt wird</translation>
    </message>
    <message>
        <source>two of its resources have the ID %1</source>
        <translation>zwei seiner Ressourcen haben die ID %1</translation>
    </message>
    <message>
        <source>it refers to a material or texture that does not exist</source>
        <translation>es verweist auf ein Material oder eine Textur, die es nicht gibt</translation>
    </message>
    <message>
        <source>one of its transforms does not have twelve numbers</source>
        <translation>eine seiner Transformationen besteht nicht aus zwölf Zahlen</translation>
    </message>
    <message>
        <source>the file %1 is missing from the package</source>
        <translation>die Datei %1 fehlt im Paket</translation>
    </message>
    <message>
        <source>it places an object that does not exist</source>
        <translation>es platziert ein Objekt, das es nicht gibt</translation>
    </message>
    <message>
        <source>All points of the model coincide; choose another model</source>
        <translation>Alle Punkte des Modells fallen zusammen; wählen Sie ein anderes Modell</translation>
    </message>
    <message>
        <source>The model has no texture coordinates, so its texture cannot be placed; the colours of its materials are used instead</source>
        <translation>Das Modell hat keine Texturkoordinaten, daher kann seine Textur nicht aufgelegt werden; stattdessen werden die Farben seiner Materialien verwendet</translation>
    </message>
    <message>
        <source>The model needs more memory than this computer has; simplify the model</source>
        <translation>Das Modell braucht mehr Speicher, als dieser Rechner hat; vereinfachen Sie das Modell</translation>
    </message>
    <message>
        <source>Duplicate triangles that were removed: %1</source>
        <translation>Entfernte doppelte Dreiecke: %1</translation>
    </message>
    <message>
        <source>Triangles flipped to face the same way as their neighbours: %1</source>
        <translation>Gewendete Dreiecke, die anders herum lagen als ihre Nachbarn: %1</translation>
    </message>
    <message>
        <source>the length of a list is not a whole number</source>
        <translation>die Länge einer Liste ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>the file %1 in the package is encrypted</source>
        <translation>die Datei %1 im Paket ist verschlüsselt</translation>
    </message>
    <message>
        <source>the file %1 in the package is damaged</source>
        <translation>die Datei %1 im Paket ist beschädigt</translation>
    </message>
    <message>
        <source>the file %1 in the package has an error: %2</source>
        <translation>die Datei %1 im Paket hat einen Fehler: %2</translation>
    </message>
    <message>
        <source>The model&apos;s largest dimension would be %1 mm; set the size that it should have</source>
        <translation>Die größte Abmessung des Modells wäre %1 mm; geben Sie die Größe an, die es haben soll</translation>
    </message>
    <message>
        <source>The mesh is not closed, so the program can only estimate which points lie inside it; if the result looks wrong, close the mesh</source>
        <translation>Das Netz ist nicht geschlossen, daher kann das Programm nur schätzen, welche Punkte innen liegen; wenn das Ergebnis falsch aussieht, schließen Sie das Netz</translation>
    </message>
    <message>
        <source>The model&apos;s largest dimension is only %1 mm; if its file is not in millimetres, set the size that it should have</source>
        <translation>Die größte Abmessung des Modells ist nur %1 mm; wenn seine Datei nicht in Millimetern ist, geben Sie die Größe an, die es haben soll</translation>
    </message>
    <message>
        <source>The model was not read, because it names files that are hidden or outside its folder, such as %1; put these files beside the model, or allow them (--allow-outside)</source>
        <translation>Das Modell wurde nicht gelesen, weil es Dateien nennt, die versteckt sind oder außerhalb seines Ordners liegen, etwa %1; legen Sie diese Dateien neben das Modell, oder erlauben Sie sie (--allow-outside)</translation>
    </message>
    <message>
        <source>Points merged where rounded coordinates had left a gap: %1</source>
        <translation>Vereinigte Punkte, zwischen denen gerundete Koordinaten eine Lücke gelassen hatten: %1</translation>
    </message>
    <message>
        <source>Pieces of the surface flipped because they were inside out: %1</source>
        <translation>Gewendete Stücke der Oberfläche, die von innen nach außen gekehrt waren: %1</translation>
    </message>
    <message>
        <source>The model cannot be read: %1; save it again, or as %2</source>
        <translation>Das Modell kann nicht gelesen werden: %1; speichern Sie es neu oder als %2</translation>
    </message>
    <message>
        <source>The model file is empty; save it again</source>
        <translation>Die Modelldatei ist leer; speichern Sie sie neu</translation>
    </message>
    <message>
        <source>%1 corners of the model&apos;s triangles are not numbers (NaN or infinite); repair the model and save it again</source>
        <translation>%1 Ecken der Dreiecke des Modells sind keine Zahlen (NaN oder unendlich); reparieren Sie das Modell und speichern Sie es neu</translation>
    </message>
    <message>
        <source>The model lies too far from its origin; move it to the origin and save it again</source>
        <translation>Das Modell liegt zu weit von seinem Ursprung; schieben Sie es in den Ursprung und speichern Sie es neu</translation>
    </message>
    <message>
        <source>it has no surfaces</source>
        <translation>sie hat keine Flächen</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>sie ist beschädigt</translation>
    </message>
    <message>
        <source>it has no geometry</source>
        <translation>sie hat keine Geometrie</translation>
    </message>
    <message>
        <source>IGES cannot be read on Windows</source>
        <translation>IGES kann unter Windows nicht gelesen werden</translation>
    </message>
    <message>
        <source>The CAD file cannot be read: %1; save it again as STEP (AP214 or AP242) in the CAD program</source>
        <translation>Die CAD-Datei kann nicht gelesen werden: %1; speichern Sie sie im CAD-Programm noch einmal als STEP (AP214 oder AP242)</translation>
    </message>
    <message>
        <source>it is neither STEP nor IGES</source>
        <translation>sie ist weder STEP noch IGES</translation>
    </message>
    <message>
        <source>Reading the CAD file</source>
        <translation>Die CAD-Datei wird gelesen</translation>
    </message>
    <message>
        <source>its geometry is invalid (%1)</source>
        <translation>ihre Geometrie ist ungültig (%1)</translation>
    </message>
    <message>
        <source>Cutting the surfaces into triangles</source>
        <translation>Die Flächen werden in Dreiecke zerlegt</translation>
    </message>
    <message>
        <source>Faces that are missing, because they cannot be cut into triangles: %1 (%2)</source>
        <translation>Flächen, die fehlen, weil sie nicht in Dreiecke zerlegt werden können: %1 (%2)</translation>
    </message>
    <message>
        <source>its surfaces have no extent</source>
        <translation>ihre Flächen haben keine Ausdehnung</translation>
    </message>
    <message>
        <source>its surfaces cannot be cut into triangles</source>
        <translation>ihre Flächen können nicht in Dreiecke zerlegt werden</translation>
    </message>
    <message>
        <source>The model mirrors a texture past its edge, or ends it there; here it repeats, so these places are wrong. Apply this to the picture in a modelling program</source>
        <translation>Das Modell spiegelt eine Textur jenseits ihres Randes oder lässt sie dort enden; hier wiederholt sie sich, sodass diese Stellen falsch sind. Wenden Sie dies in einem Modellierprogramm auf das Bild an</translation>
    </message>
    <message>
        <source>The model tints a texture with its material&apos;s colour, which is not shown; apply the colour to the picture</source>
        <translation>Das Modell tönt eine Textur mit der Farbe ihres Materials, was nicht gezeigt wird; wenden Sie die Farbe auf das Bild an</translation>
    </message>
    <message>
        <source>The model has several sets of texture coordinates, and its file does not say clearly which set its texture uses; if the texture is misplaced, delete the other sets in a modelling program</source>
        <translation>Das Modell hat mehrere Sätze von Texturkoordinaten, und seine Datei sagt nicht eindeutig, welchen Satz die Textur verwendet; wenn die Textur falsch liegt, löschen Sie die anderen Sätze in einem Modellierprogramm</translation>
    </message>
    <message>
        <source>The model moves, scales or rotates a texture, which is not shown correctly; apply the transform to the texture coordinates in a modelling program</source>
        <translation>Das Modell verschiebt, skaliert oder dreht eine Textur, was nicht richtig gezeigt wird; wenden Sie die Transformation in einem Modellierprogramm auf die Texturkoordinaten an</translation>
    </message>
    <message>
        <source>a skin lacks bind matrices for some of its joints</source>
        <translation>einem Skin fehlen Bindematrizen für einige seiner Gelenke</translation>
    </message>
    <message>
        <source>The skin of the model does not say clearly how joints move %1 of its points, so these stay as stored; apply the armature in a modelling program</source>
        <translation>Der Skin des Modells sagt nicht eindeutig, wie Gelenke %1 seiner Punkte bewegen; diese bleiben daher, wie sie gespeichert sind; wenden Sie das Skelett in einem Modellierprogramm an</translation>
    </message>
    <message>
        <source>its GlobalSettings name impossible axes or units</source>
        <translation>seine GlobalSettings nennen unmögliche Achsen oder Einheiten</translation>
    </message>
    <message>
        <source>a node uses a skin that does not exist</source>
        <translation>ein Knoten verwendet einen Skin, der nicht existiert</translation>
    </message>
    <message>
        <source>The file has a master scale of %1, which programs apply in different ways, so it is not applied; check the size of the model</source>
        <translation>Die Datei hat einen Hauptmaßstab (master scale) von %1, den Programme unterschiedlich anwenden; er wird daher nicht angewendet; prüfen Sie die Größe des Modells</translation>
    </message>
    <message>
        <source>Objects that their matrix mirrors: %1, first %2. Programs read these in different ways, so they may be mirrored wrongly; apply their transforms in a modelling program</source>
        <translation>Objekte, die ihre Matrix spiegelt: %1, zuerst %2. Programme lesen solche Objekte unterschiedlich, daher können sie falsch gespiegelt sein; wenden Sie ihre Transformationen in einem Modellierprogramm an</translation>
    </message>
    <message>
        <source>The sizes of the file&apos;s parts do not fit together, so its scale and its mirrored objects are not known; export the model again</source>
        <translation>Die Größen der Teile dieser Datei passen nicht zusammen; daher sind ihr Maßstab und ihre gespiegelten Objekte nicht bekannt; exportieren Sie das Modell erneut</translation>
    </message>
    <message>
        <source>The model has a transparent material without a texture, which is shown opaque; give the material a texture with transparency</source>
        <translation>Das Modell hat ein durchsichtiges Material ohne Textur, das deckend gezeigt wird; geben Sie dem Material eine Textur mit Transparenz</translation>
    </message>
    <message>
        <source>The model mixes colours within its triangles, or mixes materials (3MF compositematerials or multiproperties), which is not shown; bake its colours into a texture to print them</source>
        <translation>Das Modell mischt Farben innerhalb seiner Dreiecke oder mischt Materialien (compositematerials oder multiproperties von 3MF), was nicht gezeigt wird; backen Sie seine Farben in eine Textur, um sie zu drucken</translation>
    </message>
    <message>
        <source>The model&apos;s coordinates are too large; scale the model down in a modelling program and save it again</source>
        <translation>Die Koordinaten des Modells sind zu groß; verkleinern Sie das Modell in einem Modellierprogramm und speichern Sie es neu</translation>
    </message>
    <message>
        <source>The texture coordinates of %1 triangles are not numbers or are too large; these triangles show their material&apos;s colour</source>
        <translation>Die Texturkoordinaten von %1 Dreiecken sind keine Zahlen oder zu groß; diese Dreiecke zeigen die Farbe ihres Materials</translation>
    </message>
    <message>
        <source>The model has a texture of several layers, which is not shown correctly; merge the layers into one picture</source>
        <translation>Das Modell hat eine Textur aus mehreren Ebenen, die nicht richtig gezeigt wird; fassen Sie die Ebenen zu einem Bild zusammen</translation>
    </message>
    <message>
        <source>Objects that share the mesh of another object, but not its materials: %1, first %2. They are shown with the materials of that object; give each object its own mesh in a modelling program</source>
        <translation>Objekte, die das Netz eines anderen Objekts teilen, aber nicht dessen Materialien: %1, zuerst %2. Sie werden mit den Materialien jenes Objekts gezeigt; geben Sie in einem Modellierprogramm jedem Objekt ein eigenes Netz</translation>
    </message>
    <message>
        <source>Objects that do not inherit the scale of their parents as usual (InheritType): %1, first %2. This is not followed, so they may have another size or shape; apply their transforms in a modelling program</source>
        <translation>Objekte, die die Skalierung ihrer Eltern nicht wie üblich erben (InheritType): %1, zuerst %2. Das wird nicht befolgt, daher können sie eine andere Größe oder Form haben; wenden Sie ihre Transformationen in einem Modellierprogramm an</translation>
    </message>
    <message>
        <source>Hidden objects: %1, first %2. They are imported, too, and dipped with the others; delete them in a modelling program if they do not belong to the part</source>
        <translation>Ausgeblendete Objekte: %1, zuerst %2. Sie werden ebenfalls importiert und mit den anderen getaucht; löschen Sie sie in einem Modellierprogramm, wenn sie nicht zum Teil gehören</translation>
    </message>
    <message>
        <source>The model wants hard edges between the pixels of a picture (magFilter NEAREST), but the sheet shows smooth changes of colour; enlarge the picture without smoothing in an image program</source>
        <translation>Das Modell will harte Kanten zwischen den Pixeln eines Bildes (magFilter NEAREST), aber das Blatt zeigt weiche Farbübergänge; vergrößern Sie das Bild ohne Glättung in einem Bildprogramm</translation>
    </message>
    <message>
        <source>its line %1 gives a point by %2 numbers instead of 3</source>
        <translation>ihre Zeile %1 gibt einen Punkt mit %2 statt 3 Zahlen an</translation>
    </message>
    <message>
        <source>its line %1 gives a point the weight %2, which programs read in different ways</source>
        <translation>ihre Zeile %1 gibt einem Punkt das Gewicht %2, das Programme unterschiedlich lesen</translation>
    </message>
    <message>
        <source>Faces whose edges cross each other: %1. Their inside is not clear, so they may be filled wrongly; cut them into triangles in a modelling program</source>
        <translation>Flächen, deren Kanten sich kreuzen: %1. Ihr Inneres ist nicht eindeutig, daher können sie falsch gefüllt sein; zerlegen Sie sie in einem Modellierprogramm in Dreiecke</translation>
    </message>
    <message>
        <source>Some points of the model (%1) lie more than %2 times as far from its middle as most points; delete them in a modelling program and save the model again</source>
        <translation>Einige Punkte des Modells (%1) liegen mehr als %2-mal so weit von seiner Mitte entfernt wie die meisten; löschen Sie sie in einem Modellierprogramm, und speichern Sie das Modell neu</translation>
    </message>
    <message>
        <source>line %1 has fans of triangles, which are not supported (export the model as triangles)</source>
        <translation>Zeile %1 enthält Dreiecksfächer, die nicht unterstützt werden (exportieren Sie das Modell als Dreiecke)</translation>
    </message>
    <message>
        <source>line %1 skews a node, which is not supported (apply the transforms in a modelling program)</source>
        <translation>Zeile %1 schert einen Knoten, was nicht unterstützt wird (wenden Sie die Transformationen in einem Modellierprogramm an)</translation>
    </message>
    <message>
        <source>line %1 turns a node about an axis whose length is not 1, so it would change the shape (apply the transforms in a modelling program)</source>
        <translation>Zeile %1 dreht einen Knoten um eine Achse, deren Länge nicht 1 ist, und würde so die Form ändern (wenden Sie die Transformationen in einem Modellierprogramm an)</translation>
    </message>
    <message>
        <source>the rotation of a node is not a quaternion of length 1, so it would change the size (export the model again)</source>
        <translation>die Drehung eines Knotens ist kein Quaternion der Länge 1 und würde so die Größe ändern (exportieren Sie das Modell noch einmal)</translation>
    </message>
    <message>
        <source>Some triangles (%1) have no place on the model&apos;s texture; they show one colour, which is mixed from its corners</source>
        <translation>Einige Dreiecke (%1) haben keine Stelle auf der Textur des Modells; sie zeigen eine einzige Farbe, gemischt aus deren Ecken</translation>
    </message>
    <message>
        <source>the image in line %1 has no file name (Collada 1.4 has it directly in init_from)</source>
        <translation>das Bild in Zeile %1 hat keinen Dateinamen (in Collada 1.4 steht er direkt in init_from)</translation>
    </message>
    <message>
        <source>The model has a material with a picture of its light (emission), but none of its colour, and the picture is not shown; use it for the colour in a modelling program</source>
        <translation>Das Modell hat ein Material mit einem Bild seines Leuchtens (Emission), aber keinem seiner Farbe; das Bild wird nicht gezeigt. Verwenden Sie es in einem Modellierprogramm für die Farbe</translation>
    </message>
    <message>
        <source>The model has triangles that were painted in a slicer, whose paint is not shown; paint the model in a modelling program, with a texture</source>
        <translation>Das Modell hat Dreiecke, die in einem Slicer bemalt wurden; die Bemalung wird nicht gezeigt. Bemalen Sie das Modell in einem Modellierprogramm mit einer Textur</translation>
    </message>
    <message>
        <source>Triangles inside the body that were removed: %1</source>
        <translation>Entfernte Dreiecke im Inneren des Körpers: %1</translation>
    </message>
    <message>
        <source>the number of polygons before line %1 differs from the declared count</source>
        <translation>die Anzahl der Polygone vor Zeile %1 weicht von der angegebenen ab</translation>
    </message>
    <message>
        <source>Faces of different colours or textures overlap in one plane, on about %1 mm², and either may be printed there; in a modelling program, delete the faces that should not show, or move one body by 0.1 mm</source>
        <translation>Flächen mit verschiedenen Farben oder Texturen überlappen sich in einer Ebene, auf etwa %1 mm², und jede von beiden kann dort gedruckt werden; löschen Sie in einem Modellierprogramm die Flächen, die nicht zu sehen sein sollen, oder verschieben Sie einen Körper um 0,1 mm</translation>
    </message>
    <message>
        <source>The picture cannot be read; check its name and permissions</source>
        <translation>Das Bild kann nicht gelesen werden; prüfen Sie Namen und Zugriffsrechte</translation>
    </message>
</context>
<context>
    <name>dipwright::InkLaw</name>
    <message>
        <source>“%1” is not an ink tone; write ink, density, exponent, bend and greatest stretch, such as cyan 0.3 0.48 0.1 2.9</source>
        <translation>„%1“ ist kein Ton einer Tinte; schreiben Sie Tinte, Dichte, Exponent, Krümmung und größte Dehnung, wie cyan 0.3 0.48 0.1 2.9</translation>
    </message>
    <message>
        <source>Sort the tones by ink: cyan, magenta, yellow, black, white</source>
        <translation>Ordnen Sie die Töne nach Tinten: Cyan, Magenta, Gelb, Schwarz, Weiß</translation>
    </message>
    <message>
        <source>Sort the tones of an ink by increasing density</source>
        <translation>Ordnen Sie die Töne einer Tinte nach steigender Dichte</translation>
    </message>
    <message>
        <source>On film with an area stretch of %3, the patch of density %2 would look lighter than the patch of density %1; measure both again</source>
        <translation>Auf Film mit der Flächendehnung %3 würde das Feld der Dichte %2 heller aussehen als das Feld der Dichte %1; messen Sie beide noch einmal</translation>
    </message>
    <message>
        <source>A density must be from %1 to %2; zero the densitometer on film without ink, or leave the patch out</source>
        <translation>Eine Dichte muss zwischen %1 und %2 liegen; stellen Sie das Densitometer auf Film ohne Farbe auf null, oder lassen Sie das Feld weg</translation>
    </message>
    <message>
        <source>The stretched area must be %1 to %2 times the unstretched area; leave this reading out</source>
        <translation>Die gedehnte Fläche muss das %1- bis %2-fache der ungedehnten Fläche sein; lassen Sie diese Messung weg</translation>
    </message>
    <message>
        <source>A wedge needs 1 to %1 patches with readings on stretched film</source>
        <translation>Ein Keil braucht 1 bis %1 Felder mit Messungen auf gedehntem Film</translation>
    </message>
    <message>
        <source>The readings of the patch of density %1 are impossible for ink; check that its densities and stretches are in the right rows</source>
        <translation>Die Messwerte des Felds der Dichte %1 sind für Farbe unmöglich; prüfen Sie, ob seine Dichten und Dehnungen in den richtigen Zeilen stehen</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
</context>
<context>
    <name>dipwright::InspectionController</name>
    <message>
        <source>Reading photos</source>
        <translation>Fotos werden gelesen</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>No photos yet</source>
        <translation>Noch keine Fotos</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Finding corners</source>
        <translation>Ecken werden gesucht</translation>
    </message>
    <message>
        <source>Measuring pairs</source>
        <translation>Paare werden gemessen</translation>
    </message>
    <message>
        <source>Wrote the residuals to %1</source>
        <translation>Abweichungen nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Dipped part</source>
        <translation>Getauchtes Teil</translation>
    </message>
    <message>
        <source>As built</source>
        <translation>Gefertigt</translation>
    </message>
    <message>
        <source>Film on the water</source>
        <translation>Film auf Wasser</translation>
    </message>
    <message>
        <source>Choose dipped image</source>
        <translation>Getauchtes Bild wählen</translation>
    </message>
    <message>
        <source>Choose kind of pairs</source>
        <translation>Art der Paare wählen</translation>
    </message>
    <message>
        <source>The project refers to this photo:</source>
        <translation>Das Projekt verweist auf dieses Foto:</translation>
    </message>
    <message>
        <source>The photo %1 has changed since its places were clicked.</source>
        <translation>Das Foto %1 hat sich geändert, seit seine Stellen angeklickt wurden.</translation>
    </message>
    <message>
        <source>Export residuals to a folder</source>
        <translation>Abweichungen in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Export residuals</source>
        <translation>Abweichungen exportieren</translation>
    </message>
    <message>
        <source>The model&apos;s texture contains no chessboard squares, so there are no corners to find; dip the part with the chessboard film, or measure only the pairs</source>
        <translation>Die Textur des Modells enthält keine Schachbrettfelder, deshalb gibt es keine Ecken zu finden; tauchen Sie das Teil mit dem Schachbrettfilm, oder messen Sie nur die Paare</translation>
    </message>
</context>
<context>
    <name>dipwright::JigModel</name>
    <message>
        <source>The bounding boxes of this part and of %1 overlap; move the parts apart on the jig</source>
        <translation>Die umgebenden Quader dieses Teils und von %1 überschneiden sich; rücken Sie die Teile auf dem Gestell auseinander</translation>
    </message>
    <message>
        <source>A jig needs at least one part, and its parts may have at most %1 materials in all</source>
        <translation>Ein Gestell braucht mindestens ein Teil, und seine Teile dürfen zusammen höchstens %1 Materialien haben</translation>
    </message>
</context>
<context>
    <name>dipwright::JobIndicator</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Estimated from the progress of the job.</source>
        <translation>Aus dem Fortschritt der Aufgabe geschätzt.</translation>
    </message>
</context>
<context>
    <name>dipwright::JobQueue</name>
    <message>
        <source>Cancelling …</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>, failed: %1</source>
        <translation>, gescheitert: %1</translation>
    </message>
    <message>
        <source>, cancelled: %1</source>
        <translation>, abgebrochen: %1</translation>
    </message>
    <message>
        <source>Coverage %1 %</source>
        <translation>Abdeckung %1 %</translation>
    </message>
    <message>
        <source>The queue has finished. Projects done: %1</source>
        <translation>Die Warteschlange ist fertig. Fertige Projekte: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Nothing has happened yet.</source>
        <translation>Noch ist nichts geschehen.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Empties the log.</source>
        <translation>Leert das Protokoll.</translation>
    </message>
    <message>
        <source>Copy report</source>
        <translation>Bericht kopieren</translation>
    </message>
    <message>
        <source>Copies the log, with details of the program and the computer, to the clipboard.</source>
        <translation>Kopiert das Protokoll mit Angaben zu Programm und Rechner in die Zwischenablage.</translation>
    </message>
</context>
<context>
    <name>dipwright::LookInsideBar</name>
    <message>
        <source>Show the other side</source>
        <translation>Andere Seite zeigen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Position of the section through part and film. You can also drag its frame in the view.</source>
        <translation>Lage des Schnitts durch Teil und Film. Sie können auch seinen Rahmen in der Ansicht ziehen.</translation>
    </message>
    <message>
        <source>How opaque the film is. At 100 % it hides everything behind it.</source>
        <translation>Wie deckend der Film ist. Bei 100 % verdeckt er alles dahinter.</translation>
    </message>
    <message>
        <source>Film opacity</source>
        <translation>Deckkraft des Films</translation>
    </message>
    <message>
        <source>Cut across X</source>
        <translation>Schnitt quer zu X</translation>
    </message>
    <message>
        <source>Horizontal cut, across Y</source>
        <translation>Waagerecht, quer zu Y</translation>
    </message>
    <message>
        <source>Cut across Z</source>
        <translation>Schnitt quer zu Z</translation>
    </message>
    <message>
        <source>Axis perpendicular to the section plane</source>
        <translation>Achse senkrecht zur Schnittebene</translation>
    </message>
</context>
<context>
    <name>dipwright::MainWindow</name>
    <message>
        <source>Cancelling …</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>Layout “%1”</source>
        <translation>Anordnung „%1“</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>The largest dimension of the part is %1. If the file uses another unit, change this dimension under Model.</source>
        <translation>Die größte Abmessung des Teils ist %1. Wenn die Datei eine andere Einheit verwendet, ändern Sie diese Abmessung unter „Modell“.</translation>
    </message>
</context>
<context>
    <name>dipwright::MarkFields</name>
    <message>
        <source>Marks nothing</source>
        <translation>Markiert nichts</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Remove last</source>
        <translation>Letzte entfernen</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>A click on the part</source>
        <translation>Ein Klick auf das Teil</translation>
    </message>
    <message>
        <source>Marks on the part: %1</source>
        <translation>Marken auf dem Teil: %1</translation>
    </message>
    <message>
        <source>Click on part</source>
        <translation>Klick auf das Teil</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Radierer</translation>
    </message>
    <message>
        <source>Radius of the brush on the part. The keys [ and ] change it.</source>
        <translation>Radius des Pinsels auf dem Teil. Die Tasten [ und ] ändern ihn.</translation>
    </message>
    <message>
        <source>Strokes on the part take the area out of the marks. Hold Shift to erase with a single stroke.</source>
        <translation>Striche auf dem Teil nehmen die Fläche aus den Markierungen heraus. Mit gehaltener Umschalttaste radiert ein einzelner Strich.</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Nach Namen</translation>
    </message>
    <message>
        <source>A face of the CAD model, or a material, by its name. The mark stays on it when the triangles are made again.</source>
        <translation>Eine Fläche des CAD-Modells oder ein Material, nach dem Namen. Die Markierung bleibt darauf, wenn die Dreiecke neu gemacht werden.</translation>
    </message>
    <message>
        <source>Marks this face or material as chosen above.</source>
        <translation>Markiert diese Fläche oder dieses Material, wie oben gewählt.</translation>
    </message>
</context>
<context>
    <name>dipwright::MaskFields</name>
    <message>
        <source>Masks with a brush</source>
        <translation>Maskiert mit einem Pinsel</translation>
    </message>
    <message>
        <source>Masks a whole face</source>
        <translation>Maskiert eine ganze Fläche</translation>
    </message>
    <message>
        <source>What a click or drag on the part does. Masked surface must stay free of film: it is covered with tape, the sheet stays blank there, and the cradle may touch it.</source>
        <translation>Was ein Klick oder ein Ziehen auf dem Teil bewirkt. Maskierte Fläche muss frei von Film bleiben: Sie wird mit Klebeband abgedeckt, das Blatt bleibt dort leer, und die Halterung darf sie berühren.</translation>
    </message>
    <message>
        <source>Masks a whole material or CAD face</source>
        <translation>Maskiert ein ganzes Material oder eine CAD-Fläche</translation>
    </message>
</context>
<context>
    <name>dipwright::MeasurePlot</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Rank %1</source>
        <translation>Rang %1</translation>
    </message>
    <message>
        <source>Horizontal axis</source>
        <translation>Waagerechte Achse</translation>
    </message>
    <message>
        <source>Vertical axis</source>
        <translation>Senkrechte Achse</translation>
    </message>
    <message>
        <source>Right and up is better. The line joins the poses that no other pose beats in both measures.</source>
        <translation>Rechts und oben ist besser. Die Linie verbindet die Lagen, die keine andere in beiden Maßen übertrifft.</translation>
    </message>
    <message>
        <source>better →</source>
        <translation>besser →</translation>
    </message>
    <message>
        <source>%1: worst %2, best %3</source>
        <translation>%1: schlechtester Wert %2, bester %3</translation>
    </message>
</context>
<context>
    <name>dipwright::MeasureTool</name>
    <message>
        <source>Distance %1</source>
        <translation>Abstand %1</translation>
    </message>
    <message>
        <source>Click the second place on the part</source>
        <translation>Klicken Sie die zweite Stelle auf dem Teil an</translation>
    </message>
    <message>
        <source>%1, along the surface %2</source>
        <translation>%1, entlang der Oberfläche %2</translation>
    </message>
</context>
<context>
    <name>dipwright::ModelFile</name>
    <message>
        <source>a texture of the model</source>
        <translation>eine Textur des Modells</translation>
    </message>
    <message>
        <source>The stored model is damaged; import the model again</source>
        <translation>Das gespeicherte Modell ist beschädigt; importieren Sie das Modell neu</translation>
    </message>
    <message>
        <source>The stored model has format version %1, but this program reads version %2; use a newer version of this program</source>
        <translation>Das gespeicherte Modell hat die Formatversion %1, dieses Programm liest aber Version %2; verwenden Sie eine neuere Version dieses Programms</translation>
    </message>
</context>
<context>
    <name>dipwright::ModelFormats</name>
    <message>
        <source>%1 or %2</source>
        <extracomment>Names of file formats: &quot;OBJ, PLY, STL, glTF&quot; or &quot;3MF&quot;</extracomment>
        <translation>%1 oder %2</translation>
    </message>
</context>
<context>
    <name>dipwright::NewProjectDialog</name>
    <message>
        <source>Models (%1)</source>
        <translation>Modelle (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>Dipwright projects (%1)</source>
        <translation>Dipwright-Projekte (%1)</translation>
    </message>
    <message>
        <source>One unit of the file is</source>
        <translation>Eine Einheit der Datei ist</translation>
    </message>
    <message>
        <source>One dip</source>
        <translation>Ein Tauchvorgang</translation>
    </message>
    <message>
        <source>Two dips: bottom and top</source>
        <translation>Zwei Tauchvorgänge: unten und oben</translation>
    </message>
    <message>
        <source>Two dips: left and right</source>
        <translation>Zwei Tauchvorgänge: links und rechts</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>&amp;Modell</translation>
    </message>
    <message>
        <source>Te&amp;xture</source>
        <translation>Te&amp;xtur</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>&amp;Film</source>
        <translation>&amp;Film</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>a millimetre</source>
        <translation>ein Millimeter</translation>
    </message>
    <message>
        <source>a centimetre</source>
        <translation>ein Zentimeter</translation>
    </message>
    <message>
        <source>a metre</source>
        <translation>ein Meter</translation>
    </message>
    <message>
        <source>an inch</source>
        <translation>ein Zoll</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
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
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Reading the model …</source>
        <translation>Modell wird gelesen …</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Modell wird gelesen</translation>
    </message>
    <message>
        <source>Film &amp;profile</source>
        <translation>Film&amp;profil</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>The model&apos;s own texture</source>
        <translation>Die eigene Textur des Modells</translation>
    </message>
    <message>
        <source>A picture that replaces the model&apos;s own texture. Leave it empty to keep the model&apos;s texture.</source>
        <translation>Ein Bild, das die eigene Textur des Modells ersetzt. Leer: Die Textur des Modells bleibt.</translation>
    </message>
    <message>
        <source>The size of the film as it is delivered and printed.</source>
        <translation>Die Größe, in der der Film geliefert und bedruckt wird.</translation>
    </message>
    <message>
        <source>The measured properties of the film: how it swells, grows and tears.</source>
        <translation>Die gemessenen Eigenschaften des Films: wie er quillt, wächst und reißt.</translation>
    </message>
    <message>
        <source>How many times the part is dipped, and from which sides. You can change this later.</source>
        <translation>Wie oft und von welchen Seiten das Teil getaucht wird. Sie können das später ändern.</translation>
    </message>
    <message>
        <source>Choose a model</source>
        <translation>Modell wählen</translation>
    </message>
    <message>
        <source>Choose a texture</source>
        <translation>Textur wählen</translation>
    </message>
    <message>
        <source>&amp;Dips</source>
        <translation>&amp;Tauchvorgänge</translation>
    </message>
    <message>
        <source>The unit of the coordinates in the model file. The file itself does not state it.</source>
        <translation>Die Einheit der Koordinaten in der Modelldatei. Die Datei selbst gibt sie nicht an.</translation>
    </message>
    <message>
        <source>The part measures %1 × %2 × %3</source>
        <translation>Das Teil misst %1 × %2 × %3</translation>
    </message>
    <message>
        <source>the unit was guessed from the size.</source>
        <translation>die Einheit wurde nach der Größe geschätzt.</translation>
    </message>
    <message>
        <source>The largest dimension is</source>
        <translation>Die größte Abmessung ist</translation>
    </message>
    <message>
        <source>One dip with the film model of the 2020 paper, for comparison</source>
        <translation>Ein Tauchvorgang mit dem Filmmodell der Arbeit von 2020, zum Vergleich</translation>
    </message>
    <message>
        <source>Largest dimension</source>
        <translation>Größte Abmessung</translation>
    </message>
    <message>
        <source>Scales the model so that its largest dimension (along X, Y or Z) has this length.</source>
        <translation>Skaliert das Modell so, dass seine größte Abmessung (entlang X, Y oder Z) diese Länge hat.</translation>
    </message>
    <message>
        <source>Choose a model file</source>
        <translation>Modelldatei wählen</translation>
    </message>
    <message>
        <source>The model file of the part to dip: %1.</source>
        <translation>Die Modelldatei des Teils, das getaucht wird: %1.</translation>
    </message>
    <message>
        <source>Create and &amp;run</source>
        <translation>Anlegen und &amp;starten</translation>
    </message>
    <message>
        <source>Creates the project and simulates its dips at once.</source>
        <translation>Legt das Projekt an und simuliert seine Tauchvorgänge sofort.</translation>
    </message>
</context>
<context>
    <name>dipwright::NoticeBar</name>
    <message>
        <source>Close this notice</source>
        <translation>Diesen Hinweis schließen</translation>
    </message>
</context>
<context>
    <name>dipwright::NumberBox</name>
    <message>
        <source>“%1” has a unit, but this field has none; type only the number</source>
        <translation>„%1“ hat eine Einheit, aber dieses Feld hat keine; geben Sie nur die Zahl ein</translation>
    </message>
    <message>
        <source>“%1” has a unit that does not fit this field; type a number in %2</source>
        <translation>„%1“ hat eine Einheit, die nicht zu diesem Feld passt; geben Sie eine Zahl in %2 ein</translation>
    </message>
    <message>
        <source>“%1” is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>“%1” is outside the range %2 to %3%4</source>
        <translation>„%1“ liegt außerhalb des Bereichs %2 bis %3%4</translation>
    </message>
    <message>
        <source>“%1” is not a whole number</source>
        <translation>„%1“ ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>The field is empty; type a number</source>
        <translation>Das Feld ist leer; geben Sie eine Zahl ein</translation>
    </message>
    <message>
        <source>“%1” can mean %2 or %3; type one of them</source>
        <translation>„%1“ kann %2 oder %3 bedeuten; geben Sie eines davon ein</translation>
    </message>
    <message>
        <source>“%1” is not a unit that this field knows; type a number in %2</source>
        <translation>„%1“ ist keine Einheit, die dieses Feld kennt; geben Sie eine Zahl in %2 ein</translation>
    </message>
</context>
<context>
    <name>dipwright::NumericalErrorCheck</name>
    <message>
        <source>Checking the numerical error</source>
        <translation>Numerischer Fehler wird geprüft</translation>
    </message>
    <message>
        <source>Check numerical error</source>
        <translation>Numerischen Fehler prüfen</translation>
    </message>
</context>
<context>
    <name>dipwright::NumericalErrorDialog</name>
    <message>
        <source>%1: this sheet is not accurate enough. For 95 % of it, the numerical error is up to %2. Use smaller film cells or more points, or turn the part.</source>
        <translation>%1: Dieses Blatt ist nicht genau genug. Für 95 % davon beträgt der numerische Fehler bis zu %2. Nehmen Sie kleinere Filmzellen oder mehr Punkte, oder drehen Sie das Teil.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Painted in both</source>
        <translation>In beiden bemalt</translation>
    </message>
    <message>
        <source>Painted in one</source>
        <translation>In einer bemalt</translation>
    </message>
    <message>
        <source>Share of the part&apos;s surface that is painted in both computations</source>
        <translation>Anteil der Oberfläche des Teils, der in beiden Rechnungen bemalt wird</translation>
    </message>
    <message>
        <source>Share of the part&apos;s surface that is painted in only one of the two computations</source>
        <translation>Anteil der Oberfläche des Teils, der nur in einer der beiden Rechnungen bemalt wird</translation>
    </message>
    <message>
        <source>With half the step</source>
        <translation>Mit halbem Schritt</translation>
    </message>
    <message>
        <source>With half the cell width</source>
        <translation>Mit halber Zellbreite</translation>
    </message>
    <message>
        <source>Numerical error of the sheet</source>
        <translation>Numerischer Fehler des Blatts</translation>
    </message>
    <message>
        <source>%1: the dip paints nothing, so there is nothing to compare.</source>
        <translation>%1: Der Tauchvorgang bemalt nichts, daher gibt es nichts zu vergleichen.</translation>
    </message>
    <message>
        <source>Numerical error of the sheets</source>
        <translation>Numerischer Fehler der Blätter</translation>
    </message>
    <message>
        <source>&amp;Save maps…</source>
        <translation>Karten &amp;speichern …</translation>
    </message>
    <message>
        <source>The project has changed since these figures were computed.</source>
        <translation>Das Projekt hat sich geändert, seit diese Zahlen berechnet wurden.</translation>
    </message>
    <message>
        <source>Save maps to a folder</source>
        <translation>Karten in einem Ordner speichern</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>95. Perzentil</translation>
    </message>
    <message>
        <source>How far the image on the sheet moves with half the step or half the cell width</source>
        <translation>Wie weit sich das Bild auf dem Blatt mit halbem Schritt oder halber Zellbreite verschiebt</translation>
    </message>
    <message>
        <source>%1: this sheet is accurate enough. For 95 % of it, the numerical error is at most %2.</source>
        <translation>%1: Dieses Blatt ist genau genug. Für 95 % davon beträgt der numerische Fehler höchstens %2.</translation>
    </message>
</context>
<context>
    <name>dipwright::OrientationMap</name>
    <message>
        <source>Which side
goes down first</source>
        <translation>Welche Seite
zuerst eintaucht</translation>
    </message>
    <message>
        <source>Rating of each side when it goes down first</source>
        <translation>Bewertung jeder Seite, wenn sie zuerst eintaucht</translation>
    </message>
    <message>
        <source>Objective %1; click to turn this side down</source>
        <translation>Zielwert %1; Klick dreht diese Seite nach unten</translation>
    </message>
</context>
<context>
    <name>dipwright::OutputsDialog</name>
    <message>
        <source>Overwrite files that were not made here</source>
        <translation>Dateien überschreiben, die nicht hier erzeugt wurden</translation>
    </message>
    <message>
        <source>Clip what lies outside the printable area</source>
        <translation>Abschneiden, was außerhalb des druckbaren Bereichs liegt</translation>
    </message>
    <message>
        <source>&amp;Save set</source>
        <translation>Satz &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Remove set</source>
        <translation>Satz &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Wählen…</translation>
    </message>
    <message>
        <source>Make outputs</source>
        <translation>Ausgaben erzeugen</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgaben</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>These results were made before the last changes to the project. Run the dip again for outputs of the current state.</source>
        <translation>Diese Ergebnisse stammen von vor den letzten Änderungen am Projekt. Starten Sie den Tauchvorgang neu, um Ausgaben des jetzigen Standes zu erhalten.</translation>
    </message>
    <message>
        <source>Cancelled. Outputs that were finished before stay.</source>
        <translation>Abgebrochen. Ausgaben, die vorher fertig waren, bleiben.</translation>
    </message>
    <message>
        <source>Output set</source>
        <translation>Ausgabesatz</translation>
    </message>
    <message>
        <source>A named list of outputs. To make an own set, tick its outputs, type a name and save it. It is kept with the project; the command line makes the same files with run --outputs NAME.</source>
        <translation>Eine benannte Liste von Ausgaben. Für einen eigenen Satz haken Sie seine Ausgaben an, geben einen Namen ein und speichern ihn. Er bleibt im Projekt; die Befehlszeile erzeugt dieselben Dateien mit run --outputs NAME.</translation>
    </message>
    <message>
        <source>Keeps the ticked outputs under this name in the project. This can be undone.</source>
        <translation>Behält die angehakten Ausgaben unter diesem Namen im Projekt. Das lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Removes this set from the project. This can be undone.</source>
        <translation>Entfernt diesen Satz aus dem Projekt. Das lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>S&amp;et</source>
        <translation>Sa&amp;tz</translation>
    </message>
    <message>
        <source>The folder that the files are written to. It is made if it does not exist.</source>
        <translation>Der Ordner, in den die Dateien geschrieben werden. Er wird angelegt, wenn es ihn nicht gibt.</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Ordner</translation>
    </message>
    <message>
        <source>If this is not ticked, an output fails rather than replace a file that it has not made, or that was changed since.</source>
        <translation>Ohne Haken schlägt eine Ausgabe fehl, statt eine Datei zu ersetzen, die sie nicht erzeugt hat oder die seitdem geändert wurde.</translation>
    </message>
    <message>
        <source>For sheets in the printer&apos;s colours: if this is not ticked, they fail if colour lies where the printer cannot print.</source>
        <translation>Für Blätter in den Farben des Druckers: Ohne Haken schlagen sie fehl, wenn Farbe dort liegt, wo der Drucker nicht drucken kann.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&amp;Make outputs</source>
        <translation>Ausgaben er&amp;zeugen</translation>
    </message>
    <message>
        <source>Writes the files of all ticked outputs.</source>
        <translation>Schreibt die Dateien aller angehakten Ausgaben.</translation>
    </message>
    <message>
        <source>Save output set “%1”</source>
        <translation>Ausgabesatz „%1“ speichern</translation>
    </message>
    <message>
        <source>The set “%1” is kept with the project.</source>
        <translation>Der Satz „%1“ bleibt im Projekt.</translation>
    </message>
    <message>
        <source>Remove output set “%1”</source>
        <translation>Ausgabesatz „%1“ entfernen</translation>
    </message>
    <message>
        <source>Folder of the outputs</source>
        <translation>Ordner der Ausgaben</translation>
    </message>
    <message>
        <source>Looking for outputs</source>
        <translation>Ausgaben werden gesucht</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fehlgeschlagen</translation>
    </message>
    <message>
        <source>Not made</source>
        <translation>Nicht erzeugt</translation>
    </message>
    <message>
        <source>Making outputs …</source>
        <translation>Ausgaben werden erzeugt …</translation>
    </message>
    <message>
        <source>Making outputs</source>
        <translation>Ausgaben werden erzeugt</translation>
    </message>
    <message>
        <source>Made the outputs in %1</source>
        <translation>Die Ausgaben wurden in %1 erzeugt</translation>
    </message>
    <message>
        <source>Outputs that failed: %1 of %2</source>
        <translation>Fehlgeschlagene Ausgaben: %1 von %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>dipwright::PackDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Add projects and lay them out.</source>
        <translation>Fügen Sie Projekte hinzu und ordnen Sie sie an.</translation>
    </message>
    <message>
        <source>Projects on the film</source>
        <translation>Projekte auf dem Film</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Exemplare</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigenes Maß</translation>
    </message>
    <message>
        <source>Short edge first</source>
        <translation>Kurze Kante zuerst</translation>
    </message>
    <message>
        <source>Long edge first</source>
        <translation>Lange Kante zuerst</translation>
    </message>
    <message>
        <source>&amp;Film</source>
        <translation>&amp;Film</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Länge</translation>
    </message>
    <message>
        <source>Fe&amp;ed</source>
        <translation>Ein&amp;zug</translation>
    </message>
    <message>
        <source>&amp;Bare film</source>
        <translation>Freier Fil&amp;m</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren …</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>Copies of %1</source>
        <translation>Exemplare von %1</translation>
    </message>
    <message>
        <source>Laying out</source>
        <translation>Wird angeordnet</translation>
    </message>
    <message>
        <source>Films: %1. They are printed at true size.</source>
        <translation>Filme: %1. Sie werden in wahrer Größe gedruckt.</translation>
    </message>
    <message>
        <source>Writing the films</source>
        <translation>Filme werden geschrieben</translation>
    </message>
    <message>
        <source>Wrote the films to %1</source>
        <translation>Filme nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Several jobs</source>
        <translation>Mehrere Aufträge</translation>
    </message>
    <message>
        <source>Film %1</source>
        <translation>Film %1</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>&amp;Turn pieces to save film</source>
        <translation>Stücke d&amp;rehen, um Film zu sparen</translation>
    </message>
    <message>
        <source>Several jobs on one film</source>
        <translation>Mehrere Aufträge auf einem Film</translation>
    </message>
    <message>
        <source>You can drop project files here. The last saved version of each file is used.</source>
        <translation>Sie können Projektdateien hierher ziehen. Verwendet wird die zuletzt gespeicherte Fassung jeder Datei.</translation>
    </message>
    <message>
        <source>&amp;Add projects…</source>
        <translation>Projekte &amp;hinzufügen …</translation>
    </message>
    <message>
        <source>The edge that enters the printer first. Film swells more along its web. A piece that swells unequally keeps its direction along the web.</source>
        <translation>Die Kante, die zuerst in den Drucker geht. Film quillt längs seiner Bahn stärker. Ein Stück, das ungleich quillt, behält seine Richtung zur Bahn.</translation>
    </message>
    <message>
        <source>Turns pieces by 90°, but only if their film swells equally in both directions.</source>
        <translation>Dreht Stücke um 90°, aber nur, wenn ihr Film in beiden Richtungen gleich quillt.</translation>
    </message>
    <message>
        <source>Shown film</source>
        <translation>Gezeigter Film</translation>
    </message>
    <message>
        <source>La&amp;y out</source>
        <translation>A&amp;nordnen</translation>
    </message>
    <message>
        <source>Simulates the projects that have no result yet, then lays out all pieces.</source>
        <translation>Simuliert die Projekte, die noch kein Ergebnis haben, und ordnet dann alle Stücke an.</translation>
    </message>
    <message>
        <source>Writes each film as PDF, PNG and TIFF at true size, and a list of the pieces with their places.</source>
        <translation>Schreibt jeden Film als PDF, PNG und TIFF in wahrer Größe und eine Liste der Stücke mit ihren Orten.</translation>
    </message>
    <message>
        <source>Add projects</source>
        <translation>Projekte hinzufügen</translation>
    </message>
    <message>
        <source>The largest length. The roll is cut off after the last piece.</source>
        <translation>Die größte Länge. Die Rolle wird hinter dem letzten Stück abgeschnitten.</translation>
    </message>
    <message>
        <source>Export films to a folder</source>
        <translation>Filme in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Press “Lay out”. Projects that have no result yet are simulated first.</source>
        <translation>Drücken Sie „Anordnen“. Projekte, die noch kein Ergebnis haben, werden zuerst simuliert.</translation>
    </message>
    <message>
        <source>Add projects or drop their files here.</source>
        <translation>Fügen Sie Projekte hinzu oder ziehen Sie ihre Dateien hierher.</translation>
    </message>
    <message>
        <source>Width of the bare film around the ink. Choose it wide: each job is computed for its whole film, and a piece that is cut close to the ink behaves differently near its edge.</source>
        <translation>Breite des freien Films um die Farbe. Wählen Sie sie groß: Jeder Auftrag ist für seinen ganzen Film berechnet, und ein nahe an der Farbe ausgeschnittenes Stück verhält sich am Rand anders.</translation>
    </message>
    <message>
        <source>&amp;Spacing between pieces</source>
        <translation>&amp;Abstand der Stücke</translation>
    </message>
    <message>
        <source>The film or roll on which the pieces are placed.</source>
        <translation>Der Film oder die Rolle, auf die die Stücke gelegt werden.</translation>
    </message>
    <message>
        <source>Width of the film or roll.</source>
        <translation>Breite des Films oder der Rolle.</translation>
    </message>
    <message>
        <source>Least distance between two pieces.</source>
        <translation>Kleinster Abstand zwischen zwei Stücken.</translation>
    </message>
    <message>
        <source>The film that the preview shows.</source>
        <translation>Der Film, den die Vorschau zeigt.</translation>
    </message>
    <message>
        <source>How many copies of the project are placed on the film.</source>
        <translation>Wie viele Kopien des Projekts auf den Film gelegt werden.</translation>
    </message>
    <message>
        <source>W&amp;hole sheets with cut marks</source>
        <translation>&amp;Ganze Blätter mit Schnittmarken</translation>
    </message>
    <message>
        <source>Places whole sheets with their own marks, for an unattended series on a roll. Cut marks and the number of each copy stand in the gaps; 5 to 20 mm are usual. Otherwise only the printed parts are placed.</source>
        <translation>Legt ganze Blätter mit ihren eigenen Marken, für eine unbeaufsichtigte Serie auf einer Rolle. In den Abständen stehen Schnittmarken und die Nummer jedes Exemplars; 5 bis 20 mm sind üblich. Sonst werden nur die bedruckten Teile gelegt.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>In exported files: %1.</source>
        <translation>In exportierten Dateien: %1.</translation>
    </message>
</context>
<context>
    <name>dipwright::PaintArtwork</name>
    <message>
        <source>The artwork does not fit into this computer&apos;s memory; choose a lower resolution of the sheet</source>
        <translation>Die Gestaltung passt nicht in den Speicher dieses Rechners; wählen Sie eine geringere Auflösung des Blatts</translation>
    </message>
    <message>
        <source>Painting the artwork</source>
        <translation>Gestaltung wird aufgetragen</translation>
    </message>
</context>
<context>
    <name>dipwright::PartCamera</name>
    <message>
        <source>Finding corners in photo %1</source>
        <translation>Ecken in Foto %1 werden gesucht</translation>
    </message>
    <message>
        <source>In photo %1, black and white are swapped; the film was laid with its ink side down, or shifted by one square</source>
        <translation>In Foto %1 sind Schwarz und Weiß vertauscht; der Film lag mit der Farbseite nach unten oder um ein Feld verschoben</translation>
    </message>
    <message>
        <source>Photo %2 should show %1 corners, but only %3 were found; check that it shows this job&apos;s part and print, whole and sharp, and that its places are correct</source>
        <translation>Foto %2 müsste %1 Ecken zeigen, aber nur %3 wurden gefunden; prüfen Sie, ob es Teil und Druck dieses Auftrags ganz und scharf zeigt und ob seine Stellen stimmen</translation>
    </message>
    <message>
        <source>Photo %1 has %2 pairs of places, but its camera needs %3; give more pairs</source>
        <translation>Foto %1 hat %2 Paare von Stellen, seine Kamera braucht aber %3; geben Sie mehr Paare an</translation>
    </message>
    <message>
        <source>All places of photo %1 lie in one plane, which does not determine the camera&apos;s distance; give some places on other faces</source>
        <translation>Alle Stellen von Foto %1 liegen in einer Ebene, und das bestimmt die Entfernung der Kamera nicht; geben Sie einige Stellen auf anderen Flächen an</translation>
    </message>
    <message>
        <source>The pairs do not determine the camera; give more pairs, farther apart</source>
        <translation>Die Paare bestimmen die Kamera nicht; geben Sie mehr Paare an, weiter auseinander</translation>
    </message>
    <message>
        <source>The pairs do not determine the camera&apos;s distance; add pairs at places nearer to the camera and farther from it, or take the photo from a shorter distance</source>
        <translation>Die Paare bestimmen die Entfernung der Kamera nicht; fügen Sie Paare an Stellen hinzu, die der Kamera näher und ferner sind, oder nehmen Sie das Foto aus kürzerer Entfernung auf</translation>
    </message>
    <message>
        <source>The first line of the pairs must be %1</source>
        <translation>Die erste Zeile der Paare muss %1 sein</translation>
    </message>
    <message>
        <source>Line %1 of the pairs must contain %2</source>
        <translation>Zeile %1 der Paare muss enthalten: %2</translation>
    </message>
    <message>
        <source>There are more than %1 pairs; give fewer</source>
        <translation>Es sind mehr als %1 Paare; geben Sie weniger an</translation>
    </message>
    <message>
        <source>a photo number, two coordinates in pixels and three in millimetres, separated by commas</source>
        <translation>eine Fotonummer, zwei Koordinaten in Pixeln und drei in Millimetern, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>a photo number, two coordinates in pixels, a dip number, two sheet coordinates and three model coordinates in millimetres, separated by commas</source>
        <translation>eine Fotonummer, zwei Koordinaten in Pixeln, eine Tauchvorgangnummer, zwei Koordinaten auf dem Blatt und drei am Modell in Millimetern, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>The photos have different sizes; use photos of one camera, held the same way</source>
        <translation>Die Fotos sind verschieden groß; verwenden Sie Fotos einer Kamera, gleich gehalten</translation>
    </message>
    <message>
        <source>With this photo, the part&apos;s photos have %1 million pixels in total, but the limit is %2 million; use fewer or smaller photos</source>
        <translation>Mit diesem Foto haben die Fotos des Teils zusammen %1 Millionen Pixel, die Grenze ist aber %2 Millionen; verwenden Sie weniger oder kleinere Fotos</translation>
    </message>
    <message>
        <source>According to the places given for it, photo %1 shows none of the print; give the places again, or photograph the dipped side</source>
        <translation>Nach den dafür angegebenen Stellen zeigt Foto %1 nichts vom Druck; geben Sie die Stellen noch einmal an, oder fotografieren Sie die getauchte Seite</translation>
    </message>
    <message>
        <source>The places marked in photo %1 are a mirror image of the places on the model; use the photo unflipped, and give the places in the model&apos;s own coordinates</source>
        <translation>Die im Foto %1 markierten Stellen sind ein Spiegelbild der Stellen auf dem Modell; verwenden Sie das Foto ungespiegelt, und geben Sie die Stellen in den Koordinaten des Modells an</translation>
    </message>
    <message>
        <source>Line %1 of the pairs names a place outside the photo, which has %2 × %3 pixels; correct the place</source>
        <translation>Zeile %1 der Paare nennt eine Stelle außerhalb des Fotos, das %2 × %3 Pixel hat; berichtigen Sie die Stelle</translation>
    </message>
    <message>
        <source>The corners found are %1 of a square from their expected places (median). Above %2, a corner may be confused with the one a diagonal away, so check one corner on the part by hand, or use larger squares</source>
        <translation>Die gefundenen Ecken liegen %1 eines Quadrats neben ihren erwarteten Orten (Median). Über %2 kann eine Ecke mit der diagonal benachbarten verwechselt werden; prüfen Sie deshalb eine Ecke am Teil von Hand, oder nehmen Sie größere Quadrate</translation>
    </message>
    <message>
        <source>Rings: expected places · lines: deviations of the seen places, scale %1:1</source>
        <translation>Ringe: erwartete Stellen · Linien: Abweichungen der gesehenen Stellen, Maßstab %1:1</translation>
    </message>
</context>
<context>
    <name>dipwright::PartPage</name>
    <message>
        <source>Photo of the dipped part</source>
        <translation>Foto des getauchten Teils</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Remove this photo and its pairs</source>
        <translation>Dieses Foto und seine Paare entfernen</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>Ganzes Bild</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Photos (%1)</source>
        <translation>Fotos (%1)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportieren …</translation>
    </message>
    <message>
        <source>Photo %1</source>
        <translation>Foto %1</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>%1 of %2 corners found.</source>
        <translation>%1 von %2 Ecken gefunden.</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>R ± σ, px</source>
        <translation>R ± σ, px</translation>
    </message>
    <message>
        <source>R, %</source>
        <translation>R, %</translation>
    </message>
    <message>
        <source>95 %, mm</source>
        <translation>95 %, mm</translation>
    </message>
    <message>
        <source>Error of the image on the part</source>
        <translation>Fehler des Bilds auf dem Teil</translation>
    </message>
    <message>
        <source>Add &amp;photos…</source>
        <translation>&amp;Fotos hinzufügen …</translation>
    </message>
    <message>
        <source>Remove photo</source>
        <translation>Foto entfernen</translation>
    </message>
    <message>
        <source>Photos of the dipped part</source>
        <translation>Fotos des getauchten Teils</translation>
    </message>
    <message>
        <source>Dipped with the c&amp;hessboard film (17 mm)</source>
        <translation>Mit dem Sc&amp;hachbrettfilm (17 mm) getaucht</translation>
    </message>
    <message>
        <source>&amp;Measure pairs</source>
        <translation>Paare &amp;messen</translation>
    </message>
    <message>
        <source>Fits the camera to the pairs and shows their residuals</source>
        <translation>Passt die Kamera an die Paare an und zeigt ihre Abweichungen</translation>
    </message>
    <message>
        <source>&amp;Find corners</source>
        <translation>Ecken &amp;suchen</translation>
    </message>
    <message>
        <source>Finds the corners of the image in all photos and compares them with the simulated film</source>
        <translation>Sucht die Ecken des Bilds in allen Fotos und vergleicht sie mit dem simulierten Film</translation>
    </message>
    <message>
        <source>&amp;Remove pair</source>
        <translation>Paar &amp;entfernen</translation>
    </message>
    <message>
        <source>Writes the table, the places and the photos with residuals to a folder</source>
        <translation>Schreibt Tabelle, Stellen und Fotos mit Abweichungen in einen Ordner</translation>
    </message>
    <message>
        <source>Now click the same place on the part in the 3D view.</source>
        <translation>Klicken Sie nun dieselbe Stelle auf dem Teil in der 3D-Ansicht an.</translation>
    </message>
    <message>
        <source>The camera was fitted to the pairs.</source>
        <translation>Die Kamera wurde an die Paare angepasst.</translation>
    </message>
    <message>
        <source>N: number of measured places</source>
        <translation>N: Anzahl der gemessenen Stellen</translation>
    </message>
    <message>
        <source>The camera was fitted to the printed pattern, so a shift or rotation of the whole image is not measured.</source>
        <translation>Die Kamera wurde am gedruckten Muster ausgerichtet; eine Verschiebung oder Drehung des ganzen Bildes wird deshalb nicht gemessen.</translation>
    </message>
    <message>
        <source>Largest, mm</source>
        <translation>Größte, mm</translation>
    </message>
    <message>
        <source>R: mean distance in the photo between the measured and the expected position of a place, ± standard deviation σ, in pixels</source>
        <translation>R: mittlerer Abstand im Foto zwischen gemessener und erwarteter Position einer Stelle, ± Standardabweichung σ, in Pixeln</translation>
    </message>
    <message>
        <source>R as a share of the photo&apos;s diagonal, as in Table II of the 2020 paper</source>
        <translation>R als Anteil der Diagonale des Fotos, wie in Tabelle II der Arbeit von 2020</translation>
    </message>
    <message>
        <source>95 % of the places on the part are within this distance of their expected positions, measured perpendicular to the line of sight</source>
        <translation>95 % der Stellen auf dem Teil liegen innerhalb dieses Abstands von ihren erwarteten Positionen, senkrecht zur Blickrichtung gemessen</translation>
    </message>
    <message>
        <source>Largest distance of a place on the part from its expected position, measured perpendicular to the line of sight</source>
        <translation>Größter Abstand einer Stelle auf dem Teil von ihrer erwarteten Position, senkrecht zur Blickrichtung gemessen</translation>
    </message>
    <message>
        <source>If ticked, the program looks for the corners of the built-in chessboard. Otherwise it looks for chessboard squares in the model&apos;s texture.</source>
        <translation>Mit Häkchen sucht das Programm die Ecken des eingebauten Schachbretts. Sonst sucht es Schachbrettfelder in der Textur des Modells.</translation>
    </message>
    <message>
        <source>The pairs mark the part &amp;itself, not the image</source>
        <translation>Die Paare mark&amp;ieren das Teil selbst, nicht das Bild</translation>
    </message>
    <message>
        <source>Tick this if the pairs are tips and edges of the part, not places in the image. Then the camera is fitted only to the pairs, so that a shift of the whole image becomes visible.</source>
        <translation>Setzen Sie das Häkchen, wenn die Paare Spitzen und Kanten des Teils sind, nicht Stellen im Bild. Dann wird die Kamera nur an die Paare angepasst, sodass eine Verschiebung des ganzen Bilds sichtbar wird.</translation>
    </message>
    <message>
        <source>Add photos of the dipped part, or drop them here. Take all photos with the same camera. The part must be sharp, completely visible and fill the picture.</source>
        <translation>Fügen Sie Fotos des getauchten Teils hinzu oder legen Sie sie hier ab. Nehmen Sie alle Fotos mit derselben Kamera auf. Das Teil muss scharf und ganz zu sehen sein und das Bild füllen.</translation>
    </message>
    <message>
        <source>Click a place in the photo, then the same place on the part in the 3D view. %1 of %2 pairs so far; spread them over several faces.</source>
        <translation>Klicken Sie eine Stelle im Foto an, dann dieselbe Stelle auf dem Teil in der 3D-Ansicht. Bisher %1 von %2 Paaren; verteilen Sie sie über mehrere Flächen.</translation>
    </message>
    <message>
        <source>%1 pairs. Drag a place to correct it, or press Delete to remove it. Then click “Find corners”, or click “Measure pairs” to use only the pairs.</source>
        <translation>%1 Paare. Ziehen Sie eine Stelle, um sie zu berichtigen; Entf löscht sie. Klicken Sie dann auf „Ecken suchen“, oder auf „Paare messen“, um nur die Paare zu verwenden.</translation>
    </message>
    <message>
        <source>The photo that is shown.</source>
        <translation>Das gezeigte Foto.</translation>
    </message>
</context>
<context>
    <name>dipwright::PathKeyFields</name>
    <message>
        <source>Add pose</source>
        <translation>Lage hinzufügen</translation>
    </message>
    <message>
        <source>Remove pose</source>
        <translation>Lage entfernen</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>The poses that the part takes in turn. The view shows the chosen pose; its rings and arrows change it.</source>
        <translation>Die Lagen, die das Teil nacheinander einnimmt. Die Ansicht zeigt die gewählte Lage; ihre Ringe und Pfeile ändern sie.</translation>
    </message>
    <message>
        <source>Adds a pose between the chosen one and the next.</source>
        <translation>Fügt eine Lage zwischen der gewählten und der nächsten ein.</translation>
    </message>
    <message>
        <source>Removes the chosen pose. The first and the last one stay.</source>
        <translation>Entfernt die gewählte Lage. Die erste und die letzte bleiben.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Depth of the part&apos;s lowest point. In the first pose it touches the water, in the last one it is at the depth of the dip.</source>
        <translation>Tiefe des tiefsten Punkts des Teils. In der ersten Lage berührt er das Wasser, in der letzten ist er in der Tiefe des Tauchvorgangs.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>How far the part has moved along %1 from its offset.</source>
        <translation>Wie weit sich das Teil von seinem Versatz entlang %1 bewegt hat.</translation>
    </message>
    <message>
        <source>Moved along %1</source>
        <translation>Bewegt entlang %1</translation>
    </message>
    <message>
        <source>How far the part is turned about %1 from its rotation at the end of the dip; about X first, then Y, then Z.</source>
        <translation>Wie weit das Teil um %1 gedreht ist, gerechnet von seiner Drehung am Ende des Tauchvorgangs; zuerst um X, dann Y, dann Z.</translation>
    </message>
    <message>
        <source>Turned about %1</source>
        <translation>Gedreht um %1</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>%1: %2 s, depth %3</source>
        <translation>%1: %2 s, Tiefe %3</translation>
    </message>
    <message>
        <source>When the part takes this pose, since the dip began. With a limit of the acceleration the part may take it later.</source>
        <translation>Wann das Teil diese Lage einnimmt, seit Beginn des Tauchvorgangs. Mit einer Grenze der Beschleunigung nimmt das Teil sie vielleicht später ein.</translation>
    </message>
</context>
<context>
    <name>dipwright::PhotoView</name>
    <message>
        <source>Lines: residuals, scale %1:1</source>
        <translation>Linien: Abweichungen, Maßstab %1:1</translation>
    </message>
</context>
<context>
    <name>dipwright::PicturePanel</name>
    <message>
        <source>Whole picture</source>
        <translation>Ganzes Bild</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>True size</source>
        <translation>Wahre Größe</translation>
    </message>
</context>
<context>
    <name>dipwright::PlatesDialog</name>
    <message>
        <source>Cyan</source>
        <translation>Cyan</translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation>Magenta</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>Platten</translation>
    </message>
    <message>
        <source>Plates need a printer profile with an ICC profile in CMYK. Choose one under Sheet in the project, and run the dip again.</source>
        <translation>Platten brauchen ein Druckerprofil mit einem ICC-Profil in CMYK. Wählen Sie eines im Projekt unter Blatt und rechnen Sie den Tauchvorgang neu.</translation>
    </message>
    <message>
        <source>&amp;All plates</source>
        <translation>&amp;Alle Platten</translation>
    </message>
    <message>
        <source>&amp;Only this plate</source>
        <translation>&amp;Nur diese Platte</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>Wheel or + and − zoom, dragging or the arrow keys move the picture. Ctrl and the arrow keys move the place whose ink is shown, by one pixel; with Shift by ten.</source>
        <translation>Mausrad oder + und − vergrößern und verkleinern, Ziehen oder die Pfeiltasten verschieben das Bild. Strg und die Pfeiltasten bewegen die Stelle, deren Tinte angezeigt wird, um ein Pixel; mit Umschalt um zehn.</translation>
    </message>
    <message>
        <source>Stops the computation. Choose another view or sheet to start again.</source>
        <translation>Hält die Berechnung an. Wählen Sie eine andere Ansicht oder ein anderes Blatt, um neu zu beginnen.</translation>
    </message>
    <message>
        <source>The dip whose sheet is shown.</source>
        <translation>Der Tauchvorgang, dessen Blatt gezeigt wird.</translation>
    </message>
    <message>
        <source>Ticked plates in ink colours</source>
        <translation>Angehakte Platten in Farbe</translation>
    </message>
    <message>
        <source>Selected plate in grey</source>
        <translation>Gewählte Platte in Grau</translation>
    </message>
    <message>
        <source>Total ink of the four inks</source>
        <translation>Gesamtfarbauftrag der vier Tinten</translation>
    </message>
    <message>
        <source>What the picture shows. In grey, black is full ink. Total ink is the sum of cyan, magenta, yellow and black; red is above the limit.</source>
        <translation>Was das Bild zeigt. In Grau ist Schwarz volle Tinte. Der Gesamtfarbauftrag ist die Summe von Cyan, Magenta, Gelb und Schwarz; Rot liegt über der Grenze.</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Colour of the part</source>
        <translation>Farbe des Teils</translation>
    </message>
    <message>
        <source>What lies beneath the inks in the picture. White ink shows only on another ground than white.</source>
        <translation>Was im Bild unter den Tinten liegt. Weiße Tinte sieht man nur auf einem anderen Untergrund als Weiß.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>The largest sum of the four inks that the film carries. Places above it are marked and measured. It starts at the printer profile&apos;s total area coverage. Usual: 200 to 300 %. The print does not change.</source>
        <translation>Die größte Summe der vier Tinten, die der Film trägt. Stellen darüber werden markiert und gemessen. Anfangs steht hier der Gesamtfarbauftrag des Druckerprofils. Üblich: 200 bis 300 %. Der Druck ändert sich nicht.</translation>
    </message>
    <message>
        <source>S&amp;heet</source>
        <translation>&amp;Blatt</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>An&amp;sicht</translation>
    </message>
    <message>
        <source>&amp;Ground</source>
        <translation>&amp;Untergrund</translation>
    </message>
    <message>
        <source>Total ink &amp;limit</source>
        <translation>&amp;Größter Auftrag</translation>
    </message>
    <message>
        <source>Plates in printing order</source>
        <translation>Platten in Druckreihenfolge</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Cursor %</source>
        <translation>Zeiger %</translation>
    </message>
    <message>
        <source>Largest %</source>
        <translation>Größte %</translation>
    </message>
    <message>
        <source>Full ink</source>
        <translation>Volle Tinte</translation>
    </message>
    <message>
        <source>The ink under the cursor, as a share of full ink.</source>
        <translation>Die Tinte unter dem Mauszeiger als Anteil voller Tinte.</translation>
    </message>
    <message>
        <source>The largest share of ink on the film.</source>
        <translation>Der größte Anteil von Tinte auf dem Film.</translation>
    </message>
    <message>
        <source>How much ink the plate takes, as the area that it would cover at full ink.</source>
        <translation>Wie viel Tinte die Platte braucht, als Fläche, die sie mit voller Tinte decken würde.</translation>
    </message>
    <message>
        <source>Tick the plates that the picture shows. Space changes the selected plate, a double-click shows only that plate.</source>
        <translation>Haken Sie die Platten an, die das Bild zeigt. Die Leertaste ändert die gewählte Platte, ein Doppelklick zeigt nur diese Platte.</translation>
    </message>
    <message>
        <source>Making the plates</source>
        <translation>Platten werden gemacht</translation>
    </message>
    <message>
        <source>Measuring the plates</source>
        <translation>Platten werden gemessen</translation>
    </message>
    <message>
        <source>Drawing the plates</source>
        <translation>Platten werden gezeichnet</translation>
    </message>
    <message>
        <source>Four inks</source>
        <translation>Vier Tinten</translation>
    </message>
    <message>
        <source>All plates</source>
        <translation>Alle Platten</translation>
    </message>
    <message>
        <source>Above the limit of %1 %: %2, %3 % of the inked film.
95 % of the inked film carries at most %4 %. The figures are those of the film&apos;s picture; marks and lettering are printed besides it.</source>
        <translation>Über der Grenze von %1 %: %2, das sind %3 % des bedruckten Films.
95 % des bedruckten Films tragen höchstens %4 %. Die Zahlen gelten für das Bild auf dem Film; Marken und Schrift kommen dazu.</translation>
    </message>
    <message>
        <source>The sheet is printed %1 times; the figures are those of one pass.</source>
        <translation>Das Blatt wird %1-mal gedruckt; die Zahlen gelten für einen Durchgang.</translation>
    </message>
    <message>
        <source>%1 &gt; limit</source>
        <translation>%1 &gt; Grenze</translation>
    </message>
</context>
<context>
    <name>dipwright::PoseTable</name>
    <message>
        <source>%1: turned by %2° about X, Y, Z</source>
        <translation>%1: gedreht um %2° um X, Y, Z</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>≈ %1</source>
        <comment>about</comment>
        <translation>≈ %1</translation>
    </message>
    <message>
        <source>Compared with your pose: %1</source>
        <translation>Verglichen mit Ihrer Lage: %1</translation>
    </message>
    <message>
        <source>Found poses, best first</source>
        <translation>Gefundene Lagen, beste zuerst</translation>
    </message>
    <message>
        <source>Verdict,
differences</source>
        <translation>Urteil,
Unterschiede</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiterer</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Does not meet a limit.</source>
        <translation>Hält eine Grenze nicht ein.</translation>
    </message>
    <message>
        <source>Your pose.</source>
        <translation>Ihre Lage.</translation>
    </message>
    <message>
        <source>Better: %1</source>
        <translation>Besser: %1</translation>
    </message>
    <message>
        <source>Worse: %1</source>
        <translation>Schlechter: %1</translation>
    </message>
    <message>
        <source>Objective,
coverage,
stretch</source>
        <translation>Zielwert,
Abdeckung,
Dehnung</translation>
    </message>
    <message>
        <source>%1 (expected)</source>
        <translation>%1 (erwartet)</translation>
    </message>
</context>
<context>
    <name>dipwright::PreferencesDialog</name>
    <message>
        <source>Run again after each change</source>
        <translation>Nach jeder Änderung neu rechnen</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Solvers</source>
        <translation>Solver</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Turntable: up stays up</source>
        <translation>Drehteller: oben bleibt oben</translation>
    </message>
    <message>
        <source>Trackball: turns freely</source>
        <translation>Rollkugel: dreht frei</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>&amp;Navigation</translation>
    </message>
    <message>
        <source>&amp;Film of new projects</source>
        <translation>Film neuer &amp;Projekte</translation>
    </message>
    <message>
        <source>&amp;Recovery copy after</source>
        <translation>Sicherungs&amp;kopie nach</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>The language of menus, panels and messages.</source>
        <translation>Die Sprache der Menüs, Bereiche und Meldungen.</translation>
    </message>
    <message>
        <source>The unit in which lengths and speeds are shown and typed.</source>
        <translation>Die Einheit, in der Längen und Geschwindigkeiten gezeigt und eingegeben werden.</translation>
    </message>
    <message>
        <source>Light or dark colours.</source>
        <translation>Helle oder dunkle Farben.</translation>
    </message>
    <message>
        <source>&amp;Printer of new projects</source>
        <translation>&amp;Drucker neuer Projekte</translation>
    </message>
    <message>
        <source>Film pr&amp;ofile of new projects</source>
        <translation>Filmp&amp;rofil neuer Projekte</translation>
    </message>
    <message>
        <source>The film size proposed for new projects.</source>
        <translation>Die Filmgröße, die für neue Projekte vorgeschlagen wird.</translation>
    </message>
    <message>
        <source>The film profile proposed for new projects.</source>
        <translation>Das Filmprofil, das für neue Projekte vorgeschlagen wird.</translation>
    </message>
    <message>
        <source>The printer profile of new projects. You can change it under Sheet.</source>
        <translation>Das Druckerprofil neuer Projekte. Unter „Blatt“ können Sie es ändern.</translation>
    </message>
    <message>
        <source>How dragging turns the view.</source>
        <translation>Wie Ziehen die Ansicht dreht.</translation>
    </message>
    <message>
        <source>Longest time between a change and the recovery copy. After a crash, your work is restored from this copy.</source>
        <translation>Längste Zeit zwischen einer Änderung und der Sicherungskopie. Nach einem Absturz wird Ihre Arbeit aus dieser Kopie wiederhergestellt.</translation>
    </message>
    <message>
        <source>After the first run, each change recomputes the results that depend on it.</source>
        <translation>Nach dem ersten Lauf berechnet jede Änderung die Ergebnisse neu, die von ihr abhängen.</translation>
    </message>
    <message>
        <source>A new language takes effect when you restart the program.</source>
        <translation>Eine neue Sprache wirkt nach einem Neustart des Programms.</translation>
    </message>
    <message>
        <source>L&amp;ength unit</source>
        <translation>&amp;Längeneinheit</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>%1 is assigned to both “%2” and “%3”. Change one of them.</source>
        <translation>%1 ist „%2“ und „%3“ zugewiesen. Ändern Sie eines davon.</translation>
    </message>
    <message>
        <source>Keep results next to the project file</source>
        <translation>Ergebnisse neben der Projektdatei aufbewahren</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Saves the dips of a project in the file NAME.dips next to the project file, up to 64 MB. When you open the project again, its results are shown at once.</source>
        <translation>Speichert die Tauchvorgänge eines Projekts in der Datei NAME.dips neben der Projektdatei, bis zu 64 MB. Wenn Sie das Projekt wieder öffnen, werden seine Ergebnisse sofort gezeigt.</translation>
    </message>
</context>
<context>
    <name>dipwright::PrintDialog</name>
    <message>
        <source>Custom, as set in the first project</source>
        <translation>Eigenes, wie im ersten Projekt eingestellt</translation>
    </message>
    <message>
        <source>None: true size and sRGB (choose a profile in the first project)</source>
        <translation>Keines: wahre Größe und sRGB (wählen Sie ein Profil im ersten Projekt)</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Drucker</translation>
    </message>
    <message>
        <source>&amp;Printer</source>
        <translation>&amp;Drucker</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>&amp;Copies</source>
        <translation>&amp;Exemplare</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Blätter</translation>
    </message>
    <message>
        <source>Looking for printers …</source>
        <translation>Drucker werden gesucht …</translation>
    </message>
    <message>
        <source>Looking for printers</source>
        <translation>Drucker werden gesucht</translation>
    </message>
    <message>
        <source>Choose at least one sheet.</source>
        <translation>Wählen Sie mindestens ein Blatt.</translation>
    </message>
    <message>
        <source>Printing …</source>
        <translation>Wird gedruckt …</translation>
    </message>
    <message>
        <source>Printing</source>
        <translation>Wird gedruckt</translation>
    </message>
    <message>
        <source>Printed on %1</source>
        <translation>Auf %1 gedruckt</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>The film itself</source>
        <translation>Der Film selbst</translation>
    </message>
    <message>
        <source>Custom, as set under Sheet</source>
        <translation>Eigenes, wie unter „Blatt“ eingestellt</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Hochformat</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>P&amp;apier</translation>
    </message>
    <message>
        <source>&amp;Orientation</source>
        <translation>Aus&amp;richtung</translation>
    </message>
    <message>
        <source>As designed</source>
        <translation>Wie entworfen</translation>
    </message>
    <message>
        <source>As printed (soft proof)</source>
        <translation>Wie gedruckt (Softproof)</translation>
    </message>
    <message>
        <source>A soft proof needs a printer profile with an ICC profile.</source>
        <translation>Ein Softproof braucht ein Druckerprofil mit ICC-Profil.</translation>
    </message>
    <message>
        <source>Colours of the page</source>
        <translation>Farben der Seite</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Ready to print at true size. Pages: %1.</source>
        <translation>Bereit zum Druck in wahrer Größe. Seiten: %1.</translation>
    </message>
    <message>
        <source>The paper that the sheet is printed on.</source>
        <translation>Das Papier, auf das das Blatt gedruckt wird.</translation>
    </message>
    <message>
        <source>Tile the sheet if the paper is too small</source>
        <translation>Blatt in Kacheln teilen, wenn das Papier zu klein ist</translation>
    </message>
    <message>
        <source>Print in grey on a monochrome printer</source>
        <translation>Auf einem Schwarzweißdrucker grau drucken</translation>
    </message>
    <message>
        <source>Clip what lies outside the printable area</source>
        <translation>Abschneiden, was außerhalb des druckbaren Bereichs liegt</translation>
    </message>
    <message>
        <source>The printer does not report this paper as loaded</source>
        <translation>Der Drucker meldet dieses Papier nicht als eingelegt</translation>
    </message>
    <message>
        <source>Print anyway</source>
        <translation>Trotzdem drucken</translation>
    </message>
    <message>
        <source>Print sheets</source>
        <translation>Blätter drucken</translation>
    </message>
    <message>
        <source>Whether the sheet of this dip is printed.</source>
        <translation>Ob das Blatt dieses Tauchvorgangs gedruckt wird.</translation>
    </message>
    <message>
        <source>Save as file…</source>
        <translation>Als Datei speichern …</translation>
    </message>
    <message>
        <source>Saves the shown sheet as PDF or TIFF, in the printer&apos;s scale and colours.</source>
        <translation>Speichert das gezeigte Blatt als PDF oder TIFF, im Maßstab und in den Farben des Druckers.</translation>
    </message>
    <message>
        <source>Number of copies of each sheet.</source>
        <translation>Anzahl der Exemplare jedes Blatts.</translation>
    </message>
    <message>
        <source>No printer set up</source>
        <translation>Kein Drucker eingerichtet</translation>
    </message>
    <message>
        <source>As printed, out-of-gamut colours in magenta</source>
        <translation>Wie gedruckt, Farben außerhalb des Farbumfangs in Magenta</translation>
    </message>
    <message>
        <source>How the page is shown here. The print does not change.</source>
        <translation>Wie die Seite hier gezeigt wird. Der Druck ändert sich nicht.</translation>
    </message>
    <message>
        <source>Computing the soft proof</source>
        <translation>Softproof wird berechnet</translation>
    </message>
    <message>
        <source>%1 % of the painted area is out of the printer&apos;s gamut.</source>
        <translation>%1 % der bemalten Fläche liegen außerhalb des Farbumfangs des Druckers.</translation>
    </message>
    <message>
        <source>Save sheet</source>
        <translation>Blatt speichern</translation>
    </message>
    <message>
        <source>Cancelled. Pages that the printer has already begun may still come out.</source>
        <translation>Abgebrochen. Seiten, die der Drucker schon begonnen hat, kommen vielleicht noch heraus.</translation>
    </message>
    <message>
        <source>None: true size and sRGB (choose a profile under Sheet)</source>
        <translation>Keines: wahre Größe und sRGB (wählen Sie ein Profil unter „Blatt“)</translation>
    </message>
    <message>
        <source>If this is not ticked, the program refuses a print with this problem and shows the reason.</source>
        <translation>Ohne Häkchen verweigert das Programm einen Druck mit diesem Problem und zeigt den Grund.</translation>
    </message>
    <message>
        <source>The printers that are set up on this computer.</source>
        <translation>Die Drucker, die auf diesem Rechner eingerichtet sind.</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. Save the sheet as PDF and print it elsewhere, at 100 %.</source>
        <translation>Auf diesem Rechner ist kein Drucker eingerichtet. Speichern Sie das Blatt als PDF und drucken Sie es anderswo mit 100 %.</translation>
    </message>
    <message>
        <source>Checking the printer …</source>
        <translation>Der Drucker wird geprüft …</translation>
    </message>
    <message>
        <source>Checking the printer</source>
        <translation>Der Drucker wird geprüft</translation>
    </message>
    <message>
        <source>Sent to the print queue of %1</source>
        <translation>An die Druckwarteschlange von %1 gesendet</translation>
    </message>
    <message>
        <source>P&amp;lates…</source>
        <translation>P&amp;latten…</translation>
    </message>
    <message>
        <source>This film is too long to show its plates. Look at the plates of the single jobs.</source>
        <translation>Dieser Film ist zu lang, um seine Platten zu zeigen. Sehen Sie sich die Platten der einzelnen Aufträge an.</translation>
    </message>
    <message>
        <source>Shows the plates of the sheets, the ink under the cursor, and where there is too much ink. Needs a printer profile with an ICC profile in CMYK.</source>
        <translation>Zeigt die Platten der Blätter, die Tinte unter dem Mauszeiger und wo zu viel Tinte liegt. Braucht ein Druckerprofil mit einem ICC-Profil in CMYK.</translation>
    </message>
</context>
<context>
    <name>dipwright::PrintFields</name>
    <message>
        <source>Shift X</source>
        <translation>Versatz X</translation>
    </message>
    <message>
        <source>Shift Z</source>
        <translation>Versatz Z</translation>
    </message>
    <message>
        <source>After %1 and %2</source>
        <translation>Nach %1 und %2</translation>
    </message>
    <message>
        <source>After %1</source>
        <translation>Nach %1</translation>
    </message>
    <message>
        <source>How far the second film is displaced along X.</source>
        <translation>Wie weit der zweite Film längs X verschoben ist.</translation>
    </message>
    <message>
        <source>How far the second film is displaced along Z.</source>
        <translation>Wie weit der zweite Film längs Z verschoben ist.</translation>
    </message>
    <message>
        <source>How much more the second film has swollen than the sheet assumes.</source>
        <translation>Wie viel mehr der zweite Film gequollen ist, als das Blatt annimmt.</translation>
    </message>
    <message>
        <source>Extra depth</source>
        <translation>Zusätzliche Tiefe</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Puts the second film back in its intended place.</source>
        <translation>Legt den zweiten Film wieder an seinen vorgesehenen Ort.</translation>
    </message>
    <message>
        <source>Show part</source>
        <translation>Teil zeigen</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Angle by which the second film is turned, from X towards Z.</source>
        <translation>Winkel, um den der zweite Film gedreht ist, von X nach Z.</translation>
    </message>
    <message>
        <source>Extra swell</source>
        <translation>Mehr Quellung</translation>
    </message>
    <message>
        <source>How much deeper the part is dipped. A negative value dips it less deep; surface that then stays above the water gets no ink. If the dip covers the whole part, it cannot go deeper.</source>
        <translation>Wie viel tiefer das Teil getaucht wird. Bei einem negativen Wert wird es weniger tief getaucht; was dann über dem Wasser bleibt, bekommt keine Farbe. Taucht schon das ganze Teil ein, kann es nicht tiefer gehen.</translation>
    </message>
</context>
<context>
    <name>dipwright::PrintHistoryDialog</name>
    <message>
        <source>Project file: %1</source>
        <translation>Projektdatei: %1</translation>
    </message>
    <message>
        <source>Written to: %1</source>
        <translation>Geschrieben nach: %1</translation>
    </message>
    <message>
        <source>Film: %1</source>
        <translation>Film: %1</translation>
    </message>
    <message>
        <source>The project had not been saved when it was printed.</source>
        <translation>Das Projekt war noch nicht gespeichert, als es gedruckt wurde.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Job number on the sheet, project, printer …</source>
        <translation>Auftragsnummer auf dem Blatt, Projekt, Drucker …</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Printer or file</source>
        <translation>Drucker oder Datei</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Exemplare</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Reading the print history</source>
        <translation>Der Druckverlauf wird gelesen</translation>
    </message>
    <message>
        <source>Reading the print history …</source>
        <translation>Der Druckverlauf wird gelesen …</translation>
    </message>
    <message>
        <source>Nothing has been printed yet.</source>
        <translation>Noch wurde nichts gedruckt.</translation>
    </message>
    <message>
        <source>Printer profile: %1</source>
        <translation>Druckerprofil: %1</translation>
    </message>
    <message>
        <source>Paper name in the printer: %1</source>
        <translation>Name des Papiers im Drucker: %1</translation>
    </message>
    <message>
        <source>The project file no longer exists.</source>
        <translation>Die Projektdatei gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>Print history</source>
        <translation>Druckverlauf</translation>
    </message>
    <message>
        <source>Shows the prints that contain all words typed here. Parts of words are enough.</source>
        <translation>Zeigt die Drucke, die alle hier eingegebenen Wörter enthalten. Wortteile genügen.</translation>
    </message>
    <message>
        <source>Prints, newest first</source>
        <translation>Drucke, neueste zuerst</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Tauchvorgang</translation>
    </message>
    <message>
        <source>&amp;Open project</source>
        <translation>Projekt &amp;öffnen</translation>
    </message>
    <message>
        <source>No print contains these words.</source>
        <translation>Kein Druck enthält diese Wörter.</translation>
    </message>
</context>
<context>
    <name>dipwright::PrinterColour</name>
    <message>
        <source>This ICC profile cannot be used for printing; choose the printer&apos;s output profile</source>
        <translation>Dieses ICC-Profil taugt nicht zum Drucken; wählen Sie das Ausgabeprofil des Druckers</translation>
    </message>
    <message>
        <source>This file is not an ICC profile, or it is damaged; choose another file</source>
        <translation>Diese Datei ist kein ICC-Profil oder ist beschädigt; wählen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>This ICC profile does not belong to an RGB or CMYK printer; choose the printer&apos;s output profile</source>
        <translation>Dieses ICC-Profil gehört zu keinem RGB- oder CMYK-Drucker; wählen Sie das Ausgabeprofil des Druckers</translation>
    </message>
    <message>
        <source>This file is not an ICC device link from RGB or CMYK to CMYK, or it is damaged; choose another file</source>
        <translation>Diese Datei ist kein ICC-Device-Link von RGB oder CMYK nach CMYK, oder sie ist beschädigt; wählen Sie eine andere Datei</translation>
    </message>
</context>
<context>
    <name>dipwright::Printing</name>
    <message>
        <source>The printer does not reach the outer %1 mm of the paper, and a part of the cut contour lies there; check that the cutter reaches it</source>
        <translation>Der Drucker erreicht die äußeren %1 mm des Papiers nicht, und ein Teil der Schneidkontur liegt dort; prüfen Sie, ob der Schneider sie erreicht</translation>
    </message>
    <message>
        <source>The sheet could not be sent to the printer: %1</source>
        <translation>Das Blatt konnte nicht an den Drucker gesendet werden: %1</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>The printer is stopped%1; start it again in the system&apos;s settings</source>
        <translation>Der Drucker ist angehalten%1; starten Sie ihn in den Einstellungen des Systems</translation>
    </message>
    <message>
        <source>The sheet of %1 is larger than every paper of the printer (%2); make it smaller or print it in tiles</source>
        <translation>Das Blatt von %1 ist größer als jedes Papier des Druckers (%2); verkleinern Sie es oder drucken Sie es in Kacheln</translation>
    </message>
    <message>
        <source>The printer does not reach the outer %1 mm of the paper, and the sheet has colour there</source>
        <translation>Der Drucker erreicht die äußeren %1 mm des Papiers nicht, aber das Blatt hat dort Farbe</translation>
    </message>
    <message>
        <source>The printer prints in grey only, and the sheet is coloured; choose a colour printer, or accept grey</source>
        <translation>Der Drucker druckt nur grau, und das Blatt ist farbig; wählen Sie einen Farbdrucker, oder nehmen Sie Grau hin</translation>
    </message>
    <message>
        <source>The printer prints the coloured sheet in grey</source>
        <translation>Der Drucker druckt das farbige Blatt grau</translation>
    </message>
    <message>
        <source>The printer has no paper of %1 loaded</source>
        <translation>Im Drucker ist kein Papier von %1 eingelegt</translation>
    </message>
    <message>
        <source>%1; load it, or choose other paper</source>
        <translation>%1; legen Sie es ein, oder wählen Sie anderes Papier</translation>
    </message>
    <message>
        <source>Printing</source>
        <translation>Wird gedruckt</translation>
    </message>
    <message>
        <source>Held in the printer&apos;s queue</source>
        <translation>In der Warteschlange des Druckers angehalten</translation>
    </message>
    <message>
        <source>Waiting in the printer&apos;s queue</source>
        <translation>Wartet in der Warteschlange des Druckers</translation>
    </message>
    <message>
        <source>The job was cancelled at the printer</source>
        <translation>Der Auftrag wurde am Drucker abgebrochen</translation>
    </message>
    <message>
        <source>The sheet could not be sent to the printer</source>
        <translation>Das Blatt konnte nicht an den Drucker gesendet werden</translation>
    </message>
    <message>
        <source>Calibration of %1</source>
        <translation>Kalibrierung von %1</translation>
    </message>
    <message>
        <source>%1, lot %2</source>
        <translation>%1, Charge %2</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>Gedruckt</translation>
    </message>
    <message>
        <source>Handed to the printer&apos;s queue</source>
        <translation>An die Warteschlange des Druckers übergeben</translation>
    </message>
    <message>
        <source>Written to a file</source>
        <translation>In eine Datei geschrieben</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Gescheitert: %1</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Angehalten: %1</translation>
    </message>
    <message>
        <source>The printer does not report its capabilities: %1</source>
        <translation>Der Drucker meldet seine Fähigkeiten nicht: %1</translation>
    </message>
    <message>
        <source>The printer refuses the job: %1</source>
        <translation>Der Drucker lehnt den Auftrag ab: %1</translation>
    </message>
    <message>
        <source>The print system does not report the state of the job: %1</source>
        <translation>Das Drucksystem meldet den Zustand des Auftrags nicht: %1</translation>
    </message>
    <message>
        <source>The cut contour is left out: it needs a PDF and a printer profile with an ICC profile in CMYK</source>
        <translation>Die Schneidkontur wird weggelassen: Sie braucht ein PDF und ein Druckerprofil mit einem ICC-Profil in CMYK</translation>
    </message>
    <message>
        <source>A sheet in tiles can only be written as PDF, one page for each tile; end the file name in .pdf</source>
        <translation>Ein Blatt in Kacheln lässt sich nur als PDF schreiben, eine Seite je Kachel; geben Sie der Datei die Endung .pdf</translation>
    </message>
    <message>
        <source>Sent, outcome unknown</source>
        <translation>Gesendet, Ergebnis unbekannt</translation>
    </message>
    <message>
        <source>Unknown: %1</source>
        <translation>Unbekannt: %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be created</source>
        <translation>der Ordner %1 kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>%1; choose larger or borderless paper, or accept that this colour is lost</source>
        <translation>%1; wählen Sie größeres oder randloses Papier, oder nehmen Sie den Verlust dieser Farbe hin</translation>
    </message>
    <message>
        <source>The printer scales pages by itself (&quot;%1&quot;), and the print system cannot turn this off; set the scaling to &quot;none&quot; in the printer&apos;s own menu</source>
        <translation>Der Drucker skaliert Seiten von selbst („%1“), und das Drucksystem kann das nicht abschalten; stellen Sie im eigenen Menü des Druckers die Skalierung auf „none“</translation>
    </message>
    <message>
        <source>There is no such printer, and no other printer is set up; set one up in the system first</source>
        <translation>Diesen Drucker gibt es nicht, und es ist kein anderer eingerichtet; richten Sie zuerst einen im System ein</translation>
    </message>
    <message>
        <source>There is no such printer; choose one of: %1</source>
        <translation>Diesen Drucker gibt es nicht; wählen Sie einen von: %1</translation>
    </message>
    <message>
        <source>The printer scales pages by default, and its queue cannot turn this off; the job bypasses the queue and goes directly to the printer</source>
        <translation>Der Drucker skaliert Seiten standardmäßig, und seine Warteschlange kann das nicht abschalten; der Auftrag umgeht die Warteschlange und geht direkt an den Drucker</translation>
    </message>
    <message>
        <source>the job was cancelled</source>
        <translation>der Auftrag wurde abgebrochen</translation>
    </message>
    <message>
        <source>the job could not be cancelled, so remove it from the printer&apos;s queue</source>
        <translation>der Auftrag ließ sich nicht abbrechen, entfernen Sie ihn daher aus der Warteschlange des Druckers</translation>
    </message>
    <message>
        <source>The print system has finished the job, but the printer does not answer; check whether the sheet was printed, and print it again if not</source>
        <translation>Das Drucksystem hat den Auftrag abgeschlossen, aber der Drucker antwortet nicht; prüfen Sie, ob das Blatt gedruckt ist, und drucken Sie es sonst noch einmal</translation>
    </message>
    <message>
        <source>The printer aborted the job: %1</source>
        <translation>Der Drucker hat den Auftrag abgebrochen: %1</translation>
    </message>
    <message>
        <source>The printer stopped in the middle of the job: %1; the rest was cancelled, so print the sheet again</source>
        <translation>Der Drucker hielt mitten im Auftrag an: %1; der Rest wurde abgebrochen, drucken Sie das Blatt daher noch einmal</translation>
    </message>
    <message>
        <source>The printer has stopped: %1; the job was cancelled, so start the printer and print the sheet again</source>
        <translation>Der Drucker hat angehalten: %1; der Auftrag wurde abgebrochen, starten Sie den Drucker daher und drucken Sie das Blatt noch einmal</translation>
    </message>
    <message>
        <source>The printer does not answer (%1); %2; check its power, its cable and its address in the system, and print the sheet again</source>
        <translation>Der Drucker antwortet nicht (%1); %2; prüfen Sie Strom, Kabel und seine Adresse im System und drucken Sie das Blatt noch einmal</translation>
    </message>
    <message>
        <source>The state of job %1 has not changed for a long time (%2), and this printer cannot be queried; check the printer, and remove the job from its queue if it does not print</source>
        <translation>Der Zustand von Auftrag %1 hat sich lange nicht geändert (%2), und dieser Drucker lässt sich nicht abfragen; sehen Sie am Drucker nach und entfernen Sie den Auftrag aus der Warteschlange, falls er nicht druckt</translation>
    </message>
    <message>
        <source>The printer refuses the job</source>
        <translation>Der Drucker lehnt den Auftrag ab</translation>
    </message>
    <message>
        <source>the printer would change the page size</source>
        <translation>der Drucker würde die Größe der Seite ändern</translation>
    </message>
    <message>
        <source>no reason was given</source>
        <translation>kein Grund angegeben</translation>
    </message>
    <message>
        <source>The printer feeds this paper only with its other edge first; rotate the page by 90°</source>
        <translation>Der Drucker nimmt dieses Papier nur mit der anderen Kante voran; drehen Sie die Seite um 90°</translation>
    </message>
    <message>
        <source>%1 mm² of the part will be visibly too pale: the stretched film needs more ink there than full ink, the ink limit and the total area coverage allow</source>
        <translation>%1 mm² des Teils werden sichtbar zu blass: Der gedehnte Film braucht dort mehr Farbe, als Vollton, Tintenlimit und Gesamtfarbauftrag zulassen</translation>
    </message>
    <message>
        <source>This print could not be added to the print history: %1</source>
        <translation>Dieser Druck konnte nicht in den Druckverlauf aufgenommen werden: %1</translation>
    </message>
    <message>
        <source>The printer does not accept jobs at the moment%1; allow jobs in the system&apos;s settings</source>
        <translation>Der Drucker nimmt im Augenblick keine Aufträge an%1; erlauben Sie Aufträge in den Einstellungen des Systems</translation>
    </message>
    <message>
        <source>The printer has no paper of %1; set the paper of the sheet to one of these: %2</source>
        <translation>Der Drucker hat kein Papier von %1; stellen Sie das Papier des Blatts auf eines von diesen: %2</translation>
    </message>
    <message>
        <source>The printer reports no loaded paper for the tiles; load paper, or choose a paper for the tiles</source>
        <translation>Der Drucker meldet kein eingelegtes Papier für die Kacheln; legen Sie Papier ein, oder wählen Sie ein Papier für die Kacheln</translation>
    </message>
    <message>
        <source>The printer has no paper named %1; choose another paper</source>
        <translation>Der Drucker hat kein Papier namens %1; wählen Sie ein anderes Papier</translation>
    </message>
    <message>
        <source>The printer does not reach the outer %1 mm of the paper; enter the printer&apos;s margins in its profile first</source>
        <translation>Der Drucker erreicht die äußeren %1 mm des Papiers nicht; tragen Sie zuerst die Ränder des Druckers in sein Profil ein</translation>
    </message>
    <message>
        <source>This version of the program cannot print; print the sheet&apos;s PDF at 100 % with another program</source>
        <translation>Diese Fassung des Programms kann nicht drucken; drucken Sie das PDF des Blatts mit 100 % aus einem anderen Programm</translation>
    </message>
    <message>
        <source>any size from %1 to %2</source>
        <translation>jede Größe von %1 bis %2</translation>
    </message>
    <message>
        <source>Each sheet must be printed %1 times onto the same film, without moving it: the project prints its ink in %1 passes</source>
        <translation>Jedes Blatt muss %1-mal auf denselben Film gedruckt werden, ohne ihn zu verschieben: Das Projekt druckt seine Tinte in %1 Durchgängen</translation>
    </message>
    <message>
        <source>Series on the roll, %1, with cut marks; sheets: %2</source>
        <translation>Serie auf der Rolle, %1, mit Schnittmarken; Blätter: %2</translation>
    </message>
    <message>
        <source>At the printer profile&apos;s scale, the cut contour reaches past the edge of the paper</source>
        <translation>Beim Maßstab des Druckerprofils reicht die Schneidkontur über den Rand des Papiers hinaus</translation>
    </message>
    <message>
        <source>%1; choose larger paper, or accept that a part of it is lost</source>
        <translation>%1; wählen Sie größeres Papier, oder nehmen Sie hin, dass ein Teil davon verloren geht</translation>
    </message>
    <message>
        <source>The registration marks are printed %1 mm farther inside than the pins of traveller and cradle, because this printer needs wider margins than the job&apos;s profile has. Before you use the pins, enter these margins in the profile and run the job again</source>
        <translation>Die Passmarken werden %1 mm weiter innen gedruckt, als die Passstifte von Laufkarte und Halterung stehen, weil dieser Drucker breitere Ränder braucht, als im Profil des Auftrags stehen. Tragen Sie diese Ränder in das Profil ein, und führen Sie den Auftrag erneut aus, bevor Sie die Stifte verwenden</translation>
    </message>
</context>
<context>
    <name>dipwright::ProfileController</name>
    <message>
        <source>Calibrated %1</source>
        <translation>%1 kalibriert</translation>
    </message>
    <message>
        <source>Use profile %1</source>
        <translation>Profil %1 verwenden</translation>
    </message>
</context>
<context>
    <name>dipwright::ProfilesDialog</name>
    <message>
        <source>Profiles (%1)</source>
        <translation>Profile (%1)</translation>
    </message>
    <message>
        <source>%1 (RGB)</source>
        <translation>%1 (RGB)</translation>
    </message>
    <message>
        <source>Copy…</source>
        <translation>Kopieren …</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren …</translation>
    </message>
    <message>
        <source>Printers</source>
        <translation>Drucker</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>Filme</translation>
    </message>
    <message>
        <source>Tanks</source>
        <translation>Becken</translation>
    </message>
    <message>
        <source>Comes with the program</source>
        <translation>Kommt mit dem Programm</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>Choose an ICC profile</source>
        <translation>ICC-Profil wählen</translation>
    </message>
    <message>
        <source>No ICC profile</source>
        <translation>Kein ICC-Profil</translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation>ICC-Profil</translation>
    </message>
    <message>
        <source>The printer&apos;s output profile, made for its ink and film. Sheets are then sent in the printer&apos;s own colours.</source>
        <translation>Das Ausgabeprofil des Druckers für seine Farben und den Film. Blätter werden dann in den Farben des Druckers gesendet.</translation>
    </message>
    <message>
        <source>A profile needs a name</source>
        <translation>Ein Profil braucht einen Namen</translation>
    </message>
    <message>
        <source>Name of the copy:</source>
        <translation>Name der Kopie:</translation>
    </message>
    <message>
        <source>ICC profiles (%1)</source>
        <translation>ICC-Profile (%1)</translation>
    </message>
    <message>
        <source>%1 (CMYK)</source>
        <translation>%1 (CMYK)</translation>
    </message>
    <message>
        <source>None (the printer receives sRGB)</source>
        <translation>Keines (der Drucker erhält sRGB)</translation>
    </message>
    <message>
        <source>&amp;Use in project</source>
        <translation>Im Projekt &amp;verwenden</translation>
    </message>
    <message>
        <source>Copies the profile and its values into the project. Later changes to the profile do not affect the project.</source>
        <translation>Kopiert das Profil und seine Werte in das Projekt. Spätere Änderungen am Profil wirken sich nicht auf das Projekt aus.</translation>
    </message>
    <message>
        <source>Makes your own copy of this profile.</source>
        <translation>Erstellt Ihre eigene Kopie dieses Profils.</translation>
    </message>
    <message>
        <source>A profile with this name already exists; choose another name</source>
        <translation>Ein Profil mit diesem Namen gibt es schon; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>Profile changed by another program</source>
        <translation>Profil von einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>Another program has changed the profile “%1” in the meantime.</source>
        <translation>Ein anderes Programm hat das Profil „%1“ inzwischen geändert.</translation>
    </message>
    <message>
        <source>Load the other version</source>
        <translation>Die andere Fassung laden</translation>
    </message>
    <message>
        <source>Keep &amp;mine</source>
        <translation>&amp;Meines behalten</translation>
    </message>
    <message>
        <source>Changes are saved at once. Profiles in italics come with the program. If you change one, your copy is used; “Remove” restores the original.</source>
        <translation>Änderungen werden sofort gespeichert. Kursive Profile kommen mit dem Programm. Ändern Sie eines, wird Ihre Kopie verwendet; „Entfernen“ stellt das Original wieder her.</translation>
    </message>
    <message>
        <source>Import profile</source>
        <translation>Profil importieren</translation>
    </message>
    <message>
        <source>Export profile</source>
        <translation>Profil exportieren</translation>
    </message>
    <message>
        <source>Copy profile</source>
        <translation>Profil kopieren</translation>
    </message>
    <message>
        <source>%1, copy</source>
        <translation>%1, Kopie</translation>
    </message>
    <message>
        <source>None (the ICC profile converts all pictures)</source>
        <translation>Keiner (das ICC-Profil wandelt alle Bilder um)</translation>
    </message>
    <message>
        <source>For pictures in CMYK</source>
        <translation>Für Bilder in CMYK</translation>
    </message>
    <message>
        <source>For pictures in RGB</source>
        <translation>Für Bilder in RGB</translation>
    </message>
    <message>
        <source>Device link</source>
        <translation>Device-Link</translation>
    </message>
    <message>
        <source>An ICC device link from RGB or CMYK to the printer&apos;s CMYK. It converts pictures of its kind in place of the ICC profile, for example to keep black text in black ink. Used only with a CMYK ICC profile.</source>
        <translation>Ein ICC-Device-Link von RGB oder CMYK in das CMYK des Druckers. Er wandelt Bilder seiner Art anstelle des ICC-Profils um, zum Beispiel damit schwarzer Text in schwarzer Tinte bleibt. Nur mit einem CMYK-ICC-Profil verwendet.</translation>
    </message>
    <message>
        <source>Choose a device link</source>
        <translation>Device-Link wählen</translation>
    </message>
    <message>
        <source>No device link</source>
        <translation>Kein Device-Link</translation>
    </message>
    <message>
        <source>A device link needs the printer&apos;s ICC profile, too; choose that first</source>
        <translation>Ein Device-Link braucht auch das ICC-Profil des Druckers; wählen Sie zuerst dieses</translation>
    </message>
</context>
<context>
    <name>dipwright::ProjectTree</name>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>The result is up to date.</source>
        <translation>Das Ergebnis ist aktuell.</translation>
    </message>
    <message>
        <source>Changed since the last run. Run again.</source>
        <translation>Seit dem letzten Lauf geändert. Starten Sie neu.</translation>
    </message>
    <message>
        <source>Not simulated yet.</source>
        <translation>Noch nicht simuliert.</translation>
    </message>
    <message>
        <source>Add second dip</source>
        <translation>Zweiten Tauchvorgang hinzufügen</translation>
    </message>
    <message>
        <source>Remove this dip</source>
        <translation>Diesen Tauchvorgang entfernen</translation>
    </message>
</context>
<context>
    <name>dipwright::PropertyField</name>
    <message>
        <source>%1 to %2%3</source>
        <translation>%1 bis %2%3</translation>
    </message>
    <message>
        <source>linked</source>
        <translation>verknüpft</translation>
    </message>
    <message>
        <source>Linked: typing one number sets the others as well</source>
        <translation>Verknüpft: eine eingegebene Zahl gilt auch für die anderen</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>%1 wählen</translation>
    </message>
    <message>
        <source>Choose the colour</source>
        <translation>Die Farbe wählen</translation>
    </message>
</context>
<context>
    <name>dipwright::PropertyPanel</name>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Film profile</source>
        <translation>Filmprofil</translation>
    </message>
    <message>
        <source>Tank profile</source>
        <translation>Beckenprofil</translation>
    </message>
    <message>
        <source>Printer profile</source>
        <translation>Druckerprofil</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Embedded in the project</source>
        <translation>Im Projekt enthalten</translation>
    </message>
    <message>
        <source>Triangles: %1</source>
        <translation>Dreiecke: %1</translation>
    </message>
    <message>
        <source>Volume: %1 cm³</source>
        <translation>Volumen: %1 cm³</translation>
    </message>
    <message>
        <source>Closed surface</source>
        <translation>Geschlossene Oberfläche</translation>
    </message>
    <message>
        <source>Surface with openings</source>
        <translation>Oberfläche mit Öffnungen</translation>
    </message>
    <message>
        <source>Texture of %1 × %2 pixels</source>
        <translation>Textur von %1 × %2 Bildpunkten</translation>
    </message>
    <message>
        <source>Reads the model&apos;s file again and keeps all settings.</source>
        <translation>Liest die Datei des Modells neu und behält alle Einstellungen.</translation>
    </message>
    <message>
        <source>Production</source>
        <translation>Produktion</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigenes</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>%1 wählen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>Best available</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>%1 (not available)</source>
        <translation>%1 (nicht verfügbar)</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solver</translation>
    </message>
    <message>
        <source>%1 (not installed)</source>
        <translation>%1 (nicht installiert)</translation>
    </message>
    <message>
        <source>The measured values of one film: size, swell, relaxation and sides.</source>
        <translation>Die gemessenen Werte eines Films: Größe, Quellung, Relaxation und Seiten.</translation>
    </message>
    <message>
        <source>The values of one tank. Its barriers hold the sides of the film.</source>
        <translation>Die Werte eines Beckens. Seine Barrieren halten die Seiten des Films.</translation>
    </message>
    <message>
        <source>The measured values of one printer: scale, margins, colours, ink limit and resolution.</source>
        <translation>Die gemessenen Werte eines Druckers: Maßstab, Ränder, Farben, Tintenlimit und Auflösung.</translation>
    </message>
    <message>
        <source>No texture (drop a picture on the window to add one)</source>
        <translation>Keine Textur (ziehen Sie ein Bild auf das Fenster, um eine hinzuzufügen)</translation>
    </message>
    <message>
        <source>Reload from disk</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Replace model…</source>
        <translation>Modell ersetzen …</translation>
    </message>
    <message>
        <source>Loads another model. Rotations and offsets are reset.</source>
        <translation>Lädt ein anderes Modell. Drehungen und Versatz werden zurückgesetzt.</translation>
    </message>
    <message>
        <source>Replace texture…</source>
        <translation>Textur ersetzen …</translation>
    </message>
    <message>
        <source>Replaces the texture of the model with another picture.</source>
        <translation>Ersetzt die Textur des Modells durch ein anderes Bild.</translation>
    </message>
    <message>
        <source>Marks for the seam</source>
        <translation>Marken für die Naht</translation>
    </message>
    <message>
        <source>Zones on the part</source>
        <translation>Zonen auf dem Teil</translation>
    </message>
    <message>
        <source>Compute tolerances…</source>
        <translation>Toleranzen berechnen …</translation>
    </message>
    <message>
        <source>Simulates dips with the expected deviations, each alone and all at once. Shows how far the colours land from their intended places.</source>
        <translation>Simuliert Tauchvorgänge mit den erwarteten Abweichungen, einzeln und alle zugleich. Zeigt, wie weit die Farben von ihrem vorgesehenen Ort entfernt landen.</translation>
    </message>
    <message>
        <source>Print with a misplaced second film</source>
        <translation>Druck mit verschobenem zweitem Film</translation>
    </message>
    <message>
        <source>Apply preset</source>
        <translation>Vorgabe anwenden</translation>
    </message>
    <message>
        <source>The program that simulates the dip. “Best available” uses a GPU if there is one.</source>
        <translation>Das Programm, das den Tauchvorgang simuliert. „Automatisch“ verwendet eine GPU, wenn es eine gibt.</translation>
    </message>
    <message>
        <source>Choose solver</source>
        <translation>Solver wählen</translation>
    </message>
    <message>
        <source>Read from %1</source>
        <translation>Gelesen aus %1</translation>
    </message>
    <message>
        <source>Size: %1 × %2 × %3</source>
        <translation>Größe: %1 × %2 × %3</translation>
    </message>
    <message>
        <source>Largest dimension</source>
        <translation>Größte Abmessung</translation>
    </message>
    <message>
        <source>Scales the model, with the marks on it, so that its largest dimension (along X, Y or Z) has this length.</source>
        <translation>Skaliert das Modell mit den Marken darauf, sodass seine größte Abmessung (längs X, Y oder Z) diese Länge hat.</translation>
    </message>
    <message>
        <source>To see it, choose “Finished part” in the 3D view. The sheets do not change.</source>
        <translation>Um ihn zu sehen, wählen Sie „Fertiges Teil“ in der 3D-Ansicht. Die Blätter ändern sich nicht.</translation>
    </message>
    <message>
        <source>Model of 2020</source>
        <translation>Modell von 2020</translation>
    </message>
    <message>
        <source>Production is the accurate film model and the default. Model of 2020 is the published film model, for comparison.</source>
        <translation>Produktion ist das genaue Filmmodell und der Standard. Modell von 2020 ist das veröffentlichte Filmmodell, zum Vergleich.</translation>
    </message>
    <message>
        <source>Change poses of path</source>
        <translation>Lagen des Wegs ändern</translation>
    </message>
    <message>
        <source>Masks on the part</source>
        <translation>Masken auf dem Teil</translation>
    </message>
    <message>
        <source>Tolerance of triangles</source>
        <translation>Toleranz der Dreiecke</translation>
    </message>
    <message>
        <source>The largest distance of the triangles from the surfaces of the CAD file. A smaller one shows curves more exactly and makes more triangles. Usual: 0.005 to 0.1 mm. Zones, masks and artwork stay.</source>
        <translation>Der größte Abstand der Dreiecke von den Flächen der CAD-Datei. Eine kleinere Toleranz zeigt Rundungen genauer und macht mehr Dreiecke. Üblich: 0,005 bis 0,1 mm. Zonen, Masken und Bilder bleiben.</translation>
    </message>
</context>
<context>
    <name>dipwright::QueueDialog</name>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Gescheitert</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Projects in the queue</source>
        <translation>Projekte in der Warteschlange</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Folder for the results</source>
        <translation>Ordner für die Ergebnisse</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>&amp;Wählen …</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1
Results: %2</source>
        <translation>%1
Ergebnisse: %2</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Job queue</source>
        <translation>Warteschlange</translation>
    </message>
    <message>
        <source>&amp;Add projects…</source>
        <translation>Projekte &amp;hinzufügen …</translation>
    </message>
    <message>
        <source>&amp;Cancel selected</source>
        <translation>&amp;Gewählte abbrechen</translation>
    </message>
    <message>
        <source>Cancel a&amp;ll</source>
        <translation>&amp;Alle abbrechen</translation>
    </message>
    <message>
        <source>&amp;Remove finished</source>
        <translation>&amp;Beendete entfernen</translation>
    </message>
    <message>
        <source>&amp;Open project</source>
        <translation>Projekt &amp;öffnen</translation>
    </message>
    <message>
        <source>Each added project gets a subfolder with its name here.</source>
        <translation>Jedes hinzugefügte Projekt erhält hier einen Unterordner mit seinem Namen.</translation>
    </message>
    <message>
        <source>Resul&amp;ts folder</source>
        <translation>&amp;Ordner für die Ergebnisse</translation>
    </message>
    <message>
        <source>Add projects</source>
        <translation>Projekte hinzufügen</translation>
    </message>
    <message>
        <source>%1 of %2 finished</source>
        <translation>%1 von %2 beendet</translation>
    </message>
    <message>
        <source>Projects are still running. Stop them?</source>
        <translation>Es werden noch Projekte gerechnet. Beenden?</translation>
    </message>
    <message>
        <source>Finished results are kept.</source>
        <translation>Fertige Ergebnisse bleiben erhalten.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Add projects. They run one after the other, each in its last saved version. The results are written to the results folder.</source>
        <translation>Fügen Sie Projekte hinzu. Sie laufen nacheinander, jedes in der zuletzt gespeicherten Fassung. Die Ergebnisse werden in den Ergebnisordner geschrieben.</translation>
    </message>
    <message>
        <source>Result of the selected project</source>
        <translation>Ergebnis des gewählten Projekts</translation>
    </message>
    <message>
        <source>At the tan&amp;k…</source>
        <translation>Am Bec&amp;ken …</translation>
    </message>
    <message>
        <source>Opens the tank-side page with the steps of all finished projects</source>
        <translation>Öffnet die Seite für das Becken mit den Schritten aller fertigen Projekte</translation>
    </message>
</context>
<context>
    <name>dipwright::ReadPhotos</name>
    <message>
        <source>The photo cannot be read; check its name and permissions</source>
        <translation>Das Foto kann nicht gelesen werden; prüfen Sie Namen und Rechte</translation>
    </message>
</context>
<context>
    <name>dipwright::Reader</name>
    <message>
        <source>This operating system cannot run the reader of models and pictures in a sandbox, so nothing was read. Use another system, or set DIPWRIGHT_READ_UNCONFINED=1 for files that you trust</source>
        <translation>Dieses Betriebssystem kann das Programm, das Modelle und Bilder liest, nicht in einer Sandbox ausführen; deshalb wurde nichts gelesen. Nehmen Sie ein anderes System, oder setzen Sie DIPWRIGHT_READ_UNCONFINED=1 für Dateien, denen Sie vertrauen</translation>
    </message>
</context>
<context>
    <name>dipwright::ReaderProcess</name>
    <message>
        <source>The program that reads models and pictures cannot be started: %1</source>
        <translation>Das Programm, das Modelle und Bilder liest, kann nicht gestartet werden: %1</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The code of the language of this translation: de, pt_BR …</extracomment>
        <translation>de</translation>
    </message>
    <message>
        <source>The program that reads models and pictures is missing; reinstall Dipwright</source>
        <translation>Das Programm, das Modelle und Bilder liest, fehlt; installieren Sie Dipwright neu</translation>
    </message>
    <message>
        <source>The file was not read, because the file reader returned invalid data for it; save it again</source>
        <translation>Die Datei wurde nicht gelesen, weil das Leseprogramm für sie ungültige Daten zurückgab; speichern Sie sie neu</translation>
    </message>
    <message>
        <source>The file was not read, because it made the file reader crash; save it again (a model as %1, a picture as PNG)</source>
        <translation>Die Datei wurde nicht gelesen, weil sie das Leseprogramm zum Absturz brachte; speichern Sie sie neu (ein Modell als %1, ein Bild als PNG)</translation>
    </message>
    <message>
        <source>This Dipwright was built without the reader of CAD files; save the model as %1, or use a Dipwright with CAD (dipwright-cad-reader)</source>
        <translation>Dieses Dipwright wurde ohne den Leser für CAD-Dateien gebaut; speichern Sie das Modell als %1, oder verwenden Sie ein Dipwright mit CAD (dipwright-cad-reader)</translation>
    </message>
    <message>
        <source>The CAD file was not read, because it made the file reader crash; save it again as STEP (AP214 or AP242) in the CAD program</source>
        <translation>Die CAD-Datei wurde nicht gelesen, weil sie das Leseprogramm zum Absturz brachte; speichern Sie sie im CAD-Programm neu als STEP (AP214 oder AP242)</translation>
    </message>
</context>
<context>
    <name>dipwright::ReplaceQuestion</name>
    <message>
        <source>%1 already contains %2. Replace them?</source>
        <translation>%1 enthält bereits %2. Ersetzen?</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
</context>
<context>
    <name>dipwright::ReportPanel</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Run the dip to see its figures.</source>
        <translation>Starten Sie den Tauchvorgang, um seine Zahlen zu sehen.</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solver</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>Film used</source>
        <translation>Film genutzt</translation>
    </message>
    <message>
        <source>Total coverage</source>
        <translation>Gesamte Abdeckung</translation>
    </message>
    <message>
        <source>Masked areas</source>
        <translation>Maskierte Flächen</translation>
    </message>
</context>
<context>
    <name>dipwright::ResultTabs</name>
    <message>
        <source>Changed since the last run. Run again.</source>
        <translation>Seit dem letzten Lauf geändert. Starten Sie neu.</translation>
    </message>
    <message>
        <source>%1, out of date</source>
        <translation>%1, veraltet</translation>
    </message>
</context>
<context>
    <name>dipwright::Results</name>
    <message>
        <source>Dark outline: film on the part · grey: unused film</source>
        <translation>Dunkler Umriss: Film auf dem Teil · grau: ungenutzter Film</translation>
    </message>
    <message>
        <source>There is no colour map of this name; choose one of %1</source>
        <translation>Eine Farbskala dieses Namens gibt es nicht; wählen Sie eine von %1</translation>
    </message>
    <message>
        <source>Preparing the proof</source>
        <translation>Vorschau wird vorbereitet</translation>
    </message>
    <message>
        <source>Drawing the proof</source>
        <translation>Vorschau wird gezeichnet</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Von rechts</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Von hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Von links</translation>
    </message>
    <message>
        <source>Stretch of the film</source>
        <translation>Dehnung des Films</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>stretch
mm per mm</source>
        <translation>Dehnung
mm je mm</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 und mehr</translation>
    </message>
    <message>
        <source>Wrinkling of the film</source>
        <translation>Faltenbildung des Films</translation>
    </message>
    <message>
        <source>Smaller principal stretch; below 1 the film is compressed and may fold</source>
        <translation>Kleinere Hauptdehnung; unter 1 ist der Film gestaucht und kann Falten werfen</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mehr</translation>
    </message>
    <message>
        <source>%1: %2 mm², %3 %</source>
        <translation>%1: %2 mm², %3 %</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>Von unten</translation>
    </message>
    <message>
        <source>Film of %1</source>
        <translation>Film von %1</translation>
    </message>
    <message>
        <source>Tolerance of the sheet</source>
        <translation>Toleranz des Blatts</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>a number and its unit</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Both, in the overlap</source>
        <translation>Beide, in der Überlappung</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Nicht bemalt</translation>
    </message>
    <message>
        <source>Seam: %1 mm</source>
        <translation>Naht: %1 mm</translation>
    </message>
    <message>
        <source>Drawing the coverage picture</source>
        <translation>Abdeckungsbild wird gezeichnet</translation>
    </message>
    <message>
        <source>Stretch of the film on the part: min. %1 · mean %2 · 95 % below %3 · max. %4</source>
        <translation>Dehnung des Films auf dem Teil: min. %1 · Mittel %2 · 95 % unter %3 · max. %4</translation>
    </message>
    <message>
        <source>On the part: %1 % of the film is compressed by over 1 % · smallest stretch %2</source>
        <translation>Auf dem Teil: %1 % des Films sind um über 1 % gestaucht · kleinste Dehnung %2</translation>
    </message>
    <message>
        <source>Numerical error of the sheet</source>
        <translation>Numerischer Fehler des Blatts</translation>
    </message>
    <message>
        <source>error
%1</source>
        <translation>Fehler
%1</translation>
    </message>
    <message>
        <source>How far handling may move the image on the part; ink side up</source>
        <translation>Wie weit die Handhabung das Bild auf dem Teil verschieben kann; Farbseite oben</translation>
    </message>
    <message>
        <source>shift
± %1</source>
        <translation>Verschiebung
± %1</translation>
    </message>
    <message>
        <source>Dark outline: film on the part · pale: unused film</source>
        <translation>Dunkler Umriss: Film auf dem Teil · blass: ungenutzter Film</translation>
    </message>
    <message>
        <source>How far the image may be off because of the film&apos;s cells and the solver&apos;s steps; ink side up</source>
        <translation>Wie weit das Bild wegen der Zellen des Films und der Schritte des Solvers abweichen kann; Farbseite oben</translation>
    </message>
    <message>
        <source>Mean stretch at each point: final length divided by rest length; ink side up</source>
        <translation>Mittlere Dehnung an jedem Punkt: Endlänge geteilt durch Ruhelänge; Farbseite oben</translation>
    </message>
    <message>
        <source>On the part: 95 % of the image moves by ±%1 or less</source>
        <translation>Auf dem Teil: 95 % des Bilds verschieben sich um höchstens ±%1</translation>
    </message>
    <message>
        <source>Limit: %1 · black: painted by only one of the compared dips</source>
        <translation>Grenze: %1 · schwarz: nur von einem der verglichenen Tauchvorgänge bedeckt</translation>
    </message>
    <message>
        <source>Difference of two sheets</source>
        <translation>Unterschied zweier Blätter</translation>
    </message>
    <message>
        <source>How far the image is from its place on the other sheet; ink side up</source>
        <translation>Wie weit das Bild von seiner Stelle auf dem anderen Blatt entfernt ist; Farbseite oben</translation>
    </message>
    <message>
        <source>distance
%1</source>
        <translation>Abstand
%1</translation>
    </message>
    <message>
        <source>Black: painted in only one of the two states</source>
        <translation>Schwarz: nur in einem der beiden Stände bemalt</translation>
    </message>
</context>
<context>
    <name>dipwright::ResultsPanel</name>
    <message>
        <source>Reverse texture</source>
        <translation>Umgekehrte Textur</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>How much the film has stretched, and where</source>
        <translation>Wie viel sich der Film gedehnt hat und wo</translation>
    </message>
    <message>
        <source>The figures of the last run</source>
        <translation>Die Zahlen des letzten Laufs</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Run the dip to see the image for the film.</source>
        <translation>Starten Sie den Tauchvorgang, um das Bild für den Film zu sehen.</translation>
    </message>
    <message>
        <source>Run the dip to see the finished part.</source>
        <translation>Starten Sie den Tauchvorgang, um das fertige Teil zu sehen.</translation>
    </message>
    <message>
        <source>Run the dip to see the page as it will be printed.</source>
        <translation>Starten Sie den Tauchvorgang, um die Seite zu sehen, wie sie gedruckt wird.</translation>
    </message>
    <message>
        <source>Shares of the dips</source>
        <translation>Anteile der Tauchvorgänge</translation>
    </message>
    <message>
        <source>Shows which areas each dip paints, from six sides and on both films</source>
        <translation>Zeigt, welche Flächen jeder Tauchvorgang bemalt, von sechs Seiten und auf beiden Filmen</translation>
    </message>
    <message>
        <source>Shows which areas each dip paints, over the sheet of this dip</source>
        <translation>Zeigt, welche Flächen jeder Tauchvorgang bemalt, über dem Blatt dieses Tauchvorgangs</translation>
    </message>
    <message>
        <source>Without white</source>
        <translation>Ohne Weiß</translation>
    </message>
    <message>
        <source>Shows the ink on the part&apos;s own colour, without the white</source>
        <translation>Zeigt die Druckfarbe auf der Farbe des Teils, ohne das Weiß</translation>
    </message>
    <message>
        <source>Whether to print the sheet, and which places to check first</source>
        <translation>Ob das Blatt gedruckt werden soll und welche Stellen zuerst zu prüfen sind</translation>
    </message>
    <message>
        <source>The reverse texture: the image for the film</source>
        <translation>Die umgekehrte Textur: das Bild für den Film</translation>
    </message>
    <message>
        <source>The finished part</source>
        <translation>Das fertige Teil</translation>
    </message>
    <message>
        <source>The page as it will be printed</source>
        <translation>Die Seite, wie sie gedruckt wird</translation>
    </message>
</context>
<context>
    <name>dipwright::ReverseTexture</name>
    <message>
        <source>Reversing the texture</source>
        <translation>Textur wird umgekehrt</translation>
    </message>
    <message>
        <source>The film image is too large for this computer&apos;s memory; choose a lower resolution</source>
        <translation>Das Filmbild ist zu groß für den Speicher dieses Rechners; wählen Sie eine kleinere Auflösung</translation>
    </message>
    <message>
        <source>Adding bleed at the edges</source>
        <translation>Beschnitt wird an den Rändern hinzugefügt</translation>
    </message>
</context>
<context>
    <name>dipwright::SeamFields</name>
    <message>
        <source>Whole face</source>
        <translation>Ganze Fläche</translation>
    </message>
    <message>
        <source>Keeps the seam away</source>
        <translation>Hält die Naht fern</translation>
    </message>
    <message>
        <source>Allows the seam</source>
        <translation>Erlaubt die Naht</translation>
    </message>
    <message>
        <source>Marks the whole flat face that you click, up to its edges.</source>
        <translation>Markiert die ganze ebene Fläche, die Sie anklicken, bis zu ihren Kanten.</translation>
    </message>
    <message>
        <source>Assigns the place to %1</source>
        <translation>Weist die Stelle %1 zu</translation>
    </message>
    <message>
        <source>What a click or drag on the part does. Assign areas to the other dip to move the seam. With “Run live” the seam is updated at once.</source>
        <translation>Was ein Klick oder Ziehen auf dem Teil bewirkt. Weisen Sie dem anderen Tauchvorgang Flächen zu, um die Naht zu verschieben. Mit „Laufend neu rechnen“ folgt die Naht sofort.</translation>
    </message>
</context>
<context>
    <name>dipwright::SearchController</name>
    <message>
        <source>Searching poses</source>
        <translation>Lagen werden gesucht</translation>
    </message>
    <message>
        <source>The search has finished. The best pose is at the top.</source>
        <translation>Die Suche ist fertig. Die beste Lage steht oben.</translation>
    </message>
    <message>
        <source>The search was stopped. The best pose so far is at the top.</source>
        <translation>Die Suche wurde abgebrochen. Die bisher beste Lage steht oben.</translation>
    </message>
    <message>
        <source>Pose search</source>
        <translation>Lagensuche</translation>
    </message>
    <message>
        <source>Change search settings</source>
        <translation>Sucheinstellungen ändern</translation>
    </message>
</context>
<context>
    <name>dipwright::SearchPage</name>
    <message>
        <source>&amp;Search</source>
        <translation>&amp;Suchen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>One dip</source>
        <translation>Ein Tauchvorgang</translation>
    </message>
    <message>
        <source>Two dips, judged together</source>
        <translation>Zwei Tauchvorgänge, gemeinsam beurteilt</translation>
    </message>
    <message>
        <source> poses</source>
        <translation> Lagen</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Fortschritt der Suche</translation>
    </message>
    <message>
        <source>%1 of %2 dips</source>
        <translation>%1 von %2 Tauchvorgängen</translation>
    </message>
    <message>
        <source>Rank %1</source>
        <translation>Rang %1</translation>
    </message>
    <message>
        <source>&amp;Use this pose</source>
        <translation>Diese Lage &amp;verwenden</translation>
    </message>
    <message>
        <source>Side &amp;by side…</source>
        <translation>&amp;Nebeneinander …</translation>
    </message>
    <message>
        <source>Dips</source>
        <translation>Tauchvorgänge</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>Weights and limits</source>
        <translation>Gewichte und Grenzen</translation>
    </message>
    <message>
        <source>Leaves the processor to other programs. The search continues where it stopped.</source>
        <translation>Überlässt den Prozessor anderen Programmen. Die Suche geht weiter, wo sie angehalten wurde.</translation>
    </message>
    <message>
        <source>Ends the search and keeps the best poses found</source>
        <translation>Beendet die Suche und behält die besten gefundenen Lagen</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Rank %1 compared with rank %2: %3</source>
        <translation>Rang %1 verglichen mit Rang %2: %3</translation>
    </message>
    <message>
        <source>The project&apos;s own pose</source>
        <translation>Die Lage des Projekts</translation>
    </message>
    <message>
        <source>Number of poses that are simulated with a coarse film. They are chosen from %1 poses that are judged by the part&apos;s shape alone. The best simulated poses are refined.</source>
        <translation>Anzahl der Lagen, die mit einem groben Film simuliert werden. Sie werden aus %1 Lagen ausgewählt, die nur nach der Form des Teils beurteilt werden. Die besten simulierten Lagen werden verfeinert.</translation>
    </message>
    <message>
        <source>The same seed gives the same table. Another seed tries other directions.</source>
        <translation>Derselbe Startwert ergibt dieselbe Tabelle. Ein anderer Startwert probiert andere Richtungen.</translation>
    </message>
    <message>
        <source>Shows two selected poses side by side with linked cameras. If only one pose is selected, shows it beside the project&apos;s own pose.</source>
        <translation>Zeigt zwei ausgewählte Lagen nebeneinander mit gekoppelten Kameras. Ist nur eine Lage ausgewählt, zeigt es sie neben der Lage des Projekts.</translation>
    </message>
    <message>
        <source>Click a pose to see its film on the part, also during the search. Undo brings back your own pose. Select two poses to compare them.</source>
        <translation>Klicken Sie auf eine Lage, um ihren Film auf dem Teil zu sehen, auch während der Suche. Rückgängig stellt Ihre eigene Lage wieder her. Wählen Sie zwei Lagen, um sie zu vergleichen.</translation>
    </message>
    <message>
        <source>Sets the dips of the project to the pose that is selected in the table. Undo takes this back in one step.</source>
        <translation>Stellt die Tauchvorgänge des Projekts auf die Lage ein, die in der Tabelle ausgewählt ist. Rückgängig nimmt das in einem Schritt zurück.</translation>
    </message>
    <message>
        <source>Waiting until the dip of the project has finished</source>
        <translation>Wartet, bis der Tauchvorgang des Projekts fertig ist</translation>
    </message>
    <message>
        <source>Try paths</source>
        <translation>Wege probieren</translation>
    </message>
    <message>
        <source>Also tries paths for the best poses: the part enters the water tilted and is levelled on the way down, goes down slanted, or, if a depth is set, rolls. So air can escape, and the film reaches further. Takes about twice as long.</source>
        <translation>Probiert für die besten Lagen auch Wege: Das Teil taucht gekippt ein und wird beim Absenken waagerecht gestellt, geht schräg nach unten oder rollt, wenn eine Tiefe eingestellt ist. So kann Luft entweichen, und der Film reicht weiter. Dauert etwa doppelt so lange.</translation>
    </message>
    <message>
        <source>Whether one dip paints the part, or two dips from different sides.</source>
        <translation>Ob ein Tauchvorgang das Teil bemalt oder zwei von verschiedenen Seiten.</translation>
    </message>
    <message>
        <source>Dipping the best pose with smaller cells</source>
        <translation>Die beste Lage wird mit kleineren Zellen getaucht</translation>
    </message>
    <message>
        <source>The project has changed since this search. Search again.</source>
        <translation>Das Projekt wurde seit dieser Suche geändert. Suchen Sie neu.</translation>
    </message>
</context>
<context>
    <name>dipwright::ServerController</name>
    <message>
        <source>Running on the server</source>
        <translation>Lauf auf dem Server</translation>
    </message>
    <message>
        <source>The project was changed while the server ran it. Send it again.</source>
        <translation>Das Projekt wurde geändert, während der Server rechnete. Senden Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The server has simulated the dips.</source>
        <translation>Der Server hat die Tauchvorgänge simuliert.</translation>
    </message>
    <message>
        <source>Send to server</source>
        <translation>An Server senden</translation>
    </message>
</context>
<context>
    <name>dipwright::ServerDialog</name>
    <message>
        <source>Paste the server&apos;s token, or write the path of its file</source>
        <translation>Fügen Sie das Token des Servers ein, oder schreiben Sie den Pfad seiner Datei</translation>
    </message>
    <message>
        <source>Send to server</source>
        <translation>An Server senden</translation>
    </message>
    <message>
        <source>Where dipwright-cli serve listens: a port of this computer, such as 127.0.0.1:8137, or the path of a socket. Another computer is reached through an SSH tunnel.</source>
        <translation>Wo dipwright-cli serve erreichbar ist: ein Port dieses Rechners, etwa 127.0.0.1:8137, oder der Pfad eines Sockets. Einen anderen Rechner erreichen Sie durch einen SSH-Tunnel.</translation>
    </message>
    <message>
        <source>The token that the server asks for, or the path of the file that holds it. Only the path is remembered.</source>
        <translation>Das Token, das der Server verlangt, oder der Pfad der Datei, in der es steht. Nur der Pfad wird gemerkt.</translation>
    </message>
    <message>
        <source>The server simulates the dips of this project. Its results then appear here like those of a run on this computer.</source>
        <translation>Der Server simuliert die Tauchvorgänge dieses Projekts. Seine Ergebnisse erscheinen dann hier wie die eines Laufs auf diesem Rechner.</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>&amp;Adresse</translation>
    </message>
    <message>
        <source>&amp;Token or its file</source>
        <translation>&amp;Token oder seine Datei</translation>
    </message>
    <message>
        <source>&amp;Send</source>
        <translation>&amp;Senden</translation>
    </message>
    <message>
        <source>There is no such file</source>
        <translation>Diese Datei gibt es nicht</translation>
    </message>
</context>
<context>
    <name>dipwright::Sheet</name>
    <message>
        <source>The cut contour with its bleed reaches %1 mm from the ink, past the edge of this job&apos;s sheet; choose a smaller distance or bleed, or a cut contour along the film&apos;s edge</source>
        <translation>Die Schneidkontur mit ihrem Beschnitt reicht %1 mm über die Farbe hinaus und damit über den Rand des Blatts dieses Auftrags; wählen Sie einen kleineren Abstand oder Beschnitt oder eine Schneidkontur am Filmrand</translation>
    </message>
    <message>
        <source>The setting “%1” differs between this job and %2; give both the same value</source>
        <translation>Die Einstellung „%1“ ist in diesem Auftrag anders als in %2; geben Sie beiden denselben Wert</translation>
    </message>
    <message>
        <source>Bleed at the cut contour</source>
        <translation>Beschnitt an der Schneidkontur</translation>
    </message>
    <message>
        <source>Distance of the cut contour</source>
        <translation>Abstand der Schneidkontur</translation>
    </message>
    <message>
        <source>Name of the cut contour</source>
        <translation>Name der Schneidkontur</translation>
    </message>
    <message>
        <source>Cut contour</source>
        <translation>Schneidkontur</translation>
    </message>
    <message>
        <source>With its marks, this job&apos;s sheet needs %1 × %2 mm, but the roll has only %3 × %4 mm inside its edges; use a larger roll or a smaller film</source>
        <translation>Mit seinen Marken braucht das Blatt dieses Auftrags %1 × %2 mm, die Rolle hat innerhalb ihrer Ränder aber nur %3 × %4 mm; verwenden Sie eine größere Rolle oder einen kleineren Film</translation>
    </message>
    <message>
        <source>The sheet&apos;s PDF cannot be written: %1</source>
        <translation>Das PDF des Blatts kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>The sheet&apos;s TIFF cannot be written: %1</source>
        <translation>Das TIFF des Blatts kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Unknown paper &quot;%1&quot;; choose film, A4, A3, Letter or custom</source>
        <translation>Unbekanntes Papier „%1“; wählen Sie film, A4, A3, Letter oder custom</translation>
    </message>
    <message>
        <source>The paper of %1 × %2 mm is smaller than the film of %3 × %4 mm; choose larger paper, turn it or make the film smaller</source>
        <translation>Das Papier von %1 × %2 mm ist kleiner als der Film von %3 × %4 mm; wählen Sie größeres Papier, drehen Sie es oder verkleinern Sie den Film</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Auftrag %1</translation>
    </message>
    <message>
        <source>Dip %1, copy %2 of %3</source>
        <translation>Tauchvorgang %1, Exemplar %2 von %3</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 · Film %4 · Scale %5</source>
        <translation>%1 · %2 · %3 · Film %4 · Maßstab %5</translation>
    </message>
    <message>
        <source>This job&apos;s sheet has %1 dpi, but the sheet of %2 has %3 dpi; give both the same resolution</source>
        <translation>Das Blatt dieses Auftrags hat %1 dpi, das Blatt von %2 aber %3 dpi; geben Sie beiden dieselbe Auflösung</translation>
    </message>
    <message>
        <source>%1 pieces cannot be packed; choose 1 to %2 pieces</source>
        <translation>%1 Stücke können nicht zusammengelegt werden; wählen Sie 1 bis %2 Stücke</translation>
    </message>
    <message>
        <source>With its marks, this job&apos;s sheet needs %1 × %2 mm, but the film has only %3 × %4 mm inside its edges; use a larger film</source>
        <translation>Mit seinen Marken braucht das Blatt dieses Auftrags %1 × %2 mm, der Film hat innerhalb seiner Ränder aber nur %3 × %4 mm; verwenden Sie einen größeren Film</translation>
    </message>
    <message>
        <source>The copies need %1 films, more than the limit of %2; choose fewer copies</source>
        <translation>Die Exemplare brauchen %1 Filme, mehr als die höchstens %2; wählen Sie weniger Exemplare</translation>
    </message>
    <message>
        <source>A film of %1 × %2 mm at %3 dpi needs an image outside the range of 1 to %4 pixels per side; choose another resolution or film size</source>
        <translation>Ein Film von %1 × %2 mm bei %3 dpi braucht ein Bild außerhalb des Bereichs von 1 bis %4 Pixeln je Seite; wählen Sie eine andere Auflösung oder Filmgröße</translation>
    </message>
    <message>
        <source>The sheet&apos;s PNG cannot be written: %1</source>
        <translation>Das PNG des Blatts kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>The sheet needs more than %1 pages of this paper; use larger paper</source>
        <translation>Das Blatt braucht mehr als %1 Seiten dieses Papiers; verwenden Sie größeres Papier</translation>
    </message>
    <message>
        <source>This job&apos;s spot ink %1 has another colour or printing order than in another job; give it the same colour and order in both jobs</source>
        <translation>Die Sonderfarbe %1 hat in diesem Auftrag eine andere Farbe oder Druckreihenfolge als in einem anderen Auftrag; geben Sie ihr in beiden Aufträgen dieselbe Farbe und Reihenfolge</translation>
    </message>
    <message>
        <source>This job&apos;s white layer differs from the white layer of %1; give both the same kind of white and the same ink name</source>
        <translation>Die Weißschicht dieses Auftrags unterscheidet sich von der Weißschicht von %1; geben Sie beiden dieselbe Art Weiß und denselben Tintennamen</translation>
    </message>
    <message>
        <source>This job&apos;s sheet contains no ink; remove the job from the film</source>
        <translation>Das Blatt dieses Auftrags enthält keine Farbe; entfernen Sie den Auftrag vom Film</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm is too small for a tile of the sheet; use larger paper</source>
        <translation>Papier von %1 × %2 mm ist zu klein für eine Kachel des Blatts; verwenden Sie größeres Papier</translation>
    </message>
    <message>
        <source>Film %1 of %2, 1 piece</source>
        <translation>Film %1 von %2, 1 Stück</translation>
    </message>
    <message>
        <source>Film %1 of %2, %3 pieces</source>
        <translation>Film %1 von %2, %3 Stücke</translation>
    </message>
    <message>
        <source>Film %1 · Scale %2 · %3</source>
        <translation>Film %1 · Maßstab %2 · %3</translation>
    </message>
    <message>
        <source>A film of %1 mm is longer than the limit of %2 mm; choose a shorter film</source>
        <translation>Ein Film von %1 mm ist länger als die Grenze von %2 mm; wählen Sie einen kürzeren Film</translation>
    </message>
    <message>
        <source>Job %1 · %2 · copy %3 of %4</source>
        <translation>Auftrag %1 · %2 · Exemplar %3 von %4</translation>
    </message>
    <message>
        <source>This job&apos;s sheet is printed in %1 passes, but the sheet of %2 in %3; give both the same number of passes</source>
        <translation>Das Blatt dieses Auftrags wird in %1 Durchgängen gedruckt, das Blatt von %2 aber in %3; geben Sie beiden dieselbe Zahl von Durchgängen</translation>
    </message>
    <message>
        <source>Row %2 of %3, column %4 of %5 · job %1 · %6 · %7 · cut along the dashed lines</source>
        <translation>Zeile %2 von %3, Spalte %4 von %5 · Auftrag %1 · %6 · %7 · an den gestrichelten Linien schneiden</translation>
    </message>
    <message>
        <source>The marks, the ruler or the job line cover a part of the picture, because there is no room beside it. Use larger film or paper, or do not print them</source>
        <translation>Die Marken, das Lineal oder die Auftragszeile verdecken einen Teil des Bildes, weil daneben kein Platz ist. Verwenden Sie einen größeren Film oder größeres Papier, oder drucken Sie sie nicht</translation>
    </message>
    <message>
        <source>The ink %1 is a spot ink in one job and the white ink in another; rename one of them</source>
        <translation>Die Farbe %1 ist in einem Auftrag eine Sonderfarbe und in einem anderen das Weiß; benennen Sie eine davon um</translation>
    </message>
    <message>
        <source>This job&apos;s spot ink %1 is named %2 in another job; write both alike, with the same capital letters</source>
        <translation>Die Sonderfarbe %1 dieses Auftrags heißt in einem anderen %2; schreiben Sie beide gleich, mit denselben Großbuchstaben</translation>
    </message>
</context>
<context>
    <name>dipwright::SheetCorrection</name>
    <message>
        <source>Dip %1: %2 places measured on one part, errors up to %3 mm. Measure three parts or more to see which errors repeat.</source>
        <translation>Tauchvorgang %1: %2 Stellen auf einem Teil gemessen, Fehler bis zu %3 mm. Messen Sie drei Teile oder mehr, um zu sehen, welche Fehler sich wiederholen.</translation>
    </message>
    <message>
        <source>Blue: correction of the next sheet, to the same scale</source>
        <translation>Blau: Korrektur des nächsten Blatts, im selben Maßstab</translation>
    </message>
    <message>
        <source>Dip %1: %2 places measured on %3 parts. The repeating error is up to %4 mm; places less than %5 mm apart have similar errors. Scatter: %6 mm for single places, %7 mm for whole parts.</source>
        <translation>Tauchvorgang %1: %2 Stellen auf %3 Teilen gemessen. Der wiederkehrende Fehler beträgt bis zu %4 mm; Stellen mit weniger als %5 mm Abstand haben ähnliche Fehler. Streuung: %6 mm bei einzelnen Stellen, %7 mm bei ganzen Teilen.</translation>
    </message>
    <message>
        <source>The measured errors of dip %1 contradict each other, so a correction would fold or mirror the sheet; check the measured places, or remove the part from the job or turn the correction off</source>
        <translation>Die gemessenen Fehler von Tauchvorgang %1 widersprechen sich, eine Korrektur würde das Blatt falten oder spiegeln; prüfen Sie die gemessenen Stellen, entfernen Sie das Teil aus dem Auftrag oder schalten Sie die Korrektur aus</translation>
    </message>
    <message>
        <source>The measured parts move the picture by up to %1 mm and change lengths by %2 %. More than %3 mm or %4 % is unusual. Check the measured places, or turn the correction off.</source>
        <translation>Die gemessenen Teile verschieben das Bild um bis zu %1 mm und ändern Längen um %2 %. Mehr als %3 mm oder %4 % ist unüblich. Prüfen Sie die gemessenen Stellen, oder schalten Sie die Korrektur aus.</translation>
    </message>
    <message>
        <source>Red: mean measured error (parts: %1), scale %2:1</source>
        <translation>Rot: mittlerer gemessener Fehler (Teile: %1), Maßstab %2:1</translation>
    </message>
</context>
<context>
    <name>dipwright::SnapshotsDialog</name>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>Schnappschüsse</translation>
    </message>
    <message>
        <source>Name of the snapshot</source>
        <translation>Name des Schnappschusses</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>Verglichen mit</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>Verglichen mit %1</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>All settings are the same.</source>
        <translation>Alle Einstellungen sind gleich.</translation>
    </message>
    <message>
        <source>Settings that differ: %1</source>
        <translation>Einstellungen, die sich unterscheiden: %1</translation>
    </message>
    <message>
        <source>&amp;Take snapshot</source>
        <translation>Schnappschuss &amp;aufnehmen</translation>
    </message>
    <message>
        <source>R&amp;estore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Side by side…</source>
        <translation>&amp;Nebeneinander …</translation>
    </message>
    <message>
        <source>Snapshots, oldest first</source>
        <translation>Schnappschüsse, die ältesten zuerst</translation>
    </message>
    <message>
        <source>The name under which the settings are saved in the project file</source>
        <translation>Der Name, unter dem die Einstellungen in der Projektdatei gespeichert werden</translation>
    </message>
    <message>
        <source>Restores the settings of the snapshot. Model, photos and measured parts stay. This can be undone.</source>
        <translation>Stellt die Einstellungen des Schnappschusses wieder her. Modell, Fotos und gemessene Teile bleiben. Das lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Compared with the current project</source>
        <translation>Verglichen mit dem aktuellen Projekt</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Aktuell</translation>
    </message>
    <message>
        <source>A snapshot saves the project&apos;s settings under a name in the project file.</source>
        <translation>Ein Schnappschuss speichert die Einstellungen des Projekts unter einem Namen in der Projektdatei.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Shows both versions side by side in linked views. Dips that have no result yet are run first.</source>
        <translation>Zeigt beide Fassungen nebeneinander in gekoppelten Ansichten. Tauchvorgänge ohne Ergebnis werden zuerst gerechnet.</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>Schnappschuss</translation>
    </message>
</context>
<context>
    <name>dipwright::SolverPage</name>
    <message>
        <source>Solvers</source>
        <translation>Solver</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solver</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>%1 by %2
%3</source>
        <translation>%1 von %2
%3</translation>
    </message>
    <message>
        <source>Put solver plugins into %1</source>
        <translation>Legen Sie Solver-Plugins in %1</translation>
    </message>
    <message>
        <source>Choose the solver of a project under Dipping. “Best available” uses the best solver that can run on this computer.</source>
        <translation>Den Solver eines Projekts wählen Sie unter „Tauchen“. „Automatisch“ verwendet den besten, der auf diesem Rechner laufen kann.</translation>
    </message>
    <message>
        <source>No solver found</source>
        <translation>Kein Solver gefunden</translation>
    </message>
    <message>
        <source>Checking whether this solver can run here …</source>
        <translation>Es wird geprüft, ob dieser Solver hier laufen kann …</translation>
    </message>
</context>
<context>
    <name>dipwright::StartPage</name>
    <message>
        <source>Recent projects</source>
        <translation>Letzte Projekte</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Projects that you open or save appear here.</source>
        <translation>Projekte, die Sie öffnen oder speichern, erscheinen hier.</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Aus dieser Liste entfernen</translation>
    </message>
    <message>
        <source>Models and projects can also be dropped on the window.</source>
        <translation>Modelle und Projekte können auch auf das Fenster gezogen werden.</translation>
    </message>
    <message>
        <source>Start from a textured model: %1.</source>
        <translation>Beginnen Sie mit einem texturierten Modell: %1.</translation>
    </message>
    <message>
        <source>From a textured model to a printable film.</source>
        <translation>Vom texturierten Modell zum druckbaren Film.</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>Neues Projekt …</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Projekt öffnen …</translation>
    </message>
    <message>
        <source>Continue with a saved project.</source>
        <translation>Setzen Sie ein gespeichertes Projekt fort.</translation>
    </message>
    <message>
        <source>Quick tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Explains the window in six steps.</source>
        <translation>Erklärt das Fenster in sechs Schritten.</translation>
    </message>
</context>
<context>
    <name>dipwright::StatusLine</name>
    <message>
        <source>Value under the cursor</source>
        <translation>Wert unter dem Zeiger</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>The job does not respond. Save your work, then close the window to end the job.</source>
        <translation>Der Auftrag reagiert nicht. Speichern Sie Ihre Arbeit und schließen Sie dann das Fenster, um ihn zu beenden.</translation>
    </message>
    <message>
        <source>Cancel saving</source>
        <translation>Speichern abbrechen</translation>
    </message>
    <message>
        <source>Cancel saving. The file stays as it was.</source>
        <translation>Speichern abbrechen. Die Datei bleibt, wie sie war.</translation>
    </message>
</context>
<context>
    <name>dipwright::StretchPanel</name>
    <message>
        <source>Automatic range</source>
        <translation>Bereich automatisch</translation>
    </message>
    <message>
        <source>Lowest value</source>
        <translation>Kleinster Wert</translation>
    </message>
    <message>
        <source>Highest value</source>
        <translation>Größter Wert</translation>
    </message>
    <message>
        <source>Mark above</source>
        <translation>Markieren über</translation>
    </message>
    <message>
        <source>Limit above which film is marked</source>
        <translation>Grenze, über der Film markiert wird</translation>
    </message>
    <message>
        <source>Isolines</source>
        <translation>Isolinien</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Area stretch</source>
        <translation>Flächendehnung</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Größte Dehnung</translation>
    </message>
    <message>
        <source>Smallest stretch</source>
        <translation>Kleinste Dehnung</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>Farbskala</translation>
    </message>
    <message>
        <source>Colour map; all are safe for colour-blind readers.</source>
        <translation>Farbskala; alle sind auch für Farbenblinde lesbar.</translation>
    </message>
    <message>
        <source>Stretch map</source>
        <translation>Dehnungskarte</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Save the map or its numbers</source>
        <translation>Die Karte oder ihre Zahlen speichern</translation>
    </message>
    <message>
        <source>Picture (PNG)…</source>
        <translation>Bild (PNG) …</translation>
    </message>
    <message>
        <source>Table (CSV)…</source>
        <translation>Tabelle (CSV) …</translation>
    </message>
    <message>
        <source>Film (VTP)…</source>
        <translation>Film (VTP) …</translation>
    </message>
    <message>
        <source>Run the dip to see how the film stretches.</source>
        <translation>Starten Sie den Tauchvorgang, um zu sehen, wie sich der Film dehnt.</translation>
    </message>
    <message>
        <source>What the map shows.</source>
        <translation>Was die Karte zeigt.</translation>
    </message>
    <message>
        <source>Shows all film over the limit in one warning colour.</source>
        <translation>Zeigt allen Film über der Grenze in einer Warnfarbe.</translation>
    </message>
    <message>
        <source>Lines of equal value on the map.</source>
        <translation>Linien gleichen Wertes auf der Karte.</translation>
    </message>
    <message>
        <source>On the part: mean %1 · 95 % below %2 · largest %3</source>
        <translation>Auf dem Teil: Mittel %1 · 95 % unter %2 · größte %3</translation>
    </message>
    <message>
        <source>Length after the dip divided by length before it, averaged over the directions around each point.</source>
        <translation>Länge nach dem Tauchvorgang geteilt durch Länge davor, gemittelt über die Richtungen um jeden Punkt.</translation>
    </message>
    <message>
        <source>Area after the dip divided by area before it. The ink thins by this factor.</source>
        <translation>Fläche nach dem Tauchvorgang geteilt durch Fläche davor. Um diesen Faktor wird die Farbe dünner.</translation>
    </message>
    <message>
        <source>The stretch in the direction in which the film is stretched most.</source>
        <translation>Die Dehnung in der Richtung, in der der Film am stärksten gedehnt ist.</translation>
    </message>
    <message>
        <source>The stretch in the direction in which the film is stretched least. Below 1, the film wrinkles.</source>
        <translation>Die Dehnung in der Richtung, in der der Film am wenigsten gedehnt ist. Unter 1 wirft der Film Falten.</translation>
    </message>
    <message>
        <source>Fits the colours to the values on the part. If off, the scale runs between the two numbers on the right, so that you can compare maps.</source>
        <translation>Passt die Farben an die Werte auf dem Teil an. Ohne Häkchen reicht die Skala von der einen zur anderen Zahl rechts, damit Sie Karten vergleichen können.</translation>
    </message>
</context>
<context>
    <name>dipwright::SurfaceQuery</name>
    <message>
        <source>The mesh is too large for this computer&apos;s memory; reduce its number of triangles</source>
        <translation>Das Netz ist zu groß für den Speicher dieses Rechners; verringern Sie die Zahl der Dreiecke</translation>
    </message>
</context>
<context>
    <name>dipwright::TankController</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The project has changed since these sheets were made.</source>
        <translation>Das Projekt hat sich geändert, seit diese Blätter gemacht wurden.</translation>
    </message>
    <message>
        <source>Keep times at the tank</source>
        <translation>Zeiten am Becken behalten</translation>
    </message>
    <message>
        <source>The times of %1 were not stored: the project is closed and has no file</source>
        <translation>Die Zeiten von %1 wurden nicht gespeichert: Das Projekt ist geschlossen und hat keine Datei</translation>
    </message>
    <message>
        <source>Storing the times</source>
        <translation>Zeiten werden gespeichert</translation>
    </message>
    <message>
        <source>The times of %1 were not stored</source>
        <translation>Die Zeiten von %1 wurden nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>dipwright::TankPage</name>
    <message>
        <source>Done (space bar)</source>
        <translation>Fertig (Leertaste)</translation>
    </message>
    <message>
        <source>Ends this step and stores its time; space bar</source>
        <translation>Beendet diesen Schritt und merkt sich seine Zeit; Leertaste</translation>
    </message>
    <message>
        <source>Back (←)</source>
        <translation>Zurück (←)</translation>
    </message>
    <message>
        <source>Returns to the step before and forgets its time; left arrow</source>
        <translation>Geht zum Schritt davor zurück und vergisst dessen Zeit; Pfeil nach links</translation>
    </message>
    <message>
        <source>Pause (P)</source>
        <translation>Pause (P)</translation>
    </message>
    <message>
        <source>Stops the clock until you continue; P</source>
        <translation>Hält die Uhr an, bis Sie weitermachen; P</translation>
    </message>
    <message>
        <source>Sound (S)</source>
        <translation>Ton (S)</translation>
    </message>
    <message>
        <source>Beeps in the last three seconds of a step; S</source>
        <translation>Gibt in den letzten drei Sekunden eines Schritts einen Ton; S</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>Closes the page. It continues at this step when it is opened again; Escape</source>
        <translation>Schließt die Seite. Sie macht bei diesem Schritt weiter, wenn sie wieder geöffnet wird; Esc</translation>
    </message>
    <message>
        <source>At the tank</source>
        <translation>Am Becken</translation>
    </message>
    <message>
        <source>Time of the step</source>
        <translation>Zeit des Schritts</translation>
    </message>
    <message>
        <source>job %1 of %2</source>
        <translation>Auftrag %1 von %2</translation>
    </message>
    <message>
        <source>dip %1</source>
        <translation>Tauchvorgang %1</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>Durchgang %1</translation>
    </message>
    <message>
        <source>All steps are done</source>
        <translation>Alle Schritte sind fertig</translation>
    </message>
    <message>
        <source>Paused: %1</source>
        <translation>Pause: %1</translation>
    </message>
    <message>
        <source>The times are stored with the job. The space bar starts the next run.</source>
        <translation>Die Zeiten sind beim Auftrag gespeichert. Die Leertaste beginnt den nächsten Durchgang.</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Danach: %1</translation>
    </message>
    <message>
        <source>Next run (space bar)</source>
        <translation>Nächster Durchgang (Leertaste)</translation>
    </message>
    <message>
        <source>Continue (P)</source>
        <translation>Weiter (P)</translation>
    </message>
</context>
<context>
    <name>dipwright::Texture</name>
    <message>
        <source>The picture has no pixels; choose another one</source>
        <translation>Das Bild hat keine Bildpunkte; wählen Sie ein anderes</translation>
    </message>
    <message>
        <source>The file is not a picture that can be read; save it as PNG or JPEG</source>
        <translation>Die Datei ist kein lesbares Bild; speichern Sie sie als PNG oder JPEG</translation>
    </message>
    <message>
        <source>%1, with %2 × %3 pixels</source>
        <translation>%1, mit %2 × %3 Pixeln</translation>
    </message>
    <message>
        <source>The photo is incomplete; copy it from the camera again</source>
        <translation>Das Foto ist unvollständig; kopieren Sie es noch einmal von der Kamera</translation>
    </message>
    <message>
        <source>HEIF pictures cannot be read on this computer; save the picture as JPEG, or set the camera to JPEG</source>
        <translation>HEIF-Bilder können auf diesem Rechner nicht gelesen werden; speichern Sie das Bild als JPEG, oder stellen Sie die Kamera auf JPEG</translation>
    </message>
    <message>
        <source>The picture is damaged: its ICC profile is incomplete; save it again</source>
        <translation>Das Bild ist beschädigt: Sein ICC-Profil ist unvollständig; speichern Sie es neu</translation>
    </message>
    <message>
        <source>The picture&apos;s ICC profile is damaged or does not match its pixels; save the picture again as sRGB</source>
        <translation>Das ICC-Profil des Bildes ist beschädigt oder passt nicht zu seinen Pixeln; speichern Sie das Bild neu als sRGB</translation>
    </message>
    <message>
        <source>The picture&apos;s ICC profile is larger than %1 MB; save the picture again as sRGB</source>
        <translation>Das ICC-Profil des Bildes ist größer als %1 MB; speichern Sie das Bild neu als sRGB</translation>
    </message>
    <message>
        <source>The picture file is incomplete; save it again, or copy it again from its source</source>
        <translation>Die Bilddatei ist unvollständig; speichern Sie sie neu, oder kopieren Sie sie noch einmal von ihrer Quelle</translation>
    </message>
    <message>
        <source>The CMYK picture is damaged or stored in an unsupported way; save it again as JPEG, or as TIFF without tiles or planes</source>
        <translation>Das CMYK-Bild ist beschädigt oder auf eine nicht unterstützte Art gespeichert; speichern Sie es neu als JPEG, oder als TIFF ohne Kacheln und Ebenen</translation>
    </message>
    <message>
        <source>The picture is damaged: %1; save it again</source>
        <translation>Das Bild ist beschädigt: %1; speichern Sie es neu</translation>
    </message>
    <message>
        <source>The Lab picture is damaged or stored in an unsupported way; save it again as RGB, or as TIFF in 8 or 16 bits without tiles or planes</source>
        <translation>Das Lab-Bild ist beschädigt oder auf eine nicht unterstützte Art gespeichert; speichern Sie es neu als RGB, oder als TIFF in 8 oder 16 Bit ohne Kacheln und Ebenen</translation>
    </message>
    <message>
        <source>The TIFF file stores its pixels in a way that is not supported, such as in planes, as floating-point numbers or with extra channels; save the picture again as PNG, or as TIFF with 8 or 16 bits, without planes and extra channels</source>
        <translation>Die TIFF-Datei speichert ihre Pixel auf eine nicht unterstützte Art, etwa in Ebenen, als Gleitkommazahlen oder mit zusätzlichen Kanälen; speichern Sie das Bild neu als PNG, oder als TIFF mit 8 oder 16 Bit ohne Ebenen und zusätzliche Kanäle</translation>
    </message>
    <message>
        <source>The CMYK picture has 16 bits and no ICC profile; save it with its profile, with 8 bits, or as sRGB</source>
        <translation>Das CMYK-Bild hat 16 Bit und kein ICC-Profil; speichern Sie es mit seinem Profil, mit 8 Bit oder als sRGB</translation>
    </message>
</context>
<context>
    <name>dipwright::TexturedMesh</name>
    <message>
        <source>The model&apos;s texture</source>
        <translation>Die Textur des Modells</translation>
    </message>
    <message>
        <source>Texture %1 of the model</source>
        <translation>Textur %1 des Modells</translation>
    </message>
</context>
<context>
    <name>dipwright::TimeLeft</name>
    <message>
        <source>about %1 s left</source>
        <translation>noch etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>noch etwa %1 min</translation>
    </message>
    <message>
        <source>about %1 h %2 min left</source>
        <translation>noch etwa %1 h %2 min</translation>
    </message>
</context>
<context>
    <name>dipwright::Timeline</name>
    <message>
        <source>Before the dip</source>
        <translation>Vor dem Tauchvorgang</translation>
    </message>
    <message>
        <source>Play the dip</source>
        <translation>Den Tauchvorgang abspielen</translation>
    </message>
    <message>
        <source>End of the dip</source>
        <translation>Ende des Tauchvorgangs</translation>
    </message>
    <message>
        <source>Time of the dip</source>
        <translation>Zeit des Tauchvorgangs</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Depth of the part&apos;s lowest point below the waterline</source>
        <translation>Tiefe des tiefsten Punkts des Teils unter der Wasserlinie</translation>
    </message>
</context>
<context>
    <name>dipwright::ToleranceCheck</name>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>Computing the tolerances</source>
        <translation>Toleranzen werden berechnet</translation>
    </message>
</context>
<context>
    <name>dipwright::ToleranceDialog</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Tolerance of the sheet</source>
        <translation>Toleranz des Blatts</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Contribution</source>
        <translation>Beitrag</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Effect of each contributor</source>
        <translation>Wirkung jeder Abweichung</translation>
    </message>
    <message>
        <source>How much this contributor adds to the total displacement of the image</source>
        <translation>Wie viel diese Abweichung zur gesamten Verschiebung des Bilds beiträgt</translation>
    </message>
    <message>
        <source>The project has changed since these figures were computed.</source>
        <translation>Das Projekt hat sich geändert, seit diese Zahlen berechnet wurden.</translation>
    </message>
    <message>
        <source>How far this quantity may deviate, up or down</source>
        <translation>Wie weit diese Größe abweichen darf, nach oben oder unten</translation>
    </message>
    <message>
        <source>With this contributor alone, half of the painted area lands within this distance of its intended place</source>
        <translation>Mit dieser Abweichung allein liegt die Hälfte der bemalten Fläche innerhalb dieses Abstands von ihrem Sollort</translation>
    </message>
    <message>
        <source>With this contributor alone, 95 % of the painted area lands within this distance of its intended place</source>
        <translation>Mit dieser Abweichung allein liegen 95 % der bemalten Fläche innerhalb dieses Abstands von ihrem Sollort</translation>
    </message>
    <message>
        <source>With this contributor alone, the largest displacement on the part</source>
        <translation>Mit dieser Abweichung allein die größte Verschiebung auf dem Teil</translation>
    </message>
    <message>
        <source>With this contributor alone, the area at the edge of the paint that is no longer painted (−) or painted in addition (+)</source>
        <translation>Mit dieser Abweichung allein die Fläche am Rand der Bemalung, die nicht mehr (−) oder zusätzlich (+) bemalt wird</translation>
    </message>
    <message>
        <source>All contributors together: 95 % of the painted area is within %1 of its intended place, and half of the area within %2.</source>
        <translation>Alle Abweichungen zusammen: 95 % der bemalten Fläche liegen innerhalb von %1 um ihren Sollort, die Hälfte der Fläche innerhalb von %2.</translation>
    </message>
    <message>
        <source>Displacement of %1 at the place %2 on the model; largest contributor: %3</source>
        <translation>Verschiebung von %1 an der Stelle %2 auf dem Modell; größter Beitrag: %3</translation>
    </message>
</context>
<context>
    <name>dipwright::Tour</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
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
</context>
<context>
    <name>dipwright::VerdictPanel</name>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Numerical error of the sheet</source>
        <translation>Numerischer Fehler des Blatts</translation>
    </message>
    <message>
        <source>Run the dip to see the numerical error of the sheet.</source>
        <translation>Starten Sie den Tauchvorgang, um den numerischen Fehler des Blatts zu sehen.</translation>
    </message>
    <message>
        <source>This is a draft. The verdict follows with the result.</source>
        <translation>Dies ist ein Entwurf. Das Urteil folgt mit dem Ergebnis.</translation>
    </message>
    <message>
        <source>This is a draft. There is no verdict, because the run was cancelled. Run the dip to get one.</source>
        <translation>Dies ist ein Entwurf. Es gibt kein Urteil, weil die Berechnung abgebrochen wurde. Starten Sie den Tauchvorgang, um eines zu erhalten.</translation>
    </message>
    <message>
        <source>This is a draft. There is no verdict, because the run failed. See the log for the reason, then run the dip again.</source>
        <translation>Dies ist ein Entwurf. Es gibt kein Urteil, weil die Berechnung fehlgeschlagen ist. Der Grund steht im Protokoll; starten Sie danach den Tauchvorgang erneut.</translation>
    </message>
</context>
<context>
    <name>dipwright::ViewController</name>
    <message>
        <source>Reading the picture</source>
        <translation>Bild wird gelesen</translation>
    </message>
    <message>
        <source>Picture on the film</source>
        <translation>Bild auf dem Film</translation>
    </message>
</context>
<context>
    <name>dipwright::WatchPage</name>
    <message>
        <source>Date %1   Lot %2   Water %3 °C</source>
        <translation>Datum %1   Charge %2   Wasser %3 °C</translation>
    </message>
    <message>
        <source>Film watch: print this page on the film</source>
        <translation>Filmmessung: diese Seite auf den Film drucken</translation>
    </message>
    <message>
        <source>Film watch, card: print this page on stiff, waterproof cardboard</source>
        <translation>Filmmessung, Karte: diese Seite auf steifen, wasserfesten Karton drucken</translation>
    </message>
    <message>
        <source>Ink side: lay the film on the water with this side up, so that you can read this text from above.</source>
        <translation>Farbseite: den Film mit dieser Seite nach oben aufs Wasser legen, so dass dieser Text von oben lesbar ist.</translation>
    </message>
    <message>
        <source>For every photo, lay the card flat on the water beside the film, with this side up.</source>
        <translation>Für jedes Foto die Karte flach neben dem Film aufs Wasser legen, mit dieser Seite nach oben.</translation>
    </message>
    <message>
        <source>Both rulers must measure %1 mm. If they do not, enter their measured lengths when you evaluate the photos.</source>
        <translation>Beide Lineale müssen %1 mm messen. Wenn nicht, geben Sie die gemessenen Längen bei der Auswertung der Fotos an.</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm is too small for a chessboard with %3 corners; use larger paper</source>
        <translation>Papier von %1 × %2 mm ist zu klein für ein Schachbrett mit %3 Ecken; verwenden Sie größeres Papier</translation>
    </message>
</context>
<context>
    <name>dipwright::WedgePage</name>
    <message>
        <source>1. Zero the densitometer on unprinted film. Read every patch before the dip.</source>
        <translation>1. Densitometer auf unbedrucktem Film auf null stellen. Jedes Feld vor dem Tauchvorgang messen.</translation>
    </message>
    <message>
        <source>Date %1   Lot %2</source>
        <translation>Datum %1   Charge %2</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm is too small for the wedge; use larger paper</source>
        <translation>Papier von %1 × %2 mm ist zu klein für den Keil; verwenden Sie größeres Papier</translation>
    </message>
    <message>
        <source>Step wedge: print this page on the film like a sheet</source>
        <translation>Stufenkeil: diese Seite wie ein Blatt auf den Film drucken</translation>
    </message>
    <message>
        <source>density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>2. Stretch the floating film by a dip or by hand. Measure both rulers (%1 mm if not stretched).</source>
        <translation>2. Schwimmenden Film durch Tauchen oder von Hand dehnen. Beide Lineale messen (ungedehnt %1 mm).</translation>
    </message>
    <message>
        <source>3. Read every patch again. Repeat with 3 or 4 stretches, up to the largest stretch of the job.</source>
        <translation>3. Jedes Feld neu messen. Mit 3 oder 4 Dehnungen wiederholen, bis zur größten Dehnung des Auftrags.</translation>
    </message>
</context>
<context>
    <name>dipwright::WedgeTable</name>
    <message>
        <source>The table of a step wedge must begin with the line %1 and have at most %2 lines</source>
        <translation>Die Tabelle eines Stufenkeils muss mit der Zeile %1 beginnen und darf höchstens %2 Zeilen haben</translation>
    </message>
    <message>
        <source>Line %1 of the table must contain an ink (cyan, magenta, yellow, black, white or grey) and five numbers, separated by commas</source>
        <translation>Zeile %1 der Tabelle muss eine Tinte (cyan, magenta, yellow, black, white oder grey) und fünf Zahlen enthalten, durch Kommas getrennt</translation>
    </message>
</context>
<context>
    <name>dipwright::WeightFields</name>
    <message>
        <source>Quality in zone %1</source>
        <translation>Qualität in Zone %1</translation>
    </message>
    <message>
        <source>Weight of %1</source>
        <translation>Gewicht von %1</translation>
    </message>
    <message>
        <source>Limit of %1</source>
        <translation>Grenze von %1</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>How much more the quality counts in this zone of the part. Zones are marked under Tolerances.</source>
        <translation>Wie viel mehr die Qualität in dieser Zone des Teils zählt. Zonen werden unter „Toleranzen“ markiert.</translation>
    </message>
    <message>
        <source>How much this measure counts, compared with the others. 0: not at all.</source>
        <translation>Wie viel dieses Maß im Vergleich zu den anderen zählt. 0: gar nicht.</translation>
    </message>
    <message>
        <source>Of poses with the same verdict, those that miss this limit rank below those that keep it.</source>
        <translation>Von Lagen mit demselben Urteil kommen die, die diese Grenze verfehlen, nach denen, die sie einhalten.</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowActions</name>
    <message>
        <source>Open another window</source>
        <translation>Ein weiteres Fenster öffnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Ein Projekt öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Das Projekt speichern</translation>
    </message>
    <message>
        <source>Save the project as another file</source>
        <translation>Das Projekt als andere Datei speichern</translation>
    </message>
    <message>
        <source>Write sheets, stretch maps, proof, films and report to a folder</source>
        <translation>Blätter, Dehnungskarten, Vorschau, Filme und Bericht in einen Ordner schreiben</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>Pro&amp;files…</source>
        <translation>Pro&amp;file …</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close all windows</source>
        <translation>Alle Fenster schließen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>&amp;Schräg</translation>
    </message>
    <message>
        <source>Look from above at an angle</source>
        <translation>Schräg von oben sehen</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Von vorn sehen</translation>
    </message>
    <message>
        <source>Ri&amp;ght</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Von rechts sehen</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>Von oben sehen</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>Look from behind</source>
        <translation>Von hinten sehen</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>Von links sehen</translation>
    </message>
    <message>
        <source>&amp;Bottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>Von unten sehen</translation>
    </message>
    <message>
        <source>Show the water and the edges of the tank</source>
        <translation>Das Wasser und die Kanten des Beckens zeigen</translation>
    </message>
    <message>
        <source>At the end of the dip, hide the film that paints nothing</source>
        <translation>Am Ende des Tauchvorgangs den Film verbergen, der nichts bemalt</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Lines every 10 mm</source>
        <translation>&amp;Linien alle 10 mm</translation>
    </message>
    <message>
        <source>S&amp;tretch</source>
        <translation>&amp;Dehnung</translation>
    </message>
    <message>
        <source>&amp;About Dipwright</source>
        <translation>Ü&amp;ber Dipwright</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <translation>„%1“ &amp;rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <translation>„%1“ &amp;wiederholen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;Tolerances…</source>
        <translation>&amp;Toleranzen …</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>Schni&amp;tt</translation>
    </message>
    <message>
        <source>Snapsho&amp;ts…</source>
        <translation>Schn&amp;appschüsse …</translation>
    </message>
    <message>
        <source>Turn about &amp;X by 15°</source>
        <translation>Um &amp;X um 15° drehen</translation>
    </message>
    <message>
        <source>Turn about X by −15°</source>
        <translation>Um X um −15° drehen</translation>
    </message>
    <message>
        <source>Turn about &amp;Y by 15°</source>
        <translation>Um &amp;Y um 15° drehen</translation>
    </message>
    <message>
        <source>Turn about Y by −15°</source>
        <translation>Um Y um −15° drehen</translation>
    </message>
    <message>
        <source>Turn about &amp;Z by 15°</source>
        <translation>Um &amp;Z um 15° drehen</translation>
    </message>
    <message>
        <source>Turn about Z by −15°</source>
        <translation>Um Z um −15° drehen</translation>
    </message>
    <message>
        <source>&amp;Artwork</source>
        <translation>&amp;Gestaltung</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Neues Fens&amp;ter</translation>
    </message>
    <message>
        <source>&amp;New project…</source>
        <translation>&amp;Neues Projekt …</translation>
    </message>
    <message>
        <source>Create a project from a model</source>
        <translation>Ein Projekt aus einem Modell anlegen</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the settings under a name, compare them and restore them</source>
        <translation>Die Einstellungen unter einem Namen speichern, vergleichen und wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Export results…</source>
        <translation>&amp;Ergebnisse exportieren …</translation>
    </message>
    <message>
        <source>Export sheet as P&amp;DF…</source>
        <translation>Blatt als &amp;PDF exportieren …</translation>
    </message>
    <message>
        <source>Save the sheet of this dip as PDF at true size</source>
        <translation>Das Blatt dieses Tauchvorgangs in wahrer Größe als PDF speichern</translation>
    </message>
    <message>
        <source>Export film image as PN&amp;G…</source>
        <translation>Filmbild als PN&amp;G exportieren …</translation>
    </message>
    <message>
        <source>Save the film image of this dip as PNG</source>
        <translation>Das Filmbild dieses Tauchvorgangs als PNG speichern</translation>
    </message>
    <message>
        <source>Export crad&amp;les…</source>
        <translation>&amp;Halterungen exportieren …</translation>
    </message>
    <message>
        <source>Save a cradle that holds the part in each dip, as STL and 3MF for 3D printing</source>
        <translation>Für jeden Tauchvorgang eine Halterung des Teils als STL und 3MF für den 3D-Druck speichern</translation>
    </message>
    <message>
        <source>Print the sheets at true size</source>
        <translation>Die Blätter in wahrer Größe drucken</translation>
    </message>
    <message>
        <source>Print &amp;history…</source>
        <translation>Druck&amp;verlauf …</translation>
    </message>
    <message>
        <source>Show what was printed, when, on which printer and from which project</source>
        <translation>Zeigen, was wann auf welchem Drucker und aus welchem Projekt gedruckt wurde</translation>
    </message>
    <message>
        <source>&amp;Job queue…</source>
        <translation>&amp;Warteschlange …</translation>
    </message>
    <message>
        <source>Run several projects one after the other while you keep working</source>
        <translation>Mehrere Projekte nacheinander rechnen, während Sie weiterarbeiten</translation>
    </message>
    <message>
        <source>Several jobs on one &amp;film…</source>
        <translation>&amp;Mehrere Aufträge auf einem Film …</translation>
    </message>
    <message>
        <source>Place the sheets of several projects, and copies of them, side by side on a film or roll</source>
        <translation>Die Blätter mehrerer Projekte, und Exemplare davon, nebeneinander auf einen Film oder eine Rolle legen</translation>
    </message>
    <message>
        <source>Calibrate pr&amp;inter…</source>
        <translation>D&amp;rucker kalibrieren …</translation>
    </message>
    <message>
        <source>Print a page with rulers and store the printer&apos;s scale in its profile</source>
        <translation>Eine Seite mit Linealen drucken und den Maßstab des Druckers in seinem Profil speichern</translation>
    </message>
    <message>
        <source>Show and edit the profiles of printers, films and tanks</source>
        <translation>Die Profile von Druckern, Filmen und Becken zeigen und bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>Fenster s&amp;chließen</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Die letzte Änderung rückgängig machen</translation>
    </message>
    <message>
        <source>Redo the change that was undone</source>
        <translation>Die rückgängig gemachte Änderung wiederholen</translation>
    </message>
    <message>
        <source>Add &amp;second dip</source>
        <translation>&amp;Zweiten Tauchvorgang hinzufügen</translation>
    </message>
    <message>
        <source>Dip the part a second time, from another side</source>
        <translation>Das Teil ein zweites Mal tauchen, von einer anderen Seite</translation>
    </message>
    <message>
        <source>Remove &amp;dip</source>
        <translation>&amp;Tauchvorgang entfernen</translation>
    </message>
    <message>
        <source>Remove the dip that is shown</source>
        <translation>Den gezeigten Tauchvorgang entfernen</translation>
    </message>
    <message>
        <source>S&amp;wap dips</source>
        <translation>Tauchvorgänge ta&amp;uschen</translation>
    </message>
    <message>
        <source>Re&amp;load model</source>
        <translation>Modell neu &amp;laden</translation>
    </message>
    <message>
        <source>Read the model file again and keep all settings</source>
        <translation>Die Modelldatei neu lesen und alle Einstellungen behalten</translation>
    </message>
    <message>
        <source>Replace &amp;model…</source>
        <translation>&amp;Modell ersetzen …</translation>
    </message>
    <message>
        <source>Use another model</source>
        <translation>Ein anderes Modell verwenden</translation>
    </message>
    <message>
        <source>Replace &amp;texture…</source>
        <translation>Te&amp;xtur ersetzen …</translation>
    </message>
    <message>
        <source>Use another image as the texture</source>
        <translation>Ein anderes Bild als Textur verwenden</translation>
    </message>
    <message>
        <source>Place pictures, text and patterns on the part</source>
        <translation>Bilder, Text und Muster auf das Teil legen</translation>
    </message>
    <message>
        <source>Set units, language, theme, shortcuts and solvers</source>
        <translation>Einheiten, Sprache, Aussehen, Tastenkürzel und Solver einstellen</translation>
    </message>
    <message>
        <source>Simulate the dip and compute the sheets</source>
        <translation>Den Tauchvorgang simulieren und die Blätter berechnen</translation>
    </message>
    <message>
        <source>Cancel everything that is running</source>
        <translation>Alles abbrechen, was gerade läuft</translation>
    </message>
    <message>
        <source>Run &amp;live</source>
        <translation>Laufend &amp;neu rechnen</translation>
    </message>
    <message>
        <source>&amp;Find poses…</source>
        <translation>&amp;Lagen suchen …</translation>
    </message>
    <message>
        <source>Search for the best rotation and position of the part, for one dip or two</source>
        <translation>Die beste Drehung und Position des Teils suchen, für einen Tauchvorgang oder zwei</translation>
    </message>
    <message>
        <source>Check numerical &amp;error…</source>
        <translation>Numerischen &amp;Fehler prüfen …</translation>
    </message>
    <message>
        <source>Compute how far handling may move the image, and which zones keep their limits</source>
        <translation>Berechnen, wie weit die Handhabung das Bild verschieben kann und welche Zonen ihre Grenzen einhalten</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>Abs&amp;pielen oder anhalten</translation>
    </message>
    <message>
        <source>Show all of the part and the film</source>
        <translation>Das ganze Teil und den ganzen Film zeigen</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Put all panels back into their original places</source>
        <translation>Alle Bereiche an ihren ursprünglichen Platz zurückstellen</translation>
    </message>
    <message>
        <source>&amp;Save layout…</source>
        <translation>Anordnung &amp;speichern …</translation>
    </message>
    <message>
        <source>Save the arrangement of the panels under a name</source>
        <translation>Die Anordnung der Bereiche unter einem Namen speichern</translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation>&amp;Parallelprojektion</translation>
    </message>
    <message>
        <source>Rings an&amp;d arrows</source>
        <translation>Rin&amp;ge und Pfeile</translation>
    </message>
    <message>
        <source>Show the rings that turn the part and the arrows that move it</source>
        <translation>Die Ringe zeigen, die das Teil drehen, und die Pfeile, die es verschieben</translation>
    </message>
    <message>
        <source>&amp;Water and tank</source>
        <translation>&amp;Wasser und Becken</translation>
    </message>
    <message>
        <source>P&amp;art</source>
        <translation>Te&amp;il</translation>
    </message>
    <message>
        <source>Show the part</source>
        <translation>Das Teil zeigen</translation>
    </message>
    <message>
        <source>Co&amp;verage on the part</source>
        <translation>Abde&amp;ckung auf dem Teil</translation>
    </message>
    <message>
        <source>Show the painted area of the part</source>
        <translation>Die bemalte Fläche des Teils zeigen</translation>
    </message>
    <message>
        <source>F&amp;inished part</source>
        <translation>&amp;Fertiges Teil</translation>
    </message>
    <message>
        <source>Show the part as it comes out of all dips, from every side</source>
        <translation>Das Teil zeigen, wie es aus allen Tauchvorgängen kommt, von allen Seiten</translation>
    </message>
    <message>
        <source>&amp;Zones on the part</source>
        <translation>&amp;Zonen auf dem Teil</translation>
    </message>
    <message>
        <source>Film on the part o&amp;nly</source>
        <translation>&amp;Nur Film auf dem Teil</translation>
    </message>
    <message>
        <source>S&amp;ee-through film</source>
        <translation>&amp;Durchsichtiger Film</translation>
    </message>
    <message>
        <source>Show the part through the film</source>
        <translation>Das Teil durch den Film hindurch zeigen</translation>
    </message>
    <message>
        <source>What the film shows in the 3D view</source>
        <translation>Was der Film in der 3D-Ansicht zeigt</translation>
    </message>
    <message>
        <source>Film &amp;image</source>
        <translation>Film&amp;bild</translation>
    </message>
    <message>
        <source>&amp;Shares of the dips</source>
        <translation>&amp;Anteile der Tauchvorgänge</translation>
    </message>
    <message>
        <source>&amp;Chessboard, 17 mm squares</source>
        <translation>&amp;Schachbrett, Felder von 17 mm</translation>
    </message>
    <message>
        <source>&amp;Picture from file…</source>
        <translation>B&amp;ild aus Datei …</translation>
    </message>
    <message>
        <source>Turn the part by 15°</source>
        <translation>Das Teil um 15° drehen</translation>
    </message>
    <message>
        <source>Move the part over the film</source>
        <translation>Das Teil über dem Film verschieben</translation>
    </message>
    <message>
        <source>Move &amp;right by 5 mm</source>
        <translation>5 mm nach &amp;rechts schieben</translation>
    </message>
    <message>
        <source>Move &amp;left by 5 mm</source>
        <translation>5 mm nach &amp;links schieben</translation>
    </message>
    <message>
        <source>Move &amp;up the sheet by 5 mm</source>
        <translation>5 mm das Blatt hin&amp;auf schieben</translation>
    </message>
    <message>
        <source>Move &amp;down the sheet by 5 mm</source>
        <translation>5 mm das Blatt hin&amp;unter schieben</translation>
    </message>
    <message>
        <source>Move to the &amp;middle of the film</source>
        <translation>In die &amp;Mitte des Films schieben</translation>
    </message>
    <message>
        <source>Quick &amp;tour</source>
        <translation>&amp;Rundgang</translation>
    </message>
    <message>
        <source>User &amp;guide</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>&amp;What is this?</source>
        <translation>&amp;Was ist das?</translation>
    </message>
    <message>
        <source>Click an element of the window to see what it does</source>
        <translation>Klicken Sie ein Element des Fensters an, um zu sehen, was es tut</translation>
    </message>
    <message>
        <source>Film on the part before the d&amp;ip</source>
        <translation>Film auf dem Teil &amp;vor dem Tauchvorgang</translation>
    </message>
    <message>
        <source>Draw near and far places at the same scale, without perspective</source>
        <translation>Nahe und ferne Stellen im gleichen Maßstab zeichnen, ohne Perspektive</translation>
    </message>
    <message>
        <source>Exchange the order of the two dips</source>
        <translation>Die Reihenfolge der beiden Tauchvorgänge vertauschen</translation>
    </message>
    <message>
        <source>As soon as there is a first result, run again after each change</source>
        <translation>Sobald es ein erstes Ergebnis gibt, nach jeder Änderung neu rechnen</translation>
    </message>
    <message>
        <source>Compute the sheets with finer steps and cells, and show where and how far the image changes</source>
        <translation>Die Blätter mit feineren Schritten und Zellen berechnen und zeigen, wo und wie weit sich das Bild ändert</translation>
    </message>
    <message>
        <source>Play the dip, or pause it</source>
        <translation>Den Tauchvorgang abspielen oder anhalten</translation>
    </message>
    <message>
        <source>While you place the part, show it with the film of the last results; if this is off, show the flat film</source>
        <translation>Beim Platzieren das Teil mit dem Film der letzten Ergebnisse zeigen; ist dies aus, den flachen Film zeigen</translation>
    </message>
    <message>
        <source>Cut the part and the film open along a plane; move the plane with its slider or its frame</source>
        <translation>Teil und Film an einer Ebene aufschneiden; der Regler oder der Rahmen verschiebt die Ebene</translation>
    </message>
    <message>
        <source>Explain the areas of the window in six steps</source>
        <translation>Die Bereiche des Fensters in sechs Schritten erklären</translation>
    </message>
    <message>
        <source>Open the user guide at the section about the selected field</source>
        <translation>Das Handbuch an der Stelle zum gewählten Feld öffnen</translation>
    </message>
    <message>
        <source>Show the zones of the part. After Dip ▸ Tolerances, also show where the zones stay within their limits</source>
        <translation>Die Zonen des Teils zeigen. Nach Tauchen ▸ Toleranzen auch zeigen, wo die Zonen innerhalb ihrer Grenzen bleiben</translation>
    </message>
    <message>
        <source>&amp;Zoom to part</source>
        <translation>Auf das Teil &amp;zoomen</translation>
    </message>
    <message>
        <source>Show the part as large as possible, without the film around it</source>
        <translation>Das Teil so groß wie möglich zeigen, ohne den Film darum herum</translation>
    </message>
    <message>
        <source>Make &amp;outputs…</source>
        <translation>Aus&amp;gaben erzeugen…</translation>
    </message>
    <message>
        <source>Write a list of files that is kept with the project, such as everything that the print shop needs</source>
        <translation>Eine Liste von Dateien schreiben, die im Projekt bleibt, zum Beispiel alles, was die Druckerei braucht</translation>
    </message>
    <message>
        <source>At the tan&amp;k…</source>
        <translation>Am Bec&amp;ken …</translation>
    </message>
    <message>
        <source>Show the steps at the tank in large letters, count their times down and store how long they took</source>
        <translation>Die Schritte am Becken in großen Buchstaben zeigen, ihre Zeiten herunterzählen und speichern, wie lange sie gedauert haben</translation>
    </message>
    <message>
        <source>Warnings on t&amp;he part</source>
        <translation>Warn&amp;ungen auf dem Teil</translation>
    </message>
    <message>
        <source>Mark trapped air, torn film and places that are not reached. Click a mark to see it in the report</source>
        <translation>Eingeschlossene Luft, gerissenen Film und nicht erreichte Stellen markieren. Ein Klick auf eine Marke zeigt sie im Bericht</translation>
    </message>
    <message>
        <source>Cradle aro&amp;und the part</source>
        <translation>&amp;Halterung um das Teil</translation>
    </message>
    <message>
        <source>Make the cradle of this dip and show it, before you export it</source>
        <translation>Die Halterung dieses Tauchvorgangs herstellen und zeigen, bevor sie exportiert wird</translation>
    </message>
    <message>
        <source>Click two places on the part to measure the straight distance between them, and the distance along the surface</source>
        <translation>Zwei Stellen auf dem Teil anklicken, um ihren geraden Abstand und den Abstand entlang der Oberfläche zu messen</translation>
    </message>
    <message>
        <source>Plates…</source>
        <translation>Platten…</translation>
    </message>
    <message>
        <source>Show the plates of the sheets, the ink under the cursor, and where there is too much ink</source>
        <translation>Zeigt die Platten der Blätter, die Tinte unter dem Mauszeiger und wo zu viel Tinte liegt</translation>
    </message>
    <message>
        <source>Send to ser&amp;ver…</source>
        <translation>An Ser&amp;ver senden…</translation>
    </message>
    <message>
        <source>Simulate the dips on another computer, such as one with a GPU, and show the results here</source>
        <translation>Die Tauchvorgänge auf einem anderen Rechner simulieren, etwa einem mit GPU, und die Ergebnisse hier zeigen</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowLayout</name>
    <message>
        <source>3D view of the dip</source>
        <translation>3D-Ansicht des Tauchvorgangs</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Name of the layout</source>
        <translation>Name der Anordnung</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>The part above the film. Drag to turn the view, drag with the right button to move it, use the wheel to zoom. Drag a ring to turn the part.</source>
        <translation>Das Teil über dem Film. Ziehen dreht die Ansicht, Ziehen mit der rechten Taste verschiebt sie, das Rad zoomt. Ein Zug am Ring dreht das Teil.</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>Anordnung speichern</translation>
    </message>
    <message>
        <source>No saved layouts</source>
        <translation>Keine gespeicherten Anordnungen</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowMenus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Dip</source>
        <translation>&amp;Tauchen</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Layouts</source>
        <translation>Anord&amp;nungen</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Hauptleiste</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Film appearance</source>
        <translation>Aussehen des Films</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Tur&amp;n part</source>
        <translation>Teil &amp;drehen</translation>
    </message>
    <message>
        <source>Mo&amp;ve part</source>
        <translation>Teil &amp;verschieben</translation>
    </message>
    <message>
        <source>Film appearan&amp;ce</source>
        <translation>&amp;Aussehen des Films</translation>
    </message>
    <message>
        <source>What the film shows in the 3D view</source>
        <translation>Was der Film in der 3D-Ansicht zeigt</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowMessages</name>
    <message>
        <source>Read files</source>
        <translation>Dateien lesen</translation>
    </message>
    <message>
        <source>Read these files only if they belong to the model or project. A model or project from someone else may refer to your private files. These files would then be saved in the project.</source>
        <translation>Lesen Sie diese Dateien nur, wenn sie zum Modell oder Projekt gehören. Ein fremdes Modell oder Projekt kann auf Ihre privaten Dateien verweisen. Diese würden dann im Projekt gespeichert.</translation>
    </message>
</context>
<context>
    <name>dipwright::Workbench</name>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Restore project</source>
        <translation>Projekt wiederherstellen</translation>
    </message>
    <message>
        <source>Dipwright was not closed properly. “%1” has unsaved changes from %2.</source>
        <translation>Dipwright wurde nicht ordentlich beendet. „%1“ hat nicht gespeicherte Änderungen von %2.</translation>
    </message>
    <message>
        <source>The project was never saved to a file.</source>
        <translation>Das Projekt wurde nie in einer Datei gespeichert.</translation>
    </message>
    <message>
        <source>The file %1 still holds the last saved version.</source>
        <translation>Die Datei %1 enthält noch die zuletzt gespeicherte Fassung.</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>Später entscheiden</translation>
    </message>
</context>
<context>
    <name>dipwright::ZoneFields</name>
    <message>
        <source>Marks zone %1</source>
        <translation>Markiert Zone %1</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>Whole face</source>
        <translation>Ganze Fläche</translation>
    </message>
    <message>
        <source>The zone that a click or drag on the part sets. Zone A must be painted most precisely. The surface without a mark is zone C.</source>
        <translation>Die Zone, die ein Klick oder Ziehen auf dem Teil setzt. Zone A muss am genauesten bemalt werden. Die Fläche ohne Marke ist Zone C.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>What a click marks: the surface under the brush, the face up to its edges, or everything with the same material in the model.</source>
        <translation>Was ein Klick markiert: die Oberfläche unter dem Pinsel, die Fläche bis zu ihren Kanten oder alles, was im Modell dasselbe Material hat.</translation>
    </message>
    <message>
        <source>Whole material or CAD face</source>
        <translation>Ganzes Material oder CAD-Fläche</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Computational hydrographic printing.</source>
        <translation>Berechneter Wassertransferdruck.</translation>
    </message>
    <message>
        <source>Projects to open.</source>
        <translation>Projekte, die geöffnet werden.</translation>
    </message>
</context>
</TS>
