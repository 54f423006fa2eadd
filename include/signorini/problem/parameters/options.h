// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
/** What the third direction does in two dimensions. */
enum class PlaneState
{
  strain,
  stress
};

/** The method for the dual problem. */
enum class ContactSolver
{
  /** multigrid on levels with many unknowns where it may be used, else active_set. */
  automatic,
  /** Projected SOR. */
  psor,
  /** The primal-dual active set method. */
  active_set,
  /** MPRGP: conjugate gradients and projected gradient steps. */
  mprgp,
  /** V-cycles, each followed by a problem on the boundary; no dual problem is formed. */
  multigrid
};

/** When V-cycles for contact end. */
enum class StopAt
{
  /** At the tolerance. */
  tolerance,
  /** At a tenth of the error of the discretisation, as the level before lets it expect. */
  discretisation_error
};

/** How systems with the stiffness matrix are solved. */
enum class LinearSolver
{
  /** condensed on one rank, amesos_mumps on several. */
  automatic,
  /** CHOLMOD; eliminates the contact unknowns last. One rank only. */
  condensed,
  /** MUMPS, distributed over all ranks. */
  amesos_mumps,
  /** KLU, gathered on one rank. */
  amesos_klu,
  /** Conjugate gradients with V-cycles; A is not assembled. One rank only. */
  multigrid
};

/** The shape of the body. */
enum class Shape
{
  rectangle,
  /** In space. */
  box,
  polygon,
  half_disc,
  disc,
  ring,
  /** A mesh file. */
  file
};

/** Hooke's law. */
enum class MaterialLaw
{
  isotropic,
  orthotropic,
  general
};

/** How the meshes of a study follow one another. */
enum class Strategy
{
  /** Each is the one before with every cell split: the paper's. */
  nested,
  /** Each is graded to what is singular in the solution of the one before, with degrees that rise
   * away from there. */
  hp
};

/** The multipliers on graded meshes. */
enum class HpMultipliers
{
  /** Polynomials of degree p - 2 on every face, with the sign condition at their Gauss points. */
  gauss,
  /** u_n <= g at the nodes of the trace of V^h. */
  nodal
};

/** The displacement element. */
enum class Element
{
  q1,
  /** Q1 with a dilatation that is averaged over cells. */
  q1_b_bar
};

/** The levels for which VTU files are written. */
enum class VtuLevels
{
  none,
  finest,
  all
};

/** Yes, no, or as the program sees fit. */
enum class Choice
{
  yes,
  no,
  automatic
};

/** The values of an option and their names in a parameter file. */
template <typename Option>
using OptionNames = std::vector<std::pair<Option, std::string>>;

/** All values of an option, in the order in which messages list them. */
template <typename Option>
const OptionNames<Option> &option_names();

template <>
const OptionNames<Shape> &option_names();
template <>
const OptionNames<MaterialLaw> &option_names();
template <>
const OptionNames<PlaneState> &option_names();
template <>
const OptionNames<Strategy> &option_names();
template <>
const OptionNames<HpMultipliers> &option_names();
template <>
const OptionNames<Element> &option_names();
template <>
const OptionNames<ContactSolver> &option_names();
template <>
const OptionNames<StopAt> &option_names();
template <>
const OptionNames<LinearSolver> &option_names();
template <>
const OptionNames<VtuLevels> &option_names();
template <>
const OptionNames<Choice> &option_names();

/** The name of a value in a parameter file. */
template <typename Option>
std::string to_text(const Option value)
{
  for (const auto &entry : option_names<Option>())
    if (entry.first == value)
      return entry.second;
  throw std::out_of_range("this value of an option has no name");
}

/** The value with a name. @throws std::out_of_range if there is none. */
template <typename Option>
Option from_text(const std::string &name)
{
  for (const auto &entry : option_names<Option>())
    if (entry.second == name)
      return entry.first;
  throw std::out_of_range("no value of this option has the name " + name);
}

/** All names, joined by a separator. */
template <typename Option>
std::string list_names(const std::string &separator)
{
  std::string list;
  for (const auto &entry : option_names<Option>())
    list += (list.empty() ? "" : separator) + entry.second;
  return list;
}
} // namespace Signorini
