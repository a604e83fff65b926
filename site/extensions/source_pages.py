"""Links to files that are no pages, such as decks and scripts, lead to pages that show them, highlighted."""

from pathlib import Path, PurePosixPath

from sphinx import addnodes
from docutils import nodes
from sphinx.transforms import SphinxTransform

LANGUAGES = {".toml": "toml", ".py": "python", ".cpp": "c++", ".hpp": "c++", ".sh": "bash"}


def page_of(path: PurePosixPath) -> str:
    return f"source/{path}"


def is_text(path: Path) -> bool:
    try:
        path.read_text()
    except UnicodeDecodeError:
        return False
    return True


class SourceLinks(SphinxTransform):
    default_priority = 890  # before Sphinx collects the files to be downloaded

    def apply(self, **_):
        for link in list(self.document.findall(addnodes.download_reference)):
            # Paths of MyST are relative to the page; those that begin with "/" to the root of the project.
            name, path = self.env.relfn2path(link["reftarget"])
            if not Path(path).is_file() or not is_text(Path(path)):
                continue
            name = PurePosixPath(name)
            if not hasattr(self.env, "breccia_sources"):
                self.env.breccia_sources = {}
            self.env.breccia_sources.setdefault(str(name), set()).add(self.env.docname)
            uri = self.app.builder.get_relative_uri(self.env.docname, page_of(name))
            link.replace_self(nodes.reference("", "", *link.children, refuri=uri, internal=True))


def source_pages(app):
    for name in sorted(getattr(app.env, "breccia_sources", {})):
        path = PurePosixPath(name)
        language = LANGUAGES.get(path.suffix, "none")
        code = app.builder.highlighter.highlight_block(Path(app.srcdir, name).read_text(), language)
        yield page_of(path), {"title": name, "body": f"<h1>{name}</h1>\n{code}"}, "page.html"


def setup(app):
    app.add_transform(SourceLinks)
    app.connect("html-collect-pages", lambda app: source_pages(app))
    return {"parallel_read_safe": False, "parallel_write_safe": True}
