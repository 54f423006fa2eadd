// SPDX-License-Identifier: LGPL-2.1-or-later
// A⁻¹ by the sparse direct solvers of Trilinos (Amesos), and the choice of a solver.

#include <signorini/base/errors.h>
#include <signorini/base/parallel.h>
#include <signorini/solvers/stiffness/condensed_inverse.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Amesos.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_Vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <set>
#include <sstream>

namespace Signorini {
namespace {
/** Returns a number in [-1, 1) without a pattern that a kernel could be orthogonal to (a hash of
 * i). */
double irregular_number(const types::global_dof_index i) {
  const unsigned long long hash = (static_cast<unsigned long long>(i) + 1) * 0x9E3779B97F4A7C15ULL;
  return std::ldexp(static_cast<double>((hash ^ (hash >> 29U)) & 0xFFFFFFFFULL), -31) - 1.;
}

/**
 * Calls work(), which runs MUMPS or KLU, and keeps their output: the user reads one sentence
 * instead.
 * @throws ComputationError that begins with @p failure. The code of MUMPS stands in the output as
 * "INFOG(1) = -13", negative; those of a lack of memory are those of section "Error diagnostics" of
 * the users' guide of MUMPS.
 */
template <typename Work>
void call_solver(const std::string &failure, const Work &work) {
  static const std::set<int> out_of_memory = {-5,  -7,  -8,  -9,  -11, -13, -14,
                                              -15, -17, -18, -19, -20, -23, -25};
  std::ostringstream printed;
  struct Screen {
    std::streambuf *buffer;
    ~Screen() {
      std::cerr.rdbuf(buffer);
    }
  };
  const Screen screen = {std::cerr.rdbuf(printed.rdbuf())};
  try {
    work();
  } catch (const ExceptionBase &) {
    const std::string text = printed.str(), key = "INFOG(1) = ";
    const auto found = text.find(key);
    const int code = found == std::string::npos ? 0 : std::atoi(&text[found + key.size()]);
    std::string cause = "the matrix is singular, or out of memory";
    if (out_of_memory.count(code) > 0)
      cause = "out of memory";
    else if (code == -10 || code == -6)
      cause = "the matrix is singular";
    else if (code != 0)
      cause = "MUMPS ended";
    throw ComputationError(failure + ": " + cause +
                           (code == 0 ? "." : " (MUMPS, code " + std::to_string(code) + ")."));
  }
}

StiffnessInverse::Vector diagonal_of(const TrilinosWrappers::SparseMatrix &matrix) {
  StiffnessInverse::Vector diagonal(matrix.locally_owned_range_indices(),
                                    matrix.get_mpi_communicator());
  for (const auto i : matrix.locally_owned_range_indices())
    diagonal(i) = matrix.diag_element(i);
  return diagonal;
}

/** The inverse by KLU (gathers the matrix on one rank) or MUMPS (distributed), through Amesos.
 * KLU solves a block of right-hand sides in half the time; deal.II's class takes only one. */
class AmesosInverse final : public MatrixInverse {
public:
  AmesosInverse(const TrilinosWrappers::SparseMatrix &matrix, const double unit,
                const char *const type, const unsigned int n_threads)
    : MatrixInverse(matrix, unit)
    , matrix_(matrix.trilinos_matrix())
    , n_threads_(n_threads) {
    problem_.SetOperator(const_cast<Epetra_CrsMatrix *>(&matrix_));
    solver_.reset(Amesos().Create(type, problem_));
    const LibraryThreads threads(n_threads_);
    call_solver("The factorisation of the stiffness matrix by " + std::string(type) + " failed",
                [&]() {
                  succeed(solver_->SymbolicFactorization());
                  succeed(solver_->NumericFactorization());
                });
    refuse_singular_matrix();
  }

private:
  static void succeed(const int error) {
    AssertThrow(error == 0, ExcTrilinosError(error));
  }

