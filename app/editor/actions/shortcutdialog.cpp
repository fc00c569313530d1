// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/shortcutdialog.h"

#include "app/editor/actions/shortcuts.h"
#include "views/widgets/icons.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace editor {

ShortcutDialog::ShortcutDialog(const Actions &actions, Settings &settings, QWidget *parent)
    : QDialog(parent)
    , mActions(actions)
    , mSettings(settings)
    , mSearch(new QLineEdit(this))
    , mTree(new QTreeWidget(this))
    , mKeys(new QKeySequenceEdit(this))
    , mAssign(new QPushButton(tr("&Assign"), this))
    , mClear(new QPushButton(tr("&Clear"), this))
    , mReset(new QPushButton(tr("&Default"), this))
    , mConflict(new QLabel(this))
{
    setWindowTitle(tr("Configure Shortcuts"));
    setObjectName(QStringLiteral("shortcutDialog"));
    resize(560, 620);

    mSearch->setPlaceholderText(tr("Search actions or keys"));
    mSearch->setAccessibleName(tr("Search"));
    mSearch->setClearButtonEnabled(true);
    mSearch->addAction(views::icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    mTree->setHeaderLabels({tr("Action"), tr("Shortcut")});
    mTree->setAccessibleName(tr("Actions"));
    mTree->setUniformRowHeights(true);
    mTree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    mTree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    mTree->header()->setStretchLastSection(false);
    mKeys->setAccessibleName(tr("New shortcut"));
    mKeys->setToolTip(tr("Press the keys"));
    mConflict->setWordWrap(true);
    mConflict->setObjectName(QStringLiteral("conflict"));
    mConflict->setMinimumHeight(2 * fontMetrics().lineSpacing());
    mConflict->setAlignment(Qt::AlignTop);

    auto *label = new QLabel(tr("&New shortcut:"), this);
    label->setBuddy(mKeys);
    auto *row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(mKeys, 1);
    row->addWidget(mAssign);
    row->addWidget(mClear);
    row->addWidget(mReset);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton *all = buttons->addButton(tr("Default for A&ll"), QDialogButtonBox::ResetRole);
    all->setObjectName(QStringLiteral("resetAll"));
    auto *column = new QVBoxLayout(this);
    column->addWidget(mSearch);
    column->addWidget(mTree, 1);
    column->addLayout(row);
    column->addWidget(mConflict);
    column->addWidget(buttons);
    for (QPushButton *button : {mAssign, mClear, mReset, all})
        button->setAutoDefault(false); // Return belongs to the keys field

    connect(mSearch, &QLineEdit::textChanged, this, &ShortcutDialog::filter);
    connect(mTree, &QTreeWidget::currentItemChanged, this, &ShortcutDialog::showSelected);
    connect(mKeys, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutDialog::showConflict);
    connect(mAssign, &QPushButton::clicked, this, &ShortcutDialog::assign);
    connect(mClear, &QPushButton::clicked, this, &ShortcutDialog::clearSelected);
    connect(mReset, &QPushButton::clicked, this, &ShortcutDialog::resetSelected);
    connect(all, &QPushButton::clicked, this, &ShortcutDialog::resetAll);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fillTree();
    showSelected();
}

void ShortcutDialog::fillTree()
{
    std::map<QString, QTreeWidgetItem *> menus;
    for (const Actions::Entry &entry : mActions.entries()) {
        const QString menu = plainTitle(QCoreApplication::translate("Actions", entry.menu));
        QTreeWidgetItem *&parent = menus[menu];
        if (!parent) {
            parent = new QTreeWidgetItem(mTree, {menu});
            parent->setFlags(Qt::ItemIsEnabled);
            parent->setExpanded(true);
        }
        auto *item = new QTreeWidgetItem(parent, {entry.title()});
        item->setIcon(0, entry.action->icon());
        mItems.emplace(&entry, item);
        showShortcuts(entry);
    }
}

void ShortcutDialog::filter(const QString &text)
{
    for (const auto &[entry, item] : mItems)
        item->setHidden(!item->text(0).contains(text, Qt::CaseInsensitive) &&
                        !item->text(1).contains(text, Qt::CaseInsensitive));
    for (int i = 0; i < mTree->topLevelItemCount(); ++i) {
        QTreeWidgetItem *menu = mTree->topLevelItem(i);
        bool any = false;
        for (int k = 0; k < menu->childCount(); ++k)
            any = any || !menu->child(k)->isHidden();
        menu->setHidden(!any);
    }
}

const Actions::Entry *ShortcutDialog::selected() const
{
    for (const auto &[entry, item] : mItems)
        if (item == mTree->currentItem())
            return entry;
    return nullptr;
}

void ShortcutDialog::showSelected()
{
    const Actions::Entry *entry = selected();
    const QSignalBlocker blocker(mKeys);
    mKeys->setKeySequence(entry ? entry->action->shortcut() : QKeySequence());
    mKeys->setEnabled(entry != nullptr);
    mClear->setEnabled(entry && !entry->action->shortcuts().isEmpty());
    mReset->setEnabled(entry && entry->action->shortcuts() != entry->defaultShortcuts);
    showConflict();
}

void ShortcutDialog::showConflict()
{
    const Actions::Entry *entry = selected();
    const QKeySequence key = mKeys->keySequence();
    const bool another = entry && !key.isEmpty() && !entry->action->shortcuts().contains(key);
    mAssign->setEnabled(another);
    mAssign->setText(tr("&Assign"));
    mConflict->clear();
    if (!entry || key.isEmpty())
        return;
    QStringList names;
    for (const Actions::Entry *other : entriesWithKey(mActions, key, entry))
        names << tr("“%1”").arg(other->title());
    if (names.isEmpty())
        return;
    mAssign->setText(tr("&Take Over"));
    mConflict->setText(tr("%1 already belongs to %2, which would lose it.")
                           .arg(key.toString(QKeySequence::NativeText), names.join(QStringLiteral(", "))));
}

void ShortcutDialog::assign()
{
    const Actions::Entry *entry = selected();
    const QKeySequence key = mKeys->keySequence();
    if (!entry || key.isEmpty())
        return;
    for (const Actions::Entry *other : entriesWithKey(mActions, key, entry)) {
        QList<QKeySequence> left = other->action->shortcuts();
        left.removeAll(key);
        change(*other, left);
    }
    change(*entry, {key});
    showSelected();
}

void ShortcutDialog::clearSelected()
{
    if (const Actions::Entry *entry = selected())
        change(*entry, {});
    showSelected();
}

void ShortcutDialog::resetSelected()
{
    const Actions::Entry *entry = selected();
    if (!entry)
        return;
    // Keys that another action has by now stay with it: two actions with one key would both be dead.
    QList<QKeySequence> free;
    for (const QKeySequence &key : entry->defaultShortcuts)
        if (entriesWithKey(mActions, key, entry).empty())
            free << key;
    change(*entry, free);
    showSelected();
    if (free != entry->defaultShortcuts)
        mConflict->setText(tr("Some default keys belong to other actions now and stay there."));
}

void ShortcutDialog::resetAll()
{
    for (const Actions::Entry &entry : mActions.entries())
        change(entry, entry.defaultShortcuts);
    showSelected();
}

void ShortcutDialog::change(const Actions::Entry &entry, const QList<QKeySequence> &shortcuts)
{
    entry.action->setShortcuts(shortcuts);
    if (shortcuts == entry.defaultShortcuts)
        mSettings.setShortcuts(entry.key(), std::nullopt);
    else
        mSettings.setShortcuts(entry.key(), shortcuts);
    showShortcuts(entry);
}

void ShortcutDialog::showShortcuts(const Actions::Entry &entry)
{
    QTreeWidgetItem *item = mItems.at(&entry);
    item->setText(1, shortcutText(entry.action->shortcuts()));
    QFont font = mTree->font();
    font.setBold(entry.action->shortcuts() != entry.defaultShortcuts);
    item->setFont(1, font);
}

} // namespace editor
