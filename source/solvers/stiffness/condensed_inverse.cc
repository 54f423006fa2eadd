// SPDX-License-Identifier: LGPL-2.1-or-later
// A = L Lᵀ by CHOLMOD, chosen unknowns last.

#include <signorini/base/errors.h>
#include <signorini/solvers/stiffness/condensed_inverse.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cholmod.h>
#include <cmath>
#include <new>

namespace Signorini {
namespace {
/** The part of the largest pivot below which a pivot is doubtful: a solve has to show whether it
 * can be used. */
constexpr double doubtful_pivot = 1e-9;

/** The workspace of CHOLMOD, with its error states. */
struct Workspace {
  Workspace() {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
  }
  ~Workspace() {
    cholmod_finish(&common);
  }
  Workspace(const Workspace &) = delete;
  Workspace &operator=(const Workspace &) = delete;

  /**
   * Checks the state.
   * @throws after a failed call.
   */
  void check() const {
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
      throw std::bad_alloc();
    if (common.status == CHOLMOD_TOO_LARGE)
      throw ComputationError("The factor of the stiffness matrix has more than 2^31 entries, the "
                             "limit of CHOLMOD; Solver/Linear solver = amesos_mumps has none.");
    if (common.status == CHOLMOD_NOT_POSDEF)
      throw ComputationError("The factorisation of the stiffness matrix by CHOLMOD failed: the "
                             "matrix is singular or not positive definite.");
    if (common.status < CHOLMOD_OK)
      throw ComputationError("The factorisation of the stiffness matrix by CHOLMOD failed.");
  }

  cholmod_common common = {};
};

/** Returns a symmetric matrix by its rows, of which CHOLMOD reads the upper triangle: the entries
 * of A below the diagonal are not read. Without @p values it is a pattern. */
cholmod_sparse view_of(const int n, int *const start, int *const column, double *const value) {
  cholmod_sparse matrix = {};
  matrix.nrow = matrix.ncol = n;
  matrix.nzmax = start[n];
  matrix.p = start;
  matrix.i = column;
  matrix.x = value;
  matrix.stype = matrix.sorted = matrix.packed = 1;
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = value == nullptr ? CHOLMOD_PATTERN : CHOLMOD_REAL;
  matrix.dtype = CHOLMOD_DOUBLE;
  return matrix;
}

/** The number of couplings per node above which a graph is that of a 3-D body, where a node of a
 * brick has 26 neighbours: nested dissection (METIS) there needs a third of the operations of
 * minimum degree. In 2-D, where a node has 8 neighbours, it costs more than it saves. */
constexpr double couplings_in_3d = 20.;

/** Returns an ordering of A with little fill: approximate minimum degree, in 3-D METIS. Unknowns
 * that follow each other with the same couplings (those of one node) are ordered as one: this takes
 * a quarter of the time, and the factor gets smaller. */
std::vector<int> fill_reducing_order(Workspace &workspace, const Rows &A) {
  std::vector<int> first = {0}, node(A.n, 0), start = {0}, neighbour;
  for (int i = 1; i < A.n; ++i) {
    if (A.start[i + 1] - A.start[i] == 1 || !A.same_pattern(i - 1, i))
      first.push_back(i);
    node[i] = static_cast<int>(first.size()) - 1;
  }
  const int n_nodes = static_cast<int>(first.size());
  first.push_back(A.n);
  for (int j = 0; j < n_nodes; ++j) {
    for (int entry = A.start[first[j]]; entry < A.start[first[j] + 1]; ++entry)
      if (node[A.column[entry]] <= j)
        neighbour.push_back(node[A.column[entry]]);
    const auto begin = neighbour.begin() + start.back();
    std::sort(begin, neighbour.end());
    neighbour.erase(std::unique(begin, neighbour.end()), neighbour.end());
    start.push_back(static_cast<int>(neighbour.size()));
  }
  cholmod_sparse graph = view_of(n_nodes, start.data(), neighbour.data(), nullptr);
  std::vector<int> order_of_nodes(n_nodes), order;
  // The graph counts the upper triangle.
  if (2. * static_cast<double>(neighbour.size()) > couplings_in_3d * n_nodes)
    cholmod_metis(&graph, nullptr, 0, 1, order_of_nodes.data(), &workspace.common);
  else
    cholmod_amd(&graph, nullptr, 0, order_of_nodes.data(), &workspace.common);
  workspace.check();
  order.reserve(A.n);
  for (const int j : order_of_nodes)
    for (int i = first[j]; i < first[j + 1]; ++i)
      order.push_back(i);
  return order;
}
} // namespace

Rows::Rows(const TrilinosWrappers::SparseMatrix &A)
  : n(A.trilinos_matrix().NumMyRows()) {
  // With all rows on this rank the columns are numbered like the rows.
  Assert(A.trilinos_matrix().ColMap().SameAs(A.trilinos_matrix().RowMap()), ExcInternalError());
  const int error = A.trilinos_matrix().ExtractCrsDataPointers(start, column, value);
  AssertThrow(error == 0, ExcTrilinosError(error));
}

/** The factor L with the workspace it lives in. */
class CholeskyFactor {
public:
  CholeskyFactor(const Rows &A, const std::vector<types::global_dof_index> &last)
    : n_(A.n)
    , n_last_(static_cast<int>(last.size())) {
    std::vector<bool> chosen(n_, false);
    for (const auto i : last)
      chosen[i] = true;
    cholmod_sparse matrix = view_of(A.n, A.start, A.column, A.value);
    analyse(A, matrix, chosen);
    factorise(A);
  }
  ~CholeskyFactor() {
    for (cholmod_dense **const dense : {&x_, &y_, &e_})
      cholmod_free_dense(dense, &workspace_.common);
    cholmod_free_factor(&L_, &workspace_.common);
  }
  CholeskyFactor(const CholeskyFactor &) = delete;
  CholeskyFactor &operator=(const CholeskyFactor &) = delete;

