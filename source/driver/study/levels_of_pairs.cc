// SPDX-License-Identifier: LGPL-2.1-or-later
// The levels of pairs of bodies where none is stated.

#include <signorini/base/errors.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/mesh/mesh.h>
#include <signorini/driver/study/levels_of_pairs.h>
#include <signorini/problem/parameters/parameters.h>

#include <cmath>

namespace Signorini {
namespace {
/** Returns whether a mesh has enough cells to begin with, and the sides of all pairs face each
 * other on more than two faces. */
bool can_begin(const Scene<2> &scene, const unsigned int level) {
  constexpr double n_enough = 256.;
  if (scene.geometry.n_coarse_cells * std::pow(4., level) < n_enough)
    return false;
  try {
    const Mesh<2> mesh(scene.geometry, level, level, MPI_COMM_SELF);
    return !ContactSurface<2>(mesh, scene, Partition()).has_unstable_patch();
  } catch (const InputError &) {
    return false;
  }
}
} // namespace

std::array<unsigned int, 2> levels_of_pairs(const Scene<2> &scene) {
  constexpr double most = 5e5;
  const DiscretizationParameters usual;
  unsigned int first = 0;
  while (first < usual.coarsest_level && !can_begin(scene, first))
    ++first;
  unsigned int last = first + 1;
  while (last < usual.finest_level &&
         2. * scene.geometry.n_coarse_cells * std::pow(4., last + 1.) < most)
    ++last;
  return {{first, last}};
}
} // namespace Signorini
