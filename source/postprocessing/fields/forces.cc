// SPDX-License-Identifier: LGPL-2.1-or-later
// The ends of contact between the nodes of multipliers.

#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/postprocessing/fields/forces.h>

#include <algorithm>

namespace Signorini
{
namespace
{
/** Returns the nodes around a closed side, the first one again at the end; they begin where two
 * neighbours are of the same kind, if there are such. */
std::vector<SideNode> once_around(const SideNodes &side)
{
  const std::size_t n = side.nodes.size();
  std::size_t first = 0;
  while (first + 1 < n && side.nodes[first].presses != side.nodes[(first + n - 1) % n].presses)
    ++first;
  std::vector<SideNode> nodes;
  for (std::size_t i = first; i <= first + n; ++i)
    nodes.push_back({side.nodes[i % n].s + (i < n ? 0. : side.length), side.nodes[i % n].presses});
  return nodes;
}

/** An end of contact, and whether contact begins or ends there. */
struct Change
{
  PressedInterval::End end;
  bool begins;
};

/** Returns the change between nodes i and j, the second of which presses if contact begins. */
Change between(const std::vector<SideNode> &nodes, const std::size_t i, const std::size_t j)
{
  return {{0.5 * (nodes[i].s + nodes[j].s), 0.5 * (nodes[j].s - nodes[i].s)}, nodes[j].presses};
}

std::vector<Change> find_changes(const std::vector<SideNode> &nodes)
{
  std::vector<Change> changes;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
  {
    const std::size_t first = i;
    while (i + 1 < nodes.size() && nodes[i].presses != nodes[i + 1].presses)
      ++i;
    if (i == first)
      continue;
    // From here on nodes i and i + 1 are of the same kind.
    if (nodes[first].presses != nodes[i].presses)
      changes.push_back(between(nodes, first, i));
    else
    {
      changes.push_back(between(nodes, first, first + 1));
      changes.push_back(between(nodes, i - 1, i));
    }
  }
  return changes;
}

std::vector<PressedInterval> intervals_of(const SideNodes &side)
{
  const auto presses = [](const SideNode &node) { return node.presses; };
  if (std::none_of(side.nodes.begin(), side.nodes.end(), presses))
    return {};
  if (std::all_of(side.nodes.begin(), side.nodes.end(), presses))
    return {{side.number, {0., 0.}, {side.length, 0.}}};
  std::vector<Change> changes = find_changes(side.closed ? once_around(side) : side.nodes);
  if (side.closed && !changes.front().begins)
  {
    // The interval that contains the first node.
    Change last = changes.front();
    last.end.s += side.length;
    changes.erase(changes.begin());
    changes.push_back(last);
  }
  if (!side.closed && side.nodes.front().presses)
    changes.insert(changes.begin(), {{0., 0.}, true});
  if (!side.closed && side.nodes.back().presses)
    changes.push_back({{side.length, 0.}, false});
  std::vector<PressedInterval> intervals;
  for (std::size_t i = 0; i + 1 < changes.size(); i += 2)
  {
    const double turn = changes[i].end.s < side.length ? 0. : side.length;
    intervals.push_back({side.number, changes[i].end, changes[i + 1].end});
    intervals.back().start.s -= turn;
    intervals.back().end.s -= turn;
  }
  std::sort(intervals.begin(), intervals.end(), [](const auto &a, const auto &b) {
    return a.start.s < b.start.s;
  });
  return intervals;
}
} // namespace

std::vector<PressedInterval> pressed_intervals(const MultiplierSpace<2> &multipliers,
                                               const Pressure &P)
{
  std::vector<PressedInterval> intervals;
  for (const SideNodes &side : nodes_by_side(multipliers, P))
  {
    const std::vector<PressedInterval> side_data = intervals_of(side);
    intervals.insert(intervals.end(), side_data.begin(), side_data.end());
  }
  return intervals;
}

// p_H: resultants, recovery, transfer between partitions.

double pressing_threshold(const Pressure &P)
{
  return P.size() == 0 ? 0. : -1e-12 * P.linfty_norm();
}

template <int dim>
ContactSummary summarise_contact(const MultiplierSpace<dim> &space, const Pressure &P)
{
  ContactSummary summary;
  const double threshold = pressing_threshold(P);
  const dealii::Vector<double> integrals = space.integrals();
  for (unsigned int k = 0; k < P.size(); ++k)
  {
    summary.normal_force -= P[k] * integrals[k];
    summary.max_pressure = std::max(summary.max_pressure, -P[k]);
    if (!(P[k] < threshold))
      continue;
    ++summary.active;
    if (space.is_piecewise_constant())
      summary.length += integrals[k];
  }
  if constexpr (dim == 2)
    if (!space.is_piecewise_constant())
      for (const PressedInterval &interval : pressed_intervals(space, P))
        summary.length += interval.length();
  return summary;
}

template <>
RecoveredPressure<2>::RecoveredPressure(const MultiplierSpace<2> &space, const Pressure &P)
  : space_(space)
  , surface_(space.surface())
  , P_(P)
{
  for (unsigned int tau = 0; tau < surface_.patches().size(); ++tau)
    means_.push_back(space.value(P, tau, surface_.patches()[tau].centre()));
}

template <>
RecoveredPressure<2>::Neighbour RecoveredPressure<2>::neighbour(const unsigned int patch,
                                                                const int step) const
{
  const std::vector<Patch<2>> &patches = surface_.patches();
  const auto on_side = [&](const int t) {
    return t >= 0 && t < static_cast<int>(patches.size()) && patches[t].side == patches[patch].side;
  };
  int next = static_cast<int>(patch) + step;
  const Side<2> &side = surface_.side(patches[patch]);
  // Beyond a corner, the pressure is that of another direction.
  const bool has_corner =
    side.has_corner(step > 0 ? patches[patch].upper[0] : patches[patch].lower[0]);
  if (on_side(next) && !has_corner)
    return {static_cast<unsigned int>(next), patches[next].centre()[0]};
  if (!side.is_closed() || has_corner)
    return {patch, patches[patch].centre()[0]};
  // Around a closed side, this is the patch at the other end of the list.
  for (next = static_cast<int>(patch); on_side(next - step);)
    next -= step;
  return {static_cast<unsigned int>(next), patches[next].centre()[0] + step * side.length()};
}

template <>
double RecoveredPressure<2>::operator()(const unsigned int patch, const Point<1> &s) const
{
  if (!space_.is_piecewise_constant())
    return std::min(0., space_.value(P_, patch, s));
  const double middle = surface_.patches()[patch].centre()[0];
  const int step = s[0] < middle ? -1 : 1;
  Neighbour next = neighbour(patch, step);
  if (next.patch == patch)
    next = neighbour(patch, -step);
  if (next.patch == patch)
    return means_[patch];
  const double slope = (means_[next.patch] - means_[patch]) / (next.middle - middle);
  return std::min(0., means_[patch] + slope * (s[0] - middle));
}

template <>
Pressure transfer_pressure(const PatchPressure<2> &from, const std::vector<Patch<2>> &to)
{
  const std::vector<Patch<2>> &patches = from.patches;
  Pressure transferred(to.size());
  std::size_t first = 0;
  for (std::size_t t = 0; t < to.size(); ++t)
  {
    const double start = to[t].lower[0], end = to[t].upper[0];
    const auto before = [&](const Patch<2> &patch) {
      return patch.side < to[t].side || (patch.side == to[t].side && patch.upper[0] <= start);
    };
    while (first < patches.size() && before(patches[first]))
      ++first;
    for (std::size_t k = first;
         k < patches.size() && patches[k].side == to[t].side && patches[k].lower[0] < end;
         ++k)
    {
      const double overlap =
        std::min(patches[k].upper[0], end) - std::max(patches[k].lower[0], start);
      transferred[t] += std::max(overlap, 0.) / to[t].measure * from.P[k];
    }
  }
  return transferred;
}

Columns<ContactSummary> ContactSummary::columns()
{
  return {{"active", &ContactSummary::active},
          {"contact_force_n", &ContactSummary::normal_force},
          {"max_pressure", &ContactSummary::max_pressure},
          {"contact_length", &ContactSummary::length}};
}

template ContactSummary summarise_contact(const MultiplierSpace<2> &, const Pressure &);
template ContactSummary summarise_contact(const MultiplierSpace<3> &, const Pressure &);

// p_H on rectangles: bilinear recovery, transfer between partitions.

namespace
{
/** A position between the centres of two intervals: the numbers of both, and the share of the
 * second. The share is negative beyond the first one. */
struct BetweenCentres
{
  unsigned int first, second;
  double share;
};

/** Returns the position of a point between the centre of interval @p i and that of the next one on
 * its side. */
BetweenCentres
between_centres(const PatchGrid &grid, const unsigned int d, const unsigned int i, const double s)
{
  const unsigned int n = grid.n(d);
  if (n == 1)
    return {i, i, 0.};
  const double middle = grid.middle(d, i);
  const bool before = i + 1 == n || (i > 0 && s < middle);
  const unsigned int next = before ? i - 1 : i + 1;
  return {i, next, (s - middle) / (grid.middle(d, next) - middle)};
}

/** The part of an interval that another one covers. */
struct Overlap
{
  unsigned int number;
  double share;
};

/** Returns for every interval between @p to its overlaps with those between @p from. */
std::vector<std::vector<Overlap>> overlaps(const std::vector<double> &from,
                                           const std::vector<double> &to)
{
  std::vector<std::vector<Overlap>> all(to.size() - 1);
  std::size_t first = 0;
  for (std::size_t t = 0; t + 1 < to.size(); ++t)
  {
    while (first + 2 < from.size() && from[first + 1] <= to[t])
      ++first;
    for (std::size_t k = first; k + 1 < from.size() && from[k] < to[t + 1]; ++k)
    {
      const double length = std::min(from[k + 1], to[t + 1]) - std::max(from[k], to[t]);
      if (length > 0.)
        all[t].push_back({static_cast<unsigned int>(k), length / (to[t + 1] - to[t])});
    }
  }
  return all;
}
} // namespace

template <>
RecoveredPressure<3>::RecoveredPressure(const MultiplierSpace<3> &space, const Pressure &P)
  : space_(space)
  , surface_(space.surface())
  , P_(P)
  , grids_(patch_grids(space.surface().patches()))
  , places_(space.surface().patches().size())
{
  for (unsigned int tau = 0; tau < surface_.patches().size(); ++tau)
    means_.push_back(space.value(P, tau, surface_.patches()[tau].centre()));
  for (unsigned int g = 0; g < grids_.size(); ++g)
    for (unsigned int j = 0; j < grids_[g].n(1); ++j)
      for (unsigned int i = 0; i < grids_[g].n(0); ++i)
        places_[grids_[g].at(i, j)] = {g, {{i, j}}};
}

template <>
double RecoveredPressure<3>::operator()(const unsigned int patch, const Point<2> &s) const
{
  const Place &place = places_[patch];
  const PatchGrid &grid = grids_[place.grid];
  const BetweenCentres x = between_centres(grid, 0, place.index[0], s[0]);
  const BetweenCentres y = between_centres(grid, 1, place.index[1], s[1]);
  const auto along_x = [&](const unsigned int row) {
    return (1. - x.share) * means_[grid.at(x.first, row)] +
           x.share * means_[grid.at(x.second, row)];
  };
  return std::min(0., (1. - y.share) * along_x(y.first) + y.share * along_x(y.second));
}

template <>
Pressure transfer_pressure(const PatchPressure<3> &from, const std::vector<Patch<3>> &to)
{
  const std::vector<PatchGrid> given = patch_grids(from.patches);
  Pressure transferred(to.size());
  for (const PatchGrid &grid : patch_grids(to))
  {
    const auto known = std::find_if(
      given.begin(), given.end(), [&](const PatchGrid &other) { return other.side == grid.side; });
    if (known == given.end())
      continue;
    const auto columns = overlaps(known->ends[0], grid.ends[0]);
    const auto rows = overlaps(known->ends[1], grid.ends[1]);
    for (unsigned int j = 0; j < grid.n(1); ++j)
      for (unsigned int i = 0; i < grid.n(0); ++i)
        for (const Overlap &row : rows[j])
          for (const Overlap &column : columns[i])
            transferred[grid.at(i, j)] +=
              row.share * column.share * from.P[known->at(column.number, row.number)];
  }
  return transferred;
}

// The nodes of multipliers that press.

std::vector<SideNodes> nodes_by_side(const MultiplierSpace<2> &multipliers, const Pressure &P)
{
  const ContactSurface<2> &surface = multipliers.surface();
  const double threshold = pressing_threshold(P);
  std::vector<SideNodes> sides;
  for (unsigned int k = 0; k < P.size(); ++k)
  {
    const Patch<2> &patch = surface.patches()[multipliers.patch_of(k)];
    if (sides.empty() || sides.back().number != patch.side)
    {
      const Side<2> &side = surface.side(patch);
      sides.push_back({patch.side, side.length(), side.is_closed(), {}});
    }
    sides.back().nodes.push_back({multipliers.node(k)[0], P[k] < threshold});
  }
  return sides;
}

// The balance of forces, node by node, and the resultants of the contact pressure.

double NodalForces::largest() const
{
  return std::max({internal.l2_norm(), loads.l2_norm(), contact.l2_norm()});
}

template <int dim>
NodalForces nodal_forces(const DisplacementSpace<dim> &space,
                         const Scene<dim> &scene,
                         const DistributedVector &loads,
                         const Coupling &D,
                         const Displacement &U,
                         const Pressure &P)
{
  NodalForces forces;
  const InternalForces<dim> internal = internal_forces(space, scene, U);
  forces.internal = space.dual(internal.forces);
  forces.loads = space.dual(loads);
  DistributedVector contact = space.make_vector();
  D.add_product(P, contact);
  contact.compress(VectorOperation::add);
  forces.contact = space.dual(contact);
  forces.residual = forces.internal;
  forces.residual -= forces.loads;
  forces.residual -= forces.contact;
  space.carry_to_masters(forces.residual);
  forces.magnitude = internal.magnitudes.l2_norm();
  forces.rigid = norm_of_rigid_motion(space, scene, U);
  return forces;
}

template <int dim>
Resultant<dim> contact_resultant(const MultiplierSpace<dim> &multipliers,
                                 const Pressure &P,
                                 const Piece<dim> &piece)
{
  Resultant<dim> resultant;
  const SurfaceRule<dim> &rule = piece.on_mesh;
  for (std::size_t q = 0; q < rule.size(); ++q)
    resultant.add(multipliers.value(P, piece.patch, rule.on_side[q]) * rule.weights[q] *
                    rule.normals[q],
                  rule.points[q]);
  return resultant;
}

template NodalForces nodal_forces(const DisplacementSpace<2> &,
                                  const Scene<2> &,
                                  const DistributedVector &,
                                  const Coupling &,
                                  const Displacement &,
                                  const Pressure &);
template NodalForces nodal_forces(const DisplacementSpace<3> &,
                                  const Scene<3> &,
                                  const DistributedVector &,
                                  const Coupling &,
                                  const Displacement &,
                                  const Pressure &);
template Resultant<2> contact_resultant(const MultiplierSpace<2> &,
                                        const Pressure &,
                                        const Piece<2> &);
template Resultant<3> contact_resultant(const MultiplierSpace<3> &,
                                        const Pressure &,
                                        const Piece<3> &);

// The reactions of plates.

template <int dim>
std::vector<PlateForce> plate_forces(const DisplacementSpace<dim> &space,
                                     const Scene<dim> &scene,
                                     const NodalForces &forces)
{
  std::vector<PlateForce> result;
  for (std::size_t p = 0; p < scene.plates.size(); ++p)
  {
    const auto work_on = [&](const PlateMotion &motion) {
      std::vector<PlateMotion> motions(scene.plates.size());
      motions[p] = motion;
      return space.prescribed(with_only_plates_moved(scene, motions)) * forces.residual;
    };
    result.push_back({work_on({1., 0.}), work_on({0., 1.})});
  }
  return result;
}

template std::vector<PlateForce> plate_forces(const DisplacementSpace<2> &,
                                              const Scene<2> &,
                                              const NodalForces &);
template std::vector<PlateForce> plate_forces(const DisplacementSpace<3> &,
                                              const Scene<3> &,
                                              const NodalForces &);
} // namespace Signorini
