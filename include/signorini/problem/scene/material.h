// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/formulas/expression.h>
#include <signorini/problem/parameters/options.h>

#include <deal.II/base/symmetric_tensor.h>

#include <functional>
#include <memory>
#include <vector>

namespace Signorini {
/** Hooke's law across the plane of a 2-D body: sigma_zz = coupling:eps + modulus eps_zz, and the
 * stress in the plane that eps_zz adds, eps_zz coupling. */
template <int dim>
struct AcrossLaw {
  SymmetricTensor<2, dim> coupling;
  double modulus = 0.;
};

/** Hooke's tensor E_ijkl(x) of (1) (force/area). */
template <int dim>
class Material {
public:
  /** @param modulus E_0, a modulus of this material (force/area). */
  explicit Material(const double modulus)
    : modulus_(modulus) {}
  virtual ~Material() = default;

  /** Returns E_0, the unit of stress in which systems of equations are solved (force/area). */
  double modulus() const {
    return modulus_;
  }
  /** Returns E_ijkl / E_0 at a point. @throws InputError where the data there is no material. */
  virtual SymmetricTensor<4, dim> relative_hooke(const Point<dim> &x) const = 0;
  /** Returns E_ijkl at a point. @throws InputError like relative_hooke(). */
  SymmetricTensor<4, dim> hooke(const Point<dim> &x) const {
    return modulus_ * relative_hooke(x);
  }

  /** Returns whether E_ijkl is the same everywhere. */
  virtual bool is_constant() const = 0;
  /** Returns whether it is the same everywhere in each cell of a mesh: constants of regions, which
   * consist of coarse cells. */
  virtual bool is_constant_on_cells() const {
    return is_constant();
  }

  /** Returns the law across the plane at a point, in units of E_0. Plane problems do not contain
   * it, but the von Mises stress does; in bodies of revolution it is that around the axis. */
  virtual AcrossLaw<dim> relative_across(const Point<dim> &x) const = 0;
  /** Returns the same in units of stress. */
  AcrossLaw<dim> across(const Point<dim> &x) const {
    const AcrossLaw<dim> law = relative_across(x);
    return {modulus_ * law.coupling, modulus_ * law.modulus};
  }

  /** Returns the formulas of the moduli. */
  virtual std::vector<Expression<dim>> expressions() const = 0;

private:
  double modulus_;
};

/** Returns the material sigma = lambda tr(eps) I + 2 mu eps, with lambda replaced by 2 lambda
 * mu/(lambda + 2 mu) for plane stress; in bodies of revolution eps contains the hoop strain.
 * Young's modulus and Poisson's ratio may depend on the point; E_0 is Young's modulus at the point
 * @p reference. */
template <int dim>
std::shared_ptr<const Material<dim>> make_isotropic(const Expression<dim> &youngs_modulus,
                                                    const Expression<dim> &poissons_ratio,
                                                    PlaneState plane_state,
                                                    const Point<dim> &reference = Point<dim>());

/** Returns the material that is one of several at every point: that of the index @p index_at. E_0
 * is that of the material at the point @p reference. */
template <int dim>
std::shared_ptr<const Material<dim>> make_piecewise(
  const std::vector<std::shared_ptr<const Material<dim>>> &materials,
  const std::function<unsigned int(const Point<dim> &)> &index_at, const Point<dim> &reference);

/** Returns the material (s11, s22, s12) = C (e11, e22, 2 e12), in 3-D (s11, s22, s33, s23, s13,
 * s12) = C (e11, e22, e33, 2 e23, 2 e13, 2 e12), with the upper triangle of C, row by row: C11,
 * C12, ...; C must be positive definite at every point. In 2-D s33 = Z (e11,e22,2 e12) with the
 * three entries Z of @p across, which is empty in plane stress. E_0 is C11 at the point @p
 * reference. */
template <int dim>
std::shared_ptr<const Material<dim>> make_general(const std::vector<Expression<dim>> &entries,
                                                  const std::vector<Expression<dim>> &across = {},
                                                  const Point<dim> &reference = Point<dim>());

/** Returns the material with the moduli Q11, Q22, Q12, Q66 in axes that are rotated by @p degrees
 * against the x-axis; s33 = Q31 e11 + Q32 e22 in these axes with the two entries of @p across,
 * which is empty in plane stress. E_0 is Q11 at the point @p reference. */
std::shared_ptr<const Material<2>> make_orthotropic(const std::vector<Expression<2>> &moduli,
                                                    double degrees,
                                                    const std::vector<Expression<2>> &across = {},
                                                    const Point<2> &reference = Point<2>());
} // namespace Signorini
