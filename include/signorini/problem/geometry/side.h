// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/curve.h>
#include <signorini/problem/geometry/surface.h>

#include <string>
#include <type_traits>
#include <utility>

namespace Signorini {
/** A smooth piece of the boundary: project(x), normal_at(x), centre(); a curve also has a
 * coordinate, the arc length. */
template <int dim>
using SideManifold = std::conditional_t<dim == 2, Curve, SurfacePart>;

/** A named piece of the boundary: a name and the manifold that the piece is. */
template <int dim>
class Side : public SideManifold<dim> {
public:
  Side(std::string name, SideManifold<dim> manifold)
    : SideManifold<dim>(std::move(manifold))
    , name_(std::move(name)) {}

  const std::string &name() const {
    return name_;
  }

private:
  std::string name_;
};

} // namespace Signorini
