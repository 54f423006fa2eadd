# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of parameters as the program prints it, as a page."""
import re
import subprocess


def page(program):
    """Returns the page: a heading for each subsection, an entry with its default and its meaning for each parameter."""
    text = subprocess.run([program, "--print-parameters"], capture_output=True, text=True, check=True).stdout
    lines = ["# Parameters", "", "All entries with their defaults, as `signorini --print-parameters` prints them; "
             "[the manual](doc/manual.md) has examples.", "", "## Before all subsections", ""]
    help_text, depth = [], 0
    for line in text.splitlines()[2:]:
        line = line.strip()
        if line.startswith("#"):
            help_text.append(line[1:].strip())
        elif match := re.fullmatch(r"subsection (.*)", line):
            depth += 1
            lines += ["#" * (depth + 1) + " " + match[1], ""]
        elif line == "end":
            depth -= 1
        elif match := re.fullmatch(r"set (.*?)\s*=\s*(.*)", line):
            escaped = re.sub(r"([\\*_<>\[\]$`|])", r"\\\1", " ".join(help_text))
            lines += [f"`{match[1]}`" + (f" = `{match[2]}`" if match[2] else ""), f": {escaped}", ""]
            help_text = []
    return "\n".join(lines)
