// SPDX-License-Identifier: LGPL-2.1-or-later
// What is known about the solution of one level.

#include "level_examination.h"

#include <signorini/base/columns.h>
#include <signorini/driver/level/level.h>
#include <signorini/driver/level/level_iteration.h>
#include <signorini/error_control/bound/error_bound.h>
#include <signorini/error_control/estimate/missed_contact.h>
#include <signorini/postprocessing/errors/pressure_errors.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/norms/inf_sup.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** The limit of Inf-sup constant = automatic: it needs a factorisation of its own, which in space
 * costs more than the rest of the level from some thousand unknowns on. */
constexpr unsigned int largest_automatic_inf_sup(const unsigned int dim)
{
  return dim == 2 ? 100000 : 5000;
}

/** Whether the constant of Lemma 1 is asked for on a level of this size; on graded meshes only if
 * the user wants it. */
template <int dim>
bool wants_inf_sup(const Parameters &parameters, const unsigned long long n_dofs)
{
  const Choice choice = parameters.output.inf_sup_constant;
  return choice == Choice::yes || (choice == Choice::automatic && !uses_multigrid(parameters) &&
                                   parameters.discretization.strategy == Strategy::nested &&
                                   n_dofs <= largest_automatic_inf_sup(dim));
}

/** The bound is asked for where the study may stop. */
bool wants_bound(const DiscretizationParameters &given, const unsigned int level)
{
  if (given.strategy == Strategy::hp)
    return false;
  return level == given.finest_level || given.target_error > 0.;
}

/** Unknowns beyond which there is no bound: it takes more memory than V-cycles do, 0.6 kB for each
 * unknown, and more time than all the rest. */
constexpr unsigned long long most_bounded_unknowns = 10000000;

/** Where plates are and what holds them there. */
void add_plates(const DisplacementSpace<2> &space,
                const SolvedSystem<2> &solved,
                const NodalForces &nodal,
                LevelSolution<2> &solution)
{
  const Scene<2> &scene = solution.scene;
  if (scene.plates.empty())
    return;
  const std::vector<PlateMotion> motions = solved.modes.plate_motions(scene.plates, solution.q);
  const std::vector<PlateForce> forces = plate_forces(space, scene, nodal);
  for (std::size_t p = 0; p < scene.plates.size(); ++p)
    solution.record.motions.plates.push_back({scene.geometry.sides[scene.plates[p].side].name(),
                                              scene.plates[p],
                                              motions[p],
                                              forces[p].force,
                                              forces[p].moment});
}

/** The largest part of a force or moment on a free motion that nothing balances: the residual's
 * work on z_j against that of what drives the plates. */
template <int dim>
double motion_balance(const std::vector<Plate> &plates,
                      const MotionModes<dim> &modes,
                      const NodalForces &forces)
{
  double largest = 0.;
  for (unsigned int j = 0; j < modes.size(); ++j)
  {
    const double work = modes.motions[j].work_of_plates(plates);
    const double scale = std::max(std::abs(work), forces.scale() * modes.Z[j].linfty_norm());
    if (scale > 0.)
      largest = std::max(largest, std::abs(modes.Z[j] * forces.residual - work) / scale);
  }
  return largest;
}

/** The energy is that of the problem with given forces: they lose what they do. */
void subtract_work_of_plates(LevelRecord &record)
{
  double work = 0.;
  for (const PlateRecord &plate : record.motions.plates)
    work += plate.plate.work(plate.motion);
  record.certificate.energy -= work;
  if (record.bound && record.bound->energy_lower && record.bound->energy_upper)
  {
    *record.bound->energy_lower -= work;
    *record.bound->energy_upper -= work;
  }
}

/** Primal minus dual objective where nobody knows the body without contact: with r = f + D P - A U
 * it is P.W + r.A^{-1} r/2. */
