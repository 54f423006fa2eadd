// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/surface.h>

#include <deal.II/base/point.h>

#include <vector>

namespace Signorini {
/** A surface through points of a side, and how well it fits. */
struct SurfaceFit {
  Surface surface;
  /** The largest distance of a point from the surface (length). */
  double residual;
  /** The least singular value of the derivatives of all distances by the numbers of the surface
   * over the largest one, for an extent of the points of one: where it is small, rounded points do
   * not tell the surface. */
  double condition;
  /** Whether the normals of all faces are on the same side of the surface. */
  bool follows_normals;
};

/** Points of a part of the boundary, and the faces between them. */
struct SurfaceSamples {
  /** Nodes, those in the middles of edges and faces of second order, too. */
  std::vector<Point<3>> points;
  /** The middle of every face, and its normal out of the body. */
  std::vector<SurfacePoint<3>> faces;
};

/**
 * Returns the surface of the points. It is a plane if all points are within 1e-6 of their extent.
 * Otherwise it is a sphere or a cylinder, the nearer one, with a residual of at most 1e-6 radii,
 * condition >= 1e-5 and normals on one side. The points must tell it from other surfaces: those of
 * a cylinder lie on four lines or more (three belong to every row of faces of second order), those
 * of a sphere on more than two parallel circles (two belong to every cone). Otherwise it is a
 * surface of faces.
 */
SurfaceFit fit_surface(const SurfaceSamples &samples);

/**
 * Returns the surface of a given kind for which the sum of squares of the distances is least. The
 * caller judges it; where there is none, it is a surface of faces with an infinite residual.
 * Points on two lines have no cylinder and points on one circle no sphere: condition is zero.
 */
SurfaceFit fit_surface(const SurfaceSamples &samples, Surface::Kind kind);
} // namespace Signorini
