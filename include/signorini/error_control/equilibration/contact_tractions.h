// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/tractions.h>

#include <map>
#include <set>
#include <vector>

namespace Signorini {
/**
 * The conditions on the tractions of contact edges, τ_n ≤ 0 and with friction |τ_t| ≤ s.
 *
 * On edges that press everywhere τ_n is unknown. Where the result is positive (a coefficient of
 * Bernstein is), and on all other contact edges, τ_n is p_H, with positive coefficients of
 * Bernstein set to zero. With friction τ_t is unknown on edges that stick everywhere. Elsewhere,
 * and where the result exceeds a polynomial s_E ≤ s, it is q_H, with coefficients of Bernstein
 * between those of -s_E and s_E; on edges that slip it is -s_E or s_E. With Coulomb's law, s =
 * f |τ_n|, τ_n is known everywhere.
 */
class ContactTractions {
public:
  /** Sets the tractions of contact edges. The arguments must outlive the object. */
  ContactTractions(const BoundData &data, Tractions &tractions);

  /** Returns the numbers of the edges by face of the contact surface; none on sides that do not
   * carry the traction. */
  const std::vector<unsigned int> &edges() const {
    return edges_;
  }
  /** Returns the edges on which s_E is far below s. */
  const std::set<unsigned int> &unresolved() const {
    return unresolved_;
  }
  /** Fixes the free edges whose traction pulls, or exceeds the bound of friction. @return whether
   * there were any. */
  bool fix_pulling_edges();

private:
  /** Returns for each contact edge whether a component of u follows the partner on all patches on
   * it and on its neighbours on the same side: next to others the best traction would leave the
   * admissible ones. @param states of the patches. */
  std::map<unsigned int, bool> edges_inside(const std::vector<NodeState> &states,
                                            Component component) const;
  void give_tangential_part(const std::vector<NodeState> &of_patches);
  /** Returns the coefficients of Legendre's polynomials of p_H (component 0) or q_H on an edge. */
  std::vector<double> projection_of(unsigned int edge, unsigned int component) const;
  /** Sets τ_n of an edge to p_H, without positive coefficients of Bernstein. */
  void press_by_multipliers(unsigned int edge);
  /** Sets τ_t to q_H, between the bounds of friction; where the edge slips, to one of them. */
  void rub_by_multipliers(unsigned int edge);
  /** Returns the bound of friction at the position @p s. */
  double tangential_bound(unsigned int edge, double s) const;
  /** Returns the coefficients of Bernstein of a polynomial that is close to this, and not above it
   * at samples. Notes the edge where it is far below. */
  std::vector<double> lower_tangential_bound(unsigned int edge);
  bool is_admissible(unsigned int edge, unsigned int component) const;

  const BoundData &data_;
  Tractions &tractions_;
  std::vector<unsigned int> edges_;
  /** The pieces of Γ_c with the numbers of their edges. */
  struct PieceOfEdge {
    const Piece<2> &piece;
    unsigned int edge;
  };
  std::vector<PieceOfEdge> pieces_;
  /** With friction, by edge: how its patches slip, and the coefficients of Bernstein of s_E. */
  std::map<unsigned int, State> slips_;
  std::map<unsigned int, std::vector<double>> bounds_;
  std::set<unsigned int> unresolved_;
};
} // namespace Signorini
