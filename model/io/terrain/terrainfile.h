// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"
#include "model/base/progress.h"
#include "model/terrain/terrain.h"

#include <QJsonObject>
#include <QString>

namespace model::io {

/// Version of the `.terrain` format that we write, and the newest that we read. FORMAT.md has the same.
inline constexpr int TerrainFormatMajor = 1, TerrainFormatMinor = 0;

/// Part of a file that this program does not know, kept as it is.
struct ForeignEntry
{
    std::string name; ///< UTF-8
    Bytes bytes;

    friend bool operator==(const ForeignEntry &, const ForeignEntry &) = default;
};

/// What a `.terrain` file holds beside the terrain.
struct TerrainExtras
{
    terrain::Point2 step; ///< of the raster that the terrain was made of; 0 if of none
    QJsonObject tools;    ///< the state of the tools, for whoever knows them
    Bytes thumbnail;      ///< a PNG of at most 256 x 256 pixels; empty: none
    QJsonObject manifest; ///< keys that this program does not know
    std::vector<ForeignEntry> others;
};

struct TerrainFile
{
    terrain::Terrain terrain;
    TerrainExtras extras;
    /// The file is of a newer minor version: something that the program does not know may be lost in it on a save.
    bool isNewer = false;
};

/// The bytes of a `.terrain` file. model/io/terrain/FORMAT.md. Lossless: coordinates, heights, layers and the ledger
/// come back to the bit. The same terrain gives the same bytes. \param fileIds  if wanted: the vertex of the file that
/// each slot of the TIN became \error Cancelled
Result<Bytes> formatTerrain(const terrain::Terrain &terrain, const TerrainExtras &extras,
                            std::vector<terrain::VertexId> *fileIds = nullptr, const Progress &progress = Progress());

/// \param memoryLimit  bytes that reading may take: of every entry together, and of the terrain
/// \error BadMagic, UnsupportedVersion, UnsupportedFeature, MissingChunk, DuplicateChunk, ChecksumMismatch, BadValue,
///        Truncated, CorruptStream, TrailingBytes, SyntaxError, BrokenTerrain, BadSetting (a material), LimitExceeded,
///        OutOfMemory, Cancelled
Result<TerrainFile> parseTerrain(std::span<const std::uint8_t> bytes, std::uint64_t memoryLimit,
                                 const Progress &progress = Progress());

/// Through a SaveFile: the old file or the new one, never neither. \error as formatTerrain; CannotOpen, CannotWrite
Result<void> saveTerrain(const QString &path, const terrain::Terrain &terrain, const TerrainExtras &extras,
                         const Progress &progress = Progress());

/// A file that somebody chose may take half of the machine's memory.
/// \error as parseTerrain; NotFound, CannotOpen, CannotRead
Result<TerrainFile> openTerrain(const QString &path, const Progress &progress = Progress());

} // namespace model::io
