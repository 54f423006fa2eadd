// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact by the dual problem: A, its inverse, F and C = Dᵀ A⁻¹ D, P and q, then U.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/discretization.h>
#include <signorini/discretization/space/trace_values.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/free_motions.h>
#include <signorini/solvers/contact/motion_modes.h>
#include <signorini/solvers/stiffness/cellwise_inverse.h>
#include <signorini/solvers/stiffness/stiffness_multigrid.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "methods.h"

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;

/** Free motions with B of forces at points of the contact boundary, and the set of these forces. */
struct PointMotions {
  FreeMotions motions;
  AdmissibleSet admissible;
};

/** Returns the motions with forces at the ends of all pieces. */
template <int dim>
PointMotions with_forces_at_points(FreeMotions motions, const Discretization<dim> &discretization,
                                   const MotionModes<dim> &modes) {
  const ContactSurface<dim> &surface = discretization.surface;
  std::vector<Point<dim - 1>> ends;
  for (unsigned int v = 0; v < GeometryInfo<dim - 1>::vertices_per_cell; ++v)
    ends.push_back(GeometryInfo<dim - 1>::unit_cell_vertex(v));
  const unsigned int m = discretization.multipliers.n_multipliers(),
                     n = ends.size() * surface.pieces().size();
  const AdmissibleSet &K = discretization.K;
  const bool has_tangential_part = K.has_tangential_part();
  TraceValues<dim> traces(discretization.space);
  motions.B.reinit(has_tangential_part ? 2 * n : n, modes.size());
  Vector s(n), f(n);
  for (std::size_t i = 0; i < surface.pieces().size(); ++i) {
    const Piece<dim> &piece = surface.pieces()[i];
    const SurfaceRule<dim> rule = surface.at(piece, ends);
    for (unsigned int j = 0; j < modes.size(); ++j) {
      const auto z = traces.displacement(surface, piece, rule, modes.Z[j]);
      for (std::size_t e = 0; e < ends.size(); ++e) {
        motions.B(ends.size() * i + e, j) = z[e] * rule.directions[e];
        if (has_tangential_part)
          motions.B(n + ends.size() * i + e, j) =
            z[e] * direction_of(Component::tangential, rule.directions[e]);
      }
    }
    for (std::size_t e = 0; has_tangential_part && e < ends.size(); ++e) {
      s[ends.size() * i + e] = 0.5 * (piece.upper[0] - piece.lower[0]) * K[m + piece.patch].upper;
      f[ends.size() * i + e] = K.coefficient(m + piece.patch);
    }
  }
  return {std::move(motions), has_tangential_part ? AdmissibleSet::with_tangential_part(s, f)
                                                  : AdmissibleSet::nonpositive(n)};
}

/** Returns the largest diagonal entry of K; one if K has no positive entry. */
double typical_stiffness(const FreeMotions &motions) {
  double stiffness = 0.;
  for (unsigned int j = 0; j < motions.K.m(); ++j)
    stiffness = std::max(stiffness, motions.K(j, j));
  return stiffness > 0. ? stiffness : 1.;
}

/** Returns whether forces at points of the contact boundary can balance the loads, and those in the
 * middles of patches cannot. */
template <int dim>
bool points_balance(const Discretization<dim> &discretization, const MotionModes<dim> &modes,
                    const FreeMotions &motions) {
  const PointMotions at_points = with_forces_at_points(motions, discretization, modes);
  const double stiffness = typical_stiffness(motions);
  return ReducedMotions(motions, discretization.K, stiffness).escape &&
         !ReducedMotions(at_points.motions, at_points.admissible, stiffness).escape;
}

/** Refuses loads that drive a motion along which contact sides slide. @throws InputError always. */
template <int dim>
[[noreturn]] void refuse_sliding(const Parameters &parameters, const RigidMotion<dim> &motion) {
  throw InputError(parameters.boundary.where + ": the loads drive " + motion.name() +
                   " of the body, along which contact sides slide without friction; allowed: "
                   "loads in balance, or more sides that hold the body.");
}

/** Returns a motion of the body that the pressing patches leave free, where no load works in
 * motions and only a negative gap presses; none if there is none. */
