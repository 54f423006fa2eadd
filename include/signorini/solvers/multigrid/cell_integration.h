// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/mesh/mesh.h>
#include <signorini/problem/scene/material.h>
#include <signorini/solvers/multigrid/cell_matrices.h>

#include <array>
#include <vector>

namespace Signorini
{
/** The positions of the nodes of a level in the body of size one, by number. */
template <int dim>
using NodePlaces = LevelVector<dim, double>;

/** Integrates ∫_K ε(φ_i):E:ε(φ_j) for many cells with straight edges at a time. The
 * matrices are those of CellStiffness, with p + 3 = 4 Gauss points per direction. */
template <int dim>
class CellIntegration
{
public:
  CellIntegration(const Mesh<dim> &mesh, const Material<dim> &material);

  /** Returns E/E_0 in Voigt's notation, for a constant tensor. */
  std::array<double, PointRule<dim, double>::n_moduli> constant_moduli() const
  {
    return moduli(dealii::Point<dim>());
  }
  /**
   * Writes the matrices of all batches that have matrices of their own.
   * @throws InputError where the material has no value.
   */
  void integrate(CellMatrices<dim, double> &matrices,
                 const BlockGrid<dim> &grid,
                 const NodePlaces<dim> &places) const;

private:
  static constexpr unsigned int n_vertices = 1U << dim;
  static constexpr unsigned int n_strains = dim * (dim + 1) / 2;
  /** The number of entries of a symmetric matrix in Voigt's notation, by rows of its lower
   * triangle. */
  static constexpr unsigned int n_moduli = n_strains * (n_strains + 1) / 2;

  /** The values of the shape functions at a point, their derivatives on the reference cell, and the
   * weight. */
  struct Point
  {
    std::array<double, n_vertices> values;
    std::array<double, n_vertices * dim> gradients;
    double weight;
  };
  /** Returns the moduli at a point of the body of size one. */
  std::array<double, n_moduli> moduli(const dealii::Point<dim> &x) const;
  /** Sets moduli[modulus][lane] at a point of all cells of a batch. */
  void moduli_of_batch(double (*result)[n_lanes],
                       const Point &point,
                       const double (*vertices)[n_lanes]) const;

  const Mesh<dim> &mesh_;
  const Material<dim> &material_;
  std::vector<Point> points_;
};
/** Makes the rule with Gauss points, as many in each direction. */
template <int dim, typename Number>
std::shared_ptr<const PointRule<dim, Number>>
make_point_rule(const NodePlaces<dim> &places,
                unsigned int n_nodes,
                const std::array<double, PointRule<dim, Number>::n_moduli> &moduli,
                unsigned int n_points);

/** Returns the matrices of a batch, [entry][lane]; valid until the buffer changes. */
template <int dim, typename Number>
const Number *entries_of_batch(const CellMatrices<dim, Number> &matrices,
                               const BlockGrid<dim> &grid,
                               std::size_t batch,
                               std::vector<Number> &buffer);

/** Adds the diagonal blocks of nodes, [dim c + d], of the matrix that would be assembled. */
template <int dim, typename Number>
void add_diagonal_blocks(LevelVector<dim * dim, Number> &blocks,
                         const BlockGrid<dim> &grid,
                         const CellMatrices<dim, Number> &matrices);
} // namespace Signorini
