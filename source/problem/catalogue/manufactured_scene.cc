// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact solutions as the data of problem (1).

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "catalogue_scenes.h"

namespace Signorini
{
namespace
{
template <int dim>
class DisplacementField : public Function<dim>
{
public:
  explicit DisplacementField(FieldOf<dim> field)
    : Function<dim>(dim)
    , field_(std::move(field))
  {
  }
  double value(const Point<dim> &x, const unsigned int component) const override
  {
    return field_(x).u[component];
  }
  void vector_value(const Point<dim> &x, dealii::Vector<double> &values) const override
  {
    const ExactField<dim> at_x = field_(x);
    std::copy(at_x.u.begin(), at_x.u.end(), values.begin());
  }
  Tensor<1, dim> gradient(const Point<dim> &x, const unsigned int component) const override
  {
    return row(field_(x), component);
  }
  void vector_gradient(const Point<dim> &x, std::vector<Tensor<1, dim>> &gradients) const override
  {
    const ExactField<dim> at_x = field_(x);
    for (unsigned int c = 0; c < dim; ++c)
      gradients[c] = row(at_x, c);
  }

private:
  static Tensor<1, dim> row(const ExactField<dim> &at_x, const unsigned int c)
  {
    Tensor<1, dim> gradient;
    for (unsigned int d = 0; d < dim; ++d)
      gradient[d] = at_x.du[c][d];
    return gradient;
  }

  FieldOf<dim> field_;
};

template <int dim>
class BodyForce : public Function<dim>
{
public:
  explicit BodyForce(FieldOf<dim> field)
    : Function<dim>(dim)
    , field_(std::move(field))
  {
  }
  double value(const Point<dim> &x, const unsigned int component) const override
  {
    return field_(x).f[component];
  }
  void vector_value(const Point<dim> &x, dealii::Vector<double> &values) const override
  {
    const ExactField<dim> at_x = field_(x);
    std::copy(at_x.f.begin(), at_x.f.end(), values.begin());
  }

private:
  FieldOf<dim> field_;
};

template <int dim>
class Traction : public Function<dim>
{
public:
  Traction(FieldOf<dim> field,
           std::shared_ptr<const Material<dim>> material,
           const Tensor<1, dim> &normal)
    : Function<dim>(dim)
    , field_(std::move(field))
    , material_(std::move(material))
    , normal_(normal)
  {
  }
  double value(const Point<dim> &x, const unsigned int component) const override
  {
    return traction(x)[component];
  }
  void vector_value(const Point<dim> &x, dealii::Vector<double> &values) const override
  {
    const Tensor<1, dim> t = traction(x);
    for (unsigned int d = 0; d < dim; ++d)
      values[d] = t[d];
  }

private:
  Tensor<1, dim> traction(const Point<dim> &x) const
  {
    const ExactField<dim> at_x = field_(x);
    SymmetricTensor<2, dim> strain;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        strain[i][j] = 0.5 * (at_x.du[i][j] + at_x.du[j][i]);
    const SymmetricTensor<2, dim> stress = material_->hooke(x) * strain;
    return stress * normal_;
  }

