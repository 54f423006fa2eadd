# SPDX-License-Identifier: LGPL-2.1-or-later
# Target "run": the scene that shows contact, with its results in the folder results.

add_custom_target(run
  COMMAND signorini prm/block_on_parabola.prm
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  USES_TERMINAL)
