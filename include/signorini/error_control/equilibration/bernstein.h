// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace Signorini {
/** Returns the coefficients of Bernstein, of degree n, of a sum of orthonormal Legendre polynomials
 * of degrees 0 to n on [0,1]. The values of the polynomial lie between the smallest and the largest
 * coefficient. */
std::vector<double> bernstein_coefficients(const std::vector<double> &legendre);

/** Returns the coefficients of orthonormal Legendre polynomials from those of Bernstein. */
std::vector<double> legendre_coefficients(const std::vector<double> &bernstein);
} // namespace Signorini
