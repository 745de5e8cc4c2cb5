"""What Blender is given to do: photographs of a home by path tracing. Run by a Python that has bpy, never imported.

    python _cycles.py JOB.json
    blender -b -P _cycles.py -- JOB.json

JOB has `glb`, `out`, `views` (name, pose, fx, width, height), `sun` (the way to it), `panes` (corner, across, up and
normal of each window), `uneven` (what materials are of that are not quite flat), `lamps` (their names), `shades` (what
they have that light goes through), `samples` and `threads`.
"""

import json
import math
import sys
import tempfile
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix, Vector

sys.path.insert(0, str(Path(__file__).parent))
from _outside import put, surroundings

SUN, SKY, LAMPS = 4.0, 1.0, 15.0
"""Sunlight, W/m²; how bright the sky is; how much brighter than their lumens lamps are, as by day one turns them up."""
EDGE = 0.002
"""Radius of edges, m."""
GLOW, RIM = 1.1, 0.45
"""How bright what gives light is in the photograph, by the middle, and what of that is left where it is seen aslant."""
THROUGH = 0.6
"""Share of what falls on a lampshade that goes on through it."""
GLASS = 1.45
"""Index of refraction of window panes."""
OUTSIDE = 0.25
"""How much of the light outside a picture shows, as one put together of two, for the room and for its windows."""
UNEVEN = {"plaster": ((1.3, 0.001), (60.0, 0.0003)), "cloth": ((5.0, 0.008), (19.0, 0.003)),
          "bedding": ((4.0, 0.016), (11.0, 0.006), (31.0, 0.002))}
"""Swells of surfaces: how many a metre, and how deep they are, m."""
MIDDLE = 0.2
"""What the median of a photograph is exposed to."""
STOPS = (-3.0, 6.0)
SMALL = 6
"""A picture for the exposure is so many times smaller."""


