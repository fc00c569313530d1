// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tools/stroke.h"

#include <QString>

namespace views {

/// What every tool has in one way or another, for whoever changes it without knowing which tool it is.

/// Half the width of what a tool touches, in metres; 0 for a breakline.
double radiusOf(const model::terrain::Tool &tool);
/// Bounded to what tools take. Nothing happens to a breakline.
void setRadius(model::terrain::Tool &tool, double metres);

/// How much one stamp does: a depth or a height in metres, a volume, or a share from 0 to 1.
enum class AmountKind { None, Metres, CubicMetres, Share };
AmountKind amountKindOf(const model::terrain::Tool &tool);
double amountOf(const model::terrain::Tool &tool);
void setAmount(model::terrain::Tool &tool, double amount);

/// The mask of a tool that has one, else null.
const model::terrain::Mask *maskOf(const model::terrain::Tool &tool);
void setMask(model::terrain::Tool &tool, const model::terrain::Mask &mask);
/// The brush of a tool that has one, else null.
const model::terrain::Brush *brushOf(const model::terrain::Tool &tool);
void setBrush(model::terrain::Tool &tool, const model::terrain::Brush &brush);

/// The tool that does the opposite, with the same radius; the same tool if there is none.
model::terrain::Tool inverted(const model::terrain::Tool &tool);
/// A brush as wide that smooths, or lifts the ground.
model::terrain::Tool smoothing(const model::terrain::Tool &tool);
model::terrain::Tool lifting(const model::terrain::Tool &tool);

/// "Imprint", as in a list of tools and in the history.
QString titleOf(const model::terrain::Tool &tool);
/// What the tool does, in one sentence.
QString hintOf(const model::terrain::Tool &tool);

} // namespace views
