// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/bound/error_bound.h>

#include <deal.II/base/data_out_base.h>

#include <mpi.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
/**
 * Returns a field of @p n_components numbers per point as a <DataArray>, point by point, in the
 * same form as the arrays of deal.II: 32-bit floats in one block, compressed by zlib, in base 64.
 */
std::string vtu_array(const std::string &name,
                      unsigned int n_components,
                      const std::vector<float> &values);

/** Adds an array to the point data of a <Piece>. */
void add_to_point_data(std::string &piece, const std::string &array);

/** Writes a file of the pieces of all ranks, on rank 0; an error, say a full disk, is thrown on all
 * ranks. Collective. */
void write_vtu_pieces(const std::filesystem::path &path,
                      std::string piece,
                      const DataOutBase::VtkFlags &flags,
                      MPI_Comm communicator);

/**
 * Writes for ParaView u_h, the patch interpolation that comes closest to u (RecoveredDisplacement,
 * where T^{2h} exists) and its 3-D stress tensor, its von Mises stress and its principal stresses;
 * and the bound cell by cell, where there is one. Cells of a degree p > 1 are divided into p x p,
 * get the stress of u_h, and have the field "degree" in place of the bound. In 3-D the file
 * contains u_h and the same stresses at the corners of the cells, where the patch interpolation is
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
void write_pvd(const std::filesystem::path &path,
               const std::vector<std::pair<double, std::string>> &files);
} // namespace Signorini
