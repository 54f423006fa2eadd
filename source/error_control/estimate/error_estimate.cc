// SPDX-License-Identifier: LGPL-2.1-or-later
// The displacement z_h that belongs to a better pressure than p_H.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/elasticity/body_measure.h>
#include <signorini/discretization/elasticity/cell_values.h>
#include <signorini/discretization/elasticity/internal_forces.h>
#include <signorini/discretization/elasticity/trace_values.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/postprocessing/fields/contact_load.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/postprocessing/fields/pressure_transfer.h>
#include <signorini/postprocessing/fields/recovered_pressure.h>
#include <signorini/solvers/contact/compliance.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
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
                                               const Discretization<dim> &given,
                                               const ContactSolution<dim> &contact) {
  const Coupling D = assemble_coupling(given.space, multipliers);
  const Coupling condensed_D = condense(D, given.space.constraints());
  for (unsigned int k = 0; k < condensed_D.n_columns(); ++k)
    if (condensed_D.column(k).empty())
      return {};
  FreeState free;
  free.F = assemble_gap(multipliers, multipliers.surface().scene().boundary, given.n_points);
  free.F -= D.transpose_product(contact.dual->free.U);
  if (free.nothing_touches(AdmissibleSet::nonpositive(free.F.size())))
    return dealii::Vector<double>(multipliers.n_multipliers());
  return solve_on_other_patches(
    contact, {D, condensed_D}, free.F,
    transfer_pressure<dim>({given.surface.patches(), contact.P.normal()},
                           multipliers.surface().patches()));
}

/** The recovered p or q, shifted on every patch so that its mean is that of p_H or q_H; p is cut
 * off at zero. R^H p - p_H converges faster than p - p_H, see (25). The means of a line through the
 * middles of patches do not, and whole patches act on the body far more than what varies on them.
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

/** The recovered q by components. It is cut off at s, or at f times the recovered |p|; where a
 * patch slips, it is as long as that. */
template <int dim>
class RecoveredFriction {
public:
  RecoveredFriction(const MultiplierSpace<dim> &space, const Scene<dim> &scene,
                    const Multiplier &multiplier)
    : space_(space)
    , scene_(scene)
    , multiplier_(multiplier)
    , pressure_(space, multiplier.normal()) {
    for (const Pressure &part : multiplier.tangential()) {
      components_.emplace_back(space, part, Component::tangential);
      largest_ = std::max(largest_, 2. * part.linfty_norm());
    }
  }
  /** Returns component c of q at the points of a rule. */
  std::vector<double> operator()(const unsigned int c, const Piece<dim> &piece,
                                 const SurfaceRule<dim> &rule) const {
    const auto &given = *scene_.boundary[space_.surface().faces()[piece.face].side].friction;
    const bool slips = multiplier_.state(piece.patch).slip != State::inside;
    const std::vector<double> p = pressure_(piece, rule);
    std::vector<std::vector<double>> q;
    for (const ShiftedPressure<dim> &component : components_)
      q.push_back(component(piece, rule));
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double given_here = given.value(rule.points[i]);
      const double bound =
        multiplier_.is_coupled() ? std::min(largest_, given_here * std::abs(p[i])) : given_here;
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
  const MultiplierSpace<dim> &space_;
  const Scene<dim> &scene_;
  const Multiplier &multiplier_;
  ShiftedPressure<dim> pressure_;
  std::vector<ShiftedPressure<dim>> components_;
  /** A large coefficient must not multiply what the recovered p has beyond its mean. */
  double largest_ = 0.;
};

const auto rule_on_mesh = [](const auto &piece) -> const auto & {
  return piece.on_mesh;
};

/** Adds the load of the recovered q. */
template <int dim>
void add_friction_load(const Discretization<dim> &discretization, const Scene<dim> &scene,
                       const Multiplier &multiplier, Coupling::Column &load) {
  const RecoveredFriction<dim> friction(discretization.multipliers, scene, multiplier);
  for (unsigned int c = 0; c < tangents<dim>().size(); ++c) {
    const auto values_on = [&](const Piece<dim> &piece, const SurfaceRule<dim> &rule) {
      return friction(c, piece, rule);
    };
    for (const auto &[row, value] : contact_load(discretization.space, discretization.surface,
                                                 rule_on_mesh, values_on, tangents<dim>()[c]))
      load[row] += value;
  }
}

/** Returns z_h for a load. */
template <int dim>
PressureCorrection correct_by(const Coupling &load, const Discretization<dim> &discretization,
                              const ContactSolution<dim> &contact) {
  const DisplacementSpace<dim> &space = discretization.space;
  dealii::Vector<double> minus_P(contact.P.values());
  minus_P *= -1.;
  DualVector forces = space.make_vector();
  load.add_product(dealii::Vector<double>{1.}, forces);
  discretization.condensed_D.add_product(minus_P, forces);
  PressureCorrection correction;
  correction.z = solve_homogeneous(*contact.inverse, space, forces);
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
  return condense(Coupling({pressure_load(space, multipliers, P)}), space.constraints());
}

template <int dim>
PressureCorrection correct_pressure(const Discretization<dim> &discretization,
                                    const Scene<dim> &scene, const ContactSolution<dim> &contact) {
  const auto &[space, surface, multipliers] =
    std::tie(discretization.space, discretization.surface, discretization.multipliers);
  const Pressure &given = contact.P.normal();
  if (surface.has_unstable_patch())
    return {};
  if (contact.P.has_friction()) {
    Coupling::Column load = pressure_load(space, multipliers, given);
    add_friction_load(discretization, scene, contact.P, load);
    return correct_by<dim>(condense(Coupling({load}), space.constraints()), discretization,
                           contact);
  }
  if (contact.dual) {
    const ContactSurface<dim> finer(space.mesh(), scene, Partition{recovery_ratio, 0});
    const MultiplierSpace<dim> finer_multipliers(finer);
    if (finer.patches().size() > surface.patches().size())
      if (const auto P = solve_on(finer_multipliers, discretization, contact))
        return presses_nowhere(given) && presses_nowhere(*P)
                 ? PressureCorrection()
                 : correct_by<dim>(recovered_load(space, finer_multipliers, Pressure(*P)),
                                   discretization, contact);
  }
  return presses_nowhere(given)
           ? PressureCorrection()
           : correct_by<dim>(recovered_load(space, multipliers, given), discretization, contact);
}

INSTANTIATE_FUNCTION(recovered_load);
INSTANTIATE_FUNCTION(correct_pressure);

// Distances between interpolations of the nodal values; (24) and (31) make the first an estimate of
// the error of the mesh.

namespace {
/** The squares of norms of v - w, of a cell or of the body: of the values, the gradients, and the
 * energy. */
using Squares = Tensor<1, 3>;

/** Integrates v - w, where v is the patch interpolation over @p fine generations and w that over
 * one less. Every chunk of cells has its own object. */
template <int dim>
class Distance {
public:
  using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

