// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/bound_data.h>
#include <signorini/error_control/equilibration/carrier.h>
#include <signorini/error_control/equilibration/edge_function.h>

#include <deal.II/base/polynomial.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** A point of the boundary. */
struct SidePoint {
  /** The number of the side in the geometry. */
  unsigned int side = 0;
  /** The arc length from the start of the side (length). */
  double arc_length = 0.;
};

/** Returns the name of a point, such as "bottom at (0.25, 0)". */
std::string name_of(const SidePoint &at, const Scene<2> &scene);

/** A polynomial of t in [0,1]: the chord between the values at the ends, and t (1 - t) times
 * another one. Monomials lose digits, a hundred times rounding at degree six; the ends are exact,
 * where a face that presses passes w on to the next one. */
struct FacePolynomial {
  double value(const double t) const {
    return (1. - t) * first + t * last + t * (1. - t) * inner.value(t);
  }

  double first = 0., last = 0.;
  Polynomials::Polynomial<double> inner = Polynomials::Polynomial<double>(0);
};

/** A vector field along a face, its components x and y. */
using FaceVector = std::array<FacePolynomial, 2>;

/** A contact face with d = ũ_n - g on it, as a function of t in [0,1] from vertex 0 to vertex 1 of
 * the face. Here and below v_n is v.m with the direction m of contact, and v_t that along its
 * tangent. In a pair ũ_n is that of both bodies, and d belongs to faces of the carrier; beyond the
 * other side d goes on as a constant, or falls to zero at a node that a support holds. */
struct PenetrationFace {
  using Dofs = std::array<types::global_dof_index, 2>;
  using Polynomial = Polynomials::Polynomial<double>;

  PenetrationFace(const unsigned int side, Curve line)
    : side(side)
    , line(std::move(line)) {}

  unsigned int side;
  /** The segment or arc from vertex 0 to vertex 1, t by arc length. */
  Curve line;
  /** The outward unit normal in the middle. */
  Tensor<1, 2> normal;
  /** The least and the largest t at which data of the side is that of this face: not at the corners
   * of the side. */
  std::array<double, 2> inside;
  /** The nodes on the face, first the vertices 0 and 1: t, the degrees of freedom, and for the
   * nodes between them the polynomials that are 1 at one and 0 at the others. */
  std::vector<double> nodes;
  std::vector<Dofs> dofs;
  std::vector<Polynomial> basis;
  /** The numbers of the conditions at the nodes, see ContactTrace::conditions(). */
  std::vector<unsigned int> conditions;
  /** The part of a patch on the face, its state, and the direction of contact where that is not the
   * normal. In a pair also the point of the other face. */
  struct Pressed {
    double from, to;
    NodeState state;
    std::optional<PieceOnFace> other;
    std::optional<Tensor<1, 2>> direction;

    /** Returns the parameter of the other face at t. */
    double on_other(double t) const;
  };
  /** The parts, sorted; none where the face belongs to the other side of a pair, or nothing faces
   * it. */
  std::vector<Pressed> pressures;
  /** τ_n and τ_t. */
  std::array<Polynomial, 2> traction;
  /** The positions where p_H jumps or data has a kink, with 0 and 1. */
  std::vector<double> breaks;
  /** The upper interpolant of d. */
  EdgeFunction d;
  /** Whether w_t = ũ_t - g_t on the face. */
  bool lifts_slip = false;

  double length() const {
    return line.length();
  }
  Point<2> point(const double t) const {
    return line.point(t * length());
  }
  /** Returns the direction m of contact or its tangent at a point of the face. */
  Tensor<1, 2> direction(Component component, double t) const;
  /** Returns d/dt of direction(), zero on segments and where contact acts along planes' normals. */
  Tensor<1, 2> turning(Component component, double t) const;
  /** Returns whether contact acts along several directions on the face. */
  bool mixes() const;
  /** Returns whether there is a d on the face. */
  bool is_contact() const {
    return !pressures.empty();
  }
  /** Returns whether contact is possible at t. */
  bool may_touch(const double t) const {
    return is_contact() && t >= pressures.front().from && t <= pressures.back().to;
  }
  /** Returns τ_n (component 0) or τ_t, zero where contact is not possible. */
  double traction_at(const unsigned int c, const double t) const {
    return may_touch(t) ? traction[c].value(t) : 0.;
  }
  /** Returns the part with t, or the nearest one. */
  const Pressed &part_at(double t) const;
  /** Returns the weights of v at the nodes in v(t). */
  std::vector<double> weights(double t) const;
  /** Returns whether p_H presses on a part of the face; presses_everywhere() whether on all of it.
   */
  bool presses() const;
  bool presses_everywhere() const;
  /** Returns a function of V^h on the face. */
  FaceVector trace(const Displacement &V) const;
  /** Returns a component of a vector field. */
  double value(const FaceVector &v, Component component, double t) const;
  /** Calls visit(t, weight) for Gauss points on each part of a function on the face, four for
   * bilinear elements; the weights are lengths. */
  void for_each_point(const EdgeFunction &function,
                      const std::function<void(double t, double weight)> &visit) const;
};

/** The condition w_n ≥ required at a contact node, for w in V^h with homogeneous essential
 * conditions; with friction also w_t = required at the nodes of faces where w takes the slip. */