  /** Calls @p visit(i, j, L_ij) for every i ≥ j of the columns from @p first_column on. */
  template <typename Visitor>
  void for_each_entry(const int first_column, const Visitor &visit) const {
    const int *const super = static_cast<int *>(L_->super);
    const int *const row_start = static_cast<int *>(L_->pi);
    const int *const value_start = static_cast<int *>(L_->px);
    const int *const rows = static_cast<int *>(L_->s);
    const double *const values = static_cast<double *>(L_->x);
    const auto n_supernodes = static_cast<int>(L_->nsuper);
    int s = std::upper_bound(super, super + n_supernodes, first_column) - super - 1;
    for (s = std::max(s, 0); s < n_supernodes; ++s) {
      const int n_rows = row_start[s + 1] - row_start[s];
      for (int j = std::max(super[s], first_column); j < super[s + 1]; ++j) {
        const int c = j - super[s];
        for (int r = c; r < n_rows; ++r)
          visit(rows[row_start[s] + r], j, values[value_start[s] + c * n_rows + r]);
      }
    }
  }

  /** Returns the unknowns in the order of their elimination. */
  const int *order() const {
    return static_cast<int *>(L_->Perm);
  }
  int first_of_last() const {
    return n_ - n_last_;
  }

  /** Returns the smallest pivot over the largest one. */
  double min_pivot() {
    return cholmod_rcond(L_, &workspace_.common);
  }

  /** Computes X = A⁻¹ X for the right-hand sides, one column after another. */
  void solve(std::vector<double> &X) {
    cholmod_dense right_hand_sides = {};
    right_hand_sides.nrow = right_hand_sides.d = n_;
    right_hand_sides.ncol = X.size() / n_;
    right_hand_sides.nzmax = X.size();
    right_hand_sides.x = X.data();
    right_hand_sides.xtype = CHOLMOD_REAL;
    right_hand_sides.dtype = CHOLMOD_DOUBLE;
    cholmod_solve2(CHOLMOD_A, L_, &right_hand_sides, nullptr, &x_, nullptr, &y_, &e_,
                   &workspace_.common);
    workspace_.check();
    std::copy_n(static_cast<double *>(x_->x), X.size(), X.begin());
  }

private:
  /** Analyses the pattern. Postordering makes supernodes large; it keeps the chosen unknowns last
   * wherever the others are connected. Elsewhere they are moved once more, behind the trees that
   * came after them. */
  void analyse(const Rows &A, cholmod_sparse &matrix, const std::vector<bool> &chosen) {
    std::vector<int> given = fill_reducing_order(workspace_, A);
    for (const bool postorder : {true, false}) {
      std::stable_partition(given.begin(), given.end(), [&](const int i) { return !chosen[i]; });
      workspace_.common.postorder = postorder ? 1 : 0;
      cholmod_free_factor(&L_, &workspace_.common);
      L_ = cholmod_analyze_p(&matrix, given.data(), nullptr, 0, &workspace_.common);
      workspace_.check();
      if (std::all_of(order() + first_of_last(), order() + n_, [&](int i) { return chosen[i]; }))
        return;
      given.assign(order(), order() + n_);
    }
  }

