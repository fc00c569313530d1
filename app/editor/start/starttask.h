// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/start/commandline.h"

#include <QObject>
#include <QTimer>

namespace editor {

class MainWindow;

/// What the command line wants once everything is open: a comparison, a frame, play, a picture of the window (after
/// which the program ends: 0 if the picture was written, else 4).
class StartTask final : public QObject
{
    Q_OBJECT

public:
    StartTask(MainWindow &window, StartOptions options);

private:
    void proceed();
    void takeScreenshot();

    MainWindow &mWindow;
    const StartOptions mOptions;
    QTimer mPolling;
    bool mIsComparing = false; ///< begun
};

} // namespace editor
