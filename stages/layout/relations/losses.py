"""What the relations model is told off for: -log p of what furnished rooms hold, and of where it stands."""

from dataclasses import fields, is_dataclass, replace
from typing import TypeVar

import torch
from torch import Tensor

from apartgen.stages.layout.relations.features import SHUT_OUT
from apartgen.stages.layout.relations.learning import Asked, Frames, Scene
from apartgen.stages.layout.relations.network import Head, Relations

T = TypeVar("T")
cross = torch.nn.functional.cross_entropy


def onto(told: T, device: str) -> T:
    """The same, its tensors on a device: a dataclass or list of tensors and of such."""
    if device == "cpu":
        return told
    if isinstance(told, Tensor):
        return told.to(device, non_blocking=True)  # type: ignore[return-value]
    if isinstance(told, list):
        return [onto(one, device) for one in told]  # type: ignore[return-value]
    if is_dataclass(told) and not isinstance(told, type):
        return replace(told, **{field.name: onto(getattr(told, field.name), device) for field in fields(told)})
    return told


def scene(network: Relations, of: Scene) -> dict[str, Tensor]:
    """Cross-entropy of the next category and of its reference, a mean over objects."""
    tokens, asking = network.look(of.view, network.bag(of.left), of.mask)
    logits = network.next(asking).float().masked_fill(of.left == 0, SHUT_OUT)[of.there]
    refer = network.reference(asking, of.asked.clamp_min(0), tokens, of.known)
    refer = refer.masked_fill(~of.before, SHUT_OUT)[of.told]
    return {"next": cross(logits, of.asked[of.there]), "refer": cross(refer, of.reference)}


def frames(network: Relations, of: Frames) -> dict[str, Tensor]:
    """-log p of every attribute, each given those before it, a mean over those who have it."""
    state, tokens = network.view(of.view, of.category, of.left)
    heads = {f"size {k}": head for k, head in enumerate(network.of_size)} | {
        name: getattr(network, name) for name in ("heading", "side", "low", "gap", "along", "across")}
    out = dict[str, Tensor]()
    for asked in of.asked:
        extra = None if asked.same is None else network.same[int(asked.name[-1])] * asked.same
        out[asked.name] = _attribute(heads[asked.name], state, tokens, asked, extra)
        if asked.name not in ("along", "across"):  # the last that is said
            own = heads[asked.name].own(asked.bins)
            state = state + own * asked.told.to(own.dtype)
    return out


def _attribute(head: Head, state: Tensor, tokens: Tensor, asked: Asked, extra: Tensor | None) -> Tensor:
    """Mean -log p of the wanted bins, or of pointers at tokens that have the same value."""
    if asked.at is None or asked.match is None or asked.real is None:
        return cross(head(state[asked.rows], depths=asked.depths)[0], asked.wanted)
    logits, points = head(state[asked.rows], head.keys(tokens[asked.rows]), asked.at, asked.depths)
    points = points if extra is None else points + extra
    points = points.masked_fill(~asked.real, SHUT_OUT)
    hit = points.masked_fill(~(asked.match & asked.real), SHUT_OUT).flatten(1)
    whole = torch.cat([logits, points.flatten(1)], 1).logsumexp(1)
    right = torch.cat([logits.gather(1, asked.wanted[:, None]), hit], 1).logsumexp(1)
    return (whole - right).mean()
