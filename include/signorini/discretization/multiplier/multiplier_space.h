// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/multiplier/admissible_set.h>

#include <deal.II/lac/vector.h>

#include <utility>
#include <vector>

namespace Signorini
{
/** P, the values of p_H at the nodes of its basis (force/length^{dim-1}). Every rank stores all of
 * them: a boundary has few. */
class Pressure : public dealii::Vector<double>
{
public:
  Pressure() = default;
  /** Zero values. */
  explicit Pressure(const unsigned int n)
    : dealii::Vector<double>(n)
  {
  }
  explicit Pressure(const dealii::Vector<double> &values)
    : dealii::Vector<double>(values)
  {
  }
  using dealii::Vector<double>::operator=;
};

/**
 * The space Q^H of functions that are polynomials on every patch; on most meshes constants.
 *
 * With n unknowns a patch has polynomials of degree n - 1 in the coordinate of its side, and the
 * Lagrange basis ψ_k at the n Gauss points of the patch: p_H = sum P_k ψ_k. For n = 1 that is
 * ψ = 1. With n - 1 = p - 2 on the faces of elements of degree p the pair is inf-sup stable. The
 * basis is orthogonal in L2, and P_k is the value of p_H at a Gauss point, where N^H restricts its
 * sign.
 *
 * On the nodes of the trace of V^h (Nodes::lobatto) p_H is continuous: neighbouring patches share
 * the node between them. With the rules of Gauss and Lobatto on the faces D and G are then those of
 * collocation, u_n ≤ g at the nodes. All unknowns, signs, values and integrals of multipliers come
 * from this space, so that another basis changes only this file.
 */
template <int dim>
class MultiplierSpace
{
public:
  using Vector = dealii::Vector<double>;
  /** The numbers of the unknowns at the nodes of a patch, in the order of arc length. */
  using Unknowns = std::vector<unsigned int>;
  /** The number of a node without an unknown: there p_H is zero. */
  static constexpr unsigned int no_unknown = numbers::invalid_unsigned_int;

  /** The nodes of a patch with several unknowns. */
  enum class Nodes
  {
    gauss,
    lobatto
  };

  /**
   * Makes the space of constants.
   * @param surface must outlive the object.
   */
  explicit MultiplierSpace(const ContactSurface<dim> &surface);
  /**
   * Makes the space of polynomials.
   * @param n_nodes of every patch, at least one, or two of Lobatto. Only in 2-D more than one.
   * @param without numbers of unknowns, sorted, as they are without this list: these nodes get
   * none.
   */
  MultiplierSpace(const ContactSurface<dim> &surface,
                  const std::vector<unsigned int> &n_nodes,
                  Nodes nodes = Nodes::gauss,
                  const std::vector<unsigned int> &without = {});

  const ContactSurface<dim> &surface() const
  {
    return surface_;
  }
  /** Returns m, the number of unknowns. */
  unsigned int n_multipliers() const
  {
    return patch_of_.size();
  }
  /** Returns the set of admissible P: pressures, P ≤ 0. */
  AdmissibleSet admissible_set() const
  {
    return AdmissibleSet::nonpositive(n_multipliers());
  }
  Nodes nodes() const
  {
    return nodes_;
  }
  /** Returns all unknowns whose functions do not vanish on a patch. */
  const Unknowns &unknowns_on(const unsigned int patch) const
  {
    return unknowns_[patch];
  }
  /** Returns the function of the i-th of these unknowns at a point of the side. */
  double shape_value(unsigned int patch, unsigned int i, const Point<dim - 1> &s) const;

  /** Returns the first unknown of a patch. Every unknown belongs to one patch, which has
   * first_of(patch), ..., first_of(patch + 1) - 1; of two patches that share a node, to the first.
   */
  unsigned int first_of(const unsigned int patch) const
  {
    return first_[patch];
  }
  unsigned int patch_of(const unsigned int unknown) const
  {
    return patch_of_[unknown];
  }
  unsigned int n_of(const unsigned int patch) const
  {
    return first_[patch + 1] - first_[patch];
  }
  /** Returns whether every patch has one unknown. */
  bool is_piecewise_constant() const
  {
    return n_multipliers() == surface_.patches().size();
  }
  /** Returns the point of the side at which the unknown is the value of p_H. */
  Point<dim - 1> node(unsigned int unknown) const;

  /** Returns ψ_k at the point @p s of the side, on the patch to which the unknown belongs. */
  double shape_value(unsigned int unknown, const Point<dim - 1> &s) const;
  /** Returns p_H at a point of a patch. */
  double value(const Pressure &P, unsigned int patch, const Point<dim - 1> &s) const;

