// SPDX-License-Identifier: LGPL-2.1-or-later
// Pressure and opening over arc length.

#include <signorini/base/errors.h>
#include <signorini/results/files/files.h>
#include <signorini/results/pictures/pictures.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <iomanip>
#include <limits>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "drawn_cells.h"

namespace Signorini
{
namespace
{
/** The pieces of one contact side, and their name. */
struct DrawnSide
{
  std::string name;
  std::vector<const ContactSegment *> segments;
  bool has_exact_pressure = false;
  bool has_exact_opening = false;
};

std::vector<DrawnSide> sides_of(const Scene<2> &scene, const std::vector<ContactSegment> &line)
{
  std::vector<DrawnSide> sides;
  for (const ContactSegment &segment : line)
  {
    if (sides.empty() || sides.back().segments.front()->side_number != segment.side_number)
      sides.push_back({segment.side, {}, false, scene.exact_displacement != nullptr});
    sides.back().segments.push_back(&segment);
    for (const ContactPoint &point : segment.curve)
      sides.back().has_exact_pressure =
        sides.back().has_exact_pressure || point.p_exact.has_value();
  }
  return sides;
}

/** Returns g - u_n of the exact displacement; NaN where that has no value. */
double exact_opening(const Scene<2> &scene, const ContactPoint &point)
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (scene.exact_displacement == nullptr)
    return unknown;
  try
  {
    dealii::Vector<double> u(2);
    scene.exact_displacement->vector_value(point.x, u);
    return point.g - (u[0] * point.n[0] + u[1] * point.n[1]);
  }
  catch (const InputError &)
  {
    return unknown;
  }
}

/** Returns -p, where zero has no sign. */
double compression(const double p)
{
  return p == 0. ? 0. : -p;
}

/** Writes the curves of a side: s, p_H, recovered and exact pressure, opening, exact opening.
 * Constants jump where two pieces meet, which draws steps. */
void write_data(std::ostream &script,
                const Scene<2> &scene,
                const std::string &name,
                const DrawnSide &side)
{
  constexpr double rounding = 1e-13;
  const double tiny = rounding * scene.geometry.longest_extent();
  script << "$" << name << " << END_OF_DATA\n";
  for (const ContactSegment *segment : side.segments)
    for (const ContactPoint &point : segment->curve)
    {
      const double opening = point.g - point.u_n;
      script << plot_number(point.s) << " " << plot_number(compression(point.p_H)) << " "
             << plot_number(compression(point.p_recovered)) << " "
             << (point.p_exact ? plot_number(compression(*point.p_exact)) : "NaN") << " "
             << plot_number(std::abs(opening) < tiny ? 0. : opening) << " "
             << plot_number(exact_opening(scene, point)) << "\n";
    }
  script << "END_OF_DATA\n";
}

/** Colours the ground where p_H presses. The numbers of objects begin anew with every side. */
void mark_zones(std::ostream &script, const DrawnSide &side, const double max_drawn_pressure)
{
  constexpr double pressing = 1e-10;
  script << "unset object\n";
  bool open = false;
  double start = 0., end = 0.;
  const auto close = [&]() {
    if (open)
      script << "set object rectangle from " << plot_number(start) << ", graph 0 to "
             << plot_number(end) << ", graph 1 behind fillstyle solid noborder fillcolor rgb \""
             << Colour::pale_blue << "\"\n";
    open = false;
  };
  for (const ContactSegment *segment : side.segments)
    for (std::size_t i = 0; i + 1 < segment->curve.size(); ++i)
    {
      const ContactPoint &a = segment->curve[i], &b = segment->curve[i + 1];
      if (-0.5 * (a.p_H + b.p_H) <= pressing * max_drawn_pressure)
        close();
      else
      {
        if (!open)
          start = a.s;
        open = true;
        end = b.s;
      }
    }
  close();
}

/** Returns "$side0 using 1:3 with lines ...". */
std::string curve(const std::string &data,
                  const unsigned int column,
                  const char *style,
                  const char *colour,
                  const std::string &title)
{
  return "$" + data + " using 1:" + std::to_string(column) + " with lines " + style + " lc rgb \"" +
         colour + "\" title " + plot_text(title);
}

void plot_pressure(std::ostream &script, const DrawnSide &side, const std::string &data)
{
  script << "set title " << plot_text("Contact pressure on " + side.name) << "\n"
         << "set ylabel 'contact pressure −p (force/area)'\n"
         << "plot " << curve(data, 2, "lw 1.2", Colour::blue, "p_H") << ", "
         << curve(data, 3, "lw 1.6", Colour::orange, "recovered");
  if (side.has_exact_pressure)
    script << ", " << curve(data, 4, "lw 1.6 dt 2", Colour::black, "exact");
  script << "\n";
}

void plot_opening(std::ostream &script, const DrawnSide &side, const std::string &data)
{
  script << "set title " << plot_text("Opening on " + side.name) << "\n"
         << "set ylabel 'opening g − u_n (length)'\n"
         << "plot " << curve(data, 5, "lw 1.6", Colour::blue, "u_h");
  if (side.has_exact_opening)
    script << ", " << curve(data, 6, "lw 1.6 dt 2", Colour::black, "exact");
  script << "\n";
}
} // namespace

