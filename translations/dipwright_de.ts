<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Archive</name>
    <message>
        <source>There is no such file</source>
        <translation>Diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>The file is empty</source>
        <translation>Die Datei ist leer</translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>Die Datei kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>This is not a Dipwright project, or the file is cut off or damaged</source>
        <translation>Das ist kein Dipwright-Projekt, oder die Datei ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>The file is cut off or damaged</source>
        <translation>Die Datei ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>The file holds an entry with an unsafe path and is not opened</source>
        <translation>Die Datei enthält einen Eintrag mit unsicherem Pfad und wird nicht geöffnet</translation>
    </message>
    <message>
        <source>The file holds the entry %1 twice</source>
        <translation>Die Datei enthält den Eintrag %1 doppelt</translation>
    </message>
    <message>
        <source>The file is encrypted, save it without a password</source>
        <translation>Die Datei ist verschlüsselt; speichern Sie sie ohne Kennwort</translation>
    </message>
    <message>
        <source>The project lacks %1</source>
        <translation>Dem Projekt fehlt %1</translation>
    </message>
    <message>
        <source>%1 in the project is cut off or damaged</source>
        <translation>%1 im Projekt ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>The file cannot be packed</source>
        <translation>Die Datei lässt sich nicht packen</translation>
    </message>
</context>
<context>
    <name>AtomicFile</name>
    <message>
        <source>it is a folder</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>it may not be written</source>
        <translation>sie darf nicht geschrieben werden</translation>
    </message>
    <message>
        <source>another program is writing it at this moment, try again</source>
        <translation>ein anderes Programm schreibt sie in diesem Augenblick, versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>it does not reach the disk: %1</source>
        <translation>sie kommt nicht auf die Platte: %1</translation>
    </message>
    <message>
        <source>The file cannot be written: %1</source>
        <translation>Die Datei kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>its links lead to one another</source>
        <translation>seine Verknüpfungen führen zueinander</translation>
    </message>
    <message>
        <source>it is no plain file</source>
        <translation>es ist keine gewöhnliche Datei</translation>
    </message>
</context>
<context>
    <name>BodyAppearance</name>
    <message>
        <source>Painted</source>
        <translation>Gefärbt</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Nicht gefärbt</translation>
    </message>
    <message>
        <source>Painted, by the shape</source>
        <translation>Gefärbt, der Form nach</translation>
    </message>
</context>
<context>
    <name>Certainty</name>
    <message>
        <source>the film has too few points to be compared with one of half as many</source>
        <translation>der Film hat zu wenige Punkte, um ihn mit einem von halb so vielen zu vergleichen</translation>
    </message>
    <message>
        <source>a coarser film does not follow the body at all</source>
        <translation>ein gröberer Film folgt dem Körper überhaupt nicht</translation>
    </message>
    <message>
        <source>Overhang (°)</source>
        <translation>Überhang (°)</translation>
    </message>
    <message>
        <source>Fading grip (°)</source>
        <translation>Nachlassender Halt (°)</translation>
    </message>
    <message>
        <source>Tearing (times the length or area)</source>
        <translation>Reißen (das Wievielfache von Länge oder Fläche)</translation>
    </message>
    <message>
        <source>Gathering (mean stretch)</source>
        <translation>Raffen (mittlere Dehnung)</translation>
    </message>
    <message>
        <source>%1, %2 to %3 in place of %4: the sheet moves by up to %5 (95 % of it), %6 % of what is painted by more than %7, and %8 % is not painted any more.</source>
        <translation>%1, %2 bis %3 statt %4: Der Bogen verschiebt sich um bis zu %5 (95 % von ihm), %6 % der bemalten Fläche um mehr als %7, und %8 % werden nicht mehr bemalt.</translation>
    </message>
</context>
<context>
    <name>VerdictPanel</name>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Places of %1:</source>
        <translation>Stellen von %1:</translation>
    </message>
</context>
<context>
    <name>CheckedSolver</name>
    <message>
        <source>it threw an unknown exception</source>
        <translation>er hat eine unbekannte Ausnahme geworfen</translation>
    </message>
    <message>
        <source>it gave points a state that there is none of</source>
        <translation>er hat Punkten einen Zustand gegeben, den es nicht gibt</translation>
    </message>
    <message>
        <source>it gave points a mark that there is none of</source>
        <translation>er hat Punkten eine Marke gegeben, die es nicht gibt</translation>
    </message>
    <message>
        <source>it gave no film</source>
        <translation>er hat keinen Film gegeben</translation>
    </message>
    <message>
        <source>it stopped by itself</source>
        <translation>er hat von selbst aufgehört</translation>
    </message>
    <message>
        <source>it left films of a batch empty</source>
        <translation>er hat Filme eines Stapels leer gelassen</translation>
    </message>
    <message>
        <source>it told steps or a descent that cannot be</source>
        <translation>er hat Schritte oder einen Weg gemeldet, die nicht sein können</translation>
    </message>
    <message>
        <source>it does not come forward</source>
        <translation>er kommt nicht voran</translation>
    </message>
    <message>
        <source>it told figures of its equilibrium that cannot be</source>
        <translation>er hat Werte seines Gleichgewichts gemeldet, die nicht sein können</translation>
    </message>
</context>
<context>
    <name>ColourNote</name>
    <message>
        <source>%1 is in CMYK and names no ICC profile: its colours are guessed by a formula and can be far off; save it with its profile, or as sRGB</source>
        <translation>%1 ist in CMYK und nennt kein ICC-Profil: Die Farben sind nach einer Formel geschätzt und können weit danebenliegen; speichern Sie das Bild mit seinem Profil oder als sRGB</translation>
    </message>
    <message>
        <source>%1 has colours that are not kept as they are: %2 % of its pixels lie beyond BT.2020, in which pictures are kept, and are printed less saturated; save it in a smaller space, such as Adobe RGB, to choose how</source>
        <translation>%1 hat Farben, die nicht bleiben, wie sie sind: %2 % der Pixel liegen außerhalb von BT.2020, worin Bilder gehalten werden, und werden weniger gesättigt gedruckt; speichern Sie das Bild in einem kleineren Farbraum wie Adobe RGB, um das selbst zu bestimmen</translation>
    </message>
</context>
<context>
    <name>Cradle</name>
    <message>
        <source>%1: the body tips out of its cradle where it is not fixed; what stays dry does not lie on all sides of its middle. Fix it through the bore, or turn the pose</source>
        <translation>%1: Der Körper kippt aus seiner Halterung, wo er nicht befestigt ist; was trocken bleibt, liegt nicht auf allen Seiten seiner Mitte. Befestigen Sie ihn durch die Bohrung, oder drehen Sie die Lage</translation>
    </message>
    <message>
        <source>%1: nothing keeps the body from sliding sideways in its cradle, for what stays dry is flat; mark its place and fix it there</source>
        <translation>%1: Nichts hält den Körper davon ab, in seiner Halterung seitlich zu rutschen, denn was trocken bleibt, ist flach; zeichnen Sie seinen Platz an und befestigen Sie ihn dort</translation>
    </message>
    <message>
        <source>%1: the cradle lies on %2 mm² of paint of an earlier dip; line it there with %3 mm of soft felt or foam</source>
        <translation>%1: Die Halterung liegt auf %2 mm² Farbe eines früheren Tauchvorgangs; legen Sie sie dort mit %3 mm weichem Filz oder Schaum aus</translation>
    </message>
    <message>
        <source>%1: the cradle&apos;s plate has no room for arrow and job; write them on it</source>
        <translation>%1: Die Platte der Halterung hat keinen Platz für Pfeil und Auftrag; schreiben Sie sie darauf</translation>
    </message>
    <message>
        <source>%1: there is no cradle, for all that could hold the body is painted by an earlier dip; allow it with cradle.on_paint, through padding, or turn the pose</source>
        <translation>%1: Es gibt keine Halterung, denn alles, was den Körper halten könnte, hat ein früherer Tauchvorgang bemalt; erlauben Sie es mit cradle.on_paint, durch ein Polster, oder drehen Sie die Lage</translation>
    </message>
    <message>
        <source>%1: there is no cradle, for the film reaches all that could hold the body; dip it less deep or turn the pose</source>
        <translation>%1: Es gibt keine Halterung, denn der Film erreicht alles, was den Körper halten könnte; tauchen Sie ihn weniger tief oder drehen Sie die Lage</translation>
    </message>
    <message>
        <source>Forming the cradle</source>
        <translation>Halterung wird geformt</translation>
    </message>
    <message>
        <source>Checking the cradle</source>
        <translation>Halterung wird geprüft</translation>
    </message>
    <message>
        <source>Looking for what stays dry</source>
        <translation>Gesucht wird, was trocken bleibt</translation>
    </message>
</context>
<context>
    <name>Dip</name>
    <message>
        <source>Dipping</source>
        <translation>Tauchen</translation>
    </message>
    <message>
        <source>The simulation became unstable; choose a smaller time step or contact travel</source>
        <translation>Die Simulation wurde instabil; wählen Sie einen kleineren Zeitschritt oder Kontaktweg</translation>
    </message>
    <message>
        <source>The solver failed: %1</source>
        <translation>Der Löser ist gescheitert: %1</translation>
    </message>
    <message>
        <source>The solver failed with an unknown exception</source>
        <translation>Der Löser ist mit einer unbekannten Ausnahme gescheitert</translation>
    </message>
    <message>
        <source>With these cells the film would have %1 million points, and it may have %2; give it larger cells</source>
        <translation>Mit diesen Zellen hätte die Folie %1 Millionen Punkte, und sie darf %2 haben; geben Sie ihr größere Zellen</translation>
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
        <source>%1, %2 % of what is painted, depend on marked film. %3.</source>
        <translation>%1, %2 % der bemalten Fläche, hängen von markiertem Film ab. %3.</translation>
    </message>
    <message>
        <source>The body does not meet the film; move it over the film, choose a larger film, or give the film smaller cells or more points</source>
        <translation>Der Körper trifft den Film nicht; schieben Sie ihn über den Film, wählen Sie einen größeren Film oder geben Sie dem Film kleinere Zellen oder mehr Punkte</translation>
    </message>
    <message>
        <source>The body is not found: parts of it are only %1 mm thick, and the distance field has cells of %2 mm; make them thicker, or dip a smaller part of it</source>
        <translation>Der Körper wird nicht gefunden: Teile von ihm sind nur %1 mm dick, und das Abstandsfeld hat Zellen von %2 mm; machen Sie sie dicker oder tauchen Sie einen kleineren Teil von ihm</translation>
    </message>
    <message>
        <source>choose a film of at least %1 × %2 mm</source>
        <translation>wählen Sie einen Film von mindestens %1 × %2 mm</translation>
    </message>
    <message>
        <source>no film is larger than %1 mm: check the model&apos;s size and unit</source>
        <translation>kein Film ist größer als %1 mm: Prüfen Sie Größe und Einheit des Modells</translation>
    </message>
    <message>
        <source>The body is larger than the film on all sides, %1 × %2 mm on the water, and no film is left to go round it; %3</source>
        <translation>Der Körper ist auf allen Seiten größer als der Film, %1 × %2 mm auf dem Wasser, und es bleibt kein Film, der sich um ihn legt; %3</translation>
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
        <translation>Losgelassener Film</translation>
    </message>
</context>
<context>
    <name>DipCache</name>
    <message>
        <source>The dips cannot be kept: %1</source>
        <translation>Die Tauchvorgänge können nicht aufbewahrt werden: %1</translation>
    </message>
    <message>
        <source>Reading the kept dips</source>
        <translation>Aufbewahrte Tauchvorgänge werden gelesen</translation>
    </message>
    <message>
        <source>The kept dips are damaged and not used; a run makes them again</source>
        <translation>Die aufbewahrten Tauchvorgänge sind beschädigt und werden nicht verwendet; ein Lauf macht sie neu</translation>
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
</context>
<context>
    <name>DipPlayback</name>
    <message>
        <source>%1 (%2 deep)</source>
        <translation>%1 (%2 tief)</translation>
    </message>
    <message>
        <source>First contact</source>
        <translation>Erste Berührung</translation>
    </message>
    <message>
        <source>Film tears</source>
        <translation>Film reißt</translation>
    </message>
    <message>
        <source>Air is trapped under the body</source>
        <translation>Luft wird unter dem Körper eingeschlossen</translation>
    </message>
    <message>
        <source>Film is released at an overhang</source>
        <translation>Film löst sich an einem Überhang</translation>
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
        <source>%1, about %2 s</source>
        <translation>%1, etwa %2 s</translation>
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
        <source>Whether this side of the film floats freely or is held by a barrier in the tank.</source>
        <translation>Ob diese Seite des Films frei schwimmt oder von einer Barriere im Becken gehalten wird.</translation>
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
        <source>How much the wetted film has grown over the printed one, across and down. Measure it: it is the first number to calibrate, and the sheet is printed smaller by it.</source>
        <translation>Wie viel der benetzte Film gegenüber dem gedruckten gewachsen ist, quer und längs. Messen Sie es: Es ist die erste Zahl, die zu kalibrieren ist, und der Bogen wird um sie kleiner gedruckt.</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxation</translation>
    </message>
    <message>
        <source>How fast stress in the floating film decays. An elastic film remembers its shape for ever; a viscous one, at 0 s, forgets at once.</source>
        <translation>Wie schnell Spannung im schwimmenden Film abklingt. Ein elastischer Film behält seine Form für immer in Erinnerung, ein viskoser, bei 0 s, vergisst sie sofort.</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>Elastisch</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wachstum</translation>
    </message>
    <message>
        <source>How fast the film goes on growing while it floats, in a second of the dip and at its begin. What is on the body grows no more.</source>
        <translation>Wie schnell die Folie weiterwächst, während sie schwimmt, in einer Sekunde und zu Beginn des Tauchvorgangs. Was am Körper liegt, wächst nicht mehr.</translation>
    </message>
    <message>
        <source>Grows by at most</source>
        <translation>Wächst höchstens um</translation>
    </message>
    <message>
        <source>Contact distance</source>
        <translation>Kontaktabstand</translation>
    </message>
    <message>
        <source>How near a film point has to come to the surface to touch it.</source>
        <translation>Wie nahe ein Filmpunkt der Oberfläche kommen muss, um sie zu berühren.</translation>
    </message>
    <message>
        <source>Grip fades over</source>
        <translation>Halt schwindet über</translation>
    </message>
    <message>
        <source>So far before the overhang the body begins to lose its grip on the film. A guess: no film was measured.</source>
        <translation>So weit vor dem Überhang beginnt der Körper, die Folie loszulassen. Eine Annahme: Keine Folie wurde gemessen.</translation>
    </message>
    <message>
        <source>Gathers below</source>
        <translation>Rafft sich unter</translation>
    </message>
    <message>
        <source>Film pushed together to a mean stretch below this gathers, and hardly resists any more. A guess: no film was measured.</source>
        <translation>Folie, die unter diese mittlere Dehnung zusammengeschoben wird, rafft sich und leistet kaum noch Widerstand. Eine Annahme: Keine Folie wurde gemessen.</translation>
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
        <source>Ink thins by</source>
        <translation>Tinte wird dünner mit</translation>
    </message>
    <message>
        <source>The exponent n: ink printed with density D shows D·J^−n where film is stretched to J times its area. 1 for dye, 0 for dots that hide what is behind them. A guess, taken for inks without tones.</source>
        <translation>Der Exponent n: mit der Dichte D gedruckte Tinte zeigt D·J^−n, wo der Film auf das J-fache seiner Fläche gedehnt ist. 1 für Farbstoff, 0 für Punkte, die alles hinter sich verdecken. Eine Schätzung, für Tinten ohne gemessene Töne.</translation>
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
        <source>Black and white</source>
        <translation>Schwarz und Weiß</translation>
    </message>
    <message>
        <source>The same of black and white ink, which printers in CMYK have: there each ink is made up for by itself, after separation.</source>
        <translation>Dasselbe für schwarze und weiße Tinte, die Drucker in CMYK haben: Dort wird jede Tinte für sich ausgeglichen, nach der Separation.</translation>
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
        <source>Ink, measured</source>
        <translation>Tinte, gemessen</translation>
    </message>
    <message>
        <source>What a step wedge told, tone by tone: ink, density, exponent, bend, greatest stretch (dipwright-cli profile wedge).</source>
        <translation>Was ein Stufenkeil ergab, Ton für Ton: Tinte, Dichte, Exponent, Krümmung, größte Dehnung (dipwright-cli profile wedge).</translation>
    </message>
    <message>
        <source>As in the project</source>
        <translation>Wie im Projekt</translation>
    </message>
    <message>
        <source>Tears at</source>
        <translation>Reißt bei</translation>
    </message>
    <message>
        <source>How many times its length or its area film can be stretched before it tears. Torn film is marked and not painted.</source>
        <translation>Um das Wievielfache Länge oder Fläche des Films wachsen können, bevor er reißt. Gerissener Film wird markiert und nicht aufgetragen.</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Überhang</translation>
    </message>
    <message>
        <source>Film holds on faces that turn upwards by no more than this.</source>
        <translation>Film hält auf Flächen, die sich höchstens so weit nach oben wenden.</translation>
    </message>
    <message>
        <source>Total growth of the floating film after a long time, relative to its length at the start of the dip. 0: the film does not grow.</source>
        <translation>Gesamtes Wachstum des schwimmenden Films nach langer Zeit, bezogen auf seine Länge zu Beginn des Tauchens. 0: Der Film wächst nicht.</translation>
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
        <source>None: a film that was not measured</source>
        <translation>Keines: ein Film, der nicht gemessen wurde</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>FolderTransaction</name>
    <message>
        <source>The results cannot be written, %1 is not a folder</source>
        <translation>Die Ergebnisse können nicht geschrieben werden, %1 ist kein Ordner</translation>
    </message>
    <message>
        <source>The results cannot be written: %1</source>
        <translation>Die Ergebnisse können nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>The results cannot be moved into the folder, is a file there in use?</source>
        <translation>Die Ergebnisse können nicht in den Ordner verschoben werden; wird dort eine Datei benutzt?</translation>
    </message>
    <message>
        <source>%1 is in the way of the results; move it, or choose another folder</source>
        <translation>%1 steht den Ergebnissen im Weg; verschieben Sie es oder wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>Another program is writing results there (%1); wait for it, or choose another folder</source>
        <translation>Ein anderes Programm schreibt dort Ergebnisse (%1); warten Sie darauf, oder wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>The folder cannot be written, choose another</source>
        <translation>In den Ordner kann nicht geschrieben werden; wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>The results are only in part moved into the folder; close what has files there open, and start the program again, which moves the rest</source>
        <translation>Die Ergebnisse sind nur zum Teil in den Ordner verschoben; schließen Sie, was dort Dateien geöffnet hat, und starten Sie das Programm neu: Es verschiebt den Rest</translation>
    </message>
    <message>
        <source>The results cannot be read again: %1</source>
        <translation>Die Ergebnisse lassen sich nicht noch einmal lesen: %1</translation>
    </message>
    <message>
        <source>Earlier results there were not completed and cannot be now; close what has files there open, or move %1 out of it</source>
        <translation>Frühere Ergebnisse dort wurden nicht vollendet und können es jetzt nicht werden; schließen Sie, was dort Dateien offen hat, oder legen Sie %1 woanders hin</translation>
    </message>
    <message>
        <source>Somebody has moved or removed files of %1 while the results were written, and they are not complete; leave it alone and try again</source>
        <translation>Jemand hat Dateien aus %1 verschoben oder entfernt, während die Ergebnisse geschrieben wurden, und sie sind nicht vollständig; lassen Sie den Ordner in Ruhe und versuchen Sie es noch einmal</translation>
    </message>
</context>
<context>
    <name>GuidePlaces</name>
    <message>
        <source>Dip ▸ Check Certainty</source>
        <translation>Tauchen ▸ Verlässlichkeit prüfen</translation>
    </message>
    <message>
        <source>Dip ▸ Tolerances</source>
        <translation>Tauchen ▸ Toleranzen</translation>
    </message>
    <message>
        <source>File ▸ New Project</source>
        <translation>Datei ▸ Neues Projekt</translation>
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
        <source>Reload Model</source>
        <translation>Modell neu laden</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Fuge</translation>
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
        <source>Dip ▸ Find Poses</source>
        <translation>Tauchen ▸ Lagen suchen</translation>
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
        <translation>Bogen</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>File ▸ Print History</source>
        <translation>Datei ▸ Druckverlauf</translation>
    </message>
    <message>
        <source>File ▸ Calibrate Printer</source>
        <translation>Datei ▸ Drucker kalibrieren</translation>
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
        <source>As Built</source>
        <translation>Wie gebaut</translation>
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
        <source>File ▸ Job Queue</source>
        <translation>Datei ▸ Warteschlange</translation>
    </message>
    <message>
        <source>log</source>
        <translation>Protokoll</translation>
    </message>
</context>
<context>
    <name>ImmersionEdits</name>
    <message>
        <source>Add Immersion</source>
        <translation>Tauchvorgang hinzufügen</translation>
    </message>
    <message>
        <source>Immersion %1</source>
        <translation>Tauchvorgang %1</translation>
    </message>
    <message>
        <source>Remove Immersion</source>
        <translation>Tauchvorgang entfernen</translation>
    </message>
    <message>
        <source>Swap Immersions</source>
        <translation>Tauchvorgänge tauschen</translation>
    </message>
    <message>
        <source>Take Pose</source>
        <translation>Lage übernehmen</translation>
    </message>
</context>
<context>
    <name>InspectionEdits</name>
    <message>
        <source>Add Photos</source>
        <translation>Fotos hinzufügen</translation>
    </message>
    <message>
        <source>Remove Photo</source>
        <translation>Foto entfernen</translation>
    </message>
    <message>
        <source>Add Pair of Places</source>
        <translation>Stellenpaar hinzufügen</translation>
    </message>
    <message>
        <source>Move Place in Photo</source>
        <translation>Stelle im Foto verschieben</translation>
    </message>
    <message>
        <source>Remove Pair of Places</source>
        <translation>Stellenpaar entfernen</translation>
    </message>
    <message>
        <source>Change Film on the Water</source>
        <translation>Film auf dem Wasser ändern</translation>
    </message>
    <message>
        <source>Keep Part</source>
        <translation>Teil behalten</translation>
    </message>
    <message>
        <source>Correct the Next Sheets</source>
        <translation>Nächste Bögen korrigieren</translation>
    </message>
    <message>
        <source>Change Strength of Correction</source>
        <translation>Stärke der Korrektur ändern</translation>
    </message>
    <message>
        <source>Use What Was Fitted</source>
        <translation>Anpassung übernehmen</translation>
    </message>
    <message>
        <source>Measured %1</source>
        <translation>Gemessen %1</translation>
    </message>
</context>
<context>
    <name>InspectionProfile</name>
    <message>
        <source>Save to Profile</source>
        <translation>Im Profil speichern</translation>
    </message>
    <message>
        <source>Name of the film profile, an old or a new one</source>
        <translation>Name des Filmprofils, ein vorhandener oder neuer</translation>
    </message>
    <message>
        <source>The film profile %1 has what was measured</source>
        <translation>Das Filmprofil %1 hat die Messung übernommen</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Pose Search</source>
        <translation>Lagensuche</translation>
    </message>
    <message>
        <source>Artwork</source>
        <translation>Gestaltung</translation>
    </message>
</context>
<context>
    <name>MarkEdits</name>
    <message>
        <source>Mark for the Join</source>
        <translation>Marke für die Fuge</translation>
    </message>
    <message>
        <source>Mark a Zone</source>
        <translation>Zone markieren</translation>
    </message>
    <message>
        <source>Remove Mark</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>Remove Marks</source>
        <translation>Marken entfernen</translation>
    </message>
</context>
<context>
    <name>ModelEdits</name>
    <message>
        <source>Change Size</source>
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
        <source>Immersion %1</source>
        <translation>Tauchvorgang %1</translation>
    </message>
    <message>
        <source>Reload Model</source>
        <translation>Modell neu laden</translation>
    </message>
    <message>
        <source>Replace Model</source>
        <translation>Modell ersetzen</translation>
    </message>
    <message>
        <source>Replace Texture</source>
        <translation>Textur ersetzen</translation>
    </message>
    <message>
        <source>Reading the texture</source>
        <translation>Textur wird gelesen</translation>
    </message>
    <message>
        <source>The model names files outside its own folder:</source>
        <translation>Das Modell nennt Dateien außerhalb seines Ordners:</translation>
    </message>
    <message>
        <source>The project, as it was opened, names these files:</source>
        <translation>Das Projekt, wie es geöffnet wurde, nennt diese Dateien:</translation>
    </message>
</context>
<context>
    <name>Motion</name>
    <message>
        <source>The template of the motion names {%1}, which there is not; use one of %2</source>
        <translation>Die Vorlage der Bewegung nennt {%1}, das es nicht gibt; nehmen Sie eines von %2</translation>
    </message>
</context>
<context>
    <name>OutOfProcessSolver</name>
    <message>
        <source>it cannot be given a process of its own: %1</source>
        <translation>er kann keinen eigenen Prozess bekommen: %1</translation>
    </message>
    <message>
        <source>it was at one step for more than %1 s and was stopped</source>
        <translation>er war länger als %1 s an einem Schritt und wurde beendet</translation>
    </message>
    <message>
        <source>its process was killed, perhaps for want of memory</source>
        <translation>sein Prozess wurde beendet, vielleicht aus Mangel an Speicher</translation>
    </message>
    <message>
        <source>it crashed (%1)</source>
        <translation>er ist abgestürzt (%1)</translation>
    </message>
    <message>
        <source>it ended its process (%1)</source>
        <translation>er hat seinen Prozess beendet (%1)</translation>
    </message>
    <message>
        <source>it answered with more than there can be and was stopped</source>
        <translation>er hat mit mehr geantwortet, als es geben kann, und wurde beendet</translation>
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
        <source>axis−diag</source>
        <translation>Achse−Diag</translation>
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
        <translation>FALSCH</translation>
    </message>
    <message>
        <source>Dipping</source>
        <translation>Tauchen</translation>
    </message>
    <message>
        <source>The solver failed: %1</source>
        <translation>Der Löser ist gescheitert: %1</translation>
    </message>
    <message>
        <source>physics validation</source>
        <translation>Prüfung der Physik</translation>
    </message>
    <message>
        <source>The film never touched the body; the solver cannot be used</source>
        <translation>Der Film hat den Körper nie berührt; der Löser ist nicht zu gebrauchen</translation>
    </message>
    <message>
        <source>Sphere to 80°</source>
        <translation>Kugel bis 80°</translation>
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
        <source>Inside of a torus to 80°</source>
        <translation>Innenseite eines Torus bis 80°</translation>
    </message>
    <message>
        <source>Lying cylinder to 80°</source>
        <translation>Liegender Zylinder bis 80°</translation>
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
</context>
<context>
    <name>Pipeline</name>
    <message>
        <source>%1 %2 × %3 mm</source>
        <translation>%1 %2 × %3 mm</translation>
    </message>
    <message>
        <source>1:1, swell %1 × %2 taken out</source>
        <translation>1:1, Quellung %1 × %2 herausgerechnet</translation>
    </message>
    <message>
        <source>The project has no model, import one first</source>
        <translation>Das Projekt hat kein Modell; importieren Sie zuerst eines</translation>
    </message>
    <message>
        <source>%1 failed and %2 took over: %3</source>
        <translation>%1 ist gescheitert, %2 hat übernommen: %3</translation>
    </message>
    <message>
        <source>Finding the film on the body</source>
        <translation>Film auf dem Körper wird gesucht</translation>
    </message>
    <message>
        <source>The body does not meet the film; move it over the film or choose a larger film</source>
        <translation>Der Körper trifft den Film nicht; schieben Sie ihn über den Film oder wählen Sie einen größeren Film</translation>
    </message>
    <message>
        <source>The CPU takes over from %1: %2</source>
        <translation>Die CPU übernimmt für %1: %2</translation>
    </message>
    <message>
        <source>The model is not closed, what is inside is guessed</source>
        <translation>Das Modell ist nicht geschlossen; was innen ist, wird geschätzt</translation>
    </message>
    <message>
        <source>The model has no texture, its plain colours are printed</source>
        <translation>Das Modell hat keine Textur; gedruckt werden seine einfachen Farben</translation>
    </message>
    <message>
        <source>Writing the sheet of %1</source>
        <translation>Bogen von %1 wird geschrieben</translation>
    </message>
    <message>
        <source>Writing the film of %1</source>
        <translation>Film von %1 wird geschrieben</translation>
    </message>
    <message>
        <source>Writing the stretch of %1</source>
        <translation>Dehnung von %1 wird geschrieben</translation>
    </message>
    <message>
        <source>Moving the results in place</source>
        <translation>Ergebnisse werden an ihren Platz gebracht</translation>
    </message>
    <message>
        <source>The film is too fine to be compared with one of %1 × %2 points, set half as many for the comparison</source>
        <translation>Der Film ist zu fein, um mit einem von %1 × %2 Punkten verglichen zu werden; geben Sie ihm für den Vergleich halb so viele</translation>
    </message>
    <message>
        <source>Comparing the sheets</source>
        <translation>Bögen werden verglichen</translation>
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
        <source>Varying the laws</source>
        <translation>Gesetze werden verändert</translation>
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
        <source>Writing the motion</source>
        <translation>Bewegung wird geschrieben</translation>
    </message>
    <message>
        <source>With a law varied the film does not follow the body; give the film smaller cells or more points</source>
        <translation>Mit einem veränderten Gesetz folgt der Film dem Körper nicht; geben Sie dem Film kleinere Zellen oder mehr Punkte</translation>
    </message>
    <message>
        <source>The body is smaller than the film&apos;s cells; give the film smaller cells or more points, or check the model&apos;s unit</source>
        <translation>Der Körper ist kleiner als die Zellen des Films; geben Sie dem Film kleinere Zellen oder mehr Punkte, oder prüfen Sie die Einheit des Modells</translation>
    </message>
    <message>
        <source>%1: the film&apos;s cells are coarse for this body, give the film smaller cells or more points</source>
        <translation>%1: Die Zellen des Films sind grob für diesen Körper; geben Sie dem Film kleinere Zellen oder mehr Punkte</translation>
    </message>
    <message>
        <source>%1 is better dipped after %2: along the join its film is drawn out %3 times and that of %2 %4 times, and the last film lies off so many times as far on the body as on the water</source>
        <translation>%1 wird besser nach %2 getaucht: längs der Fuge ist sein Film auf das %3-fache gedehnt und der von %2 auf das %4-fache, und der letzte Film liegt auf dem Körper um so viel mehr daneben als auf dem Wasser</translation>
    </message>
    <message>
        <source>Writing who paints what</source>
        <translation>Schreibe, wer was färbt</translation>
    </message>
    <message>
        <source>Writing the tolerances of %1</source>
        <translation>Schreibe die Toleranzen von %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The body reaches past the edge of the tank “%1”; move or turn it</source>
        <translation>Der Körper ragt über den Rand des Beckens „%1“ hinaus; verschieben oder drehen Sie ihn</translation>
    </message>
    <message>
        <source>The body reaches past the film&apos;s edge; move or turn it, or %1</source>
        <translation>Der Körper ragt über den Rand des Films hinaus; verschieben oder drehen Sie ihn, oder %1</translation>
    </message>
    <message>
        <source>Film %1: %2 × %3 mm, pieces: %4, %5 % of it used</source>
        <translation>Film %1: %2 × %3 mm, Stücke: %4, zu %5 % genutzt</translation>
    </message>
    <message>
        <source>Writing film %1</source>
        <translation>Schreibe Film %1</translation>
    </message>
    <message>
        <source>Dipping deeper</source>
        <translation>Tiefer getaucht</translation>
    </message>
    <message>
        <source>Two plates of the sheet are called %1; give each a name of its own</source>
        <translation>Zwei Platten des Bogens heißen %1; geben Sie jeder einen eigenen Namen</translation>
    </message>
    <message>
        <source>The artwork has %1 spot inks, and there is room for %2</source>
        <translation>Die Gestaltung hat %1 Sonderfarben, und Platz ist für %2</translation>
    </message>
    <message>
        <source>Of the model&apos;s file: %1</source>
        <translation>Zur Datei des Modells: %1</translation>
    </message>
    <message>
        <source>Parts of the model are only %1 mm thick, and the distance field, with cells of %2 mm, is at its limit: film may miss them; make them thicker, or dip a smaller part of the model</source>
        <translation>Teile des Modells sind nur %1 mm dick, und das Abstandsfeld ist mit Zellen von %2 mm an seiner Grenze: Der Film kann sie verfehlen; machen Sie sie dicker oder tauchen Sie einen kleineren Teil des Modells</translation>
    </message>
    <message>
        <source>The model is inside out, at least in parts, and film does not lie on what faces inwards; import it anew, which turns it</source>
        <translation>Das Modell ist zumindest teilweise umgestülpt, und auf dem, was nach innen zeigt, liegt kein Film; lesen Sie es neu ein, dann wird es gewendet</translation>
    </message>
    <message>
        <source>The sheets take about %1 GB of memory while they are made</source>
        <translation>Die Bogen brauchen etwa %1 GB Speicher, während sie entstehen</translation>
    </message>
    <message>
        <source>The sheets would take about %1 GB of memory, and this computer has %2 GB: choose a lower resolution or a smaller film</source>
        <translation>Die Bogen bräuchten etwa %1 GB Speicher, und dieser Rechner hat %2 GB: Wählen Sie eine niedrigere Auflösung oder einen kleineren Film</translation>
    </message>
    <message>
        <source>The picture on the film</source>
        <translation>Das Bild auf dem Film</translation>
    </message>
