// SPDX-License-Identifier: GPL-3.0-or-later
// What JavaScript calls (app/web/player/decoder.ts). An instance of the module opens one file: what a hostile one does
// to it ends with it, and its memory goes back as a whole. Numbers above 32 bits go as double; arrays as the address
// and the number of values of the array that was asked for last.
#include "app/web/decoder/errornames.h"
#include "app/web/decoder/outofmemory.h"
#include "app/web/decoder/texturelayout.h"
#include "model/codec/container/progressivereader.h"

#include <algorithm>
#include <new>
#include <optional>

#define WEB_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace {

using model::Error;
using model::Vec3f;
using model::codec::DecodedAnimation;
using model::codec::ProductAnimation;
using model::codec::ProgressiveReader;

struct Opened
{
    ProgressiveReader reader;
    model::Bytes input;
    std::shared_ptr<const DecodedAnimation> shown;
    std::optional<Error> error;
    Vec3f centre; ///< positions are given relative to it, so that floats on the GPU are exact far from the origin too
    bool hasCentre = false;
    std::string text;
    // What array() gives.
    std::vector<float> floats;
    std::vector<std::uint32_t> integers;
    std::vector<std::uint32_t> corners; ///< between cornerRanges() and corners()
    const void *array = nullptr;
    std::size_t arrayLength = 0;
};

Opened &opened()
{
    static Opened file;
    return file;
}

bool isLinear(const ProgressiveReader &reader)
{
    return reader.header()->codec != std::uint8_t(model::CodecId::Direct);
}

const ProductAnimation &product()
{
    return static_cast<const ProductAnimation &>(*opened().shown);
}

void give(std::vector<float> values)
{
    Opened &file = opened();
    file.floats = std::move(values);
    file.array = file.floats.data();
    file.arrayLength = file.floats.size();
}

void give(std::vector<std::uint32_t> values)
{
    Opened &file = opened();
    file.integers = std::move(values);
    file.array = file.integers.data();
    file.arrayLength = file.integers.size();
}

const char *give(std::string text)
{
    opened().text = std::move(text);
    return opened().text.c_str();
}

void grow(model::Box3f &box, std::uint32_t frame)
{
    for (const Vec3f &position : opened().shown->frame(frame))
        box.add(position);
}

} // namespace

/// Once, before anything else.
WEB_EXPORT(start) void start()
{
    std::set_new_handler(web::outOfMemory);
}

/// Where the next bytes of the file go.
WEB_EXPORT(input) std::uint8_t *input(std::uint32_t size)
{
    opened().input.resize(size);
    return opened().input.data();
}

/// Takes those bytes. \returns whether they were good; if not, the error functions tell.
WEB_EXPORT(append) bool append()
{
    Opened &file = opened();
    const auto appended = file.reader.append(file.input);
    if (!appended)
        file.error = appended.error();
    return appended.has_value();
}

/// The file has ended. \returns whether it is whole
WEB_EXPORT(finish) bool finish()
{
    Opened &file = opened();
    if (!file.error && !file.reader.isComplete())
        file.error = Error{model::ErrorCode::Truncated,
                           {std::to_string(file.reader.leastBytes()), std::to_string(file.reader.bytesRead())},
                           {},
                           Error::None,
                           file.reader.bytesRead()};
    return !file.error;
}

/// Decodes what opening has left for later. \returns whether it was good
WEB_EXPORT(check) bool check()
{
    Opened &file = opened();
    if (const auto checked = file.shown->check(model::Progress()); !checked)
        file.error = checked.error();
    return !file.error;
}

WEB_EXPORT(errorName) const char *errorName()
{
    return opened().error ? web::nameOf(opened().error->code) : "";
}

WEB_EXPORT(errorArgumentCount) std::uint32_t errorArgumentCount()
{
    return opened().error ? std::uint32_t(opened().error->args.size()) : 0;
}

WEB_EXPORT(errorArgument) const char *errorArgument(std::uint32_t index)
{
    return opened().error->args[index].c_str();
}

/// The byte of the file at fault, -1 if there is none.
WEB_EXPORT(errorOffset) double errorOffset()
{
    return opened().error && opened().error->offset != Error::None ? double(opened().error->offset) : -1;
}

WEB_EXPORT(hasHeader) bool hasHeader()
{
    return opened().reader.header() != nullptr;
}

