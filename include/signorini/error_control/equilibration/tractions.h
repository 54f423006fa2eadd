// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/bound_data.h>
#include <signorini/error_control/equilibration/oscillation.h>
#include <signorini/error_control/equilibration/traction_space.h>

#include <array>
#include <utility>
#include <vector>

namespace Signorini {
/** A condition row · x = value on the coefficients of edges, a row of length one, with the weight
 * of its square. */
struct TractionCondition {
  std::vector<std::pair<unsigned int, double>> row;
  double value = 0., weight = 0.;
};

/** The coefficients x of a space, with the values that the sides of a body prescribe. Those that
 * are not free keep their values. */
struct Tractions {
  using Vector = dealii::Vector<double>;

  /** Sets those on traction sides to the projection of t, and all others to zero; the tractions of
   * clamped sides, of rollers along the normal, and inside the body are free. */
  Tractions(const BoundData &data, const EquilibrationMesh &mesh);

  /** Returns the coefficients of τ_n (component 0) or τ_t on an edge. */
  std::vector<double> on_edge(unsigned int edge, unsigned int component) const;
  /** Sets them, and fixes them. */
  void fix(unsigned int edge, unsigned int component, const std::vector<double> &legendre);
  /** Projects the tractions of shared edges to those of both sides of pairs. */
  void project_shared();

  TractionSpace space;
  Vector x;
  /** The rests t - t_h by component and edge; on the sides of pairs, q - t_h. */
  std::array<std::vector<TractionRest>, 2> rests;
  /** The forces and moments on plates. */
  std::vector<TractionCondition> conditions;

private:
  void project_given(const BoundData &data);
  /** Returns q - t_h on an edge of a side of a pair. */
  TractionRest rest_of_pair(unsigned int edge, unsigned int component) const;
  void add_plates(const Scene<2> &scene);
};
} // namespace Signorini
