<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>BoxHistoryWords</name>
    <message>
        <source>well</source>
        <translation>in Ordnung</translation>
    </message>
    <message>
        <source>no source in sight</source>
        <translation>keine Quelle in Sicht</translation>
    </message>
    <message>
        <source>no words</source>
        <translation>keine Worte</translation>
    </message>
    <message>
        <source>pulled out</source>
        <translation>herausgezogen</translation>
    </message>
    <message>
        <source>clips</source>
        <translation>übersteuert</translation>
    </message>
    <message>
        <source>something was lost</source>
        <translation>etwas ging verloren</translation>
    </message>
    <message>
        <source>nothing is known</source>
        <translation>nichts bekannt</translation>
    </message>
    <message>
        <source>%1 s lost on the line</source>
        <translation>%1 s auf der Strecke verloren</translation>
    </message>
    <message numerus="yes">
        <source>%n word(s) lost</source>
        <translation>
            <numerusform>%n Wort verloren</numerusform>
            <numerusform>%n Worte verloren</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 for %2 s</source>
        <translation>%1, %2 s lang</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 ranges a second</source>
        <translation>%1 Entfernungen je Sekunde</translation>
    </message>
    <message>
        <source>%1 at %2: %3</source>
        <translation>%1 bei %2: %3</translation>
    </message>
</context>
<context>
    <name>BoxWords</name>
    <message>
        <source>its wire is pulled out of the box</source>
        <translation>sein Kabel ist aus der Box gezogen</translation>
    </message>
    <message>
        <source>its signal is at full scale</source>
        <translation>sein Signal ist voll ausgesteuert</translation>
    </message>
    <message>
        <source>its words are not understood; check the wire and the board</source>
        <translation>seine Worte sind nicht zu verstehen; Kabel und Platine prüfen</translation>
    </message>
    <message>
        <source>it has fallen silent</source>
        <translation>er ist verstummt</translation>
    </message>
    <message>
        <source>it says the same for ever; switch the board off and on</source>
        <translation>er sagt immer dasselbe; die Platine aus- und einschalten</translation>
    </message>
    <message>
        <source>the box is away</source>
        <translation>die Box ist fort</translation>
    </message>
