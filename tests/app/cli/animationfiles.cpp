// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/animationfiles.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QtEndian>

#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace tests {

Frames framesOf(const model::Sequence &sequence)
{
    Frames frames;
    for (std::uint32_t i = 0; i < sequence.frameCount(); ++i)
        frames.push_back(sequence.frame(i));
    return frames;
}

void writeFile(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qUtf8Printable(path));
}

QByteArray readFile(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArray objOf(const std::vector<model::Vec3f> &positions, const std::vector<model::Triangle> &triangles)
{
    QByteArray text;
    const auto number = [](float value) { return QByteArray::number(double(value), 'g', 9); };
    for (const model::Vec3f &p : positions)
        text += "v " + number(p.x) + ' ' + number(p.y) + ' ' + number(p.z) + '\n';
    for (const model::Triangle &t : triangles)
        text += "f " + QByteArray::number(t[0] + 1) + ' ' + QByteArray::number(t[1] + 1) + ' ' +
                QByteArray::number(t[2] + 1) + '\n';
    return text;
}

void writeObjFolder(const QString &folder, const model::Sequence &sequence)
{
    QDir().mkpath(folder);
    for (std::uint32_t i = 0; i < sequence.frameCount(); ++i)
        writeFile(folder + QStringLiteral("/frame_%1.obj").arg(i + 1),
                  objOf(sequence.frame(i), sequence.connectivity().triangles));
}

void writePc2(const QString &path, const model::Sequence &sequence)
{
    QByteArray bytes("POINTCACHE2\0", 12);
    const auto put = [&bytes](std::uint32_t value) {
        char word[4];
        qToLittleEndian(value, word);
        bytes.append(word, 4);
    };
    put(1);
    put(sequence.vertexCount());
    put(std::bit_cast<std::uint32_t>(0.0f));
    put(std::bit_cast<std::uint32_t>(1.0f));
    put(sequence.frameCount());
    for (const model::Vec3f &p : sequence.allPositions())
        for (const float value : {p.x, p.y, p.z})
            put(std::bit_cast<std::uint32_t>(value));
    writeFile(path, bytes);
}

std::optional<PointCache> readPc2(const QString &path)
{
    const QByteArray bytes = readFile(path);
    const auto word = [&bytes](qsizetype at) { return qFromLittleEndian<std::uint32_t>(bytes.constData() + at); };
    const auto real = [&word](qsizetype at) { return std::bit_cast<float>(word(at)); };
    if (bytes.size() < 32 || bytes.left(12) != QByteArray("POINTCACHE2\0", 12) || word(12) != 1)
        return {};
    PointCache cache{real(20), real(24), word(16), {}};
    const std::uint32_t frameCount = word(28);
    if (bytes.size() != 32 + qsizetype(12) * cache.vertexCount * frameCount)
        return {};
    qsizetype at = 32;
    for (std::uint32_t frame = 0; frame < frameCount; ++frame) {
        cache.frames.emplace_back();
        for (std::uint32_t i = 0; i < cache.vertexCount; ++i, at += 12)
            cache.frames.back().push_back({real(at), real(at + 4), real(at + 8)});
    }
    return cache;
}

std::vector<std::uint32_t> readPermutation(const QString &path)
{
    std::vector<std::uint32_t> result;
    const QList<QByteArray> lines = readFile(path).split('\n');
    for (qsizetype i = 0; i + 1 < lines.size(); ++i) // behind the last end of line there is nothing
        result.push_back(lines[i].toUInt());
    return result;
}

double diagonalOf(const Frames &frames)
{
    double least[3], most[3];
    std::fill_n(least, 3, std::numeric_limits<double>::max());
    std::fill_n(most, 3, std::numeric_limits<double>::lowest());
    for (const auto &frame : frames)
        for (const model::Vec3f &p : frame) {
            const double value[3] = {p.x, p.y, p.z};
            for (int i = 0; i < 3; ++i) {
                least[i] = std::min(least[i], value[i]);
                most[i] = std::max(most[i], value[i]);
            }
        }
    return std::hypot(most[0] - least[0], most[1] - least[1], most[2] - least[2]);
}

Errors errorsBetween(const Frames &reference, const Frames &test, const std::vector<std::uint32_t> &permutation,
                     double diagonal)
{
    Errors errors;
    double squaredError = 0, squaredSpread = 0, count = 0;
    for (std::size_t f = 0; f < reference.size(); ++f) {
        double mean[3] = {};
        for (const model::Vec3f &p : reference[f]) {
            mean[0] += p.x / double(reference[f].size());
            mean[1] += p.y / double(reference[f].size());
            mean[2] += p.z / double(reference[f].size());
        }
        for (std::size_t i = 0; i < test[f].size(); ++i) {
            const model::Vec3f r = reference[f][permutation.empty() ? i : permutation[i]];
            const model::Vec3f t = test[f][i];
            const double distance = std::hypot(double(t.x) - r.x, double(t.y) - r.y, double(t.z) - r.z);
            squaredError += distance * distance;
            squaredSpread += std::pow(r.x - mean[0], 2) + std::pow(r.y - mean[1], 2) + std::pow(r.z - mean[2], 2);
            errors.largest = std::max(errors.largest, distance);
            ++count;
        }
    }
    errors.kgPercent = 100 * std::sqrt(squaredError / squaredSpread);
    errors.rmse = std::sqrt(squaredError / count);
    errors.psnr = 20 * std::log10((diagonal > 0 ? diagonal : diagonalOf(reference)) / errors.rmse);
    return errors;
}

QStringList contentsOf(const QString &folder)
{
    QStringList result;
    QDirIterator it(folder, QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
                    QDirIterator::Subdirectories);
    while (it.hasNext())
        result << QDir(folder).relativeFilePath(it.next());
    result.sort();
    return result;
}

} // namespace tests
