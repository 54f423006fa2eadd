// SPDX-License-Identifier: LGPL-2.1-or-later
// What is integrated over the cells of a stress in equilibrium.

#include <signorini/base/threads.h>
#include <signorini/bound/equilibrated_stress.h>

#include <algorithm>

namespace Signorini
{
namespace
{
double product(const Components &a, const Components &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Components difference(const Components &a, const Components &b)
{
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}

const Law &law_at(const std::vector<Law> &laws, const std::size_t i)
{
  return laws[laws.size() == 1 ? 0 : i];
}
} // namespace

Components EquilibratedStress::strain(const unsigned int cell,
                                      const StressPoint &point,
                                      const CornerValues &u) const
{
  const Components of_u_h = strain_of(point.gradients, u);
  if (!lift_.cells()[cell])
    return of_u_h;
  const Components more = lift_.strain(cell, point);
  return {{of_u_h[0] + more[0], of_u_h[1] + more[1], of_u_h[2] + more[2]}};
}

EquilibratedStress::CellIntegrals EquilibratedStress::integrate(const unsigned int cell,
                                                                CellRoom &room,
                                                                CellEnergies *const energies) const
{
  const CellData &data = table_.data(cell, room);
  const std::vector<Law> &laws = table_.laws(cell, data, room);
  const std::vector<Components> tau = stress(cell, data);
  const CornerValues u = displacement(mesh_.cells()[cell]);
  CellIntegrals result;
  CellSquares &sum = result.squares;
  sum.smallest_eigenvalue = laws[0].smallest_eigenvalue;
  CompositeCell::Stresses dual_of_misfit{}, dual_of_stress{};
  for (std::size_t i = 0; i < data.points.size(); ++i)
  {
    const StressPoint &point = data.points[i];
    const Law &law = law_at(laws, i);
    const Components misfit = difference(law.stress(strain(cell, point, u)), tau[i]);
    const Components of_misfit = law.strain(misfit), of_stress = law.strain(tau[i]);
    sum.misfit += point.weight * product(misfit, of_misfit);
    sum.stress += point.weight * product(tau[i], of_stress);
    for (unsigned int m = 0; m < 3; ++m)
    {
      const double weight = point.weight * point.psi[m];
      for (unsigned int l = 0; l < 3; ++l)
      {
        dual_of_misfit[9 * point.triangle + 3 * m + l] += weight * of_misfit[l];
        dual_of_stress[9 * point.triangle + 3 * m + l] += weight * of_stress[l];
      }
    }
    if (lift_.cells()[cell])
    {
      const Components e = lift_.strain(cell, point);
      sum.lift += point.weight * product(e, law.stress(e));
    }
    sum.smallest_eigenvalue = std::min(sum.smallest_eigenvalue, law.smallest_eigenvalue);
  }
  result.of_misfit = data.composite.transposed(dual_of_misfit);
  result.of_stress = data.composite.transposed(dual_of_stress);
  if (energies != nullptr && energies->is_first(cell))
    energies->set(cell, make_energy(data, laws));
  return result;
}

std::vector<EquilibratedStress::CellIntegrals>
EquilibratedStress::integrate_all(CellEnergies &energies) const
{
  std::vector<CellIntegrals> all(mesh_.cells().size());
  work_on_ranges(n_threads(), all.size(), [&](const std::size_t begin, const std::size_t end) {
    CellRoom room;
    for (std::size_t c = begin; c < end; ++c)
      all[c] = integrate(c, room, &energies);
  });
  return all;
}
} // namespace Signorini
