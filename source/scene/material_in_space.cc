// SPDX-License-Identifier: LGPL-2.1-or-later
// E_ijkl in space by the 21 entries of its matrix.

#include <signorini/base/exceptions.h>
#include <signorini/scene/material.h>

#include <array>
#include <cmath>
#include <sstream>

namespace Signorini
{
namespace
{
/** Order of the matrix. */
constexpr unsigned int n_strains = 6;

/** Which component of stress and strain a row stands for. */
constexpr std::array<std::array<unsigned int, 2>, n_strains> voigt_pairs = {
  {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{1, 2}}, {{0, 2}}, {{0, 1}}}};

using VoigtMatrix6 = std::array<std::array<double, n_strains>, n_strains>;

/** Whether Cholesky's factorisation finds positive pivots only. */
bool is_positive_definite(VoigtMatrix6 C)
{
  for (unsigned int k = 0; k < n_strains; ++k)
  {
    if (!(C[k][k] > 0. && std::isfinite(C[k][k])))
      return false;
    for (unsigned int i = k + 1; i < n_strains; ++i)
      for (unsigned int j = k + 1; j < n_strains; ++j)
        C[i][j] -= C[i][k] * C[k][j] / C[k][k];
  }
  return true;
}

/** The entry C11 as the unit of stress; what is no modulus is found where it is used. */
double unit_from(const Expression<3> &entry, const dealii::Point<3> &x)
{
  const double value = entry(x);
  return value > 0. && std::isfinite(value) ? value : 1.;
}

class GeneralInSpace : public Material<3>
{
public:
  GeneralInSpace(const std::vector<Expression<3>> &entries, const dealii::Point<3> &reference)
    : Material<3>(unit_from(entries[0], reference))
    , entries_(entries)
  {
  }

  dealii::SymmetricTensor<4, 3> relative_hooke(const dealii::Point<3> &x) const override
  {
    const VoigtMatrix6 C = relative_matrix(x);
    if (!is_positive_definite(C))
    {
      std::ostringstream message;
      message << entries_[0].where() << ": found a tensor that is not positive definite at (" << x
              << "), allowed: a positive definite one.";
      throw InputError(message.str());
    }
    dealii::SymmetricTensor<4, 3> E;
    for (unsigned int i = 0; i < n_strains; ++i)
      for (unsigned int j = 0; j < n_strains; ++j)
        E[voigt_pairs[i][0]][voigt_pairs[i][1]][voigt_pairs[j][0]][voigt_pairs[j][1]] = C[i][j];
    return E;
  }

  bool is_constant() const override
  {
    for (const Expression<3> &entry : entries_)
      if (!entry.is_constant())
        return false;
    return true;
  }

  double out_of_plane_stress(const dealii::Point<3> & /*x*/,
                             const dealii::SymmetricTensor<2, 3> & /*strain*/) const override
  {
    return 0.;
  }

private:
  VoigtMatrix6 relative_matrix(const dealii::Point<3> &x) const
  {
    VoigtMatrix6 C;
    auto entry = entries_.begin();
    for (unsigned int i = 0; i < n_strains; ++i)
      for (unsigned int j = i; j < n_strains; ++j, ++entry)
        C[i][j] = C[j][i] = (*entry)(x) / modulus();
    return C;
  }

  std::vector<Expression<3>> entries_;
};
} // namespace

std::shared_ptr<const Material<3>> make_general_in_space(const std::vector<Expression<3>> &entries,
                                                         const dealii::Point<3> &reference)
{
  AssertDimension(entries.size(), 21);
  return std::make_shared<GeneralInSpace>(entries, reference);
}
} // namespace Signorini
