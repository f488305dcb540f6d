"""Whether an Alembic file shows what was recorded."""

import numpy as np

from read_alembic import Archive, demand
from recorded_motion import bounds_of, demand_normals, demand_same

def property_of(schema, name, metadata, is_array, time_sampling, count):
    demand(name in schema.children, f"no property {name}")
    found = schema.children[name]
    demand(found.metadata == metadata, f"metadata of {name}: {found.metadata}")
    demand(found.is_array == is_array, f"whether {name} is an array")
    demand(found.time_sampling == time_sampling, f"time sampling of {name}")
    demand(found.count == count, f"{name} has {found.count} samples, not {count}")
    return found


UV_METADATA = {
    "arrayExtent": "1",
    "geoScope": "vtx",
    "interpretation": "vector",
    "isGeomParam": "true",
    "podExtent": "2",
    "podName": "float32_t",
}
NORMALS_METADATA = {**UV_METADATA, "interpretation": "normal", "podExtent": "3"}


def alembic_schema(xform, name):
    """The mesh's schema below a transformation that is the identity."""
    demand(
        xform.metadata
        == {"schema": "AbcGeom_Xform_v3", "schemaObjTitle": "AbcGeom_Xform_v3:.xform"},
        "a transformation's metadata",
    )
    demand(list(xform.properties) == [".xform"], "a transformation's properties")
    identity = xform.properties[".xform"]
    demand(identity.metadata == {"schema": "AbcGeom_Xform_v3"}, "the schema of a transformation")
    demand(not identity.children and identity.samples is None, "a transformation that moves")
    demand(list(xform.children) == [name + "Shape"], "names below a transformation")
    mesh = xform.children[name + "Shape"]
    kind = {"schema": "AbcGeom_PolyMesh_v1", "schemaBaseType": "AbcGeom_GeomBase_v1"}
    title = {"schemaObjTitle": "AbcGeom_PolyMesh_v1:.geom"}
    demand(mesh.metadata == {**kind, **title}, "a mesh's metadata")
    demand(not mesh.children and list(mesh.properties) == [".geom"], "what is in a mesh")
    demand(mesh.properties[".geom"].metadata == kind, "the schema of a mesh")
    return mesh.properties[".geom"]


def check_alembic_mesh(schema, mesh, uv, frames, time_sampling, what, has_normals):
    names = [".selfBnds", "P", ".faceIndices", ".faceCounts"]
    names += ["uv"] * (uv is not None) + ["N"] * has_normals
    demand(list(schema.children) == names, "the properties of a mesh")
    count = len(frames)
    sampled = lambda name, metadata: property_of(
        schema, name, metadata, name != ".selfBnds", time_sampling, count
    )
    bounds = sampled(".selfBnds", {"interpretation": "box"})
    positions = sampled("P", {"geoScope": "vtx", "interpretation": "point"})
    for number, expected in enumerate(frames):
        demand_same(positions.sample(number), expected, f"positions of {what(number)}")
        demand_same(bounds.sample(number), bounds_of(expected), f"bounds of {what(number)}")
    clockwise = np.concatenate([face[::-1] for face in mesh.faces])
    demand_same(sampled(".faceIndices", {}).sample(0).ravel(), clockwise, "faces")
    corners = [len(face) for face in mesh.faces]
    demand_same(sampled(".faceCounts", {}).sample(0).ravel(), corners, "corners of faces")
    if uv is not None:
        stored = sampled("uv", UV_METADATA)
        demand(len(stored.samples) == 1, "uv that stand in the file more than once")
        demand_same(stored.sample(0), uv, "uv")
    if has_normals:
        normals = sampled("N", NORMALS_METADATA)
        for number, positions in enumerate(frames):
            demand_normals(normals.sample(number), positions, mesh, what(number))


ARCHIVE_METADATA = {
    "_ai_AlembicVersion": "Alembic 1.8.5",
    "_ai_Application": "ribbon-convert",
    "_ai_Description": "a unit is 1 m, y is up",
}


def check_alembic(path, reference):
    archive = Archive(path)
    frames = reference.frames
    rate = reference.frames_per_second
    stated = archive.metadata.pop("_ai_DCC_FPS")
    demand(float(stated) == rate, f"frame rate of the metadata: {stated}")
    demand(archive.metadata == ARCHIVE_METADATA, "metadata of the archive")
    demand(archive.time_samplings == [(1, 1.0, 0.0), (len(frames), 1 / rate, 0.0)], "frame rate")
    names = [reference.ribbon.name, reference.obstacle.name]
    demand(list(archive.top.children) == names, f"names {list(archive.top.children)}")
    demand(not archive.top.properties, "properties of the top object")
    ribbon, obstacle = (alembic_schema(archive.top.children[name], name) for name in names)
    normals = reference.has_normals
    of_frame = lambda number: f"frame {number + 1}"
    check_alembic_mesh(ribbon, reference.ribbon, reference.uv, frames, 1, of_frame, normals)
    static, of_obstacle = [reference.obstacle_positions], lambda _: "the obstacle"
    check_alembic_mesh(obstacle, reference.obstacle, None, static, 0, of_obstacle, normals)
