// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>

#include <string>

#include "tests.h"

/** A displacement that another program computed, its scene, and numbers of it from exact
 * integration, by a program of its own. */
struct VerifiedFile {
  std::string name;
  /** The scene: a file of prm, or assignments "Subsection/Parameter=value". */
  std::string prm;
  std::vector<std::string> settings;
  double strain, load, distance, factor;
};

inline const std::vector<VerifiedFile> verified_files = {
  {"a1_tri3",
   "described_a1.prm",
   {},
   6.4313877247e-01,
   6.3707842165e-01,
   1.7229088432e-01,
   1.0008960},
  {"a1_quad9",
   "described_a1.prm",
   {},
   6.7395805243e-01,
   6.6733114415e-01,
   3.5568729197e-03,
   1.0000035},
  {"ring_quad9",
   "",
   {"Geometry/Shape=ring", "Geometry/Radius=2", "Geometry/Inner radius=1",
    "Material/Young's modulus=2.5", "Material/Poisson's ratio=0.25", "Boundary/Clamped=inner",
    "Boundary/Contact=outer", "Contact/Gap=-0.1"},
   3.7696728153e-01,
   0.,
   5.8973480465e-03,
   0.9999855},
  {"block_tri6",
   "",
   {"Geometry/Lower left=-1, 0", "Geometry/Cells=2, 1", "Boundary/Displacement=top: 0; -0.05",
    "Boundary/Contact=bottom", "Contact/Gap=x^2/4"},
   1.9425273287e-03,
   0.,
   2.490575393e-03,
   1.0151046},
  {"beam_quad8",
   "",
   {"Geometry/Upper right=8, 1", "Geometry/Cells=8, 1", "Material/Young's modulus=1000",
    "Material/Plane state=stress", "Boundary/Clamped=left", "Boundary/Contact=bottom",
    "Boundary/Traction=top: 0; -0.1*sin(pi*x/8)", "Contact/Gap=0.1"},
   1.3313490826e-02,
   2.6488676703e-02,
   7.66836018e-03,
   1.0128120}};

inline std::string path_of(const VerifiedFile &file) {
  return SOURCE_DIR "/tests/error_control/verify/" + file.name + ".vtu";
}

inline Signorini::Parameters parameters_of(const VerifiedFile &file,
                                           std::vector<std::string> more = {}) {
  more.insert(more.begin(), file.settings.begin(), file.settings.end());
  return file.prm.empty() ? Signorini::parse_parameters("", "test", more)
                          : Signorini::read_parameters(SOURCE_DIR "/prm/" + file.prm, more);
}
