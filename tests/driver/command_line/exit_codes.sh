#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# What the program answers on the command line: exit codes, messages and files.
# usage: exit_codes.sh PROGRAM

program=$(realpath "$1")
. "$(dirname "$0")/../../checks.bash"

# run CODE ARGUMENTS...: runs the program and checks its exit code.
run() {
  local code=$1
  shift
  "$program" "$@" >stdout 2>stderr </dev/null
  local found=$?
  check "exit code $code: signorini ${*//$'\n'/ }" [ "$found" -eq "$code" ]
}

says() { grep -qF -- "$1" stdout; }

# refuse_late FRAGMENT ARGUMENTS...: exit code 1, one line that holds the fragment, nothing left
# behind. What was wrong shows on a level only, after the scene has been printed.
refuse_late() {
  local fragment=$1
  shift
  run 1 "$@"
  check "  says '$fragment'" grep -qF -- "$fragment" stderr
  check "  in one line" one_line_of_complaint
  check "  and leaves nothing behind" only_the_inputs
}

# refuse FRAGMENT ARGUMENTS...: the same, and nothing is printed before.
refuse() {
  refuse_late "$@"
  check "  and prints nothing else" is_empty stdout
}

write_inputs() {
  cat >a1.prm <<'PRM'
# A1 on few levels
subsection Scene
  set Name = A1
end
subsection Discretization
  set Coarsest level = 2
  set Finest level   = 3
end
PRM
  printf 'subsection Boundary\nset Contact = bottom\nend\n' >loose.prm
  printf '\0\1\2' >binary.prm
  touch file stdout stderr
  mkdir folder.prm
  inputs=$(ls -A)
}

# --check shows a scene, solves nothing and leaves earlier results alone.
test_check() {
  mkdir -p shown
  echo old >shown/answer.json
  run 0 "$1" --check --output shown
  check "  the sides" grep -q '^bottom  *contact  *(0, 0)  *(1, 0)  *1  *gap ' stdout
  check "  the first mesh" says 'First mesh: 16 cells.'
  check "  the cost" grep -q '^Cost: level 3 has 64 cells and 4 patches, .* about 128 unknowns' stdout
  check "  its file" grep -q '"role":"contact"' shown/scene.json
  check "  nothing is solved" [ ! -e shown/convergence.csv ]
  check "  earlier results stay" [ "$(cat shown/answer.json)" = old ]
  printf 'set Dimension = 3\nsubsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n' >shown/box.prm
  printf 'subsection Load\nset Body force = 0; 0; -0.1*x\nend\n' >>shown/box.prm
  printf 'subsection Contact\nset Friction = coulomb\nset Friction coefficient = 0.1+x\nend\n' >>shown/box.prm
  run 0 shown/box.prm --check --output shown
  check "  sides in space" grep -q '^bottom  *contact .* (1, 1, 0)  *1  *gap 0, friction coefficient 0.1 to 1.1$' stdout
  check "  friction" says 'Friction: coulomb, bottom 0.1 to 1.1.'
  check "  the body force" says 'Body force: x: 0, y: 0, z: -0.0875 to -0.0125.'
  printf 'subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n' >shown/flat.prm
  printf 'subsection Contact\nset Foundation = circle 0.5,-1 radius 1\nend\n' >>shown/flat.prm
  run 0 shown/flat.prm --check --output shown --set 'Load cases/Cases=gap 0 to 2 in 5 cases | shift y 0.1'
  check "  foundations and load cases" says 'Load cases: 6: gap 0 to 2, shift y 0 to 0.1.'
  check "  in the file, too" grep -qF '"notes":["Foundation: circle 0.5,-1 radius 1",' shown/scene.json
  rm -r shown
}

