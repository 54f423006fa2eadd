// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/mesh/cut_quadrature.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <memory>

namespace Signorini
{
/**
 * Shape functions at the Gauss points of a cell; on the pieces of a cell that a kink crosses, at
 * the Gauss points of each piece.
 */
template <int dim>
class CellValues
{
public:
  CellValues(const dealii::Mapping<dim> &mapping,
             const dealii::FiniteElement<dim> &element,
             const Kinks<dim> &kinks,
             const unsigned int n_points,
             const dealii::UpdateFlags flags)
    : kinks_(kinks)
    , n_points_(n_points)
    , plain_(mapping, element, dealii::QGauss<dim>(n_points), flags)
  {
  }

  /** @param cell of the mesh, or of a DoFHandler where functions shall be evaluated. */
  template <typename CellIterator>
  const dealii::FEValues<dim> &reinit(const CellIterator &cell)
  {
    dealii::FEValues<dim> *values = &plain_;
    if (needs_cuts<dim>(kinks_, cell))
    {
      cut_ = std::make_unique<dealii::FEValues<dim>>(plain_.get_mapping(),
                                                     plain_.get_fe(),
                                                     cut_quadrature<dim>(kinks_, cell, n_points_),
                                                     plain_.get_update_flags());
      values = cut_.get();
    }
    values->reinit(cell);
    return *values;
  }

private:
  const Kinks<dim> &kinks_;
  unsigned int n_points_;
  dealii::FEValues<dim> plain_;
  std::unique_ptr<dealii::FEValues<dim>> cut_;
};

/** Shape functions at the Gauss points of a face; where a kink cuts the face, at the Gauss points
 * of its parts. */
template <int dim>
class FaceValues
{
public:
  using CellIterator = typename dealii::Triangulation<dim>::active_cell_iterator;

  FaceValues(const dealii::Mapping<dim> &mapping,
             const dealii::FiniteElement<dim> &element,
             const Kinks<dim> &kinks,
             const unsigned int n_points,
             const dealii::UpdateFlags flags)
    : kinks_(kinks)
    , rule_(n_points)
    , plain_(mapping, element, rule_, flags)
  {
  }

  const dealii::FEFaceValues<dim> &reinit(const CellIterator &cell, const unsigned int face_no)
  {
    dealii::FEFaceValues<dim> *values = &plain_;
    // In space, planes do not cut faces yet.
    if constexpr (dim == 2)
    {
      const auto face = cell->face(face_no);
      const std::vector<double> cuts = kinks_.cut(face->vertex(0), face->vertex(1));
      if (cuts.size() > 2)
      {
        cut_ = std::make_unique<dealii::FEFaceValues<dim>>(plain_.get_mapping(),
                                                           plain_.get_fe(),
                                                           split_quadrature(rule_, cuts),
                                                           plain_.get_update_flags());
        values = cut_.get();
      }
    }
    values->reinit(cell, face_no);
    return *values;
  }

private:
  const Kinks<dim> &kinks_;
  dealii::QGauss<dim - 1> rule_;
  dealii::FEFaceValues<dim> plain_;
  std::unique_ptr<dealii::FEFaceValues<dim>> cut_;
};
} // namespace Signorini
