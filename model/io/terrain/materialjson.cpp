// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/materialjson.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

namespace model::io {

using terrain::CriticalAngle;
using terrain::Material;

namespace {

struct Field
{
    const char *key;
    double Material::*member;
};

constexpr Field Fields[] = {
    {"humidity", &Material::humidity},
    {"bulk_density", &Material::bulkDensity},
    {"compressibility", &Material::compressibility},
    {"inside_slope", &Material::insideSlope},
    {"outside_slope", &Material::outsideSlope},
    {"roughness", &Material::roughness},
    {"liquidity", &Material::liquidity},
    {"compression", &Material::compression},
};

std::string textOf(const QJsonValue &value)
{
    const QByteArray text = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
    return text.mid(1, text.size() - 2).toStdString();
}

} // namespace

QJsonObject jsonOf(const Material &material)
{
    QJsonArray curve;
    for (const CriticalAngle &point : material.criticalAngles)
        curve.append(QJsonArray{point.humidity, point.degrees});
    QJsonObject json{{"name", QString::fromStdString(material.name)}, {"critical_angles", curve}};
    for (const Field &field : Fields)
        json[QLatin1String(field.key)] = material.*field.member;
    return json;
}

Result<void> readMaterial(const QJsonObject &json, Material &material)
{
    if (const QJsonValue name = json["name"]; name.isString())
        material.name = name.toString().toStdString();
    else if (!name.isUndefined())
        return fail(ErrorCode::BadSetting, "name", textOf(name), QT_TRANSLATE_NOOP("ErrorText", "a text"));
    for (const Field &field : Fields) {
        const QJsonValue value = json[QLatin1String(field.key)];
        if (value.isUndefined())
            continue;
        if (!value.isDouble())
            return fail(ErrorCode::BadSetting, field.key, textOf(value), QT_TRANSLATE_NOOP("ErrorText", "a number"));
        material.*field.member = value.toDouble();
    }
    const QJsonValue curve = json["critical_angles"];
    if (!curve.isUndefined()) {
        const auto refuse = [&] {
            return fail(ErrorCode::BadSetting, "critical_angles", textOf(curve),
                        QT_TRANSLATE_NOOP("ErrorText", "a list of [humidity, degrees]"));
        };
        material.criticalAngles.clear();
        if (!curve.isArray() || std::size_t(curve.toArray().size()) > terrain::LargestCurve)
            return refuse();
        const QJsonArray points = curve.toArray();
        for (const QJsonValue &point : points) {
            const QJsonArray pair = point.toArray();
            if (pair.size() != 2 || !pair[0].isDouble() || !pair[1].isDouble())
                return refuse();
            material.criticalAngles.push_back({pair[0].toDouble(), pair[1].toDouble()});
        }
    }
    return check(material);
}

} // namespace model::io
