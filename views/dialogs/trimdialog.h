// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/editdialog.h"

namespace views {

class NumberField;

/// Asks which frames to keep. People count frames from 1, as the timeline does.
class TrimDialog final : public EditDialog
{
    Q_OBJECT

public:
    /// \param first, last  proposed, 0-based: the loop range
    TrimDialog(commands::AnimationContext &context, std::uint32_t first, std::uint32_t last, QWidget *parent = nullptr);

protected:
    QString problem() const override;
    QString consequence() const override;
    bool apply() override;

private:
    NumberField *mFirst;
    NumberField *mLast;
};

} // namespace views
