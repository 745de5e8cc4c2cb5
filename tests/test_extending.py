"""The examples of docs/extending.md, installed as the package they make up and run as they are written there."""

import csv
import json
import math
import os
import re
import shlex
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import trimesh

from apartgen.schemas import plugins

PAGE = (Path(__file__).parent.parent / "docs/extending.md").read_text(encoding="utf-8")
FILES = dict(re.findall(r"```(?:toml|python)\n# (\S+)\n(.*?)```", PAGE, re.DOTALL))
COMMANDS = re.findall(r"```sh\n(.*?)\n```", PAGE, re.DOTALL)
TAPE = """study,3.0,3.2
desk,1.5,2.8,270,0.7,1.4,0.75
office_chair,1.5,2.1,90,0.6,0.6,1.0
bookshelf,0.3,1.5,0,0.3,0.9,1.9
"""


def install(site: Path, files: dict[str, str]) -> Path:
    """A package's files and its entry points, as pip would put them."""
    project = tomllib.loads(files["pyproject.toml"])["project"]
    for name, text in files.items():
        if name != "pyproject.toml":
            (site / name).parent.mkdir(parents=True, exist_ok=True)
            (site / name).write_text(text, encoding="utf-8")
    about = site / f"{project['name'].replace('-', '_')}-{project['version']}.dist-info"
    about.mkdir(parents=True)
    named = f"Name: {project['name']}\nVersion: {project['version']}\n"
    about.joinpath("METADATA").write_text(f"Metadata-Version: 2.1\n{named}")
    points = [f"[{group}]\n" + "".join(f"{name} = {value}\n" for name, value in named.items())
              for group, named in project["entry-points"].items()]
    about.joinpath("entry_points.txt").write_text("\n".join(points))
    return site


def run(line: str, site: Path, folder: Path) -> subprocess.CompletedProcess[str]:
    word, *arguments = shlex.split(line)
    assert word == "apartgen"
    paths = os.pathsep.join([str(site), *os.environ.get("PYTHONPATH", "").split(os.pathsep)])
    env = {**os.environ, "PYTHONPATH": paths.rstrip(os.pathsep), "OMP_NUM_THREADS": "1"}
    return subprocess.run([sys.executable, "-m", "apartgen_cli", *arguments], cwd=folder, env=env, timeout=300,
                          capture_output=True, text=True)


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    return install(tmp_path_factory.mktemp("site"), FILES)


@pytest.fixture(scope="module")
def done(site, tmp_path_factory):
    """The folder in which every command of the page was run, in order."""
    folder = tmp_path_factory.mktemp("work")
    (folder / "rooms").mkdir()
    (folder / "rooms/study.csv").write_text(TAPE)
    (folder / "models").mkdir()
    trimesh.creation.box((300, 900, 1900)).export(folder / "models/bookshelf.stl")
    (folder / "models/chair.stl").write_text("no solid")
    for line in COMMANDS:
        ended = run(line, site, folder)
        assert ended.returncode == 0 and "my-home" not in ended.stderr, f"{line}\n{ended.stderr}"
    return folder


def body(file: Path) -> dict:
    return json.loads(file.read_text(encoding="utf-8"))["body"]


def test_every_kind_of_member_has_its_example():
    groups = set(tomllib.loads(FILES["pyproject.toml"])["project"]["entry-points"])
    told = set(re.findall(r"\| `(apartgen\.[a-z]+)` \|", PAGE))
    assert groups == told and len(COMMANDS) == len(groups)
    assert {group.removeprefix(plugins.PREFIX) for group in told} <= set(plugins.KNOWN)


def test_what_is_installed_is_named_beside_the_version(site, tmp_path):
    own, none = (run("apartgen --version", place, tmp_path).stdout.splitlines() for place in (site, tmp_path))
    assert len(none) == 1 and own[0] == none[0]
    assert own[1] == f"with my-home 1.0: {', '.join(sorted(re.findall(r'`apartgen.([a-z]+)` .', PAGE)[:10]))}"


