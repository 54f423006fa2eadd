// SPDX-License-Identifier: LGPL-2.1-or-later
// What the bound of pi^{2h} u_h needs of the stress.

#include <signorini/bound/equilibrated_stress.h>
#include <signorini/bound/pointwise.h>
#include <signorini/bound/pressing_edges.h>

#include <algorithm>

namespace Signorini
{
void EquilibratedStress::integrate_patches(const CellState &state, CellIntegrals &result) const
{
  const unsigned int cell = state.cell;
  const CellData &data = state.data;
  const PatchBubbles::Coefficients b = bubbles_->on(cell);
  const bool holds_back = bubbles_->holds_back(cell);
  CompositeCell::Stresses dual{};
  std::unique_ptr<const BubbleForm> own;
  const BubbleForm *form = forms_->of(cell);
  if (form == nullptr && !lift_.cells()[cell] && table_.constant_law() && data.shape.affine)
  {
    own = std::make_unique<const BubbleForm>(data.shape, state.laws[0]);
    form = own.get();
  }
  if (form != nullptr)
  {
    const CellMisfit misfit = {state.u, stresses(cell, data), load(cell).slope};
    result.squares.of_patches = std::max(0., result.squares.misfit + form->change(b, misfit));
    // There u_D - u_h = 0, and z is what is held back.
    result.squares.lift_of_patches =
      holds_back ? form->change(bubbles_->held_back(cell), CellMisfit{}) : 0.;
    dual = form->dual(b);
  }
  else
  {
    UpperSum square(state.from_above), energy(state.from_above);
    for (std::size_t i = 0; i < data.points.size(); ++i)
    {
      const StressPoint &point = data.points[i];
      const Law &law = law_at(state.laws, i);
      const BubbleGradients gradients = bubble_gradients(point);
      const Components of_bubbles = strain_of(gradients, b);
      const Components e = sum(strain(cell, point, state.u), of_bubbles);
      const Components s = difference(law.stress(e), state.tau[i]);
      square.add(point, contraction(s, law.strain(s)));
      add_dual(point, of_bubbles, dual);
      if (!holds_back)
        continue;
      // u_D - pi^{2h} u_h = (u_D - u_h) - b.
      const Components z =
        difference(lift_.strain(cell, point), strain_of(gradients, bubbles_->held_back(cell)));
      energy.add(point, contraction(z, law.stress(z)));
    }
    result.squares.of_patches = square.value();
    result.squares.lift_of_patches = holds_back ? energy.value() : result.squares.lift;
  }
  const CellMoments of_bubbles = data.composite.transposed(dual);
  for (unsigned int j = 0; j < of_bubbles.size(); ++j)
    result.of_patches[j] = result.of_misfit[j] + of_bubbles[j];
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
