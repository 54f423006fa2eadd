// SPDX-License-Identifier: LGPL-2.1-or-later
// Generalised displacements: what plates and pins could do.

#include <signorini/scene/free_motions.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** The motions of all plates as one vector: travels, and rotations times the size of the body. */
using Coordinates = std::vector<double>;

Coordinates coordinates_of(const std::vector<PlateMotion> &motions, const double size)
{
  Coordinates x;
  for (const PlateMotion &motion : motions)
  {
    x.push_back(motion.travel);
    x.push_back(size * motion.rotation);
  }
  return x;
}

Coordinates coordinates_of(const RigidMotion &rigid)
{
  return {rigid.translation[0], rigid.translation[1], rigid.rotation};
}

/** The same span, with all translations that lie in it before what turns the body. */
std::vector<RigidMotion> translations_first(std::vector<RigidMotion> motions)
{
  const auto turning =
    std::max_element(motions.begin(), motions.end(), [](const auto &a, const auto &b) {
      return std::abs(a.rotation) < std::abs(b.rotation);
    });
  if (turning == motions.end() || turning->is_translation())
    return motions;
  std::iter_swap(turning, motions.end() - 1);
  const RigidMotion &last = motions.back();
  for (std::size_t i = 0; i + 1 < motions.size(); ++i)
    motions[i] = combine({motions[i], last}, {1., -motions[i].rotation / last.rotation});
  return motions;
}

/** The scene with contact sides that can neither open nor close. */
Scene<2> on_rails(Scene<2> scene)
{
  for (BoundaryCondition<2> &condition : scene.boundary)
    if (condition.role == Role::contact)
      condition.role = Role::roller;
  return scene;
}

double product(const Coordinates &x, const Coordinates &y)
{
  double sum = 0.;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += x[i] * y[i];
  return sum;
}

/** Takes the part in the span of an orthonormal basis away; twice, for rounding. */
void project_out(const std::vector<Coordinates> &basis, Coordinates &x)
{
  for (unsigned int pass = 0; pass < 2; ++pass)
    for (const Coordinates &e : basis)
    {
      const double share = product(e, x);
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] -= share * e[i];
    }
}

/** Adds the direction of @p x to the basis unless it lies in its span. @return whether it did not.
 */
bool extend(std::vector<Coordinates> &basis, Coordinates x)
{
  constexpr double negligible = 1e-6;
  project_out(basis, x);
  const double norm = std::sqrt(product(x, x));
  if (norm < negligible)
    return false;
  for (double &entry : x)
    entry /= norm;
  basis.push_back(x);
  return true;
}

/** What plates do when the body moves as a whole. */
std::vector<PlateMotion> follow(const RigidMotion &rigid, const std::vector<Plate> &plates)
{
  std::vector<PlateMotion> motions;
  motions.reserve(plates.size());
  for (const Plate &plate : plates)
    motions.push_back({plate.is_pushed ? rigid.velocity(plate.centre) * plate.direction : 0.,
                       plate.turns ? rigid.rotation / rigid.size : 0.});
  return motions;
}

/** One plate moves in one way, all others rest. */
std::vector<FreeMotion> single_motions(const std::vector<Plate> &plates, const double size)
{
  std::vector<FreeMotion> motions;
  for (std::size_t p = 0; p < plates.size(); ++p)
  {
    const auto add = [&](const PlateMotion &motion) {
      motions.push_back({std::vector<PlateMotion>(plates.size()), {}});
      motions.back().plates[p] = motion;
    };
    if (plates[p].is_pushed)
      add({1., 0.});
    if (plates[p].turns)
      add({0., 1. / size});
  }
  return motions;
}
} // namespace

double FreeMotion::work_of_plates(const std::vector<Plate> &plates_of_scene) const
{
  double work = 0.;
  for (std::size_t p = 0; p < plates.size(); ++p)
    work += plates_of_scene[p].work(plates[p]);
  return work;
}

FreeMotionBasis free_motions(const Scene<2> &scene)
{
  FreeMotionBasis motions;
  std::vector<Coordinates> rigid_motions, plate_motions;
  const double size = scene.geometry.diameter();
  const auto add = [&](const RigidMotion &rigid, std::vector<FreeMotion> &kind) {
    if (!extend(rigid_motions, coordinates_of(rigid)))
      return;
    kind.push_back({follow(rigid, scene.plates), rigid});
    extend(plate_motions, coordinates_of(kind.back().plates, size));
  };
  for (const RigidMotion &rigid : free_rigid_motions(on_rails(scene), Plates::released))
    add(rigid, motions.unseen);
  // Pure translations are exact on all meshes, and their balance is that of forces.
  for (const RigidMotion &rigid : translations_first(free_rigid_motions(scene, Plates::released)))
    add(rigid, motions.seen);
  for (const FreeMotion &single : single_motions(scene.plates, size))
    if (extend(plate_motions, coordinates_of(single.plates, size)))
      motions.seen.push_back(single);
  return motions;
}

std::vector<PlateMotion> combine_plates(const std::vector<FreeMotion> &motions,
                                        const std::vector<double> &q,
                                        const std::size_t n_plates)
{
  std::vector<PlateMotion> sum(n_plates);
  for (std::size_t j = 0; j < motions.size(); ++j)
    for (std::size_t p = 0; p < n_plates; ++p)
    {
      sum[p].travel += q[j] * motions[j].plates[p].travel;
      sum[p].rotation += q[j] * motions[j].plates[p].rotation;
    }
  return sum;
}
} // namespace Signorini
