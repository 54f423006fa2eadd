# SPDX-License-Identifier: LGPL-2.1-or-later
# The median of column c over the runs of a key: of value[key, c, 1] to value[key, c, count[key]]. Empty if one is empty.
function median(key, c,    n, i, j, x, sorted) {
  n = count[key]
  for (i = 1; i <= n; ++i) {
    x = value[key, c, i]
    if (x == "") return ""
    for (j = i - 1; j >= 1 && sorted[j] + 0 > x + 0; --j) sorted[j + 1] = sorted[j]
    sorted[j + 1] = x
  }
  return n % 2 == 1 ? sorted[(n + 1) / 2] : (sorted[n / 2] + sorted[n / 2 + 1]) / 2
}
