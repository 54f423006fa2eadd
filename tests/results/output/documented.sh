#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Every file of a run, every column, key and field in it stands in doc/output.md: three runs, in one start.
# usage: documented.sh PROGRAM ROOT

program=$(realpath "$1")
document=$(realpath "$2")/doc/output.md
. "$(dirname "$0")/../../checks.bash"

# all_named WORDS...: each stands in backticks.
all_named() {
  printf '`%s`\n' "$@" | sort -u >words
  grep -oF -f words "$document" | sort -u | comm -23 words - >missing
  sed "s|^|not in $document: |" missing
  [ "$#" -gt 0 ] && is_empty missing
}
columns_of() { head -n 1 "$1" | sed 's/reaction_[a-z]*_/reaction_SIDE_/g' | tr ',' ' '; }
keys_of() { grep -o '"[a-z_]*":' "$1" | tr -d '":' | sort -u; }
# The points, the cells and their numbering belong to the format.
fields_of() { grep -o 'Name="[^"]*"' "$1" | sed 's/.*="//; s/"//' | grep -vx 'connectivity\|offsets\|types'; }
files_of() { ls "$1" | sed 's/-[0-9][0-9]\./-LL./' | sort -u; }

cat >run.prm <<'PRM'
subsection Scene
  set Name = A1
end
subsection Discretization
  set Coarsest level = 3
  set Finest level   = 3
end
subsection Output
  set Compliance = true
  set VTU        = all
end
subsection Solver
  set Tolerated error = 1e-9
end
PRM
cat >driven.prm <<'PRM'
subsection Boundary
  set Plates  = top: 0, -1 turning
  set Contact = bottom
end
subsection Load
  set Plate force = top: 0.05
end
subsection Contact
  set Gap = 0.5*(x-0.5)^2
end
subsection Load cases
  set Cases  = force 0.5 to 2 in 3 cases | force -1
  set Fields = 3
end
subsection Discretization
  set Finest level = 3
end
subsection Output
  set Compliance = true
end
subsection Solver
  set Tolerated error = 0.6
end
PRM
cat >hp.prm <<'PRM'
subsection Scene
  set Name = B1
end
subsection Discretization
  set Strategy       = hp
  set Coarsest level = 2
  set Finest level   = 7
  set Target error   = 0.001
end
subsection Output
  set Compliance = true
  set VTU        = all
end
PRM
"$program" run.prm driven.prm hp.prm --output . >stdout 2>stderr
check "three runs, one of which is not resolved" [ $? -eq 2 ]
ended() { grep -qx "$1\.prm: .*, exit code $2, \./$1" stdout; }

check "a run that is not resolved, which has every key" ended run 2
check "files" all_named $(files_of run)
check "columns of convergence.csv" all_named $(columns_of run/convergence.csv)
check "columns of contacts.csv" all_named $(columns_of run/contacts.csv)
check "columns of contact-03.csv" all_named $(columns_of run/contact-03.csv)
check "keys of certificate.json" all_named $(keys_of run/certificate.json)
check "  the reason among them" grep -q '"failure":' run/certificate.json
check "  the bound among them" grep -q '"place_of_penetration":' run/certificate.json
check "keys of answer.json" all_named $(keys_of run/answer.json)
check "fields of solution-03.vtu" all_named $(fields_of run/solution-03.vtu)
check "fields of contact-03.vtu" all_named $(fields_of run/contact-03.vtu)
check "the scene's formulas in parameters.prm" grep -q '^# Exact p   -10\*max(xi-x,0)^3' run/parameters.prm

# From the files alone, by the recipes of the document.
force=$(awk -F, 'NR > 1 && !seen[$10]++ { sum -= $5 * $11 } END { printf "%.12e", sum }' run/contact-03.csv)
peak=$(awk -F, 'NR > 1 && -$5 > peak { peak = -$5 } END { printf "%.12e", peak }' run/contact-03.csv)
column() { awk -F, -v name="$1" 'NR == 1 { for (c = 1; c <= NF; ++c) if ($c == name) k = c } END { printf "%.12e", $k }' run/convergence.csv; }
check "the contact force from contact-03.csv" [ "$force" = "$(column contact_force_n)" ]
check "the peak pressure from contact-03.csv" [ "$peak" = "$(column max_pressure)" ]
p=$(awk -F, 'NR > 1 && !seen[$10]++ { printf "%.12e ", $5 }' run/contact-03.csv)
check "P from contact-03.csv" [ "$p" = "$(tail -n +3 run/P-03.mtx | awk '{ printf "%.12e ", $1 }')" ]

# Bodies that move freely, and load cases.
check "a plate with load cases" ended driven 0
check "  files" all_named $(ls driven | sed 's/-[0-9][0-9]\./-LL./; s/-[0-9]\{6\}\./-NNNNNN./' | sort -u)
check "  columns" all_named $(columns_of driven/cases.csv)
check "  keys" all_named $(keys_of driven/certificate.json) $(keys_of driven/answer.json)
check "  forces in balance in every case" awk -F, 'NR > 1 && $NF == "solved" { n += ($9 - 0.05*$2)^2 + ($9 + $(NF-1))^2 < 1e-20 } END { exit n != 3 }' driven/cases.csv
check "  the last case lifts off" grep -q '^4,-1,.*,it lifts off$' driven/cases.csv

# Graded meshes write other files, fields and columns.
check "a run on graded meshes" ended hp 0
last=$(ls hp/solution-*.vtu | tail -n 1 | sed 's/.*solution-\(..\).*/\1/')
check "  with several steps" [ "$last" -ge 2 ]
check "  files" all_named $(files_of hp)
check "  columns" all_named $(columns_of hp/convergence.csv)
check "  keys" all_named $(keys_of hp/certificate.json) $(keys_of hp/answer.json)
check "  fields" all_named $(fields_of "hp/solution-$last.vtu") $(fields_of "hp/contact-$last.vtu")
check "  the degree among them" grep -q 'Name="degree"' "hp/solution-$last.vtu"
check "  P at the nodes from contact-$last.csv" [ "$(tail -n +3 "hp/P-$last.mtx" | wc -l)" -eq \
  "$(awk -F, 'NR > 1 { ++rows[$10] } END { for (t in rows) n += (rows[t] - 3) / 2; print n }' "hp/contact-$last.csv")" ]
# The displacement of another program.
"$program" run.prm --verify run/solution-03.vtu --set Output/Compliance=false --output verified >stdout 2>stderr
check "a displacement is verified" grep -q '^Verified ' stdout
check "  files" all_named $(files_of verified)
check "  keys" all_named $(keys_of verified/verified.json)
check "  fields" all_named $(fields_of verified/verified.vtu | grep -vx Points)
echo "$failures failures"
[ "$failures" -eq 0 ]
