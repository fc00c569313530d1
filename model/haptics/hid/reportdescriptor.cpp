// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/hid/reportdescriptor.h"

#include <algorithm>
#include <array>
#include <string>

namespace model::haptics {

namespace {

constexpr std::size_t LargestDescriptor = 4096, LargestFieldCount = 1024, LargestUsageCount = 1024, LargestDepth = 32;
constexpr std::uint32_t LargestReport = 65536; ///< bits

enum class ItemType : std::uint8_t { Main, Global, Local, Reserved };
constexpr std::uint8_t LongItem = 0xfe;

/// What Push keeps.
struct Globals
{
    std::uint32_t page = 0, bitSize = 0, count = 0;
    std::int32_t least = 0, most = 0;
    std::uint32_t mostUnsigned = 0;
    std::uint8_t reportId = 0;
};

struct Locals
{
    std::vector<HidUsage> usages;
    std::uint32_t usageLeast = 0;
};

class Parser
{
public:
    explicit Parser(std::span<const std::uint8_t> bytes)
        : mBytes(bytes)
    {}

    Result<std::vector<HidField>> run()
    {
        if (mBytes.size() > LargestDescriptor)
            return fail(tooMany("descriptor", mBytes.size(), LargestDescriptor));
        while (mAt < mBytes.size())
            if (auto taken = item(); !taken)
                return fail(std::move(taken).error().atByte(mAt));
        if (!mCollections.empty())
            return fail(unmatched("open collections", mCollections.size()));
        return std::move(mFields);
    }

private:
    static Error tooMany(const char *what, std::size_t size, std::size_t limit)
    {
        return {ErrorCode::LimitExceeded,
                {what, std::to_string(size), std::to_string(limit)},
                {},
                Error::None,
                Error::None};
    }
    static Error unmatched(const char *what, std::size_t count)
    {
        return {ErrorCode::BadValue, {what, std::to_string(count), "0"}, {}, Error::None, Error::None};
    }

    Result<void> item()
    {
        const std::uint8_t prefix = mBytes[mAt];
        const std::size_t left = mBytes.size() - mAt - 1;
        std::size_t length = (prefix & 3) == 3 ? 4 : prefix & 3;
        if (prefix == LongItem)
            length = left > 0 ? std::size_t(mBytes[mAt + 1]) + 2 : 1;
        if (length > left)
            return fail(ErrorCode::Truncated, std::to_string(length), std::to_string(left));
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < length && prefix != LongItem; ++i)
            value |= std::uint32_t(mBytes[mAt + 1 + i]) << (8 * i);
        mAt += 1 + length;
        if (prefix == LongItem)
            return {};
        // Negative numbers are as short as they can be.
        std::int32_t number = std::int32_t(value);
        if (length == 1)
            number = std::int8_t(value);
        else if (length == 2)
            number = std::int16_t(value);
        switch (ItemType((prefix >> 2) & 3)) {
        case ItemType::Main:
            return mainItem(prefix >> 4, value);
        case ItemType::Global:
            return globalItem(prefix >> 4, value, number);
        case ItemType::Local:
            return localItem(prefix >> 4, value, length);
        case ItemType::Reserved:
            return {};
        }
        return {};
    }

    Result<void> mainItem(int tag, std::uint32_t value)
    {
        enum { Input = 8, Output = 9, Collection = 10, Feature = 11, EndCollection = 12 };
        Result<void> result;
        if (tag == Collection) {
            if (mCollections.size() == LargestDepth)
                return fail(tooMany("collections", mCollections.size() + 1, LargestDepth));
            mCollections.push_back(mLocals.usages.empty() ? 0 : mLocals.usages.front());
        } else if (tag == EndCollection) {
            if (mCollections.empty())
                return fail(unmatched("ends of collections", 1));
            mCollections.pop_back();
        } else if (tag == Input) {
            result = field(HidField::Kind::Input, value);
        } else if (tag == Output) {
            result = field(HidField::Kind::Output, value);
        } else if (tag == Feature) {
            result = field(HidField::Kind::Feature, value);
        }
        mLocals = {};
        return result;
    }

    Result<void> field(HidField::Kind kind, std::uint32_t flags)
    {
        if (mGlobals.count == 0)
            return {};
        if (mGlobals.bitSize == 0 || mGlobals.bitSize > 32)
            return fail(ErrorCode::BadValue, "report size", std::to_string(mGlobals.bitSize), "1 ... 32");
        if (mFields.size() == LargestFieldCount)
            return fail(tooMany("fields", mFields.size() + 1, LargestFieldCount));
        std::uint32_t &offset = mOffsets[std::size_t(kind)][mGlobals.reportId];
        if (mGlobals.count > LargestReport || offset + mGlobals.bitSize * mGlobals.count > LargestReport)
            return fail(tooMany("bits of a report", mGlobals.count, LargestReport));
        HidField field;
        field.kind = kind;
        field.reportId = mGlobals.reportId;
        field.isConstant = flags & 1;
        field.isArray = !(flags & 2);
        field.bitOffset = offset;
        field.bitSize = mGlobals.bitSize;
        field.count = mGlobals.count;
        field.least = mGlobals.least;
        // A largest value written as unsigned (0xff for 255) would be negative.
        field.most =
            mGlobals.most < mGlobals.least ? std::int32_t(std::min(mGlobals.mostUnsigned, 0x7fffffffu)) : mGlobals.most;
        field.usages = std::move(mLocals.usages);
        field.collections = mCollections;
        offset += mGlobals.bitSize * mGlobals.count;
        mFields.push_back(std::move(field));
        return {};
    }

