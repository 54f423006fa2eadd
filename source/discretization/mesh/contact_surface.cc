// SPDX-License-Identifier: LGPL-2.1-or-later
// Γ_c: its faces, the points of its pieces on the mesh, and the grids of its patches.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/problem/scene/contact_pair.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <tuple>

namespace Signorini {
namespace {
constexpr unsigned int no_patch = numbers::invalid_unsigned_int;

/** The corners of a patch in the coordinates of its side. */
template <int dim>
using PatchBox = std::array<Point<dim - 1>, 2>;

/** Returns it in the coordinates along the edges of a rectangle, of which the corners are two. */
PatchBox<3> box_on(const Side<3> &side, const Patch<3> &patch) {
  const FaceCorners &rectangle = side.faces().front();
  const std::array<double, 2> lengths = side.rectangle();
  std::vector<Point<2>> corners;
  for (const Point<3> &x : patch.face.corners) {
    corners.emplace_back();
    for (unsigned int d = 0; d < 2; ++d)
      corners.back()[d] = (x - rectangle[0]) * (rectangle[1 + d] - rectangle[0]) / lengths[d];
  }
  const auto [lower, upper] = BoundingBox<2>(corners).get_boundary_points();
  return {{lower, upper}};
}

/** Returns the ends of the intervals that boxes cover in one coordinate. */
template <int dim>
std::vector<double> ends_of(const std::vector<PatchBox<dim>> &boxes, const unsigned int d) {
  std::vector<double> starts;
  double end = boxes[0][1][d], shortest = end - boxes[0][0][d];
  for (const auto &[lower, upper] : boxes) {
    starts.push_back(lower[d]);
    end = std::max(end, upper[d]);
    shortest = std::min(shortest, upper[d] - lower[d]);
  }
  std::sort(starts.begin(), starts.end());
  // Starts are equal up to rounding.
  starts.erase(std::unique(starts.begin(), starts.end(),
                           [&](const double a, const double b) { return b - a < 0.5 * shortest; }),
               starts.end());
  starts.push_back(end);
  return starts;
}

/** Returns the interval that contains a point. */
unsigned int interval_of(const std::vector<double> &ends, const double s) {
  const auto next = std::upper_bound(ends.begin() + 1, ends.end() - 1, s);
  return next - ends.begin() - 1;
}
} // namespace

namespace {
/** Returns the grids of patches with given boxes. */
template <int dim>
std::vector<PatchGrid> grids_of(const std::vector<Patch<dim>> &patches,
                                const std::vector<PatchBox<dim>> &boxes) {
  std::vector<PatchGrid> grids;
  for (std::size_t first = 0, last = 0; first < patches.size(); first = last) {
    while (last < patches.size() && patches[last].contact == patches[first].contact)
      ++last;
    PatchGrid grid;
    grid.contact = patches[first].contact;
    grid.side = patches[first].side;
    const std::vector<PatchBox<dim>> own(boxes.begin() + first, boxes.begin() + last);
    for (unsigned int d = 0; d < dim - 1; ++d)
      grid.ends[d] = ends_of<dim>(own, d);
    grid.patches.assign(static_cast<std::size_t>(grid.n(0)) * grid.n(1), no_patch);
    for (std::size_t t = first; t < last; ++t) {
      const auto &[lower, upper] = boxes[t];
      const Point<dim - 1> centre = lower + 0.5 * (upper - lower);
      const unsigned int row = dim == 2 ? 0 : interval_of(grid.ends[1], centre[dim - 2]);
      grid.patches[interval_of(grid.ends[0], centre[0]) + grid.n(0) * row] = t;
    }
    if (grid.patches.size() != last - first ||
        std::find(grid.patches.begin(), grid.patches.end(), no_patch) != grid.patches.end())
      throw ComputationError("The contact patches of a side in space are not the cells of a grid.");
    grids.push_back(std::move(grid));
  }
  return grids;
}
} // namespace

std::vector<PatchGrid> patch_grids(const std::vector<Patch<2>> &patches) {
  std::vector<PatchBox<2>> boxes;
  for (const Patch<2> &patch : patches)
    boxes.push_back({{patch.lower, patch.upper}});
  return grids_of(patches, boxes);
}

std::vector<PatchGrid> patch_grids(const ContactSurface<2> &surface) {
  return patch_grids(surface.patches());
}

std::vector<PatchGrid> patch_grids(const ContactSurface<3> &surface) {
  std::vector<PatchBox<3>> boxes;
  for (const Patch<3> &patch : surface.patches())
    boxes.push_back(box_on(surface.side(patch), patch));
  return grids_of(surface.patches(), boxes);
}

template <int dim>
double Patch<dim>::diameter() const {
  if constexpr (dim == 2)
    return lower.distance(upper);
  else
    return std::max(face.corners[0].distance(face.corners[3]),
                    face.corners[1].distance(face.corners[2]));
}

template struct Patch<2>;
template struct Patch<3>;

namespace {
template <int dim>
std::vector<ContactFace<dim>> find_own_faces(const Mesh<dim> &mesh, const Scene<dim> &scene) {
  std::vector<ContactFace<dim>> faces;
  for (const auto &cell :
       mesh.triangulation().active_cell_iterators() | IteratorFilters::LocallyOwnedCell())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary()) {
        const unsigned int side = cell->face(f)->boundary_id();
        if (scene.boundary[side].role != Role::contact)
          continue;
        faces.push_back({cell, f, side, {}, dim == 3 ? identity_of(*cell) : CellId()});
        for (const unsigned int v : cell->face(f)->vertex_indices())
          faces.back().vertices[v] = cell->face(f)->vertex(v);
      }
  return faces;
}

/** Returns the faces of all ranks in the order that a mesh of one rank has. */
template <int dim>
std::vector<ContactFace<dim>> share(const std::vector<ContactFace<dim>> &own,
                                    MPI_Comm communicator) {
  std::vector<ContactFace<dim>> faces;
  using Record =
    std::tuple<CellId::binary_type, unsigned int, unsigned int, std::vector<Point<dim>>>;
  std::vector<Record> records;
  records.reserve(own.size());
  for (const ContactFace<dim> &face : own)
    records.emplace_back(identity_of(*face.cell).template to_binary<dim>(), face.face_no, face.side,
                         std::vector<Point<dim>>(face.vertices.begin(), face.vertices.end()));
  const auto all = Utilities::MPI::all_gather(communicator, records);
  for (unsigned int rank = 0; rank < all.size(); ++rank)
    for (std::size_t i = 0; i < all[rank].size(); ++i) {
      const auto &[id, face_no, side, vertices] = all[rank][i];
      ContactFace<dim> face = {{}, face_no, side, {}, CellId(id)};
      if (rank == Utilities::MPI::this_mpi_process(communicator))
        face.cell = own[i].cell;
      std::copy(vertices.begin(), vertices.end(), face.vertices.begin());
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end(), [](const auto &a, const auto &b) {
    return std::tie(a.identity, a.face_no) < std::tie(b.identity, b.face_no);
  });
  return faces;
}

template <int dim>
std::vector<ContactFace<dim>> find_contact_faces(const Mesh<dim> &mesh, const Scene<dim> &scene) {
  std::vector<ContactFace<dim>> faces = find_own_faces(mesh, scene);
  if (mesh.is_shared())
    faces = share(faces, mesh.communicator());
  std::stable_sort(faces.begin(), faces.end(),
                   [](const auto &a, const auto &b) { return a.side < b.side; });
  return faces;
}

/** Returns @p rule on the box between two corners in the reference coordinates of a face. */
template <int dim>
Quadrature<dim> on_box(const Quadrature<dim> &rule, const Point<dim> &corner,
                       const Point<dim> &opposite) {
  std::vector<Point<dim>> points = rule.get_points();
  std::vector<double> weights = rule.get_weights();
  for (unsigned int d = 0; d < dim; ++d) {
    const double lowest = std::min(corner[d], opposite[d]);
    const double edge = std::abs(opposite[d] - corner[d]);
    for (Point<dim> &point : points)
      point[d] = lowest + edge * point[d];
    for (double &weight : weights)
      weight *= edge;
  }
  return Quadrature<dim>(points, weights);
}

} // namespace

