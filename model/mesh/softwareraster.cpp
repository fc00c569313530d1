// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: J. Pineda, A Parallel Algorithm for Polygon Rasterization, 1988 (edge functions).
// Differs: vertices snap to 1/256 sample, so that edge functions are exact in double and neighbours leave no crack;
//          the nearest triangle of each sample is found first and shaded once.
#include "model/mesh/softwareraster.h"

#include "model/base/parallel.h"
#include "model/mesh/normals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace model {

namespace {

constexpr int SamplesPerAxis = 2;         ///< 2 x 2 a pixel
constexpr int BandHeight = 16;            ///< pixels; a band is the unit of work for a thread and bounds the memory
constexpr double SnapSteps = 256;         ///< of a vertex, per sample
constexpr float WireHalfWidth = 0.4f;     ///< pixels, on each side of an edge
constexpr float WireOpacity = 0.75f;      ///< keeps the surface readable where triangles are as small as pixels
constexpr std::uint32_t NoTriangle = ~0u; ///< a sample that shows the background

/// A vertex in clip space: visible where -w <= z.
struct ClipVertex
{
    double x, y, z, w;
    Vec3f normal; ///< in camera space
    float place;  ///< on the palette
};

/// A triangle on the screen, in samples, x to the right, y down.
struct ScreenTriangle
{
    double x[3], y[3];
    double sign;  ///< makes its edge functions positive inside
    double depth; ///< at the origin of the screen, and how it grows
    double depthDx, depthDy;
    Vec3f normal[3];           ///< over w, so that their linear blend is perspective-correct but for its length
    float place[3], weight[3]; ///< on the palette, over w; 1 over w
    float edgeLength[3];       ///< of the edge opposite to each vertex; 0: not an edge of the mesh, drawn without wire
    bool front;
};

/// Twice the signed area of a, b, p: the edge function of a -> b.
double edge(const ScreenTriangle &t, int a, int b, double px, double py)
{
    return t.sign * ((t.x[b] - t.x[a]) * (py - t.y[a]) - (t.y[b] - t.y[a]) * (px - t.x[a]));
}

ClipVertex transformed(const Matrix4 &m, Vec3f p, Vec3f normal, float place)
{
    const auto row = [&](int i) {
        return double(m[i]) * p.x + double(m[4 + i]) * p.y + double(m[8 + i]) * p.z + m[12 + i];
    };
    return {row(0), row(1), row(2), row(3), normal, place};
}

Vec3f rotated(const Matrix4 &m, Vec3f v)
{
    return {m[0] * v.x + m[4] * v.y + m[8] * v.z, m[1] * v.x + m[5] * v.y + m[9] * v.z,
            m[2] * v.x + m[6] * v.y + m[10] * v.z};
}

ClipVertex blend(const ClipVertex &a, const ClipVertex &b, double t)
{
    const auto mix = [t](double u, double v) { return u + (v - u) * t; };
    return {mix(a.x, b.x),
            mix(a.y, b.y),
            mix(a.z, b.z),
            mix(a.w, b.w),
            a.normal + (b.normal - a.normal) * float(t),
            float(mix(a.place, b.place))};
}

/// Collects the triangles that a picture shows, clipped at the near plane.
class Scene
{
public:
    Scene(int width, int height, std::size_t triangleCount)
        : mWidth(width * SamplesPerAxis)
        , mHeight(height * SamplesPerAxis)
    {
        mTriangles.reserve(triangleCount);
    }

    const std::vector<ScreenTriangle> &triangles() const { return mTriangles; }

