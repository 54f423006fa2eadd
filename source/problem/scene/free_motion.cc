// SPDX-License-Identifier: LGPL-2.1-or-later
// Generalised displacements: the motions of plates and pins.

#include <signorini/problem/scene/free_motion.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** The motions of all plates, travels and rotations times the size of the body, or of a body. */
using Coordinates = dealii::Vector<double>;

Coordinates coordinates_of(const std::vector<PlateMotion> &motions, const double size) {
  Coordinates x(3 * motions.size());
  for (std::size_t p = 0; p < motions.size(); ++p) {
    x[3 * p] = motions[p].travel;
    x[3 * p + 1] = motions[p].drift;
    x[3 * p + 2] = size * motions[p].rotation;
  }
  return x;
}

/** Returns a basis of the same span: first all translations that lie in it, then the motion that
 * turns the body. */
std::vector<RigidMotion> translations_first(std::vector<RigidMotion> motions) {
  // Motions of several bodies are separate already.
  if (motions.empty() || motions.front().bodies.size() > 1)
    return motions;
  const auto rotation = [](const RigidMotion &motion) { return motion.bodies[0].rotation; };
  const auto turning =
    std::max_element(motions.begin(), motions.end(), [&](const auto &a, const auto &b) {
      return std::abs(rotation(a)) < std::abs(rotation(b));
    });
  if (turning->is_translation())
    return motions;
  std::iter_swap(turning, motions.end() - 1);
  const RigidMotion &last = motions.back();
  for (std::size_t i = 0; i + 1 < motions.size(); ++i)
    motions[i] = combine({motions[i], last}, {1., -rotation(motions[i]) / rotation(last)});
  return motions;
}

/** Returns the scene with contact sides that can neither open nor close, with friction nor slide.
 */
Scene<2> with_sliding_contact(Scene<2> scene) {
  for (const ContactCondition<2> &contact : scene.contacts)
    scene.boundary[contact.side].role =
      scene.contact_law.has_tangential_part() ? Role::clamped : Role::roller;
  return scene;
}

/** Adds the direction of @p x to an orthonormal basis unless it lies in its span. @return whether
 * it was added. */
bool extend(std::vector<Coordinates> &basis, Coordinates x) {
  constexpr double negligible = 1e-6;
  // Twice, because of rounding.
  for (unsigned int pass = 0; pass < 2; ++pass)
    for (const Coordinates &e : basis)
      x.add(-(e * x), e);
  const double norm = x.size() == 0 ? 0. : x.l2_norm();
  if (norm < negligible)
    return false;
  x /= norm;
  basis.push_back(x);
  return true;
}

/** Returns the motions of the plates when their bodies move as wholes. */
std::vector<PlateMotion> follow(const RigidMotion &rigid, const Scene<2> &scene) {
  std::vector<PlateMotion> motions;
  motions.reserve(scene.plates.size());
  for (const Plate &plate : scene.plates) {
    const BodyMotion &body = rigid.bodies[scene.geometry.body_of_side(plate.side)];
    motions.push_back({plate.is_pushed ? body.velocity(plate.centre) * plate.direction : 0.,
                       plate.drifts ? body.velocity(plate.centre) * plate.across() : 0.,
                       plate.turns ? body.rotation / body.size : 0.});
  }
  return motions;
}

/** Returns the motions in which one plate moves in one way and all others rest. */
std::vector<FreeMotion> single_motions(const std::vector<Plate> &plates, const double size) {
  std::vector<FreeMotion> motions;
  for (std::size_t p = 0; p < plates.size(); ++p) {
    const auto add = [&](const PlateMotion &motion) {
      motions.push_back({std::vector<PlateMotion>(plates.size()), {}});
      motions.back().plates[p] = motion;
    };
    if (plates[p].is_pushed)
      add({1., 0., 0.});
    if (plates[p].drifts)
      add({0., 1., 0.});
    if (plates[p].turns)
      add({0., 0., 1. / size});
  }
  return motions;
}
} // namespace

double FreeMotion::work_of_plates(const std::vector<Plate> &plates_of_scene) const {
  AssertDimension(plates.size(), plates_of_scene.size());
  double work = 0.;
  for (std::size_t p = 0; p < plates.size(); ++p)
    work += plates_of_scene[p].work(plates[p]);
  return work;
}

FreeMotionBasis free_motions(const Scene<2> &scene) {
  FreeMotionBasis motions;
  std::vector<Coordinates> rigid_motions, plate_motions;
  const double size = scene.geometry.diameter();
  const auto add = [&](const RigidMotion &rigid, std::vector<FreeMotion> &kind) {
    Coordinates x(3 * rigid.bodies.size());
    for (std::size_t b = 0; b < rigid.bodies.size(); ++b)
      for (unsigned int k = 0; k < 3; ++k)
        x[3 * b + k] = k < 2 ? rigid.bodies[b].translation[k] : rigid.bodies[b].rotation;
    if (!extend(rigid_motions, x))
      return;
    kind.push_back({follow(rigid, scene), rigid});
    extend(plate_motions, coordinates_of(kind.back().plates, size));
  };
  for (const RigidMotion &rigid : free_rigid_motions(with_sliding_contact(scene), Plates::released))
    add(rigid, motions.neutral);
  // Pure translations are exact on all meshes, and their balance is that of forces.
  for (const RigidMotion &rigid : translations_first(free_rigid_motions(scene, Plates::released)))
    add(rigid, motions.resisted);
  for (const FreeMotion &single : single_motions(scene.plates, size))
    if (extend(plate_motions, coordinates_of(single.plates, size)))
      motions.resisted.push_back(single);
  return motions;
}

std::vector<PlateMotion> combine_plates(const std::vector<FreeMotion> &motions,
                                        const std::vector<double> &q, const std::size_t n_plates) {
  std::vector<PlateMotion> sum(n_plates);
  for (std::size_t j = 0; j < motions.size(); ++j)
    for (std::size_t p = 0; p < n_plates; ++p) {
      sum[p].travel += q[j] * motions[j].plates[p].travel;
      sum[p].drift += q[j] * motions[j].plates[p].drift;
      sum[p].rotation += q[j] * motions[j].plates[p].rotation;
    }
  return sum;
}
} // namespace Signorini
