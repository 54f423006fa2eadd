// SPDX-License-Identifier: LGPL-2.1-or-later
// Carries the lacking resultants of cells to the supports.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/stress/balance.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

#include <cmath>

namespace Signorini
{
namespace
{
using Vector2 = Tensor<1, 2>;

constexpr unsigned int no_cell = static_cast<unsigned int>(-1);

/** An edge of a cell, with its number in the cell. */
struct CellEdge
{
  unsigned int cell, k;
};

/** Adds the linear traction with the given resultant on edge k of a cell. */
void add_resultant(const EdgeCell &cell,
                   const unsigned int k,
                   const Resultant<2> &resultant,
                   std::vector<double> &moments)
{
  const Point<2> &a = cell.corners[k], &b = cell.corners[(k + 1) % 4];
  const Point<2> middle = a + 0.5 * (b - a);
  Vector2 normal({b[1] - a[1], a[0] - b[0]});
  normal /= normal.norm();
  // Half of the force at either end, and a couple that is normal to the edge.
  const double couple = resultant.moment_about(middle)[0] / moment_of(a - b, normal)[0];
  CellMoments change{};
  for (unsigned int c = 0; c < 2; ++c)
  {
    change[4 * k + c] = 0.5 * resultant.force[c] + couple * normal[c];
    change[4 * k + 2 + c] = 0.5 * resultant.force[c] - couple * normal[c];
  }
  add_moments(cell, change, moments);
}

/** A tree of cells: every cell but the root stores the edge that leads towards the root. */
class CellTree
{
public:
  CellTree(const EdgeMesh &mesh, const unsigned int root)
    : mesh_(mesh)
    , parent_(mesh.cells().size(), {no_cell, 0})
  {
    std::vector<std::array<unsigned int, 2>> cells_at(mesh.edges().size(), {{no_cell, no_cell}});
    for (unsigned int c = 0; c < mesh.cells().size(); ++c)
      for (unsigned int k = 0; k < 4; ++k)
        cells_at[mesh.cells()[c].edges[k]][mesh.cells()[c].sign[k] > 0. ? 0 : 1] = c;
    order_.push_back(root);
    for (std::size_t i = 0; i < order_.size(); ++i)
      for (const unsigned int edge : mesh.cells()[order_[i]].edges)
        for (const unsigned int other : cells_at[edge])
          if (other != no_cell && other != root && parent_[other].cell == no_cell)
          {
            unsigned int k = 0;
            while (mesh.cells()[other].edges[k] != edge)
              ++k;
            parent_[other] = {order_[i], k};
            order_.push_back(other);
          }
  }
  /**
   * Passes the lacking resultant of every cell on to its parent.
   * @return the resultant that the root lacks then.
   */
  Resultant<2> collect(std::vector<Resultant<2>> lacking, std::vector<double> &moments) const
  {
    for (std::size_t i = order_.size(); i-- > 1;)
    {
      const unsigned int c = order_[i];
      add_resultant(mesh_.cells()[c], parent_[c].k, lacking[c], moments);
      lacking[parent_[c].cell] += lacking[c];
    }
    return lacking[order_[0]];
  }
  /** Hands a resultant over from the root to a cell: the traction on the cell, from the side of the
   * root, is its opposite. */
  void hand_over(unsigned int cell, Resultant<2> resultant, std::vector<double> &moments) const
  {
    resultant.force *= -1.;
    resultant.moment *= -1.;
    for (; parent_[cell].cell != no_cell; cell = parent_[cell].cell)
      add_resultant(mesh_.cells()[cell], parent_[cell].k, resultant, moments);
  }

private:
  const EdgeMesh &mesh_;
  std::vector<CellEdge> parent_;
  std::vector<unsigned int> order_;
};

/** Returns the edges that take the remaining resultant: one for any traction, or two rollers. */
std::vector<CellEdge> find_supports(const EdgeMesh &mesh)
{
  std::vector<CellEdge> rollers;
  Vector2 first_normal;
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    for (unsigned int k = 0; k < 4; ++k)
    {
      const Edge &edge = mesh.edges()[mesh.cells()[c].edges[k]];
      if (edge.side == Edge::no_side || edge.freedom == EdgeFreedom::none)
        continue;
      if (edge.freedom == EdgeFreedom::any)
        return {{c, k}};
      if (rollers.empty())
        first_normal = edge.normal;
      if (rollers.empty() ||
          (rollers.size() == 1 && std::abs(moment_of(first_normal, edge.normal)[0]) > 1e-3))
        rollers.push_back({c, k});
    }
  return rollers;
}

/** Returns, for every cell, the resultant of rest at its corners. */
std::vector<Resultant<2>> lacking_resultants(const EdgeMesh &mesh, const std::vector<Vector2> &rest)
{
  std::vector<Resultant<2>> lacking(mesh.cells().size());
  for (std::size_t c = 0; c < lacking.size(); ++c)
    for (unsigned int a = 0; a < 4; ++a)
      lacking[c].add(rest[mesh.cells()[c].vertices[a]], mesh.cells()[c].corners[a]);
  return lacking;
}
} // namespace

bool balance_cells(const EdgeMesh &mesh,
                   const std::vector<Vector2> &rest,
                   std::vector<double> &moments)
{
  const std::vector<CellEdge> supports = find_supports(mesh);
  if (supports.empty())
    return false;
  const EdgeCell &root = mesh.cells()[supports[0].cell];
  const Edge &edge = mesh.edges()[root.edges[supports[0].k]];
  if (edge.freedom == EdgeFreedom::normal && supports.size() < 2)
    return false;
  const CellTree tree(mesh, supports[0].cell);
  Resultant<2> left = tree.collect(lacking_resultants(mesh, rest), moments);
  if (edge.freedom == EdgeFreedom::normal)
  {
    // The second roller takes the part of the force that the first one cannot.
    const EdgeCell &cell = mesh.cells()[supports[1].cell];
    const unsigned int k = supports[1].k;
    const Vector2 &n = mesh.edges()[cell.edges[k]].normal;
    const double size = moment_of(edge.normal, left.force)[0] / moment_of(edge.normal, n)[0];
    Resultant<2> second;
    second.add(size * n, cell.corners[k] + 0.5 * (cell.corners[(k + 1) % 4] - cell.corners[k]));
    add_resultant(cell, k, second, moments);
    tree.hand_over(supports[1].cell, second, moments);
    left.force -= second.force;
    left.moment -= second.moment;
    // Normal up to rounding.
    left.force = (left.force * edge.normal) * edge.normal;
  }
  add_resultant(root, supports[0].k, left, moments);
  return true;
}

// The best stress in equilibrium, by one sparse factorisation.

namespace
{
/** The unknown components of moments. */
class FreeMoments
{
public:
  /** A multiple of an unknown. */
  struct Term
  {
    unsigned int unknown;
    double factor;
  };

