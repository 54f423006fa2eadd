// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/** Bodies of kernels are inlined into functions that are compiled for several instruction sets. */
#define SIGNORINI_INLINE [[gnu::always_inline]] inline

#ifdef __x86_64__
#define SIGNORINI_AVX2 __attribute__((target("avx2,fma")))
#ifdef __clang__
#define SIGNORINI_AVX512 __attribute__((target("avx512f,avx512vl,avx512dq,avx512bw,avx2,fma")))
#else
#define SIGNORINI_AVX512                                                                           \
  __attribute__((target("avx512f,avx512vl,avx512dq,avx512bw,avx2,fma,prefer-vector-width=512")))
#endif
#endif

namespace Signorini
{
/** A vector of @p width numbers, which may lie in an array of such numbers. */
template <typename Number, int width>
struct Wide
{
  typedef Number Type __attribute__((vector_size(width * sizeof(Number)), may_alias));
};
} // namespace Signorini
