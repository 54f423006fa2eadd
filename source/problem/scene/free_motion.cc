// SPDX-License-Identifier: LGPL-2.1-or-later
// Generalised displacements: the motions of plates and pins.

#include <signorini/base/instantiate.h>
#include <signorini/problem/scene/free_motion.h>

#include <deal.II/lac/vector.h>

namespace Signorini {
namespace {
/** The motions of all plates, travels and rotations times the size of the body, or of a body. */
using Coordinates = dealii::Vector<double>;

template <int dim>
Coordinates coordinates_of(const std::vector<PlateMotion<dim>> &motions, const double size) {
  std::vector<double> x;
  for (PlateMotion<dim> motion : motions) {
    x.push_back(motion.travel);
    for (unsigned int k = dim; k < n_rigid_motions<dim>; ++k) {
      x.push_back(component(motion.drift, k - dim));
      x.push_back(size * component(motion.rotation, k - dim));
    }
  }
  return Coordinates(x.begin(), x.end());
}

template <int dim>
Coordinates coordinates_of(const RigidMotion<dim> &motion) {
  std::vector<double> x;
  for (BodyMotion<dim> body : motion.bodies) {
    x.insert(x.end(), body.translation.begin_raw(), body.translation.end_raw());
    for (unsigned int k = dim; k < n_rigid_motions<dim>; ++k)
      x.push_back(component(body.rotation, k - dim));
  }
  return Coordinates(x.begin(), x.end());
}

/** Returns the scene with contact sides that can neither open nor close, with friction nor slide.
 */
template <int dim>
Scene<dim> with_sliding_contact(Scene<dim> scene) {
  for (const ContactCondition<dim> &contact : scene.contacts)
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
template <int dim>
std::vector<PlateMotion<dim>> follow(const RigidMotion<dim> &rigid, const Scene<dim> &scene) {
  std::vector<PlateMotion<dim>> motions;
  for (const Plate<dim> &plate : scene.plates) {
    const BodyMotion<dim> &body = rigid.bodies[scene.geometry.body_of_side(plate.side)];
    const Tensor<1, dim> v = body.velocity(plate.centre);
    const auto across = plate.across();
    const auto units = plate.unit_motions();
    PlateMotion<dim> &motion = motions.emplace_back();
    motion.travel = plate.is_pushed ? v * plate.direction : 0.;
    for (unsigned int k = 1; k < dim && plate.drifts; ++k)
      motion.add(v * across[k - 1], units[k]);
    if (plate.turns)
      motion.rotation += 1. / body.size * body.rotation;
  }
  return motions;
}

/** Returns the motions in which one plate moves in one way and all others rest. */
template <int dim>
std::vector<FreeMotion<dim>> single_motions(const std::vector<Plate<dim>> &plates,
                                            const double size) {
  std::vector<FreeMotion<dim>> motions;
  for (std::size_t p = 0; p < plates.size(); ++p) {
    const auto units = plates[p].unit_motions();
    for (unsigned int k = 0; k < units.size(); ++k)
      if (plates[p].drives(k)) {
        motions.push_back({std::vector<PlateMotion<dim>>(plates.size()), {}});
        motions.back().plates[p].add(k < dim ? 1. : 1. / size, units[k]);
      }
  }
  return motions;
}
} // namespace

template <int dim>
double FreeMotion<dim>::work_of_plates(const std::vector<Plate<dim>> &plates_of_scene) const {
  AssertDimension(plates.size(), plates_of_scene.size());
  double work = 0.;
  for (std::size_t p = 0; p < plates.size(); ++p)
    work += plates_of_scene[p].work(plates[p]);
  return work;
}

template <int dim>
FreeMotionBasis<dim> free_motions(const Scene<dim> &scene) {
  FreeMotionBasis<dim> motions;
  std::vector<Coordinates> rigid_motions, plate_motions;
  const double size = scene.geometry.diameter();
  const auto add = [&](const RigidMotion<dim> &rigid, std::vector<FreeMotion<dim>> &kind) {
    if (!extend(rigid_motions, coordinates_of(rigid)))
      return;
    kind.push_back({follow(rigid, scene), rigid});
    extend(plate_motions, coordinates_of(kind.back().plates, size));
  };
  for (const RigidMotion<dim> &rigid :
       free_rigid_motions(with_sliding_contact(scene), Plates::released))
    add(rigid, motions.neutral);
  // Pure translations, which come first, are exact on all meshes, and their balance is that of
  // forces.
  for (const RigidMotion<dim> &rigid : free_rigid_motions(scene, Plates::released))
    add(rigid, motions.resisted);
  for (const FreeMotion<dim> &single : single_motions(scene.plates, size))
    if (extend(plate_motions, coordinates_of(single.plates, size)))
      motions.resisted.push_back(single);
  return motions;
}

template <int dim>
std::vector<PlateMotion<dim>> combine_plates(const std::vector<FreeMotion<dim>> &motions,
                                             const std::vector<double> &q,
                                             const std::size_t n_plates) {
  std::vector<PlateMotion<dim>> sum(n_plates);
  for (std::size_t j = 0; j < motions.size(); ++j)
    for (std::size_t p = 0; p < n_plates; ++p)
      sum[p].add(q[j], motions[j].plates[p]);
  return sum;
}

template struct FreeMotion<2>;
template struct FreeMotion<3>;
INSTANTIATE_FUNCTION(free_motions);
INSTANTIATE_FUNCTION(combine_plates);
} // namespace Signorini
