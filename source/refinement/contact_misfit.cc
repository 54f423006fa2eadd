// SPDX-License-Identifier: LGPL-2.1-or-later
// u_n - g where the body presses.

#include <signorini/elasticity/trace_values.h>
#include <signorini/postprocess/contact_pressure.h>
#include <signorini/refinement/contact_misfit.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** Whether all multipliers of a patch press. */
bool presses_everywhere(const MultiplierSpace<2> &multipliers,
                        const dealii::Vector<double> &P,
                        const unsigned int patch)
{
  const double threshold = pressing_threshold(P);
  const auto &unknowns = multipliers.unknowns_on(patch);
  return std::all_of(unknowns.begin(), unknowns.end(), [&](const unsigned int k) {
    return k == multipliers.no_unknown || P[k] < threshold;
  });
}
} // namespace

void add_contact_misfit(const DisplacementSpace<2> &space,
                        const MultiplierSpace<2> &multipliers,
                        const Scene<2> &scene,
                        const NodalVector &U,
                        const dealii::Vector<double> &P,
                        std::vector<CellIndicator> &indicators)
{
  const ContactSurface<2> &surface = multipliers.surface();
  TraceValues<2> traces(space);
  std::vector<double> g;
  for (const Piece<2> &piece : surface.pieces())
  {
    if (!presses_everywhere(multipliers, P, piece.patch))
      continue;
    const ContactFace<2> &face = surface.faces()[piece.face];
    const unsigned int p = space.element(face.cell).degree;
    const SurfaceRule<2> rule = surface.rule(piece, p + 2);
    const std::vector<double> u_n = traces.normal_displacement(face, rule, U);
    g.resize(rule.size());
    surface.condition(piece).data->value_list(rule.points, g);
    double square = 0.;
    for (std::size_t q = 0; q < rule.size(); ++q)
      square += (u_n[q] - g[q]) * (u_n[q] - g[q]) * rule.weights[q];
    const double waves = 0.5 * dealii::numbers::PI * p / surface.patches()[piece.patch].measure;
    CellIndicator &indicator = indicators[face.cell->active_cell_index()];
    indicator.error = std::sqrt(indicator.error * indicator.error +
                                indicator_modulus(scene, face.cell->center()) * waves * square);
  }
}
} // namespace Signorini
