// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/study/study.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/verification/catalogue/catalogue.h>
#include <signorini/verification/verify.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "scene_text.h"
#include "tests.h"

/** Runs a study silently, without files unless a directory is given. */
template <int dim>
Signorini::StudyResult<dim> run(const Signorini::Parameters &parameters,
                                const Signorini::Scene<dim> &scene,
                                const std::string &directory = "") {
  std::ostream silence(nullptr);
  return Signorini::run_study(parameters, scene, MPI_COMM_WORLD,
                              {silence, directory, [](const std::string &) {}},
                              Signorini::make_verify(parameters, scene));
}

/** Solves the scene of a text. */
template <int dim = 2>
Signorini::StudyResult<dim> solve(const std::string &text,
                                  const std::vector<std::string> &overrides = {}) {
  const Signorini::Parameters parameters =
    Signorini::parse_parameters(parameter_file(text), "test", overrides);
  return run(parameters, Signorini::make_scene<dim>(parameters, Signorini::named_scenes()));
}

/** Solves the scene of a file. */
template <int dim = 2>
Signorini::StudyResult<dim> solve_file(const std::string &file,
                                       const std::vector<std::string> &overrides = {},
                                       const std::string &directory = "") {
  const Signorini::Parameters parameters = Signorini::read_parameters(file, overrides);
  return run(parameters, Signorini::make_scene<dim>(parameters, Signorini::named_scenes()),
             directory);
}

/** Returns the parameter file of a scene of the catalogue. */
inline std::string named_scene(const std::string &name) {
  return "subsection Scene\n set Name = " + name + "\n end\n";
}

/** Returns the overrides for a study from one level to another, and more of them. */
inline std::vector<std::string> levels(const unsigned int coarsest, const unsigned int finest,
                                       std::vector<std::string> more = {}) {
  more.push_back("Discretization/Coarsest level=" + std::to_string(coarsest));
  more.push_back("Discretization/Finest level=" + std::to_string(finest));
  return more;
}

/** Returns a column of the last level, which must be known. */
template <int dim>
double last(const Signorini::StudyResult<dim> &result, const std::string &column) {
  return Signorini::value(result.levels.back(), column).value();
}

/** A line by least squares, and how well it fits. */
struct Line {
  double slope, correlation;
};

inline Line fit(const std::vector<double> &x, const std::vector<double> &y) {
  const auto covariance = [n = x.size()](const std::vector<double> &a,
                                         const std::vector<double> &b) {
    return n * std::inner_product(a.begin(), a.end(), b.begin(), 0.) -
           std::accumulate(a.begin(), a.end(), 0.) * std::accumulate(b.begin(), b.end(), 0.);
  };
  const double xx = covariance(x, x), xy = covariance(x, y);
  return {xy / xx, xy / std::sqrt(xx * covariance(y, y))};
}

/** Returns the least-squares slope of log(quantity) against log(h). */
inline double slope(const std::vector<Signorini::LevelRecord> &levels,
                    const std::function<double(const Signorini::LevelRecord &)> &quantity) {
  std::vector<double> x, y;
  for (const Signorini::LevelRecord &level : levels) {
    x.push_back(std::log(level.sizes.h));
    y.push_back(std::log(quantity(level)));
  }
  return fit(x, y).slope;
}

/** Returns the slope of a column. */
inline double slope(const std::vector<Signorini::LevelRecord> &levels, const std::string &column) {
  return slope(levels, [&column](const Signorini::LevelRecord &level) {
    return Signorini::value(level, column).value();
  });
}

/** Checks that the slopes of columns lie between two numbers. */
inline void check_orders(Checks &checks, const std::vector<Signorini::LevelRecord> &levels,
                         const std::vector<std::tuple<std::string, double, double>> &orders) {
  for (const auto &[column, low, high] : orders)
    checks.between("order of " + column, slope(levels, column), low, high);
}

/** Returns |a - b| / |b|. */
template <typename First, typename Second>
double relative_distance(const First &a, const Second &b) {
  First difference(a);
  difference -= b;
  return difference.l2_norm() / b.l2_norm();
}
