// SPDX-License-Identifier: LGPL-2.1-or-later
// A scene before it is solved: its sides, its cost, a drawing.

#include <signorini/base/instantiate.h>
#include <signorini/base/message.h>
#include <signorini/base/parallel.h>
#include <signorini/base/text.h>
#include <signorini/discretization/mesh/mesh.h>
#include <signorini/driver/check/show_scene.h>
#include <signorini/driver/study/settings.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/results/output/files.h>
#include <signorini/results/output/pictures.h>
#include <signorini/results/output/scene_json.h>
#include <signorini/results/output/screen.h>
#include <signorini/results/output/tables.h>
#include <signorini/solvers/methods/memory_limit.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** Returns "-1 to 2", or one number. */
std::string range(double low, double high) {
  const double rounding = 1e-12 * std::max(std::abs(low), std::abs(high));
  low = std::abs(low) <= rounding ? 0. : low;
  high = std::abs(high) <= rounding ? 0. : high;
  return number_text(low) + (low < high ? " to " + number_text(high) : "");
}

/** Returns the range of a component of a function at some points, nothing where there is none. */
template <int dim>
std::string range(const FunctionPointer<dim> &function, const std::vector<Point<dim>> &points,
                  const unsigned int component = 0) {
  double low = function->value(points[0], component), high = low;
  for (const Point<dim> &x : points) {
    low = std::min(low, function->value(x, component));
    high = std::max(high, function->value(x, component));
  }
  return range(low, high);
}

/** Returns the ranges of all components, "x: 0, y: -1 to 2". */
template <int dim>
std::string ranges(const FunctionPointer<dim> &function, const std::vector<Point<dim>> &points) {
  std::vector<std::string> texts;
  for (unsigned int c = 0; c < function->n_components; ++c)
    texts.push_back(std::string(1, "xyz"[c]) + ": " + range<dim>(function, points, c));
  return join(texts, ", ");
}

std::string text_of(const double x) {
  return number_text(x);
}
std::string text_of(const Tensor<1, 3> &x) {
  return vector_text(x);
}

/** Returns the motion of a plate: "plate, force 2 along (0, -1), turning". */
template <int dim>
std::string motion_of(const Plate<dim> &plate) {
  return (plate.is_pushed ? "plate, force " + number_text(plate.force)
                          : "plate, travel " + number_text(plate.travel)) +
         " along " + vector_text(plate.direction) +
         (plate.drifts ? ", force across " + text_of(plate.cross_force) : "") +
         (plate.turns ? ", turning" : "");
}

/** Returns the data of a contact: "gap 0 to 0.1, friction coefficient 0.3". */
template <int dim>
std::string data_of(const ContactPair<dim> &pair, const Scene<dim> &scene,
                    const std::vector<Point<dim>> &points) {
  const ContactCondition<dim> &contact = pair.data();
  std::string text = "gap " + range<dim>(contact.gap, points);
  if (pair.other_side())
    text += ", with " + pair.other_name();
  for (const auto &limit : scene.contact_law.limits())
    text += std::string(", ") + limit.name + " " + range<dim>(contact.*limit.data, points);
  if (contact.shift != nullptr)
    text += ", foundation moves " + (contact.shift->n_components == 1
                                       ? range<dim>(contact.shift, points)
                                       : ranges<dim>(contact.shift, points));
  return text;
}

/** Returns the data of a side. */
template <int dim>
std::string data_of(const Scene<dim> &scene, const unsigned int side,
                    const std::vector<Point<dim>> &points) {
  for (const Plate<dim> &plate : scene.plates)
    if (plate.side == side)
      return motion_of(plate);
  const BoundaryCondition<dim> &condition = scene.boundary[side];
  if (condition.role != Role::contact)
    return condition.data == nullptr ? "" : ranges<dim>(condition.data, points);
  std::vector<std::string> texts;
  for (const ContactPair<dim> &pair : contact_pairs(scene))
    if (pair.side() == side)
      texts.push_back(data_of(pair, scene, points));
    else if (pair.other_side() == side)
      texts.push_back("with " + scene.geometry.sides[pair.side()].name());
  return join(texts, "; ");
}

/** Prints a line for every side. */
template <int dim>
void print_sides(const Scene<dim> &scene, std::ostream &screen) {
  const auto point = [rounding = 1e-12 * scene.geometry.diameter()](Point<dim> x) {
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = std::abs(x[d]) < rounding ? 0. : x[d];
    return vector_text(x);
  };
  std::vector<std::vector<std::string>> rows = {
    {"side", "role", "from", "to", dim == 2 ? "length" : "area", "data"}};
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    const Side<dim> &side = scene.geometry.sides[i];
    const std::vector<Point<dim>> points = sample_side(scene, i).points;
    double measure = 1.;
    if constexpr (dim == 2)
      measure = side.length();
    else
      measure = side.area();
    rows.push_back({side.name(), word_for(scene.boundary[i].role), point(points.front()),
                    point(points.back()), number_text(measure), data_of(scene, i, points)});
  }
  print_columns(screen, rows, rows[0].size());
  screen << "\n";
}

