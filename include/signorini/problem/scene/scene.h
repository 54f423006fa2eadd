// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/parameters/options.h>
#include <signorini/problem/scene/foundation.h>
#include <signorini/problem/scene/material.h>
#include <signorini/problem/scene/probe.h>

#include <deal.II/base/function.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/**
 * The bounds of lengths and moduli of a described scene; loads and displacements lie below the
 * upper one. They are far enough from the ends of double precision for products such as an energy
 * f² L⁴/E or a determinant of moduli. Other units bring every real body into this range.
 */
constexpr double min_magnitude = 1e-30;
constexpr double max_magnitude = 1e30;

/** The largest distance of a body from the origin, in its own diameters: x - y loses that much. */
constexpr double max_distance = 1e6;

/** The largest ratio of a body's length to its thickness, and to its shortest side. */
constexpr double max_slenderness = 1e6;

/** A change of a scene's loads and of its foundation; the body and its supports stay the same, and
 * so does its stiffness. */
struct LoadCase {
  /** Factor of tractions and of the forces and moments on plates. */
  double force = 1.;
  /** Factor of the body force. */
  double weight = 1.;
  /** Factor of prescribed displacements and of the given travels of plates. */
  double travel = 1.;
  /** Factor of the gap. */
  double gap = 1.;
  /** Factor of the tangential motion of the foundation. */
  double slide = 1.;
  /** Factor of the forces across the direction of plates. */
  double cross = 1.;
  /** The shift of the foundation, in addition to Contact/Foundation position (length). */
  double shift_x = 0., shift_y = 0.;
  /** Whether its fields are written. */
  bool has_fields = false;

  Tensor<1, 2> shift() const {
    return Tensor<1, 2>({shift_x, shift_y});
  }
};

/** The motion of a plate. */
struct PlateMotion {
  /** The travel delta along the plate's direction (length). */
  double travel = 0.;
  /** The drift eta across the plate's direction (length). */
  double drift = 0.;
  /** The rotation theta, counter-clockwise about the plate's centre (radians, small). */
  double rotation = 0.;
};

/**
 * A side to which a rigid plate is bonded: u = delta d + eta d' + theta (-(y - c2), x - c1) on it,
 * where d' is d turned counter-clockwise by a right angle. Each of the three motions is given, or
 * the force or the moment that drives it is.
 */
struct Plate {
  /** The number of the side in the geometry. */
  unsigned int side = 0;
  /** The direction d, a unit vector. */
  Tensor<1, 2> direction;
  /** The centre c: the middle of the side, of a closed one that of the box around it (of a circle
   * its centre). */
  Point<2> centre;
  /** Whether a force drives the travel; otherwise it is given. */
  bool is_pushed = false;
  /** The force along d on a plate that is pushed (force per thickness). */
  double force = 0.;
  /** The travel delta of a plate that is not pushed (length). */
  double travel = 0.;
  /** Whether a force drives the drift; otherwise it is zero. */
  bool drifts = false;
  /** The force along d' on a plate that drifts (force per thickness). */
  double cross_force = 0.;
  /** Whether a moment drives the rotation; otherwise it is zero. */
  bool turns = false;
  /** The moment about c, counter-clockwise, on a plate that turns (force x length per thickness).
   */
  double moment = 0.;

  /** Returns d'. */
  Tensor<1, 2> across() const {
    return -cross_product_2d(direction);
  }
  /** Returns the displacement of the point @p x of the plate. */
  Tensor<1, 2> displacement(const PlateMotion &motion, const Point<2> &x) const;
  /** Returns the work that the forces and the moment that drive the plate do in a motion (force x
   * length per thickness). */
  double work(const PlateMotion &motion) const {
    return force * motion.travel + cross_force * motion.drift + moment * motion.rotation;
  }
};

/** Returns the displacement of a plate as data of its side. */
std::shared_ptr<const Function<2>> plate_displacement(const Plate &plate,
                                                      const PlateMotion &motion);

/** The condition on a side of the body; every side has exactly one role. */
enum class Role {
  /** sigma n = 0. */
  free,
  /** u = 0. */
  clamped,
  /** u.n = 0, sigma_T = 0. */
  roller,
  /** u is given. */
  displacement,
  /** sigma n is given. */
  traction,
  /** u.m <= g, sigma n = p m, p <= 0, p (u.m - g) = 0 with the direction m of contact, mostly n;
   * or with the law of friction across m. */
  contact,
  /** A contact side of another body touches this one, whose traction is that of the contact side
   * with the other sign. */
  opposite
};

/** Returns "free", "clamped", ... */
std::string word_for(Role role);

template <int dim>
using FunctionPointer = std::shared_ptr<const Function<dim>>;

