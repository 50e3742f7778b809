"""Tests materials of mesh files and of scenes: drawn features, messages, refused values."""
import base64
import json
import struct
import zlib

from common import SOURCE, Case, main, png_rows, unfiltered

WORDS = "has features that are not drawn: "


def png(pixels, width=None):
    """Returns a PNG of RGBA pixels, as rows of `width` pixels, or one row."""
    width = width or len(pixels)
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    rows = b"".join(b"\0" + b"".join(bytes(p) for p in pixels[at:at + width]) for at in range(0, len(pixels), width))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, len(pixels) // width, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def gltf(materials, images=(), textures=()):
    """Returns two triangles of a square before the camera, one for each of the first two materials."""
    places = [(-1, 1, 0), (-1, -1, 0), (1, -1, 0), (1, 1, 0)]
    uvs = [(0, 0), (0, 1), (1, 1), (1, 0)]
    corners = struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    data = b"".join(struct.pack("<3f", *p) for p in places) + b"".join(struct.pack("<2f", *p) for p in uvs) + corners
    part = lambda first, material: {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": first, "material": material}
    return {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [part(2, 0), part(3, min(1, len(materials) - 1))]}],
            "materials": list(materials), "textures": list(textures),
            "images": [{"uri": "data:image/png;base64," + base64.b64encode(image).decode()} for image in images],
            "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                            {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
                          {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                          {"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"},
                          {"bufferView": 2, "byteOffset": 6, "componentType": 5123, "count": 3, "type": "SCALAR"}],
            "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}


