// SPDX-License-Identifier: LGPL-2.1-or-later
// Moments of tractions: those that are given, and those that follow around every vertex.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/loads/cell_loads.h>
#include <signorini/error_control/stress/edge_tractions.h>
#include <signorini/problem/scene/functions.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Signorini
{
namespace
{
/** The moments of t on one edge of a traction side, and the norms of what they leave. */
struct EdgeTraction
{
  /**
   * Integrates t.
   * @param second_end the corner of the cell that is the second end of the edge. Its hat function
   * is the share of the length on straight edges.
   */
  EdgeTraction(const FEFaceValues<2> &values,
               const Function<2> &traction,
               const Edge &edge,
               const unsigned int second_end)
  {
    const auto &points = values.get_quadrature_points();
    std::vector<dealii::Vector<double>> t(points.size(), dealii::Vector<double>(2));
    traction.vector_value_list(points, t);
    std::array<double, 4> both{};
    for (unsigned int i = 0; i < t.size(); ++i)
      for (unsigned int c = 0; c < 2; ++c)
      {
        const double s = values.shape_value(2 * second_end, i);
        both[c] += (1. - s) * t[i][c] * values.JxW(i);
        both[2 + c] += s * t[i][c] * values.JxW(i);
      }
    double shear_square = 0., normal_square = 0.;
    for (unsigned int i = 0; i < t.size(); ++i)
    {
      const double s = values.shape_value(2 * second_end, i);
      const Tensor<1, 2> rest =
        Tensor<1, 2>({t[i][0], t[i][1]}) - linear_traction(both.data(), s) / edge.length;
      const double normal_part = rest * edge.normal;
      normal_square += normal_part * normal_part * values.JxW(i);
      shear_square += (rest - normal_part * edge.normal).norm_square() * values.JxW(i);
    }
    moments = {{Tensor<1, 2>({both[0], both[1]}), Tensor<1, 2>({both[2], both[3]})}};
    normal_rest = std::sqrt(normal_square);
    shear_rest = std::sqrt(shear_square);
  }

  std::array<Tensor<1, 2>, 2> moments;
  double normal_rest, shear_rest;
};

void add_traction_sides(const DisplacementSpace<2> &space,
                        const Scene<2> &scene,
                        const EdgeMesh &mesh,
                        const unsigned int n_points,
                        GivenTractions &given)
{
  const auto is_traction = [&](const Edge &edge) {
    return edge.is_boundary() && scene.boundary[edge.side].role == Role::traction;
  };
  const std::size_t n_edges = std::count_if(mesh.edges().begin(), mesh.edges().end(), is_traction);
  if (n_edges == 0)
    return;
  const auto make_values = [&](const unsigned int n) {
    return FaceValues<2>(space.mesh().mapping(),
                         space,
                         scene.kinks,
                         n,
                         update_values | update_quadrature_points | update_JxW_values);
  };
  const unsigned int n_fine = std::min<std::size_t>(20000 / n_edges, 256);
  FaceValues<2> values = make_values(n_points), finer = make_values(std::max(n_points, n_fine));
  for (const auto &cell : space.mesh().triangulation().active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
    {
      const unsigned int number = mesh.edge_of_line(cell->face(f)->index());
      const Edge &edge = mesh.edges()[number];
      if (!is_traction(edge))
        continue;
      const bool reversed = edge.vertices[0] != cell->face(f)->vertex_index(0);
      const unsigned int second_end = GeometryInfo<2>::face_to_cell_vertices(f, reversed ? 0 : 1);
      const Function<2> &t = *scene.boundary[edge.side].data;
      EdgeTraction traction(values.reinit(cell, f), t, edge, second_end);
      if (n_fine > n_points && !is_constant(t))
      {
        const EdgeTraction fine(finer.reinit(cell, f), t, edge, second_end);
        if (!agree(traction.moments,
                   fine.moments,
                   traction.normal_rest + traction.shear_rest,
                   fine.normal_rest + fine.shear_rest,
                   edge.length))
          traction = fine;
      }
      for (unsigned int i = 0; i < 4; ++i)
        given.moments[4 * number + i] = traction.moments[i / 2][i % 2];
      given.normal_rest[number] = traction.normal_rest;
      given.shear_rest[number] = traction.shear_rest;
    }
}

/** A part [from, to] of an edge, as shares of its length, with the constant pressure p. */
struct PressedPart
{
  double from, to, p;
};

/** Returns p_H on the pieces face ∩ patch of every contact edge, along Edge::vertices. */
std::map<unsigned int, std::vector<PressedPart>>
pressed_parts(const EdgeMesh &mesh, const MultiplierSpace<2> &multipliers, const Pressure &P)
{
  const ContactSurface<2> &surface = multipliers.surface();
  std::map<unsigned int, std::vector<PressedPart>> parts;
  for (const Piece<2> &piece : surface.pieces())
  {
    const ContactFace<2> &face = surface.faces()[piece.face];
    const auto line = face.cell->face(face.face_no);
    const unsigned int edge = mesh.edge_of_line(line->index());
    double from = piece.lower_on_face[0], to = piece.upper_on_face[0];
    if (mesh.edges()[edge].vertices[0] != line->vertex_index(0))
    {
      from = 1. - from;
      to = 1. - to;
    }
    parts[edge].push_back(
      {std::min(from, to), std::max(from, to), multipliers.value(P, piece.patch, piece.lower)});
  }
  return parts;
}

void add_contact_sides(const EdgeMesh &mesh,
                       const MultiplierSpace<2> &multipliers,
                       const Pressure &P,
                       GivenTractions &given)
{
  for (const auto &[number, parts] : pressed_parts(mesh, multipliers, P))
  {
    const Edge &edge = mesh.edges()[number];
    double *const moments = &given.moments[4 * number];
    for (const auto &[a, b, p] : parts)
    {
      const double second = 0.5 * (b * b - a * a), first = (b - a) - second;
      for (unsigned int c = 0; c < 2; ++c)
      {
        moments[c] += p * edge.length * first * edge.normal[c];
        moments[2 + c] += p * edge.length * second * edge.normal[c];
      }
    }
    if (parts.size() == 1)
      continue;
    double square = 0.;
    for (const PressedPart &part : parts)
    {
      const auto rest = [&](const double s) {
        return part.p - linear_traction(moments, s) * edge.normal / edge.length;
      };
      // Simpson's rule is exact for squares of linear functions.
      const double a = rest(part.from), b = rest(part.to);
      square += edge.length * (part.to - part.from) * (a * a + (a + b) * (a + b) + b * b) / 6.;
    }
    given.normal_rest[number] = std::sqrt(square);
  }
}
} // namespace

GivenTractions given_tractions(const DisplacementSpace<2> &space,
                               const Scene<2> &scene,
                               const EdgeMesh &mesh,
                               const MultiplierSpace<2> &multipliers,
                               const Pressure &P,
                               const unsigned int n_points)
{
  GivenTractions given = {std::vector<double>(mesh.n_moments(), 0.),
                          std::vector<double>(mesh.edges().size(), 0.),
                          std::vector<double>(mesh.edges().size(), 0.)};
  add_traction_sides(space, scene, mesh, n_points, given);
  add_contact_sides(mesh, multipliers, P, given);
  return given;
}

void give_to_contact(const EdgeMesh &mesh,
                     const Scene<2> &scene,
                     const std::vector<Tensor<1, 2>> &rest,
                     GivenTractions &given)
{
  for (std::size_t v = 0; v < rest.size(); ++v)
  {
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

EdgeMoments solve_stars(const EdgeMesh &mesh,
                        const std::vector<CornerForces> &R,
                        const std::vector<double> &given,
                        const std::vector<double> &guess)
{
  EdgeMoments result = {std::vector<double>(mesh.n_moments(), 0.),
                        std::vector<Tensor<1, 2>>(mesh.stars().size())};
  std::vector<Tensor<1, 2>> sum;
  for (unsigned int vertex = 0; vertex < mesh.stars().size(); ++vertex)
  {
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
    if (!star.is_closed())
    {
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
    for (unsigned int j = 0; j < n_spokes; ++j)
    {
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
