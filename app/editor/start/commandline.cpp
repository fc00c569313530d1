// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/commandline.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>

namespace editor {

namespace {

constexpr int UsageError = 2;

struct CommandLine
{
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

std::optional<int> number(const QString &value, int min, int max)
{
    bool ok = false;
    const int result = value.toInt(&ok);
    return ok && result >= min && result <= max ? std::optional(result) : std::nullopt;
}

std::optional<QSize> size(const QString &value)
{
    static const QRegularExpression pattern(QStringLiteral("^(\\d{2,5})x(\\d{2,5})$"));
    const auto match = pattern.match(value);
    if (!match.hasMatch())
        return std::nullopt;
    return QSize(match.captured(1).toInt(), match.captured(2).toInt());
}

std::optional<Theme> theme(const QString &value)
{
    if (value == QLatin1String("light"))
        return Theme::Light;
    if (value == QLatin1String("dark"))
        return Theme::Dark;
    if (value == QLatin1String("system"))
        return Theme::System;
    return std::nullopt;
}

} // namespace

StartOptions parseCommandLine(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(CommandLine::tr("Sandreel plays mesh animations and shapes sandy terrain."));
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    const QCommandLineOption languageOption(
        QStringLiteral("language"), CommandLine::tr("Language of the interface: en or cs."), QStringLiteral("CODE"));
    const QCommandLineOption themeOption(QStringLiteral("theme"), CommandLine::tr("Colours: light, dark or system."),
                                         QStringLiteral("NAME"));
    const QCommandLineOption sizeOption(
        QStringLiteral("size"), CommandLine::tr("Size of the window, for example 1280x800."), QStringLiteral("WxH"));
    const QCommandLineOption frameOption(QStringLiteral("frame"), CommandLine::tr("Go to this frame; the first is 1."),
                                         QStringLiteral("N"));
    const QCommandLineOption compareOption(QStringLiteral("compare"),
                                           CommandLine::tr("Show what the last animation lost of this original."),
                                           QStringLiteral("PATH"));
    const QCommandLineOption playOption(QStringLiteral("play"), CommandLine::tr("Start playing."));
    const QCommandLineOption screenshotOption(QStringLiteral("screenshot"),
                                              CommandLine::tr("Write a picture of the window to FILE and quit."),
                                              QStringLiteral("FILE"));
    const QCommandLineOption afterOption(QStringLiteral("after"),
                                         CommandLine::tr("Wait this many milliseconds after everything is open."),
                                         QStringLiteral("MS"));
    parser.addOptions({languageOption, themeOption, sizeOption, frameOption, compareOption, playOption,
                       screenshotOption, afterOption});
    parser.addPositionalArgument(
        QStringLiteral("files"),
        CommandLine::tr("Animations to open; folders, point caches, scenes and meshes to prepare."),
        QStringLiteral("[files...]"));

    StartOptions options;
    const auto refuse = [&](const QString &reason) {
        options.exit = StartOptions::Exit{UsageError, reason + QLatin1Char('\n')};
        return options;
    };
    if (!parser.parse(arguments))
        return refuse(parser.errorText());
    if (parser.isSet(help)) {
        options.exit = StartOptions::Exit{0, parser.helpText()};
        return options;
    }
    if (parser.isSet(version)) {
        options.exit =
            StartOptions::Exit{0, QStringLiteral("Sandreel %1\n").arg(QCoreApplication::applicationVersion())};
        return options;
    }
    const auto refuseValue = [&](const QCommandLineOption &option) {
        return refuse(CommandLine::tr("Option --%1 does not take the value \"%2\".")
                          .arg(option.names().constFirst(), parser.value(option)));
    };
    if (parser.isSet(languageOption)) {
        options.language = parser.value(languageOption);
        if (*options.language != QLatin1String("en") && *options.language != QLatin1String("cs"))
            return refuseValue(languageOption);
    }
    if (parser.isSet(themeOption) && !(options.theme = theme(parser.value(themeOption))))
        return refuseValue(themeOption);
    if (parser.isSet(sizeOption) && !(options.size = size(parser.value(sizeOption))))
        return refuseValue(sizeOption);
    if (parser.isSet(frameOption) && !(options.frame = number(parser.value(frameOption), 1, 1 << 30)))
        return refuseValue(frameOption);
    if (parser.isSet(afterOption)) {
        const auto delay = number(parser.value(afterOption), 0, 600000);
        if (!delay)
            return refuseValue(afterOption);
        options.screenshotDelay = *delay;
    }
    if (parser.isSet(compareOption))
        options.original = QFileInfo(parser.value(compareOption)).absoluteFilePath();
    options.play = parser.isSet(playOption);
    options.screenshot = parser.value(screenshotOption);
    const QStringList paths = parser.positionalArguments();
    for (const QString &path : paths)
        options.paths << QFileInfo(path).absoluteFilePath();
    return options;
}

} // namespace editor
