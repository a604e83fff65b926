"""The gallery: the decks that examples/README.md lists, with pictures of their results, where scripts/site has run
them."""

import html
import re
import shutil
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList

RESULTS = Path("build/site-examples")
ROW = re.compile(r"\| \[[^]]+\]\((?P<deck>[\w-]+)\.toml\) \| (?P<words>.*) \|")


def pictures_of(root: Path, deck: str) -> list[Path]:
    """The microstructure and the curves of the last stage."""
    stages = sorted((root / RESULTS / deck).glob("*/microstructure.svg"), key=lambda path: path.stat().st_mtime)
    curves = sorted((root / RESULTS / deck).glob("*/*modulus*.svg"), key=lambda path: path.stat().st_mtime)
    return [*stages[-1:], *curves[-1:]]


class Gallery(Directive):
    def run(self):
        env = self.state.document.settings.env
        root = Path(env.app.srcdir)
        gallery = nodes.container(classes=["gallery"])
        for row in ROW.finditer((root / "examples" / "README.md").read_text()):
            pictures = pictures_of(root, row["deck"])
            if not pictures:
                continue
            card = nodes.container(classes=["deck"])
            card += nodes.raw("", self.pictures(env.app, row["deck"], pictures), format="html")
            # The words as in examples/README.md, whose links are relative to that folder.
            words = re.sub(r"\]\((?!\.\.)", "](../examples/", row["words"])
            text = f"[{row['deck']}.toml](../examples/{row['deck']}.toml): {words}"
            self.state.nested_parse(StringList([text], "examples/README.md"), 0, card)
            gallery += card
        return [gallery]

    @staticmethod
    def pictures(app, deck, pictures):
        target = Path(app.outdir, "_images", "gallery")
        target.mkdir(parents=True, exist_ok=True)
        links = []
        for picture in pictures:
            name = f"{deck}-{picture.name}"
            shutil.copy(picture, target / name)
            place = html.escape(f"../_images/gallery/{name}")
            links.append(f'<a href="{place}"><img src="{place}" loading="lazy" alt="{picture.stem} of {deck}"></a>')
        return f'<div class="pictures">{"".join(links)}</div>'


def setup(app):
    app.add_directive("gallery", Gallery)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
