# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sets the formulas of Markdown pages, which are plain text in the sources: as TeX between dollars, for MathJax.

Indented lines with signs of formulas become displays. In sentences a word is part of a formula if it has indices, signs or
Greek letters, or single letters only; neighbours with signs between them are one formula.
"""
import re
import unicodedata

GREEK = dict(zip("αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΦΨΩ", (
    "alpha beta gamma delta varepsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon varphi chi psi omega "
    "Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega").split()))
SIGNS = {"−": r"-", "·": r"\cdot ", "≤": r"\le ", "≥": r"\ge ", "∫": r"\int ", "⟺": r"\iff ", "←": r"\leftarrow ",
         "→": r"\to ", "∓": r"\mp ", "⟨": r"\langle ", "⟩": r"\rangle ", "∖": r"\setminus ", "∪": r"\cup ", "∩": r"\cap ",
         "∈": r"\in ", "∇": r"\nabla ", "∂": r"\partial ", "∞": r"\infty ", "½": r"\tfrac12 ", "¼": r"\tfrac14 ",
         "¾": r"\tfrac34 ", "×": r"\times ", "±": r"\pm ", "≈": r"\approx ", "≠": r"\ne ", "⊂": r"\subset ", "ℓ": r"\ell ",
         "∎": r"\blacksquare ", "√": r"\surd ", "‖": r"\|", "|||": r"|\!|\!|", "|": r"|", "*": r"^*", "{": r"\{",
         "}": r"\}", "%": r"\%", "&": r"\&", "#": r"\#", "_": r"\_", "^": r"\hat{}", "...": r"\ldots ", "…": r"\ldots ",
         "<": r"\lt ", ">": r"\gt ", "⊗": r"\otimes ", "∑": r"\sum ", "⊥": r"\perp ", "°": r"^\circ ", "∘": r"\circ "}
RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ᵀⁿᵏ", "0123456789+-Tnk"))
LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉₊₋ₙₕᵢⱼₖₘₚₜₓ", "0123456789+-nhijkmptx"))
ACCENTS = {"\u0303": "tilde", "\u0304": "bar", "\u0302": "hat", "\u0305": "bar"}
OPERATORS = "arctan cond cos diag div exp ln log max min osc sign sin sup tan tr dim Re Im".split()
DIFFERENTIALS = ("dx", "ds", "dt", "dy", "dr")
INDEX = r"(?:[A-Za-zα-ωΑ-Ωℓ0-9\u0300-\u036f']+(?:,[A-Za-zα-ω]+(?![\w^(α-ω]))?|[*+−-])"
TOKEN = re.compile(r"[A-Za-zα-ω][\u0300-\u036f]|\|\|\||\.\.\.|[_^](?:\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}|" + INDEX + r")|"
                   r"[⁰¹²³⁴-⁹⁺⁻ᵀⁿᵏ]+|[₀-₉₊₋ₙₕᵢⱼₖₘₚₜₓ]+|[A-Za-z]+|\d+(?:[.,]\d+)*(?:e[-−]?\d+)?|\s+|.", re.DOTALL)
LETTER = "A-Za-zα-ωΓΔΘΛΞΠΣΦΨΩℓ"


def decomposed(text):
    """Returns a text with accents behind their letters."""
    return unicodedata.normalize("NFD", text).replace("≠", "≠")


def index(text):
    """Returns the text behind _ or ^."""
    inside = text[1:-1] if text.startswith("{") else text
    return "{" + tex(inside, words=False) + "}"


def tex(text, words=True):
    """Returns the TeX of a formula in plain text: x_k, x^{k}, ², ∫, ‖v‖; words stay words."""
    result, last = "", ""
    for token in TOKEN.findall(decomposed(text)):
        if token[0] in "_^" and len(token) > 1:
            # A dash after a name that is raised already (w'_n, A⁻¹_22) needs a group of its own.
            both = "_" in last + token[0] and "^" in last + token[0]
            result = (result if not last or both else result + "{}") + token[0] + index(token[1:])
            last = last + token[0] if both else token[0]
            continue
        if token[0] in RAISED or token[0] in LOWERED:
            sign = "^" if token[0] in RAISED else "_"
            result = (result if not last or sign not in last else result + "{}") + sign + "{" + "".join(
                {**RAISED, **LOWERED}[letter] for letter in token) + "}"
            last += sign
            continue
        last = ""
        if token in GREEK:
            result += {"Σ": r"\sum "}.get(token, f"\\{GREEK[token]} ")
        elif len(token) == 2 and token[1] in ACCENTS:
            result += f"\\{ACCENTS[token[1]]}{{{tex(token[0])}}}"
        elif token == "~" and result and result[-1].isspace():
            head, name = re.fullmatch(r"(.*?)(\\?[A-Za-z]+\s)", result, re.DOTALL).groups()
            result = f"{head}\\tilde{{{name.strip()}}}"
        elif token.isspace():
            result += r"\quad " if len(token) > 1 else " "
        elif token in OPERATORS:
            result += f"\\operatorname{{{token}}}"
        elif token in DIFFERENTIALS:
            result += f"\\,{token} "
        elif words and token.isalpha() and len(token) > 1 and (token.islower() or (token[1:].islower() and len(token) > 3)):
            result += f"\\text{{ {token} }}"
        elif token in SIGNS:
            result += SIGNS[token]
        else:
            result += token
    return re.sub(r" \} +\\text\{ ", " ", result).strip()


def display(lines):
    """Returns the display of lines of formulas: columns are separated by two blanks, a number in brackets stands before a line."""
    width = min(len(line) - len(line.lstrip()) for line in lines)
    lines = [line[width:].rstrip() for line in lines]
    rows = [re.split(r" {2,}", line) for line in lines]
    if len(rows) == 1:
        return ["$$", r"\quad ".join(tex(cell) for cell in rows[0]), "$$"]
    body = " \\\\\n".join(" & ".join(tex(cell) for cell in row) for row in rows)
    return ["$$", "\\begin{array}{" + "l" * max(map(len, rows)) + "}", body, "\\end{array}", "$$"]


def is_display(lines):
    """Whether indented lines are formulas, and no commands, parameters or listings."""
    text = "\n".join(lines)
    return bool(re.search(r"[∫‖≤≥⟺Σσκπᵀ²]|\b[A-Za-z]+_[{A-Za-z]", text)) and not re.search(
        r"^\s*(set |subsection|end$|signorini|build/|bash|cmake|python3|#)", text, re.MULTILINE) and "`" not in text


SIGN = re.compile(r"[=<>+−·:≤≥×±≈/∈⊂∖∪∩→⟺≠|‖-]+")
NUMBER = re.compile(r"[+−-]?\d+(?:[.,]\d+)*(?:e[-−]?\d+)?|½")
OF_FORMULA = re.compile(f"[∫‖≤≥Σ⟺∇∂∞½√²³⁻ᵀ₀-₉ₙ]|[α-ωΓΔΘΛΞΠΦΨΩ]|[{LETTER}\u0300-\u036f)|‖][_^]|[{LETTER}][\u0300-\u036f]")


def is_formula(word):
    """Whether a word of a sentence, without the signs around it, is a formula by itself."""
    word = decomposed(word)
    names = re.findall(r"[A-Za-z]+", re.sub(r"[_^]\{[^}]*\}|[_^][A-Za-z0-9]+", " ", word))
    names = [name for name in names if name not in OPERATORS and name not in DIFFERENTIALS]
    if any(len(name) > 2 or (len(name) == 2 and not OF_FORMULA.search(word)) for name in names):
        return False
    if re.search(r"[A-Za-z]{3,}_|[\"“”;—–]|://|mm|Pa", word):
        return False
    return bool(OF_FORMULA.search(word)) or (
        len(names) > 0 and all(len(name) == 1 for name in names) and word not in ("a", "A", "I")
        and not re.search(r"[A-Z]\.|[A-Z]\d|\d[A-Za-z]|\w[-.][A-Za-z]", word))


def peel(run):
    """Splits a run into what stands before the formula, the formula, and what stands behind: punctuation, brackets without
    their partners."""
    before, after = "", ""
    for opening, closing in ("()", "[]", "{}"):
        while run.startswith(opening) and run.count(opening) > run.count(closing):
            before, run = before + opening, run[1:]
    while run and (run[-1] in ".,;:!?" or any(run.endswith(closing) and run.count(closing) > run.count(opening)
                                              for opening, closing in ("()", "[]"))):
        run, after = run[:-1], run[-1] + after
    # A whole formula in brackets keeps them as text if they belong to the sentence.
    return before, run, after


def balanced(text):
    return all(text.count(a) == text.count(b) for a, b in ("()", "[]", "{}"))


def kinds_of(words):
    """Returns of which kind words of a sentence are: part of a "formula", a "sign" between two, a "number", or a "word"."""
    kinds = []
    for word in words:
        core = peel(word)[1]
        kinds.append("sign" if SIGN.fullmatch(word) and word != "-" else "number" if NUMBER.fullmatch(core or "") else
                     "formula" if core and is_formula(core) else "word")
    for i, word in enumerate(words):
        if kinds[i] == "word" and re.fullmatch(r"[A-Z][A-Za-z]?", peel(word)[1] or "") and "sign" in kinds[max(i - 1, 0):i + 2]:
            kinds[i] = "formula"
        elif kinds[i] == "formula" and re.fullmatch(r"\(?[A-Z]\.", word) and re.match("[A-Za-z]", "".join(words[i + 1:i + 2])):
            kinds[i] = "word"  # the initial of a name
        elif kinds[i] == "formula" and i > 0 and kinds[i - 1] == "number" and re.fullmatch(r"[smN]\W*", word) and (
                kinds[i + 1:i + 2] != ["formula"]):
            kinds[i] = "word"  # a unit
    return kinds


def end_of_run(words, kinds, i):
    """Returns the last word of the formula that begins with a word: punctuation ends it, and brackets that close without
    having been opened."""
    j = i
    while True:
        text = " ".join(words[i:j + 1])
        depth = sum(text.count(a) - text.count(b) for a, b in ("()", "[]"))
        if depth < 0 or (depth == 0 and words[j][-1:] in ".,;:!?" and kinds[j] != "sign"):
            break
        following = kinds[j + 1:j + 3]
        if following[:1] == ["formula"]:
            j += 1
        elif following[:1] == ["sign"] and following[1:] in (["formula"], ["number"]):
            j += 2
        else:
            break
    while j > i and not balanced(peel(" ".join(words[i:j + 1]))[1]):
        j -= 1
    while j > i and kinds[j] == "sign":
        j -= 1
    return j


def sentence(text):
    """Sets the formulas of a piece of text without code and links."""
    parts = re.split(r"(\s+)", text)
    words, blanks = parts[::2], parts[1::2] + [""]
    kinds, result, i = kinds_of(words), [], 0
    while i < len(words):
        j = i
        if kinds[i] == "formula" or (kinds[i] == "number" and kinds[i + 1:i + 2] in (["formula"], ["sign"])):
            j = end_of_run(words, kinds, i)
        before, formula, after = peel(" ".join(words[i:j + 1]))
        if formula and "formula" in kinds[i:j + 1] and is_set(formula):
            result.append(f"{before}${tex(formula)}${after}{blanks[j]}")
        else:
            result.append("".join(words[k] + blanks[k] for k in range(i, j + 1)))
        i = j + 1
    return "".join(result)


def is_set(formula):
    """Whether a run is a formula and no number or mark of Markdown."""
    return not NUMBER.fullmatch(formula) and balanced(formula) and "**" not in formula and not re.match(r"\*|.*[^A-Zp]\*$", formula)


KEPT = re.compile(r"(`+[^`]*`+|!?\[[^\]]*\]\([^)]*\)|<[^>\s][^>]*>|\$[^$]*\$|\*\*|(?<![A-Zp\w])\*(?=\w)|(?<=\w)\*(?!\w))")


def set_page(text):
    """Returns a Markdown page with its formulas set."""
    result, paragraph = [], []

    def end():
        if paragraph:
            pieces = KEPT.split("\n".join(paragraph))
            result.append("".join(piece if k % 2 else sentence(piece) for k, piece in enumerate(pieces)))
            paragraph.clear()
    lines, i = text.split("\n"), 0
    while i < len(lines):
        line = lines[i]
        if line.startswith("```"):
            end()
            stop = next((k for k in range(i + 1, len(lines)) if lines[k].startswith("```")), len(lines) - 1)
            result.append("\n".join(lines[i:stop + 1]))
            i = stop + 1
            continue
        indent = len(line) - len(line.lstrip())
        if indent >= 4 and line.strip() and not paragraph and (not result or result[-1] == ""):
            stop = i
            while "".join(lines[stop:stop + 1]).startswith("    ") or (
                    lines[stop:stop + 1] == [""] and "".join(lines[stop + 1:stop + 2]).startswith("    ")):
                stop += 1
            block = lines[i:stop]
            if is_display([one for one in block if one.strip()]):
                # In an item of a list the display belongs to the item.
                inside = " " * (indent - 4)
                result += [inside + one for part in "\n".join(block).split("\n\n") for one in display(part.split("\n"))]
            else:
                result.append("\n".join(block))
            i = stop
            continue
        if not line.strip() or line.startswith(("#", "|")):
            end()
            result.append(line)
        elif re.match(r"\s*([-*]|\d+\.)\s", line):
            end()
            paragraph.append(line)
        else:
            paragraph.append(line)
        i += 1
    end()
    return "\n".join(result)
