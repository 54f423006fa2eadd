// SPDX-License-Identifier: LGPL-2.1-or-later
// Functions of V^h with given normal components at contact nodes.

#include <signorini/error_control/bound/contact_lift.h>
#include <signorini/solvers/contact/active_set.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/stiffness/stiffness_multigrid.h>

#include <deal.II/lac/linear_operator.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;

/** The columns E of those conditions at contact nodes that A⁻¹ lets move. In pairs they are those
 * on the carrier: forces at its nodes would bend the other body between these. @param all whether
 * w_t is given at all nodes, not only next to faces that stick. */
struct MovingNodes {
  MovingNodes(const DisplacementSpace<2> &space, const ContactTrace &trace, const bool all)
    : E(select(space, trace, all)) {}

  /** The numbers of the columns among ContactTrace::conditions(). */
  std::vector<unsigned int> numbers;
  Coupling E;

private:
  Coupling select(const DisplacementSpace<2> &space, const ContactTrace &trace, const bool all) {
    // Pins hold the body while A is solved: the free parts of two normals of a pinned node are
    // dependent.
    const auto is_pinned = [&](const Coupling::Column::value_type &entry) {
      return space.constraints().is_constrained(entry.first);
    };
    std::vector<Coupling::Column> columns;
    for (unsigned int k = 0; k < trace.conditions().size(); ++k) {
      const NodeCondition &condition = trace.conditions()[k];
      const Coupling::Column &column = condition.own;
      if ((all || condition.is_normal() || condition.presses) && !condition.held() &&
          !condition.yields_across && std::none_of(column.begin(), column.end(), is_pinned)) {
        numbers.push_back(k);
        columns.push_back(column);
      }
    }
    return Coupling(std::move(columns));
  }
};

/** Moves w along a part of a column a of E, that on the carrier, until a.w has the value, or with
 * @p only_raise not less. @return by how much a.w was too small. */
template <typename VectorType>
double adjust(const Coupling::Column &a, const Coupling::Column &own, const double value,
              const bool only_raise, VectorType &w) {
  double residual = value, slope = 0.;
  for (const auto &[row, factor] : a)
    residual -= factor * w[row];
  for (const auto &[row, factor] : own)
    if (const auto in_a = a.find(row); in_a != a.end())
      slope += factor * in_a->second;
  if (!(slope > 0.) || (only_raise && residual <= 0.))
    return 0.;
  for (const auto &[row, factor] : own)
    w[row] += residual / slope * factor;
  return residual;
}

/** Moves w at contact nodes until w_n and w_t are the targets; with @p only_raise w_n is not below
 * them, and w_t counts next to faces that stick: along one direction after the other, which takes
 * several rounds where two normals meet in a corner. @return whether the rounds were enough. */
bool impose(const ContactTrace &trace, const Vector &targets, const bool only_raise,
            Displacement &w) {
  constexpr unsigned int max_rounds = 10000;
  const double tolerance = 1e-14 * targets.linfty_norm();
  for (unsigned int round = 0; round < max_rounds; ++round) {
    double largest = 0.;
    for (unsigned int k = 0; k < targets.size(); ++k) {
      const NodeCondition &condition = trace.conditions()[k];
      if (condition.is_normal() || condition.presses || !only_raise)
        largest = std::max(largest, std::abs(adjust(condition.column, condition.own, targets[k],
                                                    only_raise && condition.is_normal(), w)));
    }
    if (largest <= tolerance)
      return true;
  }
  return false;
}

/**
 * Returns a w with nearly the least J(w) = 1/2 a(w, w) - f.w among functions with w_n ≥ required at
 * the nodes, where A⁻¹ iterates: the primal-dual active set method. Each set of nodes that are held
 * takes a few steps of conjugate gradients from the w of the set before; their number doubles from
 * set to set.
 * @param held the nodes to begin with.
 */
