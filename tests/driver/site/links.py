# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every link of the documents and of the site's own pages leads to a file that exists, and to a heading of it.

usage: links.py PROGRAM ROOT
"""
import importlib.machinery
import importlib.util
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[2]).resolve()
sys.dont_write_bytecode = True
loader = importlib.machinery.SourceFileLoader("gallery", str(ROOT / "scripts/gallery"))
gallery = importlib.util.module_from_spec(importlib.util.spec_from_loader("gallery", loader))
loader.exec_module(gallery)
LINK = re.compile(r"\]\(([^)\s]+)\)|src=\"([^\"]+)\"")
# Pages that the build of the site makes: no file has them.
MADE = {"gallery/index.md", "tour.md", "parameters.md", "python/index.md", "luo_liang.md", "index.md",
        *(f"gallery/{name}.md" for names in gallery.SCENES.values() for name in names),
        *(f"gallery/{name}-{picture}.png" for names in gallery.SCENES.values() for name in names
          for picture in ("deformed", "pressure"))}


def anchors(path):
    """Returns the anchors of the headings of a page, as code hosts make them."""
    result, text = set(), re.sub(r"```.*?```", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
    for heading in re.findall(r"^#+ (.*)$", text, re.MULTILINE):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").lower()
        name = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        result.add(next(one for one in (name, *(f"{name}-{i}" for i in range(1, 99))) if one not in result))
    return result


def broken(page):
    """Yields the links of a page that lead nowhere."""
    is_site = page.parent == ROOT / "doc/site"
    for match in LINK.finditer(re.sub(r"`[^`\n]*`", "", page.read_text(encoding="utf-8"))):
        link = match[1] or match[2]
        target, _, anchor = link.partition("#")
        if re.match("[a-z]+:", link):
            continue
        path = ((ROOT if is_site else page.parent) / target).resolve() if target else page
        if is_site and target in MADE:
            path = ROOT / "README.md"
            anchor = anchor if target == "index.md" else ""
        if not path.exists() or (anchor and path.suffix == ".md" and anchor not in anchors(path)):
            yield link


pages = [*ROOT.glob("doc/*.md"), *ROOT.glob("doc/site/*.md"), ROOT / "doc/measured/README.md", ROOT / "README.md", ROOT / "CONTRIBUTING.md",
         *ROOT.glob("source/*/README.md")]
failures = [f"{page.relative_to(ROOT)}: {link}" for page in sorted(pages) for link in broken(page)]
for failure in failures:
    print(f"FAIL the link {failure} leads nowhere")
print(f"{len(pages)} pages, {len(failures)} broken links")
sys.exit(bool(failures) or len(pages) < 15)
