<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>App::Property</name>
    <message>
        <source>Distance of neighbouring dimples; 0: from the other sizes</source>
        <translation>Abstand benachbarter Mulden; 0: aus den anderen Größen</translation>
    </message>
    <message>
        <source>Overlapping: the dimples&apos; bottoms are the faces; isolated: the faces stay between dimples</source>
        <translation>Überlappend: der Grund der Mulden ist die Fläche; einzeln: die Fläche bleibt zwischen den Mulden stehen</translation>
    </message>
    <message>
        <source>Depth of the dimples; 0: from the other sizes</source>
        <translation>Tiefe der Mulden; 0: aus den anderen Größen</translation>
    </message>
    <message>
        <source>Diameter of a dimple&apos;s rim; 0: from the other sizes</source>
        <translation>Durchmesser des Randes einer Mulde; 0: aus den anderen Größen</translation>
    </message>
    <message>
        <source>Share of the faces that isolated dimples take up, 0 to 1; 0: from the other sizes</source>
        <translation>Anteil der Flächen, den einzelne Mulden einnehmen, 0 bis 1; 0: aus den anderen Größen</translation>
    </message>
    <message>
        <source>Height of what stays between neighbouring dimples; 0: from the other sizes</source>
        <translation>Höhe dessen, was zwischen benachbarten Mulden stehen bleibt; 0: aus den anderen Größen</translation>
    </message>
    <message>
        <source>Shape of the patches: squares and rectangles on a square lattice, the others on a triangular one</source>
        <translation>Form der Felder: Quadrate und Rechtecke auf einem quadratischen Gitter, die anderen auf einem dreieckigen</translation>
    </message>
    <message>
        <source>Dimples along the side of a square or triangle; radius of a hexagon in dimples</source>
        <translation>Mulden entlang der Seite eines Quadrats oder Dreiecks; Radius eines Sechsecks in Mulden</translation>
    </message>
    <message>
        <source>Dimples along the other side of a patch whose sides may differ; 0: as the first side</source>
        <translation>Mulden entlang der anderen Seite eines Felds, dessen Seiten verschieden sein können; 0: wie die erste Seite</translation>
    </message>
    <message>
        <source>Patches along X; 0 covers the faces</source>
        <translation>Felder entlang X; 0 bedeckt die Flächen</translation>
    </message>
    <message>
        <source>Patches along Y; 0 covers the faces</source>
        <translation>Felder entlang Y; 0 bedeckt die Flächen</translation>
    </message>
    <message>
        <source>Mill each patch from its outline inwards, or from its centre outwards</source>
        <translation>Jedes Feld von außen nach innen oder von der Mitte nach außen fräsen</translation>
    </message>
    <message>
        <source>Begin all patches at the same corner, or at the corner nearest to the patch before</source>
        <translation>Alle Felder an derselben Ecke beginnen, oder an der Ecke, die dem vorigen Feld am nächsten ist</translation>
    </message>
    <message>
        <source>Rows run over the whole face, across the borders of patches, or inside each patch</source>
        <translation>Zeilen laufen über die ganze Fläche, über die Grenzen der Felder hinweg, oder innerhalb jedes Felds</translation>
    </message>
    <message>
        <source>Direction of the lattice that rows go along: the one of the least time (each is planned), the one nearest to the texture&apos;s X or Y, or the one along which the faces bend least</source>
        <translation>Richtung des Gitters, der die Zeilen folgen: die mit der kürzesten Zeit (jede wird geplant), die nächste zu X oder Y der Textur, oder die, entlang der sich die Flächen am wenigsten krümmen</translation>
    </message>
    <message>
        <source>Mill all rows in the same sense; otherwise to and fro</source>
        <translation>Alle Zeilen im selben Sinn fräsen; sonst hin und her</translation>
    </message>
    <message>
        <source>Number of the patch, in milling order, with which the program begins; 1: all are milled</source>
        <translation>Nummer des Felds, in der Reihenfolge des Fräsens, mit dem das Programm beginnt; 1: alle werden gefräst</translation>
    </message>
    <message>
        <source>Begin each patch with a comment that has its number</source>
        <translation>Jedes Feld mit einem Kommentar beginnen, der seine Nummer nennt</translation>
    </message>
    <message>
        <source>Direction in which the texture is projected on the faces</source>
        <translation>Richtung, in der die Textur auf die Flächen projiziert wird</translation>
    </message>
    <message>
        <source>Project on the faces from the side on which they look largest</source>
        <translation>Von der Seite auf die Flächen projizieren, von der sie am größten erscheinen</translation>
    </message>
    <message>
        <source>Rotation of the texture</source>
        <translation>Drehung der Textur</translation>
    </message>
    <message>
        <source>Centre the texture on the faces</source>
        <translation>Die Textur auf den Flächen zentrieren</translation>
    </message>
    <message>
        <source>Centre of the texture, if not automatic</source>
        <translation>Mitte der Textur, wenn nicht automatisch</translation>
    </message>
    <message>
        <source>Dimples where the face is steeper than this to the projection are left out</source>
        <translation>Mulden, wo die Fläche steiler als dies zur Projektion steht, werden ausgelassen</translation>
    </message>
    <message>
        <source>Dimples where the tool axis is nearer to the normal than this are left out: the tip rubs</source>
        <translation>Mulden, wo die Werkzeugachse der Normalen näher ist als dies, werden ausgelassen: die Spitze reibt</translation>
    </message>
    <message>
        <source>Leave out dimples in which the tip of the ball, which does not cut, would rub</source>
        <translation>Mulden auslassen, in denen die Spitze der Kugel, die nicht schneidet, reiben würde</translation>
    </message>
    <message>
        <source>Dimples nearer than this to the border of the faces are left out</source>
        <translation>Mulden, die näher am Rand der Flächen liegen, werden ausgelassen</translation>
    </message>
    <message>
        <source>Patches with fewer dimples than this on the faces are left out</source>
        <translation>Felder mit weniger Mulden als dies auf den Flächen werden ausgelassen</translation>
    </message>
    <message>
        <source>What a picture or closed curves do: leave dimples out, thin them, or set their depth</source>
        <translation>Was ein Bild oder geschlossene Kurven tun: Mulden auslassen, ausdünnen oder ihre Tiefe bestimmen</translation>
    </message>
    <message>
        <source>Picture: white is milled, black is not</source>
        <translation>Bild: Weiß wird gefräst, Schwarz nicht</translation>
    </message>
    <message>
        <source>Sketches or wires: inside is milled, outside is not; used if there is no picture</source>
        <translation>Skizzen oder Drähte: innen wird gefräst, außen nicht; gilt, wenn es kein Bild gibt</translation>
    </message>
    <message>
        <source>Change black for white, inside for outside</source>
        <translation>Schwarz und Weiß, innen und außen vertauschen</translation>
    </message>
    <message>
        <source>Width of the picture on the texture plane; 0: as large as fits the faces</source>
        <translation>Breite des Bilds auf der Ebene der Textur; 0: so groß, wie es auf die Flächen passt</translation>
    </message>
    <message>
        <source>Centre of the picture from the texture&apos;s own, along its X and Y</source>
        <translation>Mitte des Bilds von der der Textur aus, entlang ihrer X- und Y-Richtung</translation>
    </message>
    <message>
        <source>Grey below which dimples are left out, 0 (black) to 1 (white)</source>
        <translation>Grau, unter dem Mulden ausgelassen werden, 0 (schwarz) bis 1 (weiß)</translation>
    </message>
    <message>
        <source>Depth of dimples where it is black</source>
        <translation>Tiefe der Mulden, wo es schwarz ist</translation>
    </message>
    <message>
        <source>Depth of dimples where it is white</source>
        <translation>Tiefe der Mulden, wo es weiß ist</translation>
    </message>
    <message>
        <source>How the spindle&apos;s phase is kept</source>
        <translation>Wie die Phase der Spindel gehalten wird</translation>
    </message>
    <message>
        <source>Name of the machine file; empty: unknown</source>
        <translation>Name der Maschinendatei; leer: unbekannt</translation>
    </message>
    <message>
        <source>Post even if the machine cannot hold the phase</source>
        <translation>Ausgeben, auch wenn die Maschine die Phase nicht halten kann</translation>
    </message>
    <message>
        <source>Ball and flutes may cut so deep below the model, besides the texture itself</source>
        <translation>So tief dürfen Kugel und Schneiden unter das Modell schneiden, außer der Textur selbst</translation>
    </message>
    <message>
        <source>Shank and holder must keep so far away from the model</source>
        <translation>So weit müssen Schaft und Halter vom Modell entfernt bleiben</translation>
    </message>
    <message>
        <source>How far the tool stands out of its holder; 0: the tool bit&apos;s length</source>
        <translation>Wie weit das Werkzeug aus dem Halter ragt; 0: die Länge des Werkzeugs</translation>
    </message>
    <message>
        <source>Diameter of the holder, for the collision check; 0: no holder</source>
        <translation>Durchmesser des Halters, für die Kollisionsprüfung; 0: kein Halter</translation>
    </message>
    <message>
        <source>Length of the holder, for the collision check</source>
        <translation>Länge des Halters, für die Kollisionsprüfung</translation>
    </message>
    <message>
        <source>Post even if the tool gouges or collides, or if that is not known</source>
        <translation>Ausgeben, auch wenn das Werkzeug das Teil verletzt oder kollidiert, oder wenn das nicht bekannt ist</translation>
    </message>
    <message>
        <source>Fixed axis, surface normal with lead and tilt, fixed axis but leaned away from the normal, or field</source>
        <translation>Feste Achse, Flächennormale mit Voreil- und Seitenwinkel, feste Achse mit Abstand von der Normalen, oder Feld</translation>
    </message>
    <message>
        <source>Direction from the tip to the holder; other than Z it needs rotary axes</source>
        <translation>Richtung von der Spitze zum Halter; eine andere als Z braucht Drehachsen</translation>
    </message>
    <message>
        <source>Lean from the normal towards the feed</source>
        <translation>Neigung von der Normalen zum Vorschub hin</translation>
    </message>
    <message>
        <source>Lean from the normal to the left of the feed</source>
        <translation>Neigung von der Normalen nach links vom Vorschub</translation>
    </message>
    <message>
        <source>Least angle between tool axis and normal, so that the tip does not cut</source>
        <translation>Kleinster Winkel zwischen Werkzeugachse und Normale, damit die Spitze nicht schneidet</translation>
    </message>
    <message>
        <source>Direction that the lead leans towards instead of the feed; zero: the feed</source>
        <translation>Richtung, zu der statt zum Vorschub geneigt wird; null: der Vorschub</translation>
    </message>
    <message>
        <source>DCM modifier whose voxel model gives the axes; none: the job&apos;s stock less its model</source>
        <translation>DCM-Modifikator, dessen Voxelmodell die Achsen gibt; keiner: das Rohteil des Auftrags ohne sein Modell</translation>
    </message>
    <message>
        <source>Side of a voxel if no modifier is named</source>
        <translation>Kante eines Voxels, wenn kein Modifikator genannt ist</translation>
    </message>
    <message>
        <source>By how much an axis may be drawn towards its neighbours&apos;</source>
        <translation>Um wie viel eine Achse zu denen ihrer Nachbarn gezogen werden darf</translation>
    </message>
    <message>
        <source>Greatest angle of the axis to Z</source>
        <translation>Größter Winkel der Achse zu Z</translation>
    </message>
    <message>
        <source>Spindle-locked rows keep one axis; greatest angle between it and the one asked for (half of it is used to turn less from row to row)</source>
        <translation>An die Spindel gekoppelte Zeilen behalten eine Achse; größter Winkel zwischen ihr und der gewünschten (die Hälfte davon dient dazu, von Zeile zu Zeile weniger zu drehen)</translation>
    </message>
    <message>
        <source>Whether the controller keeps the tool point (TCP), or the program is referred to the pivots</source>
        <translation>Ob die Steuerung die Werkzeugspitze führt (TCP), oder das Programm auf die Drehpunkte bezogen ist</translation>
    </message>
    <message>
        <source>Length from the spindle&apos;s gauge point to the tip, for tilting heads without TCP</source>
        <translation>Länge vom Bezugspunkt der Spindel zur Spitze, für Schwenkköpfe ohne TCP</translation>
    </message>
    <message>
        <source>Clearance of paced paths between rows</source>
        <translation>Abheben getakteter Bahnen zwischen Zeilen</translation>
    </message>
    <message>
        <source>One flute makes all dimples</source>
        <translation>Eine Schneide macht alle Mulden</translation>
    </message>
    <message>
        <source>Spindle turns added between dimples</source>
        <translation>Zwischen Mulden eingefügte Umdrehungen der Spindel</translation>
    </message>
    <message>
        <source>Angle added per dimple, for calibration</source>
        <translation>Je Mulde hinzugefügter Winkel, zum Kalibrieren</translation>
    </message>
    <message>
        <source>Decimals of the posted coordinates; must be the post&apos;s own</source>
        <translation>Nachkommastellen der ausgegebenen Koordinaten; es müssen die des Postprozessors sein</translation>
    </message>
    <message>
        <source>Greatest phase error of the posted program</source>
        <translation>Größter Phasenfehler des ausgegebenen Programms</translation>
    </message>
    <message>
        <source>Each patch&apos;s plane fits its dimples on the faces best, or goes through its corners there</source>
        <translation>Die Ebene jedes Felds passt am besten zu seinen Mulden auf den Flächen, oder geht dort durch seine Ecken</translation>
    </message>
    <message>
        <source>Lattice: dimples are placed; free: marks fall as side, cross-feed and feed make them</source>
        <translation>Gitter: Mulden werden gesetzt; frei: Spuren fallen, wie Seite, Querzustellung und Vorschub sie ergeben</translation>
    </message>
    <message>
        <source>Side of the patches</source>
        <translation>Seite der Felder</translation>
    </message>
    <message>
        <source>Distance of neighbouring passes</source>
        <translation>Abstand benachbarter Bahnen</translation>
    </message>
    <message>
        <source>Distance of marks along the path; 0: from the tool controller&apos;s feed and spindle speed</source>
        <translation>Abstand der Spuren entlang der Bahn; 0: aus Vorschub und Drehzahl der Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>1: corners and apex on the faces; 0: flat; other values exaggerate or invert the pyramid</source>
        <translation>1: Ecken und Spitze auf den Flächen; 0: eben; andere Werte überhöhen die Pyramide oder kehren sie um</translation>
    </message>
    <message>
        <source>Added to the height of each apex</source>
        <translation>Wird zur Höhe jeder Spitze hinzugefügt</translation>
    </message>
    <message>
        <source>Lines in planes along X, or contours at levels</source>
        <translation>Zeilen in Ebenen entlang X, oder Höhenlinien</translation>
    </message>
    <message>
        <source>Layers from the stock, the last pass, or both</source>
        <translation>Schichten aus dem Rohteil, der letzte Durchgang, oder beides</translation>
    </message>
    <message>
        <source>Distance between lines</source>
        <translation>Abstand der Zeilen</translation>
    </message>
    <message>
        <source>Distance between layers</source>
        <translation>Abstand der Schichten</translation>
    </message>
    <message>
        <source>The last pass&apos;s; 0: as the others&apos;</source>
        <translation>Der des letzten Durchgangs; 0: wie die anderen</translation>
    </message>
    <message>
        <source>Left by roughing for the last pass</source>
        <translation>Was das Schruppen für den letzten Durchgang übrig lässt</translation>
    </message>
    <message>
        <source>Of the path from the model</source>
        <translation>Der Bahn vom Modell</translation>
    </message>
    <message>
        <source>What is taken from the voxel model</source>
        <translation>Was dem Voxelmodell entnommen wird</translation>
    </message>
    <message>
        <source>Side of a voxel</source>
        <translation>Kante eines Voxels</translation>
    </message>
    <message>
        <source>Feed at the product&apos;s surface, V_Lo</source>
        <translation>Vorschub an der Oberfläche des Produkts, V_Lo</translation>
    </message>
    <message>
        <source>Feed at the skin of the stock, V_Hi</source>
        <translation>Vorschub an der Haut des Rohteils, V_Hi</translation>
    </message>
    <message>
        <source>Feed where nothing is left to cut; 0: as elsewhere</source>
        <translation>Vorschub, wo nichts mehr zu schneiden ist; 0: wie sonst</translation>
    </message>
    <message>
        <source>Moves that go down steeply never get faster</source>
        <translation>Steil nach unten gehende Wege werden nie schneller</translation>
    </message>
    <message>
        <source>Other materials in the stock: &apos;name factor where&apos;, a factor on the feed, and a depth in mm below the stock&apos;s surface or the name of a solid</source>
        <translation>Andere Werkstoffe im Rohteil: &apos;Name Faktor wo&apos;, ein Faktor für den Vorschub, und eine Tiefe in mm unter der Oberfläche des Rohteils oder der Name eines Körpers</translation>
    </message>
    <message>
        <source>Whether the values at the skin of the stock are held, or are only where diffusion begins</source>
        <translation>Ob die Werte an der Haut des Rohteils gehalten werden, oder nur der Anfang der Diffusion sind</translation>
    </message>
    <message>
        <source>Of the feed: to its steady state, or for a time as in the paper</source>
        <translation>Des Vorschubs: bis zum stationären Zustand, oder für eine Zeit wie in der Veröffentlichung</translation>
    </message>
    <message>
        <source>Of a transient diffusion, in seconds</source>
        <translation>Einer zeitabhängigen Diffusion, in Sekunden</translation>
    </message>
    <message>
        <source>Of a transient diffusion, in mm^2/s</source>
        <translation>Einer zeitabhängigen Diffusion, in mm^2/s</translation>
    </message>
    <message>
        <source>Divide a time step that is too long for the voxels</source>
        <translation>Einen Zeitschritt teilen, der für die Voxel zu lang ist</translation>
    </message>
    <message>
        <source>Diffuse the two angles (as in the paper) or the unit vector of the axis</source>
        <translation>Die beiden Winkel (wie in der Veröffentlichung) oder den Einheitsvektor der Achse diffundieren</translation>
    </message>
    <message>
        <source>Greatest angle of the posture about X and about Y</source>
        <translation>Größter Winkel der Werkzeugstellung um X und um Y</translation>
    </message>
    <message>
        <source>Interpolate between voxels, or take each voxel&apos;s value (the paper&apos;s staircase)</source>
        <translation>Zwischen Voxeln interpolieren, oder den Wert jedes Voxels nehmen (die Treppe der Veröffentlichung)</translation>
    </message>
    <message>
        <source>Where the voxels are read</source>
        <translation>Wo die Voxel gelesen werden</translation>
    </message>
    <message>
        <source>Of a move&apos;s feed from the field&apos;s</source>
        <translation>Des Vorschubs eines Wegs von dem des Felds</translation>
    </message>
    <message>
        <source>Of the axis along a move</source>
        <translation>Der Achse entlang eines Wegs</translation>
    </message>
    <message>
        <source>Name of the machine file; empty: no limits</source>
        <translation>Name der Maschinendatei; leer: keine Grenzen</translation>
    </message>
    <message>
        <source>Frusta of shank and holder: &apos;from to diameter diameter&apos;, heights above the tip in mm</source>
        <translation>Kegelstümpfe von Schaft und Halter: &apos;von bis Durchmesser Durchmesser&apos;, Höhen über der Spitze in mm</translation>
    </message>
    <message>
        <source>That is kept between holder and part</source>
        <translation>Der zwischen Halter und Teil gehalten wird</translation>
    </message>
    <message>
        <source>Of the triangles that stand for the shapes</source>
        <translation>Der Dreiecke, die für die Formen stehen</translation>
    </message>
    <message>
        <source>For the voxel model and its fields, in MiB</source>
        <translation>Für das Voxelmodell und seine Felder, in MiB</translation>
    </message>
    <message>
        <source>Dimples that are milled</source>
        <translation>Mulden, die gefräst werden</translation>
    </message>
    <message>
        <source>Lattice points left out, by reason</source>
        <translation>Ausgelassene Gitterpunkte, nach Grund</translation>
    </message>
    <message>
        <source>Mean spindle turns from dimple to dimple</source>
        <translation>Mittlere Umdrehungen der Spindel von Mulde zu Mulde</translation>
    </message>
    <message>
        <source>Whether the machine can hold the phase</source>
        <translation>Ob die Maschine die Phase halten kann</translation>
    </message>
    <message>
        <source>Distance of neighbouring dimples</source>
        <translation>Abstand benachbarter Mulden</translation>
    </message>
    <message>
        <source>Depth of the dimples</source>
        <translation>Tiefe der Mulden</translation>
    </message>
    <message>
        <source>Diameter of a dimple&apos;s rim</source>
        <translation>Durchmesser des Randes einer Mulde</translation>
    </message>
    <message>
        <source>Share of the faces that is dimple, 0 to 1</source>
        <translation>Anteil der Flächen, der Mulde ist, 0 bis 1</translation>
    </message>
    <message>
        <source>Height of what stays between dimples</source>
        <translation>Höhe dessen, was zwischen Mulden stehen bleibt</translation>
    </message>
    <message>
        <source>Tilt below which the tip rubs in a dimple</source>
        <translation>Neigung, unter der die Spitze in einer Mulde reibt</translation>
    </message>
    <message>
        <source>Milled dimples in which the tip rubs</source>
        <translation>Gefräste Mulden, in denen die Spitze reibt</translation>
    </message>
    <message>
        <source>Least distance of any two dimples, straight in space</source>
        <translation>Kleinster Abstand zweier Mulden, geradeaus im Raum</translation>
    </message>
    <message>
        <source>Greatest distance of neighbours, measured</source>
        <translation>Größter Abstand von Nachbarn, gemessen</translation>
    </message>
    <message>
        <source>Root mean square of distance / spacing - 1</source>
        <translation>Quadratisches Mittel von Abstand / Sollabstand - 1</translation>
    </message>
    <message>
        <source>Least angle of lattice directions, measured</source>
        <translation>Kleinster Winkel der Gitterrichtungen, gemessen</translation>
    </message>
    <message>
        <source>Greatest angle of lattice directions, measured</source>
        <translation>Größter Winkel der Gitterrichtungen, gemessen</translation>
    </message>
    <message>
        <source>Milled dimples, each worth a cell of the lattice, over the faces&apos; area; 0: not known</source>
        <translation>Gefräste Mulden, jede eine Zelle des Gitters wert, durch den Inhalt der Flächen; 0: nicht bekannt</translation>
    </message>
    <message>
        <source>What was decided for you, and what is not covered</source>
        <translation>Was für Sie entschieden wurde, und was nicht bedeckt ist</translation>
    </message>
    <message>
        <source>Direction of the projection</source>
        <translation>Richtung der Projektion</translation>
    </message>
    <message>
        <source>How marks of neighbouring passes stand</source>
        <translation>Wie Spuren benachbarter Bahnen zueinander stehen</translation>
    </message>
    <message>
        <source>Predicted drift from pass to pass, in teeth</source>
        <translation>Vorhergesagte Verschiebung von Bahn zu Bahn, in Zähnen</translation>
    </message>
    <message>
        <source>The same, measured on the path</source>
        <translation>Dasselbe, an der Bahn gemessen</translation>
    </message>
    <message>
        <source>Largest difference of the phase measured on the path and predicted, in teeth</source>
        <translation>Größter Unterschied der an der Bahn gemessenen und der vorhergesagten Phase, in Zähnen</translation>
    </message>
    <message>
        <source>Of the path</source>
        <translation>Der Bahn</translation>
    </message>
    <message>
        <source>Ridge between lines on a flat, in mm</source>
        <translation>Grat zwischen Zeilen auf einer Ebene, in mm</translation>
    </message>
    <message>
        <source>Lines left out: in a cavity, not reached from above</source>
        <translation>Ausgelassene Zeilen: in einem Hohlraum, von oben nicht erreicht</translation>
    </message>
    <message>
        <source>Timed moves</source>
        <translation>Wege mit eigener Zeit</translation>
    </message>
    <message>
        <source>The base operation&apos;s, in seconds</source>
        <translation>Die der Grundoperation, in Sekunden</translation>
    </message>
    <message>
        <source>Between moves that go straight on, in mm/min</source>
        <translation>Zwischen Wegen, die geradeaus weitergehen, in mm/min</translation>
    </message>
    <message>
        <source>Within a move, in degrees</source>
        <translation>Innerhalb eines Wegs, in Grad</translation>
    </message>
    <message>
        <source>That are stored</source>
        <translation>Die gespeichert sind</translation>
    </message>
    <message>
        <source>Places where no axis keeps the holder clear</source>
        <translation>Stellen, an denen keine Achse den Halter frei hält</translation>
    </message>
    <message>
        <source>Stock and model of the job: recomputed when they change</source>
        <translation>Rohteil und Modell des Auftrags: neu berechnet, wenn sie sich ändern</translation>
    </message>
    <message>
        <source>Path to modify</source>
        <translation>Zu ändernde Bahn</translation>
    </message>
    <message>
        <source>Number of the patch, in milling order, with which the program ends; 0: with the last one</source>
        <translation>Nummer des Felds, in der Reihenfolge des Fräsens, mit dem das Programm endet; 0: mit dem letzten</translation>
    </message>
    <message>
        <source>Stop before each patch if the operator has switched optional stops on (M1)</source>
        <translation>Vor jedem Feld anhalten, wenn wahlweiser Halt eingeschaltet ist (M1)</translation>
    </message>
    <message>
        <source>Cutting end and flutes may cut so deep below the model, besides Tolerance</source>
        <translation>So tief dürfen Stirn und Schneiden unter das Modell schneiden, außer der Toleranz</translation>
    </message>
    <message>
        <source>Cutting end and flutes may cut so deep below the model, besides the tolerance of copy milling under it</source>
        <translation>So tief dürfen Stirn und Schneiden unter das Modell schneiden, außer der Toleranz des Kopierfräsens darunter</translation>
    </message>
    <message>
        <source>Time of all moves, rapids too, in seconds</source>
        <translation>Zeit aller Wege, auch der Eilgänge, in Sekunden</translation>
    </message>
    <message>
        <source>Tool controller of the operation that is modified</source>
        <translation>Werkzeugsteuerung der Operation, die geändert wird</translation>
    </message>
    <message>
        <source>Time that FreeCAD counts for the job</source>
        <translation>Zeit, die FreeCAD für den Auftrag zählt</translation>
    </message>
    <message>
        <source>Whether the operation that is modified is switched on</source>
        <translation>Ob die Operation, die geändert wird, eingeschaltet ist</translation>
    </message>
    <message>
        <source>Name of the machine file, whose rapids and accelerations the time counts; empty: unknown</source>
        <translation>Name der Maschinendatei, deren Eilgänge und Beschleunigungen in die Zeit eingehen; leer: unbekannt</translation>
    </message>
    <message>
        <source>Largest on the tool in a turn, in N; 0: no limit</source>
        <translation>Größte am Werkzeug in einer Umdrehung, in N; 0: keine Grenze</translation>
    </message>
    <message>
        <source>Power at the tool&apos;s edges, in W; 0: no limit</source>
        <translation>Leistung an den Schneiden, in W; 0: keine Grenze</translation>
    </message>
    <message>
        <source>Mean chip thickness; 0: no limit</source>
        <translation>Mittlere Spanungsdicke; 0: keine Grenze</translation>
    </message>
    <message>
        <source>k_c1.1 of the stock: cutting force on a chip 1 mm thick and 1 mm wide, in N</source>
        <translation>k_c1.1 des Rohteils: Schnittkraft an einem Span von 1 mm Dicke und 1 mm Breite, in N</translation>
    </message>
    <message>
        <source>m_c of the stock: how thin chips resist more</source>
        <translation>m_c des Rohteils: wie dünne Späne mehr Widerstand leisten</translation>
    </message>
    <message>
        <source>Normal to the cutting surface, of the cutting force</source>
        <translation>Normal zur Schneidenfläche, als Anteil der Schnittkraft</translation>
    </message>
    <message>
        <source>On the tool in a turn, in N; 0: no limit of the load</source>
        <translation>Am Werkzeug in einer Umdrehung, in N; 0: keine Grenze der Belastung</translation>
    </message>
    <message>
        <source>At the tool&apos;s edges, in W; 0: no limit of the load</source>
        <translation>An den Schneiden, in W; 0: keine Grenze der Belastung</translation>
    </message>
    <message>
        <source>Mean chip thickness, in mm; 0: no limit of the load</source>
        <translation>Mittlere Spanungsdicke, in mm; 0: keine Grenze der Belastung</translation>
    </message>
    <message>
        <source>Mill patch by patch along helices, in rows of the lattice, or all round a cylinder along one thread while a rotary table turns it</source>
        <translation>Feld für Feld entlang von Spiralen fräsen, in Zeilen des Gitters, oder rund um einen Zylinder entlang eines einzigen Gewindegangs, während ein Drehtisch ihn dreht</translation>
    </message>
    <message>
        <source>Projected: spacing kept as seen along the projection; on surface: kept along the faces; ball: a lattice that is a sphere&apos;s own</source>
        <translation>Projiziert: der Abstand gilt entlang der Projektion gesehen; auf der Fläche: er gilt entlang der Flächen; Kugel: ein Gitter, das einer Kugel eigen ist</translation>
    </message>
    <message>
        <source>Lattice of a ball: icosahedral, most even; along a Fibonacci spiral; or in rings about its pole</source>
        <translation>Gitter einer Kugel: ikosaedrisch, am gleichmäßigsten; entlang einer Fibonacci-Spirale; oder in Ringen um ihren Pol</translation>
    </message>
    <message>
        <source>Dimples on the whole ball; 0: by the spacing</source>
        <translation>Mulden auf der ganzen Kugel; 0: nach dem Abstand</translation>
    </message>
    <message>
        <source>One: dimples no steeper than the limit; two: those of the half that looks to the tool, the others after the ball was turned over</source>
        <translation>Eine: Mulden, die nicht steiler sind als die Grenze; zwei: die der Hälfte, die zum Werkzeug schaut, die anderen, nachdem die Kugel umgedreht wurde</translation>
    </message>
