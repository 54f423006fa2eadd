// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact part of the bound: the part of w inside faces, and the sum.

#include <signorini/error_control/contact_term/contact_lift.h>
#include <signorini/error_control/contact_term/contact_trace.h>
#include <signorini/error_control/contact_term/nodal_lift.h>
#include <signorini/error_control/loads/cell_rule.h>
#include <signorini/error_control/stress/equilibrated_stress.h>

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
/** Computes r_F of one face from q and w_h. */
class Remainder
{
public:
  Remainder(const PenetrationFace &face, const Displacement &w_h)
    : face_(face)
    , presses_(face.presses_everywhere())
    , chord_{face.d.value(0.), face.d.value(1.)}
    , slack_{face.normal_value(w_h, 0.) - chord_[0], face.normal_value(w_h, 1.) - chord_[1]}
  {
  }

  EdgeFunction function() const
  {
    std::vector<EdgeFunction::Part> parts;
    for (const EdgeFunction::Part &q : face_.d.parts())
    {
      const EdgeFunction::Part b = minus(q, chord_), lack = minus(b, slack_);
      std::vector<double> breaks = {q.start, q.end};
      add_roots(lack, breaks);
      if (presses_)
        add_roots(b, breaks);
      std::sort(breaks.begin(), breaks.end());
      // b - e and b have the same zeros where e = 0; a part without length has no slope.
      const double shortest = 1e-9 * (q.end - q.start);
      breaks.erase(std::unique(breaks.begin(),
                               breaks.end() - 1,
                               [=](const double s, const double t) { return t - s < shortest; }),
                   breaks.end() - 1);
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        parts.push_back(on(b, lack, breaks[i], breaks[i + 1]));
    }
    // b = 0 there and e ≥ 0, up to rounding.
    parts.front().first = 0.;
    parts.back().last = 0.;
    return EdgeFunction(std::move(parts));
  }

private:
  using Ends = std::array<double, 2>;

  /** Returns a part minus the linear function with the given values at 0 and 1. */
  static EdgeFunction::Part minus(EdgeFunction::Part part, const Ends &ends)
  {
    part.first -= (1. - part.start) * ends[0] + part.start * ends[1];
    part.last -= (1. - part.end) * ends[0] + part.end * ends[1];
    return part;
  }
  /** Adds the zeros inside of a part, not too close to its ends. */
  static void add_roots(const EdgeFunction::Part &part, std::vector<double> &breaks)
  {
    // first + slope τ - 4 bulge τ², in the form that does not cancel.
    const double slope = part.last - part.first + 4. * part.bulge;
    const double square = slope * slope + 16. * part.bulge * part.first;
    if (square < 0.)
      return;
    const double sum = slope + std::copysign(std::sqrt(square), slope);
    for (const double tau : {sum / (8. * part.bulge), -2. * part.first / sum})
      if (tau > 1e-9 && tau < 1. - 1e-9)
        breaks.push_back(part.start + tau * (part.end - part.start));
  }
  /** Returns the remainder between two breaks: there it is one of b - e, b and 0. */
  EdgeFunction::Part on(const EdgeFunction::Part &b,
                        const EdgeFunction::Part &lack,
                        const double start,
                        const double end) const
  {
    const double length = (end - start) / (b.end - b.start);
    const double middle = 0.5 * (start + end);
    const double value = remainder(b.value(middle), lack.value(middle));
    EdgeFunction::Part part = {start,
                               end,
                               remainder(b.value(start), lack.value(start)),
                               remainder(b.value(end), lack.value(end)),
                               0.};
    if (value != 0.)
      part.bulge = b.bulge * length * length;
    return part;
  }
  double remainder(const double b, const double lack) const
  {
    return std::max(lack, presses_ ? std::min(b, 0.) : 0.);
  }

  const PenetrationFace &face_;
  bool presses_;
  Ends chord_, slack_;
};

std::string describe(const std::string &reason, const SidePlace &place, const Scene<2> &scene)
{
  const Side<2> &side = scene.geometry.sides[place.side];
  const Point<2> x = side.point(place.arc_length);
  std::ostringstream text;
  text << reason << ", on " << side.name() << " at (" << x[0] << ", " << x[1] << ")";
  return text.str();
}

/** Returns ∫_F τ_n (d - w_n). */
double contact_term(const ContactTrace &trace, const LiftField &lift, const unsigned int face)
{
  static const QGauss<1> gauss(4);
  const PenetrationFace &F = trace.faces()[face];
  double sum = 0.;
  // The parts are those of d and p_H, cut where w_n has kinks.
  for (const EdgeFunction::Part &part : lift.remainder(face).parts())
    for (unsigned int q = 0; q < gauss.size(); ++q)
    {
      const double t = part.start + (part.end - part.start) * gauss.point(q)[0];
      const double traction = F.traction(t);
      if (traction == 0.)
        continue;
      sum += traction * (trace.penetration(F, t) - lift.normal_value(face, t)) * F.length *
             (part.end - part.start) * gauss.weight(q);
    }
  return sum;
}
} // namespace

