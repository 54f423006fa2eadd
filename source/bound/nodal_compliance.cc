// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces at contact nodes and what they do there.

#include <signorini/bound/nodal_compliance.h>
#include <signorini/boundary_model/boundary_model.h>
#include <signorini/compliance/compliance.h>
#include <signorini/compliance/solved_compliance.h>
#include <signorini/qp/dual_solver.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;

/** Of the energy of a step. w is a minimum: its own energy has twice as many digits. */
constexpr double nodal_tolerance = 1e-14;
constexpr unsigned int most_solves = 30;
/** A dense matrix of 70 MB, and its factors. */
constexpr unsigned int most_nodes_of_kernel = 3000;

/** The halves of faces beside each of the conditions: on one side, as condition and place are. */
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
        patch = {face.side, dealii::Point<1>(lower), dealii::Point<1>(upper), 0.};
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
  if (numbers_.size() > most_nodes_of_kernel)
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
  return iterate(F, [](const dealii::FullMatrix<double> &M, const Vector &rhs, const Vector &Q) {
    return solve_dual_problem(std::make_shared<const DenseCompliance>(M), rhs, Q, {}).P;
  });
}

Vector NodalCompliance::solve(const Vector &F)
{
  const auto solve_with =
    [](const dealii::FullMatrix<double> &C, const Vector &rhs, const Vector &) {
      dealii::LAPACKFullMatrix<double> matrix(rhs.size());
      matrix = C;
      matrix.set_property(dealii::LAPACKSupport::symmetric);
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
  for (unsigned int k = 0; k < most_solves; ++k)
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
    const double of_model = d * M_d;
    for (unsigned int i = 0; i < d.size(); ++i)
      for (unsigned int j = 0; j < d.size(); ++j)
        model_(i, j) += C_d[i] * C_d[j] / energy - M_d[i] * M_d[j] / of_model;
  }
  return Q;
}
} // namespace Signorini
