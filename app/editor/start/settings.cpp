// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/settings.h"

#include <QCoreApplication>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QPointer>
#include <QSettings>
#include <QThreadPool>

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

/// Writes to the disk in another thread: it waits until the bytes are safe, which on a slow disk takes long.
class QuickSettings final : public QSettings
{
public:
    using QSettings::QSettings;

protected:
    bool event(QEvent *event) override
    {
        if (event->type() != QEvent::UpdateRequest) // asked for by a change
            return QSettings::event(event);
        // All instances of a file share what is not written yet; the destructor writes what this came too late for.
        QThreadPool::globalInstance()->start([] { QSettings().sync(); });
        return true;
    }
};

QSettings &store()
{
    static const QPointer<QSettings> settings = new QuickSettings(QCoreApplication::instance());
    return *settings;
}

} // namespace

QByteArray Settings::windowGeometry() const
{
    return store().value(GeometryKey).toByteArray();
}

void Settings::setWindowGeometry(const QByteArray &geometry)
{
    store().setValue(GeometryKey, geometry);
}

QByteArray Settings::windowState(const QString &name) const
{
    return store().value(StateGroup + name).toByteArray();
}

void Settings::setWindowState(const QString &name, const QByteArray &state)
{
    store().setValue(StateGroup + name, state);
}

Theme Settings::theme() const
{
    const QString stored = store().value(ThemeKey).toString();
    for (const auto &[theme, name] : ThemeNames)
        if (stored == name)
            return theme;
    return Theme::System;
}

void Settings::setTheme(Theme theme)
{
    for (const auto &[known, name] : ThemeNames)
        if (known == theme)
            store().setValue(ThemeKey, QString(name));
}

QString Settings::language() const
{
    return store().value(LanguageKey).toString();
}

void Settings::setLanguage(const QString &code)
{
    store().setValue(LanguageKey, code);
}

QString Settings::lastFolder() const
{
    const QString stored = store().value(LastFolderKey).toString();
    return !stored.isEmpty() && QFileInfo(stored).isDir() ? stored : QDir::homePath();
}

void Settings::setLastFolder(const QString &folder)
{
    store().setValue(LastFolderKey, folder);
}

QStringList Settings::recentFiles() const
{
    QStringList result;
    const QStringList stored = store().value(RecentKey).toStringList();
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
    store().setValue(RecentKey, files.mid(0, MaxRecentFiles));
}

void Settings::removeRecentFile(const QString &path)
{
    QStringList files = recentFiles();
    files.removeAll(path);
    store().setValue(RecentKey, files);
}

void Settings::clearRecentFiles()
{
    store().remove(RecentKey);
}

std::optional<QList<QKeySequence>> Settings::shortcuts(const QString &actionKey) const
{
    const QVariant stored = store().value(ShortcutsGroup + actionKey);
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
        store().setValue(ShortcutsGroup + actionKey,
                         QKeySequence::listToString(*shortcuts, QKeySequence::PortableText));
    else
        store().remove(ShortcutsGroup + actionKey);
}

bool Settings::statisticsVisible() const
{
    return store().value(StatisticsKey, true).toBool();
}

void Settings::setStatisticsVisible(bool visible)
{
    store().setValue(StatisticsKey, visible);
}

} // namespace editor
