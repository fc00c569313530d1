// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/setcompression.h"

#include "model/animation/settingsfields.h"

#include <QCoreApplication>
#include <QLocale>

namespace commands {

namespace {

/// "Set Basis Size to 30"; empty for a field without a name of its own.
QString textForField(std::string_view key, const QString &value)
{
    if (key == "basis")
        return QCoreApplication::translate("Undo", "Set Basis Size to %1").arg(value);
    if (key == "resolution")
        return QCoreApplication::translate("Undo", "Set Resolution to %1").arg(value);
    if (key == "step")
        return QCoreApplication::translate("Undo", "Set Step to %1").arg(value);
    if (key == "basis-step")
        return QCoreApplication::translate("Undo", "Set Basis Step to %1").arg(value);
    return {};
}

QString shown(std::uint32_t value)
{
    return QLocale().toString(value);
}

QString shown(double value)
{
    return QLocale().toString(value);
}

template <class Choice>
QString shown(Choice value)
{
    return QString::fromStdString(model::fieldText(value));
}

QString textFor(const model::CompressionSettings &present, const model::CompressionSettings &wanted)
{
    QString text;
    // Named after a field if that alone changes.
    model::visitFields(wanted.method, [&](const auto &wantedField, const auto &wantedValue) {
        model::CompressionSettings alone = present;
        model::visitFields(alone.method, [&](const auto &field, auto &value) {
            if constexpr (std::is_assignable_v<decltype(value), decltype(wantedValue)>)
                if (field.key == wantedField.key)
                    value = wantedValue;
        });
        if (alone == wanted && text.isEmpty())
            text = textForField(wantedField.key, shown(wantedValue));
    });
    return text.isEmpty() ? QCoreApplication::translate("Undo", "Change Compression") : text;
}

} // namespace

SetCompression::SetCompression(model::AnimationDocument &document, const model::CompressionSettings &settings,
                               GestureId gesture)
    : ChangeCompression(document, textFor(document.compression(), settings), settings, MergeId::SetCompression, gesture)
{}

} // namespace commands
