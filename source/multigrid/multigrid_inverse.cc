// SPDX-License-Identifier: LGPL-2.1-or-later
// Conjugate gradients with V-cycles.

#include <signorini/base/exceptions.h>
#include <signorini/multigrid/multigrid_inverse.h>
#include <signorini/multigrid/stiffness_multigrid.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace Signorini
{
namespace
{
constexpr unsigned int most_cycles = 500;
/** Rounding of products with A, relative to a smooth load: 1e-16 / h^2. */
constexpr double refine_solves_above = 1e-8;
/** Solves to a goal above this are not refined. */
constexpr double loose_goal = 1e-10;
constexpr double refuse_solves_above = 1e-4;

NodalVector to_nodal(const StiffnessInverse::Vector &from)
{
  const double *const values = from.trilinos_vector()[0];
  return NodalVector(values, values + from.size());
}

void copy_to(StiffnessInverse::Vector &to, const NodalVector &from)
{
  std::copy(from.begin(), from.end(), to.trilinos_vector()[0]);
}

[[noreturn]] void refuse_to_go_on(const double reduction)
{
  std::ostringstream message;
  message << "Multigrid reduced the residual of a linear system only to " << std::sqrt(reduction)
          << " of what it was, in at most " << most_cycles
          << " V-cycles; Solver/Linear solver = condensed factorises instead.";
  throw ComputationError(message.str());
}
} // namespace

MultigridInverse::MultigridInverse(std::shared_ptr<const StiffnessOperator> A,
                                   const Vector &diagonal,
                                   const double goal)
  : StiffnessInverse(diagonal,
                     1.,
                     SolveAccuracy{goal > loose_goal ? std::numeric_limits<double>::infinity()
                                                     : refine_solves_above,
                                   refuse_solves_above})
  , A_(std::move(A))
  , goal_(goal)
{
}

void MultigridInverse::residual(Vector &r,
                                const Vector &x,
                                const Vector &b,
                                const bool /*accurate*/) const
{
  NodalVector product(A_->size());
  A_->apply(product, to_nodal(x));
  product.sadd(-1., 1., to_nodal(b));
  copy_to(r, product);
}

void MultigridInverse::apply(std::vector<Vector> &x, const std::vector<Vector> &b) const
{
  for (std::size_t k = 0; k < x.size(); ++k)
    solve_one(x[k], b[k]);
}

void MultigridInverse::solve_one(Vector &x, const Vector &b) const
{
  NodalVector r = to_nodal(b), z(r.size()), q(r.size()), u(r.size());
  A_->precondition(z, r);
  NodalVector p = z;
  double rz = r * z;
  const double start = rz, goal = goal_ * goal_ * start;
  unsigned int n_cycles = 1;
  for (; rz > goal; ++n_cycles)
  {
    A_->apply(q, p);
    const double curvature = p * q;
    if (n_cycles >= most_cycles || !(curvature > 0.))
      refuse_to_go_on(rz / start);
    const double alpha = rz / curvature;
    u.add(alpha, p);
    r.add(-alpha, q);
    A_->precondition(z, r);
    const double before = rz;
    rz = r * z;
    p.sadd(rz / before, 1., z);
  }
  if (!(rz >= 0.))
    refuse_to_go_on(-rz / start);
  copy_to(x, u);
  largest_number_of_cycles_ = std::max(largest_number_of_cycles_, n_cycles);
}

template <int dim>
std::unique_ptr<MultigridInverse> make_multigrid_inverse(const DisplacementSpace<dim> &space,
                                                         const Scene<dim> &scene,
                                                         const double goal)
{
  const auto A = std::make_shared<const StiffnessMultigrid<dim>>(space, scene);
  DistributedVector diagonal = space.make_vector();
  copy_to(diagonal, A->diagonal());
  return std::make_unique<MultigridInverse>(A, diagonal, goal);
}

template std::unique_ptr<MultigridInverse> make_multigrid_inverse(const DisplacementSpace<2> &,
                                                                  const Scene<2> &,
                                                                  double);
template std::unique_ptr<MultigridInverse> make_multigrid_inverse(const DisplacementSpace<3> &,
                                                                  const Scene<3> &,
                                                                  double);
} // namespace Signorini
