"""Blender add-on: Object > Tie a ribbon along this drawing, docs/blender.md.

The drawing goes out as a scene of ribbon-record, and what that records comes back by the add-on Ribbon recording.
"""

import json
import os
import re
import shutil
import subprocess
import zlib
from pathlib import Path

import bpy
import numpy
from bpy.props import EnumProperty, FloatProperty, IntProperty, StringProperty

bl_info = {
    "name": "Ribbon knot",
    "author": "The ribbon authors",
    "version": (0, 2, 0),
    "blender": (3, 4, 0),
    "location": "Object > Tie a ribbon along this drawing",
    "description": "A drawn curve as a ribbon that is fastened by ribbon-record",
    "category": "Object",
}

FABRICS = ("silk", "satin", "cotton", "polyester", "wool", "denim", "obi brocade")

# The first line of every text that is written says so in a comment, for whom, and with a checksum of what follows: no
# file of somebody else is replaced, none of another drawing, and none that was edited.
MARK = "written by the add-on Ribbon knot"
COMMENTS = {".svg": ("<!-- ", " -->"), ".obj": ("# ", ""), ".toml": ("# ", "")}

# Rows in the world's units (x right, y up, z towards the viewer, as in recordings) that make of a place what one sees
# along each axis: right, down, and how near it is.
VIEWS = {
    "x": numpy.array([[0, 0, -1], [0, -1, 0], [1, 0, 0]]),
    "y": numpy.array([[1, 0, 0], [0, 0, 1], [0, 1, 0]]),
    "z": numpy.array([[1, 0, 0], [0, -1, 0], [0, 0, 1]]),
}


class Trouble(Exception):
    """What the user is told instead of a knot."""


def recorded_axes(places, scene):
    """Places of Blender's world, z up, in the metres of recordings, y up."""
    x, y, z = numpy.asarray(places, dtype=float).reshape(-1, 3).T * scene.unit_settings.scale_length
    return numpy.column_stack([x, z, -y])


def blender_axes(place):
    """The other way round, in metres."""
    x, y, z = place
    return x, -z, y


def check_open(drawing, is_closed):
    if is_closed:
        raise Trouble(f"{drawing.name}: it is closed; a band has two ends, open it (Toggle Cyclic)")


def stroke_of_grease_pencil(drawing, depsgraph):
    """Of the active layer, as Blender draws it: where that is moved to, with modifiers."""
    layer = drawing.evaluated_get(depsgraph).data.layers.active
    strokes = layer.active_frame.strokes if layer and layer.active_frame else ()
    if len(strokes) != 1:
        raise Trouble(f"{drawing.name}: the active layer has {len(strokes)} strokes; draw the band in a single one")
    check_open(drawing, strokes[0].use_cyclic)
    return [point.co.copy() for point in strokes[0].points]


def points_of_curve(drawing, depsgraph):
    """Of the curve as Blender draws it, without what is swept along it."""
    copy = drawing.data.copy()
    try:
        copy.bevel_depth = copy.extrude = 0
        copy.bevel_object = None
        if len(copy.splines) != 1:
            raise Trouble(f"{drawing.name}: it has {len(copy.splines)} splines; draw the band as a single one")
        check_open(drawing, copy.splines[0].use_cyclic_u)
        probe = bpy.data.objects.new("probe", copy)
        mesh = probe.to_mesh(depsgraph=depsgraph)
        points = [vertex.co.copy() for vertex in mesh.vertices]
        probe.to_mesh_clear()
        bpy.data.objects.remove(probe)
        return points
    finally:
        bpy.data.curves.remove(copy)


def drawn_line(drawing, context):
    """The drawing as points, n x 3, in the metres of recordings."""
    read = stroke_of_grease_pencil if drawing.type == "GPENCIL" else points_of_curve
    points = read(drawing, context.evaluated_depsgraph_get())
    line = recorded_axes([drawing.matrix_world @ point for point in points], context.scene)
    apart = numpy.linalg.norm(numpy.diff(line, axis=0), axis=1) > 1e-9
    line = line[numpy.concatenate([[True], apart])] if len(line) else line
    if len(line) < 3:
        raise Trouble(f"{drawing.name}: there is no line to follow; draw the band in a single stroke")
    return line


