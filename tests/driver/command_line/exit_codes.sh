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

says() { [[ $(<stdout) == *"$1"* ]]; }
complains() { [[ $(<stderr) == *"$1"* ]]; }

# run_scenes CODE ARGUMENTS...: the scenes of the array "scenes" in one call. Its standard output is kept by scene.
declare -A output_of
run_scenes() {
  local line n=-1
  run "$1" "${scenes[@]/%/.prm}" "${@:2}"
  output_of=()
  while IFS= read -r line; do
    if [[ $line == 'Scene  '* ]]; then n=$((n + 1)); fi
    output_of[${scenes[n]:-more}]+=$line$'\n'
  done <stdout
  mapfile -t complaints <stderr
}
# of SCENE TEXT
of() { [[ ${output_of[$1]} == *"$2"* ]]; }

# refuse_late FRAGMENT ARGUMENTS...: exit code 1, one line that holds the fragment, nothing left
# behind. What was wrong shows on a level only, after the scene has been printed.
refuse_late() {
  local fragment=$1
  shift
  run 1 "$@"
  check "  says '$fragment'" complains "$fragment"
  check "  in one line" one_line_of_complaint
  check "  and leaves nothing behind" only_the_inputs
}

# refuse FRAGMENT ARGUMENTS...: the same, and nothing is printed before.
refuse() {
  refuse_late "$@"
  check "  and prints nothing else" is_empty stdout
}

# refuse_scenes DIRECTORY FILES... -- FRAGMENTS...: exit code 1 for all of these files in one call, a line for each of them that
# holds its fragment, and nothing left behind.
refuse_scenes() {
  local directory_of_call=$1 files=() i
  shift
  while [ "$1" != -- ]; do
    files+=("$1")
    shift
  done
  shift
  run 1 "${files[@]}" --output "$directory_of_call"
  mapfile -t complaints <stderr
  ends=''
  for i in "${!files[@]}"; do
    check "  says '${*:i+1:1}'" line_holds "$i" "${*:i+1:1}"
    ends+=$'\n'"${files[i]}: wrong input, exit code 1, $directory_of_call/$(basename "${files[i]}" .prm)"
  done
  check "  in one line each" [ "${#complaints[@]}" -eq "${#files[@]}" ]
  check "  and leaves nothing behind" only_the_inputs
}
# line_holds N FRAGMENT: of a line of stderr, counted from 0.
line_holds() { [[ ${complaints[$1]} == 'signorini: '*"$2"* && ${complaints[$1]} == *[.\)] ]]; }

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
  cp a1.prm x.prm
  variant a1.prm late 'Discretization/Patch ratio=1' 'Solver/Require stability=true'
  variant loose.prm bent Boundary/Clamped=top Geometry/Distortion=0.45 'Discretization/Coarsest level=5'
  touch file stdout stderr
  mkdir folder.prm
  inputs=$(ls -A)
}

# --check shows a scene, solves nothing and leaves earlier results alone.
test_check() {
  mkdir -p shown path
  echo old >shown/answer.json
  # Without the package for pictures.
  printf '#!/bin/sh\nexit 127\n' >path/python3
  chmod +x path/python3
  PATH=$PWD/path:$PATH run 0 "$1" --check --output shown
  check "  the sides" grep -q '^bottom  *contact  *(0, 0)  *(1, 0)  *1  *gap ' stdout
  check "  the first mesh" says 'First mesh: 16 cells.'
  check "  the cost" grep -q '^Cost: level 3 has 64 cells and 4 patches, .* about 128 unknowns' stdout
  check "  its file" grep -q '"role":"contact"' shown/scene.json
  check "  why there is no picture" says "Picture: not drawn, because Python's matplotlib is missing"
  check "  nothing is solved" [ ! -e shown/convergence.csv ]
  check "  earlier results stay" [ "$(<shown/answer.json)" = old ]
  printf 'set Dimension = 3\nsubsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n' >box.prm
  printf 'subsection Load\nset Body force = 0; 0; -0.1*x\nend\n' >>box.prm
  printf 'subsection Contact\nset Friction = coulomb\nset Friction coefficient = 0.1+x\nend\n' >>box.prm
  printf 'subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n' >flat.prm
  printf 'subsection Contact\nset Foundation = circle 0.5,-1 radius 1\nend\n' >>flat.prm
  printf 'subsection Load cases\nset Cases = gap 0 to 2 in 5 cases | shift y 0.1\nend\n' >>flat.prm
  scenes=(box flat)
  run_scenes 0 --check --output shown
  check "  sides in space" grep -q '^bottom  *contact .* (1, 1, 0)  *1  *gap 0, friction coefficient 0.1 to 1.1$' stdout
  check "  friction" of box 'Friction: coulomb, bottom 0.1 to 1.1.'
  check "  the body force" of box 'Body force: x: 0, y: 0, z: -0.0875 to -0.0125.'
  check "  foundations and load cases" of flat 'Load cases: 6: gap 0 to 2, shift y 0 to 0.1.'
  check "  in the file, too" grep -qF '"notes":["Foundation: circle 0.5,-1 radius 1",' shown/flat/scene.json
  check "  a picture, if it can be drawn" eval "says 'Picture: shown/flat/scene.svg' || says matplotlib"
  rm -r shown path box.prm flat.prm
}