def glowing(color, **more):
    return {"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0}, "emissiveFactor": color, **more}


class Materials(Case):
    def scene(self, file, material=None):
        objects = {"mesh": {"shape": "file", "file": file}}
        if material is not None:
            objects["material"] = material
        self.write("square.json", {"version": 1, "render": {"tone": "plain", "samples": 1}, "camera": {"position": [0, 0, 4], "target": [0, 0, 0]},
                                   "sun": {"intensity": 0}, "sky": {"zenith": [0, 0, 0], "horizon": [0, 0, 0], "ground": [0, 0, 0], "ambient": 0},
                                   "objects": {"square": objects}})

    def picture(self, *more):
        """Returns the colours at the lower left and the upper right of the square's diagonal."""
        self.good("render", "square.json", "--frames", "0", "--size", "65x65", "-o", "out/", "--overwrite", *more)
        width, _, rows = png_rows((self.folder / "out/000000.png").read_bytes())
        data = b"".join(unfiltered(rows, width * 3, 3))
        return tuple(tuple(data[3 * (width * y + x):][:3]) for x, y in ((24, 40), (40, 24)))

    def test_a_material_for_each_part_of_a_file(self):
        self.write("square.gltf", gltf([glowing([1, 0, 0]), glowing([0, 0, 1])]))
        self.scene("square.gltf")
        self.assertEqual(self.picture(), ((255, 0, 0), (0, 0, 255)))
        # The emission in the scene replaces the emission in the file.
        self.scene("square.gltf", {"emission": [0, 1, 0], "color": [0, 0, 0]})
        self.assertEqual(self.picture(), ((0, 255, 0), (0, 255, 0)))

    def test_ignored_parts_of_a_file_are_reported_once(self):
        transform = {"extensions": {"KHR_texture_transform": {"scale": [2, 2]}}}
        pane = {"name": "pane", "extensions": {"KHR_materials_anisotropy": {}, "KHR_materials_ior": {"ior": 1.3}},
                "occlusionTexture": {"index": 0, "texCoord": 1}, "normalTexture": {"index": 0, **transform}, "emissiveTexture": {"index": 0}}
        self.write("square.gltf", {**gltf([pane], [png([(128, 128, 255, 255)])], [{"source": 0, "sampler": 0}]), "samplers": [{"magFilter": 9728}]})
        self.scene("square.gltf")
        said = self.good("render", "square.json", "--frames", "0", "--size", "16x16", "-o", "out/").err
        self.assertEqual(said.count(WORDS), 1)
        line = next(line for line in said.splitlines() if WORDS in line)
        for part in ("square.gltf", "KHR_materials_anisotropy of material \"pane\"", "KHR_materials_ior of material \"pane\"", "magFilter NEAREST of normalTexture", "occlusionTexture (its texCoord differs from that of the other textures) of material \"pane\"",
                     "emissiveTexture (its KHR_texture_transform is not that of the others) of material \"pane\""):
            self.assertIn(part, line)
        more = {**gltf([glowing([1, 0, 0])]), "extensionsUsed": ["KHR_lights_punctual", "KHR_texture_transform", "EXT_mesh_gpu_instancing"], "animations": [{}]}
        self.write("square.gltf", more)
        self.assertIn(WORDS + "EXT_mesh_gpu_instancing; animations (a \"body\" shows those of nodes)", self.said())
        self.write("square.gltf", gltf([pane], [png([(128, 128, 255, 255)])], [{"source": 0}]))
        said = self.good("render", "square.json", "--frames", "0", "--size", "16x16", "-o", "driver/", "--rasterizer", "driver").err
        self.assertEqual(said.count("square: the driver's rasterizer draws only the colour, roughness and metal"), 1)

    def test_invalid_pictures_inside_a_file_are_refused(self):
        broken = gltf([glowing([1, 1, 1], emissiveTexture={"index": 0})], [b"no picture"], [{"source": 0}])
        self.write("square.gltf", broken)
        self.scene("square.gltf")
        self.bad(6, ["image 0 is not a picture"], "render", "square.json", "--frames", "0", "-o", "out/")
        broken["images"] = [{"uri": "../secret.png"}]
        self.write("square.gltf", broken)
        self.assertIn("../secret.png (it lies outside the folders that the scene may read; --assets DIR adds one)",
                      self.good("render", "square.json", "--frames", "0", "--size", "8x8", "-o", "out/").err)
        broken["textures"] = []
        self.write("square.gltf", broken)
        self.bad(6, ["number 0 of its 0 textures"], "render", "square.json", "--frames", "0", "-o", "out2/")

    def test_libraries_of_materials(self):
        self.write("square.obj", b"mtllib square.mtl\nv -1 1 0\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nvt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                 b"usemtl left\nf 1/1 2/2 3/3\nusemtl right\nf 1/1 3/3 4/4\n")
        self.write("square.mtl", b"newmtl left\nKd 0 0 0\nKe 0 1 0\nnewmtl right\nKd 0 0 0\nKe 1 1 1\nmap_Ke -clamp on glow.png\nmap_refl sky.png\n")
        self.write("glow.png", png([(255, 0, 0, 255)]))
        self.scene("square.obj")
        self.assertEqual(self.picture(), ((0, 255, 0), (255, 0, 0)))
        self.assertIn("map_refl of material \"right\"", self.said())
        self.write("square.mtl", b"newmtl left\nKd 0 0 0\nKe 0 1 0\nd 0.5\nnewmtl right\nKd 0 0 0\nKe 1 1 1\nmap_d hole.png\n")
        self.write("hole.png", png([(0, 0, 0, 255)]))
        left, right = self.picture()
        self.assertEqual(right, (0, 0, 0))
        self.assertTrue(180 < left[1] < 195, left)  # The picture contains half of the light.
        self.write("square.mtl", b"newmtl left\nmap_Kd gone.png\n")
        self.assertIn("gone.png (it does not exist or is not a regular file)", self.said())
        (self.folder / "square.mtl").unlink()
        self.assertIn("square.mtl (it does not exist", self.said())

    def square(self, library):
        """Writes an OBJ with one material; at the points that picture() reads, u and v are 0.32 and 0.68."""
        self.write("square.obj", b"mtllib square.mtl\nv -1 1 0\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nvt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                 b"usemtl all\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n")
        self.write("square.mtl", b"newmtl all\nKd 0 0 0\n" + library)
        self.scene("square.obj")

    def said(self):
        """Returns the warnings about the scene. `validate` prints them as `render` does, in a tenth of the time."""
        return self.good("validate", "square.json").err

    def test_options_of_maps_in_libraries(self):
        red, green, blue, white = (255, 0, 0, 255), (0, 255, 0, 255), (0, 0, 255, 255), (255,) * 4
        self.write("across.png", png([red, red, green, green]))
        self.write("down.png", png([red, red, green, green, blue, blue, white, white], 1))
        for options, file, left, right in (("", "across", red, green), ("-o 0.5 0 0", "across", green, red), ("-s -1 1 1", "across", green, red),
                                           ("-s 0.5", "across", red, red), ("-o 0.5 -clamp on", "across", green, green), ("-blendu off -bm 1", "across", red, green),
                                           ("", "down", blue, green), ("-o 0 0.25", "down", green, red), ("-s 1 0.25", "down", white, white)):
            self.square(f"Ke 1 1 1\nmap_Ke {options} {file}.png\n".encode())
            self.assertEqual(self.picture(), (left[:3], right[:3]), (options, file))
            self.assertNotIn(WORDS, self.said())
        self.square(b"Ke 1 1 1\nmap_Ke -o 0.5 0 across.png\nmap_Kd -mm 0.1 1 -t 0.1 across.png\n")
        said = self.said()
        for part in ("-mm of map_Kd of material \"all\"", "-t of map_Kd", "map_Ke (its -o and -s are not those of the others)"):
            self.assertIn(part, said)

    def test_unsupported_words_of_libraries_are_reported(self):
        for library, part in ((b"Ke 0 1 0\naniso 0.5\nanisor 0.1\n", "aniso of material"), (b"Ke 0 1 0\nd -halo 1\n", "-halo of d"),
                              (b"Ke 0 1 0\nKd spectral glass.rfl\n", "\"Kd spectral glass.rfl\" of material"), (b"Ke 0 1 0\nPr nan\n", "\"Pr nan\""),
                              (b"Ke 0 1 0\nTf 1 0 0\n", "Tf of material")):
            self.square(library)
            self.assertIn(part, self.said())
            self.square(library + b"Kd 0 0 0\n")
            self.assertEqual(self.picture(), ((0, 255, 0), (0, 255, 0)))
        # Blender writes these values for unused features.
        self.square(b"Ke 0 1 0\naniso 0\nanisor 0\nPs 0\nTf 1 1 1\nmap_d -imfchan l -cc off gone.png\n")
        self.assertIn("gone.png", self.said())
        self.assertNotIn("aniso", self.said())
        self.square(b"map_Ke gone.png\n")  # Without its picture, a light source is dark.
        self.assertEqual(self.picture(), ((0, 0, 0), (0, 0, 0)))

    def test_usual_lighting_words_of_libraries_are_accepted(self):
        blender = b"Ns 250.000000\nKa 1.000000 1.000000 1.000000\nKs 0.500000 0.500000 0.500000\nKe 0 1 0\nNi 1.450000\nd 1.000000\nillum 2\n"
        for library in (blender, b"Ke 0 1 0\nKa 0 0 0\nKs 0 0 0\nNi 1\nillum 1\n", b"Ke 0 1 0\nKa 0.5 0.2 0.1\nKd 0.5 0.2 0.1\nKs 1 1 1\nillum 3\n",
                        b"Ke 0 1 0\nd 0.5\nNi 1.5\nillum 9\n", b"Ke 0 1 0\nillum 4\nTr 0.5\n"):
            self.square(library)
            self.assertNotIn(WORDS, self.said(), library)
        for library, part in ((b"Ka 0.5 0.2 0.1\n", "Ka"), (b"Ks 0.9 0.7 0.3\n", "Ks"), (b"Ni 2.4\n", "Ni"), (b"illum 0\n", "illum 0"), (b"Ks spectral a.rfl\n", "\"Ks spectral a.rfl\""),
                              (b"Ni 1.5\nillum 7\n", "Ni of material \"all\"; illum 7")):
            self.square(b"Ke 0 1 0\n" + library)
            self.assertIn(f"{WORDS}{part} of material \"all\"\n", self.said(), library)

    def test_unlit(self):
        self.write("leaf.png", png([(255, 255, 255, 255), (0, 255, 0, 40)]))
        leaf = (self.folder / "leaf.png").read_bytes()
        plain = {"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 1, 1], "metallicFactor": 0}, "emissiveFactor": [1, 0, 0], "extensions": {"KHR_materials_unlit": {}}}
        holed = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "alphaMode": "MASK", "extensions": {"KHR_materials_unlit": {}, "KHR_materials_clearcoat": {"clearcoatFactor": 1}}}
        self.write("square.gltf", {**gltf([plain, holed], [leaf], [{"source": 0}]), "extensionsUsed": ["KHR_materials_unlit"]})
        self.scene("square.gltf")
        # The light does not come from "emissiveFactor". The second material is a hole.
        self.assertEqual(self.picture(), ((0, 0, 255), (0, 0, 0)))
        self.assertNotIn(WORDS, self.said())
        light = ("-D", "sun.intensity=9", "-D", "sun.direction=[0,0,1]")
        self.assertEqual(self.picture(*light)[0], (0, 0, 255))
        colored = gltf([plain])
        colored["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 0
        self.write("square.gltf", colored)
        self.assertIn(WORDS + "COLOR_0 of what is unlit", self.said())

    def test_texture_transforms_of_gltf(self):
        red, green, blue, white = (255, 0, 0, 255), (0, 255, 0, 255), (0, 0, 255, 255), (255,) * 4
        across, down = png([red, red, green, green]), png([red, red, green, green, blue, blue, white, white], 1)
        # picture() reads u = 0.32, v = 0.68, and then u = 0.68, v = 0.32. A quarter turn gives u' = v and v' = -u.
        for image, transform, left, right in ((across, {}, red, green), (across, {"offset": [0.5, 0]}, green, red), (across, {"scale": [0.5, 1]}, red, red),
                                              (across, {"rotation": 1.5707963}, green, red), (down, {}, blue, green), (down, {"offset": [0, 0.25]}, white, blue),
                                              (down, {"rotation": 1.5707963}, blue, green), (down, {"rotation": 1.5707963, "offset": [0, 0.25], "scale": [2, 1]}, blue, white)):
            shining = glowing([1, 1, 1], emissiveTexture={"index": 0, "extensions": {"KHR_texture_transform": transform}})
            self.write("square.gltf", gltf([shining], [image], [{"source": 0}]))
            self.scene("square.gltf")
            self.assertEqual(self.picture(), (left[:3], right[:3]), transform)
            self.assertNotIn(WORDS, self.said())
        second = gltf([glowing([1, 1, 1], emissiveTexture={"index": 0, "texCoord": 1})], [across], [{"source": 0}])
        # The second uv set consists of the positions, so u = 0.32 is at x = -0.36.
        for part in second["meshes"][0]["primitives"]:
            part["attributes"]["TEXCOORD_1"] = 4
        second["accessors"].append({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC2"})
        second["bufferViews"][0]["byteStride"] = 12
        self.write("square.gltf", second)
        self.scene("square.gltf")
        self.assertEqual(self.picture(), ((0, 255, 0), (255, 0, 0)))  # u = x is -0.36, which wraps to 0.64, and 0.36.
        self.assertNotIn(WORDS, self.said())

    def test_maps_of_a_scene(self):
        self.write("leaf.png", png([(255, 255, 255, 255), (255, 255, 255, 40)]))
        self.write("square.gltf", gltf([glowing([1, 0, 0])]))
        shining = {"color": [0, 0, 0], "emission": [0, 0, 1], "texture": "leaf.png"}
        self.scene("square.gltf", {**shining, "alpha": "cut"})
        self.assertEqual(self.picture(), ((0, 0, 255), (0, 0, 0)))
        self.scene("square.gltf", {**shining, "alpha": "cut", "alphaCutoff": 0.1})
        self.assertEqual(self.picture(), ((0, 0, 255), (0, 0, 255)))
        self.scene("square.gltf", {"color": [0, 0, 0], "emission": [0, 0, 1], "alpha": "blend", "opacity": 0.5})
        self.assertTrue(180 < self.picture()[0][2] < 195)

    def test_holes_do_not_depend_on_the_size_of_triangles(self):
        """A plane of 2 triangles, drawn by workgroups, and the same plane of 8,192, drawn one per invocation. With the
        corners of the small ones swapped, 428 pixels differ."""
        material = {"texture": "textures/halo.png", "alpha": "cut", "textureScale": [4, 4]}
        for side in (2, 65):
            plane = {"shape": "plane", "size": [2, 0, 2], "rotation": [60, 20, 0], "position": [0, 1, 0], "resolution": [side, side]}
            self.write("plane.json", {"version": 2, "objects": {"a": {"mesh": plane, "material": material}}})
            self.good("render", "plane.json", "-o", f"{side}.png", "--frames", 0, "--size", "160x90")
        self.good("diff", "2.png", "65.png", "--max-diff-pixels", 40)

    def test_validate_opens_what_render_opens(self):
        self.write("leaf.png", png([(255, 255, 255, 255), (255, 255, 255, 40)]))
        self.write("words.png", b"no picture")
        self.write("narrow.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + bytes((128, 128, 128, 129)))
        render = ("render", "scene.json", "--frames", "0", "--size", "8x8", "-o", "out/", "--overwrite")
        scene = {"version": 1, "objects": {"ball": {"sphere": {}}}}

        def both(code, words, material=None, **sections):
            ball = {"sphere": {}, **({} if material is None else {"material": material})}
            self.write("scene.json", {**scene, **sections, "objects": {"ball": ball}})
            for command in (("validate", "scene.json"), render):
                if code == 0:
                    self.good(*command)
                else:
                    done = self.run_program(*command)
                    self.assertIn(words, done.err)
                    self.assertEqual(done.returncode, code)

        both(0, "", {"texture": "leaf.png", "alpha": "cut"})
        both(2, "needs a material with \"alpha\": \"cut\" or \"blend\"", {"texture": "leaf.png"})
        for key in ("normalMap", "metallicRoughnessMap", "occlusionMap", "emissionMap"):
            both(6, "words.png is not a picture", {key: "words.png", "emission": [1, 1, 1]})
        both(6, "words.png is neither Radiance HDR nor OpenEXR", sky={"picture": "words.png"})
        both(6, "an equirectangular picture is twice as wide as high", sky={"picture": "narrow.hdr"})
        both(2, "3 samples per pixel are not supported; use 1, 2, 4, 8 or 16", render={"samples": 3})

    def test_keys_that_do_nothing_are_refused(self):
        self.write("square.gltf", gltf([glowing([1, 0, 0])]))
        self.write("map.png", png([(128, 128, 255, 255)]))
        for material, words in (({"opacity": 0.5}, "\"opacity\" is for a material with \"alpha\": \"cut\" or \"blend\""),
                                ({"alpha": "blend", "alphaCutoff": 0.5}, "\"alphaCutoff\" is for a material with \"alpha\": \"cut\""),
                                ({"normalStrength": 2}, "with a \"normalMap\""), ({"emissionMap": "map.png"}, "with an \"emission\""),
                                ({"normalMap": "map.png", "texture": "map.png", "bump": 0.1}, "use a \"normalMap\""),
                                ({"clearCoatRoughness": 0.1}, "with a \"clearCoat\""), ({"sheenRoughness": 0.3}, "with a \"sheen\""),
                                ({"occlusionStrength": 0.3}, "with an \"occlusionMap\"")):
            self.scene("square.gltf", material)
            self.bad_scene([words], "render", "square.json", "--frames", "0", "-o", "out/")

    def test_high_draws_emission_beside_a_skin_without_maps(self):
        square = {"mesh": {"shape": "plane", "size": [1, 0, 1], "position": [0, 0, 0]}}
        self.write("skin.json", {"version": 1, "stage": False, "render": {"quality": "high", "raySamples": 1}, "camera": {"position": [0, 3, 3], "target": [0, 0, 0]},
                                 "objects": {"hide": {"grayScott": {"size": [8, 8], "display": {"layer": "none"}}},
                                             "body": {**square, "material": {"skin": {"field": "hide", "look": "map"}}},
                                             "eye": {"mesh": {**square["mesh"], "position": [1, 0, 0]}, "material": {"emission": [1, 1, 1]}}}})
        self.good("render", "skin.json", "--frames", "0", "--size", "16x16", "-o", "out/")


if __name__ == "__main__":
    main()
