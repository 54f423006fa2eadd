// SPDX-License-Identifier: LGPL-2.1-or-later
// A = L Lᵀ by CHOLMOD, the insides of cells first, chosen unknowns last.

#include <signorini/base/errors.h>
#include <signorini/solvers/stiffness/condensed_inverse.h>

#include <algorithm>
#include <cholmod.h>
#include <cmath>
#include <new>

#include "cell_interiors.h"

namespace Signorini {
namespace {
/** CHOLMOD's long integers, which allow factors of more than 2^31 entries. */
using Long = SuiteSparse_long;

/** The part of the largest pivot below which a pivot is doubtful: a solve has to show whether it
 * can be used. */
constexpr double doubtful_pivot = 1e-9;

/** The workspace of CHOLMOD, with its error states. */
struct Workspace {
  Workspace() {
    cholmod_l_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
  }
  ~Workspace() {
    cholmod_l_finish(&common);
  }
  Workspace(const Workspace &) = delete;
  Workspace &operator=(const Workspace &) = delete;

  /**
   * Checks the state.
   * @throws after a failed call.
   */
  void check() const {
    if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE)
      throw std::bad_alloc();
    if (common.status == CHOLMOD_NOT_POSDEF)
      throw ComputationError("The factorisation of the stiffness matrix by CHOLMOD failed: the "
                             "matrix is singular or not positive definite.");
    if (common.status < CHOLMOD_OK)
      throw ComputationError("The factorisation of the stiffness matrix by CHOLMOD failed.");
  }

  cholmod_common common = {};
};

/** A sparse symmetric matrix, or its pattern: the upper triangle by columns. */
struct UpperTriangle {
  /** Returns the arrays as CHOLMOD reads them. */
  cholmod_sparse view() {
    cholmod_sparse matrix = {};
    matrix.nrow = matrix.ncol = start.size() - 1;
    matrix.nzmax = row.size();
    matrix.p = start.data();
    matrix.i = row.data();
    matrix.x = value.data();
    matrix.stype = matrix.sorted = matrix.packed = 1;
    matrix.itype = CHOLMOD_LONG;
    matrix.xtype = value.empty() ? CHOLMOD_PATTERN : CHOLMOD_REAL;
    matrix.dtype = CHOLMOD_DOUBLE;
    return matrix;
  }

  std::vector<Long> start = {0}, row;
  std::vector<double> value;
};

/** Copies A without the zeros that the sparsity pattern holds. */
UpperTriangle upper_triangle(const Rows &A) {
  UpperTriangle matrix;
  for (int j = 0; j < A.n; ++j) {
    for (int entry = A.start[j]; entry < A.start[j + 1]; ++entry)
      if (A.column[entry] == j || (A.column[entry] < j && A.value[entry] != 0.)) {
        matrix.row.push_back(A.column[entry]);
        matrix.value.push_back(A.value[entry]);
      }
    matrix.start.push_back(static_cast<Long>(matrix.row.size()));
  }
  return matrix;
}

/** The number of couplings per node above which a graph is that of a 3-D body, where a node of a
 * brick has 26 neighbours: nested dissection (METIS) there needs a third of the operations of
 * minimum degree. In 2-D, where a node has 8 neighbours, it costs more than it saves. */
constexpr double couplings_in_3d = 20.;

/** Returns an ordering of A with little fill: approximate minimum degree, in 3-D METIS. Unknowns
 * that follow each other with the same couplings (those of one node) are ordered as one: this takes
 * a quarter of the time, and the factor gets smaller. */
std::vector<Long> fill_reducing_order(Workspace &workspace, const Rows &A) {
  std::vector<int> first = {0}, node(A.n, 0);
  for (int i = 1; i < A.n; ++i) {
    if (A.start[i + 1] - A.start[i] == 1 || !A.same_pattern(i - 1, i))
      first.push_back(i);
    node[i] = static_cast<int>(first.size()) - 1;
  }
  const Long n_nodes = static_cast<Long>(first.size());
  first.push_back(A.n);
  UpperTriangle graph;
  for (Long j = 0; j < n_nodes; ++j) {
    for (int entry = A.start[first[j]]; entry < A.start[first[j] + 1]; ++entry)
      if (node[A.column[entry]] <= j)
        graph.row.push_back(node[A.column[entry]]);
    const auto begin = graph.row.begin() + graph.start.back();
    std::sort(begin, graph.row.end());
    graph.row.erase(std::unique(begin, graph.row.end()), graph.row.end());
    graph.start.push_back(static_cast<Long>(graph.row.size()));
  }
  cholmod_sparse view = graph.view();
  std::vector<Long> order_of_nodes(n_nodes), order;
  // The graph counts the upper triangle.
  if (2. * static_cast<double>(graph.row.size()) > couplings_in_3d * static_cast<double>(n_nodes))
    cholmod_l_metis(&view, nullptr, 0, 1, order_of_nodes.data(), &workspace.common);
  else
    cholmod_l_amd(&view, nullptr, 0, order_of_nodes.data(), &workspace.common);
  workspace.check();
  order.reserve(A.n);
  for (const Long j : order_of_nodes)
    for (int i = first[j]; i < first[j + 1]; ++i)
      order.push_back(i);
  return order;
}
} // namespace

