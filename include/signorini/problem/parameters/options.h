// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/sector.h>

#include <string>
#include <typeindex>
#include <vector>

namespace Signorini {
/** The state in the direction normal to a 2-D body. */
enum class PlaneState { strain, stress, axisymmetric };

/** The method for the dual problem. */
enum class ContactSolver {
  /** Chooses multigrid on levels with many unknowns where it may be used, else active_set. */
  automatic,
  /** Projected SOR. */
  psor,
  /** The primal-dual active set method. */
  active_set,
  /** V-cycles, each followed by a problem on the boundary; no dual problem is formed. */
  multigrid
};

/** The solver of systems with the stiffness matrix. */
enum class LinearSolver {
  /** Chooses condensed in serial, amesos_mumps on several ranks. */
  automatic,
  /** CHOLMOD, which eliminates the contact unknowns last; serial. */
  condensed,
  /** MUMPS, distributed over all ranks. */
  amesos_mumps,
  /** KLU, gathered on one rank. */
  amesos_klu,
  /** Conjugate gradients with V-cycles; A is not assembled; serial. */
  multigrid
};

/** The shape of the body. */
enum class Shape {
  rectangle,
  /** A box in 3-D. */
  box,
  polygon,
  half_disc,
  disc,
  ring,
  /** In 3-D. */
  ball,
  cylinder,
  tube,
  /** The body of a mesh file. */
  file
};

/** Hooke's law. */
enum class MaterialLaw { isotropic, orthotropic, general };

/** The way in which the meshes of a study follow one another. */
enum class Strategy {
  /** Chooses hp where nothing asks for nested meshes. */
  automatic,
  /** Each mesh is the one before with every cell split, as in the paper. */
  nested,
  /** Each mesh is graded to the singularities of the solution on the one before, with degrees that
   * rise away from them. */
  hp
};

/** The displacement element. */
enum class Element {
  q1,
  /** Q1 with the dilatation averaged over each cell (B-bar). */
  q1_b_bar,
  /** Biquadratic: the method of the paper one order up, with constants on patches as before. */
  q2
};

/** The direction along which contact with planes of a foundation acts. */
enum class ContactDirection {
  /** The plane's own normal. */
  foundation,
  /** The outward normal of the body, as in the paper. */
  body
};

/** The law of friction on the contact sides. */
enum class Friction {
  none,
  /** |P_t| ≤ s with a given bound s. */
  tresca,
  /** |P_t| ≤ f |P_n|. */
  coulomb
};

/** The relation of load cases to one another. */
enum class CaseSequence {
  independent,
  /** Each case goes on from the state of friction of the one before. */
  steps
};

/** The levels for which VTU files are written. */
enum class VtuLevels { none, finest, all };

/** A setting that is on, off, or chosen by the program. */
enum class Choice { yes, no, automatic };

/** Whether the bound of the error is computed: where it is known how, or never. */
enum class WantedBound { automatic, none };

/** Returns the names of an enumeration's values in a parameter file, in their order. */
const std::vector<std::string> &option_names(const std::type_index &option);

/** Returns the name of a value in a parameter file. */
template <typename Option>
std::string to_text(const Option value) {
  return option_names(typeid(Option)).at(static_cast<std::size_t>(value));
}
} // namespace Signorini
