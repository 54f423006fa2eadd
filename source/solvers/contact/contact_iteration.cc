// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact by V-cycles, each followed by a problem on the boundary, with Anderson's acceleration.

#include <signorini/solvers/contact/contact_iteration.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/contact/saddle_point.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <numeric>
#include <optional>
#include <vector>

#include "saddle_point_internal.h"

namespace Signorini {
/** A step of the iteration from U and P. */
struct ContactStep {
  /** The residual r = f + D P - A U and z = V r. */
  NodalVector r, z;
  /** The change d = Q - P and t Ĉ_1 d. */
  dealii::Vector<double> d, C_d;

  /** Returns (z.V⁻¹ z + d.t Ĉ_1 d)^{1/2}. */
  double size() const;
};

/**
 * Anderson's acceleration of the iteration: the next (U, P) is taken where the step, as the linear
 * combination of the last ones, is smallest in the norm of ContactStep::size(). Between changes of
 * the set {P < 0} the iteration is linear, and this is a restarted method of minimal residuals for
 * it.
 *
 * Two differences are kept, in single precision: 24 bytes per degree of freedom. (Relative errors
 * of differences matter, which fall with the step.)
 */
class Acceleration {
public:
  /**
   * Moves U and P by @p step, or farther.
   * @param same_set whether the step keeps the set; otherwise earlier steps are forgotten.
   */
  void advance(NodalVector &U, dealii::Vector<double> &P, const ContactStep &step, bool same_set);
  /** Forgets all earlier steps. */
  void forget() {
    differences_.clear();
    last_.reset();
  }

private:
  /** A step and the increments that were taken, or the change of these from one point to the next.
   */
  struct Difference {
    LinearAlgebra::distributed::Vector<float> U, r, z;
    dealii::Vector<double> P, d, C_d;
  };

  /** Returns the coefficients of the differences. */
  dealii::Vector<double> coefficients(const ContactStep &step) const;