</context>
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
        <translation>Werte aus dem Datenblatt, bis zu 10 % daneben</translation>
    </message>
    <message>
        <source>taken to sit as the rig shows it</source>
        <translation>so angenommen, wie das Rig es zeigt</translation>
    </message>
    <message>
        <source>%1 mg</source>
        <translation>%1 mg</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1 nach oben</translation>
    </message>
    <message>
        <source>%1 and %2 up</source>
        <translation>%1 und %2 nach oben</translation>
    </message>
    <message>
        <source>corner %1 up</source>
        <translation>Ecke %1 nach oben</translation>
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
    <message>
        <source>no named person</source>
        <translation>einer Person ohne Namen</translation>
    </message>
    <message>
        <source>Range never calibrated.</source>
        <translation>Bereich nie kalibriert.</translation>
    </message>
    <message>
        <source>Range of all sensors, %1.</source>
        <translation>Bereich aller Sensoren, %1.</translation>
    </message>
    <message>
        <source>Range of %1 of %2 sensors, %3.</source>
        <translation>Bereich von %1 von %2 Sensoren, %3.</translation>
    </message>
    <message>
        <source>Mounting on %1 not calibrated.</source>
        <translation>Befestigung an %1 nicht kalibriert.</translation>
    </message>
    <message>
        <source>Mounting on %1, %2.</source>
        <translation>Befestigung an %1, %2.</translation>
    </message>
    <message>
        <source>Mounting on %1: %2 of %3 sensors, %4.</source>
        <translation>Befestigung an %1: %2 von %3 Sensoren, %4.</translation>
    </message>
    <message>
        <source>d MMM yyyy HH:mm</source>
        <translation>d. MMM yyyy HH:mm</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>pulled</source>
        <translation>herausgezogen</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>inverted</source>
        <translation>invertiert</translation>
    </message>
    <message>
        <source>louder</source>
        <translation>lauter</translation>
    </message>
    <message>
        <source>quieter</source>
        <translation>leiser</translation>
    </message>
    <message>
        <source>importing</source>
        <translation>wird importiert</translation>
    </message>
    <message>
        <source>preparing the motion</source>
        <translation>Bewegung wird vorbereitet</translation>
    </message>
    <message>
        <source>writing the truth</source>
        <translation>Wahrheit wird geschrieben</translation>
    </message>
    <message>
        <source>closing the take</source>
        <translation>Take wird geschlossen</translation>
    </message>
    <message>
        <source>decoding</source>
        <translation>wird dekodiert</translation>
    </message>
    <message>
        <source>calibrating</source>
        <translation>wird kalibriert</translation>
    </message>
    <message>
        <source>estimating</source>
        <translation>wird geschätzt</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>wird geschrieben</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>wird geprüft</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>eine Datei angeben</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>den Pfad prüfen</translation>
    </message>
    <message>
        <source>is too large (%1 bytes)</source>
        <translation>ist zu groß (%1 Bytes)</translation>
    </message>
    <message>
        <source>check that it is the right file</source>
        <translation>prüfen, ob es die richtige Datei ist</translation>
    </message>
    <message>
        <source>is too large</source>
        <translation>ist zu groß</translation>
    </message>
    <message>
        <source>reading failed half-way</source>
        <translation>das Lesen brach mittendrin ab</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>den Datenträger prüfen</translation>
    </message>
    <message>
        <source>check that the folder exists, that you may write there and that the disk has room</source>
        <translation>prüfen, ob es den Ordner gibt, ob Sie dort schreiben dürfen und ob auf dem Datenträger Platz ist</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>writing failed</source>
        <translation>das Schreiben schlug fehl</translation>
    </message>
    <message>
        <source>is nested deeper than %1 levels</source>
        <translation>ist tiefer als %1 Ebenen verschachtelt</translation>
    </message>
    <message>
        <source>is not valid JSON</source>
        <translation>ist kein gültiges JSON</translation>
    </message>
    <message>
        <source>correct it there</source>
        <translation>dort berichtigen</translation>
    </message>
    <message>
        <source>is not valid JSON: it holds a number that is too large</source>
        <translation>ist kein gültiges JSON: eine Zahl darin ist zu groß</translation>
    </message>
    <message>
        <source>top level</source>
        <translation>oberste Ebene</translation>
    </message>
    <message>
        <source>is not an object</source>
        <translation>ist kein Objekt</translation>
    </message>
    <message>
        <source>is not a known key</source>
        <translation>ist kein bekannter Schlüssel</translation>
    </message>
    <message>
        <source>known here: %1</source>
        <translation>hier bekannt: %1</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>is not a list</source>
        <translation>ist keine Liste</translation>
    </message>
    <message>
        <source>is not a number</source>
        <translation>ist keine Zahl</translation>
    </message>
    <message>
        <source>is %1, outside %2 to %3</source>
        <translation>ist %1, außerhalb von %2 bis %3</translation>
    </message>
    <message>
        <source>is not a whole number</source>
        <translation>ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>is not true or false</source>
        <translation>ist weder wahr noch falsch</translation>
    </message>
    <message>
        <source>is not a text</source>
        <translation>ist kein Text</translation>
    </message>
    <message>
        <source>has %1 values instead of %2</source>
        <translation>hat %1 Werte statt %2</translation>
    </message>
    <message>
        <source>give a WAV, W64, RF64, FLAC or AIFF file</source>
        <translation>eine Datei im Format WAV, W64, RF64, FLAC oder AIFF angeben</translation>
    </message>
    <message>
        <source>20-bit samples were stored in 24 bits, exactly</source>
        <translation>20-Bit-Abtastwerte wurden verlustfrei in 24 Bit abgelegt</translation>
    </message>
    <message>
        <source>64-bit float samples were rounded to 32-bit floats</source>
        <translation>64-Bit-Gleitkommawerte wurden auf 32 Bit gerundet</translation>
    </message>
    <message>
        <source>8-bit samples were stored in 16 bits, exactly; 8 bits are coarse: record 16 or more</source>
        <translation>8-Bit-Abtastwerte wurden verlustfrei in 16 Bit abgelegt; 8 Bit sind grob: mit 16 oder mehr aufnehmen</translation>
    </message>
    <message>
        <source>samples were decompressed to 32-bit floats</source>
        <translation>die Abtastwerte wurden in 32-Bit-Gleitkommawerte entpackt</translation>
    </message>
    <message>
        <source>samples were decompressed to 16 bits</source>
        <translation>die Abtastwerte wurden in 16 Bit entpackt</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>gibt es nicht</translation>
    </message>
    <message>
        <source>is a folder, not a recording</source>
        <translation>ist ein Ordner, keine Aufzeichnung</translation>
    </message>
    <message>
        <source>is not a file that can be read twice</source>
        <translation>ist keine Datei, die man zweimal lesen kann</translation>
    </message>
    <message>
        <source>is empty (0 bytes)</source>
        <translation>ist leer (0 Bytes)</translation>
    </message>
    <message>
        <source>copy it again from the recorder</source>
        <translation>noch einmal vom Rekorder kopieren</translation>
    </message>
    <message>
        <source>the header says that there are no channels</source>
        <translation>laut Dateikopf gibt es keine Kanäle</translation>
    </message>
    <message>
        <source>the recording has one channel</source>
        <translation>die Aufzeichnung hat einen Kanal</translation>
    </message>
    <message>
        <source>record in stereo</source>
        <translation>in Stereo aufnehmen</translation>
    </message>
    <message>
        <source>the recording has %1 channels</source>
        <translation>die Aufzeichnung hat %1 Kanäle</translation>
    </message>
    <message>
        <source>record %1 channels</source>
        <translation>%1 Kanäle aufnehmen</translation>
    </message>
    <message>
        <source>the header says %1 samples per second</source>
        <translation>der Dateikopf nennt %1 Abtastwerte pro Sekunde</translation>
    </message>
    <message>
        <source>record at 44100 to 192000; %1 to %2 can be read</source>
        <translation>mit 44100 bis 192000 aufnehmen; %1 bis %2 sind lesbar</translation>
    </message>
    <message>
        <source>the recorder never closed this file; it was read to its end</source>
        <translation>der Rekorder hat diese Datei nie geschlossen; sie wurde bis zum Ende gelesen</translation>
    </message>
    <message>
        <source>check its last second</source>
        <translation>die letzte Sekunde prüfen</translation>
    </message>
    <message>
        <source>the recording is cut off: its header promises %1, but %2 are there</source>
        <translation>die Aufzeichnung ist abgeschnitten: der Dateikopf verspricht %1, vorhanden sind %2</translation>
    </message>
    <message>
        <source>copy it again from the recorder if that has more</source>
        <translation>noch einmal vom Rekorder kopieren, falls dort mehr ist</translation>
    </message>
    <message>
        <source>the last %1 of %2 bytes are only part of a frame and were left out</source>
        <translation>die letzten %1 von %2 Bytes sind nur ein Teil eines Abtastzeitpunkts und wurden weggelassen</translation>
    </message>
    <message>
        <source>is not an audio file that can be read</source>
        <translation>ist keine lesbare Audiodatei</translation>
    </message>
    <message>
        <source>copy it again from the recorder, or export it as WAV</source>
        <translation>noch einmal vom Rekorder kopieren oder als WAV ausgeben</translation>
    </message>
    <message>
        <source>the recording has no samples</source>
        <translation>die Aufzeichnung hat keine Abtastwerte</translation>
    </message>
    <message>
        <source>check that the recorder was running</source>
        <translation>prüfen, ob der Rekorder lief</translation>
    </message>
    <message>
        <source>the recording was compressed with loss, which blurs the signal</source>
        <translation>die Aufzeichnung wurde verlustbehaftet komprimiert, das verwischt das Signal</translation>
    </message>
    <message>
        <source>set the recorder to WAV or FLAC</source>
        <translation>den Rekorder auf WAV oder FLAC stellen</translation>
    </message>
    <message>
        <source>the recording breaks off or is damaged after %1 s</source>
        <translation>die Aufzeichnung bricht nach %1 s ab oder ist dort beschädigt</translation>
    </message>
    <message>
        <source>the recording breaks off after %1 s</source>
        <translation>die Aufzeichnung bricht nach %1 s ab</translation>
    </message>
    <message>
        <source>%1 of %2 samples are not numbers</source>
        <translation>%1 von %2 Abtastwerten sind keine Zahlen</translation>
    </message>
    <message>
        <source>export it again from the audio program, as 16 or 24 bit</source>
        <translation>aus dem Audioprogramm neu ausgeben, mit 16 oder 24 Bit</translation>
    </message>
    <message>
        <source>raw samples are little-endian, as the program&apos;s own</source>
        <translation>Rohwerte sind little-endian wie die des Programms</translation>
    </message>
    <message>
        <source>sound cannot be used (%1)</source>
        <translation>der Ton kann nicht benutzt werden (%1)</translation>
    </message>
    <message>
        <source>sound card</source>
        <translation>Soundkarte</translation>
    </message>
    <message>
        <source>check that sound works in other programs</source>
        <translation>prüfen, ob andere Programme Ton haben</translation>
    </message>
    <message>
        <source>there is no sound card to capture from</source>
        <translation>es gibt keine Soundkarte zum Aufnehmen</translation>
    </message>
    <message>
        <source>connect one</source>
        <translation>eine anschließen</translation>
    </message>
    <message>
        <source>there is no such device</source>
        <translation>dieses Gerät gibt es nicht</translation>
    </message>
    <message>
        <source>connect it, or choose one that `limbwave devices` lists</source>
        <translation>anschließen oder eines wählen, das `limbwave devices` aufzählt</translation>
    </message>
    <message>
        <source>has %1 channels, not %2</source>
        <translation>hat %1 Kanäle, nicht %2</translation>
    </message>
    <message>
        <source>choose another device</source>
        <translation>ein anderes Gerät wählen</translation>
    </message>
    <message>
        <source>does not give %1 samples</source>
        <translation>liefert keine Abtastwerte vom Typ %1</translation>
    </message>
    <message>
        <source>it offers %1</source>
        <translation>angeboten wird: %1</translation>
    </message>
    <message>
        <source>does not run at %1 Hz</source>
        <translation>läuft nicht mit %1 Hz</translation>
    </message>
    <message>
        <source>cannot be opened (%1)</source>
        <translation>lässt sich nicht öffnen (%1)</translation>
    </message>
    <message>
        <source>check that no other program uses it</source>
        <translation>prüfen, ob ein anderes Programm das Gerät benutzt</translation>
    </message>
    <message>
        <source>does not start (%1)</source>
        <translation>startet nicht (%1)</translation>
    </message>
    <message>
        <source>check that it is still connected and that no other program uses it</source>
        <translation>prüfen, ob das Gerät noch angeschlossen ist und kein anderes Programm es benutzt</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>writing failed (%1)</source>
        <translation>das Schreiben schlug fehl (%1)</translation>
    </message>
    <message>
        <source>what was recorded until then is kept; make room, or record to another disk</source>
        <translation>was bis dahin aufgenommen wurde, bleibt; Platz schaffen oder auf einen anderen Datenträger aufnehmen</translation>
    </message>
    <message>
        <source>cannot hold this rate and number of channels</source>
        <translation>kann diese Rate und Kanalzahl nicht aufnehmen</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>ein anderes Format wählen</translation>
    </message>
    <message>
        <source>cannot be written (%1)</source>
        <translation>kann nicht geschrieben werden (%1)</translation>
    </message>
    <message>
        <source>check that the folder exists and that you may write there</source>
        <translation>prüfen, ob es den Ordner gibt und ob Sie dort schreiben dürfen</translation>
    </message>
    <message>
        <source>%1 times in all, %2 of them told; the last: %3</source>
        <translation>insgesamt %1-mal, davon %2 gemeldet; zuletzt: %3</translation>
    </message>
    <message>
        <source>%1 samples are not numbers</source>
        <translation>%1 Abtastwerte sind keine Zahlen</translation>
    </message>
    <message>
        <source>The file or device delivers broken data: record again or convert the file anew</source>
        <translation>Datei oder Gerät liefern fehlerhafte Daten: noch einmal aufnehmen oder die Datei neu umwandeln</translation>
    </message>
    <message>
        <source>the counter was lost for %1 ms (%2 cycles)</source>
        <translation>der Zähler war %1 ms lang verloren (%2 Zyklen)</translation>
    </message>
    <message>
        <source>the counter is gone (nothing for %1 ms)</source>
        <translation>der Zähler ist weg (seit %1 ms nichts)</translation>
    </message>
    <message>
        <source>Check the plug and the cable; if samples were dropped, close other programs or take a larger buffer</source>
        <translation>Stecker und Kabel prüfen; gingen Abtastwerte verloren, andere Programme schließen oder einen größeren Puffer nehmen</translation>
    </message>
    <message>
        <source>both channels are silent (left %1 dBFS, right %2 dBFS)</source>
        <translation>beide Kanäle sind still (links %1 dBFS, rechts %2 dBFS)</translation>
    </message>
    <message>
        <source>Switch the board on, plug it into the line-in socket, choose that input in the sound settings and turn its level up</source>
        <translation>Die Platine einschalten, in die Line-in-Buchse stecken, diesen Eingang in den Toneinstellungen wählen und den Pegel aufdrehen</translation>
    </message>
    <message>
        <source>both channels carry the same signal (correlation %1)</source>
        <translation>beide Kanäle führen dasselbe Signal (Korrelation %1)</translation>
    </message>
    <message>
        <source>Record in stereo, use a stereo cable and a line input: a microphone socket is often mono</source>
        <translation>In Stereo aufnehmen, ein Stereokabel und einen Line-Eingang benutzen: eine Mikrofonbuchse ist oft mono</translation>
    </message>
    <message>
        <source>the counter runs at %1 cycles per second, the rig allows %2 to %3</source>
        <translation>der Zähler läuft mit %1 Zyklen pro Sekunde, das Rig erlaubt %2 bis %3</translation>
    </message>
    <message>
        <source>Choose the rig that belongs to this board, or check that the sample rate is really what the file or device says</source>
        <translation>Das Rig wählen, das zu dieser Platine gehört, oder prüfen, ob die Abtastrate wirklich die ist, die Datei oder Gerät nennen</translation>
    </message>
    <message>
        <source>the %1 channel is silent (%2 dBFS) and there is no counter on the other one</source>
        <translation>der Kanal %1 ist still (%2 dBFS), und auf dem anderen ist kein Zähler</translation>
    </message>
    <message>
        <source>Use a stereo cable, push the plug in fully and record in stereo</source>
        <translation>Ein Stereokabel benutzen, den Stecker ganz hineinschieben und in Stereo aufnehmen</translation>
    </message>
    <message>
        <source>there is only %1 Hz mains hum, no counter on either channel</source>
        <translation>da ist nur Netzbrummen mit %1 Hz, auf keinem Kanal ein Zähler</translation>
    </message>
    <message>
        <source>Push the plug in fully, check the cable&apos;s ground and that the board is switched on</source>
        <translation>Den Stecker ganz hineinschieben, die Masse des Kabels prüfen und ob die Platine eingeschaltet ist</translation>
    </message>
    <message>
        <source>no counter of about %1 cycles per second on either channel (left %2 dBFS, right %3 dBFS)</source>
        <translation>auf keinem Kanal ein Zähler mit etwa %1 Zyklen pro Sekunde (links %2 dBFS, rechts %3 dBFS)</translation>
    </message>
    <message>
        <source>Choose the input that the board is plugged into, not a microphone or a player; switch effects such as noise reduction and automatic gain off</source>
        <translation>Den Eingang wählen, in dem die Platine steckt, nicht ein Mikrofon oder einen Spieler; Effekte wie Rauschunterdrückung und automatische Aussteuerung abschalten</translation>
    </message>
    <message>
        <source>only %1 whole cycles of the board were heard</source>
        <translation>nur %1 ganze Zyklen der Platine waren zu hören</translation>
    </message>
    <message>
        <source>Record at least a second</source>
        <translation>Mindestens eine Sekunde aufnehmen</translation>
    </message>
    <message>
        <source>the counter is there, but the %1 channel carries no sensor values (its slots differ by %2 % of the counter&apos;s swing)</source>
        <translation>der Zähler ist da, aber der Kanal %1 führt keine Sensorwerte (seine Zeitfächer unterscheiden sich um %2 % des Zählerhubs)</translation>
    </message>
    <message>
        <source>Check the cable&apos;s other channel and the balance control</source>
        <translation>Den anderen Kanal des Kabels und den Balanceregler prüfen</translation>
    </message>
    <message>
        <source>the reference slot does not stand out from the sensors (score %1 of 1), so polarity cannot be told; it is taken as %2</source>
        <translation>das Referenzfach hebt sich nicht von den Sensoren ab (%1 von 1), die Polung ist also nicht zu erkennen; angenommen wird: %2</translation>
    </message>
    <message>
        <source>not inverted</source>
        <translation>nicht invertiert</translation>
    </message>
    <message>
        <source>Check the reference voltage of the board against the rig, and that all sensors are plugged in</source>
        <translation>Die Referenzspannung der Platine mit dem Rig vergleichen und prüfen, ob alle Sensoren stecken</translation>
    </message>
    <message>
        <source>left and right are exchanged: the counter is on the left channel</source>
        <translation>links und rechts sind vertauscht: der Zähler liegt auf dem linken Kanal</translation>
    </message>
    <message>
        <source>Nothing is lost, they are exchanged back; exchange the plugs, or set this in the rig&apos;s line settings</source>
        <translation>Nichts ist verloren, sie werden zurückgetauscht; die Stecker tauschen oder es in den Leitungseinstellungen des Rigs festlegen</translation>
    </message>
    <message>
        <source>the %1 channel (sensors) is inverted by this sound card</source>
        <translation>der Kanal %1 (Sensoren) wird von dieser Soundkarte invertiert</translation>
    </message>
    <message>
        <source>Nothing to do: it is turned over again</source>
        <translation>Nichts zu tun: er wird wieder umgedreht</translation>
    </message>
    <message>
        <source>the %1 channel (counter) is inverted by this sound card</source>
        <translation>der Kanal %1 (Zähler) wird von dieser Soundkarte invertiert</translation>
    </message>
    <message>
        <source>the counter swings by only %1 % of full scale (%2 dBFS)</source>
        <translation>der Zähler schwingt nur um %1 % der Vollaussteuerung (%2 dBFS)</translation>
    </message>
    <message>
        <source>Turn the input level up until the counter reaches about two thirds of full scale</source>
        <translation>Den Eingangspegel aufdrehen, bis der Zähler etwa zwei Drittel der Vollaussteuerung erreicht</translation>
    </message>
    <message>
        <source>the %1 channel seems to be recorded at %2 times the gain of the other</source>
        <translation>der Kanal %1 ist anscheinend mit der %2-fachen Verstärkung des anderen aufgenommen</translation>
    </message>
    <message>
        <source>Set the balance to the middle and then leave it, or repeat the range calibration with this setting</source>
        <translation>Die Balance auf Mitte stellen und dann nicht mehr anfassen, oder die Bereichskalibrierung mit dieser Einstellung wiederholen</translation>
    </message>
    <message>
        <source>the signal is only %1 ms long</source>
        <translation>das Signal ist nur %1 ms lang</translation>
    </message>
    <message>
        <source>the reference slot</source>
        <translation>das Referenzfach</translation>
    </message>
    <message>
        <source>sensor %1 axis %2</source>
        <translation>Sensor %1 Achse %2</translation>
    </message>
    <message>
        <source>the sensor channel reaches full scale in %1 of %2 slots, first %3</source>
        <translation>der Sensorkanal erreicht in %1 von %2 Zeitfächern die Vollaussteuerung, zuerst: %3</translation>
    </message>
    <message>
        <source>Turn the input level down and record this part again</source>
        <translation>Den Eingangspegel herunterdrehen und diesen Teil noch einmal aufnehmen</translation>
    </message>
    <message>
        <source>the counter channel reaches full scale, so its swing is no measure of the gain; the last good scale is kept</source>
        <translation>der Zählerkanal erreicht die Vollaussteuerung, sein Hub ist also kein Maß der Verstärkung; die letzte gute wird beibehalten</translation>
    </message>
    <message>
        <source>Turn the input level down until the counter reaches about two thirds of full scale</source>
        <translation>Den Eingangspegel herunterdrehen, bis der Zähler etwa zwei Drittel der Vollaussteuerung erreicht</translation>
    </message>
    <message>
        <source>the reference level, which should stand still, moves by %1 % of the counter&apos;s swing: there is hum on the sensor channel</source>
        <translation>der Referenzpegel, der stillstehen sollte, bewegt sich um %1 % des Zählerhubs: auf dem Sensorkanal brummt es</translation>
    </message>
    <message>
        <source>Run the computer on its battery, keep the cable away from power supplies and use a shielded one</source>
        <translation>Den Rechner mit dem Akku betreiben, das Kabel von Netzteilen fernhalten und ein geschirmtes nehmen</translation>
    </message>
    <message>
        <source>the sensor channel changed by a factor of %1, the counter channel did not</source>
        <translation>der Sensorkanal änderte sich um den Faktor %1, der Zählerkanal nicht</translation>
    </message>
    <message>
        <source>Set the balance back to where it was, or repeat the range calibration</source>
        <translation>Die Balance dorthin zurückstellen, wo sie war, oder die Bereichskalibrierung wiederholen</translation>
    </message>
    <message>
        <source>the counter channel changed by a factor of %1, the sensor channel did not</source>
        <translation>der Zählerkanal änderte sich um den Faktor %1, der Sensorkanal nicht</translation>
    </message>
    <message>
        <source>the input level changed by a factor of %1; values are scaled back by the counter&apos;s swing</source>
        <translation>der Eingangspegel änderte sich um den Faktor %1; die Werte werden mit dem Zählerhub zurückgerechnet</translation>
    </message>
    <message>
        <source>Leave the volume knob alone while recording; check this part of the take</source>
        <translation>Den Lautstärkeregler während der Aufnahme nicht anfassen; diesen Teil des Takes prüfen</translation>
    </message>
    <message>
        <source>%1 slots reached full scale in all, in %2 stretches</source>
        <translation>insgesamt erreichten %1 Zeitfächer die Vollaussteuerung, in %2 Abschnitten</translation>
    </message>
    <message>
        <source>Turn the input level down and record again</source>
        <translation>Den Eingangspegel herunterdrehen und noch einmal aufnehmen</translation>
    </message>
    <message>
        <source>it is even and one more than three times the number of sensors: 4, 10, 16, 22 or 28</source>
        <translation>gerade und um eins größer als das Dreifache der Sensorzahl: 4, 10, 16, 22 oder 28</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no accelerometer of this rig</source>
        <translation>ist „%1“, das ist kein Beschleunigungssensor dieses Rigs</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is not perpendicular to that of the first pose</source>
        <translation>steht nicht senkrecht auf der ersten Pose</translation>
    </message>
    <message>
        <source>has %1 entries, but %2 slots carry %3 sensors</source>
        <translation>hat %1 Einträge, aber %2 Zeitfächer tragen %3 Sensoren</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no segment of skeleton &quot;%2&quot;</source>
        <translation>ist „%1“, das ist kein Segment des Skeletts „%2“</translation>
    </message>
    <message>
        <source>name one of its segments</source>
        <translation>eines seiner Segmente angeben</translation>
    </message>
    <message>
        <source>use fixed, hinge, universal or spherical</source>
        <translation>fixed, hinge, universal oder spherical verwenden</translation>
    </message>
    <message>
        <source>is nearly parallel to axis</source>
        <translation>ist fast parallel zu axis</translation>
    </message>
    <message>
        <source>a universal joint has two different axes</source>
        <translation>ein Kardangelenk hat zwei verschiedene Achsen</translation>
    </message>
    <message>
        <source>is larger than maximum_deg</source>
        <translation>ist größer als maximum_deg</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which another segment has already</source>
        <translation>ist „%1“, so heißt schon ein anderes Segment</translation>
    </message>
    <message>
        <source>has no parent</source>
        <translation>hat kein übergeordnetes Segment</translation>
    </message>
    <message>
        <source>only the first segment, the root, has none</source>
        <translation>nur das erste Segment, die Wurzel, hat keines</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which no earlier segment is</source>
        <translation>ist „%1“, so heißt kein früheres Segment</translation>
    </message>
    <message>
        <source>list parents before children</source>
        <translation>übergeordnete Segmente zuerst aufzählen</translation>
    </message>
    <message>
        <source>is longer than 10 m</source>
        <translation>ist länger als 10 m</translation>
    </message>
    <message>
        <source>lengths are in metres</source>
        <translation>Längen stehen in Metern</translation>
    </message>
    <message>
        <source>a skeleton has at least one segment</source>
        <translation>ein Skelett hat mindestens ein Segment</translation>
    </message>
    <message>
        <source>has more than 512 segments</source>
        <translation>hat mehr als 512 Segmente</translation>
    </message>
    <message>
        <source>is not a direction: its length is zero</source>
        <translation>ist keine Richtung: die Länge ist null</translation>
    </message>
    <message>
        <source>is not a rotation: a quaternion [w, x, y, z] has length 1</source>
        <translation>ist keine Drehung: ein Quaternion [w, x, y, z] hat die Länge 1</translation>
    </message>
    <message>
        <source>is larger than any sensor can have</source>
        <translation>ist größer, als es bei einem Sensor sein kann</translation>
    </message>
    <message>
        <source>calibrate the sensor again</source>
        <translation>den Sensor neu kalibrieren</translation>
    </message>
    <message>
        <source>does not have three rows</source>
        <translation>hat nicht drei Zeilen</translation>
    </message>
    <message>
        <source>is singular or mirrors the axes</source>
        <translation>ist singulär oder spiegelt die Achsen</translation>
    </message>
    <message>
        <source>is not a unit quaternion</source>
        <translation>ist kein Einheitsquaternion</translation>
    </message>
    <message>
        <source>four numbers, w first, with squares that add up to 1</source>
        <translation>vier Zahlen, w zuerst, deren Quadrate zusammen 1 ergeben</translation>
    </message>
    <message>
        <source>does not have one entry per sensor</source>
        <translation>hat nicht einen Eintrag pro Sensor</translation>
    </message>
    <message>
        <source>there are too few readings at rest to check the gain</source>
        <translation>es gibt zu wenige Messwerte in Ruhe, um die Verstärkung zu prüfen</translation>
    </message>
    <message>
        <source>hold still for two seconds</source>
        <translation>zwei Sekunden stillhalten</translation>
    </message>
    <message>
        <source>the readings do not depend on the gain</source>
        <translation>die Messwerte hängen nicht von der Verstärkung ab</translation>
    </message>
    <message>
        <source>check the sensors&apos; offsets</source>
        <translation>die Nullpunkte der Sensoren prüfen</translation>
    </message>
    <message>
        <source>the sensors do not read gravity with any gain</source>
        <translation>die Sensoren zeigen mit keiner Verstärkung die Erdbeschleunigung</translation>
    </message>
    <message>
        <source>calibrate their range again</source>
        <translation>ihren Bereich neu kalibrieren</translation>
    </message>
    <message>
        <source>the gain is uncertain by %1 %</source>
        <translation>die Verstärkung ist um %1 % unsicher</translation>
    </message>
    <message>
        <source>calibrate the sensors&apos; range, then hold still in several poses</source>
        <translation>den Bereich der Sensoren kalibrieren, dann in mehreren Posen stillhalten</translation>
    </message>
    <message>
        <source>the two directions of gravity are %1° apart, not about 90°</source>
        <translation>die beiden Richtungen der Schwerkraft liegen %1° auseinander, nicht etwa 90°</translation>
    </message>
    <message>
        <source>hold two poses a right angle apart</source>
        <translation>zwei Posen im rechten Winkel zueinander halten</translation>
    </message>
    <message>
        <source>%1: pose %2</source>
        <translation>%1: Pose %2</translation>
    </message>
    <message>
        <source>there is no whole %1 s without lost or clipped readings</source>
        <translation>es gibt keine ganzen %1 s ohne verlorene oder übersteuerte Messwerte</translation>
    </message>
    <message>
        <source>check the level and the plugs, then hold the pose again</source>
        <translation>Pegel und Stecker prüfen, dann die Pose noch einmal halten</translation>
    </message>
    <message>
        <source>it was never held still: the stillest second still moved by %1 mg</source>
        <translation>sie wurde nie stillgehalten: auch die ruhigste Sekunde bewegte sich noch um %1 mg</translation>
    </message>
    <message>
        <source>hold the pose without moving for two seconds</source>
        <translation>die Pose zwei Sekunden lang halten, ohne sich zu bewegen</translation>
    </message>
    <message>
        <source>hold first &quot;%1&quot;, then &quot;%2&quot;</source>
        <translation>zuerst „%1“ halten, dann „%2“</translation>
    </message>
    <message>
        <source>both poses are the same: gravity turned by only %1° between them</source>
        <translation>beide Posen sind gleich: die Schwerkraft drehte sich zwischen ihnen nur um %1°</translation>
    </message>
    <message>
        <source>the poses are opposite: gravity turned by %1° instead of 90°</source>
        <translation>die Posen sind entgegengesetzt: die Schwerkraft drehte sich um %1° statt um 90°</translation>
    </message>
    <message>
        <source>the poses were held in the wrong order</source>
        <translation>die Posen wurden in der falschen Reihenfolge gehalten</translation>
    </message>
    <message>
        <source>two poses</source>
        <translation>zwei Posen</translation>
    </message>
    <message>
        <source>repeat: this sensor&apos;s gravity turned by %1° between the poses, not by 90°</source>
        <translation>wiederholen: die Schwerkraft dieses Sensors drehte sich zwischen den Posen um %1°, nicht um 90°</translation>
    </message>
    <message>
        <source>%1: poses %2° apart (%3° off), held within %4 mg</source>
        <translation>%1: Posen %2° auseinander (%3° daneben), auf %4 mg ruhig gehalten</translation>
    </message>
    <message>
        <source>; each direction may be %1° off: hold the poses more exactly</source>
        <translation>; jede Richtung kann um %1° falsch sein: die Posen genauer halten</translation>
    </message>
    <message>
        <source>; it moved while it was held</source>
        <translation>; er bewegte sich, während er gehalten wurde</translation>
    </message>
    <message>
        <source>; it reads %1 g at rest: calibrate its range, or the volume was moved</source>
        <translation>; in Ruhe zeigt er %1 g: den Bereich kalibrieren, oder die Lautstärke wurde verstellt</translation>
    </message>
    <message>
        <source>sits %1° away from how the rig shows it</source>
        <translation>sitzt um %1° anders, als es das Rig zeigt</translation>
    </message>
    <message>
        <source>if it is not mounted that way on purpose, two of its axes may be swapped or its slot may be another&apos;s</source>
        <translation>wenn der Sensor nicht absichtlich so sitzt, sind vielleicht zwei Achsen vertauscht, oder sein Zeitfach gehört einem anderen</translation>
    </message>
    <message>
        <source>no usable signal: check the plug and the level</source>
        <translation>kein brauchbares Signal: Stecker und Pegel prüfen</translation>
    </message>
    <message>
        <source>turn it more slowly</source>
        <translation>langsamer drehen</translation>
    </message>
    <message>
        <source>move it smoothly, without jerks</source>
        <translation>gleichmäßig bewegen, ohne Rucke</translation>
    </message>
    <message>
        <source>enough: every direction was seen</source>
        <translation>genug: jede Richtung war dabei</translation>
    </message>
    <message>
        <source>turn it until %1</source>
        <translation>drehen, bis %1</translation>
    </message>
    <message>
        <source>sensor %1</source>
        <translation>Sensor %1</translation>
    </message>
    <message>
        <source>there are no readings</source>
        <translation>es gibt keine Messwerte</translation>
    </message>
    <message>
        <source>record the sensor while turning it slowly about all its axes</source>
        <translation>den Sensor aufnehmen, während man ihn langsam um alle Achsen dreht</translation>
    </message>
    <message>
        <source>the signal was clipped or lost in %1 % of the time</source>
        <translation>das Signal war %1 % der Zeit übersteuert oder verloren</translation>
    </message>
    <message>
        <source>lower the recording level until nothing clips, check the plug, and repeat</source>
        <translation>den Aufnahmepegel senken, bis nichts mehr übersteuert, den Stecker prüfen und wiederholen</translation>
    </message>
    <message>
        <source>%1 % of the readings were clipped or lost</source>
        <translation>%1 % der Messwerte waren übersteuert oder verloren</translation>
    </message>
    <message>
        <source>lower the recording level</source>
        <translation>den Aufnahmepegel senken</translation>
    </message>
    <message>
        <source>the sensor reached its range of %1 g in %2 % of the readings</source>
        <translation>der Sensor erreichte bei %2 % der Messwerte seinen Bereich von %1 g</translation>
    </message>
    <message>
        <source>turn it more gently</source>
        <translation>sanfter drehen</translation>
    </message>
    <message>
        <source>the sensor was steady for only %1 s; %2 s are needed</source>
        <translation>der Sensor war nur %1 s lang ruhig; %2 s sind nötig</translation>
    </message>
    <message>
        <source>turn it slowly, about ten seconds per full turn, without jerks</source>
        <translation>langsam drehen, etwa zehn Sekunden pro Umdrehung, ohne Rucke</translation>
    </message>
    <message>
        <source>axis %1 is stuck: it moved by only %2 g while the others turned</source>
        <translation>Achse %1 hängt fest: sie bewegte sich nur um %2 g, während die anderen sich drehten</translation>
    </message>
    <message>
        <source>check this axis&apos;s wire and solder joint</source>
        <translation>Leitung und Lötstelle dieser Achse prüfen</translation>
    </message>
    <message>
        <source>axes %1 and %2 show the same signal</source>
        <translation>die Achsen %1 und %2 zeigen dasselbe Signal</translation>
    </message>
    <message>
        <source>check the wiring of these two axes for a short circuit or a doubled slot</source>
        <translation>die Verdrahtung dieser beiden Achsen auf einen Kurzschluss oder ein doppeltes Zeitfach prüfen</translation>
    </message>
    <message>
        <source>axis %1 stops at %2 g: its signal is clipped</source>
        <translation>Achse %1 bleibt bei %2 g stehen: ihr Signal ist übersteuert</translation>
    </message>
    <message>
        <source>lower the recording level, or check the sensor&apos;s supply</source>
        <translation>den Aufnahmepegel senken oder die Versorgung des Sensors prüfen</translation>
    </message>
    <message>
        <source>the volume was moved by %1 % about %2 s after the start</source>
        <translation>die Lautstärke wurde etwa %2 s nach Beginn um %1 % verstellt</translation>
    </message>
    <message>
        <source>leave the volume and the balance alone and repeat</source>
        <translation>Lautstärke und Balance nicht anfassen und wiederholen</translation>
    </message>
    <message>
        <source>only %1 % of all directions were covered; %2 % are needed</source>
        <translation>nur %1 % aller Richtungen waren dabei; %2 % sind nötig</translation>
    </message>
    <message>
        <source>go on turning it slowly, for example until %1</source>
        <translation>langsam weiterdrehen, zum Beispiel bis %1</translation>
    </message>
    <message>
        <source>the readings do not form an ellipsoid</source>
        <translation>die Messwerte bilden kein Ellipsoid</translation>
    </message>
    <message>
        <source>turn it slowly about all its axes, through all directions</source>
        <translation>langsam um alle Achsen drehen, durch alle Richtungen</translation>
    </message>
    <message>
        <source>%1 % of all directions were covered, the largest hole is %2° wide</source>
        <translation>%1 % aller Richtungen waren dabei, die größte Lücke ist %2° weit</translation>
    </message>
    <message>
        <source>the readings are too few to be checked against each other</source>
        <translation>es sind zu wenige Messwerte, um sie aneinander zu prüfen</translation>
    </message>
    <message>
        <source>turn it for longer, a minute or so</source>
        <translation>länger drehen, etwa eine Minute</translation>
    </message>
    <message>
        <source>offset %1 g and scale %2 to %3 are not those of this sensor</source>
        <translation>Nullpunkt %1 g und Empfindlichkeit %2 bis %3 sind nicht die dieses Sensors</translation>
    </message>
    <message>
        <source>check the rig&apos;s sensitivity and zero, the volume and the balance</source>
        <translation>Empfindlichkeit und Nullpunkt des Rigs, Lautstärke und Balance prüfen</translation>
    </message>
    <message>
        <source>%1: %2 mg left over (%3; extremes %4 mg, ellipsoid %5 mg), %6 % of all directions covered</source>
        <translation>%1: %2 mg bleiben übrig (%3; Extremwerte %4 mg, Ellipsoid %5 mg), %6 % aller Richtungen waren dabei</translation>
    </message>
    <message>
        <source>; turn it more slowly and without jerks, and hold it at the box, not at the cable</source>
        <translation>; langsamer und ohne Rucke drehen, und am Gehäuse halten, nicht am Kabel</translation>
    </message>
    <message>
        <source>the corner of %1, %2 and %3 up</source>
        <translation>die Ecke aus %1, %2 und %3 oben ist</translation>
    </message>
    <message>
        <source>between %1 and %2 up</source>
        <translation>es zwischen %1 und %2 nach oben zeigt</translation>
    </message>
    <message>
        <source>cannot be made (%1)</source>
        <translation>kann nicht angelegt werden (%1)</translation>
    </message>
    <message>
        <source>check that you may write there</source>
        <translation>prüfen, ob Sie dort schreiben dürfen</translation>
    </message>
    <message>
        <source>cannot be listed (%1)</source>
        <translation>kann nicht aufgelistet werden (%1)</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>die Zugriffsrechte prüfen</translation>
    </message>
    <message>
        <source>put back a copy, or delete it and calibrate again</source>
        <translation>eine Kopie zurücklegen, oder die Datei löschen und neu kalibrieren</translation>
    </message>
    <message>
        <source>there is no limb calibration to keep</source>
        <translation>es gibt keine Gliedmaßenkalibrierung, die zu behalten wäre</translation>
    </message>
    <message>
        <source>calibrate at least one sensor</source>
        <translation>mindestens einen Sensor kalibrieren</translation>
    </message>
    <message>
        <source>%1: no range calibration</source>
        <translation>%1: keine Bereichskalibrierung</translation>
    </message>
    <message>
        <source>%1: no limb calibration</source>
        <translation>%1: keine Gliedmaßenkalibrierung</translation>
    </message>
    <message>
        <source>no named subject</source>
        <translation>niemandem mit Namen</translation>
    </message>
    <message>
        <source>is not in the calibration library</source>
        <translation>ist nicht in der Kalibrierungsbibliothek</translation>
    </message>
    <message>
        <source>name a file that the library lists</source>
        <translation>eine Datei angeben, die die Bibliothek aufzählt</translation>
    </message>
    <message>
        <source>%1 channels at %2 Hz, %3</source>
        <translation>%1 Kanäle mit %2 Hz, %3</translation>
    </message>
    <message>
        <source>export the two that carry the signal as a stereo file</source>
        <translation>die beiden, die das Signal tragen, als Stereodatei ausgeben</translation>
    </message>
    <message>
        <source>has %1, but %2 has %3</source>
        <translation>hat %1, aber %2 hat %3</translation>
    </message>
    <message>
        <source>parts of one recording have the same format; import others into their own takes</source>
        <translation>Teile einer Aufzeichnung haben dasselbe Format; andere in eigene Takes importieren</translation>
    </message>
    <message>
        <source>there is no recording to import</source>
        <translation>es gibt keine Aufzeichnung zum Importieren</translation>
    </message>
    <message>
        <source>name at least one file</source>
        <translation>mindestens eine Datei angeben</translation>
    </message>
    <message>
        <source>exists already</source>
        <translation>gibt es schon</translation>
    </message>
    <message>
        <source>choose another name, or move it away</source>
        <translation>einen anderen Namen wählen oder das Vorhandene verschieben</translation>
    </message>
    <message>
        <source>recording stopped because the disk is nearly full (%1 MB left)</source>
        <translation>die Aufnahme endete, weil der Datenträger fast voll ist (noch %1 MB)</translation>
    </message>
    <message>
        <source>everything up to here is kept; make room, or record to another disk</source>
        <translation>alles bis hierher bleibt; Platz schaffen oder auf einen anderen Datenträger aufnehmen</translation>
    </message>
    <message>
        <source>cannot be recorded to: the disk is nearly full (%1 MB left)</source>
        <translation>dorthin kann nicht aufgenommen werden: der Datenträger ist fast voll (noch %1 MB)</translation>
    </message>
    <message>
        <source>make room, or record to another disk</source>
        <translation>Platz schaffen oder auf einen anderen Datenträger aufnehmen</translation>
    </message>
    <message>
        <source>check that the folder above it exists and that you may write there</source>
        <translation>prüfen, ob es den Ordner darüber gibt und ob Sie dort schreiben dürfen</translation>
    </message>
    <message>
        <source>the recording is closed</source>
        <translation>die Aufnahme ist abgeschlossen</translation>
    </message>
    <message>
        <source>the samples of this take are lost unless you have a copy of that file</source>
        <translation>die Abtastwerte dieses Takes sind verloren, wenn Sie keine Kopie dieser Datei haben</translation>
    </message>
    <message>
        <source>holds %1 channels at %2 Hz with %3 bytes per frame, but take.json says %4 at %5 Hz with %6</source>
        <translation>enthält %1 Kanäle mit %2 Hz und %3 Bytes pro Abtastzeitpunkt, aber take.json nennt %4 mit %5 Hz und %6</translation>
    </message>
    <message>
        <source>put back the file that belongs to this take</source>
        <translation>die Datei zurücklegen, die zu diesem Take gehört</translation>
    </message>
    <message>
        <source>is not a take: there is no take.json in it</source>
        <translation>ist kein Take: es ist kein take.json darin</translation>
    </message>
    <message>
        <source>name the folder of a take, or make one with `limbwave record` or `limbwave import`</source>
        <translation>den Ordner eines Takes angeben, oder mit `limbwave record` oder `limbwave import` einen machen</translation>
    </message>
    <message>
        <source>is missing; the samples are there, and the rig is taken to be &quot;%1&quot;</source>
        <translation>fehlt; die Abtastwerte sind da, und als Rig wird „%1“ angenommen</translation>
    </message>
    <message>
        <source>put it back, or run `limbwave recover`</source>
        <translation>zurücklegen oder `limbwave recover` ausführen</translation>
    </message>
    <message>
        <source>the last event was cut off</source>
        <translation>das letzte Ereignis war abgeschnitten</translation>
    </message>
    <message>
        <source>is being recorded right now</source>
        <translation>wird gerade aufgenommen</translation>
    </message>
    <message>
        <source>the recording was not closed properly; %1 s are there</source>
        <translation>die Aufnahme wurde nicht ordentlich abgeschlossen; %1 s sind da</translation>
    </message>
    <message>
        <source>run `limbwave recover` to repair it; nothing is lost by that</source>
        <translation>mit `limbwave recover` reparieren; dabei geht nichts verloren</translation>
    </message>
    <message>
        <source>holds %1 s, but %2 s were recorded</source>
        <translation>enthält %1 s, aufgenommen wurden aber %2 s</translation>
    </message>
    <message>
        <source>copy the take again</source>
        <translation>den Take noch einmal kopieren</translation>
    </message>
    <message>
        <source>the header is damaged</source>
        <translation>der Dateikopf ist beschädigt</translation>
    </message>
    <message>
        <source>run `limbwave recover` to repair it</source>
        <translation>mit `limbwave recover` reparieren</translation>
    </message>
    <message>
        <source>is a file, not the folder of a take</source>
        <translation>ist eine Datei, nicht der Ordner eines Takes</translation>
    </message>
    <message>
        <source>make a take of a recording with `limbwave import`</source>
        <translation>mit `limbwave import` aus einer Aufzeichnung einen Take machen</translation>
    </message>
    <message>
        <source>the event could not be written (%1)</source>
        <translation>das Ereignis konnte nicht geschrieben werden (%1)</translation>
    </message>
    <message>
        <source>check that the disk has room</source>
        <translation>prüfen, ob auf dem Datenträger Platz ist</translation>
    </message>
    <message>
        <source>the header says %1 frames, but the take has %2</source>
        <translation>der Dateikopf nennt %1 Abtastzeitpunkte, der Take hat aber %2</translation>
    </message>
    <message>
        <source>%1 bytes follow the last frame of the take</source>
        <translation>nach dem letzten Abtastzeitpunkt des Takes folgen %1 Bytes</translation>
    </message>
    <message>
        <source>segment &quot;%1&quot; reaches beyond the end of the take</source>
        <translation>Abschnitt „%1“ reicht über das Ende des Takes hinaus</translation>
    </message>
    <message>
        <source>shorten it there</source>
        <translation>dort kürzen</translation>
    </message>
    <message>
        <source>%1 events lie beyond the end of the take</source>
        <translation>%1 Ereignisse liegen hinter dem Ende des Takes</translation>
    </message>
    <message>
        <source>the rig is worn by skeleton &quot;%1&quot;, but the snapshot is of &quot;%2&quot;</source>
        <translation>das Rig wird vom Skelett „%1“ getragen, die Momentaufnahme ist aber von „%2“</translation>
    </message>
    <message>
        <source>sensor &quot;%1&quot; sits on &quot;%2&quot;, which is no segment of the skeleton</source>
        <translation>Sensor „%1“ sitzt auf „%2“, das ist kein Segment des Skeletts</translation>
    </message>
    <message>
        <source>the calibration is of %1 sensors with %2 mounts, but the rig has %3</source>
        <translation>die Kalibrierung ist von %1 Sensoren mit %2 Befestigungen, das Rig hat aber %3</translation>
    </message>
    <message>
        <source>calibrate again</source>
        <translation>neu kalibrieren</translation>
    </message>
    <message>
        <source>record again; they count as loss of signal</source>
        <translation>noch einmal aufnehmen; sie zählen als Signalverlust</translation>
    </message>
    <message>
        <source>make it again: solve or simulate the take again</source>
        <translation>neu machen: den Take noch einmal berechnen oder simulieren</translation>
    </message>
    <message>
        <source>check that you may write there and that the disk has room</source>
        <translation>prüfen, ob Sie dort schreiben dürfen und ob auf dem Datenträger Platz ist</translation>
    </message>
    <message>
        <source>was not written by Limbwave, so that its header is left alone</source>
        <translation>wurde nicht von Limbwave geschrieben, der Dateikopf bleibt deshalb unverändert</translation>
    </message>
    <message>
        <source>import the file into a new take</source>
        <translation>die Datei in einen neuen Take importieren</translation>
    </message>
    <message>
        <source>the last event had been cut off and was removed</source>
        <translation>das letzte Ereignis war abgeschnitten und wurde entfernt</translation>
    </message>
    <message>
        <source>run `limbwave recover` to make an empty one</source>
        <translation>mit `limbwave recover` eine leere anlegen</translation>
    </message>
    <message>
        <source>stop the recording first</source>
        <translation>zuerst die Aufnahme beenden</translation>
    </message>
    <message>
        <source>the header now says %1 frames instead of %2</source>
        <translation>der Dateikopf nennt jetzt %1 Abtastzeitpunkte statt %2</translation>
    </message>
    <message>
        <source>the take is closed with %1 s</source>
        <translation>der Take ist mit %1 s abgeschlossen</translation>
    </message>
    <message>
        <source>take.json was made again: the rig is taken to be &quot;%1&quot;</source>
        <translation>take.json wurde neu gemacht: als Rig wird „%1“ angenommen</translation>
    </message>
    <message>
        <source>correct it there when another one was worn</source>
        <translation>dort berichtigen, wenn ein anderes getragen wurde</translation>
    </message>
    <message>
        <source>is not a known sample type</source>
        <translation>ist kein bekannter Abtasttyp</translation>
    </message>
    <message>
        <source>int16, int24, int32 or float32</source>
        <translation>int16, int24, int32 oder float32</translation>
    </message>
    <message>
        <source>was written by a newer version of Limbwave</source>
        <translation>wurde von einer neueren Version von Limbwave geschrieben</translation>
    </message>
    <message>
        <source>open it with that version</source>
        <translation>mit jener Version öffnen</translation>
    </message>
    <message>
        <source>%1: /rig</source>
        <translation>%1: /rig</translation>
    </message>
    <message>
        <source>%1: /skeleton</source>
        <translation>%1: /skeleton</translation>
    </message>
    <message>
        <source>%1: /calibration</source>
        <translation>%1: /calibration</translation>
    </message>
    <message>
        <source>reading failed (%1)</source>
        <translation>das Lesen schlug fehl (%1)</translation>
    </message>
    <message>
        <source>became shorter meanwhile</source>
        <translation>wurde inzwischen kürzer</translation>
    </message>
    <message>
        <source>is too short to find the multiplexer&apos;s clock in it</source>
        <translation>ist zu kurz, um darin den Takt des Multiplexers zu finden</translation>
    </message>
    <message>
        <source>record at least a second</source>
        <translation>mindestens eine Sekunde aufnehmen</translation>
    </message>
    <message>
        <source>has %1 channels, but the line-in path needs two</source>
        <translation>hat %1 Kanäle, der Line-in-Weg braucht aber zwei</translation>
    </message>
    <message>
        <source>is being recorded already</source>
        <translation>wird schon aufgenommen</translation>
    </message>
    <message>
        <source>stop that recording first</source>
        <translation>zuerst jene Aufnahme beenden</translation>
    </message>
    <message>
        <source>nothing is being recorded</source>
        <translation>es wird nichts aufgenommen</translation>
    </message>
    <message>
        <source>start a recording first</source>
        <translation>zuerst eine Aufnahme beginnen</translation>
    </message>
    <message>
        <source>%1 has stopped giving samples</source>
        <translation>%1 liefert keine Abtastwerte mehr</translation>
    </message>
    <message>
        <source>check the cable and the sound server, then choose the device again</source>
        <translation>Kabel und Soundserver prüfen, dann das Gerät noch einmal wählen</translation>
    </message>
    <message>
        <source>%1 samples were lost</source>
        <translation>%1 Abtastwerte gingen verloren</translation>
    </message>
    <message>
        <source>samples were lost, the device does not say how many</source>
        <translation>Abtastwerte gingen verloren, das Gerät sagt nicht, wie viele</translation>
    </message>
    <message>
        <source>close programs that keep the computer busy, or choose a larger buffer of the sound card</source>
        <translation>Programme schließen, die den Rechner beschäftigen, oder einen größeren Puffer der Soundkarte wählen</translation>
    </message>
    <message>
        <source>use auto, normal or inverted</source>
        <translation>auto, normal oder inverted verwenden</translation>
    </message>
    <message>
        <source>is not later than the key before</source>
        <translation>liegt nicht später als der Schlüssel davor</translation>
    </message>
    <message>
        <source>%1 s solved in %2 s (decoding %3 s, estimating %4 s)</source>
        <translation>%1 s in %2 s berechnet (Dekodieren %3 s, Schätzen %4 s)</translation>
    </message>
    <message>
        <source>calibration: %1</source>
        <translation>Kalibrierung: %1</translation>
    </message>
    <message>
        <source>line: %1 cycles/s, jitter %2 %, coupling %3 ± %4 Hz, noise %5 dB, %6 cycles, %7 lost</source>
        <translation>Leitung: %1 Zyklen/s, Schwankung %2 %, Kopplung %3 ± %4 Hz, Rauschen %5 dB, %6 Zyklen, %7 verloren</translation>
    </message>
    <message>
        <source>no readings yet</source>
        <translation>noch keine Messwerte</translation>
    </message>
    <message>
        <source>only %1 % of the readings can be used; lower the level if it clips, else check the cable</source>
        <translation>nur %1 % der Messwerte sind brauchbar; den Pegel senken, wenn es übersteuert, sonst das Kabel prüfen</translation>
    </message>
    <message>
        <source>reads nothing; check that the sensor is plugged in</source>
        <translation>zeigt nichts; prüfen, ob der Sensor eingesteckt ist</translation>
    </message>
    <message>
        <source>reads %1 g, more than the sensor can; check its cable and supply</source>
        <translation>zeigt %1 g, mehr als der Sensor kann; Kabel und Versorgung prüfen</translation>
    </message>
    <message>
        <source>reads %1 g at rest instead of 1 g; %2</source>
        <translation>zeigt in Ruhe %1 g statt 1 g; %2</translation>
    </message>
    <message>
        <source>repeat its range calibration</source>
        <translation>die Bereichskalibrierung wiederholen</translation>
    </message>
    <message>
        <source>reaches its limit of %1 g; move less abruptly</source>
        <translation>erreicht die Grenze von %1 g; weniger ruckartig bewegen</translation>
    </message>
    <message>
        <source>%1 % of the readings are lost</source>
        <translation>%1 % der Messwerte sind verloren</translation>
    </message>
    <message>
        <source>works, but was never calibrated; calibrate its range</source>
        <translation>geht, wurde aber nie kalibriert; den Bereich kalibrieren</translation>
    </message>
    <message>
        <source>the line is %1 ± %2 % %3 than on the day of calibration; gravity at rest showed it and it was corrected</source>
        <translation>die Leitung ist %1 ± %2 % %3 als am Tag der Kalibrierung; die Schwerkraft in Ruhe zeigte es, und es wurde ausgeglichen</translation>
    </message>
    <message>
        <source>has no decoded reading within its capture</source>
        <translation>hat im aufgenommenen Teil keinen dekodierten Messwert</translation>
    </message>
    <message>
        <source>check the events of the take: limbwave info TAKE</source>
        <translation>die Ereignisse des Takes ansehen: limbwave info TAKE</translation>
    </message>
    <message>
        <source>cannot be the name of a solve</source>
        <translation>kann nicht der Name einer Berechnung sein</translation>
    </message>
    <message>
        <source>use letters, digits, spaces and dashes</source>
        <translation>Buchstaben, Ziffern, Leerzeichen und Striche verwenden</translation>
    </message>
    <message>
        <source>check that you may write into the take</source>
        <translation>prüfen, ob Sie in den Take schreiben dürfen</translation>
    </message>
    <message>
        <source>has no solve &quot;%1&quot;</source>
        <translation>hat keine Berechnung „%1“</translation>
    </message>
    <message>
        <source>solve it first: limbwave solve TAKE</source>
        <translation>zuerst berechnen: limbwave solve TAKE</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>ist beschädigt</translation>
    </message>
    <message>
        <source>solve the take again</source>
        <translation>den Take noch einmal berechnen</translation>
    </message>
    <message>
        <source>range calibration failed: %1</source>
        <translation>die Bereichskalibrierung schlug fehl: %1</translation>
    </message>
    <message>
        <source>limb calibration failed: %1</source>
        <translation>die Gliedmaßenkalibrierung schlug fehl: %1</translation>
    </message>
    <message>
        <source>from the take&apos;s own calibration: range of %1 of %2 sensors (residual at most %3 g), mounting of %4 (poses at most %5° from perpendicular)</source>
        <translation>aus der Kalibrierung im Take: Bereich von %1 von %2 Sensoren (Rest höchstens %3 g), Befestigung von %4 (Posen höchstens %5° vom rechten Winkel)</translation>
    </message>
    <message>
        <source>an unknown date</source>
        <translation>einem unbekannten Tag</translation>
    </message>
    <message>
        <source>has no calibration in it</source>
        <translation>enthält keine Kalibrierung</translation>
    </message>
    <message>
        <source>calibrate it, or choose another --calibration</source>
        <translation>kalibrieren oder eine andere --calibration wählen</translation>
    </message>
    <message>
        <source>has no calibration segments</source>
        <translation>hat keine Kalibrierungsabschnitte</translation>
    </message>
    <message>
        <source>choose another --calibration</source>
        <translation>eine andere --calibration wählen</translation>
    </message>
    <message>
        <source>as recorded in the take, of %1</source>
        <translation>wie im Take aufgezeichnet, von %1</translation>
    </message>
    <message>
        <source>from the data sheet alone</source>
        <translation>nur aus dem Datenblatt</translation>
    </message>
    <message>
        <source>no sensor of this take was ever calibrated, so inclinations may be 10° wrong</source>
        <translation>kein Sensor dieses Takes wurde je kalibriert, Neigungen können also um 10° falsch sein</translation>
    </message>
    <message>
        <source>calibrate the range of the sensors and their mounting</source>
        <translation>den Bereich der Sensoren und ihre Befestigung kalibrieren</translation>
    </message>
    <message>
        <source>is not a source of calibrations</source>
        <translation>ist keine Quelle von Kalibrierungen</translation>
    </message>
    <message>
        <source>use auto, snapshot, segments, library or nominal</source>
        <translation>auto, snapshot, segments, library oder nominal verwenden</translation>
    </message>
    <message>
        <source>the signal of %1 jumps within its slot: a click, or samples that were lost; the reading is left out</source>
        <translation>das Signal von %1 springt innerhalb seines Zeitfachs: ein Knacks oder verlorene Abtastwerte; der Messwert wird weggelassen</translation>
    </message>
    <message>
        <source>If it happens often, check plugs and solder joints, close other programs or take a larger buffer</source>
        <translation>Kommt es oft vor: Stecker und Lötstellen prüfen, andere Programme schließen oder einen größeren Puffer nehmen</translation>
    </message>
    <message>
        <source>at %1 samples per second a slot has only %2: readings are off by some thousandths of g and more</source>
        <translation>bei %1 Abtastwerten pro Sekunde hat ein Zeitfach nur %2: Messwerte sind um einige Tausendstel g und mehr falsch</translation>
    </message>
    <message>
        <source>Record at 44100 samples per second or more</source>
        <translation>Mit 44100 Abtastwerten pro Sekunde oder mehr aufnehmen</translation>
    </message>
    <message>
        <source>there is %1 Hz mains hum on the sensor channel, %2 % of the counter&apos;s swing; it is taken out as far as it is steady</source>
        <translation>auf dem Sensorkanal ist Netzbrummen mit %1 Hz, %2 % des Zählerhubs; es wird entfernt, soweit es gleichmäßig ist</translation>
    </message>
    <message>
        <source>is entered for two sensors</source>
        <translation>ist für zwei Sensoren eingetragen</translation>
    </message>
    <message>
        <source>serial &quot;%1&quot;</source>
        <translation>Seriennummer „%1“</translation>
    </message>
    <message>
        <source>give each sensor its own</source>
        <translation>jedem Sensor eine eigene geben</translation>
    </message>
    <message>
        <source>%1, but none of %2</source>
        <translation>%1, aber keine von %2</translation>
    </message>
    <message>
        <source>the calibration library has nothing for rig &quot;%1&quot; on %2</source>
        <translation>die Kalibrierungsbibliothek hat nichts für das Rig „%1“ an %2</translation>
    </message>
    <message>
        <source>calibration library: %1%2 %3</source>
        <translation>Kalibrierungsbibliothek: %1%2 %3</translation>
    </message>
    <message>
        <source>limbs of %1</source>
        <translation>Gliedmaßen von %1</translation>
    </message>
    <message>
        <source>cannot be set aside (%1)</source>
        <translation>kann nicht beiseitegelegt werden (%1)</translation>
    </message>
    <message>
        <source>the range of %1</source>
        <translation>der Bereich von %1</translation>
    </message>
    <message>
        <source>the mounting of %1</source>
        <translation>die Befestigung von %1</translation>
    </message>
    <message>
        <source>never calibrated, so from the data sheet: %1</source>
        <translation>nie kalibriert, daher aus dem Datenblatt: %1</translation>
    </message>
    <message>
        <source>calibrate these sensors, then solve again</source>
        <translation>diese Sensoren kalibrieren, dann neu berechnen</translation>
    </message>
    <message>
        <source>; completed by the %1</source>
        <translation>; ergänzt durch: %1</translation>
    </message>
    <message>
        <source>calibrate its sensors, or choose another --calibration</source>
        <translation>seine Sensoren kalibrieren oder eine andere --calibration wählen</translation>
    </message>
    <message>
        <source>has no inputs %1 and %2, only %3</source>
        <translation>hat keine Eingänge %1 und %2, nur %3</translation>
    </message>
    <message>
        <source>choose other inputs</source>
        <translation>andere Eingänge wählen</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Abtastwerte</translation>
    </message>
    <message>
        <source>is damaged, or of a kind that cannot be read (%1)</source>
        <translation>ist beschädigt oder von einer Art, die sich nicht lesen lässt (%1)</translation>
    </message>
    <message>
        <source>copy it again from the recorder, or accept what is there</source>
        <translation>noch einmal vom Aufnahmegerät kopieren oder nehmen, was da ist</translation>
    </message>
    <message>
        <source>the calibration has &quot;%1&quot; where the rig has &quot;%2&quot;</source>
        <translation>die Kalibrierung hat „%1“, wo das Rig „%2“ hat</translation>
    </message>
    <message>
        <source>put the entries into the order of the rig, or calibrate again</source>
        <translation>die Einträge in die Reihenfolge des Rigs bringen oder neu kalibrieren</translation>
    </message>
    <message>
        <source>does not fit: the disk is nearly full (%1 MB left)</source>
        <translation>passt nicht: der Datenträger ist fast voll (noch %1 MB)</translation>
    </message>
    <message>
        <source>make room, or choose another disk</source>
        <translation>Platz schaffen oder einen anderen Datenträger wählen</translation>
    </message>
    <message>
        <source>%1; it is not used</source>
        <translation>%1; sie wird nicht verwendet</translation>
    </message>
    <message>
        <source>the samples are not those that were recorded (checksum %1, recorded %2)</source>
        <translation>die Abtastwerte sind nicht die aufgenommenen (Prüfsumme %1, aufgenommen %2)</translation>
    </message>
    <message>
        <source>copy the take again; the disk or the card may be failing</source>
        <translation>den Take noch einmal kopieren; vielleicht versagt der Datenträger oder die Karte</translation>
    </message>
    <message>
        <source>was being replaced and was put back</source>
        <translation>wurde gerade ersetzt und ist wiederhergestellt</translation>
    </message>
    <message>
        <source>segment &quot;%1&quot; reached beyond the end of the take and was shortened</source>
        <translation>der Abschnitt „%1“ reichte über das Ende des Takes hinaus und wurde gekürzt</translation>
    </message>
    <message>
        <source>the calibration was not of this rig and was removed</source>
        <translation>die Kalibrierung war nicht von diesem Rig und wurde entfernt</translation>
    </message>
    <message>
        <source>the inclination at %1 s is not a number</source>
        <translation>die Neigung bei %1 s ist keine Zahl</translation>
    </message>
    <message>
        <source>solve with another smoothing, and report this with the take</source>
        <translation>mit einer anderen Glättung lösen und dies mit dem Take melden</translation>
    </message>
    <message>
        <source>a slot of the board lasts only %1 samples at %2 samples a second</source>
        <translation>ein Fach der Platine dauert nur %1 Abtastwerte bei %2 Abtastwerten je Sekunde</translation>
    </message>
    <message>
        <source>record at %1 at least, or correct the rig&apos;s cycle rate</source>
        <translation>mit mindestens %1 aufnehmen oder die Zyklusrate des Rigs berichtigen</translation>
    </message>
    <message>
        <source>use chain, adaptive, bridging or none</source>
        <translation>chain, adaptive, bridging oder none verwenden</translation>
    </message>
    <message>
        <source>%1 usable %2 %, gravity explains %3 %, %4</source>
        <translation>%1: %2 % brauchbar, die Schwerkraft erklärt %3 %, %4</translation>
    </message>
    <message>
        <source>%1 g at rest</source>
        <translation>%1 g in Ruhe</translation>
    </message>
    <message>
        <source>never at rest</source>
        <translation>nie in Ruhe</translation>
    </message>
    <message>
        <source>check its cable and plug</source>
        <translation>Kabel und Stecker prüfen</translation>
    </message>
    <message>
        <source>sits on &quot;%1&quot;, which is no segment of the skeleton, and is left out</source>
        <translation>sitzt an „%1“, das kein Segment des Skeletts ist, und wird weggelassen</translation>
    </message>
    <message>
        <source>was changed by another program: its joints have keys at different times</source>
        <translation>wurde von einem anderen Programm geändert: seine Gelenke haben Keys zu verschiedenen Zeiten</translation>
    </message>
    <message>
        <source>solve the take again, or import the changed clip elsewhere</source>
        <translation>den Take neu lösen oder den geänderten Clip anderswo importieren</translation>
    </message>
    <message>
        <source>turn this sensor slowly about all axes again: limbwave calibrate range</source>
        <translation>diesen Sensor noch einmal langsam um alle Achsen drehen: limbwave calibrate range</translation>
    </message>
    <message>
        <source>hold the poses again, still and exact: limbwave calibrate limb</source>
        <translation>die Posen noch einmal halten, still und genau: limbwave calibrate limb</translation>
    </message>
    <message>
        <source>the take&apos;s own %1 calibration is poor: %2</source>
        <translation>die eigene %1-Kalibrierung des Takes ist schlecht: %2</translation>
    </message>
    <message>
        <source>the mounting poses were up to %1° from perpendicular: %2</source>
        <translation>die Haltungen für die Befestigung waren bis zu %1° vom rechten Winkel entfernt: %2</translation>
    </message>
    <message>
        <source>hold the poses more exactly to make it better</source>
        <translation>die Haltungen genauer einnehmen, dann wird es besser</translation>
    </message>
    <message>
        <source>is more than 10 m off</source>
        <translation>liegt mehr als 10 m entfernt</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which another %2 has already</source>
        <translation>ist „%1“, was schon ein anderer Eintrag hat (%2)</translation>
    </message>
    <message>
        <source>has a pulse_hz of %1, too close to half the sample rate</source>
        <translation>hat pulse_hz %1, zu nah an der halben Abtastrate</translation>
    </message>
    <message>
        <source>use a rate_hz of at least 2.5 times pulse_hz</source>
        <translation>rate_hz mindestens auf das 2,5-Fache von pulse_hz setzen</translation>
    </message>
    <message>
        <source>has pulses longer than half a slot</source>
        <translation>hat Pulse, die länger als ein halber Zeitschlitz sind</translation>
    </message>
    <message>
        <source>use fewer pulse_cycles or more slot_samples</source>
        <translation>weniger pulse_cycles oder mehr slot_samples verwenden</translation>
    </message>
    <message>
        <source>has %1 entries, but %2 microphones have a wire each</source>
        <translation>hat %1 Einträge, aber %2 Mikrofone haben je eine Leitung</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, but the microphone of this wire is &quot;%2&quot;</source>
        <translation>ist „%1“, aber das Mikrofon dieser Leitung ist „%2“</translation>
    </message>
    <message>
        <source>%1: /%2/%3/segment</source>
        <translation>%1: /%2/%3/segment</translation>
    </message>
    <message>
        <source>stands beside line_in</source>
        <translation>steht neben line_in</translation>
    </message>
    <message>
        <source>a rig has one or the other</source>
        <translation>ein Rig hat das eine oder das andere</translation>
    </message>
    <message>
        <source>has %1 entries</source>
        <translation>hat %1 Einträge</translation>
    </message>
    <message>
        <source>a driver box has 1 to 64 wires</source>
        <translation>eine Treiberbox hat 1 bis 64 Leitungen</translation>
    </message>
    <message>
        <source>a driver box has up to 64 sources</source>
        <translation>eine Treiberbox hat bis zu 64 Quellen</translation>
    </message>
    <message>
        <source>lies more than 10 m off</source>
        <translation>liegt mehr als 10 m entfernt</translation>
    </message>
    <message>
        <source>there is no output for sound</source>
        <translation>es gibt keinen Tonausgang</translation>
    </message>
    <message>
        <source>connect a loudspeaker or headphones</source>
        <translation>schließen Sie Lautsprecher oder Kopfhörer an</translation>
    </message>
    <message>
        <source>the output cannot be used (%1)</source>
        <translation>der Ausgang lässt sich nicht verwenden (%1)</translation>
    </message>
    <message>
        <source>does not name every place of the rig once</source>
        <translation>nennt nicht jede Stelle des Rigs genau einmal</translation>
    </message>
    <message>
        <source>the sensors&apos; places</source>
        <translation>die Stellen der Sensoren</translation>
    </message>
    <message>
        <source>give every sensor its own place</source>
        <translation>geben Sie jedem Sensor seine eigene Stelle</translation>
    </message>
    <message>
        <source>%1 samples were lost on the line</source>
        <translation>%1 Abtastwerte gingen auf der Leitung verloren</translation>
    </message>
    <message>
        <source>wire %1 was %2</source>
        <translation>Leitung %1 wurde %2</translation>
    </message>
    <message>
        <source>plugged in again</source>
        <translation>wieder eingesteckt</translation>
    </message>
    <message>
        <source>a block came twice and was taken once</source>
        <translation>ein Block kam doppelt und wurde einmal genommen</translation>
    </message>
    <message>
        <source>a block came late and was put in its place</source>
        <translation>ein Block kam verspätet und wurde an seine Stelle gesetzt</translation>
    </message>
    <message>
        <source>is no serial port</source>
        <translation>ist keine serielle Schnittstelle</translation>
    </message>
    <message>
        <source>check the cable, and the port&apos;s name</source>
        <translation>prüfen Sie das Kabel und den Namen der Schnittstelle</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>check the cable, and that you may use serial ports (group dialout)</source>
        <translation>prüfen Sie das Kabel und ob Sie serielle Schnittstellen benutzen dürfen (Gruppe dialout)</translation>
    </message>
    <message>
        <source>the driver box does not answer any more; waiting for it</source>
        <translation>die Treiberbox antwortet nicht mehr; es wird auf sie gewartet</translation>
    </message>
    <message>
        <source>the driver box was switched on again; the length of the gap is by the computer&apos;s clock</source>
        <translation>die Treiberbox wurde wieder eingeschaltet; die Länge der Lücke kommt von der Uhr des Rechners</translation>
    </message>
    <message>
        <source>the driver box is back after %1 s</source>
        <translation>die Treiberbox ist nach %1 s wieder da</translation>
    </message>
    <message>
        <source>samples come again after %1 s</source>
        <translation>nach %1 s kommen wieder Abtastwerte</translation>
    </message>
    <message>
        <source>no samples come from the driver box</source>
        <translation>von der Treiberbox kommen keine Abtastwerte</translation>
    </message>
    <message>
        <source>does not answer as a driver box does</source>
        <translation>antwortet nicht wie eine Treiberbox</translation>
    </message>
    <message>
        <source>check that it is the box&apos;s port, and that it is on</source>
        <translation>prüfen Sie, ob es die Schnittstelle der Box ist und ob sie eingeschaltet ist</translation>
    </message>
    <message>
        <source>numbers are copied as they lie in memory</source>
        <translation>Zahlen werden so kopiert, wie sie im Speicher liegen</translation>
    </message>
    <message>
        <source>has an entry that is not above 0 and up to 2</source>
        <translation>hat einen Eintrag, der nicht über 0 und höchstens 2 ist</translation>
    </message>
    <message>
        <source>amplitudes at 0, 10, ... 180 degrees</source>
        <translation>Amplituden bei 0, 10, … 180 Grad</translation>
    </message>
    <message>
        <source>has no driver box</source>
        <translation>hat keine Treiberbox</translation>
    </message>
    <message>
        <source>rig &quot;%1&quot;</source>
        <translation>Rig „%1“</translation>
    </message>
    <message>
        <source>use driver-box-body or another with a driver box</source>
        <translation>nehmen Sie driver-box-body oder ein anderes mit Treiberbox</translation>
    </message>
    <message>
        <source>is for %1 wires and %2 sources at %3 Hz with %4 samples a slot, but the box has %5 and %6 at %7 Hz with %8</source>
        <translation>ist für %1 Leitungen und %2 Quellen bei %3 Hz mit %4 Abtastwerten je Zeitschlitz, aber die Box hat %5 und %6 bei %7 Hz mit %8</translation>
    </message>
    <message>
        <source>use the rig that belongs to this box</source>
        <translation>nehmen Sie das Rig, das zu dieser Box gehört</translation>
    </message>
    <message>
        <source>driver box %1, %2</source>
        <translation>Treiberbox %1, %2</translation>
    </message>
    <message>
        <source>the box&apos;s battery is down to %1 V</source>
        <translation>die Batterie der Box ist auf %1 V gesunken</translation>
    </message>
    <message>
        <source>%1: /ranging</source>
        <translation>%1: /ranging</translation>
    </message>
    <message>
        <source>has %1 channels, but its rig is not that of a driver box with as many wires</source>
        <translation>hat %1 Kanäle, aber sein Rig ist nicht das einer Treiberbox mit ebenso vielen Leitungen</translation>
    </message>
    <message>
        <source>use a take of a driver box</source>
        <translation>nehmen Sie einen Take einer Treiberbox</translation>
    </message>
    <message>
        <source>there is no reading of the sensors that shall be used</source>
        <translation>von den Sensoren, die benutzt werden sollen, gibt es keine Messwerte</translation>
    </message>
    <message>
        <source>choose other sensors</source>
        <translation>wählen Sie andere Sensoren</translation>
    </message>
    <message>
        <source>the root is said to be given, but there is no path of it</source>
        <translation>die Wurzel soll gegeben sein, aber es gibt keinen Weg von ihr</translation>
    </message>
    <message>
        <source>give one, or let the root be free</source>
        <translation>geben Sie einen an oder lassen Sie die Wurzel frei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; moved in the first second: its gyroscope&apos;s bias is not known</source>
        <translation>„%1“ hat sich in der ersten Sekunde bewegt: die Nullpunktabweichung seines Kreisels ist unbekannt</translation>
    </message>
    <message>
        <source>begin with a second of standing still</source>
        <translation>beginnen Sie mit einer Sekunde Stillstehen</translation>
    </message>
    <message>
        <source>correct the line</source>
        <translation>berichtigen Sie die Zeile</translation>
    </message>
    <message>
        <source>has no column &quot;sensor&quot;, and the rig has several</source>
        <translation>hat keine Spalte „sensor“, und das Rig hat mehrere</translation>
    </message>
    <message>
        <source>say which sensor every row is of</source>
        <translation>geben Sie an, von welchem Sensor jede Zeile ist</translation>
    </message>
    <message>
        <source>has a cell that is not a number</source>
        <translation>hat eine Zelle, die keine Zahl ist</translation>
    </message>
    <message>
        <source>names the sensor &quot;%1&quot;, which the rig lacks</source>
        <translation>nennt den Sensor „%1“, den das Rig nicht hat</translation>
    </message>
    <message>
        <source>name sensors as in the rig</source>
        <translation>benennen Sie Sensoren wie im Rig</translation>
    </message>
    <message>
        <source>is earlier than the line before</source>
        <translation>ist früher als die Zeile davor</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which the rig lacks</source>
        <translation>nennt „%1“, was das Rig nicht hat</translation>
    </message>
    <message>
        <source>name sources and receivers as in the rig</source>
        <translation>benennen Sie Quellen und Empfänger wie im Rig</translation>
    </message>
    <message>
        <source>has no column &quot;%1&quot;</source>
        <translation>hat keine Spalte „%1“</translation>
    </message>
    <message>
        <source>a path has time_s,qw,qx,qy,qz,px_m,py_m,pz_m</source>
        <translation>ein Weg hat time_s,qw,qx,qy,qz,px_m,py_m,pz_m</translation>
    </message>
    <message>
        <source>has a quaternion that is not of length 1</source>
        <translation>hat ein Quaternion, dessen Länge nicht 1 ist</translation>
    </message>
    <message>
        <source>is not later than the line before</source>
        <translation>ist nicht später als die Zeile davor</translation>
    </message>
    <message>
        <source>has fewer than two poses</source>
        <translation>hat weniger als zwei Posen</translation>
    </message>
    <message>
        <source>check the columns and the segment&apos;s name</source>
        <translation>prüfen Sie die Spalten und den Namen des Segments</translation>
    </message>
    <message>
        <source>has neither the columns of inertial readings nor those of ranges</source>
        <translation>hat weder die Spalten von Inertialmesswerten noch die von Entfernungen</translation>
    </message>
    <message>
        <source>see &quot;Plain files for other people&apos;s sensors&quot; in the manual</source>
        <translation>siehe „Plain files for other people&apos;s sensors“ im Handbuch</translation>
    </message>
    <message>
        <source>has no column &quot;time_s&quot;</source>
        <translation>hat keine Spalte „time_s“</translation>
    </message>
    <message>
        <source>say when every row was measured</source>
        <translation>geben Sie an, wann jede Zeile gemessen wurde</translation>
    </message>
    <message>
        <source>has no reading</source>
        <translation>hat keinen Messwert</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>exportieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>check that it exists and that you may read it</source>
        <translation>prüfen Sie, ob es sie gibt und ob Sie sie lesen dürfen</translation>
    </message>
    <message>
        <source>is larger than 2 GB</source>
        <translation>ist größer als 2 GB</translation>
    </message>
    <message>
        <source>is damaged or breaks off</source>
        <translation>ist beschädigt oder bricht ab</translation>
    </message>
    <message>
        <source>its first line names the columns</source>
        <translation>ihre erste Zeile benennt die Spalten</translation>
    </message>
    <message>
        <source>this version reads &quot;line-in&quot;, &quot;driver-box&quot; and &quot;log&quot;</source>
        <translation>diese Version liest „line-in“, „driver-box“ und „log“</translation>
    </message>
    <message>
        <source>has no truth</source>
        <translation>hat keine Wahrheit</translation>
    </message>
    <message>
        <source>give the root&apos;s path as a CSV file</source>
        <translation>geben Sie den Weg der Wurzel als CSV-Datei an</translation>
    </message>
    <message>
        <source>does not tell where the root was</source>
        <translation>sagt nicht, wo die Wurzel war</translation>
    </message>
    <message>
        <source>%1 % of %2 readings of &quot;%3&quot; contradict all others</source>
        <translation>%1 % von %2 Messwerten von „%3“ widersprechen allen anderen</translation>
    </message>
    <message>
        <source>check where it is worn, and its calibration</source>
        <translation>prüfen Sie, wo er getragen wird, und seine Kalibrierung</translation>
    </message>
    <message>
        <source>%1 % of %2 readings of &quot;%3&quot; are beyond its range</source>
        <translation>%1 % von %2 Messwerten von „%3“ liegen außerhalb seines Messbereichs</translation>
    </message>
    <message>
        <source>such movements need sensors of a wider range</source>
        <translation>solche Bewegungen brauchen Sensoren mit größerem Messbereich</translation>
    </message>
    <message>
        <source>as read</source>
        <translation>wie gelesen</translation>
    </message>
    <message>
        <source>%1 m/s, within %2 m/s, from %3 pairs on one segment%4</source>
        <translation>%1 m/s, auf %2 m/s genau, aus %3 Paaren auf einem Segment%4</translation>
    </message>
    <message>
        <source>; %1 pairs that contradict them are left out</source>
        <translation>; %1 Paare, die ihnen widersprechen, sind weggelassen</translation>
    </message>
    <message>
        <source>has too few ranges between sources and microphones on one segment</source>
        <translation>hat zu wenige Abstände zwischen Quellen und Mikrofonen auf einem Segment</translation>
    </message>
    <message>
        <source>speed of sound</source>
        <translation>Schallgeschwindigkeit</translation>
    </message>
    <message>
        <source>take more of the recording, or enter temperature and humidity</source>
        <translation>mehr von der Aufnahme nehmen oder Temperatur und Feuchte eingeben</translation>
    </message>
    <message>
        <source>%1 samples were lost because the disk was too slow</source>
        <translation>%1 Abtastwerte gingen verloren, weil die Platte zu langsam war</translation>
    </message>
    <message>
        <source>is running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>stop it before its schedule is changed</source>
        <translation>halten Sie sie an, bevor Sie ihre Reihenfolge ändern</translation>
    </message>
    <message>
        <source>refuses the order in which sources are to fire</source>
        <translation>lehnt die Reihenfolge ab, in der die Quellen senden sollen</translation>
    </message>
    <message>
        <source>check that the rig belongs to this box</source>
        <translation>prüfen Sie, ob das Rig zu dieser Box gehört</translation>
    </message>
    <message>
        <source>does not start</source>
        <translation>startet nicht</translation>
    </message>
    <message>
        <source>check the cable, and switch the box off and on</source>
        <translation>prüfen Sie das Kabel und schalten Sie die Box aus und ein</translation>
    </message>
    <message>
        <source>sound card %1</source>
        <translation>Soundkarte %1</translation>
    </message>
    <message>
        <source>check that the rig belongs to this card</source>
        <translation>prüfen Sie, ob das Rig zu dieser Karte gehört</translation>
    </message>
    <message>
        <source>%1 samples were lost: %2</source>
        <translation>%1 Abtastwerte gingen verloren: %2</translation>
    </message>
    <message>
        <source>the sound card was away; by the computer&apos;s clock</source>
        <translation>die Soundkarte war fort; nach der Uhr des Rechners</translation>
    </message>
    <message>
        <source>the sound card is back after %1 s</source>
        <translation>die Soundkarte ist nach %1 s wieder da</translation>
    </message>
    <message>
        <source>no mark is heard from the outputs; delays are as the sound card says, and may be off</source>
        <translation>von den Ausgängen ist keine Marke zu hören; die Verzögerungen sind die von der Soundkarte genannten und können falsch sein</translation>
    </message>
    <message>
        <source>the sound card left them out</source>
        <translation>die Soundkarte ließ sie aus</translation>
    </message>
    <message>
        <source>outputs were late by %1 samples and are put right</source>
        <translation>die Ausgänge waren um %1 Abtastwerte zu spät und sind berichtigt</translation>
    </message>
    <message>
        <source>the sound card does not answer any more; waiting for it</source>
        <translation>die Soundkarte antwortet nicht mehr; es wird auf sie gewartet</translation>
    </message>
    <message>
        <source>the computer was too slow for the sound card</source>
        <translation>der Rechner war zu langsam für die Soundkarte</translation>
    </message>
    <message>
        <source>has %1 inputs and %2 outputs, but %3 and %4 are needed</source>
        <translation>hat %1 Eingänge und %2 Ausgänge, gebraucht werden %3 und %4</translation>
    </message>
    <message>
        <source>use a larger interface, or a rig with fewer boards</source>
        <translation>benutzen Sie ein größeres Interface oder ein Rig mit weniger Platinen</translation>
    </message>
    <message>
        <source>cannot play and capture at %1 Hz (%2)</source>
        <translation>kann bei %1 Hz nicht zugleich abspielen und aufnehmen (%2)</translation>
    </message>
    <message>
        <source>check that no other program uses it, and choose a rate that it runs at</source>
        <translation>prüfen Sie, dass kein anderes Programm sie benutzt, und wählen Sie eine Rate, mit der sie läuft</translation>
    </message>
    <message>
        <source>is not of length 1</source>
        <translation>hat nicht die Länge 1</translation>
    </message>
    <message>
        <source>is not &quot;body-filter-state&quot;</source>
        <translation>ist nicht „body-filter-state“</translation>
    </message>
    <message>
        <source>give a file that was saved by --save-state</source>
        <translation>geben Sie eine Datei an, die mit --save-state gesichert wurde</translation>
    </message>
    <message>
        <source>has not as many entries as the states need</source>
        <translation>hat nicht so viele Einträge, wie die Zustände brauchen</translation>
    </message>
    <message>
        <source>the saved state is of another rig, skeleton or choice of sensors</source>
        <translation>der gesicherte Zustand gehört zu einem anderen Rig, Skelett oder anderen Sensoren</translation>
    </message>
    <message>
        <source>resume with what it was saved with</source>
        <translation>setzen Sie mit dem fort, womit er gesichert wurde</translation>
    </message>
    <message>
        <source>saved state</source>
        <translation>gesicherter Zustand</translation>
    </message>
    <message>
        <source>is of another skeleton or rig</source>
        <translation>gehört zu einem anderen Skelett oder Rig</translation>
    </message>
    <message>
        <source>the skeleton has no feet that could stand: the root is free</source>
        <translation>das Skelett hat keine Füße, die stehen könnten: die Wurzel ist frei</translation>
    </message>
    <message>
        <source>give it segments that reach the ground, or solve with another root</source>
        <translation>geben Sie ihm Segmente, die den Boden erreichen, oder berechnen Sie mit einer anderen Wurzel</translation>
    </message>
    <message>
        <source>&quot;%1&quot; never stood: its contacts do not hold the root</source>
        <translation>„%1“ stand nie: seine Kontakte halten die Wurzel nicht</translation>
    </message>
    <message>
        <source>check its sensor, or solve with another root</source>
        <translation>prüfen Sie seinen Sensor, oder berechnen Sie mit einer anderen Wurzel</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stood %2 times, %3 s in all</source>
        <translation>„%1“ stand %2-mal, insgesamt %3 s</translation>
    </message>
    <message>
        <source> and &quot;</source>
        <translation> und „</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 moved in the first second</source>
        <translation>%1 bewegte sich in der ersten Sekunde</translation>
    </message>
    <message>
        <source>begin with a second of standing still in the rest pose, or start in mid-motion</source>
        <translation>beginnen Sie mit einer Sekunde Stillstand in der Ruhepose, oder starten Sie mitten in der Bewegung</translation>
    </message>
    <message>
        <source>%1 moved in the first second: the pose at the start is hardly known</source>
        <translation>%1 bewegte sich in der ersten Sekunde: die Pose am Anfang ist kaum bekannt</translation>
    </message>
    <message>
        <source>begin with a second of standing still in the rest pose</source>
        <translation>beginnen Sie mit einer Sekunde Stillstand in der Ruhepose</translation>
    </message>
    <message>
        <source>&quot;%1&quot; feels gravity %2° away from where it should be in the rest pose</source>
        <translation>„%1“ spürt die Schwerkraft %2° neben der Richtung, die sie in der Ruhepose haben müsste</translation>
    </message>
    <message>
        <source>it is mounted upside down: turn it round, or say so in the rig</source>
        <translation>er sitzt verkehrt herum: drehen Sie ihn um, oder tragen Sie es im Rig ein</translation>
    </message>
    <message>
        <source>mount it as the rig says, and hold the rest pose</source>
        <translation>befestigen Sie ihn wie im Rig, und halten Sie die Ruhepose</translation>
    </message>
    <message>
        <source>is of another rig</source>
        <translation>gehört zu einem anderen Rig</translation>
    </message>
    <message>
        <source>no sensor was heard for %1 from %2 on: the pose was held there</source>
        <translation>ab %2 war %1 lang kein Sensor zu hören: die Pose wurde dort gehalten</translation>
    </message>
    <message>
        <source>check the box, its cable and its battery</source>
        <translation>prüfen Sie die Box, ihr Kabel und ihren Akku</translation>
    </message>
    <message>
        <source>%1 was never heard: the filter did without it</source>
        <translation>%1 war nie zu hören: das Filter kam ohne aus</translation>
    </message>
    <message>
        <source>check its wire and its plug</source>
        <translation>prüfen Sie Leitung und Stecker</translation>
    </message>
    <message>
        <source>from the start</source>
        <translation>von Anfang an</translation>
    </message>
    <message>
        <source>from %1 on</source>
        <translation>ab %1</translation>
    </message>
    <message>
        <source> until %1</source>
        <translation> bis %1</translation>
    </message>
    <message>
        <source>%1 was silent %2%3: the filter did without it</source>
        <translation>%1 schwieg %2%3: das Filter kam ohne aus</translation>
    </message>
    <message>
        <source>%1 gave the same reading %2%3: the filter did without it</source>
        <translation>%1 gab %2%3 immer denselben Messwert: das Filter kam ohne aus</translation>
    </message>
    <message>
        <source>its chip hangs or is broken: switch it off and on, or replace it</source>
        <translation>sein Chip hängt oder ist defekt: schalten Sie ihn aus und ein, oder ersetzen Sie ihn</translation>
    </message>
    <message>
        <source>%1 was not heard %2 times for a moment</source>
        <translation>%1 war %2-mal kurz nicht zu hören</translation>
    </message>
    <message>
        <source>check its plug</source>
        <translation>prüfen Sie seinen Stecker</translation>
    </message>
    <message>
        <source>%1 sensors feel gravity far from where it is in the rest pose</source>
        <translation>%1 Sensoren spüren die Schwerkraft weit neben der Richtung in der Ruhepose</translation>
    </message>
    <message>
        <source>begin in the rest pose</source>
        <translation>beginnen Sie in der Ruhepose</translation>
    </message>
    <message>
        <source>looking for mixed up sensors</source>
        <translation>Suche nach vertauschten Sensoren</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; are exchanged: solved as if each were in the other&apos;s place</source>
        <translation>„%1“ und „%2“ sind vertauscht: berechnet, als säße jeder am Platz des anderen</translation>
    </message>
    <message>
        <source>exchange them, or their wires, before the next recording</source>
        <translation>tauschen Sie sie oder ihre Leitungen vor der nächsten Aufnahme</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is mounted the wrong way round: solved as if turned by 180° about its %2 axis</source>
        <translation>„%1“ sitzt verkehrt: berechnet, als wäre er um 180° um seine %2-Achse gedreht</translation>
    </message>
    <message>
        <source>turn it round, or say so in the rig</source>
        <translation>drehen Sie ihn um, oder tragen Sie es im Rig ein</translation>
    </message>
    <message>
        <source>a smoother looks to both sides and cannot resume</source>
        <translation>ein Glätter sieht in beide Richtungen und kann nicht fortsetzen</translation>
    </message>
    <message>
        <source>choose the filter</source>
        <translation>wählen Sie das Filter</translation>
    </message>
    <message>
        <source>cannot be taken out (%1)</source>
        <translation>kann nicht herausgenommen werden (%1)</translation>
    </message>
    <message>
        <source>is no time, name and two numbers</source>
        <translation>ist nicht Zeit, Name und zwei Zahlen</translation>
    </message>
    <message>
        <source>does not name every segment at every time</source>
        <translation>nennt nicht zu jeder Zeit jedes Segment</translation>
    </message>
    <message>
        <source>has fewer cells than the header</source>
        <translation>hat weniger Zellen als die Kopfzeile</translation>
    </message>
    <message>
        <source>complete the line; cells may be empty</source>
        <translation>vervollständigen Sie die Zeile; Zellen dürfen leer sein</translation>
    </message>
    <message>
        <source>has a range that is not positive</source>
        <translation>hat eine Entfernung, die nicht positiv ist</translation>
    </message>
    <message>
        <source>has a confidence that is not from 0 to 1</source>
        <translation>hat ein Vertrauen, das nicht zwischen 0 und 1 liegt</translation>
    </message>
    <message>
        <source>this computer is too slow for the live picture, which has left something out</source>
        <translation>dieser Rechner ist zu langsam für das Livebild, das etwas ausgelassen hat</translation>
    </message>
    <message>
        <source>the recording is whole: solve it afterwards</source>
        <translation>die Aufnahme ist vollständig: berechnen Sie sie danach</translation>
    </message>
    <message>
        <source>a session runs only once</source>
        <translation>eine Sitzung läuft nur einmal</translation>
    </message>
    <message>
        <source>make another</source>
        <translation>legen Sie eine andere an</translation>
    </message>
    <message>
        <source>cannot be known while recording</source>
        <translation>kann während der Aufnahme nicht bekannt sein</translation>
    </message>
    <message>
        <source>root &quot;%1&quot;</source>
        <translation>Wurzel „%1“</translation>
    </message>
    <message>
        <source>choose free, fixed or contacts</source>
        <translation>wählen Sie free, fixed oder contacts</translation>
    </message>
    <message>
        <source>no session runs</source>
        <translation>keine Sitzung läuft</translation>
    </message>
    <message>
        <source>start one</source>
        <translation>starten Sie eine</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1 nach oben</translation>
    </message>
    <message>
        <source>the skeletons have %1 and %2 segments</source>
        <translation>die Skelette haben %1 und %2 Segmente</translation>
    </message>
    <message>
        <source>join clips of the same skeleton</source>
        <translation>Clips desselben Skeletts verbinden</translation>
    </message>
    <message>
        <source>segment %1 is &quot;%2&quot; in one clip and &quot;%3&quot; in the other</source>
        <translation>Segment %1 heißt im einen Clip „%2“ und im anderen „%3“</translation>
    </message>
    <message>
        <source>reducing keys</source>
        <translation>Schlüssel werden verringert</translation>
    </message>
    <message>
        <source>export the mesh again from the program that made it</source>
        <translation>das Netz aus seinem Programm noch einmal exportieren</translation>
    </message>
    <message>
        <source>%1 vertices have %2 normals, %3 rows of bones and %4 of weights</source>
        <translation>%1 Punkte haben %2 Normalen, %3 Zeilen mit Knochen und %4 mit Gewichten</translation>
    </message>
    <message>
        <source>%1 bind poses for %2 bones</source>
        <translation>%1 Bindeposen für %2 Knochen</translation>
    </message>
    <message>
        <source>vertex %1 has a number that is not finite</source>
        <translation>Punkt %1 hat eine Zahl, die nicht endlich ist</translation>
    </message>
    <message>
        <source>triangle %1 has a corner beyond the %2 vertices</source>
        <translation>Dreieck %1 hat eine Ecke jenseits der %2 Punkte</translation>
    </message>
    <message>
        <source>vertex %1 has a wrong bone or weight</source>
        <translation>Punkt %1 hat einen falschen Knochen oder ein falsches Gewicht</translation>
    </message>
    <message>
        <source>the weights of vertex %1 sum to %2, not 1</source>
        <translation>die Gewichte von Punkt %1 ergeben zusammen %2 statt 1</translation>
    </message>
    <message>
        <source>finding bones</source>
        <translation>Knochen werden gesucht</translation>
    </message>
    <message>
        <source>choose a mesh of triangles that stands around the skeleton</source>
        <translation>ein Netz aus Dreiecken wählen, das um das Skelett herum steht</translation>
    </message>
    <message>
        <source>the mesh has no triangles</source>
        <translation>das Netz hat keine Dreiecke</translation>
    </message>
    <message>
        <source>there is no skeleton to bind it to</source>
        <translation>es gibt kein Skelett, an das es gebunden werden könnte</translation>
    </message>
    <message>
        <source>vertex %1 is not a number</source>
        <translation>Punkt %1 ist keine Zahl</translation>
    </message>
    <message>
        <source>triangle %1 has a corner that does not exist</source>
        <translation>Dreieck %1 hat eine Ecke, die es nicht gibt</translation>
    </message>
    <message>
        <source>the equations of the skin cannot be solved</source>
        <translation>die Gleichungen der Haut lassen sich nicht lösen</translation>
    </message>
    <message>
        <source>repair the mesh: close holes, merge slivers</source>
        <translation>das Netz ausbessern: Löcher schließen, Splitter verschmelzen</translation>
    </message>
    <message>
        <source>spreading heat</source>
        <translation>Wärme wird verteilt</translation>
    </message>
    <message>
        <source>is no animation that can be read</source>
        <translation>ist keine Animation, die sich lesen lässt</translation>
    </message>
    <message>
        <source>choose a .bvh, .glb, .gltf, .vrm or .fbx file</source>
        <translation>eine Datei mit .bvh, .glb, .gltf, .vrm oder .fbx wählen</translation>
    </message>
    <message>
        <source>is no bone of a person</source>
        <translation>ist kein Knochen eines Menschen</translation>
    </message>
    <message>
        <source>the bones are listed in resources/bone_maps/README.md</source>
        <translation>die Knochen stehen in resources/bone_maps/README.md</translation>
    </message>
    <message>
        <source>is empty or stands for two bones</source>
        <translation>ist leer oder steht für zwei Knochen</translation>
    </message>
    <message>
        <source>give every bone a name of its own</source>
        <translation>jedem Knochen einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>is no object</source>
        <translation>ist kein Objekt</translation>
    </message>
    <message>
        <source>write it as %1</source>
        <translation>es als %1 schreiben</translation>
    </message>
    <message>
        <source>HIERARCHY, with which a BVH file starts</source>
        <translation>HIERARCHY, womit eine BVH-Datei beginnt</translation>
    </message>
    <message>
        <source>check that it is a BVH file</source>
        <translation>prüfen, ob es eine BVH-Datei ist</translation>
    </message>
    <message>
        <source>a second ROOT</source>
        <translation>ein zweites ROOT</translation>
    </message>
    <message>
        <source>write one person per file</source>
        <translation>jede Person in eine eigene Datei schreiben</translation>
    </message>
    <message>
        <source>check that the file is whole</source>
        <translation>prüfen, ob die Datei vollständig ist</translation>
    </message>
    <message>
        <source>%1 joint(s) without OFFSET, first &quot;%2&quot;, are taken to be at their parent</source>
        <translation>%1 Gelenk(e) ohne OFFSET, zuerst „%2“, werden beim übergeordneten angenommen</translation>
    </message>
    <message>
        <source>%1 stands where %2 belongs</source>
        <translation>%1 steht, wo %2 hingehört</translation>
    </message>
    <message>
        <source>check the hierarchy there</source>
        <translation>die Hierarchie dort prüfen</translation>
    </message>
    <message>
        <source>the file ends inside joint &quot;%1&quot;</source>
        <translation>die Datei endet mitten in Gelenk „%1“</translation>
    </message>
    <message>
        <source>OFFSET, CHANNELS, JOINT, End Site or }</source>
        <translation>OFFSET, CHANNELS, JOINT, End Site oder }</translation>
    </message>
    <message>
        <source>check the braces of the hierarchy</source>
        <translation>die Klammern der Hierarchie prüfen</translation>
    </message>
    <message>
        <source>a number of OFFSET</source>
        <translation>eine Zahl von OFFSET</translation>
    </message>
    <message>
        <source>give three numbers with decimal points</source>
        <translation>drei Zahlen mit Dezimalpunkt angeben</translation>
    </message>
    <message>
        <source>an OFFSET of %1 is no bone&apos;s</source>
        <translation>ein OFFSET von %1 gehört zu keinem Knochen</translation>
    </message>
    <message>
        <source>a number of channels from 0 to 6</source>
        <translation>eine Zahl von Kanälen von 0 bis 6</translation>
    </message>
    <message>
        <source>count the channels that follow</source>
        <translation>die folgenden Kanäle zählen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has CHANNELS twice</source>
        <translation>„%1“ hat zweimal CHANNELS</translation>
    </message>
    <message>
        <source>leave one of them</source>
        <translation>eines davon stehen lassen</translation>
    </message>
    <message>
        <source>the name of a channel</source>
        <translation>der Name eines Kanals</translation>
    </message>
    <message>
        <source>use Xposition to Zposition and Xrotation to Zrotation</source>
        <translation>Xposition bis Zposition und Xrotation bis Zrotation verwenden</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 twice</source>
        <translation>„%1“ hat zweimal %2</translation>
    </message>
    <message>
        <source>list every channel once</source>
        <translation>jeden Kanal einmal aufführen</translation>
    </message>
    <message>
        <source>joints slide in their parents, &quot;%1&quot; by %2 mm; the skeleton has their mean places</source>
        <translation>Gelenke gleiten gegen ihr übergeordnetes, „%1“ um %2 mm; das Skelett hat ihre mittleren Plätze</translation>
    </message>
    <message>
        <source>check that the disk has room, and export again</source>
        <translation>prüfen, ob auf der Platte Platz ist, und noch einmal exportieren</translation>
    </message>
    <message>
        <source>has no frames</source>
        <translation>hat keine Bilder</translation>
    </message>
    <message>
        <source>says that it has %1 frames and has %2</source>
        <translation>nennt %1 Bilder und hat %2</translation>
    </message>
    <message>
        <source>%1 (behind frame %2)</source>
        <translation>%1 (hinter Bild %2)</translation>
    </message>
    <message>
        <source>&quot;Frames:&quot; and &quot;Frame Time:&quot; must follow MOTION</source>
        <translation>auf MOTION müssen „Frames:“ und „Frame Time:“ folgen</translation>
    </message>
    <message>
        <source>%1 stands where a number belongs</source>
        <translation>%1 steht, wo eine Zahl hingehört</translation>
    </message>
    <message>
        <source>%1 is not a number of frames</source>
        <translation>%1 ist keine Zahl von Bildern</translation>
    </message>
    <message>
        <source>count the lines that follow</source>
        <translation>die folgenden Zeilen zählen</translation>
    </message>
    <message>
        <source>a Frame Time of %1 s makes no sense</source>
        <translation>eine Frame Time von %1 s ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>give the seconds from frame to frame, for example 0.0166667</source>
        <translation>die Sekunden von Bild zu Bild angeben, zum Beispiel 0.0166667</translation>
    </message>
    <message>
        <source>frame %1 has %2 values instead of %3</source>
        <translation>Bild %1 hat %2 Werte statt %3</translation>
    </message>
    <message>
        <source>check the CHANNELS of the hierarchy and that the file is whole</source>
        <translation>die CHANNELS der Hierarchie prüfen und ob die Datei vollständig ist</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>write numbers with a decimal point and spaces between them</source>
        <translation>Zahlen mit Dezimalpunkt und mit Leerzeichen dazwischen schreiben</translation>
    </message>
    <message>
        <source>frame %1 has more than %2 values</source>
        <translation>Bild %1 hat mehr als %2 Werte</translation>
    </message>
    <message>
        <source>check the CHANNELS of the hierarchy</source>
        <translation>die CHANNELS der Hierarchie prüfen</translation>
    </message>
    <message>
        <source>the file breaks off inside its last frame</source>
        <translation>die Datei bricht mitten in ihrem letzten Bild ab</translation>
    </message>
    <message>
        <source>check that it was copied whole</source>
        <translation>prüfen, ob sie ganz kopiert wurde</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>the file says %1 frames and has %2</source>
        <translation>die Datei nennt %1 Bilder und hat %2</translation>
    </message>
    <message>
        <source>is UTF-16 text</source>
        <translation>ist Text in UTF-16</translation>
    </message>
    <message>
        <source>save it as UTF-8</source>
        <translation>als UTF-8 speichern</translation>
    </message>
    <message>
        <source>%1 metres per unit is not a scale</source>
        <translation>%1 Meter je Einheit ist kein Maßstab</translation>
    </message>
    <message>
        <source>give a positive number</source>
        <translation>eine positive Zahl angeben</translation>
    </message>
    <message>
        <source>no joint has channels</source>
        <translation>kein Gelenk hat Kanäle</translation>
    </message>
    <message>
        <source>the pose of &quot;%1&quot; at %2 s is not a number</source>
        <translation>die Pose von „%1“ bei %2 s ist keine Zahl</translation>
    </message>
    <message>
        <source>the clip has no skeleton</source>
        <translation>der Clip hat kein Skelett</translation>
    </message>
    <message>
        <source>solve the take first</source>
        <translation>zuerst den Take berechnen</translation>
    </message>
    <message>
        <source>%1 is not a frame rate</source>
        <translation>%1 ist keine Bildrate</translation>
    </message>
    <message>
        <source>give the frames per second, for example 60</source>
        <translation>die Bilder je Sekunde angeben, zum Beispiel 60</translation>
    </message>
    <message>
        <source>%1 s at %2 frames per second are too many frames</source>
        <translation>%1 s mit %2 Bildern je Sekunde sind zu viele Bilder</translation>
    </message>
    <message>
        <source>write fewer frames per second or a part of it</source>
        <translation>weniger Bilder je Sekunde oder nur einen Teil schreiben</translation>
    </message>
    <message>
        <source>the keys of &quot;%1&quot; are not whole</source>
        <translation>die Schlüssel von „%1“ sind nicht vollständig</translation>
    </message>
    <message>
        <source>the key times of &quot;%1&quot; do not increase from 0</source>
        <translation>die Zeiten der Schlüssel von „%1“ steigen nicht von 0 an</translation>
    </message>
    <message>
        <source>%1 joints move, but the skeleton has %2</source>
        <translation>%1 Gelenke bewegen sich, aber das Skelett hat %2</translation>
    </message>
    <message>
        <source>the rest pose of &quot;%1&quot; is not a pose</source>
        <translation>die Ruhepose von „%1“ ist keine Pose</translation>
    </message>
    <message>
        <source>correct the skeleton</source>
        <translation>das Skelett berichtigen</translation>
    </message>
    <message>
        <source>there is no clip to write</source>
        <translation>es gibt keinen Clip zu schreiben</translation>
    </message>
    <message>
        <source>solve a take first, or choose a clip</source>
        <translation>zuerst einen Take berechnen oder einen Clip wählen</translation>
    </message>
    <message>
        <source>%1 s at %2 frames per second are too many rows</source>
        <translation>%1 s mit %2 Bildern je Sekunde sind zu viele Zeilen</translation>
    </message>
    <message>
        <source>the written file cannot be read back: %1</source>
        <translation>die geschriebene Datei lässt sich nicht zurücklesen: %1</translation>
    </message>
    <message>
        <source>from %1 s to %2 s there is nothing; it is %3 s long</source>
        <translation>von %1 s bis %2 s ist nichts; er ist %3 s lang</translation>
    </message>
    <message>
        <source>choose a part inside the clip</source>
        <translation>einen Teil innerhalb des Clips wählen</translation>
    </message>
    <message>
        <source>choose another file</source>
        <translation>eine andere Datei wählen</translation>
    </message>
    <message>
        <source>has an ending that cannot be written</source>
        <translation>hat eine Endung, die sich nicht schreiben lässt</translation>
    </message>
    <message>
        <source>use .fbx, .glb, .gltf, .vrm, .bvh or .csv</source>
        <translation>.fbx, .glb, .gltf, .vrm, .bvh oder .csv verwenden</translation>
    </message>
    <message>
        <source>nothing is to be exported</source>
        <translation>es ist nichts zu exportieren</translation>
    </message>
    <message>
        <source>choose a clip</source>
        <translation>einen Clip wählen</translation>
    </message>
    <message>
        <source>one file of this format holds one actor</source>
        <translation>eine Datei dieses Formats fasst einen Darsteller</translation>
    </message>
    <message>
        <source>export every actor to a file of its own</source>
        <translation>jeden Darsteller in eine eigene Datei exportieren</translation>
    </message>
    <message>
        <source>give the frames per second</source>
        <translation>die Bilder je Sekunde angeben</translation>
    </message>
    <message>
        <source>a curve of &quot;%1&quot; has no keys</source>
        <translation>eine Kurve von „%1“ hat keine Schlüssel</translation>
    </message>
    <message>
        <source>a curve of &quot;%1&quot;</source>
        <translation>eine Kurve von „%1“</translation>
    </message>
    <message>
        <source>%1 has %2 times and %3 values</source>
        <translation>%1 hat %2 Zeiten und %3 Werte</translation>
    </message>
    <message>
        <source>the key times of %1 do not increase</source>
        <translation>die Zeiten der Schlüssel von %1 steigen nicht an</translation>
    </message>
    <message>
        <source>%1 has a key that is absurd or no number</source>
        <translation>%1 hat einen Schlüssel, der unsinnig oder keine Zahl ist</translation>
    </message>
    <message>
        <source>%1 has no whole keys</source>
        <translation>%1 hat keine vollständigen Schlüssel</translation>
    </message>
    <message>
        <source>%1 does not say how it goes from key to key</source>
        <translation>%1 sagt nicht, wie es von Schlüssel zu Schlüssel geht</translation>
    </message>
    <message>
        <source>%1 has keys that cannot be unpacked or do not increase</source>
        <translation>%1 hat Schlüssel, die sich nicht entpacken lassen oder nicht ansteigen</translation>
    </message>
    <message>
        <source>%1 has tangents that are not given</source>
        <translation>%1 hat Tangenten, die nicht angegeben sind</translation>
    </message>
    <message>
        <source>%1 does not say how it goes on after every key</source>
        <translation>%1 sagt nicht, wie es nach jedem Schlüssel weitergeht</translation>
    </message>
    <message>
        <source>it has %1 nodes, %2 animations and %3 skins</source>
        <translation>sie hat %1 Knoten, %2 Animationen und %3 Häute</translation>
    </message>
    <message>
        <source>its animation is too long to be read</source>
        <translation>ihre Animation ist zu lang zum Lesen</translation>
    </message>
    <message>
        <source>the animation of &quot;%1&quot; has more keys than can be read</source>
        <translation>die Animation von „%1“ hat mehr Schlüssel, als sich lesen lassen</translation>
    </message>
    <message>
        <source>the mesh &quot;%1&quot;</source>
        <translation>das Netz „%1“</translation>
    </message>
    <message>
        <source>%1 has no vertices or no polygons</source>
        <translation>%1 hat keine Punkte oder keine Vielecke</translation>
    </message>
    <message>
        <source>%1 has vertices that are not three sane numbers each</source>
        <translation>%1 hat Punkte, die nicht je drei sinnvolle Zahlen sind</translation>
    </message>
    <message>
        <source>%1 is bound absurdly far away</source>
        <translation>%1 ist unsinnig weit weg gebunden</translation>
    </message>
    <message>
        <source>%1 has a corner at vertex %2 of %3</source>
        <translation>%1 hat eine Ecke an Punkt %2 von %3</translation>
    </message>
    <message>
        <source>%1 has a polygon without an end, or none</source>
        <translation>%1 hat ein Vieleck ohne Ende oder keines</translation>
    </message>
    <message>
        <source>%1 has no %2 matrix</source>
        <translation>%1 hat keine Matrix %2</translation>
    </message>
    <message>
        <source>%1 has a %2 matrix that is none</source>
        <translation>%1 hat eine Matrix %2, die keine ist</translation>
    </message>
    <message>
        <source>the skin of &quot;%1&quot; on &quot;%2&quot;</source>
        <translation>die Haut von „%1“ an „%2“</translation>
    </message>
    <message>
        <source>%1 has a bone of no size</source>
        <translation>%1 hat einen Knochen ohne Größe</translation>
    </message>
    <message>
        <source>%1 has %2 vertices and %3 weights</source>
        <translation>%1 hat %2 Punkte und %3 Gewichte</translation>
    </message>
    <message>
        <source>%1 moves vertex %2 of %3</source>
        <translation>%1 bewegt Punkt %2 von %3</translation>
    </message>
    <message>
        <source>has no bones</source>
        <translation>hat keine Knochen</translation>
    </message>
    <message>
        <source>export the skeleton along with the animation</source>
        <translation>das Skelett zusammen mit der Animation exportieren</translation>
    </message>
    <message>
        <source>has several layers of animation</source>
        <translation>hat mehrere Ebenen von Animation</translation>
    </message>
    <message>
        <source>bake them into one</source>
        <translation>sie in eine backen</translation>
    </message>
    <message>
        <source>%1 has a number that is absurd or none</source>
        <translation>%1 hat eine Zahl, die unsinnig oder keine ist</translation>
    </message>
    <message>
        <source>has bones that are absurdly far away</source>
        <translation>hat Knochen, die unsinnig weit weg sind</translation>
    </message>
    <message>
        <source>check its unit and scale</source>
        <translation>Einheit und Maßstab prüfen</translation>
    </message>
    <message>
        <source>has %1 skeletons, one with %2 bones</source>
        <translation>hat %1 Skelette, eines mit %2 Knochen</translation>
    </message>
    <message>
        <source>export only what is to be animated</source>
        <translation>nur exportieren, was animiert werden soll</translation>
    </message>
    <message>
        <source>cannot be understood (%1)</source>
        <translation>ist nicht zu verstehen (%1)</translation>
    </message>
    <message>
        <source>is FBX as text</source>
        <translation>ist FBX als Text</translation>
    </message>
    <message>
        <source>is not an FBX file</source>
        <translation>ist keine FBX-Datei</translation>
    </message>
    <message>
        <source>save it as binary FBX</source>
        <translation>als binäres FBX speichern</translation>
    </message>
    <message>
        <source>is FBX of version %1.%2</source>
        <translation>ist FBX der Version %1.%2</translation>
    </message>
    <message>
        <source>save it as FBX 2011 or newer (7.1 to 7.7)</source>
        <translation>als FBX 2011 oder neuer (7.1 bis 7.7) speichern</translation>
    </message>
    <message>
        <source>a record is cut off</source>
        <translation>ein Eintrag ist abgeschnitten</translation>
    </message>
    <message>
        <source>there is something behind the last record of a group</source>
        <translation>hinter dem letzten Eintrag einer Gruppe steht noch etwas</translation>
    </message>
    <message>
        <source>a record reaches beyond its place</source>
        <translation>ein Eintrag reicht über seinen Platz hinaus</translation>
    </message>
    <message>
        <source>there are more records than any program writes</source>
        <translation>es sind mehr Einträge, als ein Programm schreibt</translation>
    </message>
    <message>
        <source>records lie in each other deeper than any program writes</source>
        <translation>Einträge liegen tiefer ineinander, als ein Programm schreibt</translation>
    </message>
    <message>
        <source>a record&apos;s properties have another size than it says</source>
        <translation>die Eigenschaften eines Eintrags haben eine andere Größe, als er sagt</translation>
    </message>
    <message>
        <source>a record ends elsewhere than it says</source>
        <translation>ein Eintrag endet woanders, als er sagt</translation>
    </message>
    <message>
        <source>a property is missing</source>
        <translation>eine Eigenschaft fehlt</translation>
    </message>
    <message>
        <source>a property is of no known type</source>
        <translation>eine Eigenschaft hat keinen bekannten Typ</translation>
    </message>
    <message>
        <source>a property is cut off</source>
        <translation>eine Eigenschaft ist abgeschnitten</translation>
    </message>
    <message>
        <source>an array does not have the size that it says</source>
        <translation>eine Liste hat nicht die Größe, die sie nennt</translation>
    </message>
    <message>
        <source>%1, byte %2</source>
        <translation>%1, Byte %2</translation>
    </message>
    <message>
        <source>check that the file is whole, or export it again</source>
        <translation>prüfen, ob die Datei vollständig ist, oder sie noch einmal exportieren</translation>
    </message>
    <message>
        <source>%1 is not a list of numbers</source>
        <translation>%1 ist keine Liste von Zahlen</translation>
    </message>
    <message>
        <source>its lists of numbers are too long to be read</source>
        <translation>ihre Zahlenlisten sind zu lang zum Lesen</translation>
    </message>
    <message>
        <source>%1 cannot be unpacked to %2 numbers</source>
        <translation>%1 lässt sich nicht zu %2 Zahlen entpacken</translation>
    </message>
    <message>
        <source>there are no objects in it</source>
        <translation>es sind keine Objekte darin</translation>
    </message>
    <message>
        <source>there are more connections than any program writes</source>
        <translation>es sind mehr Verbindungen, als ein Programm schreibt</translation>
    </message>
    <message>
        <source>bones hang on each other deeper than in any skeleton</source>
        <translation>Knochen hängen tiefer aneinander als in jedem Skelett</translation>
    </message>
    <message>
        <source>&quot;%1&quot; hangs on itself</source>
        <translation>„%1“ hängt an sich selbst</translation>
    </message>
    <message>
        <source>the clip does not fit into an FBX 7.4 file (4 GB)</source>
        <translation>der Clip passt nicht in eine Datei in FBX 7.4 (4 GB)</translation>
    </message>
    <message>
        <source>cut it into shorter ones or write fewer frames a second</source>
        <translation>ihn in kürzere teilen oder weniger Bilder je Sekunde schreiben</translation>
    </message>
    <message>
        <source>it has %1 nodes</source>
        <translation>sie hat %1 Knoten</translation>
    </message>
    <message>
        <source>export it again from the program that made it</source>
        <translation>aus ihrem Programm noch einmal exportieren</translation>
    </message>
    <message>
        <source>/nodes/%1/children: node %2 does not exist</source>
        <translation>/nodes/%1/children: Knoten %2 gibt es nicht</translation>
    </message>
    <message>
        <source>/nodes/%1: is the child of two nodes</source>
        <translation>/nodes/%1: hängt an zwei Knoten</translation>
    </message>
    <message>
        <source>/nodes/%1: is its own ancestor</source>
        <translation>/nodes/%1: ist sein eigener Vorfahr</translation>
    </message>
    <message>
        <source>/skins/%1/joints: node %2 does not exist</source>
        <translation>/skins/%1/joints: Knoten %2 gibt es nicht</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is scaled differently along its axes; the mean counts</source>
        <translation>„%1“ ist entlang seiner Achsen verschieden skaliert; es gilt das Mittel</translation>
    </message>
    <message>
        <source>apply the scale in the program that made it</source>
        <translation>die Skalierung in seinem Programm anwenden</translation>
    </message>
    <message>
        <source>/nodes/%1: its place or scale is not a usable number</source>
        <translation>/nodes/%1: sein Ort oder Maßstab ist keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>does not fit into a glTF file (4 GB)</source>
        <translation>passt nicht in eine glTF-Datei (4 GB)</translation>
    </message>
    <message>
        <source>export a part of it or fewer frames a second</source>
        <translation>einen Teil oder weniger Bilder je Sekunde exportieren</translation>
    </message>
    <message>
        <source>cannot be written as glTF</source>
        <translation>lässt sich nicht als glTF schreiben</translation>
    </message>
    <message>
        <source>export again</source>
        <translation>noch einmal exportieren</translation>
    </message>
    <message>
        <source>node %1 gets its %2 from two channels</source>
        <translation>Knoten %1 bekommt sein %2 aus zwei Kanälen</translation>
    </message>
    <message>
        <source>movement of &quot;%1&quot; is left out</source>
        <translation>Bewegung von „%1“ wird weggelassen</translation>
    </message>
    <message>
        <source>bake it into rotations and translations of bones</source>
        <translation>sie in Drehungen und Verschiebungen von Knochen backen</translation>
    </message>
    <message>
        <source>its sampler does not exist</source>
        <translation>seinen Sampler gibt es nicht</translation>
    </message>
    <message>
        <source>its keys are not whole</source>
        <translation>seine Schlüssel sind nicht vollständig</translation>
    </message>
    <message>
        <source>it has more keys than can be read</source>
        <translation>er hat mehr Schlüssel, als sich lesen lassen</translation>
    </message>
    <message>
        <source>the time of key %1 is not later than the one before</source>
        <translation>die Zeit von Schlüssel %1 liegt nicht nach der davor</translation>
    </message>
    <message>
        <source>key %1 is not a usable number</source>
        <translation>Schlüssel %1 ist keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>has no skeleton</source>
        <translation>hat kein Skelett</translation>
    </message>
    <message>
        <source>export it with its armature</source>
        <translation>zusammen mit dem Skelett exportieren</translation>
    </message>
    <message>
        <source>has %1 skeletons and %2 animations</source>
        <translation>hat %1 Skelette und %2 Animationen</translation>
    </message>
    <message>
        <source>node &quot;%1&quot;</source>
        <translation>Knoten „%1“</translation>
    </message>
    <message>
        <source>its mesh or skin does not exist</source>
        <translation>sein Netz oder seine Haut gibt es nicht</translation>
    </message>
    <message>
        <source>its inverse bind matrices are not whole</source>
        <translation>seine inversen Bindematrizen sind nicht vollständig</translation>
    </message>
    <message>
        <source>inverse bind matrix %1 cannot be used</source>
        <translation>die inverse Bindematrix %1 ist nicht brauchbar</translation>
    </message>
    <message>
        <source>joint %1 hangs on another tree than joint 0</source>
        <translation>Gelenk %1 hängt an einem anderen Baum als Gelenk 0</translation>
    </message>
    <message>
        <source>is no list of triangles and is left out</source>
        <translation>ist keine Liste von Dreiecken und wird weggelassen</translation>
    </message>
    <message>
        <source>its positions are not whole</source>
        <translation>seine Positionen sind nicht vollständig</translation>
    </message>
    <message>
        <source>there are more vertices than can be read</source>
        <translation>es sind mehr Punkte, als sich lesen lassen</translation>
    </message>
    <message>
        <source>its joints and weights are not whole</source>
        <translation>seine Gelenke und Gewichte sind nicht vollständig</translation>
    </message>
    <message>
        <source>has a skin but no joints and weights</source>
        <translation>hat eine Haut, aber keine Gelenke und Gewichte</translation>
    </message>
    <message>
        <source>vertices follow more than four bones; the four strongest are kept</source>
        <translation>Punkte folgen mehr als vier Knochen; die vier stärksten bleiben</translation>
    </message>
    <message>
        <source>vertex %1 follows joint %2 of %3</source>
        <translation>Punkt %1 folgt Gelenk %2 von %3</translation>
    </message>
    <message>
        <source>its indices are not whole</source>
        <translation>seine Indizes sind nicht vollständig</translation>
    </message>
    <message>
        <source>there are more triangles than can be read</source>
        <translation>es sind mehr Dreiecke, als sich lesen lassen</translation>
    </message>
    <message>
        <source>index %1 is %2 of %3 vertices</source>
        <translation>Index %1 ist %2 von %3 Punkten</translation>
    </message>
    <message>
        <source>is not a glTF file</source>
        <translation>ist keine glTF-Datei</translation>
    </message>
    <message>
        <source>is cut off</source>
        <translation>ist abgeschnitten</translation>
    </message>
    <message>
        <source>is glTF version %1</source>
        <translation>ist glTF der Version %1</translation>
    </message>
    <message>
        <source>use glTF 2.0</source>
        <translation>glTF 2.0 verwenden</translation>
    </message>
    <message>
        <source>is cut off or has something behind its end</source>
        <translation>ist abgeschnitten oder hat hinter dem Ende noch etwas</translation>
    </message>
    <message>
        <source>refers to a file elsewhere, %1</source>
        <translation>verweist auf eine Datei anderswo, %1</translation>
    </message>
    <message>
        <source>is not valid glTF (%1)</source>
        <translation>ist kein gültiges glTF (%1)</translation>
    </message>
    <message>
        <source>an animation channel leads nowhere</source>
        <translation>ein Animationskanal führt nirgendwohin</translation>
    </message>
    <message>
        <source>the keys of an animation channel are not whole or not of the kind that Limbwave writes</source>
        <translation>die Schlüssel eines Animationskanals sind nicht vollständig oder nicht von der Art, die Limbwave schreibt</translation>
    </message>
    <message>
        <source>check that the file was not changed</source>
        <translation>prüfen, ob die Datei geändert wurde</translation>
    </message>
    <message>
        <source>is not a clip that Limbwave wrote</source>
        <translation>ist kein Clip, den Limbwave geschrieben hat</translation>
    </message>
    <message>
        <source>use one from a take&apos;s solves</source>
        <translation>einen aus den Berechnungen eines Takes verwenden</translation>
    </message>
    <message>
        <source>%1: scenes/0/extras</source>
        <translation>%1: scenes/0/extras</translation>
    </message>
    <message>
        <source>is not step, linear or cubic</source>
        <translation>ist weder step noch linear noch cubic</translation>
    </message>
    <message>
        <source>it has fewer nodes than its skeleton has segments</source>
        <translation>er hat weniger Knoten, als sein Skelett Segmente hat</translation>
    </message>
    <message>
        <source>the times of its keys do not increase</source>
        <translation>die Zeiten seiner Schlüssel steigen nicht an</translation>
    </message>
    <message>
        <source>a key is not a number</source>
        <translation>ein Schlüssel ist keine Zahl</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 times and %3 values</source>
        <translation>„%1“ hat %2 Zeiten und %3 Werte</translation>
    </message>
    <message>
        <source>a take&apos;s clip has no place for %1</source>
        <translation>der Clip eines Takes hat keinen Platz für %1</translation>
    </message>
    <message>
        <source>export it to a file of its own</source>
        <translation>in eine eigene Datei exportieren</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, which slides</source>
        <translation>„%1“, das gleitet</translation>
    </message>
    <message>
        <source>joints without a bone</source>
        <translation>Gelenke ohne Knochen</translation>
    </message>
    <message>
        <source>velocities and ways of single keys</source>
        <translation>Geschwindigkeiten und Wege einzelner Schlüssel</translation>
    </message>
    <message>
        <source>the rest pose of &quot;%1&quot; is not a number</source>
        <translation>die Ruhepose von „%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>root position</source>
        <translation>Ort der Wurzel</translation>
    </message>
    <message>
        <source>the clip does not fit into a glTF file (4 GB)</source>
        <translation>der Clip passt nicht in eine glTF-Datei (4 GB)</translation>
    </message>
    <message>
        <source>cut it into shorter ones</source>
        <translation>ihn in kürzere teilen</translation>
    </message>
    <message>
        <source>the clip cannot be written as glTF</source>
        <translation>der Clip lässt sich nicht als glTF schreiben</translation>
    </message>
    <message>
        <source>save the mesh as .obj, .glb or .fbx</source>
        <translation>das Netz als .obj, .glb oder .fbx speichern</translation>
    </message>
    <message>
        <source>is no mesh that can be read</source>
        <translation>ist kein Netz, das sich lesen lässt</translation>
    </message>
    <message>
        <source>save it as .obj, .glb or .fbx</source>
        <translation>als .obj, .glb oder .fbx speichern</translation>
    </message>
    <message>
        <source>cannot be read as a mesh (%1)</source>
        <translation>lässt sich nicht als Netz lesen (%1)</translation>
    </message>
    <message>
        <source>has more than ten million triangles</source>
        <translation>hat mehr als zehn Millionen Dreiecke</translation>
    </message>
    <message>
        <source>simplify it first</source>
        <translation>es zuerst vereinfachen</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>hat keine Dreiecke</translation>
    </message>
    <message>
        <source>choose a file with a mesh</source>
        <translation>eine Datei mit einem Netz wählen</translation>
    </message>
    <message>
        <source>reading the mesh</source>
        <translation>das Netz wird gelesen</translation>
    </message>
    <message>
        <source>use one of %1</source>
        <translation>eines von %1 verwenden</translation>
    </message>
    <message>
        <source>puts movement on a root bone that is not there</source>
        <translation>legt Bewegung auf einen Wurzelknochen, den es nicht gibt</translation>
    </message>
    <message>
        <source>set &quot;root&quot; to &quot;bone&quot;</source>
        <translation>„root“ auf „bone“ setzen</translation>
    </message>
    <message>
        <source>%1 needs bones that the skeleton lacks: %2</source>
        <translation>%1 braucht Knochen, die dem Skelett fehlen: %2</translation>
    </message>
    <message>
        <source>capture a whole body, choose another preset, or name the bones in a bone map</source>
        <translation>einen ganzen Körper aufnehmen, eine andere Vorgabe wählen oder die Knochen in einer Namensliste benennen</translation>
    </message>
    <message>
        <source>export a clip with a skeleton</source>
        <translation>einen Clip mit Skelett exportieren</translation>
    </message>
    <message>
        <source>nothing was written; choose another format or preset, and report this file</source>
        <translation>es wurde nichts geschrieben; ein anderes Format oder eine andere Vorgabe wählen und diese Datei melden</translation>
    </message>
    <message>
        <source>the written file has &quot;%1&quot; %2 mm away from where it belongs at frame %3 (%4 s)</source>
        <translation>die geschriebene Datei hat „%1“ in Bild %3 (%4 s) um %2 mm neben seinem Platz</translation>
    </message>
    <message>
        <source>the written file has %1 actors instead of %2</source>
        <translation>die geschriebene Datei hat %1 Darsteller statt %2</translation>
    </message>
    <message>
        <source>the written file has %1 bones instead of %2</source>
        <translation>die geschriebene Datei hat %1 Knochen statt %2</translation>
    </message>
    <message>
        <source>the written file ends before frame %1</source>
        <translation>die geschriebene Datei endet vor Bild %1</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>das Ende der Datei</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>das Ende der Zeile</translation>
    </message>
    <message>
        <source>the cost of the whole take fell by %1 % in %2 rounds</source>
        <translation>die Kosten des ganzen Takes fielen in %2 Runden um %1 %</translation>
    </message>
    <message>
        <source>noises by the likelihood of the first %1 s: %2; its logarithm rose by %3</source>
        <translation>Rauschen nach der Likelihood der ersten %1 s: %2; ihr Logarithmus stieg um %3</translation>
    </message>
    <message>
        <source>Driver box on %1%2</source>
        <translation>Treiberbox an %1%2</translation>
    </message>
    <message>
        <source>Driver box emulator %1</source>
        <translation>Emulator einer Treiberbox %1</translation>
    </message>
    <message>
        <source>%1 as a driver box</source>
        <translation>%1 als Treiberbox</translation>
    </message>
    <message>
        <source>wire %1 was pulled before</source>
        <translation>Kabel %1 war vorher schon gezogen</translation>
    </message>
    <message>
        <source>a factor at the end of its range says that the errors are not noise: compare with a solve without</source>
        <translation>ein Faktor am Ende seines Bereichs besagt, dass die Fehler kein Rauschen sind: mit einer Berechnung ohne ihn vergleichen</translation>
    </message>
    <message>
        <source>is of another version</source>
        <translation>stammt von einer anderen Version</translation>
    </message>
    <message>
        <source>save the state again with this version</source>
        <translation>den Zustand mit dieser Version neu speichern</translation>
    </message>
    <message>
        <source>must be inclination, filter, smoother or batch</source>
        <translation>muss inclination, filter, smoother oder batch sein</translation>
    </message>
    <message>
        <source>must name some of A, G and D</source>
        <translation>muss einige von A, G und D nennen</translation>
    </message>
    <message>
        <source>is gone</source>
        <translation>ist fort</translation>
    </message>
    <message>
        <source>check that it is still connected, and open it again</source>
        <translation>prüfen Sie, ob es noch angeschlossen ist, und öffnen Sie es neu</translation>
    </message>
    <message>
        <source>has no measured calibration of sources</source>
        <translation>hat keine gemessene Kalibrierung der Quellen</translation>
    </message>
    <message>
        <source>name another take of this driver box</source>
        <translation>nennen Sie einen anderen Take dieser Treiberbox</translation>
    </message>
    <message>
        <source>has other sources than the rig &quot;%1&quot;</source>
        <translation>hat andere Quellen als das Rig „%1“</translation>
    </message>
    <message>
        <source>name a take of the same driver box and rig</source>
        <translation>nennen Sie einen Take derselben Treiberbox mit demselben Rig</translation>
    </message>
    <message>
        <source>has no driver box in its rig</source>
        <translation>hat keine Treiberbox in seinem Rig</translation>
    </message>
    <message>
        <source>give it the rig it was recorded with</source>
        <translation>geben Sie ihm das Rig, mit dem er aufgenommen wurde</translation>
    </message>
    <message>
        <source>the root&apos;s place is told by its feet for %1 % of the time, and by its own acceleration for the rest</source>
        <translation>der Ort der Wurzel kommt %1 % der Zeit von ihren Füßen, sonst von ihrer eigenen Beschleunigung</translation>
    </message>
    <message>
        <source>feet that glide or float tell little: give the root&apos;s path</source>
        <translation>gleitende oder schwebende Füße sagen wenig: den Weg der Wurzel angeben</translation>
    </message>
    <message>
        <source>the pose in which the take begins was found from its first seconds</source>
        <translation>die Pose, mit der der Take beginnt, wurde aus seinen ersten Sekunden gefunden</translation>
    </message>
    <message>
        <source>root fixed: it stays at its place</source>
        <translation>Wurzel fest: sie bleibt an ihrem Ort</translation>
    </message>
    <message>
        <source>root by the feet that stand (contacts)</source>
        <translation>Wurzel nach den stehenden Füßen (contacts)</translation>
    </message>
    <message>
        <source>root free: by its own acceleration alone</source>
        <translation>Wurzel frei: nur nach ihrer eigenen Beschleunigung</translation>
    </message>
    <message>
        <source>root given: %1</source>
        <translation>Wurzel vorgegeben: %1</translation>
    </message>
    <message>
        <source>; its place is uncertain by %1 m along the ground and %2 m in height at the end (1 σ)</source>
        <translation>; ihr Ort ist am Ende um %1 m entlang des Bodens und %2 m in der Höhe unsicher (1 σ)</translation>
    </message>
    <message>
        <source>choose --root contacts for somebody who stands or walks, or give its path</source>
        <translation>für jemanden, der steht oder geht, --root contacts wählen, oder ihren Weg angeben</translation>
    </message>
