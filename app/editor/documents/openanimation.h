// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/document.h"
#include "commands/animation/animationcontext.h"
#include "model/document/animationdocument.h"
#include "views/docks/filefacts.h"
#include "views/scene/comparison.h"
#include "views/scene/player.h"

#include <memory>
#include <optional>

namespace editor {

/// An animation with its player, which keeps frame and play over a reload.
class OpenAnimation final : public Document
{
    Q_OBJECT

public:
    explicit OpenAnimation(QObject *parent = nullptr);
    ~OpenAnimation() override;

    DocumentKind kind() const override { return DocumentKind::Animation; }
    QString title() const override;
    QString origin() const override;
    QString summary() const override;
    QString warning() const override;
    bool isModified() const override;
    commands::AnimationContext *context() const override { return mContext.get(); }

    /// Shows what was made in the program: it has no file yet, and is unsaved. opened() follows at once.
    void show(model::FrameSourcePtr frames);

    /// What a file that was cut shows, as long as it was not saved. It has no path then.
    struct Cut
    {
        std::uint32_t details = 0, detailsInFile = 0; ///< basis trajectories
    };
    const std::optional<Cut> &cut() const { return mCut; }

    views::Player &player() { return mPlayer; }
    /// What it lost of its original; not saved.
    views::Comparison &comparison() { return mComparison; }
    /// Of the file as it was last read or written.
    const std::optional<views::FileFacts> &fileFacts() const { return mFacts; }

protected:
    void read(const QString &path) override;
    void write(const QString &path) override;

private:
    /// All that saving writes, besides the source.
    struct Content
    {
        model::Timing timing;
        model::Similarity placement;
        std::string name;
        model::CompressionSettings compression;

        static Content of(const model::AnimationDocument &document);
        friend bool operator==(const Content &, const Content &) = default;
    };

    void take(std::shared_ptr<const model::codec::DecodedAnimation> animation);
    void begin(model::FrameSourcePtr frames, const model::CompressionSettings &settings);
    void contentChanged(const model::AnimationChange &change);
    /// It comes from no file, and was never saved.
    bool isMade() const { return mDocument && !mSavedContent; }

    std::optional<Cut> mCut;
    std::optional<views::FileFacts> mFacts;
    std::unique_ptr<model::AnimationDocument> mDocument;
    std::unique_ptr<commands::AnimationContext> mContext;
    std::optional<Content> mSavedContent; ///< nothing: never saved
    views::Player mPlayer;
    views::Comparison mComparison{mPlayer};
};

} // namespace editor
