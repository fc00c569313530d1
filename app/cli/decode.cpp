// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/outputs.h"
#include "model/io/animationwriter.h"

namespace cli {

namespace {

struct Decode
{
    InputOptions input;
    std::string output, mesh;
    model::io::MeshFormat format = model::io::MeshFormat::Obj;

    model::Result<void> run(Console &console) const;
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
    const auto source = input.read(console.progress("Reading"));
    if (!source)
        return model::fail(source.error());
    RemoveUnlessKept partial(mesh);
    if (!mesh.empty())
        if (auto saved =
                model::io::writeMesh(fromUtf8(mesh), (*source)->frame(0), (*source)->connectivity(), baseFormat);
            !saved)
            return saved;
    auto written = isCache ? model::io::writePc2(target, **source, console.progress("Writing"))
                           : model::io::writeFrames(target, **source, format, console.progress("Writing"));
    if (!written)
        return written;
    partial.keep();
    if (console.isJson())
        console.json({{"output", target},
                      {"frames", double((*source)->frameCount())},
                      {"vertices", double((*source)->vertexCount())}});
    else
        console.note(QStringLiteral("%1: %2 frames, %3 vertices")
                         .arg(target)
                         .arg((*source)->frameCount())
                         .arg((*source)->vertexCount()));
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
    command->footer("Examples:\n"
                    "  sandreel-cli decode walk.anim -o frames/ --format ply\n"
                    "  sandreel-cli decode walk.anim -o walk.pc2 --mesh walk.obj");
    command->callback([options, &run] { run = [options](Console &console) { return options->run(console); }; });
}

} // namespace cli
