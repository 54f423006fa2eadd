#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# The pictures of a run where gnuplot is installed, and what is said where it is not.
# usage: pictures.sh PROGRAM PRM_FOLDER MPIEXEC

program=$(realpath "$1")
scenes=$(realpath "$2")
mpiexec=$3
. "$(dirname "$0")/../../driver/command_line/checks.sh"

run() { "$program" "$@" --set Output/VTU=none >stdout 2>stderr; }
pictures_of() { (cd "$1" && ls -A | grep -v '\.csv$\|\.json$\|\.prm$' | tr '\n' ' '); }
# Every tag is closed by its own name, attributes are quoted, and there is one element at the top.
well_formed() {
  perl -0777 -e '
    $_ = <>; s/^<\?xml[^>]*\?>//; s/<!--.*?-->//gs; my ($depth, $tops, @open) = (0, 0);
    while (/\G([^<]*)(<[^>]*>)?/g) {
      my ($text, $tag) = ($1, $2); $text =~ s/&(lt|gt|amp|quot|apos|#\d+);//g;
      die "a bare & in: $text" if $text =~ /&/; die "text at the top: $text" if !@open && $text =~ /\S/;
      last if !defined $tag;
      if ($tag =~ m{^</([\w:]+)\s*>$}) { my $top = pop @open; die "$tag closes $top" if $top ne $1; }
      elsif ($tag =~ m{^<([\w:]+)(\s+[\w:-]+\s*=\s*("[^"<]*"|\x27[^\x27<]*\x27))*\s*(/?)>$}) { ++$tops if !@open; push @open, $1 if $4 eq ""; }
      else { die "no tag: $tag"; }
    }
    die "open: @open" if @open; die "$tops elements at the top" if $tops != 1;' "$1" 2>stderr
}
# curves FILE: gnuplot puts each into a group. polygons FILE: those of the first group.
curves() { grep -c 'id="gnuplot_plot_' "$1"; }
polygons() { awk '/id="gnuplot_plot_1"/ { on = 1 } /id="gnuplot_plot_2"/ { on = 0 } on && /<polygon/ { ++n } END { print n }' "$1"; }

# Where gnuplot is not found the run succeeds, draws nothing and says what to install.
mkdir empty
PATH=$directory/empty "$program" "$scenes/a1.prm" --set 'Discretization/Finest level=3' --set Output/VTU=none \
  --set Output/Pictures=true --output without >stdout 2>stderr
check "a run without gnuplot is certified" [ $? -eq 0 ]
check "  and says what to install, once" [ "$(grep -c '^Pictures: .*install it (the package gnuplot-nox in Debian).*\.$' stdout)" -eq 1 ]
check "  and draws nothing" [ -z "$(pictures_of without)" ]

# A gnuplot that fails is one sentence, too.
printf '#!/bin/sh\necho "line 1: no such terminal" >&2\nexit 1\n' >empty/gnuplot
chmod +x empty/gnuplot
PATH=$directory/empty:$PATH run "$scenes/a1.prm" --set 'Discretization/Finest level=3' --set Output/Pictures=true --output fails
check "a run with a gnuplot that fails is certified" [ $? -eq 0 ]
check "  and says why" grep -qx 'Pictures: pressure.svg was not drawn: gnuplot failed: line 1: no such terminal\.' stdout
check "  and draws nothing" [ -z "$(pictures_of fails)" ]
printf '#!/bin/sh\nkill -9 $$\n' >empty/gnuplot
PATH=$directory/empty:$PATH run "$scenes/a1.prm" --set 'Discretization/Finest level=3' --set Output/Pictures=true --output killed
check "a run with a gnuplot that is killed is certified" [ $? -eq 0 ]
check "  and says why" grep -qx 'Pictures: pressure.svg was not drawn: gnuplot failed: it said nothing\.' stdout
# One that does not end is stopped after a minute, during which the results are there.
printf '#!/bin/sh\nexec sleep 1000\n' >empty/gnuplot
PATH=$directory/empty:$PATH run "$scenes/a1.prm" --set 'Discretization/Finest level=3' --set Output/Pictures=true --output hangs
check "a run with a gnuplot that hangs is certified" [ $? -eq 0 ]
check "  and says why" grep -qx 'Pictures: pressure.svg was not drawn: gnuplot did not end within 60 seconds and was stopped\.' stdout
check "  the certificate, too" grep -q '"verdict": "certified"' hangs/certificate.json

if ! command -v gnuplot >/dev/null; then
  echo "gnuplot is not installed: the pictures themselves are not tested."
  echo "$failures failures"
  [ "$failures" -eq 0 ]
  exit
fi

run "$scenes/a1.prm" --set 'Discretization/Finest level=6' --set Output/Pictures=true --output a1
check "a run with pictures" [ $? -eq 0 ]
check "  says nothing about them" [ "$(grep -c Pictures: stdout)" -eq 0 ]
check "  which are three files" [ "$(pictures_of a1)" = "convergence.svg deformed.svg pressure.svg " ]
for picture in pressure deformed convergence; do
  check "  $picture.svg is well formed" well_formed "a1/$picture.svg"
done
check "  pressure: p_H, recovered, exact; opening, exact opening" [ "$(curves a1/pressure.svg)" -eq 5 ]
check "  convergence: estimate, error, bound, triangle" [ "$(curves a1/convergence.svg)" -eq 4 ]
check "  deformed: every one of 64² cells" [ "$(polygons a1/deformed.svg)" -eq 4096 ]
run "$scenes/a1.prm" --set 'Discretization/Coarsest level=7' --set 'Discretization/Finest level=7' --set Output/Errors=false \
  --set Output/Pictures=true --output fine
check "  of 128² cells their parents" [ "$(polygons fine/deformed.svg)" -eq 4096 ]
run "$scenes/a1.prm" --set 'Discretization/Finest level=3' --output a1
check "a run without pictures removes earlier ones" [ -z "$(pictures_of a1)" ]

# The same files from two processes, of a body with two contact sides.
run "$scenes/two_contact_sides.prm" --set 'Discretization/Finest level=3' --set Output/Pictures=true --output one
"$mpiexec" -np 2 "$program" "$scenes/two_contact_sides.prm" --set 'Discretization/Finest level=3' --set Output/VTU=none \
  --set Output/Pictures=true --output two >stdout 2>stderr
check "two processes draw" [ "$(pictures_of two)" = "convergence.svg deformed.svg pressure.svg " ]
check "  both contact sides" [ "$(curves two/pressure.svg)" -eq "$(curves one/pressure.svg)" ]
check "  the same polygons" [ "$(polygons two/deformed.svg)" -eq "$(polygons one/deformed.svg)" ]

# Graded meshes, a curved body with names and cells of its own, and another folder for the user's settings.
run "$scenes/b1.prm" --set Discretization/Strategy=hp --set 'Discretization/Target error=0.001' --set Output/Pictures=true --output hp
check "graded meshes have pictures" [ "$(pictures_of hp)" = "convergence.svg deformed.svg pressure.svg " ]
check "  well formed" well_formed hp/deformed.svg
mkdir home && echo 'set terminal dumb; print "surprise"' >home/.gnuplot
HOME=$directory/home run "$scenes/e3.prm" --set 'Discretization/Finest level=3' --set Output/Pictures=true --output e3
check "the user's settings of gnuplot change nothing" well_formed e3/pressure.svg
run "$scenes/e3.prm" --set 'Discretization/Finest level=3' --set Output/Pictures=true --output again
check "the same run gives the same pictures" cmp e3/deformed.svg again/deformed.svg
check "nothing else is left" [ "$(ls -A | tr '\n' ' ')" = "a1 again e3 empty fails fine hangs home hp killed one stderr stdout two without " ]
echo "$failures failures"
[ "$failures" -eq 0 ]
