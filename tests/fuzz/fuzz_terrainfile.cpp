// SPDX-License-Identifier: GPL-3.0-or-later
// The container, and its surface alone: the input is taken as a whole `.terrain` file, as the bytes of
// `terrain/surface`, and as the tail of a recovery journal.
#include "model/io/terrain/recovery.h"
#include "model/io/terrain/terrainfile.h"
#include "model/io/terrain/tiles/tilecodec.h"
#include "model/io/terrain/zipfile.h"
#include "model/terrain/tin/build/restoretin.h"
#include "model/terrain/tin/validate.h"
#include "tests/fuzz/require.h"
#include "tests/support/scarcity.h"

#include <zlib.h>

using namespace model;
using namespace model::io;

namespace {

constexpr std::uint64_t Limit = std::uint64_t(64) << 20;

void checkSurface(std::span<const std::uint8_t> bytes)
{
    tests::AllocationMeter meter;
    auto surface = decodeSurface(bytes, Limit);
    SANDREEL_REQUIRE(meter.peak() <= 8 * Limit);
    if (!surface)
        return;
    const auto tin = terrain::restoreTin(std::move(surface->arrays), surface->domain, {});
    if (!tin)
        return;
    SANDREEL_REQUIRE(terrain::findDefects(*tin).empty());
    // What is sound is written again, and is the same.
    const auto again = encodeSurface(tin->arrays(), tin->domain(), {});
    SANDREEL_REQUIRE(again.has_value());
    SANDREEL_REQUIRE(decodeSurface(*again, 2 * Limit).has_value());
}

void checkFile(std::span<const std::uint8_t> bytes)
{
    const auto file = parseTerrain(bytes, Limit);
    if (!file)
        return;
    SANDREEL_REQUIRE(validate(file->terrain).has_value());
    const auto again = formatTerrain(file->terrain, file->extras);
    SANDREEL_REQUIRE(again.has_value());
    const auto reread = parseTerrain(*again, 4 * Limit);
    SANDREEL_REQUIRE(reread.has_value());
    SANDREEL_REQUIRE(reread->terrain.tin.vertexCount() == file->terrain.tin.vertexCount());
}

/// A journal whose one frame is the input, with its checksum.
void checkJournal(std::span<const std::uint8_t> bytes)
{
    static const Bytes saved = *formatTerrain(terrain::Terrain(terrain::Tin({{0, 0}, {8, 8}})), {});
    const auto crc = [](std::span<const std::uint8_t> b) {
        return std::uint32_t(crc32_z(crc32(0, nullptr, 0), b.data(), b.size()));
    };
    ByteWriter journal;
    const auto frame = [&](std::span<const std::uint8_t> body) {
        journal.u32(std::uint32_t(body.size()));
        journal.u32(crc(body));
        journal.bytes(body);
    };
    const std::string base = '\0' + ("{\"path\":\"\",\"crc32\":" + std::to_string(crc(saved)) +
                                     ",\"bytes\":" + std::to_string(saved.size()) + "}");
    const std::uint8_t magic[] = {'S', 'R', 'J', 'O', 'U', 'R', 'N', 1};
    journal.bytes(magic);
    frame({reinterpret_cast<const std::uint8_t *>(base.data()), base.size()});
    frame(bytes);
    const auto recovered = replayJournal(journal.data(), saved, Limit);
    if (recovered)
        SANDREEL_REQUIRE(terrain::findDefects(recovered->terrain.tin).empty());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size < 1)
        return 0;
    const std::span<const std::uint8_t> rest(data + 1, size - 1);
    switch (data[0] % 3) {
    case 0:
        checkFile(rest);
        break;
    case 1:
        checkSurface(rest);
        break;
    default:
        checkJournal(rest);
    }
    return 0;
}
