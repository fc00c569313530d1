// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/pointcache.h"

#include "model/base/bytes.h"
#include "model/io/animationreader.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"
#include "model/io/meshfile.h"
#include "model/io/positionmemory.h"
#include "model/io/rawpositions.h"

#include <algorithm>
#include <cmath>

#include <QDir>
#include <QFileInfo>
#include <QStringList>

namespace model::io {

namespace {

/// What a point cache says before its positions.
struct CacheHeader
{
    std::uint64_t vertexCount = 0;
    std::uint64_t frameCount = 0;
    std::uint64_t positionsBegin = 0; ///< byte in the file
    double frameRate = 0;             ///< 0: not said
    std::endian order = std::endian::little;
};

/// Checks the counts against the size of the file, before anything is allocated for them.
Result<void> checkCounts(const CacheHeader &header, std::uint64_t vertexOffset, std::uint64_t frameOffset,
                         std::uint64_t bytesPerFrame, std::uint64_t fileSize)
{
    constexpr std::uint64_t MaxCount = 0x7FFFFFFF; // both formats have signed numbers
    const auto check = [](const char *what, std::uint64_t count, std::uint64_t offset) -> Result<void> {
        if (count >= 1 && count <= MaxCount)
            return {};
        return failAtByte(offset, ErrorCode::BadValue, what, std::to_string(count), "1.." + std::to_string(MaxCount));
    };
    if (auto checked =
            check(QT_TRANSLATE_NOOP("ErrorText", "the number of vertices"), header.vertexCount, vertexOffset);
        !checked)
        return checked;
    if (auto checked = check(QT_TRANSLATE_NOOP("ErrorText", "the number of frames"), header.frameCount, frameOffset);
        !checked)
        return checked;
    const std::uint64_t frameBytes = bytesPerFrame + header.vertexCount * sizeof(Vec3f); // below 2^35
    const std::uint64_t there = fileSize - std::min(fileSize, header.positionsBegin);
    if (header.frameCount > there / frameBytes) {
        constexpr std::uint64_t Huge = ~std::uint64_t(0) / 2; // stands for a product that does not fit
        const std::uint64_t wanted = header.frameCount > Huge / frameBytes ? Huge : header.frameCount * frameBytes;
        return failAtByte(fileSize, ErrorCode::Truncated, std::to_string(header.positionsBegin + wanted),
                          std::to_string(fileSize));
    }
    if (const std::uint64_t needed = header.frameCount * frameBytes; there > needed)
        return failAtByte(header.positionsBegin + needed, ErrorCode::TrailingBytes, std::to_string(there - needed));
    return {};
}

/// The first `size` bytes; \error Truncated and those of readInto
Result<Bytes> readStart(QFile &file, std::uint64_t size, const Progress &progress)
{
    Bytes bytes(size);
    const auto got = readInto(file, reinterpret_cast<char *>(bytes.data()), size, progress);
    if (!got)
        return fail(got.error());
    if (*got < size)
        return failAtByte(*got, ErrorCode::Truncated, std::to_string(size), std::to_string(*got));
    return bytes;
}

Result<CacheHeader> readPc2Header(QFile &file, const Progress &progress)
{
    constexpr std::string_view Magic("POINTCACHE2\0", 12);
    constexpr std::uint64_t Size = 32;
    const Result<Bytes> bytes = readStart(file, Size, progress);
    if (!bytes)
        return fail(bytes.error());
    ByteReader reader(*bytes);
    const auto magic = reader.bytes(Magic.size());
    if (!std::equal(magic.begin(), magic.end(), Magic.begin()))
        return failAtByte(0, ErrorCode::BadMagic, "PC2");
    if (const std::uint32_t version = reader.u32(); version != 1)
        return failAtByte(Magic.size(), ErrorCode::UnsupportedVersion, std::to_string(version), "1");
    CacheHeader header;
    const std::uint64_t vertexOffset = reader.offset();
    header.vertexCount = reader.u32();
    reader.f32(); // first frame
    reader.f32(); // frames from one sample to the next
    const std::uint64_t frameOffset = reader.offset();
    header.frameCount = reader.u32();
    header.positionsBegin = Size;
    if (auto checked = checkCounts(header, vertexOffset, frameOffset, 0, std::uint64_t(file.size())); !checked)
        return fail(std::move(checked.error()));
    return header;
}

std::uint32_t bigEndianU32(const std::uint8_t *p)
{
    return std::uint32_t(p[0]) << 24 | std::uint32_t(p[1]) << 16 | std::uint32_t(p[2]) << 8 | p[3];
}

/// Frames per second of equally spaced times, 0 if they are of no use. Times are 32-bit floats, so a rate that is
/// within their precision of a thousandth (23.976, 30) is meant to be that.
double rateOf(std::span<const float> times)
{
    constexpr double Precision = 1e-5;
    const double duration = double(times.back()) - double(times.front());
    if (!std::isfinite(duration) || duration <= 0)
        return 0;
    const double rate = double(times.size() - 1) / duration;
    const double rounded = std::round(rate * 1000) / 1000;
    return std::abs(rounded - rate) < Precision * rate ? rounded : rate;
}

Result<CacheHeader> readMddHeader(QFile &file, const Progress &progress)
{
    constexpr std::uint64_t CountBytes = 8, TimeBytes = 4;
    const Result<Bytes> counts = readStart(file, CountBytes, progress);
    if (!counts)
        return fail(counts.error());
    CacheHeader header;
    header.frameCount = bigEndianU32(counts->data());
    header.vertexCount = bigEndianU32(counts->data() + 4);
    header.positionsBegin = CountBytes;
    header.order = std::endian::big;
    if (auto checked = checkCounts(header, 4, 0, TimeBytes, std::uint64_t(file.size())); !checked)
        return fail(std::move(checked.error()));
    header.positionsBegin += header.frameCount * TimeBytes;

    const Result<Bytes> bytes = readStart(file, header.frameCount * TimeBytes, progress);
    if (!bytes)
        return fail(bytes.error());
    std::vector<float> times(header.frameCount);
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] = std::bit_cast<float>(bigEndianU32(bytes->data() + 4 * i));
    header.frameRate = rateOf(times);
    return header;
}

Result<std::vector<Vec3f>> readPositions(QFile &file, const CacheHeader &header, const Progress &progress)
{
    Result<std::vector<Vec3f>> positions = positionMemory(header.vertexCount, header.frameCount);
    if (!positions)
        return positions;
    for (std::uint64_t frame = 0; frame < header.frameCount; ++frame) {
        const std::span<Vec3f> now = std::span(*positions).subspan(frame * header.vertexCount, header.vertexCount);
        const auto got = readInto(file, reinterpret_cast<char *>(now.data()), now.size_bytes(), progress);
        if (!got)
            return fail(got.error());
        const std::uint64_t begin = header.positionsBegin + frame * now.size_bytes();
        if (*got < now.size_bytes()) // it has become shorter since its size was asked for
            return failAtByte(begin + *got, ErrorCode::Truncated, std::to_string(now.size_bytes()),
                              std::to_string(*got));
        swapBytesUnlessNative(now, header.order);
        if (const auto bad = std::find_if_not(now.begin(), now.end(), isFinite); bad != now.end())
            return failAtByte(begin + std::uint64_t(bad - now.begin()) * sizeof(Vec3f), ErrorCode::NonFinite,
                              "vertex " + std::to_string(bad - now.begin()));
        progress.report(double(frame + 1) / double(header.frameCount));
    }
    return positions;
}

/// The mesh of the same stem beside the cache; empty if there is none.
QString meshBeside(const QString &cache)
{
    const QFileInfo info(cache);
    for (const QString &ending : meshEndings())
        for (const QString &spelling : {ending, ending.toUpper()})
            if (const QString path = info.dir().filePath(info.completeBaseName() + QLatin1Char('.') + spelling);
                QFileInfo(path).isFile())
                return path;
    return {};
}

} // namespace

