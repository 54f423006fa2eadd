// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <type_traits>

/** The bodies of kernels are inlined into functions that are compiled for several instruction sets.
 */
#define SIGNORINI_INLINE __attribute__((always_inline))

namespace Signorini {
/** The instruction sets of processors; each kernel exists for all of them. */
enum class Instructions { basic, avx2, avx512 };

/** Returns the best instruction set of this processor. */
inline Instructions instructions_of_this_machine() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
    return Instructions::avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return Instructions::avx2;
#endif
  return Instructions::basic;
}

#ifdef __x86_64__
template <typename Kernel>
__attribute__((target("avx2,fma"))) void run_avx2(const Kernel &kernel) {
  kernel(std::integral_constant<int, 32>());
}
#ifdef __clang__
#define SIGNORINI_WIDTH
#else
#define SIGNORINI_WIDTH ",prefer-vector-width=512"
#endif
template <typename Kernel>
__attribute__((target("avx512f,avx512vl,avx512dq,avx512bw,avx2,fma" SIGNORINI_WIDTH))) void
run_avx512(const Kernel &kernel) {
  kernel(std::integral_constant<int, 64>());
}
#endif

/** Calls kernel(bytes of a vector register) compiled for an instruction set: the kernel is a lambda
 * that is always inlined. */
template <typename Kernel>
void run(const Instructions instructions, const Kernel &kernel) {
#ifdef __x86_64__
  if (instructions == Instructions::avx512)
    return run_avx512(kernel);
  if (instructions == Instructions::avx2)
    return run_avx2(kernel);
#endif
  (void)instructions;
  kernel(std::integral_constant<int, 16>());
}
} // namespace Signorini
