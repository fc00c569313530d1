// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/reel/reelencoder.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace model::codec {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Chosen on chicken, cow, dance, samba and horse-gallop at 1 % KG error, where each is near its optimum; that of the
// geometric mean of the sizes is flat: half or twice of each costs about 1 - 3 %.
// The rest shape's step, in 32ths of the coefficients' less one.
constexpr std::uint8_t ShapeShare = 47;
// Squared steps that a bit must save. On the rest shape others build, so less is asked.
constexpr double BitPrice = 0.12;
constexpr double ShapeBitPrice = 0.08;
// (n + 1) / 256.
constexpr std::uint8_t ShapeRatio = 243, BasisRatio = 252, CoefficientRatio = 240;
// How many smaller magnitudes are considered beside the nearest.
constexpr std::int32_t Smaller = 2;
// Added to the diagonals of normal equations, relative to their trace.
constexpr double Ridge = 1e-9;
// The least basis that is looked for; then twice that.
constexpr std::size_t FirstSearch = 48;

/// Chooses and codes residuals into a stream that is thrown away: only what the models learn matters.
class Chooser
{
public:
    explicit Chooser(double bitPrice)
        : mBitPrice(bitPrice)
    {}

    /// \param deviation  in steps
    template <class Model>
    std::int32_t operator()(Model &model, const typename Model::Contexts &contexts, std::size_t set, double deviation)
    {
        const double size = std::fabs(deviation);
        std::int32_t chosen = 0;
        if (!(size < MaxResidual)) {
            mExceeded = true;
        } else if (size >= 0.5) {
            const std::int32_t nearest = std::int32_t(size + 0.5);
            double least = HUGE_VAL;
            for (std::int32_t q = nearest; q >= std::max(0, nearest - Smaller); --q) {
                const double rest = size - q;
                const double price = rest * rest + mBitPrice * model.cost(contexts, set, q);
                if (price < least) {
                    least = price;
                    chosen = q;
                }
            }
        }
        if (deviation < 0)
            chosen = -chosen;
        model.code(mCoder, contexts, set, chosen);
        return chosen;
    }

    bool exceeded() const { return mExceeded; }

private:
    /// Takes decisions as a range coder does, and writes nothing.
    struct NullCoder
    {
        std::uint32_t decision(std::uint32_t, std::uint32_t value) { return value; }
        std::uint32_t direct(unsigned, std::uint32_t value) { return value; }
        std::uint32_t bit(AdaptiveBit &model, std::uint32_t value) { return model.update(value), value; }
    };

    double mBitPrice;
    NullCoder mCoder;
    bool mExceeded = false;
};

// What suits the basis depends on how much of the file it is: on the values of a trajectory for each vertex. Chosen on
// the five and bone, cloth_honey, faerie_md2, fox_survey, morph_columns and robot_dance, 0.02 to 1.6 of them.
double valuesPerVertex(std::size_t frames, std::size_t vertices)
{
    return 3 * double(frames) / double(vertices);
}

/// Basis trajectories of less than this many steps (root mean square over the vertices) are left out: the dearer they
/// are, the more they must bring.
double leastStrength(double share)
{
    return std::clamp(0.8 * std::sqrt(share), 0.2, 0.4);
}

/// The step of a basis trajectory, in steps over the norm of its coefficients. 1 would balance the errors; but where
/// vertices are many, the bits are spent better on them, whose neighbours learn from them.
double basisStep(double share)
{
    return std::clamp(0.78 * std::pow(share, -0.28), 0.7, 1.6);
}

/// X with X m = b, for a symmetric positive semidefinite m.
MatrixXd divided(const MatrixXd &b, MatrixXd m)
{
    m.diagonal().array() += Ridge * m.trace();
    return m.ldlt().solve(b.transpose()).transpose();
}