  // Products of functions of degree two or four per direction: three or five points are exact on
  // parallelograms.
  Distance(const DisplacementSpace<dim> &space, const Material<dim> *const material,
           const Displacement &U, const unsigned int fine)
    : U_(U)
    , values_(space.mesh().mapping(), space.element(),
              QGauss<dim>((space.element().degree << fine) + 1),
              update_values | update_gradients | update_inverse_jacobians | update_JxW_values |
                update_quadrature_points)
    , v_(space, values_.get_quadrature(), fine)
    , w_(space, values_.get_quadrature(), fine - 1) {
    if (material != nullptr)
      energy_.emplace(*material);
  }
  Squares integrate(const CellIterator &cell) {
    values_.reinit(cell);
    const FieldValues<dim> &v = v_.evaluate(U_, cell, values_);
    const FieldValues<dim> &w = w_.evaluate(U_, cell, values_);
    Squares sum;
    for (const unsigned int q : values_.quadrature_point_indices()) {
      const Tensor<2, dim> gradient = v.gradients[q] - w.gradients[q];
      const double energy =
        energy_ ? energy_->at(values_.quadrature_point(q)).density(strain_of(gradient)) : 0.;
      sum += measure_at(values_, q) *
             Squares({(v.values[q] - w.values[q]).norm_square(), gradient.norm_square(), energy});
    }
    return sum;
  }

private:
  /** Empty if energies are not wanted. */
  std::optional<EnergyMeasure<dim>> energy_;
  const Displacement &U_;
  FEValues<dim> values_;
  PatchInterpolation<dim> v_, w_;
};

/** Returns the sums over all ranks; the parts of the threads are added up in the order of cells. */
template <int dim>
Squares integrate(const DisplacementSpace<dim> &space, const Material<dim> *const material,
                  const Displacement &U, const unsigned int fine) {
  Squares sum;
  integrate_by_chunks<Squares, dim>(
    space,
    [&](const Cells<dim> &cells) {
      Distance<dim> distance(space, material, U, fine);
      Squares chunk_result;
      for (const auto &cell : cells)
        chunk_result += distance.integrate(cell);
      return chunk_result;
    },
    [&sum](const Squares &chunk_result) { sum += chunk_result; });
  return Utilities::MPI::sum(sum, space.mesh().communicator());
}

/** Returns ‖.‖_1 with lengths in the given unit, up to that unit's own power. */
double norm_1(const Squares &squares, const double unit_of_length) {
  return std::sqrt(squares[0] / (unit_of_length * unit_of_length) + squares[1]);
}
} // namespace

template <int dim>
ErrorEstimate estimate_error(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                             const Displacement &U, const EnergyScale &scale,
                             const PressureCorrection &correction, const OtherErrors &others) {
  const Material<dim> *const material = scene.material.get();
  const Squares u_h_squares = integrate(space, material, U, 1);
  double mesh_square = u_h_squares[2];
  if (correction.z.size() > 0) {
    Displacement corrected(U);
    corrected += correction.z;
    mesh_square = integrate(space, material, corrected, 1)[2];
  }
  ErrorEstimate estimate;
  estimate.h1 = norm_1(u_h_squares, 1.);
  estimate.mesh = std::sqrt(mesh_square);
  estimate.pressure = correction.energy_norm;
  estimate.algebra = others.algebra;
  estimate.contact = others.contact;
  estimate.energy = std::hypot(std::sqrt(mesh_square), correction.energy_norm);
  estimate.energy = std::hypot(estimate.energy, others.algebra, others.contact);
  if (estimate.energy > 0.)
    estimate.relative = estimate.energy / scale.of(estimate.energy);
  return estimate;
}

template <int dim>
unsigned int best_interpolation(const DisplacementSpace<dim> &space, const Displacement &U) {
  if (space.mesh().n_nested_ancestors() < 2)
    return space.mesh().n_nested_ancestors();
  const auto change = [&](const unsigned int fine) {
    return norm_1(integrate<dim>(space, nullptr, U, fine), space.mesh().size());
  };
  return change(2) < 2. / 3. * change(1) ? 2 : 1;
}

Columns<ErrorEstimate> ErrorEstimate::columns() {
  return {{"estimated_h1", &ErrorEstimate::h1},
          {"estimated_energy", &ErrorEstimate::energy},
          {"estimated_relative", &ErrorEstimate::relative},
          {"estimated_mesh", &ErrorEstimate::mesh},
          {"estimated_pressure", &ErrorEstimate::pressure},
          {"estimated_algebra", &ErrorEstimate::algebra},
          {"estimated_contact", &ErrorEstimate::contact}};
}

INSTANTIATE_FUNCTION(estimate_error);
INSTANTIATE_FUNCTION(best_interpolation);

// Penetration where nothing presses.

namespace {
/** Returns whether the closures of two patches meet. */
bool touch(const Patch<3> &a, const Patch<3> &b) {
  const double tolerance = 1e-6 * a.diameter();
  if (a.side != b.side)
    return false;
  for (unsigned int d = 0; d < 2; ++d)
    if (a.lower[d] > b.upper[d] + tolerance || b.lower[d] > a.upper[d] + tolerance)
      return false;
  return true;
}

/** Returns whether a patch presses or touches one that does. */
bool is_near_contact(const MultiplierSpace<3> &multipliers, const Pressure &P,
                     const Patch<3> &patch) {
  const double threshold = pressing_threshold(P);
  for (unsigned int k = 0; k < P.size(); ++k)
    if (P[k] < threshold && touch(multipliers.surface().patches()[multipliers.patch_of(k)], patch))
      return true;
  return false;
}

/** Returns the modulus of the softer one of pressing and shearing. */
double modulus_at(const Scene<3> &scene, const Point<3> &x) {
  const SymmetricTensor<4, 3> E = scene.material->hooke(x);
  return std::min(std::max({E[0][0][0][0], E[1][1][1][1], E[2][2][2][2]}),
                  4. * std::max({E[0][1][0][1], E[0][2][0][2], E[1][2][1][2]}));
}
} // namespace

double energy_of_missed_contact(const DisplacementSpace<3> &space,
                                const MultiplierSpace<3> &multipliers, const Scene<3> &scene,
                                const Displacement &U, const Pressure &P) {
  const ContactSurface<3> &surface = multipliers.surface();
  // Coarse meshes, which miss contact, are sampled densely.
  const double per_piece = 20000. / std::max<std::size_t>(1, surface.pieces().size());
  const auto n_points = static_cast<unsigned int>(std::clamp(std::sqrt(per_piece), 3., 32.));
  TraceValues<3> traces(space);
  std::vector<double> on_patch(surface.patches().size(), 0.);
  for (const Piece<3> &piece : surface.pieces()) {
    const SurfaceRule<3> rule = surface.rule(piece, n_points);
    const std::vector<double> depths = penetration(surface, piece, rule, U, traces);
    double square = 0.;
    for (std::size_t q = 0; q < rule.size(); ++q)
      square += std::pow(std::max(0., depths[q]), 2) * rule.weights[q];
    if (square > 0.)
      on_patch[piece.patch] += modulus_at(scene, rule.points[0]) * square;
  }
  double energy = 0.;
  for (std::size_t k = 0; k < on_patch.size(); ++k)
    if (const Patch<3> &patch = surface.patches()[k];
        on_patch[k] > 0. && !is_near_contact(multipliers, P, patch))
      energy += 0.5 * numbers::PI / std::sqrt(patch.measure) * on_patch[k];
  return std::sqrt(energy);
}
} // namespace Signorini
