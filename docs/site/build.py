"""Builds a folder of pages from the documents, to be put on any web server: `make site`.

    python docs/site/build.py OUT [--homes]

With --homes the homes of the gallery are made, each with a page to walk about in. The folder can be read without a
server.
"""

import html
import re
import shutil
import sys
from pathlib import Path
from urllib.parse import unquote, urlsplit

from markdown_it import MarkdownIt

ROOT = Path(__file__).parents[2]
STYLE = Path(__file__).with_name("style.css")
FRONT = "README.md"
TOP = (FRONT, "CONTRIBUTING.md", "CHANGELOG.md")
GALLERY = "docs/gallery.md"
ORDER = ("gallery", "library", "commands", "plan", "layout", "retrieve", "walkable", "populate", "export", "render",
         "qa", "metrics", "check", "datasets", "embodied", "physics", "realism", "model-card", "extending")
"""Pages of `docs` as they are listed; others follow by name."""
LINK = re.compile(r'(href|src)="([^"]+)"')
HEADING = re.compile(r"<h([1-4])>(.*?)</h\1>", re.DOTALL)


def sources() -> list[Path]:
    """Every document, from the root."""
    docs = sorted(path.relative_to(ROOT) for path in (ROOT / "docs").rglob("*.md"))
    return [Path(name) for name in TOP if (ROOT / name).is_file()] + docs


def page_of(source: Path) -> Path:
    """Where a document's page is."""
    return Path("index.html") if str(source) == FRONT else source.with_suffix(".html")


def build(out: Path, homes: bool = False) -> list[Path]:
    """All pages and what they show, into an empty folder; the pages' list."""
    out.mkdir(parents=True, exist_ok=True)
    shutil.copy(STYLE, out / STYLE.name)
    walks = _homes(out) if homes else []
    pages = []
    for source in sources():
        text = (ROOT / source).read_text(encoding="utf-8")
        body = _anchored(MarkdownIt("commonmark", {"html": True}).enable("table").render(text))
        body = _linked(out, source, body)
        if str(source) == GALLERY and walks:
            body += _listed(source, walks)
        page = out / page_of(source)
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text(_whole(source, text, body), encoding="utf-8")
        pages.append(page)
    return pages


def _linked(out: Path, source: Path, body: str) -> str:
    """A document's text with links to pages in place of documents."""
    return LINK.sub(lambda match: f'{match[1]}="{_target(out, source, match[2])}"', body)


def _target(out: Path, source: Path, link: str) -> str:
    """Where a link of a document leads to from its page; files that it shows are copied."""
    parts = urlsplit(link)
    if parts.scheme or not parts.path:
        return link
    wanted = (ROOT / source.parent / unquote(parts.path)).resolve()
    inner = wanted.relative_to(ROOT)
    if wanted.suffix == ".md" and inner in sources():
        inner = page_of(inner)
    elif wanted.is_dir():
        inner = _folder(out, inner)
    elif wanted.is_file():
        (out / inner).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(wanted, out / inner)
    return _way(source, inner) + (f"#{parts.fragment}" if parts.fragment else "")


def _folder(out: Path, inner: Path) -> Path:
    """A page that lists a folder's files, which are copied."""
    files = [path for path in sorted((ROOT / inner).iterdir()) if path.is_file() and path.suffix != ".pyc"]
    page = out / inner / "index.html"
    page.parent.mkdir(parents=True, exist_ok=True)
    for path in files:
        shutil.copy(path, out / inner / path.name)
    rows = "".join(f'<li><a href="{html.escape(path.name)}">{html.escape(path.name)}</a></li>' for path in files)
    page.write_text(_whole(inner / "index.md", f"# {inner}", f"<h1>{inner}</h1><ul>{rows}</ul>"), encoding="utf-8")
    return inner / "index.html"


def _way(source: Path, target: Path) -> str:
    """The address of a file from a page."""
    up = "../" * len(page_of(source).parent.parts)
    return up + target.as_posix()


def _anchored(body: str) -> str:
    """Headings get the names by which documents link to them."""
    def named(match: re.Match[str]) -> str:
        plain = re.sub(r"<[^>]+>", "", match[2]).lower()
        name = re.sub(r"[^\w -]", "", html.unescape(plain)).strip().replace(" ", "-")
        return f'<h{match[1]} id="{name}">{match[2]}</h{match[1]}>'

    return HEADING.sub(named, body)


def _whole(source: Path, text: str, body: str) -> str:
    """A page with its title and the list of the others."""
    title = next((line.lstrip("# ") for line in text.splitlines() if line.startswith("#")), str(source))
    names = sorted((path.stem for path in sources() if path.parent == Path("docs")),
                   key=lambda name: (ORDER.index(name) if name in ORDER else len(ORDER), name))
    links = [("apartgen", Path("index.html")), *((name, Path("docs") / f"{name}.html") for name in names)]
    here = page_of(source)
    rows = "".join(f'<a href="{_way(source, page)}"{" aria-current=page" if page == here else ""}>{name}</a>'
                   for name, page in links)
    return (f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">'
            f'<link rel="stylesheet" href="{_way(source, Path(STYLE.name))}"></head>'
            f"<body><nav>{rows}</nav><main>{body}</main></body></html>\n")


def _homes(out: Path) -> list[tuple[str, Path]]:
    """Pages to walk about in, by what was asked for."""
    sys.path.insert(0, str(ROOT / "docs/experiments"))
    import gallery

    import apartgen

    found = []
    (out / "homes").mkdir(exist_ok=True)
    for number, home, _ in gallery.made():
        apartgen.view([home], out / "homes" / f"{number}.html")
        found.append((home.body.prompt, Path("homes") / f"{number}.html"))
    return found


def _listed(source: Path, walks: list[tuple[str, Path]]) -> str:
    rows = "".join(f'<li><a href="{_way(source, page)}">{html.escape(text)}</a></li>' for text, page in walks)
    return f'<h2 id="walk-about">Walk about in them</h2><ol>{rows}</ol>'


def broken(out: Path) -> list[str]:
    """Links between pages of a folder that lead nowhere."""
    found, names = [], {}
    pages = sorted(out.rglob("*.html"))
    for page in pages:
        names[page.resolve()] = set(re.findall(r'id="([^"]+)"', page.read_text(encoding="utf-8")))
    for page in (page for page in pages if page.parent.name != "homes"):
        for _, link in LINK.findall(page.read_text(encoding="utf-8")):
            parts = urlsplit(html.unescape(link))
            if parts.scheme:
                continue
            target = (page.parent / unquote(parts.path)).resolve() if parts.path else page.resolve()
            if not target.is_file() or (parts.fragment and parts.fragment not in names.get(target, ())):
                found.append(f"{page.relative_to(out)}: {link}")
    return found


if __name__ == "__main__":
    build(Path(sys.argv[1]), "--homes" in sys.argv[2:])
    if lost := broken(Path(sys.argv[1])):
        sys.exit("\n".join(lost))
