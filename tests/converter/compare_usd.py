"""Whether a USD file shows what was recorded."""

import numpy as np

from read_alembic import demand
from read_usda import Layer
from recorded_motion import bounds_of, demand_normals, demand_same


def check_usd_mesh(prim, mesh, uv, frames, is_static, what, has_normals):
    """A mesh whose only samples are its positions, extents and perhaps normals."""
    demand(prim.metadata["apiSchemas"] == ["MaterialBindingAPI"], "the schemas of a mesh")
    demand(prim.metadata.get("displayName", prim.name) == mesh.name, "names")
    properties = prim.properties
    names = {"points", "extent", "faceVertexCounts", "faceVertexIndices", "doubleSided"}
    names |= {"subdivisionScheme", "material:binding"} | ({"primvars:st"} if uv is not None else set())
    names |= {"normals"} if has_normals else set()
    demand(set(properties) == names, f"properties {sorted(properties)}")
    demand(properties["doubleSided"].value and properties["doubleSided"].is_uniform, "two sides")
    scheme = properties["subdivisionScheme"]
    demand(scheme.value == "none" and scheme.is_uniform, "a mesh that is subdivided")
    demand_same(properties["faceVertexCounts"].value, [len(face) for face in mesh.faces], "corners")
    demand_same(properties["faceVertexIndices"].value, np.concatenate(mesh.faces), "faces")
    points, extents = properties["points"], properties["extent"]
    demand((points.kind, extents.kind) == ("point3f", "float3"), "the types of positions")
    if is_static:
        points.samples, extents.samples = {0: points.value}, {0: extents.value}
    times = list(range(len(frames)))
    demand(list(points.samples) == list(extents.samples) == times, "the times of frames")
    for time, expected in enumerate(frames):
        demand_same(points.samples[time], expected, f"positions of {what(time)}")
        extent = bounds_of(expected).reshape(2, 3)
        demand_same(extents.samples[time], extent, f"extent of {what(time)}")
    if has_normals:
        check_usd_normals(properties["normals"], mesh, frames, is_static, what)
    if uv is not None:
        st = properties["primvars:st"]
        demand(st.kind == "texCoord2f" and st.metadata == {"interpolation": "vertex"}, "uv")
        demand_same(st.value, uv, "uv")


def check_usd_normals(normals, mesh, frames, is_static, what):
    demand(normals.kind == "normal3f", "the type of normals")
    demand(normals.metadata == {"interpolation": "vertex"}, "where normals stand")
    samples = {0: normals.value} if is_static else normals.samples
    demand(list(samples) == list(range(len(frames))), "the times of normals")
    for time, positions in enumerate(frames):
        demand_normals(samples[time], positions, mesh, what(time))


def check_usd_material(world, prim, name):
    target = prim.properties["material:binding"]
    demand(target == f"/World/Materials/{name}", f"a material at {target}")
    material = world.children["Materials"].children[name]
    surface = material.properties["outputs:surface"].connection
    demand(surface == f"{target}/surface.outputs:surface", "the surface of a material")
    shader = material.children["surface"].properties
    demand(shader["info:id"].value == "UsdPreviewSurface", "the shader of a material")
    color = {"ribbon": [0.61, 0.03, 0.05], "obstacle": [0.45, 0.45, 0.42]}[name]
    demand(shader["inputs:diffuseColor"].value == color, "the color of a material")


def check_usd(path, reference):
    layer = Layer(path)
    rate, frames = reference.frames_per_second, reference.frames
    stated = (layer.metadata["timeCodesPerSecond"], layer.metadata["framesPerSecond"])
    demand(stated == (rate, rate), f"frame rate {stated}")
    span = (layer.metadata["startTimeCode"], layer.metadata["endTimeCode"])
    demand(span == (0, len(frames) - 1), f"frames {span}")
    space = (layer.metadata["upAxis"], layer.metadata["metersPerUnit"])
    demand(space == ("Y", 1), f"axis and unit {space}")
    demand(layer.metadata["defaultPrim"] == "World" and list(layer.prims) == ["World"], "prims")
    world = layer.prims["World"]
    identifiers = [mesh.name.replace(" ", "_") for mesh in (reference.ribbon, reference.obstacle)]
    demand(list(world.children) == [*identifiers, "Materials"], f"names {list(world.children)}")
    ribbon, obstacle = (world.children[name] for name in identifiers)
    normals = reference.has_normals
    of_frame = lambda time: f"frame {time + 1}"
    check_usd_mesh(ribbon, reference.ribbon, reference.uv, frames, False, of_frame, normals)
    static, of_obstacle = [reference.obstacle_positions], lambda _: "the obstacle"
    check_usd_mesh(obstacle, reference.obstacle, None, static, True, of_obstacle, normals)
    check_usd_material(world, ribbon, "ribbon")
    check_usd_material(world, obstacle, "obstacle")
