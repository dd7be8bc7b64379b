# SPDX-License-Identifier: GPL-3.0-or-later
"""Sphinx: pages that work from a folder, without a network, with the same bytes whenever they are made."""
import json
import re
from pathlib import Path

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml
from pygments.lexers import TextLexer

here = Path(__file__).resolve().parent

project = "rwedge"
author = ""
version = release = re.search(r"project\(rwedge VERSION ([\d.]+)", (here.parents[1] / "CMakeLists.txt").read_text())[1]

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
autodoc_typehints = "none"
autodoc_member_order = "bysource"
napoleon_google_docstring = False
napoleon_use_ivar = True
nitpick_ignore_regex = [("py:.*", r"(?!rwedge\.).*")]  # kinds of arguments, such as array_like, and names of other packages
source_suffix = {".md": "markdown"}
myst_heading_anchors = 4
myst_enable_extensions = ["deflist", "dollarmath"]
myst_fence_as_directive = ["math"]
smartquotes = False
highlight_language = "none"

html_theme = "furo"
html_title = f"rwedge {version}"
html_static_path = ["style.css"]
html_css_files = ["style.css"]
html_copy_source = html_show_sourcelink = False
html_show_copyright = False
html_last_updated_fmt = None
pygments_style = "default"
html_math_renderer = "mathml"


def set_formula(writer, node):
    """As MathML, which browsers draw without help. It has no space of its own behind the name of a function."""
    block = isinstance(node, nodes.math_block)
    formula = tex2mathml(re.sub(r"\\(arc(cos|tan)|cos|cot|ln|sin|tan) ", r"\g<0>\\,", node.astext()), as_block=block)
    writer.body.append(f'<div class="math">{formula}</div>' if block else formula)
    raise nodes.SkipNode


# A browser reads no other file of a folder. So the search has the texts beside it, in place of what it would fetch.
FETCH = """window.fetch = async (address) => ({text: () => {
    const page = document.createElement("div");
    page.setAttribute("role", "main");
    page.textContent = texts[address.replace(/^\\.\\/|\\.html$/g, "")];
    return page.outerHTML;
}});
"""


def text_of(document):
    for formula in list(document.findall(lambda node: isinstance(node, (nodes.math, nodes.math_block)))):
        formula.parent.remove(formula)
    return document.astext()


def keep_texts(app, failure):
    texts = {} if failure else {name: text_of(app.env.get_doctree(name)) for name in sorted(app.env.found_docs)}
    (Path(app.outdir) / "_static" / "texts.js").write_text(f"const texts = {json.dumps(texts, indent=0)};\n{FETCH}", encoding="utf-8")


def search_in_texts(app, page, template, context, doctree):
    if page == "search":
        app.add_js_file("texts.js")


def setup(app):
    app.add_lexer("csv", TextLexer)
    app.add_html_math_renderer("mathml", (set_formula, None), (set_formula, None))
    app.connect("html-page-context", search_in_texts)
    app.connect("build-finished", keep_texts)
