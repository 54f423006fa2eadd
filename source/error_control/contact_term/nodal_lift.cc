// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces at contact nodes and their displacements.

#include <signorini/error_control/contact_term/nodal_lift.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/cycles/boundary_model.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;

/** The tolerance of the energy of a step, in products of forces and displacements: the steps
 * themselves are then below 1e-10. */
constexpr double nodal_tolerance = 1e-20;
constexpr unsigned int max_solves = 40;
/** The maximal size of a dense matrix, which takes 70 MB with that size, and its factors as much.
 */
constexpr unsigned int max_kernel_nodes = 3000;

/** Returns the halves of faces beside each of the conditions, on the side of the condition's place.
 */
std::vector<Patch<2>> patches_around_nodes(const ContactTrace &trace,
                                           const std::vector<unsigned int> &numbers)
{
  std::vector<Patch<2>> all(trace.conditions().size());
  for (const PenetrationFace &face : trace.faces())
  {
    const Side<2> &curve = trace.surface().side({face.side, {}, {}, 0.});
    const double middle = curve.arc_length(face.point(0.5));
    for (const unsigned int end : {0, 1})
    {
      Patch<2> &patch = all[face.conditions[end]];
      const bool is_lower = curve.arc_length(face.point(0.75)) < middle;
      const double other = middle + 0.5 * face.length * (is_lower == (end == 1) ? -1. : 1.);
      const double lower = std::min(middle, other), upper = std::max(middle, other);
      // Around a closed side one half is enough.
      if (patch.measure > 0. && std::min(std::abs(patch.lower[0] - upper),
                                         std::abs(patch.upper[0] - lower)) > 0.1 * face.length)
        continue;
      if (patch.measure == 0.)
        patch = {face.side, Point<1>(lower), Point<1>(upper), 0.};
      patch.lower[0] = std::min(patch.lower[0], lower);
      patch.upper[0] = std::max(patch.upper[0], upper);
      patch.measure = patch.upper[0] - patch.lower[0];
    }
  }
  std::vector<Patch<2>> patches;
  for (const unsigned int k : numbers)
    patches.push_back(all[k]);
  return patches;
}

} // namespace

NodalCompliance::NodalCompliance(const DisplacementSpace<2> &space,
                                 const ContactTrace &trace,
                                 const StiffnessInverse &inverse)
  : E_(std::vector<Coupling::Column>())
{
  // Pins hold the body while A is solved: what is left of two normals of a pinned node is
  // dependent.
  const auto is_pinned = [&](const Coupling::Column::value_type &entry) {
    return space.constraints().is_constrained(entry.first);
  };
  std::vector<Coupling::Column> columns;
  for (unsigned int k = 0; k < trace.conditions().size(); ++k)
  {
    const Coupling::Column &column = trace.normals().column(k);
    if (trace.conditions()[k].held || std::any_of(column.begin(), column.end(), is_pinned))
      continue;
    numbers_.push_back(k);
    columns.push_back(column);
  }
  E_ = Coupling(std::move(columns));
  if (numbers_.empty())
    return;
  C_ = make_compliance(inverse, E_, seconds_);
  if (C_->is_explicit())
    return;
  if (numbers_.size() > max_kernel_nodes)
  {
    numbers_.clear();
    return;
  }
  const std::vector<Patch<2>> patches = patches_around_nodes(trace, numbers_);
  model_ = make_kernel_model(trace.surface(), patches)->dense();
  // Forces in place of pressures.
  for (unsigned int i = 0; i < patches.size(); ++i)
    for (unsigned int j = 0; j < patches.size(); ++j)
      model_(i, j) /= patches[i].measure * patches[j].measure;
  C_ = std::make_shared<const SolvedCompliance>(inverse, E_, Vector());
}

Vector NodalCompliance::press(const Vector &F, const Vector &start)
{
  if (C_->is_explicit())
    return solve_dual_problem(C_, F, start, {}).P;
  return iterate(F, [](const FullMatrix<double> &M, const Vector &rhs, const Vector &Q) {
    return solve_dual_problem(std::make_shared<const DenseCompliance>(M), rhs, Q, {}).P;
  });
}

