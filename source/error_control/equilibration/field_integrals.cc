// SPDX-License-Identifier: LGPL-2.1-or-later
// The integrals of u_h and π^{2h} u_h that their distance to a stress in equilibrium needs.

#include <signorini/discretization/elasticity/cell_field.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/equilibration/field_integrals.h>
#include <signorini/error_control/loads/law.h>
#include <signorini/error_control/loads/law_sampling.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/fe/mapping_q1.h>

namespace Signorini {
namespace {
/** The integrals over the cells of a chunk. */
struct Chunk {
  std::array<double, 2> strain = {{0., 0.}}, load = {{0., 0.}};
  std::vector<std::pair<unsigned int, double>> distances;
};

/** Adds the points of a rule on a part of a cell, in reference coordinates, with their areas. */
void add_points(const Quadrature<2> &rule, const Triangle &x, const CellShape &shape,
                std::vector<Point<2>> &points, std::vector<double> &weights) {
  for (unsigned int q = 0; q < rule.size(); ++q) {
    points.push_back(shape.reference(point_of(x, rule.point(q)) - shape.corners[0]));
    weights.push_back(rule.weight(q) * twice_area(x));
  }
}

/** Returns the number of points per direction: for products of functions of degree two on
 * parallelograms; more where the law varies, or a load that is integrated itself. */
unsigned int n_points(const BoundData &data, const unsigned int n_fields) {
  const unsigned int n =
    (data.space.element().degree << (n_fields - 1)) + (data.scene.material->is_constant() ? 1 : 3);
  return StressMesh::aligns(data) || data.scene.body_force == nullptr ? n : n + 6;
}

/** Integrates over cells. Every chunk has its own object. */
class CellSums {
public:
  CellSums(const BoundData &data, const Tensor<1, 2> &translation, const CellForce &force)
    : data_(data)
    , translation_(translation)
    , force_(force)
    , n_fields_(data.space.mesh().has_parents() ? 2 : 1)
    , is_constant_(data.scene.material->is_constant())
    , values_(StaticMappingQ1<2>::mapping, data.space.element(),
              QGauss<2>(n_points(data, n_fields_)),
              update_values | update_gradients | update_inverse_jacobians | update_JxW_values |
                update_quadrature_points) {
    for (unsigned int k = 0; k < n_fields_; ++k)
      fields_.emplace_back(data.space, values_.get_quadrature(), k);
    if (is_constant_)
      hooke_ = data.scene.material->hooke(Point<2>());
  }

  void add(const DoFHandler<2>::active_cell_iterator &cell, Chunk &chunk) {
    values_.reinit(cell);
    double distance = 0.;
    if (is_constant_ || !needs_cuts<2>(data_.scene.law_kinks, cell))
      distance = add_energies(cell, values_, values_.get_JxW_values(), false, chunk);
    else
      visit_parts(cell, data_.scene.law_kinks,
                  [&](const FEValues<2> &values, const auto &weights, const bool is_rough) {
                    distance += add_energies(cell, values, weights, is_rough, chunk);
                  });
    if (force_ && !needs_cuts<2>(data_.scene.kinks, cell))
      add_loads(cell, values_, values_.get_JxW_values(), chunk);
    else if (force_)
      visit_parts(cell, data_.scene.kinks,
                  [&](const FEValues<2> &values, const auto &weights, const bool /*is_rough*/) {
                    add_loads(cell, values, weights, chunk);
                  });
    chunk.distances.emplace_back(cell->active_cell_index(), std::sqrt(distance));
  }

private:
  /** Visits the points of all smooth parts of a cell at once, and those of each rough one. */
  template <typename Visitor>
  void visit_parts(const DoFHandler<2>::active_cell_iterator &cell, const Kinks<2> &kinks,
                   const Visitor &visit) const {
    const QWitherdenVincentSimplex<2> rule(3);
    const CellShape shape(corners_of(cell));
    std::vector<Point<2>> smooth;
    std::vector<double> smooth_weights;
    const auto visit_points = [&](const std::vector<Point<2>> &points,
                                  const std::vector<double> &weights, const bool is_rough) {
      if (points.empty())
        return;
      FEValues<2> values(StaticMappingQ1<2>::mapping, data_.space.element(), Quadrature<2>(points),
                         values_.get_update_flags());
      values.reinit(cell);
      visit(values, weights, is_rough);
    };
    for (const auto &triangle : triangle_parts(shape, kinks))
      for (const TrianglePart &part : triangle) {
        std::vector<Point<2>> points;
        std::vector<double> weights;
        add_points(rule, part.corners, shape, part.is_rough ? points : smooth,
                   part.is_rough ? weights : smooth_weights);
        visit_points(points, weights, true);
      }
    visit_points(smooth, smooth_weights, false);
  }

