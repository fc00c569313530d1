// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"

#include <QString>

#include <compare>
#include <functional>
#include <vector>

namespace views {

enum class FieldKind : std::uint8_t {
    MeanCurvature,
    GaussianCurvature,
    Valence,
    CodecError,       ///< distance from the original's vertex
    TrajectoryLength, ///< way that the vertex goes through all frames
    PcaCoefficient,   ///< how much a basis trajectory moves the vertex
};

/// A number at each vertex.
struct FieldId
{
    FieldKind kind = FieldKind::MeanCurvature;
    int index = 0; ///< which coefficient, from 0
    friend auto operator<=>(const FieldId &, const FieldId &) = default;
};

/// A field that can be had, and how. The work runs in another thread.
struct FieldOffer
{
    FieldId id;
    std::function<model::Result<std::vector<float>>(const model::Progress &)> make; ///< #V; NaN where there is no value
};

/// "Mean Curvature"
QString fieldTitle(FieldId id);

/// The values that most lie between: outliers at either end, up to a hundredth of all, do not stretch a scale. NaN and
/// infinity are passed by; {0, 0} if nothing is left.
std::pair<float, float> typicalRange(const std::vector<float> &values);

} // namespace views
