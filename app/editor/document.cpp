// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/document.h"

#include "app/editor/samples.h"
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

bool isInResources(const QString &path)
{
    return path.startsWith(QLatin1String(":/"));
}

} // namespace

Document::Content Document::Content::of(const model::AnimationDocument &document)
{
    return {document.timing(), document.placement(), document.name(), document.compression()};
}

Document::Document(QObject *parent)
    : QObject(parent)
{
    connect(&mOpening, &views::Job::runningChanged, this, &Document::stateChanged);
    connect(&mSaving, &views::Job::runningChanged, this, &Document::stateChanged);
}

Document::~Document()
{
    emit aboutToBeReplaced();
}

void Document::open(const QString &path)
{
    mSource = path;
    mPath = isInResources(path) ? QString() : path;
    struct Opened
    {
        AnimationPtr animation;
        FileStamp stamp;
        std::optional<Cut> cut;
    };
    mOpening.start(
        [path](const model::Progress &progress) -> model::Result<Opened> {
            const FileStamp stamp = FileStamp::of(path); // before reading: a later writer is then noticed
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
            mStamp = result->stamp;
            mCut = result->cut;
            if (mCut)
                mPath.clear(); // so that saving asks where: the file may still be coming
            take(std::move(result->animation));
        });
}

void Document::reload()
{
    open(mSource);
}

void Document::take(AnimationPtr animation)
{
    emit aboutToBeReplaced();
    const bool again = isOpen();
    const model::Playback before = mPlayer.playback();
    mContext.reset();
    mFacts = views::factsOf(*animation);
    const model::CompressionSettings settings = animation->settings();
    mDocument = std::make_unique<model::AnimationDocument>(std::move(animation), settings);
    mContext = std::make_unique<commands::AnimationContext>(*mDocument);
    connect(mDocument.get(), &model::AnimationDocument::changed, this, &Document::contentChanged);
    mSavedContent = Content::of(*mDocument);
    mPlayer.setSource(mDocument->frames());
    if (again) {
        mPlayer.seek(before.frame());
        if (before.isPlaying())
            mPlayer.play();
    }
    updateModified();
    emit opened();
}

void Document::save(const QString &path)
{
    Q_ASSERT(canSave());
    Content content = Content::of(*mDocument);
    const int step = mContext->undoStack().index();
    mSaving.start([frames = mDocument->frames(), settings = content.compression,
                   path](const model::Progress &progress) { return saveToFile(*frames, settings, path, progress); },
                  [this, path, step, content = std::move(content)](model::Result<Saved> result) mutable {
                      if (!result) {
                          emit saveFailed(result.error());
                          return;
                      }
                      mSource = mPath = path;
                      mCut.reset();
                      mStamp = result->stamp;
                      mFacts = std::move(result->facts);
                      mSavedContent = std::move(content);
                      // The stack can mark only the step that it stands on.
                      if (mContext->undoStack().index() == step)
                          mContext->undoStack().setClean();
                      else
                          mContext->undoStack().resetClean();
                      updateModified();
                      emit saved();
                      emit stateChanged();
                  });
}

QString Document::title() const
{
    if (mCut)
        return tr("%1 (cut)").arg(QFileInfo(mSource).completeBaseName());
    return mPath.isEmpty() ? sampleName(mSource) : QFileInfo(mPath).completeBaseName();
}

bool Document::isModified() const
{
    return mDocument && mSavedContent && !(Content::of(*mDocument) == *mSavedContent);
}

void Document::contentChanged(const model::AnimationChange &change)
{
    const bool framesDiffer =
        std::holds_alternative<model::TimingChanged>(change) || std::holds_alternative<model::PlacementChanged>(change);
    if (framesDiffer)
        mPlayer.setSource(mDocument->frames());
    updateModified();
}

void Document::updateModified()
{
    const bool modified = isModified();
    if (std::exchange(mWasModified, modified) != modified)
        emit stateChanged();
}

} // namespace editor