</context>
<context>
    <name>CoreServices</name>
    <message>
        <source>Simulator: %1</source>
        <translation>Simulator: %1</translation>
    </message>
    <message>
        <source>%1 as a driver box</source>
        <translation>%1 als Treiberbox</translation>
    </message>
    <message>
        <source>Driver box emulator %1</source>
        <translation>Emulator einer Treiberbox %1</translation>
    </message>
    <message>
        <source>Driver box at %1</source>
        <translation>Treiberbox an %1</translation>
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
        <source>FBX</source>
        <translation>FBX</translation>
    </message>
    <message>
        <source>Skeleton, motion and skinned body; Blender, Maya, MotionBuilder, Unreal and Unity read it</source>
        <translation>Skelett, Bewegung und Körper; lesbar für Blender, Maya, MotionBuilder, Unreal und Unity</translation>
    </message>
    <message>
        <source>glTF, binary (.glb)</source>
        <translation>glTF, binär (.glb)</translation>
    </message>
    <message>
        <source>Skeleton, motion and skinned body in one file; Blender, Unreal and web viewers read it</source>
        <translation>Skelett, Bewegung und Körper in einer Datei; lesbar für Blender, Unreal und Webseiten</translation>
    </message>
    <message>
        <source>glTF, text (.gltf)</source>
        <translation>glTF, Text (.gltf)</translation>
    </message>
    <message>
        <source>The same as readable JSON, a third larger</source>
        <translation>Dasselbe als lesbares JSON, ein Drittel größer</translation>
    </message>
    <message>
        <source>VRM 1.0 (.vrm)</source>
        <translation>VRM 1.0 (.vrm)</translation>
    </message>
    <message>
        <source>An avatar with its bones marked, for VRM viewers</source>
        <translation>Ein Avatar mit gekennzeichneten Knochen für VRM-Programme</translation>
    </message>
    <message>
        <source>One skeleton and its motion as text, without a body; Blender and MotionBuilder read it</source>
        <translation>Ein Skelett und seine Bewegung als Text, ohne Körper; lesbar für Blender und MotionBuilder</translation>
    </message>
    <message>
        <source>CSV, poses as a table</source>
        <translation>CSV, Posen als Tabelle</translation>
    </message>
    <message>
        <source>Where every bone is in every frame, for spreadsheets and scripts</source>
        <translation>Wo jeder Knochen in jedem Bild ist, für Tabellen und Skripte</translation>
    </message>
