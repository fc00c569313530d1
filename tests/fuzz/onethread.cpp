// SPDX-License-Identifier: GPL-3.0-or-later
// The same run for the same input.
#include "model/base/parallel.h"

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    model::setThreadCount(1);
    return 0;
}