/** The role of one side and the data that belongs to it. */
template <int dim>
struct BoundaryCondition {
  Role role = Role::free;
  /** The prescribed displacement or traction (dim components), or the gap (one component); else
   * empty. */
  FunctionPointer<dim> data;
  /** The exact contact pressure p = sigma_n of a contact side, if known. */
  FunctionPointer<dim> exact_pressure;
  /** The number of the side of another body that a contact side may touch; then u.n is that of both
   * bodies along the normals of the contact side. None where the foundation is rigid. */
  std::optional<unsigned int> opposite = {};
  /** The number of equal patches of a contact side, aligned with nothing; zero where patches are
   * groups of faces. */
  unsigned int n_patches = 0;
  /** The obstacles of a contact side whose gap is the distance to them; foundation_gap(side,
   * foundation, position, directions) computes the gap for another position of theirs. Else empty.
   */
  std::shared_ptr<const Foundation> foundation = nullptr;
  /** The directions of contact, in 2-D. Load cases that move the foundation keep them. */
  ContactDirections directions = {};
  /** With friction: Coulomb's coefficient f or Tresca's bound s, and the tangential motion g_t of
   * the foundation, empty where it rests: in the plane along t, in space a vector whose tangential
   * part counts. The tangent t is m turned counter-clockwise. */
  FunctionPointer<dim> friction = nullptr;
  FunctionPointer<dim> shift = nullptr;
  /** The exact tangential traction q = σn·t of a contact side, if known. */
  FunctionPointer<dim> exact_friction = nullptr;
};

/** Problem (1): a body, its material, its supports, its loads and its foundation. */
template <int dim>
struct Scene {
  std::string name;
  /** One line that describes the scene. */
  std::string title;
  /** The problem of a catalogue scene, in lines; empty for a scene that the parameters describe. */
  std::string description;
  Geometry<dim> geometry;
  /** boundary[i] belongs to geometry.sides[i]. */
  std::vector<BoundaryCondition<dim>> boundary;
  /** The sides that rigid plates move (2-D only). Their role is displacement; their data is the
   * given part of the motion, and all of it once it is known (with_plates_moved()). */
  std::vector<Plate> plates;
  /** Whether rigid motions are left that contact alone can stop. Then single degrees of freedom are
   * pinned while the system is solved, and the motions are unknowns of the dual problem. */
  bool is_held_by_contact = false;
  /** Other loads for which the finest level is solved, too. */
  std::vector<LoadCase> load_cases;
  /** The law of friction of all contact sides. */
  Friction friction = Friction::none;
  std::shared_ptr<const Material<dim>> material;
  /** The body force f of (1), dim components; empty means zero. */
  FunctionPointer<dim> body_force;
  /** The exact displacement u of (1) with its gradient, dim components; empty means unknown. */
  FunctionPointer<dim> exact_displacement;
  /** The shift of the foundations of all sides that `data` contains (length). */
  Tensor<1, dim> foundation_position;
  /** The probes of Output/Report. */
  std::vector<Probe<dim>> probes;
  /** Where data is not smooth, with boxes for the body force; and the same with boxes for the
   * moduli, nothing where these are constant on cells. */
  Kinks<dim> kinks, law_kinks;

  /** Returns the numbers of the contact sides gamma_{c,i}, i = 1..n_g. */
  std::vector<unsigned int> contact_sides() const;
  /** Returns whether a contact side touches another body. */
  bool has_pairs() const;
  /** Returns the direction m of contact at a point of a side; on sides of other roles n. */
  Tensor<1, dim> contact_direction(unsigned int side, const Point<dim> &x) const;
  /** Returns BoundaryCondition::n_patches of all sides. */
  std::vector<unsigned int> given_patches() const;
  /** Returns whether p is known on every contact side. */
  bool has_exact_pressure() const;
};

/** Returns the scene with the displacements of the moved plates as prescribed displacements. @param
 * motions one for each plate. */
template <int dim>
Scene<dim> with_plates_moved(Scene<dim> scene, const std::vector<PlateMotion> &motions);

/** Returns the same scene with all other prescribed displacements set to zero. */
template <int dim>
Scene<dim> with_only_plates_moved(Scene<dim> scene, const std::vector<PlateMotion> &motions);

/** Returns the scene of a load case, without its exact solution. @param scene must have a
 * foundation of obstacles if the shift is not zero. */
Scene<2> scene_of_case(Scene<2> scene, const LoadCase &load_case);

/** Returns the plates with the forces and travels of a load case. */
std::vector<Plate> plates_of_case(std::vector<Plate> plates, const LoadCase &load_case);

/** The kinds of load of a scene. */
enum class LoadKind { force, weight, travel, cross };

/** A number of a load case, a factor or a shift. */
struct CaseFactor {
  /** The name in Load cases/Cases: "shift x". */
  std::string name;
  double LoadCase::*number;
  /** The kind of load that it multiplies; none of other numbers. */
  std::optional<LoadKind> kind;
  /** The lack of a scene in which it changes nothing: "no body force". */
  std::string lacking;
};

/** Returns all numbers of load cases, those of the same kind as in LoadKind in its order. */
const std::vector<CaseFactor> &case_factors();

/** Returns the scene with one kind of load; all others are zero, and forces do not act on plates.
 */
Scene<2> with_only(Scene<2> scene, LoadKind kind);

/** Returns whether the scene has loads of this kind. */
bool has_load(const Scene<2> &scene, LoadKind kind);
} // namespace Signorini
