"""Blender shows a texture on the ribbon as ribbon-play does: upright seen from the front, repeated along.

  blender -b --factory-startup -noaudio --python-exit-code 1 --python blender_texture.py -- \
      RIBBON_CONVERT BLENDER_SAMPLES FOLDER

A flat ribbon is converted with a picture of few pixels, all of other colours, imported and rendered from its
front by Cycles, with the colour of the material's image as its light. Each pixel of each repetition must be
seen where it belongs. The same comparison must refuse uv that are turned round.
"""

import math
import pathlib
import struct
import subprocess
import sys
import zlib

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from blender_scene import import_file  # noqa: E402

# The flat sample of blender_samples: 12 x 4 particles.
LENGTH, WIDTH, HEIGHT = 1.1, 0.09, 0.3

# Rows from the top, sRGB.
PICTURE = (
    ((255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 0)),
    ((0, 255, 255), (255, 0, 255), (64, 64, 64), (255, 255, 255)),
)
ROWS, COLUMNS = len(PICTURE), len(PICTURE[0])
REPETITIONS = LENGTH / (WIDTH * COLUMNS / ROWS)

# Of a picture of the whole ribbon.
PIXELS_ALONG, PIXELS_ACROSS = 550, 45


# Of the back of a solid.
LINING = (
    ((0, 0, 128), (128, 0, 0), (0, 128, 0), (128, 128, 0)),
    ((200, 100, 0), (0, 100, 200), (100, 0, 200), (10, 20, 30)),
)


def write_png(path, picture):
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    rows = b"".join(b"\0" + bytes(c for pixel in row for c in pixel) for row in picture)
    head = struct.pack(">IIBBBBB", COLUMNS, ROWS, 8, 2, 0, 0, 0)
    parts = chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + parts)


def image_node(material):
    nodes = material.node_tree.nodes
    found = [node for node in nodes if node.type == "TEX_IMAGE"]
    return found[0] if len(found) == 1 and found[0].image else None


def light_up(material):
    """What the material's image shows becomes light, so that nothing else counts."""
    tree = material.node_tree
    node = image_node(material)
    node.interpolation = "Closest"
    light = tree.nodes.new("ShaderNodeEmission")
    output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
    tree.links.new(node.outputs["Color"], light.inputs["Color"])
    tree.links.new(light.outputs["Emission"], output.inputs["Surface"])


def look(from_behind):
    """In the picture, the recording's x goes to the right and its z, across the ribbon, up; down from behind."""
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = (LENGTH / 2, -WIDTH / 2, HEIGHT + (1 if from_behind else -1))
    camera.rotation_euler = (0 if from_behind else math.pi, 0, 0)
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = LENGTH
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def rendered(path):
    """Pixels as rows from the bottom, each (r, g, b) from 0 to 1 as in the PNG."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples = "CPU", 1
    scene.cycles.use_denoising = False
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 0.01
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y = PIXELS_ALONG, PIXELS_ACROSS
    scene.render.resolution_percentage = 100
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    flat = list(image.pixels)
    bpy.data.images.remove(image)
    return [flat[4 * i : 4 * i + 3] for i in range(PIXELS_ALONG * PIXELS_ACROSS)]


def texels(picture):
    """The middle of each pixel in each repetition, along and across from 0 to 1, with its colour."""
    for place in range(int(REPETITIONS * COLUMNS)):
        for row in range(ROWS):
            along = (place + 0.5) / (REPETITIONS * COLUMNS)
            across = 1 - (row + 0.5) / ROWS
            yield along, across, picture[row][place % COLUMNS]


def compare_rendered(pixels, picture, from_behind):
    wrong = 0
    for along, across, colour in texels(picture):
        up = 1 - across if from_behind else across
        x, y = int(along * PIXELS_ALONG), int(up * PIXELS_ACROSS)
        seen = pixels[y * PIXELS_ALONG + x]
        wrong += max(abs(255 * s - c) for s, c in zip(seen, colour)) > 2
    return [f"{wrong} of {len(list(texels(picture)))} texels are not where they belong"] if wrong else []


def turned_round(mesh, axis):
    for corner in mesh.uv_layers[0].data:
        corner.uv[axis] = (REPETITIONS, 1)[axis] - corner.uv[axis]


def check(path, turn=None, picture=PICTURE, from_behind=False):
    """Problems of an export; `turn` spoils its uv first. `picture`: what must be seen."""
    import_file(path)
    for obj in list(bpy.data.objects):
        if obj.name != "first knot":
            bpy.data.objects.remove(obj)
    ribbon = bpy.data.objects["first knot"]
    materials = [slot.material for slot in ribbon.material_slots]
    for material in materials:
        node = image_node(material)
        if node is None:
            return ["the material shows no image"]
        if tuple(node.image.size) != (COLUMNS, ROWS):
            return [f"the image has {tuple(node.image.size)} pixels"]
    if turn is not None:
        turned_round(ribbon.data, turn)
    for material in materials:
        light_up(material)
    look(from_behind)
    return compare_rendered(rendered(path.with_suffix(".render.png")), picture, from_behind)


def main():
    convert, samples, folder = sys.argv[sys.argv.index("--") + 1 :]
    folder = pathlib.Path(folder)
    subprocess.run([samples, folder], check=True)
    write_png(folder / "cloth.png", PICTURE)
    write_png(folder / "lining.png", LINING)
    failed = 0

    def say(good, what, problems):
        nonlocal failed
        failed += not good
        print("ok    " if good else "FAILED", what, "; ".join(problems) or "right", flush=True)

    command = [convert, folder / "flat.rbn", "--texture", folder / "cloth.png", "--quiet", "--force"]
    for name, options in (
        ("obj/knot.obj", ("--frames", "1")),
        ("fbx/knot.0001.fbx", ("--frames", "1")),
        ("motion/knot.fbx", ()),
        ("glb/knot.glb", ()),
        ("solid/knot.obj", ("--frames", "1", "--thickness", "0.002")),
    ):
        path = folder / "textured" / name
        output = str(path).replace("0001", "{frame:04}")
        subprocess.run([*command, "-o", output, *options], check=True)
        problems = check(path)
        say(not problems, name, problems)
    lining = ("--thickness", "0.002", "--texture-back", folder / "lining.png")
    for name, options in (("obj/knot.obj", ("--frames", "1")), ("fbx/knot.fbx", ()), ("glb/knot.glb", ())):
        path = folder / "lined" / name
        subprocess.run([*command, "-o", path, *lining, *options], check=True)
        problems = check(path) + check(path, None, LINING, True)
        say(not problems, f"lined {name}", problems)
    problems = check(folder / "lined/glb/knot.glb", None, PICTURE, True)
    say(any("not where they belong" in p for p in problems), "refused, the front's on the back:", problems)
    for axis, name in enumerate(("u turned round", "v turned round")):
        problems = check(folder / "textured/glb/knot.glb", axis)
        say(any("not where they belong" in p for p in problems), f"refused, {name}:", problems)
    if failed:
        raise SystemExit(f"{failed} comparisons went wrong")


main()
