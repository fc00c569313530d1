// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/relief.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

// Based on:
//   K. Perlin, Improving Noise, 2002
//   R. A. Bagnold, The Physics of Blown Sand and Desert Dunes, 1941: the profile of a transverse dune
// Differs: twelve of the gradients lie in the plane, evenly around the circle; the order comes of a seed.

namespace model::io {

namespace {

constexpr int Gradients = 12;
// The wind blows from the west, a little to the north: rows of dunes along an edge of the terrain look made.
constexpr double WindDegrees = 20;
// A dune rises slowly to its crest, and falls on the lee side at about the angle at which sand rests.
constexpr double CrestAt = 0.6;

double fade(double t)
{
    return t * t * t * (t * (t * 6 - 15) + 10);
}

double mix(double a, double b, double t)
{
    return a + (b - a) * t;
}

double smooth(double t)
{
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Height of a dune of height 1 at `phase` of its length, 0 ... 1, with the wind.
double profile(double phase)
{
    if (phase < CrestAt)
        return std::sin(phase / CrestAt * std::numbers::pi / 2) * smooth(phase / CrestAt * 1.6);
    // Steepest at the brink, and running out at the foot.
    return std::pow((1 - phase) / (1 - CrestAt), 1.3);
}

} // namespace

Relief::Relief(const ReliefSettings &settings)
    : mSettings(settings)
{
    std::iota(mOrder.begin(), mOrder.end(), std::uint8_t(0));
    // A shuffle of our own: those of the library differ from one to the other.
    std::uint64_t state = (std::uint64_t(settings.seed) + 1) * 0x9e3779b97f4a7c15u;
    for (std::size_t i = mOrder.size() - 1; i > 0; --i) {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        std::swap(mOrder[i], mOrder[(state >> 32) % (i + 1)]);
    }
}

/// -1 ... 1, about; the size of its features is 1.
double Relief::noise(double x, double y) const
{
    const double fx = std::floor(x), fy = std::floor(y);
    const auto corner = [&](int dx, int dy) {
        const auto wrap = [](double value) { return std::size_t(value - 256 * std::floor(value / 256)) & 255; };
        const std::size_t hash = mOrder[(mOrder[wrap(fx + dx)] + wrap(fy + dy)) & 255];
        const double angle = double(hash % Gradients) * 2 * std::numbers::pi / Gradients;
        return std::cos(angle) * (x - fx - dx) + std::sin(angle) * (y - fy - dy);
    };
    const double u = fade(x - fx), v = fade(y - fy);
    return 1.5 * mix(mix(corner(0, 0), corner(1, 0), u), mix(corner(0, 1), corner(1, 1), u), v);
}

double Relief::hills(double x, double y) const
{
    constexpr int Octaves = 6;
    double sum = 0, amplitude = 0.5, frequency = 1;
    for (int octave = 0; octave < Octaves; ++octave) {
        sum += amplitude * noise(x * frequency + 19.1 * octave, y * frequency - 7.3 * octave);
        amplitude /= 2.7;
        frequency *= 2;
    }
    return std::clamp(0.5 + 0.85 * sum, 0.0, 1.0);
}

double Relief::dunes(double x, double y) const
{
    const double wind = WindDegrees * std::numbers::pi / 180;
    const double along = x * std::cos(wind) + y * std::sin(wind);
    const double across = y * std::cos(wind) - x * std::sin(wind);
    // Crests wind, and run into one another.
    const double bent = along + 0.5 * noise(0.3 * along, 0.6 * across) + 0.05 * noise(1.1 * along, 1.7 * across);
    const double strength = 0.62 + 0.38 * noise(0.6 * along + 40, 0.6 * across + 40);
    const double ground = 0.12 * (1 + noise(0.3 * x - 9, 0.3 * y + 5));
    return std::clamp(0.84 * strength * profile(bent - std::floor(bent)) + ground, 0.0, 1.0);
}

double Relief::heightAt(terrain::Point2 p) const
{
    if (mSettings.shape == ReliefShape::Flat)
        return 0;
    const double x = p.x / mSettings.wavelength, y = p.y / mSettings.wavelength;
    return mSettings.height * (mSettings.shape == ReliefShape::Dunes ? dunes(x, y) : hills(x, y));
}

} // namespace model::io
