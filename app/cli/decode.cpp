// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/outputs.h"
#include "model/io/animationwriter.h"
#include "model/io/animfile.h"

#include <QFileInfo>

#include <optional>

namespace cli {

namespace {

struct Decode
{
    InputOptions input;
    std::string output, mesh;
    model::io::MeshFormat format = model::io::MeshFormat::Obj;
    std::uint64_t bytes = 0; ///< 0: the whole file

    model::Result<void> run(Console &console) const;
    model::Result<model::io::AnimPrefix> readPrefix(Console &console) const;
    model::Result<model::FrameSourcePtr> readAll(Console &console) const;
};

model::Result<model::io::MeshFormat> meshFormatOf(const QString &path)
{
    const QString ending = endingOf(path.toStdString());
    if (ending == QLatin1String("obj"))
        return model::io::MeshFormat::Obj;
    if (ending == QLatin1String("off"))
        return model::io::MeshFormat::Off;
    if (ending == QLatin1String("ply"))
        return model::io::MeshFormat::Ply;
    return model::fail(model::ErrorCode::BadSetting, "--mesh", path.toStdString(), ".obj, .off, .ply");
}

model::Result<model::io::AnimPrefix> Decode::readPrefix(Console &console) const
{
    const QString path = fromUtf8(input.path);
    const auto notBytes = [&](const QString &allowed) {
        return model::fail(model::ErrorCode::BadSetting, "--bytes", std::to_string(bytes), allowed.toStdString());
    };
    if (endingOf(input.path) != QLatin1String("anim"))
        return notBytes(QStringLiteral("with an .anim file of codec reel"));
    auto prefix = model::io::openAnimPrefix(path, bytes, console.progress("Reading"));
    if (prefix || prefix.error().code != model::ErrorCode::Truncated)
        return prefix;
    // A file that ends too early is one thing, asking for too little of a whole one another.
    const model::Error error = prefix.error();
    const std::uint64_t needed = std::stoull(error.args[0]);
    const auto size = std::uint64_t(QFileInfo(path).size());
    if (needed > size)
        return prefix;
    return notBytes(needed == size ? QStringLiteral("all %1 bytes; only codec reel can be decoded in part").arg(size)
                                   : QStringLiteral("%1 or more, for connectivity and shape").arg(needed));
}

model::Result<model::FrameSourcePtr> Decode::readAll(Console &console) const
{
    auto source = input.read(console.progress("Reading"));
    if (source || source.error().code != model::ErrorCode::Truncated || endingOf(input.path) != QLatin1String("anim"))
        return source;
    const auto prefix = model::io::openAnimPrefix(fromUtf8(input.path), ~std::uint64_t(0));
    if (prefix)
        console.note(QStringLiteral("%1 of its %2 basis trajectories are there: --bytes %3 decodes them.")
                         .arg(prefix->animation->basisSize())
                         .arg(prefix->bandsInFile)
                         .arg(prefix->bytes));
    return source;
}

model::Result<void> Decode::run(Console &console) const
{
    const QString target = fromUtf8(output);
    const QString ending = endingOf(output);
    const bool isCache = ending == QLatin1String("pc2");
    if (!isCache && model::io::readableEndings().contains(ending))
        return model::fail(model::ErrorCode::BadSetting, "--output", output, "a folder, or a file that ends in .pc2");
    if (auto checked = checkOutputs({{"--output", output, !isCache}, {"--mesh", mesh}}, {input.path, input.baseMesh});
        !checked)
        return checked;
    model::io::MeshFormat baseFormat = format;
    if (!mesh.empty()) {
        const auto known = meshFormatOf(fromUtf8(mesh));
        if (!known)
            return model::fail(known.error());
        baseFormat = *known;
    }
    model::FrameSourcePtr source;
    std::optional<model::io::AnimPrefix> prefix;
    if (bytes > 0) {
        auto read = readPrefix(console);
        if (!read)
            return model::fail(std::move(read).error());
        source = read->animation;
        prefix = std::move(*read);
    } else {
        auto read = readAll(console);
        if (!read)
            return model::fail(std::move(read).error());
        source = std::move(*read);
    }
    RemoveUnlessKept partial(mesh);
    if (!mesh.empty())
        if (auto saved = model::io::writeMesh(fromUtf8(mesh), source->frame(0), source->connectivity(), baseFormat);
            !saved)
            return saved;
    auto written = isCache ? model::io::writePc2(target, *source, console.progress("Writing"))
                           : model::io::writeFrames(target, *source, format, console.progress("Writing"));
    if (!written)
        return written;
    partial.keep();
    QJsonObject json{
        {"output", target}, {"frames", double(source->frameCount())}, {"vertices", double(source->vertexCount())}};
    QString text =
        QStringLiteral("%1: %2 frames, %3 vertices").arg(target).arg(source->frameCount()).arg(source->vertexCount());
    if (prefix) {
        json["bytes"] = double(prefix->bytes);
        json["file_bytes"] = double(prefix->fileBytes);
        json["basis"] = double(prefix->animation->basisSize());
        json["basis_in_file"] = double(prefix->bandsInFile);
        text += QStringLiteral(", from %1 of %2 bytes with %3 of %4 basis trajectories")
                    .arg(prefix->bytes)
                    .arg(prefix->fileBytes)
                    .arg(prefix->animation->basisSize())
                    .arg(prefix->bandsInFile);
    }
    console.outcome(json, text);
    return {};
}

} // namespace

void addDecode(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("decode", "Turn an .anim file into mesh files or a point cache");
    const auto options = std::make_shared<Decode>();
    options->input.addTo(*command);
    command
        ->add_option("-o,--output", options->output,
                     "A folder for the frames, or a .pc2 file (float32 positions in the decoder's order of vertices)")
        ->required()
        ->type_name("DIR|FILE.pc2");
    const std::map<std::string, model::io::MeshFormat> formats{
        {"obj", model::io::MeshFormat::Obj}, {"off", model::io::MeshFormat::Off}, {"ply", model::io::MeshFormat::Ply}};
    command->add_option("--format", options->format, "Format of the frames (default: obj)")
        ->transform(CLI::CheckedTransformer(formats, CLI::ignore_case).description(""))
        ->type_name("obj|off|ply");
    command->add_option("--mesh", options->mesh, "Also write the first frame, as the base mesh of a point cache")
        ->type_name("FILE");
    command
        ->add_option("--bytes", options->bytes,
                     "Decode only the first N bytes of an .anim file of codec reel: fewer\n"
                     "bytes, fewer basis trajectories (info says how many need how much)")
        ->check(CLI::PositiveNumber)
        ->type_name("N");
    command->footer("Examples:\n"
                    "  sandreel-cli decode walk.anim -o frames/ --format ply\n"
                    "  sandreel-cli decode walk.anim -o walk.pc2 --mesh walk.obj\n"
                    "  sandreel-cli decode walk.anim -o preview/ --bytes 20000");
    onCall(*command, options, run);
}

} // namespace cli
