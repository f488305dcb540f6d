"""What ribbon-convert writes stays free of intersections in Blender.

  blender -b --factory-startup -noaudio --python-exit-code 1 --python blender_tessellation.py -- \
      RIBBON_CONVERT COUNT_INTERSECTIONS KNOT.rbn NAME RATE FOLDER [formats]

Every frame of a tight knot is imported in every format; the triangles into which Blender itself
divides the meshes go to CGAL, which counts the pairs that meet. There must be none, and every vertex
must be where the recording has it. With quads that begin anywhere some meet, or this would prove
nothing. NAME is the ribbon's, RATE the recording's frames a second; with the word "formats" only
what each writes by default is tried.

Coordinates are those of the objects, which are the file's: Blender turns objects upright by a
rotation, whose rounding is not the file's.
"""

import pathlib
import struct
import subprocess
import sys

import bpy
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from blender_scene import attach_cache, evaluated, import_file  # noqa: E402


# Of its length, how far a vertex may be from where the recording has it.
TOLERANCE = 1e-5


def meshes(ribbon):
    """The scene's objects of the kind, the ribbon first."""
    found = [obj for obj in bpy.data.objects if obj.type == "MESH"]
    return sorted(found, key=lambda obj: obj.name != ribbon)


def show_sequence(pattern, ribbon, rate):
    """Shows one file a frame."""
    for path in sorted(pattern.parent.glob("knot.*" + pattern.suffix)):
        import_file(path)
        yield


def samples_of(cache):
    """How many samples a point cache holds."""
    kind, place = ("<i", 28) if cache.suffix == ".pc2" else (">i", 0)
    with cache.open("rb") as file:
        return struct.unpack_from(kind, file.read(32), place)[0]


def show_cache(cache, ribbon, rate):
    """Shows the samples of a point cache on the mesh beside it."""
    import_file(cache.with_suffix(".obj"))
    attach_cache(ribbon, cache)
    for frame in range(samples_of(cache)):
        bpy.context.scene.frame_set(frame)
        yield


def show_motion(path, ribbon, rate):
    """Shows the shapes of a file that holds the mesh and its motion."""
    import_file(path, rate)
    keys = bpy.data.objects[ribbon].data.shape_keys.key_blocks
    first = 1 if path.suffix == ".fbx" else 0
    for frame in range(len(keys)):
        bpy.context.scene.frame_set(first + frame)
        yield


# What is written, and how Blender shows frame after frame of it.
EXPORTS = {
    "knot.{frame:04}.obj": show_sequence,
    "knot.{frame:04}.fbx": show_sequence,
    "knot.pc2": show_cache,
    "knot.mdd": show_cache,
    "knot.glb": show_motion,
    "knot.fbx": show_motion,
}


def tessellation(obj):
    """Points and triangles of an object, as Blender draws them."""
    mesh = evaluated(obj).data
    mesh.calc_loop_triangles()
    points = numpy.empty(3 * len(mesh.vertices), "<f4")
    triangles = numpy.empty(3 * len(mesh.loop_triangles), "<i4")
    mesh.vertices.foreach_get("co", points)
    mesh.loop_triangles.foreach_get("vertices", triangles)
    return points, triangles


