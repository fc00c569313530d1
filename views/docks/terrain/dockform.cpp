// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/terrain/dockform.h"

#include "views/dialogs/numberfield.h"

#include <QDockWidget>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>

#include <cmath>

namespace views {

namespace {

/// Scrolls up and down alone: as wide as what is in it, whatever that comes to be.
class TallArea final : public QScrollArea
{
protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (watched == widget() && event->type() == QEvent::LayoutRequest)
            fit();
        return QScrollArea::eventFilter(watched, event);
    }
    void showEvent(QShowEvent *event) override
    {
        fit(); // texts and fonts are what they will be
        QScrollArea::showEvent(event);
    }

private:
    void fit() { setMinimumWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width()); }
};

} // namespace

void setScrolledWidget(QDockWidget &dock, QWidget *content)
{
    auto *scroll = new TallArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus); // the fields in it have the focus
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    QWidget *before = dock.widget();
    dock.setWidget(scroll);
    delete before;
}

void addRow(QFormLayout &form, const QString &label, QWidget *editor, const QString &unit)
{
    form.setRowWrapPolicy(QFormLayout::DontWrapRows);
    form.setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    if (auto *number = qobject_cast<NumberField *>(editor)) {
        number->setHint(unit);
        for (HintLabel *const hint : number->findChildren<HintLabel *>())
            hint->setWordWrap(true); // a refusal takes several lines in a narrow dock
        form.addRow(label, editor);
        if (auto *buddy = qobject_cast<QLabel *>(form.labelForField(editor)))
            buddy->setBuddy(&number->input());
        return;
    }
    form.addRow(label, editor);
    QString name = label;
    editor->setAccessibleName(name.remove(QLatin1Char('&')).remove(QLatin1Char(':')));
}

QLabel *addFact(QFormLayout &form, const QString &label)
{
    auto *value = new QLabel(QStringLiteral("–"));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form.addRow(label, value);
    return value;
}

void setRowVisible(QWidget *editor, bool isVisible)
{
    if (auto *form = qobject_cast<QFormLayout *>(editor->parentWidget()->layout()))
        form->setRowVisible(editor, isVisible);
}

void clearForm(QFormLayout &form)
{
    while (form.rowCount() > 0) {
        const QFormLayout::TakeRowResult row = form.takeRow(0);
        for (QLayoutItem *item : {row.labelItem, row.fieldItem}) {
            if (!item)
                continue;
            if (QWidget *widget = item->widget()) {
                widget->hide();
                widget->setObjectName(QString());
                widget->deleteLater();
            }
            delete item;
        }
    }
}

void showNumber(NumberField &field, double value)
{
    // What was typed may have been rounded to fewer digits than the value has.
    const double tolerance = 0.5 * std::pow(10.0, -field.range().decimals);
    if (field.value() && std::abs(*field.value() - value) < tolerance)
        return;
    const QSignalBlocker blocker(field);
    field.setValue(value);
}

} // namespace views