  /** Adds energies, from above on a part where the law is rough. @return the square of the
   * distance. */
  double add_energies(const DoFHandler<2>::active_cell_iterator &cell, const FEValues<2> &values,
                      const std::vector<double> &weights, const bool is_rough, Chunk &chunk) {
    std::vector<const FieldValues<2> *> v;
    for (auto &field : fields_)
      v.push_back(&field.evaluate(data_.U, cell, values));
    std::array<double, 3> sums = {{0., 0., 0.}}, largest = sums;
    double area = 0.;
    for (std::size_t q = 0; q < weights.size(); ++q) {
      if (!is_constant_)
        hooke_ = data_.scene.material->hooke(values.quadrature_point(q));
      const Tensor<2, 2> &of_u = v[0]->gradients[q], &of_last = v.back()->gradients[q];
      const std::array<SymmetricTensor<2, 2>, 3> strains = {
        {symmetrize(of_u), symmetrize(of_last),
         symmetrize(n_fields_ == 2 ? of_last - of_u : of_u)}};
      area += weights[q];
      for (unsigned int k = 0; k < 3; ++k) {
        const double density = (hooke_ * strains[k]) * strains[k];
        sums[k] += weights[q] * density;
        largest[k] = std::max(largest[k], density);
      }
    }
    for (unsigned int k = 0; k < 3 && is_rough; ++k)
      sums[k] = area * largest[k];
    for (unsigned int k = 0; k < 2; ++k)
      chunk.strain[k] += sums[k];
    return sums[2];
  }

  void add_loads(const DoFHandler<2>::active_cell_iterator &cell, const FEValues<2> &values,
                 const std::vector<double> &weights, Chunk &chunk) {
    const std::vector<Tensor<1, 2>> force = force_(cell, values.get_quadrature_points());
    for (unsigned int k = 0; k < n_fields_; ++k) {
      const auto &v = fields_[k].evaluate(data_.U, cell, values).values;
      for (std::size_t q = 0; q < weights.size(); ++q)
        chunk.load[k] += weights[q] * (force[q] * (v[q] - translation_));
    }
  }

