// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/frameworker.h"

#include <utility>

namespace views {

/// Frames to be filled again. Kept alive by the frames that are out, so that the last one may outlive the worker.
class FrameWorker::BufferPool final : public std::enable_shared_from_this<FrameWorker::BufferPool>
{
public:
    std::shared_ptr<FrameData> take()
    {
        std::unique_ptr<FrameData> data;
        {
            const std::lock_guard lock(mMutex);
            if (!mFree.empty()) {
                data = std::move(mFree.back());
                mFree.pop_back();
            }
        }
        if (!data)
            data = std::make_unique<FrameData>();
        return {data.release(), [pool = shared_from_this()](FrameData *back) { pool->giveBack(back); }};
    }

private:
    /// One on the screen, one in the making, one ahead.
    static constexpr std::size_t Capacity = 3;

    void giveBack(FrameData *data)
    {
        std::unique_ptr<FrameData> owned(data);
        owned->source.reset();
        owned->original.reset();
        const std::lock_guard lock(mMutex);
        if (mFree.size() < Capacity)
            mFree.push_back(std::move(owned));
    }

    std::mutex mMutex;
    std::vector<std::unique_ptr<FrameData>> mFree;
};

FrameWorker::FrameWorker(Deliver deliver)
    : mDeliver(std::move(deliver))
    , mPool(std::make_shared<BufferPool>())
    , mThread([this] { run(); })
{}

FrameWorker::~FrameWorker()
{
    {
        const std::lock_guard lock(mMutex);
        mStopping = true;
    }
    mWake.notify_one();
    mThread.join();
}

void FrameWorker::request(model::FrameSourcePtr source, OriginalPtr original, std::uint32_t frame, FramePurpose purpose)
{
    {
        const std::lock_guard lock(mMutex);
        mRequest.reset();
        if (mInWork && mInWork->source == source && mInWork->original == original && mInWork->frame == frame) {
            mInWork->purpose = purpose;
            return;
        }
        mRequest = Request{std::move(source), std::move(original), frame, purpose};
    }
    mWake.notify_one();
}

void FrameWorker::cancel()
{
    const std::lock_guard lock(mMutex);
    mRequest.reset();
}

void FrameWorker::run()
{
    while (true) {
        Request request;
        {
            std::unique_lock lock(mMutex);
            mWake.wait(lock, [this] { return mStopping || mRequest; });
            if (mStopping)
                return;
            request = *std::exchange(mRequest, std::nullopt);
            mInWork = request;
        }
        std::shared_ptr<FrameData> data = mPool->take();
        makeFrame(request.source, request.frame, *data, request.original);
        {
            const std::lock_guard lock(mMutex);
            request.purpose = std::exchange(mInWork, std::nullopt)->purpose;
        }
        mDeliver(std::move(data), request.purpose);
    }
}

} // namespace views
