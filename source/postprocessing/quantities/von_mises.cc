// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest von Mises stress of the recovered displacement.

#include <signorini/base/errors.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/postprocessing/fields/stress.h>
#include <signorini/postprocessing/quantities/von_mises.h>

#include <cmath>
#include <map>
#include <memory>

namespace Signorini
{
namespace
{
/** The value and the position of the largest stress, zero at the origin if there is none. */
template <int dim>
struct StressAt
{
  double value = 0.;
  dealii::Point<dim> point;
  MeshAt mesh;
};

/** The results of a set of cells. */
template <int dim>
struct CellResults
{
  /** The largest stress of all points, and of those away from singular places. */
  StressAt<dim> all, away;
  /** The measure of the cells, and that of those with large strains. */
  double measure = 0., strained = 0.;

  /**
   * Adds the measure of a cell.
   * @param strain in the middle of the cell.
   */
  void add_cell(const double of_cell, const dealii::SymmetricTensor<2, dim> &strain)
  {
    const auto principal = dealii::eigenvalues(strain);
    measure += of_cell;
    if (std::max(principal[0], -principal[dim - 1]) > large_strain)
      strained += of_cell;
  }
};

/** The data of the stress field. */
template <int dim>
struct StressField
{
  const DisplacementSpace<dim> &space;
  const Material<dim> &material;
  const Displacement &U;
  /** The mean dilatations by cell; empty where the strain is that of u_h. */
  const std::vector<double> dilatation;
  const std::vector<SingularPlace<dim>> &places;
};

/** Returns the middle of the reference cell and its corners. */
template <int dim>
dealii::Quadrature<dim> middle_and_corners()
{
  std::vector<dealii::Point<dim>> points(1);
  for (unsigned int d = 0; d < dim; ++d)
    points[0][d] = 0.5;
  for (const unsigned int v : dealii::GeometryInfo<dim>::vertex_indices())
    points.push_back(dealii::GeometryInfo<dim>::unit_cell_vertex(v));
  return dealii::Quadrature<dim>(points);
}

/** Takes the larger one; of equals (a symmetric body has some) the one further left, then further
 * down, so that neither ranks nor rounding choose. */
template <int dim>
void take_larger(const StressAt<dim> &candidate, StressAt<dim> &largest)
{
  constexpr double rounding = 1e-9;
  const double excess = candidate.value - largest.value;
  const bool equal = std::abs(excess) <= rounding * largest.value;
  const dealii::Tensor<1, dim> step = candidate.point - largest.point;
  bool comes_first = false;
  for (unsigned int d = dim; d-- > 0;)
    comes_first = step[d] < 0. || (step[d] == 0. && comes_first);
  if (equal ? comes_first : excess > 0.)
    largest = candidate;
}

/** Adds the results of another part of the body. */
template <int dim>
void add(const CellResults<dim> &part, CellResults<dim> &results)
{
  take_larger(part.all, results.all);
  take_larger(part.away, results.away);
  results.measure += part.measure;
  results.strained += part.strained;
}

/** Compares the stress at a point with the largest one; skips points where the material's data has
 * no value. */
template <int dim>
void compare(const StressField<dim> &field,
             const dealii::Point<dim> &x,
             const dealii::SymmetricTensor<2, dim> &strain,
             const MeshAt &mesh,
             CellResults<dim> &results)
{
  try
  {
    const StressAt<dim> here = {von_mises(stress_in_space(field.material, x, strain)), x, mesh};
    take_larger(here, results.all);
    if (!any_contains(field.places, x))
      take_larger(here, results.away);
  }
  catch (const InputError &)
  {
  }
}

/** Returns the middle of the reference cell and the nodes of an element. */
template <int dim>
dealii::Quadrature<dim> middle_and_nodes(const dealii::FiniteElement<dim> &element)
{
  std::vector<dealii::Point<dim>> points = element.base_element(0).get_unit_support_points();
  points.insert(points.begin(), middle_and_corners<dim>().point(0));
  return dealii::Quadrature<dim>(points);
}

/** Returns the results of a chunk of cells of several degrees, with the largest stress at the nodes
 * of each. */
template <int dim>
CellResults<dim> results_at_nodes(const Cells<dim> &cells, const StressField<dim> &field)
{
  const dealii::FEValuesExtractors::Vector displacement(0);
  CellResults<dim> results;
  std::map<unsigned int, std::unique_ptr<dealii::FEValues<dim>>> values_by_degree;
  std::vector<dealii::SymmetricTensor<2, dim>> strains;
  for (const auto &cell : cells)
  {
    const dealii::FiniteElement<dim> &element = cell->get_fe();
    std::unique_ptr<dealii::FEValues<dim>> &values = values_by_degree[element.degree];
    if (values == nullptr)
      values = std::make_unique<dealii::FEValues<dim>>(field.space.mesh().mapping(),
                                                       element,
                                                       middle_and_nodes(element),
                                                       dealii::update_gradients |
                                                         dealii::update_quadrature_points);
    values->reinit(cell);
    strains.resize(values->n_quadrature_points);
    (*values)[displacement].get_function_symmetric_gradients(field.U.entries(), strains);
    const MeshAt mesh = {cell->diameter(), element.degree};
    results.add_cell(cell->measure(), strains[0]);
    for (unsigned int q = 1; q < strains.size(); ++q)
      compare(field, values->quadrature_point(q), strains[q], mesh, results);
  }
  return results;
}

/** Returns the results of a chunk of cells. */
template <int dim>
CellResults<dim> results_of(const Cells<dim> &cells, const StressField<dim> &field)
{
  const DisplacementSpace<dim> &space = field.space;
  if (space.has_several_elements())
    return results_at_nodes(cells, field);
  dealii::FEValues<dim> values(space.mesh().mapping(),
                               space.element(),
                               middle_and_corners<dim>(),
                               dealii::update_gradients | dealii::update_inverse_jacobians |
                                 dealii::update_quadrature_points);
  PatchInterpolation<dim> interpolation(
    space, values.get_quadrature(), space.mesh().has_parents() ? 1 : 0);
  CellResults<dim> results;
  for (const auto &cell : cells)
  {
    values.reinit(cell);
    const FieldValues<dim> &u = interpolation.evaluate(field.U, cell, values);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      dealii::SymmetricTensor<2, dim> strain = symmetrize(u.gradients[q]);
      if (!field.dilatation.empty())
        replace_trace(strain, field.dilatation[cell->active_cell_index()]);
      compare(field, values.quadrature_point(q), strain, {}, results);
      if (q == 0)
        results.add_cell(cell->measure(), strain);
    }
  }
  return results;
}

/** Returns the results of all cells of this rank. */
template <int dim>
CellResults<dim> results_of_cells(const StressField<dim> &field)
{
  CellResults<dim> results;
  integrate_by_chunks<CellResults<dim>, dim>(
    field.space,
    [&](const Cells<dim> &cells) { return results_of(cells, field); },
    [&results](const CellResults<dim> &of_chunk) { add(of_chunk, results); });
  return results;
}

/** Returns the largest stress of all ranks. */
template <int dim>
StressMaximum largest_of_ranks(const StressAt<dim> &mine, MPI_Comm communicator)
{
  std::array<double, 1 + dim> numbers = {{mine.value}};
  for (unsigned int d = 0; d < dim; ++d)
    numbers[1 + d] = mine.point[d];
  StressAt<dim> largest;
  for (const auto &of_rank : dealii::Utilities::MPI::all_gather(communicator, numbers))
  {
    StressAt<dim> other;
    other.value = of_rank[0];
    for (unsigned int d = 0; d < dim; ++d)
      other.point[d] = of_rank[1 + d];
    // Graded meshes are serial.
    other.mesh = mine.mesh;
    take_larger(other, largest);
  }
  return {largest.value, largest.point, largest.mesh};
}
} // namespace

