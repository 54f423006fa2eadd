# SPDX-License-Identifier: LGPL-2.1-or-later
# From convergence.csv of a run with error norms and of one without to a line: the error that was reached, the unknowns, and
# the seconds. Without input: the names of the columns.
# REQUEST is a target, or a level of nested meshes, whose rows up to this one count.
# usage: awk -v configuration=STRATEGY,SCENE,END,REQUEST -v seconds="USER SYSTEM" -v reference=R -v repetition=N
#            -f benchmark_targets.awk WITH_ERRORS WITHOUT
BEGIN {
  FS = ","
  n_stages = split("mesh setup assembly factor compliance qp recovery postprocess", stages, " ")
}
BEGIN { split(configuration, part_of, ","); strategy = part_of[1]; level = part_of[4] }
FNR == 1 { ++file; for (c = 1; c <= NF; ++c) column[$c] = c; next }
strategy == "nested" && $1 > level + 0 { next }
file == 1 {
  u_h1 = $(column["u_h1"]); u_l2 = $(column["u_l2"]); post = $(column["u_post_h1"])
  energy = $(column["energy"]); estimate = $(column["estimated_relative"])
}
file == 2 {
  ++steps
  dofs = $(column["dofs"])
  all_dofs += dofs
  degree = $(column["max_degree"])
  processor = $(column["cpu_total"])
  for (i = 1; i <= n_stages; ++i) sums[i] += $(column["t_" stages[i]])
}
function magnitude(x) { return x < 0 ? -x : x }
END {
  if (file == 0) {
    line = "strategy,scene,end,request,repetition,error,error_post,estimate,steps,dofs,all_dofs,max_degree,cpu"
    for (i = 1; i <= n_stages; ++i) line = line ",t_" stages[i]
    print line
    exit
  }
  if (strategy == "hp") { split(seconds, part, " "); processor = part[1] + part[2] }
  if (u_h1 != "") {
    error = sqrt(u_h1 ^ 2 - u_l2 ^ 2) / reference
    if (post != "") post = post / reference
  } else
    error = sqrt(magnitude((energy - reference) / reference))
  line = configuration "," repetition "," error "," post "," estimate "," steps "," dofs "," all_dofs "," degree "," processor
  for (i = 1; i <= n_stages; ++i) line = line "," sums[i]
  print line
}
