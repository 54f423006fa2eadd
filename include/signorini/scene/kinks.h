// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/side.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Signorini
{
/** The line (in space, the plane) normal.x = position, |normal| = 1. */
template <int dim>
struct KinkLine
{
  dealii::Tensor<1, dim> normal;
  double position;

  /** normal.x - position. */
  double signed_distance(const dealii::Point<dim> &x) const
  {
    return normal * (x - dealii::Point<dim>()) - position;
  }
};

/** The lines x_d = positions[d][k] for all d and k. */
template <int dim>
std::vector<KinkLine<dim>> lines_at(const std::array<std::vector<double>, dim> &positions);

/**
 * Lines at which data is not smooth, and the points where they meet contact sides. Contact may end
 * at such a point, and derivatives of the solution may be unbounded there.
 */
template <int dim>
class Kinks
{
public:
  /** Closer than this share of an edge, a line touches an end and cuts nothing. */
  static constexpr double tolerance = 1e-10;

  Kinks(std::vector<KinkLine<dim>> lines = {});

  /** Finds the points where the lines meet a contact side. */
  void add_ends_on(const Side<dim> &contact_side);

  /** The same lines, for meshes that are graded to the ends of contact: rules need not be. */
  Kinks without_ends() const
  {
    return Kinks(lines_);
  }

  const std::vector<KinkLine<dim>> &lines() const
  {
    return lines_;
  }
  /** Possible ends of contact zones. */
  const std::vector<dealii::Point<dim>> &ends() const
  {
    return ends_;
  }

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

private:
  std::vector<KinkLine<dim>> lines_;
  std::vector<dealii::Point<dim>> ends_;
};
} // namespace Signorini
