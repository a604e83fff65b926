"""References to equations, "Eq. 33b" and "Eqs. 3 to 5" in any page, become links to the equations of docs/theory.md."""

import re

from docutils import nodes
from katex_math import TAG
from sphinx.transforms.post_transforms import SphinxPostTransform

PAGE = "docs/theory"
REFERENCE = re.compile(r"Eqs?\.\s(\d+[a-z]?)")


def collect_equations(app, tree):
    if app.env.docname == PAGE:
        app.env.breccia_equations = {tag[1] for block in tree.findall(nodes.math_block)
                                     if (tag := TAG.search(block.astext()))}


class EquationLinks(SphinxPostTransform):
    default_priority = 700

    def run(self, **_):
        known = getattr(self.env, "breccia_equations", set())
        page = self.app.builder.get_relative_uri(self.env.docname, PAGE)
        for text in list(self.document.findall(nodes.Text)):
            if isinstance(text.parent, (nodes.reference, nodes.literal, nodes.literal_block, nodes.title)):
                continue
            parts = self.parts_of(str(text), known, page)
            if len(parts) > 1:
                text.parent.replace(text, parts)

    @staticmethod
    def parts_of(text, known, page):
        parts, end = [], 0
        for match in REFERENCE.finditer(text):
            if match[1] not in known:
                continue
            parts += [nodes.Text(text[end:match.start()]),
                      nodes.reference("", match[0], refuri=f"{page}#eq-{match[1]}", internal=True)]
            end = match.end()
        return [*parts, nodes.Text(text[end:])]


def setup(app):
    app.connect("doctree-read", collect_equations)
    app.add_post_transform(EquationLinks)
    return {"parallel_read_safe": False, "parallel_write_safe": True}
