// SPDX-License-Identifier: LGPL-2.1-or-later
// Penetration between the nodes of the multipliers.

#include <signorini/elasticity/trace_values.h>
#include <signorini/postprocess/contact_pressure.h>
#include <signorini/refinement/unseen_contact.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** What u_n - g does on a patch, and whether a multiplier presses. */
struct PatchState
{
  unsigned int cell = 0;
  double deepest = 0., largest = 0.;
  bool presses = false;
};

std::vector<PatchState> patch_states(const DisplacementSpace<2> &space,
                                     const MultiplierSpace<2> &multipliers,
                                     const NodalVector &U,
                                     const dealii::Vector<double> &P)
{
  const ContactSurface<2> &surface = multipliers.surface();
  std::vector<PatchState> states(surface.patches().size());
  TraceValues<2> traces(space);
  std::vector<double> g;
  constexpr unsigned int n_intervals = 32;
  std::vector<dealii::Point<1>> positions;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    positions.emplace_back(static_cast<double>(i) / n_intervals);
  for (const Piece<2> &piece : surface.pieces())
  {
    const ContactFace<2> &face = surface.faces()[piece.face];
    const SurfaceRule<2> rule = surface.at(piece, positions);
    const std::vector<double> u_n = traces.normal_displacement(face, rule, U);
    g.resize(rule.size());
    surface.condition(piece).data->value_list(rule.points, g);
    PatchState &state = states[piece.patch];
    state.cell = face.cell->active_cell_index();
    for (std::size_t q = 0; q < rule.size(); ++q)
    {
      state.deepest = std::max(state.deepest, u_n[q] - g[q]);
      state.largest = std::max(state.largest, std::abs(u_n[q] - g[q]));
    }
  }
  const double threshold = pressing_threshold(P);
  for (unsigned int k = 0; k < P.size(); ++k)
    if (P[k] < threshold)
      states[multipliers.patch_of(k)].presses = true;
  return states;
}
} // namespace

std::vector<unsigned int> unseen_contact(const DisplacementSpace<2> &space,
                                         const MultiplierSpace<2> &multipliers,
                                         const NodalVector &U,
                                         const dealii::Vector<double> &P)
{
  constexpr double rounding = 1e-10, noticeable = 1e-3;
  const std::vector<PatchState> states = patch_states(space, multipliers, U, P);
  double largest = 0.;
  bool touches = false;
  for (const PatchState &state : states)
  {
    largest = std::max(largest, state.largest);
    touches = touches || state.presses;
  }
  const double tolerance = largest * (touches ? noticeable : rounding);
  std::vector<unsigned int> cells;
  for (std::size_t patch = 0; patch < states.size(); ++patch)
  {
    const auto presses = [&](const std::size_t other) {
      return other < states.size() && states[other].presses;
    };
    if (states[patch].deepest > tolerance && !presses(patch) && !presses(patch + 1) &&
        !(patch > 0 && presses(patch - 1)))
      cells.push_back(states[patch].cell);
  }
  return cells;
}
} // namespace Signorini
