"""Write the episodes that `apartgen bench embodied` runs in an apartment as JSON, for Isaac Sim, Nav2 and a policy.

    python write_episodes.py bench/embodied/homes/guided-12.json -o guided-12.episodes.json

Runs where apartgen is installed, on any retrieve or walkable artifact. What is drawn is drawn from the artifact's own
seed, as the benchmark does; `stages/embodied/episodes.py` says what each field is, in metres, radians and seconds.
"""

import argparse
import json
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from apartgen.schemas import artifact
from apartgen.schemas.errors import ApartgenError
from apartgen.schemas.retrieve import Retrieve
from apartgen_cli.bench.embodied import lane, simulated


def written(path: Path, out: Path, seed: int | None, libraries: list[str]) -> Path:
    """One artifact's episodes as a file; BadInput for what is no furnished apartment."""
    from apartgen.stages import retrieve
    from apartgen.stages.embodied import episodes
    from apartgen.stages.export import mjcf
    from apartgen.stages.retrieve.matching.config import RetrieveConfig
    from apartgen.stages.scene.scene import Scene

    read = artifact.read(path, Retrieve)
    drawn = f"{path.stem}-{read.made.seed if seed is None else seed}"
    scene = Scene(read.body, retrieve.open_libraries(RetrieveConfig(libraries=libraries)).load_asset, shown=False)
    with TemporaryDirectory() as folder:
        mjcf.write(scene, Path(folder))
        apartment = simulated(scene, Path(folder) / "mjcf" / "apartment.xml", path.stem)
        found = episodes.listed(apartment, lane(drawn))
    artifact.write(json.dumps(found.model_dump(), indent=1) + "\n", out)
    return out


def main() -> None:
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("artifact", type=Path, help="a retrieve or walkable artifact")
    asked.add_argument("-o", "--out", type=Path, required=True, help="the file to write")
    asked.add_argument("--seed", type=int, help="in place of the artifact's own")
    asked.add_argument("--library", action="append", default=[], help="folder of an asset library in use")
    given = asked.parse_args()
    try:
        written(given.artifact, given.out, given.seed, given.library)
    except ApartgenError as error:
        sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
