// SPDX-License-Identifier: LGPL-2.1-or-later
// The penetration of u_h or π^{2h} u_h along Γ_c, and the contact nodes.

#include <signorini/error_control/contact_term/contact_trace.h>
#include <signorini/postprocessing/fields/forces.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
double PenetrationFace::pressure(const double t) const
{
  for (const Pressed &part : pressures)
    if (t <= part.to)
      return part.p;
  return pressures.empty() ? 0. : pressures.back().p;
}

bool PenetrationFace::presses() const
{
  return std::any_of(
    pressures.begin(), pressures.end(), [](const Pressed &part) { return part.presses; });
}

bool PenetrationFace::presses_everywhere() const
{
  return std::all_of(
    pressures.begin(), pressures.end(), [](const Pressed &part) { return part.presses; });
}

double PenetrationFace::component(const Displacement &V,
                                  const double t,
                                  const Tensor<1, 2> &direction) const
{
  double value = 0.;
  for (unsigned int d = 0; d < 2; ++d)
    value += direction[d] * ((1. - t) * V[dofs[0][d]] + t * V[dofs[1][d]]);
  return value;
}

ContactTrace::ContactTrace(const DisplacementSpace<2> &space,
                           const Scene<2> &scene,
                           const MultiplierSpace<2> &multipliers,
                           const Displacement &U,
                           const Pressure &P,
                           const std::vector<FaceField> &fields)
  : space_(space)
  , scene_(scene)
  , multipliers_(multipliers)
  , U_(U)
  , normals_(std::vector<Coupling::Column>())
{
  find_faces(P, fields);
  find_conditions();
  sample();
  find_obstacle();
}

void ContactTrace::find_faces(const Pressure &P, const std::vector<FaceField> &fields)
{
  const ContactSurface<2> &surface = multipliers_.surface();
  const double rounding = 1e-14 * U_.linfty_norm();
  for (unsigned int i = 0; i < surface.faces().size(); ++i)
  {
    const ContactFace<2> &contact = surface.faces()[i];
    const auto cell = space_.dof_cell(contact.cell);
    PenetrationFace face = {};
    face.number = i;
    if (!fields.empty())
      face.field = fields[i];
    // Where π^{2h} u_h = u_h but for rounding, the contact term would be rounding, and the root of
    // rounding is not.
    if (std::abs(face.field.bubble) <= rounding)
      face.field.bubble = 0.;
    face.side = contact.side;
    for (unsigned int end = 0; end < 2; ++end)
    {
      const unsigned int v = GeometryInfo<2>::face_to_cell_vertices(contact.face_no, end);
      (end == 0 ? face.start : face.end) = cell->vertex(v);
      for (unsigned int d = 0; d < 2; ++d)
        face.dofs[end][d] = cell->vertex_dof_index(v, d);
    }
    face.length = face.start.distance(face.end);
    if (space_.mesh().is_curved())
    {
      Point<2> middle(0.5, 0.5);
      middle[contact.face_no / 2] = contact.face_no % 2;
      face.bulge =
        space_.mesh().mapping().transform_unit_to_real_cell(cell, middle) - face.point(0.5);
    }
    const Side<2> &side = scene_.geometry.sides[contact.side];
    face.normal = side.normal(side.arc_length(face.point(0.5)));
    faces_.push_back(face);
  }
  const double threshold = pressing_threshold(P);
  for (const Piece<2> &piece : surface.pieces())
  {
    const double a = piece.lower_on_face[0], b = piece.upper_on_face[0];
    const double p = multipliers_.value(P, piece.patch, piece.lower);
    faces_[piece.face].pressures.push_back({std::min(a, b), std::max(a, b), p, p < threshold});
  }
  for (PenetrationFace &face : faces_)
    std::sort(face.pressures.begin(), face.pressures.end(), [](const auto &a, const auto &b) {
      return a.from < b.from;
    });
}

unsigned int ContactTrace::condition_at(const PenetrationFace &face,
                                        const unsigned int end,
                                        ConditionsOfVertices &known)
{
  const ContactFace<2> &contact = multipliers_.surface().faces()[face.number];
  const unsigned int vertex =
    contact.cell->vertex_index(GeometryInfo<2>::face_to_cell_vertices(contact.face_no, end));
  for (const unsigned int k : known[vertex])
    if ((conditions_[k].normal - face.normal).norm() < 1e-10)
      return k;
  known[vertex].push_back(conditions_.size());
  NodeCondition condition = {};
  condition.normal = face.normal;
  condition.required = -std::numeric_limits<double>::infinity();
  const Side<2> &side = scene_.geometry.sides[face.side];
  condition.place = {face.side, side.arc_length(end == 0 ? face.start : face.end)};
  conditions_.push_back(condition);
  return conditions_.size() - 1;
}

void ContactTrace::find_conditions()
{
  std::vector<Coupling::Column> columns;
  ConditionsOfVertices known;
  for (PenetrationFace &face : faces_)
    for (unsigned int end = 0; end < 2; ++end)
    {
      face.conditions[end] = condition_at(face, end, known);
      if (face.conditions[end] == columns.size())
      {
        columns.emplace_back();
        for (unsigned int d = 0; d < 2; ++d)
          if (std::abs(face.normal[d]) > 1e-15)
            columns.back().emplace(face.dofs[end][d], face.normal[d]);
      }
      NodeCondition &condition = conditions_[face.conditions[end]];
      condition.presses = condition.presses || face.presses();
    }
  const Coupling condensed = condense(Coupling(columns), space_.constraints_without_pins());
  columns.clear();
  for (unsigned int k = 0; k < condensed.n_columns(); ++k)
  {
    double square = 0.;
    for (const auto &entry : condensed.column(k))
      square += entry.second * entry.second;
    conditions_[k].held = square < 1e-20;
    columns.push_back(conditions_[k].held ? Coupling::Column() : condensed.column(k));
  }
  normals_ = Coupling(std::move(columns));
}

