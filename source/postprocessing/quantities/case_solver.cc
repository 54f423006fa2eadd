// SPDX-License-Identifier: LGPL-2.1-or-later
// Many loads on one body: the factors, C and B are those of all cases.

#include <signorini/discretization/space/linear_system.h>
#include <signorini/discretization/space/paired_piece.h>
#include <signorini/postprocessing/fields/contact_intervals.h>
#include <signorini/postprocessing/quantities/case_solver.h>
#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/postprocessing/quantities/peak_pressure.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/motion_modes.h>

#include <algorithm>

namespace Signorini {
template <int dim>
CaseSolver<dim>::CaseSolver(const Discretization<dim> &discretization, const Scene<dim> &scene,
                            const LevelOperators<dim> &operators, const DualSolverOptions &options,
                            const bool are_steps)
  : discretization_(discretization)
  , scene_(scene)
  , operators_(operators)
  , options_(options)
  , are_steps_(are_steps)
  , B_(operators_.modes.couple(discretization_.D))
  , G_(discretization_.assemble_gap_of(scene_))
  , reactions_(discretization_.space, scene_)
  , slip_(discretization_.multipliers.n_multipliers()) {
  for (const CaseFactor &factor : case_factors())
    if (factor.kind && has_load(scene_, *factor.kind))
      responses_.push_back(respond(factor));
}

template <int dim>
typename CaseSolver<dim>::LoadResponse CaseSolver<dim>::respond(const CaseFactor &factor) const {
  const Scene<dim> scene = with_only(scene_, *factor.kind);
  const DisplacementSpace<dim> &space = discretization_.space;
  const Displacement k = space.prescribed(scene);
  const LinearSystem<dim> system =
    assemble_right_hand_side(space, scene, discretization_.n_points, k);
  LoadResponse response;
  response.factor = factor.number;
  response.U = solve_homogeneous(*operators_.inverse, space, system.f);
  response.U += k;
  response.closing = discretization_.D.transpose_product(response.U);
  response.loads = system.loads;
  response.work = operators_.modes.work(scene.plates, system.loads, response.U);
  return response;
}

template <int dim>
dealii::Vector<double> CaseSolver<dim>::gap_of(const LoadCase &load_case) const {
  if (load_case.shift<dim>().norm() > 0.)
    return discretization_.assemble_gap_of(scene_of_case(scene_, load_case));
  dealii::Vector<double> G = G_;
  for (unsigned int k = 0; k < G.size(); ++k)
    G[k] *= k < discretization_.multipliers.n_multipliers() ? load_case.gap : load_case.slide;
  return G;
}

template <int dim>
TangentialSummary CaseSolver<dim>::finish_step(const dealii::Vector<double> &F) {
  dealii::Vector<double> W = operators_.C->apply(P_.values());
  W -= F;
  if (q_.size() > 0)
    B_.vmult_add(W, q_);
  TangentialSummary summary = summarise_tangential_part(discretization_.multipliers, P_, W);
  if (!are_steps_)
    return summary;
  for (unsigned int k = 0, m = slip_.size(); k < m; ++k)
    slip_[k] += W[m + k];
  summary.dissipation = dissipation_ += summary.dissipation;
  return summary;
}

template <int dim>
DualVector CaseSolver<dim>::loads_of(const LoadCase &load_case) const {
  DualVector loads = discretization_.space.make_vector();
  for (const LoadResponse &response : responses_)
    loads.add(load_case.*response.factor, response.loads);
  return loads;
}

template <int dim>
bool CaseSolver<dim>::slides(const LoadCase &load_case) const {
  if (operators_.modes.neutral.empty())
    return false;
  const std::vector<Plate<dim>> plates = plates_of_case(scene_.plates, load_case);
  return operators_.modes.driven_neutral(plates, loads_of(load_case)).has_value();
}

template <int dim>
CaseResult CaseSolver<dim>::solve_dual(const LoadCase &load_case) {
  CaseResult result;
  result.load_case = last_ = load_case;
  dealii::Vector<double> F = gap_of(load_case);
  const unsigned int m = discretization_.multipliers.n_multipliers();
  for (unsigned int k = m; k < F.size() && are_steps_; ++k)
    F[k] += slip_[k - m];
  FreeMotions motions = {B_, operators_.modes.K, dealii::Vector<double>(operators_.modes.size()),
                         dealii::Vector<double>(operators_.modes.size())};
  for (const LoadResponse &response : responses_) {
    const double share = load_case.*response.factor;
    F.add(-share, response.closing);
    motions.b.add(share, response.work.value);
    motions.b_magnitude.add(std::abs(share), response.work.magnitude);
  }
  const MotionResult solved =
    solve_dual_problem(operators_.C, F, discretization_.K, motions, P_.values(), options_);
  if (solved.escape)
    result.escape = text_of_escape(rigid_part(operators_.modes, *solved.escape),
                                   opens(B_, *solved.escape, m) && !solved.sliding);
  const QPResult &qp = solved.qp;
  q_ = solved.q;
  P_ = Multiplier(qp.P, discretization_.K);
  if (P_.has_tangential_part() && solved.escape)
    // The next case begins with stick.
    P_ = Multiplier();
  else if (P_.has_tangential_part())
    result.tangential = finish_step(F);
  result.iterations = qp.iterations;
  result.kkt = qp.kkt_residual;
  result.converged = qp.converged;
  return result;
}

template <int dim>
CaseResult CaseSolver<dim>::solve(const LoadCase &load_case) {
  CaseResult result = solve_dual(load_case);
  if (slides(load_case))
    result.escape = "it slides";
  if (!result.escape.empty())
    return result;
  const ContactSurface<dim> &surface = discretization_.surface;
  const std::vector<unsigned int> contacts = contacts_of_contact_force(scene_);
  Resultant<dim> force;
  const PairSide acts_on = body_of_contact_force(scene_);
  for (const Piece<dim> &piece : surface.pieces())
    if (std::count(contacts.begin(), contacts.end(), surface.patches()[piece.patch].contact) > 0)
      force += PairedPiece<dim>(surface, piece).resultant(discretization_.multipliers, P_, acts_on);
  result.contact = {force.force, force.moment};
  if (const auto peak = peak_pressure(discretization_.multipliers, P_.normal()))
    result.peak_pressure = peak->value;
  const ContactSummary summary = summarise_contact(discretization_.multipliers, P_.normal());
  if constexpr (dim == 2)
    for (const ContactZone &zone : contact_zones(discretization_.multipliers, P_.normal())) {
      result.zone_length += zone.length;
      ++result.n_zones;
    }
  else
    result.zone_length = summary.length;
  result.active = summary.active;
  result.plates = plate_records(scene_, plate_motions(), {});
  return result;
}

template <int dim>
std::vector<PlateMotion<dim>> CaseSolver<dim>::plate_motions() const {
  return operators_.modes.plate_motions(plates_of_case(scene_.plates, last_), q_);
}

template <int dim>
std::vector<std::pair<std::string, double>>
CaseSolver<dim>::reactions(const Displacement &U) const {
  DualVector forces = loads_of(last_);
  discretization_.D.add_product(P_.values(), forces);
  return reactions_.of(U, forces);
}

template <int dim>
ContactSolution CaseSolver<dim>::contact() const {
  ContactSolution contact;
  contact.P = P_;
  contact.q = q_;
  DualVector forces = discretization_.space.make_vector();
  discretization_.condensed_D.add_product(P_.values(), forces);
  contact.U = solve_homogeneous(*operators_.inverse, discretization_.space, forces);
  for (const LoadResponse &response : responses_)
    contact.U.add(last_.*response.factor, response.U);
  operators_.modes.add_to(contact.U, q_);
  return contact;
}

template class CaseSolver<2>;
template class CaseSolver<3>;
} // namespace Signorini
