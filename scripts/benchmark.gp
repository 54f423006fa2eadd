# SPDX-License-Identifier: LGPL-2.1-or-later
# Draws what scripts/benchmark measured. It sets folder, scenes, contact (the contact solver to be drawn),
# linear_solvers and n_levels; a series is the file folder/series/SCENE-CONTACT-LINEAR.csv.

set datafile separator ","
set datafile missing NaN
set grid lc rgb "#dddddd"
set border lc rgb "#888888"
set style fill solid 0.9 noborder
series(s, l) = folder . "/series/" . s . "-" . contact . "-" . l . ".csv"
title_of(s) = s eq "two_ends" ? "smooth contact, two ends" : s eq "no_contact" ? "the same without contact" : \
              s eq "a1" ? "scene A1" : "scene B1"
n_scenes = words(scenes)
n_linear = words(linear_solvers)
array colours[8] = ["#c6dbef", "#9ecae1", "#6baed6", "#08519c", "#d94801", "#fdae6b", "#74c476", "#bdbdbd"]
array linear_colours[6] = ["#08519c", "#d94801", "#238b45", "#6a51a3", "#a50f15", "#555555"]

# Time against error, the levels that lead to an answer included.
with_error = ""
do for [s in scenes] { if (s ne "no_contact") { with_error = with_error . " " . s } }
if (words(with_error) > 0) {
  set terminal pngcairo size 380*words(with_error),420 font "DejaVu Sans,10"
  set output folder . "/benchmark_error.png"
  set multiplot layout 1,words(with_error)
  set logscale xy
  set format y "10^{%T}"
  set xlabel "seconds, all levels up to this one"
  set key right top reverse Left samplen 2 font ",8"
  do for [s in with_error] {
    set title title_of(s)
    plot for [k=1:n_linear] series(s, word(linear_solvers, k)) using "t_nested":"u_h1" with linespoints pt 7 ps 0.8 \
           lc rgb linear_colours[k] title "‖u−u_h‖₁, " . word(linear_solvers, k) noenhanced, \
         for [k=1:n_linear] series(s, word(linear_solvers, k)) using "t_nested":"u_post_h1" with linespoints pt 6 ps 0.8 \
           dt 2 lc rgb linear_colours[k] title "‖u−πu_h‖₁, " . word(linear_solvers, k) noenhanced
  }
  unset multiplot
  unset logscale
  set format y "%g"
}

# Time against unknowns by stage, divided by the unknowns: linear cost is level. The first level is left out: it bears
# what is done once, such as reading the expressions.
first = n_levels > 2 ? 1 : 0
set terminal pngcairo size 520*n_linear,300*n_scenes font "DejaVu Sans,10"
set output folder . "/benchmark_stages.png"
set multiplot layout n_scenes,n_linear
set xlabel "unknowns"
set ylabel "microseconds per unknown"
set key outside right top reverse Left samplen 1 font ",8"
set boxwidth 0.8
set yrange [0:*]
set offsets 0.6,0.6,0,0
stages = "t_mesh t_setup t_assembly t_factor t_compliance t_qp t_recovery t_postprocess"
stage_titles = "'mesh' 'spaces, D, G' 'assembly' 'factorisation' 'compliance' 'dual problem' 'recovery' 'certificate, estimate'"
total(k) = (sum [i=1:k] column(word(stages, i)))*1e6/column("dofs")
do for [s in scenes] {
  do for [l in linear_solvers] {
    set title title_of(s) . ", " . l noenhanced
    plot for [k=8:1:-1] series(s, l) every ::first using "level":(total(k)):xtic(stringcolumn("dofs")) with boxes lc rgb colours[k] \
      title word(stage_titles, k)
  }
}
unset multiplot
set offsets 0,0,0,0

# Memory per unknown.
if (n_levels > 2) {
  set terminal pngcairo size 640,420 font "DejaVu Sans,10"
  set output folder . "/benchmark_memory.png"
  set logscale x
  set yrange [*:*]
  set key inside right bottom
  set title "Peak memory above that of the first level"
  set ylabel "bytes per unknown"
  set xtics auto
  plot for [k=1:n_linear] folder . "/series/memory-" . word(linear_solvers, k) . ".csv" using "dofs":"bytes_per_dof" \
    with linespoints pt 7 lc rgb linear_colours[k] title word(linear_solvers, k) noenhanced
}
