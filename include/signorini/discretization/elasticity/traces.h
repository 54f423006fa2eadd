// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/discretization/mesh/contact_surface.h>

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_values.h>

#include <memory>
#include <vector>

namespace Signorini
{
/** The shape functions of V^h at points of contact faces. Consecutive faces with the same reference
 * points share one table. */
template <int dim>
class TraceValues
{
public:
  explicit TraceValues(const DisplacementSpace<dim> &space);

  /**
   * Computes the shape functions on a face.
   * @param on_face points in the reference coordinates of the face.
   */
  const dealii::FEFaceValues<dim> &reinit(const ContactFace<dim> &face,
                                          const std::vector<dealii::Point<dim - 1>> &on_face);

  /** Returns u_h at the points of a rule on the face. */
  std::vector<dealii::Tensor<1, dim>> displacement(const ContactFace<dim> &face,
                                                   const SurfaceRule<dim> &rule,
                                                   const Displacement &U);

  /** Returns u_h.n at the points of a rule on the face. */
  std::vector<double> normal_displacement(const ContactFace<dim> &face,
                                          const SurfaceRule<dim> &rule,
                                          const Displacement &U);

private:
  const DisplacementSpace<dim> &space_;
  std::vector<dealii::Point<dim - 1>> on_face_;
  unsigned int element_number_ = 0;
  std::unique_ptr<dealii::FEFaceValues<dim>> values_;
};

/** The positions of the nodes of a cell, in the order of the cell's scalar shape functions. */
template <int dim>
class NodePositions
{
public:
  explicit NodePositions(const DisplacementSpace<dim> &space)
    : space_(space)
    , values_(space.elements().size())
  {
  }

  /** Returns the positions, valid until the next call. */
  const std::vector<dealii::Point<dim>> &
  operator()(const typename DisplacementSpace<dim>::CellIterator &cell)
  {
    const unsigned int number = space_.element_number(cell);
    std::unique_ptr<dealii::FEValues<dim>> &values = values_[number];
    if (values == nullptr)
    {
      const dealii::FiniteElement<dim> &element = space_.elements()[number];
      values = std::make_unique<dealii::FEValues<dim>>(
        space_.mesh().mapping(),
        element,
        dealii::Quadrature<dim>(element.base_element(0).get_unit_support_points()),
        dealii::update_quadrature_points);
    }
    values->reinit(cell);
    return values->get_quadrature_points();
  }

private:
  const DisplacementSpace<dim> &space_;
  /** The values by element. */
  std::vector<std::unique_ptr<dealii::FEValues<dim>>> values_;
};

/** Returns I^h u: the values of u at the nodes of V^h, all of them on every rank. */
template <int dim>
Displacement interpolate_at_nodes(const DisplacementSpace<dim> &space,
                                  const dealii::Function<dim> &u);

/** A moment: a number in 2-D, a vector in 3-D. */
template <int dim>
using Moment = dealii::Tensor<1, dim == 2 ? 1 : dim>;

/** Returns the moment x × F; in 2-D x1 F2 - x2 F1. */
inline Moment<2> moment_of(const dealii::Tensor<1, 2> &x, const dealii::Tensor<1, 2> &F)
{
  Moment<2> moment;
  moment[0] = x[0] * F[1] - x[1] * F[0];
  return moment;
}
inline Moment<3> moment_of(const dealii::Tensor<1, 3> &x, const dealii::Tensor<1, 3> &F)
{
  return dealii::cross_product_3d(x, F);
}

/** The resultant of surface and body forces: force and moment about the origin. */
template <int dim>
struct Resultant
{
  dealii::Tensor<1, dim> force;
  Moment<dim> moment;

  /** Adds a force that acts at a point. */
  void add(const dealii::Tensor<1, dim> &F, const dealii::Point<dim> &x)
  {
    force += F;
    moment += moment_of(x, F);
  }
  Resultant &operator+=(const Resultant &other)
  {
    force += other.force;
    moment += other.moment;
    return *this;
  }
  /** Returns the moment about another point. */
  Moment<dim> moment_about(const dealii::Point<dim> &x) const
  {
    return moment - moment_of(x, force);
  }
};

/** Returns the sum over all ranks. Collective. */
template <int dim>
Resultant<dim> sum_over_ranks(const Resultant<dim> &part, MPI_Comm communicator)
{
  return {dealii::Utilities::MPI::sum(part.force, communicator),
          dealii::Utilities::MPI::sum(part.moment, communicator)};
}
} // namespace Signorini