  FieldOf<dim> field_;
  std::shared_ptr<const Material<dim>> material_;
  Tensor<1, dim> normal_;
};

class ProfileFunction : public Function<2>
{
public:
  ProfileFunction(Profile profile, const unsigned int d)
    : profile_(std::move(profile))
    , d_(d)
  {
  }
  double value(const Point<2> &x, const unsigned int) const override
  {
    return profile_(x[d_]);
  }

private:
  Profile profile_;
  unsigned int d_;
};
} // namespace

std::array<double, 3> cube_of_positive_part(const double a, const std::array<double, 3> &q)
{
  const double p = std::max(q[0], 0.);
  return {a * p * p * p, 3. * a * p * p * q[1], a * (6. * p * q[1] * q[1] + 3. * p * p * q[2])};
}

FunctionPointer<2> displacement_of(const Field &field)
{
  return std::make_shared<DisplacementField<2>>(field);
}

FunctionPointer<2> body_force_of(const Field &field)
{
  return std::make_shared<BodyForce<2>>(field);
}

FunctionPointer<2> traction_of(const Field &field,
                               std::shared_ptr<const Material<2>> material,
                               const Tensor<1, 2> &normal)
{
  return std::make_shared<Traction<2>>(field, std::move(material), normal);
}

FunctionPointer<3> displacement_of(const FieldOf<3> &field)
{
  return std::make_shared<DisplacementField<3>>(field);
}

FunctionPointer<3> body_force_of(const FieldOf<3> &field)
{
  return std::make_shared<BodyForce<3>>(field);
}

FunctionPointer<3> traction_of(const FieldOf<3> &field,
                               std::shared_ptr<const Material<3>> material,
                               const Tensor<1, 3> &normal)
{
  return std::make_shared<Traction<3>>(field, std::move(material), normal);
}

FunctionPointer<2> function_of(const Profile &profile, const unsigned int d)
{
  return std::make_shared<ProfileFunction>(profile, d);
}

std::shared_ptr<const Material<2>> make_lame_material(const double lambda, const double mu)
{
  const auto number = [](const double value) {
    std::ostringstream text;
    text << std::setprecision(17) << value;
    return Expression<2>(text.str(), {}, "catalogue");
  };
  return make_isotropic<2>(number(mu * (3. * lambda + 2. * mu) / (lambda + mu)),
                           number(lambda / (2. * (lambda + mu))),
                           PlaneState::strain);
}

Scene<2> make_manufactured_scene(const Field &field,
                                 const std::shared_ptr<const Material<2>> &material,
                                 const Profile &gap,
                                 const Profile &pressure,
                                 const std::vector<double> &kinks_at_x)
{
  Scene<2> scene;
  scene.geometry = make_rectangle({0., 0.}, {1., 1.}, {1, 1});
  scene.boundary.resize(scene.geometry.sides.size());
  for (const char *name : {"left", "right"})
  {
    const std::size_t side = scene.geometry.find_side(name);
    scene.boundary[side] = {
      Role::traction, traction_of(field, material, scene.geometry.sides[side].normal(0.)), nullptr};
  }
  scene.boundary[scene.geometry.find_side("top")].role = Role::clamped;
  scene.boundary[scene.geometry.find_side("bottom")] = {
    Role::contact, function_of(gap), function_of(pressure)};
  scene.material = material;
  scene.body_force = body_force_of(field);
  scene.exact_displacement = displacement_of(field);
  scene.kinks = lines_at<2>({{kinks_at_x, {}}});
  return scene;
}

// Exact solutions in polar coordinates.

namespace
{
class AngleFunction : public Function<2>
{
public:
  explicit AngleFunction(Profile profile)
    : profile_(std::move(profile))
  {
  }
  double value(const Point<2> &x, const unsigned int) const override
  {
    return profile_(std::atan2(x[1], x[0]));
  }

private:
  Profile profile_;
};

FieldAtPoint to_cartesian(const PolarDisplacement &u,
                          const double r,
                          const double theta,
                          const double lambda,
                          const double mu)
{
  const PolarDerivatives &ur = u.radial, &ut = u.angular;
  const double M = lambda + 2. * mu, r2 = r * r;
  const double gradient[2][2] = {{ur.r, (ur.t - ut.v) / r}, {ut.r, (ut.t + ur.v) / r}};
  const double force[2] = {-(M * (ur.rr + ur.r / r - ur.v / r2) + mu * ur.tt / r2 +
                             (lambda + mu) * ut.rt / r - (lambda + 3. * mu) * ut.t / r2),
                           -(mu * (ut.rr + ut.r / r - ut.v / r2) + M * ut.tt / r2 +
                             (lambda + mu) * ur.rt / r + (lambda + 3. * mu) * ur.t / r2)};
  // e[a][i]: component i of e_r and e_theta.
  const double e[2][2] = {{std::cos(theta), std::sin(theta)}, {-std::sin(theta), std::cos(theta)}};
  FieldAtPoint field = {};
  for (unsigned int i = 0; i < 2; ++i)
  {
    field.u[i] = ur.v * e[0][i] + ut.v * e[1][i];
    field.f[i] = force[0] * e[0][i] + force[1] * e[1][i];
    for (unsigned int j = 0; j < 2; ++j)
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int b = 0; b < 2; ++b)
          field.du[i][j] += e[a][i] * gradient[a][b] * e[b][j];
  }
  return field;
}
} // namespace

PolarDerivatives product(const std::array<double, 3> &u, const std::array<double, 3> &v)
{
  return {u[0] * v[0], u[1] * v[0], u[0] * v[1], u[2] * v[0], u[1] * v[1], u[0] * v[2]};
}

Field field_of(const PolarField &polar, const double lambda, const double mu)
{
  return [=](const Point<2> &x) {
    const double r = x.norm(), theta = std::atan2(x[1], x[0]);
    return r < 1e-100 ? FieldAtPoint{} : to_cartesian(polar(r, theta), r, theta, lambda, mu);
  };
}

FunctionPointer<2> function_of_angle(const Profile &profile)
{
  return std::make_shared<AngleFunction>(profile);
}
} // namespace Signorini
