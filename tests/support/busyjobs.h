// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/jobs/job.h"

#include <array>
#include <future>

namespace tests {

/// Holds every thread that jobs have: a job that is started while this lives is running, for whoever asks, and gets no
/// further. So a test does with it what it likes, however fast the machine is.
class BusyJobs
{
public:
    BusyJobs()
    {
        const std::shared_future<void> gate = mGate.get_future().share();
        for (views::Job &job : mJobs)
            job.start(
                [gate](const model::Progress &) -> model::Result<void> {
                    gate.wait();
                    return {};
                },
                [](const model::Result<void> &) {});
    }
    BusyJobs(const BusyJobs &) = delete;
    BusyJobs &operator=(const BusyJobs &) = delete;
    ~BusyJobs() { mGate.set_value(); }

private:
    std::promise<void> mGate;
    std::array<views::Job, 64> mJobs; ///< more than there are threads; those that wait do so before any later job
};

} // namespace tests
