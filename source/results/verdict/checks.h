// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/results/verdict/judge.h>

#include <string>
#include <vector>

// Each check returns one sentence that says what is wrong and what helps, or nothing.

namespace Signorini
{
/** A number is infinite or not a number. */
std::string check_overflow(const LevelRecord &level, const Judge &judge);
/** Rounding leaves less than six digits of U. */
std::string check_rounding(const LevelRecord &level, const Judge &judge);
/** The KKT residual of the dual problem is above the tolerance. */
std::string check_dual_problem(const LevelRecord &level, const Judge &judge);
/** The dual problem of a load case was not solved. */
std::string check_load_cases(const LevelRecord &level, const Judge &judge);
/** A residual of the certificate is above its bound. */
std::string check_residuals(const LevelRecord &level, const Judge &judge);

/** The finest level is in doubt. Coarser ones do not matter: it does not depend on them. */
std::string check_finest_level(const std::vector<LevelRecord> &levels, const Judge &judge);
/** Two brackets of the energy have no number in common. */
std::string check_brackets(const std::vector<LevelRecord> &levels, const Judge &judge);
/** On the finest level other pressures solve the dual problem, too. */
std::string check_uniqueness(const std::vector<LevelRecord> &levels, const Judge &judge);
/** The bound of the error on the finest level, or without one its estimate, is larger than what is
 * tolerated, or nothing is known about the error. */
std::string check_error(const std::vector<LevelRecord> &levels, const Judge &judge);
/** The user has set a target error, and the finest level does not reach it. */
std::string check_target(const std::vector<LevelRecord> &levels, const Judge &judge);
/** On the finest level bilinear elements are too stiff for a nearly incompressible body, and what
 * is known about the error does not exclude that. */
std::string check_locking(const std::vector<LevelRecord> &levels, const Judge &judge);
/** The bracket of the energy is too wide: strain energy and work of loads nearly cancel. */
std::string check_energy(const std::vector<LevelRecord> &levels, const Judge &judge);
/** Without a bound: the estimated error does not fall. */
std::string check_estimate(const std::vector<LevelRecord> &levels, const Judge &judge);
} // namespace Signorini
