// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/base/parallel.h>
#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/mesh/cut_quadrature.h>

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/hp/mapping_collection.h>
#include <deal.II/hp/q_collection.h>

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace Signorini {
template <int dim>
using Cells = std::vector<typename DoFHandler<dim>::active_cell_iterator>;

/** Returns the cells of this rank, in their order, in chunks that one thread works on at a time. */
template <int dim>
std::vector<Cells<dim>> chunks_of_owned_cells(const DisplacementSpace<dim> &space) {
  constexpr std::size_t chunk_size = 512;
  std::vector<Cells<dim>> chunks;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned()) {
      if (chunks.empty() || chunks.back().size() == chunk_size)
        chunks.emplace_back().reserve(chunk_size);
      chunks.back().push_back(cell);
    }
  return chunks;
}

/** Calls consume(integrate(chunk)) for the cells of this rank, with all threads given. The chunks
 * are the same for any number of threads, none depends on another (FEValues reads the cell before),
 * and they are consumed in order: so the digits are the same, too. */
template <typename Result, int dim>
void integrate_by_chunks(const DisplacementSpace<dim> &space,
                         const std::function<Result(const Cells<dim> &)> &integrate,
                         const std::function<void(const Result &)> &consume) {
  const std::vector<Cells<dim>> chunks = chunks_of_owned_cells(space);
  produce_in_parallel<Result>(
    n_available_threads(space.mesh().communicator()), chunks.size(),
    [&](const std::size_t i) { return integrate(chunks[i]); }, consume);
}

/** The FEValues of cells (@p rule_dim = dim) or FEFaceValues with Gauss' rules, one object for
 * every element of a space. Cells of degree p have p - 1 points per direction more than those of
 * degree one. */
template <int dim, int rule_dim>
class ValuesByElement {
public:
  /**
   * Stores the arguments.
   * @param n_points per direction, for degree one.
   */
  ValuesByElement(const Mapping<dim> &mapping, const DisplacementSpace<dim> &space,
                  const Kinks<dim> &kinks, const unsigned int n_points, const UpdateFlags flags)
    : kinks_(kinks)
    , mappings_(mapping)
    , space_(space)
    , n_points_(n_points)
    , plain_(mappings_, space.elements(), gauss_rules(), flags) {}

protected:
  using Values =
    std::conditional_t<rule_dim == dim, dealii::FEValues<dim>, dealii::FEFaceValues<dim>>;

  /** Returns the values with Gauss' rule, or with cut_rule(n_points); those are valid until the
   * next call. @param face_no for faces of the cell. */
  template <typename CutRule, typename CellIterator, typename... FaceNumber>
  const Values &reinit_at(const bool is_cut, const CutRule &cut_rule, const CellIterator &cell,
                          const FaceNumber... face_no) {
    const unsigned int number = space_.element_number(cell);
    if (!is_cut) {
      plain_.reinit(cell, face_no..., number, 0, number);
      return plain_.get_present_fe_values();
    }
    cut_ = std::make_unique<Values>(mappings_[0], space_.elements()[number],
                                    cut_rule(n_points(number)), plain_.get_update_flags());
    cut_->reinit(cell, face_no...);
    return *cut_;
  }

  const Kinks<dim> &kinks_;

private:
  using HpValues = std::conditional_t<rule_dim == dim, hp::FEValues<dim>, hp::FEFaceValues<dim>>;

  unsigned int n_points(const unsigned int element_number) const {
    return n_points_ + space_.elements()[element_number].degree - 1;
  }
  hp::QCollection<rule_dim> gauss_rules() const {
    hp::QCollection<rule_dim> rules;
    for (unsigned int number = 0; number < space_.elements().size(); ++number)
      rules.push_back(QGauss<rule_dim>(n_points(number)));
    return rules;
  }

  const hp::MappingCollection<dim> mappings_;
  const DisplacementSpace<dim> &space_;
  unsigned int n_points_;
  HpValues plain_;
  std::unique_ptr<Values> cut_;
};

/** The shape functions at the Gauss points of a cell; on the pieces of a cell that a kink crosses,
 * at the Gauss points of each piece. */
template <int dim>
class CellValues : public ValuesByElement<dim, dim> {
public:
  using ValuesByElement<dim, dim>::ValuesByElement;

  /**
   * Computes the values on a cell.
   * @param cell of the mesh, or of a DoFHandler where functions are to be evaluated.
   */
  template <typename CellIterator>
  const FEValues<dim> &reinit(const CellIterator &cell) {
    // In 3-D planes do not cut cells yet.
    const auto cut_rule = [&](const unsigned int n) -> Quadrature<dim> {
      if constexpr (dim == 2)
        return cut_quadrature(this->kinks_, cell, n);
      return QGauss<dim>(n);
    };
    const bool is_cut = dim == 2 && needs_cuts<dim>(this->kinks_, cell);
    return this->reinit_at(is_cut, cut_rule, cell);
  }
};

/** The shape functions at the Gauss points of a face; where a kink cuts the face, at the Gauss
 * points of its parts. */
template <int dim>
class FaceValues : public ValuesByElement<dim, dim - 1> {
public:
  using CellIterator = typename Triangulation<dim>::active_cell_iterator;
  using ValuesByElement<dim, dim - 1>::ValuesByElement;

