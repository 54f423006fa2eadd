// SPDX-License-Identifier: LGPL-2.1-or-later
// C and P of one level.

#include <signorini/base/columns.h>
#include <signorini/base/errors.h>
#include <signorini/driver/level/level_pressure.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/recovery.h>
#include <signorini/solvers/cycles/boundary_model.h>
#include <signorini/solvers/kinematics/motion_modes.h>
#include <signorini/solvers/methods/escape_message.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
DualSolve summary_of(const QPResult &result, const ContactSolver method)
{
  DualSolve summary;
  summary.method = method;
  summary.iterations = result.iterations;
  if (method == ContactSolver::psor)
    summary.increment_iterations = result.increment_iterations;
  summary.kkt = result.kkt_residual;
  summary.converged = result.converged;
  summary.unique = result.unique;
  summary.active_set_failure = result.active_set_failure;
  return summary;
}

/** Tells the user of every twentieth part of the columns of C. */
ColumnProgress column_progress(const Progress &progress, const unsigned int n_columns)
{
  const unsigned int every = std::max(1U, n_columns / 20);
  return [&progress, every, n_columns](const unsigned int done) {
    if (done % every == 0)
      progress("compliance: " + std::to_string(done) + " columns, up to " +
               std::to_string(n_columns));
  };
}

/** C^ for MPRGP; null for other methods, and for other multipliers than constants. */
template <int dim>
std::shared_ptr<const BoundaryModel> model_for(const Parameters &parameters,
                                               const Discretization<dim> &discretization)
{
  if (parameters.solver.contact_solver != ContactSolver::mprgp ||
      !discretization.multipliers.is_piecewise_constant())
    return nullptr;
  return make_boundary_model(discretization.multipliers);
}

SetPreconditioner preconditioner(const std::shared_ptr<const BoundaryModel> &model)
{
  if (model == nullptr)
    return {};
  return [model](const std::vector<unsigned int> &set, const dealii::Vector<double> &r) {
    return model->solve(set, r);
  };
}

/** C, by products only where MPRGP meets a solver without factors. */
template <int dim>
std::shared_ptr<const ComplianceOperator> compliance_for(const Parameters &parameters,
                                                         const Discretization<dim> &discretization,
                                                         const StiffnessInverse &inverse,
                                                         const Progress &progress,
                                                         LevelRecord &record)
{
  const Coupling &D = discretization.condensed_D;
  if (!inverse.has_factors())
    if (const auto model = model_for(parameters, discretization))
      return std::make_shared<const SolvedCompliance>(inverse, D, model->diagonal());
  return make_compliance(
    inverse, D, record.times.compliance, column_progress(progress, D.n_columns()));
}

/** C_kk P_k. */
dealii::Vector<double> effect_on_itself(const Parameters &parameters,
                                        const ComplianceOperator &C,
                                        const dealii::Vector<double> &P)
{
  if (parameters.solver.contact_solver != ContactSolver::mprgp)
    return diagonal_times(C, P);
  dealii::Vector<double> product(P);
  product.scale(C.diagonal());
  return product;
}

/** P, and q where motions are free. */
template <int dim>
QPResult solve_contact(const Parameters &parameters,
                       const Discretization<dim> &discretization,
                       const MotionModes<dim> &modes,
                       const std::shared_ptr<const ComplianceOperator> &C,
                       const dealii::Vector<double> &F,
                       const dealii::Vector<double> &start,
                       LevelSolution<dim> &solution)
{
  const SolverParameters &solver = parameters.solver;
  const DualSolverOptions options = {solver.contact_solver,
                                     solver.relaxation,
                                     solver.tolerance,
                                     solver.maximum_iterations,
                                     is_unstable(discretization),
                                     preconditioner(model_for(parameters, discretization))};
  if (modes.size() == 0)
    return solve_dual_problem(C, F, start, options);
  if (solver.contact_solver == ContactSolver::mprgp)
    throw InputError(solver.contact_solver.where() + ": found '" +
                     to_text(solver.contact_solver.value) +
                     "' for a body or a plate that moves freely, allowed there: psor, active set.");
  const MotionResult result = solve_dual_problem(C, F, solution.motions, start, options);
  if constexpr (dim == 2)
  {
    if (result.escape)
      refuse_escape(parameters, discretization, modes, solution.motions, *result.escape);
    const bool begins_inside =
      std::any_of(F.begin(), F.end(), [](const double F_k) { return F_k < 0.; });
    if (begins_inside)
      refuse_undetermined(parameters, modes, solution.motions, result.qp.P);
  }
  solution.q = result.q;
  return result.qp;
}
} // namespace

double algebraic_error(const dealii::Vector<double> &P,
                       const dealii::Vector<double> &W,
                       const dealii::Vector<double> &diagonal)
{
  constexpr double diagonal_over_eigenvalue = 6.;
  double energy = 0.;
  for (unsigned int k = 0; k < P.size(); ++k)
    if (diagonal[k] > 0.)
      energy += diagonal[k] * std::pow(P[k] - std::min(0., P[k] - W[k] / diagonal[k]), 2);
  return std::sqrt(diagonal_over_eigenvalue * energy);
}

