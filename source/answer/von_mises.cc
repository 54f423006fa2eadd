// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest von Mises stress of the recovered displacement.

#include <signorini/answer/von_mises.h>
#include <signorini/base/exceptions.h>
#include <signorini/elasticity/cell_chunks.h>
#include <signorini/postprocess/mean_dilatation.h>
#include <signorini/postprocess/patch_interpolation.h>
#include <signorini/postprocess/stress.h>

#include <cmath>
#include <map>
#include <memory>

namespace Signorini
{
namespace
{
/** The corners of the reference cell and its middle. */
dealii::Quadrature<2> corners_and_middle()
{
  std::vector<dealii::Point<2>> points = {dealii::Point<2>(0.5, 0.5)};
  for (const unsigned int v : dealii::GeometryInfo<2>::vertex_indices())
    points.push_back(dealii::GeometryInfo<2>::unit_cell_vertex(v));
  return dealii::Quadrature<2>(points);
}

/** Takes the larger one; of equals (a symmetric body has some) the one further left or down, so
 * that neither ranks nor rounding choose. */
void take_larger(const VonMises &candidate, VonMises &largest)
{
  constexpr double rounding = 1e-9;
  const double excess = candidate.value - largest.value;
  const bool equal = std::abs(excess) <= rounding * largest.value;
  const dealii::Tensor<1, 2> step = candidate.point - largest.point;
  const bool comes_first = step[0] < 0. || (step[0] == 0. && step[1] < 0.);
  if (equal ? comes_first : excess > 0.)
    largest = candidate;
}

/** The stress at a point; nothing where the material's data has no value. */
void compare(const Material<2> &material,
             const dealii::Point<2> &x,
             const dealii::SymmetricTensor<2, 2> &strain,
             VonMises &largest)
{
  try
  {
    take_larger({von_mises(stress_in_space(material, x, strain)), x}, largest);
  }
  catch (const InputError &)
  {
  }
}

/** The largest of a chunk of cells of several degrees, at the nodes of each. */
VonMises largest_at_nodes(const Cells<2> &cells,
                          const DisplacementSpace<2> &space,
                          const Material<2> &material,
                          const NodalVector &U)
{
  const dealii::FEValuesExtractors::Vector displacement(0);
  VonMises largest;
  std::map<unsigned int, std::unique_ptr<dealii::FEValues<2>>> values_by_degree;
  std::vector<dealii::SymmetricTensor<2, 2>> strains;
  for (const auto &cell : cells)
  {
    const dealii::FiniteElement<2> &element = cell->get_fe();
    std::unique_ptr<dealii::FEValues<2>> &values = values_by_degree[element.degree];
    if (values == nullptr)
      values = std::make_unique<dealii::FEValues<2>>(
        space.mesh().mapping(),
        element,
        dealii::Quadrature<2>(element.base_element(0).get_unit_support_points()),
        dealii::update_gradients | dealii::update_quadrature_points);
    values->reinit(cell);
    strains.resize(values->n_quadrature_points);
    (*values)[displacement].get_function_symmetric_gradients(U, strains);
    for (const unsigned int q : values->quadrature_point_indices())
      compare(material, values->quadrature_point(q), strains[q], largest);
  }
  return largest;
}

/** The largest of a chunk of cells. */
VonMises largest_of(const Cells<2> &cells,
                    const DisplacementSpace<2> &space,
                    const Material<2> &material,
                    const NodalVector &U,
                    const std::vector<double> &dilatation)
{
  if (space.has_several_elements())
    return largest_at_nodes(cells, space, material, U);
  dealii::FEValues<2> values(space.mesh().mapping(),
                             space.element(),
                             corners_and_middle(),
                             dealii::update_gradients | dealii::update_inverse_jacobians |
                               dealii::update_quadrature_points);
  PatchInterpolation<2> field(space, values.get_quadrature(), space.mesh().has_parents() ? 1 : 0);
  VonMises largest;
  for (const auto &cell : cells)
  {
    values.reinit(cell);
    const FieldValues<2> &u = field.evaluate(U, cell, values);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      dealii::SymmetricTensor<2, 2> strain = symmetrize(u.gradients[q]);
      if (!dilatation.empty())
        replace_trace(strain, dilatation[cell->active_cell_index()]);
      compare(material, values.quadrature_point(q), strain, largest);
    }
  }
  return largest;
}

/** The largest one of all ranks. */
VonMises largest_of_ranks(const VonMises &mine, MPI_Comm communicator)
{
  const std::array<double, 3> numbers = {{mine.value, mine.point[0], mine.point[1]}};
  VonMises largest;
  for (const auto &of_rank : dealii::Utilities::MPI::all_gather(communicator, numbers))
    take_larger({of_rank[0], {of_rank[1], of_rank[2]}}, largest);
  return largest;
}
} // namespace

VonMises largest_von_mises(const DisplacementSpace<2> &space,
                           const Scene<2> &scene,
                           const NodalVector &U)
{
  const std::vector<double> dilatation = space.strain_operator() == StrainOperator::mean_dilatation
                                           ? mean_dilatations(space, U)
                                           : std::vector<double>();
  VonMises largest;
  integrate_by_chunks<VonMises, 2>(
    space,
    [&](const Cells<2> &cells) { return largest_of(cells, space, *scene.material, U, dilatation); },
    [&largest](const VonMises &of_chunk) { take_larger(of_chunk, largest); });
  return largest_of_ranks(largest, space.mesh().communicator());
}
} // namespace Signorini
