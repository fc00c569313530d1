// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/numberfield.h"

#include "views/dialogs/quantitytext.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

std::optional<double> parseNumber(const QString &text, bool whole)
{
    bool ok = false;
    double value = QLocale().toDouble(text.trimmed(), &ok);
    if (!ok)
        value = QLocale::c().toDouble(text.trimmed(), &ok);
    if (!ok || !std::isfinite(value) || (whole && value != std::floor(value)))
        return std::nullopt;
    return value;
}

} // namespace

NumberField::NumberField(const QString &what, const NumberRange &range, QWidget *parent)
    : QWidget(parent)
    , mWhat(what)
    , mRange(range)
    , mInput(new InputLine(this))
    , mHint(new HintLabel(this))
{
    // Wide enough for the largest number, with its group separators.
    const QString widest = numberText(mRange.max, mRange.decimals) + QString(mRange.decimals, u'8');
    mInput->setMinimumWidth(std::max(90, mInput->fontMetrics().horizontalAdvance(widest) + 24));
    mInput->setMaximumWidth(std::max(110, mInput->minimumWidth()));
    mInput->setAccessibleName(what);
    mInput->installEventFilter(this);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(mInput);
    row->addWidget(mHint, 1);
    setFocusProxy(mInput);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(mInput, &QLineEdit::textChanged, this, &NumberField::takeText);
    setValue(range.min);
}

void NumberField::setRange(const NumberRange &range)
{
    if (mRange == range)
        return;
    mRange = range;
    takeText();
}

void NumberField::setHint(const QString &hint)
{
    mHintText = hint;
    showState();
}

void NumberField::setValue(double value)
{
    mInput->setText(numberText(value, mRange.decimals));
    takeText(); // also if the text is the same: the range may be another one
}

QString NumberField::problem() const
{
    if (mValue)
        return {};
    return tr("%1: enter %2.").arg(mWhat, rangeText());
}

bool NumberField::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == mInput && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down) {
            stepBy(key == Qt::Key_Up ? 1 : -1);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void NumberField::takeText()
{
    std::optional<double> value = parseNumber(mInput->text(), mRange.decimals == 0);
    if (value && (*value < mRange.min || *value > mRange.max))
        value.reset();
    const bool differs = value != mValue;
    mValue = value;
    showState();
    if (differs)
        emit changed();
}

void NumberField::showState()
{
    mInput->setRefused(!mValue);
    if (mValue)
        mHint->showHint(mHintText);
    else
        mHint->showRefusal(tr("Allowed: %1").arg(rangeText()));
    mInput->setAccessibleDescription(mHint->text());
}

void NumberField::stepBy(double steps)
{
    const double from = parseNumber(mInput->text(), false).value_or(mRange.min);
    setValue(std::clamp(from + steps * mStep, mRange.min, mRange.max));
    mInput->selectAll();
}

QString NumberField::rangeText() const
{
    const QString first = numberText(mRange.min, mRange.decimals);
    const QString last = numberText(mRange.max, mRange.decimals);
    return mRange.decimals == 0 ? tr("a whole number from %1 to %2").arg(first, last)
                                : tr("a number from %1 to %2").arg(first, last);
}

} // namespace views
