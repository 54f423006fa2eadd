// SPDX-License-Identifier: LGPL-2.1-or-later
// Unstructured grids in VTK's XML format.

#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/mesh_file/vtu_file.h>

#include <deal.II/base/utilities.h>

#include <boost/endian/conversion.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <zlib.h>

namespace Signorini {
namespace {
using Tree = boost::property_tree::ptree;
using Numbers = std::vector<double>;

/** A defect, to which the file and the piece are added. */
using Defect = std::runtime_error;

std::string attribute(const Tree &element, const std::string &name) {
  return element.get("<xmlattr>." + name, "");
}

std::size_t count_in(const Tree &element, const std::string &name) {
  constexpr double most = 1e9;
  double number = -1.;
  const std::string text = attribute(element, name);
  if (!read_number(text, number) || number < 0. || number > most || number != std::floor(number))
    throw Defect(name + ": found " + quote(text) + ", allowed: a whole number below 1e9.");
  return static_cast<std::size_t>(number);
}

/** Returns the bytes of codes in base 64, each with padding at its end. */
std::string decoded(const std::string &text) {
  std::string bytes;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    end = std::min(text.find('=', at), text.size() - 1) / 4 * 4 + 4;
    try {
      if (end > text.size())
        throw Defect("A group of four characters is cut.");
      const std::vector<unsigned char> part = Utilities::decode_base64(text.substr(at, end - at));
      bytes.append(part.begin(), part.end());
    } catch (const std::exception &) {
      throw Defect("the data is no code in base 64.");
    }
  }
  return bytes;
}

/** Takes binary numbers and blocks from the front of a text of bytes. */
class ByteReader {
public:
  ByteReader(std::string bytes, const bool is_big_endian)
    : bytes_(std::move(bytes))
    , is_big_endian_(is_big_endian) {}

  std::string take(const std::size_t n) {
    if (n > bytes_.size() - at_)
      throw Defect("the data ends too early.");
    at_ += n;
    return bytes_.substr(at_ - n, n);
  }
  template <typename T>
  T number() {
    std::string bytes = take(sizeof(T));
    if (is_big_endian_ == (boost::endian::order::native == boost::endian::order::little))
      std::reverse(bytes.begin(), bytes.end());
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }
  template <typename T>
  Numbers all() {
    Numbers numbers;
    while (at_ < bytes_.size())
      numbers.push_back(static_cast<double>(number<T>()));
    return numbers;
  }

private:
  std::string bytes_;
  bool is_big_endian_;
  std::size_t at_ = 0;
};

Numbers numbers_of(const std::string &type, ByteReader bytes) {
  using Read = Numbers (ByteReader::*)();
  static const std::map<std::string, Read> types = {
    {"Float64", &ByteReader::all<double>},     {"Float32", &ByteReader::all<float>},
    {"Int64", &ByteReader::all<std::int64_t>}, {"UInt64", &ByteReader::all<std::uint64_t>},
    {"Int32", &ByteReader::all<std::int32_t>}, {"UInt32", &ByteReader::all<std::uint32_t>},
    {"Int16", &ByteReader::all<std::int16_t>}, {"UInt16", &ByteReader::all<std::uint16_t>},
    {"Int8", &ByteReader::all<std::int8_t>},   {"UInt8", &ByteReader::all<std::uint8_t>}};
  const auto found = types.find(type);
  if (found == types.end())
    throw Defect("found the type " + quote(type) + ", allowed: Float32, Float64, Int8 to UInt64.");
  return (bytes.*found->second)();
}

Numbers numbers_of(const std::string &text) {
  Numbers numbers;
  const char *at = text.c_str();
  for (char *end = nullptr;; at = end) {
    numbers.push_back(std::strtod(at, &end));
    if (end == at)
      break;
  }
  numbers.pop_back();
  if (const std::string rest = trim(at); !rest.empty())
    throw Defect("found " + quote(rest) + ", allowed: numbers.");
  return numbers;
}

/** Reads the pieces of a file. */
class PieceReader {
public:
  PieceReader(const Tree &file, std::string appended, const std::string &field, VtuMesh &mesh)
    : appended_(std::move(appended))
    , is_big_endian_(attribute(file, "byte_order") == "BigEndian")
    , has_long_headers_(attribute(file, "header_type") == "UInt64")
    , is_coded_(file.get("AppendedData.<xmlattr>.encoding", "") == "base64")
    , compressor_(attribute(file, "compressor"))
    , field_(field)
    , mesh_(mesh) {}

