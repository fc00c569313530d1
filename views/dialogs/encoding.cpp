// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/encoding.h"

#include "model/animation/editedframes.h"
#include "model/codec/animationcodec.h"
#include "model/io/animfile.h"

#include <QElapsedTimer>

namespace views {

using namespace model;

namespace {

// Shares of the progress bar, as measured on the dance sequence.
constexpr double NormalisedAt = 0.05;
constexpr double EncodedAt = 0.7;
constexpr double DecodedAt = 0.75;

} // namespace

Result<EncodingReport> encodeToFile(const EncodingOrder &order, const Progress &progress)
{
    QElapsedTimer clock;
    clock.start();
    const FrameSource &source = *order.frames;
    const auto placement = normalisingSimilarity(source, order.normalisation, progress.part(0, NormalisedAt));
    if (!placement)
        return fail(placement.error());
    const auto placed = std::make_shared<const EditedFrames>(order.frames, TimeMap::identity(source.frameCount()),
                                                             *placement, order.frameRate, order.name.toStdString());
    const EditedFrames &edited = *placed;

    auto encoded = codec::encodeAnimation(edited, order.settings, progress.part(NormalisedAt, EncodedAt));
    if (!encoded)
        return fail(encoded.error());
    EncodingReport report;
    report.encodingSeconds = double(clock.elapsed()) / 1000;

    const auto decoded = codec::decodeAnimation(encoded->bytes, progress.part(EncodedAt, DecodedAt),
                                                codec::DecodeLimits::ofThisMachine(encoded->bytes.size()));
    if (!decoded)
        return fail(decoded.error());
    auto errors = compareAnimations(edited, **decoded, encoded->permutation, progress.part(DecodedAt, 1));
    if (!errors)
        return fail(errors.error());
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (const auto saved = io::saveBytes(order.output, encoded->bytes); !saved)
        return fail(saved.error());

    const double samples = double(source.vertexCount()) * source.frameCount();
    report.order = order;
    report.order.frames = nullptr;
    report.original = std::make_shared<const Original>(Original{placed, std::move(encoded->permutation)});
    report.fileBytes = encoded->bytes.size();
    report.rawBytes = std::uint64_t(samples) * sizeof(Vec3f);
    report.bitsPerFrameAndVertex = 8 * double(report.fileBytes) / samples;
    report.errors = std::move(*errors);
    return report;
}

} // namespace views
