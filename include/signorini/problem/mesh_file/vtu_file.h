// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Signorini {
/** The cells of a file of VTK with one field at their points; those of all pieces one after the
 * other. */
struct VtuMesh {
  struct Cell {
    /** VTK's number of its kind: 5 is a triangle. */
    unsigned int type;
    /** The indices of its points, in VTK's order. */
    std::vector<unsigned int> points;
  };

  /** The name of the file in messages. */
  std::string name;
  std::vector<Point<3>> points;
  std::vector<Cell> cells;
  /** The number of components of the field, and its values point by point. */
  unsigned int n_components = 0;
  std::vector<double> values;
};

/**
 * Reads an unstructured grid in VTK's XML format (ending .vtu): numbers as text, in base 64 or
 * appended, also compressed by zlib, in both byte orders.
 * @param name the name of the file in messages.
 * @param field the name of the field among the point data.
 * @throws InputError with the piece and the array for everything else, and for sizes that the file
 * does not hold.
 */
VtuMesh read_vtu(const std::string &text, const std::string &name, const std::string &field);
} // namespace Signorini
