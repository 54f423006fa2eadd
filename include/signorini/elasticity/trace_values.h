// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/mesh/contact_surface.h>

#include <deal.II/fe/fe_values.h>

#include <memory>
#include <vector>

namespace Signorini
{
/** Shape functions of V^h at points of contact faces. Faces that are asked for the same reference
 * points one after another share one table. */
template <int dim>
class TraceValues
{
public:
  explicit TraceValues(const DisplacementSpace<dim> &space);

  /** @param on_face points in the reference coordinates of the face. */
  const dealii::FEFaceValues<dim> &reinit(const ContactFace<dim> &face,
                                          const std::vector<dealii::Point<dim - 1>> &on_face);

  /** u_h at the points of a rule on the face. */
  std::vector<dealii::Tensor<1, dim>> displacement(const ContactFace<dim> &face,
                                                   const SurfaceRule<dim> &rule,
                                                   const NodalVector &U);

  /** u_h.n at the points of a rule on the face. */
  std::vector<double> normal_displacement(const ContactFace<dim> &face,
                                          const SurfaceRule<dim> &rule,
                                          const NodalVector &U);

private:
  const DisplacementSpace<dim> &space_;
  std::vector<dealii::Point<dim - 1>> on_face_;
  unsigned int element_number_ = 0;
  std::unique_ptr<dealii::FEFaceValues<dim>> values_;
};
} // namespace Signorini
