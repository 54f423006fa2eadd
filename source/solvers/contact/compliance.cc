// SPDX-License-Identifier: LGPL-2.1-or-later
// C = Dᵀ A⁻¹ D from the factors or column by column, F = G - Dᵀ A⁻¹ f, and U = A⁻¹(D P + f) of
// (23).

#include <signorini/base/columns.h>
#include <signorini/base/instantiate.h>
#include <signorini/solvers/contact/compliance.h>

#include <algorithm>
#include <set>

namespace Signorini {
namespace {
/** The number of right-hand sides that are solved at once. */
constexpr std::size_t block_size = 32;
} // namespace

ColumnCompliance::ColumnCompliance(const StiffnessInverse &inverse, const Coupling &condensed_D,
                                   ColumnProgress progress)
  : DenseCompliance(Matrix(condensed_D.n_columns(), condensed_D.n_columns()))
  , inverse_(inverse)
  , D_(condensed_D)
  , progress_(std::move(progress))
  , known_(condensed_D.n_columns(), false) {}

ComplianceOperator::Matrix ColumnCompliance::solve_for(const Indices &numbers) const {
  Matrix found(size(), numbers.size());
  dealii::Vector<double> unit(size());
  for (std::size_t first = 0; first < numbers.size(); first += block_size) {
    const std::size_t last = std::min(first + block_size, numbers.size());
    std::vector<StiffnessInverse::Vector> right_hand_sides, solutions;
    for (std::size_t j = first; j < last; ++j) {
      unit = 0.;
      unit[numbers[j]] = 1.;
      right_hand_sides.push_back(inverse_.make_vector());
      D_.add_product(unit, right_hand_sides.back());
      solutions.push_back(inverse_.make_vector());
    }
    inverse_.solve(solutions, right_hand_sides);
    for (std::size_t j = first; j < last; ++j) {
      const dealii::Vector<double> column = D_.transpose_product(solutions[j - first]);
      for (unsigned int i = 0; i < size(); ++i)
        found(i, j) = column[i];
    }
    if (progress_)
      progress_(n_known_ + last);
  }
  return found;
}

void ColumnCompliance::require(const Indices &numbers) const {
  Indices missing;
  for (const unsigned int k : numbers)
    if (!known_[k])
      missing.push_back(k);
  if (missing.empty())
    return;
  const Matrix found = solve_for(missing);
  // Where both columns are computed now, the mean; elsewhere the row is the column.
  for (unsigned int j = 0; j < missing.size(); ++j)
    for (unsigned int i = 0; i < size(); ++i)
      C_(i, missing[j]) = C_(missing[j], i) = found(i, j);
  for (unsigned int j = 0; j < missing.size(); ++j)
    for (unsigned int i = 0; i < missing.size(); ++i)
      C_(missing[i], missing[j]) = 0.5 * (found(missing[i], j) + found(missing[j], i));
  for (const unsigned int k : missing)
    known_[k] = true;
  n_known_ += static_cast<unsigned int>(missing.size());
}

namespace {
/** Returns C = Dᵀ S⁻¹ D = Wᵀ W with S = L Lᵀ and W = L⁻¹ D. */
FullMatrix<double> compliance_from(TrailingFactor &factor, const Coupling &condensed_D) {
  // A moved LAPACK matrix loses its properties.
  factor.L.set_property(LAPACKSupport::lower_triangular);
  const unsigned int m = condensed_D.n_columns();
  LAPACKFullMatrix<double> W(factor.L.m(), m);
  for (unsigned int k = 0; k < m; ++k)
    for (const auto &entry : condensed_D.column(k))
      W(factor.rows.at(entry.first), k) += entry.second;
  factor.L.solve(W);
  LAPACKFullMatrix<double> C(m, m);
  W.Tmmult(C, W);
  FullMatrix<double> result(m, m);
  result = C;
  return result;
}
} // namespace

std::vector<types::global_dof_index> contact_unknowns(const Coupling &condensed_D) {
  std::set<types::global_dof_index> rows;
  for (unsigned int k = 0; k < condensed_D.n_columns(); ++k)
    for (const auto &entry : condensed_D.column(k))
      rows.insert(entry.first);
  return {rows.begin(), rows.end()};
}

std::shared_ptr<const ComplianceOperator> make_compliance(const StiffnessInverse &inverse,
                                                          const Coupling &condensed_D,
                                                          const ColumnProgress &progress) {
  // A scene without contact has no columns.
  const auto rows = contact_unknowns(condensed_D);
  if (auto factor = rows.empty() ? std::nullopt : inverse.trailing_factor(rows))
    return std::make_shared<const DenseCompliance>(compliance_from(*factor, condensed_D));
  return std::make_shared<const ColumnCompliance>(inverse, condensed_D, progress);
}

bool FreeState::nothing_touches(const AdmissibleSet &K) const {
  dealii::Vector<double> step(F);
  step *= -1.;
  return K.residual(dealii::Vector<double>(F.size()), step).all_zero();
}

template <int dim>
FreeState solve_free_state(const StiffnessInverse &inverse, const DisplacementSpace<dim> &space,
                           const DualVector &f, const Coupling &D,
                           const dealii::Vector<double> &G) {
  Displacement U_0 = space.zero();
  inverse.solve(U_0, f);
  FreeState state;
  state.U = space.complete(U_0);
  state.F = G;
  state.F -= D.transpose_product(state.U);
  // The rounding of U, which would decide whether a body that only touches presses.
  const double rounding = 1e-13 * state.U.linfty_norm();
  for (unsigned int k = 0; k < D.n_columns(); ++k) {
    double size = 0.;
    for (const auto &entry : D.column(k))
      size += std::abs(entry.second);
    if (std::abs(state.F[k]) <= rounding * size)
      state.F[k] = 0.;
  }
  return state;
}

template <int dim>
Displacement recover_displacement(const StiffnessInverse &inverse,
                                  const DisplacementSpace<dim> &space, const Coupling &condensed_D,
                                  const dealii::Vector<double> &P, const DualVector &f) {
  DualVector DP_plus_f(f);
  condensed_D.add_product(P, DP_plus_f);
  Displacement U = space.zero();
  inverse.solve(U, DP_plus_f);
  return space.complete(U);
}

template <int dim>
Displacement solve_homogeneous(const StiffnessInverse &inverse, const DisplacementSpace<dim> &space,
                               const DualVector &b) {
  Displacement w = space.zero();
  inverse.solve(w, b);
  space.distribute_homogeneous(w);
  return w;
}

INSTANTIATE_FUNCTION(solve_free_state);
INSTANTIATE_FUNCTION(recover_displacement);
INSTANTIATE_FUNCTION(solve_homogeneous);
} // namespace Signorini
