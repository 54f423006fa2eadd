// SPDX-License-Identifier: LGPL-2.1-or-later
// Pressure, gap and opening along the contact boundary.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/paired_piece.h>
#include <signorini/postprocessing/fields/recovered_pressure.h>
#include <signorini/results/output/contact_files.h>
#include <signorini/results/output/solution_vtu.h>
#include <signorini/results/output/tables.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Signorini {
namespace {
/** Returns -p, where zero has no sign. */
double positive_in_compression(const double p) {
  return p == 0. ? 0. : -p;
}

/** Returns positions between 0 and 1 on a piece: its ends, the nodes of its multipliers, and the
 * middles between all of these. */
std::vector<Point<1>> positions_of_polynomial(const Piece<2> &piece,
                                              const MultiplierSpace<2> &multipliers) {
  std::vector<double> corners = {0.};
  for (unsigned int k = multipliers.first_of(piece.patch);
       k < multipliers.first_of(piece.patch + 1); ++k) {
    const double t = (multipliers.node(k)[0] - piece.lower[0]) / (piece.upper[0] - piece.lower[0]);
    if (t > 0. && t < 1.)
      corners.push_back(t);
  }
  corners.push_back(1.);
  std::vector<Point<1>> positions = {Point<1>(0.)};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    positions.emplace_back(0.5 * (corners[i - 1] + corners[i]));
    positions.emplace_back(corners[i]);
  }
  return positions;
}

/** Returns the number of a state in files: 0 where it is open, 1 where it sticks, 2 where it slips.
 */
int number_of(const NodeState &state) {
  return !state.presses ? 0 : state.slip == State::inside ? 1 : 2;
}

/** A row of contact-LL.csv. */
template <int dim>
struct ContactRow {
  const ContactPiece<dim> &piece;
  const ContactPoint<dim> &point;
};

template <int dim>
void add_tangential_columns(Columns<ContactRow<dim>> &columns) {
  using Row = ContactRow<dim>;
  const auto add = [&](const char *name, const auto part) {
    columns.push_back({name, [part](const Row &row) { return (*row.point.tangential).*part; }});
  };
  add("q_H", &TangentialPoint::q_H);
  add("s_H", &TangentialPoint::s_H);
  add("slip", &TangentialPoint::slip);
  add("q_exact", &TangentialPoint::q_exact);
  for (const auto &[name, vector] :
       {std::pair("q_H_", &TangentialPoint::traction), {"slip_", &TangentialPoint::slip_vector}})
    for (unsigned int d = 0; d < dim && dim == 3; ++d)
      columns.push_back({name + std::string(1, "xyz"[d]), [part = vector, d](const Row &row) {
                           return ((*row.point.tangential).*part)[d];
                         }});
  columns.push_back(
    {"state", [](const Row &row) { return number_of(row.point.tangential->state); }});
}

template <int dim>
Columns<ContactRow<dim>> contact_columns(const bool has_tangential_part, const bool has_pairs,
                                         const bool has_directions) {
  using Row = ContactRow<dim>;
  Columns<Row> columns;
  if (dim == 2)
    columns.push_back({"s", [](const Row &row) { return row.point.s[0]; }});
  for (unsigned int d = 0; d < dim; ++d)
    columns.push_back({std::string(1, "xyz"[d]), [d](const Row &row) { return row.point.x[d]; }});
  const Columns<Row> others = {
    {"p_H", [](const Row &row) { return row.point.p_H; }},
    {"p_recovered", [](const Row &row) { return row.point.p_recovered; }},
    {"u_n", [](const Row &row) { return row.point.u_n; }},
    {"g", [](const Row &row) { return row.point.g; }},
    // The pressure is infinite at an edge of a punch.
    {"p_exact",
     [](const Row &row) {
       return std::isfinite(row.point.p_exact.value_or(0.)) ? row.point.p_exact : std::nullopt;
     }},
    {"patch", [](const Row &row) { return row.piece.patch; }},
    {dim == 2 ? "patch_length" : "patch_area",
     [](const Row &row) { return row.piece.patch_measure; }}};
  columns.insert(columns.end(), others.begin(), others.end());
  if (has_tangential_part)
    add_tangential_columns(columns);
  const auto add_across = [&](const std::string &name, const auto value) {
    columns.push_back({name + "_opposite", [value](const Row &row) {
                         const auto &across = row.point.across;
                         return across ? std::optional<double>(value(*across)) : std::nullopt;
                       }});
  };
  for (unsigned int d = 0; d < dim && has_pairs; ++d)
    add_across(std::string(1, "xyz"[d]), [d](const auto &across) { return across.x[d]; });
  if (has_pairs)
    add_across("u_n", [](const auto &across) { return across.u_n; });
  for (unsigned int d = 0; d < dim && has_directions; ++d)
    columns.push_back(
      {std::string("m_") + "xyz"[d], [d](const Row &row) { return row.point.direction[d]; }});
  return columns;
}

