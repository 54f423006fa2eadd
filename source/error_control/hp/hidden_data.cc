// SPDX-License-Identifier: LGPL-2.1-or-later
// Layers and bumps between the points of the first mesh.

#include <signorini/base/errors.h>
#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/error_control/hp/hidden_data.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace Signorini {
namespace {
/** The limits of splitting. A material whose layers need more splits is refused; loads, and the
 * data of sides, are integrated on the parts of cells. */
constexpr unsigned int max_splits_in_body = 16, max_splits_for_loads = 6, max_split_cells = 2000;

/** The positions of the lines of a cell that are sampled. Near their ends the distances are 2^-k.
 */
constexpr std::array<double, 5> sampled_lines = {{0.081, 0.293, 0.517, 0.714, 0.923}};
constexpr unsigned int n_points_at_ends = 20;

using Values = std::vector<double>;

/** Returns positions between 0 and 1: @p n at equal distances, then those near the ends. */
std::vector<double> sample_positions(const unsigned int n) {
  std::vector<double> positions;
  for (unsigned int i = 0; i < n; ++i)
    positions.push_back((i + 0.5) / n);
  for (unsigned int k = 2; k < n_points_at_ends; ++k)
    positions.insert(positions.end(), {std::pow(0.5, k), 1. - std::pow(0.5, k)});
  return positions;
}

/** Returns a point of a cell, bilinear in its reference coordinates. */
Point<2> point_of(const Triangulation<2>::active_cell_iterator &cell, const double s,
                  const double t) {
  return Point<2>((1. - s) * (1. - t) * cell->vertex(0) + s * (1. - t) * cell->vertex(1) +
                  (1. - s) * t * cell->vertex(2) + s * t * cell->vertex(3));
}

/** Returns the logarithms of the moduli. */
Values log_moduli(const Material<2> &material, const Point<2> &x) {
  const SymmetricTensor<4, 2> E = material.relative_hooke(x);
  return {std::log(E[0][0][0][0]), std::log(E[1][1][1][1]), std::log(E[0][1][0][1])};
}

/** Returns the largest E_a/E_h - 1, with the arithmetic and the harmonic mean of each modulus on a
 * cell, where the moduli jump; zero where they do not. */
double jump_share(const Material<2> &material, const Triangulation<2>::active_cell_iterator &cell) {
  constexpr unsigned int n = 16;
  const double min_jump = std::log(1.5);
  std::array<std::array<Values, n>, n> at;
  std::array<double, 3> sum = {}, sum_of_inverses = {};
  bool jumps = false;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j) {
      at[i][j] = log_moduli(material, point_of(cell, (i + 0.5) / n, (j + 0.5) / n));
      for (unsigned int c = 0; c < sum.size(); ++c) {
        const double here = at[i][j][c];
        sum[c] += std::exp(here);
        sum_of_inverses[c] += std::exp(-here);
        jumps = jumps || (i > 0 && std::abs(here - at[i - 1][j][c]) > min_jump) ||
                (j > 0 && std::abs(here - at[i][j - 1][c]) > min_jump);
      }
    }
  double share = 0.;
  for (unsigned int c = 0; jumps && c < sum.size(); ++c)
    share = std::max(share, sum[c] * sum_of_inverses[c] / std::pow(n, 4) - 1.);
  return share;
}

/** The range of the values at the points of a rule; is_far() returns whether another value is far
 * from all of them. */
class SampledRange {
public:
  void add(const Values &values) {
    if (low_.empty())
      low_ = high_ = values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      low_[i] = std::min(low_[i], values[i]);
      high_[i] = std::max(high_[i], values[i]);
    }
  }
  double width() const {
    double largest = 0.;
    for (std::size_t i = 0; i < low_.size(); ++i)
      largest = std::max(largest, high_[i] - low_[i]);
    return largest;
  }
  bool is_far(const Values &values, const double tolerance) const {
    for (std::size_t i = 0; i < std::min(values.size(), low_.size()); ++i) {
      const double slack = 0.5 * (high_[i] - low_[i]) + tolerance;
      if (values[i] < low_[i] - slack || values[i] > high_[i] + slack)
        return true;
    }
    return false;
  }

