// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/framedata.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace views {

/// Why a frame is asked for: to be drawn, or because play will soon come to it.
enum class FramePurpose : std::uint8_t { Wanted, Ahead };

/// Makes frames one after another in a thread of its own. Of the frames asked for while it works, only the newest is
/// made. Buffers of frames that nobody holds any more are used again.
class FrameWorker final
{
public:
    using Deliver = std::function<void(FrameDataPtr, FramePurpose)>;
    /// \param deliver  called in the worker's thread with each frame made
    explicit FrameWorker(Deliver deliver);
    /// Waits for the frame being made, which is still delivered.
    ~FrameWorker();

    FrameWorker(const FrameWorker &) = delete;
    FrameWorker &operator=(const FrameWorker &) = delete;

    /// Replaces what was asked for and is not begun; a frame that is just being made is not made twice. Precondition:
    /// frame < source->frameCount().
    void request(model::FrameSourcePtr source, OriginalPtr original, std::uint32_t frame, FramePurpose purpose);
    /// Forgets what was asked for and is not begun.
    void cancel();

private:
    struct Request
    {
        model::FrameSourcePtr source;
        OriginalPtr original;
        std::uint32_t frame = 0;
        FramePurpose purpose = FramePurpose::Wanted;
    };
    class BufferPool;

    void run();

    Deliver mDeliver;
    std::shared_ptr<BufferPool> mPool;
    std::mutex mMutex;
    std::condition_variable mWake;
    std::optional<Request> mRequest;
    std::optional<Request> mInWork;
    bool mStopping = false;
    std::thread mThread; ///< last: starts when the rest is there
};

} // namespace views
