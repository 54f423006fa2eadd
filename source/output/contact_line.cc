// SPDX-License-Identifier: LGPL-2.1-or-later
// Pressure, gap and opening along the contact boundary.

#include <signorini/multiplier/coupling.h>
#include <signorini/output/contact_line.h>
#include <signorini/postprocess/contact_pressure.h>

#include <deal.II/base/data_out_base.h>

#include <iomanip>
#include <tuple>

namespace Signorini
{
template <int dim>
std::vector<ContactSegment<dim>> trace_contact_line(const DisplacementSpace<dim> &space,
                                                    const MultiplierSpace<dim> &multipliers,
                                                    const NodalVector &U,
                                                    const dealii::Vector<double> &P)
{
  const RecoveredPressure<dim> recovered(multipliers, P);
  std::vector<ContactSegment<dim>> line;
  for (const Piece &piece : multipliers.partition().pieces)
  {
    const Patch &patch = multipliers.partition().patches[piece.patch];
    const Side<dim> &side = multipliers.side(patch);
    const BoundaryCondition<dim> &condition = multipliers.condition(patch);
    const ContactFace<dim> &face = multipliers.faces()[piece.face];
    const auto point = [&](const double s) {
      ContactPoint<dim> point;
      point.side = side.name();
      point.s = s;
      point.x = side.point(s);
      point.p_H = P[piece.patch];
      point.p_recovered = recovered(piece.patch, s);
      point.u_n = normal_displacement(space, face, side.normal(s), U, s);
      point.g = condition.data->value(point.x);
      if (condition.exact_pressure != nullptr)
        point.p_exact = condition.exact_pressure->value(point.x);
      return point;
    };
    line.push_back({point(piece.start), point(0.5 * (piece.start + piece.end)), point(piece.end)});
  }
  return line;
}

template <int dim>
void write_contact_csv(std::ostream &stream, const std::vector<ContactSegment<dim>> &line)
{
  stream << "side,s,x,y,p_H,p_recovered,u_n,g,p_exact\n" << std::setprecision(16);
  for (const ContactSegment<dim> &segment : line)
  {
    const ContactPoint<dim> &point = segment.middle;
    stream << point.side << "," << point.s;
    for (unsigned int d = 0; d < dim; ++d)
      stream << "," << point.x[d];
    stream << "," << point.p_H << "," << point.p_recovered << "," << point.u_n << "," << point.g
           << ",";
    if (point.p_exact)
      stream << *point.p_exact;
    stream << "\n";
  }
}

template <int dim>
void write_contact_vtu(std::ostream &stream, const std::vector<ContactSegment<dim>> &line)
{
  const std::vector<std::string> names = {
    "pressure", "recovered_pressure", "normal_displacement", "gap", "opening"};
  std::vector<dealii::DataOutBase::Patch<dim - 1, dim>> patches(line.size());
  for (std::size_t k = 0; k < line.size(); ++k)
  {
    patches[k].patch_index = k;
    patches[k].reference_cell = dealii::ReferenceCells::get_hypercube<dim - 1>();
    patches[k].n_subdivisions = 1;
    patches[k].data.reinit(names.size(), 2);
    for (unsigned int v = 0; v < 2; ++v)
    {
      const ContactPoint<dim> &point = v == 0 ? line[k].start : line[k].end;
      patches[k].vertices[v] = point.x;
      const double values[] = {
        point.p_H, point.p_recovered, point.u_n, point.g, point.g - point.u_n};
      for (unsigned int n = 0; n < names.size(); ++n)
        patches[k].data(n, v) = static_cast<float>(values[n]);
    }
  }
  using Range = std::tuple<unsigned int,
                           unsigned int,
                           std::string,
                           dealii::DataComponentInterpretation::DataComponentInterpretation>;
  dealii::DataOutBase::VtkFlags flags;
  // The same run gives the same file.
  flags.print_date_and_time = false;
  dealii::DataOutBase::write_vtu(patches, names, std::vector<Range>(), flags, stream);
}

template std::vector<ContactSegment<2>> trace_contact_line(const DisplacementSpace<2> &,
                                                           const MultiplierSpace<2> &,
                                                           const NodalVector &,
                                                           const dealii::Vector<double> &);
template void write_contact_csv(std::ostream &, const std::vector<ContactSegment<2>> &);
template void write_contact_vtu(std::ostream &, const std::vector<ContactSegment<2>> &);
} // namespace Signorini
