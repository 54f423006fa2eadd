// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/scene.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <vector>

namespace Signorini
{
/**
 * Lines x_d = const at which data is not smooth. What they cross is integrated on the pieces, all
 * else with the plain rule. Where a line meets a contact side, contact may end and derivatives of
 * the solution may be unbounded: cells near such a point are integrated on pieces that shrink
 * towards it.
 */
template <int dim>
class Kinks
{
public:
  /** Lines only. */
  explicit Kinks(const std::array<std::vector<double>, dim> &positions);
  /** The lines of a scene, and where they meet its contact sides. */
  static Kinks of_scene(const Scene<dim> &scene);

  /**
   * The parameters t in [0,1], sorted, at which the segment from @p a to @p b is cut: 0, the
   * crossings, 1.
   */
  std::vector<double> cut(const dealii::Point<dim> &a, const dealii::Point<dim> &b) const;

  /** Whether a line passes through an end of the segment from @p a to @p b. */
  bool touch(const dealii::Point<dim> &a, const dealii::Point<dim> &b) const;

  /** Whether a line runs through the interior of the cell. */
  bool cross(const typename dealii::Triangulation<dim>::cell_iterator &cell) const;

  /** Whether the plain rule is not enough: a line crosses the cell or meets a contact side near it.
   */
  bool affect(const typename dealii::Triangulation<dim>::cell_iterator &cell) const;

  /**
   * A rule on the reference cell that integrates on the pieces of a (straight-sided) cell, with
   * @p n_points Gauss points per direction on each.
   */
  dealii::Quadrature<dim> quadrature(const typename dealii::Triangulation<dim>::cell_iterator &cell,
                                     unsigned int n_points) const;

private:
  /** The possible ends of contact zones that are near the cell, measured by its diameter. */
  std::vector<dealii::Point<dim>>
  ends_near(const typename dealii::Triangulation<dim>::cell_iterator &cell) const;

  std::array<std::vector<double>, dim> positions_;
  /** Possible ends of contact zones. */
  std::vector<dealii::Point<dim>> ends_;
};

/** The rule on [0,1] that applies @p rule between consecutive @p cuts. */
dealii::Quadrature<1> split_quadrature(const dealii::Quadrature<1> &rule,
                                       const std::vector<double> &cuts);
} // namespace Signorini
