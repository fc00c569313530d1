// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/eigenvectors.h"

#include <Eigen/Eigenvalues>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <exception>

namespace model::codec {

namespace {

// Below this the full decomposition takes under 50 ms, which is as short as a cancel may take.
constexpr Eigen::Index SmallMatrix = 400;

/// Thrown out of Spectra, which knows no other way to stop; caught in this file.
struct Stopped
{};

/// What Spectra multiplies with.
class Operator
{
public:
    using Scalar = double;
    Operator(const MatrixProduct &apply, Eigen::Index size, const Progress &progress)
        : mApply(apply)
        , mSize(size)
        , mProgress(progress)
    {}
    Eigen::Index rows() const { return mSize; }
    Eigen::Index cols() const { return mSize; }
    void perform_op(const double *in, double *out) const
    {
        mIn = Eigen::Map<const Eigen::VectorXd>(in, mSize);
        mApply(mIn, mOut);
        if (mProgress.isCancelled())
            throw Stopped();
        Eigen::Map<Eigen::VectorXd>(out, mSize) = mOut;
    }

private:
    const MatrixProduct &mApply;
    Eigen::Index mSize;
    const Progress &mProgress;
    mutable Eigen::VectorXd mIn;
    mutable Eigen::VectorXd mOut;
};

/// By Lanczos iteration; fewer than `count` if not all were found.
Result<Eigen::MatrixXd> byIteration(const MatrixProduct &apply, Eigen::Index size, Eigen::Index count,
                                    Eigen::Index restarts, double tolerance, const Progress &progress)
{
    try {
        Operator product(apply, size, progress);
        Spectra::SymEigsSolver<Operator> solver(product, count, std::min(size, 2 * count + 10));
        solver.init();
        solver.compute(Spectra::SortRule::LargestAlge, restarts, tolerance);
        return solver.eigenvectors();
    } catch (const Stopped &) {
        return fail(ErrorCode::Cancelled);
    } catch (const std::exception &) {
        return Eigen::MatrixXd(size, 0); // the iteration broke down
    }
}

Eigen::MatrixXd byFullDecomposition(const Eigen::MatrixXd &matrix, Eigen::Index count)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    return solver.eigenvectors().rightCols(count).rowwise().reverse();
}

} // namespace

Result<Eigen::MatrixXd> strongestEigenvectors(const Eigen::MatrixXd &matrix, std::size_t wanted,
                                              const Progress &progress)
{
    const Eigen::Index size = matrix.rows();
    const Eigen::Index count = std::min(Eigen::Index(wanted), size);
    if (matrix.trace() <= 0)
        return Eigen::MatrixXd(size, 0);
    if (size <= SmallMatrix || count > size / 4)
        return byFullDecomposition(matrix, count);
    const MatrixProduct apply = [&](const Eigen::VectorXd &in, Eigen::VectorXd &out) { out.noalias() = matrix * in; };
    Result<Eigen::MatrixXd> found = byIteration(apply, size, count, 300, 1e-9, progress);
    if (found && found->cols() < count)
        return byFullDecomposition(matrix, count);
    return found;
}

Result<Eigen::MatrixXd> strongestEigenvectors(const MatrixProduct &apply, std::size_t size, std::size_t count,
                                              const Progress &progress)
{
    return byIteration(apply, Eigen::Index(size), Eigen::Index(count), 30, 1e-7, progress);
}

} // namespace model::codec
