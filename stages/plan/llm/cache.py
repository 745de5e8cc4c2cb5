"""Answers of models, kept by prompt, model and instructions."""

import hashlib
import json
import logging
import os
import tempfile
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from apartgen.schemas.plan import Program
from apartgen.stages.plan.llm.answers import instructions, reply_schema

log = logging.getLogger("apartgen")


class Cache:
    """One answer's place in a folder; no folder, no cache."""

    def __init__(self, folder: Path | None, model: str, prompt: str) -> None:
        key = json.dumps([model, prompt, instructions(), reply_schema()], sort_keys=True)
        name = hashlib.sha256(key.encode()).hexdigest()[:32] + ".json"
        self.path = None if folder is None else folder / name

    def recalled(self) -> tuple[Program, dict[str, Any]] | None:
        """The kept programme and its `used`, None where there is none; a damaged file is read over."""
        if self.path is None or not self.path.exists():
            return None
        try:
            kept = json.loads(self.path.read_text(encoding="utf-8"))
            return Program.model_validate(kept["program"]), dict(kept["used"]) | {"cached": True}
        except (OSError, ValueError, KeyError, TypeError, ValidationError) as e:
            log.warning("%s: damaged cache entry (%s), asking again", self.path, type(e).__name__)
            return None

    def save(self, program: Program, used: dict[str, Any]) -> None:
        """Keep an answer; the file appears whole or not at all."""
        if self.path is None:
            return
        self.path.parent.mkdir(parents=True, exist_ok=True)
        body = json.dumps({"program": program.model_dump(mode="json"), "used": used}, ensure_ascii=False, indent=1)
        handle, temporary = tempfile.mkstemp(dir=self.path.parent, suffix=".part")
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(body)
        os.replace(temporary, self.path)
