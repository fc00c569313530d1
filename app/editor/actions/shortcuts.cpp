// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/shortcuts.h"

namespace editor {

void applyShortcuts(const Actions &actions, const Settings &settings)
{
    for (const Actions::Entry &entry : actions.entries())
        entry.action->setShortcuts(settings.shortcuts(entry.key()).value_or(entry.defaultShortcuts));
}

std::vector<const Actions::Entry *> entriesWithKey(const Actions &actions, const QKeySequence &key,
                                                   const Actions::Entry *except)
{
    std::vector<const Actions::Entry *> result;
    const auto areNeverTogether = [except](const Actions::Entry &entry) {
        return except && except->kind && entry.kind && except->kind != entry.kind;
    };
    for (const Actions::Entry &entry : actions.entries())
        if (&entry != except && !areNeverTogether(entry) && entry.action->shortcuts().contains(key))
            result.push_back(&entry);
    return result;
}

QString shortcutText(const QList<QKeySequence> &shortcuts)
{
    QStringList parts;
    for (const QKeySequence &sequence : shortcuts)
        parts << sequence.toString(QKeySequence::NativeText);
    return parts.join(QStringLiteral(", "));
}

} // namespace editor
