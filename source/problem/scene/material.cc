// SPDX-License-Identifier: LGPL-2.1-or-later
// E_ijkl: isotropic, orthotropic and general, by expressions.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/scene/material.h>

#include <deal.II/base/numbers.h>
#include <deal.II/physics/elasticity/standard_tensors.h>

#include <array>
#include <cmath>
#include <sstream>

namespace Signorini
{
namespace
{
template <int dim>
[[noreturn]] void refuse_value(const std::string &where,
                               const Point<dim> &x,
                               const std::string &found,
                               const std::string &allowed)
{
  std::ostringstream message;
  message << where << ": found " << found << " at (" << x << "), allowed: " << allowed << ".";
  throw InputError(message.str());
}

/** Returns a modulus at a point as the unit of stress, and 1 where it is no modulus: that is an
 * error where it is used. */
template <int dim>
double unit_of_stress(const Expression<dim> &modulus, const Point<dim> &x)
{
  const double value = modulus(x);
  return value > 0. && std::isfinite(value) ? value : 1.;
}

template <int dim>
class Isotropic : public Material<dim>
{
public:
  Isotropic(const Expression<dim> &youngs_modulus,
            const Expression<dim> &poissons_ratio,
            const PlaneState plane_state,
            const Point<dim> &reference)
    : Material<dim>(unit_of_stress(youngs_modulus, reference))
    , youngs_modulus_(youngs_modulus)
    , poissons_ratio_(poissons_ratio)
    , plane_state_(plane_state)
  {
  }

  SymmetricTensor<4, dim> relative_hooke(const Point<dim> &x) const override
  {
    const Lame lame = relative_lame_constants(x);
    using Tensors = Physics::Elasticity::StandardTensors<dim>;
    return lame.lambda * Tensors::IxI + 2. * lame.mu * Tensors::S;
  }

  bool is_constant() const override
  {
    return youngs_modulus_.is_constant() && poissons_ratio_.is_constant();
  }

  double out_of_plane_stress(const Point<dim> &x,
                             const SymmetricTensor<2, dim> &strain) const override
  {
    return dim == 2 && plane_state_ == PlaneState::strain
             ? this->modulus() * relative_lame_constants(x).lambda * trace(strain)
             : 0.;
  }

private:
  struct Lame
  {
    double lambda;
    double mu;
  };

  /** Returns Lame's constants in units of E_0: a constant modulus is exactly 1, whatever its unit.
   */
  Lame relative_lame_constants(const Point<dim> &x) const
  {
    const double given = youngs_modulus_(x);
    const double E = given / this->modulus();
    const double nu = poissons_ratio_(x);
    if (!(given > 0. && std::isfinite(E)))
      refuse_value(youngs_modulus_.where(), x, number_text(given), "a positive number everywhere");
    if (!(nu > -1. && nu < 0.5))
      refuse_value(poissons_ratio_.where(),
                   x,
                   number_text(nu),
                   "a number between -1 and 0.5 (both excluded) everywhere");
    const double mu = E / (2. * (1. + nu));
    const bool plane_stress = dim == 2 && plane_state_ == PlaneState::stress;
    const double lambda =
      plane_stress ? E * nu / (1. - nu * nu) : E * nu / ((1. + nu) * (1. - 2. * nu));
    return {lambda, mu};
  }

