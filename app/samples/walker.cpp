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
constexpr int StrideFrames = 40; ///< one step of each leg; divides FrameCount, so that the animation loops
constexpr float Forward = -std::numbers::pi_v<float> / 2; ///< turns +y to +x
constexpr float TwoPi = 2 * std::numbers::pi_v<float>;

constexpr float BodyHeight = 0.93f;
constexpr float UpperLength = 0.40f;
constexpr float LowerLength = 0.42f;
constexpr float AnkleHeight = 0.09f;
constexpr float HalfStride = 0.24f;
constexpr float StepHeight = 0.16f;

struct Leg
{
    Vec3f hip;      ///< in the body's frame
    float phase;    ///< 0..1 of the stride
    float kneeSign; ///< +1: the knee points forward
};
/// The order in which a walking horse sets its feet.
constexpr Leg Legs[] = {{{-0.46f, -0.14f, 0.25f}, 0.00f, 1},
                        {{0.46f, -0.14f, 0.25f}, 0.25f, -1},
                        {{-0.46f, -0.14f, -0.25f}, 0.50f, 1},
                        {{0.46f, -0.14f, -0.25f}, 0.75f, -1}};

/// Where the ankle of a leg is, relative to the ground under its hip.
Vec3f anklePath(float phase)
{
    const float t = phase - std::floor(phase);
    constexpr float StanceShare = 0.62f;
    if (t < StanceShare)
        return {HalfStride * (1 - 2 * t / StanceShare), AnkleHeight, 0};
    const float swing = (t - StanceShare) / (1 - StanceShare);
    const float eased = swing * swing * (3 - 2 * swing);
    return {HalfStride * (2 * eased - 1), AnkleHeight + StepHeight * std::sin(std::numbers::pi_v<float> * swing), 0};
}

/// The joints of a leg for one moment: upper part, lower part and foot.
struct LegPose
{
    Pose upper, lower, foot;
};

/// Two bones from the hip to the ankle, in the plane of walking (law of cosines).
LegPose poseLeg(const Leg &leg, const Pose &body, float stride)
{
    const Vec3f hip = body(leg.hip);
    const Vec3f ankle = anklePath(stride + leg.phase) + Vec3f{leg.hip.x, 0, hip.z};
    const float dx = ankle.x - hip.x, dy = ankle.y - hip.y;
    const float reach = std::min(std::hypot(dx, dy), 0.999f * (UpperLength + LowerLength));
    const float towards = std::atan2(dx, -dy); // about +z, from straight down
    const auto angleOpposite = [](float opposite, float a, float b) {
        return std::acos(std::clamp((a * a + b * b - opposite * opposite) / (2 * a * b), -1.0f, 1.0f));
    };
    const float atHip = angleOpposite(LowerLength, UpperLength, reach);
    const float atKnee = angleOpposite(reach, UpperLength, LowerLength);

    LegPose pose;
    const float upperAngle = towards + leg.kneeSign * atHip;
    pose.upper = turnedZ(upperAngle);
    pose.upper.origin = hip;
    const float lowerAngle = upperAngle - leg.kneeSign * (std::numbers::pi_v<float> - atKnee);
    pose.lower = turnedZ(lowerAngle);
    pose.lower.origin = pose.upper({0, -UpperLength, 0});
    pose.foot = moved(pose.lower({0, -LowerLength, 0}));
    return pose;
}

/// The tail bends as a whole: a tapered tube around a curve that waves sideways.
TriangleMesh tail(const Pose &body, float stride)
{
    constexpr float Length = 0.75f;
    return closedSurface(18, 14, [&](float u, float v) {
        const float sway = 0.5f * u * u * std::sin(TwoPi * (stride - 0.45f * u));
        const Vec3f centre{-Length * u * (1 - 0.25f * u), 0.42f * u * u, Length * 0.55f * sway};
        // Round at the tip, and closed inside the body.
        const float radius = 0.085f * (1 - 0.6f * u) * std::sqrt(std::max(0.0f, 1 - u * u)) * std::min(1.0f, 12 * u);
        const float around = v * TwoPi;
        const Vec3f p = centre + Vec3f{0, radius * std::cos(around), radius * std::sin(around)};
        return body(p + Vec3f{-0.70f, 0.10f, 0});
    });
}

void appendPosed(TriangleMesh &mesh, TriangleMesh part, const Pose &pose)
{
    for (Vec3f &p : part.positions)
        p = pose(p);
    append(mesh, part);
}

TriangleMesh creatureAt(float stride)
{
    const float step = TwoPi * stride;
    const Pose body = turnedX(0.035f * std::sin(step))
                          .in(turnedZ(0.025f * std::sin(2 * step + 0.6f)))
                          .in(moved({0.015f * std::sin(2 * step), BodyHeight + 0.022f * std::cos(2 * step), 0}));
    const Pose head = turnedZ(0.10f * std::sin(2 * step + 1.2f))
                          .in(turnedY(0.10f * std::sin(step)))
                          .in(moved({0.80f, 0.32f, 0}))
                          .in(body);

    TriangleMesh mesh;
    // The poles of body and head point forward, so that the rings run around them.
    appendPosed(mesh, ellipsoid({0.40f, 0.74f, 0.40f}, 31, 48), turnedZ(Forward).in(body));
    appendPosed(mesh, limb(0.36f, 0.19f, 0.22f, 28), turnedZ(-0.9f).in(moved({0.84f, 0.30f, 0})).in(body));
    appendPosed(mesh, ellipsoid({0.27f, 0.30f, 0.26f}, 23, 36), turnedZ(Forward).in(head));
    appendPosed(mesh, ellipsoid({0.15f, 0.20f, 0.16f}, 17, 28),
                turnedZ(Forward).in(moved({0.26f, -0.07f, 0})).in(head));
    for (const float side : {-1.0f, 1.0f}) {
        appendPosed(mesh, ellipsoid({0.055f, 0.055f, 0.055f}, 9, 16), moved({0.19f, 0.10f, side * 0.155f}).in(head));
        const Pose ear =
            turnedX(side * (0.45f + 0.12f * std::sin(2 * step + 0.8f))).in(moved({-0.05f, 0.20f, side * 0.14f}));
        appendPosed(mesh, ellipsoid({0.045f, 0.19f, 0.10f}, 13, 20), moved({0, 0.13f, 0}).in(ear).in(head));
    }
    for (const Leg &leg : Legs) {
        const LegPose pose = poseLeg(leg, body, stride);
        appendPosed(mesh, limb(UpperLength, 0.16f, 0.105f, 24), pose.upper);
        appendPosed(mesh, limb(LowerLength, 0.105f, 0.075f, 24), pose.lower);
        appendPosed(mesh, ellipsoid({0.15f, 0.085f, 0.105f}, 11, 20), moved({0.045f, 0, 0}).in(pose.foot));
    }
    append(mesh, tail(body, stride));
    return mesh;
}

} // namespace

model::Sequence makeWalker()
{
    model::Connectivity connectivity;
    std::vector<Vec3f> positions;
    for (int frame = 0; frame < FrameCount; ++frame) {
        TriangleMesh mesh = creatureAt(float(frame % StrideFrames) / StrideFrames);
        positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
        connectivity = std::move(mesh.connectivity);
    }
    return model::Sequence(std::move(connectivity), std::move(positions), 30.0, "Walker");
}

} // namespace samples
