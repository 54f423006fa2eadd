// SPDX-License-Identifier: LGPL-2.1-or-later
// What a better pressure than p_H does to the displacement.

#include <signorini/compliance/free_state.h>
#include <signorini/elasticity/trace_values.h>
#include <signorini/postprocess/contact_pressure.h>
#include <signorini/postprocess/pressure_correction.h>
#include <signorini/recovery/recovery.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace Signorini
{
namespace
{
/** Faces per patch of the partition that pressures are recovered from. */
constexpr unsigned int recovery_ratio = 2;

bool presses_nowhere(const dealii::Vector<double> &P)
{
  return std::none_of(P.begin(), P.end(), [](const double p) { return p < 0.; });
}

/** P of the dual problem on another partition; none where a patch sees no free node, or where the
 * solver fails. */
template <int dim>
std::optional<dealii::Vector<double>> solve_on(const MultiplierSpace<dim> &multipliers,
                                               const PressureData<dim> &data)
{
  const Coupling D = assemble_coupling(data.space, multipliers);
  const Coupling condensed_D = condense(D, data.space.constraints());
  for (unsigned int k = 0; k < condensed_D.n_columns(); ++k)
    if (condensed_D.column(k).empty())
      return {};
  FreeState free;
  free.F = assemble_gap(multipliers, data.n_points);
  free.F -= D.transpose_product(data.U_free);
  if (free.nothing_touches())
    return dealii::Vector<double>(multipliers.n_multipliers());
  return data.solve_dual(D,
                         condensed_D,
                         free.F,
                         transfer_pressure<dim>({data.multipliers.surface().patches(), data.P},
                                                multipliers.surface().patches()));
}

/**
 * The recovered pressure, shifted on every patch so that its mean is that of p_H, and nowhere
 * positive. R^H p - p_H converges faster than p - p_H, see (25). The means of a line through the
 * middles of patches do not, and whole patches act on the body far more than what varies on them.
 */
template <int dim>
class ShiftedPressure
{
public:
  ShiftedPressure(const MultiplierSpace<dim> &multipliers, const dealii::Vector<double> &P)
    : recovered_(multipliers, P)
    , shifts_(P)
  {
    dealii::Vector<double> integrals(P.size()), lengths(P.size());
    for (const Piece<dim> &piece : multipliers.surface().pieces())
      for (std::size_t q = 0; q < piece.on_mesh.size(); ++q)
      {
        const double weight = piece.on_mesh.weights[q];
        lengths[piece.patch] += weight;
        integrals[piece.patch] += recovered_(piece.patch, piece.on_mesh.on_side[q]) * weight;
      }
    for (unsigned int k = 0; k < P.size(); ++k)
      shifts_[k] -= integrals[k] / lengths[k];
  }
  double operator()(const unsigned int patch, const dealii::Point<dim - 1> &s) const
  {
    return std::min(0., recovered_(patch, s) + shifts_[patch]);
  }

private:
  RecoveredPressure<dim> recovered_;
  dealii::Vector<double> shifts_;
};

/** z_h for a load. */
template <int dim>
PressureCorrection correct_by(const Coupling &load, const PressureData<dim> &data)
{
  dealii::Vector<double> one(1);
  one = 1.;
  dealii::Vector<double> minus_P(data.P);
  minus_P *= -1.;
  DistributedVector forces = data.space.make_vector();
  load.add_product(one, forces);
  data.condensed_D.add_product(minus_P, forces);
  PressureCorrection correction;
  correction.z = solve_homogeneous(data.inverse, data.space, forces);
  // b.z = a(z, z): z is in V^h with homogeneous conditions.
  double work = 0.;
  for (const auto i : data.space.locally_owned())
    work += forces(i) * correction.z[i];
  work = dealii::Utilities::MPI::sum(work, data.space.mesh().communicator());
  correction.energy_norm = std::sqrt(std::max(0., work));
  return correction;
}
} // namespace

template <int dim>
Coupling recovered_load(const DisplacementSpace<dim> &space,
                        const MultiplierSpace<dim> &multipliers,
                        const dealii::Vector<double> &P)
{
  const ContactSurface<dim> &surface = multipliers.surface();
  const dealii::FEValuesExtractors::Vector displacement(0);
  const ShiftedPressure<dim> recovered(multipliers, P);
  TraceValues<dim> traces(space);
  std::map<dealii::types::global_dof_index, double> forces;
  for (const Piece<dim> &piece : surface.pieces())
  {
    const ContactFace<dim> &face = surface.faces()[piece.face];
    const SurfaceRule<dim> &rule = piece.on_mesh;
    const auto &values = traces.reinit(face, rule.on_face);
    const auto indices = space.cell_dofs(face.cell);
    for (std::size_t q = 0; q < rule.size(); ++q)
    {
      const double force = recovered(piece.patch, rule.on_side[q]) * rule.weights[q];
      if (force != 0.)
        for (unsigned int j = 0; j < indices.size(); ++j)
          forces[indices[j]] += force * (values[displacement].value(j, q) * rule.normals[q]);
    }
  }
  return condense(Coupling({Coupling::Column(forces.begin(), forces.end())}), space.constraints());
}

template <int dim>
PressureCorrection correct_pressure(const PressureData<dim> &data)
{
  const ContactSurface<dim> &surface = data.multipliers.surface();
  const ContactSurface<dim> finer(data.space.mesh(), data.scene, Partition{recovery_ratio, 0});
  if (surface.has_unstable_patch())
    return {};
  if (data.solve_dual && finer.patches().size() > surface.patches().size())
  {
    const MultiplierSpace<dim> multipliers(finer);
    if (const auto P = solve_on(multipliers, data))
      return presses_nowhere(*P) && presses_nowhere(data.P)
               ? PressureCorrection()
               : correct_by<dim>(recovered_load(data.space, multipliers, *P), data);
  }
  return presses_nowhere(data.P)
           ? PressureCorrection()
           : correct_by<dim>(recovered_load(data.space, data.multipliers, data.P), data);
}

template Coupling recovered_load(const DisplacementSpace<2> &,
                                 const MultiplierSpace<2> &,
                                 const dealii::Vector<double> &);
template PressureCorrection correct_pressure(const PressureData<2> &);
template Coupling recovered_load(const DisplacementSpace<3> &,
                                 const MultiplierSpace<3> &,
                                 const dealii::Vector<double> &);
template PressureCorrection correct_pressure(const PressureData<3> &);
} // namespace Signorini
