// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/results/verdict/judge.h>

#include <string>
#include <vector>

// Every check returns one sentence with what is wrong and what helps, or nothing.

namespace Signorini
{
/** Checks that no number is infinite or not a number. */
std::string check_overflow(const LevelRecord &level, const Judge &judge);
/** Checks that rounding leaves at least six digits of U. */
std::string check_rounding(const LevelRecord &level, const Judge &judge);
/** Checks the KKT residual of the dual problem against the tolerance. */
std::string check_dual_problem(const LevelRecord &level, const Judge &judge);
/** Checks that the dual problem of every load case was solved. */
std::string check_load_cases(const LevelRecord &level, const Judge &judge);
/** Checks the residuals of the certificate against their bound. */
std::string check_residuals(const LevelRecord &level, const Judge &judge);

/** Checks that the finest level is not in doubt. Coarser ones do not matter: it does not depend on
 * them. */
std::string check_finest_level(const std::vector<LevelRecord> &levels, const Judge &judge);
/** Checks that all brackets of the energy have a number in common. */
std::string check_brackets(const std::vector<LevelRecord> &levels, const Judge &judge);
/** Checks that no other pressures solve the dual problem on the finest level. */
std::string check_uniqueness(const std::vector<LevelRecord> &levels, const Judge &judge);
/** Checks that the bound of the error on the finest level, or without one its estimate, is known
 * and tolerated. */
std::string check_error(const std::vector<LevelRecord> &levels, const Judge &judge);
/** Checks that the finest level reaches a target error that the user has set. */
std::string check_target(const std::vector<LevelRecord> &levels, const Judge &judge);
/** Checks that on the finest level bilinear elements are not too stiff for a nearly incompressible
 * body, unless the known error excludes that. */
std::string check_locking(const std::vector<LevelRecord> &levels, const Judge &judge);
/** Checks that the bracket of the energy is not too wide: strain energy and work of loads may
 * nearly cancel. */
std::string check_energy(const std::vector<LevelRecord> &levels, const Judge &judge);
/** Checks, without a bound, that the estimated error falls. */
std::string check_estimate(const std::vector<LevelRecord> &levels, const Judge &judge);
} // namespace Signorini
