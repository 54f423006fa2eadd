#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes a page of luo_liang.cc like those of deal.II's tutorial: comments become text with set formulas, between them
stands the code. The figures are made by the program.

usage: page.py PROGRAM FOLDER     writes FOLDER/index.html
"""
import html
import pathlib
import re
import subprocess
import sys

GREEK = {"Omega": "Ω", "Gamma": "Γ", "alpha": "α", "beta": "β", "delta": "δ", "eps": "ε", "epsilon": "ε", "lambda": "λ",
         "mu": "μ", "omega": "ω", "phi": "φ", "pi": "π", "rho": "ρ", "sigma": "σ", "tau": "τ", "xi": "ξ"}
SIGNS = {"<=": "≤", ">=": "≥", "->": "→", "|||": "⦀", "||": "‖", "-": "−", "*": "·", "~": "≈", "'": "′", "<": "&lt;",
         ">": "&gt;", "&": "&amp;"}
OPERATORS = ("diag", "div", "grad", "int", "ln", "max", "min", "sqrt", "sum", "tr")
TOKEN = re.compile(r"\|\|\||\|\||<=|>=|->|\.\.\.|[A-Za-z]+|\d+(?:\.\d+)?(?:e-?\d+)?|\s+|.")
KEYWORDS = ("auto bool break case catch class const constexpr continue double else explicit false for if int namespace new "
            "override private public return static struct template true try typename unsigned using void while").split()
STYLE = """
body { max-width: 60em; margin: 2em auto; padding: 0 1em; font-family: sans-serif; line-height: 1.45 }
pre { background: #f4f6f8; border: 1px solid #d0d7de; padding: .7em; overflow-x: auto; line-height: 1.3 }
.m, .m td { font-family: "STIX Two Math", "Cambria Math", "Latin Modern Math", "DejaVu Serif", serif }
table.m { margin: .6em 0 .6em 2em } table.m td { padding: .1em 1.2em .1em 0; white-space: nowrap }
sub, sup { line-height: 0 } figure { margin: 1.5em 0; text-align: center } figure img { max-width: 100%; max-height: 30em }
.c { color: #57606a } .k { color: #8250df } .s { color: #0a6b2d }
"""


def group(tokens, i):
    """Returns the index and the end of an index of a name: {...}, or one token."""
    if tokens[i] != "{":
        return tokens[i:i + 1], i + 1
    end = next(k for k in range(i, len(tokens)) if tokens[k] == "}")
    return tokens[i + 1:end], end + 1


def formula(text):
    """Sets a formula: names in italics, words upright, x_k and x^k as indices, int and sum as signs."""
    tokens, result, i = TOKEN.findall(text), "", 0
    while i < len(tokens):
        token, i = tokens[i], i + 1
        if token in "_^" and i < len(tokens):
            inside, i = group(tokens, i)
            level = "sub" if token == "_" else "sup"
            inside = formula("".join(inside))
            if len(re.sub("<[^>]*>", "", inside)) > 1 and inside.isalpha():
                inside = f"<i>{inside}</i>"
            result += f"<{level}>{inside}</{level}>"
        elif token in ("int", "sum") and (token == "int" or tokens[i:i + 1] == ["_"]):
            result += {"int": "∫", "sum": "∑"}[token]
        elif token == "~" and result.endswith("</i>"):
            result += "\u0303"
        elif token in GREEK:
            result += GREEK[token]
        elif len(token) == 1 and token.isalpha():
            result += f"<i>{token}</i>"
        else:
            result += SIGNS.get(token, token)
    return result


def is_formula(word, begins_sentence):
    """Whether a word of a sentence is a formula: an index, a Greek name, or single letters only."""
    names = [name for name in re.findall("[A-Za-z]+", word) if name not in GREEK and name not in OPERATORS]
    if not re.search("[-A-Za-z<>=|]", word) or word in ("a", "a,", "I") or (begins_sentence and word == "A"):
        return False
    if any(len(name) > 2 for name in re.findall("([A-Za-z]+)_", word) if name in names):
        return False  # a name of the code
    return bool(re.search(r"[A-Za-z|)][_^]", word)) or all(len(name) == 1 for name in names)


def sentence(text):
    """Sets the words of a text; `code` and *emphasis* are marked."""
    result, before = [], "."
    for part in re.split(r"(`[^`]*`)", text):
        if part.startswith("`"):
            result.append(f"<code>{html.escape(part[1:-1])}</code>")
            continue
        for word in re.findall(r"\s+|(?:\{[^}]*\}|\S)+", part):
            set_word = f'<span class="m">{formula(word)}</span>' if is_formula(word, before.endswith(".")) else html.escape(word)
            result.append(set_word)
            before = word if word.strip() else before
    return re.sub(r"\*([^*<>]+)\*", r"<em>\1</em>", "".join(result))


def block(lines):
    """Sets indented lines: a listing, a quotation, or formulas in columns."""
    if any(re.match(r"\s*(set |stage |luo_liang |\d+  |level )", line) for line in lines):
        return "<pre>" + html.escape("\n".join(lines)) + "</pre>"
    if not any(re.search("[=<>^_]", line) for line in lines):
        return "<blockquote>" + html.escape(" ".join(line.strip() for line in lines)) + "</blockquote>"
    rows = ("".join(f"<td>{formula(cell)}</td>" for cell in re.split(r"\s{2,}", line.strip())) for line in lines)
    return '<table class="m">' + "".join(f"<tr>{row}</tr>" for row in rows) + "</table>"


def is_table(lines):
    return sum(bool(re.fullmatch(r"\s*[\d/]+(\s+[-+.\de]+)+\s*", line)) for line in lines) > 1


def paragraph(lines):
    """Sets the lines of a comment between two empty ones."""
    figure = re.fullmatch(r"@figure\{(.*?)\}\{(.*)\}", " ".join(lines))
    if figure:
        return f'<figure><img src="{figure[1]}" alt=""><figcaption>{sentence(figure[2])}</figcaption></figure>'
    if is_table(lines):
        return "<pre>" + html.escape("\n".join(lines)) + "</pre>"
    result, i = "", 0
    while i < len(lines):
        first, kind = i, "*" if lines[i].startswith("* ") else " " if lines[i].startswith("  ") else "p"
        i += 1
        while i < len(lines) and not lines[i].startswith("* ") and (kind == "*" or lines[i].startswith("  ") == (kind == " ")):
            i += 1
        text = sentence(" ".join(line.strip("* ") if kind == "*" else line for line in lines[first:i]))
        result += block(lines[first:i]) if kind == " " else f"<li>{text}</li>" if kind == "*" else f"<p>{text}</p>"
    return result


def code(lines):
    """Sets code, with marks for comments, texts and keywords."""
    def mark(match):
        kind = "c" if match[0].startswith("//") else "s" if match[0][0] in "\"'" else "k"
        return match[0] if kind == "k" and match[0] not in KEYWORDS else f'<span class="{kind}">{match[0]}</span>'
    text = html.escape("\n".join(lines).strip("\n"), quote=False)
    return "<pre>" + re.sub(r"//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|\b[a-z]+\b", mark, text) + "</pre>" if text else ""


def page(source):
    """Returns the page of a source: its comments at the start of lines are text."""
    body, contents, text, listing = [], [], [], []

    def end_text():
        if text:
            body.append(paragraph(text))
            text.clear()
    for line in source.splitlines()[1:] + ["//"]:
        if not line.startswith("//"):
            end_text()
            listing.append(line)
            continue
        body.append(code(listing))
        listing.clear()
        line = line[3:].rstrip()
        heading = re.fullmatch(r"@sect(\d)\{(.*)\}", line)
        if heading:
            end_text()
            name = f"section-{len(contents)}"
            contents.append(f'<li style="margin-left: {int(heading[1]) - 1}em"><a href="#{name}">{sentence(heading[2])}</a></li>')
            body.append(f'<h{heading[1]} id="{name}">{sentence(heading[2])}</h{heading[1]}>')
        elif line:
            text.append(line)
        else:
            end_text()
    return ("<!DOCTYPE html><html lang='en'><head><meta charset='utf-8'><title>luo_liang</title><style>" + STYLE +
            "</style></head><body>" + "\n".join(body).replace("</h1>", "</h1><ul>" + "".join(contents[1:]) + "</ul>", 1) +
            "</body></html>\n")


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "figures.prm").write_text("set Write figures = true\n")
    subprocess.run([program, "figures.prm"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    source = pathlib.Path(__file__).with_name("luo_liang.cc").read_text(encoding="utf-8")
    (folder / "index.html").write_text(page(source), encoding="utf-8")


if __name__ == "__main__":
    main()
