"""Divides a file of prompts into shards of lines of JSON, each with an id; `split.py PROMPTS SHARD OUT`."""

import json
import sys
from pathlib import Path


def row(number: int, line: str) -> str:
    """A prompt as JSON; one without an id is called by its number."""
    value = json.loads(line) if line.startswith("{") else {"prompt": line}
    return json.dumps({"id": f"{number:07d}", **value}, ensure_ascii=False) + "\n"


def main(prompts: str, shard: str, out: str) -> None:
    """Write the shards that changed, and take away those that are no more."""
    lines = [line.strip() for line in Path(prompts).read_text(encoding="utf-8").splitlines() if line.strip()]
    rows, size = [row(i, line) for i, line in enumerate(lines)], int(shard)
    shards = {f"{i // size:05d}.prompts": "".join(rows[i:i + size]) for i in range(0, len(rows), size)}
    for name, text in shards.items():
        file = Path(out) / name
        if not file.exists() or file.read_text(encoding="utf-8") != text:
            file.write_text(text, encoding="utf-8")
    for file in Path(out).glob("*.prompts"):
        if file.name not in shards:
            file.unlink()


if __name__ == "__main__":
    main(*sys.argv[1:])
