// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/mesh/mesh_plan.h>

#include <cmath>
#include <string>

#include "one_level.h"

/** A scene from the text of a parameter file, on the mesh of a plan. */
struct GradedLevel : public OneLevel {
  GradedLevel(const std::string &text, const Signorini::MeshPlan &plan)
    : OneLevel(text + "\nDiscretization/Strategy = hp\n", plan) {}
  const Signorini::Mesh<2> &mesh() const {
    return discretization.mesh;
  }
};

/** A uniform mesh, all of whose cells have the given degree. */
inline Signorini::MeshPlan uniform_plan(const unsigned int level, const unsigned int degree) {
  Signorini::MeshPlan plan;
  plan.base_level = level;
  plan.rise = degree - 2.;
  return plan;
}

/** A corner towards which cells are split. */
inline Signorini::Singularity corner(const dealii::Point<2> &point, const double layers) {
  Signorini::Singularity singularity = {};
  singularity.kind = Signorini::Singularity::Kind::corner;
  singularity.point = point;
  singularity.exponent = 0.5;
  singularity.layers = layers;
  return singularity;
}

/** A part of a side towards which cells are split. */
inline Signorini::Singularity end_of_contact(const dealii::Point<2> &point, const unsigned int side,
                                             const double from, const double to,
                                             const double layers) {
  return {Signorini::Singularity::Kind::end_of_contact, point, 1.5, side, from, to, layers};
}

/** Whether the mesh has hanging nodes. */
inline bool has_hanging_nodes(const Signorini::Mesh<2> &mesh) {
  return mesh.triangulation().has_hanging_nodes();
}

/** Neighbours differ by one split and by one degree at most. */
inline bool is_graded(const Signorini::DisplacementSpace<2> &space) {
  const auto degrees = degrees_of(space);
  for (const auto &cell : space.mesh().triangulation().active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      if (cell->at_boundary(f) || !cell->neighbor(f)->is_active())
        continue;
      const auto other = cell->neighbor(f);
      const int difference = static_cast<int>(degrees[cell->active_cell_index()]) -
                             static_cast<int>(degrees[other->active_cell_index()]);
      if (std::abs(cell->level() - other->level()) > 1 || std::abs(difference) > 1)
        return false;
    }
  return true;
}