template <int dim>
double algebraic_error(const Parameters &parameters,
                       const Discretization<dim> &discretization,
                       const ComplianceOperator &C,
                       const LevelSolution<dim> &solution)
{
  const dealii::Vector<double> &P = solution.P;
  dealii::Vector<double> W = discretization.D.transpose_product(solution.U);
  W -= discretization.G;
  if (parameters.solver.contact_solver == ContactSolver::mprgp)
    return algebraic_error(P, W, C.diagonal());
  // Where nothing presses nor penetrates, a column of C may cost a solve.
  dealii::Vector<double> counted(P.size());
  for (unsigned int k = 0; k < P.size(); ++k)
    counted[k] = P[k] != 0. || W[k] > 0. ? 1. : 0.;
  return algebraic_error(P, W, diagonal_times(C, counted));
}

template <int dim>
Pressure find_pressure(const Parameters &parameters,
                       const Discretization<dim> &discretization,
                       const StiffnessInverse &inverse,
                       const MotionModes<dim> &modes,
                       const dealii::Vector<double> &start,
                       const Progress &progress,
                       LevelSolution<dim> &solution)
{
  const auto C = compliance_for(parameters, discretization, inverse, progress, solution.record);
  if (parameters.output.compliance)
    solution.C = C->dense();
  progress("dual problem");
  const StageTimer timer(solution.record.times.qp);
  const QPResult result =
    solve_contact(parameters, discretization, modes, C, solution.F, start, solution);
  solution.record.dual = summary_of(result, parameters.solver.contact_solver);
  return {result.P, C->apply(result.P), effect_on_itself(parameters, *C, result.P), C, {}};
}

template <int dim>
NodalVector recover(const Discretization<dim> &discretization,
                    const StiffnessInverse &inverse,
                    const MotionModes<dim> &modes,
                    const DistributedVector &f,
                    const LevelSolution<dim> &solution)
{
  NodalVector U =
    recover_displacement(inverse, discretization.space, discretization.condensed_D, solution.P, f);
  if (modes.size() > 0)
    modes.add_to(U, solution.q);
  return U;
}

template <int dim>
void correct_rounding(const Parameters &parameters,
                      const Discretization<dim> &discretization,
                      const StiffnessInverse &inverse,
                      const MotionModes<dim> &modes,
                      const DistributedVector &f,
                      Pressure &pressure,
                      LevelSolution<dim> &solution)
{
  constexpr unsigned int most_passes = 3;
  constexpr double negligible = 1e-10;
  const double measure = discretization.multipliers.integrals().l2_norm();
  for (unsigned int pass = 0; pass < most_passes; ++pass)
  {
    // F - r = C P + B q - W
    dealii::Vector<double> corrected_F(pressure.C_P);
    if (modes.size() > 0)
      solution.motions.B.vmult_add(corrected_F, solution.q);
    corrected_F -= discretization.D.transpose_product(solution.U);
    corrected_F += discretization.G;
    dealii::Vector<double> r(corrected_F);
    r -= pass == 0 ? solution.F : pressure.corrected_F;
    if (r.l2_norm() <= negligible * measure * solution.U.linfty_norm())
      return;
    pressure.corrected_F = corrected_F;
    const QPResult result = solve_contact(
      parameters, discretization, modes, pressure.C, corrected_F, pressure.P, solution);
    solution.record.dual = summary_of(result, parameters.solver.contact_solver);
    pressure.P = result.P;
    pressure.C_P = pressure.C->apply(result.P);
    pressure.diagonal_P = effect_on_itself(parameters, *pressure.C, result.P);
    solution.P = pressure.P;
    solution.U = recover(discretization, inverse, modes, f, solution);
  }
}

template double algebraic_error(const Parameters &,
                                const Discretization<2> &,
                                const ComplianceOperator &,
                                const LevelSolution<2> &);
template double algebraic_error(const Parameters &,
                                const Discretization<3> &,
                                const ComplianceOperator &,
                                const LevelSolution<3> &);
template Pressure find_pressure(const Parameters &,
                                const Discretization<2> &,
                                const StiffnessInverse &,
                                const MotionModes<2> &,
                                const dealii::Vector<double> &,
                                const Progress &,
                                LevelSolution<2> &);
template NodalVector recover(const Discretization<2> &,
                             const StiffnessInverse &,
                             const MotionModes<2> &,
                             const DistributedVector &,
                             const LevelSolution<2> &);
template void correct_rounding(const Parameters &,
                               const Discretization<2> &,
                               const StiffnessInverse &,
                               const MotionModes<2> &,
                               const DistributedVector &,
                               Pressure &,
                               LevelSolution<2> &);
template Pressure find_pressure(const Parameters &,
                                const Discretization<3> &,
                                const StiffnessInverse &,
                                const MotionModes<3> &,
                                const dealii::Vector<double> &,
                                const Progress &,
                                LevelSolution<3> &);
template NodalVector recover(const Discretization<3> &,
                             const StiffnessInverse &,
                             const MotionModes<3> &,
                             const DistributedVector &,
                             const LevelSolution<3> &);
template void correct_rounding(const Parameters &,
                               const Discretization<3> &,
                               const StiffnessInverse &,
                               const MotionModes<3> &,
                               const DistributedVector &,
                               Pressure &,
                               LevelSolution<3> &);
} // namespace Signorini
