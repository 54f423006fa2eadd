// SPDX-License-Identifier: LGPL-2.1-or-later
// The errors of nested levels from one graded stress.

#include <signorini/driver/sequence/level_errors.h>
#include <signorini/driver/sequence/reference_run.h>
#include <signorini/error_control/bound/contact_trace.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** Returns the target and the limit of the graded run: three digits of the error, and no more work
 * than the level itself takes, or a second. */
ReferenceTarget target_for(const LevelRecord &record) {
  constexpr double share = 5.5e-4, smallest = 1e-7, largest = 1e-3, usual_error = 0.05;
  constexpr unsigned long long few_unknowns = 30000, share_of_unknowns = 8, many_unknowns = 200000;
  const double error = record.estimate ? record.estimate->relative : usual_error;
  ReferenceTarget target;
  target.error = std::clamp(share * error, smallest, largest);
  target.max_unknowns = static_cast<unsigned int>(
    std::min(many_unknowns, few_unknowns + record.sizes.dofs / share_of_unknowns));
  return target;
}

/** Returns a bound that has the penetration of a level, and no errors yet. */
ErrorBound with_penetration(const BoundData &data) {
  ErrorBound bound;
  const Polynomials::Polynomial<double> zero(0);
  const ContactTrace trace(
    data, std::vector<FaceTractions>(data.surface().faces().size(), {{zero, zero}}));
  bound.penetration = trace.max_penetration();
  bound.place_of_penetration = name_of(trace.point_of_largest(), data.scene);
  return bound;
}
} // namespace

template <int dim>
bool LevelErrors<dim>::are_wanted() const {
  return dim == 2 && context_.parameters.output.bound != WantedBound::none &&
         !context_.scene.geometry.axisymmetric;
}

template <int dim>
void LevelErrors<dim>::add(const Discretization<dim> &discretization,
                           const LevelSolution<dim> &solution) {
  if constexpr (dim == 2) {
    if (!are_wanted() || !gap_on_all_meshes(solution.on(discretization)).empty())
      return;
    const LevelRecord &record = solution.record;
    const Solved<2> solved = solution.on(discretization);
    ErrorBound bound;
    // Samples are those of the whole body.
    if (!discretization.mesh.is_shared()) {
      const BoundData data(solved, *solution.operators->inverse, solution.energies, solution.scale);
      // No mesh has a stress then, as along curved pairs.
      if (!objection_to_stress(data).empty())
        return;
      bound = with_penetration(data);
    }
    levels_[record.sizes.level] = {
      works_of_level(solved, solution.energies, record), bound, solution.scale,
      solution.contact.P.normal() * discretization.multipliers.integrals()};
  }
}

template <int dim>
std::vector<FieldWorks> LevelErrors<dim>::works_of_level(const Solved<2> &solved,
                                                         const Energies &energies,
                                                         const LevelRecord &record) {
  constexpr unsigned long long many_cells = 5000;
  const auto post_strain = record.estimate ? record.estimate->post_strain : std::nullopt;
  const bool has_sums = !solved.space.mesh().is_curved() &&
                        solved.space.strain_operator() == StrainOperator::symmetric_gradient;
  if (!has_sums)
    return works_of(solved);
  std::vector<FieldWorks> sums = works_by_sums(solved, energies, post_strain);
  if (record.sizes.cells > many_cells && !rests_.empty()) {
    for (std::size_t k = 0; k < sums.size(); ++k)
      sums[k].margin += rests_[k] * sums[k].strain;
    return sums;
  }
  const std::vector<FieldWorks> works = works_of(solved);
  rests_.resize(works.size());
  for (std::size_t k = 0; k < sums.size(); ++k)
    rests_[k] = (works[k].margin + std::abs(works[k].strain - sums[k].strain) +
                 2. * std::abs(works[k].load - sums[k].load)) /
                works[k].strain;
  return works;
}

template <int dim>
bool LevelErrors<dim>::know_last(const LevelRecord &record, const Progress &progress) {
  constexpr double share = 1. / 3.;
  if constexpr (dim == 2) {
    if (levels_.count(record.sizes.level) == 0 || !record.dual.converged)
      return false;
    if (!run_)
      run_ = &context_.references->find(context_.parameters, context_.scene, target_for(record),
                                        progress);
    if (!run_->stress)
      return false;
    const WithMargin error = run_->stress->distance(levels_.at(record.sizes.level).works[0]);
    return error.value > 0. && error.margin <= share * error.value;
  }
  return false;
}

template <int dim>
std::map<unsigned int, ErrorBound> LevelErrors<dim>::all() const {
  std::map<unsigned int, ErrorBound> errors;
  for (const auto &[number, level] : levels_)
    errors[number] = error_of(level);
  return errors;
}

template <int dim>
ErrorBound LevelErrors<dim>::error_of(const Level &level) const {
  const ReferenceStress &stress = *run_->stress;
  ErrorBound bound = level.bound;
  const auto relative = [&](const double error) {
    const double scale = level.scale.of(error);
    return error == 0. ? 0. : error / scale;
  };
  const WithMargin error = stress.distance(level.works[0]);
  bound.distance = error.value;
  bound.margin = error.margin;
  bound.absolute = error.upper();
  bound.relative = relative(error.upper());
  if (level.works.size() > 1) {
    const WithMargin post = stress.distance(level.works[1]);
    bound.post_distance = post.value;
    bound.post_margin = post.margin;
    bound.post_absolute = post.upper();
    bound.post_relative = relative(post.upper());
  }
  bound.is_conditional = stress.is_conditional;
  if (stress.J) {
    bound.energy_lower = stress.J->lower;
    bound.energy_upper = stress.J->upper;
  }
  if (stress.contact_force)
    bound.force_error =
      std::abs(level.contact_force - stress.contact_force->value) + stress.contact_force->margin;
  return bound;
}

template class LevelErrors<2>;
template class LevelErrors<3>;
} // namespace Signorini
