// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/record/recording.h"

#include <zlib.h>

#include <cmath>

namespace model::haptics {

namespace {

constexpr std::string_view Magic = "SRHAPTIC";
enum class Tag : std::uint8_t { End = 0, Settings = 1, Patch = 2, Sample = 3 };
constexpr std::size_t LongestText = 1000;
/// ns
constexpr std::int64_t LargestTime = std::int64_t(1) << 62;

std::uint32_t checksumOf(std::span<const std::uint8_t> bytes)
{
    return std::uint32_t(crc32_z(0, bytes.data(), bytes.size()));
}

/// The two directions of one syntax: a field is written or read by the same line (FORMAT.md 3).
class Writer
{
public:
    void u8(std::uint8_t &value) { bytes.u8(value); }
    void u32(std::uint32_t &value) { bytes.u32(value); }
    void u64(std::uint64_t &value) { bytes.u64(value); }
    void f32(float &value) { bytes.f32(value); }
    /// Any number, NaN too: what went into the servo is recorded as it was.
    void f64(double &value) { bytes.f64(value); }
    void finite(double &value, const char *) { bytes.f64(value); }
    void positive(double &value, const char *) { bytes.f64(value); }
    void time(Time &value) { bytes.u64(std::uint64_t(value.count())); }
    void flag(bool &value, const char *) { bytes.u8(value); }
    template <class Enum>
    void choice(Enum &value, Enum, Enum, const char *)
    {
        bytes.u8(std::uint8_t(value));
    }
    void triangles(std::vector<std::array<Vec3f, 3>> &list)
    {
        std::uint32_t count = std::uint32_t(list.size());
        u32(count);
        for (auto &triangle : list)
            for (Vec3f &corner : triangle)
                for (float *const value : {&corner.x, &corner.y, &corner.z})
                    f32(*value);
    }

    ByteWriter bytes;
};

class Reader
{
public:
    explicit Reader(std::span<const std::uint8_t> data)
        : bytes(data)
    {}
    void u8(std::uint8_t &value) { value = bytes.u8(); }
    void u32(std::uint32_t &value) { value = bytes.u32(); }
    void u64(std::uint64_t &value) { value = bytes.u64(); }
    void f32(float &value)
    {
        value = bytes.f32();
        requireFinite(value, "triangle");
    }
    void f64(double &value) { value = bytes.f64(); }
    void finite(double &value, const char *name)
    {
        value = bytes.f64();
        requireFinite(value, name);
    }
    void positive(double &value, const char *name)
    {
        finite(value, name);
        if (!(value > 0) && bytes.ok())
            bytes.setError(
                {ErrorCode::BadValue, {name, std::to_string(value), "above 0"}, {}, Error::None, bytes.offset()});
    }
    void time(Time &value)
    {
        const std::int64_t count = std::int64_t(bytes.u64());
        if (bytes.require(count >= 0 && count <= LargestTime, "time", std::uint64_t(count), "0 ... 2^62"))
            value = Time(count);
    }
    void flag(bool &value, const char *name)
    {
        const std::uint8_t byte = bytes.u8();
        bytes.require(byte <= 1, name, byte, "0 ... 1");
        value = byte == 1;
    }
    template <class Enum>
    void choice(Enum &value, Enum least, Enum most, const char *name)
    {
        const std::uint8_t byte = bytes.u8();
        if (bytes.require(byte >= std::uint8_t(least) && byte <= std::uint8_t(most), name, byte,
                          std::to_string(int(least)) + " ... " + std::to_string(int(most))))
            value = Enum(byte);
    }
    void triangles(std::vector<std::array<Vec3f, 3>> &list)
    {
        std::uint32_t count = 0;
        u32(count);
        constexpr std::uint32_t Bytes = 36;
        if (!bytes.require(count <= TerrainPatch::MaxTriangles && std::size_t(count) * Bytes <= bytes.left(),
                           "triangle count", count, "0 ... 512"))
            return;
        list.resize(count);
        for (auto &triangle : list)
            for (Vec3f &corner : triangle)
                for (float *const value : {&corner.x, &corner.y, &corner.z})
                    f32(*value);
    }