template <int dim>
VonMises largest_von_mises(const DisplacementSpace<dim> &space,
                           const Scene<dim> &scene,
                           const Displacement &U,
                           const std::vector<SingularPlace<dim>> &places)
{
  const StressField<dim> field = {space,
                                  *scene.material,
                                  U,
                                  space.strain_operator() == StrainOperator::mean_dilatation
                                    ? mean_dilatations(space, U)
                                    : std::vector<double>(),
                                  places};
  const CellResults<dim> mine = results_of_cells(field);
  MPI_Comm communicator = space.mesh().communicator();
  VonMises stress = {largest_of_ranks(mine.all, communicator), {}, {}};
  if (!places.empty())
    stress.away = largest_of_ranks(mine.away, communicator);
  stress.strained_share = dealii::Utilities::MPI::sum(mine.strained, communicator) /
                          dealii::Utilities::MPI::sum(mine.measure, communicator);
  return stress;
}

template VonMises largest_von_mises(const DisplacementSpace<2> &,
                                    const Scene<2> &,
                                    const Displacement &,
                                    const std::vector<SingularPlace<2>> &);
template VonMises largest_von_mises(const DisplacementSpace<3> &,
                                    const Scene<3> &,
                                    const Displacement &,
                                    const std::vector<SingularPlace<3>> &);
} // namespace Signorini