def test_a_category_is_placed_and_built(done):
    home = body(done / "desk/walkable.json")
    desks = [o for o in home["objects"] if o["category"] == "standing_desk"]
    assert len(desks) == 1 and 0.95 <= desks[0]["size"][2] <= 1.25
    assert desks[0]["asset"]["id"].startswith("standing_desk/") and desks[0]["room"] == "study_1"
    study = [o["category"] for o in home["objects"] if o["room"] == "study_1"]
    assert "desk" not in study and "office_chair" in study, "it comes in the place of what it is like, not beside it"


def test_a_type_of_room_is_planned_and_tells_what_it_is_like(done, site):
    home = body(done / "gym.json")
    room = next(room for room in home["rooms"] if room["id"] == "home_gym_1")
    assert (room["type"], room["like"]) == ("home_gym", "study")
    assert {"room": "home_gym_1", "category": "desk", "count": 0} in home["program"]["objects"]
    for command in ("export gym.json --format svg -o alone/", "layout gym.json -o alone.json"):
        alone = run(f"apartgen {command}", done / "nowhere", done)
        assert alone.returncode == 0, alone.stderr  # whoever lacks the package can read it
    gym = {o["category"] for o in body(done / "alone.json")["objects"] if o["room"] == "home_gym_1"}
    assert {"bench", "mirror", "plant"} <= gym and gym.isdisjoint({"desk", "chair", "office_chair"})


def test_a_style_is_among_those_of_its_category(done, site):
    """It can be shown, and what looks for a desk like it gets it."""
    code = ("from apartgen.stages.retrieve import open_libraries\n"
            "own = open_libraries()\n"
            "like = own.load_asset('parametric', 'desk/trestle/700x1400x750/0')\n"
            "from apartgen.stages.retrieve.shape.encoder import latents\n"
            "print(own.nearest('desk', like.size, latents([like])[0]).id)")
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                           env={**os.environ, "PYTHONPATH": str(site)})
    assert ended.stdout.startswith("desk/trestle/700x1400x750/"), ended.stderr
    assert (done / "desks.png").stat().st_size > 1000


def test_a_style_has_a_tray_that_comes_out(done, site):
    shown = run("apartgen assets show parametric desk/trestle/700x1400x750/0", site, done)
    (joint,) = [link["joint"] for link in json.loads(shown.stdout)["links"] if link["joint"]]
    assert (joint["type"], joint["range"], joint["axis"]) == ("slide", [0.0, 0.3], [1.0, 0.0, 0.0])


def test_a_kind_of_library_is_indexed(done, site):
    """The model has the box of its file, in metres; what cannot be read is left out."""
    listed = run("apartgen assets list --library shelves/", site, done)
    assert listed.stdout == "bookshelf\t0.30 0.90 1.90\tmodels\tbookshelf\n"


def test_a_term_of_choice_is_in_the_balance(done, tmp_path):
    """Without it the desk that was chosen is no nearer to a window."""
    files = FILES | {"pyproject.toml": FILES["pyproject.toml"].replace('bright = "my_home.bright"', "")}
    ended = run("apartgen layout desk/plan.json --candidates 4 -o dull.json", install(tmp_path, files), done)
    assert ended.returncode == 0, ended.stderr
    far = []
    for name in ("bright.json", "dull.json"):
        home = body(done / name)
        panes = [o["segment"] for o in home["openings"] if o["kind"] == "window" and "study_1" in o["rooms"]]
        (desk,) = [o["center"][:2] for o in home["objects"] if o["category"] == "standing_desk"]
        far.append(min(math.dist(desk, [(a + b) / 2 for a, b in zip(*pane)]) for pane in panes))
    assert far[0] <= far[1]


def test_what_has_changed_is_made_again(done, tmp_path):
    """And nothing else: an exporter's code is no part of what is measured."""
    site, line = install(tmp_path, FILES), "apartgen metrics desk/walkable.json --metric seats -o measured/"
    (done / "measured").mkdir()
    for changed, told in (("labels", "wrote"), ("seats", "kept"), ("labels", "wrote")):
        ended = run(line, site, done)
        assert ended.returncode == 0 and f"{told} measured" in ended.stderr, (changed, ended.stderr)
        with (site / f"my_home/{changed}.py").open("a") as file:
            file.write("\nCHANGED = True\n")


def test_a_format_writes_what_the_home_holds(done):
    home = body(done / "desk/walkable.json")
    rows = list(csv.DictReader((done / "labels/labels.csv").open(encoding="utf-8")))
    assert {(row["id"], row["category"], row["room"]) for row in rows} == {
        (o["id"], o["category"], o["room"]) for o in home["objects"]}


