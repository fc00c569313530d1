// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/svgpath.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace model::terrain {

namespace {

/// Chords of one curve at most; they halve the distance to it by four for each doubling.
constexpr int MostChords = 64;

Point2 mixed(Point2 a, Point2 b, double t)
{
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

struct Cubic
{
    Point2 from, control1, control2, to;

    Point2 at(double t) const
    {
        const Point2 a = mixed(from, control1, t), b = mixed(control1, control2, t), c = mixed(control2, to, t);
        return mixed(mixed(a, b, t), mixed(b, c, t), t);
    }
    /// A bound on its second derivative: n chords stay within it / (8 n^2).
    double bend() const
    {
        const auto second = [](Point2 a, Point2 b, Point2 c) {
            return 6 * std::hypot(a.x - 2 * b.x + c.x, a.y - 2 * b.y + c.y);
        };
        return std::max(second(from, control1, control2), second(control1, control2, to));
    }
};

class Parser
{
public:
    explicit Parser(std::string_view text)
        : mText(text)
    {}

    Result<void> parse()
    {
        skipSpace();
        if (mAt == mText.size() || (mText[mAt] != 'M' && mText[mAt] != 'm'))
            return unexpected("M");
        char command = 0;
        bool isClosed = false;
        while (skipSpace(), mAt < mText.size()) {
            if (std::isalpha(static_cast<unsigned char>(mText[mAt])))
                command = mText[mAt++];
            else if (command == 'Z' || command == 'z')
                return unexpected("a command");
            if (isClosed || (!mPieces.empty() && (command == 'M' || command == 'm')))
                return unexpected("one closed outline");
            if (command == 'Z' || command == 'z') {
                isClosed = true;
                continue;
            }
            if (const Result<void> done = step(command); !done)
                return done;
            // More coordinates after those of M are those of L.
            command = command == 'M' ? 'L' : command == 'm' ? 'l' : command;
        }
        return {};
    }

    Point2 start() const { return mStart; }
    const std::vector<Cubic> &pieces() const { return mPieces; }

private:
    Result<void> step(char command)
    {
        const bool isRelative = command >= 'a';
        const Point2 base = isRelative ? mPen : Point2{};
        double numbers[6] = {};
        const auto read = [&](int count) {
            for (int i = 0; i < count; ++i)
                if (!readNumber(numbers[i]))
                    return false;
            return true;
        };
        const auto point = [&](int i) { return Point2{base.x + numbers[i], base.y + numbers[i + 1]}; };
        switch (isRelative ? char(command - 'a' + 'A') : command) {
        case 'M':
            if (!read(2))
                return unexpected("a number");
            mStart = mPen = point(0);
            return {};
        case 'L':
            if (!read(2))
                return unexpected("a number");
            line(point(0));
            return {};
        case 'H':
            if (!read(1))
                return unexpected("a number");
            line({base.x + numbers[0], mPen.y});
            return {};
        case 'V':
            if (!read(1))
                return unexpected("a number");
            line({mPen.x, base.y + numbers[0]});
            return {};
        case 'C':
            if (!read(6))
                return unexpected("a number");
            curve({mPen, point(0), point(2), point(4)});
            return {};
        case 'Q': {
            if (!read(4))
                return unexpected("a number");
            const Point2 control = point(0), to = point(2);
            curve({mPen, mixed(mPen, control, 2.0 / 3), mixed(to, control, 2.0 / 3), to});
            return {};
        }
        default:
            --mAt;
            return unexpected("M, L, H, V, C, Q or Z");
        }
    }
    void line(Point2 to) { curve({mPen, mPen, to, to}, true); }
    void curve(Cubic cubic, bool isLine = false)
    {
        if (isLine)
            cubic = {cubic.from, mixed(cubic.from, cubic.to, 1.0 / 3), mixed(cubic.from, cubic.to, 2.0 / 3), cubic.to};
        mPieces.push_back(cubic);
        mPen = cubic.to;
    }

    void skipSpace()
    {
        while (mAt < mText.size() && (std::isspace(static_cast<unsigned char>(mText[mAt])) || mText[mAt] == ','))
            ++mAt;
    }
    bool readNumber(double &value)
    {
        skipSpace();
        if (mAt < mText.size() && mText[mAt] == '+')
            ++mAt;
        const auto [end, error] = std::from_chars(mText.data() + mAt, mText.data() + mText.size(), value);
        if (error != std::errc() || !std::isfinite(value))
            return false;
        mAt = std::size_t(end - mText.data());
        return true;
    }
    tl::unexpected<Error> unexpected(const char *wanted) const
    {
        const std::string found = mAt < mText.size() ? std::string(mText.substr(mAt, 12)) : "the end";
        return fail(ErrorCode::SyntaxError, wanted, found);
    }

    const std::string_view mText;
    std::size_t mAt = 0;
    Point2 mStart, mPen;
    std::vector<Cubic> mPieces;
};

} // namespace

Result<Outline> outlineFromSvgPath(std::string_view data, double tolerance)
{
    Parser parser(data);
    if (const Result<void> parsed = parser.parse(); !parsed)
        return fail(parsed.error());
    // The box of the control points bounds the size well enough to choose how fine the chords are.
    Point2 low = parser.start(), high = low;
    const auto grow = [&](Point2 p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    };
    for (const Cubic &cubic : parser.pieces())
        for (const Point2 p : {cubic.control1, cubic.control2, cubic.to})
            grow(p);
    const double chordError = std::max(tolerance, 1e-6) * std::hypot(high.x - low.x, high.y - low.y) / 2;
    std::vector<Point2> points{parser.start()};
    for (const Cubic &cubic : parser.pieces()) {
        const double wanted = chordError > 0 ? std::ceil(std::sqrt(cubic.bend() / (8 * chordError))) : 1;
        const int chords = int(std::clamp(wanted, 1.0, double(MostChords)));
        for (int i = 1; i <= chords; ++i)
            points.push_back(i == chords ? cubic.to : cubic.at(double(i) / chords));
    }
    low = high = points[0];
    for (const Point2 p : points)
        grow(p);
    const Point2 middle{low.x + (high.x - low.x) / 2, low.y + (high.y - low.y) / 2};
    double reach = 0;
    for (const Point2 p : points)
        reach = std::max(reach, std::hypot(p.x - middle.x, p.y - middle.y));
    if (reach > 0)
        for (Point2 &p : points)
            p = {(p.x - middle.x) / reach, (middle.y - p.y) / reach};
    return Outline::polygon(std::move(points));
}

} // namespace model::terrain
