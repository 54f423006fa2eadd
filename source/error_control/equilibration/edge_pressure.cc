// SPDX-License-Identifier: LGPL-2.1-or-later
// The tractions that sides give: those of traction sides, and pressures that do not pull.

#include <signorini/error_control/equilibration/bernstein.h>
#include <signorini/error_control/equilibration/best_stress.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace Signorini {
void BestStress::give_tractions() {
  // About 20000 points on all faces, unless t is constant: narrow tractions are seen.
  const auto is_loaded = [this](const auto &face) {
    return face->at_boundary() && data_.scene.boundary[face->boundary_id()].role == Role::traction;
  };
  unsigned int n_faces = 0;
  for (const auto &face : data_.space.mesh().triangulation().active_face_iterators())
    if (is_loaded(face) && !is_constant(*data_.scene.boundary[face->boundary_id()].data))
      ++n_faces;
  const unsigned int n_points = n_faces > 0 ? std::clamp(20000 / n_faces, 6U, 96U) : 6;
  FaceValues<2> values(StaticMappingQ1<2>::mapping, data_.space, data_.scene.kinks, n_points,
                       update_quadrature_points | update_JxW_values | update_normal_vectors);
  dealii::Vector<double> t(2);
  rests_.fill(std::vector<double>(mesh_->edges().size(), 0.));
  for (const auto &cell : data_.space.mesh().triangulation().active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      if (!is_loaded(cell->face(f)))
        continue;
      const unsigned int number = mesh_->edge_at(cell, f);
      const TractionEdge &edge = mesh_->edges()[number];
      const FEFaceValues<2> &rule = values.reinit(cell, f);
      for (const unsigned int q : rule.quadrature_point_indices()) {
        data_.scene.boundary[edge.side].data->vector_value(rule.quadrature_point(q), t);
        const Tensor<1, 2> &n = rule.normal_vector(q);
        const std::array<double, 2> parts = {
          {n[0] * t[0] + n[1] * t[1], n[0] * t[1] - n[1] * t[0]}};
        const auto L = legendre_values(edge.degree, edge.start.distance(rule.quadrature_point(q)) /
                                                      edge.length());
        for (unsigned int c = 0; c < 2; ++c) {
          rests_[c][number] += rule.JxW(q) * parts[c] * parts[c];
          for (unsigned int i = 0; i <= edge.degree; ++i)
            x_[edge.position(c, i)] += rule.JxW(q) / edge.length() * L[i] * parts[c];
        }
      }
    }
  for (unsigned int c = 0; c < 2; ++c)
    for (std::size_t number = 0; number < mesh_->edges().size(); ++number)
      if (double &rest = rests_[c][number]; rest > 0.) {
        const TractionEdge &edge = mesh_->edges()[number];
        const double square = rest;
        for (unsigned int i = 0; i <= edge.degree; ++i)
          rest -= edge.length() * std::pow(x_[edge.position(c, i)], 2);
        // The root of rounding is not rounding.
        rest = rest > 1e-14 * square ? std::sqrt(rest) : 0.;
      }
}

std::vector<double> BestStress::projection_of(const Pressure &P, const unsigned int number) const {
  const TractionEdge &edge = mesh_->edges()[number];
  const QGauss<1> gauss(edge.degree + 1);
  std::vector<double> p(edge.degree + 1, 0.);
  const auto &pieces = data_.multipliers.surface().pieces();
  for (const Piece<2> &piece : pieces) {
    if (contact_edges_[piece.face] != number)
      continue;
    const Side<2> &side = data_.scene.geometry.sides[edge.side];
    const auto position = [&](const Point<1> &s) {
      return edge.start.distance(side.point(s[0])) / edge.length();
    };
    const double from = position(piece.lower), to = position(piece.upper);
    for (unsigned int q = 0; q < gauss.size(); ++q) {
      const double s = gauss.point(q)[0];
      const auto L = legendre_values(edge.degree, from + s * (to - from));
      const double value =
        data_.multipliers.value(P, piece.patch, piece.lower + s * (piece.upper - piece.lower));
      for (unsigned int i = 0; i < p.size(); ++i)
        p[i] += gauss.weight(q) * std::abs(to - from) * L[i] * value;
    }
  }
  return p;
}

void BestStress::fix_edge(const unsigned int number, const unsigned int component,
                          const std::vector<double> &legendre) {
  mesh_->set_free(number, component, false);
  for (unsigned int i = 0; i < legendre.size(); ++i)
    x_[mesh_->edges()[number].position(component, i)] = legendre[i];
}

std::vector<double> BestStress::coefficients(const unsigned int number,
                                             const unsigned int component) const {
  const TractionEdge &edge = mesh_->edges()[number];
  std::vector<double> legendre;
  for (unsigned int i = 0; i <= edge.degree; ++i)
    legendre.push_back(x_[edge.position(component, i)]);
  return legendre;
}

void BestStress::press_by_multipliers(const unsigned int number) {
  std::vector<double> p = projection_of(data_.P.normal(), number), b = bernstein_coefficients(p);
  if (std::any_of(b.begin(), b.end(), [](const double value) { return value > 0.; })) {
    // The same force, where it presses: the mean of the coefficients is that of the polynomial.
    const double force = std::accumulate(b.begin(), b.end(), 0.);
    for (double &value : b)
      value = std::min(0., value);
    const double pressing = std::accumulate(b.begin(), b.end(), 0.);
    for (double &value : b)
      value *= force < 0. ? force / pressing : 0.;
    p = legendre_coefficients(b);
  }
  fix_edge(number, 0, p);
}

