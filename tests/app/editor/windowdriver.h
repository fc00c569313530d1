// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/animationtab.h"
#include "app/editor/documents/terraintab.h"
#include "app/editor/start/language.h"
#include "app/editor/window/mainwindow.h"
#include "model/animation/compressionsettings.h"

#include <QTemporaryDir>

#include <functional>

class QDialog;

namespace tests {

/// A shown main window, driven as a person does.
struct WindowDriver
{
    WindowDriver();

    /// Precondition: the current tab is an animation's.
    editor::OpenAnimation &document() { return window.workspace().currentAnimation()->document(); }
    /// Precondition: the current tab is a terrain's.
    editor::OpenTerrain &terrain() { return window.workspace().currentTerrain()->document(); }
    QAction &action(editor::ActionId id) { return window.actions()[id]; }
    /// Waits until nothing is being opened or saved.
    bool settle();
    /// Opens what cannot be but an `.anim`, and waits.
    bool open(const QString &path);

    editor::Language language;
    editor::MainWindow window;
};

/// A small `.anim` file of our own in `folder`.
QString makeAnim(const QTemporaryDir &folder, const QString &name = QStringLiteral("wave.anim"),
                 const model::CompressionSettings &settings = {model::PcaSettings()});

/// Does `what` with the next modal dialog, as soon as it is there.
void withNextDialog(std::function<void(QDialog &)> what);
/// Clicks the button with this text (without mnemonic); fails the test if there is none.
void clickButton(QWidget &dialog, const QString &text);

} // namespace tests
