// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace model::terrain {

/// A sum of doubles that carries its rounding errors along: its error does not grow with the number of terms.
/// Source: A. Neumaier, Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen, 1974.
struct CompensatedSum
{
    double sum = 0, lost = 0;

    void add(double term)
    {
        const double total = sum + term;
        lost += std::abs(sum) >= std::abs(term) ? (sum - total) + term : (term - total) + sum;
        sum = total;
    }
    double value() const { return sum + lost; }
};

/// Where the volume of a terrain came from and went, in cubic metres since it was built.
struct Ledger
{
    double start = 0;       ///< the volume as built
    CompensatedSum added;   ///< by raised vertices, at least 0
    CompensatedSum removed; ///< by lowered vertices, at least 0
    CompensatedSum moved;   ///< from vertex to vertex, at least 0
    CompensatedSum pressed; ///< out of layers that were compacted, at least 0: their mass stayed
    CompensatedSum kept;    ///< changes of the surface by edits that do not give their volume back, either sign

    /// What the volume has to be now.
    double expected() const
    {
        CompensatedSum total = added;
        total.add(-removed.sum);
        total.add(-removed.lost);
        total.add(-pressed.sum);
        total.add(-pressed.lost);
        total.add(kept.sum);
        total.add(kept.lost);
        total.add(start);
        return total.value();
    }
};

} // namespace model::terrain
