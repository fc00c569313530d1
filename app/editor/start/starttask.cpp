// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/starttask.h"

#include "app/editor/documents/animationtab.h"
#include "app/editor/window/mainwindow.h"
#include "views/dialogs/comparedialog.h"

#include <QApplication>
#include <QFileInfo>
#include <QPixmap>
#include <QScreen>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace editor {

namespace {

constexpr int PollMilliseconds = 20;
constexpr int CannotWrite = 4;

} // namespace

StartTask::StartTask(MainWindow &window, StartOptions options)
    : mWindow(window)
    , mOptions(std::move(options))
{
    mPolling.setInterval(PollMilliseconds);
    connect(&mPolling, &QTimer::timeout, this, &StartTask::proceed);
    if (mOptions.frame || mOptions.play || !mOptions.original.isEmpty() || !mOptions.screenshot.isEmpty())
        mPolling.start();
}

void StartTask::proceed()
{
    const auto tabs = mWindow.workspace().tabs();
    if (std::any_of(tabs.begin(), tabs.end(), [](DocumentTab *tab) { return tab->document().isOpening(); }))
        return;
    if (AnimationTab *tab = mWindow.workspace().currentAnimation(); tab && tab->document().isOpen()) {
        views::Comparison &comparison = tab->document().comparison();
        if (!mOptions.original.isEmpty() && !std::exchange(mIsComparing, true)) {
            mWindow.actions()[ActionId::ErrorColors].setChecked(true);
            comparison.start(QFileInfo(mOptions.original).fileName(),
                             views::originalReader(mOptions.original, model::Normalisation::None));
        }
        if (comparison.isReading() || comparison.isMeasuring())
            return;
    }
    mPolling.stop();
    if (AnimationTab *tab = mWindow.workspace().currentAnimation()) {
        if (mOptions.frame)
            tab->document().player().seek(*mOptions.frame - 1);
        if (mOptions.play)
            tab->document().player().play();
    }
    if (!mOptions.screenshot.isEmpty())
        QTimer::singleShot(mOptions.screenshotDelay, this, &StartTask::takeScreenshot);
}

void StartTask::takeScreenshot()
{
    // Not QWidget::grab(): that loses what is painted over the OpenGL picture.
    const QPixmap picture = mWindow.screen()->grabWindow(mWindow.winId());
    const bool written = !picture.isNull() && picture.save(mOptions.screenshot);
    if (!written)
        std::fprintf(stderr, "sandreel: cannot write %s\n", qPrintable(mOptions.screenshot));
    QApplication::exit(written ? 0 : CannotWrite);
}

} // namespace editor
