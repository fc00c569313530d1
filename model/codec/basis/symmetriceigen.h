// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"

#include <Eigen/Core>

namespace model::codec {

/// Eigenvalues, the largest first, and as many of their vectors as were asked for.
struct SymmetricEigen
{
    Eigen::VectorXd values;  ///< #n
    Eigen::MatrixXd vectors; ///< #n x count, orthonormal
};

/// All eigenvalues of a symmetric matrix, with errors of some units in the last place of the largest. The same with any
/// number of threads; looks at `progress` every few milliseconds.
/// \param matrix  the lower triangle is read; all entries finite
/// \error Cancelled
/// Cost: about 10 n^3 operations, whatever `count` is.
Result<SymmetricEigen> symmetricEigen(Eigen::MatrixXd matrix, Eigen::Index count, const Progress &progress);

} // namespace model::codec
