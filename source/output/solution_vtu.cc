// SPDX-License-Identifier: LGPL-2.1-or-later
// The body for ParaView: displacement, its recovery, stresses, bound.

#include <signorini/base/agreement.h>
#include <signorini/base/exceptions.h>
#include <signorini/base/gather.h>
#include <signorini/output/files.h>
#include <signorini/output/solution_vtu.h>
#include <signorini/output/vtu_text.h>
#include <signorini/postprocess/mean_dilatation.h>
#include <signorini/postprocess/recovered_displacement.h>
#include <signorini/postprocess/stress.h>

#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <sstream>

namespace Signorini
{
namespace
{
constexpr std::array<const char *, 8> stress_names = {"stress_xx",
                                                      "stress_yy",
                                                      "stress_zz",
                                                      "stress_xy",
                                                      "von_mises_stress",
                                                      "principal_stress_1",
                                                      "principal_stress_2",
                                                      "principal_stress_3"};

/** sigma = E : eps(u) and what is read off it, at the output points. */
template <int dim>
class StressPostprocessor : public dealii::DataPostprocessor<dim>
{
  static_assert(dim == 2, "The components are those of a plane body.");

public:
  /** @param dilatation instead of tr eps(u), by active cell index; empty: tr eps(u) itself. */
  StressPostprocessor(const Material<dim> &material, std::vector<double> dilatation)
    : material_(material)
    , dilatation_(std::move(dilatation))
  {
  }

  std::vector<std::string> get_names() const override
  {
    return {stress_names.begin(), stress_names.end()};
  }

  std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>
  get_data_component_interpretation() const override
  {
    return std::vector(stress_names.size(),
                       dealii::DataComponentInterpretation::component_is_scalar);
  }

  dealii::UpdateFlags get_needed_update_flags() const override
  {
    return dealii::update_gradients | dealii::update_quadrature_points;
  }

  void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<dim> &inputs,
                             std::vector<dealii::Vector<double>> &computed) const override
  {
    for (unsigned int q = 0; q < computed.size(); ++q)
    {
      dealii::Tensor<2, dim> gradient;
      for (unsigned int i = 0; i < dim; ++i)
        gradient[i] = inputs.solution_gradients[q][i];
      dealii::SymmetricTensor<2, dim> strain = symmetrize(gradient);
      if (!dilatation_.empty())
        replace_trace(strain, dilatation_[inputs.template get_cell<dim>()->active_cell_index()]);
      evaluate(inputs.evaluation_points[q], strain, computed[q]);
    }
  }

private:
  void evaluate(const dealii::Point<dim> &x,
                const dealii::SymmetricTensor<2, dim> &strain,
                dealii::Vector<double> &computed) const
  {
    try
    {
      const SpatialStress stress = stress_in_space(material_, x, strain);
      const std::array<double, 3> principal = principal_stresses(stress);
      const double values[stress_names.size()] = {stress[0][0],
                                                  stress[1][1],
                                                  stress[2][2],
                                                  stress[0][1],
                                                  von_mises(stress),
                                                  principal[0],
                                                  principal[1],
                                                  principal[2]};
      std::copy(std::begin(values), std::end(values), computed.begin());
    }
    catch (const InputError &)
    {
      // Mesh nodes may be the only points where the material's data has no value.
      computed = std::numeric_limits<double>::quiet_NaN();
    }
  }

