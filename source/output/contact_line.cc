// SPDX-License-Identifier: LGPL-2.1-or-later
// Pressure, gap and opening along the contact boundary.

#include <signorini/elasticity/trace_values.h>
#include <signorini/output/contact_line.h>
#include <signorini/postprocess/contact_pressure.h>

#include <deal.II/base/data_out_base.h>

#include <iomanip>
#include <tuple>

namespace Signorini
{
namespace
{
/** -p, where zero has no sign. */
double positive_in_compression(const double p)
{
  return p == 0. ? 0. : -p;
}
} // namespace

std::vector<ContactSegment> trace_contact_line(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const NodalVector &U,
                                               const dealii::Vector<double> &P)
{
  const ContactSurface<2> &surface = multipliers.surface();
  const RecoveredPressure recovered(multipliers, P);
  TraceValues<2> traces(space);
  std::vector<ContactSegment> line;
  for (const Piece<2> &piece : surface.pieces())
  {
    const BoundaryCondition<2> &condition = surface.condition(piece);
    const SurfaceRule<2> ends_and_middle =
      surface.at(piece, {dealii::Point<1>(0.), dealii::Point<1>(0.5), dealii::Point<1>(1.)});
    const std::vector<dealii::Tensor<1, 2>> u =
      traces.displacement(surface.faces()[piece.face], ends_and_middle, U);
    const Patch<2> &patch = surface.patches()[piece.patch];
    const auto point = [&](const std::size_t q) {
      const dealii::Point<1> &s = ends_and_middle.on_side[q];
      ContactPoint point;
      point.s = s[0];
      point.x = ends_and_middle.points[q];
      point.p_H = multipliers.value(P, piece.patch, s);
      point.p_recovered = recovered(piece.patch, s);
      point.u = u[q];
      point.u_n = u[q] * ends_and_middle.normals[q];
      point.g = condition.data->value(point.x);
      if (condition.exact_pressure != nullptr)
        point.p_exact = condition.exact_pressure->value(point.x);
      return point;
    };
    line.push_back({surface.side(patch).name(),
                    patch.side,
                    piece.face,
                    piece.patch,
                    patch.measure,
                    point(0),
                    point(1),
                    point(2)});
  }
  return line;
}

void write_contact_csv(std::ostream &stream, const std::vector<ContactSegment> &line)
{
  stream << "side,s,x,y,p_H,p_recovered,u_n,g,p_exact,patch,patch_length\n"
         << std::setprecision(16);
  for (const ContactSegment &segment : line)
  {
    const ContactPoint &point = segment.middle;
    stream << segment.side << "," << point.s;
    for (unsigned int d = 0; d < 2; ++d)
      stream << "," << point.x[d];
    stream << "," << point.p_H << "," << point.p_recovered << "," << point.u_n << "," << point.g
           << ",";
    if (point.p_exact)
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
  std::vector<dealii::DataOutBase::Patch<1, 2>> patches(line.size());
  for (std::size_t k = 0; k < line.size(); ++k)
  {
    patches[k].patch_index = k;
    patches[k].reference_cell = dealii::ReferenceCells::get_hypercube<1>();
    patches[k].n_subdivisions = 1;
    patches[k].data.reinit(names.size(), 2);
    for (unsigned int v = 0; v < 2; ++v)
    {
      const ContactPoint &point = v == 0 ? line[k].start : line[k].end;
      patches[k].vertices[v] = point.x;
      const double values[] = {point.u[0],
                               point.u[1],
                               positive_in_compression(point.p_H),
                               positive_in_compression(point.p_recovered),
                               point.u_n,
                               point.g,
                               point.g - point.u_n,
                               static_cast<double>(line[k].patch),
                               static_cast<double>(line[k].side_number),
                               bound.empty() ? 0. : bound[line[k].face]};
      for (unsigned int n = 0; n < names.size(); ++n)
        patches[k].data(n, v) = static_cast<float>(values[n]);
    }
  }
  using Range = std::tuple<unsigned int,
                           unsigned int,
                           std::string,
                           dealii::DataComponentInterpretation::DataComponentInterpretation>;
  const std::vector<Range> vectors = {
    {0, 1, "displacement", dealii::DataComponentInterpretation::component_is_part_of_vector}};
  dealii::DataOutBase::VtkFlags flags;
  // The same run gives the same file.
  flags.print_date_and_time = false;
  dealii::DataOutBase::write_vtu(patches, names, vectors, flags, stream);
}
} // namespace Signorini
