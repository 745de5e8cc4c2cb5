"""What a robot makes of whole homes, as it was: its floor and ways, how it steers, what it takes hold of."""

import boxes_library as fake
import numpy as np
import pytest
from crowded import crowded
from digests import kept

from apartgen.stages import registry
from apartgen.stages.embodied import base, episodes, floor, goals, instructions, interact, navigate, planner, world
from apartgen.stages.embodied.interact import aim, chains, parts, robot, timing, ways
from apartgen.stages.embodied.pursuit import Pursuit
from apartgen.stages.scene.scene import Scene

pytestmark = pytest.mark.wide

NAMES = ("studio", "kitchen", "bedroom")
STEPS = 400


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """Scenes and their MJCF by name, written when one is asked for."""
    found = {}

    def of(name):
        if name not in found:
            home = kept.home(name) if name in kept.HOMES else crowded(3, name)
            scene = Scene(home, kept.load if name in kept.HOMES else fake.Boxes().of(home).load_asset)
            folder = tmp_path_factory.mktemp(name)
            registry.load("apartgen.stages.export", "mjcf").write(scene, folder)
            found[name] = scene, folder / "mjcf" / "apartment.xml"
        return found[name]
    return of


def surveyed(scene, mjcf):
    return floor.survey(world.build(scene, mjcf, moving=(), fused=True), base.RADIUS, base.HEIGHT)


@pytest.mark.parametrize("name", NAMES)
def test_floors(built, name):
    ground = surveyed(*built(name))
    points = kept.lane("floor", name).uniform(-1, 9, (60, 2))
    kept.same("embodied", f"floor {name}", {
        "clearance": ground.clearance, "open": ground.open, "parts": ground.parts, "costs": planner.costs(ground),
        "beside": ground.beside(points), "near": [ground.near(x, y) for x, y in points.tolist()],
        "cells": planner.cell(ground, points), "start": goals.start(ground),
        "low": floor.survey(world.build(*built(name), moving=(), fused=True), 0.2, 0.4).clearance,
        "above": sorted(floor.above_ground(world.build(*built(name), moving=(), fused=True)))})


@pytest.fixture(scope="module")
def roads(built):
    """From the middle of the free floor, of every home."""
    found = {}
    for name in NAMES:
        ground = surveyed(*built(name))
        rows, columns = np.nonzero(ground.free)
        k = len(rows) // 2
        found[name] = planner.roadmap(ground, (int(rows[k]), int(columns[k])))
    return found


def cells(road, rng, many):
    reached = np.argwhere(road.reached)
    return [(int(row), int(column)) for row, column in reached[rng.integers(len(reached), size=many)]]


@pytest.mark.parametrize("name", NAMES)
def test_ways(built, roads, name):
    road, rng = roads[name], kept.lane("ways", name)
    there = cells(road, rng, 25)
    objects = road.floor.space.plan.objects
    kept.same("embodied", f"ways {name}", {
        "reached": road.reached, "cost": road.cost, "length": road.length,
        "paths": [road.path(goal) for goal in there], "shortest": [road.shortest(goal) for goal in there],
        "limits": [navigate.limit(road.path(goal)) for goal in there],
        "goals": [goals.goals(road.floor, objects, road.reached, np.random.default_rng(k)) for k in range(8)],
        "cut off": goals.goals(road.floor, objects, road.reached & False, rng)})


@pytest.mark.parametrize("name", NAMES)
def test_steering(roads, name):
    """Along ways, without physics: a body that does as it is told, put aside by some centimetres now and then."""
    road, rng = roads[name], kept.lane("steering", name)
    found = []
    for goal in cells(road, rng, 8):
        pursuit = Pursuit(road.floor, road.path(goal), float(rng.uniform(-3, 3)))
        (x, y), yaw, told = pursuit.path[0], float(rng.uniform(-3, 3)), []
        for step in range(STEPS):
            speed, turn, done = pursuit.command(x, y, yaw)
            told.append((speed, turn, pursuit.at, pursuit.turning, pursuit.inching))
            x, y = x + speed * np.cos(yaw) * 0.05, y + speed * np.sin(yaw) * 0.05
            yaw += turn * 0.05
            if step % 37 == 20:
                x, y, yaw = x + rng.normal(0, 0.02), y + rng.normal(0, 0.02), yaw + rng.normal(0, 0.1)
            if done:
                break
        found.append([told, x, y])
    kept.same("embodied", f"steering {name}", {str(k): one for k, one in enumerate(found)})