test_answers() {
  run 0 -h
  for word in usage: --set --sweep --output --list-scenes --print-parameters --check --quiet --version 'Exit codes'; do
    check "  help names $word" says "$word"
  done
  run 0 --version
  for word in 'signorini ' deal.II Trilinos BLAS; do
    check "  version names $word" says "$word"
  done
  run 0 --list-scenes
  for word in described A1 D1 'block on parabola'; do
    check "  scenes: $word" says "$word"
  done
  run 0 --print-parameters
  for word in 'set Contact solver' 'active set' 'psor' 'set Relaxation' '= 1.1' 'Allowed:' \
    '(both excluded)' '(force/area)' 'subsection Output'; do
    check "  parameters: $word" says "$word"
  done
  run 0 --print-parameters Contact Load
  check "  parameters of two subsections" [ "$(grep -c '^subsection' stdout)" -eq 2 ]
  check "    with their entries" says 'set Friction coefficient'
  run 1 --print-parameters Contacts
  check "  a wrong name is refused" grep -q "found the subsection 'Contacts', allowed: Boundary, " stderr
  : >stderr
  check "answers leave nothing behind" only_the_inputs
  check "answers say nothing on stderr" is_empty stderr
}

test_refusals() {
  refuse 'no parameter file is given'
  refuse "unrecognised option '--frobnicate'" --frobnicate a1.prm
  refuse '--help lists what is allowed' --out results a1.prm
  refuse "the parameter files 'a1.prm' and './a1.prm', whose results would both go to" a1.prm ./a1.prm
  refuse 'no such file.prm: this parameter file cannot be read.' 'no such file.prm'
  refuse 'binary.prm: this is not a text file.' binary.prm
  refuse 'of the body free' loose.prm
  refuse '--set' a1.prm --set
  refuse '--set: Contact/Gap: the expression' loose.prm --set $'Contact/Gap=x\n+'
  refuse "--output: found 'file/x', allowed: a directory" a1.prm --output file/x
  refuse "--output: found ''" a1.prm --output ''
  refuse "allowed: a directory" a1.prm --output "new/$(printf 'x%.0s' {1..300})"
  refuse_late 'a contact patch is no longer than a face' a1.prm --output deep/er/results \
    --set 'Discretization/Patch ratio=1' --set 'Solver/Require stability=true'
  refuse_late 'is not convex' loose.prm --set 'Boundary/Clamped=top' \
    --set 'Geometry/Distortion=0.45' --set 'Discretization/Coarsest level=5'
}

columns="level,cells,dofs,multipliers,h,H,active,qp_iterations,kkt,inf_sup,energy,contact_force_n"
columns+=",max_pressure,contact_length,u_h1,u_l2,u_superclose_h1,u_post_h1,p_l2,p_dual"
columns+=",p_dual_spectral,p_superclose_dual,p_superclose_dual_spectral,p_post_l2,endpoint_error"
columns+=",estimated_h1,effectivity"
times=",t_mesh,t_setup,t_assembly,t_factor,t_compliance,t_qp,t_recovery,t_postprocess,t_errors"
times+=",t_output,t_total,cpu_total,peak_memory_mb"

header_is_right() { head -n 1 "$1" | grep -q "^$columns$times\(,.*\)\?$"; }
cells_of() { tail -n +2 "$1/convergence.csv" | cut -d, -f1,2 | tr '\n' ' '; }
numbers_of() { cut -d, -f1-27 "$1/convergence.csv"; }
same_numbers() { [ "$(numbers_of "$1")" = "$(numbers_of "$2")" ]; }
verdict_is() { grep -q "\"verdict\": \"$2\"" "$1/certificate.json"; }

