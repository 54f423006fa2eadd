// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/study/study.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

/** Solves a study silently, without files. */
template <int dim = 2>
Signorini::StudyResult<dim> solve(const std::string &text,
                                  const std::vector<std::string> &overrides = {})
{
  std::ostream silence(nullptr);
  const Signorini::Parameters parameters = Signorini::parse_parameters(text, "test", overrides);
  return Signorini::run_study(parameters,
                              Signorini::make_scene<dim>(parameters),
                              MPI_COMM_WORLD,
                              {silence, "", [](const std::string &) {}});
}

/** Returns the parameter file of a scene of the catalogue. */
inline std::string named_scene(const std::string &name)
{
  return "subsection Scene\n set Name = " + name + "\n end\n";
}

/** Returns the overrides for a study from one level to another. */
inline std::vector<std::string> levels(const unsigned int coarsest, const unsigned int finest)
{
  return {"Discretization/Coarsest level=" + std::to_string(coarsest),
          "Discretization/Finest level=" + std::to_string(finest)};
}

/** Returns the least-squares slope of log(quantity) against log(h). */
inline double slope(const std::vector<Signorini::LevelRecord> &levels,
                    const std::function<double(const Signorini::LevelRecord &)> &quantity)
{
  double n = 0., x = 0., y = 0., xx = 0., xy = 0.;
  for (const Signorini::LevelRecord &level : levels)
  {
    const double a = std::log(level.sizes.h), b = std::log(quantity(level));
    n += 1.;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

/** Returns the slope of a column. */
inline double slope(const std::vector<Signorini::LevelRecord> &levels, const std::string &column)
{
  return slope(levels, [&column](const Signorini::LevelRecord &level) {
    return Signorini::value(level, column).value();
  });
}

/** Returns |a - b| / |b|. */
template <typename First, typename Second>
double relative_distance(const First &a, const Second &b)
{
  First difference(a);
  difference -= b;
  return difference.l2_norm() / b.l2_norm();
}
