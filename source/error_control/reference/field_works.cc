// SPDX-License-Identifier: LGPL-2.1-or-later
// The integrals of a level's displacement over its cells, and its values on the boundary.

#include <signorini/discretization/mesh/arc_mapping.h>
#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/space/body_measure.h>
#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/discretization/space/cell_stiffness.h>
#include <signorini/error_control/equilibration/cell_shape.h>
#include <signorini/error_control/reference/field_works.h>
#include <signorini/error_control/reference/hidden_load.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

namespace Signorini {
namespace {
/** The nodes of Gauss and Lobatto on [0,1], and Lagrange's polynomials of these. */
struct LobattoBasis {
  explicit LobattoBasis(const unsigned int n_nodes)
    : nodes(QGaussLobatto<1>(n_nodes).get_points())
    , polynomials(Polynomials::generate_complete_Lagrange_basis(nodes)) {}

  std::vector<Point<1>> nodes;
  std::vector<Polynomials::Polynomial<double>> polynomials;
};

const LobattoBasis &lobatto_basis(const unsigned int n_nodes) {
  thread_local std::map<unsigned int, LobattoBasis> bases;
  return bases.try_emplace(n_nodes, n_nodes).first->second;
}
} // namespace

SideSpan::SideSpan(const Side<2> &side, const Curve &line) {
  // The middle is unique on closed sides, too.
  const double half = 0.5 * line.length(), middle = side.arc_length(line.point(half));
  from = middle - half;
  to = middle + half;
  is_forward = (line.point(line.length()) - line.point(0.)) * side.tangent(middle, to) > 0.;
}

Tensor<1, 2> BoundaryTrace::value(const double s) const {
  const LobattoBasis &basis = lobatto_basis(static_cast<unsigned int>(values.size()));
  const double t = (s - from) / (to - from);
  Tensor<1, 2> sum;
  for (std::size_t i = 0; i < values.size(); ++i)
    sum += basis.polynomials[i].value(t) * values[i];
  return sum;
}

namespace {
using WorkCell = DoFHandler<2>::active_cell_iterator;

/** An integral of u_h, and of π^{2h} u_h. */
using FieldSums = std::array<double, 2>;

/** The works of all fields on the cells of a chunk, and the rests of their quadrature. */
struct ChunkWorks {
  FieldSums strain = {{0., 0.}}, load = strain, margin = strain;
};

/** Integrals over one cell by larger and larger rules. */
struct RuleSequence {
  static constexpr unsigned int n_more = 12;

  /** Takes the integrals by the next rule. @return whether they differ by rounding from those
   * before. */
  bool agrees(const FieldSums &next) {
    constexpr double allowed = 1e-12;
    double rest = 0., size = 0.;
    for (std::size_t k = 0; k < sums.size(); ++k) {
      rests[k] = std::abs(next[k] - sums[k]);
      rest += rests[k];
      size += std::abs(next[k]);
    }
    const bool is_first = n_rules++ == 0;
    sums = next;
    return !is_first && rest <= allowed * size;
  }

  FieldSums sums = {{0., 0.}}, rests = sums;
  unsigned int n_rules = 0;
};

/** Points of several cells at which a body force is evaluated together: point by point, formulas
 * take several times as long. */
class LoadBatch {
public:
  LoadBatch()
    : forces_(size, dealii::Vector<double>(2)) {}

  bool is_full() const {
    return points_.size() == size;
  }
  /** Adds a point with v dx of each field there. @param cell the number of the sums. */
  void add(const Point<2> &x, const std::array<Tensor<1, 2>, 2> &weighted, const std::size_t cell) {
    points_.push_back(x);
    weighted_.push_back(weighted);
    cells_.push_back(cell);
  }
  /** Adds f·v dx of all points to the sums, and forgets the points. */
  void evaluate(const Function<2> &force, std::vector<FieldSums> &sums) {
    const std::size_t n = points_.size();
    // The list of values must be as long as that of points.
    points_.resize(size, n > 0 ? points_.back() : Point<2>());
    if (n > 0)
      force.vector_value_list(points_, forces_);
    for (std::size_t q = 0; q < n; ++q)
      for (std::size_t k = 0; k < 2; ++k)
        sums[cells_[q]][k] +=
          weighted_[q][k][0] * forces_[q][0] + weighted_[q][k][1] * forces_[q][1];
    points_.clear();
    weighted_.clear();
    cells_.clear();
  }

private:
  static constexpr std::size_t size = 128;

