// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/cell_shape.h>
#include <signorini/problem/scene/material.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Signorini {
/** Hooke's law C at a point, in Components. */
struct Law {
  explicit Law(const SymmetricTensor<4, 2> &hooke);

  /** Makes the law one that is not stiffer than this or the other one. */
  void soften(const Law &other);
  /** Returns the lower triangular G with G Gᵀ = C. */
  Tensor<2, 3> root() const;

  Tensor<2, 3> stiffness, compliance;
  /** The smallest c with e:C:e ≥ c e:e. */
  double min_eigenvalue;
};

/** Returns A + (B - A)+ for symmetric matrices in Components, which is not less than A or B: with
 * Poisson's ratio one law may be softer in shear and the other one under pressure. */
Tensor<2, 3> upper_bound(const Tensor<2, 3> &A, const Tensor<2, 3> &B);

/** Returns whether Hooke's tensor varies by more than a factor of 1.5 in a cell, at 6 x 6 points: a
 * norm, that of the compliance, or a share of the norm by more than 0.4. */
bool law_varies(const Material<2> &material, const std::array<Point<2>, 4> &corners);
} // namespace Signorini
