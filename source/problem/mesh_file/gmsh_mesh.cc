// SPDX-License-Identifier: LGPL-2.1-or-later
// The format MSH of Gmsh, versions 2.2 and 4.1, section by section.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/mesh_file/file_mesh.h>
#include <signorini/problem/scene/scene.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>

namespace Signorini
{
/** Goes through the words of a mesh file and counts its lines. */
class GmshScanner
{
public:
  /** Begins with the text, which must outlive the scanner. */
  GmshScanner(const std::string &text, std::string name)
    : text_(text)
    , name_(std::move(name))
  {
  }

  /** Returns whether no word is left. */
  bool is_at_end()
  {
    skip_blanks();
    return position_ == text_.size();
  }

  /** Returns the next word; @p what is its meaning in messages. @throws InputError at the end of
   * the file. */
  std::string_view word(const char *what)
  {
    if (is_at_end())
      throw InputError(name_ + ": the file ends where " + what + " should be.");
    const std::size_t start = position_;
    while (position_ < text_.size() && !is_blank(text_[position_]))
      ++position_;
    return std::string_view(text_).substr(start, position_ - start);
  }

  /** Returns the next word as a number. @throws InputError if it is none. */
  template <typename Number>
  Number number(const char *what)
  {
    const std::string_view found = word(what);
    Number value = 0;
    const auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (error != std::errc() || end != found.data() + found.size())
      refuse(found,
             std::string(what) + (std::is_unsigned_v<Number>   ? " (0, 1, 2, ...)"
                                  : std::is_integral_v<Number> ? " (an integer)"
                                                               : " (a number)"));
    return value;
  }

  /** Returns how many of something follow: a number that the rest of the file can hold. */
  std::size_t count(const char *what)
  {
    const auto n = number<std::size_t>(what);
    if (n > text_.size() - position_)
      throw InputError(place() + ": found the number " + std::to_string(n) + " as " + what +
                       ", but the rest of the file has " +
                       std::to_string(text_.size() - position_) + " characters.");
    return n;
  }

  /** Returns the next words between quotation marks. */
  std::string quoted(const char *what)
  {
    if (is_at_end() || text_[position_] != '"')
      refuse(word(what), what);
    const std::size_t end = text_.find_first_of("\"\n", position_ + 1);
    if (end == std::string::npos || text_[end] == '\n')
      refuse(text_.substr(position_, end - position_), what);
    const std::string found = text_.substr(position_ + 1, end - position_ - 1);
    position_ = end + 1;
    return found;
  }

  /** Reads the next word, which must be this one. */
  void expect(const std::string &expected)
  {
    const std::string_view found = word(expected.c_str());
    if (found != expected)
      refuse(found, expected.c_str());
  }

  /** Skips the text up to the next @p mark, and the mark. */
  void skip_behind(const std::string &mark)
  {
    const std::string opened = place();
    while (!is_at_end())
      if (word("a word") == mark)
        return;
    throw InputError(opened + ": this section is not closed by " + mark + ".");
  }

  std::size_t line() const
  {
    return line_;
  }
  /** Returns "part.msh:12", with the line of the last word. */
  std::string place() const
  {
    return name_ + ":" + std::to_string(line_);
  }

  [[noreturn]] void refuse(const std::string_view found, const std::string &allowed) const
  {
    throw InputError(place() + ": found " + quote(std::string(found)) + ", allowed: " + allowed +
                     ".");
  }

private:
  static bool is_blank(const char c)
  {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
  }

  void skip_blanks()
  {
    for (; position_ < text_.size() && is_blank(text_[position_]); ++position_)
      line_ += text_[position_] == '\n' ? 1 : 0;
  }

  const std::string &text_;
  std::string name_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
};

namespace
{
/** The number of nodes of the elements that are read, by Gmsh's number of their type. */
const std::map<unsigned int, unsigned int> nodes_of_types =
  {{15, 1}, {1, 2}, {8, 3}, {3, 4}, {16, 8}, {10, 9}};
constexpr unsigned int type_of_points = 15;

/** Returns the name of another type of element for messages. */
std::string name_of_type(const unsigned int type)
{
  static const std::map<unsigned int, std::string> names = {{2, "a triangle"},
                                                            {4, "a tetrahedron"},
                                                            {5, "a hexahedron"},
                                                            {6, "a prism"},
                                                            {7, "a pyramid"},
                                                            {9, "a triangle with 6 nodes"},
                                                            {21, "a triangle with 10 nodes"},
                                                            {26, "a line with 4 nodes"},
                                                            {36, "a quadrilateral with 16 nodes"}};
  const auto found = names.find(type);
  return (found == names.end() ? "of another kind" : found->second) + " (type " +
         std::to_string(type) + ")";
}

/** Reads the sections of one file. */
class GmshReader
{
public:
  GmshReader(const std::string &text, const std::string &name)
    : scanner_(text, name)
  {
    mesh_.name = name;
  }

