// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/outputs.h"
#include "model/base/parallel.h"
#include "model/mesh/softwareraster.h"
#include "views/scene/picturefiles.h"

#include <QFile>
#include <QImage>
#include <QRegularExpression>

#include <atomic>
#include <mutex>
#include <numbers>
#include <optional>

namespace cli {

namespace {

struct Render
{
    InputOptions input;
    std::string output, size = "960x540";
    std::optional<std::uint32_t> frame; ///< counted from 1
    double yaw = 35, pitch = 20;
    bool wireframe = false;

    model::Result<void> run(Console &console) const;
    model::Result<void> draw(const model::FrameSource &source, std::uint32_t index, const model::OrbitCamera &camera,
                             const QString &path, const model::Progress &progress) const;
    model::Result<void> drawAll(const model::FrameSource &source, const model::OrbitCamera &camera,
                                const model::Progress &progress) const;
    int width() const { return std::stoi(size); }
    int height() const { return std::stoi(size.substr(size.find('x') + 1)); }
    /// The output with a frame's number in place of its %d or %04d; empty optional if it has none.
    std::optional<QString> pathOf(std::uint32_t index) const;
};

std::optional<QString> Render::pathOf(std::uint32_t index) const
{
    static const QRegularExpression number(QStringLiteral("%0?(\\d{0,2})d"));
    const QString pattern = fromUtf8(output);
    const QRegularExpressionMatch match = number.match(pattern);
    if (!match.hasMatch())
        return std::nullopt;
    const QString digits = QStringLiteral("%1").arg(index + 1, match.captured(1).toInt(), 10, QLatin1Char('0'));
    return QString(pattern).replace(match.capturedStart(), match.capturedLength(), digits);
}

model::Result<void> Render::draw(const model::FrameSource &source, std::uint32_t index,
                                 const model::OrbitCamera &camera, const QString &path,
                                 const model::Progress &progress) const
{
    model::RasterStyle style;
    style.wireframe = wireframe;
    const model::Picture picture = model::drawMesh(source.frame(index), source.connectivity().triangles, camera,
                                                   width(), height(), style, progress);
    return views::savePng(
        path, QImage(picture.rgba.data(), picture.width, picture.height, 4 * picture.width, QImage::Format_RGBA8888),
        progress);
}

/// A picture for each frame; on an error or an interrupt those already written are removed.
model::Result<void> Render::drawAll(const model::FrameSource &source, const model::OrbitCamera &camera,
                                    const model::Progress &progress) const
{
    std::mutex mutex;
    std::optional<model::Error> problem;
    QStringList written;
    std::atomic<std::uint32_t> done = 0;
    model::parallelFor(source.frameCount(), [&](std::size_t i) {
        {
            const std::lock_guard lock(mutex);
            if (problem || progress.isCancelled())
                return;
        }
        const QString path = *pathOf(std::uint32_t(i));
        const bool existed = QFile::exists(path);
        const auto drawn = draw(source, std::uint32_t(i), camera, path, progress);
        progress.report(double(++done) / source.frameCount());
        const std::lock_guard lock(mutex);
        if (!drawn && !problem)
            problem = drawn.error();
        else if (drawn && !existed)
            written << path;
    });
    if (!problem && progress.isCancelled())
        problem = model::Error{model::ErrorCode::Cancelled, {}, {}, model::Error::None, model::Error::None};
    if (!problem)
        return {};
    for (const QString &path : written)
        QFile::remove(path);
    return model::fail(*problem);
}

model::Result<void> Render::run(Console &console) const
{
    constexpr int MaxSide = 16384;
    if (width() < 1 || height() < 1 || width() > MaxSide || height() > MaxSide)
        return model::fail(model::ErrorCode::BadSetting, "--size", size, "1x1 ... 16384x16384");
    if (endingOf(output) != QLatin1String("png"))
        return model::fail(model::ErrorCode::BadSetting, "--output", output, "a name that ends in .png");
    const bool all = pathOf(0).has_value();
    if (all && frame)
        return model::fail(model::ErrorCode::BadSetting, "--frame", std::to_string(*frame),
                           "no --frame with a number in the name of --output, which means all frames");
    if (auto checked = checkOutputs({{"--output", pathOf(0).value_or(fromUtf8(output)).toStdString()}},
                                    {input.path, input.baseMesh});
        !checked)
        return checked;
    const auto read = input.read(console.progress("Reading"));
    if (!read)
        return model::fail(read.error());
    const model::FrameSource &source = **read;
    const std::uint32_t shown = frame.value_or(1);
    if (shown > source.frameCount())
        return model::fail(model::ErrorCode::BadSetting, "--frame", std::to_string(shown),
                           "1 ... " + std::to_string(source.frameCount()));
    const auto box = model::boundingBoxOfAll(source, console.progress("Measuring"));
    if (!box)
        return model::fail(box.error());
    model::OrbitCamera camera;
    camera.yaw = float(yaw * std::numbers::pi / 180);
    camera.pitch = float(pitch * std::numbers::pi / 180);
    camera.fit(*box, float(width()) / float(height()));

    const model::Progress progress = console.progress("Drawing");
    auto drawn = all ? drawAll(source, camera, progress) : draw(source, shown - 1, camera, fromUtf8(output), progress);
    if (!drawn)
        return drawn;
    console.outcome(
        {{"output", fromUtf8(output)},
         {"pictures", double(all ? source.frameCount() : 1)},
         {"width", width()},
         {"height", height()}},
        QStringLiteral("%1: %2").arg(fromUtf8(output), all ? QStringLiteral("%1 pictures").arg(source.frameCount())
                                                           : QStringLiteral("frame %1").arg(shown)));
    return {};
}

} // namespace

void addRender(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("render", "Draw a frame, or all of them, as PNG pictures; needs no display");
    const auto options = std::make_shared<Render>();
    options->input.addTo(*command);
    command
        ->add_option("-o,--output", options->output,
                     "The PNG file to write; with %04d in its name, one for each frame, counted from 1")
        ->required()
        ->type_name("FILE.png");
    command->add_option("--frame", options->frame, "Which frame, counted from 1 (default: 1)")
        ->check(CLI::PositiveNumber)
        ->type_name("N");
    static const CLI::Validator isSize(
        [](std::string &text) -> std::string {
            static const QRegularExpression pattern(QStringLiteral("^\\d{1,5}x\\d{1,5}$"));
            return pattern.match(fromUtf8(text)).hasMatch() ? "" : "must be WIDTHxHEIGHT, for instance 960x540";
        },
        "");
    command->add_option("--size", options->size, "Pixels (default: 960x540)")->check(isSize)->type_name("WxH");
    command->add_option("--yaw", options->yaw, "Degrees around the vertical axis (default: 35)")
        ->check(finiteRange(-360, 360))
        ->type_name("D");
    command->add_option("--pitch", options->pitch, "Degrees from above (default: 20)")
        ->check(finiteRange(-90, 90))
        ->type_name("D");
    command->add_flag("--wireframe", options->wireframe, "Draw the edges too");
    command->footer("Examples:\n"
                    "  sandreel-cli render walk.anim -o walk.png --frame 12 --size 1920x1080\n"
                    "  sandreel-cli render walk.anim -o pictures/walk_%04d.png");
    onCall(*command, options, run);
}

} // namespace cli
