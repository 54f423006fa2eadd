// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/multiplier/multiplier_space.h>
#include <signorini/norms/spectral_norm.h>

#include <map>
#include <optional>

namespace Signorini
{
/**
 * Errors of the contact pressure in |||.|||_{-1/2,Gamma_c}, the root of the sum of squares over the
 * contact sides.
 */
struct DualNormErrors
{
  /** |||p - p_H||| in the cosine norm and in the paper's (Sobolev-Slobodeckij) norm. */
  double spectral;
  std::optional<double> slobodeckij;
  /** |||R^H p - p_H||| likewise. */
  double superclose_spectral;
  std::optional<double> superclose_slobodeckij;

  static Columns<DualNormErrors> columns();
};

/** The exact pressure on the contact sides, prepared for the norms of all levels. */
class ExactPressure
{
public:
  /** Needs Scene::has_exact_pressure(). Computes 8192 cosine coefficients per side. */
  explicit ExactPressure(const Scene<2> &scene);

  /**
   * The paper's norm is Richardson's extrapolation of grids with 8 m and 16 m cells, m the patches
   * of the side. It is left out where a side has more than 128 of them (its cost grows like m³) and
   * on arcs (distances are not arc lengths there).
   */
  DualNormErrors errors(const MultiplierSpace<2> &space, const dealii::Vector<double> &P) const;

  /** R^H p: the mean of p on every patch. */
  dealii::Vector<double> project(const MultiplierSpace<2> &space) const;

private:
  /** The same on the patches [first, last), which make up a side. */
  DualNormErrors errors_on_side(const MultiplierSpace<2> &space,
                                const dealii::Vector<double> &P,
                                const dealii::Vector<double> &projected_p,
                                unsigned int first,
                                unsigned int last) const;

  const Scene<2> &scene_;
  std::map<unsigned int, dealii::Vector<double>> coefficients_;
};
} // namespace Signorini
