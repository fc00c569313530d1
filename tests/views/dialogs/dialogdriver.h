// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"

#include <QDialog>
#include <QString>
#include <QTest>

namespace tests {

/// The widget of this object name (and type) in a dialog; a missing one fails loudly.
template <class Widget>
Widget *find(const QWidget &dialog, const char *objectName)
{
    auto *widget = dialog.findChild<Widget *>(QLatin1String(objectName));
    if (!widget)
        qFatal("no %s in the dialog", objectName);
    return widget;
}

/// Shows a dialog and waits until it takes keys.
void open(QDialog &dialog);

/// Replaces the text of the line edit in the field of this object name, letter by letter.
void typeInto(const QWidget &dialog, const char *fieldName, const QString &text);

void click(const QWidget &dialog, const char *buttonName);

/// What a label or the line edit in a field says.
QString textOf(const QWidget &dialog, const char *objectName);

/// Answers the next message box by the button of this text, once it is there. `seen` gets the box's text.
void answerMessageBox(const QString &button, QString *seen = nullptr);

/// Writes an animation as OBJ frames; returns the folder's path.
QString writeObjFrames(const QString &folder, const model::FrameSource &frames);

/// Focusable widgets without a name that a screen reader could say.
QStringList unnamedWidgets(const QWidget &dialog);

} // namespace tests
