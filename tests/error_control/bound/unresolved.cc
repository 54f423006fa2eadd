// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes and patches that miss what happens: the bound of the energy error holds nevertheless, and
// shows that the answer is worth nothing.
//
// The reference is u_f in V^h of a much finer mesh, nested in that of u_h. |||u_f - u_h||| is not
// above |||u - u_h||| where nothing touches, or the same points touch (a(u - u_f, u_f - u_h) = 0),
// and elsewhere up to |||u - u_f|||.

#include <signorini/discretization/elasticity/cell_stiffness.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <map>
#include <memory>

#include "one_level.h"
#include "tests.h"
#include "unresolved_scenes.h"

using namespace Signorini;

namespace
{
/** Values at the nodes of a rectangle that is divided into equal cells. */
class GridField
{
public:
  GridField(const DisplacementSpace<2> &space, const Displacement &U)
  {
    std::map<double, unsigned int> x, y;
    const auto &triangulation = space.mesh().triangulation();
    for (unsigned int d = 0; d < 2; ++d)
    {
      low_[d] = 1e300;
      double high = -1e300, width = 1e300;
      for (const auto &cell : triangulation.active_cell_iterators())
      {
        low_[d] = std::min(low_[d], cell->vertex(0)[d]);
        high = std::max(high, cell->vertex(3)[d]);
        width = std::min(width, cell->vertex(3)[d] - cell->vertex(0)[d]);
      }
      n_[d] = static_cast<unsigned int>(std::lround((high - low_[d]) / width));
      width_[d] = (high - low_[d]) / n_[d];
    }
    values_.resize((n_[0] + 1) * (n_[1] + 1));
    for (const auto &cell : space.dofs().active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
      {
        const dealii::Tensor<1, 2> at = cell->vertex(v) - low_;
        const auto i = std::lround(at[0] / width_[0]), j = std::lround(at[1] / width_[1]);
        for (unsigned int d = 0; d < 2; ++d)
          values_[j * (n_[0] + 1) + i][d] = U[cell->vertex_dof_index(v, d)];
      }
  }

  dealii::Tensor<1, 2> operator()(const dealii::Point<2> &x) const
  {
    std::array<unsigned int, 2> i;
    std::array<double, 2> t;
    for (unsigned int d = 0; d < 2; ++d)
    {
      const double position = std::max(0., (x[d] - low_[d]) / width_[d]);
      i[d] = std::min(n_[d] - 1, static_cast<unsigned int>(position + 1e-9));
      t[d] = position - i[d];
    }
    const dealii::Tensor<1, 2> *row = &values_[i[1] * (n_[0] + 1) + i[0]];
    const dealii::Tensor<1, 2> *next = row + n_[0] + 1;
    return (1. - t[1]) * ((1. - t[0]) * row[0] + t[0] * row[1]) +
           t[1] * ((1. - t[0]) * next[0] + t[0] * next[1]);
  }

private:
  dealii::Point<2> low_;
  std::array<unsigned int, 2> n_;
  std::array<double, 2> width_;
  std::vector<dealii::Tensor<1, 2>> values_;
};

/** u_f, with a(.,.) of the conforming element. */
struct Reference
{
  Reference(const std::string &text, const unsigned int number)
    : level(text, number)
    , space(level.discretization.mesh, level.scene)
    , U(level.solve().U)
    , energy(square(U))
  {
  }
  double square(const Displacement &V) const
  {
    const DualVector forces = space.dual(internal_forces(space, level.scene, V).forces);
    return std::max(0., V * forces);
  }

  OneLevel level;
  DisplacementSpace<2> space;
  Displacement U;
  double energy;
};

std::string key_of_reference(const Unresolved::Given &given)
{
  return given.scene + std::to_string(given.reference_level);
}

class Test
{
public:
  Test()
    : file_("unresolved.md")
  {
    file_ << "| scene | level | true, relative | bound, relative | bound / true | energy |\n"
             "|---|---|---|---|---|---|\n";
  }

  void check(const Unresolved::Given &given)
  {
    const Reference &fine = reference(given);
    const OneLevel level(given.scene + given.discretization +
                           Unresolved::option("Target error", "1e-9") +
                           entry("Output", "Inf-sup constant", "false"),
                         given.level);
    const LevelSolution<2> solution = level.solve();
    const GridField u_h(level.space(), solution.U);
    const Displacement on_fine = nodal_values(fine.space, u_h);
    Displacement difference(fine.U);
    difference -= on_fine;
    const double error = std::sqrt(fine.square(difference)), energy = fine.square(on_fine);
    const ErrorBound &bound = *solution.record.bound;
    const std::string name = given.name + ", level " + std::to_string(given.level);
    const double relative = bound.relative.value_or(1e30),
                 absolute = bound.absolute.value_or(1e10 * error);
    checks_.between(name + ", bound / error", absolute / error, 0.98, 1e30);
    checks_.that(name + ", not certified",
                 std::abs(energy - fine.energy) <= 0.05 * fine.energy || relative > 0.2);
    file_ << "| " << given.name << " | " << given.level << " | " << std::setprecision(3)
          << error / std::sqrt(fine.energy) << " | ";
    if (bound.absolute)
      file_ << relative << " | " << absolute / error;
    else
      file_ << "none | ";
    file_ << " | " << energy / fine.energy << " |" << std::endl;
  }

  int exit_code() const
  {
    return checks_.exit_code();
  }

private:
  /** That of the scene before is kept. */
  const Reference &reference(const Unresolved::Given &given)
  {
    const std::string key = key_of_reference(given);
    if (key != key_)
      reference_ =
        std::make_unique<Reference>(given.scene + Unresolved::option("Finest level", "14") +
                                      entry("Output", "Inf-sup constant", "false"),
                                    given.reference_level);
    key_ = key;
    return *reference_;
  }

  Checks checks_;
  std::ofstream file_;
  std::string key_;
  std::unique_ptr<Reference> reference_;
};

} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Unresolved::Scenes scenes;
  for (const auto &add : {Unresolved::add_missed_contact,
                          Unresolved::add_bending,
                          Unresolved::add_fine_data,
                          Unresolved::add_fine_materials,
                          Unresolved::add_narrow_data,
                          Unresolved::add_prescribed,
                          Unresolved::add_locking,
                          Unresolved::add_mixed,
                          Unresolved::add_loose_solver})
    add(scenes);
  // The levels of a scene one after the other share its reference.
  std::map<std::string, std::size_t> first;
  for (const Unresolved::Given &given : scenes.all)
    first.emplace(key_of_reference(given), first.size());
  std::stable_sort(scenes.all.begin(),
                   scenes.all.end(),
                   [&](const Unresolved::Given &a, const Unresolved::Given &b) {
                     return first.at(key_of_reference(a)) < first.at(key_of_reference(b));
                   });
  Test test;
  for (const Unresolved::Given &given : scenes.all)
    test.check(given);
  return test.exit_code();
}