  explicit FreeMoments(const EdgeMesh &mesh)
    : mesh_(mesh)
    , first_(mesh.edges().size())
  {
    for (std::size_t e = 0; e < mesh.edges().size(); ++e)
    {
      first_[e] = size_;
      size_ += 2 * n_directions(mesh.edges()[e]);
    }
  }
  unsigned int size() const
  {
    return size_;
  }
  /** Returns the terms of component c of the moment that edge k of a cell has at corner k + end. */
  std::vector<Term> terms(const EdgeCell &cell,
                          const unsigned int k,
                          const unsigned int end,
                          const unsigned int c) const
  {
    const Edge &edge = mesh_.edges()[cell.edges[k]];
    const unsigned int n = n_directions(edge);
    const unsigned int at_end = (EdgeMesh::position(cell, k, end) - 4 * cell.edges[k]) / 2;
    const unsigned int first = first_[cell.edges[k]] + n * at_end;
    if (n == 2)
      return {{first + c, cell.sign[k]}};
    if (n == 1)
      return {{first, cell.sign[k] * edge.normal[c]}};
    return {};
  }
  /** Returns the moments, see EdgeMesh. */
  std::vector<double> moments(const dealii::Vector<double> &unknowns) const
  {
    std::vector<double> result(mesh_.n_moments(), 0.);
    for (std::size_t e = 0; e < mesh_.edges().size(); ++e)
    {
      const Edge &edge = mesh_.edges()[e];
      const unsigned int n = n_directions(edge);
      for (unsigned int end = 0; end < 2; ++end)
        for (unsigned int c = 0; c < 2 && n > 0; ++c)
          result[4 * e + 2 * end + c] =
            n == 2 ? unknowns[first_[e] + 2 * end + c] : edge.normal[c] * unknowns[first_[e] + end];
    }
    return result;
  }
  /** Applies the transpose of moments(). */
  void add_transposed(const std::vector<double> &moments, dealii::Vector<double> &unknowns) const
  {
    for (std::size_t e = 0; e < mesh_.edges().size(); ++e)
    {
      const Edge &edge = mesh_.edges()[e];
      const unsigned int n = n_directions(edge);
      for (unsigned int end = 0; end < 2; ++end)
        for (unsigned int c = 0; c < 2 && n > 0; ++c)
          unknowns[first_[e] + n * end + (n == 2 ? c : 0)] +=
            (n == 2 ? 1. : edge.normal[c]) * moments[4 * e + 2 * end + c];
    }
  }

private:
  static unsigned int n_directions(const Edge &edge)
  {
    return edge.freedom == EdgeFreedom::any ? 2 : (edge.freedom == EdgeFreedom::normal ? 1 : 0);
  }

