// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/meshreport.h"

#include "model/geometry/vec3d.h"
#include "model/mesh/analysis/coincident.h"
#include "model/mesh/analysis/duplicates.h"
#include "model/mesh/analysis/parts.h"
#include "model/mesh/analysis/vertexfans.h"

#include <algorithm>

namespace model {

namespace {

class Analysis
{
public:
    Analysis(const Faces &faces, std::span<const Vec3f> positions)
        : mFaces(faces)
        , mPositions(positions)
        , mLinks(faces)
        , mParts(findParts(mLinks))
        , mFans(findFans(mLinks))
    {
        mReport.vertices = faces.vertexCount();
        mReport.edges = mLinks.edgeCount();
        mReport.faces = faces.faceCount();
        mReport.components.resize(mParts.componentCount());
        for (std::uint32_t c = 0; c < mParts.componentCount(); ++c)
            mReport.components[c].isOrientable = mParts.isOrientable[c];
    }

    MeshReport run(const Progress &progress)
    {
        progress.report(0.5);
        countVertices();
        countFacesAndEdges();
        if (progress.isCancelled())
            return {};
        progress.report(0.6);
        findHoles();
        if (progress.isCancelled())
            return {};
        progress.report(0.7);
        measure();
        conclude();
        progress.report(0.9);
        problems(ProblemKind::DuplicateFace) = findDuplicateFaces(mLinks);
        problems(ProblemKind::CoincidentVertex) = findCoincidentVertices(mPositions);
        for (std::vector<ProblemIds> &list : mReport.problems)
            std::sort(list.begin(), list.end());
        mReport.componentOfFace = std::move(mParts.componentOf);
        return std::move(mReport);
    }

private:
    std::vector<ProblemIds> &problems(ProblemKind kind) { return mReport.problems[std::size_t(kind)]; }
    ComponentReport &componentOf(std::uint32_t face) { return mReport.components[mParts.componentOf[face]]; }
    ComponentReport &componentOfCorner(std::uint32_t corner) { return componentOf(mFaces.faceOf(corner)); }

    void countVertices()
    {
        for (std::uint32_t v = 0; v < mFaces.vertexCount(); ++v) {
            if (mFans.cornerAt[v] == NoFaceCorner)
                problems(ProblemKind::IsolatedVertex).push_back({v, NoId});
            else
                ++componentOfCorner(mFans.cornerAt[v]).vertices;
        }
        for (const VertexFans::Split &split : mFans.splits) {
            problems(ProblemKind::NonManifoldVertex).push_back({split.vertex, NoId});
            // Counted above in one of the components that meet here.
            std::vector<std::uint32_t> components;
            for (const auto &fan : split.fans)
                components.push_back(mParts.componentOf[mFaces.faceOf(fan.front())]);
            std::sort(components.begin(), components.end());
            for (std::size_t i = 0; i < components.size(); ++i) {
                if (i > 0 && components[i] == components[i - 1])
                    mReport.components[components[i]].isManifold = false;
                else
                    ++mReport.components[components[i]].vertices;
            }
            --componentOfCorner(mFans.cornerAt[split.vertex]).vertices;
        }
    }

    void countFacesAndEdges()
    {
        for (std::uint32_t f = 0; f < mFaces.faceCount(); ++f) {
            ComponentReport &component = componentOf(f);
            if (component.faces++ == 0)
                component.firstFace = f;
            for (std::uint32_t side = mFaces.begin(f); side < mFaces.end(f); ++side) {
                const std::uint32_t across = mLinks.across(side);
                component.edges += across == BorderSide || (across <= LastLinkedSide && across > side);
                component.boundaryEdges += across == BorderSide;
                if (across <= LastLinkedSide && across > side && mLinks.isTwisted(side)) {
                    ++component.inconsistentEdges;
                    const Edge edge = mLinks.edge(side);
                    problems(ProblemKind::InconsistentEdge).push_back({edge[0], edge[1]});
                }
            }
            if (isDegenerate(mFaces.face(f))) {
                component.isManifold = false;
                problems(ProblemKind::DegenerateFace).push_back({f, NoId});
            }
        }
        for (const FaceLinks::CrowdedEdge &crowded : mLinks.crowded()) {
            ComponentReport &component = componentOfCorner(crowded.sides[0]);
            ++component.edges;
            component.isManifold = false;
            problems(ProblemKind::NonManifoldEdge).push_back({crowded.edge[0], crowded.edge[1]});
        }
    }

    Vec3d at(std::uint32_t vertex) const { return mPositions[vertex]; }