template <int dim>
std::optional<RigidMotion<dim>> motion_left_free(const Parameters &parameters,
                                                 const Discretization<dim> &discretization,
                                                 const LevelOperators<dim> &operators,
                                                 const FreeMotions &motions, const Vector &F,
                                                 const Vector &P) {
  const unsigned int m = discretization.multipliers.n_multipliers();
  constexpr double rounding = 1e-10;
  const double touches = rounding * std::max(discretization.G.linfty_norm(), F.linfty_norm());
  // Loads in balance strain the body, wherever it comes to rest.
  if (!motions.b_magnitude.all_zero() ||
      std::none_of(F.begin(), F.begin() + m, [&](double F_k) { return F_k < -touches; }))
    return {};
  // A body that has lifted off keeps pressures of the size of rounding, or of the tolerance: its
  // KKT residual compares C_ii P_i with F. They hold nothing. Friction holds with its bound,
  // however little of it is needed.
  const double negligible = std::max<double>(rounding, parameters.solver.tolerance) * F.l2_norm();
  Vector holding(P);
  const AdmissibleSet K = discretization.K.at(P);
  for (unsigned int i = m; i < P.size(); ++i)
    holding[i] = K[i].upper;
  const Vector closing = operators.C->diagonal_times(holding);
  FreeMotions pressing_motions = motions;
  for (unsigned int i = 0; i < P.size(); ++i)
    for (unsigned int j = 0; j < motions.b.size() && std::abs(closing[i]) <= negligible; ++j)
      pressing_motions.B(i, j) = 0.;
  const auto neutral =
    ReducedMotions(pressing_motions, discretization.K, typical_stiffness(motions)).neutral;
  return neutral.empty() ? std::nullopt
                         : std::optional(rigid_part(operators.modes, neutral.front()));
}

/** Refuses a motion that the pressing patches leave free. @throws InputError always. */
template <int dim>
[[noreturn]] void refuse_undetermined(const Parameters &parameters, const RigidMotion<dim> &motion,
                                      const bool has_friction) {
  throw InputError(parameters.boundary.where +
                   ": no load moves the body, and the pressure of the foundation, into which it "
                   "begins, leaves " +
                   motion.name() + " free" +
                   (has_friction ? ", along which friction is too weak to hold it; allowed: "
                                   "more friction, "
                                 : "; allowed: ") +
                   "loads that press the body onto the foundation, or more sides that hold it.");
}

/** Returns whether later levels may have other patches, which determine more motions. */
template <int dim>
bool is_refined_later(const Parameters &parameters, const Discretization<dim> &discretization) {
  const DiscretizationParameters &given = parameters.discretization;
  return given.strategy != Strategy::hp && discretization.mesh.level() < given.finest_level;
}

/** Returns whether there is friction, and a larger coefficient would balance the loads. */
bool larger_bound_could_hold(const AdmissibleSet &K, const FreeMotions &motions) {
  constexpr double large = 1e3;
  if (!K.has_tangential_part())
    return false;
  Vector s(K.n_normal()), f(K.n_normal());
  f = large;
  return !ReducedMotions(motions, AdmissibleSet::with_tangential_part(s, f),
                         typical_stiffness(motions))
            .escape;
}

/**
 * Refuses a motion v of the body that nothing stops. Piecewise constant pressures carry forces
 * between the middles of patches only: where pressures at points of the contact boundary would
 * balance the loads, the mesh is too coarse, and the message says that.
 * @throws InputError always.
 */
