// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/mesh/contact_partition.h>
#include <signorini/mesh/kinks.h>

#include <deal.II/lac/vector.h>

namespace Signorini
{
/**
 * Q^H: one constant per patch. Integrates functions over the patches, on the pieces face ∩ tau, cut
 * at kinks.
 */
template <int dim>
class MultiplierSpace
{
public:
  MultiplierSpace(const Scene<dim> &scene,
                  std::vector<ContactFace<dim>> faces,
                  ContactPartition partition);

  /** m. */
  unsigned int n_multipliers() const
  {
    return partition_.patches.size();
  }
  const ContactPartition &partition() const
  {
    return partition_;
  }
  const std::vector<ContactFace<dim>> &faces() const
  {
    return faces_;
  }
  const Side<dim> &side(const Patch &patch) const
  {
    return scene_.geometry.sides[patch.side];
  }
  const BoundaryCondition<dim> &condition(const Patch &patch) const
  {
    return scene_.boundary[patch.side];
  }
  /** |tau| for all patches (length). */
  dealii::Vector<double> lengths() const;

  /**
   * Points and weights for integrals over a piece, cut at kinks, with @p n_points on each part;
   * with @p graded, geometrically refined towards kinks, with at least eight points, for functions
   * that are only continuous there.
   */
  struct Rule
  {
    std::vector<double> arc_lengths;
    std::vector<dealii::Point<dim>> points;
    std::vector<double> weights;
  };
  Rule rule(const Piece &piece, unsigned int n_points, bool graded = false) const;

private:
  const Scene<dim> &scene_;
  Kinks<dim> kinks_;
  std::vector<ContactFace<dim>> faces_;
  ContactPartition partition_;
};

/** G_tau = int_tau g. @throws InputError where g has no value. */
template <int dim>
dealii::Vector<double> assemble_gap(const MultiplierSpace<dim> &space, unsigned int n_points);
} // namespace Signorini