</context>
<context>
    <name>PlainFile</name>
    <message>
        <source>it is a folder</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>it is a pipe or a device; save what it sends as a file, and name that</source>
        <translation>es ist eine Pipe oder ein Gerät; was sie liefert, als Datei speichern und diese angeben</translation>
    </message>
</context>
<context>
    <name>Png</name>
    <message>
        <source>The picture cannot be stored as PNG: %1</source>
        <translation>Das Bild kann nicht als PNG gespeichert werden: %1</translation>
    </message>
    <message>
        <source>The picture cannot be stored as PNG, it is empty or too large for this computer&apos;s memory</source>
        <translation>Das Bild kann nicht als PNG gespeichert werden, es ist leer oder zu groß für den Speicher dieses Rechners</translation>
    </message>
</context>
<context>
    <name>PoseSearch</name>
    <message>
        <source>Trying poses</source>
        <translation>Lagen werden probiert</translation>
    </message>
    <message>
        <source>No pose paints anything; choose a larger film</source>
        <translation>Keine Lage bemalt etwas; wählen Sie einen größeren Film</translation>
    </message>
    <message>
        <source>Immersion %1</source>
        <translation>Tauchvorgang %1</translation>
    </message>
    <message>
        <source>The project has no model, import one first</source>
        <translation>Das Projekt hat kein Modell; importieren Sie zuerst eines</translation>
    </message>
    <message>
        <source>Judging directions by the body&apos;s shape</source>
        <translation>Richtungen werden nach der Form des Körpers beurteilt</translation>
    </message>
    <message>
        <source>part %1 of %2</source>
        <translation>Teil %1 von %2</translation>
    </message>
    <message>
        <source>Hand over each of the %1 parts once; there are %2</source>
        <translation>Übergeben Sie jeden der %1 Teile einmal; es sind %2</translation>
    </message>
    <message>
        <source>This part does not hold the dips that are its share; make it again</source>
        <translation>Dieser Teil enthält nicht die Tauchvorgänge, die sein Anteil sind; erzeugen Sie ihn neu</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>dasselbe</translation>
    </message>
    <message>
        <source>This is not a part of a pose search, or it is damaged; make it again</source>
        <translation>Dies ist kein Teil einer Lagensuche, oder er ist beschädigt; erzeugen Sie ihn neu</translation>
    </message>
    <message>
        <source>Choose a number from %1 to %2</source>
        <translation>Wählen Sie eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>There is no measure of this name; choose one of %1</source>
        <translation>Es gibt kein Maß dieses Namens; wählen Sie eines von %1</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Bedeckung</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Größte Dehnung</translation>
    </message>
    <message>
        <source>Certain</source>
        <translation>Sicher</translation>
    </message>
    <message>
        <source>Wrinkled</source>
        <translation>Gefaltet</translation>
    </message>
    <message>
        <source>Torn</source>
        <translation>Gerissen</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Eingeschlossene Luft</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Naht</translation>
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
        <source>All weights are 0; give one of them more</source>
        <translation>Alle Gewichte sind 0; geben Sie einem mehr</translation>
    </message>
    <message>
        <source>This part belongs to another search; make all parts from the same project with the same options and solver</source>
        <translation>Dieser Teil gehört zu einer anderen Suche; erzeugen Sie alle Teile aus demselben Projekt mit denselben Optionen und demselben Löser</translation>
    </message>
    <message>
        <source>Narrow overlap</source>
        <translation>Schmale Überlappung</translation>
    </message>
</context>
<context>
    <name>ProfileSpecs</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What the profile is called in lists and in projects.</source>
        <translation>Wie das Profil in Listen und Projekten heißt.</translation>
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
        <source>System&apos;s name</source>
        <translation>Name im System</translation>
    </message>
    <message>
        <source>The name under which the system knows the printer. It is then chosen at first when a sheet is printed.</source>
        <translation>Der Name, unter dem das System den Drucker kennt. Beim Drucken eines Bogens ist er dann zuerst gewählt.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Printed length over true length, across the paper and along its feed. Sheets are drawn smaller by it. “Calibrate Printer” measures it.</source>
        <translation>Gedruckte durch wahre Länge, quer zum Papier und entlang seinem Einzug. Bögen werden um so viel kleiner gezeichnet. „Drucker kalibrieren“ misst es.</translation>
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
        <source>What the printer does not reach at the paper&apos;s left, top, right and bottom edge.</source>
        <translation>Was der Drucker am linken, oberen, rechten und unteren Rand des Papiers nicht erreicht.</translation>
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
        <source>Pixels an inch of the sheets for this printer.</source>
        <translation>Pixel je Zoll der Bögen für diesen Drucker.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Rendering intent</source>
        <translation>Wiedergabeabsicht</translation>
    </message>
    <message>
        <source>How colours that the printer cannot make are brought into its reach.</source>
        <translation>Wie Farben, die der Drucker nicht kann, in seinen Bereich geholt werden.</translation>
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
        <source>Fit black point</source>
        <translation>Schwarzpunkt anpassen</translation>
    </message>
    <message>
        <source>Fits the darkest dark to what the printer can print, so that shadows stay distinct.</source>
        <translation>Passt das dunkelste Dunkel an das an, was der Drucker kann, damit Schatten unterscheidbar bleiben.</translation>
    </message>
    <message>
        <source>Ink limit</source>
        <translation>Farbgrenze</translation>
    </message>
    <message>
        <source>The highest optical density a channel that the film holds.</source>
        <translation>Die höchste optische Dichte je Kanal, die der Film hält.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Width and height of the dry film.</source>
        <translation>Breite und Höhe des trockenen Films.</translation>
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
        <source>The edge that goes into the printer first: a film swells more along its web.</source>
        <translation>Die Kante, die zuerst in den Drucker geht: Ein Film quillt entlang seiner Bahn stärker.</translation>
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
        <source>The maker&apos;s number: another lot may swell otherwise.</source>
        <translation>Die Nummer des Herstellers: Eine andere Charge quillt vielleicht anders.</translation>
    </message>
    <message>
        <source>Use before</source>
        <translation>Verwendbar bis</translation>
    </message>
    <message>
        <source>A date such as 2027-03-31, or nothing.</source>
        <translation>Ein Datum wie 2027-03-31 oder nichts.</translation>
    </message>
    <message>
        <source>Behaviour on the water</source>
        <translation>Verhalten auf dem Wasser</translation>
    </message>
    <message>
        <source>Soak time</source>
        <translation>Weichzeit</translation>
    </message>
    <message>
        <source>From the water to the activator.</source>
        <translation>Vom Auflegen bis zum Aktivator.</translation>
    </message>
    <message>
        <source>Activator time</source>
        <translation>Aktivatorzeit</translation>
    </message>
    <message>
        <source>From the activator to the dip.</source>
        <translation>Vom Aktivator bis zum Tauchen.</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Width and length of the water.</source>
        <translation>Breite und Länge der Wasserfläche.</translation>
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
        <source>How far the water stands under the tank&apos;s rim.</source>
        <translation>Wie weit das Wasser unter dem Beckenrand steht.</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Between the tank&apos;s marks, across and along, which the sheet&apos;s registration marks are laid to. 0: there are none.</source>
        <translation>Abstand der Marken des Beckens, quer und längs, an die die Passmarken des Bogens gelegt werden. 0: Es gibt keine.</translation>
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
        <source>Advanced: laws without measurement</source>
        <translation>Erweitert: Gesetze ohne Messung</translation>
    </message>
    <message>
        <source>Flash time</source>
        <translation>Ablüftzeit</translation>
    </message>
    <message>
        <source>From the dip to the rinse.</source>
        <translation>Vom Tauchen bis zum Abspülen.</translation>
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
        <source>From the rinse until the body may be touched, or dipped again.</source>
        <translation>Vom Abspülen, bis der Körper angefasst oder wieder getaucht werden darf.</translation>
    </message>
    <message>
        <source>Measured by photos</source>
        <translation>Auf Fotos gemessen</translation>
    </message>
    <message>
        <source>Measured on</source>
        <translation>Gemessen am</translation>
    </message>
    <message>
        <source>The day of the photos. While swell and growth are what they gave, the profile counts as measured, else as guessed.</source>
        <translation>Der Tag der Fotos. Solange Quellung und Wachstum sind, was sie ergaben, gilt das Profil als gemessen, sonst als geschätzt.</translation>
    </message>
    <message>
        <source>Water, °C</source>
        <translation>Wasser, °C</translation>
    </message>
    <message>
        <source>How warm the water was.</source>
        <translation>Wie warm das Wasser war.</translation>
    </message>
    <message>
        <source>Swell found</source>
        <translation>Gefundene Quellung</translation>
    </message>
    <message>
        <source>The swell that the photos gave. 0: none.</source>
        <translation>Die Quellung, die die Fotos ergaben. 0: keine.</translation>
    </message>
    <message>
        <source>… and off by</source>
        <translation>… und ungenau um</translation>
    </message>
    <message>
        <source>How far that swell may be off, at 95 %.</source>
        <translation>Um wie viel diese Quellung falsch sein kann, mit 95 %.</translation>
    </message>
    <message>
        <source>Growth found</source>
        <translation>Gefundenes Wachstum</translation>
    </message>
    <message>
        <source>The growth that the photos gave.</source>
        <translation>Das Wachstum, das die Fotos ergaben.</translation>
    </message>
    <message>
        <source>… at most</source>
        <translation>… höchstens</translation>
    </message>
    <message>
        <source>The growth&apos;s limit that the photos gave.</source>
        <translation>Die Grenze des Wachstums, die die Fotos ergaben.</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>How far the corners in the photos lie from where these figures have them, on the average.</source>
        <translation>Wie weit die Ecken auf den Fotos im Mittel davon entfernt liegen, wo diese Zahlen sie erwarten.</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>The SHA-256 of the photos&apos; files, by which they can be known again.</source>
        <translation>Der SHA-256 der Fotodateien, an dem sie wiederzuerkennen sind.</translation>
    </message>
    <message>
        <source>Relaxation found</source>
        <translation>Gefundene Relaxation</translation>
    </message>
    <message>
        <source>The relaxation time that photos of a dipped part gave.</source>
        <translation>Die Relaxationszeit, die Fotos eines getauchten Teils ergaben.</translation>
    </message>
    <message>
        <source>Total ink</source>
        <translation>Gesamtfarbauftrag</translation>
    </message>
    <message>
        <source>Most of all four inks together on one place, with an ICC profile in CMYK. Cyan, magenta and yellow give way, black stays.</source>
        <translation>Höchstens so viel von allen vier Farben zusammen an einer Stelle, mit einem ICC-Profil in CMYK. Cyan, Magenta und Gelb weichen, Schwarz bleibt.</translation>
    </message>
    <message>
        <source>As the ICC profile has it</source>
        <translation>Wie im ICC-Profil</translation>
    </message>
</context>
<context>
    <name>Profiles</name>
    <message>
        <source>%1, lot %2,</source>
        <translation>%1, Charge %2,</translation>
    </message>
    <message>
        <source>The film %1 expired on %2; take a fresh lot, or try this one first</source>
        <translation>Der Film %1 ist am %2 abgelaufen; nehmen Sie eine frische Charge oder proben Sie erst mit dieser</translation>
    </message>
    <message>
        <source>The ICC profile is not stored as base64 text, import it anew</source>
        <translation>Das ICC-Profil ist nicht als Base64-Text gespeichert; importieren Sie es neu</translation>
    </message>
    <message>
        <source>%1 is not a date, write it as 2027-03-31</source>
        <translation>%1 ist kein Datum; schreiben Sie es wie 2027-03-31</translation>
    </message>
    <message>
        <source>This is not a Dipwright profile</source>
        <translation>Das ist kein Dipwright-Profil</translation>
    </message>
    <message>
        <source>The profile has version %1 of the file format and this program reads up to version %2, open it with a newer Dipwright</source>
        <translation>Das Profil hat die Version %1 des Dateiformats, dieses Programm liest bis Version %2; öffnen Sie es mit einem neueren Dipwright</translation>
    </message>
    <message>
        <source>A profile needs a name</source>
        <translation>Ein Profil braucht einen Namen</translation>
    </message>
    <message>
        <source>There is no %1 profile of this name, there are: %2</source>
        <translation>Ein Profil für %1 mit diesem Namen gibt es nicht; es gibt: %2</translation>
    </message>
    <message>
        <source>The folder for profiles cannot be made, choose another with DIPWRIGHT_PROFILE_PATH</source>
        <translation>Der Ordner für Profile kann nicht angelegt werden; wählen Sie mit DIPWRIGHT_PROFILE_PATH einen anderen</translation>
    </message>
    <message>
        <source>The profile cannot be removed</source>
        <translation>Das Profil kann nicht entfernt werden</translation>
    </message>
    <message>
        <source>There is no %1 profile of your own of this name</source>
        <translation>Ein eigenes Profil für %1 mit diesem Namen gibt es nicht</translation>
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
        <source>There is no such kind of profile, use printer, film or tank</source>
        <translation>Diese Art Profil gibt es nicht; nehmen Sie printer, film oder tank</translation>
    </message>
    <message>
        <source>There is no such value in this profile, there are %1</source>
        <translation>Diesen Wert gibt es in diesem Profil nicht; es gibt %1</translation>
    </message>
    <message>
        <source>The profile is being written elsewhere (%1), try again</source>
        <translation>Das Profil wird gerade anderswo geschrieben (%1); versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>Another program has changed the profile since it was read, nothing is saved; look at what it says now and do it again</source>
        <translation>Ein anderes Programm hat das Profil geändert, seit es gelesen wurde; nichts ist gespeichert. Sehen Sie nach, was es nun sagt, und ändern Sie es noch einmal</translation>
    </message>
    <message>
        <source>The file that is there cannot be read as a profile and is not replaced; mend it, move it away, or choose another name: %1</source>
        <translation>Die vorhandene Datei ist nicht als Profil lesbar und wird nicht ersetzt; bitte berichtigen, verschieben oder einen anderen Namen wählen: %1</translation>
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
        <translation>ein Feld</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>%1 does not fit here, give %2</source>
        <translation>%1 passt hier nicht; geben Sie %2 an</translation>
    </message>
    <message>
        <source>%1 does not fit here, give %2 parts, each %3</source>
        <translation>%1 passt hier nicht; geben Sie %2 Teile an, jeder %3</translation>
    </message>
    <message>
        <source>“%1” must be an object</source>
        <translation>„%1“ muss ein Objekt sein</translation>
    </message>
    <message>
        <source>There is no film size of this name, use one of %1</source>
        <translation>Ein Filmformat dieses Namens gibt es nicht; nehmen Sie eines von %1</translation>
    </message>
    <message>
        <source>immersions must be an array of one or two immersions</source>
        <translation>immersions muss ein Feld von einem oder zwei Tauchvorgängen sein</translation>
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
        <source>The project has version %1 of the file format and this program reads up to version %2, open it with a newer Dipwright</source>
        <translation>Das Projekt hat die Version %1 des Dateiformats, dieses Programm liest bis Version %2; öffnen Sie es mit einem neueren Dipwright</translation>
    </message>
    <message>
        <source>there are %1</source>
        <translation>es gibt %1</translation>
    </message>
    <message>
        <source>There is no such setting, %1</source>
        <translation>Diese Einstellung gibt es nicht; %1</translation>
    </message>
    <message>
        <source>There is no preset %1, use production or paper-2020</source>
        <translation>Die Vorgabe %1 gibt es nicht; nehmen Sie production oder paper-2020</translation>
    </message>
    <message>
        <source>%1 × %2 points are more than the %3 million that a film may have, give fewer</source>
        <translation>%1 × %2 Punkte sind mehr als die %3 Millionen, die ein Film haben darf; nehmen Sie weniger</translation>
    </message>
    <message>
        <source>A value is missing, give %1</source>
        <translation>Hier fehlt ein Wert; geben Sie %1 an</translation>
    </message>
    <message>
        <source>%1 must be an array of at most %2 entries</source>
        <translation>%1 muss eine Liste mit höchstens %2 Einträgen sein</translation>
    </message>
    <message>
        <source>inspection.pairs names a photo that inspection.photos has not</source>
        <translation>inspection.pairs nennt ein Foto, das inspection.photos nicht hat</translation>
    </message>
    <message>
        <source>A spot ink needs a name of its own, and not All, None, or that of one of the four inks</source>
        <translation>Eine Sonderfarbe braucht einen eigenen Namen, nicht All, None oder den einer der vier Farben</translation>
    </message>
    <message>
        <source>“%1” is not a colour, write it as #1a2b3c</source>
        <translation>„%1“ ist keine Farbe, schreiben Sie sie als #1a2b3c</translation>
    </message>
    <message>
        <source>a colour such as #1a2b3c</source>
        <translation>eine Farbe wie #1a2b3c</translation>
    </message>
    <message>
        <source>The artwork&apos;s layers are %1 in number, the lowest is artwork.layers[0]</source>
        <translation>Die Gestaltung hat Ebenen in der Zahl %1, die unterste ist artwork.layers[0]</translation>
    </message>
    <message>
        <source>The project&apos;s immersions are %1 in number, the first is immersions[0]</source>
        <translation>Die Zahl der Tauchvorgänge des Projekts ist %1, der erste ist immersions[0]</translation>
    </message>
    <message>
        <source>the sections are artwork, film, process, body, immersions[0], sheet, ink, share, cradle, tolerance, pose_search, as_built and inspection</source>
        <translation>die Abschnitte sind artwork, film, process, body, immersions[0], sheet, ink, share, cradle, tolerance, pose_search, as_built und inspection</translation>
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
        <source>Immersions</source>
        <translation>Tauchvorgänge</translation>
    </message>
    <message>
        <source>Marks for the join</source>
        <translation>Marken für die Fuge</translation>
    </message>
    <message>
        <source>Marks for zones</source>
        <translation>Marken für Zonen</translation>
    </message>
    <message>
        <source>Printer&apos;s profile</source>
        <translation>Druckerprofil</translation>
    </message>
    <message>
        <source>Film&apos;s profile</source>
        <translation>Filmprofil</translation>
    </message>
    <message>
        <source>Tank&apos;s profile</source>
        <translation>Beckenprofil</translation>
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
        <source>%1, otherwise</source>
        <translation>%1, sonst anders</translation>
    </message>
    <message>
        <source>Artwork · layer %1</source>
        <translation>Gestaltung · Ebene %1</translation>
    </message>
    <message>
        <source>%1, %2 × %3%7 at (%4; %5; %6)%7, turned by %8°</source>
        <translation>%1, %2 × %3%7 bei (%4; %5; %6)%7, um %8° gedreht</translation>
    </message>
</context>
<context>
    <name>ProjectFile</name>
    <message>
        <source>Another program has written the project since it was read, nothing is saved; look at what it holds now and do it again</source>
        <translation>Ein anderes Programm hat das Projekt geschrieben, seit es gelesen wurde; nichts ist gespeichert. Sehen Sie nach, was es nun enthält, und wiederholen Sie den Schritt</translation>
    </message>
    <message>
        <source>The project is open elsewhere (%1); close it there, or work on a copy</source>
        <translation>Das Projekt ist anderswo geöffnet (%1); schließen Sie es dort, oder arbeiten Sie an einer Kopie</translation>
    </message>
    <message>
        <source>The file that is there cannot be read, and nothing is saved over it; try again, or save under another name</source>
        <translation>Die Datei, die dort liegt, kann nicht gelesen werden, und nichts wird über sie gespeichert; versuchen Sie es noch einmal, oder speichern Sie unter einem anderen Namen</translation>
    </message>
</context>
<context>
    <name>ProjectStore</name>
    <message>
        <source>This is not a Dipwright project, it holds no project.json</source>
        <translation>Das ist kein Dipwright-Projekt, es enthält keine project.json</translation>
    </message>
    <message>
        <source>project.json is damaged at character %1: %2</source>
        <translation>project.json ist bei Zeichen %1 beschädigt: %2</translation>
    </message>
    <message>
        <source>The model in the project is not the one that was saved, its sha256 differs</source>
        <translation>Das Modell im Projekt ist nicht das gespeicherte, sein sha256 weicht ab</translation>
    </message>
    <message>
        <source>The project lists %1 textures and its model needs %2</source>
        <translation>Das Projekt nennt %1 Texturen, sein Modell braucht %2</translation>
    </message>
    <message>
        <source>The project cannot be saved: %1</source>
        <translation>Das Projekt kann nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>project.json holds a list where a project should be</source>
        <translation>project.json enthält eine Liste, wo ein Projekt stehen sollte</translation>
    </message>
    <message>
        <source>The project names no model, model.mesh is missing</source>
        <translation>Das Projekt nennt kein Modell, model.mesh fehlt</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>The project is not saved, as it could not be opened again: %1</source>
        <translation>Das Projekt wird nicht gespeichert, da es nicht wieder geöffnet werden könnte: %1</translation>
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
    <name>PropertySpecs</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What the project is called. It stands in the job line of every sheet.</source>
        <translation>Wie das Projekt heißt. Der Name steht in der Auftragszeile jedes Bogens.</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>The date in the job line. It belongs to the project, so that the same project always gives the same sheet.</source>
        <translation>Das Datum in der Auftragszeile. Es gehört zum Projekt, damit dasselbe Projekt immer denselben Bogen ergibt.</translation>
    </message>
    <message>
        <source>Distance field</source>
        <translation>Abstandsfeld</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Samples along each edge of the cube round the body in which the distance to its surface is kept. More follows finer detail and takes longer to build.</source>
        <translation>Abtastpunkte je Kante des Würfels um den Körper, in dem der Abstand zur Oberfläche liegt. Mehr folgt feineren Einzelheiten und braucht länger.</translation>
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
        <source>The size in which the film comes and is printed.</source>
        <translation>Die Größe, in der der Film geliefert und bedruckt wird.</translation>
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
        <source>Width and height of the printed film. The grid keeps its spacing.</source>
        <translation>Breite und Höhe des gedruckten Films. Das Gitter behält seinen Abstand.</translation>
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
        <source>Points of the simulated film across and down. More points show finer detail and take longer.</source>
        <translation>Punkte des simulierten Films quer und längs. Mehr Punkte zeigen feinere Einzelheiten und brauchen länger.</translation>
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
        <source>Isotropic film resists shear and gives the same result whichever way the grid lies. The structural lattice joins horizontal and vertical neighbours only, as in the paper of 2020.</source>
        <translation>Isotroper Film widersteht Scherung und ergibt dasselbe, wie das Gitter auch liegt. Das strukturelle Gitter verbindet nur waagrechte und senkrechte Nachbarn, wie in der Arbeit von 2020.</translation>
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
        <source>Whether the water holds up the free film. Without it nothing does.</source>
        <translation>Ob das Wasser den freien Film trägt. Ohne es trägt ihn nichts.</translation>
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
        <source>How fast the body comes down into the water.</source>
        <translation>Wie schnell der Körper ins Wasser sinkt.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>How far the lowest point of the body goes under the waterline. “Whole body” dips until all of it is under.</source>
        <translation>Wie weit der tiefste Punkt des Körpers unter die Wasserlinie kommt. „Ganzer Körper“ taucht, bis alles unter Wasser ist.</translation>
    </message>
    <message>
        <source>Whole body</source>
        <translation>Ganzer Körper</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Zugabe</translation>
    </message>
    <message>
        <source>How much farther than fully under the body is dipped.</source>
        <translation>Wie viel weiter als ganz unter Wasser der Körper getaucht wird.</translation>
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
        <source>How far the contact line travels in one step, in cells of the film. Smaller is finer and slower.</source>
        <translation>Wie weit die Kontaktlinie in einem Schritt wandert, in Zellen des Films. Kleiner ist feiner und langsamer.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Time that one step simulates.</source>
        <translation>Zeit, die ein Schritt simuliert.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>Sweeps over all constraints in one step.</source>
        <translation>Durchläufe über alle Zwangsbedingungen in einem Schritt.</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>Durchläufe</translation>
    </message>
    <message>
        <source>Jacobi corrects all points at once and averages; Gauss–Seidel one after the other.</source>
        <translation>Jacobi korrigiert alle Punkte zugleich und mittelt, Gauß–Seidel einen nach dem anderen.</translation>
    </message>
    <message>
        <source>Self-contact</source>
        <translation>Selbstkontakt</translation>
    </message>
    <message>
        <source>Keep film from passing through film.</source>
        <translation>Verhindert, dass Film durch Film dringt.</translation>
    </message>
    <message>
        <source>What this immersion is called. It stands in the job line of its sheet.</source>
        <translation>Wie dieser Tauchvorgang heißt. Der Name steht in der Auftragszeile seines Bogens.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>How the body is turned about X, then Y, then Z before it is dipped. Drag the rings in the view to turn it by hand; hold Shift for steps of 15°.</source>
        <translation>Wie der Körper vor dem Tauchen um X, dann Y, dann Z gedreht wird. Ziehen Sie an den Ringen der Ansicht, um ihn von Hand zu drehen; mit Umschalt in Schritten von 15°.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Where the body meets the film, from the middle of the film: X to the right, Z down the sheet.</source>
        <translation>Wo der Körper den Film trifft, von der Mitte des Films aus: X nach rechts, Z den Bogen hinab.</translation>
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
        <source>The page that the film image is laid on. “As the film” prints the film itself, edge to edge.</source>
        <translation>Die Seite, auf die das Filmbild gelegt wird. „Wie der Film“ druckt den Film selbst, von Rand zu Rand.</translation>
    </message>
    <message>
        <source>As the film</source>
        <translation>Wie der Film</translation>
    </message>
    <message>
        <source>Width and height of the page.</source>
        <translation>Breite und Höhe der Seite.</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source>Turn the page on its side.</source>
        <translation>Die Seite quer legen.</translation>
    </message>
    <message>
        <source>Pixels to the inch of the film image.</source>
        <translation>Bildpunkte je Zoll des Filmbilds.</translation>
    </message>
    <message>
        <source>Bleed</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>How far the colour is continued past the painted area, so that a small error of position leaves no bare edge.</source>
        <translation>Wie weit die Farbe über die bemalte Fläche hinaus weitergeht, damit ein kleiner Lagefehler keinen kahlen Rand lässt.</translation>
    </message>
    <message>
        <source>On the page</source>
        <translation>Auf der Seite</translation>
    </message>
    <message>
        <source>Registration marks</source>
        <translation>Passmarken</translation>
    </message>
    <message>
        <source>Marks in the corners by which the film is laid into the tank.</source>
        <translation>Marken in den Ecken, nach denen der Film ins Becken gelegt wird.</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Lineal</translation>
    </message>
    <message>
        <source>A ruler of 100 mm: measure it to see that the page was printed at true size.</source>
        <translation>Ein Lineal von 100 mm: Messen Sie nach, ob die Seite in wahrer Größe gedruckt wurde.</translation>
    </message>
    <message>
        <source>Job line</source>
        <translation>Auftragszeile</translation>
    </message>
    <message>
        <source>A line with project, immersion, date, film, scale and a check sum.</source>
        <translation>Eine Zeile mit Projekt, Tauchvorgang, Datum, Film, Maßstab und Prüfsumme.</translation>
    </message>
    <message>
        <source>Compensate stretch</source>
        <translation>Dehnung ausgleichen</translation>
    </message>
    <message>
        <source>Ink thins where the film stretches. Print more there, so that the body shows the colour of the texture.</source>
        <translation>Farbe wird dünner, wo sich der Film dehnt. Dort mehr drucken, damit der Körper die Farbe der Textur zeigt.</translation>
    </message>
    <message>
        <source>Ink limit</source>
        <translation>Farbgrenze</translation>
    </message>
    <message>
        <source>The highest optical density that can be printed. Where more would be needed, the colour falls short and the report says so.</source>
        <translation>Die höchste optische Dichte, die gedruckt werden kann. Wo mehr nötig wäre, reicht die Farbe nicht, und der Bericht sagt es.</translation>
    </message>
    <message>
        <source>Advanced: laws without measurement</source>
        <translation>Erweitert: Gesetze ohne Messung</translation>
    </message>
    <message>
        <source>How fine the simulated film is. Automatic chooses the size of its cells from the body&apos;s narrow parts and its pose: fine where the body comes down, coarse towards the film&apos;s edges.</source>
        <translation>Wie fein die simulierte Folie ist. „Automatisch“ wählt die Größe ihrer Zellen nach den schmalen Stellen des Körpers und seiner Lage: fein, wo der Körper eintaucht, grob zu den Rändern der Folie hin.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Size of the cells</source>
        <translation>Größe der Zellen</translation>
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
        <source>The side of the simulated film&apos;s cells where the body comes down. Smaller cells show finer detail and take longer.</source>
        <translation>Die Seite der Zellen der simulierten Folie dort, wo der Körper eintaucht. Kleinere Zellen zeigen feinere Einzelheiten und dauern länger.</translation>
    </message>
    <message>
        <source>Each dip paints the places that it paints better, and leaves the others blank. If not, both paint all that they reach, and some places are painted twice.</source>
        <translation>Jeder Tauchvorgang färbt die Stellen, die er besser färbt, und lässt die anderen frei. Sonst färben beide alles, was sie erreichen, und manche Stellen werden doppelt gefärbt.</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>The band along the join in which both dips fade into each other, on the body. It is made wider where the registration error would show in it.</source>
        <translation>Das Band längs der Fuge, in dem beide Tauchvorgänge ineinander übergehen, auf dem Körper. Es wird breiter, wo der Passerfehler darin zu sehen wäre.</translation>
    </message>
    <message>
        <source>Registration error</source>
        <translation>Passerfehler</translation>
    </message>
    <message>
        <source>How far the second dip may lie off the first. The band is made wide enough that no edge shows.</source>
        <translation>Wie weit der zweite Tauchvorgang neben dem ersten liegen darf. Das Band wird so breit, dass keine Kante zu sehen ist.</translation>
    </message>
    <message>
        <source>Stretched by at most</source>
        <translation>Höchstens gedehnt um</translation>
    </message>
    <message>
        <source>Where one dip&apos;s film is drawn out to more times its length, the other is to paint, if it can.</source>
        <translation>Wo der Film eines Tauchvorgangs auf mehr als das Sovielfache seiner Länge gezogen ist, färbt der andere, wenn er kann.</translation>
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
        <source>How far the cradle keeps off the body that lies in it.</source>
        <translation>Wie weit die Halterung von dem Körper wegbleibt, der in ihr liegt.</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>How thick what holds the body is, at its thinnest.</source>
        <translation>Wie dick an der dünnsten Stelle ist, was den Körper hält.</translation>
    </message>
    <message>
        <source>Reaches down</source>
        <translation>Reicht hinab</translation>
    </message>
    <message>
        <source>How far below the body&apos;s top the cradle reaches. It goes deeper where the body would tip or slide.</source>
        <translation>Wie weit unter das obere Ende des Körpers die Halterung reicht. Sie geht tiefer, wo der Körper kippen oder rutschen würde.</translation>
    </message>
    <message>
        <source>Off the film</source>
        <translation>Vom Film weg</translation>
    </message>
    <message>
        <source>How far the cradle keeps off all that the film reaches, and off what earlier dips have painted.</source>
        <translation>Wie weit die Halterung von allem wegbleibt, was der Film erreicht, und von dem, was frühere Tauchvorgänge bemalt haben.</translation>
    </message>
    <message>
        <source>On paint</source>
        <translation>Auf Farbe</translation>
    </message>
    <message>
        <source>Whether the cradle may lie on what earlier dips have painted, through padding.</source>
        <translation>Ob die Halterung, durch ein Polster, auf dem liegen darf, was frühere Tauchvorgänge bemalt haben.</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Polster</translation>
    </message>
    <message>
        <source>Room that is left for felt or foam where the cradle lies on paint.</source>
        <translation>Raum, der für Filz oder Schaum bleibt, wo die Halterung auf Farbe liegt.</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>How thick the plate is that the cradle hangs from.</source>
        <translation>Wie dick die Platte ist, an der die Halterung hängt.</translation>
    </message>
    <message>
        <source>Off the water</source>
        <translation>Vom Wasser weg</translation>
    </message>
    <message>
        <source>How far the plate stays above the water at the end of the dip.</source>
        <translation>Wie weit die Platte am Ende des Tauchvorgangs über dem Wasser bleibt.</translation>
    </message>
    <message>
        <source>Pins apart</source>
        <translation>Abstand der Stifte</translation>
    </message>
    <message>
        <source>How far apart two of the datum pins are at most. They stand where the sheet&apos;s marks float, or are drawn in towards the film&apos;s middle.</source>
        <translation>Wie weit zwei der Passstifte höchstens voneinander entfernt sind. Sie stehen, wo die Marken des Bogens schwimmen, oder sind zur Mitte des Films hereingezogen.</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Stifte</translation>
    </message>
    <message>
        <source>The diameter of the datum pins of the tank&apos;s frame.</source>
        <translation>Der Durchmesser der Passstifte am Rahmen des Beckens.</translation>
    </message>
    <message>
        <source>Pin clearance</source>
        <translation>Spiel der Stifte</translation>
    </message>
    <message>
        <source>How much wider than the pins their holes are, all round.</source>
        <translation>Um wie viel weiter als die Stifte ihre Löcher ringsum sind.</translation>
    </message>
    <message>
        <source>Bore</source>
        <translation>Bohrung</translation>
    </message>
    <message>
        <source>A hole through plate and seat, to fix the body by a screw, suction or hot glue. At 0 there is none.</source>
        <translation>Ein Loch durch Platte und Sitz, um den Körper mit Schraube, Sauger oder Heißkleber zu befestigen. Bei 0 gibt es keines.</translation>
    </message>
    <message>
        <source>Engraving</source>
        <translation>Gravur</translation>
    </message>
    <message>
        <source>How deep arrow, number and job are cut into the plate. At 0 they are not.</source>
        <translation>Wie tief Pfeil, Nummer und Auftrag in die Platte geschnitten sind. Bei 0 gar nicht.</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>The side of the cells that the cradle&apos;s form is computed on. Smaller is smoother, slower and makes larger files.</source>
        <translation>Die Seite der Zellen, auf denen die Form der Halterung berechnet wird. Kleiner ist glatter, langsamer und macht größere Dateien.</translation>
    </message>
    <message>
        <source>Body on the water</source>
        <translation>Körper auf dem Wasser</translation>
    </message>
    <message>
        <source>How far the body may lie off its place when it meets the film. 95 of 100 dips keep a tolerance.</source>
        <translation>Wie weit der Körper neben seinem Ort sein darf, wenn er den Film trifft. 95 von 100 Tauchvorgängen halten eine Toleranz ein.</translation>
    </message>
    <message>
        <source>Body turned</source>
        <translation>Körper verdreht</translation>
    </message>
    <message>
        <source>How far the body may be turned off its pose, about axes through its middle.</source>
        <translation>Wie weit der Körper gegen seine Lage verdreht sein darf, um Achsen durch seine Mitte.</translation>
    </message>
    <message>
        <source>Film on the water</source>
        <translation>Film auf dem Wasser</translation>
    </message>
    <message>
        <source>How far the film may lie off its place when the body meets it.</source>
        <translation>Wie weit der Film neben seinem Ort liegen darf, wenn der Körper ihn trifft.</translation>
    </message>
    <message>
        <source>Film turned</source>
        <translation>Film verdreht</translation>
    </message>
    <message>
        <source>How far the film may be turned on the water, about its middle.</source>
        <translation>Wie weit der Film auf dem Wasser verdreht sein darf, um seine Mitte.</translation>
    </message>
    <message>
        <source>By how much of its length the floating film may be longer or shorter than reckoned.</source>
        <translation>Um welchen Teil seiner Länge der schwimmende Film länger oder kürzer sein darf als gerechnet.</translation>
    </message>
    <message>
        <source>Water level</source>
        <translation>Wasserstand</translation>
    </message>
    <message>
        <source>By how much the body may go under deeper or less deep.</source>
        <translation>Um wie viel der Körper tiefer oder weniger tief eintauchen darf.</translation>
    </message>
    <message>
        <source>By how much of its speed the dip may be faster or slower.</source>
        <translation>Um welchen Teil seiner Geschwindigkeit der Tauchvorgang schneller oder langsamer sein darf.</translation>
    </message>
    <message>
        <source>By how much of it the film&apos;s relaxation time may be longer or shorter.</source>
        <translation>Um welchen Teil die Relaxationszeit des Films länger oder kürzer sein darf.</translation>
    </message>
    <message>
        <source>Of the zones</source>
        <translation>Der Zonen</translation>
    </message>
    <message>
        <source>How far colours may land off their places, to either side. What is not marked on the body is zone C.</source>
        <translation>Wie weit Farben neben ihrem Ort landen dürfen, nach beiden Seiten. Was auf dem Körper nicht markiert ist, ist Zone C.</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>Dips</source>
        <translation>Tauchvorgänge</translation>
    </message>
    <message>
        <source>Dips with everything off at once, to see whether what each does by itself can be added up. 0: none.</source>
        <translation>Tauchvorgänge, in denen alles zugleich abweicht, um zu sehen, ob sich die einzelnen Wirkungen addieren lassen. 0: keine.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>What is off by how much in them. Another number draws others.</source>
        <translation>Was darin um wie viel abweicht. Eine andere Zahl zieht andere.</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Korrektur</translation>
    </message>
    <message>
        <source>By what repeats</source>
        <translation>Um das Wiederkehrende</translation>
    </message>
    <message>
        <source>Takes off the sheet what the parts that the job keeps are off again and again.</source>
        <translation>Nimmt vom Bogen, was an den Teilen, die der Auftrag behält, immer wieder daneben liegt.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>How much of it is taken off.</source>
        <translation>Wie viel davon abgezogen wird.</translation>
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
        <source>Join</source>
        <translation>Fuge</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Bogen</translation>
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
        <source>Spot inks</source>
        <translation>Sonderfarben</translation>
    </message>
    <message>
        <source>Cut line</source>
        <translation>Schnittlinie</translation>
    </message>
    <message>
        <source>A line for the cutter, as a spot ink in a PDF in CMYK.</source>
        <translation>Eine Linie für den Schneideplotter, als Sonderfarbe in einem PDF in CMYK.</translation>
    </message>
    <message>
        <source>Round the ink</source>
        <translation>Um die Farbe herum</translation>
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
        <source>Of the cut line from the ink.</source>
        <translation>Der Schnittlinie von der Farbe.</translation>
    </message>
    <message>
        <source>Its ink</source>
        <translation>Ihre Farbe</translation>
    </message>
    <message>
        <source>The name by which the cutter knows the line.</source>
        <translation>Der Name, unter dem der Schneideplotter die Linie kennt.</translation>
    </message>
    <message>
        <source>Part&apos;s colour</source>
        <translation>Farbe des Teils</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>A plate of white under all colour. What is printed last touches the part; printed first, it lies on the outside, over the colour. In PDF and TIFF in CMYK.</source>
        <translation>Eine weiße Platte unter aller Farbe. Was zuletzt gedruckt wird, berührt das Teil; zuerst gedruckt liegt es außen, über der Farbe. In PDF und TIFF in CMYK.</translation>
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
        <source>Share of full tint that the part is to have; more is printed where the film stretches, as far as full tint goes.</source>
        <translation>Anteil des vollen Tons, den das Teil haben soll; gedruckt wird mehr, wo der Film sich dehnt, soweit der volle Ton reicht.</translation>
    </message>
    <message>
        <source>Choke</source>
        <translation>Unterfüllung</translation>
    </message>
    <message>
        <source>How much smaller than the colour the white is, all round, on the film.</source>
        <translation>Um wie viel das Weiß ringsum kleiner ist als die Farbe, auf dem Film.</translation>
    </message>
    <message>
        <source>Name of white</source>
        <translation>Name des Weiß</translation>
    </message>
    <message>
        <source>The name by which the printer knows its white ink.</source>
        <translation>Der Name, unter dem der Drucker seine weiße Farbe kennt.</translation>
    </message>
    <message>
        <source>Of the bare part, as #1a2b3c: proof and view show the ink on it. Empty: light grey, and ink as it looks on white.</source>
        <translation>Des unbedruckten Teils, wie #1a2b3c: Vorschau und Ansicht zeigen die Farbe darauf. Leer: hellgrau, und Farbe, wie sie auf Weiß aussieht.</translation>
    </message>
    <message>
        <source>Bleed past it</source>
        <translation>Beschnittzugabe</translation>
    </message>
    <message>
        <source>How far beyond the cut line the colours of the painted film&apos;s edge go on, so that a cut that slips shows no bare film.</source>
        <translation>Wie weit die Farben vom Rand des bemalten Films über die Schnittlinie hinaus weitergehen, damit ein verrutschter Schnitt keinen leeren Film zeigt.</translation>
    </message>
    <message>
        <source>Print it</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Check first</source>
        <translation>Erst prüfen</translation>
    </message>
    <message>
        <source>Do not print</source>
        <translation>Nicht drucken</translation>
    </message>
    <message>
        <source>Verdict: check first above</source>
        <translation>Urteil: erst prüfen oberhalb von</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Eingeschlossene Luft</translation>
    </message>
    <message>
        <source>The share of the body&apos;s surface that trapped air may keep dry. The verdict is “do not print” above five times a limit.</source>
        <translation>Der Anteil der Oberfläche des Körpers, den eingeschlossene Luft trocken halten darf. Über dem Fünffachen einer Grenze lautet das Urteil „Nicht drucken“.</translation>
    </message>
    <message>
        <source>Too pale</source>
        <translation>Zu blass</translation>
    </message>
    <message>
        <source>The share of the painted area that may look too pale, because the film stretches more than the ink can make up for.</source>
        <translation>Der Anteil der bemalten Fläche, der zu blass werden darf, weil der Film sich mehr dehnt, als die Farbe ausgleichen kann.</translation>
    </message>
    <message>
        <source>Torn or released film</source>
        <translation>Gerissener oder losgelassener Film</translation>
    </message>
    <message>
        <source>The share of the painted area on which the film may tear or be pulled off the body.</source>
        <translation>Der Anteil der bemalten Fläche, auf dem der Film reißen oder vom Körper abgezogen werden darf.</translation>
    </message>
    <message>
        <source>Reached by neither dip</source>
        <translation>Von keinem Tauchvorgang erreicht</translation>
    </message>
    <message>
        <source>The share of the body&apos;s surface that neither of two dips may reach. A job of one dip has no such limit.</source>
        <translation>Der Anteil der Oberfläche des Körpers, den keiner von zwei Tauchvorgängen erreichen muss. Ein Auftrag mit einem Tauchvorgang hat keine solche Grenze.</translation>
    </message>
    <message>
        <source>Narrow overlap</source>
        <translation>Schmale Überlappung</translation>
    </message>
    <message>
        <source>The share of the overlap of two dips that may be too narrow for how far the second film may lie off.</source>
        <translation>Der Anteil der Überlappung zweier Tauchvorgänge, der zu schmal dafür sein darf, wie weit der zweite Film daneben liegen kann.</translation>
    </message>
    <message>
        <source>Bare in a zone</source>
        <translation>Frei in einer Zone</translation>
    </message>
    <message>
        <source>The share of zone A or B, where they are marked, that may stay without paint.</source>
        <translation>Der Anteil von Zone A oder B, wo sie markiert sind, der ohne Farbe bleiben darf.</translation>
    </message>
    <message>
        <source>Film&apos;s edge</source>
        <translation>Rand des Films</translation>
    </message>
    <message>
        <source>How far the painted film has to stay from the film&apos;s edge, so that it neither curls nor folds.</source>
        <translation>Wie weit der bemalende Film vom Rand des Films wegbleiben muss, damit er sich weder rollt noch faltet.</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>What a model of one plain colour, without artwork, comes to.</source>
        <translation>Was ein Modell von einer einzigen Farbe, ohne Gestaltung, ergibt.</translation>
    </message>
    <message>
        <source>Repaired model</source>
        <translation>Berichtigtes Modell</translation>
    </message>
    <message>
        <source>What a model comes to that was put right, or lacks something that its file names.</source>
        <translation>Was ein Modell ergibt, das berichtigt wurde oder dem etwas fehlt, das seine Datei nennt.</translation>
    </message>
    <message>
        <source>Film not measured</source>
        <translation>Film nicht gemessen</translation>
    </message>
    <message>
        <source>What a film comes to whose swell nobody has measured.</source>
        <translation>Was ein Film ergibt, dessen Quellung niemand gemessen hat.</translation>
    </message>
    <message>
        <source>Split the body between the dips</source>
        <translation>Den Körper auf die Tauchvorgänge aufteilen</translation>
    </message>
    <message>
        <source>Expected deviations (±)</source>
        <translation>Erwartete Abweichungen (±)</translation>
    </message>
