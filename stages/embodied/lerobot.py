"""Episodes as a LeRobotDataset, version 3.0: what robots felt of themselves and did, in Parquet tables, no pictures.

Layout and names are those of lerobot's own writer (lerobot 0.4): meta/info.json, meta/stats.json, meta/tasks.parquet,
meta/episodes/chunk-000/file-000.parquet, data/chunk-000/file-000.parquet. Everything is in one file of each kind.
"""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.errors import BadInput
from apartgen.stages.embodied.interact.robot import NAMES
from apartgen.stages.embodied.outcome import RATE, Course

VERSION = "v3.0"
CHUNK, DATA_MB, VIDEO_MB = 1000, 100, 200
"""Files of a chunk, and sizes of files at most, as lerobot has them by default."""
FILE = "chunk-{chunk_index:03d}/file-{file_index:03d}"
FIRST = FILE.format(chunk_index=0, file_index=0)
STATE, AROUND, ACTION = "observation.state", "observation.environment_state", "action"
COUNTED = ("timestamp", "frame_index", "episode_index", "index", "task_index")
QUANTILES = (0.01, 0.1, 0.5, 0.9, 0.99)

Half = Literal["navigation", "interaction"]
POSE = ("x", "y", "heading")
FEATURES: dict[Half, dict[str, tuple[str, ...]]] = {
    "navigation": {STATE: (*POSE, "speed", "turn"), AROUND: tuple(f"goal_{name}" for name in POSE),
                   ACTION: ("speed", "turn")},
    "interaction": {STATE: NAMES, AROUND: ("part", "handle_x", "handle_y", "handle_z"), ACTION: NAMES},
}  # fmt: skip
"""Names of the numbers: m, rad, m/s, rad/s; the world's frame. `turn` is the speed of turning; actions of the
manipulator are its servos' targets, `part` its joint's position."""
ROBOTS: dict[Half, str] = {"navigation": "apartgen_base", "interaction": "apartgen_manipulator"}

Columns = dict[str, NDArray[Any]]
Stats = dict[str, dict[str, list[float]]]


@dataclass(frozen=True)
class Episode:
    """What was asked, in words, of which episode of the benchmark, and how it went."""

    task: str
    id: str
    course: Course


def write(half: Half, episodes: Sequence[Episode], folder: Path) -> list[Path]:
    """The data set of some episodes of one robot, one at least, in a folder; BadInput without pyarrow."""
    _pyarrow()
    tasks = sorted({episode.task for episode in episodes})
    columns = [_columns(half, k, episode, tasks.index(episode.task)) for k, episode in enumerate(episodes)]
    ends = np.cumsum([len(one["index"]) for one in columns])
    for one, end in zip(columns, ends):
        one["index"] += end - len(one["index"])
    whole = {name: np.concatenate([one[name] for one in columns]) for name in columns[0]}
    rows = [_row(k, episode, one, int(end)) for k, (episode, one, end) in enumerate(zip(episodes, columns, ends))]
    listed = {name: [row[name] for row in rows] for name in rows[0]}
    (folder / "meta").mkdir(parents=True)
    return [
        _json(folder / "meta" / "info.json", _info(half, len(episodes), int(ends[-1]), len(tasks))),
        _json(folder / "meta" / "stats.json", _stats(whole)),
        _tasks(folder / "meta" / "tasks.parquet", tasks),
        _table(folder / "meta" / "episodes" / f"{FIRST}.parquet", listed),
        _table(folder / "data" / f"{FIRST}.parquet", whole),
    ]


def _pyarrow() -> Any:
    try:
        import pyarrow
    except ImportError:
        raise BadInput("--lerobot: tables are written by pyarrow; pip install 'apartgen[dataset]'") from None
    return pyarrow


