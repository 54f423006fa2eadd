// SPDX-License-Identifier: LGPL-2.1-or-later
// What the scripts of all pictures have in common.

#include <signorini/base/errors.h>
#include <signorini/results/files/files.h>
#include <signorini/results/pictures/gnuplot.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <iomanip>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "gnuplot_internal.h"

namespace Signorini
{
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
constexpr std::chrono::seconds longest_wait(60);

enum class End
{
  good,
  bad,
  late
};

/** Waits for the end of a process, which is good with code 0. A process that is late is killed. */
End wait_for(const pid_t id)
{
  const auto deadline = std::chrono::steady_clock::now() + longest_wait;
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
            "gnuplot did not end within " + std::to_string(longest_wait.count()) +
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
