// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/cell_values.h>
#include <signorini/discretization/space/displacement_space.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace Signorini {
/**
 * Returns the number of Gauss points per direction for elements of degree one whose edges are not
 * parallel. With a constant tensor two in space keep the patch test exact: ∇φ dx has the degree
 * three in each coordinate of a trilinear map.
 */
template <int dim>
unsigned int n_stiffness_points(const bool has_constant_moduli) {
  return dim == 3 && has_constant_moduli ? 2 : 4;
}

/**
 * Integrates a(φ_j, φ_i)/E on one cell, with the unit of stiffness E of stiffness_unit().
 *
 * For elements of degree p, p + 1 Gauss points per direction are exact for a constant tensor on a
 * parallelogram or parallelepiped; otherwise n_stiffness_points() + p - 1 are taken, and p + 2 in
 * bodies of revolution, where only u_x v_x / x is no polynomial. With a constant tensor, cells of
 * one shape share a matrix, which in 2-D does not depend on their size: on a mesh of squares it is
 * integrated once per degree.
 */
template <int dim>
class CellStiffness {
public:
  using CellIterator = typename Triangulation<dim>::active_cell_iterator;

  CellStiffness(const DisplacementSpace<dim> &space, const Scene<dim> &scene);

  /** A matrix that similar cells share. */
  using Matrix = std::shared_ptr<const FullMatrix<double>>;

  /** Returns the matrix of the cell, to be shared. */
  Matrix share(const CellIterator &cell);
  /** Returns the matrix of the cell, valid until the next call. */
  const FullMatrix<double> &operator()(const CellIterator &cell) {
    last_ = share(cell);
    return *last_;
  }

private:
  /** The matrix of a shape: the vertices relative to the first, divided by the cell's size, in 3-D
   * by the body's. */
  struct Sample {
    unsigned int element_number;
    std::array<Tensor<1, dim>, 1U << dim> shape;
    Matrix matrix;
  };

  Matrix integrate(const CellIterator &cell);

  const DisplacementSpace<dim> &space_;
  const Mesh<dim> &mesh_;
  const Material<dim> &material_;
  StrainOperator strain_operator_;
  bool constant_;
  /** The kinks of the data; none for a constant tensor, which is smooth across all lines. */
  Kinks<dim> kinks_;
  CellValues<dim> affine_values_;
  CellValues<dim> values_;
  Matrix last_;
  FullMatrix<double> strains_, stresses_;
  /** The samples of a constant tensor, in the order of their first use. */
  std::vector<Sample> samples_;
};

/** Returns whether every vertex is the sum of the edges along its coordinates: a parallelogram, in
 * 3-D a parallelepiped, if edges are straight. */
template <int dim>
bool is_affine(const typename Triangulation<dim>::cell_iterator &cell);

/** Returns the unit in which a(φ_j, φ_i) is computed: E_0 l^{dim-2}, in bodies of revolution E_0 l,
 * with the material's modulus E_0 and the body's size l. Matrices are those of a body of size one
 * and modulus one, so that neither units nor sizes of numbers matter (force/length per thickness,
 * in 2-D: force/area).
 */
template <int dim>
double stiffness_unit(const DisplacementSpace<dim> &space, const Material<dim> &material) {
  const int power = space.mesh().is_axisymmetric() ? 1 : dim - 2;
  return material.modulus() * std::pow(space.mesh().size(), power);
}

} // namespace Signorini
