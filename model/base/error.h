// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

namespace model {

/// What went wrong. The text for people is made from it in model/io/errortext; `args` fill its %1, %2, ...
/// A new code comes with a row there and a test that produces it.
enum class ErrorCode : std::uint16_t {
    // The input is not what it should be.
    NoFrames,           ///< a folder without a readable frame; args: the endings looked for
    UnknownFormat,      ///< no reader for this file; args: the file's ending
    SyntaxError,        ///< text that does not parse; args: what was expected, what was found
    NonFinite,          ///< a NaN or infinite number; args: what it is (e.g. "vertex 12")
    IndexOutOfRange,    ///< args: the index, the number of vertices
    NoVertices,         ///< a mesh without a vertex
    VertexCountDiffers, ///< args: count here, count in the first frame, the first frame's file
    FacesDiffer,        ///< args: first triangle that differs, the first frame's file
    FaceCountDiffers,   ///< args: count here, count in the first frame, the first frame's file
    Truncated,          ///< the data end too early; args: bytes needed, bytes there
    TrailingBytes,      ///< data after the end; args: number of bytes
    BadMagic,           ///< the file does not start as its format does; args: the format's name
    UnsupportedVersion, ///< args: version of the file, newest version that we read
    UnsupportedFeature, ///< a valid file that uses what we do not read; args: what
    ChecksumMismatch,   ///< args: the chunk's tag
    MissingChunk,       ///< args: the chunk's tag
    DuplicateChunk,     ///< args: the chunk's tag
    BadValue,           ///< a field outside its range; args: the field, its value, the allowed range
    UnknownCodec,       ///< args: the codec's number
    CorruptStream,      ///< a coded stream that cannot be decoded; args: the stage
    MissingBaseMesh,    ///< a point cache without its base mesh
    NoAnimation,        ///< a scene that holds no mesh to animate; args: why
    ImporterFailed,     ///< a library's reader refused the file; args: its message
    MeshesDiffer,       ///< two animations that cannot be compared; args: what, here, there
    BadPermutation,     ///< a permutation file that is none; args: what is wrong
    NoSurface,          ///< an elevation model without ground: all of it is void
    NotASurface,        ///< a mesh that is not one height for each place; args: where, why
    BrokenTerrain,      ///< a triangulation that breaks its own rules; args: the rule, the ids at fault
    // The caller asked for something that cannot be.
    BadSetting,          ///< args: the setting, its value, the allowed range
    CrossingConstraints, ///< a line that may not cross another; args: the vertices of the one, of the other
    // The world.
    CannotOpen,  ///< args: the system's reason
    CannotRead,  ///< args: the system's reason
    CannotWrite, ///< args: the system's reason
    NotFound,    ///< no such file or folder
    // Too much.
    LimitExceeded, ///< args: what, its size, the limit
    OutOfMemory,   ///< args: bytes wanted
    // Not an error of anybody.
    Cancelled,
};

/// The kinds that a caller may treat differently; `sandreel-cli` has an exit code for each.
enum class ErrorCategory : std::uint8_t { Usage, BadInput, InputOutput, Limit, Cancelled };

ErrorCategory categoryOf(ErrorCode code);

/// What went wrong and where. `file` is UTF-8 and empty if no file is concerned.
struct Error
{
    static constexpr std::uint64_t None = ~std::uint64_t(0);

    ErrorCode code = ErrorCode::CorruptStream;
    std::vector<std::string> args;
    std::string file;
    std::uint64_t line = None;   ///< 1-based line of a text file
    std::uint64_t offset = None; ///< 0-based byte of a binary file

    /// The same error in `path`, unless a file is named already: the innermost caller knows best.
    Error in(std::string path) &&
    {
        if (file.empty())
            file = std::move(path);
        return std::move(*this);
    }
    Error atLine(std::uint64_t number) &&
    {
        line = number;
        return std::move(*this);
    }
    Error atByte(std::uint64_t position) &&
    {
        offset = position;
        return std::move(*this);
    }
};

template <class T>
using Result = tl::expected<T, Error>;

/// `return fail(ErrorCode::NotFound);` in a function that returns a Result.
template <class... Args>
tl::unexpected<Error> fail(ErrorCode code, Args &&...args)
{
    return tl::unexpected<Error>(Error{code, {std::string(std::forward<Args>(args))...}, {}, Error::None, Error::None});
}

/// `return fail(std::move(error).in(path));`
inline tl::unexpected<Error> fail(Error error)
{
    return tl::unexpected<Error>(std::move(error));
}

} // namespace model
