// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact by V-cycles, each followed by a problem on the boundary: no A, no factors, no C.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/solvers/contact/contact_iteration.h>
#include <signorini/solvers/stiffness/stiffness_multigrid.h>

#include <algorithm>
#include <cmath>

#include "methods.h"

namespace Signorini {
namespace {
/** The factor by which the scale t is expected to grow from level to level. */
constexpr double growth_of_scale = 1.05;
/** The largest number of cycles. Where MINRES needs more, a factorisation is the better choice. */
constexpr unsigned int max_contact_cycles = 1000;
/** The ratio of the tolerance of stationarity to that of the KKT residual. */
constexpr double stationarity_per_tolerance = 10.;
/** The tolerance of the linear systems that the estimate of the error needs. */
constexpr double tolerance_of_estimates = 1e-4;

using Vector = dealii::Vector<double>;

/** Returns the nodal values with zero in constrained rows; the zero vector if U is empty. */
template <int dim>
NodalVector free_part(const DisplacementSpace<dim> &space, const Displacement &U,
                      const StiffnessOperator &A) {
  NodalVector free = A.make_vector();
  if (U.size() == 0)
    return free;
  std::copy(U.begin(), U.end(), free.begin());
  for (const auto &line : space.constraints().get_lines())
    if (free.in_local_range(line.index))
      free(line.index) = 0.;
  return free;
}

/** Returns U = T U_free + k. */
template <int dim>
Displacement complete_free_part(const DisplacementSpace<dim> &space, const NodalVector &U_free) {
  Displacement free = space.zero();
  std::copy(U_free.begin(), U_free.end(), free.begin());
  return space.complete(free);
}

template <int dim>
class CycleMethod final : public ContactMethod<dim> {
public:
  CycleMethod(const Parameters &parameters, const Scene<dim> &scene)
    : parameters_(parameters)
    , scene_(scene) {}

  LevelOperators<dim> make_operators(const Discretization<dim> &discretization,
                                     const Progress &progress) const override {
    const DisplacementSpace<dim> &space = discretization.space;
    StageTimes times;
    progress("assembly");
    const auto system = timed(times.assembly, [&]() {
      return std::make_shared<const LinearSystem<dim>>(assemble_right_hand_side(
        space, scene_, discretization.n_points, space.complete(space.zero())));
    });
    progress("factorisation");
    const std::shared_ptr<const StiffnessInverse> inverse = timed(times.factor, [&]() {
      return make_multigrid_inverse(space, scene_, tolerance_of_estimates);
    });
    MotionModes<dim> modes = make_motion_modes(space, scene_, *inverse);
    if (modes.size() > 0 || !modes.neutral.empty())
      throw InputError(parameters_.solver.contact_solver.where() +
                       ": found 'multigrid' for a body or a plate that moves freely, allowed "
                       "there: psor, active set.");
    return {system, inverse, std::move(modes), nullptr, times};
  }

  ContactSolution solve(const Discretization<dim> &discretization,
                        const LevelOperators<dim> &operators, const ContactStart &start,
                        const Progress &progress) const override {
    progress("V-cycles");
    StageTimes times = operators.times;
    ContactSolution contact =
      timed(times.qp, [&]() { return iterate(discretization, operators, start); });
    contact.times = times;
    return contact;
  }

private:
  ContactSolution iterate(const Discretization<dim> &discretization,
                          const LevelOperators<dim> &operators, const ContactStart &start) const {
    const DisplacementSpace<dim> &space = discretization.space;
    const StiffnessOperator &A = *operators.inverse->cycles();
    const auto model = make_boundary_model(discretization.multipliers);
    Vector gap(discretization.G);
    gap -= discretization.D.transpose_product(space.complete(space.zero()));
    const ContactIterationOptions options = options_for(start);
    const ContactIterationResult result = solve_contact_by_cycles(
      {A, operators.system->f, discretization.condensed_D, gap, *model,
       space.condense(operators.system->loads).l2_norm()},
      free_part(space, start.U, A), start.P.size() > 0 ? start.P : Vector(gap.size()), options);
    ContactSolution contact;
    contact.P = Multiplier(result.P, discretization.K);
    contact.U = complete_free_part(space, result.U);
    contact.W = discretization.gap_residual(contact.U);
    contact.data = CycleData{result.scale, result.energy_of_residual};
    contact.report.method = ContactSolver::multigrid;
    contact.report.iterations = result.cycles + result.cycles_for_scale;
    contact.report.kkt = result.kkt_residual;
    contact.report.converged = result.converged;
    contact.report.stalled = result.stalled;
    Vector diagonal = model->diagonal();
    diagonal *= result.scale;
    contact.diagonal_P = result.P;
    contact.diagonal_P.scale(diagonal);
    contact.algebraic_error =
      std::hypot(algebraic_error(discretization.K, result.P, contact.W, diagonal),
                 std::sqrt(2. * std::abs(result.energy_of_residual)));
    return contact;
  }

  ContactIterationOptions options_for(const ContactStart &start) const {
    const SolverParameters &solver = parameters_.solver;
    ContactIterationOptions options;
    options.tolerance = solver.tolerance;
    options.stationarity = stationarity_per_tolerance * solver.tolerance;
    options.maximum_cycles = std::min<unsigned int>(solver.maximum_iterations, max_contact_cycles);
    options.scale = growth_of_scale * start.scale;
    return options;
  }

  const Parameters &parameters_;
  const Scene<dim> &scene_;
};
} // namespace

template <int dim>
std::unique_ptr<ContactMethod<dim>> make_cycle_method(const Parameters &parameters,
                                                      const Scene<dim> &scene) {
  return std::make_unique<CycleMethod<dim>>(parameters, scene);
}

INSTANTIATE_FUNCTION(make_cycle_method);
} // namespace Signorini
