// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QKeySequence>
#include <QMap>
#include <QString>
#include <QStringList>

#include <optional>

namespace editor {

enum class Theme { System, Light, Dark };

/// What is remembered from one session to the next. Takes any garbage that a settings file may hold, or what a newer
/// version wrote, as if nothing were there: a getter never fails.
class Settings
{
public:
    static constexpr int MaxRecentFiles = 12;

    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray &geometry);
    /// Docks and toolbars as QMainWindow::saveState gives them, by the name of what they are arranged for.
    QByteArray windowState(const QString &name) const;
    void setWindowState(const QString &name, const QByteArray &state);

    Theme theme() const;
    void setTheme(Theme theme);

    /// "en", "cs"; empty for the system's.
    QString language() const;
    void setLanguage(const QString &code);

    /// An existing folder: the one of the last file, else the home folder.
    QString lastFolder() const;
    void setLastFolder(const QString &folder);

    /// Absolute paths, newest first; files that are gone included.
    QStringList recentFiles() const;
    void addRecentFile(const QString &path);
    void removeRecentFile(const QString &path);
    void clearRecentFiles();

    /// What the user chose for an action; nothing if it keeps its default, an empty list if it was taken away.
    std::optional<QList<QKeySequence>> shortcuts(const QString &actionKey) const;
    void setShortcuts(const QString &actionKey, const std::optional<QList<QKeySequence>> &shortcuts);

    /// Over the picture: sizes and times.
    bool statisticsVisible() const;
    void setStatisticsVisible(bool visible);
};

} // namespace editor
