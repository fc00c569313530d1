// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/editdialog.h"

namespace views {

class NumberField;

/// Asks for another frame rate of the same frames, and says how long they will last.
class FrameRateDialog final : public EditDialog
{
    Q_OBJECT

public:
    explicit FrameRateDialog(commands::AnimationContext &context, QWidget *parent = nullptr);

protected:
    QString problem() const override;
    QString consequence() const override;
    bool apply() override;

private:
    NumberField *mRate;
};

} // namespace views
