// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

namespace Signorini {
/**
 * One `set Name = value` of a parameter file, or one value of `--set` or `--sweep` on the command
 * line, with its origin.
 */
struct Assignment {
  /** The subsections and the name, joined by '/': "Solver/Tolerance". */
  std::string path;
  /** The value without comment and surrounding blanks. */
  std::string value;
  /** The origin for messages: "scene.prm:12", "--set" or "--sweep". */
  std::string origin;
};

/**
 * Splits the text of a parameter file into its assignments, in the order of the file.
 *
 * The syntax consists of `subsection NAME`, `end`, `set NAME = VALUE`, comments from `#` to the end
 * of the line, continuation lines (a backslash at the end; lines of comment may stand between
 * them), the line ends of all systems and a byte-order mark.
 * @throws InputError for anything else, for control characters, unbalanced subsections and an entry
 * set twice, a subsection inside of another, and one without entries that is not among @p
 * known_sections (wrong names of others show in their entries).
 */
std::vector<Assignment> scan_parameter_text(const std::string &text, const std::string &file_name,
                                            const std::set<std::string> &known_sections = {});

/** Splits `Subsection/Parameter=value` of an option of the command line, `--set` or `--sweep`.
 * @throws InputError without '='. */
Assignment scan_override(const std::string &argument, const std::string &option = "--set");

/** Reads a whole file. @throws InputError if it cannot be read, is not a file (devices and pipes
 * may never end) or has more than @p max_size bytes. Messages begin with @p where and call the
 * file a @p kind. */
std::string read_whole_file(const std::string &file_name, const std::string &where,
                            const std::string &kind, std::size_t max_size);

/** Reads a parameter file of at most a million bytes; throws InputError if it contains characters
 * 0. */
std::string read_text_file(const std::string &file_name);
} // namespace Signorini