/// What a place of the shape, times sqrt(F), adds to each frame.
Eigen::VectorXd constantTrajectory(const Eigen::Vector3d &place, std::size_t frames)
{
    return place.replicate(Index(frames), 1) / std::sqrt(double(frames));
}

} // namespace

ReelEncoder::ReelEncoder(Trajectories trajectories, EncodedConnectivity connectivity, CoarseToFine vertexNodes,
                         std::uint32_t frameCount)
    : mTrajectories(std::move(trajectories))
    , mConnectivity(std::move(connectivity))
    , mVertexNodes(std::move(vertexNodes))
    , mFrameNodes(coarseToFineInTime(frameCount))
{}

ReelEncoder::ReelEncoder(ReelEncoder &&) noexcept = default;
ReelEncoder::~ReelEncoder() = default;

Result<ReelEncoder> ReelEncoder::prepare(const FrameStack &frames, EncodedConnectivity connectivity,
                                         const Progress &progress)
{
    Result<Trajectories> trajectories = Trajectories::of(frames, progress.part(0, 0.8));
    if (!trajectories)
        return fail(trajectories.error());
    Result<CoarseToFine> nodes = coarseToFine(connectivity.coded.connectivity, progress.part(0.8, 1));
    if (!nodes)
        return fail(nodes.error());
    return ReelEncoder(std::move(*trajectories), std::move(connectivity), std::move(*nodes), frames.frameCount());
}

// What steps are measured by where all vertices of a frame are in one point.
double ReelEncoder::meanMotion() const
{
    const std::vector<double> &means = mTrajectories.means();
    double squares = 0;
    for (std::size_t row = 0; row < means.size(); ++row)
        squares += (means[row] - means[row % 3]) * (means[row] - means[row % 3]);
    return squares > 0 ? std::sqrt(squares) : 1;
}

Result<std::size_t> ReelEncoder::basisSizeFor(const ReelSettings &settings, double step, const Progress &progress)
{
    const double least = leastStrength(valuesPerVertex(mFrameNodes.size(), mVertexNodes.size()));
    const std::size_t most = settings.basisSize ? settings.basisSize : ReelSettings::MaxBasisSize;
    std::size_t count = std::min(most, FirstSearch);
    for (;;) {
        if (const auto found = mTrajectories.find(count, progress); !found)
            return fail(found.error());
        const std::vector<double> &strengths = mTrajectories.strengths();
        std::size_t kept = 0;
        while (kept < std::min(most, strengths.size()) && strengths[kept] > least * step)
            ++kept;
        if (kept < strengths.size() || mTrajectories.hasAll() || count == most)
            return kept;
        count = std::min(most, 2 * count);
    }
}