/** Evaluates the fields at points of the contact boundary. */
template <int dim>
class ContactTracer {
public:
  explicit ContactTracer(const BodyInContact<dim> &body)
    : body_(body)
    , surface_(body.surface())
    , bounds_(body.P.bounds())
    , recovered_(body.multipliers, body.P.normal())
    , traces_(body.space) {}

  std::vector<ContactPoint<dim>> trace(const Piece<dim> &piece,
                                       const std::vector<Point<dim - 1>> &positions) {
    const ContactCondition<dim> &condition =
      body_.scene.contacts[surface_.patches()[piece.patch].contact];
    const SurfaceRule<dim> rule = surface_.at(piece, positions);
    const PairedPiece<dim> pair(surface_, piece);
    const auto u = pair.displacements(rule, body_.U, traces_);
    const bool is_of_bodies = pair.other_face() != nullptr;
    const std::vector<Point<dim>> across =
      pair.points(rule, is_of_bodies ? PairSide::second : PairSide::first);
    std::vector<ContactPoint<dim>> points;
    for (std::size_t q = 0; q < rule.size(); ++q) {
      ContactPoint<dim> point;
      point.s = rule.on_side[q];
      point.x = rule.points[q];
      point.p_H = body_.multipliers.value(body_.P.normal(), piece.patch, point.s);
      point.p_recovered = recovered_(piece.patch, point.s);
      point.u = u[0][q];
      point.direction = rule.directions[q];
      const Tensor<1, dim> closing = u[0][q] - u[1][q];
      point.u_n = closing * point.direction;
      point.g = pair.in(body_.scene).gap(point.x);
      if (body_.P.has_tangential_part())
        point.tangential = tangential_at(piece, point, closing);
      if (is_of_bodies)
        point.across = {across[q], u[1][q], u[1][q] * rule.directions[q]};
      if (condition.exact_pressure != nullptr)
        point.p_exact = condition.exact_pressure->value(point.x);
      points.push_back(point);
    }
    return points;
  }

private:
  TangentialPoint tangential_at(const Piece<dim> &piece, const ContactPoint<dim> &at,
                                Tensor<1, dim> slip) const {
    const unsigned int patch = piece.patch;
    const ContactPair<dim> pair = PairedPiece<dim>(surface_, piece).in(body_.scene);
    const auto &exact = pair.data().exact_tangential;
    const Tensor<1, dim> &m = at.direction;
    const auto &[multipliers, P] = std::tie(body_.multipliers, body_.P);
    TangentialPoint point;
    point.q_H = multipliers.value(P.values(), patch, at.s, 1);
    point.s_H = multipliers.value(bounds_, patch, at.s);
    point.state = P.state(multipliers.nearest_node(patch, at.s));
    if (exact != nullptr)
      point.q_exact = exact->value(at.x);
    if constexpr (dim == 2)
      point.slip = slip * direction_of(Component::tangential, m) - pair.shift(at.x);
    else {
      for (unsigned int d = 0; d < dim; ++d)
        slip[d] -= pair.shift(at.x, d);
      point.slip_vector = slip - (slip * m) * m;
      point.slip = point.slip_vector.norm();
      point.traction = tangential_traction(multipliers, P, patch, at.s, m);
      point.q_H = point.traction.norm();
    }
    return point;
  }

  const BodyInContact<dim> &body_;
  const ContactSurface<dim> &surface_;
  Pressure bounds_;
  RecoveredPressure<dim> recovered_;
  TraceValues<dim> traces_;
};
} // namespace

/** Returns a piece with its points. */
template <int dim>
static ContactPiece<dim> trace_piece(ContactTracer<dim> &tracer,
                                     const MultiplierSpace<dim> &multipliers,
                                     const Piece<dim> &piece) {
  const ContactSurface<dim> &surface = multipliers.surface();
  const Patch<dim> &patch = surface.patches()[piece.patch];
  std::vector<Point<dim - 1>> rows = QMidpoint<dim - 1>().get_points(),
                              corners = QTrapezoid<dim - 1>().get_points();
  if constexpr (dim == 2)
    if (!multipliers.is_piecewise_constant())
      rows = corners = positions_of_polynomial(piece, multipliers);
  // In one call: faces with the same points share a table.
  std::vector<Point<dim - 1>> positions = rows;
  positions.insert(positions.end(), corners.begin(), corners.end());
  const std::vector<ContactPoint<dim>> points = tracer.trace(piece, positions);
  const auto middle = points.begin() + rows.size();
  return {surface.side(patch).name(),
          patch.contact,
          patch.side,
          piece.face,
          piece.patch,
          patch.measure,
          PairedPiece<dim>(surface, piece).pair().other_side(),
          !surface.condition(piece).directions.are_normals(),
          {points.begin(), middle},
          {middle, points.end()}};
}

