// SPDX-License-Identifier: LGPL-2.1-or-later
// Free motions on a level: Z = k - A⁻¹ A k for the lifts k of free motions, and their words for
// messages.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/discretization/space/nodes.h>
#include <signorini/problem/scene/functions.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/motion_modes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
/** Returns the nodal values of a rigid motion. */
template <int dim>
Displacement interpolate(const RigidMotion<dim> &motion, const DisplacementSpace<dim> &space) {
  std::vector<FieldFunction<dim>> velocities;
  for (const BodyMotion<dim> &body : motion.bodies)
    velocities.emplace_back([body](const Point<dim> &x) { return body.velocity(x); });
  return velocities.size() == 1 ? interpolate_at_nodes(space, velocities.front())
                                : interpolate_by_body(space, velocities);
}

/** Returns the values of the motion on plates, pins and other supports; zero elsewhere. */
template <int dim>
Displacement lift(const FreeMotion<dim> &motion, const DisplacementSpace<dim> &space,
                  const Scene<dim> &scene) {
  Displacement k = space.prescribed(with_only_plates_moved(scene, motion.plates));
  if (motion.rigid) {
    Displacement of_pins = space.zero();
    for (const auto &pin : space.pins())
      if (of_pins.in_local_range(pin.dof))
        of_pins(pin.dof) = motion.rigid->bodies[pin.body].velocity(pin.node)[pin.component];
    // Hanging nodes may follow a pin.
    space.distribute_without_pins(of_pins);
    k += of_pins;
  }
  k.update_ghost_values();
  return k;
}

/** Returns the forces of a mode; empty where all of them are rounding: V^h contains the rigid
 * motion. */
template <int dim>
DualVector forces_of_mode(const DisplacedBody<dim> &mode) {
  constexpr double rounding = 10. * std::numeric_limits<double>::epsilon();
  const Displacement &z = mode.U;
  const InternalForces<dim> internal = internal_forces(mode);
  DualVector sizes = internal.magnitudes;
  for (unsigned int i = 0; i < sizes.locally_owned_size(); ++i)
    sizes.local_element(i) *= z.local_element(i);
  return z * internal.forces <= rounding * sizes.l1_norm() ? DualVector() : internal.forces;
}

/** Returns b.c and the sum of the absolute values of its terms. */
std::array<double, 2> product_of(const DualVector &b, const DualVector &c) {
  DualVector terms(b);
  terms.scale(c);
  return {{b * c, terms.l1_norm()}};
}

/** Returns the work of the forces on plates and of the loads in a motion with nodal values z, and
 * the sum of the absolute values of its terms. */
template <int dim>
std::array<double, 2> work_in(const FreeMotion<dim> &motion, const Displacement &z,
                              const std::vector<Plate<dim>> &plates, const DualVector &loads) {
  const double by_plates = motion.work_of_plates(plates);
  const auto by_loads = product_of(z, loads);
  return {{by_plates + by_loads[0], std::abs(by_plates) + by_loads[1]}};
}

/** Returns k - A⁻¹ A k for the displacement k of a body. */
template <int dim>
Displacement extend(const DisplacedBody<dim> &body, const StiffnessInverse &inverse) {
  DualVector r = internal_forces(body).forces;
  r *= -1.;
  Displacement z = solve_homogeneous(inverse, body.space, body.space.condense(r));
  z += body.U;
  return z;
}

/** Returns the modes of plates, and of a body that only contact holds. */
template <int dim>
MotionModes<dim> modes_of(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                          const StiffnessInverse &inverse) {
  MotionModes<dim> modes;
  const FreeMotionBasis<dim> basis = free_motions(scene);
  modes.neutral = basis.neutral;
  for (const FreeMotion<dim> &motion : modes.neutral)
    modes.neutral_modes.push_back(interpolate(*motion.rigid, space));
  if (space.mesh().is_curved())
    modes.neutral_tolerance = 1e-3;
  const auto add_mode = [&](const FreeMotion<dim> &motion, const bool undetermined) {
    const bool strains =
      !motion.rigid || (space.mesh().is_curved() && !motion.rigid->is_translation());
    Displacement z = strains ? extend<dim>({space, scene, lift(motion, space, scene)}, inverse)
                             : interpolate(*motion.rigid, space);
    DualVector forces = strains ? forces_of_mode<dim>({space, scene, z}) : DualVector();
    if (undetermined && forces.size() == 0)
      return;
    modes.motions.push_back(motion);
    modes.Z.push_back(std::move(z));
    modes.forces.push_back(std::move(forces));
  };
  for (const FreeMotion<dim> &motion : basis.resisted)
    add_mode(motion, false);
  // Where V^h lacks a rotation, a pin would take a part of the loads.
  for (const FreeMotion<dim> &motion : modes.neutral)
    add_mode(motion, true);
  const unsigned int k = modes.size();
  modes.K.reinit(k, k);
  for (unsigned int i = 0; i < k; ++i)
    for (unsigned int j = i + 1; j-- > 0;)
      if (modes.forces[i].size() > 0 && modes.forces[j].size() > 0) {
        const double K_ij = 0.5 * (modes.Z[i] * modes.forces[j] + modes.Z[j] * modes.forces[i]);
        // Rounding must not make K indefinite.
        const double largest = std::sqrt(modes.K(i, i) * modes.K(j, j));
        modes.K(i, j) = modes.K(j, i) = i == j ? K_ij : std::clamp(K_ij, -largest, largest);
      }
  return modes;
}
} // namespace

