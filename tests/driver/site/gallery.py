# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scenes of the gallery exist, their heads say what to expect in the form that can be read, and the cheapest of them have
these numbers. Neither Sphinx nor matplotlib is needed.

usage: gallery.py PROGRAM ROOT
"""
import importlib.machinery
import importlib.util
import pathlib
import re
import subprocess
import sys

PROGRAM, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
CHEAP = ["bodies/press_fit", "revolution/thick_cylinder", "revolution/cone_seal"]
sys.dont_write_bytecode = True
loader = importlib.machinery.SourceFileLoader("gallery", str(ROOT / "scripts/gallery"))
gallery = importlib.util.module_from_spec(importlib.util.spec_from_loader("gallery", loader))
loader.exec_module(gallery)
failures = 0


def check(name, holds):
    global failures
    print("PASS" if holds else "FAIL", name)
    failures += not holds


def refusal(line, answer=None):
    """Returns what is said against an expectation, or against an answer."""
    try:
        one = gallery.Expectation(line, "x.prm")
        if answer is not None:
            one.check(answer, "x.prm")
    except gallery.Failure as failure:
        return str(failure)
    return ""


def start(*arguments):
    return subprocess.run([sys.executable, ROOT / "scripts/gallery", *arguments], capture_output=True, text=True, check=False)


done = start("--check")
check("all scenes exist and expect numbers " + done.stderr.strip(), done.returncode == 0)
lines = [line for path in ROOT.glob("prm/**/*.prm")
         for line in re.findall(r"^# (Expect \S+ = .*\+-.*)$", path.read_text(encoding="utf-8"), re.MULTILINE)]
check(f"{len(lines)} expectations of all scenes can be read", len(lines) > 80 and not any(map(refusal, lines)))

done = start(PROGRAM, "pages", "--only", *CHEAP, "--without-pictures")
check("the cheapest scenes have the numbers that they expect " + done.stderr.strip(), done.returncode == 0)
pages = [pathlib.Path("pages", f"{name}.md") for name in CHEAP]
check("each has a page with its numbers", all("| computed | expected |" in page.read_text(encoding="utf-8") for page in pages))

answer = {"force": [0., 2.], "zones": [{"length": 0.5}]}
check("a value within its tolerance", refusal("Expect force = (0, 2.001) +- 0.1 % (a source)", answer) == "")
check("a value outside", "found (0, 2)" in refusal("Expect force = (0, 2.003) +- 0.1 %", answer))
check("a number of a list", refusal("Expect zones.0.length = 0.5 +- 1e-9", answer) == "")
check("a key that is not there", "correct the key" in refusal("Expect zones.1.length = 0.5 +- 1e-9", answer))
check("a vector in place of a number", "found [0.0, 2.0]" in refusal("Expect force = 2 +- 0.1", answer))
check("a tolerance as large as the value", "tolerance" in refusal("Expect force = 2 +- 2"))
check("no tolerance", "write 'Expect" in refusal("Expect force = 2"))
sys.exit(failures > 0)
