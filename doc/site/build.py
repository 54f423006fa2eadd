#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the site: pages of the documents, of scenes that are run, of tables, parameters and examples.

usage: build.py PROGRAM FOLDER [--tutorial LUO_LIANG] [--reference FOLDER]

writes FOLDER/html/index.html. The documents stay where they are: they are copied into FOLDER/pages, where formulas are set and
links lead to pages or to copies of files. A link that leads nowhere, and a number of a scene that its file does not expect,
stop the build.
"""
import argparse
import importlib.machinery
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE)]
import examples
import parameters
import plots
from set_formulas import set_page

DOCUMENTS = [*sorted((ROOT / "doc").glob("*.md")), ROOT / "doc/measured/README.md", ROOT / "README.md", ROOT / "CHANGELOG.md",
             ROOT / "CONTRIBUTING.md"]
WITHOUT_FORMULAS = [ROOT / f"{name}.md" for name in ("README", "CHANGELOG", "CONTRIBUTING", "doc/map", "doc/design", "doc/manual",
                                                     "doc/recipes")]
MATHJAX = pathlib.Path("/usr/share/javascript/mathjax")
# What one output of MathJax needs: 54 MB are others.
OF_MATHJAX = ["MathJax.js", "config/TeX-AMS_CHTML.js", "jax/element", "jax/input/TeX", "jax/output/CommonHTML", "extensions",
              "fonts/HTML-CSS/TeX/woff"]
# What stands for a file or a folder that is no page by itself.
PAGES = {"README.md": "index.md", "source/luo_liang/luo_liang.cc": "luo_liang.md", "source/luo_liang": "luo_liang.md",
         "python/examples": "python/index.md", "prm": "gallery/index.md"}
LINK = re.compile(r"(\]\()([^)\s]+)(\))")


def linked(text, page, pages, scenes):
    """Returns a document with the links of the site: those to scenes lead to their pages in the gallery, those to files to
    copies, those to folders become text."""
    def to(target, anchor=""):
        return f"]({os.path.relpath(pages / target, (pages / page.relative_to(ROOT)).parent)}{'#' + anchor if anchor else ''})"

    def link(match):
        target, _, anchor = match[2].partition("#")
        if not target or re.match(r"[a-z]+:", target):
            return match[0]
        path = (page.parent / target).resolve()
        name = path.relative_to(ROOT).as_posix()
        if name in PAGES or name in scenes:
            return to(PAGES.get(name) or scenes[name], anchor)
        if path.is_file():
            if path.suffix != ".md":
                copy(path, pages / name)
            return match[0]
        if path.is_dir():
            if path / "README.md" in DOCUMENTS:
                return to(f"{name}/README.md")
            return to("gallery/index.md") if name.startswith("prm/") else "](@)"
        if page.name == "CHANGELOG.md":  # of a file that an older version had
            return "](@)"
        raise SystemExit(f"site: {page.relative_to(ROOT)} links to '{match[2]}', which does not exist: correct the link.")
    return re.sub(r"\[([^\]]*)\]\(@\)", r"\1", LINK.sub(link, text))


def copy(path, target):
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(path, target)


def copy_documents(pages, scenes):
    """Copies documents and pictures; formulas of the theory are set, pictures of raw HTML become those of Sphinx."""
    shutil.copytree(ROOT / "doc/pictures", pages / "doc/pictures", dirs_exist_ok=True)
    for page in DOCUMENTS:
        text = linked(page.read_text(encoding="utf-8"), page, pages, scenes)
        text = re.sub(r"<img[^>]*>", lambda tag: " ".join(tag[0].split()), text)
        if page not in WITHOUT_FORMULAS:
            text = set_page(text)
        if page == ROOT / "doc/measured/README.md":
            text = plots.linked(text, ROOT / "doc/measured", pages / "doc/measured")
        target = pages / page.relative_to(ROOT)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    # The README is the start page; the site's own links stand below its title.
    title, text = (pages / "README.md").read_text(encoding="utf-8").split("\n", 1)
    (pages / "README.md").unlink()
    (pages / "index.md").write_text(f"{title}\n\n{(HERE / 'index.md').read_text(encoding='utf-8')}{text}", encoding="utf-8")
    copy(HERE / "tour.md", pages / "tour.md")


def make_tour(program, pages, cache):
    """Writes the input and the output of the tour, from the run of the gallery."""
    loader = importlib.machinery.SourceFileLoader("gallery", str(ROOT / "scripts/gallery"))
    gallery = importlib.util.module_from_spec(importlib.util.spec_from_loader("gallery", loader))
    loader.exec_module(gallery)
    scene = gallery.Scene("block_on_parabola")
    _, record = scene.run(program, cache, program.read_bytes())
    (pages / "tour").mkdir()
    (pages / "tour/input.txt").write_text(scene.input + "\n", encoding="utf-8")
    (pages / "tour/output.txt").write_text(record["output"].strip("\n") + "\n", encoding="utf-8")


def make_tutorial(program, pages):
    """Makes the page of luo_liang.cc: the text of page.py inside a page of the site."""
    folder = pages / "luo_liang"
    subprocess.run([sys.executable, ROOT / "source/luo_liang/page.py", program, folder], check=True)
    text = (folder / "index.html").read_text(encoding="utf-8")
    title, body = re.search(r"<h1[^>]*>(.*?)</h1>(.*)</body>", text, re.DOTALL).groups()
    body = body.replace('src="', 'src="luo_liang/').replace("\n\n", "\n&#10;")
    title = re.sub("<[^>]*>", "", title)
    (pages / "luo_liang.md").write_text(
        f"# {title}\n\n```{{raw}} html\n<div class=\"tutorial\">\n{body}\n</div>\n```\n", encoding="utf-8")
    (folder / "index.html").unlink()
    shutil.copytree(folder, pages / "extra/luo_liang")


def copy_mathjax(static):
    for name in OF_MATHJAX:
        source, target = MATHJAX / name, static / "mathjax" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if source.is_dir() else shutil.copyfile)(source, target)


def synchronise(new, pages):
    """Makes a folder equal to a new one; files that are the same keep their times, so that Sphinx reads the others only. Returns
    whether files went."""
    names = {path.relative_to(new) for path in new.rglob("*") if path.is_file()}
    gone = [path for path in pages.rglob("*") if path.is_file() and path.relative_to(pages) not in names]
    for path in gone:
        path.unlink()
    for name in names:
        if not (pages / name).exists() or (pages / name).read_bytes() != (new / name).read_bytes():
            copy(new / name, pages / name)
    shutil.rmtree(new)
    return bool(gone)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--tutorial", type=pathlib.Path, help="the program luo_liang")
    parser.add_argument("--reference", type=pathlib.Path, help="the folder of Doxygen's pages")
    arguments = parser.parse_args()
    program, folder = arguments.program.resolve(), arguments.folder.resolve()
    pages = folder / "new"
    shutil.rmtree(pages, ignore_errors=True)
    (pages / "static").mkdir(parents=True)
    (pages / "extra").mkdir()
    gallery = [sys.executable, ROOT / "scripts/gallery", program, pages / "gallery", "--cache", folder / "cache"]
    if subprocess.run(gallery, check=False).returncode:
        sys.exit(1)
    shutil.move(pages / "gallery/thumbnails", pages / "extra/gallery/thumbnails")  # they are pictures of raw HTML
    scenes = {f"prm/{page.relative_to(pages / 'gallery').with_suffix('.prm').as_posix()}": page.relative_to(pages)
              for page in (pages / "gallery").rglob("*.md")}
    copy_documents(pages, scenes)
    make_tour(program, pages, folder / "cache")
    (pages / "parameters.md").write_text(parameters.page(program), encoding="utf-8")
    examples.make_pages(ROOT / "python/examples", pages / "python", program, folder / "cache")
    if arguments.tutorial:
        make_tutorial(arguments.tutorial.resolve(), pages)
    has_reference = arguments.reference is not None and (arguments.reference / "index.html").exists()
    if has_reference:
        shutil.copytree(arguments.reference, pages / "extra/reference")
    (pages / "reference.md").write_text("# Reference of the headers\n\n" + (
        '<a href="reference/index.html">All classes and functions</a>, made by Doxygen from the comments of the headers.\n'
        if has_reference else "It was not built with this site: install doxygen and build the target `site` again.\n"), encoding="utf-8")
    copy(HERE / "conf.py", pages / "conf.py")
    copy(HERE / "site.css", pages / "static/site.css")
    copy_mathjax(pages / "static")
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.split()[1].rstrip(",")
    if synchronise(pages, folder / "pages"):
        shutil.rmtree(folder / "html", ignore_errors=True)
    done = subprocess.run([sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-j", "2", "-d", folder / "doctrees",
                           folder / "pages", folder / "html"],
                          env={**os.environ, "SIGNORINI_VERSION": version}, check=False)
    if done.returncode == 0:
        print(f"The site is {folder / 'html/index.html'}")
    sys.exit(done.returncode)


if __name__ == "__main__":
    main()
