// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/elasticity/integration.h>

namespace Signorini
{
/**
 * a(phi_j, phi_i) on one cell.
 *
 * Two Gauss points per direction are exact for a constant tensor on a parallelogram; four are taken
 * otherwise. With a constant tensor, congruent cells share one matrix: on a mesh of squares it is
 * integrated once.
 */
template <int dim>
class CellStiffness
{
public:
  using CellIterator = typename dealii::Triangulation<dim>::active_cell_iterator;

  CellStiffness(const DisplacementSpace<dim> &space,
                const Material<dim> &material,
                const Kinks<dim> &kinks);

  /** The matrix of the cell; valid until the next call. */
  const dealii::FullMatrix<double> &operator()(const CellIterator &cell);

private:
  void integrate(const dealii::FEValues<dim> &values);
  bool is_congruent(const CellIterator &cell) const;

  const Material<dim> &material_;
  bool constant_;
  /** Whether vertices alone do not tell the shape of a cell. */
  bool curved_;
  Kinks<dim> kinks_;
  CellValues<dim> affine_values_;
  CellValues<dim> general_values_;
  dealii::FullMatrix<double> matrix_;
  std::vector<dealii::Tensor<1, dim>> shape_;
};

/** (a(phi_j, phi_i))_ij U for all i, constrained or not: the internal forces. Collective. */
template <int dim>
DistributedVector internal_forces(const DisplacementSpace<dim> &space,
                                  const Scene<dim> &scene,
                                  const NodalVector &U);
} // namespace Signorini
