// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/settings.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace editor {

namespace {

constexpr auto GeometryKey = "window/geometry";
constexpr auto StateGroup = "window/state/";
constexpr auto ThemeKey = "interface/theme";
constexpr auto LanguageKey = "interface/language";
constexpr auto LastFolderKey = "files/lastFolder";
constexpr auto RecentKey = "files/recent";
constexpr auto StatisticsKey = "view/statistics";
constexpr auto ShortcutsGroup = "shortcuts/";

const std::pair<Theme, QLatin1String> ThemeNames[] = {
    {Theme::System, QLatin1String("system")},
    {Theme::Light, QLatin1String("light")},
    {Theme::Dark, QLatin1String("dark")},
};

} // namespace

QByteArray Settings::windowGeometry() const
{
    return QSettings().value(GeometryKey).toByteArray();
}

void Settings::setWindowGeometry(const QByteArray &geometry)
{
    QSettings().setValue(GeometryKey, geometry);
}

QByteArray Settings::windowState(const QString &name) const
{
    return QSettings().value(StateGroup + name).toByteArray();
}

void Settings::setWindowState(const QString &name, const QByteArray &state)
{
    QSettings().setValue(StateGroup + name, state);
}

Theme Settings::theme() const
{
    const QString stored = QSettings().value(ThemeKey).toString();
    for (const auto &[theme, name] : ThemeNames)
        if (stored == name)
            return theme;
    return Theme::System;
}

void Settings::setTheme(Theme theme)
{
    for (const auto &[known, name] : ThemeNames)
        if (known == theme)
            QSettings().setValue(ThemeKey, QString(name));
}

QString Settings::language() const
{
    return QSettings().value(LanguageKey).toString();
}

void Settings::setLanguage(const QString &code)
{
    QSettings().setValue(LanguageKey, code);
}

QString Settings::lastFolder() const
{
    const QString stored = QSettings().value(LastFolderKey).toString();
    return !stored.isEmpty() && QFileInfo(stored).isDir() ? stored : QDir::homePath();
}

void Settings::setLastFolder(const QString &folder)
{
    QSettings().setValue(LastFolderKey, folder);
}

QStringList Settings::recentFiles() const
{
    QStringList result;
    const QStringList stored = QSettings().value(RecentKey).toStringList();
    for (const QString &path : stored)
        if (QFileInfo(path).isAbsolute() && !result.contains(path) && result.size() < MaxRecentFiles)
            result << path;
    return result;
}

void Settings::addRecentFile(const QString &path)
{
    QStringList files = recentFiles();
    files.removeAll(path);
    files.prepend(path);
    QSettings().setValue(RecentKey, files.mid(0, MaxRecentFiles));
}

void Settings::removeRecentFile(const QString &path)
{
    QStringList files = recentFiles();
    files.removeAll(path);
    QSettings().setValue(RecentKey, files);
}

void Settings::clearRecentFiles()
{
    QSettings().remove(RecentKey);
}

std::optional<QList<QKeySequence>> Settings::shortcuts(const QString &actionKey) const
{
    const QVariant stored = QSettings().value(ShortcutsGroup + actionKey);
    if (!stored.isValid())
        return std::nullopt;
    QList<QKeySequence> result;
    const QList<QKeySequence> sequences = QKeySequence::listFromString(stored.toString(), QKeySequence::PortableText);
    for (const QKeySequence &sequence : sequences)
        if (!sequence.isEmpty() && !sequence.toString().isEmpty())
            result << sequence;
    return result;
}

void Settings::setShortcuts(const QString &actionKey, const std::optional<QList<QKeySequence>> &shortcuts)
{
    if (shortcuts)
        QSettings().setValue(ShortcutsGroup + actionKey,
                             QKeySequence::listToString(*shortcuts, QKeySequence::PortableText));
    else
        QSettings().remove(ShortcutsGroup + actionKey);
}

bool Settings::statisticsVisible() const
{
    return QSettings().value(StatisticsKey, true).toBool();
}

void Settings::setStatisticsVisible(bool visible)
{
    QSettings().setValue(StatisticsKey, visible);
}

} // namespace editor
