# SPDX-License-Identifier: LGPL-2.1-or-later
"""Setting the formulas of the documents loses no word, no code and no link, and what is set is as expected.

usage: formulas.py PROGRAM ROOT
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[2]).resolve()
sys.dont_write_bytecode = True
sys.path[:0] = [str(ROOT / "doc/site")]
from set_formulas import sentence, set_page, tex

failures = 0


def check(name, holds):
    global failures
    if not holds:
        print("FAIL", name)
        failures += 1


FORMULAS = {"|||v||| = a(v, v)^{1/2}": r"|\!|\!|v|\!|\!| = a(v, v)^{1/2}", "u_h": "u_{h}", "A⁻¹": "A^{-1}", "½ UᵀAU": r"\tfrac12  U^{T}AU",
            "Γ_c^-": r"\Gamma _{c}^{-}", "ũ − π^{2h}u": r"\tilde{u} - \pi ^{2h}u", "p* = πE*": r"p^* = \pi E^*", "for all v": r"\text{ for all } v",
            "Σ_{i≥0} q_ij²": r"\sum _{i\ge 0} q_{ij}^{2}"}
for text, expected in FORMULAS.items():
    check(f"{text} is {expected}, found {tex(text)}", tex(text) == expected)
SENTENCES = {"for v in V, and ‖u − v‖ ≤ c h on a side.": r"for $v$ in $V$, and $\|u - v\| \le  c h$ on a side.",
             "a file of 10 s, A scene": "a file of 10 s, A scene", "(s ≥ 0 given)": r"($s \ge  0$ given)",
             "- On a plane, in 3-D": "- On a plane, in 3-D", "D_t,jτ = 0": r"$D_{t,j\tau} = 0$",
             "P. Luo and G.-P. Liang": "P. Luo and G.-P. Liang", "V-cycles and `u_h` with 2 T": "V-cycles and `u_h` with $2 T$"}
for text, expected in SENTENCES.items():
    check(f"{text} is {expected}, found {set_page(text)}", set_page(text) == expected)


def words(text):
    """Returns what must stay: words of four letters and more, in their order."""
    text = re.sub(r"\\(begin|end)\{array\}(\{l+\})?|\\[A-Za-z]+", " ", text)
    return re.findall(r"[A-Za-z]{4,}", text)


def kept(text):
    """Returns code and the targets of links."""
    return re.findall(r"`[^`\n]+`|\]\([^)]*\)", text)


pages = sorted(ROOT.glob("doc/*.md"))
check("there are documents", len(pages) > 10)
n_formulas = 0
for page in pages:
    text = page.read_text(encoding="utf-8")
    done = set_page(text)
    check(f"{page.name} keeps its words", words(text) == words(done))
    check(f"{page.name} keeps its code and links", kept(text) == kept(done))
    without_code = re.sub(r"```.*?```|`[^`]*`|^    .*$", "", done, flags=re.DOTALL | re.MULTILINE)
    formulas = re.findall(r"\$\$(.*?)\$\$|\$([^$]*)\$", without_code, re.DOTALL)
    n_formulas += len(formulas)
    check(f"{page.name} has pairs of dollars", without_code.count("$") == sum(4 if one else 2 for one, _ in formulas))
    for one in formulas:
        inside = re.sub(r"\\[{}]", "", one[0] or one[1])
        check(f"{page.name}: the braces of {inside} are balanced", inside.count("{") == inside.count("}") and inside.strip())
print(f"{len(pages)} documents, {n_formulas} formulas, {failures} failures")
sys.exit(failures > 0 or n_formulas < 1000)