ContactLift::ContactLift(const DisplacementSpace<2> &space,
                         const Scene<2> &scene,
                         const MultiplierSpace<2> &multipliers,
                         const Displacement &U,
                         const Pressure &P,
                         const std::optional<DualData> &dual,
                         const std::vector<FaceField> &fields)
  : space_(space)
  , scene_(scene)
{
  if (space.element().degree > 1)
  {
    no_bound_ = "the displacement has a degree above one, and the bound is for bilinear elements";
    return;
  }
  trace_ = std::make_unique<const ContactTrace>(space, scene, multipliers, U, P, fields);
  if (trace_->obstacle())
  {
    no_bound_ = describe(trace_->obstacle()->first, trace_->obstacle()->second, scene);
    return;
  }
  consider(layer_lift(space, scene, *trace_), LiftMethod::layer);
  if (!dual || bound_->square() <= dual->enough)
    return;
  const auto consider_dual = [&](const dealii::Vector<double> &required, const LiftMethod method) {
    consider(dual_lift(space, *trace_, dual->condensed_D, dual->inverse, P, required), method);
  };
  consider_dual(required_values(*trace_), LiftMethod::dual);
  const auto raised = raised_values(*trace_);
  if (raised && bound_->square() > dual->enough)
    consider_dual(*raised, LiftMethod::raised_dual);
}

void ContactLift::consider(Displacement w_h, const LiftMethod method)
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
  bound.lift_energy = Utilities::MPI::sum(local, space_.mesh().communicator());
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
  Utilities::MPI::sum(local_parts, space_.mesh().communicator(), parts);
  for (unsigned int i = 0; i < parts.size(); ++i)
    parts[i] += bound.face_terms[i];
  if (parts.empty())
    return bound;
  const PenetrationFace &worst =
    trace_->faces()[std::max_element(parts.begin(), parts.end()) - parts.begin()];
  bound.dominant_part = {worst.side,
                         scene_.geometry.sides[worst.side].arc_length(worst.point(0.5))};
  return bound;
}

std::optional<double> norm_of_unit_lift(const DisplacementSpace<2> &space,
                                        const Scene<2> &scene,
                                        const ContactTrace &trace,
                                        const StiffnessInverse &inverse)
{
  const std::optional<Displacement> z = unit_normal_lift(space, trace, inverse);
  if (!z)
    return {};
  const LiftField lift(space, scene, trace, *z, std::vector<EdgeFunction>(trace.faces().size()));
  const dealii::Vector<double> energies = lift.cell_energies();
  const double local = std::accumulate(energies.begin(), energies.end(), 0.);
  return std::sqrt(Utilities::MPI::sum(local, space.mesh().communicator()));
}

// The part of the stress that the bound of π^{2h} u_h needs.

void EquilibratedStress::integrate_patches(const CellState &state, CellIntegrals &result) const
{
  const unsigned int cell = state.cell;
  const CellData &data = state.data;
  const PatchBubbles::Coefficients b = bubbles_->on(cell);
  const bool holds_back = bubbles_->holds_back(cell);
  CompositeCell::Stresses dual{};
  std::unique_ptr<const BubbleForm> own;
  const BubbleForm *form = forms_->of(cell);
  if (form == nullptr && !lift_.cells()[cell] && table_.constant_law() && data.shape.affine)
  {
    own = std::make_unique<const BubbleForm>(data.shape, state.laws[0]);
    form = own.get();
  }
  if (form != nullptr)
  {
    const CellMisfit misfit = {state.u, stresses(cell, data), load(cell).slope};
    result.squares.interpolated_part =
      std::max(0., result.squares.misfit + form->change(b, misfit));
    // There u_D - u_h = 0, and z is what is held back.
    result.squares.interpolated_lift =
      holds_back ? form->change(bubbles_->held_back(cell), CellMisfit{}) : 0.;
    dual = form->dual(b);
  }
  else
  {
    UpperSum square(state.from_above), energy(state.from_above);
    for (std::size_t i = 0; i < data.points.size(); ++i)
    {
      const StressPoint &point = data.points[i];
      const Law &law = law_at(state.laws, i);
      const BubbleGradients gradients = bubble_gradients(point);
      const Components bubble_data = strain_of(gradients, b);
      const Components e = sum(strain(cell, point, state.u), bubble_data);
      const Components s = difference(law.stress(e), state.tau[i]);
      square.add(point, contraction(s, law.strain(s)));
      add_dual(point, bubble_data, dual);
      if (!holds_back)
        continue;
      // u_D - π^{2h} u_h = (u_D - u_h) - b.
      const Components z =
        difference(lift_.strain(cell, point), strain_of(gradients, bubbles_->held_back(cell)));
      energy.add(point, contraction(z, law.stress(z)));
    }
    result.squares.interpolated_part = square.value();
    result.squares.interpolated_lift = holds_back ? energy.value() : result.squares.lift;
  }
  const CellMoments bubble_data = data.composite.transposed(dual);
  for (unsigned int j = 0; j < bubble_data.size(); ++j)
    result.interpolated_part[j] = result.misfit_data[j] + bubble_data[j];
}

double EquilibratedStress::normal_bubble(const unsigned int contact_face) const
{
  const auto &face = data_.multipliers.surface().faces()[contact_face];
  const unsigned int edge = mesh_.edge_of_line(face.cell->face(face.face_no)->index());
  return bubbles_->on_edge(edge) * mesh_.edges()[edge].normal;
}

std::vector<std::optional<std::array<double, 2>>> EquilibratedStress::free_tractions() const
{
  const auto &faces = data_.multipliers.surface().faces();
  std::vector<std::optional<std::array<double, 2>>> tractions(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const auto line = faces[i].cell->face(faces[i].face_no);
    const unsigned int number = mesh_.edge_of_line(line->index());
    const Edge &edge = mesh_.edges()[number];
    if (edge.freedom != EdgeFreedom::normal)
      continue;
    tractions[i] = normal_tractions(edge, number, moments_);
    if (edge.vertices[0] != line->vertex_index(0))
      std::swap((*tractions[i])[0], (*tractions[i])[1]);
  }
  return tractions;
}
} // namespace Signorini
