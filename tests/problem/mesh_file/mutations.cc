// SPDX-License-Identifier: LGPL-2.1-or-later
// Damaged mesh files: each is a body, or one sentence says why not.

#include <signorini/base/errors.h>
#include <signorini/problem/mesh_file/file_geometry.h>

#include <random>

#include "tests.h"

using namespace Signorini;

namespace {
/** Replaces, removes or repeats a few pieces of a text. */
std::string damage(std::string text, std::mt19937 &random) {
  static const std::string symbols = "0123456789 .-+e$\"\n\tnN/";
  const auto below = [&](const std::size_t n) { return n == 0 ? 0 : random() % n; };
  for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
    const std::size_t at = below(text.size()), length = below(20);
    switch (below(4)) {
    case 0:
      text[at] = symbols[below(symbols.size())];
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, text.substr(below(text.size()), length));
      break;
    default:
      text[at] = static_cast<char>(below(256));
    }
  }
  return text;
}

/** Whether a text is a body or an InputError with one good line. */
bool is_judged(const std::string &text) {
  try {
    const Geometry<2> geometry = make_geometry(read_gmsh<2>(text, "a.msh"), {}, "arcs");
    return !geometry.sides.empty();
  } catch (const InputError &error) {
    const std::string message = error.what();
    return message.rfind("a.msh", 0) == 0 && message.back() == '.' && message.size() < 1000 &&
           message.find('\n') == std::string::npos;
  }
}

void test_mutations(Checks &checks) {
  std::mt19937 random(5);
  for (const std::string file : {"bracket_1.msh", "bracket_1_v4.msh", "bracket_2_v2.msh"}) {
    const std::string text = file_text(SOURCE_DIR "/tests/problem/mesh_file/" + file);
    for (unsigned int i = 0; i < 1000; ++i)
      checks.that(file, is_judged(damage(text, random)));
  }
}
} // namespace

int main() {
  return run_tests({test_mutations});
}
