// SPDX-License-Identifier: LGPL-2.1-or-later
// Omega between closed loops of segments and arcs.

#include <signorini/base/errors.h>
#include <signorini/problem/geometry/outline.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include "outline_mesh.h"

namespace Signorini
{
namespace
{
/** Returns the box around the sides. */
std::array<Point<2>, 2> box_around(const std::vector<Side<2>> &sides)
{
  std::array<Point<2>, 2> box = {{sides[0].start(), sides[0].start()}};
  const auto include = [&box](const Point<2> &x) {
    for (unsigned int d = 0; d < 2; ++d)
    {
      box[0][d] = std::min(box[0][d], x[d]);
      box[1][d] = std::max(box[1][d], x[d]);
    }
  };
  for (const Side<2> &side : sides)
    for (unsigned int k = 0; k < side.n_pieces(); ++k)
    {
      const Curve &piece = side.piece(k);
      include(piece.start());
      include(piece.end());
      for (unsigned int d = 0; d < 2 && piece.radius() > 0.; ++d)
        for (const double sign : {-1., 1.})
        {
          // The point of the circle that is farthest in this direction, if it is on the arc.
          const Point<2> x =
            piece.centre_of_circle() + sign * piece.radius() * Point<2>::unit_vector(d);
          const double s = piece.arc_length(x);
          if (s > 0. && s < piece.length())
            include(x);
        }
    }
  return box;
}

OutlineMesh make_mesh(const std::vector<Side<2>> &sides,
                      const std::vector<Loop> &loops,
                      const double mesh_size,
                      const std::string &where)
{
  // With shorter chords the cells next to arcs are less bent.
  double step = 0.25 * numbers::PI;
  for (unsigned int attempt = 0; attempt < 10; ++attempt, step *= 0.7)
    if (auto mesh = mesh_outline(sides, loops, mesh_size, step, max_coarse_cells, where))
      return *mesh;
  throw InputError(where +
                   ": no mesh was found for this shape, allowed: arcs that do not come very "
                   "close to other sides or meet them at very small angles.");
}

/** Returns the centre of the largest triangle: every third vertex behind the middles of its edges.
 */
Point<2> point_inside(const OutlineMesh &mesh)
{
  double largest = 0.;
  Point<2> inside;
  for (const CellData<2> &cell : mesh.cells)
  {
    const Tensor<1, 2> a = mesh.vertices[cell.vertices[3]] - mesh.vertices[cell.vertices[0]];
    const Tensor<1, 2> b = mesh.vertices[cell.vertices[2]] - mesh.vertices[cell.vertices[1]];
    const double area = 0.5 * std::abs(a[0] * b[1] - a[1] * b[0]);
    // Of equal triangles the first one is taken, whatever rounding makes of them.
    if (area > (1. + 1e-9) * largest)
    {
      largest = area;
      inside = mesh.vertices[cell.vertices[3]];
    }
  }
  return inside;
}

void make_triangulation(const OutlineMesh &mesh, Triangulation<2> &triangulation)
{
  triangulation.create_triangulation(mesh.vertices, mesh.cells, mesh.lines);
  for (std::size_t k = 0; k < mesh.circles.size(); ++k)
    triangulation.set_manifold(k, SphericalManifold<2>(mesh.circles[k]));
  for (std::size_t k = 0; k < mesh.curved_cells.size(); ++k)
    triangulation.set_manifold(mesh.circles.size() + k, mesh.curved_cells[k]);
}
} // namespace

Geometry<2> make_outlined_body(const std::vector<Side<2>> &sides,
                               const double mesh_size,
                               const std::string &where)
{
  Geometry<2> geometry;
  geometry.sides = sides;
  const auto [lower, upper] = box_around(sides);
  geometry.lower = lower;
  geometry.upper = upper;
  const std::vector<Loop> loops = find_loops(sides, geometry.diameter(), where);
  check_outline(sides, loops, geometry.diameter(), where);
  const auto mesh = std::make_shared<const OutlineMesh>(make_mesh(sides, loops, mesh_size, where));
  geometry.n_coarse_cells = static_cast<double>(mesh->cells.size());
  geometry.curved = !mesh->circles.empty();
  geometry.star_shaped = false;
  geometry.inside = point_inside(*mesh);
  geometry.make_coarse_mesh = [mesh](Triangulation<2> &triangulation) {
    make_triangulation(*mesh, triangulation);
  };
  return geometry;
}

// Checks of an outline, on polygons whose corners lie on the sides at most 2 degrees apart.

namespace
{
using Vector2 = Tensor<1, 2>;

/** The distance (in sizes of the body) below which two points are the same. */
constexpr double same_point = 1e-9;

struct FineChord
{
  Point<2> a, b;
  std::size_t side, loop;

