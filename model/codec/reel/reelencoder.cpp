// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/reel/reelencoder.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

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
    /// Of all that was chosen, but for the tails of large residuals.
    double bits() const { return mCoder.bits; }

private:
    /// Takes decisions as a range coder does, and writes nothing.
    struct CountingCoder
    {
        std::uint32_t decision(std::uint32_t probabilityOfOne, std::uint32_t value)
        {
            bits += DecisionCost::of(probabilityOfOne, value);
            return value;
        }
        std::uint32_t direct(unsigned count, std::uint32_t value)
        {
            bits += count;
            return value;
        }
        std::uint32_t bit(AdaptiveBit &model, std::uint32_t value) { return model.update(value), value; }

        double bits = 0;
    };

    double mBitPrice;
    CountingCoder mCoder;
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

ReelEncoder::ReelEncoder(const FrameStack &frames, Trajectories trajectories, EncodedConnectivity connectivity,
                         CoarseToFine vertexNodes)
    : mFrames(&frames)
    , mConnectivity(std::move(connectivity))
    , mFrameNodes(coarseToFineInTime(frames.frameCount()))
    , mWhole{{}, {}, std::move(vertexNodes), nullptr, std::move(trajectories)}
    , mComponents(componentsOf(mWhole.nodes))
{
    for (std::uint32_t node = 0; node < mWhole.nodes.size(); ++node) {
        mWhole.members.push_back(node);
        mWhole.columns.push_back(inputVertex(node));
    }
}

ReelEncoder::ReelEncoder(ReelEncoder &&) noexcept = default;
ReelEncoder::~ReelEncoder() = default;

Result<ReelEncoder> ReelEncoder::prepare(const FrameStack &frames, EncodedConnectivity connectivity,
                                         const Progress &progress)
{
    Result<Trajectories> trajectories = Trajectories::of(frames, frames.rowMeans(), progress.part(0, 0.8));
    if (!trajectories)
        return fail(trajectories.error());
    Result<CoarseToFine> nodes = coarseToFine(connectivity.coded.connectivity, progress.part(0.8, 1));
    if (!nodes)
        return fail(nodes.error());
    return ReelEncoder(frames, std::move(*trajectories), std::move(connectivity), std::move(*nodes));
}

// What steps are measured by where all vertices of a frame are in one point.
double ReelEncoder::meanMotion() const
{
    const std::vector<double> &means = trajectories().means();
    double squares = 0;
    for (std::size_t row = 0; row < means.size(); ++row)
        squares += (means[row] - means[row % 3]) * (means[row] - means[row % 3]);
    return squares > 0 ? std::sqrt(squares) : 1;
}

/// How many trajectories are stronger than `least`. \param most  no more
Result<std::size_t> basisSizeFor(Trajectories &trajectories, std::size_t most, double least, const Progress &progress)
{
    std::size_t count = std::min(most, FirstSearch);
    for (;;) {
        if (const auto found = trajectories.find(count, progress); !found)
            return fail(found.error());
        const std::vector<double> &strengths = trajectories.strengths();
        std::size_t kept = 0;
        while (kept < std::min(most, strengths.size()) && strengths[kept] > least)
            ++kept;
        if (kept < strengths.size() || trajectories.hasAll() || count == most)
            return kept;
        count = std::min(most, 2 * count);
    }
}

double ReelEncoder::stepOf(const ReelSettings &settings) const
{
    const double norm = std::sqrt(trajectories().energy() / double(mWhole.nodes.size()));
    return settings.step * (norm > 0 ? norm : meanMotion());
}