</context>
<context>
    <name>PatchMill</name>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Texture kind</source>
        <translation>Art der Textur</translation>
    </message>
    <message>
        <source>Overlapping</source>
        <translation>Überlappend</translation>
    </message>
    <message>
        <source>Isolated</source>
        <translation>Einzeln</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Dimple diameter</source>
        <translation>Durchmesser der Mulden</translation>
    </message>
    <message>
        <source>Area share</source>
        <translation>Flächenanteil</translation>
    </message>
    <message>
        <source>Ridge height</source>
        <translation>Grathöhe</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Projected</source>
        <translation>Projiziert</translation>
    </message>
    <message>
        <source>On surface</source>
        <translation>Auf der Fläche</translation>
    </message>
    <message>
        <source>Patch shape</source>
        <translation>Form der Felder</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Hexagon</source>
        <translation>Sechseck</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Patch side</source>
        <translation>Seite der Felder</translation>
    </message>
    <message>
        <source>Patch side across</source>
        <translation>Andere Seite der Felder</translation>
    </message>
    <message>
        <source>Patches X</source>
        <translation>Felder X</translation>
    </message>
    <message>
        <source>Patches Y</source>
        <translation>Felder Y</translation>
    </message>
    <message>
        <source>Helix order</source>
        <translation>Richtung der Spirale</translation>
    </message>
    <message>
        <source>Inward</source>
        <translation>Nach innen</translation>
    </message>
    <message>
        <source>Outward</source>
        <translation>Nach außen</translation>
    </message>
    <message>
        <source>Helix start</source>
        <translation>Beginn der Spirale</translation>
    </message>
    <message>
        <source>Same corner</source>
        <translation>Gleiche Ecke</translation>
    </message>
    <message>
        <source>Nearest corner</source>
        <translation>Nächste Ecke</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Helix</source>
        <translation>Spirale</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Row extent</source>
        <translation>Ausdehnung der Zeilen</translation>
    </message>
    <message>
        <source>Whole face</source>
        <translation>Ganze Fläche</translation>
    </message>
    <message>
        <source>Each patch</source>
        <translation>Jedes Feld</translation>
    </message>
    <message>
        <source>Row direction</source>
        <translation>Richtung der Zeilen</translation>
    </message>
    <message>
        <source>Least time</source>
        <translation>Kürzeste Zeit</translation>
    </message>
    <message>
        <source>Along X</source>
        <translation>Entlang X</translation>
    </message>
    <message>
        <source>Along Y</source>
        <translation>Entlang Y</translation>
    </message>
    <message>
        <source>Principal curvature</source>
        <translation>Hauptkrümmung</translation>
    </message>
    <message>
        <source>Rows one way</source>
        <translation>Zeilen nur in einer Richtung</translation>
    </message>
    <message>
        <source>First patch</source>
        <translation>Erstes Feld</translation>
    </message>
    <message>
        <source>Patch comments</source>
        <translation>Kommentare zu Feldern</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Auto direction</source>
        <translation>Richtung automatisch</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Auto origin</source>
        <translation>Mitte automatisch</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Steepest slope</source>
        <translation>Steilste Neigung</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Minimum tilt</source>
        <translation>Kleinste Neigung</translation>
    </message>
    <message>
        <source>Avoid rubbing</source>
        <translation>Reiben vermeiden</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Minimum dimples</source>
        <translation>Mindestzahl der Mulden</translation>
    </message>
    <message>
        <source>Mask use</source>
        <translation>Verwendung der Maske</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Mask image</source>
        <translation>Bild der Maske</translation>
    </message>
    <message>
        <source>Mask curves</source>
        <translation>Kurven der Maske</translation>
    </message>
    <message>
        <source>Mask invert</source>
        <translation>Maske umkehren</translation>
    </message>
    <message>
        <source>Mask width</source>
        <translation>Breite der Maske</translation>
    </message>
    <message>
        <source>Mask centre</source>
        <translation>Mitte der Maske</translation>
    </message>
    <message>
        <source>Mask threshold</source>
        <translation>Schwelle der Maske</translation>
    </message>
    <message>
        <source>Depth at black</source>
        <translation>Tiefe bei Schwarz</translation>
    </message>
    <message>
        <source>Depth at white</source>
        <translation>Tiefe bei Weiß</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Constant feed</source>
        <translation>Fester Vorschub</translation>
    </message>
    <message>
        <source>Constant feed, fitted stops</source>
        <translation>Fester Vorschub, angepasste Halte</translation>
    </message>
    <message>
        <source>Feed per move</source>
        <translation>Vorschub je Satz</translation>
    </message>
    <message>
        <source>Spindle-locked</source>
        <translation>An die Spindel gekoppelt</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Post unheld</source>
        <translation>Ausgeben trotz verlorener Phase</translation>
    </message>
    <message>
        <source>Gouge tolerance</source>
        <translation>Toleranz für Verletzungen</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Tool clearance</source>
        <translation>Abstand des Werkzeugs</translation>
    </message>
    <message>
        <source>Stick out</source>
        <translation>Auskraglänge</translation>
    </message>
    <message>
        <source>Holder diameter</source>
        <translation>Durchmesser des Halters</translation>
    </message>
    <message>
        <source>Holder length</source>
        <translation>Länge des Halters</translation>
    </message>
    <message>
        <source>Post gouging</source>
        <translation>Ausgeben trotz Verletzung</translation>
    </message>
    <message>
        <source>Tool axis mode</source>
        <translation>Werkzeugachse</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>Werkzeugachse</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Minimum lead</source>
        <translation>Kleinster Voreilwinkel</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Fixed axis</source>
        <translation>Feste Achse</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Voreilwinkel</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Seitenwinkel</translation>
    </message>
    <message>
        <source>Lead towards</source>
        <translation>Voreilen nach</translation>
    </message>
    <message>
        <source>Posture field</source>
        <translation>Haltungsfeld</translation>
    </message>
    <message>
        <source>Field voxel size</source>
        <translation>Voxelgröße des Feldes</translation>
    </message>
    <message>
        <source>Axis smoothing</source>
        <translation>Glättung der Achse</translation>
    </message>
    <message>
        <source>Widest tilt</source>
        <translation>Größte Neigung</translation>
    </message>
    <message>
        <source>Row tolerance</source>
        <translation>Toleranz der Zeilen</translation>
    </message>
    <message>
        <source>Program form</source>
        <translation>Form des Programms</translation>
    </message>
    <message>
        <source>As the machine</source>
        <translation>Wie die Maschine</translation>
    </message>
    <message>
        <source>With TCP</source>
        <translation>Mit TCP</translation>
    </message>
    <message>
        <source>Without TCP</source>
        <translation>Ohne TCP</translation>
    </message>
    <message>
        <source>Gauge length</source>
        <translation>Spannlänge</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Abheben</translation>
    </message>
    <message>
        <source>Same flute</source>
        <translation>Gleiche Schneide</translation>
    </message>
    <message>
        <source>Extra turns</source>
        <translation>Zusätzliche Umdrehungen</translation>
    </message>
    <message>
        <source>Phase step</source>
        <translation>Phasenschritt</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>Nachkommastellen</translation>
    </message>
    <message>
        <source>Phase tolerance</source>
        <translation>Phasentoleranz</translation>
    </message>
    <message>
        <source>Plane fit</source>
        <translation>Anpassung der Ebenen</translation>
    </message>
    <message>
        <source>Best fit</source>
        <translation>Beste Anpassung</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Free form</source>
        <translation>Freie Form</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Free side</source>
        <translation>Freie Seite</translation>
    </message>
    <message>
        <source>Cross feed</source>
        <translation>Bahnabstand</translation>
    </message>
    <message>
        <source>Feed per tooth</source>
        <translation>Zahnvorschub</translation>
    </message>
    <message>
        <source>Height factor</source>
        <translation>Höhenfaktor</translation>
    </message>
    <message>
        <source>Apex lift</source>
        <translation>Anhebung der Spitze</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Höhenlinien</translation>
    </message>
    <message>
        <source>Scanning with undercuts</source>
        <translation>Zeilen mit Hinterschnitten</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Roughing and finishing</source>
        <translation>Schruppen und Schlichten</translation>
    </message>
    <message>
        <source>Roughing</source>
        <translation>Schruppen</translation>
    </message>
    <message>
        <source>Finishing</source>
        <translation>Schlichten</translation>
    </message>
    <message>
        <source>Radial depth</source>
        <translation>Radiale Zustellung</translation>
    </message>
    <message>
        <source>Axial depth</source>
        <translation>Axiale Zustellung</translation>
    </message>
    <message>
        <source>Finishing radial depth</source>
        <translation>Radiale Zustellung beim Schlichten</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Regelt</translation>
    </message>
    <message>
        <source>DCM</source>
        <translation>DCM</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Posture</source>
        <translation>Haltung</translation>
    </message>
    <message>
        <source>Feed and posture</source>
        <translation>Vorschub und Haltung</translation>
    </message>
    <message>
        <source>Voxel size</source>
        <translation>Voxelgröße</translation>
    </message>
    <message>
        <source>Feed at product</source>
        <translation>Vorschub am Werkstück</translation>
    </message>
    <message>
        <source>Feed at skin</source>
        <translation>Vorschub an der Rohteilhaut</translation>
    </message>
    <message>
        <source>Feed in air</source>
        <translation>Vorschub in der Luft</translation>
    </message>
    <message>
        <source>Keep plunges</source>
        <translation>Eintauchen beibehalten</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Werkstoffe</translation>
    </message>
    <message>
        <source>Exterior</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Gehalten</translation>
    </message>
    <message>
        <source>Diffusion</source>
        <translation>Diffusion</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Stationär</translation>
    </message>
    <message>
        <source>Transient</source>
        <translation>Zeitlich begrenzt</translation>
    </message>
    <message>
        <source>Diffusion time</source>
        <translation>Dauer der Diffusion</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Diffusivity</source>
        <translation>Diffusivität</translation>
    </message>
    <message>
        <source>Sub steps</source>
        <translation>Teilschritte</translation>
    </message>
    <message>
        <source>Posture form</source>
        <translation>Form der Haltung</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Unit vector</source>
        <translation>Einheitsvektor</translation>
    </message>
    <message>
        <source>Tilt limit</source>
        <translation>Grenze der Neigung</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Ablesen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Geglättet</translation>
    </message>
    <message>
        <source>Staircase</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Read at</source>
        <translation>Abgelesen an</translation>
    </message>
    <message>
        <source>Ball centre</source>
        <translation>Kugelmitte</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>Feed tolerance</source>
        <translation>Toleranz des Vorschubs</translation>
    </message>
    <message>
        <source>Axis tolerance</source>
        <translation>Toleranz der Achse</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Halter</translation>
    </message>
    <message>
        <source>Holder clearance</source>
        <translation>Abstand des Halters</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>Abweichung der Dreiecke</translation>
    </message>
    <message>
        <source>Memory limit</source>
        <translation>Speichergrenze</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>gefräst</translation>
    </message>
    <message>
        <source>off the face</source>
        <translation>neben der Fläche</translation>
    </message>
    <message>
        <source>too steep</source>
        <translation>zu steil</translation>
    </message>
    <message>
        <source>tool tip</source>
        <translation>Werkzeugspitze</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>Hinterschnitt</translation>
    </message>
    <message>
        <source>near an edge</source>
        <translation>nahe am Rand</translation>
    </message>
    <message>
        <source>sliver</source>
        <translation>zu kleines Feld</translation>
    </message>
    <message>
        <source>masked</source>
        <translation>maskiert</translation>
    </message>
    <message>
        <source>no facet</source>
        <translation>keine Facette</translation>
    </message>
    <message>
        <source>off the net</source>
        <translation>neben dem Netz</translation>
    </message>
    <message>
        <source>crowded</source>
        <translation>zu dicht</translation>
    </message>
    <message>
        <source>square</source>
        <translation>quadratisch</translation>
    </message>
    <message>
        <source>staggered</source>
        <translation>versetzt</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>schief</translation>
    </message>
    <message>
        <source>irregular</source>
        <translation>unregelmäßig</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Dimples planned</source>
        <translation>Geplante Mulden</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>marks that nobody planned</source>
        <translation>nicht geplante Marken</translation>
    </message>
    <message>
        <source>off their places, rms</source>
        <translation>Abweichung vom Ort, quadratisches Mittel</translation>
    </message>
    <message>
        <source>depth to the rim</source>
        <translation>Tiefe bis zum Rand</translation>
    </message>
    <message>
        <source>diameter, mean</source>
        <translation>Durchmesser, Mittel</translation>
    </message>
    <message>
        <source>distance to the nearest, mean</source>
        <translation>Abstand zum nächsten, Mittel</translation>
    </message>
    <message>
        <source>array</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>quality, 0 to 1</source>
        <translation>Güte, 0 bis 1</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>spindle lock</source>
        <translation>Kopplung an die Spindel</translation>
    </message>
    <message>
        <source>decimals</source>
        <translation>Nachkommastellen</translation>
    </message>
    <message>
        <source>servo period</source>
        <translation>Servotakt</translation>
    </message>
    <message>
        <source>path tolerance</source>
        <translation>Bahntoleranz</translation>
    </message>
    <message>
        <source>linear axes</source>
        <translation>Linearachsen</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>jerk</source>
        <translation>Ruck</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
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
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>start phase</source>
        <translation>Anfangsphase</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>rotary axis C</source>
        <translation>Drehachse C</translation>
    </message>
    <message>
        <source>letter</source>
        <translation>Buchstabe</translation>
    </message>
    <message>
        <source>side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>rotary axis A</source>
        <translation>Drehachse A</translation>
    </message>
    <message>
        <source>work zero</source>
        <translation>Werkstücknullpunkt</translation>
    </message>
    <message>
        <source>retract</source>
        <translation>Rückzug</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Bezugspunkt</translation>
    </message>
    <message>
        <source>TCP on</source>
        <translation>TCP ein</translation>
    </message>
    <message>
        <source>TCP off</source>
        <translation>TCP aus</translation>
    </message>
    <message>
        <source>smoothing on</source>
        <translation>Glättung ein</translation>
    </message>
    <message>
        <source>smoothing off</source>
        <translation>Glättung aus</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>controller version</source>
        <translation>Version der Steuerung</translation>
    </message>
    <message>
        <source>lock origin</source>
        <translation>Ursprung der Kopplung</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>spindle rpm</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>rotary axis B</source>
        <translation>Drehachse B</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>no face</source>
        <translation>keine Fläche</translation>
    </message>
    <message>
        <source>select faces to texture.</source>
        <translation>Flächen für die Textur auswählen.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>select a part or its faces.</source>
        <translation>ein Teil oder seine Flächen auswählen.</translation>
    </message>
    <message>
        <source>{} operations</source>
        <translation>{} Operationen</translation>
    </message>
    <message>
        <source>select one operation of a job.</source>
        <translation>eine Operation eines Auftrags auswählen.</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>Ordner für den Bericht</translation>
    </message>
    <message>
        <source>PatchMill&apos;s compiled core</source>
        <translation>Der kompilierte Kern von PatchMill</translation>
    </message>
    <message>
        <source>Documents with PatchMill&apos;s operations can be opened and saved; nothing is lost.</source>
        <translation>Dokumente mit Operationen von PatchMill können geöffnet und gespeichert werden; nichts geht verloren.</translation>
    </message>
    <message>
        <source>Install</source>
        <translation>Installieren</translation>
    </message>
    <message>
        <source>Install from a wheel file …</source>
        <translation>Aus einer Wheel-Datei installieren …</translation>
    </message>
    <message>
        <source>Copy the command for a terminal</source>
        <translation>Befehl für ein Terminal kopieren</translation>
    </message>
    <message>
        <source>A wheel of PatchMill&apos;s core</source>
        <translation>Ein Wheel mit dem Kern von PatchMill</translation>
    </message>
    <message>
        <source>Copied. Start FreeCAD again when it has run.</source>
        <translation>Kopiert. FreeCAD neu starten, wenn er gelaufen ist.</translation>
    </message>
    <message>
        <source>Installed. Start FreeCAD again to use it.</source>
        <translation>Installiert. FreeCAD neu starten, um ihn zu verwenden.</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Marks in rows</source>
        <translation>Marken in Reihen</translation>
    </message>
    <message>
        <source>Staggered</source>
        <translation>Versetzt</translation>
    </message>
    <message>
        <source>Propose</source>
        <translation>Vorschlagen</translation>
    </message>
    <message>
        <source>side {:.4f} mm, cross-feed {:.4f} mm, feed per tooth {:.4f} mm: {}</source>
        <translation>Seite {:.4f} mm, Bahnabstand {:.4f} mm, Zahnvorschub {:.4f} mm: {}</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(keine)</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Maschinen</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Importieren …</translation>
    </message>
    <message>
        <source>Remove my file</source>
        <translation>Meine Datei entfernen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Reads the configuration of a LinuxCNC machine</source>
        <translation>Liest die Konfiguration einer Maschine mit LinuxCNC</translation>
    </message>
    <message>
        <source>Your own file.</source>
        <translation>Ihre eigene Datei.</translation>
    </message>
    <message>
        <source>Comes with PatchMill.</source>
        <translation>Gehört zu PatchMill.</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Name of the new machine file:</source>
        <translation>Name der neuen Maschinendatei:</translation>
    </message>
    <message>
        <source>From {}; to be saved as {}.</source>
        <translation>Aus {}; zu speichern als {}.</translation>
    </message>
    <message>
        <source>Close without saving what was changed?</source>
        <translation>Schließen, ohne die Änderungen zu speichern?</translation>
    </message>
    <message>
        <source>Post and check {}</source>
        <translation>{} ausgeben und prüfen</translation>
    </message>
    <message>
        <source>Post-&amp;processor</source>
        <translation>&amp;Postprozessor</translation>
    </message>
    <message>
        <source>&amp;Work offset</source>
        <translation>&amp;Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Post</source>
        <translation>Ausgeben</translation>
    </message>
    <message>
        <source>none is named</source>
        <translation>keine ist genannt</translation>
    </message>
    <message>
        <source>not judged: no machine is named</source>
        <translation>nicht beurteilt: keine Maschine ist genannt</translation>
    </message>
    <message>
        <source>no texture</source>
        <translation>keine Textur</translation>
    </message>
    <message>
        <source>Choose the program&apos;s file</source>
        <translation>Datei des Programms wählen</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>{} was written. Not compared with the path: {}.</source>
        <translation>{} wurde geschrieben. Nicht mit der Bahn verglichen: {}.</translation>
    </message>
    <message>
        <source>{} was written, read back and holds the plan.</source>
        <translation>{} wurde geschrieben, zurückgelesen und hält den Plan ein.</translation>
    </message>
    <message>
        <source>{} dimples in {} patches</source>
        <translation>{} Mulden in {} Feldern</translation>
    </message>
    <message>
        <source>{} of milling, {:.2f} turns per dimple</source>
        <translation>{} Fräszeit, {:.2f} Umdrehungen je Mulde</translation>
    </message>
    <message>
        <source>%p % · {:.0f} s left</source>
        <translation>%p % · noch {:.0f} s</translation>
    </message>
    <message>
        <source>Check {}</source>
        <translation>{} prüfen</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Prüfung läuft …</translation>
    </message>
    <message>
        <source>{} moves, {} of milling, ridges of {} on a flat</source>
        <translation>{} Sätze, {} Fräszeit, Grate von {} auf einer Ebene</translation>
    </message>
    <message>
        <source>DCM modifier</source>
        <translation>DCM-Modifikator</translation>
    </message>
    <message>
        <source>Slice through the voxels</source>
        <translation>Schnitt durch die Voxel</translation>
    </message>
    <message>
        <source>across {}</source>
        <translation>quer zu {}</translation>
    </message>
    <message>
        <source>Distance to the product</source>
        <translation>Abstand zum Werkstück</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Posture as arrows</source>
        <translation>Haltung als Pfeile</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Bei</translation>
    </message>
    <message>
        <source>{} moves, {} of milling instead of {}</source>
        <translation>{} Sätze, {} Fräszeit statt {}</translation>
    </message>
    <message>
        <source>feed [{}]</source>
        <translation>Vorschub [{}]</translation>
    </message>
    <message>
        <source>tilt [°]</source>
        <translation>Neigung [°]</translation>
    </message>
    <message>
        <source>distance [{}]</source>
        <translation>Abstand [{}]</translation>
    </message>
    <message>
        <source>Tool controller</source>
        <translation>Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlmittel</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>, to dimple {}</source>
        <translation>, zu Mulde {}</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Simulating and drawing …</source>
        <translation>Simuliere und zeichne …</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>Simulate marks</source>
        <translation>Marken simulieren</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>Save relief …</source>
        <translation>Relief speichern …</translation>
    </message>
    <message>
        <source>As a height map or a mesh, or the dimples as a table</source>
        <translation>Als Höhenkarte oder Netz, oder die Mulden als Tabelle</translation>
    </message>
    <message>
        <source>whole texture</source>
        <translation>ganze Textur</translation>
    </message>
    <message>
        <source>as planned</source>
        <translation>wie geplant</translation>
    </message>
    <message>
        <source>as {} would run it</source>
        <translation>wie {} es fahren würde</translation>
    </message>
    <message>
        <source>How far the first flute stands out</source>
        <translation>Wie weit die erste Schneide vorsteht</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>Runout</source>
        <translation>Rundlauffehler</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Height map</source>
        <translation>Höhenkarte</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Table of dimples</source>
        <translation>Tabelle der Mulden</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Relief</translation>
    </message>
    <message>
        <source>Looking for good values …</source>
        <translation>Suche gute Werte …</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>Berechne …</translation>
    </message>
    <message>
        <source>Looking for what helps …</source>
        <translation>Suche, was hilft …</translation>
    </message>
    <message>
        <source>Nothing that was tried makes it better.</source>
        <translation>Nichts, was versucht wurde, macht es besser.</translation>
    </message>
    <message>
        <source>Set for this strategy: any flute, no extra turns.</source>
        <translation>Für diese Strategie gesetzt: jede Schneide, keine zusätzlichen Umdrehungen.</translation>
    </message>
    <message>
        <source>{} dimples</source>
        <translation>{} Mulden</translation>
    </message>
    <message>
        <source>quality {} of patches at {}° to {}°: {}</source>
        <translation>Güte {} von Feldern bei {}° bis {}°: {}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Tried: this is what it gives</source>
        <translation>Versucht: das kommt dabei heraus</translation>
    </message>
    <message>
        <source>Not simulated</source>
        <translation>Nicht simuliert</translation>
    </message>
    <message>
        <source>Good: {} of the faces as planned</source>
        <translation>Gut: {} der Flächen wie geplant</translation>
    </message>
    <message>
        <source>Good if the machine holds the phase: choose a machine to know</source>
        <translation>Gut, wenn die Maschine die Phase hält: eine Maschine wählen, um es zu wissen</translation>
    </message>
    <message>
        <source>{} of the faces good; {} left out</source>
        <translation>{} der Flächen gut; {} ausgelassen</translation>
    </message>
    <message>
        <source>Incline the part {:.0f}°</source>
        <translation>Teil um {:.0f}° neigen</translation>
    </message>
    <message>
        <source>Lean the tool {:.0f}°</source>
        <translation>Werkzeug um {:.0f}° anstellen</translation>
    </message>
    <message>
        <source>Leave out what is too flat</source>
        <translation>Zu Flaches auslassen</translation>
    </message>
    <message>
        <source>Take the values that suit</source>
        <translation>Passende Werte übernehmen</translation>
    </message>
    <message>
        <source>{}: {:.0f} % good, {}</source>
        <translation>{}: {:.0f} % gut, {}</translation>
    </message>
    <message>
        <source>Dimples</source>
        <translation>Mulden</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Tool axes</source>
        <translation>Werkzeugachsen</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Play the path</source>
        <translation>Bahn abspielen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Quality {} with the borders of the faces, {} inside</source>
        <translation>Güte {} mit den Rändern der Flächen, {} innen</translation>
    </message>
    <message>
        <source>Let the tool follow the faces, leant {:.0f}°</source>
        <translation>Das Werkzeug den Flächen folgen lassen, um {:.0f}° geneigt</translation>
    </message>
    <message>
        <source>Choose a smaller spacing</source>
        <translation>Einen kleineren Abstand wählen</translation>
    </message>
    <message>
        <source>{}, spacing {}</source>
        <translation>{}, Abstand {}</translation>
    </message>
    <message>
        <source>{}, leave out what is too flat</source>
        <translation>{}, zu Flaches auslassen</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>Find the best speed</source>
        <translation>Die beste Drehzahl suchen</translation>
    </message>
    <message>
        <source>Trying other speeds …</source>
        <translation>Andere Drehzahlen werden versucht …</translation>
    </message>
    <message>
        <source>No speed from S{} to S{} holds.</source>
        <translation>Keine Drehzahl von S{} bis S{} hält die Phase.</translation>
    </message>
    <message>
        <source>Set S{}</source>
        <translation>S{} einstellen</translation>
    </message>
    <message>
        <source>Other operations use this tool controller: give this one its own.</source>
        <translation>Andere Operationen benutzen diese Werkzeugsteuerung: dieser eine eigene geben.</translation>
    </message>
    <message>
        <source>Last patch</source>
        <translation>Letztes Feld</translation>
    </message>
    <message>
        <source>Patch stops</source>
        <translation>Halt zwischen Feldern</translation>
    </message>
    <message>
        <source>counted from</source>
        <translation>gezählt von</translation>
    </message>
    <message>
        <source>{}, borders not as good</source>
        <translation>{}, Ränder weniger gut</translation>
    </message>
    <message>
        <source>{} for PatchMill&apos;s operations</source>
        <translation>{} für die Operationen von PatchMill</translation>
    </message>
    <message>
        <source>Play {}</source>
        <translation>{} abspielen</translation>
    </message>
    <message>
        <source>Next finding</source>
        <translation>Nächster Befund</translation>
    </message>
    <message>
        <source>Goes on to where the check found something next</source>
        <translation>Geht weiter zur nächsten Stelle, an der die Prüfung etwas gefunden hat</translation>
    </message>
    <message>
        <source>{:.0f} % of the faces look away or are too steep as the part lies</source>
        <translation>{:.0f} % der Flächen sehen weg oder sind zu steil, so wie das Teil liegt</translation>
    </message>
    <message>
        <source>Lay the dimples along the faces</source>
        <translation>Die Mulden entlang der Flächen legen</translation>
    </message>
    <message>
        <source>{}, dimples laid along the faces</source>
        <translation>{}, Mulden entlang der Flächen gelegt</translation>
    </message>
    <message>
        <source>Leave out what is steeper than {:.0f}°</source>
        <translation>Auslassen, was steiler als {:.0f}° ist</translation>
    </message>
    <message>
        <source>{}, leave out what is steeper than {:.0f}°</source>
        <translation>{}, auslassen, was steiler als {:.0f}° ist</translation>
    </message>
    <message>
        <source>The faces bend in to a radius of {}; the ball of {} does not fit there.</source>
        <translation>Die Flächen sind bis zu einem Radius von {} hohl; die Kugel von {} passt dort nicht hinein.</translation>
    </message>
    <message>
        <source>{} of the faces as planned, their borders included</source>
        <translation>{} der Flächen wie geplant, mit ihren Rändern</translation>
    </message>
    <message>
        <source>{} of the faces good; the rest looks away: turn the part for it</source>
        <translation>{} der Flächen gut; der Rest ist abgewandt: das Teil dafür drehen</translation>
    </message>
    <message>
        <source>The faces are about {} wide: {:.0f} dimples side by side are too few.</source>
        <translation>Die Flächen sind etwa {} breit: {:.0f} Mulden nebeneinander sind zu wenige.</translation>
    </message>
    <message>
        <source>give a finite number.</source>
        <translation>Eine endliche Zahl angeben.</translation>
    </message>
    <message>
        <source>give a value greater than zero.</source>
        <translation>Einen Wert größer als null angeben.</translation>
    </message>
    <message>
        <source>give a finite value greater than zero.</source>
        <translation>Einen endlichen Wert größer als null angeben.</translation>
    </message>
    <message>
        <source>give a value from {} to {} mm.</source>
        <translation>Einen Wert von {} bis {} mm angeben.</translation>
    </message>
    <message>
        <source>give a value from {} to {} degrees.</source>
        <translation>Einen Wert von {} bis {} Grad angeben.</translation>
    </message>
    <message>
        <source>give more than zero.</source>
        <translation>Mehr als null angeben.</translation>
    </message>
    <message>
        <source>give zero or a positive length.</source>
        <translation>Null oder eine positive Länge angeben.</translation>
    </message>
    <message>
        <source>give a whole number greater than zero: posts write S so.</source>
        <translation>Eine ganze Zahl größer als null angeben: So schreiben Postprozessoren S.</translation>
    </message>
    <message>
        <source>give the tool controller a feed.</source>
        <translation>Der Werkzeugsteuerung einen Vorschub geben.</translation>
    </message>
    <message>
        <source>give the operation a tool controller with a tool.</source>
        <translation>Der Operation eine Werkzeugsteuerung mit Werkzeug geben.</translation>
    </message>
    <message>
        <source>{} mm from the nearest dimple</source>
        <translation>{} mm von der nächsten Mulde</translation>
    </message>
    <message>
        <source>a ball of radius {} mm leaves untouched material between the dimples: choose a smaller spacing or a larger ball.</source>
        <translation>Eine Kugel vom Radius {} mm lässt zwischen den Mulden Material stehen: Einen kleineren Abstand oder eine größere Kugel wählen.</translation>
    </message>
    <message>
        <source>choose a larger ball or a smaller spacing.</source>
        <translation>Eine größere Kugel oder einen kleineren Abstand wählen.</translation>
    </message>
    <message>
        <source>in dimples {} mm deep the tip of the ball would rub: incline the tool by more than {}°, or choose shallower dimples.</source>
        <translation>In {} mm tiefen Mulden würde die Kugelspitze reiben: Das Werkzeug um mehr als {}° neigen oder flachere Mulden wählen.</translation>
    </message>
    <message>
        <source>in dimples {} mm deep the tip of the ball would rub under a tilt of {} degrees, and the faces have {} at most: incline the part or choose shallower dimples.</source>
        <translation>In {} mm tiefen Mulden würde die Kugelspitze unter {} Grad Neigung reiben, und die Flächen haben höchstens {}: Das Teil neigen oder flachere Mulden wählen.</translation>
    </message>
    <message>
        <source>on a paced path every flute passes in turn: allow any flute, or use the constant-feed strategy.</source>
        <translation>Auf einer getakteten Bahn schneidet jede Schneide der Reihe nach: Jede Schneide zulassen oder die Strategie mit konstantem Vorschub wählen.</translation>
    </message>
    <message>
        <source>select a face of a solid or surface.</source>
        <translation>Eine Fläche eines Körpers oder einer Fläche auswählen.</translation>
    </message>
    <message>
        <source>select at least one face of the job&apos;s model.</source>
        <translation>Mindestens eine Fläche des Modells im Job auswählen.</translation>
    </message>
    <message>
        <source>it is gone: choose the faces again.</source>
        <translation>Sie ist nicht mehr da: Die Flächen neu wählen.</translation>
    </message>
    <message>
        <source>give the job a stock.</source>
        <translation>Dem Job ein Rohteil geben.</translation>
    </message>
    <message>
        <source>give the job a model.</source>
        <translation>Dem Job ein Modell geben.</translation>
    </message>
    <message>
        <source>it belongs to no job: make it in one.</source>
        <translation>Sie gehört zu keinem Job: In einem Job anlegen.</translation>
    </message>
    <message>
        <source>choose a texture operation.</source>
        <translation>Eine Texturoperation wählen.</translation>
    </message>
    <message>
        <source>repair the operation first.</source>
        <translation>Zuerst die Operation in Ordnung bringen.</translation>
    </message>
    <message>
        <source>copy milling takes a ball, bull nose, tapered or conical end mill: choose one.</source>
        <translation>Kopierfräsen braucht einen Kugel-, Torus-, konischen Kugel- oder Kegelfräser: Einen davon wählen.</translation>
    </message>
    <message>
        <source>choose a ball, bull nose, flat, tapered ball or conical end mill.</source>
        <translation>Einen Kugel-, Torus-, Schaft-, konischen Kugel- oder Kegelfräser wählen.</translation>
    </message>
    <message>
        <source>give no more than the tool&apos;s cutting edge, {} mm.</source>
        <translation>Nicht mehr als die Schneidenlänge des Werkzeugs angeben, {} mm.</translation>
    </message>
    <message>
        <source>give no more than AxialDepth, {} mm: the last pass takes it all at once.</source>
        <translation>Nicht mehr als die axiale Zustellung angeben, {} mm: Der letzte Durchgang nimmt alles auf einmal.</translation>
    </message>
    <message>
        <source>rapids would go through the stock: give more than its top, {} mm.</source>
        <translation>Eilgänge gingen durch das Rohteil: Mehr als seine Oberkante angeben, {} mm.</translation>
    </message>
    <message>
        <source>there is nothing to cut on them, or the ball does not reach them from above.</source>
        <translation>An ihnen ist nichts zu fräsen, oder die Kugel erreicht sie nicht von oben.</translation>
    </message>
    <message>
        <source>with undercuts choose the whole model.</source>
        <translation>Bei Hinterschnitten das ganze Modell wählen.</translation>
    </message>
    <message>
        <source>tool axes other than Z need a machine file with rotary axes.</source>
        <translation>Andere Werkzeugachsen als Z brauchen eine Maschinendatei mit Drehachsen.</translation>
    </message>
    <message>
        <source>name a machine file: without one nobody knows what it can follow.</source>
        <translation>Eine Maschinendatei nennen: Ohne sie ist nicht bekannt, wozu die Maschine folgen kann.</translation>
    </message>
    <message>
        <source>give a picture or closed curves, or choose None.</source>
        <translation>Ein Bild oder geschlossene Kurven angeben, oder „Keine“ wählen.</translation>
    </message>
    <message>
        <source>it has an open curve: close it.</source>
        <translation>Sie hat eine offene Kurve: Diese schließen.</translation>
    </message>
    <message>
        <source>put it over the faces.</source>
        <translation>Über die Flächen legen.</translation>
    </message>
    <message>
        <source>the job has no active operation.</source>
        <translation>Der Job hat keine aktive Operation.</translation>
    </message>
    <message>
        <source>choose a post-processor for the job.</source>
        <translation>Einen Postprozessor für den Job wählen.</translation>
    </message>
    <message>
        <source>name a file in a folder that can be written to.</source>
        <translation>Eine Datei in einem beschreibbaren Ordner nennen.</translation>
    </message>
    <message>
        <source>give the name of a file.</source>
        <translation>Den Namen einer Datei angeben.</translation>
    </message>
    <message>
        <source>What {} leaves</source>
        <translation>Was {} stehen lässt</translation>
    </message>
    <message>
        <source>Simulating …</source>
        <translation>Simuliere …</translation>
    </message>
    <message>
        <source>left over the part [{}]</source>
        <translation>über dem Teil [{}]</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>height over the faces [{}]</source>
        <translation>Höhe über den Flächen [{}]</translation>
    </message>
    <message>
        <source>part that is milled, seen from above</source>
        <translation>gefräster Teil, von oben gesehen</translation>
    </message>
    <message>
        <source>left over the part, mean</source>
        <translation>steht über dem Teil, im Mittel</translation>
    </message>
    <message>
        <source>left over the part, at most</source>
        <translation>steht über dem Teil, höchstens</translation>
    </message>
    <message>
        <source>cut below the part, at most</source>
        <translation>unter das Teil gefräst, höchstens</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Walls of the part beside the faces are in the tool&apos;s way.</source>
        <translation>Wände des Teils neben den Flächen sind dem Werkzeug im Weg.</translation>
    </message>
    <message>
        <source>Mill them in {} operations, the tool leant from each side</source>
        <translation>In {} Operationen fräsen, das Werkzeug von jeder Seite geneigt</translation>
    </message>
    <message>
        <source>Mill them in {} clampings, a job for each</source>
        <translation>In {} Aufspannungen fräsen, mit je einem Auftrag</translation>
    </message>
    <message>
        <source>{}, margin {} beside walls</source>
        <translation>{}, neben Wänden {} Rand</translation>
    </message>
    <message>
        <source>--program-number={}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD posts what has ToolController and Active: take it out of the job.</source>
        <translation>FreeCAD postet, was ToolController und Active hat: Es aus dem Job nehmen.</translation>
    </message>
    <message>
        <source>FreeCAD refused it: check its job, base faces and tool.</source>
        <translation>FreeCAD hat sie abgelehnt: Job, Flächen und Werkzeug prüfen.</translation>
    </message>
    <message>
        <source>FreeCAD takes a tool controller of number 0 for none: give {} another.</source>
        <translation>FreeCAD hält eine Werkzeugsteuerung mit der Nummer 0 für keine: {} eine andere geben.</translation>
    </message>
    <message>
        <source>FreeCAD would read it otherwise: write words of a letter and a number, each letter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD&apos;s paths are in millimetres: take it out.</source>
        <translation>Bahnen von FreeCAD sind in Millimetern: Das Wort herausnehmen.</translation>
    </message>
    <message>
        <source>TCP is on</source>
        <translation>TCP ist eingeschaltet</translation>
    </message>
    <message>
        <source>TCP is {} in line {}</source>
        <translation>TCP ist {} in Zeile {}</translation>
    </message>
    <message>
        <source>a ball end mill alone can be seen so: choose one.</source>
        <translation>So lässt sich nur ein Kugelfräser ansehen: Einen wählen.</translation>
    </message>
    <message>
        <source>a ball of radius {} mm leaves untouched material between marks so far apart: choose less, a smaller cross-feed or a larger ball.</source>
        <translation>Eine Kugel vom Radius {} mm lässt zwischen so weit entfernten Spuren Material stehen: Weniger, einen kleineren Bahnabstand oder eine größere Kugel wählen.</translation>
    </message>
    <message>
        <source>a curved base needs {} of each, a flat one none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a cut needs a feed greater than zero: give it one here.</source>
        <translation>Ein Schnitt braucht einen Vorschub größer als null: Hier einen angeben.</translation>
    </message>
    <message>
        <source>a drilling cycle goes from R down to Z.</source>
        <translation>Ein Bohrzyklus geht von R hinunter nach Z.</translation>
    </message>
    <message>
        <source>a grid needs at least one cell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a lead of {} mm in line {}</source>
        <translation>eine Steigung von {} mm in Zeile {}</translation>
    </message>
    <message>
        <source>a live session cuts scanning lines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a locked path needs no fitting.</source>
        <translation>Eine an die Spindel gekoppelte Bahn braucht keine Anpassung.</translation>
    </message>
    <message>
        <source>a loop of {} points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a move turns the spindle forward.</source>
        <translation>Eine Bewegung dreht die Spindel vorwärts.</translation>
    </message>
    <message>
        <source>a move without feed</source>
        <translation>eine Bewegung ohne Vorschub</translation>
    </message>
    <message>
        <source>a paced path needs two dimples at least: see the counts of those left out, and change the faces, the limits or the tool axis.</source>
        <translation>Eine getaktete Bahn braucht mindestens zwei Mulden: Die Zahl der ausgelassenen ansehen und die Flächen, die Grenzen oder die Werkzeugachse ändern.</translation>
    </message>
    <message>
        <source>a patch of side {} mm would have {} laps: choose a larger cross-feed.</source>
        <translation>Ein Feld mit {} mm Seite hätte {} Umläufe: Einen größeren Bahnabstand wählen.</translation>
    </message>
    <message>
        <source>a patch would have {} marks: choose a larger feed per tooth.</source>
        <translation>Ein Feld hätte {} Spuren: Einen größeren Vorschub je Zahn wählen.</translation>
    </message>
    <message>
        <source>a path in FreeCAD needs one G or M word here.</source>
        <translation>Eine Bahn in FreeCAD braucht hier ein G- oder M-Wort.</translation>
    </message>
    <message>
        <source>a peck greater than zero is needed.</source>
        <translation>Das Ausspanen braucht eine Tiefe größer als null.</translation>
    </message>
    <message>
        <source>a recording has its machine in it: leave it out.</source>
        <translation>Eine Aufzeichnung enthält ihre Maschine: Sie weglassen.</translation>
    </message>
    <message>
        <source>a rotary axis turns in a G33 block, which {} cannot: keep one tool axis for the whole texture, or use feed per move.</source>
        <translation>Eine Drehachse dreht sich in einem G33-Satz, was {} nicht kann: Für die ganze Textur eine Werkzeugachse behalten oder Vorschub je Satz benutzen.</translation>
    </message>
    <message>
        <source>a section goes upward from 0 or more, has radii of 0 or more, and all are at most 1e6 mm.</source>
        <translation>Ein Abschnitt geht von 0 oder mehr nach oben, hat Radien von 0 oder mehr, und alles ist höchstens 1e6 mm.</translation>
    </message>
    <message>
        <source>a shape without faces</source>
        <translation>eine Form ohne Flächen</translation>
    </message>
    <message>
        <source>a spindle-locked move needs a way of the programmed point: rotary axes alone cannot be locked.</source>
        <translation>Eine an die Spindel gekoppelte Bewegung braucht einen Weg des programmierten Punkts: Drehachsen allein lassen sich nicht koppeln.</translation>
    </message>
    <message>
        <source>a spindle-locked move needs more turns than its corner roundings take.</source>
        <translation>Eine an die Spindel gekoppelte Bewegung braucht mehr Umdrehungen als ihre Eckenrundungen.</translation>
    </message>
    <message>
        <source>a stop would end the spindle&apos;s lock: post each patch as a file of its own (patches=1).</source>
        <translation>Ein Halt würde die Kopplung an die Spindel beenden: Jedes Feld als eigene Datei posten (patches=1).</translation>
    </message>
    <message>
        <source>a texture on the surface begins there, and no face can be cut there: move it.</source>
        <translation>Dort beginnt eine Textur auf der Fläche, und dort lässt sich keine Fläche fräsen: Den Ursprung verschieben.</translation>
    </message>
    <message>
        <source>a texture path</source>
        <translation>die Bahn einer Textur</translation>
    </message>
    <message>
        <source>a texture&apos;s feed is its timing and its axis sets the phase: choose another operation.</source>
        <translation>Der Vorschub einer Textur ist ihr Takt, und ihre Achse bestimmt die Phase: Eine andere Operation wählen.</translation>
    </message>
    <message>
        <source>a timed move needs more than no turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vertex at infinity</source>
        <translation>eine Ecke im Unendlichen</translation>
    </message>
    <message>
        <source>about {} dimples are more than the limit of {}: choose a larger spacing or a smaller area.</source>
        <translation>Etwa {} Mulden sind mehr als die Grenze von {}: Einen größeren Abstand oder eine kleinere Fläche wählen.</translation>
    </message>
    <message>
        <source>about {} dimples are more than the limit of {}: choose a larger spacing or fewer faces.</source>
        <translation>Etwa {} Mulden sind mehr als die Grenze von {}: Einen größeren Abstand oder weniger Flächen wählen.</translation>
    </message>
    <message>
        <source>all that follows would be read by it: take it out of the preamble.</source>
        <translation>Alles Folgende würde danach gelesen: Es aus dem Vorspann nehmen.</translation>
    </message>
    <message>
        <source>an arc needs its centre by I and J, in the XY plane.</source>
        <translation>Ein Kreisbogen braucht seinen Mittelpunkt mit I und J in der XY-Ebene.</translation>
    </message>
    <message>
        <source>an edge without a curve</source>
        <translation>eine Kante ohne Kurve</translation>
    </message>
    <message>
        <source>an open shell, {} unmatched edges</source>
        <translation>eine offene Schale, {} Kanten ohne Gegenstück</translation>
    </message>
    <message>
        <source>an upright operation follows, and the machine&apos;s file does not say where the tool is clear of a turning table: give retract_mm there, or bring them back to zero in the operation that turns them.</source>
        <translation>Es folgt eine Operation mit aufrechtem Werkzeug, und die Maschinendatei sagt nicht, wo das Werkzeug über einem drehenden Tisch frei ist: Dort retract_mm angeben, oder die Achsen in der Operation, die sie dreht, auf null zurückbringen.</translation>
    </message>
    <message>
        <source>an upright shank would cut the overhang: put a DCM modifier with posture on {}.</source>
        <translation>Ein aufrechter Schaft würde in den Überhang schneiden: Auf {} einen DCM-Modifikator mit Haltung setzen.</translation>
    </message>
    <message>
        <source>another operation leaves this, not its tool&apos;s length: end that one by G43 H{}.</source>
        <translation>Eine andere Operation hinterlässt dies, nicht die Länge ihres Werkzeugs: Jene mit G43 H{} enden lassen.</translation>
    </message>
    <message>
        <source>at most about {} million are made: give {} mm or more.</source>
        <translation>Es werden höchstens etwa {} Millionen gemacht: {} mm oder mehr angeben.</translation>
    </message>
    <message>
        <source>at this spacing it takes dimples of {} mm, wider than the ball: choose a larger ball or a smaller spacing.</source>
        <translation>Bei diesem Abstand braucht es Mulden von {} mm, breiter als die Kugel: Eine größere Kugel oder einen kleineren Abstand wählen.</translation>
    </message>
    <message>
        <source>axis {} would leave its limits by {} mm.</source>
        <translation>Die Achse {} überschritte ihre Grenzen um {} mm.</translation>
    </message>
    <message>
        <source>byte {} is no UTF-8: save the file as UTF-8.</source>
        <translation>Byte {} ist kein UTF-8: Die Datei als UTF-8 speichern.</translation>
    </message>
    <message>
        <source>byte {} is zero, as in UTF-16 and in what is no text: save the file as plain text.</source>
        <translation>Byte {} ist null, wie in UTF-16 und in anderem als Text: Die Datei als reinen Text speichern.</translation>
    </message>
    <message>
        <source>choose 3, 4 or 6: other regular polygons do not cover a face.</source>
        <translation>3, 4 oder 6 wählen: Andere regelmäßige Vielecke decken keine Fläche.</translation>
    </message>
    <message>
        <source>choose a DCM modifier, or none.</source>
        <translation>Einen DCM-Modifikator wählen, oder keinen.</translation>
    </message>
    <message>
        <source>choose a texture, copy milling or a DCM modifier.</source>
        <translation>Eine Textur, ein Kopierfräsen oder einen DCM-Modifikator wählen.</translation>
    </message>
    <message>
        <source>choose a work offset in the job&apos;s setup, such as G54.</source>
        <translation>Im Setup des Jobs eine Nullpunktverschiebung wählen, etwa G54.</translation>
    </message>
    <message>
        <source>choose an operation or a dressup of a job.</source>
        <translation>Eine Operation oder eine Aufbereitung eines Jobs wählen.</translation>
    </message>
    <message>
        <source>choose faces that have an inside.</source>
        <translation>Flächen wählen, die ein Inneres haben.</translation>
    </message>
    <message>
        <source>choose it so that each axis gets 1 to 32,768 voxels.</source>
        <translation>So wählen, dass jede Achse 1 bis 32.768 Voxel bekommt.</translation>
    </message>
    <message>
        <source>choose square or staggered.</source>
        <translation>Quadratisch oder versetzt wählen.</translation>
    </message>
    <message>
        <source>choose the coolant in the operations that want it: their Coolant says Flood or Mist.</source>
        <translation>Das Kühlmittel in den Operationen wählen, die es brauchen: Ihr Coolant sagt Flood oder Mist.</translation>
    </message>
    <message>
        <source>corner {} of {} vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>count from 0, the first dimple.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dimples {} and {} are at one place on the program&apos;s decimals.</source>
        <translation>Die Mulden {} und {} liegen mit den Nachkommastellen des Programms an einem Ort.</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>empty or infinite</source>
        <translation>leer oder unendlich</translation>
    </message>
    <message>
        <source>enlarge it: there would be more than ten million passes.</source>
        <translation>Ihn vergrößern: Es gäbe mehr als zehn Millionen Durchgänge.</translation>
    </message>
    <message>
        <source>enlarge the tolerance.</source>
        <translation>Die Toleranz vergrößern.</translation>
    </message>
    <message>
        <source>every lattice point was left out ({}): {}.</source>
        <translation>Alle Gitterpunkte wurden ausgelassen ({}): {}.</translation>
    </message>
    <message>
        <source>every lattice point was left out: see the counts by reason, and change the faces, the limits or the tool axis.</source>
        <translation>Alle Gitterpunkte wurden ausgelassen: Die Zahlen nach Gründen ansehen und die Flächen, die Grenzen oder die Werkzeugachse ändern.</translation>
    </message>
    <message>
        <source>every mark was left out: see the counts by reason, and change the faces, the limits or the tool axis.</source>
        <translation>Alle Spuren wurden ausgelassen: Die Zahlen nach Gründen ansehen und die Flächen, die Grenzen oder die Werkzeugachse ändern.</translation>
    </message>
    <message>
        <source>explicit steps are stable up to r = {}: use at most {} s, or allow sub-steps.</source>
        <translation>Explizite Schritte sind bis r = {} stabil: Höchstens {} s nehmen oder Teilschritte erlauben.</translation>
    </message>
    <message>
        <source>faces without area</source>
        <translation>Flächen ohne Inhalt</translation>
    </message>
    <message>
        <source>give 0 &lt;= from &lt; to and diameters of 0 or more.</source>
        <translation>0 &lt;= von &lt; bis und Durchmesser von 0 oder mehr angeben.</translation>
    </message>
    <message>
        <source>give 0 or at least FeedAtSkin.</source>
        <translation>0 oder mindestens den Vorschub an der Rohteilhaut angeben.</translation>
    </message>
    <message>
        <source>give 0 or more.</source>
        <translation>0 oder mehr angeben.</translation>
    </message>
    <message>
        <source>give 0 to {} decimals.</source>
        <translation>0 bis {} Nachkommastellen angeben.</translation>
    </message>
    <message>
        <source>give 0, 1 or 2 for x, y or z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give 1 or more.</source>
        <translation>1 oder mehr angeben.</translation>
    </message>
    <message>
        <source>give 255 at most.</source>
        <translation>Höchstens 255 angeben.</translation>
    </message>
    <message>
        <source>give A, B or C.</source>
        <translation>A, B oder C angeben.</translation>
    </message>
    <message>
        <source>give a closed solid; mend the gaps or the flipped triangles.</source>
        <translation>Einen geschlossenen Körper angeben; die Lücken oder die gewendeten Dreiecke ausbessern.</translation>
    </message>
    <message>
        <source>give a depth greater than zero.</source>
        <translation>Eine Tiefe größer als null angeben.</translation>
    </message>
    <message>
        <source>give a direction: finite, and not zero.</source>
        <translation>Eine Richtung angeben: endlich und nicht null.</translation>
    </message>
    <message>
        <source>give a factor greater than zero.</source>
        <translation>Einen Faktor größer als null angeben.</translation>
    </message>
    <message>
        <source>give a finite vector other than zero; a voxel model has none inside the part.</source>
        <translation>Einen endlichen Vektor ungleich null angeben; ein Voxelmodell hat im Inneren des Teils keinen.</translation>
    </message>
    <message>
        <source>give a finite vector that is not zero.</source>
        <translation>Einen endlichen Vektor ungleich null angeben.</translation>
    </message>
    <message>
        <source>give a function of positions and normals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a height above 0 and up to the ball&apos;s radius, {} mm.</source>
        <translation>Eine Höhe über 0 und bis zum Kugelradius angeben, {} mm.</translation>
    </message>
    <message>
        <source>give a length greater than zero.</source>
        <translation>Eine Länge größer als null angeben.</translation>
    </message>
    <message>
        <source>give a name, a factor on the feed, and a depth in mm or the name of a solid, such as &apos;skin 0.6 1.5&apos;.</source>
        <translation>Einen Namen, einen Faktor auf den Vorschub und eine Tiefe in mm oder den Namen eines Körpers angeben, etwa &apos;skin 0.6 1.5&apos;.</translation>
    </message>
    <message>
        <source>give a number of decimals, such as 3.</source>
        <translation>Eine Anzahl von Nachkommastellen angeben, etwa 3.</translation>
    </message>
    <message>
        <source>give a number.</source>
        <translation>Eine Zahl angeben.</translation>
    </message>
    <message>
        <source>give a path of this texture&apos;s plan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a path whose moves are all timed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a positive jerk in mm/s³, or leave it out for none.</source>
        <translation>Einen positiven Ruck in mm/s³ angeben, oder ihn für keinen weglassen.</translation>
    </message>
    <message>
        <source>give a shape with faces.</source>
        <translation>Eine Form mit Flächen angeben.</translation>
    </message>
    <message>
        <source>give a size greater than zero.</source>
        <translation>Eine Größe größer als null angeben.</translation>
    </message>
    <message>
        <source>give a solid whose surface faces outwards.</source>
        <translation>Einen Körper angeben, dessen Oberfläche nach außen weist.</translation>
    </message>
    <message>
        <source>give a solid with a tessellated surface.</source>
        <translation>Einen Körper mit vernetzter Oberfläche angeben.</translation>
    </message>
    <message>
        <source>give a stock larger than the part, or smaller voxels.</source>
        <translation>Ein Rohteil angeben, das größer als das Teil ist, oder kleinere Voxel.</translation>
    </message>
    <message>
        <source>give a stock with length, width and height.</source>
        <translation>Ein Rohteil mit Länge, Breite und Höhe angeben.</translation>
    </message>
    <message>
        <source>give a tessellated surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a texture of the job.</source>
        <translation>Eine Textur des Jobs angeben.</translation>
    </message>
    <message>
        <source>give a value from 0 to 90 degrees.</source>
        <translation>Einen Wert von 0 bis 90 Grad angeben.</translation>
    </message>
    <message>
        <source>give a vector other than zero.</source>
        <translation>Einen Vektor ungleich null angeben.</translation>
    </message>
    <message>
        <source>give a whole multiple of {} turn, so that a flute is at the contact point again.</source>
        <translation>Ein ganzes Vielfaches von {} Umdrehungen angeben, damit wieder eine Schneide am Berührpunkt ist.</translation>
    </message>
    <message>
        <source>give a whole number, from 1.</source>
        <translation>Eine ganze Zahl ab 1 angeben.</translation>
    </message>
    <message>
        <source>give an angle above 0° and up to 90°.</source>
        <translation>Einen Winkel über 0° und bis 90° angeben.</translation>
    </message>
    <message>
        <source>give an area with finite corners.</source>
        <translation>Eine Fläche mit endlichen Ecken angeben.</translation>
    </message>
    <message>
        <source>give an operation of PatchMill.</source>
        <translation>Eine Operation von PatchMill angeben.</translation>
    </message>
    <message>
        <source>give at least 0 and less than {} degrees.</source>
        <translation>Mindestens 0 und weniger als {} Grad angeben.</translation>
    </message>
    <message>
        <source>give at least the lower feed.</source>
        <translation>Mindestens den unteren Vorschub angeben.</translation>
    </message>
    <message>
        <source>give at least the safe height, {} mm.</source>
        <translation>Mindestens die Sicherheitshöhe angeben, {} mm.</translation>
    </message>
    <message>
        <source>give closed loops of at least three finite points.</source>
        <translation>Geschlossene Kurven mit mindestens drei endlichen Punkten angeben.</translation>
    </message>
    <message>
        <source>give each axis its own.</source>
        <translation>Jeder Achse einen eigenen geben.</translation>
    </message>
    <message>
        <source>give either the feed per tooth or the ridge height.</source>
        <translation>Entweder den Vorschub je Zahn oder die Grathöhe angeben.</translation>
    </message>
    <message>
        <source>give finite ((x, y) least, (x, y) greatest) in mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give finite numbers.</source>
        <translation>Endliche Zahlen angeben.</translation>
    </message>
    <message>
        <source>give finite rows (time, x, y, z, spindle azimuth).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give finite vertices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give four numbers: from, to, two diameters.</source>
        <translation>Vier Zahlen angeben: von, bis, zwei Durchmesser.</translation>
    </message>
    <message>
        <source>give how many a file has at most, or 0.</source>
        <translation>Angeben, wie viele eine Datei höchstens hat, oder 0.</translation>
    </message>
    <message>
        <source>give it.</source>
        <translation>Es angeben.</translation>
    </message>
    <message>
        <source>give more than 0 and at most {} degrees.</source>
        <translation>Mehr als 0 und höchstens {} Grad angeben.</translation>
    </message>
    <message>
        <source>give more than zero and less than the part&apos;s width.</source>
        <translation>Mehr als null und weniger als die Breite des Teils angeben.</translation>
    </message>
    <message>
        <source>give more than zero and no more than FeedAtSkin, {} mm/min.</source>
        <translation>Mehr als null und nicht mehr als den Vorschub an der Rohteilhaut angeben, {} mm/min.</translation>
    </message>
    <message>
        <source>give no less than FirstPatch, {}.</source>
        <translation>Nicht weniger als das erste Feld angeben, {}.</translation>
    </message>
    <message>
        <source>give numbers of zero or more.</source>
        <translation>Zahlen ab null angeben.</translation>
    </message>
    <message>
        <source>give one for each flute, or none.</source>
        <translation>Je Schneide einen Wert angeben, oder keinen.</translation>
    </message>
    <message>
        <source>give one for each of the {} dimples.</source>
        <translation>Für jede der {} Mulden einen angeben.</translation>
    </message>
    <message>
        <source>give one for each of the {} {}.</source>
        <translation>Für jedes der {} {} eins angeben.</translation>
    </message>
    <message>
        <source>give one for each text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give one for the start and one per move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give one for the stock and one for each material.</source>
        <translation>Einen für das Rohteil und einen für jeden Werkstoff angeben.</translation>
    </message>
    <message>
        <source>give one greater than zero.</source>
        <translation>Einen größer als null angeben.</translation>
    </message>
    <message>
        <source>give one of path, program and samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give one of the lattice&apos;s {} steps.</source>
        <translation>Einen der {} Schritte des Gitters angeben.</translation>
    </message>
    <message>
        <source>give one of: {}.</source>
        <translation>Eins davon angeben: {}.</translation>
    </message>
    <message>
        <source>give one role and one value per field for each of the grid&apos;s {} cells.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give one value for each pixel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give the least corner first.</source>
        <translation>Zuerst die kleinere Ecke angeben.</translation>
    </message>
    <message>
        <source>give the least corner first; all sides must be longer than zero.</source>
        <translation>Zuerst die kleinere Ecke angeben; alle Seiten müssen länger als null sein.</translation>
    </message>
    <message>
        <source>give the lower limit first.</source>
        <translation>Zuerst die untere Grenze angeben.</translation>
    </message>
    <message>
        <source>give the name of a post-processor.</source>
        <translation>Den Namen eines Postprozessors angeben.</translation>
    </message>
    <message>
        <source>give three finite numbers.</source>
        <translation>Drei endliche Zahlen angeben.</translation>
    </message>
    <message>
        <source>give triangles whose corners are vertices of the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give two different finite corners.</source>
        <translation>Zwei verschiedene endliche Ecken angeben.</translation>
    </message>
    <message>
        <source>give two rotary axes at most.</source>
        <translation>Höchstens zwei Drehachsen angeben.</translation>
    </message>
    <message>
        <source>give two vectors that are not parallel.</source>
        <translation>Zwei Vektoren angeben, die nicht parallel sind.</translation>
    </message>
    <message>
        <source>give values from 0 to 1.</source>
        <translation>Werte von 0 bis 1 angeben.</translation>
    </message>
    <message>
        <source>give whole numbers of rpm greater than zero.</source>
        <translation>Ganze Drehzahlen in 1/min größer als null angeben.</translation>
    </message>
    <message>
        <source>give zero or more.</source>
        <translation>Null oder mehr angeben.</translation>
    </message>
    <message>
        <source>give {} mm or more.</source>
        <translation>{} mm oder mehr angeben.</translation>
    </message>
    <message>
        <source>give {} more than zero.</source>
        <translation>Für {} mehr als null angeben.</translation>
    </message>
    <message>
        <source>give {} the width of its flat tip, more than 0.</source>
        <translation>{} die Breite der flachen Spitze geben, mehr als 0.</translation>
    </message>
    <message>
        <source>in the free form every flute leaves a mark: allow any.</source>
        <translation>In der freien Form hinterlässt jede Schneide eine Spur: Jede zulassen.</translation>
    </message>
    <message>
        <source>in the free form the phase follows from the feed: choose &apos;{}&apos;.</source>
        <translation>In der freien Form folgt die Phase aus dem Vorschub: „{}“ wählen.</translation>
    </message>
    <message>
        <source>invalid</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>it belongs to no job: choose one that does.</source>
        <translation>Sie gehört zu keinem Job: Eine wählen, die zu einem gehört.</translation>
    </message>
    <message>
        <source>it can be one of trivkins, {}: take a machine file of that kind and change it.</source>
        <translation>Möglich sind trivkins, {}: Eine Maschinendatei dieser Art nehmen und ändern.</translation>
    </message>
    <message>
        <source>it cannot be read ({}): give another file.</source>
        <translation>Sie lässt sich nicht lesen ({}): Eine andere Datei angeben.</translation>
    </message>
    <message>
        <source>it cannot be read ({}): save it as PNG.</source>
        <translation>Es lässt sich nicht lesen ({}): Es als PNG speichern.</translation>
    </message>
    <message>
        <source>it cannot be taken away ({}): change the folder&apos;s permissions.</source>
        <translation>Sie lässt sich nicht löschen ({}): Die Rechte des Ordners ändern.</translation>
    </message>
    <message>
        <source>it cannot be with a tilted tool, whose moves are in inverse time: set Controls to Feed.</source>
        <translation>Mit geneigtem Werkzeug, dessen Bewegungen in inverser Zeit stehen, geht es nicht: „Regelt“ auf Vorschub setzen.</translation>
    </message>
    <message>
        <source>it cannot be written ({}): give another file.</source>
        <translation>Sie lässt sich nicht schreiben ({}): Eine andere Datei angeben.</translation>
    </message>
    <message>
        <source>it could not be written: make room or choose a folder.</source>
        <translation>Sie ließ sich nicht schreiben: Platz schaffen oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>it does not keep {}{} of {}: use one of PatchMill&apos;s own posts.</source>
        <translation>Er behält {}{} von {} nicht: Einen der Postprozessoren von PatchMill benutzen.</translation>
    </message>
    <message>
        <source>it does not take the arguments {}: change them, or use another post-processor.</source>
        <translation>Er nimmt die Argumente {} nicht: Sie ändern oder einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>it failed ({}): use another post-processor.</source>
        <translation>Er ist gescheitert ({}): Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>it failed in a way that FreeCAD&apos;s report view tells.</source>
        <translation>Sie ist auf eine Weise gescheitert, die FreeCADs Ausgabefenster nennt.</translation>
    </message>
    <message>
        <source>it has an error, so that nothing after it is computed: mend it.</source>
        <translation>Sie hat einen Fehler, so dass nichts nach ihr berechnet wird: Ihn beheben.</translation>
    </message>
    <message>
        <source>it has more than {} bytes: give a smaller file.</source>
        <translation>Sie hat mehr als {} Byte: Eine kleinere Datei angeben.</translation>
    </message>
    <message>
        <source>it has no moves: recompute it.</source>
        <translation>Sie hat keine Bewegungen: Sie neu berechnen.</translation>
    </message>
    <message>
        <source>it has no path: take it out of the job&apos;s operations.</source>
        <translation>Sie hat keine Bahn: Sie aus den Operationen des Jobs nehmen.</translation>
    </message>
    <message>
        <source>it has no posture.</source>
        <translation>Sie hat keine Haltung.</translation>
    </message>
    <message>
        <source>it has no rotary axes: choose a machine that has, or only Feed.</source>
        <translation>Sie hat keine Drehachsen: Eine Maschine mit Drehachsen wählen, oder nur Vorschub.</translation>
    </message>
    <message>
        <source>it has no surface: repair the shape.</source>
        <translation>Sie hat keine Oberfläche: Die Form in Ordnung bringen.</translation>
    </message>
    <message>
        <source>it has no wires: choose sketches or wires.</source>
        <translation>Sie hat keine Drähte: Skizzen oder Drähte wählen.</translation>
    </message>
    <message>
        <source>it includes itself.</source>
        <translation>Sie schließt sich selbst ein.</translation>
    </message>
    <message>
        <source>it is a device or a pipe, not a file: give another one.</source>
        <translation>Sie ist ein Gerät oder eine Pipe, keine Datei: Eine andere angeben.</translation>
    </message>
    <message>
        <source>it is a device or a pipe, not a file: name another one.</source>
        <translation>Sie ist ein Gerät oder eine Pipe, keine Datei: Eine andere nennen.</translation>
    </message>
    <message>
        <source>it is empty: give the program of this job.</source>
        <translation>Es ist leer: Das Programm dieses Jobs angeben.</translation>
    </message>
    <message>
        <source>it is gone: choose a face again.</source>
        <translation>Sie ist nicht mehr da: Eine Fläche neu wählen.</translation>
    </message>
    <message>
        <source>it is inside out, its faces look into it: reverse the shape, or make the solid again.</source>
        <translation>Er ist umgestülpt, seine Flächen blicken nach innen: Die Form umkehren oder den Körper neu erzeugen.</translation>
    </message>
    <message>
        <source>it is nested too deeply.</source>
        <translation>Sie ist zu tief verschachtelt.</translation>
    </message>
    <message>
        <source>it is no LinuxCNC configuration: it says nothing of axes.</source>
        <translation>Es ist keine Konfiguration von LinuxCNC: Sie nennt keine Achsen.</translation>
    </message>
    <message>
        <source>it is no work offset of a control: choose G54 to G59.3 in the job&apos;s setup.</source>
        <translation>Sie ist keine Nullpunktverschiebung einer Steuerung: Im Setup des Jobs G54 bis G59.3 wählen.</translation>
    </message>
    <message>
        <source>it is not in the job {}: choose faces of {}.</source>
        <translation>Es ist nicht im Job {}: Flächen von {} wählen.</translation>
    </message>
    <message>
        <source>it is of an earlier posting, and would be run after these: take it away.</source>
        <translation>Sie stammt von einem früheren Posten und liefe nach diesen: Sie löschen.</translation>
    </message>
    <message>
        <source>it is parallel to axis {}: two parallel rotary axes are one.</source>
        <translation>Sie ist parallel zur Achse {}: Zwei parallele Drehachsen sind eine.</translation>
    </message>
    <message>
        <source>it is switched off.</source>
        <translation>Sie ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>it stands twice, and all would be milled twice at one place: name it once.</source>
        <translation>Sie steht zweimal da, und alles würde an einem Ort zweimal gefräst: Sie einmal nennen.</translation>
    </message>
    <message>
        <source>it would change a texture&apos;s path, which is its timing: take it away.</source>
        <translation>Er würde die Bahn einer Textur ändern, die ihr Takt ist: Ihn entfernen.</translation>
    </message>
    <message>
        <source>it would end the program, which the post does: take it out.</source>
        <translation>Es würde das Programm beenden, was der Postprozessor tut: Es herausnehmen.</translation>
    </message>
    <message>
        <source>it would have to turn at {} times its greatest velocity in move {}: smooth the tool axes, or {}.</source>
        <translation>Sie müsste sich in Bewegung {1} mit dem {0}-fachen ihrer größten Geschwindigkeit drehen: Die Werkzeugachsen glätten, oder {2}.</translation>
    </message>
    <message>
        <source>it would take {} GB of memory, and {} GB are free: {}</source>
        <translation>Es würde {} GB Speicher brauchen, und {} GB sind frei: {}</translation>
    </message>
    <message>
        <source>it would take {} GB: scale it down to {} million pixels, one for each dimple does.</source>
        <translation>Es würde {} GB brauchen: Es auf {} Millionen Pixel verkleinern, eins je Mulde genügt.</translation>
    </message>
    <message>
        <source>it wrote nothing: use another post-processor.</source>
        <translation>Er hat nichts geschrieben: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>its controller does not keep the tool tip: choose one with TCP.</source>
        <translation>Ihre Steuerung führt die Werkzeugspitze nicht nach: Eine mit TCP wählen.</translation>
    </message>
    <message>
        <source>its ends are not on one circle, by {} mm: choose another operation.</source>
        <translation>Seine Enden liegen nicht auf einem Kreis, um {} mm: Eine andere Operation wählen.</translation>
    </message>
    <message>
        <source>its feed is a timing, which must not change.</source>
        <translation>Ihr Vorschub ist ein Takt, der sich nicht ändern darf.</translation>
    </message>
    <message>
        <source>its motion is not known: {}.</source>
        <translation>Ihre Bewegung ist nicht bekannt: {}.</translation>
    </message>
    <message>
        <source>its start phase was found by a version that counted it anew in each program: mill a calibration patch anew.</source>
        <translation>Ihre Startphase wurde mit einer Version gefunden, die sie in jedem Programm neu zählte: Ein neues Kalibrierfeld fräsen.</translation>
    </message>
    <message>
        <source>its start phase was found with the controller &apos;{}&apos;, and it has &apos;{}&apos;: mill a calibration patch anew.</source>
        <translation>Ihre Startphase wurde mit der Werkzeugsteuerung „{}“ gefunden, und sie hat „{}“: Ein neues Kalibrierfeld fräsen.</translation>
    </message>
    <message>
        <source>its tool is tilted already: choose an upright path.</source>
        <translation>Ihr Werkzeug ist schon geneigt: Eine Bahn mit aufrechtem Werkzeug wählen.</translation>
    </message>
    <message>
        <source>leave its feed alone: a texture&apos;s feed is its timing.</source>
        <translation>Ihren Vorschub lassen: Der Vorschub einer Textur ist ihr Takt.</translation>
    </message>
    <message>
        <source>legs can be fitted to stops only where the machine stops: use exact stop.</source>
        <translation>Wege lassen sich nur dort an Halte anpassen, wo die Maschine hält: Genauhalt benutzen.</translation>
    </message>
    <message>
        <source>let the operation mill a face of the job&apos;s model.</source>
        <translation>Die Operation eine Fläche des Modells im Job fräsen lassen.</translation>
    </message>
    <message>
        <source>line {} begins at X{} Y{} Z{}</source>
        <translation>Zeile {} beginnt bei X{} Y{} Z{}</translation>
    </message>
    <message>
        <source>live, choose the whole model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lower limit above the upper one</source>
        <translation>untere Grenze über der oberen</translation>
    </message>
    <message>
        <source>make voxels about {} mm or raise the memory limit.</source>
        <translation>Voxel von etwa {} mm nehmen oder die Speichergrenze heraufsetzen.</translation>
    </message>
    <message>
        <source>masks need dimples on a lattice: choose None.</source>
        <translation>Masken brauchen Mulden auf einem Gitter: „Keine“ wählen.</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>move the part into the stock or enlarge it.</source>
        <translation>Das Teil in das Rohteil schieben oder es vergrößern.</translation>
    </message>
    <message>
        <source>move the part into the stock or enlarge the stock.</source>
        <translation>Das Teil in das Rohteil schieben oder das Rohteil vergrößern.</translation>
    </message>
    <message>
        <source>name a machine file with rotary axes: they tilt the tool.</source>
        <translation>Eine Maschinendatei mit Drehachsen nennen: Sie neigen das Werkzeug.</translation>
    </message>
    <message>
        <source>name the machine on which the patch was milled.</source>
        <translation>Die Maschine nennen, auf der das Feld gefräst wurde.</translation>
    </message>
    <message>
        <source>no JSON</source>
        <translation>kein JSON</translation>
    </message>
    <message>
        <source>no Resources/machines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no dimples</source>
        <translation>keine Mulden</translation>
    </message>
    <message>
        <source>no direction at dimple {}</source>
        <translation>keine Richtung bei Mulde {}</translation>
    </message>
    <message>
        <source>no machine</source>
        <translation>keine Maschine</translation>
    </message>
    <message>
        <source>no operation, tool or work offset there has this word: take it out of the post.</source>
        <translation>Keine Operation, kein Werkzeug und keine Nullpunktverschiebung hat dort dieses Wort: Es aus dem Postprozessor nehmen.</translation>
    </message>
    <message>
        <source>no path</source>
        <translation>keine Bahn</translation>
    </message>
    <message>
        <source>no phase is wanted at this dimple.</source>
        <translation>An dieser Mulde ist keine Phase gefordert.</translation>
    </message>
    <message>
        <source>no phase is wanted there.</source>
        <translation>Dort ist keine Phase gefordert.</translation>
    </message>
    <message>
        <source>no place of the faces can be cut from this direction: choose another direction, a steeper limit or other faces.</source>
        <translation>Aus dieser Richtung lässt sich kein Ort der Flächen fräsen: Eine andere Richtung, eine steilere Grenze oder andere Flächen wählen.</translation>
    </message>
    <message>
        <source>no places</source>
        <translation>keine Orte</translation>
    </message>
    <message>
        <source>no posture for dimple {}</source>
        <translation>keine Haltung für Mulde {}</translation>
    </message>
    <message>
        <source>no shape</source>
        <translation>keine Form</translation>
    </message>
    <message>
        <source>no volume</source>
        <translation>kein Volumen</translation>
    </message>
    <message>
        <source>no way in</source>
        <translation>kein Anfahrweg</translation>
    </message>
    <message>
        <source>none of its moves end on the texture&apos;s dimples.</source>
        <translation>Keine ihrer Bewegungen endet auf den Mulden der Textur.</translation>
    </message>
    <message>
        <source>none over the part</source>
        <translation>keine über dem Teil</translation>
    </message>
    <message>
        <source>not Scanning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not computed</source>
        <translation>nicht berechnet</translation>
    </message>
    <message>
        <source>not finite</source>
        <translation>nicht endlich</translation>
    </message>
    <message>
        <source>not in the program</source>
        <translation>nicht im Programm</translation>
    </message>
    <message>
        <source>one tooth per dimple takes {} mm/s: turn the spindle at no more than {} rpm.</source>
        <translation>Ein Zahn je Mulde verlangt {} mm/s: Die Spindel mit höchstens {} 1/min drehen.</translation>
    </message>
    <message>
        <source>only your own machine files can be taken away.</source>
        <translation>Nur eigene Maschinendateien lassen sich löschen.</translation>
    </message>
    <message>
        <source>other K or F words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other K or F words in line {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other words G61 and G64</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plan one for each of the {} dimples.</source>
        <translation>Für jede der {} Mulden eine planen.</translation>
    </message>
    <message>
        <source>plan the postures of these dimples.</source>
        <translation>Die Haltungen dieser Mulden planen.</translation>
    </message>
    <message>
        <source>post the operations of a job.</source>
        <translation>Die Operationen eines Jobs posten.</translation>
    </message>
    <message>
        <source>programs are in ASCII letters: use no others.</source>
        <translation>Programme bestehen aus ASCII-Zeichen: Keine anderen benutzen.</translation>
    </message>
    <message>
        <source>recordings are cut with an upright tool only.</source>
        <translation>Aufzeichnungen werden nur mit aufrechtem Werkzeug gefräst.</translation>
    </message>
    <message>
        <source>repair the operation before posting.</source>
        <translation>Vor dem Posten die Operation in Ordnung bringen.</translation>
    </message>
    <message>
        <source>repair the shape.</source>
        <translation>Die Form in Ordnung bringen.</translation>
    </message>
    <message>
        <source>rotary axes</source>
        <translation>Drehachsen</translation>
    </message>
    <message>
        <source>rotary words</source>
        <translation>Drehachsenwörter</translation>
    </message>
    <message>
        <source>rounded corners (G64)</source>
        <translation>gerundete Ecken (G64)</translation>
    </message>
    <message>
        <source>samples must be in order of time.</source>
        <translation>Aufzeichnungen müssen nach der Zeit geordnet sein.</translation>
    </message>
    <message>
        <source>say which copy goes on.</source>
        <translation>Sagen, welche Kopie fortgesetzt wird.</translation>
    </message>
    <message>
        <source>say which of the job&apos;s goes on.</source>
        <translation>Sagen, welche des Jobs fortgesetzt wird.</translation>
    </message>
    <message>
        <source>select a face, not an edge or a vertex.</source>
        <translation>Eine Fläche auswählen, keine Kante und keine Ecke.</translation>
    </message>
    <message>
        <source>select at least one face.</source>
        <translation>Mindestens eine Fläche auswählen.</translation>
    </message>
    <message>
        <source>set Flutes of {} to what the tool has; proposed: {}, as most ball end mills have.</source>
        <translation>Flutes von {} auf die Schneidenzahl des Werkzeugs setzen; vorgeschlagen: {}, wie bei den meisten Kugelfräsern.</translation>
    </message>
    <message>
        <source>set the feeds of its tool controller.</source>
        <translation>Die Vorschübe seiner Werkzeugsteuerung setzen.</translation>
    </message>
    <message>
        <source>several motions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spindle-locked</source>
        <translation>an die Spindel gekoppelt</translation>
    </message>
    <message>
        <source>take only the posture from the voxel model: a texture&apos;s feed is its timing.</source>
        <translation>Vom Voxelmodell nur die Haltung nehmen: Der Vorschub einer Textur ist ihr Takt.</translation>
    </message>
    <message>
        <source>textures are posted in millimetres.</source>
        <translation>Texturen werden in Millimetern gepostet.</translation>
    </message>
    <message>
        <source>the angle between the flanks of {} is more than 0 and at most 120 degrees.</source>
        <translation>Der Winkel zwischen den Flanken von {} ist größer als 0 und höchstens 120 Grad.</translation>
    </message>
    <message>
        <source>the control of the machine {} takes {}: give --precision={} and the same Decimals.</source>
        <translation>Die Steuerung der Maschine {} nimmt {}: --precision={} und ebenso viele Nachkommastellen angeben.</translation>
    </message>
    <message>
        <source>the direction is parallel to the texture&apos;s x axis: choose another one.</source>
        <translation>Die Richtung ist parallel zur x-Achse der Textur: Eine andere wählen.</translation>
    </message>
    <message>
        <source>the faces look to all sides alike: switch it off and give a direction.</source>
        <translation>Die Flächen blicken gleichermaßen nach allen Seiten: Es ausschalten und eine Richtung angeben.</translation>
    </message>
    <message>
        <source>the feed makes {} mm a tooth: give the same.</source>
        <translation>Der Vorschub ergibt {} mm je Zahn: Dasselbe angeben.</translation>
    </message>
    <message>
        <source>the file is read-only: name another one.</source>
        <translation>Die Datei ist schreibgeschützt: Eine andere nennen.</translation>
    </message>
    <message>
        <source>the flat bottom of {} is within its radius, {} mm.</source>
        <translation>Der flache Boden von {} liegt innerhalb seines Radius, {} mm.</translation>
    </message>
    <message>
        <source>the folder cannot be made ({}): set PATCHMILL_MACHINES to another one.</source>
        <translation>Der Ordner lässt sich nicht anlegen ({}): PATCHMILL_MACHINES auf einen anderen setzen.</translation>
    </message>
    <message>
        <source>the free form has its spindle speed from the feed per tooth.</source>
        <translation>Die freie Form hat ihre Drehzahl aus dem Vorschub je Zahn.</translation>
    </message>
    <message>
        <source>the free form has no lattice: choose Helix.</source>
        <translation>Die freie Form hat kein Gitter: Helix wählen.</translation>
    </message>
    <message>
        <source>the free form is milled as a whole: give {}.</source>
        <translation>Die freie Form wird als Ganzes gefräst: {} angeben.</translation>
    </message>
    <message>
        <source>the free form&apos;s marks overlap: choose so.</source>
        <translation>Die Spuren der freien Form überlappen: Dies wählen.</translation>
    </message>
    <message>
        <source>the installation is not complete.</source>
        <translation>Die Installation ist nicht vollständig.</translation>
    </message>
    <message>
        <source>the job has {}.</source>
        <translation>Der Job hat {}.</translation>
    </message>
    <message>
        <source>the job makes {} files: post them with post_files().</source>
        <translation>Der Job ergibt {} Dateien: Sie mit post_files() posten.</translation>
    </message>
    <message>
        <source>the limit is {} GB: take {} mm or more, or a smaller window.</source>
        <translation>Die Grenze ist {} GB: {} mm oder mehr nehmen, oder ein kleineres Fenster.</translation>
    </message>
    <message>
        <source>the machine file says that this controller cannot follow the spindle: use the feed-per-move strategy, or set the machine&apos;s spindle lock if it can.</source>
        <translation>Die Maschinendatei sagt, dass diese Steuerung der Spindel nicht folgen kann: Die Strategie Vorschub je Satz benutzen, oder die Spindelkopplung der Maschine einschalten, wenn sie es kann.</translation>
    </message>
    <message>
        <source>the machine goes up to {} mm/min.</source>
        <translation>Die Maschine erreicht {} mm/min.</translation>
    </message>
    <message>
        <source>the machine {} has no TCP.</source>
        <translation>Die Maschine {} hat kein TCP.</translation>
    </message>
    <message>
        <source>the machine {} has the control {}: use patchmill_{}, or choose another machine.</source>
        <translation>Die Maschine {} hat die Steuerung {}: patchmill_{} benutzen oder eine andere Maschine wählen.</translation>
    </message>
    <message>
        <source>the machine {} says that its controller cannot follow the spindle: use feed per move or constant feed.</source>
        <translation>Die Maschine {} sagt, dass ihre Steuerung der Spindel nicht folgen kann: Vorschub je Satz oder festen Vorschub benutzen.</translation>
    </message>
    <message>
        <source>the mesh is not closed: repair it, or take it out of the job.</source>
        <translation>Das Netz ist nicht geschlossen: Es ausbessern oder aus dem Job nehmen.</translation>
    </message>
    <message>
        <source>the net would have {} nodes, more than the limit of {}: choose a larger spacing or a smaller area.</source>
        <translation>Das Netz hätte {} Knoten, mehr als die Grenze von {}: Einen größeren Abstand oder eine kleinere Fläche wählen.</translation>
    </message>
    <message>
        <source>the next operation with {} would find the spindle so: end this one by M{}.</source>
        <translation>Die nächste Operation mit {} fände die Spindel so vor: Diese mit M{} enden lassen.</translation>
    </message>
    <message>
        <source>the operation begins at X{} Y{} Z{}: use another post-processor.</source>
        <translation>Die Operation beginnt bei X{} Y{} Z{}: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the operation has F {} there: use another post-processor.</source>
        <translation>Die Operation hat dort F {}: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the operation has another one there: use another post-processor.</source>
        <translation>Die Operation hat dort ein anderes: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the operation has no such word: use another post-processor.</source>
        <translation>Die Operation hat kein solches Wort: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the operation has {} there: use another post-processor.</source>
        <translation>Die Operation hat dort {}: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the operation has {}: use another post-processor.</source>
        <translation>Die Operation hat {}: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the operation is milled with TCP {}: use another post-processor.</source>
        <translation>Die Operation wird mit TCP {} gefräst: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the operation under it is gone: delete the dressup.</source>
        <translation>Die Operation darunter ist nicht mehr da: Die Aufbereitung löschen.</translation>
    </message>
    <message>
        <source>the patch has no two passes at a cross-feed of {} mm: choose a longer side.</source>
        <translation>Das Feld hat bei einem Bahnabstand von {} mm keine zwei Durchgänge: Eine längere Seite wählen.</translation>
    </message>
    <message>
        <source>the patch has {}.</source>
        <translation>Das Feld hat {}.</translation>
    </message>
    <message>
        <source>the path ends a move on a dimple that the plan does not cut.</source>
        <translation>Die Bahn beendet eine Bewegung auf einer Mulde, die der Plan nicht fräst.</translation>
    </message>
    <message>
        <source>the path has no timed move before its first dimple that could be lengthened.</source>
        <translation>Die Bahn hat vor ihrer ersten Mulde keine getaktete Bewegung, die sich verlängern ließe.</translation>
    </message>
    <message>
        <source>the path is not of constant feed {} mm/s.</source>
        <translation>Die Bahn hat nicht den festen Vorschub {} mm/s.</translation>
    </message>
    <message>
        <source>the path would take {} interpolation periods: too many to follow one by one.</source>
        <translation>Die Bahn würde {} Interpolationstakte dauern: zu viele, um ihnen einzeln zu folgen.</translation>
    </message>
    <message>
        <source>the post leaves TCP on for what comes after it: end the operation by {}.</source>
        <translation>Der Postprozessor lässt TCP für das Folgende eingeschaltet: Die Operation mit {} enden lassen.</translation>
    </message>
    <message>
        <source>the post leaves it on for {}, whose coolant is None: end the operation by M9.</source>
        <translation>Der Postprozessor lässt es für {} eingeschaltet, das kein Kühlmittel hat: Die Operation mit M9 enden lassen.</translation>
    </message>
    <message>
        <source>the post leaves it on for {}: end the operation by {}.</source>
        <translation>Der Postprozessor lässt es für {} eingeschaltet: Die Operation mit {} enden lassen.</translation>
    </message>
    <message>
        <source>the post writes {} decimals: give --precision={} or change Decimals.</source>
        <translation>Der Postprozessor schreibt {} Nachkommastellen: --precision={} angeben oder die Nachkommastellen ändern.</translation>
    </message>
    <message>
        <source>the post-processor changed the path: use another one.</source>
        <translation>Der Postprozessor hat die Bahn verändert: Einen anderen benutzen.</translation>
    </message>
    <message>
        <source>the post-processor does not keep them: use patchmill_linuxcnc.</source>
        <translation>Der Postprozessor behält sie nicht: patchmill_linuxcnc benutzen.</translation>
    </message>
    <message>
        <source>the posted text has a phase error of {} degrees in {} runs: post more decimals.</source>
        <translation>Der gepostete Text hat einen Phasenfehler von {} Grad in {} Läufen: Mit mehr Nachkommastellen posten.</translation>
    </message>
    <message>
        <source>the posted text turns the spindle at {} rpm where {} is milled.</source>
        <translation>Der gepostete Text dreht die Spindel mit {} 1/min, wo {} gefräst wird.</translation>
    </message>
    <message>
        <source>the posted text turns the spindle at {} rpm {}.</source>
        <translation>Der gepostete Text dreht die Spindel mit {} 1/min {}.</translation>
    </message>
    <message>
        <source>the posture did not converge (residual {}): try another size.</source>
        <translation>Die Haltung konvergiert nicht (Rest {}): Eine andere Größe versuchen.</translation>
    </message>
    <message>
        <source>the program does not call the tool&apos;s length: use another post-processor.</source>
        <translation>Das Programm ruft die Werkzeuglänge nicht auf: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the program does not have it: use a post-processor that keeps it, or leave it out.</source>
        <translation>Das Programm hat es nicht: Einen Postprozessor benutzen, der es behält, oder es weglassen.</translation>
    </message>
    <message>
        <source>the program does not switch it on for {}: choose None, or another post-processor.</source>
        <translation>Das Programm schaltet es für {} nicht ein: „Keine“ wählen oder einen anderen Postprozessor.</translation>
    </message>
    <message>
        <source>the program ends with it: use another post-processor.</source>
        <translation>Das Programm endet damit: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the program ends without it: use another post-processor.</source>
        <translation>Das Programm endet ohne es: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the program has T{} in the spindle where {} is milled.</source>
        <translation>Das Programm hat T{} in der Spindel, wo {} gefräst wird.</translation>
    </message>
    <message>
        <source>the program has it on where {} begins: end the operation before by M9.</source>
        <translation>Das Programm hat es eingeschaltet, wo {} beginnt: Die Operation davor mit M9 enden lassen.</translation>
    </message>
    <message>
        <source>the program has {} in force where {} begins: use another post-processor.</source>
        <translation>Im Programm gilt {}, wo {} beginnt: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the recorded spindle turns the other way at {} s.</source>
        <translation>Die aufgezeichnete Spindel dreht bei {} s andersherum.</translation>
    </message>
    <message>
        <source>the rotary axis next to the tool is parallel to the tool: it cannot tilt it. List the axes in chain order, from the work to the tool.</source>
        <translation>Die Drehachse am Werkzeug ist parallel zum Werkzeug: Sie kann es nicht neigen. Die Achsen in der Reihenfolge der Kette nennen, vom Werkstück zum Werkzeug.</translation>
    </message>
    <message>
        <source>the shape could not be read: repair it.</source>
        <translation>Die Form ließ sich nicht lesen: Sie in Ordnung bringen.</translation>
    </message>
    <message>
        <source>the spindle must turn: Forward or Reverse.</source>
        <translation>Die Spindel muss drehen: Forward oder Reverse.</translation>
    </message>
    <message>
        <source>the strategy &apos;{}&apos; needs a machine file.</source>
        <translation>Die Strategie „{}“ braucht eine Maschinendatei.</translation>
    </message>
    <message>
        <source>the strategy has none to choose: leave it out.</source>
        <translation>Bei dieser Strategie gibt es keinen zu wählen: Ihn weglassen.</translation>
    </message>
    <message>
        <source>the table or head turns in line {} without it: use another post-processor.</source>
        <translation>In Zeile {} dreht sich Tisch oder Kopf ohne es: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the texture belongs to no job with a stock and a model.</source>
        <translation>Die Textur gehört zu keinem Job mit Rohteil und Modell.</translation>
    </message>
    <message>
        <source>the texture has nothing to look at.</source>
        <translation>An der Textur ist nichts anzusehen.</translation>
    </message>
    <message>
        <source>the texture has the patches 1 to {}.</source>
        <translation>Die Textur hat die Felder 1 bis {}.</translation>
    </message>
    <message>
        <source>the times of stops are known to a period only without a jerk limit.</source>
        <translation>Die Zeiten der Halte sind nur ohne Ruckbegrenzung auf einen Takt genau bekannt.</translation>
    </message>
    <message>
        <source>the tool is changed in line {} without it: use another post-processor.</source>
        <translation>In Zeile {} wird das Werkzeug ohne es gewechselt: Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>the tool must stand out further than its cutting end.</source>
        <translation>Das Werkzeug muss weiter herausstehen als seine Schneiden.</translation>
    </message>
    <message>
        <source>the tool of {} needs a diameter greater than zero.</source>
        <translation>Das Werkzeug von {} braucht einen Durchmesser größer als null.</translation>
    </message>
    <message>
        <source>the tool reaches Z {} mm between dimples: give a greater safe height.</source>
        <translation>Das Werkzeug erreicht zwischen Mulden Z {} mm: Eine größere Sicherheitshöhe angeben.</translation>
    </message>
    <message>
        <source>the tool tip is at Z {} mm on dimple {}: give a greater safe height.</source>
        <translation>Die Werkzeugspitze ist bei Z {} mm an Mulde {}: Eine größere Sicherheitshöhe angeben.</translation>
    </message>
    <message>
        <source>the tool tip is at Z {} mm on mark {}: give a greater safe height.</source>
        <translation>Die Werkzeugspitze ist bei Z {} mm an Spur {}: Eine größere Sicherheitshöhe angeben.</translation>
    </message>
    <message>
        <source>the upper corner must not lie below the lower one, nor too far from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the voxels lie from {} to {} mm.</source>
        <translation>Die Voxel liegen von {} bis {} mm.</translation>
    </message>
    <message>
        <source>there can be no such file ({}): give another name.</source>
        <translation>Eine solche Datei kann es nicht geben ({}): Einen anderen Namen angeben.</translation>
    </message>
    <message>
        <source>there can be no such file: give another name.</source>
        <translation>Eine solche Datei kann es nicht geben: Einen anderen Namen angeben.</translation>
    </message>
    <message>
        <source>there is no object &apos;{}&apos; with a shape: {}</source>
        <translation>Es gibt kein Objekt „{}“ mit einer Form: {}</translation>
    </message>
    <message>
        <source>there is no operation with a tool controller below it.</source>
        <translation>Darunter gibt es keine Operation mit Werkzeugsteuerung.</translation>
    </message>
    <message>
        <source>there is no such file: choose a picture.</source>
        <translation>Es gibt keine solche Datei: Ein Bild wählen.</translation>
    </message>
    <message>
        <source>there is no such machine file; there are: {}.</source>
        <translation>Es gibt keine solche Maschinendatei; es gibt: {}.</translation>
    </message>
    <message>
        <source>there is no such post-processor.</source>
        <translation>Es gibt keinen solchen Postprozessor.</translation>
    </message>
    <message>
        <source>there must be a dimple to look at.</source>
        <translation>Es muss eine Mulde zum Ansehen geben.</translation>
    </message>
    <message>
        <source>this FreeCAD posts the tool bit&apos;s: set both alike.</source>
        <translation>Dieses FreeCAD postet den des Werkzeugs: Beide gleich setzen.</translation>
    </message>
    <message>
        <source>this feed move is of no operation: take it out of the post.</source>
        <translation>Diese Vorschubbewegung gehört zu keiner Operation: Sie aus dem Postprozessor nehmen.</translation>
    </message>
    <message>
        <source>this place is off the faces: choose one on them.</source>
        <translation>Dieser Ort liegt nicht auf den Flächen: Einen auf ihnen wählen.</translation>
    </message>
    <message>
        <source>this speed alone is judged.</source>
        <translation>Nur diese Drehzahl wird beurteilt.</translation>
    </message>
    <message>
        <source>this word is not understood: choose another operation.</source>
        <translation>Dieses Wort wird nicht verstanden: Eine andere Operation wählen.</translation>
    </message>
    <message>
        <source>tilted</source>
        <translation>geneigt</translation>
    </message>
    <message>
        <source>tools are changed by tool controllers: give the operation that of the tool, and take the word out.</source>
        <translation>Werkzeuge werden durch Werkzeugsteuerungen gewechselt: Der Operation die des Werkzeugs geben und das Wort herausnehmen.</translation>
    </message>
    <message>
        <source>unknown in move {}</source>
        <translation>unbekannt in Bewegung {}</translation>
    </message>
    <message>
        <source>use ASCII letters in labels and comments.</source>
        <translation>In Bezeichnungen und Kommentaren ASCII-Zeichen benutzen.</translation>
    </message>
    <message>
        <source>use another post-processor.</source>
        <translation>Einen anderen Postprozessor benutzen.</translation>
    </message>
    <message>
        <source>use letters, digits, points, dashes and underscores for its name.</source>
        <translation>Für den Namen Buchstaben, Ziffern, Punkte, Binde- und Unterstriche benutzen.</translation>
    </message>
    <message>
        <source>what a tool of kind &apos;{}&apos; leaves is not known: give 0.</source>
        <translation>Was ein Werkzeug der Art „{}“ stehen lässt, ist nicht bekannt: 0 angeben.</translation>
    </message>
    <message>
        <source>where that moves the tool is not known here: post the operation in a job of its own.</source>
        <translation>Wohin das Werkzeug dadurch fährt, ist hier nicht bekannt: Die Operation in einem eigenen Job posten.</translation>
    </message>
    <message>
        <source>without TCP a tilting head needs the length from its gauge point to the tip.</source>
        <translation>Ohne TCP braucht ein Schwenkkopf die Länge von seinem Bezugspunkt bis zur Spitze.</translation>
    </message>
    <message>
        <source>work offsets are the job&apos;s: choose it in the job&apos;s setup, and take it out here.</source>
        <translation>Nullpunktverschiebungen gehören zum Job: Sie in dessen Setup wählen und hier herausnehmen.</translation>
    </message>
    <message>
        <source>work offsets are the job&apos;s: choose it in the job&apos;s setup, and take the operation out.</source>
        <translation>Nullpunktverschiebungen gehören zum Job: Sie in dessen Setup wählen und die Operation herausnehmen.</translation>
    </message>
    <message>
        <source>{} Nothing is posted; {} Set PostGouging to post it all the same.</source>
        <translation>{} Nichts wurde gepostet; {} PostGouging setzen, um trotzdem zu posten.</translation>
    </message>
    <message>
        <source>{} Set PostUnheld to post it all the same.</source>
        <translation>{} PostUnheld setzen, um trotzdem zu posten.</translation>
    </message>
    <message>
        <source>{} Tilt less.</source>
        <translation>{} Weniger neigen.</translation>
    </message>
    <message>
        <source>{} and {} have it, and are different tools: give one of them another number.</source>
        <translation>{} und {} haben sie und sind verschiedene Werkzeuge: Einem eine andere Nummer geben.</translation>
    </message>
    <message>
        <source>{} asks for {} {}: give that, or leave one of them empty.</source>
        <translation>{} verlangt {} {}: Dies angeben, oder eins davon leer lassen.</translation>
    </message>
    <message>
        <source>{} cannot read it: {}.</source>
        <translation>{} kann es nicht lesen: {}.</translation>
    </message>
    <message>
        <source>{} dimples are more than the limit of {}: choose a larger spacing or fewer patches.</source>
        <translation>{} Mulden sind mehr als die Grenze von {}: Einen größeren Abstand oder weniger Felder wählen.</translation>
    </message>
    <message>
        <source>{} does not know it.</source>
        <translation>{} kennt es nicht.</translation>
    </message>
    <message>
        <source>{} has no block that follows the spindle: use feed per move or constant feed.</source>
        <translation>{} hat keinen Satz, der der Spindel folgt: Vorschub je Satz oder festen Vorschub benutzen.</translation>
    </message>
    <message>
        <source>{} has no such work offset: choose {} in the job&apos;s setup.</source>
        <translation>{} hat keine solche Nullpunktverschiebung: Im Setup des Jobs {} wählen.</translation>
    </message>
    <message>
        <source>{} has no word for them: use constant feed.</source>
        <translation>{} hat kein Wort dafür: Festen Vorschub benutzen.</translation>
    </message>
    <message>
        <source>{} has taken its place in the job: choose that.</source>
        <translation>{} hat ihren Platz im Job eingenommen: Jene wählen.</translation>
    </message>
    <message>
        <source>{} in {}, {} in its tool bit</source>
        <translation>{} in {}, {} in seinem Werkzeug</translation>
    </message>
    <message>
        <source>{} is drawn there, and not milled there: set it to zero, and move the model.</source>
        <translation>{} ist dort gezeichnet und wird nicht dort gefräst: Sie auf null setzen und das Modell verschieben.</translation>
    </message>
    <message>
        <source>{} is milled with it: give the tool controller {} one.</source>
        <translation>{} wird damit gefräst: Der Werkzeugsteuerung {} eins geben.</translation>
    </message>
    <message>
        <source>{} is posted in millimetres.</source>
        <translation>{} wird in Millimetern gepostet.</translation>
    </message>
    <message>
        <source>{} is switched off: switch it on.</source>
        <translation>{} ist ausgeschaltet: Es einschalten.</translation>
    </message>
    <message>
        <source>{} marks are more than the limit of {}: choose a larger feed per tooth or fewer patches.</source>
        <translation>{} Spuren sind mehr als die Grenze von {}: Einen größeren Vorschub je Zahn oder weniger Felder wählen.</translation>
    </message>
    <message>
        <source>{} mm for {} mm of stock</source>
        <translation>{} mm für {} mm Rohteil</translation>
    </message>
    <message>
        <source>{} mm outside the stock</source>
        <translation>{} mm außerhalb des Rohteils</translation>
    </message>
    <message>
        <source>{} mm radial, {} mm axial</source>
        <translation>{} mm radial, {} mm axial</translation>
    </message>
    <message>
        <source>{} mm, about {} million triangles</source>
        <translation>{} mm, etwa {} Millionen Dreiecke</translation>
    </message>
    <message>
        <source>{} mm, {} points a level</source>
        <translation>{} mm, {} Punkte je Höhe</translation>
    </message>
    <message>
        <source>{} mm, {} voxels of box, about {} MiB of the {} MiB allowed</source>
        <translation>{} mm, {} Voxel im Quader, etwa {} MiB von erlaubten {} MiB</translation>
    </message>
    <message>
        <source>{} names {}, and a program is for one machine: choose the same, or post {} by itself.</source>
        <translation>{} nennt {}, und ein Programm ist für eine Maschine: Dieselbe wählen oder {} allein posten.</translation>
    </message>
    <message>
        <source>{} of {} dimples read back</source>
        <translation>{} von {} Mulden zurückgelesen</translation>
    </message>
    <message>
        <source>{} of {} has {}: no smaller piece is made of it.</source>
        <translation>{} von {} hat {}: Kleiner wird es nicht geteilt.</translation>
    </message>
    <message>
        <source>{} of {} moves read back</source>
        <translation>{} von {} Bewegungen zurückgelesen</translation>
    </message>
    <message>
        <source>{} s, r = D dt / dx^2 = {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} sags and {} normals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} stops between patches</source>
        <translation>{} Halte zwischen Feldern</translation>
    </message>
    <message>
        <source>{} timed moves</source>
        <translation>{} getaktete Bewegungen</translation>
    </message>
    <message>
        <source>{} turns at {} rpm: take the word out, and give the operation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} turns take the tool {} mm, and dimple {} is {} mm away: give at least {} ExtraTurns.</source>
        <translation>{} Umdrehungen führen das Werkzeug {} mm weit, und Mulde {} ist {} mm entfernt: Mindestens {} zusätzliche Umdrehungen angeben.</translation>
    </message>
    <message>
        <source>{} with a ball end mill: choose one.</source>
        <translation>{} mit einem Kugelfräser: Einen wählen.</translation>
    </message>
    <message>
        <source>{} writes it as it is: use letters and digits, or one of PatchMill&apos;s own posts.</source>
        <translation>{} schreibt es, wie es ist: Buchstaben und Ziffern benutzen, oder einen der Postprozessoren von PatchMill.</translation>
    </message>
    <message>
        <source>{} x {} with {} values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: repair the shape.</source>
        <translation>{}: Die Form in Ordnung bringen.</translation>
    </message>
    <message>
        <source>{}: use one of PatchMill&apos;s own posts.</source>
        <translation>{}: Einen der Postprozessoren von PatchMill benutzen.</translation>
    </message>
    <message>
        <source>{}choose Without TCP.</source>
        <translation>{}„Ohne TCP“ wählen.</translation>
    </message>
    <message>
        <source>Machine of LinuxCNC or FreeCAD</source>
        <translation>Maschine von LinuxCNC oder FreeCAD</translation>
    </message>
    <message>
        <source>it is no machine file of FreeCAD: give another one.</source>
        <translation>Es ist keine Maschinendatei von FreeCAD: Eine andere angeben.</translation>
    </message>
    <message>
        <source>it says nothing of axes: give a machine file of FreeCAD.</source>
        <translation>Sie nennt keine Achsen: Eine Maschinendatei von FreeCAD angeben.</translation>
    </message>
    <message>
        <source>set the machine to metric units in FreeCAD&apos;s machine editor.</source>
        <translation>Die Maschine in FreeCADs Maschineneditor auf metrische Einheiten stellen.</translation>
    </message>
    <message>
        <source>Accelerations are not in the file: {} mm/s² was taken. Give those of the machine, from which follows what a texture&apos;s timing can be.</source>
        <translation>Beschleunigungen stehen nicht in der Datei: {} mm/s² wurde genommen. Die der Maschine angeben, aus denen folgt, welcher Takt einer Textur möglich ist.</translation>
    </message>
    <message>
        <source>Dimples cover {} % of the faces; left out on them: {}.</source>
        <translation>Mulden bedecken {} % der Flächen; auf ihnen ausgelassen: {}.</translation>
    </message>
    <message>
        <source>M428 is taken to switch TCP on, and M429 off: look into their subroutines.</source>
        <translation>Es wird angenommen, dass M428 TCP einschaltet und M429 es ausschaltet: Ihre Unterprogramme ansehen.</translation>
    </message>
    <message>
        <source>No HAL file that was read joins an encoder to spindle.0.revs and spindle.0.index-enable: the spindle is taken for one that no move can follow.</source>
        <translation>Keine der gelesenen HAL-Dateien verbindet einen Geber mit spindle.0.revs und spindle.0.index-enable: Es wird angenommen, dass keine Bewegung der Spindel folgen kann.</translation>
    </message>
    <message>
        <source>No HAL file that was read joins an encoder to spindle.0.revs and spindle.0.index-enable: the spindle is taken for one that no move can follow. Not read: {}.</source>
        <translation>Keine der gelesenen HAL-Dateien verbindet einen Geber mit spindle.0.revs und spindle.0.index-enable: Es wird angenommen, dass keine Bewegung der Spindel folgen kann. Nicht gelesen: {}.</translation>
    </message>
    <message>
        <source>No M428 and M429 are there to switch TCP: it is taken to have none.</source>
        <translation>Es gibt kein M428 und M429, die TCP schalten: Es wird angenommen, dass es keines hat.</translation>
    </message>
    <message>
        <source>The control is taken to have no TCP: say so if it has.</source>
        <translation>Es wird angenommen, dass die Steuerung kein TCP hat: Es angeben, wenn sie es hat.</translation>
    </message>
    <message>
        <source>The faces look to all sides alike: they are projected on along ({}, {}, {}).</source>
        <translation>Die Flächen blicken gleichermaßen nach allen Seiten: Es wird entlang ({}, {}, {}) auf sie projiziert.</translation>
    </message>
    <message>
        <source>The lattice is laid in {} pieces.</source>
        <translation>Das Gitter wird in {} Stücken gelegt.</translation>
    </message>
    <message>
        <source>The safe height was raised to Z {} mm, above what is milled.</source>
        <translation>Die Sicherheitshöhe wurde auf Z {} mm angehoben, über das, was gefräst wird.</translation>
    </message>
    <message>
        <source>The start phase is 0°: mill a calibration patch to find it.</source>
        <translation>Die Startphase ist 0°: Ein Kalibrierfeld fräsen, um sie zu finden.</translation>
    </message>
    <message>
        <source>The velocities differ ({} mm/s): the smallest was taken.</source>
        <translation>Die Geschwindigkeiten sind verschieden ({} mm/s): Die kleinste wurde genommen.</translation>
    </message>
    <message>
        <source>Those of rotary axes are not either: {}°/s² was taken.</source>
        <translation>Auch die der Drehachsen nicht: {}°/s² wurde genommen.</translation>
    </message>
    <message>
        <source>Where the rotary axis {} lies trivkins does not say: it was left out.</source>
        <translation>Wo die Drehachse {} liegt, sagt trivkins nicht: Sie wurde weggelassen.</translation>
    </message>
    <message>
        <source>Where the tool is clear of the table is not known: give the retract height.</source>
        <translation>Wo das Werkzeug über dem Tisch frei ist, ist nicht bekannt: Die Rückzugshöhe angeben.</translation>
    </message>
    <message>
        <source>Whether the control can follow the spindle is not in the file: it is taken not to.</source>
        <translation>Ob die Steuerung der Spindel folgen kann, steht nicht in der Datei: Es wird angenommen, dass sie es nicht kann.</translation>
    </message>
    <message>
        <source>Which of {} carries the other is not in the file: look at the axes.</source>
        <translation>Welche der Achsen {} die andere trägt, steht nicht in der Datei: Die Achsen prüfen.</translation>
    </message>
    <message>
        <source>[EMCMOT]SERVO_PERIOD is not given: 1 ms was taken, as LinuxCNC does.</source>
        <translation>[EMCMOT]SERVO_PERIOD ist nicht angegeben: 1 ms wurde genommen, wie LinuxCNC es tut.</translation>
    </message>
    <message>
        <source>an upright shank would cut the overhang: put a DCM modifier with posture on it.</source>
        <translation>Ein aufrechter Schaft würde in den Überhang schneiden: Einen DCM-Modifikator mit Haltung darauf setzen.</translation>
    </message>
    <message>
        <source>the lines are further apart than the tool is wide: ridges stay between them.</source>
        <translation>Die Zeilen sind weiter voneinander entfernt, als das Werkzeug breit ist: Dazwischen bleiben Grate.</translation>
    </message>
    <message>
        <source>{} differs ({} {}): the smallest was taken.</source>
        <translation>{} ist verschieden ({} {}): Der kleinste Wert wurde genommen.</translation>
    </message>
    <message>
        <source>{} dimples go round the closed face, {} mm apart.</source>
        <translation>{} Mulden gehen um die geschlossene Fläche herum, {} mm voneinander.</translation>
    </message>
    <message>
        <source>{} is set in no HAL file that was read: 0 was taken.</source>
        <translation>{} ist in keiner gelesenen HAL-Datei gesetzt: 0 wurde genommen.</translation>
    </message>
    <message>
        <source>{} lattice points are left out for others that are too near, where pieces or the two sides of a closed face meet.</source>
        <translation>{} Gitterpunkte sind für andere ausgelassen, die zu nah sind, wo Stücke oder die beiden Seiten einer geschlossenen Fläche aufeinandertreffen.</translation>
    </message>
    <message>
        <source>{} lines in cavities are left out: no way from above.</source>
        <translation>{} Zeilen in Höhlungen sind ausgelassen: kein Weg von oben.</translation>
    </message>
    <message>
        <source>Take a smaller ball</source>
        <translation>Eine kleinere Kugel nehmen</translation>
    </message>
    <message>
        <source>{}, tool diameter {}</source>
        <translation>{}, Werkzeugdurchmesser {}</translation>
    </message>
    <message>
        <source>{} dimples in one patch</source>
        <translation>{} Mulden in einem Feld</translation>
    </message>
    <message>
        <source>A patch of side {} is larger than the faces ({} x {} mm): its side is made {}.</source>
        <translation>Ein Feld mit der Seite {} ist größer als die Flächen ({} x {} mm): Seine Seite wird {}.</translation>
    </message>
    <message>
        <source>A patch of side {} is larger than the faces ({} x {} mm): its sides are made {} and {}.</source>
        <translation>Ein Feld mit der Seite {} ist größer als die Flächen ({} x {} mm): Seine Seiten werden {} und {}.</translation>
    </message>
    <message>
        <source>Force along the path</source>
        <translation>Kraft entlang des Wegs</translation>
    </message>
    <message>
        <source>Power along the path</source>
        <translation>Leistung entlang des Wegs</translation>
    </message>
    <message>
        <source>Chip thickness along the path</source>
        <translation>Spanungsdicke entlang des Wegs</translation>
    </message>
    <message>
        <source>force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>power [W]</source>
        <translation>Leistung [W]</translation>
    </message>
    <message>
        <source>chip thickness [µm]</source>
        <translation>Spanungsdicke [µm]</translation>
    </message>
    <message>
        <source>Largest force {} N ({} times the median), power {} W, chips {} µm thick</source>
        <translation>Größte Kraft {} N (das {}-Fache des Medians), Leistung {} W, Späne {} µm dick</translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation>Kraftgrenze</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Belastung</translation>
    </message>
    <message>
        <source>Power limit</source>
        <translation>Leistungsgrenze</translation>
    </message>
    <message>
        <source>Chip limit</source>
        <translation>Spanungsdickengrenze</translation>
    </message>
    <message>
        <source>Specific force</source>
        <translation>Spezifische Kraft</translation>
    </message>
    <message>
        <source>Force exponent</source>
        <translation>Exponent der Kraft</translation>
    </message>
    <message>
        <source>Normal force</source>
        <translation>Normalkraft</translation>
    </message>
    <message>
        <source>The tool runs into the part beside the faces</source>
        <translation>Das Werkzeug läuft neben den Flächen in das Teil</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Gewinde</translation>
    </message>
    <message>
        <source>The margin is not kept: the thread runs over both ends of the cylinder.</source>
        <translation>Der Rand wird nicht eingehalten: Das Gewinde läuft über beide Enden des Zylinders hinaus.</translation>
    </message>
    <message>
        <source>a cylinder turned by {} degrees</source>
        <translation>ein um {} Grad gedrehter Zylinder</translation>
    </message>
    <message>
        <source>a cylinder {} mm beside the axis</source>
        <translation>ein Zylinder {} mm neben der Achse</translation>
    </message>
    <message>
        <source>a thread closes on itself only if the spindle leads the axes: choose Spindle-locked.</source>
        <translation>Ein Gewinde schließt sich nur, wenn die Spindel die Achsen führt: wählen Sie „An die Spindel gekoppelt“.</translation>
    </message>
    <message>
        <source>a thread goes all the way round: choose all faces of a cylinder that has no holes.</source>
        <translation>Ein Gewinde geht ganz herum: wählen Sie alle Flächen eines Zylinders ohne Löcher.</translation>
    </message>
    <message>
        <source>a thread goes round a cylinder: choose a cylindrical face, or another Order.</source>
        <translation>Ein Gewinde geht um einen Zylinder: wählen Sie eine zylindrische Fläche oder eine andere Reihenfolge.</translation>
    </message>
    <message>
        <source>a thread goes round one: choose faces of one alone.</source>
        <translation>Ein Gewinde geht um einen einzigen: wählen Sie nur dessen Flächen.</translation>
    </message>
    <message>
        <source>a thread is milled from outside: choose another Order.</source>
        <translation>Ein Gewinde wird von außen gefräst: wählen Sie eine andere Reihenfolge.</translation>
    </message>
    <message>
        <source>a thread needs a machine file with a rotary table, such as four-axis-mill.</source>
        <translation>Ein Gewinde braucht eine Maschinendatei mit Rundtisch, etwa four-axis-mill.</translation>
    </message>
    <message>
        <source>a thread needs one rotary table along X or Y and no other, as four-axis-mill has.</source>
        <translation>Ein Gewinde braucht einen einzigen Rundtisch entlang X oder Y, wie four-axis-mill ihn hat.</translation>
    </message>
    <message>
        <source>axis {} has limits and would have to wind from 0 to {} degrees: where it can, give null as its limits_degrees.</source>
        <translation>Achse {} hat Grenzen und müsste von 0 bis {} Grad drehen: wo sie es kann, geben Sie null als ihr limits_degrees an.</translation>
    </message>
    <message>
        <source>axis {} would go from {} to {} mm, beyond its limits.</source>
        <translation>Achse {} würde von {} bis {} mm fahren, über ihre Grenzen hinaus.</translation>
    </message>
    <message>
        <source>axis {} would have to turn at {} degrees/s, and does at {}: give {} rpm or less.</source>
        <translation>Achse {} müsste mit {} Grad/s drehen und kann {}: geben Sie höchstens {} U/min an.</translation>
    </message>
    <message>
        <source>give 0, for no limit, or more.</source>
        <translation>geben Sie 0 für keine Grenze oder mehr an.</translation>
    </message>
    <message>
        <source>give a grid of at least 2 x 2 heights.</source>
        <translation>geben Sie ein Raster von mindestens 2 x 2 Höhen an.</translation>
    </message>
    <message>
        <source>give less than 90 degrees.</source>
        <translation>geben Sie weniger als 90 Grad an.</translation>
    </message>
    <message>
        <source>give the tool its number of flutes: the chip thickness follows from it.</source>
        <translation>geben Sie dem Werkzeug die Zahl seiner Schneiden: daraus folgt die Spandicke.</translation>
    </message>
    <message>
        <source>how a tool of kind &apos;{}&apos; cuts is not known: choose another tool.</source>
        <translation>wie ein Werkzeug der Art &apos;{}&apos; schneidet, ist nicht bekannt: wählen Sie ein anderes Werkzeug.</translation>
    </message>
    <message>
        <source>it is to lie along the rotary axis {}: turn the job&apos;s model.</source>
        <translation>er muss entlang der Drehachse {} liegen: drehen Sie das Modell des Auftrags.</translation>
    </message>
    <message>
        <source>its axis is to be the rotary axis {}, which goes through ({}, {}, {}) mm of the work: move the job&apos;s model, or tell the machine file&apos;s work_zero_mm.</source>
        <translation>seine Achse muss die Drehachse {} sein, die durch ({}, {}, {}) mm des Werkstücks geht: verschieben Sie das Modell des Auftrags, oder geben Sie work_zero_mm der Maschinendatei an.</translation>
    </message>
    <message>
        <source>on a cylinder that turns the tool has a lead to the surface: choose Normal.</source>
        <translation>an einem Zylinder, der sich dreht, hat das Werkzeug einen Voreilwinkel zur Fläche: wählen Sie „Normale“.</translation>
    </message>
    <message>
        <source>only a thread goes all round: use patchmill.simulate.</source>
        <translation>nur ein Gewinde geht ganz herum: nehmen Sie patchmill.simulate.</translation>
    </message>
    <message>
        <source>only {} go round the cylinder: choose a smaller one.</source>
        <translation>nur {} gehen um den Zylinder: wählen Sie einen kleineren.</translation>
    </message>
    <message>
        <source>several cylinders</source>
        <translation>mehrere Zylinder</translation>
    </message>
    <message>
        <source>the tool&apos;s tip stands at Z {} mm: give more.</source>
        <translation>die Werkzeugspitze steht bei Z {} mm: geben Sie mehr an.</translation>
    </message>
    <message>
        <source>the feed would fall below {} mm/min: give more.</source>
        <translation>der Vorschub fiele unter {} mm/min: geben Sie mehr an.</translation>
    </message>
    <message>
        <source>Go on without saving what was changed?</source>
        <translation>Ohne zu speichern weitermachen?</translation>
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
        <source>table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>ball centre</source>
        <translation>Kugelmitte</translation>
    </message>
    <message>
        <source>index</source>
        <translation>Indeximpuls</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>bei erreichter Drehzahl</translation>
    </message>
    <message>
        <source>{} of {}
