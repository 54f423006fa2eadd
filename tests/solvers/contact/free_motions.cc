// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem with free motions, on rigid beams on springs: answers by hand, loads that tip or
// lift, motions that nothing sees, and elastic resistance.

#include <signorini/solvers/contact/free_motions.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "tests.h"

using namespace Signorini;
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;
using Numbers = std::vector<double>;

namespace {
/**
 * A rigid beam on springs of compliance c at the positions x, with gaps below it. q_0 is its way
 * down, q_1 its rotation: B_i = (1, x_i). It is loaded with the force N at the position e.
 */
struct Beam {
  Numbers x;
  double c = 1.;
  double N = 1.;
  double e = 0.;
  Numbers gap = {};
};

Vector gaps_of(const Beam &beam) {
  return beam.gap.empty() ? Vector(beam.x.size()) : Vector(beam.gap.begin(), beam.gap.end());
}

std::shared_ptr<const ComplianceOperator> compliance_of(const Beam &beam) {
  Matrix C(beam.x.size(), beam.x.size());
  for (unsigned int i = 0; i < beam.x.size(); ++i)
    C(i, i) = beam.c;
  return std::make_shared<const DenseCompliance>(C);
}

FreeMotions motions_of(const Beam &beam) {
  FreeMotions motions{Matrix(beam.x.size(), 2), Matrix(2, 2), Vector(2)};
  for (unsigned int i = 0; i < beam.x.size(); ++i) {
    motions.B(i, 0) = 1.;
    motions.B(i, 1) = beam.x[i];
  }
  motions.b[0] = beam.N;
  motions.b[1] = beam.N * beam.e;
  return motions;
}

DualSolverOptions options_for(const ContactSolver method) {
  DualSolverOptions options;
  options.method = method;
  return options;
}

MotionResult solve_on(const Beam &beam, const FreeMotions &motions,
                      const DualSolverOptions &options) {
  const Vector gaps = gaps_of(beam);
  return solve_dual_problem(compliance_of(beam), gaps, AdmissibleSet::nonpositive(gaps.size()),
                            motions, Vector(), options);
}

double distance(const Vector &found, const Numbers &expected) {
  double largest = std::abs(static_cast<double>(found.size()) - expected.size());
  for (unsigned int i = 0; i < found.size() && i < expected.size(); ++i)
    largest = std::max(largest, std::abs(found[i] - expected[i]));
  return largest;
}

/** Both methods; q is compared unless it is empty. */
void compare(Checks &checks, const std::string &name, const Beam &beam, const FreeMotions &motions,
             const Numbers &P, const Numbers &q) {
  for (const ContactSolver method : {ContactSolver::active_set, ContactSolver::psor}) {
    const bool sweeps = method == ContactSolver::psor;
    const std::string full = name + (sweeps ? ", psor" : ", active set");
    const double tolerance = sweeps ? 1e-8 : 1e-11;
    const MotionResult found = solve_on(beam, motions, options_for(method));
    checks.near(full + ": P", distance(found.qp.P, P), 0., tolerance);
    if (!q.empty())
      checks.near(full + ": q", distance(found.q, q), 0., tolerance);
    checks.that(full + ": converged", found.qp.converged && !found.escape);
  }
}

void compare(Checks &checks, const std::string &name, const Beam &beam, const Numbers &P,
             const Numbers &q) {
  compare(checks, name, beam, motions_of(beam), P, q);
}

MotionResult solve(const Beam &beam, const FreeMotions &motions) {
  return solve_on(beam, motions, DualSolverOptions());
}

void balanced_beams(Checks &checks) {
  compare(checks, "two springs, a gap", {{-1, 1}, 2., 3., 0.5, {4., 0.}}, {-0.75, -2.25},
          {5., -0.5});
  // R = N/n + N e x/sum x^2 while that is positive.
  const Numbers x = {-2, -1, 0, 1, 2};
  compare(checks, "inside the kern", {x, 1., 10., 0.5}, {-1., -1.5, -2., -2.5, -3.}, {2., 0.5});
  // The edge of the kern: the first spring touches without force.
  compare(checks, "edge of the kern", {x, 1., 10., 1.}, {0., -1., -2., -3., -4.}, {2., 1.});
  // Three springs press: centroid 1, sum (x - 1)^2 = 2.
  compare(checks, "outside the kern", {x, 1., 12., 1.5}, {0., 0., -1., -4., -7.}, {1., 3.});
  compare(checks, "above the last spring but one", {x, 2., 12., -1.75}, {-9., -3., 0., 0., 0.}, {});
  // Above the edge only one spring presses, and any rotation that opens the others is right.
  compare(checks, "above the edge", {x, 1., 12., 2.}, {0., 0., 0., 0., -12.}, {});
  compare(checks, "one spring", {{0.}, 2., 3., 0.}, {-3.}, {6., 0.});
  compare(checks, "no load, gaps", {{-1, 1}, 1., 0., 0., {1., 2.}}, {0., 0.}, {0., 0.});
}

void translations(Checks &checks) {
  // sum (q - gap_i)_+/c = N.
  const Beam beam{{0, 0, 0}, 0.5, 3., 0., {0., 1., 5.}};
  FreeMotions motions{Matrix(3, 1), Matrix(1, 1), Vector(1)};
  for (unsigned int i = 0; i < 3; ++i)
    motions.B(i, 0) = 1.;
  motions.b[0] = 3.;
  compare(checks, "translation", beam, motions, {-2.5, -0.5, 0.}, {1.25});
  // q/k + sum (q - gap_i)_+/c = b.
  motions.K(0, 0) = 2.;
  compare(checks, "a spring above", beam, motions, {-1.5, 0., 0.}, {0.75});
  motions.b[0] = -3.;
  compare(checks, "a spring above that lifts", beam, motions, {0., 0., 0.}, {-1.5});
}

/** The escape v opens everywhere and gains work; relative to its size. */
bool escapes(const MotionResult &found, const FreeMotions &motions) {
  if (!found.escape || found.qp.converged || found.qp.P.linfty_norm() > 0.)
    return false;
  const Vector &v = *found.escape;
  bool opens = true;
  for (unsigned int i = 0; i < motions.B.m(); ++i) {
    double rate = 0., size = 0.;
    for (unsigned int j = 0; j < v.size(); ++j) {
      rate += motions.B(i, j) * v[j];
      size += std::abs(motions.B(i, j) * v[j]);
    }
    opens = opens && rate <= 1e-12 * size;
  }
  return opens && motions.b * v > 0.;
}

void escaping_beams(Checks &checks) {
  const Numbers x = {-2, -1, 0, 1, 2};
  const Beam tipping{x, 1., 12., 2.5};
  MotionResult found = solve(tipping, motions_of(tipping));
  checks.that("tipping", escapes(found, motions_of(tipping)));
  checks.near("tipping about the last spring",
              found.escape ? (*found.escape)[0] + 2. * (*found.escape)[1] : 1., 0., 1e-12);
  const Beam just{x, 1., 12., 2. + 1e-6};
  checks.that("tipping, just", escapes(solve(just, motions_of(just)), motions_of(just)));
  const Beam hardly{x, 1., 12., 2. + 1e-12};
  checks.that("within rounding of the edge", !solve(hardly, motions_of(hardly)).escape);
  const Beam lifted{x, 1., -1., 0.3};
  checks.that("lifted", escapes(solve(lifted, motions_of(lifted)), motions_of(lifted)));
  FreeMotions moment = motions_of(tipping);
  moment.b[0] = 0.;
  checks.that("a moment alone", escapes(solve(tipping, moment), moment));
  moment.K(1, 1) = 3.;
  found = solve(tipping, moment);
  checks.that("a moment against a spring", found.qp.converged && !found.escape);
  moment.K(0, 0) = -1e-15;
  checks.that("resistance that is rounding", solve(tipping, moment).qp.converged);
  moment.K(0, 0) = 0.;
  moment.b[0] = -1.;
  checks.that("lifted in spite of that spring", escapes(solve(tipping, moment), moment));
  // Held by both: nothing escapes.
  moment.K(0, 0) = 2.;
  checks.that("lifted against springs", solve(tipping, moment).qp.converged);
}

void neutral_motions(Checks &checks) {
  // q_2 slides, and so does q_0 + q_1 less q_3.
  const Beam beam{{-1, 1}, 2., 3., 0.5};
  const FreeMotions two = motions_of(beam);
  FreeMotions motions{Matrix(2, 4), Matrix(4, 4), Vector(4)};
  for (unsigned int i = 0; i < 2; ++i) {
    motions.B(i, 0) = 1.;
    motions.B(i, 1) = beam.x[i];
    motions.B(i, 2) = 1e-17 * beam.x[i];
    motions.B(i, 3) = 1. + beam.x[i];
  }
  motions.b[0] = two.b[0];
  motions.b[1] = two.b[1];
  motions.b[2] = 1e-16;
  motions.b[3] = two.b[0] + two.b[1];
  MotionResult found = solve(beam, motions);
  checks.near("two neutral motions: P", distance(found.qp.P, {-0.75, -2.25}), 0., 1e-11);
  checks.near("two neutral motions: found", found.neutral.size(), 2., 0.);
  checks.that("two neutral motions: converged", found.qp.converged && !found.escape);
  checks.near("two neutral motions: sliding stays zero", found.q[2], 0., 1e-12);
  checks.near("two neutral motions: the way", found.q[0] + found.q[3], 3., 1e-11);
  motions.b[2] = 0.1;
  found = solve(beam, motions);
  checks.that("pushed sideways", found.escape && std::abs((*found.escape)[2]) > 0.1);
  // b_2 is a sum of terms of size 1e9.
  motions.b[2] = -1e-7;
  checks.that("a sum without its magnitude", solve(beam, motions).escape.has_value());
  motions.b_magnitude.reinit(4);
  motions.b_magnitude[2] = 1e9;
  checks.that("a sum that is rounding", !solve(beam, motions).escape);
  motions.b_magnitude = Vector();
  motions.b[2] = 0.1;
  motions.K(2, 2) = 5.;
  found = solve(beam, motions);
  checks.near("pushed sideways against a spring", found.q[2], 0.02, 1e-11);
  checks.near("one neutral motion", found.neutral.size(), 1., 0.);
}

void empty_problems(Checks &checks) {
  const Beam beam{{-1, 1}, 2., 3., 0., {-1., 1.}};
  const MotionResult held = solve(beam, FreeMotions());
  checks.near("no motions", distance(held.qp.P, {-0.5, 0.}), 0., 1e-14);
  checks.that("no motions: converged", held.qp.converged && held.q.size() == 0);
  FreeMotions motions{Matrix(), Matrix(1, 1), Vector(1)};
  motions.b[0] = 1.;
  checks.that("no patches", solve({}, motions).escape.has_value());
  motions.K(0, 0) = 4.;
  checks.near("no patches, a spring", distance(solve({}, motions).q, {0.25}), 0., 1e-15);
  DualSolverOptions few = options_for(ContactSolver::psor);
  few.maximum_iterations = 1;
  few.tolerance = 1e-15;
  const Beam uneven{{-2, -1, 0, 1, 2}, 1., 12., 1.5};
  Matrix C(5, 5);
  for (unsigned int i = 0; i < 5; ++i)
    for (unsigned int j = 0; j < 5; ++j)
      C(i, j) = std::exp(-0.3 * std::abs(double(i) - double(j)));
  const MotionResult stopped =
    solve_dual_problem(std::make_shared<const DenseCompliance>(C), gaps_of(uneven),
                       AdmissibleSet::nonpositive(5), motions_of(uneven), Vector(), few);
  checks.that("sweeps run out", !stopped.qp.converged);
}
} // namespace

int main() {
  return run_tests({balanced_beams, translations, escaping_beams, neutral_motions, empty_problems});
}
