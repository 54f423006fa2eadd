// SPDX-License-Identifier: LGPL-2.1-or-later
// The columns of errors against an exact solution, and of the numbers of the lemmas.

#include <signorini/results/verdict/exact_errors.h>

namespace Signorini {
Columns<DisplacementErrors> DisplacementErrors::columns() {
  return {{"u_h1", &DisplacementErrors::h1},
          {"u_l2", &DisplacementErrors::l2},
          {"u_superclose_h1", &DisplacementErrors::superclose_h1},
          {"u_post_h1", &DisplacementErrors::post_h1},
          {"u_post4_h1", &DisplacementErrors::post4_h1},
          {"u_energy", &DisplacementErrors::energy}};
}

Columns<PressureErrors> PressureErrors::columns() {
  return {{"p_l2", &PressureErrors::l2}, {"p_post_l2", &PressureErrors::post_l2}};
}

Columns<DualNormErrors> DualNormErrors::columns() {
  return {{"p_dual", &DualNormErrors::slobodeckij},
          {"p_dual_spectral", &DualNormErrors::spectral},
          {"p_superclose_dual", &DualNormErrors::superclose_slobodeckij},
          {"p_superclose_dual_spectral", &DualNormErrors::superclose_spectral}};
}

Columns<LemmaNumbers> LemmaNumbers::columns() {
  return {{"lemma_2_l2", &LemmaNumbers::projection_l2},
          {"lemma_2_dual", &LemmaNumbers::projection_dual},
          {"lemma_3_h1", &LemmaNumbers::interpolation_h1},
          {"lemma_3_trace", &LemmaNumbers::interpolation_trace},
          {"lemma_5", &LemmaNumbers::consistency},
          {"bound_26", &LemmaNumbers::bound_26},
          {"bound_27", &LemmaNumbers::bound_27},
          {"bound_30", &LemmaNumbers::bound_30}};
}
} // namespace Signorini