  Expression<dim> youngs_modulus_;
  Expression<dim> poissons_ratio_;
  PlaneState plane_state_;
};

/** The entries C11, C12, C13, C22, C23, C33. */
using VoigtMatrix = std::array<double, 6>;

SymmetricTensor<4, 2> to_tensor(const VoigtMatrix &C)
{
  SymmetricTensor<4, 2> E;
  E[0][0][0][0] = C[0];
  E[0][0][1][1] = E[1][1][0][0] = C[1];
  E[0][0][0][1] = E[0][1][0][0] = C[2];
  E[1][1][1][1] = C[3];
  E[1][1][0][1] = E[0][1][1][1] = C[4];
  E[0][1][0][1] = C[5];
  return E;
}

/** Returns whether C is positive definite, by Sylvester's criterion. */
bool is_positive_definite(const VoigtMatrix &C)
{
  const double minor = C[0] * C[3] - C[1] * C[1];
  const double determinant = C[0] * (C[3] * C[5] - C[4] * C[4]) -
                             C[1] * (C[1] * C[5] - C[4] * C[2]) +
                             C[2] * (C[1] * C[4] - C[3] * C[2]);
  return C[0] > 0. && minor > 0. && determinant > 0. && std::isfinite(determinant);
}

/** Returns the matrix of an orthotropic material seen from axes turned by -angle. */
VoigtMatrix rotate(const std::array<double, 4> &Q, const double angle)
{
  const double Q11 = Q[0], Q22 = Q[1], Q12 = Q[2], Q66 = Q[3];
  const double c = std::cos(angle), s = std::sin(angle);
  const double c2 = c * c, s2 = s * s, mixed = Q12 + 2. * Q66;
  return {Q11 * c2 * c2 + 2. * mixed * s2 * c2 + Q22 * s2 * s2,
          (Q11 + Q22 - 4. * Q66) * s2 * c2 + Q12 * (s2 * s2 + c2 * c2),
          (Q11 - mixed) * s * c2 * c + (mixed - Q22) * s2 * s * c,
          Q11 * s2 * s2 + 2. * mixed * s2 * c2 + Q22 * c2 * c2,
          (Q11 - mixed) * s2 * s * c + (mixed - Q22) * s * c2 * c,
          (Q11 + Q22 - 2. * Q12 - 2. * Q66) * s2 * c2 + Q66 * (s2 * s2 + c2 * c2)};
}

/** A law given by expressions for its Voigt matrix, or for moduli to be rotated into it. */
class Anisotropic : public Material<2>
{
public:
  Anisotropic(const std::vector<Expression<2>> &entries,
              const double degrees,
              const std::vector<Expression<2>> &across,
              const Point<2> &reference)
    : Material<2>(unit_of_stress(entries[0], reference))
    , entries_(entries)
    , across_(across)
    , angle_(degrees * numbers::PI / 180.)
  {
  }

  SymmetricTensor<4, 2> relative_hooke(const Point<2> &x) const override
  {
    const VoigtMatrix C = relative_voigt(x);
    if (!is_positive_definite(C))
      refuse_value(entries_[0].where(),
                   x,
                   "a tensor that is not positive definite",
                   "a positive definite one");
    return to_tensor(C);
  }

  bool is_constant() const override
  {
    for (const Expression<2> &entry : entries_)
      if (!entry.is_constant())
        return false;
    return true;
  }

  double out_of_plane_stress(const Point<2> &x, const SymmetricTensor<2, 2> &strain) const override
  {
    const Tensor<1, 2> first({std::cos(angle_), std::sin(angle_)}), second({-first[1], first[0]});
    const std::array<double, 3> in_own_axes = {
      first * (strain * first), second * (strain * second), 2. * (first * (strain * second))};
    double stress = 0.;
    for (std::size_t i = 0; i < across_.size(); ++i)
      stress += across_[i](x) * in_own_axes[i];
    return stress;
  }

private:
  VoigtMatrix relative_voigt(const Point<2> &x) const
  {
    const auto e = [&](const unsigned int i) { return entries_[i](x) / modulus(); };
    if (entries_.size() == 4)
      return rotate({e(0), e(1), e(2), e(3)}, angle_);
    return {e(0), e(1), e(2), e(3), e(4), e(5)};
  }

  std::vector<Expression<2>> entries_, across_;
  double angle_;
};
template <int dim>
class Piecewise : public Material<dim>
{
public:
  Piecewise(const std::vector<std::shared_ptr<const Material<dim>>> &materials,
            const std::function<unsigned int(const Point<dim> &)> &index_at,
            const Point<dim> &reference)
    : Material<dim>(materials[index_at(reference)]->modulus())
    , materials_(materials)
    , index_at_(index_at)
  {
  }

  SymmetricTensor<4, dim> relative_hooke(const Point<dim> &x) const override
  {
    return materials_[index_at_(x)]->hooke(x) / this->modulus();
  }

  bool is_constant() const override
  {
    return false;
  }

