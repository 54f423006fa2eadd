// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

namespace Signorini
{
/** A scene with other loads and another foundation; the body and what holds it are the same, and so
 * is its stiffness. */
struct LoadCase
{
  /** Factor of tractions and of the forces and moments on plates. */
  double force = 1.;
  /** Factor of the body force. */
  double weight = 1.;
  /** Factor of prescribed displacements and of the given travels of plates. */
  double travel = 1.;
  /** Factor of the gap. */
  double gap = 1.;
  /** By how much the foundation is moved, beside Contact/Foundation position (length). */
  dealii::Tensor<1, 2> shift;
  /** Whether its fields are written. */
  bool has_fields = false;
};
} // namespace Signorini
