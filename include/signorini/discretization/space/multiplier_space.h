// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/base/errors.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/space/admissible_set.h>
#include <signorini/discretization/space/displacement_space.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <optional>
#include <vector>

namespace Signorini {
/** P, the values of p_H at the nodes of its basis (force/length^{dim-1}). Every rank stores all of
 * them: a boundary has few. */
class Pressure : public dealii::Vector<double> {
public:
  Pressure() = default;
  /** Zero values. */
  explicit Pressure(const unsigned int n)
    : dealii::Vector<double>(n) {}
  explicit Pressure(const dealii::Vector<double> &values)
    : dealii::Vector<double>(values) {}
  using dealii::Vector<double>::operator=;
};

/** Returns the value below which a pressure presses, -1e-12 max|P|: smaller values are zeros up to
 * the tolerance of a solver. */
inline double pressing_threshold(const Pressure &P) {
  return P.size() == 0 ? 0. : -1e-12 * P.linfty_norm();
}

/**
 * The space Q^H of functions that are polynomials on every patch; on most meshes constants.
 *
 * With n unknowns a patch has polynomials of degree n - 1 in the coordinate of its side, and the
 * Lagrange basis ψ_k at the n Gauss points of the patch: p_H = sum P_k ψ_k. For n = 1 that is
 * ψ = 1. With n - 1 = p - 2 on the faces of elements of degree p the pair is inf-sup stable. The
 * basis is orthogonal in L2, and P_k is the value of p_H at a Gauss point, where N^H restricts its
 * sign. All unknowns, signs, values and integrals of multipliers come from this space, so that
 * another basis changes only this file.
 */
template <int dim>
class MultiplierSpace {
public:
  using Vector = dealii::Vector<double>;

  /**
   * Makes the space of constants.
   * @param surface must outlive the object.
   */
  explicit MultiplierSpace(const ContactSurface<dim> &surface);
  /**
   * Makes the space of polynomials.
   * @param n_nodes of every patch. Only in 2-D more than one.
   */
  MultiplierSpace(const ContactSurface<dim> &surface, const std::vector<unsigned int> &n_nodes);

  const ContactSurface<dim> &surface() const {
    return surface_;
  }
  /** Returns m, the number of unknowns. */
  unsigned int n_multipliers() const {
    return patch_of_.size();
  }
  /** Returns the first unknown of a patch, which has first_of(patch), ..., first_of(patch + 1) - 1.
   */
  unsigned int first_of(const unsigned int patch) const {
    return first_[patch];
  }
  unsigned int n_of(const unsigned int patch) const {
    return first_[patch + 1] - first_[patch];
  }
  unsigned int patch_of(const unsigned int unknown) const {
    return patch_of_[unknown];
  }
  /** Returns whether every patch has one unknown. */
  bool is_piecewise_constant() const {
    return n_multipliers() == surface_.patches().size();
  }
  /** Returns the Gauss point of the side at which the unknown is the value of p_H. */
  Point<dim - 1> node(unsigned int unknown) const;
  /** Returns the unknown of a patch whose node is nearest to a point of the side. */
  unsigned int nearest_node(unsigned int patch, const Point<dim - 1> &s) const;

  /** Returns ψ_k at the point @p s of the side, on the patch to which the unknown belongs. */
  double shape_value(unsigned int unknown, const Point<dim - 1> &s) const;
  /** Returns p_H at a point of a patch; of (P_n, P_t) another component than the first. */
  double value(const Vector &P, unsigned int patch, const Point<dim - 1> &s,
               unsigned int component = 0) const;

