"""For Blender: the first frame of a simreel scene of spheres, generated meshes and a ground, under sun and gradient, by Cycles with as many
bounces as render.quality "high" has. blender -b --python scene.py -- SCENE.json FOLDER PICTURE.png SAMPLES; FOLDER has the
scene's meshes as simreel bake writes them."""
import json
import math
import pathlib
import sys

import bpy
from mathutils import Vector


def place(p):
    """From y up to z up."""
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


def material(name, given):
    """A GGX lobe of F0 0.04 over a matt surface that gets what the lobe leaves (glsl/draw/exact/rays/facet.glsl); a metal: the lobe
    alone."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    color = (*given.get("color", [0.8, 0.8, 0.8]), 1)
    r = given.get("roughness", 0.8)
    metal = given.get("metallic", 0) == 1
    out = nodes.new("ShaderNodeOutputMaterial")
    lobe = nodes.new("ShaderNodeBsdfPrincipled")
    lobe.distribution = "GGX"
    lobe.inputs["Roughness"].default_value = r
    lobe.inputs["Metallic"].default_value = float(metal)
    lobe.inputs["Specular"].default_value = 0.5
    lobe.inputs["Base Color"].default_value = color if metal else (0, 0, 0, 1)
    if metal:
        links.new(lobe.outputs[0], out.inputs["Surface"])
        return made
    facing = nodes.new("ShaderNodeLayerWeight")
    facing.inputs["Blend"].default_value = 0.5
    cosine = math_node(nodes, links, "SUBTRACT", 1.0, facing.outputs["Facing"])
    fall = math_node(nodes, links, "POWER", 2.0, math_node(nodes, links, "MULTIPLY", cosine, -9.28))
    least = math_node(nodes, links, "MULTIPLY", math_node(nodes, links, "MINIMUM", fall, (1 - r) ** 2), 1 - r)
    mirrored = math_node(nodes, links, "MULTIPLY", math_node(nodes, links, "ADD", least, 0.0425 - 0.0275 * r), 0.9984)
    kept = math_node(nodes, links, "SUBTRACT", 1 - 0.0016 + 0.00088 * r, mirrored)
    tint = nodes.new("ShaderNodeMixRGB")
    tint.inputs["Color1"].default_value = (0, 0, 0, 1)
    tint.inputs["Color2"].default_value = color
    links.new(kept, tint.inputs["Fac"])
    matt = nodes.new("ShaderNodeBsdfDiffuse")
    links.new(tint.outputs[0], matt.inputs["Color"])
    both = nodes.new("ShaderNodeAddShader")
    links.new(matt.outputs[0], both.inputs[0])
    links.new(lobe.outputs[0], both.inputs[1])
    links.new(both.outputs[0], out.inputs["Surface"])
    return made


def sky(given):
    """glsl/draw/sky.glsl: zenith to horizon by (1 - y)^6, below it to the ground's colour within a third."""
    world = bpy.data.worlds.new("sky")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    nodes.clear()
    where = nodes.new("ShaderNodeTexCoord")
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
    light, out = nodes.new("ShaderNodeBackground"), nodes.new("ShaderNodeOutputWorld")
    links.new(second.outputs[0], light.inputs["Color"])
    links.new(light.outputs[0], out.inputs["Surface"])


def add_light(kind, given, position=None):
    lamp = bpy.data.lights.new(kind, kind)
    lamp.color = given.get("color", [1, 1, 1])
    thing = bpy.data.objects.new(kind, lamp)
    bpy.context.collection.objects.link(thing)
    if kind == "SUN":
        lamp.energy = given["intensity"]
        lamp.angle = math.radians(given.get("diameter", 0))
        thing.rotation_euler = place(given["direction"]).to_track_quat("Z", "Y").to_euler()
    else:
        lamp.energy = 4 * math.pi * given["intensity"]
        lamp.shadow_soft_size = given["radius"]
        thing.location = place(given["position"])
    lamp.use_shadow = True


def main():
    scene_file, folder, picture, samples = sys.argv[sys.argv.index("--") + 1:]
    given = json.loads(pathlib.Path(scene_file).read_text())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    sky(given["sky"])
    add_light("SUN", given["sun"])
    for lamp in given.get("lights", {}).values():
        add_light("POINT", lamp)
    ground = given["ground"]
    reach = ground["fadeEnd"]
    target = given["camera"]["target"]
    bpy.ops.mesh.primitive_plane_add(size=2 * reach, location=place((target[0], ground["height"], target[2])))
    bpy.context.object.data.materials.append(material("ground", {**ground, "metallic": 0}))
    for name, thing in given["objects"].items():
        if "sphere" in thing:
            bpy.ops.mesh.primitive_uv_sphere_add(segments=256, ring_count=128, radius=thing["sphere"]["radius"],
                                                 location=place(thing["sphere"]["position"]))
        else:
            bpy.ops.import_mesh.ply(filepath=str(next(pathlib.Path(folder).glob(f"{name}_*.ply"))))
            bpy.context.object.rotation_euler = (math.radians(90), 0, 0)
        bpy.ops.object.shade_smooth()
        bpy.context.object.data.materials.append(material(name, thing["material"]))
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle = math.radians(given["camera"]["fieldOfView"])
    eye = bpy.data.objects.new("camera", camera)
    bpy.context.collection.objects.link(eye)
    eye.location = place(given["camera"]["position"])
    eye.rotation_euler = (place(target) - eye.location).to_track_quat("-Z", "Y").to_euler()
    scene.camera = eye
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = int(samples)
    cycles.use_denoising = cycles.use_adaptive_sampling = False
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = 1
    cycles.transmission_bounces = cycles.transparent_max_bounces = 0
    cycles.sample_clamp_indirect = 10
    cycles.filter_width = 1
    cycles.pixel_filter_type = "BOX"
    scene.render.resolution_x, scene.render.resolution_y = given["render"]["size"]
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = "Standard"
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.filepath = picture
    bpy.ops.render.render(write_still=True)


main()