Result<ReelChoice> ReelEncoder::choose(const ReelSettings &settings, const Progress &progress)
{
    const bool hasComponents = std::ranges::any_of(mComponents, [](std::uint32_t c) { return c > 0; });
    Part *whole = &mWhole;
    Result<ReelChoice> choice = chooseFor({&whole, 1}, {}, settings, progress.part(0, hasComponents ? 0.4 : 1));
    if (!choice || !hasComponents)
        return choice;
    const Result<Clusters> clusters = findClusters(*choice, progress.part(0.4, 0.5));
    if (!clusters)
        return fail(clusters.error());
    if (clusters->count < 2)
        return choice;
    if (const auto done = split(*clusters, progress.part(0.5, 0.6)); !done)
        return fail(done.error());
    std::vector<Part *> parts;
    for (Part &part : mParts)
        parts.push_back(&part);
    Result<ReelChoice> split = chooseFor(parts, *clusters, settings, progress.part(0.6, 1));
    if (!split)
        return split;
    const double unit = choice->parameters.step * choice->parameters.step;
    const auto price = [&](const ReelChoice &c) { return c.squaredError / unit + BitPrice * c.bits; };
    return price(*split) < price(*choice) ? split : choice;
}

Result<Clusters> ReelEncoder::findClusters(const ReelChoice &whole, const Progress &progress) const
{
    const MatrixXd basis = trajectories().basis().leftCols(Index(whole.parameters.basisSize));
    const Result<MatrixXd> coefficients = trajectories().project(basis, trajectories().shape(), progress);
    if (!coefficients)
        return fail(coefficients.error());
    std::vector<std::uint32_t> ofColumns(mComponents.size());
    for (std::size_t node = 0; node < mComponents.size(); ++node)
        ofColumns[mWhole.columns[node]] = mComponents[node];
    return clustersOf(*coefficients, ofColumns, mFrames->rowCount(), whole.parameters.step, progress);
}

Result<void> ReelEncoder::split(const Clusters &clusters, const Progress &progress)
{
    if (clusters.labels == mPartLabels)
        return {};
    mParts.clear();
    mPartLabels = clusters.labels;
    const auto members = nodesOf(clusters, mComponents);
    for (const std::vector<std::uint32_t> &nodes : members) {
        std::vector<std::uint32_t> vertices;
        for (const std::uint32_t node : nodes)
            vertices.push_back(inputVertex(node));
        auto frames = std::make_unique<FrameStack>(mFrames->subset(vertices));
        Result<Trajectories> found = Trajectories::of(*frames, trajectories().means(), progress);
        if (!found) {
            mPartLabels.clear();
            return fail(found.error());
        }
        std::vector<std::uint32_t> columns(nodes.size());
        std::iota(columns.begin(), columns.end(), 0u);
        mParts.push_back(
            {nodes, std::move(columns), restrictedTo(mWhole.nodes, nodes), std::move(frames), std::move(*found)});
    }
    return {};
}

