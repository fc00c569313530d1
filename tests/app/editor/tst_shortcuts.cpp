// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/shortcutdialog.h"
#include "app/editor/actions/shortcuts.h"
#include "tests/app/editor/windowdriver.h"
#include "tests/support/testmain.h"

#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

using editor::ActionId;

class TestShortcuts final : public QObject
{
    Q_OBJECT

    static QTreeWidgetItem *itemOf(editor::ShortcutDialog &dialog, const QString &title)
    {
        for (QTreeWidgetItemIterator it(dialog.findChild<QTreeWidget *>()); *it; ++it)
            if ((*it)->parent() && (*it)->text(0) == title)
                return *it;
        return nullptr;
    }
    /// The field waits a moment for more keys before it takes them as the shortcut.
    static void press(editor::ShortcutDialog &dialog, Qt::Key key)
    {
        auto *keys = dialog.findChild<QKeySequenceEdit *>();
        QSignalSpy changed(keys, &QKeySequenceEdit::keySequenceChanged);
        QTest::keyClick(keys, key, Qt::ControlModifier);
        QVERIFY(!changed.isEmpty() || changed.wait());
    }
    static void select(editor::ShortcutDialog &dialog, const QString &title)
    {
        dialog.findChild<QTreeWidget *>()->setCurrentItem(itemOf(dialog, title));
    }

private slots:
    void init() { QSettings().clear(); }

    void noTwoActionsShareADefaultKey()
    {
        const tests::WindowDriver driver;
        // Actions for documents of different kinds are never there together.
        using editor::DocumentKind;
        QMap<QString, QString> owner;
        for (const DocumentKind kind : editor::EveryDocumentKind) {
            owner.clear();
            for (const auto &entry : const_cast<tests::WindowDriver &>(driver).window.actions().entries()) {
                QVERIFY2(!entry.key().isEmpty(), qPrintable(entry.title()));
                if (entry.kind.value_or(kind) != kind)
                    continue;
                for (const QKeySequence &key : entry.defaultShortcuts) {
                    QVERIFY2(!owner.contains(key.toString()),
                             qPrintable(key.toString() + ": " + entry.title() + ", " + owner.value(key.toString())));
                    owner.insert(key.toString(), entry.title());
                }
            }
        }
        QVERIFY(owner.size() > 20);
    }

    void pressedKeysAreAssignedAndRemembered()
    {
        tests::WindowDriver driver;
        editor::Settings settings;
        editor::ShortcutDialog dialog(driver.window.actions(), settings);
        dialog.show();
        select(dialog, "Normalise");
        press(dialog, Qt::Key_J);
        tests::clickButton(dialog, "Assign");
        QCOMPARE(driver.action(ActionId::Normalise).shortcut(), QKeySequence("Ctrl+J"));
        QCOMPARE(itemOf(dialog, "Normalise")->text(1), QString("Ctrl+J"));

        tests::WindowDriver next; // as in the next session
        QCOMPARE(next.action(ActionId::Normalise).shortcut(), QKeySequence("Ctrl+J"));
    }

    void aTakenKeyIsNamedAndMovesOnlyWhenAskedFor()
    {
        tests::WindowDriver driver;
        editor::Settings settings;
        editor::ShortcutDialog dialog(driver.window.actions(), settings);
        dialog.show();
        select(dialog, "Normalise");
        press(dialog, Qt::Key_O);
        QVERIFY(dialog.findChild<QLabel *>("conflict")->text().contains("Open"));
        QCOMPARE(driver.action(ActionId::Open).shortcut(), QKeySequence("Ctrl+O"));
        tests::clickButton(dialog, "Take Over");
        QCOMPARE(driver.action(ActionId::Normalise).shortcut(), QKeySequence("Ctrl+O"));
        QVERIFY(driver.action(ActionId::Open).shortcuts().isEmpty());

        select(dialog, "Open");
        tests::clickButton(dialog, "Default"); // the key stays where it went
        QVERIFY(driver.action(ActionId::Open).shortcuts().isEmpty());
        tests::clickButton(dialog, "Default for All");
        QCOMPARE(driver.action(ActionId::Open).shortcut(), QKeySequence("Ctrl+O"));
        QVERIFY(driver.action(ActionId::Normalise).shortcuts().isEmpty());
        QVERIFY(!settings.shortcuts("file.open"));
    }

    void searchFindsActionsAndKeys()
    {
        tests::WindowDriver driver;
        editor::Settings settings;
        editor::ShortcutDialog dialog(driver.window.actions(), settings);
        dialog.findChild<QLineEdit *>()->setText("trim");
        QVERIFY(!itemOf(dialog, "Trim to Range")->isHidden());
        QVERIFY(itemOf(dialog, "Open")->isHidden());
        dialog.findChild<QLineEdit *>()->setText("ctrl+o");
        QVERIFY(!itemOf(dialog, "Open")->isHidden());
    }
};

SANDREEL_TEST(TestShortcuts)
#include "tst_shortcuts.moc"
