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
#include <signorini/postprocessing/fields/nodal_forces.h>
#include <signorini/solvers/methods/contact_method.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** Releases factors, C and the system matrix, which take most of the memory, where nothing needs
 * them later. */
template <int dim>
void release_unused(const LevelProblem<dim> &problem, LevelSolution<dim> &solution) {
  // C of several ranks is written column by column, each by a solve.
  const bool writes_compliance = problem.parameters.output.compliance;
  const bool solves_later = writes_compliance || !problem.scene.load_cases.empty();
  ContactSolution<dim> &contact = solution.contact;
  if (contact.dual && !writes_compliance)
    contact.dual->C = nullptr;
  if (!solves_later) {
    contact.inverse = nullptr;
    contact.system = nullptr;
  }
}

/** The largest number of unknowns for which the bound is computed: it takes more memory than
 * V-cycles do, 0.6 kB for each unknown, and more time than all the rest. */
constexpr unsigned long long max_bounded_unknowns = 10000000;

template <int dim>
LevelSizes sizes_of(const Discretization<dim> &discretization, const Strategy strategy) {
  const auto [shortest_edge, longest_edge] = discretization.mesh.range_of_edges();
  return {discretization.mesh.level(),
          discretization.mesh.triangulation().n_global_active_cells(),
          discretization.space.dofs().n_dofs(),
          discretization.multipliers.n_multipliers(),
          longest_edge,
          discretization.surface.longest_patch(),
          is_unstable(discretization),
          discretization.space.max_element_degree(),
          shortest_edge,
          strategy};
}

/** Returns the records of all plates: their motions, and the forces that hold them there. */
template <int dim>
std::vector<PlateRecord> plates_of(const Solved<dim> &solved, const NodalForces &nodal) {
  std::vector<PlateRecord> plates;
  if constexpr (dim == 2) {
    const Scene<2> &scene = solved.scene;
    const std::vector<PlateMotion> motions =
      solved.contact.modes.plate_motions(scene.plates, solved.contact.q);
    const std::vector<PlateForce> forces = plate_forces(solved.space, scene, nodal);
    for (std::size_t p = 0; p < scene.plates.size(); ++p)
      plates.push_back({scene.geometry.sides[scene.plates[p].side].name(), scene.plates[p],
                        motions[p], forces[p].force, forces[p].cross_force, forces[p].moment});
  }
  return plates;
}

/** Returns the largest relative imbalance of a free motion: the work of the residual on z_j minus
 * that of the forces on the plates. */
template <int dim>
double motion_balance(const std::vector<Plate> &plates, const MotionModes<dim> &modes,
                      const NodalForces &forces) {
  double largest = 0.;
  for (unsigned int j = 0; j < modes.size(); ++j) {
    const double work = modes.motions[j].work_of_plates(plates);
    const double scale = std::max(std::abs(work), forces.scale() * modes.Z[j].linfty_norm());
    if (scale > 0.)
      largest = std::max(largest, std::abs(modes.Z[j] * forces.residual - work) / scale);
  }
  return largest;
}

/** Computes the estimate of the error. */
template <int dim>
ErrorEstimate estimate_of(const Solved<dim> &solved, const EnergyScale &scale) {
  OtherErrors others;
  others.algebra = solved.contact.algebraic_error;
  others.contact = contact_part(solved);
  return estimate_error(solved, scale, correct_pressure(solved), others);
}

/** Computes the bound of the error of U and P, and its parts by cell; or says why there is none. */
void add_bound(const Given<WantedBound> &wanted, const Discretization<2> &discretization,
               LevelSolution<2> &solution) {
  LevelRecord &record = solution.record;
  const StageTimer timer(record.times.postprocess), bound_timer(record.times.bound);
  LocatedBound located;
  const ContactSolution<2> &contact = solution.contact;
  if (wanted == WantedBound::none)
    located.bound.missing = wanted.name + " is false";
  else if (contact.U.size() > max_bounded_unknowns)
    located.bound.missing =
      "it is not computed for more than " + std::to_string(max_bounded_unknowns) + " unknowns";
  else {
    const double work = contact.modes.work_of_plates(solution.scene.plates, contact.q),
                 dissipation = record.friction ? record.friction->dissipation : 0.;
    located = compute_located_bound({{discretization, solution.scene, contact},
                                     record.certificate.energy + work - dissipation,
                                     solution.energy});
    for (std::optional<double> *const energy :
         {&located.bound.energy_lower, &located.bound.energy_upper})
      if (*energy)
        **energy -= work;
  }
  record.bound = located.bound;
  solution.bound_fields = std::move(located.fields);
}