test_run() {
  run 0 a1.prm
  check "  a table is printed" says 'Certified'
  check "  nothing on stderr" is_empty stderr
  for name in convergence.csv certificate.json parameters.prm solution-03.vtu contact-03.vtu \
    solution.pvd contact.pvd contact-02.csv contact-03.csv; do
    check "  results/a1/$name" [ -s "results/a1/$name" ]
  done
  check "  no fields of coarser levels" [ ! -e results/a1/solution-02.vtu ]
  check "  header of convergence.csv" header_is_right results/a1/convergence.csv
  check "  one row per level" [ "$(cells_of results/a1)" = '2,16 3,64 ' ]
  check "  header of contact-03.csv" [ "$(head -n 1 results/a1/contact-03.csv)" = \
    'side,s,x,y,p_H,p_recovered,u_n,g,p_exact,patch,patch_length' ]
  check "  verdict" verdict_is results/a1 certified

  run 0 results/a1/parameters.prm --output again
  check "  the same numbers from parameters.prm alone" same_numbers results/a1 again
  check "  the same parameters" cmp -s results/a1/parameters.prm again/parameters.prm
  run 0 --set 'Discretization/Finest level=4' a1.prm --set 'Discretization/Finest level=2' --set 'Solver/Tolerated error=2' \
    --output=one/two --set 'Output/VTU=none' --set 'Output/Compliance=true'
  check "  the last --set wins" [ "$(wc -l <one/two/convergence.csv)" -eq 2 ]
  check "  no VTU" [ ! -e one/two/solution-02.vtu ]
  for name in A C D F G P f; do
    check "  $name-02.mtx" [ -s "one/two/$name-02.mtx" ]
  done
}

test_exhausted() {
  run 2 a1.prm --output exhausted --set 'Solver/Contact solver=psor' \
    --set 'Solver/Maximum iterations=1'
  check "  results are written, of no finer level" [ "$(wc -l <exhausted/convergence.csv)" -eq 2 ]
  check "  and marked" verdict_is exhausted 'not certified'
  check "  and it is said" says 'NOT certified'
  run 2 a1.prm --output exhausted --set Discretization/Strategy=hp --set 'Solver/Maximum iterations=1'
  check "  graded meshes, too" [ "$(wc -l <exhausted/convergence.csv)" -eq 2 ]
  run 1 a1.prm --output huge --set Discretization/Strategy=hp --set 'Discretization/Coarsest level=14'
  check "  before it is made" grep -q 'the first mesh has more than 2.14748e+09 unknowns' stderr
}

test_replaced() {
  run 0 a1.prm --output replaced --set 'Solver/Tolerated error=2' --set 'Discretization/Finest level=2' --set 'Discretization/Patches=7'
  check "  a solver that was not chosen says so" says 'projected SOR answered instead'
  check "  and the certificate, too" grep -q '"contact_solver_replaced": true' replaced/certificate.json
  # 6144 unknowns in space, which V-cycles are chosen for; three do not solve anything.
  cat >box.prm <<'PRM'
set Dimension = 3
subsection Geometry
  set Shape = box
  set Cells = 2, 2, 1
end
subsection Boundary
  set Clamped = top
  set Contact = bottom
end
subsection Load
  set Body force = 0; 0; -0.01
end
subsection Discretization
  set Coarsest level = 3
  set Finest level   = 3
end
PRM
  run 0 box.prm --output factors --set 'Solver/Maximum iterations=3' --set 'Output/Inf-sup constant=false' --set Output/VTU=none
  check "  V-cycles that are given up say so" says 'on level 3 a factorisation answered instead of V-cycles (level 3 did not end within'
}

# described TOP GAP [DIMENSION]: a block whose top is displaced.
described() {
  printf 'set Dimension = %s\nsubsection Boundary\n  set Contact = bottom\n  set Rollers = left\n' "${3:-2}"
  printf '  set Displacement = top: %s\nend\nsubsection Contact\n  set Gap = %s\nend\n' "$1" "$2"
  printf 'subsection Discretization\n  set Coarsest level = 2\n  set Finest level = 3\nend\n'
}

