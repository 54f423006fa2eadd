// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/mesh.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/hp/fe_collection.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>

namespace Signorini {
/**
 * A functional r on V^h by its values r_j = r(φ_j), such as forces at nodes. A rank stores the rows
 * that it owns, and collects its contributions to rows of others until compress(); the products r·U
 * and the norms are sums over all ranks.
 */
using DualVector = LinearAlgebra::distributed::Vector<double>;

/**
 * U, the nodal values of a function in V^h. A rank stores the values that it owns and, as ghosts,
 * those at all other nodes of the cells that its mesh holds (DisplacementSpace::zero()). No other
 * values can be read. Norms and products are collective.
 */
class Displacement : public LinearAlgebra::distributed::Vector<double> {
public:
  using Base = LinearAlgebra::distributed::Vector<double>;

  Displacement() = default;
  /** Zero values, all of them on this rank. */
  explicit Displacement(const unsigned int n)
    : Base(n) {}
  /** Zero values with this distribution. */
  explicit Displacement(const std::shared_ptr<const Utilities::MPI::Partitioner> &rows)
    : Base(rows) {}
  /** Copies ghosts, too (deal.II copies the owned values only), without communication. */
  Displacement(const Displacement &U)
    : Base(U) {
    if (!U.has_ghost_elements())
      return;
    const auto n_owned = U.locally_owned_size();
    for (unsigned int i = 0; i < U.get_partitioner()->n_ghost_indices(); ++i)
      local_element(n_owned + i) = U.local_element(n_owned + i);
    set_ghost_state(true);
  }
  Displacement(Displacement &&) = default;
  Displacement &operator=(const Displacement &) = default;
  Displacement &operator=(Displacement &&) = default;
  using Base::operator=;
  /** Returns the values as a vector of deal.II, whose functions are compiled for these only. */
  const Base &entries() const {
    return *this;
  }
  Base &entries() {
    return *this;
  }
};

/** The operator by which a(.,.) takes the strain of a function of V^h. */
enum class StrainOperator {
  /** The strain ε(v) = (grad v + grad vᵀ)/2: the conforming element, which locks as Poisson's
   * ratio tends to 1/2. */
  symmetric_gradient,
  /** The B-bar strain ε(v) + (m - tr ε(v))/dim I, where m is the mean of tr ε(v) over the
   * cell. It keeps the order of V^h for all Poisson's ratios. (Hughes, Int. J. Numer. Methods Eng.
   * 15 (1980) 1413-1418, with the 2-D dilatation.) */
  mean_dilatation
};

/** The space V^h: FE_Q for each component, with the essential conditions of clamped, prescribed and
 * roller sides. Cells may have different degrees, and hanging nodes; u_h is continuous all the
 * same. (On an edge between two degrees it has the lower one.) */
template <int dim>
class DisplacementSpace {
public:
  /**
   * Makes the space with one element.
   * @param degree of the element per direction; the method of the paper and its orders are those of
   * degree one.
   */
  DisplacementSpace(const Mesh<dim> &mesh, const Scene<dim> &scene,
                    StrainOperator strain_operator = StrainOperator::symmetric_gradient,
                    unsigned int degree = 1);
  /**
   * Makes the space with several elements.
   * @param degrees of the active cells, in their order; all from 2 to the largest have an element.
   */
  DisplacementSpace(const Mesh<dim> &mesh, const Scene<dim> &scene,
                    const std::vector<unsigned int> &degrees);

  const Mesh<dim> &mesh() const {
    return mesh_;
  }
  StrainOperator strain_operator() const {
    return strain_operator_;
  }
  using CellIterator = typename Triangulation<dim>::active_cell_iterator;