template <int dim>
[[noreturn]] void refuse_escape(const Parameters &parameters,
                                const Discretization<dim> &discretization,
                                const MotionModes<dim> &modes, const FreeMotions &motions,
                                const Vector &v, const std::optional<Sliding> &sliding) {
  const RigidMotion<dim> motion = rigid_part(modes, v);
  if (sliding) {
    const RigidMotion<dim> along = rigid_part(modes, sliding->v);
    // Forces of the whole body for a motion of unit size.
    double unit = 0.;
    for (const BodyMotion<dim> &body : along.bodies)
      unit = std::max({unit, body.translation.norm(), size_of(body.rotation) / body.size});
    unit /= discretization.surface.scene().geometry.thickness;
    throw InputError(
      parameters.boundary.where + ": the body slides " + along.direction() +
      ": friction carries at most " + number_text(sliding->resistance / unit) +
      ", the loads pull with " + number_text(sliding->load / unit) + "; allowed: more friction" +
      (sliding->resistance > 0.
         ? " (at least " + number_text(sliding->load / sliding->resistance) + " times as much)"
         : "") +
      ", loads that press the body onto the foundation, or "
      "more sides that hold it.");
  }
  if (points_balance(discretization, modes, motions)) {
    const Given<unsigned int> &coarsest = parameters.discretization.coarsest_level;
    throw InputError(coarsest.where() + ": found '" + std::to_string(coarsest.value) +
                     "', where a contact patch carries forces in its middle only and the loads "
                     "act closer to the end of contact (the body would move " +
                     motion.direction() + "), allowed: a finer coarsest level.");
  }
  const bool is_slippery = larger_bound_could_hold(discretization.K, motions);
  throw InputError(
    parameters.boundary.where + ": the loads move the body " + motion.direction() + ", and no " +
    (is_slippery ? "pressure with so little friction" : "pressure of the foundation") +
    " balances them (" +
    text_of_escape(motion, opens(motions.B, v, discretization.multipliers.n_multipliers())) +
    "); allowed: " + (is_slippery ? "more friction, " : "") +
    "loads that press it onto the foundation, or more sides that hold it.");
}

DualSolve summary_of(const QPResult &result, const ContactSolver method) {
  DualSolve summary;
  summary.method = method;
  summary.iterations = result.iterations;
  if (method == ContactSolver::psor)
    summary.increment_iterations = result.increment_iterations;
  summary.kkt = result.kkt_residual;
  summary.converged = result.converged;
  summary.by_path = result.by_path;
  summary.unique = result.unique;
  summary.active_set_failure = result.active_set_failure;
  return summary;
}

/** Returns a callback that reports every twentieth part of the columns of C. */
ColumnProgress column_progress(const Progress &progress, const unsigned int n_columns) {
  const unsigned int every = std::max(1U, n_columns / 20);
  return [progress, every, n_columns](const unsigned int done) {
    if (done % every == 0)
      progress("compliance: " + std::to_string(done) + " columns, up to " +
               std::to_string(n_columns));
  };
}

/** Returns the names of the motions that contact does not resist. @throws InputError if loads drive
 * one of them. */
template <int dim>
std::vector<std::string> undetermined_motions(const Parameters &parameters,
                                              const std::vector<Plate<dim>> &plates,
                                              const LevelOperators<dim> &operators) {
  const MotionModes<dim> &modes = operators.modes;
  std::vector<std::string> names;
  if (modes.neutral.empty())
    return names;
  if (const auto driven = modes.driven_neutral(plates, operators.system->loads))
    refuse_sliding(parameters, *modes.neutral[*driven].rigid);
  for (const FreeMotion<dim> &motion : modes.neutral)
    names.push_back(motion.rigid->name());
  return names;
}

/** Returns the estimated algebraic error in the energy norm. */
double algebraic_part(const ComplianceOperator &C, const ContactSolution &contact) {
  const Vector &P = contact.P.values(), &W = contact.W;
  // Where nothing presses nor penetrates, a column of C may cost a solve.
  Vector counted(P.size());
  for (unsigned int k = 0; k < counted.size(); ++k)
    counted[k] = P[k] != 0. || W[k] > 0. ? 1. : 0.;
  return algebraic_error(contact.P.set(), P, W, C.diagonal_times(counted));
}

template <int dim>
class DualMethod final : public ContactMethod<dim> {
public:
  DualMethod(const Parameters &parameters, const Scene<dim> &scene, const SolverChoice &choice)
    : parameters_(parameters)
    , scene_(scene)
    , choice_(choice) {}

