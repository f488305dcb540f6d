"""Installs the add-on in Blender as a user does, imports a recording by it and looks at what is there.

usage: import_recording.py PACKAGE ADD_ON FOLDER      PACKAGE: folder in which the package ribbon lies
"""

import contextlib
import io
import os
import sys
from pathlib import Path

import bpy
import numpy

package, add_on, folder = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, package)
folder = Path(folder)

import ribbon  # noqa: E402, found only now

ALONG, ACROSS, FRAMES = 20, 4, 12


def wave(frame):
    positions = numpy.empty((ALONG, ACROSS, 3))
    positions[..., 0] = numpy.linspace(0, 0.4, ALONG)[:, None]
    positions[..., 1] = 0.05 * numpy.sin(positions[..., 0] * 20 + frame)
    positions[..., 2] = numpy.linspace(-0.02, 0.02, ACROSS)
    return positions


def check(claim, text):
    if not claim:
        sys.exit(f"FAILED: {text}")


def vertices_of(thing):
    numbers = numpy.empty(3 * len(thing.data.vertices), dtype=numpy.float32)
    thing.data.vertices.foreach_get("co", numbers)
    return numbers.reshape(-1, 3)


def check_frames(recording, first):
    scene = bpy.context.scene
    thing = next(thing for thing in scene.objects if "ribbon_recording" in thing)
    for frame in (first + 5, first, first + FRAMES - 1, first + 3):
        scene.frame_set(frame)
        expected = recording[frame - first].reshape(-1, 3)
        check((vertices_of(thing) == expected).all(), f"frame {frame} is not as recorded, bit for bit")
        world = numpy.array(thing.matrix_world) @ [*map(float, expected[7]), 1]
        check(abs(world[2] - expected[7][1]) < 1e-6, "up is not up")
    scene.frame_set(first + FRAMES + 50)
    check((vertices_of(thing) == recording[-1].reshape(-1, 3)).all(), "behind the last frame it does not hold still")
    return thing


def check_refused(path, word, **settings):
    before = len(bpy.data.objects)
    try:
        bpy.ops.import_scene.ribbon_recording(filepath=str(path), **settings)
    except RuntimeError as error:
        check(word in str(error), f"the refusal says {error}")
    else:
        sys.exit(f"FAILED: {path} was imported")
    check(len(bpy.data.objects) == before, f"{path} left something behind")


def printed_at(frame):
    with contextlib.redirect_stdout(io.StringIO()) as said:
        bpy.context.scene.frame_set(frame)
    return said.getvalue()


