// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/scene/foundation.h>
#include <signorini/problem/scene/material.h>

#include <deal.II/base/function.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
/**
 * Lengths and moduli of a described scene lie between these bounds, loads and displacements below
 * the upper one: far enough from the ends of the double precision for products such as an energy
 * f² L⁴/E or a determinant of moduli. Other units bring every real body into this range.
 */
constexpr double smallest_magnitude = 1e-30;
constexpr double largest_magnitude = 1e30;

/** How many times its own size a body may lie away from the origin: x - y loses that much. */
constexpr double largest_distance = 1e6;

/** How many times longer than thick a body may be, and longer than its shortest side. */
constexpr double largest_slenderness = 1e6;

/** A scene with other loads and another foundation; the body and what holds it are the same, and so
 * is its stiffness. */
struct LoadCase
{
  /** Factor of tractions and of the forces and moments on plates. */
  double force = 1.;
  /** Factor of the body force. */
  double weight = 1.;
  /** Factor of prescribed displacements and of the given travels of plates. */
  double travel = 1.;
  /** Factor of the gap. */
  double gap = 1.;
  /** By how much the foundation is moved, beside Contact/Foundation position (length). */
  dealii::Tensor<1, 2> shift;
  /** Whether its fields are written. */
  bool has_fields = false;
};

/** How far a plate has moved. */
struct PlateMotion
{
  /** delta, along the plate's direction (length). */
  double travel = 0.;
  /** theta, counter-clockwise about the plate's centre (radians, small). */
  double rotation = 0.;
};

/**
 * A side to which a rigid plate is bonded: u = delta d + theta (-(y - c2), x - c1) on it. Each of
 * the two motions is given, or the force or the moment that drives it is.
 */
struct Plate
{
  /** Number of the side in the geometry. */
  unsigned int side = 0;
  /** d, a unit vector. */
  dealii::Tensor<1, 2> direction;
  /** c, the middle of the side. */
  dealii::Point<2> centre;
  /** Whether a force drives the travel; otherwise it is given. */
  bool is_pushed = false;
  /** Along d (force per thickness); of a plate that is pushed. */
  double force = 0.;
  /** delta of a plate that is not pushed (length). */
  double travel = 0.;
  /** Whether a moment drives the rotation; otherwise it is zero. */
  bool turns = false;
  /** About c, counter-clockwise (force x length per thickness); of a plate that turns. */
  double moment = 0.;

  /** The displacement of the point @p x of the plate. */
  dealii::Tensor<1, 2> displacement(const PlateMotion &motion, const dealii::Point<2> &x) const;
  /** What the force and the moment that drive the plate do in a motion (force x length per
   * thickness). */
  double work(const PlateMotion &motion) const
  {
    return force * motion.travel + moment * motion.rotation;
  }
};

/** The displacement of a plate as data of its side. */
std::shared_ptr<const dealii::Function<2>> plate_displacement(const Plate &plate,
                                                              const PlateMotion &motion);

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

/** The scene of a load case. Exact solutions are not known for it.
 * @param scene with rigid things as foundation where shift is not zero. */
Scene<2> scene_of_case(Scene<2> scene, const LoadCase &load_case);

/** The plates with the forces and travels of a load case. */
std::vector<Plate> plates_of_case(std::vector<Plate> plates, const LoadCase &load_case);

/** Which of a scene's loads act. */
enum class LoadKind
{
  force,
  weight,
  travel
};

/** The scene with one kind of load; all others are zero, and forces do not act on plates. */
Scene<2> with_only(Scene<2> scene, LoadKind kind);

/** Whether the scene has loads of this kind. */
bool has_load(const Scene<2> &scene, LoadKind kind);
} // namespace Signorini
