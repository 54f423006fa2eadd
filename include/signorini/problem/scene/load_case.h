// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/plate.h>

#include <deal.II/base/tensor.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini {
template <int dim>
struct Scene;

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
  double shift_x = 0., shift_y = 0., shift_z = 0.;
  /** Whether its fields are written. */
  bool has_fields = false;

  template <int dim>
  Tensor<1, dim> shift() const {
    Tensor<1, dim> shift;
    for (unsigned int d = 0; d < dim; ++d)
      shift[d] = d == 0 ? shift_x : d == 1 ? shift_y : shift_z;
    return shift;
  }
};

/** Returns the scene of a load case, without its exact solution. @param scene must have a
 * foundation of obstacles if the shift is not zero. */
template <int dim>
Scene<dim> scene_of_case(Scene<dim> scene, const LoadCase &load_case);

/** Returns the plates with the forces and travels of a load case. */
template <int dim>
std::vector<Plate<dim>> plates_of_case(std::vector<Plate<dim>> plates, const LoadCase &load_case);

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
  std::string missing_data;
};

/** Returns all numbers of load cases, those of the same kind as in LoadKind in its order. */
const std::vector<CaseFactor> &case_factors();

/** Returns the scene with one kind of load; all others are zero, and forces do not act on plates.
 */
template <int dim>
Scene<dim> with_only(Scene<dim> scene, LoadKind kind);

/** Returns whether the scene has loads of this kind. */
template <int dim>
bool has_load(const Scene<dim> &scene, LoadKind kind);
} // namespace Signorini
