"""Blender opens what ribbon-convert writes, and sees what was recorded.

  blender -b --factory-startup -noaudio --python-exit-code 1 --python blender_import.py -- \
      RIBBON_CONVERT BLENDER_SAMPLES FOLDER

Every export is imported and compared with the recording: objects, names, materials, numbers of
vertices and faces, vertex order, uv, axes (Blender is z up: x, -z, y of the recording), unit, frame
rate, and each position in each frame. The same comparison must refuse the spoiled exports, or it
would prove nothing.
"""

import json
import pathlib
import subprocess
import sys

import bpy
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from blender_scene import CACHES, attach_cache, evaluated, import_file  # noqa: E402
from recorded_motion import normals_of  # noqa: E402

# Blender turns imported objects upright by a rotation in single precision, so its positions are
# exact only to a few times this part of the largest coordinate.
FLOAT_ROUNDING = 4 * 2.0**-23

# The frame in blender_samples' spoiled OBJ and FBX files: the one with coincident vertices.
SPOILED_FRAME = 2

# In frames after the first, Blender shows normals as it keeps them: as angles to those that it computes. Of the smooth
# wave compared here they are off by 0.011; of tight knots by more (benchmarks/blender_normals.py).
NORMALS_TOLERANCE = 0.015

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
    "other_name": "objects are",
    # FBX tells its rate; in glTF frames come at other times.
    "wrong_rate": {".fbx": "the frame rate is", ".glb": "a position is off"},
}

# Faults that have no place in what is compared here.
UNSEEN = ("inside_out",)

# The formats that hold a mesh and its motion.
SCENES = (".glb", ".fbx")

# Where importers put the first frame of a motion.
FIRST_FRAME = {".pc2": 0, ".mdd": 0, ".glb": 0, ".fbx": 1}


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
        self.frames_per_second = data["frames_per_second"]
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
    """Problems of one exported frame; none when it is right. glTF has triangles alone."""
    corners = 3 if path.suffix == ".glb" else corners
    try:
        import_file(path, reference.frames_per_second if path.suffix == ".glb" else 24)
    except Exception as error:  # whatever an importer raises on a broken file
        return ["Blender does not open it: " + str(error).strip().splitlines()[-1]]
    problems = compare_objects(reference)
    if reference.ribbon not in bpy.data.objects:
        return problems
    mesh = bpy.data.objects[reference.ribbon].data
    return problems + compare_ribbon(reference, mesh, frame, corners) + compare_uv(mesh, reference.uv)


def check_frames(reference, first, corners):
    """Problems of what Blender shows, over all frames; the first is the scene's frame `first`."""
    problems = []
    for frame in range(len(reference.frames)):
        bpy.context.scene.frame_set(first + frame)
        ribbon = evaluated(bpy.data.objects[reference.ribbon])
        problems += [
            f"frame {frame}: {problem}"
            for problem in compare_ribbon(reference, ribbon.data, frame, corners)
        ]
    return problems


def check_cache(base, cache, reference, corners=3):
    """Problems of a point cache on its base."""
    problems = check_file(base, reference, 0, corners)
    attach_cache(reference.ribbon, cache)
    return problems + check_frames(reference, FIRST_FRAME[cache.suffix], corners)


def compare_rate(reference):
    render = bpy.context.scene.render
    rate = render.fps / render.fps_base
    wanted = reference.frames_per_second
    return [] if rate == wanted else [f"the frame rate is {rate}, not {wanted}"]


def compare_shapes(reference):
    """One shape for each frame but the first, which is the mesh itself."""
    keys = bpy.data.objects[reference.ribbon].data.shape_keys
    found = [key.name for key in keys.key_blocks][1:] if keys else []
    wanted = [f"frame {frame + 1}" for frame in range(1, len(reference.frames))]
    return [] if found == wanted else [f"shapes are {found}, not {wanted}"]


def check_motion(path, reference, corners=3):
    """Problems of a file that holds the mesh and its motion."""
    problems = check_file(path, reference, 0, corners)
    if reference.ribbon not in bpy.data.objects:
        return problems
    problems += compare_shapes(reference)
    if path.suffix == ".fbx":
        problems += compare_rate(reference)
    corners = 3 if path.suffix == ".glb" else corners
    return problems + check_frames(reference, FIRST_FRAME[path.suffix], corners)


def seen_normals(obj):
    """The normal at each vertex, in the recording's axes, and the faces. All corners of a vertex have the same."""
    mesh = evaluated(obj).data
    mesh.calc_normals_split()
    normals = numpy.zeros((len(mesh.vertices), 3))
    for loop in mesh.loops:
        normals[loop.vertex_index] = loop.normal
    for loop in mesh.loops:
        if abs(normals[loop.vertex_index] - numpy.array(loop.normal)).max() > 1e-4:
            return None, None
    normals = normals @ numpy.array(obj.matrix_world.to_3x3()).T
    normals /= numpy.linalg.norm(normals, axis=1, keepdims=True)
    return normals[:, [0, 2, 1]] * [1, 1, -1], [list(p.vertices) for p in mesh.polygons]


def compare_normals(reference, frame, tolerance):
    """Problems of what the ribbon shows now, beside the smooth normals of a recorded frame."""
    normals, faces = seen_normals(bpy.data.objects[reference.ribbon])
    if normals is None:
        return ["a vertex with several normals"]
    worst = abs(normals - normals_of(reference.frames[frame], faces)).max()
    return [] if worst <= tolerance else [f"frame {frame}: normals are off by {worst:.3g}"]


