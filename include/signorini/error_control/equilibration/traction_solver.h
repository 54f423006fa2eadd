// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/cell_fit.h>

#include <utility>
#include <vector>

namespace Signorini {
/** A condition row · x = value on the coefficients of edges, a row of length one, with the weight
 * of its square. */
struct TractionCondition {
  std::vector<std::pair<unsigned int, double>> row;
  double value = 0., weight = 0.;
};

/** Returns a weight of the square of what a cell lacks in balance, relative to its energy. */
double penalty_of(const CellFit &fit);

/** Returns E x - shift for a cell, see CellFit. */
dealii::Vector<double> lacking_traces(const TractionCell &cell, const CellFit &fit,
                                      const TractionMesh &mesh, const dealii::Vector<double> &x);

/**
 * Finds the tractions x that minimise Σ_K size² (E x - shift)ᵀ S (E x - shift) / 2 - work.x among
 * those that balance every cell and satisfy the conditions; given coefficients keep their values.
 * Conjugate gradients for the multipliers of an augmented Lagrangian, with one Cholesky factor,
 * bring what is lacking down to rounding in a few steps, in long bodies, too.
 * @return what is lacking, relative to the largest trace.
 */
double minimise(const TractionMesh &mesh, const std::vector<CellFit> &fits,
                const std::vector<TractionCondition> &conditions,
                const dealii::Vector<double> &work, dealii::Vector<double> &x);
} // namespace Signorini
