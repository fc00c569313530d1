// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/editdialog.h"

namespace views {

class NumberField;

/// Asks for another frame rate at the same speed, and says how many frames that makes.
class ResampleDialog final : public EditDialog
{
    Q_OBJECT

public:
    explicit ResampleDialog(commands::AnimationContext &context, QWidget *parent = nullptr);

protected:
    QString problem() const override;
    QString consequence() const override;
    bool apply() override;

private:
    std::uint64_t frameCount() const;

    NumberField *mRate;
};

} // namespace views
