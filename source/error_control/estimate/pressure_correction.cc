// SPDX-License-Identifier: LGPL-2.1-or-later
// The displacement z_h that belongs to a better pressure than p_H.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/paired_piece.h>
#include <signorini/error_control/estimate/pressure_correction.h>
#include <signorini/postprocessing/fields/contact_load.h>
#include <signorini/postprocessing/fields/pressure_transfer.h>
#include <signorini/postprocessing/fields/recovered_pressure.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/methods/contact_method.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

namespace Signorini {
namespace {
/** The number of faces per patch of the partition that pressures are recovered from. */
constexpr unsigned int recovery_ratio = 2;

bool presses_nowhere(const dealii::Vector<double> &P) {
  return std::none_of(P.begin(), P.end(), [](const double p) { return p < 0.; });
}

/** Returns P of the dual problem on another partition; none where a patch contains no free node, or
 * where the solver fails. */
template <int dim>
std::optional<dealii::Vector<double>> solve_on(const MultiplierSpace<dim> &multipliers,
                                               const Solved<dim> &solved, const DualData &dual,
                                               const LevelOperators<dim> &operators) {
  const Discretization<dim> &given = solved.discretization;
  const Coupling D = assemble_coupling(given.space, multipliers);
  const Coupling condensed_D = condense(D, given.space.constraints());
  if (condensed_D.empty_column(given.space.mesh().communicator()))
    return {};
  FreeState free;
  free.F = assemble_gap(multipliers, multipliers.surface().scene().contacts, given.n_points);
  free.F -= D.transpose_product(dual.free.U);
  if (free.nothing_touches(AdmissibleSet::nonpositive(free.F.size())))
    return dealii::Vector<double>(multipliers.n_multipliers());
  return solve_on_other_patches(operators, dual.motions, solved.contact.q, {D, condensed_D}, free.F,
                                transfer_pressure<dim>({given.surface.patches(), solved.P.normal()},
                                                       multipliers.surface().patches()));
}

/** The recovered p or q, shifted on every patch so that its mean is that of p_H or q_H; p is cut
 * off at zero. R^H p - p_H converges faster than p - p_H, see (25). The means of a line through the
 * middles of patches do not, and whole patches act on the body far more than variations on them.
 */
template <int dim>
class ShiftedPressure {
public:
  ShiftedPressure(const MultiplierSpace<dim> &multipliers, const Pressure &P,
                  const Component component = Component::normal)
    : recovered_(multipliers, P)
    , most_(component == Component::normal ? 0. : std::numeric_limits<double>::infinity())
    , shifts_(P) {
    dealii::Vector<double> integrals(P.size()), lengths(P.size());
    for (const Piece<dim> &piece : multipliers.surface().pieces())
      for (std::size_t q = 0; q < piece.on_mesh.size(); ++q) {
        const double weight = piece.on_mesh.weights[q];
        lengths[piece.patch] += weight;
        integrals[piece.patch] +=
          std::min(most_, recovered_.without_sign(piece.patch, piece.on_mesh.on_side[q])) * weight;
      }
    const MPI_Comm communicator = multipliers.surface().communicator();
    Utilities::MPI::sum(lengths, communicator, lengths);
    Utilities::MPI::sum(integrals, communicator, integrals);
    for (unsigned int k = 0; k < P.size(); ++k)
      shifts_[k] -= integrals[k] / lengths[k];
  }
  /** Returns the values at the points of a rule. */
  std::vector<double> operator()(const Piece<dim> &piece, const SurfaceRule<dim> &rule) const {
    std::vector<double> p;
    for (const Point<dim - 1> &s : rule.on_side)
      p.push_back(std::min(most_, std::min(most_, recovered_.without_sign(piece.patch, s)) +
                                    shifts_[piece.patch]));
    return p;
  }

private:
  RecoveredPressure<dim> recovered_;
  /** Zero for p, infinity for q. */
  double most_;
  dealii::Vector<double> shifts_;
};

/** The recovered q by components. It is cut off at the bound of friction that belongs to the
 * recovered p; where a patch slips, it is as long as that. */
template <int dim>
class RecoveredTangential {
public:
  explicit RecoveredTangential(const BodyInContact<dim> &body)
    : body_(body)
    , pressure_(body.multipliers, body.P.normal()) {
    for (const Pressure &part : body.P.tangential()) {
      components_.emplace_back(body.multipliers, part, Component::tangential);
      largest_ = std::max(largest_, 2. * part.linfty_norm());
    }
  }
  /** Returns component c of q at the points of a rule. */
  std::vector<double> operator()(const unsigned int c, const Piece<dim> &piece,
                                 const SurfaceRule<dim> &rule) const {
    const ContactPair<dim> pair = PairedPiece<dim>(body_.surface(), piece).pair();
    const bool slips = body_.P.state(piece.patch).slip != State::inside;
    const std::vector<double> p = pressure_(piece, rule);
    std::vector<std::vector<double>> q;
    for (const ShiftedPressure<dim> &component : components_)
      q.push_back(component(piece, rule));
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double given = pair.bound(rule.points[i], p[i]),
                   bound = body_.P.is_coupled() ? std::min(largest_, given) : given;
      double square = 0.;
      for (const std::vector<double> &component : q)
        square += component[i] * component[i];
      const double length = std::sqrt(square);
      if (length > 0. && (slips || length > bound))
        q[c][i] *= bound / length;
    }
    return q[c];
  }

private:
  const BodyInContact<dim> &body_;
  ShiftedPressure<dim> pressure_;
  std::vector<ShiftedPressure<dim>> components_;
  /** A large coefficient must not multiply the part of the recovered p beyond its mean. */
  double largest_ = 0.;
};

const auto rule_on_mesh = [](const auto &piece) -> const auto & {
  return piece.on_mesh;
};

/** Adds the load of the recovered q. */
template <int dim>
void add_tangential_load(const BodyInContact<dim> &body, Coupling::Column &load) {
  const RecoveredTangential<dim> q(body);
  for (unsigned int c = 0; c < tangents<dim>().size(); ++c) {
    const auto values_on = [&](const Piece<dim> &piece, const SurfaceRule<dim> &rule) {
      return q(c, piece, rule);
    };
    for (const auto &[row, value] :
         contact_load(body.space, body.surface(), rule_on_mesh, values_on, tangents<dim>()[c]))
      load[row] += value;
  }
}

/** Returns z_h for a load. */
template <int dim>
PressureCorrection correct_by(const Coupling &load, const Solved<dim> &solved,
                              const StiffnessInverse &inverse) {
  const DisplacementSpace<dim> &space = solved.space;
  dealii::Vector<double> minus_P(solved.P.values());
  minus_P *= -1.;
  DualVector forces = space.make_vector();
  load.add_product(dealii::Vector<double>{1.}, forces);
  solved.discretization.condensed_D.add_product(minus_P, forces);
  PressureCorrection correction;
  correction.z = solve_homogeneous(inverse, space, forces);
  // b.z = a(z, z): z is in V^h with homogeneous conditions.
  const double work = forces * correction.z;
  correction.energy_norm = std::sqrt(std::max(0., work));
  return correction;
}

/** Returns the load of the recovered pressure. */
template <int dim>
Coupling::Column pressure_load(const DisplacementSpace<dim> &space,
                               const MultiplierSpace<dim> &multipliers, const Pressure &P) {
  const ShiftedPressure<dim> pressure(multipliers, P);
  return contact_load(space, multipliers.surface(), rule_on_mesh, pressure);
}
} // namespace

