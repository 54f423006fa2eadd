#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# The script of the benchmark on tiny levels: its tables are complete, and graded meshes reach the errors they are asked for.
# Nothing is asserted about speed.
# usage: benchmark.sh PROGRAM ROOT

program=$(realpath "$1")
script=$(realpath "$2")/scripts/benchmark.py
. "$(dirname "$0")/../../checks.bash"

# every_row COLUMN CONDITION [TABLE]: every row satisfies an awk condition on the column's value v, the row, and the first
# columns scene or strategy.
every_row() {
  awk -F, -v name="$1" "NR == 1 { for (c = 1; c <= NF; ++c) column[\$c] = c; if (!(name in column)) exit 1; next }
    { v = \$(column[name]); scene = strategy = \$1; request = \$4; if (!($2)) { wrong = 1; print \$0 } } END { exit wrong }" "$directory/out/${3:-benchmark.csv}"
}

# sum FILE COLUMN
sum() {
  awk -F, -v name="$2" 'NR == 1 { for (c = 1; c <= NF; ++c) column[$c] = c; next }
    { sum += $(column[name]) } END { printf "%.6f\n", sum }' "$1"
}

pictures=(--no-pictures)
if python3 -c "import importlib.util as i, sys; sys.exit(not i.find_spec('matplotlib'))"; then pictures=(); fi
python3 "$script" --program "$program" --output "$directory/out" --coarsest 4 --largest 5 --repetitions 2 \
  --scenes "two_ends no_contact" --linear-solvers amesos_klu --strategies nested --targets "" "${pictures[@]}" >stdout 2>stderr
check "exit code 0" [ $? -eq 0 ]
check "no complaints" [ ! -s stderr ]
# 2 scenes x 2 contact solvers x 1 linear solver x 2 levels, twice.
check "one row per configuration and level" [ "$(wc -l <out/benchmark.csv)" -eq 9 ]
check "one row per run and level" [ "$(wc -l <out/runs.csv)" -eq 17 ]
check "every configuration once" [ "$(tail -n +2 out/benchmark.csv | cut -d, -f1-3,5 | sort -u | wc -l)" -eq 8 ]
check "columns and fields agree" [ "$(awk -F, '{ print NF }' out/benchmark.csv | sort -u | wc -l)" -eq 1 ]
for stage in t_mesh t_setup t_assembly t_factor t_compliance t_postprocess t_total t_solution t_nested t_process; do
  check "$stage is positive" every_row "$stage" "v > 0"
done
check "nothing presses without contact" every_row active 'scene != "no_contact" || v == 0'
check "no dual problem without contact" every_row t_qp 'scene == "no_contact" ? v == 0 : v > 0'
check "errors where the solution is known" every_row u_h1 'scene == "no_contact" ? v == "" : v > 0'
check "medians of two runs" every_row repetitions "v == 2"
check "the median of two is their mean" \
  awk "BEGIN { d = $(sum out/runs.csv t_total) - 2 * $(sum out/benchmark.csv t_total); exit !(d * d < 1e-8) }"
check "the ratio of contact to no contact" [ "$(grep -c '^contact / no contact' out/summary.txt)" -eq 2 ]
check "memory of the levels but the first" [ "$(wc -l <out/memory.csv)" -eq 2 ]
check "versions" grep -q '^deal.II' out/environment.txt
if [ "${#pictures[@]}" -eq 0 ]; then
  for picture in error stages memory; do
    check "picture $picture" [ "$(stat -c %s "out/benchmark_$picture.png" 2>/dev/null || echo 0)" -gt 2000 ]
  done
fi
check "no times to an error" [ ! -e out/targets.csv ]

# Time to an error: 2 scenes, of which one has two ends of contact, x (2 levels and 2 targets).
python3 "$script" --program "$program" --output "$directory/out" --coarsest 4 --largest 5 --repetitions 1 --targets "1e-1 1e-3" \
  --ends "0.7071067811865475 0.3" --scenes "b1 block" --linear-solvers condensed --contact-solvers "active set" \
  "${pictures[@]}" >stdout 2>stderr
check "times to an error: exit code 0" [ $? -eq 0 ]
check "times to an error: no complaints" [ ! -s stderr ]
check "one row per scene, end and request" [ "$(wc -l <out/targets.csv)" -eq 13 ]
check "one row per run and request" [ "$(wc -l <out/target_runs.csv)" -eq 13 ]
check "the worst end only" [ "$(wc -l <out/targets_worst.csv)" -eq 9 ]
check "columns and fields agree in the times to an error" \
  [ "$(cat out/targets.csv out/targets_worst.csv out/target_runs.csv | awk -F, '{ print NF }' | sort -u | wc -l)" -eq 1 ]
for number in cpu dofs error t_assembly t_factor; do check "times to an error: $number" every_row "$number" "v > 0" targets.csv; done
# The seminorm is at most a third more than the energy norm, which is estimated, relative to that of u.
check "graded meshes reach the target" every_row error 'strategy == "nested" || v <= 1.5 * request' targets.csv
check "pi u_h of nested meshes is better" every_row error_post 'strategy == "hp" || v < 0.12' targets.csv
check "every scene reaches 1e-3 with graded meshes" [ "$(grep -c ' hp  *1e-3 ' out/targets.txt)" -eq 2 ]
if [ "${#pictures[@]}" -eq 0 ]; then
  check "picture targets" [ "$(stat -c %s out/benchmark_targets.png 2>/dev/null || echo 0)" -gt 2000 ]
fi

# Wrong options are refused with one sentence.
for options in "--largest x" "--largest 2 --coarsest 3" "--scenes nowhere" "--targets 2" "--strategies h" "--ends x" "--frobnicate 1" "--program nothing"; do
  # shellcheck disable=SC2086
  python3 "$script" --program "$program" $options --output "$directory/refused" >stdout 2>stderr
  check "refuses $options" [ "$? $(wc -l <stderr)" = "1 1" ]
done
check "and writes nothing" [ ! -e refused ]
[ "$failures" -eq 0 ]