  const EdgeMesh &mesh_;
  std::vector<unsigned int> first_;
  unsigned int size_ = 0;
};

/** Returns the terms of all 16 moments of a cell. */
std::array<std::vector<FreeMoments::Term>, 16> cell_terms(const FreeMoments &free,
                                                          const EdgeCell &cell)
{
  std::array<std::vector<FreeMoments::Term>, 16> terms;
  for (unsigned int j = 0; j < 16; ++j)
    terms[j] = free.terms(cell, j / 4, j % 4 / 2, j % 2);
  return terms;
}

/** Returns the coefficient of moment j in force 0 or 1, or in the moment about corner 0 over the
 * size. */
double balance_entry(const EdgeCell &cell, const unsigned int j, const unsigned int row)
{
  if (row < 2)
    return j % 2 == row ? 1. : 0.;
  const Tensor<1, 2> arm = (cell.corners[(j / 4 + j % 4 / 2) % 4] - cell.corners[0]) /
                           cell.corners[0].distance(cell.corners[2]);
  return j % 2 == 0 ? -arm[1] : arm[0];
}

/** Calls add(row, column, value) for all entries of the matrix, with S times @p scale. */
template <typename Add>
void for_all_entries(const EdgeMesh &mesh,
                     const CellEnergies &energies,
                     const FreeMoments &free,
                     const double scale,
                     const Add &add)
{
  for (unsigned int number = 0; number < mesh.cells().size(); ++number)
  {
    const EdgeCell &cell = mesh.cells()[number];
    const auto terms = cell_terms(free, cell);
    const CellEnergy &energy = energies(number);
    for (unsigned int i = 0; i < 16; ++i)
      for (const FreeMoments::Term &a : terms[i])
      {
        for (unsigned int j = 0; j < 16; ++j)
          for (const FreeMoments::Term &b : terms[j])
            add(a.unknown, b.unknown, scale * a.factor * b.factor * energy[16 * i + j]);
        for (unsigned int row = 0; row < 3; ++row)
          if (const double entry = balance_entry(cell, i, row); entry != 0.)
          {
            const unsigned int at = free.size() + 3 * number + row;
            add(a.unknown, at, a.factor * entry);
            add(at, a.unknown, a.factor * entry);
          }
      }
  }
}

/** Returns the multipliers of a cell that do no work on any edge which may carry tractions: the
 * rigid motions that such edges leave to the body, in the coordinates of the cell. */
std::vector<std::array<double, 3>> free_motions(const EdgeMesh &mesh, const EdgeCell &frame_cell)
{
  // A motion moves x by (a - w y, b + w x)/size, x and y from corner 0 of the cell.
  const double size = frame_cell.corners[0].distance(frame_cell.corners[2]);
  SymmetricTensor<2, 3> work;
  for (const EdgeCell &cell : mesh.cells())
    for (unsigned int k = 0; k < 4; ++k)
    {
      const Edge &edge = mesh.edges()[cell.edges[k]];
      if (edge.side == Edge::no_side || edge.freedom == EdgeFreedom::none)
        continue;
      for (const unsigned int corner : {k, (k + 1) % 4})
      {
        const Tensor<1, 2> arm = (cell.corners[corner] - frame_cell.corners[0]) / size;
        for (unsigned int d = 0; d < (edge.freedom == EdgeFreedom::any ? 2 : 1); ++d)
        {
          Tensor<1, 2> n = edge.normal;
          if (edge.freedom == EdgeFreedom::any)
            n = Point<2>::unit_vector(d);
          const Tensor<1, 3> row({n[0], n[1], arm[0] * n[1] - arm[1] * n[0]});
          work += symmetrize(outer_product(row, row));
        }
      }
    }
  std::vector<std::array<double, 3>> motions;
  const auto pairs = eigenvectors(work);
  for (const auto &[stopped, motion] : pairs)
    if (stopped <= 1e-10 * pairs[0].first)
      motions.push_back({{motion[0], motion[1], motion[2]}});
  return motions;
}
} // namespace

std::vector<double> optimal_change(const EdgeMesh &mesh,
                                   const CellEnergies &energies,
                                   const std::vector<double> &r)
{
  const FreeMoments free(mesh);
  const unsigned int n = free.size() + 3 * mesh.cells().size();
  const auto motions = free_motions(mesh, mesh.cells()[0]);
  double largest = 0.;
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    for (unsigned int j = 0; j < 16; ++j)
      largest = std::max(largest, energies(c)[17 * j]);
  if (!(largest > 0.) || !std::isfinite(largest))
    return {};
  const double scale = 1. / largest;
  DynamicSparsityPattern entries(n, n);
  for_all_entries(mesh, energies, free, scale, [&](const auto i, const auto j, const double) {
    entries.add(i, j);
  });
  const auto for_multipliers_of_first_cell = [&](const auto &add) {
    for (const std::array<double, 3> &motion : motions)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          add(free.size() + i, free.size() + j, -motion[i] * motion[j]);
  };
  for_multipliers_of_first_cell(
    [&](const auto i, const auto j, const double) { entries.add(i, j); });
  SparsityPattern pattern;
  pattern.copy_from(entries);
  SparseMatrix<double> matrix(pattern);
  for_all_entries(mesh, energies, free, scale, [&](const auto i, const auto j, const double value) {
    matrix.add(i, j, value);
  });
  for_multipliers_of_first_cell(
    [&](const auto i, const auto j, const double value) { matrix.add(i, j, value); });
  dealii::Vector<double> rhs(n);
  free.add_transposed(r, rhs);
  rhs *= scale;
  dealii::Vector<double> x(rhs), residual(n);
  try
  {
    SparseDirectUMFPACK().solve(matrix, x);
  }
  catch (const ExceptionBase &)
  {
    return {};
  }
  constexpr double tolerance = 1e-9;
  if (!(matrix.residual(residual, x, rhs) <= tolerance * x.l2_norm()))
    return {};
  return free.moments(x);
}
} // namespace Signorini
