// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/cycles/boundary_model.h>

#include <array>
#include <vector>

namespace Signorini
{
/** A patch of the kernel: a segment in 2-D, or a rectangle in 3-D. */
template <int dim>
struct FlatPatch
{
  dealii::Point<dim> corner;
  /** The edges, as vectors from the corner. */
  std::array<dealii::Tensor<1, dim>, dim - 1> edges;
  /** The measure of the patch itself; that of the segment or rectangle may be smaller. */
  double measure;

  dealii::Point<dim> centre() const;
  double diameter() const;
};

/**
 * Returns the displacement of the half-space, without its factor 2/(π E'): ∫ k(x - y) dy over
 * the patch, with k = -log(|x - y|/R) in 2-D and 1/(2 |x - y|) in 3-D. It is exact for segments and
 * rectangles.
 * @param radius R; it has no meaning in 3-D.
 */
template <int dim>
double patch_potential(const FlatPatch<dim> &patch, const dealii::Point<dim> &x, double radius);

/** Returns ∫∫ k(x - y) over two patches. The inner integral is exact, the outer one by Gauss'
 * rule with two points per direction, or with four where the patches are near. Far away it is the
 * product of the measures times k between the centres. The interaction is symmetric. */
template <int dim>
double patch_interaction(const FlatPatch<dim> &a, const FlatPatch<dim> &b, double radius);

/** The model Ĉ as a matrix. */
class KernelModel final : public BoundaryModel
{
public:
  explicit KernelModel(Matrix C);

  unsigned int size() const override;
  Vector apply(const Vector &P) const override;
  Vector apply_inverse(const Vector &P) const override;
  double entry(unsigned int i, unsigned int j) const override;

private:
  Matrix C_;
  dealii::LAPACKFullMatrix<double> L_;
};
} // namespace Signorini