  void add(const Tree &piece) {
    const std::size_t n_points = count_in(piece, "NumberOfPoints"),
                      n_cells = count_in(piece, "NumberOfCells"), first = mesh_.points.size();
    if (n_points == 0 || n_cells == 0)
      return;
    const Numbers x = read(piece, "Points", "", 3 * n_points),
                  types = read(piece, "Cells", "types", n_cells),
                  ends = read(piece, "Cells", "offsets", n_cells);
    const double last = std::clamp(ends.back(), 0., 1e9);
    const Numbers entries = read(piece, "Cells", "connectivity", static_cast<std::size_t>(last));
    for (std::size_t i = 0; i < n_points; ++i)
      mesh_.points.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
    for (std::size_t c = 0; c < n_cells; ++c) {
      const double begin = c == 0 ? 0. : ends[c - 1];
      if (!(begin >= 0. && begin <= ends[c] && ends[c] <= last && types[c] >= 0. &&
            types[c] < 256.))
        throw Defect(concatenate("cell ", c, ": its type or its offset is wrong."));
      VtuMesh::Cell &cell = mesh_.cells.emplace_back();
      cell.type = static_cast<unsigned int>(types[c]);
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(ends[c]); ++k) {
        if (!(entries[k] >= 0. && entries[k] < n_points))
          throw Defect(concatenate("cell ", c, ": found the point ", entries[k], ", allowed: 0 to ",
                                   n_points - 1, "."));
        cell.points.push_back(first + static_cast<unsigned int>(entries[k]));
      }
    }
    add_field(piece, n_points);
  }

private:
  /** Returns the array of a part of a piece with this name, or the first one for an empty name;
   * the names of all of them in @p names. */
  static const Tree *find(const Tree &piece, const std::string &part, const std::string &name,
                          std::vector<std::string> &names) {
    const Tree *result = nullptr;
    if (const auto found = piece.get_child_optional(part))
      for (const auto &[tag, array] : *found)
        if (tag == "DataArray") {
          names.push_back(attribute(array, "Name"));
          if (name.empty() || names.back() == name)
            result = &array;
        }
    return result;
  }
  /** Returns the @p n numbers of an array. */
  Numbers read(const Tree &piece, const std::string &part, const std::string &name,
               const std::size_t n) {
    std::vector<std::string> names;
    const Tree *const array = find(piece, part, name, names);
    const std::string where = part + (name.empty() ? "" : ", array " + quote(name)) + ": ";
    if (array == nullptr)
      throw Defect(where + "there is no such array.");
    try {
      Numbers numbers = read(*array);
      if (numbers.size() != n)
        throw Defect(concatenate("found ", numbers.size(), " numbers, allowed: ", n,
                                 " as the numbers of points and cells say."));
      return numbers;
    } catch (const Defect &defect) {
      throw Defect(where + defect.what());
    }
  }
  Numbers read(const Tree &array) const {
    const std::string type = attribute(array, "type"), format = attribute(array, "format");
    std::string data = array.data();
    if (format == "ascii")
      return numbers_of(data);
    if (format == "binary") {
      data.erase(std::remove_if(data.begin(), data.end(),
                                [](const unsigned char c) { return std::isspace(c) != 0; }),
                 data.end());
      data = decoded(data);
    } else if (format == "appended") {
      const std::size_t offset = count_in(array, "offset");
      if (offset > appended_.size())
        throw Defect(concatenate("offset ", offset, " is behind the end of the appended data."));
      data = appended_.substr(offset);
      if (is_coded_)
        data = decoded(trim(data));
    } else
      throw Defect("found the format " + quote(format) + ", allowed: ascii, binary, appended.");
    return numbers_of(type, {content({std::move(data), is_big_endian_}), is_big_endian_});
  }
  /** Returns the bytes behind the header of an array. */
  std::string content(ByteReader bytes) const {
    const auto header = [&]() {
      return has_long_headers_ ? bytes.number<std::uint64_t>() : bytes.number<std::uint32_t>();
    };
    if (compressor_.empty())
      return bytes.take(header());
    if (compressor_ != "vtkZLibDataCompressor")
      throw Defect("found the compressor " + quote(compressor_) +
                   ", allowed: vtkZLibDataCompressor, or no compression.");
    const std::size_t n_blocks = header(), whole = header(), last = header();
    std::vector<std::size_t> sizes;
    while (sizes.size() < n_blocks)
      sizes.push_back(header());
    std::string all;
    for (std::size_t k = 0; k < n_blocks; ++k) {
      const std::string packed = bytes.take(sizes[k]);
      uLongf size = k + 1 == n_blocks && last > 0 ? last : whole;
      // zlib packs at most 1032 bytes into one.
      std::string block(std::min<std::size_t>(size, 1032 * packed.size()), '\0');
      if (uncompress(reinterpret_cast<Bytef *>(block.data()), &(size = block.size()),
                     reinterpret_cast<const Bytef *>(packed.data()), packed.size()) != Z_OK)
        throw Defect("a compressed block is damaged.");
      all += block.substr(0, size);
    }
    return all;
  }
  void add_field(const Tree &piece, const std::size_t n_points) {
    std::vector<std::string> names;
    const Tree *const array = field_.empty() ? nullptr : find(piece, "PointData", field_, names);
    if (array == nullptr)
      throw Defect("found no point data of the name " + quote(field_) +
                   " (Verify/Field), allowed: " + join(names) + ".");
    const std::string text = attribute(*array, "NumberOfComponents");
    const unsigned int n = text == "2" ? 2 : 3;
    if ((text != "2" && text != "3") || (mesh_.n_components != 0 && mesh_.n_components != n))
      throw Defect("the field " + quote(field_) + " has " + quote(text) +
                   " components, allowed: 2 or 3, as many in all pieces.");
    mesh_.n_components = n;
    const Numbers values = read(piece, "PointData", field_, n * n_points);
    mesh_.values.insert(mesh_.values.end(), values.begin(), values.end());
  }

