// SPDX-License-Identifier: LGPL-2.1-or-later
// Values of expressions, checked at points that the integrals will use or come close to.

#include <signorini/base/instantiate.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/functions.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "input.h"

namespace Signorini {
namespace {
template <int dim>
using Points = std::vector<Point<dim>>;

/** Returns points of the unit cube: products of Gauss points and points close to the ends, or the
 * ends. An even number of Gauss points leaves out lines of symmetry, on which kinks lie. */
template <int dim>
Points<dim> unit_points(const unsigned int n_gauss, const bool with_ends = false) {
  Points<1> line = {Point<1>(1e-4), Point<1>(1. - 1e-4)};
  const QGauss<1> gauss(n_gauss);
  line.insert(line.end(), gauss.get_points().begin(), gauss.get_points().end());
  if (with_ends)
    line.insert(line.end(), {Point<1>(0.), Point<1>(1.)});
  return Quadrature<dim>(Quadrature<1>(line)).get_points();
}

/** Returns points inside of a side and, for data that is evaluated at nodes, at its ends. */
Points<2> sample_side(const Side<2> &side, const bool with_ends) {
  // A side of very many pieces has short ones.
  const unsigned int n_gauss = side.n_pieces() > 100 ? 1 : 12;
  Points<2> points;
  for (unsigned int k = 0; k < side.n_pieces(); ++k)
    for (const Point<1> &share : unit_points<1>(n_gauss, with_ends))
      points.push_back(side.piece(k).point(share[0] * side.piece(k).length()));
  return points;
}
Points<3> sample_side(const Side<3> &side, const bool with_ends) {
  // A side of very many faces has small ones.
  const unsigned int n_gauss = side.faces().size() > 20 ? 1 : 12;
  Points<3> points;
  for (const FaceCorners &face : side.faces())
    for (const Point<2> &share : unit_points<2>(n_gauss, with_ends))
      points.push_back(side.project(point_on(face, share)));
  return points;
}

/** Returns points of the segments from the middle of a body to its sides; of other bodies, points
 * of the cells of the coarse mesh, or of some cells if there are very many. */
template <int dim>
Points<dim> sample_body(const Geometry<dim> &geometry) {
  Points<dim> points;
  if (geometry.star_shaped) {
    const Point<dim> inside = geometry.inner_point();
    for (const Side<dim> &side : geometry.sides)
      for (const Point<dim> &x : sample_side(side, false))
        for (const Point<1> &share : unit_points<1>(dim == 2 ? 12 : 2))
          points.push_back(inside + share[0] * (x - inside));
    return points;
  }
  constexpr unsigned int few = 20, enough = 500;
  Triangulation<dim> mesh;
  geometry.make_coarse_mesh(mesh);
  const unsigned int n_cells = mesh.n_active_cells(), stride = 1 + n_cells / enough;
  const MappingQ1<dim> mapping;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->active_cell_index() % stride == 0)
      for (const Point<dim> &q : unit_points<dim>(n_cells > few ? 2 : 12))
        points.push_back(mapping.transform_unit_to_real_cell(cell, q));
  return points;
}

/** Refuses values that are no numbers, or too large. */
template <int dim>
void check_finite(const FunctionPointer<dim> &function, const Points<dim> &points,
                  const std::string &where) {
  if (function == nullptr)
    return;
  for (const Point<dim> &x : points)
    for (unsigned int c = 0; c < function->n_components; ++c)
      check_magnitude(function->value(x, c), c, x, where);
}

/** Refuses values of a function that are above a share of the largest one times @p sign, 1 or -1,
 * under a @p name. */
template <int dim>
void check_sign(const FunctionPointer<dim> &function, const Points<dim> &points,
                const std::string &where, const double sign, const double share,
                const std::string &name, const std::string &allowed) {
  if (function == nullptr)
    return;
  check_finite(function, points, where);
  double largest = 0.;
  for (const Point<dim> &x : points)
    largest = std::max(largest, std::abs(function->value(x)));
  for (const Point<dim> &x : points)
    if (sign * function->value(x) > share * largest)
      refuse_value(where, name + number_text(function->value(x)), x, allowed);
}

/**
 * Checks a gradient given by expressions against the derivatives of the displacement at points
 * inside the body. Points where they are not finite are skipped.
 * @throws InputError if it is wrong at three points.
 */
template <int dim>
void check_exact_gradient(const ExactSolutionParameters &exact, const Scene<dim> &scene,
                          const Points<dim> &points) {
  if (exact.displacement_gradient.value.empty())
    return;
  const auto &u = dynamic_cast<const ExpressionFunction<dim> &>(*scene.exact_displacement);
  double max_u = 0.;
  for (const Point<dim> &x : points)
    for (unsigned int c = 0; c < dim; ++c)
      max_u = std::max(max_u, std::abs(u.value(x, c)));
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d) {
      unsigned int n_objections = 0;
      for (const Point<dim> &x : points) {
        const double given = u.gradient(x, c)[d], found = u.exact_gradient(x, c)[d];
        const double tolerance =
          1e-4 * max_u / scene.geometry.shortest_extent() + 1e-3 * std::abs(found);
        n_objections += std::isfinite(found) && !(std::abs(found - given) <= tolerance);
        if (n_objections == 3)
          refuse_value(exact.displacement_gradient.where(),
                       "du" + std::to_string(c + 1) + "/d" + "xyz"[d] + " = " + number_text(given),
                       x,
                       number_text(found) + ", the derivative of " + exact.displacement.name +
                         ", or no gradient");
      }
    }
}

