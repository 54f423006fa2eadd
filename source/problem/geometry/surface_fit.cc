// SPDX-License-Identifier: LGPL-2.1-or-later
// Planes, spheres and cylinders through points of a side: least squares in scaled coordinates.

#include <signorini/problem/geometry/surface_fit.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace Signorini {
namespace {
/** Equations a·x = b with n unknowns in the mean of squares, as their triangular factor: memory
 * does not grow with their number. */
template <unsigned int n>
class LeastSquares {
public:
  void add(std::array<double, n> a, double b) {
    for (unsigned int i = 0; i < n; ++i) {
      const double length = std::hypot(R_[i][i], a[i]);
      if (length == 0.)
        continue;
      const double c = R_[i][i] / length, s = a[i] / length;
      const auto rotate = [&](double &above, double &below) {
        const double kept = above;
        above = c * kept + s * below;
        below = c * below - s * kept;
      };
      for (unsigned int j = i; j < n; ++j)
        rotate(R_[i][j], a[j]);
      rotate(b_[i], b);
    }
  }

  /** Returns the solution, the shortest one where the equations do not tell it. */
  Tensor<1, n> solve() const {
    constexpr double rounding = 1e-12;
    LAPACKFullMatrix<double> R = matrix();
    R.compute_inverse_svd(rounding * singular_values()[0]);
    Vector<double> x(n);
    R.vmult(x, Vector<double>(b_.begin(), b_.end()));
    Tensor<1, n> solution;
    std::copy(x.begin(), x.end(), solution.begin_raw());
    return solution;
  }

  std::array<double, n> singular_values() const {
    LAPACKFullMatrix<double> R = matrix();
    R.compute_svd();
    std::array<double, n> values;
    for (unsigned int i = 0; i < n; ++i)
      values[i] = R.singular_value(i);
    return values;
  }

  /** Returns the unit vector x for which the sum of (a·x)² is least. */
  Tensor<1, n> kernel() const {
    LAPACKFullMatrix<double> R = matrix();
    R.compute_svd();
    Tensor<1, n> x;
    for (unsigned int j = 0; j < n; ++j)
      x[j] = R.get_svd_vt()(n - 1, j);
    return x;
  }

private:
  LAPACKFullMatrix<double> matrix() const {
    LAPACKFullMatrix<double> R(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = i; j < n; ++j)
        R(i, j) = R_[i][j];
    return R;
  }

  std::array<std::array<double, n>, n> R_ = {};
  std::array<double, n> b_ = {};
};

/** The points about their mean, with an extent of one. */
struct ScaledPoints {
  explicit ScaledPoints(const std::vector<Point<3>> &given)
    : size(0.) {
    Assert(!given.empty(), ExcMessage("A surface is fitted to points."));
    for (const Point<3> &x : given)
      mean += x / static_cast<double>(given.size());
    for (const Point<3> &x : given)
      size = std::max(size, x.distance(mean));
    for (const Point<3> &x : given)
      points.emplace_back((x - mean) / size);
  }

  Point<3> original(const Tensor<1, 3> &y) const {
    return mean + size * y;
  }

  Point<3> mean;
  double size;
  std::vector<Point<3>> points;
};

/** Two unit vectors at right angles to a unit vector and to one another. */
std::array<Tensor<1, 3>, 2> vectors_across(const Tensor<1, 3> &e) {
  Tensor<1, 3> other;
  other[std::abs(e[0]) < 0.6 ? 0 : 1] = 1.;
  Tensor<1, 3> first = cross_product_3d(e, other);
  first /= first.norm();
  return {{first, cross_product_3d(e, first)}};
}

/** A round surface in scaled coordinates: a sphere, or a cylinder if it has an axis. */
struct Round {
  Tensor<1, 3> point, axis;
  double radius = 0.;

  Tensor<1, 3> arm(const Point<3> &y) const {
    const Tensor<1, 3> r = y - point;
    return r - (r * axis) * axis;
  }
  double distance(const Point<3> &y) const {
    return arm(y).norm() - radius;
  }
};

/** Spheres: the unknowns are the centre and the radius. */
struct Spheres {
  static constexpr unsigned int n = 4;