def axis_seen_along(line):
    """A drawing is flat: the one along which it reaches least."""
    return "xyz"[int(numpy.argmin(numpy.ptp(line, axis=0)))]


def middle_of(places):
    return 0.5 * (places.min(axis=0) + places.max(axis=0))


def crossings(seen):
    """Of the polyline as seen, n x 3: for each (place along it, depth there) of its two passages, in segments."""
    found = []
    low = numpy.minimum(seen[:-1, :2], seen[1:, :2])
    high = numpy.maximum(seen[:-1, :2], seen[1:, :2])
    for i in range(len(seen) - 1):
        near = numpy.all((low[i + 2:] <= high[i]) & (high[i + 2:] >= low[i]), axis=1)
        for j in numpy.flatnonzero(near) + i + 2:
            ways = numpy.column_stack([seen[i + 1, :2] - seen[i, :2], seen[j, :2] - seen[j + 1, :2]])
            if abs(numpy.linalg.det(ways)) < 1e-15:
                continue
            s, t = numpy.linalg.solve(ways, seen[j, :2] - seen[i, :2])
            if 0 <= s < 1 and 0 <= t < 1:
                found.append(((i + s, seen[i, 2] + s * (seen[i + 1, 2] - seen[i, 2])),
                              (j + t, seen[j, 2] + t * (seen[j + 1, 2] - seen[j, 2]))))
    return found


def over_and_under(seen):
    """Letters of all passages in the order of the walk; empty where the drawing is flat and they alternate."""
    level = 1e-6 * numpy.ptp(seen[:, :2], axis=0).max()
    passages = []
    level_at = []
    for first, second in crossings(seen):
        if abs(first[1] - second[1]) <= level:
            level_at.append(first[0])
            continue
        is_over = first[1] > second[1]
        passages += [(first[0], "O" if is_over else "U"), (second[0], "U" if is_over else "O")]
    if passages and level_at:
        place = seen[int(min(level_at))]
        raise Trouble(f"the drawing crosses itself {len(level_at)} times at one height, first near {place[0]:.3g} m right "
                      f"and {-place[1]:.3g} m up, and elsewhere at two; raise or lower it at all crossings, or at none")
    return "".join(letter for _, letter in sorted(passages))


def path_of(seen):
    """In millimetres, as the path of an SVG file that shows all of it."""
    places = 1000 * seen[:, :2]
    low, size = places.min(axis=0) - 10, numpy.ptp(places, axis=0) + 20
    words = " L ".join(f"{x:.6g} {y:.6g}" for x, y in places)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{low[0]:.6g} {low[1]:.6g} {size[0]:.6g} {size[1]:.6g}">\n'
            f'  <path id="band" fill="none" stroke="black" stroke-width="2" d="M {words}"/>\n</svg>\n')


def triangles_of(thing, context):
    """Vertices, n x 3 in the metres of recordings, and triangles of a mesh as Blender shows it."""
    shown = thing.evaluated_get(context.evaluated_depsgraph_get())
    mesh = shown.to_mesh()
    mesh.calc_loop_triangles()
    vertices = recorded_axes([thing.matrix_world @ vertex.co for vertex in mesh.vertices], context.scene)
    triangles = [list(triangle.vertices) for triangle in mesh.loop_triangles]
    shown.to_mesh_clear()
    if not triangles:
        raise Trouble(f"{thing.name}: it has no faces; select another mesh to fasten the ribbon round, or none")
    if thing.matrix_world.is_negative:
        triangles = [triangle[::-1] for triangle in triangles]  # mirrored, they would be inside out
    return vertices, triangles


