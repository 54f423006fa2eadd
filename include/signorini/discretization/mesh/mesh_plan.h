// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/mesh.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/grid/cell_id.h>

#include <map>
#include <vector>

namespace Signorini {
/** A point or bracket on the boundary next to which u ~ r^λ: a corner, a kink, or an end of
 * contact. An end of contact lies between two points of a side. */
struct Singularity {
  enum class Kind {
    corner,
    /** A point where a line of kinks meets a side, a possible end of contact or the end of an
     * interface; in a pair also the point across from it, or from a corner of the other body. */
    kink,
    /** The point of a curved side of a pair that is nearest to the other one: the first mesh is
     * graded to it, so that contact is seen. */
    first_touch,
    end_of_contact
  };
  Kind kind;
  /** The corner, the kink, or the middle of the bracket. */
  Point<2> point;
  /** The exponent λ, as far as it is known. */
  double exponent = 1.;
  /** The side of kinks and ends of contact, and the bracket in its arc length (length). */
  unsigned int side = 0;
  double from = 0., to = 0.;
  /** The number of splits of the cells at it. */
  double layers = 0.;
  /** Whether u is singular here according to the data of the scene, and not only possibly. */
  bool is_certain = false;
  /** The indicator of the cells at it when it had the layers before these; 0: not known. */
  double last_error = 0., last_layers = 0.;
  /** The number of the body whose cells are split. */
  unsigned int body = 0;

  /** Returns whether the point, or a part of the bracket, lies in the closure of a cell. */
  bool touches(const Scene<2> &scene, const Triangulation<2>::active_cell_iterator &cell) const;
};

/** Returns the singularity with layers in a body that is closest to a point, if there is any. */
const Singularity *nearest(const std::vector<Singularity> &singularities, const Point<2> &x,
                           unsigned int body = 0);

/** The demands of the solution on earlier meshes on a cell. */
struct CellDemand {
  bool split = false;
  /** The lowest degree of the cell, or of its children. */
  unsigned int degree = 0;
};

/**
 * The plan of a mesh and its degrees: the mesh of the first step, split towards the singularities
 * and where there are demands.
 *
 * A cell that touches a singularity is split until it was split as often as there are layers. The
 * degree falls linearly with the layers, from 2 + rise away from all singularities to 2 next to
 * one.
 */
struct MeshPlan {
  /** The number of refinements of the mesh of the first step. */
  unsigned int base_level = 0;
  MeshGuides<2> guides;
  /** The size of the cells of the mesh of the first step (length). */
  double base_size = 1.;
  /** The same by body, where there are several. */
  std::vector<double> base_sizes = {};
  std::vector<Singularity> singularities;
  std::map<CellId, CellDemand> demands;
  double rise = 0.;
  /** The part of the error of the mesh before that should be left. */
  double aim = 1.;
  unsigned int max_element_degree = 9;

  /** Returns the size of the cells of a body in the mesh of the first step (length). */
  double size_in(const unsigned int body) const {
    return base_sizes.empty() ? base_size : base_sizes[body];
  }
  /** Returns whether a cell must be split. */
  bool must_split(const Scene<2> &scene, const Triangulation<2>::active_cell_iterator &cell,
                  unsigned int n_splits) const;
};

/** Returns whether a cell is as deep as cells can be: no plan splits it. */
bool is_deepest(const Triangulation<2>::active_cell_iterator &cell);

/** Makes the mesh of a plan. */
Mesh<2> make_mesh(const MeshPlan &plan, const Scene<2> &scene);

/** Returns the degrees of the active cells of a mesh; those of neighbours differ by one at most. */
std::vector<unsigned int> plan_degrees(const MeshPlan &plan, const Scene<2> &scene,
                                       const Mesh<2> &mesh);

/** Returns the degree that a plan gives to a cell of a body, regardless of its neighbours. */
unsigned int planned_degree(const MeshPlan &plan, const Mesh<2> &mesh, unsigned int body,
                            const Triangulation<2>::active_cell_iterator &cell);
} // namespace Signorini
