// SPDX-License-Identifier: GPL-3.0-or-later
// Where a hand comes to rest on stiff ground, over stiffness and delay: the table of model/haptics/README.md.
#include "tests/model/haptics/handloop.h"

#include <cstdio>

int main()
{
    constexpr double Stiffness[] = {50, 100, 200, 400, 800, 1600, 3200, 6400};
    std::printf("delay ms |");
    for (const double k : Stiffness)
        std::printf(" %5.0f", k);
    std::printf(" | stiffest   b / (d + T/2)\n");
    for (const int delay : {0, 1, 2, 5, 10, 20}) {
        std::printf("%8d |", delay);
        for (const double k : Stiffness)
            std::printf("     %c", tests::comesToRest(k, delay) ? '+' : '-');
        std::printf(" | %8.0f   %8.0f\n", tests::stiffestStable(delay),
                    model::haptics::SimulatedHand().damping / ((delay + 0.5) * 0.001));
    }
}
