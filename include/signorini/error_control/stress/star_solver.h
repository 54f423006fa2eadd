// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/stress/cell_table.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Signorini {
/** Returns the forces and the moment of a cell (rows) by its 16 moments of tractions. The moment is
 * that about @p centre, divided by the size of the cell. */
std::array<CellMoments, 3> balance_of(const EdgeCell &cell, const Point<2> &centre);

/**
 * The sum over all vertices of exact solves on their stars: among the changes of moments on the
 * edges at a vertex that disturb the balance of no cell, the one with the least
 * 1/2 bᵀ S b - rᵀ b. It is a symmetric operator whose values disturb no balance: a preconditioner
 * of S on the stresses without loads.
 */
class StarSolver {
public:
  StarSolver(const EdgeMesh &mesh, const CellEnergies &energies, unsigned int n_threads = 1);

  /** Solves the star of a vertex anew after its edges have changed their freedom. */
  void renew(unsigned int vertex);

  /** Sets z = Σ_i Z_i (Z_iᵀ S Z_i)⁻¹ Z_iᵀ r. Z_i is known: all spokes carry the same force and
   * couple, and each a shear along itself. */
  void apply(const std::vector<double> &r, std::vector<double> &z) const;
  /** Sets gradient = S b, cell by cell. */
  void multiply(const std::vector<double> &b, std::vector<double> &gradient) const;

private:
  /** Returns (ZᵀSZ)⁻¹ of a star: Z has columns for a force, a couple, and a shear of every spoke,
   * without those that its edges bar. */
  FullMatrix<double> solve_star(const Star &star) const;

  const EdgeMesh &mesh_;
  const CellEnergies &energies_;
  unsigned int n_threads_;
  std::vector<FullMatrix<double>> matrices_;
  std::vector<unsigned int> matrix_of_star_;
};
} // namespace Signorini
