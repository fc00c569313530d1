// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace model {

/// A 64-bit digest of bytes (XXH64). Fast, well mixed, not for use against an adversary. Compare digests within one
/// program run only: the callers below feed it memory as it lies there.
/// \param seed  the digest of what came before, to chain several pieces
/// Source: Yann Collet, xxHash fast digest algorithm, specification 0.2.0.
std::uint64_t digestOf(std::span<const std::byte> bytes, std::uint64_t seed = 0);

/// The same of an array of plain values without padding, its length included, so that chained arrays cannot run into
/// each other.
template <class T>
std::uint64_t digestOfArray(std::span<const T> values, std::uint64_t seed = 0)
{
    static_assert(std::is_trivially_copyable_v<T>);
    return digestOf(std::as_bytes(values), seed ^ (values.size() * 0x9e3779b97f4a7c15u));
}

} // namespace model