  std::vector<Point<2>> points_;
  std::vector<std::array<Tensor<1, 2>, 2>> weighted_;
  std::vector<std::size_t> cells_;
  std::vector<dealii::Vector<double>> forces_;
};

/** Integrates the fields of a level on the cells of a chunk. */
class WorkIntegrator {
public:
  WorkIntegrator(const Solved<2> &solved, const std::vector<EvaluatedField> &fields,
                 const ExactMaps &maps)
    : scene_(solved.scene)
    , maps_(maps)
    , n_fields_(fields.size())
    , degree_factor_(fields.back().n_generations > 0 ? 2 : 1)
    , is_curved_(solved.space.mesh().is_curved())
    , has_constant_load_(scene_.body_force != nullptr && is_constant(*scene_.body_force))
    , measure_(scene_)
    , u_(solved.space, fields, ValuesCache<2>::gauss,
         [&maps](const auto &cell) -> const Mapping<2> & { return maps.of(cell); }) {}

  ChunkWorks integrate(const Cells<2> &cells) {
    ChunkWorks chunk;
    for (const auto &cell : cells)
      add_strain(cell, chunk);
    if (scene_.body_force != nullptr)
      add_loads(cells, chunk);
    return chunk;
  }

  /** Returns the works of the body force by one rule, three points per direction for π^{2h} u_h. */
  ChunkWorks loads_by_one_rule(const Cells<2> &cells) {
    RuleSequence second;
    second.n_rules = 1;
    std::vector<Pending> pending;
    for (const auto &cell : cells)
      pending.push_back({cell, second});
    ChunkWorks chunk;
    for (const FieldSums &works : works_of_next_rule(pending))
      for (std::size_t k = 0; k < n_fields_; ++k)
        chunk.load[k] += works[k];
    return chunk;
  }

private:
  /** A cell on which the work of the load is not known yet. */
  struct Pending {
    WorkCell cell;
    RuleSequence works;
  };

  unsigned int degree_on(const WorkCell &cell) const {
    return degree_factor_ * cell->get_fe().degree;
  }
  bool is_plain(const WorkCell &cell) const {
    return !is_curved_ && is_affine<2>(cell);
  }
  /** Moves to the points of a rule on a cell, cut where data is not smooth. */
  void move_to(const WorkCell &cell, const Kinks<2> &kinks, const unsigned int n_points) {
    if (needs_cuts<2>(kinks, cell))
      u_.reinit_once(cell, cut_quadrature(kinks, cell, n_points, maps_.of(cell)));
    else
      u_.reinit(cell, n_points);
  }
  void add_strain(const WorkCell &cell, ChunkWorks &chunk) {
    const bool is_polynomial = scene_.material->is_constant_on_cells() && is_plain(cell);
    RuleSequence energies;
    unsigned int n_points = degree_on(cell) + 1;
    while (!energies.agrees(strain_energies(cell, n_points++)) && !is_polynomial &&
           energies.n_rules < RuleSequence::n_more) {
    }
    for (std::size_t k = 0; k < n_fields_; ++k) {
      chunk.strain[k] += energies.sums[k];
      chunk.margin[k] +=
        is_polynomial ? 0. : energies.rests[k] + rough_energy(cell, energies.sums[k]);
    }
  }
  FieldSums strain_energies(const WorkCell &cell, const unsigned int n_points) {
    FieldSums energies = {{0., 0.}};
    move_to(cell, scene_.law_kinks, n_points);
    for (unsigned int q = 0; q < u_.size(); ++q) {
      measure_.at(u_.points()[q]);
      for (std::size_t k = 0; k < n_fields_; ++k)
        energies[k] += u_.measure(q) * measure_.density(strain_of(u_.gradient(q, k)));
    }
    return energies;
  }
  /** Returns the energy on a cell with boxes of the law that hide details between points. */
  double rough_energy(const WorkCell &cell, const double strain) const {
    return scene_.law_kinks.boxes().hides_some(cell->bounding_box()) ? strain : 0.;
  }
  /** Adds the works of the body force, which is evaluated on many cells at once: formulas take
   * several times as long point by point. */
  void add_loads(const Cells<2> &cells, ChunkWorks &chunk) {
    std::vector<Pending> pending;
    for (const auto &cell : cells)
      pending.push_back({cell, {}});
    while (!pending.empty()) {
      const std::vector<FieldSums> works = works_of_next_rule(pending);
      std::size_t n_left = 0;
      for (std::size_t i = 0; i < pending.size(); ++i) {
        RuleSequence &rules = pending[i].works;
        const bool is_polynomial = has_constant_load_ && is_plain(pending[i].cell);
        if (!rules.agrees(works[i]) && !is_polynomial && rules.n_rules < RuleSequence::n_more) {
          pending[n_left++] = pending[i];
          continue;
        }
        for (std::size_t k = 0; k < n_fields_; ++k) {
          chunk.load[k] += rules.sums[k];
          chunk.margin[k] += is_polynomial ? 0. : 2. * rules.rests[k];
        }
      }
      pending.resize(n_left);
    }
  }
  /** Returns the works on all cells by their next rules. */
  std::vector<FieldSums> works_of_next_rule(const std::vector<Pending> &pending) {
    std::vector<FieldSums> works(pending.size(), {{0., 0.}});
    for (std::size_t i = 0; i < pending.size(); ++i) {
      move_to(pending[i].cell, scene_.kinks, degree_on(pending[i].cell) + pending[i].works.n_rules);
      for (unsigned int q = 0; q < u_.size(); ++q) {
        std::array<Tensor<1, 2>, 2> weighted;
        for (std::size_t k = 0; k < n_fields_; ++k)
          weighted[k] = u_.measure(q) * u_.value(q, k);
        batch_.add(u_.points()[q], weighted, i);
        if (batch_.is_full())
          batch_.evaluate(*scene_.body_force, works);
      }
    }
    batch_.evaluate(*scene_.body_force, works);
    return works;
  }

