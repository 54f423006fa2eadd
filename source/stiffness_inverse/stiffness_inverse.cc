// SPDX-License-Identifier: LGPL-2.1-or-later
// A^{-1} by the sparse direct solvers of Trilinos (Amesos), and the choice of a solver.

#include <signorini/base/exceptions.h>
#include <signorini/base/threads.h>
#include <signorini/stiffness_inverse/condensed_inverse.h>
#include <signorini/stiffness_inverse/library_threads.h>
#include <signorini/stiffness_inverse/stiffness_inverse.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/trilinos_solver.h>

#include <cmath>
#include <sstream>

namespace Signorini
{
namespace
{
/** Residuals above this part of |b| are refined once. */
constexpr double refine_above = 1e-12;
/** Once refinement has changed x by less than this part, so has it for other right-hand sides with
 * residuals like that. */
constexpr double harmless = 1e-9;
/** A solution that refinement changes by more than this part is refused. */
constexpr double refuse_above = 1e-4;

/** A number in [-1, 1) without a pattern that a kernel could be orthogonal to (a hash of i). */
double irregular_number(const dealii::types::global_dof_index i)
{
  const unsigned long long hash = (static_cast<unsigned long long>(i) + 1) * 0x9E3779B97F4A7C15ULL;
  return std::ldexp(static_cast<double>((hash ^ (hash >> 29U)) & 0xFFFFFFFFULL), -31) - 1.;
}

/** KLU (gathers the matrix on one rank) or MUMPS (distributed), through Amesos. */
class AmesosInverse final : public StiffnessInverse
{
public:
  AmesosInverse(const dealii::TrilinosWrappers::SparseMatrix &A, const std::string &type)
    : StiffnessInverse(A)
    , n_threads_(type == "Amesos_Mumps" ? number_of_threads(A.get_mpi_communicator()) : 1)
    , solver_(control_, dealii::TrilinosWrappers::SolverDirect::AdditionalData(false, type))
  {
    const LibraryThreads threads(n_threads_);
    try
    {
      solver_.initialize(A);
    }
    catch (const dealii::ExceptionBase &)
    {
      throw ComputationError("The factorisation of the stiffness matrix by " + type +
                             " failed: the matrix is singular, or memory ran out.");
    }
    refuse_singular_matrix();
  }

private:
  void apply(Vector &x, const Vector &b) const override
  {
    const LibraryThreads threads(n_threads_);
    try
    {
      solver_.solve(x, b);
    }
    catch (const dealii::ExceptionBase &)
    {
      throw ComputationError("A linear solve failed: the stiffness matrix is singular, or memory "
                             "ran out.");
    }
  }

  unsigned int n_threads_;
  mutable dealii::SolverControl control_;
  mutable dealii::TrilinosWrappers::SolverDirect solver_;
};
} // namespace

StiffnessInverse::StiffnessInverse(const dealii::TrilinosWrappers::SparseMatrix &A)
  : A_(A)
  , scaling_(A.locally_owned_range_indices(), A.get_mpi_communicator())
{
  for (const auto i : A.locally_owned_range_indices())
    scaling_(i) = 1. / std::sqrt(A.diag_element(i));
  scaling_.compress(dealii::VectorOperation::insert);
}

double StiffnessInverse::scaled_norm(const Vector &r) const
{
  Vector scaled(r);
  scaled.scale(scaling_);
  return scaled.l2_norm();
}

double StiffnessInverse::refine(Vector &x, const Vector &r) const
{
  Vector correction(r);
  apply(correction, r);
  x += correction;
  const double size = x.l2_norm();
  return size > 0. ? correction.l2_norm() / size : 0.;
}

void StiffnessInverse::solve(Vector &x, const Vector &b) const
{
  ++n_solves_;
  apply(x, b);
  Vector r(b);
  A_.residual(r, x, b);
  const double size = scaled_norm(b);
  double residual = size > 0. ? scaled_norm(r) / size : 0.;
  const bool is_known = residual <= largest_residual_ && rounding_error_ < harmless;
  if (!(residual < refine_above || is_known))
  {
    const double change = refine(x, r);
    rounding_error_ = std::max(rounding_error_, change);
    if (!(change < refuse_above))
    {
      std::ostringstream message;
      message
        << "A linear solve is spoilt by rounding: refinement changes the solution by the part "
        << change
        << ", more than 1e-4; the stiffness matrix is singular or too ill-conditioned "
           "(Poisson's ratio near 1/2, moduli of very different size, a very slender body).";
      throw ComputationError(message.str());
    }
    A_.residual(r, x, b);
    residual = scaled_norm(r) / size;
  }
  largest_residual_ = std::max(largest_residual_, residual);
}

void StiffnessInverse::refuse_singular_matrix() const
{
  Vector b(A_.locally_owned_range_indices(), A_.get_mpi_communicator());
  for (const auto i : A_.locally_owned_range_indices())
    b(i) = irregular_number(i);
  b.compress(dealii::VectorOperation::insert);
  Vector x(b);
  solve(x, b);
  n_solves_ = 0;
  largest_residual_ = 0.;
  rounding_error_ = 0.;
}

LinearSolver resolve(const LinearSolver solver, const unsigned int n_ranks)
{
  if (solver != LinearSolver::automatic)
    return solver;
  return n_ranks == 1 ? LinearSolver::condensed : LinearSolver::amesos_mumps;
}

std::unique_ptr<StiffnessInverse>
factorise(const dealii::TrilinosWrappers::SparseMatrix &A,
          const LinearSolver solver,
          const std::vector<dealii::types::global_dof_index> &contact_unknowns)
{
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(A.get_mpi_communicator());
  switch (resolve(solver, n_ranks))
  {
  case LinearSolver::condensed:
    AssertThrow(n_ranks == 1,
                dealii::ExcMessage("The condensed factorisation works on one rank only."));
    return std::make_unique<CondensedInverse>(A, contact_unknowns);
  case LinearSolver::amesos_klu:
    return std::make_unique<AmesosInverse>(A, "Amesos_Klu");
  default:
    return std::make_unique<AmesosInverse>(A, "Amesos_Mumps");
  }
}
} // namespace Signorini
