"""Script for Blender: renders a frame of a simreel scene with Cycles, with as many bounces as render.quality "high".
blender -b --python scene.py -- SCENE.json FOLDER PICTURE.png SAMPLES; FOLDER holds the files of `simreel bake` for the
frame. SAMPLES 0: draws each object unlit in the colour flat_color(number), with numbers from 1 and 0 for the ground,
for comparing positions. carried.py lists the parts of a scene that are transferred."""
import array
import json
import math
import pathlib
import struct
import sys

import bpy
from mathutils import Euler, Vector

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from carried import flat_color, is_baked, refusals  # noqa: E402

ASSETS = pathlib.Path(__file__).resolve().parents[2] / "assets"


def place(p):
    """Converts a point from y-up to z-up coordinates."""
    return Vector((p[0], -p[2], p[1]))


def math_node(nodes, links, operation, first, second=None, clamp=False):
    node = nodes.new("ShaderNodeMath")
    node.operation = operation
    node.use_clamp = clamp
    for i, value in enumerate((first, second)):
        if isinstance(value, (int, float)):
            node.inputs[i].default_value = value
        elif value is not None:
            links.new(value, node.inputs[i])
    return node.outputs[0]


def picture_of(name, folder):
    return bpy.data.images.load(str(next(f for f in (folder / name, ASSETS / name) if f.exists())))


def times(nodes, links, color, texture):
    product = nodes.new("ShaderNodeMixRGB")
    product.blend_type = "MULTIPLY"
    product.inputs["Fac"].default_value = 1
    product.inputs["Color1"].default_value = color
    links.new(texture, product.inputs["Color2"])
    return product.outputs[0]


