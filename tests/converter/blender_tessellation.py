"""What ribbon-convert writes stays free of intersections in Blender.

  blender -b --factory-startup -noaudio --python-exit-code 1 --python blender_tessellation.py -- \
      RIBBON_CONVERT COUNT_INTERSECTIONS KNOT.rbn FRAMES FOLDER

Every frame of a tight knot is imported in every format; the triangles into which Blender itself
divides the meshes go to CGAL, which counts the pairs that meet. There must be none. With quads that
begin anywhere there are some, or this would prove nothing.

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


RIBBON = "overhand-hourglass-8x400"  # the name of the scene
FRAMES_PER_SECOND = 5  # as tight_knot.sh records it


def meshes():
    """The scene's objects of the kind, the ribbon first."""
    found = [obj for obj in bpy.data.objects if obj.type == "MESH"]
    return sorted(found, key=lambda obj: obj.name != RIBBON)


def show_sequence(pattern):
    """Shows one file a frame."""
    for path in sorted(pattern.parent.glob("knot.*" + pattern.suffix)):
        import_file(path)
        yield


def show_cache(cache):
    """Shows the samples of a point cache on the mesh beside it."""
    import_file(cache.with_suffix(".obj"))
    attach_cache(RIBBON, cache)
    samples = struct.unpack_from("<i", cache.read_bytes(), 28)[0]
    for frame in range(samples):
        bpy.context.scene.frame_set(frame)
        yield


def show_motion(path):
    """Shows the shapes of a file that holds the mesh and its motion."""
    import_file(path, FRAMES_PER_SECOND)
    keys = bpy.data.objects[RIBBON].data.shape_keys.key_blocks
    first = 1 if path.suffix == ".fbx" else 0
    for frame in range(len(keys)):
        bpy.context.scene.frame_set(first + frame)
        yield


# What is written, and how Blender shows frame after frame of it.
EXPORTS = {
    "knot.{frame:04}.obj": show_sequence,
    "knot.{frame:04}.fbx": show_sequence,
    "knot.pc2": show_cache,
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


def scene_bytes():
    """All that the scene shows, as count_intersections reads it."""
    parts = [tessellation(obj) for obj in meshes()]
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
    def __init__(self, convert, count, recording, frames, folder):
        self.convert = convert
        self.count = count
        self.recording = recording
        self.frames = int(frames)
        self.folder = pathlib.Path(folder)
        self.failed = 0

    def export(self, name, options):
        output = self.folder / ("".join(options).strip("-") or "default") / name
        command = [self.convert, self.recording, "-o", output, "--quiet", "--force", *options]
        subprocess.run(command, check=True)
        return output

    def pairs(self, show, output):
        """How many pairs of triangles meet in each frame."""
        dump = output.parent / "triangles"
        with dump.open("wb") as file:
            for _ in show(output):
                file.write(scene_bytes())
        counted = subprocess.run([self.count, dump], check=True, capture_output=True, text=True)
        return [int(line) for line in counted.stdout.split()]

    def say(self, good, what, pairs):
        self.failed += 0 if good else 1
        verdict = "ok    " if good else "FAILED"
        print(f"{verdict} {what}: {sum(pairs)} pairs meet in {len(pairs)} frames", flush=True)

    def accept(self, name, options):
        pairs = self.pairs(EXPORTS[name], self.export(name, options))
        self.say(pairs == [0] * self.frames, " ".join([name, *options]), pairs)

    def refuse_spoiled(self, name):
        output = self.export(name, ["--faces", "quads"])
        for obj in output.parent.glob("*.obj"):
            begin_anywhere(obj)
        pairs = self.pairs(EXPORTS[name], output)
        self.say(len(pairs) == self.frames and sum(pairs) >= 24, f"spoiled {name}", pairs)


def main():
    check = Check(*sys.argv[sys.argv.index("--") + 1 :])
    for name in EXPORTS:
        check.accept(name, [])
    for name in ("knot.{frame:04}.obj", "knot.pc2"):
        check.accept(name, ["--faces", "quads"])
        check.refuse_spoiled(name)
    check.accept("knot.{frame:04}.obj", ["--thickness", "0.003"])
    check.accept("knot.pc2", ["--up", "z", "--unit", "cm", "--scale", "0.3"])
    if check.failed:
        raise SystemExit(f"{check.failed} comparisons went wrong")


main()
