// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace editor {

/// A document that comes with the program.
struct Sample
{
    QString path; ///< in the program's resources
    QString name; ///< in the interface's language
};

std::vector<Sample> samples();
/// The name of a sample by its path, or file name.
QString sampleName(const QString &path);

} // namespace editor
