// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/threads.h>
#include <signorini/elasticity/displacement_space.h>

#include <functional>
#include <vector>

namespace Signorini
{
template <int dim>
using Cells = std::vector<typename dealii::DoFHandler<dim>::active_cell_iterator>;

/** The cells of this rank, in their order, in chunks that one thread works on at a time. */
template <int dim>
std::vector<Cells<dim>> chunks_of_owned_cells(const DisplacementSpace<dim> &space)
{
  constexpr std::size_t chunk_size = 512;
  std::vector<Cells<dim>> chunks;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned())
    {
      if (chunks.empty() || chunks.back().size() == chunk_size)
        chunks.emplace_back().reserve(chunk_size);
      chunks.back().push_back(cell);
    }
  return chunks;
}

/**
 * consume(integrate(chunk)) for the cells of this rank, with all threads given. The chunks are the
 * same for any number of threads, none depends on another (FEValues looks back to the cell before),
 * and they are consumed in order: so the digits are the same, too.
 */
template <typename Result, int dim>
void integrate_by_chunks(const DisplacementSpace<dim> &space,
                         const std::function<Result(const Cells<dim> &)> &integrate,
                         const std::function<void(const Result &)> &consume)
{
  const std::vector<Cells<dim>> chunks = chunks_of_owned_cells(space);
  produce_in_parallel<Result>(
    number_of_threads(space.mesh().communicator()),
    chunks.size(),
    [&](const std::size_t i) { return integrate(chunks[i]); },
    consume);
}
} // namespace Signorini
