// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/mesh/cut_quadrature.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <memory>

namespace Signorini
{
/** FEValues or FEFaceValues with Gauss' rules, one object for every element of a space. Cells of
 * degree p have p - 1 points per direction more than those of degree one. */
template <int dim, int rule_dim, typename Values>
class ValuesByElement
{
public:
  /** @param n_points per direction, for degree one. */
  ValuesByElement(const dealii::Mapping<dim> &mapping,
                  const DisplacementSpace<dim> &space,
                  const Kinks<dim> &kinks,
                  const unsigned int n_points,
                  const dealii::UpdateFlags flags)
    : kinks_(kinks)
    , mapping_(mapping)
    , space_(space)
    , n_points_(n_points)
    , flags_(flags)
    , plain_(space.elements().size())
  {
  }

protected:
  template <typename CellIterator>
  unsigned int n_points(const CellIterator &cell) const
  {
    return n_points_ + space_.element(cell).degree - 1;
  }
  /** With Gauss' rule. */
  template <typename CellIterator>
  Values &plain(const CellIterator &cell)
  {
    std::unique_ptr<Values> &values = plain_[space_.element_number(cell)];
    if (values == nullptr)
      values = make(cell, dealii::QGauss<rule_dim>(n_points(cell)));
    return *values;
  }
  /** With another rule; valid until the next one. */
  template <typename CellIterator>
  Values &cut(const CellIterator &cell, const dealii::Quadrature<rule_dim> &rule)
  {
    cut_ = make(cell, rule);
    return *cut_;
  }

  const Kinks<dim> &kinks_;

private:
  template <typename CellIterator>
  std::unique_ptr<Values> make(const CellIterator &cell, const dealii::Quadrature<rule_dim> &rule)
  {
    return std::make_unique<Values>(mapping_, space_.element(cell), rule, flags_);
  }

  const dealii::Mapping<dim> &mapping_;
  const DisplacementSpace<dim> &space_;
  unsigned int n_points_;
  dealii::UpdateFlags flags_;
  std::vector<std::unique_ptr<Values>> plain_;
  std::unique_ptr<Values> cut_;
};

/** Shape functions at the Gauss points of a cell; on the pieces of a cell that a kink crosses, at
 * the Gauss points of each piece. */
template <int dim>
class CellValues : public ValuesByElement<dim, dim, dealii::FEValues<dim>>
{
public:
  using ValuesByElement<dim, dim, dealii::FEValues<dim>>::ValuesByElement;

  /** @param cell of the mesh, or of a DoFHandler where functions shall be evaluated. */
  template <typename CellIterator>
  const dealii::FEValues<dim> &reinit(const CellIterator &cell)
  {
    dealii::FEValues<dim> &values =
      needs_cuts<dim>(this->kinks_, cell)
        ? this->cut(cell, cut_quadrature<dim>(this->kinks_, cell, this->n_points(cell)))
        : this->plain(cell);
    values.reinit(cell);
    return values;
  }
};

/** Shape functions at the Gauss points of a face; where a kink cuts the face, at the Gauss points
 * of its parts. */
template <int dim>
class FaceValues : public ValuesByElement<dim, dim - 1, dealii::FEFaceValues<dim>>
{
public:
  using CellIterator = typename dealii::Triangulation<dim>::active_cell_iterator;
  using ValuesByElement<dim, dim - 1, dealii::FEFaceValues<dim>>::ValuesByElement;

  const dealii::FEFaceValues<dim> &reinit(const CellIterator &cell, const unsigned int face_no)
  {
    dealii::FEFaceValues<dim> *values = nullptr;
    // In space, planes do not cut faces yet.
    if constexpr (dim == 2)
    {
      const auto face = cell->face(face_no);
      const std::vector<double> cuts = this->kinks_.cut(face->vertex(0), face->vertex(1));
      if (cuts.size() > 2)
        values =
          &this->cut(cell, split_quadrature(dealii::QGauss<dim - 1>(this->n_points(cell)), cuts));
    }
    if (values == nullptr)
      values = &this->plain(cell);
    values->reinit(cell, face_no);
    return *values;
  }
};
} // namespace Signorini
