// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/input/make_scene.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

/** Constants of the family below. */
struct Family {
  std::string nu = "0.3";
  /** Height of the body, in widths. */
  std::string height = "1";
  /** Logarithms to the base 10 of the contrast of E along and across the contact side. */
  std::string contrast_x = "0", contrast_y = "0";
  /** Units of length and stress. */
  std::string length = "1", stress = "1";
};

/**
 * One exact solution for every Poisson's ratio, height, contrast and unit: with X = x/L, Y = y/L,
 * M = max(xi - X, 0), s = sin(pi X)/10, mu = S m, m = exp(kx X + ky Y), r = mu/(lambda + 2 mu),
 * c = lambda/(lambda + 2 mu), q = -10 M^3 + 2 s':
 *
 *     u = L (s, Y (r q - s')),  sigma = S m (2 s' + c q, -10 M^3, Y (r q' - s'')),
 *
 * which is bounded as nu tends to 1/2 (div u = r q). On y = 0: sigma_12 = 0, u_n = 0, p = sigma_22,
 * and the gap L max(X - xi, 0)^2 opens where p vanishes. u is prescribed on the other sides.
 */
inline std::string text_of(const Family &family) {
  const bool uniform = family.contrast_x == "0" && family.contrast_y == "0";
  const std::string m = uniform ? "1" : "exp(kx*x/L+ky*y/L)";
  const std::string u = "0.1*L*sin(pi*x/L); y*(-w*cos(pi*x/L)*(1-2*r) - 10*r*max(xi-x/L,0)^3)";
  const std::string q1 = "(30*max(xi-x/L,0)^2 - 2*w*pi*sin(pi*x/L))";
  const std::string s12 = "y/L*(w*pi*sin(pi*x/L) + r*" + q1 + ")";
  std::string f1 = "w*pi*sin(pi*x/L) - (c+r)*" + q1;
  std::string f2 = "y/L*(-w*pi^2*cos(pi*x/L)*(1-2*r) + 60*r*max(xi-x/L,0))";
  // Terms that vanish would be computed a million times.
  if (!uniform) {
    f1 += " - kx*(2*w*cos(pi*x/L)*(1+c) - 10*c*max(xi-x/L,0)^3) - ky*" + s12;
    f2 += " - kx*" + s12 + " + ky*10*max(xi-x/L,0)^3";
  }
  std::ostringstream text;
  text << std::setprecision(17) << "subsection Constants\nset Values = nu=" << family.nu
       << ", L=" << family.length << ", S=" << family.stress << ", kx=log(10)*("
       << family.contrast_x << "), ky=log(10)*(" << family.contrast_y
       << "), xi=0.70710678118654752, r=(1-2*nu)/(2*(1-nu)), c=nu/(1-nu), w=0.1*pi\nend\n"
       << "subsection Geometry\nset Upper right = " << family.length << ", "
       << std::stod(family.length) * std::stod(family.height)
       << "\nend\nsubsection Material\nset Young's modulus = 2*(1+nu)*S*" << m
       << "\nset Poisson's ratio = nu\nend\nsubsection Boundary\nset Contact = bottom\n"
       << "set Displacement = left: " << u << " | right: " << u << " | top: " << u
       << "\nend\nsubsection Load\nset Body force = S/L*" << m << "*(" << f1 << "); S/L*" << m
       << "*(" << f2 << ")\nend\nsubsection Contact\nset Gap = L*max(x/L-xi,0)^2\nend\n"
       << "subsection Exact solution\nset Displacement = " << u
       << "\nset Pressure = -10*S*exp(kx*x/L)*max(xi-x/L,0)^3\nend\n"
       << "subsection Discretization\nset Kinks at x = "
       << 0.70710678118654752 * std::stod(family.length) << "\nend\n";
  return text.str();
}

/** The known values at a point of an axis. */
struct Measured {
  Signorini::StudyResult<2> study;
  double condition = 0.;
  unsigned int psor = 0, active_set = 0;

