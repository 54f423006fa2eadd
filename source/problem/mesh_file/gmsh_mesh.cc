// SPDX-License-Identifier: LGPL-2.1-or-later
// The format MSH of Gmsh, versions 2.0 to 2.2 and 4.1, section by section.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/mesh_file/file_mesh.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>

namespace Signorini {
/** Goes through the words of a mesh file and counts its lines. */
class GmshScanner {
public:
  /** Begins with the text, which must outlive the scanner. */
  GmshScanner(const std::string &text, std::string name)
    : text_(text)
    , name_(std::move(name)) {}

  /** Returns whether no word is left. */
  bool is_at_end() {
    skip_blanks();
    return position_ == text_.size();
  }

  /** Returns the next word; @p meaning is that in messages. @throws InputError at the end of
   * the file. */
  std::string_view word(const char *meaning) {
    if (is_at_end())
      throw input_error(name_, ": the file ends where ", meaning, " should be.");
    const std::size_t start = position_;
    while (position_ < text_.size() && !is_blank(text_[position_]))
      ++position_;
    return std::string_view(text_).substr(start, position_ - start);
  }

  /** Returns the next word as a number. @throws InputError if it is none. */
  template <typename Number>
  Number number(const char *meaning) {
    const std::string_view found = word(meaning);
    Number value = 0;
    const auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (error != std::errc() || end != found.data() + found.size())
      refuse(found, std::string(meaning) + (std::is_unsigned_v<Number>   ? " (0, 1, 2, ...)"
                                            : std::is_integral_v<Number> ? " (an integer)"
                                                                         : " (a number)"));
    return value;
  }

  /** Returns how many of something follow: a number that the rest of the file can hold. */
  std::size_t count(const char *meaning) {
    const auto n = number<std::size_t>(meaning);
    if (n > text_.size() - position_)
      refuse("found the number " + std::to_string(n) + " as " + meaning +
             ", but the rest of the file has " + std::to_string(text_.size() - position_) +
             " characters.");
    return n;
  }

  /** Returns the next words between quotation marks. */
  std::string quoted(const char *meaning) {
    if (!is_before_quoted())
      refuse(word(meaning), meaning);
    const std::size_t end = text_.find_first_of("\"\n", position_ + 1);
    if (end == std::string::npos || text_[end] == '\n')
      refuse(text_.substr(position_, end - position_), meaning);
    const std::string found = text_.substr(position_ + 1, end - position_ - 1);
    position_ = end + 1;
    return found;
  }

  /** Returns whether a quotation mark follows. */
  bool is_before_quoted() {
    return !is_at_end() && text_[position_] == '"';
  }

  /** Reads the next word, which must be this one. */
  void expect(const std::string &expected) {
    const std::string_view found = word(expected.c_str());
    if (found != expected)
      refuse(found, expected.c_str());
  }

  /** Skips the text up to the next @p mark, and the mark. */
  void skip_behind(const std::string &mark) {
    while (word(mark.c_str()) != mark) {
    }
  }

  /** Returns the line of the last word; 0 where the user has not seen the text. */
  std::size_t line() const {
    return has_lines_ ? line_ : 0;
  }
  /** From here on messages name no lines. */
  void forget_lines() {
    has_lines_ = false;
  }
  /** Throws an error at the line of the last word. */
  [[noreturn]] void refuse(const std::string &message) const {
    throw input_error(place_in_file(name_, line()), message);
  }
  [[noreturn]] void refuse(const std::string_view found, const std::string &allowed) const {
    refuse("found " + quote(std::string(found)) + ", allowed: " + allowed + ".");
  }

private:
  static bool is_blank(const char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
  }

  void skip_blanks() {
    for (; position_ < text_.size() && is_blank(text_[position_]); ++position_)
      line_ += text_[position_] == '\n' ? 1 : 0;
  }