  double lowest() const
  {
    return std::min(a[0], b[0]);
  }
  double highest() const
  {
    return std::max(a[0], b[0]);
  }
};

double cross_of(const Vector2 &a, const Vector2 &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

std::vector<FineChord> fine_chords(const std::vector<Side<2>> &sides,
                                   const std::vector<Loop> &loops)
{
  constexpr double step = numbers::PI / 90.;
  std::vector<FineChord> chords;
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t i = loops[l].first; i < loops[l].last; ++i)
      for (unsigned int k = 0; k < sides[i].n_pieces(); ++k)
      {
        const Curve &piece = sides[i].piece(k);
        const double angle = piece.radius() > 0. ? piece.length() / piece.radius() : 0.;
        const auto n = static_cast<unsigned int>(std::max(1., std::ceil(angle / step)));
        for (unsigned int j = 0; j < n; ++j)
          chords.push_back(
            {piece.point(j * piece.length() / n), piece.point((j + 1) * piece.length() / n), i, l});
      }
  return chords;
}

/** Returns the distance from a point to a segment. */
double distance(const Point<2> &x, const FineChord &chord)
{
  const Vector2 d = chord.b - chord.a;
  const double t = std::clamp(((x - chord.a) * d) / (d * d), 0., 1.);
  return x.distance(chord.a + t * d);
}

bool meet(const FineChord &p, const FineChord &q, const double tolerance)
{
  const auto hand = [](const FineChord &chord, const Point<2> &x) {
    return cross_of(chord.b - chord.a, x - chord.a);
  };
  if (hand(p, q.a) * hand(p, q.b) < 0. && hand(q, p.a) * hand(q, p.b) < 0.)
    return true;
  return std::min({distance(p.a, q), distance(p.b, q), distance(q.a, p), distance(q.b, p)}) <
         tolerance;
}

/** Returns whether two chords with a common end fold onto each other; others with a common end may
 * meet. */
bool folds(const FineChord &p, const FineChord &q)
{
  const Vector2 in = p.b - p.a, out = q.b - q.a;
  return in * out < 0. && std::abs(cross_of(in, out)) < 1e-6 * in.norm() * out.norm();
}

[[noreturn]] void refuse_meeting(const std::vector<Side<2>> &sides,
                                 const FineChord &p,
                                 const FineChord &q,
                                 const std::string &where)
{
  const Point<2> x = q.a + 0.5 * (q.b - q.a);
  const auto [first, second] = std::minmax(sides[p.side].name(), sides[q.side].name());
  std::ostringstream message;
  message << where << ": "
          << (p.side == q.side ? "the side " + sides[p.side].name() + " crosses or touches itself"
                               : "the sides " + first + " and " + second + " cross or touch")
          << " near (" << x[0] << ", " << x[1] << "), allowed: sides that meet at their ends only.";
  throw InputError(message.str());
}

/** Refuses chords that cross or touch. @p chords are in the order of the loops. */
void refuse_crossings(const std::vector<Side<2>> &sides,
                      std::vector<FineChord> chords,
                      const double size,
                      const std::string &where)
{
  const double tolerance = same_point * size;
  std::sort(chords.begin(), chords.end(), [](const FineChord &p, const FineChord &q) {
    return p.lowest() < q.lowest();
  });
  for (std::size_t i = 0; i < chords.size(); ++i)
    for (std::size_t j = i + 1;
         j < chords.size() && chords[j].lowest() < chords[i].highest() + tolerance;
         ++j)
    {
      const FineChord &p = chords[i], &q = chords[j];
      if (std::min(p.a[1], p.b[1]) > std::max(q.a[1], q.b[1]) + tolerance ||
          std::max(p.a[1], p.b[1]) < std::min(q.a[1], q.b[1]) - tolerance)
        continue;
      const bool in_a_row =
        p.loop == q.loop && (p.b.distance(q.a) < tolerance || q.b.distance(p.a) < tolerance);
      if (in_a_row ? folds(p, q) : meet(p, q, tolerance))
        refuse_meeting(sides, p, q, where);
    }
}

/** Returns whether a ray to the right of a point meets a loop an odd number of times. */
bool encloses(const std::vector<FineChord> &chords, const std::size_t loop, const Point<2> &x)
{
  bool odd = false;
  for (const FineChord &chord : chords)
    if (chord.loop == loop && (chord.a[1] > x[1]) != (chord.b[1] > x[1]))
    {
      const double t = (x[1] - chord.a[1]) / (chord.b[1] - chord.a[1]);
      odd = odd != (chord.a[0] + t * (chord.b[0] - chord.a[0]) > x[0]);
    }
  return odd;
}

/** Returns the area inside a loop, positive if the loop has its inside on the left. */
double signed_area(const std::vector<FineChord> &chords, const std::size_t loop)
{
  double area = 0.;
  const Point<2> &origin = chords[0].a;
  for (const FineChord &chord : chords)
    if (chord.loop == loop)
      area += 0.5 * cross_of(chord.a - origin, chord.b - origin);
  return area;
}
} // namespace

std::vector<Loop> find_loops(const std::vector<Side<2>> &sides,
                             const double size,
                             const std::string &where)
{
  const double tolerance = same_point * size;
  std::vector<Loop> loops;
  std::size_t first = 0;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    if (i > first && sides[i - 1].end().distance(sides[i].start()) > tolerance)
      throw InputError(where + ": the side " + sides[i].name() + " does not begin where " +
                       sides[i - 1].name() + " ends, allowed: closed loops.");
    if (sides[i].end().distance(sides[first].start()) <= tolerance)
    {
      loops.push_back({first, i + 1});
      first = i + 1;
    }
  }
  if (first < sides.size() || loops.empty())
    throw InputError(where + ": the sides do not form closed loops.");
  return loops;
}

void check_outline(const std::vector<Side<2>> &sides,
                   const std::vector<Loop> &loops,
                   const double size,
                   const std::string &where)
{
  const std::vector<FineChord> chords = fine_chords(sides, loops);
  refuse_crossings(sides, chords, size, where);
  std::vector<std::size_t> outer;
  for (std::size_t l = 0; l < loops.size(); ++l)
    if (signed_area(chords, l) > 0.)
      outer.push_back(l);
  if (outer.size() != 1)
    throw InputError(where + ": found " + std::to_string(outer.size()) +
                     " loops around bodies, allowed: one body.");
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t other = 0; other < loops.size(); ++other)
      if (l != outer[0] && l != other &&
          encloses(chords, other, sides[loops[l].first].start()) != (other == outer[0]))
        throw InputError(where + ": " + sides[loops[l].first].name() + " lies " +
                         (other == outer[0] ? "outside of the body"
                                            : "inside of " + sides[loops[other].first].name()) +
                         ", allowed: holes inside of the body, each by itself.");
}
} // namespace Signorini
