// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/inspect/fieldoffers.h"

#include "model/animation/vertexmotion.h"
#include "model/codec/basis/principalfields.h"
#include "model/mesh/analysis/vertexfields.h"

#include <algorithm>
#include <mutex>
#include <optional>

namespace editor {

namespace {

constexpr std::size_t CoefficientCount = 6; ///< in the list of fields

/// All coefficients come out of one computation: the first that is asked for makes them.
struct SharedCoefficients
{
    std::mutex mutex;
    std::optional<model::codec::PrincipalFields> fields;
};

} // namespace

std::vector<views::FieldOffer> meshFields(const std::shared_ptr<const model::PolygonMesh> &mesh)
{
    using views::FieldKind;
    using Values = model::Result<std::vector<float>>;
    return {
        {{FieldKind::MeanCurvature},
         [mesh](const model::Progress &) -> Values { return curvatures(mesh->faces, mesh->positions).mean; }},
        {{FieldKind::GaussianCurvature},
         [mesh](const model::Progress &) -> Values { return curvatures(mesh->faces, mesh->positions).gaussian; }},
        {{FieldKind::Valence}, [mesh](const model::Progress &) -> Values { return valences(mesh->faces); }},
    };
}

std::vector<views::FieldOffer> frameFields(const model::FrameSourcePtr &frames, const views::OriginalPtr &original,
                                           std::uint32_t frame)
{
    using views::FieldKind;
    std::vector<views::FieldOffer> offers;
    if (original)
        offers.push_back({{FieldKind::CodecError},
                          [frames, original, frame](const model::Progress &) -> model::Result<std::vector<float>> {
                              views::FrameData data;
                              views::makeFrame(frames, frame, data, original);
                              return std::move(data.errors);
                          }});
    offers.push_back({{FieldKind::TrajectoryLength}, [frames](const model::Progress &progress) {
                          return model::trajectoryLengths(*frames, progress);
                      }});
    if (frames->frameCount() < 2)
        return offers;
    const auto shared = std::make_shared<SharedCoefficients>();
    const std::size_t count = std::min<std::size_t>(CoefficientCount, frames->frameCount() - 1);
    for (std::size_t k = 0; k < count; ++k)
        offers.push_back(
            {{FieldKind::PcaCoefficient, int(k)},
             [frames, shared, count, k](const model::Progress &progress) -> model::Result<std::vector<float>> {
                 const std::lock_guard lock(shared->mutex);
                 if (!shared->fields) {
                     auto found = model::codec::principalFields(*frames, count, progress);
                     if (!found)
                         return model::fail(found.error());
                     shared->fields = std::move(*found);
                 }
                 // An animation of lower rank does not move in what is left.
                 if (k >= shared->fields->coefficients.size())
                     return std::vector<float>(frames->vertexCount(), 0.0f);
                 return shared->fields->coefficients[k];
             }});
    return offers;
}

} // namespace editor