# Whatever number is known of the error decides.
test_accuracy() {
  described '0; -0.1*x' -0.05 >jump.prm
  run 2 jump.prm --set 'Solver/Tolerated error=0.01'
  check "  a bound is above Tolerated error" grep -q 'guaranteed bound; Tolerated error: 1 %' stderr
  check "  graded meshes are named" grep -q 'Strategy = hp' stderr
  run 0 jump.prm --set 'Solver/Tolerated error=0.3' --set Output/Bound=false
  check "  a bound is not computed unless it is wanted" \
    says 'there is no bound of the error (Output/Bound is false)'
  run 2 jump.prm --set 'Solver/Tolerated error=0.001' --set Discretization/Strategy=hp \
    --set 'Discretization/Maximum unknowns=400'
  check "  on graded meshes, too" grep -q 'Tolerated error' stderr
  printf 'subsection %s\n  set %s\nend\n' Geometry 'Shape = half disc' Boundary 'Contact = arc' \
    Boundary 'Displacement = flat: 0; -0.02' Contact 'Foundation = plane 0,-1 normal 0,1' \
    Load 'Body force = 0; y<-0.5 ? -0.01 : 0' Discretization 'Strategy = hp' >disc.prm
  run 2 disc.prm --set 'Solver/Tolerated error=1e-5'
  check "  an estimate is above Tolerated error" grep -q 'estimated; Tolerated error: 0.001 %' stderr

  described '0; 0; -0.02' '(x^2 + y^2)/2' 3 >missed.prm
  run 2 missed.prm
  check "  contact that is missed in space" grep -q 'penetrates where no patch presses' stderr
  described '0; -0.001' '0.02*sin(20*x)^2' >moved.prm
  sed -i 's/top: 0/top: 0.5/; s/Rollers = left/Rollers =/' moved.prm
  run 2 moved.prm
  check "  contact that a body misses which moves as a whole" grep -q 'contact is not resolved' stderr

  for top in '0; 0' '1; -0.03'; do
    described "$top" 0.1 >rigid.prm
    sed -i '/Rollers/d' rigid.prm
    run 0 rigid.prm
    check "  nothing touches" says 'nothing touches'
    check "  the error is rounding" says 'at most 0.000001 %'
  done
  run 0 rigid.prm --set 'Contact/Friction=tresca' --set 'Contact/Friction bound=0.01'
  check "  friction: nothing touches" says 'nothing touches'
  check "  no ratio of forces that vanish" [ "$(grep -cwiE 'T/N|nan|inf' stdout)" -eq 0 ]
  described '0; 0; 0.01' 0.1 3 >rigid.prm
  run 0 rigid.prm --set 'Solver/Contact solver=multigrid' --set Solver/Tolerance=1e-3
  printf 'subsection Boundary\nset Contact = bottom\nset Rollers = left\nset Plates = top: 0, -1 turning\nend\n' >plate.prm
  printf 'subsection Load\nset Plate travel = top: 0.04\nend\nsubsection Contact\nset Gap = 0.1\nend\n' >>plate.prm
  printf 'subsection Discretization\nset Coarsest level = 2\nset Finest level = 3\nend\n' >>plate.prm
  run 0 plate.prm
  run 0 plate.prm --sweep 'Load/Plate travel=top: 0, top: 0.1, top: 0.15' --set 'Load cases/Cases=travel 0 | travel 1'

  # Load cases alone touch: graded meshes, which would miss their contact, give way to nested ones.
  described '0; -0.01' '0.02+(x-0.3)^2' >apart.prm
  sed -i '/level/d' apart.prm
  run 0 apart.prm --set 'Load cases/Cases=travel 4' --set 'Discretization/Target error=0.05'
  check "  graded meshes are left" says 'Strategy  nested, since load cases alone touch'

  # A circle that touches the body in one point, without loads: what is left is the rounding of the gap.
  printf 'subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n' >touching.prm
  for x in 0.5 0.3 0.37; do
    run 0 touching.prm --set Discretization/Strategy=hp --set "Contact/Foundation=circle $x,-1 radius 1"
    check "  touching at $x: nothing touches" says 'nothing touches'
  done

  # The last V-cycle takes nearly all of the residual.
  described '0; -0.02*x' 0.01 >cycles.prm
  sed -i 's/Rollers/Clamped/' cycles.prm
  run 0 cycles.prm --set 'Geometry/Cells=2, 1' --set 'Discretization/Coarsest level=0' \
    --set 'Solver/Contact solver=multigrid' --set Solver/Tolerance=1e-8
}

write_inputs
test_answers
test_check a1.prm
test_refusals
test_run
test_exhausted
test_replaced
test_accuracy
echo "$failures failures"
[ "$failures" -eq 0 ]
