// SPDX-License-Identifier: LGPL-2.1-or-later
// From the findings of a step to the mesh of the next one.

#include <signorini/error_control/hp/next_plan.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/corners.h>
#include <signorini/problem/scene/facing.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** The factor by which the error should fall in a full step. */
constexpr double reduction = 12.;

/** The number of additional layers in a full step at an end of contact, where u ~ r^{3/2}. */
constexpr double layers_per_step = 3.;
constexpr double exponent_at_ends = 1.5;

/** The largest number of cells in the bracket of an end: deeper layers wait until the end is known
 * better. The bracket of an end that was found before has 16. */
constexpr double most_in_bracket = 32.;

/** The smallest exponent: smaller ones would need more layers than a mesh can have. */
constexpr double min_exponent = 0.2;

/** The rise of the degree far away from singularities in a full step. */
constexpr double rise_per_step = 1.5;

/** The decay above which a cell is split. Below it, the degree rises. */
constexpr double slow_decay = 0.4;

/** Returns the share of a full step that leads to the goal. */
double step_length(const double error, const double goal) {
  return std::min(1., std::max(1. / 3., std::log(error / goal) / std::log(reduction)));
}

/** Returns the indicators of the cells at a singularity. */
std::vector<CellIndicator> indicators_at(const Singularity &singularity, const Scene<2> &scene,
                                         const Mesh<2> &mesh,
                                         const std::vector<CellIndicator> &indicators) {
  std::vector<CellIndicator> found;
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    if (singularity.touches(scene, cell))
      found.push_back(indicators[cell->active_cell_index()]);
  return found;
}

/** Returns a singularity on a part of a side. */
Singularity on_side(const Singularity::Kind kind, const ZoneBracket &part, const Scene<2> &scene) {
  Singularity found = {kind,
                       scene.geometry.sides[part.side].point(0.5 * (part.from + part.to)),
                       exponent_at_ends,
                       part.side,
                       part.from,
                       part.to};
  found.body = scene.geometry.body_of_side(part.side);
  return found;
}

/** Returns a part of a contact side, and in a pair the part of the other side that lies across: u
 * is singular on both. */
std::vector<ZoneBracket> on_both_sides(const ZoneBracket &part, const Scene<2> &scene) {
  std::vector<ZoneBracket> parts = {part};
  for (const ContactPair<2> &pair : contact_pairs(scene)) {
    if (pair.side() != part.side || !pair.other_side() ||
        !pair.contains(0.5 * (part.from + part.to)))
      continue;
    const auto [from, to] =
      part_across(scene.geometry.sides[part.side], scene.geometry.sides[*pair.other_side()],
                  part.from, part.to);
    parts.push_back({*pair.other_side(), std::min(from, to), std::max(from, to)});
  }
  return parts;
}

/** The goals of the next step, in units of the indicators. */
struct Goal {
  /** The error of all cells together. */
  double error;
  /** The error of one cell. */
  double per_cell;
  /** The share of a full step. */
  double length;
};

/** Returns λ as observed from the error at a singularity, which falls by 2^{-λ} per layer. */
double observed_exponent(const Singularity &known, const double error) {
  const double more_layers = known.layers - known.last_layers;
  if (known.last_error <= 0. || more_layers < 1. || error <= 0.)
    return known.exponent;
  const double observed = std::log2(known.last_error / error) / more_layers;
  return std::max(min_exponent, std::min(known.exponent, observed));
}

