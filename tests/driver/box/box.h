// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/space/displaced_body.h>
#include <signorini/problem/geometry/shapes.h>
#include <signorini/problem/scene/functions.h>

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
scalar(const std::function<double(const dealii::Point<3> &)> &f) {
  return std::make_shared<dealii::ScalarFunctionFromFunctionObject<3>>(f);
}
using Vector3 = dealii::Tensor<1, 3>;
inline Signorini::FunctionPointer<3>
field(const std::function<Vector3(const dealii::Point<3> &)> &f) {
  return std::make_shared<Signorini::FieldFunction<3>>(f);
}

/** Functions that vanish. */
inline const Signorini::FunctionPointer<3> zero = scalar([](const auto &) { return 0.; }),
                                           nothing = field([](const auto &) { return Vector3(); });

/** A box between rollers on its upright sides, prescribed at the top, in contact at the bottom. */
inline Signorini::Scene<3> make_box_scene(const Signorini::FunctionPointer<3> &gap,
                                          const Signorini::FunctionPointer<3> &top,
                                          const dealii::Point<3> &upper = {1., 1., 1.}) {
  using namespace Signorini;
  Scene<3> scene;
  scene.name = "box";
  scene.geometry = make_box({0., 0., 0.}, upper, {1, 1, 1});
  const Expression<3> E("1", {}, "E"), nu("0.3", {}, "nu");
  scene.material = make_isotropic<3>(E, nu, PlaneState::strain);
  scene.boundary.resize(6);
  for (const char *side : {"left", "right", "front", "back"})
    scene.boundary[scene.geometry.find_side(side)].role = Role::roller;
  const unsigned int bottom = scene.geometry.find_side("bottom");
  scene.boundary[bottom].role = Role::contact;
  scene.contacts.emplace_back().side = bottom;
  scene.contacts[0].gap = gap;
  auto &above = scene.boundary[scene.geometry.find_side("top")];
  above.role = Role::displacement;
  above.data = top;
  return scene;
}

/** Mesh, spaces and couplings of a box. */
struct Box {
  Box(const Signorini::Scene<3> &scene_, const unsigned int level, const unsigned int ratio,
      const unsigned int degree = 1)
    : scene(scene_)
    , mesh(scene.geometry, 0, level, MPI_COMM_WORLD)
    , space(mesh, scene, Signorini::StrainOperator::symmetric_gradient, degree)
    , surface(mesh, scene, Signorini::Partition{ratio})
    , multipliers(surface)
    , D(assemble_coupling(space, multipliers))
    , condensed_D(condense(D, space.constraints()))
    , G(assemble_gap(multipliers, scene.contacts, 3)) {}
  Box(const Box &) = delete;

  /** The values of p at the middles of the patches, in x and y: of a product of linear functions
   * the means. */
  Signorini::Pressure at_centres(const std::function<double(const dealii::Point<2> &)> &p) const {
    Signorini::Pressure P(multipliers.n_multipliers());
    for (unsigned int tau = 0; tau < P.size(); ++tau)
      P[tau] = p(at(tau, surface.patches()[tau].centre()));
    return P;
  }

  /** The x and y of a point of a patch. */
  dealii::Point<2> at(const unsigned int patch, const dealii::Point<2> &s) const {
    const dealii::Point<3> x = surface.point(surface.patches()[patch], s);
    return {x[0], x[1]};
  }

  /** The box displaced and pressed. */
  Signorini::BodyInContact<3> body(const Signorini::Displacement &U,
                                   const Signorini::Multiplier &P) const {
    return {{space, scene, U}, multipliers, P};
  }

  const Signorini::Scene<3> &scene;
  Signorini::Mesh<3> mesh;
  Signorini::DisplacementSpace<3> space;
  Signorini::ContactSurface<3> surface;
  Signorini::MultiplierSpace<3> multipliers;
  Signorini::Coupling D, condensed_D;
  dealii::Vector<double> G;
};
