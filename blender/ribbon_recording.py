"""Blender add-on: File > Import > Ribbon recording (.rbn), docs/blender.md.

Frames stay in the recording: each is read when Blender comes to it, also when it renders.
"""

import os
import re

import bpy
import numpy
from bpy.app.handlers import persistent
from bpy.props import BoolProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

import ribbon

bl_info = {
    "name": "Ribbon recording",
    "author": "The ribbon authors",
    "version": (0, 2, 0),
    "blender": (3, 4, 0),
    "location": "File > Import > Ribbon recording (.rbn)",
    "description": "Bands of cloth as ribbon-record recorded them",
    "category": "Import-Export",
}

# What an imported object remembers, so that a .blend that is opened again goes on.
PATH = "ribbon_recording"
FIRST = "ribbon_first_frame"

# Recordings are y up; so turned, their coordinates stay the same bits.
UPRIGHT = (numpy.pi / 2, 0, 0)

# So a scene of the add-on Ribbon knot says where in Blender its drawing was.
ORIGIN = re.compile(r"^# In Blender the origin is at \[(-?\d+\.\d+), (-?\d+\.\d+), (-?\d+\.\d+)\], in metres$", re.M)

opened = {}


def absolute(path):
    """Of Blender or of a script, where another folder may be the one that it works in later."""
    return os.path.abspath(bpy.path.abspath(path))


def recording_at(path):
    """The recording of that path, opened once it has a frame."""
    if path not in opened:
        recording = ribbon.open(path)
        if len(recording) == 0:
            raise ribbon.Error(path, "the recording holds no frame yet", "wait until one is recorded")
        opened[path] = recording
    return opened[path]


def mesh_of(name, vertices, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices.reshape(-1, 3).tolist(), [], faces.tolist())
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    return mesh


def add_uv(mesh, uv):
    corners = numpy.empty(len(mesh.loops), dtype=numpy.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    mesh.uv_layers.new(name="uv").data.foreach_set("uv", uv.reshape(-1, 2)[corners].ravel())


def loaded(texture):
    """The picture of that path."""
    picture = bpy.data.images.load(texture, check_existing=True)
    if 0 in picture.size:
        bpy.data.images.remove(picture)
        raise ribbon.Error(texture, "is no picture that Blender can read", "choose another texture, or none")
    return picture


def cloth(picture, length):
    """A material of cloth; a picture is as high as the ribbon is wide, repeated along its length in widths."""
    material = bpy.data.materials.new("cloth")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    surface = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    surface.inputs["Roughness"].default_value = 0.6
    if not picture:
        surface.inputs["Base Color"].default_value = (0.6, 0.05, 0.08, 1)
        return material
    image = nodes.new("ShaderNodeTexImage")
    image.image = picture
    mapping = nodes.new("ShaderNodeMapping")
    mapping.inputs["Scale"].default_value = (length * picture.size[1] / picture.size[0], 1, 1)
    links.new(nodes.new("ShaderNodeTexCoord").outputs["UV"], mapping.inputs["Vector"])
    links.new(mapping.outputs["Vector"], image.inputs["Vector"])
    links.new(image.outputs["Color"], surface.inputs["Base Color"])
    return material


def origin_of(recording):
    """In Blender, in metres."""
    said = ORIGIN.search(recording.scene_text)
    return [float(number) for number in said.groups()] if said else [0, 0, 0]


def linked(context, mesh, recording):
    metre = 1 / context.scene.unit_settings.scale_length
    thing = bpy.data.objects.new(mesh.name, mesh)
    thing.location = [metre * x for x in origin_of(recording)]
    thing.rotation_euler = UPRIGHT
    thing.scale = (metre,) * 3
    context.collection.objects.link(thing)
    return thing


def add_ribbon(context, path, first_frame, texture):
    recording = recording_at(path)
    first = recording[0]
    picture = loaded(texture) if texture else None
    mesh = mesh_of(recording.scene_name, first, recording.triangles)
    add_uv(mesh, recording.uv)
    mesh.materials.append(cloth(picture, recording.length / recording.width))
    thing = linked(context, mesh, recording)
    thing[PATH], thing[FIRST] = path, first_frame
    return thing


def add_obstacle(context, recording):
    obstacle = recording.obstacle
    linked(context, mesh_of(obstacle.name or "obstacle", obstacle.vertices, obstacle.triangles), recording)


def set_time(scene, recording, first_frame):
    scene.render.fps = max(1, round(recording.frames_per_second))
    scene.render.fps_base = scene.render.fps / recording.frames_per_second
    scene.frame_start, scene.frame_end = first_frame, first_frame + len(recording) - 1
    scene.frame_set(first_frame)


def show(thing, frame):
    """Moves an imported ribbon to where it is in this frame of the scene; frames outside hold still."""
    recording = recording_at(thing[PATH])
    if len(thing.data.vertices) != recording.along * recording.across:
        raise ribbon.Error(thing[PATH], f"{thing.name} has {len(thing.data.vertices)} vertices, and the recording "
                           f"{recording.along * recording.across} particles", "import it anew")
    index = max(frame - thing[FIRST], 0)
    if index >= len(recording):
        recording.refresh()  # more may have been recorded
    index = min(index, len(recording) - 1)
    thing.data.vertices.foreach_set("co", recording[index].ravel())
    thing.data.update()


@persistent
def show_all(scene, _=None):
    """Before each frame. What cannot be read stays as it is, and the console says why."""
    for thing in scene.objects:
        if PATH in thing:
            try:
                show(thing, scene.frame_current)
            except ribbon.Error as error:
                print(error)


class ImportRibbonRecording(bpy.types.Operator, ImportHelper):
    """Import a recording of ribbon-record, frame by frame"""

    bl_idname = "import_scene.ribbon_recording"
    bl_label = "Import ribbon recording"
    bl_options = {"UNDO"}
    filename_ext = ".rbn"
    filter_glob: StringProperty(default="*.rbn", options={"HIDDEN"})
    first_frame: IntProperty(name="First frame", default=1, min=0,
                             description="Of the scene, that shows the recording's first")
    with_obstacle: BoolProperty(name="Obstacle", default=True, description="Import what the ribbon is fastened around")
    texture: StringProperty(name="Texture", subtype="FILE_PATH", description="A picture as high as the ribbon is wide")

    def execute(self, context):
        path = absolute(self.filepath)
        opened.pop(path, None)  # it may have been recorded anew
        try:
            recording = recording_at(path)
            thing = add_ribbon(context, path, self.first_frame, self.texture and absolute(self.texture))
        except (ribbon.Error, RuntimeError) as error:
            self.report({"ERROR"}, str(error).removeprefix("Error: ").strip())
            return {"CANCELLED"}
        if self.with_obstacle and recording.obstacle is not None:
            add_obstacle(context, recording)
        set_time(context.scene, recording, self.first_frame)
        for other in context.selected_objects:
            other.select_set(False)
        thing.select_set(True)
        context.view_layer.objects.active = thing
        return {"FINISHED"}


def menu_entry(menu, _):
    menu.layout.operator(ImportRibbonRecording.bl_idname, text="Ribbon recording (.rbn)")


def register():
    bpy.utils.register_class(ImportRibbonRecording)
    bpy.types.TOPBAR_MT_file_import.append(menu_entry)
    bpy.app.handlers.frame_change_pre.append(show_all)


def unregister():
    bpy.app.handlers.frame_change_pre.remove(show_all)
    bpy.types.TOPBAR_MT_file_import.remove(menu_entry)
    bpy.utils.unregister_class(ImportRibbonRecording)
    opened.clear()
