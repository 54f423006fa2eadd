// SPDX-License-Identifier: LGPL-2.1-or-later
// scene.json: a scene before it is solved.

#include <signorini/base/instantiate.h>
#include <signorini/postprocessing/quantities/answer_vector.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/results/output/scene_json.h>

#include <deal.II/base/geometry_info.h>

#include <nlohmann/json.hpp>

#include <array>
#include <utility>

namespace Signorini {
using Json = nlohmann::ordered_json;

namespace {
/** Returns equally spaced points of a side, its ends included. */
std::vector<SurfacePoint<2>> points_on(const Side<2> &side) {
  constexpr unsigned int n_intervals = 64;
  std::vector<SurfacePoint<2>> found;
  for (unsigned int i = 0; i <= n_intervals; ++i) {
    const double s = i * side.length() / n_intervals;
    found.push_back({side.point(s), side.normal(s)});
  }
  return found;
}
std::vector<SurfacePoint<3>> points_on(const Side<3> &side) {
  return side.samples();
}
} // namespace

template <int dim>
SideSamples<dim> sample_side(const Scene<dim> &scene, const unsigned int side) {
  AssertIndexRange(side, scene.boundary.size());
  FunctionPointer<dim> data = scene.boundary[side].data;
  for (const ContactCondition<dim> &contact : scene.contacts)
    if (contact.side == side && data == nullptr)
      data = contact.gap;
  SideSamples<dim> samples;
  for (const SurfacePoint<dim> &point : points_on(scene.geometry.sides[side])) {
    samples.points.push_back(point.x);
    samples.normals.push_back(point.n);
    samples.values.emplace_back();
    if (data != nullptr)
      for (unsigned int c = 0; c < data->n_components; ++c)
        samples.values.back().push_back(data->value(samples.points.back(), c));
  }
  return samples;
}

INSTANTIATE_FUNCTION(sample_side);

void write_scene_json(std::ostream &stream, const Scene<2> &scene,
                      const Triangulation<2> &first_mesh, const SceneNotes &notes) {
  Json json = {{"sides", Json::array()},
               {"cells", Json::array()},
               {"notes", notes.lines},
               {"body_force", notes.body_force}};
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    const SideSamples<2> samples = sample_side(scene, i);
    Json side = {{"name", scene.geometry.sides[i].name()},
                 {"role", word_for(scene.boundary[i].role)}};
    std::vector<std::string> opposite;
    const ContactPair<2> *first = nullptr;
    const std::vector<ContactPair<2>> pairs = contact_pairs(scene);
    for (const ContactPair<2> &pair : pairs) {
      if (pair.side() == i && pair.other_side())
        opposite.push_back(pair.other_name());
      if (pair.other_side() == i)
        opposite.push_back(scene.geometry.sides[pair.side()].name());
      if (pair.side() == i && first == nullptr)
        first = &pair;
    }
    if (!opposite.empty())
      side["opposite"] = opposite;
    for (std::size_t k = 0; k < samples.points.size(); ++k) {
      side["points"].push_back(AnswerVector(samples.points[k]));
      side["normals"].push_back(AnswerVector(samples.normals[k]));
      side["values"].push_back(samples.values[k]);
      if (first != nullptr && !first->data().directions.are_normals())
        side["directions"].push_back(AnswerVector(first->direction(samples.points[k])));
    }
    for (const Plate<2> &plate : scene.plates)
      if (plate.side == i)
        side["plate"] = {{"direction", AnswerVector(plate.direction)},
                         {"force", plate.is_pushed ? Json(plate.force) : Json(nullptr)},
                         {"travel", plate.is_pushed ? Json(nullptr) : Json(plate.travel)},
                         {"cross_force", plate.cross_force}};
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

void write_scene_json(std::ostream &stream, const Scene<3> &scene,
                      const Triangulation<3> &first_mesh, const SceneNotes &notes) {
  std::vector<Json> faces(scene.boundary.size(), Json::array());
  for (const auto &cell : first_mesh.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f)) {
        // Round the outward normal: that of every other face of a cell points inwards.
        Json corners = Json::array();
        for (const unsigned int v : f % 2 == 0 ? std::array<unsigned int, 4>{{0, 2, 3, 1}}
                                               : std::array<unsigned int, 4>{{0, 1, 3, 2}})
          corners.push_back(
            AnswerVector(cell->vertex(GeometryInfo<3>::face_to_cell_vertices(f, v))));
        faces[cell->face(f)->boundary_id()].push_back(corners);
      }
  Json json = {{"sides", Json::array()}, {"notes", notes.lines}, {"body_force", notes.body_force}};
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    json["sides"].push_back({{"name", scene.geometry.sides[i].name()},
                             {"role", word_for(scene.boundary[i].role)},
                             {"faces", std::move(faces[i])}});
  stream << json.dump() << "\n";
}
} // namespace Signorini