move {} of {}{}
X {}  Y {}  Z {} {}
spindle {:.0f}°</source>
        <translation>{} von {}
Satz {} von {}{}
X {}  Y {}  Z {} {}
Spindel {:.0f}°</translation>
    </message>
    <message>
        <source>S{} takes {}, the phase off by up to {:.1f}°. None that holds is faster.</source>
        <translation>S{} braucht {}, die Phase weicht um bis zu {:.1f}° ab. Keine, die hält, ist schneller.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Ball lattice</source>
        <translation>Gitter der Kugel</translation>
    </message>
    <message>
        <source>Icosahedral</source>
        <translation>Ikosaedrisch</translation>
    </message>
    <message>
        <source>Fibonacci</source>
        <translation>Fibonacci</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Ringe</translation>
    </message>
    <message>
        <source>Ball dimples</source>
        <translation>Mulden der Kugel</translation>
    </message>
    <message>
        <source>Ball setups</source>
        <translation>Aufspannungen der Kugel</translation>
    </message>
    <message>
        <source>One</source>
        <translation>Eine</translation>
    </message>
    <message>
        <source>Two</source>
        <translation>Zwei</translation>
    </message>
    <message>
        <source>Some dimples, {} mm wide, run into each other.</source>
        <translation>Manche Mulden, {} mm breit, gehen ineinander über.</translation>
    </message>
    <message>
        <source>a ball&apos;s lattice is milled from outside: choose another Mapping.</source>
        <translation>Das Gitter einer Kugel wird von außen gefräst: Eine andere Abbildung wählen.</translation>
    </message>
    <message>
        <source>a ball&apos;s lattice is that of one: choose its faces alone.</source>
        <translation>Das Gitter einer Kugel gehört zu einer einzigen: Nur deren Flächen wählen.</translation>
    </message>
    <message>
        <source>a ball&apos;s lattice lies on a spherical face: choose one, or another Mapping.</source>
        <translation>Das Gitter einer Kugel liegt auf einer Kugelfläche: Eine solche wählen oder eine andere Abbildung.</translation>
    </message>
    <message>
        <source>an icosahedral lattice has {} or {}: choose one of these, or another lattice.</source>
        <translation>Ein ikosaedrisches Gitter hat {} oder {}: Eines davon wählen oder ein anderes Gitter.</translation>
    </message>
    <message>
        <source>give Projected, On surface or Ball.</source>
        <translation>Projiziert, Auf der Fläche oder Kugel angeben.</translation>
    </message>
    <message>
        <source>give less than the tool&apos;s diameter, {} mm, and the ball&apos;s.</source>
        <translation>Weniger angeben als den Durchmesser des Werkzeugs, {} mm, und den der Kugel.</translation>
    </message>
    <message>
        <source>on a ball one follows from the other: give 0 for one of them.</source>
        <translation>Auf einer Kugel folgt eines aus dem anderen: Für eines davon 0 angeben.</translation>
    </message>
    <message>
        <source>only a ball is seen from all sides: use patchmill.simulate.</source>
        <translation>Nur eine Kugel wird von allen Seiten gesehen: patchmill.simulate verwenden.</translation>
    </message>
    <message>
        <source>several spheres</source>
        <translation>mehrere Kugeln</translation>
    </message>
    <message>
        <source>give a value from {} to {}.</source>
        <translation>Einen Wert von {} bis {} angeben.</translation>
    </message>
    <message>
        <source>{} mm, more than {} million triangles</source>
        <translation>{} mm, mehr als {} Millionen Dreiecke</translation>
    </message>
    <message>
        <source>give 0, or choose a constant-feed strategy: a paced path takes none.</source>
        <translation>0 angeben oder eine Strategie mit konstantem Vorschub wählen: eine getaktete Bahn braucht keine.</translation>
    </message>
    <message>
        <source>A ball of diameter {} reaches {:.0f} % of the faces.</source>
        <translation>Eine Kugel mit dem Durchmesser {} erreicht {:.0f} % der Flächen.</translation>
    </message>
    <message>
        <source>the mesh {}</source>
        <translation>das Netz {}</translation>
    </message>
    <message>
        <source>it has no faces for a job. In FreeCAD&apos;s Python console patchmill.mesh_texture makes a program for it.</source>
        <translation>es hat keine Flächen für einen Auftrag. In der Python-Konsole von FreeCAD macht patchmill.mesh_texture ein Programm dafür.</translation>
    </message>
    <message>
        <source>a mesh has no cylinder to be turned about: choose Helix or Rows.</source>
        <translation>ein Netz hat keinen Zylinder, um den es gedreht würde: wählen Sie Helix oder Rows.</translation>
    </message>
    <message>
        <source>a mesh has no face to lay a lattice on by its own lines: choose Projected.</source>
        <translation>ein Netz hat keine Fläche, auf die ein Gitter nach ihren Linien gelegt würde: wählen Sie Projected.</translation>
    </message>
    <message>
        <source>beside {} faces</source>
        <translation>neben {} Flächen</translation>
    </message>
    <message>
        <source>give a Mesh object, or an STL, OBJ or PLY file.</source>
        <translation>geben Sie ein Netz-Objekt oder eine STL-, OBJ- oder PLY-Datei an.</translation>
    </message>
    <message>
        <source>give a file that ends in {}.</source>
        <translation>geben Sie eine Datei an, die auf {} endet.</translation>
    </message>
    <message>
        <source>give a mesh or faces, not both.</source>
        <translation>geben Sie ein Netz oder Flächen an, nicht beides.</translation>
    </message>
    <message>
        <source>give a mesh that has some.</source>
        <translation>geben Sie ein Netz an, das welche hat.</translation>
    </message>
    <message>
        <source>give numbers of 0 to {}.</source>
        <translation>geben Sie Nummern von 0 bis {} an.</translation>
    </message>
    <message>
        <source>give one of them.</source>
        <translation>geben Sie eines davon an.</translation>
    </message>
    <message>
        <source>give the number of a triangle, 0 to {}.</source>
        <translation>geben Sie die Nummer eines Dreiecks an, 0 bis {}.</translation>
    </message>
    <message>
        <source>give the numbers of some triangles.</source>
        <translation>geben Sie die Nummern von Dreiecken an.</translation>
    </message>
    <message>
        <source>give the numbers of those that are meant.</source>
        <translation>geben Sie die Nummern derer an, die gemeint sind.</translation>
    </message>
    <message>
        <source>give the surface that is projected on.</source>
        <translation>geben Sie die Oberfläche an, auf die projiziert wird.</translation>
    </message>
    <message>
        <source>give three finite numbers in mm.</source>
        <translation>geben Sie drei endliche Zahlen in mm an.</translation>
    </message>
    <message>
        <source>give triangles whose corners are apart.</source>
        <translation>geben Sie Dreiecke an, deren Ecken auseinander liegen.</translation>
    </message>
    <message>
        <source>it cannot be read ({}).</source>
        <translation>sie lässt sich nicht lesen ({}).</translation>
    </message>
    <message>
        <source>it holds no triangles.</source>
        <translation>sie enthält keine Dreiecke.</translation>
    </message>
    <message>
        <source>nearest and triangles</source>
        <translation>nearest und triangles</translation>
    </message>
    <message>
        <source>no area</source>
        <translation>keine Fläche</translation>
    </message>
    <message>
        <source>no mesh</source>
        <translation>kein Netz</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>diese Datei gibt es nicht.</translation>
    </message>
