// SPDX-License-Identifier: LGPL-2.1-or-later
// What steps predict for the next one.

#include <signorini/discretization/space/body_measure.h>
#include <signorini/discretization/space/cell_field.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/error_control/hp/contact_misfit.h>
#include <signorini/error_control/hp/hidden_data.h>
#include <signorini/error_control/hp/step_examination.h>
#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/problem/scene/contradictions.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace Signorini {
double ErrorHistory::add(const double indicator, const std::optional<double> &difference,
                         const double planned) {
  constexpr double safety = 4. / 3.;
  double estimate = indicator;
  if (difference && last_indicator_) {
    const double indicator_ratio = *last_indicator_ > 0. ? indicator / *last_indicator_ : 1.;
    double ratio = std::max(indicator_ratio, planned);
    if (last_difference_ && *last_difference_ > 0.)
      ratio = std::max(ratio, std::min(*difference / *last_difference_, 4. * indicator_ratio));
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
  // The first steps see more and more of what the scene holds.
  constexpr std::size_t patience = 6, n_compared = 4;
  return estimates_.size() > patience &&
         estimates_.back() > 0.5 * estimates_[estimates_.size() - 1 - n_compared];
}

// The distance between the solutions of two steps.

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

/** Integrates over cells on which one function is given on the cell and the other on a cell that
 * contains it. */
class DistanceIntegrals {
public:
  explicit DistanceIntegrals(const Scene<2> &scene)
    : measure_(scene) {}

  double integrate(const Mesh<2> &mesh, const Triangulation<2>::active_cell_iterator &cell,
                   const CellField &on_cell, const CellField &on_ancestor, const Window &window) {
    const unsigned int n = std::max(on_cell.degree(), on_ancestor.degree()) + 1;
    const FEValues<2> &values = values_on(mesh, n, cell);
    const LineTable &table = table_on_cell(on_cell.degree(), n);
    const FieldValues<2> fine = on_cell.evaluate(table, table);
    const auto part = [&](const unsigned int d) {
      return make_line_table(on_ancestor.degree(), points_of(n, window.corner[d], window.edge));
    };
    const FieldValues<2> coarse = on_ancestor.evaluate(part(0), part(1));
    double energy = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      energy +=
        measure_at(values, q) * measure_.at(values.quadrature_point(q))
                                  .density(fine.values[q] - coarse.values[q],
                                           (fine.gradients[q] - window.edge * coarse.gradients[q]) *
                                             Tensor<2, 2>(values.inverse_jacobian(q)));
    return energy;
  }

private:
  static std::vector<double> points_of(const unsigned int n, const double from, const double edge) {
    // Newton's method finds the points in long double: once for every n.
    thread_local std::map<unsigned int, QGauss<1>> rules;
    std::vector<double> points;
    for (const Point<1> &x : rules.try_emplace(n, n).first->second.get_points())
      points.push_back(from + edge * x[0]);
    return points;
  }
  const LineTable &table_on_cell(const unsigned int degree, const unsigned int n) {
    LineTable &table = tables_[{degree, n}];
    if (table.values.empty())
      table = make_line_table(degree, points_of(n, 0., 1.));
    return table;
  }
  const FEValues<2> &values_on(const Mesh<2> &mesh, const unsigned int n,
                               const Triangulation<2>::active_cell_iterator &cell) {
    auto &values = values_[{&mesh, n}];
    if (values == nullptr)
      values = std::make_unique<FEValues<2>>(mesh.mapping(), no_functions_, QGauss<2>(n),
                                             update_inverse_jacobians | update_quadrature_points |
                                               update_JxW_values);
    values->reinit(cell);
    return *values;
  }

  EnergyMeasure<2> measure_;
  FE_Nothing<2> no_functions_;
  /** The tables, by degree and number of points. */
  std::map<std::pair<unsigned int, unsigned int>, LineTable> tables_;
  std::map<std::pair<const Mesh<2> *, unsigned int>, std::unique_ptr<FEValues<2>>> values_;
};

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
  DistanceIntegrals integrals(u.scene);
  double square = 0.;
  const auto integrate = [&](const DisplacedBody<2> &fine, const MeshCell &cell,
                             const DisplacedBody<2> &coarse) {
    return [&, cell](const auto &part, const Window &window) {
      const CellField on_part(fine.space.dof_cell(part), fine.U);
      const CellField on_whole(coarse.space.dof_cell(cell), coarse.U);
      square += integrals.integrate(fine.space.mesh(), part, on_part, on_whole, window);
    };
  };
  for (const auto &[in_u, in_v] : GridTools::get_finest_common_cells(
         u.space.mesh().triangulation(), v.space.mesh().triangulation()))
    if (in_u->is_active())
      for_each_part(in_v, {}, integrate(v, in_u, u));
    else
      for_each_part(in_u, {}, integrate(u, in_v, v));
  return std::sqrt(square);
}

// What is known about one step of a graded sequence.

StepFindings StepExamination::examine(const Solved<2> &solved, const EnergyScale &scale,
                                      const std::optional<DisplacedBody<2>> &before,
                                      const double planned) {
  std::vector<bool> presses, sticks;
  for (const NodeState &state : patch_states(solved.multipliers, solved.P)) {
    presses.push_back(state.presses);
    sticks.push_back(solved.scene.friction != Friction::none && state.slip == State::inside);
  }
  StepFindings findings;
  findings.indicators = indicate(solved);
  add_contact_misfit(solved, presses, Component::normal, findings.indicators);
  add_contact_misfit(solved, sticks, Component::tangential, findings.indicators);
  findings.jumps = add_jump_misfit(solved, findings.indicators);
  findings.brackets = zone_brackets(solved.multipliers, solved.P.states());
  findings.missed_contact_cells = missed_contact_cells(solved);
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
  // What does not fall while the mesh is refined has no limit: data contradict each other.
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
  // What is left of a plate are the displacements of its side.
  scene.plates.clear();
  return history_.n_steps() > patience && !find_contradiction(scene).empty();
}
} // namespace Signorini
