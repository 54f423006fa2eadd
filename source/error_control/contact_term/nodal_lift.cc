// SPDX-License-Identifier: LGPL-2.1-or-later
// Functions of V^h with given normal components at contact nodes.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/contact_term/contact_lift.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <deal.II/base/function.h>
#include <deal.II/lac/linear_operator.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;

/** The number of contact nodes up to which columns of C are solved for where A⁻¹ iterates. */
constexpr unsigned int max_solved_nodes = 200;

/** Returns whether C is used, and not a layer. */
bool is_cheap(const StiffnessInverse &inverse, const ContactTrace &trace) {
  return inverse.has_factors() || trace.conditions().size() <= max_solved_nodes;
}

/** The columns E of those conditions at contact nodes that A⁻¹ lets move, and C = Eᵀ A⁻¹ E. */
class NodalCompliance {
public:
  NodalCompliance(const BoundData &data, const ContactTrace &trace)
    : E_(select(data.space, trace))
    , C_(numbers_.empty() ? nullptr : make_compliance(data.inverse, E_, seconds_)) {}
  NodalCompliance(const NodalCompliance &) = delete;

  /** Returns the numbers of the columns of E among ContactTrace::conditions(). */
  const std::vector<unsigned int> &numbers() const {
    return numbers_;
  }
  const Coupling &E() const {
    return E_;
  }
  const std::shared_ptr<const ComplianceOperator> &C() const {
    return C_;
  }

private:
  Coupling select(const DisplacementSpace<2> &space, const ContactTrace &trace) {
    // Pins hold the body while A is solved: what is left of two normals of a pinned node is
    // dependent.
    const auto is_pinned = [&](const Coupling::Column::value_type &entry) {
      return space.constraints().is_constrained(entry.first);
    };
    std::vector<Coupling::Column> columns;
    for (unsigned int k = 0; k < trace.conditions().size(); ++k)
      if (const Coupling::Column &column = trace.conditions()[k].column;
          !column.empty() && std::none_of(column.begin(), column.end(), is_pinned)) {
        numbers_.push_back(k);
        columns.push_back(column);
      }
    return Coupling(std::move(columns));
  }

  std::vector<unsigned int> numbers_;
  Coupling E_;
  double seconds_ = 0.;
  std::shared_ptr<const ComplianceOperator> C_;
};

/** Moves w at contact nodes until w_n are the targets, or with @p only_raise not below them: along
 * one normal after the other, which takes several rounds where two of them meet in a corner.
 * @return whether the rounds were enough. */
bool impose(const ContactTrace &trace, const Vector &targets, const bool only_raise,
            Displacement &w) {
  constexpr unsigned int max_rounds = 10000;
  const double tolerance = 1e-14 * targets.linfty_norm();
  for (unsigned int round = 0; round < max_rounds; ++round) {
    double largest = 0.;
    for (unsigned int k = 0; k < targets.size(); ++k) {
      double lacking = targets[k], square = 0.;
      for (const auto &[row, factor] : trace.conditions()[k].column) {
        lacking -= factor * w[row];
        square += factor * factor;
      }
      if (square == 0. || (only_raise && lacking <= 0.))
        continue;
      largest = std::max(largest, std::abs(lacking));
      for (const auto &[row, factor] : trace.conditions()[k].column)
        w[row] += lacking / square * factor;
    }
    if (largest <= tolerance)
      return true;
  }
  return false;
}

/** The sum over the contact sides of ω (1 - y/D)_+ n, with ω and n of the nearest contact node of
 * the side at the distance y. */
class Layers {
public:
  Layers(const Scene<2> &scene, const ContactTrace &trace, const Vector &omega)
    : trace_(trace)
    , omega_(omega) {
    for (const unsigned int side : scene.contact_sides()) {
      double squares = 0., slopes = 0.;
      std::vector<Node> nodes;
      for (const PenetrationFace &face : trace.faces())
        if (face.side == side) {
          const double a = omega[face.conditions[0]], b = omega[face.conditions[1]];
          squares += stretch_to_shear(scene, face) * face.length * (a * a + a * b + b * b);
          slopes += (b - a) * (b - a) / face.length;
          for (const unsigned int k : face.conditions)
            nodes.emplace_back(trace.conditions()[k].point, k);
        }
      const double extent = scene.geometry.shortest_extent();
      Layer &layer = layers_.emplace_back(
        Layer{slopes > 0. ? std::min(extent, std::sqrt(squares / slopes)) : extent,
              pack_rtree(nodes),
              {}});
      std::vector<Point<2>> points;
      for (const Node &node : nodes)
        points.push_back(node.first);
      layer.box = BoundingBox<2>(points);
      layer.box.extend(layer.depth);
    }
  }