</context>
<context>
    <name>PatchMillPreferences</name>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>New jobs: ball end mill and post-processor</source>
        <translation>Neue Aufträge: Kugelfräser und Postprozessor</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source> rpm</source>
        <translation> U/min</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source> mm/min</source>
        <translation> mm/min</translation>
    </message>
    <message>
        <source>Post-processor</source>
        <translation>Postprozessor</translation>
    </message>
    <message>
        <source>linuxcnc</source>
        <translation>linuxcnc</translation>
    </message>
    <message>
        <source>New textures</source>
        <translation>Neue Texturen</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Machine file</source>
        <translation>Maschinendatei</translation>
    </message>
    <message>
        <source>Name of a machine file, such as linuxcnc-mill; empty: the phase is not judged</source>
        <translation>Name einer Maschinendatei, etwa linuxcnc-mill; leer: die Phase wird nicht beurteilt</translation>
    </message>
    <message>
        <source>Decimals of coordinates</source>
        <translation>Nachkommastellen der Koordinaten</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>Memory of one computation</source>
        <translation>Speicher einer Berechnung</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Threads (from the next start)</source>
        <translation>Threads (ab dem nächsten Start)</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
</context>
<context>
    <name>PatchMill_CalibrationPatch</name>
    <message>
        <source>Calibration patch</source>
        <translation>Kalibrierfeld</translation>
    </message>
    <message>
        <source>One patch whose best dimple tells the machine&apos;s start phase</source>
        <translation>Ein Feld, dessen beste Mulde die Anfangsphase der Maschine verrät</translation>
    </message>
