// SPDX-License-Identifier: LGPL-2.1-or-later
// B: the normal trace of V^h on Γ_c.

#include <signorini/discretization/elasticity/trace_values.h>

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
std::vector<Tensor<1, dim>> TraceValues<dim>::displacement(const ContactFace<dim> &face,
                                                           const SurfaceRule<dim> &rule,
                                                           const Displacement &U) {
  const auto &values = reinit(face, rule.on_face);
  std::vector<Tensor<1, dim>> u(rule.size());
  values[FEValuesExtractors::Vector(0)].get_function_values(U.entries(), u);
  return u;
}

template <int dim>
std::vector<double> TraceValues<dim>::normal_displacement(const ContactFace<dim> &face,
                                                          const SurfaceRule<dim> &rule,
                                                          const Displacement &U) {
  const std::vector<Tensor<1, dim>> u = displacement(face, rule, U);
  std::vector<double> u_n(rule.size());
  for (std::size_t q = 0; q < rule.size(); ++q)
    u_n[q] = u[q] * rule.normals[q];
  return u_n;
}

template class TraceValues<2>;
template class TraceValues<3>;
} // namespace Signorini