@pytest.mark.parametrize("line, told", [
    ("layout desk/plan.json -o out.json", "desk/plan.json: program.objects: wanted in study_1: no category"),
    ("retrieve desk/layout.json -o out.json", r"desk/layout.json: objects\[\d+\].category: no category"),
    ("export desk/walkable.json --format glb -o out/", "desk/walkable.json: no category"),
])
def test_without_the_package_its_category_is_named_and_what_to_do(line, told, done):
    """What only draws boxes does without."""
    ended = run(f"apartgen {line}", done / "nowhere", done)
    assert ended.returncode == 2 and re.match(rf"apartgen: {told} 'standing_desk' is known here", ended.stderr)
    assert "apartgen.categories), install that: `apartgen --version`" in ended.stderr
    assert not (done / line.split()[-1]).exists()


TERM = {"pyproject.toml": '[project]\nname = "my-term"\nversion = "1.0"\n'
                          '[project.entry-points."apartgen.choice"]\nodd = "odd"\n'
                          '[project.entry-points."apartgen.export"]\nplain = "plain"\n',
        "odd.py": '"""Odd."""\n\n\ndef cost(room):\n    return room.site.nothing\n',
        "plain.py": '"""Boxes."""\nNEEDS_ASSETS = False\n\n\ndef write(scene, out):\n    path = out / "plain.txt"\n'
                    '    path.write_text(str(len(scene.home.objects)))\n    return [path]\n'}


def test_a_term_that_fails_ends_the_command_and_is_named(done, tmp_path):
    ended = run("apartgen layout gym.json -o odd.json", install(tmp_path, TERM), done)
    assert ended.returncode == 2 and not (done / "odd.json").exists()
    assert re.match("apartgen: my-term: odd = 'odd': cost failed, AttributeError: .*odd.py:5", ended.stderr)


def test_a_format_that_needs_boxes_alone_takes_a_layout(done, tmp_path):
    """One that needs assets says so."""
    site = install(tmp_path, {name: text.replace("[project.entry-points.\"apartgen.choice\"]\nodd = \"odd\"\n", "")
                              for name, text in TERM.items()})
    ended = run("apartgen export desk/layout.json --format plain -o plain/", site, done)
    assert ended.returncode == 0, ended.stderr
    assert int((done / "plain/plain.txt").read_text()) == len(body(done / "desk/layout.json")["objects"])
    refused = run("apartgen export desk/layout.json --format glb -o none/", site, done)
    assert refused.returncode == 2 and "run `apartgen retrieve` on it first" in refused.stderr


def test_a_metric_counts(done):
    home = body(done / "desk/walkable.json")
    seats = dict.fromkeys(("chair", "office_chair", "stool", "bench", "balcony_chair", "armchair"), 1)
    seats |= {"sofa": 3, "corner_sofa": 3}
    (value,) = body(done / "seats.json")["values"]
    assert value["value"] == sum(seats.get(o["category"], 0) for o in home["objects"]) > 0
    assert value in body(done / "desk/metrics.json")["values"]


def test_a_guidance_energy_acts(done, site):
    ended = run("apartgen layout gym.json --model diffusion --guidance quiet=0 -o loud.json", site, done)
    assert ended.returncode == 0, ended.stderr
    beds = [[o["center"] for o in body(done / name)["objects"] if o["category"].endswith("_bed")]
            for name in ("quiet.json", "loud.json")]
    assert beds[0] and beds[0] != beds[1]


def test_a_source_of_homes_is_trained_on(done):
    import numpy as np

    with np.load(done / "corpus.npz") as file:
        assert file["category"].shape[0] >= 1


