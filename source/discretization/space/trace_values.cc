// SPDX-License-Identifier: LGPL-2.1-or-later
// B: the normal trace of V^h on Γ_c.

#include <signorini/discretization/space/trace_values.h>

namespace Signorini {
template <int dim>
TraceValues<dim>::TraceValues(const DisplacementSpace<dim> &space)
  : space_(space) {}

template <int dim>
const FEFaceValues<dim> &TraceValues<dim>::reinit(const ContactFace<dim> &face,
                                                  const std::vector<Point<dim - 1>> &on_face) {
  const unsigned int number = space_.element_number(face.cell);
  if (values_ == nullptr || number != element_number_ || on_face != on_face_) {
    on_face_ = on_face;
    element_number_ = number;
    values_ =
      std::make_unique<FEFaceValues<dim>>(space_.mesh().mapping(), space_.elements()[number],
                                          Quadrature<dim - 1>(on_face), update_values);
  }
  values_->reinit(space_.dof_cell(face.cell), face.face_no);
  return *values_;
}

template <int dim>
std::vector<Tensor<1, dim>> TraceValues<dim>::displacement(const ContactSurface<dim> &surface,
                                                           const Piece<dim> &piece,
                                                           const SurfaceRule<dim> &rule,
                                                           const Displacement &U) {
  std::vector<Tensor<1, dim>> sum(rule.size()), u(rule.size());
  for (const auto &[face, points, sign] : surface.faces_at(piece, rule)) {
    reinit(face, points)[FEValuesExtractors::Vector(0)].get_function_values(U.entries(), u);
    for (std::size_t q = 0; q < u.size(); ++q)
      sum[q] += sign * u[q];
  }
  return sum;
}

template class TraceValues<2>;
template class TraceValues<3>;
} // namespace Signorini
