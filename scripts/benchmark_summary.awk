# SPDX-License-Identifier: LGPL-2.1-or-later
# The finest level of every configuration, and what contact costs beside the same body without contact.
BEGIN { FS = "," }
NR == 1 { for (c = 1; c <= NF; ++c) column[$c] = c; next }
{
  key = $1 "," $2 "," $3
  if (!(key in seconds)) order[++n] = key
  dofs[key] = $(column["dofs"])
  seconds[key] = $(column["t_solution"])
  factor[key] = $(column["t_factor"])
  compliance[key] = $(column["t_compliance"])
  error[key] = $(column["u_h1"]) == "" ? "-" : sprintf("%.3e", $(column["u_h1"]))
}
END {
  row = "%-11s %-11s %-13s %9s %9s %9s %10s %10s\n"
  printf row, "scene", "contact", "linear", "dofs", "seconds", "factor", "compliance", "|u-uh|1"
  for (i = 1; i <= n; ++i) {
    key = order[i]
    split(key, part, ",")
    printf row, part[1], part[2], part[3], dofs[key], sprintf("%.3f", seconds[key]), sprintf("%.3f", factor[key]),
           sprintf("%.3f", compliance[key]), error[key]
  }
  for (i = 1; i <= n; ++i) {
    split(order[i], part, ",")
    without = "no_contact," part[2] "," part[3]
    if (part[1] == "two_ends" && (without in seconds))
      printf "contact / no contact, %s, %s: %.2f\n", part[2], part[3], seconds[order[i]] / seconds[without]
  }
}
