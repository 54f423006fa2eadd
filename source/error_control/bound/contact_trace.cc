// SPDX-License-Identifier: LGPL-2.1-or-later
// The penetration of u_h or π^{2h} u_h along Γ_c, and the contact nodes.

#include <signorini/discretization/space/paired_piece.h>
#include <signorini/error_control/bound/contact_trace.h>
#include <signorini/error_control/equilibration/cell_shape.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace Signorini {
std::string name_of(const SidePoint &at, const Scene<2> &scene) {
  const Side<2> &side = scene.geometry.sides[at.side];
  const Point<2> x = side.point(at.arc_length);
  std::ostringstream name;
  name << side.name() << " at (" << x[0] << ", " << x[1] << ")";
  return name.str();
}

bool PenetrationFace::presses() const {
  return std::any_of(pressures.begin(), pressures.end(),
                     [](const Pressed &part) { return part.state.presses; });
}

bool PenetrationFace::presses_everywhere() const {
  constexpr double rounding = 1e-9;
  return may_touch(rounding) && may_touch(1. - rounding) &&
         std::all_of(pressures.begin(), pressures.end(),
                     [](const Pressed &part) { return part.state.presses; });
}

const PenetrationFace::Pressed &PenetrationFace::part_at(const double t) const {
  return *std::find_if(pressures.begin(), pressures.end() - 1,
                       [t](const Pressed &part) { return t <= part.to; });
}

double PenetrationFace::Pressed::on_other(const double t) const {
  return other->lower +
         std::clamp((t - from) / (to - from), 0., 1.) * (other->upper - other->lower);
}

std::vector<double> PenetrationFace::weights(const double t) const {
  std::vector<double> weights = {1. - t, t};
  for (std::size_t i = 2; i < nodes.size(); ++i) {
    const double bubble = basis[i - 2].value(t) * t * (1. - t) / (nodes[i] * (1. - nodes[i]));
    weights.push_back(bubble);
    weights[0] -= (1. - nodes[i]) * bubble;
    weights[1] -= nodes[i] * bubble;
  }
  return weights;
}

bool PenetrationFace::mixes() const {
  return std::any_of(pressures.begin(), pressures.end(), [this](const Pressed &part) {
    return part.direction != pressures.front().direction;
  });
}

Tensor<1, 2> PenetrationFace::direction(const Component component, const double t) const {
  if (is_contact())
    if (const auto &m = part_at(t).direction)
      return direction_of(component, *m);
  if (line.is_flat())
    return direction_of(component, normal);
  const Tensor<1, 2> n = line.normal(t * length());
  return direction_of(component, n * normal > 0. ? n : -1. * n);
}

Tensor<1, 2> PenetrationFace::turning(const Component component, const double t) const {
  if (line.is_flat() || (is_contact() && part_at(t).direction))
    return {};
  // x turns about the centre like n and t.
  const Tensor<1, 2> from_centre = point(t) - line.centre_of_circle();
  const double turn = cross(from_centre, line.tangent(t * length(), 0.)) / line.radius();
  return -turn * length() / line.radius() * cross_product_2d(direction(component, t));
}

FaceVector PenetrationFace::trace(const Displacement &V) const {
  FaceVector sum;
  for (unsigned int d = 0; d < 2; ++d) {
    sum[d].first = V[dofs[0][d]];
    sum[d].last = V[dofs[1][d]];
    for (std::size_t i = 2; i < dofs.size(); ++i) {
      Polynomial at_node = basis[i - 2];
      const double t = nodes[i];
      at_node *= (V[dofs[i][d]] - (1. - t) * sum[d].first - t * sum[d].last) / (t * (1. - t));
      sum[d].inner += at_node;
    }
  }
  return sum;
}

double PenetrationFace::value(const FaceVector &v, const Component component,
                              const double t) const {
  const Tensor<1, 2> along = direction(component, t);
  return along[0] * v[0].value(t) + along[1] * v[1].value(t);
}

