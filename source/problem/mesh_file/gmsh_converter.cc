// SPDX-License-Identifier: LGPL-2.1-or-later
// Gmsh's program as a converter, in a process of its own, so that it cannot harm this one.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/mesh_file/file_geometry.h>
#include <signorini/problem/parameters/parameter_text.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Signorini {
namespace {
constexpr rlim_t max_seconds = 30, max_memory = 4ULL << 30, max_mesh_size = 500000000;

/** How the files of each kind begin, behind blanks; a script has no sign. Gmsh runs other kinds as
 * scripts. */
using Signs = std::map<std::string, std::vector<std::string>>;
const Signs shapes = {{"geo", {}},
                      {"step", {"ISO-10303-21"}},
                      {"stp", {"ISO-10303-21"}},
                      {"iges", {}},
                      {"igs", {}},
                      {"brep", {"DBRep_DrawableShape", "CASCADE Topology"}}};
const std::vector<std::string> nastran = {"$", "SOL", "CEND", "BEGIN BULK", "GRID"};
const Signs meshes = {{"msh", {"$"}},
                      {"unv", {"-1"}},
                      {"bdf", nastran},
                      {"nas", nastran},
                      {"mesh", {"MeshVersionFormatted"}},
                      {"vtk", {"# vtk DataFile"}},
                      {"med", {"\x89HDF"}}};

/** Returns whether a text begins like files with this ending. */
bool begins_like(const std::string &ending, const std::string &text) {
  // Lines of IGES files have the letter of their section in column 73.
  constexpr std::size_t column = 72;
  if (ending == "iges" || ending == "igs")
    return text.find_first_of("\r\n") > column && text.compare(column, 1, "S") == 0;
  const std::vector<std::string> &signs = (shapes.count(ending) > 0 ? shapes : meshes).at(ending);
  const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  return std::any_of(signs.begin(), signs.end(), [&](const std::string &sign) {
    return text.compare(start, sign.size(), sign) == 0;
  });
}

/** Waits for the end of a process. @return its status, as of waitpid(); -1 if there is none. */
int wait_for(const pid_t child) {
  int status = -1;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/** A folder that a process of its own removes with all that it contains, also where this process
 * is ended. */
struct TemporaryFolder {
  explicit TemporaryFolder(const std::string &where) {
    std::string name = (std::filesystem::temp_directory_path() / "signorini-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw input_error(where, "no temporary folder can be made in ",
                        std::filesystem::temp_directory_path().string(), ".");
    path = name;
    // No signal ends the remover; it waits for the end of the pipe, which this process holds open.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) == 0)
      remover = fork();
    if (remover == 0) {
      close(ends[1]);
      char nothing;
      while (read(ends[0], &nothing, 1) > 0) {
      }
      remove();
      _exit(0);
    }
    close(ends[0]);
    life = ends[1];
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;
  ~TemporaryFolder() {
    close(life);
    wait_for(remover);
    remove();
  }

  void remove() const {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }

  std::filesystem::path path;
  pid_t remover = -1;
  int life = -1;
};

/** Returns a script with blanks instead of its comments. Where it is not certain that a comment is
 * none of a text between quotation marks, it stays, and so do all that follow. */
std::string without_comments(std::string text) {
  char quote = 0;
  const bool is_plain = text.find('\0') == std::string::npos;
  for (std::size_t i = 0; is_plain && i < text.size(); ++i) {
    const char c = text[i];
    const bool is_quote = c == '"' || c == '\'';
    if (quote != 0 && c != quote && (is_quote || c == '\\' || c == '\n'))
      break;
    if (is_quote)
      quote = quote == 0 ? c : 0;
    const char next = i + 1 < text.size() ? text[i + 1] : ' ';
    if (quote != 0 || c != '/' || (next != '/' && next != '*'))
      continue;
    const std::size_t end = next == '/' ? std::min(text.find_first_of("\r\n", i), text.size())
                                        : std::min(text.find("*/", i + 2), text.size() - 2) + 2;
    std::replace_if(
      text.begin() + i, text.begin() + end, [](const char any) { return any != '\n'; }, ' ');
    i = end - 1;
  }
  return text;
}

/** A script is a program: refuses words by which it runs others, or reads and writes files. */
void check_script(const std::string &text, const std::string &where) {
  static const std::vector<std::string> refused = split_words(
    "SystemCall System NonBlockingSystemCall OnelabRun ExternalProcess Include Merge "
    "MergeWithBoundingBox ShapeFromFile Save Print Printf Plugin General CreateDir Error "
    "Sleep ListFromFile FileExists GetEnv ParseString CurrentDirectory CurrentDir "
    "GmshExecutableName Solver PostProcessing Structured");
  std::size_t line = 1;
  std::string word;
  for (const char c : without_comments(text) + "\n") {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += c;
      continue;
    }
    if (std::count(refused.begin(), refused.end(), word) > 0)
      throw input_error(
        where, "found ", quote(word), " in line ", line,
        ", allowed: shapes, sizes and physical groups; statements that run programs "
        "or read or write other files are not run.");
    word.clear();
    line += c == '\n' ? 1 : 0;
  }
}

/** Becomes Gmsh, with limits that it inherits. Only calls that are safe behind fork(). */
[[noreturn]] void become_gmsh(const char *folder, char *const *arguments,
                              char *const *environment) {
  const auto limit = [](const auto resource, const rlim_t most, const rlim_t later = 0) {
    const rlimit both = {most, most + later};
    setrlimit(resource, &both);
  };
  // Behind the soft limit comes SIGXCPU, behind the other one SIGKILL, which may have other
  // reasons.
  limit(RLIMIT_CPU, max_seconds, 1);
  limit(RLIMIT_AS, max_memory);
  limit(RLIMIT_FSIZE, max_mesh_size);
  limit(RLIMIT_CORE, 0);
  alarm(max_seconds);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int output = chdir(folder) == 0 ? open("log", O_WRONLY | O_CREAT, 0600) : -1;
  const int input = open("/dev/null", O_RDONLY);
  if (output >= 0 && input >= 0 && dup2(input, 0) == 0 && dup2(output, 1) == 1 &&
      dup2(output, 2) == 2)
    execvpe("gmsh", arguments, environment);
  _exit(127);
}

/** Runs Gmsh in a folder. @return its status, as of waitpid(). */
int run_gmsh(const std::string &folder, std::vector<std::string> arguments) {
  const char *const path = std::getenv("PATH");
  std::vector<std::string> environment = {"HOME=" + folder, "LC_ALL=C",
                                          std::string("PATH=") + (path == nullptr ? "" : path)};
  const auto pointers = [](std::vector<std::string> &texts) {
    std::vector<char *> found;
    for (std::string &text : texts)
      found.push_back(text.data());
    found.push_back(nullptr);
    return found;
  };
  const std::vector<char *> argv = pointers(arguments), envp = pointers(environment);
  const pid_t child = fork();
  if (child == 0)
    become_gmsh(folder.c_str(), argv.data(), envp.data());
  return wait_for(child);
}

/** Returns the reason why Gmsh made no mesh, with its first complaint. */
std::string describe_failure(const int status, const std::filesystem::path &log) {
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU || signal == SIGALRM)
    return "Gmsh did not end within " + std::to_string(max_seconds) + " seconds";
  if (signal == SIGKILL)
    return "Gmsh was killed, by a user or for want of memory";
  std::ifstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("Error", 0) == 0) {
      std::replace_if(
        line.begin(), line.end(), [](const unsigned char c) { return std::isprint(c) == 0; }, '?');
      return "Gmsh says " + quote(trim(line.substr(std::min(line.size(), line.find(':') + 1))));
    }
  return signal != 0 ? "Gmsh ended with the signal " + std::to_string(signal)
                     : "Gmsh made no mesh of it";
}
} // namespace

