// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/scene.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace Signorini
{
/**
 * Lines at which data is not smooth. What they cross is integrated on the pieces, all
 * else with the plain rule. Where a line meets a contact side, contact may end and derivatives of
 * the solution may be unbounded: cells near such a point are integrated on pieces that shrink
 * towards it.
 */
template <int dim>
class Kinks
{
public:
  /** Lines only. */
  explicit Kinks(std::vector<KinkLine<dim>> lines);
  /** The lines of a scene, and where they meet its contact sides. */
  static Kinks of_scene(const Scene<dim> &scene);

  /**
   * The parameters t in [0,1], sorted, at which the segment from @p a to @p b is cut: 0, the
   * crossings, 1.
   */
  std::vector<double> cut(const dealii::Point<dim> &a, const dealii::Point<dim> &b) const;

  /**
   * The arc lengths, sorted, at which the part [from, to] of a side (or of its continuation) is
   * cut: from, the crossings, to.
   */
  std::vector<double> cut(const Side<dim> &side, double from, double to) const;

  /** Whether a line passes through an end of the part [from, to] of a side. */
  bool touch(const Side<dim> &side, double from, double to) const;

  /** Whether a line runs through the interior of the cell. */
  bool cross(const typename dealii::Triangulation<dim>::cell_iterator &cell) const;

  /** Whether the plain rule is not enough: a line crosses the cell or meets a contact side near it.
   */
  bool affect(const typename dealii::Triangulation<dim>::cell_iterator &cell) const;

  /**
   * A rule on the reference cell that integrates on the pieces of a cell, with @p n_points Gauss
   * points per direction on each. A curved cell is cut like the quadrilateral of its vertices: the
   * rule is as accurate there for smooth functions, and nearly so for others.
   */
  dealii::Quadrature<dim> quadrature(const typename dealii::Triangulation<dim>::cell_iterator &cell,
                                     unsigned int n_points) const;

private:
  /** The possible ends of contact zones that are near the cell, measured by its diameter. */
  std::vector<dealii::Point<dim>>
  ends_near(const typename dealii::Triangulation<dim>::cell_iterator &cell) const;

  std::vector<KinkLine<dim>> lines_;
  /** Possible ends of contact zones. */
  std::vector<dealii::Point<dim>> ends_;
};

/** The rule from the first to the last of the sorted @p cuts that applies @p rule, a rule on [0,1],
 * between consecutive ones. */
dealii::Quadrature<1> split_quadrature(const dealii::Quadrature<1> &rule,
                                       const std::vector<double> &cuts);
} // namespace Signorini
