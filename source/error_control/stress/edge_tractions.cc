// SPDX-License-Identifier: LGPL-2.1-or-later
// Moments of tractions: those that are given, and those that follow around every vertex.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/stress/edge_tractions.h>
#include <signorini/problem/scene/functions.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using Vector2 = Tensor<1, 2>;

Vector2 entry(const std::vector<double> &moments, const unsigned int at)
{
  return Vector2({moments[at], moments[at + 1]});
}

/** Returns the values at the ends of the linear function with the moments a and b on an edge of the
 * given length. */
std::array<Vector2, 2> linear_traction(const std::vector<double> &moments,
                                       const unsigned int edge,
                                       const double length)
{
  const Vector2 a = entry(moments, 4 * edge), b = entry(moments, 4 * edge + 2);
  return {{(4. * a - 2. * b) / length, (4. * b - 2. * a) / length}};
}

/** The moments of t on one edge of a traction side. */
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
    const std::size_t n_points = values.get_quadrature_points().size();
    std::vector<dealii::Vector<double>> t(n_points, dealii::Vector<double>(2));
    traction.vector_value_list(values.get_quadrature_points(), t);
    const auto position = [&](const unsigned int i) {
      return values.shape_value(2 * second_end, i);
    };
    for (unsigned int i = 0; i < n_points; ++i)
      for (unsigned int c = 0; c < 2; ++c)
      {
        const double s = position(i), weighted = t[i][c] * values.JxW(i);
        moments[c] += (1. - s) * weighted;
        moments[2 + c] += s * weighted;
      }
    const auto linear = linear_traction(moments, 0, edge.length);
    double shear_square = 0., normal_square = 0.;
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const double s = position(i);
      const Vector2 difference = Vector2({t[i][0], t[i][1]}) - (1. - s) * linear[0] - s * linear[1];
      const double normal_part = difference * edge.normal;
      normal_square += normal_part * normal_part * values.JxW(i);
      shear_square += (difference - normal_part * edge.normal).norm_square() * values.JxW(i);
    }
    normal_rest = std::sqrt(normal_square);
    shear_rest = std::sqrt(shear_square);
  }
  /** Returns whether finer quadrature gives the same. */
  bool agrees(const EdgeTraction &finer, const double length) const
  {
    constexpr double tolerance = 1e-4;
    double difference = 0., size = 0.;
    for (unsigned int i = 0; i < 4; ++i)
    {
      difference = std::max(difference, std::abs(moments[i] - finer.moments[i]));
      size = std::max(size, std::abs(moments[i]));
    }
    return difference <= tolerance * size &&
           finer.normal_rest + finer.shear_rest <=
             1.01 * (normal_rest + shear_rest) + tolerance * size / std::sqrt(length);
  }

  std::vector<double> moments = std::vector<double>(4, 0.);
  double normal_rest, shear_rest;
};

/** Returns the number of further points on an edge, about 20000 on all edges. */
unsigned int n_fine_points(const EdgeMesh &mesh, const Scene<2> &scene)
{
  std::size_t n_edges = 0;
  for (const Edge &edge : mesh.edges())
    if (edge.side != Edge::no_side && scene.boundary[edge.side].role == Role::traction)
      ++n_edges;
  return n_edges == 0 ? 0 : std::min<std::size_t>(20000 / n_edges, 256);
}