    void add(const ClipVertex &a, const ClipVertex &b, const ClipVertex &c)
    {
        const ClipVertex *corners[3] = {&a, &b, &c};
        ClipVertex polygon[4];
        int count = 0;
        for (int i = 0; i < 3; ++i) {
            const ClipVertex &from = *corners[i];
            const ClipVertex &to = *corners[(i + 1) % 3];
            const double fromDistance = from.z + from.w;
            const double toDistance = to.z + to.w;
            if (!std::isfinite(fromDistance) || !std::isfinite(from.x) || !std::isfinite(from.y))
                return;
            if (fromDistance > 0)
                polygon[count++] = from;
            if ((fromDistance > 0) != (toDistance > 0))
                polygon[count++] = blend(from, to, fromDistance / (fromDistance - toDistance));
        }
        if (count >= 3)
            project(polygon[0], polygon[1], polygon[2], count == 3);
        if (count == 4)
            project(polygon[0], polygon[2], polygon[3], false);
    }

private:
    void project(const ClipVertex &a, const ClipVertex &b, const ClipVertex &c, bool whole)
    {
        ScreenTriangle t;
        double depth[3];
        const ClipVertex *corners[3] = {&a, &b, &c};
        for (int i = 0; i < 3; ++i) {
            const ClipVertex &v = *corners[i];
            if (!(v.w > 0))
                return;
            t.x[i] = std::round((v.x / v.w * 0.5 + 0.5) * mWidth * SnapSteps) / SnapSteps;
            t.y[i] = std::round((0.5 - v.y / v.w * 0.5) * mHeight * SnapSteps) / SnapSteps;
            depth[i] = v.z / v.w;
            t.normal[i] = v.normal * float(1 / v.w);
            t.place[i] = v.place * float(1 / v.w);
            t.weight[i] = float(1 / v.w);
        }
        t.sign = 1;
        const double area = edge(t, 0, 1, t.x[2], t.y[2]);
        const auto [left, right] = std::minmax({t.x[0], t.x[1], t.x[2]});
        if (!(std::abs(area) > 0) || right < 0 || left > mWidth)
            return;
        t.sign = area > 0 ? 1 : -1;
        t.front = area < 0; // counter-clockwise, y downwards
        const double u = depth[1] - depth[0];
        const double v = depth[2] - depth[0];
        t.depthDx = (u * (t.y[2] - t.y[0]) - v * (t.y[1] - t.y[0])) / area;
        t.depthDy = (v * (t.x[1] - t.x[0]) - u * (t.x[2] - t.x[0])) / area;
        t.depth = depth[0] - t.depthDx * t.x[0] - t.depthDy * t.y[0];
        for (int i = 0; i < 3; ++i) {
            const int from = (i + 1) % 3;
            const int to = (i + 2) % 3;
            t.edgeLength[i] = whole ? float(std::hypot(t.x[to] - t.x[from], t.y[to] - t.y[from])) : 0.0f;
        }
        mTriangles.push_back(t);
    }

    int mWidth, mHeight; ///< samples
    std::vector<ScreenTriangle> mTriangles;
};

/// Light that leaves a surface; colours are linear (squares of what a screen shows), lights turn with the camera.
Vec3f shade(Vec3f surface, Vec3f normal)
{
    constexpr Vec3f Key{-0.402f, 0.536f, 0.742f}; // from the upper left, in front
    constexpr Vec3f Fill{0.812f, 0.071f, 0.579f};
    constexpr Vec3f Half{-0.215f, 0.287f, 0.933f}; // between the key light and the viewer
    const float key = 0.78f * std::max(0.0f, dot(normal, Key));
    const float fill = 0.20f * std::max(0.0f, dot(normal, Fill));
    const float sky = 0.10f + 0.06f * normal.y;
    float gloss = std::max(0.0f, dot(normal, Half));
    for (int i = 0; i < 5; ++i) // to the 32nd power
        gloss *= gloss;
    const Vec3f light{key + 0.85f * fill + sky, 0.98f * key + 0.95f * fill + sky, 0.94f * key + fill + 1.15f * sky};
    const float shine = 0.10f * gloss;
    return {surface.x * light.x + shine, surface.y * light.y + shine, surface.z * light.z + shine};
}

Vec3f linear(const std::array<std::uint8_t, 3> &colour)
{
    const auto channel = [](std::uint8_t c) { return float(c) * float(c) / (255.0f * 255.0f); };
    return {channel(colour[0]), channel(colour[1]), channel(colour[2])};
}

std::uint8_t displayed(float channel)
{
    return std::uint8_t(255.0f * std::sqrt(std::clamp(channel, 0.0f, 1.0f)) + 0.5f);
}

/// The rows first..last of the picture, drawn by one thread.
class Band
{
public:
    Band(const std::vector<ScreenTriangle> &triangles, int width, int firstRow, int rowCount)
        : mTriangles(triangles)
        , mWidth(width * SamplesPerAxis)
        , mFirstRow(firstRow * SamplesPerAxis)
        , mRowCount(rowCount * SamplesPerAxis)
        , mDepth(std::size_t(mWidth) * mRowCount, std::numeric_limits<float>::max())
        , mNearest(mDepth.size(), NoTriangle)
    {}

