// SPDX-License-Identifier: LGPL-2.1-or-later
// The deformed body on its foundation.

#include <signorini/results/pictures/deformed_picture.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "drawn_cells.h"

namespace Signorini
{
namespace
{
using Polyline = std::vector<Point<2>>;

/** The rectangle that is drawn. */
struct Frame
{
  Point<2> lower = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Point<2> upper = -1. * lower;

  void include(const Point<2> &x)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      lower[d] = std::min(lower[d], x[d]);
      upper[d] = std::max(upper[d], x[d]);
    }
  }
  void include(const Polyline &points)
  {
    for (const Point<2> &x : points)
      include(x);
  }
};

/** Returns 1, 2 or 5 times a power of ten, at least 1, so that the largest displacement becomes at
 * most a tenth of the body. */
double magnification(const std::vector<DrawnCell> &cells, const double size)
{
  double largest = 0.;
  for (const DrawnCell &cell : cells)
    for (const DrawnPoint &point : cell.points)
      largest = std::max(largest, point.u.norm());
  const double wanted = 0.1 * size / largest;
  if (!std::isfinite(wanted) || wanted < 1.)
    return 1.;
  const double power = std::pow(10., std::floor(std::log10(wanted)));
  for (const double factor : {5., 2.})
    if (factor * power <= wanted)
      return factor * power;
  return power;
}

/** Returns the end of the scale of colours: the largest stress, unless only a few points near a
 * singular corner reach it. */
double end_of_colours(const std::vector<DrawnCell> &cells)
{
  std::vector<double> values;
  for (const DrawnCell &cell : cells)
    for (const DrawnPoint &point : cell.points)
      if (std::isfinite(point.von_mises))
        values.push_back(point.von_mises);
  if (values.empty())
    return 1.;
  const double largest = *std::max_element(values.begin(), values.end());
  const auto usual = values.begin() + static_cast<std::ptrdiff_t>(0.99 * (values.size() - 1.));
  std::nth_element(values.begin(), usual, values.end());
  constexpr double singular = 1.5;
  const double end = largest > singular * *usual ? *usual : largest;
  return end > 0. ? end : 1.;
}

/** Returns the points of an edge, 0 left, 1 right, 2 bottom, 3 top. */
std::vector<const DrawnPoint *> points_of_edge(const DrawnCell &cell, const unsigned int edge)
{
  std::vector<const DrawnPoint *> points;
  for (unsigned int k = 0; k <= cell.n; ++k)
  {
    const unsigned int end = edge % 2 == 0 ? 0 : cell.n;
    points.push_back(edge < 2 ? &cell.point(end, k) : &cell.point(k, end));
  }
  return points;
}

void write_point(std::ostream &script, const Point<2> &x)
{
  script << plot_number(x[0]) << " " << plot_number(x[1]) << " 0\n";
}

/** Writes a straight line. (What gnuplot's surfaces offer as lines, it joins to a grid.) */
void write_vector(std::ostream &script, const Point<2> &a, const Point<2> &b)
{
  script << plot_number(a[0]) << " " << plot_number(a[1]) << " 0 " << plot_number(b[0] - a[0])
         << " " << plot_number(b[1] - a[1]) << " 0\n";
}

/** Draws with one magnification. */
class BodyDrawing
{
public:
  BodyDrawing(std::ostream &script, const std::vector<DrawnCell> &cells, const double factor)
    : script_(script)
    , cells_(cells)
    , factor_(factor)
  {
    for (const DrawnCell &cell : cells)
      for (const DrawnPoint &point : cell.points)
      {
        frame_.include(point.x);
        frame_.include(deformed(point));
      }
  }

  Frame &frame()
  {
    return frame_;
  }
  const Frame &frame() const
  {
    return frame_;
  }

