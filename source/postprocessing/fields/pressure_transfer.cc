// SPDX-License-Identifier: LGPL-2.1-or-later
// A pressure carried over to the patches or the nodes of another mesh, and a displacement to the
// next level.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/patch_interpolation.h>
#include <signorini/postprocessing/fields/pressure_transfer.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <map>
#include <utility>

namespace Signorini {
namespace {
/** The part of an interval that another one covers. */
struct Overlap {
  unsigned int number;
  double share;
};

/** Returns for every interval between @p to its overlaps with those between @p from. */
std::vector<std::vector<Overlap>> overlaps(const std::vector<double> &from,
                                           const std::vector<double> &to) {
  std::vector<std::vector<Overlap>> all(to.size() - 1);
  std::size_t first = 0;
  for (std::size_t t = 0; t + 1 < to.size(); ++t) {
    while (first + 2 < from.size() && from[first + 1] <= to[t])
      ++first;
    for (std::size_t k = first; k + 1 < from.size() && from[k] < to[t + 1]; ++k) {
      const double length = std::min(from[k + 1], to[t + 1]) - std::max(from[k], to[t]);
      if (length > 0.)
        all[t].push_back({static_cast<unsigned int>(k), length / (to[t + 1] - to[t])});
    }
  }
  return all;
}
} // namespace

template <>
Pressure transfer_pressure(const PatchPressure<2> &from, const std::vector<Patch<2>> &to) {
  const std::vector<PatchGrid> given = patch_grids(from.patches);
  Pressure transferred(to.size());
  for (const PatchGrid &grid : patch_grids(to)) {
    const auto known = std::find_if(given.begin(), given.end(), [&](const PatchGrid &other) {
      return other.contact == grid.contact;
    });
    if (known == given.end())
      continue;
    const auto intervals = overlaps(known->ends[0], grid.ends[0]);
    for (unsigned int i = 0; i < grid.n(0); ++i)
      for (const Overlap &part : intervals[i])
        transferred[grid.patches[i]] += part.share * from.P[known->patches[part.number]];
  }
  return transferred;
}

namespace {
/** The identity of a face: that of its cell, and its number there. */
using FaceIdentity = std::pair<CellId, unsigned int>;

/** Returns the identity of the face of a patch, or of an ancestor of it. */
FaceIdentity ancestor_of(const Patch<3> &patch, const unsigned int n_generations) {
  return {Signorini::ancestor_of(patch.face.cell, n_generations), patch.face.face_no};
}

/** Returns the patches by the identities of their faces and of all ancestors of these. */
std::map<FaceIdentity, std::vector<unsigned int>> families(const std::vector<Patch<3>> &patches) {
  std::map<FaceIdentity, std::vector<unsigned int>> found;
  for (unsigned int t = 0; t < patches.size(); ++t)
    for (unsigned int g = 0; g <= patches[t].face.cell.get_child_indices().size(); ++g)
      found[ancestor_of(patches[t], g)].push_back(t);
  return found;
}
} // namespace

template <>
Pressure transfer_pressure(const PatchPressure<3> &from, const std::vector<Patch<3>> &to) {
  Pressure transferred(to.size());
  const auto descendants = families(from.patches);
  for (unsigned int t = 0; t < to.size(); ++t) {
    const auto n_before = static_cast<unsigned int>(to[t].face.cell.get_child_indices().size());
    for (unsigned int g = 0; g <= n_before; ++g) {
      const auto known = descendants.find(ancestor_of(to[t], g));
      // Of an ancestor only the patch itself counts, not its whole family.
      if (known == descendants.end() ||
          (g > 0 && from.patches[known->second.front()].face.cell != known->first.first))
        continue;
      double force = 0., area = 0.;
      for (const unsigned int k : known->second) {
        force += from.P[k] * from.patches[k].measure;
        area += from.patches[k].measure;
      }
      transferred[t] = force / area;
      break;
    }
  }
  return transferred;
}

Pressure transfer_pressure(const MultiplierSpace<2> &from, const Pressure &P,
                           const MultiplierSpace<2> &to, const Interval &allowed) {
  const std::vector<Patch<2>> &known = from.surface().patches();
  Pressure transferred(to.n_multipliers());
  std::size_t patch = 0;
  for (unsigned int k = 0; k < transferred.size(); ++k) {
    const unsigned int contact = to.surface().patches()[to.patch_of(k)].contact;
    const Point<1> s = to.node(k);
    // Patches and nodes are sorted by contact and arc length.
    while (patch + 1 < known.size() &&
           (known[patch].contact < contact ||
            (known[patch].contact == contact && known[patch].upper[0] < s[0])))
      ++patch;
    if (known[patch].contact == contact)
      transferred[k] = std::clamp(from.value(P, patch, s), allowed.lower, allowed.upper);
  }
  return transferred;
}

template <int dim>
Displacement carry_over(const DisplacementSpace<dim> &coarse, const Displacement &U,
                        const DisplacementSpace<dim> &fine) {
  const unsigned int level = coarse.mesh().level();
  if (fine.mesh().level() != level + 1)
    return {};
  // The vertices of a cell and the middles between them, lexicographically.
  const QIterated<dim> nodes(QTrapezoid<1>(), 2);
  PatchInterpolation<dim> interpolation(coarse, U, nodes, coarse.mesh().has_parents() ? 1 : 0);
  Displacement carried = fine.zero();
  for (const auto &parent : fine.dofs().cell_iterators_on_level(level)) {
    if (parent->is_active() || !parent->child(0)->is_locally_owned())
      continue;
    // A rank that owns the children has the parent on the coarse mesh, too.
    const auto of_coarse = coarse.mesh().cell_at(identity_of(*parent));
    const typename DoFHandler<dim>::active_cell_iterator cell(
      &coarse.mesh().triangulation(), of_coarse->level(), of_coarse->index(), &coarse.dofs());
    if (parent->vertex(0).distance(cell->vertex(0)) > 1e-10 * fine.mesh().size())
      return {};
    const std::vector<Tensor<1, dim>> &values = interpolation.on_reference_cell(cell).values;
    for (unsigned int c = 0; c < parent->n_children(); ++c)
      for (const unsigned int v : parent->vertex_indices()) {
        unsigned int node = 0;
        for (unsigned int d = dim; d > 0; --d)
          node = 3 * node + ((c >> (d - 1)) & 1U) + ((v >> (d - 1)) & 1U);
        for (unsigned int d = 0; d < dim; ++d)
          carried[parent->child(c)->vertex_dof_index(v, d)] = values[node][d];
      }
  }
  carried.update_ghost_values();
  return carried;
}

INSTANTIATE_FUNCTION(carry_over);
} // namespace Signorini