/** Adds what is known about other solutions with Coulomb's friction. */
void add_regularity(const Discretization<2> &discretization, LevelSolution<2> &solution) {
  FrictionSummary &friction = *solution.record.friction;
  const StageTimer timer(solution.record.times.postprocess);
  const ContactSolution<2> &contact = solution.contact;
  if (contact.dual->C == nullptr)
    return;
  if (const auto found = examine_regularity(contact.dual->C, contact.dual->motions,
                                            discretization.K, contact.P.values())) {
    friction.critical_factor = found->critical_factor;
    friction.fixed_point_rate = found->fixed_point_rate;
    friction.is_regular = found->has_sign_of_no_friction;
  }
}

/** Adds the certificate, and the answer, which needs the same nodal forces. */
template <int dim>
void add_certificate_and_answer(const Discretization<dim> &discretization,
                                LevelSolution<dim> &solution) {
  const auto &[contact, scene] = std::tie(solution.contact, solution.scene);
  const Solved<dim> solved(discretization, scene, contact);
  LevelRecord &record = solution.record;
  const NodalForces forces = nodal_forces(solved, contact.system->loads, discretization.D);
  solution.energy = forces.energy;
  record.certificate = certify(solved, forces);
  record.certificate.motion_balance = motion_balance(scene.plates, contact.modes, forces);
  record.motions.plates = plates_of(solved, forces);
  record.answer = compute_answer<dim>(solved, forces);
}

/** Computes what follows from U and P: the certificate, the answer, and the estimate and the
 * bound of the error, as far as they are wanted. Collective. */
template <int dim>
void examine(const Parameters &parameters, const Discretization<dim> &discretization,
             const Progress &progress, LevelSolution<dim> &solution) {
  const ContactSolution<dim> &contact = solution.contact;
  LevelRecord &record = solution.record;
  record.sizes = sizes_of(discretization, parameters.discretization.strategy);
  record.times = contact.times;
  record.times.mesh = discretization.times.mesh;
  record.times.setup = discretization.times.setup;
  record.linear = contact.linear;
  record.dual = contact.report;
  record.motions.undetermined = contact.undetermined;
  record.contact = summarise_contact(discretization.multipliers, contact.P.normal());
  const StageTimer timer(record.times.postprocess);
  if (contact.P.has_friction())
    record.friction = summarise_friction(discretization.multipliers, contact.P, contact.W);
  progress("certificate");
  add_certificate_and_answer(discretization, solution);
  if (discretization.mesh.has_parents())
    record.estimate =
      estimate_of(Solved<dim>(discretization, solution.scene, contact), solution.energy);
}
} // namespace

template <int dim>
LevelSolution<dim> solve_level(const LevelProblem<dim> &problem,
                               const Discretization<dim> &discretization, const ContactStart &start,
                               const Progress &progress) {
  const auto [parameters, scene, solvers] = problem;
  const auto method = make_contact_method(parameters, scene, solvers);
  LevelSolution<dim> solution;
  solution.contact = method->solve(discretization, start, progress);
  const ContactSolution<dim> &contact = solution.contact;
  solution.scene = with_plates_moved(scene, contact.modes.plate_motions(scene.plates, contact.q));
  examine(parameters, discretization, progress, solution);
  return solution;
}

template <int dim>
void finish_level(const LevelProblem<dim> &problem, const Discretization<dim> &discretization,
                  const bool wants_bound, const Progress &progress, LevelSolution<dim> &solution) {
  if constexpr (dim == 2) {
    if (wants_bound) {
      if (solution.record.friction)
        add_regularity(discretization, solution);
      progress("bound of the error");
      add_bound(problem.parameters.output.bound, discretization, solution);
    }
  }
  release_unused(problem, solution);
}

INSTANTIATE_FUNCTION(solve_level);
INSTANTIATE_FUNCTION(finish_level);
} // namespace Signorini