  void apply(std::vector<Vector> &x, const std::vector<Vector> &b) const override {
    const auto n = static_cast<int>(x.size());
    if (n == 0)
      return;
    Epetra_MultiVector X(matrix_.DomainMap(), n), B(matrix_.RangeMap(), n);
    for (int k = 0; k < n; ++k)
      std::copy(b[k].begin(), b[k].end(), B[k]);
    problem_.SetLHS(&X);
    problem_.SetRHS(&B);
    const LibraryThreads threads(n_threads_);
    call_solver("A linear solve failed", [&]() { succeed(solver_->Solve()); });
    for (int k = 0; k < n; ++k)
      std::copy_n(X[k], x[k].locally_owned_size(), x[k].begin());
  }

  const Epetra_CrsMatrix &matrix_;
  unsigned int n_threads_;
  mutable Epetra_LinearProblem problem_;
  std::unique_ptr<Amesos_BaseSolver> solver_;
};
} // namespace

StiffnessInverse::StiffnessInverse(const Vector &diagonal, const double unit,
                                   const SolveAccuracy &accuracy)
  : unit_(unit)
  , accuracy_(accuracy)
  , scaling_(diagonal) {
  for (const auto i : diagonal.locally_owned_elements())
    scaling_(i) = 1. / std::sqrt(diagonal(i));
}

StiffnessInverse::Vector StiffnessInverse::make_vector() const {
  return Vector(scaling_.locally_owned_elements(), communicator());
}

double StiffnessInverse::scaled_norm(const Vector &r) const {
  Vector scaled(r);
  scaled.scale(scaling_);
  return scaled.l2_norm();
}

double StiffnessInverse::refine(Vector &x, const Vector &r) const {
  std::vector<Vector> correction = {r};
  apply(correction, {r});
  x += correction[0];
  const double size = x.l2_norm();
  return size > 0. ? correction[0].l2_norm() / size : 0.;
}

MatrixInverse::MatrixInverse(const TrilinosWrappers::SparseMatrix &matrix, const double unit)
  : StiffnessInverse(diagonal_of(matrix), unit, SolveAccuracy())
  , matrix_(matrix) {}

namespace {
/** Returns the owned entries of a vector as Trilinos reads them. (Programs of clang++ do not find
 * the products of deal.II's wrapper with vectors other than its own.) */
Epetra_Vector view_of(const StiffnessInverse::Vector &x, const Epetra_CrsMatrix &A) {
  return Epetra_Vector(View, A.DomainMap(), const_cast<double *>(x.begin()));
}
} // namespace

void MatrixInverse::residual(Vector &r, const Vector &x, const Vector &b,
                             const bool accurate) const {
  if (accurate) {
    accurate_residual(r, x, b);
  } else {
    const Epetra_CrsMatrix &A = matrix_.trilinos_matrix();
    Epetra_Vector product = view_of(r, A);
    const int error = A.Multiply(false, view_of(x, A), product);
    AssertThrow(error == 0, ExcTrilinosError(error));
    r.sadd(-1., 1., b);
  }
}

void MatrixInverse::accurate_residual(Vector &r, const Vector &x, const Vector &b) const {
  const Epetra_CrsMatrix &A = matrix_.trilinos_matrix();
  // The entries of x that the rows of this rank need.
  Epetra_Vector columns(A.ColMap());
  if (A.Importer() != nullptr)
    columns.Import(view_of(x, A), *A.Importer(), Insert);
  else
    columns.Update(1., view_of(x, A), 0.);
  const double *const x_values = columns.Values();
  const double *const right_hand_side = b.begin();
  double *const result = r.begin();
  for (int row = 0; row < A.NumMyRows(); ++row) {
    int n_entries = 0;
    double *values = nullptr;
    int *indices = nullptr;
    A.ExtractMyRowView(row, n_entries, values, indices);
    // Several sums: an addition need not wait for the one before.
    std::array<long double, 4> sums = {{right_hand_side[row]}};
    int i = 0;
    for (; i + 4 <= n_entries; i += 4)
      for (int k = 0; k < 4; ++k)
        sums[k] -= static_cast<long double>(values[i + k]) * x_values[indices[i + k]];
    for (; i < n_entries; ++i)
      sums[0] -= static_cast<long double>(values[i]) * x_values[indices[i]];
    result[row] = static_cast<double>((sums[0] + sums[1]) + (sums[2] + sums[3]));
  }
}

StiffnessInverse::Check StiffnessInverse::improve(Vector &x, const Vector &b) const {
  Vector r(b);
  residual(r, x, b, false);
  const double size = scaled_norm(b);
  Check check;
  check.residual = size > 0. ? scaled_norm(r) / size : 0.;
  if (check.residual < accuracy_.refine_above)
    return check;
  residual(r, x, b, true);
  check.rounding_error = refine(x, r);
  if (!(check.rounding_error < accuracy_.refuse_above)) {
    std::ostringstream message;
    message
      << "Rounding errors are too large in a linear solve: one step of refinement changes the "
         "solution by the relative amount "
      << check.rounding_error << ", allowed: " << accuracy_.refuse_above
      << "; the stiffness matrix is singular or too ill-conditioned (Poisson's ratio near "
         "1/2, moduli of very different size, a very slender body).";
    throw ComputationError(message.str());
  }
  // The first step shows the effect of rounding, also of that in the entries of the matrix. Further
  // ones make answers to different right-hand sides agree with each other.
  double change = check.rounding_error;
  for (unsigned int step = 0; step < 2 && change > 1e-13; ++step) {
    residual(r, x, b, true);
    change = refine(x, r);
  }
  residual(r, x, b, false);
  check.residual = scaled_norm(r) / size;
  return check;
}

void StiffnessInverse::solve(std::vector<Vector> &x, const std::vector<Vector> &b) const {
  apply(x, b);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Check check = improve(x[k], b[k]);
    x[k] /= unit_;
    ++n_solves_;
    max_residual_ = std::max(max_residual_, check.residual);
    rounding_error_ = std::max(rounding_error_, check.rounding_error);
  }
}