struct NodeCondition {
  /** n, or t. */
  Tensor<1, 2> direction;
  Component component;
  Point<2> point;
  SidePoint at;
  /** The value d at the node, or, next to a face on which d is larger inside and nothing presses,
   * that value: where contact was missed, a w_h that is wide costs much less energy than a function
   * inside of the face. */
  double required;
  /** Whether a neighbouring face presses, or for w_t takes the slip. */
  bool presses = false;
  /** The column of w -> w.direction, condensed. It is empty where that vanishes for all such w,
   * because another side holds the node. In a pair it is that of w_n of both bodies; own is its
   * part on the carrier, or that on the other body where the carrier is held. */
  Coupling::Column column, own;
  /** Whether own is the part on the other body: its node alone gives way. */
  bool yields_across = false;

  bool held() const {
    return column.empty();
  }
  bool is_normal() const {
    return component == Component::normal;
  }
};

/** The penetration d = ũ_n - g on Γ_c, face by face, with ũ = u_h or π^{2h} u_h. It also holds
 * the conditions that a w in V^h with w_n ≥ d at contact nodes satisfies: one per contact node and
 * direction of the normal. A corner of two contact sides has two. With friction nodes of one normal
 * have a condition on w_t, too: there w_t = ũ_t - g_t on faces that stick. */
class ContactTrace {
public:
  /**
   * Samples d. The data must outlive the object.
   * @param tractions τ_n and τ_t in the order of ContactSurface::faces().
   * @throws InputError where g has no value.
   */
  explicit ContactTrace(const BoundData &data, const std::vector<FaceTractions> &tractions);

  const std::vector<PenetrationFace> &faces() const {
    return faces_;
  }
  const std::vector<NodeCondition> &conditions() const {
    return conditions_;
  }
  const ContactSurface<2> &surface() const {
    return data_.multipliers.surface();
  }
  /** Returns whether w_n and w_t can be given at all contact nodes at once, as far as other sides
   * do not hold them. */
  bool prescribes_all() const {
    return prescribes_all_;
  }
  /** Returns the degrees of freedom on the faces across from carriers. */
  std::set<types::global_dof_index> dofs_across() const;
  /** Returns the traces of a function of V^h on all faces. */
  std::vector<FaceVector> traces(const Displacement &V) const;
  /** Returns v_n or v_t at t, in a pair that of both bodies, from the traces of v. */
  double closing(const PenetrationFace &face, Component component, double t,
                 const std::vector<FaceVector> &v) const;
  /** Returns d itself at t, up to the evaluation of g, or ũ_t - g_t. */
  double misfit(const PenetrationFace &face, Component component, double t) const;
  /** Returns the bound of friction, zero where contact is not possible. */
  double tangential_bound(const PenetrationFace &face, double t) const;
  /** Returns the rounding of d = 0 on a face. */
  double rounding(const PenetrationFace &face) const;
  /** Returns an EdgeFunction that is not below d - w_n, or close to ũ_t - g_t - w_t. @param w the
   * traces of w. */
  EdgeFunction deficit(const PenetrationFace &face, Component component,
                       const std::vector<FaceVector> &w) const {
    return sample(face, component, w).function;
  }
  /** Returns ∫ τ_n d + τ_t (ũ_t - g_t) over Γ_c, by the same points. */
  double work_of_penetration() const;
  /** Returns whether contact acts along several directions on a face. */
  bool mixes() const {
    return std::any_of(faces_.begin(), faces_.end(),
                       [](const PenetrationFace &face) { return face.mixes(); });
  }
  /** Returns max (d)_+ over all samples; point_of_largest() returns its position. */
  double max_penetration() const {
    return max_;
  }
  /** Returns the place of a point of a face. */
  SidePoint side_point(const PenetrationFace &face, const double t) const {
    return {face.side, data_.scene.geometry.sides[face.side].arc_length(face.point(t))};
  }
  const SidePoint &point_of_largest() const {
    return point_of_largest_;
  }
  /** Returns a point where u_n - g > 0 and another side holds the body: no w of finite energy
   * removes that. */
  const std::optional<SidePoint> &obstacle() const {
    return obstacle_;
  }

private:
  void find_faces();
  PenetrationFace make_face(const ContactFace<2> &contact) const;
  void set_tractions(const std::vector<FaceTractions> &tractions);
  /** Returns whether friction holds the whole face, and a w with w_t = ũ_t - g_t costs less than
   * the work of friction: an energy of about μ A², A = max |ũ_t - g_t|, less than s A length. It
   * does not where g_t jumps. */
  bool wants_lift_of_slip(const PenetrationFace &face) const;
  void find_conditions();
  /** Returns the number of the condition on a component of w at a node of a face, a new one if it
   * is the first. */
  unsigned int condition_at(const PenetrationFace &face, std::size_t node, Component component,
                            std::vector<unsigned int> &known);
  void condense_columns();
  /** Returns misfit() where contact is possible. */
  double misfit_at(const PenetrationFace &face, Component component, double t) const;
  /** Returns the line along which data of contact on the face is given. */
  Curve line_of_data(const PenetrationFace &face) const;
  UpperInterpolant sample(const PenetrationFace &face, Component component,
                          const std::vector<FaceVector> &w) const;
  void sample();
  void require();

  const BoundData &data_;
  const double size_of_U_;
  std::vector<PenetrationFace> faces_;
  /** The traces of ũ. */
  std::vector<FaceVector> u_;
  std::vector<NodeCondition> conditions_;
  bool prescribes_all_ = true;
  double max_ = 0.;
  SidePoint point_of_largest_;
  std::optional<SidePoint> obstacle_;
};
} // namespace Signorini