</context>
<context>
    <name>ReportPanel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Body painted</source>
        <translation>Körper bemalt</translation>
    </message>
    <message>
        <source>Film points on the body</source>
        <translation>Filmpunkte auf dem Körper</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Stretch, mean and largest</source>
        <translation>Dehnung, Mittel und größte</translation>
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
        <source>Colour short of ink</source>
        <translation>Farbe ohne genug Tinte</translation>
    </message>
    <message>
        <source>Air trapped</source>
        <translation>Eingeschlossene Luft</translation>
    </message>
    <message>
        <source>Simulated in</source>
        <translation>Simuliert in</translation>
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
        <source>Steps without equilibrium</source>
        <translation>Schritte ohne Gleichgewicht</translation>
    </message>
    <message>
        <source>Texture read back, mean and 95 %</source>
        <translation>Textur zurückgelesen, Mittel und 95 %</translation>
    </message>
    <message>
        <source>Of that, by marked film</source>
        <translation>Davon durch markierten Film</translation>
    </message>
    <message>
        <source>Painted by %1 alone</source>
        <translation>Von %1 allein gefärbt</translation>
    </message>
    <message>
        <source>In the overlap, by both</source>
        <translation>In der Überlappung, von beiden</translation>
    </message>
    <message>
        <source>Reached by neither</source>
        <translation>Von keinem erreicht</translation>
    </message>
    <message>
        <source>Width of the overlap</source>
        <translation>Breite der Überlappung</translation>
    </message>
    <message>
        <source>Length of the join</source>
        <translation>Länge der Fuge</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Fuge</translation>
    </message>
    <message>
        <source>Smaller places not reached</source>
        <translation>Kleinere nicht erreichte Stellen</translation>
    </message>
    <message>
        <source>Not reached at %1</source>
        <translation>Nicht erreicht bei %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Overlap that is too narrow for %1 off</source>
        <translation>Überlappung, zu schmal für %1 daneben</translation>
    </message>
    <message>
        <source>Most of the film stays empty: %1, %2 × %3, is enough.</source>
        <translation>Das meiste vom Film bleibt leer: %1, %2 × %3, genügt.</translation>
    </message>
    <message>
        <source>Take this film</source>
        <translation>Diesen Film nehmen</translation>
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
        <source>The file is larger than %1 MB, more than what is asked for here takes; choose another one</source>
        <translation>Die Datei ist größer als %1 MB, mehr als das, wonach hier gefragt ist, braucht; wählen Sie eine andere</translation>
    </message>
</context>
<context>
    <name>SnapshotEdits</name>
    <message>
        <source>Take Snapshot “%1”</source>
        <translation>Schnappschuss „%1“ aufnehmen</translation>
    </message>
    <message>
        <source>Remove Snapshot “%1”</source>
        <translation>Schnappschuss „%1“ entfernen</translation>
    </message>
    <message>
        <source>Go Back to “%1”</source>
        <translation>Zu „%1“ zurückgehen</translation>
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
        <source>Its description is too large to be one</source>
        <translation>Seine Beschreibung ist zu groß, um eine zu sein</translation>
    </message>
    <message>
        <source>Its description is not valid JSON: %1</source>
        <translation>Seine Beschreibung ist kein gültiges JSON: %1</translation>
    </message>
    <message>
        <source>Its description is not one of a solver</source>
        <translation>Seine Beschreibung ist nicht die eines Lösers</translation>
    </message>
    <message>
        <source>Its id may hold only small letters, digits and hyphens</source>
        <translation>Seine Kennung darf nur Kleinbuchstaben, Ziffern und Bindestriche enthalten</translation>
    </message>
    <message>
        <source>Its module has to be a file beside its description</source>
        <translation>Sein Modul muss eine Datei neben seiner Beschreibung sein</translation>
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
        <translation>Sein Modul hat keinen Einsprung %1</translation>
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
        <translation>Hier kann kein Löser laufen; installieren Sie einen oder setzen Sie DIPWRIGHT_PLUGIN_PATH</translation>
    </message>
    <message>
        <source>There is no such solver; choose one of %1</source>
        <translation>Diesen Löser gibt es nicht; wählen Sie einen von %1</translation>
    </message>
    <message>
        <source>This solver cannot be used: %1</source>
        <translation>Dieser Löser kann nicht verwendet werden: %1</translation>
    </message>
    <message>
        <source>It was built for solver interface %1, and this program has %2; get it for this version of the program, or build it anew</source>
        <translation>Er wurde für die Löserschnittstelle %1 gebaut, und dieses Programm hat %2; besorgen Sie ihn für diese Version des Programms, oder bauen Sie ihn neu</translation>
    </message>
    <message>
        <source>Its module does not fit this program&apos;s solver interface %1, whatever its description says; build it anew</source>
        <translation>Sein Modul passt nicht zur Löserschnittstelle %1 dieses Programms, was auch immer seine Beschreibung sagt; bauen Sie es neu</translation>
    </message>
    <message>
        <source>It has crashed twice; replace it, or set DIPWRIGHT_RETRY_SOLVERS=1 to try it again</source>
        <translation>Er ist zweimal abgestürzt; ersetzen Sie ihn, oder setzen Sie DIPWRIGHT_RETRY_SOLVERS=1, um ihn wieder zu versuchen</translation>
    </message>
    <message>
        <source>Others can write to %1; take that right from them, or move the plugin</source>
        <translation>Andere können %1 schreiben; nehmen Sie ihnen das Recht, oder verschieben Sie das Plugin</translation>
    </message>
    <message>
        <source>It cannot run here and does not say why; ask whoever made it</source>
        <translation>Er kann hier nicht laufen und sagt nicht, warum; fragen Sie seinen Hersteller</translation>
    </message>
    <message>
        <source>The &quot;priority&quot; in its description has to be a whole number from -%1 to %1</source>
        <translation>„priority“ in seiner Beschreibung muss eine ganze Zahl von -%1 bis %1 sein</translation>
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
        <source>%1, better</source>
        <translation>%1, besser</translation>
    </message>
    <message>
        <source>%1, worse</source>
        <translation>%1, schlechter</translation>
    </message>
    <message>
        <source>Body painted altogether</source>
        <translation>Körper insgesamt bemalt</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Largest stretch of 95 % of the film on the body</source>
        <translation>Größte Dehnung von 95 % des Films am Körper</translation>
    </message>
    <message>
        <source>Area that is not certain</source>
        <translation>Fläche, die nicht sicher ist</translation>
    </message>
</context>
<context>
    <name>Tolerance</name>
    <message>
        <source>Body along X</source>
        <translation>Körper längs X</translation>
    </message>
    <message>
        <source>Body along Z</source>
        <translation>Körper längs Z</translation>
    </message>
    <message>
        <source>Body about X</source>
        <translation>Körper um X</translation>
    </message>
    <message>
        <source>Body about Y</source>
        <translation>Körper um Y</translation>
    </message>
    <message>
        <source>Body about Z</source>
        <translation>Körper um Z</translation>
    </message>
    <message>
        <source>Film along X</source>
        <translation>Film längs X</translation>
    </message>
    <message>
        <source>Film along Z</source>
        <translation>Film längs Z</translation>
    </message>
    <message>
        <source>Film about Y</source>
        <translation>Film um Y</translation>
    </message>
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
        <source>Dipping off its place</source>
        <translation>Tauche mit Abweichungen</translation>
    </message>
    <message>
        <source>A film that lies off its place does not follow the body; give the film smaller cells or more points</source>
        <translation>Ein Film, der neben seinem Ort liegt, folgt dem Körper nicht; geben Sie dem Film kleinere Zellen oder mehr Punkte</translation>
    </message>
    <message>
        <source>%1 dips with everything off at once come to ±%2 in place of ±%3.</source>
        <translation>%1 Tauchvorgänge, in denen alles zugleich abweicht, ergeben ±%2 statt ±%3.</translation>
    </message>
    <message>
        <source>%1 dips with everything off at once come to ±%2 in place of ±%3: what the contributors do cannot simply be added here.</source>
        <translation>%1 Tauchvorgänge, in denen alles zugleich abweicht, ergeben ±%2 statt ±%3: Die einzelnen Wirkungen lassen sich hier nicht einfach addieren.</translation>
    </message>
    <message>
        <source>Zone %1 is not painted.</source>
        <translation>Zone %1 wird nicht bemalt.</translation>
    </message>
    <message>
        <source>Zone %1 keeps its limit: %2 % of what is painted is within ±%3, 95 % within ±%4. Most of it comes from: %5.</source>
        <translation>Zone %1 hält ihre Grenze ein: %2 % des Bemalten liegen innerhalb von ±%3, 95 % innerhalb von ±%4. Das meiste kommt von: %5.</translation>
    </message>
    <message>
        <source>Zone %1 does not keep its limit: %2 % of what is painted is within ±%3, 95 % only within ±%4. Most of it comes from: %5.</source>
        <translation>Zone %1 hält ihre Grenze nicht ein: %2 % des Bemalten liegen innerhalb von ±%3, 95 % erst innerhalb von ±%4. Das meiste kommt von: %5.</translation>
    </message>
</context>
<context>
    <name>Traveller</name>
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
        <source>Traveller of %1, %2</source>
        <translation>Laufkarte von %1, %2</translation>
    </message>
    <message>
        <source>%1. %2, sheet %3</source>
        <translation>%1. %2, Bogen %3</translation>
    </message>
    <message>
        <source>Order: %1</source>
        <translation>Reihenfolge: %1</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Auftrag %1</translation>
    </message>
    <message>
        <source>Turned about X %1°, then Y %2°, then Z %3°. Its middle %4 mm to the right of the film&apos;s middle and %5 mm towards the film&apos;s lower edge. Solid blue: the water when the dip begins; dashed: when it ends.</source>
        <translation>Gedreht um X %1°, dann Y %2°, dann Z %3°. Seine Mitte %4 mm rechts von der Mitte des Films und %5 mm zu seiner unteren Kante hin. Blau durchgezogen: das Wasser, wenn das Tauchen beginnt; gestrichelt: wenn es endet.</translation>
    </message>
    <message>
        <source>No cradle was made for this job; hold the body as drawn.</source>
        <translation>Für diesen Auftrag wurde keine Halterung gemacht; halten Sie den Körper wie gezeichnet.</translation>
    </message>
    <message>
        <source>Cradle %1: its plate shows the same number and job; its arrow points to the film&apos;s upper edge.</source>
        <translation>Halterung %1: Ihre Platte zeigt dieselbe Nummer und denselben Auftrag; ihr Pfeil zeigt zur oberen Kante des Films.</translation>
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
        <source>From above, ink side up. Crosses: the sheet&apos;s marks as they float; red: the datum pins, at %1 / %2 / %3 mm from the film&apos;s middle (to the right; down); dashed: the body.</source>
        <translation>Von oben, Farbseite oben. Kreuze: die Marken des Bogens, wie sie schwimmen; rot: die Passstifte, bei %1 / %2 / %3 mm von der Mitte des Films (nach rechts; nach unten); gestrichelt: der Körper.</translation>
    </message>
    <message>
        <source>Dotted: the tank&apos;s marks, %1 × %2 mm apart; the film lies in their middle.</source>
        <translation>Gepunktet: die Marken des Beckens, %1 × %2 mm voneinander; der Film liegt in ihrer Mitte.</translation>
    </message>
    <message>
        <source>The tank&apos;s marks are not given.</source>
        <translation>Die Marken des Beckens sind nicht angegeben.</translation>
    </message>
    <message>
        <source>Film %1 × %2 mm, swell %3 × %4.</source>
        <translation>Film %1 × %2 mm, Quellung %3 × %4.</translation>
    </message>
    <message>
        <source>No film profile is given.</source>
        <translation>Kein Filmprofil ist angegeben.</translation>
    </message>
    <message>
        <source>%1, lot %2, good until %3.</source>
        <translation>%1, Charge %2, haltbar bis %3.</translation>
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
        <source>as the film maker says (no time given)</source>
        <translation>wie der Hersteller des Films angibt (keine Zeit angegeben)</translation>
    </message>
    <message>
        <source>Lay sheet %1 on the water, ink side up; its upper edge lies where the arrow of the plate points.</source>
        <translation>Bogen %1 auf das Wasser legen, Farbseite oben; seine obere Kante liegt dort, wohin der Pfeil der Platte zeigt.</translation>
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
        <source>Dip from %1 mm above the water to %2 mm below it, at %3 mm/s: %4 s</source>
        <translation>Von %1 mm über dem Wasser bis %2 mm darunter tauchen, mit %3 mm/s: %4 s</translation>
    </message>
    <message>
        <source>Hold under water for %1 s, clear the film around the part, lift it out at %2 mm/s</source>
        <translation>%1 s unter Wasser halten, den Film um das Teil entfernen, mit %2 mm/s herausheben</translation>
    </message>
    <message>
        <source>Let it flash off before rinsing: %1</source>
        <translation>Vor dem Abspülen ablüften lassen: %1</translation>
    </message>
    <message>
        <source>Rinse and dry: %1</source>
        <translation>Abspülen und trocknen: %1</translation>
    </message>
    <message>
        <source>Compare the part with the picture before dip %1: colour in its place, no tear, no fold, dry where the next cradle holds it</source>
        <translation>Vor Tauchvorgang %1 das Teil mit dem Bild vergleichen: Farbe an ihrem Platz, kein Riss, keine Falte, trocken, wo die nächste Halterung es hält</translation>
    </message>
    <message>
        <source>Compare the part with the picture</source>
        <translation>Das Teil mit dem Bild vergleichen</translation>
    </message>
    <message>
        <source>After dip %1 the part should look like this: seen from the film&apos;s lower edge, from its right edge, and from below</source>
        <translation>Nach Tauchvorgang %1 soll das Teil so aussehen: von der unteren Kante des Films, von der rechten Kante und von unten gesehen</translation>
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
</context>
<context>
    <name>Verdict</name>
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
        <source>No place is painted both by this dip and by coarser ones.</source>
        <translation>Keine Stelle wird sowohl von diesem Tauchvorgang als auch von gröberen bemalt.</translation>
    </message>
    <message>
        <source>95 % of the sheet is within %1 (numerical error).</source>
        <translation>95 % des Bogens liegen innerhalb von %1 (numerischer Fehler).</translation>
    </message>
    <message>
        <source>Numerical error: 95 % of the painted area is within %1; the limit is %2. Set Film &gt; Cells to %3, turn the body, or dip it twice.</source>
        <translation>Numerischer Fehler: 95 % der bemalten Fläche liegen innerhalb von %1; die Grenze ist %2. Setzen Sie Film &gt; Zellen auf %3, drehen Sie den Körper oder tauchen Sie ihn zweimal.</translation>
    </message>
    <message>
        <source>Numerical error: 95 % of the painted area is within %1; the limit is %2. Set more points (Film &gt; Points), turn the body, or dip it twice.</source>
        <translation>Numerischer Fehler: 95 % der bemalten Fläche liegen innerhalb von %1; die Grenze ist %2. Setzen Sie mehr Punkte (Film &gt; Punkte), drehen Sie den Körper oder tauchen Sie ihn zweimal.</translation>
    </message>
    <message>
        <source>Numerical error: 95 % of the painted area is within %1; the limit is %2. Turn the body, dip it twice, or set much smaller cells or more points (Film &gt; Cells).</source>
        <translation>Numerischer Fehler: 95 % der bemalten Fläche liegen innerhalb von %1; die Grenze ist %2. Drehen Sie den Körper, tauchen Sie ihn zweimal oder setzen Sie viel kleinere Zellen oder mehr Punkte (Film &gt; Zellen).</translation>
    </message>
    <message>
        <source>Numerical error: 95 % of the painted area is within %1; the limit is %2. Most of it comes from the steps: set a smaller Dipping &gt; Step.</source>
        <translation>Numerischer Fehler: 95 % der bemalten Fläche liegen innerhalb von %1; die Grenze ist %2. Das meiste davon kommt von den Schritten: Setzen Sie Tauchen &gt; Schritt kleiner.</translation>
    </message>
    <message>
        <source>Numerical error: %1 % of the painted area may be off by more than %2. Check the places in the list.</source>
        <translation>Numerischer Fehler: %1 % der bemalten Fläche können um mehr als %2 daneben liegen. Prüfen Sie die Stellen in der Liste.</translation>
    </message>
    <message>
        <source>The border of the paint is uncertain: only finer or only coarser dips paint %1 % of the body. Set smaller cells (Film &gt; Cells).</source>
        <translation>Der Rand der Farbe ist unsicher: %1 % des Körpers bemalen nur feinere oder nur gröbere Tauchvorgänge. Setzen Sie kleinere Zellen (Film &gt; Zellen).</translation>
    </message>
    <message>
        <source>%1 steps of the dip did not reach equilibrium; up to %2 % of the elastic force remained. Set smaller cells (Film &gt; Cells).</source>
        <translation>%1 Schritte des Tauchvorgangs erreichten kein Gleichgewicht; bis zu %2 % der elastischen Kraft blieben übrig. Setzen Sie kleinere Zellen (Film &gt; Zellen).</translation>
    </message>
    <message>
        <source>The film paints nothing of the body. Check the model&apos;s unit, its place over the film, and the depth of the dip.</source>
        <translation>Der Film bemalt nichts vom Körper. Prüfen Sie die Einheit des Modells, seinen Platz über dem Film und die Tauchtiefe.</translation>
    </message>
    <message>
        <source>Trapped air keeps %1 % of the body dry; the limit is %2 %. Turn the body so that the air escapes, or drill a vent hole.</source>
        <translation>Eingeschlossene Luft hält %1 % des Körpers trocken; die Grenze ist %2 %. Drehen Sie den Körper so, dass die Luft entweicht, oder bohren Sie ein Entlüftungsloch.</translation>
    </message>
    <message>
        <source>%1 % of the painted area will be too pale; the limit is %2 %. The film stretches more than Ink &gt; Ink limit can compensate. Turn the body, or choose lighter colours.</source>
        <translation>%1 % der bemalten Fläche werden zu blass; die Grenze ist %2 %. Der Film dehnt sich mehr, als Farbe &gt; Farbgrenze ausgleichen kann. Drehen Sie den Körper oder wählen Sie hellere Farben.</translation>
    </message>
    <message>
        <source>The film tore or was released on %1 % of the painted area; the limit is %2 %. Turn the body, or dip it twice.</source>
        <translation>Der Film riss oder löste sich auf %1 % der bemalten Fläche; die Grenze ist %2 %. Drehen Sie den Körper oder tauchen Sie ihn zweimal.</translation>
    </message>
    <message>
        <source>The painted film comes within %1 of the film&apos;s edge; at least %2 are required. Use a larger film, or move the body to the film&apos;s centre.</source>
        <translation>Der bemalende Film kommt dem Rand des Films auf %1 nahe; mindestens %2 sind nötig. Nehmen Sie einen größeren Film oder rücken Sie den Körper in die Mitte des Films.</translation>
    </message>
    <message>
        <source>Neither dip reaches %1 % of the body; the limit is %2 %. Turn one of the poses.</source>
        <translation>Kein Tauchvorgang erreicht %1 % des Körpers; die Grenze ist %2 %. Drehen Sie eine der Lagen.</translation>
    </message>
    <message>
        <source>%1 % of the overlap is too narrow; the limit is %2 %. The second film shows there if it is misplaced. Widen Join &gt; Overlap, or turn one of the poses.</source>
        <translation>%1 % der Überlappung sind zu schmal; die Grenze ist %2 %. Dort ist der zweite Film zu sehen, wenn er versetzt liegt. Verbreitern Sie Fuge &gt; Überlappung oder drehen Sie eine der Lagen.</translation>
    </message>
    <message>
        <source>%1 % is not painted; the limit is %2 %. Turn the body so that film reaches it.</source>
        <translation>%1 % sind nicht bemalt; die Grenze ist %2 %. Drehen Sie den Körper so, dass Film dorthin kommt.</translation>
    </message>
    <message>
        <source>Handling and numerical error together: 95 % of the painted area is within ±%1; the limit is ±%2. Tighten the largest contributor, or turn the body.</source>
        <translation>Handhabung und numerischer Fehler zusammen: 95 % der bemalten Fläche liegen innerhalb von ±%1; die Grenze ist ±%2. Verringern Sie den größten Beitrag oder drehen Sie den Körper.</translation>
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
        <translation>Erst diese Stellen prüfen</translation>
    </message>
    <message>
        <source>%1 may be off by more than %2, at most by %3</source>
        <translation>%1 können um mehr als %2 daneben liegen, höchstens um %3</translation>
    </message>
</context>
<context>
    <name>ZoneAppearance</name>
    <message>
        <source>Zone %1, ±%2 mm</source>
        <translation>Zone %1, ±%2 mm</translation>
    </message>
    <message>
        <source>Pale: far within the limit</source>
        <translation>Blass: weit innerhalb der Grenze</translation>
    </message>
    <message>
        <source>Past the limit</source>
        <translation>Über der Grenze</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Nicht bemalt</translation>
    </message>
</context>
<context>
    <name>dipwright::Artwork</name>
    <message>
        <source>The artwork has %1 layers, as many as there may be; remove one</source>
        <translation>Die Gestaltung hat %1 Ebenen, mehr dürfen es nicht sein; entfernen Sie eine</translation>
    </message>
    <message>
        <source>The text “%1” is to be set in %2, which this computer does not have, and is set in another; install that font or choose one that is here</source>
        <translation>Der Text „%1“ soll in %2 gesetzt werden, die es auf diesem Rechner nicht gibt, und steht in einer anderen Schrift; installieren Sie die Schrift oder wählen Sie eine vorhandene</translation>
    </message>
    <message>
        <source>The picture of the layer “%1”</source>
        <translation>Das Bild der Ebene „%1“</translation>
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
        <source>Change Layer</source>
        <translation>Ebene ändern</translation>
    </message>
    <message>
        <source>Base Colour</source>
        <translation>Grundfarbe</translation>
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
        <source>Add Picture</source>
        <translation>Bild hinzufügen</translation>
    </message>
    <message>
        <source>Move Layer</source>
        <translation>Ebene verschieben</translation>
    </message>
    <message>
        <source>Remove Layer</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>Turn Layer</source>
        <translation>Ebene drehen</translation>
    </message>
    <message>
        <source>Size of Layer</source>
        <translation>Größe der Ebene</translation>
    </message>
