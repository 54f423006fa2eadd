// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocessing/quantities/singular_edges.h>
#include <signorini/postprocessing/quantities/von_mises.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** The fields that a report has of a probe: the von Mises stress, the largest and the smallest
 * principal stress (force/area), and |u| (length). */
enum class ReportField { von_mises, largest_principal, smallest_principal, displacement };
constexpr std::size_t n_report_fields = 4;

/** Returns "von_mises", ... */
std::string to_text(ReportField field);

/** A mean over a probe or a force (unit of its field; force), with a bound of its error. */
struct BoundedValue {
  /** "mean stress_xx", "mean u_x", "force_x" or, on a stretch, "weighted force_n". */
  std::string name;
  double value = 0.;
  /** The guaranteed bound of |value - exact value|, or why there is none, a clause. */
  std::optional<double> error = {};
  std::string missing = {};
};

/** The values at a probe. */
struct ProbeReport {
  std::string probe;
  /** The extreme value of each field; of the smallest principal stress the smallest. Empty where
   * the mesh has no point in the probe. */
  std::vector<FieldMaximum> extremes;
  /** The corners and edges in the probe where stresses grow without limit. Points next to them are
   * left out of the extremes, unless the probe is a single point. */
  std::vector<GrowthEdge> growth;
  /** For a point and for points along a line: those in the body, with the distance from the start,
   * the coordinates, u, the stresses xx, yy, zz, xy (in space also xz, yz), and the four fields. */
  std::vector<std::vector<double>> rows;
  /** Where guaranteed means are wanted, those of the finest level. */
  std::vector<BoundedValue> means = {};
};

/** Returns the extremes and means of all probes with names for a table: "von_mises at 1,2 radius
 * 3", "mean u_x at top", "error of mean u_x at top". */
std::vector<std::pair<std::string, double>> named_extremes(const std::vector<ProbeReport> &reports);

/** Returns the names of the columns of ProbeReport::rows, separated by commas. */
std::string report_header(unsigned int dimension);

/**
 * Reports on the probes of a scene, at the points of SampledField::at_nodes(), and at the points of
 * lines. Points where the material's data has no value are left out. Collective.
 * @param singular the singular edges; P decides whether they grow.
 * @throws InputError for a point or a line outside of the body.
 */
template <int dim>
std::vector<ProbeReport> report_on_probes(const BodyInContact<dim> &body,
                                          const std::vector<SingularEdge<dim>> &singular);
} // namespace Signorini
