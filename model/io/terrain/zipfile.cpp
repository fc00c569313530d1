// SPDX-License-Identifier: GPL-3.0-or-later
// libzip stops at this file.
#include "model/io/terrain/zipfile.h"

#include <algorithm>
#include <memory>

#include <QCoreApplication>
#include <zip.h>

namespace model::io {

namespace {

constexpr std::uint64_t MaxEntries = 4096;
constexpr std::size_t MaxNameLength = 255;
/// Deflate makes nothing smaller than this.
constexpr std::uint64_t LargestRatio = 1032;

struct Discard
{
    void operator()(zip_t *zip) const { zip_discard(zip); }
};
struct CloseEntry
{
    void operator()(zip_file_t *file) const { zip_fclose(file); }
};
struct FreeSource
{
    void operator()(zip_source_t *source) const { zip_source_free(source); }
};
using ZipPtr = std::unique_ptr<zip_t, Discard>;
using EntryPtr = std::unique_ptr<zip_file_t, CloseEntry>;
using SourcePtr = std::unique_ptr<zip_source_t, FreeSource>;

tl::unexpected<Error> failWriting(zip_error_t *error)
{
    return fail(ErrorCode::ImporterFailed, zip_error_strerror(error));
}

/// Relative, with no way out of the folder that somebody unpacks it in.
bool isSafeName(std::string_view name)
{
    if (name.empty() || name.size() > MaxNameLength || name.front() == '/' || name.find('\\') != name.npos ||
        name.find(':') != name.npos)
        return false;
    if (std::any_of(name.begin(), name.end(), [](char c) { return std::uint8_t(c) < 0x20 || c == 0x7f; }))
        return false;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        const std::string_view part = name.substr(begin, end - begin);
        if (part == "." || part == ".." || (part.empty() && end != name.size()))
            return false;
        begin = end + 1;
    }
    return true;
}

struct Listed
{
    zip_uint64_t index;
    std::string name;
    std::uint64_t size;
};

Result<std::vector<Listed>> list(zip_t *zip, std::uint64_t memoryLimit)
{
    const zip_int64_t count = zip_get_num_entries(zip, 0);
    if (count < 0 || std::uint64_t(count) > MaxEntries)
        return fail(ErrorCode::LimitExceeded, QT_TRANSLATE_NOOP("ErrorText", "number of parts"), std::to_string(count),
                    std::to_string(MaxEntries));
    std::vector<Listed> entries;
    std::uint64_t total = 0;
    for (zip_uint64_t i = 0; i < zip_uint64_t(count); ++i) {
        zip_stat_t stat;
        if (zip_stat_index(zip, i, ZIP_FL_ENC_RAW, &stat) != 0 || !(stat.valid & ZIP_STAT_NAME) ||
            !(stat.valid & ZIP_STAT_SIZE) || !(stat.valid & ZIP_STAT_COMP_SIZE))
            return fail(ErrorCode::CorruptStream, "ZIP");
        const std::string name = stat.name;
        if (!isSafeName(name))
            return fail(ErrorCode::BadValue, QT_TRANSLATE_NOOP("ErrorText", "name of a part"), name,
                        QT_TRANSLATE_NOOP("ErrorText", "a relative path"));
        if (name.back() == '/')
            continue;
        if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) && stat.encryption_method != ZIP_EM_NONE)
            return fail(ErrorCode::UnsupportedFeature, QT_TRANSLATE_NOOP("ErrorText", "encryption"));
        if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE)
            return fail(ErrorCode::UnsupportedFeature,
                        QT_TRANSLATE_NOOP("ErrorText", "another compression of its parts"));
        if (stat.size / LargestRatio > stat.comp_size)
            return fail(ErrorCode::BadValue, QT_TRANSLATE_NOOP("ErrorText", "unpacked size"), std::to_string(stat.size),
                        QT_TRANSLATE_NOOP("ErrorText", "at most the bytes left"));
        if (stat.size > memoryLimit - std::min(total, memoryLimit))
            return fail(ErrorCode::LimitExceeded, QT_TRANSLATE_NOOP("ErrorText", "memory"),
                        std::to_string(total + stat.size), std::to_string(memoryLimit));
        total += stat.size;
        entries.push_back({i, name, stat.size});
    }
    return entries;
}

} // namespace

