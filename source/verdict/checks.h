// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/verdict/judge.h>

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
/** A residual of the certificate is above its bound. */
std::string check_residuals(const LevelRecord &level, const Judge &judge);

/** Some level is in doubt. */
std::string check_levels(const std::vector<LevelRecord> &levels, const Judge &judge);
/** On the finest level other pressures solve the dual problem, too. */
std::string check_uniqueness(const std::vector<LevelRecord> &levels, const Judge &judge);
/** On the finest level bilinear elements are too stiff for a nearly incompressible body. */
std::string check_locking(const std::vector<LevelRecord> &levels, const Judge &judge);
/** The estimated error does not fall. */
std::string check_estimate(const std::vector<LevelRecord> &levels, const Judge &judge);
} // namespace Signorini
