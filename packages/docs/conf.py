# SPDX-License-Identifier: GPL-3.0-or-later
"""Sphinx: pages that work from a folder, without a network, with the same bytes whenever they are made."""
import re
from pathlib import Path

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
myst_enable_extensions = ["deflist"]
smartquotes = False
highlight_language = "none"

html_theme = "furo"
html_title = f"rwedge {version}"
html_static_path = ["style.css"]
html_css_files = ["style.css"]
html_copy_source = html_show_sourcelink = False
html_show_copyright = False
html_show_search_summary = False  # a browser reads no other file of a folder
html_last_updated_fmt = None
pygments_style = "default"
