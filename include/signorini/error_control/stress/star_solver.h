// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/stress/cell_table.h>

#include <deal.II/lac/full_matrix.h>

#include <map>
#include <vector>

namespace Signorini
{
/** The matrices S of all cells. Cells that share CellData and have a constant law share the matrix.
 */
class CellEnergies
{
public:
  explicit CellEnergies(const CellTable &table, std::size_t n_cells);

  /** Returns whether a cell shares its matrix with no cell before. */
  bool is_first(const unsigned int cell) const
  {
    return first_cell_[index_[cell]] == cell;
  }
  /** Sets the matrix of a cell and of all that share it. */
  void set(const unsigned int cell, const CellEnergy &energy)
  {
    matrices_[index_[cell]] = energy;
  }
  const CellEnergy &operator()(const unsigned int cell) const
  {
    return matrices_[index_[cell]];
  }
  /** Returns the number of a cell's matrix, which is equal for cells that share one. */
  unsigned int number(const unsigned int cell) const
  {
    return index_[cell];
  }
  /** Returns whether other cells may share the cell's matrix. */
  bool is_shared(const unsigned int cell) const
  {
    return shared_ && table_.shape_of(cell) < table_.n_shapes();
  }

private:
  bool shared_;
  const CellTable &table_;
  /** The number of the matrix for every cell, and the first cell for every matrix. */
  std::vector<unsigned int> index_, first_cell_;
  std::vector<CellEnergy> matrices_;
};

/**
 * The sum over all vertices of exact solves on their stars: among the changes of moments on the
 * edges at a vertex that disturb the balance of no cell, the one with the least
 * 1/2 bᵀ S b - rᵀ b. It is a symmetric operator whose values disturb no balance: a preconditioner
 * of S on the stresses without loads.
 */
class StarSolver
{
public:
  StarSolver(const EdgeMesh &mesh, const CellEnergies &energies, unsigned int n_threads = 1);

  /** Solves the star of a vertex anew after its edges have changed their freedom. */
  void renew(unsigned int vertex, const CellEnergies &energies);

  /** Sets z = Σ_i Z_i (Z_iᵀ S Z_i)⁻¹ Z_iᵀ r. */
  void apply(const std::vector<double> &r, std::vector<double> &z) const;

private:
  /** Returns Z (ZᵀSZ)⁻¹ Zᵀ of a star row by row, in the order spoke, end (centre first),
   * component. */
  std::vector<double> solve_star(const Star &star, const CellEnergies &energies) const;
  /** Returns a key that is equal for stars with equal matrices; empty if that is not known. */
  std::vector<unsigned int> key(const Star &star, const CellEnergies &energies) const;

  const EdgeMesh &mesh_;
  /** The matrices of the stars, row by row. */
  std::vector<std::vector<double>> matrices_;
  std::vector<unsigned int> matrix_of_star_;
};

/** Returns a basis of the null space of a matrix, as columns, by elimination with full pivoting. */
FullMatrix<double> null_space(FullMatrix<double> matrix);

/** Returns S b on a cell. */
CellMoments multiply(const CellEnergy &energy, const CellMoments &b);

/** Sets gradient = S b, cell by cell. */
void multiply(const EdgeMesh &mesh,
              const CellEnergies &energies,
              const std::vector<double> &b,
              std::vector<double> &gradient);
} // namespace Signorini