template <int dim>
double gap_of_cycles(const Discretization<dim> &discretization,
                     const NodalForces &forces,
                     const LevelSolution<dim> &solution)
{
  dealii::Vector<double> W = discretization.D.transpose_product(solution.U);
  W -= discretization.G;
  const double scale = std::max({0.5 * std::abs(solution.U * forces.internal),
                                 std::abs(solution.U * forces.loads),
                                 std::abs(solution.P * discretization.G),
                                 forces.rigid_energy()});
  const double gap = std::abs(solution.P * W + solution.energy_of_residual);
  return scale > 0. ? gap / scale : gap;
}

/** The certificate, and the answer, which needs the same nodal forces. */
template <int dim>
void add_certificate_and_answer(const Discretization<dim> &discretization,
                                const SolvedSystem<dim> &solved,
                                LevelSolution<dim> &solution)
{
  const Scene<dim> &scene = solution.scene;
  const DisplacementSpace<dim> &space = discretization.space;
  LevelRecord &record = solution.record;
  record.contact = summarise_contact(discretization.multipliers, solution.P);
  const NodalForces forces =
    nodal_forces(space, scene, solved.system.loads, discretization.D, solution.U, solution.P);
  record.certificate = certify(space,
                               scene,
                               solved.system,
                               discretization.multipliers,
                               discretization.D,
                               ContactSolution<dim>{solution.U,
                                                    solved.free.U,
                                                    solution.P,
                                                    solved.free.F,
                                                    discretization.G,
                                                    solved.pressure.C_P,
                                                    solved.pressure.diagonal_P},
                               forces);
  if (solution.contact_scale > 0.)
    record.certificate.duality_gap = gap_of_cycles(discretization, forces, solution);
  record.certificate.motion_balance = motion_balance(scene.plates, solved.modes, forces);
  if constexpr (dim == 2)
    add_plates(space, solved, forces, solution);
  record.answer =
    compute_answer(space, scene, discretization.multipliers, forces, solution.U, solution.P);
}

/** The dual problem on other patches, for the estimate. Motions begin at q. None after V-cycles:
 * each column of C would be a linear solve, and F is not known. */
template <int dim>
DualProblem dual_problem(const SolvedSystem<dim> &solved, const LevelSolution<dim> &solution)
{
  if (solution.contact_scale > 0.)
    return {};
  return [&solved,
          &solution](const Coupling &D,
                     const Coupling &condensed_D,
                     const dealii::Vector<double> &F,
                     const dealii::Vector<double> &start) -> std::optional<dealii::Vector<double>> {
    double seconds = 0.;
    const auto C = make_compliance(solved.inverse, condensed_D, seconds);
    QPResult result;
    if (solved.modes.size() == 0)
      result = solve_dual_problem(C, F, start, {});
    else
    {
      FreeMotions motions = solution.motions;
      motions.B = solved.modes.couple(D);
      dealii::Vector<double> K_q(solution.q.size());
      motions.K.vmult(K_q, solution.q);
      motions.b -= K_q;
      result = solve_dual_problem(C, F, motions, start, {}).qp;
    }
    return result.converged ? std::optional<dealii::Vector<double>>(result.P) : std::nullopt;
  };
}

/** The estimate of the error. */
template <int dim>
void add_estimate(const Discretization<dim> &discretization,
                  const SolvedSystem<dim> &solved,
                  LevelSolution<dim> &solution)
{
  const Scene<dim> &scene = solution.scene;
  const PressureCorrection correction = correct_pressure<dim>({discretization.space,
                                                               scene,
                                                               discretization.multipliers,
                                                               solved.free.U,
                                                               solution.P,
                                                               discretization.condensed_D,
                                                               solved.inverse,
                                                               discretization.n_points,
                                                               dual_problem(solved, solution)});
  OtherErrors others;
  others.algebra = solution.algebraic_error;
  if constexpr (dim == 3)
    others.contact = energy_of_missed_contact(
      discretization.space, discretization.multipliers, scene, solution.U, solution.P);
  solution.record.estimate =
    estimate_error(discretization.space, scene, solution.U, correction, others);
}

