// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: M. Mueller, B. Heidelberger, M. Hennix, J. Ratcliff, "Position based dynamics", 2007;
//           M. Macklin, K. Storey, M. Lu, P. Terdiman, N. Chentanez, S. Jeschke, M. Mueller, "Small steps in physics
//           simulation", 2019: one solver pass in each of many substeps.
// Differs:  near particles of the cloth keep each other at a distance.
#include "app/samples/samples.h"
#include "app/samples/shapes.h"

#include <algorithm>
#include <cmath>

namespace samples {

namespace {

using model::Vec3f;

constexpr int FrameCount = 150;
constexpr double FrameRate = 30;
constexpr int Side = 76; ///< vertices along an edge of the cloth
constexpr float ClothSize = 2.3f;
constexpr float Spacing = ClothSize / (Side - 1);
constexpr float BallRadius = 0.55f;
constexpr float Thickness = 0.9f * Spacing; ///< least distance of two sheets of cloth
constexpr int Substeps = 24;
constexpr int PairLife = 4;                   ///< substeps for which the list of near particles is kept
constexpr float PairReach = 1.6f * Thickness; ///< what may touch within that time
constexpr float StretchCompliance = 1e-7f;
constexpr float ShearCompliance = 4e-6f;
constexpr float BendCompliance = 6e-3f;
constexpr float AirDrag = 0.55f; ///< 1/s
constexpr float BallFriction = 0.35f;

struct Distance
{
    std::uint32_t a, b;
    float rest;
    float compliance;
};

class Cloth
{
public:
    Cloth()
    {
        for (int row = 0; row < Side; ++row)
            for (int column = 0; column < Side; ++column) {
                // Turned and a little off the middle, with a faint unevenness: perfect symmetry would buckle
                // unnaturally.
                const float x = (float(column) - 0.5f * (Side - 1)) * Spacing,
                            z = (float(row) - 0.5f * (Side - 1)) * Spacing;
                const float unevenness = 0.004f * std::sin(5.1f * x + 1.7f * z) * std::sin(4.3f * z - 2.2f * x);
                mPositions.push_back({0.955f * x + 0.296f * z + 0.06f, BallRadius + 0.42f + unevenness,
                                      -0.296f * x + 0.955f * z - 0.03f});
            }
        mVelocities.resize(mPositions.size());
        for (int row = 0; row < Side; ++row)
            for (int column = 0; column < Side; ++column) {
                connect(row, column, 0, 1, StretchCompliance);
                connect(row, column, 1, 0, StretchCompliance);
                connect(row, column, 1, 1, ShearCompliance);
                connect(row, column, 1, -1, ShearCompliance);
                connect(row, column, 0, 2, BendCompliance);
                connect(row, column, 2, 0, BendCompliance);
            }
    }

    const std::vector<Vec3f> &positions() const { return mPositions; }

    void advance(float seconds)
    {
        for (int i = 0; i < Substeps; ++i) {
            if (i % PairLife == 0)
                findNearPairs();
            substep(seconds / Substeps);
        }
    }

private:
    static std::uint32_t at(int row, int column) { return std::uint32_t(row * Side + column); }

    void connect(int row, int column, int down, int right, float compliance)
    {
        const int r = row + down, c = column + right;
        if (r >= Side || c < 0 || c >= Side)
            return;
        const std::uint32_t a = at(row, column), b = at(r, c);
        mDistances.push_back({a, b, length(mPositions[a] - mPositions[b]), compliance});
    }

    void substep(float dt)
    {
        std::vector<Vec3f> previous = mPositions;
        for (std::size_t i = 0; i < mPositions.size(); ++i) {
            mVelocities[i] = mVelocities[i] * (1 - AirDrag * dt) + Vec3f{0, -9.81f * dt, 0};
            mPositions[i] = mPositions[i] + mVelocities[i] * dt;
        }
        for (const Distance &d : mDistances) {
            const Vec3f apart = mPositions[d.a] - mPositions[d.b];
            const float now = length(apart);
            const Vec3f move = apart * ((d.rest - now) / (now * (2 + d.compliance / (dt * dt))));
            mPositions[d.a] = mPositions[d.a] + move;
            mPositions[d.b] = mPositions[d.b] - move;
        }
        for (const auto &[a, b] : mNearPairs)
            separate(a, b, previous);
        for (std::size_t i = 0; i < mPositions.size(); ++i) {
            stayOutside(i, previous[i]);
            mVelocities[i] = (mPositions[i] - previous[i]) * (1 / dt);
        }
    }

    void stayOutside(std::size_t i, Vec3f previous)
    {
        Vec3f &p = mPositions[i];
        constexpr float Skin = BallRadius + 0.5f * Thickness;
        if (const float distance = length(p); distance < Skin)
            pushOut(p, p * (1 / distance), Skin - distance, previous, BallFriction);
    }

