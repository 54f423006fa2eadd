// SPDX-License-Identifier: LGPL-2.1-or-later
// Distances between interpolations of the nodal values; (24) and (31) make the first an estimate of
// the error.

#include <signorini/elasticity/cell_chunks.h>
#include <signorini/postprocess/error_estimate.h>
#include <signorini/postprocess/patch_interpolation.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace Signorini
{
namespace
{
/** ‖v‖_0^2 and |v|_1^2. */
struct Squares
{
  double values = 0.;
  double gradients = 0.;

  Squares &operator+=(const Squares &other)
  {
    values += other.values;
    gradients += other.gradients;
    return *this;
  }
};

/** Those of v - w and of v, of a cell or of the body. */
struct Comparison
{
  Squares difference;
  Squares norm;

  Comparison &operator+=(const Comparison &other)
  {
    difference += other.difference;
    norm += other.norm;
    return *this;
  }
};

/** v is the patch interpolation over @p fine generations, w over one less; every chunk of cells
 * has its own. */
template <int dim>
class Distance
{
public:
  using CellIterator = typename dealii::DoFHandler<dim>::active_cell_iterator;

  // Products of functions of degree two or four per direction: three or five points are exact on
  // parallelograms.
  Distance(const DisplacementSpace<dim> &space, const NodalVector &U, const unsigned int fine)
    : U_(U)
    , values_(space.mesh().mapping(),
              space.element(),
              dealii::QGauss<dim>((space.element().degree << fine) + 1),
              dealii::update_values | dealii::update_gradients | dealii::update_inverse_jacobians |
                dealii::update_JxW_values)
    , v_(space, values_.get_quadrature(), fine)
    , w_(space, values_.get_quadrature(), fine - 1)
  {
  }
  Comparison integrate(const CellIterator &cell)
  {
    values_.reinit(cell);
    const FieldValues<dim> &v = v_.evaluate(U_, cell, values_);
    const FieldValues<dim> &w = w_.evaluate(U_, cell, values_);
    Comparison sum;
    for (const unsigned int q : values_.quadrature_point_indices())
    {
      const double JxW = values_.JxW(q);
      sum.difference += {(v.values[q] - w.values[q]).norm_square() * JxW,
                         (v.gradients[q] - w.gradients[q]).norm_square() * JxW};
      sum.norm += {v.values[q].norm_square() * JxW, v.gradients[q].norm_square() * JxW};
    }
    return sum;
  }

private:
  const NodalVector &U_;
  dealii::FEValues<dim> values_;
  PatchInterpolation<dim> v_, w_;
};

/** The sums over all ranks; the threads' parts are added up in the order of cells. */
template <int dim>
Comparison integrate(const DisplacementSpace<dim> &space,
                     const NodalVector &U,
                     const unsigned int fine)
{
  Comparison sum;
  integrate_by_chunks<Comparison, dim>(
    space,
    [&](const Cells<dim> &cells) {
      Distance<dim> distance(space, U, fine);
      Comparison of_chunk;
      for (const auto &cell : cells)
        of_chunk += distance.integrate(cell);
      return of_chunk;
    },
    [&sum](const Comparison &of_chunk) { sum += of_chunk; });
  for (Squares *const squares : {&sum.difference, &sum.norm})
    for (double *const square : {&squares->values, &squares->gradients})
      *square = dealii::Utilities::MPI::sum(*square, space.mesh().communicator());
  return sum;
}

/** ‖.‖_1 with lengths in the given unit, up to that unit's own power. */
double norm_1(const Squares &squares, const double unit_of_length)
{
  return std::sqrt(squares.values / (unit_of_length * unit_of_length) + squares.gradients);
}
} // namespace

template <int dim>
ErrorEstimate estimate_error(const DisplacementSpace<dim> &space, const NodalVector &U)
{
  const Comparison sum = integrate(space, U, 1);
  const double size = space.mesh().size(), norm = norm_1(sum.norm, size);
  return {norm_1(sum.difference, 1.), norm > 0. ? norm_1(sum.difference, size) / norm : 0.};
}

template <int dim>
unsigned int best_interpolation(const DisplacementSpace<dim> &space, const NodalVector &U)
{
  if (space.mesh().n_nested_ancestors() < 2)
    return space.mesh().n_nested_ancestors();
  const auto change = [&](const unsigned int fine) {
    return norm_1(integrate(space, U, fine).difference, space.mesh().size());
  };
  return change(2) < 2. / 3. * change(1) ? 2 : 1;
}

Columns<ErrorEstimate> ErrorEstimate::columns()
{
  return {{"estimated_h1", &ErrorEstimate::absolute}};
}

template ErrorEstimate estimate_error(const DisplacementSpace<2> &, const NodalVector &);
template ErrorEstimate estimate_error(const DisplacementSpace<3> &, const NodalVector &);
template unsigned int best_interpolation(const DisplacementSpace<2> &, const NodalVector &);
template unsigned int best_interpolation(const DisplacementSpace<3> &, const NodalVector &);
} // namespace Signorini
