// SPDX-License-Identifier: LGPL-2.1-or-later
// The memory that a level needs.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/solvers/methods/memory_limit.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <sys/resource.h>
#include <unistd.h>

namespace Signorini {
namespace {
/** Returns a low estimate of the bytes of mesh, matrix and factor. They took 3.5 kB per cell for
 * 2^16 cells of a square, 4.1 kB for 2^18 and 4.4 kB for 2^20 (condensed; Amesos MUMPS takes more):
 * the factor grows like n log n. In 3-D it grows like n^{4/3}: 50 kB per cell for 2^15 cells of a
 * cube. */
template <int dim>
double sparse_bytes(const double cells) {
  if (dim == 2)
    return cells * std::max(1e3, 240. * std::log2(cells) - 370.);
  return cells * (4e3 + 900. * std::cbrt(cells));
}

/** Returns a low estimate of the bytes of mesh, unknowns and vectors. They took 0.75 kB per cell of
 * a square (4096²) and 1.2 kB per cell of a cube (64³). */
template <int dim>
double bytes_without_factor(const double cells) {
  return cells * (dim == 2 ? 700. : 1000.);
}

/** Returns the bytes of C, its copy and its factor; with the condensed solver also those of the
 * factor of S, of order @p unknowns, and of W. */
double dense_bytes(const double patches, const double unknowns, const bool condensed) {
  return sizeof(double) *
         (3. * patches * patches + (condensed ? unknowns * (unknowns + patches) : 0.));
}

/** Returns the finest level; with a target error, which may be reached earlier, the coarsest. */
unsigned int judged_level(const DiscretizationParameters &given) {
  return given.target_error > 0. ? given.coarsest_level : given.finest_level;
}

/** Returns the number in a file, or infinity: "max" stands for no limit. */
double read_limit(const char *file_name) {
  std::ifstream file(file_name);
  double limit = 0.;
  return file >> limit && limit > 0. ? limit : HUGE_VAL;
}

/** Returns the memory that each process on this machine may have, the smallest of all machines. */
double available_bytes(MPI_Comm communicator) {
  double available =
    static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  rlimit address_space = {};
  if (getrlimit(RLIMIT_AS, &address_space) == 0 && address_space.rlim_cur != RLIM_INFINITY)
    available = std::min(available, static_cast<double>(address_space.rlim_cur));
  // The files of the container's own control group, version 2 and 1.
  for (const char *file :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
    available = std::min(available, read_limit(file));
  MPI_Comm of_machine;
  MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &of_machine);
  available /= Utilities::MPI::n_mpi_processes(of_machine);
  MPI_Comm_free(&of_machine);
  return Utilities::MPI::min(available, communicator);
}

/** Returns the share of the boundary length that may touch. */
double share_of_contact(const Scene<2> &scene) {
  double length = 0., contact_length = 0.;
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    length += scene.geometry.sides[i].length();
    if (scene.has_contact_on(i))
      contact_length += scene.geometry.sides[i].length();
  }
  return contact_length / length;
}

std::string gibibytes(const double bytes) {
  const double gib = bytes / (1024. * 1024. * 1024.);
  if (gib < 0.1)
    return number_text(std::ceil(1024. * gib)) + " MiB";
  return number_text(gib < 10. ? std::round(10. * gib) / 10. : std::round(gib)) + " GiB";
}
} // namespace

