"""Thirty homes with furniture sent to five formats and read back: `python there_and_back.py 30`; needs the extra `cad`.

Prints for each format how many homes came back with all rooms, openings and furniture, the least overlap of a room, how
far furniture moved, and CPU seconds a file. RoomPlan has no word for some furniture, which is not counted there.
"""

import logging
import sys
import tempfile
from pathlib import Path
from time import process_time

sys.path.insert(0, str(Path(__file__).parents[3] / "tests"))

from plan.imports import homes, writers  # noqa: E402

from apartgen.schemas.layout import Layout  # noqa: E402
from apartgen.stages import export  # noqa: E402
from apartgen.stages.plan import PlanConfig, imports  # noqa: E402
from apartgen.stages.plan.study import archetypes  # noqa: E402
from apartgen.stages.things.asset import Asset  # noqa: E402

FORMATS = ("sh3d", "ifc", "dxf", "roomplan", "procthor")
FILES = {"sh3d": "home.sh3d", "roomplan": "scan.json", "procthor": "house.json"}


def written(format: str, home: Layout) -> tuple[str, bytes]:
    """A file of a format: by the small writers of the tests, IFC and DXF by our own exports."""
    if format in FILES:
        return FILES[format], getattr(writers, format)(home)
    with tempfile.TemporaryDirectory() as folder:
        export.run(home, [format], Path(folder), lambda library, id: Asset(
            library, id, id, "plain", (1, 1, 1), [], credit=""))
        (path,) = Path(folder).glob(f"*.{format}")
        return path.name, path.read_bytes()


def main(count: int) -> None:
    """The table."""
    logging.getLogger("apartgen").setLevel(logging.ERROR)
    names = list(archetypes())
    given = [homes.furnished(names[i % len(names)], i // len(names)) for i in range(count)]
    print("| format | all back | least IoU of a room | openings missed | furniture lost | moved, mm | CPU s a file |")
    print("|---|---|---|---|---|---|---|")
    for format in FORMATS:
        kept, seconds = [], 0.0
        for home in given:
            file = written(format, home)
            began = process_time()
            back = imports.read(*file, PlanConfig())
            seconds += process_time() - began
            assert back is not None
            kept.append(homes.compared(home, back))
        lost = [[id for id in k.lost if format != "roomplan" or id.split(".")[1][:-2] in writers.APPLE] for k in kept]
        whole = sum(k.iou >= 0.97 and not k.openings and not gone and k.moved < 0.05
                    for k, gone in zip(kept, lost, strict=True))
        print(f"| {format} | {whole} of {count} | {min(k.iou for k in kept):.3f} "
              f"| {sum(len(k.openings) for k in kept)} | "
              f"{sum(map(len, lost))} | {1000 * max(k.moved for k in kept):.1f} | {seconds / count:.2f} |", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 30)