private:
  Values low_, high_;
};

/** Decides about splits of cells while a mesh is made. */
class DataProbe {
public:
  using Cell = Triangulation<2>::active_cell_iterator;

  DataProbe(const Scene<2> &scene, MeshPlan &plan)
    : scene_(scene)
    , plan_(plan) {}

  bool must_split(const Cell &cell, const unsigned int n_splits) {
    if (plan_.must_split(scene_, cell, n_splits))
      return true;
    if (!checked_cells_.insert(cell->id()).second)
      return false;
    const unsigned int n =
      std::clamp<unsigned int>(4e4 / cell->get_triangulation().n_active_cells(), 16, max_points);
    const std::optional<Point<2>> place = hidden_in(cell, n);
    if (!place && !is_rough(cell))
      return false;
    if (n_splits >= (place ? max_splits_in_body : max_splits_for_loads) ||
        n_split_ >= max_split_cells) {
      hidden_ = place;
      return false;
    }
    ++n_split_;
    plan_.demands[cell->id()].split = true;
    return true;
  }
  /** Returns the place where the material hides after all splits. */
  const std::optional<Point<2>> &hidden() const {
    return hidden_;
  }

private:
  static constexpr unsigned int max_points = 1000;

  std::optional<Point<2>> hidden_in(const Cell &cell, const unsigned int n) const {
    if (scene_.material->is_constant())
      return {};
    const auto moduli = [this](const Point<2> &x) { return log_moduli(*scene_.material, x); };
    constexpr double tolerance = 0.01;
    SampledRange seen;
    const QGauss<2> gauss(n_gauss);
    for (const Point<2> &x : gauss.get_points())
      seen.add(moduli(point_of(cell, x[0], x[1])));
    for (const double s : sample_positions(n))
      for (const double t : sampled_lines)
        for (const Point<2> &x : {point_of(cell, s, t), point_of(cell, t, s)})
          if (seen.is_far(moduli(x), tolerance))
            return x;
    return {};
  }

  /** Returns whether the data of the body or of a side varies too fast for the plain rule. */
  bool is_rough(const Cell &cell) const {
    if (scene_.kinks.boxes().divides(cell->bounding_box()))
      return true;
    const Kinks<2> &kinks = scene_.kinks;
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && kinks.has_breaks(face->vertex(0), face->vertex(1)))
        return true;
    return false;
  }

  static constexpr unsigned int n_gauss = 4;
  const Scene<2> &scene_;
  MeshPlan &plan_;
  /** The cells in which nothing hides. */
  std::set<CellId> checked_cells_;
  unsigned int n_split_ = 0;
  std::optional<Point<2>> hidden_;
};
} // namespace

std::optional<Point<2>> resolve_hidden_data(const Scene<2> &scene, MeshPlan &plan) {
  DataProbe probe(scene, plan);
  const Mesh<2> mesh(
    scene.geometry, plan.base_level, plan.lines,
    [&probe](const DataProbe::Cell &cell, const unsigned int n_splits) {
      return probe.must_split(cell, n_splits);
    },
    2);
  return probe.hidden();
}

void add_jump_misfit(const DisplacementSpace<2> &space, const Scene<2> &scene,
                     const Displacement &U, std::vector<CellIndicator> &indicators) {
  if (scene.material->is_constant())
    return;
  CellStiffness<2> stiffness(space, scene);
  const double unit = stiffness_unit(space, *scene.material);
  dealii::Vector<double> on_cell;
  for (const auto &cell : space.dofs().active_cell_iterators()) {
    const double share = jump_share(*scene.material, cell);
    if (share == 0.)
      continue;
    on_cell.reinit(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_values(U, on_cell);
    double &error = indicators[cell->active_cell_index()].error;
    error = std::sqrt(error * error +
                      share * unit * std::max(0., stiffness(cell).matrix_norm_square(on_cell)));
  }
}
} // namespace Signorini
