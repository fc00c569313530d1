// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/start/settings.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

namespace editor {

/// What the program was asked to do when it was started.
struct StartOptions
{
    QStringList paths; ///< absolute
    std::optional<QString> language;
    std::optional<Theme> theme;
    std::optional<QSize> size;
    std::optional<int> frame; ///< counted from 1, as everywhere in the interface
    QString original;         ///< to compare the last of `paths` with; absolute, empty: none
    bool play = false;
    QString screenshot; ///< empty: none
    int screenshotDelay = 1500;

    /// Set if the program should print `text` and end instead.
    struct Exit
    {
        int code;
        QString text;
    };
    std::optional<Exit> exit;
};

/// \param arguments  with the program's name first
StartOptions parseCommandLine(const QStringList &arguments);

} // namespace editor
