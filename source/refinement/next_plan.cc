// SPDX-License-Identifier: LGPL-2.1-or-later
// From the findings of a step to the mesh of the next one.

#include <signorini/refinement/next_plan.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** By which the error shall fall in a full step. */
constexpr double reduction = 12.;

/** More layers in a full step at an end of contact, where u ~ r^{3/2}. */
constexpr double layers_per_step = 3.;
constexpr double exponent_at_ends = 1.5;

/** How much the degree rises far away from singularities in a full step. */
constexpr double rise_per_step = 1.5;

/** The share of a full step that leads to the goal. */
double step_length(const double error, const double goal)
{
  return std::min(1., std::max(1. / 3., std::log(error / goal) / std::log(reduction)));
}

/** The part of the indicators that lies at a singularity. */
double error_at(const Singularity &singularity,
                const Scene<2> &scene,
                const Mesh<2> &mesh,
                const std::vector<CellIndicator> &indicators)
{
  double square = 0.;
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    if (singularity.touches(scene, cell))
      square += std::pow(indicators[cell->active_cell_index()].error, 2);
  return std::sqrt(square);
}

Singularity end_of_contact(const ContactBracket &bracket,
                           const Scene<2> &scene,
                           const double layers)
{
  return {Singularity::Kind::end_of_contact,
          scene.geometry.sides[bracket.side].point(0.5 * (bracket.from + bracket.to)),
          exponent_at_ends,
          bracket.side,
          bracket.from,
          bracket.to,
          layers};
}

/** What the next step wants, in units of the indicators. */
struct Goal
{
  /** Of all cells together. */
  double error;
  /** Of one cell. */
  double per_cell;
  double length;
};

void grade(const MeshPlan &plan,
           const Scene<2> &scene,
           const Mesh<2> &mesh,
           const StepFindings &findings,
           const Goal &goal,
           MeshPlan &next)
{
  next.singularities.clear();
  double end_layers = 0.;
  for (const Singularity &known : plan.singularities)
  {
    if (known.kind == Singularity::Kind::end_of_contact)
    {
      end_layers = std::max(end_layers, known.layers);
      continue;
    }
    Singularity singularity = known;
    if (error_at(known, scene, mesh, findings.indicators) > 0.25 * goal.error)
      singularity.layers += goal.length * layers_per_step * exponent_at_ends / known.exponent;
    next.singularities.push_back(singularity);
  }
  end_layers = std::max(end_layers, layers_per_step * plan.rise / rise_per_step);
  for (const ContactBracket &bracket : findings.brackets)
    next.singularities.push_back(
      end_of_contact(bracket, scene, end_layers + goal.length * layers_per_step));
}

void demand(const Scene<2> &scene,
            const Mesh<2> &mesh,
            const std::vector<unsigned int> &degrees,
            const StepFindings &findings,
            const Goal &goal,
            MeshPlan &next)
{
  constexpr double slow_decay = 0.4, margin = 2.;
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
  {
    const CellIndicator &indicator = findings.indicators[cell->active_cell_index()];
    if (next.must_split(scene, cell, mesh.splits(cell)))
      continue;
    const unsigned int degree = degrees[cell->active_cell_index()];
    const unsigned int planned = std::max(degree, planned_degree(next, mesh, cell));
    const double predicted = indicator.error * std::pow(indicator.decay, planned - degree);
    if (predicted <= margin * goal.per_cell)
      continue;
    const double missing =
      std::ceil(std::log(predicted / goal.per_cell) / std::log(1. / indicator.decay));
    CellDemand &demand = next.demands[cell->id()];
    if (indicator.decay < slow_decay && planned + missing <= next.largest_degree)
      demand.degree = std::max(demand.degree, planned + static_cast<unsigned int>(missing));
    else
    {
      demand.split = true;
      demand.degree = std::max(demand.degree, degree);
    }
  }
}
} // namespace

MeshPlan first_plan(const Scene<2> &scene,
                    const unsigned int base_level,
                    const unsigned int largest_degree)
{
  MeshPlan plan;
  plan.base_level = base_level;
  plan.largest_degree = largest_degree;
  for (const KinkLine<2> &line : scene.kinks.lines())
    for (unsigned int d = 0; d < 2; ++d)
      if (std::abs(line.normal[1 - d]) < 1e-12)
        plan.lines[d].push_back(line.position / line.normal[d]);
  return plan;
}

MeshPlan next_plan(const MeshPlan &plan,
                   const Scene<2> &scene,
                   const Mesh<2> &mesh,
                   const std::vector<unsigned int> &degrees,
                   const StepFindings &findings)
{
  MeshPlan next = plan;
  const std::size_t n_cells = mesh.triangulation().n_active_cells();
  if (!findings.unseen_contact.empty())
  {
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (std::find(findings.unseen_contact.begin(),
                    findings.unseen_contact.end(),
                    cell->active_cell_index()) != findings.unseen_contact.end())
        next.demands[cell->id()].split = true;
    return next;
  }
  const double aim = std::max(0.6 * findings.target, findings.error / reduction);
  Goal goal = {};
  goal.length = step_length(findings.error, aim);
  goal.error = findings.error > 0. ? total(findings.indicators) * aim / findings.error : 0.;
  goal.per_cell = goal.error / std::sqrt(static_cast<double>(n_cells));
  next.rise += goal.length * rise_per_step;
  grade(plan, scene, mesh, findings, goal, next);
  if (plan.rise > 0.)
    demand(scene, mesh, degrees, findings, goal, next);
  return next;
}
} // namespace Signorini
