// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of VTK: every encoding is the same mesh, and a damaged file is one sentence.

#include <signorini/problem/mesh_file/vtu_file.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <random>
#include <zlib.h>

#include "tests.h"

using namespace Signorini;

namespace {
const std::vector<double> points = {0, 0, 0, 1, 0, 0, 2.5, 0, 0, 0, 1, 0, 1, 1, 0},
                          displacement = {0, 0, 0, 0.25, 0,      0, 0.5, -1e-3,
                                          0, 0, 7, 0,    1. / 3, 0, 0},
                          connectivity = {0, 1, 4, 3, 1, 2, 4}, offsets = {4, 7}, types = {9, 5};

/** How the numbers of a file are written. */
struct Encoding {
  std::string name, format, real = "Float64", integer = "Int64";
  bool is_big = false, is_long = false, is_packed = false, is_raw = false;
};

const std::vector<Encoding> encodings = {
  {"text", "ascii"},
  {"base 64", "binary"},
  {"base 64 of 32 bits", "binary", "Float32", "Int32"},
  {"big numbers first", "binary", "Float64", "Int32", true},
  {"zlib", "binary", "Float64", "Int64", false, false, true},
  {"zlib, long headers", "binary", "Float64", "UInt32", false, true, true},
  {"appended", "appended", "Float64", "Int64", false, true, false, true},
  {"appended, zlib", "appended", "Float32", "Int64", true, true, true, true},
  {"appended in base 64", "appended"},
  {"appended in base 64, zlib", "appended", "Float64", "UInt64", false, false, true}};

template <typename T>
void append(T number, const bool is_big, std::string &bytes) {
  std::string part(reinterpret_cast<const char *>(&number), sizeof(T));
  if (is_big)
    std::reverse(part.begin(), part.end());
  bytes += part;
}

std::string bytes_of(const std::vector<double> &values, const std::string &type,
                     const bool is_big) {
  std::string bytes;
  for (const double x : values)
    if (type == "Float64")
      append(x, is_big, bytes);
    else if (type == "Float32")
      append(static_cast<float>(x), is_big, bytes);
    else if (type == "Int32" || type == "UInt32")
      append(static_cast<std::int32_t>(x), is_big, bytes);
    else if (type == "UInt8")
      append(static_cast<std::uint8_t>(x), is_big, bytes);
    else
      append(static_cast<std::int64_t>(x), is_big, bytes);
  return bytes;
}

std::string packed(const std::string &bytes) {
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  compress(reinterpret_cast<Bytef *>(result.data()), &size,
           reinterpret_cast<const Bytef *>(bytes.data()), bytes.size());
  result.resize(size);
  return result;
}

std::string coded(const std::string &bytes, const bool is_raw) {
  return is_raw ? bytes : Utilities::encode_base64({bytes.begin(), bytes.end()});
}

/** Returns the header and the data of an array, in two blocks where it is compressed. */
std::string data_of(const Encoding &encoding, const std::string &bytes) {
  std::string header;
  const auto add = [&](const std::size_t n) {
    if (encoding.is_long)
      append(static_cast<std::uint64_t>(n), encoding.is_big, header);
    else
      append(static_cast<std::uint32_t>(n), encoding.is_big, header);
  };
  if (!encoding.is_packed) {
    add(bytes.size());
    return coded(header + bytes, encoding.is_raw);
  }
  const std::size_t block = (bytes.size() + 1) / 2;
  const std::string first = packed(bytes.substr(0, block)), second = packed(bytes.substr(block));
  for (const std::size_t n :
       {std::size_t(2), block, bytes.size() - block, first.size(), second.size()})
    add(n);
  return coded(header, encoding.is_raw) + coded(first + second, encoding.is_raw);
}

std::string file_of(const Encoding &encoding) {
  std::string appended;
  const auto array = [&](const std::string &name, const std::string &type,
                         const std::vector<double> &values, const std::string &more = "") {
    std::ostringstream text;
    text.precision(17);
    text << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" " << more << " format=\""
         << encoding.format << "\"";
    const std::string data = data_of(encoding, bytes_of(values, type, encoding.is_big));
    if (encoding.format == "appended") {
      text << " offset=\"" << appended.size() << "\"/>\n";
      appended += data;
      return text.str();
    }
    text << ">\n";
    if (encoding.format == "binary")
      text << data;
    for (const double x : values)
      if (encoding.format == "ascii")
        text << x << " ";
    text << "\n</DataArray>\n";
    return text.str();
  };
  const std::string three = "NumberOfComponents=\"3\"";
  std::string text =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"";
  text += encoding.is_big ? "BigEndian\"" : "LittleEndian\"";
  text += encoding.is_long ? " header_type=\"UInt64\"" : "";
  text += encoding.is_packed ? " compressor=\"vtkZLibDataCompressor\"" : "";
  text += ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"5\" NumberOfCells=\"2\">\n<Points>\n" +
          array("Points", encoding.real, points, three) + "</Points>\n<Cells>\n" +
          array("connectivity", encoding.integer, connectivity) +
          array("offsets", encoding.integer, offsets) + array("types", "UInt8", types) +
          "</Cells>\n<PointData>\n" + array("pressure", encoding.real, {1, 2, 3, 4, 5}) +
          array("displacement", encoding.real, displacement, three) +
          "</PointData>\n</Piece>\n</UnstructuredGrid>\n";
  if (!appended.empty())
    text += std::string("<AppendedData encoding=\"") + (encoding.is_raw ? "raw" : "base64") +
            "\">\n_" + appended + "\n</AppendedData>\n";
  return text + "</VTKFile>\n";
}

void test_encodings(Checks &checks) {
  for (const Encoding &encoding : encodings) {
    checks.about(encoding.name);
    const VtuMesh mesh = read_vtu(file_of(encoding), "a.vtu", "displacement");
    const double rounding = encoding.real == "Float32" ? 1e-6 : 0.;
    std::vector<double> x, entries, kinds;
    for (const Point<3> &point : mesh.points)
      x.insert(x.end(), point.begin_raw(), point.end_raw());
    for (const VtuMesh::Cell &cell : mesh.cells) {
      entries.insert(entries.end(), cell.points.begin(), cell.points.end());
      kinds.push_back(cell.type);
    }
    checks.near("points", x, points, rounding);
    checks.near("values", mesh.values, displacement, rounding);
    checks.near("cells", entries, connectivity, 0.);
    checks.near("types", kinds, types, 0.);
  }
}

/** Two pieces are one mesh. */
void test_pieces(Checks &checks) {
  std::string text = file_of(encodings[0]);
  const std::size_t begin = text.find("<Piece"), end = text.find("</UnstructuredGrid>");
  text.insert(end, text.substr(begin, end - begin));
  const VtuMesh mesh = read_vtu(text, "a.vtu", "displacement");
  checks.near("points of two pieces", mesh.points.size(), 10., 0.);
  checks.near("first point of the second piece", mesh.cells[2].points[0], 5., 0.);
}

void test_refusals(Checks &checks) {
  const std::string good = file_of(encodings[0]);
  const auto refuse = [&](const std::string &part, const std::string &other,
                          const std::string &message) {
    std::string text = good;
    if (const std::size_t at = text.find(part); at != std::string::npos)
      text.replace(at, part.size(), other);
    checks.refuses("a.vtu: " + message, [&]() { read_vtu(text, "a.vtu", "displacement"); });
  };
  refuse(good, "", "this is no file of VTK with an UnstructuredGrid, allowed: .vtu.");
  refuse("UnstructuredGrid>", "PolyData>",
         "this is no file of VTK with an UnstructuredGrid, allowed: .vtu.");
  refuse("Name=\"displacement\"", "Name=\"U\"",
         "piece 1: found no point data of the name 'displacement' (Verify/Field), allowed: "
         "pressure, U.");
  refuse("Name=\"displacement\" NumberOfComponents=\"3\"",
         "Name=\"displacement\" NumberOfComponents=\"6\"",
         "piece 1: the field 'displacement' has '6' components, allowed: 2 or 3, as many in all "
         "pieces.");
  refuse("NumberOfPoints=\"5\"", "NumberOfPoints=\"6\"",
         "piece 1: Points: found 15 numbers, allowed: 18 as the numbers of points and cells say.");
  refuse("NumberOfPoints=\"5\"", "NumberOfPoints=\"1e12\"",
         "piece 1: NumberOfPoints: found '1e12', allowed: a whole number below 1e9.");
  refuse("0 1 4 3 1 2 4", "0 1 4 3 1 2 5", "piece 1: cell 1: found the point 5, allowed: 0 to 4.");
  refuse("4 7", "5 4",
         "piece 1: Cells, array 'connectivity': found 7 numbers, allowed: 4 as the numbers of "
         "points and "
         "cells say.");
  refuse("4 7", "9 7", "piece 1: cell 0: its type or its offset is wrong.");
  refuse("0 1 4 3", "0 1 x 3",
         "piece 1: Cells, array 'connectivity': found 'x 3 1 2 4', allowed: numbers.");
  refuse("Name=\"offsets\"", "Name=\"ends\"",
         "piece 1: Cells, array 'offsets': there is no such array.");
  refuse("format=\"ascii\"", "format=\"hex\"",
         "piece 1: Points: found the format 'hex', allowed: ascii, binary, appended.");
  refuse("format=\"ascii\"", "format=\"appended\" offset=\"7\"",
         "piece 1: Points: offset 7 is behind the end of the appended data.");
  refuse("format=\"ascii\"", "format=\"binary\"",
         "piece 1: Points: the data is no code in base 64.");
}

/** Replaces, removes or repeats a few pieces of a text. */
std::string damage(std::string text, std::mt19937 &random) {
  const auto below = [&](const std::size_t n) { return n == 0 ? 0 : random() % n; };
  for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
    const std::size_t at = below(text.size()), length = below(40);
    switch (below(5)) {
    case 0:
      text[at] = "0123456789 .-+e=\"<>/AZ_"[below(23)];
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, text.substr(below(text.size()), length));
      break;
    case 3:
      text.resize(at + 1);
      break;
    default:
      text[at] = static_cast<char>(below(256));
    }
  }
  return text;
}

void test_damage(Checks &checks) {
  std::mt19937 random(3);
  for (const Encoding &encoding : encodings) {
    const std::string text = file_of(encoding);
    for (unsigned int i = 0; i < 1000; ++i) {
      std::string message = "a.vtu: read.";
      try {
        read_vtu(damage(text, random), "a.vtu", "displacement");
      } catch (const InputError &error) {
        message = error.what();
      }
      checks.that("damaged " + encoding.name + " is read or refused in one sentence",
                  message.rfind("a.vtu: ", 0) == 0 && message.back() == '.' &&
                    message.size() < 1000);
    }
  }
  // Sizes that no file holds, and elements in one another.
  std::string deep;
  for (unsigned int i = 0; i < 9000; ++i)
    deep += "<a>";
  checks.throws<InputError>("deep", "a.vtu: ", [&]() { read_vtu(deep, "a.vtu", "displacement"); });
}
} // namespace

int main() {
  return run_tests({test_encodings, test_pieces, test_refusals, test_damage});
}
