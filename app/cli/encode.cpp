// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/outputs.h"
#include "app/cli/settingsoptions.h"
#include "model/animation/editedframes.h"
#include "model/animation/metrics.h"
#include "model/animation/settingsfields.h"
#include "model/codec/ratecontrol.h"
#include "model/io/animfile.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QJsonValue>

#include <cmath>

namespace cli {

namespace {

struct Encode
{
    InputOptions input;
    NormaliseOption normalise;
    SettingsOptions compression;
    std::string output, permutation, name;
    bool measure = false;

    model::Result<void> run(Console &console) const;
    model::Result<model::codec::EncodedAnimation>
    encodeAs(const model::FrameSource &source, model::CompressionSettings &settings, Console &console) const;
    model::Result<void> writePermutation(const std::vector<std::uint32_t> &order) const;
    model::FrameSourcePtr named(model::FrameSourcePtr source) const;
};

/// The animation under the name and rate that were asked for.
model::FrameSourcePtr Encode::named(model::FrameSourcePtr source) const
{
    std::string title = !name.empty() ? name : source->name();
    if (title.empty())
        title = QFileInfo(fromUtf8(input.path)).completeBaseName().toStdString();
    const double rate = input.frameRate > 0 ? input.frameRate : source->frameRate();
    // A reader may have given the rate already; only one layer of edits lets an .anim below be recognised.
    if (const auto *edited = dynamic_cast<const model::EditedFrames *>(source.get()); edited && edited->keepsFrames())
        source = edited->source();
    return std::make_shared<model::EditedFrames>(source, model::TimeMap::identity(source->frameCount()),
                                                 model::Similarity(), rate, std::move(title));
}

model::Result<void> Encode::writePermutation(const std::vector<std::uint32_t> &order) const
{
    std::string text;
    for (const std::uint32_t index : order)
        text += std::to_string(index) + '\n';
    return model::io::saveBytes(fromUtf8(permutation),
                                {reinterpret_cast<const std::uint8_t *>(text.data()), text.size()});
}

/// With these settings, or with those that a target was met by, which `settings` then become.
model::Result<model::codec::EncodedAnimation>
Encode::encodeAs(const model::FrameSource &source, model::CompressionSettings &settings, Console &console) const
{
    // An .anim that already has these settings keeps its stream: encoding it once more would only lose more.
    if (!compression.target())
        return model::io::encodeEdited(source, settings, console.progress("Encoding"));
    auto found = model::codec::encodeToTarget(source, settings.codec(), settings.keepOrder, *compression.target(),
                                              console.progress("Searching"));
    if (!found)
        return model::fail(std::move(found.error()));
    settings = found->settings;
    return std::move(found->encoded);
}

model::Result<void> Encode::run(Console &console) const
{
    if (endingOf(output) != QLatin1String("anim"))
        return model::fail(model::ErrorCode::BadSetting, "--output", output, "a name that ends in .anim");
    auto settings = compression.settings();
    if (!settings)
        return model::fail(settings.error());
    if (auto checked =
            checkOutputs({{"--output", output}, {"--permutation", permutation}}, {input.path, input.baseMesh});
        !checked)
        return checked;
    const auto read = input.read(console.progress("Reading"));
    if (!read)
        return model::fail(read.error());
    const auto normalised = normalise.apply(*read, console.progress("Measuring"));
    if (!normalised)
        return model::fail(normalised.error());
    const model::FrameSourcePtr source = named(*normalised);

    QElapsedTimer clock;
    clock.start();
    const auto encoded = encodeAs(*source, *settings, console);
    if (!encoded)
        return model::fail(encoded.error());
    const double seconds = double(clock.elapsed()) / 1000;
    const double bytes = double(encoded->bytes.size());

    QJsonObject json{{"output", fromUtf8(output)},
                     {"bytes", bytes},
                     {"raw_bytes", rawBytes(*source)},
                     {"ratio", rawBytes(*source) / bytes},
                     {"bpfv", bitsPerFrameAndVertex(bytes, *source)},
                     {"vertices", double(source->vertexCount())},
                     {"triangles", double(source->connectivity().triangles.size())},
                     {"frames", double(source->frameCount())},
                     {"encode_seconds", seconds},
                     {"settings", fromUtf8(model::settingsText(*settings))}};
    QStringList text{QStringLiteral("%1: %2, %3 times smaller than float32, %4 bits per frame and vertex")
                         .arg(fromUtf8(output), sizeText(bytes))
                         .arg(rawBytes(*source) / bytes, 0, 'f', 1)
                         .arg(bitsPerFrameAndVertex(bytes, *source), 0, 'f', 3)};
    if (compression.target())
        text << QStringLiteral("Settings: %1").arg(fromUtf8(model::settingsText(*settings)));

    if (measure) {
        const auto decoded =
            model::codec::decodeAnimation(encoded->bytes, console.progress("Decoding"),
                                          model::codec::DecodeLimits::ofThisMachine(encoded->bytes.size()));
        if (!decoded)
            return model::fail(decoded.error());
        const auto lost =
            model::compareAnimations(*source, **decoded, encoded->permutation, console.progress("Comparing"));
        if (!lost)
            return model::fail(lost.error());
        json["kg_error_percent"] = lost->kgErrorPercent;
        json["rmse"] = lost->rmse;
        json["psnr_db"] = std::isfinite(lost->psnrDb) ? QJsonValue(lost->psnrDb) : QJsonValue();
        json["max_vertex_error"] = lost->maxVertexError;
        text << QStringLiteral("KG error %1 %, RMSE %2, largest vertex error %3")
                    .arg(lost->kgErrorPercent, 0, 'g', 4)
                    .arg(lost->rmse, 0, 'g', 4)
                    .arg(lost->maxVertexError, 0, 'g', 4);
    }

    if (console.isInterrupted())
        return model::fail(model::ErrorCode::Cancelled);
    RemoveUnlessKept partial(permutation);
    if (!permutation.empty())
        if (auto written = writePermutation(encoded->permutation); !written)
            return written;
    if (auto saved = model::io::saveBytes(fromUtf8(output), encoded->bytes); !saved)
        return saved;
    partial.keep();
    console.data(json, text);
    return {};
}

} // namespace

void addEncode(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("encode", "Turn an animation into a small .anim file");
    const auto options = std::make_shared<Encode>();
    options->input.addTo(*command);
    command->add_option("-o,--output", options->output, "The .anim file to write")->required()->type_name("FILE");
    options->compression.addTo(*command);
    options->normalise.addTo(*command, "Fit the first frame, or all of them, into the cube -1..1 (default: none)");
    command->add_option("--fps", options->input.frameRate, "Frames per second; a scene is sampled at this rate")
        ->check(finiteRange(0.001, 1000))
        ->type_name("N");
    command->add_option("--name", options->name, "Name of the animation (default: the input's)")->type_name("TEXT");
    command
        ->add_option(
            "--permutation", options->permutation,
            "Also write the order of the vertices: a line for each decoded vertex, with its index in the input,\n"
            "counted from 0")
        ->type_name("FILE");
    command->add_flag("--measure", options->measure, "Decode again and print the errors");
    command->footer("Examples:\n"
                    "  sandreel-cli encode frames/ -o walk.anim\n"
                    "  sandreel-cli encode walk.pc2 --base-mesh walk.obj -o walk.anim --basis 40 --measure\n"
                    "  sandreel-cli encode frames/ -o walk.anim --max-kg-error 0.5\n"
                    "  sandreel-cli encode frames/ -o walk.anim --codec direct --resolution 16384 --predictor N\n"
                    "  sandreel-cli encode robot.glb --animation 2 --fps 30 --normalize all -o robot.anim");
    onCall(*command, options, run);
}

} // namespace cli