void BestStress::give_contact() {
  const ContactSurface<2> &surface = data_.multipliers.surface();
  contact_edges_.clear();
  for (const ContactFace<2> &face : surface.faces())
    contact_edges_.push_back(mesh_->edge_at(face.cell, face.face_no));
  const std::vector<NodeState> of_patches = patch_states(data_.multipliers, data_.P);
  std::map<unsigned int, bool> presses;
  for (const Piece<2> &piece : surface.pieces()) {
    bool &on_edge = presses.emplace(contact_edges_[piece.face], true).first->second;
    on_edge = on_edge && of_patches[piece.patch].presses;
  }
  // Next to an edge that is open the best traction would pull.
  std::map<unsigned int, bool> is_free = presses;
  for (std::size_t i = 0; i + 1 < contact_edges_.size(); ++i)
    if (const unsigned int here = contact_edges_[i], next = contact_edges_[i + 1];
        mesh_->edges()[here].side == mesh_->edges()[next].side && !(presses[here] && presses[next]))
      is_free[here] = is_free[next] = false;
  for (const auto &[edge, free] : is_free) {
    press_by_multipliers(edge);
    // With Coulomb's law the bound of friction needs a τ_n that is known.
    mesh_->set_free(edge, 0, free && !data_.P.is_coupled());
  }
  if (data_.has_friction())
    give_friction();
}

bool BestStress::fix_pulling_edges() {
  bool fixed = false;
  for (const unsigned int number : contact_edges_) {
    const TractionEdge &edge = mesh_->edges()[number];
    if (edge.is_free[0]) {
      const std::vector<double> b = bernstein_coefficients(coefficients(number, 0));
      if (std::any_of(b.begin(), b.end(), [](const double value) { return value > 0.; })) {
        press_by_multipliers(number);
        fixed = true;
      }
    }
    if (edge.is_free[1] && !is_within_friction(number)) {
      rub_by_multipliers(number);
      fixed = true;
    }
  }
  return fixed;
}

void BestStress::add_plate_conditions() {
  for (const Plate &plate : data_.scene.plates) {
    TractionCondition force, moment;
    for (const TractionEdge &edge : mesh_->edges()) {
      if (edge.side != plate.side)
        continue;
      const double length = edge.length();
      const Tensor<1, 2> n = edge.normal(data_.scene.geometry), t({-n[1], n[0]}),
                         arm = edge.start + 0.5 * (edge.end - edge.start) - plate.centre;
      const double slope = (t * (edge.end - edge.start)) / std::sqrt(12.) * length;
      const std::array<Tensor<1, 2>, 2> directions = {{n, t}};
      for (unsigned int c = 0; c < 2; ++c) {
        force.row.emplace_back(edge.position(c, 0), length * (directions[c] * plate.direction));
        moment.row.emplace_back(edge.position(c, 0), length * cross(arm, directions[c]));
      }
      moment.row.emplace_back(edge.position(0, 1), -slope);
    }
    const auto add = [this](TractionCondition condition, const double value) {
      double square = 0.;
      for (const auto &entry : condition.row)
        square += entry.second * entry.second;
      for (auto &entry : condition.row)
        entry.second /= std::sqrt(square);
      condition.value = value / std::sqrt(square);
      conditions_.push_back(std::move(condition));
    };
    if (plate.is_pushed)
      add(std::move(force), plate.force);
    if (plate.turns)
      add(std::move(moment), plate.moment);
  }
}

std::vector<FaceField> BestStress::face_fields(const bool interpolated) const {
  std::vector<FaceField> fields;
  for (std::size_t i = 0; i < contact_edges_.size(); ++i) {
    const ContactFace<2> &face = data_.multipliers.surface().faces()[i];
    const TractionEdge &edge = mesh_->edges()[contact_edges_[i]];
    const auto line = face.cell->face(face.face_no);
    const double along =
                   (edge.end - edge.start) * (line->vertex(1) - line->vertex(0)) > 0. ? 1. : -1.,
                 share = along * line->vertex(0).distance(line->vertex(1)) / edge.length();
    FaceField &field = fields.emplace_back();
    for (unsigned int c = 0; c < 2; ++c) {
      Polynomials::Polynomial<double> &sum = field.traction[c] = Polynomials::Polynomial<double>(0);
      for (unsigned int k = 0; k <= edge.degree; ++k) {
        Polynomials::Polynomial<double> term = Polynomials::Legendre(k);
        term *= x_[edge.position(c, k)];
        sum += term;
      }
      sum.shift(edge.start.distance(line->vertex(0)) / edge.length());
      sum.scale(share);
    }
    if (interpolated)
      field.bubble = fields_->bubbles.at(line->index());
  }
  return fields;
}

double BestStress::change_of_force() const {
  double change = -(data_.P.normal() * data_.multipliers.integrals());
  for (const unsigned int number :
       std::set<unsigned int>(contact_edges_.begin(), contact_edges_.end()))
    change += mesh_->edges()[number].length() * x_[mesh_->edges()[number].position(0, 0)];
  return change;
}
} // namespace Signorini