Displacement relaxed_displacement(const BoundData &data, const Coupling &E, const Vector &required,
                                  const DualVector &f, std::vector<bool> held,
                                  const unsigned int max_sets) {
  constexpr unsigned int max_steps = 80;
  constexpr double tolerance = 0.03;
  unsigned int n_steps = 5;
  const StiffnessOperator &A = *data.inverse.cycles();
  DualVector w = A.make_vector(), g(w);
  double last_J = std::numeric_limits<double>::infinity();
  for (unsigned int n_sets = 0; n_sets < max_sets; ++n_sets) {
    // Nodes are held in both directions: two normals that meet in one may be nearly parallel.
    std::vector<types::global_dof_index> rows;
    for (unsigned int k = 0; k < held.size(); ++k)
      if (held[k]) {
        adjust(E.column(k), E.column(k), required[k], false, w);
        for (const auto &entry : E.column(k))
          rows.push_back(entry.first);
      }
    const auto clear = [&rows](DualVector &v) {
      for (const auto row : rows)
        v[row] = 0.;
    };
    LinearOperator<DualVector> K, V;
    K.vmult = [&](DualVector &y, const DualVector &x) {
      A.vmult(y, x);
      clear(y);
    };
    V.vmult = [&](DualVector &z, const DualVector &r) {
      A.precondition(z, r);
      clear(z);
    };
    K.vmult(g, w);
    g -= f;
    clear(g);
    // Where V-cycles are exact, more steps would end with 0/0.
    IterationNumberControl control(n_steps, 1e-8 * g.l2_norm());
    g = f;
    clear(g);
    SolverCG<DualVector>(control).solve(K, w, g, V);
    A.vmult(g, w);
    const double energy = w * g, J = 0.5 * energy - f * w;
    if (std::abs(J - last_J) <= tolerance * energy)
      break;
    // Far from the w of its set the signs of Q are accidental, and rounding decides which sets
    // follow. Long bodies take many steps, and each start forgets the directions of the last one.
    if (n_sets > 0)
      n_steps = std::min(max_steps, 2 * n_steps);
    last_J = J;
    g.sadd(-1., 1., f);
    Vector closing = required;
    closing -= E.transpose_product(w);
    held = next_set(held, E.transpose_product(g), closing);
  }
  Displacement result = data.space.zero();
  std::copy(w.begin(), w.end(), result.begin());
  return result;
}

/** Returns the solution of the dual problem of nodal_lift(). @param of_carriers the values required
 * of the carriers' own w_n. @param touches receives the nodes at which it has them; rounding of A⁻¹
 * may lift them. */
Displacement pressed_displacement(const BoundData &data, const ContactTrace &trace,
                                  const Vector &of_carriers, std::vector<bool> &touches) {
  DualVector forces = data.space.make_vector();
  // Where friction slips, its force does the work that s |ũ_t - g_t - w_t| loses.
  const Pressure &P_n = data.P.normal();
  Vector P(P_n);
  if (data.has_tangential_part())
    P = join(P_n, Vector(P_n.size()));
  data.condensed_D.add_product(P, forces);
  for (const types::global_dof_index dof : trace.dofs_across())
    forces[dof] = 0.;
  const MovingNodes nodes(data.space, trace, false);
  Vector required(nodes.numbers.size()), start(required.size());
  std::vector<bool> held;
  std::vector<Interval> intervals;
  for (unsigned int i = 0; i < required.size(); ++i) {
    const NodeCondition &condition = trace.conditions()[nodes.numbers[i]];
    intervals.push_back(
      {Interval().lower, condition.is_normal() ? 0. : std::numeric_limits<double>::infinity()});
    required[i] = of_carriers[nodes.numbers[i]];
    if (condition.presses)
      start[i] = -P_n.linfty_norm() * trace.faces()[0].length();
    held.push_back(condition.presses || required[i] > 0.);
  }
  if (!data.inverse.has_factors())
    return relaxed_displacement(data, nodes.E, required, forces, held, 10);
  if (!held.empty()) {
    Vector F = nodes.E.transpose_product(solve_homogeneous(data.inverse, data.space, forces));
    F -= required;
    // Any w is admissible that is raised afterwards: where nodes lie so close that their compliance
    // is singular, a few sweeps have to do.
    DualSolverOptions options;
    options.maximum_iterations = 300;
    Vector minus_Q = solve_dual_problem(make_compliance(data.inverse, nodes.E), F,
                                        AdmissibleSet(intervals), start, options)
                       .P;
    minus_Q *= -1.;
    for (unsigned int i = 0; i < F.size(); ++i)
      touches[nodes.numbers[i]] =
        minus_Q[i] > 0. || !trace.conditions()[nodes.numbers[i]].is_normal();
    nodes.E.add_product(minus_Q, forces);
  }
  return solve_homogeneous(data.inverse, data.space, forces);
}

