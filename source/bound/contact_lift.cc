// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact part of the bound: what w_h lacks inside faces, and the sum.

#include <signorini/bound/contact_lift.h>
#include <signorini/bound/nodal_lift.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace Signorini
{
namespace
{
/** What is known of r_F on one part: b - e and b as polynomials of degree two. */
class Remainder
{
public:
  Remainder(const PenetrationFace &face, const NodalVector &w_h)
    : face_(face)
    , chord_{face.d.value(0.), face.d.value(1.)}
    , slack_{face.normal_value(w_h, 0.) - chord_[0], face.normal_value(w_h, 1.) - chord_[1]}
  {
  }

  EdgeFunction function() const
  {
    std::vector<EdgeFunction::Part> parts = face_.d.parts();
    const std::vector<EdgeFunction::Part> d = parts;
    std::vector<double> values(d.size() + 1, 0.);
    // Zero at both ends of the face; at a break the larger value of both sides.
    for (std::size_t i = 1; i < d.size(); ++i)
      values[i] = std::max(value_at(d[i].start, d[i].first, presses(d[i - 1])),
                           value_at(d[i].start, d[i].first, presses(d[i])));
    for (std::size_t i = 0; i < d.size(); ++i)
    {
      parts[i].first = values[i];
      parts[i].last = values[i + 1];
      if (!presses(d[i]))
        parts[i].bulge = is_open(d[i]) ? 0. : std::max(0., d[i].bulge);
    }
    return EdgeFunction(std::move(parts));
  }

private:
  bool presses(const EdgeFunction::Part &part) const
  {
    return face_.pressure(0.5 * (part.start + part.end)) < 0.;
  }
  double chord(const double t) const
  {
    return (1. - t) * chord_[0] + t * chord_[1];
  }
  double slack(const double t) const
  {
    return (1. - t) * slack_[0] + t * slack_[1];
  }
  double value_at(const double t, const double d, const bool pressing) const
  {
    const double b = d - chord(t);
    return std::max(b - slack(t), pressing ? std::min(b, 0.) : 0.);
  }
  /** Whether b - e <= 0 on all of the part: the largest value of a parabola. */
  bool is_open(const EdgeFunction::Part &part) const
  {
    const double first = part.first - chord(part.start) - slack(part.start);
    const double last = part.last - chord(part.end) - slack(part.end);
    const double c = part.bulge;
    double largest = std::max(first, last);
    // The derivative last - first + 4 c (1 - 2 tau) vanishes at tau.
    if (c > 0. && std::abs(last - first) < 4. * c)
    {
      const double tau = 0.5 + (last - first) / (8. * c);
      largest = (1. - tau) * first + tau * last + 4. * c * tau * (1. - tau);
    }
    return largest <= 0.;
  }

  const PenetrationFace &face_;
  std::array<double, 2> chord_, slack_;
};

std::string describe(const std::string &reason, const SidePlace &place, const Scene<2> &scene)
{
  const Side<2> &side = scene.geometry.sides[place.side];
  std::ostringstream text;
  text << reason << ": side " << side.name() << ", arc length " << place.arc_length << ", ("
       << side.point(place.arc_length) << ").";
  return text.str();
}

/** int_F p_H (d - w_n). */
double contact_term(const ContactTrace &trace, const LiftField &lift, const unsigned int face)
{
  static const dealii::QGauss<1> gauss(4);
  const PenetrationFace &F = trace.faces()[face];
  double sum = 0.;
  for (const EdgeFunction::Part &part : F.d.parts())
  {
    const double p = F.pressure(0.5 * (part.start + part.end));
    if (p == 0.)
      continue;
    for (unsigned int q = 0; q < gauss.size(); ++q)
    {
      const double t = part.start + (part.end - part.start) * gauss.point(q)[0];
      sum += p * (trace.penetration(F, t) - lift.normal_value(face, t)) * F.length *
             (part.end - part.start) * gauss.weight(q);
    }
  }
  return sum;
}
} // namespace

ContactLift::ContactLift(const DisplacementSpace<2> &space,
                         const Scene<2> &scene,
                         const MultiplierSpace<2> &multipliers,
                         const NodalVector &U,
                         const dealii::Vector<double> &P,
                         const std::optional<DualData> &dual)
  : space_(space)
  , scene_(scene)
{
  if (space.mesh().is_curved())
  {
    no_bound_ = "the body has curved sides, and the bound is for straight ones.";
    return;
  }
  trace_ = std::make_unique<const ContactTrace>(space, scene, multipliers, U, P);
  if (trace_->obstacle())
  {
    no_bound_ = describe(trace_->obstacle()->first, trace_->obstacle()->second, scene);
    return;
  }
  consider(layer_lift(space, scene, *trace_), LiftMethod::layer);
  if (dual && bound_->square() > 0.)
    consider(dual_lift(space, *trace_, dual->condensed_D, dual->inverse, P), LiftMethod::dual);
}

void ContactLift::consider(NodalVector w_h, const LiftMethod method)
{
  std::vector<EdgeFunction> remainders;
  for (const PenetrationFace &face : trace_->faces())
    remainders.push_back(Remainder(face, w_h).function());
  auto lift = std::make_unique<const LiftField>(
    space_, scene_, *trace_, std::move(w_h), std::move(remainders));
  ContactBound bound = evaluate(*lift, method);
  if (bound_ && bound_->square() <= bound.square())
    return;
  lift_ = std::move(lift);
  bound_ = std::move(bound);
}

ContactBound ContactLift::evaluate(const LiftField &lift, const LiftMethod method) const
{
  ContactBound bound;
  bound.method = method;
  bound.cell_energies = lift.cell_energies();
  const double local = std::accumulate(bound.cell_energies.begin(), bound.cell_energies.end(), 0.);
  bound.lift_energy = dealii::Utilities::MPI::sum(local, space_.mesh().communicator());
  std::vector<double> local_parts, parts;
  for (unsigned int i = 0; i < trace_->faces().size(); ++i)
  {
    const double term = contact_term(*trace_, lift, i);
    bound.contact_term += term;
    bound.face_terms.push_back(2. * term);
    const auto cell = trace_->surface().faces()[trace_->faces()[i].number].cell;
    local_parts.push_back(bound.cell_energies[cell->active_cell_index()]);
  }
  parts.resize(local_parts.size());
  dealii::Utilities::MPI::sum(local_parts, space_.mesh().communicator(), parts);
  for (unsigned int i = 0; i < parts.size(); ++i)
    parts[i] += bound.face_terms[i];
  const PenetrationFace &worst =
    trace_->faces()[std::max_element(parts.begin(), parts.end()) - parts.begin()];
  bound.largest_part = {worst.side,
                        scene_.geometry.sides[worst.side].arc_length(worst.point(0.5))};
  return bound;
}

std::optional<double> norm_of_unit_lift(const DisplacementSpace<2> &space,
                                        const Scene<2> &scene,
                                        const ContactTrace &trace,
                                        const StiffnessInverse &inverse)
{
  const std::optional<NodalVector> z = lift_of_one(space, scene, trace, inverse);
  if (!z)
    return {};
  const LiftField lift(
    space, scene, trace, *z, std::vector<EdgeFunction>(trace.faces().size()));
  const dealii::Vector<double> energies = lift.cell_energies();
  const double local = std::accumulate(energies.begin(), energies.end(), 0.);
  return std::sqrt(dealii::Utilities::MPI::sum(local, space.mesh().communicator()));
}
} // namespace Signorini