  const Scene<2> &scene_;
  const ExactMaps &maps_;
  const std::size_t n_fields_;
  const unsigned int degree_factor_;
  const bool is_curved_, has_constant_load_;
  EnergyMeasure<2> measure_;
  CellEvaluator<2> u_;
  LoadBatch batch_;
};

/** Adds integrals over all cells. */
void add_cell_works(const Solved<2> &solved,
                    const std::function<ChunkWorks(const Cells<2> &)> &integrate,
                    std::vector<FieldWorks> &works) {
  integrate_by_chunks<ChunkWorks, 2>(solved.space, integrate, [&works](const ChunkWorks &chunk) {
    for (std::size_t k = 0; k < works.size(); ++k) {
      works[k].strain += chunk.strain[k];
      works[k].load += chunk.load[k];
      works[k].margin += chunk.margin[k];
    }
  });
}

/** Returns the values at the middles of the faces of a cell. */
Quadrature<2> middles_of_faces(const unsigned int /*number*/) {
  return Quadrature<2>({{0., 0.5}, {1., 0.5}, {0.5, 0.}, {0.5, 1.}});
}

/** Makes the traces of a level on its boundary faces. */
class TraceMaker {
public:
  TraceMaker(const Solved<2> &solved, const std::vector<EvaluatedField> &fields)
    : solved_(solved)
    , n_fields_(fields.size())
    , middles_(solved.space, {fields.back()}, middles_of_faces, {}, false) {}

