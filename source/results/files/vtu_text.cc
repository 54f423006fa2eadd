// SPDX-License-Identifier: LGPL-2.1-or-later
// Arrays and files that deal.II does not write in the format VTU.

#include <signorini/base/errors.h>
#include <signorini/base/parallel.h>
#include <signorini/results/files/files.h>
#include <signorini/results/files/vtu_text.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cstdint>
#include <zlib.h>

namespace Signorini
{
namespace
{
std::string base_64(const void *const data, const std::size_t size)
{
  const auto *const bytes = static_cast<const unsigned char *>(data);
  return dealii::Utilities::encode_base64(std::vector<unsigned char>(bytes, bytes + size));
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
} // namespace Signorini