def _columns(half: Half, number: int, episode: Episode, task: int) -> Columns:
    course, n = episode.course, len(episode.course.action)
    rows = {STATE: course.state, AROUND: course.around, ACTION: course.action}
    assert all(np.shape(rows[name]) == (n, len(names)) for name, names in FEATURES[half].items())
    frames = np.arange(n)
    return {
        **{name: np.asarray(rows[name], np.float32) for name in FEATURES[half]},
        "timestamp": (frames / RATE).astype(np.float32), "frame_index": frames,
        "episode_index": np.full(n, number), "index": frames.copy(), "task_index": np.full(n, task),
    }


def _row(number: int, episode: Episode, columns: Columns, end: int) -> dict[str, Any]:
    """What is told of one episode."""
    n = len(columns["index"])
    stats = {f"stats/{name}/{key}": value for name, found in _stats(columns).items() for key, value in found.items()}
    return {
        "episode_index": number, "tasks": [episode.task], "length": n, "apartgen_id": episode.id,
        "data/chunk_index": 0, "data/file_index": 0, "dataset_from_index": end - n, "dataset_to_index": end, **stats,
        "meta/episodes/chunk_index": 0, "meta/episodes/file_index": 0,
    }


def _stats(columns: Mapping[str, NDArray[Any]]) -> Stats:
    """Least, greatest, mean, spread, count and quantiles of each number, as lists."""
    found = {}
    for name, values in columns.items():
        rows = values.reshape(len(values), -1).astype(float)
        known = {"min": rows.min(0), "max": rows.max(0), "mean": rows.mean(0), "std": rows.std(0)}
        known |= {f"q{round(100 * q):02d}": np.quantile(rows, q, axis=0) for q in QUANTILES}
        found[name] = {key: value.tolist() for key, value in known.items()} | {"count": [len(rows)]}
    return found


def _info(half: Half, episodes: int, frames: int, tasks: int) -> dict[str, Any]:
    features: dict[str, dict[str, Any]] = {
        name: {"dtype": "float32", "shape": [len(names)], "names": list(names)}
        for name, names in FEATURES[half].items()}
    features |= {name: {"dtype": "float32" if name == "timestamp" else "int64", "shape": [1], "names": None}
                 for name in COUNTED}
    return {
        "codebase_version": VERSION, "robot_type": ROBOTS[half], "total_episodes": episodes, "total_frames": frames,
        "total_tasks": tasks, "chunks_size": CHUNK, "data_files_size_in_mb": DATA_MB,
        "video_files_size_in_mb": VIDEO_MB, "fps": RATE, "splits": {"train": f"0:{episodes}"},
        "data_path": f"data/{FILE}.parquet", "video_path": None, "features": features,
    }


def _json(path: Path, held: Any) -> Path:
    path.write_text(json.dumps(held, indent=4) + "\n", encoding="utf-8")
    return path


def _table(path: Path, columns: Mapping[str, Any], about: Mapping[str, str] | None = None) -> Path:
    """A Parquet file; rows of numbers are lists of fixed length."""
    pyarrow = _pyarrow()
    from pyarrow import parquet

    arrays = {}
    for name, values in columns.items():
        wide = isinstance(values, np.ndarray) and values.ndim == 2
        arrays[name] = pyarrow.FixedSizeListArray.from_arrays(values.ravel(), values.shape[1]) if wide else (
            pyarrow.array(values))
    path.parent.mkdir(parents=True, exist_ok=True)
    parquet.write_table(pyarrow.table(arrays).replace_schema_metadata(about), path)
    return path


def _tasks(path: Path, tasks: list[str]) -> Path:
    """Numbers of tasks by their words, which lerobot takes for the index of a pandas table."""
    def column(name: str, kind: str, numpy: str) -> dict[str, Any]:
        return {"name": name, "field_name": name, "pandas_type": kind, "numpy_type": numpy, "metadata": None}

    about = {"index_columns": ["task"], "column_indexes": [], "pandas_version": "2.0.0", "columns": [
        column("task_index", "int64", "int64"), column("task", "unicode", "object")]}
    return _table(path, {"task_index": np.arange(len(tasks)), "task": tasks}, {"pandas": json.dumps(about)})
