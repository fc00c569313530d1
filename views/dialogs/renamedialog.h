// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/editdialog.h"

class QLineEdit;

namespace views {

/// Asks for another name of the animation (not of its file).
class RenameDialog final : public EditDialog
{
    Q_OBJECT

public:
    explicit RenameDialog(commands::AnimationContext &context, QWidget *parent = nullptr);

protected:
    QString problem() const override { return {}; }
    bool apply() override;

private:
    QLineEdit *mName;
};

} // namespace views
