// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/body_measure.h>
#include <signorini/discretization/space/cell_values.h>
#include <signorini/discretization/space/displaced_body.h>
#include <signorini/discretization/space/patch_interpolation.h>

#include <deal.II/fe/fe_nothing.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace Signorini {
/** A function of V^h, and the number of generations over which PatchInterpolation interpolates it;
 * none: the function itself. */
struct EvaluatedField {
  const Displacement *U;
  unsigned int n_generations = 0;
};

/**
 * Evaluates u_h, π^{2h} u_h and the like at points of cells, with dx: the one cache of maps and
 * tabulated polynomials. Cells may have several degrees; there only functions of V^h themselves are
 * evaluated. Everything is valid until the next move. Every thread has its own.
 */
template <int dim>
class CellEvaluator {
public:
  using Cell = typename DoFHandler<dim>::active_cell_iterator;
  using Rule = typename ValuesCache<dim>::Rule;
  /** Returns the map of a cell. */
  using Map = std::function<const Mapping<dim> &(const Cell &)>;

  /**
   * The space, the nodal values and the maps must outlive the object.
   * @param rule the rules by their numbers; by default Gauss' by the number of points per
   * direction.
   * @param map by default that of the mesh.
   * @param measures whether rules have weights: maps may degenerate at corners of cells.
   */
  CellEvaluator(const DisplacementSpace<dim> &space, std::vector<EvaluatedField> fields,
                Rule rule = ValuesCache<dim>::gauss, Map map = {}, bool measures = true);

  /** Moves to the points of a rule on a cell. Tables of a rule are computed once. */
  void reinit(const Cell &cell, unsigned int rule_number);
  /** Moves to points of a rule that does not come again. */
  void reinit_once(const Cell &cell, const Quadrature<dim> &rule);

  const Cell &cell() const {
    return cell_;
  }
  unsigned int size() const {
    return map_values_->n_quadrature_points;
  }
  const std::vector<Point<dim>> &points() const {
    return map_values_->get_quadrature_points();
  }
  const Point<dim> &unit_point(const unsigned int q) const {
    return map_values_->get_quadrature().point(q);
  }
  /** Returns dx at a point. */
  double measure(const unsigned int q) const {
    return measure_at(*map_values_, q);
  }
  /** Returns a field with its derivatives in reference coordinates. */
  const FieldValues<dim> &on_reference_cell(const unsigned int k = 0) const {
    return *fields_at_points_[k];
  }
  /** Returns derivatives in the body: du_i/dx_j = Σ_k du_i/dξ_k dξ_k/dx_j. */
  Tensor<2, dim> in_body(const Tensor<2, dim> &on_reference_cell, const unsigned int q) const {
    return on_reference_cell * Tensor<2, dim>(map_values_->inverse_jacobian(q));
  }
  const Tensor<1, dim> &value(const unsigned int q, const unsigned int k = 0) const {
    return on_reference_cell(k).values[q];
  }
  Tensor<2, dim> gradient(const unsigned int q, const unsigned int k = 0) const {
    return in_body(on_reference_cell(k).gradients[q], q);
  }

private:
  /** The tables of a rule. */
  struct Tables {
    /** On cells of one degree: the fields. */
    std::vector<PatchInterpolation<dim>> patches;
    /** On cells of several degrees, in 2-D. */
    std::optional<TabulatedRule> rule;
  };

  Tables make_tables(const Quadrature<dim> &rule) const;
  void evaluate(const Cell &cell, Tables &tables);

  const DisplacementSpace<dim> &space_;
  const std::vector<EvaluatedField> fields_;
  const Rule rule_;
  const Map map_;
  /** Whether fields are evaluated cell by cell. */
  const bool by_cells_;
  const FE_Nothing<dim> no_functions_;
  ValuesCache<dim> maps_;
  std::map<unsigned int, Tables> tables_;
  /** Those of the last rule that does not come again. */
  std::unique_ptr<FEValues<dim>> map_once_;
  Tables tables_once_;
  Cell cell_;
  const FEValues<dim> *map_values_ = nullptr;
  std::vector<FieldValues<dim>> cell_fields_;
  std::vector<const FieldValues<dim> *> fields_at_points_;
};

/** The displacement, the strain and the rotation at a point of a cell. */
template <int dim>
struct FieldSample {
  Point<dim> x;
  /** The coordinates in the reference cell. */
  Point<dim> unit;
  Tensor<1, dim> u;
  Strain<dim> strain;
  /** The angle |W| of the rotation, 2 |W|² = W:W with W = (∇u - ∇uᵀ)/2 (radians, small). */
  double rotation = 0.;
};

/** Returns the mean of tr ε(u_h) over the parent of each active cell (over the cell itself where
 * there is no T^{2h}), in the order of active cells. With StrainOperator::mean_dilatation, means
 * over cells may alternate between neighbours, as the pressure of Q1-P0 does. */
template <int dim>
std::vector<double> mean_dilatations(const DisplacedBody<dim> &body);

/** The solution of which samples are taken. With mean dilatation the trace of the strain is
 * mean_dilatations(). */
template <int dim>
struct SampledField : DisplacedBody<dim> {
  explicit SampledField(const DisplacedBody<dim> &body);

  /** Returns an evaluator of π^{2h} u_h, or of u_h on a mesh without T^{2h}, whose rule of an
   * element has the middle of its cells and their corners, or with several elements the nodes. */
  CellEvaluator<dim> at_nodes() const;
  /** Returns the sample of a field at a point of an evaluator. */
  FieldSample<dim> sample(const CellEvaluator<dim> &u, unsigned int q, unsigned int k = 0) const;
  /** Fills the samples at all points. */
  void sample(const CellEvaluator<dim> &u, std::vector<FieldSample<dim>> &samples) const;

  /** The mean dilatations by cell; empty where the strain is that of u_h. */
  std::vector<double> dilatation;
};
} // namespace Signorini
