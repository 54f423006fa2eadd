// SPDX-License-Identifier: LGPL-2.1-or-later
// Sums over the ranks that share a node.

#include <signorini/solvers/stiffness/shared_nodes.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>

namespace Signorini {
namespace {
using NodesByRank = std::map<unsigned int, std::vector<NodeNumber>>;

/** Returns the nodes that both ranks have, in the order of their numbers. */
NodesByRank find_shared(const std::vector<std::pair<types::global_dof_index, NodeNumber>> &nodes,
                        const std::set<types::subdomain_id> &neighbours, MPI_Comm communicator) {
  const std::map<types::global_dof_index, NodeNumber> mine(nodes.begin(), nodes.end());
  std::vector<types::global_dof_index> sorted;
  sorted.reserve(mine.size());
  for (const auto &[number, node] : mine)
    sorted.push_back(number);
  std::map<unsigned int, std::vector<types::global_dof_index>> sent;
  for (const unsigned int rank : neighbours)
    sent[rank] = sorted;
  NodesByRank shared;
  for (const auto &[rank, theirs] : Utilities::MPI::some_to_some(communicator, sent))
    for (const types::global_dof_index number : theirs)
      if (const auto found = mine.find(number); found != mine.end())
        shared[rank].push_back(found->second);
  return shared;
}
} // namespace

SharedNodes::SharedNodes(const std::vector<std::pair<types::global_dof_index, NodeNumber>> &nodes,
                         const std::set<types::subdomain_id> &neighbours, MPI_Comm communicator)
  : SharedNodes(communicator, find_shared(nodes, neighbours, communicator)) {}

SharedNodes::SharedNodes(MPI_Comm communicator, NodesByRank nodes)
  : communicator_(communicator)
  , nodes_(std::move(nodes)) {
  std::set<NodeNumber> all, foreign;
  for (const auto &[rank, of_rank] : nodes_) {
    all.insert(of_rank.begin(), of_rank.end());
    if (rank < Utilities::MPI::this_mpi_process(communicator))
      foreign.insert(of_rank.begin(), of_rank.end());
  }
  all_.assign(all.begin(), all.end());
  foreign_.assign(foreign.begin(), foreign.end());
}

SharedNodes SharedNodes::coarsen(const std::vector<NodeNumber> &identities) const {
  std::map<NodeNumber, NodeNumber> coarse_nodes;
  for (NodeNumber node = 0; node < identities.size(); ++node)
    coarse_nodes.emplace(identities[node], node);
  NodesByRank coarse;
  for (const auto &[rank, nodes] : nodes_)
    for (const NodeNumber node : nodes)
      if (const auto found = coarse_nodes.find(node); found != coarse_nodes.end())
        coarse[rank].push_back(found->second);
  return {communicator_, std::move(coarse)};
}

template <int n_components, typename Number>
void SharedNodes::add(LevelVector<n_components, Number> &parts) const {
  if (nodes_.empty())
    return;
  const auto packed = [&parts](const std::vector<NodeNumber> &nodes) {
    std::vector<Number> entries;
    entries.reserve(nodes.size() * n_components);
    for (const auto &component : parts)
      for (const NodeNumber node : nodes)
        entries.push_back(component[node]);
    return entries;
  };
  const auto add_entries = [&parts](const std::vector<NodeNumber> &nodes,
                                    const std::vector<Number> &entries) {
    auto entry = entries.begin();
    for (auto &component : parts)
      for (const NodeNumber node : nodes)
        component[node] += *entry++;
  };
  std::map<unsigned int, std::vector<Number>> sent, received;
  std::vector<MPI_Request> requests;
  constexpr int tag = 1;
  for (const auto &[rank, nodes] : nodes_) {
    sent[rank] = packed(nodes);
    received[rank].resize(sent[rank].size());
    const int n_bytes = static_cast<int>(sent[rank].size() * sizeof(Number));
    MPI_Irecv(received[rank].data(), n_bytes, MPI_BYTE, static_cast<int>(rank), tag, communicator_,
              &requests.emplace_back());
    MPI_Isend(sent[rank].data(), n_bytes, MPI_BYTE, static_cast<int>(rank), tag, communicator_,
              &requests.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  received[Utilities::MPI::this_mpi_process(communicator_)] = packed(all_);
  for (auto &component : parts)
    for (const NodeNumber node : all_)
      component[node] = Number();
  for (const auto &[rank, entries] : received) {
    const auto of_neighbour = nodes_.find(rank);
    add_entries(of_neighbour == nodes_.end() ? all_ : of_neighbour->second, entries);
  }
}

template void SharedNodes::add(LevelVector<2, float> &) const;
template void SharedNodes::add(LevelVector<3, float> &) const;
template void SharedNodes::add(LevelVector<6, float> &) const;
template void SharedNodes::add(LevelVector<2, double> &) const;
template void SharedNodes::add(LevelVector<3, double> &) const;
} // namespace Signorini
