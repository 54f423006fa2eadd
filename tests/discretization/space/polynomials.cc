// SPDX-License-Identifier: LGPL-2.1-or-later
// Multipliers with several unknowns on a patch: the basis, its integrals, R^H, D and G of
// polynomials.

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

#include "error_control/hp/graded.h"
#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
/** Degrees 2 to 7, one to six unknowns per patch, on faces of two oblique sides. */
struct Pentagon : public GradedLevel {
  explicit Pentagon(const std::string &gap)
    : GradedLevel("subsection Geometry\nset Shape = polygon\n"
                  "set Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1\nend\n"
                  "subsection Boundary\nset Clamped = side0\nset Contact = side2 side3\nend\n" +
                    entry("Contact", "Gap", gap),
                  plan()) {}

private:
  static MeshPlan plan() {
    MeshPlan plan = uniform_plan(1, 7);
    plan.base_size = 0.5;
    plan.singularities = {corner({1., 2.5}, 5.)};
    return plan;
  }
};

/** int f over a patch. */
double integral(const Patch<2> &patch, const std::function<double(const Point<1> &)> &f) {
  const dealii::QGauss<1> gauss(12);
  double sum = 0.;
  for (unsigned int q = 0; q < gauss.size(); ++q)
    sum += f(patch.lower + gauss.point(q)[0] * (patch.upper - patch.lower)) * gauss.weight(q);
  return sum * patch.measure;
}

void basis(Checks &checks, const MultiplierSpace<2> &space) {
  const std::vector<Patch<2>> &patches = space.surface().patches();
  unsigned int most = 0, n_all = 0;
  double unity = 0., lagrange = 0., integrals = 0., products = 0., values = 0.;
  const dealii::Vector<double> squares = space.integrals();
  const Pressure P(RandomNumbers(5).vector(space.n_multipliers()));
  for (unsigned int patch = 0; patch < patches.size(); ++patch) {
    const unsigned int first = space.first_of(patch), n = space.n_of(patch);
    most = std::max(most, n);
    n_all += n;
    for (const double r : {0., 0.1, 0.6, 1.}) {
      const Point<1> s = patches[patch].lower + r * (patches[patch].upper - patches[patch].lower);
      double sum = 0., p = 0.;
      for (unsigned int k = first; k < first + n; ++k) {
        sum += space.shape_value(k, s);
        p += P[k] * space.shape_value(k, s);
      }
      unity = std::max(unity, std::abs(sum - 1.));
      values = std::max(values, std::abs(space.value(P, patch, s) - p));
    }
    for (unsigned int k = first; k < first + n; ++k) {
      if (space.patch_of(k) != patch)
        lagrange = 1.;
      integrals =
        std::max(integrals, std::abs(squares[k] - integral(patches[patch], [&](const Point<1> &s) {
                                       return space.shape_value(k, s);
                                     })));
      for (unsigned int j = first; j < first + n; ++j) {
        lagrange =
          std::max(lagrange, std::abs(space.shape_value(k, space.node(j)) - (j == k ? 1. : 0.)));
        products =
          std::max(products, std::abs((j == k ? squares[k] : 0.) -
                                      integral(patches[patch], [&](const Point<1> &s) {
                                        return space.shape_value(j, s) * space.shape_value(k, s);
                                      })));
      }
    }
  }
  checks.that("one to six unknowns per patch", most == 6);
  checks.that("the unknowns are numbered by patch",
              n_all == space.n_multipliers() && !space.is_piecewise_constant());
  checks.near("sum of psi_k = 1", unity, 0., 1e-12);
  checks.near("psi_k at the nodes", lagrange, 0., 1e-10);
  checks.near("int psi_k", integrals, 0., 1e-13);
  checks.near("int psi_j psi_k", products, 0., 1e-13);
  checks.near("p_H = sum P_k psi_k", values, 0., 1e-13);
}