  GmshMesh read()
  {
    read_format();
    while (!scanner_.is_at_end())
    {
      const std::string section(scanner_.word("the name of a section"));
      if (section.size() < 2 || section[0] != '$')
        scanner_.refuse(section, "the name of a section, which begins with $");
      const std::string end = "$End" + section.substr(1);
      if (section == "$PhysicalNames")
        read_names();
      else if (section == "$Entities" && !is_old_)
        read_entities();
      else if (section == "$Nodes")
        is_old_ ? read_old_nodes() : read_nodes();
      else if (section == "$Elements")
        is_old_ ? read_old_elements() : read_elements();
      else
      {
        scanner_.skip_behind(end);
        continue;
      }
      scanner_.expect(end);
    }
    if (mesh_.nodes.empty())
      throw InputError(mesh_.name + ": found no section $Nodes, allowed: a mesh.");
    if (mesh_.quadrilaterals.empty())
      throw InputError(mesh_.name +
                       ": found no quadrilaterals, allowed: a mesh of quadrilaterals.");
    return std::move(mesh_);
  }

private:
  void read_format()
  {
    scanner_.expect("$MeshFormat");
    const std::string version(scanner_.word("the version of the format"));
    is_old_ = version == "2.2";
    if (!is_old_ && version != "4.1")
      scanner_.refuse(version, "the version 2.2 or 4.1 of the format (gmsh -format msh41)");
    if (scanner_.number<int>("0 for a file of text") != 0)
      throw InputError(scanner_.place() +
                       ": found a binary mesh file, allowed: a file of text (gmsh without -bin).");
    scanner_.number<unsigned int>("the size of a number");
    scanner_.expect("$EndMeshFormat");
  }

  void read_names()
  {
    for (std::size_t i = scanner_.count("the number of physical names"); i > 0; --i)
    {
      const auto dim = scanner_.number<unsigned int>("the dimension of a physical group");
      const int group = scanner_.number<int>("the number of a physical group");
      const std::string name = scanner_.quoted("a name between quotation marks");
      if (dim == 1)
        mesh_.curve_names[group] = name;
    }
  }

  /** Reads the entities, and keeps the physical groups of the curves. */
  void read_entities()
  {
    std::array<std::size_t, 4> n = {};
    for (std::size_t &n_of_dim : n)
      n_of_dim = scanner_.count("a number of entities");
    for (unsigned int dim = 0; dim < 4; ++dim)
      for (std::size_t i = n[dim]; i > 0; --i)
      {
        const int tag = scanner_.number<int>("the number of an entity");
        for (unsigned int c = 0; c < (dim == 0 ? 3 : 6); ++c)
          scanner_.number<double>("a coordinate of an entity");
        const std::size_t n_groups = scanner_.count("the number of physical groups");
        if (dim == 1 && n_groups > 1)
          throw InputError(scanner_.place() + ": found curve " + std::to_string(tag) + " in " +
                           std::to_string(n_groups) +
                           " physical groups, allowed: one, because a side has one name.");
        for (std::size_t g = 0; g < n_groups; ++g)
        {
          const int group = scanner_.number<int>("the number of a physical group");
          if (dim == 1)
            groups_of_curves_[tag] = std::abs(group);
        }
        if (dim > 0)
          for (std::size_t b = scanner_.count("the number of bounding entities"); b > 0; --b)
            scanner_.number<int>("the number of a bounding entity");
      }
  }

  void add_node(const std::size_t tag)
  {
    GmshMesh::Node node = {tag, 0, {}};
    for (double &x : node.x)
    {
      x = scanner_.number<double>("a coordinate of a node");
      if (!(std::abs(x) <= max_magnitude))
        throw InputError(scanner_.place() + ": found the coordinate " + number_text(x) +
                         " of node " + std::to_string(tag) + ", allowed: coordinates up to " +
                         number_text(max_magnitude) + "; take other units.");
    }
    node.line = scanner_.line();
    if (!index_of_tag_.emplace(tag, mesh_.nodes.size()).second)
      throw InputError(scanner_.place() + ": found node " + std::to_string(tag) +
                       " a second time, allowed: one node for each number.");
    mesh_.nodes.push_back(node);
  }

