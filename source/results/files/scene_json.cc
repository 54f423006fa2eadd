// SPDX-License-Identifier: LGPL-2.1-or-later
// scene.json: what is known of a scene before it is solved.

#include <signorini/postprocessing/quantities/answer_vector.h>
#include <signorini/results/files/scene_json.h>

#include <nlohmann/json.hpp>

#include "answer_json.h"

namespace Signorini {
SideSamples sample_side(const Scene<2> &scene, const unsigned int side) {
  constexpr unsigned int n_intervals = 64;
  const Side<2> &curve = scene.geometry.sides[side];
  const FunctionPointer<2> &data = scene.boundary[side].data;
  SideSamples samples;
  for (unsigned int i = 0; i <= n_intervals; ++i) {
    const double s = i * curve.length() / n_intervals;
    samples.points.push_back(curve.point(s));
    samples.normals.push_back(curve.normal(s));
    samples.values.emplace_back();
    if (data != nullptr)
      for (unsigned int c = 0; c < data->n_components; ++c)
        samples.values.back().push_back(data->value(samples.points.back(), c));
  }
  return samples;
}

void write_scene_json(std::ostream &stream, const Scene<2> &scene,
                      const Triangulation<2> &first_mesh) {
  Json json = {{"sides", Json::array()}, {"cells", Json::array()}};
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    const SideSamples samples = sample_side(scene, i);
    Json side = {{"name", scene.geometry.sides[i].name()},
                 {"role", word_for(scene.boundary[i].role)}};
    if (const auto opposite = scene.boundary[i].opposite)
      side["opposite"] = scene.geometry.sides[*opposite].name();
    for (std::size_t k = 0; k < samples.points.size(); ++k) {
      side["points"].push_back(AnswerVector(samples.points[k]));
      side["normals"].push_back(AnswerVector(samples.normals[k]));
      side["values"].push_back(samples.values[k]);
    }
    for (const Plate &plate : scene.plates)
      if (plate.side == i)
        side["plate"] = {
          {"direction", AnswerVector(plate.direction)},
          {"force", plate.is_pushed ? Json(plate.force * scene.geometry.thickness) : Json(nullptr)},
          {"travel", plate.is_pushed ? Json(nullptr) : Json(plate.travel)},
          {"cross_force", plate.cross_force * scene.geometry.thickness}};
    json["sides"].push_back(side);
  }
  for (const auto &cell : first_mesh.active_cell_iterators()) {
    Json corners = Json::array();
    for (const unsigned int v : {0U, 1U, 3U, 2U})
      corners.push_back(AnswerVector(cell->vertex(v)));
    json["cells"].push_back(corners);
  }
  stream << json.dump() << "\n";
}
} // namespace Signorini