void PenetrationFace::for_each_point(const EdgeFunction &function,
                                     const std::function<void(double, double)> &visit) const {
  static const QGauss<1> few(4), many(12);
  const QGauss<1> &gauss = nodes.size() > 2 ? many : few;
  for (const EdgeFunction::Part &part : function.parts())
    for (unsigned int q = 0; q < gauss.size(); ++q) {
      const double share = part.end - part.start;
      visit(part.start + share * gauss.point(q)[0], length() * share * gauss.weight(q));
    }
}

ContactTrace::ContactTrace(const BoundData &data, const std::vector<FaceTractions> &tractions)
  : data_(data)
  , size_of_U_(data.U.linfty_norm()) {
  find_faces();
  set_tractions(tractions);
  find_conditions();
  sample();
  require();
}

PenetrationFace ContactTrace::make_face(const ContactFace<2> &contact) const {
  const auto cell = data_.space.dof_cell(contact.cell);
  const auto line = cell->face(contact.face_no);
  const Side<2> &side = data_.scene.geometry.sides[contact.side];
  PenetrationFace face(contact.side, side.between(line->vertex(0), line->vertex(1)));
  face.normal = side.normal(side.arc_length(face.point(0.5)));
  constexpr double beside = 1e-9;
  const ContactDirections<2> directions = directions_on(data_.scene, contact.side);
  const auto is_corner = [&](const Point<2> &x) {
    const double s = side.arc_length(x), near = beside * side.length();
    return side.has_corner(s) || directions.change_between(s - near, s + near);
  };
  face.inside = {
    {is_corner(face.line.start()) ? beside : 0., is_corner(face.line.end()) ? 1. - beside : 1.}};

  const FiniteElement<2> &element = data_.space.element(contact.cell),
                         &base = element.base_element(0);
  const std::vector<types::global_dof_index> dofs = data_.space.cell_dofs(contact.cell);
  const std::vector<Point<1>> &nodes = base.get_unit_face_support_points();
  face.basis = Polynomials::generate_complete_Lagrange_basis(
    std::vector<Point<1>>(nodes.begin() + 2, nodes.end()));
  for (unsigned int i = 0; i < nodes.size(); ++i) {
    const unsigned int node = base.face_to_cell_index(i, contact.face_no);
    face.nodes.push_back(nodes[i][0]);
    face.dofs.push_back({{dofs[element.component_to_system_index(0, node)],
                          dofs[element.component_to_system_index(1, node)]}});
  }
  return face;
}

void ContactTrace::set_tractions(const std::vector<FaceTractions> &tractions) {
  u_ = traces(data_.U);
  for (std::size_t i = 0; i < faces_.size(); ++i)
    faces_[i].traction = tractions[i];
  for (PenetrationFace &face : faces_)
    face.lifts_slip = data_.has_tangential_part() && face.is_contact() && wants_lift_of_slip(face);
}

void ContactTrace::find_faces() {
  for (const ContactFace<2> &face : surface().faces())
    faces_.push_back(make_face(face));
  const std::vector<NodeState> states = patch_states(data_.multipliers, data_.P);
  for (const Piece<2> &piece : surface().pieces()) {
    auto [own, other] = seen_from_carrier(surface(), piece);
    if (own.lower > own.upper) {
      std::swap(own.lower, own.upper);
      if (other)
        std::swap(other->lower, other->upper);
    }
    faces_[own.face].pressures.push_back(
      {own.lower, own.upper, states[piece.patch], other,
       surface().condition(piece).directions.at(0.5 * (piece.lower[0] + piece.upper[0]))});
  }
  for (PenetrationFace &face : faces_)
    std::sort(face.pressures.begin(), face.pressures.end(),
              [](const auto &a, const auto &b) { return a.from < b.from; });
}

