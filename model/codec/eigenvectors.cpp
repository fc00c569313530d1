// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/eigenvectors.h"

#include <Eigen/Eigenvalues>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>

namespace model::codec {

namespace {

// Below this the full decomposition takes under 50 ms, which is as short as a cancel may take.
constexpr Eigen::Index SmallMatrix = 400;

/// Thrown out of Spectra, which knows no other way to stop; caught in this file.
struct Stopped
{};

class Product
{
public:
    using Scalar = double;
    Product(const Eigen::MatrixXd &matrix, const Progress &progress)
        : mMatrix(matrix)
        , mProgress(progress)
    {}
    Eigen::Index rows() const { return mMatrix.rows(); }
    Eigen::Index cols() const { return mMatrix.cols(); }
    void perform_op(const double *in, double *out) const
    {
        if (mProgress.isCancelled())
            throw Stopped();
        Eigen::Map<Eigen::VectorXd>(out, rows()).noalias() = mMatrix * Eigen::Map<const Eigen::VectorXd>(in, cols());
    }

private:
    const Eigen::MatrixXd &mMatrix;
    const Progress &mProgress;
};

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
    try {
        Product product(matrix, progress);
        Spectra::SymEigsSolver<Product> solver(product, count, std::min(size, 2 * count + 10));
        solver.init();
        const Eigen::Index found = solver.compute(Spectra::SortRule::LargestAlge, 300, 1e-9);
        if (found == count)
            return solver.eigenvectors();
    } catch (const Stopped &) {
        return fail(ErrorCode::Cancelled);
    }
    return byFullDecomposition(matrix, count);
}

} // namespace model::codec
