// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tinarrays.h"

namespace model::io {

/// Calls `field(double &)` for each number that a ledger is made of, as files have them. FORMAT.md, 5.6.
template <class Field>
void forEachLedgerField(terrain::TinTotals &totals, Field field)
{
    terrain::Ledger &ledger = totals.ledger;
    field(ledger.start);
    const auto sum = [&](terrain::CompensatedSum &value) {
        field(value.sum);
        field(value.lost);
    };
    for (terrain::CompensatedSum *const value :
         {&ledger.added, &ledger.removed, &ledger.moved, &ledger.kept, &ledger.pressed})
        sum(*value);
    for (std::uint32_t l = 0; l < totals.layers.count; ++l)
        sum(totals.compacted[l]);
}

} // namespace model::io
