// SPDX-License-Identifier: LGPL-2.1-or-later
// The method that finds contact, and its summary.

#include <signorini/base/instantiate.h>

#include <cmath>

#include "methods.h"

namespace Signorini {
Columns<DualSolve> DualSolve::columns() {
  return {{"qp_iterations", &DualSolve::iterations},
          {"kkt", &DualSolve::kkt},
          {"qp_increment_iterations", &DualSolve::increment_iterations}};
}

double algebraic_error(const AdmissibleSet &K, const dealii::Vector<double> &P,
                       const dealii::Vector<double> &W, const dealii::Vector<double> &diagonal) {
  constexpr double diagonal_over_eigenvalue = 6.;
  double energy = 0.;
  dealii::Vector<double> step(P.size());
  for (unsigned int k = 0; k < P.size(); ++k)
    step[k] = diagonal[k] > 0. ? W[k] / diagonal[k] : 0.;
  const dealii::Vector<double> rest = K.residual(P, step);
  for (unsigned int k = 0; k < P.size(); ++k)
    energy += diagonal[k] * rest[k] * rest[k];
  return std::sqrt(diagonal_over_eigenvalue * energy);
}

template <int dim>
std::unique_ptr<ContactMethod<dim>> make_contact_method(const Parameters &parameters,
                                                        const Scene<dim> &scene,
                                                        const SolverChoice &choice) {
  if (choice.is_by_cycles())
    return make_cycle_method(parameters, scene);
  return make_dual_method(parameters, scene, choice);
}

INSTANTIATE_FUNCTION(make_contact_method);
} // namespace Signorini
