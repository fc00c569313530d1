// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/basis/principalfields.h"

#include "model/codec/basis/principalbasis.h"

namespace model::codec {

Result<PrincipalFields> principalFields(const FrameSource &source, std::size_t count, const Progress &progress)
{
    const auto frames = FrameStack::gather(source, progress.part(0, 0.2));
    if (!frames)
        return fail(frames.error());
    const auto components = PrincipalComponents::of(*frames, count, progress.part(0.2, 0.8));
    if (!components)
        return fail(components.error());
    std::vector<double> basis;
    for (std::size_t k = 0; k < components->count(); ++k) {
        const auto trajectory = components->trajectory(k);
        basis.insert(basis.end(), trajectory.begin(), trajectory.end());
    }
    const auto fitted = fittedCoefficients(*frames, frames->rowMeans(), basis, progress.part(0.8, 1));
    if (!fitted)
        return fail(fitted.error());
    const double energy = frames->centredEnergy();
    const std::size_t vertices = source.vertexCount();
    PrincipalFields fields;
    for (std::size_t k = 0; k < fitted->rank; ++k) {
        const auto begin = fitted->values.begin() + std::ptrdiff_t(k * vertices);
        fields.coefficients.emplace_back(begin, begin + std::ptrdiff_t(vertices));
        double sum = 0;
        for (std::size_t v = 0; v < vertices; ++v)
            sum += begin[std::ptrdiff_t(v)] * begin[std::ptrdiff_t(v)];
        fields.energyShares.push_back(energy > 0 ? sum / energy : 0);
    }
    return fields;
}

} // namespace model::codec
