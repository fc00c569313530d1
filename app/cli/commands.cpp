// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"

#include "model/animation/editedframes.h"

#include <QLocale>

namespace cli {

void InputOptions::addTo(CLI::App &command, const std::string &name)
{
    command
        .add_option(name, path,
                    "A folder of OBJ, OFF, PLY or STL frames, a point cache (PC2, MDD),\n"
                    "a scene (glTF, FBX, Collada), or an .anim file")
        ->required();
    command.add_option("--base-mesh", baseMesh, "Mesh of a point cache (default: the mesh of the same name beside it)")
        ->type_name("MESH");
    command.add_option("--animation", animation, "Which animation of a scene, counted from 1")
        ->check(CLI::PositiveNumber)
        ->type_name("N");
}

model::Result<model::FrameSourcePtr> InputOptions::read(const model::Progress &progress) const
{
    model::io::ReadOptions options;
    options.baseMesh = fromUtf8(baseMesh);
    options.frameRate = frameRate;
    options.animationIndex = animation - 1;
    return model::io::readAnimation(fromUtf8(path), options, progress);
}

void NormaliseOption::addTo(CLI::App &command, const std::string &help)
{
    const std::map<std::string, model::Normalisation> modes{{"none", model::Normalisation::None},
                                                            {"first", model::Normalisation::FirstFrame},
                                                            {"all", model::Normalisation::AllFrames}};
    command.add_option("--normalize", mode, help)
        ->transform(CLI::CheckedTransformer(modes, CLI::ignore_case).description(""))
        ->type_name("none|first|all");
}

model::Result<model::FrameSourcePtr> NormaliseOption::apply(model::FrameSourcePtr source,
                                                            const model::Progress &progress) const
{
    if (mode == model::Normalisation::None)
        return source;
    const auto placement = model::normalisingSimilarity(*source, mode, progress);
    if (!placement)
        return model::fail(placement.error());
    return std::make_shared<model::EditedFrames>(source, model::TimeMap::identity(source->frameCount()), *placement,
                                                 source->frameRate(), source->name());
}

double rawBytes(const model::FrameSource &source)
{
    return 12.0 * source.vertexCount() * source.frameCount();
}

double bitsPerFrameAndVertex(double bytes, const model::FrameSource &source)
{
    return 8 * bytes / (double(source.vertexCount()) * source.frameCount());
}

CLI::Validator finiteRange(double least, double most)
{
    return CLI::Validator(
        [least, most](std::string &text) -> std::string {
            bool isNumber = false;
            const double value = fromUtf8(text).toDouble(&isNumber);
            if (isNumber && value >= least && value <= most)
                return {};
            return QStringLiteral("must be a number from %1 to %2, not %3")
                .arg(least)
                .arg(most)
                .arg(fromUtf8(text))
                .toStdString();
        },
        "");
}

QString sizeText(double bytes)
{
    const QLocale locale = QLocale::c();
    if (bytes < 1000)
        return locale.toString(bytes, 'f', 0) + QStringLiteral(" bytes");
    if (bytes < 1e6)
        return locale.toString(bytes / 1e3, 'f', 1) + QStringLiteral(" kB");
    return locale.toString(bytes / 1e6, 'f', 2) + QStringLiteral(" MB");
}

} // namespace cli
