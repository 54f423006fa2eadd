// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/postprocessing/fields/energies.h>
#include <signorini/solvers/methods/solved.h>

#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

namespace Signorini {
/** The arc lengths of the ends of a line on a side, from < to; on a closed side one of them may lie
 * beyond it. */
struct SideSpan {
  SideSpan(const Side<2> &side, const Curve &line);

  /** Returns the arc length at a position of the line, from 0 to 1. */
  double arc_length(const double position) const {
    return is_forward ? from + position * (to - from) : to - position * (to - from);
  }

  double from, to;
  /** Whether the line runs along the side. */
  bool is_forward;
};

/** A displacement along a part of a side: a polynomial of the arc length. */
struct BoundaryTrace {
  /** The number of the side in the geometry. */
  unsigned int side = 0;
  /** The arc lengths of the ends, from < to; on a closed side one of them may lie beyond it. */
  double from = 0., to = 0.;
  /** The values at the nodes of Gauss and Lobatto between the ends, at least those at both. */
  std::vector<Tensor<1, 2>> values;

  /** Returns the value at an arc length. */
  Tensor<1, 2> value(double s) const;
  template <typename Archive>
  void serialize(Archive &archive, unsigned int /*version*/) {
    archive &side &from &to &values;
  }
};

/** The integrals of a continuous displacement v of a 2-D body that its distance to a stress in
 * equilibrium needs, see ReferenceStress. */
struct FieldWorks {
  /** The energy |||v|||² = ∫ ε(v):C:ε(v) (force x length per thickness). */
  double strain = 0.;
  /** The work f(v) + ∫ t·v of the loads and of the tractions that are given. */
  double load = 0.;
  /** The rest of quadrature in strain - 2 load. */
  double margin = 0.;
  /** v on the sides whose tractions are not given. */
  std::vector<BoundaryTrace> traces;
};

/**
 * Returns the works of u_h and, where cells of degree one have parents and straight edges, of
 * π^{2h} u_h. Cells with an arc have exact arcs (ExactMaps). Cells on which a rule of Gauss is not
 * exact take larger rules until two of them agree; the difference counts as margin, and so does
 * the work of loads that no point shows (HiddenLoad). Runs on all threads. Collective.
 */
std::vector<FieldWorks> works_of(const Solved<2> &solved);

/**
 * Returns the same from the sums of the level itself: f(u_h) and |||u_h|||² of its matrices, and
 * |||π^{2h} u_h|||² of the estimate. Only the load is integrated, for π^{2h} u_h, by three points
 * per direction. The margin lacks the rest of quadrature. There are no such sums on curved bodies
 * and with mean dilatation. Collective.
 * @param post_strain that of ErrorEstimate, of elements of degree one.
 */
std::vector<FieldWorks> works_by_sums(const Solved<2> &solved, const Energies &energies,
                                      const std::optional<double> &post_strain);
} // namespace Signorini