/** Returns corners and kinks with the layers of the next mesh. */
std::vector<Singularity> grade_places(const MeshPlan &plan, const Scene<2> &scene,
                                      const Mesh<2> &mesh, const StepFindings &findings,
                                      const Goal &goal) {
  std::vector<Singularity> singularities;
  for (const Singularity &known : plan.singularities) {
    if (known.kind == Singularity::Kind::end_of_contact ||
        known.kind == Singularity::Kind::first_touch)
      continue;
    Singularity singularity = known;
    const auto indicators = indicators_at(known, scene, mesh, findings.indicators);
    const double error = total(indicators);
    singularity.exponent = observed_exponent(known, error);
    // u_h does not look analytic.
    const auto is_rough = [](const CellIndicator &cell) { return cell.decay > slow_decay; };
    const bool needs_first_layers =
      known.is_certain ||
      (plan.rise > 0. && std::any_of(indicators.begin(), indicators.end(), is_rough));
    if (known.layers > 0. ? error > 0.25 * goal.error
                          : needs_first_layers && error > 0.1 * goal.error) {
      singularity.last_error = error;
      singularity.last_layers = known.layers;
      singularity.layers += goal.length * layers_per_step * exponent_at_ends / singularity.exponent;
    }
    singularities.push_back(singularity);
  }
  return singularities;
}

/** Returns the kink at which contact ends, if there is one in the bracket or next to it. */
Singularity *kink_in(const Singularity &end, std::vector<Singularity> &singularities) {
  const double width = end.to - end.from;
  for (Singularity &singularity : singularities)
    if (singularity.kind == Singularity::Kind::kink && singularity.side == end.side &&
        singularity.from > end.from - 0.5 * width && singularity.to < end.to + 0.5 * width)
      return &singularity;
  return nullptr;
}

/** Returns the end of contact of the mesh before that is nearest on the same side, or the point of
 * the first touch, from which both ends of a zone come. */
const Singularity *end_before(const Singularity &end, const MeshPlan &plan) {
  const Singularity *found = nullptr;
  for (const Singularity &known : plan.singularities)
    if ((known.kind == Singularity::Kind::end_of_contact ||
         known.kind == Singularity::Kind::first_touch) &&
        known.side == end.side &&
        (found == nullptr || known.point.distance(end.point) < found->point.distance(end.point)))
      found = &known;
  return found;
}

/** Sets the singular singularities of the next mesh with their layers. */
void grade(const MeshPlan &plan, const Scene<2> &scene, const Mesh<2> &mesh,
           const StepFindings &findings, const Goal &goal, MeshPlan &next) {
  next.singularities = grade_places(plan, scene, mesh, findings, goal);
  // An end that moves takes its layers along; a new one has as many as an old one of this age.
  const double usual = layers_per_step * plan.rise / rise_per_step;
  std::vector<Singularity> all;
  for (const ZoneBracket &bracket : findings.brackets) {
    std::vector<Singularity> ends;
    std::vector<CellIndicator> indicators;
    double smallest = HUGE_VAL;
    for (const ZoneBracket &part : on_both_sides(bracket, scene)) {
      ends.push_back(on_side(Singularity::Kind::end_of_contact, part, scene));
      const auto found = indicators_at(ends.back(), scene, mesh, findings.indicators);
      indicators.insert(indicators.end(), found.begin(), found.end());
      smallest = std::min(smallest, plan.size_in(ends.back().body));
    }
    for (Singularity &end : ends) {
      // The cells of both bodies become equally small.
      const Singularity *const before = end_before(end, plan);
      end.layers = before != nullptr ? before->layers
                   : usual > 0.      ? usual + std::log2(plan.size_in(end.body) / smallest)
                                     : 0.;
      if (end.layers == 0. || total(indicators) > 0.2 * goal.error)
        end.layers += goal.length * layers_per_step;
      end.layers = std::min(
        end.layers, std::log2(most_in_bracket * plan.size_in(end.body) / (end.to - end.from)));
      if (Singularity *const kink = kink_in(end, next.singularities))
        kink->layers = std::max(kink->layers, end.layers);
      else
        all.push_back(end);
    }
  }
  next.singularities.insert(next.singularities.end(), all.begin(), all.end());
}

