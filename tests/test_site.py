"""The documents as pages: all are there, and no link leads nowhere."""

import importlib.util
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    pytest.importorskip("markdown_it")
    found = importlib.util.spec_from_file_location("site_build", ROOT / "docs/site/build.py")
    module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    out = tmp_path_factory.mktemp("site")
    return module, out, module.build(out)


def test_every_document_is_a_page_that_lists_the_others(site):
    _, out, pages = site
    documents = [*(ROOT / "docs").rglob("*.md"), ROOT / "README.md"]
    assert {page.relative_to(out).with_suffix(".md") for page in pages} >= \
        {path.relative_to(ROOT) for path in documents if path.name != "README.md"}
    for name in ("index.html", "docs/qa.html", "docs/experiments/realism/table.html"):
        text = (out / name).read_text()
        assert all(f"docs/{path.stem}.html" in text for path in (ROOT / "docs").glob("*.md"))


def test_no_link_leads_nowhere(site):
    module, out, _ = site
    assert not module.broken(out)


def test_what_leads_nowhere_is_named(site, tmp_path):
    module, _, _ = site
    (tmp_path / "a.html").write_text('<h1 id="here"></h1><a href="b.html">x</a><a href="#here">x</a>'
                                     '<a href="#gone">x</a><img src="c.png"><a href="https://x.org/y">x</a>')
    assert module.broken(tmp_path) == ["a.html: b.html", "a.html: #gone", "a.html: c.png"]


def test_links_of_documents_have_their_words(site):
    """As many links as the documents have, by another reading of them."""
    _, out, _ = site
    for name in ("export", "render", "qa", "library"):
        text = re.sub(r"```.*?```|`[^`]*`", "", (ROOT / f"docs/{name}.md").read_text(), flags=re.DOTALL)
        wanted = len(re.findall(r"\]\([^)]+\)", text))
        main = (out / f"docs/{name}.html").read_text().partition("<main>")[2]
        assert len(re.findall(r'(?:href|src)="', main)) == wanted
