# SPDX-License-Identifier: LGPL-2.1-or-later
# Draws a contact-LL.csv: the pressure, and the boundary against the foundation.
#   gnuplot -e "file='results/block_on_parabola/contact-07.csv'; picture='contact.png'" doc/plot_contact.gp

if (!exists("file")) { print "usage: gnuplot -e \"file='contact-LL.csv'; picture='contact.png'\" doc/plot_contact.gp"; exit }
if (!exists("picture")) picture = "contact.png"

set terminal pngcairo size 1000,640 font "DejaVu Sans,11"
set output picture
set datafile separator ","
stats file using (-column("g")) name "foundation" nooutput
depth = foundation_min - 0.1*(foundation_max - foundation_min) - 1e-12
set multiplot layout 2,1
set grid lc rgb "#dddddd"
set border lc rgb "#888888"
set lmargin 12
set rmargin 4

set title "Contact pressure −p (force/area)"
set format x ""
plot file using "s":(-column("p_H")) with histeps lw 2 lc rgb "#9ecae1" title "p_H, constant on every patch", \
     file using "s":(-column("p_recovered")) with lines lw 2 lc rgb "#08519c" title "recovered"

set title "Normal displacement against the foundation (length)"
set format x "%g"
set key bottom center
set yrange [depth:*]
set xlabel "arc length s along the contact side"
plot file using "s":(-column("g")) with filledcurves y1=depth fs solid 0.25 noborder lc rgb "#999999" notitle, \
     file using "s":(-column("g")) with lines lw 2 lc rgb "#555555" title "foundation, −g", \
     file using "s":(-column("u_n")) with lines lw 2 lc rgb "#d94801" title "boundary of the body, −u_n"
unset multiplot