    Result<void> globalItem(int tag, std::uint32_t value, std::int32_t number)
    {
        enum { UsagePage, Least, Most, PhysicalLeast, PhysicalMost, Exponent, Unit, Size, Id, Count, Push, Pop };
        switch (tag) {
        case UsagePage:
            mGlobals.page = value & 0xffff;
            break;
        case Least:
            mGlobals.least = number;
            break;
        case Most:
            mGlobals.most = number;
            mGlobals.mostUnsigned = value;
            break;
        case Size:
            mGlobals.bitSize = value;
            break;
        case Id:
            if (value == 0 || value > 255)
                return fail(ErrorCode::BadValue, "report id", std::to_string(value), "1 ... 255");
            mGlobals.reportId = std::uint8_t(value);
            break;
        case Count:
            mGlobals.count = value;
            break;
        case Push:
            if (mStack.size() == LargestDepth)
                return fail(tooMany("pushes", mStack.size() + 1, LargestDepth));
            mStack.push_back(mGlobals);
            break;
        case Pop:
            if (mStack.empty())
                return fail(unmatched("pops", 1));
            mGlobals = mStack.back();
            mStack.pop_back();
            break;
        default:
            break;
        }
        return {};
    }

    Result<void> localItem(int tag, std::uint32_t value, std::size_t length)
    {
        enum { Usage, UsageLeast, UsageMost };
        const HidUsage usage = length == 4 ? value : mGlobals.page << 16 | value;
        if (tag == Usage) {
            if (mLocals.usages.size() == LargestUsageCount)
                return fail(tooMany("usages", mLocals.usages.size() + 1, LargestUsageCount));
            mLocals.usages.push_back(usage);
        } else if (tag == UsageLeast) {
            mLocals.usageLeast = usage;
        } else if (tag == UsageMost) {
            if (usage >= mLocals.usageLeast && usage - mLocals.usageLeast >= LargestUsageCount - mLocals.usages.size())
                return fail(tooMany("usages", usage - mLocals.usageLeast, LargestUsageCount));
            for (HidUsage u = mLocals.usageLeast; u <= usage; ++u) {
                mLocals.usages.push_back(u);
                if (u == ~HidUsage(0))
                    break;
            }
        }
        return {};
    }

    std::span<const std::uint8_t> mBytes;
    std::size_t mAt = 0;
    Globals mGlobals;
    Locals mLocals;
    std::vector<Globals> mStack;
    std::vector<HidUsage> mCollections;
    std::array<std::array<std::uint32_t, 256>, 3> mOffsets{};
    std::vector<HidField> mFields;
};

/// Where a value lies in a report with its id byte; the bits before it.
std::size_t bitOf(const HidField &field, std::uint32_t index)
{
    return 8 + std::size_t(field.bitOffset) + std::size_t(field.bitSize) * index;
}

} // namespace

bool HidField::isIn(HidUsage collection) const
{
    return std::find(collections.begin(), collections.end(), collection) != collections.end();
}

Result<std::vector<HidField>> parseReportDescriptor(std::span<const std::uint8_t> descriptor)
{
    return Parser(descriptor).run();
}

std::size_t reportSize(std::span<const HidField> fields, HidField::Kind kind, std::uint8_t reportId)
{
    std::size_t bits = 0;
    for (const HidField &field : fields)
        if (field.kind == kind && field.reportId == reportId)
            bits = std::max<std::size_t>(bits, field.bitOffset + std::size_t(field.bitSize) * field.count);
    return bits == 0 ? 0 : 1 + (bits + 7) / 8;
}

std::int32_t valueIn(std::span<const std::uint8_t> report, const HidField &field, std::uint32_t index)
{
    const std::size_t first = bitOf(field, index);
    if (index >= field.count || first + field.bitSize > 8 * report.size())
        return 0;
    std::uint32_t value = 0;
    for (std::uint32_t i = 0; i < field.bitSize; ++i)
        value |= std::uint32_t(report[(first + i) / 8] >> ((first + i) % 8) & 1) << i;
    if (field.least < 0 && field.bitSize < 32 && (value >> (field.bitSize - 1) & 1))
        value |= ~std::uint32_t(0) << field.bitSize;
    return std::int32_t(value);
}

void setValueIn(std::span<std::uint8_t> report, const HidField &field, std::int32_t value, std::uint32_t index)
{
    const std::size_t first = bitOf(field, index);
    if (index >= field.count || first + field.bitSize > 8 * report.size())
        return;
    for (std::uint32_t i = 0; i < field.bitSize; ++i) {
        const std::uint8_t bit = std::uint8_t(1 << ((first + i) % 8));
        std::uint8_t &byte = report[(first + i) / 8];
        byte = std::uint8_t(std::uint32_t(value) >> i & 1 ? byte | bit : byte & ~bit);
    }
}

} // namespace model::haptics
