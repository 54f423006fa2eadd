// SPDX-License-Identifier: LGPL-2.1-or-later
// The system (5) checked with integrals over the cells: nothing here uses A or its factors.

#include <signorini/elasticity/cell_stiffness.h>
#include <signorini/postprocess/certificate.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Signorini
{
namespace
{
double relative(const double value, const double scale)
{
  return scale > 0. ? std::abs(value) / scale : std::abs(value);
}

/** a(u_h, phi_j), f(phi_j), [p_H, B phi_j] and their balance, for every j, known to all ranks. */
struct NodalForces
{
  NodalVector internal;
  NodalVector loads;
  NodalVector contact;
  /** internal - loads - contact: zero on free, the reaction on constrained degrees of freedom. */
  NodalVector residual;
  /** |A| |U|: the size of the terms that make up the internal forces. */
  double magnitude = 0.;

  /** The norm of the largest of the forces. */
  double largest() const
  {
    return std::max({internal.l2_norm(), loads.l2_norm(), contact.l2_norm()});
  }
  /** Whether all forces are zero within rounding: a rigid motion. Then there is nothing but the
   * magnitude that residuals could be compared with. */
  bool vanish() const
  {
    return largest() <= 1e3 * std::numeric_limits<double>::epsilon() * magnitude;
  }
};

template <int dim>
NodalForces nodal_forces(const DisplacementSpace<dim> &space,
                         const Scene<dim> &scene,
                         const LinearSystem<dim> &system,
                         const Coupling &D,
                         const ContactSolution<dim> &solution)
{
  NodalForces forces;
  const InternalForces<dim> internal = internal_forces(space, scene, solution.U);
  forces.internal = NodalVector(internal.forces);
  forces.loads = NodalVector(system.loads);
  DistributedVector contact = space.make_vector();
  D.add_product(solution.P, contact);
  contact.compress(dealii::VectorOperation::add);
  forces.contact = NodalVector(contact);
  forces.residual = forces.internal;
  forces.residual -= forces.loads;
  forces.residual -= forces.contact;
  forces.magnitude = internal.magnitudes.l2_norm();
  return forces;
}

/** |T^T r|_2 relative to the largest term of r. */
template <int dim>
double stationarity(const DisplacementSpace<dim> &space, const NodalForces &forces)
{
  return relative(space.condense(forces.residual).l2_norm(),
                  forces.vanish() ? forces.magnitude : forces.largest());
}

/** Nodes that hold the body: where degrees of freedom are constrained, or constrain others. */
template <int dim>
std::map<dealii::types::global_dof_index, std::pair<dealii::Point<dim>, unsigned int>>
supported_dofs(const DisplacementSpace<dim> &space)
{
  std::vector<bool> supported(space.dofs().n_dofs(), false);
  for (const auto &line : space.constraints().get_lines())
  {
    supported[line.index] = true;
    for (const auto &entry : line.entries)
      supported[entry.first] = true;
  }
  std::map<dealii::types::global_dof_index, std::pair<dealii::Point<dim>, unsigned int>> dofs;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->at_boundary())
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int d = 0; d < dim; ++d)
          if (supported[cell->vertex_dof_index(v, d)])
            dofs[cell->vertex_dof_index(v, d)] = {cell->vertex(v), d};
  return dofs;
}

/** The point of the mesh's boundary that stands for the arc length @p s of a face. */
template <int dim>
dealii::Point<dim> point_on_face(const Mesh<dim> &mesh,
                                 const ContactFace<dim> &face,
                                 const double s)
{
  static_assert(dim == 2, "a face has one parameter");
  dealii::Point<dim> unit;
  unit[face.face_no / 2] = face.face_no % 2;
  unit[1 - face.face_no / 2] = face.parameter(s);
  return mesh.mapping().transform_unit_to_real_cell(face.cell, unit);
}

/**
 * sum_tau P_tau int_tau n and its moment. In the plane n ds is the tangent turned by a right angle,
 * so that both integrals depend on the ends a, b of a piece only, however it is curved: +-(b2 - a2,
 * a1 - b1) and -+(|b|^2 - |a|^2)/2.
 */
template <int dim>
Resultant<dim> contact_resultant(const Mesh<dim> &mesh,
                                 const MultiplierSpace<dim> &multipliers,
                                 const dealii::Vector<double> &P)
{
  Resultant<dim> resultant;
  for (const Piece &piece : multipliers.partition().pieces)
  {
    const ContactFace<dim> &face = multipliers.faces()[piece.face];
    const dealii::Point<dim> a = point_on_face(mesh, face, piece.start);
    const dealii::Point<dim> b = point_on_face(mesh, face, piece.end);
    dealii::Tensor<1, dim> turned({b[1] - a[1], a[0] - b[0]});
    const auto &side = multipliers.side(multipliers.partition().patches[piece.patch]);
    const double sign = turned * side.normal(0.5 * (piece.start + piece.end)) > 0. ? 1. : -1.;
    resultant.force += sign * P[piece.patch] * turned;
    resultant.moment -= sign * P[piece.patch] * 0.5 * (b.square() - a.square());
  }
  return resultant;
}

