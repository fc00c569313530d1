// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tools/stroke.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace views {

/// One setting of a tool, for a form: how it is called and how it is read and written.
struct ToolField
{
    enum class Kind { Number, Choice, Flag };

    Kind kind = Kind::Number;
    QString label; ///< "Radius"; of a flag the text beside its box
    QString unit;  ///< "m", "°"; of a number
    QString hint;  ///< what it is, where the label does not say all
    double min = 0, max = 0;
    int decimals = 0;
    double step = 1;
    QStringList choices; ///< of a choice: the value is its place
    std::function<double(const model::terrain::Tool &)> value;
    std::function<void(model::terrain::Tool &, double)> setValue;
};

/// The settings of a tool that depend on its kind, in the order of a form. Which there are may depend on them: a level
/// only if there is one.
std::vector<ToolField> fieldsOf(const model::terrain::Tool &tool);
/// The settings of its mask; empty if it has none.
std::vector<ToolField> maskFieldsOf(const model::terrain::Tool &tool);

} // namespace views