  /** Returns the elements that cells may have. */
  const hp::FECollection<dim> &elements() const {
    return dofs_.get_fe_collection();
  }
  /** Returns whether cells have different elements. */
  bool has_several_elements() const {
    return elements().size() > 1;
  }
  /** Returns the number of the element of one of the mesh's cells. */
  unsigned int element_number(const CellIterator &cell) const {
    return has_several_elements() ? dof_cell(cell)->active_fe_index() : 0;
  }
  const FiniteElement<dim> &element(const CellIterator &cell) const {
    return elements()[element_number(cell)];
  }
  /** Returns the element of all cells. Where cells have different ones, call element(cell). */
  const FiniteElement<dim> &element() const {
    Assert(!has_several_elements(), ExcInternalError());
    return elements()[0];
  }
  /** Returns the highest degree of an element. */
  unsigned int max_element_degree() const {
    return elements().max_degree();
  }
  const DoFHandler<dim> &dofs() const {
    return dofs_;
  }
  /** Returns the constraints of the degrees of freedom: U = T U_free + k. */
  const AffineConstraints<double> &constraints() const {
    return constraints_;
  }
  /** Returns the degrees of freedom through which clamped, prescribed and roller sides hold the
   * body: the only ones that carry reactions. (Other constraints keep u_h continuous.) */
  const IndexSet &supports() const {
    return supports_;
  }
  /** A degree of freedom that holds a body, which contact alone stops, while the system is solved.
   */
  struct Pin {
    types::global_dof_index dof;
    Point<dim> node;
    unsigned int component;
    /** The number of the body. */
    unsigned int body;
  };
  /** Returns one pin for each rigid motion that supports leave free, where
   * Scene::is_held_by_contact. Pins are no supports: the solution leaves no reaction there. */
  const std::vector<Pin> &pins() const {
    return pins_;
  }
  /** Returns the prescribed values of a scene with the same roles: k at constrained degrees of
   * freedom (those on pins are zero), zero at all others. */
  Displacement prescribed(const Scene<dim> &scene) const;
  const IndexSet &locally_owned() const {
    return dofs_.locally_owned_dofs();
  }
  /** Returns the functional zero. */
  DualVector make_vector() const {
    return DualVector(rows_);
  }
  /** Returns U = 0 with the ghosts of this rank. */
  Displacement zero() const {
    Displacement U(rows_);
    U.update_ghost_values();
    return U;
  }
  /** Returns U with the values of the unconstrained rows, and the others computed from them. */
  Displacement complete(const Displacement &free_values) const;
  /** Sets the constrained values of a difference of two displacements: T w_free, zero where
   * displacements are prescribed. */
  void distribute_homogeneous(Displacement &w) const;
  /** Sets the same values without pins: the body may move as a whole. */
  void distribute_without_pins(Displacement &w) const;
  /** Returns constraints() without pins. */
  const AffineConstraints<double> &constraints_without_pins() const {
    return pins_.empty() ? constraints_ : constraints_without_pins_;
  }
  /** Returns the functional restricted to V^h: Tᵀ r, where v = T v_free for v in V^h. r_j =
   * r(φ_j) for all j; the result is zero at constrained degrees of freedom, whatever is
   * prescribed there. */
  DualVector condense(const DualVector &functional) const;
  /** Adds r_j of degrees of freedom that only keep u_h continuous to those of their masters: the
   * functional is the same on continuous functions. Reactions are then at supports and nowhere
   * else. */
  void carry_to_masters(DualVector &functional) const;
  /** Sets the values of degrees of freedom that only keep a function continuous. */
  void make_continuous(Displacement &v) const;
  /** Returns one of the mesh's cells with its degrees of freedom. */
  typename DoFHandler<dim>::active_cell_iterator dof_cell(const CellIterator &cell) const;
  /** Returns the degrees of freedom of one of the mesh's cells. */
  std::vector<types::global_dof_index> cell_dofs(const CellIterator &cell) const;

private:
  /** Distributes the degrees of freedom after the elements are chosen. */
  void distribute(const Scene<dim> &scene, const hp::FECollection<dim> &elements);

  const Mesh<dim> &mesh_;
  StrainOperator strain_operator_;
  DoFHandler<dim> dofs_;
  AffineConstraints<double> constraints_;
  /** The constraints without pins, set only where there are pins. */
  AffineConstraints<double> constraints_without_pins_;
  /** The constraints that keep u_h continuous; empty where no node hangs and all degrees are equal.
   */
  AffineConstraints<double> continuity_;
  IndexSet supports_;
  /** The rows that this rank owns, and its ghosts. */
  std::shared_ptr<const Utilities::MPI::Partitioner> rows_;
  std::vector<Pin> pins_;
};
} // namespace Signorini