  double out_of_plane_stress(const Point<dim> &x,
                             const SymmetricTensor<2, dim> &strain) const override
  {
    return materials_[index_at_(x)]->out_of_plane_stress(x, strain);
  }

private:
  std::vector<std::shared_ptr<const Material<dim>>> materials_;
  std::function<unsigned int(const Point<dim> &)> index_at_;
};
} // namespace

template <int dim>
std::shared_ptr<const Material<dim>>
make_piecewise(const std::vector<std::shared_ptr<const Material<dim>>> &materials,
               const std::function<unsigned int(const Point<dim> &)> &index_at,
               const Point<dim> &reference)
{
  return std::make_shared<Piecewise<dim>>(materials, index_at, reference);
}

template <int dim>
std::shared_ptr<const Material<dim>> make_isotropic(const Expression<dim> &youngs_modulus,
                                                    const Expression<dim> &poissons_ratio,
                                                    const PlaneState plane_state,
                                                    const Point<dim> &reference)
{
  return std::make_shared<Isotropic<dim>>(youngs_modulus, poissons_ratio, plane_state, reference);
}

std::shared_ptr<const Material<2>> make_general(const std::vector<Expression<2>> &entries,
                                                const std::vector<Expression<2>> &across,
                                                const Point<2> &reference)
{
  AssertDimension(entries.size(), 6);
  return std::make_shared<Anisotropic>(entries, 0., across, reference);
}

std::shared_ptr<const Material<2>> make_orthotropic(const std::vector<Expression<2>> &moduli,
                                                    const double degrees,
                                                    const std::vector<Expression<2>> &across,
                                                    const Point<2> &reference)
{
  AssertDimension(moduli.size(), 4);
  return std::make_shared<Anisotropic>(moduli, degrees, across, reference);
}

template std::shared_ptr<const Material<2>>
make_isotropic(const Expression<2> &, const Expression<2> &, PlaneState, const Point<2> &);
template std::shared_ptr<const Material<3>>
make_isotropic(const Expression<3> &, const Expression<3> &, PlaneState, const Point<3> &);
template std::shared_ptr<const Material<2>>
make_piecewise(const std::vector<std::shared_ptr<const Material<2>>> &,
               const std::function<unsigned int(const Point<2> &)> &,
               const Point<2> &);
template std::shared_ptr<const Material<3>>
make_piecewise(const std::vector<std::shared_ptr<const Material<3>>> &,
               const std::function<unsigned int(const Point<3> &)> &,
               const Point<3> &);

// E_ijkl in 3-D by the 21 entries of its matrix.

namespace
{
/** The order of the matrix. */
constexpr unsigned int n_strains = 6;

/** The component of stress and strain that a row stands for. */
constexpr std::array<std::array<unsigned int, 2>, n_strains> voigt_pairs = {
  {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{1, 2}}, {{0, 2}}, {{0, 1}}}};

using VoigtMatrix6 = std::array<std::array<double, n_strains>, n_strains>;

/** Returns whether Cholesky's factorisation finds positive pivots only. */
bool is_positive_definite(VoigtMatrix6 C)
{
  for (unsigned int k = 0; k < n_strains; ++k)
  {
    if (!(C[k][k] > 0. && std::isfinite(C[k][k])))
      return false;
    for (unsigned int i = k + 1; i < n_strains; ++i)
      for (unsigned int j = k + 1; j < n_strains; ++j)
        C[i][j] -= C[i][k] * C[k][j] / C[k][k];
  }
  return true;
}

/** Returns the entry C11 as the unit of stress, and 1 where it is no modulus: that is an error
 * where it is used. */
double unit_from(const Expression<3> &entry, const Point<3> &x)
{
  const double value = entry(x);
  return value > 0. && std::isfinite(value) ? value : 1.;
}

class General3D : public Material<3>
{
public:
  General3D(const std::vector<Expression<3>> &entries, const Point<3> &reference)
    : Material<3>(unit_from(entries[0], reference))
    , entries_(entries)
  {
  }

  SymmetricTensor<4, 3> relative_hooke(const Point<3> &x) const override
  {
    const VoigtMatrix6 C = relative_matrix(x);
    if (!is_positive_definite(C))
    {
      std::ostringstream message;
      message << entries_[0].where() << ": found a tensor that is not positive definite at (" << x
              << "), allowed: a positive definite one.";
      throw InputError(message.str());
    }
    SymmetricTensor<4, 3> E;
    for (unsigned int i = 0; i < n_strains; ++i)
      for (unsigned int j = 0; j < n_strains; ++j)
        E[voigt_pairs[i][0]][voigt_pairs[i][1]][voigt_pairs[j][0]][voigt_pairs[j][1]] = C[i][j];
    return E;
  }

  bool is_constant() const override
  {
    for (const Expression<3> &entry : entries_)
      if (!entry.is_constant())
        return false;
    return true;
  }

  double out_of_plane_stress(const Point<3> & /*x*/,
                             const SymmetricTensor<2, 3> & /*strain*/) const override
  {
    return 0.;
  }

private:
  VoigtMatrix6 relative_matrix(const Point<3> &x) const
  {
    VoigtMatrix6 C;
    auto entry = entries_.begin();
    for (unsigned int i = 0; i < n_strains; ++i)
      for (unsigned int j = i; j < n_strains; ++j, ++entry)
        C[i][j] = C[j][i] = (*entry)(x) / modulus();
    return C;
  }

  std::vector<Expression<3>> entries_;
};
} // namespace

std::shared_ptr<const Material<3>> make_general_3d(const std::vector<Expression<3>> &entries,
                                                   const Point<3> &reference)
{
  AssertDimension(entries.size(), 21);
  return std::make_shared<General3D>(entries, reference);
}
} // namespace Signorini