template <int dim>
ContactSurface<dim>::ContactSurface(const Mesh<dim> &mesh, const Scene<dim> &scene,
                                    const Partition &partition)
  : mesh_(mesh)
  , scene_(scene)
  , faces_(find_contact_faces(mesh, scene)) {
  divide(partition);
  keep_own_pieces();
  // φ.n dS has degree one per direction on a flat face, and degree two on a parabola.
  place_points(std::vector<unsigned int>(mesh.triangulation().n_active_cells(), 2));
}

template <int dim>
ContactSurface<dim>::ContactSurface(const Mesh<dim> &mesh, const Scene<dim> &scene,
                                    const std::vector<unsigned int> &n_points)
  : mesh_(mesh)
  , scene_(scene)
  , faces_(find_contact_faces(mesh, scene)) {
  divide(Partition{1, {}, true});
  keep_own_pieces();
  place_points(n_points);
}

template <int dim>
void ContactSurface<dim>::place_points(const std::vector<unsigned int> &n_points) {
  const FE_Nothing<dim> no_functions;
  std::unique_ptr<FEFaceValues<dim>> values;
  std::vector<Point<dim - 1>> last_points;
  for (Piece<dim> &piece : pieces_) {
    unsigned int n = n_points[faces_[piece.face].cell->active_cell_index()];
    if (piece.opposite && !mesh_.is_shared())
      n = std::max(n, n_points[faces_[piece.opposite->first].cell->active_cell_index()]);
    const Quadrature<dim - 1> rule =
      on_box<dim - 1>(QGauss<dim - 1>(n), piece.lower_on_face, piece.upper_on_face);
    // Nearly all pieces are whole faces or the same part of one.
    if (values == nullptr || rule.get_points() != last_points)
      values = std::make_unique<FEFaceValues<dim>>(mesh_.mapping(), no_functions, rule,
                                                   update_quadrature_points |
                                                     update_normal_vectors | update_JxW_values);
    last_points = rule.get_points();
    values->reinit(faces_[piece.face].cell, faces_[piece.face].face_no);
    SurfaceRule<dim> &on_mesh = piece.on_mesh;
    on_mesh.on_face = rule.get_points();
    on_mesh.points = values->get_quadrature_points();
    on_mesh.normals = values->get_normal_vectors();
    on_mesh.weights = values->get_JxW_values();
    set_coordinates(piece, on_mesh);
    complete(piece, on_mesh);
  }
}