/** Returns u.n of the other body of a contact, at the point across from @p x, for the normal n of
 * the side; zero where there is none. */
template <int dim, typename Displacement>
double motion_across(const Scene<dim> &scene, const ContactPair<dim> &pair, const Point<dim> &x,
                     const Displacement &u) {
  if constexpr (dim == 2)
    if (const auto &other = pair.other_side()) {
      const Side<2> &side = scene.geometry.sides[pair.side()];
      const Tensor<1, 2> n = side.normal_at(x);
      if (const auto distance = scene.geometry.sides[*other].distance_along(x, n))
        return u(x + *distance * n) * n;
    }
  return 0.;
}

/**
 * Checks that an exact displacement satisfies the condition on a side: u = 0, u·n = 0,
 * u = u_D, or u·n <= g.
 * @throws InputError
 */
template <int dim>
void check_exact_on_side(const ExactSolutionParameters &exact, const Scene<dim> &scene,
                         const unsigned int i, const Points<dim> &points) {
  if (scene.exact_displacement == nullptr)
    return;
  const Side<dim> &side = scene.geometry.sides[i];
  const BoundaryCondition<dim> &condition = scene.boundary[i];
  const auto u_at = [&](const Point<dim> &x) {
    Tensor<1, dim> u;
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = scene.exact_displacement->value(x, c);
    return u;
  };
  double size = u_at(scene.geometry.inner_point()).norm();
  for (const Point<dim> &x : points)
    size = std::max(size, u_at(x).norm());
  // Constants may have few digits.
  constexpr double share = 1e-4;
  for (const Point<dim> &x : points) {
    const auto refuse = [&](const std::string &name, const double found,
                            const std::string &allowed) {
      refuse_value(exact.displacement.where(),
                   name + " = " + number_text(found) + " on the side " + side.name(), x, allowed);
    };
    const Tensor<1, dim> u = u_at(x);
    if (condition.role == Role::clamped || condition.role == Role::displacement)
      for (unsigned int c = 0; c < dim; ++c) {
        const double given = condition.data == nullptr ? 0. : condition.data->value(x, c);
        if (!(std::abs(u[c] - given) <= share * (size + std::abs(given))))
          refuse("u" + std::to_string(c + 1), u[c],
                 number_text(given) + ", which is prescribed there");
      }
    if (const double u_n = u * side.normal_at(x);
        condition.role == Role::roller && !(std::abs(u_n) <= share * size))
      refuse("u.n", u_n, "0 on rollers");
    for (const ContactPair<dim> &pair : contact_pairs(scene)) {
      if (pair.side() != i || (pair.other_side() && !pair.contains(x)))
        continue;
      const double gap = pair.gap(x),
                   closing = u * pair.direction(x) - motion_across(scene, pair, x, u_at);
      if (!(closing <= gap + share * size))
        refuse("u.n", closing, "at most the gap " + number_text(gap));
    }
  }
}
} // namespace