  /** Returns the largest P_k that N^H allows: p_H ≤ 0 at every node. */
  Vector upper_bounds() const;
  /** Returns ∫ ψ_k for all k (length^{dim-1}). */
  Vector integrals() const;
  /** Returns R^H q, the L2-projection of a function q, from its moments b_k = ∫ q ψ_k. */
  Vector project(const Vector &moments) const;

private:
  /** Returns whether the last node of a side is its first one, too. */
  bool closes(const Patch<dim> &last) const;
  /** Returns whether a corner of the side lies before the patch. */
  bool starts_at_corner(const Patch<dim> &patch) const;
  /** Numbers the unknowns, patch after patch. */
  void number(const std::vector<unsigned int> &n_nodes, const std::vector<unsigned int> &without);

  const ContactSurface<dim> &surface_;
  Nodes nodes_;
  /** The unknowns by patch. */
  std::vector<Unknowns> unknowns_;
  /** The first unknown by patch, and the number of all. */
  std::vector<unsigned int> first_;
  /** The patch of every unknown, and its node there. */
  std::vector<unsigned int> patch_of_, node_of_;
};

/**
 * Returns ∫ q ψ_k for all k, where @p values_on (piece, rule) is a function q at the points of
 * a rule on a piece.
 * @param n_points per direction, for constants; one more per degree.
 */
template <int dim, typename Function>
dealii::Vector<double> integrate_against_multipliers(const MultiplierSpace<dim> &space,
                                                     const unsigned int n_points,
                                                     const Grading grading,
                                                     const Function &values_on)
{
  dealii::Vector<double> moments(space.n_multipliers());
  for (const Piece<dim> &piece : space.surface().pieces())
  {
    const auto &unknowns = space.unknowns_on(piece.patch);
    // Collocation has its own rule.
    const SurfaceRule<dim> rule =
      space.nodes() == MultiplierSpace<dim>::Nodes::lobatto
        ? piece.on_mesh
        : space.surface().rule(piece, n_points + unknowns.size() - 1, grading);
    const std::vector<double> q = values_on(piece, rule);
    for (unsigned int k = 0; k < unknowns.size(); ++k)
      if (unknowns[k] != space.no_unknown)
        for (std::size_t i = 0; i < rule.size(); ++i)
          moments[unknowns[k]] +=
            q[i] * space.shape_value(piece.patch, k, rule.on_side[i]) * rule.weights[i];
  }
  return moments;
}

/**
 * Returns G_k = ∫ g ψ_k (length^dim), with @p n_points Gauss points per direction and part of a
 * piece for constants; @p grading of the rules. @p boundary holds the gap of every side.
 * @throws InputError where g has no value.
 */
template <int dim>
dealii::Vector<double> assemble_gap(const MultiplierSpace<dim> &space,
                                    const std::vector<BoundaryCondition<dim>> &boundary,
                                    unsigned int n_points,
                                    Grading grading = Grading::towards_kinks);

/** Returns G for the gap of the surface's own scene. */
template <int dim>
dealii::Vector<double> assemble_gap(const MultiplierSpace<dim> &space,
                                    const unsigned int n_points,
                                    const Grading grading = Grading::towards_kinks)
{
  return assemble_gap(space, space.surface().scene().boundary, n_points, grading);
}

/** The coupling D, n x m: one sparse column per multiplier, nonzero at the degrees of freedom near
 * its patch. It is small, and every rank stores all of it. */
class Coupling
{
public:
  using Column = std::vector<std::pair<types::global_dof_index, double>>;

  explicit Coupling(std::vector<Column> columns);

  unsigned int n_columns() const
  {
    return columns_.size();
  }
  const Column &column(const unsigned int k) const
  {
    return columns_[k];
  }
  /** Adds D P to the locally owned rows of @p vector. The caller compresses. */
  void add_product(const dealii::Vector<double> &P, DistributedVector &vector) const;
  /** Returns Dᵀ U. Collective. */
  dealii::Vector<double> transpose_product(const Displacement &U) const;
  /** Returns Dᵀ U for entries that are all on this rank. */
  dealii::Vector<double> transpose_product(const dealii::Vector<double> &U) const;
  /** Returns Dᵀ U from the locally owned rows of a distributed U; summed over the ranks it is Dᵀ
   * U. */
  dealii::Vector<double> local_transpose_product(const DistributedVector &U) const;

private:
  std::vector<Column> columns_;
};

/** Assembles D_jk = ∫_{Γ_c} φ_j.n ψ_k, integrated exactly on the pieces face ∩ patch. */
template <int dim>
Coupling assemble_coupling(const DisplacementSpace<dim> &space,
                           const MultiplierSpace<dim> &multipliers);

/** Returns Tᵀ D: the coupling of the unconstrained degrees of freedom. */
Coupling condense(const Coupling &D, const AffineConstraints<double> &constraints);
} // namespace Signorini
