// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"

#include <Eigen/Core>

namespace model::codec {

/// The eigenvectors of the largest eigenvalues of a symmetric positive semidefinite matrix, the strongest first.
/// \param matrix  both triangles are used
/// \returns       #n x at most `count`; fewer only if the rest of the matrix is zero
/// \error Cancelled
Result<Eigen::MatrixXd> strongestEigenvectors(const Eigen::MatrixXd &matrix, std::size_t count,
                                              const Progress &progress);

} // namespace model::codec
