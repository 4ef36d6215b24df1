<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
    <context>
        <name>CalibrationWords</name>
        <message>
            <source>%1, %2</source>
            <translation>%1, %2</translation>
        </message>
        <message>
            <source>Good</source>
            <translation>Gut</translation>
        </message>
        <message>
            <source>Usable</source>
            <translation>Brauchbar</translation>
        </message>
        <message>
            <source>Repeat</source>
            <translation>Wiederholen</translation>
        </message>
        <message>
            <source>Not calibrated</source>
            <translation>Nicht kalibriert</translation>
        </message>
        <message>
            <source>data sheet values, up to 10 % off</source>
            <translation>Werte des Datenblatts, bis zu 10 % daneben</translation>
        </message>
        <message>
            <source>taken to sit as the rig shows it</source>
            <translation>angenommen: sitzt, wie das Rig es zeigt</translation>
        </message>
        <message>
            <source>%1 mg</source>
            <translation>%1 mg</translation>
        </message>
        <message>
            <source>%1 up</source>
            <translation>%1 oben</translation>
        </message>
        <message>
            <source>%1 and %2 up</source>
            <translation>%1 und %2 oben</translation>
        </message>
        <message>
            <source>corner %1 up</source>
            <translation>Ecke %1 oben</translation>
        </message>
        <message>
            <source>1 sensor</source>
            <translation>1 Sensor</translation>
        </message>
        <message>
            <source>%1 sensors</source>
            <translation>%1 Sensoren</translation>
        </message>
        <message>
            <source>1 calibration</source>
            <translation>1 Kalibrierung</translation>
        </message>
        <message>
            <source>%1 calibrations</source>
            <translation>%1 Kalibrierungen</translation>
        </message>
        <message>
            <source>extremes</source>
            <translation>Extremwerte</translation>
        </message>
        <message>
            <source>ellipsoid</source>
            <translation>Ellipsoid</translation>
        </message>
        <message>
            <source>two poses</source>
            <translation>zwei Posen</translation>
        </message>
    </context>
    <context>
        <name>CoreServices</name>
        <message>
            <source>Simulator: %1</source>
            <translation>Simulator: %1</translation>
        </message>
    </context>
    <context>
        <name>DeviceFormat</name>
        <message>
            <source>Automatic</source>
            <translation>Automatisch</translation>
        </message>
        <message>
            <source>the device does not say what it offers; another program may be using it</source>
            <translation>das Gerät sagt nicht, was es bietet; vielleicht benutzt es ein anderes Programm</translation>
        </message>
        <message>
            <source>the device does not run at this rate</source>
            <translation>mit dieser Rate läuft das Gerät nicht</translation>
        </message>
        <message>
            <source>the device does not give such samples</source>
            <translation>solche Abtastwerte liefert das Gerät nicht</translation>
        </message>
        <message>
            <source>Left %1, right %2</source>
            <translation>Links %1, rechts %2</translation>
        </message>
        <message>
            <source>Other inputs</source>
            <translation>Andere Eingänge</translation>
        </message>
        <message>
            <source>the device is mono; the board needs two channels</source>
            <translation>das Gerät ist mono; die Platine braucht zwei Kanäle</translation>
        </message>
        <message>
            <source>the device has no more than these</source>
            <translation>mehr als diese hat das Gerät nicht</translation>
        </message>
        <message>
            <source>%1 bit float</source>
            <translation>%1 Bit Gleitkomma</translation>
        </message>
        <message>
            <source>%1 bit</source>
            <translation>%1 Bit</translation>
        </message>
        <message>
            <source>%1, %2</source>
            <translation>%1, %2</translation>
        </message>
        <message>
            <source>%1, inputs %2 + %3</source>
            <translation>%1, Eingänge %2 + %3</translation>
        </message>
    </context>
    <context>
        <name>Export</name>
        <message>
            <source>BVH</source>
            <translation>BVH</translation>
        </message>
        <message>
            <source>Choose where the file goes.</source>
            <translation>Wählen Sie, wohin die Datei soll.</translation>
        </message>
        <message>
            <source>The folder %1 does not exist. Choose another one.</source>
            <translation>Den Ordner %1 gibt es nicht. Wählen Sie einen anderen.</translation>
        </message>
        <message>
            <source>%1 is a folder. Give the file a name.</source>
            <translation>%1 ist ein Ordner. Geben Sie der Datei einen Namen.</translation>
        </message>
        <message>
            <source>You may not write into %1. Choose another folder.</source>
            <translation>Sie dürfen nicht in %1 schreiben. Wählen Sie einen anderen Ordner.</translation>
        </message>
        <message>
            <source>The name must end in %1, or other programs will not find the file.</source>
            <translation>Der Name muss auf %1 enden, sonst finden andere Programme die Datei nicht.</translation>
        </message>
        <message>
            <source>Skeleton and motion as text, for Blender, Maya, MotionBuilder and others</source>
            <translation>Skelett und Bewegung als Text, für Blender, Maya, MotionBuilder und andere</translation>
        </message>
    </context>
    <context>
        <name>Format</name>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>%1 min</source>
            <translation>%1 min</translation>
        </message>
        <message>
            <source>%1 h</source>
            <translation>%1 h</translation>
        </message>
        <message>
            <source>over 9 days</source>
            <translation>über 9 Tage</translation>
        </message>
        <message>
            <source>%1 days</source>
            <translation>%1 Tage</translation>
        </message>
        <message>
            <source>%1 kHz</source>
            <translation>%1 kHz</translation>
        </message>
        <message>
            <source>silent</source>
            <translation>stumm</translation>
        </message>
        <message>
            <source>%1 dB</source>
            <translation>%1 dB</translation>
        </message>
        <message>
            <source>The take needs a name.</source>
            <translation>Der Take braucht einen Namen.</translation>
        </message>
        <message>
            <source>A take&apos;s name has no slash and does not start with a dot.</source>
            <translation>Der Name eines Takes enthält keinen Schrägstrich und beginnt nicht mit einem Punkt.</translation>
        </message>
        <message>
            <source>This name is too long for the disk.</source>
            <translation>Dieser Name ist zu lang für die Platte.</translation>
        </message>
        <message>
            <source>There is a take of this name already. Choose another one.</source>
            <translation>Einen Take dieses Namens gibt es schon. Wählen Sie einen anderen.</translation>
        </message>
    </context>
    <context>
        <name>Health</name>
        <message>
            <source>not heard yet</source>
            <translation>noch nicht gehört</translation>
        </message>
        <message>
            <source>good</source>
            <translation>gut</translation>
        </message>
        <message>
            <source>reads nothing; check that the sensor is plugged in</source>
            <translation>misst nichts; prüfen Sie, ob der Sensor eingesteckt ist</translation>
        </message>
        <message>
            <source>no readings yet</source>
            <translation>noch keine Messwerte</translation>
        </message>
        <message>
            <source>works, but was never calibrated; calibrate its range</source>
            <translation>arbeitet, wurde aber nie kalibriert; kalibrieren Sie seinen Messbereich</translation>
        </message>
    </context>
    <context>
        <name>LevelAdvice</name>
        <message>
            <source>Nothing comes in</source>
            <translation>Es kommt nichts an</translation>
        </message>
        <message>
            <source>Check the cable, that the board has power, and that this is the input it is plugged into.</source>
            <translation>Prüfen Sie das Kabel, ob die Platine Strom hat und ob sie in diesem Eingang steckt.</translation>
        </message>
        <message>
            <source>This does not sound like the board</source>
            <translation>Das klingt nicht nach der Platine</translation>
        </message>
        <message>
            <source>Choose the line input, not the microphone; use a stereo cable; switch off echo cancelling and noise suppression of the sound system.</source>
            <translation>Wählen Sie den Line-Eingang, nicht das Mikrofon; nehmen Sie ein Stereokabel; schalten Sie Echo- und Rauschunterdrückung des Soundsystems aus.</translation>
        </message>
        <message>
            <source>Listening</source>
            <translation>Hört zu</translation>
        </message>
        <message>
            <source>The line is being judged; this takes about a second.</source>
            <translation>Die Leitung wird beurteilt; das dauert etwa eine Sekunde.</translation>
        </message>
        <message>
            <source>Too high</source>
            <translation>Zu hoch</translation>
        </message>
        <message>
            <source>Turn the recording volume down a little, or quick movements will clip.</source>
            <translation>Regeln Sie die Aufnahmelautstärke etwas herunter, sonst übersteuern schnelle Bewegungen.</translation>
        </message>
        <message>
            <source>Too low</source>
            <translation>Zu niedrig</translation>
        </message>
        <message>
            <source>Turn the recording volume up until the bar stands in the green zone; now it is at %1.</source>
            <translation>Regeln Sie die Aufnahmelautstärke herauf, bis der Balken im grünen Bereich steht; jetzt sind es %1.</translation>
        </message>
        <message>
            <source>Level is good</source>
            <translation>Der Pegel ist gut</translation>
        </message>
        <message>
            <source>No device is open</source>
            <translation>Kein Gerät ist offen</translation>
        </message>
        <message>
            <source>Choose one above.</source>
            <translation>Wählen Sie oben eines.</translation>
        </message>
        <message>
            <source>The device has stopped sending</source>
            <translation>Das Gerät sendet nicht mehr</translation>
        </message>
        <message>
            <source>Plug it in again, look for devices again, and choose it once more.</source>
            <translation>Stecken Sie es wieder ein, suchen Sie erneut nach Geräten und wählen Sie es noch einmal.</translation>
        </message>
    </context>
    <context>
        <name>Motions</name>
        <message>
            <source>Waving</source>
            <translation>Winken</translation>
        </message>
        <message>
            <source>Quick turns of the forearm</source>
            <translation>Schnelle Drehungen des Unterarms</translation>
        </message>
        <message>
            <source>Arm raises</source>
            <translation>Arm heben</translation>
        </message>
        <message>
            <source>Slow and exact</source>
            <translation>Langsam und genau</translation>
        </message>
        <message>
            <source>Reaching for a glass</source>
            <translation>Nach einem Glas greifen</translation>
        </message>
        <message>
            <source>All segments at once</source>
            <translation>Alle Glieder zugleich</translation>
        </message>
        <message>
            <source>Walking</source>
            <translation>Gehen</translation>
        </message>
        <message>
            <source>The arm swings along</source>
            <translation>Der Arm schwingt mit</translation>
        </message>
        <message>
            <source>Boxing</source>
            <translation>Boxen</translation>
        </message>
        <message>
            <source>Hard accelerations</source>
            <translation>Harte Beschleunigungen</translation>
        </message>
        <message>
            <source>Every joint</source>
            <translation>Jedes Gelenk</translation>
        </message>
        <message>
            <source>One after another</source>
            <translation>Eines nach dem anderen</translation>
        </message>
        <message>
            <source>Still poses</source>
            <translation>Ruhige Haltungen</translation>
        </message>
        <message>
            <source>For measuring accuracy</source>
            <translation>Zum Messen der Genauigkeit</translation>
        </message>
        <message>
            <source>From the simulator</source>
            <translation>Aus dem Simulator</translation>
        </message>
    </context>
    <context>
        <name>Quality</name>
        <message>
            <source>–</source>
            <translation>–</translation>
        </message>
        <message>
            <source>100 %</source>
            <translation>100 %</translation>
        </message>
        <message>
            <source>%1 %</source>
            <translation>%1 %</translation>
        </message>
        <message>
            <source>%1: only %2 of the readings are usable.</source>
            <translation>%1: nur %2 der Messwerte sind brauchbar.</translation>
        </message>
        <message>
            <source>Check its plug and cable, and that the level does not clip.</source>
            <translation>Prüfen Sie Stecker und Kabel und dass der Pegel nicht übersteuert.</translation>
        </message>
        <message>
            <source>%1: reads %2 g at rest instead of 1.</source>
            <translation>%1: misst in Ruhe %2 g statt 1.</translation>
        </message>
        <message>
            <source>Calibrate its range: turn it slowly about all axes.</source>
            <translation>Kalibrieren Sie seinen Messbereich: Drehen Sie ihn langsam um alle Achsen.</translation>
        </message>
        <message>
            <source>Calibrate its range again when you have a minute.</source>
            <translation>Kalibrieren Sie seinen Messbereich neu, wenn Sie eine Minute haben.</translation>
        </message>
        <message>
            <source>%1: gravity alone explains only %2 of the readings.</source>
            <translation>%1: die Schwerkraft allein erklärt nur %2 der Messwerte.</translation>
        </message>
        <message>
            <source>The limb moved fast. Bridging or stronger smoothing helps.</source>
            <translation>Das Glied bewegte sich schnell. Überbrücken oder stärkeres Glätten hilft.</translation>
        </message>
        <message>
            <source>%1: good.</source>
            <translation>%1: gut.</translation>
        </message>
        <message>
            <source>No signal was found on the line.</source>
            <translation>Auf der Leitung wurde kein Signal gefunden.</translation>
        </message>
        <message>
            <source>Check that the recording is of the sensor board, in stereo.</source>
            <translation>Prüfen Sie, ob die Aufnahme von der Sensorplatine stammt und stereo ist.</translation>
        </message>
        <message>
            <source>%1 of the signal was lost.</source>
            <translation>%1 des Signals gingen verloren.</translation>
        </message>
        <message>
            <source>Look at the events on the timeline for when, and check plugs and levels.</source>
            <translation>Wann, zeigen die Ereignisse auf der Zeitleiste; prüfen Sie Stecker und Pegel.</translation>
        </message>
        <message>
            <source>%1 readings touched full scale.</source>
            <translation>%1 Messwerte stießen an die Aussteuerungsgrenze.</translation>
        </message>
        <message>
            <source>Turn the recording level down before the next take.</source>
            <translation>Regeln Sie vor dem nächsten Take den Aufnahmepegel herunter.</translation>
        </message>
        <message>
            <source>The line was heard without loss.</source>
            <translation>Die Leitung wurde ohne Verlust gehört.</translation>
        </message>
        <message>
            <source>%1 readings a second, clock jitter %2 %</source>
            <translation>%1 Messungen je Sekunde, Taktzittern %2 %</translation>
        </message>
        <message>
            <source>%1 cycles heard, %2 lost</source>
            <translation>%1 Zyklen gehört, %2 verloren</translation>
        </message>
        <message>
            <source>Coupling of the sound card %1 ± %2 Hz, undone</source>
            <translation>Kopplung der Soundkarte %1 ± %2 Hz, herausgerechnet</translation>
        </message>
        <message>
            <source>Coupling of the sound card %1 Hz, undone</source>
            <translation>Kopplung der Soundkarte %1 Hz, herausgerechnet</translation>
        </message>
        <message>
            <source>Noise %1 dB</source>
            <translation>Rauschen %1 dB</translation>
        </message>
        <message>
            <source>Left and right were swapped; taken care of</source>
            <translation>Links und rechts waren vertauscht; berücksichtigt</translation>
        </message>
        <message>
            <source>The signal came inverted; taken care of</source>
            <translation>Das Signal kam umgepolt an; berücksichtigt</translation>
        </message>
        <message>
            <source>At %1 s: %2</source>
            <translation>Bei %1 s: %2</translation>
        </message>
        <message>
            <source>Good: every sensor was heard and trusted.</source>
            <translation>Gut: Jeder Sensor wurde gehört und war vertrauenswürdig.</translation>
        </message>
        <message>
            <source>%1° mean, %2° at most</source>
            <translation>%1° im Mittel, höchstens %2°</translation>
        </message>
        <message>
            <source>None</source>
            <translation>Keine</translation>
        </message>
        <message>
            <source>Adaptive</source>
            <translation>Anpassend</translation>
        </message>
        <message>
            <source>Bridging</source>
            <translation>Überbrückend</translation>
        </message>
        <message>
            <source>Every frame by itself, as measured.</source>
            <translation>Jedes Bild für sich, wie gemessen.</translation>
        </message>
        <message>
            <source>Follows trusted readings closely and smooths the others. No lag.</source>
            <translation>Folgt vertrauenswürdigen Messwerten eng und glättet die anderen. Ohne Verzug.</translation>
        </message>
        <message>
            <source>As adaptive, and carries the limb on through bursts of acceleration.</source>
            <translation>Wie anpassend, und führt das Glied durch Beschleunigungsstöße weiter.</translation>
        </message>
    </context>
    <context>
        <name>SolveEntries</name>
        <message>
            <source>Solve</source>
            <translation>Berechnen</translation>
        </message>
        <message>
            <source>See the moving figure, judge it, key rotations</source>
            <translation>Die bewegte Figur sehen, beurteilen, Drehungen setzen</translation>
        </message>
        <message>
            <source>F</source>
            <translation>F</translation>
        </message>
        <message>
            <source>Frame the selection</source>
            <translation>Auswahl ins Bild holen</translation>
        </message>
        <message>
            <source>Shift+F / Shift+S / Shift+T</source>
            <translation>Umschalt+F / Umschalt+S / Umschalt+T</translation>
        </message>
        <message>
            <source>Look from the front, the side, the top</source>
            <translation>Von vorn, von der Seite, von oben sehen</translation>
        </message>
        <message>
            <source>Drag / Shift+drag / wheel</source>
            <translation>Ziehen / Umschalt+Ziehen / Rad</translation>
        </message>
        <message>
            <source>Turn, move, zoom the view</source>
            <translation>Ansicht drehen, verschieben, vergrößern</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Ausgeben</translation>
        </message>
        <message>
            <source>Write the motion to a file for other programs</source>
            <translation>Die Bewegung für andere Programme in eine Datei schreiben</translation>
        </message>
        <message>
            <source>Ctrl+E</source>
            <translation>Strg+E</translation>
        </message>
        <message>
            <source>Space</source>
            <translation>Leertaste</translation>
        </message>
        <message>
            <source>Play or pause</source>
            <translation>Abspielen oder anhalten</translation>
        </message>
        <message>
            <source>J / K / L</source>
            <translation>J / K / L</translation>
        </message>
        <message>
            <source>Play backwards, stop, play forwards; again: faster</source>
            <translation>Rückwärts, anhalten, vorwärts; nochmals: schneller</translation>
        </message>
        <message>
            <source>Left / Right</source>
            <translation>Links / Rechts</translation>
        </message>
        <message>
            <source>One frame back or on; with Shift ten</source>
            <translation>Ein Bild zurück oder vor; mit Umschalt zehn</translation>
        </message>
        <message>
            <source>Up / Down</source>
            <translation>Auf / Ab</translation>
        </message>
        <message>
            <source>To the key before or after</source>
            <translation>Zum Schlüssel davor oder danach</translation>
        </message>
        <message>
            <source>Home / End</source>
            <translation>Pos1 / Ende</translation>
        </message>
        <message>
            <source>To the start or the end</source>
            <translation>Zum Anfang oder Ende</translation>
        </message>
        <message>
            <source>Shift+Home</source>
            <translation>Umschalt+Pos1</translation>
        </message>
        <message>
            <source>Show the whole clip</source>
            <translation>Den ganzen Clip zeigen</translation>
        </message>
        <message>
            <source>I</source>
            <translation>I</translation>
        </message>
        <message>
            <source>Set a key for the selected bone</source>
            <translation>Schlüssel für den gewählten Knochen setzen</translation>
        </message>
        <message>
            <source>Del</source>
            <translation>Entf</translation>
        </message>
        <message>
            <source>Delete the selected keys</source>
            <translation>Die gewählten Schlüssel löschen</translation>
        </message>
        <message>
            <source>Alt+Left / Alt+Right</source>
            <translation>Alt+Links / Alt+Rechts</translation>
        </message>
        <message>
            <source>Move the selected keys by a frame</source>
            <translation>Die gewählten Schlüssel um ein Bild verschieben</translation>
        </message>
        <message>
            <source>Alt+Up / Alt+Down</source>
            <translation>Alt+Auf / Alt+Ab</translation>
        </message>
        <message>
            <source>Turn the selected keys by 1°; with Shift by 0.1°</source>
            <translation>Die gewählten Schlüssel um 1° drehen; mit Umschalt um 0,1°</translation>
        </message>
    </context>
    <context>
        <name>SolveTimeline</name>
        <message>
            <source>Select a bone, then press I to key its rotation about the vertical.</source>
            <translation>Wählen Sie einen Knochen und drücken Sie I, um seine Drehung um die Senkrechte zu setzen.</translation>
        </message>
        <message>
            <source>Keys of the bones appear here once a take is solved.</source>
            <translation>Die Schlüssel der Knochen erscheinen hier, sobald ein Take berechnet ist.</translation>
        </message>
    </context>
    <context>
        <name>StatusFacts</name>
        <message>
            <source>not recording</source>
            <translation>keine Aufnahme</translation>
        </message>
        <message>
            <source>Nothing is being recorded.</source>
            <translation>Es wird nichts aufgenommen.</translation>
        </message>
        <message>
            <source>recording stopped</source>
            <translation>Aufnahme beendet</translation>
        </message>
        <message>
            <source>closing the take</source>
            <translation>Take wird geschlossen</translation>
        </message>
        <message>
            <source>The last samples are being written.</source>
            <translation>Die letzten Werte werden geschrieben.</translation>
        </message>
        <message>
            <source>REC %1</source>
            <translation>REC %1</translation>
        </message>
        <message>
            <source>Times at which the device lost samples: %1. Close other programs, or choose a lower rate.</source>
            <translation>So oft hat das Gerät Werte verloren: %1. Schließen Sie andere Programme oder wählen Sie eine niedrigere Rate.</translation>
        </message>
        <message>
            <source>Recording. No sample has been lost.</source>
            <translation>Aufnahme läuft. Kein Wert ging verloren.</translation>
        </message>
        <message>
            <source>(losing samples)</source>
            <translation>(verliert Werte)</translation>
        </message>
        <message>
            <source>no device</source>
            <translation>kein Gerät</translation>
        </message>
        <message>
            <source>device lost</source>
            <translation>Gerät verloren</translation>
        </message>
        <message>
            <source>disk –</source>
            <translation>Platte –</translation>
        </message>
        <message>
            <source>disk %1</source>
            <translation>Platte %1</translation>
        </message>
        <message>
            <source>The disk is full after %1 of recording. Free some space or choose another folder.</source>
            <translation>Nach %1 Aufnahme ist die Platte voll. Schaffen Sie Platz oder wählen Sie einen anderen Ordner.</translation>
        </message>
        <message>
            <source>The disk has room for %1 of recording.</source>
            <translation>Die Platte hat Platz für %1 Aufnahme.</translation>
        </message>
        <message>
            <source>sensors –</source>
            <translation>Sensoren –</translation>
        </message>
        <message>
            <source>Known while a device is open.</source>
            <translation>Bekannt, solange ein Gerät offen ist.</translation>
        </message>
        <message>
            <source>Sensor %1: %2</source>
            <translation>Sensor %1: %2</translation>
        </message>
        <message>
            <source>All sensors send plausible accelerations.</source>
            <translation>Alle Sensoren senden plausible Beschleunigungen.</translation>
        </message>
        <message>
            <source>The sensors have not been heard yet.</source>
            <translation>Die Sensoren wurden noch nicht gehört.</translation>
        </message>
        <message>
            <source>sensors %1/%2</source>
            <translation>Sensoren %1/%2</translation>
        </message>
        <message>
            <source>sync –</source>
            <translation>Takt –</translation>
        </message>
        <message>
            <source>no signal</source>
            <translation>kein Signal</translation>
        </message>
        <message>
            <source>The device has stopped sending.</source>
            <translation>Das Gerät sendet nicht mehr.</translation>
        </message>
        <message>
            <source>sync %1 Hz</source>
            <translation>Takt %1 Hz</translation>
        </message>
        <message>
            <source>In step with the board; cycles lost since the start: %1.</source>
            <translation>Im Takt mit der Platine; verlorene Zyklen seit dem Start: %1.</translation>
        </message>
        <message>
            <source>In step with the board; no cycle has been lost.</source>
            <translation>Im Takt mit der Platine; kein Zyklus ging verloren.</translation>
        </message>
        <message>
            <source>no sync</source>
            <translation>kein Takt</translation>
        </message>
        <message>
            <source>The board&apos;s clock is not heard on the right channel. Look at the scope.</source>
            <translation>Der Takt der Platine ist auf dem rechten Kanal nicht zu hören. Sehen Sie auf das Oszilloskop.</translation>
        </message>
        <message>
            <source>listening</source>
            <translation>hört zu</translation>
        </message>
        <message>
            <source>Looking for the board&apos;s clock.</source>
            <translation>Sucht den Takt der Platine.</translation>
        </message>
        <message>
            <source>latency –</source>
            <translation>Verzug –</translation>
        </message>
        <message>
            <source>From the sensor to the screen, beyond the device&apos;s own buffer; known while a skeleton is shown live.</source>
            <translation>Vom Sensor bis zum Bildschirm, jenseits des Gerätepuffers; bekannt, solange ein Skelett live gezeigt wird.</translation>
        </message>
        <message>
            <source>latency %1 ms</source>
            <translation>Verzug %1 ms</translation>
        </message>
        <message>
            <source>From the sensor to the screen, beyond the device&apos;s own buffer: %1 ms on average, %2 ms at most; the device adds %3 ms.</source>
            <translation>Vom Sensor bis zum Bildschirm, jenseits des Gerätepuffers: im Mittel %1 ms, höchstens %2 ms; das Gerät fügt %3 ms hinzu.</translation>
        </message>
    </context>
    <context>
        <name>TakeSegments</name>
        <message>
            <source>Sensors are turned</source>
            <translation>Sensoren werden gedreht</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Capture</source>
            <translation>Aufnahme</translation>
        </message>
    </context>
    <context>
        <name>Workspaces</name>
        <message>
            <source>Capture</source>
            <translation>Aufnehmen</translation>
        </message>
        <message>
            <source>Choose a device, check levels, record</source>
            <translation>Gerät wählen, Pegel prüfen, aufnehmen</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::BoneCard</name>
        <message>
            <source>Bone</source>
            <translation>Knochen</translation>
        </message>
        <message>
            <source>Selected bone</source>
            <translation>Gewählter Knochen</translation>
        </message>
        <message>
            <source> mm</source>
            <translation> mm</translation>
        </message>
        <message>
            <source>Length of the bone in millimetres</source>
            <translation>Länge des Knochens in Millimetern</translation>
        </message>
        <message>
            <source>°</source>
            <translation>°</translation>
        </message>
        <message>
            <source>Rotation about the vertical at the playhead in degrees</source>
            <translation>Drehung um die Senkrechte an der Abspielmarke in Grad</translation>
        </message>
        <message>
            <source>Sets a key at the playhead</source>
            <translation>Setzt einen Schlüssel an der Abspielmarke</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>Länge</translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation>Drehung</translation>
        </message>
        <message>
            <source>Set key</source>
            <translation>Schlüssel setzen</translation>
        </message>
        <message>
            <source>Sets a key of the rotation at the playhead (I)</source>
            <translation>Setzt an der Abspielmarke einen Schlüssel der Drehung (I)</translation>
        </message>
        <message>
            <source>Delete key</source>
            <translation>Schlüssel löschen</translation>
        </message>
        <message>
            <source>Deletes the selected keys (Del)</source>
            <translation>Löscht die gewählten Schlüssel (Entf)</translation>
        </message>
        <message>
            <source>Keys of the rotation about the vertical</source>
            <translation>Schlüssel der Drehung um die Senkrechte</translation>
        </message>
        <message>
            <source>No skeleton yet</source>
            <translation>Noch kein Skelett</translation>
        </message>
        <message>
            <source>Choose a bone</source>
            <translation>Wählen Sie einen Knochen</translation>
        </message>
        <message>
            <source>–</source>
            <translation>–</translation>
        </message>
        <message>
            <source>Click a bone in the view, or choose one here.</source>
            <translation>Klicken Sie in der Ansicht auf einen Knochen oder wählen Sie hier einen.</translation>
        </message>
        <message>
            <source>No sensor is worn here: it follows its parent.</source>
            <translation>Hier wird kein Sensor getragen: Er folgt seinem Elternknochen.</translation>
        </message>
        <message>
            <source>Rotations can be keyed once the take is solved.</source>
            <translation>Drehungen lassen sich setzen, sobald der Take berechnet ist.</translation>
        </message>
        <message>
            <source>About the vertical, which gravity cannot tell. Turning it sets a key at the playhead.</source>
            <translation>Um die Senkrechte, die die Schwerkraft nicht verrät. Drehen setzt einen Schlüssel an der Abspielmarke.</translation>
        </message>
        <message>
            <source>%1    %2°</source>
            <translation>%1    %2°</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::CalibrateHistory</name>
        <message>
            <source>Library: %1</source>
            <translation>Bibliothek: %1</translation>
        </message>
        <message>
            <source>History</source>
            <translation>Verlauf</translation>
        </message>
        <message>
            <source>Select a sensor to see its calibrations.</source>
            <translation>Einen Sensor wählen, um seine Kalibrierungen zu sehen.</translation>
        </message>
        <message>
            <source>No serial: known by its place on the board.</source>
            <translation>Ohne Seriennummer: bekannt durch seinen Platz auf der Platine.</translation>
        </message>
        <message>
            <source>Serial %1</source>
            <translation>Seriennummer %1</translation>
        </message>
        <message>
            <source>Range</source>
            <translation>Messbereich</translation>
        </message>
        <message>
            <source>none yet</source>
            <translation>noch keine</translation>
        </message>
        <message>
            <source>Mounting</source>
            <translation>Sitz</translation>
        </message>
        <message>
            <source>in use</source>
            <translation>in Gebrauch</translation>
        </message>
        <message>
            <source>Use</source>
            <translation>Benutzen</translation>
        </message>
        <message>
            <source>Go back to this calibration</source>
            <translation>Zu dieser Kalibrierung zurückkehren</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::CalibrateOverview</name>
        <message>
            <source>Everything is calibrated</source>
            <translation>Alles ist kalibriert</translation>
        </message>
        <message>
            <source>Range: %1 of %3.  Mounting: %2 of %3.</source>
            <translation>Messbereich: %1 von %3.  Sitz: %2 von %3.</translation>
        </message>
        <message>
            <source>Next: calibrate the range, once in a sensor&apos;s life. Uncalibrated sensors may point 6° or more beside the truth.</source>
            <translation>Als Nächstes: den Messbereich kalibrieren, einmal im Leben eines Sensors. Unkalibrierte Sensoren zeigen leicht 6° und mehr daneben.</translation>
        </message>
        <message>
            <source>Next: put the sensors on and calibrate the mounting.</source>
            <translation>Als Nächstes: die Sensoren anlegen und ihren Sitz kalibrieren.</translation>
        </message>
        <message>
            <source>Repeat: %1.</source>
            <translation>Wiederholen: %1.</translation>
        </message>
        <message>
            <source>, </source>
            <translation>, </translation>
        </message>
        <message>
            <source>Calibrate the mounting again whenever the sensors are put on anew or have slipped.</source>
            <translation>Den Sitz neu kalibrieren, sobald die Sensoren neu angelegt werden oder verrutscht sind.</translation>
        </message>
        <message>
            <source>Calibrate range</source>
            <translation>Messbereich kalibrieren</translation>
        </message>
        <message>
            <source>Calibrate mounting</source>
            <translation>Sitz kalibrieren</translation>
        </message>
        <message>
            <source>From a recording</source>
            <translation>Aus einer Aufnahme</translation>
        </message>
        <message>
            <source>Use the library&apos;s calibration</source>
            <translation>Kalibrierung der Bibliothek benutzen</translation>
        </message>
        <message>
            <source>Sensor</source>
            <translation>Sensor</translation>
        </message>
        <message>
            <source>Range: residual of gravity</source>
            <translation>Messbereich: Restfehler der Schwerkraft</translation>
        </message>
        <message>
            <source>Mounting: angle between the poses, 90° is right</source>
            <translation>Sitz: Winkel zwischen den Posen, richtig sind 90°</translation>
        </message>
        <message>
            <source>Calibrate from a stretch of a take in which sensors were turned or poses held</source>
            <translation>Aus einem Abschnitt eines Takes kalibrieren, in dem Sensoren gedreht oder Posen gehalten wurden</translation>
        </message>
        <message>
            <source>Running capture: %1.</source>
            <translation>Laufende Aufnahme: %1.</translation>
        </message>
        <message>
            <source>Take: %1.</source>
            <translation>Take: %1.</translation>
        </message>
        <message>
            <source> Worn by %1.</source>
            <translation> Getragen von %1.</translation>
        </message>
        <message>
            <source>The newest of every sensor and of this wearer&apos;s mountings</source>
            <translation>Das Neueste jedes Sensors und vom Sitz an dieser Person</translation>
        </message>
        <message>
            <source>The library knows none of these sensors yet.</source>
            <translation>Die Bibliothek kennt noch keinen dieser Sensoren.</translation>
        </message>
        <message>
            <source>no serial</source>
            <translation>ohne Seriennummer</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::CalibrateWorkspace</name>
        <message>
            <source>Nothing to calibrate yet</source>
            <translation>Noch nichts zu kalibrieren</translation>
        </message>
        <message>
            <source>Open a device in Capture to calibrate its sensors, or open a take to look at its calibration and compute it anew.</source>
            <translation>Unter „Aufnehmen“ ein Gerät öffnen, um seine Sensoren zu kalibrieren, oder einen Take öffnen, um seine Kalibrierung anzusehen und neu zu berechnen.</translation>
        </message>
        <message>
            <source>Open a device in Capture</source>
            <translation>Gerät unter „Aufnehmen“ öffnen</translation>
        </message>
        <message>
            <source>Calibrate from a recording</source>
            <translation>Aus einer Aufnahme kalibrieren</translation>
        </message>
        <message>
            <source>Range calibration</source>
            <translation>Kalibrierung des Messbereichs</translation>
        </message>
        <message>
            <source>Mounting calibration</source>
            <translation>Kalibrierung des Sitzes</translation>
        </message>
        <message>
            <source>Calibration from a recording</source>
            <translation>Kalibrierung aus einer Aufnahme</translation>
        </message>
        <message>
            <source>%1 of %2 is saved and in use.</source>
            <translation>%1 von %2: gespeichert und in Gebrauch.</translation>
        </message>
        <message>
            <source>Calibrate</source>
            <translation>Kalibrieren</translation>
        </message>
        <message>
            <source>Find each sensor&apos;s zero and scale, and how it sits on its limb</source>
            <translation>Nullpunkt und Maßstab jedes Sensors finden, und wie er auf seinem Glied sitzt</translation>
        </message>
        <message>
            <source>Enter</source>
            <translation>Eingabe</translation>
        </message>
        <message>
            <source>Next step of a calibration</source>
            <translation>Nächster Schritt einer Kalibrierung</translation>
        </message>
        <message>
            <source>Esc</source>
            <translation>Esc</translation>
        </message>
        <message>
            <source>Leave a calibration, asking first</source>
            <translation>Eine Kalibrierung verlassen, mit Rückfrage</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::CalibrationDesk</name>
        <message>
            <source>The raw signals are not kept: %1</source>
            <translation>Die rohen Signale werden nicht aufgehoben: %1</translation>
        </message>
        <message>
            <source>Reading the calibration library</source>
            <translation>Die Kalibrierungen werden gelesen</translation>
        </message>
        <message>
            <source>The calibration is not saved in the take</source>
            <translation>Die Kalibrierung ist nicht im Take gespeichert</translation>
        </message>
        <message>
            <source>The calibration is not saved in the library</source>
            <translation>Die Kalibrierung ist nicht in der Bibliothek gespeichert</translation>
        </message>
        <message>
            <source>The calibration is not taken out of the library</source>
            <translation>Die Kalibrierung ist nicht aus der Bibliothek genommen</translation>
        </message>
        <message>
            <source>Saving the calibration</source>
            <translation>Die Kalibrierung wird gespeichert</translation>
        </message>
        <message>
            <source>range calibration</source>
            <translation>Kalibrierung des Messbereichs</translation>
        </message>
        <message>
            <source>mounting calibration</source>
            <translation>Kalibrierung des Sitzes</translation>
        </message>
        <message>
            <source>choice of calibration</source>
            <translation>Wahl der Kalibrierung</translation>
        </message>
        <message>
            <source>Raw signals are kept in %1</source>
            <translation>Die rohen Signale stehen in %1</translation>
        </message>
        <message>
            <source>The raw signals are not kept in a take of their own: the capture records already, or it cannot record. The calibration itself goes on.</source>
            <translation>Die rohen Signale bekommen keinen eigenen Take: Es wird schon aufgenommen, oder es kann nicht aufgenommen werden. Die Kalibrierung selbst geht weiter.</translation>
        </message>
        <message>
            <source>Closing the calibration&apos;s take</source>
            <translation>Der Take der Kalibrierung wird geschlossen</translation>
        </message>
        <message>
            <source>The calibration&apos;s take has no segments</source>
            <translation>Der Take der Kalibrierung hat keine Abschnitte</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::CalibrationWizard</name>
        <message>
            <source>Sounds</source>
            <translation>Töne</translation>
        </message>
        <message>
            <source>Not saved: %1</source>
            <translation>Nicht gespeichert: %1</translation>
        </message>
        <message>
            <source>Sounds are on: the countdown is heard. Press to mute.</source>
            <translation>Töne sind an: Man hört den Countdown. Drücken: stumm.</translation>
        </message>
        <message>
            <source>Sounds are off. Press to hear the countdown.</source>
            <translation>Töne sind aus. Drücken, um den Countdown zu hören.</translation>
        </message>
        <message>
            <source>Open a device in Capture</source>
            <translation>Gerät unter „Aufnehmen“ öffnen</translation>
        </message>
        <message>
            <source>%1 calibrated</source>
            <translation>%1 kalibriert</translation>
        </message>
        <message>
            <source>Repeat</source>
            <translation>Wiederholen</translation>
        </message>
        <message>
            <source>%1 of %2 calibrated, repeat the others</source>
            <translation>%1 von %2 kalibriert, die anderen wiederholen</translation>
        </message>
        <message>
            <source>Signal: &lt;b&gt;%1&lt;/b&gt;</source>
            <translation>Signal: &lt;b&gt;%1&lt;/b&gt;</translation>
        </message>
        <message>
            <source>&lt;b&gt;No signal comes in.&lt;/b&gt;</source>
            <translation>&lt;b&gt;Es kommt kein Signal.&lt;/b&gt;</translation>
        </message>
        <message>
            <source>The verdicts of %1 are not saved yet.</source>
            <translation>Die Urteile zu %1 sind noch nicht gespeichert.</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::CaptureModel</name>
        <message>
            <source>Rig %1</source>
            <translation>Rig %1</translation>
        </message>
        <message>
            <source>Looking for devices</source>
            <translation>Sucht nach Geräten</translation>
        </message>
        <message>
            <source>rig</source>
            <translation>Rig</translation>
        </message>
        <message>
            <source>subject</source>
            <translation>Person</translation>
        </message>
        <message>
            <source>name of the take</source>
            <translation>Name des Takes</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::CaptureWorkspace</name>
        <message>
            <source>Look again</source>
            <translation>Erneut suchen</translation>
        </message>
        <message>
            <source>Use the simulator</source>
            <translation>Simulator benutzen</translation>
        </message>
        <message>
            <source>Record, or stop recording</source>
            <translation>Aufnehmen oder Aufnahme beenden</translation>
        </message>
        <message>
            <source>Set a marker</source>
            <translation>Marke setzen</translation>
        </message>
        <message>
            <source>Look for devices again</source>
            <translation>Erneut nach Geräten suchen</translation>
        </message>
        <message>
            <source>Looking for devices</source>
            <translation>Sucht nach Geräten</translation>
        </message>
        <message>
            <source>Opening %1</source>
            <translation>%1 wird geöffnet</translation>
        </message>
        <message>
            <source>%1 cannot be opened</source>
            <translation>%1 lässt sich nicht öffnen</translation>
        </message>
        <message>
            <source>The sound system does not answer</source>
            <translation>Das Soundsystem antwortet nicht</translation>
        </message>
        <message>
            <source>Choose a device</source>
            <translation>Wählen Sie ein Gerät</translation>
        </message>
        <message>
            <source>Choose above the line input that the board is plugged into. Levels and signals show at once; nothing is recorded before you say so.</source>
            <translation>Wählen Sie oben den Line-Eingang, in dem die Platine steckt. Pegel und Signale erscheinen sofort; aufgenommen wird erst, wenn Sie es sagen.</translation>
        </message>
        <message>
            <source>No sound card with a stereo input was found</source>
            <translation>Keine Soundkarte mit Stereoeingang gefunden</translation>
        </message>
        <message>
            <source>Plug in a sound card with a stereo line input and look again. A microphone input is mono and does not do. Without hardware, the simulator is a device as well.</source>
            <translation>Stecken Sie eine Soundkarte mit Stereo-Line-Eingang ein und suchen Sie erneut. Ein Mikrofoneingang ist mono und genügt nicht. Ohne Hardware dient auch der Simulator als Gerät.</translation>
        </message>
        <message>
            <source>%1 is recorded: %2.</source>
            <translation>%1 ist aufgenommen: %2.</translation>
        </message>
        <message>
            <source>Solve it</source>
            <translation>Berechnen</translation>
        </message>
        <message>
            <source>Rename the selected marker</source>
            <translation>Die gewählte Marke umbenennen</translation>
        </message>
        <message>
            <source>Delete</source>
            <translation>Entf</translation>
        </message>
        <message>
            <source>Delete the selected marker</source>
            <translation>Die gewählte Marke löschen</translation>
        </message>
        <message>
            <source>Shift+← / →</source>
            <translation>Umschalt+← / →</translation>
        </message>
        <message>
            <source>In the signal: move the selected marker by 10 ms, with Ctrl by 100 ms</source>
            <translation>Im Signal: die gewählte Marke um 10 ms verschieben, mit Strg um 100 ms</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::CurvesPanel</name>
        <message>
            <source>Inclination and trust of every sensor</source>
            <translation>Neigung und Vertrauen jedes Sensors</translation>
        </message>
        <message>
            <source>Elevation of the bone, −90° to 90°</source>
            <translation>Erhebung des Knochens, −90° bis 90°</translation>
        </message>
        <message>
            <source>Trust</source>
            <translation>Vertrauen</translation>
        </message>
        <message>
            <source>%1°</source>
            <translation>%1°</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::ExportWorkspace</name>
        <message>
            <source>Go to Solve</source>
            <translation>Zum Berechnen</translation>
        </message>
        <message>
            <source>%1 frames a second</source>
            <translation>%1 Bilder je Sekunde</translation>
        </message>
        <message>
            <source>Another rate</source>
            <translation>Andere Rate</translation>
        </message>
        <message>
            <source> Hz</source>
            <translation> Hz</translation>
        </message>
        <message>
            <source>Frames a second</source>
            <translation>Bilder je Sekunde</translation>
        </message>
        <message>
            <source>Centimetres (most programs)</source>
            <translation>Zentimeter (die meisten Programme)</translation>
        </message>
        <message>
            <source>Metres (Blender&apos;s own)</source>
            <translation>Meter (Blenders eigene)</translation>
        </message>
        <message>
            <source>Choose…</source>
            <translation>Wählen …</translation>
        </message>
        <message>
            <source>Solve</source>
            <translation>Berechnen</translation>
        </message>
        <message>
            <source>Format</source>
            <translation>Format</translation>
        </message>
        <message>
            <source>Frame rate</source>
            <translation>Bildrate</translation>
        </message>
        <message>
            <source>Unit of length</source>
            <translation>Längeneinheit</translation>
        </message>
        <message>
            <source>File</source>
            <translation>Datei</translation>
        </message>
        <message>
            <source>Show in folder</source>
            <translation>Im Ordner zeigen</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Ausgeben</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <source>Write the file (Ctrl+E)</source>
            <translation>Die Datei schreiben (Strg+E)</translation>
        </message>
        <message>
            <source>No take is open</source>
            <translation>Kein Take ist offen</translation>
        </message>
        <message>
            <source>The take is being solved</source>
            <translation>Der Take wird berechnet</translation>
        </message>
        <message>
            <source>Nothing is solved yet</source>
            <translation>Noch ist nichts berechnet</translation>
        </message>
        <message>
            <source>Open or capture one first.</source>
            <translation>Öffnen Sie erst einen oder nehmen Sie einen auf.</translation>
        </message>
        <message>
            <source>It can be exported in a moment.</source>
            <translation>Er lässt sich gleich ausgeben.</translation>
        </message>
        <message>
            <source>Solve the take first.</source>
            <translation>Berechnen Sie erst den Take.</translation>
        </message>
        <message>
            <source>%1 (open, with your edits)</source>
            <translation>%1 (offen, mit Ihren Änderungen)</translation>
        </message>
        <message>
            <source>%1 frames, %2, %3 bones.</source>
            <translation>%1 Bilder, %2, %3 Knochen.</translation>
        </message>
        <message>
            <source> The file exists and will be replaced.</source>
            <translation> Die Datei gibt es schon; sie wird ersetzt.</translation>
        </message>
        <message>
            <source>Export to</source>
            <translation>Ausgeben nach</translation>
        </message>
        <message>
            <source>%1 (*%2)</source>
            <translation>%1 (*%2)</translation>
        </message>
        <message>
            <source>Exporting %1</source>
            <translation>%1 wird ausgegeben</translation>
        </message>
        <message>
            <source>Written and read back: %1</source>
            <translation>Geschrieben und zurückgelesen: %1</translation>
        </message>
        <message>
            <source>%1, %2 frames at %3 Hz, %4, %5 bones, in %6</source>
            <translation>%1, %2 Bilder mit %3 Hz, %4, %5 Knochen, in %6</translation>
        </message>
        <message>
            <source>Export cancelled.</source>
            <translation>Ausgabe abgebrochen.</translation>
        </message>
        <message>
            <source>No file was left behind.</source>
            <translation>Es blieb keine Datei zurück.</translation>
        </message>
        <message>
            <source>Not exported. %1</source>
            <translation>Nicht ausgegeben. %1</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::JobBar</name>
        <message>
            <source>stopping</source>
            <translation>hält an</translation>
        </message>
        <message>
            <source>%1 left</source>
            <translation>noch %1</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <source>Cancel: %1</source>
            <translation>Abbrechen: %1</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::KeyEditor</name>
        <message>
            <source>set key of %1</source>
            <translation>Schlüssel von %1 setzen</translation>
        </message>
        <message>
            <source>change key of %1</source>
            <translation>Schlüssel von %1 ändern</translation>
        </message>
        <message numerus="yes">
            <source>move %n key(s)</source>
            <translation>
                <numerusform>%n Schlüssel verschieben</numerusform>
                <numerusform>%n Schlüssel verschieben</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>turn %n key(s)</source>
            <translation>
                <numerusform>%n Schlüssel drehen</numerusform>
                <numerusform>%n Schlüssel drehen</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>delete %n key(s)</source>
            <translation>
                <numerusform>%n Schlüssel löschen</numerusform>
                <numerusform>%n Schlüssel löschen</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::LevelMeter</name>
        <message>
            <source>clips</source>
            <translation>übersteuert</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::LevelPanel</name>
        <message>
            <source>Level</source>
            <translation>Pegel</translation>
        </message>
        <message>
            <source>Left: accelerations</source>
            <translation>Links: Beschleunigungen</translation>
        </message>
        <message>
            <source>Right: clock</source>
            <translation>Rechts: Takt</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::LimbHoldPage</name>
        <message>
            <source>Check: %1</source>
            <translation>Prüfung: %1</translation>
        </message>
        <message>
            <source>Pose %1 of 2: %2</source>
            <translation>Pose %1 von 2: %2</translation>
        </message>
        <message>
            <source>, </source>
            <translation>, </translation>
        </message>
        <message>
            <source>Take this pose</source>
            <translation>Diese Pose einnehmen</translation>
        </message>
        <message>
            <source>The device is back</source>
            <translation>Das Gerät ist wieder da</translation>
        </message>
        <message>
            <source>Signal lost</source>
            <translation>Signal weg</translation>
        </message>
        <message>
            <source>Go back and start the poses again.</source>
            <translation>Zurückgehen und die Posen neu beginnen.</translation>
        </message>
        <message>
            <source>The device stopped sending. Plug it in again, open it in Capture, then go back and start the poses again. What was held until then is kept.</source>
            <translation>Das Gerät sendet nicht mehr. Wieder einstecken, unter „Aufnehmen“ öffnen, dann zurückgehen und die Posen neu beginnen. Was bis dahin gehalten wurde, bleibt erhalten.</translation>
        </message>
        <message>
            <source>lost</source>
            <translation>weg</translation>
        </message>
        <message>
            <source>Go on without %1</source>
            <translation>Ohne %1 weitermachen</translation>
        </message>
        <message>
            <source>Take the stillest second (%1)</source>
            <translation>Die ruhigste Sekunde nehmen (%1)</translation>
        </message>
        <message>
            <source>No signal: %1</source>
            <translation>Kein Signal: %1</translation>
        </message>
        <message>
            <source>Check the cable and plug of %1, or go on without.</source>
            <translation>Kabel und Stecker prüfen (%1) oder ohne weitermachen.</translation>
        </message>
        <message>
            <source>?</source>
            <translation>?</translation>
        </message>
        <message>
            <source>Hold still</source>
            <translation>Stillhalten</translation>
        </message>
        <message>
            <source>Good, stay like this.</source>
            <translation>Gut, so bleiben.</translation>
        </message>
        <message>
            <source>still</source>
            <translation>still</translation>
        </message>
        <message>
            <source>Moves: %1</source>
            <translation>Bewegt sich: %1</translation>
        </message>
        <message>
            <source>Rest it against something, breathe out and hold. It is taken as soon as all are still.</source>
            <translation>Anlehnen, ausatmen und halten. Sobald alle still sind, wird es genommen.</translation>
        </message>
        <message>
            <source>moves</source>
            <translation>bewegt</translation>
        </message>
        <message>
            <source>One still second is enough.</source>
            <translation>Eine ruhige Sekunde genügt.</translation>
        </message>
        <message>
            <source>hold</source>
            <translation>halten</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::LimbWizard</name>
        <message>
            <source>Calibrate mounting</source>
            <translation>Sitz kalibrieren</translation>
        </message>
        <message>
            <source>Which limb, and which of its sensors?</source>
            <translation>Welches Glied, und welche seiner Sensoren?</translation>
        </message>
        <message>
            <source>Mounting calibration finds how every sensor sits on its limb, from two poses a right angle apart. It is done each time the sensors are put on.</source>
            <translation>Hier wird aus zwei Posen im rechten Winkel gefunden, wie jeder Sensor auf seinem Glied sitzt. Das ist jedes Mal nötig, wenn die Sensoren angelegt werden.</translation>
        </message>
        <message>
            <source>Who wears them</source>
            <translation>Wer sie trägt</translation>
        </message>
        <message>
            <source>Name (may stay empty)</source>
            <translation>Name (darf leer bleiben)</translation>
        </message>
        <message>
            <source>Calibrate their range first</source>
            <translation>Zuerst ihren Messbereich kalibrieren</translation>
        </message>
        <message>
            <source>After Start you have the time below to take the first pose. It is captured by itself as soon as everything is still for a second; a sound tells, and the second pose follows. No key is needed.</source>
            <translation>Nach „Start“ bleibt die Zeit unten, um die erste Pose einzunehmen. Sie wird von selbst erfasst, sobald alles eine Sekunde lang still ist; ein Ton sagt es, dann folgt die zweite Pose. Keine Taste ist nötig.</translation>
        </message>
        <message>
            <source>Time to take a pose</source>
            <translation>Zeit für eine Pose</translation>
        </message>
        <message>
            <source> s</source>
            <translation> s</translation>
        </message>
        <message>
            <source>Repeat both poses</source>
            <translation>Beide Posen wiederholen</translation>
        </message>
        <message>
            <source>The pose that was held would not be used.</source>
            <translation>Die gehaltene Pose ginge verloren.</translation>
        </message>
        <message>
            <source>. Remedy: %1.</source>
            <translation>. Abhilfe: %1.</translation>
        </message>
        <message>
            <source>between poses</source>
            <translation>zwischen den Posen</translation>
        </message>
        <message>
            <source>%1 from 90°, held within %2.</source>
            <translation>%1 von 90°, gehalten auf %2.</translation>
        </message>
        <message>
            <source> The poses were not a right angle apart: each may be %1 off.</source>
            <translation> Die Posen standen nicht im rechten Winkel: Jede kann %1 daneben sein.</translation>
        </message>
        <message>
            <source> It moved while it was held.</source>
            <translation> Es hat sich beim Halten bewegt.</translation>
        </message>
        <message>
            <source> It reads %1 g at rest: calibrate its range, or the volume was moved.</source>
            <translation> In Ruhe zeigt er %1 g: Messbereich kalibrieren, oder der Pegel wurde verstellt.</translation>
        </message>
        <message>
            <source>sits %1 from how the rig shows it</source>
            <translation>sitzt %1 anders, als das Rig zeigt</translation>
        </message>
        <message>
            <source>attempt before: %1</source>
            <translation>Versuch davor: %1</translation>
        </message>
        <message>
            <source>%1: %2, then %3</source>
            <translation>%1: %2, dann %3</translation>
        </message>
        <message>
            <source>Range never calibrated: %1. Their directions may be several degrees off.</source>
            <translation>Messbereich nie kalibriert: %1. Die Richtungen können mehrere Grad daneben sein.</translation>
        </message>
        <message>
            <source>, </source>
            <translation>, </translation>
        </message>
        <message>
            <source>Limb</source>
            <translation>Glied</translation>
        </message>
        <message>
            <source>How</source>
            <translation>Wie</translation>
        </message>
        <message>
            <source>First pose</source>
            <translation>Erste Pose</translation>
        </message>
        <message>
            <source>Second pose</source>
            <translation>Zweite Pose</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Urteil</translation>
        </message>
        <message>
            <source>Continue</source>
            <translation>Weiter</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Start</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>Zurück</translation>
        </message>
        <message>
            <source>Skip the wait</source>
            <translation>Nicht warten</translation>
        </message>
        <message>
            <source>Take the stillest second</source>
            <translation>Die ruhigste Sekunde nehmen</translation>
        </message>
        <message>
            <source>Computing…</source>
            <translation>Wird berechnet…</translation>
        </message>
        <message>
            <source>Save %1</source>
            <translation>%1 speichern</translation>
        </message>
        <message>
            <source>Back to the verdict</source>
            <translation>Zurück zum Urteil</translation>
        </message>
        <message>
            <source>%1 %2; %3.</source>
            <translation>%1 %2; %3.</translation>
        </message>
        <message>
            <source>Check: hold &quot;%1&quot; again</source>
            <translation>Prüfen: „%1“ noch einmal halten</translation>
        </message>
        <message>
            <source>held within %1</source>
            <translation>gehalten auf %1</translation>
        </message>
        <message>
            <source>Not checked</source>
            <translation>Nicht geprüft</translation>
        </message>
        <message>
            <source>At most %1 off</source>
            <translation>Höchstens %1 daneben</translation>
        </message>
        <message>
            <source>Angle between gravity as each sensor now sees it on its limb and as the pose asks for. It holds the wearer&apos;s own inexactness too.</source>
            <translation>Winkel zwischen der Schwerkraft, wie jeder Sensor sie jetzt auf seinem Glied sieht, und wie die Pose sie verlangt. Die Ungenauigkeit der Person steckt mit darin.</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::LimbWizardModel</name>
        <message>
            <source>This rig names no poses. Add calibration groups to its file.</source>
            <translation>Dieses Rig nennt keine Posen. In seiner Datei Kalibriergruppen ergänzen.</translation>
        </message>
        <message>
            <source>Choose at least one sensor.</source>
            <translation>Mindestens einen Sensor wählen.</translation>
        </message>
        <message>
            <source>No signal comes in. Open a device in Capture.</source>
            <translation>Es kommt kein Signal. Unter „Aufnehmen“ ein Gerät öffnen.</translation>
        </message>
        <message>
            <source>The device died. Go back and start again when it is there.</source>
            <translation>Das Gerät ist ausgefallen. Zurückgehen und neu beginnen, wenn es wieder da ist.</translation>
        </message>
        <message>
            <source>Hold still: it goes on by itself.</source>
            <translation>Stillhalten: Es geht von selbst weiter.</translation>
        </message>
        <message>
            <source>Computing…</source>
            <translation>Wird berechnet…</translation>
        </message>
        <message>
            <source>Saving…</source>
            <translation>Wird gespeichert…</translation>
        </message>
        <message>
            <source>Nothing is accepted yet.</source>
            <translation>Noch ist nichts angenommen.</translation>
        </message>
        <message>
            <source>Computing the mounting</source>
            <translation>Der Sitz wird berechnet</translation>
        </message>
        <message>
            <source>Checking the mounting</source>
            <translation>Der Sitz wird geprüft</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::LiveModel</name>
        <message>
            <source>Opening %1</source>
            <translation>%1 wird geöffnet</translation>
        </message>
        <message>
            <source>Closing %1</source>
            <translation>%1 wird geschlossen</translation>
        </message>
        <message>
            <source>%1 has stopped sending.</source>
            <translation>%1 sendet nicht mehr.</translation>
        </message>
        <message>
            <source>Plug it in again, then choose it once more. What was recorded until now is kept.</source>
            <translation>Stecken Sie es wieder ein und wählen Sie es noch einmal. Was bis jetzt aufgenommen wurde, bleibt erhalten.</translation>
        </message>
        <message>
            <source>Making the take</source>
            <translation>Take wird angelegt</translation>
        </message>
        <message>
            <source>Closing the take</source>
            <translation>Take wird geschlossen</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::MainWindow</name>
        <message>
            <source>Recent takes</source>
            <translation>Letzte Takes</translation>
        </message>
        <message>
            <source>Inspector</source>
            <translation>Inspektor</translation>
        </message>
        <message>
            <source>Timeline</source>
            <translation>Zeitleiste</translation>
        </message>
        <message>
            <source>New take</source>
            <translation>Neuer Take</translation>
        </message>
        <message>
            <source>Open take…</source>
            <translation>Take öffnen …</translation>
        </message>
        <message>
            <source>Import recording…</source>
            <translation>Aufnahme einlesen …</translation>
        </message>
        <message>
            <source>Close take</source>
            <translation>Take schließen</translation>
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
            <source>Light colours</source>
            <translation>Helle Farben</translation>
        </message>
        <message>
            <source>Full screen</source>
            <translation>Vollbild</translation>
        </message>
        <message>
            <source>Keyboard shortcuts</source>
            <translation>Tastenkürzel</translation>
        </message>
        <message>
            <source>Quit</source>
            <translation>Beenden</translation>
        </message>
        <message>
            <source>%1 – %2</source>
            <translation>%1 – %2</translation>
        </message>
        <message>
            <source>● Recording – %1</source>
            <translation>● Aufnahme – %1</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::MarkerModel</name>
        <message>
            <source>Marker %1</source>
            <translation>Marke %1</translation>
        </message>
        <message>
            <source>set marker</source>
            <translation>Marke setzen</translation>
        </message>
        <message>
            <source>rename marker</source>
            <translation>Marke umbenennen</translation>
        </message>
        <message>
            <source>move marker</source>
            <translation>Marke verschieben</translation>
        </message>
        <message>
            <source>delete marker</source>
            <translation>Marke löschen</translation>
        </message>
        <message>
            <source>The marker is not saved</source>
            <translation>Die Marke ist nicht gespeichert</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::MarkerPanel</name>
        <message>
            <source>Markers</source>
            <translation>Marken</translation>
        </message>
        <message>
            <source>Set marker</source>
            <translation>Marke setzen</translation>
        </message>
        <message>
            <source>Press M while recording.</source>
            <translation>Drücken Sie M während der Aufnahme.</translation>
        </message>
        <message>
            <source>Set a marker at this moment of the recording (M)</source>
            <translation>An dieser Stelle der Aufnahme eine Marke setzen (M)</translation>
        </message>
        <message>
            <source>Rename the marker (F2)</source>
            <translation>Die Marke umbenennen (F2)</translation>
        </message>
        <message>
            <source>Delete the marker (Delete)</source>
            <translation>Die Marke löschen (Entf)</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Zeit</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <source>Double click to type another time</source>
            <translation>Doppelklick: eine andere Zeit eintippen</translation>
        </message>
        <message>
            <source>Press M while recording. In the signal below, double click at the upper edge.</source>
            <translation>Während der Aufnahme M drücken. Unten im Signal: Doppelklick am oberen Rand.</translation>
        </message>
        <message>
            <source>&quot;%1&quot; is not a time.</source>
            <translation>„%1“ ist keine Zeit.</translation>
        </message>
        <message>
            <source>Write it like 1:07.3 or 67.3.</source>
            <translation>Zum Beispiel 1:07,3 oder 67,3 schreiben.</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::MessageBar</name>
        <message>
            <source>Dismiss</source>
            <translation>Ausblenden</translation>
        </message>
        <message>
            <source>%1 more</source>
            <translation>%1 weitere</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::ModeBar</name>
        <message>
            <source>Workspaces</source>
            <translation>Arbeitsbereiche</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Start</translation>
        </message>
        <message>
            <source>The welcome page: demo takes, recent takes</source>
            <translation>Die Startseite: Demo-Takes, letzte Takes</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::MovementBars</name>
        <message>
            <source>waiting</source>
            <translation>wartet</translation>
        </message>
        <message>
            <source>no signal</source>
            <translation>kein Signal</translation>
        </message>
        <message>
            <source>moves: %1</source>
            <translation>bewegt: %1</translation>
        </message>
        <message>
            <source>still: %1</source>
            <translation>still: %1</translation>
        </message>
        <message>
            <source>still below %1</source>
            <translation>still unter %1</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::OverviewPanel</name>
        <message>
            <source>Reading %1</source>
            <translation>%1 wird gelesen</translation>
        </message>
        <message>
            <source>The signal cannot be shown</source>
            <translation>Das Signal lässt sich nicht zeigen</translation>
        </message>
        <message>
            <source>What is being recorded</source>
            <translation>Was gerade aufgenommen wird</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::OverviewView</name>
        <message>
            <source>Recorded signal</source>
            <translation>Aufgenommenes Signal</translation>
        </message>
        <message>
            <source>The take is empty.</source>
            <translation>Der Take ist leer.</translation>
        </message>
        <message>
            <source>Reading the signal…</source>
            <translation>Das Signal wird gelesen …</translation>
        </message>
        <message>
            <source> s</source>
            <translation> s</translation>
        </message>
        <message>
            <source>%1 at %2. Drag: move. Double click: rename. Delete: delete.</source>
            <translation>%1 bei %2. Ziehen: verschieben. Doppelklick: umbenennen. Entf: löschen.</translation>
        </message>
        <message>
            <source>Wheel: zoom. Drag: move. Double click: show all; at the upper edge: set a marker there.</source>
            <translation>Rad: Zoom. Ziehen: verschieben. Doppelklick: alles zeigen; am oberen Rand: dort eine Marke setzen.</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::QualityCard</name>
        <message>
            <source>Quality</source>
            <translation>Güte</translation>
        </message>
        <message>
            <source>Numbers appear here once the take is solved.</source>
            <translation>Hier erscheinen Zahlen, sobald der Take berechnet ist.</translation>
        </message>
        <message>
            <source>Sensor</source>
            <translation>Sensor</translation>
        </message>
        <message>
            <source>usable</source>
            <translation>brauchbar</translation>
        </message>
        <message>
            <source>trusted</source>
            <translation>vertraut</translation>
        </message>
        <message>
            <source>at rest</source>
            <translation>in Ruhe</translation>
        </message>
        <message>
            <source>%1 g</source>
            <translation>%1 g</translation>
        </message>
        <message>
            <source>–</source>
            <translation>–</translation>
        </message>
        <message numerus="yes">
            <source>and %n more finding(s)</source>
            <translation>
                <numerusform>und %n weiterer Befund</numerusform>
                <numerusform>und %n weitere Befunde</numerusform>
            </translation>
        </message>
        <message>
            <source>%1 of take; decoded in %2 s, solved in %3 s</source>
            <translation>%1 Take; dekodiert in %2 s, berechnet in %3 s</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::RangeTurnPage</name>
        <message>
            <source>Start turning</source>
            <translation>Jetzt drehen</translation>
        </message>
        <message>
            <source>Slowly, about ten seconds for a full turn.</source>
            <translation>Langsam, etwa zehn Sekunden für eine volle Drehung.</translation>
        </message>
        <message>
            <source>%1: no signal</source>
            <translation>%1: kein Signal</translation>
        </message>
        <message>
            <source>Its readings stopped. Check its cable and plug; what was turned so far is kept.</source>
            <translation>Die Messwerte sind ausgeblieben. Kabel und Stecker prüfen; was bisher gedreht wurde, bleibt erhalten.</translation>
        </message>
        <message>
            <source>Slower</source>
            <translation>Langsamer</translation>
        </message>
        <message>
            <source>Only slow turning shows gravity alone. What is too fast is left out.</source>
            <translation>Nur langsames Drehen zeigt die Schwerkraft allein. Was zu schnell ist, zählt nicht.</translation>
        </message>
        <message>
            <source>Smoother</source>
            <translation>Ruhiger</translation>
        </message>
        <message>
            <source>Jerks and knocks are left out. Turn it like a full glass.</source>
            <translation>Rucke und Stöße zählen nicht. Wie ein volles Glas drehen.</translation>
        </message>
        <message>
            <source>Enough</source>
            <translation>Genug</translation>
        </message>
        <message>
            <source>Finish now, or fill the last gaps for an even better result.</source>
            <translation>Jetzt beenden oder die letzten Lücken füllen; das Ergebnis wird dann noch besser.</translation>
        </message>
        <message>
            <source>Complete</source>
            <translation>Vollständig</translation>
        </message>
        <message>
            <source>Go on turning</source>
            <translation>Weiterdrehen</translation>
        </message>
        <message>
            <source>Every direction was seen. Press Enter to finish.</source>
            <translation>Jede Richtung war dabei. Eingabetaste: beenden.</translation>
        </message>
        <message>
            <source>Every direction was seen; a few more steady seconds are needed.</source>
            <translation>Jede Richtung war dabei; es fehlen noch einige ruhige Sekunden.</translation>
        </message>
        <message>
            <source>Turn: %1</source>
            <translation>Drehen: %1</translation>
        </message>
        <message>
            <source>%1 has enough; these directions would make it better.</source>
            <translation>%1 hat genug; diese Richtungen machen es besser.</translation>
        </message>
        <message>
            <source>Bring the blue arrow of the box to the top; on the map, the white dot into the blue ring.</source>
            <translation>Den blauen Pfeil des Kastens nach oben bringen; auf der Karte: den weißen Punkt in den blauen Ring.</translation>
        </message>
        <message>
            <source>Start over</source>
            <translation>Von vorn</translation>
        </message>
        <message>
            <source>Show this sensor; once more: the one in most need</source>
            <translation>Diesen Sensor zeigen; noch einmal: den bedürftigsten</translation>
        </message>
        <message>
            <source>%1  no signal</source>
            <translation>%1  kein Signal</translation>
        </message>
        <message>
            <source>%1  %2 %</source>
            <translation>%1  %2 %</translation>
        </message>
        <message>
            <source>The device is back</source>
            <translation>Das Gerät ist wieder da</translation>
        </message>
        <message>
            <source>Signal lost</source>
            <translation>Signal weg</translation>
        </message>
        <message>
            <source>Start over to turn the sensors once more.</source>
            <translation>„Von vorn“, um die Sensoren noch einmal zu drehen.</translation>
        </message>
        <message>
            <source>The device stopped sending. Plug it in again and open it in Capture, then start over.</source>
            <translation>Das Gerät sendet nicht mehr. Wieder einstecken, unter „Aufnehmen“ öffnen, dann von vorn.</translation>
        </message>
        <message>
            <source>Or finish with what was turned until then; it is kept.</source>
            <translation>Oder mit dem beenden, was bis dahin gedreht wurde; es bleibt erhalten.</translation>
        </message>
        <message>
            <source>Nothing had been turned yet.</source>
            <translation>Noch war nichts gedreht.</translation>
        </message>
        <message>
            <source>The device is gone: open it in Capture first.</source>
            <translation>Das Gerät ist weg: zuerst unter „Aufnehmen“ öffnen.</translation>
        </message>
        <message>
            <source>&lt;b&gt;%1 %&lt;/b&gt; of the sphere, %2 % needed&lt;br&gt;&lt;b&gt;%3 s&lt;/b&gt; steady, %4 s needed&lt;br&gt;%5 turned</source>
            <translation>&lt;b&gt;%1 %&lt;/b&gt; der Kugel, nötig %2 %&lt;br&gt;&lt;b&gt;%3 s&lt;/b&gt; ruhig, nötig %4 s&lt;br&gt;%5 gedreht</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::RangeWizard</name>
        <message>
            <source>RMS off 1 g</source>
            <translation>RMS neben 1 g</translation>
        </message>
        <message>
            <source>Ellipsoid is better: %1 against %2 by extremes.</source>
            <translation>Ellipsoid ist besser: %1 gegen %2 aus Extremwerten.</translation>
        </message>
        <message>
            <source>Extremes are better: %1 against %2 by ellipsoid.</source>
            <translation>Extremwerte sind besser: %1 gegen %2 mit Ellipsoid.</translation>
        </message>
        <message>
            <source>%1 % of the sphere, %2 s steady</source>
            <translation>%1 % der Kugel, %2 s ruhig</translation>
        </message>
        <message>
            <source>attempt before: %1</source>
            <translation>Versuch davor: %1</translation>
        </message>
        <message>
            <source>Calibrate range</source>
            <translation>Messbereich kalibrieren</translation>
        </message>
        <message>
            <source>Which sensors?</source>
            <translation>Welche Sensoren?</translation>
        </message>
        <message>
            <source>Range calibration finds each sensor&apos;s zero and scale from gravity. It is done &lt;b&gt;once in a sensor&apos;s life&lt;/b&gt;, not on the body, and takes about a minute.</source>
            <translation>Hier werden Nullpunkt und Maßstab jedes Sensors aus der Schwerkraft gefunden. Das geschieht &lt;b&gt;einmal im Leben eines Sensors&lt;/b&gt;, nicht am Körper, und dauert etwa eine Minute.</translation>
        </message>
        <message>
            <source>Several sensors can be calibrated at once: fix them in one small box so that none can slip, and turn the box.</source>
            <translation>Mehrere Sensoren gehen zugleich: in einem kleinen Kasten so befestigen, dass keiner rutscht, und den Kasten drehen.</translation>
        </message>
        <message>
            <source>&lt;b&gt;Hold the box in both hands&lt;/b&gt;, cables slack. Sit down: it takes about a minute.</source>
            <translation>&lt;b&gt;Den Kasten in beide Hände nehmen&lt;/b&gt;, Kabel locker. Hinsetzen: Es dauert etwa eine Minute.</translation>
        </message>
        <message>
            <source>&lt;b&gt;Turn it slowly until every face has looked up once&lt;/b&gt;, then every edge and corner between them.</source>
            <translation>&lt;b&gt;Langsam drehen, bis jede Fläche einmal oben war&lt;/b&gt;, dann jede Kante und Ecke dazwischen.</translation>
        </message>
        <message>
            <source>&lt;b&gt;Slowly&lt;/b&gt; means about ten seconds for a full turn, without knocks. Only steady turning counts; what is too fast is left out by itself.</source>
            <translation>&lt;b&gt;Langsam&lt;/b&gt; heißt etwa zehn Sekunden für eine volle Drehung, ohne Stöße. Nur ruhiges Drehen zählt; zu Schnelles fällt von selbst weg.</translation>
        </message>
        <message>
            <source>The map fills up as you turn. It always names the direction that is missing most.</source>
            <translation>Die Karte füllt sich beim Drehen. Sie nennt immer die Richtung, die am meisten fehlt.</translation>
        </message>
        <message>
            <source>Sensors</source>
            <translation>Sensoren</translation>
        </message>
        <message>
            <source>How</source>
            <translation>Wie</translation>
        </message>
        <message>
            <source>Turn</source>
            <translation>Drehen</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Urteil</translation>
        </message>
        <message>
            <source>Continue</source>
            <translation>Weiter</translation>
        </message>
        <message>
            <source>Start turning</source>
            <translation>Jetzt drehen</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>Zurück</translation>
        </message>
        <message>
            <source>Finish</source>
            <translation>Beenden</translation>
        </message>
        <message>
            <source>Finish early</source>
            <translation>Vorzeitig beenden</translation>
        </message>
        <message>
            <source>Computing…</source>
            <translation>Wird berechnet…</translation>
        </message>
        <message>
            <source>Save %1</source>
            <translation>%1 speichern</translation>
        </message>
        <message>
            <source>What was turned until now would not be used.</source>
            <translation>Was bis jetzt gedreht wurde, ginge verloren.</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::RangeWizardModel</name>
        <message>
            <source>Choose at least one sensor.</source>
            <translation>Mindestens einen Sensor wählen.</translation>
        </message>
        <message>
            <source>No signal comes in. Open a device in Capture.</source>
            <translation>Es kommt kein Signal. Unter „Aufnehmen“ ein Gerät öffnen.</translation>
        </message>
        <message>
            <source>The device died before anything was turned. Start over when it is back.</source>
            <translation>Das Gerät fiel aus, bevor etwas gedreht war. Von vorn, wenn es wieder da ist.</translation>
        </message>
        <message>
            <source>Turn the sensors first.</source>
            <translation>Zuerst die Sensoren drehen.</translation>
        </message>
        <message>
            <source>Computing…</source>
            <translation>Wird berechnet…</translation>
        </message>
        <message>
            <source>Saving…</source>
            <translation>Wird gespeichert…</translation>
        </message>
        <message>
            <source>Nothing is accepted yet.</source>
            <translation>Noch ist nichts angenommen.</translation>
        </message>
        <message>
            <source>Computing the range calibration</source>
            <translation>Der Messbereich wird berechnet</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::RateGauge</name>
        <message>
            <source>%1°/s</source>
            <translation>%1°/s</translation>
        </message>
        <message>
            <source>No signal</source>
            <translation>Kein Signal</translation>
        </message>
        <message>
            <source>Too fast: %1</source>
            <translation>Zu schnell: %1</translation>
        </message>
        <message>
            <source>Jerky: %1</source>
            <translation>Ruckelt: %1</translation>
        </message>
        <message>
            <source>Steady: %1</source>
            <translation>Ruhig: %1</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::RecordPanel</name>
        <message>
            <source>Recorded time</source>
            <translation>Aufgenommene Zeit</translation>
        </message>
        <message>
            <source>Subject</source>
            <translation>Person</translation>
        </message>
        <message>
            <source>Who wears the sensors</source>
            <translation>Wer die Sensoren trägt</translation>
        </message>
        <message>
            <source>Name of the take</source>
            <translation>Name des Takes</translation>
        </message>
        <message>
            <source>Take</source>
            <translation>Take</translation>
        </message>
        <message>
            <source>Choose the folder for takes</source>
            <translation>Ordner für Takes wählen</translation>
        </message>
        <message>
            <source>Folder for takes</source>
            <translation>Ordner für Takes</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Stopp</translation>
        </message>
        <message>
            <source>Record</source>
            <translation>Aufnehmen</translation>
        </message>
        <message>
            <source>Stop recording</source>
            <translation>Aufnahme beenden</translation>
        </message>
        <message>
            <source>Stop recording and close the take (R)</source>
            <translation>Aufnahme beenden und den Take schließen (R)</translation>
        </message>
        <message>
            <source>Record a new take (R)</source>
            <translation>Einen neuen Take aufnehmen (R)</translation>
        </message>
        <message>
            <source>Choose a device first</source>
            <translation>Wählen Sie erst ein Gerät</translation>
        </message>
        <message>
            <source>Recording, but samples are being lost</source>
            <translation>Aufnahme läuft, aber Werte gehen verloren</translation>
        </message>
        <message>
            <source>Recording</source>
            <translation>Aufnahme läuft</translation>
        </message>
        <message>
            <source>Closing the take</source>
            <translation>Take wird geschlossen</translation>
        </message>
        <message>
            <source>Making the take</source>
            <translation>Take wird angelegt</translation>
        </message>
        <message>
            <source>Ready</source>
            <translation>Bereit</translation>
        </message>
        <message>
            <source>Opening the device</source>
            <translation>Gerät wird geöffnet</translation>
        </message>
        <message>
            <source>Not ready</source>
            <translation>Nicht bereit</translation>
        </message>
        <message>
            <source>No device</source>
            <translation>Kein Gerät</translation>
        </message>
        <message>
            <source>disk: %1</source>
            <translation>Platte: %1</translation>
        </message>
        <message>
            <source>How long recording lasts until the disk is full</source>
            <translation>Wie lange aufgenommen werden kann, bis die Platte voll ist</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::SaveQueue</name>
        <message>
            <source>Saving the take</source>
            <translation>Der Take wird gespeichert</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::ScopeView</name>
        <message>
            <source>Scope of both channels</source>
            <translation>Oszilloskop beider Kanäle</translation>
        </message>
        <message>
            <source>ref</source>
            <translation>Ref</translation>
        </message>
        <message>
            <source>full height ±%1 of full scale</source>
            <translation>volle Höhe ±%1 der Aussteuerung</translation>
        </message>
        <message>
            <source>Right channel: accelerations (swapped)</source>
            <translation>Rechter Kanal: Beschleunigungen (vertauscht)</translation>
        </message>
        <message>
            <source>Left channel: accelerations</source>
            <translation>Linker Kanal: Beschleunigungen</translation>
        </message>
        <message>
            <source>Left channel: clock (swapped)</source>
            <translation>Linker Kanal: Takt (vertauscht)</translation>
        </message>
        <message>
            <source>Right channel: clock</source>
            <translation>Rechter Kanal: Takt</translation>
        </message>
        <message>
            <source>not in step with the board: the picture runs free, slots are not known</source>
            <translation>nicht im Takt mit der Platine: Das Bild läuft frei, die Fächer sind unbekannt</translation>
        </message>
        <message>
            <source>no signal</source>
            <translation>kein Signal</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::SensorCube</name>
        <message>
            <source>How the sensor is held</source>
            <translation>Wie der Sensor gehalten wird</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::SensorRow</name>
        <message>
            <source>%1: range %2, mounting %3</source>
            <translation>%1: Messbereich %2, Sitz %3</translation>
        </message>
        <message>
            <source>Calibrate</source>
            <translation>Kalibrieren</translation>
        </message>
        <message>
            <source>Repeat</source>
            <translation>Wiederholen</translation>
        </message>
        <message>
            <source>Range of %1 only</source>
            <translation>Nur den Messbereich von %1</translation>
        </message>
        <message>
            <source>Mounting of %1 only</source>
            <translation>Nur den Sitz von %1</translation>
        </message>
        <message>
            <source>The rig names no poses for this sensor.</source>
            <translation>Das Rig nennt für diesen Sensor keine Posen.</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::SensorStrips</name>
        <message>
            <source>Accelerations and health of every sensor</source>
            <translation>Beschleunigungen und Zustand jedes Sensors</translation>
        </message>
        <message>
            <source>x axis, m/s²</source>
            <translation>x-Achse, m/s²</translation>
        </message>
        <message>
            <source>y axis, m/s²</source>
            <translation>y-Achse, m/s²</translation>
        </message>
        <message>
            <source>z axis, m/s²</source>
            <translation>z-Achse, m/s²</translation>
        </message>
        <message>
            <source>−10 s</source>
            <translation>−10 s</translation>
        </message>
        <message>
            <source>now</source>
            <translation>jetzt</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::SettingsCard</name>
        <message>
            <source>Solving</source>
            <translation>Berechnung</translation>
        </message>
        <message>
            <source>Smoothing</source>
            <translation>Glättung</translation>
        </message>
        <message>
            <source> ms</source>
            <translation> ms</translation>
        </message>
        <message>
            <source>Time scale of the smoothing in milliseconds</source>
            <translation>Zeitmaß der Glättung in Millisekunden</translation>
        </message>
        <message>
            <source>Calibration</source>
            <translation>Kalibrierung</translation>
        </message>
        <message>
            <source>Best there is</source>
            <translation>Beste vorhandene</translation>
        </message>
        <message>
            <source>Of the take</source>
            <translation>Aus dem Take</translation>
        </message>
        <message>
            <source>Poses in the take</source>
            <translation>Haltungen im Take</translation>
        </message>
        <message>
            <source>Library</source>
            <translation>Bibliothek</translation>
        </message>
        <message>
            <source>Data sheet</source>
            <translation>Datenblatt</translation>
        </message>
        <message>
            <source>Strength</source>
            <translation>Stärke</translation>
        </message>
        <message>
            <source>Solve</source>
            <translation>Berechnen</translation>
        </message>
        <message>
            <source>change smoothing</source>
            <translation>Glättung ändern</translation>
        </message>
        <message>
            <source>change calibration</source>
            <translation>Kalibrierung ändern</translation>
        </message>
        <message>
            <source>change strength of smoothing</source>
            <translation>Stärke der Glättung ändern</translation>
        </message>
        <message>
            <source>Cancel solving</source>
            <translation>Berechnung abbrechen</translation>
        </message>
        <message>
            <source>Solve again</source>
            <translation>Neu berechnen</translation>
        </message>
        <message>
            <source>Used: %1</source>
            <translation>Benutzt: %1</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::ShortcutSheet</name>
        <message>
            <source>Everywhere</source>
            <translation>Überall</translation>
        </message>
        <message>
            <source>Go to a workspace</source>
            <translation>Zu einem Arbeitsbereich</translation>
        </message>
        <message>
            <source>New take</source>
            <translation>Neuer Take</translation>
        </message>
        <message>
            <source>Open a take</source>
            <translation>Take öffnen</translation>
        </message>
        <message>
            <source>Import recordings</source>
            <translation>Aufnahmen einlesen</translation>
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
            <source>Full screen</source>
            <translation>Vollbild</translation>
        </message>
        <message>
            <source>This sheet</source>
            <translation>Diese Übersicht</translation>
        </message>
        <message>
            <source>Timeline</source>
            <translation>Zeitleiste</translation>
        </message>
        <message>
            <source>Keyboard shortcuts</source>
            <translation>Tastenkürzel</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::SignalStrip</name>
        <message>
            <source>Accelerations of the newest seconds</source>
            <translation>Beschleunigungen der letzten Sekunden</translation>
        </message>
        <message>
            <source>%1 g</source>
            <translation>%1 g</translation>
        </message>
        <message>
            <source>No readings yet</source>
            <translation>Noch keine Messwerte</translation>
        </message>
        <message>
            <source> g</source>
            <translation> g</translation>
        </message>
        <message>
            <source>none</source>
            <translation>keine</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::SolveModel</name>
        <message>
            <source>Reading the solve</source>
            <translation>Berechnung wird gelesen</translation>
        </message>
        <message>
            <source>Solving %1</source>
            <translation>%1 wird berechnet</translation>
        </message>
        <message>
            <source>The saved solve could not be read; solving again.</source>
            <translation>Die gespeicherte Berechnung war nicht lesbar; es wird neu berechnet.</translation>
        </message>
        <message>
            <source>Solving was cancelled</source>
            <translation>Die Berechnung wurde abgebrochen</translation>
        </message>
        <message>
            <source>The solve could not be saved in the take.</source>
            <translation>Die Berechnung ließ sich nicht im Take speichern.</translation>
        </message>
        <message>
            <source>The solve could not be compared with the truth.</source>
            <translation>Die Berechnung ließ sich nicht mit der Wahrheit vergleichen.</translation>
        </message>
        <message>
            <source>change length of %1</source>
            <translation>Länge von %1 ändern</translation>
        </message>
        <message>
            <source>Saving the solve</source>
            <translation>Berechnung wird gespeichert</translation>
        </message>
        <message>
            <source>Your edits could not be saved in the take.</source>
            <translation>Ihre Änderungen ließen sich nicht im Take speichern.</translation>
        </message>
        <message>
            <source>Comparing with the truth</source>
            <translation>Vergleich mit der Wahrheit</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::SolveWorkspace</name>
        <message>
            <source>Capture a take</source>
            <translation>Einen Take aufnehmen</translation>
        </message>
        <message>
            <source>Live</source>
            <translation>Live</translation>
        </message>
        <message>
            <source>Show what is being captured instead of the take</source>
            <translation>Zeigt statt des Takes, was gerade aufgenommen wird</translation>
        </message>
        <message>
            <source>Look from this side (%1)</source>
            <translation>Von dieser Seite sehen (%1)</translation>
        </message>
        <message>
            <source>Front</source>
            <translation>Vorn</translation>
        </message>
        <message>
            <source>Shift+F</source>
            <translation>Umschalt+F</translation>
        </message>
        <message>
            <source>Side</source>
            <translation>Seite</translation>
        </message>
        <message>
            <source>Shift+S</source>
            <translation>Umschalt+S</translation>
        </message>
        <message>
            <source>Top</source>
            <translation>Oben</translation>
        </message>
        <message>
            <source>Shift+T</source>
            <translation>Umschalt+T</translation>
        </message>
        <message>
            <source>Frame the selection (F)</source>
            <translation>Auswahl ins Bild holen (F)</translation>
        </message>
        <message>
            <source>Show the floor</source>
            <translation>Boden zeigen</translation>
        </message>
        <message>
            <source>Show the sensors</source>
            <translation>Sensoren zeigen</translation>
        </message>
        <message>
            <source>Show the truth of this simulated take</source>
            <translation>Die Wahrheit dieses simulierten Takes zeigen</translation>
        </message>
        <message>
            <source>Live from %1</source>
            <translation>Live von %1</translation>
        </message>
        <message>
            <source>Live from %1, capture to screen %2 ms mean, %3 ms at most</source>
            <translation>Live von %1, vom Sensor zum Bildschirm %2 ms im Mittel, höchstens %3 ms</translation>
        </message>
        <message>
            <source>No take is open</source>
            <translation>Kein Take ist offen</translation>
        </message>
        <message>
            <source>Capture one, open one, or try a demo from the first page.</source>
            <translation>Nehmen Sie einen auf, öffnen Sie einen oder probieren Sie eine Demo von der Startseite.</translation>
        </message>
        <message>
            <source>This take could not be solved</source>
            <translation>Dieser Take ließ sich nicht berechnen</translation>
        </message>
        <message>
            <source>Try again</source>
            <translation>Noch einmal</translation>
        </message>
        <message>
            <source>Reading the solve…</source>
            <translation>Berechnung wird gelesen …</translation>
        </message>
        <message>
            <source>Solving…</source>
            <translation>Wird berechnet …</translation>
        </message>
        <message>
            <source>%1 of motion, %2 frames at %3 Hz, smoothing: %4</source>
            <translation>%1 Bewegung, %2 Bilder mit %3 Hz, Glättung: %4</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::SourceBar</name>
        <message>
            <source>Look for devices again</source>
            <translation>Erneut nach Geräten suchen</translation>
        </message>
        <message>
            <source>&amp;Device</source>
            <translation>&amp;Gerät</translation>
        </message>
        <message>
            <source>Device</source>
            <translation>Gerät</translation>
        </message>
        <message>
            <source>Where the signal comes from: a sound card&apos;s line input, or the simulator</source>
            <translation>Woher das Signal kommt: der Line-Eingang einer Soundkarte oder der Simulator</translation>
        </message>
        <message>
            <source>R&amp;ig</source>
            <translation>R&amp;ig</translation>
        </message>
        <message>
            <source>Rig</source>
            <translation>Rig</translation>
        </message>
        <message>
            <source>What is worn where</source>
            <translation>Was wo getragen wird</translation>
        </message>
        <message>
            <source>Looking for devices…</source>
            <translation>Sucht nach Geräten …</translation>
        </message>
        <message>
            <source>Choose a device</source>
            <translation>Wählen Sie ein Gerät</translation>
        </message>
        <message>
            <source>%1 (file %2)</source>
            <translation>%1 (Datei %2)</translation>
        </message>
        <message>
            <source>What is worn where: %1</source>
            <translation>Was wo getragen wird: %1</translation>
        </message>
        <message>
            <source>Stop recording to choose another rig</source>
            <translation>Die Aufnahme beenden, um ein anderes Rig zu wählen</translation>
        </message>
        <message>
            <source>Stop recording to choose another device</source>
            <translation>Die Aufnahme beenden, um ein anderes Gerät zu wählen</translation>
        </message>
        <message>
            <source>Format</source>
            <translation>Format</translation>
        </message>
        <message>
            <source>Sampling rate, sample format and inputs: %1</source>
            <translation>Abtastrate, Format und Eingänge: %1</translation>
        </message>
        <message>
            <source>Sampling rate, sample format and inputs</source>
            <translation>Abtastrate, Format und Eingänge</translation>
        </message>
        <message>
            <source>Stop recording to choose another format</source>
            <translation>Die Aufnahme beenden, um ein anderes Format zu wählen</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Sampling rate</source>
            <translation>Abtastrate</translation>
        </message>
        <message>
            <source>Sample format</source>
            <translation>Format der Abtastwerte</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Eingänge</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::SphereMap</name>
        <message>
            <source>Directions that were visited</source>
            <translation>Besuchte Richtungen</translation>
        </message>
        <message>
            <source>%1 of %2 directions</source>
            <translation>%1 von %2 Richtungen</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::StatusStrip</name>
        <message>
            <source>The open take: new, open, import, recent</source>
            <translation>Der offene Take: neu, öffnen, einlesen, letzte</translation>
        </message>
        <message>
            <source>Menu</source>
            <translation>Menü</translation>
        </message>
        <message>
            <source>No take</source>
            <translation>Kein Take</translation>
        </message>
        <message>
            <source>Take: %1</source>
            <translation>Take: %1</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::StretchModel</name>
        <message>
            <source>Reading the signals of %1</source>
            <translation>Die Signale von %1 werden gelesen</translation>
        </message>
        <message>
            <source>Reading was cancelled.</source>
            <translation>Das Lesen wurde abgebrochen.</translation>
        </message>
        <message>
            <source>Sensors are turned</source>
            <translation>Sensoren werden gedreht</translation>
        </message>
        <message>
            <source>Pose %1: %2</source>
            <translation>Pose %1: %2</translation>
        </message>
        <message>
            <source>Open a take first.</source>
            <translation>Zuerst einen Take öffnen.</translation>
        </message>
        <message>
            <source>The signals are still being read.</source>
            <translation>Die Signale werden noch gelesen.</translation>
        </message>
        <message>
            <source>Computing…</source>
            <translation>Wird berechnet…</translation>
        </message>
        <message>
            <source>&quot;%1&quot; holds no readings. Choose another stretch.</source>
            <translation>„%1“ enthält keine Messwerte. Einen anderen Abschnitt wählen.</translation>
        </message>
        <message>
            <source>The two poses overlap. Move them apart.</source>
            <translation>Die beiden Posen überschneiden sich. Auseinanderziehen.</translation>
        </message>
        <message>
            <source>Computing the range calibration</source>
            <translation>Der Messbereich wird berechnet</translation>
        </message>
        <message>
            <source>Computing the mounting</source>
            <translation>Der Sitz wird berechnet</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::StretchPage</name>
        <message>
            <source>Other take</source>
            <translation>Anderer Take</translation>
        </message>
        <message>
            <source>Show the verdict</source>
            <translation>Urteil zeigen</translation>
        </message>
        <message>
            <source>Calibrate from a recording</source>
            <translation>Aus einer Aufnahme kalibrieren</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <source>Esc</source>
            <translation>Esc</translation>
        </message>
        <message>
            <source>Take</source>
            <translation>Take</translation>
        </message>
        <message>
            <source>&amp;Movement</source>
            <translation>&amp;Bewegung</translation>
        </message>
        <message>
            <source>Movement</source>
            <translation>Bewegung</translation>
        </message>
        <message>
            <source>&amp;Shown sensor</source>
            <translation>&amp;Gezeigter Sensor</translation>
        </message>
        <message>
            <source>Shown sensor</source>
            <translation>Gezeigter Sensor</translation>
        </message>
        <message>
            <source> s</source>
            <translation> s</translation>
        </message>
        <message>
            <source>Begin</source>
            <translation>Anfang</translation>
        </message>
        <message>
            <source>End</source>
            <translation>Ende</translation>
        </message>
        <message>
            <source>Take what is visible</source>
            <translation>Sichtbares nehmen</translation>
        </message>
        <message>
            <source>from</source>
            <translation>von</translation>
        </message>
        <message>
            <source>to</source>
            <translation>bis</translation>
        </message>
        <message>
            <source>Browse…</source>
            <translation>Durchsuchen…</translation>
        </message>
        <message>
            <source>Choose a take</source>
            <translation>Einen Take wählen</translation>
        </message>
        <message>
            <source>none</source>
            <translation>keine</translation>
        </message>
        <message>
            <source>Range: sensors are turned</source>
            <translation>Messbereich: Sensoren werden gedreht</translation>
        </message>
        <message>
            <source>Mounting: two poses of %1</source>
            <translation>Sitz: zwei Posen, %1</translation>
        </message>
        <message>
            <source>Open a take: its signals appear here.</source>
            <translation>Einen Take öffnen: Seine Signale erscheinen hier.</translation>
        </message>
        <message>
            <source>Reading the signals…</source>
            <translation>Die Signale werden gelesen…</translation>
        </message>
        <message>
            <source>The same procedure as with a running capture. Nothing is saved before you have seen the verdict.</source>
            <translation>Dasselbe Verfahren wie bei laufender Aufnahme. Nichts wird gespeichert, bevor das Urteil zu sehen war.</translation>
        </message>
        <message>
            <source>Own choice</source>
            <translation>Eigene Wahl</translation>
        </message>
        <message>
            <source>The whole take</source>
            <translation>Der ganze Take</translation>
        </message>
        <message>
            <source>%1 s long</source>
            <translation>%1 s lang</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::StretchPlot</name>
        <message>
            <source>Accelerations of the take</source>
            <translation>Beschleunigungen des Takes</translation>
        </message>
        <message>
            <source>Drag a stretch or its ends. Wheel: zoom. Drag beside it: move. Double click: show all.</source>
            <translation>Einen Abschnitt oder seine Enden ziehen. Rad: Zoom. Daneben ziehen: verschieben. Doppelklick: alles zeigen.</translation>
        </message>
        <message>
            <source> s</source>
            <translation> s</translation>
        </message>
        <message>
            <source>%1 g</source>
            <translation>%1 g</translation>
        </message>
        <message>
            <source>x</source>
            <translation>x</translation>
        </message>
        <message>
            <source>y</source>
            <translation>y</translation>
        </message>
        <message>
            <source>z</source>
            <translation>z</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::StudioContext</name>
        <message>
            <source>%1 cannot be opened</source>
            <translation>%1 lässt sich nicht öffnen</translation>
        </message>
        <message>
            <source>The recording failed. %1</source>
            <translation>Die Aufnahme ist gescheitert. %1</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::TakeActions</name>
        <message>
            <source>Open a take (a folder that ends in .take)</source>
            <translation>Einen Take öffnen (ein Ordner, der auf .take endet)</translation>
        </message>
        <message>
            <source>Import recordings of a sound recorder</source>
            <translation>Aufnahmen eines Tonrekorders einlesen</translation>
        </message>
        <message>
            <source>Recordings (*.wav *.w64 *.rf64 *.flac *.aiff *.aif *.ogg *.mp3);;All files (*)</source>
            <translation>Aufnahmen (*.wav *.w64 *.rf64 *.flac *.aiff *.aif *.ogg *.mp3);;Alle Dateien (*)</translation>
        </message>
        <message>
            <source>A take is being recorded.</source>
            <translation>Ein Take wird aufgenommen.</translation>
        </message>
        <message>
            <source>Stop the recording before another take is opened.</source>
            <translation>Beenden Sie die Aufnahme, bevor ein anderer Take geöffnet wird.</translation>
        </message>
        <message>
            <source>Importing %1</source>
            <translation>%1 wird eingelesen</translation>
        </message>
        <message>
            <source>Making the demo take “%1”</source>
            <translation>Demo-Take „%1“ wird erzeugt</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::TakeDocument</name>
        <message>
            <source>Opening %1</source>
            <translation>%1 wird geöffnet</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::TimelineCanvas</name>
        <message>
            <source>Timeline</source>
            <translation>Zeitleiste</translation>
        </message>
        <message>
            <source>%1: %2° at %3 s</source>
            <translation>%1: %2° bei %3 s</translation>
        </message>
        <message>
            <source>%1 at %2 s</source>
            <translation>%1 bei %2 s</translation>
        </message>
        <message>
            <source>%1: double-click sets a key</source>
            <translation>%1: Doppelklick setzt einen Schlüssel</translation>
        </message>
        <message>
            <source>Events</source>
            <translation>Ereignisse</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::TimelineWidget</name>
        <message>
            <source>Go to the start</source>
            <translation>Zum Anfang</translation>
        </message>
        <message>
            <source>Home</source>
            <translation>Pos1</translation>
        </message>
        <message>
            <source>One frame back</source>
            <translation>Ein Bild zurück</translation>
        </message>
        <message>
            <source>Left</source>
            <translation>Links</translation>
        </message>
        <message>
            <source>Play</source>
            <translation>Abspielen</translation>
        </message>
        <message>
            <source>Space</source>
            <translation>Leertaste</translation>
        </message>
        <message>
            <source>One frame on</source>
            <translation>Ein Bild vor</translation>
        </message>
        <message>
            <source>Right</source>
            <translation>Rechts</translation>
        </message>
        <message>
            <source>Go to the end</source>
            <translation>Zum Ende</translation>
        </message>
        <message>
            <source>End</source>
            <translation>Ende</translation>
        </message>
        <message>
            <source>Loop</source>
            <translation>Schleife</translation>
        </message>
        <message>
            <source>Playing speed</source>
            <translation>Abspielgeschwindigkeit</translation>
        </message>
        <message>
            <source>%1×</source>
            <translation>%1×</translation>
        </message>
        <message>
            <source>Playhead</source>
            <translation>Abspielmarke</translation>
        </message>
        <message>
            <source>Set a key for the selected bone at the playhead</source>
            <translation>Schlüssel für den gewählten Knochen an der Abspielmarke setzen</translation>
        </message>
        <message>
            <source>I</source>
            <translation>I</translation>
        </message>
        <message>
            <source>Delete the selected keys</source>
            <translation>Die gewählten Schlüssel löschen</translation>
        </message>
        <message>
            <source>Del</source>
            <translation>Entf</translation>
        </message>
        <message>
            <source>Show the whole clip</source>
            <translation>Den ganzen Clip zeigen</translation>
        </message>
        <message>
            <source>Shift+Home</source>
            <translation>Umschalt+Pos1</translation>
        </message>
        <message>
            <source>%1 (Space)</source>
            <translation>%1 (Leertaste)</translation>
        </message>
        <message>
            <source>Pause</source>
            <translation>Anhalten</translation>
        </message>
        <message>
            <source>–</source>
            <translation>–</translation>
        </message>
        <message>
            <source>/ %1   frame %2 of %3</source>
            <translation>/ %1   Bild %2 von %3</translation>
        </message>
        <message>
            <source>nothing to play yet</source>
            <translation>noch nichts abzuspielen</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::TruthCard</name>
        <message>
            <source>Against the truth</source>
            <translation>Gegen die Wahrheit</translation>
        </message>
        <message>
            <source>Inclination error %1</source>
            <translation>Neigungsfehler %1</translation>
        </message>
        <message>
            <source>Bone</source>
            <translation>Knochen</translation>
        </message>
        <message>
            <source>mean</source>
            <translation>Mittel</translation>
        </message>
        <message>
            <source>max</source>
            <translation>Max.</translation>
        </message>
        <message>
            <source>position</source>
            <translation>Ort</translation>
        </message>
        <message>
            <source>%1°</source>
            <translation>%1°</translation>
        </message>
        <message>
            <source>%1 mm</source>
            <translation>%1 mm</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::VerdictRow</name>
        <message>
            <source>Repeat this sensor only</source>
            <translation>Nur diesen Sensor wiederholen</translation>
        </message>
        <message>
            <source>Discard</source>
            <translation>Verwerfen</translation>
        </message>
        <message>
            <source>Accepted</source>
            <translation>Angenommen</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>Annehmen</translation>
        </message>
        <message>
            <source>Needs a running capture</source>
            <translation>Braucht eine laufende Aufnahme</translation>
        </message>
        <message>
            <source>Discarded</source>
            <translation>Verworfen</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::ViewerWidget</name>
        <message>
            <source>Viewer</source>
            <translation>Ansicht</translation>
        </message>
        <message>
            <source>Shows the skeleton in three dimensions.</source>
            <translation>Zeigt das Skelett in drei Dimensionen.</translation>
        </message>
        <message>
            <source>&lt;p&gt;&lt;b&gt;No picture: this computer offers no OpenGL 3.2.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Everything else works: solve, edit keys and export as usual. To see the figure, install the graphics driver or Mesa (on Debian: libgl1-mesa-dri) and start again.&lt;/p&gt;</source>
            <translation>&lt;p&gt;&lt;b&gt;Kein Bild: Dieser Rechner bietet kein OpenGL 3.2.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Alles andere geht: Berechnen, bearbeiten und geben Sie aus wie gewohnt. Um die Figur zu sehen, installieren Sie den Grafiktreiber oder Mesa (unter Debian: libgl1-mesa-dri) und starten Sie neu.&lt;/p&gt;</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::WelcomePage</name>
        <message>
            <source>Records what low-cost sensors on a body feel and turns it into animation for Blender, Maya and game engines.</source>
            <translation>Nimmt auf, was preiswerte Sensoren am Körper spüren, und macht daraus Animation für Blender, Maya und Spiel-Engines.</translation>
        </message>
        <message>
            <source>New take</source>
            <translation>Neuer Take</translation>
        </message>
        <message>
            <source>Choose a device and record</source>
            <translation>Gerät wählen und aufnehmen</translation>
        </message>
        <message>
            <source>Import recording</source>
            <translation>Aufnahme einlesen</translation>
        </message>
        <message>
            <source>WAV, FLAC or MP3 files of a sound recorder that was worn</source>
            <translation>WAV-, FLAC- oder MP3-Dateien eines getragenen Tonrekorders</translation>
        </message>
        <message>
            <source>Open take</source>
            <translation>Take öffnen</translation>
        </message>
        <message>
            <source>A folder that ends in .take</source>
            <translation>Ein Ordner, der auf .take endet</translation>
        </message>
        <message>
            <source>or drop recordings and takes anywhere on this window</source>
            <translation>oder ziehen Sie Aufnahmen und Takes auf dieses Fenster</translation>
        </message>
        <message>
            <source>Recent takes</source>
            <translation>Letzte Takes</translation>
        </message>
        <message>
            <source>Try it without hardware</source>
            <translation>Ohne Hardware ausprobieren</translation>
        </message>
    </context>
    <context>
        <name>limbwave::ui::WizardFrame</name>
        <message>
            <source>Leave</source>
            <translation>Verlassen</translation>
        </message>
        <message>
            <source>Stay</source>
            <translation>Bleiben</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>Zurück</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <source>Esc</source>
            <translation>Esc</translation>
        </message>
        <message>
            <source>Enter</source>
            <translation>Eingabe</translation>
        </message>
    </context>
    <context>
        <name>main</name>
        <message>
            <source>Records wearable motion sensors and turns them into animation.</source>
            <translation>Nimmt am Körper getragene Bewegungssensoren auf und macht daraus Animation.</translation>
        </message>
        <message>
            <source>Open a demo take of the simulator.</source>
            <translation>Einen Demo-Take des Simulators öffnen.</translation>
        </message>
        <message>
            <source>Colours: dark or light.</source>
            <translation>Farben: dark (dunkel) oder light (hell).</translation>
        </message>
        <message>
            <source>Write pictures of the solved TAKE into this folder and end; needs no display.</source>
            <translation>Bilder des berechneten TAKE in diesen Ordner schreiben und enden; braucht keinen Bildschirm.</translation>
        </message>
        <message>
            <source>Take folder to open, or recordings to import.</source>
            <translation>Take-Ordner zum Öffnen oder Aufnahmen zum Einlesen.</translation>
        </message>
    </context>
</TS>
