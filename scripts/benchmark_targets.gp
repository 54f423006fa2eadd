# SPDX-License-Identifier: LGPL-2.1-or-later
# Draws relative error against processor time, nested and graded meshes. scripts/benchmark sets folder, scenes and
# strategies; a series is the file folder/series/targets-SCENE-STRATEGY.csv.

set datafile separator ","
set grid lc rgb "#dddddd"
set border lc rgb "#888888"
series(s, strategy) = folder . "/series/targets-" . s . "-" . strategy . ".csv"
title_of(s) = s eq "two_ends" ? "smooth contact, two ends" : s eq "b1" ? "B1, worst end of contact" : \
              s eq "b3" ? "B3" : "block on parabola (energy)"
has(strategy) = strstrt(" " . strategies . " ", " " . strategy . " ") > 0
drawn = ""
do for [s in scenes] { if (s ne "b1_kinks") { drawn = drawn . " " . s } }
set encoding utf8
set terminal pngcairo size 420*words(drawn),420 font "DejaVu Sans,10"
set output folder . "/benchmark_targets.png"
set multiplot layout 1,words(drawn)
set logscale xy
set format y "10^{%T}"
set xlabel "seconds of processor time"
set ylabel "relative error"
set xrange [0.2:10]
set xtics (0.2, 0.5, 1, 2, 5, 10)
set key right top reverse Left samplen 2 font ",9"
line(s, strategy, what, style) = sprintf("'%s' using 'cpu':'%s' with linespoints ps 0.8 %s, ", series(s, strategy), what, style)
do for [s in drawn] {
  set title title_of(s)
  lines = ""
  if (has("nested")) { lines = lines . line(s, "nested", "error", "pt 7 lc rgb '#08519c' title 'nested, u_h' noenhanced") }
  if (has("nested") && s ne "block") {
    lines = lines . line(s, "nested", "error_post", "pt 6 dt 2 lc rgb '#08519c' title 'nested, π²ʰu_h' noenhanced")
  }
  if (has("hp")) { lines = lines . line(s, "hp", "error", "pt 7 lc rgb '#d94801' title 'hp, u_h' noenhanced") }
  eval("plot " . lines[1:strlen(lines)-2])
}
unset multiplot