BROKEN = {
    "raises.py": ('"""Raises."""\nraise RuntimeError("out of order")\n', "apartgen.export"),
    "bad_syntax.py": ("def write(:\n", "apartgen.export"),
    "lacks.py": ('"""Lacks NEEDS."""\n\n\ndef measure(home, against=None):\n    return []\n', "apartgen.metrics"),
    "fails.py": ('"""Fails."""\nfrom apartgen.schemas.plan import Plan\nNEEDS = Plan\n\n\n'
                 "def measure(home, against=None):\n    return 1 / 0\n", "apartgen.metrics"),
    "gives.py": ('"""Gives a dict."""\n\n\ndef write(scene, out):\n    return {"a": 1}\n', "apartgen.export"),
    "alone.toml": ('[thing]\nsize = [1, 1, 1]\n', "apartgen.categories"),
    "typo.toml": ('[lamp]\nlike = "floor_lamp"\nlumen = 3\n', "apartgen.categories"),
    "torn.toml": ("[lamp\n", "apartgen.categories"),
    "hall.toml": ('[aula]\nlike = "hall"\n', "apartgen.rooms"),
}


@pytest.fixture(scope="module")
def broken(tmp_path_factory):
    """A package of nothing but faults; one module is not even there."""
    groups: dict[str, dict[str, str]] = {"apartgen.guidance": {"gone": "broken.gone"}}
    for name, (_, group) in BROKEN.items():
        stem, _, kind = name.partition(".")
        groups.setdefault(group, {})[stem] = f"broken:{name}" if kind == "toml" else f"broken.{stem}"
    points = "".join(f'[project.entry-points."{group}"]\n' + "".join(f'{k} = "{v}"\n' for k, v in named.items())
                     for group, named in groups.items())
    files = {f"broken/{name}": text for name, (text, _) in BROKEN.items()} | {"broken/__init__.py": ""}
    return install(tmp_path_factory.mktemp("faults"), files | {
        "pyproject.toml": f'[project]\nname = "broken-things"\nversion = "1.0"\n{points}'})


@pytest.mark.parametrize("line, told", [
    ("apartgen export gym.json --format raises -o out/", "broken.raises.*RuntimeError: out of order"),
    ("apartgen export gym.json --format gives -o out/", "broken.gives.*gave a dict, not a list of Path"),
    ("apartgen export gym.json --format bad_syntax -o out/", "no export 'bad_syntax'"),
    ("apartgen metrics gym.json --metric fails -o out.json", "broken.fails.*ZeroDivisionError.*fails.py:7"),
    ("apartgen metrics gym.json --metric lacks -o out.json", "broken.lacks.*has no NEEDS"),
])
def test_what_is_broken_is_named_and_never_a_traceback(line, told, broken, done):
    ended = run(line, broken, done)
    assert ended.returncode == 2 and "Traceback" not in ended.stderr
    assert re.search(rf"apartgen: .*{told}", ended.stderr), ended.stderr
    assert "broken-things" in ended.stderr


def test_what_is_broken_is_left_out_of_the_rest(broken, done):
    """A command that asks for none of it says what is left out, and works."""
    ended = run("apartgen plan studio -o studio.json", broken, done)
    assert ended.returncode == 0, ended.stderr
    for told in ("alone.toml.*needs like", "typo.toml.*lumen", "torn.toml", "hall.toml.*did you mean 'hallway'"):
        assert re.search(f"warning: broken-things: .*{told}", ended.stderr), ended.stderr


THINGS = """[toy_box]
like = "chest"
min = [0.35, 0.6, 0.4]
size = [0.4, 0.8, 0.45]
max = [0.45, 1.0, 0.55]
synonyms = ["toy chest", "crate for dolls", "double bed"]
"""


def test_a_category_is_meant_by_its_name_even_where_that_was_said_of_what_it_is_like(tmp_path):
    points = '[project.entry-points."apartgen.categories"]\nthings = "toys:things.toml"\n'
    site = install(tmp_path / "site", {"toys/things.toml": THINGS, "toys/__init__.py": "", "pyproject.toml":
                                       f'[project]\nname = "toys"\nversion = "1.0"\n{points}'})
    said = {"a toy box": 1, "two toy boxes": 2, "a toy chest": 1, "a crate for dolls": 1}
    for k, (words, count) in enumerate(said.items()):
        ended = run(f'apartgen plan "one-bedroom flat with {words} in the bedroom" -o {k}.json', site, tmp_path)
        assert ended.returncode == 0, ended.stderr
        asked = json.loads((tmp_path / f"{k}.json").read_text())["body"]["program"]["objects"]
        assert [(one["category"], one["count"]) for one in asked] == [("toy_box", count)], words
        assert "'double bed' is said of another category" in ended.stderr
