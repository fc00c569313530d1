// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - M. Alexa, W. Mueller: Representing Animations by Principal Components, 2000
// Differs: the eigenvectors come from the Gram matrix of the smaller side, and the coefficients are fitted to the basis
// as the decoder has it.
#include "model/codec/basis/principalbasis.h"

#include "model/base/parallel.h"
#include "model/codec/basis/eigenvectors.h"
#include "model/codec/basis/gram.h"
#include "model/codec/basis/kernels.h"
#include "model/codec/container/syntax.h"
#include "model/codec/entropy/bandstage.h"

#include <Eigen/Cholesky>

#include <atomic>
#include <cmath>
#include <numeric>

namespace model::codec {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using RowMajorMatrixF = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t BlockColumns = 256;
// Multiplications of one task at most, some tens of milliseconds: with hundreds of trajectories blocks become smaller.
constexpr std::size_t TaskProducts = 1u << 25;
// Added to the diagonal of U^T U, relative to its largest entry, so that trajectories that became dependent by
// quantisation do not make it singular. Its effect on the coefficients is below the precision of a float.
constexpr double Ridge = 1e-10;

/// Vertices of a block for whose every vertex there are so many multiplications.
std::size_t blockWidth(std::size_t productsPerVertex)
{
    return std::clamp<std::size_t>(TaskProducts / std::max<std::size_t>(productsPerVertex, 1), 8, BlockColumns);
}

struct Quantizer
{
    double resolution;
    const char *what;
    double limit;
    std::atomic<bool> exceeded = false;

    double operator()(double value)
    {
        const double q = std::round(value * resolution);
        if (!(std::fabs(q) <= limit)) {
            exceeded.store(true, std::memory_order_relaxed);
            return 0;
        }
        return q;
    }
    tl::unexpected<Error> error() const
    {
        return fail(ErrorCode::LimitExceeded, std::string(what) + " x resolution " + numberText(resolution),
                    "more than " + numberText(limit), numberText(limit));
    }
};

/// The strongest trajectories of an animation with many frames and many vertices.
Result<MatrixXd> principalBasisByProducts(const FrameStack &frames, std::span<const double> means, std::size_t count,
                                          const Progress &progress)
{
    // How many products the solver will take is not known: the report nears the end without reaching it.
    double products = 0;
    const double typical = 4.0 * double(count) + 20;
    const MatrixProduct apply = [&](const Eigen::VectorXd &in, Eigen::VectorXd &out) {
        applyGram(frames, means, in, out, progress);
        products += 1;
        progress.report(products / (products + typical));
    };
    return strongestEigenvectors(apply, frames.rowCount(), count, progress);
}

/// The strongest trajectories, orthonormal: #3F x count.
Result<MatrixXd> principalBasis(const FrameStack &frames, std::span<const double> means, std::size_t count,
                                const Progress &progress)
{
    if (std::min<std::size_t>(frames.rowCount(), frames.vertexCount()) > MaxGramRows) {
        Result<MatrixXd> basis = principalBasisByProducts(frames, means, count, progress);
        if (!basis || basis->cols() > 0)
            return basis;
    }
    const Result<MatrixXd> gram = gramMatrix(frames, means, progress.part(0, 0.7));
    if (!gram)
        return fail(gram.error());
    Result<MatrixXd> vectors = strongestEigenvectors(*gram, count, progress.part(0.7, 1));
    if (!vectors || frames.rowCount() <= frames.vertexCount())
        return vectors;

    // Eigenvectors w of S^T S: u = S w / |S w|.
    MatrixXd basis = MatrixXd::Zero(Index(frames.rowCount()), vectors->cols());
    RowMajorMatrixF panel(Index(frames.rowCount()), Index(BlockColumns));
    for (std::size_t first = 0; first < frames.vertexCount(); first += BlockColumns) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        const std::size_t width = std::min<std::size_t>(BlockColumns, frames.vertexCount() - first);
        frames.centredVertices(means, first, width, panel.data(), BlockColumns);
        const std::size_t rowsAtOnce =
            TaskProducts / (BlockColumns * std::max<std::size_t>(std::size_t(basis.cols()), 1)) + 1;
        parallelRanges(frames.rowCount(), rowsAtOnce, [&](std::size_t begin, std::size_t end) {
            if (progress.isCancelled())
                return;
            basis.middleRows(Index(begin), Index(end - begin)).noalias() +=
                panel.block(Index(begin), 0, Index(end - begin), Index(width)).cast<double>() *
                vectors->middleRows(Index(first), Index(width));
        });
    }
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    basis.colwise().normalize();
    return basis;
}

/// An eigenvector is one up to its sign: make its entry of largest magnitude positive, so that the file does not
/// depend on the solver's way to it.
void fixSigns(MatrixXd &basis)
{
    for (Index k = 0; k < basis.cols(); ++k) {
        Index at = 0;
        basis.col(k).cwiseAbs().maxCoeff(&at);
        if (basis(at, k) < 0)
            basis.col(k) = -basis.col(k);
    }
}

