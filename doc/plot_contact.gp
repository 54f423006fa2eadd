# SPDX-License-Identifier: LGPL-2.1-or-later
# Draws a contact-LL.csv: for every contact side the contact pressure -p (positive in compression), and the boundary
# against the foundation.
#   gnuplot -e "file='results/block_on_parabola/contact-07.csv'; picture='contact.png'" doc/plot_contact.gp

if (!exists("file")) { print "usage: gnuplot -e \"file='contact-LL.csv'; picture='contact.png'\" doc/plot_contact.gp"; exit }
if (!exists("picture")) picture = "contact.png"

set datafile separator ","
set datafile columnheaders
# Rows of other sides have the value NaN and are left out.
set datafile missing NaN
sides = ""
quoted(name) = "\"".name."\""
remember(name) = strstrt(sides, quoted(name)) ? 0 : (sides = sides." ".quoted(name), 1)
stats file using (remember(strcol("side"))) name "new" nooutput
n = words(sides)
# Polynomials have rows at the ends of faces, so also where a side begins; constants have middles only.
stats file using "s" name "s" nooutput
kind = s_min > 0 ? "histeps" : "lines"
name = s_min > 0 ? "p_H, constant on every patch" : "p_H, a polynomial on every face"
on(i, side, value) = side eq word(sides, i) ? value : NaN

set terminal pngcairo size 1000 + 600*(n - 1),640 font "DejaVu Sans,11"
set output picture
set multiplot layout 2,n columnsfirst
set grid lc rgb "#dddddd"
set border lc rgb "#888888"
set lmargin 12
set rmargin 4

do for [i=1:n] {
  of_side = n == 1 ? "" : ", side ".word(sides, i)
  set title "Contact pressure −p (force/area)".of_side
  set format x ""
  set xlabel ""
  set key top right
  set yrange [*:*]
  plot file using "s":(on(i, strcol("side"), -column("p_H"))) with @kind lw 2 lc rgb "#9ecae1" title name, \
       file using "s":(on(i, strcol("side"), -column("p_recovered"))) with lines lw 2 lc rgb "#08519c" title "recovered"

  stats file using (on(i, strcol("side"), -column("g"))) name "foundation" nooutput
  depth = foundation_min - 0.1*(foundation_max - foundation_min) - 1e-12
  set title "Normal displacement against the foundation (length)".of_side
  set format x "%g"
  set key bottom center
  set yrange [depth:*]
  set xlabel "arc length s along the contact side"
  plot file using "s":(on(i, strcol("side"), -column("g"))) with filledcurves y1=depth fs solid 0.25 noborder lc rgb "#999999" notitle, \
       file using "s":(on(i, strcol("side"), -column("g"))) with lines lw 2 lc rgb "#555555" title "foundation, −g", \
       file using "s":(on(i, strcol("side"), -column("u_n"))) with lines lw 2 lc rgb "#d94801" title "boundary of the body, −u_n"
}
unset multiplot