void StiffnessInverse::solve(Vector &x, const Vector &b) const {
  std::vector<Vector> several = {x};
  solve(several, {b});
  x = several[0];
}

void StiffnessInverse::solve_once(Vector &x, const Vector &b) const {
  std::vector<Vector> several = {x};
  apply(several, {b});
  x.equ(1. / unit_, several[0]);
}

void StiffnessInverse::refuse_singular_matrix() const {
  Vector b = make_vector();
  for (const auto i : b.locally_owned_elements())
    b(i) = irregular_number(i);
  std::vector<Vector> x = {b};
  apply(x, {b});
  improve(x[0], b);
}

LinearSolver resolve(const LinearSolver solver, const unsigned int n_ranks) {
  if (solver != LinearSolver::automatic)
    return solver;
  return n_ranks == 1 ? LinearSolver::condensed : LinearSolver::amesos_mumps;
}

std::unique_ptr<StiffnessInverse>
factorise(const TrilinosWrappers::SparseMatrix &matrix, const double unit,
          const LinearSolver solver, const std::vector<types::global_dof_index> &contact_unknowns) {
  MPI_Comm communicator = matrix.get_mpi_communicator();
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
  switch (resolve(solver == LinearSolver::multigrid ? LinearSolver::automatic : solver, n_ranks)) {
  case LinearSolver::condensed:
    AssertThrow(n_ranks == 1, ExcMessage("The condensed factorisation works on one rank only."));
    return std::make_unique<CondensedInverse>(matrix, unit, contact_unknowns);
  case LinearSolver::amesos_klu:
    return std::make_unique<AmesosInverse>(matrix, unit, "Amesos_Klu", 1);
  default:
    return std::make_unique<AmesosInverse>(matrix, unit, "Amesos_Mumps", n_available_threads());
  }
}
} // namespace Signorini
