// SPDX-License-Identifier: LGPL-2.1-or-later
// 3-D bodies for ParaView, cell by cell: displacement and stress at the corners.

#include <signorini/base/errors.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/postprocessing/fields/stress.h>
#include <signorini/results/files/solution_vtu.h>

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <tuple>

namespace Signorini
{
namespace
{
/** The names of the fields; the first three are a vector. */
constexpr std::array<const char *, 13> field_names_3d = {"displacement",
                                                         "displacement",
                                                         "displacement",
                                                         "stress_xx",
                                                         "stress_yy",
                                                         "stress_zz",
                                                         "stress_xy",
                                                         "stress_xz",
                                                         "stress_yz",
                                                         "von_mises_stress",
                                                         "principal_stress_1",
                                                         "principal_stress_2",
                                                         "principal_stress_3"};
/** The row of the first stress. */
constexpr unsigned int first_stress = 3;

/** Returns the stresses in the order of the names; not a number where the material's data has no
 * value. */
std::array<double, field_names_3d.size() - first_stress>
stresses_at(const Material<3> &material, const Point<3> &x, const SymmetricTensor<2, 3> &strain)
{
  try
  {
    const Stress3D s = stress_in_3d(material, x, strain);
    const std::array<double, 3> principal = principal_stresses(s);
    return {{s[0][0],
             s[1][1],
             s[2][2],
             s[0][1],
             s[0][2],
             s[1][2],
             von_mises(s),
             principal[0],
             principal[1],
             principal[2]}};
  }
  catch (const InputError &)
  {
    std::array<double, field_names_3d.size() - first_stress> nothing = {};
    nothing.fill(std::numeric_limits<double>::quiet_NaN());
    return nothing;
  }
}

using Hexahedra = std::vector<DataOutBase::Patch<3, 3>>;

/** Returns the cells of this rank with their fields. */
Hexahedra fields_of_hexahedra(const DisplacementSpace<3> &space,
                              const Material<3> &material,
                              const Displacement &U)
{
  std::vector<Point<3>> corners;
  for (const unsigned int v : GeometryInfo<3>::vertex_indices())
    corners.push_back(GeometryInfo<3>::unit_cell_vertex(v));
  FEValues<3> values(space.mesh().mapping(),
                     space.element(),
                     Quadrature<3>(corners),
                     update_inverse_jacobians | update_quadrature_points);
  PatchInterpolation<3> field(space,
                              values.get_quadrature(),
                              space.max_element_degree() > 1 ? 0 : best_interpolation(space, U));
  Hexahedra cells;
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    values.reinit(cell);
    const FieldValues<3> &u = field.evaluate(U, cell, values);
    DataOutBase::Patch<3, 3> &patch = cells.emplace_back();
    patch.patch_index = cells.size() - 1;
    patch.reference_cell = ReferenceCells::get_hypercube<3>();
    patch.n_subdivisions = 1;
    patch.data.reinit(field_names_3d.size(), corners.size());
    for (unsigned int v = 0; v < corners.size(); ++v)
    {
      patch.vertices[v] = cell->vertex(v);
      for (unsigned int d = 0; d < 3; ++d)
        patch.data(d, v) = u.values[v][d];
      const auto stresses =
        stresses_at(material, values.quadrature_point(v), symmetrize(u.gradients[v]));
      for (unsigned int n = 0; n < stresses.size(); ++n)
        patch.data(first_stress + n, v) = stresses[n];
    }
  }
  return cells;
}

/** Returns the stress tensors point by point. */
std::vector<float> tensors_of(const Hexahedra &cells)
{
  constexpr std::array<unsigned int, 9> rows = {{3, 6, 7, 6, 4, 8, 7, 8, 5}};
  std::vector<float> tensors;
  for (const auto &cell : cells)
    for (unsigned int v = 0; v < cell.data.n_cols(); ++v)
      for (const unsigned int row : rows)
        tensors.push_back(cell.data(row, v));
  return tensors;
}
} // namespace

template <>
void write_solution_vtu(const std::filesystem::path &path,
                        const DisplacementSpace<3> &space,
                        const Scene<3> &scene,
                        const Displacement &U,
                        const BoundFields & /*there is no bound in space*/,
                        const unsigned int number)
{
  using Range = std::tuple<unsigned int,
                           unsigned int,
                           std::string,
                           dealii::DataComponentInterpretation::DataComponentInterpretation>;
  const std::vector<Range> vectors = {
    {0, 2, "displacement", dealii::DataComponentInterpretation::component_is_part_of_vector}};
  const DataOutBase::VtkFlags flags(number, number, false, DataOutBase::VtkFlags::best_speed);
  const Hexahedra cells = fields_of_hexahedra(space, *scene.material, U);
  std::ostringstream stream;
  DataOutBase::write_vtu_main(
    cells, {field_names_3d.begin(), field_names_3d.end()}, vectors, flags, stream);
  std::string piece = stream.str();
  // A rank may have no cells, and then has no point data.
  if (!cells.empty())
    add_to_point_data(piece, vtu_array("stress", 9, tensors_of(cells)));
  write_vtu_pieces(path, std::move(piece), flags, space.mesh().communicator());
}
} // namespace Signorini
