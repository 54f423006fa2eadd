// SPDX-License-Identifier: LGPL-2.1-or-later
// The names of all options.

#include <signorini/problem/parameters/options.h>

namespace Signorini
{
template <>
const OptionNames<Shape> &option_names()
{
  static const OptionNames<Shape> names = {{Shape::rectangle, "rectangle"},
                                           {Shape::box, "box"},
                                           {Shape::polygon, "polygon"},
                                           {Shape::half_disc, "half disc"},
                                           {Shape::disc, "disc"},
                                           {Shape::ring, "ring"},
                                           {Shape::file, "file"}};
  return names;
}

template <>
const OptionNames<MaterialLaw> &option_names()
{
  static const OptionNames<MaterialLaw> names = {{MaterialLaw::isotropic, "isotropic"},
                                                 {MaterialLaw::orthotropic, "orthotropic"},
                                                 {MaterialLaw::general, "general"}};
  return names;
}

template <>
const OptionNames<PlaneState> &option_names()
{
  static const OptionNames<PlaneState> names = {{PlaneState::strain, "strain"},
                                                {PlaneState::stress, "stress"}};
  return names;
}

template <>
const OptionNames<Strategy> &option_names()
{
  static const OptionNames<Strategy> names = {{Strategy::nested, "nested"}, {Strategy::hp, "hp"}};
  return names;
}

template <>
const OptionNames<Element> &option_names()
{
  static const OptionNames<Element> names = {
    {Element::q1, "Q1"}, {Element::q1_b_bar, "Q1 B-bar"}, {Element::q2, "Q2"}};
  return names;
}

template <>
const OptionNames<ContactSolver> &option_names()
{
  static const OptionNames<ContactSolver> names = {{ContactSolver::automatic, "automatic"},
                                                   {ContactSolver::psor, "psor"},
                                                   {ContactSolver::active_set, "active set"},
                                                   {ContactSolver::mprgp, "mprgp"},
                                                   {ContactSolver::multigrid, "multigrid"}};
  return names;
}

template <>
const OptionNames<StopAt> &option_names()
{
  static const OptionNames<StopAt> names = {{StopAt::tolerance, "tolerance"},
                                            {StopAt::discretisation_error, "discretisation error"}};
  return names;
}

template <>
const OptionNames<LinearSolver> &option_names()
{
  static const OptionNames<LinearSolver> names = {{LinearSolver::automatic, "automatic"},
                                                  {LinearSolver::condensed, "condensed"},
                                                  {LinearSolver::amesos_mumps, "amesos_mumps"},
                                                  {LinearSolver::amesos_klu, "amesos_klu"},
                                                  {LinearSolver::multigrid, "multigrid"}};
  return names;
}

template <>
const OptionNames<VtuLevels> &option_names()
{
  static const OptionNames<VtuLevels> names = {
    {VtuLevels::none, "none"}, {VtuLevels::finest, "finest"}, {VtuLevels::all, "all"}};
  return names;
}

template <>
const OptionNames<Choice> &option_names()
{
  static const OptionNames<Choice> names = {
    {Choice::yes, "true"}, {Choice::no, "false"}, {Choice::automatic, "automatic"}};
  return names;
}
} // namespace Signorini