template <int dim>
FullMatrix<double> MotionModes<dim>::couple(const Coupling &D) const {
  // The ends of a symmetric patch balance each other: rounding must not turn that into a closing.
  constexpr double rounding = 1e-13;
  FullMatrix<double> B(D.n_columns(), size());
  dealii::Vector<double> magnitude(B.m());
  for (unsigned int j = 0; j < size(); ++j) {
    const dealii::Vector<double> column = D.transpose_product(Z[j]);
    magnitude = 0.;
    for (unsigned int i = 0; i < column.size(); ++i)
      for (const auto &[row, entry] : D.column(i))
        magnitude[i] += std::abs(entry * Z[j](row));
    Utilities::MPI::sum(magnitude, Z[j].get_mpi_communicator(), magnitude);
    for (unsigned int i = 0; i < column.size(); ++i)
      B(i, j) = std::abs(column[i]) > rounding * magnitude[i] ? column[i] : 0.;
  }
  return B;
}

template <int dim>
MotionWork MotionModes<dim>::work(const std::vector<Plate<dim>> &plates, const DualVector &loads,
                                  const Displacement &U_0) const {
  // Loads in balance do no work, which rounding must not turn into a force.
  constexpr double rounding = 1e-13;
  MotionWork work = {dealii::Vector<double>(size()), dealii::Vector<double>(size())};
  for (unsigned int j = 0; j < size(); ++j) {
    const auto on_boundary = work_in(motions[j], Z[j], plates, loads);
    const auto by_U_0 = forces[j].size() > 0 ? product_of(forces[j], U_0) : std::array<double, 2>();
    work.value[j] = on_boundary[0] - by_U_0[0];
    work.magnitude[j] = on_boundary[1] + by_U_0[1];
    if (std::abs(work.value[j]) <= rounding * work.magnitude[j])
      work.value[j] = 0.;
  }
  return work;
}

template <int dim>
std::optional<unsigned int> MotionModes<dim>::driven_neutral(const std::vector<Plate<dim>> &plates,
                                                             const DualVector &loads) const {
  for (unsigned int j = 0; j < neutral.size(); ++j) {
    const auto [value, magnitude] = work_in(neutral[j], neutral_modes[j], plates, loads);
    if (std::abs(value) > neutral_tolerance * magnitude)
      return j;
  }
  return {};
}

template <int dim>
void MotionModes<dim>::add_to(Displacement &U, const dealii::Vector<double> &q) const {
  for (unsigned int j = 0; j < size(); ++j)
    U.add(q[j], Z[j]);
}

template <int dim>
double MotionModes<dim>::work_of_plates(const std::vector<Plate<dim>> &plates,
                                        const dealii::Vector<double> &q) const {
  double work = 0.;
  const std::vector<PlateMotion<dim>> moved = plate_motions(plates, q);
  for (std::size_t p = 0; p < plates.size(); ++p)
    work += plates[p].work(moved[p]);
  return work;
}

template <int dim>
std::vector<PlateMotion<dim>> MotionModes<dim>::plate_motions(
  const std::vector<Plate<dim>> &plates, const dealii::Vector<double> &q) const {
  std::vector<PlateMotion<dim>> sum =
    combine_plates(motions, std::vector<double>(q.begin(), q.end()), plates.size());
  for (std::size_t p = 0; p < plates.size(); ++p)
    sum[p].travel += plates[p].travel;
  return sum;
}

template <int dim>
MotionModes<dim> make_motion_modes(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                                   const StiffnessInverse &inverse) {
  return !scene.plates.empty() || scene.is_held_by_contact ? modes_of(space, scene, inverse)
                                                           : MotionModes<dim>();
}

template <int dim>
std::string text_of_escape(const RigidMotion<dim> &motion, const bool opens) {
  if (!opens)
    return dim == 2 || motion.is_translation() ? "it slides" : "it turns";
  return motion.is_translation() ? "it lifts off" : "it tips over";
}

template <int dim>
RigidMotion<dim> rigid_part(const MotionModes<dim> &modes, const dealii::Vector<double> &v) {
  std::vector<RigidMotion<dim>> rigid;
  std::vector<double> weights;
  for (unsigned int j = 0; j < modes.size(); ++j)
    if (modes.motions[j].rigid) {
      rigid.push_back(*modes.motions[j].rigid);
      weights.push_back(v[j]);
    }
  return combine(rigid, weights);
}

bool opens(const FullMatrix<double> &B, const dealii::Vector<double> &v, const unsigned int m) {
  constexpr double negligible = 1e-8;
  dealii::Vector<double> opening(B.m());
  B.vmult(opening, v);
  const double small = negligible * B.linfty_norm() * v.linfty_norm();
  return std::any_of(opening.begin(), opening.begin() + m,
                     [small](const double x) { return std::abs(x) > small; });
}

template struct MotionModes<2>;
template struct MotionModes<3>;
INSTANTIATE_FUNCTION(make_motion_modes);
INSTANTIATE_FUNCTION(text_of_escape);
INSTANTIATE_FUNCTION(rigid_part);
} // namespace Signorini