</context>
<context>
    <name>dipwright::ArtworkPage</name>
    <message>
        <source>Add &amp;Picture…</source>
        <translation>&amp;Bild hinzufügen …</translation>
    </message>
    <message>
        <source>Lays a picture on the body. A picture dropped on the body in the view is laid where it was dropped.</source>
        <translation>Legt ein Bild auf den Körper. Ein Bild, das in der Ansicht auf dem Körper fallen gelassen wird, liegt dort.</translation>
    </message>
    <message>
        <source>Add &amp;Text</source>
        <translation>&amp;Text hinzufügen</translation>
    </message>
    <message>
        <source>Add Pa&amp;ttern</source>
        <translation>&amp;Muster hinzufügen</translation>
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
        <source>Layers, the uppermost first</source>
        <translation>Ebenen, die oberste zuerst</translation>
    </message>
    <message>
        <source>The layers, the uppermost first. The tick shows or hides one, a double click renames it; Delete removes it, Ctrl with the arrows moves it.</source>
        <translation>Die Ebenen, die oberste zuerst. Das Häkchen blendet eine ein oder aus, ein Doppelklick benennt sie um; Entf entfernt sie, Strg mit den Pfeilen verschiebt sie.</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Lays the layer over the next one (Ctrl+Up)</source>
        <translation>Legt die Ebene über die nächste (Strg+Auf)</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Lays the layer under the next one (Ctrl+Down)</source>
        <translation>Legt die Ebene unter die nächste (Strg+Ab)</translation>
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
        <source>What lies below all layers; white is no ink. Without it the model shows what it looks like by itself.</source>
        <translation>Was unter allen Ebenen liegt; Weiß ist keine Druckfarbe. Ohne sie zeigt das Modell sein eigenes Aussehen.</translation>
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
        <source>Each number makes another pattern of the same kind.</source>
        <translation>Jede Zahl ergibt ein anderes Muster derselben Art.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>100 %: hides what lies below it.</source>
        <translation>100 %: verdeckt, was darunter liegt.</translation>
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
        <source>Laid on</source>
        <translation>Aufgelegt</translation>
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
        <source>Round an axis</source>
        <translation>Um eine Achse</translation>
    </message>
    <message>
        <source>From six sides</source>
        <translation>Von sechs Seiten</translation>
    </message>
    <message>
        <source>A decal keeps lengths and straight lines round its middle. The others are for patterns over all of the body.</source>
        <translation>Ein Abziehbild erhält Längen und gerade Linien um seine Mitte. Die anderen sind für Muster über den ganzen Körper.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>What is shown fits in, its proportions kept.</source>
        <translation>Was gezeigt wird, passt hinein; seine Proportionen bleiben.</translation>
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
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Counterclockwise as seen from outside.</source>
        <translation>Gegen den Uhrzeigersinn, von außen gesehen.</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Repeated every</source>
        <translation>Wiederholt alle</translation>
    </message>
    <message>
        <source>The width of one repeat on the body; round an axis a whole number of them is laid.</source>
        <translation>Die Breite einer Wiederholung auf dem Körper; um eine Achse geht eine ganze Zahl davon.</translation>
    </message>
    <message>
        <source>once</source>
        <translation>einmal</translation>
    </message>
    <message>
        <source>Middle, X</source>
        <translation>Mitte, X</translation>
    </message>
    <message>
        <source>Middle, Y</source>
        <translation>Mitte, Y</translation>
    </message>
    <message>
        <source>Middle, Z</source>
        <translation>Mitte, Z</translation>
    </message>
    <message>
        <source>In the model&apos;s coordinates; of a decal the nearest place of the body counts.</source>
        <translation>In Koordinaten des Modells; bei einem Abziehbild zählt die nächste Stelle des Körpers.</translation>
    </message>
    <message>
        <source>the model&apos;s own</source>
        <translation>die des Modells</translation>
    </message>
    <message>
        <source>Spot ink</source>
        <translation>Sonderfarbe</translation>
    </message>
    <message>
        <source>printed in its colours</source>
        <translation>in ihren Farben gedruckt</translation>
    </message>
    <message>
        <source>The name of a varnish or of an ink of its own, as the printer knows it. The layer is then a plate beside the four inks, in PDF and TIFF in CMYK; what it covers counts, and not its colours.</source>
        <translation>Der Name eines Lacks oder einer eigenen Druckfarbe, wie der Drucker sie kennt. Die Ebene ist dann eine Platte neben den vier Farben, in PDF und TIFF in CMYK; es zählt, was sie deckt, nicht ihre Farben.</translation>
    </message>
    <message>
        <source>Looks like</source>
        <translation>Sieht aus wie</translation>
    </message>
    <message>
        <source>What stands for the ink where nobody knows its name.</source>
        <translation>Was für die Farbe steht, wo niemand ihren Namen kennt.</translation>
    </message>
    <message>
        <source>Outside the colours</source>
        <translation>Außen auf den Farben</translation>
    </message>
    <message>
        <source>Printed before the four inks, so that it ends up outside them, as a varnish does; else after them, towards the part.</source>
        <translation>Vor den vier Farben gedruckt, sodass sie am Ende außen liegt, wie ein Lack; sonst nach ihnen, zum Teil hin.</translation>
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
        <source>Turn Body</source>
        <translation>Körper drehen</translation>
    </message>
    <message>
        <source>Turned by %1° about %2; with Shift by steps of %3°</source>
        <translation>Um %1° um %2 gedreht; mit der Umschalttaste in Schritten von %3°</translation>
    </message>
    <message>
        <source>Change Depth</source>
        <translation>Tiefe ändern</translation>
    </message>
    <message>
        <source>Dipped %1 deep; with Shift by steps of %2</source>
        <translation>%1 tief getaucht; mit der Umschalttaste in Schritten von %2</translation>
    </message>
    <message>
        <source>Move Body</source>
        <translation>Körper verschieben</translation>
    </message>
    <message>
        <source>Moved to %1 along %2; with Shift by steps of %3</source>
        <translation>Auf %1 längs %2 verschoben; mit der Umschalttaste in Schritten von %3</translation>
    </message>
</context>
<context>
    <name>dipwright::BodyMenu</name>
    <message>
        <source>&amp;Lay This Face Down</source>
        <translation>Diese Fläche nach &amp;unten legen</translation>
    </message>
    <message>
        <source>This Face Must Be &amp;Good (Zone A)</source>
        <translation>Diese Fläche muss &amp;gut werden (Zone A)</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Drehen</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Verschieben</translation>
    </message>
    <message>
        <source>Turn Body</source>
        <translation>Körper drehen</translation>
    </message>
    <message>
        <source>Move Body</source>
        <translation>Körper verschieben</translation>
    </message>
    <message>
        <source>Lay Face Down</source>
        <translation>Fläche nach unten legen</translation>
    </message>
</context>
<context>
    <name>dipwright::FinishedPartPreview</name>
    <message>
        <source>Printing the body</source>
        <translation>Bedrucke den Körper</translation>
    </message>
</context>
<context>
    <name>dipwright::BodyShare</name>
    <message>
        <source>Sharing out the body</source>
        <translation>Der Körper wird aufgeteilt</translation>
    </message>
</context>
<context>
    <name>dipwright::Budgets</name>
    <message>
        <source>The file is larger than %1 MB; reduce it</source>
        <translation>Die Datei ist größer als %1 MB; verkleinern Sie sie</translation>
    </message>
    <message>
        <source>The model names more than %1 other files; reduce it</source>
        <translation>Das Modell nennt mehr als %1 andere Dateien; verkleinern Sie es</translation>
    </message>
    <message>
        <source>The model has more than %1 million triangles, too many for a file of its size or for any computer; reduce it</source>
        <translation>Das Modell hat mehr als %1 Millionen Dreiecke, zu viele für eine Datei dieser Größe oder für jeden Rechner; verkleinern Sie es</translation>
    </message>
    <message>
        <source>A face of the model has more than %1 corners; cut it into triangles in a modelling program</source>
        <translation>Eine Fläche des Modells hat mehr als %1 Ecken; zerlegen Sie sie in einem Modellierprogramm in Dreiecke</translation>
    </message>
    <message>
        <source>The model cannot be read: its parts hold one another more than %1 deep; join them in a modelling program</source>
        <translation>Das Modell kann nicht gelesen werden: Seine Teile enthalten einander mehr als %1-fach; verbinden Sie sie in einem Modellierprogramm</translation>
    </message>
    <message>
        <source>The model has more than %1 materials; reduce them</source>
        <translation>Das Modell hat mehr als %1 Materialien; verringern Sie ihre Zahl</translation>
    </message>
    <message>
        <source>The file would unpack to more than %1 MB, more than any of its size needs, and is not opened; ask whoever made it for another</source>
        <translation>Die Datei ergäbe entpackt mehr als %1 MB, mehr als jede von ihrer Größe braucht, und wird nicht geöffnet; bitten Sie um eine andere</translation>
    </message>
    <message>
        <source>The file holds more entries than %1 and is not opened; ask whoever made it for another</source>
        <translation>Die Datei enthält mehr Einträge als %1 und wird nicht geöffnet; bitten Sie um eine andere</translation>
    </message>
    <message>
        <source>project.json is larger than %1 MB and is not read; ask whoever made the project for another</source>
        <translation>project.json ist größer als %1 MB und wird nicht gelesen; bitten Sie um ein anderes Projekt</translation>
    </message>
    <message>
        <source>The project holds more than %1 MB that is not its own; take that out with an archive program</source>
        <translation>Das Projekt enthält mehr als %1 MB, die nicht zu ihm gehören; entfernen Sie diese mit einem Archivprogramm</translation>
    </message>
    <message>
        <source>The texture has more than %1 pixels a side; make it smaller</source>
        <translation>Die Textur hat mehr als %1 Pixel je Seite; verkleinern Sie sie</translation>
    </message>
    <message>
        <source>The pictures have more than %1 million pixels together, too many for files of their size or for any sheet; make them smaller</source>
        <translation>Die Bilder haben zusammen mehr als %1 Millionen Pixel, zu viele für Dateien ihrer Größe oder für jeden Bogen; verkleinern Sie sie</translation>
    </message>
    <message>
        <source>Reading the file takes more than %1 MB of memory, more than any of its size needs; reduce it or save it anew</source>
        <translation>Die Datei zu lesen braucht mehr als %1 MB Speicher, mehr als jede von ihrer Größe braucht; verkleinern Sie sie oder speichern Sie sie neu</translation>
    </message>
    <message>
        <source>Reading the file takes more than %1 seconds, more than any of its size needs; reduce it or save it anew</source>
        <translation>Die Datei zu lesen dauert länger als %1 Sekunden, länger als jede von ihrer Größe braucht; verkleinern Sie sie oder speichern Sie sie neu</translation>
    </message>
    <message>
        <source>The file&apos;s values hold one another more than %1 deep and it is not read; ask whoever made it for another</source>
        <translation>Die Werte der Datei enthalten einander mehr als %1 tief, und sie wird nicht gelesen; bitten Sie, wer sie gemacht hat, um eine andere</translation>
    </message>
    <message>
        <source>The file holds more than %1 million values and is not read; ask whoever made it for another</source>
        <translation>Die Datei enthält mehr als %1 Millionen Werte und wird nicht gelesen; bitten Sie, wer sie gemacht hat, um eine andere</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltController</name>
    <message>
        <source>Looking for what repeats</source>
        <translation>Wiederkehrendes wird gesucht</translation>
    </message>
    <message>
        <source>As Built</source>
        <translation>Wie gebaut</translation>
    </message>
    <message>
        <source>Measuring the part on the sheet</source>
        <translation>Teil wird auf dem Bogen gemessen</translation>
    </message>
    <message>
        <source>Keep Part</source>
        <translation>Teil behalten</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltPage</name>
    <message>
        <source>&amp;Correct the next sheets</source>
        <translation>Nächste Bögen &amp;korrigieren</translation>
    </message>
    <message>
        <source>What repeats, and the correction</source>
        <translation>Was sich wiederholt, und die Korrektur</translation>
    </message>
    <message>
        <source>Parts that the job keeps</source>
        <translation>Teile, die der Auftrag behält</translation>
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
        <source>Off</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>On the sheet, root mean square</source>
        <translation>Auf dem Bogen, quadratisches Mittel</translation>
    </message>
    <message>
        <source>Who says that the part may count</source>
        <translation>Wer sagt, dass das Teil zählen darf</translation>
    </message>
    <message>
        <source>&amp;Keep Part</source>
        <translation>Teil &amp;behalten</translation>
    </message>
    <message>
        <source>Keeps with the job how far the print of the measured part is off</source>
        <translation>Behält beim Auftrag, wie weit der Druck des gemessenen Teils abweicht</translation>
    </message>
    <message>
        <source>Prints the next sheets so that what repeats does not come again</source>
        <translation>Druckt die nächsten Bögen so, dass nicht wiederkehrt, was sich wiederholt</translation>
    </message>
    <message>
        <source>Strength of the correction</source>
        <translation>Stärke der Korrektur</translation>
    </message>
    <message>
        <source>How much of what repeats is taken off the next sheets</source>
        <translation>Wie viel davon auf den nächsten Bögen ausgeglichen wird</translation>
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
        <source>The next sheets are corrected so.</source>
        <translation>So werden die nächsten Bögen korrigiert.</translation>
    </message>
    <message>
        <source>The next sheets are not corrected: this is what they would be.</source>
        <translation>Die nächsten Bögen werden nicht korrigiert: So wären sie es.</translation>
    </message>
    <message>
        <source>Keep the part that was measured: the job then has its photos, how far its print is off, and who accepted it.</source>
        <translation>Behalten Sie das gemessene Teil: Der Auftrag hat dann seine Fotos, die Abweichung des Drucks und wer es abgenommen hat.</translation>
    </message>
    <message>
        <source>To keep a part, find the corners of its print on the page “Dipped Part”, with pairs that are places of the body itself.</source>
        <translation>Um ein Teil zu behalten, suchen Sie die Ecken seines Drucks auf der Seite „Getauchtes Teil“, mit Paaren, die Stellen des Körpers selbst sind.</translation>
    </message>
    <message>
        <source>The repeating error of the parts is shown here.</source>
        <translation>Hier ist der wiederkehrende Fehler der Teile zu sehen.</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltPlaces</name>
    <message>
        <source>None of the places is seen on film that lies on the body; are the photos of this job?</source>
        <translation>Keine der Stellen ist auf Film zu sehen, der am Körper liegt; sind die Fotos von diesem Auftrag?</translation>
    </message>
    <message>
        <source>The job keeps %1 parts and %2 places at most, and would have more</source>
        <translation>Der Auftrag behält höchstens %1 Teile und %2 Stellen und hätte mehr</translation>
    </message>
    <message>
        <source>The job keeps the part of these photos already; the same part twice would count as two that agree</source>
        <translation>Der Auftrag behält das Teil dieser Fotos schon; dasselbe Teil zweimal würde als zwei zählen, die übereinstimmen</translation>
    </message>
</context>
<context>
    <name>dipwright::CalibrationDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Measure: the printer as it is</source>
        <translation>Messen: der Drucker, wie er ist</translation>
    </message>
    <message>
        <source>Verify: corrected by the profile</source>
        <translation>Prüfen: durch das Profil korrigiert</translation>
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
        <source>&amp;Print Page</source>
        <translation>Seite &amp;drucken</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Als PDF speichern …</translation>
    </message>
    <message>
        <source>&amp;Take over into Profile</source>
        <translation>Ins Profil &amp;übernehmen</translation>
    </message>
    <message>
        <source>Calibrate Printer</source>
        <translation>Drucker kalibrieren</translation>
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
        <source>The profile that the scale goes into. “Profiles” makes new ones.</source>
        <translation>Das Profil, in das der Maßstab kommt. Unter „Profile“ entstehen neue.</translation>
    </message>
    <message>
        <source>2. Measure its rulers</source>
        <translation>2. Lineale messen</translation>
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
        <source>No printer is set up on this machine. Save the page as PDF and print it elsewhere, at 100 %.</source>
        <translation>Auf diesem Rechner ist kein Drucker eingerichtet. Speichern Sie die Seite als PDF und drucken Sie sie woanders, mit 100 %.</translation>
    </message>
    <message>
        <source>instead of %1 mm</source>
        <translation>statt %1 mm</translation>
    </message>
    <message>
        <source>Print the page, measure both rulers from the first to the last line to a tenth of a millimetre, and type what they show. Then verify with the second page.</source>
        <translation>Drucken Sie die Seite, messen Sie beide Lineale vom ersten bis zum letzten Strich auf einen Zehntelmillimeter und geben Sie ein, was sie zeigen. Prüfen Sie danach mit der zweiten Seite.</translation>
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
        <source>Handed to the queue of %1</source>
        <translation>An die Warteschlange von %1 übergeben</translation>
    </message>
    <message>
        <source>Save Page</source>
        <translation>Seite speichern</translation>
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
        <source>%1 now has the scale X %2, Y %3. Print the second page to verify it.</source>
        <translation>%1 hat jetzt den Maßstab X %2, Y %3. Drucken Sie zum Prüfen die zweite Seite.</translation>
    </message>
    <message>
        <source>What the printed ruler measures, to a tenth of a millimetre.</source>
        <translation>Was das gedruckte Lineal misst, auf ein Zehntel Millimeter.</translation>
    </message>
    <message>
        <source>The printers that are set up on this machine.</source>
        <translation>Die Drucker, die auf diesem Rechner eingerichtet sind.</translation>
    </message>
    <message>
        <source>The paper that is in the printer.</source>
        <translation>Das Papier, das im Drucker liegt.</translation>
    </message>
    <message>
        <source>Rulers without correction, to be measured.</source>
        <translation>Lineale ohne Korrektur, zum Messen.</translation>
    </message>
    <message>
        <source>The same rulers corrected, which must now measure what they say.</source>
        <translation>Dieselben Lineale korrigiert: Sie müssen nun messen, was sie sagen.</translation>
    </message>
    <message>
        <source>None is set up</source>
        <translation>Keiner eingerichtet</translation>
    </message>
</context>
<context>
    <name>dipwright::CalibrationPage</name>
    <message>
        <source>The horizontal ruler must measure %1 mm and the vertical one %2 mm from the first to the last line.</source>
        <translation>Das waagrechte Lineal muss %1 mm messen, das senkrechte %2 mm, vom ersten bis zum letzten Strich.</translation>
    </message>
    <message>
        <source>If either is more than 0.2 mm off, measure and calibrate once more.</source>
        <translation>Weicht eines um mehr als 0,2 mm ab, messen und kalibrieren Sie noch einmal.</translation>
    </message>
    <message>
        <source>Type what they do measure, to a tenth of a millimetre, into the printer&apos;s profile.</source>
        <translation>Tragen Sie ein, was sie wirklich messen, auf ein Zehntel Millimeter, in das Profil des Druckers.</translation>
    </message>
    <message>
        <source>Corrected for X %1, Y %2</source>
        <translation>Korrigiert um X %1, Y %2</translation>
    </message>
    <message>
        <source>Not corrected: X 1, Y 1</source>
        <translation>Nicht korrigiert: X 1, Y 1</translation>
    </message>
    <message>
        <source>Verification of the printer&apos;s scale</source>
        <translation>Prüfung des Druckermaßstabs</translation>
    </message>
    <message>
        <source>Calibration of the printer&apos;s scale</source>
        <translation>Kalibrierung des Druckermaßstabs</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm is too small to calibrate a printer with; take A5 or larger</source>
        <translation>Papier von %1 × %2 mm ist zu klein, um einen Drucker zu kalibrieren; nehmen Sie A5 oder größer</translation>
    </message>
    <message>
        <source>The calibration page cannot be written: %1</source>
        <translation>Die Kalibrierseite kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>%1 mm in place of %2 mm is more than 10 % off; switch off all scaling in the printer&apos;s settings, print the page anew and measure again</source>
        <translation>%1 mm statt %2 mm ist mehr als 10 % daneben; schalten Sie alle Skalierung in den Einstellungen des Druckers ab, drucken Sie die Seite neu und messen Sie wieder</translation>
    </message>
</context>
<context>
    <name>dipwright::NumericalErrorCheck</name>
    <message>
        <source>Checking the certainty</source>
        <translation>Verlässlichkeit wird geprüft</translation>
    </message>
    <message>
        <source>Check Certainty</source>
        <translation>Verlässlichkeit prüfen</translation>
    </message>
</context>
<context>
    <name>dipwright::NumericalErrorDialog</name>
    <message>
        <source>How far the sheet moves</source>
        <translation>Wie weit sich der Bogen verschiebt</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>With steps half as long</source>
        <translation>Mit halb so langen Schritten</translation>
    </message>
    <message>
        <source>With film cells half as wide</source>
        <translation>Mit halb so breiten Filmzellen</translation>
    </message>
    <message>
        <source>Certainty of the sheet</source>
        <translation>Verlässlichkeit des Bogens</translation>
    </message>
    <message>
        <source>Certainty of the Sheets</source>
        <translation>Verlässlichkeit der Bögen</translation>
    </message>
    <message>
        <source>&amp;Save Maps…</source>
        <translation>Karten &amp;speichern …</translation>
    </message>
    <message>
        <source>Save Maps to a Folder</source>
        <translation>Karten in einem Ordner speichern</translation>
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
        <source>Painted twice</source>
        <translation>Beide malen</translation>
    </message>
    <message>
        <source>Painted once</source>
        <translation>Nur einer malt</translation>
    </message>
    <message>
        <source>The part of the body that is painted by both dips</source>
        <translation>Der Teil des Körpers, den beide Tauchvorgänge bemalen</translation>
    </message>
    <message>
        <source>The part of the body that is painted by one of the dips only</source>
        <translation>Der Teil des Körpers, den nur einer der Tauchvorgänge bemalt</translation>
    </message>
    <message>
        <source>%1: nothing is painted that could be compared.</source>
        <translation>%1: es wird nichts bemalt, das verglichen werden könnte.</translation>
    </message>
    <message>
        <source>%1: this sheet is certain. 95 % of it moves by %2 or less when it is computed more finely.</source>
        <translation>%1: dieser Bogen ist verlässlich. 95 % davon verschieben sich um %2 oder weniger, wenn feiner gerechnet wird.</translation>
    </message>
    <message>
        <source>These are the figures of the project as it was before the last changes.</source>
        <translation>Dies sind die Zahlen des Projekts, wie es vor den letzten Änderungen war.</translation>
    </message>
    <message>
        <source>%1: this sheet is not certain. 95 % of it moves by up to %2 when it is computed more finely; give the film smaller cells or more points, turn the body, or dip it in two immersions.</source>
        <translation>%1: dieser Bogen ist nicht verlässlich. 95 % davon verschieben sich um bis zu %2, wenn feiner gerechnet wird; geben Sie dem Film kleinere Zellen oder mehr Punkte, drehen Sie den Körper oder tauchen Sie ihn in zwei Tauchvorgängen.</translation>
    </message>
</context>
<context>
    <name>dipwright::VerdictPanel</name>
    <message>
        <source>Certainty of the sheet</source>
        <translation>Sicherheit des Bogens</translation>
    </message>
    <message>
        <source>Run the dip to see how far the sheet may be off.</source>
        <translation>Starten Sie den Tauchvorgang, um zu sehen, wie weit der Bogen daneben liegen kann.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
</context>
<context>
    <name>dipwright::CompareWindow</name>
    <message>
        <source>Side by Side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Was gezeigt wird</translation>
    </message>
    <message>
        <source>What both bodies wear: the film&apos;s lines, how far it is drawn out, or what is painted</source>
        <translation>Was beide Körper tragen: die Linien des Films, wie weit er gedehnt ist, oder was bemalt ist</translation>
    </message>
    <message>
        <source>Film on the body</source>
        <translation>Film am Körper</translation>
    </message>
    <message>
        <source>Stretch of the film</source>
        <translation>Dehnung des Films</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Bedeckung</translation>
    </message>
    <message>
        <source>Immersion</source>
        <translation>Tauchvorgang</translation>
    </message>
    <message>
        <source>The immersion that is looked at</source>
        <translation>Der Tauchvorgang, der betrachtet wird</translation>
    </message>
    <message>
        <source>Immersion %1</source>
        <translation>Tauchvorgang %1</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Show the bodies as large as can be</source>
        <translation>Die Körper so groß wie möglich zeigen</translation>
    </message>
    <message>
        <source>Figures of both</source>
        <translation>Zahlen von beiden</translation>
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
        <source>Back to the project; Escape does the same</source>
        <translation>Zurück zum Projekt; Escape tut dasselbe</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
</context>
<context>
    <name>dipwright::DeeperFilm</name>
    <message>
        <source>Dipping deeper</source>
        <translation>Tiefer getaucht</translation>
    </message>
    <message>
        <source>Deeper dip</source>
        <translation>Tieferer Tauchvorgang</translation>
    </message>
</context>
<context>
    <name>dipwright::DipCacheUpdater</name>
    <message>
        <source>Looking for results</source>
        <translation>Ergebnisse werden gesucht</translation>
    </message>
    <message>
        <source>The results are those of the dips kept beside the project.</source>
        <translation>Die Ergebnisse sind die der Tauchvorgänge, die neben dem Projekt aufbewahrt sind.</translation>
    </message>
</context>
<context>
    <name>dipwright::DipController</name>
    <message>
        <source>The Dip</source>
        <translation>Der Tauchvorgang</translation>
    </message>
    <message>
        <source>Simulated with %1 on %2</source>
        <translation>Simuliert mit %1 auf %2</translation>
    </message>
    <message>
        <source>The sheet is out of date: it was made before the last changes.</source>
        <translation>Der Bogen ist veraltet: Er entstand vor den letzten Änderungen.</translation>
    </message>
    <message>
        <source>The results are out of date: they were made before the last changes.</source>
        <translation>Die Ergebnisse sind veraltet: Sie entstanden vor den letzten Änderungen.</translation>
    </message>
    <message>
        <source>The results are out of date; run the dip again first.</source>
        <translation>Die Ergebnisse sind veraltet; starten Sie zuerst das Tauchen neu.</translation>
    </message>
    <message>
        <source>Film %1</source>
        <translation>Film %1</translation>
    </message>
</context>
<context>
    <name>dipwright::DipView</name>
    <message>
        <source>The 3D view needs OpenGL 3.2, and no such context could be made. Everything else works.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.2, und ein solcher Kontext ließ sich nicht anlegen. Alles andere geht.</translation>
    </message>
</context>
<context>
    <name>dipwright::DistanceField</name>
    <message>
        <source>The distance field&apos;s resolution is %1; choose 32 to 512</source>
        <translation>Die Auflösung des Abstandsfelds ist %1; wählen Sie 32 bis 512</translation>
    </message>
    <message>
        <source>The body has no extent; choose a model with a surface</source>
        <translation>Der Körper hat keine Ausdehnung; wählen Sie ein Modell mit einer Oberfläche</translation>
    </message>
    <message>
        <source>Building the distance field</source>
        <translation>Abstandsfeld wird gebaut</translation>
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
        <source>Open Project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Project in Use</source>
        <translation>Projekt in Benutzung</translation>
    </message>
    <message>
        <source>“%1” is open already, on %2 (process %3).</source>
        <translation>„%1“ ist schon geöffnet, auf %2 (Prozess %3).</translation>
    </message>
    <message>
        <source>an unknown machine</source>
        <translation>einem unbekannten Rechner</translation>
    </message>
    <message>
        <source>Open Anyway</source>
        <translation>Trotzdem öffnen</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to “%1” before it is closed?</source>
        <translation>Die Änderungen an „%1“ vor dem Schließen speichern?</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>%1 is a picture: open the project first that is to wear it</source>
        <translation>%1 ist ein Bild: Öffnen Sie zuerst das Projekt, das es tragen soll</translation>
    </message>
    <message>
        <source>%1 is neither a project, a model nor a picture</source>
        <translation>%1 ist weder ein Projekt noch ein Modell noch ein Bild</translation>
    </message>
    <message>
        <source>If both of you save, the second is asked whose work is to stay.</source>
        <translation>Speichern beide, so wird der zweite gefragt, wessen Arbeit bleiben soll.</translation>
    </message>
    <message>
        <source>Project Changed Elsewhere</source>
        <translation>Projekt anderswo geändert</translation>
    </message>
    <message>
        <source>Another program has written “%1” since it was opened here.</source>
        <translation>Ein anderes Programm hat „%1“ geschrieben, seit es hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>Save under another name to keep both. Overwriting loses what the other has done.</source>
        <translation>Speichern Sie unter einem anderen Namen, um beides zu behalten. Überschreiben verliert, was der andere getan hat.</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>Ü&amp;berschreiben</translation>
    </message>
</context>
<context>
    <name>dipwright::DocumentSession</name>
    <message>
        <source>Opening the project</source>
        <translation>Projekt wird geöffnet</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 geöffnet</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>Restoring the project</source>
        <translation>Projekt wird wiederhergestellt</translation>
    </message>
    <message>
        <source>Restore Project</source>
        <translation>Projekt wiederherstellen</translation>
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
        <source>Unsaved changes are not kept in case of a crash; save them often. %1</source>
        <translation>Ungespeicherte Änderungen werden für den Fall eines Absturzes nicht aufgehoben; speichern Sie oft. %1</translation>
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
        <source>Replace Model</source>
        <translation>Modell ersetzen</translation>
    </message>
    <message>
        <source>Replace Texture</source>
        <translation>Textur ersetzen</translation>
    </message>