std::set<types::global_dof_index> ContactTrace::dofs_across() const {
  std::set<types::global_dof_index> dofs;
  for (const PenetrationFace &face : faces_)
    for (const PenetrationFace::Pressed &part : face.pressures)
      if (part.other)
        for (const PenetrationFace::Dofs &of_node : faces_[part.other->face].dofs)
          dofs.insert(of_node.begin(), of_node.end());
  return dofs;
}

std::vector<FaceVector> ContactTrace::traces(const Displacement &V) const {
  std::vector<FaceVector> traces;
  traces.reserve(faces_.size());
  for (const PenetrationFace &face : faces_)
    traces.push_back(face.trace(V));
  return traces;
}

double ContactTrace::closing(const PenetrationFace &face, const Component component, const double t,
                             const std::vector<FaceVector> &v) const {
  const PenetrationFace::Pressed &part = face.part_at(t);
  const double own = face.value(v[&face - faces_.data()], component, t);
  if (!part.other)
    return own;
  const FaceVector &of_other = v[part.other->face];
  const double on_other = part.on_other(t);
  return own - face.direction(component, t) *
                 Tensor<1, 2>({of_other[0].value(on_other), of_other[1].value(on_other)});
}

bool ContactTrace::wants_lift_of_slip(const PenetrationFace &face) const {
  if (std::any_of(face.pressures.begin(), face.pressures.end(),
                  [](const auto &part) { return !follows(part.state, Component::tangential); }))
    return false;
  constexpr unsigned int n_samples = 8;
  double largest = 0., bound = 0.;
  for (unsigned int i = 0; i <= n_samples; ++i) {
    const double t = static_cast<double>(i) / n_samples;
    largest = std::max(largest, std::abs(misfit(face, Component::tangential, t)));
    bound = std::max(bound, tangential_bound(face, t));
  }
  const auto shear =
    symmetrize(outer_product(face.normal, face.direction(Component::tangential, 0.5)));
  return shear * (data_.scene.material->hooke(face.point(0.5)) * shear) * largest <=
         bound * face.length();
}

unsigned int ContactTrace::condition_at(const PenetrationFace &face, const std::size_t node,
                                        const Component component,
                                        std::vector<unsigned int> &known) {
  const Tensor<1, 2> direction = face.direction(component, face.nodes[node]);
  for (const unsigned int k : known)
    if (conditions_[k].component == component &&
        (conditions_[k].direction - direction).norm() < 1e-10)
      return k;
  known.push_back(conditions_.size());
  const double t = face.nodes[node], least = component == Component::normal
                                               ? -std::numeric_limits<double>::infinity()
                                               : 0.;
  conditions_.push_back(
    {direction, component, face.point(t), side_point(face, t), least, false, {}, {}});
  NodeCondition &condition = conditions_.back();
  const auto add = [&](Coupling::Column &column, const PenetrationFace::Dofs &dofs,
                       const double weight) {
    for (unsigned int d = 0; d < 2; ++d)
      if (std::abs(weight * direction[d]) > 1e-15)
        column[dofs[d]] += weight * direction[d];
  };
  add(condition.own, face.dofs[node], 1.);
  condition.column = condition.own;
  if (const PenetrationFace::Pressed &part = face.part_at(face.nodes[node]); part.other) {
    const PenetrationFace &other = faces_[part.other->face];
    const std::vector<double> weights = other.weights(part.on_other(face.nodes[node]));
    for (std::size_t i = 0; i < weights.size(); ++i)
      add(condition.column, other.dofs[i], -weights[i]);
  }
  return known.back();
}

namespace {
bool are_parallel(const Coupling::Column &a, const Coupling::Column &b) {
  double aa = 0., ab = 0., bb = 0.;
  for (const auto &[row, factor] : a) {
    const auto found = b.find(row);
    aa += factor * factor;
    ab += found == b.end() ? 0. : factor * found->second;
  }
  for (const auto &entry : b)
    bb += entry.second * entry.second;
  return ab * ab > (1. - 1e-6) * aa * bb;
}
} // namespace