  const std::string appended_;
  const bool is_big_endian_, has_long_headers_, is_coded_;
  const std::string compressor_;
  const std::string &field_;
  VtuMesh &mesh_;
};

void read_file(std::string xml, const std::string &field, VtuMesh &mesh) {
  // Appended data may be binary, which is no XML.
  std::string appended;
  if (const std::size_t tag = xml.find("<AppendedData"); tag != std::string::npos) {
    const std::size_t start = xml.find('_', xml.find('>', tag)), end = xml.rfind("</AppendedData");
    if (start == std::string::npos || end == std::string::npos || end <= start)
      throw Defect("the appended data does not begin with '_', or has no end.");
    appended = xml.substr(start + 1, end - start - 1);
    xml.erase(start, end - start);
  }
  // The parser calls itself for each element in another one: few have room.
  constexpr std::ptrdiff_t most_tags = 10000;
  if (std::count(xml.begin(), xml.end(), '<') > most_tags)
    throw Defect("the file has more than 10000 tags, allowed: fewer pieces.");
  std::istringstream stream(xml);
  Tree tree;
  try {
    boost::property_tree::read_xml(stream, tree);
  } catch (const boost::property_tree::xml_parser_error &error) {
    throw Defect(concatenate("line ", error.line(), ": ", error.message(), "."));
  }
  const auto grid = tree.get_child_optional("VTKFile.UnstructuredGrid");
  if (!grid)
    throw Defect("this is no file of VTK with an UnstructuredGrid, allowed: .vtu.");
  PieceReader reader(tree.get_child("VTKFile"), std::move(appended), field, mesh);
  unsigned int number = 0;
  for (const auto &[name, piece] : *grid)
    if (name == "Piece")
      try {
        ++number;
        reader.add(piece);
      } catch (const Defect &defect) {
        throw Defect(concatenate("piece ", number, ": ", defect.what()));
      }
}
} // namespace

VtuMesh read_vtu(const std::string &text, const std::string &name, const std::string &field) {
  VtuMesh mesh;
  mesh.name = name;
  try {
    read_file(text, field, mesh);
  } catch (const Defect &defect) {
    throw InputError(name + ": " + defect.what());
  }
  if (mesh.cells.empty())
    throw InputError(name + ": the file has no cells.");
  return mesh;
}
} // namespace Signorini
