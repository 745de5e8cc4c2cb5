"""The networks without torch say what they say with it, whatever else is computed with them and what is remembered."""

import os
import subprocess
import sys
from functools import cache

import numpy as np
import pytest
import torch
from layout.rooms_for_tests import some_rooms
from numpy.typing import NDArray

from apartgen.stages.layout.relations import (
    around,
    clear,
    contents,
    describe,
    infer,
    learning,
    looking,
    pointing,
    trained,
    weights,
)
from apartgen.stages.layout.relations import network as torched
from apartgen.stages.layout.relations.memory import Memory
from apartgen.stages.layout.relations.propose import Speaker
from apartgen.stages.layout.relations.tokens import OBJECT, seen, shell
from apartgen.stages.things.categories import CATEGORIES

CLOSE = 1e-4
Floats = NDArray[np.float32]


@cache
def oracle() -> trained.Model:
    """The shipped weights in the networks that are trained."""
    _, known, _ = weights.load()
    model = trained.Model(weights.load()[0].places.shape, len(known.categories), len(known.types))
    model.load_state_dict(trained.tensors(weights.SHIPPED))
    return model.eval().requires_grad_(False)


class Case:
    """Rooms with a number of objects each, as the oracle has them, padded, and as speakers have them."""

    def __init__(self, seed: int, counts: tuple[int, ...]) -> None:
        self.rng = rng = np.random.default_rng(seed)
        model, known, _ = weights.load()
        rooms = some_rooms(len(counts), seed)
        shells = [shell(rooms, i) for i in range(len(counts))]
        self.speakers = [
            Speaker(model, known, one, int(rooms.type[i]), rng.normal(size=3).astype(np.float32), 2, 3, 4, 3.0)
            for i, one in enumerate(shells)]
        self.objects = [self.things(n) for n in counts]
        self.categories = [rng.integers(len(known.categories), size=n) for n in counts]
        self.shell, self.n = np.array([len(one.kind) for one in shells]), np.array(counts)
        b, t = len(counts), int((self.shell + self.n).max())
        self.batch = of = learning.Batch(
            np.zeros((b, t, 7), np.float32), np.full((b, t), OBJECT), np.full((b, t), -1),
            np.zeros((b, t, 2), np.float32), self.shell, self.n, rooms.type,
            np.stack([one.facts for one in self.speakers]).astype(np.float32),
            rng.integers(len(known.categories), size=(b, 1)), np.zeros((b, 1), np.int64), np.ones((b, 1), bool),
            rng.integers(3, size=(b, 1, len(known.categories))).astype(np.float32), np.zeros((b, t), np.float32))
        for i, one in enumerate(shells):
            s, n = len(one.kind), len(one.kind) + counts[i]
            of.boxes[i, :s], of.kind[i, :s], of.swing[i, :s], of.deep[i, :s] = one
            of.boxes[i, s:n], of.category[i, s:n] = self.objects[i], self.categories[i]
        self.real = np.arange(t)[None] < (self.shell + self.n)[:, None]

    def things(self, n: int) -> Floats:
        low, high = [-2, -2, -3, 0.2, 0.2, 0, 0.3], [2, 2, 3, 1.5, 1.5, 0, 2]
        return self.rng.uniform(low, high, (n, 7)).astype(np.float32)

    def remembered(self, i: int, stages: int) -> Memory:
        """Room i with its objects, which came in so many goes."""
        memory = self.speakers[i].empty.with_space(int(self.n[i]))
        for some in np.array_split(np.arange(self.n[i]), stages):
            memory.add(self.objects[i][some], self.categories[i][some], np.zeros(len(some), bool))
            if stages > 1:
                looking.look(self.speakers[i].model.places, [memory], self.asking(i))
        return memory

    def asking(self, i: int) -> Floats:
        return self.speakers[i].model.places.bag(self.batch.left[i])