def built(job):
    """The home with its light; all that was there is taken away."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=job["glb"])
    scene = bpy.context.scene
    for one in (one for one in scene.objects if one.type == "LIGHT"):
        one.data.energy *= LAMPS
        one.data.shadow_soft_size = 0.06
    for material in bpy.data.materials:
        finished(material, UNEVEN.get(job["uneven"].get(material.name.partition(".")[0]), ()))
    shades = {name: lit_through(bpy.data.materials[name]) for name in job["shades"] if name in bpy.data.materials}
    for one in (one for one in scene.objects if one.name.partition(".")[0] in job["lamps"]):
        for slot in (slot for slot in one.material_slots if slot.material and slot.material.name in shades):
            slot.link, slot.material = "OBJECT", shades[slot.material.name]
    for material in bpy.data.materials:
        glowing(material)
    sky(scene, Vector(job["sun"]))
    for k, pane in enumerate(job["panes"]):
        portal(scene, f"portal_{k}", *(Vector(v) for v in pane))
    surroundings(scene)
    return scene


def finished(material, swells):
    """Glass of windows lets light through undimmed but for what it mirrors; all else has edges that catch light, and
    swells.
    """
    tree = material.node_tree
    surface = next((node for node in tree.nodes if node.type == "BSDF_PRINCIPLED"), None) if tree else None
    if surface is None:
        return
    if material.name.partition(".")[0] == "window_glass":
        output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
        clear, mirror, mixed, share = (tree.nodes.new(f"ShaderNode{name}")
                                       for name in ("BsdfTransparent", "BsdfGlossy", "MixShader", "Fresnel"))
        mirror.inputs["Roughness"].default_value = 0.02
        sides, seen = tree.nodes.new("ShaderNodeNewGeometry"), tree.nodes.new("ShaderNodeLightPath")
        within, dimmed = tree.nodes.new("ShaderNodeMapRange"), tree.nodes.new("ShaderNodeMapRange")
        # what leaves a pane goes on straight, and is never mirrored as a whole, as it would be from within glass
        within.inputs["To Min"].default_value, within.inputs["To Max"].default_value = GLASS, 1 / GLASS
        dimmed.inputs["To Min"].default_value, dimmed.inputs["To Max"].default_value = 1.0, OUTSIDE ** 0.5
        for source, target in (
                (sides.outputs["Backfacing"], within.inputs["Value"]), (within.outputs[0], share.inputs["IOR"]),
                (seen.outputs["Is Camera Ray"], dimmed.inputs["Value"]), (dimmed.outputs[0], clear.inputs["Color"]),
                (share.outputs[0], mixed.inputs[0]), (clear.outputs[0], mixed.inputs[1]),
                (mirror.outputs[0], mixed.inputs[2]), (mixed.outputs[0], output.inputs[0])):
            tree.links.new(source, target)
    elif not surface.inputs["Normal"].is_linked:
        edge = tree.nodes.new("ShaderNodeBevel")
        edge.samples, edge.inputs["Radius"].default_value = 4, EDGE
        tree.links.new(swollen(tree, edge.outputs[0], swells), surface.inputs["Normal"])


def glowing(material):
    """What gives light is as bright as its node `glow` says, less towards its rim."""
    tree = material.node_tree
    surface = next((node for node in tree.nodes if node.type == "BSDF_PRINCIPLED"), None) if tree else None
    if surface is None or not surface.inputs["Emission Strength"].default_value or not any(
            surface.inputs["Emission Color"].default_value[:3]):
        return
    aslant, fallen, glow, both = (tree.nodes.new(f"ShaderNode{name}") for name in (
        "LayerWeight", "MapRange", "Value", "Math"))
    fallen.inputs["To Min"].default_value, fallen.inputs["To Max"].default_value = 1.0, RIM
    glow.name, both.operation = "glow", "MULTIPLY"
    for source, target in ((aslant.outputs["Facing"], fallen.inputs["Value"]), (fallen.outputs[0], both.inputs[0]),
                           (glow.outputs[0], both.inputs[1]), (both.outputs[0], surface.inputs["Emission Strength"])):
        tree.links.new(source, target)


def exposed(scene, stops):
    """A picture's exposure; what gives light is as bright in all."""
    scene.view_settings.exposure = stops
    for node in (node for material in bpy.data.materials if material.node_tree for node in material.node_tree.nodes
                 if node.name == "glow"):
        node.outputs[0].default_value = GLOW / 2**stops


def lit_through(material):
    """A copy of a lampshade's material that glows by the light within and not by itself."""
    shade = material.copy()
    tree = shade.node_tree
    surface = next(node for node in tree.nodes if node.type == "BSDF_PRINCIPLED")
    output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    surface.inputs["Emission Strength"].default_value = 0.0
    behind, mixed = tree.nodes.new("ShaderNodeBsdfTranslucent"), tree.nodes.new("ShaderNodeMixShader")
    mixed.inputs[0].default_value = THROUGH
    color = surface.inputs["Base Color"]
    behind.inputs[0].default_value = color.default_value
    links = [(surface.outputs[0], mixed.inputs[1]), (behind.outputs[0], mixed.inputs[2]),
             (mixed.outputs[0], output.inputs[0]), *((link.from_socket, behind.inputs[0]) for link in color.links)]
    for source, target in links:
        tree.links.new(source, target)
    return shade


def swollen(tree, normal, swells):
    """A normal that noise turns: of every swell its number a metre and its depth."""
    place = tree.nodes.new("ShaderNodeNewGeometry")
    for often, deep in swells:
        swell, bump = tree.nodes.new("ShaderNodeTexNoise"), tree.nodes.new("ShaderNodeBump")
        swell.inputs["Scale"].default_value, swell.inputs["Detail"].default_value = often, 3.0
        bump.inputs["Distance"].default_value = deep
        tree.links.new(place.outputs["Position"], swell.inputs["Vector"])
        tree.links.new(swell.outputs[0], bump.inputs["Height"])
        tree.links.new(normal, bump.inputs["Normal"])
        normal = bump.outputs[0]
    return normal


