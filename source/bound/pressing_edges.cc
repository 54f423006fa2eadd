// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact edges whose normal traction may be free.

#include <signorini/bound/pressing_edges.h>
#include <signorini/postprocess/contact_pressure.h>

namespace Signorini
{
std::vector<unsigned int> pressing_edges(const EdgeMesh &mesh,
                                         const MultiplierSpace<2> &multipliers,
                                         const dealii::Vector<double> &P)
{
  const ContactSurface<2> &surface = multipliers.surface();
  const double threshold = pressing_threshold(P);
  std::vector<bool> presses(surface.faces().size(), true);
  for (const Piece<2> &piece : surface.pieces())
    if (!(multipliers.value(P, piece.patch, piece.lower) < threshold))
      presses[piece.face] = false;
  std::vector<unsigned int> edges;
  for (std::size_t i = 0; i < presses.size(); ++i)
    if (presses[i])
    {
      const ContactFace<2> &face = surface.faces()[i];
      edges.push_back(mesh.edge_of_line(face.cell->face(face.face_no)->index()));
    }
  return edges;
}

std::array<double, 2> normal_tractions(const Edge &edge,
                                       const unsigned int number,
                                       const std::vector<double> &moments)
{
  double a = 0., b = 0.;
  for (unsigned int c = 0; c < 2; ++c)
  {
    a += moments[4 * number + c] * edge.normal[c];
    b += moments[4 * number + 2 + c] * edge.normal[c];
  }
  return {{(4. * a - 2. * b) / edge.length, (4. * b - 2. * a) / edge.length}};
}
} // namespace Signorini