Result<ReelChoice> ReelEncoder::choose(const ReelSettings &settings, const Progress &progress)
{
    const auto vertices = double(mVertexNodes.size());
    ReelChoice choice;
    ReelParameters &p = choice.parameters;
    p.wantedStep = settings.step;
    p.wantedBasisSize = settings.basisSize;
    const double norm = std::sqrt(mTrajectories.energy() / vertices);
    p.step = settings.step * (norm > 0 ? norm : meanMotion());
    p.shapeShare = ShapeShare;
    p.meanExponent = std::uint8_t(std::lround(4 * std::log2(vertices))); // step / sqrt(V)
    for (std::size_t axis = 0; axis < 3; ++axis)
        p.origin[axis] = float(mTrajectories.means()[axis]);
    p.shapeRatio = ShapeRatio;
    p.basisRatio = BasisRatio;
    p.coefficientRatio = CoefficientRatio;

    const Result<std::size_t> basisSize = basisSizeFor(settings, p.step, progress.part(0, 0.2));
    if (!basisSize)
        return fail(basisSize.error());
    p.basisSize = std::uint32_t(*basisSize);
    const double share = basisStep(valuesPerVertex(mFrameNodes.size(), mVertexNodes.size()));
    for (std::size_t k = 0; k < *basisSize; ++k) {
        const double wanted = share * settings.step / (mTrajectories.strengths()[k] / norm * std::sqrt(vertices));
        choice.stepExponents.push_back(std::int32_t(std::lround(8 * std::log2(wanted))));
    }

    const auto tooLarge = [&](const char *what) {
        return fail(ErrorCode::LimitExceeded, std::string(what) + " in steps", std::to_string(MaxResidual),
                    std::to_string(MaxResidual));
    };
    MatrixXd shape;
    std::vector<Point> places;
    const bool shapeFits = chooseShape(choice, shape, places, progress);
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (!shapeFits)
        return tooLarge("position");
    progress.report(0.3);

    // The trajectories, the coefficients that fit them best as they were decoded, and once more the trajectories that
    // fit those best: 2 - 3 % of the size.
    MatrixXd basis, coefficients;
    if (!chooseBasis(choice, mTrajectories.basis().leftCols(Index(*basisSize)), basis))
        return tooLarge("basis");
    const Result<MatrixXd> projected = mTrajectories.project(basis, shape, progress.part(0.3, 0.4));
    if (!projected)
        return fail(projected.error());
    const MatrixXd wanted = divided(projected->transpose(), basis.transpose() * basis).transpose();
    if (!chooseCoefficients(choice, wanted, krigingWeights(mVertexNodes, places), coefficients,
                            progress.part(0.4, 0.8)))
        return progress.isCancelled() ? fail(ErrorCode::Cancelled) : tooLarge("coefficient");
    const Result<MatrixXd> correlated = mTrajectories.correlate(coefficients, shape, progress.part(0.8, 0.95));
    if (!correlated)
        return fail(correlated.error());
    const MatrixXd products = coefficients * coefficients.transpose();
    if (!chooseBasis(choice, divided(*correlated, products), basis))
        return tooLarge("basis");

    // What is left in the mean over the vertices, the mean vertices can take.
    const Eigen::VectorXd left =
        (constantTrajectory(shape.rowwise().sum(), mFrameNodes.size()) + basis * coefficients.rowwise().sum()) /
        -vertices;
    if (!chooseMeans(choice, left))
        return tooLarge("position");
    choice.squaredError +=
        std::max(0.0, mTrajectories.energyAbout(shape) - 2 * basis.cwiseProduct(*correlated).sum() +
                          products.cwiseProduct(basis.transpose() * basis).sum() - vertices * left.squaredNorm());
    progress.report(1);
    return choice;
}

bool ReelEncoder::chooseShape(ReelChoice &choice, MatrixXd &decoded, std::vector<Point> &places,
                              const Progress &progress) const
{
    const ReelParameters &p = choice.parameters;
    Chooser chooser(ShapeBitPrice);
    ShapeCoder coder(mVertexNodes, levelRatio(p.shapeRatio));
    const MatrixXd wanted = mTrajectories.shape() / shapeStep(p);
    const bool whole = coder.codeAll(
        [&](ShapeCoder::Model &model, const auto &contexts, std::size_t set, std::uint32_t node,
            const ExpectedPlace &expected, std::size_t axis, double step) {
            double deviation = 0;
            for (std::size_t c = 0; c < 3; ++c)
                deviation += (wanted(Index(c), inputVertex(node)) - expected.place[c]) * expected.axes[axis][c];
            const std::int32_t q = chooser(model, contexts, set, deviation / step);
            choice.shape.push_back(q);
            return q;
        },
        [&] { return !progress.isCancelled(); });
    places = coder.places();
    decoded.resize(3, Index(places.size()));
    for (std::size_t node = 0; node < places.size(); ++node)
        for (std::size_t c = 0; c < 3; ++c)
            decoded(Index(c), inputVertex(node)) = places[node][c] * shapeStep(p);
    return whole && !chooser.exceeded();
}

