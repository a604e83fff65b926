"""The overview of the C++ library: its modules, as docs/contributing.md describes them, with links to the pages that
Doxygen makes of their public headers."""

import re
import xml.etree.ElementTree as ET
from collections import defaultdict
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList

TAGS = Path("build/site-cpp/breccia.tag")
MODULE = re.compile(r"\| `(?P<module>\w+)` \| (?P<words>[^|]+) \|")


def links_by_module(tags: Path) -> dict[str, list[tuple[str, str]]]:
    """The names of types and functions, and their places among the pages of Doxygen."""
    compounds = ET.parse(tags).getroot().findall("compound")
    pages = {one.findtext("name"): one.findtext("filename") for one in compounds}
    links: dict[str, set[tuple[str, str]]] = defaultdict(set)
    for header in compounds:
        if header.get("kind") != "file":
            continue
        # The headers of no module, such as error.hpp, are those of the whole library.
        module = re.sub(r"^.*breccia/?", "", header.findtext("path", "")).strip("/")
        for one in header.findall("class"):
            if "<" not in one.text and one.text.startswith("breccia::"):
                links[module].add((one.text.removeprefix("breccia::"), pages[one.text]))
        for one in header.findall("member"):
            # Not the declarations of instances beside those of their templates.
            if one.get("kind") in ("function", "enumeration", "typedef") and "<" not in one.findtext("name"):
                place = f"{one.findtext('anchorfile')}#{one.findtext('anchor')}"
                links[module].add((one.findtext("name"), place))
    return {module: sorted(set(dict(sorted(all_)).items())) for module, all_ in links.items()}


class Modules(Directive):
    def run(self):
        root = Path(self.state.document.settings.env.app.srcdir)
        links = links_by_module(root / TAGS)
        modules = [("breccia", "errors, and the words of enumerations", ""),
                   *((row["module"], row["words"], row["module"])
                     for row in MODULE.finditer((root / "docs" / "contributing.md").read_text()))]
        sections = []
        for title, words, module in modules:
            if module not in links:
                continue
            section = nodes.section(ids=[f"module-{title}"], names=[title])
            section += nodes.title("", title)
            self.state.nested_parse(StringList([f"{words[0].upper()}{words[1:]}."], "docs/contributing.md"), 0, section)
            names = nodes.paragraph(classes=["names"])
            for name, place in links[module]:
                names += nodes.reference("", name, refuri=f"../cpp/{place}", internal=True)
                names += nodes.Text("\n")
            section += names
            sections.append(section)
        return sections


def setup(app):
    app.add_directive("modules", Modules)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
