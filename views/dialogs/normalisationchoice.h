// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/normalisation.h"

#include <QComboBox>

namespace views {

/// A box to choose what is made to fit the cube.
class NormalisationChoice final : public QComboBox
{
    Q_OBJECT

public:
    explicit NormalisationChoice(QWidget *parent = nullptr);

    model::Normalisation mode() const;
    void setMode(model::Normalisation mode);
};

/// As in a list of settings: "not normalised", "normalised by all frames".
QString normalisationText(model::Normalisation mode);

} // namespace views
