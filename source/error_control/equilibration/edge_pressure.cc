// SPDX-License-Identifier: LGPL-2.1-or-later
// The tractions that sides give: those of traction sides, and pressures that do not pull.

#include <signorini/error_control/equilibration/best_stress.h>
#include <signorini/postprocessing/fields/forces.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini {
namespace {
/** Returns the coefficients of Bernstein, of degree n, of a sum of orthonormal Legendre polynomials
 * of degrees 0 to n. Where none is positive, the polynomial is not positive on [0,1]. */
std::vector<double> bernstein_coefficients(const std::vector<double> &legendre) {
  const unsigned int n = legendre.size() - 1;
  std::vector<double> sum(n + 1, 0.);
  for (unsigned int k = 0; k <= n; ++k) {
    // P_k has the coefficients (-1)^{k-i} (k choose i); then the degree is raised to n.
    std::vector<double> b = {k % 2 == 0 ? 1. : -1.};
    for (unsigned int i = 1; i <= k; ++i)
      b.push_back(-b.back() * (k - i + 1) / i);
    for (unsigned int degree = k; degree < n; ++degree) {
      std::vector<double> raised(degree + 2);
      for (unsigned int i = 0; i <= degree + 1; ++i)
        raised[i] = (i > 0 ? b[i - 1] * i / (degree + 1.) : 0.) +
                    (i <= degree ? b[i] * (degree + 1. - i) / (degree + 1.) : 0.);
      b = std::move(raised);
    }
    for (unsigned int i = 0; i <= n; ++i)
      sum[i] += std::sqrt(2. * k + 1.) * legendre[k] * b[i];
  }
  return sum;
}

double bernstein_value(std::vector<double> b, const double s) {
  for (; b.size() > 1; b.pop_back())
    for (std::size_t i = 0; i + 1 < b.size(); ++i)
      b[i] = (1. - s) * b[i] + s * b[i + 1];
  return b[0];
}
} // namespace

void BestStress::give_tractions() {
  FaceValues<2> values(data_.space.mesh().mapping(), data_.space, data_.scene.kinks, 6,
                       update_quadrature_points | update_JxW_values | update_normal_vectors);
  dealii::Vector<double> t(2);
  for (const auto &cell : cells_)
    for (const unsigned int f : cell->face_indices()) {
      if (!cell->at_boundary(f) ||
          data_.scene.boundary[cell->face(f)->boundary_id()].role != Role::traction)
        continue;
      const unsigned int number = mesh_.edge_of_line(cell->face(f)->index());
      const TractionEdge &edge = mesh_.edges()[number];
      const FEFaceValues<2> &rule = values.reinit(cell, f);
      std::array<double, 2> squares = {{0., 0.}};
      for (const unsigned int q : rule.quadrature_point_indices()) {
        data_.scene.boundary[edge.side].data->vector_value(rule.quadrature_point(q), t);
        const Tensor<1, 2> &n = rule.normal_vector(q);
        const std::array<double, 2> parts = {
          {n[0] * t[0] + n[1] * t[1], n[0] * t[1] - n[1] * t[0]}};
        const auto L = legendre_values(edge.degree, edge.start.distance(rule.quadrature_point(q)) /
                                                      edge.length());
        for (unsigned int c = 0; c < 2; ++c) {
          squares[c] += rule.JxW(q) * parts[c] * parts[c];
          for (unsigned int i = 0; i <= edge.degree; ++i)
            x_[edge.position(c, i)] += rule.JxW(q) / edge.length() * L[i] * parts[c];
        }
      }
      for (unsigned int c = 0; c < 2; ++c) {
        double rest = squares[c];
        for (unsigned int i = 0; i <= edge.degree; ++i)
          rest -= edge.length() * std::pow(x_[edge.position(c, i)], 2);
        // The root of rounding is not rounding.
        (c == 0 ? normal_rest_ : shear_rest_)[number] =
          rest > 1e-14 * squares[c] ? std::sqrt(rest) : 0.;
      }
    }
}

std::vector<PrescribedEdge> BestStress::prescribed_edges() const {
  std::vector<PrescribedEdge> edges;
  for (unsigned int c = 0; c < cells_.size(); ++c)
    for (unsigned int k = 0; k < 4; ++k) {
      const TractionCell &cell = mesh_.cells()[c];
      const unsigned int side = mesh_.edges()[cell.sides[k].edge].side;
      if (side == TractionEdge::no_side || data_.scene.boundary[side].role != Role::displacement)
        continue;
      const CellField u(data_.space.dof_cell(cells_[c]), data_.U);
      // Sides 0 and 2 run along the first reference coordinate, 2 and 3 backwards.
      edges.push_back(
        {c, k, side, cell.corners[k], cell.corners[(k + 1) % 4], [u, k](const double s) {
           const unsigned int p = u.degree();
           const LineTable line = make_line_table(p, {k < 2 ? s : 1. - s});
           Tensor<1, 2> value;
           for (unsigned int d = 0; d < 2; ++d)
             for (unsigned int i = 0; i <= p; ++i)
               value[d] += line.values(0, i) *
                           (k % 2 == 0 ? u(d, i, k == 0 ? 0 : p) : u(d, k == 1 ? p : 0, i));
           return value;
         }});
    }
  return edges;
}

