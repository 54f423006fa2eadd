// SPDX-License-Identifier: LGPL-2.1-or-later
// The check of the system (5) with integrals over the cells, without A or its factors.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/nodes.h>
#include <signorini/discretization/space/paired_piece.h>
#include <signorini/error_control/estimate/certificate.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace Signorini {
namespace {
double relative(const double value, const double scale) {
  return scale > 0. ? std::abs(value) / scale : std::abs(value);
}

/** A degree of freedom that holds a body. */
template <int dim>
struct SupportPoint {
  Point<dim> node;
  unsigned int component, body;
};

/** Returns the degrees of freedom that hold the bodies. */
template <int dim>
std::map<types::global_dof_index, SupportPoint<dim>>
support_points(const DisplacementSpace<dim> &space, const Geometry<dim> &geometry) {
  NodePositions<dim> positions(space);
  std::map<types::global_dof_index, SupportPoint<dim>> points;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (!cell->is_artificial() && cell->at_boundary()) {
      const std::vector<Point<dim>> &nodes = positions(cell);
      const std::vector<types::global_dof_index> dofs = space.cell_dofs(cell);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        if (space.supports().is_element(dofs[i])) {
          const auto [component, node] = cell->get_fe().system_to_component_index(i);
          points[dofs[i]] = {nodes[node], component, geometry.body_of(cell)};
        }
    }
  return points;
}

/** Returns the resultants of contact by body, and the sum of their sizes: pressures all around a
 * hole have none. */
template <int dim>
std::pair<std::vector<Resultant<dim>>, double> contact_by_body(const BodyInContact<dim> &body) {
  const Geometry<dim> &geometry = body.scene.geometry;
  std::vector<Resultant<dim>> contact(geometry.n_bodies());
  double size = 0.;
  for (const Piece<dim> &piece : body.surface().pieces()) {
    const PairedPiece<dim> pair(body.surface(), piece);
    const Resultant<dim> resultant = pair.resultant(body.multipliers, body.P);
    contact[geometry.body_of_side(body.surface().faces()[piece.face].side)] += resultant;
    if (const ContactFace<dim> *const other = pair.other_face())
      contact[geometry.body_of_side(other->side)] +=
        pair.resultant(body.multipliers, body.P, PairSide::second);
    size += resultant.force.norm();
  }
  const MPI_Comm communicator = body.surface().communicator();
  for (Resultant<dim> &resultant : contact)
    resultant = sum_over_ranks(resultant, communicator);
  return {contact, Utilities::MPI::sum(size, communicator)};
}

/** Computes the balances of forces and moments between reactions, loads and contact: those of the
 * body where they are worst. @param sums loads and contact by body. */
template <int dim>
void balance(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
             std::vector<Resultant<dim>> sums, const double size_of_contact,
             const NodalForces &forces, Certificate &certificate) {
  double sum_of_sizes = 0.;
  std::vector<Resultant<dim>> reactions(sums.size());
  for (const auto &[dof, support] : support_points(space, scene.geometry))
    if (forces.residual.in_local_range(dof)) {
      Tensor<1, dim> reaction;
      reaction[support.component] = forces.residual(dof);
      sum_of_sizes += reaction.norm();
      reactions[support.body].add(reaction, support.node);
    }
  sum_of_sizes = Utilities::MPI::sum(sum_of_sizes, space.mesh().communicator());
  // About the centre of the body: the origin may be far away.
  const Point<dim> centre =
    scene.geometry.lower + 0.5 * (scene.geometry.upper - scene.geometry.lower);
  // Loads in balance have no resultant: the forces at the nodes are the size of loads.
  const double largest = std::max({sum_of_sizes, forces.loads.l1_norm(), size_of_contact});
  const double scale = forces.energy.rigid ? std::max(forces.magnitude, largest) : largest;
  const double arm = scene.geometry.diameter() + centre.norm();
  certificate.force_balance = certificate.moment_balance = 0.;
  for (unsigned int k = 0; k < sums.size(); ++k) {
    Resultant<dim> &sum = sums[k];
    sum += sum_over_ranks(reactions[k], space.mesh().communicator());
    // All around the axis radial forces are in balance, and hoop stresses carry them.
    if (scene.geometry.axisymmetric)
      sum = {Tensor<1, dim>() + sum.force[dim - 1] * Point<dim>::unit_vector(dim - 1), {}};
    certificate.force_balance =
      std::max(certificate.force_balance, relative(sum.force.norm(), scale));
    certificate.moment_balance =
      std::max(certificate.moment_balance, relative(sum.moment_about(centre).norm(), scale * arm));
  }
}

/** Returns the largest error of U at the vertices of sides that hold the body. */
template <int dim>
double support_error(const DisplacedBody<dim> &body) {
  const auto &[space, scene, U] = body;
  double scale = U.linfty_norm();
  // A vertex between two sides takes the displacement of one; on rollers alone, it obeys both.
  struct Errors {
    std::optional<double> displacement;
    double rollers = 0.;
  };
  std::map<unsigned int, Errors> errors;
  dealii::Vector<double> prescribed(dim);
  // A vertex of this rank may lie on cells of others.
  for (const auto &cell : space.dofs().active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      const auto face = cell->face(f);
      if (cell->is_artificial() || !face->at_boundary())
        continue;
      const unsigned int number = face->boundary_id();
      const BoundaryCondition<dim> &condition = scene.boundary[number];
      const bool rolls = condition.role == Role::roller;
      // The system takes other normals at the vertices of curved rollers.
      if (rolls ? space.mesh().is_curved()
                : condition.role != Role::clamped && condition.role != Role::displacement)
        continue;
      for (const unsigned int v : face->vertex_indices()) {
        prescribed = 0.;
        if (condition.role == Role::displacement)
          condition.data->vector_value(face->vertex(v), prescribed);
        scale = std::max(scale, prescribed.linfty_norm());
        Tensor<1, dim> rest;
        for (unsigned int d = 0; d < dim; ++d)
          rest[d] = U[face->vertex_dof_index(v, d, cell->active_fe_index())] - prescribed[d];
        auto &[displacement, rollers] = errors[face->vertex_index(v)];
        const Side<dim> &side = scene.geometry.sides[number];
        // In the plane a straight side may end at the vertex; in space its surface goes on.
        if (rolls)
          rollers = std::max(
            rollers, std::abs(rest * side.normal_at(dim == 2 ? face->center() : face->vertex(v))));
        else
          displacement = std::min(displacement.value_or(rest.norm()), rest.norm());
      }
    }
  double largest = 0.;
  for (const auto &[vertex, error] : errors)
    largest = std::max(largest, error.displacement.value_or(error.rollers));
  MPI_Comm communicator = space.mesh().communicator();
  return relative(Utilities::MPI::max(largest, communicator),
                  Utilities::MPI::max(scale, communicator));
}

/** The least share of the displacement without contact that counts as a scale: contact may leave
 * less of it than rounding does. 1e-8 of this share is 50 times the unit roundoff. */
constexpr double min_share_of_free_state = 1e-6;

/** Checks signs, penetration and complementarity of P and W, and that W vanishes where P_t sticks.
 */
template <int dim>
void check_contact(const Solved<dim> &solved, const double energy_scale, Certificate &certificate) {
  const ContactSolution &solution = solved.contact;
  const dealii::Vector<double> measures = solved.multipliers.integrals(), &P = solution.P.values(),
                               &W = solution.W;
  const AdmissibleSet &K = solution.P.set();
  const unsigned int m = measures.size();
  double deepest = 0., outside = 0.;
  double length_scale = solution.U.linfty_norm();
  if (const DualData *const dual = solution.dual())
    length_scale = std::max(length_scale, min_share_of_free_state * dual->free.U.linfty_norm());
  for (unsigned int tau = 0; tau < m; ++tau) {
    deepest = std::max(deepest, W[tau] / measures[tau]);
    length_scale = std::max(length_scale, std::abs(solved.discretization.G[tau]) / measures[tau]);
  }
  const dealii::Vector<double> slip = K.slip(P, W);
  for (unsigned int i = m; i < K.n_blocks(); ++i)
    deepest = std::max(deepest, std::abs(K.length(i, W) - K.length(i, slip)) / measures[i - m]);
  // How far P lies outside of the admissible set.
  for (const double distance : K.residual(P, dealii::Vector<double>(P.size())))
    outside = std::max(outside, std::abs(distance));
  certificate.penetration = relative(deepest, length_scale);
  certificate.sign = relative(outside, P.linfty_norm());
  certificate.complementarity = relative(P * W + K.dissipation(slip), energy_scale);
  for (unsigned int tau = 0; tau < m; ++tau) {
    // Measured as lengths, so that they are small where all pressures vanish.
    const double pressed = solution.diagonal_P.size() > 0 ? solution.diagonal_P[tau] : 0.;
    const double small = 1e-6 * length_scale * measures[tau];
    if (std::abs(pressed) < small && std::abs(W[tau]) < small)
      ++certificate.degenerate_patches;
  }
}

/**
 * Returns the relative duality gap. Energies are differences to Π(U_0) of the body without contact.
 * With V = U - U_0 the primal one is Π(U) - Π(U_0) = a(V,V)/2, where a(V,V) = a(U,V) - f(V), with
 * friction plus its dissipation; the dual one is Pᵀ F - Pᵀ C P/2.
 */
double duality_gap(const ContactSolution &contact, const DualData &data, const NodalForces &forces,
                   const double dissipation, const double energy_scale) {
  Displacement V = contact.U;
  V -= data.free.U;
  const dealii::Vector<double> &P = contact.P.values();
  const double primal = 0.5 * (V * forces.internal - V * forces.loads) + dissipation;
  const double dual = P * data.free.F - 0.5 * (P * contact.C_P);
  return relative(primal - dual, std::max(energy_scale, std::abs(dual)));
}

/** Returns the relative duality gap where the body without contact is not computed: with r = f + D
 * P - A U it is Pᵀ W + ½ rᵀ A⁻¹ r. */
double duality_gap(const ContactSolution &contact, const CycleData &data, const NodalForces &forces,
                   const Energies &energies) {
  const double scale =
    std::max({0.5 * std::abs(contact.U * forces.internal), std::abs(energies.loads),
              std::abs(energies.gap), forces.rigid_energy()});
  return relative(energies.opening + data.energy_of_residual, scale);
}
} // namespace

