// SPDX-License-Identifier: LGPL-2.1-or-later
// One level, from the spaces to the examined answer.

#include <signorini/base/columns.h>
#include <signorini/base/instantiate.h>
#include <signorini/driver/level/level.h>
#include <signorini/error_control/bound/error_bound.h>
#include <signorini/error_control/estimate/contact_part.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/error_control/estimate/pressure_correction.h>
#include <signorini/postprocessing/fields/contact_intervals.h>
#include <signorini/postprocessing/fields/energies.h>
#include <signorini/solvers/methods/contact_method.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** The largest number of unknowns for which the bound is computed: it takes more memory than
 * V-cycles do, 0.6 kB for each unknown, and more time than all the rest. */
constexpr unsigned long long max_bounded_unknowns = 10000000;

template <int dim>
LevelSizes sizes_of(const Discretization<dim> &discretization, const Strategy strategy) {
  const auto [shortest_edge, longest_edge] = discretization.mesh.range_of_edges();
  LevelSizes sizes;
  sizes.level = discretization.mesh.level();
  sizes.cells = discretization.mesh.triangulation().n_global_active_cells();
  sizes.dofs = discretization.space.dofs().n_dofs();
  sizes.multipliers = discretization.multipliers.n_multipliers();
  sizes.h = longest_edge;
  sizes.H = discretization.surface.longest_patch();
  sizes.unstable = is_unstable(discretization);
  sizes.max_degree = discretization.space.max_element_degree();
  sizes.min_h = shortest_edge;
  sizes.strategy = strategy;
  return sizes;
}

/** Returns the largest relative imbalance of a free motion: the work of the residual on z_j minus
 * that of the forces on the plates. Pins are no supports: what they take is missing in these
 * balances. */
template <int dim>
double motion_balance(const std::vector<Plate<dim>> &plates, const MotionModes<dim> &modes,
                      const NodalForces &forces) {
  double largest = 0.;
  const auto add = [&](const FreeMotion<dim> &motion, const Displacement &z) {
    const double work = motion.work_of_plates(plates);
    const double scale = std::max(std::abs(work), forces.scale() * z.linfty_norm());
    if (scale > 0.)
      largest = std::max(largest, std::abs(z * forces.residual - work) / scale);
  };
  for (unsigned int j = 0; j < modes.size(); ++j)
    add(modes.motions[j], modes.Z[j]);
  // In the plane arcs leave neutral motions a part of the loads.
  for (unsigned int j = 0; j < modes.neutral.size() && dim == 3; ++j)
    add(modes.neutral[j], modes.neutral_modes[j]);
  return largest;
}

/** Computes the estimate of the error. */
template <int dim>
ErrorEstimate estimate_of(const Solved<dim> &solved, const LevelSolution<dim> &solution) {
  OtherErrors others;
  others.algebra = solved.contact.algebraic_error;
  others.contact = contact_part(solved);
  return estimate_error(solved, solution.scale,
                        correct_by_finer_patches(solved, *solution.operators), others);
}

/** Returns the bound of the error of U and P, and its parts by cell; or says why there is none. */
LocatedBound located_bound(const Given<WantedBound> &wanted, const Solved<2> &solved,
                           const LevelSolution<2> &solution, const bool keeps_stress) {
  LocatedBound none;
  if (wanted == WantedBound::none)
    none.bound.missing = wanted.name + " is false";
  else if (solved.U.size() > max_bounded_unknowns)
    none.bound.missing =
      "it is not computed for more than " + std::to_string(max_bounded_unknowns) + " unknowns";
  else if (solved.space.mesh().is_shared())
    none.bound.missing = "processes share the level, and no graded run tells its error";
  else
    return compute_located_bound(
      {solved, *solution.operators->inverse, solution.energies, solution.scale}, keeps_stress);
  return none;
}

/** Adds the known facts about other solutions with Coulomb's friction. */
void add_regularity(const Discretization<2> &discretization,
                    const std::shared_ptr<const ComplianceOperator> &C,
                    const ContactSolution &contact, TangentialSummary &summary) {
  if (const auto found =
        examine_regularity(C, contact.dual()->motions, discretization.K, contact.P.values())) {
    summary.critical_factor = found->critical_factor;
    summary.fixed_point_rate = found->fixed_point_rate;
    summary.is_regular = found->keeps_sign;
  }
}