QStringList pointCacheEndings()
{
    return {QStringLiteral("pc2"), QStringLiteral("mdd")};
}

Result<std::shared_ptr<const Sequence>> readPointCache(const QString &path, const QString &baseMesh, double frameRate,
                                                       std::string name, const Progress &progress)
{
    QFile file(path);
    if (const auto opened = openFile(file); !opened)
        return fail(opened.error());
    const bool isPc2 = QFileInfo(path).suffix().toLower() == pointCacheEndings().front();
    const Result<CacheHeader> header = isPc2 ? readPc2Header(file, progress) : readMddHeader(file, progress);
    if (!header)
        return failIn(path, header.error());

    const QString meshPath = baseMesh.isEmpty() ? meshBeside(path) : baseMesh;
    if (meshPath.isEmpty())
        return failIn(path, ErrorCode::MissingBaseMesh);
    Result<TriangleMesh> mesh = readMesh(meshPath);
    if (!mesh)
        return fail(std::move(mesh.error()));
    if (mesh->connectivity.vertexCount != header->vertexCount)
        return failIn(path, ErrorCode::VertexCountDiffers, std::to_string(header->vertexCount),
                      std::to_string(mesh->connectivity.vertexCount), meshPath.toStdString());

    Result<std::vector<Vec3f>> positions = readPositions(file, *header, progress);
    if (!positions)
        return failIn(path, std::move(positions.error()));
    constexpr double DefaultFrameRate = 25;
    const double rate = frameRate > 0 ? frameRate : header->frameRate > 0 ? header->frameRate : DefaultFrameRate;
    return std::make_shared<const Sequence>(std::move(mesh->connectivity), std::move(*positions), rate,
                                            std::move(name));
}

} // namespace model::io
