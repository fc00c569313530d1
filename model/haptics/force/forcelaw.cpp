// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/force/forcelaw.h"

#include "model/haptics/force/granularlaw.h"
#include "model/haptics/force/law2009.h"

namespace model::haptics {

const char *nameOf(LawKind kind)
{
    switch (kind) {
    case LawKind::Granular:
        return "granular";
    case LawKind::Reference2009:
        return "2009";
    case LawKind::Reference2009AlongMotion:
        return "2009-along-motion";
    }
    return "";
}

std::optional<LawKind> lawNamed(std::string_view name)
{
    for (const LawKind kind : EveryLaw)
        if (name == nameOf(kind))
            return kind;
    return {};
}

std::unique_ptr<ForceLaw> makeLaw(LawKind kind)
{
    switch (kind) {
    case LawKind::Granular:
        return std::make_unique<GranularLaw>();
    case LawKind::Reference2009:
        return std::make_unique<Law2009>();
    case LawKind::Reference2009AlongMotion:
        return std::make_unique<Law2009>(Law2009::Parts{.sideways = Law2009::Sideways::AlongMotion});
    }
    return std::make_unique<GranularLaw>();
}

} // namespace model::haptics
