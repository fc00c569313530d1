// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - G. H. Golub and C. F. Van Loan: Matrix Computations, 4th edition, 2013, 8.3
// - F. G. Van Zee, R. A. van de Geijn, G. Quintana-Orti: Restructuring the Tridiagonal and Bidiagonal QR Algorithms for
//   Performance, 2014
// Differs: the update of a column's step and the product of the next are one pass over the matrix; the rotations of
// some sweeps are collected and applied to panels of 16 rows in parallel, without fusing sweeps. When an entry beside
// the diagonal counts as zero, and the shift, are those of Eigen's SelfAdjointEigenSolver, which cannot be stopped.
#include "model/codec/basis/symmetriceigen.h"

#include "model/base/parallel.h"
#include "model/codec/basis/kernels.h"

#include <Eigen/Householder>
#include <Eigen/Jacobi>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <vector>

namespace model::codec {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Parts that the columns of a pass are cut into, each with sums of its own, added in their order.
constexpr std::size_t PassParts = 8;
// Below this a pass takes about as long as starting a thread does.
constexpr Index MinParallelColumns = 1000;
// Columns and reflections of one step of making Q: some milliseconds for 3000 rows.
constexpr Index QColumns = 32;
constexpr Index QReflections = 48;
// Sweeps whose rotations are applied at once: a megabyte of them for 2000 rows, small beside the panels.
constexpr Index SweepsAtOnce = 32;
// As in Eigen; a finite matrix needs about 1.7 for each row.
constexpr Index MaxSweepsPerRow = 30;

struct Tridiagonal
{
    VectorXd diagonal;
    VectorXd beside;
    VectorXd scales; ///< of the reflections, whose vectors are left below the diagonal of the matrix
};

/// Begin of part `p` of `columns` columns of a lower triangle: all have about the same number of entries.
Index partBegin(Index columns, std::size_t p)
{
    return columns - Index(double(columns) * std::sqrt(1.0 - double(p) / double(PassParts)));
}

/// One pass over the lower triangle of `rest`: rest -= v w^T + w v^T, then rest * next, where `next` is a function of
/// what the first column has become.
class Pass
{
public:
    explicit Pass(Index size) { mSums.fill(VectorXd(size)); }

    /// \param product  gets rest * next
    void operator()(Eigen::Ref<MatrixXd> rest, const VectorXd &v, const VectorXd &w, const VectorXd &next,
                    VectorXd &product)
    {
        const Index size = rest.rows();
        const auto part = [&](std::size_t p) {
            auto sums = mSums[p].head(size);
            const Index begin = partBegin(size, p), end = partBegin(size, p + 1);
            if (begin == end)
                return;
            sums.tail(size - begin).setZero();
            for (Index j = begin; j < end; ++j) {
                const Index below = size - j - 1;
                auto column = rest.col(j).tail(below + 1);
                if (v.size() > 0)
                    column.noalias() -= w[j] * v.tail(below + 1) + v[j] * w.tail(below + 1);
                sums.tail(below).noalias() += next[j] * column.tail(below);
                sums[j] += column[0] * next[j] + column.tail(below).dot(next.tail(below));
            }
        };
        if (size < MinParallelColumns) {
            for (std::size_t p = 0; p < PassParts; ++p)
                part(p);
        } else {
            parallelFor(PassParts, part);
        }
        product = VectorXd::Zero(size);
        for (std::size_t p = 0; p < PassParts; ++p) {
            const Index begin = partBegin(size, p);
            if (begin < partBegin(size, p + 1))
                product.tail(size - begin) += mSums[p].segment(begin, size - begin);
        }
    }

private:
    std::array<VectorXd, PassParts> mSums;
};

/// T = Q^T A Q by reflections; A's lower triangle then holds their vectors.
Result<Tridiagonal> tridiagonalised(MatrixXd &a, const Progress &progress)
{
    const Index size = a.rows();
    Tridiagonal t{VectorXd(size), VectorXd(std::max<Index>(size - 1, 0)), VectorXd(std::max<Index>(size - 1, 0))};
    Pass pass(size);
    VectorXd v, w; // of the column before, to be taken from the rest yet
    for (Index k = 0; k + 1 < size; ++k) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        // rest: rows and columns k.. ; its first column is brought up to date at once, the others in the pass.
        auto column = a.col(k).tail(size - k);
        if (k > 0)
            column -= w[0] * v + v[0] * w;
        t.diagonal[k] = column[0];
        auto below = a.col(k).tail(size - k - 1);
        below.makeHouseholderInPlace(t.scales[k], t.beside[k]);
        VectorXd reflection = below;
        reflection[0] = 1;
        VectorXd product;
        if (k > 0)
            pass(a.bottomRightCorner(size - k - 1, size - k - 1), v.tail(size - k - 1).eval(),
                 w.tail(size - k - 1).eval(), reflection, product);
        else
            pass(a.bottomRightCorner(size - k - 1, size - k - 1), {}, {}, reflection, product);
        product *= t.scales[k];
        product -= (0.5 * t.scales[k] * product.dot(reflection)) * reflection;
        v = std::move(reflection);
        w = std::move(product);
        const double left = 1 - double(k) / double(size);
        progress.report(1 - left * left * left);
    }
    if (size > 0)
        t.diagonal[size - 1] = a(size - 1, size - 1); // the last reflection is of one entry: none
    return t;
}

