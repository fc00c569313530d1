// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/animbytes.h"

#include <algorithm>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t *data, std::size_t size, std::size_t maxSize);

using namespace model;

namespace tests {

namespace {

void mutatePayload(Bytes &payload, std::size_t maxSize)
{
    const std::size_t size = payload.size();
    payload.resize(std::max(size, maxSize));
    payload.resize(LLVMFuzzerMutate(payload.data(), size, payload.size()));
}

} // namespace

} // namespace tests

/// Mostly changes the payload of one chunk and mends the frame around it, sometimes drops, repeats or swaps chunks,
/// sometimes changes bytes anywhere.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t *data, std::size_t size, std::size_t maxSize, unsigned seed)
{
    using namespace tests;
    std::minstd_rand random(seed);
    std::vector<RawChunk> chunks = chunksOf({data, size});
    const unsigned kind = unsigned(random() % 32);
    if (chunks.empty() || kind == 0)
        return LLVMFuzzerMutate(data, size, maxSize);
    const std::size_t at = random() % chunks.size();
    if (kind == 1)
        chunks.erase(chunks.begin() + std::ptrdiff_t(at));
    else if (kind == 2)
        chunks.push_back(chunks[at]);
    else if (kind == 3)
        std::swap(chunks[at], chunks[random() % chunks.size()]);
    else
        mutatePayload(chunks[at].payload, chunks[at].payload.size() + (maxSize - std::min(maxSize, size)));
    const Bytes file = fileOf(chunks);
    if (file.size() > maxSize)
        return LLVMFuzzerMutate(data, size, maxSize);
    std::copy(file.begin(), file.end(), data);
    return file.size();
}