test_answers() {
  run 0 -h
  for word in usage: --set --sweep --output --list-scenes --print-parameters --check --quiet --verify --verify-tolerance --version 'Exit codes'; do
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
  check "  a wrong name is refused" complains "found the subsection 'Contacts', allowed: Boundary, "
  : >stderr
  check "answers leave nothing behind" only_the_inputs
  check "answers say nothing on stderr" is_empty stderr
}

test_refusals() {
  refuse 'no parameter file is given'
  refuse "unrecognised option '--frobnicate'" --frobnicate a1.prm
  refuse '--help lists what is allowed' --out results a1.prm
  refuse "the parameter files 'a1.prm' and './a1.prm', whose results would both go to" a1.prm ./a1.prm
  refuse '--set' a1.prm --set
  refuse '--set: Contact/Gap: the expression' loose.prm --set $'Contact/Gap=x\n+'
  refuse "--output: found ''" a1.prm --output ''
  refuse "allowed: a directory" a1.prm --output "new/$(printf 'x%.0s' {1..300})"
  refuse_scenes file 'no such file.prm' binary.prm loose.prm x.prm -- \
    'no such file.prm: this parameter file cannot be read.' 'binary.prm: this is not a text file.' 'of the body free' \
    "--output: found 'file/x', allowed: a directory"
  check "  and prints nothing but what became of each" [ "$(<stdout)" = "$ends" ]
  refuse_scenes deep/er/results late.prm bent.prm -- 'a contact patch is no longer than a face' 'is not convex'
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
n_lines() { wc -l <"$1"; }

# described TOP GAP [DIMENSION]: a block whose top is displaced.
described() {
  printf 'set Dimension = %s\nsubsection Boundary\n  set Contact = bottom\n  set Rollers = left\n' "${3:-2}"
  printf '  set Displacement = top: %s\nend\nsubsection Contact\n  set Gap = %s\nend\n' "$1" "$2"
  printf 'subsection Discretization\n  set Coarsest level = 2\n  set Finest level = 3\nend\n'
}

# All that ends well, in one call. Whatever number is known of the error decides.
test_certified() {
  variant a1.prm replaced 'Solver/Tolerated error=2' 'Discretization/Finest level=2' Discretization/Patches=7
  # 6144 unknowns in space, which V-cycles are chosen for; three do not solve anything.
  cat >factors.prm <<'PRM'
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
subsection Solver
  set Maximum iterations = 3
end
subsection Output
  set Inf-sup constant = false
  set VTU = none
end
PRM
  variant jump.prm boundless 'Solver/Tolerated error=0.3' Output/Bound=false
  described '0; 0' 0.1 | sed '/Rollers/d' >held.prm
  described '1; -0.03' 0.1 | sed '/Rollers/d' >rigid.prm
  variant rigid.prm rough Contact/Friction=tresca 'Contact/Friction bound=0.01'
  described '0; 0; 0.01' 0.1 3 >above.prm
  variant above.prm lifted 'Solver/Contact solver=multigrid' Solver/Tolerance=1e-3
  printf 'subsection Boundary\nset Contact = bottom\nset Rollers = left\nset Plates = top: 0, -1 turning\nend\n' >plate.prm
  printf 'subsection Load\nset Plate travel = top: 0.04\nend\nsubsection Contact\nset Gap = 0.1\nend\n' >>plate.prm
  printf 'subsection Discretization\nset Coarsest level = 2\nset Finest level = 3\nend\n' >>plate.prm
  # A circle that touches the body in one point, without loads: what is left is the rounding of the gap.
  printf 'subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n' >touching.prm
  for x in 0.5 0.3 0.37; do
    variant touching.prm "touching_$x" Discretization/Strategy=hp "Contact/Foundation=circle $x,-1 radius 1"
  done
  # The last V-cycle takes nearly all of the residual.
  described '0; -0.02*x' 0.01 | sed 's/Rollers/Clamped/' >base.prm
  variant base.prm cycles 'Geometry/Cells=2, 1' 'Discretization/Coarsest level=0' 'Solver/Contact solver=multigrid' Solver/Tolerance=1e-8
  # Load cases alone touch: graded meshes, which would miss their contact, give way to nested ones. A second scene is printed.
  described '0; -0.01' '0.02+(x-0.3)^2' | sed '/level/d' >base.prm
  variant base.prm apart 'Load cases/Cases=travel 4' 'Discretization/Target error=0.05'
  scenes=(a1 replaced factors boundless held rigid rough lifted plate touching_0.5 touching_0.3 touching_0.37 cycles apart)
  run_scenes 0
  check "  a table is printed" of a1 'Certified'
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
  check "  a solver that was not chosen says so" of replaced 'projected SOR answered instead'
  check "  and the certificate, too" grep -q '"contact_solver_replaced": true' results/replaced/certificate.json
  check "  V-cycles that are given up say so" \
    of factors 'on level 3 a factorisation answered instead of V-cycles (level 3 did not end within'
  check "  a bound is not computed unless it is wanted" of boundless 'there is no bound of the error (Output/Bound is false)'
  for name in held rigid; do
    check "  nothing touches" of $name 'nothing touches'
    check "  the error is rounding" of $name 'at most 0.000001 %'
  done
  check "  friction: nothing touches" of rough 'nothing touches'
  check "  no ratio of forces that vanish" [ "$(grep -cwiE 'T/N|nan|inf' <<<"${output_of[rough]}")" -eq 0 ]
  for x in 0.5 0.3 0.37; do check "  touching at $x: nothing touches" of "touching_$x" 'nothing touches'; done
  check "  graded meshes are left" of apart 'Strategy  nested, since load cases alone touch'
}

# All that does not end well.
test_not_certified() {
  variant a1.prm few_sweeps 'Solver/Contact solver=psor' 'Solver/Maximum iterations=1'
  variant a1.prm few_graded Discretization/Strategy=hp 'Solver/Maximum iterations=1'
  variant jump.prm narrow 'Solver/Tolerated error=0.01'
  variant jump.prm graded 'Solver/Tolerated error=0.001' Discretization/Strategy=hp 'Discretization/Maximum unknowns=400'
  printf 'subsection %s\n  set %s\nend\n' Geometry 'Shape = half disc' Boundary 'Contact = arc' \
    Boundary 'Displacement = flat: 0; -0.02' Contact 'Foundation = plane 0,-1 normal 0,1' \
    Load 'Body force = 0; y<-0.5 ? -0.01 : 0' Discretization 'Strategy = hp' Solver 'Tolerated error = 1e-5' >disc.prm
  described '0; 0; -0.02' '(x^2 + y^2)/2' 3 >missed.prm
  described '0.5; -0.001' '0.02*sin(20*x)^2' | sed 's/Rollers = left/Rollers =/' >moved.prm
  variant a1.prm huge Discretization/Strategy=hp 'Discretization/Coarsest level=14'
  scenes=(few_sweeps few_graded narrow graded disc missed moved huge)
  run_scenes 2 --output not
  check "  one line each" [ "${#complaints[@]}" -eq "${#scenes[@]}" ]
  for name in "${scenes[@]::7}"; do check "  $name: exit code 2" says ", exit code 2, not/$name"; done
  check "  results are written, of no finer level" [ "$(n_lines not/few_sweeps/convergence.csv)" -eq 2 ]
  check "  and marked" verdict_is not/few_sweeps 'not certified'
  check "  and it is said" of few_sweeps 'NOT certified'
  check "  graded meshes, too" [ "$(n_lines not/few_graded/convergence.csv)" -eq 2 ]
  check "  a bound is above Tolerated error" line_holds 2 'guaranteed bound; Tolerated error: 1 %'
  check "  graded meshes are named" line_holds 2 'Strategy = hp'
  check "  on graded meshes, too" line_holds 3 'Tolerated error'
  check "  an estimate is above Tolerated error" line_holds 4 'estimated; Tolerated error: 0.001 %'
  check "  contact that is missed in space" line_holds 5 'contact is not resolved: refine'
  check "  contact that a body misses which moves as a whole" line_holds 6 'contact is not resolved'
  check "  huge: exit code 1" ends_with huge.prm 'wrong input' 1 not/huge
  check "  before it is made" line_holds 7 'the first mesh has more than 2.14748e+09 unknowns'
}

# What is done with the results of a run, and with options.
test_run() {
  run 0 results/a1/parameters.prm --output again
  check "  the same numbers from parameters.prm alone" same_numbers results/a1 again
  check "  the same parameters" cmp -s results/a1/parameters.prm again/parameters.prm
  run 0 --set 'Discretization/Finest level=4' a1.prm --set 'Discretization/Finest level=2' --set 'Solver/Tolerated error=2' \
    --output=one/two --set 'Output/VTU=none' --set 'Output/Compliance=true'
  check "  the last --set wins" [ "$(n_lines one/two/convergence.csv)" -eq 2 ]
  check "  no VTU" [ ! -e one/two/solution-02.vtu ]
  for name in A C D F G P f; do
    check "  $name-02.mtx" [ -s "one/two/$name-02.mtx" ]
  done
  run 0 plate.prm --sweep 'Load/Plate travel=top: 0, top: 0.1, top: 0.15' --set 'Load cases/Cases=travel 0 | travel 1'
}

described '0; -0.1*x' -0.05 >jump.prm
write_inputs
test_answers
test_check a1.prm
test_refusals
test_certified
test_not_certified
test_run
echo "$failures failures"
[ "$failures" -eq 0 ]
