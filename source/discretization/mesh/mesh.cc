// SPDX-License-Identifier: LGPL-2.1-or-later
// T^h by nested refinement, partitioned by p4est.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/discretization/mesh/arc_mapping.h>
#include <signorini/discretization/mesh/mesh.h>
#include <signorini/problem/geometry/arc_cell.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace Signorini {
namespace {
/** Makes every cell with an arc the transfinite interpolation of its own edges, of which all others
 * are straight. Before their vertices moved, cells were parts of coarse cells, which they may
 * leave.
 * @throws InputError where an arc folds its cell. */
void follow_arcs(const Geometry<2> &geometry, Triangulation<2> &triangulation) {
  types::manifold_id next = 0;
  for (const types::manifold_id id : triangulation.get_manifold_ids())
    next = id == numbers::flat_manifold_id ? next : std::max(next, id + 1);
  // Maps are stored for cells of all levels, those of coarser ones are not used.
  for (const auto &cell : triangulation.cell_iterators()) {
    const ArcCentres centres = arc_centres(geometry.sides, cell);
    for (const unsigned int f : cell->face_indices())
      if (!centres[f])
        cell->face(f)->set_manifold_id(numbers::flat_manifold_id);
    const bool is_map = cell->is_active() && has_arcs(centres);
    cell->set_manifold_id(is_map ? next : numbers::flat_manifold_id);
    if (!is_map)
      continue;
    const ArcCell map({{cell->vertex(0), cell->vertex(1), cell->vertex(3), cell->vertex(2)}},
                      {{centres[2], centres[1], centres[3], centres[0]}});
    if (!map.is_valid(0.))
      throw input_error(geometry.where_distortion, ": found ", geometry.distortion,
                        ", with which the cell at (", cell->center(),
                        ") is folded by its side on a circle, allowed: a smaller share.");
    triangulation.set_manifold(next++, map);
  }
}

/** Moves the interior vertices; the mapping of every cell must stay one to one. */
template <int dim>
void distort(const Geometry<dim> &geometry, Triangulation<dim> &triangulation) {
  using Info = GeometryInfo<dim>;
  GridTools::distort_random(geometry.distortion, triangulation, true);
  for (const auto &cell : triangulation.active_cell_iterators()) {
    Point<dim> vertices[Info::vertices_per_cell];
    Tensor<0, dim> determinants[Info::vertices_per_cell];
    for (const unsigned int v : cell->vertex_indices())
      vertices[v] = cell->vertex(v);
    Info::alternating_form_at_vertices(vertices, determinants);
    for (const double determinant : determinants)
      if (!(determinant > 0.))
        throw input_error(geometry.where_distortion, ": found ", geometry.distortion,
                          ", with which the cell at (", cell->center(),
                          ") is not convex, allowed: a smaller share.");
  }
  if constexpr (dim == 2)
    if (geometry.curved)
      follow_arcs(geometry, triangulation);
}

/** A map of the given degree, followed by x -> (x - lower)/size. */
template <int dim>
class UnitMapping : public MappingQ<dim> {
public:
  UnitMapping(const unsigned int degree, const Point<dim> &lower, const double size)
    : MappingQ<dim>(degree)
    , lower_(lower)
    , size_(size) {}

  std::unique_ptr<Mapping<dim>> clone() const override {
    return std::make_unique<UnitMapping<dim>>(this->get_degree(), lower_, size_);
  }

  bool preserves_vertex_locations() const override {
    return false;
  }

  boost::container::small_vector<Point<dim>, GeometryInfo<dim>::vertices_per_cell>
  get_vertices(const typename Triangulation<dim>::cell_iterator &cell) const override {
    auto vertices = MappingQ<dim>::get_vertices(cell);
    for (Point<dim> &x : vertices)
      x = to_unit_body(x);
    return vertices;
  }

protected:
  std::vector<Point<dim>> compute_mapping_support_points(
    const typename Triangulation<dim>::cell_iterator &cell) const override {
    auto points = MappingQ<dim>::compute_mapping_support_points(cell);
    for (Point<dim> &x : points)
      x = to_unit_body(x);
    return points;
  }

private:
  Point<dim> to_unit_body(const Point<dim> &x) const {
    return Point<dim>((x - lower_) / size_);
  }