</context>
<context>
    <name>PatchMill_Check</name>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Looks for gouges and collisions of ball, shank and holder with the part</source>
        <translation>Sucht nach Verletzungen und Kollisionen von Kugel, Schaft und Halter mit dem Teil</translation>
    </message>
</context>
<context>
    <name>PatchMill_CopyMilling</name>
    <message>
        <source>Copy milling</source>
        <translation>Kopierfräsen</translation>
    </message>
    <message>
        <source>Lines over the selected faces or the whole part, layer by layer</source>
        <translation>Zeilen über die gewählten Flächen oder das ganze Teil, Schicht für Schicht</translation>
    </message>
</context>
<context>
    <name>PatchMill_CurvedTexture</name>
    <message>
        <source>Curved texture</source>
        <translation>Gekrümmte Textur</translation>
    </message>
    <message>
        <source>Dimples that lie on the selected faces (Xu and Sasahara 2016)</source>
        <translation>Mulden, die auf den gewählten Flächen liegen (Xu und Sasahara 2016)</translation>
    </message>
</context>
<context>
    <name>PatchMill_DressupDcm</name>
    <message>
        <source>DCM modifier</source>
        <translation>DCM-Modifikator</translation>
    </message>
    <message>
        <source>Feed and tool posture of the selected operation from a voxel model</source>
        <translation>Vorschub und Werkzeughaltung der gewählten Operation aus einem Voxelmodell</translation>
    </message>
