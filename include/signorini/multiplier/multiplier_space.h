// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/mesh/contact_surface.h>

#include <deal.II/lac/vector.h>

namespace Signorini
{
/**
 * Q^H, the functions that are constant on every patch, with the basis psi_k = 1 on patch k and 0
 * elsewhere: p_H = sum P_k psi_k. Whoever needs unknowns, signs, values or integrals of multipliers
 * asks this space, so that another basis is a matter of this file.
 */
template <int dim>
class MultiplierSpace
{
public:
  using Vector = dealii::Vector<double>;

  /** @param surface must outlive the object. */
  explicit MultiplierSpace(const ContactSurface<dim> &surface);

  const ContactSurface<dim> &surface() const
  {
    return surface_;
  }
  /** m, the number of unknowns. */
  unsigned int n_multipliers() const
  {
    return surface_.patches().size() * n_per_patch;
  }
  /** The unknowns of a patch are first_of(patch), ..., first_of(patch) + n_per_patch - 1. */
  static constexpr unsigned int n_per_patch = 1;
  static unsigned int first_of(const unsigned int patch)
  {
    return patch * n_per_patch;
  }
  static unsigned int patch_of(const unsigned int unknown)
  {
    return unknown / n_per_patch;
  }

  /** psi_k at the point @p s of the side, on the patch to which the unknown belongs. */
  double shape_value(unsigned int unknown, const dealii::Point<dim - 1> &s) const;
  /** p_H at a point of a patch. */
  double value(const Vector &P, unsigned int patch, const dealii::Point<dim - 1> &s) const;

  /** The largest P_k that N^H allows: p_H <= 0 on every patch. */
  Vector upper_bounds() const;
  /** int psi_k for all k (length^{dim-1}). */
  Vector integrals() const;
  /** R^H q, the L2-projection of a function q, from its moments b_k = int q psi_k. */
  Vector project(const Vector &moments) const;

private:
  const ContactSurface<dim> &surface_;
};

/** int q psi_k for all k, where @p values_on (piece, rule) is a function q at the points
 * of a rule on a piece. */
template <int dim, typename Function>
dealii::Vector<double> integrate_against_multipliers(const MultiplierSpace<dim> &space,
                                                     const unsigned int n_points,
                                                     const Grading grading,
                                                     const Function &values_on)
{
  dealii::Vector<double> moments(space.n_multipliers());
  for (const Piece<dim> &piece : space.surface().pieces())
  {
    const SurfaceRule<dim> rule = space.surface().rule(piece, n_points, grading);
    const std::vector<double> q = values_on(piece, rule);
    const unsigned int first = space.first_of(piece.patch);
    for (unsigned int k = first; k < first + space.n_per_patch; ++k)
      for (std::size_t i = 0; i < rule.size(); ++i)
        moments[k] += q[i] * space.shape_value(k, rule.on_side[i]) * rule.weights[i];
  }
  return moments;
}

/** G_k = int g psi_k (length^dim), with @p n_points Gauss points per direction and part of a piece,
 * and rules that are refined towards kinks. @throws InputError where g has no value. */
template <int dim>
dealii::Vector<double> assemble_gap(const MultiplierSpace<dim> &space, unsigned int n_points);
} // namespace Signorini