  const FEFaceValues<dim> &reinit(const CellIterator &cell, const unsigned int face_no) {
    const auto face = cell->face(face_no);
    // In 3-D planes do not cut faces yet.
    std::vector<double> cuts;
    if constexpr (dim == 2)
      cuts = this->kinks_.cut(face->vertex(0), face->vertex(1));
    const auto cut_rule = [&](const unsigned int n) -> Quadrature<dim - 1> {
      if constexpr (dim == 2)
        return split_quadrature(QGauss<1>(n), cuts);
      return QGauss<dim - 1>(n);
    };
    return this->reinit_at(cuts.size() > 2, cut_rule, cell, face_no);
  }
};

/** Returns, where the body moves as a whole, the energy norm that such a displacement has if it
 * strains the body: max|u_h| E_0^{1/2} l^{(dim-2)/2} with the unit of stiffness_unit(); max|u_h|
 * counts as at least 1e-6 of the body's size. |||u_h|||, forces and their errors are only rounding
 * then, or the remainder of the linear solver. Returns none where the body is strained. Collective.
 */
template <int dim>
std::optional<double> norm_of_rigid_motion(const DisplacementSpace<dim> &space,
                                           const Scene<dim> &scene, const Displacement &U);

/** What errors in the energy norm are divided by (root of force x length^{dim-1}). */
struct EnergyScale {
  /** The norm |||u_h|||. */
  double norm = 0.;
  /** The result of norm_of_rigid_motion(). */
  std::optional<double> rigid;

  /** Returns |||u_h|||. Where the body moves rigidly, |||u_h||| is rounding; the scale of an error
   * that is rounding, too, is norm_of_rigid_motion(), and a larger error is all of |||u|||. */
  double of(const double error) const {
    constexpr double rounding = 1e-7;
    if (!rigid)
      return norm;
    return error <= rounding * *rigid ? *rigid : error;
  }
};

/** The shape functions of V^h at points of contact faces. Consecutive faces with the same reference
 * points share one table. */
template <int dim>
class TraceValues {
public:
  explicit TraceValues(const DisplacementSpace<dim> &space);

  /**
   * Computes the shape functions on a face.
   * @param on_face points in the reference coordinates of the face.
   */
  const FEFaceValues<dim> &reinit(const ContactFace<dim> &face,
                                  const std::vector<Point<dim - 1>> &on_face);

  /** Returns u_h at the points of a rule on the face. */
  std::vector<Tensor<1, dim>> displacement(const ContactFace<dim> &face,
                                           const SurfaceRule<dim> &rule, const Displacement &U);

  /** Returns u_h.n at the points of a rule on the face. */
  std::vector<double> normal_displacement(const ContactFace<dim> &face,
                                          const SurfaceRule<dim> &rule, const Displacement &U);

private:
  const DisplacementSpace<dim> &space_;
  std::vector<Point<dim - 1>> on_face_;
  unsigned int element_number_ = 0;
  std::unique_ptr<FEFaceValues<dim>> values_;
};

/** The positions of the nodes of a cell, in the order of the cell's scalar shape functions. */
template <int dim>
class NodePositions {
public:
  explicit NodePositions(const DisplacementSpace<dim> &space)
    : mappings_(space.mesh().mapping())
    , values_(mappings_, space.elements(), nodes_of(space.elements()), update_quadrature_points) {}

  /** Returns the positions, valid until the next call. */
  const std::vector<Point<dim>> &
  operator()(const typename DoFHandler<dim>::active_cell_iterator &cell) {
    values_.reinit(cell);
    return values_.get_present_fe_values().get_quadrature_points();
  }

private:
  static hp::QCollection<dim> nodes_of(const hp::FECollection<dim> &elements) {
    hp::QCollection<dim> nodes;
    for (unsigned int number = 0; number < elements.size(); ++number)
      nodes.push_back(Quadrature<dim>(elements[number].base_element(0).get_unit_support_points()));
    return nodes;
  }

  const hp::MappingCollection<dim> mappings_;
  hp::FEValues<dim> values_;
};

/** Returns I^h u: the values of u at the nodes of V^h, all of them on every rank. */
template <int dim>
Displacement interpolate_at_nodes(const DisplacementSpace<dim> &space, const Function<dim> &u);

/** A moment: a number in 2-D, a vector in 3-D. */
template <int dim>
using Moment = Tensor<1, dim == 2 ? 1 : dim>;

/** Returns the moment x × F; in 2-D x1 F2 - x2 F1. */
inline Moment<2> moment_of(const Tensor<1, 2> &x, const Tensor<1, 2> &F) {
  Moment<2> moment;
  moment[0] = x[0] * F[1] - x[1] * F[0];
  return moment;
}
inline Moment<3> moment_of(const Tensor<1, 3> &x, const Tensor<1, 3> &F) {
  return cross_product_3d(x, F);
}

/** The resultant of surface and body forces: force and moment about the origin. */
template <int dim>
struct Resultant {
  Tensor<1, dim> force;
  Moment<dim> moment;

  /** Adds a force that acts at a point. */
  void add(const Tensor<1, dim> &F, const Point<dim> &x) {
    force += F;
    moment += moment_of(x, F);
  }
  Resultant &operator+=(const Resultant &other) {
    force += other.force;
    moment += other.moment;
    return *this;
  }
  /** Returns the moment about another point. */
  Moment<dim> moment_about(const Point<dim> &x) const {
    return moment - moment_of(x, force);
  }
};

/** Returns the sum over all ranks. Collective. */
template <int dim>
Resultant<dim> sum_over_ranks(const Resultant<dim> &part, MPI_Comm communicator) {
  return {Utilities::MPI::sum(part.force, communicator),
          Utilities::MPI::sum(part.moment, communicator)};
}
} // namespace Signorini