/** The bound of the error of U and P, and where it comes from. */
void add_bound(const Discretization<2> &discretization,
               const StiffnessInverse &inverse,
               LevelSolution<2> &solution)
{
  const StageTimer timer(solution.record.times.bound);
  LocatedBound located = compute_located_bound({{discretization.space,
                                                 solution.scene,
                                                 discretization.multipliers,
                                                 solution.U,
                                                 solution.P,
                                                 discretization.n_points},
                                                inverse,
                                                discretization.condensed_D,
                                                discretization.G,
                                                solution.record.certificate.energy});
  solution.record.bound = located.bound;
  solution.bound_fields = std::move(located.fields);
}
} // namespace

template <int dim>
void examine(const Parameters &parameters,
             const Discretization<dim> &discretization,
             const SolvedSystem<dim> &solved,
             const Progress &progress,
             LevelSolution<dim> &solution)
{
  LevelRecord &record = solution.record;
  const StageTimer timer(record.times.postprocess);
  const DisplacementSpace<dim> &space = discretization.space;
  if (wants_inf_sup<dim>(parameters, space.dofs().n_dofs()))
  {
    progress("inf-sup constant");
    record.inf_sup = measure_inf_sup(space,
                                     discretization.multipliers,
                                     discretization.condensed_D,
                                     parameters.solver.linear_solver);
  }
  progress("certificate");
  add_certificate_and_answer(discretization, solved, solution);
  if (discretization.mesh.has_parents())
    add_estimate(discretization, solved, solution);
  if constexpr (dim == 2)
    if (wants_bound(parameters.discretization, record.sizes.level))
    {
      progress("bound of the error");
      if (record.sizes.dofs <= most_bounded_unknowns)
        add_bound(discretization, solved.inverse, solution);
      else
        record.bound.emplace().missing =
          "it is not computed for more than " + std::to_string(most_bounded_unknowns) + " unknowns";
    }
  subtract_work_of_plates(record);
}

template void examine(const Parameters &,
                      const Discretization<2> &,
                      const SolvedSystem<2> &,
                      const Progress &,
                      LevelSolution<2> &);
template void examine(const Parameters &,
                      const Discretization<3> &,
                      const SolvedSystem<3> &,
                      const Progress &,
                      LevelSolution<3> &);

// What is known about a level when the exact solution is.

template <int dim>
void add_errors(const Parameters &parameters,
                const Scene<dim> &scene,
                const Discretization<dim> &discretization,
                const ExactPressure<dim> *pressure,
                LevelSolution<dim> &solution)
{
  if (!parameters.output.errors)
    return;
  const unsigned int n_points = discretization.n_points + 1;
  const MultiplierSpace<dim> &multipliers = discretization.multipliers;
  LevelRecord &record = solution.record;
  const StageTimer timer(record.times.errors);
  if (scene.exact_displacement != nullptr)
    record.displacement_errors =
      compute_displacement_errors(discretization.space, scene, solution.U, n_points);
  if (scene.has_exact_pressure())
  {
    record.pressure_errors = compute_pressure_errors(multipliers, solution.P, n_points);
    record.endpoint_error = contact_end_error(multipliers, scene, solution.P);
  }
  if (pressure != nullptr)
    record.dual_norm_errors = pressure->errors(multipliers, solution.P);
  if constexpr (dim == 2)
    if (parameters.output.lemmas && parameters.discretization.strategy == Strategy::nested &&
        scene.exact_displacement != nullptr && pressure != nullptr)
      record.lemmas = compute_lemma_numbers(discretization.space,
                                            scene,
                                            multipliers,
                                            discretization.D,
                                            *pressure,
                                            solution.loads,
                                            parameters.solver.linear_solver,
                                            n_points);
}

template void add_errors(const Parameters &,
                         const Scene<2> &,
                         const Discretization<2> &,
                         const ExactPressure<2> *,
                         LevelSolution<2> &);
template void add_errors(const Parameters &,
                         const Scene<3> &,
                         const Discretization<3> &,
                         const ExactPressure<3> *,
                         LevelSolution<3> &);
} // namespace Signorini
