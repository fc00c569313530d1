// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - K. Wu and H. Simon: Thick-Restart Lanczos Method for Large Symmetric Eigenvalue Problems, 2000
// Differs: every vector is made orthogonal to all before it, twice, and the small matrix is taken from these products,
// so that nothing depends on its being tridiagonal.
#include "model/codec/basis/eigenvectors.h"

#include "model/base/parallel.h"
#include "model/codec/basis/symmetriceigen.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace model::codec {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Below this the full decomposition takes some 50 ms and is as fast as the iteration.
constexpr Index SmallMatrix = 400;
constexpr double Epsilon = std::numeric_limits<double>::epsilon();
// Entries of a matrix that one task goes through: some hundred microseconds.
constexpr Index TaskEntries = 1 << 18;

/// Calls body(begin, end) for ranges of `count` rows or columns with `length` entries each. The ranges, and with them
/// the rounding, are the same with any number of threads.
template <class Body>
void forRanges(Index count, Index length, const Body &body)
{
    const Index grain = std::max<Index>(16, TaskEntries / std::max<Index>(length, 1));
    parallelRanges(std::size_t(count), std::size_t(grain),
                   [&](std::size_t begin, std::size_t end) { body(Index(begin), Index(end)); });
}

class Lanczos
{
public:
    Lanczos(const MatrixProduct &apply, Index size, Index count, const Progress &progress)
        : mApply(apply)
        , mProgress(progress)
        , mSize(size)
        , mCount(count)
        , mSteps(std::min(size, 2 * count + 10))
        , mVectors(size, mSteps + 1)
        , mSmall(MatrixXd::Zero(mSteps, mSteps))
    {
        VectorXd start(size);
        randomise(start);
        mVectors.col(0) = start.normalized();
    }

    /// Those of the first `count` that were found to `tolerance`.
    Result<MatrixXd> run(Index restarts, double tolerance)
    {
        for (Index kept = 0;; --restarts) {
            for (Index step = kept; step < mSteps; ++step)
                if (const auto stepped = extend(step); !stepped)
                    return fail(stepped.error());
            const Result<SymmetricEigen> ritz = symmetricEigen(mSmall, mSteps, mProgress.part(0, 0));
            if (!ritz)
                return fail(ritz.error());
            const std::vector<Index> found = converged(*ritz, tolerance);
            const bool last = Index(found.size()) == mCount || restarts <= 0 || mSteps == mSize;
            kept = last ? mCount : mCount + std::min(Index(found.size()), (mSteps - mCount) / 2);
            if (const auto combined = combine(ritz->vectors.leftCols(kept)); !combined)
                return fail(combined.error());
            if (last)
                return MatrixXd(mVectors(Eigen::all, found));
            mVectors.col(kept) = mVectors.col(mSteps);
            mSmall.setZero();
            mSmall.diagonal().head(kept) = ritz->values.head(kept);
        }
    }

private:
    void randomise(VectorXd &vector)
    {
        for (double &entry : vector)
            entry = double(mRandom()) / double(std::mt19937::max()) - 0.5;
    }

    /// Takes the share of the first `count` vectors out of `vector`. \returns  the products with them
    VectorXd orthogonalise(VectorXd &vector, Index count) const
    {
        VectorXd all = VectorXd::Zero(count);
        for (int pass = 0; pass < 2; ++pass) { // twice is enough (Kahan)
            VectorXd products(count);
            forRanges(count, mSize, [&](Index begin, Index end) {
                if (!mProgress.isCancelled())
                    products.segment(begin, end - begin).noalias() =
                        mVectors.middleCols(begin, end - begin).transpose() * vector;
            });
            forRanges(mSize, count, [&](Index begin, Index end) {
                if (!mProgress.isCancelled())
                    vector.segment(begin, end - begin).noalias() -=
                        mVectors.block(begin, 0, end - begin, count) * products;
            });
            all += products;
        }
        return all;
    }

    /// From vector `step` to the next one; a column of the small matrix on the way.
    Result<void> extend(Index step)
    {
        VectorXd next;
        mApply(mVectors.col(step), next);
        if (mProgress.isCancelled())
            return fail(ErrorCode::Cancelled);
        const double length = next.norm();
        const VectorXd products = orthogonalise(next, step + 1);
        mSmall.col(step).head(step + 1) = products;
        mSmall.row(step).head(step + 1) = products.transpose();
        mLeft = next.norm();
        if (mLeft <= 4 * Epsilon * length && step + 1 < mSize) {
            // Nothing leads out of the space: go on somewhere else.
            randomise(next);
            orthogonalise(next, step + 1);
            orthogonalise(next, step + 1);
            mLeft = 0;
            next.normalize();
        } else if (mLeft > 0) {
            next /= mLeft;
        }
        mVectors.col(step + 1) = next;
        if (mProgress.isCancelled())
            return fail(ErrorCode::Cancelled);
        return {};
    }

    /// Which of the first `count` are exact: A u differs from theta u by what the last vector leaves.
    std::vector<Index> converged(const SymmetricEigen &ritz, double tolerance) const
    {
        std::vector<Index> result;
        for (Index k = 0; k < mCount; ++k) {
            const double residual = mLeft * std::fabs(ritz.vectors(mSteps - 1, k));
            const double rounding = Epsilon * std::fabs(ritz.values[0]);
            if (mSteps == mSize || residual <= std::max(tolerance * std::fabs(ritz.values[k]), rounding))
                result.push_back(k);
        }
        return result;
    }

    /// The first vectors become combinations of all.
    Result<void> combine(const MatrixXd &weights)
    {
        forRanges(mSize, 16 * mSteps, [&](Index begin, Index end) {
            if (mProgress.isCancelled())
                return;
            const MatrixXd rows = mVectors.block(begin, 0, end - begin, mSteps) * weights;
            mVectors.block(begin, 0, end - begin, weights.cols()) = rows;
        });
        if (mProgress.isCancelled())
            return fail(ErrorCode::Cancelled);
        return {};
    }

    const MatrixProduct &mApply;
    const Progress &mProgress;
    const Index mSize;
    const Index mCount;
    const Index mSteps;
    MatrixXd mVectors; ///< #size x (steps + 1), orthonormal
    MatrixXd mSmall;   ///< what the matrix is on them
    double mLeft = 0;  ///< length of what leads out of them
    std::mt19937 mRandom;
};

} // namespace

Result<MatrixXd> strongestEigenvectors(const MatrixXd &matrix, std::size_t wanted, const Progress &progress)
{
    const Index size = matrix.rows();
    const Index count = std::min(Index(wanted), size);
    if (matrix.trace() <= 0)
        return MatrixXd(size, 0);
    if (size > SmallMatrix && count <= size / 4) {
        const MatrixProduct apply = [&](const VectorXd &in, VectorXd &out) {
            out.resize(size);
            forRanges(size, size, [&](Index begin, Index end) {
                out.segment(begin, end - begin).noalias() = matrix.middleCols(begin, end - begin).transpose() * in;
            });
        };
        Result<MatrixXd> found = Lanczos(apply, size, count, progress).run(300, 1e-9);
        if (!found || found->cols() == count)
            return found;
    }
    Result<SymmetricEigen> all = symmetricEigen(matrix, count, progress);
    if (!all)
        return fail(all.error());
    return std::move(all->vectors);
}

Result<MatrixXd> strongestEigenvectors(const MatrixProduct &apply, std::size_t size, std::size_t count,
                                       const Progress &progress)
{
    return Lanczos(apply, Index(size), Index(count), progress).run(30, 1e-7);
}

} // namespace model::codec