  /** Factorises A in the order of the analysis. Both triangles are stored, so that a column of the
   * permuted matrix is one pass over a row of A. From one triangle CHOLMOD would permute A itself,
   * which takes nearly as long as the numeric factorisation. */
  void factorise(const Rows &A) {
    std::vector<int> position(n_), start = {0}, row;
    std::vector<double> value;
    for (int j = 0; j < n_; ++j)
      position[order()[j]] = j;
    row.reserve((A.start[n_] + n_) / 2);
    value.reserve(row.capacity());
    for (int j = 0; j < n_; ++j) {
      const int old = order()[j];
      for (int entry = A.start[old]; entry < A.start[old + 1]; ++entry)
        if (const int i = position[A.column[entry]]; i >= j) {
          row.push_back(i);
          value.push_back(A.value[entry]);
        }
      start.push_back(static_cast<int>(row.size()));
    }
    cholmod_sparse lower = view_of(n_, start.data(), row.data(), value.data());
    lower.stype = -1;
    lower.sorted = 0;
    double no_shift[] = {0., 0.};
    cholmod_super_numeric(&lower, nullptr, no_shift, L_, &workspace_.common);
    workspace_.check();
  }

  Workspace workspace_;
  int n_;
  int n_last_;
  cholmod_factor *L_ = nullptr;
  cholmod_dense *x_ = nullptr;
  cholmod_dense *y_ = nullptr;
  cholmod_dense *e_ = nullptr;
};

SparseCholesky::SparseCholesky(const Rows &A)
  : factor_(std::make_unique<CholeskyFactor>(A, std::vector<types::global_dof_index>())) {}

SparseCholesky::~SparseCholesky() = default;

void SparseCholesky::solve(std::vector<double> &x) const {
  factor_->solve(x);
}

CondensedInverse::CondensedInverse(const TrilinosWrappers::SparseMatrix &matrix, const double unit,
                                   const std::vector<Index> &last)
  : MatrixInverse(matrix, unit)
  , factor_(std::make_unique<CholeskyFactor>(Rows(matrix), last)) {
  const int first = factor_->first_of_last();
  for (unsigned int row = 0; row < last.size(); ++row)
    rows_[factor_->order()[first + row]] = row;
  // A singular matrix has a pivot of the size of rounding.
  if (!(factor_->min_pivot() > doubtful_pivot))
    refuse_singular_matrix();
}

CondensedInverse::~CondensedInverse() = default;

std::optional<TrailingFactor>
CondensedInverse::trailing_factor(const std::vector<Index> &unknowns) const {
  if (!std::all_of(unknowns.begin(), unknowns.end(),
                   [&](const Index i) { return rows_.count(i) == 1; }))
    return {};
  const int first = factor_->first_of_last();
  const auto n = static_cast<unsigned int>(rows_.size());
  TrailingFactor trailing = {LAPACKFullMatrix<double>(n, n), rows_};
  const double root = std::sqrt(unit());
  factor_->for_each_entry(first, [&](const int i, const int j, const double L_ij) {
    trailing.L(i - first, j - first) = root * L_ij;
  });
  return trailing;
}

void CondensedInverse::apply(std::vector<Vector> &x, const std::vector<Vector> &b) const {
  if (b.empty())
    return;
  std::vector<double> X;
  X.reserve(b.size() * b[0].size());
  for (const Vector &right_hand_side : b)
    X.insert(X.end(), right_hand_side.begin(), right_hand_side.end());
  factor_->solve(X);
  auto begin = X.cbegin();
  for (Vector &solution : x) {
    std::copy(begin, begin + solution.size(), solution.begin());
    begin += static_cast<std::ptrdiff_t>(solution.size());
  }
}
} // namespace Signorini