void add_traction_sides(const DisplacementSpace<2> &space,
                        const Scene<2> &scene,
                        const EdgeMesh &mesh,
                        const unsigned int n_points,
                        GivenTractions &given)
{
  const auto make_values = [&](const unsigned int n) {
    return FaceValues<2>(space.mesh().mapping(),
                         space,
                         scene.kinks,
                         n,
                         update_values | update_quadrature_points | update_JxW_values);
  };
  const unsigned int n_fine = std::max(n_points, n_fine_points(mesh, scene));
  FaceValues<2> values = make_values(n_points), finer = make_values(n_fine);
  for (const auto &cell : space.mesh().triangulation().active_cell_iterators())
    if (cell->at_boundary())
      for (const unsigned int f : cell->face_indices())
      {
        const auto face = cell->face(f);
        if (!face->at_boundary() || scene.boundary[face->boundary_id()].role != Role::traction)
          continue;
        const unsigned int number = mesh.edge_of_line(face->index());
        const Edge &edge = mesh.edges()[number];
        const bool reversed = edge.vertices[0] != face->vertex_index(0);
        const unsigned int second_end = GeometryInfo<2>::face_to_cell_vertices(f, reversed ? 0 : 1);
        const Function<2> &t = *scene.boundary[face->boundary_id()].data;
        EdgeTraction traction(values.reinit(cell, f), t, edge, second_end);
        if (n_fine > n_points && !is_constant(t))
        {
          const EdgeTraction fine(finer.reinit(cell, f), t, edge, second_end);
          if (!traction.agrees(fine, edge.length))
            traction = fine;
        }
        std::copy(
          traction.moments.begin(), traction.moments.end(), given.moments.begin() + 4 * number);
        given.normal_rest[number] = traction.normal_rest;
        given.shear_rest[number] = traction.shear_rest;
      }
}

/** A part [from, to] of an edge, as shares of its length, with the constant pressure p. */
struct PressedPart
{
  unsigned int edge;
  double from, to, p;
};

/** Returns p_H on the pieces face ∩ patch, along Edge::vertices. */
std::vector<PressedPart> pressed_parts(const EdgeMesh &mesh,
                                       const MultiplierSpace<2> &multipliers,
                                       const Pressure &P)
{
  const ContactSurface<2> &surface = multipliers.surface();
  std::vector<PressedPart> parts;
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
    parts.push_back({edge,
                     std::min(from, to),
                     std::max(from, to),
                     multipliers.value(P, piece.patch, piece.lower)});
  }
  return parts;
}

void add_contact_sides(const EdgeMesh &mesh,
                       const std::vector<PressedPart> &parts,
                       GivenTractions &given)
{
  std::vector<unsigned int> n_parts(mesh.edges().size(), 0);
  for (const PressedPart &part : parts)
  {
    const Edge &edge = mesh.edges()[part.edge];
    ++n_parts[part.edge];
    const double a = part.from, b = part.to;
    const double second = 0.5 * (b * b - a * a), first = (b - a) - second;
    for (unsigned int c = 0; c < 2; ++c)
    {
      given.moments[4 * part.edge + c] += part.p * edge.length * first * edge.normal[c];
      given.moments[4 * part.edge + 2 + c] += part.p * edge.length * second * edge.normal[c];
    }
  }
  std::vector<double> squares(mesh.edges().size(), 0.);
  for (const PressedPart &part : parts)
    if (n_parts[part.edge] > 1)
    {
      const Edge &edge = mesh.edges()[part.edge];
      const auto linear = linear_traction(given.moments, part.edge, edge.length);
      const auto difference = [&](const double s) {
        return part.p - ((1. - s) * linear[0] + s * linear[1]) * edge.normal;
      };
      // Simpson's rule is exact for squares of linear functions.
      const double a = difference(part.from), b = difference(part.to);
      const double m = 0.5 * (a + b);
      squares[part.edge] += edge.length * (part.to - part.from) * (a * a + 4. * m * m + b * b) / 6.;
    }
  for (std::size_t e = 0; e < squares.size(); ++e)
    given.normal_rest[e] += std::sqrt(squares[e]);
}

/** The linear equations a.c = value for a vector c in 2-D, as many as determine it. */
class Conditions
{
public:
  /**
   * Adds a condition.
   * @return the violation, if the condition follows from those before; else zero.
   */
  double add(const Vector2 &a, const double value)
  {
    Vector2 rest = a;
    double violation = value;
    for (unsigned int i = 0; i < n_; ++i)
    {
      violation -= (a * q_[i]) * value_[i];
      rest -= (a * q_[i]) * q_[i];
    }
    if (n_ == 2 || rest.norm() < 1e-8)
      return violation;
    q_[n_] = rest / rest.norm();
    value_[n_++] = violation / rest.norm();
    return 0.;
  }
  /** Returns the vector closest to @p guess. */
  Vector2 closest(const Vector2 &guess) const
  {
    Vector2 c = guess;
    for (unsigned int i = 0; i < n_; ++i)
      c += (value_[i] - guess * q_[i]) * q_[i];
    return c;
  }

private:
  unsigned int n_ = 0;
  std::array<Vector2, 2> q_;
  std::array<double, 2> value_{};
};