  void write_cells()
  {
    script_ << "$cells << END_OF_DATA\n";
    for (const DrawnCell &cell : cells_)
      for (unsigned int j = 0; j < cell.n; ++j)
        for (unsigned int i = 0; i < cell.n; ++i)
        {
          // A quadrilateral has two rows of two points, and the mean of their values as its colour.
          // All are one surface, which is the shortest for SVG; a row of holes parts them.
          write_corner(cell.point(i, j));
          write_corner(cell.point(i + 1, j));
          script_ << "\n";
          write_corner(cell.point(i, j + 1));
          write_corner(cell.point(i + 1, j + 1));
          script_ << "\nNaN NaN NaN\nNaN NaN NaN\n\n";
        }
    script_ << "END_OF_DATA\n";
  }

  /** Writes the edges of all cells, or of those at the boundary. */
  void write_edges(const std::string &name, const bool only_boundary, const bool is_deformed)
  {
    script_ << "$" << name << " << END_OF_DATA\n";
    for (const DrawnCell &cell : cells_)
      for (unsigned int edge = 0; edge < 4; ++edge)
      {
        if (only_boundary && !cell.at_boundary[edge])
          continue;
        const DrawnPoint *before = nullptr;
        for (const DrawnPoint *point : points_of_edge(cell, edge))
        {
          if (before != nullptr)
            write_vector(script_,
                         is_deformed ? deformed(*before) : before->x,
                         is_deformed ? deformed(*point) : point->x);
          before = point;
        }
      }
    script_ << "END_OF_DATA\n";
  }

private:
  Point<2> deformed(const DrawnPoint &point) const
  {
    return point.x + factor_ * point.u;
  }
  void write_corner(const DrawnPoint &point)
  {
    const Point<2> x = deformed(point);
    script_ << plot_number(x[0]) << " " << plot_number(x[1]) << " " << plot_number(point.von_mises)
            << "\n";
  }

  std::ostream &script_;
  const std::vector<DrawnCell> &cells_;
  const double factor_;
  Frame frame_;
};

/** The surface of the foundation along a contact side, and the line inside to which it is drawn. */
struct DrawnFoundation
{
  Polyline surface, inside;
};

/** Returns the runs of points of the foundation that are near the body. */
std::vector<DrawnFoundation> foundations(const std::vector<ContactSegment> &line,
                                         const double factor,
                                         const double size)
{
  constexpr double near = 0.15, thickness = 0.04;
  std::vector<DrawnFoundation> runs;
  bool open = false;
  unsigned int side = 0;
  for (const ContactSegment &segment : line)
  {
    open = open && segment.side_number == side;
    side = segment.side_number;
    for (const ContactPoint &point : segment.curve)
    {
      const double distance = factor * point.g;
      if (!(std::abs(distance) <= near * size + factor * point.u.norm()))
      {
        open = false;
        continue;
      }
      if (!open)
        runs.emplace_back();
      open = true;
      const Point<2> x = point.x + distance * point.n;
      Polyline &surface = runs.back().surface;
      // The point where two pieces meet comes twice.
      if (!surface.empty() && surface.back().distance(x) < 1e-3 * size &&
          &point != &line.back().curve.back())
        continue;
      surface.push_back(x);
      runs.back().inside.push_back(x + thickness * size * point.n);
    }
  }
  runs.erase(std::remove_if(runs.begin(),
                            runs.end(),
                            [](const DrawnFoundation &run) { return run.surface.size() < 2; }),
             runs.end());
  return runs;
}

void write_foundations(std::ostream &script, const std::vector<DrawnFoundation> &runs)
{
  for (const DrawnFoundation &run : runs)
  {
    Polyline outline = run.surface;
    outline.insert(outline.end(), run.inside.rbegin(), run.inside.rend());
    outline.push_back(outline.front());
    script << "set object polygon";
    for (std::size_t i = 0; i < outline.size(); ++i)
      script << (i == 0 ? " from " : " to ") << plot_number(outline[i][0]) << ","
             << plot_number(outline[i][1]);
    script << " behind fillstyle solid noborder fillcolor rgb \"" << Colour::foundation << "\"\n";
  }
  script << "$foundation << END_OF_DATA\n";
  for (const DrawnFoundation &run : runs)
  {
    for (const Point<2> &x : run.surface)
      write_point(script, x);
    script << "\n\n";
  }
  script << "END_OF_DATA\n";
}

