// SPDX-License-Identifier: LGPL-2.1-or-later
// A⁻¹ where the unknowns inside cells are eliminated cell by cell.

#include <signorini/base/instantiate.h>
#include <signorini/solvers/stiffness/cellwise_inverse.h>

#include <utility>

namespace Signorini {
namespace {
using Dof = std::vector<types::global_dof_index>::const_iterator;

dealii::Vector<double> values(const StiffnessInverse::Vector &x, const Dof begin, const Dof end) {
  dealii::Vector<double> result(end - begin);
  x.extract_subvector_to(begin, end, result.begin());
  return result;
}

template <int dim>
class CellwiseInverse final : public MatrixInverse {
public:
  using Cell = CondensedCell<dim>;

  /** @param edges the inverse of the system's matrix. */
  CellwiseInverse(const LinearSystem<dim> &system, const DisplacementSpace<dim> &space,
                  std::unique_ptr<StiffnessInverse> edges)
    : MatrixInverse(system.matrix, system.unit)
    , cells_(system.cells)
    , space_(space)
    , edges_(std::move(edges)) {}

  std::optional<TrailingFactor> trailing_factor(const std::vector<Index> &unknowns) const override {
    return edges_->trailing_factor(unknowns);
  }

  /** x_i = K_ii⁻¹ b_i + X x_e, where x_e solves the system of all S for b_e + Xᵀ b_i. */
  void apply(std::vector<Vector> &x, const std::vector<Vector> &b) const override {
    std::vector<Vector> on_edges;
    on_edges.reserve(b.size());
    for (const Vector &b_k : b)
      on_edges.push_back(reduced(b_k));
    edges_->apply(x, on_edges);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const Displacement u = displacement(x[k]);
      for (const Cell &cell : cells_) {
        const Dof inner = cell.dofs.begin() + cell.matrix->X.n();
        dealii::Vector<double> u_inner = values(b[k], inner, cell.dofs.end());
        cell.matrix->inner.solve(u_inner);
        cell.matrix->X.vmult(u_inner, values(u, cell.dofs.begin(), inner), true);
        for (unsigned int i = 0; i < u_inner.size(); ++i)
          x[k](inner[i]) = u_inner[i];
      }
    }
  }

private:
  void residual(Vector &r, const Vector &x, const Vector &b, const bool accurate) const override {
    MatrixInverse::residual(r, x, reduced(b), accurate);
    for (const Cell &cell : cells_)
      for (Dof i = cell.dofs.begin() + cell.matrix->X.n(); i != cell.dofs.end(); ++i)
        r(*i) = 0.;
  }

  /** Returns b_e + Xᵀ b_i beside b_i. */
  Vector reduced(const Vector &b) const {
    DualVector sum = space_.make_vector();
    sum.copy_locally_owned_data_from(b);
    for (const Cell &cell : cells_) {
      const LAPACKFullMatrix<double> &X = cell.matrix->X;
      dealii::Vector<double> product(X.n());
      X.Tvmult(product, values(b, cell.dofs.begin() + X.n(), cell.dofs.end()));
      sum.add(product.size(), cell.dofs.data(), product.begin());
    }
    sum.compress(VectorOperation::add);
    return space_.condense(sum);
  }

  /** Returns T x. */
  Displacement displacement(const Vector &x) const {
    Displacement u = space_.zero();
    u.copy_locally_owned_data_from(x);
    space_.distribute_homogeneous(u);
    return u;
  }

  const std::vector<Cell> &cells_;
  const DisplacementSpace<dim> &space_;
  std::unique_ptr<StiffnessInverse> edges_;
};
} // namespace

template <int dim>
std::unique_ptr<StiffnessInverse> make_stiffness_inverse(
  const LinearSystem<dim> &system, const DisplacementSpace<dim> &space, const LinearSolver solver,
  const std::vector<types::global_dof_index> &contact_unknowns) {
  auto inverse = factorise(system.matrix, system.unit, solver, contact_unknowns);
  if (system.cells.empty())
    return inverse;
  return std::make_unique<CellwiseInverse<dim>>(system, space, std::move(inverse));
}

INSTANTIATE_FUNCTION(make_stiffness_inverse);
} // namespace Signorini
