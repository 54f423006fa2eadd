# SPDX-License-Identifier: LGPL-2.1-or-later
# From the runs to a target to one row per strategy, scene, end of contact and request: medians. The file that the variable
# worst names gets one row per strategy, scene and request, with the largest value of every column over the ends of
# contact; the same rows go to folder/targets-SCENE-STRATEGY.csv.
# usage: awk -f benchmark_median.awk -f benchmark_target_medians.awk -v worst=FILE -v folder=FOLDER RUNS
BEGIN { FS = OFS = "," }
NR == 1 {
  n_columns = NF
  for (c = 1; c <= NF; ++c) name[c] = $c
  sub(/,repetition/, ",repetitions")
  print
  sub(/,end,/, ",ends,")
  header = $0
  print header >worst
  next
}
{
  key = $1 OFS $2 OFS $3 OFS $4
  if (!(key in count)) keys[++n_keys] = key
  ++count[key]
  for (c = 6; c <= NF; ++c) value[key, c, count[key]] = $c
}
END {
  for (k = 1; k <= n_keys; ++k) {
    split(keys[k], part, FS)
    group = part[1] OFS part[2] OFS part[4]
    if (!(group in n_ends)) groups[++n_groups] = group
    ++n_ends[group]
    line = keys[k] OFS count[keys[k]]
    for (c = 6; c <= n_columns; ++c) {
      m = median(keys[k], c)
      line = line OFS m
      if (m != "" && (!((group, c) in largest) || m + 0 > largest[group, c] + 0)) largest[group, c] = m
    }
    n_runs[group] = count[keys[k]]
    print line
  }
  for (k = 1; k <= n_groups; ++k) {
    split(groups[k], part, FS)
    line = part[1] OFS part[2] OFS n_ends[groups[k]] OFS part[3] OFS n_runs[groups[k]]
    for (c = 6; c <= n_columns; ++c) line = line OFS largest[groups[k], c]
    print line >worst
    file = folder "/targets-" part[2] "-" part[1] ".csv"
    if (!(file in opened)) { print header >file; opened[file] = 1 }
    print line >file
  }
}