  void read_old_nodes()
  {
    for (std::size_t i = scanner_.count("the number of nodes"); i > 0; --i)
      add_node(scanner_.number<std::size_t>("the number of a node"));
  }

  void read_nodes()
  {
    const std::size_t n_blocks = scanner_.count("the number of blocks");
    for (unsigned int i = 0; i < 3; ++i)
      scanner_.number<std::size_t>("a number of nodes");
    for (std::size_t block = 0; block < n_blocks; ++block)
    {
      const auto dim = scanner_.number<unsigned int>("the dimension of an entity");
      scanner_.number<int>("the number of an entity");
      const bool is_parametric = scanner_.number<int>("0 or 1") != 0;
      std::vector<std::size_t> tags(scanner_.count("the number of nodes"));
      for (std::size_t &tag : tags)
        tag = scanner_.number<std::size_t>("the number of a node");
      for (const std::size_t tag : tags)
      {
        add_node(tag);
        for (unsigned int c = 0; is_parametric && c < dim; ++c)
          scanner_.number<double>("a parameter of a node");
      }
    }
  }

  /** Returns the number of nodes of a type. @throws InputError if it is neither a line nor a
   * quadrilateral. */
  unsigned int n_nodes_of(const unsigned int type, const std::size_t tag) const
  {
    const auto found = nodes_of_types.find(type);
    if (found == nodes_of_types.end())
      throw InputError(scanner_.place() + ": element " + std::to_string(tag) + " is " +
                       name_of_type(type) +
                       ", allowed: quadrilaterals with 4, 8 or 9 nodes and lines with 2 or 3 "
                       "(Gmsh: Mesh.RecombineAll = 1 and Mesh.SubdivisionAlgorithm = 1).");
    return found->second;
  }

  void add_element(const unsigned int type, const std::size_t tag, const int group)
  {
    GmshMesh::Element element = {tag, scanner_.line(), group, n_nodes_of(type, tag), {}};
    for (unsigned int i = 0; i < element.n_nodes; ++i)
    {
      const auto node = scanner_.number<std::size_t>("the number of a node");
      const auto found = index_of_tag_.find(node);
      if (found == index_of_tag_.end())
        throw InputError(scanner_.place() + ": element " + std::to_string(tag) + " has the node " +
                         std::to_string(node) + ", which the section $Nodes before it lacks.");
      element.nodes[i] = found->second;
    }
    if (type != type_of_points)
      (element.n_nodes < 4 ? mesh_.lines : mesh_.quadrilaterals).push_back(element);
  }

  void read_old_elements()
  {
    for (std::size_t i = scanner_.count("the number of elements"); i > 0; --i)
    {
      const auto tag = scanner_.number<std::size_t>("the number of an element");
      const auto type = scanner_.number<unsigned int>("the type of an element");
      n_nodes_of(type, tag);
      int group = 0;
      const std::size_t n_tags = scanner_.count("a number of tags");
      for (std::size_t t = 0; t < n_tags; ++t)
      {
        const int value = scanner_.number<int>("a tag of an element");
        if (t == 0)
          group = std::abs(value);
      }
      add_element(type, tag, group);
    }
  }

  void read_elements()
  {
    const std::size_t n_blocks = scanner_.count("the number of blocks");
    for (unsigned int i = 0; i < 3; ++i)
      scanner_.number<std::size_t>("a number of elements");
    for (std::size_t block = 0; block < n_blocks; ++block)
    {
      const auto dim = scanner_.number<unsigned int>("the dimension of an entity");
      const int entity = scanner_.number<int>("the number of an entity");
      const auto type = scanner_.number<unsigned int>("the type of an element");
      const auto group = groups_of_curves_.find(entity);
      const bool has_group = dim == 1 && group != groups_of_curves_.end();
      for (std::size_t i = scanner_.count("the number of elements"); i > 0; --i)
        add_element(type,
                    scanner_.number<std::size_t>("the number of an element"),
                    has_group ? group->second : 0);
    }
  }

  GmshScanner scanner_;
  GmshMesh mesh_;
  /** Whether the version is 2.2. */
  bool is_old_ = false;
  std::map<int, int> groups_of_curves_;
  std::unordered_map<std::size_t, unsigned int> index_of_tag_;
};
} // namespace

GmshMesh read_gmsh(const std::string &text, const std::string &name)
{
  return GmshReader(text, name).read();
}
} // namespace Signorini
