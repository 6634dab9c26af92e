<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>PassagesPage</name>
    <message numerus="yes">
        <source>%n passage(s) deleted.</source>
        <translation>
            <numerusform>%n passage deleted.</numerusform>
            <numerusform>%n passages deleted.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>narrative</name>
    <message numerus="yes">
        <source>%n gybe(s)</source>
        <translation>
            <numerusform>%n gybe</numerusform>
            <numerusform>%n gybes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tack(s)</source>
        <translation>
            <numerusform>%n tack</numerusform>
            <numerusform>%n tacks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ways</name>
    <message numerus="yes">
        <source>%n turn(s) instead of {others}:</source>
        <translation>
            <numerusform>%n turn instead of {others}:</numerusform>
            <numerusform>%n turns instead of {others}:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turn(s):</source>
        <translation>
            <numerusform>%n turn:</numerusform>
            <numerusform>%n turns:</numerusform>
        </translation>
    </message>
</context>
</TS>
