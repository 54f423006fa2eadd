// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/loads/cell_shape.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Signorini {
/** Hooke's law C at a point, in Components. */
struct Law {
  explicit Law(const SymmetricTensor<4, 2> &hooke);

  /** Returns the lower triangular G with G Gᵀ = C. */
  Tensor<2, 3> root() const;

  Tensor<2, 3> stiffness, compliance;
  /** The smallest c with e:C:e ≥ c e:e. */
  double min_eigenvalue;
};

} // namespace Signorini
