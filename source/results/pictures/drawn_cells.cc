// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement and stress at the corners of what is drawn.

#include "drawn_cells.h"

#include <signorini/base/errors.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/postprocessing/fields/stress.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace Signorini
{
namespace
{
constexpr unsigned int max_cells = 10000;

/** Evaluates the drawn displacement and its stress on active cells. The stress is that of the
 * interpolation that largest_von_mises() uses, too. */
class FieldSampler
{
public:
  FieldSampler(const DisplacementSpace<2> &space, const Scene<2> &scene, const Displacement &U)
    : space_(space)
    , material_(*scene.material)
    , U_(U)
    , dilatation_(space.strain_operator() == StrainOperator::mean_dilatation
                    ? mean_dilatations(space, U)
                    : std::vector<double>())
    , interpolated_(!space.has_several_elements() && space.mesh().has_parents())
  {
    if (interpolated_)
      interpolation_.emplace(space, Quadrature<2>(), 1);
  }

  /** Returns the values at the points of a rule. @param rule_number the number of the rule among
   * those used with this element. */
  std::vector<DrawnPoint> at(const DisplacementSpace<2>::CellIterator &cell,
                             const unsigned int rule_number,
                             const Quadrature<2> &rule)
  {
    const auto dof_cell = space_.dof_cell(cell);
    std::unique_ptr<FEValues<2>> &values = values_[{space_.element_number(cell), rule_number}];
    if (values == nullptr)
      values = std::make_unique<FEValues<2>>(space_.mesh().mapping(),
                                             space_.element(cell),
                                             rule,
                                             update_values | update_gradients |
                                               update_inverse_jacobians | update_quadrature_points);
    values->reinit(dof_cell);
    std::vector<Tensor<1, 2>> u(values->n_quadrature_points);
    std::vector<Tensor<2, 2>> gradients(values->n_quadrature_points);
    const FEValuesExtractors::Vector displacement(0);
    (*values)[displacement].get_function_values(U_.entries(), u);
    if (interpolated_)
      gradients = interpolation_->evaluate(U_, dof_cell, *values).gradients;
    else
      (*values)[displacement].get_function_gradients(U_.entries(), gradients);
    std::vector<DrawnPoint> points(values->n_quadrature_points);
    for (const unsigned int q : values->quadrature_point_indices())
    {
      SymmetricTensor<2, 2> strain = symmetrize(gradients[q]);
      if (!dilatation_.empty())
        replace_trace(strain, dilatation_[cell->active_cell_index()]);
      const Point<2> &x = values->quadrature_point(q);
      points[q] = {x, u[q], stress_at(x, strain)};
    }
    return points;
  }

private:
  double stress_at(const Point<2> &x, const SymmetricTensor<2, 2> &strain) const
  {
    try
    {
      return von_mises(stress_in_3d(material_, x, strain));
    }
    catch (const InputError &)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

  const DisplacementSpace<2> &space_;
  const Material<2> &material_;
  const Displacement &U_;
  const std::vector<double> dilatation_;
  const bool interpolated_;
  std::optional<PatchInterpolation<2>> interpolation_;
  /** The values by the number of the element and of the rule. */
  std::map<std::pair<unsigned int, unsigned int>, std::unique_ptr<FEValues<2>>> values_;
};

/** Returns (n+1)² points of the reference cell, row after row. */
Quadrature<2> lattice(const unsigned int n)
{
  std::vector<Point<2>> points;
  for (unsigned int j = 0; j <= n; ++j)
    for (unsigned int i = 0; i <= n; ++i)
      points.emplace_back(static_cast<double>(i) / n, static_cast<double>(j) / n);
  return Quadrature<2>(points);
}

/** Returns the number of parts of a cell per direction. */
unsigned int n_parts(const DisplacementSpace<2> &space,
                     const DisplacementSpace<2>::CellIterator &cell)
{
  constexpr double parts_of_body = 48.;
  constexpr unsigned int most = 12;
  const double size = space.mesh().size() / parts_of_body;
  return std::min(most, static_cast<unsigned int>(std::ceil(0.7 * cell->diameter() / size)));
}

/** Returns an ancestor of active cells. Its corners are corners of active cells, whose values they
 * get. */
DrawnCell coarse_cell(const Triangulation<2>::cell_iterator &cell, FieldSampler &sampler)
{
  DrawnCell drawn;
  for (const unsigned int v : GeometryInfo<2>::vertex_indices())
  {
    Triangulation<2>::cell_iterator descendant = cell;
    while (descendant->has_children())
      descendant = descendant->child(v);
    drawn.points.push_back(
      sampler.at(descendant, v, Quadrature<2>(GeometryInfo<2>::unit_cell_vertex(v))).front());
  }
  return drawn;
}

/** Returns the finest level of the mesh with few enough cells; the first one where no level has. */
unsigned int drawn_level(const Triangulation<2> &triangulation)
{
  unsigned int level = triangulation.n_levels() - 1;
  while (level > 0 && triangulation.n_cells(level) > max_cells)
    --level;
  return level;
}
} // namespace

std::vector<DrawnCell> collect_drawn_cells(const DisplacementSpace<2> &space,
                                           const Scene<2> &scene,
                                           const Displacement &U)
{
  const Triangulation<2> &triangulation = space.mesh().triangulation();
  FieldSampler sampler(space, scene, U);
  std::vector<DrawnCell> cells;
  const auto add = [&](DrawnCell drawn, const auto &cell) {
    for (const unsigned int f : GeometryInfo<2>::face_indices())
      drawn.at_boundary[f] = cell->face(f)->at_boundary();
    cells.push_back(std::move(drawn));
  };
  const bool is_uniform =
    triangulation.n_active_cells() == triangulation.n_cells(triangulation.n_levels() - 1);
  if (is_uniform && triangulation.n_active_cells() > max_cells)
    for (const auto &cell : triangulation.cell_iterators_on_level(drawn_level(triangulation)))
      add(coarse_cell(cell, sampler), cell);
  else
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      DrawnCell drawn;
      drawn.n = n_parts(space, cell);
      drawn.points = sampler.at(cell, drawn.n, lattice(drawn.n));
      add(std::move(drawn), cell);
    }
  return cells;
}
} // namespace Signorini