Columns<Certificate> Certificate::columns() {
  return {{"energy", &Certificate::energy}};
}

template <int dim>
Certificate certify(const Solved<dim> &solved, const std::vector<Resultant<dim>> &applied,
                    const NodalForces &forces, const Energies &energies) {
  const DisplacementSpace<dim> &space = solved.space;
  const ContactSolution &solution = solved.contact;
  Certificate certificate;
  certificate.moments_are_exact = !space.mesh().is_curved();
  // |Tᵀ r|₂ relative to the largest term of r.
  certificate.stationarity = relative(space.condense(forces.residual).l2_norm(), forces.scale());
  certificate.support = support_error<dim>(solved);
  certificate.translation = forces.translation;
  auto [sums, size_of_contact] = contact_by_body<dim>(solved);
  for (unsigned int k = 0; k < sums.size(); ++k)
    sums[k] += applied[k];
  balance(space, solved.scene, std::move(sums), size_of_contact, forces, certificate);

  const DualData *const dual = solution.dual();
  double energy_scale = std::max(
    {energies.strain, std::abs(energies.loads), std::abs(energies.gap), forces.rigid_energy()});
  if (dual != nullptr)
    energy_scale = std::max(energy_scale,
                            min_share_of_free_state * std::abs(solution.P.values() * dual->free.F));
  check_contact(solved, energy_scale, certificate);
  certificate.energy = energies.J();
  if (solution.P.has_tangential_part()) {
    double work =
      solution.U * forces.internal - energies.loads - energies.gap + energies.dissipation;
    double work_of_supports = 0.;
    for (const auto support : space.supports())
      if (forces.residual.in_local_range(support))
        work_of_supports += solution.U(support) * forces.residual(support);
    work -= Utilities::MPI::sum(work_of_supports, space.mesh().communicator());
    certificate.dissipation_balance = relative(work, energy_scale);
  }

  if (const auto *const cycles = std::get_if<CycleData>(&solution.data))
    certificate.duality_gap = duality_gap(solution, *cycles, forces, energies);
  else if (solution.touches())
    certificate.duality_gap =
      duality_gap(solution, *dual, forces, energies.dissipation, energy_scale);
  const double unit_roundoff = std::numeric_limits<double>::epsilon();
  const double noise = unit_roundoff * forces.magnitude;
  certificate.rounding = forces.energy.rigid ? unit_roundoff
                         : noise > 0.        ? noise / std::max(noise, forces.largest())
                                             : 0.;
  return certificate;
}

INSTANTIATE_FUNCTION(certify);

} // namespace Signorini
