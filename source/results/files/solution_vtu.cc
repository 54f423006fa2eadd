// SPDX-License-Identifier: LGPL-2.1-or-later
// Arrays and files that deal.II does not write in the format VTU.

#include <signorini/base/errors.h>
#include <signorini/base/parallel.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/postprocessing/fields/stress.h>
#include <signorini/results/files/files.h>
#include <signorini/results/files/solution_vtu.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <tuple>
#include <zlib.h>

namespace Signorini
{
namespace
{
std::string base_64(const void *const data, const std::size_t size)
{
  const auto *const bytes = static_cast<const unsigned char *>(data);
  return Utilities::encode_base64(std::vector<unsigned char>(bytes, bytes + size));
}
} // namespace

std::string vtu_array(const std::string &name,
                      const unsigned int n_components,
                      const std::vector<float> &values)
{
  const uLong size = values.size() * sizeof(float);
  uLongf compressed_size = compressBound(size);
  std::vector<unsigned char> compressed(compressed_size);
  if (compress2(compressed.data(),
                &compressed_size,
                reinterpret_cast<const Bytef *>(values.data()),
                size,
                Z_BEST_SPEED) != Z_OK)
    throw ComputationError("The field '" + name + "' could not be compressed.");
  // The header has one block; its size, and that of the last block; its size when compressed.
  const std::uint32_t header[] = {1,
                                  static_cast<std::uint32_t>(size),
                                  static_cast<std::uint32_t>(size),
                                  static_cast<std::uint32_t>(compressed_size)};
  return "    <DataArray type=\"Float32\" Name=\"" + name + "\" NumberOfComponents=\"" +
         std::to_string(n_components) + "\" format=\"binary\">\n" +
         base_64(header, sizeof(header)) + base_64(compressed.data(), compressed_size) +
         "\n    </DataArray>\n";
}

void add_to_point_data(std::string &piece, const std::string &array)
{
  piece.insert(piece.rfind('\n', piece.rfind("</PointData>")) + 1, array);
}

void write_vtu_pieces(const std::filesystem::path &path,
                      std::string piece,
                      const DataOutBase::VtkFlags &flags,
                      MPI_Comm communicator)
{
  const std::vector<std::string> pieces = gather_texts(std::move(piece), communicator);
  agree(communicator, [&]() {
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    write_file(path, [&](std::ostream &stream) {
      DataOutBase::write_vtu_header(stream, flags);
      for (const std::string &text : pieces)
        stream << text;
      DataOutBase::write_vtu_footer(stream);
    });
  });
}

// The body for ParaView: displacement, its recovery, stresses, bound.

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

/** Computes sigma = E : eps(u) and its invariants at the output points. */
template <int dim>
class StressPostprocessor : public DataPostprocessor<dim>
{
  static_assert(dim == 2, "The components are those of a plane body.");

public:
  /** Stores the material. @param dilatation instead of tr eps(u), by active cell index; empty: tr
   * eps(u) itself. */
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

  UpdateFlags get_needed_update_flags() const override
  {
    return update_gradients | update_quadrature_points;
  }

