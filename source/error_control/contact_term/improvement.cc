// SPDX-License-Identifier: LGPL-2.1-or-later
// Conjugate gradients that bring the stress closer to that of the displacement.

#include <signorini/error_control/stress/balance.h>
#include <signorini/error_control/stress/equilibrated_stress.h>
#include <signorini/error_control/stress/star_solver.h>
#include <signorini/postprocessing/fields/forces.h>

#include <algorithm>
#include <limits>

namespace Signorini {
namespace {
double product(const std::vector<double> &a, const std::vector<double> &b) {
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

/** Adds factor b to a. */
void add(std::vector<double> &a, const double factor, const std::vector<double> &b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] += factor * b[i];
}

constexpr unsigned int max_steps = 50;
/** The improvement stops when a step takes less than this share of the square of the misfit of u_h,
 * and of π^{2h} u_h where there is one. */
constexpr double min_share = 0.01, min_interpolated_share = 0.03;
/** The number of cells up to which the best stress is computed (optimal_change()), and the number
 * up to which it is computed if the steps did not end. */
constexpr std::size_t max_cells_always_direct = 1024, max_cells_direct = 4096;

/** The share of the square of τ below which the misfit is rounding. */
constexpr double rounding = 1e-20;

/** Returns τ_n at both ends of an edge, in the order of Edge::vertices (force/area). */
std::array<double, 2> normal_tractions(const Edge &edge, const unsigned int number,
                                       const std::vector<double> &moments) {
  double a = 0., b = 0.;
  for (unsigned int c = 0; c < 2; ++c) {
    a += moments[4 * number + c] * edge.normal[c];
    b += moments[4 * number + 2 + c] * edge.normal[c];
  }
  return {{(4. * a - 2. * b) / edge.length, (4. * b - 2. * a) / edge.length}};
}

/** Returns those of the edges at an end of which τ_n pulls. */
std::vector<unsigned int> pulling(const EdgeMesh &mesh, const std::vector<unsigned int> &edges,
                                  const std::vector<double> &moments) {
  std::vector<unsigned int> result;
  for (const unsigned int edge : edges) {
    const auto [first, last] = normal_tractions(mesh.edges()[edge], edge, moments);
    if (first > 0. || last > 0.)
      result.push_back(edge);
  }
  return result;
}

/** Returns the contact edges on which p_H presses everywhere: all pieces face ∩ patch are below
 * pressing_threshold(). */
std::vector<unsigned int> pressing_edges(const EdgeMesh &mesh,
                                         const MultiplierSpace<2> &multipliers, const Pressure &P) {
  const ContactSurface<2> &surface = multipliers.surface();
  const double threshold = pressing_threshold(P);
  std::vector<bool> presses(surface.faces().size(), true);
  for (const Piece<2> &piece : surface.pieces())
    if (!(multipliers.value(P, piece.patch, piece.lower) < threshold))
      presses[piece.face] = false;
  std::vector<unsigned int> edges;
  for (std::size_t i = 0; i < presses.size(); ++i)
    if (const ContactFace<2> &face = surface.faces()[i]; presses[i])
      edges.push_back(mesh.edge_of_line(face.cell->face(face.face_no)->index()));
  return edges;
}
} // namespace

EquilibratedStress::Residual EquilibratedStress::residual() const {
  Residual result;
  result.r.assign(moments_.size(), 0.);
  for (unsigned int c = 0; c < mesh_.cells().size(); ++c) {
    const CellIntegrals &cell = integrals_[c];
    result.square += cell.misfit.value;
    result.interpolated_square += cell.interpolated_part.value;
    result.energy += cell.stress.value;
    CellMoments force = cell.misfit.gradient;
    for (double &value : force)
      value *= -1.;
    add_moments(mesh_.cells()[c], force, result.r);
  }
  if (!bubbles_)
    result.interpolated_square = std::numeric_limits<double>::infinity();
  return result;
}

std::vector<double> EquilibratedStress::improve(const CellEnergies &energies) {
  Residual at_start = residual();
  std::vector<unsigned int> free;
  if (bubbles_)
    free = pressing_edges(mesh_, data_.multipliers, data_.P);
  for (const unsigned int edge : free) {
    mesh_.set_freedom(edge, EdgeFreedom::normal);
    // ∫_e b.δ τ n with δ τ n from its moments: what the residual of π^{2h} u_h has
    // more than that of u_h, for stresses without loads.
    for (unsigned int i = 0; i < 4; ++i)
      at_start.r[4 * edge + i] += 2. / 3. * bubbles_->edges[edge][i % 2];
  }
  const std::vector<double> start = moments_;
  if (at_start.square > rounding * at_start.energy) {
    StarSolver solver(mesh_, energies, n_threads());
    for (;;) {
      const auto edges = iterate(at_start, solver, energies, free);
      if (edges.empty())
        break;
      moments_ = start;
      for (const unsigned int edge : edges) {
        free.erase(std::find(free.begin(), free.end(), edge));
        mesh_.set_freedom(edge, EdgeFreedom::none);
      }
      for (const unsigned int edge : edges)
        for (const unsigned int vertex : mesh_.edges()[edge].vertices)
          solver.renew(vertex);
    }
  }
  for (const unsigned int edge : free)
    given_.normal_rest[edge] = 0.;
  std::vector<double> change = moments_;
  add(change, -1., start);
  return change;
}

std::vector<unsigned int> EquilibratedStress::iterate(Residual left, const StarSolver &solver,
                                                      const CellEnergies &energies,
                                                      const std::vector<unsigned int> &free) {
  const Steps steps = improve_step_by_step(left, solver, free);
  const std::size_t n_cells = mesh_.cells().size();
  // Where a force drives a plate, the stress carries that force. Changes around single vertices do
  // not alter it, but the best of all stresses may.
  const auto &plates = data_.scene.plates;
  const bool is_driven = std::any_of(plates.begin(), plates.end(), [](const Plate &plate) {
    return plate.is_pushed || plate.turns;
  });
  if (is_driven || !steps.pulling.empty() || left.square <= rounding * left.energy ||
      n_cells > max_cells_direct || (steps.settled && n_cells > max_cells_always_direct))
    return steps.pulling;
  const std::vector<double> change = optimal_change(mesh_, energies, left.r);
  if (change.empty())
    return {};
  add(moments_, 1., change);
  return pulling(mesh_, free, moments_);
}

EquilibratedStress::Steps EquilibratedStress::improve_step_by_step(
  Residual &left, const StarSolver &solver, const std::vector<unsigned int> &free) {
  std::vector<double> z(left.r.size(), 0.), q(left.r.size(), 0.);
  solver.apply(left.r, z);
  std::vector<double> p = z;
  double rz = product(left.r, z);
  unsigned int step = 0;
  while (rz > 0. && left.square > rounding * left.energy && step++ < max_steps) {
    solver.multiply(p, q);
    const double alpha = rz / product(p, q), decrease = alpha * rz;
    if (!(decrease > 0.))
      return {{}, true};
    add(moments_, alpha, p);
    add(left.r, -alpha, q);
    if (const auto edges = pulling(mesh_, free, moments_); !edges.empty())
      return {edges, false};
    left.square -= decrease;
    left.interpolated_square -= decrease;
    // Rounding may make the square for π^{2h} u_h negative.
    const double least = std::min(min_share * left.square,
                                  min_interpolated_share * std::max(0., left.interpolated_square));
    if (decrease < least || left.square < 0.)
      return {{}, true};
    solver.apply(left.r, z);
    const double new_rz = product(left.r, z), beta = new_rz / rz;
    rz = new_rz;
    for (std::size_t i = 0; i < p.size(); ++i)
      p[i] = z[i] + beta * p[i];
  }
  return {};
}

std::vector<FaceField> EquilibratedStress::face_fields(const bool interpolated) const {
  std::vector<FaceField> fields;
  for (const ContactFace<2> &face : data_.multipliers.surface().faces()) {
    FaceField &field = fields.emplace_back();
    const auto line = face.cell->face(face.face_no);
    const unsigned int number = mesh_.edge_of_line(line->index());
    const Edge &edge = mesh_.edges()[number];
    if (interpolated)
      field.bubble = bubbles_->edges[number] * edge.normal;
    if (edge.freedom != EdgeFreedom::normal)
      continue;
    auto [first, last] = normal_tractions(edge, number, moments_);
    if (edge.vertices[0] != line->vertex_index(0))
      std::swap(first, last);
    field.traction.emplace(std::vector<double>{first, last - first});
  }
  return fields;
}
} // namespace Signorini
