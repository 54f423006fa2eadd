// SPDX-License-Identifier: LGPL-2.1-or-later
// The body for ParaView: displacement, its recovery, stresses, bound.

#include <signorini/base/instantiate.h>
#include <signorini/base/parallel.h>
#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/postprocessing/fields/stress.h>
#include <signorini/results/output/solution_vtu.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
namespace {
/** Some readers (meshio) lose cells of a file of several pieces: up to so many cells are one. */
constexpr std::size_t cells_in_one_piece = 65536;
/** The cells of each of several pieces, which bound the memory of writing: one takes 0.1 GB. */
constexpr std::size_t cells_per_piece = 16384;
/** The most threads that make pieces. */
constexpr unsigned int max_threads = 4;

/** Returns whether the file shows a patch interpolation beside u_h. */
template <int dim>
bool is_recovered(const DisplacementSpace<dim> &space) {
  return space.max_element_degree() == 1 && space.mesh().has_parents();
}

/** A piece of the file: its text, and the names of the fields. */
using VtuPiece = std::pair<std::string, std::vector<std::string>>;

/** Makes a piece of some cells with their fields. Cells may be divided in different ways. */
template <int dim>
class PieceWriter {
public:
  using Cell = typename DoFHandler<dim>::active_cell_iterator;

  PieceWriter(const SampledField<dim> &field, const BoundFields &bound,
              const unsigned int n_generations)
    : field_(field)
    , stress_(*field.scene.material)
    , bound_(bound)
    , n_generations_(n_generations)
    , is_recovered_(is_recovered(field.space))
    , by_parents_(dim == 3 && is_recovered_ && field.scene.material->is_constant()) {}

  /** Writes all cells of this rank in pieces, which threads make; they are the same for any number
   * of threads. @return the fields. */
  VtuCells<dim> write(const DataOutBase::VtkFlags &flags, std::ostream &stream) const {
    std::vector<Cell> cells;
    for (unsigned int number = 0; number < field_.space.elements().size(); ++number)
      for (const Cell &cell : field_.space.dofs().active_cell_iterators())
        if (cell->is_locally_owned() && cell->active_fe_index() == number &&
            !(by_parents_ && cell->parent()->child_index(0) != cell->index()))
          cells.push_back(cell);
    // A parent in space takes the memory of four cells in the plane.
    const std::size_t weight = by_parents_ ? 4 : 1,
                      size = (weight * cells.size() > cells_in_one_piece ? cells_per_piece
                                                                         : cells_in_one_piece) /
                             weight;
    VtuCells<dim> fields;
    produce_in_parallel<VtuPiece>(
      std::min(n_available_threads(), max_threads), (cells.size() + size - 1) / size,
      [&](const std::size_t i) {
        PieceWriter writer(field_, bound_, n_generations_);
        for (auto first = cells.begin() + i * size,
                  end = cells.begin() + std::min((i + 1) * size, cells.size()), next = first;
             first != end; first = next) {
          const unsigned int number = (*first)->active_fe_index();
          next = std::find_if(first, end,
                              [&](const Cell &cell) { return cell->active_fe_index() != number; });
          writer.add_cells(number, first, next);
        }
        const VtuCells<dim> &piece = writer.cells_;
        std::ostringstream text;
        DataOutBase::write_vtu_main(piece.cells, piece.names, piece.ranges(), flags, text);
        return VtuPiece(text.str(), piece.names);
      },
      [&](const VtuPiece &piece) {
        stream << piece.first;
        fields.names = piece.second;
      });
    return fields;
  }

private:
  using CellInList = typename std::vector<Cell>::const_iterator;

  /** Adds cells of one of the elements. */
  void add_cells(const unsigned int number, const CellInList first, const CellInList end) {
    const FiniteElement<dim> &element = field_.space.elements()[number];
    unsigned int n = dim == 3 ? 1 : element.degree;
    if (is_recovered_ && (dim == 2 || by_parents_))
      n = 2;
    // The corners of all children of a parent, seen from its first one.
    const Quadrature<1> of_children(
      std::vector<Point<1>>{Point<1>(0.), Point<1>(1.), Point<1>(2.)});
    const Quadrature<dim> points =
      by_parents_ ? Quadrature<dim>(of_children) : QIterated<dim>(QTrapezoid<1>(), n);
    // At the corners of children the interpolation is u_h.
    std::vector<EvaluatedField> fields;
    if (!by_parents_)
      fields.push_back({&field_.U});
    if (is_recovered_)
      fields.push_back({&field_.U, n_generations_});
    CellEvaluator<dim> u(
      field_.space, fields, [&](unsigned int) { return points; }, {}, false);
    for (CellInList cell = first; cell != end; ++cell) {
      u.reinit(*cell, number);
      add_cell(*cell, n, u, fields.size() - 1);
    }
  }