void write_contact_sides(std::ostream &script,
                         const std::vector<ContactSegment> &line,
                         const double factor)
{
  script << "$contact << END_OF_DATA\n";
  unsigned int side = line.empty() ? 0 : line.front().side_number;
  for (const ContactSegment &segment : line)
  {
    if (segment.side_number != side)
      script << "\n\n";
    side = segment.side_number;
    for (const ContactPoint &point : segment.curve)
      write_point(script, point.x + factor * point.u);
  }
  script << "END_OF_DATA\n";
}

/** Writes the size of the picture, ranges with a margin, and the scale of colours from light to
 * dark. */
void set_view(std::ostream &script, const Frame &frame, const double end_of_scale)
{
  const Tensor<1, 2> extent = frame.upper - frame.lower;
  const double margin = 0.04 * std::max(extent[0], extent[1]);
  script << "set xrange [" << plot_number(frame.lower[0] - margin) << ":"
         << plot_number(frame.upper[0] + margin) << "]\nset yrange ["
         << plot_number(frame.lower[1] - margin) << ":" << plot_number(frame.upper[1] + margin)
         << "]\nset cbrange [0:" << plot_number(end_of_scale) << "]\n"
         << "set palette defined (0 '#FDFBE4', 0.2 '#F5D97C', 0.45 '#D98D4E', 0.7 '#9C4063', "
            "1 '#2D1160')\n"
         << "set view map\nset pm3d explicit corners2color mean\nset size ratio "
            "-1\nunset grid\n"
         << "set xlabel 'x'\nset ylabel 'y' norotate\n"
         << "set cblabel 'von Mises stress (force/area)'\n"
         << "set key at screen 0.5,0.04 center horizontal maxrows 1\n";
}
} // namespace

Picture deformed_picture(const DisplacementSpace<2> &space,
                         const Scene<2> &scene,
                         const Displacement &U,
                         const std::vector<ContactSegment> &line)
{
  const double size = scene.geometry.longest_extent();
  const std::vector<DrawnCell> cells = collect_drawn_cells(space, scene, U);
  const double factor = magnification(cells, size);
  const std::vector<DrawnFoundation> foundation = foundations(line, factor, size);
  std::ostringstream data;
  BodyDrawing drawing(data, cells, factor);
  for (const DrawnFoundation &run : foundation)
  {
    drawing.frame().include(run.surface);
    drawing.frame().include(run.inside);
  }
  constexpr std::size_t max_cells_with_edges = 1200;
  const bool has_edges = cells.size() <= max_cells_with_edges;
  drawing.write_cells();
  drawing.write_edges("undeformed", true, false);
  drawing.write_edges("edges", !has_edges, true);
  write_contact_sides(data, line, factor);
  write_foundations(data, foundation);

  const Tensor<1, 2> extent = drawing.frame().upper - drawing.frame().lower;
  constexpr double width = 820., plot_width = 600., around = 150.;
  const double height = std::min(900., std::max(360., around + plot_width * extent[1] / extent[0]));
  std::ostringstream script;
  start_script(script, static_cast<unsigned int>(width), static_cast<unsigned int>(height));
  set_view(script, drawing.frame(), end_of_colours(cells));
  const std::string title = "Deformed body, displacement and gap × " + plot_number(factor);
  script << data.str() << "set title " << plot_text(title) << "\n"
         << "splot $cells with pm3d notitle, "
         << "$undeformed with vectors nohead lw 0.8 lc rgb \"" << Colour::grey
         << "\" title 'undeformed', $edges with vectors nohead lw 0.4 lc rgb '#606060' notitle, "
         << "$contact with lines lw 2.5 lc rgb \"" << Colour::blue << "\" title 'contact side'";
  if (!foundation.empty())
    script << ", $foundation with lines lw 1.5 lc rgb '#5A554E' title 'foundation'";
  script << "\n";
  return {"deformed.svg", title + ", coloured by von Mises stress", script.str()};
}
} // namespace Signorini
