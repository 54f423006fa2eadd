// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/bound/error_bound.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/utilities.h>

#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace Signorini
{
/** A cell of a VTU file with its points and fields. All files are three-dimensional: in 2-D, too,
 * deal.II writes tensors with all their components then. */
template <int dim>
using VtuCell = DataOutBase::Patch<dim, 3>;

/** Returns a cell that is divided into n^dim, without points and fields yet. */
template <int dim>
VtuCell<dim> make_vtu_cell(const std::size_t index,
                           const unsigned int n,
                           const std::size_t n_fields)
{
  VtuCell<dim> cell;
  cell.patch_index = index;
  cell.reference_cell = ReferenceCells::get_hypercube<dim>();
  cell.n_subdivisions = n;
  // The last three rows are the points.
  cell.points_are_available = true;
  cell.data.reinit(n_fields + 3, Utilities::pow(n + 1, dim));
  return cell;
}

/** Sets point @p v of a cell and the fields there; fields that are vectors or tensors are three or
 * nine numbers. */
template <int dim, int spacedim>
void set_vtu_point(VtuCell<dim> &cell,
                   const unsigned int v,
                   const Point<spacedim> &x,
                   const std::vector<double> &fields)
{
  for (std::size_t i = 0; i < fields.size(); ++i)
    cell.data(i, v) = fields[i];
  for (unsigned int d = 0; d < spacedim; ++d)
    cell.data(fields.size() + d, v) = x[d];
}

using VtuRange = std::tuple<unsigned int,
                            unsigned int,
                            std::string,
                            DataComponentInterpretation::DataComponentInterpretation>;

/** Returns which numbers are the components of a vector or tensor: those with the same name. */
std::vector<VtuRange> vtu_ranges(const std::vector<std::string> &names);

/**
 * Writes for ParaView u_h, the patch interpolation that comes closest to u (best_interpolation()),
 * its 3-D stress tensor, its von Mises stress and its principal stresses; and the bound cell by
 * cell, where there is one. In 2-D cells are divided into four where T^{2h} exists; cells of a
 * degree p > 1 are divided into p x p, get the stress of u_h, and have the field "degree". In 3-D
 * the file contains u_h and stresses at the corners of the cells, where the patch interpolation is
 * u_h. Collective.
 */
template <int dim>
void write_solution_vtu(const std::filesystem::path &path,
                        const DisplacementSpace<dim> &space,
                        const Scene<dim> &scene,
                        const Displacement &U,
                        const BoundFields &bound,
                        unsigned int number);

/** Writes a .pvd that lists one file per level; the level takes the place of time. */
void write_pvd(std::ostream &stream, const std::vector<std::pair<double, std::string>> &files);
} // namespace Signorini
