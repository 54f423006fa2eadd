// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>

#include <functional>
#include <string>
#include <tuple>
#include <vector>

namespace Signorini {
/** A scene that code makes, not a parameter file. */
template <int dim>
struct NamedScene {
  std::string name;
  std::function<Scene<dim>()> make;
};

/** All scenes to which Scene/Name may refer, in 2-D and in 3-D. */
using NamedScenes = std::tuple<std::vector<NamedScene<2>>, std::vector<NamedScene<3>>>;
} // namespace Signorini