Result<ReelChoice> ReelEncoder::chooseFor(std::span<Part *const> parts, const Clusters &clusters,
                                          const ReelSettings &settings, const Progress &progress)
{
    const auto vertices = double(mWhole.nodes.size());
    ReelChoice choice;
    choice.clusters = clusters;
    ReelParameters &p = choice.parameters;
    p.wantedStep = settings.step;
    p.wantedBasisSize = settings.basisSize;
    p.step = stepOf(settings);
    p.shapeShare = ShapeShare;
    p.meanExponent = std::uint8_t(std::lround(4 * std::log2(vertices))); // step / sqrt(V)
    for (std::size_t axis = 0; axis < 3; ++axis)
        p.origin[axis] = float(trajectories().means()[axis]);
    p.shapeRatio = ShapeRatio;
    p.basisRatio = BasisRatio;
    p.coefficientRatio = CoefficientRatio;

    // The strongest first, whatever their part.
    struct Candidate
    {
        double norm;
        std::uint32_t part;
        Index k;
        double step; ///< in steps over the norm
    };
    std::vector<Candidate> kept;
    const std::size_t most = settings.basisSize ? settings.basisSize : ReelSettings::MaxBasisSize;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        const double share = valuesPerVertex(mFrameNodes.size(), parts[i]->nodes.size());
        const Result<std::size_t> count = basisSizeFor(parts[i]->trajectories, most, leastStrength(share) * p.step,
                                                       progress.part(0.2 * i / double(parts.size()), 0.2));
        if (!count)
            return fail(count.error());
        const double root = std::sqrt(double(parts[i]->nodes.size()));
        for (std::size_t k = 0; k < *count; ++k)
            kept.push_back({parts[i]->trajectories.strengths()[k] * root, i, Index(k), basisStep(share)});
    }
    if (parts.size() > 1)
        std::ranges::stable_sort(kept, std::greater(), &Candidate::norm);
    kept.resize(std::min(kept.size(), most));
    p.basisSize = std::uint32_t(kept.size());
    const double total = std::sqrt(trajectories().energy());
    MatrixXd wantedBasis(Index(mFrames->rowCount()), Index(kept.size()));
    std::vector<Index> ranks(parts.size());
    for (std::size_t k = 0; k < kept.size(); ++k) {
        choice.labels.push_back(kept[k].part);
        const double wanted = kept[k].step * settings.step / (kept[k].norm / total * std::sqrt(vertices));
        choice.stepExponents.push_back(std::int32_t(std::lround(8 * std::log2(wanted))));
        wantedBasis.col(Index(k)) = parts[kept[k].part]->trajectories.basis().col(kept[k].k);
        ++ranks[kept[k].part];
    }
    // The trajectories of one part.
    const auto partOf = [&](const MatrixXd &basis, std::uint32_t part) {
        MatrixXd own(basis.rows(), ranks[part]);
        for (Index k = 0, to = 0; k < basis.cols(); ++k)
            if (choice.labels[std::size_t(k)] == part)
                own.col(to++) = basis.col(k);
        return own;
    };

    const auto stopped = [&](const char *what) {
        return progress.isCancelled() ? fail(ErrorCode::Cancelled)
                                      : fail(ErrorCode::LimitExceeded, std::string(what) + " in steps",
                                             std::to_string(MaxResidual), std::to_string(MaxResidual));
    };
    MatrixXd shape;
    std::vector<Point> places;
    const bool shapeFits = chooseShape(choice, shape, places, progress);
    if (!shapeFits)
        return stopped("position");
    progress.report(0.3);
    std::vector<MatrixXd> shapes(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        shapes[i].resize(3, Index(parts[i]->nodes.size()));
        for (std::size_t node = 0; node < parts[i]->nodes.size(); ++node)
            shapes[i].col(Index(parts[i]->columns[node])) = shape.col(Index(inputVertex(parts[i]->members[node])));
    }

    // The trajectories, the coefficients that fit them best as they were decoded, and once more the trajectories that
    // fit those best: 2 - 3 % of the size.
    MatrixXd basis;
    if (chooseBasis(choice, wantedBasis, basis, progress.part(0.3, 0.3)) < 0)
        return stopped("basis");
    std::vector<MatrixXd> wanted(parts.size()), coefficients;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        const MatrixXd own = partOf(basis, i);
        const Result<MatrixXd> projected = parts[i]->trajectories.project(own, shapes[i], progress.part(0.3, 0.4));
        if (!projected)
            return fail(projected.error());
        wanted[i] = divided(projected->transpose(), own.transpose() * own).transpose();
    }
    const double coefficientBits =
        chooseCoefficients(choice, parts, wanted, places, coefficients, progress.part(0.4, 0.8));
    if (coefficientBits < 0)
        return stopped("coefficient");
    std::vector<MatrixXd> correlations(parts.size());
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        Result<MatrixXd> correlated =
            parts[i]->trajectories.correlate(coefficients[i], shapes[i], progress.part(0.8, 0.95));
        if (!correlated)
            return fail(correlated.error());
        correlations[i] = std::move(*correlated);
        const MatrixXd refitted = divided(correlations[i], coefficients[i] * coefficients[i].transpose());
        for (Index k = 0, from = 0; k < wantedBasis.cols(); ++k)
            if (choice.labels[std::size_t(k)] == i)
                wantedBasis.col(k) = refitted.col(from++);
    }
    const double basisBits = chooseBasis(choice, wantedBasis, basis, progress.part(0.95, 1));
    if (basisBits < 0)
        return stopped("basis");
    choice.bits = basisBits + coefficientBits;

    // What is left in the mean over the vertices, the mean vertices can take.
    Eigen::VectorXd left = constantTrajectory(shape.rowwise().sum(), mFrameNodes.size());
    double squares = 0;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        const MatrixXd own = partOf(basis, i);
        left += own * coefficients[i].rowwise().sum();
        squares += parts[i]->trajectories.energyAbout(shapes[i]) - 2 * own.cwiseProduct(correlations[i]).sum() +
                   (coefficients[i] * coefficients[i].transpose()).cwiseProduct(own.transpose() * own).sum();
    }
    left /= -vertices;
    if (!chooseMeans(choice, left))
        return stopped("position");
    choice.squaredError += std::max(0.0, squares - vertices * left.squaredNorm());
    progress.report(1);
    return choice;
}

