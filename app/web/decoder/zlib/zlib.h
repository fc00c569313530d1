// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The part of zlib's interface that model/codec decodes with, for WebAssembly, where Debian has no zlib. What is
// decoded is the same; what only an encoder calls is declared and not there.

#include <cstddef>
#include <cstdint>

using Bytef = std::uint8_t;
using uInt = unsigned;

constexpr int Z_OK = 0;
constexpr int Z_STREAM_END = 1;
constexpr int Z_DATA_ERROR = -3;
constexpr int Z_MEM_ERROR = -4;
constexpr int Z_BUF_ERROR = -5;
constexpr int Z_NO_FLUSH = 0;
constexpr int Z_FINISH = 4;
constexpr int Z_BEST_COMPRESSION = 9;

struct InflateState;

struct z_stream_s
{
    Bytef *next_in = nullptr;
    uInt avail_in = 0;
    Bytef *next_out = nullptr;
    uInt avail_out = 0;
    InflateState *state = nullptr;
};

using z_stream = z_stream_s;

int inflateInit(z_stream *stream);
/// Decodes until the output is full. Differs from zlib's: all of the input is there at the first call.
/// \returns Z_OK, Z_STREAM_END once the checksum was verified, Z_DATA_ERROR, Z_BUF_ERROR if the input ends too early
int inflate(z_stream *stream, int flush);
int inflateEnd(z_stream *stream);

int deflateInit(z_stream *stream, int level);
int deflate(z_stream *stream, int flush);
int deflateEnd(z_stream *stream);