/** R^H of s^n on n unknowns is its interpolant at the Gauss points: the remainder is a multiple of
 * Legendre's polynomial of degree n, which is orthogonal to Q^H and vanishes there. */
void projections(Checks &checks, const MultiplierSpace<2> &space) {
  for (const Grading grading : {Grading::none, Grading::towards_kinks})
    for (unsigned int degree = 0; degree <= 6; ++degree) {
      const auto moments = integrate_against_multipliers(
        space, 4, grading, [&](const Piece<2> &, const SurfaceRule<2> &rule) {
          std::vector<double> values;
          for (const auto &s : rule.on_side)
            values.push_back(std::pow(s[0] - 0.5, degree));
          return values;
        });
      const auto coefficients = space.project(moments);
      double error = 0.;
      for (unsigned int k = 0; k < space.n_multipliers(); ++k)
        if (space.n_of(space.patch_of(k)) >= degree)
          error =
            std::max(error, std::abs(coefficients[k] - std::pow(space.node(k)[0] - 0.5, degree)));
      checks.near("projection of degree " + std::to_string(degree), error, 0., 1e-11);
    }
}

/** max over patches of |sum_k b_k s_k^j - int f s^j| for all s^j in Q^H: sum_k s_k^j psi_k = s^j.
 */
double moment_error(const MultiplierSpace<2> &space, const dealii::Vector<double> &b,
                    const std::function<double(const Patch<2> &, const Point<1> &)> &f) {
  double error = 0.;
  for (unsigned int patch = 0; patch < space.surface().patches().size(); ++patch) {
    const Patch<2> &interval = space.surface().patches()[patch];
    for (unsigned int j = 0; j < space.n_of(patch); ++j) {
      double found = 0.;
      for (unsigned int k = space.first_of(patch); k < space.first_of(patch + 1); ++k)
        found += b[k] * std::pow(space.node(k)[0], j);
      error = std::max(error, std::abs(found - integral(interval, [&](const Point<1> &s) {
                                         return f(interval, s) * std::pow(s[0], j);
                                       })));
    }
  }
  return error;
}

/** D^T U = int u_n psi_k for u of degree two, which all elements have; G = int g psi_k. */
void couplings(Checks &checks, const Pentagon &level) {
  const MultiplierSpace<2> &space = level.multipliers();
  const Field u = [](const Point<2> &x) {
    return Point<2>(0.3 * x[0] * x[0] - x[1], x[0] * x[1] + 0.2 * x[1] * x[1] + 1.);
  };
  const auto normal = [&](const Patch<2> &patch, const Point<1> &s) {
    const Side<2> &side = space.surface().side(patch);
    return u(side.point(s)) * side.normal(s);
  };
  const Displacement U = nodal_values(level.space(), u);
  const Coupling &D = level.discretization.D, &condensed_D = level.discretization.condensed_D;
  checks.near("D^T U", moment_error(space, D.transpose_product(U), normal), 0., 1e-13);
  checks.near("G",
              moment_error(space, level.discretization.G,
                           [&](const Patch<2> &patch, const auto &s) {
                             const Point<2> x = space.surface().side(patch).point(s);
                             return std::pow(x[0], 3) - 0.1 * x[1];
                           }),
              0., 1e-13);
  // u = 0 on the clamped side0, where y = 0: the condensed D sees the free values only, and gives
  // the same product, hanging nodes or not.
  const Field held = [](const Point<2> &x) { return Point<2>(x[0] * x[1], x[1] * x[1]); };
  const Displacement V = nodal_values(level.space(), held);
  checks.near("condensed D^T U", distance(condensed_D.transpose_product(V), D.transpose_product(V)),
              0., 1e-13);
}

} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {[](Checks &checks) {
                     const Pentagon level("x^3 - 0.1*y");
                     basis(checks, level.multipliers());
                     projections(checks, level.multipliers());
                     couplings(checks, level);
                   }});
}