def material(name, given, folder):
    """Makes a material: a GGX lobe of F0 0.04 over a diffuse surface that receives the energy the lobe leaves
    (glsl/draw/exact/rays/facet.glsl); for a metal only the lobe. The v coordinate of a texture starts at the bottom, as
    in baked files."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    color = (*given.get("color", [0.8, 0.7, 0.6]), 1)
    r = given.get("roughness", 0.8)
    metal = given.get("metallic", 0) == 1
    out = nodes.new("ShaderNodeOutputMaterial")
    lobe = nodes.new("ShaderNodeBsdfPrincipled")
    lobe.distribution = "GGX"
    lobe.inputs["Roughness"].default_value = r
    lobe.inputs["Metallic"].default_value = float(metal)
    lobe.inputs["Specular"].default_value = 0.5
    lobe.inputs["Base Color"].default_value = color if metal else (0, 0, 0, 1)
    textured = None
    if given.get("texture"):
        texture = nodes.new("ShaderNodeTexImage")
        texture.image = picture_of(given["texture"], folder)
        textured = times(nodes, links, color, texture.outputs["Color"])
    if metal:
        if textured:
            links.new(textured, lobe.inputs["Base Color"])
        links.new(lobe.outputs[0], out.inputs["Surface"])
        return made
    facing = nodes.new("ShaderNodeLayerWeight")
    facing.inputs["Blend"].default_value = 0.5
    # ambientLobe() of glsl/draw/surface/shading.glsl is 1 - (0.04 x + y).
    alpha = r * r

    def node(operation, first, second=None, clamp=False):
        return math_node(nodes, links, operation, first, second, clamp)

    tilt = facing.outputs["Facing"]
    cosine = node("SUBTRACT", 1.0, tilt)
    tilt2 = node("MULTIPLY", tilt, tilt)
    over = node("MULTIPLY", node("MULTIPLY", tilt2, tilt), node("ADD", tilt2, 0.473 * r))
    white = node("DIVIDE", over, node("ADD", node("MULTIPLY", tilt2, 12.16 * alpha), 1 + 25.46 * alpha * alpha))
    line = node("ADD", node("MULTIPLY", cosine, -4.156 + 10.618 * r - 6.316 * alpha), 2.607 - 5.241 * r + 3.265 * alpha)
    hidden = node("DIVIDE", node("MULTIPLY", node("MULTIPLY", cosine, alpha), line), node("ADD", cosine, 0.1419 * alpha + 1e-6))
    colored = node("SUBTRACT", node("SUBTRACT", 1.0, node("MAXIMUM", hidden, 0.0)), white)
    kept = node("SUBTRACT", node("SUBTRACT", 1.0, white), node("MULTIPLY", colored, 0.04), clamp=True)
    tint = nodes.new("ShaderNodeMixRGB")
    tint.inputs["Color1"].default_value = (0, 0, 0, 1)
    tint.inputs["Color2"].default_value = color
    if textured:
        links.new(textured, tint.inputs["Color2"])
    links.new(kept, tint.inputs["Fac"])
    below = nodes.new("ShaderNodeBsdfDiffuse")
    links.new(tint.outputs[0], below.inputs["Color"])
    matt = below.outputs[0]
    if given.get("translucency", 0) > 0:
        through, parts = nodes.new("ShaderNodeBsdfTranslucent"), nodes.new("ShaderNodeMixShader")
        links.new(tint.outputs[0], through.inputs["Color"])
        parts.inputs["Fac"].default_value = given["translucency"]
        links.new(matt, parts.inputs[1])
        links.new(through.outputs[0], parts.inputs[2])
        matt = parts.outputs[0]
    both = nodes.new("ShaderNodeAddShader")
    links.new(matt, both.inputs[0])
    links.new(lobe.outputs[0], both.inputs[1])
    links.new(both.outputs[0], out.inputs["Surface"])
    return made


def flat(number):
    """Makes a material of constant colour, independent of lights."""
    made = bpy.data.materials.new("flat")
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    shine, out = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    shine.inputs["Color"].default_value = (*flat_color(number), 1)
    links.new(shine.outputs[0], out.inputs["Surface"])
    return made


def sphere_rows(radius, length):
    """Yields the profile of a sphere, or of a capsule along y with `length` between the centres of its caps: (radius,
    y, cosine and sine of the normal's slope)."""
    half = 64
    for i in range(half + 1):
        angle = -math.pi / 2 + math.pi / 2 * i / half
        yield radius * math.cos(angle), radius * math.sin(angle) - length / 2, math.cos(angle), math.sin(angle)
    for i in range(0 if length > 0 else 1, half + 1):
        angle = math.pi / 2 * i / half
        yield radius * math.cos(angle), radius * math.sin(angle) + length / 2, math.cos(angle), math.sin(angle)


def turned_solid(given, length):
    """Returns vertices, normals and faces of a solid of revolution in the scene's space, with enough segments to look
    round."""
    rows, around = list(sphere_rows(given.get("radius", 1), length)), 256
    turn = Euler([math.radians(a) for a in given.get("rotation", (0, 0, 0))], "XYZ").to_matrix()
    middle = Vector(given.get("position", (0, 0, 0)))
    places, normals = [], []
    for r, y, flat_part, up in rows:
        for j in range(around):
            c, s = math.cos(2 * math.pi * j / around), math.sin(2 * math.pi * j / around)
            places.append(turn @ Vector((r * c, y, r * s)) + middle)
            normals.append(turn @ Vector((flat_part * c, up, flat_part * s)))
    faces = []
    for i in range(len(rows) - 1):
        for j in range(around):
            a, b = i * around + j, i * around + (j + 1) % around
            faces.append((a, a + around, b + around, b))
    return places, normals, None, faces


def baked(file):
    """Returns vertices, normals, uv and triangles of a PLY file written by simreel bake."""
    data = file.read_bytes()
    head, end = data.split(b"end_header\n")[0].decode(), data.index(b"end_header\n") + len(b"end_header\n")
    lines = [line.split() for line in head.splitlines()]
    assert ["format", "binary_little_endian", "1.0"] in lines, file
    vertices, count = (int(next(line[2] for line in lines if line[:2] == ["element", name])) for name in ("vertex", "face"))
    names = [line[2] for line in lines if line[0] == "property" and line[1] == "float"]
    numbers = array.array("f", data[end:end + 4 * len(names) * vertices])
    at = {name: numbers[i::len(names)] for i, name in enumerate(names)}
    faces = [row[1:] for row in struct.iter_unpack("<B3I", data[end + 4 * len(numbers):])]
    assert len(faces) == count, file
    uv = list(zip(at["s"], at["t"])) if "s" in at else None
    return list(zip(at["x"], at["y"], at["z"])), list(zip(at["nx"], at["ny"], at["nz"])), uv, faces


def add_mesh(name, places, normals, uv, faces):
    """Adds a mesh with the scene's own normals, instead of normals computed by Blender."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([place(p) for p in places], [], faces)
    mesh.polygons.foreach_set("use_smooth", [True] * len(faces))
    if uv:
        layer = mesh.uv_layers.new()
        layer.data.foreach_set("uv", [x for face in faces for i in face for x in uv[i]])
    mesh.use_auto_smooth = True
    mesh.normals_split_custom_set_from_vertices([place(n).normalized() for n in normals])
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(thing)
    return thing


def sky(given, folder):
    """Sets the sky. A picture's middle points towards -z before rotation, and towards +x in Blender. Without a picture,
    the gradient of glsl/draw/sky.glsl: from zenith to horizon by (1 - y)^6, below the horizon to the ground's colour
    within a third."""
    world = bpy.data.worlds.new("sky")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    nodes.clear()
    where = nodes.new("ShaderNodeTexCoord")
    light, out = nodes.new("ShaderNodeBackground"), nodes.new("ShaderNodeOutputWorld")
    links.new(light.outputs[0], out.inputs["Surface"])
    if "picture" in given:
        turned, seen = nodes.new("ShaderNodeMapping"), nodes.new("ShaderNodeTexEnvironment")
        turned.inputs["Rotation"].default_value = (0, 0, math.radians(given.get("turn", 0) - 90))
        seen.image = picture_of(given["picture"], folder)
        links.new(where.outputs["Generated"], turned.inputs["Vector"])
        links.new(turned.outputs["Vector"], seen.inputs["Vector"])
        links.new(seen.outputs["Color"], light.inputs["Color"])
        light.inputs["Strength"].default_value = given.get("strength", 1)
        return
    apart = nodes.new("ShaderNodeSeparateXYZ")
    links.new(where.outputs["Generated"], apart.inputs[0])
    height = apart.outputs["Z"]
    above = math_node(nodes, links, "MAXIMUM", height, 0.0)
    up = math_node(nodes, links, "POWER", math_node(nodes, links, "SUBTRACT", 1.0, above), 6.0)
    t = math_node(nodes, links, "MULTIPLY", height, -3.0, clamp=True)
    smooth = math_node(nodes, links, "MULTIPLY", math_node(nodes, links, "MULTIPLY", t, t),
                       math_node(nodes, links, "SUBTRACT", 3.0, math_node(nodes, links, "MULTIPLY", t, 2.0)))
    colors = [(*given[name], 1) for name in ("zenith", "horizon", "ground")]
    first, second = nodes.new("ShaderNodeMixRGB"), nodes.new("ShaderNodeMixRGB")
    first.inputs["Color1"].default_value, first.inputs["Color2"].default_value = colors[0], colors[1]
    second.inputs["Color2"].default_value = colors[2]
    links.new(up, first.inputs["Fac"])
    links.new(first.outputs[0], second.inputs["Color1"])
    links.new(smooth, second.inputs["Fac"])
    links.new(second.outputs[0], light.inputs["Color"])


def add_light(kind, given):
    """Adds a light with Blender's power in watts: 4 pi W per cd for a sphere, 4 W per unit for a rectangle, because
    Cycles gives a lamp of power P the radiance P / (4 area)."""
    lamp = bpy.data.lights.new(kind, kind)
    lamp.color = given["color"] if kind == "SUN" else given.get("color", [1, 0.72, 0.42])
    thing = bpy.data.objects.new(kind, lamp)
    bpy.context.collection.objects.link(thing)
    thing.visible_camera = False
    if kind == "SUN":
        lamp.energy = given["intensity"]
        lamp.angle = math.radians(given.get("diameter", 0))
        thing.rotation_euler = place(given["direction"]).to_track_quat("Z", "Y").to_euler()
        return
    thing.location = place(given["position"])
    if kind == "AREA":
        lamp.energy = 4 * given.get("intensity", 20)
        lamp.shape = "RECTANGLE"
        lamp.size, lamp.size_y = given["area"].get("width", 1), given["area"].get("height", 1)
        face(thing, given["area"].get("target", (0, 0, 0)))
    else:
        lamp.energy = 4 * math.pi * given.get("intensity", 20)
        lamp.shadow_soft_size = given.get("radius", 0.05)


def face(thing, target):
    thing.rotation_euler = (place(target) - thing.location).to_track_quat("-Z", "Y").to_euler()


def add_ground(given, target):
    """Adds the ground as a disc out to the distance where it has faded out."""
    bpy.ops.mesh.primitive_circle_add(vertices=512, radius=given["fadeEnd"], fill_type="NGON",
                                      location=place((target[0], given["height"], target[2])))
    return bpy.context.object


def add_camera(given):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle = math.radians(given["fieldOfView"])
    camera.clip_start, camera.clip_end = given.get("near", 0.05), given.get("far", 200)
    eye = bpy.data.objects.new("camera", camera)
    bpy.context.collection.objects.link(eye)
    eye.location = place(given["position"])
    face(eye, given["target"])
    bpy.context.scene.camera = eye


def settings(scene, size, samples):
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = samples
    cycles.use_denoising = cycles.use_adaptive_sampling = False
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = 1
    cycles.transparent_max_bounces = 0
    cycles.sample_clamp_indirect = 10
    cycles.filter_width = 1
    cycles.pixel_filter_type = "BOX"
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.render.resolution_percentage = 100
    scene.render.dither_intensity = 0
    scene.view_settings.view_transform = "Standard"
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGB"


def main():
    scene_file, folder, picture, samples = sys.argv[sys.argv.index("--") + 1:]
    given, folder, places = json.loads(pathlib.Path(scene_file).read_text()), pathlib.Path(folder), int(samples) == 0
    if refused := refusals(given):
        raise SystemExit("\n".join(refused))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene

    def surface(name, of, number):
        return flat(number) if places else material(name, of, folder)

    if not places:
        sky(given["sky"], folder)
        if given["sun"]["intensity"] > 0:
            add_light("SUN", given["sun"])
        for lamp in given.get("lights", {}).values():
            add_light(lamp.get("type", "point").upper(), lamp)
    add_ground(given["ground"], given["camera"]["target"]).data.materials.append(surface("ground", given["ground"], 0))
    for number, (name, thing) in enumerate(given["objects"].items(), 1):
        if is_baked(thing):
            (file,) = folder.glob(f"{name}_*.ply")
            parts = baked(file)
        else:
            solid = thing.get("sphere") or thing["capsule"]
            parts = turned_solid({"radius": 0.1, **solid} if "capsule" in thing else solid, solid.get("length", 2) if "capsule" in thing else 0)
        add_mesh(name, *parts).data.materials.append(surface(name, thing["material"], number))
    add_camera(given["camera"])
    settings(scene, given["render"]["size"], int(samples) or 1)
    scene.render.filepath = picture
    bpy.ops.render.render(write_still=True)


main()