  const BoundData &data_;
  const Tensor<1, 2> translation_;
  const CellForce &force_;
  unsigned int n_fields_;
  bool is_constant_;
  FEValues<2> values_;
  std::vector<PatchInterpolation<2>> fields_;
  SymmetricTensor<4, 2> hooke_;
};

/** Adds what a face contributes to the moments of u_h, and of π^{2h} u_h = u_h + 4 s (1 - s)
 * bubble; where u is prescribed, v = u. */
void add_moments(const FEFaceValues<2> &values, const CellField &u, const unsigned int face,
                 const Tensor<1, 2> &translation, const Tensor<1, 2> &bubble,
                 const Function<2> *const prescribed, const TractionEdge &edge,
                 FieldsOfLevel &fields) {
  const Tensor<1, 2> n = values.normal_vector(0), t({-n[1], n[0]});
  const auto line = values.get_cell()->face(face);
  for (const unsigned int q : values.quadrature_point_indices()) {
    const Point<2> &x = values.quadrature_point(q);
    const double s = line->vertex(0).distance(x) / line->diameter();
    Tensor<1, 2> v = u.on_face(face, s) - translation, w = v + 4. * s * (1. - s) * bubble;
    if (prescribed != nullptr) {
      dealii::Vector<double> u_D(2);
      prescribed->vector_value(x, u_D);
      v = w = Tensor<1, 2>({u_D[0], u_D[1]}) - translation;
    }
    const auto L = legendre_values(edge.degree, edge.start.distance(x) / edge.length());
    for (unsigned int i = 0; i <= edge.degree; ++i)
      for (unsigned int c = 0; c < 2; ++c) {
        const Tensor<1, 2> weight = values.JxW(q) * L[i] * (c == 0 ? n : t);
        fields.u_h.moments[edge.position(c, i)] += weight * v;
        fields.post.moments[edge.position(c, i)] += weight * w;
      }
  }
}

void integrate_boundary(const BoundData &data, const TractionMesh &mesh,
                        const Tensor<1, 2> &translation, FieldsOfLevel &fields) {
  FaceValues<2> values(StaticMappingQ1<2>::mapping, data.space, data.scene.kinks, 8,
                       update_quadrature_points | update_JxW_values | update_normal_vectors);
  std::unique_ptr<PatchInterpolation<2>> post;
  if (data.space.mesh().has_parents())
    post = std::make_unique<PatchInterpolation<2>>(
      data.space, Quadrature<2>({{0., 0.5}, {1., 0.5}, {0.5, 0.}, {0.5, 1.}}));
  const double rounding = 1e-13 * data.U.linfty_norm();
  for (const auto &cell : data.space.dofs().active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      if (!cell->at_boundary(f))
        continue;
      const CellField u(cell, data.U);
      Tensor<1, 2> bubble;
      if (post)
        bubble = post->values(data.U, cell)[f] - u.on_face(f, 0.5);
      if (bubble.norm() <= rounding)
        bubble = 0.;
      const BoundaryCondition<2> &condition = data.scene.boundary[cell->face(f)->boundary_id()];
      add_moments(values.reinit(cell, f), u, f, translation, bubble,
                  condition.role == Role::displacement ? condition.data.get() : nullptr,
                  mesh.edges()[mesh.edge_at(cell, f)], fields);
      fields.bubbles[cell->face(f)->index()] = bubble;
    }
}
} // namespace

std::array<double, 2> FieldIntegrals::without_stress(const dealii::Vector<double> &x) const {
  std::array<double, 2> sums = {{strain - 2. * load, strain + 2. * std::abs(load)}};
  for (std::size_t i = 0; i < x.size(); ++i) {
    sums[0] -= 2. * moments[i] * x[i];
    sums[1] += 2. * std::abs(moments[i] * x[i]);
  }
  return sums;
}

PrescribedLift lift_of(const BoundData &data, const std::map<unsigned int, Tensor<1, 2>> &bubbles) {
  constexpr std::array<unsigned int, 4> face_in_circle = {{2, 1, 3, 0}};
  std::vector<PrescribedEdge> edges;
  for (const auto &cell : data.space.dofs().active_cell_iterators())
    for (unsigned int k = 0; k < 4; ++k) {
      const unsigned int face = face_in_circle[k];
      const auto line = cell->face(face);
      if (!cell->at_boundary(face) ||
          data.scene.boundary[line->boundary_id()].role != Role::displacement)
        continue;
      const CellField u(cell, data.U);
      const auto found = bubbles.find(line->index());
      const Tensor<1, 2> bubble = found != bubbles.end() ? found->second : Tensor<1, 2>();
      // Sides 0 and 1 run along a reference coordinate, 2 and 3 backwards.
      edges.push_back({cell->active_cell_index(), k, line->boundary_id(),
                       line->vertex(k < 2 ? 0 : 1), line->vertex(k < 2 ? 1 : 0),
                       [u, bubble, face, k](const double s) {
                         return u.on_face(face, k < 2 ? s : 1. - s) + 4. * s * (1. - s) * bubble;
                       }});
    }
  return PrescribedLift(data, data.space.mesh().triangulation().n_active_cells(), edges);
}

dealii::Vector<double> add_lift(const BoundData &data, const PrescribedLift &lift,
                                const unsigned int n_generations, const CellForce &force,
                                FieldIntegrals *const field) {
  dealii::Vector<double> norms(lift.cells().size());
  const Quadrature<2> rule = triangle_rule(16);
  for (const auto &cell : data.space.dofs().active_cell_iterators()) {
    const unsigned int number = cell->active_cell_index();
    if (!lift.cells()[number])
      continue;
    const CellShape shape(corners_of(cell));
    std::vector<Point<2>> points;
    std::vector<double> weights;
    for (const auto &parts :
         triangle_parts(shape, data.scene.law_kinks.with_lines(lift.lines(number, shape.corners))))
      for (const TrianglePart &part : parts)
        add_points(rule, part.corners, shape, points, weights);
    FEValues<2> values(StaticMappingQ1<2>::mapping, data.space.element(cell), Quadrature<2>(points),
                       update_gradients | update_inverse_jacobians | update_JxW_values |
                         update_quadrature_points);
    values.reinit(cell);
    std::vector<Tensor<2, 2>> gradients(points.size());
    if (field != nullptr)
      gradients = PatchInterpolation<2>(data.space, Quadrature<2>(), n_generations)
                    .evaluate(data.U, cell, values)
                    .gradients;
    const std::vector<Tensor<1, 2>> f = force ? force(cell, values.get_quadrature_points())
                                              : std::vector<Tensor<1, 2>>(points.size());
    double square = 0.;
    for (std::size_t q = 0; q < points.size(); ++q) {
      const Components e = lift.strain(number, shape, points[q]),
                       stress =
                         Law(data.scene.material->hooke(values.quadrature_point(q))).stiffness * e;
      square += weights[q] * (e * stress);
      if (field == nullptr)
        continue;
      const Tensor<2, 2> &g = gradients[q];
      field->strain +=
        weights[q] * ((Components({g[0][0], g[1][1], g[0][1] + g[1][0]}) * 2. + e) * stress);
      field->load += weights[q] * (f[q] * lift.value(number, points[q]));
    }
    norms[number] = std::sqrt(square);
  }
  if (field != nullptr)
    field->lift = norms.l2_norm();
  return norms;
}

FieldsOfLevel integrate_fields(const BoundData &data, const TractionMesh &mesh,
                               const PrescribedLift &lift, const Tensor<1, 2> &translation,
                               const CellForce &force) {
  FieldsOfLevel fields;
  fields.translation = translation;
  fields.distances.reinit(data.space.mesh().triangulation().n_active_cells());
  integrate_by_chunks<Chunk, 2>(
    data.space,
    [&](const Cells<2> &cells) {
      CellSums sums(data, translation, force);
      Chunk chunk;
      for (const auto &cell : cells)
        sums.add(cell, chunk);
      return chunk;
    },
    [&fields](const Chunk &chunk) {
      for (unsigned int k = 0; k < 2; ++k) {
        FieldIntegrals &field = k == 0 ? fields.u_h : fields.post;
        field.strain += chunk.strain[k];
        field.load += chunk.load[k];
      }
      for (const auto &[cell, distance] : chunk.distances)
        fields.distances[cell] = distance;
    });
  const MPI_Comm communicator = data.space.mesh().communicator();
  for (FieldIntegrals *const field : {&fields.u_h, &fields.post}) {
    field->strain = Utilities::MPI::sum(field->strain, communicator);
    field->load = Utilities::MPI::sum(field->load, communicator);
    field->moments.reinit(mesh.n_coefficients());
  }
  Utilities::MPI::sum(fields.distances, communicator, fields.distances);
  integrate_boundary(data, mesh, translation, fields);
  add_lift(data, lift, 0, force, &fields.u_h);
  if (data.space.mesh().has_parents())
    add_lift(data, lift_of(data, fields.bubbles), 1, force, &fields.post);
  return fields;
}
} // namespace Signorini