def as_counted(parts):
    """Points and triangles of objects, as count_intersections reads them."""
    points = numpy.concatenate([points for points, _ in parts])
    first = numpy.cumsum([0] + [len(points) // 3 for points, _ in parts])
    triangles = numpy.concatenate(
        [triangles + numpy.int32(start) for (_, triangles), start in zip(parts, first)]
    )
    counts = [len(points) // 3, len(triangles) // 3, len(parts[0][1]) // 3]
    return numpy.array(counts, "<i4").tobytes() + points.tobytes() + triangles.tobytes()


def begin_anywhere(obj):
    """Spoils an OBJ: its quads begin at their smallest corner, as if diagonals did not matter."""

    def turned(line):
        if not line.startswith("f ") or len(line.split()) != 5:
            return line
        corners = line.split()[1:]
        first = min(range(4), key=lambda k: int(corners[k].split("/")[0]))
        return " ".join(["f"] + corners[first:] + corners[:first])

    obj.write_text("\n".join(map(turned, obj.read_text().splitlines())) + "\n")


class Check:
    def __init__(self, convert, count, recording, name, rate, folder):
        self.convert = convert
        self.count = count
        self.recording = recording
        self.name = name
        self.rate = float(rate)
        self.folder = pathlib.Path(folder)
        self.failed = 0
        self.recorded = numpy.load(self.export("knot.npy", []), mmap_mode="r")
        self.frames = len(self.recorded)
        along = numpy.diff(self.recorded[0], axis=0)
        self.length = numpy.linalg.norm(along, axis=2).sum(axis=0).max()

    def export(self, name, options):
        output = self.folder / ("".join(options).strip("-") or "default") / name
        command = [self.convert, self.recording, "-o", output, "--quiet", "--force", *options]
        subprocess.run(command, check=True)
        return output

    def seen(self, name, output):
        """How many pairs of triangles meet in each frame, and the largest distance of any vertex."""
        dump = output.parent / "triangles"
        worst = 0.0
        with dump.open("wb") as file:
            for number, _ in enumerate(EXPORTS[name](output, self.name, self.rate)):
                parts = [tessellation(obj) for obj in meshes(self.name)]
                file.write(as_counted(parts))
                worst = max(worst, self.distance(name, parts[0][0], number))
        counted = subprocess.run([self.count, dump], check=True, capture_output=True, text=True)
        dump.unlink()
        return [int(line) for line in counted.stdout.split()], worst

    def distance(self, name, points, number):
        """The largest one from what was recorded; has no meaning for solids and what is placed otherwise."""
        recorded = self.recorded[min(number, self.frames - 1)].reshape(-1, 3)
        if name.endswith(".glb"):  # whose importer turns the mesh upright, and not the object
            recorded = recorded[:, [0, 2, 1]] * numpy.float32([1, -1, 1])
        seen = points.reshape(-1, 3)
        return abs(seen - recorded).max() if len(seen) == len(recorded) else numpy.inf

    def say(self, good, what, pairs):
        self.failed += 0 if good else 1
        verdict = "ok    " if good else "FAILED"
        print(f"{verdict} {what}: {sum(pairs)} pairs meet in {len(pairs)} frames", flush=True)

    def accept(self, name, options=()):
        pairs, _ = self.seen(name, self.export(name, options))
        self.say(pairs == [0] * self.frames, " ".join([name, *options]), pairs)

    def accept_default(self, name):
        pairs, worst = self.seen(name, self.export(name, ()))
        good = pairs == [0] * self.frames and worst <= TOLERANCE * self.length
        self.say(good, f"{name}, at most {worst:.2g} m off", pairs)

    def refuse_spoiled(self, name):
        output = self.export(name, ["--faces", "quads"])
        for obj in output.parent.glob("*.obj"):
            begin_anywhere(obj)
        pairs, _ = self.seen(name, output)
        self.say(len(pairs) == self.frames and sum(pairs) >= 24, f"spoiled {name}", pairs)


def main():
    arguments = sys.argv[sys.argv.index("--") + 1 :]
    check = Check(*arguments[:6])
    for name in EXPORTS:
        check.accept_default(name)
    if arguments[6:] != ["formats"]:
        check_options(check)
    if check.failed:
        raise SystemExit(f"{check.failed} comparisons went wrong")


def check_options(check):
    for name in ("knot.{frame:04}.obj", "knot.pc2"):
        check.accept(name, ["--faces", "quads"])
        check.refuse_spoiled(name)
    check.accept("knot.{frame:04}.obj", ["--thickness", "0.003"])
    check.accept("knot.pc2", ["--up", "z", "--unit", "cm", "--scale", "0.3"])


main()
