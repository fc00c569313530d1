<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Undo</name>
    <message numerus="yes">
        <source>Trim to %n Frame(s)</source>
        <translation>
            <numerusform>Trim to %n Frame</numerusform>
            <numerusform>Trim to %n Frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>editor::FileActions</name>
    <message numerus="yes">
        <source>%n document(s) have unsaved changes.</source>
        <translation>
            <numerusform>%n document has unsaved changes.</numerusform>
            <numerusform>%n documents have unsaved changes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>editor::OpenMesh</name>
    <message numerus="yes">
        <source>It is one of %n numbered meshes in its folder. To open them as an animation, drop the folder here, or choose it in File &gt; Prepare Animation.</source>
        <translation>
            <numerusform>It is one of %n numbered mesh in its folder. To open them as an animation, drop the folder here, or choose it in File &gt; Prepare Animation.</numerusform>
            <numerusform>It is one of %n numbered meshes in its folder. To open them as an animation, drop the folder here, or choose it in File &gt; Prepare Animation.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>editor::RecordActions</name>
    <message numerus="yes">
        <source>Recording %1: %n frame(s)</source>
        <translation>
            <numerusform>Recording %1: %n frame</numerusform>
            <numerusform>Recording %1: %n frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>editor::RecoveryDialog</name>
    <message numerus="yes">
        <source>%n terrain(s) cannot be recovered any more after this.</source>
        <translation>
            <numerusform>%n terrain cannot be recovered any more after this.</numerusform>
            <numerusform>%n terrains cannot be recovered any more after this.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>views::ExportFramesDialog</name>
    <message numerus="yes">
        <source>%n file(s) will be written.</source>
        <translation>
            <numerusform>%n file will be written.</numerusform>
            <numerusform>%n files will be written.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>views::ExportPicturesDialog</name>
    <message numerus="yes">
        <source>%n picture(s) of %1 × %2 pixels. At %3 frames per second they last %4.</source>
        <translation>
            <numerusform>%n picture of %1 × %2 pixels. At %3 frames per second it lasts %4.</numerusform>
            <numerusform>%n pictures of %1 × %2 pixels. At %3 frames per second they last %4.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>views::HistoryDock</name>
    <message numerus="yes">
        <source>%n older steps were dropped to stay within the limit.</source>
        <translation>
            <numerusform>%n older step was dropped to stay within the limit.</numerusform>
            <numerusform>%n older steps were dropped to stay within the limit.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>views::TurntableDialog</name>
    <message numerus="yes">
        <source>%n picture(s) of %1 × %2 pixels. At %3 pictures per second they last %4.</source>
        <translation>
            <numerusform>%n picture of %1 × %2 pixels. At %3 pictures per second it lasts %4.</numerusform>
            <numerusform>%n pictures of %1 × %2 pixels. At %3 pictures per second they last %4.</numerusform>
        </translation>
    </message>
</context>
</TS>
