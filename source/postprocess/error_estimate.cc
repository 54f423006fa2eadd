// SPDX-License-Identifier: LGPL-2.1-or-later
// Distances between interpolations of the nodal values; (24) and (31) make the first an estimate of
// the error of the mesh.

#include <signorini/elasticity/cell_chunks.h>
#include <signorini/elasticity/energy_norm.h>
#include <signorini/postprocess/error_estimate.h>
#include <signorini/postprocess/patch_interpolation.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace Signorini
{
namespace
{
/** Squares of norms of v - w, of a cell or of the body. */
struct Squares
{
  double values = 0.;
  double gradients = 0.;
  double energy = 0.;

  Squares &operator+=(const Squares &other)
  {
    values += other.values;
    gradients += other.gradients;
    energy += other.energy;
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
  Distance(const DisplacementSpace<dim> &space,
           const Material<dim> *const material,
           const NodalVector &U,
           const unsigned int fine)
    : material_(material)
    , U_(U)
    , values_(space.mesh().mapping(),
              space.element(),
              dealii::QGauss<dim>((space.element().degree << fine) + 1),
              dealii::update_values | dealii::update_gradients | dealii::update_inverse_jacobians |
                dealii::update_JxW_values | dealii::update_quadrature_points)
    , v_(space, values_.get_quadrature(), fine)
    , w_(space, values_.get_quadrature(), fine - 1)
  {
    if (material != nullptr && material->is_constant())
      hooke_ = material->hooke(dealii::Point<dim>());
  }
  Squares integrate(const CellIterator &cell)
  {
    values_.reinit(cell);
    const FieldValues<dim> &v = v_.evaluate(U_, cell, values_);
    const FieldValues<dim> &w = w_.evaluate(U_, cell, values_);
    Squares sum;
    for (const unsigned int q : values_.quadrature_point_indices())
    {
      const double JxW = values_.JxW(q);
      const dealii::Tensor<2, dim> gradient = v.gradients[q] - w.gradients[q];
      const dealii::SymmetricTensor<2, dim> strain = symmetrize(gradient);
      if (material_ != nullptr && !material_->is_constant())
        hooke_ = material_->hooke(values_.quadrature_point(q));
      sum += {(v.values[q] - w.values[q]).norm_square() * JxW,
              gradient.norm_square() * JxW,
              (hooke_ * strain) * strain * JxW};
    }
    return sum;
  }

private:
  /** Null: energies are not wanted. */
  const Material<dim> *material_;
  const NodalVector &U_;
  dealii::FEValues<dim> values_;
  PatchInterpolation<dim> v_, w_;
  dealii::SymmetricTensor<4, dim> hooke_;
};

/** The sums over all ranks; the threads' parts are added up in the order of cells. */
template <int dim>
Squares integrate(const DisplacementSpace<dim> &space,
                  const Material<dim> *const material,
                  const NodalVector &U,
                  const unsigned int fine)
{
  Squares sum;
  integrate_by_chunks<Squares, dim>(
    space,
    [&](const Cells<dim> &cells) {
      Distance<dim> distance(space, material, U, fine);
      Squares of_chunk;
      for (const auto &cell : cells)
        of_chunk += distance.integrate(cell);
      return of_chunk;
    },
    [&sum](const Squares &of_chunk) { sum += of_chunk; });
  for (double *const square : {&sum.values, &sum.gradients, &sum.energy})
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
ErrorEstimate estimate_error(const DisplacementSpace<dim> &space,
                             const Scene<dim> &scene,
                             const NodalVector &U,
                             const PressureCorrection &correction,
                             const OtherErrors &others)
{
  const Material<dim> *const material = scene.material.get();
  const Squares of_U = integrate(space, material, U, 1);
  double mesh_square = of_U.energy;
  if (correction.z.size() > 0)
  {
    NodalVector corrected(U);
    corrected += correction.z;
    mesh_square = integrate(space, material, corrected, 1).energy;
  }
  ErrorEstimate estimate;
  estimate.h1 = norm_1(of_U, 1.);
  estimate.mesh = std::sqrt(mesh_square);
  estimate.pressure = correction.energy_norm;
  estimate.algebra = others.algebra;
  estimate.contact = others.contact;
  estimate.energy = std::hypot(std::sqrt(mesh_square), correction.energy_norm);
  estimate.energy = std::hypot(estimate.energy, others.algebra, others.contact);
  if (estimate.energy > 0.)
    estimate.relative =
      estimate.energy /
      energy_scale(energy_norm(space, scene, U), estimate.energy, space, scene, U);
  return estimate;
}

template <int dim>
unsigned int best_interpolation(const DisplacementSpace<dim> &space, const NodalVector &U)
{
  if (space.mesh().n_nested_ancestors() < 2)
    return space.mesh().n_nested_ancestors();
  const auto change = [&](const unsigned int fine) {
    return norm_1(integrate<dim>(space, nullptr, U, fine), space.mesh().size());
  };
  return change(2) < 2. / 3. * change(1) ? 2 : 1;
}

Columns<ErrorEstimate> ErrorEstimate::columns()
{
  return {{"estimated_h1", &ErrorEstimate::h1},
          {"estimated_energy", &ErrorEstimate::energy},
          {"estimated_relative", &ErrorEstimate::relative},
          {"estimated_mesh", &ErrorEstimate::mesh},
          {"estimated_pressure", &ErrorEstimate::pressure},
          {"estimated_algebra", &ErrorEstimate::algebra},
          {"estimated_contact", &ErrorEstimate::contact}};
}

template ErrorEstimate estimate_error(const DisplacementSpace<2> &,
                                      const Scene<2> &,
                                      const NodalVector &,
                                      const PressureCorrection &,
                                      const OtherErrors &);
template ErrorEstimate estimate_error(const DisplacementSpace<3> &,
                                      const Scene<3> &,
                                      const NodalVector &,
                                      const PressureCorrection &,
                                      const OtherErrors &);
template unsigned int best_interpolation(const DisplacementSpace<2> &, const NodalVector &);
template unsigned int best_interpolation(const DisplacementSpace<3> &, const NodalVector &);
} // namespace Signorini
