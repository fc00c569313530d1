// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/views/dialogs/dialogdriver.h"

#include "model/io/animationwriter.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QTimer>

namespace tests {

void open(QDialog &dialog)
{
    dialog.show();
    dialog.activateWindow(); // without a window manager nobody else does
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
}

void typeInto(const QWidget &dialog, const char *fieldName, const QString &text)
{
    auto *field = find<QWidget>(dialog, fieldName);
    auto *input = qobject_cast<QLineEdit *>(field);
    if (!input)
        input = field->findChild<QLineEdit *>();
    QVERIFY2(input && input->isVisible() && input->isEnabled(), fieldName);
    input->setFocus();
    input->selectAll();
    QTest::keyClick(input, Qt::Key_Delete);
    for (const QChar letter : text) { // QTest::keyClicks() takes only Latin-1
        QKeyEvent press(QEvent::KeyPress, 0, Qt::NoModifier, letter);
        QApplication::sendEvent(input, &press);
    }
}

void click(const QWidget &dialog, const char *buttonName)
{
    auto *button = find<QAbstractButton>(dialog, buttonName);
    QVERIFY2(button->isVisible() && button->isEnabled(), buttonName);
    QTest::mouseClick(button, Qt::LeftButton);
}

QString textOf(const QWidget &dialog, const char *objectName)
{
    auto *widget = find<QWidget>(dialog, objectName);
    if (const auto *label = qobject_cast<QLabel *>(widget))
        return label->text();
    if (const auto *line = qobject_cast<QLineEdit *>(widget))
        return line->text();
    return widget->findChild<QLineEdit *>()->text();
}

void answerMessageBox(const QString &button, QString *seen)
{
    auto *timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, button, seen] {
        auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
        if (!box)
            return;
        timer->deleteLater();
        timer->stop();
        if (seen)
            *seen = box->text();
        for (QAbstractButton *candidate : box->buttons())
            if (candidate->text().remove(u'&') == button)
                return candidate->click();
        qFatal("no button %s", qPrintable(button));
    });
    timer->start(10);
}

QString writeObjFrames(const QString &folder, const model::FrameSource &frames)
{
    const auto written = model::io::writeFrames(folder, frames, model::io::MeshFormat::Obj);
    if (!written)
        qFatal("cannot write frames to %s", qPrintable(folder));
    return folder;
}

QStringList unnamedWidgets(const QWidget &dialog)
{
    QStringList result;
    for (QWidget *widget : dialog.findChildren<QWidget *>()) {
        if (!(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy())
            continue;
        const QAccessibleInterface *accessible = QAccessible::queryAccessibleInterface(widget);
        if (!accessible || accessible->text(QAccessible::Name).isEmpty())
            result << QStringLiteral("%1 %2").arg(QLatin1String(widget->metaObject()->className()),
                                                  widget->objectName());
    }
    return result;
}

} // namespace tests