  const std::string &text_;
  std::string name_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  bool has_lines_ = true;
};

namespace {
/** A type of element; with no nodes: one that is not read. */
struct ElementType {
  std::string name;
  unsigned int dimension, n_nodes, n_corners;
};

/** The types of elements by Gmsh's number. */
const std::map<unsigned int, ElementType> element_types = {
  {15, {"a point", 0, 1, 1}},
  {1, {"a line", 1, 2, 2}},
  {8, {"a line", 1, 3, 2}},
  {2, {"a triangle", 2, 3, 3}},
  {9, {"a triangle", 2, 6, 3}},
  {3, {"a quadrilateral", 2, 4, 4}},
  {16, {"a quadrilateral", 2, 8, 4}},
  {10, {"a quadrilateral", 2, 9, 4}},
  {4, {"a tetrahedron", 3, 4, 4}},
  {11, {"a tetrahedron", 3, 10, 4}},
  {5, {"a hexahedron", 3, 8, 8}},
  {17, {"a hexahedron", 3, 20, 8}},
  {12, {"a hexahedron", 3, 27, 8}},
  {6, {"a prism", 3, 6, 6}},
  {18, {"a prism", 3, 15, 6}},
  {13, {"a prism", 3, 18, 6}},
  {7, {"a pyramid", 3, 0, 5}},
  {14, {"a pyramid", 3, 0, 5}},
  {19, {"a pyramid", 3, 0, 5}},
  {26, {"a line of order 3", 1, 0, 2}},
  {21, {"a triangle of order 3", 2, 0, 3}},
  {36, {"a quadrilateral of order 3", 2, 0, 4}},
  {29, {"a tetrahedron of order 3", 3, 0, 4}},
  {92, {"a hexahedron of order 3", 3, 0, 8}},
  {90, {"a prism of order 3", 3, 0, 6}}};

/** Returns whether the nodes and elements of a version of the format are those of 2.2. */
bool is_version_2(const std::string_view version) {
  return version == "2" || version == "2.0" || version == "2.1" || version == "2.2";
}

/** Reads the sections of one file. */
template <int dim>
class GmshReader {
  using Element = typename FileMesh<dim>::Element;

public:
  GmshReader(const std::string &text, const std::string &name)
    : scanner_(text, name) {
    mesh_.name = name;
  }

  FileMesh<dim> read() {
    read_format();
    while (!scanner_.is_at_end()) {
      const std::string section(scanner_.word("the name of a section"));
      if (section.size() < 2 || section[0] != '$')
        scanner_.refuse(section, "the name of a section, which begins with $");
      const std::string end = "$End" + section.substr(1);
      if (section == "$PhysicalNames")
        read_names();
      else if (section == "$Entities" && !is_old_)
        read_entities();
      else if (section == "$Nodes")
        read_nodes();
      else if (section == "$Elements")
        read_elements();
      else if (section == conversion_section)
        scanner_.forget_lines();
      else {
        scanner_.skip_behind(end);
        continue;
      }
      scanner_.expect(end);
    }
    if (mesh_.cells.empty())
      throw input_error(mesh_.name, ": found no cells, allowed: a mesh of ",
                        dim == 2 ? "quadrilaterals or triangles."
                                 : "hexahedra, tetrahedra or prisms.");
    for (const auto &[group, name] : names_without_dimension_) {
      const auto give_name = [&, group = group, name = name](const auto &elements,
                                                             const unsigned int dimension) {
        for (const auto &element : elements)
          if (element.group == group)
            mesh_.group_names.emplace(std::make_pair(dimension, group), name);
      };
      give_name(mesh_.faces, dim - 1);
      give_name(mesh_.cells, dim);
    }
    return std::move(mesh_);
  }

private:
  template <typename Number>
  void skip(const unsigned int n, const char *meaning) {
    for (unsigned int i = 0; i < n; ++i)
      scanner_.number<Number>(meaning);
  }

  void read_format() {
    scanner_.expect("$MeshFormat");
    const std::string version(scanner_.word("the version of the format"));
    is_old_ = is_version_2(version);
    if (!is_old_ && version != "4.1")
      scanner_.refuse(version, "the version 2.0 to 2.2 or 4.1 of the format (gmsh -format msh41)");
    if (scanner_.word("0 for a file of text") != "0")
      scanner_.refuse("found a binary mesh file, allowed: a file of text (gmsh without -bin).");
    skip<unsigned int>(1, "the size of a number");
    scanner_.expect("$EndMeshFormat");
  }

