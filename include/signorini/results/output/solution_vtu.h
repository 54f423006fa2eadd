// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/bound/error_bound.h>

#include <deal.II/base/data_out_base.h>

#include <algorithm>
#include <functional>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace Signorini {
/** The fields at a point of a VTU file, numbers with their names. Three or nine numbers with the
 * same name are the components of a vector or of a tensor. */
using VtuFields = std::vector<std::pair<const char *, double>>;

/** Adds a vector, in the plane with the third component 0. */
template <int dim>
void add_vector(const char *const name, const Tensor<1, dim> &vector, VtuFields &fields) {
  for (unsigned int d = 0; d < 3; ++d)
    fields.emplace_back(name, d < dim ? vector[d % dim] : 0.);
}

/** The cells of a VTU file, all with the same fields. All files are three-dimensional: in 2-D, too,
 * deal.II writes tensors with all their components then. */
template <int dim>
struct VtuCells {
  using Range = std::tuple<unsigned int, unsigned int, std::string,
                           DataComponentInterpretation::DataComponentInterpretation>;

  std::vector<DataOutBase::Patch<dim, 3>> cells;
  /** The names of the numbers. */
  std::vector<std::string> names;

  /** Adds a cell that is divided into n^dim, with its points and the fields there. */
  template <int spacedim>
  void add(const unsigned int n, const std::vector<Point<spacedim>> &points,
           const std::vector<VtuFields> &fields) {
    AssertDimension(points.size(), fields.size());
    if (names.empty())
      for (const auto &[name, value] : fields[0])
        names.emplace_back(name);
    DataOutBase::Patch<dim, 3> &cell = cells.emplace_back();
    cell.patch_index = cells.size() - 1;
    cell.reference_cell = ReferenceCells::get_hypercube<dim>();
    cell.n_subdivisions = n;
    // The last three rows are the points.
    cell.points_are_available = true;
    cell.data.reinit(names.size() + 3, points.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
      for (std::size_t i = 0; i < names.size(); ++i)
        cell.data(i, v) = fields[v][i].second;
      for (unsigned int d = 0; d < spacedim; ++d)
        cell.data(names.size() + d, v) = points[v][d];
    }
  }
  /** Returns which numbers are the components of a vector or tensor. */
  std::vector<Range> ranges() const {
    std::vector<Range> ranges;
    for (auto first = names.begin(), end = first; first != names.end(); first = end) {
      end = std::find_if(first, names.end(), [&](const auto &name) { return name != *first; });
      if (end - first > 1)
        ranges.emplace_back(first - names.begin(), end - names.begin() - 1, *first,
                            end - first == 3
                              ? DataComponentInterpretation::component_is_part_of_vector
                              : DataComponentInterpretation::component_is_part_of_tensor);
    }
    return ranges;
  }
};

/**
 * Writes for ParaView u_h, the patch interpolation that comes closest to u (best_interpolation()),
 * its 3-D stress tensor, its von Mises stress and its principal stresses; and the bound cell by
 * cell, where there is one. In 2-D cells are divided into four where T^{2h} exists; cells of a
 * degree p > 1 are divided into p x p, get the stress of u_h, and have the field "degree". In 3-D
 * the file contains u_h and stresses at the corners of the cells, where the patch interpolation is
 * u_h; the children of a parent share these unless the material varies. A rank writes its own
 * cells, at most 65536 or 16384 parents in a piece of the file: with fewer, the file has one piece.
 *
 * Collective; the function that is returned writes, without communication, so that it may fail on
 * one rank alone. It refers to the objects of the arguments, and returns the fields, without cells.
 */
template <int dim>
std::function<VtuCells<dim>(std::ostream &)> solution_vtu(const DisplacedBody<dim> &body,
                                                          const BoundFields &bound,
                                                          unsigned int number);

/** Writes a .pvtu that lists the files of all ranks, which have these @p fields. */
template <int dim>
void write_pvtu(std::ostream &stream, const std::vector<std::string> &files,
                const VtuCells<dim> &fields);

/** Writes a .pvd that lists one file per level; the level replaces time. */
void write_pvd(std::ostream &stream, const std::vector<std::pair<double, std::string>> &files);
} // namespace Signorini
