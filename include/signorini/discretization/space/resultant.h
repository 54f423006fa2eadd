// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace Signorini {
/** A moment: a number in 2-D, a vector in 3-D. */
template <int dim>
using Moment = Tensor<1, dim == 2 ? 1 : dim>;

/** Returns the moment x × F; in 2-D x1 F2 - x2 F1. */
inline Moment<2> moment_of(const Tensor<1, 2> &x, const Tensor<1, 2> &F) {
  Moment<2> moment;
  moment[0] = x[0] * F[1] - x[1] * F[0];
  return moment;
}
inline Moment<3> moment_of(const Tensor<1, 3> &x, const Tensor<1, 3> &F) {
  return cross_product_3d(x, F);
}

/** The resultant of surface and body forces: force and moment about the origin. */
template <int dim>
struct Resultant {
  Tensor<1, dim> force;
  Moment<dim> moment;

  /** Adds a force that acts at a point. */
  void add(const Tensor<1, dim> &F, const Point<dim> &x) {
    force += F;
    moment += moment_of(x, F);
  }
  Resultant &operator+=(const Resultant &other) {
    force += other.force;
    moment += other.moment;
    return *this;
  }
  /** Returns the moment about another point. */
  Moment<dim> moment_about(const Point<dim> &x) const {
    return moment - moment_of(x, force);
  }
};

/** Returns the sum over all ranks. Collective. */
template <int dim>
Resultant<dim> sum_over_ranks(const Resultant<dim> &part, MPI_Comm communicator) {
  return {Utilities::MPI::sum(part.force, communicator),
          Utilities::MPI::sum(part.moment, communicator)};
}
} // namespace Signorini
