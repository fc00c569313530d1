// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/inputline.h"

#include <QWidget>

#include <optional>

namespace views {

/// What a NumberField takes, ends included.
struct NumberRange
{
    double min = 0;
    double max = 0;
    int decimals = 0; ///< shown at most; 0: whole numbers only

    friend bool operator==(const NumberRange &, const NumberRange &) = default;
};

/// A number that a person types, as written in the interface's language (a decimal point is taken too). Unlike a spin
/// box it never bends what was typed: a value out of range stays, is marked, and the allowed range is said beside it.
/// Up and Down step.
class NumberField final : public QWidget
{
    Q_OBJECT

public:
    /// \param what  the name of the value: "Basis size"
    NumberField(const QString &what, const NumberRange &range, QWidget *parent = nullptr);

    const NumberRange &range() const { return mRange; }
    void setRange(const NumberRange &range);
    void setStep(double step) { mStep = step; }
    /// A quiet remark beside a value that is fine: a unit, a consequence.
    void setHint(const QString &hint);

    void setValue(double value);
    /// Nothing while the text is refused.
    std::optional<double> value() const { return mValue; }
    /// Why the text is refused, as a sentence that names the field; empty if it is not.
    QString problem() const;

    InputLine &input() const { return *mInput; }

signals:
    /// The value is another one, or began or ceased to be one.
    void changed();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void takeText();
    void showState();
    void stepBy(double steps);
    QString rangeText() const;

    const QString mWhat;
    NumberRange mRange;
    double mStep = 1;
    std::optional<double> mValue;
    QString mHintText;
    InputLine *mInput;
    HintLabel *mHint;
};

} // namespace views
