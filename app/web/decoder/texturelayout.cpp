// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/decoder/texturelayout.h"

#include <algorithm>

namespace web {

using model::Connectivity;
using model::FrameSource;
using model::Triangle;
using model::Vec3f;
using model::codec::ProductAnimation;

std::size_t wholeRows(std::size_t count, std::uint32_t columns)
{
    return (std::max<std::size_t>(count, 1) + columns - 1) / columns * columns;
}

std::uint32_t layerCount(std::uint32_t rank)
{
    return (rank + TexelValues - 1) / TexelValues;
}

VertexCorners cornersOf(const Connectivity &connectivity)
{
    constexpr std::size_t Values = 2; // of a texel
    VertexCorners corners;
    corners.ranges.resize(Values * wholeRows(connectivity.vertexCount, VertexColumns));
    corners.others.resize(Values * wholeRows(3 * connectivity.triangles.size(), CornerColumns));
    for (const Triangle &triangle : connectivity.triangles)
        for (const std::uint32_t vertex : triangle)
            ++corners.ranges[Values * vertex + 1];
    std::uint32_t first = 0;
    std::vector<std::uint32_t> next(connectivity.vertexCount);
    for (std::uint32_t vertex = 0; vertex < connectivity.vertexCount; ++vertex) {
        corners.ranges[Values * vertex] = next[vertex] = first;
        first += corners.ranges[Values * vertex + 1];
    }
    for (const Triangle &triangle : connectivity.triangles)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::size_t at = Values * std::size_t(next[triangle[corner]]++);
            corners.others[at] = triangle[(corner + 1) % 3];
            corners.others[at + 1] = triangle[(corner + 2) % 3];
        }
    return corners;
}

std::vector<std::uint32_t> edgesOf(const Connectivity &connectivity)
{
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * connectivity.triangles.size());
    for (const Triangle &triangle : connectivity.triangles)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint64_t a = triangle[corner], b = triangle[(corner + 1) % 3];
            if (a != b)
                edges.push_back(std::min(a, b) << 32 | std::max(a, b));
        }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<std::uint32_t> ends;
    ends.reserve(2 * edges.size());
    for (const std::uint64_t edge : edges) {
        ends.push_back(std::uint32_t(edge >> 32));
        ends.push_back(std::uint32_t(edge));
    }
    return ends;
}

std::vector<float> coefficientLayer(const ProductAnimation &animation, std::uint32_t layer)
{
    std::vector<float> texels(TexelValues * wholeRows(animation.vertexCount(), VertexColumns));
    const std::uint32_t first = layer * TexelValues;
    const std::uint32_t count = std::min(TexelValues, animation.rank() - first);
    for (std::size_t vertex = 0; vertex < animation.vertexCount(); ++vertex)
        for (std::uint32_t k = 0; k < count; ++k)
            texels[TexelValues * vertex + k] = animation.coefficient(first + k, vertex);
    return texels;
}

std::vector<float> basisRows(const ProductAnimation &animation, const Vec3f &centre)
{
    const double origin[] = {centre.x, centre.y, centre.z};
    const std::size_t texels = 1 + std::size_t(TexelValues) * layerCount(animation.rank());
    std::vector<float> rows(4 * texels * animation.frameCount());
    float *row = rows.data();
    for (std::size_t frame = 0; frame < animation.frameCount(); ++frame, row += 4 * texels)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            row[axis] = float(animation.mean(3 * frame + axis) - origin[axis]);
            for (std::uint32_t k = 0; k < animation.rank(); ++k)
                row[4 * (1 + std::size_t(k)) + axis] = animation.basis(k, 3 * frame + axis);
        }
    return rows;
}

std::vector<float> frameTexels(const FrameSource &animation, std::uint32_t frame, const Vec3f &centre)
{
    const std::vector<Vec3f> positions = animation.frame(frame);
    std::vector<float> texels(4 * wholeRows(positions.size(), VertexColumns));
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
        const Vec3f place = positions[vertex] - centre;
        texels[4 * vertex] = place.x;
        texels[4 * vertex + 1] = place.y;
        texels[4 * vertex + 2] = place.z;
    }
    return texels;
}

} // namespace web
