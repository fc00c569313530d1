// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/animations.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

using namespace model;

namespace tests {

PlainAnimation::PlainAnimation(std::uint32_t frames, std::uint32_t vertices, std::vector<Triangle> triangles,
                               const std::function<Vec3f(std::uint32_t, std::uint32_t)> &position)
    : mConnectivity{vertices, std::move(triangles)}
    , mFrames(frames, std::vector<Vec3f>(vertices))
{
    for (std::uint32_t f = 0; f < frames; ++f)
        for (std::uint32_t v = 0; v < vertices; ++v)
            mFrames[f][v] = position(f, v);
}

void PlainAnimation::positions(std::uint32_t frame, std::span<Vec3f> out) const
{
    std::copy(mFrames[frame].begin(), mFrames[frame].end(), out.begin());
}

std::vector<Triangle> strip(std::uint32_t vertices)
{
    std::vector<Triangle> triangles;
    for (std::uint32_t v = 0; v + 2 < vertices; ++v)
        triangles.push_back(v % 2 ? Triangle{v + 1, v, v + 2} : Triangle{v, v + 1, v + 2});
    return triangles;
}

PlainAnimation waves(std::uint32_t frames, std::uint32_t vertices, unsigned modes)
{
    return {frames, vertices, strip(vertices), [&](std::uint32_t f, std::uint32_t v) {
                const double time = frames > 1 ? double(f) / (frames - 1) : 0;
                const double u = std::fmod(v * 0.618033988749895, 1.0);
                const double s = double(v) / vertices;
                double lift = 0;
                for (unsigned m = 1; m <= modes; ++m)
                    lift += std::sin(6.3 * m * (s + 0.3 * u) + m) * std::cos(6.3 * (m % 5 + 1) * time + 2 * m) /
                            (m * m + 2.0);
                return Vec3f{float(2 * s - 1 + 0.3 * time), float(u - 0.5), float(lift)};
            }};
}

PlainAnimation flock(std::uint32_t frames, std::uint32_t bodies, std::uint32_t vertices)
{
    std::vector<model::Triangle> triangles;
    for (std::uint32_t body = 0; body < bodies; ++body)
        for (model::Triangle t : strip(vertices)) {
            for (std::uint32_t &v : t)
                v += body * vertices;
            triangles.push_back(t);
        }
    return {frames, bodies * vertices, triangles, [=](std::uint32_t f, std::uint32_t v) {
                const double body = v / vertices, i = v % vertices;
                const double t = double(f) / frames, own = 1.7 * body;
                const double flap = std::sin((9 + 3.1 * body) * t + own) * std::pow(i / vertices - 0.5, 2);
                const double twist = std::sin((5 + 2.3 * body) * t * t + own) * (v % 2);
                const double wave = std::cos((14 + body) * t + 7 * i / vertices + own) * 0.3;
                return Vec3f{float(3 * body + 0.1 * i + 0.2 * twist), float(2 * flap + 0.5 * wave),
                             float(0.4 * (v % 2) + 0.3 * wave * twist)};
            }};
}

std::vector<NamedAnimation> animationTable()
{
    std::vector<NamedAnimation> table;
    const auto add = [&](std::string name, PlainAnimation animation) {
        table.push_back({std::move(name), std::make_shared<PlainAnimation>(std::move(animation))});
    };
    add("wave", waves(20, 200, 8));
    add("flock", flock(20, 4, 60));
    add("fewer vertices than rows", waves(40, 17, 8));
    add("one vertex", waves(12, 1, 4));
    add("one frame", waves(1, 50, 4));
    add("one vertex, one frame", waves(1, 1, 1));
    add("two frames", waves(2, 33, 3));
    add("still", {5, 30, strip(30), [](auto, std::uint32_t v) { return Vec3f{float(v), 1, -float(v) * 0.5f}; }});
    add("all at one point", {5, 30, strip(30), [](auto, auto) { return Vec3f{1.5f, 0, -2.25f}; }});
    add("all at one moving point", {5, 30, strip(30), [](std::uint32_t f, auto) { return Vec3f{float(f), 0, 1}; }});
    add("no triangles", {7, 40, {}, [](std::uint32_t f, std::uint32_t v) {
                             return Vec3f{float(std::sin(0.1 * f * v)), float(v % 7), 0};
                         }});
    add("dirty triangles", {3,
                            9,
                            {{0, 0, 0}, {8, 8, 1}, {0, 1, 2}, {0, 1, 2}, {2, 1, 0}, {8, 0, 7}},
                            [](std::uint32_t f, std::uint32_t v) {
                                return Vec3f{float(v), float(f * v % 5), 0};
                            }});
    add("far from the origin", {9, 60, strip(60), [](std::uint32_t f, std::uint32_t v) {
                                    return Vec3f{4e6f + float(v), -7e6f + 2 * float(f), 3e5f + 0.5f * float(f * v % 9)};
                                }});
    add("tiny", {9, 60, strip(60), [](std::uint32_t f, std::uint32_t v) {
                     return Vec3f{1e-7f * float(v), 1e-7f * float(f), 1e-8f * float(f * v % 9)};
                 }});
    return table;
}

std::shared_ptr<PlainAnimation> readPointCache(const std::string &folder)
{
    const std::string stem = folder + folder.substr(folder.find_last_of('/'));
    std::ifstream cache(stem + ".pc2", std::ios::binary);
    char head[32] = {};
    cache.read(head, sizeof head);
    std::uint32_t vertices = 0;
    std::uint32_t frames = 0;
    std::memcpy(&vertices, head + 16, 4);
    std::memcpy(&frames, head + 28, 4);
    std::vector<Vec3f> points(std::size_t(vertices) * frames);
    cache.read(reinterpret_cast<char *>(points.data()), std::streamsize(points.size() * sizeof(Vec3f)));

    std::vector<Triangle> triangles;
    std::ifstream mesh(stem + ".obj");
    for (std::string line; std::getline(mesh, line);) {
        if (line.rfind("f ", 0) != 0)
            continue;
        std::istringstream corners(line.substr(2));
        std::vector<std::uint32_t> face;
        for (std::string corner; corners >> corner;)
            face.push_back(std::uint32_t(std::stoul(corner)) - 1);
        for (std::size_t i = 2; i < face.size(); ++i)
            triangles.push_back({face[0], face[i - 1], face[i]});
    }
    return std::make_shared<PlainAnimation>(
        frames, vertices, std::move(triangles),
        [&](std::uint32_t f, std::uint32_t v) { return points[std::size_t(f) * vertices + v]; });
}

PlainAnimation normalised(const PlainAnimation &animation)
{
    Box3f box;
    for (std::uint32_t f = 0; f < animation.frameCount(); ++f)
        for (const Vec3f p : animation.frame(f)) {
            box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
            box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
        }
    const float longest = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
    PlainAnimation result = animation;
    for (auto &frame : result.frames())
        for (Vec3f &p : frame)
            p = (p - (box.min + box.max) * 0.5f) * (2 / longest);
    return result;
}

PlainAnimation reordered(const PlainAnimation &animation, const std::vector<std::uint32_t> &permutation)
{
    std::vector<std::vector<Vec3f>> frames;
    for (std::uint32_t f = 0; f < animation.frameCount(); ++f)
        frames.push_back(animation.frame(f));
    return {animation.frameCount(), animation.vertexCount(), {}, [&](std::uint32_t f, std::uint32_t v) {
                return frames[f][permutation[v]];
            }};
}

double kgErrorPercent(const FrameSource &reference, const FrameSource &test)
{
    double error = 0;
    double spread = 0;
    for (std::uint32_t f = 0; f < reference.frameCount(); ++f) {
        const auto v = reference.frame(f);
        const auto w = test.frame(f);
        double mean[3] = {};
        for (const Vec3f p : v) {
            mean[0] += double(p.x) / double(v.size());
            mean[1] += double(p.y) / double(v.size());
            mean[2] += double(p.z) / double(v.size());
        }
        for (std::size_t i = 0; i < v.size(); ++i) {
            error += std::pow(double(v[i].x) - double(w[i].x), 2) + std::pow(double(v[i].y) - double(w[i].y), 2) +
                     std::pow(double(v[i].z) - double(w[i].z), 2);
            spread += std::pow(double(v[i].x) - mean[0], 2) + std::pow(double(v[i].y) - mean[1], 2) +
                      std::pow(double(v[i].z) - mean[2], 2);
        }
    }
    return 100 * std::sqrt(error / (spread > 0 ? spread : 1));
}

double largestError(const FrameSource &reference, const FrameSource &test)
{
    double largest = 0;
    for (std::uint32_t f = 0; f < reference.frameCount(); ++f) {
        const auto v = reference.frame(f);
        const auto w = test.frame(f);
        for (std::size_t i = 0; i < v.size(); ++i)
            largest =
                std::max({largest, std::fabs(double(v[i].x) - double(w[i].x)),
                          std::fabs(double(v[i].y) - double(w[i].y)), std::fabs(double(v[i].z) - double(w[i].z))});
    }
    return largest;
}

} // namespace tests