</context>
<context>
    <name>dipwright::ExportController</name>
    <message>
        <source>Export Results to a Folder</source>
        <translation>Ergebnisse in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Export Results</source>
        <translation>Ergebnisse exportieren</translation>
    </message>
    <message>
        <source>Wrote the results to %1</source>
        <translation>Ergebnisse nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Save Sheet</source>
        <translation>Bogen speichern</translation>
    </message>
    <message>
        <source>Export Stretch</source>
        <translation>Dehnung exportieren</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>dehnung</translation>
    </message>
    <message>
        <source>These sheets were made before the last changes. Run the dip first to print what the project now says.</source>
        <translation>Diese Bögen entstanden vor den letzten Änderungen. Starten Sie zuerst den Tauchvorgang, um zu drucken, was im Projekt jetzt steht.</translation>
    </message>
    <message>
        <source>Save Maps</source>
        <translation>Karten speichern</translation>
    </message>
    <message>
        <source>Wrote the maps to %1</source>
        <translation>Karten nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Export Cradles</source>
        <translation>Halterungen exportieren</translation>
    </message>
    <message>
        <source>Export Cradles to a Folder</source>
        <translation>Halterungen in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Wrote the cradles to %1</source>
        <translation>Halterungen nach %1 geschrieben</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmFit</name>
    <message>
        <source>The fit does not come to rest in %1 rounds; look for places that were mistaken for others, or fit fewer quantities</source>
        <translation>Die Anpassung kommt in %1 Runden nicht zur Ruhe; suchen Sie nach verwechselten Stellen oder passen Sie weniger Größen an</translation>
    </message>
    <message>
        <source>Fitted</source>
        <translation>Angepasst</translation>
    </message>
    <message>
        <source>The pairs tell nothing of the film; give more of them, all round the body</source>
        <translation>Die Paare sagen nichts über den Film; geben Sie mehr davon an, rund um den Körper</translation>
    </message>
    <message>
        <source>None of the printed places lies on the body in the simulation; are they of this job&apos;s sheet?</source>
        <translation>Keine der gedruckten Stellen liegt in der Simulation auf dem Körper; sind sie vom Bogen dieses Auftrags?</translation>
    </message>
    <message>
        <source>%1, dip %2</source>
        <translation>%1, Tauchvorgang %2</translation>
    </message>
    <message>
        <source>%1 and %2 are told together rather than each by itself: correlation %3</source>
        <translation>%1 und %2 sind eher zusammen als jede für sich bestimmt: Korrelation %3</translation>
    </message>
    <message>
        <source>%1 is not told by these pairs and stays as it was</source>
        <translation>%1 ist durch diese Paare nicht bestimmt und bleibt, wie es war</translation>
    </message>
    <message>
        <source>The print was off by %1 px or %2 mm and is by %3 px or %4 mm with what was found (root mean square)</source>
        <translation>Der Druck lag %1 px oder %2 mm daneben und liegt mit dem Gefundenen %3 px oder %4 mm daneben (quadratisches Mittel)</translation>
    </message>
    <message>
        <source>give pairs of places all round the body</source>
        <translation>geben Sie Paare rund um den Körper an</translation>
    </message>
    <message>
        <source>photograph places near the body&apos;s lowest point and others high on its sides, from more than one direction</source>
        <translation>fotografieren Sie Stellen nahe dem tiefsten Punkt des Körpers und andere weit oben an seinen Seiten, aus mehr als einer Richtung</translation>
    </message>
    <message>
        <source>measure growth by photos of the floating film, “inspect film”</source>
        <translation>messen Sie das Wachstum durch Fotos des schwimmenden Films, „inspect film“</translation>
    </message>
    <message>
        <source>measure it at the tank and leave it out of the fit</source>
        <translation>messen Sie es am Becken und lassen Sie es aus der Anpassung</translation>
    </message>
    <message>
        <source>The project&apos;s film does not grow, and so its growth cannot be fitted; measure it by photos of the floating film, “inspect film”</source>
        <translation>Der Film des Projekts wächst nicht, also lässt sich sein Wachstum nicht anpassen; messen Sie es durch Fotos des schwimmenden Films, „inspect film“</translation>
    </message>
    <message>
        <source>%1 changes nothing of this film and cannot be fitted</source>
        <translation>%1 ändert an diesem Film nichts und lässt sich nicht anpassen</translation>
    </message>
    <message>
        <source>%1 moves none of the places, so that the pairs do not tell it; %2</source>
        <translation>%1 bewegt keine der Stellen, so dass die Paare es nicht bestimmen; %2</translation>
    </message>
    <message>
        <source>The pairs cannot tell %1 from the camera&apos;s place (correlation %2); %3</source>
        <translation>Die Paare können %1 nicht vom Platz der Kamera unterscheiden (Korrelation %2); %3</translation>
    </message>
    <message>
        <source>give more pairs of the body itself, farther apart</source>
        <translation>geben Sie mehr Paare des Körpers selbst an, weiter auseinander</translation>
    </message>
    <message>
        <source>give pairs of the body itself, its edges, corners or holes, with --pairs</source>
        <translation>geben Sie mit --pairs Paare des Körpers selbst an, seine Kanten, Ecken oder Löcher</translation>
    </message>
    <message>
        <source>The pairs cannot tell %1 from %2 (correlation %3); fit one of the two alone, or %4</source>
        <translation>Die Paare können %1 nicht von %2 unterscheiden (Korrelation %3); passen Sie nur eines von beiden an, oder %4</translation>
    </message>
    <message>
        <source>The pairs do not tell %1 well enough; give more of them, or %2</source>
        <translation>Die Paare bestimmen %1 nicht gut genug; geben Sie mehr davon an, oder %2</translation>
    </message>
    <message>
        <source>Body along X</source>
        <translation>Körper entlang X</translation>
    </message>
    <message>
        <source>Body along Z</source>
        <translation>Körper entlang Z</translation>
    </message>
    <message>
        <source>Body about Y</source>
        <translation>Körper um Y</translation>
    </message>
    <message>
        <source>Swell along X</source>
        <translation>Quellung entlang X</translation>
    </message>
    <message>
        <source>Swell along Y</source>
        <translation>Quellung entlang Y</translation>
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
        <source>“%1” is nothing that can be fitted; choose of %2</source>
        <translation>„%1“ lässt sich nicht anpassen; wählen Sie aus %2</translation>
    </message>
    <message>
        <source>There are fewer pairs on the body than tell %1 numbers of film and camera; give more, or fit fewer quantities</source>
        <translation>Es sind weniger Paare auf dem Körper, als %1 Zahlen von Film und Kamera bestimmen; geben Sie mehr an oder passen Sie weniger Größen an</translation>
    </message>
    <message>
        <source>No film and camera are found that fit the pairs; look for places that were mistaken for others</source>
        <translation>Es finden sich kein Film und keine Kamera, die zu den Paaren passen; suchen Sie nach verwechselten Stellen</translation>
    </message>
    <message>
        <source>A place is said to be of dip %1, and the project has %2</source>
        <translation>Eine Stelle soll von Tauchvorgang %1 sein, und das Projekt hat %2</translation>
    </message>
    <message>
        <source>%1: %2, was taken for %3; 95 %: %4</source>
        <translation>%1: %2, angenommen war %3; 95 %: %4</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 is known to about %2 % only: a tenth of it moves none of the places seen by more than %3 mm; give more of them, or %4</source>
        <translation>%1 ist nur auf etwa %2 % bekannt: ein Zehntel davon bewegt keine der gesehenen Stellen um mehr als %3 mm; geben Sie mehr davon, oder %4</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmPage</name>
    <message>
        <source>Unevenness of the film</source>
        <translation>Ungleichmäßigkeit des Films</translation>
    </message>
    <message>
        <source>Where the film has grown more and less is shown here.</source>
        <translation>Hier wird gezeigt, wo der Film mehr und wo er weniger gewachsen ist.</translation>
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
        <source>Seconds since it was laid</source>
        <translation>Sekunden seit dem Auflegen</translation>
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
        <source>Add photos of the film&apos;s chessboard floating on the water with the card beside it, or drop them here. The guide says how they are made.</source>
        <translation>Fügen Sie Fotos vom Schachbrett des Films hinzu, das auf dem Wasser schwimmt, mit der Karte daneben, oder legen Sie sie hier ab. Das Handbuch sagt, wie sie gemacht werden.</translation>
    </message>
    <message>
        <source>Dip begins after</source>
        <translation>Tauchen beginnt nach</translation>
    </message>
    <message>
        <source>Lot</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>Add &amp;Photos…</source>
        <translation>&amp;Fotos hinzufügen …</translation>
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
        <source>&amp;Save to Profile…</source>
        <translation>Im Profil &amp;speichern …</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Photos of the Film</source>
        <translation>Fotos des Films</translation>
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
        <source>when the dip begins</source>
        <translation>bei Beginn des Tauchens</translation>
    </message>
    <message>
        <source>Photo of the film</source>
        <translation>Foto des Films</translation>
    </message>
    <message>
        <source>The corners that were found in the photo are shown here.</source>
        <translation>Hier werden die im Foto gefundenen Ecken gezeigt.</translation>
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
        <source>Seconds since the film was laid on the water; the swell is told of then</source>
        <translation>Sekunden seit dem Auflegen des Films auf das Wasser; für diesen Zeitpunkt gilt die Quellung</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Längs</translation>
    </message>
    <message>
        <source>How exactly each ruler was read; the swell&apos;s interval holds it</source>
        <translation>Wie genau jedes Lineal abgelesen wurde; im Intervall der Quellung enthalten</translation>
    </message>
    <message>
        <source>as the photos say</source>
        <translation>wie in den Fotos</translation>
    </message>
    <message>
        <source>Of a camera of 35 mm; only needed where the card lies above the film</source>
        <translation>Bezogen auf Kleinbild (35 mm); nur nötig, wo die Karte über dem Film liegt</translation>
    </message>
    <message>
        <source>Card&apos;s rulers</source>
        <translation>Lineale der Karte</translation>
    </message>
    <message>
        <source>Dry film&apos;s rulers</source>
        <translation>Lineale, Film trocken</translation>
    </message>
    <message>
        <source>Read to ±</source>
        <translation>Abgelesen auf ±</translation>
    </message>
    <message>
        <source>Card above the film</source>
        <translation>Karte über dem Film</translation>
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
        <source>Rulers and Camera</source>
        <translation>Lineale und Kamera</translation>
    </message>
    <message>
        <source>What the printed rulers measure, how high the card lies, and what is known of the camera</source>
        <translation>Was die gedruckten Lineale messen, wie hoch die Karte liegt und was über die Kamera bekannt ist</translation>
    </message>
    <message>
        <source>%1: %2 corners of the film, %3 of the card, %4 px off</source>
        <translation>%1: %2 Ecken des Films, %3 der Karte, Abweichung %4 px</translation>
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
        <source>Of a camera measured before; “?”: as each photo has it</source>
        <translation>Einer früher gemessenen Kamera; „?“: wie in jedem Foto</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmProbe</name>
    <message>
        <source>Body at %1, %2, %3</source>
        <translation>Körper bei %1, %2, %3</translation>
    </message>
    <message>
        <source>on the body</source>
        <translation>auf dem Körper</translation>
    </message>
    <message>
        <source>on the water</source>
        <translation>auf dem Wasser</translation>
    </message>
    <message>
        <source>Sheet %1, %2 · %3 · stretch %4 by %5, area %6</source>
        <translation>Bogen %1, %2 · %3 · Dehnung %4 mal %5, Fläche %6</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmWatch</name>
    <message>
        <source>The film&apos;s chessboard is mirrored: lay the film with its ink side up, or turn the picture back that was flipped</source>
        <translation>Das Schachbrett des Films ist gespiegelt: legen Sie den Film mit der Farbe nach oben, oder drehen Sie das gespiegelte Bild zurück</translation>
    </message>
    <message>
        <source>The card is mirrored: turn the picture back that was flipped</source>
        <translation>Die Karte ist gespiegelt: drehen Sie das gespiegelte Bild zurück</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>Growth is not measured: that takes photos at three moments or more, from before the dip begins to after it ends</source>
        <translation>Das Wachstum ist nicht gemessen: dazu braucht es Fotos zu drei Zeitpunkten oder mehr, von vor dem Beginn des Tauchens bis nach seinem Ende</translation>
    </message>
    <message>
        <source>The film did not grow between the photos by more than they can tell</source>
        <translation>Der Film wuchs zwischen den Fotos nicht um mehr, als sie erkennen lassen</translation>
    </message>
    <message>
        <source>Growth: %1 ± %2 % a second</source>
        <translation>Wachstum: %1 ± %2 % in der Sekunde</translation>
    </message>
    <message>
        <source>It still grew as fast at the last photo, so that its limit is not known and the profile keeps its own growth; go on until it grows no more</source>
        <translation>Er wuchs beim letzten Foto noch so schnell, dass die Grenze nicht bekannt ist und das Profil sein eigenes Wachstum behält; fotografieren Sie weiter, bis er nicht mehr wächst</translation>
    </message>
    <message>
        <source>Growth: %1 ± %2 % a second when the dip begins, by %3 ± %4 % in the end</source>
        <translation>Wachstum: %1 ± %2 % in der Sekunde zu Beginn des Tauchens, am Ende um %3 ± %4 %</translation>
    </message>
    <message>
        <source>Of the film&apos;s chessboard too little is seen; photograph all of it, sharp and without glare</source>
        <translation>Vom Schachbrett des Films ist zu wenig zu sehen; fotografieren Sie es ganz, scharf und ohne Spiegelung</translation>
    </message>
    <message>
        <source>No chessboard of the film watch is seen; print it with “calibrate film” and photograph it whole, sharp and without glare</source>
        <translation>Kein Schachbrett der Filmmessung ist zu sehen; drucken Sie es mit „calibrate film“ und fotografieren Sie es ganz, scharf und ohne Spiegelung</translation>
    </message>
    <message>
        <source>The card of the film watch is not seen, without which no lengths are known; print it with “calibrate card” and lay it beside the film</source>
        <translation>Die Karte der Filmmessung ist nicht zu sehen, ohne die keine Längen bekannt sind; drucken Sie sie mit „calibrate card“ und legen Sie sie neben den Film</translation>
    </message>
    <message>
        <source>Swell when the dip begins: along X %1, along Y %2</source>
        <translation>Quellung zu Beginn des Tauchens: entlang X %1, entlang Y %2</translation>
    </message>
    <message>
        <source>Unevenness: 95 % of the film lies within %1 mm of where an evenly swollen film would lie</source>
        <translation>Ungleichmäßigkeit: 95 % des Films liegen höchstens %1 mm davon entfernt, wo ein gleichmäßig gequollener Film läge</translation>
    </message>
    <message>
        <source>Unevenness of the film</source>
        <translation>Ungleichmäßigkeit des Films</translation>
    </message>
    <message>
        <source>Colour: grown more or less than the mean, %1 · arrows: moved, %2 times</source>
        <translation>Farbe: mehr oder weniger gewachsen als das Mittel, %1 · Pfeile: verschoben, %2-fach</translation>
    </message>
    <message>
        <source>95 % of the corners lie within %1 mm of an evenly swollen film</source>
        <translation>95 % der Ecken liegen höchstens %1 mm neben einem gleichmäßig gequollenen Film</translation>
    </message>
    <message>
        <source>The corners seen do not tell how the film lies; photograph film and card from above, both whole</source>
        <translation>Die sichtbaren Ecken sagen nicht, wie der Film liegt; fotografieren Sie Film und Karte von oben, beide ganz</translation>
    </message>
    <message>
        <source>Only %1 corners of the film&apos;s chessboard are seen and it takes %2; photograph all of it, without glare</source>
        <translation>Nur %1 Ecken vom Schachbrett des Films sind zu sehen, und es braucht %2; fotografieren Sie es ganz und ohne Spiegelung</translation>
    </message>
    <message>
        <source>Only %1 corners of the card are seen and it takes %2; photograph all of it, without glare</source>
        <translation>Nur %1 Ecken der Karte sind zu sehen, und es braucht %2; fotografieren Sie sie ganz und ohne Spiegelung</translation>
    </message>
    <message>
        <source>The photo does not say how long the camera&apos;s lens was, which is needed where the card lies above the film; give its focal length as of a 35 mm camera</source>
        <translation>Das Foto nennt die Brennweite der Kamera nicht, die nötig ist, wo die Karte über dem Film liegt; geben Sie sie bezogen auf Kleinbild (35 mm) an</translation>
    </message>
    <message>
        <source>The photos show the film from %1 to %2 s after it was laid on the water, and the dip begins after %3 s, of which they tell nothing; correct the times, or photograph the film from before the dip begins</source>
        <translation>Die Fotos zeigen den Film von %1 bis %2 s nach dem Auflegen, und das Tauchen beginnt nach %3 s, worüber sie nichts sagen; berichtigen Sie die Zeiten, oder fotografieren Sie den Film von vor dem Tauchen an</translation>
    </message>
    <message>
        <source>The swell is that after %1 s, and the dip begins after %2 s: what the film grows between is not in it</source>
        <translation>Die Quellung ist die nach %1 s, und das Tauchen beginnt nach %2 s: was der Film dazwischen wächst, ist nicht darin</translation>
    </message>
    <message>
        <source>The card&apos;s corners lie %1 px from where those of a flat card would; lay it flat, and correct what is told of the lens&apos;s distortion, the focal length and the card&apos;s height, or leave them out</source>
        <translation>Die Ecken der Karte liegen %1 px neben denen einer ebenen Karte; legen Sie sie eben hin, und berichtigen Sie die Angaben zur Verzeichnung, zur Brennweite und zur Höhe der Karte, oder lassen Sie sie weg</translation>
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
        <source>The project names photos outside itself:</source>
        <translation>Das Projekt nennt Fotos außerhalb seiner selbst:</translation>
    </message>
    <message>
        <source>Measuring the film</source>
        <translation>Film wird gemessen</translation>
    </message>
    <message>
        <source>Film on the Water</source>
        <translation>Film im Becken</translation>
    </message>
    <message>
        <source>The photo %1 is another one than was added.</source>
        <translation>Das Foto %1 ist ein anderes als das hinzugefügte.</translation>
    </message>
    <message>
        <source>Export Film Watch to a Folder</source>
        <translation>Filmbeobachtung in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Export Film Watch</source>
        <translation>Filmbeobachtung exportieren</translation>
    </message>
    <message>
        <source>Wrote the film watch to %1</source>
        <translation>Filmbeobachtung nach %1 geschrieben</translation>
    </message>
</context>
<context>
    <name>dipwright::FitController</name>
    <message>
        <source>Fitting film and dip</source>
        <translation>Film und Tauchvorgang werden angepasst</translation>
    </message>
    <message>
        <source>Use in Project</source>
        <translation>Im Projekt verwenden</translation>
    </message>
    <message>
        <source>Export Fit to a Folder</source>
        <translation>Anpassung in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Export Fit</source>
        <translation>Anpassung exportieren</translation>
    </message>
    <message>
        <source>Wrote the fit to %1</source>
        <translation>Anpassung nach %1 geschrieben</translation>
    </message>
</context>
<context>
    <name>dipwright::FitPage</name>
    <message>
        <source>What was fitted</source>
        <translation>Was angepasst wurde</translation>
    </message>
    <message>
        <source>Correlations of what was fitted</source>
        <translation>Korrelationen des Angepassten</translation>
    </message>
    <message>
        <source>Near 1 or −1: the two are told together rather than each by itself</source>
        <translation>Nahe 1 oder −1: Beide sind eher zusammen bekannt als jedes für sich</translation>
    </message>
    <message>
        <source>&amp;Fit Film and Dip</source>
        <translation>Film und Tauchvorgang an&amp;passen</translation>
    </message>
    <message>
        <source>Finds what film and dip really were: simulates the dip again and again until the print lies where the photos show it</source>
        <translation>Findet, wie Film und Tauchvorgang wirklich waren: simuliert immer wieder, bis der Druck liegt, wo die Fotos ihn zeigen</translation>
    </message>
    <message>
        <source>&amp;Use in Project</source>
        <translation>Im Projekt &amp;verwenden</translation>
    </message>
    <message>
        <source>The project takes film, placement and depth as they were found; the film counts as measured</source>
        <translation>Das Projekt übernimmt Film, Lage und Tiefe wie gefunden; der Film gilt als gemessen</translation>
    </message>
    <message>
        <source>&amp;Save to Profile…</source>
        <translation>Im Profil &amp;speichern …</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>Find the corners of the print on the page “Dipped Part” first: film and dip are fitted to them.</source>
        <translation>Suchen Sie zuerst die Ecken des Drucks auf der Seite „Getauchtes Teil“: Film und Tauchvorgang werden an sie angepasst.</translation>
    </message>
    <message>
        <source>The pairs are not of the body itself: a shift or turn of the whole print cannot be told from one of the camera.</source>
        <translation>Die Paare sind nicht vom Körper selbst: Eine Verschiebung oder Drehung des ganzen Drucks ist nicht von einer der Kamera zu unterscheiden.</translation>
    </message>
    <message>
        <source>Fits placement, swell and relaxation, as far as the photos tell them.</source>
        <translation>Passt Lage, Quellung und Relaxation an, soweit die Fotos sie verraten.</translation>
    </message>
    <message>
        <source>The project has film, placement and depth as they were found here. To fit again, find the corners anew.</source>
        <translation>Das Projekt hat Film, Lage und Tiefe, wie sie hier gefunden wurden. Um erneut anzupassen, suchen Sie die Ecken neu.</translation>
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
printed on stiff, waterproof card</source>
        <translation>card.pdf
auf steife, wasserfeste Karte gedruckt</translation>
    </message>
    <message>
        <source>The rulers of both must measure 100 mm</source>
        <translation>Die Lineale beider müssen 100 mm messen</translation>
    </message>
    <message>
        <source>The film, its ink side up, as for a dip</source>
        <translation>Der Film, Farbe nach oben, wie zum Tauchen</translation>
    </message>
    <message>
        <source>The card beside it, flat</source>
        <translation>Die Karte daneben, flach</translation>
    </message>
    <message>
        <source>Both prints at one height: that is how millimetres are known</source>
        <translation>Beide Drucke auf einer Höhe: daher sind Millimeter bekannt</translation>
    </message>
    <message>
        <source>Note the time when the film is laid</source>
        <translation>Notieren, wann der Film aufgelegt wird</translation>
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
        <source>One photo tells the swell, three or more the growth</source>
        <translation>Ein Foto zeigt die Quellung, drei oder mehr das Wachstum</translation>
    </message>
    <message>
        <source>from before the dip begins until the film grows no more</source>
        <translation>von der Zeit vor dem Tauchen, bis der Film nicht mehr wächst</translation>
    </message>
</context>
<context>
    <name>dipwright::GuideWindow</name>
    <message>
        <source>User Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Enter goes to the next place</source>
        <translation>Die Eingabetaste geht zur nächsten Stelle</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Nichts gefunden</translation>
    </message>
    <message>
        <source>Places: %1</source>
        <translation>Stellen: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::HelpController</name>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Dipwright computes the picture to print on a film so that, when the body is dipped through it, every colour lands where it belongs.</source>
        <translation>Dipwright berechnet das Bild, das auf einen Film zu drucken ist, damit beim Tauchen des Körpers jede Farbe dort landet, wohin sie gehört.</translation>
    </message>
    <message>
        <source>The project</source>
        <translation>Das Projekt</translation>
    </message>
    <message>
        <source>Model, film, one or two immersions, sheet and ink. Choose a part in the tree and change its values below. Begin by dropping a model on the window.</source>
        <translation>Modell, Film, ein oder zwei Tauchvorgänge, Bogen und Farbe. Wählen Sie einen Teil im Baum und ändern Sie darunter seine Werte. Beginnen Sie, indem Sie ein Modell auf das Fenster ziehen.</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>Die Ansicht</translation>
    </message>
    <message>
        <source>The body above the film. Drag to look round it, turn it by its rings, then press Run.</source>
        <translation>Der Körper über dem Film. Ziehen Sie, um ihn von allen Seiten zu sehen, drehen Sie ihn an seinen Ringen und starten Sie dann.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Simulates the dip while you watch and can be cancelled at any time. With Run Live, each change runs what depends on it again.</source>
        <translation>Simuliert den Tauchvorgang vor Ihren Augen und kann jederzeit abgebrochen werden. Mit „Mitlaufen“ rechnet jede Änderung neu, was von ihr abhängt.</translation>
    </message>
    <message>
        <source>The timeline</source>
        <translation>Die Zeitleiste</translation>
    </message>
    <message>
        <source>Plays the dip again, or shows any moment of it.</source>
        <translation>Spielt den Tauchvorgang noch einmal ab oder zeigt einen beliebigen Augenblick.</translation>
    </message>
    <message>
        <source>The results</source>
        <translation>Die Ergebnisse</translation>
    </message>
    <message>
        <source>How the film stretches, the picture that goes on it, the body as it will come out, and the sheet to print. Move the cursor over one and see the same place in all the others.</source>
        <translation>Wie sich der Film dehnt, das Bild, das auf ihn kommt, der Körper, wie er herauskommt, und der Bogen zum Drucken. Fahren Sie mit dem Zeiger über eines und sehen Sie dieselbe Stelle in allen anderen.</translation>
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
        <source>The report is on the clipboard</source>
        <translation>Der Bericht liegt in der Zwischenablage</translation>
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
        <source>there is no number where one should be, in line %1</source>
        <translation>wo eine Zahl stehen sollte, steht keine, in Zeile %1</translation>
    </message>
    <message>
        <source>it counts more values than it can hold, in line %1</source>
        <translation>er zählt mehr Werte, als er enthalten kann, in Zeile %1</translation>
    </message>
    <message>
        <source>its array %1 has fewer values than are read</source>
        <translation>sein Array %1 hat weniger Werte, als gelesen werden</translation>
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
        <source>The model file is empty; save it anew</source>
        <translation>Die Modelldatei ist leer; speichern Sie sie neu</translation>
    </message>
    <message>
        <source>The texture file cannot be read; check its name and permissions</source>
        <translation>Die Texturdatei kann nicht gelesen werden; prüfen Sie Namen und Zugriffsrechte</translation>
    </message>
    <message>
        <source>%1 corners of the model&apos;s triangles are not numbers (NaN or infinite); repair the model and save it anew</source>
        <translation>%1 Ecken der Dreiecke des Modells sind keine Zahlen (NaN oder unendlich); reparieren Sie das Modell und speichern Sie es neu</translation>
    </message>
    <message>
        <source>None of the model&apos;s triangles has an area; choose another model</source>
        <translation>Keines der Dreiecke des Modells hat eine Fläche; wählen Sie ein anderes Modell</translation>
    </message>
    <message>
        <source>The model has no extent; choose another model</source>
        <translation>Das Modell hat keine Ausdehnung; wählen Sie ein anderes</translation>
    </message>
    <message>
        <source>The model&apos;s longest edge would be %1 mm; give the size it is to have</source>
        <translation>Die längste Kante des Modells wäre %1 mm; geben Sie die Größe an, die es haben soll</translation>
    </message>
    <message>
        <source>The model lies too far from its origin; move it there and save it anew</source>
        <translation>Das Modell liegt zu weit von seinem Ursprung; schieben Sie es dorthin und speichern Sie es neu</translation>
    </message>
    <message>
        <source>The mesh is not closed: what is inside is judged by most of the directions from which it is seen</source>
        <translation>Das Netz ist nicht geschlossen: Was innen ist, wird nach der Mehrheit der Blickrichtungen beurteilt</translation>
    </message>
    <message>
        <source>The model&apos;s longest edge is only %1 mm; if its file is not in millimetres, give the size it is to have</source>
        <translation>Die längste Kante des Modells ist nur %1 mm; wenn seine Datei nicht in Millimetern ist, geben Sie die Größe an, die es haben soll</translation>
    </message>
    <message>
        <source>The model has no texture coordinates, so its texture cannot be placed and is not used; its materials&apos; colours are</source>
        <translation>Das Modell hat keine Texturkoordinaten, daher kann seine Textur nicht aufgelegt werden; verwendet werden die Farben seiner Materialien</translation>
    </message>
    <message>
        <source>The file %1, which the model names, was not found</source>
        <translation>Die Datei %1, die das Modell nennt, wurde nicht gefunden</translation>
    </message>
    <message>
        <source>%1 texture coordinates are too large to be used; their triangles show the material&apos;s colour</source>
        <translation>%1 Texturkoordinaten sind zu groß, um verwendet zu werden; ihre Dreiecke zeigen die Farbe des Materials</translation>
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
        <translation>Teile der Textur werden gesucht</translation>
    </message>
    <message>
        <source>The model needs more memory than there is; reduce it</source>
        <translation>Das Modell braucht mehr Speicher, als da ist; verkleinern Sie es</translation>
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
        <source>a face names a point that is not there</source>
        <translation>eine Fläche nennt einen Punkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>The colours of the model&apos;s points are not used; bake them into a texture to print them</source>
        <translation>Die Farben der Punkte des Modells werden nicht verwendet; backen Sie sie in eine Textur, um sie zu drucken</translation>
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
        <source>a triangle names a point that is not there</source>
        <translation>ein Dreieck nennt einen Punkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>it is not a 3MF package</source>
        <translation>es ist kein 3MF-Paket</translation>
    </message>
    <message>
        <source>%1 in it is damaged</source>
        <translation>%1 darin ist beschädigt</translation>
    </message>
    <message>
        <source>%1 in it: %2</source>
        <translation>%1 darin: %2</translation>
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
        <source>%1 is not in it</source>
        <translation>%1 ist nicht darin</translation>
    </message>
    <message>
        <source>it places an object that is not there</source>
        <translation>es setzt ein Objekt, das es nicht gibt</translation>
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
        <source>The model cannot be read: %1; save it anew, or as %2</source>
        <translation>Das Modell kann nicht gelesen werden: %1; speichern Sie es neu oder als %2</translation>
    </message>
    <message>
        <source>its format is none of those that are read</source>
        <translation>sein Format ist keines von denen, die gelesen werden</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>die Datei kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>%1 describes a material before it names any</source>
        <translation>%1 beschreibt ein Material, bevor es eines nennt</translation>
    </message>
    <message>
        <source>%1 in it is encrypted</source>
        <translation>%1 darin ist verschlüsselt</translation>
    </message>
    <message>
        <source>The model names files that do not belong to its folder, such as %1, and is not read; put them beside it, or allow it to read them (--allow-outside)</source>
        <translation>Das Modell nennt Dateien, die nicht zu seinem Ordner gehören, etwa %1, und wird nicht gelesen; legen Sie sie daneben, oder erlauben Sie, sie zu lesen (--allow-outside)</translation>
    </message>
    <message>
        <source>Triangles without area that were removed: %1</source>
        <translation>Dreiecke ohne Fläche, die entfernt wurden: %1</translation>
    </message>
    <message>
        <source>Triangles turned that faced the other way than their neighbours: %1</source>
        <translation>Gewendete Dreiecke, die anders herum lagen als ihre Nachbarn: %1</translation>
    </message>
    <message>
        <source>Parts of the surface turned that were inside out: %1</source>
        <translation>Gewendete Teile der Oberfläche, die von innen nach außen gekehrt waren: %1</translation>
    </message>
    <message>
        <source>it needs the glTF extension %1, which is not read (export it without that)</source>
        <translation>es braucht die glTF-Erweiterung %1, die nicht gelesen wird (exportieren Sie es ohne sie)</translation>
    </message>
    <message>
        <source>its points or texture coordinates are whole numbers, which are not read (export it with float coordinates, without quantization)</source>
        <translation>seine Punkte oder Texturkoordinaten sind ganze Zahlen, die nicht gelesen werden (exportieren Sie es mit Gleitkomma-Koordinaten, ohne Quantisierung)</translation>
    </message>
    <message>
        <source>The model scales or turns a texture (KHR_texture_transform), which is not followed rightly; apply that to the texture coordinates in a modelling program</source>
        <translation>Das Modell skaliert oder dreht eine Textur (KHR_texture_transform), was nicht richtig befolgt wird; wenden Sie das in einem Modellierprogramm auf die Texturkoordinaten an</translation>
    </message>
    <message>
        <source>A texture of the model is without a picture or in a format that is not read, and its material&apos;s colour is used instead; export it with PNG or JPEG</source>
        <translation>Eine Textur des Modells ist ohne Bild oder in einem Format, das nicht gelesen wird; stattdessen wird die Farbe ihres Materials verwendet; exportieren Sie es mit PNG oder JPEG</translation>
    </message>
    <message>
        <source>it holds more than its header counts</source>
        <translation>es enthält mehr, als sein Kopf zählt</translation>
    </message>
    <message>
        <source>its unit %1 is unknown</source>
        <translation>seine Einheit %1 ist unbekannt</translation>
    </message>
    <message>
        <source>it needs the 3MF extension %1, which is not read</source>
        <translation>es braucht die 3MF-Erweiterung %1, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>two things in it have the number %1</source>
        <translation>zwei Dinge darin haben die Nummer %1</translation>
    </message>
    <message>
        <source>it names a material or texture that is not there</source>
        <translation>es nennt ein Material oder eine Textur, die es nicht gibt</translation>
    </message>
    <message>
        <source>a transform in it is not twelve numbers</source>
        <translation>eine Transformation darin besteht nicht aus zwölf Zahlen</translation>
    </message>
    <message>
        <source>Options that %1 gives a texture are not followed: %2; apply them to the picture in a modelling program</source>
        <translation>Optionen, die %1 einer Textur gibt, werden nicht befolgt: %2; wenden Sie sie in einem Modellierprogramm auf das Bild an</translation>
    </message>
    <message>
        <source>The model has a skin without bind matrices: its points are taken as they are stored, not as the joints place them; where they lie wrong, apply the armature in a modelling program</source>
        <translation>Das Modell hat eine Haut ohne Bindematrizen: Seine Punkte werden genommen, wie sie gespeichert sind, nicht wie die Gelenke sie stellen; wo sie falsch liegen, wenden Sie das Skelett in einem Modellierprogramm an</translation>
    </message>
    <message>
        <source>Points joined along seams that rounding had opened: %1</source>
        <translation>Verbundene Punkte an Nähten, die durch Rundung offen waren: %1</translation>
    </message>
    <message>
        <source>Triangles removed that the file gives twice: %1</source>
        <translation>Entfernte Dreiecke, die die Datei doppelt enthält: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::InkLaw</name>
    <message>
        <source>A density is from %1 to %2; zero the densitometer on a place without ink, and leave that patch out</source>
        <translation>Eine Dichte liegt zwischen %1 und %2; stellen Sie das Densitometer an einer Stelle ohne Tinte auf null und lassen Sie dieses Feld weg</translation>
    </message>
    <message>
        <source>The film&apos;s area must have grown by %1 to %2 times to be a reading</source>
        <translation>Für eine Messung muss die Fläche des Films auf das %1- bis %2-fache gewachsen sein</translation>
    </message>
    <message>
        <source>The patch of density %1 thins as no ink does; see that its densities and stretches stand in the right rows</source>
        <translation>Das Feld der Dichte %1 wird dünner als jede Tinte; prüfen Sie, ob Dichten und Dehnungen in den richtigen Zeilen stehen</translation>
    </message>
    <message>
        <source>The tones of an ink must stand from light to dense</source>
        <translation>Die Töne einer Tinte müssen von hell nach dicht stehen</translation>
    </message>
    <message>
        <source>Of the patches of density %1 and %2 the denser one would show less where film is stretched to %3; read both again</source>
        <translation>Von den Feldern der Dichten %1 und %2 würde das dichtere weniger zeigen, wo der Film auf %3 gedehnt ist; messen Sie beide noch einmal</translation>
    </message>
    <message>
        <source>A wedge has from 1 to %1 patches that were read on stretched film</source>
        <translation>Ein Keil hat 1 bis %1 Felder, die auf gedehntem Film gemessen wurden</translation>
    </message>
    <message>
        <source>The tones must stand by ink: cyan, magenta, yellow, black, white</source>
        <translation>Die Töne müssen nach Tinten stehen: Cyan, Magenta, Gelb, Schwarz, Weiß</translation>
    </message>
    <message>
        <source>“%1” is no tone of an ink, which is its name, density, exponent, bend and greatest stretch, such as cyan 0.3 0.48 0.1 2.9</source>
        <translation>„%1“ ist kein Ton einer Tinte, also ihr Name, Dichte, Exponent, Krümmung und größte Dehnung, wie cyan 0.3 0.48 0.1 2.9</translation>
    </message>
</context>
<context>
    <name>dipwright::InspectionController</name>
    <message>
        <source>The model&apos;s texture has no chess squares to look for; dip the chessboard, or measure the pairs alone</source>
        <translation>Die Textur des Modells hat keine Schachfelder, die sich suchen ließen; tauchen Sie das Schachbrett oder messen Sie nur die Paare</translation>
    </message>
    <message>
        <source>Dipped Part</source>
        <translation>Getauchtes Teil</translation>
    </message>
    <message>
        <source>Film on the Water</source>
        <translation>Film im Becken</translation>
    </message>
    <message>
        <source>Choose What Was Dipped</source>
        <translation>Wählen, was getaucht wurde</translation>
    </message>
    <message>
        <source>Choose What Pairs Are Of</source>
        <translation>Wählen, wovon die Paare sind</translation>
    </message>
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
        <source>The project names a photo outside itself:</source>
        <translation>Das Projekt nennt ein Foto außerhalb seiner selbst:</translation>
    </message>
    <message>
        <source>The photo %1 is another one than its places were clicked in.</source>
        <translation>Das Foto %1 ist ein anderes als das, in dem seine Stellen angeklickt wurden.</translation>
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
        <source>Export Residuals to a Folder</source>
        <translation>Abweichungen in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Export Residuals</source>
        <translation>Abweichungen exportieren</translation>
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
        <source>As Built</source>
        <translation>Wie gebaut</translation>
    </message>
