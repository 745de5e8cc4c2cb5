"""The training curve as a picture beside the weights."""

from pathlib import Path


def place(weights: Path) -> Path:
    """Where the curve of a weights file lies."""
    return weights.with_suffix(".png")


def draw(losses: list[list[float]], weights: Path) -> None:
    """Draw the mean loss at every checkpoint, rows of (step, loss) or (step, loss, loss of rooms held out)."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    figure = Figure(figsize=(6.4, 4.0), dpi=130, layout="constrained")
    axes = figure.subplots()
    step, *lines = zip(*losses, strict=True)
    for line, name in zip(lines, ("learned from, running mean", "held out"), strict=False):
        axes.plot(step, line, marker=".", label=name)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set(xlabel="step", ylabel="loss")
    axes.legend()
    axes.grid(alpha=0.3)
    part = weights.with_suffix(".png.part")
    figure.savefig(part, format="png", metadata={"Software": None})
    part.replace(place(weights))
