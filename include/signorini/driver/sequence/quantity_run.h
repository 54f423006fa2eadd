// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/progress.h>
#include <signorini/results/verdict/level_result.h>

namespace Signorini {
/**
 * Adds ProbeReport::means to the record of a level with a guaranteed bound b of |||u - u_h|||, for
 * the probes that ask for guaranteed means; s bounds ‖σ(u) - τ‖ (ReferenceStress::stress_error):
 *
 * - the mean over P of l:σ, l = e_i e_jᵀ: |mean - mean_h| ≤ (l:E:l/|P|)^{1/2} b;
 * - the mean of u_i on a side: |m(u) - m(u_h)| ≤ |||u_m||| b, u_m the displacement under the
 *   traction e_i/|side| alone, supports at zero, contact sides free;
 * - R(σ) = ∫ σn·φ over a side that is held or in contact, with φ = e_i or on a stretch a weight
 *   times n: |R(σ) - R(τ)| ≤ s |||Φ|||, Φ the displacement with Φ = φ on the side and with no
 *   motion, or on rollers and flat contact sides without friction none along n, where tractions
 *   are not known.
 *
 * |||u_m||| and |||Φ||| come from graded runs of these linear scenes, with their guaranteed bounds.
 * The weight is 1 on the middle half of the stretch, 10 r³ - 15 r⁴ + 6 r⁵ in the quarters beside it
 * and zero elsewhere. Collective.
 */
void add_guaranteed_means(const Parameters &parameters, const Scene<2> &scene,
                          LevelResult<2> &level, const Progress &progress);
} // namespace Signorini
