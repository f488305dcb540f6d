"""What Blender writes is read as an obstacle where Blender shows it, and with the same outside.

    blender -b --python blender_files.py -- PRINT_OBSTACLE FOLDER
"""
import math
import os
import subprocess
import sys

import bpy

PRINT_OBSTACLE, FOLDER = sys.argv[sys.argv.index("--") + 1:]
CORNERS = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)]
OUTWARD = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


def rock():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    mesh = bpy.data.meshes.new("rock")
    mesh.from_pydata(CORNERS, [], OUTWARD)
    rock = bpy.data.objects.new("rock", mesh)
    rock.location = (0.5, 0.25, 0.125)
    rock.rotation_euler = (0.1, 0.2, 0.3)
    bpy.context.collection.objects.link(rock)
    return rock


def mirrored_rock():
    """Mirrored by an empty that holds it, as an object of a group."""
    shown = rock()
    mirror = bpy.data.objects.new("mirror", None)
    mirror.scale = (-1, 1, 1)
    bpy.context.collection.objects.link(mirror)
    shown.parent = mirror
    return shown


def skinned_rock():
    """Hangs on an armature that stands elsewhere; of one vertex half of the weight is given."""
    shown = rock()
    armature = bpy.data.objects.new("armature", bpy.data.armatures.new("armature"))
    bpy.context.collection.objects.link(armature)
    bpy.context.view_layer.objects.active = armature
    bpy.ops.object.mode_set(mode="EDIT")
    lower = armature.data.edit_bones.new("lower")
    lower.tail = (0, 0, 1)
    upper = armature.data.edit_bones.new("upper")
    upper.head, upper.tail, upper.parent = (0, 0, 1), (0, 0.5, 2), lower
    bpy.ops.object.mode_set(mode="OBJECT")
    armature.location = (5, 6, 7)
    armature.rotation_euler = (0.3, 0.2, 0.1)
    shown.parent = armature
    for joint, weights in (("lower", {0: 1, 1: 1, 2: 0.25}), ("upper", {2: 0.75, 3: 0.5})):
        group = shown.vertex_groups.new(name=joint)
        for vertex, weight in weights.items():
            group.add([vertex], weight, "REPLACE")
    shown.modifiers.new("armature", "ARMATURE").object = armature
    return shown


def shown_corners(shown):
    """As Blender shows them, y up."""
    bpy.context.view_layer.update()
    evaluated = shown.evaluated_get(bpy.context.evaluated_depsgraph_get())
    places = [evaluated.matrix_world @ vertex.co for vertex in evaluated.to_mesh().vertices]
    return [(place.x, place.z, -place.y) for place in places]


def obstacle_of(path):
    lines = subprocess.run([PRINT_OBSTACLE, path], check=True, capture_output=True, text=True).stdout.split("\n")
    rows = [line.split() for line in lines if line]
    return ([tuple(map(float, row[1:])) for row in rows if row[0] == "v"],
            [tuple(int(word) - 1 for word in row[1:]) for row in rows if row[0] == "f"])


def volume(corners, triangles):
    """What the triangles enclose; negative where they face inwards."""
    def determinant(a, b, c):
        return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return sum(determinant(*(corners[corner] for corner in triangle)) for triangle in triangles) / 6


def check(path, expected):
    corners, triangles = obstacle_of(path)
    assert len(corners) == 4 and len(triangles) == 4, f"{path}: {corners} {triangles}"
    for corner in expected:
        nearest = min(math.dist(corner, other) for other in corners)
        assert nearest < 1e-5, f"{path}: {corner} is {nearest} m away from {corners}"
    assert volume(corners, triangles) > 0, f"{path}: faces inwards"


FBX = {"y": {}, "z": {"axis_up": "Z", "axis_forward": "Y"}, "x": {"axis_up": "X", "axis_forward": "Y"},
       "metres": {"apply_scale_options": "FBX_SCALE_ALL"}}

for make in (rock, mirrored_rock, skinned_rock):
    expected = shown_corners(make())
    stem = os.path.join(FOLDER, make.__name__)
    for name, settings in FBX.items():
        path = f"{stem}_{name}.fbx"
        bpy.ops.export_scene.fbx(filepath=path, **settings)
        check(path, expected)
    bpy.ops.export_scene.gltf(filepath=stem + ".glb")
    check(stem + ".glb", expected)
