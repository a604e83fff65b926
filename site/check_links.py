"""Lists links of a site that lead nowhere: to files that are not there, or to places that a page does not have. Links to
other sites are listed in a file beside it, and not fetched.

    check_links.py SITE
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """The links of a page, and the places in it that a link can lead to."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.links: set[str] = set()
        self.places: set[str] = set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.places |= {values[key] for key in ("id", "name") if values.get(key)}
        for key in ("href", "src"):
            if values.get(key):
                self.links.add(values[key])


def check(site: Path) -> tuple[list[str], set[str]]:
    """What is wrong with the links of a site, and the links that lead out of it."""
    pages = {path.resolve(): Page(path) for path in sorted(site.rglob("*.html"))}
    mistakes, external = [], set()
    for path, page in pages.items():
        for link in sorted(page.links):
            parts = urlsplit(link)
            if parts.scheme in ("http", "https"):
                external.add(link)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            place = unquote(parts.fragment)
            if not target.is_file():
                mistakes.append(f"{path.relative_to(site)}: no such file: {link}")
            elif place and target in pages and place not in pages[target].places:
                mistakes.append(f"{path.relative_to(site)}: no such place: {link}")
    return mistakes, external


def main() -> int:
    site = Path(sys.argv[1]).resolve()
    mistakes, external = check(site)
    listed = site.with_name(f"{site.name}-external-links.txt")
    listed.write_text("".join(f"{link}\n" for link in sorted(external)))
    print("\n".join(mistakes), file=sys.stderr, end="\n" if mistakes else "")
    print(f"{len(external)} links to other sites, not checked, are listed in {listed}")
    return 1 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main())
