"""Installs both add-ons in Blender as a user does, draws a knot round a post, and has it tied.

usage: tie_drawn_knot.py PACKAGE IMPORT_ADD_ON ADD_ON RECORDER FOLDER    PACKAGE: folder in which the package ribbon lies
"""

import math
import re
import subprocess
import sys
from pathlib import Path

import bpy
import numpy
from mathutils import Vector

package, import_add_on, add_on, recorder, folder = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, package)
folder = Path(folder)

import ribbon  # noqa: E402, found only now


def check(claim, text):
    if not claim:
        sys.exit(f"FAILED: {text}")


# Seen from above, round the origin: a left-handed trefoil (its three crossings are negative), cut open.
TREFOIL = [(math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t), -math.sin(3 * t))
           for t in (math.radians(d) for d in range(35, 386, 3))]


def drawn_points(height):
    """Metres: the trefoil, as high and as deep, its ends drawn on outwards."""
    points = [(0.04 * x, 0.04 * y, height * z) for x, y, z in TREFOIL]
    ends = []
    for end, next_to_it in ((points[0], points[1]), (points[-1], points[-2])):
        way = [a - b for a, b in zip(end, next_to_it)]
        size = math.hypot(*way[:2])
        ends.append([tuple(a + k * 0.02 * w / size for a, w in zip(end, way[:2])) + (end[2],) for k in range(1, 11)])
    return ends[0][::-1] + points + ends[1]


def draw_curve(points, name):
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    spline = curve.splines.new("POLY")
    spline.points.add(len(points) - 1)
    for place, point in zip(spline.points, points):
        place.co = (*point, 1)
    return linked(bpy.data.objects.new(name, curve))


def draw_stroke(points, name):
    data = bpy.data.grease_pencils.new(name)
    layer = data.layers.new("ink")
    stroke = layer.frames.new(1).strokes.new()
    stroke.points.add(len(points))
    for place, point in zip(stroke.points, points):
        place.co = point
    data.layers.active = layer
    return linked(bpy.data.objects.new(name, data))


def linked(thing):
    bpy.context.collection.objects.link(thing)
    return thing


def choose(drawing, *others):
    bpy.ops.object.select_all(action="DESELECT")
    for thing in (drawing, *others):
        thing.select_set(True)
    bpy.context.view_layer.objects.active = drawing


def tie(**settings):
    return bpy.ops.object.tie_ribbon(folder=str(folder), **settings)


def check_refused(word, **settings):
    try:
        tie(**settings)
    except RuntimeError as error:
        check(word in str(error), f"the refusal says {error}, not {word}")
    else:
        sys.exit(f"FAILED: nothing said {word}")


def check_lies_on(drawing, recording):
    """The middle line of the first frame, in Blender's world."""
    thing = bpy.context.active_object
    drawn = [drawing.matrix_world @ point.co.xyz for point in drawing.data.splines[0].points]
    for place in recording[0].mean(axis=1)[::10]:
        x = thing.matrix_world @ Vector(map(float, place))
        off = min((x - point).length for point in drawn) * bpy.context.scene.unit_settings.scale_length
        check(off < 0.01, f"the ribbon begins {off} m off the drawing")


def check_closes_on(post):
    bpy.context.scene.frame_set(bpy.context.scene.frame_end)
    thing = bpy.context.active_object
    places = [post.matrix_world.inverted() @ thing.matrix_world @ vertex.co for vertex in thing.data.vertices]
    off = min((math.hypot(x, y) for x, y, z in places if abs(z) < 0.05), default=math.inf)
    check(0.0148 < off < 0.017, f"at last the ribbon is {off} m off the axis of the post")


for module in (import_add_on, add_on):
    bpy.ops.preferences.addon_install(filepath=module)

bpy.ops.preferences.addon_enable(module="ribbon_knot")
preferences = bpy.context.preferences.addons["ribbon_knot"].preferences
drawing = draw_curve(drawn_points(0.005), "my knot")
choose(drawing)
preferences.recorder = str(folder / "nowhere")
check_refused("there is no such program")
preferences.recorder = recorder
check_refused("tick it, too")
bpy.ops.preferences.addon_enable(module="ribbon_recording")

choose(draw_curve([(0, 0, 0), (0.1, 0, 0)], "short"))
check_refused("no line to follow")
closed = draw_curve(drawn_points(0.02), "closed")
closed.data.splines[0].use_cyclic_u = True
choose(closed)
check_refused("it is closed")
choose(drawing)
check_refused("'width' of the ribbon", width=0.0002, fabric="wool")

# A post through the middle, as Blender's user adds one.
bpy.ops.mesh.primitive_cylinder_add(radius=0.015, depth=0.3, vertices=24, location=(0, 0, 0))
post = bpy.context.active_object
choose(drawing, post)
check(tie(width=0.01, duration=1.0) == {"FINISHED"}, "the curve was not tied")
recording = ribbon.open(folder / "my-knot.rbn")
verification = ribbon.verify(recording)
check(not verification.complaints, verification.complaints)
check("trefoil, left-handed" in str(verification.knot), f"the knot is {verification.knot}")
check(recording.obstacle is not None and len(recording.obstacle.vertices) == 48, "the post is another")
thing = bpy.context.active_object
check(thing["ribbon_recording"] == str(folder / "my-knot.rbn"), "what came back is no recording")
check_lies_on(drawing, recording)

