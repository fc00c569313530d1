// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "model/animation/settingsfields.h"
#include "model/codec/animationcodec.h"

#include <QJsonArray>

namespace cli {

namespace {

struct Info
{
    InputOptions input;

    model::Result<void> run(Console &console) const;
};

QJsonArray jsonOf(model::Vec3f v)
{
    return {double(v.x), double(v.y), double(v.z)};
}

QString textOf(model::Vec3f v)
{
    return QStringLiteral("(%1, %2, %3)")
        .arg(double(v.x), 0, 'g', 5)
        .arg(double(v.y), 0, 'g', 5)
        .arg(double(v.z), 0, 'g', 5);
}

QString fromView(std::string_view text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

/// The settings of the codec; returns them as a text: "pca, basis 17 of 20, resolution 10000".
QString addSettings(const model::codec::DecodedAnimation &anim, QJsonObject &json)
{
    const model::CompressionSettings &settings = anim.settings();
    QString text = fromView(model::codecKey(settings.codec()));
    json["codec"] = text;
    model::visitFields(settings.method, [&](const auto &field, const auto &value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        QString shown = fromUtf8(model::fieldText(value));
        const QString key = fromView(field.key).replace('-', '_');
        if constexpr (std::is_arithmetic_v<Value>)
            json[key] = double(value);
        else
            json[key] = shown;
        if (field.key == "basis") {
            json["basis_wanted"] = double(value);
            json["basis"] = double(anim.basisSize());
            if (double(value) != double(anim.basisSize()))
                shown = QStringLiteral("%1 of %2").arg(anim.basisSize()).arg(shown);
        }
        text += QStringLiteral(", %1 %2").arg(fromView(field.key), shown);
    });
    if (settings.keepOrder)
        text += QStringLiteral(", order kept");
    json["keep_order"] = settings.keepOrder;
    return text;
}

/// What an .anim file adds to what every animation has.
model::Result<void> addEncoding(const model::codec::DecodedAnimation &anim, QJsonObject &json, QStringList &text)
{
    const double bytes = double(anim.encodedBytes());
    const auto chunks = model::codec::listChunks(anim.encoded());
    if (!chunks)
        return model::fail(chunks.error());
    QJsonObject sizes;
    QStringList sizeTexts;
    for (const model::codec::ChunkInfo &chunk : *chunks) {
        const QString tag = fromUtf8(chunk.tag);
        sizes[tag] = sizes[tag].toDouble() + double(chunk.bytes);
        sizeTexts << QStringLiteral("%1 %2").arg(tag).arg(chunk.bytes);
    }
    json["bytes"] = bytes;
    const auto prefixes = anim.prefixBytes();
    if (!prefixes.empty()) {
        QJsonArray list;
        for (std::size_t k = 0; k < prefixes.size(); ++k)
            list.append(QJsonObject{{"basis", double(k)}, {"bytes", double(prefixes[k])}});
        json["prefixes"] = list;
    }
    json["ratio"] = rawBytes(anim) / bytes;
    json["bpfv"] = bitsPerFrameAndVertex(bytes, anim);
    const QString codec = addSettings(anim, json);
    json["creator"] = fromUtf8(anim.creator());
    json["chunks"] = sizes;
    text << QStringLiteral("file          %1, %2 times smaller than float32, %3 bits per frame and vertex")
                .arg(sizeText(bytes))
                .arg(rawBytes(anim) / bytes, 0, 'f', 1)
                .arg(bitsPerFrameAndVertex(bytes, anim), 0, 'f', 3)
         << QStringLiteral("codec         %1").arg(codec)
         << QStringLiteral("creator       %1").arg(fromUtf8(anim.creator()))
         << QStringLiteral("chunks        %1 (bytes)").arg(sizeTexts.join(QStringLiteral(", ")));
    if (prefixes.size() > 1)
        text << QStringLiteral("progressive   first picture after %1 bytes, half of the trajectories after %2")
                    .arg(prefixes[0])
                    .arg(prefixes[prefixes.size() / 2]);
    return {};
}

model::Result<void> Info::run(Console &console) const
{
    const auto read = input.read(console.progress("Reading"));
    if (!read)
        return model::fail(read.error());
    const model::FrameSource &source = **read;
    const auto box = model::boundingBoxOfAll(source, console.progress("Measuring"));
    if (!box)
        return model::fail(box.error());

    QJsonObject json{{"name", fromUtf8(source.name())},
                     {"vertices", double(source.vertexCount())},
                     {"triangles", double(source.connectivity().triangles.size())},
                     {"frames", double(source.frameCount())},
                     {"frame_rate", source.frameRate()},
                     {"duration_seconds", source.frameCount() / source.frameRate()},
                     {"raw_bytes", rawBytes(source)},
                     {"box", QJsonObject{{"min", jsonOf(box->min)}, {"max", jsonOf(box->max)}}}};
    QStringList text{
        QStringLiteral("name          %1").arg(fromUtf8(source.name())),
        QStringLiteral("vertices      %1").arg(source.vertexCount()),
        QStringLiteral("triangles     %1").arg(source.connectivity().triangles.size()),
        QStringLiteral("frames        %1 at %2 per second, %3 s")
            .arg(source.frameCount())
            .arg(source.frameRate())
            .arg(source.frameCount() / source.frameRate(), 0, 'f', 2),
        QStringLiteral("box           %1 .. %2").arg(textOf(box->min), textOf(box->max)),
        QStringLiteral("as float32    %1").arg(sizeText(rawBytes(source))),
    };
    if (const auto *anim = dynamic_cast<const model::codec::DecodedAnimation *>(&source))
        if (const auto added = addEncoding(*anim, json, text); !added)
            return added;

    console.data(json, text);
    return {};
}

} // namespace

void addInfo(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("info", "Say what an animation holds");
    const auto options = std::make_shared<Info>();
    options->input.addTo(*command);
    command->footer("Examples:\n"
                    "  sandreel-cli info walk.anim\n"
                    "  sandreel-cli --json info frames/");
    onCall(*command, options, run);
}

} // namespace cli
