// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/faces.h"

#include <algorithm>

namespace model {

Faces::Faces(const Connectivity &connectivity)
    : mVertexCount(connectivity.vertexCount)
{
    mCorners.reserve(3 * connectivity.triangles.size());
    for (const Triangle &t : connectivity.triangles)
        mCorners.insert(mCorners.end(), t.begin(), t.end());
}

void Faces::reserve(std::size_t faces, std::size_t corners)
{
    mCorners.reserve(corners);
    if (!mBegins.empty()) {
        mBegins.reserve(faces + 1);
        mFaceOf.reserve(corners);
    }
}

void Faces::add(std::span<const std::uint32_t> corners)
{
    if (mBegins.empty() && corners.size() != 3) {
        for (std::uint32_t corner = 0; corner < mCorners.size(); ++corner) {
            if (corner % 3 == 0)
                mBegins.push_back(corner);
            mFaceOf.push_back(corner / 3);
        }
        mBegins.push_back(cornerCount());
    }
    if (!mBegins.empty()) {
        mFaceOf.insert(mFaceOf.end(), corners.size(), faceCount());
        mBegins.push_back(std::uint32_t(mCorners.size() + corners.size()));
    }
    mCorners.insert(mCorners.end(), corners.begin(), corners.end());
}

void Faces::renameVertices(std::span<const std::uint32_t> names)
{
    for (std::uint32_t &vertex : mCorners)
        vertex = names[vertex];
}

Connectivity fans(const Faces &faces, std::vector<std::uint32_t> *faceOf)
{
    Connectivity connectivity{faces.vertexCount(), {}};
    connectivity.triangles.reserve(faces.faceCount());
    if (faceOf)
        faceOf->clear();
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
        const auto face = faces.face(f);
        for (std::size_t i = 2; i < face.size(); ++i) {
            connectivity.triangles.push_back({face[0], face[i - 1], face[i]});
            if (faceOf)
                faceOf->push_back(f);
        }
    }
    return connectivity;
}

bool isDegenerate(std::span<const std::uint32_t> face)
{
    if (face.size() == 3)
        return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
    if (face.size() < 3)
        return true;
    std::vector<std::uint32_t> sorted(face.begin(), face.end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

} // namespace model
