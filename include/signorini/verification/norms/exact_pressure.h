// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/results/verdict/exact_errors.h>
#include <signorini/verification/norms/cosine_norm.h>

#include <vector>

namespace Signorini {
/** Returns the exact pressure at the points of a rule on a piece. */
template <int dim>
std::vector<double> exact_pressure_on(const ContactSurface<dim> &surface, const Piece<dim> &piece,
                                      const SurfaceRule<dim> &rule);

/** The exact pressure on the contact sides, prepared for the norms of all levels. */
template <int dim>
class ExactPressure {
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
  const Scene<dim> &scene_;
  /** Those of each contact. */
  std::vector<typename CosineNorm<dim>::Modes> coefficients_;
};
} // namespace Signorini
