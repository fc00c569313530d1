// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/samples/samples.h"
#include "model/codec/animationcodec.h"
#include "model/io/animationwriter.h"
#include "model/io/animfile.h"
#include "model/io/errortext.h"
#include "model/io/terrain/terrainfile.h"

#include <CLI/CLI.hpp>

#include <QCoreApplication>

#include <array>
#include <iostream>

namespace samples {

std::span<const Sample> allSamples()
{
    using model::CompressionSettings;
    using model::PcaSettings;
    static constexpr std::array<Sample, 3> Samples{{
        {"cloth", "a cloth that falls over a ball", makeCloth, CompressionSettings{PcaSettings{40, 1500}}},
        {"walker", "a creature walking on the spot", makeWalker, CompressionSettings{PcaSettings{20, 1500}}},
        {"jellyfish", "a jellyfish that pulses", makeJellyfish, CompressionSettings{PcaSettings{20, 2000}}},
    }};
    return Samples;
}

} // namespace samples

namespace {

int report(const model::Error &error)
{
    std::cerr << model::io::errorText(error).toStdString() << '\n';
    return 1;
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    CLI::App options("Makes the sample animations that come with Sandreel.", "sandreel-samples");
    std::vector<std::string> names;
    for (const samples::Sample &sample : samples::allSamples())
        names.emplace_back(sample.name);
    std::string name, objFolder, animFile;
    std::string terrainFile;
    bool list = false;
    options.add_flag("--list", list, "List the samples");
    options.add_option("NAME", name, "Which sample to make")->check(CLI::IsMember(names));
    options.add_option("--obj", objFolder, "Write it as a folder of OBJ frames");
    options.add_option("--anim", animFile, "Write it as an .anim file");
    options.add_option("--dunes", terrainFile, "Write the sample terrain as a .terrain file");
    CLI11_PARSE(options, argc, argv);

    if (list) {
        for (const samples::Sample &sample : samples::allSamples())
            std::cout << sample.name << "  " << sample.description << '\n';
        return 0;
    }
    if (!terrainFile.empty()) {
        const auto terrain = samples::makeDunes();
        if (!terrain)
            return report(terrain.error());
        if (const auto saved = model::io::saveTerrain(QString::fromStdString(terrainFile), *terrain, {}); !saved)
            return report(saved.error());
        return 0;
    }
    for (const samples::Sample &sample : samples::allSamples()) {
        if (sample.name != name)
            continue;
        const model::Sequence sequence = sample.make();
        if (!objFolder.empty())
            if (const auto written =
                    model::io::writeFrames(QString::fromStdString(objFolder), sequence, model::io::MeshFormat::Obj);
                !written)
                return report(written.error());
        if (!animFile.empty()) {
            const auto encoded = model::codec::encodeAnimation(sequence, sample.settings);
            if (!encoded)
                return report(encoded.error());
            if (const auto saved = model::io::saveBytes(QString::fromStdString(animFile), encoded->bytes); !saved)
                return report(saved.error());
        }
        return 0;
    }
    std::cerr << options.help();
    return 2;
}
