// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact solutions as the data of problem (1).

#include "manufactured_scene.h"

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Signorini
{
namespace
{
class Displacement : public dealii::Function<2>
{
public:
  explicit Displacement(Field field)
    : dealii::Function<2>(2)
    , field_(std::move(field))
  {
  }
  double value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    return field_(x).u[component];
  }
  void vector_value(const dealii::Point<2> &x, dealii::Vector<double> &values) const override
  {
    const FieldAtPoint at_x = field_(x);
    values[0] = at_x.u[0];
    values[1] = at_x.u[1];
  }
  dealii::Tensor<1, 2> gradient(const dealii::Point<2> &x,
                                const unsigned int component) const override
  {
    const FieldAtPoint at_x = field_(x);
    return dealii::Tensor<1, 2>({at_x.du[component][0], at_x.du[component][1]});
  }
  void vector_gradient(const dealii::Point<2> &x,
                       std::vector<dealii::Tensor<1, 2>> &gradients) const override
  {
    const FieldAtPoint at_x = field_(x);
    for (unsigned int c = 0; c < 2; ++c)
      gradients[c] = dealii::Tensor<1, 2>({at_x.du[c][0], at_x.du[c][1]});
  }

private:
  Field field_;
};

class BodyForce : public dealii::Function<2>
{
public:
  explicit BodyForce(Field field)
    : dealii::Function<2>(2)
    , field_(std::move(field))
  {
  }
  double value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    return field_(x).f[component];
  }
  void vector_value(const dealii::Point<2> &x, dealii::Vector<double> &values) const override
  {
    const FieldAtPoint at_x = field_(x);
    values[0] = at_x.f[0];
    values[1] = at_x.f[1];
  }

private:
  Field field_;
};

class Traction : public dealii::Function<2>
{
public:
  Traction(Field field,
           std::shared_ptr<const Material<2>> material,
           const dealii::Tensor<1, 2> &normal)
    : dealii::Function<2>(2)
    , field_(std::move(field))
    , material_(std::move(material))
    , normal_(normal)
  {
  }
  double value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    return traction(x)[component];
  }
  void vector_value(const dealii::Point<2> &x, dealii::Vector<double> &values) const override
  {
    const dealii::Tensor<1, 2> t = traction(x);
    values[0] = t[0];
    values[1] = t[1];
  }

private:
  dealii::Tensor<1, 2> traction(const dealii::Point<2> &x) const
  {
    const FieldAtPoint at_x = field_(x);
    dealii::SymmetricTensor<2, 2> strain;
    strain[0][0] = at_x.du[0][0];
    strain[1][1] = at_x.du[1][1];
    strain[0][1] = 0.5 * (at_x.du[0][1] + at_x.du[1][0]);
    const dealii::SymmetricTensor<2, 2> stress = material_->hooke(x) * strain;
    return stress * normal_;
  }

  Field field_;
  std::shared_ptr<const Material<2>> material_;
  dealii::Tensor<1, 2> normal_;
};

class ProfileFunction : public dealii::Function<2>
{
public:
  ProfileFunction(Profile profile, const unsigned int d)
    : profile_(std::move(profile))
    , d_(d)
  {
  }
  double value(const dealii::Point<2> &x, const unsigned int) const override
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
  return std::make_shared<Displacement>(field);
}

FunctionPointer<2> body_force_of(const Field &field)
{
  return std::make_shared<BodyForce>(field);
}

FunctionPointer<2> traction_of(const Field &field,
                               std::shared_ptr<const Material<2>> material,
                               const dealii::Tensor<1, 2> &normal)
{
  return std::make_shared<Traction>(field, std::move(material), normal);
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
} // namespace Signorini