  /** Returns ∫ ψ_k for all k (length^{dim-1}); in bodies of revolution over the circumference. */
  Vector integrals() const;
  /** Returns the same over the side itself. */
  Vector lengths() const;
  /** Returns R^H q, the L2-projection of a function q, from its moments b_k = ∫ q ψ_k. */
  Vector project(const Vector &moments) const;

private:
  const ContactSurface<dim> &surface_;
  /** The first unknown by patch, and the number of all. */
  std::vector<unsigned int> first_;
  /** The patch of every unknown. */
  std::vector<unsigned int> patch_of_;
  /** The Gauss points with their weights, and the basis between 0 and 1, by the number of nodes. */
  std::vector<QGauss<1>> rules_;
  std::vector<std::vector<Polynomials::Polynomial<double>>> bases_;
};

/**
 * Returns ∫ q ψ_k for all k, where @p values_on (piece, rule) is a function q at the points of
 * a rule on a piece. Collective.
 * @param n_points per direction, for constants; one more per degree.
 */
template <int dim, typename Function>
dealii::Vector<double> integrate_against_multipliers(const MultiplierSpace<dim> &space,
                                                     const unsigned int n_points,
                                                     const Grading grading,
                                                     const Function &values_on) {
  dealii::Vector<double> moments(space.n_multipliers());
  const MPI_Comm communicator = space.surface().communicator();
  agree(communicator, [&]() {
    for (const Piece<dim> &piece : space.surface().pieces()) {
      const SurfaceRule<dim> rule =
        space.surface().rule(piece, n_points + space.n_of(piece.patch) - 1, grading);
      const std::vector<double> q = values_on(piece, rule);
      for (unsigned int k = space.first_of(piece.patch); k < space.first_of(piece.patch + 1); ++k)
        for (std::size_t i = 0; i < rule.size(); ++i)
          moments[k] += q[i] * space.shape_value(k, rule.on_side[i]) * rule.weights[i];
    }
  });
  Utilities::MPI::sum(moments, communicator, moments);
  return moments;
}

/** A component of a vector on Γ_c: along the direction m of contact, mostly the outward normal, or
 * along a tangent. In the plane the tangent is m turned counter-clockwise. In space m = n, and
 * there are two: the first is the part of the x axis in the side (of the y axis where the side is
 * nearly perpendicular to x), the second is n × that. */
enum class Component { normal, tangential, second_tangential };

/** Returns the components of P_t. */
template <int dim>
std::vector<Component> tangents() {
  if constexpr (dim == 2)
    return {Component::tangential};
  else
    return {Component::tangential, Component::second_tangential};
}

/** Returns m or a tangent. */
template <int dim>
Tensor<1, dim> direction_of(Component component, const Tensor<1, dim> &m);

/**
 * Returns G_k = ∫ g ψ_k (length^dim), with @p n_points Gauss points per direction and part of a
 * piece for constants; @p grading of the rules. @p contacts hold the gap, or another function in
 * its place; one that is missing is zero. Of a vector in space @p component counts.
 * @throws InputError where g has no value.
 */
template <int dim>
dealii::Vector<double>
assemble_gap(const MultiplierSpace<dim> &space, const std::vector<ContactCondition<dim>> &contacts,
             unsigned int n_points, Grading grading = Grading::towards_kinks,
             FunctionPointer<dim> ContactCondition<dim>::*data = &ContactCondition<dim>::gap,
             Component component = Component::normal);

/** The coupling D, n x m: one sparse column per multiplier, nonzero at the degrees of freedom near
 * its patch. A rank stores the rows that it owns. */
class Coupling {
public:
  using Column = std::map<types::global_dof_index, double>;

  explicit Coupling(std::vector<Column> columns = {})
    : columns_(std::move(columns)) {}

  unsigned int n_columns() const {
    return columns_.size();
  }
  const Column &column(const unsigned int k) const {
    return columns_[k];
  }
  /** Returns the first column that is zero on all ranks. Collective. */
  std::optional<unsigned int> empty_column(MPI_Comm communicator) const;
  /** Adds D P to @p vector. */
  void add_product(const dealii::Vector<double> &P, DualVector &vector) const;
  /** Returns Dᵀ U; collective if U is distributed. */
  template <typename VectorType>
  dealii::Vector<double> transpose_product(const VectorType &U) const;

private:
  std::vector<Column> columns_;
};

/** Returns the coupling that is the sum of those of all ranks, which know some columns of their
 * cells. Collective. */
template <int dim>
Coupling sum_columns(const DisplacementSpace<dim> &space, std::vector<Coupling::Column> parts);

/** Assembles D_jk = ∫_{Γ_c} φ_j.m ψ_k, integrated exactly on the pieces face ∩ patch; with a
 * tangent instead of m if the component is tangential.
 * @param share of the sides that are named first, and of their opposites. */
template <int dim>
Coupling assemble_coupling(const DisplacementSpace<dim> &space,
                           const MultiplierSpace<dim> &multipliers,
                           Component component = Component::normal,
                           const std::array<double, 2> &share = {{1., 1.}});

/** Returns (P_n, P_t), or (D_n, D_t); in space P_t = (P_t1, P_t2). */
dealii::Vector<double> join(const dealii::Vector<double> &normal,
                            const dealii::Vector<double> &tangential);
Coupling join(const Coupling &normal, const Coupling &tangential);

/** Returns Tᵀ D: the coupling of the unconstrained degrees of freedom. */
Coupling condense(const Coupling &D, const AffineConstraints<double> &constraints);
} // namespace Signorini
