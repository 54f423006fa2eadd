// SPDX-License-Identifier: LGPL-2.1-or-later
// What the bound of pi^{2h} u_h needs of the stress.

#include <signorini/bound/equilibrated_stress.h>
#include <signorini/bound/pointwise.h>
#include <signorini/bound/pressing_edges.h>

#include <algorithm>

namespace Signorini
{
double EquilibratedStress::patch_misfit_square(const unsigned int cell,
                                               const CellData &data,
                                               const double misfit_square) const
{
  const PatchBubbles::Coefficients b = bubbles_->on(cell);
  CellMisfit misfit;
  misfit.u = deformation(mesh_.cells()[cell]);
  if (const BubbleForm *form = lift_.cells()[cell] ? nullptr : forms_.of(cell, table_, data))
  {
    misfit.stresses = stresses(cell, data);
    misfit.slope = load(cell).slope;
    return std::max(0., misfit_square + form->change(b, misfit));
  }
  const std::vector<Law> &laws = table_.laws(cell, data);
  const std::vector<Components> tau = stress(cell, data);
  UpperSum square;
  for (std::size_t i = 0; i < data.points.size(); ++i)
  {
    const StressPoint &point = data.points[i];
    const Law &law = law_at(laws, i);
    const Components e = sum(strain(cell, point, misfit.u), strain_of(bubble_gradients(point), b));
    const Components s = difference(law.stress(e), tau[i]);
    square.add(point, contraction(s, law.strain(s)));
  }
  return square.value();
}

double EquilibratedStress::patch_lift_energy(const unsigned int cell, const CellData &data) const
{
  const std::vector<Law> &laws = table_.laws(cell, data);
  UpperSum energy;
  for (std::size_t i = 0; i < data.points.size(); ++i)
  {
    const StressPoint &point = data.points[i];
    // u_D - pi^{2h} u_h = (u_D - u_h) - b.
    const Components e = difference(lift_.strain(cell, point),
                                    strain_of(bubble_gradients(point), bubbles_->held_back(cell)));
    energy.add(point, contraction(e, law_at(laws, i).stress(e)));
  }
  return energy.value();
}

double EquilibratedStress::normal_bubble(const unsigned int contact_face) const
{
  const auto &face = data_.multipliers.surface().faces()[contact_face];
  const unsigned int edge = mesh_.edge_of_line(face.cell->face(face.face_no)->index());
  return bubbles_->on_edge(edge) * mesh_.edges()[edge].normal;
}

std::vector<std::optional<std::array<double, 2>>> EquilibratedStress::free_tractions() const
{
  const auto &faces = data_.multipliers.surface().faces();
  std::vector<std::optional<std::array<double, 2>>> tractions(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const auto line = faces[i].cell->face(faces[i].face_no);
    const unsigned int number = mesh_.edge_of_line(line->index());
    const Edge &edge = mesh_.edges()[number];
    if (edge.freedom != EdgeFreedom::normal)
      continue;
    tractions[i] = normal_tractions(edge, number, moments_);
    if (edge.vertices[0] != line->vertex_index(0))
      std::swap((*tractions[i])[0], (*tractions[i])[1]);
  }
  return tractions;
}
} // namespace Signorini
