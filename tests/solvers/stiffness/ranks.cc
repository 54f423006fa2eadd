// SPDX-License-Identifier: LGPL-2.1-or-later
// V-cycles on a mesh that ranks share: the same number on any number of ranks, and the messages
// that one of them takes.

#include <deal.II/base/mpi.h>

#include <mpi.h>

#include "driver/box/box.h"
#include "v_cycle.h"

using namespace Signorini;

namespace {
/** The messages that this rank has sent since the beginning. */
struct Traffic {
  unsigned int messages = 0, reductions = 0;
  double bytes = 0.;
};
Traffic traffic;
} // namespace

// These replace MPI's functions, and call them. (PETSc defines macros of these names.)
extern "C" int(MPI_Isend)(const void *buffer, int count, MPI_Datatype type, int rank, int tag,
                          MPI_Comm communicator, MPI_Request *request) {
  int size = 0;
  MPI_Type_size(type, &size);
  ++traffic.messages;
  traffic.bytes += double(count) * size;
  return PMPI_Isend(buffer, count, type, rank, tag, communicator, request);
}

extern "C" int(MPI_Allreduce)(const void *send, void *receive, int count, MPI_Datatype type,
                              MPI_Op operation, MPI_Comm communicator) {
  ++traffic.reductions;
  return PMPI_Allreduce(send, receive, count, type, operation, communicator);
}

namespace {
Scene<3> cube() {
  return make_box_scene(scalar([](const auto &) { return 0.; }),
                        field([](const dealii::Point<3> &) { return Vector3(); }), {1., 1., 1.});
}

/** Nodes that ranks share: a vector of ones becomes the number of ranks that have the node. */
void sums(Checks &checks) {
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                     rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  // Every rank has the nodes 0 and 10 r, ..., 10 r + 10.
  std::vector<std::pair<dealii::types::global_dof_index, NodeNumber>> nodes = {{0, 0}};
  for (unsigned int i = rank == 0 ? 1 : 0; i <= 10; ++i)
    nodes.emplace_back(10 * rank + i, nodes.size());
  std::set<dealii::types::subdomain_id> others;
  for (unsigned int r = 0; r < n_ranks; ++r)
    if (r != rank)
      others.insert(r);
  const SharedNodes shared(nodes, others, MPI_COMM_WORLD);
  LevelVector<2, float> ones(nodes.size());
  for (auto &component : ones)
    component.fill(1.F);
  shared.add(ones);
  for (const auto &[number, i] : nodes) {
    const bool between = number % 10 == 0 && number > 0 && number < 10 * n_ranks;
    const double expected = number == 0 ? n_ranks : between ? 2. : 1.;
    checks.near("sharers of node " + std::to_string(number), {ones[0][i], ones[1][i]},
                {expected, expected}, 0.);
  }
  checks.near("nodes of lower ranks", shared.n_foreign(), rank == 0 ? 0. : 2., 0.);
}

/** One product, one residual and six smoothing products have an exchange each, and so has a
 * restriction; the levels of the roots and below take one reduction. */
void messages(Checks &checks) {
  const HeldBody<3> body(cube(), 5, 5);
  const DualVector r = body.random_vector(1);
  DualVector z(r);
  const Traffic before = traffic;
  body.multigrid.precondition(z, r);
  const Traffic cycle = {traffic.messages - before.messages, traffic.reductions - before.reductions,
                         traffic.bytes - before.bytes};
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  if (n_ranks == 1) {
    checks.near("one rank sends nothing", cycle.messages, 0., 0.);
    return;
  }
  const unsigned int n_levels = 5 - body.mesh.subtree_level(), n_neighbours = n_ranks - 1;
  // The entries of r; six products and a restriction on each level but that of the roots.
  checks.near("messages", cycle.messages, (7. * n_levels - 1. + 1.) * n_neighbours, 0.);
  checks.near("reductions", cycle.reductions, 1. + 1., 0.);
  // At most the surface of half of a cube and seven exchanges, on levels that have a quarter.
  const double nodes = 33. * 33. * n_neighbours;
  checks.between("bytes", cycle.bytes, 7. * 3. * 4. * 0.3 * nodes, 7. * 3. * 4. * 1.4 * 2. * nodes);
}

void steps(Checks &checks) {
  for (const unsigned int level : {4U, 5U}) {
    const HeldBody<3> body(cube(), level, level);
    const DualVector b = body.random_vector(5);
    DualVector x(b);
    checks.between("cube, level " + std::to_string(level),
                   conjugate_gradients(body.multigrid, x, b), 1, 8);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {sums, messages, steps});
}
