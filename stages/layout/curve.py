"""The training curve as a picture beside the weights."""

from pathlib import Path


def place(weights: Path) -> Path:
    """Where the curve of a weights file lies."""
    return weights.with_suffix(".png")


def draw(losses: list[list[float]], weights: Path) -> None:
    """Draw the mean loss at every checkpoint, rows of (step, loss)."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    figure = Figure(figsize=(6.4, 4.0), dpi=130, layout="constrained")
    axes = figure.subplots()
    axes.plot(*zip(*losses, strict=True), marker=".")
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set(xlabel="step", ylabel="loss, running mean")
    axes.grid(alpha=0.3)
    part = weights.with_suffix(".png.part")
    figure.savefig(part, format="png", metadata={"Software": None})
    part.replace(place(weights))