  static std::array<double, n> derivative(const Round &sphere, const Point<3> &y) {
    const Tensor<1, 3> r = sphere.arm(y) / std::max(sphere.arm(y).norm(), 1e-300);
    return {{-r[0], -r[1], -r[2], -1.}};
  }
  static Round moved(Round sphere, const Tensor<1, n> &step) {
    for (unsigned int d = 0; d < 3; ++d)
      sphere.point[d] += step[d];
    sphere.radius += step[3];
    return sphere;
  }
  /** |y|² = 2 c·y + R² - |c|². */
  static Round first_guess(const ScaledPoints &scaled) {
    LeastSquares<n> equations;
    for (const Point<3> &y : scaled.points)
      equations.add({{2. * y[0], 2. * y[1], 2. * y[2], 1.}}, y.norm_square());
    const Tensor<1, n> x = equations.solve();
    Round sphere;
    for (unsigned int d = 0; d < 3; ++d)
      sphere.point[d] = x[d];
    sphere.radius = std::sqrt(x[3] + sphere.point.norm_square());
    return sphere;
  }
};

/** Cylinders: the unknowns are the axis, the point across it, and the radius. */
struct Cylinders {
  static constexpr unsigned int n = 5;

  static std::array<double, n> derivative(const Round &cylinder, const Point<3> &y) {
    const auto across = vectors_across(cylinder.axis);
    const Tensor<1, 3> r = cylinder.arm(y) / std::max(cylinder.arm(y).norm(), 1e-300);
    const double along = (y - cylinder.point) * cylinder.axis;
    return {{-along * (r * across[0]), -along * (r * across[1]), -(r * across[0]), -(r * across[1]),
             -1.}};
  }
  static Round moved(Round cylinder, const Tensor<1, n> &step) {
    const auto across = vectors_across(cylinder.axis);
    cylinder.axis += step[0] * across[0] + step[1] * across[1];
    cylinder.axis /= cylinder.axis.norm();
    cylinder.point += step[2] * across[0] + step[3] * across[1];
    cylinder.radius += step[4];
    return cylinder;
  }
  /** The normals of faces are at right angles to the axis, and points across it lie on a circle. */
  static Round first_guess(const ScaledPoints &scaled, const std::vector<SurfacePoint<3>> &faces) {
    LeastSquares<3> normals;
    for (const SurfacePoint<3> &face : faces)
      normals.add({{face.n[0], face.n[1], face.n[2]}}, 0.);
    Round cylinder;
    cylinder.axis = normals.kernel();
    const auto across = vectors_across(cylinder.axis);
    LeastSquares<3> circle;
    for (const Point<3> &y : scaled.points) {
      const double s = y * across[0], t = y * across[1];
      circle.add({{2. * s, 2. * t, 1.}}, s * s + t * t);
    }
    const Tensor<1, 3> x = circle.solve();
    cylinder.point = x[0] * across[0] + x[1] * across[1];
    cylinder.radius = std::sqrt(x[2] + x[0] * x[0] + x[1] * x[1]);
    return cylinder;
  }
};

double sum_of_squares(const Round &round, const std::vector<Point<3>> &points) {
  double sum = 0.;
  for (const Point<3> &y : points)
    sum += std::pow(round.distance(y), 2);
  return sum;
}

template <typename Family>
LeastSquares<Family::n> linearised(const Round &round, const std::vector<Point<3>> &points) {
  LeastSquares<Family::n> equations;
  for (const Point<3> &y : points)
    equations.add(Family::derivative(round, y), -round.distance(y));
  return equations;
}

/** Gauss-Newton, with steps that are halved until the sum of squares falls; where it falls no
 * more, rounding is reached. @return the least over the largest singular value. */
template <typename Family>
double improve(Round &round, const std::vector<Point<3>> &points) {
  constexpr unsigned int max_steps = 50;
  constexpr double shortest_step = 1e-3;
  double sum = sum_of_squares(round, points);
  for (unsigned int k = 0; k < max_steps; ++k) {
    const Tensor<1, Family::n> step = linearised<Family>(round, points).solve();
    double part = 1.;
    Round next = Family::moved(round, step);
    while (!(sum_of_squares(next, points) < sum) && part > shortest_step)
      next = Family::moved(round, (part /= 2.) * step);
    const double next_sum = sum_of_squares(next, points);
    if (!(next_sum < sum))
      break;
    round = next;
    sum = next_sum;
  }
  const auto values = linearised<Family>(round, points).singular_values();
  return values.back() / values.front();
}

/** Returns whether numbers are at most @p n groups, each narrower than @p width. */
bool are_groups(std::vector<double> numbers, const unsigned int n, const double width) {
  std::sort(numbers.begin(), numbers.end());
  auto next = numbers.begin();
  for (unsigned int k = 0; k < n && next != numbers.end(); ++k)
    next = std::upper_bound(next, numbers.end(), *next + width);
  return next == numbers.end();
}

/** The distance below which positions are equal, where the extent of all points is one. */
constexpr double same_position = 1e-4;

/** Returns whether points of a cylinder lie on at most @p n lines. */
bool lie_on_lines(const std::vector<Point<3>> &points, const Round &cylinder,
                  const unsigned int n) {
  const Tensor<1, 3> first = cylinder.arm(points.front());
  const Tensor<1, 3> second = cross_product_3d(cylinder.axis, first);
  std::vector<double> arcs;
  for (const Point<3> &y : points)
    arcs.push_back(cylinder.radius * std::atan2(cylinder.arm(y) * second, cylinder.arm(y) * first));
  // The line of the first point has the angle zero, so that no line has angles near both ends
  // unless it is opposite to that one.
  const double end = numbers::PI * cylinder.radius;
  for (double &arc : arcs)
    if (arc > end - same_position)
      arc -= 2. * end;
  return are_groups(std::move(arcs), n, same_position);
}

/** Returns points that are far from one another, five or fewer. */
std::vector<Point<3>> spread(const std::vector<Point<3>> &points) {
  std::vector<Point<3>> chosen = {points.front()};
  const auto distance_from_chosen = [&](const Point<3> &y) {
    double least = std::numeric_limits<double>::max();
    for (const Point<3> &x : chosen)
      least = std::min(least, x.distance(y));
    return least;
  };
  while (chosen.size() < std::min<std::size_t>(5, points.size()))
    chosen.push_back(
      *std::max_element(points.begin(), points.end(), [&](const auto &a, const auto &b) {
        return distance_from_chosen(a) < distance_from_chosen(b);
      }));
  return chosen;
}

/** Returns whether points of a sphere lie on at most @p n parallel circles (one or two). Of any
 * five points three then lie on the same one. */
bool lie_on_circles(const std::vector<Point<3>> &points, const unsigned int n) {
  const std::vector<Point<3>> some = spread(points);
  if (some.size() < 5 && n > 1)
    return true;
  for (unsigned int i = 0; i < some.size(); ++i)
    for (unsigned int j = 0; j < i; ++j)
      for (unsigned int k = 0; k < j; ++k) {
        Tensor<1, 3> normal = cross_product_3d(some[i] - some[k], some[j] - some[k]);
        if (normal.norm() == 0.)
          continue;
        normal /= normal.norm();
        std::vector<double> heights;
        for (const Point<3> &y : points)
          heights.push_back(y * normal);
        if (are_groups(std::move(heights), n, same_position))
          return true;
      }
  return false;
}

/** Returns the sum of the products of the normals of faces with those of a surface, and whether
 * all have the same sign. */
std::pair<double, bool> compare_normals(const Surface &surface,
                                        const std::vector<SurfacePoint<3>> &faces) {
  double sum = 0., sum_of_sizes = 0.;
  bool all_the_same = !faces.empty();
  for (const SurfacePoint<3> &face : faces) {
    const double product = face.n * surface.normal(face.x);
    sum += product;
    sum_of_sizes += std::abs(product);
    all_the_same = all_the_same && product != 0. && std::abs(sum) == sum_of_sizes;
  }
  return {sum, all_the_same};
}

SurfaceFit no_surface(const double residual) {
  return {Surface::faces(), residual, 0., true};
}

SurfaceFit fit_plane(const ScaledPoints &scaled, const std::vector<SurfacePoint<3>> &faces) {
  LeastSquares<3> arms, derivatives;
  for (const Point<3> &y : scaled.points)
    arms.add({{y[0], y[1], y[2]}}, 0.);
  Tensor<1, 3> normal = arms.kernel();
  const auto across = vectors_across(normal);
  double farthest = 0.;
  for (const Point<3> &y : scaled.points) {
    farthest = std::max(farthest, std::abs(y * normal));
    derivatives.add({{1., y * across[0], y * across[1]}}, 0.);
  }
  const auto [sum, follows] = compare_normals(Surface::plane(scaled.mean, normal), faces);
  const auto values = derivatives.singular_values();
  return {Surface::plane(scaled.mean, sum < 0. ? -normal : normal), scaled.size * farthest,
          values.back() / values.front(), follows};
}

/** @param make makes the surface with the body inside or outside. */
SurfaceFit judged(const ScaledPoints &scaled, const Round &round, const double condition,
                  const std::vector<SurfacePoint<3>> &faces,
                  const std::function<Surface(Body)> &make) {
  double farthest = 0.;
  for (const Point<3> &y : scaled.points)
    farthest = std::max(farthest, std::abs(round.distance(y)));
  const auto [sum, follows] = compare_normals(make(Body::inside), faces);
  return {make(sum < 0. ? Body::outside : Body::inside), scaled.size * farthest, condition,
          follows};
}

bool exists(const Round &round) {
  return std::isfinite(round.point.norm()) && round.radius > 0. && std::isfinite(round.radius);
}

/** @param n_circles the number of parallel circles that do not tell a sphere. */
SurfaceFit fit_sphere(const ScaledPoints &scaled, const std::vector<SurfacePoint<3>> &faces,
                      const unsigned int n_circles) {
  Round sphere = Spheres::first_guess(scaled);
  const double condition = exists(sphere) ? improve<Spheres>(sphere, scaled.points) : 0.;
  if (!exists(sphere))
    return no_surface(std::numeric_limits<double>::infinity());
  return judged(scaled, sphere, lie_on_circles(scaled.points, n_circles) ? 0. : condition, faces,
                [&](const Body body) {
                  return Surface::sphere(scaled.original(sphere.point), scaled.size * sphere.radius,
                                         body);
                });
}

/** @param n_lines the number of lines that do not tell a cylinder. */
SurfaceFit fit_cylinder(const ScaledPoints &scaled, const std::vector<SurfacePoint<3>> &faces,
                        const unsigned int n_lines) {
  Round cylinder = Cylinders::first_guess(scaled, faces);
  const double condition = exists(cylinder) ? improve<Cylinders>(cylinder, scaled.points) : 0.;
  if (!exists(cylinder))
    return no_surface(std::numeric_limits<double>::infinity());
  return judged(scaled, cylinder, lie_on_lines(scaled.points, cylinder, n_lines) ? 0. : condition,
                faces, [&](const Body body) {
                  return Surface::cylinder(scaled.original(cylinder.point), cylinder.axis,
                                           scaled.size * cylinder.radius, body);
                });
}
} // namespace

