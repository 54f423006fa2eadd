// SPDX-License-Identifier: LGPL-2.1-or-later
// Every block of wrong_files.txt is refused, with the message that stands there.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameter_text.h>
#include <signorini/verification/catalogue/catalogue.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** A wrong file, as a whole or as settings on top of a good scene. */
struct Block {
  std::string line;
  std::vector<std::string> settings;
  std::string text;
  std::string message;
  /** It shows on a level only. */
  bool late = false;
};

/** \x1b stands for a character that cannot be written in a table, {200*(} for many. */
std::string unescape(const std::string &text) {
  static const std::regex repetition(R"(\{(\d+)\*([^}]*)\})"), character(R"(\\x(..))");
  std::string plain = text;
  std::smatch match;
  while (std::regex_search(plain, match, repetition)) {
    std::string many;
    for (int i = 0; i < std::stoi(match[1]); ++i)
      many += match[2];
    plain = match.prefix().str() + many + match.suffix().str();
  }
  while (std::regex_search(plain, match, character)) {
    const char c = static_cast<char>(std::stoi(match[1], nullptr, 16));
    plain = match.prefix().str() + c + match.suffix().str();
  }
  return plain;
}

std::vector<Block> read_table(const std::string &file_name) {
  std::ifstream file(file_name);
  std::vector<Block> blocks;
  Block block;
  std::string line;
  for (unsigned int number = 1; std::getline(file, line); ++number) {
    if (line.empty() || line[0] == '#')
      continue;
    if (block.line.empty())
      block.line = "wrong_files.txt:" + std::to_string(number);
    if (line.rfind("| ", 0) == 0 || line == "|")
      block.text += unescape(line.substr(std::min<std::size_t>(2, line.size()))) + "\n";
    else if (line[0] != '>')
      block.settings.push_back(unescape(line));
    else {
      block.late = line.rfind(">> ", 0) == 0;
      block.message = unescape(line.substr(line.find(' ') + 1));
      blocks.push_back(block);
      block = Block();
    }
  }
  return blocks;
}

using Entries = std::vector<std::pair<std::string, std::string>>;

/** A good scene with some of its values replaced, in the order of their first mention. */
Entries entries_of(const Block &block) {
  Entries entries = {{"Boundary/Clamped", "top"},
                     {"Boundary/Contact", "bottom"},
                     {"Load/Body force", "0; -1"},
                     {"Discretization/Finest level", "3"}};
  for (const std::string &setting : block.settings) {
    const auto equals = setting.find('=');
    const std::string path = trim(setting.substr(0, equals));
    const std::string value = trim(setting.substr(equals + 1));
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const auto &entry) { return entry.first == path; });
    if (found == entries.end())
      entries.emplace_back(path, value);
    else
      found->second = value;
  }
  return entries;
}

/** The message about a file, or that it was not refused; the memory of this machine is left out.
 */
std::string message_of(const std::string &text, const std::vector<std::string> &overrides,
                       const bool late) {
  try {
    const Parameters parameters = parse_parameters(text, "bad.prm", overrides);
    const auto read = [&](const auto &scene) {
      if (late)
        run(parameters, scene);
    };
    if (dimension_of(parameters, named_scenes()) == 2)
      read(make_scene<2>(parameters, named_scenes()));
    else
      read(make_scene<3>(parameters, named_scenes()));
  } catch (const InputError &error) {
    static const std::regex memory("[0-9.]+ GiB of memory");
    return std::regex_replace(error.what(), memory, "{memory} of memory");
  }
  return "nothing was refused";
}

/** The message of a block with the origin for '@'. */
std::string with_origin(const std::string &message, const std::string &origin) {
  return message.rfind("@: ", 0) == 0 ? origin + message.substr(1) : message;
}

/** The parameter that a message "@: Section/Name: ..." is about. */
std::string path_of(const std::string &message) {
  const auto first = message.find(": ") + 2;
  return message.substr(first, message.find(": ", first) - first);
}

/** The message is exactly this, and one line that ends as a sentence. */
void compare(Checks &checks, const std::string &name, const std::string &found,
             const std::string &expected) {
  const bool is_sentence = found.find_first_of("\n\r") == std::string::npos &&
                           (found.back() == '.' || found.back() == ')');
  checks.that(name, found == expected && is_sentence);
  if (found != expected)
    std::cout << "  found:    " << found << "\n  expected: " << expected << std::endl;
}

std::vector<std::string> overrides_of(const Block &block) {
  std::vector<std::string> overrides;
  for (const auto &[path, value] : entries_of(block))
    overrides.push_back(path + "=" + value);
  return overrides;
}

void test_settings(Checks &checks, const Block &block) {
  // Each entry takes three lines of the file.
  std::ostringstream text;
  std::string origin = "bad.prm";
  unsigned int line = 1;
  for (const auto &[path, value] : entries_of(block)) {
    const auto slash = path.find('/');
    const bool is_inside = slash != std::string::npos;
    text << (is_inside ? "subsection " + path.substr(0, slash) : "") << "\nset "
         << path.substr(is_inside ? slash + 1 : 0) << " = " << value << "\n"
         << (is_inside ? "end" : "") << "\n";
    if (path == path_of(block.message))
      origin = "bad.prm:" + std::to_string(line + 1);
    line += 3;
  }
  compare(checks, block.line + " in the file", message_of(text.str(), {}, block.late),
          with_origin(block.message, origin));
  compare(checks, block.line + " by --set", message_of("", overrides_of(block), block.late),
          with_origin(block.message, "--set"));
}

void test_table(Checks &checks) {
  const std::vector<Block> table =
    read_table(SOURCE_DIR "/tests/problem/bad_input/wrong_files.txt");
  for (const Block &block : table)
    if (block.text.empty())
      test_settings(checks, block);
    else
      compare(checks, block.line, message_of(block.text, {}, block.late), block.message);
  checks.that("at least 150 wrong files", table.size() >= 150);
  checks.that("the scene without the faults is good",
              message_of("", overrides_of(Block()), true) == "nothing was refused");
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_table});
}
