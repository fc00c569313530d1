// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/device/trajectory.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace model::haptics {

namespace {

constexpr std::size_t LargestTrajectory = 1'000'000;
constexpr double LargestPosition = 10;

/// Takes the next word off `line`.
std::string_view nextWord(std::string_view &line)
{
    constexpr std::string_view Blanks = " \t\r";
    line.remove_prefix(std::min(line.find_first_not_of(Blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(Blanks));
    line.remove_prefix(word.size());
    return word;
}

template <class Number>
bool parse(std::string_view word, Number &number)
{
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size();
}

Result<Trajectory::Point> parsePoint(std::string_view line)
{
    Trajectory::Point point;
    for (double *const number : {&point.time, &point.position.x, &point.position.y, &point.position.z})
        if (const std::string_view word = nextWord(line); !parse(word, *number))
            return fail(ErrorCode::SyntaxError, "a number", std::string(word));
    if (const std::string_view word = nextWord(line); !word.empty() && !parse(word, point.buttons))
        return fail(ErrorCode::SyntaxError, "a number of buttons", std::string(word));
    if (const std::string_view word = nextWord(line); !word.empty())
        return fail(ErrorCode::SyntaxError, "the end of the line", std::string(word));
    for (const double value : {point.position.x, point.position.y, point.position.z})
        if (!(std::abs(value) <= LargestPosition))
            return fail(ErrorCode::BadValue, "position", std::to_string(value), "-10 ... 10");
    return point;
}

} // namespace

Trajectory::Point Trajectory::at(double time) const
{
    const auto after = std::upper_bound(mPoints.begin(), mPoints.end(), time,
                                        [](double t, const Point &point) { return t < point.time; });
    if (after == mPoints.begin())
        return mPoints.front();
    const Point &from = *(after - 1);
    if (after == mPoints.end())
        return from;
    const double t = (time - from.time) / (after->time - from.time);
    return {time, from.position * (1 - t) + after->position * t, from.buttons};
}

Result<Trajectory> parseTrajectory(std::string_view text)
{
    std::vector<Trajectory::Point> points;
    for (std::uint64_t number = 1; !text.empty(); ++number) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, length);
        text.remove_prefix(std::min(length + 1, text.size()));
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(" \t\r") == line.npos)
            continue;
        auto point = parsePoint(line);
        if (!point)
            return fail(std::move(point).error().atLine(number));
        const double earliest = points.empty() ? 0 : points.back().time;
        if (!(point->time >= earliest) || !std::isfinite(point->time))
            return fail(Error{ErrorCode::BadValue,
                              {"time", std::to_string(point->time), "at least " + std::to_string(earliest)},
                              {},
                              number,
                              Error::None});
        if (points.size() == LargestTrajectory)
            return fail(ErrorCode::LimitExceeded, "number of points", "more", std::to_string(LargestTrajectory));
        points.push_back(*point);
    }
    if (points.empty())
        return fail(ErrorCode::SyntaxError, "a line of numbers", "none");
    return Trajectory(std::move(points));
}

Trajectory pressTrajectory()
{
    return Trajectory({{0.0, {0, 0, 0.010}, 0},
                       {2.5, {0, 0, 0.004}, 0}, // above the ground until the forces have come up
                       {3.0, {0, 0, 0.004}, 0},
                       {4.5, {0, 0, -0.030}, 1},     // pressed in
                       {5.5, {0, 0, -0.030}, 1},     // held
                       {7.0, {0.040, 0, -0.030}, 1}, // ploughed
                       {8.0, {0.040, 0, -0.030}, 1}, // held
                       {9.0, {0.040, 0, 0.020}, 0},  // and out
                       {9.5, {0.040, 0, 0.020}, 0}});
}

} // namespace model::haptics
