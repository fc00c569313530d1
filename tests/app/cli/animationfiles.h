// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/sequence.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace tests {

// Files of animations, written and read here by hand: nothing of the program under test judges itself.

using Frames = std::vector<std::vector<model::Vec3f>>;

Frames framesOf(const model::Sequence &sequence);

void writeFile(const QString &path, const QByteArray &bytes);
QByteArray readFile(const QString &path);

/// OBJ with numbers that read as the same floats.
QByteArray objOf(const std::vector<model::Vec3f> &positions, const std::vector<model::Triangle> &triangles);
/// Makes `folder` with frame_1.obj, frame_2.obj, ...
void writeObjFolder(const QString &folder, const model::Sequence &sequence);
void writePc2(const QString &path, const model::Sequence &sequence);

struct PointCache
{
    float startFrame = 0, sampleRate = 0;
    std::uint32_t vertexCount = 0;
    Frames frames;
};
/// A PC2 file that is exactly what its header says; nothing otherwise.
std::optional<PointCache> readPc2(const QString &path);

/// The numbers of a permutation file, one a line.
std::vector<std::uint32_t> readPermutation(const QString &path);

/// The error figures, in double and by their definitions; test[i] is reference[permutation[i]].
struct Errors
{
    double kgPercent = 0, rmse = 0, psnr = 0, largest = 0;
};
/// \param diagonal  for the PSNR; of the box of `reference` if 0
Errors errorsBetween(const Frames &reference, const Frames &test, const std::vector<std::uint32_t> &permutation,
                     double diagonal = 0);
double diagonalOf(const Frames &frames);

/// Every file and folder below `folder`, sorted: to see that nothing was left behind.
QStringList contentsOf(const QString &folder);

} // namespace tests
