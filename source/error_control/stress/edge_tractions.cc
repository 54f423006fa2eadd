// SPDX-License-Identifier: LGPL-2.1-or-later
// Moments of tractions: those that are given, and those that follow around every vertex.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/loads/cell_loads.h>
#include <signorini/error_control/stress/edge_tractions.h>
#include <signorini/problem/scene/functions.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Signorini {
namespace {
/** A traction t at position s in [0,1] of an edge, with a weight (length). */
struct TractionPoint {
  double s, weight;
  Tensor<1, 2> t;
};

/** The moments of a traction on an edge, and the norms of what they leave. */
struct EdgeTraction {
  EdgeTraction(const std::vector<TractionPoint> &points, const Edge &edge) {
    for (const auto &[s, weight, t] : points) {
      moments[0] += (1. - s) * weight * t;
      moments[1] += s * weight * t;
    }
    for (const auto &[s, weight, t] : points) {
      const Tensor<1, 2> rest = t - linear_traction(&moments[0][0], s) / edge.length;
      const double normal_part = rest * edge.normal;
      normal_rest += weight * normal_part * normal_part;
      shear_rest += weight * (rest - normal_part * edge.normal).norm_square();
    }
    normal_rest = std::sqrt(normal_rest);
    shear_rest = std::sqrt(shear_rest);
  }
  void give(const unsigned int edge, GivenTractions &given) const {
    for (unsigned int i = 0; i < 4; ++i)
      given.moments[4 * edge + i] = moments[i / 2][i % 2];
    given.normal_rest[edge] = normal_rest;
    given.shear_rest[edge] = shear_rest;
  }

  std::array<Tensor<1, 2>, 2> moments;
  double normal_rest = 0., shear_rest = 0.;
};

/** Returns a traction at quadrature points; the hat function of vertex @p second_end of the cell,
 * the second end of the edge, is the share of the length on straight edges. */
std::vector<TractionPoint> sample(const FEFaceValues<2> &values, const Function<2> &traction,
                                  const unsigned int second_end) {
  std::vector<TractionPoint> points;
  dealii::Vector<double> t(2);
  for (const unsigned int q : values.quadrature_point_indices()) {
    traction.vector_value(values.quadrature_point(q), t);
    points.push_back(
      {values.shape_value(2 * second_end, q), values.JxW(q), Tensor<1, 2>({t[0], t[1]})});
  }
  return points;
}

void add_traction_sides(const BoundData &data, const EdgeMesh &mesh, GivenTractions &given) {
  const auto is_traction = [&](const Edge &edge) {
    return edge.is_boundary() && data.scene.boundary[edge.side].role == Role::traction;
  };
  const std::size_t n_edges = std::count_if(mesh.edges().begin(), mesh.edges().end(), is_traction);
  if (n_edges == 0)
    return;
  const auto make_values = [&](const unsigned int n) {
    return FaceValues<2>(data.space.mesh().mapping(), data.space, data.scene.kinks, n,
                         update_values | update_quadrature_points | update_JxW_values);
  };
  const unsigned int n_fine = std::min<std::size_t>(20000 / n_edges, 256);
  FaceValues<2> values = make_values(data.n_points),
                finer = make_values(std::max(data.n_points, n_fine));
  for (const auto &cell : data.space.mesh().triangulation().active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      const unsigned int number = mesh.edge_of_line(cell->face(f)->index());
      const Edge &edge = mesh.edges()[number];
      if (!is_traction(edge))
        continue;
      const bool reversed = edge.vertices[0] != cell->face(f)->vertex_index(0);
      const unsigned int second_end = GeometryInfo<2>::face_to_cell_vertices(f, reversed ? 0 : 1);
      const Function<2> &t = *data.scene.boundary[edge.side].data;
      EdgeTraction traction(sample(values.reinit(cell, f), t, second_end), edge);
      if (n_fine > data.n_points && !is_constant(t)) {
        const EdgeTraction fine(sample(finer.reinit(cell, f), t, second_end), edge);
        if (!agree(traction.moments, fine.moments, traction.normal_rest + traction.shear_rest,
                   fine.normal_rest + fine.shear_rest, edge.length))
          traction = fine;
      }
      traction.give(number, given);
    }
}

/** Adds p_H n, constant on the pieces face ∩ patch: two Gauss points on each are exact. */
void add_contact_sides(const BoundData &data, const EdgeMesh &mesh, GivenTractions &given) {
  const QGauss<1> gauss(2);
  const ContactSurface<2> &surface = data.multipliers.surface();
  std::map<unsigned int, std::vector<TractionPoint>> points;
  for (const Piece<2> &piece : surface.pieces()) {
    const ContactFace<2> &face = surface.faces()[piece.face];
    const auto line = face.cell->face(face.face_no);
    const unsigned int number = mesh.edge_of_line(line->index());
    const Edge &edge = mesh.edges()[number];
    const double from = piece.lower_on_face[0], length = piece.upper_on_face[0] - from;
    for (unsigned int q = 0; q < gauss.size(); ++q) {
      const double s = from + length * gauss.point(q)[0];
      points[number].push_back(
        {edge.vertices[0] == line->vertex_index(0) ? s : 1. - s,
         gauss.weight(q) * std::abs(length) * edge.length,
         data.multipliers.value(data.P, piece.patch, piece.lower) * edge.normal});
    }
  }
  for (const auto &[number, on_edge] : points) {
    EdgeTraction traction(on_edge, mesh.edges()[number]);
    // A constant leaves rounding only.
    if (on_edge.size() == gauss.size())
      traction.normal_rest = traction.shear_rest = 0.;
    traction.give(number, given);
  }
}
} // namespace

