// SPDX-License-Identifier: LGPL-2.1-or-later
// The misfits u_n - g where the body presses, u_t - g_t where it sticks, and penetration between
// the nodes of the multipliers.

#include <signorini/discretization/space/paired_piece.h>
#include <signorini/error_control/estimate/contact_part.h>
#include <signorini/error_control/hp/contact_misfit.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
void add_contact_misfit(const BodyInContact<2> &body, const Component component,
                        std::vector<CellIndicator> &indicators) {
  const ContactSurface<2> &surface = body.surface();
  const std::vector<NodeState> states = patch_states(body.multipliers, body.P);
  TraceValues<2> traces(body.space);
  for (const Piece<2> &piece : surface.pieces()) {
    if (!follows(states[piece.patch], component))
      continue;
    unsigned int p = 0;
    double compliance = 0.;
    const auto faces = surface.faces_at(piece, piece.on_mesh);
    for (const auto &of_body : faces) {
      p = std::max(p, body.space.element(of_body.face.cell).degree);
      compliance += 1. / softer_modulus(body.scene, of_body.face.cell->center());
    }
    const SurfaceRule<2> rule = surface.rule(piece, p + 2);
    const std::vector<double> depths =
      PairedPiece<2>(surface, piece).closing(body, rule, traces, component);
    double square = 0.;
    for (std::size_t q = 0; q < rule.size(); ++q)
      square += depths[q] * depths[q] * rule.weights[q];
    const double waves = 0.5 * numbers::PI * p / surface.patches()[piece.patch].measure;
    // Both bodies give way, the softer one more.
    for (const auto &of_body : faces) {
      CellIndicator &indicator = indicators[of_body.face.cell->active_cell_index()];
      const double modulus = softer_modulus(body.scene, of_body.face.cell->center());
      indicator.error =
        std::hypot(indicator.error, std::sqrt(waves * square / modulus) / compliance);
    }
  }
}

namespace {
/** The extreme values of u_n - g on a patch, and whether a multiplier presses. */
struct PatchState {
  /** The cells of the piece that lies deepest, in a pair of both bodies. */
  std::vector<unsigned int> cells;
  double deepest = 0., largest = 0.;
  bool presses = false;
};

/** Adds samples of u_n - g on a piece to the state of its patch. Around the deepest point the next
 * samples are closer to each other: a tip may touch between those of the whole face. */
void add_samples(const BodyInContact<2> &body, const Piece<2> &piece, TraceValues<2> &traces,
                 PatchState &state) {
  constexpr unsigned int n_zooms = 3, n_intervals = 32;
  double from = 0., to = 1.;
  for (unsigned int zoom = 0; zoom < n_zooms; ++zoom) {
    std::vector<Point<1>> positions;
    for (unsigned int i = 0; i <= n_intervals; ++i)
      positions.emplace_back(from + (to - from) * i / n_intervals);
    const SurfaceRule<2> rule = body.surface().at(piece, positions);
    const std::vector<double> depths =
      PairedPiece<2>(body.surface(), piece).closing(body, rule, traces);
    const auto deepest = std::max_element(depths.begin(), depths.end());
    if (state.cells.empty() || *deepest > state.deepest) {
      state.cells.clear();
      for (const auto &of_body : body.surface().faces_at(piece, rule))
        state.cells.push_back(of_body.face.cell->active_cell_index());
    }
    state.deepest = std::max(state.deepest, *deepest);
    for (const double depth : depths)
      state.largest = std::max(state.largest, std::abs(depth));
    const double middle = positions[deepest - depths.begin()][0], step = (to - from) / n_intervals;
    from = std::max(0., middle - step);
    to = std::min(1., middle + step);
  }
}

std::vector<PatchState> patch_states(const BodyInContact<2> &body) {
  const ContactSurface<2> &surface = body.surface();
  std::vector<PatchState> states(surface.patches().size());
  TraceValues<2> traces(body.space);
  for (const Piece<2> &piece : surface.pieces()) {
    add_samples(body, piece, traces, states[piece.patch]);
  }
  for (unsigned int k = 0; k < body.multipliers.n_multipliers(); ++k)
    if (body.P.presses(k))
      states[body.multipliers.patch_of(k)].presses = true;
  return states;
}
} // namespace

std::vector<unsigned int> missed_contact_cells(const BodyInContact<2> &body) {
  constexpr double rounding = 1e-10, noticeable = 1e-3;
  const std::vector<PatchState> states = patch_states(body);
  double largest = 0.;
  bool touches = false;
  for (const PatchState &state : states) {
    largest = std::max(largest, state.largest);
    touches = touches || state.presses;
  }
  const double tolerance = largest * (touches ? noticeable : rounding);
  std::vector<unsigned int> cells;
  for (std::size_t patch = 0; patch < states.size(); ++patch) {
    const auto presses = [&](const std::size_t other) {
      return other < states.size() && states[other].presses;
    };
    if (states[patch].deepest > tolerance && !presses(patch) && !presses(patch + 1) &&
        !(patch > 0 && presses(patch - 1)))
      cells.insert(cells.end(), states[patch].cells.begin(), states[patch].cells.end());
  }
  return cells;
}
} // namespace Signorini
