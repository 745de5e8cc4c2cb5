"""What is seen from a home's windows in a photograph: houses and trees around a meadow. Run within Blender."""

import math

import bpy
import numpy as np
from mathutils import Matrix, Vector, noise

GROUND = -9.0
"""Height of the ground outside, m."""
STREETS, SPACING = (40.0, 180.0), 26.0
"""From where to where there are houses, and how far apart, m; the nearer are lower than eyes are."""
FACES = ((0.62, 0.55, 0.45, 1), (0.5, 0.28, 0.2, 1), (0.72, 0.7, 0.66, 1), (0.55, 0.5, 0.35, 1))
PANE, LEAF = (0.05, 0.06, 0.08, 1), (0.05, 0.1, 0.03, 1)
MEADOW, FIELD = (0.07, 0.11, 0.04, 1), (0.16, 0.16, 0.08, 1)
"""Its colours, that go over into each other within some metres."""


def surroundings(scene):
    """The ground with houses and trees."""
    ground(scene)
    street(scene)


def ground(scene):
    """A plain of meadows and fields below the windows."""
    far = 500.0
    mesh = bpy.data.meshes.new("ground")
    mesh.from_pydata([(-far, -far, GROUND), (far, -far, GROUND), (far, far, GROUND), (-far, far, GROUND)], [],
                     [(0, 1, 2, 3)])
    material = plain("ground", MEADOW)
    surface = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    tree, place = material.node_tree, material.node_tree.nodes.new("ShaderNodeNewGeometry")
    swell, ramp = tree.nodes.new("ShaderNodeTexNoise"), tree.nodes.new("ShaderNodeValToRGB")
    swell.inputs["Scale"].default_value, swell.inputs["Detail"].default_value = 0.03, 8.0
    for stop, (at, color) in zip(ramp.color_ramp.elements, ((0.42, MEADOW), (0.58, FIELD))):
        stop.position, stop.color = at, color
    for source, target in ((place.outputs["Position"], swell.inputs["Vector"]), (swell.outputs[0], ramp.inputs[0]),
                           (ramp.outputs[0], surface.inputs["Base Color"])):
        tree.links.new(source, target)
    mesh.materials.append(material)
    put(scene, "ground", mesh, Matrix())


def street(scene):
    """Houses with rows of windows and trees between them, all around; the same for every home."""
    rng = np.random.default_rng(1)
    blocks = [shape(facade(color), bpy.ops.mesh.primitive_cube_add, lambda at: at + Vector((0, 0, 0.5)), size=1.0)
              for color in FACES]
    crown = shape(plain("leaf", LEAF), bpy.ops.mesh.primitive_ico_sphere_add, lambda at: at * (
        1.0 + 0.35 * noise.noise(at * 2.5) + 0.15 * noise.noise(at * 9.0)), subdivisions=5, radius=1.0)
    near, far = STREETS
    steps = range(-int(far / SPACING), int(far / SPACING) + 1)
    for x, y in ((SPACING * i + rng.uniform(-5, 5), SPACING * j + rng.uniform(-5, 5)) for i in steps for j in steps):
        away = math.hypot(x, y)
        if near < away < far:
            size = rng.uniform(9, 16), rng.uniform(9, 14), rng.uniform(6, 9) + 3 * (away > 2 * near), 1
            put(scene, "house", blocks[int(rng.integers(len(blocks)))],
                Matrix.Translation((x, y, GROUND)) @ Matrix.Diagonal(size))
            for side in (-1, 1):
                tall = rng.uniform(2.0, 3.5)
                at = x + side * rng.uniform(8, 13), y + rng.uniform(-13, 13), GROUND + tall
                put(scene, "tree", crown, Matrix.Translation(at) @ Matrix.Scale(tall, 4))


def shape(material, add, moved, **kind):
    """A mesh that Blender makes, of a material, its vertices moved."""
    add(location=(0, 0, 0), **kind)
    made = bpy.context.object
    mesh = made.data
    bpy.data.objects.remove(made)
    for vertex in mesh.vertices:
        vertex.co = moved(vertex.co)
    mesh.materials.append(material)
    return mesh


def facade(color):
    """A wall's material with windows in rows, a storey of 2.9 m and an axis of 2.6 m."""
    material = plain("facade", color)
    tree = material.node_tree
    surface = next(node for node in tree.nodes if node.type == "BSDF_PRINCIPLED")
    place, parts, along, bricks = (tree.nodes.new(f"ShaderNode{name}")
                                   for name in ("NewGeometry", "SeparateXYZ", "Math", "TexBrick"))
    flat = tree.nodes.new("ShaderNodeCombineXYZ")
    bricks.offset = 0.0
    for name, value in (("Scale", 1.0), ("Brick Width", 2.6), ("Row Height", 2.9), ("Mortar Size", 0.75),
                        ("Mortar Smooth", 0.0), ("Color1", PANE), ("Color2", PANE), ("Mortar", color)):
        bricks.inputs[name].default_value = value
    for source, target in ((place.outputs["Position"], parts.inputs[0]), (parts.outputs[0], along.inputs[0]),
                           (parts.outputs[1], along.inputs[1]), (along.outputs[0], flat.inputs[0]),
                           (parts.outputs[2], flat.inputs[1]), (flat.outputs[0], bricks.inputs["Vector"]),
                           (bricks.outputs["Color"], surface.inputs["Base Color"])):
        tree.links.new(source, target)
    return material


def plain(name, color):
    """A dull material of a colour."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    surface = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    surface.inputs["Roughness"].default_value, surface.inputs["Base Color"].default_value = 1.0, color
    return material


def put(scene, name, data, place):
    """An object of this data in the scene."""
    one = bpy.data.objects.new(name, data)
    scene.collection.objects.link(one)
    one.matrix_world = place
    return one