  void evaluate_vector_field(const DataPostprocessorInputs::Vector<dim> &inputs,
                             std::vector<dealii::Vector<double>> &computed) const override
  {
    for (unsigned int q = 0; q < computed.size(); ++q)
    {
      Tensor<2, dim> gradient;
      for (unsigned int i = 0; i < dim; ++i)
        gradient[i] = inputs.solution_gradients[q][i];
      SymmetricTensor<2, dim> strain = symmetrize(gradient);
      if (!dilatation_.empty())
        replace_trace(strain, dilatation_[inputs.template get_cell<dim>()->active_cell_index()]);
      evaluate(inputs.evaluation_points[q], strain, computed[q]);
    }
  }

private:
  void evaluate(const Point<dim> &x,
                const SymmetricTensor<2, dim> &strain,
                dealii::Vector<double> &computed) const
  {
    try
    {
      const Stress3D stress = stress_in_3d(material_, x, strain);
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

/** The cells of this rank with their fields, as a piece of a file. Cells may have different numbers
 * of subdivisions. */
template <int dim>
struct FieldPiece
{
  using VectorRange = std::tuple<unsigned int,
                                 unsigned int,
                                 std::string,
                                 dealii::DataComponentInterpretation::DataComponentInterpretation>;

  std::string text(const DataOutBase::VtkFlags &flags) const
  {
    std::ostringstream stream;
    DataOutBase::write_vtu_main(cells, names, vectors, flags, stream);
    std::string text = stream.str();
    // A rank may have no cells, and then has no point data.
    if (!cells.empty())
      add_to_point_data(text, vtu_array("stress", 9, stress_tensors()));
    return text;
  }

  std::vector<DataOutBase::Patch<dim, dim>> cells;
  std::vector<std::string> names;
  std::vector<VectorRange> vectors;

private:
  /** Returns the 3-D tensor, point by point: deal.II's tensors of 2-D bodies have sigma_zz = 0. */
  std::vector<float> stress_tensors() const
  {
    const auto row = [&](const char *name) {
      return static_cast<unsigned int>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const unsigned int xx = row("stress_xx"), yy = row("stress_yy"), zz = row("stress_zz"),
                       xy = row("stress_xy");
    std::vector<float> tensors;
    for (const auto &cell : cells)
      for (unsigned int v = 0; v < cell.data.n_cols(); ++v)
      {
        const auto value = [&](const unsigned int n) { return cell.data(n, v); };
        tensors.insert(tensors.end(),
                       {value(xx), value(xy), 0.F, value(xy), value(yy), 0.F, 0.F, 0.F, value(zz)});
      }
    return tensors;
  }
};

/** The fields on some of the cells, which are all divided in the same way. */
template <int dim>
class FieldsOnCells : public DataOut<dim>
{
public:
  /** Adds the cells of this rank that were built to a piece. */
  void append_to(FieldPiece<dim> &piece) const
  {
    piece.names = this->get_dataset_names();
    piece.vectors = this->get_nonscalar_data_ranges();
    const auto &built = this->get_patches();
    piece.cells.insert(piece.cells.end(), built.begin(), built.end());
  }
};

dealii::Vector<double> to_vector(const std::vector<double> &values)
{
  return {values.begin(), values.end()};
}

/** Returns which cells deal.II draws with curved edges. */
template <int dim>
typename DataOut<dim>::CurvedCellRegion curved_region(const Mesh<dim> &mesh)
{
  return mesh.is_curved() ? DataOut<dim>::curved_inner_cells : DataOut<dim>::no_curved_cells;
}

template <int dim>
void add_displacement(const DoFHandler<dim> &dofs,
                      const Displacement &U,
                      const std::string &name,
                      FieldsOnCells<dim> &fields)
{
  using namespace dealii::DataComponentInterpretation;
  fields.add_data_vector(
    dofs,
    U.entries(),
    std::vector<std::string>(dim, name),
    std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>(
      dim, component_is_part_of_vector));
}

/** Returns the fields on cells of degree one, divided into four where there is T^{2h}, whose
 * interpolation gives the stress. */
template <int dim>
FieldPiece<dim> fields_of_bilinear_cells(const DisplacementSpace<dim> &space,
                                         const Displacement &U,
                                         const StressPostprocessor<dim> &stress,
                                         const BoundFields &bound)
{
  const std::array<std::pair<const char *, dealii::Vector<double>>, 3> cell_fields = {
    {{"bound_mesh", to_vector(bound.mesh)},
     {"bound_oscillation", to_vector(bound.oscillation)},
     {"bound_lift", to_vector(bound.lift)}}};
  FieldsOnCells<dim> fields;
  add_displacement(space.dofs(), U, "displacement", fields);
  std::optional<RecoveredDisplacement<dim>> recovered;
  if (space.mesh().has_parents())
  {
    recovered.emplace(space, U);
    add_displacement(recovered->dofs(), recovered->values(), "recovered_displacement", fields);
    fields.add_data_vector(recovered->dofs(), recovered->values().entries(), stress);
  }
  else
    fields.add_data_vector(space.dofs(), U.entries(), stress);
  for (const auto &[name, values] : cell_fields)
    if (values.size() > 0)
      fields.add_data_vector(values, name, DataOut<dim>::type_cell_data);
  fields.build_patches(
    space.mesh().mapping(), space.mesh().has_parents() ? 2 : 1, curved_region(space.mesh()));
  FieldPiece<dim> piece;
  fields.append_to(piece);
  return piece;
}

/** Returns the fields on cells of degree p, divided into p x p, those of lower degrees first. */
template <int dim>
FieldPiece<dim> fields_by_degree(const DisplacementSpace<dim> &space,
                                 const Displacement &U,
                                 const StressPostprocessor<dim> &stress)
{
  dealii::Vector<double> degrees(space.mesh().triangulation().n_active_cells());
  for (const auto &cell : space.dofs().active_cell_iterators())
    degrees[cell->active_cell_index()] = cell->get_fe().degree;
  FieldPiece<dim> piece;
  for (unsigned int degree = 1; degree <= space.max_element_degree(); ++degree)
  {
    if (std::find(degrees.begin(), degrees.end(), degree) == degrees.end())
      continue;
    FieldsOnCells<dim> fields;
    add_displacement(space.dofs(), U, "displacement", fields);
    fields.add_data_vector(space.dofs(), U.entries(), stress);
    fields.add_data_vector(degrees, "degree", DataOut<dim>::type_cell_data);
    fields.set_cell_selection([&](const typename DataOut<dim>::cell_iterator &cell) {
      return cell->is_active() && degrees[cell->active_cell_index()] == degree;
    });
    fields.build_patches(space.mesh().mapping(), degree, curved_region(space.mesh()));
    fields.append_to(piece);
  }
  return piece;
}
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
  const StressPostprocessor<dim> stress(*scene.material,
                                        space.strain_operator() == StrainOperator::mean_dilatation
                                          ? mean_dilatations(space, U)
                                          : std::vector<double>());
  const FieldPiece<dim> piece = space.max_element_degree() > 1
                                  ? fields_by_degree(space, U, stress)
                                  : fields_of_bilinear_cells(space, U, stress, bound);
  write_vtu_pieces(path, piece.text(flags), flags, space.mesh().communicator());
}

void write_pvd(const std::filesystem::path &path,
               const std::vector<std::pair<double, std::string>> &files)
{
  std::ostringstream record;
  DataOutBase::write_pvd_record(record, files);
  // The comment, which contains the time, is removed: the same run gives the same file.
  std::string text = record.str();
  const std::size_t start = text.find("<!--"), end = text.find("-->");
  if (start != std::string::npos && end != std::string::npos)
    text.erase(start, text.find_first_not_of("->\n", end) - start);
  write_file(path, [&](std::ostream &stream) { stream << text; });
}

template void write_solution_vtu(const std::filesystem::path &,
                                 const DisplacementSpace<2> &,
                                 const Scene<2> &,
                                 const Displacement &,
                                 const BoundFields &,
                                 unsigned int);
} // namespace Signorini
