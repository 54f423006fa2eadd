// SPDX-License-Identifier: LGPL-2.1-or-later
// The lift w in the body: columns of cells below contact faces, and energies.

#include <signorini/error_control/contact_term/lift_field.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using dealii::GeometryInfo;
using dealii::Point;
using dealii::Tensor;

/** Returns d(N_v)/dx_k of the four bilinear shape functions. */
std::array<Tensor<1, 2>, 4> shape_gradients(const Point<2> &x)
{
  std::array<Tensor<1, 2>, 4> gradients;
  for (unsigned int v = 0; v < 4; ++v)
    gradients[v] = GeometryInfo<2>::d_linear_shape_function_gradient(x, v);
  return gradients;
}

/** across() returns the distance from the edge @p entry in reference coordinates, along() the
 * position along it. */
double across(const Point<2> &x, const unsigned int entry)
{
  return entry % 2 == 0 ? x[entry / 2] : 1. - x[entry / 2];
}
double along(const Point<2> &x, const unsigned int entry, const bool flipped)
{
  const double t = x[1 - entry / 2];
  return flipped ? 1. - t : t;
}

/** The maximal number of cells per column. */
constexpr unsigned int max_column_length = 64;
} // namespace

LiftField::LiftField(const DisplacementSpace<2> &space,
                     const Scene<2> &scene,
                     const ContactTrace &trace,
                     Displacement w_h,
                     std::vector<EdgeFunction> remainders)
  : space_(space)
  , scene_(scene)
  , trace_(trace)
  , w_h_(std::move(w_h))
  , remainders_(std::move(remainders))
  , rules_{QGauss<1>(2), QGauss<1>(3), QGauss<1>(4)}
{
  if (!scene.material->is_constant())
    sampling_.emplace(*scene.material, space.mesh().triangulation().n_active_cells());
  for (unsigned int face = 0; face < remainders_.size(); ++face)
    if (!remainders_[face].is_zero())
      add_column(face);
}

double LiftField::depth(const unsigned int face) const
{
  const PenetrationFace &F = trace_.faces()[face];
  const auto C = scene_.material->hooke(F.point(0.5));
  const Tensor<1, 2> n = F.normal;
  Tensor<1, 2> m;
  m[0] = -n[1];
  m[1] = n[0];
  const auto nn = symmetrize(outer_product(n, n)), nm = symmetrize(outer_product(n, m));
  const double squares = F.length * remainders_[face].square_integral();
  const double slopes = remainders_[face].slope_integral() / F.length;
  return std::sqrt(3. * (nn * (C * nn)) * squares / ((nm * (C * nm)) * slopes));
}

void LiftField::add_column(const unsigned int face)
{
  struct Step
  {
    CellIterator cell;
    unsigned int entry;
    bool flipped;
    double height;
  };
  const ContactFace<2> &contact = trace_.surface().faces()[trace_.faces()[face].number];
  const double wanted = depth(face);
  std::vector<Step> steps;
  double reached = 0.;
  CellIterator cell = space_.dof_cell(contact.cell);
  unsigned int entry = contact.face_no;
  bool flipped = false;
  while (true)
  {
    const unsigned int exit = GeometryInfo<2>::opposite_face[entry];
    const double height = cell->face(entry)->center().distance(cell->face(exit)->center());
    steps.push_back({cell, entry, flipped, height});
    reached += height;
    if (reached >= wanted || steps.size() == max_column_length || cell->face(exit)->at_boundary() ||
        cell->neighbor(exit)->level() != cell->level() || cell->neighbor(exit)->has_children())
      break;
    const auto next = cell->neighbor(exit);
    const unsigned int next_entry = cell->neighbor_of_neighbor(exit);
    const bool same_direction =
      cell->vertex_index(GeometryInfo<2>::face_to_cell_vertices(exit, 0)) ==
      next->vertex_index(GeometryInfo<2>::face_to_cell_vertices(next_entry, 0));
    flipped = flipped == same_direction;
    cell = next;
    entry = next_entry;
  }
  const double D = std::min(wanted, reached);
  double top = 1.;
  for (const Step &step : steps)
  {
    const double slope = step.height / D;
    passages_[step.cell->active_cell_index()].push_back(
      {face, step.entry, step.flipped, top, slope});
    top -= slope;
  }
  // Rounding must not leave anything at the end.
  if (D == reached)
    passages_[steps.back().cell->active_cell_index()].back().slope =
      passages_[steps.back().cell->active_cell_index()].back().top;
}

double LiftField::normal_value(const unsigned int face, const double t) const
{
  return trace_.faces()[face].normal_value(w_h_, t) + remainders_[face].value(t);
}

LiftField::LocalField LiftField::local_field(const CellIterator &cell) const
{
  static const std::vector<Passage> none;
  LocalField field = {};
  for (unsigned int v = 0; v < 4; ++v)
  {
    field.vertices[v] = cell->vertex(v);
    for (unsigned int d = 0; d < 2; ++d)
      field.w_h[v][d] = w_h_[cell->vertex_dof_index(v, d)];
  }
  const auto found = passages_.find(cell->active_cell_index());
  field.passages = found == passages_.end() ? &none : &found->second;
  return field;
}

Tensor<1, 2> LiftField::value(const CellIterator &cell, const Point<2> &reference) const
{
  const LocalField field = local_field(cell);
  Tensor<1, 2> w;
  for (unsigned int v = 0; v < 4; ++v)
    w += GeometryInfo<2>::d_linear_shape_function(reference, v) * field.w_h[v];
  for (const Passage &passage : *field.passages)
  {
    const double psi = passage.top - passage.slope * across(reference, passage.entry);
    const double t = along(reference, passage.entry, passage.flipped);
    if (psi > 0.)
      w += psi * remainders_[passage.face].value(t) * trace_.faces()[passage.face].normal;
  }
  return w;
}

