// SPDX-License-Identifier: LGPL-2.1-or-later
// Pressure, gap and opening along the contact boundary.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/results/files/contact_files.h>

#include <deal.II/base/data_out_base.h>

#include <cmath>
#include <iomanip>
#include <iterator>
#include <tuple>

namespace Signorini
{
namespace
{
/** Returns -p, where zero has no sign. */
double positive_in_compression(const double p)
{
  return p == 0. ? 0. : -p;
}

/** Returns the values of curves at a point, in the order of the names in write_contact_vtu(). */
std::vector<float> curve_values(const ContactSegment &segment,
                                const ContactPoint &point,
                                const double bound)
{
  const double values[] = {point.u[0],
                           point.u[1],
                           positive_in_compression(point.p_H),
                           positive_in_compression(point.p_recovered),
                           point.u_n,
                           point.g,
                           point.g - point.u_n,
                           static_cast<double>(segment.patch),
                           static_cast<double>(segment.side_number),
                           bound};
  return {std::begin(values), std::end(values)};
}

using Positions = std::vector<Point<1>>;

/** Returns positions between 0 and 1 on a piece: its ends, the nodes of its multipliers, and the
 * middles between all of these. */
Positions positions_of_polynomial(const Piece<2> &piece, const MultiplierSpace<2> &multipliers)
{
  std::vector<double> corners = {0.};
  for (unsigned int k = multipliers.first_of(piece.patch);
       k < multipliers.first_of(piece.patch + 1);
       ++k)
  {
    const double t = (multipliers.node(k)[0] - piece.lower[0]) / (piece.upper[0] - piece.lower[0]);
    if (t > 0. && t < 1.)
      corners.push_back(t);
  }
  corners.push_back(1.);
  Positions positions;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
  {
    positions.emplace_back(corners[i]);
    positions.emplace_back(0.5 * (corners[i] + corners[i + 1]));
  }
  positions.emplace_back(1.);
  return positions;
}

/** Computes the fields at points of the contact boundary. */
class ContactTracer
{
public:
  ContactTracer(const DisplacementSpace<2> &space,
                const MultiplierSpace<2> &multipliers,
                const std::vector<BoundaryCondition<2>> &boundary,
                const Displacement &U,
                const Pressure &P)
    : multipliers_(multipliers)
    , surface_(multipliers.surface())
    , boundary_(boundary)
    , U_(U)
    , P_(P)
    , recovered_(multipliers, P)
    , traces_(space)
  {
  }