    void cover(std::uint32_t index)
    {
        const ScreenTriangle &t = mTriangles[index];
        const auto [left, right] = std::minmax({t.x[0], t.x[1], t.x[2]});
        const auto [top, bottom] = std::minmax({t.y[0], t.y[1], t.y[2]});
        const int firstX = int(std::clamp(std::ceil(left - 0.5), 0.0, double(mWidth)));
        const int endX = int(std::clamp(std::floor(right - 0.5) + 1, 0.0, double(mWidth)));
        const int firstY = int(std::clamp(std::ceil(top - 0.5) - mFirstRow, 0.0, double(mRowCount)));
        const int endY = int(std::clamp(std::floor(bottom - 0.5) + 1 - mFirstRow, 0.0, double(mRowCount)));
        const double stepX[3] = {t.sign * (t.y[1] - t.y[2]), t.sign * (t.y[2] - t.y[0]), t.sign * (t.y[0] - t.y[1])};
        for (int y = firstY; y < endY; ++y) {
            const double py = y + mFirstRow + 0.5;
            const double px = firstX + 0.5;
            double inside[3] = {edge(t, 1, 2, px, py), edge(t, 2, 0, px, py), edge(t, 0, 1, px, py)};
            const double depth = t.depth + t.depthDy * py;
            float *const depths = mDepth.data() + std::size_t(y) * mWidth;
            for (int x = firstX; x < endX; ++x) {
                if (inside[0] >= 0 && inside[1] >= 0 && inside[2] >= 0) {
                    const float z = float(depth + t.depthDx * (x + 0.5));
                    if (z < depths[x]) {
                        depths[x] = z;
                        mNearest[std::size_t(y) * mWidth + x] = index;
                    }
                }
                for (int i = 0; i < 3; ++i)
                    inside[i] += stepX[i];
            }
        }
    }

    /// Colours of the pixels, written to `rgba`, which begins at the band's first pixel.
    void resolve(const RasterStyle &style, int pictureHeight, std::uint8_t *rgba) const
    {
        std::vector<Vec3f> palette;
        for (const auto &colour : style.palette)
            palette.push_back(linear(colour));
        const Vec3f surface = linear(style.surface);
        for (int y = 0; y < mRowCount; y += SamplesPerAxis) {
            const Vec3f background = backgroundOf(style, (mFirstRow + y) / SamplesPerAxis, pictureHeight);
            for (int x = 0; x < mWidth; x += SamplesPerAxis) {
                Vec3f sum;
                for (int sy = y; sy < y + SamplesPerAxis; ++sy)
                    for (int sx = x; sx < x + SamplesPerAxis; ++sx) {
                        const std::uint32_t index = mNearest[std::size_t(sy) * mWidth + sx];
                        sum =
                            sum + (index == NoTriangle ? background
                                                       : colourOf(mTriangles[index], surface, palette, style, sx, sy));
                    }
                const Vec3f mean = sum * (1.0f / (SamplesPerAxis * SamplesPerAxis));
                *rgba++ = displayed(mean.x);
                *rgba++ = displayed(mean.y);
                *rgba++ = displayed(mean.z);
                *rgba++ = 255;
            }
        }
    }

private:
    static Vec3f backgroundOf(const RasterStyle &style, int row, int pictureHeight)
    {
        const float t = pictureHeight > 1 ? float(row) / float(pictureHeight - 1) : 0.0f;
        const auto mix = [&](int i) {
            const float shown = (float(style.backgroundTop[i]) * (1 - t) + float(style.backgroundBottom[i]) * t) / 255;
            return shown * shown;
        };
        return {mix(0), mix(1), mix(2)};
    }

    /// \param place  0..1; what lies outside, or is no number, has the colour of the nearer end
    static Vec3f onPalette(const std::vector<Vec3f> &palette, float place)
    {
        const float steps = float(palette.size() - 1);
        const float scaled = place > 0 ? std::min(place, 1.0f) * steps : 0.0f;
        const std::size_t below = std::min(std::size_t(scaled), palette.size() - 2);
        const float t = scaled - float(below);
        return palette[below] * (1 - t) + palette[below + 1] * t;
    }

