// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Signorini
{
/** (A_1)_ij = (phi_j, phi_i)_{1,Omega} = int phi_j.phi_i + grad phi_j : grad phi_i, condensed like
 * A. Collective. */
template <int dim>
dealii::TrilinosWrappers::SparseMatrix assemble_h1_gram_matrix(const DisplacementSpace<dim> &space);
} // namespace Signorini
