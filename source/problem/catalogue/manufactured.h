// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/functions.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace Signorini {
/**
 * A number with its first and second derivatives in the coordinates: forward automatic
 * differentiation. (Two nested numbers of Sacado take three times as long: 7 % of the CPU time of
 * A1 on 512² cells.)
 */
template <int dim>
struct Jet {
  Jet(const double v = 0., const Tensor<1, dim> &g = {}, const SymmetricTensor<2, dim> &h = {})
    : value(v)
    , gradient(g)
    , hessian(h) {}

  double value;
  Tensor<1, dim> gradient;
  SymmetricTensor<2, dim> hessian;

  /** Returns f(a), from f and its two derivatives at the value of a. */
  Jet chain(const double f, const double f1, const double f2) const {
    return {f, f1 * gradient, f1 * hessian + f2 * symmetrize(outer_product(gradient, gradient))};
  }
  friend Jet operator+(const Jet &a, const Jet &b) {
    return {a.value + b.value, a.gradient + b.gradient, a.hessian + b.hessian};
  }
  friend Jet operator*(const double s, const Jet &a) {
    return {s * a.value, s * a.gradient, s * a.hessian};
  }
  friend Jet operator*(const Jet &a, const Jet &b) {
    return {a.value * b.value, a.value * b.gradient + b.value * a.gradient,
            a.value * b.hessian + b.value * a.hessian +
              2. * symmetrize(outer_product(a.gradient, b.gradient))};
  }
  friend Jet operator-(const Jet &a) {
    return -1. * a;
  }
  friend Jet operator-(const Jet &a, const Jet &b) {
    return a + -b;
  }
  friend Jet operator/(const Jet &a, const double s) {
    return 1. / s * a;
  }
  friend Jet operator/(const Jet &a, const Jet &b) {
    const double r = 1. / b.value;
    return a * b.chain(r, -r * r, 2. * r * r * r);
  }
  friend Jet sqrt(const Jet &a) {
    const double root = std::sqrt(a.value);
    return a.chain(root, 0.5 / root, -0.25 / (root * a.value));
  }
  friend Jet sin(const Jet &a) {
    const double s = std::sin(a.value), c = std::cos(a.value);
    return a.chain(s, c, -s);
  }
};

using Jet2 = Jet<2>;
using Jets2 = std::array<Jet2, 2>;

template <int dim>
Jet<dim> positive_part(const Jet<dim> &q) {
  return q.value > 0. ? q : Jet<dim>();
}

template <int dim>
Jet<dim> cube(const Jet<dim> &q) {
  return q * q * q;
}

/** A formula for a vector field: its components from the coordinates, with all derivatives. */
template <int dim>
using Formula = std::function<std::array<Jet<dim>, dim>(const std::array<Jet<dim>, dim> &)>;

/** Fields by their values alone. */
template <int dim>
using ScalarField = std::function<double(const Point<dim> &)>;
template <int dim>
using VectorField = std::function<Tensor<1, dim>(const Point<dim> &)>;

/** Returns the isotropic material with Young's modulus and Poisson's ratio by expressions, in plane
 * strain; by default lambda = mu = 1. */
template <int dim>
std::shared_ptr<const Material<dim>> isotropic(const std::string &E = "2.5",
                                               const std::string &nu = "0.25") {
  const auto expression = [](const std::string &text) {
    return Expression<dim>(text, {}, "catalogue");
  };
  return make_isotropic<dim>(expression(E), expression(nu), PlaneState::strain);
}

template <int dim>
FunctionPointer<dim> function_of(const ScalarField<dim> &field) {
  return std::make_shared<ScalarFunctionFromFunctionObject<dim>>(field);
}

/** Returns the scene of a body that is clamped on one side and in contact on another, with given
 * tractions on all others. */
template <int dim>
Scene<dim> contact_scene(const Geometry<dim> &geometry,
                         const std::shared_ptr<const Material<dim>> &material,
                         const std::string &clamped, const std::string &contact,
                         const ScalarField<dim> &gap, const ScalarField<dim> &pressure) {
  Scene<dim> scene;
  scene.geometry = geometry;
  scene.material = material;
  scene.boundary.assign(geometry.sides.size(), {Role::traction, nullptr, nullptr});
  scene.boundary[geometry.find_side(clamped)].role = Role::clamped;
  scene.boundary[geometry.find_side(contact)] = {Role::contact, function_of(gap),
                                                 function_of(pressure)};
  return scene;
}

/**
 * Makes u the exact solution of a scene: u, its gradient, the tractions sigma n of flat sides and
 * the body force f = -div sigma, by automatic derivatives.
 *
 * @param log_gradient the gradient of log m where Hooke's tensor is m(x) C; empty for constant
 * tensors.
 */
template <int dim>
void set_exact_solution(Scene<dim> &scene, const Formula<dim> &u,
                        const VectorField<dim> &log_gradient = {}) {
  const auto material = scene.material;
  const auto jets = [u](const Point<dim> &x) {
    std::array<Jet<dim>, dim> at;
    for (unsigned int d = 0; d < dim; ++d)
      at[d] = {x[d], Point<dim>::unit_vector(d)};
    return u(at);
  };
  const auto value = [jets](const Point<dim> &x) {
    const std::array<Jet<dim>, dim> u_at_x = jets(x);
    Tensor<1, dim> result;
    for (unsigned int i = 0; i < dim; ++i)
      result[i] = u_at_x[i].value;
    return result;
  };
  const auto gradient = [jets](const Point<dim> &x) {
    const std::array<Jet<dim>, dim> u_at_x = jets(x);
    Tensor<2, dim> result;
    for (unsigned int i = 0; i < dim; ++i)
      result[i] = u_at_x[i].gradient;
    return result;
  };
  const auto body_force = [jets, material, log_gradient](const Point<dim> &x) {
    const std::array<Jet<dim>, dim> u_at_x = jets(x);
    const Tensor<1, dim> m = log_gradient ? log_gradient(x) : Tensor<1, dim>();
    const SymmetricTensor<4, dim> C = material->hooke(x);
    Tensor<1, dim> f;
    for (unsigned int j = 0; j < dim; ++j) {
      // (m C grad u)_{,j} = m C (grad u_{,j} + (log m)_{,j} grad u)
      Tensor<2, dim> derivative;
      for (unsigned int k = 0; k < dim; ++k)
        derivative[k] = u_at_x[k].hessian * Point<dim>::unit_vector(j) + m[j] * u_at_x[k].gradient;
      f -= (C * symmetrize(derivative)) * Point<dim>::unit_vector(j);
    }
    return f;
  };
  scene.exact_displacement = std::make_shared<FieldFunction<dim>>(value, gradient);
  scene.body_force = std::make_shared<FieldFunction<dim>>(body_force);
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    if (scene.boundary[i].role == Role::traction) {
      const Side<dim> &side = scene.geometry.sides[i];
      const Tensor<1, dim> normal = side.normal(side.coordinates(scene.geometry.lower));
      scene.boundary[i].data =
        std::make_shared<FieldFunction<dim>>([gradient, material, normal](const Point<dim> &x) {
          return material->hooke(x) * symmetrize(gradient(x)) * normal;
        });
    }
}
} // namespace Signorini
