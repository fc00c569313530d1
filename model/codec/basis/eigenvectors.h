// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"

#include <Eigen/Core>

#include <functional>

namespace model::codec {

/// The eigenvectors of the largest eigenvalues of a symmetric positive semidefinite matrix, the strongest first.
/// \param matrix  both triangles are used
/// \returns       #n x at most `count`; fewer only if the rest of the matrix is zero
/// \error Cancelled
Result<Eigen::MatrixXd> strongestEigenvectors(const Eigen::MatrixXd &matrix, std::size_t count,
                                              const Progress &progress);

/// The same for a matrix that is too large to be written down: `apply` computes its product with a vector, and may
/// stop in the middle once the work is cancelled.
/// \returns  fewer than `count` also where the iteration did not find more to 7 digits
/// \error Cancelled
using MatrixProduct = std::function<void(const Eigen::VectorXd &in, Eigen::VectorXd &out)>;
Result<Eigen::MatrixXd> strongestEigenvectors(const MatrixProduct &apply, std::size_t size, std::size_t count,
                                              const Progress &progress);

} // namespace model::codec
