"""The navigation: the lists of docs/README.md as the site's table of contents, so that they stand in one place."""

import re
from pathlib import Path

#: Pages that only the site has, or that are not in docs/.
OTHER = {"Examples": ["examples/README", "site/gallery", "examples/python/*"],
         "Reference": ["site/python-reference", "site/cpp-reference"],
         "Project": ["docs/README", "CHANGELOG"]}


def pages_by_heading(overview: str) -> dict[str, list[str]]:
    """The pages that docs/README.md lists below each of its headings, such as "For reference:"."""
    pages: dict[str, list[str]] = {}
    heading = ""
    for line in overview.splitlines():
        if match := re.fullmatch(r"(\w[\w ]+):", line):
            heading = match[1]
        elif match := re.match(r"- \[[^]]*\]\(([\w/-]+)\.md\)", line):
            pages.setdefault(heading, []).append(f"docs/{match[1]}")
    return pages


def add_navigation(app, name, source):
    if name != app.config.root_doc:
        return
    overview = Path(app.srcdir, "docs", "README.md").read_text()
    for heading, pages in {**pages_by_heading(overview), **OTHER}.items():
        lines = "\n".join(f"/{page}" for page in pages)
        is_pattern = ":glob:\n" if any("*" in page for page in pages) else ""
        source[0] += f"\n```{{toctree}}\n:hidden:\n:caption: {heading}\n{is_pattern}\n{lines}\n```\n"


def setup(app):
    app.connect("source-read", add_navigation)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
