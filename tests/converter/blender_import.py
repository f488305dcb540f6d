"""Blender opens what ribbon-convert writes, and sees what was recorded.

  blender -b --factory-startup -noaudio --python-exit-code 1 --python blender_import.py -- \
      RIBBON_CONVERT BLENDER_SAMPLES FOLDER

Every export is imported and compared with the recording: objects, names, materials, numbers of
vertices and faces, vertex order, uv, axes (Blender is z up: x, -z, y of the recording), unit, and
each position. The same comparison must refuse the spoiled exports, or it would prove nothing.
"""

import json
import pathlib
import subprocess
import sys

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from blender_scene import CACHES, attach_cache, evaluated, import_file  # noqa: E402

# Blender turns imported objects upright by a rotation in single precision, so its positions are
# exact only to a few times this part of the largest coordinate.
FLOAT_ROUNDING = 4 * 2.0**-23

# The frame in blender_samples' spoiled OBJ and FBX files: the one with coincident vertices.
SPOILED_FRAME = 2

# What the comparison must say about each fault that blender_samples plants.
FAULTS = {
    "moved_vertex": "a position is off",
    "moved_obstacle": "a position is off",
    "swapped_vertices": "a position is off",
    "wrong_axes": "a position is off",
    "hundredfold": "a position is off",
    "wrong_unit": "a position is off",
    "swapped_frames": "a position is off",
    "frozen": "a position is off",
    "swapped_uv": "uv differ",
    "wrong_name": "objects are",
    "unrepaired": "Blender does not open it",
}


class Reference:
    """What the recording holds (blender_samples wrote it)."""

    def __init__(self, path):
        data = json.loads(path.read_text())
        self.ribbon = data["ribbon"]
        self.obstacle = data["obstacle"]
        self.length = data["length"]
        self.uv = data["uv"]
        self.quads = data["quads"]
        self.obstacle_vertices = data["obstacle_vertices"]
        self.obstacle_triangles = data["obstacle_triangles"]
        self.frames = data["frames"]
        largest = max(abs(x) for p in self.frames[0] + self.obstacle_vertices for x in p)
        self.tolerance = 1e-5 * self.length + FLOAT_ROUNDING * largest


def z_up(point):
    x, y, z = point
    return (x, -z, y)


def largest_distance(ours, expected):
    return max(
        max(abs(a - b) for a, b in zip(p, z_up(q))) for p, q in zip(ours, expected)
    )


def world_positions(obj, mesh):
    return [obj.matrix_world @ vertex.co for vertex in mesh.vertices]


def compare_uv(mesh, uv):
    """Every corner has its vertex's uv, so vertices match the recording's by uv too."""
    if not mesh.uv_layers:
        return ["the ribbon has no uv"]
    layer = mesh.uv_layers[0].data
    worst = max(
        max(abs(a - b) for a, b in zip(layer[loop.index].uv, uv[loop.vertex_index]))
        for loop in mesh.loops
    )
    return [f"uv differ by {worst:.3g}"] if worst > 1e-6 else []


def compare_mesh(obj, mesh, expected, faces, corners, tolerance):
    what = repr(obj.name)
    if len(mesh.vertices) != len(expected):
        return [f"{what}: {len(mesh.vertices)} vertices, not {len(expected)}"]
    problems = []
    sizes = [len(polygon.vertices) for polygon in mesh.polygons]
    if sizes != [corners] * faces:
        problems.append(f"{what}: {len(sizes)} faces, not {faces} with {corners} corners each")
    distance = largest_distance(world_positions(obj, mesh), expected)
    if not distance <= tolerance:
        problems.append(f"{what}: a position is off by {distance:.3g} m")
    return problems


def compare_objects(reference):
    """Names, materials and the obstacle."""
    found = sorted((o.name, o.type) for o in bpy.data.objects)
    wanted = sorted([(reference.ribbon, "MESH"), (reference.obstacle, "MESH")])
    if found != wanted:
        return [f"objects are {found}, not {wanted}"]
    problems = []
    for name, material in ((reference.ribbon, "ribbon"), (reference.obstacle, "obstacle")):
        names = [slot.name for slot in bpy.data.objects[name].material_slots]
        if names != [material]:
            problems.append(f"{name!r} has materials {names}, not {material!r}")
    obstacle = bpy.data.objects[reference.obstacle]
    return problems + compare_mesh(
        obstacle,
        obstacle.data,
        reference.obstacle_vertices,
        reference.obstacle_triangles,
        3,
        reference.tolerance,
    )


def compare_ribbon(reference, mesh, frame, corners):
    ribbon = bpy.data.objects[reference.ribbon]
    faces = reference.quads if corners == 4 else 2 * reference.quads
    return compare_mesh(
        ribbon, mesh, reference.frames[frame], faces, corners, reference.tolerance
    )