  Point<dim> lower_;
  double size_;
};

/** A map of a body of revolution: dx and ds are those of the whole circumference, so that loops
 * over cells and faces contain no weight. */
template <typename Map>
class Revolved : public Map {
public:
  using Cell = Triangulation<2>::cell_iterator;
  using Data = Mapping<2>::InternalDataBase;
  using Output = dealii::internal::FEValuesImplementation::MappingRelatedData<2, 2>;

  /** @param axis the x-coordinate of the axis in the range of the map. */
  template <typename... Arguments>
  explicit Revolved(const double axis, Arguments &&...arguments)
    : Map(std::forward<Arguments>(arguments)...)
    , axis_(axis) {}

  std::unique_ptr<Mapping<2>> clone() const override {
    return std::make_unique<Revolved>(*this);
  }

protected:
  UpdateFlags requires_update_flags(const UpdateFlags flags) const override {
    const bool weighs = (flags & update_JxW_values) != 0;
    return Map::requires_update_flags(weighs ? flags | update_quadrature_points : flags);
  }

  CellSimilarity::Similarity fill_fe_values(const Cell &cell, CellSimilarity::Similarity,
                                            const Quadrature<2> &rule, const Data &data,
                                            Output &output) const override {
    // Cells at different distances from the axis are not similar.
    Map::fill_fe_values(cell, CellSimilarity::none, rule, data, output);
    revolve(data, output);
    return CellSimilarity::none;
  }

  using Map::fill_fe_face_values;
  void fill_fe_face_values(const Cell &cell, const unsigned int face,
                           const hp::QCollection<1> &rule, const Data &data,
                           Output &output) const override {
    Map::fill_fe_face_values(cell, face, rule, data, output);
    revolve(data, output);
  }

private:
  void revolve(const Data &data, Output &output) const {
    if ((data.update_each & update_JxW_values) != 0)
      for (unsigned int q = 0; q < output.JxW_values.size(); ++q)
        output.JxW_values[q] *= 2. * numbers::PI * (output.quadrature_points[q][0] - axis_);
  }

  double axis_;
};

/** Makes a map of the body, or one of the body of revolution that has its axis at x = @p axis. */
template <int dim, typename Map, typename... Arguments>
std::unique_ptr<Map> make_map(const std::optional<double> &axis, Arguments &&...arguments) {
  if constexpr (dim == 2)
    if (axis)
      return std::make_unique<Revolved<Map>>(*axis, std::forward<Arguments>(arguments)...);
  return std::make_unique<Map>(std::forward<Arguments>(arguments)...);
}

/** Returns the maps that curved bodies need, of degree two on nested meshes. The manifolds are
 * evaluated once per cell and not in every integral. With bilinear maps, π^{2h} would lose an
 * order: the map of a cell of T^{2h} must be that of its children up to higher order. */
template <int dim>
std::unique_ptr<const Mapping<dim>> cache(const Mapping<dim> &mapping, const unsigned int degree,
                                          const Triangulation<dim> &triangulation,
                                          const std::optional<double> &axis) {
  auto cached = make_map<dim, MappingQCache<dim>>(axis, degree);
  cached->initialize(mapping, triangulation);
  return cached;
}

/** Moves a vertex on a straight edge of the body to a point on it, unless an arc or a flat cell is
 * next to it. @return whether it moved. */
bool move_along_edge(Triangulation<2> &mesh, const unsigned int vertex, const Point<2> &target) {
  constexpr double least_ratio = 0.2;
  const Point<2> old = mesh.get_vertices()[vertex];
  std::vector<Triangulation<2>::cell_iterator> cells;
  std::vector<double> areas;
  Point<2> *moved = nullptr;
  const auto corner_areas = [&]() {
    std::vector<double> values;
    for (const auto &cell : cells)
      for (unsigned int v = 0; v < 4; ++v) {
        const Tensor<1, 2> a = cell->vertex(v ^ 1U) - cell->vertex(v),
                           b = cell->vertex(v ^ 2U) - cell->vertex(v);
        values.push_back((v == 0 || v == 3 ? 1. : -1.) * (a[0] * b[1] - a[1] * b[0]));
      }
    return values;
  };
  for (const auto &cell : mesh.active_cell_iterators())
    for (unsigned int v = 0; v < 4; ++v) {
      if (cell->vertex_index(v) != vertex)
        continue;
      cells.push_back(cell);
      moved = &cell->vertex(v);
      if (cell->manifold_id() != numbers::flat_manifold_id)
        return false;
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() &&
            (face->vertex_index(0) == vertex || face->vertex_index(1) == vertex)) {
          const Tensor<1, 2> edge = face->vertex(1) - face->vertex(0), way = target - old;
          if (std::abs(edge[0] * way[1] - edge[1] * way[0]) > 1e-10 * edge.norm_square())
            return false;
        }
    }
  const std::vector<double> before = corner_areas();
  *moved = target;
  const std::vector<double> after = corner_areas();
  for (std::size_t i = 0; i < after.size(); ++i)
    if (after[i] < least_ratio * before[i]) {
      *moved = old;
      return false;
    }
  return true;
}

