// SPDX-License-Identifier: LGPL-2.1-or-later
// The misfit u_n - g where the body presses.

#include <signorini/discretization/elasticity/traces.h>
#include <signorini/error_control/hp/contact_zone.h>
#include <signorini/postprocessing/fields/contact_pressure.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** Returns whether all multipliers of a patch press. */
bool presses_everywhere(const MultiplierSpace<2> &multipliers,
                        const Pressure &P,
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
                        const Displacement &U,
                        const Pressure &P,
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

// Penetration between the nodes of the multipliers.

namespace
{
/** The extreme values of u_n - g on a patch, and whether a multiplier presses. */
struct PatchState
{
  unsigned int cell = 0;
  double deepest = 0., largest = 0.;
  bool presses = false;
};

/** Samples u_n - g on a piece of the contact surface. */
class Penetration
{
public:
  Penetration(const DisplacementSpace<2> &space,
              const ContactSurface<2> &surface,
              const Displacement &U)
    : surface_(surface)
    , U_(U)
    , traces_(space)
  {
  }

  /** Samples at equal distances between two positions of a piece. */
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

  /** Adds the samples of a piece to the state of its patch. Around the deepest point the next
   * samples are closer to each other: a tip may touch between those of the whole face. */
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
  const Displacement &U_;
  TraceValues<2> traces_;
  std::vector<dealii::Point<1>> positions_;
  std::vector<double> values_, g_;
};

std::vector<PatchState> patch_states(const DisplacementSpace<2> &space,
                                     const MultiplierSpace<2> &multipliers,
                                     const Displacement &U,
                                     const Pressure &P)
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
                                         const Displacement &U,
                                         const Pressure &P)
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

// A pressure at the nodes of another mesh.

Pressure transfer_pressure(const MultiplierSpace<2> &from,
                           const Pressure &P,
                           const MultiplierSpace<2> &to)
{
  const std::vector<Patch<2>> &known = from.surface().patches();
  Pressure transferred(to.n_multipliers());
  std::size_t patch = 0;
  for (unsigned int k = 0; k < transferred.size(); ++k)
  {
    const unsigned int side = to.surface().patches()[to.patch_of(k)].side;
    const dealii::Point<1> s = to.node(k);
    // Patches and nodes are sorted by side and arc length.
    while (patch + 1 < known.size() && (known[patch].side < side || (known[patch].side == side &&
                                                                     known[patch].upper[0] < s[0])))
      ++patch;
    if (known[patch].side == side)
      transferred[k] = std::min(0., from.value(P, patch, s));
  }
  return transferred;
}
} // namespace Signorini