def check_file(path, reference, frame, corners=3):
    """Problems of one exported frame; none when it is right."""
    try:
        import_file(path)
    except Exception as error:  # whatever an importer raises on a broken file
        return ["Blender does not open it: " + str(error).strip().splitlines()[-1]]
    problems = compare_objects(reference)
    if reference.ribbon not in bpy.data.objects:
        return problems
    mesh = bpy.data.objects[reference.ribbon].data
    return problems + compare_ribbon(reference, mesh, frame, corners) + compare_uv(mesh, reference.uv)


def check_cache(base, cache, reference, corners=3):
    """Problems of a point cache on its base, over all frames."""
    problems = check_file(base, reference, 0, corners)
    attach_cache(reference.ribbon, cache)
    for frame in range(len(reference.frames)):
        bpy.context.scene.frame_set(frame)
        ribbon = evaluated(bpy.data.objects[reference.ribbon])
        problems += [
            f"frame {frame}: {problem}"
            for problem in compare_ribbon(reference, ribbon.data, frame, corners)
        ]
    return problems


def seen_in_cache(path):
    """A point cache with a fault of its positions, which are all that it holds."""
    faults = ("right", "moved_vertex", "swapped_frames", "frozen")
    return path.suffix in CACHES and path.stem in faults


class Verdicts:
    def __init__(self):
        self.failed = 0

    def _say(self, good, what, why):
        self.failed += 0 if good else 1
        print(f"{'ok    ' if good else 'FAILED'} {what}: {why}", flush=True)

    def accepts(self, what, problems):
        self._say(not problems, what, "; ".join(problems) or "as recorded")

    def refuses(self, what, problems, reason):
        good = any(reason in problem for problem in problems)
        answer = "; ".join(problems) or "nothing wrong"
        self._say(good, what, f"refused: {answer}" if good else f"not {reason!r}, but: {answer}")

    def judges(self, path, problems):
        """A file of blender_samples, whose name tells its fault."""
        if path.stem == "right":
            self.accepts(f"spoiled {path.name}", problems)
        else:
            self.refuses(f"spoiled {path.name}", problems, FAULTS[path.stem])


def check_exports(verdicts, convert, folder, sample, faces, corners):
    reference = Reference(folder / f"{sample}.json")
    recording = folder / f"{sample}.rbn"
    what = f"{sample} {faces}"
    out = folder / sample / faces
    for name in ("knot.{frame:04}.obj", "knot.{frame:04}.fbx", "pc2/knot.pc2", "mdd/knot.mdd"):
        command = [convert, recording, "-o", out / name, "--faces", faces, "--quiet"]
        subprocess.run(command, check=True)
    for extension in (".obj", ".fbx"):
        for frame in range(len(reference.frames)):
            path = out / f"knot.{frame + 1:04}{extension}"
            problems = check_file(path, reference, frame, corners)
            verdicts.accepts(f"{what} {path.name}", problems)
    for extension in CACHES:
        cache = out / f"{extension[1:]}/knot{extension}"
        problems = check_cache(cache.with_suffix(".obj"), cache, reference, corners)
        verdicts.accepts(f"{what} {cache.name}", problems)


def check_placed(verdicts, convert, folder):
    """FBX says its axes and unit, so that others than the recording's come to the same."""
    reference = Reference(folder / "near.json")
    out = folder / "near/placed"
    command = [convert, folder / "near.rbn", "-o", out / "knot.{frame}.fbx", "--quiet"]
    subprocess.run([*command, "--up", "z", "--unit", "cm"], check=True)
    for frame in range(len(reference.frames)):
        path = out / f"knot.{frame + 1:04}.fbx"
        verdicts.accepts(f"near z-up cm {path.name}", check_file(path, reference, frame))


def check_that_faults_are_seen(verdicts, folder):
    reference = Reference(folder / "near.json")
    spoiled = folder / "spoiled"
    faults = sorted(path for path in spoiled.iterdir() if path.suffix in (".obj", ".fbx"))
    for path in faults:
        verdicts.judges(path, check_file(path, reference, SPOILED_FRAME))
    for extension in (".obj", ".fbx"):
        neighbour = folder / "near/triangles" / f"knot.0002{extension}"
        problems = check_file(neighbour, reference, 0)
        verdicts.refuses(f"frame 2 for frame 1, {extension}", problems, "a position is off")
    motions = folder / "spoiled_motions"
    for cache in sorted(path for path in motions.iterdir() if seen_in_cache(path)):
        verdicts.judges(cache, check_cache(folder / "near/triangles/pc2/knot.obj", cache, reference))


def main():
    convert, samples, folder = sys.argv[sys.argv.index("--") + 1 :]
    folder = pathlib.Path(folder)
    subprocess.run([samples, folder], check=True)
    verdicts = Verdicts()
    for sample in ("near", "far"):
        check_exports(verdicts, convert, folder, sample, "triangles", 3)
    check_exports(verdicts, convert, folder, "near", "quads", 4)
    check_placed(verdicts, convert, folder)
    check_that_faults_are_seen(verdicts, folder)
    if verdicts.failed:
        raise SystemExit(f"{verdicts.failed} comparisons went wrong")
    print("Blender", bpy.app.version_string, "sees what was recorded", flush=True)


main()