Vector NodalCompliance::solve(const Vector &F)
{
  const auto solve_with = [](const FullMatrix<double> &C, const Vector &rhs, const Vector &) {
    LAPACKFullMatrix<double> matrix(rhs.size());
    matrix = C;
    matrix.set_property(LAPACKSupport::symmetric);
    matrix.compute_cholesky_factorization();
    Vector Q = rhs;
    matrix.solve(Q);
    return Q;
  };
  return C_->is_explicit() ? solve_with(C_->dense(), F, F) : iterate(F, solve_with);
}

template <typename SolveWith>
Vector NodalCompliance::iterate(const Vector &F, const SolveWith &solve_with)
{
  Vector Q(F.size()), C_Q(F.size()), rhs(F.size()), M_d(F.size());
  for (unsigned int k = 0; k < max_solves; ++k)
  {
    model_.vmult(rhs, Q);
    rhs += F;
    rhs -= C_Q;
    Vector d = solve_with(model_, rhs, Q);
    d -= Q;
    const Vector C_d = C_->apply(d);
    const double energy = d * C_d, descent = d * F - d * C_Q;
    if (!(energy > 0.) || !(descent > 0.))
      return Q;
    const double step = std::min(1., descent / energy);
    Q.add(step, d);
    C_Q.add(step, C_d);
    if (step * step * energy <= nodal_tolerance * (Q * C_Q))
      return Q;
    model_.vmult(M_d, d);
    const double model_energy = d * M_d;
    for (unsigned int i = 0; i < d.size(); ++i)
      for (unsigned int j = 0; j < d.size(); ++j)
        model_(i, j) += C_d[i] * C_d[j] / energy - M_d[i] * M_d[j] / model_energy;
  }
  return Q;
}

// Functions of V^h with given normal components at contact nodes.

namespace
{
using dealii::Tensor;
using Vector = dealii::Vector<double>;

double product(const Coupling::Column &a, const Displacement &w)
{
  double sum = 0.;
  for (const auto &entry : a)
    sum += entry.second * w[entry.first];
  return sum;
}

double product(const Coupling::Column &a, const Coupling::Column &b)
{
  double sum = 0.;
  for (const auto &entry : a)
    for (const auto &other : b)
      if (entry.first == other.first)
        sum += entry.second * other.second;
  return sum;
}

/** Returns the conditions of each node that is not held: one, or two in a corner of contact sides.
 */
std::vector<std::vector<unsigned int>> conditions_by_node(const Coupling &E)
{
  std::vector<std::vector<unsigned int>> nodes;
  std::map<types::global_dof_index, std::size_t> node_of;
  for (unsigned int k = 0; k < E.n_columns(); ++k)
  {
    if (E.column(k).empty())
      continue;
    std::size_t node = nodes.size();
    for (const auto &entry : E.column(k))
      if (const auto found = node_of.find(entry.first); found != node_of.end())
        node = found->second;
    if (node == nodes.size())
      nodes.emplace_back();
    nodes[node].push_back(k);
    for (const auto &entry : E.column(k))
      node_of[entry.first] = node;
  }
  return nodes;
}

/** Returns l with lacking - G l = 0 (or, with only_raise, ≤ 0) for two conditions with G = (a c; c
 * b), and |E l| as small as possible. */
std::array<double, 2> min_norm_solution(const double a,
                                        const double b,
                                        const double c,
                                        const std::array<double, 2> &lacking,
                                        const bool only_raise)
{
  if (only_raise)
  {
    const double first = std::max(0., lacking[0]) / a, second = std::max(0., lacking[1]) / b;
    if (c * first >= lacking[1])
      return {{first, 0.}};
    if (c * second >= lacking[0])
      return {{0., second}};
  }
  const double determinant = a * b - c * c;
  return {{(b * lacking[0] - c * lacking[1]) / determinant,
           (a * lacking[1] - c * lacking[0]) / determinant}};
}

/** Moves w_n at contact nodes by the shortest way to the targets; with only_raise, only where w_n
 * is below them. */
void impose(const Coupling &E, const Vector &targets, const bool only_raise, Displacement &w)
{
  for (const std::vector<unsigned int> &node : conditions_by_node(E))
  {
    const Coupling::Column &first = E.column(node[0]), &last = E.column(node.back());
    const std::array<double, 2> lacking = {
      {targets[node[0]] - product(first, w), targets[node.back()] - product(last, w)}};
    const double a = product(first, first);
    std::array<double, 2> l = {{(only_raise ? std::max(0., lacking[0]) : lacking[0]) / a, 0.}};
    if (node.size() > 1)
      l = min_norm_solution(a, product(last, last), product(first, last), lacking, only_raise);
    for (const auto &entry : first)
      w[entry.first] += l[0] * entry.second;
    for (const auto &entry : last)
      w[entry.first] += l[1] * entry.second;
  }
}

/** The function ω below one side, linear between its contact nodes, with the depth of the
 * layer. */
class Layer
{
public:
  Layer(const Scene<2> &scene,
        const ContactTrace &trace,
        const unsigned int side,
        const Vector &omega)
    : start_(scene.geometry.sides[side].start())
    , normal_(scene.geometry.sides[side].normal(0.))
    , depth_(scene.geometry.shortest_extent())
  {
    const Side<2> &curve = scene.geometry.sides[side];
    tangent_ = (curve.end() - curve.start()) / curve.length();
    double squares = 0., slopes = 0.;
    for (const PenetrationFace &face : trace.faces())
      if (face.side == side)
      {
        const double a = omega[face.conditions[0]], b = omega[face.conditions[1]];
        for (const unsigned int end : {0, 1})
          nodes_[curve.arc_length(end == 0 ? face.start : face.end)] = end == 0 ? a : b;
        squares += face.length * (a * a + a * b + b * b) / 3.;
        slopes += (b - a) * (b - a) / face.length;
      }
    const auto C = scene.material->hooke(curve.point(0.5 * curve.length()));
    const auto nn = symmetrize(outer_product(normal_, normal_));
    const auto nm = symmetrize(outer_product(normal_, tangent_));
    if (slopes > 0.)
      depth_ =
        std::min(depth_, std::sqrt(3. * (nn * (C * nn)) * squares / ((nm * (C * nm)) * slopes)));
  }

