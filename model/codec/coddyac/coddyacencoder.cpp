// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/coddyac/coddyacencoder.h"

#include "model/codec/coddyac/coddyacsyntax.h"
#include "model/codec/coddyac/lanestage.h"
#include "model/codec/coddyac/parallelogramstage.h"
#include "model/codec/connectivity/vertexorder.h"

#include <numeric>

namespace model::codec {

Result<CoddyacEncoder> CoddyacEncoder::prepare(const FrameSource &source, std::size_t trajectories,
                                               const Progress &progress)
{
    Result<FrameStack> frames = FrameStack::gather(source, progress.part(0, 0.1));
    if (!frames)
        return fail(std::move(frames).error());
    Result<EncodedConnectivity> connectivity = encodeConnectivity(source.connectivity(), progress.part(0.1, 0.15));
    if (!connectivity)
        return fail(std::move(connectivity).error());
    Result<PrincipalComponents> components = PrincipalComponents::of(*frames, trajectories, progress.part(0.15, 0.9));
    if (!components)
        return fail(std::move(components).error());
    Result<std::vector<double>> norms = coefficientNorms(*frames, *components, progress.part(0.9, 1));
    if (!norms)
        return fail(std::move(norms).error());
    return CoddyacEncoder(source, std::move(*frames), std::move(*components), std::move(*norms),
                          std::move(*connectivity));
}

Result<EncodedAnimation> CoddyacEncoder::encode(const CoddyacSettings &settings, bool keepOrder, double &squaredError,
                                                const Progress &progress) const
{
    using namespace coddyac;
    const CodedConnectivity &coded = mConnectivity.coded;
    const Result<QuantizedCoddyac> quantized = quantizedCoddyac(mFrames, mComponents, mNorms, settings, coded,
                                                                mConnectivity.permutation, progress.part(0, 0.5));
    if (!quantized)
        return fail(quantized.error());
    squaredError = quantized->squaredError;
    const Result<Bytes> coefficients =
        encodeByParallelograms(quantized->rank, quantized->coefficients, coded.neighbours, progress.part(0.5, 1));
    if (!coefficients)
        return fail(coefficients.error());

    const Header header = headerOf(*mSource, CodecId::Coddyac);
    SyntaxWriter syntax;
    Parameters parameters{settings, quantized->unit, quantized->rank, {}};
    parameters.fineness.assign(quantized->fineness.begin(), quantized->fineness.end());
    parameterSyntax(syntax, std::as_const(parameters), header);
    ContainerWriter writer(header);
    writer.chunk(ParametersTag, syntax.take());
    writer.chunk(ConnectivityTag, mConnectivity.bytes);
    if (keepOrder)
        writer.chunk(OrderTag, encodeVertexOrder(mConnectivity.permutation, coded.neighbours));
    writer.chunk(MeansTag, encodeLanes(mFrames.rowCount(), quantized->means));
    writer.chunk(BasisTag, encodeLanes(mFrames.rowCount(), quantized->basis));
    writer.chunk(CoefficientsTag, *coefficients);
    EncodedAnimation encoded{writer.finish(), mConnectivity.permutation};
    if (keepOrder)
        std::iota(encoded.permutation.begin(), encoded.permutation.end(), 0u);
    progress.report(1);
    return encoded;
}

} // namespace model::codec
