"""Readers written from the layouts read what ribbon-convert writes, and refuse what is spoiled.

  motion_files_test.py RIBBON_CONVERT BLENDER_SAMPLES FOLDER

The readers are NumPy's, and our own for Alembic and USD, which are in no package here. Each file is compared
with the recording: names, faces, uv, frame rate, and every position exactly.
"""

import pathlib
import shutil
import subprocess
import sys

import numpy as np

from compare_alembic import check_alembic
from compare_usd import check_usd
from read_alembic import Archive, Refused, demand
from read_usda import Layer
from recorded_motion import Reference, demand_frames

# What the comparison must say about each fault that blender_samples plants.
FAULTS = {
    "moved_vertex": "positions of frame 2",
    "swapped_frames": "positions of frame 2",
    "frozen": "positions of frame 2",
    "wrong_rate": "frame rate",
    "moved_obstacle": "positions of the obstacle",
    "swapped_uv": "uv",
    "inside_out": "faces",
    "other_name": "names",
}

# Those of positions, which are all that some formats hold.
FAULTS_OF_POSITIONS = ("moved_vertex", "swapped_frames", "frozen")


def check_npy(path, reference):
    array = np.load(path, allow_pickle=False)
    demand(array.dtype == np.dtype("<f4") and array.flags.c_contiguous, "not float32 in C order")
    demand(array.ndim == 4 and array.shape[3] == 3, f"shape {array.shape}")
    _, along, across, _ = array.shape
    u = reference.uv.reshape(along, across, 2)[:, :, 0]
    demand(bool((u == u[:, :1]).all()), "rows that are not the ribbon's")
    demand_frames(array.reshape(len(array), -1, 3), reference)


CHECKS = {".usda": check_usd, ".abc": check_alembic, ".npy": check_npy}


# Those of them that can hold normals.
NORMALS = (".usda", ".abc")


def problem_of(path, reference):
    """What is wrong with a file; None: nothing."""
    try:
        CHECKS[path.suffix](path, reference)
    except (Refused, ValueError, KeyError) as problem:
        return str(problem)
    return None


class Verdicts:
    def __init__(self):
        self.failed = 0

    def say(self, good, what, why):
        self.failed += 0 if good else 1
        print(f"{'ok    ' if good else 'FAILED'} {what}: {why}", flush=True)

    def judges(self, what, path, reference, fault=None):
        """The file must be as recorded, or be refused for the fault."""
        problem = problem_of(path, reference)
        if problem is None:
            self.say(fault is None, what, "as recorded")
        else:
            self.say(fault is not None and fault in problem, what, f"refused: {problem}")


def check_exports(verdicts, convert, folder, sample, frames="1:-1", normals=False):
    """Frames A to B of a sample, in every format."""
    recording = folder / f"{sample}.rbn"
    what = f"{sample} {frames}" + (" normals" if normals else "")
    out = folder / what

    def export(name, frames, *options):
        arguments = ["-o", out / name, "--frames", frames, "--quiet", *options]
        subprocess.run([convert, recording, *arguments], check=True)

    export("motion.obj", "1")
    reference = Reference(folder / f"{sample}.json", out / "motion.obj", frames, normals)
    for extension in NORMALS if normals else CHECKS:
        export(f"motion{extension}", frames, *["--normals"] * normals)
        path = out / f"motion{extension}"
        verdicts.judges(f"{what} {extension}", path, reference)
    return reference


def check_placed(verdicts, convert, folder):
    """What is z-up in centimetres says so."""
    out = folder / "placed"

    def export(name):
        placed = ["--up", "z", "--unit", "cm", "--fps", "24", "--object", "ribbon"]
        command = [convert, folder / "near.rbn", "-o", out / name, "--quiet", *placed]
        subprocess.run(command, check=True)

    export("motion.usda")
    stated = Layer(out / "motion.usda").metadata
    good = (stated["upAxis"], stated["metersPerUnit"], stated["timeCodesPerSecond"]) == ("Z", 0.01, 24)
    verdicts.say(good, "placed .usda", f"{stated}")
    export("motion.abc")
    archive = Archive(out / "motion.abc")
    good = archive.metadata["_ai_Description"] == "a unit is 0.01 m, z is up"
    good = good and archive.time_samplings == [(0, 1.0, 0.0), (5, 1 / 24, 0.0)]
    verdicts.say(good, "placed .abc", f"{archive.metadata}, {archive.time_samplings}")


def shows_picture(world, material, folder, picture):
    """Does a material of USD show the picture beside the file, at the mesh's uv?"""
    shaders = world.children["Materials"].children[material].children
    surface, image, uv = (shaders[name].properties for name in ("surface", "picture", "uv"))
    path = f"/World/Materials/{material}"
    good = surface["inputs:diffuseColor"].connection == f"{path}/picture.outputs:rgb"
    good = good and image["info:id"].value == "UsdUVTexture"
    good = good and (folder / image["inputs:file"].value).read_bytes() == picture.read_bytes()
    good = good and image["inputs:st"].connection == f"{path}/uv.outputs:result"
    good = good and (image["inputs:wrapS"].value, image["inputs:wrapT"].value) == ("repeat", "clamp")
    good = good and uv["info:id"].value == "UsdPrimvarReader_float2"
    return good and "primvars:" + uv["inputs:varname"].value in world.children["first_knot"].properties


def check_textured(verdicts, convert, folder):
    out = folder / "textured"
    picture = out / "textured.png"
    command = [convert, folder / "near.rbn", "--texture", picture, "--quiet"]
    subprocess.run([*command, "-o", out / "knot.usda"], check=True)
    good = shows_picture(Layer(out / "knot.usda").prims["World"], "ribbon", out, picture)
    verdicts.say(good, "textured .usda", "the picture beside it")


