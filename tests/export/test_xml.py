"""Documents are those of Python's own writer, indented; numbers are read back as they were to nine digits."""

from xml.etree import ElementTree

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from apartgen.stages.export._xml import add, numbers, save

WORDS = st.text(st.characters(exclude_categories=["Cs", "Cc"]) | st.sampled_from("\t\n\r<>&\"'"), max_size=12)
TAGS = st.sampled_from(["body", "geom", "a_b"])
ATTRIBUTES = st.dictionaries(st.sampled_from(["name", "class_", "pos"]), WORDS, max_size=3)
TREES = st.recursive(st.tuples(TAGS, ATTRIBUTES, WORDS.filter(lambda text: text == "" or text.strip())),
                     lambda inner: st.tuples(TAGS, ATTRIBUTES, st.lists(inner, min_size=1, max_size=4)), max_leaves=12)


def grown(tree, parent) -> None:
    tag, attributes, inside = tree
    child = add(parent, tag, inside if isinstance(inside, str) and inside else None, **attributes)
    for inner in [] if isinstance(inside, str) else inside:
        grown(inner, child)


@given(tree=TREES)
def test_a_document_is_the_one_that_python_writes(tmp_path_factory, tree):
    root = ElementTree.Element("root")
    grown(tree, root)
    written = save(root, tmp_path_factory.mktemp("x") / "x.xml").read_bytes()
    ElementTree.indent(root)
    assert written.decode() == f'<?xml version="1.0" encoding="utf-8"?>\n{ElementTree.tostring(root, "unicode")}\n'


@given(values=st.lists(st.floats(-1e6, 1e6), max_size=8))
def test_numbers_are_read_back_to_nine_digits(values):
    read = [float(word) for word in numbers(values).split()]
    np.testing.assert_allclose(read, values, rtol=5e-9, atol=1e-9)
