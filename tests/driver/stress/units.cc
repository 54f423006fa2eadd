// SPDX-License-Identifier: LGPL-2.1-or-later
// Units of length and stress: the same iterations, and the same numbers after conversion.

#include "stress.h"

using namespace Signorini;

namespace
{
/** Largest relative difference over the levels after division by the unit. */
template <typename Quantity>
double difference(const StudyResult<2> &found,
                  const StudyResult<2> &expected,
                  const double unit,
                  const Quantity &quantity)
{
  double largest = 0.;
  for (std::size_t k = 0; k < expected.levels.size(); ++k)
  {
    const double reference = quantity(expected.levels[k]);
    largest = std::max(
      largest, std::abs(quantity(found.levels[k]) / unit - reference) / std::abs(reference));
  }
  return largest;
}

void compare(Checks &checks,
             const Measured &reference,
             const std::string &length,
             const std::string &stress)
{
  Family family;
  family.length = length;
  family.stress = stress;
  const Measured found = measure(text_of(family), levels(2, 6));
  const double L = std::stod(length), S = std::stod(stress);
  const std::string name = "lengths times " + length + ", stresses times " + stress;
  checks.that(name + ": certified", found.is_certified());
  bool same_iterations = found.psor == reference.psor && found.active_set == reference.active_set;
  for (std::size_t k = 0; k < reference.study.levels.size(); ++k)
    same_iterations = same_iterations && found.study.levels[k].dual.iterations ==
                                           reference.study.levels[k].dual.iterations;
  checks.that(name + ": the same iterations", same_iterations);
  const auto near = [&](const std::string &what, const double unit, const auto &quantity) {
    checks.near(
      name + ": " + what, difference(found.study, reference.study, unit, quantity), 0., 1e-9);
  };
  near("|u-uh|_0", L * L, [](const LevelRecord &level) { return *value(level, "u_l2"); });
  near(
    "|p-pH|_0", S * std::sqrt(L), [](const LevelRecord &level) { return *value(level, "p_l2"); });
  near("energy", S * L * L, [](const LevelRecord &level) { return level.certificate.energy; });
  near("force", S * L, [](const LevelRecord &level) { return level.contact.normal_force; });
  near("largest pressure", S, [](const LevelRecord &level) { return level.contact.max_pressure; });
  near("estimate", 1., [](const LevelRecord &level) { return level.estimate->relative; });
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  const Measured reference = measure(text_of({}), levels(2, 6));
  for (const auto &units : std::vector<std::pair<std::string, std::string>>{{"1", "1e9"},
                                                                            {"1", "1e-9"},
                                                                            {"1e6", "1"},
                                                                            {"1e-6", "1"},
                                                                            {"1e-6", "1e9"},
                                                                            {"1e6", "1e-9"}})
    compare(checks, reference, units.first, units.second);
  return checks.exit_code();
}
