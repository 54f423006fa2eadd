// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/load_case.h>
#include <signorini/scene/scene.h>

namespace Signorini
{
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