GivenTractions given_tractions(const BoundData &data, const EdgeMesh &mesh) {
  GivenTractions given = {std::vector<double>(mesh.n_moments(), 0.),
                          std::vector<double>(mesh.edges().size(), 0.),
                          std::vector<double>(mesh.edges().size(), 0.)};
  add_traction_sides(data, mesh, given);
  add_contact_sides(data, mesh, given);
  return given;
}

void give_to_contact(const EdgeMesh &mesh, const Scene<2> &scene,
                     const std::vector<Tensor<1, 2>> &rest, GivenTractions &given) {
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const Star &star = mesh.stars()[v];
    if (star.cells.empty() || star.is_closed())
      continue;
    std::vector<std::pair<const Spoke *, double>> touching;
    for (const auto &[spoke, sign] :
         {std::make_pair(&star.spokes.front(), 1.), std::make_pair(&star.spokes.back(), -1.)})
      if (scene.boundary[mesh.edges()[spoke->edge].side].role == Role::contact)
        touching.emplace_back(spoke, sign * spoke->sign);
    for (const auto &[spoke, sign] : touching)
      for (unsigned int c = 0; c < 2; ++c)
        given.moments[4 * spoke->edge + 2 * spoke->end + c] +=
          sign * star.cells.size() / touching.size() * rest[v][c];
  }
}

EdgeMoments solve_stars(const EdgeMesh &mesh, const std::vector<CornerForces> &R,
                        const std::vector<double> &given, const std::vector<double> &guess) {
  EdgeMoments result = {std::vector<double>(mesh.n_moments(), 0.),
                        std::vector<Tensor<1, 2>>(mesh.stars().size())};
  std::vector<Tensor<1, 2>> sum;
  for (unsigned int vertex = 0; vertex < mesh.stars().size(); ++vertex) {
    const Star &star = mesh.stars()[vertex];
    const unsigned int n = star.cells.size(), n_spokes = star.spokes.size();
    if (n == 0)
      continue;
    const auto moment_of_spoke = [&](const unsigned int j, const std::vector<double> &moments) {
      const Spoke &spoke = star.spokes[j];
      const double *const at = &moments[4 * spoke.edge + 2 * spoke.end];
      return spoke.sign * Tensor<1, 2>({at[0], at[1]});
    };
    // The moment on spoke j is c - sum[j].
    sum.assign(n + 1, {});
    for (unsigned int j = 0; j < n; ++j)
      sum[j + 1] = sum[j] + R[star.cells[j].cell][star.cells[j].number];
    Tensor<1, 2> c;
    for (unsigned int j = 0; j < n_spokes; ++j)
      c += (moment_of_spoke(j, guess) + sum[j]) / n_spokes;
    Tensor<1, 2> rest = sum[n];
    if (!star.is_closed()) {
      // What the first edge gives is kept; in the directions P that it leaves, c fits the last one.
      const Tensor<2, 2> P = mesh.edges()[star.spokes[0].edge].projection();
      const Tensor<2, 2> Q =
        unit_symmetric_tensor<2>() - mesh.edges()[star.spokes[n].edge].projection();
      const Tensor<1, 2> first = moment_of_spoke(0, given),
                         last = moment_of_spoke(n, given) + sum[n];
      c = P * c + (first - P * first);
      const Tensor<1, 2> lacking = P * (Q * (last - c));
      for (const auto &[share, direction] : eigenvectors(symmetrize(P * Q * P)))
        // The square of the sine of an angle; smaller ones are rounding of P Q P.
        if (share > 1e-12)
          c += (direction * lacking) / share * direction;
      // With R - rest/n in place of R the moment on the last spoke is c - sum[n] + rest.
      rest = Q * (last - c);
    }
    result.rest[vertex] = rest / n;
    for (unsigned int j = 0; j < n_spokes; ++j) {
      const Spoke &spoke = star.spokes[j];
      const Tensor<1, 2> b =
        spoke.sign * (c - sum[j] + static_cast<double>(j) * result.rest[vertex]);
      for (unsigned int d = 0; d < 2; ++d)
        result.moments[4 * spoke.edge + 2 * spoke.end + d] = b[d];
    }
  }
  return result;
}
} // namespace Signorini