/** Moves vertices of a coarse mesh to the points in which lines cross the sides: splits alone would
 * never reach a jump of a traction inside of an edge. */
void move_to_lines(Triangulation<2> &mesh, const std::array<std::vector<double>, 2> &lines) {
  std::set<unsigned int> moved;
  for (unsigned int d = 0; d < 2; ++d)
    for (const double position : lines[d])
      for (const auto &face : mesh.active_face_iterators()) {
        const double from = face->vertex(0)[d] - position, to = face->vertex(1)[d] - position;
        if (!face->at_boundary() || from * to >= 0.)
          continue;
        const double t = from / (from - to);
        Point<2> crossing = face->vertex(0) + t * (face->vertex(1) - face->vertex(0));
        crossing[d] = position;
        for (const unsigned int end : {t < 0.5 ? 0U : 1U, t < 0.5 ? 1U : 0U})
          if (const unsigned int vertex = face->vertex_index(end);
              moved.count(vertex) == 0 && move_along_edge(mesh, vertex, crossing)) {
            moved.insert(vertex);
            break;
          }
      }
}

/** Moves to each point the nearest vertex inside of its side: a mesh that is graded to a vertex has
 * a third fewer cells than one that is graded to a point inside of an edge. */
void move_to_points(Triangulation<2> &mesh,
                    const std::vector<std::pair<unsigned int, Point<2>>> &points) {
  std::set<unsigned int> moved;
  for (const auto &[side, point] : points) {
    std::map<unsigned int, unsigned int> n_faces;
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == side)
        for (const unsigned int v : {0, 1})
          ++n_faces[face->vertex_index(v)];
    double smallest = std::numeric_limits<double>::max();
    unsigned int nearest = numbers::invalid_unsigned_int;
    for (const auto &[vertex, n] : n_faces)
      if (const double distance = mesh.get_vertices()[vertex].distance(point);
          n == 2 && moved.count(vertex) == 0 && distance < smallest) {
        smallest = distance;
        nearest = vertex;
      }
    if (smallest > 0. && nearest != numbers::invalid_unsigned_int &&
        move_along_edge(mesh, nearest, point))
      moved.insert(nearest);
  }
}
} // namespace

unsigned int level_of_subtrees(const double n_coarse_cells, const unsigned int dim,
                               const unsigned int n_ranks) {
  constexpr double n_per_rank = 8.;
  unsigned int level = 0;
  if (n_ranks > 1)
    while (std::ldexp(n_coarse_cells, static_cast<int>(dim * level)) < n_per_rank * n_ranks)
      ++level;
  return level;
}

namespace {
/** Makes a triangulation of one process, or one that processes share. */
template <int dim>
std::unique_ptr<parallel::TriangulationBase<dim>> make_triangulation(MPI_Comm communicator) {
  using Shared = parallel::distributed::Triangulation<dim>;
  using Alone = parallel::shared::Triangulation<dim>;
  if (Utilities::MPI::n_mpi_processes(communicator) > 1)
    return std::make_unique<Shared>(communicator, Triangulation<dim>::none,
                                    Shared::no_automatic_repartitioning);
  return std::make_unique<Alone>(communicator, Triangulation<dim>::none,
                                 /*allow_artificial_cells=*/false, Alone::partition_zorder);
}
} // namespace

