// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/free_motions.h>

#include <memory>

/** A dual problem with free motions. */
struct MotionProblem {
  dealii::FullMatrix<double> C;
  dealii::Vector<double> F;
  Signorini::FreeMotions motions;

  unsigned int m() const {
    return F.size();
  }
  unsigned int k() const {
    return motions.b.size();
  }
};

inline Signorini::MotionResult
solve(const MotionProblem &problem,
      const Signorini::ContactSolver method = Signorini::ContactSolver::active_set,
      const dealii::Vector<double> &start = {}) {
  Signorini::DualSolverOptions options;
  options.method = method;
  return Signorini::solve_dual_problem(
    std::make_shared<const Signorini::DenseCompliance>(problem.C), problem.F,
    Signorini::AdmissibleSet::nonpositive(problem.F.size()), problem.motions, start, options);
}

/** max |a_i - b_i|. */
inline double difference(dealii::Vector<double> a, const dealii::Vector<double> &b) {
  a -= b;
  return a.linfty_norm();
}