/** Returns the directions in which the traction of an edge is given. */
std::vector<Vector2> given_directions(const Edge &edge)
{
  switch (edge.freedom)
  {
  case EdgeFreedom::any:
    return {};
  case EdgeFreedom::normal:
    return {Vector2({-edge.normal[1], edge.normal[0]})};
  default:
    return {Vector2({1., 0.}), Vector2({0., 1.})};
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
  add_contact_sides(mesh, pressed_parts(mesh, multipliers, P), given);
  return given;
}

void give_to_contact(const EdgeMesh &mesh,
                     const Scene<2> &scene,
                     const std::vector<Vector2> &rest,
                     GivenTractions &given)
{
  for (std::size_t v = 0; v < rest.size(); ++v)
  {
    const Star &star = mesh.stars()[v];
    if (star.cells.empty() || star.is_closed())
      continue;
    const auto touches = [&](const Spoke &spoke) {
      return scene.boundary[mesh.edges()[spoke.edge].side].role == Role::contact;
    };
    const Spoke &first = star.spokes.front(), &last = star.spokes.back();
    const double n_contact = (touches(first) ? 1. : 0.) + (touches(last) ? 1. : 0.);
    for (const Spoke *const spoke : {&first, &last})
      if (touches(*spoke))
        for (unsigned int c = 0; c < 2; ++c)
          given.moments[4 * spoke->edge + 2 * spoke->end + c] +=
            (spoke == &first ? 1. : -1.) * spoke->sign * star.cells.size() / n_contact * rest[v][c];
  }
}

EdgeMoments::EdgeMoments(const EdgeMesh &mesh,
                         const std::vector<CornerForces> &R,
                         const std::vector<double> &given,
                         const std::vector<double> &guess)
  : mesh_(mesh)
  , moments_(mesh.n_moments(), 0.)
  , rest_(mesh.stars().size())
{
  for (unsigned int v = 0; v < mesh.stars().size(); ++v)
    solve(v, R, given, guess);
}

void EdgeMoments::solve(const unsigned int vertex,
                        const std::vector<CornerForces> &R,
                        const std::vector<double> &given,
                        const std::vector<double> &guess)
{
  const Star &star = mesh_.stars()[vertex];
  const unsigned int n = star.cells.size(), n_spokes = star.spokes.size();
  if (n == 0)
    return;
  const auto of = [&](const unsigned int j, const std::vector<double> &moments) {
    const Spoke &spoke = star.spokes[j];
    return spoke.sign * entry(moments, 4 * spoke.edge + 2 * spoke.end);
  };
  // The moment on spoke j is c - sum[j].
  std::vector<Vector2> sum(n + 1);
  Vector2 mean;
  for (unsigned int j = 0; j < n; ++j)
    sum[j + 1] = sum[j] + R[star.cells[j].cell][star.cells[j].number];
  for (unsigned int j = 0; j < n_spokes; ++j)
    mean += (of(j, guess) + sum[j]) / n_spokes;

  Vector2 rest = star.is_closed() ? sum[n] : Vector2();
  Conditions conditions;
  if (!star.is_closed())
    for (const unsigned int j : {0U, n})
      for (const Vector2 &a : given_directions(mesh_.edges()[star.spokes[j].edge]))
        // With R - rest/n in place of R the moment on the last spoke is c - sum[n] + rest.
        rest += conditions.add(a, a * (of(j, given) + sum[j])) * a;
  const Vector2 c = conditions.closest(mean);
  rest_[vertex] = rest / n;
  for (unsigned int j = 0; j < n_spokes; ++j)
  {
    const Spoke &spoke = star.spokes[j];
    const Vector2 b = spoke.sign * (c - sum[j] + static_cast<double>(j) * rest_[vertex]);
    moments_[4 * spoke.edge + 2 * spoke.end] = b[0];
    moments_[4 * spoke.edge + 2 * spoke.end + 1] = b[1];
  }
}
} // namespace Signorini
