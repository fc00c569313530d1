// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/toolvalues.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace views {

using namespace model::terrain;

namespace {

template <class... Cases>
struct Overloaded : Cases...
{
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// Far below and above what a terrain could show.
constexpr double SmallestRadius = 1e-4, LargestRadius = 1e6;
constexpr double LargestAmount = 1e6;

template <class T>
concept HasBrush = requires(T tool)
{
    tool.brush;
};

/// What one stamp does, as a member of the tool; null if there is nothing to say.
template <class T>
auto amountIn(T &tool) -> decltype(&tool.depth)
{
    return &tool.depth;
}
double *amountIn(Raise &tool)
{
    return &tool.height;
}
double *amountIn(Flatten &tool)
{
    return &tool.strength;
}
double *amountIn(Smooth &tool)
{
    return &tool.strength;
}
double *amountIn(Noise &tool)
{
    return &tool.amplitude;
}
double *amountIn(Restore &tool)
{
    return &tool.strength;
}
double *amountIn(Pour &tool)
{
    return &tool.volume;
}
double *amountIn(Moisten &tool)
{
    return &tool.strength;
}
double *amountIn(Ramp &)
{
    return nullptr;
}
double *amountIn(Breakline &)
{
    return nullptr;
}

double *amountIn(Tool &tool)
{
    return std::visit([](auto &t) -> double * { return amountIn(t); }, tool);
}

/// A brush where the tool's disc is.
Brush brushFor(const Tool &tool)
{
    Brush brush;
    if (const Brush *own = brushOf(tool))
        brush = *own;
    else if (radiusOf(tool) > 0)
        brush.radius = radiusOf(tool);
    if (const Mask *mask = maskOf(tool))
        brush.mask = *mask;
    return brush;
}

double metresOf(const Tool &tool)
{
    return amountKindOf(tool) == AmountKind::Metres ? amountOf(tool) : brushFor(tool).radius / 10;
}

} // namespace

double radiusOf(const Tool &tool)
{
    return std::visit(Overloaded{[](const Imprint &t) { return t.radius; }, [](const Rake &t) { return t.width / 2; },
                                 [](const Breakline &) { return 0.0; }, [](const auto &t) { return t.brush.radius; }},
                      tool);
}

void setRadius(Tool &tool, double metres)
{
    const double radius = std::clamp(metres, SmallestRadius, LargestRadius);
    std::visit(Overloaded{[&](Imprint &t) { t.radius = radius; }, [&](Rake &t) { t.width = 2 * radius; },
                          [](Breakline &) {}, [&](auto &t) { t.brush.radius = radius; }},
               tool);
}

AmountKind amountKindOf(const Tool &tool)
{
    return std::visit(
        Overloaded{[](const Flatten &) { return AmountKind::Share; }, [](const Smooth &) { return AmountKind::Share; },
                   [](const Restore &) { return AmountKind::Share; }, [](const Moisten &) { return AmountKind::Share; },
                   [](const Pour &) { return AmountKind::CubicMetres; }, [](const Ramp &) { return AmountKind::None; },
                   [](const Breakline &) { return AmountKind::None; }, [](const auto &) { return AmountKind::Metres; }},
        tool);
}

double amountOf(const Tool &tool)
{
    Tool copy = tool;
    const double *const amount = amountIn(copy);
    return amount ? *amount : 0;
}

void setAmount(Tool &tool, double amount)
{
    if (double *const member = amountIn(tool))
        *member = std::clamp(amount, 0.0, amountKindOf(tool) == AmountKind::Share ? 1 : LargestAmount);
}

const Mask *maskOf(const Tool &tool)
{
    return std::visit(Overloaded{[](const Imprint &t) { return &t.mask; }, [](const Rake &t) { return &t.mask; },
                                 [](const Breakline &) { return static_cast<const Mask *>(nullptr); },
                                 [](const auto &t) { return &t.brush.mask; }},
                      tool);
}

void setMask(Tool &tool, const Mask &mask)
{
    std::visit(Overloaded{[&](Imprint &t) { t.mask = mask; }, [&](Rake &t) { t.mask = mask; }, [](Breakline &) {},
                          [&](auto &t) { t.brush.mask = mask; }},
               tool);
}

const Brush *brushOf(const Tool &tool)
{
    return std::visit(
        []<class T>(const T &t) -> const Brush * {
            if constexpr (HasBrush<T>)
                return &t.brush;
            else
                return nullptr;
        },
        tool);
}

void setBrush(Tool &tool, const Brush &brush)
{
    std::visit(
        [&]<class T>(T &t) {
            if constexpr (HasBrush<T>)
                t.brush = brush;
        },
        tool);
}

Tool inverted(const Tool &tool)
{
    return std::visit(Overloaded{[](const Raise &t) {
                                     return Tool(Lower{t.brush, t.height});
                                 },
                                 [](const Lower &t) {
                                     return Tool(Raise{t.brush, t.depth});
                                 },
                                 [](const Scoop &t) {
                                     return Tool(Raise{t.brush, t.depth});
                                 },
                                 [&](const Pour &t) {
                                     // About what a stamp pours: a cone as wide has a third of the cylinder.
                                     const double area = M_PI * t.brush.radius * t.brush.radius;
                                     return Tool(Scoop{t.brush, 3 * t.volume / area});
                                 },
                                 [](const Noise &t) {
                                     Noise noise = t;
                                     noise.amplitude = -t.amplitude;
                                     return Tool(noise);
                                 },
                                 [](const Moisten &t) {
                                     Moisten dry = t;
                                     dry.humidity = 1 - t.humidity;
                                     return Tool(dry);
                                 },
                                 [&](const Imprint &t) {
                                     Brush brush = brushFor(tool);
                                     brush.falloff = Falloff::Sphere;
                                     return Tool(Raise{brush, t.depth * t.spacing});
                                 },
                                 [&](const auto &) { return tool; }},
                      tool);
}

Tool smoothing(const Tool &tool)
{
    return Smooth{brushFor(tool), 0.5};
}

Tool lifting(const Tool &tool)
{
    const Brush brush = brushFor(tool);
    return Raise{brush, metresOf(tool) * brush.spacing};
}

QString titleOf(const Tool &tool)
{
    const auto name = [](const char *text) { return QCoreApplication::translate("Tool", text); };
    return std::visit(Overloaded{[&](const Imprint &) { return name(QT_TRANSLATE_NOOP("Tool", "Imprint")); },
                                 [&](const Rake &) { return name(QT_TRANSLATE_NOOP("Tool", "Rake")); },
                                 [&](const Raise &) { return name(QT_TRANSLATE_NOOP("Tool", "Raise")); },
                                 [&](const Lower &) { return name(QT_TRANSLATE_NOOP("Tool", "Lower")); },
                                 [&](const Flatten &) { return name(QT_TRANSLATE_NOOP("Tool", "Flatten")); },
                                 [&](const Smooth &) { return name(QT_TRANSLATE_NOOP("Tool", "Smooth")); },
                                 [&](const Noise &) { return name(QT_TRANSLATE_NOOP("Tool", "Noise")); },
                                 [&](const Ramp &) { return name(QT_TRANSLATE_NOOP("Tool", "Ramp")); },
                                 [&](const Restore &) { return name(QT_TRANSLATE_NOOP("Tool", "Restore")); },
                                 [&](const Pour &) { return name(QT_TRANSLATE_NOOP("Tool", "Pour")); },
                                 [&](const Scoop &) { return name(QT_TRANSLATE_NOOP("Tool", "Scoop")); },
                                 [&](const Breakline &) { return name(QT_TRANSLATE_NOOP("Tool", "Breakline")); },
                                 [&](const Moisten &) { return name(QT_TRANSLATE_NOOP("Tool", "Moisten")); }},
                      tool);
}

QString hintOf(const Tool &tool)
{
    const auto say = [](const char *text) { return QCoreApplication::translate("Tool", text); };
    return std::visit(
        Overloaded{
            [&](const Imprint &) {
                return say(QT_TRANSLATE_NOOP(
                    "Tool", "Presses a rigid shape into the ground; what it displaces lies around it"));
            },
            [&](const Rake &) { return say(QT_TRANSLATE_NOOP("Tool", "Draws grooves side by side")); },
            [&](const Raise &) { return say(QT_TRANSLATE_NOOP("Tool", "Adds material")); },
            [&](const Lower &) { return say(QT_TRANSLATE_NOOP("Tool", "Takes material away")); },
            [&](const Flatten &) { return say(QT_TRANSLATE_NOOP("Tool", "Draws the ground towards one level")); },
            [&](const Smooth &) { return say(QT_TRANSLATE_NOOP("Tool", "Evens out bumps; the volume stays")); },
            [&](const Noise &) { return say(QT_TRANSLATE_NOOP("Tool", "Adds hills and hollows")); },
            [&](const Ramp &) {
                return say(QT_TRANSLATE_NOOP("Tool", "Makes an even slope from where you press to where you let go"));
            },
            [&](const Restore &) {
                return say(QT_TRANSLATE_NOOP("Tool", "Brings back the ground as it was at the chosen moment"));
            },
            [&](const Pour &) {
                return say(QT_TRANSLATE_NOOP("Tool", "Adds exactly this much material with each stamp"));
            },
            [&](const Scoop &) { return say(QT_TRANSLATE_NOOP("Tool", "Takes material out and says how much")); },
            [&](const Breakline &) {
                return say(QT_TRANSLATE_NOOP("Tool", "Fixes edges of the surface along your line"));
            },
            [&](const Moisten &) {
                return say(QT_TRANSLATE_NOOP("Tool", "Wets or dries the surface; wet material stands at other slopes"));
            }},
        tool);
}

} // namespace views
