// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps of the smoother, node by node, for several instruction sets.

#include <signorini/solvers/multigrid/kernels.h>

#include <cstring>

#include "point_kernel.h"

namespace Signorini
{
namespace
{
/** Returns the position of the entry of a symmetric matrix in NodeBlocks. */
template <int dim>
constexpr int block_entry(const int i, const int j)
{
  return i == j ? i : dim + i + j - 1;
}

/** Does the step, see SmootherStep. */
template <int dim, int width>
SIGNORINI_INLINE void smooth_body(const SmootherStep<dim> &step)
{
  using V = typename Wide<float, width>::Type;
  // The loop takes whole vectors: the entries behind the last node are zero, and stay so.
  for (unsigned int node = 0; node < step.n_nodes; node += width)
  {
    V r[dim];
#pragma GCC unroll 3
    for (int c = 0; c < dim; ++c)
    {
      std::memcpy(&r[c], step.b[c] + node, sizeof(V));
      if (!step.is_first)
      {
        V y;
        std::memcpy(&y, step.y[c] + node, sizeof(V));
        r[c] -= y;
      }
      r[c] *= step.gamma;
    }
#pragma GCC unroll 3
    for (int c = 0; c < dim; ++c)
    {
      V d = V{}, x = V{};
      if (!step.is_first)
      {
        std::memcpy(&d, step.d[c] + node, sizeof(V));
        std::memcpy(&x, step.x[c] + node, sizeof(V));
        d *= step.alpha;
      }
#pragma GCC unroll 3
      for (int e = 0; e < dim; ++e)
      {
        V B;
        std::memcpy(&B, step.B[block_entry<dim>(c, e)] + node, sizeof(V));
        d += B * r[e];
      }
      x += d;
      std::memcpy(step.d[c] + node, &d, sizeof(V));
      std::memcpy(step.x[c] + node, &x, sizeof(V));
    }
  }
}

template <int dim>
void smooth_basic(const SmootherStep<dim> &step)
{
  smooth_body<dim, 4>(step);
}

#ifdef __x86_64__
template <int dim>
SIGNORINI_AVX2 void smooth_avx2(const SmootherStep<dim> &step)
{
  smooth_body<dim, 8>(step);
}
template <int dim>
SIGNORINI_AVX512 void smooth_avx512(const SmootherStep<dim> &step)
{
  smooth_body<dim, 16>(step);
}
#endif
} // namespace

template <int dim>
void smooth(const SmootherStep<dim> &step, const Instructions instructions)
{
#ifdef __x86_64__
  if (instructions == Instructions::avx512)
    return smooth_avx512(step);
  if (instructions == Instructions::avx2)
    return smooth_avx2(step);
#endif
  (void)instructions;
  smooth_basic(step);
}

template void smooth(const SmootherStep<2> &, Instructions);
template void smooth(const SmootherStep<3> &, Instructions);
} // namespace Signorini
