// SPDX-License-Identifier: LGPL-2.1-or-later
// Manufactured solutions by lifting boundary data from y = 0 into the square.

#include "lift_family.h"

namespace Signorini
{
namespace
{
/** u_i, u_{i,k} and u_{i,kl} at a point. */
struct Jet
{
  std::array<double, 2> u;
  std::array<std::array<double, 2>, 2> du;
  std::array<std::array<std::array<double, 2>, 2>, 2> ddu;
};

/** Voigt vectors (11, 22, 12). */
using Voigt = std::array<double, 3>;

Voigt multiply(const std::array<Voigt, 3> &C, const Voigt &e)
{
  Voigt s = {};
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < 3; ++b)
      s[a] += C[a][b] * e[b];
  return s;
}

Jet lift(const LiftFamily &family, const dealii::Point<2> &x)
{
  const auto &C = family.C;
  const Derivatives U = family.U(x[0]), V = family.V(x[0]), p = family.p(x[0]);
  const double C22s = C[1][1] - C[1][2] * C[1][2] / C[2][2];
  const double C12s = C[0][1] - C[0][2] * C[1][2] / C[2][2];
  std::array<std::array<double, 3>, 2> slope;
  for (unsigned int k = 0; k < 3; ++k)
  {
    slope[1][k] = (p[k] - C12s * V[k + 1]) / C22s;
    slope[0][k] = -(C[0][2] * V[k + 1] + C[1][2] * slope[1][k]) / C[2][2] - U[k + 1];
  }
  const double y = x[1], c = 1. - y * y, c1 = -2. * y, c2 = -2.;
  Jet jet;
  for (unsigned int i = 0; i < 2; ++i)
  {
    const Derivatives &trace = i == 0 ? V : U;
    const auto &s = slope[i];
    jet.u[i] = (trace[0] + y * s[0]) * c;
    jet.du[i][0] = (trace[1] + y * s[1]) * c;
    jet.du[i][1] = s[0] * c + (trace[0] + y * s[0]) * c1;
    jet.ddu[i][0][0] = (trace[2] + y * s[2]) * c;
    jet.ddu[i][0][1] = jet.ddu[i][1][0] = s[1] * c + (trace[1] + y * s[1]) * c1;
    jet.ddu[i][1][1] = 2. * s[0] * c1 + (trace[0] + y * s[0]) * c2;
  }
  return jet;
}

Voigt stress(const LiftFamily &family, const Jet &jet)
{
  return multiply(family.C, {jet.du[0][0], jet.du[1][1], jet.du[0][1] + jet.du[1][0]});
}

class LiftDisplacement : public dealii::Function<2>
{
public:
  explicit LiftDisplacement(const LiftFamily &family)
    : dealii::Function<2>(2)
    , family_(family)
  {
  }
  double value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    return lift(family_, x).u[component];
  }
  void vector_value(const dealii::Point<2> &x, dealii::Vector<double> &values) const override
  {
    const Jet jet = lift(family_, x);
    values[0] = jet.u[0];
    values[1] = jet.u[1];
  }
  dealii::Tensor<1, 2> gradient(const dealii::Point<2> &x,
                                const unsigned int component) const override
  {
    const Jet jet = lift(family_, x);
    return dealii::Tensor<1, 2>({jet.du[component][0], jet.du[component][1]});
  }

private:
  LiftFamily family_;
};

/** f = -div sigma. */
class LiftBodyForce : public dealii::Function<2>
{
public:
  explicit LiftBodyForce(const LiftFamily &family)
    : dealii::Function<2>(2)
    , family_(family)
  {
  }
  void vector_value(const dealii::Point<2> &x, dealii::Vector<double> &values) const override
  {
    const Jet jet = lift(family_, x);
    std::array<Voigt, 2> ds;
    for (unsigned int k = 0; k < 2; ++k)
      ds[k] = multiply(family_.C,
                       {jet.ddu[0][0][k], jet.ddu[1][1][k], jet.ddu[0][1][k] + jet.ddu[1][0][k]});
    values[0] = -(ds[0][0] + ds[1][2]);
    values[1] = -(ds[0][2] + ds[1][1]);
  }
  double value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    dealii::Vector<double> values(2);
    vector_value(x, values);
    return values[component];
  }

private:
  LiftFamily family_;
};

/** t = sigma n. */
class LiftTraction : public dealii::Function<2>
{
public:
  LiftTraction(const LiftFamily &family, const dealii::Tensor<1, 2> &normal)
    : dealii::Function<2>(2)
    , family_(family)
    , normal_(normal)
  {
  }
  double value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    const Voigt s = stress(family_, lift(family_, x));
    return component == 0 ? s[0] * normal_[0] + s[2] * normal_[1]
                          : s[2] * normal_[0] + s[1] * normal_[1];
  }

private:
  LiftFamily family_;
  dealii::Tensor<1, 2> normal_;
};

/** A function of x alone. */
class Trace : public dealii::Function<2>
{
public:
  explicit Trace(std::function<double(double)> f)
    : f_(std::move(f))
  {
  }
  double value(const dealii::Point<2> &x, const unsigned int) const override
  {
    return f_(x[0]);
  }

private:
  std::function<double(double)> f_;
};
} // namespace

Scene<2> make_lift_scene(const LiftFamily &family)
{
  Scene<2> scene;
  scene.geometry = make_rectangle({0., 0.}, {1., 1.}, {1, 1});
  scene.boundary.resize(scene.geometry.sides.size());
  for (const char *name : {"left", "right"})
  {
    const std::size_t side = scene.geometry.find_side(name);
    scene.boundary[side] = {
      Role::traction,
      std::make_shared<LiftTraction>(family, scene.geometry.sides[side].normal),
      nullptr};
  }
  scene.boundary[scene.geometry.find_side("top")].role = Role::clamped;
  scene.boundary[scene.geometry.find_side("bottom")] = {
    Role::contact,
    std::make_shared<Trace>([family](const double x) { return -family.U(x)[0] + family.slack(x); }),
    std::make_shared<Trace>([family](const double x) { return family.p(x)[0]; })};
  scene.body_force = std::make_shared<LiftBodyForce>(family);
  scene.exact_displacement = std::make_shared<LiftDisplacement>(family);
  return scene;
}
} // namespace Signorini