def check_normals(path, reference, frames, shown=None):
    """Problems of the normals of some frames, of one file. `shown`: the frame beside which all are held."""
    import_file(path, reference.frames_per_second)
    problems = []
    for frame in frames:
        bpy.context.scene.frame_set(FIRST_FRAME.get(path.suffix, 0) + frame)
        tolerance = 1e-3 if frame == 0 else NORMALS_TOLERANCE
        problems += compare_normals(reference, frame if shown is None else shown, tolerance)
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
        if path.stem in ("right", "one_frame"):
            self.accepts(f"spoiled {path.name}", problems)
        else:
            said = FAULTS[path.stem]
            self.refuses(f"spoiled {path.name}", problems, said if isinstance(said, str) else said[path.suffix])


def check_exports(verdicts, convert, folder, sample, faces, corners):
    reference = Reference(folder / f"{sample}.json")
    recording = folder / f"{sample}.rbn"
    what = f"{sample} {faces}"
    out = folder / sample / faces
    for name in ("knot.{frame:04}.obj", "knot.{frame:04}.fbx", "pc2/knot.pc2", "mdd/knot.mdd", "knot.glb", "knot.fbx"):
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
    for extension in SCENES:
        path = out / f"knot{extension}"
        verdicts.accepts(f"{what} {path.name}", check_motion(path, reference, corners))


def check_placed(verdicts, convert, folder):
    """FBX says its axes and unit, and glTF's nodes bring them back, so that others than the
    recording's come to the same."""
    reference = Reference(folder / "near.json")
    out = folder / "near/placed"
    for name in ("knot.{frame}.fbx", "knot.fbx", "knot.glb"):
        command = [convert, folder / "near.rbn", "-o", out / name, "--quiet"]
        subprocess.run([*command, "--up", "z", "--unit", "cm"], check=True)
    for extension in SCENES:
        path = out / f"knot{extension}"
        verdicts.accepts(f"near z-up cm {path.name}", check_motion(path, reference))
    for frame in range(len(reference.frames)):
        path = out / f"knot.{frame + 1:04}.fbx"
        verdicts.accepts(f"near z-up cm {path.name}", check_file(path, reference, frame))


def check_all_normals(verdicts, convert, folder):
    """But those of the frame with coincident vertices, about which readers differ."""
    reference = Reference(folder / "near.json")
    out = folder / "near/normals"
    for name in ("knot.0001.obj", "knot.glb", "knot.fbx"):
        first = ["--frames", "1"] if name.endswith(".obj") else []
        command = [convert, folder / "near.rbn", "-o", out / name, "--normals", "--quiet", *first]
        subprocess.run([str(word).replace("0001", "{frame:04}") for word in command], check=True)
        frames = [0] if first else [0, 1, 3, 4]
        verdicts.accepts(f"near normals {name}", check_normals(out / name, reference, frames))
    stale = check_normals(out / "knot.fbx", reference, [1], shown=0)
    verdicts.refuses("normals of frame 1 for frame 2", stale, "normals are off")
    flat = check_normals(folder / "near/triangles/knot.glb", reference, [0])
    verdicts.refuses("no normals", flat, "normal")


def check_that_faults_are_seen(verdicts, folder):
    reference = Reference(folder / "near.json")
    for path in sorted((folder / "spoiled").iterdir()):
        if path.suffix in (".obj", ".fbx"):
            verdicts.judges(path, check_file(path, reference, SPOILED_FRAME))
    for extension in (".obj", ".fbx"):
        neighbour = folder / "near/triangles" / f"knot.0002{extension}"
        problems = check_file(neighbour, reference, 0)
        verdicts.refuses(f"frame 2 for frame 1, {extension}", problems, "a position is off")


def check_that_faulty_motions_are_seen(verdicts, folder):
    base = folder / "near/triangles/pc2/knot.obj"
    reference = Reference(folder / "near.json")
    for path in sorted((folder / "spoiled_motions").iterdir()):
        if seen_in_cache(path):
            verdicts.judges(path, check_cache(base, path, reference))
        elif path.suffix in SCENES and path.stem not in UNSEEN:
            verdicts.judges(path, check_motion(path, reference))
    for path in sorted((folder / "spoiled_scenes").iterdir()):
        reference = Reference(folder / "near.json")
        if path.stem == "one_frame":
            del reference.frames[1:]
        verdicts.judges(path, check_motion(path, reference))


def main():
    convert, samples, folder = sys.argv[sys.argv.index("--") + 1 :]
    folder = pathlib.Path(folder)
    subprocess.run([samples, folder], check=True)
    verdicts = Verdicts()
    for sample in ("near", "far"):
        check_exports(verdicts, convert, folder, sample, "triangles", 3)
    check_exports(verdicts, convert, folder, "near", "quads", 4)
    check_placed(verdicts, convert, folder)
    check_all_normals(verdicts, convert, folder)
    check_that_faults_are_seen(verdicts, folder)
    check_that_faulty_motions_are_seen(verdicts, folder)
    if verdicts.failed:
        raise SystemExit(f"{verdicts.failed} comparisons went wrong")
    print("Blender", bpy.app.version_string, "sees what was recorded", flush=True)


main()
