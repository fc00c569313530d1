// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/meshfields.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace views {

QString fieldTitle(FieldId id)
{
    const auto text = [](const char *source) { return QCoreApplication::translate("MeshFields", source); };
    switch (id.kind) {
    case FieldKind::MeanCurvature:
        return text(QT_TRANSLATE_NOOP("MeshFields", "Mean Curvature"));
    case FieldKind::GaussianCurvature:
        return text(QT_TRANSLATE_NOOP("MeshFields", "Gaussian Curvature"));
    case FieldKind::Valence:
        return text(QT_TRANSLATE_NOOP("MeshFields", "Valence"));
    case FieldKind::CodecError:
        return text(QT_TRANSLATE_NOOP("MeshFields", "Codec Error"));
    case FieldKind::TrajectoryLength:
        return text(QT_TRANSLATE_NOOP("MeshFields", "Trajectory Length"));
    case FieldKind::PcaCoefficient:
        break;
    }
    return text(QT_TRANSLATE_NOOP("MeshFields", "PCA Coefficient %1")).arg(id.index + 1);
}

std::pair<float, float> typicalRange(const std::vector<float> &values)
{
    std::vector<float> finite;
    finite.reserve(values.size());
    std::copy_if(values.begin(), values.end(), std::back_inserter(finite), [](float v) { return std::isfinite(v); });
    if (finite.empty())
        return {0, 0};
    const auto at = [&](std::size_t rank) {
        std::nth_element(finite.begin(), finite.begin() + std::ptrdiff_t(rank), finite.end());
        return finite[rank];
    };
    const std::size_t cut = finite.size() / 100;
    return {at(cut), at(finite.size() - 1 - cut)};
}

} // namespace views