  /** Returns the corners of all children of the parent of a cell, x running first: cells need not
   * be halves of a box. */
  static std::vector<Point<dim>> corners_of_children(const Cell &cell) {
    std::vector<Point<dim>> corners;
    for (unsigned int i = 0; i < std::lround(std::pow(3., dim)); ++i) {
      unsigned int child = 0, vertex = 0;
      for (unsigned int d = 0, position = i; d < dim; ++d, position /= 3) {
        child |= (position % 3 == 2 ? 1U : 0U) << d;
        vertex |= (position % 3 > 0 ? 1U : 0U) << d;
      }
      corners.push_back(cell->parent()->child(child)->vertex(vertex));
    }
    return corners;
  }

  /** Adds a cell with the field u_h and the one of which strains are taken. */
  void add_cell(const Cell &cell, const unsigned int n, const CellEvaluator<dim> &u,
                const unsigned int recovered) {
    const unsigned int index = cell->active_cell_index();
    const Point<dim> middle = cell->center();
    const bool has_regions = !field_.scene.geometry.regions.empty();
    const double region = has_regions ? field_.scene.geometry.region_at(middle) : 0.;
    const std::vector<Point<dim>> points = by_parents_ ? corners_of_children(cell) : u.points();
    fields_.resize(u.size());
    for (unsigned int q = 0; q < fields_.size(); ++q) {
      VtuFields &fields = fields_[q];
      fields.clear();
      add_vector("displacement", u.value(q), fields);
      if (dim == 2 && is_recovered_)
        add_vector("recovered_displacement", u.value(q, recovered), fields);
      add_stress(points[q], middle, field_.sample(u, q, recovered).strain, fields);
      if (has_regions)
        fields.emplace_back("region", region);
      if (!bound_.mesh.empty())
        fields.insert(fields.end(), {{"bound_mesh", bound_.mesh[index]},
                                     {"bound_oscillation", bound_.oscillation[index]},
                                     {"bound_lift", bound_.lift[index]}});
      if (field_.space.max_element_degree() > 1)
        fields.emplace_back("degree", cell->get_fe().degree);
    }
    cells_.add(n, points, fields_);
  }

  /** Adds the tensor, its components and its invariants. */
  void add_stress(const Point<dim> &x, const Point<dim> &middle, const Strain<dim> &strain,
                  VtuFields &fields) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    Stress3D stress = unknown * unit_symmetric_tensor<3>();
    std::array<double, 3> principal = {{unknown, unknown, unknown}};
    try {
      stress = stress_(x, middle, strain);
      principal = principal_stresses(stress);
    } catch (const InputError &) {
      // Mesh nodes may be the only points where the material's data has no value.
    }
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        fields.emplace_back("stress", stress[i][j]);
    fields.insert(fields.end(), {{"stress_xx", stress[0][0]},
                                 {"stress_yy", stress[1][1]},
                                 {"stress_zz", stress[2][2]},
                                 {"stress_xy", stress[0][1]}});
    if (dim == 3)
      fields.insert(fields.end(), {{"stress_xz", stress[0][2]}, {"stress_yz", stress[1][2]}});
    fields.insert(fields.end(), {{"von_mises_stress", von_mises(stress)},
                                 {"principal_stress_1", principal[0]},
                                 {"principal_stress_2", principal[1]},
                                 {"principal_stress_3", principal[2]}});
  }

  const SampledField<dim> &field_;
  StressIn3D<dim> stress_;
  const BoundFields &bound_;
  /** Those of the patch interpolation. */
  unsigned int n_generations_;
  /** Whether stresses come from the patch interpolation. */
  bool is_recovered_;
  /** Whether the children of a parent share their corners, where no field jumps between them. */
  bool by_parents_;
  VtuCells<dim> cells_;
  /** Those of the points of a cell. */
  std::vector<VtuFields> fields_;
};
} // namespace

template <int dim>
std::function<VtuCells<dim>(std::ostream &)> solution_vtu(const DisplacedBody<dim> &body,
                                                          const BoundFields &bound,
                                                          const unsigned int number) {
  const unsigned int n_generations =
    is_recovered(body.space) ? best_interpolation(body.space, body.U) : 0;
  return [body, &bound, number, n_generations](std::ostream &stream) {
    const DataOutBase::VtkFlags flags(number, number, false, DataOutBase::VtkFlags::best_speed);
    DataOutBase::write_vtu_header(stream, flags);
    const SampledField<dim> field(body);
    VtuCells<dim> fields = PieceWriter<dim>(field, bound, n_generations).write(flags, stream);
    DataOutBase::write_vtu_footer(stream);
    return fields;
  };
}

template <int dim>
void write_pvtu(std::ostream &stream, const std::vector<std::string> &files,
                const VtuCells<dim> &fields) {
  DataOutBase::write_pvtu_record(stream, files, fields.names, fields.ranges(),
                                 DataOutBase::VtkFlags());
}

void write_pvd(std::ostream &stream, const std::vector<std::pair<double, std::string>> &files) {
  std::ostringstream record;
  DataOutBase::write_pvd_record(record, files);
  // The comment, which contains the time, is left out: the same run gives the same file.
  static const std::regex comment("<!--[^>]*-->\\s*");
  stream << std::regex_replace(record.str(), comment, "");
}

INSTANTIATE_FUNCTION(solution_vtu);
INSTANTIATE_FUNCTION(write_pvtu);
} // namespace Signorini
