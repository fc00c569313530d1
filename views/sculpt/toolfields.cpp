// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/toolfields.h"

#include "views/sculpt/toolvalues.h"

#include <QCoreApplication>

#include <algorithm>
#include <type_traits>

namespace views {

using namespace model::terrain;

namespace {

QString text(const char *source)
{
    return QCoreApplication::translate("ToolFields", source);
}
/// A metre, with a thin space before it as people write it.
QString metres()
{
    return QStringLiteral("m");
}
QString degrees()
{
    return QStringLiteral("°");
}

struct Span
{
    double min, max;
    int decimals;
    double step;
};
constexpr Span Share{0, 1, 2, 0.05};
constexpr Span Length{0, 1e6, 4, 0.01};
constexpr Span Radius{1e-4, 1e6, 4, 0.01};

/// A number of one kind of tool.
template <class T, class Get>
ToolField number(const QString &label, const QString &unit, const Span &span, Get member)
{
    ToolField field;
    field.label = label;
    field.unit = unit;
    field.min = span.min;
    field.max = span.max;
    field.decimals = span.decimals;
    field.step = span.step;
    field.value = [member](const Tool &tool) { return double(member(const_cast<T &>(std::get<T>(tool)))); };
    field.setValue = [member](Tool &tool, double value) {
        auto &target = member(std::get<T>(tool));
        target = static_cast<std::remove_reference_t<decltype(target)>>(value);
    };
    return field;
}

ToolField flag(const QString &label, std::function<bool(const Tool &)> value, std::function<void(Tool &, bool)> set)
{
    ToolField field;
    field.kind = ToolField::Kind::Flag;
    field.label = label;
    field.value = [value](const Tool &tool) { return double(value(tool)); };
    field.setValue = [set](Tool &tool, double isOn) { set(tool, isOn != 0); };
    return field;
}

ToolField choice(const QString &label, const QStringList &choices, std::function<int(const Tool &)> value,
                 std::function<void(Tool &, int)> set)
{
    ToolField field;
    field.kind = ToolField::Kind::Choice;
    field.label = label;
    field.choices = choices;
    field.value = [value](const Tool &tool) { return double(value(tool)); };
    field.setValue = [set](Tool &tool, double place) { set(tool, int(place)); };
    return field;
}

ToolField explained(ToolField field, const QString &hint)
{
    field.hint = hint;
    return field;
}

/// A height that may be fixed, and the field for it if it is.
template <class T, class Member>
void addLevel(std::vector<ToolField> &fields, const Tool &tool, const QString &label, Member member)
{
    fields.push_back(flag(
        label, [member](const Tool &t) { return member(const_cast<T &>(std::get<T>(t))).has_value(); },
        [member](Tool &t, bool isOn) {
            auto &level = member(std::get<T>(t));
            level = isOn ? std::optional(level.value_or(0)) : std::nullopt;
        }));
    if (!member(const_cast<T &>(std::get<T>(tool))))
        return;
    ToolField field;
    field.label = text(QT_TRANSLATE_NOOP("ToolFields", "Level"));
    field.unit = metres();
    field.min = -1e6;
    field.max = 1e6;
    field.decimals = 4;
    field.step = 0.01;
    field.value = [member](const Tool &t) { return member(const_cast<T &>(std::get<T>(t))).value_or(0); };
    field.setValue = [member](Tool &t, double value) { member(std::get<T>(t)) = value; };
    fields.push_back(field);
}

ToolField radiusField()
{
    ToolField field;
    field.label = text(QT_TRANSLATE_NOOP("ToolFields", "Radius"));
    field.unit = metres();
    field.min = Radius.min;
    field.max = Radius.max;
    field.decimals = Radius.decimals;
    field.step = Radius.step;
    field.value = radiusOf;
    field.setValue = setRadius;
    return field;
}

ToolField amountField(const Tool &tool)
{
    ToolField field;
    const bool isDepth = std::holds_alternative<Imprint>(tool) || std::holds_alternative<Rake>(tool) ||
                         std::holds_alternative<Lower>(tool) || std::holds_alternative<Scoop>(tool);
    const AmountKind kind = amountKindOf(tool);
    field.label = kind == AmountKind::Share         ? text(QT_TRANSLATE_NOOP("ToolFields", "Strength"))
                  : kind == AmountKind::CubicMetres ? text(QT_TRANSLATE_NOOP("ToolFields", "Volume"))
                  : isDepth                         ? text(QT_TRANSLATE_NOOP("ToolFields", "Depth"))
                                                    : text(QT_TRANSLATE_NOOP("ToolFields", "Height"));
    field.unit = kind == AmountKind::Metres        ? metres()
                 : kind == AmountKind::CubicMetres ? QStringLiteral("m³")
                                                   : QString();
    field.max = kind == AmountKind::Share ? 1 : 1e6;
    field.decimals = kind == AmountKind::CubicMetres ? 8 : kind == AmountKind::Share ? 2 : 5;
    field.step = kind == AmountKind::Share ? 0.05 : kind == AmountKind::CubicMetres ? 1e-5 : 0.001;
    field.value = amountOf;
    field.setValue = setAmount;
    return field;
}

void addImprint(std::vector<ToolField> &fields, const Tool &tool)
{
    const std::vector<Outline> outlines{Outline::disc(), Outline::square(), Outline::wedge()};
    const bool isOwn = std::find(outlines.begin(), outlines.end(), std::get<Imprint>(tool).outline) == outlines.end();
    QStringList shapes{text(QT_TRANSLATE_NOOP("ToolFields", "Disc")), text(QT_TRANSLATE_NOOP("ToolFields", "Square")),
                       text(QT_TRANSLATE_NOOP("ToolFields", "Wedge"))};
    if (isOwn)
        shapes << text(QT_TRANSLATE_NOOP("ToolFields", "Own outline"));
    fields.insert(fields.begin(),
                  choice(
                      text(QT_TRANSLATE_NOOP("ToolFields", "Shape")), shapes,
                      [outlines](const Tool &t) {
                          return int(std::find(outlines.begin(), outlines.end(), std::get<Imprint>(t).outline) -
                                     outlines.begin());
                      },
                      [outlines](Tool &t, int place) {
                          if (std::size_t(place) < outlines.size())
                              std::get<Imprint>(t).outline = outlines[std::size_t(place)];
                      }));
    fields.push_back(number<Imprint>(text(QT_TRANSLATE_NOOP("ToolFields", "Rotation")), degrees(), {-360, 360, 1, 5},
                                     [](Imprint &t) -> double & { return t.rotation; }));
    fields.push_back(flag(
        text(QT_TRANSLATE_NOOP("ToolFields", "Follow the stroke")),
        [](const Tool &t) { return std::get<Imprint>(t).doesFollowDirection; },
        [](Tool &t, bool isOn) { std::get<Imprint>(t).doesFollowDirection = isOn; }));
    addLevel<Imprint>(fields, tool, text(QT_TRANSLATE_NOOP("ToolFields", "Press to a fixed level")),
                      [](Imprint &t) -> std::optional<double> & { return t.level; });
    fields.push_back(explained(
        number<Imprint>(text(QT_TRANSLATE_NOOP("ToolFields", "Wall")), text(QT_TRANSLATE_NOOP("ToolFields", "radii")),
                        {0.001, 0.5, 3, 0.01}, [](Imprint &t) -> double & { return t.gap; }),
        text(QT_TRANSLATE_NOOP("ToolFields", "How far the sole's edge lies inside the outline"))));
    fields.push_back(flag(
        text(QT_TRANSLATE_NOOP("ToolFields", "Rim as the material makes it")),
        [](const Tool &t) { return std::get<Imprint>(t).isRimOfMaterial; },
        [](Tool &t, bool isOn) { std::get<Imprint>(t).isRimOfMaterial = isOn; }));
    fields.push_back(number<Imprint>(text(QT_TRANSLATE_NOOP("ToolFields", "Rim angle")), degrees(), {1, 89, 1, 1},
                                     [](Imprint &t) -> double & { return t.rim.criticalAngle; }));
    fields.push_back(
        explained(number<Imprint>(text(QT_TRANSLATE_NOOP("ToolFields", "Compression")), {}, Share,
                                  [](Imprint &t) -> double & { return t.rim.compressibility; }),
                  text(QT_TRANSLATE_NOOP("ToolFields", "The part of what is displaced that is pressed together"))));
    fields.push_back(flag(
        text(QT_TRANSLATE_NOOP("ToolFields", "Pen pressure: depth")),
        [](const Tool &t) { return std::get<Imprint>(t).doesPressureScaleDepth; },
        [](Tool &t, bool isOn) { std::get<Imprint>(t).doesPressureScaleDepth = isOn; }));
}

/// What all tools of a brush have.
void addBrush(std::vector<ToolField> &fields)
{
    const auto change = [](auto member) {
        return [member](Tool &t, auto value) {
            Brush brush = *brushOf(t);
            member(brush) = static_cast<std::remove_reference_t<decltype(member(brush))>>(value);
            setBrush(t, brush);
        };
    };
    fields.push_back(choice(
        text(QT_TRANSLATE_NOOP("ToolFields", "Falloff")),
        {text(QT_TRANSLATE_NOOP("ToolFields", "Constant")), text(QT_TRANSLATE_NOOP("ToolFields", "Linear")),
         text(QT_TRANSLATE_NOOP("ToolFields", "Smooth")), text(QT_TRANSLATE_NOOP("ToolFields", "Sphere")),
         text(QT_TRANSLATE_NOOP("ToolFields", "Tip"))},
        [](const Tool &t) { return int(brushOf(t)->falloff); },
        change([](Brush &b) -> Falloff & { return b.falloff; })));
    ToolField detail;
    detail.label = text(QT_TRANSLATE_NOOP("ToolFields", "Detail"));
    detail.unit = text(QT_TRANSLATE_NOOP("ToolFields", "radii"));
    detail.hint = text(QT_TRANSLATE_NOOP("ToolFields", "Vertices are added where they are farther apart"));
    detail.min = 0.01;
    detail.max = 1;
    detail.decimals = 3;
    detail.step = 0.01;
    detail.value = [](const Tool &t) { return brushOf(t)->detail; };
    detail.setValue = change([](Brush &b) -> double & { return b.detail; });
    fields.push_back(detail);
    fields.push_back(flag(
        text(QT_TRANSLATE_NOOP("ToolFields", "Pen pressure: radius")),
        [](const Tool &t) { return brushOf(t)->doesPressureScaleRadius; },
        change([](Brush &b) -> bool & { return b.doesPressureScaleRadius; })));
    fields.push_back(flag(
        text(QT_TRANSLATE_NOOP("ToolFields", "Pen pressure: strength")),
        [](const Tool &t) { return brushOf(t)->doesPressureScaleStrength; },
        change([](Brush &b) -> bool & { return b.doesPressureScaleStrength; })));
}

void addOwn(std::vector<ToolField> &fields, const Tool &tool)
{
    if (std::holds_alternative<Imprint>(tool))
        addImprint(fields, tool);
    if (std::holds_alternative<Rake>(tool))
        fields.push_back(number<Rake>(text(QT_TRANSLATE_NOOP("ToolFields", "Tines")), {}, {1, 200, 0, 1},
                                      [](Rake &t) -> std::uint32_t & { return t.tines; }));
    if (std::holds_alternative<Flatten>(tool))
        addLevel<Flatten>(fields, tool, text(QT_TRANSLATE_NOOP("ToolFields", "To a fixed level")),
                          [](Flatten &t) -> std::optional<double> & { return t.level; });
    if (std::holds_alternative<Noise>(tool)) {
        fields.push_back(number<Noise>(text(QT_TRANSLATE_NOOP("ToolFields", "Wavelength")), metres(), Radius,
                                       [](Noise &t) -> double & { return t.wavelength; }));
        fields.push_back(number<Noise>(text(QT_TRANSLATE_NOOP("ToolFields", "Octaves")), {}, {1, 16, 0, 1},
                                       [](Noise &t) -> std::uint32_t & { return t.octaves; }));
        fields.push_back(number<Noise>(text(QT_TRANSLATE_NOOP("ToolFields", "Seed")), {}, {0, 4294967295.0, 0, 1},
                                       [](Noise &t) -> std::uint32_t & { return t.seed; }));
    }
    if (std::holds_alternative<Ramp>(tool)) {
        addLevel<Ramp>(fields, tool, text(QT_TRANSLATE_NOOP("ToolFields", "Fixed start")),
                       [](Ramp &t) -> std::optional<double> & { return t.from; });
        addLevel<Ramp>(fields, tool, text(QT_TRANSLATE_NOOP("ToolFields", "Fixed end")),
                       [](Ramp &t) -> std::optional<double> & { return t.to; });
    }
    if (std::holds_alternative<Moisten>(tool))
        fields.push_back(number<Moisten>(text(QT_TRANSLATE_NOOP("ToolFields", "Humidity")), {}, Share,
                                         [](Moisten &t) -> double & { return t.humidity; }));
    if (std::holds_alternative<Breakline>(tool)) {
        fields.push_back(
            explained(number<Breakline>(text(QT_TRANSLATE_NOOP("ToolFields", "Spacing")), metres(), Length,
                                        [](Breakline &t) -> double & { return t.spacing; }),
                      text(QT_TRANSLATE_NOOP("ToolFields", "Of its vertices; 0: only the corners of your line"))));
        addLevel<Breakline>(fields, tool, text(QT_TRANSLATE_NOOP("ToolFields", "At a fixed level")),
                            [](Breakline &t) -> std::optional<double> & { return t.height; });
        fields.push_back(choice(
            text(QT_TRANSLATE_NOOP("ToolFields", "Where lines cross")),
            {text(QT_TRANSLATE_NOOP("ToolFields", "Refuse")),
             text(QT_TRANSLATE_NOOP("ToolFields", "Replace the other")),
             text(QT_TRANSLATE_NOOP("ToolFields", "Join both"))},
            [](const Tool &t) { return int(std::get<Breakline>(t).crossing); },
            [](Tool &t, int place) { std::get<Breakline>(t).crossing = Crossing(place); }));
    }
}

} // namespace

std::vector<ToolField> fieldsOf(const Tool &tool)
{
    std::vector<ToolField> fields;
    if (radiusOf(tool) > 0)
        fields.push_back(radiusField());
    if (amountKindOf(tool) != AmountKind::None)
        fields.push_back(amountField(tool));
    addOwn(fields, tool);
    if (brushOf(tool))
        addBrush(fields);
    return fields;
}

std::vector<ToolField> maskFieldsOf(const Tool &tool)
{
    if (!maskOf(tool))
        return {};
    std::vector<ToolField> fields;
    const auto add = [&](const char *label, const QString &unit, const Span &span, double Mask::*member) {
        ToolField field;
        field.label = text(label);
        field.unit = unit;
        field.min = span.min;
        field.max = span.max;
        field.decimals = span.decimals;
        field.step = span.step;
        // No limit is shown as the farthest one.
        field.value = [member, span](const Tool &t) { return std::clamp(maskOf(t)->*member, span.min, span.max); };
        field.setValue = [member, span](Tool &t, double value) {
            Mask mask = *maskOf(t);
            const bool isHeight = member == &Mask::lowestHeight || member == &Mask::highestHeight;
            mask.*member = isHeight && value <= span.min   ? -Mask::NoLimit
                           : isHeight && value >= span.max ? Mask::NoLimit
                                                           : value;
            setMask(t, mask);
        };
        fields.push_back(field);
    };
    constexpr Span Slope{0, 90, 1, 1}, Height{-1e5, 1e5, 3, 0.1};
    add(QT_TRANSLATE_NOOP("ToolFields", "Slope from"), degrees(), Slope, &Mask::lowestSlope);
    add(QT_TRANSLATE_NOOP("ToolFields", "Slope to"), degrees(), Slope, &Mask::highestSlope);
    add(QT_TRANSLATE_NOOP("ToolFields", "Height from"), metres(), Height, &Mask::lowestHeight);
    add(QT_TRANSLATE_NOOP("ToolFields", "Height to"), metres(), Height, &Mask::highestHeight);
    add(QT_TRANSLATE_NOOP("ToolFields", "Soft edge, slope"), degrees(), Slope, &Mask::slopeBlend);
    add(QT_TRANSLATE_NOOP("ToolFields", "Soft edge, height"), metres(), Length, &Mask::heightBlend);
    return fields;
}

} // namespace views
