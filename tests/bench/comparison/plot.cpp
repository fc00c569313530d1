// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/comparison/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace bench {

namespace {

// Okabe and Ito 2008: told apart by colour-blind readers too; each line has a mark of its own beside that.
struct Style
{
    const char *colour;
    const char *dash;
    char mark; ///< c: disc, s: square, d: diamond, t: triangle
};
constexpr std::array<Style, 8> Styles{{
    {"#d55e00", "", 'c'},
    {"#0072b2", "", 's'},
    {"#009e73", "", 'd'},
    {"#cc79a7", "", 't'},
    {"#000000", "", 'c'},
    {"#000000", "5 4", 's'},
    {"#b08900", "", 'd'},
    {"#56b4e9", "", 't'},
}};

constexpr double PanelWidth = 380, PanelHeight = 300;
constexpr double Left = 62, Right = 14, Top = 34, Bottom = 50;
constexpr std::size_t Columns = 3;

struct Axis
{
    double least = 1e300, most = 0; ///< of the values

    void take(double value)
    {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    /// Room to both sides.
    void widen()
    {
        if (most <= 0)
            least = 0.1, most = 10;
        least /= 1.35;
        most *= 1.35;
    }
    double share(double value) const { return std::log(value / least) / std::log(most / least); }
    /// 1, 2 and 5 times powers of ten.
    std::vector<double> ticks() const
    {
        std::vector<double> result;
        for (int power = int(std::floor(std::log10(least))); power <= int(std::ceil(std::log10(most))); ++power)
            for (const double digit : {1.0, 2.0, 5.0})
                if (const double value = digit * std::pow(10.0, power); value >= least && value <= most)
                    result.push_back(value);
        return result;
    }
};

template <class... Args>
std::string text(const char *format, Args... args)
{
    std::array<char, 512> buffer;
    std::snprintf(buffer.data(), buffer.size(), format, args...);
    return buffer.data();
}

std::string escaped(const std::string &plain)
{
    std::string result;
    for (const char c : plain)
        result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return result;
}

std::string mark(char shape, double x, double y, const char *colour)
{
    switch (shape) {
    case 'c':
        return text("<circle cx='%.1f' cy='%.1f' r='4' fill='%s'/>\n", x, y, colour);
    case 's':
        return text("<rect x='%.1f' y='%.1f' width='7' height='7' fill='%s'/>\n", x - 3.5, y - 3.5, colour);
    case 'd':
        return text("<path d='M%.1f %.1fl5 5l-5 5l-5 -5z' fill='%s'/>\n", x, y - 5, colour);
    default:
        return text("<path d='M%.1f %.1fl4.8 8.4h-9.6z' fill='%s'/>\n", x, y - 5, colour);
    }
}

class Plot
{
public:
    explicit Plot(const std::vector<RatePanel> &panels)
        : mPanels(panels)
    {
        for (const RatePanel &panel : panels)
            for (const RateLine &line : panel.lines) {
                if (std::find(mCodecs.begin(), mCodecs.end(), line.codec) == mCodecs.end())
                    mCodecs.push_back(line.codec);
                for (const auto &[bpfv, percent] : line.points) {
                    mX.take(bpfv);
                    mY.take(percent);
                }
            }
        mX.widen();
        mY.widen();
    }

    std::string draw() const
    {
        const std::size_t cells = mPanels.size() + 1; // the legend has one
        const double width = PanelWidth * double(std::min(cells, Columns));
        const double height = PanelHeight * double((cells + Columns - 1) / Columns);
        std::string svg = text("<svg xmlns='http://www.w3.org/2000/svg' width='%.0f' height='%.0f' viewBox='0 0 %.0f "
                               "%.0f' font-family='DejaVu Sans, sans-serif' font-size='12'>\n"
                               "<rect width='100%%' height='100%%' fill='white'/>\n",
                               width, height, width, height);
        for (std::size_t i = 0; i <= mPanels.size(); ++i) {
            svg += text("<g transform='translate(%.0f %.0f)'>\n", PanelWidth * double(i % Columns),
                        PanelHeight * double(i / Columns));
            svg += i < mPanels.size() ? panel(mPanels[i]) : legend();
            svg += "</g>\n";
        }
        return svg + "</svg>\n";
    }

private:
    double x(double bpfv) const { return Left + mX.share(bpfv) * (PanelWidth - Left - Right); }
    double y(double percent) const { return Top + (1 - mY.share(percent)) * (PanelHeight - Top - Bottom); }
    const Style &styleOf(const std::string &codec) const
    {
        const auto at = std::find(mCodecs.begin(), mCodecs.end(), codec) - mCodecs.begin();
        return Styles[std::size_t(at) % Styles.size()];
    }

