// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/normalisationchoice.h"

#include <algorithm>

namespace views {

using model::Normalisation;

NormalisationChoice::NormalisationChoice(QWidget *parent)
    : QComboBox(parent)
{
    setObjectName(QStringLiteral("normalisation"));
    setAccessibleName(tr("Normalise"));
    addItem(tr("No, keep coordinates"), int(Normalisation::None));
    addItem(tr("First frame fills the cube from −1 to 1"), int(Normalisation::FirstFrame));
    addItem(tr("All frames fill the cube from −1 to 1"), int(Normalisation::AllFrames));
}

Normalisation NormalisationChoice::mode() const
{
    return Normalisation(currentData().toInt());
}

void NormalisationChoice::setMode(Normalisation mode)
{
    setCurrentIndex(std::max(0, findData(int(mode))));
}

QString normalisationText(Normalisation mode)
{
    switch (mode) {
    case Normalisation::None:
        return NormalisationChoice::tr("not normalised");
    case Normalisation::FirstFrame:
        return NormalisationChoice::tr("normalised by the first frame");
    case Normalisation::AllFrames:
        return NormalisationChoice::tr("normalised by all frames");
    }
    return {};
}

} // namespace views