</context>
<context>
    <name>ExportEdits</name>
    <message>
        <source>motion of the export</source>
        <translation>Bewegung des Exports</translation>
    </message>
    <message>
        <source>actors of the export</source>
        <translation>Darsteller des Exports</translation>
    </message>
    <message>
        <source>program of the export</source>
        <translation>Programm des Exports</translation>
    </message>
    <message>
        <source>format of the export</source>
        <translation>Format des Exports</translation>
    </message>
    <message>
        <source>frame rate of the export</source>
        <translation>Bildrate des Exports</translation>
    </message>
    <message>
        <source>range of the export</source>
        <translation>Bereich des Exports</translation>
    </message>
    <message>
        <source>way over the floor in the export</source>
        <translation>Weg über den Boden in des Exports</translation>
    </message>
    <message>
        <source>rest pose of the export</source>
        <translation>Ruhepose des Exports</translation>
    </message>
    <message>
        <source>bone names of the export</source>
        <translation>Knochennamen des Exports</translation>
    </message>
    <message>
        <source>unit of the export</source>
        <translation>Längeneinheit des Exports</translation>
    </message>
    <message>
        <source>keys of the export</source>
        <translation>Schlüssel des Exports</translation>
    </message>
    <message>
        <source>body of the export</source>
        <translation>Körper des Exports</translation>
    </message>
    <message>
        <source>file of the export</source>
        <translation>Datei des Exports</translation>
    </message>