std::vector<ContactSegment> trace_for_pictures(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const Displacement &U,
                                               const Pressure &P)
{
  constexpr std::size_t n_curve_points = 300;
  const std::size_t n_pieces = std::max<std::size_t>(1, multipliers.surface().pieces().size());
  const std::size_t n_parts = 1 + (n_curve_points - 1) / n_pieces;
  return trace_contact_line(space, multipliers, U, P, static_cast<unsigned int>(n_parts));
}

Picture pressure_picture(const Scene<2> &scene, const std::vector<ContactSegment> &line)
{
  const std::vector<DrawnSide> sides = sides_of(scene, line);
  double max_drawn_pressure = 0.;
  for (const ContactSegment &segment : line)
    for (const ContactPoint &point : segment.curve)
      max_drawn_pressure = std::max(max_drawn_pressure, -point.p_H);

  constexpr unsigned int max_columns = 3, width = 560, height = 660;
  const unsigned int n_columns = std::min<unsigned int>(sides.size(), max_columns);
  const unsigned int n_rows = (sides.size() + n_columns - 1) / n_columns;
  std::ostringstream script;
  start_script(script, std::max(720U, width * n_columns), height * n_rows);
  for (std::size_t i = 0; i < sides.size(); ++i)
    write_data(script, scene, "side" + std::to_string(i), sides[i]);
  script << "set lmargin 12\nset rmargin 3\nset key top right\nset yrange [*<0:*]\n"
         << "set multiplot layout " << 2 * n_rows << "," << n_columns << "\n";
  // Row by row: the pressures of some sides, then their openings.
  for (std::size_t first = 0; first < sides.size(); first += n_columns)
    for (const bool opening : {false, true})
      for (std::size_t i = first; i < first + n_columns; ++i)
      {
        if (i >= sides.size())
        {
          script << "set multiplot next\n";
          continue;
        }
        const std::string data = "side" + std::to_string(i);
        mark_zones(script, sides[i], max_drawn_pressure);
        script << "set xlabel "
               << (opening ? plot_text("arc length s along " + sides[i].name + " (length)") : "''")
               << "\nset xrange [" << plot_number(sides[i].segments.front()->curve.front().s) << ":"
               << plot_number(sides[i].segments.back()->curve.back().s) << "]\n";
        if (opening)
          plot_opening(script, sides[i], data);
        else
          plot_pressure(script, sides[i], data);
      }
  script << "unset multiplot\n";
  return {"pressure.svg", "Contact pressure and opening along the contact sides", script.str()};
}

// What the scripts of all pictures have in common.

void start_script(std::ostream &script, const unsigned int width, const unsigned int height)
{
  script << "set terminal svg size " << width << "," << height
         << " font \"sans-serif,13\" background \"white\" noenhanced\n"
            "set encoding utf8\n"
            "set border lc rgb \""
         << Colour::grey
         << "\"\n"
            "set grid lc rgb \"#DDDDDD\" lw 0.5\n"
            "set tics textcolor rgb \""
         << Colour::black
         << "\"\n"
            "set key textcolor rgb \""
         << Colour::black << "\" samplen 2.5\n";
}

std::string plot_number(const double value)
{
  if (!std::isfinite(value))
    return "NaN";
  std::ostringstream text;
  text << std::setprecision(9) << value;
  return text.str();
}

