// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/base/errors.h>
#include <signorini/base/parallel.h>
#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/space/displacement_space.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <functional>
#include <map>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace Signorini {
template <int dim>
using Cells = std::vector<typename DoFHandler<dim>::active_cell_iterator>;

/** Returns the cells of this rank, in their order, in chunks that one thread works on at a time. */
template <int dim>
std::vector<Cells<dim>> chunks_of_owned_cells(const DisplacementSpace<dim> &space) {
  constexpr std::size_t chunk_size = 512;
  std::vector<Cells<dim>> chunks;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned()) {
      if (chunks.empty() || chunks.back().size() == chunk_size)
        chunks.emplace_back().reserve(chunk_size);
      chunks.back().push_back(cell);
    }
  return chunks;
}

/** Calls consume(integrate(chunk)) for the cells of this rank, with all threads given. The chunks
 * are the same for any number of threads, none depends on another (FEValues reads the cell before),
 * and they are consumed in order: so the digits are the same, too. Collective: if data has no value
 * on one rank, all of them throw. */
template <typename Result, int dim>
void integrate_by_chunks(const DisplacementSpace<dim> &space,
                         const std::function<Result(const Cells<dim> &)> &integrate,
                         const std::function<void(const Result &)> &consume) {
  const std::vector<Cells<dim>> chunks = chunks_of_owned_cells(space);
  agree(space.mesh().communicator(), [&]() {
    produce_in_parallel<Result>(
      n_available_threads(), chunks.size(),
      [&](const std::size_t i) { return integrate(chunks[i]); }, consume);
  });
}

/** The FEValues of cells (@p rule_dim = dim) or FEFaceValues, made once for each map, element and
 * rule: tabulating shape functions takes longer than using them. */
template <int dim, int rule_dim = dim>
class ValuesCache {
public:
  using Values =
    std::conditional_t<rule_dim == dim, dealii::FEValues<dim>, dealii::FEFaceValues<dim>>;
  /** Returns the rule with a number. */
  using Rule = std::function<Quadrature<rule_dim>(unsigned int)>;

  explicit ValuesCache(const UpdateFlags flags, Rule rule = gauss)
    : flags_(flags)
    , rule_(std::move(rule)) {}

  static Quadrature<rule_dim> gauss(const unsigned int n_points) {
    return QGauss<rule_dim>(n_points);
  }
  /** Returns the values at the points of a rule on a cell, valid until the next call. The map and
   * the element must outlive the object. @param at a cell, or a cell and the number of a face. */
  template <typename... Location>
  const Values &reinit(const Mapping<dim> &map, const FiniteElement<dim> &element,
                       const unsigned int rule_number, const Location &...at) {
    std::unique_ptr<Values> &values = values_[{&map, &element, rule_number}];
    if (values == nullptr)
      values = std::make_unique<Values>(map, element, rule_(rule_number), flags_);
    values->reinit(at...);
    return *values;
  }
  UpdateFlags flags() const {
    return flags_;
  }

private:
  UpdateFlags flags_;
  Rule rule_;
  std::map<std::tuple<const Mapping<dim> *, const FiniteElement<dim> *, unsigned int>,
           std::unique_ptr<Values>>
    values_;
};

/** The values at Gauss' points, or at those of pieces. Cells of degree p have p - 1 points per
 * direction more than those of degree one. */
template <int dim, int rule_dim>
class ValuesByElement {
public:
  /**
   * The arguments must outlive the object.
   * @param n_points per direction, for degree one.
   */
  ValuesByElement(const Mapping<dim> &mapping, const DisplacementSpace<dim> &space,
                  const Kinks<dim> &kinks, const unsigned int n_points, const UpdateFlags flags)
    : kinks_(kinks)
    , mapping_(mapping)
    , space_(space)
    , n_points_(n_points)
    , plain_(flags) {}

  /** Returns whether the last values were those of a cut_rule: the next ones destroy them. */
  bool is_cut() const {
    return cut_ != nullptr;
  }

protected:
  using Values = typename ValuesCache<dim, rule_dim>::Values;

  /** Returns the values with Gauss' rule, or with cut_rule(n_points); they are valid until the
   * next call. @param face_no the number of a face of the cell, or nothing. */
  template <typename CutRule, typename CellIterator, typename... FaceNumber>
  const Values &reinit_at(const bool is_cut, const CutRule &cut_rule, const CellIterator &cell,
                          const FaceNumber... face_no) {
    const FiniteElement<dim> &element = space_.element(cell);
    const unsigned int n_points = n_points_ + element.degree - 1;
    cut_.reset();
    if (!is_cut)
      return plain_.reinit(mapping_, element, n_points, cell, face_no...);
    cut_ = std::make_unique<Values>(mapping_, element, cut_rule(n_points), plain_.flags());
    cut_->reinit(cell, face_no...);
    return *cut_;
  }

  const Mapping<dim> &mapping() const {
    return mapping_;
  }

  const Kinks<dim> &kinks_;

private:
  const Mapping<dim> &mapping_;
  const DisplacementSpace<dim> &space_;
  unsigned int n_points_;
  ValuesCache<dim, rule_dim> plain_;
  /** The last values, if a rule of their own made them. */
  std::unique_ptr<Values> cut_;
};

/** The shape functions at the Gauss points of a cell; on the pieces of a cell that a kink crosses,
 * at the Gauss points of each piece. */
template <int dim>
class CellValues : public ValuesByElement<dim, dim> {
public:
  using ValuesByElement<dim, dim>::ValuesByElement;

  /**
   * Computes the values on a cell.
   * @param cell of the mesh, or of a DoFHandler where functions are to be evaluated.
   */
  template <typename CellIterator>
  const FEValues<dim> &reinit(const CellIterator &cell) {
    // In 3-D planes do not cut cells yet.
    const auto cut_rule = [&](const unsigned int n) -> Quadrature<dim> {
      if constexpr (dim == 2)
        return cut_quadrature(this->kinks_, cell, n, this->mapping());
      return QGauss<dim>(n);
    };
    const bool is_cut = dim == 2 && needs_cuts<dim>(this->kinks_, cell);
    return this->reinit_at(is_cut, cut_rule, cell);
  }
};

/** The shape functions at the Gauss points of a face; where a kink cuts the face, at the Gauss
 * points of its parts. */
template <int dim>
class FaceValues : public ValuesByElement<dim, dim - 1> {
public:
  using CellIterator = typename Triangulation<dim>::active_cell_iterator;
  using ValuesByElement<dim, dim - 1>::ValuesByElement;

  /** Computes the values on a face. @param side on which it lies. */
  const FEFaceValues<dim> &reinit(const CellIterator &cell, const unsigned int face_no,
                                  const Side<dim> &side) {
    const auto face = cell->face(face_no);
    // In 3-D planes do not cut faces yet.
    std::vector<double> cuts;
    if constexpr (dim == 2)
      cuts = cut_edge(this->kinks_, side, face->vertex(0), face->vertex(1));
    const auto cut_rule = [&](const unsigned int n) -> Quadrature<dim - 1> {
      if constexpr (dim == 2)
        return split_quadrature(QGauss<1>(n), cuts);
      return QGauss<dim - 1>(n);
    };
    return this->reinit_at(cuts.size() > 2, cut_rule, cell, face_no);
  }
};
} // namespace Signorini
