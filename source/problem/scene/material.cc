// SPDX-License-Identifier: LGPL-2.1-or-later
// E_ijkl: isotropic, and general by the entries of its matrix, by expressions.

#include <signorini/base/instantiate.h>
#include <signorini/problem/scene/material.h>

#include <deal.II/base/numbers.h>
#include <deal.II/physics/elasticity/standard_tensors.h>
#include <deal.II/physics/transformations.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini {
namespace {
/** Returns a modulus at a point as the unit of stress, and 1 where it is no modulus: that is an
 * error where it is used. */
template <int dim>
double unit_of_stress(const Expression<dim> &modulus, const Point<dim> &x) {
  const double value = modulus(x);
  return value > 0. && std::isfinite(value) ? value : 1.;
}

template <int dim>
class Isotropic : public Material<dim> {
public:
  Isotropic(const Expression<dim> &youngs_modulus, const Expression<dim> &poissons_ratio,
            const PlaneState plane_state, const Point<dim> &reference)
    : Material<dim>(unit_of_stress(youngs_modulus, reference))
    , youngs_modulus_(youngs_modulus)
    , poissons_ratio_(poissons_ratio)
    , plane_state_(plane_state) {}

  SymmetricTensor<4, dim> relative_hooke(const Point<dim> &x) const override {
    const auto [lambda, mu] = relative_lame_constants(x);
    using Tensors = Physics::Elasticity::StandardTensors<dim>;
    return lambda * Tensors::IxI + 2. * mu * Tensors::S;
  }

  bool is_constant() const override {
    return youngs_modulus_.is_constant() && poissons_ratio_.is_constant();
  }

  AcrossLaw<dim> relative_across(const Point<dim> &x) const override {
    if (dim == 3 || plane_state_ == PlaneState::stress)
      return {};
    const auto [lambda, mu] = relative_lame_constants(x);
    return {lambda * unit_symmetric_tensor<dim>(), lambda + 2. * mu};
  }

  std::vector<Expression<dim>> expressions() const override {
    return {youngs_modulus_, poissons_ratio_};
  }

private:
  /** Returns lambda and mu in units of E_0: a constant modulus is exactly 1, whatever its unit. */
  std::pair<double, double> relative_lame_constants(const Point<dim> &x) const {
    const double given = youngs_modulus_(x);
    const double E = given / this->modulus();
    const double nu = poissons_ratio_(x);
    if (!(given > 0. && std::isfinite(E)))
      refuse_value(youngs_modulus_.where(), number_text(given), x, "a positive number everywhere");
    if (!(nu > -1. && nu < 0.5))
      refuse_value(poissons_ratio_.where(), number_text(nu), x,
                   "a number between -1 and 0.5 (both excluded) everywhere");
    const bool plane_stress = dim == 2 && plane_state_ == PlaneState::stress;
    return {E * nu / ((1. + nu) * (plane_stress ? 1. - nu : 1. - 2. * nu)), E / (2. * (1. + nu))};
  }

  Expression<dim> youngs_modulus_;
  Expression<dim> poissons_ratio_;
  PlaneState plane_state_;
};

/** The order of the matrix of a law, and the component of stress and strain of each row. */
template <int dim>
constexpr unsigned int n_strains = dim *(dim + 1) / 2;

TableIndices<2> component_of(const unsigned int row, const unsigned int dim) {
  if (row < dim)
    return {row, row};
  return dim == 2 ? TableIndices<2>(0, 1) : TableIndices<2>(row == 3 ? 1 : 0, row == 5 ? 1 : 2);
}

/** Returns whether Cholesky's factorisation finds positive pivots only. */
template <int n>
bool is_positive_definite(Tensor<2, n> C) {
  for (unsigned int k = 0; k < n; ++k) {
    if (!(C[k][k] > 0. && std::isfinite(C[k][k])))
      return false;
    for (unsigned int i = k + 1; i < n; ++i)
      C[i] -= C[i][k] / C[k][k] * C[k];
  }
  return true;
}

/** A law given by the upper triangle of its matrix in axes of its own. */
template <int dim>
class General : public Material<dim> {
public:
  /** @param axes the directions of the axes in its columns. */
  General(const std::vector<Expression<dim>> &entries, const std::vector<Expression<dim>> &across,
          const Tensor<2, dim> &axes, const Point<dim> &reference)
    : Material<dim>(unit_of_stress(entries[0], reference))
    , entries_(entries)
    , across_(across)
    , axes_(axes) {}

