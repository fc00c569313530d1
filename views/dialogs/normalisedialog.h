// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/editdialog.h"
#include "views/jobs/job.h"

#include "model/geometry/similarity.h"

#include <optional>

namespace views {

class JobPanel;
class NormalisationChoice;

/// Asks what shall fill the cube; looks for its box in the background, since that takes every frame.
class NormaliseDialog final : public EditDialog
{
    Q_OBJECT

public:
    explicit NormaliseDialog(commands::AnimationContext &context, QWidget *parent = nullptr);

    void reject() override;

protected:
    QString problem() const override;
    QString consequence() const override;
    bool apply() override;

private:
    NormalisationChoice *mMode;
    std::optional<model::Similarity> mPlacement; ///< found; to be pushed
    Job mMeasuring;
};

} // namespace views
