// SPDX-License-Identifier: LGPL-2.1-or-later
// Planes, spheres and cylinders, and the parts of them that are sides of a body in space.

#include <signorini/problem/geometry/surface.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
Surface::Surface(const Kind kind, const Point<3> &point, const Tensor<1, 3> &axis,
                 const double radius, const Body body)
  : kind_(kind)
  , point_(point)
  , axis_(axis)
  , radius_(radius)
  , body_(body) {
  if (const double length = axis.norm(); length > 0.)
    axis_ /= length;
}

Surface Surface::plane(const Point<3> &point, const Tensor<1, 3> &normal) {
  Assert(normal.norm() > 0., ExcMessage("The normal of a plane is not zero."));
  return {Kind::plane, point, normal, 0., Body::inside};
}

Surface Surface::sphere(const Point<3> &centre, const double radius, const Body body) {
  Assert(radius > 0., ExcMessage("The radius of a sphere is positive."));
  return {Kind::sphere, centre, Tensor<1, 3>(), radius, body};
}

Surface Surface::cylinder(const Point<3> &point, const Tensor<1, 3> &axis, const double radius,
                          const Body body) {
  Assert(radius > 0. && axis.norm() > 0., ExcMessage("A cylinder has a radius and an axis."));
  return {Kind::cylinder, point, axis, radius, body};
}

Surface Surface::faces() {
  return {Kind::faces, Point<3>(), Tensor<1, 3>(), 0., Body::inside};
}

std::string Surface::name(const Kind kind) {
  switch (kind) {
  case Kind::plane:
    return "plane";
  case Kind::sphere:
    return "sphere";
  case Kind::cylinder:
    return "cylinder";
  case Kind::faces:
    break;
  }
  return "faces";
}

Tensor<1, 3> Surface::arm(const Point<3> &x) const {
  const Tensor<1, 3> from_point = x - point_;
  // The axis of a sphere is zero.
  return from_point - (from_point * axis_) * axis_;
}

Point<3> Surface::project(const Point<3> &x) const {
  if (kind_ == Kind::faces)
    return x;
  if (kind_ == Kind::plane)
    return x - ((x - point_) * axis_) * axis_;
  const Tensor<1, 3> r = arm(x);
  const double distance = r.norm();
  return distance > 0. ? x + (radius_ / distance - 1.) * r : x;
}

Tensor<1, 3> Surface::normal(const Point<3> &x) const {
  Assert(has_normals(), ExcMessage("Faces have the normals of their own maps."));
  if (kind_ == Kind::plane)
    return axis_;
  const Tensor<1, 3> r = arm(x);
  return (body_ == Body::inside ? 1. : -1.) / r.norm() * r;
}

Point<3> point_on(const FaceCorners &corners, const Point<2> &xi) {
  const double s = xi[0], t = xi[1];
  return corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]) +
         s * t * ((corners[3] - corners[1]) - (corners[2] - corners[0]));
}

Tensor<1, 3> area_vector(const FaceCorners &corners, const Point<2> &xi) {
  const Tensor<1, 3> mixed = (corners[3] - corners[1]) - (corners[2] - corners[0]);
  return cross_product_3d((corners[1] - corners[0]) + xi[1] * mixed,
                          (corners[2] - corners[0]) + xi[0] * mixed);
}

double area_of(const FaceCorners &corners) {
  const QGauss<2> gauss(2);
  double area = 0.;
  for (unsigned int q = 0; q < gauss.size(); ++q)
    area += gauss.weight(q) * area_vector(corners, gauss.point(q)).norm();
  return area;
}

namespace {
/** Returns the reference coordinates of the point of a bilinear face that is nearest to x, by
 * Gauss' and Newton's method. */
Point<2> nearest_on(const FaceCorners &face, const Point<3> &x) {
  constexpr unsigned int n_steps = 8;
  Point<2> xi(0.5, 0.5);
  for (unsigned int step = 0; step < n_steps; ++step) {
    const Tensor<1, 3> mixed = (face[3] - face[1]) - (face[2] - face[0]),
                       a = (face[1] - face[0]) + xi[1] * mixed,
                       b = (face[2] - face[0]) + xi[0] * mixed, r = x - point_on(face, xi);
    const double aa = a * a, ab = a * b, bb = b * b, determinant = aa * bb - ab * ab;
    xi[0] = std::clamp(xi[0] + (bb * (a * r) - ab * (b * r)) / determinant, 0., 1.);
    xi[1] = std::clamp(xi[1] + (aa * (b * r) - ab * (a * r)) / determinant, 0., 1.);
  }
  return xi;
}
} // namespace

SurfacePart::SurfacePart(const Surface &surface, std::vector<FaceCorners> faces)
  : surface_(surface)
  , faces_(std::move(faces))
  , area_(0.) {
  Assert(!faces_.empty(), ExcMessage("A side has faces."));
  const QGauss<2> gauss(2);
  Tensor<1, 3> sum;
  for (const FaceCorners &face : faces_)
    for (unsigned int q = 0; q < gauss.size(); ++q) {
      const double part = gauss.weight(q) * area_vector(face, gauss.point(q)).norm();
      area_ += part;
      sum += part * point_on(face, gauss.point(q));
    }
  centre_ = surface_.project(Point<3>(sum / area_));
}

Tensor<1, 3> SurfacePart::normal_at(const Point<3> &x) const {
  if (surface_.has_normals())
    return surface_.normal(x);
  double least = std::numeric_limits<double>::max();
  Tensor<1, 3> normal;
  for (const FaceCorners &face : faces_) {
    const Point<3> middle = point_on(face, {0.5, 0.5});
    double radius = 0.;
    for (const Point<3> &corner : face)
      radius = std::max(radius, middle.distance(corner));
    if (x.distance(middle) > radius + least)
      continue;
    const Point<2> xi = nearest_on(face, x);
    if (const double distance = x.distance(point_on(face, xi)); distance < least) {
      least = distance;
      normal = area_vector(face, xi);
    }
  }
  return normal / normal.norm();
}

std::vector<SurfacePoint<3>> SurfacePart::samples(const unsigned int n) const {
  std::vector<SurfacePoint<3>> points;
  for (const FaceCorners &face : faces_)
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i) {
        const Point<2> xi(double(i) / n, double(j) / n);
        const Point<3> x = surface_.project(point_on(face, xi));
        Tensor<1, 3> normal = surface_.has_normals() ? surface_.normal(x) : area_vector(face, xi);
        points.push_back({x, normal / normal.norm()});
      }
  return points;
}

std::array<double, 2> SurfacePart::rectangle() const {
  constexpr double rounding = 1e-10;
  if (faces_.size() != 1)
    return {{0., 0.}};
  const FaceCorners &c = faces_.front();
  const Tensor<1, 3> first = c[1] - c[0], second = c[2] - c[0];
  const bool is_rectangle =
    c[3].distance(c[0] + first + second) <= rounding * (first.norm() + second.norm()) &&
    std::abs(first * second) <= rounding * first.norm() * second.norm();
  return is_rectangle ? std::array<double, 2>{{first.norm(), second.norm()}}
                      : std::array<double, 2>{{0., 0.}};
}
} // namespace Signorini
