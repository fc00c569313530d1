// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/openanimation.h"

#include "model/io/animfile.h"

#include <QFileInfo>

namespace editor {

namespace {

using AnimationPtr = std::shared_ptr<const model::codec::DecodedAnimation>;

struct Saved
{
    views::FileFacts facts;
    FileStamp stamp;
};

model::Result<Saved> saveToFile(const model::FrameSource &frames, const model::CompressionSettings &settings,
                                const QString &path, const model::Progress &progress)
{
    auto encoded = model::io::encodeEdited(frames, settings, progress.part(0, 0.9));
    if (!encoded)
        return model::fail(std::move(encoded.error()));
    if (auto written = model::io::saveBytes(path, encoded->bytes); !written)
        return model::fail(std::move(written.error()));
    const FileStamp stamp = FileStamp::of(path);
    // From here on the file is there: what follows is told even if a cancel comes.
    const auto limits = model::codec::DecodeLimits::ofThisMachine(encoded->bytes.size());
    auto decoded = model::codec::decodeAnimation(std::move(encoded->bytes), model::Progress(), limits);
    if (!decoded)
        return model::fail(std::move(decoded.error()).in(path.toStdString()));
    return Saved{views::factsOf(**decoded), stamp};
}

constexpr std::uint64_t WholeFile = ~std::uint64_t(0);

} // namespace

OpenAnimation::Content OpenAnimation::Content::of(const model::AnimationDocument &document)
{
    return {document.timing(), document.placement(), document.name(), document.compression()};
}

OpenAnimation::OpenAnimation(QObject *parent)
    : Document(parent)
{}

OpenAnimation::~OpenAnimation()
{
    emit aboutToBeReplaced();
}

void OpenAnimation::read(const QString &path)
{
    struct Opened
    {
        AnimationPtr animation;
        FileStamp stamp;
        std::optional<Cut> cut;
    };
    openingJob().start(
        [path](const model::Progress &progress) -> model::Result<Opened> {
            const FileStamp stamp = FileStamp::of(path);
            auto animation = model::io::openAnim(path, progress);
            if (!animation && animation.error().code == model::ErrorCode::Truncated)
                if (auto prefix = model::io::openAnimPrefix(path, WholeFile, progress))
                    return Opened{prefix->animation, stamp, Cut{prefix->animation->basisSize(), prefix->bandsInFile}};
            if (!animation)
                return model::fail(std::move(animation.error()));
            return Opened{std::move(*animation), stamp, {}};
        },
        [this](model::Result<Opened> result) {
            if (!result) {
                emit failed(result.error());
                return;
            }
            mCut = result->cut;
            if (mCut)
                setPath({}); // the file may still be coming
            take(std::move(result->animation));
            finishOpening(result->stamp);
        });
}

void OpenAnimation::show(model::FrameSourcePtr frames)
{
    begin(std::move(frames), {});
    finishOpening({});
}

void OpenAnimation::begin(model::FrameSourcePtr frames, const model::CompressionSettings &settings)
{
    emit aboutToBeReplaced();
    mContext.reset();
    mDocument = std::make_unique<model::AnimationDocument>(std::move(frames), settings);
    mContext = std::make_unique<commands::AnimationContext>(*mDocument);
    connect(mDocument.get(), &model::AnimationDocument::changed, this, &OpenAnimation::contentChanged);
    mPlayer.setSource(mDocument->frames());
}

void OpenAnimation::take(AnimationPtr animation)
{
    const bool again = isOpen();
    const model::Playback before = mPlayer.playback();
    mFacts = views::factsOf(*animation);
    const model::CompressionSettings settings = animation->settings();
    begin(std::move(animation), settings);
    mSavedContent = Content::of(*mDocument);
    if (again) {
        mPlayer.seek(before.frame());
        if (before.isPlaying())
            mPlayer.play();
    }
}

void OpenAnimation::write(const QString &path)
{
    Content content = Content::of(*mDocument);
    const int step = mContext->undoStack().index();
    savingJob().start([frames = mDocument->frames(), settings = content.compression,
                       path](const model::Progress &progress) { return saveToFile(*frames, settings, path, progress); },
                      [this, path, step, content = std::move(content)](model::Result<Saved> result) mutable {
                          if (!result) {
                              emit saveFailed(result.error());
                              return;
                          }
                          mCut.reset();
                          mFacts = std::move(result->facts);
                          mSavedContent = std::move(content);
                          finishSaving(path, result->stamp, step);
                      });
}

QString OpenAnimation::title() const
{
    if (mCut)
        return tr("%1 (cut)").arg(QFileInfo(source()).completeBaseName());
    return isMade() ? QString::fromStdString(mDocument->name()) : Document::title();
}

QString OpenAnimation::origin() const
{
    if (mCut)
        return tr("What is there of a file that was cut, not saved to a file yet");
    return isMade() ? tr("Recorded, not saved to a file yet") : Document::origin();
}

QString OpenAnimation::summary() const
{
    return tr("%L1 vertices, %L2 frames").arg(mDocument->vertexCount()).arg(mDocument->frameCount());
}

QString OpenAnimation::warning() const
{
    if (!mCut)
        return {};
    return tr("%1: the file ends too early. Shown are %2 of its %3 details. Copy it again, or save what is there under "
              "another name.")
        .arg(title())
        .arg(mCut->details)
        .arg(mCut->detailsInFile);
}

bool OpenAnimation::isModified() const
{
    return mDocument && !(mSavedContent && Content::of(*mDocument) == *mSavedContent);
}

void OpenAnimation::contentChanged(const model::AnimationChange &change)
{
    const bool framesDiffer =
        std::holds_alternative<model::TimingChanged>(change) || std::holds_alternative<model::PlacementChanged>(change);
    if (framesDiffer)
        mPlayer.setSource(mDocument->frames());
    updateModified();
}

} // namespace editor
