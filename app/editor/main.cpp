// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/commandline.h"
#include "app/editor/start/language.h"
#include "app/editor/start/starttask.h"
#include "app/editor/window/mainwindow.h"
#include "app/editor/window/theme.h"
#include "views/viewport/glsupport.h"
#include "views/widgets/icons.h"

#include <QApplication>

#include <cstdio>
#include <optional>

namespace {

/// Help, version and refusals must work without a display, hence before a QApplication.
std::optional<int> exitEarly(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    const editor::StartOptions options = editor::parseCommandLine(QCoreApplication::arguments());
    if (!options.exit)
        return std::nullopt;
    std::fputs(qPrintable(options.exit->text), options.exit->code == 0 ? stdout : stderr);
    return options.exit->code;
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication::setOrganizationName(QStringLiteral("Sandreel"));
    QCoreApplication::setApplicationName(QStringLiteral("sandreel"));
    QCoreApplication::setApplicationVersion(QStringLiteral(SANDREEL_VERSION));
    if (const std::optional<int> code = exitEarly(argc, argv))
        return *code;

    views::setDefaultGlFormat();
    QApplication application(argc, argv);
    QApplication::setApplicationDisplayName(QStringLiteral("Sandreel"));
    QApplication::setDesktopFileName(QStringLiteral("sandreel"));
    QApplication::setWindowIcon(views::applicationIcon());
    const editor::StartOptions options = editor::parseCommandLine(QCoreApplication::arguments());
    const editor::Settings settings;
    editor::Language language;
    language.apply(options.language.value_or(settings.language()));
    editor::applyTheme(options.theme.value_or(settings.theme()));

    editor::MainWindow window(language);
    if (options.size)
        window.resize(*options.size);
    window.show();
    window.open(options.paths);
    window.offerRecovery();
    const editor::StartTask task(window, options);
    return QApplication::exec();
}