  std::vector<ContactPoint> trace(const Piece<2> &piece, const Positions &positions)
  {
    const BoundaryCondition<2> &condition = boundary_[surface_.patches()[piece.patch].side];
    const SurfaceRule<2> rule = surface_.at(piece, positions);
    const std::vector<Tensor<1, 2>> u =
      traces_.displacement(surface_.faces()[piece.face], rule, U_);
    std::vector<ContactPoint> points(rule.size());
    for (std::size_t q = 0; q < rule.size(); ++q)
    {
      ContactPoint &point = points[q];
      const Point<1> &s = rule.on_side[q];
      point.s = s[0];
      point.x = rule.points[q];
      point.n = rule.normals[q];
      point.p_H = multipliers_.value(P_, piece.patch, s);
      point.p_recovered = recovered_(piece.patch, s);
      point.u = u[q];
      point.u_n = u[q] * rule.normals[q];
      point.g = condition.data->value(point.x);
      if (condition.exact_pressure != nullptr)
        point.p_exact = condition.exact_pressure->value(point.x);
    }
    return points;
  }

private:
  const MultiplierSpace<2> &multipliers_;
  const ContactSurface<2> &surface_;
  const std::vector<BoundaryCondition<2>> &boundary_;
  const Displacement &U_;
  const Pressure &P_;
  const RecoveredPressure<2> recovered_;
  TraceValues<2> traces_;
};
} // namespace

std::vector<ContactSegment> trace_contact_line(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const Displacement &U,
                                               const Pressure &P,
                                               const unsigned int n_parts)
{
  return trace_contact_line(
    space, multipliers, multipliers.surface().scene().boundary, U, P, n_parts);
}

std::vector<ContactSegment> trace_contact_line(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const std::vector<BoundaryCondition<2>> &boundary,
                                               const Displacement &U,
                                               const Pressure &P,
                                               const unsigned int n_parts)
{
  const ContactSurface<2> &surface = multipliers.surface();
  Positions along_piece;
  for (unsigned int i = 0; i <= n_parts; ++i)
    along_piece.emplace_back(static_cast<double>(i) / n_parts);
  ContactTracer tracer(space, multipliers, boundary, U, P);
  std::vector<ContactSegment> line;
  for (const Piece<2> &piece : surface.pieces())
  {
    const Patch<2> &patch = surface.patches()[piece.patch];
    ContactSegment segment = {
      surface.side(patch).name(), patch.side, piece.face, piece.patch, patch.measure, {}, {}};
    if (multipliers.is_piecewise_constant())
    {
      segment.rows = tracer.trace(piece, {Point<1>(0.5)});
      segment.curve = tracer.trace(piece, along_piece);
    }
    else
      segment.rows = segment.curve =
        tracer.trace(piece, positions_of_polynomial(piece, multipliers));
    line.push_back(segment);
  }
  return line;
}

void write_contact_csv(std::ostream &stream, const std::vector<ContactSegment> &line)
{
  stream << "side,s,x,y,p_H,p_recovered,u_n,g,p_exact,patch,patch_length\n"
         << std::setprecision(16);
  for (const ContactSegment &segment : line)
    for (const ContactPoint &point : segment.rows)
    {
      stream << segment.side << "," << point.s;
      for (unsigned int d = 0; d < 2; ++d)
        stream << "," << point.x[d];
      stream << "," << point.p_H << "," << point.p_recovered << "," << point.u_n << "," << point.g
             << ",";
      // The pressure is infinite at an edge of a punch.
      if (point.p_exact && std::isfinite(*point.p_exact))
        stream << *point.p_exact;
      stream << "," << segment.patch << "," << segment.patch_length << "\n";
    }
}

void write_contact_vtu(std::ostream &stream,
                       const std::vector<ContactSegment> &line,
                       const std::vector<double> &bound)
{
  std::vector<std::string> names = {"displacement",
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
  std::vector<DataOutBase::Patch<1, 2>> intervals;
  for (const ContactSegment &segment : line)
    for (std::size_t i = 0; i + 1 < segment.curve.size(); ++i)
    {
      DataOutBase::Patch<1, 2> interval;
      interval.patch_index = intervals.size();
      interval.reference_cell = ReferenceCells::get_hypercube<1>();
      interval.n_subdivisions = 1;
      interval.data.reinit(names.size(), 2);
      for (unsigned int v = 0; v < 2; ++v)
      {
        const ContactPoint &point = segment.curve[i + v];
        interval.vertices[v] = point.x;
        const std::vector<float> values =
          curve_values(segment, point, bound.empty() ? 0. : bound[segment.face]);
        for (unsigned int n = 0; n < names.size(); ++n)
          interval.data(n, v) = values[n];
      }
      intervals.push_back(interval);
    }
  using Range = std::tuple<unsigned int,
                           unsigned int,
                           std::string,
                           DataComponentInterpretation::DataComponentInterpretation>;
  const std::vector<Range> vectors = {
    {0, 1, "displacement", DataComponentInterpretation::component_is_part_of_vector}};
  DataOutBase::VtkFlags flags;
  // The same run gives the same file.
  flags.print_date_and_time = false;
  DataOutBase::write_vtu(intervals, names, vectors, flags, stream);
}

// Pressure, gap and opening on the contact boundary in 3-D.

namespace
{
/** Returns the corners of a face and its middle. */
std::vector<Point<2>> corners_and_middle_of_face()
{
  std::vector<Point<2>> positions;
  for (const unsigned int v : GeometryInfo<2>::vertex_indices())
    positions.push_back(GeometryInfo<2>::unit_cell_vertex(v));
  positions.emplace_back(0.5, 0.5);
  return positions;
}

/** Returns -p, where zero has no sign. */
double compression(const double p)
{
  return p == 0. ? 0. : -p;
}

/** Returns the values in the order of the names in write_contact_vtu(). */
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
                   const Displacement &U,
                   const Pressure &P)
{
  const ContactSurface<3> &surface = multipliers.surface();
  const std::vector<Point<2>> positions = corners_and_middle_of_face();
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
  std::vector<DataOutBase::Patch<2, 3>> cells;
  for (const ContactQuadrilateral &face : area)
  {
    DataOutBase::Patch<2, 3> cell;
    cell.patch_index = cells.size();
    cell.reference_cell = ReferenceCells::get_hypercube<2>();
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
                           DataComponentInterpretation::DataComponentInterpretation>;
  const std::vector<Range> vectors = {
    {0, 2, "displacement", DataComponentInterpretation::component_is_part_of_vector}};
  DataOutBase::VtkFlags flags;
  // The same run gives the same file.
  flags.print_date_and_time = false;
  DataOutBase::write_vtu(cells, names, vectors, flags, stream);
}
} // namespace Signorini