    ByteReader bytes;

private:
    void requireFinite(double value, const char *name)
    {
        if (!std::isfinite(value) && bytes.ok())
            bytes.setError({ErrorCode::NonFinite, {name}, {}, Error::None, bytes.offset()});
    }
};

template <class Stream>
void vectorSyntax(Stream &s, Vec3d &v)
{
    s.f64(v.x);
    s.f64(v.y);
    s.f64(v.z);
}

template <class Stream>
void feelSyntax(Stream &s, Feel &feel) // FORMAT.md 3.2
{
    s.finite(feel.resistance, "resistance");
    s.finite(feel.crust, "crust");
    s.finite(feel.plough, "plough");
    s.finite(feel.elasticity, "elasticity");
    s.finite(feel.damping, "damping");
    s.finite(feel.hold, "hold");
    s.finite(feel.graininess, "graininess");
    s.finite(feel.grainSize, "grain size");
}

template <class Stream>
void settingsSyntax(Stream &s, ServoSettings &settings) // FORMAT.md 3.3
{
    s.u64(settings.id);
    s.finite(settings.workspace.origin.x, "origin");
    s.finite(settings.workspace.origin.y, "origin");
    s.finite(settings.workspace.origin.z, "origin");
    s.positive(settings.workspace.scale, "scale");
    s.finite(settings.workspace.toolRadius, "tool radius");
    s.choice(settings.law, LawKind::Granular, LawKind::Reference2009AlongMotion, "law");
    s.finite(settings.gain, "gain");
    s.finite(settings.limits.deviceForce, "device force");
    s.finite(settings.limits.userForce, "user force");
    s.finite(settings.limits.power, "power");
    vectorSyntax(s, settings.limits.low);
    vectorSyntax(s, settings.limits.high);
    s.finite(settings.limits.wallStiffness, "wall stiffness");
    s.finite(settings.limits.wallForce, "wall force");
    s.flag(settings.overridesFeel, "feel flag");
    feelSyntax(s, settings.feel);
    s.finite(settings.deviceDamping, "device damping");
}

template <class Stream>
void patchSyntax(Stream &s, RecordedPatch &patch) // FORMAT.md 3.4
{
    s.u64(patch.id);
    s.time(patch.time);
    s.finite(patch.centre.x, "centre");
    s.finite(patch.centre.y, "centre");
    s.finite(patch.centreHeight, "height");
    s.positive(patch.radius, "radius");
    feelSyntax(s, patch.feel);
    s.flag(patch.isRefresh, "refresh flag");
    if (!patch.isRefresh)
        s.triangles(patch.triangles);
}

template <class Stream>
void sampleSyntax(Stream &s, ServoSample &sample) // FORMAT.md 3.5
{
    s.time(sample.now);
    vectorSyntax(s, sample.reading.position);
    s.u32(sample.reading.buttons);
    s.time(sample.reading.time);
    s.flag(sample.reading.isConnected, "connection flag");
    s.u64(sample.patch);
    s.u64(sample.settings);
    s.flag(sample.wantsForces, "force flag");
    vectorSyntax(s, sample.force);
    vectorSyntax(s, sample.lawForce);
    s.f64(sample.depth);
    s.choice(sample.state, SafetyState::Stopped, SafetyState::Fading, "state");
    s.choice(sample.cause, SafetyCause::None, SafetyCause::BadNumber, "cause");
}

void eventSyntax(Writer &s, ServoSettings event)
{
    s.bytes.u8(std::uint8_t(Tag::Settings));
    settingsSyntax(s, event);
}
void eventSyntax(Writer &s, RecordedPatch event)
{
    s.bytes.u8(std::uint8_t(Tag::Patch));
    patchSyntax(s, event);
}
void eventSyntax(Writer &s, ServoSample event)
{
    s.bytes.u8(std::uint8_t(Tag::Sample));
    sampleSyntax(s, event);
}

} // namespace

Bytes writeRecording(const Recording &recording)
{
    Writer writer;
    for (const char c : Magic)
        writer.bytes.u8(std::uint8_t(c));
    writer.bytes.u16(RecordingVersion);
    writer.bytes.text(std::string_view(recording.device).substr(0, LongestText));
    writer.bytes.text(std::string_view(recording.note).substr(0, LongestText));
    for (const Recording::Event &event : recording.events)
        std::visit([&](const auto &e) { eventSyntax(writer, e); }, event);
    writer.bytes.u8(std::uint8_t(Tag::End));
    writer.bytes.u64(recording.lostSamples);
    writer.bytes.u32(checksumOf(writer.bytes.data()));
    return writer.bytes.take();
}

Result<Recording> readRecording(std::span<const std::uint8_t> bytes)
{
    if (bytes.size() > LargestRecording)
        return fail(ErrorCode::LimitExceeded, "recording", std::to_string(bytes.size()),
                    std::to_string(LargestRecording));
    Reader reader(bytes);
    const auto magic = reader.bytes.bytes(Magic.size());
    if (!reader.bytes.ok() || !std::equal(magic.begin(), magic.end(), Magic.begin()))
        return fail(ErrorCode::BadMagic, "haptic recording");
    const std::uint16_t version = reader.bytes.u16();
    if (reader.bytes.ok() && version != RecordingVersion)
        return fail(ErrorCode::UnsupportedVersion, std::to_string(version), std::to_string(RecordingVersion));
    Recording recording;
    recording.device = reader.bytes.text(LongestText);
    recording.note = reader.bytes.text(LongestText);
    for (bool isOver = false; reader.bytes.ok() && !isOver;) {
        const std::uint8_t tag = reader.bytes.u8();
        const auto take = [&](auto event, auto syntax) {
            syntax(event);
            if (reader.bytes.ok())
                recording.events.emplace_back(std::move(event));
        };
        switch (Tag(tag)) {
        case Tag::End:
            isOver = true;
            break;
        case Tag::Settings:
            take(ServoSettings(), [&](ServoSettings &event) { settingsSyntax(reader, event); });
            break;
        case Tag::Patch:
            take(RecordedPatch(), [&](RecordedPatch &event) { patchSyntax(reader, event); });
            break;
        case Tag::Sample:
            take(ServoSample(), [&](ServoSample &event) { sampleSyntax(reader, event); });
            break;
        default:
            reader.bytes.require(false, "record tag", tag, "0 ... 3");
        }
    }
    recording.lostSamples = reader.bytes.u64();
    const std::size_t covered = std::size_t(reader.bytes.offset());
    const std::uint32_t checksum = reader.bytes.u32();
    reader.bytes.requireEnd();
    if (!reader.bytes.ok())
        return fail(reader.bytes.error());
    if (checksum != checksumOf(bytes.first(covered)))
        return fail(ErrorCode::ChecksumMismatch, "recording");
    return recording;
}

void Recorder::add(const TerrainPatch &patch)
{
    RecordedPatch event{patch.id, patch.time, patch.centre, patch.centreHeight, patch.radius, patch.feel, {}, false};
    const auto surface = patch.surface();
    event.isRefresh =
        !mTriangles.empty() && std::equal(surface.begin(), surface.end(), mTriangles.begin(), mTriangles.end());
    if (!event.isRefresh) {
        mTriangles.assign(surface.begin(), surface.end());
        event.triangles = mTriangles;
    }
    mRecording.events.emplace_back(std::move(event));
}

void Recorder::add(std::span<const ServoSample> samples)
{
    mRecording.events.insert(mRecording.events.end(), samples.begin(), samples.end());
}

} // namespace model::haptics
