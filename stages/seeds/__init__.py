"""Random numbers by name: what a part draws hangs on the seed and on what the part is, not on its place in a batch."""

import hashlib
import json
from collections.abc import Iterable
from typing import cast

from numpy.random import PCG64, Generator, SeedSequence

from apartgen.schemas.plan import Plan


def drawn(seed: int, *names: str) -> Generator:
    """The random numbers of what these names say, e.g. a stage's word and the digest of its plan."""
    return Generator(PCG64(SeedSequence(seed, spawn_key=_key(names))))


def lane(rng: Generator, name: str) -> Generator:
    """A generator of its own for the part of this name; nothing is drawn from `rng`, nor does its state
    matter, so that it is the same lane however often it is asked for.
    """
    source = cast(SeedSequence, rng.bit_generator.seed_seq)
    return Generator(PCG64(SeedSequence(source.entropy, spawn_key=(*source.spawn_key, *_key([name])))))


def plan_digest(home: Plan) -> str:
    """Digest of the plan's part of an apartment: the same for its layout and for all that is made of it."""
    part = home.model_dump(mode="json", include=set(Plan.model_fields))
    return hashlib.sha256(json.dumps(part, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


def _key(names: Iterable[str]) -> list[int]:
    """Eight bytes of each name's digest, as two words."""
    digests = (hashlib.sha256(name.encode("utf-8", "surrogateescape")).digest() for name in names)
    return [int.from_bytes(digest[i:i + 4], "little") for digest in digests for i in (0, 4)]