/** The factor L with the workspace it lives in. */
class CholeskyFactor {
public:
  CholeskyFactor(const Rows &whole, const std::vector<types::global_dof_index> &last)
    : chosen_(marks(whole.n, last))
    , interiors_(whole, chosen_)
    , n_(interiors_.rest().n)
    , n_last_(static_cast<Long>(last.size())) {
    const Rows &A = interiors_.rest();
    UpperTriangle triangle = upper_triangle(A);
    cholmod_sparse matrix = triangle.view();
    analyse(A, matrix);
    cholmod_l_factorize(&matrix, L_, &workspace_.common);
    workspace_.check();
  }
  ~CholeskyFactor() {
    for (cholmod_dense **const dense : {&x_, &y_, &e_})
      cholmod_l_free_dense(dense, &workspace_.common);
    cholmod_l_free_factor(&L_, &workspace_.common);
  }
  CholeskyFactor(const CholeskyFactor &) = delete;
  CholeskyFactor &operator=(const CholeskyFactor &) = delete;

  /** Calls @p visit(i, j, L_ij) for every i ≥ j of the columns from @p first_column on. */
  template <typename Visitor>
  void for_each_entry(const Long first_column, const Visitor &visit) const {
    const Long *const super = static_cast<Long *>(L_->super);
    const Long *const row_start = static_cast<Long *>(L_->pi);
    const Long *const value_start = static_cast<Long *>(L_->px);
    const Long *const rows = static_cast<Long *>(L_->s);
    const double *const values = static_cast<double *>(L_->x);
    const auto n_supernodes = static_cast<Long>(L_->nsuper);
    Long s = std::upper_bound(super, super + n_supernodes, first_column) - super - 1;
    for (s = std::max(s, Long(0)); s < n_supernodes; ++s) {
      const Long n_rows = row_start[s + 1] - row_start[s];
      for (Long j = std::max(super[s], first_column); j < super[s + 1]; ++j) {
        const Long c = j - super[s];
        for (Long r = c; r < n_rows; ++r)
          visit(rows[row_start[s] + r], j, values[value_start[s] + c * n_rows + r]);
      }
    }
  }

  /** Returns the unknown of A that is eliminated at this place, after the insides of cells. */
  Long unknown_at(const Long place) const {
    return interiors_.unknowns()[order()[place]];
  }
  Long first_of_last() const {
    return n_ - n_last_;
  }

  /** Returns the smallest pivot over the largest one. */
  double min_pivot() {
    return cholmod_l_rcond(L_, &workspace_.common);
  }

