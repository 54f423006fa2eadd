// SPDX-License-Identifier: LGPL-2.1-or-later
// The left-hand sides of (13), (24) and (31), in one pass over the cells.

#include <signorini/elasticity/integration.h>
#include <signorini/errors/displacement_errors.h>
#include <signorini/parameters/exceptions.h>
#include <signorini/postprocess/nodal_interpolation.h>
#include <signorini/postprocess/patch_interpolation.h>

#include <cmath>

namespace Signorini
{
namespace
{
/** Squares of the norms, summed up cell by cell. */
struct Squares
{
  double l2 = 0.;
  double h1_seminorm = 0.;
  double superclose = 0.;
  double post = 0.;
};

template <int dim>
class ErrorIntegrals
{
public:
  using CellIterator = typename dealii::DoFHandler<dim>::active_cell_iterator;

  ErrorIntegrals(const DisplacementSpace<dim> &space,
                 const dealii::Function<dim> &exact,
                 const NodalVector &U,
                 const unsigned int n_points)
    : space_(space)
    , exact_(exact)
    , U_(U)
    , interpolant_minus_U_(interpolate_at_nodes(space, exact))
    , value_(dim)
  {
    interpolant_minus_U_ -= U;
    if (space.mesh().has_parents())
      interpolation_.emplace(space, dealii::QGauss<dim>(n_points));
  }

  void add(const CellIterator &cell, const dealii::FEValues<dim> &values, Squares &squares)
  {
    const dealii::FEValuesExtractors::Vector displacement(0);
    const unsigned int n = values.n_quadrature_points;
    u_.resize(n);
    du_.resize(n);
    e_.resize(n);
    de_.resize(n);
    values[displacement].get_function_values(U_, u_);
    values[displacement].get_function_gradients(U_, du_);
    values[displacement].get_function_values(interpolant_minus_U_, e_);
    values[displacement].get_function_gradients(interpolant_minus_U_, de_);
    const FieldValues<dim> *recovered =
      interpolation_ ? &interpolation_->evaluate(U_, cell, values) : nullptr;
    for (unsigned int q = 0; q < n; ++q)
    {
      const double weight = values.JxW(q);
      evaluate_exact(values.quadrature_point(q));
      squares.l2 += (exact_u_ - u_[q]).norm_square() * weight;
      squares.h1_seminorm += (exact_du_ - du_[q]).norm_square() * weight;
      squares.superclose += (e_[q].norm_square() + de_[q].norm_square()) * weight;
      if (recovered != nullptr)
        squares.post += ((exact_u_ - recovered->values[q]).norm_square() +
                         (exact_du_ - recovered->gradients[q]).norm_square()) *
                        weight;
    }
  }

private:
  void evaluate_exact(const dealii::Point<dim> &x)
  {
    exact_.vector_value(x, value_);
    for (unsigned int c = 0; c < dim; ++c)
    {
      exact_u_[c] = value_[c];
      exact_du_[c] = exact_.gradient(x, c);
    }
  }

  const DisplacementSpace<dim> &space_;
  const dealii::Function<dim> &exact_;
  const NodalVector &U_;
  NodalVector interpolant_minus_U_;
  std::optional<PatchInterpolation<dim>> interpolation_;
  dealii::Vector<double> value_;
  dealii::Tensor<1, dim> exact_u_;
  dealii::Tensor<2, dim> exact_du_;
  std::vector<dealii::Tensor<1, dim>> u_, e_;
  std::vector<dealii::Tensor<2, dim>> du_, de_;
};
} // namespace

template <int dim>
DisplacementErrors compute_displacement_errors(const DisplacementSpace<dim> &space,
                                               const Scene<dim> &scene,
                                               const NodalVector &U,
                                               const unsigned int n_points)
{
  const MPI_Comm communicator = space.mesh().communicator();
  const Kinks<dim> kinks = Kinks<dim>::of_scene(scene);
  CellValues<dim> cell_values(space.mesh().mapping(),
                              space.element(),
                              kinks,
                              n_points,
                              dealii::update_values | dealii::update_gradients |
                                dealii::update_quadrature_points | dealii::update_JxW_values |
                                dealii::update_inverse_jacobians);
  ErrorIntegrals<dim> integrals(space, *scene.exact_displacement, U, n_points);
  Squares squares;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned())
      integrals.add(cell, cell_values.reinit(cell), squares);
  const auto root_of_sum = [&](const double square) {
    return std::sqrt(dealii::Utilities::MPI::sum(square, communicator));
  };
  DisplacementErrors errors;
  errors.l2 = root_of_sum(squares.l2);
  errors.h1 = root_of_sum(squares.l2 + squares.h1_seminorm);
  errors.superclose_h1 = root_of_sum(squares.superclose);
  if (space.mesh().has_parents())
    errors.post_h1 = root_of_sum(squares.post);
  if (!std::isfinite(errors.h1))
    throw InputError("Exact solution: the displacement or its gradient has no finite value at a "
                     "quadrature point, allowed: finite values on the whole body; give "
                     "'Displacement gradient' where differences leave the body.");
  return errors;
}

template DisplacementErrors compute_displacement_errors(const DisplacementSpace<2> &,
                                                        const Scene<2> &,
                                                        const NodalVector &,
                                                        unsigned int);
} // namespace Signorini
