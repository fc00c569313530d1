// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of Qt itself that every session shows, so that they are translated where Qt's own translations are not
// installed. Only read by lupdate.
#include <QCoreApplication>

namespace editor {

[[maybe_unused]] constexpr const char *ButtonTexts[] = {
    QT_TRANSLATE_NOOP("QPlatformTheme", "OK"),       QT_TRANSLATE_NOOP("QPlatformTheme", "Save"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Save All"), QT_TRANSLATE_NOOP("QPlatformTheme", "Open"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "&Yes"),     QT_TRANSLATE_NOOP("QPlatformTheme", "&No"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Cancel"),   QT_TRANSLATE_NOOP("QPlatformTheme", "Close"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Discard"),  QT_TRANSLATE_NOOP("QPlatformTheme", "Help"),
};

} // namespace editor
