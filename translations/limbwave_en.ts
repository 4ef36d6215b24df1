<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>BoxHistoryWords</name>
    <message numerus="yes">
        <source>%n word(s) lost</source>
        <translation>
            <numerusform>%n word lost</numerusform>
            <numerusform>%n words lost</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StatusFacts</name>
    <message numerus="yes">
        <source>box: %n gap(s)</source>
        <translation>
            <numerusform>box: %n gap</numerusform>
            <numerusform>box: %n gaps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>limbwave::ui::KeyEditor</name>
    <message numerus="yes">
        <source>move %n key(s)</source>
        <translation>
            <numerusform>move %n key</numerusform>
            <numerusform>move %n keys</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>turn %n key(s)</source>
        <translation>
            <numerusform>turn %n key</numerusform>
            <numerusform>turn %n keys</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>delete %n key(s)</source>
        <translation>
            <numerusform>delete %n key</numerusform>
            <numerusform>delete %n keys</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>limbwave::ui::QualityCard</name>
    <message numerus="yes">
        <source>and %n more finding(s)</source>
        <translation>
            <numerusform>and %n more finding</numerusform>
            <numerusform>and %n more findings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>limbwave::ui::RecordBanner</name>
    <message numerus="yes">
        <source>Recording begins in %n second(s)</source>
        <translation>
            <numerusform>Recording begins in %n second</numerusform>
            <numerusform>Recording begins in %n seconds</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>limbwave::ui::RecordPanel</name>
    <message numerus="yes">
        <source>Recording begins in %n second(s)</source>
        <translation>
            <numerusform>Recording begins in %n second</numerusform>
            <numerusform>Recording begins in %n seconds</numerusform>
        </translation>
    </message>
</context>
</TS>
