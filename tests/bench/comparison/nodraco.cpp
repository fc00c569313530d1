// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/comparison/contender.h"

namespace bench {

std::unique_ptr<Contender> makeDraco()
{
    return nullptr;
}

} // namespace bench
