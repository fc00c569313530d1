// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/partcolors.h"

#include <array>

namespace views {

namespace {

bool isDark(const QPalette &palette)
{
    return palette.color(QPalette::Window).lightness() < 128;
}

} // namespace

const MarkColors &markColors(const QPalette &palette)
{
    static const MarkColors light{{0, 114, 178}, {213, 94, 0},  {0, 140, 100}, {204, 0, 51},
                                  {150, 0, 170}, {84, 39, 143}, {230, 140, 0}};
    static const MarkColors dark{{86, 180, 233},  {240, 130, 40},  {40, 200, 150}, {255, 80, 90},
                                 {255, 110, 255}, {190, 150, 255}, {240, 228, 66}};
    return isDark(palette) ? dark : light;
}

QRgb componentColor(std::uint32_t component)
{
    // Tableau's twenty by hue, the light and the dark one of each apart.
    static constexpr std::array<QRgb, 12> Colors{0xff4e79a7, 0xfff28e2b, 0xff59a14f, 0xffe15759,
                                                 0xff76b7b2, 0xffedc948, 0xffb07aa1, 0xffff9da7,
                                                 0xff9c755f, 0xffa0cbe8, 0xff8cd17d, 0xffbab0ac};
    return Colors[component % Colors.size()];
}

QRgb dimmed(QRgb color, const QPalette &palette)
{
    const int ground = isDark(palette) ? 70 : 205;
    const auto mix = [&](int value) { return (value + 5 * ground) / 6; };
    return qRgb(mix(qRed(color)), mix(qGreen(color)), mix(qBlue(color)));
}

} // namespace views