void ContactTrace::find_conditions() {
  std::map<types::global_dof_index, std::vector<unsigned int>> normals, tangents;
  for (PenetrationFace &face : faces_)
    for (std::size_t i = 0; i < face.dofs.size() && face.is_contact(); ++i) {
      const unsigned int k = condition_at(face, i, Component::normal, normals[face.dofs[i][0]]);
      face.conditions.push_back(k);
      conditions_[k].presses = conditions_[k].presses || face.presses();
    }
  for (const PenetrationFace &face : faces_)
    for (std::size_t i = 0;
         i < face.dofs.size() && data_.has_tangential_part() && face.is_contact(); ++i) {
      // Two normals say all about w.
      if (normals[face.dofs[i][0]].size() > 1) {
        prescribes_all_ = false;
        continue;
      }
      NodeCondition &condition =
        conditions_[condition_at(face, i, Component::tangential, tangents[face.dofs[i][0]])];
      if (face.lifts_slip) {
        condition.presses = true;
        condition.required = misfit(face, Component::tangential, face.nodes[i]);
      }
    }
  condense_columns();
  for (const auto &[dof, numbers] : tangents) {
    // A node that another side lets move along one line only has one condition.
    NodeCondition &tangent = conditions_[numbers.front()];
    const Coupling::Column &normal = conditions_[normals.at(dof).front()].column;
    if (!tangent.held() && are_parallel(tangent.column, normal)) {
      prescribes_all_ = false;
      tangent.column.clear();
      tangent.own.clear();
    }
  }
}

void ContactTrace::condense_columns() {
  for (Coupling::Column NodeCondition::*const part :
       {&NodeCondition::own, &NodeCondition::column}) {
    std::vector<Coupling::Column> columns;
    for (NodeCondition &condition : conditions_)
      columns.push_back(std::exchange(condition.*part, {}));
    const Coupling condensed =
      condense(Coupling(std::move(columns)), data_.space.constraints_without_pins());
    for (std::size_t k = 0; k < conditions_.size(); ++k) {
      double square = 0.;
      for (const auto &entry : condensed.column(k))
        square += entry.second * entry.second;
      if (square > 1e-20)
        conditions_[k].*part = condensed.column(k);
    }
  }
  for (NodeCondition &condition : conditions_)
    if (condition.own.empty() && !condition.held()) {
      condition.own = condition.column;
      condition.yields_across = true;
    }
}

double ContactTrace::misfit(const PenetrationFace &face, const Component component,
                            const double t) const {
  const double from = face.pressures.front().from, to = face.pressures.back().to,
               value = misfit_at(face, component, std::clamp(t, from, to));
  // Beyond the other side nothing is asked of w: d goes on as a constant, or where a support holds
  // the next node it falls to zero.
  if (face.may_touch(t) || value <= 0. || face.conditions.empty() ||
      !conditions_[face.conditions[t < from ? 0 : 1]].held())
    return value;
  return value * (t < from ? t / from : (1. - t) / (1. - to));
}

double ContactTrace::misfit_at(const PenetrationFace &face, const Component component,
                               const double t) const {
  const ContactPair<2> pair = pair_with(data_.scene, face.side);
  const double u = closing(face, component, t, u_);
  const auto at = [&](const double s) {
    return point_of_data(data_.scene, face.side, face.point(s));
  };
  if (component == Component::normal)
    return u - pair.gap(at(std::clamp(t, face.inside[0], face.inside[1])));
  return u - pair.shift(at(t));
}

double ContactTrace::tangential_bound(const PenetrationFace &face, const double t) const {
  if (!face.may_touch(t))
    return 0.;
  return tangential_bound_at(data_.scene, face.side, face.point(t), face.traction[0].value(t));
}

double ContactTrace::rounding(const PenetrationFace &face) const {
  return 1e-14 * (2. * size_of_U_ + std::abs(misfit(face, Component::normal, 0.)));
}