template <int dim>
MemoryLimit<dim>::MemoryLimit(const Parameters &parameters, const Scene<dim> &scene,
                              MPI_Comm communicator)
  : n_coarse_cells_(scene.geometry.n_coarse_cells)
  , n_given_patches_(n_given_patches(scene))
  , n_components_(scene.contact_law.has_tangential_part() ? dim : 1.)
  , parameters_(parameters)
  , scene_(scene)
  , n_ranks_(Utilities::MPI::n_mpi_processes(communicator))
  , judged_(judged_level(parameters.discretization))
  , solvers_(choose_solvers(parameters, scene, parameters.discretization.finest_level))
  , condensed_(resolve(solvers_.linear, 1) == LinearSolver::condensed)
  , available_(available_bytes(communicator)) {
  const bool may_stop_early = parameters_.discretization.target_error > 0.;
  const unsigned int level = judged_;
  const auto refuse_if_huge = [&]() {
    if (needed(level) < available_)
      return;
    throw InputError((may_stop_early ? parameters_.discretization.coarsest_level
                                     : parameters_.discretization.finest_level)
                       .where() +
                     ": found '" + std::to_string(level) + "', but " + describe(level) +
                     ", allowed: levels that fit into the " + describe_available() + ".");
  };
  refuse_if_huge();
  Triangulation<dim> coarse_mesh;
  scene.geometry.make_coarse_mesh(coarse_mesh);
  double all_faces = 0.;
  for (const auto &face : coarse_mesh.active_face_iterators())
    if (face->at_boundary()) {
      all_faces += 1.;
      // Boundary numbers are not known where sides end inside coarse faces.
      if (!scene.geometry.number_after_refinement && scene.has_contact_on(face->boundary_id()))
        n_coarse_contact_faces_ += 1.;
    }
  if constexpr (dim == 2)
    if (scene.geometry.number_after_refinement)
      n_coarse_contact_faces_ = all_faces * share_of_contact(scene);
  refuse_if_huge();
}

template <int dim>
double MemoryLimit<dim>::n_cells(const unsigned int level) const {
  return n_coarse_cells_ * std::pow(2., double(dim) * level);
}

template <int dim>
double MemoryLimit<dim>::n_nodes(const unsigned int level) const {
  return (parameters_.discretization.element == Element::q2 ? std::pow(2., dim) : 1.) *
         n_cells(level);
}

template <int dim>
double MemoryLimit<dim>::n_contact_faces(const unsigned int level) const {
  return n_coarse_contact_faces_ * std::pow(2., (dim - 1.) * level);
}

template <int dim>
double MemoryLimit<dim>::n_patches(const unsigned int level) const {
  return n_given_patches_ > 0
           ? n_given_patches_
           : std::floor(n_contact_faces(level) /
                        std::pow(parameters_.discretization.patch_ratio.value, dim - 1.));
}

template <int dim>
double MemoryLimit<dim>::needed(const unsigned int level) const {
  const double share =
    is_shared(parameters_, scene_, solvers_, level, n_ranks_) ? 1. / n_ranks_ : 1.;
  if (solvers_.is_matrix_free())
    return share * bytes_without_factor<dim>(n_cells(level));
  const double degree = parameters_.discretization.element == Element::q2 ? 2. : 1.;
  return share * sparse_bytes<dim>(n_nodes(level)) +
         dense_bytes(n_components_ * n_patches(level),
                     dim * std::pow(degree, dim - 1.) * n_contact_faces(level), condensed_);
}

template <int dim>
std::string MemoryLimit<dim>::describe(const unsigned int level) const {
  // Before the coarse mesh is made its contact faces are not known.
  const bool knows_patches = n_given_patches_ > 0 || n_coarse_contact_faces_ > 0.;
  return "level " + std::to_string(level) + " has " + number_text(n_cells(level)) + " cells" +
         (knows_patches ? " and " + number_text(n_patches(level)) + " patches" : "") +
         ", which need more than " + gibibytes(needed(level));
}

template <int dim>
std::string MemoryLimit<dim>::describe_available() const {
  return gibibytes(available_) + " of memory";
}

template <int dim>
void MemoryLimit<dim>::check(const unsigned int level) const {
  if (needed(level) >= available_)
    throw ComputationError("The target error is not reached: " + describe(level) +
                           ", but there are " + describe_available() + ".");
}

template class MemoryLimit<2>;
template class MemoryLimit<3>;
} // namespace Signorini
