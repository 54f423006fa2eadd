// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/postprocessing/fields/stress.h>

#include <deal.II/hp/fe_values.h>

#include <optional>
#include <vector>

namespace Signorini {
/** The displacement, the strain and the rotation at a point of a cell. */
template <int dim>
struct FieldSample {
  Point<dim> x;
  /** The coordinates in the reference cell. */
  Point<dim> unit;
  Tensor<1, dim> u;
  Strain<dim> strain;
  /** The angle |W| of the rotation, 2 |W|² = W:W with W = (∇u - ∇uᵀ)/2 (radians, small). */
  double rotation = 0.;
};

/** The solution of which samples are taken. */
template <int dim>
struct SampledField : DisplacedBody<dim> {
  explicit SampledField(const DisplacedBody<dim> &body);

  /** Returns the strain at a point of a cell where a displacement, u_h or its interpolation, has
   * this value and gradient. */
  Strain<dim> strain(const typename DoFHandler<dim>::active_cell_iterator &cell,
                     const Point<dim> &x, const Tensor<1, dim> &value,
                     const Tensor<2, dim> &gradient) const;

  /** The mean dilatations by cell; empty where the strain is that of u_h. */
  std::vector<double> dilatation;
};

/**
 * Evaluates π^{2h} u_h, or u_h on a mesh without T^{2h} and on cells of several degrees. With mean
 * dilatation the trace of the strain is mean_dilatations(). Every thread has its own.
 */
template <int dim>
class FieldSampler {
public:
  using Cell = typename DoFHandler<dim>::active_cell_iterator;

  /** @param field must outlive the object. */
  explicit FieldSampler(const SampledField<dim> &field);

  /** Returns the samples in the middle of a cell and at its corners, or on cells of several degrees
   * at their nodes; the middle is the first. They are valid until the next call. */
  const std::vector<FieldSample<dim>> &at_nodes(const Cell &cell);
  /** Returns the sample at a point of the reference cell. */
  FieldSample<dim> at(const Cell &cell, const Point<dim> &unit);

private:
  const std::vector<FieldSample<dim>> &evaluate(const Cell &cell, const FEValues<dim> &values);

  const SampledField<dim> &field_;
  /** The interpolation; empty on cells of several degrees. */
  std::optional<PatchInterpolation<dim>> interpolation_;
  hp::MappingCollection<dim> mappings_;
  /** The elements of cells of several degrees; the interpolation has its own shape functions. */
  hp::FECollection<dim> elements_;
  hp::FEValues<dim> values_by_element_;
  FieldValues<dim> at_points_;
  std::vector<FieldSample<dim>> samples_;
};
} // namespace Signorini
