// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/erosion/erosionsettings.h"

#include "model/base/numbertext.h"

namespace model::terrain {

Result<void> check(const ErosionSettings &settings)
{
    constexpr double Longest = 1e9; // metres: more than any terrain
    const struct
    {
        const char *name;
        double value, low, high;
    } ranges[] = {
        {"rule", double(settings.rule), 0, 1},
        {"relaxation", settings.relaxation, 0.1, 1.95},
        {"startAngle", settings.startAngle, 0, 10},
        {"sweepsPerSecond", settings.sweepsPerSecond, 1, 100000},
        {"longestEdge", settings.longestEdge, 0, Longest},
        {"flatError", settings.flatError, 0, Longest},
        {"flatAngle", settings.flatAngle, 0, 10},
    };
    for (const auto &range : ranges)
        if (!(range.value >= range.low && range.value <= range.high))
            return fail(ErrorCode::BadSetting, range.name, numberText(range.value),
                        numberText(range.low) + " ... " + numberText(range.high));
    if (auto checked = check(settings.material); !checked) {
        checked.error().args[0].insert(0, "material.");
        return checked;
    }
    return {};
}

} // namespace model::terrain