</context>
<context>
    <name>dipwright::JigModel</name>
    <message>
        <source>Its box and that of %1 overlap; move them apart on the jig</source>
        <translation>Sein umgebender Quader und der von %1 überschneiden sich; rücken Sie beide auf dem Gestell auseinander</translation>
    </message>
    <message>
        <source>A jig holds one part or more, with %1 materials at most</source>
        <translation>Ein Gestell hält ein Teil oder mehr, mit höchstens %1 Materialien</translation>
    </message>
</context>
<context>
    <name>dipwright::JobQueue</name>
    <message>
        <source>%1 % of the body painted</source>
        <translation>%1 % des Körpers bemalt</translation>
    </message>
    <message>
        <source>Cancelling …</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>The queue has ended. Projects done: %1</source>
        <translation>Die Warteschlange ist zu Ende. Fertige Projekte: %1</translation>
    </message>
    <message>
        <source>, failed: %1</source>
        <translation>, gescheitert: %1</translation>
    </message>
    <message>
        <source>, cancelled: %1</source>
        <translation>, abgebrochen: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::SeamFields</name>
    <message>
        <source>The whole face</source>
        <translation>Die ganze Fläche</translation>
    </message>
    <message>
        <source>Keeps the join away</source>
        <translation>Hält die Fuge fern</translation>
    </message>
    <message>
        <source>Lets the join run there</source>
        <translation>Lässt die Fuge dort laufen</translation>
    </message>
    <message>
        <source>What a click or a drag on the body in the view marks there. Give places to the other dip to move the join. With Run Live the join follows at once.</source>
        <translation>Was ein Klick oder ein Zug auf dem Körper in der Ansicht dort markiert. Geben Sie Stellen dem anderen Tauchvorgang, um die Fuge zu verschieben. Mit „Mitlaufen“ folgt die Fuge sofort.</translation>
    </message>
    <message>
        <source>Marks the flat face that is clicked, up to its edges.</source>
        <translation>Markiert die ebene Fläche, die angeklickt wird, bis zu ihren Kanten.</translation>
    </message>
    <message>
        <source>Gives the place to %1</source>
        <translation>Gibt die Stelle %1</translation>
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
        <source>Copy Report</source>
        <translation>Bericht kopieren</translation>
    </message>
    <message>
        <source>Copies the log with facts about program and machine to the clipboard.</source>
        <translation>Kopiert das Protokoll mit Angaben zu Programm und Rechner in die Zwischenablage.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Empties the log.</source>
        <translation>Leert das Protokoll.</translation>
    </message>
</context>
<context>
    <name>dipwright::LookInsideBar</name>
    <message>
        <source>Where body and film are cut open; the frame in the view can be dragged, too</source>
        <translation>Wo Körper und Film aufgeschnitten werden; auch der Rahmen in der Ansicht lässt sich ziehen</translation>
    </message>
    <message>
        <source>How much the film covers of what lies behind it</source>
        <translation>Wie viel der Film von dem verdeckt, was hinter ihm liegt</translation>
    </message>
    <message>
        <source>Direction of the section</source>
        <translation>Richtung des Schnitts</translation>
    </message>
    <message>
        <source>Show the other side</source>
        <translation>Andere Seite zeigen</translation>
    </message>
    <message>
        <source>Film covers</source>
        <translation>Film deckt</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Across X</source>
        <translation>Quer zu X</translation>
    </message>
    <message>
        <source>Level, across Y</source>
        <translation>Waagerecht, quer zu Y</translation>
    </message>
    <message>
        <source>Across Z</source>
        <translation>Quer zu Z</translation>
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
        <source>The body is %1 long. If its file is in another unit, change its size under Model.</source>
        <translation>Der Körper ist %1 lang. Wenn seine Datei eine andere Einheit hat, ändern Sie seine Größe unter „Modell“.</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Prüfung</translation>
    </message>
</context>
<context>
    <name>dipwright::MarkFields</name>
    <message>
        <source>Remove Last</source>
        <translation>Letzte entfernen</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>A click on the body</source>
        <translation>Ein Klick auf den Körper</translation>
    </message>
    <message>
        <source>Marks nothing</source>
        <translation>Markiert nichts</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>How far round the click the mark reaches, along the surface.</source>
        <translation>Wie weit um den Klick herum die Marke reicht, entlang der Oberfläche.</translation>
    </message>
    <message>
        <source>A click</source>
        <translation>Ein Klick</translation>
    </message>
    <message>
        <source>Marks on the body: %1</source>
        <translation>Marken auf dem Körper: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::MeasurePlot</name>
    <message>
        <source>Measure to the right</source>
        <translation>Maß nach rechts</translation>
    </message>
    <message>
        <source>Measure upwards</source>
        <translation>Maß nach oben</translation>
    </message>
    <message>
        <source>Better is to the right and up. The line joins the poses that no other beats in both measures.</source>
        <translation>Besser ist rechts und oben. Die Linie verbindet die Lagen, die keine andere in beiden Maßen übertrifft.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Rank %1</source>
        <translation>Rang %1</translation>
    </message>
</context>
<context>
    <name>dipwright::MeasureTool</name>
    <message>
        <source>Click the second place on the body</source>
        <translation>Klicken Sie die zweite Stelle auf dem Körper an</translation>
    </message>
    <message>
        <source>Distance %1</source>
        <translation>Abstand %1</translation>
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
        <source>The stored model has format version %1 and this program reads version %2; use a newer program</source>
        <translation>Das gespeicherte Modell hat die Formatversion %1, dieses Programm liest Version %2; verwenden Sie ein neueres Programm</translation>
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
        <source>The longest edge is</source>
        <translation>Die längste Kante ist</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>The model&apos;s own</source>
        <translation>Die eigene des Modells</translation>
    </message>
    <message>
        <source>The size in which the film comes and is printed.</source>
        <translation>Die Größe, in der der Film geliefert und bedruckt wird.</translation>
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
        <source>One dip with the film model of 2020, to compare</source>
        <translation>Ein Tauchvorgang mit dem Filmmodell von 2020, zum Vergleich</translation>
    </message>
    <message>
        <source>How often and from where the body is dipped. All of it can be changed later.</source>
        <translation>Wie oft und von wo der Körper getaucht wird. Alles lässt sich später ändern.</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>&amp;Modell</translation>
    </message>
    <message>
        <source>Choose a Model</source>
        <translation>Modell wählen</translation>
    </message>
    <message>
        <source>Te&amp;xture</source>
        <translation>Te&amp;xtur</translation>
    </message>
    <message>
        <source>Choose a Texture</source>
        <translation>Textur wählen</translation>
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
        <source>&amp;Begin with</source>
        <translation>&amp;Beginnen mit</translation>
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
        <source>Longest edge</source>
        <translation>Längste Kante</translation>
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
        <source>The file of the body that is to be dipped.</source>
        <translation>Die Datei des Körpers, der getaucht werden soll.</translation>
    </message>
    <message>
        <source>A picture to wear in place of the model&apos;s own texture, or nothing.</source>
        <translation>Ein Bild an Stelle der eigenen Textur des Modells, oder nichts.</translation>
    </message>
    <message>
        <source>The model is made larger or smaller until its longest edge measures this.</source>
        <translation>Das Modell wird vergrößert oder verkleinert, bis seine längste Kante so viel misst.</translation>
    </message>
    <message>
        <source>In which unit the model&apos;s file gives its coordinates. The file does not say.</source>
        <translation>In welcher Einheit die Datei des Modells ihre Koordinaten angibt. Die Datei selbst sagt es nicht.</translation>
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
        <source>Choose a file: %1</source>
        <translation>Wählen Sie eine Datei: %1</translation>
    </message>
    <message>
        <source>Reading the model …</source>
        <translation>Lese das Modell …</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Lese das Modell</translation>
    </message>
    <message>
        <source>The body is %1 × %2 × %3</source>
        <translation>Der Körper misst %1 × %2 × %3</translation>
    </message>
    <message>
        <source>the unit is a guess by its size.</source>
        <translation>die Einheit ist nach seiner Größe geraten.</translation>
    </message>
    <message>
        <source>What is known of the film: how it swells, grows and tears.</source>
        <translation>Was vom Film bekannt ist: wie er quillt, wächst und reißt.</translation>
    </message>
    <message>
        <source>Film &amp;profile</source>
        <translation>Film&amp;profil</translation>
    </message>
</context>
<context>
    <name>dipwright::NoticeBar</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this notice</source>
        <translation>Diesen Hinweis schließen</translation>
    </message>
</context>
<context>
    <name>dipwright::NumberBox</name>
    <message>
        <source>“%1” has a unit, and this field has none; type the number alone</source>
        <translation>„%1“ hat eine Einheit, und dieses Feld hat keine; geben Sie nur die Zahl ein</translation>
    </message>
    <message>
        <source>“%1” is in no unit of this field; type a number in %2</source>
        <translation>„%1“ steht in keiner Einheit dieses Feldes; geben Sie eine Zahl in %2 ein</translation>
    </message>
    <message>
        <source>There is no number</source>
        <translation>Es steht keine Zahl da</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>“%1” is not within %2 to %3%4</source>
        <translation>„%1“ liegt nicht zwischen %2 und %3%4</translation>
    </message>
    <message>
        <source>“%1” can be %2 or %3; type one of them</source>
        <translation>„%1“ kann %2 oder %3 heißen; geben Sie eines davon ein</translation>
    </message>
    <message>
        <source>“%1” is no whole number</source>
        <translation>„%1“ ist keine ganze Zahl</translation>
    </message>
</context>
<context>
    <name>dipwright::OrientationMap</name>
    <message>
        <source>How good each side is to go down first</source>
        <translation>Wie gut jede Seite zuerst eintaucht</translation>
    </message>
    <message>
        <source>Which side
goes down first</source>
        <translation>Welche Seite
zuerst eintaucht</translation>
    </message>
    <message>
        <source>Objective %1, click to try this side</source>
        <translation>Zielwert %1, Klick probiert diese Seite</translation>
    </message>
</context>
<context>
    <name>dipwright::PackDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Turn pieces where that saves film</source>
        <translation>Stücke d&amp;rehen, wo das Film spart</translation>
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
        <source>Several Jobs on One Film</source>
        <translation>Mehrere Aufträge auf einem Film</translation>
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
        <source>Project files may be dropped here. They are taken as they are saved.</source>
        <translation>Projektdateien lassen sich hierher ziehen. Sie werden genommen, wie sie gespeichert sind.</translation>
    </message>
    <message>
        <source>&amp;Add Projects…</source>
        <translation>Projekte &amp;hinzufügen…</translation>
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
        <source>Film swells more along its web. Pieces of films that swell differently both ways lie along it as they were computed.</source>
        <translation>Film quillt längs seiner Bahn stärker. Stücke von Filmen, die in beiden Richtungen verschieden quellen, liegen zu ihr, wie sie berechnet sind.</translation>
    </message>
    <message>
        <source>Bare film round what is inked. A job is computed for its whole film: cut out near its ink it behaves otherwise towards the edge.</source>
        <translation>Freier Film um die Farbe. Ein Auftrag ist für seinen ganzen Film berechnet: nahe an der Farbe ausgeschnitten verhält er sich zum Rand hin anders.</translation>
    </message>
    <message>
        <source>By a quarter, and only pieces of films that swell alike both ways.</source>
        <translation>Um ein Viertel, und nur Stücke von Filmen, die in beiden Richtungen gleich quellen.</translation>
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
        <source>&amp;Spacing</source>
        <translation>&amp;Abstand</translation>
    </message>
    <message>
        <source>&amp;Bare film</source>
        <translation>Freier Fil&amp;m</translation>
    </message>
    <message>
        <source>Film that is shown</source>
        <translation>Film, der gezeigt wird</translation>
    </message>
    <message>
        <source>La&amp;y Out</source>
        <translation>A&amp;nordnen</translation>
    </message>
    <message>
        <source>Dips what has not been dipped yet, and lays it out.</source>
        <translation>Taucht, was noch nicht getaucht ist, und ordnet es an.</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>Each film as PDF, PNG and TIFF at true size, and what lies where.</source>
        <translation>Jeder Film als PDF, PNG und TIFF in wahrer Größe, und was wo liegt.</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken…</translation>
    </message>
    <message>
        <source>Copies of %1</source>
        <translation>Exemplare von %1</translation>
    </message>
    <message>
        <source>Add Projects</source>
        <translation>Projekte hinzufügen</translation>
    </message>
    <message>
        <source>At most; it is cut off behind the last piece.</source>
        <translation>Höchstens; sie wird hinter dem letzten Stück abgeschnitten.</translation>
    </message>
    <message>
        <source>Laying out</source>
        <translation>Ordne an</translation>
    </message>
    <message>
        <source>Films: %1. They are printed at true size.</source>
        <translation>Filme: %1. Sie werden in wahrer Größe gedruckt.</translation>
    </message>
    <message>
        <source>Export Films to a Folder</source>
        <translation>Filme in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Writing the films</source>
        <translation>Schreibe die Filme</translation>
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
        <source>Press Lay Out: projects that have not been dipped here are dipped first.</source>
        <translation>Drücken Sie Anordnen: Projekte, die hier noch nicht getaucht sind, werden zuerst getaucht.</translation>
    </message>
    <message>
        <source>Add projects, or drop their files here.</source>
        <translation>Fügen Sie Projekte hinzu oder ziehen Sie ihre Dateien hierher.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
</context>
<context>
    <name>dipwright::PaintArtwork</name>
    <message>
        <source>The artwork does not fit into this computer&apos;s memory; choose a lower resolution of the sheet</source>
        <translation>Die Bilder passen nicht in den Speicher dieses Computers; wählen Sie eine geringere Auflösung des Bogens</translation>
    </message>
    <message>
        <source>Painting the artwork</source>
        <translation>Bilder werden aufgetragen</translation>
    </message>
</context>
<context>
    <name>dipwright::PartCamera</name>
    <message>
        <source>Photo %1 has %2 pairs of places and takes %3 to tell its camera; give more</source>
        <translation>Foto %1 hat %2 Paare von Stellen und braucht %3, damit seine Kamera bekannt ist; geben Sie mehr an</translation>
    </message>
    <message>
        <source>All places of photo %1 lie in one plane, which does not tell how far the camera was; give some on other faces</source>
        <translation>Alle Stellen von Foto %1 liegen in einer Ebene, und das sagt nicht, wie weit die Kamera weg war; geben Sie einige auf anderen Flächen an</translation>
    </message>
    <message>
        <source>The pairs do not tell the camera; give more, farther apart</source>
        <translation>Die Paare bestimmen die Kamera nicht; geben Sie mehr an, weiter auseinander</translation>
    </message>
    <message>
        <source>The pairs do not tell how far the camera was; give places that lie nearer and farther, and photograph from less far away</source>
        <translation>Die Paare sagen nicht, wie weit die Kamera weg war; geben Sie nähere und fernere Stellen an, und fotografieren Sie aus der Nähe</translation>
    </message>
    <message>
        <source>The first line of the pairs is not %1</source>
        <translation>Die erste Zeile der Paare ist nicht %1</translation>
    </message>
    <message>
        <source>There are more than %1 pairs</source>
        <translation>Es sind mehr als %1 Paare</translation>
    </message>
    <message>
        <source>Rings: expected · lines: to where it is seen, %1 times as long</source>
        <translation>Ringe: erwartet · Linien: dorthin, wo es zu sehen ist, %1-fach</translation>
    </message>
    <message>
        <source>Photo %1 shows its places as in a mirror; give the photo as the camera made it, and the places with the model&apos;s own signs</source>
        <translation>Foto %1 zeigt seine Stellen wie in einem Spiegel; geben Sie das Foto so, wie die Kamera es gemacht hat, und die Stellen mit den Vorzeichen des Modells</translation>
    </message>
    <message>
        <source>By its places, photo %1 shows none of the print; give them again, or photograph the side that was dipped</source>
        <translation>Nach seinen Stellen zeigt Foto %1 nichts vom Druck; geben Sie sie noch einmal an oder fotografieren Sie die getauchte Seite</translation>
    </message>
    <message>
        <source>In photo %1 black and white are swapped: the film was laid with its ink down, or turned by a square</source>
        <translation>In Foto %1 sind Schwarz und Weiß vertauscht: Der Film lag mit der Farbe nach unten oder um ein Feld verschoben</translation>
    </message>
    <message>
        <source>Of %1 corners that photo %2 should show, %3 were found: is this the job&apos;s part and print, sharp and whole, and were its places given rightly?</source>
        <translation>Von %1 Ecken, die Foto %2 zeigen müsste, wurden %3 gefunden: Sind es Teil und Druck dieses Auftrags, scharf und ganz, und stimmen die angegebenen Stellen?</translation>
    </message>
    <message>
        <source>Finding corners in photo %1</source>
        <translation>Ecken in Foto %1 werden gesucht</translation>
    </message>
    <message>
        <source>Line %1 of the pairs is not %2</source>
        <translation>Zeile %1 der Paare ist nicht: %2</translation>
    </message>
    <message>
        <source>the number of a photo, two numbers of pixels and three of millimetres, joined by commas</source>
        <translation>die Nummer eines Fotos, zwei Zahlen in Pixeln und drei in Millimetern, durch Kommas verbunden</translation>
    </message>
    <message>
        <source>the number of a photo, two numbers of pixels, the number of a dip, and two and three of millimetres, joined by commas</source>
        <translation>die Nummer eines Fotos, zwei Zahlen in Pixeln, die Nummer eines Tauchvorgangs und zwei und drei in Millimetern, durch Kommas verbunden</translation>
    </message>
    <message>
        <source>The photos are of different sizes; take those of one camera, held the same way</source>
        <translation>Die Fotos sind verschieden groß; nehmen Sie solche einer Kamera, gleich gehalten</translation>
    </message>
    <message>
        <source>With this photo those of the part have %1 million pixels together, and %2 may be held at once; give fewer, or smaller ones</source>
        <translation>Mit diesem Foto haben die des Teils zusammen %1 Millionen Pixel, und %2 dürfen zugleich gehalten werden; nehmen Sie weniger oder kleinere</translation>
    </message>
</context>
<context>
    <name>dipwright::PartPage</name>
    <message>
        <source>Photo of the dipped part</source>
        <translation>Foto des getauchten Teils</translation>
    </message>
    <message>
        <source>How far the print lies off</source>
        <translation>Wie weit der Druck daneben liegt</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <source>Mean distance in the photo and its deviation</source>
        <translation>Mittlerer Abstand im Foto und seine Streuung</translation>
    </message>
    <message>
        <source>The mean over the photo&apos;s diagonal, as in the paper&apos;s Table II</source>
        <translation>Das Mittel geteilt durch die Diagonale des Fotos, wie in Tabelle II der Arbeit</translation>
    </message>
    <message>
        <source>On the body, across the line of sight: 95 % are nearer</source>
        <translation>Auf dem Körper, quer zur Blickrichtung: 95 % liegen näher</translation>
    </message>
    <message>
        <source>On the body, the farthest</source>
        <translation>Auf dem Körper, die weiteste</translation>
    </message>
    <message>
        <source>Add &amp;Photos…</source>
        <translation>&amp;Fotos hinzufügen …</translation>
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
        <source>Remove Photo</source>
        <translation>Foto entfernen</translation>
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
        <source>Photos of the Dipped Part</source>
        <translation>Fotos des getauchten Teils</translation>
    </message>
    <message>
        <source>Photos (%1)</source>
        <translation>Fotos (%1)</translation>
    </message>
    <message>
        <source>Dipped into the c&amp;hessboard of 17 mm</source>
        <translation>In das Sc&amp;hachbrett von 17 mm getaucht</translation>
    </message>
    <message>
        <source>Look for the corners of the built-in chessboard; else for those of chess squares in the model&apos;s texture</source>
        <translation>Sucht die Ecken des eingebauten Schachbretts, sonst die von Schachfeldern in der Textur des Modells</translation>
    </message>
    <message>
        <source>The pairs are places of the body &amp;itself</source>
        <translation>Die Paare s&amp;ind Stellen des Körpers selbst</translation>
    </message>
    <message>
        <source>Tips and edges, not places of the print: the camera stays as these pairs have it, so that a print that is shifted as a whole shows</source>
        <translation>Spitzen und Kanten, nicht Stellen des Drucks: Die Kamera bleibt, wie diese Paare sie haben, sodass ein im Ganzen verschobener Druck sichtbar wird</translation>
    </message>
    <message>
        <source>Measure &amp;Pairs</source>
        <translation>&amp;Paare messen</translation>
    </message>
    <message>
        <source>Fit the camera to the pairs and say how far they are off</source>
        <translation>Die Kamera an die Paare anpassen und sagen, wie weit sie daneben liegen</translation>
    </message>
    <message>
        <source>&amp;Find Corners</source>
        <translation>Ecken &amp;suchen</translation>
    </message>
    <message>
        <source>Find the corners of the print in all photos and hold them against the simulated film</source>
        <translation>Die Ecken des Drucks in allen Fotos suchen und mit dem simulierten Film vergleichen</translation>
    </message>
    <message>
        <source>&amp;Remove Pair</source>
        <translation>Paar &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Write table, places and photos with residuals to a folder</source>
        <translation>Tabelle, Stellen und Fotos mit Abweichungen in einen Ordner schreiben</translation>
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
        <source>Add photos of the dipped part, or drop them here: sharp, whole, of one camera, from near enough that the part fills the picture.</source>
        <translation>Fügen Sie Fotos des getauchten Teils hinzu oder legen Sie sie hier ab: scharf, ganz, von einer Kamera, so nah, dass das Teil das Bild füllt.</translation>
    </message>
    <message>
        <source>Now click the same place on the body in the 3D view.</source>
        <translation>Klicken Sie nun dieselbe Stelle auf dem Körper in der 3D-Ansicht an.</translation>
    </message>
    <message>
        <source>%1 of %2 corners found.</source>
        <translation>%1 von %2 Ecken gefunden.</translation>
    </message>
    <message>
        <source>The camera follows the print: a shift or turn of all of it does not show.</source>
        <translation>Die Kamera folgt dem Druck: Eine Verschiebung oder Drehung im Ganzen zeigt sich nicht.</translation>
    </message>
    <message>
        <source>The camera is that of the pairs.</source>
        <translation>Die Kamera ist die der Paare.</translation>
    </message>
    <message>
        <source>Click a place in the photo, then the same place on the body: %1 of %2 pairs, spread over several faces.</source>
        <translation>Klicken Sie eine Stelle im Foto an, dann dieselbe auf dem Körper: %1 von %2 Paaren, über mehrere Flächen verteilt.</translation>
    </message>
    <message>
        <source>%1 pairs. Drag a place to correct it; Delete removes it. Then find the corners, or measure the pairs alone.</source>
        <translation>%1 Paare. Ziehen Sie eine Stelle, um sie zu berichtigen; Entf löscht sie. Dann suchen Sie die Ecken oder messen nur die Paare.</translation>
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
        <source>Worst, mm</source>
        <translation>Größte, mm</translation>
    </message>
</context>
<context>
    <name>dipwright::PhotoView</name>
    <message>
        <source>Lines: residuals, %1 times as long</source>
        <translation>Linien: Abweichungen, %1-fach</translation>
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
        <source>Poses found, the best first</source>
        <translation>Gefundene Lagen, die beste zuerst</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Zielwert</translation>
    </message>
    <message>
        <source>Painted,
stretch</source>
        <translation>Gefärbt,
Dehnung</translation>
    </message>
    <message>
        <source>Against the best</source>
        <translation>Gegen die beste</translation>
    </message>
    <message>
        <source>≈ %1</source>
        <comment>about</comment>
        <translation>≈ %1</translation>
    </message>
    <message>
        <source>Misses a limit. %1</source>
        <translation>Verfehlt eine Grenze. %1</translation>
    </message>
    <message>
        <source>Compared with your pose: %1</source>
        <translation>Verglichen mit Ihrer Lage: %1</translation>
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
        <translation>Löser</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
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
        <source>How long after a change, at most, a copy is kept from which work is restored after a crash.</source>
        <translation>Wie lange nach einer Änderung höchstens eine Kopie angelegt wird, aus der nach einem Absturz die Arbeit wiederhergestellt wird.</translation>
    </message>
    <message>
        <source>Once there is a result, a change starts a new run of what depends on it.</source>
        <translation>Sobald es ein Ergebnis gibt, rechnet eine Änderung neu, was von ihr abhängt.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>A new language shows when the program is started again.</source>
        <translation>Eine neue Sprache zeigt sich beim nächsten Start des Programms.</translation>
    </message>
    <message>
        <source>L&amp;engths in</source>
        <translation>&amp;Längen in</translation>
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
        <source>All Back to Standard</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>The film that is proposed when a project is made.</source>
        <translation>Der Film, der für ein neues Projekt vorgeschlagen wird.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>The printer profile that new projects begin with. It can be changed under Sheet.</source>
        <translation>Das Druckerprofil, mit dem neue Projekte beginnen. Unter Bogen lässt es sich ändern.</translation>
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
        <source>How dragging in the view turns it.</source>
        <translation>Wie das Ziehen in der Ansicht sie dreht.</translation>
    </message>
    <message>
        <source>&amp;Printer of new projects</source>
        <translation>&amp;Drucker neuer Projekte</translation>
    </message>
    <message>
        <source>%1 stands for both “%2” and “%3”. Change one of them.</source>
        <translation>%1 steht für „%2“ und für „%3“. Ändern Sie eines davon.</translation>
    </message>
    <message>
        <source>The film profile that is proposed when a project is made.</source>
        <translation>Das Filmprofil, das für ein neues Projekt vorgeschlagen wird.</translation>
    </message>
    <message>
        <source>Film p&amp;rofile of new projects</source>
        <translation>Filmp&amp;rofil neuer Projekte</translation>
    </message>
    <message>
        <source>Keep results beside the project</source>
        <translation>Ergebnisse neben dem Projekt aufbewahren</translation>
    </message>
    <message>
        <source>The dips of a saved project are kept in a file NAME.dips beside it, up to 64 MB, and its results are there when it is opened again.</source>
        <translation>Die Tauchvorgänge eines gespeicherten Projekts werden in einer Datei NAME.dips daneben aufbewahrt, bis zu 64 MB, und seine Ergebnisse sind da, wenn es wieder geöffnet wird.</translation>
    </message>
</context>
<context>
    <name>dipwright::PrintDialog</name>
    <message>
        <source>Print Sheets</source>
        <translation>Bögen drucken</translation>
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
        <source>None: true size and sRGB (choose one under Sheet)</source>
        <translation>Keines: wahre Größe und sRGB (wählen Sie eines unter Bogen)</translation>
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
        <translation>Bögen</translation>
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
        <source>No printer is set up on this machine. Save the sheet as PDF and print it elsewhere, at 100 %.</source>
        <translation>Auf diesem Rechner ist kein Drucker eingerichtet. Speichern Sie den Bogen als PDF und drucken Sie ihn anderswo mit 100 %.</translation>
    </message>
    <message>
        <source>Choose at least one sheet.</source>
        <translation>Wählen Sie mindestens einen Bogen.</translation>
    </message>
    <message>
        <source>Asking the printer …</source>
        <translation>Der Drucker wird gefragt …</translation>
    </message>
    <message>
        <source>Asking the printer</source>
        <translation>Der Drucker wird gefragt</translation>
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
        <source>Handed to the queue of %1</source>
        <translation>An die Warteschlange von %1 übergeben</translation>
    </message>
    <message>
        <source>Whether this immersion&apos;s sheet is printed.</source>
        <translation>Ob der Bogen dieses Tauchvorgangs gedruckt wird.</translation>
    </message>
    <message>
        <source>The printers that are set up on this machine.</source>
        <translation>Die Drucker, die auf diesem Rechner eingerichtet sind.</translation>
    </message>
    <message>
        <source>How often each sheet is printed.</source>
        <translation>Wie oft jeder Bogen gedruckt wird.</translation>
    </message>
    <message>
        <source>Without this tick such a print is refused, with the reason.</source>
        <translation>Ohne dieses Häkchen wird ein solcher Druck mit Begründung abgelehnt.</translation>
    </message>
    <message>
        <source>Save as File…</source>
        <translation>Als Datei speichern …</translation>
    </message>
    <message>
        <source>The sheet shown, as PDF or TIFF in the printer&apos;s scale and colours.</source>
        <translation>Der gezeigte Bogen, als PDF oder TIFF im Maßstab und in den Farben des Druckers.</translation>
    </message>
    <message>
        <source>Cancelled. What the printer has already begun may still come out.</source>
        <translation>Abgebrochen. Was der Drucker schon begonnen hat, kommt vielleicht noch heraus.</translation>
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
        <translation>Eigenes, wie unter Bogen eingestellt</translation>
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
        <source>As printed, colours out of reach in magenta</source>
        <translation>Wie gedruckt, unerreichbare Farben in Magenta</translation>
    </message>
    <message>
        <source>How the page is shown here. What is printed stays the same.</source>
        <translation>Wie die Seite hier gezeigt wird. Gedruckt wird dasselbe.</translation>
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
        <source>Proofing the colours</source>
        <translation>Farben werden geprüft</translation>
    </message>
    <message>
        <source>%1 % of the paint is out of the printer&apos;s reach.</source>
        <translation>%1 % der Farbe kann der Drucker nicht wiedergeben.</translation>
    </message>
    <message>
        <source>Save Sheet</source>
        <translation>Bogen speichern</translation>
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
        <translation>Das Papier, auf das der Bogen gedruckt wird.</translation>
    </message>
    <message>
        <source>None is set up</source>
        <translation>Keiner eingerichtet</translation>
    </message>
    <message>
        <source>Tile the sheet if the paper is too small</source>
        <translation>Bogen in Stücke teilen, wenn das Papier zu klein ist</translation>
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
</context>
<context>
    <name>dipwright::PrintFields</name>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Shift X</source>
        <translation>Versatz X</translation>
    </message>
    <message>
        <source>How far the second film lies off along X.</source>
        <translation>Wie weit der zweite Film längs X daneben liegt.</translation>
    </message>
    <message>
        <source>Shift Z</source>
        <translation>Versatz Z</translation>
    </message>
    <message>
        <source>How far it lies off along Z.</source>
        <translation>Wie weit er längs Z daneben liegt.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>How far it is turned, from X to Z.</source>
        <translation>Wie weit er gedreht ist, von X nach Z.</translation>
    </message>
    <message>
        <source>Swell</source>
        <translation>Quellung</translation>
    </message>
    <message>
        <source>How much more it has grown than the sheet reckons with.</source>
        <translation>Wie viel mehr er gewachsen ist, als der Bogen annimmt.</translation>
    </message>
    <message>
        <source>In its Place</source>
        <translation>An seinen Platz</translation>
    </message>
    <message>
        <source>The second film where it belongs.</source>
        <translation>Der zweite Film dort, wo er hingehört.</translation>
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
        <source>Deeper</source>
        <translation>Tiefer</translation>
    </message>
    <message>
        <source>How much deeper the body is dipped, less deep if negative: what stays over the water gets no ink. A body that is dipped whole cannot go deeper.</source>
        <translation>Um wie viel tiefer der Körper getaucht wird, weniger tief, wenn negativ: Was über dem Wasser bleibt, bekommt keine Farbe. Ein Körper, der ganz getaucht wird, kann nicht tiefer gehen.</translation>
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
        <source>Printer&apos;s profile: %1</source>
        <translation>Druckerprofil: %1</translation>
    </message>
    <message>
        <source>Paper, in the printer&apos;s words: %1</source>
        <translation>Papier, wie der Drucker es nennt: %1</translation>
    </message>
    <message>
        <source>The project had not been saved when it was printed.</source>
        <translation>Das Projekt war noch nicht gespeichert, als es gedruckt wurde.</translation>
    </message>
    <message>
        <source>The project&apos;s file is not there any more.</source>
        <translation>Die Projektdatei ist nicht mehr da.</translation>
    </message>
    <message>
        <source>Print History</source>
        <translation>Druckverlauf</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Job number on the sheet, project, printer …</source>
        <translation>Auftragsnummer auf dem Bogen, Projekt, Drucker …</translation>
    </message>
    <message>
        <source>What was printed, the newest first</source>
        <translation>Was gedruckt wurde, das Neueste zuerst</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
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
        <source>&amp;Open Project</source>
        <translation>Projekt &amp;öffnen</translation>
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
        <source>Nothing that was printed holds these words.</source>
        <translation>Nichts Gedrucktes enthält diese Wörter.</translation>
    </message>
    <message>
        <source>Immersion</source>
        <translation>Tauchvorgang</translation>
    </message>
    <message>
        <source>Shows the prints that hold all words typed here, or parts of words</source>
        <translation>Zeigt die Drucke, die alle hier eingegebenen Wörter oder Wortteile enthalten</translation>
    </message>
</context>
<context>
    <name>dipwright::PrinterColour</name>
    <message>
        <source>The ICC profile cannot be used for printing, choose the printer&apos;s output profile</source>
        <translation>Das ICC-Profil taugt nicht zum Drucken; wählen Sie das Ausgabeprofil des Druckers</translation>
    </message>
    <message>
        <source>This is not an ICC profile, or it is damaged</source>
        <translation>Das ist kein ICC-Profil, oder es ist beschädigt</translation>
    </message>
    <message>
        <source>The ICC profile is not of an RGB or CMYK printer, choose the printer&apos;s output profile</source>
        <translation>Das ICC-Profil gehört zu keinem RGB- oder CMYK-Drucker; wählen Sie das Ausgabeprofil des Druckers</translation>
    </message>
