// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures are drawn by a script of their own from the files of the run.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/results/output/pictures.h>

#include <array>
#include <cstdio>
#include <sys/wait.h>

namespace Signorini {
namespace {
/** Returns a word of the shell: in single quotes all characters but these stand for themselves. */
std::string shell_word(const std::string &text) {
  std::string word = "'";
  for (const char c : text)
    word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

/** Returns the last line, which has the reason of a failure. */
std::string last_line(const std::string &text) {
  const std::string trimmed = trim(text);
  return trimmed.substr(trimmed.rfind('\n') + 1);
}
} // namespace

std::string draw_pictures(const std::filesystem::path &directory, const std::string &option) {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string command = shell_word(program.parent_path() / "signorini-plot") + " " + option +
                              " " + shell_word(directory);
  std::FILE *const pipe = popen(("timeout 300 " + command + " 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 4096> buffer;
  while (pipe != nullptr && std::fgets(buffer.data(), buffer.size(), pipe) != nullptr)
    output += buffer.data();
  const int status = pipe != nullptr ? pclose(pipe) : -1;
  if (status == 0)
    return "";
  // The shell and timeout end with 127 if there is no such program, and so does the script without
  // the package; timeout ends with 124 if it is late.
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  const std::string reason =
    code == 127   ? "Python's matplotlib is missing (the package python3-matplotlib in Debian)"
    : code == 124 ? "signorini-plot took longer than five minutes"
                  : "signorini-plot failed: " + shorten(one_line(last_line(output)));
  return "not drawn, because " + reason + "; draw them later with " + command + ".";
}
} // namespace Signorini
