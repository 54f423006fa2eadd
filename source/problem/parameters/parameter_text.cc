// SPDX-License-Identifier: LGPL-2.1-or-later
// The syntax of a parameter file, line by line, so that every message can name its line.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/parameter_text.h>

#include <algorithm>
#include <cctype>
#include <fcntl.h>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

#include "declarations.h"

namespace Signorini
{
namespace
{
/** The largest size of a parameter file in bytes. */
constexpr std::size_t max_file_size = 1000000;

/** An open file, which is closed at the end of the object's life. */
class FileDescriptor
{
public:
  explicit FileDescriptor(const int descriptor)
    : descriptor_(descriptor)
  {
  }
  ~FileDescriptor()
  {
    if (descriptor_ >= 0)
      close(descriptor_);
  }
  FileDescriptor(const FileDescriptor &) = delete;
  FileDescriptor &operator=(const FileDescriptor &) = delete;

  int get() const
  {
    return descriptor_;
  }

private:
  int descriptor_;
};

/** Reads line after line and stores the open subsections. */
class Scanner
{
public:
  Scanner(std::string file_name, const std::set<std::string> &known_sections)
    : file_name_(std::move(file_name))
    , known_sections_(known_sections)
  {
  }

  void read_line(const std::string &line, const unsigned int number)
  {
    place_ = file_name_ + ":" + std::to_string(number);
    const auto blank = line.find_first_of(" \t");
    const std::string keyword = line.substr(0, blank);
    const std::string rest = blank == std::string::npos ? "" : trim(line.substr(blank));
    if (keyword == "subsection" && !rest.empty())
      enter_section(rest);
    else if (keyword == "end" && rest.empty())
      leave_section();
    else if (keyword == "set" && rest.find('=') != std::string::npos && rest[0] != '=')
      add(rest);
    else
      throw InputError(place_ + ": found " + quote(line) +
                       ", but a line must be 'set Name = value', 'subsection Name' or 'end'.");
  }

  std::vector<Assignment> finish() const
  {
    if (!sections_.empty())
      throw InputError(sections_.back().place + ": subsection " + quote(sections_.back().name) +
                       " is not closed by 'end'.");
    return assignments_;
  }

private:
  struct Section
  {
    std::string name;
    std::string place;
    bool is_empty;
  };

  void enter_section(const std::string &name)
  {
    if (!known_sections_.empty() && !sections_.empty())
      throw InputError(place_ + ": found the subsection " + quote(name) + " inside of " +
                       quote(sections_.back().name) + " (" + sections_.back().place +
                       "), allowed: one after the other, each closed by 'end'.");
    sections_.push_back({name, place_, true});
  }

  void leave_section()
  {
    if (sections_.empty())
      throw InputError(place_ + ": found 'end' without an open subsection.");
    const Section &section = sections_.back();
    if (section.is_empty && !known_sections_.empty() && known_sections_.count(path()) == 0)
      throw InputError(section.place + ": found the subsection " + quote(section.name) +
                       ", allowed: " + join({known_sections_.begin(), known_sections_.end()}) +
                       ".");
    sections_.pop_back();
  }

  /** Returns the names of the open subsections, joined by '/'. */
  std::string path() const
  {
    std::string joined;
    for (const Section &section : sections_)
      joined += (joined.empty() ? "" : "/") + section.name;
    return joined;
  }

  void add(const std::string &text)
  {
    const auto equals = text.find('=');
    const std::string name = trim(text.substr(0, equals));
    const std::string full_name = sections_.empty() ? name : path() + "/" + name;
    for (Section &section : sections_)
      section.is_empty = false;
    const auto earlier = places_.emplace(full_name, place_);
    if (!earlier.second)
      throw InputError(place_ + ": " + shorten(full_name) + " was set already at " +
                       earlier.first->second + "; set every parameter only once.");
    assignments_.push_back({full_name, trim(text.substr(equals + 1)), place_});
  }

  std::string file_name_;
  std::set<std::string> known_sections_;
  std::string place_;
  std::vector<Section> sections_;
  std::map<std::string, std::string> places_;
  std::vector<Assignment> assignments_;
};

/** Returns the text without a byte-order mark, and with the line ends of Unix. */
std::string with_plain_line_ends(const std::string &text)
{
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  const bool is_marked = text.compare(0, byte_order_mark.size(), byte_order_mark) == 0;
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = is_marked ? byte_order_mark.size() : 0; i < text.size(); ++i)
    if (text[i] != '\r')
      plain += text[i];
    else if (i + 1 == text.size() || text[i + 1] != '\n')
      plain += '\n';
  return plain;
}

void refuse_control_characters(const std::string &line, const std::string &place)
{
  for (const char c : line)
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0 && c != '\t')
      throw InputError(place + ": found the control character number " +
                       std::to_string(static_cast<unsigned char>(c)) + ", allowed: plain text.");
}
} // namespace

std::vector<Assignment> scan_parameter_text(const std::string &text,
                                            const std::string &file_name,
                                            const std::set<std::string> &known_sections)
{
  Scanner scanner(file_name, known_sections);
  std::istringstream stream(with_plain_line_ends(text));
  std::string line;
  std::string logical_line;
  unsigned int number = 0;
  unsigned int first_number = 0;
  while (std::getline(stream, line))
  {
    ++number;
    refuse_control_characters(line, file_name + ":" + std::to_string(number));
    const auto comment = line.find('#');
    line = trim(line.substr(0, comment));
    // A line that is nothing but a comment may stand between the parts of a continued line.
    if (line.empty() && comment != std::string::npos)
      continue;
    if (logical_line.empty())
      first_number = number;
    const bool continued = !line.empty() && line.back() == '\\';
    logical_line += continued ? line.substr(0, line.size() - 1) + " " : line;
    if (continued)
      continue;
    logical_line = trim(logical_line);
    if (!logical_line.empty())
      scanner.read_line(logical_line, first_number);
    logical_line.clear();
  }
  if (!trim(logical_line).empty())
    scanner.read_line(trim(logical_line), first_number);
  return scanner.finish();
}

