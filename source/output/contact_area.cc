// SPDX-License-Identifier: LGPL-2.1-or-later
// Pressure, gap and opening on the contact boundary in space.

#include <signorini/elasticity/trace_values.h>
#include <signorini/output/contact_area.h>
#include <signorini/postprocess/contact_pressure.h>

#include <deal.II/base/data_out_base.h>

#include <cmath>
#include <iomanip>
#include <tuple>

namespace Signorini
{
namespace
{
/** The corners of a face and its middle. */
std::vector<dealii::Point<2>> corners_and_middle_of_face()
{
  std::vector<dealii::Point<2>> positions;
  for (const unsigned int v : dealii::GeometryInfo<2>::vertex_indices())
    positions.push_back(dealii::GeometryInfo<2>::unit_cell_vertex(v));
  positions.emplace_back(0.5, 0.5);
  return positions;
}

/** -p, where zero has no sign. */
double compression(const double p)
{
  return p == 0. ? 0. : -p;
}

/** In the order of the names in write_contact_vtu(). */
std::array<double, 11> area_values(const ContactQuadrilateral &face,
                                   const ContactAreaPoint &point,
                                   const double bound)
{
  return {{point.u[0],
           point.u[1],
           point.u[2],
           compression(point.p_H),
           compression(point.p_recovered),
           point.u_n,
           point.g,
           point.g - point.u_n,
           static_cast<double>(face.patch),
           static_cast<double>(face.side_number),
           bound}};
}
} // namespace

std::vector<ContactQuadrilateral>
trace_contact_area(const DisplacementSpace<3> &space,
                   const MultiplierSpace<3> &multipliers,
                   const std::vector<BoundaryCondition<3>> &boundary,
                   const NodalVector &U,
                   const dealii::Vector<double> &P)
{
  const ContactSurface<3> &surface = multipliers.surface();
  const std::vector<dealii::Point<2>> positions = corners_and_middle_of_face();
  const RecoveredPressure<3> recovered(multipliers, P);
  TraceValues<3> traces(space);
  std::vector<ContactQuadrilateral> area;
  for (const Piece<3> &piece : surface.pieces())
  {
    const Patch<3> &patch = surface.patches()[piece.patch];
    const BoundaryCondition<3> &condition = boundary[patch.side];
    ContactQuadrilateral face = {
      surface.side(patch).name(), patch.side, piece.face, piece.patch, patch.measure, {}, {}};
    const SurfaceRule<3> rule = surface.at(piece, positions);
    const auto u = traces.displacement(surface.faces()[piece.face], rule, U);
    for (std::size_t q = 0; q < rule.size(); ++q)
    {
      ContactAreaPoint &point = q < face.corners.size() ? face.corners[q] : face.middle;
      point.x = rule.points[q];
      point.p_H = multipliers.value(P, piece.patch, rule.on_side[q]);
      point.p_recovered = recovered(piece.patch, rule.on_side[q]);
      point.u = u[q];
      point.u_n = u[q] * rule.normals[q];
      point.g = condition.data->value(point.x);
      if (condition.exact_pressure != nullptr)
        point.p_exact = condition.exact_pressure->value(point.x);
    }
    area.push_back(face);
  }
  return area;
}

void write_contact_csv(std::ostream &stream, const std::vector<ContactQuadrilateral> &area)
{
  stream << "side,x,y,z,p_H,p_recovered,u_n,g,p_exact,patch,patch_area\n" << std::setprecision(16);
  for (const ContactQuadrilateral &face : area)
  {
    const ContactAreaPoint &point = face.middle;
    stream << face.side;
    for (unsigned int d = 0; d < 3; ++d)
      stream << "," << point.x[d];
    stream << "," << point.p_H << "," << point.p_recovered << "," << point.u_n << "," << point.g
           << ",";
    if (point.p_exact && std::isfinite(*point.p_exact))
      stream << *point.p_exact;
    stream << "," << face.patch << "," << face.patch_area << "\n";
  }
}

void write_contact_vtu(std::ostream &stream,
                       const std::vector<ContactQuadrilateral> &area,
                       const std::vector<double> &bound)
{
  std::vector<std::string> names = {"displacement",
                                    "displacement",
                                    "displacement",
                                    "contact_pressure",
                                    "recovered_contact_pressure",
                                    "normal_displacement",
                                    "gap",
                                    "opening",
                                    "patch",
                                    "side"};
  if (!bound.empty())
    names.emplace_back("bound_contact");
  std::vector<dealii::DataOutBase::Patch<2, 3>> cells;
  for (const ContactQuadrilateral &face : area)
  {
    dealii::DataOutBase::Patch<2, 3> cell;
    cell.patch_index = cells.size();
    cell.reference_cell = dealii::ReferenceCells::get_hypercube<2>();
    cell.n_subdivisions = 1;
    cell.data.reinit(names.size(), face.corners.size());
    for (unsigned int v = 0; v < face.corners.size(); ++v)
    {
      cell.vertices[v] = face.corners[v].x;
      const auto values = area_values(face, face.corners[v], bound.empty() ? 0. : bound[face.face]);
      for (unsigned int n = 0; n < names.size(); ++n)
        cell.data(n, v) = values[n];
    }
    cells.push_back(cell);
  }
  using Range = std::tuple<unsigned int,
                           unsigned int,
                           std::string,
                           dealii::DataComponentInterpretation::DataComponentInterpretation>;
  const std::vector<Range> vectors = {
    {0, 2, "displacement", dealii::DataComponentInterpretation::component_is_part_of_vector}};
  dealii::DataOutBase::VtkFlags flags;
  // The same run gives the same file.
  flags.print_date_and_time = false;
  dealii::DataOutBase::write_vtu(cells, names, vectors, flags, stream);
}
} // namespace Signorini
