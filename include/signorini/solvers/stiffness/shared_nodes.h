// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/solvers/stiffness/block_grid.h>

#include <deal.II/base/types.h>

#include <mpi.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace Signorini {
/**
 * The nodes of a level that several ranks have on their blocks. A product leaves a part of the
 * result on each of them; one message to and from every neighbour adds the parts. They are added in
 * the order of ranks, so that all ranks get the same bits.
 */
class SharedNodes {
public:
  /** No node is shared. */
  SharedNodes() = default;
  /**
   * Finds the nodes of this rank that neighbours have, too. Collective.
   * @param nodes that may be shared, with their numbers in the whole mesh.
   * @param neighbours the ranks with which this one may share nodes.
   */
  SharedNodes(const std::vector<std::pair<types::global_dof_index, NodeNumber>> &nodes,
              const std::set<types::subdomain_id> &neighbours, MPI_Comm communicator);

  /** Returns the shared nodes of a coarser level, whose identities are nodes of this one. */
  SharedNodes coarsen(const std::vector<NodeNumber> &identities) const;

  /** Adds up the entries of shared nodes. Collective among neighbours. */
  template <int n_components, typename Number>
  void add(LevelVector<n_components, Number> &parts) const;

  /** Clears the entries of nodes that belong to another rank: that of the lowest number. */
  template <int n_components>
  void clear_foreign(LevelVector<n_components, float> &values) const {
    for (auto &component : values)
      for (const NodeNumber node : foreign_)
        component[node] = 0.F;
  }
  /** Returns the number of nodes that belong to other ranks. */
  unsigned int n_foreign() const {
    return static_cast<unsigned int>(foreign_.size());
  }
  MPI_Comm communicator() const {
    return communicator_;
  }

private:
  /** Keeps the nodes that some rank shares. */
  SharedNodes(MPI_Comm communicator, std::map<unsigned int, std::vector<NodeNumber>> nodes);

  MPI_Comm communicator_ = MPI_COMM_SELF;
  /** The nodes that this rank shares with another one; both have the same order. */
  std::map<unsigned int, std::vector<NodeNumber>> nodes_;
  /** Each of these nodes once; and those that belong to other ranks. */
  std::vector<NodeNumber> all_, foreign_;
};
} // namespace Signorini