bool ReelEncoder::chooseShape(ReelChoice &choice, MatrixXd &decoded, std::vector<Point> &places,
                              const Progress &progress) const
{
    const ReelParameters &p = choice.parameters;
    Chooser chooser(ShapeBitPrice);
    ShapeCoder coder(mWhole.nodes, levelRatio(p.shapeRatio));
    const MatrixXd wanted = trajectories().shape() / shapeStep(p);
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
    BandModel learned;
    BandCoder coder(mFrameNodes, krigingWeights(mFrameNodes, framePlaces(mFrameNodes)),
                    {3, levelRatio(choice.parameters.basisRatio), TimeRidge}, learned);
    double squares = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto wanted = [&](std::size_t node) {
            const std::size_t row = 3 * mFrameNodes.vertices[node] + axis;
            return trajectories().means()[row] + left[Index(row)] - double(choice.parameters.origin[axis]);
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
    choice.squaredError = squares * double(mWhole.nodes.size());
    return !chooser.exceeded();
}

double ReelEncoder::chooseBasis(ReelChoice &choice, const MatrixXd &wanted, MatrixXd &decoded,
                                const Progress &progress) const
{
    const std::size_t rank = choice.parameters.basisSize;
    Chooser chooser(BitPrice);
    BandModel learned;
    BandCoder coder(mFrameNodes, krigingWeights(mFrameNodes, framePlaces(mFrameNodes)),
                    {3 * rank, levelRatio(choice.parameters.basisRatio), TimeRidge}, learned);
    choice.basis.clear();
    decoded.resize(wanted.rows(), wanted.cols());
    for (std::size_t band = 0; band < 3 * rank; ++band) {
        if (progress.isCancelled())
            return -1;
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
    return chooser.exceeded() ? -1 : chooser.bits();
}

double ReelEncoder::chooseCoefficients(ReelChoice &choice, std::span<Part *const> parts,
                                       std::span<const MatrixXd> wanted, const std::vector<Point> &places,
                                       std::vector<MatrixXd> &decoded, const Progress &progress) const
{
    const double step = choice.parameters.step;
    Chooser chooser(BitPrice);
    BandModel learned;
    std::vector<BandCoder> coders;
    coders.reserve(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::vector<Point> own;
        for (const std::uint32_t node : parts[i]->members)
            own.push_back(places[node]);
        coders.emplace_back(
            parts[i]->nodes, krigingWeights(parts[i]->nodes, own),
            BandSettings{std::size_t(wanted[i].rows()), levelRatio(choice.parameters.coefficientRatio), MeshRidge},
            learned);
        decoded.emplace_back(wanted[i].rows(), wanted[i].cols());
    }
    choice.coefficients.clear();
    for (std::size_t done = 0; const std::uint32_t label : choice.labels) {
        if (progress.isCancelled())
            return -1;
        const Part &part = *parts[label];
        BandCoder &coder = coders[label];
        const Index k = Index(coder.band());
        coder.nextBand([&](BandCoder::Model &m, const auto &contexts, std::size_t set, std::uint32_t node,
                           double predicted, double level) {
            const double value = wanted[label](k, part.columns[node]) / step;
            const std::int32_t q = chooser(m, contexts, set, (value - predicted) / level);
            choice.coefficients.push_back(q);
            return q;
        });
        for (std::size_t node = 0; node < part.nodes.size(); ++node)
            decoded[label](k, part.columns[node]) = coder.value(node, std::size_t(k)) * step;
        progress.report(double(++done) / double(choice.labels.size()));
    }
    return chooser.exceeded() ? -1 : chooser.bits();
}

} // namespace model::codec
