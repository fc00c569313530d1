// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/samples/samples.h"
#include "app/samples/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace samples {

namespace {

using model::TriangleMesh;
using model::Vec3f;

constexpr int FrameCount = 120;
constexpr int PulseFrames = 60; ///< divides FrameCount, so that the animation loops
constexpr int TentacleCount = 10;
constexpr int LobeCount = 10;
constexpr float TwoPi = 2 * std::numbers::pi_v<float>;

/// -1 (wide open) .. 1 (contracted): quick to contract, slow to open.
float contraction(float time)
{
    const float t = time - std::floor(time);
    return -std::cos(TwoPi * (t + 0.12f * std::sin(TwoPi * t)));
}

/// How far the animal has risen, in a loop: it shoots up on each contraction and sinks back.
float lift(float time)
{
    return 0.10f * contraction(time - 0.18f);
}

/// A point of the bell's outer (side = 1) or inner (side = 0) skin; `along` runs from the top (0) to the rim (1).
Vec3f bellPoint(float along, float around, float side, float time)
{
    // The rim follows the top with a delay, which makes the pulse a wave.
    const float pulse = contraction(time - 0.14f * along);
    const float angle = along * (1.62f + 0.16f * pulse);
    const float thickness = 0.10f * (1 - 0.75f * along);
    const float radius = (1 - 0.17f * pulse * along) * (1 - thickness * (1 - side));
    const float lobes = 1 + 0.05f * along * along * std::cos(TwoPi * LobeCount * around);
    const float height = 0.80f + 0.10f * pulse;
    return {radius * lobes * std::sin(angle) * std::sin(TwoPi * around),
            height * (1 - thickness * (1 - side)) * std::cos(angle) + lift(time),
            radius * lobes * std::sin(angle) * std::cos(TwoPi * around)};
}

TriangleMesh bell(float time)
{
    return closedSurface(59, 120, [&](float u, float v) {
        const float across = 2 * u; // 0..1 outside from the top to the rim, 1..2 inside and back
        return across <= 1 ? bellPoint(across, v, 1, time) : bellPoint(2 - across, v, 0, time);
    });
}

/// A tapered tube whose middle waves; the wave travels down and grows.
TriangleMesh tentacle(int index, float time)
{
    const float around = (float(index) + 0.5f) / TentacleCount;
    const Vec3f root = bellPoint(0.93f, around, 0.5f, time);
    const Vec3f outward = model::normalized(Vec3f{std::sin(TwoPi * around), 0, std::cos(TwoPi * around)});
    const Vec3f sideways{outward.z, 0, -outward.x};
    const float length = 1.55f + 0.35f * std::sin(2.4f * float(index));
    const float phase = 0.13f * float(index);
    return closedSurface(44, 10, [&](float u, float v) {
        const float swing = 0.20f * u * std::sin(TwoPi * (time - 0.85f * u + phase));
        const float drift = 0.16f * u * std::sin(TwoPi * (time - 0.6f * u) + 1.3f * float(index));
        const float inward = -0.30f * u * u;
        const Vec3f centre = root + Vec3f{0, -length * u * (1 - 0.06f * contraction(time - 0.3f * u)), 0} +
                             outward * (inward + swing) + sideways * drift;
        const float radius = 0.034f * (1 - 0.7f * u) * std::sqrt(std::max(0.0f, 1 - u * u)) * std::min(1.0f, 12 * u);
        return centre + outward * (radius * std::cos(TwoPi * v)) + sideways * (radius * std::sin(TwoPi * v));
    });
}

/// The frilled arms under the bell's middle.
TriangleMesh arm(int index, float time)
{
    const float turn = TwoPi * (float(index) / 4 + 0.06f);
    return closedSurface(40, 24, [&](float u, float v) {
        const float sway = 0.10f * u * std::sin(TwoPi * (time - 0.7f * u) + float(index));
        const float spread = 0.10f + 0.16f * std::sin(std::numbers::pi_v<float> * u) + sway;
        const Vec3f centre{spread * std::sin(turn), 0.55f + lift(time - 0.1f * u) - 1.35f * u, spread * std::cos(turn)};
        const float frill = 1 + 0.30f * std::sin(TwoPi * 5 * v + 9 * u) * std::min(1.0f, 4 * u);
        const float radius =
            0.115f * frill * (1 - 0.55f * u) * std::sqrt(std::max(0.0f, 1 - u * u)) * std::min(1.0f, 10 * u);
        return centre + Vec3f{radius * std::sin(TwoPi * v + 2.5f * u), 0, radius * std::cos(TwoPi * v + 2.5f * u)};
    });
}

} // namespace

model::Sequence makeJellyfish()
{
    model::Connectivity connectivity;
    std::vector<Vec3f> positions;
    for (int frame = 0; frame < FrameCount; ++frame) {
        const float time = float(frame % PulseFrames) / PulseFrames;
        TriangleMesh mesh = bell(time);
        for (int i = 0; i < 4; ++i)
            append(mesh, arm(i, time));
        for (int i = 0; i < TentacleCount; ++i)
            append(mesh, tentacle(i, time));
        positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
        connectivity = std::move(mesh.connectivity);
    }
    return model::Sequence(std::move(connectivity), std::move(positions), 30.0, "Jellyfish");
}

} // namespace samples
