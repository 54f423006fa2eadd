// SPDX-License-Identifier: LGPL-2.1-or-later
// What fits into memory.

#include "memory_limit.h"

#include <signorini/parameters/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <unistd.h>

namespace Signorini
{
namespace
{
/** Mesh, matrix and factor took 3.5 kB per cell for 2^16 cells of a square, 4.1 kB for 2^18 and
 * 4.4 kB for 2^20 (condensed; Amesos MUMPS takes more): the factor grows like n log n. */
double needed_bytes(const double cells)
{
  return cells * std::max(1e3, 240. * std::log2(cells) - 370.);
}

double physical_memory()
{
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}
} // namespace

template <int dim>
void refuse_huge_levels(const Parameters &parameters, const Scene<dim> &scene)
{
  if (parameters.discretization.target_error > 0.)
    return;
  dealii::Triangulation<dim> coarse_mesh;
  scene.geometry.make_coarse_mesh(coarse_mesh);
  const unsigned int level = parameters.discretization.finest_level;
  const double cells = coarse_mesh.n_active_cells() * std::pow(2., double(dim) * level);
  const double needed = needed_bytes(cells);
  if (needed < physical_memory())
    return;
  constexpr double gibibyte = 1024. * 1024. * 1024.;
  std::ostringstream message;
  message << parameters.where("Discretization/Finest level") << ": found '" << level
          << "', which makes " << cells << " cells and needs more than "
          << std::ceil(needed / gibibyte) << " GiB, allowed: levels that fit into the "
          << std::floor(physical_memory() / gibibyte) << " GiB of this machine.";
  throw InputError(message.str());
}

template void refuse_huge_levels(const Parameters &, const Scene<2> &);
} // namespace Signorini