/** Returns the numbers of load cases that differ from those of the scene: "53: slide -1 to 1". */
std::string describe_cases(const std::vector<LoadCase> &cases) {
  std::vector<std::string> texts;
  for (const CaseFactor &factor : case_factors()) {
    std::vector<double> values;
    for (const LoadCase &load_case : cases)
      values.push_back(load_case.*factor.number);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (const double of_scene = LoadCase().*factor.number; *low != of_scene || *high != of_scene)
      texts.push_back(factor.name + " " + range(*low, *high));
  }
  return std::to_string(cases.size()) + (texts.empty() ? "" : ": " + join(texts, ", "));
}

/** Returns the loads of the whole body. */
template <int dim>
SceneNotes notes_on(const Parameters &parameters, const Scene<dim> &scene, const Mesh<dim> &mesh) {
  SceneNotes notes;
  if (scene.contact_law.has_tangential_part()) {
    std::string line = "Friction: " + scene.contact_law.name();
    for (const ContactPair<dim> &pair : contact_pairs(scene)) {
      line += ", " + scene.geometry.sides[pair.side()].name();
      for (const auto &limit : scene.contact_law.limits())
        line += " " + range<dim>(pair.data().*limit.data, sample_side(scene, pair.side()).points);
    }
    notes.lines.push_back(line);
  }
  if (const Entry &given = parameters.contact.foundation; given.is_given)
    notes.lines.push_back("Foundation: " + parameters.contact.foundation.value +
                          (scene.foundation_position.norm() > 0.
                             ? ", moved by " + parameters.contact.foundation_position.value
                             : ""));
  if (scene.body_force != nullptr) {
    std::vector<Point<dim>> points;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      points.push_back(cell->center());
    notes.body_force.resize(dim);
    for (unsigned int d = 0; d < dim; ++d)
      for (const Point<dim> &x : points)
        notes.body_force[d] += scene.body_force->value(x, d) / points.size();
    notes.lines.push_back("Body force: " + ranges<dim>(scene.body_force, points));
  }
  if (!scene.load_cases.empty())
    notes.lines.push_back("Load cases: " + describe_cases(scene.load_cases));
  return notes;
}

/** Returns the memory and the number of unknowns that a run may need. */
template <int dim>
std::string cost_of(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator) {
  const DiscretizationParameters &given = parameters.discretization;
  if (given.strategy == Strategy::hp)
    return "graded meshes of 1e4 to 1e5 unknowns, at most " +
           std::to_string(given.maximum_unknowns);
  const MemoryLimit<dim> limit(parameters, scene, communicator);
  return limit.forecast() + "; about " + number_text(limit.n_unknowns()) + " unknowns";
}

/** Returns the aspect ratio of cells in space, ", edges of one cell up to 2 : 1", and what it
 * costs.
 */
template <int dim>
std::string describe_aspect(const Triangulation<dim> &mesh, const SolverChoice &solvers) {
  constexpr double many_cycles = 3.;
  if (dim == 2)
    return "";
  const double aspect = largest_aspect(mesh);
  return ", edges of one cell up to " + number_text(std::round(10. * aspect) / 10.) + " : 1" +
         (aspect > many_cycles && solvers.is_by_cycles()
            ? " (above 3 : 1 V-cycles are many; make cells about as long as wide)"
            : "");
}
} // namespace

template <int dim>
void show_scene(const Parameters &parameters, Scene<dim> scene, MPI_Comm communicator,
                const StudyReport &report) {
  const DiscretizationParameters &given = parameters.discretization;
  check_settings(parameters, scene);
  const SolverChoice solvers = choose_solvers(parameters, scene, given.finest_level);
  print_scene(parameters, scene, solvers, judge_of(parameters, scene), report.screen);
  const std::string cost = cost_of(parameters, scene, communicator);
  const Mesh<dim> mesh(scene.geometry, given.coarsest_level, given.coarsest_level, MPI_COMM_SELF);
  multiply_forces(scene.geometry.thickness, scene.plates);
  const SceneNotes notes = notes_on(parameters, scene, mesh);
  print_sides(scene, report.screen);
  for (const std::string &line : notes.lines)
    report.screen << line << ".\n";
  report.screen << "First mesh: " << mesh.triangulation().n_global_active_cells() << " cells"
                << describe_aspect(mesh.triangulation(), solvers) << ".\n"
                << "Cost: " << cost << ".\n";
  agree(communicator, [&]() {
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    write_file(report.directory / "scene.json", [&](std::ostream &stream) {
      write_scene_json(stream, scene, mesh.triangulation(), notes);
    });
    const std::string missing = draw_pictures(report.directory, "--scene");
    report.screen << "Picture: "
                  << (missing.empty() ? (report.directory / "scene.svg").string() : missing)
                  << "\n";
  });
}

INSTANTIATE_FUNCTION(show_scene);
} // namespace Signorini