</context>
<context>
    <name>ExportWords</name>
    <message>
        <source>%1 (your own)</source>
        <translation>%1 (eigene)</translation>
    </message>
    <message>
        <source>in place</source>
        <translation>auf der Stelle</translation>
    </message>
    <message>
        <source>on the root bone</source>
        <translation>auf dem Wurzelknochen</translation>
    </message>
    <message>
        <source>free, on the hips</source>
        <translation>frei, auf der Hüfte</translation>
    </message>
    <message>
        <source>T-pose</source>
        <translation>T-Pose</translation>
    </message>
    <message>
        <source>as captured</source>
        <translation>wie aufgenommen</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Metern</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimetern</translation>
    </message>
    <message>
        <source>Bones keep their names.</source>
        <translation>Die Knochen behalten ihre Namen.</translation>
    </message>
    <message>
        <source>Bones are named as in %1.</source>
        <translation>Die Knochen heißen wie in %1.</translation>
    </message>
    <message>
        <source>Every bone has the world&apos;s axes.</source>
        <translation>Jeder Knochen hat die Achsen der Welt.</translation>
    </message>
    <message>
        <source>Every bone points along its own %1 axis.</source>
        <translation>Jeder Knochen zeigt entlang seiner eigenen %1-Achse.</translation>
    </message>
    <message>
        <source>Bones keep their axes.</source>
        <translation>Die Knochen behalten ihre Achsen.</translation>
    </message>
    <message>
        <source>At rest the figure stands in a T-pose.</source>
        <translation>In Ruhe steht die Figur in der T-Pose.</translation>
    </message>
    <message>
        <source>The rest pose stays as captured.</source>
        <translation>Die Ruhepose bleibt wie aufgenommen.</translation>
    </message>
    <message>
        <source>At rest the soles are at height 0.</source>
        <translation>In Ruhe sind die Sohlen auf Höhe 0.</translation>
    </message>
    <message>
        <source>Frame 0 shows the rest pose; the motion starts on frame 1.</source>
        <translation>Bild 0 zeigt die Ruhepose; die Bewegung beginnt mit Bild 1.</translation>
    </message>
    <message>
        <source>The hips hang on a bone “%1”, which goes the way over the floor.</source>
        <translation>Die Hüfte hängt an einem Knochen „%1“, der den Weg über den Boden geht.</translation>
    </message>
    <message>
        <source>The hips hang on a bone “%1” at the origin.</source>
        <translation>Die Hüfte hängt an einem Knochen „%1“ im Ursprung.</translation>
    </message>
    <message>
        <source>The way over the floor is taken out: the figure moves in place.</source>
        <translation>Der Weg über den Boden ist herausgenommen: Die Figur bewegt sich auf der Stelle.</translation>
    </message>
    <message>
        <source>The hips go the way over the floor.</source>
        <translation>Die Hüfte geht den Weg über den Boden.</translation>
    </message>
    <message>
        <source>Lengths are in %1.</source>
        <translation>Längen sind in %1.</translation>
    </message>
    <message>
        <source>The %1 bones that the program asks for must be there.</source>
        <translation>Die %1 Knochen, die das Programm verlangt, müssen da sein.</translation>
    </message>
    <message>
        <source>%1 does not open %2 files by itself. Choose %3 for it.</source>
        <translation>%1 öffnet %2-Dateien nicht von sich aus. Dafür %3 wählen.</translation>
    </message>
    <message>
        <source>Blender keeps its own frame rate unless “Update Scene FPS” is on in its BVH import.</source>
        <translation>Blender behält seine eigene Bildrate, wenn beim BVH-Import „Update Scene FPS“ nicht an ist.</translation>
    </message>
    <message>
        <source>Viewers refuse a .vrm without the bones and the T-pose of the VRM 1.0 preset.</source>
        <translation>Programme weisen eine .vrm ohne die Knochen und die T-Pose der Vorgabe VRM 1.0 zurück.</translation>
    </message>
    <message>
        <source>Unreal Engine refuses bones without a body. Keep the mannequin.</source>
        <translation>Unreal Engine weist Knochen ohne Körper zurück. Die Gliederpuppe behalten.</translation>
    </message>
    <message>
        <source>Most programs make empties instead of bones of a glTF file without a body.</source>
        <translation>Die meisten Programme machen aus einer glTF-Datei ohne Körper leere Objekte statt Knochen.</translation>
    </message>
    <message>
        <source>Unreal Engine counts in centimetres: in metres the figure arrives 100 times too small.</source>
        <translation>Unreal Engine rechnet in Zentimetern: In Metern kommt die Figur 100-mal zu klein an.</translation>
    </message>
    <message>
        <source>%1 finds the joints of a character by the T-pose on frame 0.</source>
        <translation>%1 findet die Gelenke einer Figur an der T-Pose in Bild 0.</translation>
    </message>
    <message>
        <source>The bones do not look like a person&apos;s: they keep their names and their rest pose.</source>
        <translation>Die Knochen sehen nicht nach einem Menschen aus: Sie behalten ihre Namen und ihre Ruhepose.</translation>
    </message>
    <message>
        <source>The motion has %1 frames a second; the frames in between are interpolated.</source>
        <translation>Die Bewegung hat %1 Bilder je Sekunde; die Bilder dazwischen sind interpoliert.</translation>
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
        <source>never calibrated; calibrate its range</source>
        <translation>nie kalibriert; Bereich kalibrieren</translation>
    </message>
