// SPDX-License-Identifier: LGPL-2.1-or-later
// The examination of a step of a graded sequence: its distance to the step before, its error, and
// its predictions for the next one.

#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/error_control/hp/contact_misfit.h>
#include <signorini/error_control/hp/hidden_data.h>
#include <signorini/error_control/hp/step_examination.h>
#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/problem/scene/contradictions.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Signorini {
double ErrorHistory::add(const double indicator, const std::optional<double> &difference,
                         const double planned) {
  constexpr double safety = 4. / 3.;
  double estimate = indicator;
  if (difference && last_indicator_) {
    const double indicator_ratio = *last_indicator_ > 0. ? indicator / *last_indicator_ : 1.;
    // The fall of the differences shows that of the errors, one step later.
    const double seen = last_difference_ && *last_difference_ > 0.
                          ? std::min(*difference / *last_difference_, 4. * indicator_ratio)
                          : planned;
    const double ratio = std::max(indicator_ratio, seen);
    estimate = std::max(estimate, *difference * std::min(1., ratio));
  }
  last_indicator_ = indicator;
  last_difference_ = difference;
  estimates_.push_back(safety * estimate);
  return estimates_.back();
}

bool ErrorHistory::stagnates() const {
  if (!estimates_.empty() && !std::isfinite(estimates_.back()))
    return true;
  // The first steps see more and more of the scene.
  constexpr std::size_t patience = 6, n_compared = 4;
  return estimates_.size() > patience &&
         estimates_.back() > 0.5 * estimates_[estimates_.size() - 1 - n_compared];
}

bool ErrorHistory::falls() const {
  const std::size_t n = estimates_.size();
  return n < 2 || estimates_[n - 1] < 0.9 * estimates_[n - 2];
}

namespace {
using MeshCell = Triangulation<2>::cell_iterator;

/** A part of a cell's reference square: the square with this corner and edge. */
struct Window {
  std::array<double, 2> corner = {{0., 0.}};
  double edge = 1.;

  /** Returns the quarter of this part that is the given child. */
  Window quarter(const unsigned int child) const {
    return {
      {{corner[0] + 0.5 * edge * (child & 1U), corner[1] + 0.5 * edge * ((child >> 1U) & 1U)}},
      0.5 * edge};
  }
};

/** Returns the points of Gauss' rule on a window. */
Quadrature<2> gauss_on(const Window &window, const unsigned int n) {
  // Newton's method finds the points in long double: once for every n.
  thread_local std::map<unsigned int, QGauss<2>> rules;
  std::array<std::vector<Point<1>>, 2> points;
  for (const Point<1> &x : rules.try_emplace(n, n).first->second.get_tensor_basis()[0].get_points())
    for (unsigned int d = 0; d < 2; ++d)
      points[d].emplace_back(window.corner[d] + window.edge * x[0]);
  return QAnisotropic<2>(Quadrature<1>(points[0]), Quadrature<1>(points[1]));
}

/** Integrates the energy of the difference of two functions on a cell, the other one given on a
 * cell that contains it. @param u is on the cell. */
double energy_on(const CellEvaluator<2> &u, const CellField &other, const Window &window,
                 EnergyMeasure<2> &measure, const unsigned int n_points) {
  const FieldValues<2> &fine = u.on_reference_cell(),
                       coarse = TabulatedRule(gauss_on(window, n_points)).evaluate(other);
  double energy = 0.;
  for (unsigned int q = 0; q < u.size(); ++q)
    energy += u.measure(q) *
              measure.at(u.points()[q])
                .density(fine.values[q] - coarse.values[q],
                         u.in_body(fine.gradients[q] - window.edge * coarse.gradients[q], q));
  return energy;
}

/** Visits all active descendants of a cell with their windows in it. */
template <typename Visitor>
void for_each_part(const MeshCell &cell, const Window &window, const Visitor &visit) {
  if (cell->is_active()) {
    visit(Triangulation<2>::active_cell_iterator(cell), window);
    return;
  }
  for (unsigned int child = 0; child < cell->n_children(); ++child)
    for_each_part(cell->child(child), window.quarter(child), visit);
}
} // namespace

