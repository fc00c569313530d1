// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/reel/trajectories.h"

#include "model/base/parallel.h"
#include "model/codec/basis/eigenvectors.h"
#include "model/codec/basis/gram.h"
#include "model/codec/basis/kernels.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

namespace model::codec {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using RowMajorMatrixF = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t BlockColumns = 256;
// Parts that the vertices are cut into for sums over them; each has a sum of its own, so that their order is fixed.
constexpr std::size_t Parts = 16;
// Weaker trajectories than this part of the strongest are what floats left over.
constexpr double NoiseLevel = 1e-6;
// Of a search without a Gram matrix: columns beyond those that are wanted, and how often the animation is applied. More
// passes made no file smaller.
constexpr std::size_t BlockMargin = 16;
constexpr int BlockPasses = 4;

/// The sums of each axis over the frames, over sqrt(F): the products with the three constant unit trajectories.
template <class Derived>
MatrixXd constantParts(const Eigen::MatrixBase<Derived> &trajectories)
{
    const Index frames = trajectories.rows() / 3;
    MatrixXd parts = MatrixXd::Zero(3, trajectories.cols());
    for (Index f = 0; f < frames; ++f)
        parts += trajectories.middleRows(3 * f, 3);
    return parts / std::sqrt(double(frames));
}

/// Takes the constant parts away.
template <class Derived>
void removeConstants(Eigen::MatrixBase<Derived> &trajectories)
{
    const Index frames = trajectories.rows() / 3;
    const MatrixXd mean = constantParts(trajectories) / std::sqrt(double(frames));
    for (Index f = 0; f < frames; ++f)
        trajectories.middleRows(3 * f, 3) -= mean;
}

} // namespace