  std::deque<Difference> differences_;
  std::optional<Difference> last_;
};

namespace {
/** Returns a.b of vectors of different precision. Collective. */
template <typename First, typename Second>
double product(const First &a, const Second &b) {
  const double mine = std::inner_product(a.begin(), a.end(), b.begin(), 0., std::plus<>(),
                                         [](double x, double y) { return x * y; });
  return Utilities::MPI::sum(mine, a.get_mpi_communicator());
}

/** Replaces @p to by from - to. */
template <typename From, typename To>
void subtract_from(const From &from, To &to) {
  std::transform(from.begin(), from.end(), to.begin(), to.begin(), [](const auto a, const auto b) {
    return static_cast<typename To::value_type>(a - b);
  });
}
} // namespace

double ContactStep::size() const {
  return std::sqrt(std::abs(r * z + d * C_d));
}

dealii::Vector<double> Acceleration::coefficients(const ContactStep &step) const {
  const unsigned int n = differences_.size();
  FullMatrix<double> M(n, n);
  dealii::Vector<double> rhs(n), gamma(n);
  for (unsigned int i = 0; i < n; ++i) {
    const Difference &row = differences_[i];
    for (unsigned int j = 0; j < n; ++j)
      M(i, j) = product(row.z, differences_[j].r) + row.d * differences_[j].C_d;
    // Products of floats carry about eight digits.
    M(i, i) *= 1. + 1e-9;
    rhs[i] = product(row.z, step.r) + row.C_d * step.d;
    if (!(M(i, i) > 0.))
      return gamma;
  }
  // Two differences in the same direction give no more information than one.
  if (n > 1 && M.determinant() < 1e-8 * M(0, 0) * M(1, 1))
    gamma[n - 1] = rhs[n - 1] / M(n - 1, n - 1);
  else if (n > 0) {
    M.gauss_jordan();
    M.vmult(gamma, rhs);
  }
  return gamma;
}

void Acceleration::advance(NodalVector &U, dealii::Vector<double> &P, const ContactStep &step,
                           const bool same_set) {
  constexpr unsigned int depth = 2;
  if (!same_set)
    forget();
  if (last_) {
    subtract_from(step.r, last_->r);
    subtract_from(step.z, last_->z);
    subtract_from(step.d, last_->d);
    subtract_from(step.C_d, last_->C_d);
    differences_.push_back(std::move(*last_));
    if (differences_.size() > depth)
      differences_.pop_front();
  }
  const dealii::Vector<double> gamma = coefficients(step), P_before = P;
  last_.emplace();
  last_->U = step.z;
  last_->r = step.r;
  last_->z = step.z;
  last_->d = step.d;
  last_->C_d = step.C_d;
  P += step.d;
  for (unsigned int k = 0; k < gamma.size(); ++k) {
    const auto factor = static_cast<float>(-gamma[k]);
    last_->U.add(factor, differences_[k].U, factor, differences_[k].z);
    P.add(-gamma[k], differences_[k].P, -gamma[k], differences_[k].d);
  }
  for (double &p : P)
    p = std::min(p, 0.);
  last_->P = P;
  last_->P -= P_before;
  std::transform(U.begin(), U.end(), last_->U.begin(), U.begin(), std::plus<double>());
}

namespace {
using Vector = dealii::Vector<double>;

/** Returns whether three steps have grown, twofold in all. */
bool grow(const std::vector<double> &steps) {
  const std::size_t n = steps.size();
  return n > 3 && std::is_sorted(steps.end() - 3, steps.end()) && steps[n - 1] > 2. * steps[n - 4];
}

/** Returns whether twelve steps have shrunk by less than a fifth per step, which is a factor of 15.
 */
bool stall(const std::vector<double> &steps) {
  constexpr std::size_t window = 12;
  const std::size_t n = steps.size();
  return n > window && steps[n - 1] > std::pow(0.8, window) * steps[n - 1 - window];
}

/** Computes z by a V-cycle, and d by the boundary problem of U + z. */
void complete_step(const ContactSystem &system, const ContactIterationResult &at,
                   ContactStep &step) {
  step.z = system.A.make_vector();
  system.A.precondition(step.z, step.r);
  Vector W = system.opening(at.U);
  W += system.condensed_D.transpose_product(step.z);
  W /= at.scale;
  const MPI_Comm communicator = step.z.get_mpi_communicator();
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
    step.d = solve_boundary_problem(system.model, W, at.P);
  step.d = Utilities::MPI::broadcast(communicator, step.d);
  step.d -= at.P;
  step.C_d = system.model.apply(step.d);
  step.C_d *= at.scale;
}

/** Measures the energy of the residual by one more V-cycle, which is counted. */
void measure_energy_of_residual(const ContactSystem &system, const NodalVector &r,
                                ContactIterationResult &result) {
  NodalVector z = system.A.make_vector();
  system.A.precondition(z, r);
  ++result.cycles;
  result.energy_of_residual = 0.5 * (r * z);
}

/** Returns whether P + d presses where P does. */
bool keeps_set(const Vector &P, const Vector &d) {
  for (unsigned int k = 0; k < P.size(); ++k)
    if ((P[k] < 0.) != (P[k] + d[k] < 0.))
      return false;
  return true;
}
} // namespace

NodalVector ContactSystem::residual(const NodalVector &U, const Vector &P) const {
  NodalVector r = A.make_vector();
  A.vmult(r, U);
  r *= -1.;
  r += f;
  condensed_D.add_product(P, r);
  return r;
}

Vector ContactSystem::opening(const NodalVector &U) const {
  Vector W = condensed_D.transpose_product(U);
  W -= gap;
  return W;
}

double estimate_scale(const ContactSystem &system, const unsigned int n_steps) {
  constexpr double share_of_largest = 0.64;
  // The first vector has all frequencies.
  Vector v(system.gap.size());
  for (unsigned int k = 0; k < v.size(); ++k)
    v[k] = std::sin(1. + k * (k + 1.7));
  double largest = 0.;
  for (unsigned int step = 0; step < n_steps; ++step) {
    Vector w = system.model.apply_inverse(v);
    w /= std::sqrt(v * w);
    NodalVector b = system.A.make_vector(), z(b);
    system.condensed_D.add_product(w, b);
    system.A.precondition(z, b);
    v = system.condensed_D.transpose_product(z);
    largest = v * w;
  }
  return share_of_largest * largest;
}

ContactIterationResult solve_contact_by_cycles(const ContactSystem &system, const NodalVector &U,
                                               const Vector &P,
                                               const ContactIterationOptions &options) {
  constexpr unsigned int power_steps = 8;
  constexpr unsigned int max_doublings = 2;
  ContactIterationResult result;
  result.U = U;
  result.P = P;
  result.rounding_of_A = rounding_of(system.A);
  result.scale = options.scale;
  if (result.scale <= 0.) {
    result.scale = estimate_scale(system, power_steps);
    result.cycles_for_scale = power_steps;
  }
  std::vector<double> steps;
  Acceleration acceleration;
  double before = 0.;
  for (unsigned int doublings = 0;;) {
    ContactStep step;
    step.r = measure(system, options, result);
    // r.V r falls like |r|², and the last step may have taken nearly all of it.
    const double now = step.r.norm_sqr();
    if (before > 0.)
      result.energy_of_residual *= now / before;
    before = now;
    if (result.converged || result.cycles >= options.maximum_cycles) {
      if (result.cycles == 0)
        measure_energy_of_residual(system, step.r, result);
      return result;
    }
    if (grow(steps) && doublings < max_doublings) {
      ++doublings;
      result.scale *= 2.;
      steps.clear();
      acceleration.forget();
    } else if (grow(steps) || stall(steps))
      break;
    complete_step(system, result, step);
    ++result.cycles;
    // Of the point before; without a V-cycle of its own.
    result.energy_of_residual = 0.5 * (step.r * step.z);
    steps.push_back(step.size());
    acceleration.advance(result.U, result.P, step, keeps_set(result.P, step.d));
  }
  result.stalled = "the steps of V-cycles and boundary problems shrank too slowly";
  solve_by_minres(system, options, result);
  measure_energy_of_residual(system, measure(system, options, result), result);
  return result;
}
} // namespace Signorini