/** Splits or raises the degree of cells whose error the rest of the plan leaves too large. */
void demand(const Scene<2> &scene, const Mesh<2> &mesh, const std::vector<unsigned int> &degrees,
            const StepFindings &findings, const Goal &goal, MeshPlan &next) {
  constexpr double margin = 2.;
  for (const auto &cell : mesh.triangulation().active_cell_iterators()) {
    const CellIndicator &indicator = findings.indicators[cell->active_cell_index()];
    if (next.must_split(scene, cell, mesh.splits(cell)))
      continue;
    const unsigned int degree = degrees[cell->active_cell_index()];
    const unsigned int planned =
      std::max(degree, planned_degree(next, mesh, scene.geometry.body_of(cell), cell));
    const double predicted = indicator.error * std::pow(indicator.decay, planned - degree);
    const bool oscillates = indicator.oscillation > goal.per_cell;
    if (!oscillates && predicted <= margin * goal.per_cell)
      continue;
    const double missing =
      std::ceil(std::log(predicted / goal.per_cell) / std::log(1. / indicator.decay));
    CellDemand &demand = next.demands[cell->id()];
    if (!oscillates && indicator.decay < slow_decay && planned + missing <= next.max_element_degree)
      demand.degree = std::max(demand.degree, planned + static_cast<unsigned int>(missing));
    else {
      demand.split = true;
      demand.degree = std::max(demand.degree, degree);
    }
  }
}

/** Adds a corner at which u may be singular. */
void add_corner(const Corner &corner, const Scene<2> &scene, MeshPlan &plan) {
  constexpr double logarithm_exponent = 1.;
  const auto is_homogeneous = [&](const unsigned int side) {
    const Role role = scene.boundary[side].role;
    return role == Role::free || role == Role::clamped || role == Role::roller;
  };
  double exponent =
    smallest_exponent(scene, corner.position, corner.sides, layers_at(scene, corner));
  Singularity singularity = {Singularity::Kind::corner, corner.position};
  singularity.body = scene.geometry.body_of_side(corner.sides[0]);
  if (is_homogeneous(corner.sides[0]) && is_homogeneous(corner.sides[1]))
    singularity.is_certain = exponent < 1.;
  else
    // Data that does not fit together gives r log r; data of a smooth solution gives nothing.
    exponent = std::min(exponent, logarithm_exponent);
  singularity.exponent = std::max(exponent, min_exponent);
  if (exponent < max_corner_exponent)
    plan.singularities.push_back(singularity);
}

/** Adds the points of a side at which data has a kink: an end of contact, or the end of an
 * interface. */
void add_kinks(const unsigned int side, const Scene<2> &scene, MeshPlan &plan) {
  const Side<2> &curve = scene.geometry.sides[side];
  for (const double s : scene.kinks.separate_crossings(curve))
    for (const ZoneBracket &part : on_both_sides({side, s, s}, scene))
      plan.singularities.push_back(on_side(Singularity::Kind::kink, part, scene));
}

/** Adds the nearest points of the parts of two sides that face each other, unless these are flat.
 */
void add_first_touch(const ContactPair<2> &pair, const Scene<2> &scene, MeshPlan &plan) {
  constexpr double layers_to_see_contact = 4.;
  const Side<2> &first = scene.geometry.sides[pair.side()],
                &second = scene.geometry.sides[*pair.other_side()];
  if (first.is_flat() && second.is_flat())
    return;
  for (const FacingPart &part : facing_parts(first, second, grazing))
    if (pair.contains(part.nearest))
      for (const ZoneBracket &point :
           on_both_sides({pair.side(), part.nearest, part.nearest}, scene)) {
        plan.singularities.push_back(on_side(Singularity::Kind::first_touch, point, scene));
        plan.singularities.back().layers = layers_to_see_contact;
      }
}

/** Adds a corner of a body that may touch another one: u is singular in both, in the other one at
 * the point across. */