  LevelOperators<dim> make_operators(const Discretization<dim> &discretization,
                                     const Progress &progress) const override {
    const DisplacementSpace<dim> &space = discretization.space;
    const Coupling &D = discretization.condensed_D;
    // Cells of degree two have few unknowns inside; files of A have all of them.
    const bool is_condensed = space.max_element_degree() > 2 && !parameters_.output.compliance;
    StageTimes times;
    progress("assembly");
    const auto system = timed(times.assembly, [&]() {
      return std::make_shared<const LinearSystem<dim>>(
        choice_.is_matrix_free()
          ? assemble_right_hand_side(space, scene_, discretization.n_points,
                                     space.complete(space.zero()))
          : assemble_linear_system(space, scene_, discretization.n_points, is_condensed));
    });
    progress("factorisation");
    const std::shared_ptr<const StiffnessInverse> inverse =
      timed(times.factor, [&]() -> std::unique_ptr<StiffnessInverse> {
        if (choice_.is_matrix_free())
          return make_multigrid_inverse(space, scene_, solve_tolerance);
        return make_stiffness_inverse(*system, space, choice_.linear, contact_unknowns(D));
      });
    MotionModes<dim> modes =
      timed(times.compliance, [&]() { return make_motion_modes(space, scene_, *inverse); });
    const auto C = timed(times.compliance, [&]() {
      return make_compliance(*inverse, D, column_progress(progress, D.n_columns()));
    });
    return {system, inverse, std::move(modes), C, times};
  }

  ContactSolution solve(const Discretization<dim> &discretization,
                        const LevelOperators<dim> &operators, const ContactStart &start,
                        const Progress &progress) const override {
    const MotionModes<dim> &modes = operators.modes;
    StageTimes times = operators.times;
    DualData data =
      timed(times.compliance, [&]() { return free_of_contact(discretization, operators); });
    const std::vector<std::string> undetermined =
      undetermined_motions(parameters_, scene_.plates, operators);
    ContactSolution contact;
    if (modes.size() == 0 && data.free.nothing_touches(discretization.K)) {
      contact.P = Multiplier(Vector(discretization.K.size()), discretization.K);
      contact.U = data.free.U;
      contact.W = discretization.gap_residual(contact.U);
    } else {
      progress("dual problem");
      contact = press_without_rounding(discretization, operators, data, start.P, times);
      contact.algebraic_error = algebraic_part(*operators.C, contact);
    }
    if (modes.size() > 0) {
      // U_0 + Z q is then the body without contact.
      modes.add_to(data.free.U, contact.q);
      Vector B_q(data.F.size());
      data.motions.B.vmult(B_q, contact.q);
      data.free.F -= B_q;
    }
    contact.undetermined.insert(contact.undetermined.begin(), undetermined.begin(),
                                undetermined.end());
    contact.data = std::move(data);
    contact.times = times;
    contact.linear = {operators.inverse->n_solves(), operators.inverse->max_residual(),
                      operators.inverse->rounding_error()};
    return contact;
  }

private:
  /** Returns the body without contact, and the free motions. */
  DualData free_of_contact(const Discretization<dim> &discretization,
                           const LevelOperators<dim> &operators) const {
    const auto &[system, modes] = std::tie(*operators.system, operators.modes);
    DualData data;
    data.free = solve_free_state(*operators.inverse, discretization.space, system.f,
                                 discretization.D, discretization.G);
    data.F = data.free.F;
    if (modes.size() > 0) {
      const MotionWork work = modes.work(scene_.plates, system.loads, data.free.U);
      data.motions = {modes.couple(discretization.D), modes.K, work.value, work.magnitude};
    }
    return data;
  }

