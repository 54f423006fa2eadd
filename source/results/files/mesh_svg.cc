// SPDX-License-Identifier: LGPL-2.1-or-later
// A picture of a graded mesh and its degrees.

#include <signorini/results/files/mesh_svg.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <map>
#include <vector>

namespace Signorini
{
namespace
{
using Outline = std::vector<Point<2>>;

/** A cell as a polygon, and those of its edges on which there is contact. */
struct DrawnCell
{
  Outline outline;
  std::vector<Outline> contact_edges;
  unsigned int degree;
  double size;
};

/** A rectangle of the body's plane, and where it is drawn (pixels, y downwards). */
struct Panel
{
  Point<2> lower, upper;
  double left, top, scale;

  double width() const
  {
    return scale * (upper[0] - lower[0]);
  }
  double height() const
  {
    return scale * (upper[1] - lower[1]);
  }
  Point<2> pixel(const Point<2> &x) const
  {
    return {left + scale * (x[0] - lower[0]), top + scale * (upper[1] - x[1])};
  }
};

constexpr double body_pixels = 600., zoom_pixels = 400., margin = 20., line_height = 24.;

/** Returns the colour of a degree, from dark to light; it is the same in all pictures. */
const char *colour(const unsigned int degree)
{
  constexpr const char *colours[] = {
    "#440154", "#46327e", "#365c8d", "#277f8e", "#1fa187", "#4ac16d", "#a0da39", "#fde725"};
  constexpr unsigned int lowest = 2, n_colours = std::size(colours);
  return colours[std::min(std::max(degree, lowest) - lowest, n_colours - 1)];
}

/** Returns the line from one corner of a cell to another, with points between them where it is
 * curved. */
Outline edge_points(const Mapping<2> &mapping,
                    const Triangulation<2>::active_cell_iterator &cell,
                    const unsigned int from,
                    const unsigned int to,
                    const bool curved)
{
  const unsigned int n_parts = curved ? 8 : 1;
  const Point<2> a = GeometryInfo<2>::unit_cell_vertex(from);
  const Tensor<1, 2> step = GeometryInfo<2>::unit_cell_vertex(to) - a;
  Outline points = {cell->vertex(from)};
  for (unsigned int i = 1; i < n_parts; ++i)
    points.push_back(
      mapping.transform_unit_to_real_cell(cell, a + static_cast<double>(i) / n_parts * step));
  points.push_back(cell->vertex(to));
  return points;
}

std::vector<DrawnCell> collect_cells(const DisplacementSpace<2> &space, const Scene<2> &scene)
{
  // Counter-clockwise: the corners of an edge and its number.
  constexpr unsigned int edges[4][3] = {{0, 1, 2}, {1, 3, 1}, {3, 2, 3}, {2, 0, 0}};
  std::vector<DrawnCell> cells;
  for (const auto &cell : space.mesh().triangulation().active_cell_iterators())
  {
    DrawnCell drawn = {{}, {}, space.element(cell).degree, cell->diameter()};
    for (const auto &[from, to, number] : edges)
    {
      const Outline edge =
        edge_points(space.mesh().mapping(), cell, from, to, space.mesh().is_curved());
      drawn.outline.insert(drawn.outline.end(), edge.begin(), edge.end() - 1);
      const auto face = cell->face(number);
      if (face->at_boundary() && scene.boundary[face->boundary_id()].role == Role::contact)
        drawn.contact_edges.push_back(edge);
    }
    cells.push_back(drawn);
  }
  return cells;
}

/** Returns the part of a polygon on one side of a line x_d = position. (Sutherland and Hodgman,
 * Comm. ACM 17 (1974) 32-42.) */
Outline
cut(const Outline &polygon, const unsigned int d, const double position, const double direction)
{
  Outline part;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point<2> &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = direction * (a[d] - position), at_b = direction * (b[d] - position);
    if (at_a >= 0.)
      part.push_back(a);
    if ((at_a > 0. && at_b < 0.) || (at_a < 0. && at_b > 0.))
      part.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return part;
}

Outline cut(const Outline &polygon, const Panel &panel)
{
  Outline part = polygon;
  for (unsigned int d = 0; d < 2; ++d)
  {
    part = cut(part, d, panel.lower[d], 1.);
    part = cut(part, d, panel.upper[d], -1.);
  }
  return part;
}

Point<2> centroid(const Outline &outline)
{
  Tensor<1, 2> sum;
  for (const Point<2> &x : outline)
    sum += x;
  return Point<2>(sum / static_cast<double>(outline.size()));
}

/** Returns the panels: the body, and views of the smallest cell, each magnified by the same factor
 * against the one before, until that cell can be seen. */
std::vector<Panel> choose_panels(const Scene<2> &scene, const std::vector<DrawnCell> &cells)
{
  const Point<2> &lower = scene.geometry.lower, &upper = scene.geometry.upper;
  const double extent = scene.geometry.longest_extent();
  std::vector<Panel> panels = {{lower, upper, margin, margin, body_pixels / extent}};
  const auto smaller = [](const DrawnCell &a, const DrawnCell &b) {
    const bool a_touches = !a.contact_edges.empty(), b_touches = !b.contact_edges.empty();
    // Of equal cells the first one is taken.
    return a_touches == b_touches ? a.size < 0.999 * b.size : a_touches;
  };
  const DrawnCell &smallest = *std::min_element(cells.begin(), cells.end(), smaller);
  constexpr double visible = 12., clear = 30., max_zoom_factor = 24.;
  if (smallest.size * panels.front().scale >= visible)
    return panels;
  const double last_width = smallest.size * zoom_pixels / clear;
  const double n = std::ceil(std::log(extent / last_width) / std::log(max_zoom_factor));
  const Point<2> centre = centroid(smallest.outline);
  for (unsigned int i = 1; i <= n; ++i)
  {
    const double width = extent * std::pow(last_width / extent, i / n);
    Point<2> corner;
    for (unsigned int d = 0; d < 2; ++d)
      // Where the cell is at the edge of the body, the view ends there, too.
      corner[d] =
        std::min(std::max(centre[d] - 0.5 * width, lower[d]), std::max(upper[d] - width, lower[d]));
    const double left = panels.back().left + panels.back().width() + margin;
    panels.push_back(
      {corner, corner + Tensor<1, 2>({width, width}), left, margin, zoom_pixels / width});
  }
  return panels;
}

/** Writes the parts of a picture. */
class MeshDrawing
{
public:
  MeshDrawing(std::ostream &stream, const std::vector<DrawnCell> &cells)
    : stream_(stream)
    , cells_(cells)
  {
    for (const DrawnCell &cell : cells)
      ++n_cells_[cell.degree];
  }

