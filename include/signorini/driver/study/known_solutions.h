// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/level/level.h>
#include <signorini/problem/scene/named_scene.h>

#include <functional>
#include <tuple>

namespace Signorini {
/** Scenes with a name, and the functions that make a Verify, which their arguments outlive. Another
 * library gives them to runs. Without them all scenes are described by parameters, and nothing is
 * compared with exact solutions. */
struct KnownSolutions {
  template <int dim>
  using MakeVerify = std::function<Verify<dim>(const Parameters &, const Scene<dim> &)>;

  NamedScenes scenes;
  std::tuple<MakeVerify<2>, MakeVerify<3>> make_verify;
};
} // namespace Signorini
