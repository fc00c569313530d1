// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled with -march=x86-64-v3 -DEigen=Eigen_v3: shares no symbol with the other sources but its one entry, since the
// linker keeps one copy of an inline function for all, and that must not be one with AVX2 instructions.
#include "model/codec/basis/kernelbodies.h"

extern "C" const model::codec::Kernels *sandreelKernelsV3();

extern "C" const model::codec::Kernels *sandreelKernelsV3()
{
    using namespace model::codec;
    static constexpr Kernels v3{"x86-64-v3", gramTileBody, multiplyBody, reconstructBody, rotateColumnsBody};
    return &v3;
}
