// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/foundation.h>
#include <signorini/scene/geometry.h>
#include <signorini/scene/kinks.h>
#include <signorini/scene/load_case.h>
#include <signorini/scene/material.h>
#include <signorini/scene/plate.h>

#include <deal.II/base/function.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
/** What happens on a side of the body; every side has exactly one role. */
enum class Role
{
  /** sigma n = 0. */
  free,
  /** u = 0. */
  clamped,
  /** u.n = 0, sigma_T = 0. */
  roller,
  /** u given. */
  displacement,
  /** sigma n given. */
  traction,
  /** u.n <= g, sigma_n <= 0, sigma_n (u.n - g) = 0, sigma_T = 0. */
  contact
};

template <int dim>
using FunctionPointer = std::shared_ptr<const dealii::Function<dim>>;

/** The role of one side and the data that belongs to it. */
template <int dim>
struct BoundaryCondition
{
  Role role = Role::free;
  /** Prescribed displacement or traction (dim components), or gap (one); else empty. */
  FunctionPointer<dim> data;
  /** Exact contact pressure p = sigma_n of a contact side, if known. */
  FunctionPointer<dim> exact_pressure;
  /** Of a contact side whose gap is the distance to rigid things: these things, so that the gap can
   * be had for another position of theirs, foundation_gap(side, foundation, position). Else empty.
   */
  std::shared_ptr<const Foundation> foundation = nullptr;
};

/** Problem (1): a body, its material, what holds it, loads it and stops it. */
template <int dim>
struct Scene
{
  std::string name;
  /** One line that says what the scene shows. */
  std::string title;
  /** What a catalogue scene solves, in lines; empty where the parameters say it. */
  std::string description;
  Geometry<dim> geometry;
  /** boundary[i] belongs to geometry.sides[i]. */
  std::vector<BoundaryCondition<dim>> boundary;
  /** Sides that rigid plates move (in the plane). Their role is displacement; their data is what is
   * given of the motion, and all of it once it is known (with_plates_moved()). */
  std::vector<Plate> plates;
  /** Whether rigid motions are left that contact alone can stop: then single degrees of freedom are
   * pinned while the system is solved, and the motions are unknowns of the dual problem. */
  bool is_held_by_contact = false;
  /** Other loads that the finest level is solved for, too. */
  std::vector<LoadCase> load_cases;
  std::shared_ptr<const Material<dim>> material;
  /** f of (1), dim components; empty means zero. */
  FunctionPointer<dim> body_force;
  /** u of (1) with its gradient, dim components; empty means unknown. */
  FunctionPointer<dim> exact_displacement;
  /** By how much the foundations of all sides are moved in `data` (length). */
  dealii::Tensor<1, dim> foundation_position;
  /** Where the data is not smooth. */
  Kinks<dim> kinks;

  /** The numbers of the contact sides gamma_{c,i}, i = 1..n_g. */
  std::vector<unsigned int> contact_sides() const;
  /** Whether p is known on every contact side. */
  bool has_exact_pressure() const;
};

/** The scene with the plates where they have moved to: an ordinary scene with prescribed
 * displacements. @param motions one for each plate. */
template <int dim>
Scene<dim> with_plates_moved(Scene<dim> scene, const std::vector<PlateMotion> &motions);

/** The same with nothing else prescribed: all other given displacements are zero. */
template <int dim>
Scene<dim> with_only_plates_moved(Scene<dim> scene, const std::vector<PlateMotion> &motions);
} // namespace Signorini
