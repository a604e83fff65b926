"""Formulas are set by KaTeX when the site is built: pages need no script for them, and a formula that KaTeX cannot read
is a warning."""

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

from docutils import nodes
from sphinx.util import logging

LOGGER = logging.getLogger(__name__)
ASSETS = Path("/usr/share/javascript/katex")  # of the package libjs-katex
TAG = re.compile(r"\\tag\{([^}]+)\}")
CLOSING = re.compile(r"[.,;:)\]]+")


class Katex:
    """A process of Node that sets formulas, one for each process of Sphinx."""

    def __init__(self) -> None:
        self._node: subprocess.Popen[str] | None = None
        self._owner = 0

    def html(self, tex: str, is_block: bool) -> dict[str, str]:
        if self._node is None or self._owner != os.getpid():
            program = Path(__file__).with_name("katex.js")
            self._node = subprocess.Popen(["node", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                          env={**os.environ, "NODE_PATH": "/usr/share/nodejs"})
            self._owner = os.getpid()
        self._node.stdin.write(json.dumps({"tex": tex, "displayMode": is_block}) + "\n")
        self._node.stdin.flush()
        return json.loads(self._node.stdout.readline())


KATEX = Katex()


def formula(node: nodes.Element, is_block: bool) -> str:
    answer = KATEX.html(node.astext(), is_block)
    if "error" in answer:
        LOGGER.warning("formula: %s", answer["error"], location=node)
    return answer.get("html", "")


def keep_punctuation(app, doctree, name):
    """What closes after a formula goes with it: a browser may begin a line after any formula, even with a full stop."""
    for node in doctree.findall(nodes.math):
        text = node.next_node(descend=False, siblings=True)
        closing = CLOSING.match(text) if isinstance(text, nodes.Text) else None
        if closing:
            node["closing"] = closing[0]
            node.parent.replace(text, nodes.Text(text[closing.end():]))


def visit_inline(self, node):
    self.body.append(f'<span class="math">{formula(node, False)}{node.get("closing", "")}</span>')
    raise nodes.SkipNode


def visit_block(self, node):
    tag = TAG.search(node.astext())
    place = f' id="eq-{tag[1]}"' if tag else ""
    self.body.append(f'<div class="math-block"{place}>{formula(node, True)}</div>')
    raise nodes.SkipNode


def copy_assets(app, error):
    if error is None and app.builder.format == "html":
        target = Path(app.outdir, "_static", "katex")
        shutil.rmtree(target, ignore_errors=True)
        target.mkdir()
        shutil.copy(ASSETS / "katex.min.css", target)
        shutil.copytree(ASSETS / "fonts", target / "fonts", ignore=lambda _, names: [
            name for name in names if not name.endswith(".woff2")])


def setup(app):
    app.add_html_math_renderer("katex", (visit_inline, None), (visit_block, None))
    app.config.html_math_renderer = "katex"
    app.connect("doctree-resolved", keep_punctuation)
    app.connect("build-finished", copy_assets)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