  Tensor<1, 2> value(const Point<2> &x) const
  {
    const double s = (x - start_) * tangent_, y = -((x - start_) * normal_);
    if (y < -1e-10 * depth_ || y >= depth_)
      return {};
    return omega(s) * (1. - y / depth_) * normal_;
  }

private:
  /** Returns ω at s, zero beyond the ends. */
  double omega(const double s) const
  {
    const double tolerance = 1e-10 * depth_;
    const auto after = nodes_.lower_bound(s - tolerance);
    if (after == nodes_.end())
      return 0.;
    if (std::abs(after->first - s) <= tolerance)
      return after->second;
    if (after == nodes_.begin())
      return 0.;
    const auto before = std::prev(after);
    const double t = (s - before->first) / (after->first - before->first);
    return (1. - t) * before->second + t * after->second;
  }

  Point<2> start_;
  Tensor<1, 2> normal_, tangent_;
  double depth_;
  std::map<double, double> nodes_;
};

/** Interpolates the layers of all contact sides at the nodes, with the given w_n at contact nodes.
 */
Displacement interpolate_layers(const DisplacementSpace<2> &space,
                                const Scene<2> &scene,
                                const ContactTrace &trace,
                                const Vector &omega)
{
  std::vector<Layer> layers;
  // A chain turns: there, w lives at the contact nodes alone.
  for (const unsigned int side : scene.contact_sides())
    if (scene.geometry.sides[side].n_pieces() == 1)
      layers.emplace_back(scene, trace, side, omega);
  Displacement w = space.zero();
  std::vector<bool> done(space.mesh().triangulation().n_vertices(), false);
  for (const auto &cell : space.dofs().active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (!done[cell->vertex_index(v)])
      {
        done[cell->vertex_index(v)] = true;
        Tensor<1, 2> value;
        for (const Layer &layer : layers)
          value += layer.value(cell->vertex(v));
        for (unsigned int d = 0; d < 2; ++d)
          w[cell->vertex_dof_index(v, d)] = value[d];
      }
  impose(trace.normals(), omega, false, w);
  space.distribute_without_pins(w);
  return w;
}

/** Returns Eᵀ A⁻¹ D P: the last column of [E, D P]ᵀ A⁻¹ [E, D P], which a trailing factor
 * gives without a solve. */
Vector displacement_by_pressure(const Pressure &P,
                                const Coupling &condensed_D,
                                const Coupling &E,
                                const StiffnessInverse &inverse)
{
  std::map<types::global_dof_index, double> forces;
  for (unsigned int k = 0; k < P.size(); ++k)
    if (P[k] != 0.)
      for (const auto &entry : condensed_D.column(k))
        forces[entry.first] += entry.second * P[k];
  const unsigned int m = E.n_columns();
  Vector pushed(m);
  if (forces.empty())
    return pushed;
  std::vector<Coupling::Column> columns;
  for (unsigned int k = 0; k < m; ++k)
    columns.push_back(E.column(k));
  columns.emplace_back(forces.begin(), forces.end());
  const Coupling all(std::move(columns));
  double seconds = 0.;
  const auto last = make_compliance(inverse, all, seconds)->columns({m});
  for (unsigned int k = 0; k < m; ++k)
    pushed[k] = last(k, 0);
  return pushed;
}

/** Returns the solution of the dual problem of dual_lift(). */
Displacement pressed_displacement(const DisplacementSpace<2> &space,
                                  const ContactTrace &trace,
                                  const Coupling &condensed_D,
                                  const StiffnessInverse &inverse,
                                  const Pressure &P,
                                  const Vector &required,
                                  NodalCompliance &C)
{
  Vector F = displacement_by_pressure(P, condensed_D, C.columns(), inverse), start(F.size());
  for (unsigned int i = 0; i < F.size(); ++i)
  {
    F[i] -= required[C.numbers()[i]];
    if (trace.conditions()[C.numbers()[i]].presses)
      start[i] = -P.linfty_norm() * trace.faces()[0].length;
  }
  Vector minus_Q = C.press(F, start);
  minus_Q *= -1.;
  DistributedVector forces = space.make_vector();
  condensed_D.add_product(P, forces);
  C.columns().add_product(minus_Q, forces);
  return solve_homogeneous(inverse, space, forces);
}

} // namespace

Vector required_values(const ContactTrace &trace)
{
  Vector required(trace.conditions().size());
  for (unsigned int k = 0; k < required.size(); ++k)
    required[k] = trace.conditions()[k].required;
  return required;
}

std::optional<Vector> raised_values(const ContactTrace &trace)
{
  Vector raised = required_values(trace);
  bool changed = false;
  for (const PenetrationFace &face : trace.faces())
  {
    const double largest = face.d.largest();
    if (face.presses() || largest <= std::max({0., face.d.value(0.), face.d.value(1.)}))
      continue;
    changed = true;
    for (const unsigned int k : face.conditions)
      if (!trace.conditions()[k].held)
        raised[k] = std::max(raised[k], largest);
  }
  return changed ? std::optional<Vector>(raised) : std::nullopt;
}

Displacement layer_lift(const DisplacementSpace<2> &space,
                        const Scene<2> &scene,
                        const ContactTrace &trace)
{
  Vector omega = required_values(trace);
  for (unsigned int k = 0; k < omega.size(); ++k)
    if (trace.conditions()[k].held)
      omega[k] = 0.;
    else if (!trace.conditions()[k].presses)
      omega[k] = std::max(0., omega[k]);
  return interpolate_layers(space, scene, trace, omega);
}

Displacement dual_lift(const DisplacementSpace<2> &space,
                       const ContactTrace &trace,
                       const Coupling &condensed_D,
                       const StiffnessInverse &inverse,
                       const Pressure &P,
                       const dealii::Vector<double> &required)
{
  NodalCompliance C(space, trace, inverse);
  Displacement w = space.zero();
  if (!C.numbers().empty())
    w = pressed_displacement(space, trace, condensed_D, inverse, P, required, C);
  // This corrects the remainder of the solver's tolerance, and pins.
  impose(trace.normals(), required, true, w);
  space.distribute_without_pins(w);
  return w;
}

std::optional<Displacement> unit_normal_lift(const DisplacementSpace<2> &space,
                                             const ContactTrace &trace,
                                             const StiffnessInverse &inverse)
{
  NodalCompliance C(space, trace, inverse);
  const auto &conditions = trace.conditions();
  if (C.numbers().empty() ||
      std::any_of(conditions.begin(), conditions.end(), [](const auto &c) { return c.held; }))
    return {};
  Vector one(C.numbers().size()), everywhere(conditions.size());
  one = 1.;
  everywhere = 1.;
  const Vector forces = C.solve(one);
  DistributedVector b = space.make_vector();
  C.columns().add_product(forces, b);
  Displacement z = solve_homogeneous(inverse, space, b);
  impose(trace.normals(), everywhere, false, z);
  space.distribute_without_pins(z);
  return z;
}
} // namespace Signorini