  /** Computes X = A⁻¹ X for n right-hand sides, one column after another. */
  void solve(std::vector<double> &X, const Long n) {
    const std::size_t n_rows = X.size() / n;
    std::vector<double> B(n_ * n);
    for (Long k = 0; k < n; ++k)
      interiors_.reduce(X.data() + k * n_rows, B.data() + k * n_);
    cholmod_dense right_hand_sides = {};
    right_hand_sides.nrow = right_hand_sides.d = n_;
    right_hand_sides.ncol = n;
    right_hand_sides.nzmax = n_ * n;
    right_hand_sides.x = B.data();
    right_hand_sides.xtype = CHOLMOD_REAL;
    right_hand_sides.dtype = CHOLMOD_DOUBLE;
    cholmod_l_solve2(CHOLMOD_A, L_, &right_hand_sides, nullptr, &x_, nullptr, &y_, &e_,
                     &workspace_.common);
    workspace_.check();
    for (Long k = 0; k < n; ++k)
      interiors_.expand(X.data() + k * n_rows, static_cast<double *>(x_->x) + k * n_);
  }

private:
  static std::vector<bool> marks(const Long n, const std::vector<types::global_dof_index> &last) {
    std::vector<bool> chosen(n, false);
    for (const auto i : last)
      chosen[i] = true;
    return chosen;
  }

  /** Returns the unknowns of the rest in the order of their elimination. */
  const Long *order() const {
    return static_cast<Long *>(L_->Perm);
  }

  /** Analyses the pattern. Postordering makes supernodes large; it keeps the chosen unknowns last
   * wherever the others are connected. Elsewhere they are moved once more, behind the trees that
   * came after them. */
  void analyse(const Rows &A, cholmod_sparse &matrix) {
    std::vector<bool> chosen(n_, false);
    for (Long i = 0; i < n_; ++i)
      chosen[i] = chosen_[interiors_.unknowns()[i]];
    std::vector<Long> given = fill_reducing_order(workspace_, A);
    for (const bool postorder : {true, false}) {
      std::stable_partition(given.begin(), given.end(), [&](const Long i) { return !chosen[i]; });
      workspace_.common.postorder = postorder ? 1 : 0;
      cholmod_l_free_factor(&L_, &workspace_.common);
      L_ = cholmod_l_analyze_p(&matrix, given.data(), nullptr, 0, &workspace_.common);
      workspace_.check();
      if (std::all_of(order() + first_of_last(), order() + n_, [&](Long i) { return chosen[i]; }))
        return;
      given.assign(order(), order() + n_);
    }
  }

  Workspace workspace_;
  /** The unknowns that are eliminated last. */
  std::vector<bool> chosen_;
  CellInteriors interiors_;
  Long n_;
  Long n_last_;
  cholmod_factor *L_ = nullptr;
  cholmod_dense *x_ = nullptr;
  cholmod_dense *y_ = nullptr;
  cholmod_dense *e_ = nullptr;
};

SparseCholesky::SparseCholesky(const Rows &A)
  : factor_(std::make_unique<CholeskyFactor>(A, std::vector<types::global_dof_index>())) {}

SparseCholesky::~SparseCholesky() = default;

void SparseCholesky::solve(std::vector<double> &x) const {
  factor_->solve(x, 1);
}

CondensedInverse::CondensedInverse(const TrilinosWrappers::SparseMatrix &matrix, const double unit,
                                   const std::vector<Index> &last)
  : MatrixInverse(matrix, unit)
  , factor_(std::make_unique<CholeskyFactor>(Rows(matrix), last)) {
  const Long first = factor_->first_of_last();
  for (unsigned int row = 0; row < last.size(); ++row)
    rows_[factor_->unknown_at(first + row)] = row;
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
  const Long first = factor_->first_of_last();
  const auto n = static_cast<unsigned int>(rows_.size());
  TrailingFactor trailing = {LAPACKFullMatrix<double>(n, n), rows_};
  const double root = std::sqrt(unit());
  factor_->for_each_entry(first, [&](const Long i, const Long j, const double L_ij) {
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
  factor_->solve(X, static_cast<Long>(b.size()));
  auto begin = X.cbegin();
  for (Vector &solution : x) {
    std::copy(begin, begin + solution.size(), solution.begin());
    begin += static_cast<std::ptrdiff_t>(solution.size());
  }
}
} // namespace Signorini
