// SPDX-License-Identifier: LGPL-2.1-or-later
// Stresses and displacements where the user wants them.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/postprocessing/fields/stress.h>
#include <signorini/postprocessing/quantities/probe_report.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/grid_tools_cache.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
using Values = std::array<double, n_report_fields>;

/** The fields of which the smallest value is wanted have the sign -1. */
constexpr Values signs = {{1., 1., -1., 1.}};

/** The contribution of a part of the body to a probe; of the fields with their signs. */
struct ProbePart {
  std::vector<FieldMaximum> largest;
  std::vector<GrowthEdge> growth;
  std::vector<std::vector<double>> rows;

  void add(const std::vector<FieldMaximum> &values) {
    if (largest.empty())
      largest = values;
    else
      for (std::size_t i = 0; i < values.size(); ++i)
        take_larger(values[i], largest[i]);
  }
  void add(const GrowthEdge &edge) {
    if (std::none_of(growth.begin(), growth.end(),
                     [&](const GrowthEdge &known) { return known.ends == edge.ends; }))
      growth.push_back(edge);
  }
  void add(const ProbePart &other) {
    add(other.largest);
    for (const GrowthEdge &edge : other.growth)
      add(edge);
    rows.insert(rows.end(), other.rows.begin(), other.rows.end());
  }
  template <typename Archive>
  void serialize(Archive &archive, const unsigned int /*version*/) {
    archive &largest &growth &rows;
  }
};
using ProbeParts = std::vector<ProbePart>;

void add(const ProbeParts &parts, ProbeParts &sum) {
  sum.resize(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    sum[i].add(parts[i]);
}

/** Reads the fields of a solution for probes. */
template <int dim>
class ProbeReader {
public:
  using Cell = typename DoFHandler<dim>::active_cell_iterator;

  ProbeReader(const BodyInContact<dim> &body, const SampledField<dim> &field,
              const std::vector<SingularEdge<dim>> &singular)
    : body_(body)
    , field_(field)
    , singular_(singular) {}

  /** Returns the contributions of a chunk of cells to the probes. */
  ProbeParts read_cells(const Cells<dim> &cells) const {
    CellEvaluator<dim> u = field_.at_nodes();
    std::vector<FieldSample<dim>> samples;
    const std::vector<Probe<dim>> &probes = field_.scene.probes;
    ProbeParts parts(probes.size());
    for (const Cell &cell : cells) {
      if (std::none_of(probes.begin(), probes.end(),
                       [&](const auto &probe) { return may_contain(probe, cell); }))
        continue;
      u.reinit(cell, field_.space.element_number(cell));
      field_.sample(u, samples);
      for (std::size_t i = 0; i < probes.size(); ++i) {
        const bool in_region = is_in_region(probes[i], cell);
        for (const FieldSample<dim> &sample : samples)
          if (in_region || contains(probes[i], cell, sample))
            add_sample(cell, sample, parts[i]);
      }
    }
    return parts;
  }

  /** Returns the contributions of the cells of this rank to the points of a probe. */
  ProbePart read_points(const Probe<dim> &probe, const GridTools::Cache<dim> &cache) const {
    CellEvaluator<dim> u = field_.at_nodes();
    ProbePart part;
    for (const Point<dim> &x : probe.points) {
      const auto [found, unit] = GridTools::find_active_cell_around_point(cache, x);
      if (found.state() != IteratorState::valid || !found->is_locally_owned())
        continue;
      const Cell cell(&cache.get_triangulation(), found->level(), found->index(),
                      &field_.space.dofs());
      u.reinit_once(cell, Quadrature<dim>(unit));
      const FieldSample<dim> sample = field_.sample(u, 0);
      add_row(probe.points.front(), x, cell, sample, part);
      add_sample(cell, sample, part, probe.points.size() == 1);
    }
    return part;
  }

private:
  bool is_in_region(const Probe<dim> &probe, const Cell &cell) const {
    return probe.region && field_.scene.geometry.region_at(cell->center()) == *probe.region;
  }
  /** Returns false where a cell is far from a probe. */
  bool may_contain(const Probe<dim> &probe, const Cell &cell) const {
    if (probe.radius > 0.)
      return cell->center().distance(probe.centre) <= probe.radius + cell->diameter();
    if (probe.box) {
      BoundingBox<dim> around = *probe.box;
      around.extend(cell->diameter());
      return around.point_inside(cell->center());
    }
    return is_in_region(probe, cell) || (!probe.sides.empty() && cell->at_boundary());
  }
  bool contains(const Probe<dim> &probe, const Cell &cell, const FieldSample<dim> &sample) const {
    if constexpr (dim == 2)
      if (probe.stretch) {
        const double s = field_.scene.geometry.sides[probe.sides[0]].arc_length(sample.x);
        if (s < (*probe.stretch)[0] || s > (*probe.stretch)[1])
          return false;
      }
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f) && std::abs(sample.unit[f / 2] - f % 2) < 1e-12 &&
          std::count(probe.sides.begin(), probe.sides.end(), cell->face(f)->boundary_id()) > 0)
        return true;
    return probe.contains(sample.x);
  }

  Stress3D stress_of(const Cell &cell, const FieldSample<dim> &sample) const {
    return StressIn3D<dim>(*field_.scene.material)(sample.x, cell->center(), sample.strain);
  }
  static Values fields_of(const Stress3D &stress, const FieldSample<dim> &sample) {
    const std::array<double, 3> principal = principal_stresses(stress);
    return {{von_mises(stress), principal[0], principal[2], sample.u.norm()}};
  }

  /** @param always whether a sample next to an edge of growth counts, too. */
  void add_sample(const Cell &cell, const FieldSample<dim> &sample, ProbePart &part,
                  const bool always = false) const {
    const std::optional<GrowthEdge> growth = growth_at(sample.x, singular_, body_);
    if (growth)
      part.add(*growth);
    if (growth && !always)
      return;
    try {
      const Values values = fields_of(stress_of(cell, sample), sample);
      std::vector<FieldMaximum> maxima;
      for (std::size_t i = 0; i < values.size(); ++i)
        maxima.push_back({signs[i] * values[i], sample.x, mesh_at(field_.space, cell)});
      part.add(maxima);
    } catch (const InputError &) {
    }
  }

  void add_row(const Point<dim> &start, const Point<dim> &x, const Cell &cell,
               const FieldSample<dim> &sample, ProbePart &part) const {
    try {
      const Stress3D stress = stress_of(cell, sample);
      std::vector<double> row = {x.distance(start)};
      row.insert(row.end(), x.begin_raw(), x.end_raw());
      row.insert(row.end(), sample.u.begin_raw(), sample.u.end_raw());
      row.insert(row.end(), {stress[0][0], stress[1][1], stress[2][2], stress[0][1]});
      if (dim == 3)
        row.insert(row.end(), {stress[0][2], stress[1][2]});
      const Values values = fields_of(stress, sample);
      row.insert(row.end(), values.begin(), values.end());
      part.rows.push_back(row);
    } catch (const InputError &) {
    }
  }

  const BodyInContact<dim> &body_;
  const SampledField<dim> &field_;
  const std::vector<SingularEdge<dim>> &singular_;
};

