"""What is known of the tokens of a room that is being furnished: as they stand, and as the scene encoder sees them.

Objects see the shell and what came before them, so what is known of a token stays as it is while others come.
"""

import copy
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations.shape import Shape
from apartgen.stages.layout.relations.tokens import OBJECT, Array, Ints, Shell, solids

S = TypeVar("S", bound=np.generic)


class Memory:
    """Tokens of one room, the shell first: boxes (T, 7), kind, category (T,), swing (T, 2), solid (T, 7) and sort (T,)
    of what they keep others from; of the encoder `keys`, `values` (layers, T, W); `referred` (T, W) and `tells` (T, K)
    as references are asked for, `lies` (J, T, K) how tokens lie to objects; the room's type and facts (3,).

    The first `n` have been seen by the encoder, `fresh` more have not; there is space for T."""

    def __init__(self, shell: Shell, type: int, facts: Array, shape: Shape) -> None:
        self.type, self.facts = type, facts
        self.shell, self.n, self.fresh = len(shell.kind), 0, len(shell.kind)
        most = self.fresh
        self.boxes, self.kind, self.swing = shell.boxes, shell.kind, shell.swing
        self.category = np.full(most, -1)
        self.solid, self.sort = solids(shell.boxes, shell.kind, shell.swing, shell.deep, np.zeros(most, bool))
        self.keys, self.values = (np.zeros((shape.scene_layers, most, shape.width), np.float32) for _ in range(2))
        self.referred, self.tells = np.zeros((most, shape.width), np.float32), np.zeros((most, shape.key), np.float32)
        self.lies = np.zeros((0, most, shape.key), np.float32)

    @property
    def there(self) -> int:
        """How many tokens there are."""
        return self.n + self.fresh

    def with_space(self, objects: int) -> "Memory":
        """A copy in which so many objects find space, and one who asks for the next."""
        other, more = copy.copy(self), objects + 1
        other.boxes, other.solid, other.swing = (_longer(a, more) for a in (self.boxes, self.solid, self.swing))
        other.kind, other.category = _longer(self.kind, more, OBJECT), _longer(self.category, more, -1)
        other.sort = _longer(self.sort, more)
        other.keys, other.values = (_longer(a, more, axis=1) for a in (self.keys, self.values))
        other.referred, other.tells = _longer(self.referred, more), _longer(self.tells, more)
        other.lies = np.zeros((objects, self.there + more, self.tells.shape[1]), np.float32)
        return other

    def add(self, boxes: Array, category: Ints, soft: Array) -> None:
        """Objects (n, 7) stand there from now on; soft ones keep nobody away."""
        some = slice(self.there, self.there + len(boxes))
        self.boxes[some] = self.solid[some] = boxes
        self.category[some], self.sort[some] = category, np.where(soft, 0, 1)
        self.fresh += len(boxes)

    def fresh_pairs(self) -> tuple[Ints, Ints]:
        """Objects and tokens, pairs of which one at least is fresh."""
        new = np.arange(self.there) >= self.n
        j, t = np.nonzero(new[self.shell :, None] | new)
        return j + self.shell, t


def _longer(a: NDArray[S], more: int, fill: float = 0, axis: int = 0) -> NDArray[S]:
    shape = list(a.shape)
    shape[axis] = more
    return np.concatenate([a, np.full(shape, fill, a.dtype)], axis)
