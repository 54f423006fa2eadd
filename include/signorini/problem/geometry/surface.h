// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/curve.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace Signorini {
/**
 * The plane, the sphere or the cylinder on which faces of a body in space lie. Faces that follow
 * none of them are a surface of their own kind: it projects a point to itself and has no normals.
 */
class Surface {
public:
  enum class Kind { plane, sphere, cylinder, faces };

  /** Makes a plane. @param normal (not zero, of any length) points out of the body. */
  static Surface plane(const Point<3> &point, const Tensor<1, 3> &normal);
  /** Makes a sphere, with the body inside (a ball) or outside (a socket). */
  static Surface sphere(const Point<3> &centre, double radius, Body body);
  /** Makes a round cylinder about the axis through a point (@p axis not zero, of any length), with
   * the body inside (a shaft) or outside (a hole). */
  static Surface cylinder(const Point<3> &point, const Tensor<1, 3> &axis, double radius,
                          Body body);
  /** Makes the surface of faces that follow none. */
  static Surface faces();

  Kind kind() const {
    return kind_;
  }
  /** Returns "plane", "sphere", "cylinder" or "faces". */
  static std::string name(Kind kind);
  std::string name() const {
    return name(kind_);
  }
  bool is_flat() const {
    return kind_ == Kind::plane;
  }
  /** Returns whether it is a sphere or a cylinder. */
  bool is_curved() const {
    return kind_ == Kind::sphere || kind_ == Kind::cylinder;
  }
  bool has_normals() const {
    return kind_ != Kind::faces;
  }
  /** Returns a point of the plane or of the axis, or the centre. */
  const Point<3> &point() const {
    return point_;
  }
  /** Returns the unit normal of the plane, or the unit vector along the axis. */
  const Tensor<1, 3> &axis() const {
    return axis_;
  }
  /** Returns the radius; zero without one (length). */
  double radius() const {
    return radius_;
  }
  Body body() const {
    return body_;
  }

  /** Returns the nearest point of the surface; a centre, and a point of the axis, itself. */
  Point<3> project(const Point<3> &x) const;
  /** Returns the unit normal out of the body at the nearest point of the surface, which has
   * normals. */
  Tensor<1, 3> normal(const Point<3> &x) const;

private:
  Surface(Kind kind, const Point<3> &point, const Tensor<1, 3> &axis, double radius, Body body);

  /** Returns x - point() without its part along the axis of a cylinder. */
  Tensor<1, 3> arm(const Point<3> &x) const;

  Kind kind_;
  Point<3> point_;
  Tensor<1, 3> axis_;
  double radius_;
  Body body_;
};

/** The corners of a face of the mesh, in the order of deal.II: (0,0), (1,0), (0,1), (1,1). */
using FaceCorners = std::array<Point<3>, 4>;

/** The corners at the ends of the edges of a face, in the order of deal.II: those on which the
 * first coordinate is 0 and 1, then the second one. */
constexpr std::array<unsigned int, 2> edges_of_face[] = {{{0, 2}}, {{1, 3}}, {{0, 1}}, {{2, 3}}};

/** Returns whether the first coordinate is less, of equal ones the second, of equal ones the third.
 */
inline bool lies_before(const Point<3> &a, const Point<3> &b) {
  return std::tie(a[0], a[1], a[2]) < std::tie(b[0], b[1], b[2]);
}

/** The coordinates of the ends of an edge: a key, equal to the last digit for faces that share the
 * edge. */
using EdgeKey = std::array<double, 6>;

/** Returns the key of an edge, whatever its direction. */
inline EdgeKey edge_key(const Point<3> &a, const Point<3> &b) {
  const auto &[first, last] = lies_before(b, a) ? std::tie(b, a) : std::tie(a, b);
  return {{first[0], first[1], first[2], last[0], last[1], last[2]}};
}

/** Returns the point of the bilinear face at the reference coordinates @p xi. */
Point<3> point_on(const FaceCorners &corners, const Point<2> &xi);

/** Returns dx/dxi_1 × dx/dxi_2 of the bilinear face: its norm is the surface element, and its
 * direction that of the normal, up to the sign. */
Tensor<1, 3> area_vector(const FaceCorners &corners, const Point<2> &xi);

/** Returns the area of the bilinear face, exactly if its corners lie in a plane (length²). */
double area_of(const FaceCorners &corners);

/**
 * A part of the boundary of a body in space: a surface, and faces of the coarse mesh on it, or
 * larger quadrilaterals of the same shape.
 */
class SurfacePart {
public:
  /** Stores both. The corners of all faces run round the outward normal: (x_1 - x_0) × (x_2 - x_0)
   * points out of the body. */
  SurfacePart(const Surface &surface, std::vector<FaceCorners> faces);

  const Surface &surface() const {
    return surface_;
  }
  const std::vector<FaceCorners> &faces() const {
    return faces_;
  }
  bool is_flat() const {
    return surface_.is_flat();
  }
  /** Returns the nearest point of the surface. */
  Point<3> project(const Point<3> &x) const {
    return surface_.project(x);
  }
  /** Returns the outward normal at the nearest point of the surface; of faces without a surface
   * that of the nearest face, at its nearest point. */
  Tensor<1, 3> normal_at(const Point<3> &x) const;
  /** Returns the area of the faces (length²). */
  double area() const {
    return area_;
  }
  /** Returns the mean of the side, projected to it. */
  const Point<3> &centre() const {
    return centre_;
  }
  /** Returns points in a grid on every face, its edges included, @p n intervals in each direction,
   * on the surface. */
  std::vector<SurfacePoint<3>> samples(unsigned int n) const;
  /** Returns points all over the side: eight intervals, or one where there are many faces. */
  std::vector<SurfacePoint<3>> samples() const {
    constexpr std::size_t many = 50;
    return samples(faces_.size() > many ? 1 : 8);
  }
  /** Returns the lengths of the edges of a rectangle, the first one along the edge from corner 0 to
   * corner 1; zeros where the part is none. */
  std::array<double, 2> rectangle() const;

private:
  Surface surface_;
  std::vector<FaceCorners> faces_;
  double area_;
  Point<3> centre_;
};
} // namespace Signorini
