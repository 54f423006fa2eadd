// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <map>
#include <string>

#include "tests.h"

/** Measures of a mesh of curved cells: integrals, and how far its faces are off the sides.
 */
struct Measures {
  double area = 0., length = 0.;
  std::map<std::string, double> lengths;
  /** int n ds. */
  dealii::Tensor<1, 2> normals;
  /** Smallest over largest Jacobian of a cell; distances of points and of normals from the sides.
   */
  double shape = 1., off = 0., turned = 0.;
};

inline Measures measure(const Signorini::Geometry<2> &geometry,
                        const dealii::Triangulation<2> &mesh, const unsigned int degree) {
  using namespace dealii;
  const MappingQ<2> mapping(degree);
  const FE_Nothing<2> nothing;
  FEValues<2> corners(mapping, nothing, QGaussLobatto<2>(5), update_jacobians),
    cells(mapping, nothing, QGauss<2>(6), update_JxW_values);
  FEFaceValues<2> faces(mapping, nothing, QGauss<1>(6),
                        update_JxW_values | update_normal_vectors | update_quadrature_points);
  Measures found;
  for (const auto &cell : mesh.active_cell_iterators()) {
    cells.reinit(cell);
    corners.reinit(cell);
    for (const unsigned int q : cells.quadrature_point_indices())
      found.area += cells.JxW(q);
    std::vector<double> determinants;
    for (const unsigned int q : corners.quadrature_point_indices())
      determinants.push_back(corners.jacobian(q).determinant());
    const auto [smallest, largest] = std::minmax_element(determinants.begin(), determinants.end());
    found.shape = std::min(found.shape, *smallest / *largest);
    for (const unsigned int f : cell->face_indices()) {
      if (!cell->at_boundary(f))
        continue;
      const Signorini::Side<2> &side = geometry.sides.at(cell->face(f)->boundary_id());
      faces.reinit(cell, f);
      for (const unsigned int q : faces.quadrature_point_indices()) {
        const Point<2> &x = faces.quadrature_point(q);
        const double s = side.arc_length(x);
        found.length += faces.JxW(q);
        found.lengths[side.name()] += faces.JxW(q);
        found.normals += faces.JxW(q) * faces.normal_vector(q);
        found.off = std::max(found.off, side.point(s).distance(x));
        found.turned = std::max(found.turned, (side.normal(s) - faces.normal_vector(q)).norm());
      }
    }
  }
  return found;
}