def sky(scene, way):
    """A clear sky, and the sun in it."""
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    tree = scene.world.node_tree
    background = next(node for node in tree.nodes if node.type == "BACKGROUND")
    texture = tree.nodes.new("ShaderNodeTexSky")
    texture.sun_elevation, texture.sun_rotation, texture.sun_disc = math.asin(way.z), math.atan2(way.x, way.y), False
    tree.links.new(texture.outputs[0], background.inputs[0])
    background.inputs[1].default_value = SKY
    light = bpy.data.lights.new("sun", "SUN")
    light.energy, light.angle, light.color = SUN, math.radians(0.53), (1.0, 0.95, 0.88)
    put(scene, "sun", light, way.to_track_quat("Z", "Y").to_matrix().to_4x4())


def portal(scene, name, corner, across, up, normal):
    """Where light comes in, so that it is looked for there."""
    light = bpy.data.lights.new(name, "AREA")
    light.shape, light.size, light.size_y, light.cycles.is_portal = "RECTANGLE", across.length, up.length, True
    x, z = across.normalized(), -normal
    place = Matrix((x, z.cross(x), z)).transposed().to_4x4()
    place.translation = corner + (across + up) / 2
    put(scene, name, light, place)


def set_up(scene, job):
    """How Cycles works: on the processor, with its denoiser, the same for the same job."""
    scene.render.engine, cycles = "CYCLES", scene.cycles
    cycles.device, cycles.seed, cycles.use_denoising = "CPU", 0, True
    cycles.max_bounces, cycles.diffuse_bounces, cycles.transparent_max_bounces = 8, 5, 12
    cycles.sample_clamp_indirect, cycles.caustics_reflective, cycles.caustics_refractive = 4.0, False, False
    scene.render.threads_mode, scene.render.threads = "FIXED", job["threads"]
    scene.view_settings.view_transform, scene.view_settings.look = "AgX", "AgX - Medium High Contrast"


def rendered(scene, size, samples, form, file):
    """One picture into a file."""
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.cycles.samples, scene.render.image_settings.file_format = samples, form
    scene.render.image_settings.color_depth = "8" if form == "PNG" else "32"
    scene.render.filepath = str(file)
    bpy.ops.render.render(write_still=True)


def exposure(scene, size, folder):
    """Stops by which a small picture's median is lifted to the middle."""
    file = folder / "meter.exr"
    rendered(scene, [max(16, side // SMALL) for side in size], 16, "OPEN_EXR", file)
    image = bpy.data.images.load(str(file))
    light = np.array(image.pixels[:]).reshape(-1, image.channels)[:, :3] @ [0.2126, 0.7152, 0.0722]
    bpy.data.images.remove(image)
    return float(np.clip(np.log2(MIDDLE / max(float(np.median(light)), 1e-4)), *STOPS))


def main(job):
    """A photograph of each view."""
    scene = built(job)
    set_up(scene, job)
    camera = bpy.data.cameras.new("camera")
    camera.clip_start, camera.sensor_width = 0.02, 36.0
    scene.camera = put(scene, "camera", camera, Matrix())
    with tempfile.TemporaryDirectory() as folder:
        for view in job["views"]:
            size = view["width"], view["height"]
            scene.camera.matrix_world = Matrix(view["pose"]) @ Matrix.Diagonal((1, -1, -1, 1))
            camera.lens = view["fx"] / view["width"] * camera.sensor_width
            exposed(scene, 0.0)  # metered as if it were the first
            exposed(scene, exposure(scene, size, Path(folder)))
            rendered(scene, size, job["samples"], "PNG", Path(job["out"]) / f"{view['name']}.photo.png")


if __name__ == "__main__":
    main(json.loads(Path(sys.argv[-1]).read_text(encoding="utf-8")))