double ContactTrace::penetration(const PenetrationFace &face, const double t) const
{
  const Side<2> &side = scene_.geometry.sides[face.side];
  const Point<2> x = face.point(t);
  // At a corner of the side, the gap is that of this face.
  constexpr double inside = 1e-9;
  const double gap = scene_.boundary[face.side].data->value(
    side.corners().empty() ? x : face.point(std::clamp(t, inside, 1. - inside)));
  if (!space_.mesh().is_curved())
    return face.normal_value(U_, t) + 4. * t * (1. - t) * face.field.bubble - gap;
  return face.component(U_, t, side.normal_at(x, face.point(0.5))) - gap;
}

ContactTrace::TractionChange ContactTrace::traction_change(const Tensor<1, 2> &c) const
{
  const QGauss<1> gauss(4);
  TractionChange change;
  for (const PenetrationFace &face : faces_)
  {
    if (!face.field.traction)
      continue;
    for (const EdgeFunction::Part &part : face.d.parts())
      for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const double t = part.start + (part.end - part.start) * gauss.point(q)[0];
        const double force = (face.traction(t) - face.pressure(t)) * face.length *
                             (part.end - part.start) * gauss.weight(q);
        const double g = scene_.boundary[face.side].data->value(face.point(t));
        change.normal_force += force;
        change.force += force * face.normal;
        change.work_of_gap += force * (g - c * face.normal);
      }
  }
  return change;
}

double ContactTrace::work_of_penetration() const
{
  const QGauss<1> gauss(4);
  double work = 0.;
  for (const PenetrationFace &face : faces_)
    for (const EdgeFunction::Part &part : face.d.parts())
      for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const double t = part.start + (part.end - part.start) * gauss.point(q)[0];
        if (const double traction = face.traction(t); traction != 0.)
          work += traction * penetration(face, t) * face.length * (part.end - part.start) *
                  gauss.weight(q);
      }
  return work;
}

void ContactTrace::sample()
{
  max_ = 0.;
  // About 20000 points on all faces: a power of two per quarter of a face.
  unsigned int n_scanned = 4;
  while (n_scanned < 256 && 2 * n_scanned * 4 * faces_.size() <= 20000)
    n_scanned *= 2;
  const double displacement = U_.linfty_norm();
  for (PenetrationFace &face : faces_)
  {
    std::vector<double> breaks = scene_.kinks.cut(face.start, face.end);
    for (const auto &pressed : face.pressures)
      for (const double t : {pressed.from, pressed.to})
        if (std::none_of(breaks.begin(), breaks.end(), [t](const double other) {
              return std::abs(t - other) < 1e-9;
            }))
          breaks.push_back(t);
    std::sort(breaks.begin(), breaks.end());
    const Pinned pinned = {conditions_[face.conditions[0]].held,
                           conditions_[face.conditions[1]].held};
    const double rounding =
      1e-14 * (displacement + std::abs(penetration(face, 0.) - face.normal_value(U_, 0.)));
    const UpperInterpolant upper = interpolate_from_above(
      [&](const double t) { return penetration(face, t); }, breaks, rounding, pinned, n_scanned);
    face.d = upper.function;
    if (upper.largest > max_)
    {
      max_ = upper.largest;
      place_of_largest_ = {face.side,
                           scene_.geometry.sides[face.side].arc_length(face.point(upper.at))};
    }
    for (const unsigned int end : {0, 1})
    {
      NodeCondition &condition = conditions_[face.conditions[end]];
      condition.required = std::max(condition.required, face.d.value(end));
    }
  }
}

void ContactTrace::find_obstacle()
{
  // What rounding makes of u_n - g = 0.
  const double tolerance = 1e-12 * (U_.linfty_norm() + scene_.geometry.diameter());
  for (const NodeCondition &condition : conditions_)
    if (condition.held && condition.required > tolerance)
    {
      obstacle_ = {"u_n - g > 0 where the contact side meets a side that holds the body: no "
                   "displacement of finite energy removes the penetration",
                   condition.place};
      return;
    }
}

// Contact edges whose normal traction may be free.

std::vector<unsigned int> pressing_edges(const EdgeMesh &mesh,
                                         const MultiplierSpace<2> &multipliers,
                                         const Pressure &P)
{
  const ContactSurface<2> &surface = multipliers.surface();
  const double threshold = pressing_threshold(P);
  std::vector<bool> presses(surface.faces().size(), true);
  for (const Piece<2> &piece : surface.pieces())
    if (!(multipliers.value(P, piece.patch, piece.lower) < threshold))
      presses[piece.face] = false;
  std::vector<unsigned int> edges;
  for (std::size_t i = 0; i < presses.size(); ++i)
    if (presses[i])
    {
      const ContactFace<2> &face = surface.faces()[i];
      edges.push_back(mesh.edge_of_line(face.cell->face(face.face_no)->index()));
    }
  return edges;
}

std::array<double, 2> normal_tractions(const Edge &edge,
                                       const unsigned int number,
                                       const std::vector<double> &moments)
{
  double a = 0., b = 0.;
  for (unsigned int c = 0; c < 2; ++c)
  {
    a += moments[4 * number + c] * edge.normal[c];
    b += moments[4 * number + 2 + c] * edge.normal[c];
  }
  return {{(4. * a - 2. * b) / edge.length, (4. * b - 2. * a) / edge.length}};
}
} // namespace Signorini