  /** Returns the function at the nodes. */
  Displacement interpolate(const DisplacementSpace<2> &space) const {
    Displacement w = space.zero();
    std::vector<bool> is_done(space.mesh().triangulation().n_vertices(), false);
    for (const auto &cell : space.dofs().active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (!is_done[cell->vertex_index(v)]) {
          is_done[cell->vertex_index(v)] = true;
          const Tensor<1, 2> value = at(cell->vertex(v));
          for (unsigned int d = 0; d < 2; ++d)
            w[cell->vertex_dof_index(v, d)] = value[d];
        }
    return w;
  }

private:
  using Node = std::pair<Point<2>, unsigned int>;
  struct Layer {
    double depth;
    RTree<Node> nodes;
    /** The function vanishes outside of it. */
    BoundingBox<2> box;
  };

  Tensor<1, 2> at(const Point<2> &x) const {
    namespace index = boost::geometry::index;
    Tensor<1, 2> value;
    for (const Layer &layer : layers_)
      if (layer.box.point_inside(x))
        for (const auto &[node, k] : layer.nodes | index::adaptors::queried(index::nearest(x, 1)))
          value += omega_[k] * std::max(0., 1. - x.distance(node) / layer.depth) *
                   trace_.conditions()[k].normal;
    return value;
  }

  const ContactTrace &trace_;
  const Vector &omega_;
  std::vector<Layer> layers_;
};

/** Returns the solution of the dual problem of nodal_lift(). */
Displacement pressed_displacement(const BoundData &data, const ContactTrace &trace) {
  DistributedVector forces = data.space.make_vector();
  data.condensed_D.add_product(data.P, forces);
  const NodalCompliance nodal(data, trace);
  if (!nodal.numbers().empty()) {
    DistributedVector pressure_forces = forces;
    Vector F =
      nodal.E().transpose_product(solve_homogeneous(data.inverse, data.space, pressure_forces));
    Vector start(F.size());
    for (unsigned int i = 0; i < F.size(); ++i) {
      const NodeCondition &condition = trace.conditions()[nodal.numbers()[i]];
      F[i] -= condition.required;
      if (condition.presses)
        start[i] = -data.P.linfty_norm() * trace.faces()[0].length;
    }
    Vector minus_Q = solve_dual_problem(nodal.C(), F, start, {}).P;
    minus_Q *= -1.;
    nodal.E().add_product(minus_Q, forces);
  }
  return solve_homogeneous(data.inverse, data.space, forces);
}

/** Returns A⁻¹ E Q with Eᵀ A⁻¹ E Q = 1. Where columns of C cost solves, its products cost fewer. */
Displacement pushed_displacement(const BoundData &data, const NodalCompliance &nodal) {
  const SolvedCompliance solved(data.inverse, nodal.E(), {});
  LinearOperator<Vector> C;
  C.vmult = [&](Vector &y, const Vector &x) {
    y = nodal.C()->is_explicit() ? nodal.C()->apply(x) : solved.apply(x);
  };
  Vector Q(nodal.numbers().size()), one(Q.size());
  one = 1.;
  // Any Q would do: what is lacking is imposed.
  IterationNumberControl control(1000, 1e-12 * one.l2_norm());
  SolverCG<Vector>(control).solve(C, Q, one, PreconditionIdentity());
  DistributedVector forces = data.space.make_vector();
  nodal.E().add_product(Q, forces);
  return solve_homogeneous(data.inverse, data.space, forces);
}
} // namespace

std::optional<Displacement> nodal_lift(const BoundData &data, const ContactTrace &trace) {
  const std::vector<NodeCondition> &conditions = trace.conditions();
  Vector required(conditions.size()), omega(conditions.size());
  for (unsigned int k = 0; k < omega.size(); ++k) {
    required[k] = conditions[k].required;
    if (!conditions[k].held())
      omega[k] = conditions[k].presses ? required[k] : std::max(0., required[k]);
  }
  Displacement w = is_cheap(data.inverse, trace)
                     ? pressed_displacement(data, trace)
                     : Layers(data.scene, trace, omega).interpolate(data.space);
  // This corrects the remainder of the solver's tolerance, and pins.
  if (!impose(trace, required, true, w))
    return {};
  data.space.distribute_without_pins(w);
  return w;
}

std::optional<double> norm_of_unit_lift(const BoundData &data, const ContactTrace &trace) {
  const auto &conditions = trace.conditions();
  if (conditions.empty() ||
      std::any_of(conditions.begin(), conditions.end(), [](const auto &c) { return c.held(); }))
    return {};
  Vector one(conditions.size());
  one = 1.;
  const NodalCompliance nodal(data, trace);
  Displacement z = nodal.C() != nullptr && is_cheap(data.inverse, trace)
                     ? pushed_displacement(data, nodal)
                     : Layers(data.scene, trace, one).interpolate(data.space);
  if (!impose(trace, one, false, z))
    return {};
  data.space.distribute_without_pins(z);
  const double local = LiftField(data, trace, std::move(z)).cell_energies().l1_norm();
  return std::sqrt(Utilities::MPI::sum(local, data.space.mesh().communicator()));
}
} // namespace Signorini
