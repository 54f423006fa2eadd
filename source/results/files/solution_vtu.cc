// SPDX-License-Identifier: LGPL-2.1-or-later
// The body for ParaView: displacement, its recovery, stresses, bound.

#include <signorini/base/errors.h>
#include <signorini/base/parallel.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/postprocessing/fields/stress.h>
#include <signorini/results/files/files.h>
#include <signorini/results/files/solution_vtu.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <regex>
#include <sstream>

namespace Signorini
{
std::vector<VtuRange> vtu_ranges(const std::vector<std::string> &names)
{
  using namespace DataComponentInterpretation;
  std::vector<VtuRange> ranges;
  for (unsigned int first = 0, end = 0; first < names.size(); first = end)
  {
    while (end < names.size() && names[end] == names[first])
      ++end;
    if (end - first > 1)
      ranges.emplace_back(first,
                          end - 1,
                          names[first],
                          end - first == 3 ? component_is_part_of_vector
                                           : component_is_part_of_tensor);
  }
  return ranges;
}

namespace
{
/** The cells of this rank with their fields. Cells may be divided in different ways. */
template <int dim>
class BodyFields
{
public:
  BodyFields(const DisplacementSpace<dim> &space,
             const Scene<dim> &scene,
             const Displacement &U,
             const BoundFields &bound)
    : space_(space)
    , material_(*scene.material)
    , U_(U)
    , bound_(bound)
    , is_recovered_(space.max_element_degree() == 1 && space.mesh().has_parents())
  {
    if (space.strain_operator() == StrainOperator::mean_dilatation)
      dilatations_ = mean_dilatations(space, U);
    std::vector<std::string> components = {"stress_xx", "stress_yy", "stress_zz", "stress_xy"};
    if (dim == 3)
      components.insert(components.end(), {"stress_xz", "stress_yz"});
    names_.assign(3, "displacement");
    if (dim == 2 && is_recovered_)
      names_.insert(names_.end(), 3, "recovered_displacement");
    names_.insert(names_.end(), 9, "stress");
    names_.insert(names_.end(), components.begin(), components.end());
    names_.insert(
      names_.end(),
      {"von_mises_stress", "principal_stress_1", "principal_stress_2", "principal_stress_3"});
    if (!bound.mesh.empty())
      names_.insert(names_.end(), {"bound_mesh", "bound_oscillation", "bound_lift"});
    if (space.max_element_degree() > 1)
      names_.emplace_back("degree");
    for (unsigned int number = 0; number < space.elements().size(); ++number)
      add_cells(number);
  }

  std::string text(const DataOutBase::VtkFlags &flags) const
  {
    std::ostringstream stream;
    DataOutBase::write_vtu_main(cells_, names_, vtu_ranges(names_), flags, stream);
    return stream.str();
  }

private:
  using Cell = typename DoFHandler<dim>::active_cell_iterator;

  /** Adds the cells of one of the elements. */
  void add_cells(const unsigned int number)
  {
    const FiniteElement<dim> &element = space_.elements()[number];
    const unsigned int n = dim == 3 ? 1 : is_recovered_ ? 2 : element.degree;
    const Quadrature<dim> points = QIterated<dim>(QTrapezoid<1>(), n);
    FEValues<dim> values(space_.mesh().mapping(),
                         element,
                         points,
                         update_values | update_gradients | update_inverse_jacobians |
                           update_quadrature_points);
    std::optional<PatchInterpolation<dim>> interpolation;
    if (is_recovered_)
      interpolation.emplace(space_, points, best_interpolation(space_, U_));
    const FEValuesExtractors::Vector vector(0);
    FieldValues<dim> u;
    u.values.resize(points.size());
    u.gradients.resize(points.size());
    for (const Cell &cell : space_.dofs().active_cell_iterators())
    {
      if (!cell->is_locally_owned() || cell->active_fe_index() != number)
        continue;
      values.reinit(cell);
      values[vector].get_function_values(U_.entries(), u.values);
      values[vector].get_function_gradients(U_.entries(), u.gradients);
      add_cell(cell, n, values, u, interpolation ? interpolation->evaluate(U_, cell, values) : u);
    }
  }

