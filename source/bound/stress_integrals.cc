// SPDX-License-Identifier: LGPL-2.1-or-later
// What is integrated over the cells of a stress in equilibrium.

#include <signorini/base/threads.h>
#include <signorini/bound/equilibrated_stress.h>
#include <signorini/bound/pointwise.h>

#include <algorithm>

namespace Signorini
{
Components EquilibratedStress::strain(const unsigned int cell,
                                      const StressPoint &point,
                                      const CornerValues &u) const
{
  const Components of_u_h = strain_of(point.gradients, u);
  if (!lift_.cells()[cell])
    return of_u_h;
  return sum(of_u_h, lift_.strain(cell, point));
}

EquilibratedStress::CellIntegrals EquilibratedStress::integrate(const unsigned int cell,
                                                                CellRoom &room,
                                                                const bool from_above,
                                                                CellEnergies *const energies) const
{
  const CellData &data = table_.data(cell, room);
  const CellState state = {cell,
                           data,
                           table_.laws(cell, data, room),
                           stress(cell, data),
                           deformation(mesh_.cells()[cell]),
                           from_above};
  CellIntegrals result;
  UpperSum misfit_square(from_above), stress_square(from_above), lift_square(from_above);
  double &smallest_eigenvalue = result.squares.smallest_eigenvalue;
  smallest_eigenvalue = state.laws[0].smallest_eigenvalue;
  CompositeCell::Stresses dual_of_misfit{}, dual_of_stress{};
  for (std::size_t i = 0; i < data.points.size(); ++i)
  {
    const StressPoint &point = data.points[i];
    const Law &law = law_at(state.laws, i);
    const Components &tau = state.tau[i];
    const Components misfit = difference(law.stress(strain(cell, point, state.u)), tau);
    const Components of_misfit = law.strain(misfit), of_stress = law.strain(tau);
    misfit_square.add(point, contraction(misfit, of_misfit));
    stress_square.add(point, contraction(tau, of_stress));
    add_dual(point, of_misfit, dual_of_misfit);
    add_dual(point, of_stress, dual_of_stress);
    if (lift_.cells()[cell])
    {
      const Components e = lift_.strain(cell, point);
      lift_square.add(point, contraction(e, law.stress(e)));
    }
    smallest_eigenvalue = std::min(smallest_eigenvalue, law.smallest_eigenvalue);
    result.is_resolved = result.is_resolved && point.unresolved_part == StressPoint::resolved;
  }
  result.squares.misfit = misfit_square.value();
  result.squares.stress = stress_square.value();
  result.squares.lift = lift_square.value();
  result.of_misfit = data.composite.transposed(dual_of_misfit);
  result.of_stress = data.composite.transposed(dual_of_stress);
  if (bubbles_)
    integrate_patches(state, result);
  if (energies != nullptr && energies->is_first(cell))
    energies->set(cell, make_energy(data, state.laws));
  return result;
}

std::vector<EquilibratedStress::CellIntegrals>
EquilibratedStress::integrate_all(CellEnergies &energies) const
{
  std::vector<CellIntegrals> all(mesh_.cells().size());
  work_on_ranges(n_threads(), all.size(), [&](const std::size_t begin, const std::size_t end) {
    CellRoom room;
    for (std::size_t c = begin; c < end; ++c)
      all[c] = integrate(c, room, false, &energies);
  });
  return all;
}

void EquilibratedStress::update(const std::vector<CellIntegrals> &integrals,
                                const CellEnergies &energies,
                                const std::vector<double> &change)
{
  // Where more digits than that are lost, the cell is integrated again.
  constexpr double least_share = 1e-3;
  squares_.resize(integrals.size());
  work_on_ranges(
    n_threads(), integrals.size(), [&](const std::size_t begin, const std::size_t end) {
      CellRoom room;
      for (std::size_t c = begin; c < end; ++c)
      {
        const CellIntegrals &before = integrals[c];
        CellSquares &squares = squares_[c] = before.squares;
        const CellMoments b = moments_on(mesh_.cells()[c], change), Sb = multiply(energies(c), b);
        for (unsigned int j = 0; j < b.size(); ++j)
        {
          squares.misfit += b[j] * (Sb[j] - 2. * before.of_misfit[j]);
          squares.of_patches += b[j] * (Sb[j] - 2. * before.of_patches[j]);
          squares.stress += b[j] * (Sb[j] + 2. * before.of_stress[j]);
        }
        if (!before.is_resolved || squares.misfit < least_share * before.squares.misfit ||
            squares.of_patches < least_share * before.squares.of_patches ||
            squares.stress < least_share * before.squares.stress)
          squares = integrate(c, room, true).squares;
      }
    });
}
} // namespace Signorini