def check_textured_on_both_sides(verdicts, convert, folder):
    """In USD the faces of a solid's back, which are the last ones, are bound to a material of their own."""
    out = folder / "textured"
    front = out / "textured.png"
    back = out / "lining.png"
    back.write_bytes(front.read_bytes() + b"another")
    textures = ["--thickness", "0.002", "--texture", front, "--texture-back", back]
    command = [convert, folder / "flat.rbn", *textures, "--quiet"]
    subprocess.run([*command, "-o", out / "solid.usda"], check=True)
    world = Layer(out / "solid.usda").prims["World"]
    ribbon = world.children["first_knot"]
    subset = ribbon.children["back"]
    faces, side = len(ribbon.properties["faceVertexCounts"].value), 2 * 11 * 3
    good = subset.kind == "GeomSubset" and subset.metadata == {"apiSchemas": ["MaterialBindingAPI"]}
    good = good and subset.properties["elementType"].value == "face"
    good = good and subset.properties["familyName"].value == "materialBind"
    good = good and list(subset.properties["indices"].value) == list(range(faces - side, faces))
    corners = ribbon.properties["faceVertexIndices"].value.reshape(-1, 3)
    good = good and corners[faces - side :].min() >= 48 and corners[: faces - side, 0].min() < 48
    good = good and subset.properties["material:binding"] == "/World/Materials/ribbon_back"
    obstacle = world.children["small_object"]
    good = good and obstacle.properties["material:binding"] == "/World/Materials/obstacle"
    good = good and shows_picture(world, "ribbon", out, front)
    good = good and shows_picture(world, "ribbon_back", out, back)
    verdicts.say(good, "textured on both sides .usda", "a picture for each")


def check_that_faults_are_seen(verdicts, folder, reference):
    for path in sorted((folder / "spoiled_motions").iterdir()):
        if path.suffix not in CHECKS or path.stem == "right":
            continue
        if path.suffix == ".npy" and path.stem not in FAULTS_OF_POSITIONS:
            continue
        verdicts.judges(f"spoiled {path.name}", path, reference, FAULTS[path.stem])


def check_that_stale_normals_are_seen(verdicts, folder, reference):
    for extension in NORMALS:
        path = folder / "stale_normals" / f"motion{extension}"
        verdicts.judges(f"stale normals {extension}", path, reference, "normals of frame 1")


def check_that_changed_bytes_are_seen(verdicts, folder, reference):
    """Of Alembic, whose headers nothing else guards."""
    right = folder / "near 1:-1" / "motion.abc"
    content = right.read_bytes()
    changed = folder / "changed.abc"
    places = set(range(0, len(content), 7)) - Archive(right).hash_places
    for place in sorted(places):
        changed.write_bytes(content[:place] + bytes([content[place] ^ 4]) + content[place + 1 :])
        if problem_of(changed, reference) is None:
            verdicts.say(False, f"a changed byte at {place}", "as recorded")
    verdicts.say(True, f"{len(places)} changed bytes", "tried")


# What may go wrong in the text of USD, and what is said of it.
TEXT_FAULTS = (
    ("#usda 1.0", "#usda 2.0", "first line"),
    ('"first_knot"', '"first knot"', "identifier"),
    ('"first_knot"', '"1st_knot"', "identifier"),
    ('"small_object"', '"first_knot"', "two prims"),
    ("point3f[] points.t", "point3f points.t", "'('"),
    ("point3f[]", "point3[]", "type point3"),
    ("            2: [", "            1: [", "ascend"),
    ("            2: [", "            2 [", "':'"),
    ("(0.1, ", "(0.1.0, ", "token"),
    ("(0.1, ", "(0.1 ", "','"),
    ("(0.1, ", "(nan, ", "number"),
    ("(0.1, ", "(", "2 numbers instead of 3"),
    ("</World/Materials/ribbon>", "</World/Materials/cloth>", "no such target"),
    ('upAxis = "Y"', 'upAxis = "Z"', "axis"),
    ("metersPerUnit = 1", "metersPerUnit = 0.01", "unit"),
    ("endTimeCode = 4", "endTimeCode = 5", "frames"),
    ('Scheme = "none"', 'Scheme = "catmullClark"', "subdivided"),
    ("    }\n}\n", "    }\n", "word"),
)


def check_that_faults_of_text_are_seen(verdicts, folder, reference):
    text = (folder / "near 1:-1" / "motion.usda").read_text()
    changed = folder / "changed.usda"
    for right, wrong, reason in TEXT_FAULTS:
        assert right in text, right
        changed.write_text(text.replace(right, wrong, 1))
        verdicts.judges(f"{wrong!r} for {right!r}", changed, reference, reason)


def main():
    convert, samples, folder = sys.argv[1:]
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    subprocess.run([samples, folder], check=True)
    verdicts = Verdicts()
    reference = check_exports(verdicts, convert, folder, "near")
    check_exports(verdicts, convert, folder, "near", "3:3")
    check_exports(verdicts, convert, folder, "far")
    check_exports(verdicts, convert, folder, "long")
    with_normals = check_exports(verdicts, convert, folder, "near", normals=True)
    check_exports(verdicts, convert, folder, "near", "3:3", normals=True)
    check_that_stale_normals_are_seen(verdicts, folder, with_normals)
    check_placed(verdicts, convert, folder)
    check_textured(verdicts, convert, folder)
    check_textured_on_both_sides(verdicts, convert, folder)
    check_that_faults_are_seen(verdicts, folder, reference)
    check_that_changed_bytes_are_seen(verdicts, folder, reference)
    check_that_faults_of_text_are_seen(verdicts, folder, reference)
    if verdicts.failed:
        raise SystemExit(f"{verdicts.failed} comparisons went wrong")


if __name__ == "__main__":
    main()
