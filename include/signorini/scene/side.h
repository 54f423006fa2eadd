// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/curve.h>
#include <signorini/scene/rectangle.h>

#include <string>
#include <type_traits>
#include <utility>

namespace Signorini
{
/** A smooth piece of the boundary with coordinates of its own: point(s), normal(s), coordinates(x).
 */
template <int dim>
using SideManifold = std::conditional_t<dim == 2, Curve, Rectangle>;

/** A named piece of the boundary: a name and the manifold that the piece is. */
template <int dim>
class Side : public SideManifold<dim>
{
public:
  Side(std::string name, SideManifold<dim> manifold)
    : SideManifold<dim>(std::move(manifold))
    , name_(std::move(name))
  {
  }

  const std::string &name() const
  {
    return name_;
  }

private:
  std::string name_;
};
} // namespace Signorini