// Those that follow once there is a header.

WEB_EXPORT(codec) std::uint32_t codec()
{
    return opened().reader.header()->codec;
}

WEB_EXPORT(vertexCount) std::uint32_t vertexCount()
{
    return opened().reader.header()->vertexCount;
}

WEB_EXPORT(triangleCount) std::uint32_t triangleCount()
{
    return opened().reader.header()->triangleCount;
}

WEB_EXPORT(frameCount) std::uint32_t frameCount()
{
    return opened().reader.header()->frameCount;
}

WEB_EXPORT(frameRate) double frameRate()
{
    return opened().reader.header()->frameRate;
}

WEB_EXPORT(animationName) const char *animationName()
{
    return give(opened().reader.header()->name);
}

/// Whether frames are sums of trajectories, so that the GPU can compute them.
WEB_EXPORT(linear) bool linear()
{
    return isLinear(opened().reader);
}

WEB_EXPORT(bytesRead) double bytesRead()
{
    return double(opened().reader.bytesRead());
}

WEB_EXPORT(bandCount) std::uint32_t bandCount()
{
    return opened().reader.bandCount();
}

WEB_EXPORT(bandsInFile) std::uint32_t bandsInFile()
{
    return opened().reader.bandsInFile();
}

WEB_EXPORT(playable) bool playable()
{
    return opened().reader.isPlayable();
}

/// Makes what is there of the animation be what the functions below tell of. Precondition: playable()
WEB_EXPORT(show) void show()
{
    Opened &file = opened();
    file.shown = file.reader.animation();
    if (file.hasCentre)
        return;
    model::Box3f box;
    grow(box, 0);
    file.centre = box.center();
    file.hasCentre = true;
}

/// Whether vertices have the order that they will have: it may come after the first picture.
WEB_EXPORT(keepsOrder) bool keepsOrder()
{
    return opened().shown->settings().keepOrder;
}

WEB_EXPORT(rank) std::uint32_t rank()
{
    return product().rank();
}

WEB_EXPORT(layerCount) std::uint32_t layerCount()
{
    return web::layerCount(product().rank());
}

// Arrays: each of these makes one, array() and arrayLength() say where it is.

WEB_EXPORT(array) const void *array()
{
    return opened().array;
}

WEB_EXPORT(arrayLength) std::size_t arrayLength()
{
    return opened().arrayLength;
}

WEB_EXPORT(coefficients) void coefficients(std::uint32_t layer)
{
    give(web::coefficientLayer(product(), layer));
}

WEB_EXPORT(basis) void basis()
{
    give(web::basisRows(product(), opened().centre));
}

WEB_EXPORT(frame) void frame(std::uint32_t index)
{
    give(web::frameTexels(*opened().shown, index, opened().centre));
}

/// 3 T indices.
WEB_EXPORT(triangles) void triangles()
{
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * opened().shown->connectivity().triangles.size());
    for (const model::Triangle &triangle : opened().shown->connectivity().triangles)
        indices.insert(indices.end(), triangle.begin(), triangle.end());
    give(std::move(indices));
}

/// 2 E indices.
WEB_EXPORT(edges) void edges()
{
    give(web::edgesOf(opened().shown->connectivity()));
}

/// Makes two arrays: this one, and the one that corners() gives after it.
WEB_EXPORT(cornerRanges) void cornerRanges()
{
    web::VertexCorners corners = web::cornersOf(opened().shown->connectivity());
    opened().corners = std::move(corners.others);
    give(std::move(corners.ranges));
}

WEB_EXPORT(corners) void corners()
{
    give(std::move(opened().corners));
}

/// The centre, then the least and the greatest corner, of a box around `count` frames spread over all; absolute.
WEB_EXPORT(bounds) void bounds(std::uint32_t count)
{
    const Opened &file = opened();
    model::Box3f box;
    const std::uint32_t frames = file.shown->frameCount();
    const std::uint32_t sampled = std::clamp(count, 1u, frames);
    for (std::uint32_t i = 0; i < sampled; ++i)
        grow(box, sampled == 1 ? 0 : std::uint32_t(std::uint64_t(i) * (frames - 1) / (sampled - 1)));
    const Vec3f &c = file.centre, least = box.min, most = box.max;
    give(std::vector<float>{c.x, c.y, c.z, least.x, least.y, least.z, most.x, most.y, most.z});
}