template <int dim>
void check_moduli(const std::vector<Expression<dim>> &moduli, const Geometry<dim> &geometry) {
  for (const Point<dim> &x : sample_body(geometry)) {
    double largest = 0.;
    for (const Expression<dim> &modulus : moduli)
      largest = std::max(largest, std::abs(modulus(x)));
    // The material checks signs, and refuses values that are no numbers.
    if (largest > max_magnitude || (largest > 0. && largest < min_magnitude))
      refuse_value(moduli[0].where(), number_text(largest), x,
                   "moduli from " + number_text(min_magnitude) + " to " +
                     number_text(max_magnitude) + "; take other units");
  }
}

namespace {
/** Refuses conditions that need a surface on faces that follow none, and friction on curved sides:
 * tangents of patches turn along these. */
void check_surfaces(const Parameters &parameters, const Scene<3> &scene) {
  const std::string surfaces = "sides on a plane, a cylinder or a sphere (Geometry/Surfaces).";
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    const Side<3> &side = scene.geometry.sides[i];
    if (scene.boundary[i].role == Role::roller && !side.surface().has_normals())
      throw error_at(parameters.boundary.rollers, "found '", side.name(),
                     "', whose faces follow no surface, allowed: ", surfaces);
    if (scene.has_contact_on(i) && !side.is_flat() && scene.contact_law.has_tangential_part())
      throw error_at(parameters.contact.law, "found friction on '", side.name(),
                     "', which is not plane, allowed in space: friction on plane sides.");
  }
}
} // namespace

template <int dim>
void check_described_scene(const Parameters &parameters, const Scene<dim> &scene) {
  if constexpr (dim == 3)
    check_surfaces(parameters, scene);
  const ExactSolutionParameters &exact = parameters.exact;
  const Points<dim> body = sample_body(scene.geometry);
  for (const Point<dim> &x : body)
    scene.material->hooke(x);
  // Data of the problem refuses values itself, and names its own entry.
  check_finite(scene.body_force, body, "");
  check_finite(scene.exact_displacement, body, exact.displacement.where());
  check_exact_gradient(exact, scene, body);
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    const BoundaryCondition<dim> &condition = scene.boundary[i];
    const Side<dim> &side = scene.geometry.sides[i];
    check_finite(condition.data, sample_side(side, condition.role != Role::traction), "");
    check_exact_on_side(exact, scene, i, sample_side(side, false));
  }
  for (const ContactCondition<dim> &contact : scene.contacts) {
    const Side<dim> &side = scene.geometry.sides[contact.side];
    const Points<dim> inside = sample_side(side, false);
    check_finite(contact.gap, sample_side(side, true), "");
    for (const auto &limit : scene.contact_law.limits())
      check_sign(contact.*limit.data, inside, (parameters.contact.*limit.entry).where(), -1., 0.,
                 "the negative value ", "0 or more on the whole side");
    check_finite(contact.shift, inside, "");
    // Contact cannot pull.
    check_sign(contact.exact_pressure, inside, exact.pressure.where(), 1., 1e-6, "the tension ",
               "p = sigma_n <= 0, negative in compression");
  }
}

INSTANTIATE_FUNCTION(check_moduli);
INSTANTIATE_FUNCTION(check_described_scene);
} // namespace Signorini