template <int dim>
TracedContact<dim> trace_contact(const BodyInContact<dim> &body) {
  const ContactSurface<dim> &surface = body.surface();
  TracedContact<dim> contact;
  agree(surface.communicator(), [&]() {
    ContactTracer<dim> tracer(body);
    for (const Piece<dim> &piece : surface.pieces())
      contact.push_back(trace_piece(tracer, body.multipliers, piece));
  });
  if (!body.space.mesh().is_shared())
    return contact;
  contact = collect(contact, surface.communicator());
  std::stable_sort(contact.begin(), contact.end(), [](const auto &a, const auto &b) {
    return std::tie(a.contact, a.face) < std::tie(b.contact, b.face);
  });
  return contact;
}

/** Returns whether some piece may touch another body. */
template <int dim>
static bool has_pairs(const TracedContact<dim> &contact) {
  return std::any_of(contact.begin(), contact.end(),
                     [](const auto &piece) { return piece.other_side.has_value(); });
}

/** Returns whether contact acts along the normals of planes somewhere. */
template <int dim>
static bool has_directions(const TracedContact<dim> &contact) {
  return std::any_of(contact.begin(), contact.end(),
                     [](const auto &piece) { return piece.has_direction; });
}

template <int dim>
void write_contact_csv(std::ostream &stream, const TracedContact<dim> &contact) {
  const bool has_tangential_part = !contact.empty() && contact.front().rows.front().tangential;
  const Columns<ContactRow<dim>> columns =
    contact_columns<dim>(has_tangential_part, has_pairs(contact), has_directions(contact));
  stream << "side," << csv_header(columns) << "\n";
  for (const ContactPiece<dim> &piece : contact)
    for (const ContactPoint<dim> &point : piece.rows)
      stream << piece.side << "," << csv_row(columns, {piece, point}) << "\n";
}

namespace {
/** Adds a number in the plane, a vector in space. */
template <int dim>
void add_tangential(const char *const name, const double number, const Tensor<1, 3> &vector,
                    VtuFields &fields) {
  if (dim == 2)
    fields.emplace_back(name, number);
  else
    add_vector(name, vector, fields);
}
} // namespace

/** Returns the fields of a point that both sides of a pair have in common. */
template <int dim>
static VtuFields common_fields(const ContactPoint<dim> &point) {
  VtuFields fields = {{"contact_pressure", positive_in_compression(point.p_H)},
                      {"recovered_contact_pressure", positive_in_compression(point.p_recovered)},
                      {"normal_displacement", point.u_n},
                      {"gap", point.g},
                      {"opening", point.g - point.u_n}};
  if (const auto &part = point.tangential) {
    add_tangential<dim>("friction_traction", part->q_H, part->traction, fields);
    fields.emplace_back("friction_limit", part->s_H);
    add_tangential<dim>("slip", part->slip, part->slip_vector, fields);
    fields.emplace_back("friction_state", number_of(part->state));
  }
  return fields;
}

template <int dim>
void write_contact_vtu(std::ostream &stream, const TracedContact<dim> &contact,
                       const std::vector<double> &bound) {
  VtuCells<dim - 1> cells;
  const bool with_pairs = has_pairs(contact), with_directions = has_directions(contact);
  constexpr unsigned int n_corners = GeometryInfo<dim - 1>::vertices_per_cell;
  /** Adds the corners of one side, which may touch another one. */
  const auto add_side = [&](const ContactPiece<dim> &piece, const std::size_t first,
                            const bool is_second) {
    const double own = piece.side_number, other = piece.other_side ? *piece.other_side : -1.;
    std::vector<Point<dim>> points;
    std::vector<VtuFields> fields;
    for (unsigned int v = 0; v < n_corners; ++v) {
      const ContactPoint<dim> &point = piece.corners[first + v];
      points.push_back(is_second ? point.across->x : point.x);
      VtuFields all;
      add_vector("displacement", is_second ? point.across->u : point.u, all);
      all.insert(all.end(), {{"patch", piece.patch}, {"side", is_second ? other : own}});
      if (with_pairs)
        all.emplace_back("opposite", is_second ? own : other);
      if (!bound.empty())
        all.emplace_back("bound_contact", bound[piece.face]);
      if (with_directions)
        add_vector("contact_direction", point.direction, all);
      const VtuFields common = common_fields(point);
      all.insert(all.end(), common.begin(), common.end());
      fields.push_back(std::move(all));
    }
    cells.add(1, points, fields);
  };
  for (const ContactPiece<dim> &piece : contact)
    for (std::size_t first = 0; first + n_corners <= piece.corners.size(); ++first) {
      add_side(piece, first, false);
      if (piece.other_side)
        add_side(piece, first, true);
    }
  DataOutBase::VtkFlags flags;
  // The same run gives the same file.
  flags.print_date_and_time = false;
  DataOutBase::write_vtu(cells.cells, cells.names, cells.ranges(), flags, stream);
}

INSTANTIATE_FUNCTION(trace_contact);
INSTANTIATE_FUNCTION(write_contact_csv);
INSTANTIATE_FUNCTION(write_contact_vtu);
} // namespace Signorini