</context>
<context>
    <name>PatchMill_Examples</name>
    <message>
        <source>Free-form block: curved texture</source>
        <translation>Freiformblock: gekrümmte Textur</translation>
    </message>
    <message>
        <source>The part of Xu and Sasahara 2016</source>
        <translation>Das Teil von Xu und Sasahara 2016</translation>
    </message>
    <message>
        <source>Inclined plane: planar texture</source>
        <translation>Geneigte Ebene: ebene Textur</translation>
    </message>
    <message>
        <source>After Matsuda, Sasahara and Tsutsumi 2008</source>
        <translation>Nach Matsuda, Sasahara und Tsutsumi 2008</translation>
    </message>
    <message>
        <source>Cylinder: planar patches on the surface</source>
        <translation>Zylinder: ebene Felder auf der Fläche</translation>
    </message>
    <message>
        <source>Smooth part: copy milling and DCM feed</source>
        <translation>Glattes Teil: Kopierfräsen und DCM-Vorschub</translation>
    </message>
    <message>
        <source>After Kobayashi and Shirase 2014, feed</source>
        <translation>Nach Kobayashi und Shirase 2014, Vorschub</translation>
    </message>
    <message>
        <source>Overhanging part: DCM posture</source>
        <translation>Überhängendes Teil: DCM-Haltung</translation>
    </message>
    <message>
        <source>After Kobayashi and Shirase 2014, posture</source>
        <translation>Nach Kobayashi und Shirase 2014, Haltung</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Parts that are ready to be tried</source>
        <translation>Teile, die zum Ausprobieren bereit sind</translation>
    </message>
