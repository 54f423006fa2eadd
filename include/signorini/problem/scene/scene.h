// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/geometry/kinks.h>
#include <signorini/problem/parameters/options.h>
#include <signorini/problem/scene/foundation.h>
#include <signorini/problem/scene/friction_law.h>
#include <signorini/problem/scene/load_case.h>
#include <signorini/problem/scene/material.h>
#include <signorini/problem/scene/plate.h>
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
  /** The side may touch a foundation or other bodies: Scene::contacts; elsewhere sigma n = 0. */
  contact
};

/** Returns "free", "clamped", ... */
std::string word_for(Role role);

template <int dim>
using FunctionPointer = std::shared_ptr<const Function<dim>>;

/** The role of one side and the data that belongs to it. */
template <int dim>
struct BoundaryCondition {
  Role role = Role::free;
  /** The prescribed displacement or traction (dim components); else empty. */
  FunctionPointer<dim> data = nullptr;
};

/**
 * Contact of one side with a rigid foundation, or with a side of another body:
 *
 *     u.m <= g, sigma n = p m, p <= 0, p (u.m - g) = 0
 *
 * with the direction m of contact, mostly n; or with the law of friction across m. Between two
 * bodies u is the difference of both, and the traction on the other one has the other sign. A side
 * may be in any number of contacts, each on a part of it.
 */
template <int dim>
struct ContactCondition {
  /** The number of the side on which Γ_c of this contact lies: its points and normals count. */
  unsigned int side = 0;
  /** The number of the side of the other body; none where the foundation is rigid. */
  std::optional<unsigned int> opposite = {};
  /** Whether the scene names the opposite side first: the force of contact is that on its body. */
  bool is_exchanged = false;
  /** With another body: the arc lengths between which they may touch; around a closed side @p to
   * may exceed its length (length). */
  double from = 0., to = 0.;
  /** The gap g, one component. */
  FunctionPointer<dim> gap = nullptr;
  /** The exact contact pressure p = sigma_n, if known. */
  FunctionPointer<dim> exact_pressure = nullptr;
  /** The number of equal patches, aligned with nothing; zero where patches are groups of faces. */
  unsigned int n_patches = 0;
  /** The obstacles, where the gap is the distance to them; foundation_gap(side, foundation,
   * position, directions) computes the gap for another position of theirs. Else empty. */
  std::shared_ptr<const Foundation<dim>> foundation = nullptr;
  /** The directions of contact. Load cases that move the foundation keep them. */
  ContactDirections<dim> directions = {};
  /** The functions f and s of the limits of the law, and the tangential motion g_t of the
   * foundation, empty where it rests: in the plane along t, in space a vector whose tangential part
   * counts. The tangent t is m turned counter-clockwise. */
  FunctionPointer<dim> coefficient = nullptr, bound = nullptr;
  FunctionPointer<dim> shift = nullptr;
  /** The exact tangential traction q = σn·t, if known. */
  FunctionPointer<dim> exact_tangential = nullptr;
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
  /** The contacts, by side; those of one side in the order in which they are given. */
  std::vector<ContactCondition<dim>> contacts;
  /** The sides that rigid plates move. Their role is displacement; their data is the
   * given part of the motion, and all of it once it is known (with_plates_moved()). */
  std::vector<Plate<dim>> plates;
  /** Whether rigid motions are left that contact alone can stop. Then single degrees of freedom are
   * pinned while the system is solved, and the motions are unknowns of the dual problem. */
  bool is_held_by_contact = false;
  /** Other loads for which the finest level is solved, too. */
  std::vector<LoadCase> load_cases;
  /** The law of friction of all contacts. */
  FrictionLaw<dim> contact_law;
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

  /** Returns whether two bodies may touch. */
  bool has_pairs() const;
  /** Returns ContactCondition::n_patches of all contacts. */
  std::vector<unsigned int> given_patches() const;
  /** Returns whether Γ_c of a contact lies on a side. */
  bool has_contact_on(unsigned int side) const;
  /** Returns whether p is known in every contact. */
  bool has_exact_pressure() const;
};

/** Returns the scene with the displacements of the moved plates as prescribed displacements. @param
 * motions one for each plate. */
template <int dim>
Scene<dim> with_plates_moved(Scene<dim> scene, const std::vector<PlateMotion<dim>> &motions);

/** Returns the same scene with all other prescribed displacements set to zero. */
template <int dim>
Scene<dim> with_only_plates_moved(Scene<dim> scene, const std::vector<PlateMotion<dim>> &motions);

} // namespace Signorini
