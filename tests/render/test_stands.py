"""Cameras are in free air: nothing comes nearer to them than a head is wide, and none is within a thing's box."""

from types import SimpleNamespace

import numpy as np
import pytest
from digests import kept
from trimesh import triangles as exact

from apartgen.schemas.carrying import WALL
from apartgen.stages.render import route, stands
from apartgen.stages.render.points import places
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.world import world

HEIGHTS = (1.5, 1.7)
HEAD = 0.25


@pytest.fixture(scope="module", params=kept.HOMES)
def shown(request):
    return world(Scene(kept.home(request.param), kept.load))


def room_about(shown, place):
    """How far the nearest triangle is from a place, up to a metre."""
    corners = shown.every.soup.corners.astype(float)
    near = corners[((corners.min(1) < place + 1) & (corners.max(1) > place - 1)).all(1)]
    points = exact.closest_point(near, np.broadcast_to(place, (len(near), 3)))
    return min(1.0, np.linalg.norm(points - place, axis=1).min(initial=1.0))


def boxed(home, place):
    """Things within whose boxes a place is."""
    found = []
    for o in home.objects:
        c, s = np.cos(o.yaw), np.sin(o.yaw)
        x, y, z = place - np.array(o.center)
        if (np.abs([c * x + s * y, c * y - s * x, z]) < np.array(o.size) / 2).all():
            found.append(o.id)
    return found


def eyes(shown, height):
    return [*(stand.place for stand in stands.best(shown, 12, height, 1.4, (64, 48))),
            *(stand.place for stand in stands.middles(shown, height)), *places(shown, height)]


@pytest.mark.parametrize("height", HEIGHTS)
def test_heads_are_clear_of_everything(shown, height):
    for place in eyes(shown, height):
        assert not boxed(shown.plan, place)
        assert room_about(shown, place) > HEAD - 0.01


def test_nothing_that_hangs_is_stood_in():
    home = kept.home("studio")
    height = 1.5
    first = stands.best(world(Scene(home, kept.load)), 1, height, 1.4, (64, 48))[0].place
    hung = next(o for o in home.objects if o.on is None or o.on != WALL)
    hung = hung.model_copy(update={"id": "hung", "center": (first[0], first[1], height + 0.2 + hung.size[2] / 2)})
    more = home.model_copy(update={"objects": [*home.objects, hung]})
    for place in eyes(world(Scene(more, kept.load)), height):
        assert not boxed(more, place)
        c, s = np.cos(hung.yaw), np.sin(hung.yaw)
        x, y, z = place - np.array(hung.center)
        off = np.maximum(np.abs([c * x + s * y, c * y - s * x, z]) - np.array(hung.size) / 2, 0)
        assert np.linalg.norm(off) > HEAD - 0.01


def test_on_its_way_the_robot_looks_to_where_it_will_be_soon(monkeypatch):
    """Four metres to the east, three to the north, a frame a metre: 80 cm ahead is the same leg, but at the end, where
    it looks on as it came; and 40 cm before the corner it looks to the middle of what cuts it off."""
    corner = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]])
    monkeypatch.setattr(route, "_through", lambda home: corner)
    home = SimpleNamespace(room_at=lambda places: np.zeros(len(places), int))
    looks = [(*stand.place.round(6), stand.yaw) for stand in route.along(home, 8, 0.3)]
    east, north = 0.0, np.pi / 2
    wanted = [(x, 0, 0.3, east) for x in range(4)] + [(4, y, 0.3, north) for y in range(4)]
    assert looks == [pytest.approx(row) for row in wanted]
    assert route.along(home, 36, 0.3)[18].yaw == pytest.approx(np.pi / 4), "at 3.6 m"


def test_views_show_what_opens_rather_than_what_does_not(monkeypatch):
    """Of the same number of views, more things with joints are in sight than where these count as others do."""
    found = {}
    for worth in (1.0, stands.OPENS):
        monkeypatch.setattr(stands, "OPENS", worth)
        for name in kept.HOMES:
            looked_at = world(Scene(kept.home(name), kept.load))
            opens = [any(link.joint for link in body.links) for body in looked_at.bodies if body.kind == "object"]
            chosen = stands.best(looked_at, 4, 1.5, 1.4, (64, 48))
            sights = [stands._judged(looked_at, [stand] * stands.HEADINGS, 1.4, 0.75)[0][heading(stand)]
                      for stand in chosen]
            found[worth] = found.get(worth, 0) + int((np.max(sights, axis=0) > stands.ENOUGH)[opens].sum())
    assert found[stands.OPENS] > found[1.0]


def heading(stand):
    return round(stand.yaw / (2 * np.pi / stands.HEADINGS))
