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
/** ‖v - w‖_1^2 and ‖v‖_1^2, of a cell or of the body. */
struct Squares
{
  double difference = 0.;
  double norm = 0.;

  Squares &operator+=(const Squares &other)
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
              dealii::QGauss<dim>((1U << fine) + 1),
              dealii::update_values | dealii::update_gradients | dealii::update_inverse_jacobians |
                dealii::update_JxW_values)
    , v_(space, values_.get_quadrature(), fine)
    , w_(space, values_.get_quadrature(), fine - 1)
  {
  }
  Squares integrate(const CellIterator &cell)
  {
    values_.reinit(cell);
    const FieldValues<dim> &v = v_.evaluate(U_, cell, values_);
    const FieldValues<dim> &w = w_.evaluate(U_, cell, values_);
    Squares squares;
    for (const unsigned int q : values_.quadrature_point_indices())
    {
      squares.difference += ((v.values[q] - w.values[q]).norm_square() +
                             (v.gradients[q] - w.gradients[q]).norm_square()) *
                            values_.JxW(q);
      squares.norm += (v.values[q].norm_square() + v.gradients[q].norm_square()) * values_.JxW(q);
    }
    return squares;
  }

private:
  const NodalVector &U_;
  dealii::FEValues<dim> values_;
  PatchInterpolation<dim> v_, w_;
};

/** The roots of the sums over all ranks; the threads' parts are added up in the order of cells. */
template <int dim>
Squares integrate(const DisplacementSpace<dim> &space,
                  const NodalVector &U,
                  const unsigned int fine)
{
  Squares sum;
  integrate_by_chunks<Squares, dim>(
    space,
    [&](const Cells<dim> &cells) {
      Distance<dim> distance(space, U, fine);
      Squares squares;
      for (const auto &cell : cells)
        squares += distance.integrate(cell);
      return squares;
    },
    [&sum](const Squares &squares) { sum += squares; });
  const MPI_Comm communicator = space.mesh().communicator();
  return {std::sqrt(dealii::Utilities::MPI::sum(sum.difference, communicator)),
          std::sqrt(dealii::Utilities::MPI::sum(sum.norm, communicator))};
}
} // namespace

template <int dim>
ErrorEstimate estimate_error(const DisplacementSpace<dim> &space, const NodalVector &U)
{
  const Squares roots = integrate(space, U, 1);
  return {roots.difference, roots.norm > 0. ? roots.difference / roots.norm : 0.};
}

template <int dim>
unsigned int best_interpolation(const DisplacementSpace<dim> &space, const NodalVector &U)
{
  if (space.mesh().n_nested_ancestors() < 2)
    return space.mesh().n_nested_ancestors();
  const double quadratic = integrate(space, U, 1).difference;
  return integrate(space, U, 2).difference < 2. / 3. * quadratic ? 2 : 1;
}

template ErrorEstimate estimate_error(const DisplacementSpace<2> &, const NodalVector &);
template unsigned int best_interpolation(const DisplacementSpace<2> &, const NodalVector &);
} // namespace Signorini