/** Returns the part of a.w that is not the carrier's own. */
double motion_across(const NodeCondition &condition, const Displacement &w) {
  double motion = 0.;
  for (const auto &[row, factor] : condition.column)
    motion += factor * w[row];
  for (const auto &[row, factor] : condition.own)
    motion -= factor * w[row];
  return motion;
}

/** Returns A⁻¹ E Q with Eᵀ A⁻¹ E Q = targets. Where columns of C cost solves, its products cost
 * fewer. */
Displacement pushed_displacement(const BoundData &data, const Coupling &E, const Vector &targets) {
  Vector Q(E.n_columns());
  if (!data.inverse.has_factors())
    return relaxed_displacement(data, E, targets, data.space.make_vector(),
                                std::vector<bool>(targets.size(), true), 1);
  const auto pushed_by = [&](const Vector &Q_E) {
    DualVector forces = data.space.make_vector();
    E.add_product(Q_E, forces);
    Displacement w = data.space.zero();
    data.inverse.solve_once(w, forces);
    data.space.distribute_homogeneous(w);
    return w;
  };
  const auto known = make_compliance(data.inverse, E);
  LinearOperator<Vector> C;
  C.vmult = [&](Vector &y, const Vector &x) {
    y = known->is_explicit() ? known->apply(x) : E.transpose_product(pushed_by(x));
  };
  // Any Q would do: the residuals are imposed.
  IterationNumberControl control(1000, 1e-4 * targets.l2_norm());
  SolverCG<Vector>(control).solve(C, Q, targets, PreconditionIdentity());
  return pushed_by(Q);
}
} // namespace

std::optional<Displacement> nodal_lift(const BoundData &data, const ContactTrace &trace) {
  Vector required(trace.conditions().size());
  for (unsigned int k = 0; k < required.size(); ++k)
    required[k] = trace.conditions()[k].required;
  std::vector<bool> touches;
  Displacement w = data.space.zero();
  // Where w moves the body across, because other nodes ask for that, the carrier has to follow.
  constexpr unsigned int max_rounds = 8;
  Vector of_carriers = required, last;
  for (unsigned int round = 0; round < max_rounds; ++round) {
    touches.assign(required.size(), false);
    w = pressed_displacement(data, trace, of_carriers, touches);
    last = of_carriers;
    for (unsigned int k = 0; k < required.size(); ++k)
      of_carriers[k] = required[k] - motion_across(trace.conditions()[k], w);
    last -= of_carriers;
    // Any w is raised afterwards.
    if (last.linfty_norm() <= 1e-6 * of_carriers.linfty_norm())
      break;
  }
  // This corrects the remainder of the solver's tolerance, and pins.
  for (unsigned int k = 0; k < required.size(); ++k)
    if (touches[k])
      adjust(trace.conditions()[k].column, trace.conditions()[k].own, required[k], false, w);
  if (!impose(trace, required, true, w))
    return {};
  data.space.distribute_without_pins(w);
  return w;
}

std::optional<double> norm_of_unit_lift(const BoundData &data, const ContactTrace &trace) {
  const auto &conditions = trace.conditions();
  if (conditions.empty() || !trace.prescribes_all() || trace.mixes() ||
      std::any_of(conditions.begin(), conditions.end(),
                  [](const auto &c) { return c.is_normal() && c.held(); }))
    return {};
  const MovingNodes nodes(data.space, trace, true);
  Vector targets(conditions.size()), moving(nodes.numbers.size());
  for (unsigned int k = 0; k < targets.size(); ++k)
    targets[k] = conditions[k].is_normal() ? 1. : 0.;
  for (unsigned int i = 0; i < moving.size(); ++i)
    moving[i] = targets[nodes.numbers[i]];
  Displacement z = pushed_displacement(data, nodes.E, moving);
  if (!impose(trace, targets, false, z))
    return {};
  data.space.distribute_without_pins(z);
  // On the carriers alone z_n is 1 between nodes, too.
  for (const types::global_dof_index dof : trace.dofs_across())
    if (z[dof] != 0.)
      return {};
  const double local = LiftField(data, trace, std::move(z)).cell_energies().l1_norm();
  return std::sqrt(Utilities::MPI::sum(local, data.space.mesh().communicator()));
}
} // namespace Signorini