template <int dim>
const ContactFace<dim> &ContactSurface<dim>::face_of_carrier(const Piece<dim> &piece) const {
  const ContactFace<dim> &own = faces_[piece.face];
  return piece.opposite &&
             ContactPair<dim>(scene_, patches_[piece.patch].contact).carrier() != own.side
           ? faces_[piece.opposite->first]
           : own;
}

template <int dim>
double ContactSurface<dim>::longest_patch() const {
  double longest = 0.;
  for (const Patch<dim> &patch : patches_)
    longest = std::max(longest, patch.diameter());
  return longest;
}

template <int dim>
void ContactSurface<dim>::keep_own_pieces() {
  std::vector<std::set<unsigned int>> own(patches_.size()), opposite(own);
  for (const Piece<dim> &piece : pieces_) {
    own[piece.patch].insert(piece.face);
    if (piece.opposite)
      opposite[piece.patch].insert(piece.opposite->first);
  }
  has_unstable_patch_ = false;
  for (std::size_t t = 0; t < patches_.size(); ++t)
    has_unstable_patch_ = has_unstable_patch_ || own[t].size() < 2 || opposite[t].size() == 1;
  const auto is_foreign = [&](const Piece<dim> &piece) {
    return !faces_[piece.face].is_on_this_rank();
  };
  pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), is_foreign), pieces_.end());
}

template class ContactSurface<2>;
template class ContactSurface<3>;
} // namespace Signorini