  /** Reads names with the dimension of their elements, which version 2.0 does not have and Gmsh
   * then calls -1. */
  void read_names() {
    for (std::size_t i = scanner_.count("the number of physical names"); i > 0; --i) {
      const int first = scanner_.number<int>("a number before a physical name");
      if (scanner_.is_before_quoted()) {
        names_without_dimension_[first] = scanner_.quoted("a name between quotation marks");
        continue;
      }
      if (first < -1 || first > 3)
        scanner_.refuse(std::to_string(first), "the dimension of a physical group (0, 1, 2, 3)");
      const int group = scanner_.number<int>("the number of a physical group");
      const std::string name = scanner_.quoted("a name between quotation marks");
      if (first < 0)
        names_without_dimension_[group] = name;
      else
        mesh_.group_names[{static_cast<unsigned int>(first), group}] = name;
    }
  }

  /** Reads the entities, and keeps the physical groups of theirs. */
  void read_entities() {
    std::array<std::size_t, 4> n = {};
    for (std::size_t &n_of_dimension : n)
      n_of_dimension = scanner_.count("a number of entities");
    for (unsigned int d = 0; d < 4; ++d)
      for (std::size_t i = n[d]; i > 0; --i) {
        const int tag = scanner_.number<int>("the number of an entity");
        skip<double>(d == 0 ? 3 : 6, "a coordinate of an entity");
        const std::size_t n_groups = scanner_.count("the number of physical groups");
        if (d == dim - 1 && n_groups > 1)
          scanner_.refuse(std::string(dim == 2 ? "found curve " : "found surface ") +
                          std::to_string(tag) + " in " + std::to_string(n_groups) +
                          " physical groups, allowed: one, because a side has one name.");
        for (std::size_t g = 0; g < n_groups; ++g)
          groups_[{d, tag}] = std::abs(scanner_.number<int>("the number of a physical group"));
        if (d > 0)
          skip<int>(scanner_.count("the number of bounding entities"),
                    "the number of a bounding entity");
      }
  }

  void read_node(const std::size_t tag) {
    std::array<double, 3> x = {};
    for (double &coordinate : x) {
      coordinate = scanner_.number<double>("a coordinate of a node");
      if (!(std::abs(coordinate) <= max_magnitude))
        scanner_.refuse("found the coordinate " + number_text(coordinate) + " of node " +
                        std::to_string(tag) + ", allowed: coordinates up to " +
                        number_text(max_magnitude) + "; take other units.");
    }
    if (!index_of_tag_.emplace(tag, mesh_.nodes.size()).second)
      scanner_.refuse("found node " + std::to_string(tag) +
                      " a second time, allowed: one node for each number.");
    mesh_.nodes.push_back({tag, scanner_.line(), {}, x[2]});
    std::copy_n(x.begin(), dim, mesh_.nodes.back().x.begin_raw());
  }

  /** Reads the nodes, in version 2.2 like one block of version 4.1 with numbers beside nodes. */
  void read_nodes() {
    const std::size_t n_blocks = is_old_ ? 1 : scanner_.count("the number of blocks");
    skip<std::size_t>(is_old_ ? 0 : 3, "a number of nodes");
    for (std::size_t block = 0; block < n_blocks; ++block) {
      unsigned int n_parameters = 0;
      if (!is_old_) {
        n_parameters = scanner_.number<unsigned int>("the dimension of an entity");
        skip<int>(1, "the number of an entity");
        n_parameters *= scanner_.number<int>("0 or 1") != 0 ? 1 : 0;
      }
      std::vector<std::size_t> tags(scanner_.count("the number of nodes"));
      for (std::size_t &tag : tags) {
        tag = scanner_.number<std::size_t>("the number of a node");
        if (is_old_)
          read_node(tag);
      }
      for (std::size_t i = 0; i < tags.size() && !is_old_; ++i) {
        read_node(tags[i]);
        skip<double>(n_parameters, "a parameter of a node");
      }
    }
  }