    void findHoles()
    {
        for (BorderLoop &loop : findBorderLoops(mLinks)) {
            HoleReport hole;
            hole.component = mParts.componentOf[mFaces.faceOf(loop.sides.front())];
            ++mReport.components[hole.component].boundaryLoops;
            Vec3d normal;
            const Vec3d origin = at(loop.vertices.front());
            for (const std::uint32_t side : loop.sides)
                hole.length += distance(at(mFaces.vertex(side)), at(mFaces.sideEnd(side)));
            for (std::size_t i = 0; i < loop.vertices.size(); ++i)
                normal = normal + cross(at(loop.vertices[i]) - origin,
                                        at(loop.vertices[(i + 1) % loop.vertices.size()]) - origin);
            hole.area = std::sqrt(dot(normal, normal)) / 2;
            hole.loop = std::move(loop);
            mReport.holes.push_back(std::move(hole));
        }
    }

    /// Polygons that are not flat have the area and volume of their fans.
    void measure()
    {
        for (std::uint32_t f = 0; f < mFaces.faceCount(); ++f) {
            ComponentReport &component = componentOf(f);
            const auto face = mFaces.face(f);
            double area = 0, volume = 0, longest = 0;
            for (std::size_t i = 0; i < face.size(); ++i) {
                component.box.add(mPositions[face[i]]);
                longest = std::max(longest, squaredDistance(at(face[i]), at(face[i + 1 == face.size() ? 0 : i + 1])));
            }
            if (face.size() > 2) {
                // From a vertex of the component, so that large coordinates do not cost digits.
                const Vec3d origin = at(mFaces.vertex(mFaces.begin(component.firstFace)));
                const Vec3d a = at(face[0]);
                for (std::size_t i = 2; i < face.size(); ++i) {
                    const Vec3d normal = cross(at(face[i - 1]) - a, at(face[i]) - a);
                    area += std::sqrt(dot(normal, normal));
                    volume += dot(a - origin, normal);
                }
                if (area <= 2 * ZeroAreaShare * longest && !isDegenerate(face))
                    problems(ProblemKind::ZeroAreaFace).push_back({f, NoId});
            }
            component.area += area / 2;
            component.volume = component.volume.value_or(0) + (mParts.isTurned[f] ? -volume : volume) / 6;
        }
    }

    void conclude()
    {
        for (std::uint32_t c = 0; c < mReport.components.size(); ++c) {
            ComponentReport &component = mReport.components[c];
            if (!component.isManifold || !component.isOrientable || component.boundaryLoops > 0)
                component.volume.reset();
            if (component.volume && *component.volume < 0)
                problems(ProblemKind::InsideOutComponent).push_back({c, NoId});
            if (component.isManifold) {
                const std::int64_t missing = 2 - std::int64_t(component.boundaryLoops) - component.euler();
                component.genus = std::uint32_t(component.isOrientable ? missing / 2 : missing);
            }
        }
    }

    const Faces &mFaces;
    const std::span<const Vec3f> mPositions;
    const FaceLinks mLinks;
    MeshParts mParts;
    const VertexFans mFans;
    MeshReport mReport;
};

} // namespace

const char *problemKey(ProblemKind kind)
{
    switch (kind) {
    case ProblemKind::NonManifoldEdge:
        return "non_manifold_edges";
    case ProblemKind::NonManifoldVertex:
        return "non_manifold_vertices";
    case ProblemKind::InconsistentEdge:
        return "inconsistent_edges";
    case ProblemKind::DegenerateFace:
        return "degenerate_faces";
    case ProblemKind::ZeroAreaFace:
        return "zero_area_faces";
    case ProblemKind::DuplicateFace:
        return "duplicate_faces";
    case ProblemKind::IsolatedVertex:
        return "isolated_vertices";
    case ProblemKind::CoincidentVertex:
        return "coincident_vertices";
    case ProblemKind::InsideOutComponent:
        return "inside_out_components";
    case ProblemKind::SelfIntersection:
        return "self_intersections";
    }
    return "";
}

bool MeshReport::isManifold() const
{
    return of(ProblemKind::NonManifoldVertex).empty() &&
           std::all_of(components.begin(), components.end(), [](const ComponentReport &c) { return c.isManifold; });
}

bool MeshReport::isOrientable() const
{
    return std::all_of(components.begin(), components.end(), [](const ComponentReport &c) { return c.isOrientable; });
}

std::optional<std::uint32_t> MeshReport::genus() const
{
    std::uint32_t sum = 0;
    for (const ComponentReport &component : components) {
        if (!component.genus || !component.isOrientable)
            return std::nullopt;
        sum += *component.genus;
    }
    return sum;
}

Result<MeshReport> analyseMesh(const Faces &faces, std::span<const Vec3f> positions, const Progress &progress)
{
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    MeshReport report = Analysis(faces, positions).run(progress);
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    progress.report(1);
    return report;
}

} // namespace model
