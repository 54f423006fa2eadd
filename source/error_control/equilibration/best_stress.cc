// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps of the best stress.

#include <signorini/base/errors.h>
#include <signorini/error_control/equilibration/best_stress.h>
#include <signorini/error_control/equilibration/contact_tractions.h>
#include <signorini/error_control/equilibration/difference_misfit.h>
#include <signorini/error_control/equilibration/energy_misfit.h>
#include <signorini/error_control/equilibration/traction_solver.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/contradictions.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace Signorini {
namespace {
using StressCells = std::vector<EquilibrationMesh::Cell>;

/** Returns the cells with one of the edges. */
StressCells cells_at(const std::set<unsigned int> &edges, const EquilibrationMesh &mesh,
                     const TractionSpace &space) {
  StressCells cells;
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    for (const TractionSide &side : space.cells()[cell->active_cell_index()].sides)
      for (const unsigned int edge : space.sources(side.edge))
        if (edges.count(edge) > 0)
          cells.push_back(cell);
  return cells;
}

/** Returns the cells on which loads are not resolved. @param total ‖σ(u_h) - τ‖, about that, or
 * less where loads count for more. */
template <typename Misfit>
StressCells unresolved(const double total, const EquilibrationMesh &mesh,
                       const EquilibratedStress &stress) {
  StressCells cells;
  if (std::sqrt(stress.oscillation_square()) <= 0.1 * total)
    return cells;
  const double allowed = 0.1 * total / std::sqrt(stress.fits.size());
  for (const auto &cell : mesh.triangulation().active_cell_iterators()) {
    const unsigned int c = cell->active_cell_index();
    if (stress.oscillation(c) > std::max(allowed, 0.1 * Misfit::least(stress.fits[c])))
      cells.push_back(cell);
  }
  return cells;
}

template <typename Misfit>
BestStress find(const BoundData &data) {
  /** The largest residual force, see minimise(). */
  constexpr double largest_defect = 1e-9;
  EquilibrationMesh mesh(data);
  const Misfit misfit(data);
  CellFitter fitter(data, Misfit::compares);
  std::vector<CellFit> fits;
  for (;;) {
    EquilibratedStress stress = {Tractions(data, mesh), {}};
    ContactTractions contact(data, stress.tractions);
    stress.fits = fits = fitter.fit_all(mesh, stress.tractions.space, fits);
    // Loads that count beside the expected misfit are resolved at once.
    if (mesh.refine(cells_at(contact.unresolved(), mesh, stress.tractions.space), false) ||
        mesh.refine(unresolved<Misfit>(misfit.expected(stress), mesh, stress),
                    !mesh.is_own() || !mesh.is_aligned()))
      continue;
    const auto works = misfit.works(mesh, stress);
    do {
      stress.defect = minimise(stress.fits, misfit.moments(stress, works), stress.tractions);
      if (!(stress.defect <= largest_defect))
        throw ComputationError(
          "no stress in equilibrium was found: the tractions of the contact sides cannot carry "
          "the loads, or rounding");
    } while (contact.fix_pulling_edges());
    if (!mesh.refine(unresolved<Misfit>(misfit.allowed_load(stress, works), mesh, stress), true)) {
      StressBound bound = misfit.bound(stress, works);
      return {std::move(stress), std::move(bound)};
    }
  }
}
} // namespace

std::string objection_to_stress(const DisplacedBody<2> &body) {
  if (body.scene.geometry.axisymmetric)
    return "the body is one of revolution, for which there is no proof of a bound";
  if (body.space.strain_operator() != StrainOperator::symmetric_gradient &&
      body.space.max_element_degree() > 1)
    return "the strain is that of B-bar, with elements of a degree above one";
  std::set<unsigned int> paired;
  for (const ContactPair<2> &pair : contact_pairs(body.scene))
    if (pair.other_side()) {
      for (const unsigned int side : {pair.side(), *pair.other_side()})
        if (!paired.insert(side).second)
          return "the side '" + body.scene.geometry.sides[side].name() + "' is in several pairs";
      const Side<2> &a = body.scene.geometry.sides[pair.side()],
                    &b = body.scene.geometry.sides[*pair.other_side()];
      if (!(a.is_flat() && b.is_flat() && (a.normal(0.) + b.normal(0.)).norm() < 1e-10))
        return "the sides '" + a.name() + "' and '" + b.name() +
               "' of a pair are not straight and parallel";
    }
  return find_contradiction(body.scene);
}

BestStress find_best_stress(const BoundData &data) {
  return EquilibrationMesh::is_that_of_u(data) ? find<DifferenceMisfit>(data)
                                               : find<EnergyMisfit>(data);
}
} // namespace Signorini
