"""The settings of Sphinx for the site. The pages are the Markdown files of the project where they are; the folder
`site` adds what no reader of a file needs: the gallery and the references of Python and C++."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "site" / "extensions"))

project = "Breccia"
author = "the authors of Breccia"
copyright = author  # noqa: A001: Sphinx calls it so
version = release = re.search(r"project\(breccia\s+VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.I)[1]

extensions = ["myst_parser", "nbsphinx", "sphinx.ext.autodoc", "sphinx.ext.napoleon",
              "navigation", "katex_math", "equations", "source_pages", "gallery", "cpp_reference", "python_reference"]
root_doc = "README"
include_patterns = ["README.md", "CHANGELOG.md", "docs/*.md", "docs/studies/*.md", "examples/README.md", "examples/python/*.ipynb",
                    "site/*.md"]

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 6
# Outputs of a program and sketches of paths have no language.
highlight_language = "none"
nbsphinx_execute = "never"
nbsphinx_requirejs_path = ""  # from another site, for outputs with scripts, which our notebooks do not have

html_theme = "furo"
html_title = f"Breccia {release}"
html_static_path = ["style"]
html_css_files = ["katex/katex.min.css", "breccia.css"]
html_extra_path = ["index"]
html_show_sphinx = False
html_copy_source = False
