# SPDX-License-Identifier: LGPL-2.1-or-later
# For every target the run with the least time whose error is below it, in the worst of the ends of contact. Of nested
# meshes the smaller error of u_h and pi^{2h} u_h counts. A row is missing where no run reaches the target.
BEGIN { FS = ","; n_targets = split(targets, target, " ") }
NR == 1 { for (c = 1; c <= NF; ++c) column[$c] = c; next }
{
  group = $2 OFS $1
  if (!(group in known)) { known[group] = 1; order[++n_groups] = group }
  if (!((group, $3) in end_known)) { end_known[group, $3] = 1; ends[group] = ends[group] " " $3 }
  post = $(column["error_post"])
  error = $(column["error"])
  if (post != "" && post + 0 < error + 0) error = post
  for (t = 1; t <= n_targets; ++t) {
    i = group SUBSEP $3 SUBSEP t
    if (error + 0 <= target[t] + 0 && (!(i in cpu) || $(column["cpu"]) + 0 < cpu[i])) {
      cpu[i] = $(column["cpu"]) + 0
      dofs[i] = $(column["dofs"])
      steps[i] = $(column["steps"])
      reached[i] = error
    }
  }
}
END {
  row = "%-9s %-9s %6s %10s %9s %6s %8s %5s\n"
  printf row, "scene", "strategy", "target", "error", "unknowns", "steps", "seconds", "ends"
  for (k = 1; k <= n_groups; ++k)
    for (t = 1; t <= n_targets; ++t) {
      n = split(ends[order[k]], end, " ")
      slowest = 0
      for (e = 1; e <= n; ++e) {
        i = order[k] SUBSEP end[e] SUBSEP t
        if (!(i in cpu)) { slowest = 0; break }
        if (slowest == 0 || cpu[i] > cpu[slowest]) slowest = i
      }
      if (slowest == 0) continue
      split(order[k], part, OFS)
      printf row, part[1], part[2], target[t], sprintf("%.2e", reached[slowest]), dofs[slowest], steps[slowest],
             sprintf("%.2f", cpu[slowest]), n
    }
}
