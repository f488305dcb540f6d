"""How far the normals that Blender shows are from the smooth ones, in a .glb or .fbx that was written with --normals.

  ribbon-convert knot.rbn -o knot.glb --normals --frames ::10 --fps 50
  blender -b --factory-startup --python tests/benchmarks/blender_normals.py -- knot.glb

Prints, of the first frame and of all others, by how much a coordinate of a normal differs at most and at the median of all
vertices, and the largest angle. Vertices whose faces have no area are left out.
"""

import pathlib
import sys

import bpy
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "converter"))
from blender_scene import evaluated, import_file  # noqa: E402

FIRST_FRAME = {".glb": 0, ".fbx": 1}


def column(items, name, width, kind=float):
    values = numpy.zeros(len(items) * width, kind)
    items.foreach_get(name, values)
    return values.reshape(-1, width)


def smooth_normals(positions, triangles):
    """Weighted by area, as ribbon-convert writes them; not yet of length 1."""
    first, second, third = (positions[triangles[:, corner]] for corner in range(3))
    sums = numpy.zeros_like(positions)
    for corner in range(3):
        numpy.add.at(sums, triangles[:, corner], numpy.cross(second - first, third - first))
    return sums


def differences(ribbon):
    """Of each vertex: the largest difference of a coordinate, and the angle in degrees."""
    mesh = evaluated(ribbon).data
    mesh.calc_normals_split()
    corners = column(mesh.loops, "vertex_index", 1, int)[:, 0]
    smooth = smooth_normals(column(mesh.vertices, "co", 3), corners.reshape(-1, 3))
    lengths = numpy.linalg.norm(smooth, axis=1, keepdims=True)
    shown = numpy.zeros_like(smooth)
    shown[corners] = column(mesh.loops, "normal", 3)
    shown /= numpy.linalg.norm(shown, axis=1, keepdims=True)
    apart = (shown - smooth / numpy.maximum(lengths, 1e-300))[lengths[:, 0] > 0]
    halves = numpy.clip(numpy.linalg.norm(apart, axis=1) / 2, 0, 1)
    return numpy.abs(apart).max(axis=1), numpy.degrees(2 * numpy.arcsin(halves))


def told(what, frames):
    coordinates, angles = (numpy.concatenate(values) for values in zip(*frames))
    print(f"{what}: at most {coordinates.max():.2g} ({angles.max():.1f} degrees), "
          f"median {numpy.median(coordinates):.1g}")


path = pathlib.Path(sys.argv[-1])
import_file(path, 50)
ribbon = next(mesh for mesh in bpy.data.objects if mesh.type == "MESH" and mesh.data.shape_keys)
frames = []
for frame in range(len(ribbon.data.shape_keys.key_blocks)):
    bpy.context.scene.frame_set(FIRST_FRAME[path.suffix] + frame)
    frames.append(differences(ribbon))
told("first frame", frames[:1])
told(f"{len(frames) - 1} others", frames[1:])