double ContactTrace::work_of_penetration() const {
  double work = 0.;
  for (const PenetrationFace &face : faces_)
    face.for_each_point(face.d, [&](const double t, const double weight) {
      for (unsigned int c = 0; c < 2; ++c)
        if (const double traction = face.traction_at(c, t); traction != 0.)
          work += traction * misfit(face, contact_components[c], t) * weight;
    });
  return work;
}

UpperInterpolant ContactTrace::sample(const PenetrationFace &face, const Component component,
                                      const std::vector<FaceVector> &w) const {
  // About 20000 points on all faces: a power of two per quarter of a face.
  unsigned int n_scanned = 4;
  while (n_scanned < 256 && 2 * n_scanned * 4 * faces_.size() <= 20000)
    n_scanned *= 2;
  const double resolution =
    1e-15 * std::max(face.line.start().norm(), face.line.end().norm()) / face.length();
  // Next to contact w_n touches: a rise inside counts with the pressure.
  const auto is_pinned = [&](const unsigned int end) {
    const NodeCondition &condition = conditions_[face.conditions[end]];
    return component != Component::normal || condition.held() || condition.presses;
  };
  return interpolate_from_above(
    [&](const double t) {
      return misfit(face, component, t) - (w.empty() ? 0. : closing(face, component, t, w));
    },
    face.breaks, rounding(face), {is_pinned(0), is_pinned(1)}, n_scanned, resolution);
}

Curve ContactTrace::line_of_data(const PenetrationFace &face) const {
  if (pair_with(data_.scene, face.side).side() == face.side)
    return face.line;
  return Curve(point_of_data(data_.scene, face.side, face.line.start()),
               point_of_data(data_.scene, face.side, face.line.end()));
}

void ContactTrace::sample() {
  for (PenetrationFace &face : faces_) {
    if (!face.is_contact())
      continue;
    face.breaks = data_.scene.kinks.cut(Side<2>("", line_of_data(face)), 0., face.length());
    for (double &s : face.breaks)
      s /= face.length();
    for (const auto &pressed : face.pressures)
      for (const double t : {pressed.from, pressed.to})
        if (std::none_of(face.breaks.begin(), face.breaks.end(),
                         [t](const double other) { return std::abs(t - other) < 1e-9; }))
          face.breaks.push_back(t);
    std::sort(face.breaks.begin(), face.breaks.end());
    const UpperInterpolant upper = sample(face, Component::normal, {});
    face.d = upper.function;
    if (upper.largest > max_) {
      max_ = upper.largest;
      point_of_largest_ = side_point(face, upper.at);
    }
  }
}

void ContactTrace::require() {
  for (const PenetrationFace &face : faces_)
    for (std::size_t i = 0; i < face.conditions.size(); ++i) {
      NodeCondition &condition = conditions_[face.conditions[i]];
      const double t = face.nodes[i];
      condition.required =
        std::max(condition.required,
                 i > 1 && condition.presses ? misfit(face, Component::normal, t) : face.d.value(t));
    }
  // The rounding of u_n - g = 0.
  const double tolerance = 1e-12 * (size_of_U_ + data_.scene.geometry.diameter());
  for (const NodeCondition &condition : conditions_)
    if (!obstacle_ && condition.is_normal() && condition.held() && condition.required > tolerance)
      obstacle_ = condition.at;
  for (const PenetrationFace &face : faces_) {
    const double largest = face.d.largest();
    const bool near_contact =
      std::any_of(face.conditions.begin(), face.conditions.end(),
                  [&](const unsigned int k) { return conditions_[k].presses; });
    if (!near_contact && largest > std::max({0., face.d.value(0.), face.d.value(1.)}))
      for (const unsigned int k : face.conditions)
        conditions_[k].required = std::max(conditions_[k].required, largest);
  }
}
} // namespace Signorini