/** Returns the contributions of the whole body to the probes. Collective. */
template <int dim>
ProbeParts parts_of_all(const SampledField<dim> &field, const ProbeReader<dim> &reader) {
  const std::vector<Probe<dim>> &probes = field.scene.probes;
  const Mesh<dim> &mesh = field.space.mesh();
  ProbeParts mine(probes.size()), all;
  integrate_by_chunks<ProbeParts, dim>(
    field.space, [&](const Cells<dim> &cells) { return reader.read_cells(cells); },
    [&mine](const ProbeParts &parts) { add(parts, mine); });
  const GridTools::Cache<dim> cache(mesh.triangulation(), mesh.mapping());
  for (std::size_t i = 0; i < probes.size(); ++i)
    if (!probes[i].points.empty())
      mine[i] = reader.read_points(probes[i], cache);
  for (const ProbeParts &parts : Utilities::MPI::all_gather(mesh.communicator(), mine))
    add(parts, all);
  return all;
}
} // namespace

std::string to_text(const ReportField field) {
  constexpr std::array<const char *, n_report_fields> names = {
    {"von_mises", "largest_principal", "smallest_principal", "displacement"}};
  return names[static_cast<std::size_t>(field)];
}

std::vector<std::pair<std::string, double>>
named_extremes(const std::vector<ProbeReport> &reports) {
  std::vector<std::pair<std::string, double>> numbers;
  for (const ProbeReport &report : reports)
    for (std::size_t k = 0; k < report.extremes.size(); ++k)
      numbers.emplace_back(to_text(static_cast<ReportField>(k)) + " at " + report.probe,
                           report.extremes[k].value);
  for (const ProbeReport &report : reports)
    for (const BoundedValue &mean : report.means)
      if (mean.error) {
        const std::string name = mean.name + " at " + report.probe;
        numbers.emplace_back(name, mean.value);
        numbers.emplace_back("error of " + name, *mean.error);
      }
  return numbers;
}

std::string report_header(const unsigned int dimension) {
  return dimension == 2 ? "s,x,y,u_x,u_y,stress_xx,stress_yy,stress_zz,stress_xy,von_mises,"
                          "largest_principal,smallest_principal,displacement"
                        : "s,x,y,z,u_x,u_y,u_z,stress_xx,stress_yy,stress_zz,stress_xy,stress_xz,"
                          "stress_yz,von_mises,largest_principal,smallest_principal,displacement";
}

template <int dim>
std::vector<ProbeReport> report_on_probes(const BodyInContact<dim> &body,
                                          const std::vector<SingularEdge<dim>> &singular) {
  const std::vector<Probe<dim>> &probes = body.scene.probes;
  if (probes.empty())
    return {};
  const SampledField<dim> field(body);
  const ProbeParts all = parts_of_all(field, ProbeReader<dim>(body, field, singular));
  std::vector<ProbeReport> reports;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (!probes[i].points.empty() && all[i].rows.empty())
      throw input_error(probes[i].where, ": found ", quote(probes[i].name),
                        ", which is outside of the body, allowed: points of the body.");
    reports.push_back({probes[i].name, all[i].largest, all[i].growth, all[i].rows, {}});
    for (std::size_t k = 0; k < reports[i].extremes.size(); ++k)
      reports[i].extremes[k].value *= signs[k];
    std::sort(reports[i].rows.begin(), reports[i].rows.end());
  }
  return reports;
}

INSTANTIATE_FUNCTION(report_on_probes);
} // namespace Signorini
