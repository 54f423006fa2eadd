// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/problem/scene/material.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Signorini
{
/** Returns the mean of tr ε(u_h) over the parent of each active cell (over the cell itself where
 * there is no T^{2h}), in the order of active cells. With StrainOperator::mean_dilatation, means
 * over cells may alternate between neighbours, as the pressure of Q1-P0 does. */
template <int dim>
std::vector<double> mean_dilatations(const DisplacementSpace<dim> &space, const Displacement &U);

/** The evaluation of a 3-D polynomial at the points of a tensor product rule on one of the cells,
 * n_cells per direction, into which the unit cube is divided: sums over the nodes of one direction
 * after the other. With k + 1 nodes and q points per direction that takes about 4 (k+1)³ q
 * operations where q < k, not 4 (k+1)³ q³. */
class TensorEvaluation
{
public:
  using Vector3 = Tensor<1, 3>;

  /**
   * Tabulates the basis.
   * @param basis one-dimensional polynomials on [0, 1]; nodal values belong to their products, the
   * first direction running fastest.
   * @param rule of the three directions, on a cell.
   */
  TensorEvaluation(const std::vector<Polynomials::Polynomial<double>> &basis,
                   const std::array<Quadrature<1>, 3> &rule,
                   unsigned int n_cells);

  /** Computes values, and gradients with respect to the reference coordinates of the cell at @p
   * place; the points run like those of the rule, the first direction fastest. */
  void evaluate(const std::vector<Vector3> &nodal_values,
                const std::array<unsigned int, 3> &place,
                std::vector<Vector3> &values,
                std::vector<Tensor<2, 3>> &gradients);

private:
  /** The basis at the points of one direction of a cell: rows of points, columns of polynomials. */
  struct Line
  {
    std::vector<double> values, derivatives;
  };

  unsigned int n_nodes_;
  std::array<unsigned int, 3> n_points_;
  /** The lines by direction and by cell. */
  std::array<std::vector<Line>, 3> lines_;
  /** The values and d/dx after the sums over the first direction. */
  std::array<std::vector<Vector3>, 2> first_;
  /** The values, d/dx and d/dy after the sums over the second direction. */
  std::array<std::vector<Vector3>, 3> second_;
};

/** The stress with all its components, also those of a 2-D body that point out of the plane
 * (force/area). */
using Stress3D = SymmetricTensor<2, 3>;

/**
 * Returns σ = E : ε at @p x. In 2-D σ_xz = σ_yz = 0, and σ_zz is
 * Material::out_of_plane_stress().
 * @throws InputError where the material's data has no value.
 */
template <int dim>
Stress3D stress_in_3d(const Material<dim> &material,
                      const Point<dim> &x,
                      const SymmetricTensor<2, dim> &strain);

/** Returns the von Mises stress sqrt(3/2 s:s), s = σ - tr σ/3 I. */
double von_mises(const Stress3D &stress);

/** Returns the three eigenvalues of σ, the largest (the most tensile) first. */
std::array<double, 3> principal_stresses(const Stress3D &stress);
} // namespace Signorini