def scene(case: Case) -> tuple[Floats, Floats, Floats, Floats]:
    """What the oracle has of tokens, who asks, the next category, and references."""
    network, of = oracle().places, case.batch
    t, b = of.tokens, len(case.n)
    left = torch.from_numpy(of.left)
    mask = learning.scene_mask(case.shell, case.n, t, 1)
    mask[:, t, :t] = torch.from_numpy(case.real)
    view = learning.as_seen(of, seen(of.boxes, np.zeros((b, 7), np.float32)), None, case.real)
    tokens, asking = network.look(view, network.bag(left), mask)
    bodies, sort = learning.solids(of.boxes, of.kind, of.swing, of.deep, np.zeros((b, t), bool))
    known = around.known_of(of.boxes, of.kind, of.category, of.asked, (case.shell + case.n)[:, None], bodies,
                            np.where(case.real, sort, 0))
    refer = network.reference(asking, torch.from_numpy(of.asked), tokens,
                              torched.Known(*map(torch.from_numpy, known)))
    return tuple(a.numpy() for a in (tokens, asking[:, 0], network.next(asking[:, 0]), refer[:, 0]))


@pytest.mark.parametrize("seed, counts", [*enumerate([(0, 0), (1, 0, 7), (3, 12, 5), (24,), (2, 9)])])
def test_scenes_are_those_of_torch(seed: int, counts: tuple[int, ...]) -> None:
    case = Case(seed, counts)
    tokens, asked, following, refer = scene(case)
    places = case.speakers[0].model.places
    memories = [case.remembered(i, 1) for i in range(len(counts))]
    asking = looking.look(places, memories, np.concatenate([case.asking(i) for i in range(len(counts))]))
    assert asking == pytest.approx(asked, abs=CLOSE) and places.next(asking) == pytest.approx(following, abs=CLOSE)
    found = looking.references(places, memories, asking, case.batch.asked[:, 0])
    assert found[case.real] == pytest.approx(refer[case.real], abs=5 * CLOSE, rel=CLOSE)
    assert (found[~case.real] < -1e8).all()
    for i, memory in enumerate(memories):
        referred, tells = places.known(tokens[i, : memory.there])
        assert memory.referred[: memory.there] == pytest.approx(referred, abs=CLOSE)
        assert memory.tells[: memory.there] == pytest.approx(tells, abs=CLOSE)


@pytest.mark.parametrize("seed, counts", [*enumerate([(4, 7), (11, 3, 5)])])
def test_what_is_remembered_changes_nothing(seed: int, counts: tuple[int, ...]) -> None:
    """To the last bit: objects that came one after another, in twos or all at once, alone or with other rooms."""
    case = Case(seed, counts)
    places = case.speakers[0].model.places
    together = [case.remembered(i, 1) for i in range(len(counts))]
    asking = looking.look(places, together, np.concatenate([case.asking(i) for i in range(len(counts))]))
    refer = looking.references(places, together, asking, case.batch.asked[:, 0])
    for i, n in enumerate(counts):
        for stages in (2, n):
            memory = case.remembered(i, stages)
            alone = looking.look(places, [memory], case.asking(i))
            assert np.array_equal(alone[0], asking[i])
            one = looking.references(places, [memory], alone, case.batch.asked[i])
            assert np.array_equal(one[0], refer[i, : memory.there])


def frames(case: Case) -> tuple[Floats, Floats, list[int]]:
    """States and tokens of the oracle, of frames of the rooms' last objects."""
    network, of = oracle().places, case.batch
    at = case.shell + case.n - 1
    frame = of.boxes[np.arange(len(at)), at]
    view = learning.as_seen(of, seen(of.boxes, frame), at, case.real)
    state, tokens = network.view(view, torch.from_numpy(of.asked[:, 0]), torch.from_numpy(of.left[:, 0]))
    return state.numpy(), tokens.numpy(), at.tolist()


@pytest.mark.parametrize("seed, counts", [*enumerate([(0, 0), (1, 0, 7), (3, 12, 5), (24,), (2, 9)])])
def test_frames_are_those_of_torch(seed: int, counts: tuple[int, ...]) -> None:
    case = Case(seed, counts)
    state, tokens, at = frames(case)
    places = case.speakers[0].model.places
    asking = places.ask[case.batch.asked[:, 0]] + places.bag(case.batch.left[:, 0])
    said, found = looking.framed(places, [case.remembered(i, 1) for i in range(len(counts))], np.arange(len(counts)),
                                 np.array(at), asking, case.batch.asked[:, 0])
    assert said == pytest.approx(state, abs=CLOSE)
    for name in infer.POINTING:
        head = oracle().places.get_submodule(name)
        wanted = head.keys(torch.from_numpy(tokens[case.real])).numpy()
        own = places.heads[name]
        assert places.keys(own, found.keys) == pytest.approx(wanted, abs=CLOSE)
    assert np.diff(found.starts).tolist() == (case.shell + case.n).tolist()