Result<Bytes> writeZip(const std::vector<ZipEntry> &entries)
{
    zip_error_t error;
    zip_error_init(&error);
    SourcePtr memory(zip_source_buffer_create(nullptr, 0, 0, &error));
    if (!memory)
        return failWriting(&error);
    ZipPtr zip(zip_open_from_source(memory.get(), ZIP_CREATE | ZIP_TRUNCATE, &error));
    if (!zip)
        return failWriting(&error);
    zip_source_keep(memory.get());
    for (const ZipEntry &entry : entries) {
        zip_source_t *const source = zip_source_buffer(zip.get(), entry.bytes.data(), entry.bytes.size(), 0);
        const zip_int64_t index =
            source ? zip_file_add(zip.get(), entry.name.c_str(), source, ZIP_FL_ENC_UTF_8) : zip_int64_t(-1);
        if (index < 0) {
            zip_source_free(source);
            return failWriting(zip_get_error(zip.get()));
        }
        constexpr zip_uint16_t FirstDay = 1 << 5 | 1; // 1 January 1980
        if (zip_set_file_compression(zip.get(), zip_uint64_t(index), entry.isPacked ? ZIP_CM_DEFLATE : ZIP_CM_STORE,
                                     entry.isPacked ? 6 : 0) != 0 ||
            zip_file_set_dostime(zip.get(), zip_uint64_t(index), 0, FirstDay, 0) != 0)
            return failWriting(zip_get_error(zip.get()));
    }
    if (zip_close(zip.get()) != 0)
        return failWriting(zip_get_error(zip.get()));
    (void)zip.release();
    zip_stat_t stat;
    if (zip_source_stat(memory.get(), &stat) != 0 || zip_source_open(memory.get()) != 0)
        return failWriting(zip_source_error(memory.get()));
    Bytes bytes(std::size_t(stat.size));
    const zip_int64_t got = zip_source_read(memory.get(), bytes.data(), bytes.size());
    zip_source_close(memory.get());
    if (got != zip_int64_t(bytes.size()))
        return failWriting(zip_source_error(memory.get()));
    return bytes;
}

Result<std::vector<ZipEntry>> readZip(std::span<const std::uint8_t> bytes, std::uint64_t memoryLimit)
{
    constexpr std::uint8_t Magic[] = {'P', 'K', 3, 4};
    if (bytes.size() < sizeof Magic || !std::equal(Magic, Magic + sizeof Magic, bytes.begin()))
        return fail(ErrorCode::BadMagic, ".terrain");
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t *const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    // With its checks libzip refuses two entries of one name, too.
    const ZipPtr zip(source ? zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error) : nullptr);
    if (!zip) {
        zip_source_free(source);
        return fail(ErrorCode::CorruptStream, "ZIP");
    }
    const auto listed = list(zip.get(), memoryLimit);
    if (!listed)
        return fail(listed.error());
    std::vector<ZipEntry> entries;
    for (const Listed &item : *listed) {
        ZipEntry entry{item.name, Bytes(std::size_t(item.size)), false};
        const EntryPtr file(zip_fopen_index(zip.get(), item.index, 0));
        if (!file)
            return fail(ErrorCode::CorruptStream, "ZIP");
        // The checksum is looked at where the entry ends, by the read after the last byte.
        std::uint8_t beyond = 0;
        const bool isWhole = entry.bytes.empty() || zip_fread(file.get(), entry.bytes.data(), entry.bytes.size()) ==
                                                        zip_int64_t(entry.bytes.size());
        if (!isWhole || zip_fread(file.get(), &beyond, 1) != 0)
            return fail(ErrorCode::ChecksumMismatch, item.name);
        entries.push_back(std::move(entry));
    }
    return entries;
}

} // namespace model::io