template <int dim>
Coupling recovered_load(const DisplacementSpace<dim> &space,
                        const MultiplierSpace<dim> &multipliers, const Pressure &P) {
  return condense(sum_columns(space, {pressure_load(space, multipliers, P)}), space.constraints());
}

template <int dim>
PressureCorrection correct_pressure(const Solved<dim> &solved,
                                    const LevelOperators<dim> &operators) {
  const auto &[space, multipliers] = std::tie(solved.space, solved.multipliers);
  const Pressure &given = solved.P.normal();
  const bool has_tangential_part = solved.P.has_tangential_part();
  if (solved.surface().has_unstable_patch() || (!has_tangential_part && presses_nowhere(given)))
    return {};
  Coupling::Column load = pressure_load(space, multipliers, given);
  if (has_tangential_part)
    add_tangential_load(solved, load);
  return correct_by(condense(sum_columns(space, {load}), space.constraints()), solved,
                    *operators.inverse);
}

template <int dim>
PressureCorrection correct_by_finer_patches(const Solved<dim> &solved,
                                            const LevelOperators<dim> &operators) {
  const ContactSurface<dim> &surface = solved.surface();
  const DualData *const dual = solved.contact.dual();
  if (dual != nullptr && !solved.P.has_tangential_part() && !surface.has_unstable_patch()) {
    const ContactSurface<dim> finer(solved.space.mesh(), solved.scene, Partition{recovery_ratio});
    const MultiplierSpace<dim> finer_multipliers(finer);
    if (finer.patches().size() > surface.patches().size())
      if (const auto P = solve_on(finer_multipliers, solved, *dual, operators))
        return presses_nowhere(solved.P.normal()) && presses_nowhere(*P)
                 ? PressureCorrection()
                 : correct_by(recovered_load(solved.space, finer_multipliers, Pressure(*P)), solved,
                              *operators.inverse);
  }
  return correct_pressure(solved, operators);
}

INSTANTIATE_FUNCTION(recovered_load);
INSTANTIATE_FUNCTION(correct_pressure);
INSTANTIATE_FUNCTION(correct_by_finer_patches);
} // namespace Signorini