Assignment scan_override(const std::string &argument)
{
  // An override is one line, like the file it stands in for.
  std::string line = argument;
  std::replace_if(
    line.begin(), line.end(), [](const unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  const auto equals = line.find('=');
  if (equals == std::string::npos || trim(line.substr(0, equals)).empty())
    throw InputError("--set: found " + quote(line) +
                     ", but 'Subsection/Parameter=value' is expected.");
  return {trim(line.substr(0, equals)), trim(line.substr(equals + 1)), "--set"};
}

std::string read_whole_file(const std::string &file_name,
                            const std::string &where,
                            const std::string &kind,
                            const std::size_t max_size)
{
  const std::string name = where + shorten_path(file_name);
  // Pipes and some files of the kernel would wait for what never comes.
  const FileDescriptor file(open(file_name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat status = {};
  if (file.get() < 0 || fstat(file.get(), &status) != 0 || S_ISDIR(status.st_mode))
    throw InputError(name + ": this " + kind + " cannot be read.");
  if (!S_ISREG(status.st_mode))
    throw InputError(name + ": this is a device or a pipe, allowed: a file of text on a disk.");
  const auto refuse_size = [&](const std::string &found) {
    throw InputError(name + ": this file has " + found + " bytes, allowed: at most " +
                     std::to_string(max_size) + ".");
  };
  const auto stat_size = static_cast<std::size_t>(status.st_size);
  if (stat_size > max_size)
    refuse_size(std::to_string(stat_size));
  // Files of the kernel have the size 0, and may have no end.
  const std::size_t most = stat_size > 0 ? stat_size : std::min<std::size_t>(max_size, 1000000);
  std::string text(most + 1, '\0');
  std::size_t size = 0;
  ssize_t n = 1;
  while (n > 0 && size < text.size())
  {
    n = read(file.get(), &text[size], text.size() - size);
    size += n > 0 ? static_cast<std::size_t>(n) : 0;
  }
  if (n < 0)
    throw InputError(name + ": this " + kind + " cannot be read.");
  if (size > most)
    refuse_size("more than " + std::to_string(most));
  text.resize(size);
  return text;
}

std::string read_text_file(const std::string &file_name)
{
  const std::string text = read_whole_file(file_name, "", "parameter file", max_file_size);
  if (text.find('\0') != std::string::npos)
    throw InputError(shorten_path(file_name) + ": this is not a text file.");
  return text;
}

// A value for a declared parameter, or one sentence that says why not.

namespace
{
/** Returns Levenshtein's distance, for "did you mean". */
std::size_t edit_distance(const std::string &a, const std::string &b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

/** Returns whether two values mean the same, however blanks and digits are written. */
bool is_same_value(std::string a, std::string b)
{
  double first = 0., second = 0.;
  if (read_number(a, first) && read_number(b, second))
    return first == second;
  for (std::string *const text : {&a, &b})
    text->erase(std::remove(text->begin(), text->end(), ' '), text->end());
  return a == b;
}
} // namespace

void Declarations::refuse_unknown(const Assignment &assignment) const
{
  std::string nearest;
  std::size_t distance = std::numeric_limits<std::size_t>::max();
  for (const auto &declared : declared_)
    if (edit_distance(declared.first, assignment.path) < distance)
    {
      nearest = declared.first;
      distance = edit_distance(declared.first, assignment.path);
    }
  throw InputError(assignment.place + ": " + shorten(assignment.path) +
                   ": unknown parameter; did you mean '" + nearest +
                   "'? (--print-parameters lists all)");
}

void Declarations::assign(const Assignment &assignment)
{
  const std::string &path = assignment.path, &value = assignment.value;
  const auto known = declared_.find(path);
  if (known == declared_.end())
    refuse_unknown(assignment);
  const Declared &declared = known->second;
  Entry &entry = *declared.entry;
  entry.place = assignment.place;
  const auto slash = path.find('/');
  if (slash != std::string::npos)
    handler_.enter_subsection(path.substr(0, slash));
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  try
  {
    handler_.set(name, value.empty() ? declared.default_text : value);
  }
  catch (const ExceptionBase &)
  {
    throw InputError(entry.where() + ": found " + quote(value) + ", allowed: " + declared.allowed +
                     ".");
  }
  if (slash != std::string::npos)
    handler_.leave_subsection();
  entry.changed = !value.empty() && !is_same_value(value, declared.default_text);
}

std::set<std::string> Declarations::sections() const
{
  std::set<std::string> names;
  for (const auto &declared : declared_)
    if (declared.first.find('/') != std::string::npos)
      names.insert(declared.first.substr(0, declared.first.find('/')));
  return names;
}

std::vector<Entry> Declarations::changes(const std::vector<std::string> &sections) const
{
  std::vector<Entry> changes;
  for (const std::string &section : sections)
    for (const auto &declared : declared_)
      if (declared.first.rfind(section + "/", 0) == 0 && declared.second.entry->changed)
        changes.push_back(*declared.second.entry);
  return changes;
}

std::string Declarations::print(const bool with_help) const
{
  std::ostringstream text;
  handler_.print_parameters(text,
                            (with_help ? ParameterHandler::Text : ParameterHandler::ShortText) |
                              ParameterHandler::KeepDeclarationOrder);
  return text.str();
}
} // namespace Signorini
