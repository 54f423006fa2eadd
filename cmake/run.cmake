# SPDX-License-Identifier: LGPL-2.1-or-later
# Target "run": the scene that shows contact, with its results in the folder results. Target "benchmark": the timings
# of scripts/benchmark.py, with their tables and pictures in the folder benchmark.

add_custom_target(run
  COMMAND signorini prm/block_on_parabola.prm
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  DEPENDS luo_liang
  USES_TERMINAL)

add_custom_target(benchmark
  COMMAND python3 scripts/benchmark.py --program $<TARGET_FILE:signorini>
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  DEPENDS signorini
  USES_TERMINAL)