  /** Returns the traces of all fields on a face. @param f the face by its number in the cell. */
  std::vector<BoundaryTrace> traces(const WorkCell &cell, const unsigned int corner,
                                    const unsigned int f) {
    const std::vector<Side<2>> &sides = solved_.scene.geometry.sides;
    const unsigned int side = cell->face(f)->boundary_id();
    const SideSpan span(sides[side], shape_of(cell, sides).edge(corner));
    // Edges 0 and 1 of a cell run along a reference coordinate, 2 and 3 backwards.
    const bool is_forward = span.is_forward == (corner < 2);
    const CellField u(cell, solved_.U);
    std::vector<BoundaryTrace> traces(n_fields_, {side, span.from, span.to, {}});
    for (const Point<1> &node : lobatto_basis(u.degree() + 1).nodes)
      traces[0].values.push_back(u.on_face(f, is_forward ? node[0] : 1. - node[0]));
    if (n_fields_ > 1) {
      middles_.reinit(cell, 0);
      traces[1].values = traces[0].values;
      traces[1].values.insert(traces[1].values.begin() + 1, middles_.value(f));
    }
    return traces;
  }

private:
  const Solved<2> &solved_;
  const std::size_t n_fields_;
  CellEvaluator<2> middles_;
};

/** Adds the work of a given traction on a trace, with the rest of its quadrature. */
void add_traction(const Scene<2> &scene, const BoundaryTrace &trace, FieldWorks &works) {
  const Side<2> &side = scene.geometry.sides[trace.side];
  const Function<2> &t = *scene.boundary[trace.side].data;
  const std::vector<double> cuts = scene.kinks.cut(side, trace.from, trace.to);
  const auto integral = [&](const unsigned int n_points) {
    const Quadrature<1> rule = split_quadrature(QGauss<1>(n_points), cuts);
    double sum = 0.;
    dealii::Vector<double> given(2);
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const double s = rule.point(q)[0];
      t.vector_value(side.point(s), given);
      const Tensor<1, 2> v = trace.value(s);
      sum += rule.weight(q) * (given[0] * v[0] + given[1] * v[1]);
    }
    return sum;
  };
  constexpr unsigned int more = 4;
  const unsigned int n_points = static_cast<unsigned int>(trace.values.size()) + more;
  const double work = integral(n_points + more);
  works.load += work;
  works.margin += 2. * std::abs(work - integral(n_points));
}
/** Sums up the works of all ranks. */
void sum_over_ranks(const MPI_Comm communicator, FieldWorks &works) {
  works.strain = Utilities::MPI::sum(works.strain, communicator);
  works.load = Utilities::MPI::sum(works.load, communicator);
  works.margin = Utilities::MPI::sum(works.margin, communicator);
  std::vector<BoundaryTrace> all;
  for (const auto &traces : Utilities::MPI::all_gather(communicator, works.traces))
    all.insert(all.end(), traces.begin(), traces.end());
  works.traces = std::move(all);
}
/** Adds the traces of all fields, and their works on given tractions. */
void add_traces(const Solved<2> &solved, const std::vector<EvaluatedField> &fields,
                std::vector<FieldWorks> &works) {
  const Scene<2> &scene = solved.scene;
  TraceMaker maker(solved, fields);
  for (const auto &cell : solved.space.dofs().active_cell_iterators())
    for (unsigned int corner = 0; corner < 4; ++corner) {
      const unsigned int f = face_in_circle[corner];
      if (!cell->at_boundary(f) || !cell->is_locally_owned())
        continue;
      const Role role = scene.boundary[cell->face(f)->boundary_id()].role;
      if (role == Role::free)
        continue;
      const std::vector<BoundaryTrace> traces = maker.traces(cell, corner, f);
      for (std::size_t k = 0; k < works.size(); ++k)
        if (role == Role::traction)
          add_traction(scene, traces[k], works[k]);
        else
          works[k].traces.push_back(traces[k]);
    }
}

/** Returns u_h and, where cells of degree one have parents and straight edges, π^{2h} u_h. */
std::vector<EvaluatedField> fields_of_level(const Solved<2> &solved) {
  const Mesh<2> &mesh = solved.space.mesh();
  std::vector<EvaluatedField> fields = {{&solved.U}};
  if (mesh.has_parents() && !mesh.is_curved() && solved.space.max_element_degree() == 1)
    fields.push_back({&solved.U, 1});
  return fields;
}

/** Adds the work that loads may do between the points of rules. */
void add_hidden_work(const Solved<2> &solved, std::vector<FieldWorks> &works) {
  const double hidden = 2. * HiddenLoad(solved.scene).work(solved.space, solved.U);
  for (FieldWorks &field : works)
    field.margin += hidden;
}
} // namespace

std::vector<FieldWorks> works_of(const Solved<2> &solved) {
  const std::vector<EvaluatedField> fields = fields_of_level(solved);
  const ExactMaps maps(solved.space.mesh(), solved.scene.geometry.sides);
  std::vector<FieldWorks> works(fields.size());
  add_cell_works(
    solved,
    [&](const Cells<2> &cells) { return WorkIntegrator(solved, fields, maps).integrate(cells); },
    works);
  add_traces(solved, fields, works);
  for (FieldWorks &field : works)
    sum_over_ranks(solved.space.mesh().communicator(), field);
  add_hidden_work(solved, works);
  return works;
}

std::vector<FieldWorks> works_by_sums(const Solved<2> &solved, const Energies &energies,
                                      const std::optional<double> &post_strain) {
  std::vector<EvaluatedField> fields = fields_of_level(solved);
  // The interpolation of Q2 is not among the fields.
  const bool has_post = post_strain && fields.size() > 1;
  if (!has_post)
    fields.resize(1);
  const ExactMaps maps(solved.space.mesh(), solved.scene.geometry.sides);
  std::vector<FieldWorks> works(fields.size());
  if (has_post && solved.scene.body_force != nullptr) {
    std::vector<FieldWorks> post(1);
    add_cell_works(
      solved,
      [&](const Cells<2> &cells) {
        return WorkIntegrator(solved, {fields[1]}, maps).loads_by_one_rule(cells);
      },
      post);
    works[1] = post[0];
  }
  add_traces(solved, fields, works);
  for (FieldWorks &field : works)
    sum_over_ranks(solved.space.mesh().communicator(), field);
  works[0].strain = 2. * energies.strain;
  works[0].load = energies.loads;
  if (has_post)
    works[1].strain = *post_strain;
  add_hidden_work(solved, works);
  return works;
}
} // namespace Signorini