path, picture = folder / "wave.rbn", folder / "cloth.png"
stone = ribbon.Mesh([[0, 0, 0], [0, 0, 0.1], [0.1, 0, 0], [0, 0.1, 0]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
                    "stone")
ribbon.write(path, map(wave, range(FRAMES)), length=0.4, width=0.04, frames_per_second=23.976, name="wave",
             obstacle=stone)
recording = ribbon.open(path)
image = bpy.data.images.new("cloth", 8, 4)
image.filepath_raw, image.file_format = str(picture), "PNG"
image.save()

bpy.ops.preferences.addon_install(filepath=add_on)
bpy.ops.preferences.addon_enable(module=Path(add_on).stem)
check_refused(folder / "nothing.rbn", "nothing.rbn")
whole = path.read_bytes()
(folder / "other.rbn").write_bytes(b"no recording" * 100)
check_refused(folder / "other.rbn", "other.rbn")
(folder / "cut.rbn").write_bytes(whole[:100])
check_refused(folder / "cut.rbn", "cut.rbn")
check_refused(path, "is no picture", texture=str(path))
check_refused(path, "nothing.png", texture=str(folder / "nothing.png"))
bpy.ops.import_scene.ribbon_recording(filepath=str(path), first_frame=11, texture=str(picture))

thing = check_frames(recording, 11)
scene = bpy.context.scene
check(abs(scene.render.fps / scene.render.fps_base - 23.976) < 1e-4, "the rate is another")
check((scene.frame_start, scene.frame_end) == (11, 10 + FRAMES), "the range of frames is another")
check([list(face.vertices) for face in thing.data.polygons] == recording.triangles.tolist(), "triangles are others")
check(len(thing.data.uv_layers) == 1 and thing.data.materials[0].use_nodes, "there is no cloth")
check("stone" in scene.objects, "there is no obstacle")

bpy.ops.wm.save_as_mainfile(filepath=str(folder / "wave.blend"))
bpy.ops.wm.open_mainfile(filepath=str(folder / "wave.blend"))
check_frames(recording, 11)

# What is damaged or was recorded anew holds still, and the console says why.
half = len(whole) // 2
(folder / "damaged.rbn").write_bytes(whole[:half] + bytes([whole[half] ^ 255]) + whole[half + 1:])
bpy.ops.import_scene.ribbon_recording(filepath=str(folder / "damaged.rbn"))
check("is damaged" in "".join(map(printed_at, range(1, FRAMES + 1))), "nothing told of the damage")
for across in (ACROSS, 2):
    ribbon.write(folder / "anew.rbn", [wave(0)[:, :across], wave(1)[:, :across]], length=0.4, width=0.04, force=True)
    bpy.ops.import_scene.ribbon_recording(filepath=str(folder / "anew.rbn"))
said = printed_at(2)
check("has 80 vertices" in said and "import it anew" in said, f"of an older ribbon it said {said!r}")
check((vertices_of(bpy.context.active_object) == ribbon.open(folder / "anew.rbn")[1].reshape(-1, 3)).all(),
      "the newer ribbon did not move")

# So it is, in a .blend that is opened again, where one is being recorded anew; the others move.
ribbon.write(folder / "moving.rbn", map(wave, range(FRAMES)), length=0.4, width=0.04)
bpy.ops.import_scene.ribbon_recording(filepath=str(folder / "moving.rbn"))
sys.modules["ribbon_recording"].opened.clear()
(folder / "anew.rbn").unlink()
begun = ribbon.Writer(folder / "anew.rbn", along=ALONG, across=2, length=0.4, width=0.04)
said = printed_at(4)
check("anew.rbn: the recording holds no frame yet" in said, f"of a recording without a frame it said {said!r}")
check((vertices_of(bpy.context.active_object) == ribbon.open(folder / "moving.rbn")[3].reshape(-1, 3)).all(),
      "beside a recording without a frame nothing moves")
begun.append(wave(5)[:, :2])
check("no frame yet" not in printed_at(5), "its first frame is not seen")

# What grows is followed.
bpy.ops.import_scene.ribbon_recording(filepath=str(folder / "anew.rbn"))
begun.append(wave(6)[:, :2])
bpy.context.scene.frame_set(2)
check((vertices_of(bpy.context.active_object) == ribbon.open(folder / "anew.rbn")[1].reshape(-1, 3)).all(),
      "a frame that came later is not shown")

# Names may be of any bytes: such a recording is imported, and when it is gone, the others move.
odd = folder / os.fsdecode(b"\xff.rbn")
ribbon.write(odd, [wave(0), wave(1)], length=0.4, width=0.04)
bpy.ops.import_scene.ribbon_recording(filepath=str(odd))
bpy.context.active_object.name = "A first one"
odd.unlink()
bpy.ops.import_scene.ribbon_recording(filepath=str(folder / "moving.rbn"))
sys.modules["ribbon_recording"].opened.clear()
check("cannot be opened" in printed_at(2), "nothing told of the one that is gone")
check((vertices_of(bpy.context.active_object) == ribbon.open(folder / "moving.rbn")[1].reshape(-1, 3)).all(),
      "beside one that is gone nothing moves")

# A script's paths are those of its folder; no frame of a scene is below 0.
os.chdir(folder)
bpy.ops.import_scene.ribbon_recording(filepath="moving.rbn", first_frame=-5)
os.chdir("/")
check(bpy.context.active_object["ribbon_recording"] == str(folder / "moving.rbn"), "the path stays that of a script")
check(bpy.context.active_object["ribbon_first_frame"] == bpy.context.scene.frame_start == 0, "the first frame is another")

bpy.ops.preferences.addon_disable(module=Path(add_on).stem)
print("Blender shows what was recorded.")
