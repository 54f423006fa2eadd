// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest von Mises stress of the recovered displacement.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/postprocessing/fields/stress.h>
#include <signorini/postprocessing/quantities/von_mises.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** The relative difference of values that counts as none. */
constexpr double rounding = 1e-9;

/** The results of a set of cells. */
struct CellResults {
  /** The largest stress of all points, and of those away from singular edges. */
  FieldMaximum all, away;
  /** The measure of the cells, and that of those with large strains and with large rotations. */
  double measure = 0., strained = 0., turned = 0.;

  void add(const CellResults &other) {
    take_larger(other.all, all);
    take_larger(other.away, away);
    measure += other.measure;
    strained += other.strained;
    turned += other.turned;
  }
  template <typename Archive>
  void serialize(Archive &archive, const unsigned int /*version*/) {
    archive &all &away &measure &strained &turned;
  }
};

/** Returns no results: zero at the origin. */
template <int dim>
CellResults no_results() {
  return {{0., Point<dim>(), {}}, {0., Point<dim>(), {}}};
}

/** Returns whether a principal strain is large; none is larger than the norm. */
template <int dim>
bool is_large(const SymmetricTensor<2, dim> &strain) {
  if (strain.norm() <= large_strain)
    return false;
  const auto principal = eigenvalues(strain);
  return std::max(principal[0], -principal[dim - 1]) > large_strain;
}

/** Returns the results of a chunk of cells. Points where the material's data has no value are
 * skipped. */
template <int dim>
CellResults results_of(const Cells<dim> &cells, const SampledField<dim> &field,
                       const std::vector<SingularEdge<dim>> &edges) {
  const bool at_nodes = field.space.has_several_elements();
  CellEvaluator<dim> u = field.at_nodes();
  std::vector<FieldSample<dim>> samples;
  StressIn3D<dim> stress(*field.scene.material);
  CellResults results = no_results<dim>();
  for (const auto &cell : cells) {
    u.reinit(cell, field.space.element_number(cell));
    field.sample(u, samples);
    const double measure = cell->measure();
    const Point<dim> centre = cell->center();
    results.measure += measure;
    if (is_large(samples[0].strain.in_body))
      results.strained += measure;
    if (samples[0].rotation > large_rotation)
      results.turned += measure;
    const MeshAt mesh = mesh_at(field.space, cell);
    for (unsigned int q = at_nodes ? 1 : 0; q < samples.size(); ++q)
      try {
        const Point<dim> &x = samples[q].x;
        const double value = von_mises(stress(x, centre, samples[q].strain));
        // Most stresses are smaller, and nothing is stored for them.
        const auto matters = [&](const FieldMaximum &largest) {
          return value >= (1. - rounding) * largest.value;
        };
        if (matters(results.all))
          take_larger({value, x, mesh}, results.all);
        if (matters(results.away) && !any_contains(edges, x))
          take_larger({value, x, mesh}, results.away);
      } catch (const InputError &) {
      }
  }
  return results;
}

/** Returns the results of all cells. Collective. */
template <int dim>
CellResults results_of_body(const SampledField<dim> &field,
                            const std::vector<SingularEdge<dim>> &edges) {
  CellResults mine = no_results<dim>(), all = mine;
  integrate_by_chunks<CellResults, dim>(
    field.space, [&](const Cells<dim> &cells) { return results_of(cells, field, edges); },
    [&mine](const CellResults &part) { mine.add(part); });
  for (const CellResults &part :
       Utilities::MPI::all_gather(field.space.mesh().communicator(), mine))
    all.add(part);
  return all;
}
} // namespace

void take_larger(const FieldMaximum &other, FieldMaximum &largest) {
  const bool equal = std::abs(other.value - largest.value) <= rounding * std::abs(largest.value);
  if (equal ? other.point < largest.point : other.value > largest.value)
    largest = other;
}

template <int dim>
VonMises largest_von_mises(const DisplacedBody<dim> &body,
                           const std::vector<SingularEdge<dim>> &edges) {
  const CellResults results = results_of_body(SampledField<dim>(body), edges);
  VonMises stress = {results.all, {}, {}};
  if (!edges.empty())
    stress.away = results.away;
  stress.strained_share = results.strained / results.measure;
  stress.turned_share = results.turned / results.measure;
  return stress;
}

INSTANTIATE_FUNCTION(largest_von_mises);
} // namespace Signorini