  const Material<dim> &material_;
  std::vector<double> dilatation_;
};

/** Fields of which every rank writes the piece on its own cells. */
template <int dim>
class FieldPieces : public dealii::DataOut<dim>
{
public:
  std::string piece(const dealii::DataOutBase::VtkFlags &flags) const
  {
    std::ostringstream stream;
    dealii::DataOutBase::write_vtu_main(this->get_patches(),
                                        this->get_dataset_names(),
                                        this->get_nonscalar_data_ranges(),
                                        flags,
                                        stream);
    std::string text = stream.str();
    // A rank may have no cells, and then has no point data.
    if (!this->get_patches().empty())
      add_to_point_data(text, vtu_array("stress", 9, stress_tensors()));
    return text;
  }

private:
  /** The tensor in space, point by point: deal.II's tensors of plane bodies have sigma_zz = 0. */
  std::vector<float> stress_tensors() const
  {
    const std::vector<std::string> names = this->get_dataset_names();
    const auto row = [&](const char *name) {
      return static_cast<unsigned int>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const unsigned int xx = row("stress_xx"), yy = row("stress_yy"), zz = row("stress_zz"),
                       xy = row("stress_xy");
    std::vector<float> tensors;
    for (const auto &patch : this->get_patches())
      for (unsigned int v = 0; v < patch.data.n_cols(); ++v)
      {
        const auto value = [&](const unsigned int n) { return patch.data(n, v); };
        tensors.insert(tensors.end(),
                       {value(xx), value(xy), 0.F, value(xy), value(yy), 0.F, 0.F, 0.F, value(zz)});
      }
    return tensors;
  }
};

dealii::Vector<double> to_vector(const std::vector<double> &values)
{
  return {values.begin(), values.end()};
}

/** Rank 0 writes the pieces of all: when the disk is full, all hear of it. */
void write_pieces(const std::filesystem::path &path,
                  std::string piece,
                  const dealii::DataOutBase::VtkFlags &flags,
                  MPI_Comm communicator)
{
  const std::vector<std::string> pieces = gather_texts(std::move(piece), communicator);
  agree(communicator, [&]() {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    write_file(path, [&](std::ostream &stream) {
      dealii::DataOutBase::write_vtu_header(stream, flags);
      for (const std::string &text : pieces)
        stream << text;
      dealii::DataOutBase::write_vtu_footer(stream);
    });
  });
}
} // namespace

template <int dim>
void write_solution_vtu(const std::filesystem::path &path,
                        const DisplacementSpace<dim> &space,
                        const Scene<dim> &scene,
                        const NodalVector &U,
                        const BoundFields &bound)
{
  using namespace dealii::DataComponentInterpretation;
  const std::vector<DataComponentInterpretation> vector(dim, component_is_part_of_vector);
  const StressPostprocessor<dim> stress(*scene.material,
                                        space.strain_operator() == StrainOperator::mean_dilatation
                                          ? mean_dilatations(space, U)
                                          : std::vector<double>());
  const dealii::DataOutBase::VtkFlags flags(
    space.mesh().level(), space.mesh().level(), false, dealii::DataOutBase::VtkFlags::best_speed);
  const std::array<std::pair<const char *, dealii::Vector<double>>, 3> cell_fields = {
    {{"bound_mesh", to_vector(bound.mesh)},
     {"bound_oscillation", to_vector(bound.oscillation)},
     {"bound_lift", to_vector(bound.lift)}}};
  FieldPieces<dim> data_out;
  data_out.add_data_vector(space.dofs(), U, std::vector<std::string>(dim, "displacement"), vector);
  std::optional<RecoveredDisplacement<dim>> recovered;
  if (space.mesh().has_parents())
  {
    recovered.emplace(space, U);
    data_out.add_data_vector(recovered->dofs(),
                             recovered->values(),
                             std::vector<std::string>(dim, "recovered_displacement"),
                             vector);
    data_out.add_data_vector(recovered->dofs(), recovered->values(), stress);
  }
  else
    data_out.add_data_vector(space.dofs(), U, stress);
  for (const auto &[name, values] : cell_fields)
    if (values.size() > 0)
      data_out.add_data_vector(values, name, dealii::DataOut<dim>::type_cell_data);
  data_out.build_patches(space.mesh().mapping(),
                         space.mesh().has_parents() ? 2 : 1,
                         space.mesh().is_curved() ? dealii::DataOut<dim>::curved_inner_cells
                                                  : dealii::DataOut<dim>::no_curved_cells);
  write_pieces(path, data_out.piece(flags), flags, space.mesh().communicator());
}

void write_pvd(const std::filesystem::path &path,
               const std::vector<std::pair<double, std::string>> &files)
{
  std::ostringstream record;
  dealii::DataOutBase::write_pvd_record(record, files);
  // Without the comment, which holds the time: the same run gives the same file.
  std::string text = record.str();
  const std::size_t start = text.find("<!--"), end = text.find("-->");
  if (start != std::string::npos && end != std::string::npos)
    text.erase(start, text.find_first_not_of("->\n", end) - start);
  write_file(path, [&](std::ostream &stream) { stream << text; });
}

template void write_solution_vtu(const std::filesystem::path &,
                                 const DisplacementSpace<2> &,
                                 const Scene<2> &,
                                 const NodalVector &,
                                 const BoundFields &);
} // namespace Signorini