@pytest.mark.parametrize("name", ["heading", "gap", *infer.POINTING])
def test_heads_are_those_of_torch(name: str) -> None:
    """The numbers, their pointers, and what is picked of both, with tokens that are padding or are not to be meant."""
    rng = np.random.default_rng(len(name))
    head, places = oracle().places.get_submodule(name), weights.load()[0].places
    own = places.heads[name]
    counts = np.array([5, 1, 9])
    real = np.arange(counts.max())[None] < counts[:, None]
    state = rng.normal(size=(3, places.shape.width)).astype(np.float32)
    keys = rng.normal(size=(3, counts.max(), places.shape.key)).astype(np.float32)
    bins = len(own.bins.bias)
    meets = name in ("along", "across")
    depths = rng.uniform(size=(3, bins, clear.MEETS)).astype(np.float32)
    at = rng.integers(bins, size=(*real.shape, max(own.ways, 1)))
    logits, points = head(*map(torch.from_numpy, (state, keys, at)), torch.from_numpy(depths) if meets else None)
    hidden = own.hidden(state)
    met = np.einsum("rbm,rm->rb", depths, own.counts(hidden)) if meets else np.zeros((0, 0), np.float32)
    found = own.bins(hidden) + met if meets else own(state)
    assert found == pytest.approx(logits.numpy(), abs=5 * CLOSE, rel=CLOSE)
    if not own.ways:
        return
    starts, which = np.append(0, counts.cumsum()), np.arange(counts.sum())
    scores = pointing.scores(own.point(hidden), own.copying(hidden)[:, 0], keys[real], which, starts, own.ways)
    there, chance = rng.random(len(which)) < 0.7, rng.random((3, 50))
    picks = pointing.picked(found, met, scores, own.share, at[real], np.zeros((0, 0), np.float32), there, starts,
                            chance, 1.5, 0.01)
    shown = np.full((*real.shape, own.ways), -1e9, np.float32)
    shown[real] = np.where(there[:, None], points.numpy()[real], -1e9)
    wanted = clear.picked(np.concatenate([logits.numpy(), shown.reshape(3, -1)], 1), chance, 1.5, 0.01)
    first = np.repeat(starts[:-1], 50).reshape(3, 50) * own.ways
    assert np.mean(np.where(picks < bins, picks, picks - first) == wanted) > 0.98  # a chance may lie at an edge


@pytest.mark.parametrize("seed", range(4))
def test_what_is_met_is_what_depths_and_rooms_tell(seed: int) -> None:
    rng = np.random.default_rng(seed)
    rows, tokens = 5, 8
    view = np.concatenate([rng.normal(0, 2, (rows, tokens, 3)), rng.uniform(0.05, 1, (rows, tokens, 2)),
                           np.zeros((rows, tokens, 1)), rng.uniform(0.1, 2, (rows, tokens, 3))], -1).astype(np.float32)
    sort, axis = rng.integers(5, size=(rows, tokens)), rng.integers(2, size=rows)
    half = rng.uniform(0.2, 1, (rows, 2))
    said = describe.Attributes(
        rng.integers(72, size=rows), rng.uniform(0.2, 2, (rows, 3)), rng.integers(5, size=rows),
        rng.integers(60, size=rows), rng.normal(size=rows), np.zeros(rows), np.zeros(rows), np.ones(rows, bool))
    counts = rng.normal(size=(rows, clear.MEETS)).astype(np.float32)
    wanted = np.einsum("rbm,rm->rb", around.Met(view, sort, half).told(said, axis), counts)
    place, reach, unknown = around.standing(said, axis, half)
    first = np.arange(rows) * tokens
    found = clear.met(view.reshape(-1, 9), sort.ravel(), np.stack([first, first + np.where(unknown, 0, tokens)], -1),
                      axis, place, reach, counts, describe.OFFSETS, describe.OFFSET, around.SLACK)
    assert found == pytest.approx(wanted, abs=CLOSE)


