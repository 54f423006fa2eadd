// SPDX-License-Identifier: LGPL-2.1-or-later
// A scene before it is solved: its sides, what it may cost, a drawing.

#include <signorini/base/instantiate.h>
#include <signorini/base/parallel.h>
#include <signorini/base/text.h>
#include <signorini/discretization/mesh/mesh.h>
#include <signorini/driver/check/show_scene.h>
#include <signorini/results/files/files.h>
#include <signorini/results/files/scene_json.h>
#include <signorini/results/output/pictures.h>
#include <signorini/results/output/screen.h>
#include <signorini/solvers/methods/contact_method.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Signorini {
namespace {
/** Seconds for each unknown of nested levels, by doc/measured/cost_levels.csv. */
constexpr double seconds_per_unknown = 9e-6;

/** Returns "-1 to 2", or one number. */
std::string range(const SideSamples &samples, const unsigned int component) {
  double low = samples.values[0][component], high = low;
  for (const std::vector<double> &values : samples.values) {
    low = std::min(low, values[component]);
    high = std::max(high, values[component]);
  }
  return number_text(low) + (low < high ? " to " + number_text(high) : "");
}

/** Returns what is prescribed on a side: "gap 0 to 0.1". */
std::string data_of(const Scene<2> &scene, const unsigned int side, const SideSamples &samples) {
  for (const Plate &plate : scene.plates)
    if (plate.side == side)
      return (plate.is_pushed
                ? "plate, force " + number_text(plate.force * scene.geometry.thickness)
                : "plate, travel " + number_text(plate.travel)) +
             " along (" + number_text(plate.direction[0]) + ", " + number_text(plate.direction[1]) +
             ")" +
             (plate.drifts
                ? ", force across " + number_text(plate.cross_force * scene.geometry.thickness)
                : "") +
             (plate.turns ? ", turning" : "");
  if (samples.values[0].empty())
    return "";
  const auto opposite = scene.boundary[side].opposite;
  const std::string with = opposite ? ", with " + scene.geometry.sides[*opposite].name() : "";
  return samples.values[0].size() == 1 ? "gap " + range(samples, 0) + with
                                       : "x: " + range(samples, 0) + ", y: " + range(samples, 1);
}

/** Prints a line for every side. */
void print_sides(const Scene<2> &scene, std::ostream &screen) {
  const auto point = [rounding = 1e-12 * scene.geometry.diameter()](const Point<2> &x) {
    const auto text = [&](const double c) { return number_text(std::abs(c) < rounding ? 0. : c); };
    return "(" + text(x[0]) + ", " + text(x[1]) + ")";
  };
  std::size_t width = 12;
  for (const Side<2> &side : scene.geometry.sides)
    width = std::max(width, side.name().size() + 2);
  const auto columns = static_cast<int>(width);
  screen << std::left << std::setw(columns) << "side" << std::setw(14) << "role" << std::setw(20)
         << "from" << std::setw(20) << "to" << std::setw(10) << "length"
         << "data\n";
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    const Side<2> &side = scene.geometry.sides[i];
    const SideSamples samples = sample_side(scene, i);
    screen << std::setw(columns) << side.name() << std::setw(14) << word_for(scene.boundary[i].role)
           << std::setw(20) << point(samples.points.front()) << std::setw(20)
           << point(samples.points.back()) << std::setw(10) << number_text(side.length())
           << data_of(scene, i, samples) << "\n";
  }
  screen << "\n";
}

/** Returns what a run may cost. */
template <int dim>
std::string cost_of(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator) {
  if (parameters.discretization.strategy == Strategy::hp)
    return "graded meshes of 1e4 to 1e5 unknowns and 1 to 30 s for most scenes, at most " +
           std::to_string(parameters.discretization.maximum_unknowns) + " unknowns";
  const MemoryLimit<dim> limit(parameters, scene, communicator);
  const double n = limit.n_unknowns(), all = n / (1. - std::pow(0.5, dim));
  return limit.forecast() + "; about " + number_text(n) + " unknowns and " +
         number_text(std::ceil(all * seconds_per_unknown * 10.) / 10.) + " s";
}
} // namespace

template <int dim>
void show_scene(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator,
                const StudyReport &report) {
  const DiscretizationParameters &given = parameters.discretization;
  check_settings(parameters, scene);
  print_scene(parameters, scene, choose_solvers(parameters, scene, given.finest_level),
              judge_of(parameters, scene), report.screen);
  const std::string cost = cost_of(parameters, scene, communicator);
  const Mesh<dim> mesh(scene.geometry, given.coarsest_level, given.coarsest_level, MPI_COMM_SELF);
  if constexpr (dim == 2)
    print_sides(scene, report.screen);
  report.screen << "First mesh: " << mesh.triangulation().n_global_active_cells() << " cells.\n"
                << "Cost: " << cost << ".\n";
  if constexpr (dim == 2)
    agree(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      write_file(report.directory / "scene.json", [&](std::ostream &stream) {
        write_scene_json(stream, scene, mesh.triangulation());
      });
      const std::string missing = draw_pictures(report.directory, "--scene");
      report.screen << "Picture: "
                    << (missing.empty() ? (report.directory / "scene.svg").string() : missing)
                    << "\n";
    });
}

INSTANTIATE_FUNCTION(show_scene);
} // namespace Signorini
