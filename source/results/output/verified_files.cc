// SPDX-License-Identifier: LGPL-2.1-or-later
// The certificate of the displacement of another program.

#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/results/output/verified_files.h>

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>
#include <zlib.h>

namespace Signorini {
namespace {
using Json = nlohmann::ordered_json;

std::string with_digits(const double value, const int n) {
  std::ostringstream text;
  text << std::setprecision(n) << value;
  return text.str();
}

/** Returns "5.5588 +- 0.0002": the margin has two digits, and contains the rounding of the number.
 */
std::string interval_text(const double value, const double margin) {
  if (!std::isfinite(margin))
    return "unknown (the works of the loads do not converge)";
  const int decimals =
    std::clamp(1 - static_cast<int>(std::floor(std::log10(std::max(margin, 1e-12)))), 0, 10);
  const double unit = std::pow(10., -decimals);
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value << " +- "
       << std::ceil(margin / unit + 0.5) * unit;
  return text.str();
}

/** Returns "196 triangles of degree 2, 435 points". */
std::string cells_text(const ForeignField &field) {
  std::map<std::pair<bool, bool>, unsigned int> kinds;
  for (const ForeignCell &cell : field.cells())
    ++kinds[{!cell.is_triangle, cell.has_middles}];
  std::string text;
  for (const auto &[kind, n] : kinds)
    text += concatenate(n, kind.first ? " quadrilaterals" : " triangles", " of degree ",
                        kind.second ? 2 : 1, ", ");
  return text + std::to_string(field.n_nodes()) + " points";
}

/** Returns the largest miss of the supports; none without supports. */
const VerifiedSide *largest_miss(const Verification &found) {
  const VerifiedSide *largest = nullptr;
  for (const VerifiedSide &side : found.sides)
    if (side.is_support && (largest == nullptr || side.miss.norm() > largest->miss.norm()))
      largest = &side;
  return largest;
}

std::string error_text(const VerifiedField &verified) {
  const WithMargin relative = verified.relative();
  const std::string how =
    concatenate(" (energy norm, ", verified.found.is_conditional ? "conditional)" : "guaranteed)");
  return std::isfinite(relative.value)
           ? interval_text(100. * relative.value, 100. * relative.margin) + " % of |||u|||" + how
           : interval_text(verified.found.error.value, verified.found.error.margin) + how;
}

/** Returns by how much the contact force is wrong along the true one. */
std::string force_text(const VerifiedField &verified) {
  constexpr double rounding = 1e-9, noticeable = 0.01;
  const AnswerVector &answer = verified.level.answer.contact_force.resultant.force;
  const Tensor<1, 2> exact({answer[0], answer[1]});
  Tensor<1, 2> force = verified.contact_force();
  const double size = verified.level.contact.normal_force;
  for (unsigned int d = 0; d < 2; ++d)
    force[d] = std::abs(force[d]) > rounding * size ? force[d] : 0.;
  std::string text = vector_text(force);
  if (exact.norm() > rounding * size) {
    const double share = force * exact / exact.norm_square() - 1.;
    text += ", " + with_digits(100. * std::abs(share), 2) +
            (share < 0. ? " % too small" : " % too large");
  }
  text += " (with the moduli of the scene)";
  if ((verified.contact_force(&VerifiedSide::other) - verified.contact_force()).norm() >
      noticeable * size)
    text += "; uncertain, as its nodes are not in balance";
  return text;
}

std::string supports_text(const VerifiedField &verified) {
  const VerifiedSide *const miss = largest_miss(verified.found);
  if (miss == nullptr)
    return "none";
  if (miss->miss.norm() <= 1e-6 * verified.field.largest())
    return "met to " + with_digits(miss->miss.norm(), 1);
  return "missed by " + vector_text(miss->miss) + " on " +
         verified.scene.geometry.sides[miss->side].name() + " at " + vector_text(miss->at);
}

std::string factor_text(const VerifiedField &verified) {
  constexpr double clearly = 1. / 3.;
  const Verification &found = verified.found;
  const double best_percent = 100. * found.factor_distance / found.norm.value;
  return found.factor_distance < clearly * found.error.value
           ? "times " + with_digits(found.factor, 4) + " the field would be within " +
               with_digits(best_percent, 3) + " %: other units?"
           : with_digits(found.factor, 4) + ": no other unit would fit better";
}
} // namespace

WithMargin VerifiedField::relative() const {
  const auto &[error, error_margin] = found.error;
  const auto &[norm, norm_margin] = found.norm;
  if (!(norm > 2. * norm_margin))
    return {HUGE_VAL, HUGE_VAL};
  const double ratio = error / norm;
  return {ratio, (error_margin + ratio * norm_margin) / (norm - norm_margin)};
}

Tensor<1, 2> VerifiedField::contact_force(Tensor<1, 2> VerifiedSide::*const part) const {
  std::set<unsigned int> counted;
  for (const unsigned int number : contacts_of_contact_force(scene)) {
    const ContactCondition<2> &contact = scene.contacts[number];
    counted.insert(body_of_contact_force(scene) == PairSide::first || !contact.opposite
                     ? contact.side
                     : *contact.opposite);
  }
  Tensor<1, 2> force;
  for (const VerifiedSide &side : found.sides)
    if (counted.count(side.side) > 0)
      force += scene.geometry.thickness * side.*part;
  return force;
}

std::string VerifiedField::objection(const double tolerated) const {
  return concatenate(name, ": the error of the displacement is ", error_text(*this),
                     ", which is not below the tolerated ", 100. * tolerated,
                     " % (Verify/Tolerated error).");
}

void print_verified(std::ostream &stream, const VerifiedField &verified) {
  const Verification &found = verified.found;
  const auto line = [&stream](const std::string &label, const std::string &text) {
    stream << "  " << std::left << std::setw(28) << label << text << "\n";
  };
  stream << "Verified  " << verified.name << ": " << cells_text(verified.field) << "\n";
  line("Error of its displacement", error_text(verified));
  if (found.penetration) {
    line("Contact force", force_text(verified));
    const auto &[depth, at] = *found.penetration;
    line(depth > 0. ? "Penetration" : "Smallest opening",
         with_digits(std::abs(depth), 2) + " on " + at.side + " at " +
           vector_text(Point<2>(at.point[0], at.point[1])));
  }
  line("Supports", supports_text(verified));
  line("Largest error",
       "cell at " + vector_text(found.middle_of_largest) + ": " +
         with_digits(100. * found.cells[found.largest_cell] / found.error.value, 2) +
         " % of the whole; all cells are in verified.vtu");
  constexpr double noticeable = 0.02;
  if (std::abs(found.sum_of_cells() - found.error.value) > noticeable * found.error.value)
    line("", "(at their points cells sum up to " +
               with_digits(100. * found.sum_of_cells() / found.error.value, 3) + " % of it)");
  line("Best factor", factor_text(verified));
  if (const double motion = verified.field.largest_motion();
      motion > 1e-12 * verified.scene.geometry.diameter())
    line("Boundary", "points were moved onto the body, at most by " + with_digits(motion, 2));
}

void write_verified_json(std::ostream &stream, const VerifiedField &verified) {
  const Verification &found = verified.found;
  const double thickness = verified.scene.geometry.thickness;
  const auto &[distance, margin] = found.error;
  const WithMargin relative = verified.relative();
  const auto number = [](const double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  };
  const auto vector = [](const Tensor<1, 2> &x) { return Json({x[0], x[1]}); };
  Json json = {
    {"file", verified.name},
    {"cells", verified.field.cells().size()},
    {"points", verified.field.n_nodes()},
    {"guaranteed", !found.is_conditional},
    {"lower", number(std::max(0., distance - margin))},
    {"upper", number(distance + margin)},
    {"distance", number(distance)},
    {"margin", number(margin)},
    {"relative", {{"value", number(relative.value)}, {"margin", number(relative.margin)}}},
    {"norm", number(found.norm.value)},
    {"energy", thickness * (0.5 * found.strain - found.load)},
    {"works", {{"strain", thickness * found.strain}, {"load", thickness * found.load}}},
    {"area", found.area},
    {"factor", number(found.factor)},
    {"factor_distance", number(found.factor_distance)},
    {"contact_force", vector(verified.contact_force())}};
  if (found.penetration)
    json["penetration"] = {{"value", found.penetration->value},
                           {"side", found.penetration->at.side},
                           {"arc_length", found.penetration->at.arc_length},
                           {"point", found.penetration->at.point}};
  for (const VerifiedSide &side : found.sides) {
    Json &entry =
      json["sides"].emplace_back(Json{{"side", verified.scene.geometry.sides[side.side].name()}});
    if (side.is_support)
      entry["miss"] = {
        {"value", side.miss.norm()}, {"vector", vector(side.miss)}, {"point", vector(side.at)}};
    entry["force"] = vector(thickness * side.force);
    entry["moment"] = thickness * side.moment;
  }
  json["largest_cell"] = {{"number", verified.field.cells()[found.largest_cell].number},
                          {"point", vector(found.middle_of_largest)},
                          {"error", found.cells[found.largest_cell]}};
  json["sum_of_cells"] = found.sum_of_cells();
  json["largest_motion"] = verified.field.largest_motion();
  stream << json.dump(2) << "\n";
}

namespace {
/** Writes an array in base 64, compressed in one block. */
template <typename T>
void write_array(std::ostream &stream, const std::string &attributes,
                 const std::vector<T> &values) {
  const auto *const first = reinterpret_cast<const Bytef *>(values.data());
  const uLong size = values.size() * sizeof(T);
  std::vector<unsigned char> packed(compressBound(size));
  uLongf packed_size = packed.size();
  AssertThrow(compress(packed.data(), &packed_size, first, size) == Z_OK, ExcInternalError());
  packed.resize(packed_size);
  const std::array<std::uint32_t, 4> header = {{1, static_cast<std::uint32_t>(size),
                                                static_cast<std::uint32_t>(size),
                                                static_cast<std::uint32_t>(packed_size)}};
  const auto *const of_header = reinterpret_cast<const unsigned char *>(header.data());
  stream << "<DataArray " << attributes << " format=\"binary\">"
         << Utilities::encode_base64({of_header, of_header + sizeof(header)})
         << Utilities::encode_base64(packed) << "</DataArray>\n";
}
} // namespace

void write_verified_vtu(std::ostream &stream, const VerifiedField &verified) {
  const std::vector<ForeignCell> &cells = verified.field.cells();
  const unsigned int n_nodes = verified.field.n_nodes();
  std::vector<double> x(3 * n_nodes), v(3 * n_nodes), difference(3 * n_nodes);
  std::vector<std::int32_t> connectivity, offsets;
  std::vector<std::uint8_t> types;
  for (const ForeignCell &cell : cells) {
    for (unsigned int i = 0; i < cell.n_nodes(); ++i) {
      connectivity.push_back(static_cast<std::int32_t>(cell.nodes[i]));
      for (unsigned int d = 0; d < 2; ++d) {
        const unsigned int at = 3 * cell.nodes[i] + d;
        x[at] = cell.x[i][d];
        v[at] = cell.v[i][d];
        difference[at] = verified.found.differences[cell.nodes[i]][d];
      }
    }
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
    types.push_back(cell.is_triangle ? (cell.has_middles ? 22 : 5)
                                     : (cell.has_centre ? 28 : (cell.has_middles ? 23 : 9)));
  }
  const std::string vectors = "type=\"Float64\" NumberOfComponents=\"3\" Name=";
  stream << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
            "byte_order=\"LittleEndian\" compressor=\"vtkZLibDataCompressor\">\n"
         << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << n_nodes << "\" NumberOfCells=\""
         << cells.size() << "\">\n<Points>\n";
  write_array(stream, vectors + "\"Points\"", x);
  stream << "</Points>\n<Cells>\n";
  write_array(stream, "type=\"Int32\" Name=\"connectivity\"", connectivity);
  write_array(stream, "type=\"Int32\" Name=\"offsets\"", offsets);
  write_array(stream, "type=\"UInt8\" Name=\"types\"", types);
  stream << "</Cells>\n<PointData>\n";
  write_array(stream, vectors + "\"displacement\"", v);
  write_array(stream, vectors + "\"difference\"", difference);
  stream << "</PointData>\n<CellData>\n";
  write_array(stream, "type=\"Float64\" Name=\"error\"", verified.found.cells);
  stream << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}
} // namespace Signorini
