// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/mesh_file/file_mesh.h>

namespace Signorini
{
/** Adds the names and the loops of the boundary to a mesh that has its vertices and cells.
 * @param cells those of the mesh, with the nodes of the file, in the same order.
 * @throws InputError if edges, lines and names do not fit together. */
void add_boundary(const GmshMesh &gmsh,
                  const std::vector<GmshMesh::Element> &cells,
                  FileMesh &mesh);
} // namespace Signorini
