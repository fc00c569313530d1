// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/outputs.h"
#include "app/cli/playerfolder.h"
#include "model/io/animfile.h"
#include "model/io/failure.h"
#include "model/mesh/softwareraster.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QJsonArray>

#include <numbers>

namespace cli {

namespace {

// Twice the 4 : 3 of a list, for screens with small pixels.
constexpr int PictureWidth = 480, PictureHeight = 360;
// Enough that two different files never meet.
constexpr qsizetype NameLength = 20;

struct ExportPlayer
{
    std::string folder;
    std::vector<std::string> files;

    model::Result<void> run(Console &console) const;
};

/// The name of a file that holds these bytes: other bytes, other name, so that caches never show old ones.
QString contentName(const QByteArray &bytes, const QString &ending)
{
    const QByteArray digest = QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
    return QString::fromLatin1(digest.left(NameLength)) + ending;
}

model::Result<QByteArray> pictureOf(const model::FrameSource &source, const model::Progress &progress)
{
    const std::vector<model::Vec3f> positions = source.frame(source.frameCount() / 3);
    model::OrbitCamera camera;
    camera.yaw = float(35 * std::numbers::pi / 180);
    camera.pitch = float(20 * std::numbers::pi / 180);
    camera.fit(model::boundingBox(positions), float(PictureWidth) / float(PictureHeight));
    const model::Picture picture =
        model::drawMesh(positions, source.connectivity().triangles, camera, PictureWidth, PictureHeight, {}, progress);
    if (progress.isCancelled())
        return model::fail(model::ErrorCode::Cancelled);
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    QImage(picture.rgba.data(), picture.width, picture.height, 4 * picture.width, QImage::Format_RGBA8888)
        .save(&buffer, "PNG");
    return png;
}

/// Puts an animation and its picture into the folder. \returns its entry of the list
model::Result<QJsonObject> addAnimation(PlayerFolder &folder, const std::string &path, Console &console)
{
    const QString file = fromUtf8(path);
    if (endingOf(path) != QLatin1String("anim"))
        return model::fail(model::ErrorCode::BadSetting, "FILE", path, "a name that ends in .anim");
    const auto animation = model::io::openAnim(file, console.progress("Reading"));
    if (!animation)
        return model::fail(animation.error());
    // Frames that are damaged are found now, not in front of a class.
    if (const auto checked = (*animation)->check(console.progress("Checking")); !checked)
        return model::fail(model::Error(checked.error()).in(path));
    const auto picture = pictureOf(**animation, console.progress("Drawing"));
    if (!picture)
        return model::fail(picture.error());
    const model::Bytes &bytes = (*animation)->encoded();
    const auto encoded = QByteArray::fromRawData(reinterpret_cast<const char *>(bytes.data()), qsizetype(bytes.size()));
    const QString fileName = QStringLiteral("files/") + contentName(encoded, QStringLiteral(".anim"));
    const QString pictureName = QStringLiteral("pictures/") + contentName(*picture, QStringLiteral(".png"));
    if (const auto written = folder.write(fileName, encoded); !written)
        return model::fail(written.error());
    if (const auto written = folder.write(pictureName, *picture); !written)
        return model::fail(written.error());
    const std::string &name = (*animation)->name();
    return QJsonObject{{"name", name.empty() ? QFileInfo(file).completeBaseName() : fromUtf8(name)},
                       {"file", fileName},
                       {"picture", pictureName},
                       {"bytes", double(bytes.size())},
                       {"vertices", double((*animation)->vertexCount())},
                       {"frames", double((*animation)->frameCount())}};
}

model::Result<void> ExportPlayer::run(Console &console) const
{
    auto output = PlayerFolder::begin(fromUtf8(folder));
    if (!output)
        return model::fail(output.error());
    QJsonArray animations;
    for (const std::string &file : files) {
        const auto entry = addAnimation(**output, file, console);
        if (!entry)
            return model::fail(entry.error());
        animations.append(*entry);
    }
    if (console.isInterrupted())
        return model::fail(model::ErrorCode::Cancelled);
    if (auto finished = (*output)->finish(animations); !finished)
        return finished;
    console.outcome({{"folder", fromUtf8(folder)}, {"animations", animations}},
                    QStringLiteral("%1: a player of %2 animations").arg(fromUtf8(folder)).arg(animations.size()));
    return {};
}

} // namespace

void addExportPlayer(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand(
        "export-player", "Write a web page that plays animations in any browser, as one folder for any web server");
    const auto options = std::make_shared<ExportPlayer>();
    command
        ->add_option("DIR", options->folder, "The folder to write; one that an earlier export-player wrote is replaced")
        ->required();
    command->add_option("FILES", options->files, ".anim files, in the order of the page's list")->required();
    command->footer("Examples:\n"
                    "  sandreel-cli export-player site/ walk.anim dance.anim\n"
                    "  sandreel-cli export-player site/ *.anim");
    onCall(*command, options, run);
}

} // namespace cli