</context>
<context>
    <name>LatencyText</name>
    <message>
        <source>sensor to screen %1 ms mean, %2 ms for 95 %, %3 ms at most</source>
        <translation>vom Sensor bis zum Bildschirm im Mittel %1 ms, bei 95 % %2 ms, höchstens %3 ms</translation>
    </message>
    <message>
        <source>From the board&apos;s reading of its oldest sensor to the finished picture: %1 ms on average, %2 ms for 95 of 100 poses, %3 ms at most (%4 poses).</source>
        <translation>Vom Ablesen des ältesten Sensors auf der Platine bis zum fertigen Bild: im Mittel %1 ms, bei 95 von 100 Posen %2 ms, höchstens %3 ms (%4 Posen).</translation>
    </message>
    <message>
        <source>From the board&apos;s reading of its oldest sensor to the solved pose (nothing is drawn): %1 ms on average, %2 ms for 95 of 100 poses, %3 ms at most (%4 poses).</source>
        <translation>Vom Ablesen des ältesten Sensors auf der Platine bis zur berechneten Pose (gezeichnet wird nichts): im Mittel %1 ms, bei 95 von 100 Posen %2 ms, höchstens %3 ms (%4 Posen).</translation>
    </message>
    <message>
        <source>On average: one round of the board %1 ms, waiting for samples %2 ms, solving %3 ms, handing over %4 ms, drawing %5 ms.</source>
        <translation>Im Mittel: ein Umlauf der Platine %1 ms, Warten auf Abtastwerte %2 ms, Berechnen %3 ms, Übergabe %4 ms, Zeichnen %5 ms.</translation>
    </message>
    <message>
        <source>Not counted: the sound card&apos;s own buffer (%1 ms) and what the screen itself needs.</source>
        <translation>Nicht mitgezählt: der Puffer der Soundkarte (%1 ms) und was der Bildschirm selbst braucht.</translation>
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
    <name>Manual</name>
    <message>
        <source>From sensors to an animation</source>
        <translation>Von den Sensoren zur Animation</translation>
    </message>
    <message>
        <source>Wiring and the signal</source>
        <translation>Verkabelung und Signal</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>Calibrating the range</source>
        <translation>Den Bereich kalibrieren</translation>
    </message>
    <message>
        <source>Calibrating the mounting</source>
        <translation>Die Befestigung kalibrieren</translation>
    </message>
    <message>
        <source>Recording alone</source>
        <translation>Allein aufnehmen</translation>
    </message>
    <message>
        <source>With a portable recorder</source>
        <translation>Mit einem tragbaren Rekorder</translation>
    </message>
    <message>
        <source>Solving and exporting</source>
        <translation>Berechnen und exportieren</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>en</source>
        <comment>language of the manual</comment>
        <extracomment>Folder of resources/manual that holds the chapters in your language: its code, &quot;de&quot;. Without one leave it as it is.</extracomment>
        <translation>de</translation>
    </message>
    <message>
        <source>The driver box</source>
        <translation>Die Treiberbox</translation>
    </message>
</context>
<context>
    <name>ManualPicture</name>
    <message>
        <source>too low</source>
        <translation>zu niedrig</translation>
    </message>
    <message>
        <source>noise is as large as the signal</source>
        <translation>Rauschen so groß wie das Signal</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>peaks stay in the green zone</source>
        <translation>Spitzen bleiben im Grünen</translation>
    </message>
    <message>
        <source>too high</source>
        <translation>zu hoch</translation>
    </message>
    <message>
        <source>peaks are cut off</source>
        <translation>Spitzen sind abgeschnitten</translation>
    </message>
    <message>
        <source>1  horizontal: forward, level, palm down</source>
        <translation>1  waagerecht nach vorn, Handfläche nach unten</translation>
    </message>
    <message>
        <source>2  vertical: hanging, palm to the rear</source>
        <translation>2  hängend, Handfläche nach hinten</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>sensor 1: x y z</source>
        <translation>Sensor 1: x y z</translation>
    </message>
    <message>
        <source>sensor 2: x y z</source>
        <translation>Sensor 2: x y z</translation>
    </message>
    <message>
        <source>sensor 3: x y z</source>
        <translation>Sensor 3: x y z</translation>
    </message>
    <message>
        <source>sensor 4: x y z</source>
        <translation>Sensor 4: x y z</translation>
    </message>
    <message>
        <source>sensor 5: x y z</source>
        <translation>Sensor 5: x y z</translation>
    </message>
    <message>
        <source>ref.</source>
        <translation>Ref.</translation>
    </message>
    <message>
        <source>low</source>
        <translation>tief</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>every face looks up once, then edges and corners: slowly, about ten seconds for a full turn</source>
        <translation>jede Fläche einmal nach oben, dann Kanten und Ecken: langsam, etwa zehn Sekunden je Drehung</translation>
    </message>
    <message>
        <source>sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>five, worn</source>
        <translation>fünf, am Körper</translation>
    </message>
    <message>
        <source>line input</source>
        <translation>Line-Eingang</translation>
    </message>
    <message>
        <source>stereo, 44.1 kHz or more</source>
        <translation>stereo, ab 44,1 kHz</translation>
    </message>
    <message>
        <source>take</source>
        <translation>Take</translation>
    </message>
    <message>
        <source>raw samples, kept</source>
        <translation>rohe Abtastwerte</translation>
    </message>
    <message>
        <source>solve</source>
        <translation>berechnen</translation>
    </message>
    <message>
        <source>skeleton, keys</source>
        <translation>Skelett, Schlüssel</translation>
    </message>
    <message>
        <source>export</source>
        <translation>exportieren</translation>
    </message>
    <message>
        <source>FBX, BVH, glTF, CSV</source>
        <translation>FBX, BVH, glTF, CSV</translation>
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
        <translation>Schnelle Drehungen</translation>
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
        <translation>Zum Glas greifen</translation>
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
    <message>
        <source>Turning the sensors</source>
        <translation>Sensoren drehen</translation>
    </message>
    <message>
        <source>For the range calibration</source>
        <translation>Für die Kalibrierung des Messbereichs</translation>
    </message>
    <message>
        <source>Holding the poses</source>
        <translation>Posen halten</translation>
    </message>
    <message>
        <source>For the mounting calibration</source>
        <translation>Für die Kalibrierung des Sitzes</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Laufen</translation>
    </message>
    <message>
        <source>Quick and hard</source>
        <translation>Schnell und hart</translation>
    </message>
    <message>
        <source>Squats</source>
        <translation>Kniebeugen</translation>
    </message>
    <message>
        <source>Slow, with the whole body</source>
        <translation>Langsam, mit dem ganzen Körper</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>Whole body, eighteen boards and eight ultrasonic sources on a driver box</source>
        <translation>Ganzer Körper, 18 Platinen und 8 Ultraschallquellen</translation>
    </message>
    <message>
        <source>pelvis</source>
        <translation>Becken</translation>
    </message>
    <message>
        <source>abdomen</source>
        <translation>Bauch</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>linke Schulter</translation>
    </message>
    <message>
        <source>left upper arm</source>
        <translation>linker Oberarm</translation>
    </message>
    <message>
        <source>left forearm</source>
        <translation>linker Unterarm</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>rechte Schulter</translation>
    </message>
    <message>
        <source>right upper arm</source>
        <translation>rechter Oberarm</translation>
    </message>
    <message>
        <source>right forearm</source>
        <translation>rechter Unterarm</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
    <message>
        <source>left thigh</source>
        <translation>linker Oberschenkel</translation>
    </message>
    <message>
        <source>left shin</source>
        <translation>linker Unterschenkel</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>linker Fuß</translation>
    </message>
    <message>
        <source>right thigh</source>
        <translation>rechter Oberschenkel</translation>
    </message>
    <message>
        <source>right shin</source>
        <translation>rechter Unterschenkel</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>rechter Fuß</translation>
    </message>
    <message>
        <source>chest upper left</source>
        <translation>Brust oben links</translation>
    </message>
    <message>
        <source>belly left</source>
        <translation>Bauch links</translation>
    </message>
    <message>
        <source>chest lower right</source>
        <translation>Brust unten rechts</translation>
    </message>
    <message>
        <source>hat</source>
        <translation>Hut</translation>
    </message>
    <message>
        <source>chest upper right</source>
        <translation>Brust oben rechts</translation>
    </message>
    <message>
        <source>belly right</source>
        <translation>Bauch rechts</translation>
    </message>
    <message>
        <source>chest lower left</source>
        <translation>Brust unten links</translation>
    </message>
    <message>
        <source>belly middle</source>
        <translation>Bauch Mitte</translation>
    </message>
    <message>
        <source>Right arm, five accelerometers on a sound card</source>
        <translation>Rechter Arm, fünf Beschleunigungssensoren an einer Soundkarte</translation>
    </message>
    <message>
        <source>torso</source>
        <translation>Rumpf</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>Oberarm</translation>
    </message>
    <message>
        <source>forearm</source>
        <translation>Unterarm</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>fingers</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>Right arm</source>
        <translation>Rechter Arm</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>waagerecht</translation>
    </message>
    <message>
        <source>Stretch the right arm forward, level, palm down, fingers straight.</source>
        <translation>Den rechten Arm waagerecht nach vorn strecken, Handfläche nach unten, Finger gerade.</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>Let the right arm hang straight down, palm to the rear, fingers straight.</source>
        <translation>Den rechten Arm gerade herabhängen lassen, Handfläche nach hinten, Finger gerade.</translation>
    </message>
    <message>
        <source>Torso</source>
        <translation>Rumpf</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>aufrecht</translation>
    </message>
    <message>
        <source>Stand upright and look ahead.</source>
        <translation>Aufrecht stehen und geradeaus schauen.</translation>
    </message>
    <message>
        <source>bowed</source>
        <translation>gebeugt</translation>
    </message>
    <message>
        <source>Bow forward from the hips until the back is level.</source>
        <translation>Aus der Hüfte nach vorn beugen, bis der Rücken waagerecht ist.</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>Hals</translation>
    </message>
