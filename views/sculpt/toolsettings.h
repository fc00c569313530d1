// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/erosion/erosionsettings.h"
#include "model/terrain/tools/stroke.h"

#include <QObject>

#include <vector>

namespace views {

/// How sand slides while a person works.
struct FlowSettings
{
    model::terrain::ErosionSettings erosion;
    bool isOn = true;        ///< while drawing and after it
    double speed = 1;        ///< simulated seconds in a second
    double milliseconds = 5; ///< of a frame, at most
};

/// What strokes are drawn with: the chosen tool, the settings of every tool, symmetry and erosion. No part of a
/// document: docks change it, strokes use it.
class ToolSettings final : public QObject
{
    Q_OBJECT

public:
    explicit ToolSettings(QObject *parent = nullptr);

    /// The tool of each kind, in the order of model::terrain::Tool.
    const std::vector<model::terrain::Tool> &tools() const { return mTools; }
    const model::terrain::Tool &tool() const { return mTools[mChosen]; }
    void choose(std::size_t kind);
    /// Becomes the tool of its kind, and is chosen.
    void setTool(const model::terrain::Tool &tool);
    /// Sizes that suit a terrain: radii a thirtieth of its shorter side, and amounts in proportion.
    void fitTo(const model::terrain::Rectangle &domain);
    /// The shorter side of the terrain that the tools were fitted to, in metres.
    double terrainSide() const { return mSide; }

    const model::terrain::Symmetry &symmetry() const { return mSymmetry; }
    void setSymmetry(const model::terrain::Symmetry &symmetry);
    const FlowSettings &flow() const { return mFlow; }
    void setFlow(const FlowSettings &flow);

    /// Larger or smaller, and more or less with each stamp; bounded to what the tool takes.
    void scaleRadius(double factor);
    void scaleAmount(double factor);

signals:
    /// The chosen tool, or a setting of it, or the symmetry.
    void toolChanged();
    void flowChanged();

private:
    std::vector<model::terrain::Tool> mTools;
    std::size_t mChosen = 0;
    double mSide = 1;
    model::terrain::Symmetry mSymmetry;
    FlowSettings mFlow;
};

/// Tools as people know them: "Finger", "Rake", "Footprint". They set the tool of one kind.
struct ToolPreset
{
    QString title;
    model::terrain::Tool tool; ///< for a terrain whose shorter side is 1 m
};
std::vector<ToolPreset> toolPresets();
/// A tool with all its lengths multiplied.
model::terrain::Tool scaled(const model::terrain::Tool &tool, double factor);

} // namespace views