/// Quantises; trajectories that vanish at this resolution are left out. `basis` becomes what the decoder will have.
std::vector<std::int32_t> quantizeBasis(MatrixXd &basis, Quantizer &quantize)
{
    std::vector<std::int32_t> result;
    Index kept = 0;
    for (Index k = 0; k < basis.cols(); ++k) {
        const std::size_t start = result.size();
        bool vanishes = true;
        for (Index r = 0; r < basis.rows(); ++r) {
            result.push_back(std::int32_t(quantize(basis(r, k))));
            vanishes = vanishes && result.back() == 0;
        }
        if (vanishes) {
            result.resize(start);
            continue;
        }
        for (Index r = 0; r < basis.rows(); ++r)
            basis(r, kept) = result[start + std::size_t(r)] / quantize.resolution;
        ++kept;
    }
    basis.conservativeResize(Eigen::NoChange, kept);
    return result;
}

/// The coefficients on the decoded basis, quantised, with the error that this makes.
Result<void> quantizeCoefficients(const FrameStack &frames, std::span<const double> means, const MatrixXd &basis,
                                  double resolution, QuantizedPca &pca, const Progress &progress)
{
    Quantizer quantize{resolution, "coefficient", MaxBandValue};
    Result<FittedCoefficients> fitted =
        fittedCoefficients(frames, means, {basis.data(), std::size_t(basis.size())}, progress);
    if (!fitted)
        return fail(std::move(fitted).error());
    pca.coefficients.resize(fitted->values.size());
    std::vector<double> rounding(fitted->values.size());
    for (std::size_t i = 0; i < rounding.size(); ++i) {
        const double q = quantize(fitted->values[i]);
        pca.coefficients[i] = std::int32_t(q);
        rounding[i] = q / resolution - fitted->values[i];
    }
    if (quantize.exceeded)
        return quantize.error();
    pca.squaredError = fitted->squaredErrorWith(rounding, progress);
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    return {};
}

/// Bands that hold nothing but zeros are left out: an animation of lower rank keeps fewer trajectories.
void dropEmptyBands(QuantizedPca &pca, std::size_t rows, std::size_t vertices)
{
    std::uint32_t kept = 0;
    for (std::uint32_t k = 0; k < pca.rank; ++k) {
        const auto band = pca.coefficients.begin() + std::ptrdiff_t(k * vertices);
        if (std::all_of(band, band + std::ptrdiff_t(vertices), [](std::int32_t q) { return q == 0; }))
            continue;
        if (kept != k) {
            std::copy_n(band, vertices, pca.coefficients.begin() + std::ptrdiff_t(kept * vertices));
            std::copy_n(pca.basis.begin() + std::ptrdiff_t(k * rows), rows,
                        pca.basis.begin() + std::ptrdiff_t(kept * rows));
        }
        ++kept;
    }
    pca.rank = kept;
    pca.coefficients.resize(kept * vertices);
    pca.basis.resize(kept * rows);
}

} // namespace

