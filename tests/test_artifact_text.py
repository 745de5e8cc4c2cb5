"""Artifacts as text: JSON that people can read and compare line by line."""

import json

import handmade as h

from apartgen.schemas import artifact

CONFIG = {
    "numbers": [k / 7 for k in range(60)],
    "mixed": ["first", {"some": ["word"] * 12}, {"other": ["word"] * 12}, 7],
    "nested": [[k, k + 1] for k in range(40)],
    "short": [1, [2, {"a": 3}]],
    "é": "ü",
}


def test_long_rows_of_numbers_stay_together_and_all_else_is_divided() -> None:
    made = artifact.Made(by="test", seed=1, config=CONFIG)
    text, read = artifact.finish(h.plan(), made)
    again = json.loads(text)
    assert list(again) == ["apartgen", "version", "made", "body"] and text.endswith("}\n") and read.body == h.plan()
    assert again["made"]["config"]["mixed"] == CONFIG["mixed"] and again["made"]["config"]["é"] == "ü"
    rows = {line.split(":")[0].strip(' "'): line for line in text.splitlines() if ":" in line}
    assert rows["numbers"].rstrip(",").endswith("]") and len(rows["numbers"]) > 400
    assert rows["short"].strip() == '"short": [1, [2, {"a": 3}]],' and rows["é"].strip() == '"é": "ü"'
    assert rows["mixed"].strip() == '"mixed": [' and rows["nested"].strip() == '"nested": ['
    assert all(len(line) <= 140 for line in text.splitlines() if '"numbers"' not in line)


def test_what_has_112_columns_with_its_indent_is_not_divided() -> None:
    """Two columns of indent and `{"at": [[], "…"]}`, 16 without the text; names before it are not counted."""
    for long, whole in ((94, True), (95, False)):
        made = artifact.Made(by="test", seed=1, config={"at": [[], "x" * long]})
        assert ('"config": {"at": [[], "xxx' in artifact.finish(h.plan(), made)[0]) == whole, long
