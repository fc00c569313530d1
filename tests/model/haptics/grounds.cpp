// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/haptics/grounds.h"

namespace tests {

using namespace model;
using namespace model::haptics;

terrain::Terrain groundOf(double spacing, const std::function<double(double, double)> &height)
{
    std::vector<terrain::Point3> points;
    const int count = int(std::lround(2 / spacing));
    for (int j = 0; j <= count; ++j)
        for (int i = 0; i <= count; ++i) {
            const double x = -1 + 2.0 * i / count, y = -1 + 2.0 * j / count;
            points.push_back({x, y, height(x, y)});
        }
    return terrain::Terrain(terrain::buildTin(points, {{-1, -1}, {1, 1}})->tin);
}

void levelPatch(TerrainPatch &patch, double height, const Feel &feel)
{
    const float z = float(height);
    tiltedPatch(patch, {z, z, z, z}, feel);
}

void tiltedPatch(TerrainPatch &patch, const std::array<float, 4> &heights, const Feel &feel)
{
    patch.centre = {0, 0};
    patch.centreHeight = 0;
    patch.radius = 1;
    patch.feel = feel;
    const Vec3f a{-1, -1, heights[0]}, b{1, -1, heights[1]}, c{1, 1, heights[2]}, d{-1, 1, heights[3]};
    patch.triangles[0] = {a, b, c};
    patch.triangles[1] = {a, c, d};
    patch.triangleCount = 2;
    patch.index();
}

Workspace plainWorkspace()
{
    Workspace workspace;
    workspace.toolRadius = 0.01;
    return workspace;
}

VirtualLoop::VirtualLoop(LawKind law)
{
    feel.graininess = 0;
    settings.id = 1;
    settings.law = law;
    settings.workspace = plainWorkspace();
    settings.limits.userForce = 10;
    settings.limits.power = 1000;
    settings.limits.low = {-1, -1, -1};
    settings.limits.high = {1, 1, 1};
    core.publishSettings(settings);
    refresh(0);
}

void VirtualLoop::refresh(double newHeight)
{
    height = newHeight;
    TerrainPatch &patch = core.nextPatch();
    levelPatch(patch, height, feel);
    patch.id = ++mPatch;
    patch.time = now;
    core.publishPatch();
    mRefreshed = now;
}

ServoSample VirtualLoop::step(Vec3d position, Time elapsed)
{
    now += elapsed;
    if (refreshes && now - mRefreshed >= std::chrono::milliseconds(20))
        refresh(height);
    Reading reading;
    reading.position = position;
    reading.time = now;
    reading.isConnected = isConnected;
    return core.step(reading, now);
}

void VirtualLoop::arm(Vec3d position)
{
    core.setForces(true);
    for (int i = 0; i < 2100; ++i)
        step(position);
}

} // namespace tests
