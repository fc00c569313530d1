// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/plain/plainreel.h"

#include "tests/model/codec/plain/plainconnectivity.h"
#include "tests/model/codec/plain/plainshape.h"

#include <cmath>

namespace tests {

namespace {

using namespace plain;
// 13.1
double eighths(std::int64_t n)
{
    return std::pow(2.0L, (long double)n / 8);
}

float f32(Cursor &in)
{
    const std::uint32_t raw = std::uint32_t(in.fixed(4));
    float result;
    std::memcpy(&result, &raw, 4);
    return result;
}

void decode(const Data &file, PlainReel &anim)
{
    std::map<std::string, Data> chunks = chunksOf(file);
    const Head head = headOf(chunks.at("HEAD"), 4);
    const std::size_t vertices = anim.vertices = head.vertices, frames = anim.frames = head.frames;
    Cursor parameters{chunks.at("REEL")};
    parameters.f64();
    parameters.varuint();
    const double D = parameters.f64();
    const double shapeStep = D * (parameters.u8() + 1) / 32;
    const double meanStep = D * eighths(-std::int64_t(parameters.u8()));
    Place origin;
    for (double &x : origin)
        x = double(f32(parameters));
    const auto ratio = [&] { return (parameters.u8() + 1) / 256.0; };
    const double shapeRatio = ratio(), frameRatio = ratio(), vertexRatio = ratio();
    const std::uint64_t rank = anim.rank = parameters.varuint();

    const PlainConnectivity mesh = decodeConnectivityPlainly(chunks.at("CLRS"), head.vertices, head.triangles);
    anim.triangles = mesh.triangles;
    const auto nodes = vertexNodes(mesh.triangles, vertices);
    const auto times = frameNodes(frames);
    std::vector<Place> framePlaces;
    for (const Node &node : times)
        framePlaces.push_back({double(node.vertex), 0, 0});

    Range shapeIn(chunks.at("SHAP"));
    const std::vector<Place> places = Shape(nodes, shapeRatio).decode(shapeIn);
    Residuals meanResiduals{6, 20};
    Bands meanBands(times, framePlaces, stepsOf(times, frameRatio), 3, meanResiduals);
    std::vector<Place> means(frames);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto &values = meanBands.next(shapeIn);
        for (std::size_t i = 0; i < frames; ++i)
            means[times[i].vertex][axis] = origin[axis] + values[i] * meanStep;
    }
    shapeIn.end();

    anim.positions.assign(frames, std::vector<Place>(vertices));
    std::vector<std::vector<Place>> sizes(frames, std::vector<Place>(vertices));
    for (std::size_t f = 0; f < frames; ++f)
        for (std::size_t i = 0; i < vertices; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double rest = places[i][axis] * shapeStep / std::sqrt(double(frames));
                anim.positions[f][nodes[i].vertex][axis] = means[f][axis] + rest;
                sizes[f][nodes[i].vertex][axis] = std::fabs(means[f][axis]) + std::fabs(rest);
            }
    anim.step = std::max(shapeStep, meanStep);

    // 13.7
    std::vector<std::vector<std::size_t>> clusters(1);
    for (std::size_t i = 0; i < vertices; ++i)
        clusters[0].push_back(i);
    if (chunks.contains("PART")) {
        Range in(chunks.at("PART"));
        const std::uint64_t count = 1 + in.direct(6);
        Labels labels(count);
        std::vector<std::uint64_t> ofComponent;
        const auto components = componentsOf(nodes);
        clusters.assign(count, {});
        for (std::size_t i = 0; i < vertices; ++i)
            if (components[i] == ofComponent.size())
                ofComponent.push_back(labels.decode(in));
        for (std::size_t i = 0; i < vertices; ++i)
            clusters[ofComponent[components[i]]].push_back(i);
        in.end();
    }
    Range bandIn(chunks.at("BAND"));
    Residuals frameResiduals{6, 20}, vertexResiduals{6, 20};
    Bands frameBands(times, framePlaces, stepsOf(times, frameRatio), 3, frameResiduals);
    std::vector<Bands> vertexBands;
    for (const auto &members : clusters) {
        std::vector<Place> own;
        for (const std::size_t node : members)
            own.push_back(places[node]);
        vertexBands.emplace_back(only(nodes, members), own, stepsOf(nodes, vertexRatio), 0.5, vertexResiduals);
    }
    Labels labels(clusters.size());
    Integers exponents(5);
    std::int64_t e = 0;
    for (std::uint64_t k = 0; k < rank; ++k) {
        const std::uint64_t cluster = labels.decode(bandIn);
        e += exponents.decode(bandIn, k == 0 ? 0 : 1, 0);
        e = std::min<std::int64_t>(std::max<std::int64_t>(e, -4000), 4000);
        std::vector<Place> trajectory(frames);
        double largest = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto &values = frameBands.next(bandIn);
            for (std::size_t i = 0; i < frames; ++i) {
                trajectory[times[i].vertex][axis] = values[i] * eighths(e);
                largest = std::max(largest, std::fabs(values[i] * eighths(e)));
            }
        }
        anim.step = std::max(anim.step, largest * D);
        const auto &values = vertexBands[cluster].next(bandIn);
        for (std::size_t f = 0; f < frames; ++f)
            for (std::size_t i = 0; i < values.size(); ++i)
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double part = trajectory[f][axis] * values[i] * D;
                    const std::size_t vertex = nodes[clusters[cluster][i]].vertex;
                    anim.positions[f][vertex][axis] += part;
                    sizes[f][vertex][axis] += std::fabs(part);
                }
    }
    bandIn.end();
    for (const auto &frame : sizes)
        for (const Place &place : frame)
            anim.size = std::max({anim.size, place[0], place[1], place[2]});
    if (!chunks.contains("ORDR"))
        return;
    const auto order = decodeOrderPlainly(chunks.at("ORDR"), mesh.neighbours);
    for (auto &triangle : anim.triangles)
        for (std::int64_t &v : triangle)
            v = order[std::size_t(v)];
    for (auto &frame : anim.positions) {
        const auto coded = frame;
        for (std::size_t v = 0; v < vertices; ++v)
            frame[std::size_t(order[v])] = coded[v];
    }
}

} // namespace

PlainReel decodeReelPlainly(const std::vector<std::uint8_t> &file)
{
    return decodedOrError(file, &decode);
}

} // namespace tests