</context>
<context>
    <name>Preset</name>
    <message>
        <source>Bones lie along their own y, as Blender draws them; metarig names with .L and .R.</source>
        <translation>Knochen liegen entlang ihrer y-Achse, wie Blender sie zeichnet; Metarig-Namen mit .L und .R.</translation>
    </message>
    <message>
        <source>HumanIK names, joints along x, T-pose on frame 0 for characterising.</source>
        <translation>HumanIK-Namen, Gelenke entlang x, T-Pose in Bild 0 für die Charakterisierung.</translation>
    </message>
    <message>
        <source>HumanIK names, T-pose on frame 0, one reference above the hips.</source>
        <translation>HumanIK-Namen, T-Pose in Bild 0, eine Referenz über der Hüfte.</translation>
    </message>
    <message>
        <source>Everything as it was captured: own names, own rest pose, centimetres.</source>
        <translation>Alles wie aufgenommen: eigene Namen, eigene Ruhepose, Zentimeter.</translation>
    </message>
    <message>
        <source>Humanoid names, T-pose at rest, so that the avatar maps without help.</source>
        <translation>Humanoid-Namen, T-Pose in Ruhe, damit sich der Avatar von allein zuordnet.</translation>
    </message>
    <message>
        <source>Mannequin names under a single root, centimetres.</source>
        <translation>Namen der Gliederpuppe unter einer einzigen Wurzel, Zentimeter.</translation>
    </message>
    <message>
        <source>Required humanoid bones, T-pose at rest, soles at height 0, metres.</source>
        <translation>Verlangte Humanoid-Knochen, T-Pose in Ruhe, Sohlen auf Höhe 0, Meter.</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Schlicht</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Einfg</translation>
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
    <message>
        <source>The limb moved fast. Smoothing the whole chain helps.</source>
        <translation>Die Gliedmaße bewegte sich schnell. Die ganze Kette zu glätten hilft.</translation>
    </message>
    <message>
        <source>Whole chain</source>
        <translation>Ganze Kette</translation>
    </message>
    <message>
        <source>All limbs together: what their own swinging makes the sensors feel is taken into account. Check the bone lengths.</source>
        <translation>Alle Gliedmaßen zusammen: was ihr eigenes Schwingen die Sensoren spüren lässt, wird berücksichtigt. Prüfen Sie die Knochenlängen.</translation>
    </message>
    <message>
        <source>Every sensor was heard, but: %1</source>
        <translation>Jeder Sensor war zu hören, aber: %1</translation>
    </message>
    <message>
        <source>Usable: every sensor was heard, but: %1</source>
        <translation>Brauchbar: jeder Sensor war zu hören, aber: %1</translation>
    </message>
    <message>
        <source>Every sensor was heard, but the figure is off by %1.</source>
        <translation>Jeder Sensor war zu hören, aber die Figur liegt daneben: %1.</translation>
    </message>
    <message>
        <source>Fast movement does that: try another smoothing, and check the mounting.</source>
        <translation>Das kommt von schneller Bewegung: Versuchen Sie eine andere Glättung und prüfen Sie die Befestigung.</translation>
    </message>
    <message>
        <source>Good: all boards were heard, and agree.</source>
        <translation>Gut: Alle Platinen waren zu hören und widersprechen sich nicht.</translation>
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
        <translation>Exportieren</translation>
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
        <source>Alt+Left / Alt+Right</source>
        <translation>Alt+Links / Alt+Rechts</translation>
    </message>
    <message>
        <source>Alt+Up / Alt+Down</source>
        <translation>Alt+Auf / Alt+Ab</translation>
    </message>
    <message>
        <source>Turn the selected keys by 1°; with Shift by 0.1°</source>
        <translation>Die gewählten Schlüssel um 1° drehen; mit Umschalt um 0,1°</translation>
    </message>
    <message>
        <source>Delete the selected keys or the selected marker</source>
        <translation>Die gewählten Schlüssel oder die gewählte Marke löschen</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Rename the selected marker</source>
        <translation>Die gewählte Marke umbenennen</translation>
    </message>
    <message>
        <source>Move the selected keys or the selected marker by a frame</source>
        <translation>Die gewählten Schlüssel oder die gewählte Marke um ein Bild verschieben</translation>
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
    <message>
        <source>Live: what you turn now becomes keys here once it is recorded.</source>
        <translation>Live: Was Sie jetzt drehen, wird hier zu Schlüsseln, sobald es aufgenommen ist.</translation>
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
        <source>calibrating</source>
        <translation>wird kalibriert</translation>
    </message>
    <message>
        <source>A calibration is under way; its raw signals are kept in a take of their own.</source>
        <translation>Eine Kalibrierung läuft; ihre Rohsignale werden in einem eigenen Take aufgehoben.</translation>
    </message>
    <message>
        <source>Samples that were lost so far: %1, in %2 gaps. What follows keeps its time.</source>
        <translation>Bisher verlorene Abtastwerte: %1, in %2 Lücken. Was folgt, behält seine Zeit.</translation>
    </message>
    <message>
        <source>box –</source>
        <translation>Box –</translation>
    </message>
    <message>
        <source>The driver box has not been heard yet.</source>
        <translation>Von der Treiberbox ist noch nichts gekommen.</translation>
    </message>
    <message>
        <source>box away</source>
        <translation>Box fort</translation>
    </message>
    <message>
        <source>The driver box does not answer. It is taken back by itself as soon as it does.</source>
        <translation>Die Treiberbox antwortet nicht. Sobald sie es tut, geht es von selbst weiter.</translation>
    </message>
    <message numerus="yes">
        <source>box: %n gap(s)</source>
        <translation>
            <numerusform>Box: %n Lücke</numerusform>
            <numerusform>Box: %n Lücken</numerusform>
        </translation>
    </message>
    <message>
        <source>Gaps on the line: %1, with %2 samples; reconnections: %3. Every gap has its length in the take.</source>
        <translation>Lücken auf der Leitung: %1 mit %2 Abtastwerten; neu verbunden: %3. Jede Lücke steht mit ihrer Länge in der Aufnahme.</translation>
    </message>
    <message>
        <source>(samples were lost)</source>
        <translation>(Abtastwerte gingen verloren)</translation>
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
    <message>
        <source>Record, or stop recording</source>
        <translation>Aufnehmen oder Aufnahme beenden</translation>
    </message>
    <message>
        <source>Record after a countdown of %1 s</source>
        <translation>Nach einem Countdown von %1 s aufnehmen</translation>
    </message>
    <message>
        <source>Set a marker: in the recording, else at the playhead</source>
        <translation>Marke setzen: in der Aufnahme, sonst an der Abspielmarke</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::BoardDialog</name>
    <message>
        <source>Sensor board</source>
        <translation>Sensorplatine</translation>
    </message>
    <message>
        <source>Calibrations are kept per sensor. Name the board on %1, so that another board&apos;s are never taken for its own. Where the sensors carry serials, enter them: they then keep their calibration on any board.</source>
        <translation>Kalibrierungen werden je Sensor aufbewahrt. Benennen Sie die Platine an %1, damit nie die einer anderen für ihre gehalten werden. Tragen die Sensoren Seriennummern, geben Sie sie ein: Dann behalten sie ihre Kalibrierung an jeder Platine.</translation>
    </message>
    <message>
        <source>As written on it, such as “Lab 2”</source>
        <translation>Wie er darauf steht, etwa „Labor 2“</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Platine</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::BodyChoiceForm</name>
    <message>
        <source>By the past alone, as the live figure is solved.</source>
        <translation>Nur aus dem Vergangenen, so wie die Live-Figur berechnet wird.</translation>
    </message>
    <message>
        <source>The smoother again and again, until nothing changes. Takes several times as long.</source>
        <translation>Der Glätter immer wieder, bis sich nichts mehr ändert. Dauert mehrmals so lange.</translation>
    </message>
    <message>
        <source>All sensors together, forward and backward in time. The most exact for most takes.</source>
        <translation>Alle Sensoren zusammen, vorwärts und rückwärts in der Zeit. Für die meisten Takes am genauesten.</translation>
    </message>
    <message>
        <source>Feet that stand hold the figure to the ground. For somebody who stands or walks.</source>
        <translation>Füße, die stehen, halten die Figur am Boden. Für jemanden, der steht oder geht.</translation>
    </message>
    <message>
        <source>The root stays where it is. For somebody who sits, or an arm alone.</source>
        <translation>Die Wurzel bleibt, wo sie ist. Für jemanden, der sitzt, oder nur einen Arm.</translation>
    </message>
    <message>
        <source>By gravity and the sensors alone: the figure drifts away with time.</source>
        <translation>Nur nach der Schwerkraft und den Sensoren: Die Figur treibt mit der Zeit davon.</translation>
    </message>
    <message>
        <source>As it was simulated. To compare joints alone.</source>
        <translation>Wie sie simuliert wurde. Um nur die Gelenke zu vergleichen.</translation>
    </message>
    <message>
        <source>As the file tells.</source>
        <translation>Wie die Datei es sagt.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Wurzel</translation>
    </message>
    <message>
        <source>Find noises from the take</source>
        <translation>Rauschen aus dem Take bestimmen</translation>
    </message>
    <message>
        <source>Both directions</source>
        <translation>Beide Richtungen</translation>
    </message>
    <message>
        <source>Forward only</source>
        <translation>Nur vorwärts</translation>
    </message>
    <message>
        <source>Optimiser</source>
        <translation>Optimierer</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Accelerometers and gyroscopes</source>
        <translation>Beschleunigungs- und Drehratensensoren</translation>
    </message>
    <message>
        <source>Gyroscopes and ranges</source>
        <translation>Drehratensensoren und Abstände</translation>
    </message>
    <message>
        <source>Accelerometers and ranges</source>
        <translation>Beschleunigungssensoren und Abstände</translation>
    </message>
    <message>
        <source>Accelerometers</source>
        <translation>Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>Gyroscopes</source>
        <translation>Drehratensensoren</translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>For sensors that nobody has measured: how noisy they are, and how lively the wearer is, from the first seconds. Errors that are not noise deceive it.</source>
        <translation>Für Sensoren, die niemand vermessen hat: wie stark sie rauschen und wie lebhaft sich die Person bewegt, aus den ersten Sekunden. Fehler, die kein Rauschen sind, täuschen es.</translation>
    </message>
    <message>
        <source>change method</source>
        <translation>Verfahren ändern</translation>
    </message>
    <message>
        <source>change sensors to solve with</source>
        <translation>Sensoren zum Berechnen ändern</translation>
    </message>
    <message>
        <source>change root</source>
        <translation>Wurzel ändern</translation>
    </message>
    <message>
        <source>change finding of noises</source>
        <translation>Bestimmen des Rauschens ändern</translation>
    </message>
    <message>
        <source>Feet on the ground</source>
        <translation>Füße am Boden</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Of the truth</source>
        <translation>Aus der Wahrheit</translation>
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
    <message>
        <source>Back to 0°</source>
        <translation>Zurück auf 0°</translation>
    </message>
    <message>
        <source>Takes the rotation of this bone away</source>
        <translation>Nimmt die Drehung dieses Knochens weg</translation>
    </message>
    <message>
        <source>Lengths are edited in a take</source>
        <translation>Längen werden in einem Take geändert</translation>
    </message>
    <message>
        <source>Turns the live figure</source>
        <translation>Dreht die Live-Figur</translation>
    </message>
    <message>
        <source>About the vertical, which gravity cannot tell. It holds from now on and becomes a key of the take that is being recorded.</source>
        <translation>Um die Senkrechte, was die Schwerkraft nicht verrät. Es gilt ab jetzt und wird ein Schlüssel des Takes, der gerade aufgenommen wird.</translation>
    </message>
    <message>
        <source>About the vertical, which gravity cannot tell. It holds from now on, for the next take too.</source>
        <translation>Um die Senkrechte, was die Schwerkraft nicht verrät. Es gilt ab jetzt, auch für den nächsten Take.</translation>
    </message>
    <message>
        <source>Turns the bone about the vertical, beyond what its sensors say; what hangs on it without sensors follows. It holds from now on.</source>
        <translation>Dreht den Knochen um die Senkrechte über das hinaus, was seine Sensoren sagen; was ohne Sensoren daran hängt, folgt. Es gilt von jetzt an.</translation>
    </message>
    <message>
        <source>Turns the bone about the vertical, beyond what its sensors say; what hangs on it without sensors follows. Turning it sets a key at the playhead.</source>
        <translation>Dreht den Knochen um die Senkrechte über das hinaus, was seine Sensoren sagen; was ohne Sensoren daran hängt, folgt. Drehen setzt einen Schlüssel an der Abspielmarke.</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::BoxPanel</name>
    <message>
        <source>Driver box</source>
        <translation>Treiberbox</translation>
    </message>
    <message>
        <source> °C</source>
        <translation> °C</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Temperature of the air</source>
        <translation>Temperatur der Luft</translation>
    </message>
    <message>
        <source>The speed of sound follows from it: one degree is 0.2 per cent of every range</source>
        <translation>Daraus folgt die Schallgeschwindigkeit: ein Grad macht 0,2 Prozent jeder Entfernung aus</translation>
    </message>
    <message>
        <source>Humidity of the air</source>
        <translation>Feuchte der Luft</translation>
    </message>
    <message>
        <source>Relative; it matters little</source>
        <translation>Relative Feuchte; sie macht wenig aus</translation>
    </message>
    <message>
        <source>Height of the wearer</source>
        <translation>Körpergröße der Person</translation>
    </message>
    <message>
        <source>Skeleton and places of the boards are scaled to it</source>
        <translation>Skelett und Sitz der Platinen werden danach bemessen</translation>
    </message>
    <message>
        <source>as the rig says</source>
        <translation>wie im Aufbau</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Feuchte</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Waiting for the box</source>
        <translation>Warten auf die Box</translation>
    </message>
    <message>
        <source>The box is away; it is taken back by itself</source>
        <translation>Die Box ist fort; sie wird von selbst wieder verbunden</translation>
    </message>
    <message>
        <source>No live figure</source>
        <translation>Keine Live-Figur</translation>
    </message>
    <message>
        <source>Stand still for a second</source>
        <translation>Eine Sekunde stillstehen</translation>
    </message>
    <message>
        <source>Live: %1 poses a second</source>
        <translation>Live: %1 Posen je Sekunde</translation>
    </message>
    <message>
        <source>Joints ± %1°, root ± %2 m (1 σ)</source>
        <translation>Gelenke ± %1°, Wurzel ± %2 m (1 σ)</translation>
    </message>
    <message>
        <source>Gaps: %1, samples lost: %2, reconnections: %3</source>
        <translation>Lücken: %1, Abtastwerte verloren: %2, neu verbunden: %3</translation>
    </message>
    <message>
        <source>Battery %1 V, %2 °C</source>
        <translation>Batterie %1 V, %2 °C</translation>
    </message>
    <message>
        <source>Delays of the sources</source>
        <translation>Verzögerungen der Quellen</translation>
    </message>
    <message>
        <source>Nominal: every source fires when its slot begins. A take of this box in which they were measured tells by how much each is late, and its phase and level.</source>
        <translation>Nominell: Jede Quelle feuert, wenn ihr Zeitschlitz beginnt. Ein Take dieser Box, in dem sie gemessen wurden, sagt, um wie viel jede zu spät ist, dazu ihre Phase und ihren Pegel.</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>What the words mean, and what to do</source>
        <translation>Was die Wörter bedeuten und was zu tun ist</translation>
    </message>
    <message>
        <source>Nominal delays</source>
        <translation>Nominelle Verzögerungen</translation>
    </message>
    <message>
        <source>As in “%1”</source>
        <translation>Wie in „%1“</translation>
    </message>
    <message>
        <source>As in a take…</source>
        <translation>Wie in einem Take …</translation>
    </message>
    <message>
        <source>A take of this box with measured sources</source>
        <translation>Ein Take dieser Box mit gemessenen Quellen</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>The sources stay as they are</source>
        <translation>Die Quellen bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Live figure</source>
        <translation>Live-Figur</translation>
    </message>
    <message>
        <source>Smoothed, it moves as calmly as a solved take, and so much later. What is recorded is the same.</source>
        <translation>Geglättet bewegt sie sich so ruhig wie ein berechneter Take, und um so viel später. Aufgenommen wird dasselbe.</translation>
    </message>
    <message>
        <source>Smoothed, %1 s later</source>
        <translation>Geglättet, %1 s später</translation>
    </message>
    <message>
        <source>Newest pose</source>
        <translation>Neueste Pose</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Figur</translation>
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
        <translation>Wählen Sie einen Sensor, um seine Kalibrierungen zu sehen.</translation>
    </message>
    <message>
        <source>No serial: known by its place on the board.</source>
        <translation>Ohne Seriennummer: am Platz auf der Platine erkannt.</translation>
    </message>
    <message>
        <source>Serial %1</source>
        <translation>Seriennummer %1</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>Befestigung</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>in Gebrauch</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Go back to this calibration</source>
        <translation>Zu dieser Kalibrierung zurückkehren</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::CalibrateOverview</name>
    <message>
        <source>Calibrate range</source>
        <translation>Bereich kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate mounting</source>
        <translation>Befestigung kalibrieren</translation>
    </message>
    <message>
        <source>Use the library&apos;s calibration</source>
        <translation>Aus der Bibliothek nehmen</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Range: residual of gravity</source>
        <translation>Bereich: Rest gegen die Schwerkraft</translation>
    </message>
    <message>
        <source>Mounting: angle between the poses, 90° is right</source>
        <translation>Befestigung: Winkel der Posen, richtig 90°</translation>
    </message>
    <message>
        <source>Running capture: %1.</source>
        <translation>Laufende Erfassung: %1.</translation>
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
        <translation>Die neueste jedes Sensors und der Befestigungen dieser Person</translation>
    </message>
    <message>
        <source>The library knows none of these sensors yet.</source>
        <translation>Die Bibliothek kennt noch keinen dieser Sensoren.</translation>
    </message>
    <message>
        <source>no serial</source>
        <translation>ohne Seriennummer</translation>
    </message>
    <message>
        <source>Everything is calibrated</source>
        <translation>Alles ist kalibriert</translation>
    </message>
    <message>
        <source>Range: %1 of %3.  Mounting: %2 of %3.</source>
        <translation>Bereich: %1 von %3.  Befestigung: %2 von %3.</translation>
    </message>
    <message>
        <source>Next: calibrate the range, once in a sensor&apos;s life. Uncalibrated sensors may point 6° or more beside the truth.</source>
        <translation>Als Nächstes: den Bereich kalibrieren, einmal im Leben eines Sensors. Nicht kalibrierte Sensoren können um 6° und mehr danebenliegen.</translation>
    </message>
    <message>
        <source>Next: put the sensors on and calibrate the mounting.</source>
        <translation>Als Nächstes: die Sensoren anlegen und die Befestigung kalibrieren.</translation>
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
        <translation>Kalibrieren Sie die Befestigung neu, sobald die Sensoren neu angelegt wurden oder verrutscht sind.</translation>
    </message>
    <message>
        <source>From a recording</source>
        <translation>Aus einer Aufnahme</translation>
    </message>
    <message>
        <source>Calibrate from a stretch of a take in which sensors were turned or poses held</source>
        <translation>Aus einem Abschnitt eines Takes kalibrieren, in dem Sensoren gedreht oder Posen gehalten wurden</translation>
    </message>
    <message>
        <source> What the take does not carry, its solve took from the take&apos;s own calibration movements or from the library.</source>
        <translation> Was der Take nicht mitbringt, nahm die Berechnung aus seinen eigenen Kalibrierbewegungen oder aus der Bibliothek.</translation>
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
        <translation>Öffnen Sie unter „Aufnehmen“ ein Gerät, um seine Sensoren zu kalibrieren, oder öffnen Sie einen Take, um seine Kalibrierung anzusehen und neu zu berechnen.</translation>
    </message>
    <message>
        <source>Open a device in Capture</source>
        <translation>Gerät unter „Aufnehmen“ öffnen</translation>
    </message>
    <message>
        <source>Range calibration</source>
        <translation>Bereichskalibrierung</translation>
    </message>
    <message>
        <source>Mounting calibration</source>
        <translation>Befestigungskalibrierung</translation>
    </message>
    <message>
        <source>%1 of %2 is saved and in use.</source>
        <translation>%1 von %2 ist gespeichert und in Gebrauch.</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Find each sensor&apos;s zero and scale, and how it sits on its limb</source>
        <translation>Nullpunkt und Empfindlichkeit jedes Sensors finden, und wie er am Körper sitzt</translation>
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
        <translation>Eine Kalibrierung verlassen, nach Rückfrage</translation>
    </message>
    <message>
        <source>Calibrate from a recording</source>
        <translation>Aus einer Aufnahme kalibrieren</translation>
    </message>
    <message>
        <source>Calibration from a recording</source>
        <translation>Kalibrierung aus einer Aufnahme</translation>
    </message>
    <message>
        <source>Learn how sensors are calibrated</source>
        <translation>So werden Sensoren kalibriert</translation>
    </message>
    <message>
        <source>This take needs no calibration by hand</source>
        <translation>Dieser Take braucht keine Kalibrierung von Hand</translation>
    </message>
    <message>
        <source>The body filter estimates offsets, mountings and lengths while it solves. Begin takes with a second of standing still in the rest pose.</source>
        <translation>Das Körperfilter schätzt Nullpunkte, Befestigungen und Längen bei der Berechnung. Beginnen Sie Takes mit einer Sekunde Stillstand in der Ruhepose.</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::CalibrationDesk</name>
    <message>
        <source>The raw signals are not kept: %1</source>
        <translation>Die Rohsignale werden nicht aufbewahrt: %1</translation>
    </message>
    <message>
        <source>Reading the calibration library</source>
        <translation>Kalibrierungsbibliothek wird gelesen</translation>
    </message>
    <message>
        <source>Saving the calibration</source>
        <translation>Kalibrierung wird gespeichert</translation>
    </message>
    <message>
        <source>Raw signals are kept in %1</source>
        <translation>Die Rohsignale werden in %1 aufbewahrt</translation>
    </message>
    <message>
        <source>The raw signals are not kept in a take of their own: the capture records already, or it cannot record. The calibration itself goes on.</source>
        <translation>Die Rohsignale kommen nicht in einen eigenen Take: die Erfassung nimmt schon auf oder kann nicht aufnehmen. Die Kalibrierung selbst geht weiter.</translation>
    </message>
    <message>
        <source>Closing the calibration&apos;s take</source>
        <translation>Take der Kalibrierung wird geschlossen</translation>
    </message>
    <message>
        <source>The calibration&apos;s take has no segments</source>
        <translation>Der Take der Kalibrierung hat keine Abschnitte</translation>
    </message>
    <message>
        <source>The calibration is kept in the library, but what it was made for is closed: the capture or take at hand is unchanged.</source>
        <translation>Die Kalibrierung ist in der Bibliothek, aber das, wofür sie gemacht wurde, ist geschlossen: die jetzige Erfassung oder der jetzige Take bleibt unverändert.</translation>
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
        <source>range calibration</source>
        <translation>Bereichskalibrierung</translation>
    </message>
    <message>
        <source>mounting calibration</source>
        <translation>Befestigungskalibrierung</translation>
    </message>
    <message>
        <source>choice of calibration</source>
        <translation>Wahl der Kalibrierung</translation>
    </message>
    <message>
        <source>Undone: %1. It is not used any more.</source>
        <translation>Rückgängig gemacht: %1. Sie wird nicht mehr benutzt.</translation>
    </message>
    <message>
        <source>Redo brings it back. Its file stays in the library&apos;s folder, ending in &quot;.removed&quot;.</source>
        <translation>„Wiederholen“ bringt sie zurück. Ihre Datei bleibt im Ordner der Bibliothek und endet auf „.removed“.</translation>
    </message>
    <message>
        <source>subject</source>
        <translation>Person</translation>
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
    <message>
        <source>Test the sound</source>
        <translation>Ton testen</translation>
    </message>
    <message>
        <source>Plays the end of a countdown through the computer&apos;s output</source>
        <translation>Spielt das Ende eines Countdowns über den Ausgang des Rechners</translation>
    </message>
    <message>
        <source>Three sounds were played: two short ones, then a long one for “hold still”.</source>
        <translation>Drei Töne wurden gespielt: zwei kurze, dann ein langer für „stillhalten“.</translation>
    </message>
    <message>
        <source>No sound can be played: %1</source>
        <translation>Es lässt sich kein Ton abspielen: %1</translation>
    </message>
    <message>
        <source>Learn how</source>
        <translation>So geht es</translation>
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
    <message>
        <source>Reading the rig</source>
        <translation>Rig wird gelesen</translation>
    </message>
    <message>
        <source>The countdown ended without recording.</source>
        <translation>Der Countdown endete ohne Aufnahme.</translation>
    </message>
    <message>
        <source>Look at the device and at the name of the take, then begin again.</source>
        <translation>Sehen Sie nach dem Gerät und dem Namen des Takes und beginnen Sie noch einmal.</translation>
    </message>
    <message>
        <source>format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Reading the board</source>
        <translation>Platine wird gelesen</translation>
    </message>
    <message>
        <source>The board cannot be read</source>
        <translation>Die Platine lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>sensor board</source>
        <translation>Sensorplatine</translation>
    </message>
    <message>
        <source>The board cannot be kept</source>
        <translation>Die Platine lässt sich nicht speichern</translation>
    </message>
    <message>
        <source>folder for takes</source>
        <translation>Ordner für Takes</translation>
    </message>
    <message>
        <source>Driver box at %1</source>
        <translation>Treiberbox an %1</translation>
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
    <message>
        <source>Learn how the board is connected</source>
        <translation>So wird die Platine angeschlossen</translation>
    </message>
    <message>
        <source>Choose above the line input that the board is plugged into, or the driver box. Levels and signals show at once; nothing is recorded before you say so.</source>
        <translation>Wählen Sie oben den Line-Eingang, in dem die Platine steckt, oder die Treiberbox. Pegel und Signale erscheinen sofort; aufgenommen wird erst, wenn Sie es sagen.</translation>
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
    <message>
        <source>Elevation</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>± σ</source>
        <translation>± σ</translation>
    </message>
    <message>
        <source>0°</source>
        <translation>0°</translation>
    </message>
    <message>
        <source>± %1°</source>
        <translation>± %1°</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::DockTitle</name>
    <message>
        <source>Hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>Put %1 back into the window</source>
        <translation>%1 zurück ins Fenster holen</translation>
    </message>
    <message>
        <source>Show %1 in a window of its own</source>
        <translation>%1 in einem eigenen Fenster zeigen</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::ExportFinish</name>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Choose where the file goes</source>
        <translation>Wählen, wohin die Datei kommt</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write the file, read it back and compare (Ctrl+E)</source>
        <translation>Die Datei schreiben, zurücklesen und vergleichen (Strg+E)</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Pfad kopieren</translation>
    </message>
    <message>
        <source>The file exists. It is replaced when the new one is written and checked.</source>
        <translation>Die Datei gibt es schon. Sie wird ersetzt, sobald die neue geschrieben und geprüft ist.</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, noch %2</translation>
    </message>
    <message>
        <source>%1 (*%2)</source>
        <translation>%1 (*%2)</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>Exportieren nach</translation>
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
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>Every joint is where it belongs.</source>
        <translation>Jedes Gelenk ist, wo es hingehört.</translation>
    </message>
    <message>
        <source>Largest difference at any key: %1 mm, at %2.</source>
        <translation>Größter Unterschied an allen Schlüsseln: %1 mm, bei %2.</translation>
    </message>
    <message>
        <source>Export cancelled.</source>
        <translation>Export abgebrochen.</translation>
    </message>
    <message>
        <source>Nothing was written; a file that was there before is as it was.</source>
        <translation>Nichts wurde geschrieben; eine Datei, die schon da war, ist unverändert.</translation>
    </message>
    <message>
        <source>Not exported. %1</source>
        <translation>Nicht exportiert. %1</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::ExportModel</name>
    <message>
        <source>Preparing the preview</source>
        <translation>Die Vorschau wird vorbereitet</translation>
    </message>
    <message>
        <source>A file of this format holds one actor. Choose FBX or glTF, or remove the others.</source>
        <translation>Eine Datei dieses Formats fasst eine Person. FBX oder glTF wählen oder die anderen entfernen.</translation>
    </message>
    <message>
        <source>Choose the mesh that is to be skinned.</source>
        <translation>Das Netz wählen, das an die Knochen gebunden wird.</translation>
    </message>
    <message>
        <source>The part ends before it begins.</source>
        <translation>Der Ausschnitt endet, bevor er beginnt.</translation>
    </message>
    <message>
        <source>This is the file that is being exported. Choose another name.</source>
        <translation>Das ist die Datei, die exportiert wird. Einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::ExportOptionsCard</name>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>As the preset: %1</source>
        <translation>Wie die Vorgabe: %1</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Bildrate</translation>
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
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Way over the floor</source>
        <translation>Weg über den Boden</translation>
    </message>
    <message>
        <source>Rest pose</source>
        <translation>Ruhepose</translation>
    </message>
    <message>
        <source>Rest pose on frame 0</source>
        <translation>Ruhepose in Bild 0</translation>
    </message>
    <message>
        <source>Bone names</source>
        <translation>Knochennamen</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Längeneinheit</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Keep all keys</source>
        <translation>Alle Schlüssel behalten</translation>
    </message>
    <message>
        <source>Leave out keys within</source>
        <translation>Schlüssel weglassen bis</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Mannequin</source>
        <translation>Gliederpuppe</translation>
    </message>
    <message>
        <source>Your own mesh</source>
        <translation>Eigenes Netz</translation>
    </message>
    <message>
        <source>None, bones only</source>
        <translation>Keiner, nur Knochen</translation>
    </message>
    <message>
        <source>Choose mesh…</source>
        <translation>Netz wählen …</translation>
    </message>
    <message>
        <source>A .obj, .glb, .gltf or .fbx of a body; it is skinned to the bones by itself</source>
        <translation>Ein Körper als .obj, .glb, .gltf oder .fbx; er wird von selbst an die Knochen gebunden</translation>
    </message>
    <message>
        <source>Skinning</source>
        <translation>Binden</translation>
    </message>
    <message>
        <source>As the motion has it: %1 Hz</source>
        <translation>Wie die Bewegung: %1 Hz</translation>
    </message>
    <message>
        <source>As the motion has it</source>
        <translation>Wie die Bewegung</translation>
    </message>
    <message>
        <source>What the timeline shows (%1 to %2)</source>
        <translation>Was die Zeitleiste zeigt (%1 bis %2)</translation>
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
        <source>Everything (%1)</source>
        <translation>Alles (%1)</translation>
    </message>
    <message>
        <source>From … to …</source>
        <translation>Von … bis …</translation>
    </message>
    <message>
        <source>Free, on the hips</source>
        <translation>Frei, auf der Hüfte</translation>
    </message>
    <message>
        <source>In place</source>
        <translation>Auf der Stelle</translation>
    </message>
    <message>
        <source>As captured</source>
        <translation>Wie aufgenommen</translation>
    </message>
    <message>
        <source>T-pose</source>
        <translation>T-Pose</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Lengths in %1 files are always in metres</source>
        <translation>Längen in %1-Dateien sind immer in Metern</translation>
    </message>
    <message>
        <source>Keys are left out as long as no joint turns by more than this</source>
        <translation>Schlüssel werden weggelassen, solange sich kein Gelenk um mehr verdreht</translation>
    </message>
    <message>
        <source>%1 files have every frame</source>
        <translation>%1-Dateien haben jedes Bild</translation>
    </message>
    <message>
        <source>%1 files have no body</source>
        <translation>%1-Dateien haben keinen Körper</translation>
    </message>
    <message>
        <source>No mesh is chosen</source>
        <translation>Kein Netz gewählt</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Skin it</source>
        <translation>Binden</translation>
    </message>
    <message>
        <source>Skinning was stopped</source>
        <translation>Das Binden wurde angehalten</translation>
    </message>
    <message>
        <source>%1 vertices skinned</source>
        <translation>%1 Punkte gebunden</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, noch %2</translation>
    </message>
    <message>
        <source>Choose a mesh</source>
        <translation>Ein Netz wählen</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.glb *.gltf *.fbx);;All files (*)</source>
        <translation>Netze (*.obj *.glb *.gltf *.fbx);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Vorgeschlagen</translation>
    </message>
    <message>
        <source>Proposed: %1 frames a second</source>
        <translation>Vorgeschlagen: %1 Bilder je Sekunde</translation>
    </message>
    <message>
        <source>%1, as the motion has them</source>
        <translation>%1, wie die Bewegung</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::ExportPresetCard</name>
    <message>
        <source>For</source>
        <translation>Für</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What the preset sets</source>
        <translation>Was die Vorgabe bestimmt</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Your own presets and bone names</source>
        <translation>Eigene Vorgaben und Knochennamen</translation>
    </message>
    <message>
        <source>Open the folder of your presets</source>
        <translation>Ordner der eigenen Vorgaben öffnen</translation>
    </message>
    <message>
        <source>Open the folder of your bone names</source>
        <translation>Ordner der eigenen Knochennamen öffnen</translation>
    </message>
    <message>
        <source>Read them again</source>
        <translation>Neu einlesen</translation>
    </message>
    <message>
        <source>This preset cannot be read; what is wrong with it stands below.</source>
        <translation>Diese Vorgabe ist nicht lesbar; was daran falsch ist, steht unten.</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::ExportPreview</name>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Preview of the file</source>
        <translation>Vorschau der Datei</translation>
    </message>
    <message>
        <source>%1 at %2 Hz</source>
        <translation>%1 mit %2 Hz</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1, von %2 bis %3</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>Bone in the file</source>
        <translation>Knochen in der Datei</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Bones of the file</source>
        <translation>Knochen der Datei</translation>
    </message>
    <message>
        <source>Rest pose</source>
        <translation>Ruhepose</translation>
    </message>
    <message>
        <source>Show how the skeleton of the file stands by itself</source>
        <translation>Zeigen, wie das Skelett der Datei von sich aus steht</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Actors</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>, behind one frame of rest</source>
        <translation>, nach einem Bild in Ruhe</translation>
    </message>
    <message>
        <source>%1 of %2 (%3 %)</source>
        <translation>%1 von %2 (%3 %)</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>The preview is being made.</source>
        <translation>Die Vorschau entsteht.</translation>
    </message>
    <message>
        <source>There is no preview of these choices.</source>
        <translation>Zu dieser Auswahl gibt es keine Vorschau.</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In Ruhe</translation>
    </message>
    <message>
        <source>Very long: the picture ends at %1</source>
        <translation>Sehr lang: das Bild endet bei %1</translation>
    </message>
    <message>
        <source>Of earlier choices; being made again</source>
        <translation>Von früheren Angaben; wird neu gemacht</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::ExportSourceCard</name>
    <message>
        <source>Animations (%1);;All files (*)</source>
        <translation>Animationen (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Open animation…</source>
        <translation>Animation öffnen …</translation>
    </message>
    <message>
        <source>A .bvh, .fbx, .glb, .gltf or .vrm of another program, to look at it and to export it on</source>
        <translation>Eine .bvh, .fbx, .glb, .gltf oder .vrm eines anderen Programms, zum Ansehen und Weitergeben</translation>
    </message>
    <message>
        <source>Add actor</source>
        <translation>Person dazu</translation>
    </message>
    <message>
        <source>Somebody else who goes into the same file</source>
        <translation>Noch jemand, der in dieselbe Datei kommt</translation>
    </message>
    <message>
        <source>A take…</source>
        <translation>Ein Take …</translation>
    </message>
    <message>
        <source>An animation…</source>
        <translation>Eine Animation …</translation>
    </message>
    <message>
        <source>Other actors</source>
        <translation>Weitere Personen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Open an animation</source>
        <translation>Eine Animation öffnen</translation>
    </message>
    <message>
        <source>Add a solved take (a folder that ends in .take)</source>
        <translation>Einen berechneten Take hinzufügen (ein Ordner, der auf .take endet)</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::ExportSourceList</name>
    <message>
        <source>%1, solve “%2”</source>
        <translation>%1, Berechnung „%2“</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation>%1 lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>%1: %2 (%3 of %4)</source>
        <translation>%1: %2 (%3 von %4)</translation>
    </message>
    <message>
        <source>%1, as edited</source>
        <translation>%1, wie bearbeitet</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::ExportWorkspace</name>
    <message>
        <source>Go to Solve</source>
        <translation>Zum Berechnen</translation>
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
        <source>It can be exported in a moment.</source>
        <translation>Er lässt sich gleich exportieren.</translation>
    </message>
    <message>
        <source>Solve the take first.</source>
        <translation>Berechnen Sie erst den Take.</translation>
    </message>
    <message>
        <source>Open animation…</source>
        <translation>Animation öffnen …</translation>
    </message>
    <message>
        <source>There is nothing to export yet</source>
        <translation>Noch gibt es nichts zu exportieren</translation>
    </message>
    <message>
        <source>Open or capture a take, or open an animation of another program (BVH, FBX or glTF).</source>
        <translation>Einen Take öffnen oder aufnehmen oder eine Animation eines anderen Programms öffnen (BVH, FBX oder glTF).</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::FormSheet</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::ImportSheet</name>
    <message>
        <source>Import recordings</source>
        <translation>Aufnahmen einlesen</translation>
    </message>
    <message>
        <source>%1 becomes a take.</source>
        <translation>%1 wird ein Take.</translation>
    </message>
    <message>
        <source>These become one take, in this order: %1</source>
        <translation>Diese werden ein Take, in dieser Reihenfolge: %1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Rig</translation>
    </message>
    <message>
        <source>What was worn where</source>
        <translation>Was wo getragen wurde</translation>
    </message>
    <message>
        <source>Subject</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Who wore the sensors</source>
        <translation>Wer die Sensoren trug</translation>
    </message>
    <message>
        <source>The mounting of this person in the calibration library is used</source>
        <translation>Die Befestigung dieser Person aus der Kalibrierungsbibliothek wird verwendet</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Take</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Learn how to record without a computer</source>
        <translation>So wird ohne Rechner aufgenommen</translation>
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
    <message>
        <source>Learn how to set the level</source>
        <translation>So wird der Pegel eingestellt</translation>
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
        <translation>Diese Pose nehmen</translation>
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
        <source>Signal lost</source>
        <translation>Signal verloren</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>No signal: %1</source>
        <translation>Kein Signal: %1</translation>
    </message>
    <message>
        <source>Check the cable and plug of %1, or go on without.</source>
        <translation>Prüfen Sie Kabel und Stecker von %1, oder machen Sie ohne weiter.</translation>
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
        <translation>ruhig</translation>
    </message>
    <message>
        <source>Moves: %1</source>
        <translation>Bewegt sich: %1</translation>
    </message>
    <message>
        <source>Rest it against something, breathe out and hold. It is taken as soon as all are still.</source>
        <translation>Anlehnen, ausatmen und halten. Die Pose wird genommen, sobald alle ruhig sind.</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>bewegt sich</translation>
    </message>
    <message>
        <source>One still second is enough.</source>
        <translation>Eine ruhige Sekunde genügt.</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>The device is back</source>
        <translation>Das Gerät ist wieder da</translation>
    </message>
    <message>
        <source>Go back and start the poses again.</source>
        <translation>Zurückgehen und die Posen neu beginnen.</translation>
    </message>
    <message>
        <source>The device stopped sending. Plug it in again, open it in Capture, then go back and start the poses again. What was held until then is kept.</source>
        <translation>Das Gerät sendet nicht mehr. Wieder einstecken, unter „Aufnehmen“ öffnen, dann zurückgehen und die Posen neu beginnen. Was bis dahin gehalten wurde, bleibt erhalten.</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::LimbWizard</name>
    <message>
        <source>Calibrate mounting</source>
        <translation>Befestigung kalibrieren</translation>
    </message>
    <message>
        <source>Which limb, and which of its sensors?</source>
        <translation>Welche Gliedmaße und welche ihrer Sensoren?</translation>
    </message>
    <message>
        <source>Mounting calibration finds how every sensor sits on its limb, from two poses a right angle apart. It is done each time the sensors are put on.</source>
        <translation>Die Befestigungskalibrierung findet heraus, wie jeder Sensor an seiner Gliedmaße sitzt, aus zwei Posen im rechten Winkel zueinander. Sie wird nach jedem Anlegen gemacht.</translation>
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
        <translation>Zuerst ihren Bereich kalibrieren</translation>
    </message>
    <message>
        <source>After Start you have the time below to take the first pose. It is captured by itself as soon as everything is still for a second; a sound tells, and the second pose follows. No key is needed.</source>
        <translation>Nach „Start“ haben Sie so lange wie unten angegeben, um die erste Pose einzunehmen. Sie wird von selbst erfasst, sobald alles eine Sekunde lang ruhig ist; ein Ton meldet es, und die zweite Pose folgt. Eine Taste ist nicht nötig.</translation>
    </message>
    <message>
        <source>Time to take a pose</source>
        <translation>Zeit zum Einnehmen einer Pose</translation>
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
        <translation>Die gehaltene Pose würde nicht verwendet.</translation>
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
        <translation>%1 neben 90°, auf %2 ruhig gehalten.</translation>
    </message>
    <message>
        <source> The poses were not a right angle apart: each may be %1 off.</source>
        <translation> Die Posen standen nicht im rechten Winkel: jede kann um %1 falsch sein.</translation>
    </message>
    <message>
        <source> It moved while it was held.</source>
        <translation> Er bewegte sich, während er gehalten wurde.</translation>
    </message>
    <message>
        <source> It reads %1 g at rest: calibrate its range, or the volume was moved.</source>
        <translation> In Ruhe zeigt er %1 g: den Bereich kalibrieren, oder die Lautstärke wurde verstellt.</translation>
    </message>
    <message>
        <source>sits %1 from how the rig shows it</source>
        <translation>sitzt %1 anders, als das Rig es zeigt</translation>
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
        <translation>Bereich nie kalibriert: %1. Ihre Richtungen können um mehrere Grad falsch sein.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Limb</source>
        <translation>Gliedmaße</translation>
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
        <translation>Ergebnis</translation>
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
        <translation>Wird berechnet …</translation>
    </message>
    <message>
        <source>Save %1</source>
        <translation>%1 speichern</translation>
    </message>
    <message>
        <source>Back to the verdict</source>
        <translation>Zurück zum Ergebnis</translation>
    </message>
    <message>
        <source>%1 %2; %3.</source>
        <translation>%1 %2; %3.</translation>
    </message>
    <message>
        <source>Check: hold &quot;%1&quot; again</source>
        <translation>Prüfung: noch einmal „%1“ halten</translation>
    </message>
    <message>
        <source>held within %1</source>
        <translation>auf %1 ruhig gehalten</translation>
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
        <translation>Winkel zwischen der Schwerkraft, wie jeder Sensor sie nun an seiner Gliedmaße sieht, und wie die Pose sie verlangt. Darin steckt auch die Ungenauigkeit der Person.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::LimbWizardModel</name>
    <message>
        <source>This rig names no poses. Add calibration groups to its file.</source>
        <translation>Dieses Rig nennt keine Posen. Tragen Sie in seine Datei Kalibrierungsgruppen ein.</translation>
    </message>
    <message>
        <source>Choose at least one sensor.</source>
        <translation>Wählen Sie mindestens einen Sensor.</translation>
    </message>
    <message>
        <source>No signal comes in. Open a device in Capture.</source>
        <translation>Es kommt kein Signal. Öffnen Sie unter „Aufnehmen“ ein Gerät.</translation>
    </message>
    <message>
        <source>Hold still: it goes on by itself.</source>
        <translation>Stillhalten: es geht von selbst weiter.</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Wird berechnet …</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Wird gespeichert …</translation>
    </message>
    <message>
        <source>Nothing is accepted yet.</source>
        <translation>Noch ist nichts angenommen.</translation>
    </message>
    <message>
        <source>Computing the mounting</source>
        <translation>Befestigung wird berechnet</translation>
    </message>
    <message>
        <source>Checking the mounting</source>
        <translation>Befestigung wird geprüft</translation>
    </message>
    <message>
        <source>The device died. Go back and start again when it is there.</source>
        <translation>Das Gerät ist ausgefallen. Zurückgehen und neu beginnen, wenn es wieder da ist.</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::LiveHeadings</name>
    <message>
        <source>turn %1 live</source>
        <translation>%1 live drehen</translation>
    </message>
    <message>
        <source>The turns of bones are not kept</source>
        <translation>Die Drehungen der Knochen werden nicht behalten</translation>
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
    <message>
        <source>Reading the calibration of %1</source>
        <translation>Kalibrierung von %1 wird gelesen</translation>
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
    <message>
        <source>Panels</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>A take is being recorded. What is recorded until now is kept.</source>
        <translation>Ein Take wird aufgenommen. Was bis jetzt aufgenommen ist, bleibt erhalten.</translation>
    </message>
    <message>
        <source>Stop recording and quit</source>
        <translation>Aufnahme beenden und schließen</translation>
    </message>
    <message>
        <source>“%1” is still going on and would be cancelled.</source>
        <translation>„%1“ läuft noch und würde abgebrochen.</translation>
    </message>
    <message>
        <source>Cancel it and quit</source>
        <translation>Abbrechen und schließen</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weitermachen</translation>
    </message>
    <message>
        <source>Open animation…</source>
        <translation>Animation öffnen …</translation>
    </message>
    <message>
        <source>Details of the take…</source>
        <translation>Angaben zum Take …</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>A calibration is under way. What is not saved is lost.</source>
        <translation>Eine Kalibrierung läuft. Was nicht gespeichert ist, geht verloren.</translation>
    </message>
    <message>
        <source>Leave it and quit</source>
        <translation>Abbrechen und beenden</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::ManualBrowser</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Chapters</source>
        <translation>Kapitel</translation>
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
    <message>
        <source>Show the next message</source>
        <translation>Die nächste Meldung zeigen</translation>
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
        <translation>bewegt sich: %1</translation>
    </message>
    <message>
        <source>still: %1</source>
        <translation>ruhig: %1</translation>
    </message>
    <message>
        <source>still below %1</source>
        <translation>ruhig unter %1</translation>
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
    <message>
        <source>nothing was lost</source>
        <translation>nichts ging verloren</translation>
    </message>
    <message>
        <source> and more</source>
        <translation> und mehr</translation>
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
    <message>
        <source>Joints ± %1° on average (1 σ, by the filter itself)</source>
        <translation>Gelenke im Mittel ± %1° (1 σ, nach dem Filter selbst)</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::RangeTurnPage</name>
    <message>
        <source>Start over</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Show this sensor; once more: the one in most need</source>
        <translation>Diesen Sensor zeigen; noch einmal: den, der es am nötigsten hat</translation>
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
        <source>Signal lost</source>
        <translation>Signal verloren</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 %&lt;/b&gt; of the sphere, %2 % needed&lt;br&gt;&lt;b&gt;%3 s&lt;/b&gt; steady, %4 s needed&lt;br&gt;%5 turned</source>
        <translation>&lt;b&gt;%1 %&lt;/b&gt; der Kugel, %2 % nötig&lt;br&gt;&lt;b&gt;%3 s&lt;/b&gt; ruhig, %4 s nötig&lt;br&gt;%5 gedreht</translation>
    </message>
    <message>
        <source>Start turning</source>
        <translation>Drehen beginnen</translation>
    </message>
    <message>
        <source>Slowly, about ten seconds for a full turn.</source>
        <translation>Langsam, etwa zehn Sekunden für eine ganze Umdrehung.</translation>
    </message>
    <message>
        <source>%1: no signal</source>
        <translation>%1: kein Signal</translation>
    </message>
    <message>
        <source>Its readings stopped. Check its cable and plug; what was turned so far is kept.</source>
        <translation>Es kommen keine Messwerte mehr. Prüfen Sie Kabel und Stecker; das bisher Gedrehte bleibt erhalten.</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Only slow turning shows gravity alone. What is too fast is left out.</source>
        <translation>Nur langsames Drehen zeigt die Schwerkraft allein. Was zu schnell ist, wird weggelassen.</translation>
    </message>
    <message>
        <source>Smoother</source>
        <translation>Gleichmäßiger</translation>
    </message>
    <message>
        <source>Jerks and knocks are left out. Turn it like a full glass.</source>
        <translation>Rucke und Stöße werden weggelassen. Drehen Sie ihn wie ein volles Glas.</translation>
    </message>
    <message>
        <source>Enough</source>
        <translation>Genug</translation>
    </message>
    <message>
        <source>Finish now, or fill the last gaps for an even better result.</source>
        <translation>Sie können jetzt abschließen oder für ein noch besseres Ergebnis die letzten Lücken füllen.</translation>
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
        <translation>Jede Richtung war dabei. Mit der Eingabetaste abschließen.</translation>
    </message>
    <message>
        <source>Every direction was seen; a few more steady seconds are needed.</source>
        <translation>Jede Richtung war dabei; es fehlen noch ein paar ruhige Sekunden.</translation>
    </message>
    <message>
        <source>Turn: %1</source>
        <translation>Drehen: %1</translation>
    </message>
    <message>
        <source>%1 has enough; these directions would make it better.</source>
        <translation>%1 hat genug; diese Richtungen würden es noch verbessern.</translation>
    </message>
    <message>
        <source>The device is back</source>
        <translation>Das Gerät ist wieder da</translation>
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
        <source>Bring the blue arrow of the box to the top; on the map, the dot into the blue ring.</source>
        <translation>Bringen Sie den blauen Pfeil des Kastens nach oben; auf der Karte den Punkt in den blauen Ring.</translation>
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
        <translation>Das Ellipsoid ist besser: %1 gegen %2 mit Extremwerten.</translation>
    </message>
    <message>
        <source>Extremes are better: %1 against %2 by ellipsoid.</source>
        <translation>Die Extremwerte sind besser: %1 gegen %2 mit dem Ellipsoid.</translation>
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
        <translation>Bereich kalibrieren</translation>
    </message>
    <message>
        <source>Which sensors?</source>
        <translation>Welche Sensoren?</translation>
    </message>
    <message>
        <source>Range calibration finds each sensor&apos;s zero and scale from gravity. It is done &lt;b&gt;once in a sensor&apos;s life&lt;/b&gt;, not on the body, and takes about a minute.</source>
        <translation>Die Bereichskalibrierung findet Nullpunkt und Empfindlichkeit jedes Sensors aus der Schwerkraft. Sie wird &lt;b&gt;einmal im Leben eines Sensors&lt;/b&gt; gemacht, nicht am Körper, und dauert etwa eine Minute.</translation>
    </message>
    <message>
        <source>Several sensors can be calibrated at once: fix them in one small box so that none can slip, and turn the box.</source>
        <translation>Mehrere Sensoren lassen sich zugleich kalibrieren: befestigen Sie sie rutschfest in einem kleinen Kasten und drehen Sie den Kasten.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Hold the box in both hands&lt;/b&gt;, cables slack. Sit down: it takes about a minute.</source>
        <translation>&lt;b&gt;Halten Sie den Kasten mit beiden Händen&lt;/b&gt;, die Kabel locker. Setzen Sie sich: es dauert etwa eine Minute.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Turn it slowly until every face has looked up once&lt;/b&gt;, then every edge and corner between them.</source>
        <translation>&lt;b&gt;Drehen Sie ihn langsam, bis jede Seite einmal oben war&lt;/b&gt;, dann jede Kante und Ecke dazwischen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Slowly&lt;/b&gt; means about ten seconds for a full turn, without knocks. Only steady turning counts; what is too fast is left out by itself.</source>
        <translation>&lt;b&gt;Langsam&lt;/b&gt; heißt etwa zehn Sekunden für eine ganze Umdrehung, ohne Stöße. Nur ruhiges Drehen zählt; was zu schnell ist, wird von selbst weggelassen.</translation>
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
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Start turning</source>
        <translation>Drehen beginnen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Abschließen</translation>
    </message>
    <message>
        <source>Finish early</source>
        <translation>Vorzeitig abschließen</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Wird berechnet …</translation>
    </message>
    <message>
        <source>Save %1</source>
        <translation>%1 speichern</translation>
    </message>
    <message>
        <source>What was turned until now would not be used.</source>
        <translation>Das bisher Gedrehte würde nicht verwendet.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::RangeWizardModel</name>
    <message>
        <source>Choose at least one sensor.</source>
        <translation>Wählen Sie mindestens einen Sensor.</translation>
    </message>
    <message>
        <source>No signal comes in. Open a device in Capture.</source>
        <translation>Es kommt kein Signal. Öffnen Sie unter „Aufnehmen“ ein Gerät.</translation>
    </message>
    <message>
        <source>Turn the sensors first.</source>
        <translation>Drehen Sie zuerst die Sensoren.</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Wird berechnet …</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Wird gespeichert …</translation>
    </message>
    <message>
        <source>Nothing is accepted yet.</source>
        <translation>Noch ist nichts angenommen.</translation>
    </message>
    <message>
        <source>Computing the range calibration</source>
        <translation>Bereichskalibrierung wird berechnet</translation>
    </message>
    <message>
        <source>The device died before anything was turned. Start over when it is back.</source>
        <translation>Das Gerät fiel aus, bevor etwas gedreht war. Von vorn, wenn es wieder da ist.</translation>
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
        <translation>Ruckartig: %1</translation>
    </message>
    <message>
        <source>Steady: %1</source>
        <translation>Ruhig: %1</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::RecordBanner</name>
    <message>
        <source>Set marker (M)</source>
        <translation>Marke setzen (M)</translation>
    </message>
    <message>
        <source>Recorded time</source>
        <translation>Aufgenommene Zeit</translation>
    </message>
    <message>
        <source>Stop (R)</source>
        <translation>Anhalten (R)</translation>
    </message>
    <message>
        <source>Cancel (R)</source>
        <translation>Abbrechen (R)</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message numerus="yes">
        <source>Recording begins in %n second(s)</source>
        <translation>
            <numerusform>Die Aufnahme beginnt in %n Sekunde</numerusform>
            <numerusform>Die Aufnahme beginnt in %n Sekunden</numerusform>
        </translation>
    </message>
    <message>
        <source>Closing the take</source>
        <translation>Take wird abgeschlossen</translation>
    </message>
    <message>
        <source>Recording, but samples are being lost</source>
        <translation>Aufnahme läuft, aber es gehen Werte verloren</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Aufnahme: %1</translation>
    </message>
    <message>
        <source>Recording; samples were lost</source>
        <translation>Nimmt auf; Abtastwerte gingen verloren</translation>
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
    <message>
        <source>Calibration of the next take</source>
        <translation>Kalibrierung des nächsten Takes</translation>
    </message>
    <message>
        <source>%1 &lt;a href=&quot;calibrate&quot;&gt;Calibrate&lt;/a&gt;</source>
        <translation>%1 &lt;a href=&quot;calibrate&quot;&gt;Kalibrieren&lt;/a&gt;</translation>
    </message>
    <message>
        <source>Record in %1 s</source>
        <translation>In %1 s aufnehmen</translation>
    </message>
    <message>
        <source>Counts down aloud before it records, for people alone in the suit (Shift+R)</source>
        <translation>Zählt hörbar herunter, bevor es aufnimmt, für alle, die allein im Anzug stecken (Umschalt+R)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel the countdown</source>
        <translation>Countdown abbrechen</translation>
    </message>
    <message numerus="yes">
        <source>Recording begins in %n second(s)</source>
        <translation>
            <numerusform>Die Aufnahme beginnt in %n Sekunde</numerusform>
            <numerusform>Die Aufnahme beginnt in %n Sekunden</numerusform>
        </translation>
    </message>
    <message>
        <source>disk: –</source>
        <translation>Platte: –</translation>
    </message>
    <message>
        <source>A calibration is under way</source>
        <translation>Eine Kalibrierung läuft</translation>
    </message>
    <message>
        <source>Recording; samples were lost</source>
        <translation>Nimmt auf; Abtastwerte gingen verloren</translation>
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
        <translation>%1: Bereich %2, Befestigung %3</translation>
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
        <translation>Nur den Bereich von %1</translation>
    </message>
    <message>
        <source>Mounting of %1 only</source>
        <translation>Nur die Befestigung von %1</translation>
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
    <name>limbwave::ui::SensorTable</name>
    <message>
        <source>Socket</source>
        <translation>Buchse</translation>
    </message>
    <message>
        <source>Worn on</source>
        <translation>Getragen an</translation>
    </message>
    <message>
        <source>Serial</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Where the sensor in socket %1 is worn</source>
        <translation>Wo der Sensor in Buchse %1 getragen wird</translation>
    </message>
    <message>
        <source>Serial of the sensor in socket %1</source>
        <translation>Seriennummer des Sensors in Buchse %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 is entered for two sensors.</source>
        <translation>%1 ist bei zwei Sensoren eingetragen.</translation>
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
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Show or hide the inspector, the timeline</source>
        <translation>Inspektor, Zeitleiste ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Open an animation</source>
        <translation>Eine Animation öffnen</translation>
    </message>
    <message>
        <source>The manual</source>
        <translation>Das Handbuch</translation>
    </message>
    <message>
        <source>All keyboard shortcuts</source>
        <translation>Alle Tastenkürzel</translation>
    </message>
    <message>
        <source>Close the take or the animation</source>
        <translation>Den Take oder die Animation schließen</translation>
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
        <source>Solving was cancelled</source>
        <translation>Die Berechnung wurde abgebrochen</translation>
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
        <source>Comparing with the truth</source>
        <translation>Vergleich mit der Wahrheit</translation>
    </message>
    <message>
        <source>The saved solve could not be read. It was solved again with its keys and settings; lengths are the rig&apos;s. What could not be read is kept in the take as %1.</source>
        <translation>Die gespeicherte Berechnung war nicht lesbar. Es wurde mit ihren Schlüsseln und Einstellungen neu berechnet; die Längen sind die des Rigs. Das Unlesbare bleibt im Take als %1 erhalten.</translation>
    </message>
    <message>
        <source>The saved solve could not be read, nor its keys. It was solved again without them. What could not be read is kept in the take as %1.</source>
        <translation>Die gespeicherte Berechnung war nicht lesbar, auch ihre Schlüssel nicht. Es wurde ohne sie neu berechnet. Das Unlesbare bleibt im Take als %1 erhalten.</translation>
    </message>
    <message>
        <source>The solve could not be compared with the truth</source>
        <translation>Die Berechnung ließ sich nicht mit der Wahrheit vergleichen</translation>
    </message>
    <message>
        <source>The solve could not be saved in the take</source>
        <translation>Die Berechnung ließ sich nicht im Take speichern</translation>
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
        <source>Live from %1: %2</source>
        <translation>Live von %1: %2</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>It could not be solved again; what you see is from before. %1 %2</source>
        <translation>Es ließ sich nicht neu berechnen; was Sie sehen, ist von vorher. %1 %2</translation>
    </message>
    <message>
        <source>This is the demo, playing.</source>
        <translation>Das ist die Demo; sie läuft.</translation>
    </message>
    <message>
        <source>Space stops it. Drag in the timeline to look at a moment, drag in the picture to look from elsewhere.</source>
        <translation>Die Leertaste hält sie an. Ziehen Sie in der Zeitleiste, um einen Moment anzusehen, und im Bild, um von anderswo zu schauen.</translation>
    </message>
    <message>
        <source>Off the truth by %1.</source>
        <translation>Abweichung von der Wahrheit: %1.</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation>%1   %2</translation>
    </message>
    <message>
        <source>%1 of motion, %2 frames at %3 Hz</source>
        <translation>%1 Bewegung, %2 Bilder mit %3 Hz</translation>
    </message>
    <message>
        <source>%1, smoothing: %2</source>
        <translation>%1, Glättung: %2</translation>
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
    <message>
        <source>Name the sensor board, and say which sensor is worn where</source>
        <translation>Die Sensorplatine benennen und sagen, welcher Sensor wo getragen wird</translation>
    </message>
    <message>
        <source>Where the signal comes from: a sound card&apos;s line input, a driver box, or the simulator</source>
        <translation>Woher das Signal kommt: vom Line-Eingang einer Soundkarte, von einer Treiberbox oder vom Simulator</translation>
    </message>
    <message>
        <source>Driver box at another port</source>
        <translation>Treiberbox an einem anderen Anschluss</translation>
    </message>
    <message>
        <source>Serial port of the driver box, or the link of an emulator:</source>
        <translation>Serieller Anschluss der Treiberbox oder Verweis eines Emulators:</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Driver box at another port…</source>
        <translation>Treiberbox an einem anderen Anschluss …</translation>
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
    <message>
        <source>Animation: %1</source>
        <translation>Animation: %1</translation>
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
        <translation>Bereichskalibrierung wird berechnet</translation>
    </message>
    <message>
        <source>Computing the mounting</source>
        <translation>Befestigung wird berechnet</translation>
    </message>
    <message>
        <source>other movement to calibrate from</source>
        <translation>andere Bewegung zum Kalibrieren</translation>
    </message>
    <message>
        <source>other stretch to calibrate from</source>
        <translation>anderer Abschnitt zum Kalibrieren</translation>
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
        <translation>Bereich: Sensoren werden gedreht</translation>
    </message>
    <message>
        <source>Mounting: two poses of %1</source>
        <translation>Befestigung: zwei Posen, %1</translation>
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
    <name>limbwave::ui::StudioApplication</name>
    <message>
        <source>Something unexpected happened (%1).</source>
        <translation>Etwas Unerwartetes ist geschehen (%1).</translation>
    </message>
    <message>
        <source>What is recorded is kept. If it happens again, start the studio anew.</source>
        <translation>Was aufgenommen ist, bleibt erhalten. Geschieht es wieder, starten Sie das Studio neu.</translation>
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
    <message>
        <source>Open an animation</source>
        <translation>Eine Animation öffnen</translation>
    </message>
    <message>
        <source>A calibration is under way.</source>
        <translation>Eine Kalibrierung läuft.</translation>
    </message>
    <message>
        <source>Finish or leave it before another take is opened.</source>
        <translation>Beenden oder verlassen Sie sie, bevor ein anderer Take geöffnet wird.</translation>
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
    <name>limbwave::ui::TakeEdits</name>
    <message>
        <source>The sensors stay as they are</source>
        <translation>Die Sensoren bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>sensors of the take</source>
        <translation>Sensoren des Takes</translation>
    </message>
    <message>
        <source>details of the take</source>
        <translation>Angaben zum Take</translation>
    </message>
    <message>
        <source>subject of the take</source>
        <translation>Person des Takes</translation>
    </message>
    <message>
        <source>name of the take</source>
        <translation>Name des Takes</translation>
    </message>
    <message>
        <source>The take is called %1 as soon as nothing works on it any more.</source>
        <translation>Der Take heißt %1, sobald nichts mehr an ihm arbeitet.</translation>
    </message>
    <message>
        <source>The take keeps its name</source>
        <translation>Der Take behält seinen Namen</translation>
    </message>
    <message>
        <source>The change is not saved in the take</source>
        <translation>Die Änderung ist nicht im Take gespeichert</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::TakeSheet</name>
    <message>
        <source>Details of the take</source>
        <translation>Angaben zum Take</translation>
    </message>
    <message>
        <source>The signals stay as they were recorded. When sensors were mixed up, say here which one was worn where: the take is solved anew.</source>
        <translation>Die Signale bleiben, wie sie aufgenommen wurden. Wurden Sensoren vertauscht, sagen Sie hier, welcher wo getragen wurde: Der Take wird neu berechnet.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Take</translation>
    </message>
    <message>
        <source>Subject</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Who wore the sensors</source>
        <translation>Wer die Sensoren trug</translation>
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
    <message>
        <source>Double-click sets a marker</source>
        <translation>Doppelklick setzt eine Marke</translation>
    </message>
    <message>
        <source>Name of the marker</source>
        <translation>Name der Marke</translation>
    </message>
    <message>
        <source>Delete the selected keys</source>
        <translation>Die gewählten Schlüssel löschen</translation>
    </message>
    <message>
        <source>Rename the marker</source>
        <translation>Marke umbenennen</translation>
    </message>
    <message>
        <source>Delete the marker</source>
        <translation>Marke löschen</translation>
    </message>
    <message>
        <source>Set a marker here</source>
        <translation>Hier eine Marke setzen</translation>
    </message>
    <message>
        <source>Set a key here</source>
        <translation>Hier einen Schlüssel setzen</translation>
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
    <message>
        <source>Delete the selected keys or the selected marker</source>
        <translation>Die gewählten Schlüssel oder die gewählte Marke löschen</translation>
    </message>
    <message>
        <source>%1   Space plays</source>
        <translation>%1   Leertaste spielt ab</translation>
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
        <translation>Nur diesen wiederholen</translation>
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
        <translation>Braucht eine laufende Erfassung</translation>
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
        <source>Recent takes</source>
        <translation>Letzte Takes</translation>
    </message>
    <message>
        <source>Try it without hardware</source>
        <translation>Ohne Hardware ausprobieren</translation>
    </message>
    <message>
        <source>Records what low-cost sensors on a body feel and turns it into animation for Blender, Maya, MotionBuilder, Unreal and Unity.</source>
        <translation>Nimmt auf, was günstige Sensoren am Körper spüren, und macht daraus Animation für Blender, Maya, MotionBuilder, Unreal und Unity.</translation>
    </message>
    <message>
        <source>Open animation</source>
        <translation>Animation öffnen</translation>
    </message>
    <message>
        <source>BVH, FBX or glTF of another program, to look at it and to export it on</source>
        <translation>BVH, FBX oder glTF eines anderen Programms, zum Ansehen und Weitergeben</translation>
    </message>
    <message>
        <source>or drop recordings, takes and animations anywhere on this window</source>
        <translation>oder Aufnahmen, Takes und Animationen irgendwo auf dieses Fenster ziehen</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>From the wiring to the animation (F1)</source>
        <translation>Von der Verkabelung zur Animation (F1)</translation>
    </message>
</context>
<context>
    <name>limbwave::ui::WireView</name>
    <message>
        <source>Wires of the driver box</source>
        <translation>Kabel der Treiberbox</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>All wires are well.</source>
        <translation>Alle Kabel sind in Ordnung.</translation>
    </message>
    <message>
        <source>pulled out</source>
        <translation>herausgezogen</translation>
    </message>
    <message>
        <source>not understood</source>
        <translation>nicht zu verstehen</translation>
    </message>
    <message>
        <source>listening</source>
        <translation>wird abgehört</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>stumm</translation>
    </message>
    <message>
        <source>no words</source>
        <translation>keine Worte</translation>
    </message>
    <message>
        <source>frozen</source>
        <translation>eingefroren</translation>
    </message>
    <message>
        <source>clips</source>
        <translation>übersteuert</translation>
    </message>
    <message>
        <source>well</source>
        <translation>in Ordnung</translation>
    </message>
    <message>
        <source>Wire %1, %2: %3. Words lost: %4 of %5; bits put right: %6.</source>
        <translation>Kabel %1, %2: %3. Verlorene Worte: %4 von %5; berichtigte Bits: %6.</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Platine</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>Words/s</source>
        <translation>Worte/s</translation>
    </message>
    <message>
        <source>Ranges/s</source>
        <translation>Entfernungen/s</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>The box is away.</source>
        <translation>Die Box ist fort.</translation>
    </message>
    <message>
        <source>well, no source in sight</source>
        <translation>in Ordnung, keine Quelle in Sicht</translation>
    </message>
    <message>
        <source>away</source>
        <translation>fort</translation>
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
        <source>Take folder or animation to open, or recordings to import.</source>
        <translation>Take-Ordner oder Animation zum Öffnen oder Aufnahmen zum Importieren.</translation>
    </message>
</context>
</TS>
