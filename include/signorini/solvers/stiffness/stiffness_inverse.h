// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/parameters/options.h>

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace Signorini {
/**
 * The stiffness A without its entries, and one step of a solver for it. All is collective.
 *
 * Vectors have an entry for every degree of freedom of V^h in its numbering, in the user's units,
 * and every rank has those of its own ones. The essential conditions are eliminated from A, Tᵀ A T:
 * entries of arguments in constrained rows are not read, those of results are zero.
 */
class StiffnessOperator {
public:
  using Vector = LinearAlgebra::distributed::Vector<double>;

  virtual ~StiffnessOperator() = default;

  /** Returns the zero vector. */
  virtual Vector make_vector() const = 0;
  /** Computes y = A x. */
  virtual void vmult(Vector &y, const Vector &x) const = 0;
  /** Computes z = V r with a fixed V = Vᵀ, positive definite, close to A⁻¹: one V-cycle. */
  virtual void precondition(Vector &z, const Vector &r) const = 0;
};

/**
 * The part of factors that belongs to unknowns eliminated last. Written in blocks, 2 those
 * unknowns,
 *
 *     A = (A_11 A_21ᵀ)   S = A_22 - A_21 A_11⁻¹ A_21ᵀ = L Lᵀ,
 *         (A_21 A_22 ),
 *
 * (A⁻¹)_22 = S⁻¹ follows without a single solve.
 */
struct TrailingFactor {
  using Index = types::global_dof_index;

  /** The lower triangular factor L. */
  LAPACKFullMatrix<double> L;
  /** The row of L that belongs to an unknown. */
  std::map<Index, unsigned int> rows;
};

/** The tolerances of solves. */
struct SolveAccuracy {
  /** The part of the right-hand side above which a residual is refined, up to three times. */
  double refine_above = 1e-12;
  /** The relative change by refinement above which a solution is refused. */
  double refuse_above = 1e-4;
};

/**
 * The inverse A⁻¹, for A = unit × matrix. The solution for a right-hand side does not depend on
 * earlier solves.
 *
 * A new solver derives from this class and implements apply(): by factors, or by iterations, which
 * give their own SolveAccuracy.
 */
class StiffnessInverse {
public:
  using Vector = LinearAlgebra::distributed::Vector<double>;
  using Index = types::global_dof_index;

  virtual ~StiffnessInverse() = default;

  /**
   * Computes x = A⁻¹ b for every pair. The residual of every solve is computed. Where it is not
   * small, up to three steps of iterative refinement are taken, with residuals in extended
   * precision; the size of the first one shows how many digits of x rounding takes. Collective.
   * @throws ComputationError if too few digits are left, see SolveAccuracy.
   */
  void solve(std::vector<Vector> &x, const std::vector<Vector> &b) const;
  /** Computes x = A⁻¹ b for one right-hand side. */
  void solve(Vector &x, const Vector &b) const;
  /** Computes an x close to A⁻¹ b, where rounding of x does no harm: without refinement. */
  void solve_once(Vector &x, const Vector &b) const;
  /** Computes x = matrix⁻¹ b by the factors (or iterations) alone, for every pair. */
  virtual void apply(std::vector<Vector> &x, const std::vector<Vector> &b) const = 0;

  /** Returns the factor of the given unknowns; nothing if they were not eliminated last. */
  virtual std::optional<TrailingFactor>
  trailing_factor(const std::vector<Index> & /*unknowns*/) const {
    return {};
  }

  /** Returns the operator with which solves iterate, of which callers should need few; null where a
   * solve costs no more than the triangles of factors. */
  virtual const StiffnessOperator *cycles() const {
    return nullptr;
  }
  bool has_factors() const {
    return cycles() == nullptr;
  }

  /** Returns a vector of zeros with the distribution of the rows of A. */
  Vector make_vector() const;
  MPI_Comm communicator() const {
    return scaling_.get_mpi_communicator();
  }

  /** Returns the number of right-hand sides that were solved. */
  unsigned int n_solves() const {
    return n_solves_;
  }
  /** Returns the largest |b - A x| / |b| so far, in the norm |r|² = sum r_i² / A_ii. */
  double max_residual() const {
    return max_residual_;
  }
  /** Returns the largest relative error of an x so far that is due to rounding, as far as it was
   * estimated: 0 where residuals were small. */
  double rounding_error() const {
    return rounding_error_;
  }

protected:
  /**
   * Stores the scaling.
   * @param diagonal of the matrix.
   */
  StiffnessInverse(const Vector &diagonal, double unit, const SolveAccuracy &accuracy);

  /**
   * Solves once, without counting, for a b that no kernel is orthogonal to: factors of a singular
   * matrix fail there, but not for loads in its range. Derived classes call it once, unless their
   * pivots show that A is regular.
   * @throws ComputationError if the matrix is singular.
   */
  void refuse_singular_matrix() const;

  double unit() const {
    return unit_;
  }

private:
  /** The residual and the rounding error of one solve. */
  struct Check {
    double residual = 0.;
    double rounding_error = 0.;
  };

  /** Computes r = b - matrix x. With @p accurate, sums are in extended precision where there are
   * any, so that differences of large terms keep their digits. */
  virtual void residual(Vector &r, const Vector &x, const Vector &b, bool accurate) const = 0;

  /**
   * Measures the residual, and refines x where it is not small.
   * @throws ComputationError see solve().
   */
  Check improve(Vector &x, const Vector &b) const;
  /**
   * Adds matrix⁻¹ r to x.
   * @return the size of that correction relative to x.
   */
  double refine(Vector &x, const Vector &r) const;
  /** Returns (sum r_i² / A_ii)^{1/2}: rows of stiff and of soft parts of a body have equal weight.
   */
  double scaled_norm(const Vector &r) const;

  double unit_;
  SolveAccuracy accuracy_;
  /** The diagonal of the matrix to the power -1/2. */
  Vector scaling_;
  // Statistics. They change no result of the functions.
  mutable unsigned int n_solves_ = 0;
  mutable double max_residual_ = 0.;
  mutable double rounding_error_ = 0.;
};

/** The inverse A⁻¹ of an assembled matrix. */
class MatrixInverse : public StiffnessInverse {
protected:
  /**
   * Stores the matrix.
   * @param matrix must outlive the object.
   */
  MatrixInverse(const TrilinosWrappers::SparseMatrix &matrix, double unit);

  void residual(Vector &r, const Vector &x, const Vector &b, bool accurate) const override;

private:
  void accurate_residual(Vector &r, const Vector &x, const Vector &b) const;

  const TrilinosWrappers::SparseMatrix &matrix_;
};

/** Returns the solver that automatic stands for with the given number of ranks: condensed on one,
 * amesos_mumps on several. */
LinearSolver resolve(LinearSolver solver, unsigned int n_ranks);

/**
 * Factorises @p matrix and returns the inverse of unit × matrix. The matrix must outlive the
 * result. condensed is serial only. multigrid has no factors of matrices: here it means automatic.
 * Collective.
 *
 * @param contact_unknowns the unknowns that the contact pressure acts on; the condensed
 * factorisation eliminates them last.
 * @throws ComputationError if the factorisation fails.
 */
std::unique_ptr<StiffnessInverse>
factorise(const TrilinosWrappers::SparseMatrix &matrix, double unit, LinearSolver solver,
          const std::vector<types::global_dof_index> &contact_unknowns = {});
} // namespace Signorini
