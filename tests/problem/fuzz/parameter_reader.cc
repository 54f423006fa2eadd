// SPDX-License-Identifier: LGPL-2.1-or-later
// Any text as a parameter file: it is a scene, or an InputError of one short line says why not.

#include <signorini/base/errors.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

using namespace Signorini;

namespace {
[[noreturn]] void fail(const std::string &why) {
  std::cerr << why << std::endl;
  std::abort();
}

void check_message(const std::string &message) {
  constexpr std::size_t longest = 2000;
  const bool ends_well = !message.empty() && (message.back() == '.' || message.back() == ')');
  if (message.rfind("fuzz.prm", 0) != 0 || message.size() > longest || !ends_well)
    fail("No good sentence: " + message);
  for (const unsigned char c : message)
    if (c < 0x20)
      fail("Not one line: " + message);
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size) {
  const std::string text(reinterpret_cast<const char *>(data), size);
  try {
    const Parameters parameters = parse_parameters(text, "fuzz.prm");
    if (parse_parameters(parameters.echo, "echo.prm").echo != parameters.echo)
      fail("The echo is not its own echo:\n" + parameters.echo);
    make_scene<2>(parameters);
  } catch (const InputError &error) {
    check_message(error.what());
  }
  return 0;
}
