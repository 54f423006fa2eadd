// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/cycles/boundary_model.h>

#include <array>
#include <vector>

namespace Signorini
{
/** A patch as the kernel sees it: a segment, or a rectangle, in space. */
template <int dim>
struct FlatPatch
{
  dealii::Point<dim> corner;
  /** From the corner. */
  std::array<dealii::Tensor<1, dim>, dim - 1> edges;
  /** Of the patch itself; that of the segment or rectangle may be smaller. */
  double measure;

  dealii::Point<dim> centre() const;
  double diameter() const;
};

/**
 * The displacement of the half space, without its factor 2/(pi E'): int k(x - y) dy over the patch,
 * k = -log(|x - y|/R) in the plane, 1/(2 |x - y|) in space. Exact for segments and rectangles.
 * @param radius R; without meaning in space.
 */
template <int dim>
double patch_potential(const FlatPatch<dim> &patch, const dealii::Point<dim> &x, double radius);

/** int int k(x - y) over two patches: the inner integral exact, the outer one by Gauss' rule with
 * two points per direction, or with four where the patches are near; far away the product of the
 * measures times k between the centres. Symmetric. */
template <int dim>
double patch_interaction(const FlatPatch<dim> &a, const FlatPatch<dim> &b, double radius);

/** C^ as a matrix. */
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