SurfaceFit fit_surface(const SurfaceSamples &samples) {
  constexpr double max_residual = 1e-6, min_condition = 1e-5;
  const ScaledPoints scaled(samples.points);
  SurfaceFit plane = fit_plane(scaled, samples.faces);
  if (plane.residual <= max_residual * scaled.size)
    return plane;
  SurfaceFit best = no_surface(0.);
  for (const SurfaceFit &fit :
       {fit_sphere(scaled, samples.faces, 2), fit_cylinder(scaled, samples.faces, 3)})
    if (fit.residual <= max_residual * fit.surface.radius() && fit.condition >= min_condition &&
        fit.follows_normals &&
        (best.surface.kind() == Surface::Kind::faces || fit.residual < best.residual))
      best = fit;
  return best;
}

SurfaceFit fit_surface(const SurfaceSamples &samples, const Surface::Kind kind) {
  const ScaledPoints scaled(samples.points);
  switch (kind) {
  case Surface::Kind::plane:
    return fit_plane(scaled, samples.faces);
  case Surface::Kind::sphere:
    return fit_sphere(scaled, samples.faces, 1);
  case Surface::Kind::cylinder:
    return fit_cylinder(scaled, samples.faces, 2);
  case Surface::Kind::faces:
    break;
  }
  return no_surface(0.);
}
} // namespace Signorini
