// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/comparison.h"

#include "model/codec/connectivity/codedorder.h"

namespace views {

/// Where nobody has kept the order of the vertices, it is found again.
model::Result<Comparison::Measured> Comparison::measureMatched(OriginalPtr original, const model::FrameSource &test,
                                                               const model::Progress &progress)
{
    if (original->permutation.empty()) {
        auto order =
            model::codec::codedOrder(original->frames->connectivity(), test.connectivity(), progress.part(0, 0.1));
        if (!order)
            return model::fail(std::move(order).error());
        if (!order->empty())
            original = std::make_shared<const Original>(Original{original->frames, std::move(*order)});
    }
    auto errors = model::compareAnimations(*original->frames, test, original->permutation, progress.part(0.1, 1));
    if (!errors)
        return model::fail(std::move(errors).error());
    return Measured{std::move(original), std::move(*errors)};
}

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
    mMeasuring.start([original = mOriginal,
                      test](const model::Progress &progress) { return measureMatched(original, *test, progress); },
                     [this](model::Result<Measured> result) { measured(std::move(result)); });
}

void Comparison::measured(model::Result<Measured> result)
{
    if (!mOriginal) // stopped meanwhile
        return;
    if (result) {
        mIsFirst = false;
        mOriginal = std::move(result->original);
        mResult = std::move(result->errors);
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
