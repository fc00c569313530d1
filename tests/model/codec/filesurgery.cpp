// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/filesurgery.h"

#include "model/codec/animationcodec.h"
#include "tests/model/codec/animations.h"

#include <zlib.h>

using namespace model;

namespace tests {

RawChunks takeApart(const Bytes &file)
{
    RawChunks chunks;
    ByteReader reader(file);
    reader.bytes(8);
    while (reader.left() > 0) {
        const auto tag = reader.bytes(4);
        const auto payload = reader.bytes(reader.varUint());
        reader.u32();
        chunks.push_back({std::string(tag.begin(), tag.end()), Bytes(payload.begin(), payload.end())});
    }
    return chunks;
}

Bytes putTogether(const RawChunks &chunks)
{
    ByteWriter writer;
    for (const std::uint8_t byte : {0x89, 0x53, 0x52, 0x41, 0x0d, 0x0a, 0x1a, 0x0a})
        writer.u8(byte);
    for (const auto &[tag, payload] : chunks) {
        Bytes checked(tag.begin(), tag.end());
        checked.insert(checked.end(), payload.begin(), payload.end());
        for (const char c : tag)
            writer.u8(std::uint8_t(c));
        writer.varUint(payload.size());
        writer.bytes(payload);
        writer.u32(std::uint32_t(::crc32(0, checked.data(), uInt(checked.size()))));
    }
    return writer.take();
}

Bytes withPayload(const Bytes &file, const std::string &tag, const std::function<void(Bytes &)> &change)
{
    RawChunks chunks = takeApart(file);
    for (auto &[name, payload] : chunks)
        if (name == tag)
            change(payload);
    return putTogether(chunks);
}

Bytes smallFile()
{
    return codec::encodeAnimation(waves(4, 12, 5), {PcaSettings{3, 1000}})->bytes;
}

std::string errorText(const Bytes &file)
{
    const auto decoded = codec::decodeAnimation(file);
    if (decoded)
        return "none";
    const Error &error = decoded.error();
    std::string text = std::to_string(int(error.code));
    for (const std::string &arg : error.args)
        text += " " + arg;
    return text;
}

} // namespace tests
