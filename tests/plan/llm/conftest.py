"""A scripted language-model server for every test of this folder."""

import threading
from collections.abc import Iterator
from http.server import ThreadingHTTPServer

import pytest
from llm_server import Handler, Script


@pytest.fixture
def script(monkeypatch: pytest.MonkeyPatch) -> Iterator[Script]:
    """A running server and the script it plays."""
    played = Script()
    handler = type("Handler", (Handler,), {"script": played})
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02}, daemon=True).start()
    played.url = f"http://127.0.0.1:{server.server_port}/v1"
    monkeypatch.setenv("OPENAI_API_KEY", "sk-secret-abcdef123456")
    for name in ("HTTP_PROXY", "HTTPS_PROXY", "ALL_PROXY", "http_proxy", "https_proxy", "all_proxy"):
        monkeypatch.delenv(name, raising=False)
    yield played
    server.shutdown()
    server.server_close()
