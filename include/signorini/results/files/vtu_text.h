// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/data_out_base.h>

#include <mpi.h>

#include <filesystem>
#include <string>
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
                      const dealii::DataOutBase::VtkFlags &flags,
                      MPI_Comm communicator);
} // namespace Signorini
