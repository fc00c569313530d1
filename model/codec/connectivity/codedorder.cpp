// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/connectivity/codedorder.h"

#include "model/codec/connectivity/connectivitystage.h"

namespace model::codec {

Result<std::vector<std::uint32_t>> codedOrder(const Connectivity &input, const Connectivity &coded,
                                              const Progress &progress)
{
    if (input.vertexCount != coded.vertexCount || input.triangles.size() != coded.triangles.size() || input == coded)
        return {};
    Result<EncodedConnectivity> encoded = encodeConnectivity(input, progress);
    if (!encoded)
        return encoded.error().code == ErrorCode::Cancelled ? fail(ErrorCode::Cancelled)
                                                            : Result<std::vector<std::uint32_t>>();
    if (encoded->coded.connectivity != coded)
        return {};
    return std::move(encoded->permutation);
}

} // namespace model::codec