  void start(const std::vector<Panel> &panels, const unsigned int number)
  {
    const double width = panels.back().left + panels.back().width() + margin;
    double height = 0.;
    for (const Panel &panel : panels)
      height = std::max(height, panel.height());
    height += 2. * margin + 2. * line_height;
    stream_ << std::setprecision(8) << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width
            << "\" height=\"" << height << "\" viewBox=\"0 0 " << width << " " << height
            << "\" font-family=\"sans-serif\" font-size=\"13\">\n"
            << "<title>Step " << number << ": " << cells_.size() << " cells, degrees "
            << n_cells_.begin()->first << " to " << n_cells_.rbegin()->first << "</title>\n"
            << "<rect width=\"" << width << "\" height=\"" << height << "\" fill=\"white\"/>\n";
  }

  void draw(const Panel &panel, const Panel *next)
  {
    stream_ << "<g class=\"panel\" stroke-linejoin=\"round\">\n"
            << "<g class=\"contact\" fill=\"none\" stroke=\"#d62728\" stroke-width=\"6\">\n";
    for (const DrawnCell &cell : cells_)
      for (const Outline &edge : cell.contact_edges)
      {
        // The line goes there and back again.
        Outline closed = edge;
        closed.insert(closed.end(), edge.rbegin() + 1, edge.rend() - 1);
        draw(cut(closed, panel), panel, 0.);
      }
    stream_ << "</g>\n";
    for (const auto &[degree, n] : n_cells_)
    {
      stream_ << "<g class=\"degree-" << degree << "\" fill=\"" << colour(degree)
              << "\" stroke=\"white\">\n";
      for (const DrawnCell &cell : cells_)
        if (cell.degree == degree)
          draw(cut(cell.outline, panel), panel, std::min(1., 0.03 * panel.scale * cell.size));
      stream_ << "</g>\n";
    }
    stream_ << "</g>\n";
    if (next != nullptr)
      frame(panel.pixel({next->lower[0], next->upper[1]}),
            panel.scale * (next->upper[0] - next->lower[0]));
  }