  /** Adds a cell with the fields u_h and @p recovered. */
  void add_cell(const Cell &cell,
                const unsigned int n,
                const FEValues<dim> &values,
                const FieldValues<dim> &u,
                const FieldValues<dim> &recovered)
  {
    const unsigned int index = cell->active_cell_index();
    cells_.push_back(make_vtu_cell<dim>(cells_.size(), n, names_.size()));
    for (unsigned int q = 0; q < u.values.size(); ++q)
    {
      std::vector<double> fields;
      add_vector(u.values[q], fields);
      if (dim == 2 && is_recovered_)
        add_vector(recovered.values[q], fields);
      SymmetricTensor<2, dim> strain = symmetrize(recovered.gradients[q]);
      if (!dilatations_.empty())
        replace_trace(strain, dilatations_[index]);
      add_stress(values.quadrature_point(q), strain, fields);
      if (!bound_.mesh.empty())
        fields.insert(fields.end(),
                      {bound_.mesh[index], bound_.oscillation[index], bound_.lift[index]});
      if (space_.max_element_degree() > 1)
        fields.push_back(cell->get_fe().degree);
      set_vtu_point(cells_.back(), q, values.quadrature_point(q), fields);
    }
  }

  static void add_vector(const Tensor<1, dim> &vector, std::vector<double> &fields)
  {
    for (unsigned int d = 0; d < 3; ++d)
      fields.push_back(d < dim ? vector[d] : 0.);
  }

  /** Adds the tensor, its components and its invariants. */
  void add_stress(const Point<dim> &x,
                  const SymmetricTensor<2, dim> &strain,
                  std::vector<double> &fields) const
  {
    Stress3D stress;
    try
    {
      stress = stress_in_3d(material_, x, strain);
    }
    catch (const InputError &)
    {
      // Mesh nodes may be the only points where the material's data has no value.
      constexpr unsigned int n_numbers = 9 + (dim == 2 ? 4 : 6) + 4;
      fields.insert(fields.end(), n_numbers, std::numeric_limits<double>::quiet_NaN());
      return;
    }
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        fields.push_back(stress[i][j]);
    fields.insert(fields.end(), {stress[0][0], stress[1][1], stress[2][2], stress[0][1]});
    if (dim == 3)
      fields.insert(fields.end(), {stress[0][2], stress[1][2]});
    fields.push_back(von_mises(stress));
    for (const double principal : principal_stresses(stress))
      fields.push_back(principal);
  }

  const DisplacementSpace<dim> &space_;
  const Material<dim> &material_;
  const Displacement &U_;
  const BoundFields &bound_;
  /** Whether stresses come from the patch interpolation. */
  bool is_recovered_;
  /** In place of tr eps(u), by active cell; empty: tr eps(u) itself. */
  std::vector<double> dilatations_;
  std::vector<std::string> names_;
  std::vector<VtuCell<dim>> cells_;
};
} // namespace

template <int dim>
void write_solution_vtu(const std::filesystem::path &path,
                        const DisplacementSpace<dim> &space,
                        const Scene<dim> &scene,
                        const Displacement &U,
                        const BoundFields &bound,
                        const unsigned int number)
{
  const DataOutBase::VtkFlags flags(number, number, false, DataOutBase::VtkFlags::best_speed);
  MPI_Comm communicator = space.mesh().communicator();
  const std::vector<std::string> pieces =
    gather_texts(BodyFields<dim>(space, scene, U, bound).text(flags), communicator);
  // An error, say a full disk, is thrown on all ranks.
  agree(communicator, [&]() {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      write_file(path, [&](std::ostream &stream) {
        DataOutBase::write_vtu_header(stream, flags);
        for (const std::string &piece : pieces)
          stream << piece;
        DataOutBase::write_vtu_footer(stream);
      });
  });
}

void write_pvd(std::ostream &stream, const std::vector<std::pair<double, std::string>> &files)
{
  std::ostringstream record;
  DataOutBase::write_pvd_record(record, files);
  // The comment, which contains the time, is left out: the same run gives the same file.
  static const std::regex comment("<!--[^>]*-->\\s*");
  stream << std::regex_replace(record.str(), comment, "");
}

#define INSTANTIATE(dim)                                                                           \
  template void write_solution_vtu(const std::filesystem::path &,                                  \
                                   const DisplacementSpace<dim> &,                                 \
                                   const Scene<dim> &,                                             \
                                   const Displacement &,                                           \
                                   const BoundFields &,                                            \
                                   unsigned int)
INSTANTIATE(2);
INSTANTIATE(3);
#undef INSTANTIATE
} // namespace Signorini
