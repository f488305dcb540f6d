"""Files into Blender's scene, and meshes out of it."""

import bpy


# Point caches, and what the Mesh Cache modifier calls them.
CACHES = {".pc2": "PC2", ".mdd": "MDD"}


def empty_scene():
    """Forgets all objects with their data; much faster than to begin anew."""
    for kind in (bpy.data.objects, bpy.data.meshes, bpy.data.materials, bpy.data.images):
        bpy.data.batch_remove(list(kind))


def import_file(path):
    """Into an empty scene, with the importer's default settings."""
    empty_scene()
    if path.suffix == ".obj":
        bpy.ops.wm.obj_import(filepath=str(path))
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
