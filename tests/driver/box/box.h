// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/multiplier/multiplier_space.h>

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>

#include <functional>
#include <memory>
#include <vector>

/** lambda and mu of E = 1, nu = 0.3 in space. */
constexpr double lambda = 0.3 / (1.3 * 0.4);
constexpr double mu = 1. / 2.6;
/** sigma_33 / eps_33 in confined compression. */
constexpr double confined_modulus = lambda + 2. * mu;

/** Functions of x with one component, or with three. */
inline Signorini::FunctionPointer<3>
scalar(const std::function<double(const dealii::Point<3> &)> &f)
{
  return std::make_shared<dealii::ScalarFunctionFromFunctionObject<3>>(f);
}
using Vector3 = dealii::Tensor<1, 3>;
class VectorField : public dealii::Function<3>
{
public:
  explicit VectorField(std::function<Vector3(const dealii::Point<3> &)> f)
    : dealii::Function<3>(3)
    , f_(std::move(f))
  {
  }
  double value(const dealii::Point<3> &x, const unsigned int component) const override
  {
    return f_(x)[component];
  }
  void vector_value(const dealii::Point<3> &x, dealii::Vector<double> &values) const override
  {
    for (unsigned int d = 0; d < 3; ++d)
      values[d] = f_(x)[d];
  }

private:
  std::function<Vector3(const dealii::Point<3> &)> f_;
};
inline Signorini::FunctionPointer<3>
field(const std::function<Vector3(const dealii::Point<3> &)> &f)
{
  return std::make_shared<VectorField>(f);
}

/** A box between rollers on its upright sides, prescribed at the top, in contact at the bottom. */
inline Signorini::Scene<3> make_box_scene(const Signorini::FunctionPointer<3> &gap,
                                          const Signorini::FunctionPointer<3> &top,
                                          const dealii::Point<3> &upper = {1., 1., 1.})
{
  using namespace Signorini;
  Scene<3> scene;
  scene.name = "box";
  scene.geometry = make_box({0., 0., 0.}, upper, {1, 1, 1});
  const Expression<3> E("1", {}, "E"), nu("0.3", {}, "nu");
  scene.material = make_isotropic<3>(E, nu, PlaneState::strain);
  scene.boundary.resize(6);
  for (const char *side : {"left", "right", "front", "back"})
    scene.boundary[scene.geometry.find_side(side)].role = Role::roller;
  auto &bottom = scene.boundary[scene.geometry.find_side("bottom")];
  bottom.role = Role::contact;
  bottom.data = gap;
  auto &above = scene.boundary[scene.geometry.find_side("top")];
  above.role = Role::displacement;
  above.data = top;
  return scene;
}

/** Mesh, spaces and couplings of a box. */
struct Box
{
  Box(const Signorini::Scene<3> &scene_,
      const unsigned int level,
      const unsigned int ratio,
      const unsigned int degree = 1)
    : scene(scene_)
    , mesh(scene.geometry, 0, level, MPI_COMM_WORLD)
    , space(mesh, scene, Signorini::StrainOperator::symmetric_gradient, degree)
    , surface(mesh, scene, Signorini::Partition{ratio, 0})
    , multipliers(surface)
    , D(assemble_coupling(space, multipliers))
    , condensed_D(condense(D, space.constraints()))
    , G(assemble_gap(multipliers, 3))
  {
  }
  Box(const Box &) = delete;

  const Signorini::Scene<3> &scene;
  Signorini::Mesh<3> mesh;
  Signorini::DisplacementSpace<3> space;
  Signorini::ContactSurface<3> surface;
  Signorini::MultiplierSpace<3> multipliers;
  Signorini::Coupling D, condensed_D;
  dealii::Vector<double> G;
};
