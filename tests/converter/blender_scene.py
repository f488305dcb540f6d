"""Files into Blender's scene, and meshes out of it."""

import bpy
import numpy

# Blender 3.4's importer of glTF asks for a name that NumPy has given up.
numpy.bool = bool


# Point caches, and what the Mesh Cache modifier calls them.
CACHES = {".pc2": "PC2", ".mdd": "MDD"}


def empty_scene():
    """Forgets all objects with their data; much faster than to begin anew."""
    data = bpy.data
    for kind in (data.objects, data.meshes, data.materials, data.images, data.actions):
        data.batch_remove(list(kind))


def import_file(path, frames_per_second=24):
    """Into an empty scene of that rate, which glTF needs; FBX brings its own. With the importer's
    default settings."""
    empty_scene()
    render = bpy.context.scene.render
    render.fps, render.fps_base = round(frames_per_second), 1
    if path.suffix == ".obj":
        bpy.ops.wm.obj_import(filepath=str(path))
    elif path.suffix == ".glb":
        bpy.ops.import_scene.gltf(filepath=str(path))
    else:
        bpy.ops.import_scene.fbx(filepath=str(path))


def attach_cache(name, path):
    """Lets a point cache move the object."""
    cache = bpy.data.objects[name].modifiers.new("cache", "MESH_CACHE")
    cache.cache_format = CACHES[path.suffix]
    cache.filepath = str(path)


def evaluated(obj):
    """The object as it is in the scene's frame, with its modifiers."""
    return obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