# In a scene of centimetres, too, whose drawing is a hundred times as large in Blender's units, and a metre up.
units = bpy.context.scene.unit_settings
units.scale_length = 0.01
in_centimetres = draw_curve([[100 * x for x in point] for point in drawn_points(0.005)], "centimetres")
in_centimetres.location.z = 100
choose(in_centimetres)
check(tie(width=0.01, duration=0.02) == {"FINISHED"}, "the curve in centimetres was not tied")
check(abs(ribbon.open(folder / "centimetres.rbn").width - 0.01) < 1e-9, "the width is another")
check_lies_on(in_centimetres, ribbon.open(folder / "centimetres.rbn"))
bpy.data.objects.remove(bpy.context.active_object)
units.scale_length = 1

# Tied again, it takes the place of the one before.
choose(drawing, post)
check(tie(width=0.01, duration=0.02, across=5) == {"FINISHED"}, "it was not tied again")
ribbons = [thing for thing in bpy.context.scene.objects if "ribbon_recording" in thing]
check(len(ribbons) == 1 and ribbons[0] == bpy.context.active_object, f"there are {ribbons}")
check(bpy.context.selected_objects == ribbons, "something else is chosen")

# What cannot be read takes nobody's place.
broken = folder / "broken-recorder"
broken.write_text('#!/bin/sh\necho "no recording" > "$3"\n')
broken.chmod(0o755)
preferences.recorder = str(broken)
choose(drawing, post)
check_refused("my-knot.rbn")
check(ribbons[0].name in bpy.context.scene.objects, "the ribbon before is gone")
preferences.recorder = recorder
choose(drawing, post)
check(tie(width=0.01, duration=0.02) == {"FINISHED"}, "after that it was not tied")

# The same drawing on other walls, and its mirror image: where it lies and what passes over is seen.
for name, turn, height, expected in (("front", (math.pi / 2, 0, 0), 0.02, ('axis = "z"', "left-handed")),
                                     ("side", (0, math.pi / 2, 0), 0.02, ('axis = "x"', "left-handed")),
                                     ("mirrored", (0, 0, 0), -0.02, ('axis = "y"', "right-handed"))):
    drawing = draw_curve(drawn_points(height), name)
    drawing.rotation_euler = turn
    bpy.context.view_layer.update()
    choose(drawing)
    check(tie(width=0.01, duration=0.02) == {"FINISHED"}, f"{name}: it was not tied")
    knot = str(ribbon.verify(ribbon.open(folder / f"{name}.rbn")).knot)
    text = (folder / f"{name}.toml").read_text()
    check(expected[0] in text and expected[1] in knot, f"{name}: {knot}, {text}")
    check("crossings" in text and "[obstacle]" not in text, f"{name}: {text}")

# A metre off the origin to each side that a drawing is seen from, round a post there: the ribbon begins on the drawing
# and closes on the post, and so it does where File > Import shows it later. The drawing hangs on an object that scales it.
for name, turn, middle in (("above", (0, 0, 0), (0.3, 0.2, 1)),
                           ("before", (math.pi / 2, 0, 0), (0.3, 1, 0.2)),
                           ("beside", (0, math.pi / 2, 0), (1, 0.3, -0.2))):
    wall = linked(bpy.data.objects.new("wall", None))
    wall.location, wall.rotation_euler, wall.scale = middle, turn, (0.5, 0.5, 0.5)
    drawing = draw_curve([[2 * x for x in point] for point in drawn_points(0.005)], name)
    drawing.parent = wall
    bpy.ops.mesh.primitive_cylinder_add(radius=0.015, depth=0.1, vertices=24, location=middle, rotation=turn)
    post = bpy.context.active_object
    choose(drawing, post)
    check(tie(width=0.01, duration=2) == {"FINISHED"}, f"{name}: it was not tied")
    recording = ribbon.open(folder / f"{name}.rbn")
    check_lies_on(drawing, recording)
    check_closes_on(post)
    before = set(bpy.data.objects)
    bpy.ops.import_scene.ribbon_recording(filepath=str(folder / f"{name}.rbn"))
    check_lies_on(drawing, recording)
    shown, = set(bpy.data.objects) - before - {bpy.context.active_object}
    off = max(min((shown.matrix_world @ a.co - post.matrix_world @ b.co).length for b in post.data.vertices)
              for a in shown.data.vertices)
    check(off < 1e-6, f"{name}: the post is shown {off} m off")