template <int dim>
Mesh<dim>::Mesh(const Geometry<dim> &geometry, const unsigned int coarsest_level,
                const unsigned int level, MPI_Comm communicator)
  : triangulation_(make_triangulation<dim>(communicator))
  , subtree_level_(level_of_subtrees(geometry.n_coarse_cells, dim,
                                     Utilities::MPI::n_mpi_processes(communicator)))
  , curved_(dim == 2 && geometry.curved)
  , has_bent_parents_(dim == 3 && geometry.curved)
  , is_graded_(false)
  , axisymmetric_(geometry.axisymmetric)
  , lower_(geometry.lower)
  , size_(geometry.longest_extent())
  , n_nested_ancestors_(geometry.distortion == 0. ? level : level - std::min(coarsest_level, level))
  , uniform_levels_(level) {
  const unsigned int first = std::min(coarsest_level, level);
  geometry.make_coarse_mesh(*triangulation_);
  if (is_shared()) {
    AssertThrow(geometry.distortion == 0. && level > subtree_level_, ExcNotImplemented());
    triangulation_->refine_global(subtree_level_);
    dynamic_cast<parallel::distributed::Triangulation<dim> &>(*triangulation_).repartition();
  } else
    triangulation_->refine_global(first);
  if (geometry.distortion > 0.)
    distort(geometry, *triangulation_);
  triangulation_->refine_global(level - this->level());
  if (geometry.number_after_refinement)
    geometry.number_after_refinement(*triangulation_);
  make_mappings(2);
}

template <int dim>
Mesh<dim>::Mesh(const Geometry<dim> &geometry, const unsigned int base_level,
                const MeshGuides<dim> &guides, const Splits &must_split,
                const unsigned int mapping_degree)
  : triangulation_(make_triangulation<dim>(MPI_COMM_SELF))
  , subtree_level_(0)
  , curved_(dim == 2 && geometry.curved)
  , has_bent_parents_(dim == 3 && geometry.curved)
  , is_graded_(true)
  , axisymmetric_(geometry.axisymmetric)
  , lower_(geometry.lower)
  , size_(geometry.longest_extent())
  , n_nested_ancestors_(0)
  , uniform_levels_(0) {
  const bool is_distorted = geometry.distortion > 0.;
  uniform_levels_ = base_level;
  if (geometry.make_guided_mesh && !is_distorted)
    uniform_levels_ = geometry.make_guided_mesh(*triangulation_, base_level, guides);
  else
    geometry.make_coarse_mesh(*triangulation_);
  if constexpr (dim == 2)
    if (!is_distorted && uniform_levels_ == base_level)
      move_to_lines(*triangulation_, guides.lines);
  triangulation_->refine_global(uniform_levels_);
  if constexpr (dim == 2)
    if (!is_distorted)
      move_to_points(*triangulation_, guides.vertices);
  if (is_distorted)
    distort(geometry, *triangulation_);
  if (geometry.number_after_refinement)
    geometry.number_after_refinement(*triangulation_);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto &cell : triangulation_->active_cell_iterators())
      if (must_split(cell, splits(cell))) {
        cell->set_refine_flag();
        changed = true;
      }
    if (changed)
      triangulation_->execute_coarsening_and_refinement();
  }
  make_mappings(mapping_degree);
}

template <int dim>
void Mesh<dim>::make_mappings(const unsigned int degree) {
  std::optional<double> axis, unit_axis;
  if (axisymmetric_) {
    axis = 0.;
    unit_axis = -lower_[0] / size_;
  }
  if (curved_) {
    mapping_ = cache(MappingQ<dim>(degree), degree, *triangulation_, axis);
    unit_mapping_ =
      cache(UnitMapping<dim>(degree, lower_, size_), degree, *triangulation_, unit_axis);
  } else {
    mapping_ = make_map<dim, MappingQ1<dim>>(axis);
    unit_mapping_ = make_map<dim, UnitMapping<dim>>(unit_axis, 1, lower_, size_);
  }
}

template <int dim>
std::pair<double, double> Mesh<dim>::range_of_edges() const {
  std::pair<double, double> squares(size_ * size_, 0.);
  for (const auto &cell :
       triangulation_->active_cell_iterators() | IteratorFilters::LocallyOwnedCell())
    for (const unsigned int line : cell->line_indices()) {
      const auto end = [&](const unsigned int v) {
        return cell->vertex(GeometryInfo<dim>::line_to_cell_vertices(line, v));
      };
      const double square = end(0).distance_square(end(1));
      squares = {std::min(squares.first, square), std::max(squares.second, square)};
    }
  return {std::sqrt(Utilities::MPI::min(squares.first, communicator())),
          std::sqrt(Utilities::MPI::max(squares.second, communicator()))};
}

template class Mesh<2>;
template class Mesh<3>;
} // namespace Signorini