  /** Solves the dual problem with the opening F, and computes U = A⁻¹(f + D P) + Z q. */
  ContactSolution press(const Discretization<dim> &discretization,
                        const LevelOperators<dim> &operators, const FreeMotions &motions,
                        const Vector &F, const Vector &start, StageTimes &times) const {
    ContactSolution contact;
    {
      const StageTimer timer(times.qp);
      const MotionResult found =
        solve_dual_problem(operators.C, F, discretization.K, motions, start,
                           dual_options(parameters_.solver, is_unstable(discretization)));
      if (found.escape)
        refuse_escape(parameters_, discretization, operators.modes, motions, *found.escape,
                      found.sliding);
      for (const Vector &v : found.neutral)
        contact.undetermined.push_back(rigid_part(operators.modes, v).name());
      if (operators.modes.size() > 0)
        if (const auto left =
              motion_left_free(parameters_, discretization, operators, motions, F, found.qp.P)) {
          if (!is_refined_later(parameters_, discretization))
            refuse_undetermined(parameters_, *left, discretization.K.has_tangential_part());
          contact.undetermined.push_back(left->name());
        }
      contact.q = found.q;
      contact.report = summary_of(found.qp, choice_.contact);
      contact.P = Multiplier(found.qp.P, discretization.K);
      contact.C_P = operators.C->apply(found.qp.P);
      contact.diagonal_P = operators.C->diagonal_times(found.qp.P);
    }
    const StageTimer timer(times.recovery);
    contact.U =
      recover_displacement(*operators.inverse, discretization.space, discretization.condensed_D,
                           contact.P.values(), operators.system->f);
    operators.modes.add_to(contact.U, contact.q);
    contact.W = discretization.gap_residual(contact.U);
    return contact;
  }

  /**
   * Presses, and corrects the effect of rounding on C, by which the openings from U and from C
   * differ: Dᵀ U - G is C P + B q - F + r. F - r replaces F, up to three times. Without
   * rounding r is zero, however P was found.
   */
  ContactSolution press_without_rounding(const Discretization<dim> &discretization,
                                         const LevelOperators<dim> &operators, const DualData &data,
                                         const Vector &start, StageTimes &times) const {
    constexpr unsigned int max_passes = 3;
    // A solve that was given up would be given up again.
    constexpr double negligible = 1e-12, hopeless = 1e-4;
    const double measure = discretization.multipliers.integrals().l2_norm();
    Vector F = data.F;
    ContactSolution contact = press(discretization, operators, data.motions, F, start, times);
    const DualSolve first = contact.report;
    for (unsigned int pass = 0; pass < max_passes && contact.report.kkt < hopeless; ++pass) {
      // F - r = C P + B q - W
      Vector corrected(contact.C_P);
      if (operators.modes.size() > 0)
        data.motions.B.vmult_add(corrected, contact.q);
      corrected -= contact.W;
      Vector r(corrected);
      r -= F;
      if (r.l2_norm() <= negligible * measure * contact.U.linfty_norm())
        break;
      F = corrected;
      contact = press(discretization, operators, data.motions, F, contact.P.values(), times);
    }
    // The product with C has the same correction.
    contact.C_P -= F;
    contact.C_P += data.F;
    // Corrections begin with the P that the first solve found, and are not counted.
    contact.report.iterations = first.iterations;
    contact.report.increment_iterations = first.increment_iterations;
    contact.report.by_path = first.by_path;
    return contact;
  }

  const Parameters &parameters_;
  const Scene<dim> &scene_;
  SolverChoice choice_;
};
} // namespace

template <int dim>
std::unique_ptr<ContactMethod<dim>> make_dual_method(const Parameters &parameters,
                                                     const Scene<dim> &scene,
                                                     const SolverChoice &choice) {
  return std::make_unique<DualMethod<dim>>(parameters, scene, choice);
}

DualSolverOptions dual_options(const SolverParameters &solver, const bool may_be_singular) {
  return {{solver.tolerance, solver.maximum_iterations, solver.relaxation},
          solver.contact_solver,
          may_be_singular};
}

template <int dim>
std::optional<Vector> solve_on_other_patches(const LevelOperators<dim> &operators,
                                             FreeMotions motions, const Vector &q,
                                             const CouplingPair &patches, const Vector &F,
                                             const Vector &start) {
  const auto C = make_compliance(*operators.inverse, patches.condensed_D);
  if (operators.modes.size() > 0) {
    motions.B = operators.modes.couple(patches.D);
    Vector K_q(q.size());
    motions.K.vmult(K_q, q);
    motions.b -= K_q;
  }
  const QPResult result =
    solve_dual_problem(C, F, AdmissibleSet::nonpositive(F.size()), motions, start, {}).qp;
  return result.converged ? std::optional<Vector>(result.P) : std::nullopt;
}

INSTANTIATE_FUNCTION(solve_on_other_patches);
INSTANTIATE_FUNCTION(make_dual_method);
} // namespace Signorini