double energy_distance(const DisplacedBody<2> &u, const DisplacedBody<2> &v) {
  EnergyMeasure<2> measure(u.scene);
  CellEvaluator<2> u_h(u.space, {{&u.U}}), v_h(v.space, {{&v.U}});
  double square = 0.;
  const auto integrate = [&](CellEvaluator<2> &fine, const DisplacedBody<2> &of_fine,
                             const MeshCell &cell, const DisplacedBody<2> &coarse) {
    return [&, cell](const auto &part, const Window &window) {
      const CellField on_whole(coarse.space.dof_cell(cell), coarse.U);
      const auto on_part = of_fine.space.dof_cell(part);
      const unsigned int n_points = std::max(on_part->get_fe().degree, on_whole.degree()) + 1;
      fine.reinit(on_part, n_points);
      square += energy_on(fine, on_whole, window, measure, n_points);
    };
  };
  for (const auto &[in_u, in_v] : GridTools::get_finest_common_cells(
         u.space.mesh().triangulation(), v.space.mesh().triangulation()))
    if (in_u->is_active())
      for_each_part(in_v, {}, integrate(v_h, v, in_u, u));
    else
      for_each_part(in_u, {}, integrate(u_h, u, in_v, v));
  return std::sqrt(square);
}

namespace {
/** Tells the part of the indicators on cells that no plan splits. */
void add_unsplit(const Mesh<2> &mesh, StepFindings &findings) {
  double square = 0., largest = 0.;
  for (const auto &cell : mesh.triangulation().active_cell_iterators()) {
    const double error = findings.indicators[cell->active_cell_index()].error;
    if (!is_deepest(cell))
      continue;
    square += error * error;
    if (error > largest)
      findings.deepest = cell->center();
    largest = std::max(largest, error);
  }
  findings.unsplit = std::sqrt(square);
}
} // namespace

StepFindings StepExamination::examine(const Solved<2> &solved, const EnergyScale &scale,
                                      const std::optional<DisplacedBody<2>> &before,
                                      const double planned) {
  StepFindings findings;
  findings.indicators = indicate(solved);
  add_contact_misfit(solved, Component::normal, findings.indicators);
  // In a step of a history the scene has none: P sticks to where the foundation has carried it.
  if (solved.scene.contact_law.has_tangential_part())
    add_contact_misfit(solved, Component::tangential, findings.indicators);
  findings.jumps = add_jump_misfit(solved, findings.indicators);
  findings.brackets = zone_brackets(solved.multipliers, solved.P.states());
  findings.missed_contact_cells = missed_contact_cells(solved);
  add_unsplit(solved.space.mesh(), findings);
  const double indicator = total(findings.indicators);
  findings.scale = scale.of(indicator);
  findings.target = target_ * findings.scale;
  if (!findings.missed_contact_cells.empty()) {
    // The next mesh sees another problem.
    history_ = ErrorHistory();
    return findings;
  }
  std::optional<double> difference;
  if (before)
    difference = energy_distance(solved, *before);
  // A solution that lies in the space leaves nothing but rounding.
  constexpr double rounding = 1e-12;
  double error = std::max(history_.add(indicator, difference, planned), rounding * findings.scale);
  // A number that does not fall while the mesh is refined has no limit: data contradict each other.
  constexpr double noticeable = 1e-3;
  if (history_.stagnates() && error > noticeable * findings.scale)
    error = std::max(error, findings.scale);
  error = std::hypot(error, solved.contact.algebraic_error);
  // Nothing has an error where nothing deforms the body: all that is left is rounding.
  constexpr double rounding_of_rigid_motions = 1e-7;
  const bool is_rigid =
    scale.norm < findings.scale && error <= rounding_of_rigid_motions * findings.scale;
  findings.error = is_rigid ? 0. : error;
  return findings;
}

bool StepExamination::plates_penetrate(Scene<2> scene) const {
  constexpr unsigned int patience = 3;
  // Without its plate, a side keeps only its prescribed displacements.
  scene.plates.clear();
  return history_.n_steps() > patience && !find_contradiction(scene).empty();
}
} // namespace Signorini