bool is_gmsh_ending(const std::string &ending) {
  return shapes.count(ending) + meshes.count(ending) > 0;
}

std::string convert_with_gmsh(const std::string &content, const std::string &ending,
                              const unsigned int dim, const double mesh_size,
                              const std::string &where) {
  if (ending == "msh" && content.rfind("$MeshFormat", 0) != 0 && content.rfind("$NOD", 0) != 0)
    throw input_error(where,
                      "found no $MeshFormat at its beginning, allowed: a mesh file of Gmsh.");
  const bool is_shape = shapes.count(ending) > 0;
  if (!begins_like(ending, content))
    check_script(content, where);
  const TemporaryFolder folder(where);
  const std::string input = "part." + ending;
  std::ofstream(folder.path / input, std::ios::binary) << content;
  std::vector<std::string> arguments = {"gmsh", input};
  const std::string mesh_option = dim == 2 ? "-2" : "-3";
  if (is_shape) {
    arguments.insert(arguments.end(), {mesh_option, "-order", "2"});
    // Tetrahedra at facets of more than 30 degrees would fold with all vertices on a round side.
    if (dim == 3)
      arguments.insert(arguments.end(), {"-clcurv", "12"});
  } else
    arguments.emplace_back("-save");
  std::vector<std::string> options = {"Mesh.SaveAll 1", "Mesh.Binary 0"};
  // Algorithm 6, blossom and a division of all cells give quadrilaterals for every outline that was
  // tried; algorithm 8 crashes in Gmsh 4.8.4, and sizes by curvature may not end. In space
  // quadrilaterals beside tetrahedra would need pyramids.
  if (dim == 2)
    options.insert(options.end(),
                   {"Mesh.Algorithm 6", "Mesh.RecombineAll 1", "Mesh.SubdivisionAlgorithm 1"});
  for (const std::string &option : options) {
    arguments.emplace_back("-setnumber");
    for (const std::string &word : split_words(option))
      arguments.push_back(word);
  }
  if (mesh_size > 0.)
    arguments.insert(arguments.end(), {"-clmax", number_text(mesh_size)});
  arguments.insert(arguments.end(),
                   {"-nopopup", "-nt", "1", "-v", "2", "-format", "msh41", "-o", "result.msh"});
  const int status = run_gmsh(folder.path.string(), arguments);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    throw input_error(where, "files of this kind are read by Gmsh, and no program gmsh is found, "
                             "allowed: to install it (Debian: apt install gmsh), or a mesh file of "
                             "text of Gmsh, version 2 or 4.1.");
  // After an error Gmsh writes an empty mesh, without elements.
  const std::string result = (folder.path / "result.msh").string();
  std::error_code error;
  std::string text;
  if (status == 0 && std::filesystem::exists(result, error))
    text = read_whole_file(result, where, "mesh file", max_mesh_size);
  if (text.find("$Elements") == std::string::npos)
    throw input_error(where, describe_failure(status, folder.path / "log"),
                      ", allowed: a file from which Gmsh makes a mesh (gmsh ", mesh_option, ").");
  const std::string end_of_format = "$EndMeshFormat\n", mark = conversion_section;
  return text.insert(text.find(end_of_format) + end_of_format.size(),
                     mark + "\n$End" + mark.substr(1) + "\n");
}
} // namespace Signorini
