// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/basis/kernels.h"
#include "model/codec/basis/kernelbodies.h"

#ifdef SANDREEL_V3_KERNELS
extern "C" const model::codec::Kernels *sandreelKernelsV3();
#endif

namespace model::codec {

const Kernels &portableKernels()
{
    static constexpr Kernels portable{"portable", gramTileBody, multiplyBody, reconstructBody, rotateColumnsBody};
    return portable;
}

const Kernels &kernels()
{
#ifdef SANDREEL_V3_KERNELS
    static const bool hasV3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (hasV3)
        return *sandreelKernelsV3();
#endif
    return portableKernels();
}

} // namespace model::codec