  void read_elements() {
    const std::size_t n_blocks = is_old_ ? 1 : scanner_.count("the number of blocks");
    skip<std::size_t>(is_old_ ? 0 : 3, "a number of elements");
    for (std::size_t block = 0; block < n_blocks; ++block) {
      unsigned int type = 0;
      Element element = {};
      if (!is_old_) {
        const auto d = scanner_.number<unsigned int>("the dimension of an entity");
        element.entity = scanner_.number<int>("the number of an entity");
        type = scanner_.number<unsigned int>("the type of an element");
        const auto group = groups_.find({d, element.entity});
        element.group = group == groups_.end() ? 0 : group->second;
      }
      for (std::size_t i = scanner_.count("the number of elements"); i > 0; --i) {
        element.tag = scanner_.number<std::size_t>("the number of an element");
        if (is_old_) {
          type = scanner_.number<unsigned int>("the type of an element");
          const std::size_t n_tags = scanner_.count("a number of tags");
          for (std::size_t t = 0; t < n_tags; ++t) {
            const int value = std::abs(scanner_.number<int>("a tag of an element"));
            if (t < 2)
              (t == 0 ? element.group : element.entity) = value;
          }
        }
        read_element(type, element);
      }
    }
  }

  void read_element(const unsigned int type, Element element) {
    element.line = scanner_.line();
    const auto found = element_types.find(type);
    if (found == element_types.end() || found->second.n_nodes == 0 || found->second.dimension > dim)
      refuse_element(type, element.tag);
    const auto &[name, dimension, n_nodes, n_corners] = found->second;
    element.n_corners = n_corners;
    element.is_quadratic = n_nodes > n_corners;
    for (unsigned int i = 0; i < n_nodes; ++i) {
      const auto node = scanner_.number<std::size_t>("the number of a node");
      const auto index = index_of_tag_.find(node);
      if (index == index_of_tag_.end())
        scanner_.refuse("element " + std::to_string(element.tag) + " has the node " +
                        std::to_string(node) + ", which the section $Nodes before it lacks.");
      element.nodes[i] = index->second;
    }
    if (dimension + 1 >= dim)
      (dimension == dim ? mesh_.cells : mesh_.faces).push_back(element);
    mesh_.has_groups[dimension] |= element.group != 0;
  }

  [[noreturn]] void refuse_element(const unsigned int type, const std::size_t tag) const {
    const auto found = element_types.find(type);
    const bool is_known = found != element_types.end();
    scanner_.refuse(
      "element " + std::to_string(tag) + " is " +
      (is_known ? found->second.name : "of the type " + std::to_string(type)) + ", allowed: " +
      (dim == 2 ? "quadrilaterals, triangles and lines" : "hexahedra, prisms and tetrahedra") +
      " of first or second order" +
      (is_known && found->second.dimension > dim ? "; a body in space needs Dimension = 3." : "."));
  }

  GmshScanner scanner_;
  FileMesh<dim> mesh_;
  /** Whether the version is 2.0 to 2.2. */
  bool is_old_ = false;
  /** Names by the number of a group, of whatever dimension. */
  std::map<int, std::string> names_without_dimension_;
  /** The physical groups of entities, by dimension and number. */
  std::map<std::pair<unsigned int, int>, int> groups_;
  std::unordered_map<std::size_t, unsigned int> index_of_tag_;
};
} // namespace

bool is_gmsh_text(const std::string &text) {
  std::istringstream beginning(text.substr(0, 100));
  std::string section, version, type;
  beginning >> section >> version >> type;
  return section == "$MeshFormat" && (is_version_2(version) || version == "4.1") && type == "0";
}

template <int dim>
FileMesh<dim> read_gmsh(const std::string &text, const std::string &name) {
  return GmshReader<dim>(text, name).read();
}

INSTANTIATE_FUNCTION(read_gmsh);
} // namespace Signorini
