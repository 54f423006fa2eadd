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

/** u_n - g on a piece of the contact surface. */
class Penetration
{
public:
  Penetration(const DisplacementSpace<2> &space,
              const ContactSurface<2> &surface,
              const NodalVector &U)
    : surface_(surface)
    , U_(U)
    , traces_(space)
  {
  }

  /** At equal distances between two positions of a piece. */
  const std::vector<double> &sample(const Piece<2> &piece, const double from, const double to)
  {
    positions_.clear();
    for (unsigned int i = 0; i <= n_intervals; ++i)
      positions_.emplace_back(from + (to - from) * i / n_intervals);
    const SurfaceRule<2> rule = surface_.at(piece, positions_);
    values_ = traces_.normal_displacement(surface_.faces()[piece.face], rule, U_);
    g_.resize(rule.size());
    surface_.condition(piece).data->value_list(rule.points, g_);
    for (std::size_t q = 0; q < rule.size(); ++q)
      values_[q] -= g_[q];
    return values_;
  }

  /** Adds what a piece tells about its patch. Around the deepest point the next samples are closer
   * to each other: a tip may touch between those of the whole face. */
  void look_at(const Piece<2> &piece, PatchState &state)
  {
    constexpr unsigned int n_zooms = 3;
    double from = 0., to = 1.;
    for (unsigned int zoom = 0; zoom < n_zooms; ++zoom)
    {
      const std::vector<double> &d = sample(piece, from, to);
      const auto deepest = std::max_element(d.begin(), d.end());
      state.deepest = std::max(state.deepest, *deepest);
      for (const double value : d)
        state.largest = std::max(state.largest, std::abs(value));
      const double middle = positions_[deepest - d.begin()][0], step = (to - from) / n_intervals;
      from = std::max(0., middle - step);
      to = std::min(1., middle + step);
    }
  }

private:
  static constexpr unsigned int n_intervals = 32;
  const ContactSurface<2> &surface_;
  const NodalVector &U_;
  TraceValues<2> traces_;
  std::vector<dealii::Point<1>> positions_;
  std::vector<double> values_, g_;
};

std::vector<PatchState> patch_states(const DisplacementSpace<2> &space,
                                     const MultiplierSpace<2> &multipliers,
                                     const NodalVector &U,
                                     const dealii::Vector<double> &P)
{
  const ContactSurface<2> &surface = multipliers.surface();
  std::vector<PatchState> states(surface.patches().size());
  Penetration penetration(space, surface, U);
  for (const Piece<2> &piece : surface.pieces())
  {
    PatchState &state = states[piece.patch];
    state.cell = surface.faces()[piece.face].cell->active_cell_index();
    penetration.look_at(piece, state);
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