/** Adds the certificate, and the answer, which needs the same nodal forces. */
template <int dim>
void add_certificate_and_answer(const Solved<dim> &solved, LevelSolution<dim> &solution) {
  const LevelOperators<dim> &operators = *solution.operators;
  LevelRecord &record = solution.record;
  const NodalForces forces = nodal_forces(solved, operators.system->loads, solved.discretization.D);
  solution.scale = forces.energy;
  solution.energies = energies_of(solved, operators.modes, forces);
  record.certificate = certify(solved, operators.system->applied, forces, solution.energies);
  record.certificate.motion_balance = motion_balance(solved.scene.plates, operators.modes, forces);
  record.motions.plates = plate_records(
    solved.scene, operators.modes.plate_motions(solved.scene.plates, solved.contact.q),
    plate_forces(solved.space, solved.scene, forces));
  record.answer = compute_answer<dim>(solved, forces);
}

/** Computes the results that follow from U and P: the certificate, the answer and the estimate of
 * the error, as far as they are wanted. Collective. */
template <int dim>
void examine(const Parameters &parameters, const Solved<dim> &solved, const Progress &progress,
             LevelSolution<dim> &solution) {
  const Discretization<dim> &discretization = solved.discretization;
  const ContactSolution &contact = solved.contact;
  LevelRecord &record = solution.record;
  record.sizes = sizes_of(discretization, parameters.discretization.strategy);
  record.times = contact.times;
  record.times.mesh = discretization.times.mesh;
  record.times.setup = discretization.times.setup;
  record.linear = contact.linear;
  record.dual = contact.report;
  record.motions.undetermined = contact.undetermined;
  record.contact = summarise_contact(solved.multipliers, contact.P.normal());
  const StageTimer timer(record.times.postprocess);
  if (contact.P.has_tangential_part())
    record.tangential = summarise_tangential_part(solved.multipliers, contact.P, contact.W);
  progress("certificate");
  add_certificate_and_answer(solved, solution);
  if (discretization.mesh.has_parents())
    record.estimate = estimate_of(solved, solution);
}
} // namespace

template <int dim>
LevelSolution<dim> solve_level(const LevelProblem<dim> &problem,
                               const Discretization<dim> &discretization, const ContactStart &start,
                               const Progress &progress) {
  const auto [parameters, scene, solvers] = problem;
  const auto method = make_contact_method(parameters, scene, solvers);
  LevelSolution<dim> solution;
  solution.operators =
    std::make_shared<const LevelOperators<dim>>(method->make_operators(discretization, progress));
  solution.contact = method->solve(discretization, *solution.operators, start, progress);
  solution.scene = with_plates_moved(
    scene, solution.operators->modes.plate_motions(scene.plates, solution.contact.q));
  examine(parameters, solution.on(discretization), progress, solution);
  return solution;
}

template <int dim>
void add_other_solutions(const Discretization<dim> &discretization, LevelSolution<dim> &solution) {
  if constexpr (dim == 2) {
    LevelRecord &record = solution.record;
    const StageTimer timer(record.times.postprocess);
    if (record.tangential && solution.contact.touches())
      add_regularity(discretization, solution.operators->C, solution.contact, *record.tangential);
  }
}

template <int dim>
void add_bound(const Parameters &parameters, const Discretization<dim> &discretization,
               const Progress &progress, LevelSolution<dim> &solution, const bool keeps_stress) {
  if constexpr (dim == 2) {
    LevelRecord &record = solution.record;
    const StageTimer timer(record.times.postprocess), bound_timer(record.times.bound);
    progress("bound of the error");
    LocatedBound located =
      located_bound(parameters.output.bound, solution.on(discretization), solution, keeps_stress);
    record.bound = located.bound;
    solution.bound_fields = std::move(located.fields);
    solution.reference = std::move(located.reference);
  }
}

template <int dim>
void release_unused(const LevelProblem<dim> &problem, LevelSolution<dim> &solution) {
  const OutputParameters &output = problem.parameters.output;
  if (!output.compliance && problem.scene.load_cases.empty())
    solution.operators.reset();
}

INSTANTIATE_FUNCTION(solve_level);
INSTANTIATE_FUNCTION(add_other_solutions);
INSTANTIATE_FUNCTION(add_bound);
INSTANTIATE_FUNCTION(release_unused);
} // namespace Signorini