    std::string axes() const
    {
        const double bottom = PanelHeight - Bottom, right = PanelWidth - Right;
        std::string svg;
        for (const double tick : mX.ticks()) {
            svg += text("<path d='M%.1f %.1fV%.1f' stroke='#dddddd'/>\n", x(tick), Top, bottom);
            svg += text("<text x='%.1f' y='%.1f' text-anchor='middle' font-size='11'>%g</text>\n", x(tick), bottom + 15,
                        tick);
        }
        for (const double tick : mY.ticks()) {
            svg += text("<path d='M%.1f %.1fH%.1f' stroke='#dddddd'/>\n", Left, y(tick), right);
            svg += text("<text x='%.1f' y='%.1f' text-anchor='end' font-size='11'>%g</text>\n", Left - 6, y(tick) + 4,
                        tick);
        }
        svg += text("<rect x='%.1f' y='%.1f' width='%.1f' height='%.1f' fill='none' stroke='#555555'/>\n", Left, Top,
                    right - Left, bottom - Top);
        svg += text("<text x='%.1f' y='%.1f' text-anchor='middle'>bits per frame and vertex</text>\n",
                    (Left + right) / 2, bottom + 34);
        svg += text("<text transform='translate(%.1f %.1f) rotate(-90)' text-anchor='middle'>KG error, %%</text>\n",
                    16.0, (Top + bottom) / 2);
        return svg;
    }

    std::string panel(const RatePanel &panel) const
    {
        std::string svg = text("<text x='%.1f' y='%.1f' text-anchor='middle' font-size='14' font-weight='bold'>",
                               (Left + PanelWidth - Right) / 2, Top - 11) +
                          escaped(panel.title) + "</text>\n" + axes();
        for (const RateLine &line : panel.lines) {
            const Style &style = styleOf(line.codec);
            std::string path, marks;
            for (const auto &[bpfv, percent] : line.points) {
                path += text("%c%.1f %.1f", path.empty() ? 'M' : 'L', x(bpfv), y(percent));
                marks += mark(style.mark, x(bpfv), y(percent), style.colour);
            }
            svg += "<path d='" + path +
                   text("' fill='none' stroke='%s' stroke-width='1.8' stroke-dasharray='%s'/>\n", style.colour,
                        *style.dash ? style.dash : "none") +
                   marks;
        }
        return svg;
    }

    std::string legend() const
    {
        std::string svg;
        double at = Top + 14;
        for (const std::string &codec : mCodecs) {
            const Style &style = styleOf(codec);
            svg += text("<path d='M%.1f %.1fh36' stroke='%s' stroke-width='1.8' stroke-dasharray='%s'/>\n", Left, at,
                        style.colour, *style.dash ? style.dash : "none");
            svg += mark(style.mark, Left + 18, at, style.colour);
            svg += text("<text x='%.1f' y='%.1f'>", Left + 46, at + 4) + escaped(codec) + "</text>\n";
            at += 24;
        }
        return svg + text("<text x='%.1f' y='%.1f' font-size='11' fill='#555555'>Whole files. Left and below is "
                          "better.</text>\n",
                          Left, at + 8);
    }

    const std::vector<RatePanel> &mPanels;
    std::vector<std::string> mCodecs;
    Axis mX, mY;
};

} // namespace

std::string ratePlot(const std::vector<RatePanel> &panels)
{
    return Plot(panels).draw();
}

} // namespace bench
