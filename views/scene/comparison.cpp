// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/comparison.h"

namespace views {

Comparison::Comparison(Player &player, QObject *parent)
    : QObject(parent)
    , mPlayer(player)
{
    connect(&mPlayer, &Player::sourceChanged, this, &Comparison::sourceChanged);
    for (Job *job : {&mReading, &mMeasuring}) {
        connect(job, &Job::runningChanged, this, &Comparison::changed);
        connect(job, &Job::progressed, this, &Comparison::progressed);
    }
}

void Comparison::start(const QString &name, std::function<model::Result<Original>(const model::Progress &)> read)
{
    stop();
    mIsActive = true;
    mName = name;
    mReading.start(std::move(read), [this](model::Result<Original> original) {
        if (!mIsActive) // stopped meanwhile
            return;
        if (!original) {
            giveUp(original.error());
            return;
        }
        mOriginal = std::make_shared<const Original>(std::move(*original));
        mIsFirst = true;
        measure();
    });
}

void Comparison::stop()
{
    mIsActive = false;
    mReading.cancel();
    mMeasuring.cancel();
    mOriginal.reset();
    mResult.reset();
    mMismatch.reset();
    mName.clear();
    mPlayer.setOriginal(nullptr);
    emit changed();
}

void Comparison::cancel()
{
    if (isReading() || isMeasuring())
        stop();
}

void Comparison::giveUp(const model::Error &error)
{
    const QString name = mName;
    stop();
    emit failed(name, error);
}

void Comparison::sourceChanged()
{
    mResult.reset();
    mMismatch.reset();
    if (mOriginal)
        measure();
    emit changed();
}

void Comparison::measure()
{
    const model::FrameSourcePtr test = mPlayer.source();
    if (!test) {
        emit changed();
        return;
    }
    mMeasuring.start(
        [original = mOriginal, test](const model::Progress &progress) {
            return model::compareAnimations(*original->frames, *test, original->permutation, progress);
        },
        [this](model::Result<model::ComparisonResult> result) { measured(std::move(result)); });
}

void Comparison::measured(model::Result<model::ComparisonResult> result)
{
    if (!mOriginal) // stopped meanwhile
        return;
    if (result) {
        mIsFirst = false;
        mResult = std::move(*result);
        mPlayer.setOriginal(mOriginal);
    } else if (mIsFirst || result.error().code == model::ErrorCode::Cancelled) {
        giveUp(result.error());
        return;
    } else {
        mMismatch = std::move(result.error());
    }
    emit changed();
}

} // namespace views