@pytest.mark.parametrize("seed", range(3))
def test_contents_are_those_of_torch(seed: int) -> None:
    rng, c = np.random.default_rng(seed), len(CATEGORIES)
    facts = rng.normal(size=contents.FACTS).astype(np.float32)
    so_far, wanted, left = rng.integers(12, size=(6, c)), rng.integers(-1, 4, size=(6, c)), rng.integers(-1, 30, size=6)
    found = oracle().contents(
        torch.full((6,), seed), torch.from_numpy(facts).expand(6, -1), torch.from_numpy(so_far).float(),
        torch.from_numpy(left), torch.from_numpy(wanted).float())
    network = weights.load()[0].contents
    rows = np.where(left < 0, len(network.left) - 1, np.minimum(left, len(network.left) - 2))
    x = network.begun(seed, facts, contents.reached(so_far, 1), contents.reached(wanted, 0))
    own = network.following(x, rows)
    assert own == pytest.approx(found.numpy(), abs=CLOSE, rel=1e-5)


@pytest.mark.parametrize("seed", range(4))
def test_contents_that_grew_are_those_that_are_counted_anew(seed: int) -> None:
    rng, network = np.random.default_rng(seed), weights.load()[0].contents
    facts, n = rng.normal(size=contents.FACTS).astype(np.float32), 3
    so_far, wanted = np.zeros((n, len(CATEGORIES)), np.int64), rng.integers(-1, 12, size=(n, len(CATEGORIES)))
    x = network.begun(seed, facts, contents.reached(so_far, 1), contents.reached(wanted, 0))
    some = rng.integers(len(CATEGORIES), size=3)
    for _ in range(36):
        rows = np.flatnonzero(rng.random(n) < 0.7)
        category = rng.choice(some, size=len(rows))
        network.one_more(x, rows, category, so_far[rows, category], wanted[rows, category], contents.UP_TO)
        so_far[rows, category] += 1
        wanted[rows, category] -= wanted[rows, category] > 0
    anew = network.begun(seed, facts, contents.reached(so_far, 1), contents.reached(wanted, 0))
    assert x == pytest.approx(anew, abs=CLOSE) and so_far.max() > contents.UP_TO


@pytest.mark.parametrize("rows, width, out", [(1, 128, 401), (7, 11, 64), (8, 74, 5), (21, 3, 32), (0, 8, 8)])
def test_a_row_is_the_same_in_any_company(rows: int, width: int, out: int) -> None:
    rng = np.random.default_rng(rows)
    x, weight, bias = (rng.normal(size=n).astype(np.float32) for n in ((rows, width), (width, out), (out,)))
    layer = infer.Linear(weight, bias)
    found = layer(x)
    assert found == pytest.approx(x.astype(float) @ weight + bias, abs=CLOSE)
    assert all(np.array_equal(layer(x[k : k + 1])[0], found[k]) for k in range(rows))


CODE = """
import sys; sys.path.insert(0, "tests")
import handmade, numpy as np
from apartgen.stages import layout
from apartgen.stages.layout.config import LayoutConfig
print(layout.run(handmade.plan(), LayoutConfig(candidates=1), np.random.default_rng(1)).objects)
assert "torch" not in sys.modules
"""


def test_threads_change_nothing_and_nobody_needs_torch() -> None:
    """In processes of their own, as threads are counted when numpy is imported."""
    names = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "NUMBA_NUM_THREADS")
    made = [subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, timeout=240,
                           env=os.environ | dict.fromkeys(names, threads)) for threads in ("1", "2")]
    assert all(one.returncode == 0 for one in made), made[0].stderr + made[1].stderr
    assert made[0].stdout == made[1].stdout and "Box(" in made[0].stdout


def test_a_head_that_is_not_told_what_is_met_takes_it_that_nothing_is() -> None:
    head, shape = oracle().places.get_submodule("along"), weights.load()[0].places.shape
    state, keys = torch.linspace(-1, 1, shape.width)[None], torch.linspace(-1, 1, 2 * shape.key).view(1, 2, shape.key)
    at = torch.arange(2 * head.ways).view(1, 2, head.ways)
    nothing = torch.zeros(1, len(head.bins.bias), clear.MEETS)
    for told, wanted in zip(head(state, keys, at), head(state, keys, at, nothing)):
        assert torch.equal(told, wanted)
