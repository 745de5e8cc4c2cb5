"""Spoils what is well formed: bytes as disks and editors do, values as programs and people do."""

import copy
import random
from typing import Any

TOKENS = (b"{", b"}", b"[", b"]", b",", b":", b'"', b"null", b"NaN", b"-Infinity", b"1e999", b"-1", b"\x00",
          b"\xff\xfe", b"\\ud800", b"\r\n", b"<", b">", b"&", b"9" * 400, b"[" * 2000, b"-0.0",
          b"../../etc/passwd", b"\x1b[2J")
VALUES: tuple[Any, ...] = (
    None, True, False, 0, -1, 1, 2**31, -2**63, 2**64, 10**40, 0.0, -0.0, 1e-12, 1e-300, 1e9, 1e300, -1e300, 0.05, 1e6,
    "", "x", "\x00", "\x1b[2J", "../../../etc/passwd", "living_room_1", "a" * 3000, "\u202e\U0001f6cf", "NaN", [], {},
    [[]], [0, 0], [0, 0, 0], [1e9, 1e9], [[0, 0], [0, 0], [0, 0]], {"id": "x"}, [None],
    [[0, 0], [1, 1], [0, 1], [1, 0]])
"""What stands where something else is expected: some of it of the right type, much too large, small, long or flat."""


def spoilt_bytes(data: bytes, rng: random.Random) -> bytes:
    """The bytes with up to five faults."""
    found = bytearray(data)
    for _ in range(rng.choice((1, 1, 2, 3, 5))):
        at = rng.randrange(len(found) + 1)
        end = min(len(found), at + rng.choice((1, 1, 4, 40, 4000)))
        match rng.randrange(6):
            case 0:
                found[at:end] = b""
            case 1:
                found[at:at] = rng.choice(TOKENS)
            case 2:
                found[at:end] = bytes(rng.randrange(256) for _ in range(min(end - at, 8)))
            case 3:
                found[at:at] = found[at:end] * rng.choice((1, 3))
            case 4:
                found[at:at + 1] = bytes([found[at] ^ 1 << rng.randrange(8)]) if at < len(found) else b""
            case 5:
                del found[at if rng.random() < 0.3 else len(found):]
    return bytes(found)


def spoilt(value: Any, rng: random.Random, faults: int | None = None) -> Any:
    """A copy of a JSON value with a few faults anywhere in it."""
    found = copy.deepcopy(value)
    for _ in range(faults or rng.choice((1, 1, 1, 2, 4))):
        places = list(_places(found))
        if not places:
            return copy.deepcopy(rng.choice(VALUES))
        holder, key = rng.choice(places)
        _spoil(holder, key, rng)
    return found


def _spoil(holder: Any, key: Any, rng: random.Random) -> None:
    old = holder[key]
    match rng.randrange(6):
        case 0:
            del holder[key]
        case 1 if isinstance(old, (int, float)) and not isinstance(old, bool):
            holder[key] = old * rng.choice((-1, 0, 1.001, 10, 1e3, 1e-3, 1e6)) + rng.choice((0, 0.01, -0.3, 5))
        case 2 if isinstance(holder, list):
            holder.insert(key, copy.deepcopy(rng.choice(holder)))
        case 3 if isinstance(old, list) and len(old) > 1:
            rng.shuffle(old)
        case 4 if isinstance(old, str):
            holder[key] = old[:rng.randrange(len(old) + 1)] + rng.choice(("", "_2", "é", " "))
        case _:
            holder[key] = copy.deepcopy(rng.choice(VALUES))


def _places(value: Any) -> list[tuple[Any, Any]]:
    found, stack = [], [value]
    while stack:
        holder = stack.pop()
        keys = holder if isinstance(holder, dict) else range(len(holder)) if isinstance(holder, list) else ()
        for key in keys:
            found.append((holder, key))
            stack.append(holder[key])
    return found
