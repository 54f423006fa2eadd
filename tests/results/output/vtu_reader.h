// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/utilities.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>
#include <zlib.h>

/** One entry per point, with all components. */
using PointField = std::vector<std::vector<float>>;

inline std::vector<unsigned char> decode(const std::string &base_64) {
  return dealii::Utilities::decode_base64(base_64);
}

/**
 * A field of 32-bit floats of a VTU file by its name, "" for the points themselves; empty if there
 * is none. Follows the description of the format: a header of four numbers (blocks, size of a block
 * and of the last one, compressed size) and the block, both in base 64. Knows files of one piece.
 */
inline PointField read_vtu_field(const std::string &text, const std::string &name) {
  const std::string start = name.empty() ? "<DataArray type=\"Float32\" NumberOfComponents=\""
                                         : "<DataArray type=\"Float32\" Name=\"" + name + "\"";
  const std::size_t found = text.find(start);
  if (found == std::string::npos)
    return {};
  const std::size_t data = text.find(">\n", found) + 2, end = text.find('\n', data);
  const std::string components = "NumberOfComponents=\"";
  const std::size_t number = text.find(components, found);
  const std::size_t n = number < data ? std::stoul(text.substr(number + components.size())) : 1;

  std::uint32_t header[4];
  const auto header_bytes = decode(text.substr(data, 24));
  std::memcpy(header, header_bytes.data(), sizeof(header));
  const auto compressed = decode(text.substr(data + 24, end - data - 24));
  std::vector<float> values(header[1] / sizeof(float));
  uLongf size = header[1];
  if (header[0] != 1 || compressed.size() < header[3] ||
      uncompress(reinterpret_cast<Bytef *>(values.data()), &size, compressed.data(), header[3]) !=
        Z_OK ||
      size != header[1])
    return {};
  PointField field;
  for (std::size_t i = 0; i + n <= values.size(); i += n)
    field.emplace_back(values.begin() + i, values.begin() + i + n);
  return field;
}