Result<Trajectories> Trajectories::of(const FrameStack &frames, std::vector<double> means, const Progress &progress)
{
    Trajectories result(frames);
    result.mMeans = std::move(means);
    const std::size_t vertices = frames.vertexCount();
    result.mShape.resize(3, Index(vertices));
    const std::size_t blocks = (vertices + BlockColumns - 1) / BlockColumns;
    std::vector<double> energies(blocks);
    parallelFor(blocks, [&](std::size_t block) {
        if (progress.isCancelled())
            return;
        const std::size_t begin = block * BlockColumns;
        const std::size_t width = std::min(BlockColumns, vertices - begin);
        RowMajorMatrixF panel(Index(frames.rowCount()), Index(width));
        frames.centredVertices(result.mMeans, begin, width, panel.data(), width);
        const MatrixXd columns = panel.cast<double>();
        energies[block] = columns.squaredNorm();
        result.mShape.middleCols(Index(begin), Index(width)) = constantParts(columns);
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    for (const double energy : energies)
        result.mEnergy += energy;
    if (const auto found = result.findGram(progress); !found)
        return fail(found.error());
    return result;
}

Result<void> Trajectories::findGram(const Progress &progress)
{
    mByVertices = mFrames->rowCount() > mFrames->vertexCount();
    if (std::min<std::size_t>(mFrames->rowCount(), mFrames->vertexCount()) > MaxGramRows)
        return {};
    Result<MatrixXd> gram = gramMatrix(*mFrames, mMeans, progress);
    if (!gram)
        return fail(gram.error());
    mGram = std::move(*gram);
    if (mByVertices) {
        mGram.noalias() -= mShape.transpose() * mShape;
    } else {
        removeConstants(mGram);
        mGram.transposeInPlace();
        removeConstants(mGram);
        mGram = (mGram + mGram.transpose()).eval() / 2;
    }
    return {};
}

Result<void> Trajectories::find(std::size_t count, const Progress &progress)
{
    const std::size_t most = std::min<std::size_t>(mFrames->rowCount(), mFrames->vertexCount());
    count = std::min(count, most);
    if (mHasAll || std::size_t(mBasis.cols()) >= count)
        return {};
    Result<MatrixXd> found = MatrixXd();
    if (mGram.size() > 0) {
        found = strongestEigenvectors(mGram, count, progress.part(0, 0.6));
    } else {
        found = findByBlocks(count, progress.part(0, 0.6));
    }
    if (!found)
        return fail(std::move(found).error());
    mHasAll = std::size_t(found->cols()) < count || count == most;
    if (mByVertices && mGram.size() > 0) {
        Result<MatrixXd> basis = correlate(found->transpose(), mShape, progress.part(0.6, 0.8));
        if (!basis)
            return fail(std::move(basis).error());
        mBasis = std::move(*basis);
    } else {
        mBasis = std::move(*found);
    }
    mStrengths.clear();
    // Directions that the animation does not have are noise of the solver.
    Index kept = 0;
    const double strongest = mBasis.cols() > 0 ? mBasis.colwise().norm().maxCoeff() : 0;
    for (Index k = 0; k < mBasis.cols(); ++k)
        if (const double norm = mBasis.col(k).norm(); norm > NoiseLevel * strongest) {
            Index at = 0;
            mBasis.col(k).cwiseAbs().maxCoeff(&at); // its sign is free: fix it
            mBasis.col(kept++) = mBasis.col(k) * ((mBasis(at, k) < 0 ? -1 : 1) / norm);
        }
    mBasis.conservativeResize(Eigen::NoChange, kept);
    const Result<MatrixXd> coefficients = project(mBasis, mShape, progress.part(0.8, 1));
    if (!coefficients)
        return fail(coefficients.error());
    for (Index k = 0; k < kept; ++k)
        mStrengths.push_back(std::sqrt(coefficients->row(k).squaredNorm() / mFrames->vertexCount()));
    return {};
}

// Based on:
// - N. Halko, P. G. Martinsson, J. A. Tropp: Finding Structure with Randomness, 2011 (algorithm 4.4)
// Differs: what an earlier search found is part of the first block.
Result<MatrixXd> Trajectories::findByBlocks(std::size_t count, const Progress &progress) const
{
    const std::size_t most = std::min<std::size_t>(mFrames->rowCount(), mFrames->vertexCount());
    const std::size_t width = std::min(most, count + BlockMargin);
    MatrixXd block(Index(mFrames->rowCount()), Index(width));
    std::minstd_rand random; // the same numbers every time, and everywhere
    for (Index k = 0; k < block.cols(); ++k) {
        if (k < mBasis.cols()) {
            block.col(k) = mBasis.col(k);
            continue;
        }
        for (Index row = 0; row < block.rows(); ++row)
            block(row, k) = double(random()) / double(std::minstd_rand::max()) - 0.5;
    }
    const auto orthonormalize = [&] {
        removeConstants(block);
        const Eigen::HouseholderQR<MatrixXd> qr(block);
        block = qr.householderQ() * MatrixXd::Identity(block.rows(), block.cols());
    };
    orthonormalize();
    for (int pass = 0; pass < BlockPasses; ++pass) {
        const Progress part = progress.part(pass / double(BlockPasses + 1), (pass + 1) / double(BlockPasses + 1));
        const Result<MatrixXd> coefficients = project(block, mShape, part.part(0, 0.4));
        if (!coefficients)
            return fail(coefficients.error());
        Result<MatrixXd> next = correlate(*coefficients, mShape, part.part(0.4, 0.8));
        if (!next)
            return fail(std::move(next).error());
        block = std::move(*next);
        orthonormalize();
    }
    const Result<MatrixXd> coefficients = project(block, mShape, progress.part(1 - 1.0 / (BlockPasses + 1), 1));
    if (!coefficients)
        return fail(coefficients.error());
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(*coefficients * coefficients->transpose());
    const double strongest = std::max(solver.eigenvalues()[block.cols() - 1], 0.0);
    Index kept = 0;
    while (kept < Index(count) && solver.eigenvalues()[block.cols() - 1 - kept] > NoiseLevel * NoiseLevel * strongest)
        ++kept;
    return MatrixXd(block * solver.eigenvectors().rightCols(kept).rowwise().reverse());
}

Result<MatrixXd> Trajectories::project(const MatrixXd &basis, const MatrixXd &shape, const Progress &progress) const
{
    const RowMajorMatrixF transposed = basis.transpose().cast<float>();
    const std::size_t rank = std::size_t(basis.cols()), vertices = mFrames->vertexCount();
    MatrixXd result = MatrixXd::Zero(Index(rank), Index(vertices));
    if (rank == 0)
        return result;
    std::atomic<std::size_t> done = 0;
    parallelRanges(vertices, BlockColumns, [&](std::size_t begin, std::size_t end) {
        if (progress.isCancelled())
            return;
        const std::size_t width = end - begin;
        RowMajorMatrixF panel(Index(mFrames->rowCount()), Index(width));
        RowMajorMatrixF values = RowMajorMatrixF::Zero(Index(rank), Index(width));
        mFrames->centredVertices(mMeans, begin, width, panel.data(), width);
        kernels().multiply(transposed.data(), rank, mFrames->rowCount(), panel.data(), width, width, values.data(),
                           width);
        result.middleCols(Index(begin), Index(width)) = values.cast<double>();
        progress.report(double(done += width) / double(vertices));
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    result.noalias() -= constantParts(basis).transpose() * shape;
    return result;
}

Result<MatrixXd> Trajectories::correlate(const MatrixXd &coefficients, const MatrixXd &shape,
                                         const Progress &progress) const
{
    const std::size_t rank = std::size_t(coefficients.rows()), vertices = mFrames->vertexCount();
    const std::size_t rows = mFrames->rowCount();
    std::vector<MatrixXd> sums(Parts, MatrixXd::Zero(Index(rows), Index(rank)));
    const std::size_t part = (vertices + Parts - 1) / Parts;
    std::atomic<std::size_t> done = 0;
    parallelFor(Parts, [&](std::size_t p) {
        const std::size_t last = std::min(vertices, (p + 1) * part);
        for (std::size_t begin = p * part; begin < last && !progress.isCancelled(); begin += BlockColumns) {
            const std::size_t width = std::min(BlockColumns, last - begin);
            RowMajorMatrixF panel;
            panel.resize(Index(rows), Index(width));
            mFrames->centredVertices(mMeans, begin, width, panel.data(), width);
            const RowMajorMatrixF block = coefficients.middleCols(Index(begin), Index(width)).transpose().cast<float>();
            RowMajorMatrixF values = RowMajorMatrixF::Zero(Index(rows), Index(rank));
            kernels().multiply(panel.data(), rows, width, block.data(), rank, rank, values.data(), rank);
            sums[p] += values.cast<double>();
            progress.report(double(done += width) / double(vertices));
        }
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    MatrixXd result = MatrixXd::Zero(Index(rows), Index(rank));
    for (const MatrixXd &sum : sums)
        result += sum;
    const MatrixXd constant = shape * coefficients.transpose() / std::sqrt(double(mFrames->frameCount()));
    for (Index f = 0; f < Index(mFrames->frameCount()); ++f)
        result.middleRows(3 * f, 3) -= constant;
    return result;
}

double Trajectories::energyAbout(const MatrixXd &shape) const
{
    return std::max(0.0, mEnergy - 2 * mShape.cwiseProduct(shape).sum() + shape.squaredNorm());
}

} // namespace model::codec
