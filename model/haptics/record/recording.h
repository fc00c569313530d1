// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"
#include "model/haptics/servo/servocore.h"

#include <variant>
#include <vector>

namespace model::haptics {

/// The format that FORMAT.md describes.
inline constexpr std::uint16_t RecordingVersion = 1;

/// Ground as it was handed to the servo.
struct RecordedPatch
{
    std::uint64_t id = 0;
    Time time{0};
    terrain::Point2 centre;
    double centreHeight = 0, radius = 0;
    Feel feel;
    /// Empty with `isRefresh`: those of the patch before, which has the same ground.
    std::vector<std::array<Vec3f, 3>> triangles;
    bool isRefresh = false;

    friend bool operator==(const RecordedPatch &a, const RecordedPatch &b) = default;
};

/// A session with a device: all that went into the servo, in its order, and what came out of it.
struct Recording
{
    using Event = std::variant<ServoSettings, RecordedPatch, ServoSample>;

    std::string device; ///< its name
    std::string note;   ///< free text
    std::vector<Event> events;
    std::uint64_t lostSamples = 0; ///< steps that are missing: it cannot be replayed to the end then
};

/// A recording that is no longer than LargestRecording. Precondition: settings and patches come before the samples
/// that name them.
Bytes writeRecording(const Recording &recording);

inline constexpr std::size_t LargestRecording = 1u << 30;

/// Safe on any bytes.
/// \error BadMagic, UnsupportedVersion, Truncated, TrailingBytes, BadValue, NonFinite, ChecksumMismatch, LimitExceeded
Result<Recording> readRecording(std::span<const std::uint8_t> bytes);

/// Takes down a session while it runs. Patches and settings are told as they are published, samples as they are
/// drained: that order is kept by the caller, from one thread.
class Recorder
{
public:
    explicit Recorder(std::string device) { mRecording.device = std::move(device); }
    void add(const ServoSettings &settings) { mRecording.events.emplace_back(settings); }
    /// Keeps the triangles only if they are not those of the patch before.
    void add(const TerrainPatch &patch);
    void add(std::span<const ServoSample> samples);
    void setLost(std::uint64_t samples) { mRecording.lostSamples = samples; }
    const Recording &recording() const { return mRecording; }

private:
    Recording mRecording;
    std::vector<std::array<Vec3f, 3>> mTriangles;
};

/// What a replay found.
struct Replay
{
    std::uint64_t steps = 0;
    std::uint64_t different = 0; ///< steps whose force, state or cause is not what was recorded, to the last bit
    std::uint64_t firstDifferent = 0;
    double largestDifference = 0;     ///< N
    double largestForce = 0;          ///< N
    double duration = 0;              ///< s
    std::vector<ServoSample> samples; ///< as they are now

    bool isIdentical() const { return different == 0; }
};

/// Gives a new ServoCore what the recorded one was given, at the same times.
/// \error BadValue  samples that name settings or patches that are not there
Result<Replay> replay(const Recording &recording);

} // namespace model::haptics
