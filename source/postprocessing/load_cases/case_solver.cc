// SPDX-License-Identifier: LGPL-2.1-or-later
// Many loads on one body: the factors, C and B are those of all cases.

#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/load_cases/case_solver.h>
#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/postprocessing/quantities/peak_pressure.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/kinematics/motion_modes.h>

namespace Signorini {
namespace {
double share_of(const LoadCase &load_case, const LoadKind kind) {
  switch (kind) {
  case LoadKind::force:
    return load_case.force;
  case LoadKind::weight:
    return load_case.weight;
  case LoadKind::travel:
    break;
  }
  return load_case.travel;
}
} // namespace

CaseSolver::CaseSolver(CaseData data)
  : data_(std::move(data))
  , C_(make_compliance(data_.inverse, data_.condensed_D, seconds_))
  , B_(data_.modes.couple(data_.D))
  , G_(data_.gap(data_.scene))
  , slip_(data_.multipliers.n_multipliers()) {
  for (const LoadKind kind : {LoadKind::force, LoadKind::weight, LoadKind::travel})
    if (has_load(data_.scene, kind))
      responses_.push_back(respond(kind));
}

CaseSolver::LoadResponse CaseSolver::respond(const LoadKind kind) const {
  const Scene<2> scene = with_only(data_.scene, kind);
  const DisplacementSpace<2> &space = data_.space;
  const DualVector loads = space.dual(assemble_right_hand_side(space, scene, data_.n_points).loads);
  const Displacement k = space.prescribed(scene);
  DualVector r = loads;
  r -= space.dual(internal_forces(space, scene, k).forces);
  LoadResponse response;
  response.kind = kind;
  response.U = solve_prescribed(data_.inverse, space, k, r);
  response.closing = data_.D.transpose_product(response.U);
  response.loads = loads;
  response.work = data_.modes.work(scene.plates, loads, response.U);
  return response;
}

dealii::Vector<double> CaseSolver::gap_of(const LoadCase &load_case) const {
  if (load_case.shift.norm() > 0.)
    return data_.gap(scene_of_case(data_.scene, load_case));
  dealii::Vector<double> G = G_;
  for (unsigned int k = 0; k < G.size(); ++k)
    G[k] *= k < data_.multipliers.n_multipliers() ? load_case.gap : load_case.slide;
  return G;
}

FrictionSummary CaseSolver::finish_step(const dealii::Vector<double> &P,
                                        const dealii::Vector<double> &F) {
  dealii::Vector<double> W = C_->apply(P);
  W -= F;
  if (q_.size() > 0)
    B_.vmult_add(W, q_);
  FrictionSummary summary = summarise_friction(data_.multipliers, data_.options.K, P, W);
  if (!data_.are_steps)
    return summary;
  for (unsigned int k = 0, m = slip_.size(); k < m; ++k)
    slip_[k] += W[m + k];
  summary.dissipation = dissipation_ += summary.dissipation;
  return summary;
}

bool CaseSolver::slides(const LoadCase &load_case) const {
  if (data_.modes.unseen.empty())
    return false;
  DualVector loads = data_.space.zero();
  for (const LoadResponse &response : responses_)
    loads.add(share_of(load_case, response.kind), response.loads);
  const std::vector<Plate> plates = plates_of_case(data_.scene.plates, load_case);
  return data_.modes.driven_unseen(plates, loads).has_value();
}

CaseResult CaseSolver::solve_dual(const LoadCase &load_case) {
  CaseResult result;
  result.load_case = last_ = load_case;
  dealii::Vector<double> F = gap_of(load_case);
  const unsigned int m = data_.multipliers.n_multipliers();
  for (unsigned int k = m; k < F.size(); ++k)
    F[k] += slip_[k - m];
  FreeMotions motions = {B_, data_.modes.K, dealii::Vector<double>(data_.modes.size()),
                         dealii::Vector<double>(data_.modes.size()), data_.options.K};
  for (const LoadResponse &response : responses_) {
    const double share = share_of(load_case, response.kind);
    F.add(-share, response.closing);
    motions.b.add(share, response.work.value);
    motions.b_magnitude.add(std::abs(share), response.work.magnitude);
  }
  const MotionResult solved = solve_dual_problem(C_, F, motions, join(P_, P_t_), data_.options);
  if (solved.escape)
    result.escape = text_of_escape(rigid_part(data_.modes, *solved.escape),
                                   opens(B_, *solved.escape, m) && !solved.sliding);
  const QPResult &qp = solved.qp;
  q_ = solved.q;
  P_ = Pressure(dealii::Vector<double>(qp.P.begin(), qp.P.begin() + m));
  P_t_ = Pressure(dealii::Vector<double>(qp.P.begin() + m, qp.P.end()));
  if (P_t_.size() > 0 && solved.escape)
    // The next case begins with stick.
    P_ = P_t_ = Pressure();
  else if (P_t_.size() > 0)
    result.friction = finish_step(qp.P, F);
  result.iterations = qp.iterations;
  result.kkt = qp.kkt_residual;
  result.converged = qp.converged;
  return result;
}

CaseResult CaseSolver::solve(const LoadCase &load_case) {
  CaseResult result = solve_dual(load_case);
  if (slides(load_case))
    result.escape = "it slides";
  if (!result.escape.empty())
    return result;
  for (const Piece<2> &piece : data_.multipliers.surface().pieces())
    result.contact += contact_resultant(data_.multipliers, P_, piece, P_t_);
  if (const auto peak = peak_pressure(data_.multipliers, P_))
    result.peak_pressure = peak->value;
  for (const ContactZone &zone : contact_zones(data_.multipliers, P_)) {
    result.zone_length += zone.length;
    ++result.n_zones;
  }
  result.active = summarise_contact(data_.multipliers, P_).active;
  result.plates = data_.modes.plate_motions(plates_of_case(data_.scene.plates, load_case), q_);
  return result;
}

Displacement CaseSolver::displacement() const {
  DistributedVector forces = data_.space.make_vector();
  data_.condensed_D.add_product(join(P_, P_t_), forces);
  Displacement U = solve_homogeneous(data_.inverse, data_.space, forces);
  for (const LoadResponse &response : responses_)
    U.add(share_of(last_, response.kind), response.U);
  if (data_.modes.size() > 0)
    data_.modes.add_to(U, q_);
  return U;
}
} // namespace Signorini