    /// Coulomb's friction: what is pushed out by `depth` may slide back by at most friction * depth.
    static void pushOut(Vec3f &p, Vec3f normal, float depth, Vec3f previous, float friction)
    {
        p = p + normal * depth;
        const Vec3f moved = p - previous;
        const Vec3f sliding = moved - normal * dot(moved, normal);
        const float slid = length(sliding);
        if (slid > 0)
            p = p - sliding * std::min(1.0f, friction * depth / slid + 0.01f);
    }

    /// Lists the particles that are near each other but not neighbours in the cloth, by a grid of cells.
    void findNearPairs()
    {
        const auto cellOf = [](float x) { return std::int64_t(std::floor(x / PairReach)) + (1 << 19); };
        const auto key = [](std::int64_t x, std::int64_t y, std::int64_t z) { return (x << 40) | (y << 20) | z; };
        std::vector<std::pair<std::int64_t, std::uint32_t>> cells;
        for (std::uint32_t i = 0; i < mPositions.size(); ++i)
            cells.push_back({key(cellOf(mPositions[i].x), cellOf(mPositions[i].y), cellOf(mPositions[i].z)), i});
        std::ranges::sort(cells);
        mNearPairs.clear();
        for (std::uint32_t i = 0; i < mPositions.size(); ++i) {
            const std::int64_t x = cellOf(mPositions[i].x), y = cellOf(mPositions[i].y), z = cellOf(mPositions[i].z);
            for (std::int64_t dx = -1; dx <= 1; ++dx)
                for (std::int64_t dy = -1; dy <= 1; ++dy) {
                    // The three cells along z are neighbours in the sorted list.
                    auto it = std::ranges::lower_bound(cells, std::pair(key(x + dx, y + dy, z - 1), 0u));
                    for (; it != cells.end() && it->first <= key(x + dx, y + dy, z + 1); ++it)
                        if (it->second > i && !areNeighbours(i, it->second) &&
                            length(mPositions[i] - mPositions[it->second]) < PairReach)
                            mNearPairs.push_back({i, it->second});
                }
        }
    }

    static bool areNeighbours(std::uint32_t a, std::uint32_t b)
    {
        return std::abs(int(a / Side) - int(b / Side)) <= 1 && std::abs(int(a % Side) - int(b % Side)) <= 1;
    }

    void separate(std::uint32_t a, std::uint32_t b, const std::vector<Vec3f> &previous)
    {
        const Vec3f apart = mPositions[a] - mPositions[b];
        const float now = length(apart);
        if (now >= Thickness || now == 0)
            return;
        const Vec3f push = apart * (0.5f * (Thickness - now) / now);
        mPositions[a] = mPositions[a] + push;
        mPositions[b] = mPositions[b] - push;
        // Sheets that touch rub: a share of their relative motion goes.
        constexpr float Rubbing = 0.25f;
        const Vec3f slide = ((mPositions[a] - previous[a]) - (mPositions[b] - previous[b])) * Rubbing;
        mPositions[a] = mPositions[a] - slide;
        mPositions[b] = mPositions[b] + slide;
    }

    std::vector<Vec3f> mPositions, mVelocities;
    std::vector<Distance> mDistances;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> mNearPairs;
};

model::TriangleMesh clothSheet(const std::vector<Vec3f> &positions)
{
    model::TriangleMesh sheet;
    sheet.positions = positions;
    sheet.connectivity.vertexCount = std::uint32_t(positions.size());
    for (std::uint32_t row = 0; row + 1 < Side; ++row)
        for (std::uint32_t column = 0; column + 1 < Side; ++column) {
            const std::uint32_t a = row * Side + column, b = a + 1, c = a + Side, d = c + 1;
            // Alternating diagonals: no direction folds more easily than another.
            if ((row + column) % 2 == 0)
                sheet.connectivity.triangles.insert(sheet.connectivity.triangles.end(), {{a, c, d}, {a, d, b}});
            else
                sheet.connectivity.triangles.insert(sheet.connectivity.triangles.end(), {{a, c, b}, {b, c, d}});
        }
    return sheet;
}

} // namespace

model::Sequence makeCloth()
{
    Cloth cloth;
    const model::TriangleMesh ball = icosphere(BallRadius, 4);
    model::Connectivity connectivity;
    std::vector<Vec3f> positions;
    for (int frame = 0; frame < FrameCount; ++frame) {
        model::TriangleMesh mesh = clothSheet(cloth.positions());
        append(mesh, ball);
        positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
        connectivity = std::move(mesh.connectivity);
        cloth.advance(float(1 / FrameRate));
    }
    return model::Sequence(std::move(connectivity), std::move(positions), FrameRate, "Cloth");
}

} // namespace samples
