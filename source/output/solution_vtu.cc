// SPDX-License-Identifier: LGPL-2.1-or-later
// The body for ParaView: displacement, its recovery, stresses.

#include <signorini/base/agreement.h>
#include <signorini/base/exceptions.h>
#include <signorini/output/files.h>
#include <signorini/output/solution_vtu.h>
#include <signorini/postprocess/error_estimate.h>
#include <signorini/postprocess/mean_dilatation.h>
#include <signorini/postprocess/patch_interpolation.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace Signorini
{
namespace
{
/** sigma = E : eps(u) and the von Mises stress at the output points. */
template <int dim>
class StressPostprocessor : public dealii::DataPostprocessor<dim>
{
public:
  /** @param dilatation instead of tr eps(u), by active cell index; empty: tr eps(u) itself. */
  StressPostprocessor(const Material<dim> &material, std::vector<double> dilatation)
    : material_(material)
    , dilatation_(std::move(dilatation))
  {
  }

  std::vector<std::string> get_names() const override
  {
    std::vector<std::string> names(dim * dim, "stress");
    names.emplace_back("von_mises_stress");
    return names;
  }

  std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>
  get_data_component_interpretation() const override
  {
    using namespace dealii::DataComponentInterpretation;
    std::vector<DataComponentInterpretation> interpretation(dim * dim, component_is_part_of_tensor);
    interpretation.push_back(component_is_scalar);
    return interpretation;
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
      const dealii::SymmetricTensor<2, dim> stress = material_.hooke(x) * strain;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          computed[dim * i + j] = stress[i][j];
      computed[dim * dim] = von_mises(stress, material_.out_of_plane_stress(x, strain));
    }
    catch (const InputError &)
    {
      // Mesh nodes may be the only points where the material's data has no value.
      computed = std::numeric_limits<double>::quiet_NaN();
    }
  }

  /** sqrt(3/2 s:s), s the deviator of the stress in space. */
  static double von_mises(const dealii::SymmetricTensor<2, dim> &stress, const double out_of_plane)
  {
    const double mean = (trace(stress) + (dim == 2 ? out_of_plane : 0.)) / 3.;
    double sum = dim == 2 ? (out_of_plane - mean) * (out_of_plane - mean) : 0.;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        sum += std::pow(stress[i][j] - (i == j ? mean : 0.), 2);
    return std::sqrt(1.5 * sum);
  }

  const Material<dim> &material_;
  std::vector<double> dilatation_;
};

/** The patch interpolation of u_h that comes closest to u, as a function of degree two on T^h, for
 * output only. Collective. */
template <int dim>
struct RecoveredField
{
  RecoveredField(const DisplacementSpace<dim> &space, const NodalVector &U)
    : element(dealii::FE_Q<dim>(2), dim)
    , dofs(space.mesh().triangulation())
  {
    dofs.distribute_dofs(element);
    values.reinit(dofs.n_dofs());
    const dealii::Quadrature<dim> nodes(element.base_element(0).get_unit_support_points());
    dealii::FEValues<dim> at_nodes(
      space.mesh().mapping(), space.element(), nodes, dealii::update_inverse_jacobians);
    PatchInterpolation<dim> interpolation(space, nodes, best_interpolation(space, U));
    dealii::Vector<double> cell_values(element.n_dofs_per_cell());
    auto cell = dofs.begin_active();
    for (const auto &q1_cell : space.dofs().active_cell_iterators())
    {
      at_nodes.reinit(q1_cell);
      const FieldValues<dim> &recovered = interpolation.evaluate(U, q1_cell, at_nodes);
      for (unsigned int i = 0; i < cell_values.size(); ++i)
      {
        const auto component_and_node = element.system_to_component_index(i);
        cell_values[i] = recovered.values[component_and_node.second][component_and_node.first];
      }
      cell->set_dof_values(cell_values, values);
      ++cell;
    }
  }

  dealii::FESystem<dim> element;
  dealii::DoFHandler<dim> dofs;
  NodalVector values;
};

/** A field of which every rank writes the piece on its own cells. */
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
    return stream.str();
  }
};

/** All ranks' texts on rank 0, in order; nothing on the others. A text has less than 2 GiB. */
std::vector<std::string> gather(std::string text, MPI_Comm communicator)
{
  const int rank = static_cast<int>(dealii::Utilities::MPI::this_mpi_process(communicator));
  const int n_ranks = static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(communicator));
  const auto sizes = dealii::Utilities::MPI::all_gather(communicator, text.size());
  if (*std::max_element(sizes.begin(), sizes.end()) > std::numeric_limits<int>::max())
    throw ComputationError("A rank's piece of the VTU file has more than 2 GiB; more ranks or "
                           "'VTU = none' avoid that.");
  const auto size = [&](const int r) { return static_cast<int>(sizes[static_cast<unsigned>(r)]); };
  if (rank != 0)
  {
    MPI_Send(text.data(), size(rank), MPI_CHAR, 0, 0, communicator);
    return {};
  }
  std::vector<std::string> texts = {std::move(text)};
  for (int r = 1; r < n_ranks; ++r)
  {
    texts.emplace_back(sizes[static_cast<unsigned>(r)], ' ');
    MPI_Recv(texts.back().data(), size(r), MPI_CHAR, r, 0, communicator, MPI_STATUS_IGNORE);
  }
  return texts;
}

/** Rank 0 writes the pieces of all: when the disk is full, all hear of it. */
void write_pieces(const std::filesystem::path &path,
                  std::string piece,
                  const dealii::DataOutBase::VtkFlags &flags,
                  MPI_Comm communicator)
{
  const std::vector<std::string> pieces = gather(std::move(piece), communicator);
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
                        const NodalVector &U)
{
  using namespace dealii::DataComponentInterpretation;
  const std::vector<DataComponentInterpretation> vector(dim, component_is_part_of_vector);
  const StressPostprocessor<dim> stress(*scene.material,
                                        space.strain_operator() == StrainOperator::mean_dilatation
                                          ? mean_dilatations(space, U)
                                          : std::vector<double>());
  const dealii::DataOutBase::VtkFlags flags(
    space.mesh().level(), space.mesh().level(), false, dealii::DataOutBase::VtkFlags::best_speed);
  FieldPieces<dim> data_out;
  data_out.add_data_vector(space.dofs(), U, std::vector<std::string>(dim, "displacement"), vector);
  std::optional<RecoveredField<dim>> recovered;
  if (space.mesh().has_parents())
  {
    recovered.emplace(space, U);
    data_out.add_data_vector(recovered->dofs,
                             recovered->values,
                             std::vector<std::string>(dim, "recovered_displacement"),
                             vector);
    data_out.add_data_vector(recovered->dofs, recovered->values, stress);
  }
  else
    data_out.add_data_vector(space.dofs(), U, stress);
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
                                 const NodalVector &);
} // namespace Signorini
