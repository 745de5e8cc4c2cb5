"""An OpenAI-compatible server on the loopback interface that answers by script."""

import json
import time
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler
from typing import Any

PROGRAM = {
    "rooms": [
        {"id": "living_room_1", "type": "living_room", "area": 25.0},
        {"id": "kitchen_1", "type": "kitchen"},
        {"id": "bedroom_1", "type": "bedroom"},
        {"id": "bathroom_1", "type": "bathroom"},
        {"id": "hallway_1", "type": "hallway"},
    ],
    "links": [["hallway_1", "living_room_1"], ["hallway_1", "bedroom_1"], ["hallway_1", "bathroom_1"]],
    "objects": [{"room": "bedroom_1", "category": "desk", "count": 2}],
}


def good(**changes: Any) -> str:
    """A valid reply's text, the programme changed by `changes`."""
    return json.dumps({"program": PROGRAM | changes, "refusal": None})


@dataclass
class Step:
    """One scripted answer."""

    text: str | None = None
    status: int = 200
    finish: str = "stop"
    refusal: str | None = None
    delay: float = 0.0
    pause: float = 0.0
    """Seconds between one byte of the reply and the next."""
    raw: bytes | None = None
    packed: str = ""
    """How the raw reply is packed."""


@dataclass
class Script:
    """Answers in order, the last repeated; `seen` holds what was asked."""

    steps: list[Step] = field(default_factory=list)
    seen: list[dict[str, Any]] = field(default_factory=list)
    keys: list[str] = field(default_factory=list)
    formats_rejected: tuple[str, ...] = ()
    url: str = ""

    def next(self) -> Step:
        return self.steps.pop(0) if len(self.steps) > 1 else self.steps[0]


class Handler(BaseHTTPRequestHandler):
    script: Script

    def do_POST(self) -> None:
        body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.script.seen.append(body)
        self.script.keys.append(self.headers.get("Authorization", ""))
        kind = (body.get("response_format") or {}).get("type", "text")
        if kind in self.script.formats_rejected:
            return self._send(
                400,
                json.dumps(
                    {"error": {"message": f"response_format {kind} is not supported", "type": "invalid_request_error"}}
                ),
            )
        step = self.script.next()
        time.sleep(step.delay)
        if step.raw is not None:
            return self._send(step.status, step.raw, packed=step.packed)
        if step.status != 200:
            return self._send(
                step.status, json.dumps({"error": {"message": step.text or "no", "type": "error", "code": None}})
            )
        message = {"role": "assistant", "content": step.text, "refusal": step.refusal}
        reply = {
            "id": "r1", "object": "chat.completion", "created": 1, "model": body["model"],
            "choices": [{"index": 0, "message": message, "finish_reason": step.finish}],
            "usage": {"prompt_tokens": 100, "completion_tokens": 40, "total_tokens": 140},
        }  # fmt: skip
        return self._send(200, json.dumps(reply), step.pause)

    def _send(self, status: int, body: str | bytes, pause: float = 0.0, packed: str = "") -> None:
        data = body.encode() if isinstance(body, str) else body
        try:
            self.send_response(status)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(data)))
            if packed:
                self.send_header("Content-Encoding", packed)
            self.end_headers()
            for part in [data[i:i + 1] for i in range(len(data))] if pause else [data]:
                self.wfile.write(part)
                time.sleep(pause)
        except (BrokenPipeError, ConnectionResetError):
            pass  # the client gave up waiting

    def log_message(self, format: str, *args: Any) -> None:
        pass
