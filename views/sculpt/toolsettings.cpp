// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/toolsettings.h"

#include "views/sculpt/toolvalues.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace views {

using namespace model::terrain;

namespace {

/// Of a terrain's shorter side.
constexpr double UsualRadius = 1.0 / 30;

/// For a terrain whose shorter side is 1 m.
std::vector<Tool> usualTools()
{
    Brush brush;
    brush.radius = UsualRadius;
    Imprint imprint;
    imprint.radius = UsualRadius;
    imprint.depth = UsualRadius / 2;
    Rake rake;
    rake.width = 3 * UsualRadius;
    rake.depth = UsualRadius / 5;
    Noise noise;
    noise.brush = brush;
    noise.amplitude = UsualRadius / 10;
    noise.wavelength = UsualRadius;
    Moisten moisten;
    moisten.brush = brush;
    const double height = UsualRadius / 10;
    return {imprint,
            rake,
            Raise{brush, height},
            Lower{brush, height},
            Flatten{brush, 0.25, {}},
            Smooth{brush, 0.5},
            noise,
            Ramp{brush, {}, {}},
            Restore{brush, 0.5, {}},
            Pour{brush, M_PI * UsualRadius * UsualRadius * height / 3},
            Scoop{brush, height},
            Breakline{UsualRadius / 2, {}, Crossing::Split},
            moisten};
}

} // namespace

ToolSettings::ToolSettings(QObject *parent)
    : QObject(parent)
    , mTools(usualTools())
{}

void ToolSettings::choose(std::size_t kind)
{
    if (kind == mChosen || kind >= mTools.size())
        return;
    mChosen = kind;
    emit toolChanged();
}

void ToolSettings::setTool(const Tool &tool)
{
    mChosen = tool.index();
    mTools[mChosen] = tool;
    emit toolChanged();
}

void ToolSettings::fitTo(const Rectangle &domain)
{
    mSide = std::min(domain.high.x - domain.low.x, domain.high.y - domain.low.y);
    std::vector<Tool> tools = usualTools();
    for (Tool &tool : tools)
        tool = scaled(tool, mSide);
    mTools = std::move(tools);
    mSymmetry.centre = {(domain.low.x + domain.high.x) / 2, (domain.low.y + domain.high.y) / 2};
    emit toolChanged();
}

void ToolSettings::setSymmetry(const Symmetry &symmetry)
{
    if (symmetry == mSymmetry)
        return;
    mSymmetry = symmetry;
    emit toolChanged();
}

void ToolSettings::setFlow(const FlowSettings &flow)
{
    mFlow = flow;
    emit flowChanged();
}

void ToolSettings::scaleRadius(double factor)
{
    Tool changed = tool();
    setRadius(changed, radiusOf(changed) * factor);
    setTool(changed);
}

void ToolSettings::scaleAmount(double factor)
{
    Tool changed = tool();
    setAmount(changed, amountOf(changed) * factor);
    setTool(changed);
}

Tool scaled(const Tool &tool, double factor)
{
    Tool result = tool;
    setRadius(result, radiusOf(tool) * factor);
    if (amountKindOf(tool) == AmountKind::Metres)
        setAmount(result, amountOf(tool) * factor);
    else if (amountKindOf(tool) == AmountKind::CubicMetres)
        setAmount(result, amountOf(tool) * factor * factor * factor);
    if (auto *noise = std::get_if<Noise>(&result))
        noise->wavelength *= factor;
    if (auto *breakline = std::get_if<Breakline>(&result))
        breakline->spacing *= factor;
    return result;
}

std::vector<ToolPreset> toolPresets()
{
    const auto name = [](const char *text) { return QCoreApplication::translate("ToolPreset", text); };
    Imprint finger;
    finger.radius = 0.012;
    finger.depth = 0.01;
    Imprint hand;
    hand.radius = 0.05;
    hand.depth = 0.02;
    hand.rim.compressibility = 0.2;
    Imprint plough;
    plough.outline = Outline::wedge();
    plough.radius = 0.03;
    plough.depth = 0.02;
    plough.doesFollowDirection = true;
    Imprint box;
    box.outline = Outline::square();
    box.radius = 0.06;
    box.depth = 0.03;
    Rake rake;
    rake.width = 0.12;
    rake.tines = 7;
    rake.depth = 0.006;
    Rake comb = rake;
    comb.width = 0.06;
    comb.tines = 12;
    comb.depth = 0.002;
    Noise dunes;
    dunes.brush.radius = 0.15;
    dunes.amplitude = 0.01;
    dunes.wavelength = 0.1;
    dunes.octaves = 4;
    return {{name(QT_TRANSLATE_NOOP("ToolPreset", "Finger")), finger},
            {name(QT_TRANSLATE_NOOP("ToolPreset", "Hand")), hand},
            {name(QT_TRANSLATE_NOOP("ToolPreset", "Plough")), plough},
            {name(QT_TRANSLATE_NOOP("ToolPreset", "Box")), box},
            {name(QT_TRANSLATE_NOOP("ToolPreset", "Garden Rake")), rake},
            {name(QT_TRANSLATE_NOOP("ToolPreset", "Comb")), comb},
            {name(QT_TRANSLATE_NOOP("ToolPreset", "Small Dunes")), dunes}};
}

} // namespace views