  const Signorini::LevelRecord &finest() const {
    return study.levels.back();
  }
  /** Whether the equations are solved. These tests use meshes that are too coarse for a small bound
   * of the error. */
  bool is_certified() const {
    return study.verdict.equations_hold();
  }
  /** Whether the answer is withheld, and the message holds this; it may be how a sentence begins.
   */
  bool names(const std::string &cause) const {
    std::string beginning = cause;
    beginning[0] = static_cast<char>(std::toupper(beginning[0]));
    const std::string &reason = study.verdict.reason;
    return !study.verdict.is_certified() &&
           (reason.find(cause) != std::string::npos || reason.rfind(beginning, 0) == 0);
  }
};

inline double condition_number(const dealii::FullMatrix<double> &C) {
  dealii::LAPACKFullMatrix<double> copy(C.m(), C.n());
  copy = C;
  dealii::Vector<double> eigenvalues;
  dealii::FullMatrix<double> vectors;
  copy.compute_eigenvalues_symmetric(-1e300, 1e300, 0., eigenvalues, vectors);
  return eigenvalues[eigenvalues.size() - 1] / eigenvalues[0];
}

/** The study, and the dual problem of its finest level solved once more from P = 0 by both methods.
 */
inline Measured measure(const std::string &text, const std::vector<std::string> &overrides) {
  using namespace Signorini;
  Measured measured;
  std::vector<std::string> all = {"Output/VTU=none"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  measured.study = solve(text, all);
  if (measured.study.levels.empty())
    return measured;
  // The bound of the error belongs to the finest level, and is known.
  all.insert(all.end(), {"Output/Inf-sup constant=false", "Output/Compliance=true",
                         "Discretization/Finest level=14"});
  const OneLevel one(text, measured.finest().sizes.level, all);
  const LevelSolution<2> level = one.solve();
  if (!level.contact.touches())
    return measured;
  const BoundConstrainedQP qp(level.operators->C->dense(), level.contact.dual()->F);
  const SolverParameters &solver = one.parameters.solver;
  measured.condition = condition_number(level.operators->C->dense());
  measured.psor = solve_by_psor(qp, dealii::Vector<double>(qp.size()),
                                {solver.tolerance, solver.maximum_iterations, solver.relaxation})
                    .iterations;
  if (measured.condition > 0. && measured.condition < 1e14)
    measured.active_set = solve_by_active_set(qp, {}, {solver.tolerance, 1000}).iterations;
  return measured;
}

/** A table in Markdown, in a file of the working directory; scripts/stability collects them. */
class StabilityTable {
public:
  StabilityTable(const std::string &name, const std::string &axis)
    : file_(name + ".md") {
    file_
      << "| " << axis
      << " | KKT | β | cond(C) | PSOR | active set | ‖u−u_h‖₁ | ‖p−p_H‖₀ | rounding | verdict |\n"
      << "|---|---|---|---|---|---|---|---|---|---|\n";
  }

  void add(const std::string &setting, const Measured &measured) {
    file_ << "| " << setting << " | ";
    if (measured.study.levels.empty()) {
      file_ << "| | | | | | | | " << verdict(measured) << " |\n" << std::flush;
      return;
    }
    const Signorini::LevelRecord &level = measured.finest();
    number(level.dual.kkt);
    number(level.inf_sup);
    number(measured.condition > 0. ? std::optional<double>(measured.condition) : std::nullopt);
    file_ << measured.psor << " | " << measured.active_set << " | ";
    number(value(level, "u_h1"));
    number(value(level, "p_l2"));
    number(level.linear.rounding_error);
    file_ << verdict(measured) << " |\n" << std::flush;
  }

private:
  void number(const std::optional<double> &value) {
    if (value)
      file_ << std::setprecision(2) << *value;
    file_ << " | ";
  }

  /** For answers that are withheld, the first half sentence of the cause. */
  static std::string verdict(const Measured &measured) {
    const std::string &failure = measured.study.verdict.reason;
    return measured.is_certified()
             ? "certified"
             : "**exit code 2**: " + failure.substr(0, failure.find_first_of("(,;", 12)) + " …";
  }

  std::ofstream file_;
};