</context>
<context>
    <name>PatchMill_InstallCore</name>
    <message>
        <source>Install PatchMill&apos;s core …</source>
        <translation>Kern von PatchMill installieren …</translation>
    </message>
    <message>
        <source>What is missing here, and how to get it</source>
        <translation>Was hier fehlt, und wie man es bekommt</translation>
    </message>
</context>
<context>
    <name>PatchMill_Machines</name>
    <message>
        <source>Machines …</source>
        <translation>Maschinen …</translation>
    </message>
    <message>
        <source>Limits, rotary axes and controller of your machines</source>
        <translation>Grenzen, Drehachsen und Steuerung Ihrer Maschinen</translation>
    </message>
</context>
<context>
    <name>PatchMill_PlanarTexture</name>
    <message>
        <source>Planar texture</source>
        <translation>Ebene Textur</translation>
    </message>
    <message>
        <source>Dimples in flat patches on the selected faces (Matsuda 2008)</source>
        <translation>Mulden in ebenen Feldern auf den gewählten Flächen (Matsuda 2008)</translation>
    </message>
</context>
<context>
    <name>PatchMill_Play</name>
    <message>
        <source>Play the path</source>
        <translation>Bahn abspielen</translation>
    </message>
    <message>
        <source>Moves the tool along a path, with its spindle turning</source>
        <translation>Bewegt das Werkzeug mit drehender Spindel entlang einer Bahn</translation>
    </message>
</context>
<context>
    <name>PatchMill_Post</name>
    <message>
        <source>Post and check</source>
        <translation>Ausgeben und prüfen</translation>
    </message>
    <message>
        <source>Writes the program, if what is read back from its text holds the plan</source>
        <translation>Schreibt das Programm, wenn das Zurückgelesene den Plan einhält</translation>
    </message>
</context>
<context>
    <name>PatchMill_PyramidTexture</name>
    <message>
        <source>Pyramid texture</source>
        <translation>Pyramidentextur</translation>
    </message>
    <message>
        <source>Dimples in faceted patches on the selected faces</source>
        <translation>Mulden in facettierten Feldern auf den gewählten Flächen</translation>
    </message>
</context>
<context>
    <name>PatchMill_Report</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Posts the job, and writes pictures and figures</source>
        <translation>Gibt den Auftrag aus und schreibt Bilder und Zahlen</translation>
    </message>
</context>
<context>
    <name>PatchMill_Simulate</name>
    <message>
        <source>Simulate marks</source>
        <translation>Marken simulieren</translation>
    </message>
    <message>
        <source>Shows the relief that the tool will leave</source>
        <translation>Zeigt das Relief, das das Werkzeug hinterlassen wird</translation>
    </message>
</context>
</TS>