def obj_of(vertices, triangles):
    return ("".join(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in vertices) +
            "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles))


def scene_of(name, line, axis, letters, settings, middle, has_obstacle, origin):
    """The text of the scene; middle: a point on the axis that the band is fastened round."""
    length = numpy.linalg.norm(numpy.diff(line, axis=0), axis=1).sum()
    along = max(20, round(length / settings.width * (settings.across - 1)) + 1)
    direction = [int(letter == axis) for letter in "xyz"]
    springs = "[springs]\nstretch = 10\nshear = 10\nbend = 10\n"
    tables = [
        f'[curve]\nsvg = "{name}.svg"\naxis = "{axis}"\n' + (f'crossings = "{letters}"\n' if letters else ""),
        f"[ribbon]\nwidth = {settings.width:.6g}\nalong = {along}\nacross = {settings.across}\n",
        springs if settings.fabric == "NONE" else f'[cloth]\nfabric = "{settings.fabric}"\n',
        "[air]\nresistance = 4\n",
        f'[obstacle]\nmesh = "{name}.obj"\n' if has_obstacle else "",
        f"[fastening]\nspeed = {settings.speed:.6g}\nyield = 0.05\n"
        f"axis_point = [{', '.join(f'{x:.6g}' for x in middle)}]\naxis = {direction}\n",
        f'[time]\nduration = {settings.duration:.6g}\nuntil = "tight"\n',
    ]
    # The add-on Ribbon recording looks for it.
    place = f"# In Blender the origin is at [{', '.join(f'{x:.9f}' for x in blender_axes(origin))}], in metres\n"
    return f"{place}\n" + "\n".join(table for table in tables if table)


def recorder():
    preferences = bpy.context.preferences.addons.get(__name__)
    named = preferences.preferences.recorder if preferences else ""
    found = bpy.path.abspath(named) if named else shutil.which("ribbon-record")
    if not found or not Path(found).is_file():
        raise Trouble(f"{named or 'ribbon-record'}: there is no such program; install the package ribbon, or name the "
                      "program in the preferences of this add-on")
    return found


def owner_of(drawing):
    """Whose files these are, as a part of a comment: other names may give the same name of a file."""
    names = json.dumps([drawing.name, Path(bpy.data.filepath).name])
    return names.replace("--", "-\\u002d")  # which would end a comment of SVG


def mark_of(owner, text):
    return f"{MARK} for {owner}, checksum {zlib.crc32(text):08x}".encode()


def is_as_written(path, owner):
    first, _, rest = path.read_bytes().partition(b"\n")
    return mark_of(owner, rest) in first


def check_replaceable(scene, endings, owner):
    """A recording is ours where its scene is."""
    judged_by = [(ending, ending) for ending in endings] + [(".rbn", ".toml")]
    for path, marked in [tuple(map(scene.with_suffix, pair)) for pair in judged_by]:
        if path.exists() and not (marked.exists() and is_as_written(marked, owner)):
            raise Trouble(f"{path}: exists already, and is not what this add-on wrote for this drawing of this .blend; "
                          "rename the drawing, or choose another folder")


def write_scene(drawing, obstacle, settings, context):
    """Writes scene, drawing and obstacle into the folder; the scene's path."""
    folder = Path(os.path.abspath(bpy.path.abspath(settings.folder)))
    if settings.folder.startswith("//") and not bpy.data.filepath:
        raise Trouble("the .blend has no folder yet for the recording to stay in; save it first, or choose a folder")
    name = re.sub(r"\W+", "-", drawing.name).strip("-") or "knot"
    line = drawn_line(drawing, context)
    axis = axis_seen_along(line)
    letters = over_and_under(line @ VIEWS[axis].T)
    # ribbon-record lays the band in the plane through the origin, as far above it as below; and texts have few digits.
    origin = middle_of(line)
    line -= origin
    middle = middle_of(line)
    texts = {".svg": path_of(line @ VIEWS[axis].T)}
    if obstacle:
        vertices, triangles = triangles_of(obstacle, context)
        vertices -= origin
        middle = middle_of(vertices)
        texts[".obj"] = obj_of(vertices, triangles)
    texts[".toml"] = scene_of(name, line, axis, letters, settings, middle, bool(obstacle), origin)
    owner = owner_of(drawing)
    scene = folder / f"{name}.toml"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        check_replaceable(scene, texts, owner)
        for ending, text in texts.items():
            begin, end = map(str.encode, COMMENTS[ending])
            rest = text.encode()
            scene.with_suffix(ending).write_bytes(begin + mark_of(owner, rest) + end + b"\n" + rest)
    except OSError as error:
        raise Trouble(f"{error.filename}: {error.strerror}; choose another folder") from error
    return scene


class Recording:
    """A scene that ribbon-record is at work on, which one can ask without waiting for it."""

    PATIENCE_S = 5  # for the step that the recorder is in when it is stopped

    def __init__(self, program, scene):
        """Replaces what an earlier time has recorded."""
        self.path = scene.with_suffix(".rbn")
        try:
            self.process = subprocess.Popen(
                [program, str(scene), "-o", str(self.path), "--force", "--progress", "json"],
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        except OSError as error:
            raise Trouble(f"{program}: {error.strerror}; name another in the preferences of this add-on") from error
        self.program = program
        self.said = b""

    def is_at_work(self):
        """Also takes in what the recorder has said since it was asked last."""
        works = self.process.poll() is None
        os.set_blocking(self.process.stderr.fileno(), False)
        self.said += self.process.stderr.read() or b""
        return works

    def lines(self):
        return self.said.decode(errors="replace").splitlines(keepends=True)

    def progress(self):
        """How far it is, for people."""
        told = [line for line in self.lines() if line.startswith("{") and line.endswith("\n")]
        if not told:
            return "begins"
        last = json.loads(told[-1])
        counted = f"{last['unit']} {last['done']} of at most {last['total']}" if last["done"] else last["unit"]
        return ", ".join(filter(None, [counted, last.get("remark")]))

    def wait(self):
        self.said += self.process.communicate()[1]

    def check(self):
        """Once it has ended: raises what it says where it could not."""
        if self.process.returncode != 0:
            raise Trouble(self.sentence() or f"{self.program} ended with {self.process.returncode}, without a word")

    def sentence(self):
        return "".join(line for line in self.lines() if not line.startswith("{")).strip()

    def stop(self):
        """What is recorded so far stays, and ribbon-record --resume goes on with it."""
        self.process.terminate()
        try:
            self.process.wait(self.PATIENCE_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.is_at_work()


class KnotPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__
    recorder: StringProperty(name="ribbon-record", subtype="FILE_PATH", description="Empty: the one on the PATH")

    def draw(self, _):
        self.layout.prop(self, "recorder")


class TieRibbon(bpy.types.Operator):
    """Fastens a ribbon that is laid along the active curve or grease pencil stroke, round the selected mesh if there is one"""

    bl_idname = "object.tie_ribbon"
    bl_label = "Tie a ribbon along this drawing"
    bl_options = {"UNDO"}
    width: FloatProperty(name="Width", default=0.02, min=1e-4, precision=4, description="Of the ribbon, in metres")
    across: IntProperty(name="Particles across", default=4, min=2, max=64, description="Along as far apart as across")
    fabric: EnumProperty(name="Fabric", items=[("NONE", "none", "Springs of the samples")] +
                         [(name, name, f"Cloth that behaves as {name}") for name in FABRICS])
    speed: FloatProperty(name="Speed", default=0.1, min=1e-3, description="At which the hands pull, metres a second")
    duration: FloatProperty(name="Seconds", default=20, min=0.1, description="Simulated, unless it is tight before")
    folder: StringProperty(name="Folder", default="//", subtype="DIR_PATH", description="For scene and recording")

    # While the recorder is at work, these are for the view alone: nobody changes the scene then.
    NAVIGATION = {"MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "TRACKPADPAN", "TRACKPADZOOM", "MOUSEROTATE",
                  "NDOF_MOTION"}
    ASKED_EVERY_S = 0.2

    is_in_window = False
    timer = None

    @classmethod
    def poll(cls, context):
        return (context.mode == "OBJECT" and context.active_object is not None and
                context.active_object.type in {"CURVE", "GPENCIL"})

    def invoke(self, context, _):
        self.is_in_window = True
        return context.window_manager.invoke_props_dialog(self)

    def execute(self, context):
        """Waits for the recorder where a script asks; in the window, shows how far it is, and Esc stops it."""
        try:
            self.recording = self.begin(context)
            if self.is_in_window:
                return self.watch(context)
            self.recording.wait()
            return self.bring_back(context)
        except Trouble as trouble:
            return self.refuse(trouble)

    def begin(self, context):
        drawing = context.active_object
        meshes = [thing for thing in context.selected_objects if thing.type == "MESH"]
        if len(meshes) > 1:
            raise Trouble("several meshes are selected; select the one that the ribbon is fastened round, or none")
        program = recorder()
        if not hasattr(bpy.types, "IMPORT_SCENE_OT_ribbon_recording"):
            raise Trouble("the add-on Ribbon recording is not enabled; tick it, too")
        return Recording(program, write_scene(drawing, meshes[0] if meshes else None, self, context))

    def watch(self, context):
        manager = context.window_manager
        self.timer = manager.event_timer_add(self.ASKED_EVERY_S, window=context.window)
        manager.modal_handler_add(self)
        self.show_progress(context)
        return {"RUNNING_MODAL"}

    def show_progress(self, context):
        context.workspace.status_text_set(
            f"{self.recording.path.stem} is being tied: {self.recording.progress()}.    Esc: stop")

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self.cancel(context)
            self.report({"WARNING"}, self.recording.sentence() or f"{self.recording.path}: stopped")
            return {"CANCELLED"}
        if event.type in self.NAVIGATION or event.type.startswith("NUMPAD"):
            return {"PASS_THROUGH"}
        if event.type != "TIMER":
            return {"RUNNING_MODAL"}
        if self.recording.is_at_work():
            self.show_progress(context)
            return {"RUNNING_MODAL"}
        self.unwatch(context)
        try:
            return self.bring_back(context)
        except Trouble as trouble:
            return self.refuse(trouble)

    def cancel(self, context):
        """By Esc, and by Blender when it ends or opens another file."""
        if self.timer:
            self.unwatch(context)
            self.recording.stop()

    def unwatch(self, context):
        context.window_manager.event_timer_remove(self.timer)
        context.workspace.status_text_set(None)
        self.timer = None

    def bring_back(self, context):
        """The ribbon as recorded, in the place of what an earlier time has brought."""
        self.recording.check()
        path = str(self.recording.path)
        older = [thing for thing in context.scene.objects if thing.get("ribbon_recording") == path]
        try:
            ended = bpy.ops.import_scene.ribbon_recording(filepath=path, with_obstacle=False,
                                                          first_frame=context.scene.frame_start)
        except RuntimeError as error:
            raise Trouble(str(error).removeprefix("Error: ").strip()) from error
        if ended == {"FINISHED"}:
            for thing in older:
                bpy.data.objects.remove(thing)
        return ended

    def refuse(self, trouble):
        self.report({"ERROR"}, str(trouble))
        return {"CANCELLED"}


def menu_entry(menu, _):
    menu.layout.operator(TieRibbon.bl_idname)


def register():
    bpy.utils.register_class(KnotPreferences)
    bpy.utils.register_class(TieRibbon)
    bpy.types.VIEW3D_MT_object.append(menu_entry)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(menu_entry)
    bpy.utils.unregister_class(TieRibbon)
    bpy.utils.unregister_class(KnotPreferences)