std::string plot_text(const std::string &text)
{
  // Gnuplot replaces nothing in single quotes, but for a quote, which is written twice.
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

// Runs gnuplot.

namespace
{
constexpr const char *not_installed =
  "the program gnuplot was not found; install it (the package gnuplot-nox in Debian) and run "
  "again";

/** A file without a name, in memory: it disappears with its last descriptor, however the run ends.
 */
class NamelessFile
{
public:
  explicit NamelessFile(const char *purpose)
    : descriptor_(memfd_create(purpose, MFD_CLOEXEC))
  {
  }
  ~NamelessFile()
  {
    if (descriptor_ >= 0)
      close(descriptor_);
  }
  NamelessFile(const NamelessFile &) = delete;
  NamelessFile &operator=(const NamelessFile &) = delete;

  int descriptor() const
  {
    return descriptor_;
  }

  /** Writes the text and goes back to the beginning of the file. */
  bool write_all(const std::string &text) const
  {
    for (std::size_t done = 0; done < text.size();)
    {
      const ssize_t n = write(descriptor_, text.data() + done, text.size() - done);
      if (n < 0 && errno == EINTR)
        continue;
      if (n <= 0)
        return false;
      done += static_cast<std::size_t>(n);
    }
    return lseek(descriptor_, 0, SEEK_SET) == 0;
  }

  std::string read_all() const
  {
    std::string text;
    std::array<char, 65536> buffer;
    if (lseek(descriptor_, 0, SEEK_SET) != 0)
      return text;
    for (;;)
    {
      const ssize_t n = read(descriptor_, buffer.data(), buffer.size());
      if (n < 0 && errno == EINTR)
        continue;
      if (n <= 0)
        return text;
      text.append(buffer.data(), static_cast<std::size_t>(n));
    }
  }

private:
  int descriptor_;
};

/** Starts gnuplot without the user's settings (-d). @return 0 or the number of an error. */
int start_gnuplot(const NamelessFile &in,
                  const NamelessFile &out,
                  const NamelessFile &err,
                  pid_t &id)
{
  posix_spawn_file_actions_t files;
  if (const int error = posix_spawn_file_actions_init(&files))
    return error;
  posix_spawn_file_actions_adddup2(&files, in.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, err.descriptor(), STDERR_FILENO);
  std::string name = "gnuplot", option = "-d";
  char *const arguments[] = {name.data(), option.data(), nullptr};
  const int error = posix_spawnp(&id, name.c_str(), &files, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

/** The time after which gnuplot is killed; pictures take seconds. */
constexpr std::chrono::seconds max_wait(60);

enum class End
{
  good,
  bad,
  late
};

/** Waits for the end of a process, which is good with code 0. A process that is late is killed. */
End wait_for(const pid_t id)
{
  const auto deadline = std::chrono::steady_clock::now() + max_wait;
  int status = 0;
  for (pid_t ended = 0; ended != id; ended = waitpid(id, &status, WNOHANG))
  {
    if (ended < 0 && errno != EINTR)
      return End::bad;
    if (std::chrono::steady_clock::now() > deadline)
    {
      kill(id, SIGKILL);
      waitpid(id, &status, 0);
      return End::late;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? End::good : End::bad;
}

/** Returns the last line of gnuplot's messages that is not empty, which names the error. */
std::string last_line(const std::string &text)
{
  constexpr std::size_t longest = 200;
  const std::size_t end = text.find_last_not_of(" \t\n");
  if (end == std::string::npos)
    return "it said nothing";
  const std::size_t before = text.find_last_of('\n', end);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  return text.substr(start, std::min(longest, end + 1 - start));
}

/** Returns a text to stand between tags of XML. */
std::string escaped(const std::string &text)
{
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}
} // namespace

Drawing draw_with_gnuplot(const Picture &picture)
{
  const NamelessFile in("script"), out("picture"), err("complaints");
  if (in.descriptor() < 0 || out.descriptor() < 0 || err.descriptor() < 0 ||
      !in.write_all(picture.script))
    return {"", std::string("there is no room for gnuplot's input: ") + std::strerror(errno)};
  pid_t id = 0;
  const int error = start_gnuplot(in, out, err, id);
  if (error == ENOENT)
    return {"", not_installed};
  if (error != 0)
    return {"", std::string("gnuplot could not be started: ") + std::strerror(error)};
  const End end_of_process = wait_for(id);
  if (end_of_process == End::late)
    return {"",
            "gnuplot did not end within " + std::to_string(max_wait.count()) +
              " seconds and was stopped"};
  std::string svg = out.read_all();
  constexpr const char *own_title = "<title>Gnuplot</title>", *end = "</svg>";
  if (end_of_process == End::bad || svg.find(end) == std::string::npos)
    return {"", "gnuplot failed: " + one_line(last_line(err.read_all()))};
  if (const std::size_t place = svg.find(own_title); place != std::string::npos)
    svg.replace(place, std::strlen(own_title), "<title>" + escaped(picture.title) + "</title>");
  return {svg, ""};
}

std::string write_pictures(const std::filesystem::path &directory,
                           const std::vector<Picture> &pictures)
{
  for (const Picture &picture : pictures)
  {
    const Drawing drawing = draw_with_gnuplot(picture);
    if (!drawing.failure.empty())
      return picture.file + " was not drawn: " + drawing.failure + ".";
    write_file(directory / picture.file, [&](std::ostream &stream) { stream << drawing.svg; });
  }
  return "";
}
} // namespace Signorini