  void label(const Panel &panel, const double magnification)
  {
    stream_ << "<text x=\"" << panel.left << "\" y=\"" << panel.top + panel.height() + line_height
            << "\">" << std::round(magnification) << " times as large</text>\n";
  }

  void legend(const Panel &panel)
  {
    const double y = panel.top + panel.height() + line_height;
    double x = panel.left;
    const auto entry = [&](const char *fill, const std::string &text) {
      stream_ << "<rect x=\"" << x << "\" y=\"" << y - 12.
              << "\" width=\"14\" height=\"14\" fill=\"" << fill << "\"/><text x=\"" << x + 18.
              << "\" y=\"" << y << "\">" << text << "</text>\n";
      x += 72.;
    };
    stream_ << "<text x=\"" << x << "\" y=\"" << y + line_height
            << "\">Degree of the cells (how many). Red: contact sides.</text>\n";
    for (const auto &[degree, n] : n_cells_)
      entry(colour(degree), std::to_string(degree) + " (" + std::to_string(n) + ")");
  }

  void end()
  {
    stream_ << "</svg>\n";
  }

private:
  /** Draws a closed line; one that a panel has cut away is left out. */
  void draw(const Outline &outline, const Panel &panel, const double line_width)
  {
    if (outline.size() < 2)
      return;
    stream_ << "<path d=\"";
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      const Point<2> x = panel.pixel(outline[i]);
      stream_ << (i == 0 ? "M" : " ") << x[0] << "," << x[1];
    }
    stream_ << "Z\"";
    if (line_width > 0.)
      stream_ << " stroke-width=\"" << line_width << "\"";
    stream_ << "/>\n";
  }
  /** Draws the frame of the next panel. */
  void frame(const Point<2> &corner, const double width)
  {
    stream_ << "<rect x=\"" << corner[0] << "\" y=\"" << corner[1] << "\" width=\"" << width
            << "\" height=\"" << width << "\" fill=\"none\" stroke=\"black\"/>\n";
  }

  std::ostream &stream_;
  const std::vector<DrawnCell> &cells_;
  /** The numbers of cells by degree. */
  std::map<unsigned int, unsigned int> n_cells_;
};
} // namespace

void write_mesh_svg(std::ostream &stream,
                    const DisplacementSpace<2> &space,
                    const Scene<2> &scene,
                    const unsigned int number)
{
  const std::vector<DrawnCell> cells = collect_cells(space, scene);
  const std::vector<Panel> panels = choose_panels(scene, cells);
  MeshDrawing drawing(stream, cells);
  drawing.start(panels, number);
  for (std::size_t i = 0; i < panels.size(); ++i)
  {
    drawing.draw(panels[i], i + 1 < panels.size() ? &panels[i + 1] : nullptr);
    if (i > 0)
      drawing.label(panels[i], panels[i].scale / panels[0].scale);
  }
  drawing.legend(panels[0]);
  drawing.end();
}
} // namespace Signorini