# Far off, where Blender itself knows places to a quarter of a millimetre, it is no coarser.
far = draw_curve(drawn_points(0.005), "far")
far.location = (3000, -2000, 1000)
bpy.context.view_layer.update()
choose(far)
check(tie(width=0.01, duration=0.02) == {"FINISHED"}, "far off nothing was tied")
check_lies_on(far, ribbon.open(folder / "far.rbn"))
check("left-handed" in str(ribbon.verify(ribbon.open(folder / "far.rbn")).knot), "far off it is another knot")

# A mirrored object is no more inside out than Blender shows it; one of points alone is refused.
post.scale.x = -1
choose(drawing, post)
check(tie(width=0.01, duration=0.02) == {"FINISHED"}, "round the mirrored post nothing was tied")
stone = ribbon.open(folder / "beside.rbn").obstacle
corners = stone.vertices[stone.triangles].astype(float)
volume = numpy.linalg.det(corners - stone.vertices.mean(axis=0)).sum() / 6
check(abs(volume / (12 * math.sin(math.pi / 12) * 0.015 ** 2 * 0.1) - 1) < 1e-3, f"the mirrored post has {volume} m3")
points = linked(bpy.data.objects.new("points", bpy.data.meshes.new("points")))
choose(drawing, points)
check_refused("points: it has no faces")

# What somebody else has made stays as it is, whichever of the files it is.
logo = draw_curve(drawn_points(0.02), "logo")
choose(logo, post)
for ending in (".svg", ".obj", ".toml", ".rbn"):
    other = folder / f"logo{ending}"
    other.write_text("of somebody else")
    check_refused("exists already, and is not what this add-on wrote", width=0.01, duration=0.02)
    check(list(folder.glob("logo.*")) == [other] and other.read_text() == "of somebody else", f"{other} was replaced")
    other.unlink()

# So does what was edited, and what belongs to another drawing whose files have the same names.
check(tie(width=0.01, duration=0.02) == {"FINISHED"}, "the logo was not tied")
choose(logo, post)
for ending in (".svg", ".obj", ".toml"):
    edited = folder / f"logo{ending}"
    whole = edited.read_bytes()
    edited.write_bytes(whole + b"\n")
    check_refused(f"{edited}: exists already, and is not what this add-on wrote", width=0.01, duration=0.02)
    check(edited.read_bytes() == whole + b"\n", f"{edited} was replaced")
    edited.write_bytes(whole)
check(tie(width=0.01, duration=0.02) == {"FINISHED"}, "the logo was not tied again")
before = (folder / "logo.rbn").read_bytes()
choose(draw_curve(drawn_points(0.02), "logo!--"), post)
check_refused("rename the drawing", width=0.01, duration=0.02)
check((folder / "logo.rbn").read_bytes() == before, "the recording of another drawing was replaced")
bpy.context.active_object.name = "--> 'a\\b\"é"
check(tie(width=0.01, duration=0.02) == {"FINISHED"} and (folder / "a-b-é.rbn").exists(), "signs in a name hinder it")
choose(bpy.data.objects["--> 'a\\b\"é"], post)
check(tie(width=0.01, duration=0.02) == {"FINISHED"}, "signs in a name hinder it the second time")

# Without heights over and under alternate; with some it cannot be told.
choose(draw_stroke([(x, y, 0) for x, y, _ in drawn_points(0)], "flat ink"))
check(tie(width=0.01, duration=0.02, fabric="silk") == {"FINISHED"}, "the stroke was not tied")
text = (folder / "flat-ink.toml").read_text()
check("crossings" not in text and 'fabric = "silk"' in text, text)
in_layer = draw_stroke(drawn_points(0.005), "moved layer")
in_layer.data.layers.active.location.z = 1
in_layer.location.x = 0.5
choose(in_layer)
check(tie(width=0.01, duration=0.02) == {"FINISHED"}, "the stroke of a moved layer was not tied")
twin = draw_curve([(x + 0.5, y, z + 1) for x, y, z in drawn_points(0.005)], "twin")
check_lies_on(twin, ribbon.open(folder / "moved-layer.rbn"))
in_layer.data.layers.active.frames[0].strokes[0].use_cyclic = True
choose(in_layer)
check_refused("it is closed")
choose(draw_stroke([(x, y, max(0, z) * (y > 0.03)) for x, y, z in drawn_points(0.02)], "half flat"))
check_refused("at one height")

# The fabrics that it offers are those that the recorder lists.
refused = subprocess.run([recorder, folder / "flat-ink.toml", "--set", "cloth.fabric=none", "-o", folder / "none.rbn"],
                         capture_output=True, text=True).stderr
listed = re.findall('"([^"]+)"', refused.partition("one of")[2].partition(", not")[0])
check(tuple(listed) == sys.modules["ribbon_knot"].FABRICS, f"other fabrics: {refused}")

second = post.copy()
linked(second)
choose(drawing, post, second)
check_refused("several meshes")
choose(drawing)
try:
    bpy.ops.object.tie_ribbon()
except RuntimeError as error:
    check("save it first" in str(error), f"the refusal says {error}")
else:
    sys.exit("FAILED: a knot without a folder was tied")

bpy.ops.preferences.addon_disable(module="ribbon_knot")
print("Blender ties what is drawn.")
