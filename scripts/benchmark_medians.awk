# SPDX-License-Identifier: LGPL-2.1-or-later
# From the table of all runs to one row per scene, solvers and level: the median of every column. Adds t_solution, the
# seconds of a level up to its certified answer (no errors, no output), and t_nested, the same summed up over the
# levels that lead to it. Columns that are not numbers in a scene stay empty.
# usage: awk -f benchmark_median.awk -f benchmark_medians.awk RUNS
BEGIN { FS = OFS = "," }
NR == 1 {
  n_columns = NF
  for (c = 1; c <= NF; ++c) { name[c] = $c; column[$c] = c }
  print $0, "t_solution", "t_nested", "repetitions"
  next
}
{
  key = $1 OFS $2 OFS $3 OFS $(column["level"])
  if (!(key in count)) keys[++n_keys] = key
  ++count[key]
  for (c = 4; c <= NF; ++c) value[key, c, count[key]] = $c
}
END {
  for (k = 1; k <= n_keys; ++k) {
    split(keys[k], part, FS)
    configuration = part[1] OFS part[2] OFS part[3]
    line = configuration
    for (c = 4; c <= n_columns; ++c) { m[c] = median(keys[k], c); line = line OFS m[c] }
    t = m[column["t_total"]] - m[column["t_errors"]] - m[column["t_output"]]
    nested[configuration] += t
    print line, t, nested[configuration], count[keys[k]]
  }
}
