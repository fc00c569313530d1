// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>

namespace model {

/// One number for people who do not want to know more: 0 is the coarsest, 1 shows no difference to the eye.
struct Quality
{
    double value = 0.7;
    friend bool operator==(const Quality &, const Quality &) = default;
};
/// Largest KG error of the whole animation (model/animation/metrics.h), per cent.
struct MaxKgError
{
    double percent = 1;
    friend bool operator==(const MaxKgError &, const MaxKgError &) = default;
};
/// Largest distance of any vertex in any frame, as a fraction of the diagonal of the box around all frames.
struct MaxVertexError
{
    double fraction = 0.001;
    friend bool operator==(const MaxVertexError &, const MaxVertexError &) = default;
};
/// Largest size of the whole file, bytes.
struct MaxBytes
{
    std::uint64_t bytes = 1'000'000;
    friend bool operator==(const MaxBytes &, const MaxBytes &) = default;
};

/// What an encoding shall reach; its settings are then searched for.
using QualityTarget = std::variant<Quality, MaxKgError, MaxVertexError, MaxBytes>;

inline constexpr double MinKgTarget = 1e-4; ///< per cent; what float positions can show at all
inline constexpr double MaxKgTarget = 100;
inline constexpr double MinVertexTarget = 1e-7;
inline constexpr double MaxVertexTarget = 1;

/// KG errors of quality 0 and 1, per cent; even steps of quality are even steps of the error's logarithm, as sizes and
/// what an eye tells apart go.
inline constexpr double CoarsestKgError = 10;
inline constexpr double FinestKgError = 0.05;

/// \param quality  clamped to 0 ... 1
inline double kgErrorOfQuality(double quality)
{
    return CoarsestKgError * std::pow(FinestKgError / CoarsestKgError, std::clamp(quality, 0.0, 1.0));
}
/// The inverse, clamped likewise.
inline double qualityOfKgError(double percent)
{
    return std::clamp(std::log(percent / CoarsestKgError) / std::log(FinestKgError / CoarsestKgError), 0.0, 1.0);
}

} // namespace model
