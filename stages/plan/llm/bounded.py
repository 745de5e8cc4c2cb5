"""Replies of servers, no longer than a programme could ever be, however they are packed."""

from collections.abc import Iterator
from typing import Any

LONGEST = 16_000_000
"""Bytes of a reply."""
PACKED = 64_000
"""Bytes of a packed one, which unpacks to a thousand times as many at most."""
KINDS = ("gzip", "deflate", "x-gzip")
"""How a reply may be packed: of these it is known how large it can become."""


class Long(Exception):
    """A reply beyond its bound; clients wrap it in errors of theirs."""


def cause(error: BaseException | None) -> Long | None:
    """The reply's fault that an error came of, where it came of that."""
    while error is not None and not isinstance(error, Long):
        error = error.__cause__ or error.__context__
    return error


def client() -> Any:
    """A client that ends a reply at its bound."""
    import httpx

    class Counted(httpx.SyncByteStream):
        """A stream that ends with an error behind its bound."""

        def __init__(self, stream: Any, most: int) -> None:
            self._stream, self._left = stream, most

        def __iter__(self) -> Iterator[bytes]:
            for part in self._stream:
                self._left -= len(part)
                if self._left < 0:
                    raise Long("the reply is longer than any programme")
                yield part

        def close(self) -> None:
            self._stream.close()

    def bound(response: Any) -> None:
        packed = response.headers.get("content-encoding", "identity").lower()
        if packed not in ("identity", *KINDS):
            raise Long(f"the reply is packed as {packed[:20]!r}, which was not asked for")
        response.stream = Counted(response.stream, LONGEST if packed == "identity" else PACKED)

    plain = {"Accept-Encoding": "identity"}
    return httpx.Client(follow_redirects=True, headers=plain, event_hooks={"response": [bound]})
