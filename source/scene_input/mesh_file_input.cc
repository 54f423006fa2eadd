// SPDX-License-Identifier: LGPL-2.1-or-later
// Geometry/Shape = file: from the name of a mesh file to a body.

#include "mesh_file_input.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/mesh_file/file_geometry.h>
#include <signorini/parameters/parameter_text.h>

#include <filesystem>

namespace Signorini
{
namespace
{
/** In bytes: some millions of cells. */
constexpr std::size_t largest_mesh_file = 500000000;
} // namespace

Geometry<2> read_mesh_file(const GeometryParameters &given)
{
  if (given.distortion.changed)
    throw InputError(given.distortion.where() +
                     ": meshes from files are not distorted, found Shape = file.");
  const std::filesystem::path path(given.file.value);
  std::error_code error;
  if (given.file.value.empty())
    throw InputError(given.file.where() + ": found '', allowed: a mesh file of Gmsh (.msh).");
  if (!std::filesystem::exists(path, error))
    throw InputError(given.file.where() + ": found " + quote(given.file) +
                     ", which is neither in the folder of the parameter file" +
                     (given.folder.empty() ? "" : " (" + shorten_path(given.folder) + ")") +
                     " nor in the working folder, allowed: a mesh file of Gmsh (.msh).");
  const std::string text =
    read_whole_file(path.string(), given.file.where() + ": ", "mesh file", largest_mesh_file);
  const std::string name = given.file.where() + ": " + shorten_path(path.filename().string());
  return make_geometry(
    make_file_mesh(read_gmsh(text, name)), split_words(given.arcs), given.arcs.where());
}
} // namespace Signorini
