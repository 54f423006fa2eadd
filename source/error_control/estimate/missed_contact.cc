// SPDX-License-Identifier: LGPL-2.1-or-later
// Penetration where nothing presses.

#include <signorini/discretization/space/trace_values.h>
#include <signorini/error_control/estimate/missed_contact.h>
#include <signorini/postprocessing/fields/contact_load.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Signorini {
namespace {
/** Returns whether the closures of two patches meet. */
bool touch(const Patch<3> &a, const Patch<3> &b) {
  const double tolerance = 1e-6 * a.diameter();
  if (a.side != b.side)
    return false;
  for (unsigned int d = 0; d < 2; ++d)
    if (a.lower[d] > b.upper[d] + tolerance || b.lower[d] > a.upper[d] + tolerance)
      return false;
  return true;
}

/** Returns whether a patch presses or touches one that does. */
bool is_near_contact(const MultiplierSpace<3> &multipliers, const Pressure &P,
                     const Patch<3> &patch) {
  const double threshold = pressing_threshold(P);
  for (unsigned int k = 0; k < P.size(); ++k)
    if (P[k] < threshold && touch(multipliers.surface().patches()[multipliers.patch_of(k)], patch))
      return true;
  return false;
}

/** Returns the modulus of the softer one of pressing and shearing. */
double modulus_at(const Scene<3> &scene, const Point<3> &x) {
  const SymmetricTensor<4, 3> E = scene.material->hooke(x);
  return std::min(std::max({E[0][0][0][0], E[1][1][1][1], E[2][2][2][2]}),
                  4. * std::max({E[0][1][0][1], E[0][2][0][2], E[1][2][1][2]}));
}
} // namespace

double energy_of_missed_contact(const DisplacementSpace<3> &space,
                                const MultiplierSpace<3> &multipliers, const Scene<3> &scene,
                                const Displacement &U, const Pressure &P) {
  const ContactSurface<3> &surface = multipliers.surface();
  // Coarse meshes, which miss contact, are sampled densely.
  const double per_piece = 20000. / std::max<std::size_t>(1, surface.faces().size());
  const auto n_points = static_cast<unsigned int>(std::clamp(std::sqrt(per_piece), 3., 32.));
  TraceValues<3> traces(space);
  std::vector<double> on_patch(surface.patches().size(), 0.);
  for (const Piece<3> &piece : surface.pieces()) {
    const SurfaceRule<3> rule = surface.rule(piece, n_points);
    const std::vector<double> depths = penetration(scene, surface, piece, rule, U, traces);
    double square = 0.;
    for (std::size_t q = 0; q < rule.size(); ++q)
      square += std::pow(std::max(0., depths[q]), 2) * rule.weights[q];
    if (square > 0.)
      on_patch[piece.patch] += modulus_at(scene, rule.points[0]) * square;
  }
  Utilities::MPI::sum(on_patch, surface.communicator(), on_patch);
  double energy = 0.;
  for (std::size_t k = 0; k < on_patch.size(); ++k)
    if (const Patch<3> &patch = surface.patches()[k];
        on_patch[k] > 0. && !is_near_contact(multipliers, P, patch))
      energy += 0.5 * numbers::PI / std::sqrt(patch.measure) * on_patch[k];
  return std::sqrt(energy);
}
} // namespace Signorini
