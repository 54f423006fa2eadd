// SPDX-License-Identifier: LGPL-2.1-or-later
// The sums over cells of a stress in equilibrium, and its tractions on contact faces.

#include <signorini/error_control/equilibration/equilibrated_stress.h>
#include <signorini/error_control/equilibration/oscillation.h>

#include <deal.II/base/polynomial.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
double EquilibratedStress::distance(const std::size_t cell) const {
  AssertIndexRange(cell, fits.size());
  const CellFit &fit = fits[cell];
  const dealii::Vector<double> y = fit.traces(tractions.space, cell, tractions.x);
  return fit.size * std::sqrt(fit.rest * fit.rest + std::max(0., y * fit.airy->multiply(y)));
}

double EquilibratedStress::oscillation(const std::size_t cell, const bool of_pairs) const {
  AssertIndexRange(cell, fits.size());
  const TractionCell &edges_of_cell = tractions.space.cells()[cell];
  const CellFit &fit = fits[cell];
  const auto &[normal, shear] = tractions.rests;
  std::vector<unsigned int> sides;
  for (unsigned int k = 0; k < 4; ++k)
    if (const unsigned int edge = edges_of_cell.sides[k].edge;
        normal[edge].norm + shear[edge].norm > 0. &&
        (of_pairs || tractions.space.shared_parts(edge).empty()))
      sides.push_back(k);
  if (fit.load_rest == 0. && sides.empty())
    return 0.;
  const OscillationConstants constants(edges_of_cell.shape, fit.airy->degree() - 1);
  double sum = constants.body * fit.load_rest;
  for (const unsigned int k : sides) {
    const unsigned int edge = edges_of_cell.sides[k].edge;
    sum += constants.normal(k, normal[edge]) + constants.edge[k] * shear[edge].norm;
  }
  return sum / std::sqrt(fit.min_eigenvalue);
}

double EquilibratedStress::load_oscillation(const std::size_t cell) const {
  AssertIndexRange(cell, fits.size());
  const CellFit &fit = fits[cell];
  if (fit.load_rest == 0.)
    return 0.;
  return OscillationConstants(tractions.space.cells()[cell].shape, fit.airy->degree() - 1).body *
         fit.load_rest / std::sqrt(fit.min_eigenvalue);
}

double EquilibratedStress::distance_square() const {
  double square = 0.;
  for (std::size_t c = 0; c < fits.size(); ++c)
    square += std::pow(distance(c), 2);
  return square;
}

double EquilibratedStress::oscillation_square() const {
  double square = 0.;
  for (std::size_t c = 0; c < fits.size(); ++c)
    square += std::pow(oscillation(c), 2);
  return square;
}

double EquilibratedStress::contact_force(const Scene<2> &scene) const {
  double force = 0.;
  for (const TractionEdge &edge : tractions.space.edges())
    if (edge.side != TractionEdge::no_side && !edge.is_shared && scene.has_contact_on(edge.side))
      force += edge.length() * tractions.x[edge.position(0, 0)];
  return force;
}

std::vector<FaceTractions>
EquilibratedStress::face_tractions(const ContactSurface<2> &surface) const {
  std::vector<FaceTractions> tractions_of_faces;
  for (const ContactFace<2> &face : surface.faces()) {
    const unsigned int number = tractions.space.contact_edge_at(face.cell, face.face_no);
    const auto line = face.cell->face(face.face_no);
    FaceTractions &on_face = tractions_of_faces.emplace_back();
    for (unsigned int c = 0; c < 2 && number != TractionSpace::none; ++c) {
      const TractionEdge &edge = tractions.space.edges()[number];
      const double from = edge.position_of(line->vertex(0)),
                   share = edge.position_of(line->vertex(1)) - from;
      Polynomials::Polynomial<double> &sum = on_face[c] = Polynomials::Polynomial<double>(0);
      for (unsigned int k = 0; k <= edge.degree; ++k) {
        Polynomials::Polynomial<double> term = Polynomials::Legendre(k);
        term *= tractions.x[edge.position(c, k)];
        sum += term;
      }
      sum.shift(from);
      sum.scale(share);
    }
  }
  return tractions_of_faces;
}
} // namespace Signorini