Result<FittedCoefficients> fittedCoefficients(const FrameStack &frames, std::span<const double> means,
                                              std::span<const double> basis, const Progress &progress)
{
    const std::size_t rows = frames.rowCount();
    const std::size_t vertices = frames.vertexCount();
    FittedCoefficients fitted;
    fitted.rank = basis.size() / rows;
    fitted.values.resize(fitted.rank * vertices);
    fitted.gram.resize(fitted.rank * fitted.rank);
    const Eigen::Map<const MatrixXd> trajectories(basis.data(), Index(rows), Index(fitted.rank));
    Eigen::Map<MatrixXd> gram(fitted.gram.data(), Index(fitted.rank), Index(fitted.rank));
    parallelRanges(fitted.rank, TaskProducts / (rows * std::max<std::size_t>(fitted.rank, 1)) + 1,
                   [&](std::size_t begin, std::size_t end) {
                       if (!progress.isCancelled())
                           gram.middleCols(Index(begin), Index(end - begin)).noalias() =
                               trajectories.transpose() * trajectories.middleCols(Index(begin), Index(end - begin));
                   });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    MatrixXd normal = gram;
    if (fitted.rank > 0)
        normal.diagonal().array() += Ridge * normal.diagonal().maxCoeff();
    const Eigen::LLT<MatrixXd> solver(normal);

    // One sum for each block, added in their order: the same with any number of threads.
    const std::size_t most = blockWidth(fitted.rank * (rows + 2 * fitted.rank));
    std::vector<double> errors((vertices + most - 1) / most);
    std::atomic<std::size_t> done = 0;
    parallelFor(errors.size(), [&](std::size_t block) {
        if (progress.isCancelled())
            return;
        const std::size_t begin = block * most;
        const std::size_t width = std::min(most, vertices - begin);
        RowMajorMatrixF panel = RowMajorMatrixF::Zero(Index(rows), Index(width));
        frames.centredVertices(means, begin, width, panel.data(), width);
        // In double: the error below is a small difference of large numbers.
        const MatrixXd columns = panel.cast<double>();
        const MatrixXd projected = trajectories.transpose() * columns;
        const MatrixXd exact = solver.solve(projected);
        const double left =
            columns.squaredNorm() - 2 * exact.cwiseProduct(projected).sum() + exact.cwiseProduct(gram * exact).sum();
        errors[block] = std::max(left, 0.0);
        for (std::size_t k = 0; k < fitted.rank; ++k)
            for (std::size_t i = 0; i < width; ++i)
                fitted.values[k * vertices + begin + i] = exact(Index(k), Index(i));
        progress.report(double(done += width) / double(vertices));
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    fitted.squaredError = std::accumulate(errors.begin(), errors.end(), 0.0);
    return fitted;
}

double FittedCoefficients::squaredErrorWith(std::span<const double> differences, const Progress &progress) const
{
    if (rank == 0)
        return squaredError;
    const std::size_t vertices = differences.size() / rank;
    const Eigen::Map<const MatrixXd> products(gram.data(), Index(rank), Index(rank));
    const std::size_t most = blockWidth(rank * rank);
    std::vector<double> errors((vertices + most - 1) / most);
    parallelFor(errors.size(), [&](std::size_t block) {
        if (progress.isCancelled())
            return;
        const std::size_t begin = block * most;
        const std::size_t width = std::min(most, vertices - begin);
        MatrixXd part = MatrixXd::Zero(Index(rank), Index(width));
        for (std::size_t k = 0; k < rank; ++k)
            for (std::size_t i = 0; i < width; ++i)
                part(Index(k), Index(i)) = differences[k * vertices + begin + i];
        errors[block] = part.cwiseProduct(products * part).sum();
    });
    return std::accumulate(errors.begin(), errors.end(), squaredError);
}

struct PrincipalComponents::Basis
{
    MatrixXd vectors; ///< #3F x count, orthonormal, strongest first
};

PrincipalComponents::PrincipalComponents(std::unique_ptr<Basis> basis)
    : mBasis(std::move(basis))
{}
PrincipalComponents::PrincipalComponents(PrincipalComponents &&) noexcept = default;
PrincipalComponents::~PrincipalComponents() = default;

Result<PrincipalComponents> PrincipalComponents::of(const FrameStack &frames, std::size_t count,
                                                    const Progress &progress)
{
    const std::size_t most = std::min<std::size_t>({count, frames.rowCount(), frames.vertexCount()});
    Result<MatrixXd> basis = principalBasis(frames, frames.rowMeans(), most, progress);
    if (!basis)
        return fail(std::move(basis).error());
    fixSigns(*basis);
    return PrincipalComponents(std::make_unique<Basis>(Basis{std::move(*basis)}));
}

std::size_t PrincipalComponents::count() const
{
    return std::size_t(mBasis->vectors.cols());
}

std::span<const double> PrincipalComponents::trajectory(std::size_t k) const
{
    const MatrixXd &vectors = mBasis->vectors;
    return {vectors.data() + std::size_t(vectors.rows()) * k, std::size_t(vectors.rows())};
}

Result<QuantizedPca> PrincipalComponents::quantized(const FrameStack &frames, const PcaSettings &settings,
                                                    const Progress &progress) const
{
    QuantizedPca pca;
    Quantizer quantizeMean{settings.resolution, "mean position", double(MaxMeanValue)};
    std::vector<double> means = frames.rowMeans();
    for (double &mean : means) {
        pca.means.push_back(std::int64_t(quantizeMean(mean)));
        mean = double(pca.means.back()) / settings.resolution;
    }
    if (quantizeMean.exceeded)
        return quantizeMean.error();
    MatrixXd basis = mBasis->vectors.leftCols(std::min<Index>(settings.basisSize, mBasis->vectors.cols()));
    Quantizer quantizeBasisValue{settings.resolution, "basis", MaxBandValue};
    pca.basis = quantizeBasis(basis, quantizeBasisValue);
    pca.rank = std::uint32_t(basis.cols());
    if (const auto fitted = quantizeCoefficients(frames, means, basis, settings.resolution, pca, progress); !fitted)
        return fail(fitted.error());
    dropEmptyBands(pca, frames.rowCount(), frames.vertexCount());
    return pca;
}

Result<QuantizedPca> quantizedPca(const FrameStack &frames, const PcaSettings &settings, const Progress &progress)
{
    const Result<PrincipalComponents> components =
        PrincipalComponents::of(frames, settings.basisSize, progress.part(0, 0.8));
    if (!components)
        return fail(components.error());
    return components->quantized(frames, settings, progress.part(0.8, 1));
}

} // namespace model::codec
