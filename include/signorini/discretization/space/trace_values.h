// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/space/displacement_space.h>

#include <deal.II/fe/fe_values.h>

#include <memory>
#include <vector>

namespace Signorini {
/** The shape functions of V^h at points of contact faces. Consecutive faces with the same reference
 * points share one table. */
template <int dim>
class TraceValues {
public:
  explicit TraceValues(const DisplacementSpace<dim> &space);

  /**
   * Computes the shape functions on a face.
   * @param on_face points in the reference coordinates of the face.
   */
  const FEFaceValues<dim> &reinit(const ContactFace<dim> &face,
                                  const std::vector<Point<dim - 1>> &on_face);

  /** Returns u_h at the points of a rule on a piece; in a pair the difference to u_h of the other
   * body. */
  std::vector<Tensor<1, dim>> displacement(const ContactSurface<dim> &surface,
                                           const Piece<dim> &piece, const SurfaceRule<dim> &rule,
                                           const Displacement &U);

private:
  const DisplacementSpace<dim> &space_;
  std::vector<Point<dim - 1>> on_face_;
  unsigned int element_number_ = 0;
  std::unique_ptr<FEFaceValues<dim>> values_;
};
} // namespace Signorini
