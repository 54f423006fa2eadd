// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/postprocessing/norms/rectangle_norm.h>
#include <signorini/postprocessing/norms/spectral_norm.h>

#include <map>
#include <optional>
#include <type_traits>

namespace Signorini
{
/** The errors of the contact pressure in |||.|||_{-1/2,Γ_c}, the root of the sum of squares
 * over the contact sides. */
struct DualNormErrors
{
  /** The error |||p - p_H||| in the cosine norm and in the paper's (Sobolev-Slobodeckij) norm. */
  double spectral;
  std::optional<double> slobodeckij;
  /** The distance |||R^H p - p_H||| in the same norms. */
  double superclose_spectral;
  std::optional<double> superclose_slobodeckij;

  static Columns<DualNormErrors> columns();
};

/** The exact pressure on the contact sides, prepared for the norms of all levels. */
template <int dim>
class ExactPressure
{
public:
  /** Computes 8192 cosine coefficients per side; in 3-D 256 in each direction. Needs
   * Scene::has_exact_pressure(). */
  explicit ExactPressure(const Scene<dim> &scene);

  /** Returns the errors. The paper's norm is Richardson's extrapolation of grids with 8 m and 16 m
   * cells, m the patches of the side. It is left out where a side has more than 128 of them (its
   * cost grows like m³), on arcs (distances are not arc lengths there), and in 3-D. */
  DualNormErrors errors(const MultiplierSpace<dim> &space, const Pressure &P) const;

  /** Returns R^H p: the mean of p on every patch. */
  dealii::Vector<double> project(const MultiplierSpace<dim> &space) const;

private:
  /** Returns the errors on the patches [first, last), which make up a side. For 2-D only. */
  DualNormErrors errors_on_side(const MultiplierSpace<dim> &space,
                                const Pressure &P,
                                const dealii::Vector<double> &projected_p,
                                unsigned int first,
                                unsigned int last) const;

  using Coefficients =
    std::conditional_t<dim == 2, dealii::Vector<double>, dealii::FullMatrix<double>>;

  const Scene<dim> &scene_;
  std::map<unsigned int, Coefficients> coefficients_;
};
} // namespace Signorini
