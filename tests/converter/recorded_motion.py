"""What a recording holds, to compare files with."""

import json

import numpy as np

from read_alembic import demand


class Mesh:
    def __init__(self, name):
        self.name = name
        self.positions = []
        self.uv = []
        self.faces = []


def read_obj(path):
    """The objects of an OBJ, whose numbers are shifted to begin at each object."""
    meshes = []
    before = 0
    for line in path.read_text().splitlines():
        keyword, _, rest = line.partition(" ")
        if keyword == "o":
            before += len(meshes[-1].positions) if meshes else 0
            meshes.append(Mesh(rest))
        elif keyword in ("v", "vt"):
            numbers = [np.float32(number) for number in rest.split()]
            (meshes[-1].positions if keyword == "v" else meshes[-1].uv).append(numbers)
        elif keyword == "f":
            corners = [int(corner.split("/")[0]) for corner in rest.split()]
            meshes[-1].faces.append([corner - 1 - before for corner in corners])
    return meshes


def normals_of(positions, faces):
    """At each vertex the mean of the faces around it, weighted by area; up where there is none."""
    points = np.asarray(positions, float)
    sums = np.zeros_like(points)
    for face in faces:
        for second, third in zip(face[1:], face[2:]):
            area = np.cross(points[second] - points[face[0]], points[third] - points[face[0]])
            for vertex in (face[0], second, third):
                sums[vertex] += area
    lengths = np.linalg.norm(sums, axis=1, keepdims=True)
    return np.where(lengths > 0, sums / np.maximum(lengths, 1e-300), [0.0, 1.0, 0.0])


class Reference:
    """What the recording holds (blender_samples wrote it), and its first frame as OBJ."""

    def __init__(self, path, obj, frames, has_normals=False):
        self.has_normals = has_normals
        data = json.loads(path.read_text())
        first, last = map(int, frames.split(":"))
        last += len(data["frames"]) + 1 if last < 0 else 0
        self.frames = np.array(data["frames"][first - 1 : last], np.float32)
        self.frames_per_second = data["frames_per_second"]
        self.uv = np.array(data["uv"], np.float32)
        self.ribbon, self.obstacle = read_obj(obj)
        self.obstacle_positions = np.array(data["obstacle_vertices"], np.float32)


def demand_same(ours, expected, what):
    ours, expected = np.asarray(ours), np.asarray(expected)
    demand(ours.shape == expected.shape, f"{what}: shape {ours.shape}, not {expected.shape}")
    demand(np.array_equal(ours, expected), f"{what} differ")


def demand_normals(ours, positions, mesh, what):
    """Within what single precision rounds."""
    ours = np.asarray(ours, float)
    demand(ours.shape == positions.shape, f"normals of {what}: shape {ours.shape}")
    worst = np.abs(ours - normals_of(positions, mesh.faces)).max()
    demand(worst <= 2e-7, f"normals of {what} differ by {worst:.3g}")


def demand_frames(samples, reference):
    demand(len(samples) == len(reference.frames), f"{len(samples)} frames")
    for number, (sample, positions) in enumerate(zip(samples, reference.frames), 1):
        demand_same(sample, positions, f"positions of frame {number}")


def bounds_of(positions):
    return np.concatenate([positions.min(axis=0), positions.max(axis=0)]).astype(float)[None]
