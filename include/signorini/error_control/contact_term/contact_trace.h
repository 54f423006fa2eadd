// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/error_control/loads/edge_function.h>
#include <signorini/error_control/loads/edge_mesh.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
/** A place on the boundary. */
struct SidePlace
{
  /** The number of the side in the geometry. */
  unsigned int side = 0;
  /** The arc length from the start of the side (length). */
  double arc_length = 0.;
};

/** The fields ũ and τ on a contact face, as far as they differ from u_h and p_H. */
struct FaceField
{
  /** The coefficient in ũ_n = u_{h,n} + 4 t (1 - t) bubble. */
  double bubble = 0.;
  /** The traction τ_n at vertex 0 and vertex 1, linear between them. If it is empty, τ_n = p_H.
   */
  std::optional<std::array<double, 2>> traction;
};

/** A contact face with d = ũ_n - g on it, as a function of t in [0,1] from vertex 0 to vertex 1 of
 * the face. */
struct PenetrationFace
{
  using Dofs = std::array<types::global_dof_index, 2>;

  /** The number of the face in the surface. */
  unsigned int number;
  unsigned int side;
  Point<2> start, end;
  /** The outward unit normal. */
  Tensor<1, 2> normal;
  double length;
  /** The vector from the middle of the chord to that of the face. It is zero unless the face is
   * curved. */
  Tensor<1, 2> bulge;
  /** The degrees of freedom of both ends. */
  std::array<Dofs, 2> dofs;
  /** The numbers of the conditions at both ends, see ContactTrace::conditions(). */
  std::array<unsigned int, 2> conditions;
  /** An interval on which p_H is constant, and whether p is below pressing_threshold(). The
   * intervals are sorted. */
  struct Pressed
  {
    double from, to, p;
    bool presses;
  };
  std::vector<Pressed> pressures;
  FaceField field;
  /** The upper interpolant of d. */
  EdgeFunction d;

  Point<2> point(const double t) const
  {
    return start + t * (end - start) + 4. * t * (1. - t) * bulge;
  }
  /** pressure() returns p_H at t, traction() τ_n. */
  double pressure(double t) const;
  double traction(const double t) const
  {
    return field.traction ? (1. - t) * (*field.traction)[0] + t * (*field.traction)[1]
                          : pressure(t);
  }
  /** Returns whether p_H presses on a part of the face; presses_everywhere() whether on all parts.
   */
  bool presses() const;
  bool presses_everywhere() const;
  /** Returns the component of a function of V^h at t. */
  double component(const Displacement &V, double t, const Tensor<1, 2> &direction) const;
  /** Returns v_n at t, with the normal of the face. */
  double normal_value(const Displacement &V, const double t) const
  {
    return component(V, t, normal);
  }
};

/** The condition w_n ≥ required at a contact node, for w in V^h with homogeneous essential
 * conditions. */
struct NodeCondition
{
  Tensor<1, 2> normal;
  SidePlace place;
  double required;
  /** Whether a neighbouring face presses. */
  bool presses = false;
  /** Whether w_n = 0 there for all such w, because another side holds the node. */
  bool held = false;
};

/** The penetration d = ũ_n - g on Γ_c, face by face, with ũ = u_h or π^{2h} u_h. It also holds
 * the conditions that a w in V^h with w_n ≥ d at contact nodes satisfies: one per contact node and
 * direction of the normal. A corner of two contact sides has two. */
class ContactTrace
{
public:
  /**
   * Samples d. All arguments but @p fields must outlive the object.
   * @param fields in the order of ContactSurface::faces(); empty for u_h and p_H.
   * @throws InputError where g has no value.
   */
  ContactTrace(const DisplacementSpace<2> &space,
               const Scene<2> &scene,
               const MultiplierSpace<2> &multipliers,
               const Displacement &U,
               const Pressure &P,
               const std::vector<FaceField> &fields = {});

  const std::vector<PenetrationFace> &faces() const
  {
    return faces_;
  }
  const std::vector<NodeCondition> &conditions() const
  {
    return conditions_;
  }
  /** Returns the columns of w -> w_n for all conditions, condensed. They are empty where a node is
   * held. */
  const Coupling &normals() const
  {
    return normals_;
  }
  const ContactSurface<2> &surface() const
  {
    return multipliers_.surface();
  }
  /** Returns d itself at t, up to the evaluation of g. */
  double penetration(const PenetrationFace &face, double t) const;
  /** The integrals of τ_n - p_H, of (τ_n - p_H) n and of (τ_n - p_H)(g - c_n) over Γ_c,
   * with four Gauss points on every part of d. */
  struct TractionChange
  {
    double normal_force = 0.;
    Tensor<1, 2> force;
    double work_of_gap = 0.;
  };
  /**
   * Returns these integrals.
   * @param c a translation.
   */
  TractionChange traction_change(const Tensor<1, 2> &c) const;
  /** Returns ∫ τ_n d over Γ_c, by the same points. */
  double work_of_penetration() const;
  /** Returns max (d)_+ over all samples; place_of_largest() returns its place. */
  double max_penetration() const
  {
    return max_;
  }
  const SidePlace &place_of_largest() const
  {
    return place_of_largest_;
  }
  /** Returns the reason why there is no w of finite energy, and the place; none if there is such a
   * w. */
  const std::optional<std::pair<std::string, SidePlace>> &obstacle() const
  {
    return obstacle_;
  }

private:
  void find_faces(const Pressure &P, const std::vector<FaceField> &fields);
  void find_conditions();
  using ConditionsOfVertices = std::map<unsigned int, std::vector<unsigned int>>;
  /** Returns the number of the condition at one end of a face, and makes it if it is new. */
  unsigned int condition_at(const PenetrationFace &face,
                            unsigned int end,
                            ConditionsOfVertices &known);
  void sample();
  void find_obstacle();

  const DisplacementSpace<2> &space_;
  const Scene<2> &scene_;
  const MultiplierSpace<2> &multipliers_;
  const Displacement &U_;
  std::vector<PenetrationFace> faces_;
  std::vector<NodeCondition> conditions_;
  Coupling normals_;
  double max_ = 0.;
  SidePlace place_of_largest_;
  std::optional<std::pair<std::string, SidePlace>> obstacle_;
};

/** Returns the contact edges on which p_H presses everywhere: all pieces face ∩ patch are below
 * pressing_threshold(). */
std::vector<unsigned int> pressing_edges(const EdgeMesh &mesh,
                                         const MultiplierSpace<2> &multipliers,
                                         const Pressure &P);

/** Returns τ_n at both ends of an edge, in the order of Edge::vertices (force/area). */
std::array<double, 2> normal_tractions(const Edge &edge,
                                       unsigned int number,
                                       const std::vector<double> &moments);

/** Returns whether τ_n pulls at an end of the edge. */
inline bool pulls(const std::array<double, 2> &tractions)
{
  return tractions[0] > 0. || tractions[1] > 0.;
}
} // namespace Signorini
