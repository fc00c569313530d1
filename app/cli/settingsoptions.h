// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/animation/qualitytarget.h"
#include "model/base/error.h"

#include <CLI/CLI.hpp>

#include <map>
#include <optional>
#include <string>

namespace cli {

/// `--codec`, for each field that some available codec has an option of that name, and instead of those a target that
/// settings are searched for. Which option goes with which codec is known when all of them have been read, so that
/// their order does not matter.
class SettingsOptions
{
public:
    void addTo(CLI::App &command);
    /// \error BadSetting  an unknown codec or word, a value out of range, an option that the codec does not have, or
    /// one
    ///                    beside a target
    model::Result<model::CompressionSettings> settings() const;
    /// What was asked for instead of the codec's own options. Its range is left to model::codec.
    const std::optional<model::QualityTarget> &target() const { return mTarget; }

private:
    std::string mCodec;
    bool mKeepOrder = false;
    std::optional<model::QualityTarget> mTarget;
    std::string mTargetOption;                                             ///< "--quality"
    std::map<std::string, std::optional<std::string>, std::less<>> mGiven; ///< by the field's key; empty: not given
};

} // namespace cli
