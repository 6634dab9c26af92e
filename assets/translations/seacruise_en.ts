<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
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
</TS>
