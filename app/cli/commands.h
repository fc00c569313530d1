// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/console.h"
#include "model/animation/framesource.h"
#include "model/animation/normalisation.h"
#include "model/io/animationreader.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>

namespace cli {

/// What a sub-command does once the command line has been read.
using Run = std::function<model::Result<void>(Console &)>;

/// Each adds its sub-command to `app`; if it is the one that was called, `run` is set. One file per sub-command.
void addEncode(CLI::App &app, Run &run);
void addDecode(CLI::App &app, Run &run);
void addInfo(CLI::App &app, Run &run);
void addInspect(CLI::App &app, Run &run);
void addCompare(CLI::App &app, Run &run);
void addRender(CLI::App &app, Run &run);
void addExportPlayer(CLI::App &app, Run &run);
void addTerrain(CLI::App &app, Run &run);

/// How an input is named on the command line; the same words in every sub-command.
struct InputOptions
{
    std::string path;
    std::string baseMesh;
    double frameRate = 0; ///< 0: as the input says
    int animation = 1;    ///< counted from 1

    void addTo(CLI::App &command, const std::string &name = "INPUT");
    model::Result<model::FrameSourcePtr> read(const model::Progress &progress) const;
};

/// `--normalize none|first|all`
struct NormaliseOption
{
    model::Normalisation mode = model::Normalisation::None;

    void addTo(CLI::App &command, const std::string &help);
    /// The same animation, normalised.
    model::Result<model::FrameSourcePtr> apply(model::FrameSourcePtr source, const model::Progress &progress) const;
};

/// Size of all positions as float32, bytes.
double rawBytes(const model::FrameSource &source);
/// Bits per frame and vertex.
double bitsPerFrameAndVertex(double bytes, const model::FrameSource &source);
/// Has `run` run the options of the sub-command if it is the one that was called.
template <class Options>
void onCall(CLI::App &command, const std::shared_ptr<Options> &options, Run &run)
{
    command.callback([options, &run] { run = [options](Console &console) { return options->run(console); }; });
}

/// Accepts numbers from `least` to `most`; CLI::Range lets "nan" through.
CLI::Validator finiteRange(double least, double most);
/// "12.3 kB"
QString sizeText(double bytes);

inline QString fromUtf8(const std::string &text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

} // namespace cli