Tensor<2, 2> LiftField::reference_gradient(const LocalField &field, const Point<2> &x) const
{
  const auto shapes = shape_gradients(x);
  Tensor<2, 2> gradient;
  for (unsigned int v = 0; v < 4; ++v)
    gradient += outer_product(field.w_h[v], shapes[v]);
  for (const Passage &passage : *field.passages)
  {
    const double psi = passage.top - passage.slope * across(x, passage.entry);
    if (psi <= 0.)
      continue;
    const double t = along(x, passage.entry, passage.flipped);
    const EdgeFunction &r = remainders_[passage.face];
    Tensor<1, 2> slopes;
    slopes[1 - passage.entry / 2] = psi * r.slope(t) * (passage.flipped ? -1. : 1.);
    slopes[passage.entry / 2] = -passage.slope * r.value(t) * (passage.entry % 2 == 0 ? 1. : -1.);
    gradient += outer_product(trace_.faces()[passage.face].normal, slopes);
  }
  return gradient;
}

std::vector<double> LiftField::cuts(const CellIterator &cell,
                                    const LocalField &field,
                                    const unsigned int d,
                                    const unsigned int n_equal) const
{
  std::vector<double> cuts;
  for (unsigned int i = 0; i <= n_equal; ++i)
    cuts.push_back(static_cast<double>(i) / n_equal);
  if (field.passages->empty() && scene_.material->is_constant())
    return cuts;
  for (const Passage &passage : *field.passages)
    if (passage.entry / 2 == d)
    {
      const double end = passage.top / passage.slope;
      if (end < 1.)
        cuts.push_back(passage.entry % 2 == 0 ? end : 1. - end);
    }
    else
      for (const EdgeFunction::Part &part : remainders_[passage.face].parts())
        cuts.push_back(passage.flipped ? 1. - part.end : part.end);
  if (!scene_.material->is_constant())
    for (const unsigned int edge : {0, 1})
    {
      // Edges 2 and 3 run along x, edges 0 and 1 along y.
      const auto line = cell->face(2 * (1 - d) + edge);
      const auto crossings = scene_.kinks.cut(line->vertex(0), line->vertex(1));
      cuts.insert(cuts.end(), crossings.begin(), crossings.end());
    }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(),
                         cuts.end(),
                         [](const double a, const double b) { return b - a < 1e-13; }),
             cuts.end());
  return cuts;
}

unsigned int LiftField::n_equal_parts(const LocalField &field) const
{
  if (!sampling_)
    return 1;
  const auto &x = field.vertices;
  return LawSampling::varies(sampling_->scan({{x[0], x[1], x[3], x[2]}}))
           ? (sampling_->intervals() + 3) / 4
           : 1;
}

double LiftField::energy_of(const CellIterator &cell, const LocalField &field) const
{
  const bool constant = scene_.material->is_constant();
  const bool affine =
    (field.vertices[0] + (field.vertices[3] - field.vertices[1]) - field.vertices[2]).norm() <
    1e-12 * field.vertices[0].distance(field.vertices[3]);
  const QGauss<1> &rule = rules_[constant && affine ? (field.passages->empty() ? 0 : 1) : 2];
  const unsigned int n_equal = n_equal_parts(field);
  const std::vector<double> x_cuts = cuts(cell, field, 0, n_equal),
                            y_cuts = cuts(cell, field, 1, n_equal);
  SymmetricTensor<4, 2> C;
  if (constant)
    C = scene_.material->hooke(field.vertices[0]);
  double energy = 0.;
  for (std::size_t i = 0; i + 1 < x_cuts.size(); ++i)
    for (std::size_t j = 0; j + 1 < y_cuts.size(); ++j)
      for (unsigned int p = 0; p < rule.size(); ++p)
        for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const double width = x_cuts[i + 1] - x_cuts[i], height = y_cuts[j + 1] - y_cuts[j];
          const Point<2> x(x_cuts[i] + width * rule.point(p)[0],
                           y_cuts[j] + height * rule.point(q)[0]);
          const auto shapes = shape_gradients(x);
          Tensor<2, 2> J;
          Point<2> place;
          for (unsigned int v = 0; v < 4; ++v)
          {
            J += outer_product(Tensor<1, 2>(field.vertices[v]), shapes[v]);
            place += GeometryInfo<2>::d_linear_shape_function(x, v) * field.vertices[v];
          }
          const auto strain = symmetrize(reference_gradient(field, x) * invert(J));
          if (!constant)
            C = scene_.material->hooke(place);
          energy += strain * (C * strain) * std::abs(determinant(J)) * width * height *
                    rule.weight(p) * rule.weight(q);
        }
  return energy;
}

dealii::Vector<double> LiftField::cell_energies() const
{
  dealii::Vector<double> energies(space_.mesh().triangulation().n_active_cells());
  for (const auto &cell : space_.dofs().active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const LocalField field = local_field(cell);
      const bool zero = field.passages->empty() &&
                        std::all_of(field.w_h.begin(), field.w_h.end(), [](const auto &w) {
                          return w.norm_square() == 0.;
                        });
      if (!zero)
        energies[cell->active_cell_index()] = energy_of(cell, field);
    }
  return energies;
}
} // namespace Signorini