void BestStress::press_by_multipliers(const std::size_t face) {
  const ContactSurface<2> &surface = data_.multipliers.surface();
  const unsigned int number = contact_edges_[face];
  const TractionEdge &edge = mesh_.edges()[number];
  const QGauss<1> gauss(edge.degree + 1);
  std::vector<double> p(edge.degree + 1, 0.);
  for (const Piece<2> &piece : surface.pieces())
    if (piece.face == face)
      for (unsigned int q = 0; q < gauss.size(); ++q) {
        const double s = gauss.point(q)[0],
                     length = piece.upper_on_face[0] - piece.lower_on_face[0];
        const auto L = legendre_values(edge.degree, piece.lower_on_face[0] + s * length);
        const double value = data_.multipliers.value(data_.P, piece.patch,
                                                     piece.lower + s * (piece.upper - piece.lower));
        for (unsigned int i = 0; i < p.size(); ++i)
          p[i] += gauss.weight(q) * std::abs(length) * L[i] * value;
      }
  std::vector<double> b = bernstein_coefficients(p);
  if (std::any_of(b.begin(), b.end(), [](const double value) { return value > 0.; })) {
    // The same force, where it presses: the mean of the coefficients is that of the polynomial.
    const double force = std::accumulate(b.begin(), b.end(), 0.);
    for (double &value : b)
      value = std::min(0., value);
    const double pressing = std::accumulate(b.begin(), b.end(), 0.);
    for (double &value : b)
      value *= force < 0. ? force / pressing : 0.;
    p.assign(p.size(), 0.);
    for (unsigned int q = 0; q < gauss.size(); ++q) {
      const auto L = legendre_values(edge.degree, gauss.point(q)[0]);
      for (unsigned int i = 0; i < p.size(); ++i)
        p[i] += gauss.weight(q) * L[i] * bernstein_value(b, gauss.point(q)[0]);
    }
  }
  mesh_.set_free(number, 0, false);
  for (unsigned int i = 0; i < p.size(); ++i)
    x_[edge.position(0, i)] = p[i];
}

void BestStress::give_contact() {
  const ContactSurface<2> &surface = data_.multipliers.surface();
  for (const ContactFace<2> &face : surface.faces())
    contact_edges_.push_back(mesh_.edge_of_line(face.cell->face(face.face_no)->index()));
  const double threshold = pressing_threshold(data_.P);
  std::vector<bool> presses(surface.faces().size(), true);
  for (const Piece<2> &piece : surface.pieces())
    for (unsigned int k = data_.multipliers.first_of(piece.patch);
         k < data_.multipliers.first_of(piece.patch + 1); ++k)
      if (!(data_.P[k] < threshold))
        presses[piece.face] = false;
  for (std::size_t face = 0; face < presses.size(); ++face) {
    press_by_multipliers(face);
    mesh_.set_free(contact_edges_[face], 0, presses[face]);
  }
}

bool BestStress::fix_pulling_edges() {
  bool fixed = false;
  for (std::size_t face = 0; face < contact_edges_.size(); ++face) {
    const TractionEdge &edge = mesh_.edges()[contact_edges_[face]];
    if (!edge.is_free[0])
      continue;
    std::vector<double> p;
    for (unsigned int i = 0; i <= edge.degree; ++i)
      p.push_back(x_[edge.position(0, i)]);
    const std::vector<double> b = bernstein_coefficients(p);
    if (std::none_of(b.begin(), b.end(), [](const double value) { return value > 0.; }))
      continue;
    press_by_multipliers(face);
    fixed = true;
  }
  return fixed;
}

void BestStress::add_plate_conditions() {
  for (const Plate &plate : data_.scene.plates) {
    TractionCondition force, moment;
    for (const TractionEdge &edge : mesh_.edges()) {
      if (edge.side != plate.side)
        continue;
      const Side<2> &side = data_.scene.geometry.sides[plate.side];
      const Point<2> middle = edge.start + 0.5 * (edge.end - edge.start);
      const double length = edge.length();
      const Tensor<1, 2> n = side.normal(side.arc_length(middle)), t({-n[1], n[0]}),
                         arm = middle - plate.centre;
      const double slope = (t * (edge.end - edge.start)) / std::sqrt(12.) * length;
      const std::array<Tensor<1, 2>, 2> directions = {{n, t}};
      for (unsigned int c = 0; c < 2; ++c) {
        force.row.emplace_back(edge.position(c, 0), length * (directions[c] * plate.direction));
        moment.row.emplace_back(edge.position(c, 0), length * cross(arm, directions[c]));
      }
      moment.row.emplace_back(edge.position(0, 1), -slope);
    }
    force.value = plate.force;
    moment.value = plate.moment;
    if (plate.is_pushed)
      conditions_.push_back(force);
    if (plate.turns)
      conditions_.push_back(moment);
  }
}

std::vector<FaceField> BestStress::face_fields() const {
  std::vector<FaceField> fields;
  for (const unsigned int number : contact_edges_) {
    const TractionEdge &edge = mesh_.edges()[number];
    Polynomials::Polynomial<double> sum(0);
    for (unsigned int i = 0; i <= edge.degree; ++i) {
      Polynomials::Polynomial<double> term = Polynomials::Legendre(i);
      term *= x_[edge.position(0, i)];
      sum += term;
    }
    fields.push_back({0., sum});
  }
  return fields;
}

double BestStress::change_of_force() const {
  double change = -(data_.P * data_.multipliers.integrals());
  for (const unsigned int number : contact_edges_)
    change += mesh_.edges()[number].length() * x_[mesh_.edges()[number].position(0, 0)];
  return change;
}
} // namespace Signorini
