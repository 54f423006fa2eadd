// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/options.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace Signorini
{
/**
 * A without its entries, and one step of a solver for it. On one rank.
 *
 * Vectors have an entry for every degree of freedom of V^h in its numbering, in the user's units.
 * A is the stiffness after the essential conditions are eliminated, T^T A T: entries of arguments
 * in constrained rows are not read, those of results are zero.
 */
class StiffnessOperator
{
public:
  using Vector = dealii::Vector<double>;

  virtual ~StiffnessOperator() = default;

  /** The number of degrees of freedom. */
  virtual unsigned int size() const = 0;
  /** y = A x. */
  virtual void apply(Vector &y, const Vector &x) const = 0;
  /** z = V r with a fixed V = V^T, positive definite, close to A^{-1}: one V-cycle. */
  virtual void precondition(Vector &z, const Vector &r) const = 0;
};

/**
 * What factors know about unknowns that were eliminated last. Written in blocks, 2 those unknowns,
 *
 *     A = (A_11 A_21^T)   S = A_22 - A_21 A_11^{-1} A_21^T = L L^T,
 *         (A_21 A_22  ),
 *
 * and (A^{-1})_22 = S^{-1} is known without a single solve.
 */
struct TrailingFactor
{
  using Index = dealii::types::global_dof_index;

  /** Lower triangular. */
  dealii::LAPACKFullMatrix<double> L;
  /** The row of L that belongs to an unknown. */
  std::map<Index, unsigned int> rows;
};

/** How accurate solves are. */
struct SolveAccuracy
{
  /** A residual above this part of the right-hand side is refined, up to three times. */
  double refine_above = 1e-12;
  /** A solution that refinement changes by more than this part is refused. */
  double refuse_above = 1e-4;
};

/**
 * A^{-1}, for A = unit × matrix. The answer to a right-hand side depends on nothing that was solved
 * before.
 *
 * A new solver derives from this class and says how apply() works: by factors, or by iterations,
 * which give their own SolveAccuracy.
 */
class StiffnessInverse
{
public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;
  using Index = dealii::types::global_dof_index;

  virtual ~StiffnessInverse() = default;

  /**
   * x = A^{-1} b for every pair. The residual of every solve is computed. Where it is not small,
   * up to three steps of iterative refinement are taken, with residuals in extended precision; the
   * size of the first one tells how many digits of x rounding takes. Collective.
   * @throws ComputationError if too few digits are left, see SolveAccuracy.
   */
  void solve(std::vector<Vector> &x, const std::vector<Vector> &b) const;
  /** The same for one right-hand side. */
  void solve(Vector &x, const Vector &b) const;

  /** What the factors know about the given unknowns; nothing if they were not eliminated last. */
  virtual std::optional<TrailingFactor>
  trailing_factor(const std::vector<Index> & /*unknowns*/) const
  {
    return {};
  }

  /** Whether a solve costs no more than its triangles; otherwise it iterates, and who can do with
   * few solves should. */
  virtual bool has_factors() const
  {
    return true;
  }

  /** A vector of zeros with the distribution of the rows of A. */
  Vector make_vector() const;
  MPI_Comm communicator() const
  {
    return scaling_.get_mpi_communicator();
  }

  /** How many right-hand sides were solved. */
  unsigned int n_solves() const
  {
    return n_solves_;
  }
  /** The largest |b - A x| / |b| so far, in the norm |r|^2 = sum r_i^2 / A_ii. */
  double largest_residual() const
  {
    return largest_residual_;
  }
  /** The largest relative error of an x so far that is due to rounding, as far as it was estimated:
   * 0 where residuals were small. */
  double rounding_error() const
  {
    return rounding_error_;
  }

protected:
  /** @param diagonal of the matrix. */
  StiffnessInverse(const Vector &diagonal, double unit, const SolveAccuracy &accuracy);

  /**
   * One solve, not counted, for a b that no kernel is orthogonal to: factors of a singular matrix
   * betray themselves there, but not for loads in its range. Derived classes call it once, unless
   * their pivots show that A is regular.
   * @throws ComputationError
   */
  void refuse_singular_matrix() const;

  double unit() const
  {
    return unit_;
  }

private:
  /** What one solve has shown. */
  struct Check
  {
    double residual = 0.;
    double rounding_error = 0.;
  };

  /** x = matrix^{-1} b by the factors (or iterations) alone, for every pair. */
  virtual void apply(std::vector<Vector> &x, const std::vector<Vector> &b) const = 0;
  /** r = b - matrix x; @p accurate: with sums in extended precision where there are any, so that
   * differences of large terms keep their digits. */
  virtual void residual(Vector &r, const Vector &x, const Vector &b, bool accurate) const = 0;

  /** Measures the residual, and refines x where it is not small. @throws ComputationError */
  Check improve(Vector &x, const Vector &b) const;
  /** Adds matrix^{-1} r to x. @return the size of that correction relative to x. */
  double refine(Vector &x, const Vector &r) const;
  /** (sum r_i^2 / A_ii)^{1/2}: rows of stiff and of soft parts of a body count alike. */
  double scaled_norm(const Vector &r) const;

  double unit_;
  SolveAccuracy accuracy_;
  /** The diagonal of the matrix to the power -1/2. */
  Vector scaling_;
  // Reports; no answer depends on them.
  mutable unsigned int n_solves_ = 0;
  mutable double largest_residual_ = 0.;
  mutable double rounding_error_ = 0.;
};

/** A^{-1} of an assembled matrix. */
class MatrixInverse : public StiffnessInverse
{
protected:
  /** @param matrix must outlive the object. */
  MatrixInverse(const dealii::TrilinosWrappers::SparseMatrix &matrix, double unit);

private:
  void residual(Vector &r, const Vector &x, const Vector &b, bool accurate) const override;
  void accurate_residual(Vector &r, const Vector &x, const Vector &b) const;

  const dealii::TrilinosWrappers::SparseMatrix &matrix_;
};

/** What automatic stands for on so many ranks: condensed on one, amesos_mumps on several. */
LinearSolver resolve(LinearSolver solver, unsigned int n_ranks);

/**
 * Factorises @p matrix, which must outlive the result, the inverse of unit × matrix. condensed
 * works on one rank only. multigrid has no factors of matrices: it stands for automatic here.
 *
 * @param contact_unknowns those that the contact pressure acts on; the condensed factorisation
 *   eliminates them last. Collective.
 * @throws ComputationError if the factorisation fails.
 */
std::unique_ptr<StiffnessInverse>
factorise(const dealii::TrilinosWrappers::SparseMatrix &matrix,
          double unit,
          LinearSolver solver,
          const std::vector<dealii::types::global_dof_index> &contact_unknowns = {});
} // namespace Signorini