/// A square matrix as panels of PanelRows rows, each of them one column after another without gaps.
class Panels
{
public:
    explicit Panels(Index size)
        : mSize(size)
        , mValues(std::size_t((size + Rows - 1) / Rows * Rows * size))
    {}
    std::size_t count() const { return std::size_t((mSize + Rows - 1) / Rows); }
    double *panel(std::size_t p) { return mValues.data() + p * std::size_t(Rows * mSize); }
    /// Rows Rows * p .. of a column; what lies past the last row is zero.
    double *rows(std::size_t p, Index column) { return panel(p) + column * Rows; }

    void setColumns(Index first, const MatrixXd &columns)
    {
        for (Index j = 0; j < columns.cols(); ++j)
            for (Index i = 0; i < mSize; i += Rows)
                std::copy_n(columns.col(j).data() + i, std::min(Rows, mSize - i),
                            rows(std::size_t(i / Rows), first + j));
    }
    void getColumn(Index from, double *column)
    {
        for (Index i = 0; i < mSize; i += Rows)
            std::copy_n(rows(std::size_t(i / Rows), from), std::min(Rows, mSize - i), column + i);
    }

private:
    static constexpr Index Rows = Index(PanelRows);
    Index mSize;
    std::vector<double> mValues;
};

/// Q, the product of the reflections: a reflection changes no column left of its own, so each block of columns needs
/// only those that stand before it.
Result<Panels> product(const MatrixXd &reflections, const VectorXd &scales, const Progress &progress)
{
    const Index size = reflections.rows();
    Panels q(size);
    parallelRanges(std::size_t(size), std::size_t(QColumns), [&](std::size_t begin, std::size_t end) {
        MatrixXd block = MatrixXd::Zero(size, Index(end - begin));
        block.middleRows(Index(begin), block.cols()).setIdentity();
        const Index last = std::min(Index(end), size - 1);
        for (Index first = (last - 1) / QReflections * QReflections; first >= 0 && last > 0; first -= QReflections) {
            if (progress.isCancelled())
                return;
            const Index length = std::min(QReflections, last - first);
            const auto corner = reflections.bottomRightCorner(size - first, size - first);
            auto rows = block.bottomRows(size - first);
            rows.applyOnTheLeft(
                Eigen::householderSequence(corner, scales.tail(scales.size() - first)).setLength(length).setShift(1));
        }
        q.setColumns(Index(begin), block);
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    return q;
}

/// Rotations of neighbouring columns, first, first + 1, ...
struct Sweep
{
    Index first = 0;
    std::vector<PlaneRotation> rotations;
};

/// One step of implicit QR with Wilkinson's shift on the rows begin..end, whose entries beside the diagonal are not
/// zero.
Sweep qrStep(VectorXd &diagonal, VectorXd &beside, Index begin, Index end)
{
    const double half = (diagonal[end - 1] - diagonal[end]) / 2;
    const double e = beside[end - 1];
    double shift = diagonal[end];
    if (half == 0) {
        shift -= std::fabs(e);
    } else if (e != 0) {
        const double h = std::copysign(std::hypot(half, e), half);
        const double squared = e * e;
        shift -= squared == 0 ? e / ((half + h) / e) : squared / (half + h);
    }
    Sweep sweep{begin, {}};
    sweep.rotations.reserve(std::size_t(end - begin));
    double x = diagonal[begin] - shift;
    double z = beside[begin];
    for (Index k = begin; k < end && z != 0; ++k) {
        Eigen::JacobiRotation<double> rotation;
        rotation.makeGivens(x, z);
        const double c = rotation.c(), s = rotation.s();
        const double upper = s * diagonal[k] + c * beside[k];
        const double lower = s * beside[k] + c * diagonal[k + 1];
        diagonal[k] = c * (c * diagonal[k] - s * beside[k]) - s * (c * beside[k] - s * diagonal[k + 1]);
        diagonal[k + 1] = s * upper + c * lower;
        beside[k] = c * upper - s * lower;
        if (k > begin)
            beside[k - 1] = c * beside[k - 1] - s * z;
        x = beside[k];
        if (k + 1 < end) {
            z = -s * beside[k + 1];
            beside[k + 1] *= c;
        }
        sweep.rotations.push_back({c, s});
    }
    return sweep;
}

void apply(const std::vector<Sweep> &sweeps, Panels &q, const Progress &progress)
{
    parallelFor(q.count(), [&](std::size_t p) {
        if (progress.isCancelled())
            return;
        for (const Sweep &sweep : sweeps)
            kernels().rotateColumns(q.rows(p, sweep.first), sweep.rotations.data(), sweep.rotations.size());
    });
}

/// Makes T diagonal, and Q that of A.
Result<void> diagonalise(Tridiagonal &t, Panels &q, const Progress &progress)
{
    constexpr double Epsilon = std::numeric_limits<double>::epsilon();
    const Index size = t.diagonal.size();
    std::vector<Sweep> sweeps;
    Index left = MaxSweepsPerRow * size;
    for (Index end = size - 1, begin = 0; end > 0 && left > 0; --left) {
        for (Index i = begin; i < end; ++i) {
            const double scaled = t.beside[i] / Epsilon;
            if (std::fabs(t.beside[i]) < std::numeric_limits<double>::min() ||
                scaled * scaled <= std::fabs(t.diagonal[i]) + std::fabs(t.diagonal[i + 1]))
                t.beside[i] = 0;
        }
        while (end > 0 && t.beside[end - 1] == 0)
            --end;
        if (end == 0)
            break;
        begin = end - 1;
        while (begin > 0 && t.beside[begin - 1] != 0)
            --begin;
        sweeps.push_back(qrStep(t.diagonal, t.beside, begin, end));
        if (Index(sweeps.size()) == SweepsAtOnce) {
            apply(sweeps, q, progress);
            sweeps.clear();
            progress.report(1 - double(end) / double(size));
        }
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
    }
    apply(sweeps, q, progress);
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    return {};
}

} // namespace

Result<SymmetricEigen> symmetricEigen(MatrixXd matrix, Index count, const Progress &progress)
{
    const Index size = matrix.rows();
    // As in Eigen: so that nothing overflows, and what counts as zero is relative to the matrix.
    const double scale = size > 0 ? matrix.triangularView<Eigen::Lower>().toDenseMatrix().cwiseAbs().maxCoeff() : 0;
    if (scale > 0)
        matrix /= scale;
    Result<Tridiagonal> t = tridiagonalised(matrix, progress.part(0, 0.3));
    if (!t)
        return fail(t.error());
    Result<Panels> q = product(matrix, t->scales, progress);
    if (!q)
        return fail(q.error());
    if (const auto done = diagonalise(*t, *q, progress.part(0.4, 1)); !done)
        return fail(done.error());

    std::vector<Index> order(static_cast<std::size_t>(size));
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return t->diagonal[a] > t->diagonal[b]; });
    SymmetricEigen result{VectorXd(size), MatrixXd(size, count)};
    for (Index k = 0; k < size; ++k)
        result.values[k] = t->diagonal[order[std::size_t(k)]] * scale;
    for (Index k = 0; k < count; ++k)
        q->getColumn(order[std::size_t(k)], result.vectors.col(k).data());
    return result;
}

} // namespace model::codec