</context>
<context>
    <name>dipwright::Printing</name>
    <message>
        <source>The printer does not say what it can do: %1</source>
        <translation>Der Drucker sagt nicht, was er kann: %1</translation>
    </message>
    <message>
        <source>The printer does not take the job: %1</source>
        <translation>Der Drucker nimmt den Auftrag nicht an: %1</translation>
    </message>
    <message>
        <source>The sheet could not be sent to the printer: %1</source>
        <translation>Der Bogen konnte nicht an den Drucker gesendet werden: %1</translation>
    </message>
    <message>
        <source>The print system does not tell what became of the job: %1</source>
        <translation>Das Drucksystem sagt nicht, was aus dem Auftrag geworden ist: %1</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>There is no such printer, and no other; set one up in the system first</source>
        <translation>Diesen Drucker gibt es nicht und auch keinen anderen; richten Sie zuerst einen im System ein</translation>
    </message>
    <message>
        <source>There is no such printer, there are: %1</source>
        <translation>Diesen Drucker gibt es nicht; es gibt: %1</translation>
    </message>
    <message>
        <source>The printer is stopped%1; start it again in the system&apos;s settings</source>
        <translation>Der Drucker ist angehalten%1; starten Sie ihn in den Einstellungen des Systems</translation>
    </message>
    <message>
        <source>The printer takes no jobs at the moment%1; let it in the system&apos;s settings</source>
        <translation>Der Drucker nimmt im Augenblick keine Aufträge an%1; erlauben Sie es in den Einstellungen des Systems</translation>
    </message>
    <message>
        <source>The printer has no paper of %1; set the sheet&apos;s paper to one that it has: %2</source>
        <translation>Der Drucker hat kein Papier von %1; stellen Sie das Papier des Bogens auf eines, das er hat: %2</translation>
    </message>
    <message>
        <source>The sheet of %1 is larger than every paper of the printer (%2); make it smaller or print it in tiles</source>
        <translation>Der Bogen von %1 ist größer als jedes Papier des Druckers (%2); verkleinern Sie ihn oder drucken Sie ihn in Stücken</translation>
    </message>
    <message>
        <source>The printer names no paper to print pieces on</source>
        <translation>Der Drucker nennt kein Papier, auf das Stücke gedruckt werden können</translation>
    </message>
    <message>
        <source>The printer has no paper named %1</source>
        <translation>Der Drucker hat kein Papier namens %1</translation>
    </message>
    <message>
        <source>The printer does not reach the outer %1 mm of the paper, and the sheet has colour there</source>
        <translation>Der Drucker erreicht die äußeren %1 mm des Papiers nicht, und der Bogen hat dort Farbe</translation>
    </message>
    <message>
        <source>%1; choose larger or borderless paper, or accept that it is lost</source>
        <translation>%1; wählen Sie größeres oder randloses Papier, oder nehmen Sie den Verlust hin</translation>
    </message>
    <message>
        <source>The printer prints in grey only, and the sheet is coloured; choose a colour printer, or accept grey</source>
        <translation>Der Drucker druckt nur grau, und der Bogen ist farbig; wählen Sie einen Farbdrucker, oder nehmen Sie Grau hin</translation>
    </message>
    <message>
        <source>The printer prints the coloured sheet in grey</source>
        <translation>Der Drucker druckt den farbigen Bogen grau</translation>
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
        <source>it does not say why</source>
        <translation>er sagt nicht, warum</translation>
    </message>
    <message>
        <source>The job was cancelled at the printer</source>
        <translation>Der Auftrag wurde am Drucker abgebrochen</translation>
    </message>
    <message>
        <source>The printer gave the job up: %1</source>
        <translation>Der Drucker hat den Auftrag aufgegeben: %1</translation>
    </message>
    <message>
        <source>The printer stopped in the middle of the job: %1; the rest is cancelled, print the sheet anew</source>
        <translation>Der Drucker hielt mitten im Auftrag an: %1; der Rest ist abgebrochen, drucken Sie den Bogen neu</translation>
    </message>
    <message>
        <source>The printer has stopped: %1; the job is cancelled, start the printer and print the sheet anew</source>
        <translation>Der Drucker hat angehalten: %1; der Auftrag ist abgebrochen, starten Sie den Drucker und drucken Sie den Bogen neu</translation>
    </message>
    <message>
        <source>This program was built without printing; print the sheet&apos;s PDF at 100 % instead</source>
        <translation>Dieses Programm wurde ohne Drucken gebaut; drucken Sie stattdessen das PDF des Bogens mit 100 %</translation>
    </message>
    <message>
        <source>The printer does not take the job</source>
        <translation>Der Drucker nimmt den Auftrag nicht an</translation>
    </message>
    <message>
        <source>The sheet could not be sent to the printer</source>
        <translation>Der Bogen konnte nicht an den Drucker gesendet werden</translation>
    </message>
    <message>
        <source>The printer takes this paper only with its other edge first; turn the page</source>
        <translation>Der Drucker nimmt dieses Papier nur mit der anderen Kante voran; drehen Sie die Seite</translation>
    </message>
    <message>
        <source>The printer does not reach the outer %1 mm of the paper; put its margins into its profile first</source>
        <translation>Der Drucker erreicht die äußeren %1 mm des Papiers nicht; tragen Sie zuerst seine Ränder in sein Profil ein</translation>
    </message>
    <message>
        <source>Calibration of %1</source>
        <translation>Kalibrierung von %1</translation>
    </message>
    <message>
        <source>Pieces of a sheet are written as PDF, one page each; name the file .pdf</source>
        <translation>Die Teile eines Bogens werden als PDF geschrieben, je eine Seite; nennen Sie die Datei .pdf</translation>
    </message>
    <message>
        <source>The printer scales pages by itself (&quot;%1&quot;), and the print system does not pass on to it that it must not; set its scaling to &quot;none&quot; in its own menu</source>
        <translation>Der Drucker skaliert Seiten von selbst („%1“), und das Drucksystem gibt nicht an ihn weiter, dass er es nicht soll; stellen Sie in seinem eigenen Menü die Skalierung auf „none“</translation>
    </message>
    <message>
        <source>%1, lot %2</source>
        <translation>%1, Charge %2</translation>
    </message>
    <message>
        <source>Sent, nothing more is known</source>
        <translation>Gesendet, mehr ist nicht bekannt</translation>
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
        <source>The print history does not have it: %1</source>
        <translation>Im Druckverlauf fehlt es: %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>der Ordner %1 kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>it does not leave the page&apos;s size alone</source>
        <translation>er lässt die Größe der Seite nicht, wie sie ist</translation>
    </message>
    <message>
        <source>The printer scales pages where it is not told otherwise, which its queue does not pass on; the job goes past the queue, to the printer itself</source>
        <translation>Der Drucker skaliert Seiten, wenn ihm nichts anderes gesagt wird, und seine Warteschlange gibt das nicht weiter; der Auftrag geht an der Warteschlange vorbei direkt an den Drucker</translation>
    </message>
    <message>
        <source>The white layer is left out: it needs a printer profile with an ICC profile in CMYK</source>
        <translation>Die weiße Schicht fehlt: Sie braucht ein Druckerprofil mit einem ICC-Profil in CMYK</translation>
    </message>
    <message>
        <source>The cut line is left out: it needs a PDF and a printer profile with an ICC profile in CMYK</source>
        <translation>Die Schnittlinie fehlt: Sie braucht ein PDF und ein Druckerprofil mit einem ICC-Profil in CMYK</translation>
    </message>
    <message>
        <source>The spot inks are left out: they need a printer profile with an ICC profile in CMYK</source>
        <translation>Die Sonderfarben fehlen: Sie brauchen ein Druckerprofil mit einem ICC-Profil in CMYK</translation>
    </message>
    <message>
        <source>On %1 mm² of the part the inks fall visibly short: full ink, the ink limit or the total of ink does not make up for the stretch</source>
        <translation>Auf %1 mm² des Teils reichen die Tinten sichtbar nicht: volle Tinte, Farbgrenze oder Gesamtfarbauftrag gleichen die Dehnung nicht aus</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Angehalten: %1</translation>
    </message>
    <message>
        <source>Not known: %1</source>
        <translation>Nicht bekannt: %1</translation>
    </message>
    <message>
        <source>the job is cancelled</source>
        <translation>der Auftrag ist abgebrochen</translation>
    </message>
    <message>
        <source>the job could not be cancelled, remove it from the printer&apos;s queue</source>
        <translation>der Auftrag ließ sich nicht abbrechen, bitte aus der Warteschlange des Druckers entfernen</translation>
    </message>
    <message>
        <source>The print system has done with the job, but the printer does not answer; look whether the sheet has come out, and print it anew if not</source>
        <translation>Das Drucksystem hat den Auftrag abgeschlossen, aber der Drucker antwortet nicht; bitte nachsehen, ob das Blatt gedruckt ist, und es sonst neu drucken</translation>
    </message>
    <message>
        <source>The printer does not answer (%1); %2; check its power, its cable and its address in the system, and print the sheet anew</source>
        <translation>Der Drucker antwortet nicht (%1); %2; bitte Strom, Kabel und seine Adresse im System prüfen und das Blatt neu drucken</translation>
    </message>
    <message>
        <source>Nothing new was heard of job %1 for a long time (%2), and this printer cannot be asked; look at the printer, and remove the job from its queue if it does not print</source>
        <translation>Von Auftrag %1 ist lange nichts Neues bekannt (%2), und dieser Drucker lässt sich nicht fragen; bitte am Drucker nachsehen und den Auftrag aus der Warteschlange entfernen, falls er nicht druckt</translation>
    </message>
</context>
<context>
    <name>dipwright::ProfileController</name>
    <message>
        <source>Use Profile %1</source>
        <translation>Profil %1 verwenden</translation>
    </message>
    <message>
        <source>Calibrated %1</source>
        <translation>%1 kalibriert</translation>
    </message>
</context>
<context>
    <name>dipwright::ProfilesDialog</name>
    <message>
        <source>Profiles (%1)</source>
        <translation>Profile (%1)</translation>
    </message>
    <message>
        <source>None: the printer is sent sRGB</source>
        <translation>Keines: Der Drucker bekommt sRGB</translation>
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
        <source>&amp;Use in Project</source>
        <translation>Im Projekt &amp;verwenden</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>The project takes its values over and keeps a copy, so that it prints the same when the profile has since changed.</source>
        <translation>Das Projekt übernimmt seine Werte und behält eine Kopie, damit es gleich druckt, auch wenn sich das Profil seither geändert hat.</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren …</translation>
    </message>
    <message>
        <source>Makes a profile of your own from this one.</source>
        <translation>Macht aus diesem ein eigenes Profil.</translation>
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
        <translation>Das Ausgabeprofil des Druckers für seine Farben und den Film. Bögen werden dann in den Farben des Druckers gesendet.</translation>
    </message>
    <message>
        <source>A profile needs a name</source>
        <translation>Ein Profil braucht einen Namen</translation>
    </message>
    <message>
        <source>There is a profile of this name already, choose another</source>
        <translation>Ein Profil dieses Namens gibt es schon, wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>Changes are kept at once. Profiles in italics come with the program; a changed one is yours, and Remove brings the first back.</source>
        <translation>Änderungen werden sofort behalten. Kursive Profile kommen mit dem Programm; ein geändertes ist Ihres, und „Entfernen“ bringt das erste zurück.</translation>
    </message>
    <message>
        <source>Import Profile</source>
        <translation>Profil importieren</translation>
    </message>
    <message>
        <source>Export Profile</source>
        <translation>Profil exportieren</translation>
    </message>
    <message>
        <source>Copy Profile</source>
        <translation>Profil kopieren</translation>
    </message>
    <message>
        <source>Name of the copy:</source>
        <translation>Name der Kopie:</translation>
    </message>
    <message>
        <source>%1, own</source>
        <translation>%1, eigenes</translation>
    </message>
    <message>
        <source>ICC profiles (%1)</source>
        <translation>ICC-Profile (%1)</translation>
    </message>
    <message>
        <source>Profile Changed Elsewhere</source>
        <translation>Profil anderswo geändert</translation>
    </message>
    <message>
        <source>Another program has changed the profile “%1” meanwhile.</source>
        <translation>Ein anderes Programm hat das Profil „%1“ inzwischen geändert.</translation>
    </message>
    <message>
        <source>Show the Other’s</source>
        <translation>Das andere zeigen</translation>
    </message>
    <message>
        <source>Keep &amp;Mine</source>
        <translation>&amp;Meines behalten</translation>
    </message>
    <message>
        <source>%1 (CMYK)</source>
        <translation>%1 (CMYK)</translation>
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
        <source>Add a second immersion</source>
        <translation>Zweiten Tauchvorgang hinzufügen</translation>
    </message>
    <message>
        <source>Remove this immersion</source>
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
        <source>A film that was measured once: size, swell, relaxation and sides.</source>
        <translation>Ein Film, der einmal vermessen wurde: Größe, Quellung, Relaxation und Seiten.</translation>
    </message>
    <message>
        <source>Tank profile</source>
        <translation>Beckenprofil</translation>
    </message>
    <message>
        <source>A tank: its barriers hold the film&apos;s sides.</source>
        <translation>Ein Becken: Seine Barrieren halten die Seiten des Films.</translation>
    </message>
    <message>
        <source>Printer profile</source>
        <translation>Druckerprofil</translation>
    </message>
    <message>
        <source>A printer that was measured once: its scale, margins, colours, ink limit and resolution.</source>
        <translation>Ein Drucker, der einmal vermessen wurde: Maßstab, Ränder, Farben, Farbgrenze und Auflösung.</translation>
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
        <source>From %1</source>
        <translation>Aus %1</translation>
    </message>
    <message>
        <source>%1 × %2 × %3</source>
        <translation>%1 × %2 × %3</translation>
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
        <source>No texture: drop a picture on the window to put one on</source>
        <translation>Keine Textur: Ziehen Sie ein Bild auf das Fenster, um eine aufzulegen</translation>
    </message>
    <message>
        <source>Reload from Disk</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Reads the model&apos;s file again and keeps all settings.</source>
        <translation>Liest die Datei des Modells neu und behält alle Einstellungen.</translation>
    </message>
    <message>
        <source>Replace Model…</source>
        <translation>Modell ersetzen …</translation>
    </message>
    <message>
        <source>Takes another model. Rotations and offsets start anew.</source>
        <translation>Nimmt ein anderes Modell. Drehungen und Versatz beginnen von vorn.</translation>
    </message>
    <message>
        <source>Replace Texture…</source>
        <translation>Textur ersetzen …</translation>
    </message>
    <message>
        <source>Puts another picture on the model.</source>
        <translation>Legt ein anderes Bild auf das Modell.</translation>
    </message>
    <message>
        <source>Production</source>
        <translation>Produktion</translation>
    </message>
    <message>
        <source>Paper of 2020</source>
        <translation>Arbeit von 2020</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigenes</translation>
    </message>
    <message>
        <source>Production is the accurate film model and the default. Paper of 2020 is the published model, for comparison.</source>
        <translation>Produktion ist das genaue Filmmodell und die Vorgabe. Arbeit von 2020 ist das veröffentlichte Modell, zum Vergleich.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Apply Preset</source>
        <translation>Vorgabe anwenden</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>%1 wählen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Best available</source>
        <translation>Bester verfügbarer</translation>
    </message>
    <message>
        <source>%1 (not available)</source>
        <translation>%1 (nicht verfügbar)</translation>
    </message>
    <message>
        <source>What computes the dip. “Best available” takes a GPU where there is one.</source>
        <translation>Was den Tauchvorgang berechnet. „Bester verfügbarer“ nimmt eine GPU, wo es eine gibt.</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>Choose Solver</source>
        <translation>Löser wählen</translation>
    </message>
    <message>
        <source>%1 (not installed)</source>
        <translation>%1 (nicht installiert)</translation>
    </message>
    <message>
        <source>Where the join runs</source>
        <translation>Wo die Fuge läuft</translation>
    </message>
    <message>
        <source>Shown with “Print on the Body”; changes no sheet.</source>
        <translation>Zu sehen mit „Druck auf dem Körper“; ändert keinen Bogen.</translation>
    </message>
    <message>
        <source>The print, and if the second film lies off</source>
        <translation>Der Druck, und wenn der zweite Film daneben liegt</translation>
    </message>
    <message>
        <source>Zones on the body</source>
        <translation>Zonen auf dem Körper</translation>
    </message>
    <message>
        <source>Tell Tolerances…</source>
        <translation>Toleranzen berechnen …</translation>
    </message>
    <message>
        <source>Dips with everything off, one by one and all at once, and says how far the colours land off their places.</source>
        <translation>Taucht mit allen Abweichungen, einzeln und zugleich, und sagt, wie weit die Farben neben ihrem Ort landen.</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>Längste Kante</translation>
    </message>
    <message>
        <source>Makes the body larger or smaller, with what is marked on it.</source>
        <translation>Macht den Körper größer oder kleiner, mit dem, was auf ihm markiert ist.</translation>
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
        <source>Job Queue</source>
        <translation>Warteschlange</translation>
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
        <source>Each project that is added has a folder with its name in this one.</source>
        <translation>Jedes Projekt, das hinzugefügt wird, hat in diesem einen Ordner mit seinem Namen.</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>&amp;Wählen …</translation>
    </message>
    <message>
        <source>Results &amp;into</source>
        <translation>Ergebnisse &amp;in</translation>
    </message>
    <message>
        <source>&amp;Add Projects…</source>
        <translation>Projekte &amp;hinzufügen …</translation>
    </message>
    <message>
        <source>&amp;Cancel Chosen</source>
        <translation>&amp;Gewählte abbrechen</translation>
    </message>
    <message>
        <source>Cancel A&amp;ll</source>
        <translation>&amp;Alle abbrechen</translation>
    </message>
    <message>
        <source>&amp;Remove Ended</source>
        <translation>&amp;Beendete entfernen</translation>
    </message>
    <message>
        <source>&amp;Open Project</source>
        <translation>Projekt &amp;öffnen</translation>
    </message>
    <message>
        <source>Add Projects</source>
        <translation>Projekte hinzufügen</translation>
    </message>
    <message>
        <source>Folder for the Results</source>
        <translation>Ordner für die Ergebnisse</translation>
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
        <source>Add projects: they are run one after the other as they are saved, and their results written.</source>
        <translation>Fügen Sie Projekte hinzu: Sie werden nacheinander gerechnet, wie sie gespeichert sind, und ihre Ergebnisse geschrieben.</translation>
    </message>
    <message>
        <source>%1 of %2 ended</source>
        <translation>%1 von %2 beendet</translation>
    </message>
    <message>
        <source>, about %1 left</source>
        <translation>, noch etwa %1</translation>
    </message>
    <message>
        <source>Projects are still being run. Stop them?</source>
        <translation>Es werden noch Projekte gerechnet. Beenden?</translation>
    </message>
    <message>
        <source>What is done is kept.</source>
        <translation>Was fertig ist, bleibt.</translation>
    </message>
    <message>
        <source>&amp;Stop Them</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
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
        <source>The program that reads models and pictures cannot be kept from doing anything else on this system, and does not read; use another system, or set DIPWRIGHT_READ_UNCONFINED=1 for files that you trust</source>
        <translation>Das Programm, das Modelle und Bilder liest, lässt sich auf diesem System nicht davon abhalten, anderes zu tun, und liest nicht; nehmen Sie ein anderes System, oder setzen Sie DIPWRIGHT_READ_UNCONFINED=1 für Dateien, denen Sie trauen</translation>
    </message>
</context>
<context>
    <name>dipwright::ReaderProcess</name>
    <message>
        <source>The program that reads models and pictures is missing; install Dipwright anew</source>
        <translation>Das Programm, das Modelle und Bilder liest, fehlt; installieren Sie Dipwright neu</translation>
    </message>
    <message>
        <source>The program that reads models and pictures cannot be started: %1</source>
        <translation>Das Programm, das Modelle und Bilder liest, kann nicht gestartet werden: %1</translation>
    </message>
    <message>
        <source>The file makes its reader hand back what cannot be, and is not read; save it anew</source>
        <translation>Die Datei bringt das Leseprogramm dazu, Unmögliches zurückzugeben, und wird nicht gelesen; speichern Sie sie neu</translation>
    </message>
    <message>
        <source>The file makes its reader crash and is not read; save it anew, a model as %1, a picture as PNG</source>
        <translation>Die Datei lässt das Leseprogramm abstürzen und wird nicht gelesen; speichern Sie sie neu, ein Modell als %1, ein Bild als PNG</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The code of the language of this translation: de, pt_BR …</extracomment>
        <translation>de</translation>
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
        <source>Body painted altogether</source>
        <translation>Körper insgesamt bemalt</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
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
</context>
<context>
    <name>dipwright::Results</name>
    <message>
        <source>There is no colour map of this name; choose one of %1</source>
        <translation>Eine Farbtafel dieses Namens gibt es nicht; wählen Sie eine von %1</translation>
    </message>
    <message>
        <source>Preparing the proof</source>
        <translation>Vorschau wird vorbereitet</translation>
    </message>
    <message>
        <source>Tracing the proof</source>
        <translation>Vorschau wird gezeichnet</translation>
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
        <source>Stretch of the film</source>
        <translation>Dehnung des Films</translation>
    </message>
    <message>
        <source>Mean of each point&apos;s constraints, final over rest length; ink side up</source>
        <translation>Mittel der Fäden jedes Punkts, End- über Ruhelänge; Farbseite oben</translation>
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
        <source>On the body: min %1 · mean %2 · 95 % %3 · max %4</source>
        <translation>Auf dem Körper: min %1 · Mittel %2 · 95 % %3 · max %4</translation>
    </message>
    <message>
        <source>Outlined: film on the body · pale: film left over</source>
        <translation>Umrandet: Film auf dem Körper · blass: übriger Film</translation>
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
        <source>On the body: compressed by over 1 % on %1 % of the film · smallest stretch %2</source>
        <translation>Auf dem Körper: um über 1 % gestaucht auf %1 % des Films · kleinste Dehnung %2</translation>
    </message>
    <message>
        <source>Certainty of the sheet</source>
        <translation>Verlässlichkeit des Bogens</translation>
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
        <source>Both, along the join</source>
        <translation>Beide, längs der Fuge</translation>
    </message>
    <message>
        <source>Not reached</source>
        <translation>Nicht erreicht</translation>
    </message>
    <message>
        <source>The join: %1 mm</source>
        <translation>Die Fuge: %1 mm</translation>
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
        <source>Tracing the shares</source>
        <translation>Zeichne die Anteile</translation>
    </message>
    <message>
        <source>Film of %1</source>
        <translation>Film von %1</translation>
    </message>
    <message>
        <source>Tolerance of the sheet</source>
        <translation>Toleranz des Bogens</translation>
    </message>
    <message>
        <source>How far the ink may land off its place on the body; ink side up</source>
        <translation>Wie weit die Farbe neben ihrem Ort auf dem Körper landen kann; Farbseite oben</translation>
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
        <source>change
%1</source>
        <translation>Änderung
%1</translation>
    </message>
    <message>
        <source>off by
± %1</source>
        <translation>daneben um
± %1</translation>
    </message>
    <message>
        <source>On the body: 95 % within ±%1</source>
        <translation>Auf dem Körper: 95 % innerhalb ±%1</translation>
    </message>
    <message>
        <source>Numerical error of the ink&apos;s position; ink side up</source>
        <translation>Numerischer Fehler der Lage der Farbe; Farbseite oben</translation>
    </message>
    <message>
        <source>Limit: %1 · magenta: painted in only one of the dips</source>
        <translation>Grenze: %1 · Magenta: nur in einem der Tauchvorgänge bemalt</translation>
    </message>
</context>
<context>
    <name>dipwright::ResultsPanel</name>
    <message>
        <source>Reverse texture</source>
        <translation>Umgekehrte Textur</translation>
    </message>
    <message>
        <source>Run the dip to see the image that goes on the film.</source>
        <translation>Starten Sie den Tauchvorgang, um das Bild zu sehen, das auf den Film kommt.</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Run the dip to see the body as it will come out.</source>
        <translation>Starten Sie den Tauchvorgang, um den Körper zu sehen, wie er herauskommt.</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>Run the dip to see the page as it prints.</source>
        <translation>Starten Sie den Tauchvorgang, um die Seite zu sehen, wie sie gedruckt wird.</translation>
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
        <source>The reverse texture: the image that goes on the film</source>
        <translation>Die umgekehrte Textur: das Bild, das auf den Film kommt</translation>
    </message>
    <message>
        <source>The body as it will come out</source>
        <translation>Der Körper, wie er herauskommt</translation>
    </message>
    <message>
        <source>The page as it prints</source>
        <translation>Die Seite, wie sie gedruckt wird</translation>
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
        <source>Whether to print the sheet, and where to look first</source>
        <translation>Ob der Bogen gedruckt werden soll und wo zuerst hinzusehen ist</translation>
    </message>
    <message>
        <source>Who Paints What</source>
        <translation>Wer was färbt</translation>
    </message>
    <message>
        <source>The shares of the two dips, from six sides and on both films</source>
        <translation>Die Anteile der beiden Tauchvorgänge, von sechs Seiten und auf beiden Filmen</translation>
    </message>
    <message>
        <source>The shares of the two dips, over the sheet of this one</source>
        <translation>Die Anteile der beiden Tauchvorgänge, über dem Bogen von diesem</translation>
    </message>
    <message>
        <source>Without White</source>
        <translation>Ohne Weiß</translation>
    </message>
    <message>
        <source>The ink on the part&apos;s own colour, as it were without the white</source>
        <translation>Die Druckfarbe auf der Farbe des Teils, wie sie ohne das Weiß wäre</translation>
    </message>
</context>
<context>
    <name>dipwright::ReverseTexture</name>
    <message>
        <source>Reversing the texture</source>
        <translation>Textur wird umgekehrt</translation>
    </message>
    <message>
        <source>The film&apos;s image is too large for this computer&apos;s memory; choose a lower resolution</source>
        <translation>Das Bild des Films ist zu groß für den Speicher dieses Rechners; wählen Sie eine kleinere Auflösung</translation>
    </message>
    <message>
        <source>Continuing the colour past the edge</source>
        <translation>Farbe wird über den Rand hinaus fortgesetzt</translation>
    </message>
</context>
<context>
    <name>dipwright::SearchController</name>
    <message>
        <source>Searching poses</source>
        <translation>Lagen werden gesucht</translation>
    </message>
    <message>
        <source>The poses are searched; the best is on top.</source>
        <translation>Die Lagen sind durchsucht; die beste steht oben.</translation>
    </message>
    <message>
        <source>The search was stopped; the best so far is on top.</source>
        <translation>Die Suche wurde beendet; die bisher beste steht oben.</translation>
    </message>
    <message>
        <source>Pose Search</source>
        <translation>Lagensuche</translation>
    </message>
    <message>
        <source>Change What Poses Are Searched For</source>
        <translation>Ändern, wonach Lagen gesucht werden</translation>
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
        <source>&amp;Take This Pose</source>
        <translation>Diese Lage &amp;übernehmen</translation>
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
        <source>How many poses are dipped with a coarse film, out of %1 that are judged by the body&apos;s shape. The best are refined.</source>
        <translation>Wie viele Lagen mit einem groben Film getaucht werden, von %1, die nach der Form des Körpers beurteilt werden. Die besten werden verfeinert.</translation>
    </message>
    <message>
        <source>The same number gives the same table; another one tries other directions.</source>
        <translation>Dieselbe Zahl gibt dieselbe Tabelle; eine andere probiert andere Richtungen.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planen</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Probieren</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>What counts, and what must be kept</source>
        <translation>Was zählt und was eingehalten werden muss</translation>
    </message>
    <message>
        <source>Let others have the processor; the search goes on where it was</source>
        <translation>Überlässt den Prozessor anderen; die Suche geht weiter, wo sie war</translation>
    </message>
    <message>
        <source>End the search and keep the best that was found</source>
        <translation>Beendet die Suche und behält das Beste, das gefunden wurde</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Fortschritt der Suche</translation>
    </message>
    <message>
        <source>The project has been changed since these poses were searched.</source>
        <translation>Das Projekt wurde geändert, seit diese Lagen gesucht wurden.</translation>
    </message>
    <message>
        <source>Dip the body as chosen in the table; one step to undo</source>
        <translation>Taucht den Körper wie in der Tabelle gewählt; ein Schritt zum Rückgängigmachen</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>%1 of %2 dips</source>
        <translation>%1 von %2 Tauchvorgängen</translation>
    </message>
    <message>
        <source>%1, about %2 s left</source>
        <translation>%1, noch etwa %2 s</translation>
    </message>
    <message>
        <source>Rank %1 against rank %2: %3</source>
        <translation>Rang %1 gegen Rang %2: %3</translation>
    </message>
    <message>
        <source>Side &amp;by Side …</source>
        <translation>&amp;Nebeneinander …</translation>
    </message>
    <message>
        <source>Two chosen poses, or one and the project&apos;s own, in the view, by cameras that turn together</source>
        <translation>Zwei gewählte Lagen, oder eine und die des Projekts, in der Ansicht, mit Kameras, die sich gemeinsam drehen</translation>
    </message>
    <message>
        <source>Rank %1</source>
        <translation>Rang %1</translation>
    </message>
    <message>
        <source>The project&apos;s own</source>
        <translation>Die des Projekts</translation>
    </message>
</context>
<context>
    <name>dipwright::Sheet</name>
    <message>
        <source>A film of %1 × %2 mm at %3 dpi does not make an image of 1 to %4 pixels a side; choose another resolution or film size</source>
        <translation>Ein Film von %1 × %2 mm bei %3 dpi ergibt kein Bild von 1 bis %4 Bildpunkten je Seite; wählen Sie eine andere Auflösung oder Filmgröße</translation>
    </message>
    <message>
        <source>The sheet&apos;s PDF cannot be written: %1</source>
        <translation>Das PDF des Bogens kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>The sheet&apos;s TIFF cannot be written: %1</source>
        <translation>Das TIFF des Bogens kann nicht geschrieben werden: %1</translation>
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
        <source>%1 · %2 · %3 · Film %4 · Scale %5 · Job %6</source>
        <translation>%1 · %2 · %3 · Film %4 · Maßstab %5 · Auftrag %6</translation>
    </message>
    <message>
        <source>%1 · Job %2</source>
        <translation>%1 · Auftrag %2</translation>
    </message>
    <message>
        <source>The paper of %1 × %2 mm is smaller than the film of %3 × %4 mm; choose larger paper, turn it or make the film smaller</source>
        <translation>Das Papier von %1 × %2 mm ist kleiner als der Film von %3 × %4 mm; wählen Sie größeres Papier, drehen Sie es oder verkleinern Sie den Film</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm leaves no room for pieces of the sheet; take larger paper</source>
        <translation>Papier von %1 × %2 mm lässt keinen Platz für Stücke des Bogens; nehmen Sie größeres</translation>
    </message>
    <message>
        <source>The sheet would be cut into more than %1 pieces; take larger paper</source>
        <translation>Der Bogen würde in mehr als %1 Stücke geschnitten; nehmen Sie größeres Papier</translation>
    </message>
    <message>
        <source>%1 · row %2 of %3, column %4 of %5 · cut along the dashes</source>
        <translation>%1 · Zeile %2 von %3, Spalte %4 von %5 · an den Strichen schneiden</translation>
    </message>
    <message>
        <source>Its sheet has %1 dpi and that of %2 has %3; give them one resolution</source>
        <translation>Sein Bogen hat %1 dpi und der von %2 hat %3; geben Sie beiden eine Auflösung</translation>
    </message>
    <message>
        <source>%1 pieces are to be packed; choose 1 to %2</source>
        <translation>%1 Stücke sollen zusammengelegt werden; 1 bis %2 sind möglich</translation>
    </message>
    <message>
        <source>With its marks it takes %1 × %2 mm, and the film leaves %3 × %4 mm within its edges; take a larger film</source>
        <translation>Mit seinen Marken braucht es %1 × %2 mm, und der Film lässt innerhalb seiner Ränder %3 × %4 mm; nehmen Sie einen größeren Film</translation>
    </message>
    <message>
        <source>Film %1 of %2, pieces: %3</source>
        <translation>Film %1 von %2, Stücke: %3</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>There is no ink on its sheet</source>
        <translation>Auf seinem Bogen ist keine Farbe</translation>
    </message>
    <message>
        <source>This takes %1 films; choose fewer copies, up to %2 films</source>
        <translation>Das braucht %1 Filme; wählen Sie weniger Exemplare, bis zu %2 Filme</translation>
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
        <source>Its white is printed otherwise than that of %1; give them one kind of white and one name for it</source>
        <translation>Sein Weiß wird anders gedruckt als das von %1; geben Sie beiden eine Art Weiß und einen Namen dafür</translation>
    </message>
    <message>
        <source>Its spot ink %1 is printed otherwise than that of another job; give them one colour and order</source>
        <translation>Seine Sonderfarbe %1 wird anders gedruckt als die eines anderen Auftrags; geben Sie ihnen eine Farbe und Reihenfolge</translation>
    </message>