bool ReelEncoder::chooseMeans(ReelChoice &choice, const Eigen::VectorXd &left) const
{
    const double step = meanStep(choice.parameters);
    Chooser chooser(BitPrice);
    BandCoder coder(mFrameNodes, krigingWeights(mFrameNodes, framePlaces(mFrameNodes)),
                    {3, levelRatio(choice.parameters.basisRatio), TimeRidge});
    double squares = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto wanted = [&](std::size_t node) {
            const std::size_t row = 3 * mFrameNodes.vertices[node] + axis;
            return mTrajectories.means()[row] + left[Index(row)] - double(choice.parameters.origin[axis]);
        };
        coder.nextBand([&](BandCoder::Model &model, const auto &contexts, std::size_t set, std::uint32_t node,
                           double predicted, double level) {
            const std::int32_t q = chooser(model, contexts, set, (wanted(node) / step - predicted) / level);
            choice.means.push_back(q);
            return q;
        });
        for (std::size_t node = 0; node < mFrameNodes.size(); ++node) {
            const double error = wanted(node) - coder.value(node, axis) * step;
            squares += error * error;
        }
    }
    choice.squaredError = squares * double(mVertexNodes.size());
    return !chooser.exceeded();
}

bool ReelEncoder::chooseBasis(ReelChoice &choice, const MatrixXd &wanted, MatrixXd &decoded) const
{
    const std::size_t rank = choice.parameters.basisSize;
    Chooser chooser(BitPrice);
    BandCoder coder(mFrameNodes, krigingWeights(mFrameNodes, framePlaces(mFrameNodes)),
                    {3 * rank, levelRatio(choice.parameters.basisRatio), TimeRidge});
    choice.basis.clear();
    decoded.resize(wanted.rows(), wanted.cols());
    for (std::size_t band = 0; band < 3 * rank; ++band) {
        const Index k = Index(band / 3), axis = Index(band % 3);
        const double step = stepOfExponent(choice.stepExponents[band / 3]);
        coder.nextBand([&](BandCoder::Model &model, const auto &contexts, std::size_t set, std::uint32_t node,
                           double predicted, double level) {
            const double value = wanted(3 * Index(mFrameNodes.vertices[node]) + axis, k) / step;
            const std::int32_t q = chooser(model, contexts, set, (value - predicted) / level);
            choice.basis.push_back(q);
            return q;
        });
        for (std::size_t node = 0; node < mFrameNodes.size(); ++node)
            decoded(3 * Index(mFrameNodes.vertices[node]) + axis, k) = coder.value(node, band) * step;
    }
    return !chooser.exceeded();
}

bool ReelEncoder::chooseCoefficients(ReelChoice &choice, const MatrixXd &wanted, std::vector<Weights> weights,
                                     MatrixXd &decoded, const Progress &progress) const
{
    const std::size_t rank = choice.parameters.basisSize;
    const double step = choice.parameters.step;
    Chooser chooser(BitPrice);
    BandCoder coder(mVertexNodes, std::move(weights),
                    {rank, levelRatio(choice.parameters.coefficientRatio), MeshRidge});
    choice.coefficients.clear();
    decoded.resize(wanted.rows(), wanted.cols());
    for (std::size_t k = 0; k < rank; ++k) {
        if (progress.isCancelled())
            return false;
        coder.nextBand([&](BandCoder::Model &model, const auto &contexts, std::size_t set, std::uint32_t node,
                           double predicted, double level) {
            const double value = wanted(Index(k), inputVertex(node)) / step;
            const std::int32_t q = chooser(model, contexts, set, (value - predicted) / level);
            choice.coefficients.push_back(q);
            return q;
        });
        for (std::size_t node = 0; node < mVertexNodes.size(); ++node)
            decoded(Index(k), inputVertex(node)) = coder.value(node, k) * step;
        progress.report(double(k + 1) / double(rank));
    }
    return !chooser.exceeded();
}

} // namespace model::codec
