# SPDX-License-Identifier: LGPL-2.1-or-later
# The settings of Sphinx for the site; build.py makes its sources.
import os
import pathlib
import re

project = "Signorini"
html_title = "Signorini " + os.environ.get("SIGNORINI_VERSION", "")
extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["deflist", "dollarmath", "html_image"]
myst_heading_anchors = 4
myst_update_mathjax = False
suppress_warnings = ["myst.header"]
html_theme = "furo"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_extra_path = ["extra"]
html_copy_source = html_show_sourcelink = html_show_copyright = html_show_sphinx = False
highlight_language = "none"
# MathJax 2 of Debian, copied beside the pages.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML"
mathjax2_config = {"showMathMenu": False, "messageStyle": "none",
                   "tex2jax": {"processClass": "tex2jax_process|mathjax_process|math"},
                   "CommonHTML": {"linebreaks": {"automatic": False}, "scale": 95}}


def mend_theme(app, _):
    """Makes Debian's furo work without a web server: its style names one of /javascript, its script imports another."""
    static = pathlib.Path(app.outdir) / "_static"
    style, script = static / "styles/furo.css", static / "scripts/furo.js"
    shared = pathlib.Path("/usr/share/javascript/normalize.css/normalize.css")
    text = style.read_text(encoding="utf-8")
    if shared.exists():
        text = text.replace("@import url(/javascript/normalize.css/normalize.css);", shared.read_text(encoding="utf-8"))
    style.write_text(text, encoding="utf-8")
    imported = re.match(r'import Gumshoe from "./(.*)";', script.read_text(encoding="utf-8"))
    if imported:
        library = (script.parent / imported[1]).read_text(encoding="utf-8")
        script.write_text(library + script.read_text(encoding="utf-8")[imported.end():], encoding="utf-8")


def setup(app):
    app.connect("build-finished", mend_theme)
