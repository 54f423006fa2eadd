#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures tables of doc/measured anew, from runs of the program and its tests; doc/measured/README.md says what they are.

    python3 scripts/measure.py NAME...     writes doc/measured/NAME.csv (package python3-numpy)
    python3 scripts/measure.py             lists the names

The program is build/release/source/signorini, or SIGNORINI in the environment; tests (preset release-tests) stand beside it."""
import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "../python"))
import signorini
# Each of these registers its tables.
import tables.answers
import tables.cost
import tables.intervals
import tables.multigrid
import tables.orders
import tables.paper
import tables.pairs
from tables.common import ROOT, TABLES


def main():
    wrong = [name for name in sys.argv[1:] if name not in TABLES]
    if wrong or len(sys.argv) == 1:
        print(f"measure: {'found ' + repr(wrong[0]) + ', ' if wrong else ''}allowed: {', '.join(TABLES)}", file=sys.stderr)
        return 1
    for name in sys.argv[1:]:
        columns, make = TABLES[name]
        try:
            rows = list(make())
        except (signorini.Refused, OSError) as error:
            print(f"measure: {name}: {error}", file=sys.stderr)
            return 1
        with open(f"{ROOT}/doc/measured/{name}.csv", "w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([columns, *rows])
        print(f"{name}: {len(rows)} rows", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