/** Balance of forces and moments between reactions, loads and contact. */
template <int dim>
void balance(const DisplacementSpace<dim> &space,
             const Scene<dim> &scene,
             const Resultant<dim> &applied,
             const Resultant<dim> &contact,
             const NodalForces &forces,
             Certificate &certificate)
{
  Resultant<dim> reactions;
  double sum_of_sizes = 0.;
  for (const auto &dof : supported_dofs(space))
  {
    dealii::Tensor<1, dim> reaction;
    reaction[dof.second.second] = forces.residual[dof.first];
    sum_of_sizes += reaction.norm();
    reactions.add(reaction, dof.second.first);
  }
  const dealii::Tensor<1, dim> force = reactions.force + applied.force + contact.force;
  // About the centre of the body: the origin may be far away.
  const dealii::Tensor<1, dim> centre =
    0.5 * (scene.geometry.lower + (scene.geometry.upper - dealii::Point<dim>()));
  const double moment = reactions.moment + applied.moment + contact.moment -
                        (centre[0] * force[1] - centre[1] * force[0]);
  const double largest = std::max({sum_of_sizes, applied.force.norm(), contact.force.norm()});
  const double scale = forces.vanish() ? forces.magnitude : largest;
  certificate.force_balance = relative(force.norm(), scale);
  certificate.moment_balance =
    relative(moment, scale * (scene.geometry.diameter() + centre.norm()));
}

/** Signs, penetration and complementarity of P and W = D^T U - G. */
template <int dim>
void check_contact(const MultiplierSpace<dim> &multipliers,
                   const ContactSolution<dim> &solution,
                   const dealii::Vector<double> &W,
                   const double energy_scale,
                   Certificate &certificate)
{
  const unsigned int m = W.size();
  double deepest = 0., largest_P = 0., tensile = 0., length_scale = solution.U.linfty_norm();
  for (unsigned int tau = 0; tau < m; ++tau)
  {
    const double length = multipliers.partition().patches[tau].length();
    deepest = std::max(deepest, W[tau] / length);
    length_scale = std::max(length_scale, std::abs(solution.G[tau]) / length);
    largest_P = std::max(largest_P, std::abs(solution.P[tau]));
    tensile = std::max(tensile, solution.P[tau]);
  }
  certificate.penetration = relative(deepest, length_scale);
  certificate.sign = relative(tensile, largest_P);
  certificate.complementarity = relative(solution.P * W, energy_scale);
  for (unsigned int tau = 0; tau < m; ++tau)
  {
    // Measured as lengths, so that they are known to be small where all pressures vanish.
    const double pressed = solution.C.m() == m ? solution.C(tau, tau) * solution.P[tau] : 0.;
    const double small = 1e-6 * length_scale * multipliers.partition().patches[tau].length();
    if (std::abs(pressed) < small && std::abs(W[tau]) < small)
      ++certificate.degenerate_patches;
  }
}

/**
 * Without contact the body has the energy Pi(U_0). With V = U - U_0, primal: Pi(U) - Pi(U_0) =
 * a(V,V)/2 and a(V,V) = a(U,V) - f(V); dual: P^T F - P^T C P/2.
 */
template <int dim>
double duality_gap(const ContactSolution<dim> &solution,
                   const NodalForces &forces,
                   const double energy_scale)
{
  NodalVector V = solution.U;
  V -= solution.free_U;
  const double primal = 0.5 * (V * forces.internal - V * forces.loads);
  const double dual = solution.P * solution.F - 0.5 * solution.C.matrix_norm_square(solution.P);
  return relative(primal - dual, std::max(energy_scale, std::abs(dual)));
}
} // namespace

Columns<Certificate> Certificate::columns()
{
  return {{"energy", &Certificate::energy}};
}

template <int dim>
Certificate certify(const DisplacementSpace<dim> &space,
                    const Scene<dim> &scene,
                    const LinearSystem<dim> &system,
                    const MultiplierSpace<dim> &multipliers,
                    const Coupling &D,
                    const ContactSolution<dim> &solution)
{
  Certificate certificate;
  certificate.moments_are_exact = !space.mesh().is_curved();
  const NodalForces forces = nodal_forces(space, scene, system, D, solution);
  certificate.stationarity = stationarity(space, forces);
  balance(space,
          scene,
          system.applied,
          contact_resultant(space.mesh(), multipliers, solution.P),
          forces,
          certificate);

  dealii::Vector<double> W = D.transpose_product(solution.U);
  W -= solution.G;
  const double strain_energy = 0.5 * (solution.U * forces.internal);
  const double work_of_loads = solution.U * forces.loads;
  const double work_of_gap = solution.P * solution.G;
  const double energy_scale =
    std::max({strain_energy, std::abs(work_of_loads), std::abs(work_of_gap)});
  check_contact(multipliers, solution, W, energy_scale, certificate);
  // J of (22); [p, Bu - g] is P^T W.
  certificate.energy = strain_energy - work_of_loads - solution.P * W;

  if (solution.C.m() > 0)
    certificate.duality_gap = duality_gap(solution, forces, energy_scale);
  const double unit_roundoff = std::numeric_limits<double>::epsilon();
  certificate.rounding =
    forces.vanish() ? unit_roundoff : relative(unit_roundoff * forces.magnitude, forces.largest());
  return certificate;
}

template Certificate certify(const DisplacementSpace<2> &,
                             const Scene<2> &,
                             const LinearSystem<2> &,
                             const MultiplierSpace<2> &,
                             const Coupling &,
                             const ContactSolution<2> &);
} // namespace Signorini
