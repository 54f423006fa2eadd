// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>

namespace Signorini
{
/** An entry of the parameter file, as messages speak of it. */
struct Entry
{
  /** Subsection and name: "Solver/Tolerance". */
  std::string name;
  /** "scene.prm:12" or "--set"; for a default the file alone. */
  std::string place;
  /** Whether the value differs from the default. */
  bool changed = false;

  /** "scene.prm:12: Solver/Tolerance": how every message about the entry begins. */
  std::string where() const
  {
    return place + ": " + name;
  }
};

/** The value of an entry, with where it was given. Use it like the value. */
template <typename T>
struct Given : Entry
{
  T value = T();

  Given() = default;
  /** A default. */
  explicit Given(T default_value)
    : value(std::move(default_value))
  {
  }
  operator const T &() const
  {
    return value;
  }
};
} // namespace Signorini
