// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/terrain/profilecsv.h"

#include <QLocale>

#include <algorithm>

namespace views {

using namespace model::terrain;

QString profileCsv(std::span<const ProfilePoint> now, std::span<const ProfilePoint> before)
{
    std::vector<double> distances;
    for (const auto curve : {now, before})
        for (const ProfilePoint &point : curve)
            distances.push_back(point.distance);
    std::sort(distances.begin(), distances.end());
    distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
    const auto number = [](std::optional<double> value) {
        return value ? QString::number(*value, 'g', QLocale::FloatingPointShortest) : QString();
    };
    QString text =
        before.empty() ? QStringLiteral("distance_m,height_m\n") : QStringLiteral("distance_m,height_m,reference_m\n");
    for (const double distance : distances) {
        text += number(distance) + QLatin1Char(',') + number(heightAt(now, distance));
        if (!before.empty())
            text += QLatin1Char(',') + number(heightAt(before, distance));
        text += QLatin1Char('\n');
    }
    return text;
}

} // namespace views
