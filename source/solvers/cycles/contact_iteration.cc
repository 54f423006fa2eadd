// SPDX-License-Identifier: LGPL-2.1-or-later
// Anderson's acceleration of V-cycles and boundary problems.

#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/cycles/contact_iteration.h>
#include <signorini/solvers/cycles/saddle_point.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "saddle_point_internal.h"

namespace Signorini
{
/** A step of the iteration from U and P. */
struct ContactStep
{
  /** The residual r = f + D P - A U and z = V r. */
  dealii::Vector<double> r, z;
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
class Acceleration
{
public:
  /**
   * Moves U and P by @p step, or farther.
   * @param same_set whether the step keeps the set; otherwise earlier steps are forgotten.
   */
  void advance(dealii::Vector<double> &U,
               dealii::Vector<double> &P,
               const ContactStep &step,
               bool same_set);
  /** Forgets all earlier steps. */
  void forget();

private:
  using Floats = dealii::Vector<float>;

  /** The change from one point to the next: of the point, and of the step there. */
  struct Difference
  {
    Floats U, z;
    dealii::Vector<double> P, d, C_d;
  };

  void remember(const ContactStep &step);
  /** Returns the coefficients of the differences. */
  dealii::Vector<double> coefficients(const ContactStep &step) const;

  std::deque<Difference> differences_;
  /** The products of differences of steps, products_[i][j]. */
  std::deque<std::deque<double>> products_;
  bool has_last_ = false;
  /** The last step, and its increments. */
  Floats last_r_, last_z_, last_increment_;
  dealii::Vector<double> last_d_, last_C_d_, last_P_increment_;
};

namespace
{
constexpr unsigned int acceleration_depth = 2;

double product(const dealii::Vector<float> &a, const dealii::Vector<float> &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += double(a[i]) * double(b[i]);
  return sum;
}

double product(const dealii::Vector<float> &a, const dealii::Vector<double> &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += double(a[i]) * b[i];
  return sum;
}

dealii::Vector<double> difference_of(dealii::Vector<double> a, const dealii::Vector<double> &b)
{
  a -= b;
  return a;
}

/** Replaces @p to by from - to. */
void subtract_from(const dealii::Vector<double> &from, dealii::Vector<float> &to)
{
  for (unsigned int i = 0; i < to.size(); ++i)
    to[i] = static_cast<float>(from[i] - to[i]);
}
} // namespace

double ContactStep::size() const
{
  return std::sqrt(std::abs(r * z + d * C_d));
}

void Acceleration::forget()
{
  differences_.clear();
  products_.clear();
  has_last_ = false;
}

void Acceleration::remember(const ContactStep &step)
{
  // The vectors of the last step become those of the difference.
  subtract_from(step.r, last_r_);
  subtract_from(step.z, last_z_);
  differences_.push_back({std::move(last_increment_),
                          std::move(last_z_),
                          last_P_increment_,
                          difference_of(step.d, last_d_),
                          difference_of(step.C_d, last_C_d_)});
  if (differences_.size() > acceleration_depth)
  {
    differences_.pop_front();
    products_.pop_front();
    for (auto &row : products_)
      row.pop_front();
  }
  const Difference &added = differences_.back();
  products_.emplace_back();
  for (unsigned int i = 0; i < differences_.size(); ++i)
  {
    const double value = product(differences_[i].z, last_r_) + differences_[i].d * added.C_d;
    products_.back().push_back(value);
    if (i + 1 < differences_.size())
      products_[i].push_back(value);
  }
}

dealii::Vector<double> Acceleration::coefficients(const ContactStep &step) const
{
  const unsigned int n = differences_.size();
  FullMatrix<double> M(n, n), inverse(n, n);
  dealii::Vector<double> rhs(n), gamma(n);
  if (n == 0)
    return gamma;
  for (unsigned int i = 0; i < n; ++i)
  {
    for (unsigned int j = 0; j < n; ++j)
      M(i, j) = products_[i][j];
    // Products of floats carry about eight digits.
    M(i, i) *= 1. + 1e-9;
    rhs[i] = product(differences_[i].z, step.r) + differences_[i].C_d * step.d;
    if (!(M(i, i) > 0.))
      return gamma;
  }
  // Two differences in the same direction give no more information than one.
  if (n > 1 && M.determinant() < 1e-8 * M(0, 0) * M(1, 1))
  {
    gamma[n - 1] = rhs[n - 1] / M(n - 1, n - 1);
    return gamma;
  }
  inverse.invert(M);
  inverse.vmult(gamma, rhs);
  return gamma;
}

void Acceleration::advance(dealii::Vector<double> &U,
                           dealii::Vector<double> &P,
                           const ContactStep &step,
                           const bool same_set)
{
  if (!same_set)
    forget();
  if (has_last_)
    remember(step);
  const dealii::Vector<double> gamma = coefficients(step);
  last_r_ = step.r;
  last_z_ = step.z;
  last_increment_ = step.z;
  last_d_ = step.d;
  last_C_d_ = step.C_d;
  last_P_increment_ = P;
  P += step.d;
  for (unsigned int k = 0; k < gamma.size(); ++k)
  {
    const auto factor = static_cast<float>(-gamma[k]);
    last_increment_.add(factor, differences_[k].U, factor, differences_[k].z);
    P.add(-gamma[k], differences_[k].P, -gamma[k], differences_[k].d);
  }
  for (double &p : P)
    p = std::min(p, 0.);
  last_P_increment_.sadd(-1., 1., P);
  for (unsigned int i = 0; i < U.size(); ++i)
    U[i] += double(last_increment_[i]);
  has_last_ = true;
}

// A V-cycle, then a problem on the boundary, repeated.

namespace
{
using Vector = dealii::Vector<double>;

/** Returns Dᵀ V D P. */
Vector approximate_compliance_times(const ContactSystem &system, const Vector &P)
{
  dealii::Vector<double> b(system.A.size()), z(system.A.size());
  add_product(system.condensed_D, P, b);
  system.A.precondition(z, b);
  return system.condensed_D.transpose_product(z);
}

/** Returns the largest eigenvalue of a symmetric tridiagonal matrix, by bisection with Sturm's
 * sequence. */
double max_eigenvalue(const std::vector<double> &diagonal, const std::vector<double> &beside)
{
  double low = 0., high = 0.;
  for (std::size_t i = 0; i < diagonal.size(); ++i)
    high = std::max(high,
                    diagonal[i] + (i > 0 ? std::abs(beside[i - 1]) : 0.) +
                      (i < beside.size() ? std::abs(beside[i]) : 0.));
  // T - x is negative definite exactly if x is above all eigenvalues.
  const auto is_above = [&](const double x) {
    double pivot = diagonal[0] - x;
    for (std::size_t i = 1; i < diagonal.size() && pivot < 0.; ++i)
      pivot = diagonal[i] - x - beside[i - 1] * beside[i - 1] / pivot;
    return pivot < 0.;
  };
  for (unsigned int k = 0; k < 60; ++k)
    (is_above(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return high;
}

/** The sizes of the steps, which show how fast they shrink. */
class StepHistory
{
public:
  void add(const double step)
  {
    steps_.push_back(step);
  }
  void forget()
  {
    steps_.clear();
  }
  /** Returns whether three steps have grown, twofold in all. */
  bool grows() const
  {
    const std::size_t n = steps_.size();
    return n > 3 && steps_[n - 1] > steps_[n - 2] && steps_[n - 2] > steps_[n - 3] &&
           steps_[n - 1] > 2. * steps_[n - 4];
  }
  /** Returns whether twelve steps have shrunk by less than a fifth per step, which is a factor of
   * 15. */
  bool stalls() const
  {
    constexpr std::size_t window = 12;
    const std::size_t n = steps_.size();
    return n > window && steps_[n - 1] > std::pow(0.8, window) * steps_[n - 1 - window];
  }

private:
  std::vector<double> steps_;
};
/** Computes z by a V-cycle, and d by the boundary problem of U + z. */
void complete_step(const ContactSystem &system, const ContactIterationResult &at, ContactStep &step)
{
  step.z.reinit(at.U.size());
  system.A.precondition(step.z, step.r);
  Vector W = system.opening(at.U);
  W += system.condensed_D.transpose_product(step.z);
  W /= at.scale;
  step.d = solve_boundary_problem(system.model, W, at.P);
  step.d -= at.P;
  step.C_d = system.model.apply(step.d);
  step.C_d *= at.scale;
}

/** Returns (U.A U)^{1/2} up to the residual: A U = f + D P - r. */
double energy_norm(const ContactSystem &system, const ContactIterationResult &at)
{
  dealii::Vector<double> forces(system.f);
  add_product(system.condensed_D, at.P, forces);
  return std::sqrt(std::abs(forces * at.U));
}

/** Measures the energy of the residual by one more V-cycle, which is counted. */
void measure_energy_of_residual(const ContactSystem &system,
                                const dealii::Vector<double> &r,
                                ContactIterationResult &result)
{
  dealii::Vector<double> z(r.size());
  system.A.precondition(z, r);
  ++result.cycles;
  result.energy_of_residual = 0.5 * (r * z);
}

/** Returns whether P + d presses where P does. */
bool keeps_set(const Vector &P, const Vector &d)
{
  for (unsigned int k = 0; k < P.size(); ++k)
    if ((P[k] < 0.) != (P[k] + d[k] < 0.))
      return false;
  return true;
}
} // namespace

dealii::Vector<double> ContactSystem::residual(const dealii::Vector<double> &U,
                                               const Vector &P) const
{
  dealii::Vector<double> r(A.size());
  A.apply(r, U);
  r *= -1.;
  r += f;
  add_product(condensed_D, P, r);
  return r;
}

Vector ContactSystem::opening(const dealii::Vector<double> &U) const
{
  Vector W = condensed_D.transpose_product(U);
  W -= gap;
  return W;
}

double estimate_scale(const ContactSystem &system, const unsigned int n_steps)
{
  constexpr double share_of_largest = 0.6;
  const unsigned int m = system.gap.size();
  // v = Ĉ w; orthogonal in the product with Ĉ⁻¹. The first one has all frequencies.
  Vector v(m), v_before(m);
  for (unsigned int k = 0; k < m; ++k)
    v[k] = std::sin(1. + k * (k + 1.7));
  Vector w = system.model.apply_inverse(v);
  std::vector<double> diagonal, beside;
  double norm = std::sqrt(v * w);
  for (unsigned int j = 0; j < std::min(n_steps, m) && norm > 0.; ++j)
  {
    v /= norm;
    w /= norm;
    Vector next = approximate_compliance_times(system, w);
    diagonal.push_back(next * w);
    next.add(-diagonal.back(), v);
    if (j > 0)
      next.add(-norm, v_before);
    v_before = v;
    v = next;
    w = system.model.apply_inverse(v);
    norm = std::sqrt(std::max(0., v * w));
    if (norm < 1e-10 * diagonal[0])
      break;
    beside.push_back(norm);
  }
  beside.resize(diagonal.size() - 1);
  return share_of_largest * max_eigenvalue(diagonal, beside);
}

ContactIterationResult solve_contact_by_cycles(const ContactSystem &system,
                                               const dealii::Vector<double> &U,
                                               const Vector &P,
                                               const ContactIterationOptions &options)
{
  constexpr unsigned int lanczos_steps = 6;
  constexpr unsigned int max_doublings = 2;
  ContactIterationResult result;
  result.U = U;
  result.P = P;
  result.rounding_of_A = rounding_of(system.A);
  result.scale = options.scale;
  if (result.scale <= 0.)
  {
    result.scale = estimate_scale(system, lanczos_steps);
    result.cycles_for_scale = lanczos_steps;
  }
  StepHistory history;
  Acceleration acceleration;
  double before = 0.;
  for (unsigned int doublings = 0;;)
  {
    ContactStep step;
    step.r = measure(system, options, result);
    // r.V r falls like |r|², and the last step may have taken nearly all of it.
    const double now = step.r.norm_sqr();
    if (before > 0.)
      result.energy_of_residual *= now / before;
    before = now;
    if (result.converged || result.cycles >= options.maximum_cycles)
    {
      if (result.cycles == 0)
        measure_energy_of_residual(system, step.r, result);
      return result;
    }
    if (history.grows() && doublings < max_doublings)
    {
      ++doublings;
      result.scale *= 2.;
      history.forget();
      acceleration.forget();
    }
    else if (history.grows() || history.stalls())
      break;
    complete_step(system, result, step);
    ++result.cycles;
    // Of the point before; without a V-cycle of its own.
    result.energy_of_residual = 0.5 * (step.r * step.z);
    history.add(step.size());
    acceleration.advance(result.U, result.P, step, keeps_set(result.P, step.d));
    if (step.size() <= options.energy_tolerance * energy_norm(system, result))
    {
      const double left = measure(system, options, result).norm_sqr();
      if (before > 0.)
        result.energy_of_residual *= left / before;
      result.converged = true;
      return result;
    }
  }
  result.stalled = "the steps of V-cycles and boundary problems shrank too slowly";
  solve_by_minres(system, options, result);
  measure_energy_of_residual(system, measure(system, options, result), result);
  return result;
}
} // namespace Signorini
