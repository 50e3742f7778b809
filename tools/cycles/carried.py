"""Lists the parts of a scene that tools/cycles transfers to Blender; any other part is refused by name."""

SOLID = {"position", "rotation", "radius", "collides", "visible", "grip", "friction"}
KNOWN = {
    "": {"$schema", "version", "stage", "title", "seed", "time", "render", "camera", "sun", "sky", "ground", "lights", "objects", "test", "checks"},
    "render": {"size", "samples", "quality", "raySamples", "tone"},
    "camera": {"position", "target", "fieldOfView", "near", "far"},
    "sun": {"direction", "color", "intensity", "diameter", "shadow", "shadowSize", "shadowSoftness"},
    "sky": {"zenith", "horizon", "ground", "picture", "strength", "turn"},
    "ground": {"height", "color", "roughness", "fadeStart", "fadeEnd", "friction"},
    "lights.*": {"type", "position", "color", "intensity", "radius", "area", "glow", "shadowSize", "shadowSoftness"},
    "lights.*.area": {"target", "width", "height"},
    "objects.*": {"sphere", "capsule", "mesh", "cloth", "material"},
    "objects.*.sphere": SOLID,
    "objects.*.capsule": SOLID | {"length"},
    "objects.*.material": {"color", "texture", "roughness", "metallic", "translucency"},
}
# Values that a scene must give, because Blender does not have simreel's defaults.
NEEDED = {"camera": ("position", "target", "fieldOfView"), "sun": ("direction", "color", "intensity"),
          "ground": ("height", "color", "roughness", "fadeStart", "fadeEnd"), "render": ("size",)}


def refusals(scene):
    """Returns lines that name the parts which cannot be transferred; empty if the whole scene can be."""
    found = []

    def look(path, pattern, given):
        for name in sorted(set(given) - KNOWN[pattern]):
            found.append(f"{path}{'.' if path else ''}{name}: not carried over to Blender; of {path or 'a scene'} there are {', '.join(sorted(KNOWN[pattern]))}")
        for name, value in given.items():
            if isinstance(value, dict) and "keys" in value:
                found.append(f"{path}.{name}: moves along keyframes, which are not carried over; give its value at the frame")

    look("", "", scene)
    if scene.get("stage") is not False:
        found.append("stage: Blender has none; give \"stage\": false")
    for name in ("render", "camera", "sun", "sky", "ground"):
        look(name, name, scene.get(name, {}))
    for part, names in NEEDED.items():
        found += [f"{part}.{name}: is not given, and Blender has no stage" for name in names if name not in scene.get(part, {})]
    sky = scene.get("sky", {})
    if "picture" not in sky and not {"zenith", "horizon", "ground"} <= set(sky):
        found.append("sky: neither a picture nor zenith, horizon and ground")
    ground = scene.get("ground", {})
    if ground.get("fadeEnd", 0) - ground.get("fadeStart", 0) > 1:
        found.append("ground: dissolves into the sky over more than a metre, which Blender's does not; let fadeStart and fadeEnd be equal, nearly")
    if scene.get("render", {}).get("tone", "plain") != "plain":
        found.append(f"render.tone: {scene['render']['tone']}; Blender's view \"Standard\" is plain")
    for name, lamp in scene.get("lights", {}).items():
        look(f"lights.{name}", "lights.*", lamp)
        if lamp.get("type", "point") == "spot":
            found.append(f"lights.{name}.type: spot; point and area are carried over")
        if lamp.get("glow", 1) != 0 and lamp.get("type", "point") == "point":
            found.append(f"lights.{name}.glow: Blender's lamps have none; give 0")
        look(f"lights.{name}.area", "lights.*.area", lamp.get("area", {}))
    for name, thing in scene.get("objects", {}).items():
        look(f"objects.{name}", "objects.*", thing)
        for kind in ("sphere", "capsule", "material"):
            if isinstance(thing.get(kind), dict):
                look(f"objects.{name}.{kind}", f"objects.*.{kind}", thing[kind])
        if not isinstance(thing.get("material"), dict):
            found.append(f"objects.{name}.material: is not given; those of files are not carried over")
        elif thing["material"].get("metallic", 0) not in (0, 1):
            found.append(f"objects.{name}.material.metallic: {thing['material']['metallic']}; 0 and 1 are carried over")
    return found


def is_baked(thing):
    """True if the geometry comes from a file of `simreel bake`."""
    return "mesh" in thing or "cloth" in thing


def flat_color(number):
    """Returns a linear colour that identifies an object among 26; number 0 is black."""
    return [(0.0, 0.25, 1.0)[number // 3 ** k % 3] for k in range(3)]
