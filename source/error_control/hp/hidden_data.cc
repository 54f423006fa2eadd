// SPDX-License-Identifier: LGPL-2.1-or-later
// Layers and bumps between the points of the first mesh.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/space/cell_stiffness.h>
#include <signorini/error_control/equilibration/arc_lift.h>
#include <signorini/error_control/equilibration/cell_shape.h>
#include <signorini/error_control/hp/hidden_data.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Signorini {
namespace {
using Values = std::vector<double>;

/** Returns the logarithms of the moduli. */
Values log_moduli(const Material<2> &material, const Point<2> &x) {
  const SymmetricTensor<4, 2> E = material.relative_hooke(x);
  return {std::log(E[0][0][0][0]), std::log(E[1][1][1][1]), std::log(E[0][1][0][1])};
}

/** Returns the largest E_a/E_h - 1, with the arithmetic and the harmonic mean of each modulus on a
 * cell, where the moduli jump; zero where they do not. */
double jump_share(const Material<2> &material, const Mesh<2> &mesh,
                  const Triangulation<2>::active_cell_iterator &cell) {
  constexpr unsigned int n = 16;
  const double min_jump = std::log(1.5);
  const CellShape shape(corners_of(cell));
  // Beyond the chord of a curved side another body may begin.
  const bool bends = mesh.is_curved() && cell->at_boundary();
  std::array<std::array<Values, n>, n> at;
  std::array<double, 3> sum = {}, sum_of_inverses = {};
  bool jumps = false;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j) {
      const Point<2> position((i + 0.5) / n, (j + 0.5) / n);
      at[i][j] =
        log_moduli(material, bends ? mesh.mapping().transform_unit_to_real_cell(cell, position)
                                   : shape.point(CellFunctions({position[0], position[1]})));
      for (unsigned int c = 0; c < sum.size(); ++c) {
        const double value = at[i][j][c];
        sum[c] += std::exp(value);
        sum_of_inverses[c] += std::exp(-value);
        jumps = jumps || (i > 0 && std::abs(value - at[i - 1][j][c]) > min_jump) ||
                (j > 0 && std::abs(value - at[i][j - 1][c]) > min_jump);
      }
    }
  double share = 0.;
  for (unsigned int c = 0; jumps && c < sum.size(); ++c)
    share = std::max(share, sum[c] * sum_of_inverses[c] / std::pow(n, 4) - 1.);
  return share;
}

/** Returns whether stresses on a cell cannot carry tractions on one of its arcs, or an edge inside
 * of a curved body bends so much that nodes that hang on its chord leave its thin cells. */
bool is_too_bent(const Scene<2> &scene, const Triangulation<2>::active_cell_iterator &cell) {
  constexpr double largest_bend = 0.35;
  const CellShape shape = shape_of(cell, scene.geometry.sides);
  if (!ArcLift::sees_arcs(shape))
    return true;
  for (const auto &face : cell->face_iterators())
    if (const double length = face->diameter();
        !face->at_boundary() && face->center(true).distance(face->center()) * length >
                                  largest_bend * std::abs(shape.area()))
      return true;
  return false;
}

/** Returns |K|^{1/2} ‖f - c‖_K, c the mean of f on a cell K, and ∫_K |f|. */
std::pair<double, double> variation_and_sum(const Scene<2> &scene,
                                            const Triangulation<2>::active_cell_iterator &cell) {
  constexpr unsigned int n_points = 2;
  const PlaneRule rule = cut_rule(scene.kinks, corners_of(cell), n_points);
  std::vector<dealii::Vector<double>> f(rule.points.size(), dealii::Vector<double>(2));
  scene.body_force->vector_value_list(rule.points, f);
  Tensor<1, 2> force;
  double area = 0., sum = 0., square = 0.;
  for (std::size_t q = 0; q < f.size(); ++q) {
    const Tensor<1, 2> f_q({f[q][0], f[q][1]});
    area += rule.weights[q];
    sum += rule.weights[q] * f_q.norm();
    force += rule.weights[q] * f_q;
    square += rule.weights[q] * f_q.norm_square();
  }
  return {std::sqrt(std::max(0., area * square - force.norm_square())), sum};
}

/** Finds the cells in which data hides from elements of the first degree. */
class HidingCells {
public:
  HidingCells(const Scene<2> &scene, const MeshPlan &plan)
    : scene_(scene) {
    if (scene.body_force == nullptr)
      return;
    const Mesh<2> mesh(
      scene.geometry, plan.base_level, plan.guides,
      [](const auto &, unsigned int) { return false; }, 1);
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      force_ += variation_and_sum(scene, cell).second;
  }

  bool contain(const Triangulation<2>::active_cell_iterator &cell) const {
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && scene_.kinks.has_breaks(face->vertex(0), face->vertex(1)))
        return true;
    return is_divided(scene_.law_kinks, cell) || hides_force(cell);
  }

private:
  /** Returns whether a cell has many boxes. A few hide nothing from elements of higher degree.
   * Where none of the smallest boxes shows its data, small cells would not either. */
  static bool is_divided(const Kinks<2> &kinks,
                         const Triangulation<2>::active_cell_iterator &cell) {
    constexpr unsigned int few = 6;
    return kinks.boxes().divides(cell->bounding_box(), few) &&
           kinks.boxes().shows_some(cell->bounding_box());
  }

  /** Returns whether much of the body force is concentrated on a small part of a cell, or some of
   * it varies in many boxes. */
  bool hides_force(const Triangulation<2>::active_cell_iterator &cell) const {
    constexpr double much = 0.1, some = 1e-5;
    if (!(force_ > 0.) || !varies_fast(scene_.kinks, cell))
      return false;
    const double share = variation_and_sum(scene_, cell).first / force_;
    return share > much || (share > some && is_divided(scene_.kinks, cell));
  }

  const Scene<2> &scene_;
  /** ∫ |f|. */
  double force_ = 0.;
};
} // namespace

void resolve_hidden_data(const Scene<2> &scene, MeshPlan &plan) {
  constexpr unsigned int max_splits = 6, max_split_cells = 2000;
  unsigned int n_split = 0;
  const HidingCells hiding_cells(scene, plan);
  const Mesh<2> mesh(
    scene.geometry, plan.base_level, plan.guides,
    [&](const Triangulation<2>::active_cell_iterator &cell, const unsigned int n_splits) {
      if (plan.must_split(scene, cell, n_splits))
        return true;
      if (n_splits >= max_splits || n_split >= max_split_cells ||
          !(hiding_cells.contain(cell) || is_too_bent(scene, cell)))
        return false;
      ++n_split;
      return plan.demands[cell->id()].split = true;
    },
    2);
}

JumpMisfit add_jump_misfit(const DisplacedBody<2> &body, std::vector<CellIndicator> &indicators) {
  const Material<2> &material = *body.scene.material;
  JumpMisfit sum;
  if (material.is_constant())
    return sum;
  CellStiffness<2> stiffness(body.space, body.scene);
  const double unit = stiffness_unit(body.space, material);
  dealii::Vector<double> on_cell;
  for (const auto &cell : body.space.dofs().active_cell_iterators()) {
    const double share = jump_share(material, body.space.mesh(), cell);
    if (share == 0.)
      continue;
    on_cell.reinit(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_values(body.U, on_cell);
    double &error = indicators[cell->active_cell_index()].error;
    const double square = share * unit * std::max(0., stiffness(cell).matrix_norm_square(on_cell));
    error = std::sqrt(error * error + square);
    sum.square += square;
    ++sum.n_cells;
  }
  return sum;
}
} // namespace Signorini