</context>
<context>
    <name>dipwright::SheetCorrection</name>
    <message>
        <source>Blue: what the next sheet is corrected by</source>
        <translation>Blau: worum der nächste Bogen korrigiert wird</translation>
    </message>
    <message>
        <source>Dip %1: %2 places on one part, off by up to %3 mm. What of this repeats is told by three parts or more.</source>
        <translation>Tauchvorgang %1: %2 Stellen auf einem Teil, bis zu %3 mm daneben. Was sich davon wiederholt, sagen drei Teile oder mehr.</translation>
    </message>
    <message>
        <source>Dip %1: %2 places on %3 parts. Up to %4 mm repeat, much the same within %5 mm; a place scatters by %6 mm, a whole part by %7 mm.</source>
        <translation>Tauchvorgang %1: %2 Stellen auf %3 Teilen. Bis zu %4 mm wiederholen sich, etwa gleich innerhalb von %5 mm; eine Stelle streut um %6 mm, ein ganzes Teil um %7 mm.</translation>
    </message>
    <message>
        <source>Red: how far off, the mean of parts measured (%1), %2 times as long</source>
        <translation>Rot: wie weit daneben, Mittel der gemessenen Teile (%1), %2-mal so lang</translation>
    </message>
</context>
<context>
    <name>dipwright::SnapshotsDialog</name>
    <message>
        <source>&amp;Take Snapshot</source>
        <translation>Schnappschuss &amp;aufnehmen</translation>
    </message>
    <message>
        <source>&amp;Go Back to It</source>
        <translation>&amp;Dorthin zurückgehen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>Schnappschüsse</translation>
    </message>
    <message>
        <source>Snapshots, the oldest first</source>
        <translation>Schnappschüsse, die ältesten zuerst</translation>
    </message>
    <message>
        <source>Name of the snapshot</source>
        <translation>Name des Schnappschusses</translation>
    </message>
    <message>
        <source>Under which the project&apos;s settings are kept in its file</source>
        <translation>Unter dem die Einstellungen des Projekts in seiner Datei behalten werden</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>Verglichen mit</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Was sich unterscheidet</translation>
    </message>
    <message>
        <source>The settings become those of the snapshot: a step that can be undone. Model, photos and parts stay.</source>
        <translation>Die Einstellungen werden die des Schnappschusses: ein Schritt, der sich rückgängig machen lässt. Modell, Fotos und Teile bleiben.</translation>
    </message>
    <message>
        <source>Compared with the project as it is now</source>
        <translation>Verglichen mit dem Projekt, wie es jetzt ist</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>Verglichen mit %1</translation>
    </message>
    <message>
        <source>A snapshot keeps the project&apos;s settings under a name, in its file.</source>
        <translation>Ein Schnappschuss behält die Einstellungen des Projekts unter einem Namen in seiner Datei.</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
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
        <source>&amp;Side by Side …</source>
        <translation>&amp;Nebeneinander …</translation>
    </message>
    <message>
        <source>Both in the view, by cameras that turn together; what is not dipped yet is dipped</source>
        <translation>Beide in der Ansicht, mit Kameras, die sich gemeinsam drehen; was noch nicht getaucht ist, wird getaucht</translation>
    </message>
</context>
<context>
    <name>dipwright::SolverPage</name>
    <message>
        <source>Solvers</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
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
        <source>None found</source>
        <translation>Keiner gefunden</translation>
    </message>
    <message>
        <source>Put solver plugins into %1</source>
        <translation>Legen Sie Löser-Plugins in %1</translation>
    </message>
    <message>
        <source>Each project chooses its solver under Dipping. “Best available” takes the best that can run here.</source>
        <translation>Jedes Projekt wählt seinen Löser unter Tauchen. „Bester verfügbarer“ nimmt den besten, der hier laufen kann.</translation>
    </message>
    <message>
        <source>Looking whether it can run here …</source>
        <translation>Es wird nachgesehen, ob er hier laufen kann …</translation>
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
        <source>From a textured model to a film that can be printed.</source>
        <translation>Vom texturierten Modell zum druckbaren Film.</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>Neues Projekt …</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>Projekt öffnen …</translation>
    </message>
    <message>
        <source>Continue with a project that was saved.</source>
        <translation>Setzen Sie ein gespeichertes Projekt fort.</translation>
    </message>
    <message>
        <source>Quick Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>What is where, in six steps.</source>
        <translation>Was wo ist, in sechs Schritten.</translation>
    </message>
    <message>
        <source>Models and projects can also be dropped on the window.</source>
        <translation>Modelle und Projekte können auch auf das Fenster gezogen werden.</translation>
    </message>
    <message>
        <source>Start from a textured model: %1.</source>
        <translation>Beginnen Sie mit einem texturierten Modell: %1.</translation>
    </message>
</context>
<context>
    <name>dipwright::StatusLine</name>
    <message>
        <source>Value under the cursor</source>
        <translation>Wert unter dem Zeiger</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>It does not stop. Save your work; closing the window ends it.</source>
        <translation>Es hält nicht an. Speichern Sie Ihre Arbeit; wird das Fenster geschlossen, endet es.</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
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
        <source>Length of the film&apos;s threads after the dip over before: the mean round each point.</source>
        <translation>Länge der Fäden des Films nach dem Tauchen über der davor: das Mittel um jeden Punkt.</translation>
    </message>
    <message>
        <source>Area after over before. Ink thins by as much.</source>
        <translation>Fläche danach über davor. Um so viel wird die Farbe dünner.</translation>
    </message>
    <message>
        <source>The stretch in the direction in which it is largest.</source>
        <translation>Die Dehnung in der Richtung, in der sie am größten ist.</translation>
    </message>
    <message>
        <source>The stretch in the direction in which it is smallest. Below 1 the film wrinkles.</source>
        <translation>Die Dehnung in der Richtung, in der sie am kleinsten ist. Unter 1 wirft der Film Falten.</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>Farbtafel</translation>
    </message>
    <message>
        <source>Colour map; all are safe for colour-blind readers.</source>
        <translation>Farbtafel; alle sind für Farbenblinde lesbar.</translation>
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
        <source>On the body: mean %1 · 95 % below %2 · largest %3</source>
        <translation>Auf dem Körper: Mittel %1 · 95 % unter %2 · größte %3</translation>
    </message>
    <message>
        <source>What the map shows.</source>
        <translation>Was die Karte zeigt.</translation>
    </message>
    <message>
        <source>The colours span what occurs on the body. Without it they span the two numbers on the right, so that maps can be compared.</source>
        <translation>Die Farben umfassen, was auf dem Körper vorkommt. Sonst umfassen sie die beiden Zahlen rechts, sodass sich Karten vergleichen lassen.</translation>
    </message>
    <message>
        <source>Shows all film over the limit in one warning colour.</source>
        <translation>Zeigt allen Film über der Grenze in einer Warnfarbe.</translation>
    </message>
    <message>
        <source>Lines of equal value on the map.</source>
        <translation>Linien gleichen Wertes auf der Karte.</translation>
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
        <source>The picture is damaged: %1; save it anew</source>
        <translation>Das Bild ist beschädigt: %1; speichern Sie es neu</translation>
    </message>
    <message>
        <source>%1, with %2 × %3 pixels</source>
        <translation>%1, mit %2 × %3 Pixeln</translation>
    </message>
    <message>
        <source>The picture&apos;s ICC profile is damaged or not for its pixels; save it anew, as sRGB</source>
        <translation>Das ICC-Profil des Bildes ist beschädigt oder nicht für seine Pixel; speichern Sie es neu, als sRGB</translation>
    </message>
    <message>
        <source>The picture in CMYK is damaged, or kept in a way that is not read; save it anew as JPEG, or as TIFF without tiles and planes</source>
        <translation>Das Bild in CMYK ist beschädigt oder auf eine Art abgelegt, die nicht gelesen wird; speichern Sie es neu als JPEG, oder als TIFF ohne Kacheln und Ebenen</translation>
    </message>
    <message>
        <source>The picture is damaged: its ICC profile is cut off; save it anew</source>
        <translation>Das Bild ist beschädigt: Sein ICC-Profil ist abgeschnitten; speichern Sie es neu</translation>
    </message>
    <message>
        <source>Pictures in HEIF are not read here; save it as JPEG, or let the camera write JPEG</source>
        <translation>Bilder in HEIF werden hier nicht gelesen; speichern Sie es als JPEG, oder lassen Sie die Kamera JPEG schreiben</translation>
    </message>
    <message>
        <source>The picture&apos;s ICC profile is larger than %1 MB; save it anew, as sRGB</source>
        <translation>Das ICC-Profil des Bildes ist größer als %1 MB; speichern Sie es neu, als sRGB</translation>
    </message>
    <message>
        <source>The picture is cut off before its end; save it anew, or copy it again from where it came</source>
        <translation>Das Bild ist vor seinem Ende abgeschnitten; speichern Sie es neu oder kopieren Sie es noch einmal von dort, woher es kam</translation>
    </message>
    <message>
        <source>The photo is cut off in the middle; copy it from the camera again</source>
        <translation>Das Foto ist mittendrin abgeschnitten; kopieren Sie es noch einmal von der Kamera</translation>
    </message>
    <message>
        <source>The picture in Lab is damaged, or kept in a way that is not read; save it anew as RGB, or as TIFF in 8 or 16 bits without tiles and planes</source>
        <translation>Das Bild in Lab ist beschädigt oder so gespeichert, wie es nicht gelesen wird; speichern Sie es neu als RGB oder als TIFF in 8 oder 16 Bit ohne Kacheln und Ebenen</translation>
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
        <source>How far the lowest point of the body is under the waterline</source>
        <translation>Wie weit der tiefste Punkt des Körpers unter der Wasserlinie ist</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
</context>
<context>
    <name>dipwright::ToleranceCheck</name>
    <message>
        <source>Telling the tolerances</source>
        <translation>Toleranzen werden berechnet</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
</context>
<context>
    <name>dipwright::ToleranceDialog</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>Hälfte</translation>
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
        <source>Border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>What each contributor does</source>
        <translation>Was jede Abweichung bewirkt</translation>
    </message>
    <message>
        <source>The tolerance, to either side</source>
        <translation>Die Toleranz, nach beiden Seiten</translation>
    </message>
    <message>
        <source>Its part in how far colours land off their places</source>
        <translation>Ihr Anteil daran, wie weit Farben neben ihrem Ort landen</translation>
    </message>
    <message>
        <source>How far off, by itself, half of what is painted is at most</source>
        <translation>Wie weit die Hälfte des Bemalten davon allein höchstens daneben liegt</translation>
    </message>
    <message>
        <source>How far off, by itself, 95 % of what is painted is at most</source>
        <translation>Wie weit 95 % des Bemalten davon allein höchstens daneben liegen</translation>
    </message>
    <message>
        <source>How far off, by itself, the worst place is</source>
        <translation>Wie weit der schlechteste Ort davon allein daneben liegt</translation>
    </message>
    <message>
        <source>How much less, or more, of the body is painted at the border</source>
        <translation>Wie viel weniger oder mehr vom Körper am Rand bemalt wird</translation>
    </message>
    <message>
        <source>All together: 95 % of what is painted lands within %1 of its place, half of it within %2.</source>
        <translation>Alles zusammen: 95 % des Bemalten landen innerhalb von %1 um ihren Ort, die Hälfte innerhalb von %2.</translation>
    </message>
    <message>
        <source>Tolerance of the sheet</source>
        <translation>Toleranz des Bogens</translation>
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
        <source>These are the figures of the project as it was before the last changes.</source>
        <translation>Dies sind die Zahlen des Projekts, wie es vor den letzten Änderungen war.</translation>
    </message>
    <message>
        <source>%1 at %2 of the model, most by: %3</source>
        <translation>%1 bei %2 des Modells, am meisten durch: %3</translation>
    </message>
</context>
<context>
    <name>dipwright::Tour</name>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
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
    <name>dipwright::ViewController</name>
    <message>
        <source>Picture on the Film</source>
        <translation>Bild auf dem Film</translation>
    </message>
    <message>
        <source>Reading the picture</source>
        <translation>Bild wird gelesen</translation>
    </message>
</context>
<context>
    <name>dipwright::WatchPage</name>
    <message>
        <source>Film watch: print this on the film</source>
        <translation>Filmmessung: dies auf den Film drucken</translation>
    </message>
    <message>
        <source>Card of the film watch: print this on stiff, waterproof card</source>
        <translation>Karte der Filmmessung: dies auf steifen, wasserfesten Karton drucken</translation>
    </message>
    <message>
        <source>Ink side: this side up on the water, the words to be read from above.</source>
        <translation>Farbseite: diese Seite nach oben aufs Wasser, die Wörter von oben zu lesen.</translation>
    </message>
    <message>
        <source>Lay it flat on the water beside the film, this side up, in every photo.</source>
        <translation>Auf jedem Foto flach neben dem Film auf dem Wasser, diese Seite nach oben.</translation>
    </message>
    <message>
        <source>Both rulers must measure %1 mm; if not, say what they do measure when the photos are looked at.</source>
        <translation>Beide Lineale müssen %1 mm messen; wenn nicht, geben Sie an, was sie messen, wenn die Fotos ausgewertet werden.</translation>
    </message>
    <message>
        <source>Date %1   Lot %2   Water %3 °C</source>
        <translation>Datum %1   Charge %2   Wasser %3 °C</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm has no room for a chessboard with %3 corners; take a larger one</source>
        <translation>Papier von %1 × %2 mm hat keinen Platz für ein Schachbrett mit %3 Ecken; nehmen Sie ein größeres</translation>
    </message>
</context>
<context>
    <name>dipwright::WedgePage</name>
    <message>
        <source>Paper of %1 × %2 mm has no room for the wedge; take a larger one</source>
        <translation>Auf Papier von %1 × %2 mm hat der Keil keinen Platz; nehmen Sie ein größeres</translation>
    </message>
    <message>
        <source>Ink wedge: print this on the film as a sheet is printed</source>
        <translation>Tintenkeil: wie einen Bogen auf den Film drucken</translation>
    </message>
    <message>
        <source>1. Zero the densitometer on unprinted film. Read every patch before the dip.</source>
        <translation>1. Densitometer auf unbedrucktem Film auf null stellen. Jedes Feld vor dem Tauchen messen.</translation>
    </message>
    <message>
        <source>2. Stretch the film: on a body, or floating, by hand. Measure both rulers; %1 mm is no stretch.</source>
        <translation>2. Film dehnen: auf einem Körper oder schwimmend von Hand. Beide Lineale messen; %1 mm heißt ungedehnt.</translation>
    </message>
    <message>
        <source>3. Read every patch again. Best at three or four stretches up to the job&apos;s.</source>
        <translation>3. Jedes Feld noch einmal messen. Am besten bei drei oder vier Dehnungen bis zu der des Auftrags.</translation>
    </message>
    <message>
        <source>Date %1   Lot %2</source>
        <translation>Datum %1   Charge %2</translation>
    </message>
</context>
<context>
    <name>dipwright::WedgeTable</name>
    <message>
        <source>The table of a wedge begins with the line %1 and has at most %2 lines</source>
        <translation>Die Tabelle eines Keils beginnt mit der Zeile %1 und hat höchstens %2 Zeilen</translation>
    </message>
    <message>
        <source>Line %1 of the wedge is not an ink (cyan, magenta, yellow, black, white or grey) and five numbers, joined by commas</source>
        <translation>Zeile %1 des Keils ist nicht eine Tinte (cyan, magenta, yellow, black, white oder grey) und fünf Zahlen, durch Kommas verbunden</translation>
    </message>
</context>
<context>
    <name>dipwright::WeightFields</name>
    <message>
        <source>Counts</source>
        <translation>Zählt</translation>
    </message>
    <message>
        <source>Must be kept</source>
        <translation>Einzuhalten</translation>
    </message>
    <message>
        <source>Quality in zone %1</source>
        <translation>Güte in Zone %1</translation>
    </message>
    <message>
        <source>How much more the quality counts where the body is marked as this zone, under Tolerances.</source>
        <translation>Wie viel mehr die Güte zählt, wo der Körper unter Toleranzen als diese Zone markiert ist.</translation>
    </message>
    <message>
        <source>Weight of %1</source>
        <translation>Gewicht von %1</translation>
    </message>
    <message>
        <source>How much it counts against the others; 0: not at all.</source>
        <translation>Wie viel es gegen die anderen zählt; 0: gar nicht.</translation>
    </message>
    <message>
        <source>Limit of %1</source>
        <translation>Grenze von %1</translation>
    </message>
    <message>
        <source>Poses that miss it come after all that keep it.</source>
        <translation>Lagen, die sie verfehlen, kommen nach allen, die sie einhalten.</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowActions</name>
    <message>
        <source>New &amp;Window</source>
        <translation>Neues &amp;Fenster</translation>
    </message>
    <message>
        <source>Open another window</source>
        <translation>Ein weiteres Fenster öffnen</translation>
    </message>
    <message>
        <source>&amp;New Project…</source>
        <translation>&amp;Neues Projekt …</translation>
    </message>
    <message>
        <source>Make a project of a textured model</source>
        <translation>Ein Projekt aus einem texturierten Modell anlegen</translation>
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
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the project as another file</source>
        <translation>Das Projekt als andere Datei speichern</translation>
    </message>
    <message>
        <source>&amp;Export Results…</source>
        <translation>&amp;Ergebnisse exportieren …</translation>
    </message>
    <message>
        <source>Write sheets, stretch maps, proof, films and report to a folder</source>
        <translation>Bögen, Dehnungskarten, Vorschau, Filme und Bericht in einen Ordner schreiben</translation>
    </message>
    <message>
        <source>Sheet as P&amp;DF…</source>
        <translation>Bogen als P&amp;DF …</translation>
    </message>
    <message>
        <source>Save this immersion&apos;s sheet as PDF at true size</source>
        <translation>Den Bogen dieses Tauchvorgangs als PDF in wahrer Größe speichern</translation>
    </message>
    <message>
        <source>Sheet as P&amp;NG…</source>
        <translation>Bogen als P&amp;NG …</translation>
    </message>
    <message>
        <source>Save this immersion&apos;s film image as PNG</source>
        <translation>Das Filmbild dieses Tauchvorgangs als PNG speichern</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>Print sheets at true size</source>
        <translation>Bögen in wahrer Größe drucken</translation>
    </message>
    <message>
        <source>Calibrate P&amp;rinter…</source>
        <translation>D&amp;rucker kalibrieren …</translation>
    </message>
    <message>
        <source>Print a page of rulers and put the printer&apos;s scale into its profile</source>
        <translation>Eine Seite mit Linealen drucken und den Maßstab des Druckers in sein Profil übernehmen</translation>
    </message>
    <message>
        <source>Pro&amp;files…</source>
        <translation>Pro&amp;file …</translation>
    </message>
    <message>
        <source>What is known of printers, films and tanks</source>
        <translation>Was über Drucker, Filme und Becken bekannt ist</translation>
    </message>
    <message>
        <source>&amp;Close Window</source>
        <translation>Fenster s&amp;chließen</translation>
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
        <source>Take back the last change</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Die Änderung noch einmal machen</translation>
    </message>
    <message>
        <source>Add &amp;Second Immersion</source>
        <translation>&amp;Zweiten Tauchvorgang hinzufügen</translation>
    </message>
    <message>
        <source>Dip the body a second time, from another side</source>
        <translation>Den Körper ein zweites Mal tauchen, von einer anderen Seite</translation>
    </message>
    <message>
        <source>Remove &amp;Immersion</source>
        <translation>&amp;Tauchvorgang entfernen</translation>
    </message>
    <message>
        <source>Remove the immersion shown</source>
        <translation>Den gezeigten Tauchvorgang entfernen</translation>
    </message>
    <message>
        <source>Re&amp;load Model</source>
        <translation>Modell neu &amp;laden</translation>
    </message>
    <message>
        <source>Read the model&apos;s file again and keep all settings</source>
        <translation>Die Datei des Modells neu lesen und alle Einstellungen behalten</translation>
    </message>
    <message>
        <source>Replace &amp;Model…</source>
        <translation>&amp;Modell ersetzen …</translation>
    </message>
    <message>
        <source>Take another model</source>
        <translation>Ein anderes Modell nehmen</translation>
    </message>
    <message>
        <source>Replace &amp;Texture…</source>
        <translation>Te&amp;xtur ersetzen …</translation>
    </message>
    <message>
        <source>Put another picture on the model</source>
        <translation>Ein anderes Bild auf das Modell legen</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>Units, language, look, shortcuts and solvers</source>
        <translation>Einheiten, Sprache, Aussehen, Tastenkürzel und Löser</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>Simulate the dip and make the sheets</source>
        <translation>Den Tauchvorgang simulieren und die Bögen machen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Stop what is running</source>
        <translation>Anhalten, was läuft</translation>
    </message>
    <message>
        <source>Run &amp;Live</source>
        <translation>&amp;Mitlaufen</translation>
    </message>
    <message>
        <source>Once there is a result, run again after each change</source>
        <translation>Sobald es ein Ergebnis gibt, nach jeder Änderung neu rechnen</translation>
    </message>
    <message>
        <source>C&amp;heck Certainty…</source>
        <translation>&amp;Verlässlichkeit prüfen …</translation>
    </message>
    <message>
        <source>Compute the sheets more finely and see how far they move, and where</source>
        <translation>Die Bögen feiner rechnen und sehen, wie weit sie sich verschieben und wo</translation>
    </message>
    <message>
        <source>&amp;Play or Pause</source>
        <translation>Abs&amp;pielen oder anhalten</translation>
    </message>
    <message>
        <source>Play the dip</source>
        <translation>Den Tauchvorgang abspielen</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Show body and film whole</source>
        <translation>Körper und Film ganz zeigen</translation>
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
        <source>&amp;Standard Layout</source>
        <translation>&amp;Standardanordnung</translation>
    </message>
    <message>
        <source>Put all panels back where they were at first</source>
        <translation>Alle Felder an ihren ersten Platz zurückstellen</translation>
    </message>
    <message>
        <source>&amp;Save Layout…</source>
        <translation>Anordnung &amp;speichern …</translation>
    </message>
    <message>
        <source>Keep where the panels are under a name</source>
        <translation>Die Anordnung der Bereiche unter einem Namen behalten</translation>
    </message>
    <message>
        <source>&amp;Parallel Projection</source>
        <translation>&amp;Parallelprojektion</translation>
    </message>
    <message>
        <source>Show equal lengths equally long, near or far</source>
        <translation>Gleiche Längen gleich lang zeigen, nah oder fern</translation>
    </message>
    <message>
        <source>&amp;Water and Tank</source>
        <translation>&amp;Wasser und Becken</translation>
    </message>
    <message>
        <source>Show the water and the edges of the tank</source>
        <translation>Das Wasser und die Kanten des Beckens zeigen</translation>
    </message>
    <message>
        <source>Bo&amp;dy</source>
        <translation>&amp;Körper</translation>
    </message>
    <message>
        <source>Show the body</source>
        <translation>Den Körper zeigen</translation>
    </message>
    <message>
        <source>&amp;Coverage on the Body</source>
        <translation>&amp;Abdeckung auf dem Körper</translation>
    </message>
    <message>
        <source>Film on the Body &amp;Only</source>
        <translation>&amp;Nur Film auf dem Körper</translation>
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
        <source>Click two places on the body to measure the distance between them</source>
        <translation>Klicken Sie zwei Stellen auf dem Körper an, um ihren Abstand zu messen</translation>
    </message>
    <message>
        <source>What the film wears in the view</source>
        <translation>Was der Film in der Ansicht trägt</translation>
    </message>
    <message>
        <source>&amp;Lines every 10 mm</source>
        <translation>&amp;Linien alle 10 mm</translation>
    </message>
    <message>
        <source>The &amp;Sheet&apos;s Image</source>
        <translation>Das Bild des &amp;Bogens</translation>
    </message>
    <message>
        <source>S&amp;tretch</source>
        <translation>&amp;Dehnung</translation>
    </message>
    <message>
        <source>&amp;Chessboard of 17 mm</source>
        <translation>&amp;Schachbrett von 17 mm</translation>
    </message>
    <message>
        <source>A &amp;Picture…</source>
        <translation>Ein B&amp;ild …</translation>
    </message>
    <message>
        <source>Quick &amp;Tour</source>
        <translation>&amp;Rundgang</translation>
    </message>
    <message>
        <source>What is where, in six steps</source>
        <translation>Was wo ist, in sechs Schritten</translation>
    </message>
    <message>
        <source>User &amp;Guide</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>&amp;What Is This?</source>
        <translation>&amp;Was ist das?</translation>
    </message>
    <message>
        <source>Click something afterwards to be told what it is for</source>
        <translation>Klicken Sie danach auf etwas, um zu erfahren, wozu es dient</translation>
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
        <source>Crad&amp;les…</source>
        <translation>&amp;Halterungen …</translation>
    </message>
    <message>
        <source>Make what holds the body in each dip, as STL and 3MF to print in plastic</source>
        <translation>Machen, was den Körper in jedem Tauchvorgang hält, als STL und 3MF zum Drucken in Kunststoff</translation>
    </message>
    <message>
        <source>Show what the dips paint of the body</source>
        <translation>Zeigt, was die Tauchvorgänge vom Körper färben</translation>
    </message>
    <message>
        <source>&amp;Print on the Body</source>
        <translation>&amp;Druck auf dem Körper</translation>
    </message>
    <message>
        <source>Show the body as it comes out of all dips, from every side</source>
        <translation>Zeigt den Körper, wie er aus allen Tauchvorgängen kommt, von allen Seiten</translation>
    </message>
    <message>
        <source>S&amp;wap Immersions</source>
        <translation>Tauchvorgänge &amp;tauschen</translation>
    </message>
    <message>
        <source>Make the second dip the first one</source>
        <translation>Macht den zweiten Tauchvorgang zum ersten</translation>
    </message>
    <message>
        <source>&amp;Who Paints What</source>
        <translation>&amp;Wer was färbt</translation>
    </message>
    <message>
        <source>&amp;Tolerances…</source>
        <translation>&amp;Toleranzen …</translation>
    </message>
    <message>
        <source>See how far colours land off their places for what is off, and which zones keep their limits</source>
        <translation>Zeigt, wie weit Farben durch Abweichungen neben ihrem Ort landen und welche Zonen ihre Grenzen einhalten</translation>
    </message>
    <message>
        <source>&amp;Zones on the Body</source>
        <translation>&amp;Zonen auf dem Körper</translation>
    </message>
    <message>
        <source>Show the zones of the body and, once tolerances are told, where they keep their limits</source>
        <translation>Zeigt die Zonen des Körpers und, sobald die Toleranzen berechnet sind, wo sie ihre Grenzen einhalten</translation>
    </message>
    <message>
        <source>&amp;Find Poses…</source>
        <translation>Lagen &amp;suchen …</translation>
    </message>
    <message>
        <source>Search how the body is best turned and moved, for one dip or two</source>
        <translation>Sucht, wie der Körper am besten gedreht und verschoben wird, für einen Tauchvorgang oder zwei</translation>
    </message>
    <message>
        <source>Print &amp;History…</source>
        <translation>Druck&amp;verlauf …</translation>
    </message>
    <message>
        <source>See what was printed when, on what, and from which project</source>
        <translation>Sehen, was wann worauf und aus welchem Projekt gedruckt wurde</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>Schni&amp;tt</translation>
    </message>
    <message>
        <source>Cut body and film open by a plane that a slider or its frame moves</source>
        <translation>Körper und Film an einer Ebene aufschneiden, die ein Regler oder ihr Rahmen verschiebt</translation>
    </message>
    <message>
        <source>S&amp;ee-Through Film</source>
        <translation>&amp;Durchsichtiger Film</translation>
    </message>
    <message>
        <source>See the body through the film</source>
        <translation>Den Körper durch den Film hindurch sehen</translation>
    </message>
    <message>
        <source>Snapsho&amp;ts…</source>
        <translation>Schnappschüsse …</translation>
    </message>
    <message>
        <source>Keep the project&apos;s settings under a name, compare them, and go back</source>
        <translation>Die Einstellungen des Projekts unter einem Namen behalten, vergleichen und zurückgehen</translation>
    </message>
    <message>
        <source>&amp;Job Queue…</source>
        <translation>&amp;Warteschlange …</translation>
    </message>
    <message>
        <source>Run several projects one after the other, and go on working</source>
        <translation>Mehrere Projekte nacheinander rechnen und weiterarbeiten</translation>
    </message>
    <message>
        <source>Turn the body by 15°</source>
        <translation>Den Körper um 15° drehen</translation>
    </message>
    <message>
        <source>Move the body over the film</source>
        <translation>Den Körper über dem Film verschieben</translation>
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
        <source>Move to the &amp;Right by 5 mm</source>
        <translation>5 mm nach &amp;rechts schieben</translation>
    </message>
    <message>
        <source>Move to the &amp;Left by 5 mm</source>
        <translation>5 mm nach &amp;links schieben</translation>
    </message>
    <message>
        <source>Move &amp;Up the Sheet by 5 mm</source>
        <translation>5 mm den Bogen hin&amp;auf schieben</translation>
    </message>
    <message>
        <source>Move &amp;Down the Sheet by 5 mm</source>
        <translation>5 mm den Bogen hin&amp;unter schieben</translation>
    </message>
    <message>
        <source>Move to the Film&apos;s &amp;Middle</source>
        <translation>In die &amp;Mitte des Films schieben</translation>
    </message>
    <message>
        <source>How everything works, beginning with what has the focus</source>
        <translation>Wie alles geht, beginnend mit dem, was den Fokus hat</translation>
    </message>
    <message>
        <source>Several Jobs on One &amp;Film…</source>
        <translation>Mehrere Aufträge auf einem &amp;Film…</translation>
    </message>
    <message>
        <source>Lay the sheets of several projects, and copies, side by side on a film or roll</source>
        <translation>Die Bögen mehrerer Projekte, und mehrere Exemplare, nebeneinander auf einen Film oder eine Rolle legen</translation>
    </message>
    <message>
        <source>&amp;Artwork</source>
        <translation>&amp;Gestaltung</translation>
    </message>
    <message>
        <source>Lay pictures, text and patterns on the body</source>
        <translation>Bilder, Text und Muster auf den Körper legen</translation>
    </message>
    <message>
        <source>Rings and Arr&amp;ows</source>
        <translation>Ringe un&amp;d Pfeile</translation>
    </message>
    <message>
        <source>Show the rings that turn the body and the arrows that move it</source>
        <translation>Die Ringe zeigen, die den Körper drehen, und die Pfeile, die ihn verschieben</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowLayout</name>
    <message>
        <source>3D view of the dip</source>
        <translation>3D-Ansicht des Tauchvorgangs</translation>
    </message>
    <message>
        <source>The body above the film. Drag to turn the view, drag with the right button to shift it, turn the wheel to zoom. Drag a ring to turn the body.</source>
        <translation>Der Körper über dem Film. Ziehen dreht die Ansicht, Ziehen mit der rechten Taste verschiebt sie, das Rad zoomt. Ein Zug am Ring dreht den Körper.</translation>
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
        <source>Save Layout</source>
        <translation>Anordnung speichern</translation>
    </message>
    <message>
        <source>Name of the layout</source>
        <translation>Name der Anordnung</translation>
    </message>
    <message>
        <source>None saved yet</source>
        <translation>Noch keine gespeichert</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
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
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Film &amp;Wears</source>
        <translation>Film &amp;trägt</translation>
    </message>
    <message>
        <source>&amp;Layouts</source>
        <translation>Anord&amp;nungen</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Haupt</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>What the film wears in the view</source>
        <translation>Was der Film in der Ansicht trägt</translation>
    </message>
    <message>
        <source>Turn &amp;Body</source>
        <translation>&amp;Körper drehen</translation>
    </message>
    <message>
        <source>Mo&amp;ve Body</source>
        <translation>Körper &amp;verschieben</translation>
    </message>
    <message>
        <source>Film appearance</source>
        <translation>Aussehen des Films</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowMessages</name>
    <message>
        <source>Read Them</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Read them only if they belong to the model. A stranger&apos;s model or project may name private files, so that they travel on inside the project.</source>
        <translation>Lesen Sie sie nur, wenn sie zum Modell gehören. Ein Modell oder Projekt von Fremden kann private Dateien nennen, damit sie im Projekt mit weiterreisen.</translation>
    </message>
</context>
<context>
    <name>dipwright::Workbench</name>
    <message>
        <source>Restore Project</source>
        <translation>Projekt wiederherstellen</translation>
    </message>
    <message>
        <source>Dipwright was not closed properly. “%1” has changes that were not saved, from %2.</source>
        <translation>Dipwright wurde nicht ordentlich beendet. „%1“ hat Änderungen, die nicht gespeichert wurden, von %2.</translation>
    </message>
    <message>
        <source>It was never saved as a file.</source>
        <translation>Es wurde nie als Datei gespeichert.</translation>
    </message>
    <message>
        <source>Its file %1 is as it was last saved.</source>
        <translation>Seine Datei %1 ist, wie sie zuletzt gespeichert wurde.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard Changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Decide Later</source>
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
        <source>What a click or a drag on the body in the view marks. Zone A is to be painted most exactly; what is not marked is zone C.</source>
        <translation>Was ein Klick oder ein Zug auf dem Körper in der Ansicht markiert. Zone A ist am genauesten zu färben; was nicht markiert ist, ist Zone C.</translation>
    </message>
    <message>
        <source>How far</source>
        <translation>Wie weit</translation>
    </message>
    <message>
        <source>A spot</source>
        <translation>Ein Fleck</translation>
    </message>
    <message>
        <source>The whole face</source>
        <translation>Die ganze Fläche</translation>
    </message>
    <message>
        <source>All of the material</source>
        <translation>Alles von diesem Material</translation>
    </message>
    <message>
        <source>How far round the click the mark reaches: a radius along the surface, the face up to its edges, or all that has the same material in the model.</source>
        <translation>Wie weit um den Klick die Marke reicht: ein Radius entlang der Oberfläche, die Fläche bis zu ihren Kanten oder alles, was im Modell dasselbe Material hat.</translation>
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
