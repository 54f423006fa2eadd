// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/cell_fit.h>
#include <signorini/error_control/equilibration/tractions.h>

#include <vector>

namespace Signorini {
/**
 * Finds the tractions x that minimise Σ_K size² (E x - shift)ᵀ S (E x - shift) / 2 - work.x among
 * those that balance every cell and satisfy the conditions; given coefficients keep their values.
 * Conjugate gradients for the multipliers of an augmented Lagrangian, with one Cholesky factor,
 * bring the residuals down to rounding in a few steps, in long bodies, too.
 * @return the largest residual force of a cell, relative to the largest trace on the largest
 * one.
 */
double minimise(const std::vector<CellFit> &fits, const dealii::Vector<double> &work,
                Tractions &tractions);
} // namespace Signorini