void add_paired_corner(const PairedCorner &paired, const Scene<2> &scene, MeshPlan &plan) {
  const double exponent = std::max(paired.exponent, min_exponent);
  const unsigned int body = scene.geometry.body_of_side(paired.corner.sides[0]);
  for (Singularity &known : plan.singularities)
    if (known.kind == Singularity::Kind::corner && known.body == body &&
        known.point == paired.corner.position)
      known.exponent = std::min(known.exponent, exponent);
  if (!paired.meets_corner) {
    plan.singularities.push_back(
      on_side(Singularity::Kind::kink, {paired.side, paired.s, paired.s}, scene));
    plan.singularities.back().exponent = exponent;
    plan.guides.vertices.emplace_back(paired.side, plan.singularities.back().point);
  }
}

/** Returns the size of the cells of a mesh of a box (length). */
double cell_size(const Tensor<1, 2> &box, const double n_cells, const unsigned int level) {
  return std::sqrt(box[0] * box[1] / n_cells) / std::pow(2., level);
}

/** Adds a line of the mesh, unless there is one close to it. */
void add_line(const double position, const double min_distance, std::vector<double> &lines) {
  if (std::all_of(lines.begin(), lines.end(),
                  [&](const double other) { return std::abs(position - other) >= min_distance; }))
    lines.push_back(position);
}
} // namespace

MeshPlan first_plan(const Scene<2> &scene, const unsigned int base_level,
                    const unsigned int max_element_degree) {
  MeshPlan plan;
  plan.base_level = base_level;
  plan.max_element_degree = max_element_degree;
  const Tensor<1, 2> box = scene.geometry.upper - scene.geometry.lower;
  plan.base_size = cell_size(box, scene.geometry.n_graded_cells(), base_level);
  for (const ElasticBody<2> &body : scene.geometry.bodies)
    plan.base_sizes.push_back(cell_size(body.upper - body.lower, body.n_graded_cells, base_level));
  // Splits keep the shape of narrow cells. Points where data of a side changes need no such cells:
  // the mesh is graded to them.
  for (const bool in_body : {true, false})
    for (const KinkLine<2> &line : scene.kinks.lines())
      for (unsigned int d = 0; d < 2; ++d)
        if (line.in_body == in_body && std::abs(line.normal[1 - d]) < 1e-12)
          add_line(line.position / line.normal[d],
                   in_body ? Kinks<2>::min_distance * box[d] : 0.25 * plan.base_size,
                   plan.guides.lines[d]);
  for (const Corner &corner : corners(scene.geometry))
    add_corner(corner, scene, plan);
  for (unsigned int side = 0; side < scene.boundary.size(); ++side)
    if (scene.has_contact_on(side) || !scene.material->is_constant())
      add_kinks(side, scene, plan);
  for (const PairedCorner &paired : paired_corners(scene))
    add_paired_corner(paired, scene, plan);
  for (const ContactPair<2> &pair : contact_pairs(scene))
    if (pair.other_side())
      add_first_touch(pair, scene, plan);
  return plan;
}

MeshPlan next_plan(const MeshPlan &plan, const Scene<2> &scene, const Mesh<2> &mesh,
                   const std::vector<unsigned int> &degrees, const StepFindings &findings) {
  MeshPlan next = plan;
  const std::size_t n_cells = mesh.triangulation().n_active_cells();
  if (!findings.missed_contact_cells.empty()) {
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (std::find(findings.missed_contact_cells.begin(), findings.missed_contact_cells.end(),
                    cell->active_cell_index()) != findings.missed_contact_cells.end())
        next.demands[cell->id()].split = true;
    return next;
  }
  const double reachable = std::max(findings.target, findings.unsplit);
  const double aim = std::max(0.6 * reachable, findings.error / reduction);
  Goal goal = {};
  goal.length = step_length(findings.error, aim);
  goal.error = findings.error > 0. ? total(findings.indicators) * aim / findings.error : 0.;
  goal.per_cell = goal.error / std::sqrt(static_cast<double>(n_cells));
  next.rise += goal.length * rise_per_step;
  next.aim = findings.error > 0. ? aim / findings.error : 1.;
  grade(plan, scene, mesh, findings, goal, next);
  if (plan.rise > 0.)
    demand(scene, mesh, degrees, findings, goal, next);
  return next;
}
} // namespace Signorini
