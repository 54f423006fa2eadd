// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/mesh/cut_quadrature.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <memory>

namespace Signorini
{
/**
 * Shape functions at the Gauss points of a cell; on the pieces of a cell that a kink crosses, at
 * the Gauss points of each piece. Cells of degree p have p - 1 points per direction more than those
 * of degree one.
 */
template <int dim>
class CellValues
{
public:
  /** @param n_points per direction, for degree one. */
  CellValues(const dealii::Mapping<dim> &mapping,
             const DisplacementSpace<dim> &space,
             const Kinks<dim> &kinks,
             const unsigned int n_points,
             const dealii::UpdateFlags flags)
    : mapping_(mapping)
    , space_(space)
    , kinks_(kinks)
    , n_points_(n_points)
    , flags_(flags)
    , plain_(space.elements().size())
  {
  }

  /** @param cell of the mesh, or of a DoFHandler where functions shall be evaluated. */
  template <typename CellIterator>
  const dealii::FEValues<dim> &reinit(const CellIterator &cell)
  {
    const unsigned int number = space_.element_number(cell);
    const dealii::FiniteElement<dim> &element = space_.elements()[number];
    const unsigned int n_points = n_points_ + element.degree - 1;
    dealii::FEValues<dim> *values = nullptr;
    if (needs_cuts<dim>(kinks_, cell))
    {
      cut_ = std::make_unique<dealii::FEValues<dim>>(
        mapping_, element, cut_quadrature<dim>(kinks_, cell, n_points), flags_);
      values = cut_.get();
    }
    else
    {
      std::unique_ptr<dealii::FEValues<dim>> &plain = plain_[number];
      if (plain == nullptr)
        plain = std::make_unique<dealii::FEValues<dim>>(
          mapping_, element, dealii::QGauss<dim>(n_points), flags_);
      values = plain.get();
    }
    values->reinit(cell);
    return *values;
  }

private:
  const dealii::Mapping<dim> &mapping_;
  const DisplacementSpace<dim> &space_;
  const Kinks<dim> &kinks_;
  unsigned int n_points_;
  dealii::UpdateFlags flags_;
  /** By element. */
  std::vector<std::unique_ptr<dealii::FEValues<dim>>> plain_;
  std::unique_ptr<dealii::FEValues<dim>> cut_;
};

/** Shape functions at the Gauss points of a face; where a kink cuts the face, at the Gauss points
 * of its parts. More points for higher degrees as in CellValues. */
template <int dim>
class FaceValues
{
public:
  using CellIterator = typename dealii::Triangulation<dim>::active_cell_iterator;

  /** @param n_points per direction, for degree one. */
  FaceValues(const dealii::Mapping<dim> &mapping,
             const DisplacementSpace<dim> &space,
             const Kinks<dim> &kinks,
             const unsigned int n_points,
             const dealii::UpdateFlags flags)
    : mapping_(mapping)
    , space_(space)
    , kinks_(kinks)
    , n_points_(n_points)
    , flags_(flags)
    , plain_(space.elements().size())
  {
  }

  const dealii::FEFaceValues<dim> &reinit(const CellIterator &cell, const unsigned int face_no)
  {
    const unsigned int number = space_.element_number(cell);
    const dealii::FiniteElement<dim> &element = space_.elements()[number];
    const dealii::QGauss<dim - 1> rule(n_points_ + element.degree - 1);
    // In space, planes do not cut faces yet.
    if constexpr (dim == 2)
    {
      const auto face = cell->face(face_no);
      const std::vector<double> cuts = kinks_.cut(face->vertex(0), face->vertex(1));
      if (cuts.size() > 2)
      {
        cut_ = std::make_unique<dealii::FEFaceValues<dim>>(
          mapping_, element, split_quadrature(rule, cuts), flags_);
        cut_->reinit(cell, face_no);
        return *cut_;
      }
    }
    std::unique_ptr<dealii::FEFaceValues<dim>> &plain = plain_[number];
    if (plain == nullptr)
      plain = std::make_unique<dealii::FEFaceValues<dim>>(mapping_, element, rule, flags_);
    plain->reinit(cell, face_no);
    return *plain;
  }

private:
  const dealii::Mapping<dim> &mapping_;
  const DisplacementSpace<dim> &space_;
  const Kinks<dim> &kinks_;
  unsigned int n_points_;
  dealii::UpdateFlags flags_;
  /** By element. */
  std::vector<std::unique_ptr<dealii::FEFaceValues<dim>>> plain_;
  std::unique_ptr<dealii::FEFaceValues<dim>> cut_;
};
} // namespace Signorini