  SymmetricTensor<4, dim> relative_hooke(const Point<dim> &x) const override {
    constexpr unsigned int n = n_strains<dim>;
    Tensor<2, n> C;
    SymmetricTensor<4, dim> E;
    auto entry = entries_.begin();
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = i; j < n; ++j, ++entry) {
        C[i][j] = C[j][i] = (*entry)(x) / this->modulus();
        const TableIndices<2> a = component_of(i, dim), b = component_of(j, dim);
        E[a[0]][a[1]][b[0]][b[1]] = E[b[0]][b[1]][a[0]][a[1]] = C[i][j];
      }
    if (!is_positive_definite(C))
      refuse_value(entries_[0].where(), "a tensor that is not positive definite", x,
                   "a positive definite one");
    return dim == 2 ? Physics::Transformations::basis_transformation(E, axes_) : E;
  }

  bool is_constant() const override {
    return std::all_of(entries_.begin(), entries_.end(),
                       [](const auto &entry) { return entry.is_constant(); });
  }

  AcrossLaw<dim> relative_across(const Point<dim> &x) const override {
    SymmetricTensor<2, dim> in_own_axes;
    for (unsigned int i = 0; i < across_.size(); ++i)
      in_own_axes[component_of(i, dim)] = across_[i](x) / this->modulus();
    return {Physics::Transformations::basis_transformation(in_own_axes, axes_), 0.};
  }

  std::vector<Expression<dim>> expressions() const override {
    return entries_;
  }

private:
  std::vector<Expression<dim>> entries_, across_;
  Tensor<2, dim> axes_;
};

/** One of several materials at every point. */
template <int dim>
class Piecewise : public Material<dim> {
public:
  Piecewise(const std::vector<std::shared_ptr<const Material<dim>>> &materials,
            const std::function<unsigned int(const Point<dim> &)> &index_at,
            const Point<dim> &reference)
    : Material<dim>(materials[index_at(reference)]->modulus())
    , materials_(materials)
    , index_at_(index_at) {}

  SymmetricTensor<4, dim> relative_hooke(const Point<dim> &x) const override {
    return materials_[index_at_(x)]->hooke(x) / this->modulus();
  }

  bool is_constant() const override {
    return false;
  }
  bool is_constant_on_cells() const override {
    return std::all_of(materials_.begin(), materials_.end(),
                       [](const auto &material) { return material->is_constant(); });
  }

  AcrossLaw<dim> relative_across(const Point<dim> &x) const override {
    const AcrossLaw<dim> law = materials_[index_at_(x)]->across(x);
    return {law.coupling / this->modulus(), law.modulus / this->modulus()};
  }

  std::vector<Expression<dim>> expressions() const override {
    std::vector<Expression<dim>> all;
    for (const auto &material : materials_)
      for (const Expression<dim> &expression : material->expressions())
        all.push_back(expression);
    return all;
  }

private:
  std::vector<std::shared_ptr<const Material<dim>>> materials_;
  std::function<unsigned int(const Point<dim> &)> index_at_;
};
} // namespace

template <int dim>
std::shared_ptr<const Material<dim>> make_piecewise(
  const std::vector<std::shared_ptr<const Material<dim>>> &materials,
  const std::function<unsigned int(const Point<dim> &)> &index_at, const Point<dim> &reference) {
  AssertIndexRange(index_at(reference), materials.size());
  return std::make_shared<Piecewise<dim>>(materials, index_at, reference);
}

template <int dim>
std::shared_ptr<const Material<dim>> make_isotropic(const Expression<dim> &youngs_modulus,
                                                    const Expression<dim> &poissons_ratio,
                                                    const PlaneState plane_state,
                                                    const Point<dim> &reference) {
  return std::make_shared<Isotropic<dim>>(youngs_modulus, poissons_ratio, plane_state, reference);
}

template <int dim>
std::shared_ptr<const Material<dim>> make_general(const std::vector<Expression<dim>> &entries,
                                                  const std::vector<Expression<dim>> &across,
                                                  const Point<dim> &reference) {
  Assert(across.empty() || across.size() == 3, ExcDimensionMismatch(across.size(), 3));
  AssertDimension(entries.size(), n_strains<dim> * (n_strains<dim> + 1) / 2);
  const Tensor<2, dim> axes = unit_symmetric_tensor<dim>();
  return std::make_shared<General<dim>>(entries, across, axes, reference);
}

std::shared_ptr<const Material<2>> make_orthotropic(const std::vector<Expression<2>> &moduli,
                                                    const double degrees,
                                                    const std::vector<Expression<2>> &across,
                                                    const Point<2> &reference) {
  AssertDimension(moduli.size(), 4);
  Assert(across.empty() || across.size() == 2, ExcDimensionMismatch(across.size(), 2));
  const Expression<2> zero("0", {}, "");
  const double angle = degrees * numbers::PI / 180.;
  return std::make_shared<General<2>>(
    std::vector<Expression<2>>{moduli[0], moduli[2], zero, moduli[1], zero, moduli[3]}, across,
    Physics::Transformations::Rotations::rotation_matrix_2d(angle), reference);
}

INSTANTIATE_FUNCTION(make_isotropic);
INSTANTIATE_FUNCTION(make_general);
INSTANTIATE_FUNCTION(make_piecewise);
} // namespace Signorini