    Vec3f colourOf(const ScreenTriangle &t, Vec3f surface, const std::vector<Vec3f> &palette, const RasterStyle &style,
                   int sx, int sy) const
    {
        const double px = sx + 0.5;
        const double py = sy + mFirstRow + 0.5;
        const float weight[3] = {float(edge(t, 1, 2, px, py)), float(edge(t, 2, 0, px, py)),
                                 float(edge(t, 0, 1, px, py))};
        const Vec3f normal = normalized(t.normal[0] * weight[0] + t.normal[1] * weight[1] + t.normal[2] * weight[2]);
        if (!style.places.empty()) {
            const float total = t.weight[0] * weight[0] + t.weight[1] * weight[1] + t.weight[2] * weight[2];
            const float place = t.place[0] * weight[0] + t.place[1] * weight[1] + t.place[2] * weight[2];
            surface = onPalette(palette, place / total);
        }
        const Vec3f colour = shade(surface, t.front ? normal : normal * -1);
        if (!style.wireframe)
            return colour;
        float nearest = 2 * WireHalfWidth;
        for (int i = 0; i < 3; ++i)
            if (t.edgeLength[i] > 0)
                nearest = std::min(nearest, weight[i] / t.edgeLength[i] / SamplesPerAxis);
        const float line = WireOpacity * std::clamp(2 - nearest / WireHalfWidth, 0.0f, 1.0f);
        return colour * (1 - line) + linear(style.backgroundBottom) * line;
    }

    const std::vector<ScreenTriangle> &mTriangles;
    int mWidth, mFirstRow, mRowCount;
    std::vector<float> mDepth;
    std::vector<std::uint32_t> mNearest;
};

/// For each band the triangles that may touch it, in their order.
std::vector<std::vector<std::uint32_t>> trianglesOfBands(const std::vector<ScreenTriangle> &triangles, int bandCount)
{
    std::vector<std::vector<std::uint32_t>> result(static_cast<std::size_t>(bandCount));
    constexpr double SampleRows = BandHeight * SamplesPerAxis;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto [top, bottom] = std::minmax({triangles[i].y[0], triangles[i].y[1], triangles[i].y[2]});
        if (bottom < 0 || top > bandCount * SampleRows)
            continue;
        const int first = int(std::clamp(top / SampleRows, 0.0, bandCount - 1.0));
        const int last = int(std::clamp(bottom / SampleRows, 0.0, bandCount - 1.0));
        for (int band = first; band <= last; ++band)
            result[std::size_t(band)].push_back(i);
    }
    return result;
}

/// Triangles without a corner that is not finite: it would spoil the normals around it.
std::vector<Triangle> finiteTriangles(std::span<const Vec3f> positions, std::span<const Triangle> triangles)
{
    std::vector<Triangle> result;
    result.reserve(triangles.size());
    for (const Triangle &t : triangles)
        if (isFinite(positions[t[0]]) && isFinite(positions[t[1]]) && isFinite(positions[t[2]]))
            result.push_back(t);
    return result;
}

Scene sceneOf(std::span<const Vec3f> positions, std::span<const Triangle> triangles, const OrbitCamera &camera,
              int width, int height, std::span<const float> places)
{
    const std::vector<Triangle> drawn = finiteTriangles(positions, triangles);
    Scene scene(width, height, drawn.size());
    if (drawn.empty())
        return scene;
    Box3f box;
    for (const Triangle &t : drawn)
        for (const std::uint32_t vertex : t)
            box.add(positions[vertex]);
    std::vector<Vec3f> normals(positions.size());
    computeVertexNormals(positions, drawn, normals);
    const Matrix4 view = camera.viewMatrix();
    const Matrix4 clip = multiply(camera.projectionMatrix(float(width) / float(height), box), view);
    std::vector<ClipVertex> vertices(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        vertices[i] = transformed(clip, positions[i], rotated(view, normals[i]), places.empty() ? 0 : places[i]);
    for (const Triangle &t : drawn)
        scene.add(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    return scene;
}

} // namespace

Picture drawMesh(std::span<const Vec3f> positions, std::span<const Triangle> triangles, const OrbitCamera &camera,
                 int width, int height, const RasterStyle &style, const Progress &progress)
{
    assert(width >= 1 && width <= 16384 && height >= 1 && height <= 16384);
    assert(style.places.empty() || (style.places.size() == positions.size() && style.palette.size() >= 2));
    const Scene scene = sceneOf(positions, triangles, camera, width, height, style.places);
    const int bandCount = (height + BandHeight - 1) / BandHeight;
    const auto bins = trianglesOfBands(scene.triangles(), bandCount);
    Picture picture{width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 4)};
    parallelFor(std::size_t(bandCount), [&](std::size_t index) {
        if (progress.isCancelled())
            return;
        const int firstRow = int(index) * BandHeight;
        Band band(scene.triangles(), width, firstRow, std::min(BandHeight, height - firstRow));
        for (const std::uint32_t triangle : bins[index])
            band.cover(triangle);
        band.resolve(style, height, picture.rgba.data() + std::size_t(firstRow) * std::size_t(width) * 4);
    });
    return picture;
}

} // namespace model
