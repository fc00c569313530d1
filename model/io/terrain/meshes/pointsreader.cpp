// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/meshes/pointsreader.h"

#include "model/io/failure.h"

#include <charconv>
#include <cmath>

#include <QCoreApplication>

namespace model::io {

namespace {

bool isGap(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';';
}

/// The first three numbers of a line; -1, 0 ... 2: how many there are before something else (-1: nothing at all).
int parseLine(std::string_view line, double (&values)[3])
{
    int count = 0;
    const char *p = line.data(), *const end = p + line.size();
    while (count < 3) {
        while (p != end && isGap(*p))
            ++p;
        if (p == end)
            return count == 0 ? -1 : count;
        const char *const begin = *p == '+' ? p + 1 : p;
        const auto [after, error] = std::from_chars(begin, end, values[count]);
        if (error == std::errc::invalid_argument || (after != end && !isGap(*after)))
            return count;
        if (error == std::errc::result_out_of_range)
            values[count] = INFINITY;
        ++count;
        p = after;
    }
    return count;
}

} // namespace

Result<std::vector<terrain::Point3>> parsePoints(std::string_view text, const Progress &progress)
{
    constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(ByteOrderMark))
        text.remove_prefix(ByteOrderMark.size());
    std::vector<terrain::Point3> points;
    std::uint64_t lineNumber = 0;
    bool mayBeHeader = true;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        begin = end + 1;
        ++lineNumber;
        if (lineNumber % (1 << 16) == 0) {
            if (progress.isCancelled())
                return fail(ErrorCode::Cancelled);
            progress.report(double(begin) / double(text.size()));
        }
        double values[3] = {};
        const int count = parseLine(line, values);
        const std::size_t first = line.find_first_not_of(" \t");
        const bool isComment = first != line.npos && (line[first] == '#' || line.substr(first, 2) == "//");
        if (count < 0 || isComment)
            continue;
        if (count == 0 && mayBeHeader) {
            mayBeHeader = false;
            continue;
        }
        mayBeHeader = false;
        if (count < 3)
            return failAtLine(lineNumber, ErrorCode::SyntaxError, QT_TRANSLATE_NOOP("ErrorText", "a coordinate"),
                              std::string(line.substr(0, 40)));
        for (const double value : values)
            if (!std::isfinite(value))
                return failAtLine(lineNumber, ErrorCode::NonFinite, "point " + std::to_string(points.size()));
        points.push_back({values[0], values[1], values[2]});
    }
    if (points.empty())
        return fail(ErrorCode::NoVertices);
    return points;
}

} // namespace model::io
