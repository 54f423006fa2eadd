// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "one_level.h"

/** A level with its answer and its bound. */
struct Bounded : public OneLevel {
  Bounded(const std::string &text, const unsigned int number)
    : OneLevel(text + "\nDiscretization/Target error = 1e-9\nOutput/Inf-sup constant = false\n",
               number)
    , solution(solve())
    , bound(solution.record.bound.value()) {}

  const Signorini::LevelSolution<2> solution;
  const Signorini::ErrorBound &bound;
};

/** u = (y²/10, 0), prescribed on three sides: u_h does not take it along edges. J(u) = 0.04/3. */
inline const std::string prescribed_parabola =
  "Contact/Gap = 100\nLoad/Body force = -0.2; 0\nMaterial/Poisson's ratio = 0\n"
  "Material/Young's modulus = 2\nBoundary/Contact = bottom\n"
  "Boundary/Displacement = top: 0.1; 0 | left: 0.1*y*y; 0 | right: 0.1*y*y; 0\n"
  "Exact solution/Displacement = 0.1*y^2; 0\n";