class Loose:
    """A probe that touches nothing."""

    def loose(self, part):
        return part.category == "bin"

    def hit(self, posture, part, value, hold=None):
        return -1


@pytest.mark.parametrize("name", [*NAMES, "flat"])
def test_parts(built, name):
    """Of all that opens: where it is held, how the hand points, what it costs from some places, what it is called."""
    whole = world.build(*built(name), interact.mjcf())
    rooms = {room.id: room for room in whole.home.rooms}
    found, rng = {}, kept.lane("parts", name)
    for body, link in parts.listed(whole):
        one = parts.part(whole, body, link)
        followed = chains.Chains(Loose(), one)
        turns = followed.turns
        held = [*one.holds, *one.others, *one.pushes]
        stands = [np.array([*(held[0].point[:2] + one.front[:2] * far), rng.uniform(-3, 3)]) for far in (0.5, 0.7)]
        told = {
            "part": one, "lever": one.lever, "moved": [one.at(held[0].point, value) for value in (0.0, one.travel)],
            "said": instructions.instruction(body, link, rooms[body.room]), "values": followed.values, "turns": turns}
        for k, hold in enumerate(held):
            known = [followed.known(stand, hold) for stand in stands]
            told[f"hold {k}"] = [aim.directions(one, hold, turns), followed.grips(hold)[2], [
                [each.able, each.postures[each.able]] for each in known], [
                list(followed.found(stand, hold, start)) for stand in stands for start in (0, 2)]]
        found[f"{body.id} {link.name}"] = told
    kept.same("embodied", f"parts {name}", found)


@pytest.mark.parametrize("name", NAMES)
def test_episodes(built, name):
    kept.same("embodied", f"episodes {name}", {
        "listed": episodes.listed(world.build(*built(name), name=name), kept.lane("episodes", name))})


def test_postures():
    rng, found = np.random.default_rng(4), []
    for _ in range(200):
        turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        turn *= np.sign(np.linalg.det(turn))
        stand, at = rng.uniform(-1, 1, 3), rng.uniform((-1, -1, 0), (1, 1, 2))
        one = robot.posture(stand, at, turn, rng.uniform(0, 0.04), spare=0.01)
        back = None if one is None else ways.withdrawn(one, 0.05)
        many, within = robot.postures(stand, at + rng.normal(0, 0.05, (6, 3)), turn[None].repeat(6, 0), 0.02, 0.01, one)
        found.append([one, back, many[within], within] + ([] if one is None else [
            list(ways.unfolding(stand, one)), list(ways.turning(one, robot.tucked(stand, 0.5, 1.0)))]))
    path = rng.normal(size=(12, 13))
    kept.same("embodied", "postures", {"found": found, "servos": robot.LEAD, "model": robot.mjcf(),
                                       "timed": [timing.timed(path, rng.uniform(0.1, 1, 11), 0.01, ramp)
                                                 for ramp in (0.05, 0.3, 9.0)],
                                       "smoothed": [timing.smoothed(path, width) for width in (1, 3)]})


def test_chains_of_random_layers():
    rng, found = np.random.default_rng(5), []
    for _ in range(60):
        able = rng.random((chains.STEPS + 1, len(aim.OPTIONS))) < rng.uniform(0.05, 0.9)
        prices = np.where(rng.random((chains.STEPS, len(aim.OPTIONS), len(aim.OPTIONS))) < 0.4,
                          rng.integers(0, 4, (chains.STEPS, len(aim.OPTIONS), len(aim.OPTIONS))), np.inf)
        found.append(chains._cheapest(able, prices))
    kept.same("embodied", "chains", {"found": found, "options": [[*one, one.cost] for one in aim.OPTIONS]})
